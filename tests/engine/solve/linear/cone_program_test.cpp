#include "engine/solve/linear/cone_program.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <random>

#include "engine/solve/linear/linear_program.h"

namespace poinsot::solve {
namespace cone_program_test {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Rows of random cones that hold a place inside all of them.
ConeProgram random_program(std::mt19937_64& random, Index unknowns, const std::vector<Index>& sizes) {
  std::uniform_real_distribution<double> uniform(-1, 1);
  ConeProgram program;
  program.sizes = sizes;
  Index rows = 0;
  for (const Index size : sizes) rows += size;
  program.G = MatrixXd::NullaryExpr(rows, unknowns, [&] { return uniform(random); });
  program.c = VectorXd::NullaryExpr(unknowns, [&] { return uniform(random); });
  VectorXd inside = VectorXd::NullaryExpr(rows, [&] { return 0.3 * uniform(random); });
  Index first = 0;
  for (const Index size : sizes) {
    inside[first] = inside.segment(first + 1, size - 1).norm() + 0.5;
    first += size;
  }
  program.h = program.G * VectorXd::NullaryExpr(unknowns, [&] { return uniform(random); }) + inside;
  program.reach = 50;
  return program;
}

// By how much rows lie outside of their cones.
double outside(const ConeProgram& program, const VectorXd& rows) {
  double most = 0;
  Index first = 0;
  for (const Index size : program.sizes) {
    most = std::max(most, rows.segment(first + 1, size - 1).norm() - rows[first]);
    first += size;
  }
  return most;
}

TEST(ConeProgram, random_ones_are_bounded_by_their_multipliers_at_the_place_itself) {
  std::mt19937_64 random(7);
  for (int n = 0; n < 300; ++n) {
    std::vector<Index> sizes;
    for (int k = 0; k < 2 + n % 7; ++k) sizes.push_back(k % 3 == 0 ? 1 : 2 + (n + k) % 3);
    const ConeProgram program = random_program(random, 2 + n % 5, sizes);
    const auto optimum = minimise(program);
    ASSERT_TRUE(optimum) << n;
    const double value = program.c.dot(optimum->x), size = std::max(1.0, std::abs(value));
    EXPECT_LT(outside(program, program.h - program.G * optimum->x), 1e-11) << n;
    EXPECT_LT(optimum->x.norm(), program.reach + 1e-9);
    EXPECT_EQ(outside(program, optimum->multipliers), 0) << n;
    EXPECT_NEAR(value, optimum->bound, 1e-11 * program.reach * size) << n;
    EXPECT_LE(optimum->bound, value + 1e-11 * size) << n;
    // The multipliers themselves tell that no place within reach has less.
    const VectorXd left = program.G.transpose() * optimum->multipliers + program.c;
    EXPECT_LE(optimum->bound, -program.h.dot(optimum->multipliers) - left.norm() * program.reach + 1e-9 * size) << n;
  }
}

TEST(ConeProgram, of_one_disk_ends_where_the_direction_leaves_it) {
  // |(x - 1, 2 y)| <= 3 and the least of x + y: an ellipse, by its support function 1 - 3 sqrt(1 + 1/4).
  ConeProgram program;
  program.c = Eigen::Vector2d(1, 1);
  program.G = MatrixXd::Zero(3, 2);
  program.G(1, 0) = -1;
  program.G(2, 1) = -2;
  program.h = Eigen::Vector3d(3, -1, 0);
  program.sizes = {3};
  const auto optimum = minimise(program);
  ASSERT_TRUE(optimum);
  EXPECT_NEAR(optimum->bound, 1 - 3 * std::sqrt(1.25), 1e-12);
  EXPECT_NEAR(program.c.dot(optimum->x), 1 - 3 * std::sqrt(1.25), 1e-12);
}

TEST(ConeProgram, of_planes_alone_is_the_linear_program) {
  std::mt19937_64 random(11);
  for (int n = 0; n < 100; ++n) {
    const Index unknowns = 2 + n % 3;
    // A box keeps it from going on without end.
    ConeProgram program = random_program(random, unknowns, std::vector<Index>(static_cast<std::size_t>(3 + n % 4), 1));
    const Index rows = program.G.rows();
    MatrixXd G(rows + 2 * unknowns, unknowns);
    G << program.G, MatrixXd::Identity(unknowns, unknowns), -MatrixXd::Identity(unknowns, unknowns);
    VectorXd h(rows + 2 * unknowns);
    h << program.h, VectorXd::Constant(2 * unknowns, 3);
    program.G = G;
    program.h = h;
    program.sizes.assign(static_cast<std::size_t>(G.rows()), 1);
    MatrixXd A(G.rows(), 2 * unknowns + G.rows());
    A << G, -G, MatrixXd::Identity(G.rows(), G.rows());
    VectorXd c = VectorXd::Zero(A.cols());
    c.head(unknowns) = -program.c;
    c.segment(unknowns, unknowns) = program.c;
    const auto by_corners = maximise(A, h, c);
    const auto optimum = minimise(program);
    ASSERT_TRUE(by_corners && optimum) << n;
    EXPECT_NEAR(-by_corners->value, optimum->bound, 1e-9) << n;
  }
}

}  // namespace cone_program_test
}  // namespace poinsot::solve
