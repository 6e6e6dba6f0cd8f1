#include "engine/motion/closed_form/known_motion.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <vector>

#include "poinsot/engine/math/algebra/rotation.h"

namespace poinsot {
namespace {

using Vector = Vector3<double>;

class UniformRotation final : public RotationFlow {
 public:
  UniformRotation(double t0, const BodyPose& pose)
      : t0_(t0), attitude_(pose.attitude), angular_velocity_(pose.angular_velocity) {}

  void advance(double, const BodyPose&, double t, BodyPose& pose) const override {
    pose.attitude = normalized(attitude_ * quaternion_exponential((t - t0_) * angular_velocity_));
    pose.angular_velocity = angular_velocity_;
  }
  double natural_time() const override { return 1 / norm(angular_velocity_); }
  std::vector<double> periods() const override { return {2 * std::numbers::pi / norm(angular_velocity_)}; }

 private:
  double t0_;
  Quaternion<double> attitude_;
  Vector angular_velocity_;
};

class TorqueFreeRotation final : public RotationFlow {
 public:
  TorqueFreeRotation(double t0, const BodyPose& pose, const SymmetricMatrix3<double>& inertia)
      : t0_(t0), motion_(TorqueFreeMotion::of_tensor(inertia, pose.attitude, pose.angular_velocity)) {}

  void advance(double, const BodyPose&, double t, BodyPose& pose) const override {
    const TorqueFreeMotion::State state = motion_.at(t - t0_);
    pose.attitude = state.attitude;
    pose.angular_velocity = state.angular_velocity;
  }
  double natural_time() const override { return 1 / motion_.polhode().speed_range().maximum; }
  // Of the angular velocity in the body; of the axis of symmetry in space.
  std::vector<double> periods() const override {
    return {motion_.period(), 2 * std::numbers::pi / std::abs(motion_.mean_precession_rate()),
            2 * std::numbers::pi / motion_.polhode().speed_range().maximum};
  }

 private:
  double t0_;
  TorqueFreeMotion motion_;
};

// The top's own frames: Z' of the ground upward, z' of the body along its axis.
class TopRotation final : public RotationFlow {
 public:
  TopRotation(double t0, const BodyPose& pose, const TopParameters& parameters, const Vector& axis, const Vector& up)
      : t0_(t0),
        to_ground_(quaternion_of(axes_with_z_along(up))),
        to_body_(quaternion_of(axes_with_z_along(axis))),
        top_(parameters, start_of(conjugate(to_ground_) * pose.attitude * to_body_,
                                  transpose_times(axes_with_z_along(axis), pose.angular_velocity))) {
    // The fastest that the energy allows.
    const double across = norm(cross(axis, pose.angular_velocity));
    const double axial = dot(axis, pose.angular_velocity);
    const double fastest = std::hypot(
        axial, std::sqrt(across * across + 4 * std::abs(parameters.gravity_moment) / parameters.transverse_moment));
    natural_time_ = 1 / fastest;
    if (std::isfinite(top_.nutation_period()) && top_.nutation_period() > 0)
      natural_time_ = std::min(natural_time_, top_.nutation_period() / 6);
  }

  void advance(double, const BodyPose&, double t, BodyPose& pose) const override {
    const SymmetricTop::Turning turning = top_.turning(t - t0_);
    pose.attitude = to_ground_ * turning.attitude * conjugate(to_body_);
    pose.angular_velocity = rotation_matrix(to_body_) * turning.angular_velocity;
  }
  double natural_time() const override { return natural_time_; }
  // Through the vertical the axis goes to the other side, and comes back in the next period of its nutation.
  std::vector<double> periods() const override {
    return {top_.nutation_period(), 2 * top_.nutation_period(),
            2 * std::numbers::pi / std::abs(top_.mean_precession_rate())};
  }

 private:
  // Eulerian angles and their rates (Eq. 18.33): exp(k phi/2) exp(j theta/2) exp(k psi/2) is q.
  static TopState start_of(const Quaternion<double>& q, const Vector& w) {
    TopState start;
    const double upper = std::hypot(q.w, q.z), lower = std::hypot(q.x, q.y);
    start.nutation = 2 * std::atan2(lower, upper);
    start.axial_rate = w.z;
    constexpr double vertical = 1e-15;  // the sine of half the angle: rounding of a unit quaternion
    const double half_sum = std::atan2(q.z, q.w), half_difference = std::atan2(q.x, q.y);
    if (lower < vertical || upper < vertical) {
      // The line of nodes is free: all that the axis moves is nutation.
      start.nutation = lower < vertical ? 0 : std::numbers::pi;
      start.spin = std::atan2(w.x, w.y);
      start.precession = lower < vertical ? 2 * half_sum - start.spin : start.spin - 2 * half_difference;
      start.nutation_rate = std::hypot(w.x, w.y);
      return start;
    }
    start.precession = half_sum - half_difference;
    start.spin = half_sum + half_difference;
    const double s = std::sin(start.spin), c = std::cos(start.spin);
    start.nutation_rate = w.x * s + w.y * c;
    start.precession_rate = (w.y * s - w.x * c) / (2 * lower * upper);
    return start;
  }

  double t0_;
  Quaternion<double> to_ground_, to_body_;
  SymmetricTop top_;
  double natural_time_ = 0;
};

// The planar case of the top, with the sense that theta lacks.
class AxisFlow final : public WindingFlow {
 public:
  AxisFlow(const AxisMotion& motion, double natural_time)
      : motion_(motion),
        natural_time_(natural_time),
        sense_(motion.angle > 0 || (motion.angle == 0 && motion.rate >= 0) ? 1 : -1),
        top_({motion.moment, 0, motion.weight_moment}, {std::abs(motion.angle), sense_ * motion.rate, 0, 0, 0, 0}) {}

  void advance(double from, std::span<const double> start, double to, std::span<double> state) const override {
    if (to == from) {
      std::copy(start.begin(), start.end(), state.begin());
      return;
    }
    nearest(to, start, state);
  }
  void nearest(double t, std::span<const double> before, std::span<double> state) const override {
    // In the plane of the swing the attitude is exp(j angle/2).
    const auto [attitude, angular_velocity] = top_.turning(t - motion_.t0);
    constexpr double turn = 2 * std::numbers::pi;
    const double angle = motion_.coordinate + (sense_ * 2 * std::atan2(attitude.y, attitude.w) - motion_.angle);
    state[0] = angle + turn * std::nearbyint((before[0] - angle) / turn);
    state[1] = sense_ * angular_velocity.y;
  }
  double natural_time() const override { return natural_time_; }
  // A swing is two nutations, a whole turn is one.
  std::vector<double> periods() const { return {top_.nutation_period(), 2 * top_.nutation_period()}; }

 private:
  AxisMotion motion_;
  double natural_time_;
  double sense_;
  SymmetricTop top_;
};

class UniformAxisFlow final : public WindingFlow {
 public:
  UniformAxisFlow(const AxisMotion& motion, double natural_time) : motion_(motion), natural_time_(natural_time) {}
  void advance(double, std::span<const double> start, double to, std::span<double> state) const override {
    nearest(to, start, state);
  }
  void nearest(double t, std::span<const double>, std::span<double> state) const override {
    state[0] = motion_.coordinate + motion_.rate * (t - motion_.t0);
    state[1] = motion_.rate;
  }
  double natural_time() const override { return natural_time_; }

 private:
  AxisMotion motion_;
  double natural_time_;
};

class RecurrentFlow final : public StateFlow {
 public:
  // shift: what a period adds to a state.
  RecurrentFlow(std::shared_ptr<const WindingFlow> flow, double period, double natural_time, std::vector<double> shift)
      : flow_(std::move(flow)), period_(period), natural_time_(natural_time), shift_(std::move(shift)) {}

  void advance(double from, std::span<const double> start, double to, std::span<double> state) const override {
    std::vector<double> here(start.begin(), start.end());
    const double periods = std::trunc((to - from) / period_);
    double t = from;
    if (periods != 0) {
      t += periods * period_;
      std::vector<double> before = here;
      for (std::size_t k = 0; k < before.size(); ++k) before[k] += periods * shift_[k];
      flow_->nearest(t, before, here);
    }
    follow(*flow_, natural_time_, t, to, here);
    std::ranges::copy(here, state.begin());
  }
  double natural_time() const override { return natural_time_; }

  // In parts no longer than natural_time.
  static void follow(const WindingFlow& flow, double natural_time, double from, double to, std::vector<double>& state) {
    std::vector<double> next(state.size());
    const double parts = std::max(1.0, std::ceil(std::abs(to - from) / natural_time));
    double t = from;
    bool arrives = false;
    for (std::uint64_t part = 1; !arrives; ++part) {
      arrives = static_cast<double>(part) >= parts;
      const double end = arrives ? to : from + (to - from) * (static_cast<double>(part) / parts);
      flow.advance(t, state, end, next);
      state.swap(next);
      t = end;
    }
  }

 private:
  std::shared_ptr<const WindingFlow> flow_;
  double period_, natural_time_;
  std::vector<double> shift_;
};

class KnownMethod final : public StepMethod {
 public:
  KnownMethod(std::shared_ptr<const StateFlow> flow, double step) : flow_(std::move(flow)), step_(step) {}

  StepOutcome begin(double t, std::span<const double> y, double) override {
    t_ = first_ = start_ = t;
    y_.assign(y.begin(), y.end());
    y_start_ = y_;
    return StepOutcome::advanced;
  }
  StepOutcome advance(double limit) override {
    const double left = limit - t_;
    double next = limit;
    if (std::fabs(left) > step_ * (1 + 1e-9)) {
      next = first_ + std::copysign(step_ * static_cast<double>(++done_), left);
      if (std::fabs(limit - next) < 1e-9 * step_) next = limit;
    }
    if (next == t_) return StepOutcome::too_small;
    start_ = t_;
    y_start_ = y_;
    t_ = next;
    flow_->advance(start_, y_start_, t_, y_);
    return std::ranges::all_of(y_, [](double x) { return std::isfinite(x); }) ? StepOutcome::advanced
                                                                              : StepOutcome::not_finite;
  }
  double time() const override { return t_; }
  std::span<double> state() override { return y_; }
  void state_changed(bool) override {}
  bool minds_itself() const override { return true; }
  StepView last_step() override { return {start_, t_ - start_, t_, StepForm::flow, y_start_, flow_.get()}; }
  std::int64_t rejected() const override { return 0; }
  std::shared_ptr<const StateFlow> flow() const override { return flow_; }

 private:
  std::shared_ptr<const StateFlow> flow_;
  double step_;
  double t_ = 0, first_ = 0, start_ = 0;
  std::int64_t done_ = 0;
  std::vector<double> y_, y_start_;
};

}  // namespace

std::shared_ptr<const RotationFlow> uniform_rotation(double t0, const BodyPose& pose) {
  return std::make_shared<UniformRotation>(t0, pose);
}
std::shared_ptr<const RotationFlow> torque_free_rotation(double t0, const BodyPose& pose,
                                                         const SymmetricMatrix3<double>& inertia) {
  return std::make_shared<TorqueFreeRotation>(t0, pose, inertia);
}
std::shared_ptr<const RotationFlow> top_rotation(double t0, const BodyPose& pose, const TopParameters& parameters,
                                                 const Vector3<double>& axis, const Vector3<double>& up) {
  return std::make_shared<TopRotation>(t0, pose, parameters, axis, up);
}

BodyFlow::BodyFlow(std::shared_ptr<const BodyCoordinates> coordinates, std::shared_ptr<const RotationFlow> rotation,
                   double t0, const BodyPose& pose, const Vector3<double>& gravity)
    : coordinates_(std::move(coordinates)),
      rotation_(std::move(rotation)),
      t0_(t0),
      center_(pose.center),
      velocity_(pose.center_velocity),
      gravity_(gravity) {}

void BodyFlow::advance(double from, std::span<const double> start, double to, std::span<double> state) const {
  if (to == from) {
    std::copy(start.begin(), start.end(), state.begin());
    return;
  }
  reach(from, start, to, state, 0);
}

void BodyFlow::nearest(double t, std::span<const double> before, std::span<double> state) const {
  BodyPose pose;
  rotation_->advance(t, pose, t, pose);
  place(pose, t, before, state);
}

void BodyFlow::place(const BodyPose& rotated, double at, std::span<const double> before,
                     std::span<double> state) const {
  BodyPose pose = rotated;
  const double t = at - t0_;
  pose.center = center_ + t * velocity_ + (0.5 * t * t) * gravity_;
  pose.center_velocity = velocity_ + t * gravity_;
  coordinates_->write(pose, before, state);
}

// Angles are continued in parts so short that they change by less than a radian: near the pole of Eulerian angles two
// of them turn fast, and where the axis passes through it they jump.
void BodyFlow::reach(double from, std::span<const double> start, double to, std::span<double> state, int depth) const {
  BodyPose pose;
  rotation_->advance(from, coordinates_->read(start), to, pose);
  place(pose, to, start, state);
  constexpr int deepest = 30;  // halvings, by which an axis goes by the pole within a billionth of the time
  if (!coordinates_->winds() || coordinates_->turned(start, state) <= 1 || depth == deepest) return;
  const std::vector<double> first(start.begin(), start.end());
  std::vector<double> middle(state.size());
  const double half = from + 0.5 * (to - from);
  reach(from, first, half, middle, depth + 1);
  reach(half, middle, to, state, depth + 1);
}

AxisFlows axis_flow(const AxisMotion& motion) {
  const double fastest = std::hypot(motion.rate, 2 * std::sqrt(motion.weight_moment / motion.moment));
  const double natural_time = 0.5 / fastest;
  if (motion.weight_moment == 0) return {std::make_shared<UniformAxisFlow>(motion, natural_time), {}};
  const auto flow = std::make_shared<AxisFlow>(motion, natural_time);
  return {flow, flow->periods()};
}

std::shared_ptr<const StateFlow> recurrent_flow(const std::shared_ptr<const WindingFlow>& flow,
                                                std::span<const double> periods, double natural_time, double start,
                                                std::span<const double> q, std::span<const double> v,
                                                std::span<const double> sizes) {
  // What two periods add may differ by this part of the size of a coordinate: the most parts of a period bring some
  // 1e-12 of rounding, and what differs by ten times more would be seen in eight digits after a single period.
  constexpr double most_parts = 1e4, agreement = 1e-8;
  const double largest = sizes.empty() ? 1 : *std::ranges::max_element(sizes);
  std::vector<double> first(q.begin(), q.end());
  first.insert(first.end(), v.begin(), v.end());
  for (const double period : periods) {
    if (!(period > 0 && period < most_parts * natural_time)) continue;
    // What a period adds, found at one phase of the motion, must be so at another, and be nothing to the rates.
    std::vector<double> state = first;
    std::vector<std::vector<double>> added;
    double t = start;
    for (const double wait : {0.0, 0.37 * period}) {
      RecurrentFlow::follow(*flow, natural_time, t, t + wait, state);
      t += wait;
      const std::vector<double> before = state;
      RecurrentFlow::follow(*flow, natural_time, t, t + period, state);
      t += period;
      std::vector<double>& shift = added.emplace_back(state.size());
      for (std::size_t k = 0; k < state.size(); ++k) shift[k] = state[k] - before[k];
    }
    bool recurs = true;
    for (std::size_t k = 0; k < first.size(); ++k) {
      const bool rate = k >= q.size();
      const std::size_t own = rate ? k - q.size() : k;
      const double unit = own < sizes.size() && q.size() == v.size() ? sizes[own] : largest;
      const double size = rate ? unit / natural_time : unit + std::abs(added[0][k]);
      recurs = recurs && std::abs(added[0][k] - added[1][k]) <= agreement * size &&
               (!rate || std::abs(added[0][k]) <= agreement * size);
      if (rate) added[0][k] = 0;
    }
    if (recurs) return std::make_shared<RecurrentFlow>(flow, period, natural_time, added[0]);
  }
  return nullptr;
}

std::unique_ptr<StepMethod> make_known_method(std::shared_ptr<const StateFlow> flow, double step) {
  return std::make_unique<KnownMethod>(std::move(flow), step);
}

}  // namespace poinsot
