// The regressor of the inertias against inverse dynamics of bodies with other masses.
#include "poinsot/engine/dynamics/inertia_regressor.h"

#include <gtest/gtest.h>

#include "engine/dynamics/random_trees.h"

namespace poinsot {
namespace inertia_regressor_test {

using testing::Random;

// Y does not know the masses: with those of another tree of the same joints it gives the forces there.
TEST(InertiaRegressor, gives_the_joint_forces_of_bodies_of_any_mass) {
  Random random(61);
  for (int trial = 0; trial < 300; ++trial) {
    testing::StatedTree tree = testing::random_tree(random), other = tree;
    for (testing::StatedBody& body : other.bodies) body.mass = random.mass();
    const Model<double> model = testing::built(tree), heavier = testing::built(other);
    const State<double> state = testing::random_state(random, model);
    const int n = model.velocity_size(), columns = inertia_numbers * model.body_count();
    const std::vector<double> a = random.numbers(n, 5.0);
    Workspace<double> workspace(model), of_other(heavier);
    std::vector<double> Y(static_cast<std::size_t>(n * columns), NAN), tau(n), expected(n);
    inertia_regressor<double>(model, workspace, state, a, Y);
    for (int i = 0; i < n; ++i)
      for (int body = 0; body < model.body_count(); ++body) {
        const auto numbers = inertia_numbers_of(heavier, body);
        for (int k = 0; k < inertia_numbers; ++k)
          tau[i] += Y[i * columns + inertia_numbers * body + k] * numbers[static_cast<std::size_t>(k)];
      }
    inverse_dynamics<double>(heavier, of_other, state, a, expected);
    ASSERT_LT(testing::relative_difference(tau, expected), 1e-11) << "trial " << trial;
  }
}

TEST(InertiaRegressor, names_the_inertia_on_the_axes_of_the_body) {
  ModelBuilder<double> builder;
  const SymmetricMatrix3<double> I{3, 4, 5, 0.1, 0.2, 0.3};
  builder.add_body("body", ground, Joint<double>::revolute({1, 0, 0}), {}, {2, {0, 0, 1}, I});
  const auto numbers = inertia_numbers_of(builder.build(), 0);
  const std::array<double, inertia_numbers> expected{2, 0, 0, 2, 5, 6, 5, 0.1, 0.2, 0.3};
  for (std::size_t k = 0; k < expected.size(); ++k) EXPECT_NEAR(numbers[k], expected[k], 1e-14) << k;
}

}  // namespace inertia_regressor_test
}  // namespace poinsot
