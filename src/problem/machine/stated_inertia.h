// The inertia that a statement gives a body by numbers: a matrix, moments and products, or radii of gyration.
#pragma once

#include <string>

#include "poinsot/engine/math/algebra/matrix3.h"
#include "poinsot/engine/math/algebra/vector3.h"
#include "problem/machine/data.h"
#include "problem/machine/masses.h"

namespace poinsot::problem {

// Whose inertia it is, with the values of the statement and of what it leaves open.
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
