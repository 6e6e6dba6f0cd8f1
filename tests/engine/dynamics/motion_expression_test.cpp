// Loads that follow from the motion: their values by hand, their slopes against differences.
#include "poinsot/engine/dynamics/motion_expression.h"

#include <gtest/gtest.h>

#include <random>

#include "poinsot/engine/dynamics/convert_mechanism.h"
#include "poinsot/engine/model/builder.h"

namespace poinsot {
namespace motion_expression_test {

using Op = MotionOperation;

struct Case {
  Model<double> tree;
  State<double> state;
  MotionExpression<double> load;
};

// An arm on the ground and a slider on it. The load is |v| v + s^2 w x d - (sin(s) + sqrt(|s'|)) p, with v the velocity
// of a place on the slider as the arm sees it, s and s' the slider's coordinate and rate, w the arm's angular velocity,
// d a direction of the slider and p a place on it.
Case random_case(unsigned seed, double stretch) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> any(-1, 1);
  const auto vector = [&] { return Vector3<double>{any(random), any(random), any(random)}; };
  const MassProperties<double> brick{1.0, Vector3<double>::zero(), SymmetricMatrix3<double>::diagonal(0.2, 0.3, 0.25)};
  ModelBuilder<double> builder;
  const SpatialTransform<double> here{Matrix3<double>::identity(), Vector3<double>::zero()};
  builder.add_body("arm", ground, Joint<double>::revolute(normalized(vector())), here, brick);
  builder.add_body("slider", 0, Joint<double>::prismatic(normalized(vector())), here, brick);
  Case made{builder.build(), {{any(random), stretch * any(random)}, {any(random), stretch * any(random)}}, {}};
  using Kind = MotionPartKind;
  made.load.parts = {{Kind::velocity, {1, vector()}, 0, 0},
                     {Kind::coordinate, {}, ground, 1},
                     {Kind::rate, {}, ground, 1},
                     {Kind::angular_velocity, {0, {}}, ground, 0},
                     {Kind::direction, {1, normalized(vector())}, ground, 0},
                     {Kind::position, {1, vector()}, ground, 0}};
  made.load.axes = static_cast<int>(seed % 3) - 1;
  auto& steps = made.load.steps;
  const auto add = [&](Op operation, int first, int second = 0, int third = 0) {
    steps.push_back({operation, first, second, third});
    return static_cast<int>(steps.size()) - 1;
  };
  const auto parts = [&](int part) {
    return std::array<int, 3>{add(Op::part, part, 0), add(Op::part, part, 1), add(Op::part, part, 2)};
  };
  const auto v = parts(0), w = parts(3), d = parts(4), p = parts(5);
  const int s = add(Op::part, 1, 0), rate = add(Op::part, 2, 0), size = add(Op::magnitude, v[0], v[1], v[2]);
  const int square = add(Op::multiply, s, s);
  const int factor = add(Op::add, add(Op::sine, s), add(Op::square_root, add(Op::absolute, rate)));
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
    const int across = add(Op::subtract, add(Op::multiply, w[i], d[j]), add(Op::multiply, w[j], d[i]));
    const int first = add(Op::add, add(Op::multiply, size, v[k]), add(Op::multiply, square, across));
    made.load.results[k] = add(Op::subtract, first, add(Op::multiply, factor, p[k]));
  }
  return made;
}

Vector3<double> value(const Case& made, const State<double>& state) {
  Workspace<double> workspace(made.tree);
  update_velocities(made.tree, workspace, state);
  return made.load.value(made.tree, workspace);
}

Vector3<double> by_hand(const Case& made) {
  Workspace<double> w(made.tree);
  update_velocities(made.tree, w, made.state);
  const auto& parts = made.load.parts;
  const double s = made.state.q[1], rate = made.state.v[1];
  const Vector3<double> P = point_position(made.tree, w, 1, parts[0].at.point);
  const Vector3<double> v = point_velocity(made.tree, w, 1, parts[0].at.point) - cross(angular_velocity(w, 0), P);
  const Vector3<double> d = direction_on_ground(made.tree, w, 1, parts[4].at.point);
  const Vector3<double> p = point_position(made.tree, w, 1, parts[5].at.point);
  const Vector3<double> load =
      norm(v) * v + s * s * cross(angular_velocity(w, 0), d) - (std::sin(s) + std::sqrt(std::abs(rate))) * p;
  return direction_on_body(made.tree, w, made.load.axes, load);
}

TEST(MotionExpression, IsWhatItsStepsSay) {
  for (unsigned seed = 1; seed <= 60; ++seed) {
    const Case made = random_case(seed, 1);
    EXPECT_LT(norm(value(made, made.state) - by_hand(made)), 1e-13) << seed;
  }
}

TEST(MotionExpression, HasTheSlopesThatDifferencesHave) {
  using Varied = Dual<1>;
  for (unsigned seed = 1; seed <= 60; ++seed) {
    const Case made = random_case(seed, 1);
    Mechanism<double> mechanism;
    mechanism.tree = made.tree;
    KnownForce<double> force;
    force.by_motion = std::make_shared<const MotionExpression<double>>(made.load);
    mechanism.forces.push_back(force);
    const Mechanism<Varied> varied = convert_mechanism<Varied>(mechanism, [](double x) { return Varied(x); });
    for (std::size_t k = 0; k < 4; ++k) {
      State<double> up = made.state, down = made.state;
      State<Varied> state{{made.state.q[0], made.state.q[1]}, {made.state.v[0], made.state.v[1]}};
      const auto number = [k](auto& of) -> auto& { return k < 2 ? of.q[k] : of.v[k - 2]; };
      constexpr double step = 1e-6;
      number(up) += step;
      number(down) -= step;
      number(state).partial[0] = 1;
      Workspace<Varied> workspace(varied.tree);
      update_velocities(varied.tree, workspace, state);
      const Vector3<Varied> dual = varied.forces[0].now(varied.tree, workspace);
      const Vector3<double> slope{dual.x.partial[0], dual.y.partial[0], dual.z.partial[0]};
      const Vector3<double> difference = (value(made, up) - value(made, down)) / (2 * step);
      EXPECT_LT(norm(slope - difference), 2e-5 * (1 + norm(slope))) << seed << ' ' << k;
    }
  }
}

// |v| v has the slope zero where v vanishes, although |v| has none there.
TEST(MotionExpression, SquareOfASpeedIsFlatAtRest) {
  using Varied = Dual<1>;
  Case made = random_case(3, 0);
  made.load.parts.resize(1);
  made.load.steps.resize(3);  // the components of the velocity
  made.load.steps.push_back({Op::magnitude, 0, 1, 2});
  for (int k = 0; k < 3; ++k) {
    made.load.steps.push_back({Op::multiply, 3, k, 0});
    made.load.results[static_cast<std::size_t>(k)] = 4 + k;
  }
  Mechanism<double> mechanism;
  mechanism.tree = made.tree;
  mechanism.forces.emplace_back();
  mechanism.forces[0].by_motion = std::make_shared<const MotionExpression<double>>(made.load);
  const Mechanism<Varied> varied = convert_mechanism<Varied>(mechanism, [](double x) { return Varied(x); });
  State<Varied> state{{made.state.q[0], made.state.q[1]}, {made.state.v[0], Varied::variable(0, 0)}};
  Workspace<Varied> workspace(varied.tree);
  update_velocities(varied.tree, workspace, state);
  const Vector3<Varied> now = varied.forces[0].now(varied.tree, workspace);
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_EQ(now[k].value, 0);
    EXPECT_EQ(now[k].partial[0], 0);
  }
}

}  // namespace motion_expression_test
}  // namespace poinsot
