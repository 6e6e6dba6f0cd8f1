#include "poinsot/engine/mass/particles.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "poinsot/engine/mass/principal_axes.h"

namespace poinsot {
namespace {

// With a mean square x_i^2 along each principal axis, I_i/m = x_j^2 + x_k^2; two particles of m/6 at distance d on an
// axis have m d^2/3, so d^2 = 3 x_i^2.
template <class Scalar>
std::vector<Particle<Scalar>> six_particles(const MassProperties<Scalar>& body) {
  if (body.mass == Scalar(0)) return {};
  const PrincipalAxes<Scalar> principal = principal_axes((1 / body.mass) * body.inertia_center);
  const Vector3<Scalar>& moments = principal.moments;
  const Scalar half_trace = (moments.x + moments.y + moments.z) / 2;
  std::vector<Particle<Scalar>> particles;
  for (std::size_t i = 0; i < 3; ++i) {
    const Scalar mean_square = half_trace - moments[i];
    constexpr double rounded_data =
        1e-9;  // of the largest moment, for a flat body whose moments were rounded to ten digits
    if (!(mean_square >= Scalar(-rounded_data) * moments.z) || !std::isfinite(mean_square)) {
      throw std::invalid_argument(
          fmt::format("no particles have the principal moments {:.10g}, {:.10g}, {:.10g} m^2 per unit mass: each must "
                      "be at most the sum of the two others",
                      moments.x, moments.y, moments.z));
    }
    const Vector3<Scalar> d = std::sqrt(3 * std::max(mean_square, Scalar(0))) * principal.axes.column(i);
    particles.push_back({body.mass / 6, body.center + d});
    particles.push_back({body.mass / 6, body.center - d});
  }
  return particles;
}

}  // namespace

std::vector<Particle<double>> equivalent_particles(const MassProperties<double>& body) { return six_particles(body); }
std::vector<Particle<long double>> equivalent_particles(const MassProperties<long double>& body) {
  return six_particles(body);
}

}  // namespace poinsot
