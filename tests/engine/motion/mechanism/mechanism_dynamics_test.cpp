#include "poinsot/engine/motion/mechanism/mechanism_dynamics.h"

#include <gtest/gtest.h>

#include <numbers>
#include <stdexcept>

#include "engine/motion/mechanism/random_mechanisms.h"
#include "engine/motion/mechanism/sample_mechanisms.h"
#include "poinsot/engine/dynamics/velocity_constraint.h"

namespace poinsot {
namespace mechanism_dynamics_test {

using testing::accelerations_of;
using testing::largest_of;
using testing::later;
using testing::MechanismMaker;
using testing::NamedMotion;
using testing::Random;
using testing::random_closed_state;
using testing::random_mechanism;
using testing::rod;
using Vector = Vector3<double>;
using std::numbers::pi;

constexpr double g = 9.81;

struct Tally {
  int cases = 0, constrained = 0, redundant = 0, components = 0, efforts = 0;
};

// Accelerations, efforts and forces of components against the equations in which every force is named.
void compare(Random& random, MechanismDynamics& dynamics, const State<double>& state, Tally& tally) {
  const int n = dynamics.mechanism().tree.velocity_size();
  std::vector<double> given(static_cast<std::size_t>(n), 0.0);
  for (const int k : dynamics.held_coordinates()) {
    given[k] = random.uniform(-3, 3);
    dynamics.set_held_acceleration(k, given[k]);
  }
  const std::vector<double> a = accelerations_of(dynamics, state);
  const NamedMotion named(dynamics, state, given);
  // Given motions may contradict the loops.
  if (!named.solution.conflict.empty() || named.solution.condition > 1e7) return;
  ++tally.cases;
  tally.constrained += !dynamics.mechanism().constraints.empty();
  tally.redundant += !dynamics.redundant_constraints().empty();
  const double size = 1 + largest_of(a);
  for (int k = 0; k < n; ++k) {
    ASSERT_TRUE(named.solution.determined(static_cast<std::size_t>(k)));
    EXPECT_NEAR(a[k], named.solution.value[static_cast<std::size_t>(k)], 1e-9 * size) << "coordinate " << k;
  }
  double force_size = 1;
  for (std::size_t j = named.components; j < named.solution.value.size(); ++j)
    if (named.solution.determined(j)) force_size = std::max(force_size, std::abs(named.solution.value[j]));
  for (std::size_t j = 0; j < dynamics.mechanism().components.size(); ++j) {
    const ActionKind kind = dynamics.mechanism().actions[dynamics.mechanism().components[j].action].kind;
    if (kind != ActionKind::joint && named.solution.determined(named.components + j) &&
        std::abs(named.solution.value[named.components + j]) > 1e-9 * force_size) {
      EXPECT_TRUE(dynamics.component_determined(j)) << "component " << j;
    }
    if (!dynamics.component_determined(j)) continue;
    ++tally.components;
    EXPECT_TRUE(named.solution.determined(named.components + j)) << "component " << j;
    EXPECT_NEAR(dynamics.component_force(j), named.solution.value[named.components + j], 1e-8 * force_size)
        << "component " << j;
  }
  const solve::ForceUnknowns order = solve::force_unknowns(named.mechanism);
  for (std::size_t i = 0; i < order.drive_of_effort.size(); ++i) {
    if (!named.solution.determined(named.efforts + i)) continue;
    ++tally.efforts;
    EXPECT_NEAR(dynamics.held_effort(named.mechanism.drives[order.drive_of_effort[i]].coordinate),
                named.solution.value[named.efforts + i], 1e-8 * force_size);
  }
  EXPECT_LT(dynamics.constraint_misfit(), 1e-9);
}

TEST(MechanismDynamics, RandomMechanismsAgreeWithTheEquationsThatNameEveryForce) {
  Random random(20);
  Tally tally;
  for (int i = 0; tally.cases < 1000 && i < 3000 && !HasFailure(); ++i) {
    SCOPED_TRACE("mechanism " + std::to_string(i));
    MechanismDynamics dynamics(random_mechanism(random));
    if (const auto state = random_closed_state(random, dynamics, 0.5)) compare(random, dynamics, *state, tally);
  }
  EXPECT_EQ(tally.cases, 1000);
  EXPECT_GT(tally.constrained, 400);
  EXPECT_GT(tally.redundant, 100);
  EXPECT_GT(tally.components, 500);
  EXPECT_GT(tally.efforts, 200);
}

TEST(MechanismDynamics, CordsAndContactsThatDoNotActExertNothing) {
  Random random(21);
  Tally tally;
  int switched = 0;
  for (int i = 0; tally.cases < 300 && i < 2000 && !HasFailure(); ++i) {
    SCOPED_TRACE("mechanism " + std::to_string(i));
    MechanismDynamics dynamics(random_mechanism(random));
    const auto state = random_closed_state(random, dynamics, 0.5);
    if (!state) continue;
    const std::vector<Action>& actions = dynamics.mechanism().actions;
    for (std::size_t k = 0; k < actions.size(); ++k) {
      if ((actions[k].kind != ActionKind::cord && actions[k].kind != ActionKind::contact) || !random.chance(0.5))
        continue;
      dynamics.set_acting(static_cast<int>(k), false);
      ++switched;
    }
    compare(random, dynamics, *state, tally);
  }
  EXPECT_EQ(tally.cases, 300);
  EXPECT_GT(switched, 50);
}

TEST(MechanismDynamics, EnergyGrowsWithThePowerAndConstraintsHold) {
  Random random(22);
  int cases = 0, held = 0;
  for (int i = 0; cases < 300 && i < 2000; ++i) {
    SCOPED_TRACE("mechanism " + std::to_string(i));
    MechanismDynamics dynamics(random_mechanism(random));
    const auto state = random_closed_state(random, dynamics, 0.5);
    if (!state) continue;
    for (const int k : dynamics.held_coordinates()) dynamics.set_held_acceleration(k, random.uniform(-3, 3));
    const std::vector<double> a = accelerations_of(dynamics, *state);
    if (dynamics.constraint_misfit() > 1e-9 || largest_of(a) > 300) continue;
    const double power = dynamics.power();
    ++cases;
    held += !dynamics.held_coordinates().empty();
    const double t = 1e-5;
    const State<double> before = later(dynamics, *state, a, -t), after = later(dynamics, *state, a, t);
    const auto energy = [&](const State<double>& s) {
      return dynamics.kinetic_energy(s.q, s.v) + dynamics.potential_energy(s.q);
    };
    const double size = 1 + std::abs(energy(*state)) + largest_of(a);
    EXPECT_NEAR((energy(after) - energy(before)) / (2 * t), power, 1e-5 * size * size);
    for (std::size_t c = 0; c < dynamics.mechanism().constraints.size(); ++c) {
      const double rate = dynamics.gap_rate(c, after.q, after.v) - dynamics.gap_rate(c, before.q, before.v);
      EXPECT_NEAR(rate / (2 * t), 0, 1e-5 * size) << "constraint " << c;
    }
  }
  EXPECT_EQ(cases, 300);
  EXPECT_GT(held, 30);
}

const Joint<double> about_z = Joint<double>::revolute({0, 0, 1});

TEST(MechanismDynamics, APendulum) {
  MechanismMaker maker;
  maker.add_body(ground, about_z, Vector::zero(), rod(2, 0.6));
  maker.finish_tree({0, -g, 0});
  maker.mechanism.drives[0].damping = 0.3;
  MechanismDynamics dynamics(maker.mechanism);
  const State<double> state{{0.4}, {1.5}};
  const double I = 2 * 0.36 / 3;
  const double expected = (-2 * g * 0.3 * std::cos(0.4) - 0.3 * 1.5) / I;
  EXPECT_NEAR(accelerations_of(dynamics, state)[0], expected, 1e-12 * std::abs(expected));
  EXPECT_NEAR(dynamics.power(), -0.3 * 1.5 * 1.5, 1e-12);
  EXPECT_NEAR(dynamics.kinetic_energy(state.q, state.v), 0.5 * I * 2.25, 1e-12);
  EXPECT_NEAR(dynamics.potential_energy(state.q), 2 * g * 0.3 * std::sin(0.4), 1e-12);
  EXPECT_NEAR(dynamics.momentum(state.q, state.v, Vector::zero()).angular.z, I * 1.5, 1e-12);
}

TEST(MechanismDynamics, AHeldDriveCarriesWhatItsMotionNeeds) {
  MechanismMaker maker;
  maker.add_body(ground, about_z, Vector::zero(), rod(2, 0.6));
  maker.finish_tree({0, -g, 0});
  const int also[] = {0};
  MechanismDynamics dynamics(maker.mechanism, also);
  EXPECT_TRUE(dynamics.is_held(0));
  dynamics.set_held_acceleration(0, 5);
  dynamics.set_effort(0, 1);
  EXPECT_EQ(accelerations_of(dynamics, {{0.4}, {1.5}})[0], 5);
  const double couple = 2 * 0.36 / 3 * 5 + 2 * g * 0.3 * std::cos(0.4);
  EXPECT_NEAR(dynamics.held_effort(0), couple - 1, 1e-12);
  EXPECT_NEAR(dynamics.power(), couple * 1.5, 1e-12);
}

TEST(MechanismDynamics, ASphereRollsDownASlope) {
  for (const bool no_slip : {true, false}) {
    MechanismMaker maker;
    const double m = 3, r = 0.2, I = 0.4 * m * r * r, slope = 0.3;
    const int ball = maker.add_body(ground, Joint<double>::free(), {0, 0, r},
                                    {m, Vector::zero(), SymmetricMatrix3<double>::diagonal(I, I, I)});
    maker.finish_tree({g * std::sin(slope), 0, -g * std::cos(slope)});
    maker.add_contact(ball, ground, {0, 0, 0}, {0, 0, 1}, no_slip, r, std::nullopt);
    MechanismDynamics dynamics(maker.mechanism);
    State<double> state = neutral_state(dynamics.mechanism().tree);
    state.v = {0.1, 0.5, 0.3, 0.1, -0.02, 0};
    dynamics.project(state.q, state.v);
    const std::vector<double> a = accelerations_of(dynamics, state);
    EXPECT_NEAR(a[3] + (state.v[1] * state.v[5] - state.v[2] * state.v[4]),
                g * std::sin(slope) * (no_slip ? 5. / 7 : 1), 1e-12);
    EXPECT_NEAR(dynamics.component_force(0), m * g * std::cos(slope), 1e-12);
    EXPECT_TRUE(dynamics.component_determined(0));
    EXPECT_EQ(dynamics.redundant_constraints().size(), 0U);
  }
}

// A ball that rolls, with friction along two directions of its own choice.
Mechanism<double> ball_with_friction(double angle, bool friction, const Vector& gravity) {
  MechanismMaker maker;
  const int ball = maker.add_body(ground, Joint<double>::free(), {0, 0, 0.2},
                                  {3, {0.02, 0, 0.01}, SymmetricMatrix3<double>::diagonal(0.05, 0.06, 0.07)});
  maker.finish_tree(gravity);
  maker.add_contact(ball, ground, {0, 0, 0}, {0, 0, 1}, true, 0.2, std::nullopt);
  std::vector<Component<double>>& components = maker.mechanism.components;
  for (std::size_t i = 1; i < 3; ++i) {
    const double own = angle + (i == 1 ? 0 : pi / 3);
    components[i].along.vector = {std::cos(own), std::sin(own), 0};
  }
  if (!friction) components.resize(1);
  return maker.mechanism;
}

TEST(MechanismDynamics, FrictionMayActAlongOtherDirectionsThanTheConstraints) {
  const Vector gravity{2, 1, -g};
  MechanismDynamics plain(ball_with_friction(0, true, gravity)), turned(ball_with_friction(0.7, true, gravity));
  State<double> state = neutral_state(plain.mechanism().tree);
  state.v = {1, 2, 3, 0.1, 0.2, 0};
  plain.project(state.q, state.v);
  const std::vector<double> a = accelerations_of(plain, state), b = accelerations_of(turned, state);
  for (std::size_t k = 0; k < 6; ++k) EXPECT_NEAR(a[k], b[k], 1e-12);
  EXPECT_NEAR(plain.component_force(0), turned.component_force(0), 1e-12);
  EXPECT_TRUE(turned.component_determined(0) && turned.component_determined(1) && turned.component_determined(2));
  EXPECT_GT(std::abs(turned.component_force(1)), 0.1);
  EXPECT_LT(turned.constraint_misfit(), 1e-12);
  EXPECT_TRUE(turned.open_coordinates(state.q).empty());
}

TEST(MechanismDynamics, AConstraintThatNothingEnforcesIsNoticed) {
  MechanismDynamics slope(ball_with_friction(0, false, {2, 1, -g}));
  State<double> state = neutral_state(slope.mechanism().tree);
  state.v = {1, 2, 3, 0.1, 0.2, 0};
  slope.project(state.q, state.v);
  accelerations_of(slope, state);
  EXPECT_GT(slope.constraint_misfit(), 1e-3);
}

TEST(MechanismDynamics, AMasslessLinkAtTheEndOfAChainHasNoInertia) {
  MechanismMaker maker;
  const int arm = maker.add_body(ground, about_z, Vector::zero(), rod(2, 0.6));
  maker.add_body(arm, about_z, {0.6, 0, 0}, massless<double>());
  maker.finish_tree({0, -g, 0});
  MechanismDynamics dynamics(maker.mechanism);
  const std::vector<double> q{0.4, 0.2};
  const std::vector<OpenCoordinate> open = dynamics.open_coordinates(q);
  ASSERT_EQ(open.size(), 1U);
  EXPECT_EQ(open[0].coordinate, 1);
  EXPECT_TRUE(open[0].without_inertia);
  // What has inertia moves as it must.
  const std::vector<double> a = accelerations_of(dynamics, {q, {0, 0}});
  EXPECT_NEAR(a[0], -1.5 * g / 0.6 * std::cos(0.4), 1e-12);
  EXPECT_EQ(a[1], 0);
}

TEST(MechanismDynamics, ASlenderRodHasNoInertiaAboutItsOwnLine) {
  Random random(1);
  MechanismMaker maker;
  const Vector line = random.direction();
  const SymmetricMatrix3<double> I = unit_mass_inertia(line);
  const int arm = maker.add_body(ground, about_z, Vector::zero(), rod(2, 0.6));
  maker.add_body(arm, Joint<double>::revolute(line), {0.6, 0, 0}, {1.0, 0.5 * line, I});
  maker.finish_tree({0, -g, 0});
  MechanismDynamics dynamics(maker.mechanism);
  const std::vector<double> q{0.4, 0.2};
  const std::vector<OpenCoordinate> open = dynamics.open_coordinates(q);
  ASSERT_EQ(open.size(), 1U);
  EXPECT_EQ(open[0].coordinate, 1);
  EXPECT_TRUE(open[0].without_inertia);
  EXPECT_TRUE(std::isfinite(accelerations_of(dynamics, {q, {1, 1}})[0]));
}

TEST(MechanismDynamics, AnUnknownCoupleLeavesItsCoordinateOpen) {
  MechanismMaker maker;
  const int arm = maker.add_body(ground, about_z, Vector::zero(), rod(2, 0.6));
  const int other = maker.add_body(arm, about_z, {0.6, 0, 0}, rod(1, 0.3));
  maker.finish_tree({0, -g, 0});
  const int action = maker.add_action(ActionKind::support, other, arm);
  maker.add_component(action, maker.place(other, {0.6, 0, 0}), {arm, {0, 0, 1}}, true);
  MechanismDynamics dynamics(maker.mechanism);
  const std::vector<OpenCoordinate> open = dynamics.open_coordinates(std::vector<double>{0.4, 0.2});
  // The two equations hold for any acceleration of one of the two arms.
  ASSERT_EQ(open.size(), 2U);
  EXPECT_FALSE(open[0].without_inertia);
  EXPECT_FALSE(open[1].without_inertia);
  accelerations_of(dynamics, {{0.4, 0.2}, {0, 0}});
  EXPECT_FALSE(dynamics.component_determined(dynamics.mechanism().components.size() - 1));
}

TEST(MechanismDynamics, LoadsMayChangeWithTime) {
  MechanismMaker maker;
  const int body = maker.add_body(ground, Joint<double>::free(), Vector::zero(),
                                  {2, Vector::zero(), SymmetricMatrix3<double>::diagonal(1, 2, 3)});
  maker.finish_tree(Vector::zero());
  KnownForce<double> force;
  force.action = maker.add_action(ActionKind::load, body, ground);
  force.at = {body, {0, 0, 0.5}};
  maker.mechanism.forces.push_back(force);
  MechanismDynamics dynamics(maker.mechanism);
  const State<double> rest = neutral_state(dynamics.mechanism().tree);
  EXPECT_EQ(largest_of(accelerations_of(dynamics, rest)), 0);
  dynamics.set_force(0, {4, 0, 0});
  const std::vector<double> a = accelerations_of(dynamics, rest);
  EXPECT_NEAR(a[3], 2, 1e-15);
  EXPECT_NEAR(a[1], 1, 1e-15);
}

TEST(MechanismDynamics, MistakesAreRefused) {
  MechanismMaker maker;
  maker.add_body(ground, about_z, Vector::zero(), rod(2, 0.6));
  maker.finish_tree({0, -g, 0});
  const int none[] = {1};
  EXPECT_THROW(MechanismDynamics(maker.mechanism, none), std::invalid_argument);
  MechanismDynamics dynamics(maker.mechanism);
  std::vector<double> one(1), two(2);
  EXPECT_THROW(dynamics.accelerations(two, one, one), std::invalid_argument);
  EXPECT_THROW(dynamics.accelerations(one, two, one), std::invalid_argument);
  EXPECT_THROW(dynamics.accelerations(one, one, two), std::invalid_argument);
  EXPECT_THROW(dynamics.set_held_acceleration(0, 1), std::invalid_argument);
  EXPECT_THROW(dynamics.held_effort(0), std::invalid_argument);
  EXPECT_THROW(dynamics.set_held_acceleration(1, 1), std::invalid_argument);
  EXPECT_THROW(dynamics.set_force(0, Vector::zero()), std::invalid_argument);
  EXPECT_THROW(dynamics.set_effort(1, 0), std::invalid_argument);
  EXPECT_THROW(dynamics.set_acting(-1, false), std::invalid_argument);
  EXPECT_THROW(dynamics.component_force(99), std::invalid_argument);
  EXPECT_THROW(dynamics.gap(0, one), std::invalid_argument);
}

}  // namespace mechanism_dynamics_test
}  // namespace poinsot
