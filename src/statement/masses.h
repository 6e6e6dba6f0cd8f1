// Mass properties of a stated body, and the same body as particles.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "poinsot/mass/mass_properties.h"
#include "poinsot/mass/particle_set.h"
#include "poinsot/statement/data.h"

namespace poinsot::statement {

// Values for what a statement leaves open with `any`: called with the dimension, gives a value in SI.
using AnyValue = std::function<double(const Dimension&)>;

struct BodyMass {
  MassProperties<double> properties;        // on the ground's axes, as drawn
  std::vector<Particle<double>> particles;  // the same body on the independent road
};

// Throws StatementError: negative masses, shapes without extent, inertias that no body can have, wrong dimensions.
// lenient: for trial values of unknowns, negative masses and impossible inertias pass.
BodyMass body_mass(const Body& body, DataScope<double>& data, const AnyValue& any, bool lenient = false);

enum class ContactShape {
  round,    // a circle or sphere of the body
  corner,   // a point fixed in the body
  unknown,  // curved in a way that is not known here: how the point of contact moves cannot be told
  missed,   // the body is round all over, and the point is not on it
};

// How a body touches at a place.
struct RollingSurface {
  ContactShape shape = ContactShape::corner;
  Vector3<double> center{};
  Vector3<double> axis{};  // unit vector; zero for a sphere
  double radius = 0;
  double gap = 0;  // from the place to the surface, m
};
// From the shape of the body whose surface the place C lies on, or from its axis of symmetry.
RollingSurface rolling_surface(const Body& body, DataScope<double>& data, const Vector3<double>& p_OC,
                               const Vector3<double>& center_of_mass);

}  // namespace poinsot::statement
