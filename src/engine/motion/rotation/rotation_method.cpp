#include "engine/motion/rotation/rotation_method.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "engine/motion/rotation/rotation_collocation.h"
#include "engine/motion/rotation/rotation_splitting.h"

namespace poinsot {

namespace {

using Numbers = std::array<double, 7>;

double largest_momentum(const Rotor& rotor, const RotationState& state, double span) {
  return std::max({norm(state.momentum), rotor.principal.moments.z / span, 1e-300});
}

// What a step by quadrature leaves of the energy turns up as a wrong rate of the spin, whose angle then goes off with
// the time: the energy from before is given back, where a turn by at most a hundred times the tolerance does it. Near a
// rotation about a principal axis, where next to no turn changes the energy, nothing is done.
// The turn is a rotation to first order, which a thousandth of a radian still is to six digits.
void give_back_energy(const PrincipalBody& body, double energy, double tolerance, RotationState& end) {
  constexpr double times_tolerance = 100.0, largest_turn = 1e-3;
  if (body.keeps_energy()) body.restore_energy(end, energy, std::min(times_tolerance * tolerance, largest_turn));
}

double root_16(double x) { return std::sqrt(std::sqrt(std::sqrt(std::sqrt(x)))); }

// Within a step of the collocation: a shorter one, halved where that is needed.
class CollocationFlow final : public StateFlow {
 public:
  CollocationFlow(std::shared_ptr<const Rotor> rotor, double accuracy)
      : rotor_(std::move(rotor)), accuracy_(accuracy) {}

  void advance(double from, std::span<const double> start, double to, std::span<double> y) const override {
    std::copy(start.begin(), start.end(), y.begin());
    if (to == from) return;
    const PrincipalBody& body = rotor_->principal;
    RotationState state = read_rotation(body, start.data());
    const double energy = body.energy(state);
    const bool arrived = step_by_halves(from, to, [&](double t, double h) {
      const double size = largest_momentum(*rotor_, state, std::fabs(to - from));
      const RotationStep step = rotation_step(body, state, t, h, size, 0.01 * accuracy_);
      if (!step.converged) return false;
      state = step.end;
      give_back_energy(body, energy, accuracy_, state);
      return true;
    });
    write_rotation(body, state, y.data());
    if (!arrived) std::fill(y.begin(), y.end(), std::numeric_limits<double>::quiet_NaN());
  }

 private:
  std::shared_ptr<const Rotor> rotor_;
  double accuracy_;
};

// What the methods for one turning body have in common: the state, in the body's momentum and attitude.
class RotationSteps : public StepMethod {
 public:
  double time() const override { return t_; }
  std::span<double> state() override {
    write_rotation(rotor_->principal, state_, y_.data());
    return y_;
  }
  // Nothing changes it but rounding.
  void state_changed(bool) override {}
  bool minds_itself() const override { return true; }
  StepView last_step() override {
    write_rotation(rotor_->principal, state_start_, y_start_.data());
    return {start_, t_ - start_, t_, StepForm::flow, y_start_, flow_.get()};
  }
  std::shared_ptr<const StateFlow> flow() const override { return flow_; }

 protected:
  RotationSteps(std::shared_ptr<const Rotor> rotor, std::shared_ptr<const StateFlow> flow)
      : rotor_(std::move(rotor)), flow_(std::move(flow)) {}

  void begin_at(double t, std::span<const double> y) {
    std::copy(y.begin(), y.end(), y_.begin());
    state_ = read_rotation(rotor_->principal, y_.data());
    t_ = t;
  }
  void begin_step() {
    momentum_size_ = std::max(momentum_size_, norm(state_.momentum));
    state_start_ = state_;
    start_ = t_;
  }

  std::shared_ptr<const Rotor> rotor_;
  std::shared_ptr<const StateFlow> flow_;
  RotationState state_;
  RotationState state_start_;
  double momentum_size_ = 1.0;
  double t_ = 0.0;
  double start_ = 0.0;

 private:
  Numbers y_{};
  Numbers y_start_{};
};

class RotationCollocation final : public RotationSteps {
 public:
  RotationCollocation(const std::shared_ptr<const Rotor>& rotor, const IntegrationOptions& options)
      : RotationSteps(rotor, std::make_shared<CollocationFlow>(rotor, options.tolerance)),
        tolerance_(options.tolerance),
        first_(options.first_step),
        largest_(options.largest_step > 0.0 ? options.largest_step : INFINITY) {}

  StepOutcome begin(double t, std::span<const double> y, double limit) override {
    begin_at(t, y);
    const double span = std::fabs(limit - t);
    if (span == 0.0) return StepOutcome::advanced;
    momentum_size_ = largest_momentum(*rotor_, state_, span);
    last_error_ = tolerance_;
    energy_ = rotor_->principal.energy(state_);
    // Of order 16: the step hardly feels the tolerance.
    const double h =
        first_ > 0.0 ? first_ : 2.0 * root_16(tolerance_) * natural_step(rotor_->principal, state_, t, span);
    h_ = std::copysign(std::min(h, span), limit - t);
    return StepOutcome::advanced;
  }

  StepOutcome advance(double limit) override {
    const PrincipalBody& body = rotor_->principal;
    begin_step();
    for (;;) {
      const auto [h, end, at_limit, smallest] = step_towards(limit, t_, h_, largest_);
      if (std::fabs(h) <= smallest && !at_limit) return StepOutcome::too_small;

      const RotationStep step = rotation_step(body, state_, t_, h, momentum_size_, 0.01 * tolerance_);
      rounds_ += step.iterations;
      if (!step.converged) {
        ++rejected_;
        if (std::fabs(h) < 1e-12 * std::fabs(limit - t_) || rejected_in_a_row_ > 60)
          return step.finite ? StepOutcome::no_convergence : StepOutcome::not_finite;
        ++rejected_in_a_row_;
        h_ = 0.5 * h;
        continue;
      }
      // The error is of order 16; one that is on the rise will rise on.
      const double excess = std::max(step.error, 1e-8 * tolerance_) / tolerance_;
      const double trend = std::max(1.0, step.error / std::max(last_error_, 1e-30));
      const double by_error = 0.85 * root_16(std::sqrt(1.0 / trend) / excess);
      if (step.error > tolerance_) {
        ++rejected_;
        h_ = h * std::max(0.3, by_error);
        continue;
      }
      rejected_in_a_row_ = 0;
      last_error_ = step.error;
      // Rounds that contract by less than a fifth are dear.
      const double growth = std::min({by_error, std::max(0.5, 0.2 / std::max(step.contraction, 1e-3)), 1.5});
      if (!at_limit || growth < 1.0 || std::fabs(h_) < std::fabs(h)) h_ = growth * h;
      t_ = end;
      state_ = step.end;
      give_back_energy(body, energy_, tolerance_, state_);
      return StepOutcome::advanced;
    }
  }

  std::int64_t rejected() const override { return rejected_; }
  std::int64_t evaluations() const override { return 8 * rounds_; }

 private:
  double tolerance_;
  double first_;
  double largest_;
  double energy_ = 0.0;  // J, at the start
  double h_ = 0.0;
  double last_error_ = 0.0;
  std::int64_t rejected_ = 0;
  int rejected_in_a_row_ = 0;
  std::int64_t rounds_ = 0;
};

// Equal steps for long runs: the splitting for a body with an axis of symmetry, whose energy error stays bounded
// whatever the step; for others the collocation solved to rounding, for which a splitting would need to follow the
// turning of the body in far shorter steps.
class EqualSteps {
 public:
  explicit EqualSteps(const PrincipalBody& body) : body_(body), splitting_(body) {}

  bool splits() const { return splitting_.is_symmetric(); }
  // False if the implicit equations could not be solved, however the step is parted. evaluations: those of the torque
  // are added.
  bool step(RotationState& state, double t, double h, double momentum_size, std::int64_t& evaluations,
            int partings = 8) const {
    if (splits()) {
      splitting_.step(state, t, h);
      evaluations += RotationSplitting::torques_per_step;
      return true;
    }
    constexpr double to_rounding =
        1e-18;  // of the increments: less than they can change, so that rounds go on to the end
    const RotationStep step = rotation_step(body_, state, t, h, momentum_size, to_rounding);
    evaluations += 8 * step.iterations;
    if (step.converged) state = step.end;
    if (step.converged || !step.finite || partings == 0) return step.converged;
    // In two halves where the body is too fast for the rounds to contract.
    return this->step(state, t, 0.5 * h, momentum_size, evaluations, partings - 1) &&
           this->step(state, t + 0.5 * h, 0.5 * h, momentum_size, evaluations, partings - 1);
  }

 private:
  const PrincipalBody& body_;
  RotationSplitting splitting_;
};

class EqualStepFlow final : public StateFlow {
 public:
  explicit EqualStepFlow(std::shared_ptr<const Rotor> rotor) : rotor_(std::move(rotor)), steps_(rotor_->principal) {}
  void advance(double from, std::span<const double> start, double to, std::span<double> y) const override {
    RotationState state = read_rotation(rotor_->principal, start.data());
    std::int64_t evaluations = 0;
    steps_.step(state, from, to - from, largest_momentum(*rotor_, state, INFINITY), evaluations);
    write_rotation(rotor_->principal, state, y.data());
  }

 private:
  std::shared_ptr<const Rotor> rotor_;
  EqualSteps steps_;
};

class RotationInEqualSteps final : public RotationSteps {
 public:
  RotationInEqualSteps(const std::shared_ptr<const Rotor>& rotor, const IntegrationOptions& options)
      : RotationSteps(rotor, std::make_shared<EqualStepFlow>(rotor)),
        steps_(rotor_->principal),
        // Differences of steps show nothing finer than rounding.
        tolerance_(std::max(options.tolerance, 1e-14)),
        stated_(options.fixed_step) {}

  StepOutcome begin(double t, std::span<const double> y, double limit) override {
    begin_at(t, y);
    first_ = t;
    limit_ = limit;
    done_ = 0;
    const double span = std::fabs(limit - t);
    if (span == 0.0) return StepOutcome::advanced;
    momentum_size_ = largest_momentum(*rotor_, state_, span);
    const double h = stated_ > 0.0 ? stated_ : chosen_step(span);
    // A stated step goes into the span as often as its digits say, not once more by rounding; and a count has to be a
    // whole number among doubles.
    constexpr double rounding_of_count = 1e-12, most_steps = 1e15;
    const double count = std::ceil(span / h * (1.0 - rounding_of_count));
    if (!(count < most_steps)) return StepOutcome::too_small;
    count_ = std::max<std::int64_t>(1, static_cast<std::int64_t>(count));
    h_ = (limit - t) / static_cast<double>(count_);
    return StepOutcome::advanced;
  }

  StepOutcome advance(double) override {
    begin_step();
    if (!steps_.step(state_, t_, h_, momentum_size_, evaluations_)) return StepOutcome::no_convergence;
    ++done_;
    t_ = done_ == count_ ? limit_ : first_ + static_cast<double>(done_) * h_;
    return std::isfinite(norm_squared(state_.momentum) + norm_squared(state_.attitude)) ? StepOutcome::advanced
                                                                                        : StepOutcome::not_finite;
  }

  std::int64_t rejected() const override { return 0; }
  std::int64_t evaluations() const override { return evaluations_; }

 private:
  // The longest step that differs by no more than the tolerance from two of half its length, here and on the way of as
  // many steps as show a swing of the motion.
  double chosen_step(double span) {
    constexpr int looks = 32;  // steps: a swing of the motion takes some ten of this order
    double h = std::min(span, natural_step(rotor_->principal, state_, first_, span));
    const double sense = limit_ > first_ ? 1.0 : -1.0;
    RotationState state = state_;
    double t = first_;
    for (int look = 0; look < looks && std::fabs(t - first_) < span; ++look) {
      h = step_from(state, t, sense * h);
      if (!steps_.step(state, t, sense * h, momentum_size_, evaluations_)) break;
      t += sense * h;
    }
    return h;
  }

  // No longer than h.
  double step_from(const RotationState& state, double t, double signed_h) {
    double h = std::fabs(signed_h);
    for (int attempt = 0; attempt < 60; ++attempt) {
      const double half = std::copysign(0.5 * h, signed_h);
      RotationState once = state;
      RotationState twice = state;
      const bool solved = steps_.step(once, t, 2.0 * half, momentum_size_, evaluations_, 0) &&
                          steps_.step(twice, t, half, momentum_size_, evaluations_, 0) &&
                          steps_.step(twice, t + half, half, momentum_size_, evaluations_, 0);
      if (!solved) {
        h *= 0.5;
        continue;
      }
      const Quaternion<double> apart = conjugate(once.attitude) * twice.attitude;
      const double error =
          std::max(2.0 * norm(vector_part(apart)), norm(once.momentum - twice.momentum) / momentum_size_);
      if (error <= tolerance_) break;
      h *= std::clamp(0.9 * std::pow(tolerance_ / error, 1.0 / (steps_.splits() ? 9.0 : 17.0)), 0.2, 0.95);
    }
    return h;
  }

  EqualSteps steps_;
  double tolerance_;
  double stated_;
  double first_ = 0.0;
  double limit_ = 0.0;
  double h_ = 0.0;
  std::int64_t count_ = 0;
  std::int64_t done_ = 0;
  std::int64_t evaluations_ = 0;
};

}  // namespace

std::unique_ptr<StepMethod> make_rotation_collocation(const std::shared_ptr<const Rotor>& rotor,
                                                      const IntegrationOptions& options) {
  return std::make_unique<RotationCollocation>(rotor, options);
}
std::unique_ptr<StepMethod> make_rotation_in_equal_steps(const std::shared_ptr<const Rotor>& rotor,
                                                         const IntegrationOptions& options) {
  return std::make_unique<RotationInEqualSteps>(rotor, options);
}
}  // namespace poinsot
