// In a steady motion everything is turned by R about the axis of the frame, and shifted along it, after a while. A load
// that follows from the motion must then be R times what it was, and near by as well: it is looked at for parts of the
// motion that are off by some random amount, before and after.
#include "poinsot/engine/solve/stability/steady_loads.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "poinsot/engine/dynamics/kinematics.h"
#include "poinsot/engine/math/algebra/rotation.h"

namespace poinsot::solve {
namespace {

// Of its size: what counts as no spin, and as no change. Velocities come from a solved instant.
constexpr double no_change = 1e-9;

class SteadyLoads {
 public:
  using Vector = Vector3<double>;
  using Matrix = Matrix3<double>;

  SteadyLoads(const SteadyMotion& motion, double pace)
      : motion_(motion), tree_(motion.mechanism->tree), w_(tree_), pace_(pace > 0 ? pace : 1) {
    update_velocities<double>(tree_, w_, State<double>{motion.q, motion.v});
    const double turning = norm(motion.turning);
    if (turning > 0) later_ = rotation_about<double>(motion.turning / turning, 1.0);
    delay_ = 1 / (turning > 0 ? turning : pace_);
  }

  bool stays(const KnownForce<double>& force) const {
    const MotionExpression<double>& load = *force.by_motion;
    if (spins(load.axes) || (!force.couple && !rests_in_spin(force.at))) return false;
    for (const MotionPart<double>& part : load.parts)
      if (!stays(part)) return false;
    std::mt19937_64 random(7);
    for (int look = 0; look < 4; ++look) {
      std::vector<Vector> now, then;
      for (const MotionPart<double>& part : load.parts) {
        const Vector value = on_ground(part), off = shaken(part, random);
        now.push_back(value + off);
        then.push_back(is_number(part) || on_the_ground(part) ? value + off : after(part, value) + later_ * off);
      }
      const Matrix axes = body_rotation(tree_, w_, load.axes);
      const Vector before = value_of(load, now, axes);
      const Vector behind = value_of(load, then, load.axes == ground ? axes : Matrix(later_ * axes));
      if (!(norm(behind - later_ * before) <= no_change * (norm(before) + norm(behind)))) return false;
    }
    return true;
  }

  // A corner bends the load by as much in however small a step; what is smooth bends less and less.
  bool is_smooth(const KnownForce<double>& force) const {
    constexpr double far = 1e-4, near = 1e-6;  // of natural sizes
    constexpr double rounding = 1e-7;          // of the load at natural sizes, over the smaller step
    const MotionExpression<double>& load = *force.by_motion;
    const Matrix axes = body_rotation(tree_, w_, load.axes);
    std::mt19937_64 random(11);
    for (int look = 0; look < 8; ++look) {
      std::vector<Vector> here, off;
      for (const MotionPart<double>& part : load.parts) {
        here.push_back(on_ground(part));
        off.push_back(is_number(part) ? natural_size(part) * Vector{draw(random), 0, 0} : shaken(part, random));
      }
      const auto moved = [&](double by) {
        std::vector<Vector> parts = here;
        for (std::size_t i = 0; i < parts.size(); ++i) parts[i] = here[i] + by * off[i];
        return value_of(load, parts, axes);
      };
      const Vector middle = moved(0);
      const auto bend = [&](double by) { return norm(moved(by) + moved(-by) - 2.0 * middle) / by; };
      const double size = norm(middle) + norm(moved(1)) + norm(moved(-1));
      if (!(bend(near) <= 0.1 * bend(far) + rounding * size)) return false;
    }
    return true;
  }

 private:
  static bool is_number(const MotionPart<double>& part) {
    return part.kind == MotionPartKind::coordinate || part.kind == MotionPartKind::rate;
  }
  static bool on_the_ground(const MotionPart<double>& part) {
    return part.at.body == ground && part.seen_from == ground;
  }
  bool spins(int body) const {
    return body != ground && norm(angular_velocity(w_, body) - motion_.turning) > no_change * pace_;
  }
  // Whether a place on a body stays where it is in the frame.
  bool rests_in_spin(const Place<double>& place) const {
    if (!spins(place.body)) return true;
    const SpatialInertia<double>& I = tree_.body(place.body).inertia;
    const Vector center = I.mass > 0 ? I.first_moment / I.mass : Vector::zero();
    const Vector arm = direction_on_ground(tree_, w_, place.body, place.point - center);
    return parallel(arm, angular_velocity(w_, place.body) - motion_.turning, motion_.length);
  }
  static bool parallel(const Vector& a, const Vector& spin, double size) {
    return norm(cross(a, spin)) <= no_change * size * norm(spin);
  }
  bool stays(const MotionPart<double>& part) const {
    if (part.seen_from != ground && spins(part.seen_from)) return false;
    switch (part.kind) {
      case MotionPartKind::coordinate:
        return !(std::abs(rate_of_position(part.coordinate)) > no_change * pace_ * motion_.length);
      case MotionPartKind::rate:
      case MotionPartKind::angular_velocity:
        return true;
      case MotionPartKind::direction:
        return !spins(part.at.body) ||
               parallel(direction_on_ground(tree_, w_, part.at.body, part.at.point),
                        angular_velocity(w_, part.at.body) - motion_.turning, norm(part.at.point));
      case MotionPartKind::position:
      case MotionPartKind::velocity:
        break;
    }
    return rests_in_spin(part.at);
  }
  double rate_of_position(int position) const {
    for (const auto& body : tree_.bodies())
      if (position_size(body.joint) == 1 && body.q == position) return motion_.v[static_cast<std::size_t>(body.v)];
    return 0;
  }

  Vector on_ground(const MotionPart<double>& part) const {
    MotionExpression<double> alone;
    alone.parts = {part};
    for (int k = 0; k < 3; ++k) {
      alone.steps.push_back({MotionOperation::part, 0, k});
      alone.results[static_cast<std::size_t>(k)] = k;
    }
    return alone.value(tree_, w_);
  }
  // A part of the motion after the delay.
  Vector after(const MotionPart<double>& part, const Vector& value) const {
    if (part.kind != MotionPartKind::position) return later_ * value;
    const Vector v = point_velocity(tree_, w_, part.at.body, part.at.point), W = motion_.turning;
    const double turning = norm_squared(W);
    if (turning == 0) return value + delay_ * v;
    const Vector middle = value + cross(W, v) / turning;
    return middle + later_ * (value - middle) + delay_ * (dot(v, W) / turning) * W;
  }
  Vector shaken(const MotionPart<double>& part, std::mt19937_64& random) const {
    if (is_number(part) || part.kind == MotionPartKind::direction || on_the_ground(part)) return Vector::zero();
    return 0.1 * natural_size(part) * Vector{draw(random), draw(random), draw(random)};
  }
  static double draw(std::mt19937_64& random) { return std::uniform_real_distribution<double>(-1, 1)(random); }
  double natural_size(const MotionPart<double>& part) const {
    switch (part.kind) {
      case MotionPartKind::position:
      case MotionPartKind::coordinate:
        return motion_.length;
      case MotionPartKind::velocity:
      case MotionPartKind::rate:
        return motion_.length * pace_;
      case MotionPartKind::angular_velocity:
        return pace_;
      case MotionPartKind::direction:
        break;
    }
    return 1;
  }
  static Vector value_of(const MotionExpression<double>& load, const std::vector<Vector>& parts, const Matrix& axes) {
    std::vector<Vector> own;
    for (std::size_t i = 0; i < parts.size(); ++i)
      own.push_back(is_number(load.parts[i]) ? parts[i] : transpose_times(axes, parts[i]));
    const auto found = detail::run_motion_steps<double>(
        load.steps, load.results,
        [&](int i, int k) { return own[static_cast<std::size_t>(i)][static_cast<std::size_t>(k)]; },
        [&](int i) { return load.constants[static_cast<std::size_t>(i)]; });
    return axes * Vector{found[0], found[1], found[2]};
  }

  const SteadyMotion& motion_;
  const Model<double>& tree_;
  Workspace<double> w_;
  double pace_, delay_ = 0;
  Matrix later_ = Matrix::identity();
};

}  // namespace

std::optional<UnsteadyLoad> unsteady_load(const SteadyMotion& motion, double pace) {
  const SteadyLoads loads(motion, pace);
  const auto& forces = motion.mechanism->forces;
  for (std::size_t i = 0; i < forces.size(); ++i) {
    if (!forces[i].by_motion) continue;
    if (!loads.stays(forces[i])) return UnsteadyLoad{i, false};
    if (!loads.is_smooth(forces[i])) return UnsteadyLoad{i, true};
  }
  return std::nullopt;
}

}  // namespace poinsot::solve
