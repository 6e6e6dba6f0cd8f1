#include "poinsot/engine/solve/instant/particle_check.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "engine/solve/instant/drawn_motion.h"
#include "poinsot/engine/work/work.h"

namespace poinsot::solve {
namespace {

using drawn::Displacement;
using drawn::Real;
using drawn::Vector;
using drawn::widened;

constexpr Work of_a_particle = 500;

// std::max would lose a NaN; this keeps it.
Real larger(Real a, Real b) { return std::isnan(a) || a > b ? a : b; }

// A misfit over the size of its terms. What is not a number counts as infinite. What is told in doubles has no digits
// below the smallest of these that has all: what a damper has left of a speed long ago, squared.
Real ratio(Real misfit, Real size) {
  if (!std::isfinite(misfit) || !std::isfinite(size)) return std::numeric_limits<Real>::infinity();
  if (misfit <= std::numeric_limits<double>::min()) return 0;
  return size > 0 ? misfit / size : misfit > 0 ? 1 : 0;
}

// A weighted derivative of what is taken along, by central differences.
struct Differences {
  Vector first = Vector::zero(), second = Vector::zero();
  void add(std::size_t j, const Vector& ahead, const Vector& behind, Real h) {
    first += drawn::first_weights[j - 1] / h * (ahead - behind);
    second += drawn::second_weights[j - 1] / (h * h) * (ahead + behind);
  }
};

// The largest misfit of the angular momentum about the mass center and of its rate, beside what the motion's own pace
// would make of them. The arms from the mass center are turned by themselves: beside a way of millions of kilometres
// they would be lost.
Real misfit_within(const CheckBody& body, const std::array<std::vector<Displacement>, 9>& at, Real h, Real pace) {
  const auto link = static_cast<std::size_t>(body.link);
  Real mass = 0;
  Vector way = Vector::zero();
  for (const auto& particle : body.particles) {
    mass += Real(particle.mass);
    way += Real(particle.mass) * widened(particle.position);
  }
  if (!(mass > 0)) return 0;
  const Vector center = way / mass;
  Vector H = Vector::zero(), M = Vector::zero();
  Real spread = 0, drawn_far = 0;
  for (const auto& particle : body.particles) {
    const Real m = particle.mass;
    const Vector place = widened(particle.position), drawn_arm = place - center, arm = at[4][link].turn * drawn_arm;
    Differences moves;
    for (std::size_t j = 1; j <= 4; ++j)
      moves.add(j, at[4 + j][link].turn * drawn_arm - arm, at[4 - j][link].turn * drawn_arm - arm, h);
    H += m * cross(arm, moves.first);
    M += m * cross(arm, moves.second);
    spread += std::abs(m) * norm_squared(arm);
    drawn_far += std::abs(m) * norm(arm) * norm(place);
  }
  // Places that are given in doubles far from the origin leave their rounding in the arms: twenty units in the last
  // place of them are a part of the size that is allowed, 1e-8.
  constexpr Real rounding = 20 * std::numeric_limits<double>::epsilon() / 1e-8L;
  const Real size = spread + rounding * drawn_far;
  const auto off = [](const Vector& a, const Vector3<double>& b) { return norm(a - widened(b)); };
  const CheckBody::Within& told = *body.within;
  const Real H_size = pace * size + rounding * Real(told.angular_momentum_size),
             M_size = pace * pace * size + rounding * Real(told.moment_size);
  return std::max(ratio(off(H, told.angular_momentum), H_size),
                  body.forces_known ? ratio(off(M, told.moment), M_size) : 0);
}

}  // namespace

CheckResult check_with_particles(const std::vector<CheckLink>& links, const std::vector<CheckBody>& bodies,
                                 const std::vector<double>& q, const std::vector<double>& v,
                                 const std::vector<double>& a, double reach) {
  // The step of the differences is so short that no angle changes by more than a few hundredths in it.
  Real length = 0;
  for (const CheckBody& body : bodies)
    for (const auto& particle : body.particles) length = std::max(length, norm(widened(particle.position)));
  const Real pace =
      drawn::pace_of(links, v, a, std::max({length, Real(reach), length > 0 || reach > 0 ? Real(0) : Real(1)}));
  const Real h = drawn::step_of_pace / (pace > 0 ? pace : 1);
  std::array<std::vector<Displacement>, 9> at;
  for (int j = -4; j <= 4; ++j) at[static_cast<std::size_t>(j + 4)] = drawn::displacements(links, q, v, a, Real(j) * h);

  CheckResult result;
  Real force_misfit = 0, moment_misfit = 0, force_size = 0, moment_size = 0;
  for (const CheckBody& body : bodies) {
    const auto link = static_cast<std::size_t>(body.link);
    Vector L = Vector::zero(), H = Vector::zero(), F = Vector::zero(), M = Vector::zero();
    Real T = 0, L_size = 0, H_size = 0, T_size = 0, F_size = 0, M_size = 0;
    for (const auto& particle : body.particles) {
      count_work(of_a_particle);
      const Vector x0 = widened(particle.position);
      const Real m = particle.mass;
      const Vector x = at[4][link](x0);
      // Differences are taken of displacements from the present place, so that a large distance from the origin does
      // not cancel.
      Differences moves;
      for (std::size_t j = 1; j <= 4; ++j) moves.add(j, at[4 + j][link](x0) - x, at[4 - j][link](x0) - x, h);
      const Vector &velocity = moves.first, &acceleration = moves.second;
      L += m * velocity;
      H += m * cross(x, velocity);
      T += m * norm_squared(velocity) / 2;
      F += m * acceleration;
      M += m * cross(x, acceleration);
      // A particle that is at rest for this instant has no speed to compare with: what its acceleration gives it in a
      // small part of the motion's own time takes its place. Differences of doubles over 0.02/pace leave 5e-15 of
      // pace |x|, which is 5e-10 of this part: well below the misfit that is allowed, 1e-8.
      constexpr Real small_part = 1e-5L;
      Real speed = std::max(norm(velocity), small_part * pace * norm(x));
      if (pace > 0) speed = std::max(speed, small_part * norm(acceleration) / pace);
      L_size += std::abs(m) * speed;
      H_size += std::abs(m) * norm(x) * speed;
      T_size += std::abs(m) * speed * speed / 2;
      F_size += std::abs(m) * norm(acceleration);
      M_size += std::abs(m) * norm(x) * norm(acceleration);
    }
    result.momentum =
        std::max<double>(result.momentum, static_cast<double>(ratio(norm(L - widened(body.momentum)), L_size)));
    result.momentum =
        std::max<double>(result.momentum, static_cast<double>(ratio(norm(H - widened(body.angular_momentum)), H_size)));
    result.energy =
        std::max<double>(result.energy, static_cast<double>(ratio(std::abs(T - Real(body.kinetic_energy)), T_size)));
    if (body.within)
      result.newton_euler = std::max(result.newton_euler, static_cast<double>(misfit_within(body, at, h, pace)));
    if (!body.forces_known) continue;
    const Vector force = widened(body.wrench.force), moment = widened(body.wrench.moment);
    force_misfit = larger(norm(F - force), force_misfit);
    moment_misfit = larger(norm(M - moment), moment_misfit);
    // On a body that glides without forces there are no forces to compare with: what would turn its momentum round in
    // the motion's own time takes their place.
    force_size = std::max({force_size, F_size, Real(body.force_size), pace * L_size});
    moment_size = std::max({moment_size, M_size, Real(body.moment_size), pace * H_size});
  }
  // Where only couples act the forces are small, and are compared with couples over the length of the mechanism; and
  // the other way round.
  if (length > 0) force_size = std::max(force_size, moment_size / length);
  moment_size = std::max(moment_size, force_size * length);
  result.newton_euler =
      std::max(result.newton_euler,
               static_cast<double>(std::max(ratio(force_misfit, force_size), ratio(moment_misfit, moment_size))));
  return result;
}

}  // namespace poinsot::solve
