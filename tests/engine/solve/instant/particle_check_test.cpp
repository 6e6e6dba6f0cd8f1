#include "poinsot/engine/solve/instant/particle_check.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "engine/dynamics/random_trees.h"
#include "poinsot/engine/dynamics/inverse_dynamics.h"
#include "poinsot/engine/dynamics/momentum.h"

namespace poinsot::solve {
namespace particle_check_test {

using poinsot::testing::Random;
using Vector = Vector3<double>;

// A tree with all that the check is told about it.
struct Claim {
  std::vector<CheckLink> links;
  std::vector<CheckBody> bodies;
  std::vector<double> q, v, a;

  CheckResult checked() const { return check_with_particles(links, bodies, q, v, a); }
};

// Random trees of all types of joints as drawn: all body frames lie along the ground's axes while the coordinates are
// zero. Momenta, energies and forces come from the engine.
Claim random_claim(Random& random, double offset = 0) {
  Claim claim;
  ModelBuilder<double> builder;
  builder.set_gravity(random.vector(10));
  const int count = random.integer(1, 6);
  std::vector<Vector> origins;
  for (int i = 0; i < count; ++i) {
    const Joint<double> joint = testing::random_joint(random);
    const int parent = random.integer(-1, i - 1);
    const Vector origin = random.vector() + offset * Vector{1, -2, 0.5};
    const Vector parent_origin = parent < 0 ? Vector::zero() : origins[static_cast<std::size_t>(parent)];
    CheckBody body;
    body.link = i;
    for (int k = 0; k < 5; ++k) body.particles.push_back({random.uniform(0.1, 1), origin + random.vector(0.6)});
    MassProperties<double> mass = mass_properties(body.particles);
    mass.center = mass.center - origin;
    claim.links.push_back({joint.type, parent, origin, joint.axis, joint.pitch, static_cast<int>(claim.q.size()),
                           static_cast<int>(claim.v.size())});
    builder.add_body("body " + std::to_string(i), parent, joint,
                     SpatialTransform<double>::translation(origin - parent_origin), mass);
    claim.q.resize(claim.q.size() + static_cast<std::size_t>(position_size(joint.type)));
    claim.v.resize(claim.v.size() + static_cast<std::size_t>(velocity_size(joint.type)));
    origins.push_back(origin);
    claim.bodies.push_back(std::move(body));
  }
  const Model<double> model = builder.build();
  const State<double> state = testing::random_state(random, model);
  claim.q = state.q;
  claim.v = state.v;
  claim.a = random.numbers(model.velocity_size(), 3);
  Workspace<double> workspace(model);
  update_accelerations<double>(model, workspace, state, claim.a);
  for (CheckBody& body : claim.bodies) {
    const Momentum<double> momentum = body_momentum(model, workspace, body.link, Vector::zero());
    const Momentum<double> rate = body_momentum_rate(model, workspace, body.link, Vector::zero());
    body.momentum = momentum.linear;
    body.angular_momentum = momentum.angular;
    body.kinetic_energy = body_kinetic_energy(model, workspace, body.link);
    body.forces_known = true;
    body.wrench = {rate.angular, rate.linear};
    body.force_size = norm(rate.linear);
    body.moment_size = norm(rate.angular);
  }
  return claim;
}

double largest(const CheckResult& result) { return std::max({result.momentum, result.energy, result.newton_euler}); }

TEST(ParticleCheck, ConfirmsTheEngineOnTreesOfAllJoints) {
  Random random(11);
  for (int trial = 0; trial < 1000; ++trial) {
    const Claim claim = random_claim(random);
    EXPECT_LT(largest(claim.checked()), 1e-12) << "trial " << trial;
  }
}

// Positions of a thousand meters leave the second differences ten digits.
TEST(ParticleCheck, ConfirmsAFigureFarFromTheOrigin) {
  Random random(12);
  for (int trial = 0; trial < 200; ++trial) {
    const Claim claim = random_claim(random, 1000);
    EXPECT_LT(largest(claim.checked()), 1e-9) << "trial " << trial;
  }
}

// Every single claim, falsified by a millionth, is found.
TEST(ParticleCheck, FindsEveryFalsifiedClaim) {
  Random random(13);
  for (int trial = 0; trial < 300; ++trial) {
    const Claim truth = random_claim(random);
    for (std::size_t i = 0; i < truth.bodies.size(); ++i) {
      // A body that neither moves nor feels a force, as one welded to the ground, has nothing to be falsified by.
      const CheckBody& body = truth.bodies[i];
      if (norm(body.momentum) < 1e-3 || norm(body.angular_momentum) < 1e-3) continue;
      for (std::size_t k = 0; k < 3; ++k) {
        const auto falsified = [&](const std::function<void(CheckBody&)>& change) {
          Claim claim = truth;
          change(claim.bodies[i]);
          return claim.checked();
        };
        const double part = 1e-6;
        EXPECT_GT(falsified([&](CheckBody& b) { b.momentum[k] += part * norm(b.momentum); }).momentum, 1e-8);
        EXPECT_GT(falsified([&](CheckBody& b) { b.angular_momentum[k] += part * norm(b.angular_momentum); }).momentum,
                  1e-8);
        EXPECT_GT(falsified([&](CheckBody& b) { b.kinetic_energy *= 1 + part; }).energy, 1e-8);
        EXPECT_GT(falsified([&](CheckBody& b) { b.wrench.force[k] += part * 10; }).newton_euler, 1e-9);
        EXPECT_GT(falsified([&](CheckBody& b) { b.wrench.moment[k] += part * 10; }).newton_euler, 1e-9);
        EXPECT_LT(falsified([&](CheckBody& b) { b.wrench.force[k] += part * 10; }).momentum, 1e-12);
      }
    }
  }
}

// Wrong accelerations are caught by the forces, wrong velocities by momentum and energy.
TEST(ParticleCheck, FindsWrongMotion) {
  Random random(14);
  int moved = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const Claim truth = random_claim(random);
    for (std::size_t k = 0; k < truth.v.size(); ++k) {
      Claim wrong = truth;
      wrong.a[k] += 1e-5;
      EXPECT_GT(wrong.checked().newton_euler, 1e-9) << trial;
      EXPECT_LT(wrong.checked().momentum, 1e-12) << trial;
      wrong = truth;
      wrong.v[k] += 1e-5;
      EXPECT_GT(wrong.checked().momentum, 1e-9) << trial;
      ++moved;
    }
  }
  EXPECT_GT(moved, 500);
}

TEST(ParticleCheck, RefusesWhatIsNoNumber) {
  Random random(15);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Claim truth = random_claim(random);
  while (truth.bodies.size() < 2 || truth.v.empty()) truth = random_claim(random);
  // In the first body, where a later sound one must not cover it, and in the last.
  for (std::size_t i : {std::size_t{0}, truth.bodies.size() - 1}) {
    Claim claim = truth;
    claim.bodies[i].momentum.x = nan;
    EXPECT_GT(claim.checked().momentum, 1);
    claim = truth;
    claim.bodies[i].angular_momentum.y = nan;
    EXPECT_GT(claim.checked().momentum, 1);
    claim = truth;
    claim.bodies[i].kinetic_energy = nan;
    EXPECT_GT(claim.checked().energy, 1);
    claim = truth;
    claim.bodies[i].wrench.force.z = nan;
    EXPECT_GT(claim.checked().newton_euler, 1);
    claim = truth;
    claim.bodies[i].wrench.moment.z = nan;
    EXPECT_GT(claim.checked().newton_euler, 1);
  }
  Claim claim = truth;
  claim.v.back() = nan;
  EXPECT_GT(largest(claim.checked()), 1);
}

TEST(ParticleCheck, ABodyAtRestWithoutForcesIsConfirmed) {
  Claim claim;
  claim.links.push_back({JointType::weld, -1, {1, 2, 3}, {}, 0, 0, 0});
  CheckBody body;
  body.particles = {{2, {1, 0, 0}}, {1, {0, 1, 0}}};
  body.forces_known = true;
  claim.bodies.push_back(body);
  EXPECT_EQ(largest(claim.checked()), 0);
  // The same body with a momentum out of nothing is wholly wrong.
  claim.bodies[0].momentum = {0, 1e-30, 0};
  EXPECT_EQ(claim.checked().momentum, 1);
  claim.bodies[0].momentum = {};
  claim.bodies[0].wrench.force = {0, 3, 0};
  EXPECT_EQ(claim.checked().newton_euler, 1);
}

// Nothing acts on a body that glides: rounding is no force.
TEST(ParticleCheck, ABodyThatGlidesIsConfirmed) {
  Random random(16);
  for (int trial = 0; trial < 100; ++trial) {
    Claim claim;
    const Vector axis = random.direction();
    const double speed = random.uniform(-3, 3);
    claim.links.push_back({JointType::prismatic, -1, random.vector(), axis, 0, 0, 0});
    CheckBody body;
    for (int k = 0; k < 4; ++k) body.particles.push_back({random.uniform(0.1, 1), random.vector()});
    const MassProperties<double> mass = mass_properties(body.particles);
    body.momentum = mass.mass * speed * axis;
    body.angular_momentum = cross(mass.center, body.momentum);
    body.kinetic_energy = mass.mass * speed * speed / 2;
    body.forces_known = true;
    claim.bodies.push_back(body);
    claim.q = {0};
    claim.v = {speed};
    claim.a = {0};
    EXPECT_LT(largest(claim.checked()), 1e-12) << trial;
  }
}

// A circular motion whose every number is known: m r w, m r^2 w, m r^2 w^2/2, m r w^2 inwards.
TEST(ParticleCheck, AParticleOnACircle) {
  const double m = 2, r = 0.5, w = 3;
  Claim claim;
  claim.links.push_back({JointType::revolute, -1, {0, 0, 7}, {0, 0, 4}, 0, 0, 0});
  CheckBody body;
  body.particles = {{m, {r, 0, 0}}};
  body.momentum = {0, m * r * w, 0};
  body.angular_momentum = {0, 0, m * r * r * w};
  body.kinetic_energy = m * r * r * w * w / 2;
  body.forces_known = true;
  body.wrench.force = {-m * r * w * w, 0, 0};
  claim.bodies.push_back(body);
  claim.q = {0};
  claim.v = {w};
  claim.a = {0};
  EXPECT_LT(largest(claim.checked()), 1e-15);
  claim.bodies[0].wrench.force.x *= 1 + 1e-12;
  EXPECT_GT(claim.checked().newton_euler, 1e-13);
}

}  // namespace particle_check_test
}  // namespace poinsot::solve
