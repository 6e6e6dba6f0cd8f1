#include "engine/solve/roots/root_polish.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/solve/linear/decompositions.h"

namespace poinsot::solve {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double epsilon = std::numeric_limits<double>::epsilon();

// At some roots all terms vanish together, as at a pose of equilibrium, and the misfit cannot be measured by them.
// There the sizes of the terms close by are taken instead. It is a root only if the tangent's root is as near as
// rounding explains.
bool vanishes_with_its_terms(RootFunction& function, const VectorXd& u, const RootSample& sample, double least,
                             double misfit) {
  constexpr double aside = 1e-3;  // of the unknowns: what may be divided by there has lost three digits only
  if (!(misfit <= aside * function.problem().zero * least)) return false;
  for (const double way : {aside, -aside}) {
    const VectorXd beside = function.clamped(u + way * u.cwiseAbs().cwiseMax(1.0));
    if ((beside - u).norm() < 0.5 * aside) continue;
    const auto there = function.at(beside);
    if (there && misfit <= function.problem().zero * there->size &&
        sample.misfit <= std::max(sample.allowed, there->allowed))
      return true;
  }
  return false;
}

PolishedRoot judged(RootFunction& function, VectorXd u, RootSample sample, MatrixXd slopes) {
  PolishedRoot root;
  root.size = std::max(sample.size, (slopes.cwiseAbs() * u.cwiseAbs()).norm());
  const double misfit = sample.values.norm();
  root.zero = misfit <= function.problem().zero * root.size && sample.misfit <= sample.allowed;
  root.part = std::max(misfit / std::max(root.size, 1e-300), function.problem().zero * sample.misfit / sample.allowed);
  // The misfit moves a simple root by misfit / slope. Near a multiple root slope and misfit vanish together, and the
  // quotient is of the order of the distance to the root.
  const VectorXd stretch = u.cwiseAbs().cwiseMax(1.0);
  double least = 0;
  if (slopes.rows() >= slopes.cols()) least = (slopes * stretch.asDiagonal()).jacobiSvd().singularValues().minCoeff();
  root.zero = root.zero || vanishes_with_its_terms(function, u, sample, least, misfit);
  // How far the root may lie from here: the misfit and a few roundings of the terms, by the flattest direction, twenty
  // times over since slopes are those at one place only. It is never less than the last digits that steps leave, nor so
  // large that neighbours which differ in the third digit would be one.
  constexpr double sharpest = 1e-11, widest = 1e-3;
  const double noise = misfit + 8 * epsilon * root.size;
  root.radius = stretch.norm() * std::clamp(20 * noise / std::max(least, 1e-300), sharpest, widest);
  root.u = std::move(u);
  root.values = std::move(sample.values);
  root.slopes = std::move(slopes);
  return root;
}

// Where a step ends that would leave the ranges: most of the way to the border, so that the search can go on along
// it.
VectorXd stepped(const RootFunction& function, const VectorXd& u, const VectorXd& step) {
  constexpr double rest = 0.1, at_end = 1e-6;
  VectorXd next = u + step;
  for (Index k = 0; k < u.size(); ++k) {
    const RootRange& range = function.problem().ranges[static_cast<std::size_t>(k)];
    const double lower = range.lower / range.scale, upper = range.upper / range.scale;
    const auto toward = [&](double end) { return std::abs(u[k] - end) > at_end ? end + rest * (u[k] - end) : end; };
    if (u[k] >= lower && next[k] < lower) next[k] = toward(lower);
    if (u[k] <= upper && next[k] > upper) next[k] = toward(upper);
  }
  return next;
}

// How many steps the ranges leave room for from a place.
double room_along(const RootFunction& function, const VectorXd& u, const VectorXd& step) {
  double room = std::numeric_limits<double>::infinity();
  for (Index k = 0; k < u.size(); ++k) {
    const RootRange& range = function.problem().ranges[static_cast<std::size_t>(k)];
    if (step[k] == 0) continue;
    const double end = (step[k] > 0 ? range.upper : range.lower) / range.scale;
    room = std::min(room, std::max(0.0, (end - u[k]) / step[k]));
  }
  return room;
}

}  // namespace

std::optional<PolishedRoot> polish(RootFunction& function, const VectorXd& start, double enough) {
  VectorXd u = start;
  auto r = function.at(u);
  if (!r) return std::nullopt;
  const double first = std::max(r->values.norm(), 1e-300);
  double lambda = 1e-3;
  int creeping = 0;
  bool settled = false;
  for (int iteration = 0; iteration < 60 && !function.limit().spent(); ++iteration) {
    const auto J = function.slopes(u, *r);
    if (!J) return std::nullopt;
    const MatrixXd A = J->transpose() * *J;
    const VectorXd g = J->transpose() * r->values;
    if (r->values.norm() <= enough * r->size) return judged(function, std::move(u), std::move(*r), *J);
    bool moved = false;
    double ratio = 1;
    for (int attempt = 0; attempt < 12; ++attempt) {
      MatrixXd damped = A;
      damped.diagonal() += lambda * A.diagonal() + VectorXd::Constant(A.rows(), 1e-300);
      const VectorXd step = damped.ldlt().solve(-g);
      if (!step.allFinite()) break;
      const VectorXd next = stepped(function, u, step);
      const auto there = function.at(next);
      // A step by the last digits is the last one. It is taken if it leads nearer: an equation that only contradicts
      // others as long as it has any coefficient holds at the root and nowhere beside it.
      if (step.norm() <= 2 * epsilon * (1 + u.norm())) {
        if (there && there->values.size() == r->values.size() && there->values.norm() < r->values.norm()) {
          u = next;
          r = there;
        }
        break;
      }
      if (there && there->values.size() == r->values.size() && there->values.norm() < r->values.norm()) {
        ratio = there->values.norm() / r->values.norm();
        u = next;
        r = there;
        lambda = std::max(lambda / 10, 1e-15);
        moved = true;
        break;
      }
      lambda *= 10;
    }
    // The search ends where the misfit is rounding, or falls so slowly that this is its minimum.
    creeping = ratio > 0.99 ? creeping + 1 : 0;
    if (moved && r->values.norm() <= enough * r->size) return judged(function, std::move(u), std::move(*r), *J);
    // What is rounding beside the first misfit may be a misfit of a small unknown: one more step is tried.
    const bool small = r->values.norm() <= std::max(epsilon * first, 0.5 * epsilon * r->size);
    if (!moved || (small && settled) || creeping > 4) break;
    settled = small;
  }
  const auto J = function.slopes(u, *r);
  if (!J) return std::nullopt;
  return judged(function, std::move(u), std::move(*r), *J);
}

std::optional<PolishedRoot> polish_with(RootFunction& function, const VectorXd& start, const MatrixXd& slopes) {
  VectorXd u = function.clamped(start);
  auto r = function.at(u);
  if (!r || r->values.size() != slopes.rows()) return std::nullopt;
  const auto solver = slopes.completeOrthogonalDecomposition();
  for (int iteration = 0; iteration < 6; ++iteration) {
    if (r->values.norm() <= 0.5 * epsilon * r->size) break;
    const VectorXd next = function.clamped(u - solver.solve(r->values));
    // The last digits of small unknowns are digits of theirs, though not of what is as large as one.
    const bool last = (next - u).norm() <= 2 * epsilon * (1 + u.norm());
    if (next == u) break;
    const auto there = function.at(next);
    if (!there || there->values.size() != r->values.size() || there->values.norm() >= r->values.norm()) break;
    const bool creeping = there->values.norm() > 0.5 * r->values.norm();
    u = next;
    r = there;
    if (creeping || last) break;
  }
  return judged(function, std::move(u), std::move(*r), slopes);
}

std::optional<RootFamily> family_through(RootFunction& function, const PolishedRoot& root) {
  const VectorXd stretch = root.u.cwiseAbs().cwiseMax(1.0);
  const Eigen::JacobiSVD<MatrixXd> svd(root.slopes * stretch.asDiagonal(), Eigen::ComputeFullV);
  const VectorXd& sigma = svd.singularValues();
  // A direction in which the equations hardly change, beside the steepest one or beside the terms, of which a hundred
  // times the error of slopes by differences. It only suggests a curve of solutions; the walk along it decides.
  constexpr double beside_steepest = 1e-6, beside_terms = 1e-8;
  const double small = std::max(beside_steepest * sigma[0], beside_terms * root.size);
  VectorXd direction = VectorXd::Zero(root.u.size());
  for (Index k = 0; k < direction.size(); ++k)
    if (k >= sigma.size() || sigma[k] <= small) direction += svd.matrixV().col(k);
  if (direction.isZero()) return std::nullopt;
  const VectorXd unit_step = stretch.cwiseProduct(direction);
  for (const double way : {1.0, -1.0}) {
    constexpr double longest = 0.05, shortest = 1e-6;
    const double walk = std::min(longest, 0.5 * room_along(function, root.u, way * unit_step));
    if (walk < shortest) continue;
    const VectorXd ahead = root.u + way * walk * unit_step;
    if (!function.inside(ahead)) continue;
    const auto other = polish(function, ahead);
    if (!other || !other->zero || !function.inside(other->u)) continue;
    // Beside a multiple root the equations hold nearly, too: on a short walk only rounding may be left of them.
    constexpr double rounding = 1e-13;
    if (walk < longest && other->part > rounding) continue;
    // A walk that leads back to the root, or would, shows that the root stands alone.
    const VectorXd moved = (other->u - root.u).cwiseQuotient(stretch);
    if (moved.norm() < 0.5 * walk) continue;
    RootFamily family;
    family.other = other->u;
    for (Index k = 0; k < moved.size(); ++k)
      if (std::abs(moved[k]) > 1e-6 * moved.norm() || std::abs(direction[k]) > 1e-6)
        family.open_unknowns.push_back(static_cast<std::size_t>(k));
    return family;
  }
  return std::nullopt;
}

bool RootList::add(RootFunction& function, PolishedRoot root) {
  if (!function.in_ranges(root.u, root.values.norm())) return false;
  for (PolishedRoot& known : roots_) {
    if ((known.u - root.u).norm() > std::max(known.radius, root.radius)) continue;
    if (root.values.norm() * known.size < known.values.norm() * root.size) known = std::move(root);
    return false;
  }
  roots_.push_back(std::move(root));
  return true;
}

std::vector<std::vector<double>> RootList::points(const RootFunction& function) const {
  std::vector<std::vector<double>> points;
  for (const PolishedRoot& root : roots_) points.push_back(function.unscaled(function.clamped(root.u)));
  std::sort(points.begin(), points.end());
  return points;
}

}  // namespace poinsot::solve
