// Derivatives of the dynamics against dual numbers, differences and closed forms.
#include "poinsot/engine/dynamics/dynamics_derivatives.h"

#include <gtest/gtest.h>

#include "engine/dynamics/random_trees.h"
#include "poinsot/engine/dynamics/inverse_dynamics.h"
#include "poinsot/engine/math/algebra/dual.h"

namespace poinsot {
namespace dynamics_derivatives_test {

using testing::Random;
using testing::relative_difference;
using Numbers = std::vector<double>;

struct Slopes {
  Numbers by_position, by_velocity, by_third;
};

Slopes of_inverse(const Model<double>& model, const State<double>& state, const Numbers& acceleration) {
  const std::size_t size = acceleration.size() * acceleration.size();
  Slopes found{Numbers(size, NAN), Numbers(size, NAN), Numbers(size, NAN)};
  DerivativesWorkspace<double> workspace(model);
  inverse_dynamics_derivatives<double>(model, workspace, state, acceleration,
                                       {found.by_position, found.by_velocity, found.by_third});
  return found;
}

Slopes of_forward(const Model<double>& model, const State<double>& state, const Numbers& force) {
  const std::size_t size = force.size() * force.size();
  Slopes found{Numbers(size, NAN), Numbers(size, NAN), Numbers(size, NAN)};
  DerivativesWorkspace<double> workspace(model);
  forward_dynamics_derivatives<double>(model, workspace, state, force,
                                       {found.by_position, found.by_velocity, found.by_third});
  return found;
}

// The same by dual numbers, a column at a time, of a function of state and third that finds as many numbers.
template <class Function>
Slopes by_duals(const Model<double>& model, const State<double>& state, const Numbers& third, Function function) {
  using D = Dual<1>;
  const Model<D> wide = convert<D>(model);
  Workspace<D> workspace(wide);
  const auto n = static_cast<int>(third.size());
  Slopes found{Numbers(n * n), Numbers(n * n), Numbers(n * n)};
  const auto column = [&](Numbers& to, int k, const State<D>& at, const std::vector<D>& given) {
    std::vector<D> result(given.size());
    function(wide, workspace, at, given, result);
    for (int i = 0; i < n; ++i) to[i * n + k] = result[i].partial[0];
  };
  for (int k = 0; k < n; ++k) {
    const std::vector<D> given = testing::cast<D>(third);
    State<D> at = testing::cast<D>(state);
    std::vector<D> along(n, D(0));
    along[k] = D(1);
    // As integrate_position displaces them, in the first instant.
    integrate_position<D>(wide, at.q, along, D::variable(0.0, 0));
    column(found.by_position, k, at, given);
    at = testing::cast<D>(state);
    at.v[k] = D::variable(state.v[k], 0);
    column(found.by_velocity, k, at, given);
    at = testing::cast<D>(state);
    std::vector<D> varied = given;
    varied[k] = D::variable(third[k], 0);
    column(found.by_third, k, at, varied);
  }
  return found;
}

TEST(DynamicsDerivatives, of_inverse_dynamics_are_those_of_dual_numbers) {
  Random random(51);
  for (int trial = 0; trial < 400; ++trial) {
    const Model<double> model = testing::built(testing::random_tree(random));
    const State<double> state = testing::random_state(random, model);
    const Numbers a = random.numbers(model.velocity_size(), 5.0);
    const Slopes found = of_inverse(model, state, a);
    const Slopes expected =
        by_duals(model, state, a, [](const auto& of, auto& workspace, const auto& at, const auto& given, auto& result) {
          using S = typename std::decay_t<decltype(given)>::value_type;
          inverse_dynamics<S>(of, workspace, at, given, result);
        });
    ASSERT_LT(relative_difference(found.by_position, expected.by_position), 1e-11) << "trial " << trial;
    ASSERT_LT(relative_difference(found.by_velocity, expected.by_velocity), 1e-11) << "trial " << trial;
    ASSERT_LT(relative_difference(found.by_third, expected.by_third), 1e-11) << "trial " << trial;
  }
}

TEST(DynamicsDerivatives, of_forward_dynamics_are_those_of_dual_numbers) {
  Random random(52);
  for (int trial = 0; trial < 400; ++trial) {
    testing::TreeOptions options;
    options.massless_bodies = false;
    const Model<double> model = testing::built(testing::random_tree(random, options));
    const State<double> state = testing::random_state(random, model);
    const Numbers force = random.numbers(model.velocity_size(), 5.0);
    const Slopes found = of_forward(model, state, force);
    const Slopes expected = by_duals(
        model, state, force, [](const auto& of, auto& workspace, const auto& at, const auto& given, auto& result) {
          using S = typename std::decay_t<decltype(given)>::value_type;
          forward_dynamics<S>(of, workspace, at, given, result);
        });
    ASSERT_LT(relative_difference(found.by_position, expected.by_position), 1e-8) << "trial " << trial;
    ASSERT_LT(relative_difference(found.by_velocity, expected.by_velocity), 1e-8) << "trial " << trial;
    ASSERT_LT(relative_difference(found.by_third, expected.by_third), 1e-8) << "trial " << trial;
  }
}

// A pendulum of length l: a = -(g/l) sin q + tau/(m l^2), so that its slopes are -(g/l) cos q, 0 and 1/(m l^2).
TEST(DynamicsDerivatives, of_a_pendulum_are_known) {
  const double m = 2, l = 0.5, g = 9.81;
  ModelBuilder<double> builder;
  builder.set_gravity({0, -g, 0});
  builder.add_body("bob", ground, Joint<double>::revolute({0, 0, 1}), {},
                   {m, {0, -l, 0}, SymmetricMatrix3<double>::zero()});
  const Model<double> model = builder.build();
  const Slopes found = of_forward(model, {{0.7}, {3.0}}, {0.4});
  EXPECT_NEAR(found.by_position[0], -g / l * std::cos(0.7), 1e-13);
  EXPECT_NEAR(found.by_velocity[0], 0, 1e-13);
  EXPECT_NEAR(found.by_third[0], 1 / (m * l * l), 1e-13);
}

// Euler's equations (Eq. 18.26) on principal axes: d(dw_x)/dw_y = (I_y - I_z) w_z / I_x, and so on.
TEST(DynamicsDerivatives, of_a_free_body_are_those_of_eulers_equations) {
  const Vector3<double> I{1, 2, 4}, w{0.3, -1.1, 2.0};
  ModelBuilder<double> builder;
  builder.add_body("body", ground, Joint<double>::ball(), {},
                   {3, {}, SymmetricMatrix3<double>::diagonal(I.x, I.y, I.z)});
  const Model<double> model = builder.build();
  const Slopes found = of_forward(model, {{1, 0, 0, 0}, {w.x, w.y, w.z}}, {0, 0, 0});
  const Numbers expected{0, (I.y - I.z) * w.z / I.x, (I.y - I.z) * w.y / I.x, (I.z - I.x) * w.z / I.y,
                         0, (I.z - I.x) * w.x / I.y, (I.x - I.y) * w.y / I.z, (I.x - I.y) * w.x / I.z,
                         0};
  EXPECT_LT(relative_difference(found.by_velocity, expected), 1e-14);
  for (const double slope : found.by_position) EXPECT_NEAR(slope, 0, 1e-14);
}

// A body at a place of a thousand kilometers keeps its digits.
TEST(DynamicsDerivatives, keep_their_digits_far_from_the_origin) {
  Random random(53);
  const MassProperties<double> mass = random.mass();
  const Numbers a = random.numbers(6, 5.0), v = random.numbers(6, 2.0);
  const auto at = [&](double far) {
    ModelBuilder<double> builder;
    builder.set_gravity({0, 0, -9.81});
    builder.add_body("body", ground, Joint<double>::free(), {}, mass);
    return of_inverse(builder.build(), {{1, 0, 0, 0, far, -far, far}, v}, a);
  };
  const Slopes near = at(0), far = at(1e6);
  EXPECT_EQ(near.by_position, far.by_position);
  EXPECT_EQ(near.by_velocity, far.by_velocity);
}

TEST(DynamicsDerivatives, refuse_sizes_that_do_not_fit) {
  ModelBuilder<double> builder;
  builder.add_body("body", ground, Joint<double>::ball(), {}, {1, {}, SymmetricMatrix3<double>::diagonal(1, 1, 1)});
  const Model<double> model = builder.build();
  DerivativesWorkspace<double> workspace(model);
  Numbers slopes(9), short_one(8), a(3);
  const State<double> state = neutral_state(model);
  EXPECT_THROW(inverse_dynamics_derivatives<double>(model, workspace, state, a, {slopes, slopes, short_one}),
               std::invalid_argument);
  EXPECT_THROW(inverse_dynamics_derivatives<double>(model, workspace, state, short_one, {slopes, slopes, slopes}),
               std::invalid_argument);
}

}  // namespace dynamics_derivatives_test
}  // namespace poinsot
