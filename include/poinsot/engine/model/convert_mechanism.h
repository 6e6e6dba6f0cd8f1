// Converts a mechanism to another scalar.
#pragma once

#include <utility>

#include "poinsot/engine/model/mechanism.h"

namespace poinsot {

// The same mechanism with every number converted by a function from Source to Target.
template <class Target, class Source, class Convert>
Mechanism<Target> convert_mechanism(const Mechanism<Source>& source, Convert convert) {
  const auto vector = [&](const Vector3<Source>& a) { return detail::converted<Target>(a, convert); };
  const auto place = [&](const Place<Source>& a) { return Place<Target>{a.body, vector(a.point)}; };
  const auto direction = [&](const Direction<Source>& a) { return Direction<Target>{a.body, vector(a.vector)}; };

  Mechanism<Target> target;
  std::vector<Body<Target>> bodies;
  for (const Body<Source>& body : source.tree.bodies()) bodies.push_back(detail::converted<Target>(body, convert));
  target.tree =
      Model<Target>(std::move(bodies), source.tree.names(), source.tree.modes(), vector(source.tree.gravity()));
  target.takes_part = source.takes_part;
  target.coordinate_names = source.coordinate_names;
  target.actions = source.actions;
  for (const Component<Source>& c : source.components) {
    Component<Target> component{
        c.action, c.axis, c.couple, c.one_sided, place(c.at), direction(c.along), {}, convert(c.couple_per_force)};
    if (c.toward) component.toward = place(*c.toward);
    target.components.push_back(std::move(component));
  }
  for (const VelocityConstraint<Source>& c : source.constraints) {
    VelocityConstraint<Target> constraint;
    constraint.kind = c.kind;
    constraint.shape_unknown = c.shape_unknown;
    constraint.carried_by = c.carried_by;
    constraint.carried_along = c.carried_along;
    constraint.action = c.action;
    constraint.words = c.words;
    constraint.on = c.on;
    constraint.from = c.from;
    constraint.at = place(c.at);
    constraint.along = direction(c.along);
    constraint.toward = place(c.toward);
    constraint.length = convert(c.length);
    constraint.normal = c.normal;
    constraint.center = vector(c.center);
    constraint.axis = vector(c.axis);
    constraint.radius = convert(c.radius);
    constraint.surface_axis = direction(c.surface_axis);
    target.constraints.push_back(std::move(constraint));
  }
  for (const KnownForce<Source>& f : source.forces)
    target.forces.push_back({f.action, f.couple, place(f.at), vector(f.vector), f.axes});
  for (const SpringLaw<Source>& s : source.springs)
    target.springs.push_back(
        {s.action, place(s.at), place(s.toward), convert(s.stiffness), convert(s.free_length), convert(s.damping)});
  for (const Drive<Source>& d : source.drives) {
    Drive<Target> drive;
    drive.action = d.action;
    drive.coordinate = d.coordinate;
    drive.position = d.position;
    drive.turning = d.turning;
    drive.at = place(d.at);
    drive.along = direction(d.along);
    for (const Direction<Source>& other : d.others) drive.others.push_back(direction(other));
    drive.held = d.held;
    drive.effort = convert(d.effort);
    drive.stiffness = convert(d.stiffness);
    drive.free_position = convert(d.free_position);
    drive.damping = convert(d.damping);
    target.drives.push_back(std::move(drive));
  }
  return target;
}

}  // namespace poinsot
