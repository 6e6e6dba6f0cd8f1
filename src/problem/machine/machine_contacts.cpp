// The contacts of a machine.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>

#include "poinsot/engine/math/algebra/plain.h"
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

}  // namespace

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

template void add_contact(MachineDraft<double>&, const Contact&);
template void add_contact(MachineDraft<Dual<1>>&, const Contact&);
template void add_contact(MachineDraft<Formula>&, const Contact&);

}  // namespace poinsot::problem
