// The response on the second road: the same shaking of the bodies in redundant coordinates.
#include <algorithm>
#include <cmath>

#include "engine/solve/stability/redundant_pencil.h"
#include "poinsot/engine/solve/stability/response.h"

namespace poinsot::solve {
namespace {

using Index = Eigen::Index;

Place3 part_of(const ComplexVector3& v, bool imaginary) {
  Place3 one;
  for (std::size_t k = 0; k < 3; ++k) one[static_cast<Index>(k)] = imaginary ? v[k].imag() : v[k].real();
  return one;
}

std::vector<double> part_of(const std::vector<std::complex<double>>& x, bool imaginary) {
  std::vector<double> one;
  for (const std::complex<double>& number : x) one.push_back(imaginary ? number.imag() : number.real());
  return one;
}

ComplexVector joined_parts(const Vector& real, const Vector& imaginary) {
  ComplexVector all(real.size());
  for (Index k = 0; k < all.size(); ++k) all[k] = {real[k], imaginary[k]};
  return all;
}

}  // namespace

std::optional<ResponseCheck> check_response(const SteadyMotion& motion, const Excitation& excitation,
                                            const Response& found, double pace) {
  const std::unique_ptr<RedundantBodies> bodies = RedundantBodies::find(motion);
  if (!bodies) return std::nullopt;
  // Differences are taken at the pace of the shaking where that is faster than the motion.
  const double fastest = std::max(pace, excitation.frequency);
  const RedundantPencil pencil(*bodies, motion, fastest);
  ComplexVector f = ComplexVector::Zero(6 * static_cast<Index>(pencil.moving().size())),
                g = ComplexVector::Zero(pencil.gaps_count());
  if (excitation.at.body != ground) {
    const Place3 place = bodies->drawn_place(excitation.at);
    const auto forces = [&](bool imaginary) {
      return pencil.forces_of(excitation.at.body, place, part_of(excitation.force, imaginary),
                              part_of(excitation.couple, imaginary));
    };
    f = joined_parts(forces(false), forces(true));
  }
  if (excitation.coordinate >= 0) {
    const std::optional<std::size_t> gap = bodies->gap_of(excitation.coordinate);
    if (!gap) return std::nullopt;
    g[static_cast<Index>(*gap)] = pencil.gap_of(*gap, excitation.amplitude);
  }
  const ComplexVector x = joined_parts(pencil.displacement(motion, part_of(found.motion.q, false)),
                                       pencil.displacement(motion, part_of(found.motion.q, true)));
  const auto own = pencil.forced(f, g, Real(excitation.frequency) / Real(fastest), x);
  if (!own || own->loose != static_cast<Index>(found.loose.size())) return std::nullopt;
  ResponseCheck check;
  const Real size = std::max(x.norm(), own->x.norm());
  check.apart = static_cast<double>(std::min(Real(1), own->apart));
  if (size > 0) check.misfit = static_cast<double>((x - own->x).norm() / size) * check.apart;
  for (std::size_t m = 0; m < pencil.moving().size(); ++m) {
    ResponseCheck::Need need;
    need.body = static_cast<int>(pencil.moving()[m]);
    const Real unit = Real(fastest) * Real(fastest);
    for (Index k = 0; k < 3; ++k) {
      const std::complex<Real> force = own->needs(k, static_cast<Index>(m)) * unit / Real(motion.length),
                               couple = own->needs(3 + k, static_cast<Index>(m)) * unit;
      need.force[static_cast<std::size_t>(k)] = {static_cast<double>(force.real()), static_cast<double>(force.imag())};
      need.couple[static_cast<std::size_t>(k)] = {static_cast<double>(couple.real()),
                                                  static_cast<double>(couple.imag())};
    }
    check.needs.push_back(need);
  }
  return check;
}

}  // namespace poinsot::solve
