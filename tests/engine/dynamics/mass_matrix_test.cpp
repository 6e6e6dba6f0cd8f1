// The mass matrix against inverse dynamics, the kinetic energy and closed forms.
#include "poinsot/engine/dynamics/mass_matrix.h"

#include <gtest/gtest.h>

#include "engine/dynamics/random_trees.h"
#include "poinsot/engine/dynamics/inverse_dynamics.h"
#include "poinsot/engine/dynamics/momentum.h"

namespace poinsot {
namespace mass_matrix_test {

using testing::Random;
using testing::relative_difference;

TEST(MassMatrix, columns_are_inverse_dynamics_of_unit_accelerations) {
  Random random(31);
  for (int trial = 0; trial < 1000; ++trial) {
    testing::TreeOptions options;
    options.most_bodies = 10;
    testing::StatedTree tree = testing::random_tree(random, options);
    tree.gravity = Vector3<double>::zero();
    const Model<double> model = testing::built(tree);
    State<double> state = testing::random_state(random, model);
    const int n = model.velocity_size();
    Workspace<double> workspace(model);
    std::vector<double> M(n * n, NAN);
    mass_matrix<double>(model, workspace, state.q, M);
    mirror_lower_triangle<double>(M, n);
    State<double> rest = state;
    rest.v.assign(rest.v.size(), 0.0);
    std::vector<double> expected(n * n);
    for (int k = 0; k < n; ++k) {
      std::vector<double> unit(n, 0.0);
      unit[k] = 1.0;
      inverse_dynamics<double>(model, workspace, rest, unit, std::span<double>(expected).subspan(k * n, n));
    }
    ASSERT_LT(relative_difference(M, expected), 1e-11) << "trial " << trial;
    // T = v . M v / 2.
    update_velocities(model, workspace, state);
    double doubled = 0.0;
    for (int i = 0; i < n; ++i) {
      for (int j = 0; j < n; ++j) doubled += state.v[i] * M[i * n + j] * state.v[j];
    }
    const double kinetic = kinetic_energy(model, workspace);
    ASSERT_NEAR(0.5 * doubled, kinetic, 1e-11 * (1.0 + kinetic)) << "trial " << trial;
  }
}

TEST(MassMatrix, of_a_free_body_is_its_inertia_on_its_own_axes) {
  Random random(32);
  const MassProperties<double> mass = random.mass();
  ModelBuilder<double> builder;
  builder.add_body("body", ground, Joint<double>::free(), random.pose(), mass);
  const Model<double> model = builder.build();
  const State<double> state = testing::random_state(random, model);
  Workspace<double> workspace(model);
  std::vector<double> M(36);
  mass_matrix<double>(model, workspace, state.q, M);
  mirror_lower_triangle<double>(M, 6);
  const Matrix3<double> I = as_matrix(inertia_about(mass, Vector3<double>::zero()));
  const Matrix3<double> H = cross_matrix(mass.mass * mass.center);
  std::vector<double> expected(36, 0.0);
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      expected[i * 6 + j] = I(i, j);
      expected[i * 6 + j + 3] = H(i, j);
      expected[(j + 3) * 6 + i] = H(i, j);
    }
    expected[(i + 3) * 6 + i + 3] = mass.mass;
  }
  EXPECT_LT(relative_difference(M, expected), 1e-14);
}

// A body far from the ground's origin keeps its digits: positions enter only relative to the tree's first body.
TEST(MassMatrix, keeps_its_digits_far_from_the_origin) {
  Random random(33);
  const auto matrix = [&](double far, std::uint64_t seed) {
    Random same(seed);
    ModelBuilder<double> builder;
    const int base = builder.add_body("base", ground, Joint<double>::free(), {}, same.mass());
    builder.add_body("arm", base, Joint<double>::revolute(same.direction()), same.pose(), same.mass());
    const Model<double> model = builder.build();
    State<double> state = testing::random_state(same, model);
    state.q[4] = far;
    Workspace<double> workspace(model);
    std::vector<double> M(49);
    mass_matrix<double>(model, workspace, state.q, M);
    mirror_lower_triangle<double>(M, 7);
    return M;
  };
  EXPECT_LT(relative_difference(matrix(7e6, 5), matrix(0.0, 5)), 1e-14);
}

TEST(MassMatrix, refuses_lists_of_the_wrong_size) {
  Random random(34);
  const Model<double> model = testing::built(testing::random_tree(random));
  Workspace<double> workspace(model);
  const State<double> state = neutral_state(model);
  std::vector<double> wrong(model.velocity_size() * model.velocity_size() + 1);
  EXPECT_THROW(mass_matrix<double>(model, workspace, state.q, wrong), std::invalid_argument);
  EXPECT_THROW(mirror_lower_triangle<double>(wrong, model.velocity_size()), std::invalid_argument);
}

}  // namespace mass_matrix_test
}  // namespace poinsot
