// Digits of formulas: balls of real numbers, with Arb's arb as a value.
#pragma once

#include <arb.h>

#include <functional>
#include <string>

#include "engine/math/formula/formula_fraction.h"

namespace poinsot::symbolic {

class Ball {
 public:
  Ball() { arb_init(ball_); }
  explicit Ball(slong number) : Ball() { arb_set_si(ball_, number); }
  Ball(const Ball& other) : Ball() { arb_set(ball_, other.ball_); }
  Ball(Ball&& other) noexcept : Ball() { arb_swap(ball_, other.ball_); }
  Ball& operator=(Ball other) noexcept {
    arb_swap(ball_, other.ball_);
    return *this;
  }
  ~Ball() { arb_clear(ball_); }

  arb_struct* get() { return ball_; }
  const arb_struct* get() const { return ball_; }

 private:
  arb_t ball_;
};

// The values of letters, by name.
using BallOfLetter = std::function<Ball(const Generator& letter)>;

Ball ball_of(const Formula& x, const BallOfLetter& letters, slong precision);
Ball ball_of(const Generators& generators, const Polynomial& polynomial, const BallOfLetter& letters, slong precision);

// The bits with which the double nearest to a value is sought first.
inline constexpr slong digits_of_nearest = 120;
// Counts the work of the value of a polynomial of so many terms. By whatever numbers it is found, it counts as that of
// balls does.
void count_digits_of(std::size_t terms, std::size_t generators, slong precision);

// The letters' values at a point of no special place; each attempt gives another point.
BallOfLetter sample_point(int attempt);

}  // namespace poinsot::symbolic
