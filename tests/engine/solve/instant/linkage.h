// Loops of a few bodies that a pin closes.
#pragma once

#include <string>
#include <vector>

#include "poinsot/engine/model/builder.h"
#include "poinsot/engine/solve/instant/closure.h"

namespace poinsot::solve {

using Vector = Vector3<double>;

struct Linkage {
  ModelBuilder<double> builder;
  Mechanism<double> mechanism;

  int add(const std::string& name, int parent, const Joint<double>& joint, const Vector& at) {
    return builder.add_body(name, parent, joint, SpatialTransform<double>::translation(at), MassProperties<double>{});
  }
  // Holds two points together in the plane x, y of the second body.
  void pin(const Place<double>& at, const Place<double>& toward) {
    mechanism.tree = builder.build();
    mechanism.takes_part.assign(3, true);
    mechanism.coordinate_names.assign(3, "v");
    for (std::size_t k = 0; k < 2; ++k) {
      VelocityConstraint<double> c;
      c.kind = VelocityConstraintKind::point;
      c.words = "pin";
      c.on = at.body;
      c.from = toward.body;
      c.at = at;
      c.toward = toward;
      c.along = {toward.body, Vector::unit(k)};
      mechanism.constraints.push_back(c);
    }
  }
  // What is left open when one coordinate has a rate, and the rates then.
  LinearSolution with_rate(const std::vector<double>& q, std::size_t coordinate, double rate) const {
    MechanismState state(mechanism);
    state.set_positions(q);
    Condition given;
    given.coefficients.assign(3, 0.0);
    given.coefficients[coordinate] = 1;
    given.value = rate;
    return velocity_equations(state, natural_scales(mechanism), {given}).solve();
  }
};

}  // namespace poinsot::solve
