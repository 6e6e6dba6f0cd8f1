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

// A chain of two carts, of which each holds the next: at the frequency zero and slowly, where the inertia is nothing
// beside forces that balance, it is held as at rest.
TEST(Response, OfASlowShakingIsThatAtRest) {
  Random random(21);
  for (int trial = 0; trial < 10; ++trial) {
    const double k = random.uniform(50, 900), h = random.uniform(50, 900), F = random.uniform(1, 9);
    const bool second = trial % 2 == 0;
    const SolvedText solved(fmt::format(
        "points: {{A: [0, 0, 0], B: [1 m, 0, 0]}}\n"
        "bodies: {{one: {{particle: A, mass: 3 kg}}, two: {{particle: B, mass: {:.17g} kg}}}}\n"
        "joints:\n"
        "  ja: {{prismatic: x, at: A, to: one, displacement: s, spring: {{stiffness: {:.17g} N/m}}, damping: 4 "
        "N*s/m}}\n"
        "  jb: {{prismatic: x, at: B, from: one, to: two, displacement: u, spring: {{stiffness: {:.17g} N/m}}}}\n"
        "excitations: {{push: {{force: {:.17g} N, along: x, body: {}}}}}\n"
        "gravity: none\ninstants: {{now: rest}}\n"
        "ask:\n  s: response(s to push at 0 rad/s)\n  u: response(center(two).x to push at 0 rad/s)\n"
        "  t: response(s to push at 1e-5 rad/s)\n  f: response(force(ja on one).x to push at 1e-5 rad/s)\n",
        random.uniform(0.5, 9), k, h, F, second ? "two" : "one"));
    expect_near(swing_of(solved, "s"), F / k, 1e-11, "first");
    expect_near(swing_of(solved, "u"), F / k + (second ? F / h : 0), 1e-11, "second");
    expect_near(swing_of(solved, "t"), F / k, 1e-6, "slowly");
    expect_near(swing_of(solved, "f"), -F, 1e-6, "force");
  }
}

// Beside a wheel that turns as it likes a cart is held by its spring; where the wheel stands nothing says.
TEST(Response, AtRestLeavesOutWhatNothingHolds) {
  const SolvedText solved(R"(
points: {O: [0, 0, 0], A: [1 m, 0, 0], D: [1.2 m, 0, 0]}
bodies: {cart: {particle: O, mass: 2 kg}, wheel: {disk: {center: A, normal: z, radius: 0.2 m}, mass: 1 kg}}
joints:
  rail: {prismatic: x, at: O, to: cart, displacement: s, spring: {stiffness: 100 N/m}}
  axle: {revolute: z, at: A, from: cart, to: wheel, angle: q}
excitations: {push: {force: 3 N, along: x, body: cart}, turn: {couple: 1 N*m, about: z, body: wheel}}
gravity: none
instants: {now: rest}
ask:
  s: response(s to push at 0 rad/s)
  hub: response(center(wheel) to push at 0 rad/s)
  q: response(q to push at 0 rad/s)
  rim: response(position(D of wheel) to push at 0 rad/s)
  t: response(s to turn at 0 rad/s)
)");
  expect_near(swing_of(solved, "s"), 0.03, 1e-11, "cart");
  expect_near(swing_of(solved, "hub", 0), 0.03, 1e-11, "hub");
  EXPECT_EQ(swing_of(solved, "hub", 1), 0.0);
  EXPECT_NE(solved.reason("q").find("depends on what nothing holds"), std::string::npos) << solved.reason("q");
  EXPECT_NE(solved.reason("rim").find("depends on what nothing holds"), std::string::npos) << solved.reason("rim");
  EXPECT_NE(solved.reason("t").find("nothing holds what 'turn' moves"), std::string::npos) << solved.reason("t");
}

// Two shafts coupled by teeth turn together as they like, and swing beside that.
TEST(Response, OfATrainOfGearsThatIsFreeToTurn) {
  const SolvedText solved(R"(
given: {k: 8 kN*m/rad, h: 20 kN*m/rad, r: 50 mm, R: 150 mm}
points: {A: [0, 0, -1 m], B: [0, 0, 0], C: [r + R, 0, 0], D: [r + R, 0, 1 m], P: [r, 0, 0]}
bodies:
  a: {mass: 1 kg, center: A, inertia: {axis: z, axial: 0.1 kg*m^2, transverse: 0.1 kg*m^2}}
  b: {mass: 1 kg, center: B, inertia: {axis: z, axial: 0.01 kg*m^2, transverse: 0.01 kg*m^2}}
  c: {mass: 1 kg, center: C, inertia: {axis: z, axial: 0.2 kg*m^2, transverse: 0.2 kg*m^2}}
  d: {mass: 1 kg, center: D, inertia: {axis: z, axial: 0.9 kg*m^2, transverse: 0.9 kg*m^2}}
joints:
  ja: {revolute: z, at: A, to: a, angle: p}
  jb: {revolute: z, at: B, to: b, angle: q}
  jc: {revolute: z, at: C, to: c}
  jd: {revolute: z, at: D, to: d, angle: s}
gears: {mesh: {of: b, against: c, at: P}}
springs:
  ab: {from: a, to: b, about: z, stiffness: k}
  cd: {from: c, to: d, about: z, stiffness: h}
gravity: none
instants: {now: rest}
excitations: {push: {couple: 5 N*m, about: z, body: a, frequency: 150 rad/s}}
ask: {s: response(s to push), p: response(p - q to push), f: response(tangential_force(mesh on b).y to push), stays: stable(system)}
)");
  // With q for both gears, q_c = -q r/R: M x'' + K x = (5, 0, 0).
  Eigen::Matrix3d M, K;
  const double i = -1.0 / 3, k = 8e3, h = 2e4, w = 150;
  M << 0.1, 0, 0, 0, 0.01 + 0.2 * i * i, 0, 0, 0, 0.9;
  K << k, -k, 0, -k, k + h * i * i, -h * i, 0, -h * i, h;
  const Eigen::Vector3d x = (K - w * w * M).partialPivLu().solve(Eigen::Vector3d(5, 0, 0));
  expect_near(swing_of(solved, "s"), x[2], 1e-9, "end");
  expect_near(swing_of(solved, "p"), x[0] - x[1], 1e-9, "twist");
  expect_near(swing_of(solved, "f"), (-0.01 * w * w * x[1] - k * (x[0] - x[1])) / 0.05, 1e-9, "teeth");
  EXPECT_TRUE(solved.found("stays").value.truth);
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

// A block that is bolted to a floor that shakes: nothing else can move.
TEST(Response, IsThatOfWhatIsCarriedAsStated) {
  const SolvedText solved(
      "title: t\ngiven: {m: 5 kg, Y: 3 mm, w: 25 rad/s}\npoints: {O: [0, 0, 0], A: [0, 0.3 m, 0]}\n"
      "bodies: {floor: massless, block: {particle: A, mass: m}}\njoints:\n"
      "  footing: {prismatic: y, at: O, to: floor, displacement: s, rate: 0, accel: 0}\n"
      "  bolt: {weld: A, from: floor, to: block}\nexcitations: {shake: {moves: s, by: Y, frequency: w}}\n"
      "gravity: none\ninstants: {now: rest}\n"
      "ask: {F: response(force(bolt on block).y to shake), p: response(position(A of block).y to shake)}\n");
  expect_near(swing_of(solved, "F"), Complex(-5 * 0.003 * 625), 1e-9, "force");
  expect_near(swing_of(solved, "p"), Complex(0.003), 1e-9, "place");
}

}  // namespace response_test
}  // namespace
}  // namespace poinsot::problem
