// Slopes of accelerations against differences of those that another road finds (motion/mechanism).
#include "engine/solve/stability/acceleration_slopes.h"

#include <gtest/gtest.h>

#include "case_count.h"
#include "engine/motion/mechanism/random_mechanisms.h"

namespace poinsot::solve {
namespace acceleration_slopes_test {

using namespace poinsot::testing;

Vector as_vector(const std::vector<double>& list) {
  return Eigen::Map<const Eigen::VectorXd>(list.data(), static_cast<Eigen::Index>(list.size())).cast<Real>();
}

// A mechanism in a state in which its constraints hold and do not nearly depend on one another.
struct Example {
  Mechanism<double> mechanism;
  MechanismDynamics dynamics;
  State<double> state;
  std::vector<double> a;

  SteadyMotion motion() const {
    SteadyMotion motion;
    motion.mechanism = &mechanism;
    motion.q = state.q;
    motion.v = state.v;
    motion.given.resize(state.v.size());
    for (std::size_t k = 0; k < state.v.size(); ++k)
      if (dynamics.is_held(static_cast<int>(k))) motion.given[k] = 0;
    return motion;
  }
};
std::optional<Example> random_example(Random& random) {
  Mechanism<double> mechanism = random_mechanism(random);
  MechanismDynamics dynamics(mechanism);
  const std::optional<State<double>> state = random_closed_state(random, dynamics, 0.3);
  if (!state || !dynamics.open_coordinates(state->q).empty()) return std::nullopt;
  std::vector<double> a = accelerations_of(dynamics, *state);
  if (!(largest_of(a) < 1e3) || !(dynamics.independence() > 1e-2)) return std::nullopt;
  return Example{std::move(mechanism), std::move(dynamics), *state, std::move(a)};
}

// a(v + d) - a(v - d) = 2 a_v d exactly, as accelerations are quadratic in the velocities.
TEST(AccelerationSlopes, ByVelocities) {
  Random random(901);
  int seen = 0, constrained = 0;
  for (int trial = 0; trial < case_count(150); ++trial) {
    std::optional<Example> example = random_example(random);
    if (!example) continue;
    const AccelerationSlopes slopes = acceleration_slopes(example->motion());
    State<double> one = example->state, other = example->state;
    for (std::size_t k = 0; k < one.v.size(); ++k) {
      const double change = random.uniform(-1, 1);
      one.v[k] += change;
      other.v[k] -= change;
    }
    example->dynamics.project_velocities(one.q, one.v);
    example->dynamics.project_velocities(other.q, other.v);
    const Vector along = as_vector(one.v) - as_vector(other.v);
    const Vector after = as_vector(accelerations_of(example->dynamics, one));
    const Vector before = as_vector(accelerations_of(example->dynamics, other));
    const Real size = 1 + after.norm() + before.norm() + slopes.a.norm();
    EXPECT_LE((slopes.a - as_vector(example->a)).norm(), 1e-8L * size);
    EXPECT_LE((slopes.by_velocity.value * along - (after - before)).norm(), 1e-8L * size);
    ++seen;
    constrained += !example->mechanism.constraints.empty();
    if (HasFailure()) return;
  }
  EXPECT_GT(seen, case_count(150) / 3);
  EXPECT_GT(constrained, case_count(150) / 10);
}

// da/dt = a_q v + a_v a along the motion itself.
TEST(AccelerationSlopes, AlongTheMotion) {
  Random random(902);
  int seen = 0, constrained = 0;
  for (int trial = 0; trial < case_count(150); ++trial) {
    std::optional<Example> example = random_example(random);
    if (!example) continue;
    const AccelerationSlopes slopes = acceleration_slopes(example->motion());
    const auto difference = [&](double t) {
      State<double> after = later(example->dynamics, example->state, example->a, t);
      State<double> before = later(example->dynamics, example->state, example->a, -t);
      example->dynamics.project(after.q, after.v);
      example->dynamics.project(before.q, before.v);
      return Vector((as_vector(accelerations_of(example->dynamics, after)) -
                     as_vector(accelerations_of(example->dynamics, before))) /
                    Real(2 * t));
    };
    const Vector coarse = difference(2e-4), fine = difference(1e-4), expected = (4 * fine - coarse) / 3;
    const Vector found =
        slopes.by_position.value * as_vector(example->state.v) + slopes.by_velocity.value * as_vector(example->a);
    EXPECT_LE((found - expected).norm(), 1e-6L * (1 + expected.norm()) + (fine - coarse).norm());
    ++seen;
    constrained += !example->mechanism.constraints.empty();
    if (HasFailure()) return;
  }
  EXPECT_GT(seen, case_count(150) / 3);
  EXPECT_GT(constrained, case_count(150) / 10);
}

}  // namespace acceleration_slopes_test
}  // namespace poinsot::solve
