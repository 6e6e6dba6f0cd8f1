// Converts a mechanism to another scalar.
#pragma once

#include <utility>
#include <vector>

#include "poinsot/engine/dynamics/mechanism.h"

namespace poinsot {

// The same mechanism with every number converted by a function from Source to Target.
template <class Target, class Source, class Convert>
Mechanism<Target> convert_mechanism(const Mechanism<Source>& source, Convert convert) {
  const LawConverter<Target, Convert> to{convert};

  Mechanism<Target> target;
  std::vector<Body<Target>> bodies;
  for (const Body<Source>& body : source.tree.bodies()) bodies.push_back(detail::converted<Target>(body, convert));
  target.tree = Model<Target>(std::move(bodies), source.tree.names(), source.tree.modes(), to(source.tree.gravity()));
  target.takes_part = source.takes_part;
  target.coordinate_names = source.coordinate_names;
  target.actions = source.actions;
  for (const Component<Source>& c : source.components) {
    Component<Target> component;
    component.action = c.action;
    component.axis = c.axis;
    component.couple = c.couple;
    component.one_sided = c.one_sided;
    component.at = to(c.at);
    component.along = to(c.along);
    component.couple_per_force = to(c.couple_per_force);
    if (c.toward) component.toward = to(*c.toward);
    if (c.span) component.span = c.span->template converted<Target>(to);
    component.follows = c.follows;
    component.part = to(c.part);
    component.offset = to(c.offset);
    component.gain = to(c.gain);
    component.wrap = to(c.wrap);
    component.parts_wheels = c.parts_wheels;
    component.flank = c.flank;
    component.rubs = c.rubs;
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
    constraint.at = to(c.at);
    constraint.along = to(c.along);
    constraint.toward = to(c.toward);
    constraint.length = to(c.length);
    constraint.normal = c.normal;
    constraint.center = to(c.center);
    constraint.axis = to(c.axis);
    constraint.radius = to(c.radius);
    constraint.surface_axis = to(c.surface_axis);
    for (const CordSpan<Source>& span : c.spans) constraint.spans.push_back(span.template converted<Target>(to));
    constraint.keeps_length = c.keeps_length;
    if (c.surfaces) {
      const auto surface = [&](const ContactSurface<Source>& s) { return converted_surface<Target>(s, to, to, to); };
      const CurvedContact<Source>& both = *c.surfaces;
      constraint.surfaces = std::make_shared<const CurvedContact<Target>>(
          CurvedContact<Target>{surface(both.on), surface(both.from), surface(both.shape_on), surface(both.shape_from),
                                both.branch, to(both.normal), to(both.tangent)});
    }
    target.constraints.push_back(std::move(constraint));
  }
  for (const Drive<Source>& drive : source.drives) target.drives.push_back(drive.template converted<Target>(to));
  for_each_law_list(
      [&](const auto& laws, auto& converted) {
        for (const auto& law : laws) converted.push_back(law.template converted<Target>(to));
      },
      source, target);
  return target;
}

}  // namespace poinsot
