// One step of Gauss-Legendre collocation of order 16, its eight stages evaluated together:
//
//   Y_i = y + sum_j (a_ij / b_j) L_j,   L_j = h b_j f(t + c_j h, Y_j),   y+ = y + sum_j L_j,
//
// solved by rounds over all stages at once. In a round the velocities come first, from the accelerations of the round
// before, and the positions from these velocities: that halves the number of rounds.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/motion/integrator/gauss_legendre_8.h"
#include "engine/motion/integrator/step_method.h"
#include "poinsot/engine/math/algebra/pack.h"

namespace poinsot {

// A pack for each component of the state or of its rates, as the equations take them: component k of instant i at
// 8 k + i.
class StageTable {
 public:
  using Stages = Pack<gauss_legendre_8::stages>;  // one number per stage
  static constexpr std::size_t width = gauss_legendre_8::stages;

  explicit StageTable(std::size_t rows);
  StageTable(const StageTable&) = delete;
  StageTable& operator=(const StageTable&) = delete;

  Stages row(std::size_t k) const { return Stages(Stages::Lanes(at(k), std::experimental::vector_aligned)); }
  void set(std::size_t k, const Stages& pack) {
    pack.lanes().copy_to(&numbers_[k * width], std::experimental::vector_aligned);
  }
  const double* at(std::size_t k) const { return &numbers_[k * width]; }
  std::span<double> rows(std::size_t first, std::size_t count) {
    return numbers_.subspan(first * width, count * width);
  }

 private:
  std::vector<double> storage_;
  std::span<double> numbers_;  // the part of it that begins on a boundary of packs
};

class PackedStep {
 public:
  // The equations must outlive it.
  explicit PackedStep(const MotionEquations& equations);

  std::int64_t rounds() const { return rounds_; }
  // How much less the last round changed than the one before.
  double contraction() const { return contraction_; }

  // Rates at the start, at every stage: a start where there is no step before. False if they are not finite.
  bool start_flat(double t, std::span<const double> y, double h);
  // From the Legendre series of a step of length `before` that ended, or started, where this one of length h starts.
  void start_from_series(double h, double before, bool from_its_end);
  // Rounds until what those to come would still change is less than a part of what is allowed, if they contract as the
  // last one.
  StepOutcome solve(double t, std::span<const double> y, double h, std::span<const double> allowed);
  // Finds the series of the solved step, and from its decay the error over what is allowed: the first coefficient left
  // out, times as small a one of the adjoint motion.
  double find_series(std::span<const double> allowed);
  // y + sum of the increments, smallest first. carry: what rounding took off y (Kahan).
  void add_to(std::span<double> y, std::span<double> carry) const;

 private:
  using Stages = StageTable::Stages;

  Stages stage(std::span<const double> y, std::size_t k) const;
  void find_position_rates(double t, double h);
  void find_accelerations(double t, double h);

  const MotionEquations& equations_;
  std::size_t nq_;
  std::size_t n_;
  StageTable increments_;
  StageTable at_stages_;
  StageTable rates_;
  StageTable series_;  // of dy/dt times the step, in Legendre polynomials
  std::vector<double> per_allowed_;
  double contraction_ = 1.0;
  std::int64_t rounds_ = 0;
};

}  // namespace poinsot
