// Equations of motion as traced programs and generated C against the numeric engine, for random trees.
#include "poinsot/engine/dynamics/equations_of_motion.h"

#include <dlfcn.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <random>

#include "engine/motion/mechanism/sample_mechanisms.h"
#include "poinsot/engine/dynamics/forward_dynamics.h"
#include "poinsot/engine/math/trace/straight_line_text.h"
#include "poinsot/engine/model/builder.h"

namespace poinsot {
namespace equations_of_motion_test {

class RandomTree {
 public:
  explicit RandomTree(std::uint64_t seed) : random_(seed) {}

  double number(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  Vector3<double> vector(double size) { return {number(-size, size), number(-size, size), number(-size, size)}; }

  Model<double> model() {
    ModelBuilder<double> builder;
    builder.set_gravity(vector(10));
    const int count = 1 + static_cast<int>(random_() % 5);
    for (int i = 0; i < count; ++i) {
      const int parent = static_cast<int>(random_() % static_cast<std::uint64_t>(i + 1)) - 1;
      const Matrix3<double> R = rotation_exponential(vector(1));
      builder.add_body(
          "body " + std::to_string(i), parent, joint(), {rotation_exponential(vector(1.5)), vector(0.5)},
          {number(0.5, 3), vector(0.2),
           turned(R, SymmetricMatrix3<double>::diagonal(number(0.2, 0.3), number(0.2, 0.3), number(0.2, 0.3)))});
    }
    return builder.build();
  }
  State<double> state(const Model<double>& model) {
    State<double> state = neutral_state(model);
    for (double& v : state.v) v = number(-1, 1);
    integrate_position<double>(model, state.q, state.v, 1.5);
    for (double& v : state.v) v = number(-1, 1);
    return state;
  }
  std::vector<double> numbers(int count) {
    std::vector<double> list(static_cast<std::size_t>(count));
    for (double& x : list) x = number(-2, 2);
    return list;
  }

 private:
  Joint<double> joint() {
    const Vector3<double> axis = vector(1) + Vector3<double>{0, 0, 1.5};
    switch (random_() % 6) {
      case 0:
        return Joint<double>::prismatic(axis);
      case 1:
        return Joint<double>::screw(axis, number(-0.3, 0.3));
      case 2:
        return Joint<double>::ball();
      case 3:
        return Joint<double>::free();
      case 4:
        return Joint<double>::revolute(Vector3<double>::unit(random_() % 3));
      default:
        return Joint<double>::revolute(axis);
    }
  }
  std::mt19937_64 random_;
};

// A model's dynamics as a program of q, v and a third list.
struct TracedDynamics {
  Trace trace;
  TraceScope scope{trace};
  Model<Traced> model;
  State<Traced> state;
  std::vector<Traced> third;
  ProgramText text;

  explicit TracedDynamics(const Model<double>& numbers) : model(convert<Traced>(numbers)) {
    text.function = "dynamics";
    text.arrays = {"q", "v", "a", "parameters"};
    const auto add = [&](const std::string& array, int count, std::vector<Traced>& list) {
      for (int k = 0; k < count; ++k) {
        list.push_back(trace.input(0.3 + 0.11 * static_cast<double>(text.inputs.size())));
        text.inputs.push_back({array, k, array + std::to_string(k + 1), "", false});
      }
    };
    add("q", model.position_size(), state.q);
    add("v", model.velocity_size(), state.v);
    add("a", model.velocity_size(), third);
    text.blocks = {{"x", "results", third.size(), 1, false}};
  }
  std::vector<Traced> inverse() {
    Workspace<Traced> workspace(model);
    std::vector<Traced> force(third.size());
    inverse_dynamics<Traced>(model, workspace, state, third, force);
    return force;
  }
  std::vector<Traced> forward() {
    Workspace<Traced> workspace(model);
    std::vector<Traced> acceleration(third.size());
    forward_dynamics<Traced>(model, workspace, state, third, acceleration);
    return acceleration;
  }
};

void expect_near(const std::vector<double>& found, const std::vector<double>& expected, double tolerance) {
  ASSERT_EQ(found.size(), expected.size());
  double size = 0;
  for (const double x : expected) size = std::max(size, std::fabs(x));
  for (std::size_t k = 0; k < found.size(); ++k) EXPECT_NEAR(found[k], expected[k], tolerance * size) << "entry " << k;
}

TEST(EquationsOfMotion, ProgramsOfRandomTreesAgreeWithTheEngine) {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    RandomTree random(seed);
    const Model<double> model = random.model();
    if (model.velocity_size() == 0) continue;
    TracedDynamics dynamics(model);
    const StraightLine inverse(dynamics.trace, dynamics.inverse()), forward(dynamics.trace, dynamics.forward());
    Workspace<double> workspace(model);
    for (int run = 0; run < 3; ++run) {
      const State<double> state = random.state(model);
      const std::vector<double> third = random.numbers(model.velocity_size());
      std::vector<double> inputs = state.q, expected(third.size()), found(third.size());
      inputs.insert(inputs.end(), state.v.begin(), state.v.end());
      inputs.insert(inputs.end(), third.begin(), third.end());
      inverse_dynamics<double>(model, workspace, state, third, expected);
      inverse.evaluate(inputs, found);
      expect_near(found, expected, 1e-12);
      forward_dynamics<double>(model, workspace, state, third, expected);
      forward.evaluate(inputs, found);
      expect_near(found, expected, 1e-10);
    }
  }
}

// The compiler's verdict is part of the test: C99 alone, no warnings.
TEST(EquationsOfMotion, GeneratedCCompilesAloneAndAgreesWithTheEngine) {
  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() / ("poinsot-generated-" + std::to_string(getpid()));
  std::filesystem::create_directories(folder);
  using Function = void (*)(const double*, const double*, const double*, const double*, double*);
  for (std::uint64_t seed = 101; seed <= 106; ++seed) {
    RandomTree random(seed);
    const Model<double> model = random.model();
    TracedDynamics dynamics(model);
    for (const bool forward : {false, true}) {
      const StraightLine program(dynamics.trace, forward ? dynamics.forward() : dynamics.inverse());
      const std::string stem = (folder / (std::to_string(seed) + (forward ? "f" : "i"))).string();
      std::ofstream(stem + ".c") << write_program(program, dynamics.text, TextForm::c);
      const std::string command =
          "cc -std=c99 -O1 -Wall -Wextra -Werror -pedantic -ffp-contract=off -shared -fPIC -o " + stem + ".so " + stem +
          ".c -lm";
      ASSERT_EQ(std::system(command.c_str()), 0) << command;
      void* library = dlopen((stem + ".so").c_str(), RTLD_NOW | RTLD_LOCAL);
      ASSERT_NE(library, nullptr);
      const auto function = reinterpret_cast<Function>(dlsym(library, "dynamics"));
      ASSERT_NE(function, nullptr);
      Workspace<double> workspace(model);
      for (int run = 0; run < 5; ++run) {
        const State<double> state = random.state(model);
        const std::vector<double> third = random.numbers(model.velocity_size());
        std::vector<double> expected(third.size()), found(third.size());
        function(state.q.data(), state.v.data(), third.data(), nullptr, found.data());
        if (forward)
          forward_dynamics<double>(model, workspace, state, third, expected);
        else
          inverse_dynamics<double>(model, workspace, state, third, expected);
        expect_near(found, expected, forward ? 1e-10 : 1e-12);
      }
      dlclose(library);
    }
  }
  std::filesystem::remove_all(folder);
}

// M a + h from the matrices, and the accelerations by elimination, against the recursive algorithms.
TEST(EquationsOfMotion, MatricesAgreeWithRecursions) {
  for (std::uint64_t seed = 201; seed <= 230; ++seed) {
    RandomTree random(seed);
    Mechanism<double> mechanism;
    mechanism.tree = random.model();
    const Model<double>& model = mechanism.tree;
    const State<double> state = random.state(model);
    const std::vector<double> a = random.numbers(model.velocity_size());
    const EquationsOfMotion<double> equations = equations_of_motion(mechanism, state);
    const auto n = static_cast<std::size_t>(equations.size);
    std::vector<double> expected(n), found(n);
    Workspace<double> workspace(model);
    inverse_dynamics<double>(model, workspace, state, a, expected);
    for (std::size_t i = 0; i < n; ++i) {
      found[i] = -equations.right_side[i];
      for (std::size_t k = 0; k < n; ++k) found[i] += equations.mass[i * n + k] * a[k];
    }
    expect_near(found, expected, 1e-12);
    forward_dynamics<double>(model, workspace, state, std::vector<double>(n, 0.0), expected);
    const std::vector<bool> none(n, false);
    expect_near(solved_accelerations(reduced_equations(equations, none, a)), expected, 1e-9);
  }
}

// A planar loop turned in space moves as it did: of the three of its five constraints that repeat the plane, turning
// leaves rounding, which is no constraint.
TEST(EquationsOfMotion, TurnedPlanarLoopsMoveAsUnturnedOnes) {
  std::mt19937_64 random(51);
  std::uniform_real_distribution<double> number(-1, 1);
  const std::vector<bool> free(3, false);
  const std::vector<double> none(3, 0.0);
  for (int trial = 0; trial < 300; ++trial) {
    testing::FourBar figure;
    figure.crank_angle = 2 * number(random);
    figure.coupler_mass = 1.5 + number(random);
    // The rates with which the loop stays closed, of the relative angles of crank and coupler, and of the rocker.
    const auto solved = [&](const Mechanism<double>& mechanism) {
      State<double> state = neutral_state(mechanism.tree);
      EquationsOfMotion<double> equations = equations_of_motion(mechanism, state);
      const ReducedEquations<double> reduced = reduced_equations(equations, free, none);
      EXPECT_EQ(reduced.independent.size(), 1U) << "trial " << trial;
      for (std::size_t k = 0; k < 3; ++k) state.v[k] = reduced.basis[k].front();
      double largest = 0;
      for (const double v : state.v) largest = std::max(largest, std::abs(v));
      const double factor = std::copysign(2 / largest, state.v[0]);
      for (double& v : state.v) v *= factor;
      equations = equations_of_motion(mechanism, state);
      return solved_accelerations(reduced_equations(equations, free, none));
    };
    const std::vector<double> expected = solved(figure.mechanism());
    figure.R = rotation_exponential(Vector3<double>{3 * number(random), 3 * number(random), 3 * number(random)});
    ASSERT_FALSE(HasFailure());
    expect_near(solved(figure.mechanism()), expected, 1e-9);
    if (HasFailure()) return;
  }
}

}  // namespace equations_of_motion_test
}  // namespace poinsot
