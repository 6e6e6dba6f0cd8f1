// The table of shapes: one row for each kind, with all that depends on the kind.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "poinsot/engine/mass/outlines.h"
#include "problem/machine/round_surface.h"
#include "problem/machine/shape_arguments.h"
#include "problem/machine/shapes.h"

namespace poinsot::problem {

// A straight part of a surface by its corners: a particle has one, an edge two, a flat side at least three.
using Side = std::vector<Vector3<double>>;

// What a shape can touch with beside the round surface and the straight sides that its row names.
enum class OtherSurface {
  none,     // it is round all over
  corners,  // points fixed in the body: edges, ends
  curved    // in a way that is not known here
};

template <class Scalar>
struct ShapeRow {
  std::string_view words;  // what worked solutions call it, after "a"
  Outline (*picture)(const ShapeArguments<Scalar>&) = nullptr;
  // Closed form and particles.
  ShapeValues<Scalar> (*values)(const ShapeArguments<Scalar>&) = nullptr;
  OtherSurface other = OtherSurface::corners;
  // Null where it has none.
  RoundSurface<Scalar> (*round)(const ShapeArguments<Scalar>&) = nullptr;
  std::vector<Side> (*sides)(const ShapeArguments<Scalar>&) = nullptr;
};

// kind: of a shape that the reader knows. Scalar: double, Dual<1> or a formula.
template <class Scalar>
const ShapeRow<Scalar>& shape_row(const std::string& kind);

}  // namespace poinsot::problem
