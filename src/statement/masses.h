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
  MassProperties<double> properties;          // on the ground's axes, as drawn
  std::vector<Particle<double>> particles;    // the same body on the independent road
};

// Throws StatementError: negative masses, shapes without extent, inertias that no body can have, wrong dimensions.
BodyMass body_mass(const Body& body, DataScope<double>& data, const AnyValue& any);

// The circle or sphere on which a body rolls at the place C.
struct RollingSurface {
  Vector3<double> center;
  Vector3<double> axis;    // unit vector; zero for a sphere
  double radius = 0;
};
// From the shapes of revolution of the body, or from its axis of symmetry; nothing if it has none.
std::optional<RollingSurface> rolling_surface(const Body& body, DataScope<double>& data, const Vector3<double>& p_OC,
                                              const Vector3<double>& center_of_mass);

}  // namespace poinsot::statement
