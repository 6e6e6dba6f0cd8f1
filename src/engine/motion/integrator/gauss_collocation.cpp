// Gauss-Legendre collocation of order 16 in equal steps:
//
//   Y_i = y + sum_j (a_ij / b_j) L_j,   L_j = h b_j f(t + c_j h, Y_j),   y+ = y + sum_j L_j,
//
// solved by iteration to rounding. Symmetric, so that energies of reversible motions stay bounded; keeps quadratic
// invariants: unit quaternions, the energy of a body under its weight. Sums are compensated, so that rounding grows as
// a random walk (Hairer, McLachlan, Razakarivony, BIT 48, 2008).
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <vector>

#include "engine/motion/integrator/gauss_step.h"
#include "engine/motion/integrator/methods.h"

namespace poinsot {

namespace {

namespace gauss = gauss_legendre_8;

// One step of any length, and the memory for it.
class GaussStep {
 public:
  explicit GaussStep(std::size_t n)
      : n_(n), increments_(gauss::stages * n), stage_(n), rate_(n), before_(gauss::stages * n) {}

  std::span<double> increments(int i) {
    return std::span<double>(increments_).subspan(static_cast<std::size_t>(i) * n_, n_);
  }

  // Every increment h b_j f(t, y): a start for the iteration where there is no step before.
  bool start_flat(RightSide& right_side, double t, std::span<const double> y, double h) {
    if (!right_side(t, y, rate_)) return false;
    for (int j = 0; j < gauss::stages; ++j) {
      for (std::size_t k = 0; k < n_; ++k) increments(j)[k] = h * gauss::weights[j] * rate_[k];
    }
    return true;
  }

  // From the increments of the step before, of equal length.
  void start_extrapolated() {
    std::swap(before_, increments_);
    for (int i = 0; i < gauss::stages; ++i) {
      const std::span<double> to = increments(i);
      std::fill(to.begin(), to.end(), 0.0);
      for (int j = 0; j < gauss::stages; ++j) {
        const double factor = gauss::weights[i] * gauss::ahead[i][j] / gauss::weights[j];
        const double* const from = &before_[static_cast<std::size_t>(j) * n_];
        for (std::size_t k = 0; k < n_; ++k) to[k] += factor * from[k];
      }
    }
  }

  // Iterates until the increments change no more or only by what rounding stirs: stopping earlier would leave an error
  // of one sign, and a drift. scale: what counts as 1.
  StepOutcome solve(RightSide& right_side, double t, std::span<const double> y, double h,
                    std::span<const double> scale) {
    // Rounds contract by half at the longest steps that are chosen, so that fifty reach the last digit; four times as
    // many are for steps that are stated.
    constexpr int most_iterations = 200;
    // Of the natural size of a component: sums over eight stages and the accelerations stir this much.
    constexpr double rounding = 400.0 * std::numeric_limits<double>::epsilon();
    double last_change = std::numeric_limits<double>::infinity();
    int without_progress = 0;
    for (int iteration = 0; iteration < most_iterations; ++iteration) {
      double change = 0.0;
      // Each stage uses those before it as they are now.
      for (int i = 0; i < gauss::stages; ++i) {
        for (std::size_t k = 0; k < n_; ++k) {
          double sum = 0.0;
          for (int j = 0; j < gauss::stages; ++j)
            sum += gauss::ratios[i][j] * increments_[static_cast<std::size_t>(j) * n_ + k];
          stage_[k] = y[k] + sum;
        }
        if (!right_side(t + gauss::nodes[i] * h, stage_, rate_)) return StepOutcome::not_finite;
        const std::span<double> own = increments(i);
        for (std::size_t k = 0; k < n_; ++k) {
          const double increment = h * gauss::weights[i] * rate_[k];
          change = std::max(change, std::fabs(increment - own[k]) / scale[k]);
          own[k] = increment;
        }
      }
      if (change == 0.0 || (change >= last_change && change < rounding)) return StepOutcome::advanced;
      if (change >= last_change && ++without_progress > 6) return StepOutcome::no_convergence;
      last_change = change;
    }
    return StepOutcome::no_convergence;
  }

  // The error of the step over `allowed`.
  double estimated_error(std::span<const double> allowed) const {
    double error = 0.0;
    double relative = 0.0;
    for (std::size_t k = 0; k < n_; ++k) {
      std::array<double, gauss::stages> c{};
      double size = 0.0;
      for (int j = 0; j < gauss::stages; ++j) {
        const double f = increments_[static_cast<std::size_t>(j) * n_ + k] / gauss::weights[j];
        for (int i = 0; i < gauss::stages; ++i) c[i] += gauss::legendre[i][j] * f;
        size = std::max(size, std::fabs(f));
      }
      const double left_out = gauss::left_out(c.data());
      error = std::max(error, left_out / allowed[k]);
      if (size > allowed[k]) relative = std::max(relative, left_out / size);
    }
    return error * relative;
  }

  // y + sum of the increments, smallest first.
  void add_to(std::span<double> y, std::span<double> carry) const {
    for (std::size_t k = 0; k < n_; ++k) {
      double gain = carry[k];
      for (int j = 0; j < gauss::stages / 2; ++j) {
        gain += increments_[static_cast<std::size_t>(j) * n_ + k] +
                increments_[static_cast<std::size_t>(gauss::stages - 1 - j) * n_ + k];
      }
      gauss::add_compensated(gain, y[k], carry[k]);
    }
  }

 private:
  std::size_t n_;
  std::vector<double> increments_;
  std::vector<double> stage_;
  std::vector<double> rate_;
  std::vector<double> before_;
};

// States within a step: a shorter step of the method.
class GaussFlow final : public StateFlow {
 public:
  GaussFlow(const MotionEquations& equations, std::vector<double> scale)
      : equations_(equations), scale_(std::move(scale)) {}

  void advance(double from, std::span<const double> start, double to, std::span<double> state) const override {
    std::copy(start.begin(), start.end(), state.begin());
    if (to == from) return;
    RightSide right_side(equations_);
    GaussStep step(start.size());
    std::vector<double> carry(start.size());
    const bool solved = step.start_flat(right_side, from, start, to - from) &&
                        step.solve(right_side, from, start, to - from, scale_) == StepOutcome::advanced;
    if (solved) {
      step.add_to(state, carry);
    } else {
      std::fill(state.begin(), state.end(), std::numeric_limits<double>::quiet_NaN());
    }
  }

 private:
  MotionEquations equations_;
  std::vector<double> scale_;
};

class GaussCollocation final : public FlowMethod {
 public:
  GaussCollocation(RightSide& right_side, const ErrorScale& scale, double h)
      : FlowMethod(static_cast<std::size_t>(right_side.size())),
        right_side_(right_side),
        scale_(scale),
        n_(static_cast<std::size_t>(right_side.size())),
        stated_(h),
        step_(n_),
        size_(n_) {}

  StepOutcome begin(double t, std::span<const double> y, double limit) override {
    begin_at(t, y);
    first_ = t;
    limit_ = limit;
    done_ = 0;
    has_history_ = false;
    if (!step_.start_flat(right_side_, t, y_, 0.0)) return StepOutcome::not_finite;
    if (limit == t) return StepOutcome::advanced;
    note_sizes();
    flow_ = std::make_shared<GaussFlow>(right_side_.equations(), size_);
    return choose_step();
  }

  StepOutcome advance(double) override {
    note_sizes();
    if (has_history_) {
      step_.start_extrapolated();
    } else if (!step_.start_flat(right_side_, t_, y_, h_)) {
      return StepOutcome::not_finite;
    }
    StepOutcome outcome = step_.solve(right_side_, t_, y_, h_, size_);
    if (outcome != StepOutcome::advanced && has_history_) {
      // The extrapolation may have led astray.
      if (!step_.start_flat(right_side_, t_, y_, h_)) return StepOutcome::not_finite;
      outcome = step_.solve(right_side_, t_, y_, h_, size_);
    }
    if (outcome != StepOutcome::advanced) return outcome;
    y_start_ = y_;
    start_ = t_;
    step_.add_to(y_, carry_);
    ++done_;
    t_ = done_ == count_ ? limit_ : first_ + static_cast<double>(done_) * h_;
    has_history_ = true;
    return StepOutcome::advanced;
  }

  std::int64_t rejected() const override { return 0; }

 private:
  // Natural sizes of the components, for convergence to rounding.
  void note_sizes() {
    for (std::size_t k = 0; k < n_; ++k) size_[k] = std::max({size_[k], std::fabs(y_[k]), scale_.size(k)});
  }

  // Equal steps as long as the error allows at the start and on the way of as many steps as show a swing of the motion,
  // unless stated.
  StepOutcome choose_step() {
    const double span = limit_ - first_;
    double h = stated_;
    if (h == 0.0) {
      std::vector<double> rate(n_);
      right_side_(first_, y_, rate);
      // An explicit method's first step is cautious: one of order 16 is mostly ten times too short.
      h = 10.0 * first_step(right_side_, first_, y_, rate, scale_.allowed(), span, 16);
      for (int attempt = 0; attempt < 12; ++attempt) {
        h = std::min(h, std::fabs(span));
        const double signed_h = std::copysign(h, span);
        if (!step_.start_flat(right_side_, first_, y_, signed_h)) return StepOutcome::not_finite;
        if (step_.solve(right_side_, first_, y_, signed_h, size_) != StepOutcome::advanced) {
          h *= 0.5;
          continue;
        }
        const double error = step_.estimated_error(scale_.allowed());
        // Below rounding an error tells nothing: at most ten times longer by this estimate, which then is bounded by 3.
        const double factor = 0.9 * std::pow(std::max(error, 1e-16), -1.0 / 16.0);
        if (factor >= 1.0 && (factor < 1.2 || h == std::fabs(span) || attempt > 6)) break;
        h *= std::clamp(factor, 0.3, 3.0);
      }
      const double worst = largest_error(std::copysign(h, span));
      if (worst > 1.0) h *= std::max(0.1, 0.9 * std::pow(worst, -1.0 / 16.0));
    }
    // A stated step goes into the span as often as its digits say, not once more by rounding; and a count has to be a
    // whole number among doubles.
    constexpr double rounding_of_count = 1e-12, most_steps = 1e15;
    const double count = std::ceil(std::fabs(span) / h * (1.0 - rounding_of_count));
    if (!(count < most_steps)) return StepOutcome::too_small;
    count_ = std::max<std::int64_t>(1, static_cast<std::int64_t>(count));
    h_ = span / static_cast<double>(count_);
    return StepOutcome::advanced;
  }

  // Of the first steps of this length, over what is allowed; infinite if one cannot be made.
  double largest_error(double h) {
    constexpr int looks = 32;  // steps: a swing of the motion takes some ten of this order
    std::vector<double> y = y_;
    std::vector<double> carry(n_);
    double largest = 0.0;
    bool known = false;
    for (int k = 0; k < looks && std::fabs(k * h) < std::fabs(limit_ - first_); ++k) {
      const double t = first_ + k * h;
      if (known) {
        step_.start_extrapolated();
      } else if (!step_.start_flat(right_side_, t, y, h)) {
        return std::numeric_limits<double>::infinity();
      }
      if (step_.solve(right_side_, t, y, h, size_) != StepOutcome::advanced)
        return std::numeric_limits<double>::infinity();
      known = true;
      largest = std::max(largest, step_.estimated_error(scale_.allowed()));
      step_.add_to(y, carry);
    }
    return largest;
  }

  RightSide& right_side_;
  const ErrorScale& scale_;
  std::size_t n_;
  double stated_;
  GaussStep step_;
  double first_ = 0.0;
  double limit_ = 0.0;
  double h_ = 0.0;
  std::int64_t count_ = 0;
  std::int64_t done_ = 0;
  bool has_history_ = false;
  std::vector<double> size_;
};

}  // namespace

std::unique_ptr<StepMethod> make_gauss_method(RightSide& right_side, const ErrorScale& scale, double h) {
  return std::make_unique<GaussCollocation>(right_side, scale, h);
}

}  // namespace poinsot
