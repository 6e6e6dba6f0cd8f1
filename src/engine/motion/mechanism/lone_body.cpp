#include "poinsot/engine/motion/mechanism/lone_body.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "engine/motion/closed_form/known_motion.h"
#include "engine/motion/integrator/methods.h"
#include "engine/motion/rotation/rotation_method.h"
#include "poinsot/engine/mass/principal_axes.h"
#include "poinsot/engine/math/algebra/rotation.h"
#include "poinsot/engine/motion/rotation/rotation.h"

namespace poinsot {
namespace {

using Vector = Vector3<double>;
using Tensor = SymmetricMatrix3<double>;

// Of moments of inertia, lengths and directions: what counts as nothing or as the same, fifty units in the last place.
// A body that is off by more has a motion that is off by as much after one turn, and the closed form would not show it.
constexpr double rounding = 1e-14;

// Never negative, as that of a particle about itself may become by rounding.
double largest_moment(const Tensor& I) { return std::max(0.0, I.xx + I.yy + I.zz); }

// Bodies without inertia about an axis: the angular velocity across it is constant without torque.
bool lacks_a_moment(const Tensor& I) {
  const Vector least = principal_axes(I).moments;
  return !(least.x > rounding * least.z);
}

// The line of a body that it turns about beside the turning that moves it, as a rod about its own: a unit vector.
std::optional<Vector> massless_line(const Tensor& I, const Vector& w) {
  const PrincipalAxes<double> principal = principal_axes(I);
  const Vector& moments = principal.moments;
  const bool turns = moments.y > 0 && !(moments.x > rounding * moments.z) &&
                     std::abs(dot(principal.axes.column(0), w)) > rounding * norm(w);
  return turns ? std::optional(principal.axes.column(0)) : std::nullopt;
}

bool loads_act(const Mechanism<double>& mechanism) {
  if (!mechanism.constraints.empty()) return true;
  bool acts = std::any_of(mechanism.drives.begin(), mechanism.drives.end(), [](const Drive<double>& drive) {
    return drive.held || drive.feeds() || drive.stores() || drive.drains();
  });
  for_each_law(mechanism, [&](const auto&) { acts = true; });
  return acts;
}

// A joint that is no weld, with the bodies welded to its body.
struct Link {
  const Body<double>* body = nullptr;
  SpatialTransform<double> frame{};  // of its joint in the ground, all joints in their neutral position
  SpatialInertia<double> inertia = SpatialInertia<double>::zero();  // of all welded together, working axes
};

// From the ground outward; none if the tree branches, or if any but the last has inertia.
std::optional<std::vector<Link>> chain_of(const Model<double>& tree) {
  std::vector<Link> chain;
  std::vector<int> link_of;                       // of each body; -1: welded to the ground
  std::vector<SpatialTransform<double>> in_link;  // each body's working frame in that of its link
  for (const Body<double>& body : tree.bodies()) {
    const int parent_link = body.parent == ground ? -1 : link_of[static_cast<std::size_t>(body.parent)];
    const SpatialTransform<double> in_parent =
        (body.parent == ground ? SpatialTransform<double>::identity()
                               : in_link[static_cast<std::size_t>(body.parent)]) *
        body.placement;
    if (body.joint == JointType::weld) {
      link_of.push_back(parent_link);
      in_link.push_back(in_parent);
      if (parent_link >= 0) chain[static_cast<std::size_t>(parent_link)].inertia += in_parent * body.inertia;
      continue;
    }
    if (parent_link + 1 != static_cast<int>(chain.size())) return std::nullopt;
    Link link;
    link.body = &body;
    link.frame = parent_link < 0 ? in_parent : chain.back().frame * in_parent;
    link.inertia = body.inertia;
    chain.push_back(link);
    link_of.push_back(parent_link + 1);
    in_link.push_back(SpatialTransform<double>::identity());
  }
  for (std::size_t k = 0; k + 1 < chain.size(); ++k)
    if (chain[k].inertia.mass != 0 || largest_moment(chain[k].inertia.inertia) != 0) return std::nullopt;
  if (chain.empty() || !(chain.back().inertia.mass > 0)) return std::nullopt;
  return chain;
}

// Where the axes of the chain, with all angles zero, meet; none if they do not.
std::optional<Vector> meeting_point(const std::vector<Link>& chain, double length) {
  const auto axis = [&](std::size_t k) { return chain[k].frame.R.column(2); };
  const auto through = [&](std::size_t k, const Vector& point) {
    return norm(cross(axis(k), point - chain[k].frame.p)) <= rounding * length;
  };
  // The axes are perpendicular to those before: nearest points of two of them.
  const Vector apart = chain[0].frame.p - chain[1].frame.p;
  const Vector point = chain[1].frame.p + dot(apart, axis(1)) * axis(1);
  for (std::size_t k = 0; k < chain.size(); ++k)
    if (!through(k, point)) return std::nullopt;
  return point;
}

}  // namespace

std::optional<LoneBody> LoneBody::find(const Mechanism<double>& mechanism, std::span<const int> held) {
  if (loads_act(mechanism)) return std::nullopt;
  const Model<double>& tree = mechanism.tree;
  const std::optional<std::vector<Link>> chain = chain_of(tree);
  if (!chain) return std::nullopt;
  const Link& last = chain->back();
  const auto is_revolute = [](const Link& link) { return link.body->joint == JointType::revolute; };
  const bool angles = std::all_of(chain->begin(), chain->end(), is_revolute);
  const bool turns = last.body->joint == JointType::ball || last.body->joint == JointType::free;
  if (!(angles && chain->size() <= 3) && !(turns && chain->size() == 1)) return std::nullopt;

  LoneBody lone;
  lone.mass_ = last.inertia.mass;
  lone.gravity_ = tree.gravity();
  const Vector center = last.inertia.first_moment / last.inertia.mass;
  const Tensor at_center = shifted(last.inertia, -center).inertia;
  const auto velocity_place = [&](const Link& link) {
    return static_cast<std::size_t>(tree.position_size() + link.body->v);
  };
  const auto position_place = [](const Link& link) { return static_cast<std::size_t>(link.body->q); };
  const auto about_point = [&](const Vector& point) {
    lone.arm_ = center - point;
    lone.inertia_ = shifted(last.inertia, -point).inertia;
    // A mass center on the point but for rounding.
    const double length = std::sqrt(largest_moment(lone.inertia_) / lone.mass_) + norm(point);
    if (norm(lone.arm_) <= rounding * length) lone.arm_ = Vector::zero();
  };

  if (!held.empty()) {
    const Tensor& I = last.body->joint == JointType::free ? at_center : last.inertia.inertia;
    const bool turnings = std::all_of(held.begin(), held.end(), [&](int coordinate) {
      return coordinate >= last.body->v && coordinate < last.body->v + 3;
    });
    if (!turns || !turnings || !lacks_a_moment(I)) return std::nullopt;
  }
  if (last.body->joint == JointType::free) {
    lone.freedom_ = Freedom::free;
    lone.inertia_ = at_center;
    lone.coordinates_ = free_coordinates(last.frame, center, position_place(last), velocity_place(last));
    return lone;
  }
  lone.freedom_ = Freedom::point;
  if (last.body->joint == JointType::ball) {
    about_point(Vector::zero());
    lone.coordinates_ = ball_coordinates(last.frame.R, position_place(last), velocity_place(last));
    return lone;
  }
  if (chain->size() == 1) {
    lone.freedom_ = Freedom::axis;
    lone.axis_ = last.frame.R.column(2);
    lone.attitude_ = last.frame.R;
    lone.arm_ = {center.x, center.y, 0};
    lone.axial_moment_ = last.inertia.inertia.zz;
    return lone;
  }

  std::array<Vector, 3> axes;
  for (std::size_t k = 0; k < chain->size(); ++k) axes[k] = (*chain)[k].frame.R.column(2);
  const auto perpendicular = [](const Vector& a, const Vector& b) { return std::abs(dot(a, b)) <= rounding * norm(b); };
  const double length =
      norm(center) + norm(last.frame.p - chain->front().frame.p) + std::sqrt(largest_moment(at_center) / lone.mass_);
  const std::optional<Vector> point = meeting_point(*chain, length);
  if (!point || !perpendicular(axes[0], axes[1])) return std::nullopt;
  about_point(transpose_times(last.frame.R, *point - last.frame.p));
  lone.spins_ = chain->size() == 3;
  if (!lone.spins_) {
    // Two angles describe what has no inertia about its arm.
    const double arm = norm(lone.arm_);
    if (!(arm > 0)) return std::nullopt;
    if (norm(lone.inertia_ * lone.arm_) > rounding * largest_moment(lone.inertia_) * arm) return std::nullopt;
    axes[2] = last.frame.R * (lone.arm_ / arm);
  }
  if (!perpendicular(axes[1], axes[2])) return std::nullopt;
  std::vector<std::size_t> q, v;
  for (const Link& link : *chain) {
    q.push_back(position_place(link));
    v.push_back(velocity_place(link));
  }
  lone.coordinates_ = angle_coordinates({axes, last.frame.R}, q, v);
  return lone;
}

namespace {

// The axis of symmetry through the fixed point and the mass center, and the moments about and across it; none for
// another body.
struct SymmetryAxis {
  Vector axis;
  double axial = 0, transverse = 0;
};
std::optional<SymmetryAxis> symmetry_about(const Vector& arm, const Tensor& I) {
  SymmetryAxis found;
  found.axis = normalized(arm);
  const Matrix3<double> R = axes_with_z_along(found.axis);
  const Tensor T = turned(transpose(R), I);
  const double off = std::max({std::abs(T.xy), std::abs(T.yz), std::abs(T.zx), 0.5 * std::abs(T.xx - T.yy)});
  if (!(off <= rounding * largest_moment(I))) return std::nullopt;
  found.transverse = 0.5 * (T.xx + T.yy);
  found.axial = T.zz > rounding * found.transverse ? T.zz : 0;
  if (!(found.transverse > 0)) return std::nullopt;
  return found;
}

// In space, of the angular momentum across the axis.
Vector momentum_axis(const SymmetryAxis& symmetry, const BodyPose& pose) {
  const Vector& w = pose.angular_velocity;
  const Vector across = w - dot(w, symmetry.axis) * symmetry.axis;
  return rotation_matrix(pose.attitude) * (norm(across) > 0 ? normalized(across) : symmetry.axis);
}

// Along a motion that is known at any time steps need not be short, unless events are looked for in each of them: only
// how often angles have gone round must be known.
struct KnownSteps {
  std::shared_ptr<const StateFlow> flow;
  double length = 0;  // s
};
KnownSteps known_steps(const std::shared_ptr<const WindingFlow>& flow, bool winds, std::span<const double> periods,
                       double largest, double start, std::span<const double> q, std::span<const double> v,
                       std::span<const double> sizes, double end, bool no_events) {
  constexpr double most = 1e5;  // steps: of some hundred bytes each, ten megabytes
  const double natural = flow->natural_time(), span = std::abs(end - start);
  KnownSteps steps{flow, std::min(natural, largest)};
  if (!no_events || span <= most * steps.length) return steps;
  if (winds) {
    std::shared_ptr<const StateFlow> recurrent = recurrent_flow(flow, periods, natural, start, q, v, sizes);
    if (!recurrent) return steps;
    steps.flow = std::move(recurrent);
  }
  steps.length = span / most;
  return steps;
}

// What LoneBody::follow is asked for.
struct Span {
  const MotionEquations& equations;
  double start;
  std::span<const double> q, v;
  double end;
  const IntegrationOptions& options;
  std::span<const Event> events;
};

// Along a motion in closed form, of which the words tell.
IntegrationResult followed(const std::shared_ptr<const WindingFlow>& flow, bool winds, std::span<const double> periods,
                           const Span& span, const std::string& words) {
  const double largest =
      span.options.largest_step > 0 ? span.options.largest_step : std::numeric_limits<double>::infinity();
  const KnownSteps steps = known_steps(flow, winds, periods, largest, span.start, span.q, span.v,
                                       span.equations.position_sizes, span.end, span.events.empty());
  const MethodMaker make = [&](IntegrationMethod, RightSide&, const ErrorScale&, const IntegrationOptions&) {
    return make_known_method(steps.flow, steps.length);
  };
  IntegrationOptions plain = span.options;
  plain.estimate_error = false;
  IntegrationResult result =
      integrate_by(make, span.equations, span.start, span.q, span.v, span.end, plain, span.events);
  result.method = words;
  result.closed_form = true;
  return result;
}

// Whether a flow is at its start where it should be.
bool starts_right(const RotationFlow& flow, double t0, const BodyPose& pose) {
  BodyPose found;
  flow.advance(t0, pose, t0, found);
  const Quaternion<double> apart = conjugate(pose.attitude) * found.attitude;
  constexpr double start_error = 1e-12;  // rad, and of the rate: elliptic functions and their inverses leave 1e-14
  return norm(vector_part(apart)) <= start_error && norm(found.angular_velocity - pose.angular_velocity) <=
                                                        start_error * std::max(norm(pose.angular_velocity), 1e-300);
}

}  // namespace

std::optional<IntegrationResult> LoneBody::follow(const MotionEquations& equations, double start,
                                                  std::span<const double> q, std::span<const double> v, double end,
                                                  const IntegrationOptions& options,
                                                  std::span<const Event> events) const {
  if (freedom_ == Freedom::axis) return follow_axis(equations, start, q, v, end, options, events);
  std::vector<double> state(q.begin(), q.end());
  state.insert(state.end(), v.begin(), v.end());
  BodyPose pose = coordinates_->read(state);
  pose.attitude = normalized(pose.attitude);
  const double g = norm(gravity_), arm = norm(arm_);
  const bool weight = freedom_ == Freedom::point && g > 0 && arm > 0;

  std::string method;
  std::shared_ptr<const RotationFlow> rotation;
  if (!weight) {
    const bool plain = norm(pose.angular_velocity) == 0 || lacks_a_moment(inertia_);
    method = plain ? (freedom_ == Freedom::free && g > 0 ? "closed form: free fall" : "closed form: uniform rotation")
                   : "closed form: torque-free motion";
    if (const auto line = massless_line(inertia_, pose.angular_velocity)) {
      const auto symmetry = symmetry_about(*line, inertia_);
      if (!symmetry) return std::nullopt;
      method = "closed form: torque-free motion";
      rotation = top_rotation(start, pose, {symmetry->transverse, symmetry->axial, 0}, symmetry->axis,
                              momentum_axis(*symmetry, pose));
    } else {
      rotation = plain ? uniform_rotation(start, pose) : torque_free_rotation(start, pose, inertia_);
    }
  } else if (const auto symmetry = symmetry_about(arm_, inertia_)) {
    BodyPose top = pose;
    // What two angles describe does not spin by itself.
    if (symmetry->axial == 0 && !spins_)
      top.angular_velocity = top.angular_velocity - dot(top.angular_velocity, symmetry->axis) * symmetry->axis;
    method = symmetry->axial == 0 ? "closed form: spherical pendulum" : "closed form: symmetric top";
    rotation = top_rotation(start, top, {symmetry->transverse, symmetry->axial, mass_ * g * arm}, symmetry->axis,
                            -gravity_ / g);
    pose = top;
  }
  if (rotation) {
    if (!starts_right(*rotation, start, pose)) return std::nullopt;
    const auto flow = std::make_shared<BodyFlow>(coordinates_, rotation, start, pose, gravity_);
    return followed(flow, coordinates_->winds(), rotation->periods(),
                    Span{equations, start, q, v, end, options, events}, method);
  }
  if (!spins_) return std::nullopt;

  RotatingBody body;
  body.inertia = inertia_;
  body.first_moment = mass_ * arm_;
  body.gravity = gravity_;
  if (lacks_a_moment(inertia_)) return std::nullopt;
  const MethodMaker make = [&](IntegrationMethod, RightSide&, const ErrorScale&, const IntegrationOptions& o) {
    return make_body_method(coordinates_, body, o);
  };
  IntegrationResult result = integrate_by(make, equations, start, q, v, end, options, events);
  result.method = "integrated about the free motion of the body";
  return result;
}

std::optional<IntegrationResult> LoneBody::follow_axis(const MotionEquations& equations, double start,
                                                       std::span<const double> q, std::span<const double> v, double end,
                                                       const IntegrationOptions& options,
                                                       std::span<const Event> events) const {
  if (!(axial_moment_ > 0)) return std::nullopt;
  AxisMotion motion;
  motion.t0 = start;
  motion.coordinate = q[0];
  motion.rate = v[0];
  motion.moment = axial_moment_;
  // Only what pulls across the axis turns the body.
  const Vector pull = gravity_ - dot(gravity_, axis_) * axis_;
  const double g = norm(pull), arm = norm(arm_);
  if (g > rounding * norm(gravity_) && arm > 0) {
    const Vector up = -pull / g, at_zero = attitude_ * arm_;
    const double zero = std::atan2(dot(at_zero, cross(axis_, up)), dot(at_zero, up));
    motion.angle = std::remainder(zero + motion.coordinate, 2 * std::numbers::pi);
    motion.weight_moment = mass_ * g * arm;
  }
  const AxisFlows axis = axis_flow(motion);
  return followed(axis.flow, !axis.periods.empty(), axis.periods, Span{equations, start, q, v, end, options, events},
                  motion.weight_moment > 0 ? "closed form: pendulum" : "closed form: uniform rotation");
}

}  // namespace poinsot
