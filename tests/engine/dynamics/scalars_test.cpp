// All algorithms over packs and duals: the lanes of a pack equal runs over double, the partials of a dual equal
// numerical differentiation.
#include <gtest/gtest.h>

#include "engine/dynamics/random_trees.h"
#include "poinsot/engine/dynamics/constraint.h"
#include "poinsot/engine/dynamics/forward_dynamics.h"
#include "poinsot/engine/dynamics/hybrid_dynamics.h"
#include "poinsot/engine/dynamics/inverse_dynamics.h"
#include "poinsot/engine/dynamics/mass_matrix.h"
#include "poinsot/engine/dynamics/momentum.h"
#include "poinsot/engine/math/algebra/dual.h"
#include "poinsot/engine/math/algebra/pack.h"

namespace poinsot {
namespace scalars_test {

using testing::Random;
using testing::relative_difference;

// Everything the room computes of a state, in one list.
template <class Scalar>
std::vector<Scalar> everything(const Model<Scalar>& model, const State<Scalar>& state, const std::vector<Scalar>& given,
                               const std::vector<SpatialForce<Scalar>>& external,
                               const std::vector<Constraint<Scalar>>& constraints) {
  Workspace<Scalar> workspace(model);
  const int n = model.velocity_size();
  std::vector<Scalar> all;
  const auto append = [&all](const std::vector<Scalar>& list) { all.insert(all.end(), list.begin(), list.end()); };
  const auto append_vector = [&all](const Vector3<Scalar>& a) { all.insert(all.end(), {a.x, a.y, a.z}); };
  std::vector<Scalar> result(n);
  inverse_dynamics<Scalar>(model, workspace, state, given, result, external);
  append(result);
  append_vector(joint_wrench(model, workspace, model.body_count() - 1).moment);
  append_vector(ground_wrench(workspace).force);
  forward_dynamics<Scalar>(model, workspace, state, given, result, external);
  append(result);
  std::vector<Scalar> acceleration = given;
  std::vector<Scalar> force = given;
  hybrid_dynamics<Scalar>(model, workspace, state, acceleration, force, external);
  append(acceleration);
  append(force);
  std::vector<Scalar> response(n);
  force = given;
  hybrid_response<Scalar>(model, workspace, response, force);
  append(response);
  std::vector<Scalar> M(n * n, Scalar(0));
  mass_matrix<Scalar>(model, workspace, state.q, M);
  append(M);
  update_accelerations<Scalar>(model, workspace, state, given);
  const Vector3<Scalar> p{Scalar(0.3), Scalar(-0.2), Scalar(0.1)};
  const Momentum<Scalar> whole = momentum(model, workspace, p);
  const Momentum<Scalar> rate = momentum_rate(model, workspace, p);
  append_vector(whole.linear);
  append_vector(whole.angular);
  append_vector(rate.linear);
  append_vector(rate.angular);
  all.push_back(kinetic_energy(model, workspace));
  all.push_back(potential_energy(model, workspace));
  append_vector(point_acceleration(model, workspace, model.body_count() - 1, p));
  std::vector<Scalar> J(3 * n, Scalar(0));
  point_jacobian<Scalar>(model, workspace, model.body_count() - 1, p, J);
  append(J);
  acceleration = given;
  force = given;
  std::vector<Scalar> multiplier(constraints.size());
  ConstraintWorkspace<Scalar> constraint_workspace(model, static_cast<int>(constraints.size()));
  constrained_dynamics<Scalar>(model, workspace, constraint_workspace, state, constraints, acceleration, force,
                               multiplier, external);
  append(acceleration);
  append(multiplier);
  std::vector<Scalar> moved = state.q;
  integrate_position<Scalar>(model, moved, given, Scalar(0.125));
  append(moved);
  return all;
}

// A tree, states on it, and constraints between a free first body and the ground, which never degenerate.
struct Cases {
  Model<double> model;
  std::vector<State<double>> states;
  std::vector<std::vector<double>> given;
  std::vector<std::vector<SpatialForce<double>>> external;
  Vector3<double> point;
  Vector3<double> direction;
};
Cases random_cases(Random& random, int count) {
  testing::TreeOptions options;
  options.given_coordinates = true;
  testing::StatedTree tree = testing::random_tree(random, options);
  tree.bodies.front().joint = Joint<double>::free();
  tree.bodies.front().modes.assign(6, CoordinateMode::free);
  if (tree.bodies.front().mass.mass == 0.0) tree.bodies.front().mass = random.mass();
  Cases cases{testing::built(tree), {}, {}, {}, random.vector(), random.direction()};
  for (int i = 0; i < count; ++i) {
    cases.states.push_back(testing::random_state(random, cases.model));
    cases.given.push_back(random.numbers(cases.model.velocity_size(), 2.0));
    cases.external.emplace_back();
    for (int b = 0; b < cases.model.body_count(); ++b) cases.external.back().push_back(random.wrench(2.0));
  }
  return cases;
}
template <class Scalar>
std::vector<Constraint<Scalar>> constraints_of(const Cases& cases) {
  return {Constraint<Scalar>::along(ground, testing::cast<Scalar>(cases.point), testing::cast<Scalar>(cases.direction),
                                    0, testing::cast<Scalar>(cases.point)),
          Constraint<Scalar>::parallel(ground, testing::cast<Scalar>(cases.direction), 0,
                                       testing::cast<Scalar>(cases.point))};
}

template <int W>
void lanes_equal_runs_over_double() {
  Random random(61);
  for (int trial = 0; trial < 60; ++trial) {
    const Cases cases = random_cases(random, W);
    using P = Pack<W>;
    const auto packed = [](auto of) { return P::from_lanes(of); };
    State<P> state;
    std::vector<P> given;
    std::vector<SpatialForce<P>> external;
    for (int k = 0; k < cases.model.position_size(); ++k) {
      state.q.push_back(packed([&](int i) { return cases.states[i].q[k]; }));
    }
    for (int k = 0; k < cases.model.velocity_size(); ++k) {
      state.v.push_back(packed([&](int i) { return cases.states[i].v[k]; }));
      given.push_back(packed([&](int i) { return cases.given[i][k]; }));
    }
    for (int b = 0; b < cases.model.body_count(); ++b) {
      SpatialForce<P> wrench;
      for (std::size_t c = 0; c < 3; ++c) {
        wrench.moment[c] = packed([&](int i) { return cases.external[i][b].moment[c]; });
        wrench.force[c] = packed([&](int i) { return cases.external[i][b].force[c]; });
      }
      external.push_back(wrench);
    }
    const std::vector<P> found =
        everything<P>(convert<P>(cases.model), state, given, external, constraints_of<P>(cases));
    for (int i = 0; i < W; ++i) {
      const std::vector<double> expected = everything<double>(cases.model, cases.states[i], cases.given[i],
                                                              cases.external[i], constraints_of<double>(cases));
      std::vector<double> lane;
      for (const P& x : found) lane.push_back(x.lane(i));
      // Rounding differs where one of the two runs contracts products and sums, and where pivots are chosen.
      ASSERT_LT(relative_difference(lane, expected), 1e-10) << "trial " << trial << ", lane " << i;
    }
  }
}
TEST(PackDynamics, lanes_of_four_equal_runs_over_double) { lanes_equal_runs_over_double<4>(); }
TEST(PackDynamics, lanes_of_eight_equal_runs_over_double) { lanes_equal_runs_over_double<8>(); }

// Different masses, places and axes in every lane.
TEST(PackDynamics, models_may_differ_from_lane_to_lane) {
  Random random(62);
  testing::TreeOptions options;
  options.least_bodies = 4;
  const testing::StatedTree tree = testing::random_tree(random, options);
  std::vector<Model<double>> models;
  for (int i = 0; i < 4; ++i) {
    testing::StatedTree other = tree;
    other.gravity = random.vector(10.0);
    for (testing::StatedBody& body : other.bodies) {
      body.placement = random.pose();
      body.joint.axis = random.direction();
      if (body.mass.mass > 0.0) body.mass = random.mass();
    }
    models.push_back(testing::built(other));
  }
  const Model<Pack<4>> packed = pack_models<Pack<4>>(models);
  const State<double> state = testing::random_state(random, models[0]);
  const std::vector<double> force = random.numbers(packed.velocity_size(), 2.0);
  std::vector<Pack<4>> acceleration(packed.velocity_size());
  Workspace<Pack<4>> workspace(packed);
  forward_dynamics<Pack<4>>(packed, workspace, testing::cast<Pack<4>>(state), testing::cast<Pack<4>>(force),
                            acceleration);
  for (int i = 0; i < 4; ++i) {
    std::vector<double> expected(packed.velocity_size());
    Workspace<double> own(models[i]);
    forward_dynamics<double>(models[i], own, state, force, expected);
    std::vector<double> lane;
    for (const Pack<4>& x : acceleration) lane.push_back(x.lane(i));
    EXPECT_LT(relative_difference(lane, expected), 1e-11);
  }
}

// Derivatives of everything by a random direction in positions, velocities and givens, against fourth-order central
// differences in long double.
TEST(DualDynamics, partials_equal_numerical_differentiation) {
  Random random(63);
  for (int trial = 0; trial < 40; ++trial) {
    const Cases cases = random_cases(random, 1);
    const Model<double>& model = cases.model;
    const State<double>& state = cases.states[0];
    constexpr int N = 4;
    using D = Dual<N>;
    // Direction number i moves positions (tangentially), velocities and givens.
    std::vector<std::vector<double>> dq(N);
    std::vector<std::vector<double>> dv(N);
    std::vector<std::vector<double>> dg(N);
    for (int i = 0; i < N; ++i) {
      dq[i] = random.numbers(model.velocity_size(), 1.0);
      dv[i] = random.numbers(model.velocity_size(), 1.0);
      dg[i] = random.numbers(model.velocity_size(), 1.0);
    }
    State<D> dual_state = testing::cast<D>(state);
    std::vector<D> given = testing::cast<D>(cases.given[0]);
    std::vector<SpatialForce<D>> external;
    for (const SpatialForce<double>& wrench : cases.external[0]) {
      external.push_back({testing::cast<D>(wrench.moment), testing::cast<D>(wrench.force)});
    }
    // The derivative of moving along a tangent: integrate_position over duals with zero value, through zero rotation.
    std::vector<D> tangent(model.velocity_size());
    for (int k = 0; k < model.velocity_size(); ++k) {
      for (int i = 0; i < N; ++i) {
        tangent[k].partial[static_cast<std::size_t>(i)] = dq[i][k];
        dual_state.v[k].partial[static_cast<std::size_t>(i)] = dv[i][k];
        given[k].partial[static_cast<std::size_t>(i)] = dg[i][k];
      }
    }
    const Model<D> dual_model = convert<D>(model);
    integrate_position<D>(dual_model, dual_state.q, tangent, D(1));
    const std::vector<D> found = everything<D>(dual_model, dual_state, given, external, constraints_of<D>(cases));

    using Fine = long double;
    const Model<Fine> fine = convert<Fine>(model);
    std::vector<SpatialForce<Fine>> fine_external;
    for (const SpatialForce<double>& wrench : cases.external[0]) {
      fine_external.push_back({testing::cast<Fine>(wrench.moment), testing::cast<Fine>(wrench.force)});
    }
    for (int i = 0; i < N; ++i) {
      const auto at = [&](Fine t) {
        State<Fine> moved = testing::cast<Fine>(state);
        std::vector<Fine> moved_given = testing::cast<Fine>(cases.given[0]);
        integrate_position<Fine>(fine, moved.q, testing::cast<Fine>(dq[i]), t);
        for (std::size_t k = 0; k < moved.v.size(); ++k) {
          moved.v[k] += t * dv[i][k];
          moved_given[k] += t * dg[i][k];
        }
        return everything<Fine>(fine, moved, moved_given, fine_external, constraints_of<Fine>(cases));
      };
      const Fine h = 1e-4L;
      const std::vector<Fine> p1 = at(h);
      const std::vector<Fine> m1 = at(-h);
      const std::vector<Fine> p2 = at(2.0L * h);
      const std::vector<Fine> m2 = at(-2.0L * h);
      std::vector<Fine> expected(found.size());
      std::vector<Fine> partial(found.size());
      for (std::size_t k = 0; k < found.size(); ++k) {
        expected[k] = (8.0L * (p1[k] - m1[k]) - (p2[k] - m2[k])) / (12.0L * h);
        partial[k] = found[k].partial[static_cast<std::size_t>(i)];
      }
      ASSERT_LT(relative_difference(partial, expected), 1e-9) << "trial " << trial << ", direction " << i;
    }
  }
}

// Second derivatives by duals of duals: of the kinetic energy by the velocities they are the mass matrix.
TEST(DualDynamics, second_derivatives_of_the_kinetic_energy_are_the_mass_matrix) {
  Random random(64);
  testing::StatedTree tree = testing::random_tree(random);
  tree.bodies.resize(1);
  tree.bodies[0].joint = Joint<double>::free();
  tree.bodies[0].mass = random.mass();
  tree.bodies[0].modes.assign(6, CoordinateMode::free);
  const Model<double> model = testing::built(tree);
  const State<double> state = testing::random_state(random, model);
  using Inner = Dual<6>;
  using Outer = Dual<6, Inner>;
  const Model<Outer> second = convert<Outer>(model);
  State<Outer> outer = neutral_state(second);
  for (std::size_t k = 0; k < 7; ++k) outer.q[k] = Outer(state.q[k]);
  for (int k = 0; k < 6; ++k) outer.v[k] = Outer::variable(Inner::variable(state.v[k], k), k);
  Workspace<Outer> workspace(second);
  update_velocities(second, workspace, outer);
  const Outer T = kinetic_energy(second, workspace);
  Workspace<double> plain(model);
  std::vector<double> M(36);
  mass_matrix<double>(model, plain, state.q, M);
  for (std::size_t i = 0; i < 6; ++i) {
    for (std::size_t j = 0; j <= i; ++j) EXPECT_NEAR(T.partial[i].partial[j], M[i * 6 + j], 1e-12);
  }
}

}  // namespace scalars_test
}  // namespace poinsot
