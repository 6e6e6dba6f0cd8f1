// The contacts of a machine.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <optional>
#include <utility>

#include "poinsot/engine/math/algebra/plain.h"
#include "problem/entries/read_joints.h"
#include "problem/keys/joint_kinds.h"
#include "problem/language/diagnostic.h"
#include "problem/language/exact_numbers.h"
#include "problem/language/words.h"
#include "problem/machine/body_surfaces.h"
#include "problem/machine/machine_draft.h"
#include "problem/machine/touching_surfaces.h"

namespace poinsot::problem {

namespace {

bool is_particle(const Body& body) { return body.parts.size() == 1 && body.parts.front().shape.kind == "particle"; }

// Refuses a contact whose point is beside a body that is straight everywhere, and one on a particle, which has no
// surface for another body to touch.
template <class Scalar>
void check_sides(MachineDraft<Scalar>& draft, const Contact& contact, const Vector3<double>& C,
                 const Vector3<double>& on_other) {
  const auto refuse_beside = [&](const std::string& name, const Vector3<double>& point) {
    constexpr double at_surface = 1e-6;  // of the distances in the figure, which the author may have rounded
    const Body& body = draft.situation.bodies[draft.body_number(name)];
    const std::optional<double> gap = gap_to_sides(body, draft.data, point);
    if (!gap) return;
    const double size = norm(point) + norm(plain(draft.masses[draft.body_number(name)].properties.center));
    if (*gap > at_surface * size)
      fail(draft.situation.file, contact.at.mark(),
           fmt::format("contact '{}' is {:.3g} m off the surface of '{}'", contact.name, *gap, name),
           is_particle(body) ? "a particle touches where it is: correct the point under at:"
                             : "correct the point under at:, or give the body the shape that touches there");
  };
  if (!contact.corner) refuse_beside(contact.of, C);
  const auto other = std::find_if(draft.situation.bodies.begin(), draft.situation.bodies.end(),
                                  [&](const Body& body) { return body.name == contact.against; });
  if (other == draft.situation.bodies.end()) return;
  if (is_particle(*other)) {
    const auto own = std::ranges::find(draft.situation.bodies, contact.of, &Body::name);
    const bool both = own != draft.situation.bodies.end() && is_particle(*own);
    fail(draft.situation.file, contact.mark,
         "'" + other->name + "' is a particle, which has no surface that '" + contact.of + "' could touch",
         both ? "two particles do not meet: give '" + other->name + "' a shape, such as a box or a sphere"
              : "state the contact from the particle: of: " + other->name + ", against: " + contact.of +
                    ", with the normal into it");
  }
  refuse_beside(contact.against, on_other);
}

// Of data with six digits: what is off a plane or a parallel by less is meant to lie in it.
constexpr double of_data = 1e-6;

// The directions in which an edge does not slip, which turn with its body.
template <class Scalar>
std::vector<Vector3<Scalar>> knife_edges(MachineDraft<Scalar>& draft, const Contact& contact,
                                         const Vector3<Scalar>& n) {
  std::vector<Vector3<Scalar>> edges;
  if (!contact.no_slip_along.empty() && contact.carries)
    fail(draft.situation.file, contact.no_slip_along.front().mark(),
         "contact '" + contact.name + "' states what it carries and in which directions it does not slip",
         "it carries its push and forces along these directions: leave out carries:");
  if (contact.no_slip_along.size() > 2)
    fail(draft.situation.file, contact.no_slip_along[2].mark(),
         "contact '" + contact.name + "' names more directions than a surface has", "write no_slip: true");
  for (const Expression& stated : contact.no_slip_along) {
    edges.push_back(draft.data.direction(stated));
    require_in_plane(draft, edges.back(), stated.mark(), "the edge of contact '" + contact.name + "'");
    if (std::abs(dot(plain(edges.back()), plain(n))) > of_data)
      fail(draft.situation.file, stated.mark(),
           "contact '" + contact.name + "' cannot slip along " + to_string(stated) + ", which is not along the surface",
           "state directions across the normal");
  }
  if (edges.size() == 2 && !(norm(cross(plain(edges[0]), plain(edges[1]))) > of_data))
    fail(draft.situation.file, contact.no_slip_along[1].mark(),
         "contact '" + contact.name + "' names one direction twice", "leave out one of them");
  return edges;
}

// Whether what touches is a point fixed in its body, as a corner is, and an edge that is not the rim of a wheel, which
// does not slip along its axis.
template <class Scalar>
bool is_fixed_point(const MachineDraft<Scalar>& draft, const Contact& contact, const RollingSurface<Scalar>& surface,
                    const std::vector<Vector3<Scalar>>& edges) {
  if (contact.corner) return true;
  if (edges.empty()) return false;
  if (surface.shape != ContactShape::round) return true;
  const auto along_axis = [&](const Vector3<Scalar>& d) { return norm(plain(cross(d, surface.axis))) <= of_data; };
  if (norm(plain(surface.axis)) > 0 && std::ranges::all_of(edges, along_axis)) return false;
  if (draft.situation.bodies[draft.body_number(contact.of)].parts.empty()) return true;
  fail(draft.situation.file, contact.no_slip_along.front().mark(),
       "contact '" + contact.name + "' does not slip along directions that turn with '" + contact.of +
           "', which is round there",
       "of a wheel state its axis alone; a blade belongs to a body that is not round where it touches");
}

// A length by which friction acts in a joint.
template <class Scalar>
Scalar size_in_bearing(MachineDraft<Scalar>& draft, const Contact& contact, const Expression& stated, bool may_vanish) {
  Scalar size = draft.data.number(stated, dimensions::length);
  if (!draft.options.lenient && !(plain(size) > 0 || (may_vanish && plain(size) == 0)))
    fail(draft.situation.file, stated.mark(),
         contact.words() + " has a bearing " + (may_vanish ? "of negative size" : "without size"),
         "write a length above zero");
  return size;
}

// What presses in a joint whose friction follows from a coefficient. A journal of radius r bears the force across its
// axis, a collar that along it, a guide that across its direction. Where a length L is stated it bears at two ends,
// with half of the force on each and the couple that it carries divided by L; where supports are, with the force on
// each. Of a thread with the lead h for a radian, t = h/r, a = atan t, and the flank at the angle b to a square one,
// tan b_n = cos a tan b, the push N of the flank and the friction F along it follow from the force X along the axis and
// the friction's own couple M by
//   F = M cos a / r,   N = (X / cos a - M sin a / r) / cos b_n,
// so that |F| = m N is |M| = m |r (1 + t^2) X - t M| / cos b_n.
template <class Scalar>
std::vector<PressingPart<Scalar>> pressing_parts(MachineDraft<Scalar>& draft, const Contact& contact,
                                                 const Joint& joint) {
  using Part = PressingPart<Scalar>;
  const Bearing& bearing = *contact.friction->bearing;
  std::vector<Part> parts;
  const auto size = [&](const std::optional<Expression>& stated, bool may_vanish) {
    return stated ? size_in_bearing(draft, contact, *stated, may_vanish) : Scalar(1);
  };
  const Scalar radius = size(bearing.radius, !joint.kind->advances);
  const std::vector<Action>& actions = draft.machine.mechanism.actions;
  for (std::size_t i = 0; i < actions.size(); ++i) {
    const bool whole = actions[i].kind == ActionKind::joint && actions[i].name == joint.name;
    if (!whole && !(actions[i].kind == ActionKind::support && actions[i].joint == joint.name)) continue;
    Part part;
    part.action = static_cast<int>(i);
    if (joint.kind->advances) {
      if (!whole)
        fail(draft.situation.file, contact.friction->mark,
             contact.words() + " is a screw with supports, among which its thread is not told apart",
             "leave out supports:, or the friction");
      const Scalar t = pitch_of(draft, joint) / radius;
      Scalar over_cosine(1);
      if (bearing.thread_angle) {
        const Scalar angle = draft.data.number(*bearing.thread_angle, dimensions::angle);
        if (!draft.options.lenient && !(plain(angle) >= 0 && plain(angle) < std::numbers::pi))
          fail(draft.situation.file, bearing.thread_angle->mark(),
               contact.words() + " has flanks that do not stand between 0 and 180 deg to each other",
               "write the angle between the flanks, such as thread_angle: 29 deg");
        using std::tan, std::sqrt;
        const Scalar flank = tan(angle / Scalar(2));
        over_cosine = sqrt(Scalar(1) + flank * flank / (Scalar(1) + t * t));
      }
      part.form = Part::Form::thread;
      part.lever = over_cosine * radius * (Scalar(1) + t * t);
      part.own = -over_cosine * t;
      parts.push_back(part);
      continue;
    }
    if (bearing.length && !whole)
      fail(draft.situation.file, bearing.length->mark(),
           contact.words() + " states supports and a length between its ends",
           "its supports bear it: leave out length:, or supports:");
    if (bearing.radius || !joint.freedoms.front().turning) {
      part.lever = radius;
      if (bearing.length) {
        part.form = Part::Form::end;
        part.over_length = Scalar(1) / size(bearing.length, false);
        parts.push_back(part);
        part.over_length = -part.over_length;
      }
      parts.push_back(part);
    }
    if (!bearing.thrust_radius) continue;
    part.form = Part::Form::along;
    part.lever = size(bearing.thrust_radius, true);
    parts.push_back(part);
  }
  return parts;
}

// Friction in a joint acts like a motor beside that of the joint: of unknown effort while it holds or follows from the
// load, else against the rate.
template <class Scalar>
void add_friction_in_joint(MachineDraft<Scalar>& draft, const Contact& contact) {
  std::vector<Drive<Scalar>>& drives = draft.machine.mechanism.drives;
  const auto [joint, freedom] = rubbing_freedom(draft.situation.joints, contact.name);
  const std::string& named = joint.freedoms[freedom].name;
  const std::string driven = joint.name + (named.empty() ? "" : "." + named);
  const auto motor = std::ranges::find_if(drives, [&](const Drive<Scalar>& drive) {
    return draft.machine.mechanism.actions[static_cast<std::size_t>(drive.action)].name == driven;
  });
  if (motor == drives.end())
    fail(draft.situation.file, contact.friction->mark,
         contact.words() + " closes a loop, and friction in such a joint is not solved",
         "state the joint before those that hold both its bodies, or the friction at another joint of the loop");
  Drive<Scalar> rubbing = *motor;
  const bool by_load = contact.friction->bearing.has_value();
  rubbing.held = contact.grip == Grip::sticks || (by_load && contact.grip == Grip::slides);
  rubbing.effort = rubbing.stiffness = rubbing.free_position = rubbing.damping = Scalar(0);
  const auto [resting, sliding] = friction_of(draft, contact,
                                              by_load           ? dimensions::none
                                              : rubbing.turning ? dimensions::moment
                                                                : dimensions::force);
  rubbing.action = draft.add_action(ActionKind::friction, contact.name, joint.name, draft.body(contact.of),
                                    draft.body(contact.against));
  RoughContactOf<Scalar> rough;
  rough.name = contact.name;
  rough.action = rubbing.action;
  rough.grip = contact.grip;
  rough.resting = resting;
  rough.sliding = sliding;
  rough.coordinate = rubbing.coordinate;
  rough.turning = rubbing.turning;
  rough.at = rubbing.at;
  rough.drive = drives.size();
  if (by_load) rough.pressing = pressing_parts(draft, contact, joint);
  const auto [one, other] = across(rubbing.along.vector);
  rough.normal = {rubbing.along.body, one};
  rough.motions[1].along = rubbing.along;
  rough.motions[2].along = {rubbing.along.body, other};
  if (contact.grip == Grip::sticks)
    draft.machine.accelerations.push_back(
        {contact.words() + " held by its friction", rubbing.coordinate, Scalar(0), rubbing.turning, contact.mark});
  if (contact.grip == Grip::slides) {
    const Vector3<Scalar> d = draft.data.direction(*contact.slip);
    const bool forward = plain(dot(d, rubbing.along.vector)) > 0;
    rough.slip = {rubbing.along.body, forward ? rubbing.along.vector : -rubbing.along.vector};
    if (!by_load) rubbing.effort = forward ? -sliding : sliding;
  }
  drives.push_back(rubbing);
  draft.machine.rough_contacts.push_back(std::move(rough));
}

}  // namespace

template <class Scalar>
std::pair<Scalar, Scalar> friction_of(MachineDraft<Scalar>& draft, const Contact& contact, const Dimension& dimension) {
  const bool is_coefficient = !contact.in_joint || contact.friction->bearing;
  if (!is_coefficient && draft.data.value(contact.friction->resting).dimension == dimensions::none &&
      draft.data.value(contact.friction->resting).is_number() && !draft.options.lenient)
    fail(draft.situation.file, contact.friction->mark,
         contact.words() + " states a pure number as its friction, which here is a " +
             (dimension == dimensions::moment ? "couple" : "force"),
         dimension == dimensions::moment ? "write a couple, or {coefficient: 0.1, radius: 20 mm}"
                                         : "write a force, or {coefficient: 0.2}");
  const Scalar resting = draft.data.number(contact.friction->resting, dimension),
               sliding = draft.data.number(contact.friction->sliding, dimension);
  const auto refuse = [&](const std::string& message, const std::string& hint) {
    fail(draft.situation.file, contact.friction->mark, contact.words() + " " + message, hint);
  };
  if (!draft.options.lenient) {
    if (!(plain(resting) >= 0) || !(plain(sliding) >= 0))
      refuse(std::string("has a negative ") + (is_coefficient ? "coefficient of friction" : "friction"),
             std::string("friction resists: write ") + (is_coefficient ? "a coefficient" : "one") +
                 " that is zero or positive");
    if (plain(sliding) > plain(resting))
      refuse("has more friction while it slides than at rest",
             "static: is the larger of the two, or both are the same");
  }
  return {resting, sliding};
}

template <class Scalar>
void add_contact(MachineDraft<Scalar>& draft, const Contact& contact) {
  if (contact.in_joint) return add_friction_in_joint(draft, contact);
  if (contact.on_cord) return;  // Its cord knows where.
  const int on = draft.body(contact.of), from = draft.body(contact.against);
  const Vector3<Scalar> C = draft.data.place(contact.at), n = draft.data.direction(contact.normal);
  const Place<Scalar> at = draft.machine.place(on, C);
  const int action = draft.add_action(ActionKind::contact, contact.name, "", on, from);
  if (contact.open && !draft.options.open_contacts) return;
  const Vector3<Scalar> S = contact.surface ? draft.data.place(*contact.surface) : C;
  const auto [t1, t2] = across(n);
  require_in_plane(draft, n, contact.normal.mark(), "the normal of contact '" + contact.name + "'");
  const bool rubs = contact.rubs();
  // The forces that the contact can carry; of one that flies, those by which it is caught.
  std::vector<std::pair<std::string, Vector3<Scalar>>> directions;
  if (contact.carries) {
    for (const Expression& e : *contact.carries) {
      const Name* name = e.as<Name>();
      if (name && name->name == "push")
        directions.emplace_back("push", n);
      else
        directions.emplace_back(to_string(e), draft.data.direction(e));
    }
  } else if (rubs && contact.grip == Grip::slides) {
    // Along the slip the friction is the coefficient times the push: both are one component of the push's size.
    directions.emplace_back("push", n - draft.data.number(contact.friction->sliding, dimensions::none) *
                                            draft.data.direction(*contact.slip));
  } else if (!rubs || contact.grip != Grip::parts) {
    directions.emplace_back(draft.direction_name(n), n);
    if (contact.no_slip || contact.grip == Grip::sticks) {
      directions.emplace_back(draft.direction_name(t1), t1);
      directions.emplace_back(draft.direction_name(t2), t2);
    }
  }
  std::erase_if(directions, [&](const auto& direction) { return !lies_in_plane(draft, direction.second); });
  for (const auto& [name, d] : directions) {
    draft.add_component(action, name, false, at, {from, d}).one_sided =
        norm(plain(d - n)) < 1e-9 || contact.grip == Grip::slides;
  }
  const std::vector<Vector3<Scalar>> edges = knife_edges(draft, contact, n);
  for (const Vector3<Scalar>& d : edges) draft.add_component(action, draft.direction_name(d), false, at, {on, d});
  // The relative motion that the contact forbids.
  const Body& stated = draft.situation.bodies[draft.body_number(contact.of)];
  // An edge does not move over its body.
  const std::optional<TouchingSurfaces<Scalar>> curved =
      edges.empty() ? touching_surfaces(draft, contact, C, S, n) : std::nullopt;
  const RollingSurface<Scalar> surface =
      rolling_surface(stated, draft.data, C, n, draft.masses[draft.body_number(contact.of)].properties.center);
  // Such a point may stand off the body's own surface.
  const bool fixed_point = is_fixed_point(draft, contact, surface, edges);
  if (!curved && surface.shape == ContactShape::missed && !fixed_point) {
    fail(draft.situation.file, contact.at.mark(),
         fmt::format("contact '{}' is {:.3g} m off the surface of '{}'", contact.name, surface.gap, contact.of),
         "correct the point under at:");
  }
  if (!curved && !fixed_point && !normal_fits(surface, C, n))
    fail(draft.situation.file, contact.normal.mark(),
         "the normal of contact '" + contact.name + "' does not stand on the surface of '" + contact.of +
             "' at that point",
         norm(plain(surface.axis)) == 0
             ? "there it goes along the radius: correct it, or the point under at:"
             : "there it lies in the plane through the axis: correct it, or the point under at:");
  if (!fixed_point) check_sides(draft, contact, plain(C), plain(S));
  // The surface on the other side may be curved as well.
  bool unknown = surface.shape == ContactShape::unknown && !fixed_point;
  if (draft.machine.mechanism.takes_part.size() > static_cast<std::size_t>(std::max(from, 0)) && from != ground &&
      draft.machine.mechanism.takes_part[static_cast<std::size_t>(from)]) {
    const std::size_t other = draft.body_number(contact.against);
    const RollingSurface<Scalar> below =
        rolling_surface(draft.situation.bodies[other], draft.data, S, n, draft.masses[other].properties.center);
    // The flat side of a round body has its axis along the normal.
    unknown = unknown || (below.shape == ContactShape::round && norm(plain(cross(below.axis, n))) > 1e-9) ||
              below.shape == ContactShape::unknown ||
              (below.shape == ContactShape::round && norm(plain(below.axis)) == 0);
    // Within the rim of a flat side its circle is missed, too.
    const bool flat = norm(plain(below.axis)) > 0 && norm(plain(cross(below.axis, n))) <= 1e-9;
    if (!curved && !flat && below.shape == ContactShape::missed)
      fail(draft.situation.file, contact.at.mark(),
           fmt::format("contact '{}' is {:.3g} m off the surface of '{}'", contact.name, below.gap, contact.against),
           "correct the point under at:");
  }
  const bool round = !curved && surface.shape == ContactShape::round && !fixed_point;
  ContactLimit limit{contact.name, contact.of, contact.against, to_string(contact.at), action, contact.mark, {},
                     -1,           {}};
  if (curved) {
    if (curved->along_line) draft.machine.line_contacts.push_back(contact.name);
    unknown = false;
    for (const auto& end : {curved->end_on, curved->end_from}) {
      if (!end) continue;
      ContactLimit one = limit;
      one.end = end;
      if (end->of_against) std::swap(one.body, one.against);
      draft.machine.contact_limits.push_back(std::move(one));
    }
  } else if (round) {
    limit.middle = plain(surface.middle);
    limit.cosine = surface.cosine;
  } else if (!fixed_point) {
    limit.straight = straight_directions(stated, draft.data, plain(C), plain(n));
  }
  if (!curved && (norm(limit.middle) > 0 || !limit.straight.empty()))
    draft.machine.contact_limits.push_back(std::move(limit));
  const auto kind = curved  ? VelocityConstraintKind::touching
                    : round ? VelocityConstraintKind::rolling
                            : VelocityConstraintKind::point;
  const auto surfaces = curved ? std::make_shared<const CurvedContact<Scalar>>(curved->surfaces) : nullptr;
  const auto forbid = [&](const Vector3<Scalar>& d, bool edge = false) {
    const std::string words =
        std::string(contact.no_slip || edge                                          ? "rolling"
                    : contact.grip == Grip::sticks && plain(norm(cross(d, n))) > 0.5 ? "sticking"
                                                                                     : "touching") +
        " at contact '" + contact.name + "' along " + draft.direction_name(d);
    VelocityConstraint<Scalar>& c = draft.add_constraint(kind, words, on, from, at, d);
    c.action = action;
    if (edge) c.along = {on, d};
    c.surface_axis = {from, n};
    if (contact.surface) c.toward = draft.machine.place(from, S);
    c.shape_unknown = unknown;
    c.surfaces = surfaces;
    // Where both surfaces are known, the place follows from the motion.
    if (draft.situation.steady && !curved) {
      c.carried_by = draft.body(draft.situation.steady->frame);
      for (const Frame& frame : draft.situation.frames)
        if (frame.name == draft.situation.steady->frame && !frame.rides_on.empty())
          c.carried_along = draft.body(frame.rides_on);
    }
    if (!round) return;
    c.center = draft.machine.place(on, surface.center).point;
    c.axis = surface.axis;
    c.radius = surface.radius;
  };
  std::vector<VelocityConstraint<Scalar>>& constraints = draft.machine.mechanism.constraints;
  forbid(n);
  constraints.back().normal = true;
  if (contact.no_slip || rubs)
    for (const Vector3<Scalar>& t : {t1, t2})
      if (rubs || lies_in_plane(draft, t)) forbid(t);
  for (const Vector3<Scalar>& d : edges) forbid(d, true);
  if (!rubs) return;
  // What holds only while it touches, or while it sticks, is kept apart, to see how it parts and slips.
  const std::size_t first = constraints.size() - 3;
  const auto [resting, sliding] = friction_of(draft, contact, dimensions::none);
  RoughContactOf<Scalar> rough;
  rough.name = contact.name;
  rough.action = action;
  rough.grip = contact.grip;
  rough.resting = resting;
  rough.sliding = sliding;
  rough.normal = {from, n};
  rough.motions = {constraints[first], constraints[first + 1], constraints[first + 2]};
  if (contact.slip) rough.slip = {from, draft.data.direction(*contact.slip)};
  rough.turns = contact.slip_turns;
  draft.machine.rough_contacts.push_back(std::move(rough));
  const std::size_t held = contact.grip == Grip::sticks ? 3 : contact.grip == Grip::parts ? 0 : 1;
  constraints.resize(first + held);
  draft.machine.constraint_joints.resize(first + held);
}

template std::pair<double, double> friction_of(MachineDraft<double>&, const Contact&, const Dimension&);
template std::pair<Dual<1>, Dual<1>> friction_of(MachineDraft<Dual<1>>&, const Contact&, const Dimension&);
template std::pair<Formula, Formula> friction_of(MachineDraft<Formula>&, const Contact&, const Dimension&);
template void add_contact(MachineDraft<double>&, const Contact&);
template void add_contact(MachineDraft<Dual<1>>&, const Contact&);
template void add_contact(MachineDraft<Formula>&, const Contact&);

}  // namespace poinsot::problem
