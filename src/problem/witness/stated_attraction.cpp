#include "problem/witness/stated_attraction.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "problem/witness/stated_motion.h"
#include "problem/witness/stated_springs.h"

namespace poinsot::problem {
namespace {

using Real = StatedAttraction::Real;
using Vector = StatedAttraction::Vector;

// A series in the distance from the center of the particles, up to the second power.
using Series = std::array<Real, 3>;

// |a + s d|^(2 p) by powers of s, from the recurrence for a power of a series: with b the series of the square and g
// that of its power, k b_0 g_k = sum over j of (p j - (k - j)) b_j g_(k-j).
Series power_of_square(const Vector& a, const Vector& d, Real p) {
  const Series b{dot(a, a), 2 * dot(a, d), dot(d, d)};
  const Real first = std::pow(b[0], p), second = p * b[1] * first / b[0];
  return {first, second, ((p - 1) * b[1] * second + 2 * p * b[2] * first) / (2 * b[0])};
}

}  // namespace

std::optional<StatedAttraction> stated_attraction(const solve::ParticlePaths& paths, const Machine& machine,
                                                  DataScope<double>& data, std::size_t body) {
  const Situation& situation = data.situation();
  const auto& [link, mass] = machine.masses[body];
  if (!situation.central_gravity || mass.particles.empty()) return std::nullopt;
  const Vector O = widened(data.place(situation.central_gravity->toward));
  const Real mu = data.number(situation.central_gravity->parameter, dimensions::gravitational_parameter);
  // Twenty units in the last place, of which a hundred-millionth of a size is to be seen.
  constexpr Real rounding = 20 * std::numeric_limits<double>::epsilon() / 1e-8L;
  // Of the particles by their ways from the first of them as drawn, whose differences lose nothing however far they are
  // from the origin.
  const Vector drawn = widened(mass.particles.front().position);
  const Matrix3<Real> turn = paths.turn(link);
  struct Weighed {
    Real mass = 0;
    Vector way = Vector::zero();  // the sum of m x, then the center
    void add(Real m, const Vector& x) {
      mass += m;
      way += m * x;
    }
  };
  std::vector<Vector> ways;
  Weighed all;
  for (const Particle<double>& one : mass.particles) {
    ways.push_back(turn * Vector(widened(one.position) - drawn));
    all.add(one.mass, ways.back());
  }
  if (!(all.mass > 0)) return std::nullopt;
  const Vector center = all.way / all.mass;
  StatedAttraction whole;
  whole.at = paths.place(link, drawn) + center;
  const Vector from_O = whole.at - O;
  std::size_t first = 0;
  for (const PulledPart<double>& part : mass.pulled) {
    const std::size_t last = first + part.particles;
    if (last > ways.size()) return std::nullopt;
    Weighed own;
    const std::size_t begin = std::exchange(first, last);
    for (std::size_t i = begin; i < last; ++i) own.add(mass.particles[i].mass, ways[i]);
    if (own.mass == 0) continue;
    const Vector C = own.way / own.mass, arm = C - center, a = from_O + arm;
    Vector force = Vector::zero(), couple = Vector::zero();
    const auto add = [&](Real m, const Vector& d) {
      const Series falls = power_of_square(a, d, -1.5L), depth = power_of_square(a, d, -0.5L);
      const Vector along = falls[0] * a, across = falls[1] * a + falls[0] * d;
      force -= (mu * m) * Vector(along + across + falls[2] * a + falls[1] * d);
      couple -= (mu * m) * cross(d, Vector(along + across));
      whole.energy -= mu * m * (depth[0] + depth[1] + depth[2]);
    };
    if (part.by_moments)
      for (std::size_t i = begin; i < last; ++i) add(mass.particles[i].mass, ways[i] - C);
    else
      add(own.mass, Vector::zero());
    whole.force += force;
    whole.couple += couple + cross(arm, force);
    // The centers of several parts, each by itself, are drawn with the rounding of their places.
    if (mass.pulled.size() > 1) whole.couple_size += rounding * (norm(arm) + norm(drawn)) * norm(force);
  }
  Real spread = 0, drawn_far = 0, near = 0;
  for (std::size_t i = 0; i < ways.size(); ++i) {
    const Vector arm = ways[i] - center;
    const Real m = std::abs(Real(mass.particles[i].mass));
    spread += m * norm_squared(arm);
    drawn_far += m * norm(arm) * norm(widened(mass.particles[i].position));
    near = std::max(near, 1 / norm(Vector(from_O + arm)));
  }
  whole.couple_size += 3 * mu * near * near * near * (spread + rounding * drawn_far);
  return whole;
}

StatedPotential stated_potential(const solve::ParticlePaths& paths, const Machine& machine, DataScope<double>& data,
                                 int body, bool rate) {
  StatedPotential sum;
  for (std::size_t i = 0; i < machine.masses.size(); ++i) {
    const int link = machine.masses[i].first;
    if (body >= 0 && link != body) continue;
    const std::optional<StatedAttraction> pull = stated_attraction(paths, machine, data, i);
    if (!pull) continue;
    const Real brought = rate ? -dot(pull->force, paths.velocity(link, pull->at, -1)) -
                                    dot(pull->couple, paths.angular_velocity(link, -1))
                              : pull->energy;
    sum.value += brought;
    sum.size += rate ? std::abs(pull->energy) * paths.pace() : std::abs(brought);
  }
  return sum;
}

}  // namespace poinsot::problem
