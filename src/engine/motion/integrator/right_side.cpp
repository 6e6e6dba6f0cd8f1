#include "engine/motion/integrator/right_side.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "poinsot/engine/work/work.h"

namespace poinsot {

namespace {

constexpr Work of_a_number = 100;  // of the state, for its rate

}  // namespace

bool RightSide::operator()(double t, std::span<const double> y, std::span<double> rate) {
  ++evaluations_;
  count_work(of_a_number * static_cast<Work>(size()));
  const std::size_t nq = position_count();
  if (equations_.position_rate) {
    equations_.position_rate(t, y.first(nq), y.subspan(nq), rate.first(nq));
  } else {
    std::copy(y.begin() + equations_.position_size, y.end(), rate.begin());
  }
  equations_.accelerations(t, y.first(nq), y.subspan(nq), rate.subspan(nq));
  // The difference of a number from itself is zero unless it is not finite.
  double sum = 0.0;
  for (const double r : rate) sum += r - r;
  return sum == 0.0;
}

double RightSide::project(double t, std::span<double> y, std::span<const double> scale) {
  before_.assign(y.begin(), y.end());
  const std::size_t nq = position_count();
  if (equations_.project) equations_.project(t, y.first(nq), y.subspan(nq));
  for (const int first : equations_.quaternions) {
    double* c = &y[static_cast<std::size_t>(first)];
    const double inverse = 1.0 / std::sqrt(c[0] * c[0] + c[1] * c[1] + c[2] * c[2] + c[3] * c[3]);
    for (int k = 0; k < 4; ++k) c[k] *= inverse;
  }
  double largest = 0.0;
  for (std::size_t i = 0; i < y.size(); ++i) largest = std::max(largest, std::fabs(y[i] - before_[i]) / scale[i]);
  return largest;
}

ErrorScale::ErrorScale(const MotionEquations& equations, double tolerance, double span)
    : tolerance_(tolerance),
      position_count_(static_cast<std::size_t>(equations.position_size)),
      velocities_grow_(equations.velocity_sizes.empty()),
      sizes_(equations.position_sizes),
      allowed_(position_count_ + static_cast<std::size_t>(equations.velocity_size)) {
  sizes_.resize(position_count_, 1.0);
  if (velocities_grow_) {
    const double largest = sizes_.empty() ? 1.0 : *std::max_element(sizes_.begin(), sizes_.end());
    sizes_.resize(allowed_.size(), span > 0.0 ? largest / span : 1.0);
  } else {
    sizes_.insert(sizes_.end(), equations.velocity_sizes.begin(), equations.velocity_sizes.end());
  }
}

void ErrorScale::update(std::span<const double> y) {
  for (std::size_t i = 0; i < y.size(); ++i) {
    const double magnitude = std::fabs(y[i]);
    if (velocities_grow_ && i >= position_count_) sizes_[i] = std::max(sizes_[i], magnitude);
    allowed_[i] = tolerance_ * sizes_[i] + std::numeric_limits<double>::epsilon() * magnitude;
  }
}

}  // namespace poinsot
