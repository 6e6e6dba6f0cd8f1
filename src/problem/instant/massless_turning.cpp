#include "problem/instant/massless_turning.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "poinsot/engine/mass/principal_axes.h"
#include "problem/instant/instant.h"

namespace poinsot::problem {
namespace {

// As a part of the moment of inertia about other axes: rods have some 1e-16 about their own line, wires of a metre and
// a micrometre 1e-11.
constexpr double no_inertia = 1e-12;

double dot_product(const std::vector<double>& a, const std::vector<double>& b) {
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

}  // namespace

void reduce_components(const std::vector<std::vector<double>>& directions, std::vector<double>& v, double part) {
  for (const std::vector<double>& direction : directions) {
    const double along = dot_product(v, direction);
    for (std::size_t k = 0; k < v.size(); ++k) v[k] -= (1 - part) * along * direction[k];
  }
}

std::vector<std::vector<double>> take_massless(const Machine& machine, std::vector<std::vector<double>>& open) {
  std::vector<std::vector<double>> massless;
  if (open.empty()) return massless;
  MechanismDynamics dynamics(machine.mechanism);
  std::erase_if(open, [&](const std::vector<double>& direction) {
    double size = 0;
    for (std::size_t k = 0; k < direction.size(); ++k) {
      if (direction[k] == 0) continue;
      std::vector<double> one(direction.size());
      one[k] = direction[k];
      size += dynamics.kinetic_energy(machine.q, one);
    }
    if (dynamics.kinetic_energy(machine.q, direction) > no_inertia * size) return false;
    std::vector<double> rest = direction;
    reduce_components(massless, rest);
    const double length = std::sqrt(dot_product(rest, rest));
    for (double& component : rest) component /= length;
    massless.push_back(std::move(rest));
    return true;
  });
  return massless;
}

std::optional<MasslessSpin> massless_spin(const Machine& machine, int coordinate) {
  for (const auto& body : machine.mechanism.tree.bodies()) {
    const bool turning = body.joint == JointType::ball || body.joint == JointType::free;
    if (!turning || coordinate < body.v || coordinate >= body.v + 3) continue;
    const PrincipalAxes<double> principal = principal_axes(body.inertia.inertia);
    const Vector3<double>& moments = principal.moments;
    if (!(moments.x <= no_inertia * moments.z) || moments.y <= no_inertia * moments.z) return std::nullopt;
    MasslessSpin spin{static_cast<std::size_t>(body.v), principal.axes.column(0)};
    // Other bodies may be attached to this one and be moved by its turning.
    std::vector<double> v(static_cast<std::size_t>(machine.mechanism.tree.velocity_size()));
    for (std::size_t k = 0; k < 3; ++k) v[spin.first + k] = spin.axis[k];
    spin.alone = MechanismDynamics(machine.mechanism).kinetic_energy(machine.q, v) <= no_inertia * moments.z;
    return spin;
  }
  return std::nullopt;
}

bool turns_particle(const Machine& machine, int coordinate) {
  const auto& bodies = machine.mechanism.tree.bodies();
  const auto turned = std::ranges::find_if(
      bodies, [&](const auto& body) { return body.joint == JointType::revolute && body.v == coordinate; });
  if (turned == bodies.end()) return false;
  const int index = static_cast<int>(turned - bodies.begin());
  if (std::ranges::any_of(bodies, [&](const auto& body) { return body.parent == index; })) return false;
  // The working axes have their z along the axis of the joint.
  const SpatialInertia<double>& I = turned->inertia;
  if (!(I.mass > 0)) return false;
  const Vector3<double> center = I.first_moment / I.mass;
  const SymmetricMatrix3<double> own = shifted(I, -center).inertia;
  const double length = MechanismDynamics(machine.mechanism).natural_length();
  return own.xx + own.yy + own.zz <= no_inertia * I.mass * length * length &&
         std::hypot(center.x, center.y) <= no_inertia * length;
}

std::optional<int> massless_coordinate(const Machine& machine, const std::vector<OpenCoordinate>& open) {
  std::optional<int> best;
  double most = 0;
  for (const OpenCoordinate& one : open) {
    if (!one.without_inertia) continue;
    const std::optional<MasslessSpin> spin = massless_spin(machine, one.coordinate);
    const double part = spin ? std::abs(spin->axis[static_cast<std::size_t>(one.coordinate) - spin->first])
                             : turns_nothing(machine, one.coordinate) || turns_particle(machine, one.coordinate);
    if (part <= most) continue;
    most = part;
    best = one.coordinate;
  }
  return best;
}

std::vector<solve::UnseenMotion> unseen_motions(const Mechanism<double>& mechanism, const std::vector<double>& q,
                                                const std::vector<int>& held) {
  std::vector<int> coordinates;
  for (const OpenCoordinate& open : MechanismDynamics(mechanism, held).open_coordinates(q))
    if (open.without_inertia) coordinates.push_back(open.coordinate);
  return solve::unseen_motions(mechanism, q, coordinates);
}

void take_out(const MasslessSpin& spin, std::span<double> accelerations) {
  const Vector3<double> all{accelerations[spin.first], accelerations[spin.first + 1], accelerations[spin.first + 2]};
  const Vector3<double> rest = all - dot(all, spin.axis) * spin.axis;
  for (std::size_t k = 0; k < 3; ++k) accelerations[spin.first + k] = rest[k];
}

}  // namespace poinsot::problem
