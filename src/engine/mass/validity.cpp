#include "poinsot/engine/mass/validity.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "poinsot/engine/mass/principal_axes.h"

namespace poinsot {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr Vector3<double> no_moments{nan, nan, nan};

std::string quoted(std::string_view name) { return fmt::format("body '{}'", name); }

// The first value that is not finite, by name.
std::optional<InvalidMassReport> non_finite(std::initializer_list<std::pair<const char*, double>> values,
                                            std::string_view name) {
  for (const auto& [what, value] : values) {
    if (!std::isfinite(value)) {
      return InvalidMassReport{
          MassRule::finite_values,
          fmt::format("{}: {} is {}; every mass property must be a finite number", quoted(name), what, value), nan,
          no_moments};
    }
  }
  return std::nullopt;
}

// The moments to speak of: those about the given axes if these are principal, else the principal ones.
struct NamedMoments {
  std::array<const char*, 3> names;
  Vector3<double> values;
  std::string explanation;
};

NamedMoments named_moments(const SymmetricMatrix3<double>& inertia, const Vector3<double>& principal, double tolerance,
                           const MomentUnit& unit) {
  const double off_diagonal = std::max({std::abs(inertia.xy), std::abs(inertia.yz), std::abs(inertia.zx)});
  const double largest = std::max({std::abs(inertia.xx), std::abs(inertia.yy), std::abs(inertia.zz)});
  if (off_diagonal <= tolerance * largest) return {{"I_x", "I_y", "I_z"}, {inertia.xx, inertia.yy, inertia.zz}, ""};
  return {
      {"I_1", "I_2", "I_3"},
      principal,
      fmt::format(" (principal moments of I_x = {:.10g}, I_y = {:.10g}, I_z = {:.10g}, I_xy = {:.10g}, I_yz = "
                  "{:.10g}, I_zx = {:.10g} {})",
                  inertia.xx / unit.size, inertia.yy / unit.size, inertia.zz / unit.size, (0 - inertia.xy) / unit.size,
                  (0 - inertia.yz) / unit.size, (0 - inertia.zx) / unit.size, unit.text)};
}

std::string short_by(double amount, const MomentUnit& unit) {
  return fmt::format("short by {:.4g} {}", amount / unit.size, unit.text);
}

}  // namespace

std::optional<InvalidMassReport> validate(const MassProperties<double>& body, std::string_view name, double tolerance,
                                          const MomentUnit& unit) {
  const SymmetricMatrix3<double>& inertia = body.inertia_center;
  if (auto report = non_finite({{"the mass", body.mass},
                                {"the x coordinate of the mass center", body.center.x},
                                {"the y coordinate of the mass center", body.center.y},
                                {"the z coordinate of the mass center", body.center.z},
                                {"the moment of inertia I_x", inertia.xx},
                                {"the moment of inertia I_y", inertia.yy},
                                {"the moment of inertia I_z", inertia.zz},
                                {"the product of inertia I_xy", -inertia.xy},
                                {"the product of inertia I_yz", -inertia.yz},
                                {"the product of inertia I_zx", -inertia.zx}},
                               name)) {
    return report;
  }
  if (body.mass < 0) {
    return InvalidMassReport{
        MassRule::positive_mass,
        fmt::format(
            "{}: the mass is {:.10g} kg; a body's mass must not be negative (only a hole in a larger body has a "
            "negative mass)",
            quoted(name), body.mass),
        -body.mass, no_moments};
  }
  const Vector3<double> principal = principal_axes(inertia).moments;
  const double largest = std::max(std::abs(principal.x), std::abs(principal.z));
  if (body.mass == 0) {
    if (largest == 0) return std::nullopt;
    return InvalidMassReport{
        MassRule::inertia_needs_mass,
        fmt::format("{}: the mass is zero but the largest principal moment of inertia is {:.10g} {}; give a mass, or "
                    "no inertia",
                    quoted(name), largest / unit.size, unit.text),
        largest, principal};
  }

  const NamedMoments moments = named_moments(inertia, principal, tolerance, unit);
  for (std::size_t i = 0; i < 3; ++i) {
    if (moments.values[i] < -tolerance * largest) {
      return InvalidMassReport{
          MassRule::nonnegative_moments,
          fmt::format("{}: no rigid body has these moments: {} >= 0 is broken: {:.10g} < 0 {} ({}){}", quoted(name),
                      moments.names[i], moments.values[i] / unit.size, unit.text, short_by(-moments.values[i], unit),
                      moments.explanation),
          -moments.values[i], principal};
    }
  }
  for (std::size_t i = 0; i < 3; ++i) {
    // The two others in their usual order.
    const std::size_t j = i == 0 ? 1 : 0;
    const std::size_t k = i == 2 ? 1 : 2;
    const double shortage = moments.values[i] - (moments.values[j] + moments.values[k]);
    if (shortage > tolerance * largest) {
      return InvalidMassReport{
          MassRule::triangle_inequality,
          fmt::format("{}: no rigid body has these moments: {} + {} >= {} is broken: {:.10g} + {:.10g} < {:.10g} {} "
                      "({}){}",
                      quoted(name), moments.names[j], moments.names[k], moments.names[i], moments.values[j] / unit.size,
                      moments.values[k] / unit.size, moments.values[i] / unit.size, unit.text, short_by(shortage, unit),
                      moments.explanation),
          shortage, principal};
    }
  }
  return std::nullopt;
}

std::optional<InvalidMassReport> validate(double mass, const Vector3<double>& center,
                                          const Matrix3<double>& inertia_center, std::string_view name,
                                          double tolerance, const MomentUnit& unit) {
  double largest = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) largest = std::max(largest, std::abs(inertia_center(i, j)));
  }
  constexpr std::array<const char*, 3> axis{"x", "y", "z"};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = i + 1; j < 3; ++j) {
      const double upper = inertia_center(i, j);
      const double lower = inertia_center(j, i);
      const double difference = std::abs(upper - lower);
      if (difference > tolerance * largest) {
        return InvalidMassReport{
            MassRule::symmetric_tensor,
            fmt::format("{}: a tensor of inertia is symmetric, but its entry {}{} is {:.10g} and {}{} is {:.10g} {} "
                        "(they differ by {:.4g})",
                        quoted(name), axis[i], axis[j], upper / unit.size, axis[j], axis[i], lower / unit.size,
                        unit.text, difference / unit.size),
            difference, no_moments};
      }
    }
  }
  return validate(MassProperties<double>{mass, center, symmetric_part(inertia_center)}, name, tolerance, unit);
}

}  // namespace poinsot
