// Momenta, energies and their rates against particles, numerical differentiation and the forces.
#include "poinsot/engine/dynamics/momentum.h"

#include <gtest/gtest.h>

#include "engine/dynamics/newton_euler_oracle.h"
#include "poinsot/engine/dynamics/forward_dynamics.h"
#include "poinsot/engine/dynamics/inverse_dynamics.h"

namespace poinsot {
namespace momentum_test {

using testing::Random;
using testing::relative_difference;

struct Particle {
  double mass;
  Vector3<double> place;
};

// A body and the particles it consists of.
MassProperties<double> body_of(const std::vector<Particle>& particles) {
  MassProperties<double> body{0.0, Vector3<double>::zero(), SymmetricMatrix3<double>::zero()};
  for (const Particle& particle : particles) {
    body.mass += particle.mass;
    body.center += particle.mass * particle.place;
  }
  body.center = body.center / body.mass;
  for (const Particle& particle : particles) {
    body.inertia_center += particle.mass * unit_mass_inertia(particle.place - body.center);
  }
  return body;
}

TEST(Momentum, momenta_energies_and_rates_are_sums_over_particles) {
  Random random(21);
  for (int trial = 0; trial < 1000; ++trial) {
    testing::TreeOptions options;
    options.massless_bodies = false;
    testing::StatedTree tree = testing::random_tree(random, options);
    std::vector<std::vector<Particle>> particles;
    for (testing::StatedBody& body : tree.bodies) {
      std::vector<Particle>& own = particles.emplace_back();
      for (int i = 0; i < 6; ++i) own.push_back({random.uniform(0.1, 1.0), random.vector()});
      body.mass = body_of(own);
    }
    const Model<double> model = testing::built(tree);
    const State<double> state = testing::random_state(random, model);
    Workspace<double> workspace(model);
    update_accelerations<double>(model, workspace, state, random.numbers(model.velocity_size(), 3.0));
    const Vector3<double> p = random.vector(3.0);
    Momentum<double> sum{};
    Momentum<double> rate{};
    double kinetic = 0.0;
    double potential = 0.0;
    double mass = 0.0;
    Vector3<double> center{};
    for (int i = 0; i < model.body_count(); ++i) {
      Momentum<double> own{};
      double own_kinetic = 0.0;
      for (const Particle& particle : particles[static_cast<std::size_t>(i)]) {
        const Vector3<double> r = point_position(model, workspace, i, particle.place);
        const Vector3<double> v = point_velocity(model, workspace, i, particle.place);
        const Vector3<double> a = point_acceleration(model, workspace, i, particle.place);
        own += Momentum<double>{particle.mass * v, particle.mass * cross(r - p, v)};
        rate += Momentum<double>{particle.mass * a, particle.mass * cross(r - p, a)};
        own_kinetic += 0.5 * particle.mass * dot(v, v);
        potential -= particle.mass * dot(tree.gravity, r);
        mass += particle.mass;
        center += particle.mass * r;
      }
      sum += own;
      kinetic += own_kinetic;
      const Momentum<double> found = body_momentum(model, workspace, i, p);
      ASSERT_LT(relative_difference(found.linear, own.linear), 1e-10);
      ASSERT_LT(relative_difference(found.angular, own.angular), 1e-10);
      ASSERT_NEAR(body_kinetic_energy(model, workspace, i), own_kinetic, 1e-10 * (1.0 + own_kinetic));
    }
    ASSERT_LT(relative_difference(momentum(model, workspace, p).linear, sum.linear), 1e-10);
    ASSERT_LT(relative_difference(momentum(model, workspace, p).angular, sum.angular), 1e-10);
    ASSERT_LT(relative_difference(momentum_rate(model, workspace, p).linear, rate.linear), 1e-10);
    ASSERT_LT(relative_difference(momentum_rate(model, workspace, p).angular, rate.angular), 1e-10);
    ASSERT_NEAR(kinetic_energy(model, workspace), kinetic, 1e-10 * (1.0 + kinetic));
    ASSERT_NEAR(potential_energy(model, workspace), potential, 1e-10 * (1.0 + std::fabs(potential)));
    ASSERT_NEAR(total_mass(model), mass, 1e-12 * mass);
    ASSERT_LT(relative_difference(mass_center(model, workspace), center / mass), 1e-11);
  }
}

// d/dt f(t) at 0 by central differences on three halvings of the step with Richardson's extrapolation, and the change
// made by the last extrapolation as the estimate of its error.
struct Differentiated {
  Vector3<long double> value;
  long double error;
};
template <class F>
Differentiated differentiated(F f) {
  constexpr int levels = 4;
  Vector3<long double> table[levels][levels];
  long double h = 2e-3L;
  for (int i = 0; i < levels; ++i, h /= 2.0L) {
    table[i][0] = (f(h) - f(-h)) / (2.0L * h);
    long double factor = 1.0L;
    for (int j = 1; j <= i; ++j) {
      factor *= 4.0L;
      table[i][j] = (factor * table[i][j - 1] - table[i - 1][j - 1]) / (factor - 1.0L);
    }
  }
  return {table[levels - 1][levels - 1], norm(table[levels - 1][levels - 1] - table[levels - 2][levels - 2])};
}

State<long double> moved_state(const Model<long double>& model, const State<double>& state,
                               const std::vector<double>& acceleration, long double t) {
  State<long double> moved = testing::cast<long double>(state);
  std::vector<long double> mean(state.v.size());
  for (std::size_t k = 0; k < mean.size(); ++k) {
    mean[k] = state.v[k] + 0.5L * acceleration[k] * t;
    moved.v[k] = state.v[k] + acceleration[k] * t;
  }
  integrate_position<long double>(model, moved.q, mean, t);
  return moved;
}

TEST(Momentum, rates_agree_with_numerical_differentiation_along_the_motion) {
  Random random(22);
  for (int trial = 0; trial < 200; ++trial) {
    const Model<double> model = testing::built(testing::random_tree(random));
    const State<double> state = testing::random_state(random, model);
    const std::vector<double> acceleration = random.numbers(model.velocity_size(), 3.0);
    Workspace<double> workspace(model);
    update_accelerations<double>(model, workspace, state, acceleration);
    const Vector3<double> p = random.vector();
    const Model<long double> fine = convert<long double>(model);
    Workspace<long double> fine_workspace(fine);
    for (const bool angular : {false, true}) {
      const Differentiated expected = differentiated([&](long double t) {
        update_velocities(fine, fine_workspace, moved_state(fine, state, acceleration, t));
        const Momentum<long double> now = momentum(fine, fine_workspace, testing::cast<long double>(p));
        return angular ? now.angular : now.linear;
      });
      const Momentum<double> rate = momentum_rate(model, workspace, p);
      const Vector3<double>& found = angular ? rate.angular : rate.linear;
      const long double difference = norm(testing::cast<long double>(found) - expected.value);
      ASSERT_LT(difference, 1e-11L * (1.0L + norm(expected.value)) + expected.error) << "trial " << trial;
      ASSERT_LT(expected.error, 1e-6L * (1.0L + norm(expected.value))) << "trial " << trial;
    }
  }
}

TEST(Momentum, rate_is_the_sum_of_weight_and_ground_reaction) {
  Random random(23);
  for (int trial = 0; trial < 300; ++trial) {
    const Model<double> model = testing::built(testing::random_tree(random));
    const State<double> state = testing::random_state(random, model);
    const std::vector<double> acceleration = random.numbers(model.velocity_size(), 3.0);
    Workspace<double> workspace(model);
    std::vector<double> force(model.velocity_size());
    inverse_dynamics<double>(model, workspace, state, acceleration, force);
    update_accelerations<double>(model, workspace, state, acceleration);
    const Vector3<double> origin = Vector3<double>::zero();
    const Momentum<double> rate = momentum_rate(model, workspace, origin);
    const SpatialForce<double> reaction = ground_wrench(workspace);
    const Vector3<double> weight = total_mass(model) * model.gravity();
    ASSERT_LT(relative_difference(rate.linear, reaction.force + weight), 1e-10);
    ASSERT_LT(relative_difference(rate.angular, reaction.moment + cross(mass_center(model, workspace), weight)), 1e-10);
  }
}

TEST(Momentum, energy_grows_by_the_power_of_the_joints_and_the_external_forces) {
  Random random(24);
  for (int trial = 0; trial < 300; ++trial) {
    const Model<double> model = testing::built(testing::random_tree(random));
    const State<double> state = testing::random_state(random, model);
    const std::vector<double> force = random.numbers(model.velocity_size(), 3.0);
    std::vector<SpatialForce<double>> external;
    for (int i = 0; i < model.body_count(); ++i) external.push_back(random.wrench(3.0));
    std::vector<double> acceleration(model.velocity_size());
    Workspace<double> workspace(model);
    forward_dynamics<double>(model, workspace, state, force, acceleration, external);
    update_velocities(model, workspace, state);
    long double power = 0.0L;
    for (std::size_t k = 0; k < force.size(); ++k) power += force[k] * state.v[k];
    for (int i = 0; i < model.body_count(); ++i) {
      const Matrix3<double> R = body_rotation(model, workspace, i);
      power += dot(angular_velocity(workspace, i), R * external[i].moment);
      power += dot(point_velocity(model, workspace, i, Vector3<double>::zero()), R * external[i].force);
    }
    const Model<long double> fine = convert<long double>(model);
    Workspace<long double> fine_workspace(fine);
    const Differentiated grown = differentiated([&](long double t) {
      update_velocities(fine, fine_workspace, moved_state(fine, state, acceleration, t));
      return Vector3<long double>{kinetic_energy(fine, fine_workspace) + potential_energy(fine, fine_workspace), 0.0L,
                                  0.0L};
    });
    update_velocities(model, workspace, state);
    // Rounding of the accelerations enters with the momenta they multiply.
    const long double scale = 1.0L + std::fabs(power) + kinetic_energy(model, workspace) * 10.0L;
    ASSERT_LT(std::fabs(grown.value.x - power), 1e-10L * scale + grown.error) << "trial " << trial;
    ASSERT_LT(grown.error, 1e-6L * scale) << "trial " << trial;
  }
}

}  // namespace momentum_test
}  // namespace poinsot
