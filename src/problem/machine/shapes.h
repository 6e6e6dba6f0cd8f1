// The closed form and the particles of a shape, and errors in its arguments.
#pragma once

#include <string>

#include "poinsot/engine/mass/outlines.h"
#include "poinsot/engine/mass/particle_set.h"
#include "poinsot/engine/mass/shape_properties.h"
#include "problem/machine/data.h"

namespace poinsot::problem {

enum class Extent { point, length, area, volume };

template <class Scalar>
struct ShapeValues {
  Extent extent = Extent::point;
  ShapeProperties<Scalar> properties;
  ParticleSet<double> particles;  // empty when they are not wanted
};

// owner: the name of the body or part in messages. particles: whether they are wanted. The scalar is double, Dual<1>
// or Formula. Throws StatementError for missing arguments, wrong dimensions and impossible shapes
// (poinsot/engine/mass/shape_faults.h).
template <class Scalar>
ShapeValues<Scalar> shape_values(const Shape& shape, DataScope<Scalar>& data, const std::string& owner, bool particles);

// What is drawn of a shape. Throws StatementError as shape_values does.
Outline shape_picture(const Shape& shape, DataScope<double>& data, const std::string& owner);

// The value of an argument of the shape; throws if it is missing.
const Expression& shape_argument(const Shape& shape, const std::string& name, const std::string& file);

}  // namespace poinsot::problem
