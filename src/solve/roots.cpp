#include "poinsot/solve/roots.h"

#include <Eigen/Dense>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <random>

namespace poinsot::solve {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double zero_tolerance = 1e-9;

class RootFinder {
 public:
  RootFinder(const RootProblem& problem, double seconds)
      : problem_(problem),
        n_(static_cast<Eigen::Index>(problem.ranges.size())),
        end_(Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds))) {}

  Roots find() {
    Roots roots;
    roots.best_misfit = std::numeric_limits<double>::infinity();
    if (solve_linear(roots)) return roots;
    roots.search = RootSearch::many_starts;
    // Of many unknowns: when a few starts have all led to one point, inside the ranges or not, it is taken for the only
    // one. The search still counts as one from some starts.
    constexpr int enough = 4, most = 24;
    std::optional<VectorXd> only;
    int led_there = 0;
    for (const VectorXd& start : starts()) {
      if (Clock::now() > end_ || (n_ > 2 && (led_there >= enough || static_cast<int>(roots.starts) >= most))) break;
      ++roots.starts;
      const auto root = polish(start, roots);
      if (!root) continue;
      keep(*root, roots);
      if (!only) only = *root;
      const bool same = (*root - *only).norm() <= 1e-6 * (1e-3 + only->norm());
      led_there = same && led_there >= 0 ? led_there + 1 : -1;  // two points: never enough
    }
    std::sort(roots.points.begin(), roots.points.end());
    return roots;
  }

 private:
  using Clock = std::chrono::steady_clock;

  std::optional<VectorXd> equations(const VectorXd& u) const {
    std::vector<double> x(static_cast<std::size_t>(n_));
    for (Eigen::Index k = 0; k < n_; ++k)
      x[static_cast<std::size_t>(k)] = u[k] * problem_.ranges[static_cast<std::size_t>(k)].scale;
    const auto values = problem_.equations(x);
    if (!values) return std::nullopt;
    VectorXd r(static_cast<Eigen::Index>(values->values.size()));
    for (Eigen::Index i = 0; i < r.size(); ++i) r[i] = values->values[static_cast<std::size_t>(i)];
    size_ = values->size;
    if (!r.allFinite()) return std::nullopt;
    return r;
  }

  // Central differences.
  std::optional<MatrixXd> jacobian(const VectorXd& u, Eigen::Index rows) const {
    MatrixXd J(rows, n_);
    for (Eigen::Index k = 0; k < n_; ++k) {
      const double h = 6e-6 * std::max(1.0, std::abs(u[k]));
      VectorXd ahead = u, behind = u;
      ahead[k] += h;
      behind[k] -= h;
      const auto a = equations(ahead), b = equations(behind);
      if (a && b && a->size() == rows && b->size() == rows)
        J.col(k) = (*a - *b) / (2 * h);
      else
        return std::nullopt;
    }
    return J;
  }

  bool inside(const VectorXd& u) const {
    for (Eigen::Index k = 0; k < n_; ++k) {
      const RootRange& range = problem_.ranges[static_cast<std::size_t>(k)];
      const double x = u[k] * range.scale, slack = 1e-9 * range.scale;
      if (x < range.lower - slack || x > range.upper + slack) return false;
      if ((range.lower_open && x < range.lower + slack) || (range.upper_open && x > range.upper - slack)) return false;
    }
    return true;
  }

  void keep(VectorXd u, Roots& roots) const {
    if (!inside(u)) return;
    std::vector<double> x;
    for (Eigen::Index k = 0; k < n_; ++k) {
      const RootRange& range = problem_.ranges[static_cast<std::size_t>(k)];
      x.push_back(std::clamp(u[k] * range.scale, range.lower, range.upper));
    }
    for (const auto& known : roots.points) {
      bool same = true;
      for (std::size_t k = 0; k < x.size(); ++k)
        same = same && std::abs(x[k] - known[k]) <=
                           1e-7 * std::max({std::abs(x[k]), std::abs(known[k]), 1e-3 * problem_.ranges[k].scale});
      if (same) return;
    }
    roots.points.push_back(std::move(x));
  }

  // If the equations are linear, one step from anywhere solves them.
  bool solve_linear(Roots& roots) {
    const VectorXd u0 = middle();
    const auto r0 = equations(u0);
    if (!r0) return false;
    const auto J = difference_jacobian(u0, *r0);
    if (!J) return false;
    std::mt19937_64 random(5);
    std::uniform_real_distribution<double> part(-0.5, 0.5);
    for (int probe = 0; probe < 2; ++probe) {
      VectorXd u = u0;
      for (Eigen::Index k = 0; k < n_; ++k) u[k] += part(random);
      const auto r = equations(u);
      if (!r || r->size() != r0->size()) return false;
      const VectorXd expected = *r0 + *J * (u - u0);
      const double size = r0->norm() + (*J * (u - u0)).norm() + r->norm();
      if ((*r - expected).norm() > 1e-9 * size) return false;
    }
    Eigen::ColPivHouseholderQR<MatrixXd> qr(*J);
    qr.setThreshold(1e-10);
    const VectorXd u = u0 + qr.solve(-*r0);
    const VectorXd misfit = *r0 + *J * (u - u0);
    roots.best_misfit = misfit.size() ? misfit.cwiseAbs().maxCoeff() : 0;
    const double size = std::max(size_, r0->norm() + (*J * (u - u0)).norm());
    if (misfit.norm() > zero_tolerance * std::max(size, 1e-300)) return true;
    if (qr.rank() < n_) {
      roots.open = true;
      MatrixXd kernel = Eigen::FullPivLU<MatrixXd>(*J).setThreshold(1e-10).kernel();
      for (Eigen::Index k = 0; k < n_; ++k)
        if (kernel.row(k).cwiseAbs().maxCoeff() > 1e-9) roots.open_unknowns.push_back(static_cast<std::size_t>(k));
      const VectorXd other = u + 0.7 * kernel.rowwise().sum();
      for (Eigen::Index k = 0; k < n_; ++k)
        roots.alternative.push_back(other[k] * problem_.ranges[static_cast<std::size_t>(k)].scale);
    }
    keep(u, roots);
    return true;
  }
  // Steps of one natural unit: exact for linear equations.
  std::optional<MatrixXd> difference_jacobian(const VectorXd& u0, const VectorXd& r0) const {
    MatrixXd J(r0.size(), n_);
    for (Eigen::Index k = 0; k < n_; ++k) {
      VectorXd u = u0;
      u[k] += 0.5;
      const auto r = equations(u);
      if (!r || r->size() != r0.size()) return std::nullopt;
      J.col(k) = 2 * (*r - r0);
    }
    return J;
  }

  VectorXd middle() const {
    VectorXd u(n_);
    for (Eigen::Index k = 0; k < n_; ++k) {
      const RootRange& range = problem_.ranges[static_cast<std::size_t>(k)];
      const bool low = std::isfinite(range.lower), high = std::isfinite(range.upper);
      const double x = low && high ? 0.45 * range.lower + 0.55 * range.upper
                       : low       ? range.lower + range.scale
                       : high      ? range.upper - range.scale
                                   : 0.7 * range.scale;
      u[k] = x / range.scale;
    }
    return u;
  }

  // The value at the part t (0 to 1) of a range; an open one is covered over six decades of the natural size.
  double at_part(std::size_t k, double t) const {
    const RootRange& range = problem_.ranges[k];
    const bool low = std::isfinite(range.lower), high = std::isfinite(range.upper);
    if (low && high) return range.lower + t * (range.upper - range.lower);
    if (low || high) {
      const double away = range.scale * std::pow(10, 6 * t - 3);
      return low ? range.lower + away : range.upper - away;
    }
    const double s = 2 * t - 1;
    return (s < 0 ? -1 : 1) * range.scale * std::pow(10, 6 * std::abs(s) - 3);
  }

  // One or two unknowns are scanned on a grid; Newton's method starts where the misfit is smaller than at all
  // neighbours. More unknowns start at random.
  std::vector<VectorXd> starts() const {
    std::vector<VectorXd> list{middle()};
    if (n_ > 2) {
      std::mt19937_64 random(17);
      std::uniform_real_distribution<double> part(0, 1);
      for (int i = 0; i < 60; ++i) {
        VectorXd u(n_);
        for (Eigen::Index k = 0; k < n_; ++k)
          u[k] =
              at_part(static_cast<std::size_t>(k), part(random)) / problem_.ranges[static_cast<std::size_t>(k)].scale;
        list.push_back(u);
      }
      return list;
    }
    const int count = n_ == 1 ? 200 : 26, columns = n_ == 1 ? 1 : count;
    std::vector<VectorXd> grid;
    std::vector<double> misfit;
    for (int i = 0; i < count; ++i)
      for (int j = 0; j < columns; ++j) {
        VectorXd u(n_);
        u[0] = at_part(0, (i + 0.5) / count) / problem_.ranges[0].scale;
        if (n_ == 2) u[1] = at_part(1, (j + 0.5) / count) / problem_.ranges[1].scale;
        grid.push_back(u);
        const auto r = Clock::now() < end_ ? equations(u) : std::nullopt;
        misfit.push_back(r ? r->norm() : std::numeric_limits<double>::infinity());
      }
    for (int i = 0; i < count; ++i)
      for (int j = 0; j < columns; ++j) {
        const auto at = [&](int row, int column) { return misfit[static_cast<std::size_t>(row * columns + column)]; };
        bool lowest = std::isfinite(at(i, j));
        for (int di = -1; di <= 1; ++di)
          for (int dj = -1; dj <= 1; ++dj)
            if (i + di >= 0 && i + di < count && j + dj >= 0 && j + dj < columns)
              lowest = lowest && at(i, j) <= at(i + di, j + dj);
        if (lowest) list.push_back(grid[static_cast<std::size_t>(i * columns + j)]);
      }
    return list;
  }

  // Levenberg and Marquardt's method, ending with plain Gauss-Newton steps.
  std::optional<VectorXd> polish(VectorXd u, Roots& roots) const {
    auto r = equations(u);
    if (!r) return std::nullopt;
    double lambda = 1e-3;
    const double first = std::max(r->norm(), 1e-300);
    for (int iteration = 0; iteration < 60; ++iteration) {
      if (Clock::now() > end_) return std::nullopt;
      const auto J = jacobian(u, r->size());
      if (!J) return std::nullopt;
      const MatrixXd A = J->transpose() * *J;
      const VectorXd g = J->transpose() * *r;
      bool better = false;
      for (int attempt = 0; attempt < 12; ++attempt) {
        MatrixXd damped = A;
        damped.diagonal() += lambda * A.diagonal() + VectorXd::Constant(n_, 1e-300);
        const VectorXd step = damped.ldlt().solve(-g);
        if (!step.allFinite()) break;
        const VectorXd next = u + step;
        const auto there = equations(next);
        if (there && there->size() == r->size() && there->norm() < r->norm()) {
          const bool small = step.norm() <= 1e-14 * (1 + u.norm());
          u = next;
          r = there;
          lambda = std::max(lambda / 10, 1e-15);
          better = !small;
          break;
        }
        lambda *= 10;
      }
      if (!better || r->norm() <= 1e-16 * first) break;
    }
    const auto J = jacobian(u, r->size());
    if (!J) return std::nullopt;
    equations(u);
    const double size = std::max(size_, (J->cwiseAbs() * u.cwiseAbs()).norm());
    roots.best_misfit = std::min(roots.best_misfit, r->cwiseAbs().maxCoeff());
    if (r->norm() > zero_tolerance * size) return std::nullopt;
    Eigen::ColPivHouseholderQR<MatrixXd> qr(*J);
    qr.setThreshold(1e-7);
    // An unknown that changes nothing at a root is open there.
    bool idle = false;
    for (Eigen::Index k = 0; k < n_; ++k)
      if (J->col(k).norm() * std::max(1.0, std::abs(u[k])) <= 1e-8 * size && inside(u)) {
        idle = true;
        if (std::find(roots.open_unknowns.begin(), roots.open_unknowns.end(), static_cast<std::size_t>(k)) ==
            roots.open_unknowns.end())
          roots.open_unknowns.push_back(static_cast<std::size_t>(k));
      }
    if (idle) {
      roots.open = true;
      if (!roots.points.empty()) {
        // Every value will do: one stands for all.
        for (Eigen::Index k = 0; k < n_; ++k)
          roots.alternative.push_back(u[k] * problem_.ranges[static_cast<std::size_t>(k)].scale);
        if (static_cast<Eigen::Index>(roots.alternative.size()) > n_)
          roots.alternative.resize(static_cast<std::size_t>(n_));
        return std::nullopt;
      }
      return u;
    }
    if (qr.rank() < n_ && inside(u)) {
      roots.open = true;
      roots.open_unknowns.clear();
      MatrixXd kernel = Eigen::FullPivLU<MatrixXd>(*J).setThreshold(1e-7).kernel();
      for (Eigen::Index k = 0; k < n_; ++k)
        if (kernel.row(k).cwiseAbs().maxCoeff() > 1e-6) roots.open_unknowns.push_back(static_cast<std::size_t>(k));
    }
    return u;
  }

  const RootProblem& problem_;
  Eigen::Index n_;
  Clock::time_point end_;
  mutable double size_ = 0;  // of the terms at the last evaluation
};

}  // namespace

Roots find_roots(const RootProblem& problem, double seconds) { return RootFinder(problem, seconds).find(); }

}  // namespace poinsot::solve
