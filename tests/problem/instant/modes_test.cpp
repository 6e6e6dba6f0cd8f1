// All of the linearised motion as it is told - rates, damping ratios, shapes - against the matrices of masses on
// springs, and closed forms of rotors and pendulums.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <complex>
#include <numbers>

#include "problem/course/motion_support.h"
#include "problem/instant/near_steady.h"

namespace poinsot::problem {
namespace {
namespace modes_test {

using namespace testing;
using Complex = std::complex<double>;

struct TestedMode {
  double growth, frequency, damping_ratio;
  std::vector<Complex> shape;

  Complex rate() const { return {growth, frequency}; }
};

std::vector<TestedMode> modes_of(const SolvedText& solved, const std::string& name) {
  const std::vector<SolvedColumn>& columns = solved.found(name).columns;
  std::vector<TestedMode> modes;
  for (std::size_t row = 0; row < columns.front().values.size(); ++row) {
    TestedMode mode{columns[0].values[row], columns[1].values[row], columns[2].values[row], {}};
    for (std::size_t c = 3; c + 1 < columns.size(); c += 2)
      mode.shape.push_back(std::polar(columns[c].values[row], columns[c + 1].values[row]));
    modes.push_back(mode);
  }
  return modes;
}

// Masses that slide along x, each held to the ground and to the next by a spring with a damper.
struct SlidingChain {
  Eigen::MatrixXd M, C, K;
  std::string text;

  SlidingChain(Random& random, int count, double strongest_damping) {
    M = C = K = Eigen::MatrixXd::Zero(count, count);
    std::string bodies, joints, springs, points = "O: [0, 0, 0], ";
    const auto spring = [&](int i, int k) {
      const double stiffness = random.uniform(50, 2000), damping = random.uniform(0, strongest_damping);
      for (const auto& [matrix, size] : {std::pair(&K, stiffness), std::pair(&C, damping)}) {
        (*matrix)(k, k) += size;
        if (i < 0) continue;
        (*matrix)(i, i) += size;
        (*matrix)(i, k) -= size;
        (*matrix)(k, i) -= size;
      }
      springs += fmt::format(
          "  s{}_{}: {{from: {}, at: {}, to: b{}, end: P{}, stiffness: {:.17g} N/m, free_length: {}*L, damping: "
          "{:.17g} N*s/m}}\n",
          i + 1, k, i < 0 ? "ground" : fmt::format("b{}", i), i < 0 ? "O" : fmt::format("P{}", i), k, k, stiffness,
          i < 0 ? k + 1 : 1, damping);
    };
    for (int k = 0; k < count; ++k) {
      const double mass = random.uniform(0.5, 5);
      M(k, k) = mass;
      points += fmt::format("P{}: [{}*L, 0, 0], ", k, k + 1);
      bodies += fmt::format("  b{}: {{particle: P{}, mass: {:.17g} kg}}\n", k, k, mass);
      joints += fmt::format("  j{}: {{prismatic: x, at: P{}, to: b{}, displacement: q{}}}\n", k, k, k, k);
      if (k == 0 || random.chance(0.5)) spring(-1, k);
      if (k > 0) spring(k - 1, k);
    }
    points.resize(points.size() - 2);
    // Lengths that decimals do not hold leave a rounding of their balance in the springs.
    const double length = std::array{1.0, 0.3, 0.7}.at(static_cast<std::size_t>(count % 3));
    text = fmt::format("title: t\ngravity: none\ngiven: {{L: {} m}}\n", length) + "points: {" + points +
           "}\nbodies:\n" + bodies + "joints:\n" + joints + "springs:\n" + springs + "instants: {now: rest}\n";
  }
};

TEST(Modes, OfSlidingChainsSolveTheirEquations) {
  Random random(8);
  int swings = 0, dies = 0;
  for (int trial = 0; trial < 40; ++trial) {
    const int count = 1 + trial % 4;
    const SlidingChain chain(random, count, trial % 3 == 0 ? 0 : trial % 3 == 1 ? 10 : 300);
    const SolvedText solved(chain.text + "ask: {m: modes(system), e: eigenvalues(system)}\n");
    const std::vector<TestedMode> modes = modes_of(solved, "m");
    const std::vector<Value<double>>& rows = solved.found("e").value.items;
    ASSERT_EQ(rows.size(), modes.size()) << chain.text;
    Complex sum = 0;
    double logarithm = 0;
    int all = 0;
    for (std::size_t i = 0; i < modes.size(); ++i) {
      const TestedMode& mode = modes[i];
      const Complex rate = mode.rate();
      EXPECT_EQ(rows[i].items[0].number, mode.growth);
      EXPECT_EQ(rows[i].items[1].number, mode.frequency);
      EXPECT_NEAR(mode.damping_ratio, -rate.real() / std::abs(rate), 1e-12);
      if (i > 0) {
        EXPECT_GE(mode.frequency, modes[i - 1].frequency - 1e-6);
      }
      const int times = mode.frequency > 0 ? 2 : 1;
      (times == 2 ? swings : dies) += 1;
      all += times;
      sum += times * rate.real();
      logarithm += times * std::log(std::abs(rate));
      ASSERT_EQ(mode.shape.size(), static_cast<std::size_t>(count)) << chain.text;
      const Eigen::VectorXcd s = Eigen::Map<const Eigen::VectorXcd>(mode.shape.data(), count);
      EXPECT_NEAR(s.cwiseAbs().maxCoeff(), 1, 1e-6);
      const Eigen::VectorXcd left = rate * rate * (chain.M * s) + rate * (chain.C * s) + chain.K * s;
      EXPECT_LE(left.norm(), 1e-8 * (std::norm(rate) * chain.M.norm() + chain.K.norm())) << chain.text;
    }
    EXPECT_EQ(all, 2 * count) << chain.text;
    const double trace = -(chain.M.inverse() * chain.C).trace();
    EXPECT_NEAR(sum.real(), trace, 1e-8 * (1 + std::abs(trace))) << chain.text;
    EXPECT_NEAR(logarithm, std::log(chain.K.determinant() / chain.M.determinant()), 1e-7) << chain.text;
    if (HasFailure()) return;
  }
  EXPECT_GT(swings, 50);
  EXPECT_GT(dies, 5);
}

// m x'' + c x' + k x = 0 from undamped to far beyond critical damping.
TEST(Modes, OfADamper) {
  const double m = 2, k = 50, critical = 2 * std::sqrt(m * k);
  for (const double ratio : {0.0, 0.01, 0.5, 1.5, 20.0}) {
    const SolvedText solved(fmt::format(
        "title: t\ngravity: none\npoints: {{O: [0, 0, 0]}}\nbodies: {{b: {{particle: O, mass: {} kg}}}}\njoints: {{j: "
        "{{prismatic: x, at: O, to: b, displacement: q, spring: {{stiffness: {} N/m}}, damping: {:.17g} "
        "N*s/m}}}}\ninstants: {{now: rest}}\nask: {{e: eigenvalues(b), z: 'modes(b)[1].damping_ratio', last: "
        "'eigenvalues(b)[2][1]', beyond: 'eigenvalues(b)[3]'}}\n",
        m, k, ratio * critical));
    const std::vector<Value<double>>& rows = solved.found("e").value.items;
    const double w = std::sqrt(k / m);
    if (ratio < 1) {
      ASSERT_EQ(rows.size(), 1U);
      EXPECT_NEAR(rows[0].items[0].number, -ratio * w, 1e-12 * w);
      EXPECT_NEAR(rows[0].items[1].number, std::sqrt(1 - ratio * ratio) * w, 1e-12 * w);
      EXPECT_NEAR(solved.number("z"), ratio, 1e-12);
      EXPECT_EQ(solved.reason("last"), "there is no element 2: the last is 1");
    } else {
      ASSERT_EQ(rows.size(), 2U) << ratio;
      const double root = std::sqrt(ratio * ratio - 1);
      const double to = 1e-11;
      EXPECT_NEAR(rows[0].items[0].number, -(ratio + root) * w, to * ratio * w);
      EXPECT_NEAR(rows[1].items[0].number, -w / (ratio + root), to * w);
      EXPECT_EQ(rows[0].items[1].number, 0);
      EXPECT_EQ(rows[1].items[1].number, 0);
      EXPECT_NEAR(solved.number("z"), 1, 1e-12);
      EXPECT_EQ(solved.number("last"), rows[1].items[0].number);
    }
    EXPECT_EQ(solved.reason("beyond"), fmt::format("there is no element 3: the last is {}", rows.size()));
  }
}

// A rotor in gimbals on springs: A a'' + H b' + K a = 0, A b'' - H a' + L b = 0 for its small angles. The shapes are
// ellipses, run through in opposite senses at the two frequencies.
TEST(Modes, OfARotorInGimbals) {
  Random random(31);
  for (int trial = 0; trial < 25; ++trial) {
    const double I = random.uniform(0.01, 0.05), A = I * random.uniform(0.6, 3), S = random.uniform(20, 400);
    const double K = random.uniform(1, 100), L = trial % 5 == 0 ? K : random.uniform(1, 100), H = I * S;
    const SolvedText solved(fmt::format(
        "title: t\ngravity: none\npoints: {{O: [0, 0, 0]}}\nbodies: {{ring: massless, inner: massless, rotor: {{mass: "
        "2 "
        "kg, center: O, inertia: {{axis: z, axial: {:.17g} kg*m^2, transverse: {:.17g} kg*m^2}}}}}}\njoints:\n  outer: "
        "{{revolute: x, at: O, to: ring, angle: a, spring: {{stiffness: {:.17g} N*m/rad}}}}\n  middle: {{revolute: y, "
        "at: O, from: ring, to: inner, angle: b, spring: {{stiffness: {:.17g} N*m/rad}}}}\n  axle: {{revolute: z, at: "
        "O, from: inner, to: rotor, rate: {:.17g} rad/s, accel: 0}}\nsteady: {{frame: ground, spins: {{rotor: {{about: "
        "z, rate: {:.17g} rad/s}}}}}}\nask: {{m: modes(system), low: min(frequencies(rotor)), high: "
        "max(frequencies(system))}}\n",
        I, A, K, L, S, S));
    const std::vector<TestedMode> modes = modes_of(solved, "m");
    ASSERT_EQ(modes.size(), 2U);
    const double half = (A * (K + L) + H * H) / 2, root = std::sqrt(half * half - A * A * K * L);
    const std::array<double, 2> expected{std::sqrt(K * L / (half + root)), std::sqrt((half + root) / (A * A))};
    for (std::size_t i = 0; i < 2; ++i) {
      const double w = modes[i].frequency;
      EXPECT_NEAR(w, expected[i], 1e-9 * expected[i]);
      EXPECT_EQ(modes[i].damping_ratio, 0);
      // (K - A w^2) a = -i w H b
      const Complex a = modes[i].shape.at(0), b = modes[i].shape.at(1);
      EXPECT_LE(std::abs((K - A * w * w) * a + Complex(0, w * H) * b), 1e-7 * (K + A * w * w + w * H));
      EXPECT_LE(std::abs((L - A * w * w) * b - Complex(0, w * H) * a), 1e-7 * (L + A * w * w + w * H));
    }
    EXPECT_NEAR(solved.number("low"), expected[0], 1e-9 * expected[0]);
    EXPECT_NEAR(solved.number("high"), expected[1], 1e-9 * expected[1]);
    EXPECT_LT((modes[0].shape[0] * std::conj(modes[0].shape[1])).imag() *
                  (modes[1].shape[0] * std::conj(modes[1].shape[1])).imag(),
              0);
    if (HasFailure()) return;
  }
}

// What turns about the vertical as it swings is displaced along its own symmetry, too: the cart under a pendulum.
TEST(Modes, OfACartWithAPendulum) {
  const double M = 3, m = 2, l = 0.7;
  const SolvedText solved(fmt::format(
      "title: t\ngiven: {{g: 9.81 m/s^2}}\ngravity: -y\npoints: {{O: [0, 0, 0], P: [0, -{} m, 0]}}\nbodies: {{cart: "
      "{{particle: O, mass: {} kg}}, bob: {{particle: P, mass: {} kg}}}}\njoints: {{rail: {{prismatic: x, at: O, to: "
      "cart, displacement: s}}, pin: {{revolute: z, at: O, from: cart, to: bob, angle: t}}}}\ninstants: {{now: "
      "rest}}\nask: {{m: modes(system), one: 'modes(bob)[1]', s: 'modes(cart)[1].s', p: 'modes(cart)[1].s_phase'}}\n",
      l, M, m));
  const std::vector<TestedMode> modes = modes_of(solved, "m");
  ASSERT_EQ(modes.size(), 1U);
  EXPECT_NEAR(modes[0].frequency, std::sqrt(9.81 / l * (M + m) / M), 1e-10);
  // The mass center stays: (M + m) s + m l t = 0.
  EXPECT_NEAR(std::abs(modes[0].shape[0] / modes[0].shape[1] + m * l / (M + m)), 0, 1e-9);
  EXPECT_NEAR(solved.number("s") * std::cos(solved.number("p")) / std::real(modes[0].shape[1]), -m * l / (M + m), 1e-9);
  EXPECT_EQ(modes_of(solved, "one").size(), 1U);
}

TEST(Modes, SayWhatTheyDoNotTell) {
  const std::string bob =
      "title: t\ngravity: -y\npoints: {O: [0, 0, 0], P: [0, -1 m, 0]}\nbodies: {bob: {particle: P, mass: 1 kg}}\n";
  const std::string pin = bob + "joints: {pin: {revolute: z, at: O, to: bob, angle: t}}\ninstants: {now: rest}\n";
  EXPECT_EQ(failure_of_text(pin + "ask: {x: 'frequencies(bob)[0]'}\n"),
            "test.yaml:7:28: error: there is no element 0 (the first is [1])");
  EXPECT_EQ(
      failure_of_text(pin + "ask: {x: 'frequencies(bob)[1.5]'}\n"),
      "test.yaml:7:28: error: the place of an element is a whole number without unit (write frequencies(disk)[1])");
  EXPECT_EQ(failure_of_text(pin + "ask: {x: 'velocity(bob)[1]'}\n"),
            "test.yaml:7:11: error: a vector has no elements (a vector has components, v.x)");
  EXPECT_EQ(failure_of_text(pin + "ask: {x: 'modes(bob)[1].frequence'}\n"),
            "test.yaml:7:24: error: a mode has no 'frequence' (did you mean 'frequency'?)");
  EXPECT_EQ(failure_of_text(pin + "ask: {x: {of: modes(bob), unit: rad/s}}\n"),
            "test.yaml:7:7: error: modes are told in several units: no one unit is for all of them (ask for parts of "
            "them, modes(disk)[1].frequency)");
  EXPECT_EQ(SolvedText(pin + "ask: {x: 'frequencies(bob)[2]', y: 'frequencies(bob)[1]'}\n").reason("x"),
            "there is no element 2: the last is 1");
  const SolvedText falling(bob + "instants: {now: rest}\nask: {x: modes(bob), y: eigenvalues(bob)}\n");
  EXPECT_NE(falling.reason("x").find("no steady motion"), std::string::npos) << falling.reason("x");
  EXPECT_NE(falling.reason("y").find("no steady motion"), std::string::npos) << falling.reason("y");
  // In two directions it swings alike: which lines it swings along is open.
  const SolvedText ball(bob +
                        "joints: {pin: {ball: O, to: bob, angles: [a: z, b: x, c: y]}}\ninstants: {now: rest}\n"
                        "ask: {x: eigenvalues(bob), y: modes(bob)}\n");
  ASSERT_EQ(ball.found("x").value.items.size(), 2U);
  EXPECT_EQ(ball.found("y").columns.size(), 3U);
  EXPECT_TRUE(std::ranges::any_of(ball.notes(), [](const std::string& note) {
    return note == "shapes are not told: modes have the same rates, and any mixture of these is one, too";
  }));
}

// A rotor in a sprung ring tilts with the inertia that it has across the axle. One that is not alike all round has
// another as it turns, and so has one to whose side something is fastened: the equations change with time, and their
// coefficients at an instant say nothing of stability.
TEST(Modes, WhatSpinsUnevenlyHasNone) {
  const auto rotor = [](const std::string& inertia, const std::string& more = "", const std::string& end = "") {
    return "points: {O: [0, 0, 0], A: [0, 0.3 m, 0], B: [0, 0.3 m, 1 m]}\n"
           "bodies: {ring: massless, rotor: {mass: 4 kg, center: O, inertia: {" +
           inertia +
           "}}}\njoints:\n"
           "  tilt: {revolute: x, at: O, to: ring, angle: a, spring: {stiffness: 800 N*m/rad}}\n"
           "  axle: {revolute: z, at: O, from: ring, to: rotor, rate: 30 rad/s, accel: 0}\n" +
           more + "gravity: none\nsteady: {frame: ground, spins: {rotor: {about: z, rate: 30 rad/s}}}\n" + end +
           "ask: {f: max(frequencies(system)), s: stable(system)}\n";
  };
  const std::string even = "axis: z, axial: 0.9 kg*m^2, transverse: 0.5 kg*m^2",
                    uneven = "x: 0.5 kg*m^2, y: 0.02 kg*m^2, z: 0.52 kg*m^2",
                    spring =
                        "springs: {rod: {from: ground, at: B, to: rotor, end: A, stiffness: 90 N/m, tension: 0 N}}\n";
  EXPECT_NEAR(SolvedText(rotor(even)).number("f"), 40, 1e-9);
  for (const SolvedText& solved : {SolvedText(rotor(uneven)), SolvedText(rotor(even, spring))})
    for (const char* ask : {"f", "s"})
      EXPECT_NE(solved.reason(ask).find("change with time"), std::string::npos) << solved.reason(ask);
  // From a turntable springs on the ground and a weight across its axis go round.
  const auto table = [](const char* axis, const char* groove, const char* gravity, const char* holder) {
    return fmt::format(
        "points: {{O: [0, 0, 0], A: [1 m, 0, 0]}}\nbodies: {{table: massless, bob: {{particle: O, mass: 1 kg}}}}\n"
        "joints:\n  axle: {{revolute: {}, at: O, to: table, rate: 3 rad/s, accel: 0}}\n"
        "  groove: {{prismatic: {}, at: O, from: table, to: bob, displacement: s, spring: {{stiffness: 100 N/m}}}}\n"
        "springs: {{k: {{from: {}, at: A, to: bob, end: O, stiffness: 50 N/m, tension: 0 N}}}}\n"
        "gravity: {}\nsteady: {{frame: table}}\nask: {{f: max(frequencies(bob)), s: stable(bob)}}\n",
        axis, groove, holder, gravity);
  };
  EXPECT_NEAR(SolvedText(table("z", "x", "-z", "table")).number("f"), std::sqrt(150.0 - 9), 1e-9);
  for (const SolvedText& solved :
       {SolvedText(table("z", "x", "-z", "ground")), SolvedText(table("x", "y", "-z", "table"))})
    EXPECT_NE(solved.reason("f").find("change with time"), std::string::npos) << solved.reason("f");
  // In a ring that cannot tilt its inertia is felt by nothing.
  std::string held = rotor(uneven);
  held.replace(held.find("angle: a, spring: {stiffness: 800 N*m/rad}"), 42, "angle: a, rate: 0, accel: 0");
  EXPECT_TRUE(SolvedText(held.replace(held.find("f: max(frequencies(system)), "), 29, "")).found("s").value.truth);
}

}  // namespace modes_test
}  // namespace
}  // namespace poinsot::problem
