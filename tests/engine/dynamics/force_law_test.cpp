// Laws of force against their own potentials: each law's power is what its store gives away and what is not stored.
#include "poinsot/engine/dynamics/force_law.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "poinsot/engine/dynamics/action_forces.h"
#include "poinsot/engine/dynamics/equations_of_motion.h"
#include "poinsot/engine/dynamics/mechanism.h"
#include "poinsot/engine/math/algebra/rotation.h"
#include "poinsot/engine/model/builder.h"
#include "poinsot/engine/model/state.h"

namespace poinsot {
namespace force_law_test {

class RandomNumbers {
 public:
  explicit RandomNumbers(unsigned seed) : random_(seed) {}
  double number(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  Vector3<double> vector(double size) { return {number(-size, size), number(-size, size), number(-size, size)}; }

 private:
  std::mt19937_64 random_;
};

const MassProperties<double> brick{1.0, Vector3<double>::zero(), SymmetricMatrix3<double>::diagonal(0.2, 0.3, 0.25)};

// Two free bodies, and a third that hangs on the second by a revolute joint.
Mechanism<double> three_bodies() {
  ModelBuilder<double> builder;
  const SpatialTransform<double> here{Matrix3<double>::identity(), Vector3<double>::zero()};
  builder.add_body("a", ground, Joint<double>::free(), here, brick);
  builder.add_body("b", ground, Joint<double>::free(), here, brick);
  builder.add_body("c", 1, Joint<double>::revolute({1, 2, 2}), here, brick);
  Mechanism<double> mechanism;
  mechanism.tree = builder.build();
  return mechanism;
}

State<double> random_state(const Model<double>& tree, RandomNumbers& random) {
  State<double> state = neutral_state(tree);
  for (double& v : state.v) v = random.number(-1, 1);
  integrate_position<double>(tree, state.q, state.v, 1.2);
  for (double& v : state.v) v = random.number(-2, 2);
  return state;
}

// One law of each kind that is not alone in the mechanism, between the ground, a and c.
Mechanism<double> with_all_laws(RandomNumbers& random) {
  Mechanism<double> mechanism = three_bodies();
  const auto action = [&](int on, int from) {
    mechanism.actions.push_back({ActionKind::spring, "law", "", on, from});
    return static_cast<int>(mechanism.actions.size()) - 1;
  };
  mechanism.forces.push_back({action(0, 2), false, {0, random.vector(1)}, random.vector(5), 2});
  mechanism.forces.push_back({action(2, ground), true, {2, {}}, random.vector(5), ground});
  mechanism.springs.push_back({action(0, 2),
                               {0, random.vector(1)},
                               {2, random.vector(1)},
                               random.number(1, 9),
                               random.number(0.1, 1),
                               random.number(0.1, 1)});
  mechanism.torsions.push_back({action(0, 2),
                                0,
                                {2, normalized(random.vector(1))},
                                random.number(1, 9),
                                random.number(-1, 1),
                                random.number(0.1, 1)});
  mechanism.torsions.push_back(
      {action(2, ground), 2, {ground, normalized(random.vector(1))}, random.number(1, 9), 0.3, 0});
  mechanism.attractions.push_back(
      {action(2, ground),
       {2, random.vector(0.5)},
       {ground, 9.0 * normalized(random.vector(1))},
       random.number(50, 90),
       {{random.vector(0.5), 2, true, SymmetricMatrix3<double>{2, 3, 2.5, 0.4, -0.3, 0.2}}, {random.vector(0.5), 1}}});
  return mechanism;
}

template <class Visit>
void for_each_case(Visit&& visit) {
  for (unsigned seed = 1; seed <= 50; ++seed) {
    RandomNumbers random(seed);
    const Mechanism<double> mechanism = with_all_laws(random);
    const State<double> state = random_state(mechanism.tree, random);
    Workspace<double> workspace(mechanism.tree);
    update_velocities(mechanism.tree, workspace, state);
    SCOPED_TRACE(seed);
    visit(mechanism, state, workspace);
  }
}

// The potential a little later, by the velocities of the state.
template <class Law>
double stored_after(const Mechanism<double>& mechanism, const Law& law, const State<double>& state, double time) {
  Workspace<double> workspace(mechanism.tree);
  std::vector<double> q = state.q;
  integrate_position<double>(mechanism.tree, q, state.v, time);
  update_poses<double>(mechanism.tree, workspace, q);
  return law.stored_energy(mechanism.tree, workspace);
}

TEST(ForceLaw, PowerIsWhatTheStoreGivesAndWhatIsNotStored) {
  int tried = 0;
  for_each_case([&](const Mechanism<double>& mechanism, const State<double>& state,
                    const Workspace<double>& workspace) {
    for_each_law(mechanism, [&](const auto& law) {
      const Action& action = mechanism.actions[static_cast<std::size_t>(law.action)];
      constexpr double h = 1e-5;
      const double given = (stored_after(mechanism, law, state, -h) - stored_after(mechanism, law, state, h)) / (2 * h);
      const double power = power_between(workspace, action.on, action.from, law.exerted(mechanism.tree, workspace));
      const double unstored = law.unstored_power(mechanism.tree, workspace, action.on, action.from);
      EXPECT_NEAR(power, given + unstored, 1e-6 * (1 + std::abs(power)));
      EXPECT_EQ(law.stores(), given != 0);
      if (!law.feeds()) {
        EXPECT_LE(unstored, 0);
      }
      EXPECT_EQ(law.feeds() || law.drains(), unstored != 0);
      ++tried;
    });
  });
  EXPECT_EQ(tried, 50 * 6);
}

TEST(ForceLaw, GeneralisedForcesAtRestAreTheDownhillSlopesOfThePotential) {
  for_each_case([&](Mechanism<double> mechanism, State<double> state, Workspace<double>& workspace) {
    mechanism.forces.clear();
    std::fill(state.v.begin(), state.v.end(), 0.0);
    update_velocities(mechanism.tree, workspace, state);
    const std::vector<double> forces = known_generalised_forces(mechanism, workspace, state);
    const auto potential = [&](std::size_t k, double step) {
      std::vector<double> q = state.q, v(state.v.size(), 0.0);
      v[k] = 1;
      integrate_position<double>(mechanism.tree, q, v, step);
      Workspace<double> moved(mechanism.tree);
      update_poses<double>(mechanism.tree, moved, q);
      return stored_energy(mechanism, moved, State<double>{q, state.v});
    };
    for (std::size_t k = 0; k < forces.size(); ++k) {
      constexpr double h = 1e-5;
      EXPECT_NEAR(forces[k], (potential(k, -h) - potential(k, h)) / (2 * h), 1e-6 * (1 + std::abs(forces[k])));
    }
  });
}

TEST(TorsionLaw, AngleOfAPureTurningIsThatOfTheTurning) {
  Mechanism<double> mechanism = three_bodies();
  const Vector3<double> u = normalized(Vector3<double>{1, 2, 2});
  const TorsionLaw<double> law{0, 2, {1, u}, 1, 0, 0};
  Workspace<double> workspace(mechanism.tree);
  RandomNumbers random(7);
  for (const double angle : {-3.1, -1.0, -1e-9, 0.0, 0.4, 1.6, 3.14}) {
    State<double> state = random_state(mechanism.tree, random);
    state.q.back() = angle;
    update_poses<double>(mechanism.tree, workspace, state.q);
    EXPECT_NEAR(law.angle(mechanism.tree, workspace), angle, 4e-15);
  }
}

// R = swing . twist, the swing about an axis across u: the twist is the angle whatever the swing.
TEST(TorsionLaw, AngleIsTheTwistBeforeAnySwing) {
  RandomNumbers random(3);
  Mechanism<double> mechanism = three_bodies();
  for (int i = 0; i < 100; ++i) {
    const Vector3<double> u = normalized(random.vector(1));
    const double twist = random.number(-3, 3), swing = random.number(-2.8, 2.8);
    const Vector3<double> across = normalized(cross(u, random.vector(1)));
    const Matrix3<double> R =
        rotation_exponential(Vector3<double>(swing * across)) * rotation_exponential(Vector3<double>(twist * u));
    Workspace<double> workspace(mechanism.tree);
    update_poses<double>(mechanism.tree, workspace, neutral_state(mechanism.tree).q);
    workspace.motion[1].R = R;
    const TorsionLaw<double> law{0, 0, {ground, u}, 1, 0, 0};
    EXPECT_NEAR(law.angle(mechanism.tree, workspace), twist, 1e-13);
  }
}

// A quarter turn takes the couple k pi/2 about the axis; a swing turns the couple half as far as the body.
TEST(TorsionLaw, CoupleIsAlongTheAxisHalfwayBetweenTheBodies) {
  Mechanism<double> mechanism = three_bodies();
  Workspace<double> workspace(mechanism.tree);
  update_poses<double>(mechanism.tree, workspace, neutral_state(mechanism.tree).q);
  const double quarter = std::numbers::pi / 2;
  const TorsionLaw<double> law{0, 0, {ground, {0, 0, 1}}, 2, 0, 0};
  workspace.motion[1].R = rotation_exponential(Vector3<double>{0, 0, quarter});
  EXPECT_NEAR(norm(law.exerted(mechanism.tree, workspace).couple - Vector3<double>{0, 0, -2 * quarter}), 0, 1e-14);
  const double swing = 0.8;
  workspace.motion[1].R =
      rotation_exponential(Vector3<double>{swing, 0, 0}) * rotation_exponential(Vector3<double>{0, 0, quarter});
  const Vector3<double> halfway{0, -std::sin(swing / 2), std::cos(swing / 2)};
  EXPECT_NEAR(norm(law.exerted(mechanism.tree, workspace).couple + (2 * quarter / std::cos(swing / 2)) * halfway), 0,
              1e-14);
}

}  // namespace force_law_test
}  // namespace poinsot
