// A stated shape with values: closed form, particles, and what is wrong with it.
#pragma once

#include <optional>
#include <string>

#include "poinsot/mass/particle_set.h"
#include "poinsot/mass/shape_properties.h"
#include "poinsot/statement/data.h"

namespace poinsot::statement {

enum class Extent { point, length, area, volume };

struct ShapeValues {
  Extent extent = Extent::point;
  ShapeProperties<double> properties;
  ParticleSet<double> particles;
};

// owner: the body or part, named in messages. Throws StatementError for missing arguments, wrong dimensions and shapes
// that no body has (poinsot/mass/shape_faults.h).
ShapeValues shape_values(const Shape& shape, DataScope<double>& data, const std::string& owner);

// The value of an argument of the shape; throws if it is missing.
const Expression& shape_argument(const Shape& shape, const std::string& name, const std::string& file);

}  // namespace poinsot::statement
