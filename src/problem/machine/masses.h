// The mass properties of a body, and the same body as particles.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "poinsot/engine/mass/mass_properties.h"
#include "poinsot/engine/mass/particle_set.h"
#include "poinsot/engine/mass/validity.h"
#include "poinsot/engine/math/algebra/matrix3.h"
#include "problem/machine/data.h"

namespace poinsot::problem {

// Gives values for what is left open by `any`: a value in SI units for each dimension.
using AnyValue = std::function<double(const Dimension&)>;

// A part of a body that the gravity of a center pulls by itself.
template <class Scalar>
struct PulledPart {
  MassProperties<Scalar> properties;
  const Part* stated = nullptr;  // null for a body known by numbers
  bool by_moments = false;       // else as a particle: it is one, or a sphere, or known by its mass alone
  std::size_t particles = 0;     // how many of those of the body are its own
};

template <class Scalar>
struct BodyMassOf {
  MassProperties<Scalar> properties;         // on the axes of the ground, as drawn
  Vector3<Scalar> center;                    // of mass, before particles were absorbed
  std::vector<Particle<double>> particles;   // the same body for the check; only for doubles, and if wanted
  std::vector<PulledPart<Scalar>> pulled{};  // under the gravity of a center alone; they refer to the body
};
using BodyMass = BodyMassOf<double>;

// The scalar is double, Dual<1> or Formula. lenient: negative masses and impossible inertias are accepted, as
// unknowns have trial values. particles: whether they are wanted then too. Throws StatementError for negative masses,
// shapes without extent, inertias that no body can have, and wrong dimensions.
template <class Scalar>
BodyMassOf<Scalar> body_mass(const Body& body, DataScope<Scalar>& data, const AnyValue& any, bool lenient = false,
                             bool particles = false);

// The unit in which messages tell moments of inertia: that of the file.
MomentUnit moment_unit(const Situation& situation);

// The parts one by one, as drawn, on the axes of the ground: first those under parts: (a body known by numbers counts
// as one), then what is added to it, then particles that stay in it after a blow. A hole has negative mass. The
// scalar is double or Formula. Throws StatementError if a value is given as `any`, and what body_mass (masses.h)
// throws.
template <class Scalar>
std::vector<MassProperties<Scalar>> part_masses(const Body& body, DataScope<Scalar>& data);

// The inertia that a statement gives a body by numbers: a matrix, moments and products, or radii of gyration. Whose it
// is, with the values of the statement and of what it leaves open.
template <class Scalar>
struct InertiaSource {
  const std::string& body;
  DataScope<Scalar>& data;
  const AnyValue& any;
};

// On the ground's axes, about the point that the statement names (the mass center when it names none). What is stated
// as `any` becomes such as a body with the rest can have. Throws StatementError.
template <class Scalar>
SymmetricMatrix3<Scalar> stated_tensor(const StatedInertia& inertia, const Scalar& mass, const Vector3<Scalar>& center,
                                       const InertiaSource<Scalar>& source);

}  // namespace poinsot::problem
