// Gravity, the frames and the plane of a machine.
#include <algorithm>
#include <cmath>
#include <type_traits>

#include "poinsot/engine/mass/composition.h"
#include "poinsot/engine/math/algebra/plain.h"
#include "problem/language/diagnostic.h"
#include "problem/language/exact_numbers.h"
#include "problem/machine/machine_draft.h"
#include "problem/machine/shapes.h"

namespace poinsot::problem {

namespace {

// Whether a vector of pure numbers may be meant as an acceleration: [0, -1.62, 0], but not [0, -1, 0], [1, 0, -1] or
// [-sin(b), -cos(b), 0].
template <class Scalar>
bool is_size_without_unit(const Expression& expression, const Value<Scalar>& value) {
  if (!value.bare || !expression.as<List>()) return false;
  bool whole = true;
  for (std::size_t i = 0; i < 3; ++i) {
    const double part = std::abs(plain(value.vector[i]));
    whole = whole && (part == 0 || part == 1);
  }
  constexpr double nearly = 1e-2;  // as a part of one: the numbers of a direction may be rounded
  return !whole && std::abs(plain(norm_squared(value.vector)) - 1) > nearly;
}

// From the mass center of a body to those of its parts. They are differences of places near each other, so that a
// figure that is drawn far from the origin leaves no moment of the rounding of that distance about the mass center.
template <class Scalar>
std::vector<Vector3<Scalar>> arms_from_center(const BodyMassOf<Scalar>& body) {
  std::vector<Vector3<Scalar>> arms;
  Vector3<Scalar> sum = Vector3<Scalar>::zero();
  Scalar mass(0);
  for (const PulledPart<Scalar>& part : body.pulled) {
    arms.push_back(part.properties.center - body.pulled.front().properties.center);
    sum = sum + part.properties.mass * arms.back();
    mass = mass + part.properties.mass;
  }
  if (plain(mass) > 0)
    for (Vector3<Scalar>& arm : arms) arm = arm - sum / mass;
  return arms;
}

// How far the matter of a part reaches from its mass center; of a body known by numbers how far it must reach at least.
template <class Scalar>
double reach_of(const MachineDraft<Scalar>& draft, const PulledPart<Scalar>& part, const std::string& owner) {
  if constexpr (std::is_same_v<Scalar, double>) {
    const MassProperties<double>& own = part.properties;
    if (!part.stated) {
      const SymmetricMatrix3<double>& I = own.inertia_center;
      return own.mass > 0 ? std::sqrt((I.xx + I.yy + I.zz) / (2 * own.mass)) : 0;
    }
    double reach = 0;
    for (const Vector3<double>& vertex : shape_picture(part.stated->shape, draft.data, owner).vertices)
      reach = std::max(reach, norm(vertex - own.center));
    return reach;
  }
  return 0;
}

}  // namespace

template <class Scalar>
void set_gravity(MachineDraft<Scalar>& draft) {
  const Situation& situation = draft.situation;
  Vector3<Scalar> gravity = lifted<Scalar>(draft.options.open_gravity);
  if (situation.gravity) {
    const Name* name = situation.gravity->as<Name>();
    if (name && !draft.data.knows(name->name) && name->name != "none")
      fail(situation.file, situation.gravity->mark(), "'" + name->name + "' is no direction for gravity",
           "write gravity: -y or gravity: none");
    if (name && name->name == "none" && name->primes == 0) {
      gravity = Vector3<Scalar>::zero();
    } else {
      const Value<Scalar> value = draft.data.value(*situation.gravity);
      const bool direction =
          value.bare || same_kind(value.dimension, dimensions::none) || same_kind(value.dimension, dimensions::length);
      if (value.is_vector() && same_kind(value.dimension, dimensions::acceleration) && !value.bare)
        gravity = value.vector;
      else if (!value.is_vector() || !direction)
        fail(situation.file, situation.gravity->mark(),
             "gravity is " + to_string(value.dimension) + "; expected a direction or a vector of acceleration",
             "write gravity: -y, gravity: none, or gravity: [0, -9.8 m/s^2, 0]");
      else if (is_size_without_unit(*situation.gravity, value))
        fail(situation.file, situation.gravity->mark(),
             "it is not clear whether this is a direction or an acceleration without its unit",
             "write the acceleration with its unit, as in [0, -1.62 m/s^2, 0], or a direction such as -y");
      else
        gravity = draft.data.gravity_size() * draft.data.direction(*situation.gravity);
    }
  }
  draft.builder.set_gravity(gravity);
}

template <class Scalar>
void add_attractions(MachineDraft<Scalar>& draft) {
  const Situation& situation = draft.situation;
  if (!situation.central_gravity) return;
  const CentralGravity& center = *situation.central_gravity;
  if (!situation.strikes.empty())
    fail(situation.file, situation.strikes.front().mark,
         "what flies by itself is not pulled by the center, and would not know its velocity where it strikes",
         "state it as a body of its own");
  for (const Expression* one : {&center.toward, &center.parameter})
    if (depends_on_time(situation, *one))
      fail(situation.file, one->mark(), "the center that pulls is stated with data that change with time",
           "it rests, and its parameter stays");
  const Vector3<Scalar> O = draft.data.place(center.toward);
  const Scalar parameter = draft.data.number(center.parameter, dimensions::gravitational_parameter);
  if (!draft.options.lenient && !(plain(parameter) > 0))
    fail(situation.file, center.parameter.mark(), "the parameter of a center that pulls is positive");
  for (std::size_t i = 0; i < situation.bodies.size(); ++i) {
    const Body& body = situation.bodies[i];
    if (body.massless) continue;
    const int on = draft.body(body.name);
    const std::string owner = "body '" + body.name + "'";
    AttractionLaw<Scalar> law{draft.add_action(ActionKind::attraction, name_of_gravity, "", on, ground),
                              draft.machine.place(on, draft.masses[i].properties.center),
                              Place<Scalar>{ground, O},
                              parameter,
                              {}};
    const std::vector<Vector3<Scalar>> arms = arms_from_center(draft.masses[i]);
    for (const PulledPart<Scalar>& part : draft.masses[i].pulled) {
      const MassProperties<Scalar>& own = part.properties;
      const double reach = reach_of(draft, part, owner), distance = norm(plain(Vector3<Scalar>(own.center - O)));
      if (!(distance > reach))
        fail(situation.file, body.mark,
             "the center that pulls lies " + std::string(distance > 0 ? "within " : "in the middle of ") + owner +
                 ", where its pull is not known",
             "place it farther away: only from outside it is known how a center pulls");
      law.parts.push_back(
          {law.at.point + arms[law.parts.size()], own.mass, part.by_moments, own.inertia_center, reach});
    }
    draft.machine.mechanism.attractions.push_back(std::move(law));
  }
}

template <class Scalar>
void add_frame(MachineDraft<Scalar>& draft, const Frame& frame) {
  const Vector3<Scalar> origin = frame.origin ? draft.data.place(*frame.origin)
                                 : frame.rides_on.empty()
                                     ? Vector3<Scalar>::zero()
                                     : draft.masses[draft.body_number(frame.rides_on)].properties.center;
  const std::string owner = "frame '" + frame.name + "'";
  const std::size_t first = draft.next_velocity();
  const bool translates = frame.velocity || frame.acceleration;
  Vector3<Scalar> w = Vector3<Scalar>::zero(), alpha = Vector3<Scalar>::zero();
  if (frame.turns) {
    const Vector3<Scalar> axis = draft.data.direction(*frame.turns);
    const TimedNumber<Scalar> rate = draft.timed_number(*frame.rate, dimensions::angular_velocity);
    if (rate.derivative && frame.accel)
      fail(draft.situation.file, frame.accel->mark(),
           owner + " has a rate as a function of time and also accel:, which is its derivative", "remove accel:");
    const Scalar accel = frame.accel ? draft.timed_number(*frame.accel, dimensions::angular_acceleration).value
                                     : rate.derivative.value_or(Scalar(0));
    w = rate.value * axis;
    alpha = accel * axis;
    if (!translates) {
      draft.machine.index[frame.name] =
          draft.add_link(frame.name, ground, poinsot::Joint<Scalar>::revolute(axis), origin, massless<Scalar>());
      draft.machine.mechanism.coordinate_names[first] = "rate of " + owner;
      draft.state_rate(owner + ": rate", first, rate.value, true, frame.mark);
      draft.state_acceleration(owner + ": accel", first, accel, true, frame.mark);
      return;
    }
  }
  if (!translates) {
    draft.machine.index[frame.name] =
        draft.add_link(frame.name, ground, poinsot::Joint<Scalar>::weld(), origin, massless<Scalar>());
    return;
  }
  draft.machine.index[frame.name] =
      draft.add_link(frame.name, ground, poinsot::Joint<Scalar>::free(), origin, massless<Scalar>());
  draft.name_free(owner, first, 6);
  const Vector3<Scalar> v =
      frame.velocity ? draft.data.vector(*frame.velocity, dimensions::velocity) : Vector3<Scalar>::zero();
  for (std::size_t k = 0; k < 3; ++k) {
    draft.state_rate(owner + ": rate", first + k, w[k], true, frame.mark);
    draft.state_acceleration(owner + ": accel", first + k, alpha[k], true, frame.mark);
    draft.state_rate(owner + ": velocity", first + 3 + k, v[k], false, frame.mark);
  }
  std::optional<Vector3<Scalar>> stated;
  if (frame.acceleration) stated = draft.data.vector(*frame.acceleration, dimensions::acceleration);
  if (!stated && frame.velocity && depends_on_time(draft.situation, *frame.velocity)) {
    const Vector3<TimeJetOf<Scalar>> jet = draft.timed.vector(*frame.velocity, dimensions::velocity);
    stated = Vector3<Scalar>{jet.x.partial[0].value, jet.y.partial[0].value, jet.z.partial[0].value};
  }
  if (!stated) return;
  // The velocity coordinates are components on the frame's own axes, on which the rate of v is a - w x v (Eq. 18.22).
  const Vector3<Scalar> a = *stated - cross(w, v);
  for (std::size_t k = 0; k < 3; ++k)
    draft.state_acceleration(owner + ": acceleration", first + 3 + k, a[k], false, frame.mark);
}

namespace {

// Sine of the angle to a plane within which directions that were stated to nine digits lie in it.
constexpr double in_the_plane = 1e-9;

// A particle has no axes that could turn out of the plane.
bool has_no_axes(const Body& body) {
  return body.parts.size() == 1 && body.parts.front().shape.kind == "particle" && body.added.empty() &&
         body.absorbed.empty();
}

bool goes_round(const Cord& cord, const std::string& body) {
  const auto is_wheel = [&](const CordWheel& wheel) { return wheel.name == body && wheel.radius; };
  return std::ranges::any_of(cord.over, is_wheel) || (cord.off_from && is_wheel(*cord.off_from)) ||
         (cord.on_to && is_wheel(*cord.on_to));
}

}  // namespace

template <class Scalar>
bool lies_along_normal(const MachineDraft<Scalar>& draft, const Vector3<Scalar>& direction) {
  if (!draft.situation.plane) return true;
  const Vector3<double> d = plain(direction), n = Vector3<double>::unit(draft.situation.plane->normal());
  return norm(cross(d, n)) <= in_the_plane * norm(d);
}

template <class Scalar>
bool lies_in_plane(const MachineDraft<Scalar>& draft, const Vector3<Scalar>& direction) {
  if (!draft.situation.plane) return true;
  const Vector3<double> d = plain(direction);
  return std::abs(d[draft.situation.plane->normal()]) <= in_the_plane * norm(d);
}

template <class Scalar>
void require_in_plane(const MachineDraft<Scalar>& draft, const Vector3<Scalar>& vector, const Mark& mark,
                      const std::string& what) {
  if (!lies_in_plane(draft, vector))
    fail(draft.situation.file, mark, what + " points out of the plane of the problem",
         "correct it, or leave plane: out");
}

template <class Scalar>
void require_along_normal(const MachineDraft<Scalar>& draft, const Vector3<Scalar>& vector, const Mark& mark,
                          const std::string& what) {
  if (!lies_along_normal(draft, vector))
    fail(draft.situation.file, mark, what + " does not stand across the plane of the problem",
         "in a plane all turns about " + draft.situation.axes[draft.situation.plane->normal()]);
}

template <class Scalar>
void hold_in_plane(MachineDraft<Scalar>& draft) {
  const Situation& situation = draft.situation;
  if (!situation.plane) return;
  for (const NamedExpression& point : situation.points)
    require_in_plane(draft, draft.data.place(point.value), point.mark, "point '" + point.name + "'");
  for (const Frame& frame : situation.frames)
    if (frame.turns)
      require_along_normal(draft, draft.data.direction(*frame.turns), frame.turns->mark(),
                           "the axis of frame '" + frame.name + "'");
  const auto unit = [](std::size_t k) { return Vector3<Scalar>::unit(k); };
  const MotionPlane& plane = *situation.plane;
  for (std::size_t i = 0; i < situation.bodies.size(); ++i) {
    const Body& body = situation.bodies[i];
    const int on = draft.body(body.name);
    const Place<Scalar> at =
        draft.machine.place(on, body.massless ? draft.machine.drawn_origin.at(on) : draft.masses[i].center);
    const int action = draft.add_action(ActionKind::joint, hold_of_plane, "", on, ground);
    const bool free = draft.machine.mechanism.tree.body(on).joint == JointType::free;
    const std::string words = "'" + body.name + "' in the plane";
    draft.add_component(action, situation.axes[plane.normal()], false, at, {ground, unit(plane.normal())});
    if (free) draft.add_constraint(VelocityConstraintKind::point, words, on, ground, at, unit(plane.normal()));
    // A particle has no axes, unless a joint carries something on it or a cord goes round it.
    const bool carries =
        std::ranges::any_of(situation.joints, [&](const Joint& joint) { return joint.from == body.name; }) ||
        std::ranges::any_of(situation.cords, [&](const Cord& cord) { return goes_round(cord, body.name); });
    if (has_no_axes(body) && !carries) continue;
    for (const std::size_t axis : {plane.first, plane.second}) {
      draft.add_component(action, situation.axes[axis], true, at, {ground, unit(axis)});
      if (free) draft.add_constraint(VelocityConstraintKind::angular, words, on, ground, at, unit(axis));
    }
  }
}

template void set_gravity(MachineDraft<double>&);
template void add_attractions(MachineDraft<double>&);
template void add_frame(MachineDraft<double>&, const Frame&);
template void hold_in_plane(MachineDraft<double>&);
template bool lies_along_normal(const MachineDraft<double>&, const Vector3<double>&);
template bool lies_in_plane(const MachineDraft<double>&, const Vector3<double>&);
template void require_in_plane(const MachineDraft<double>&, const Vector3<double>&, const Mark&, const std::string&);
template void require_along_normal(const MachineDraft<double>&, const Vector3<double>&, const Mark&,
                                   const std::string&);
template void set_gravity(MachineDraft<Dual<1>>&);
template void add_attractions(MachineDraft<Dual<1>>&);
template void add_frame(MachineDraft<Dual<1>>&, const Frame&);
template void hold_in_plane(MachineDraft<Dual<1>>&);
template bool lies_along_normal(const MachineDraft<Dual<1>>&, const Vector3<Dual<1>>&);
template bool lies_in_plane(const MachineDraft<Dual<1>>&, const Vector3<Dual<1>>&);
template void require_in_plane(const MachineDraft<Dual<1>>&, const Vector3<Dual<1>>&, const Mark&, const std::string&);
template void require_along_normal(const MachineDraft<Dual<1>>&, const Vector3<Dual<1>>&, const Mark&,
                                   const std::string&);
template void set_gravity(MachineDraft<Formula>&);
template void add_attractions(MachineDraft<Formula>&);
template void add_frame(MachineDraft<Formula>&, const Frame&);
template void hold_in_plane(MachineDraft<Formula>&);
template bool lies_along_normal(const MachineDraft<Formula>&, const Vector3<Formula>&);
template bool lies_in_plane(const MachineDraft<Formula>&, const Vector3<Formula>&);
template void require_in_plane(const MachineDraft<Formula>&, const Vector3<Formula>&, const Mark&, const std::string&);
template void require_along_normal(const MachineDraft<Formula>&, const Vector3<Formula>&, const Mark&,
                                   const std::string&);

}  // namespace poinsot::problem
