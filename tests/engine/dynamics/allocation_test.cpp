// The algorithms allocate nothing: every call of operator new in this program is counted.
#include <gtest/gtest.h>

#include "allocation_counter.h"
#include "engine/dynamics/random_trees.h"
#include "poinsot/engine/dynamics/constraint.h"
#include "poinsot/engine/dynamics/forward_dynamics.h"
#include "poinsot/engine/dynamics/inverse_dynamics.h"
#include "poinsot/engine/dynamics/mass_matrix.h"
#include "poinsot/engine/dynamics/momentum.h"

namespace poinsot {
namespace allocation_test {

TEST(Allocation, no_algorithm_allocates) {
  if (!counts_allocations) GTEST_SKIP() << "the sanitizer allocates in its own way";
  testing::Random random(71);
  testing::TreeOptions options;
  options.least_bodies = 5;
  options.given_coordinates = true;
  const Model<double> model = testing::built(testing::random_tree(random, options));
  State<double> state = testing::random_state(random, model);
  const int n = model.velocity_size();
  std::vector<double> acceleration = random.numbers(n, 1.0);
  std::vector<double> force = random.numbers(n, 1.0);
  std::vector<double> matrix(n * n);
  std::vector<double> jacobian(3 * n);
  std::vector<double> multiplier(3);
  const std::vector<SpatialForce<double>> external(model.body_count());
  const std::vector<Constraint<double>> constraints =
      coincident_points(ground, random.vector(), model.body_count() - 1, random.vector());
  Workspace<double> workspace(model);
  ConstraintWorkspace<double> constraint_workspace(model, 3);
  const long before = allocations;
  inverse_dynamics<double>(model, workspace, state, acceleration, force, external);
  forward_dynamics<double>(model, workspace, state, force, acceleration, external);
  hybrid_dynamics<double>(model, workspace, state, acceleration, force, external);
  hybrid_response<double>(model, workspace, acceleration, force);
  mass_matrix<double>(model, workspace, state.q, matrix);
  update_accelerations<double>(model, workspace, state, acceleration);
  point_jacobian<double>(model, workspace, 0, Vector3<double>::zero(), jacobian);
  const Momentum<double> rate = momentum_rate(model, workspace, Vector3<double>::zero());
  constrained_dynamics<double>(model, workspace, constraint_workspace, state, constraints, acceleration, force,
                               multiplier, external);
  integrate_position<double>(model, state.q, state.v, 0.1);
  const long after = allocations;
  EXPECT_EQ(after, before);
  EXPECT_TRUE(std::isfinite(rate.linear.x));
  // The counter counts.
  const Workspace<double> another(model);
  EXPECT_GT(allocations, after);
}

}  // namespace allocation_test
}  // namespace poinsot
