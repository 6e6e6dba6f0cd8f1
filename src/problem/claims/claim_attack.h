// Looks for letters at which a claim fails by making what it leaves smaller, out to the edges of what can be.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "poinsot/engine/work/work.h"
#include "problem/entries/drawn_letters.h"

namespace poinsot::problem {

// The search starts from the points at which the claim holds most narrowly, among those given and others all over six
// decades, and goes on by moves of single letters, of all of them, and to places where letters of a kind are equal or
// one is the sum or the difference of two others: there bodies end, whose moments of inertia keep the inequality of the
// triangle. It is the same for the same letters in any order.
class ClaimAttack {
 public:
  // How far a claim is from failing at a point, as a part of its sides: not positive where it fails. Nothing where it
  // says nothing, because an assumption fails or a side has no value.
  using Margin = std::function<std::optional<double>(const Point&)>;
  // Whether the statement makes sense at a point. It is asked only where the margin is smaller than before.
  using MakesSense = std::function<bool(const Point&)>;

  ClaimAttack(std::vector<Letter> letters, Margin margin, MakesSense makes_sense, Work most);

  // The letters that have a part in the margin, where that is known: to move another alone makes it no smaller.
  void let_margin_read(std::set<std::string> letters) { read_ = std::move(letters); }

  // A point at which the claim fails; nothing if none was found.
  std::optional<Point> from(const std::vector<Point>& starts);
  std::size_t tried() const { return tried_; }

 private:
  struct Place {
    Point point;
    double margin = 0;
  };
  std::optional<Place> look(Point point, double below);
  std::optional<Place> best_of(std::vector<Point>& points, double below);
  bool stands(const Point& point);
  void narrow(Place& place, std::size_t seed);
  // steps: by single letters; edges: to where letters of a kind are equal, sums or differences.
  enum class Moves { steps, edges };
  std::vector<Point> moves(const Point& from, double step, Moves which) const;

  std::vector<Letter> letters_;  // by name
  std::optional<std::set<std::string>> read_;
  Margin margin_;
  MakesSense makes_sense_;
  WorkLimit limit_;
  std::size_t tried_ = 0;
};

}  // namespace poinsot::problem
