// What the steppers of Gauss-Legendre collocation have in common: equal stages one by one (gauss_collocation.cpp), all
// stages in packs (packed_step.cpp), and those of one turning body (rotation/rotation_collocation.cpp).
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <span>
#include <vector>

#include "engine/motion/integrator/gauss_legendre_8.h"
#include "engine/motion/integrator/step_method.h"
#include "poinsot/engine/math/algebra/pack.h"

namespace poinsot::gauss_legendre_8 {

// The tables with a number per stage in each pack.
struct StagePacks {
  using Stages = Pack<stages>;
  Stages ratios[stages];  // column j of a_ij / b_j
  Stages nodes;
  Stages weights;

  StagePacks() {
    for (int j = 0; j < stages; ++j)
      ratios[j] = Stages::from_lanes([j](int i) { return gauss_legendre_8::ratios[i][j]; });
    nodes = Stages::from_lanes([](int i) { return gauss_legendre_8::nodes[i]; });
    weights = Stages::from_lanes([](int i) { return gauss_legendre_8::weights[i]; });
  }
};

// What the Legendre coefficients c of dy/dt leave over, from their decay: the error of the solution is the first
// coefficient left out times as small a one of the adjoint motion.
inline double left_out(const double* c) {
  // Two by two, as symmetric motions have every other coefficient zero.
  const double last = std::max(std::fabs(c[7]), std::fabs(c[6]));
  const double before = std::max(std::fabs(c[5]), std::fabs(c[4]));
  return before > 0.0 ? last * std::min(1.0, last / before) : last;
}

// Adds to y a gain that includes what rounding took off y before, the carry (Kahan).
inline void add_compensated(double gain, double& y, double& carry) {
  const double old = y;
  y = old + gain;
  carry = gain - (y - old);
}

// The sum of the increments of all stages, smallest first.
inline double sum_of_increments(const double* L) {
  return ((L[0] + L[7]) + (L[1] + L[6])) + ((L[2] + L[5]) + (L[3] + L[4]));
}

// Whether the rounds to come change less than is allowed, all together, if they contract as the last one did.
inline bool contracted(double change, double contraction, double allowed) {
  return contraction < 1.0 && change * contraction < allowed * (1.0 - contraction);
}

}  // namespace poinsot::gauss_legendre_8

namespace poinsot {

// A method whose states within a step are shorter steps of itself, and whose sums are compensated.
class FlowMethod : public StepMethod {
 public:
  double time() const final { return t_; }
  std::span<double> state() final { return y_; }
  // Changes at the level of rounding are the rule, and what rounding took off the state still holds.
  void state_changed(bool noticeably) final {
    if (noticeably) std::fill(carry_.begin(), carry_.end(), 0.0);
  }
  StepView last_step() final { return {start_, t_ - start_, t_, StepForm::flow, y_start_, flow_.get()}; }
  std::shared_ptr<const StateFlow> flow() const final { return flow_; }

 protected:
  explicit FlowMethod(std::size_t n) : y_(n), y_start_(n), carry_(n) {}

  void begin_at(double t, std::span<const double> y) {
    std::copy(y.begin(), y.end(), y_.begin());
    std::fill(carry_.begin(), carry_.end(), 0.0);
    t_ = t;
  }

  double t_ = 0.0;
  double start_ = 0.0;
  std::vector<double> y_;
  std::vector<double> y_start_;
  std::vector<double> carry_;
  std::shared_ptr<const StateFlow> flow_;
};

}  // namespace poinsot
