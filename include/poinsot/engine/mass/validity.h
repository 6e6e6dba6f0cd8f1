// Whether a rigid body with given mass properties can exist.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "poinsot/engine/mass/mass_properties.h"

namespace poinsot {

enum class MassRule {
  finite_values,
  positive_mass,        // a body's mass is not negative
  inertia_needs_mass,   // a massless body has no inertia
  symmetric_tensor,     // only for tensors given as full matrices
  nonnegative_moments,  // every principal moment >= 0
  triangle_inequality,  // no principal moment exceeds the sum of the two others
};

struct InvalidMassReport {
  MassRule rule{};
  std::string message;                // names the body, the rule, the values and by how much it is broken
  double amount = 0;                  // by how much, in the unit of the rule (kg or kg m^2)
  Vector3<double> principal_moments;  // ascending, kg m^2; NaN where they were not computed
};

// The unit in which a message tells moments of inertia.
struct MomentUnit {
  double size = 1;  // kg m^2
  std::string text = "kg m^2";
};

constexpr double usual_tolerance_of_moments = 1e-9;

// Returns nothing if a body with these properties can exist. That includes rods and particles, some of whose moments
// are zero, and thin plates, for which the triangle inequality is an equality. A moment may be short by `tolerance`
// times the largest one.
std::optional<InvalidMassReport> validate(const MassProperties<double>& body, std::string_view name,
                                          double tolerance = usual_tolerance_of_moments, const MomentUnit& unit = {});

// The same for a tensor given with all nine entries, which must also be symmetric to `tolerance` of its largest entry.
std::optional<InvalidMassReport> validate(double mass, const Vector3<double>& center,
                                          const Matrix3<double>& inertia_center, std::string_view name,
                                          double tolerance = usual_tolerance_of_moments, const MomentUnit& unit = {});

}  // namespace poinsot
