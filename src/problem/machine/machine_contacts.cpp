// The contacts and cords of a machine.
#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "poinsot/engine/math/algebra/plain.h"
#include "problem/language/diagnostic.h"
#include "problem/language/exact_numbers.h"
#include "problem/language/words.h"
#include "problem/machine/machine_draft.h"
#include "problem/machine/rolling_surface.h"
#include "problem/machine/straight_sides.h"

namespace poinsot::problem {

namespace {

bool is_particle(const Body& body) { return body.parts.size() == 1 && body.parts.front().shape.kind == "particle"; }

// Refuses a contact whose point is beside a body that is straight everywhere, and one on a particle, which has no
// surface for another body to touch.
template <class Scalar>
void check_sides(MachineDraft<Scalar>& draft, const Contact& contact, const Vector3<double>& C) {
  const auto refuse_beside = [&](const std::string& name) {
    constexpr double at_surface = 1e-6;  // of the distances in the figure, which the author may have rounded
    const Body& body = draft.situation.bodies[draft.body_number(name)];
    const std::optional<double> gap = gap_to_sides(body, draft.data, C);
    if (!gap) return;
    const double size = norm(C) + norm(plain(draft.masses[draft.body_number(name)].properties.center));
    if (*gap > at_surface * size)
      fail(draft.situation.file, contact.at.mark(),
           fmt::format("contact '{}' is {:.3g} m off the surface of '{}'", contact.name, *gap, name),
           is_particle(body) ? "a particle touches where it is: correct the point under at:"
                             : "correct the point under at:, or give the body the shape that touches there");
  };
  refuse_beside(contact.of);
  const auto other = std::find_if(draft.situation.bodies.begin(), draft.situation.bodies.end(),
                                  [&](const Body& body) { return body.name == contact.against; });
  if (other == draft.situation.bodies.end()) return;
  if (is_particle(*other))
    fail(draft.situation.file, contact.mark,
         "'" + other->name + "' is a particle, which has no surface that '" + contact.of + "' could touch",
         "state the contact from the particle: of: " + other->name + ", against: " + contact.of +
             ", with the normal into it");
  refuse_beside(contact.against);
}

// The coefficients of friction at rest and while it slides.
template <class Scalar>
std::pair<Scalar, Scalar> friction_of(MachineDraft<Scalar>& draft, const Contact& contact) {
  const Scalar resting = draft.data.number(contact.friction->resting, dimensions::none),
               sliding = draft.data.number(contact.friction->sliding, dimensions::none);
  const auto refuse = [&](const std::string& message, const std::string& hint) {
    fail(draft.situation.file, contact.friction->mark, "contact '" + contact.name + "' " + message, hint);
  };
  if (!draft.options.lenient) {
    if (!(plain(resting) >= 0) || !(plain(sliding) >= 0))
      refuse("has a negative coefficient of friction",
             "friction resists: write a coefficient that is zero or positive");
    if (plain(sliding) > plain(resting))
      refuse("has more friction while it slides than at rest",
             "static: is the larger of the two, or both are the same");
  }
  return {resting, sliding};
}

}  // namespace

template <class Scalar>
void add_contact(MachineDraft<Scalar>& draft, const Contact& contact) {
  const int on = draft.body(contact.of), from = draft.body(contact.against);
  const Vector3<Scalar> C = draft.data.place(contact.at), n = draft.data.direction(contact.normal);
  const Place<Scalar> at = draft.machine.place(on, C);
  const int action = draft.add_action(ActionKind::contact, contact.name, "", on, from);
  const auto [t1, t2] = across(n);
  // The forces that the contact can carry.
  std::vector<std::pair<std::string, Vector3<Scalar>>> directions;
  if (contact.carries) {
    for (const Expression& e : *contact.carries) {
      const Name* name = e.as<Name>();
      if (name && name->name == "push")
        directions.emplace_back("push", n);
      else
        directions.emplace_back(to_string(e), draft.data.direction(e));
    }
  } else if (contact.friction && contact.grip == Grip::slides) {
    // Along the slip the friction is the coefficient times the push: both are one component of the push's size.
    directions.emplace_back("push", n - draft.data.number(contact.friction->sliding, dimensions::none) *
                                            draft.data.direction(*contact.slip));
  } else if (contact.grip != Grip::parts) {
    directions.emplace_back(draft.direction_name(n), n);
    if (contact.no_slip || contact.grip == Grip::sticks) {
      directions.emplace_back(draft.direction_name(t1), t1);
      directions.emplace_back(draft.direction_name(t2), t2);
    }
  }
  for (const auto& [name, d] : directions) {
    draft.add_component(action, name, false, at, {from, d}).one_sided =
        norm(plain(d - n)) < 1e-9 || contact.grip == Grip::slides;
  }
  // The relative motion that the contact forbids.
  const Body& stated = draft.situation.bodies[draft.body_number(contact.of)];
  const RollingSurface<Scalar> surface =
      rolling_surface(stated, draft.data, C, n, draft.masses[draft.body_number(contact.of)].properties.center);
  if (surface.shape == ContactShape::missed) {
    fail(draft.situation.file, contact.at.mark(),
         fmt::format("contact '{}' is {:.3g} m off the surface of '{}'", contact.name, surface.gap, contact.of),
         "correct the point under at:");
  }
  if (!normal_fits(surface, C, n))
    fail(draft.situation.file, contact.normal.mark(),
         "the normal of contact '" + contact.name + "' does not stand on the surface of '" + contact.of +
             "' at that point",
         norm(plain(surface.axis)) == 0
             ? "there it goes along the radius: correct it, or the point under at:"
             : "there it lies in the plane through the axis: correct it, or the point under at:");
  check_sides(draft, contact, plain(C));
  // The surface on the other side may be curved as well.
  bool unknown = surface.shape == ContactShape::unknown;
  if (draft.machine.mechanism.takes_part.size() > static_cast<std::size_t>(std::max(from, 0)) && from != ground &&
      draft.machine.mechanism.takes_part[static_cast<std::size_t>(from)]) {
    const std::size_t other = draft.body_number(contact.against);
    const RollingSurface<Scalar> below =
        rolling_surface(draft.situation.bodies[other], draft.data, C, n, draft.masses[other].properties.center);
    // The flat side of a round body has its axis along the normal.
    unknown = unknown || (below.shape == ContactShape::round && norm(plain(cross(below.axis, n))) > 1e-9) ||
              below.shape == ContactShape::unknown ||
              (below.shape == ContactShape::round && norm(plain(below.axis)) == 0);
  }
  const bool round = surface.shape == ContactShape::round;
  ContactLimit limit{contact.name, contact.of, contact.against, to_string(contact.at), action, contact.mark, {},
                     -1,           {}};
  if (round) {
    limit.middle = plain(surface.middle);
    limit.cosine = surface.cosine;
  } else {
    limit.straight = straight_directions(stated, draft.data, plain(C), plain(n));
  }
  if (norm(limit.middle) > 0 || !limit.straight.empty()) draft.machine.contact_limits.push_back(std::move(limit));
  const auto forbid = [&](const Vector3<Scalar>& d) {
    const std::string words = std::string(contact.no_slip                ? "rolling"
                                          : contact.grip == Grip::sticks ? "sticking"
                                                                         : "touching") +
                              " at contact '" + contact.name + "' along " + draft.direction_name(d);
    VelocityConstraint<Scalar>& c = draft.add_constraint(
        round ? VelocityConstraintKind::rolling : VelocityConstraintKind::point, words, on, from, at, d);
    c.action = action;
    c.surface_axis = {from, n};
    c.shape_unknown = unknown;
    if (draft.situation.steady) {
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
  if (contact.no_slip || contact.friction) {
    forbid(t1);
    forbid(t2);
  }
  if (!contact.friction) return;
  // What holds only while it touches, or while it sticks, is kept apart, to see how it parts and slips.
  const std::size_t first = constraints.size() - 3;
  const auto [resting, sliding] = friction_of(draft, contact);
  RoughContactOf<Scalar> rough{contact.name,
                               action,
                               contact.grip,
                               resting,
                               sliding,
                               {from, n},
                               {constraints[first], constraints[first + 1], constraints[first + 2]},
                               {}};
  if (contact.slip) rough.slip = {from, draft.data.direction(*contact.slip)};
  draft.machine.rough_contacts.push_back(std::move(rough));
  const std::size_t held = contact.grip == Grip::sticks ? 3 : contact.grip == Grip::parts ? 0 : 1;
  constraints.resize(first + held);
  draft.machine.constraint_joints.resize(first + held);
}

template <class Scalar>
void add_cord(MachineDraft<Scalar>& draft, const Cord& cord) {
  const int on = draft.body(cord.to), from = draft.body(cord.from);
  const int action = draft.add_action(ActionKind::cord, cord.name, "", on, from);
  const Vector3<Scalar> end = draft.data.place(*cord.end);
  const Place<Scalar> at = draft.machine.place(on, end);
  if (cord.direction) {
    const Vector3<Scalar> d = draft.data.direction(*cord.direction);
    draft.add_component(action, "", false, at, {ground, d}).one_sided = true;
    draft.add_constraint(VelocityConstraintKind::point, "cord '" + cord.name + "' taut", on, from, at, d).action =
        action;
    return;
  }
  const Vector3<Scalar> start = draft.data.place(*cord.at);
  if (!(norm(plain(end - start)) > 0))
    fail(draft.situation.file, cord.mark, "cord '" + cord.name + "' has length zero");
  const Vector3<Scalar> inward = normalized(start - end);
  Component<Scalar>& pull = draft.add_component(action, "", false, at, {ground, inward});
  pull.toward = draft.machine.place(from, start);
  pull.one_sided = true;
  VelocityConstraint<Scalar>& taut =
      draft.add_constraint(VelocityConstraintKind::cord_length, "cord '" + cord.name + "' taut", on, from, at, inward);
  taut.toward = draft.machine.place(from, start);
  taut.length = norm(end - start);
  taut.action = action;
}

template void add_contact(MachineDraft<double>&, const Contact&);
template void add_cord(MachineDraft<double>&, const Cord&);
template void add_contact(MachineDraft<Dual<1>>&, const Contact&);
template void add_cord(MachineDraft<Dual<1>>&, const Cord&);
template void add_contact(MachineDraft<Formula>&, const Contact&);
template void add_cord(MachineDraft<Formula>&, const Cord&);

}  // namespace poinsot::problem
