#include <array>
#include <cmath>
#include <limits>

#include "engine/motion/closed_form/known_motion.h"
#include "engine/motion/rotation/rotation_method.h"

namespace poinsot {

namespace {

using Numbers = std::array<double, 7>;

// The rotation that the steps of the collocation give.
class CollocatedRotation final : public RotationFlow {
 public:
  explicit CollocatedRotation(std::shared_ptr<const StateFlow> flow) : flow_(std::move(flow)) {}
  void advance(double t0, const BodyPose& from, double t, BodyPose& pose) const override {
    const Numbers y = numbers_of(from);
    Numbers there{};
    flow_->advance(t0, y, t, there);
    pose = pose_of(there);
  }
  double natural_time() const override { return std::numeric_limits<double>::infinity(); }

  static Numbers numbers_of(const BodyPose& pose) {
    const Quaternion<double>& a = pose.attitude;
    const Vector3<double>& w = pose.angular_velocity;
    return {a.w, a.x, a.y, a.z, w.x, w.y, w.z};
  }
  static BodyPose pose_of(std::span<const double> y) {
    BodyPose pose;
    pose.attitude = {y[0], y[1], y[2], y[3]};
    pose.angular_velocity = {y[4], y[5], y[6]};
    return pose;
  }

 private:
  std::shared_ptr<const StateFlow> flow_;
};

class BodyMethod final : public StepMethod {
 public:
  BodyMethod(std::shared_ptr<const BodyCoordinates> coordinates, const RotatingBody& body,
             const IntegrationOptions& options)
      : coordinates_(std::move(coordinates)),
        inner_(make_rotation_collocation(std::make_shared<Rotor>(body), options)),
        flow_(std::make_shared<BodyFlow>(coordinates_, std::make_shared<CollocatedRotation>(inner_->flow()), 0.0,
                                         BodyPose{}, Vector3<double>::zero())) {}

  StepOutcome begin(double t, std::span<const double> y, double limit) override {
    y_.assign(y.begin(), y.end());
    y_start_ = y_;
    start_ = t;
    return inner_->begin(t, CollocatedRotation::numbers_of(coordinates_->read(y)), limit);
  }
  StepOutcome advance(double limit) override {
    y_start_ = y_;
    start_ = inner_->time();
    const std::span<const double> here = inner_->state();
    const double radian = 1 / std::sqrt(here[4] * here[4] + here[5] * here[5] + here[6] * here[6]);
    const double left = limit - start_;
    const StepOutcome outcome =
        inner_->advance(std::fabs(left) > radian ? start_ + std::copysign(radian, left) : limit);
    if (outcome != StepOutcome::advanced) return outcome;
    coordinates_->write(CollocatedRotation::pose_of(inner_->state()), y_start_, y_);
    if (coordinates_->turned(y_start_, y_) > 1) flow_->advance(start_, y_start_, inner_->time(), y_);
    return outcome;
  }
  double time() const override { return inner_->time(); }
  std::span<double> state() override { return y_; }
  void state_changed(bool) override {}
  bool minds_itself() const override { return true; }
  StepView last_step() override {
    return {start_, inner_->time() - start_, inner_->time(), StepForm::flow, y_start_, flow_.get()};
  }
  std::int64_t rejected() const override { return inner_->rejected(); }
  std::int64_t evaluations() const override { return inner_->evaluations(); }
  std::shared_ptr<const StateFlow> flow() const override { return flow_; }

 private:
  std::shared_ptr<const BodyCoordinates> coordinates_;
  std::unique_ptr<StepMethod> inner_;
  std::shared_ptr<const BodyFlow> flow_;
  double start_ = 0;
  std::vector<double> y_, y_start_;
};

}  // namespace

std::unique_ptr<StepMethod> make_body_method(std::shared_ptr<const BodyCoordinates> coordinates,
                                             const RotatingBody& body, const IntegrationOptions& options) {
  return std::make_unique<BodyMethod>(std::move(coordinates), body, options);
}

}  // namespace poinsot
