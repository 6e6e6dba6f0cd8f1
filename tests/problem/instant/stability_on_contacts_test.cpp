// The motion near a steady one of bodies that touch a floor, in worlds drawn at any slant.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <numbers>

#include "case_count.h"
#include "problem/instant/near_steady.h"

namespace poinsot::problem {
namespace stability_on_contacts_test {

using namespace testing;
using Eigen::Vector3d;

constexpr double g = 9.81;

// The world's axes in the file: z is up.
struct World {
  Eigen::Matrix3d R;

  explicit World(Random& random) {
    const Vector3d turn(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
    R = random.chance(0.3) ? Eigen::Matrix3d(Eigen::Matrix3d::Identity())
                           : Eigen::AngleAxisd(random.uniform(0, 3), turn.normalized()).toRotationMatrix();
  }
  std::string vector(const Vector3d& v, const std::string& unit) const {
    const Vector3d x = R * v;
    return fmt::format("[{:.17g}{}, {:.17g}{}, {:.17g}{}]", x[0], unit, x[1], unit, x[2], unit);
  }
  bool is_upright() const { return R.isIdentity(0); }
  std::string gravity() const { return "gravity: " + vector({0, 0, -g}, " m/s^2") + "\n"; }
};

// A thin disk of mass one that rolls: with the inclination and the angular velocity on axes of which the first stays
// level, the second points up along the disk and the third is its axis, the rates of all four. Moments about the
// center, of the force that its acceleration takes, at the lowest point.
struct RollingDisk {
  double r;

  Vector3d left(const Eigen::Vector4d& x, const Vector3d& rates) const {
    const double a = r * r / 4, c = r * r / 2;
    const Vector3d w = x.tail<3>(), axes(w[0], w[1], w[1] / std::tan(x[0])), H(a * w[0], a * w[1], c * w[2]),
                   v = r * Vector3d(-w[2], 0, w[0]);
    const Vector3d force =
        r * Vector3d(-rates[2], 0, rates[0]) + axes.cross(v) + g * Vector3d(0, std::sin(x[0]), std::cos(x[0]));
    return Vector3d(a * rates[0], a * rates[1], c * rates[2]) + axes.cross(H) - Vector3d(0, -r, 0).cross(force);
  }
  Eigen::Vector4d rates(const Eigen::Vector4d& x) const {
    const Vector3d rest = left(x, Vector3d::Zero());
    Eigen::Matrix3d M;
    for (int k = 0; k < 3; ++k) M.col(k) = left(x, Vector3d::Unit(k)) - rest;
    Eigen::Vector4d all;
    all << x[1], -M.inverse() * rest;
    return all;
  }
  // Its center at a distance from the axis about which it turns at W.
  Eigen::Vector4d going_round(double lean, double distance, double W) const {
    const double spin = -W * (distance + r * std::sin(lean)) / r;
    return {std::numbers::pi / 2 - lean, 0, W * std::cos(lean), spin + W * std::sin(lean)};
  }
  // What is left of the moment about the level axis is linear in W^2.
  double square_of_turning(double lean, double distance) const {
    const auto moment = [&](double W) { return left(going_round(lean, distance, W), Vector3d::Zero())[0]; };
    return -moment(0) / (moment(1) - moment(0));
  }
  // Squared, the rate of the one pair that does not vanish.
  double square_of_frequency(const Eigen::Vector4d& x) const {
    Eigen::Matrix4d A;
    for (int k = 0; k < 4; ++k) {
      const double h = 1e-4 * std::max(1.0, std::abs(x[k]));
      const auto difference = [&](double step) -> Eigen::Vector4d {
        const Eigen::Vector4d ahead = x + step * Eigen::Vector4d::Unit(k), behind = x - step * Eigen::Vector4d::Unit(k);
        return (rates(ahead) - rates(behind)) / (2 * step);
      };
      A.col(k) = (4 * difference(h) - difference(2 * h)) / 3;
    }
    // The sum of the squares of all rates, of which two vanish.
    return -(A * A).trace() / 2;
  }
};

TEST(StabilityOnContacts, DiskThatRollsInACircle) {
  Random random(441);
  constexpr int trials = poinsot::testing::case_count(200);
  int stable = 0, unstable = 0;
  for (int trial = 0; trial < trials; ++trial) {
    const World world(random);
    const RollingDisk disk{random.uniform(0.01, 0.3)};
    const double r = disk.r, lean = random.uniform(0.05, 1.4),
                 distance = random.chance(0.2) ? 0 : r * std::exp(random.uniform(-2, 3)),
                 square = disk.square_of_turning(lean, distance);
    if (!(square > 0)) continue;
    const double W = std::sqrt(square);
    const Eigen::Vector4d x = disk.going_round(lean, distance, W);
    const Vector3d center(distance, 0, r * std::cos(lean)), axis(std::cos(lean), 0, std::sin(lean)),
        touched(distance + r * std::sin(lean), 0, 0);
    const std::string text =
        "title: a disk rolling in a circle\nfind: {P: rad/s, s: rad/s}\nwhere: [P > 0]\n" + world.gravity() +
        "points: {O: [0, 0, 0], G: \"" + world.vector(center, " m") + "\", C: \"" + world.vector(touched, " m") +
        "\"}\ndirections: {a: " + world.vector(axis, "") + ", up: " + world.vector(Vector3d::UnitZ(), "") + "}\n" +
        fmt::format(
            "frames: {{round: {{turns: up, rate: P}}}}\nbodies: {{disk: {{disk: {{center: G, normal: a, radius: "
            "{:.17g} m}}, mass: 2 kg}}}}\ncontacts: {{floor: {{of: disk, at: C, normal: up, no_slip: true}}}}\n"
            "steady: {{frame: round, spins: {{disk: {{about: a, rate: s}}}}}}\n"
            "ask: {{P: P, s: stable(disk), g: growth_rate(disk), f: frequencies(disk)}}\n",
            r);
    const Near near = solved_near(text).front();
    EXPECT_NEAR(near.unknown, W, 1e-7 * W) << text;
    const double expected = disk.square_of_frequency(x);
    if (std::abs(expected) < 1e-3 * x.tail<3>().squaredNorm()) continue;
    (expected > 0 ? stable : unstable) += 1;
    EXPECT_EQ(near.stable, expected > 0) << text;
    EXPECT_EQ(near.frequencies.size(), expected > 0 ? 1U : 0U) << near.list() << text;
    const double rate = std::sqrt(std::abs(expected));
    if (expected > 0) {
      EXPECT_TRUE(near.swings_at(rate)) << "expected " << rate << near.list() << text;
    }
    EXPECT_NEAR(near.growth, expected > 0 ? 0 : rate, 1e-5 * rate) << text;
    if (HasFailure()) return;
  }
  EXPECT_GT(stable, trials / 4);
  EXPECT_GT(unstable, trials / 40);
}

// The mass center of a top on a smooth floor moves up and down alone: the effective potential of its inclination.
TEST(StabilityOnContacts, TopOnASmoothFloor) {
  Random random(442);
  for (int trial = 0; trial < 100; ++trial) {
    const World world(random);
    const double m = random.uniform(0.2, 3), l = random.uniform(0.05, 0.5), I = m * l * l * random.uniform(0.05, 2),
                 J = I * random.uniform(0.51, 3), theta = random.uniform(0.2, 2.9), P = random.uniform(2, 30),
                 sine = std::sin(theta), c = std::cos(theta), b = m * g * l / P + J * P * c;
    const std::string text =
        "title: a top on a smooth floor\nfind: {P: rad/s}\n" + world.gravity() + "points: {G: [0, 0, 0], O: \"" +
        world.vector({-l * sine, 0, -l * c}, " m") + "\"}\ndirections: {up: " + world.vector(Vector3d::UnitZ(), "") +
        "}\n" +
        fmt::format(
            "frames: {{round: {{turns: up, rate: {:.17g} rad/s}}}}\n"
            "bodies: {{top: {{mass: {:.17g} kg, center: G, inertia: {{axis: O->G, axial: {:.17g} kg*m^2, transverse: "
            "{:.17g} kg*m^2}}}}}}\ncontacts: {{tip: {{of: top, at: O, normal: up}}}}\n"
            "steady: {{frame: round, spins: {{top: {{about: O->G, rate: P}}}}}}\n"
            "ask: {{P: P, s: stable(top), g: growth_rate(top), f: frequencies(top)}}\n",
            P, m, I, J);
    const Near near = solved_near(text).front();
    EXPECT_NEAR(near.unknown, b / I - P * c, 1e-7 * (std::abs(b / I) + P)) << text;
    const double curvature = b * b / J - 3 * b * c * P + J * P * P * (sine * sine + 3 * c * c) - m * g * l * c,
                 rate = std::sqrt(std::abs(curvature) / (J + m * l * l * sine * sine));
    EXPECT_EQ(near.stable, curvature > 0) << text;
    EXPECT_EQ(near.frequencies.size(), curvature > 0 ? 1U : 0U) << near.list() << text;
    if (curvature > 0) {
      EXPECT_TRUE(near.swings_at(rate)) << "expected " << rate << near.list() << text;
    }
    EXPECT_NEAR(near.growth, curvature > 0 ? 0 : rate, 1e-5 * rate) << text;
    if (HasFailure()) return;
  }
}

// Beside rates that vanish, slow ones are told apart close to the limit.
TEST(StabilityOnContacts, SlowestRollingOfDiskAndHoop) {
  Random random(443);
  for (int trial = 0; trial < 6; ++trial) {
    const World world(random);
    const double r = random.uniform(0.01, 1);
    for (const bool hoop : {false, true}) {
      const std::string text =
          "title: rolling straight on\nletters: {s: rad/s}\n" + world.gravity() + "points: {C: [0, 0, 0], G: \"" +
          world.vector({0, 0, r}, " m") + "\"}\ndirections: {a: " + world.vector(Vector3d::UnitX(), "") +
          ", up: " + world.vector(Vector3d::UnitZ(), "") + "}\n" +
          fmt::format(
              "bodies: {{wheel: {{{0}: {{center: G, normal: a, radius: {1:.17g} m}}, mass: 2 kg}}}}\n"
              "contacts: {{floor: {{of: wheel, at: C, normal: up, no_slip: true}}}}\n"
              "instants: {{now: {{angular_velocity(wheel): \"s*a\"}}}}\n"
              "ask: {{slow: {{smallest: s, while: stable(wheel)}}}}\n",
              hoop ? "ring" : "disk", r);
      const double expected = std::sqrt(g / ((hoop ? 4 : 3) * r));
      const Statement statement = read_statement(text, "test.yaml");
      const Solution solution = solve_statement(statement, {}).solutions.front();
      const SolvedAsk& slow = solution.asks.front();
      ASSERT_EQ(slow.state, AskState::found) << slow.reason << text;
      EXPECT_NEAR(slow.value.number, expected, 4e-4 * expected) << text;
      // What is farther off says how far the equations do not decide.
      const bool told = std::any_of(solution.notes.begin(), solution.notes.end(), [](const std::string& note) {
        return note.starts_with("slow: from ") && note.ends_with("do not decide");
      });
      if (std::abs(slow.value.number - expected) > 3e-6 * expected) {
        EXPECT_TRUE(told) << slow.value.number << " for " << expected << text;
      }
      if (world.is_upright()) {
        EXPECT_NEAR(slow.value.number, expected, 5e-6 * expected) << text;
      }
    }
  }
}

}  // namespace stability_on_contacts_test
}  // namespace poinsot::problem
