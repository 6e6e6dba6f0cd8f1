// Responses to what shakes against the complex matrices of masses on springs, the closed forms of rotors, motions that
// are followed until free swings have died out, and what is refused.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <complex>
#include <numbers>

#include "problem/course/motion_support.h"
#include "problem/instant/near_steady.h"

namespace poinsot::problem {
namespace {
namespace response_test {

using namespace testing;
using Complex = std::complex<double>;

// The amplitude and phase of an answer.
Complex swing_of(const SolvedText& solved, const std::string& name, std::size_t row = 0) {
  const std::vector<SolvedColumn>& columns = solved.found(name).columns;
  return std::polar(columns[0].values[row], columns[1].values[row]);
}

void expect_near(const Complex& found, const Complex& expected, double relative, const std::string& words) {
  EXPECT_LE(std::abs(found - expected), relative * std::abs(expected)) << words << ": " << found << " " << expected;
}

// Masses that slide along x, each held to the ground and to the next by a spring with a damper, one of them shaken.
TEST(Response, IsThatOfTheComplexMatrixOfSpringsAndDampers) {
  Random random(20);
  for (int trial = 0; trial < 12; ++trial) {
    const int count = 1 + trial % 3;
    Eigen::MatrixXd M = Eigen::MatrixXd::Zero(count, count), C = M, K = M;
    std::string points = "O: [0, 0, 0]", bodies, joints, springs;
    const auto spring = [&](int i, int k) {
      const double stiffness = random.uniform(50, 2000), damping = random.uniform(0.1, 20);
      for (const auto& [matrix, size] : {std::pair(&K, stiffness), std::pair(&C, damping)}) {
        (*matrix)(k, k) += size;
        if (i < 0) continue;
        (*matrix)(i, i) += size;
        (*matrix)(i, k) -= size;
        (*matrix)(k, i) -= size;
      }
      springs += fmt::format(
          "  s{}_{}: {{from: {}, at: {}, to: b{}, end: P{}, stiffness: {:.17g} N/m, free_length: {} m, damping: "
          "{:.17g} N*s/m}}\n",
          i + 1, k, i < 0 ? "ground" : fmt::format("b{}", i), i < 0 ? "O" : fmt::format("P{}", i), k, k, stiffness,
          i < 0 ? k + 1 : 1, damping);
    };
    for (int k = 0; k < count; ++k) {
      M(k, k) = random.uniform(0.5, 5);
      points += fmt::format(", P{}: [{} m, 0, 0]", k, k + 1);
      bodies += fmt::format("  b{}: {{particle: P{}, mass: {:.17g} kg}}\n", k, k, M(k, k));
      joints += fmt::format("  j{}: {{prismatic: x, at: P{}, to: b{}, displacement: x{}}}\n", k, k, k, k);
      spring(-1, k);
      if (k > 0) spring(k - 1, k);
    }
    const double F = random.uniform(1, 20), w = random.uniform(0, 40);
    const int shaken = trial % count;
    std::string asks;
    for (int k = 0; k < count; ++k) asks += fmt::format("  r{}: response(x{} to push)\n", k, k);
    const SolvedText solved(
        fmt::format("points: {{{}}}\nbodies:\n{}joints:\n{}springs:\n{}gravity: none\ninstants: {{now: "
                    "rest}}\nexcitations:\n  push: {{force: {:.17g} N, along: x, body: b{}, frequency: "
                    "{:.17g} rad/s}}\nask:\n{}",
                    points, bodies, joints, springs, F, shaken, w, asks));
    Eigen::VectorXcd f = Eigen::VectorXcd::Zero(count);
    f[shaken] = F;
    const Eigen::MatrixXcd D = (K - w * w * M).cast<Complex>() + Complex(0, w) * C.cast<Complex>();
    const Eigen::VectorXcd x = D.partialPivLu().solve(f);
    for (int k = 0; k < count; ++k)
      expect_near(swing_of(solved, fmt::format("r{}", k)), x[k], 1e-10, fmt::format("trial {} mass {}", trial, k));
  }
}

constexpr const char* pendulum = R"(
given: {m: 2 kg, L: 0.8 m, c: 0.9 N*m*s/rad, M: 0.001 N*m, w: 4 rad/s, late: 20*pi/w, sooner: 39*pi/(2*w)}
points: {O: [0, 0, 0], P: [0, -L, 0]}
bodies: {bob: {rod: [O, P], mass: m}}
joints: {pin: {revolute: z, at: O, to: bob, angle: q, damping: c}}
gravity: -y
)";

// A motion is followed until the free swings are gone: at two times a quarter apart it has the response's parts.
TEST(Response, IsWhatIsLeftOfAMotionThatIsFollowed) {
  const SolvedText near(std::string(pendulum) + R"(
instants: {now: rest}
excitations: {push: {couple: M, about: z, body: bob, frequency: w}}
ask: {r: response(q to push), f: response(reaction(pin).x to push)}
)");
  const SolvedText followed(std::string(pendulum) + R"(
loads: {push: {couple: M*cos(w*time), about: z, body: bob}}
instants: {start: {q: 0, "q'": 0}}
ask: {real: q @ late, imaginary: q @ sooner, force: reaction(pin).x @ late}
)");
  const Complex expected(followed.found("real").value.number, followed.found("imaginary").value.number);
  // cos(w t + p) is the real part at whole turns, and at a quarter before the imaginary one.
  expect_near(swing_of(near, "r"), expected, 1e-5, "angle");
  EXPECT_NEAR(swing_of(near, "f").real(), followed.found("force").value.number, 1e-5 * std::abs(swing_of(near, "f")));
}

// A force without a point acts at the mass center, on whatever axes the joint of its body has.
TEST(Response, ActsAtTheMassCenterOfBodiesOnAnyAxes) {
  const SolvedText solved(R"(
given: {m: 2 kg, L: 0.8 m, c: 0.9 N*m*s/rad, w: 4 rad/s}
points: {O: [0, 0, 0], P: [0, 0, -L], G: [0, 0, -L/2]}
bodies: {bob: {rod: [O, P], mass: m}}
joints: {pin: {revolute: x, at: O, to: bob, angle: q, damping: c}}
gravity: -z
instants: {now: rest}
excitations:
  push: {force: 0.01 N, along: y, body: bob, frequency: w}
  same: {force: 0.01 N, along: y, at: G, body: bob, frequency: w}
ask: {r: response(q to push), s: response(q to same)}
)");
  const double m = 2, L = 0.8, w = 4;
  const Complex q = 0.01 * L / 2 / Complex(m * 9.80665 * L / 2 - m * L * L / 3 * w * w, 0.9 * w);
  expect_near(swing_of(solved, "r"), q, 1e-10, "no point");
  expect_near(swing_of(solved, "s"), q, 1e-10, "the same point");
}

std::string rotor(const std::string& excitations, const std::string& asks, const std::string& rate = "1500 rpm") {
  return "given: {I: 0.02 kg*m^2, J: 0.015 kg*m^2, k: 60 N*m/rad, n: " + rate + ", M: 0.5 N*m, w: 20 rad/s}\n" + R"(
points: {O: [0, 0, 0], P: [0, 0, 0.1 m], B: [0.1 m, 0, 0]}
bodies:
  ring: massless
  inner: massless
  rotor: {mass: 2 kg, center: O, inertia: {axis: z, axial: I, transverse: J}}
joints:
  outer: {revolute: x, at: O, to: ring, angle: a, spring: {stiffness: k}}
  middle: {revolute: y, at: O, from: ring, to: inner, angle: b, spring: {stiffness: k}}
  axle: {revolute: z, at: O, from: inner, to: rotor, rate: n, accel: 0}
gravity: none
steady: {frame: ground, spins: {rotor: {about: z, rate: n}}}
excitations:
)" + excitations +
         "ask:\n" + asks;
}

TEST(Response, SplitsWhatGoesRoundAheadAndBack) {
  const SolvedText solved(
      rotor("  ahead: {couple: M, about: x, turns: z, body: rotor, frequency: w}\n"
            "  back: {couple: M, about: x, turns: -z, body: rotor, frequency: w}\n"
            "  heavy: {unbalance: 1 g*m, along: x, at: P, body: rotor}\n",
            "  a: response(a to ahead)\n  b: response(b to ahead)\n  c: response(a to back)\n"
            "  d: response(b to back)\n  u: response(b to heavy)\n"));
  const double I = 0.02, J = 0.015, k = 60, n = 1500 * 2 * std::numbers::pi / 60, w = 20, M = 0.5;
  const double ahead = M / (k - J * w * w + I * n * w), back = M / (k - J * w * w - I * n * w);
  expect_near(swing_of(solved, "a"), ahead, 1e-10, "ahead");
  expect_near(swing_of(solved, "b"), Complex(0, -ahead), 1e-10, "ahead");
  expect_near(swing_of(solved, "c"), back, 1e-10, "back");
  expect_near(swing_of(solved, "d"), Complex(0, back), 1e-10, "back");
  // The unbalance at P turns the rotor about y by the couple of its force, U n^2 times 0.1 m, going round with the
  // spin.
  expect_near(swing_of(solved, "u"), 1e-3 * n * n * 0.1 / (k - J * n * n + I * n * n), 1e-10, "unbalance");
}

// A cart on a spring, and what is said of an ask `r` of it.
std::string cart(const std::string& excitations, const std::string& ask) {
  return "given: {m: 2 kg, k: 800 N/m, F: 3 N}\npoints: {O: [0, 0, 0]}\nbodies: {cart: {particle: O, mass: "
         "m}}\njoints: "
         "{rail: {prismatic: x, at: O, to: cart, displacement: s, spring: {stiffness: k}}}\ngravity: none\nloads: "
         "{wind: {force: 0 N, along: x, body: cart}}\ninstants: {now: rest}\nexcitations: {" +
         excitations + "}\nask: {r: " + ask + "}\n";
}
constexpr const char* push = "push: {force: F, along: x, body: cart, frequency: 5 rad/s}";

TEST(Response, IsRefusedWhereThereIsNone) {
  const auto reason = [](const std::string& text) { return SolvedText(text).reason("r"); };
  EXPECT_NE(reason(cart(push, "response(s to push at 20 rad/s)")).find("no bounded response"), std::string::npos);
  EXPECT_NE(reason(R"(
points: {O: [0, 0, 0], P: [0, 0.8 m, 0]}
bodies: {rod: {rod: [O, P], mass: 2 kg}}
joints: {pin: {revolute: z, at: O, to: rod, angle: q}}
gravity: -y
instants: {now: rest}
excitations: {push: {couple: 1 N*m, about: z, body: rod, frequency: 5 rad/s}}
ask: {r: response(q to push)}
)")
                .find("unstable"),
            std::string::npos);
  // In a turning frame what is on ground axes follows the turning.
  const SolvedText turning(R"(
given: {m: 1 kg, k: 900 N/m, w: 5 rad/s}
points: {O: [0, 0, 0]}
bodies: {table: massless, bob: {particle: O, mass: m}}
joints:
  axle: {revolute: z, at: O, to: table, rate: w, accel: 0}
  groove: {prismatic: x, at: O, from: table, to: bob, displacement: s, spring: {stiffness: k}, damping: 3 N*s/m}
steady: {frame: table}
gravity: none
excitations: {push: {force: 2 N, along: x, axes: table, body: bob, frequency: 7 rad/s}}
ask:
  s: response(s to push)
  x: response(position(O of bob).x to push)
  own: {of: 'response(force(groove on bob) to push)', axes: table}
)");
  const Complex slides = 2.0 / Complex(900 - 25 - 49, 21);
  expect_near(swing_of(turning, "s"), slides, 1e-10, "groove");
  EXPECT_NE(turning.reason("x").find("follows the turning as well"), std::string::npos);
  expect_near(swing_of(turning, "own", 0), -Complex(900, 21) * slides, 1e-10, "spring");
  // The guide gives Coriolis's force 2 m w s' across.
  expect_near(swing_of(turning, "own", 1), Complex(0, 2 * 5 * 7) * slides, 1e-10, "guide");
}

TEST(Response, SaysWhatIsWrong) {
  const auto expect_words = [](const std::string& text, const std::string& words) {
    const std::string found = failure_of_text(text);
    EXPECT_NE(found.find(words), std::string::npos) << found;
  };
  expect_words(cart(push, "response(s to pull)"), "there is no excitation 'pull'");
  expect_words(cart(push, "response(s to wind)"), "'wind' is a load, which acts in the steady motion itself");
  expect_words(cart("push: {force: F, along: x, body: cart}", "response(s to push)"),
               "the frequency of 'push' is not stated");
  expect_words(cart("push: {force: F, along: x, body: cart, frequency: -5 rad/s}", "response(s to push)"),
               "a frequency is not negative");
  expect_words(cart("push: {body: cart}", "response(s to push)"), "states nothing that swings");
  expect_words(cart("push: {force: F, along: x, body: car, frequency: 5 rad/s}", "response(s to push)"),
               "there is no body 'car'");
  expect_words(cart("push: {moves: s, by: 1 mm, frequency: 5 rad/s}", "response(s to push)"), "moves as forces let it");
  expect_words(cart("push: {moves: t, by: 1 mm, frequency: 5 rad/s}", "response(s to push)"),
               "there is no coordinate 't'");
  expect_words(cart("push: {unbalance: 1 g*m, along: x, body: cart}", "response(s to push)"), "does not spin");
  expect_words(
      rotor("  beside: {force: 1 N, along: z, at: B, body: rotor, frequency: w}\n", "  r: response(a to beside)\n"),
      "acts beside the axis");
  expect_words(
      rotor("  round: {force: 1 N, along: z, turns: z, body: rotor, frequency: w}\n", "  r: response(a to round)\n"),
      "does not point across the axis");
}

}  // namespace response_test
}  // namespace
}  // namespace poinsot::problem
