// The parts of which a stated body is put together.
#pragma once

#include <vector>

#include "poinsot/engine/mass/mass_properties.h"
#include "problem/machine/data.h"

namespace poinsot::problem {

// Each by itself, as drawn, on the ground's axes: those under parts: (of a body known by numbers the body), then what
// is added to it, then particles that stay in it after a blow; a hole has negative mass. Scalar: double or Formula.
// Throws StatementError where a value is given as `any`, and what body_mass (masses.h) throws.
template <class Scalar>
std::vector<MassProperties<Scalar>> part_masses(const Body& body, DataScope<Scalar>& data);

}  // namespace poinsot::problem
