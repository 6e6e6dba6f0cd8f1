// The mass properties of the parts of a body.
#pragma once

#include <vector>

#include "poinsot/engine/mass/mass_properties.h"
#include "problem/machine/data.h"

namespace poinsot::problem {

// The parts one by one, as drawn, on the axes of the ground: first those under parts: (a body known by numbers counts
// as one), then what is added to it, then particles that stay in it after a blow. A hole has negative mass. The
// scalar is double or Formula. Throws StatementError if a value is given as `any`, and what body_mass (masses.h)
// throws.
template <class Scalar>
std::vector<MassProperties<Scalar>> part_masses(const Body& body, DataScope<Scalar>& data);

}  // namespace poinsot::problem
