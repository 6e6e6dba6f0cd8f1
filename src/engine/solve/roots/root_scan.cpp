// The scan that confirms roots.
//
// The equations are evaluated at places drawn within even parts of the ranges. Between two places of one unknown there
// is a root where the values turn around, or where they come close to zero and go away again; in a cell of four places
// of two unknowns where the plane through the values vanishes nearby. From there secants lead to it (C. G. Broyden,
// Math. Comp. 19, 577, 1965).
#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <random>

#include "engine/solve/linear/decompositions.h"
#include "engine/solve/roots/root_function.h"
#include "engine/solve/roots/root_polish.h"
#include "poinsot/engine/solve/roots/roots.h"

namespace poinsot::solve {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr std::size_t fewest_on_line = 24, most_on_line = 400;
constexpr std::size_t fewest_on_side = 7, most_on_side = 40;
// Two roots are one if they differ by no more than this part of themselves or of a thousandth of a natural size.
constexpr double one_root = 1e-6, small_root = 1e-3;
// Infinite ranges are covered evenly up to so many natural sizes, and once more so many decades to either side of one.
constexpr double sizes_scanned = 8, decades_scanned = 5;

// Places along one range, a draw in each of `count` parts; of infinite ranges half of them evenly, half by decades.
std::vector<double> scattered(const RootRange& range, std::size_t count, std::mt19937_64& random) {
  std::uniform_real_distribution<double> within(0, 1);
  const bool low = std::isfinite(range.lower), high = std::isfinite(range.upper);
  const double lower = range.lower / range.scale, upper = range.upper / range.scale;
  std::vector<double> places;
  const auto draw = [&](std::size_t i, std::size_t parts) {
    return (static_cast<double>(i) + within(random)) / static_cast<double>(parts);
  };
  if (low && high) {
    for (std::size_t i = 0; i < count; ++i) places.push_back(lower + draw(i, count) * (upper - lower));
    return places;
  }
  // From the finite end, or to both sides of zero.
  const auto at = [&](double side, double away) {
    return low ? lower + away : high ? upper - away : side < 0 ? -away : away;
  };
  const std::size_t even = count / 2;
  for (std::size_t i = 0; i < count; ++i) {
    const bool evenly = i < even;
    const double part = evenly ? draw(i, even) : draw(i - even, count - even);
    const double side = low || high ? 1 : 2 * part - 1, far = low || high ? part : std::abs(side);
    places.push_back(at(side, evenly ? sizes_scanned * far : std::pow(10, decades_scanned * (2 * far - 1))));
  }
  std::sort(places.begin(), places.end());
  return places;
}

struct ScannedPlace {
  VectorXd u, values;
  double size = 0;
};

class Scan {
 public:
  Scan(const RootProblem& problem, const Roots& known, Work most)
      : problem_(problem), plain_(plain(problem)), function_(plain_, most), judge_(problem, most) {
    for (const std::vector<double>& point : known.points) {
      VectorXd u(function_.unknowns());
      for (Index k = 0; k < u.size(); ++k)
        u[k] = point[static_cast<std::size_t>(k)] / problem.ranges[static_cast<std::size_t>(k)].scale;
      known_.push_back(std::move(u));
    }
  }

  RootScan run() {
    if (function_.unknowns() == 1)
      along_line();
    else
      over_plane();
    found_.places = function_.evaluations();
    return std::move(found_);
  }

 private:
  // The equations as they stand, without what takes their place in the search.
  static RootProblem plain(const RootProblem& problem) {
    RootProblem plain = problem;
    plain.smooth = nullptr;
    plain.slopes = nullptr;
    plain.equations = [&problem](const std::vector<double>& x) {
      auto equations = problem.equations(x);
      if (equations) equations->smooth.clear();
      return equations;
    };
    return plain;
  }

  std::optional<ScannedPlace> at(const VectorXd& u) {
    auto sample = function_.at(u);
    if (!sample || sample->values.size() == 0) return std::nullopt;
    return ScannedPlace{u, std::move(sample->values), sample->size};
  }

  // How many places the work allows, from what one evaluation takes.
  std::size_t affordable(std::size_t fewest, std::size_t most) {
    const Work begin = work_done();
    at(judge_.clamped(VectorXd::Constant(function_.unknowns(), 0.83)));
    const Work one = std::max<Work>(work_done() - begin, 1);
    return std::clamp<std::size_t>(static_cast<std::size_t>(function_.limit().left() / one), fewest, most);
  }

  void along_line() {
    std::mt19937_64 random(41);
    const std::vector<double> line = scattered(problem_.ranges[0], affordable(fewest_on_line, most_on_line), random);
    std::vector<std::optional<ScannedPlace>> places;
    for (const double u : line) places.push_back(at(VectorXd::Constant(1, u)));
    const auto comparable = [&](std::size_t i, std::size_t j) {
      return places[i] && places[j] && places[i]->values.size() == places[j]->values.size();
    };
    for (std::size_t i = 0; i + 1 < places.size(); ++i)
      if (comparable(i, i + 1) && places[i]->values.dot(places[i + 1]->values) <= 0)
        turns_around(*places[i], *places[i + 1]);
    for (std::size_t i = 1; i + 1 < places.size(); ++i)
      if (comparable(i - 1, i) && comparable(i, i + 1)) comes_close(*places[i - 1], *places[i], *places[i + 1]);
  }

  // Follows the change of sign along the direction in which the values differ, by halving and by secants in turn.
  void turns_around(ScannedPlace a, ScannedPlace b) {
    const VectorXd across = b.values - a.values;
    if (across.isZero()) return;
    for (int i = 0; i < 60; ++i) {
      const double from = across.dot(a.values), to = across.dot(b.values), width = b.u[0] - a.u[0];
      if (!(std::abs(width) > 1e-13 * (small_root + std::abs(a.u[0]))) || from == to) break;
      double part = i % 3 == 2 ? 0.5 : from / (from - to);
      // A secant that ends at a border of the bracket would never make it narrower from the other side.
      part = std::clamp(part, 1e-3, 1 - 1e-3);
      auto middle = at(VectorXd::Constant(1, a.u[0] + part * width));
      if (!middle || middle->values.size() != across.size()) return;
      ((across.dot(middle->values) < 0) == (from < 0) ? a : b) = std::move(*middle);
    }
    came_to(a.values.norm() <= b.values.norm() ? a : b);
  }

  // The least misfit between three places of which the middle one is much nearer to zero than one of the others.
  void comes_close(const ScannedPlace& before, ScannedPlace here, const ScannedPlace& after) {
    const double first = before.values.norm(), least = here.values.norm(), last = after.values.norm();
    constexpr double much = 0.3;
    if (!(least <= first && least <= last && least <= much * std::max(first, last))) return;
    if (before.values.dot(here.values) <= 0 || here.values.dot(after.values) <= 0) return;
    if (accounted_for(before.u[0], after.u[0])) return;
    double lower = before.u[0], upper = after.u[0];
    constexpr double golden = 0.3819660112501051;
    for (int i = 0; i < 40 && upper - lower > 1e-9 * (small_root + std::abs(here.u[0])); ++i) {
      const bool above = upper - here.u[0] > here.u[0] - lower;
      const double probe = here.u[0] + golden * ((above ? upper : lower) - here.u[0]);
      auto there = at(VectorXd::Constant(1, probe));
      if (!there || there->values.size() != here.values.size()) return;
      // Between the two sides of the least misfit the values may turn around twice.
      if (there->values.dot(here.values) < 0) {
        turns_around(here, *there);
        return;
      }
      if (there->values.norm() < here.values.norm()) {
        (above ? lower : upper) = here.u[0];
        here = std::move(*there);
      } else {
        (above ? upper : lower) = probe;
      }
    }
    came_to(here);
  }
  bool accounted_for(double lower, double upper) const {
    return std::ranges::any_of(known_, [&](const VectorXd& u) { return lower <= u[0] && u[0] <= upper; });
  }

  void over_plane() {
    std::mt19937_64 random(43);
    const auto side = static_cast<std::size_t>(
        std::sqrt(static_cast<double>(affordable(fewest_on_side * fewest_on_side, most_on_side * most_on_side))));
    const std::vector<double> first = scattered(problem_.ranges[0], side, random);
    const std::vector<double> second = scattered(problem_.ranges[1], side, random);
    std::vector<std::optional<ScannedPlace>> places;
    for (const double x : first)
      for (const double y : second) places.push_back(at(VectorXd{{x, y}}));
    struct Cell {
      double left;
      VectorXd start;
      MatrixXd slopes;
    };
    std::vector<Cell> cells;
    for (std::size_t i = 0; i + 1 < side; ++i)
      for (std::size_t j = 0; j + 1 < side; ++j) {
        const std::optional<ScannedPlace>* const corners[] = {&places[i * side + j], &places[i * side + j + 1],
                                                              &places[(i + 1) * side + j],
                                                              &places[(i + 1) * side + j + 1]};
        if (!std::ranges::all_of(corners, [](const auto* corner) { return corner->has_value(); })) continue;
        const VectorXd &a = (*corners[0])->values, &b = (*corners[1])->values, &c = (*corners[2])->values,
                       &d = (*corners[3])->values;
        if (b.size() != a.size() || c.size() != a.size() || d.size() != a.size()) continue;
        // The plane through the four values, over the cell from -1 to 1 both ways.
        const VectorXd mean = (a + b + c + d) / 4;
        MatrixXd slopes(a.size(), 2);
        slopes.col(0) = (c + d - a - b) / 4;
        slopes.col(1) = (b + d - a - c) / 4;
        const VectorXd s = slopes.completeOrthogonalDecomposition().solve(VectorXd(-mean));
        constexpr double nearby = 1.6, fits = 0.5;
        const double left = (mean + slopes * s).norm(), size = std::max({a.norm(), b.norm(), c.norm(), d.norm()});
        if (!(s.cwiseAbs().maxCoeff() <= nearby) || left > fits * size) continue;
        const VectorXd half{{(first[i + 1] - first[i]) / 2, (second[j + 1] - second[j]) / 2}};
        if (!(half.minCoeff() > 0)) continue;
        const VectorXd middle{{(first[i + 1] + first[i]) / 2, (second[j + 1] + second[j]) / 2}};
        cells.push_back({left / std::max(size, 1e-300), function_.clamped(middle + half.cwiseProduct(s)),
                         slopes * half.cwiseInverse().asDiagonal()});
      }
    std::ranges::stable_sort(cells, {}, &Cell::left);
    // As much again as the places took goes into the most promising cells.
    const std::size_t most = function_.evaluations() * 2;
    for (const Cell& cell : cells) {
      if (function_.evaluations() > most) break;
      by_secants(cell.start, cell.slopes);
    }
  }

  void by_secants(const VectorXd& start, MatrixXd slopes) {
    auto first = at(start);
    if (!first) return;
    ScannedPlace here = std::move(*first);
    constexpr int most_steps = 30;  // which gain a digit each at worst, and two where the slopes have been learnt
    for (int i = 0; i < most_steps && here.values.norm() > 1e-15 * here.size; ++i) {
      const VectorXd step = slopes.completeOrthogonalDecomposition().solve(VectorXd(-here.values));
      if (!step.allFinite() || step.norm() > 10 * (1 + here.u.norm())) return;
      const auto next = at(function_.clamped(here.u + step));
      if (!next || next->values.size() != here.values.size()) return;
      if (i > 3 && next->values.norm() > 0.9 * here.values.norm()) break;
      const VectorXd moved = next->u - here.u;
      if (moved.squaredNorm() == 0) break;
      slopes += (next->values - here.values - slopes * moved) * moved.transpose() / moved.squaredNorm();
      here = *next;
    }
    if (here.values.norm() <= 1e-4 * std::max(here.size, 1e-300)) came_to(here);
  }

  static double apart(const VectorXd& a, const VectorXd& b) {
    return (a - b).norm() / (small_root + std::max(a.norm(), b.norm()));
  }
  double from_known(const VectorXd& u) const {
    double nearest = std::numeric_limits<double>::infinity();
    for (const VectorXd& root : known_) nearest = std::min(nearest, apart(u, root));
    return nearest;
  }

  // A place where the scan sees a root: one that is known, a new one, or none.
  void came_to(const ScannedPlace& place) {
    if (!judge_.inside(place.u)) return;
    if (const double off = from_known(place.u); off <= one_root) {
      found_.farthest = std::max(found_.farthest, off);
      return;
    }
    const auto root = polish(judge_, place.u);
    if (!root || !root->zero || !judge_.in_ranges(root->u, root->values.norm())) return;
    // What the scan saw may be a root that it has located badly, as where values only touch zero.
    if (const double off = from_known(root->u); off <= std::max(one_root, 10 * root->radius)) return;
    if (family_through(judge_, *root)) return;
    found_.missed.push_back(judge_.unscaled(judge_.clamped(root->u)));
    known_.push_back(root->u);
  }

  const RootProblem& problem_;
  RootProblem plain_;
  RootFunction function_, judge_;
  std::vector<VectorXd> known_;
  RootScan found_;
};

}  // namespace

std::optional<RootScan> scan_roots(const RootProblem& problem, const Roots& known, Work most) {
  const std::size_t unknowns = problem.ranges.size();
  if (unknowns < 1 || unknowns > 2 || problem.costly || known.open) return std::nullopt;
  return Scan(problem, known, most).run();
}

}  // namespace poinsot::solve
