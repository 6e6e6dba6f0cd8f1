#include "engine/motion/closed_form/body_coordinates.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "poinsot/engine/math/algebra/rotation.h"

namespace poinsot {
namespace {

using Vector = Vector3<double>;

Vector vector_at(std::span<const double> state, std::size_t k) { return {state[k], state[k + 1], state[k + 2]}; }
Quaternion<double> quaternion_at(std::span<const double> state, std::size_t k) {
  return {state[k], state[k + 1], state[k + 2], state[k + 3]};
}
void put(std::span<double> state, std::size_t k, const Vector& x) {
  state[k] = x.x;
  state[k + 1] = x.y;
  state[k + 2] = x.z;
}
void put_nearer(std::span<double> state, std::span<const double> before, std::size_t k, const Quaternion<double>& a) {
  const double same = a.w * before[k] + a.x * before[k + 1] + a.y * before[k + 2] + a.z * before[k + 3];
  const double sign = same < 0 ? -1 : 1;
  state[k] = sign * a.w;
  state[k + 1] = sign * a.x;
  state[k + 2] = sign * a.y;
  state[k + 3] = sign * a.z;
}

class BallCoordinates final : public BodyCoordinates {
 public:
  BallCoordinates(const Matrix3<double>& joint_axes, std::size_t q, std::size_t v)
      : frame_(quaternion_of(joint_axes)), q_(q), v_(v) {}

  BodyPose read(std::span<const double> state) const override {
    BodyPose pose;
    pose.attitude = frame_ * quaternion_at(state, q_);
    pose.angular_velocity = vector_at(state, v_);
    return pose;
  }
  void write(const BodyPose& pose, std::span<const double> before, std::span<double> state) const override {
    put_nearer(state, before, q_, conjugate(frame_) * pose.attitude);
    put(state, v_, pose.angular_velocity);
  }

 private:
  Quaternion<double> frame_;
  std::size_t q_, v_;
};

class FreeCoordinates final : public BodyCoordinates {
 public:
  FreeCoordinates(const SpatialTransform<double>& frame, const Vector& center, std::size_t q, std::size_t v)
      : frame_(frame), turn_(quaternion_of(frame.R)), center_(center), q_(q), v_(v) {}

  BodyPose read(std::span<const double> state) const override {
    BodyPose pose;
    pose.attitude = turn_ * quaternion_at(state, q_);
    pose.angular_velocity = vector_at(state, v_);
    const Matrix3<double> R = rotation_matrix(pose.attitude);
    pose.center = frame_ * vector_at(state, q_ + 4) + R * center_;
    pose.center_velocity = R * (vector_at(state, v_ + 3) + cross(pose.angular_velocity, center_));
    return pose;
  }
  void write(const BodyPose& pose, std::span<const double> before, std::span<double> state) const override {
    const Matrix3<double> R = rotation_matrix(pose.attitude);
    put_nearer(state, before, q_, conjugate(turn_) * pose.attitude);
    put(state, q_ + 4, transpose_times(frame_.R, pose.center - R * center_ - frame_.p));
    put(state, v_, pose.angular_velocity);
    put(state, v_ + 3, transpose_times(R, pose.center_velocity) - cross(pose.angular_velocity, center_));
  }

 private:
  SpatialTransform<double> frame_;
  Quaternion<double> turn_;
  Vector center_;
  std::size_t q_, v_;
};

double angle_about(const Vector& axis, const Vector& from, const Vector& to) {
  return std::atan2(dot(to, cross(axis, from)), dot(to, from));
}
double nearest_turn(double angle, double before) {
  constexpr double turn = 2 * std::numbers::pi;
  return angle + turn * std::nearbyint((before - angle) / turn);
}

class AngleCoordinates final : public BodyCoordinates {
 public:
  AngleCoordinates(const AxesAtZero& zero, std::span<const std::size_t> q, std::span<const std::size_t> v)
      : axes_(zero.axes),
        attitude_(quaternion_of(zero.attitude)),
        second_in_body_(transpose_times(zero.attitude, zero.axes[1])),
        third_in_body_(transpose_times(zero.attitude, zero.axes[2])),
        apart_(angle_about(zero.axes[1], zero.axes[0], zero.axes[2])),
        q_(q.begin(), q.end()),
        v_(v.begin(), v.end()) {}

  BodyPose read(std::span<const double> state) const override {
    const Matrix3<double> first = rotation_about(axes_[0], state[q_[0]]);
    const Matrix3<double> second = first * rotation_about(axes_[1], state[q_[1]]);
    Vector w = state[v_[0]] * axes_[0] + state[v_[1]] * (first * axes_[1]);
    BodyPose pose;
    Matrix3<double> turn = second;
    if (q_.size() == 3) {
      turn = second * rotation_about(axes_[2], state[q_[2]]);
      w += state[v_[2]] * (second * axes_[2]);
    }
    pose.attitude = quaternion_of(turn) * attitude_;
    pose.angular_velocity = transpose_times(rotation_matrix(pose.attitude), w);
    return pose;
  }

  // The second axis is perpendicular to the first and the third one: their product, of either sense. Where they are
  // parallel the first angle stays what it was.
  void write(const BodyPose& pose, std::span<const double> before, std::span<double> state) const override {
    const Matrix3<double> R = rotation_matrix(pose.attitude);
    const Vector third = R * third_in_body_;
    const Vector n = cross(axes_[0], third);
    const double sine = norm(n), cosine = dot(axes_[0], third);
    const Vector w = R * pose.angular_velocity;
    if (sine < parallel) {
      const double first = before[q_[0]];
      const Vector second = rotation_about(axes_[0], first) * axes_[1];
      put_angles(state, before, {first, (cosine > 0 ? 0 : std::numbers::pi) - apart_, third_angle(R, second)});
      state[v_[0]] = 0;
      state[v_[1]] = dot(w, second);
      if (q_.size() == 3) state[v_[2]] = std::copysign(1.0, cosine) * dot(w, axes_[0]);
      return;
    }
    double least = INFINITY;
    for (const double sign : {1.0, -1.0}) {
      const Vector second = (sign / sine) * n;
      std::array<double, 3> angles{angle_about(axes_[0], axes_[1], second), std::atan2(sign * sine, cosine) - apart_,
                                   third_angle(R, second)};
      double far = 0;
      for (std::size_t k = 0; k < q_.size(); ++k) {
        angles[k] = nearest_turn(angles[k], before[q_[k]]);
        far = std::max(far, std::abs(angles[k] - before[q_[k]]));
      }
      if (far >= least) continue;
      least = far;
      for (std::size_t k = 0; k < q_.size(); ++k) state[q_[k]] = angles[k];
      state[v_[0]] = -sign * dot(w, cross(second, third)) / sine;
      state[v_[1]] = dot(w, second);
      if (q_.size() == 3) state[v_[2]] = sign * dot(w, cross(second, axes_[0])) / sine;
    }
  }

  // Infinite where the second angle passes the pole: just beside it the others turn fast instead.
  double turned(std::span<const double> before, std::span<const double> state) const override {
    if (std::sin(before[q_[1]] + apart_) * std::sin(state[q_[1]] + apart_) < 0) return INFINITY;
    double largest = 0;
    for (const std::size_t k : q_) largest = std::max(largest, std::abs(state[k] - before[k]));
    return largest;
  }
  bool winds() const override { return true; }

 private:
  static constexpr double parallel = 1e-14;  // the sine between axes that are the same but for rounding

  // From where the second axis stands in the body with the third angle zero.
  double third_angle(const Matrix3<double>& R, const Vector& second) const {
    return -angle_about(third_in_body_, second_in_body_, transpose_times(R, second));
  }
  void put_angles(std::span<double> state, std::span<const double> before, const std::array<double, 3>& angles) const {
    for (std::size_t k = 0; k < q_.size(); ++k) state[q_[k]] = nearest_turn(angles[k], before[q_[k]]);
  }

  std::array<Vector, 3> axes_;
  Quaternion<double> attitude_;
  Vector second_in_body_, third_in_body_;
  double apart_;  // from the first axis to the third, about the second, with all angles zero
  std::vector<std::size_t> q_, v_;
};

}  // namespace

std::unique_ptr<BodyCoordinates> ball_coordinates(const Matrix3<double>& joint_axes, std::size_t q, std::size_t v) {
  return std::make_unique<BallCoordinates>(joint_axes, q, v);
}
std::unique_ptr<BodyCoordinates> free_coordinates(const SpatialTransform<double>& frame, const Vector3<double>& center,
                                                  std::size_t q, std::size_t v) {
  return std::make_unique<FreeCoordinates>(frame, center, q, v);
}
std::unique_ptr<BodyCoordinates> angle_coordinates(const AxesAtZero& zero, std::span<const std::size_t> q,
                                                   std::span<const std::size_t> v) {
  return std::make_unique<AngleCoordinates>(zero, q, v);
}

}  // namespace poinsot
