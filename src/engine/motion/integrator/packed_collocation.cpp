#include "engine/motion/integrator/packed_collocation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "engine/motion/integrator/gauss_step.h"
#include "engine/motion/integrator/packed_step.h"

namespace poinsot {

namespace {

constexpr int order = 2 * gauss_legendre_8::stages;

// States within a step: shorter steps.
class PackedFlow final : public StateFlow {
 public:
  PackedFlow(const MotionEquations& equations, const ErrorScale& scale)
      : equations_(equations), allowed_(scale.allowed().begin(), scale.allowed().end()) {}

  void advance(double from, std::span<const double> start, double to, std::span<double> state) const override {
    std::copy(start.begin(), start.end(), state.begin());
    std::vector<double> carry(start.size());
    PackedStep step(equations_);
    const bool arrived = step_by_halves(from, to, [&](double t, double h) {
      const bool solved = step.start_flat(t, state, h) && step.solve(t, state, h, allowed_) == StepOutcome::advanced;
      if (solved) step.add_to(state, carry);
      return solved;
    });
    if (!arrived) std::fill(state.begin(), state.end(), std::numeric_limits<double>::quiet_NaN());
  }

 private:
  MotionEquations equations_;
  std::vector<double> allowed_;
};

class PackedCollocation final : public FlowMethod {
 public:
  PackedCollocation(RightSide& right_side, const ErrorScale& scale, double first, double largest)
      : FlowMethod(static_cast<std::size_t>(right_side.size())),
        right_side_(right_side),
        scale_(scale),
        first_(first),
        largest_(largest > 0.0 ? largest : std::numeric_limits<double>::infinity()),
        step_(right_side.equations()) {}

  StepOutcome begin(double t, std::span<const double> y, double limit) override {
    begin_at(t, y);
    series_ = Series::none;
    hasty_ = true;
    calm_steps_ = 0;
    stiff_signs_ = 0;
    flow_ = std::make_shared<PackedFlow>(right_side_.equations(), scale_);
    std::vector<double> rate(y_.size());
    if (!right_side_(t, y_, rate)) return StepOutcome::not_finite;
    if (limit == t) return StepOutcome::advanced;
    const double h = first_ > 0.0 ? first_ : first_step(right_side_, t, y_, rate, scale_.allowed(), limit - t, order);
    h_ = std::copysign(std::min(h, largest_), limit - t);
    return StepOutcome::advanced;
  }

  StepOutcome advance(double limit) override {
    int failures = 0;
    for (;;) {
      const auto [h, end, at_limit, smallest] = step_towards(limit, t_, h_, largest_);
      if (std::fabs(h) <= smallest && !at_limit) return refused_;

      if (series_ != Series::none) {
        step_.start_from_series(h, series_length_, series_ == Series::of_step_before);
      } else if (!step_.start_flat(t_, y_, h)) {
        return StepOutcome::not_finite;
      }
      const StepOutcome outcome = step_.solve(t_, y_, h, scale_.allowed());
      if (outcome != StepOutcome::advanced) {
        ++rejected_;
        if (std::fabs(h) <= smallest) return outcome;
        refused_ = outcome == StepOutcome::not_finite ? outcome : StepOutcome::too_small;
        // The series may have led astray.
        if (++failures > 1) series_ = Series::none;
        calm_steps_ = 0;
        h_ = 0.6 * h;
        continue;
      }
      const double error = step_.find_series(scale_.allowed());
      series_length_ = h;
      // No longer than by a hundredth of the tolerance at the sixteenth power, however small the error.
      const double by_error = 0.8 * std::pow(std::max(error, 1e-32), -1.0 / order);
      calm_steps_ = by_error > 1.1 ? calm_steps_ + 1 : 0;
      if (error > 1.0) {
        ++rejected_;
        if (std::fabs(h) <= smallest) return StepOutcome::too_small;
        refused_ = StepOutcome::too_small;
        series_ = Series::of_longer_step;
        hasty_ = false;
        h_ = std::max(0.3, by_error) * h;
        continue;
      }

      y_start_ = y_;
      start_ = t_;
      step_.add_to(y_, carry_);
      t_ = end;
      series_ = Series::of_step_before;
      // Rounds that contract by less than a third are dear.
      const double by_rounds = std::max(0.5, 0.3 / std::max(step_.contraction(), 1e-3));
      const double growth = std::min({by_error, by_rounds, most_growth()});
      if (growth < 1.1) hasty_ = false;
      if (!at_limit || growth < 1.0 || std::fabs(h_) < std::fabs(h)) h_ = growth * h;
      stiff_signs_ = by_error > 5.0 && by_rounds < 1.1 ? stiff_signs_ + 1 : 0;
      return stiff_signs_ >= 15 ? StepOutcome::stiff : StepOutcome::advanced;
    }
  }

  std::int64_t rejected() const override { return rejected_; }
  std::int64_t evaluations() const override { return gauss_legendre_8::stages * step_.rounds(); }

 private:
  // What there is to start a step from.
  enum class Series { none, of_step_before, of_longer_step };

  // Steps are as long as a swing of the motion takes, and their errors go up and down with it: growing at every chance
  // would have every third step refused. So they grow by little, unless the error has been small for a while.
  double most_growth() const { return hasty_ || calm_steps_ > 6 ? 1.5 : 1.03; }

  RightSide& right_side_;
  const ErrorScale& scale_;
  double first_;
  double largest_;
  PackedStep step_;
  double h_ = 0.0;  // proposed, signed
  Series series_ = Series::none;
  double series_length_ = 0.0;
  bool hasty_ = true;  // the first steps have not yet found their length
  int calm_steps_ = 0;
  int stiff_signs_ = 0;
  StepOutcome refused_ = StepOutcome::too_small;
  std::int64_t rejected_ = 0;
};

}  // namespace

std::unique_ptr<StepMethod> make_packed_collocation(RightSide& right_side, const ErrorScale& scale, double first,
                                                    double largest) {
  return std::make_unique<PackedCollocation>(right_side, scale, first, largest);
}

}  // namespace poinsot
