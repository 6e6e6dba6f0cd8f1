// Uses installed headers (a template) and the installed library (principal axes); exits with 1 if an answer is wrong.
#include <poinsot/engine/mass/mass_properties.h>
#include <poinsot/engine/mass/principal_axes.h>

#include <cmath>
#include <cstdio>

int main() {
  // A particle of 2 kg at 3 m from the origin on x, about the origin: 0, 18, 18 kg m^2.
  const poinsot::MassProperties<double> particle{2.0, {3.0, 0.0, 0.0}, {}};
  const auto inertia = inertia_about(particle, poinsot::Vector3<double>::zero());
  const auto principal = poinsot::principal_axes(inertia);
  std::printf("principal moments %g %g %g kg m^2\n", principal.moments.x, principal.moments.y, principal.moments.z);
  const bool right = std::abs(principal.moments.x) < 1e-12 && std::abs(principal.moments.y - 18) < 1e-12 &&
                     std::abs(principal.moments.z - 18) < 1e-12;
  return right ? 0 : 1;
}
