// Bodies as particles against closed forms: a slider on a turning arm.
#include "engine/solve/instant/particle_paths.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace poinsot::solve {
namespace particle_paths_test {

using Real = ParticlePaths::Real;
using Vector = ParticlePaths::Vector;

void expect_near(const Vector& found, const Vector& expected, Real within) {
  EXPECT_LT(norm(found - expected), within)
      << static_cast<double>(found.x) << " " << static_cast<double>(found.y) << " " << static_cast<double>(found.z);
}

// In polar coordinates: v = r' e_r + r w e_t, a = (r'' - r w^2) e_r + (r alpha + 2 r' w) e_t.
TEST(ParticlePaths, ASliderOnATurningArm) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> number(-2, 2);
  for (int trial = 0; trial < 50; ++trial) {
    const double angle = number(random), w = number(random), alpha = number(random),
                 mass = 1 + std::abs(number(random));
    const double out = number(random), rate = number(random), accel = number(random);
    const std::vector<CheckLink> links{
        {.type = JointType::revolute, .axis = {0, 0, 3}, .position = 0, .velocity = 0},
        {.type = JointType::prismatic, .parent = 0, .axis = {2, 0, 0}, .position = 1, .velocity = 1}};
    const std::vector<Particle<double>> bob{{mass, {3, 0, 0}}}, nothing;
    const ParticlePaths paths(links, {{0, &nothing}, {1, &bob}}, {angle, out}, {w, rate}, {alpha, accel});
    const Real r = 3 + Real(out), c = std::cos(Real(angle)), s = std::sin(Real(angle));
    const Vector along{c, s, 0}, across{-s, c, 0}, place = r * along, P{0.3L, -0.2L, 1};
    const Vector v = Real(rate) * along + r * Real(w) * across;
    const Vector a =
        (Real(accel) - r * Real(w) * Real(w)) * along + (r * Real(alpha) + 2 * Real(rate) * Real(w)) * across;
    constexpr Real within = 1e-10L;
    expect_near(paths.velocity(1, place, -1), v, within);
    expect_near(paths.velocity(1, place, 0), Real(rate) * along, within);
    expect_near(paths.acceleration(1, place, -1), a, within);
    expect_near(paths.acceleration(1, place, 0), Real(accel) * along, within);
    expect_near(paths.angular_velocity(1, -1), {0, 0, w}, within);
    expect_near(paths.angular_velocity(-1, 1), {0, 0, -w}, within);
    expect_near(paths.angular_velocity(1, 0), Vector::zero(), within);
    expect_near(paths.angular_acceleration(1), {0, 0, alpha}, within);
    const ParticlePaths::Sums sums = paths.sums(1, P);
    EXPECT_EQ(sums.mass, Real(mass));
    expect_near(sums.first_moment, Real(mass) * place, within);
    expect_near(sums.momentum, Real(mass) * v, within);
    expect_near(sums.angular_momentum, Real(mass) * cross(place - P, v), within);
    expect_near(sums.rate, Real(mass) * a, within);
    expect_near(sums.angular_rate, Real(mass) * cross(place - P, a), within);
    EXPECT_LT(std::abs(sums.kinetic_energy - Real(mass) * norm_squared(v) / 2), within);
    expect_near(sums.moments * Vector{1, 2, 3}, (Real(mass) * dot(place - P, Vector{1, 2, 3})) * (place - P), within);
    EXPECT_EQ(paths.sums(0, P).mass, 0);
  }
}

}  // namespace particle_paths_test
}  // namespace poinsot::solve
