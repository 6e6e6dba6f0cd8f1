// What is said of the motion near rest and steady motions where masses are left out, surfaces unknown, rates alike or
// equilibria side by side: against closed forms.
#include <gtest/gtest.h>

#include <numbers>

#include "problem/course/motion_support.h"
#include "problem/instant/near_steady.h"

namespace poinsot::problem {
namespace {

using namespace testing;

constexpr double g = 9.81;

void expect_swings(const Near& near, std::vector<double> expected, const std::string& text) {
  std::sort(expected.begin(), expected.end());
  ASSERT_EQ(near.frequencies.size(), expected.size()) << near.list() << text;
  for (std::size_t i = 0; i < expected.size(); ++i)
    EXPECT_NEAR(near.frequencies[i], expected[i], 1e-9 * expected[i]) << near.list() << text;
}

// A unit vector drawn at random, and gravity along it or against it.
Vector3<double> drawn_direction(Random& random) {
  const Vector3<double> d{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
  return norm(d) > 0.1 ? normalized(d) : Vector3<double>::unit(1);
}
std::string text_of(const Vector3<double>& v, const std::string& unit) {
  return fmt::format("[{:.17g}{}, {:.17g}{}, {:.17g}{}]", v.x, unit, v.y, unit, v.z, unit);
}

// A bob on a massless arm swings or falls as one whose arm is a cord or the bob's own.
TEST(StabilityBesideMassless, BobOnAnArmOnABallJoint) {
  Random random(511);
  int upright = 0;
  for (int trial = 0; trial < 60; ++trial) {
    const Vector3<double> d = trial < 2 ? Vector3<double>::unit(2) : drawn_direction(random);
    const double l = random.uniform(0.1, 2);
    const bool up = random.chance(0.5), own = random.chance(0.3);
    upright += up;
    const std::string bodies = own ? "bodies: {bob: {particle: B, mass: 2 kg}}\njoints: {pivot: {ball: O, to: bob}}\n"
                                   : "bodies: {arm: massless, bob: {particle: B, mass: 2 kg}}\n"
                                     "joints: {pivot: {ball: O, to: arm}, tip: {weld: B, from: arm, to: bob}}\n";
    const std::string text = "title: t\ngravity: " + text_of((up ? -g : g) * d, " m/s^2") +
                             "\npoints: {O: [0, 0, 0], B: " + text_of(l * d, " m") + "}\n" + bodies +
                             "instants: {now: rest}\nask: {s: stable(bob), g: growth_rate(bob), f: frequencies(bob)}\n";
    const Near near = solved_near(text).front();
    const double rate = std::sqrt(g / l);
    EXPECT_EQ(near.stable, !up) << text;
    EXPECT_NEAR(near.growth, up ? rate : 0, 1e-9 * rate) << text;
    expect_swings(near, up ? std::vector<double>{} : std::vector<double>{rate, rate}, text);
    if (HasFailure()) return;
  }
  EXPECT_GT(upright, 10);
  EXPECT_LT(upright, 50);
}

// The same bob in steady rotation about the vertical, on a massless arm that nothing keeps from turning about its own
// line: w^2 (1 + 3 cos^2 b) of the angle b, beside what turning about the vertical leads to.
TEST(StabilityBesideMassless, ConicalPendulumOnAnArm) {
  Random random(512);
  for (int trial = 0; trial < 20; ++trial) {
    const double L = random.uniform(0.2, 2), b = random.uniform(0.1, 1.4), c = std::cos(b), w = std::sqrt(g / (L * c));
    const std::string text =
        "title: t\ngravity: [0, -9.81 m/s^2, 0]\n" +
        fmt::format("points: {{O: [0, 0, 0], B: [{:.17g} m, {:.17g} m, 0]}}\n", L * std::sin(b), -L * c) +
        "bodies: {arm: massless, bob: {particle: B, mass: 2 kg}}\njoints: {pivot: {ball: O, to: arm}, tip: {weld: B, "
        "from: arm, to: bob}}\n" +
        fmt::format("frames: {{figure: {{turns: y, rate: {:.17g} rad/s}}}}\nsteady: {{frame: figure}}\n", w) +
        "ask: {s: stable(bob), g: growth_rate(bob), f: frequencies(bob)}\n";
    const Near near = solved_near(text).front();
    EXPECT_TRUE(near.stable) << text;
    expect_swings(near, {w * std::sqrt(1 + 3 * c * c)}, text);
    if (HasFailure()) return;
  }
}

// A rotor (I about its axis, J across) in a massless housing on a ball joint that four springs hold upright:
// J x'' - i I s x' + 2 k a^2 x = 0 of the inclination x.
TEST(StabilityBesideMassless, RotorInASprungHousing) {
  const double I = 0.02, J = 0.015, k = 1000, a = 0.1;
  for (const double s : {0.0, 30.0, 300.0}) {
    std::string springs;
    for (const auto& [name, at] :
         {std::pair{"e", "0.1 m, 0"}, {"w", "-0.1 m, 0"}, {"n", "0, 0.1 m"}, {"s", "0, -0.1 m"}})
      springs += fmt::format(
          "  {}: {{from: ground, at: '[{}, 0.2 m]', to: housing, end: '[{}, 0]', stiffness: 1000 N/m, free_length: 0.2 "
          "m}}\n",
          name, at, at);
    const std::string text =
        "title: t\ngravity: none\npoints: {O: [0, 0, 0]}\nbodies:\n  housing: massless\n  rotor: {mass: 2 kg, center: "
        "O, inertia: {x: 0.015 kg*m^2, y: 0.015 kg*m^2, z: 0.02 kg*m^2}}\njoints:\n  pivot: {ball: O, to: housing}\n" +
        fmt::format("  axle: {{revolute: z, at: O, from: housing, to: rotor, rate: {:.17g} rad/s}}\n", s) +
        "springs:\n" + springs +
        fmt::format("steady: {{frame: ground, spins: {{rotor: {{about: z, rate: {:.17g} rad/s}}}}}}\n", s) +
        "ask: {s: stable(rotor), g: growth_rate(rotor), f: frequencies(rotor)}\n";
    const double root = std::sqrt(I * s * I * s + 8 * J * k * a * a);
    const Near near = solved_near(text).front();
    EXPECT_TRUE(near.stable) << text;
    expect_swings(near, {(root - I * s) / (2 * J), (root + I * s) / (2 * J)}, text);
  }
}

// What touches with a surface that is not known is refused, whatever is asked of it. Where both surfaces are known a
// ball falls from another one with sqrt(5 g/(7 (R + r))).
TEST(StabilityBesideMassless, AnUnknownSurfaceIsRefusedAndABallOnABallFalls) {
  const auto text = [](const std::string& ball) {
    return "title: t\ngravity: [0, -9.81 m/s^2, 0]\npoints: {O: [0, 0, 0], C: [0, 1 m, 0], G: [0, 1.1 m, 0]}\nbodies: "
           "{ball: {" +
           ball +
           "mass: 2 kg}, globe: {sphere: {center: O, radius: 1 m}, mass: 50 kg}}\n"
           "joints: {base: {weld: O, to: globe}}\ncontacts: {top: {of: ball, against: globe, at: C, normal: y, "
           "no_slip: "
           "true}}\ninstants: {now: rest}\nask: {s: stable(ball), g: growth_rate(ball), f: frequencies(ball)}\n";
  };
  const SolvedText unknown(text("center: G, inertia: {x: 1 kg*m^2, y: 1 kg*m^2, z: 1 kg*m^2}, "));
  for (const char* name : {"s", "f"})
    EXPECT_TRUE(unknown.reason(name).find("how the point of contact 'top' moves is not known") != std::string::npos)
        << unknown.reason(name);
  const std::string known = text("sphere: {center: G, radius: 0.1 m}, ");
  const Near near = solved_near(known).front();
  EXPECT_FALSE(near.stable);
  EXPECT_NEAR(near.growth, std::sqrt(5 * g / (7 * 1.1)), 1e-9);
}

// Two blocks that know nothing of each other swing at the same rates, each on three springs that stand square.
TEST(StabilityOfLikes, EachBlockHasItsOwnFrequencies) {
  std::string springs;
  for (const auto& [name, body, from, end, factor] : {std::tuple{"sax", "one", "[1 m, 0, 0]", "A", 1},
                                                      {"say", "one", "[0, 1 m, 0]", "A", 2},
                                                      {"saz", "one", "[0, 0, 1 m]", "A", 3},
                                                      {"sbx", "two", "[6 m, 2 m, 3 m]", "B", 3},
                                                      {"sby", "two", "[5 m, 3 m, 3 m]", "B", 6},
                                                      {"sbz", "two", "[5 m, 2 m, 4 m]", "B", 9}})
    springs += fmt::format("  {}: {{from: ground, at: '{}', to: {}, end: {}, stiffness: {}*k, free_length: 1 m}}\n",
                           name, from, body, end, factor);
  const std::string text =
      "title: t\ngravity: none\ngiven: {k: 400 N/m}\npoints: {A: [0, 0, 0], B: [5 m, 2 m, 3 m]}\n"
      "bodies: {one: {particle: A, mass: 1 kg}, two: {particle: B, mass: 3 kg}}\nsprings:\n" +
      springs + "instants: {now: rest}\nask: {";
  const double a = 20, b = 20 * std::sqrt(2), c = 20 * std::sqrt(3);
  expect_swings(solved_near(text + "f: frequencies(one)}\n").front(), {a, b, c}, text);
  expect_swings(solved_near(text + "f: frequencies(two)}\n").front(), {a, b, c}, text);
  expect_swings(solved_near(text + "f: frequencies(system)}\n").front(), {a, a, b, b, c, c}, text);
}

// A plank of length L and height h on a drum of radius R in their plane, and on a globe: the rocking swings at
// g (R - h/2)/(L^2/12 + h^2/3) or falls. Shoved along, the plank rests at another inclination.
TEST(StabilityBesideEquilibria, PlankOnADrumAndOnAGlobe) {
  const double L = 2, depth = 0.2;
  for (const double R : {0.5, 0.11, 0.09}) {
    const double h = 0.2, stiffness = g * (R - h / 2);
    const auto text = [&](const std::string& drum, const std::string& joints) {
      return "title: t\ngravity: [0, -9.81 m/s^2, 0]\n" +
             fmt::format("points: {{O: [0, 0, 0], C: [0, {0:.17g} m, 0], G: [0, {1:.17g} m, 0]}}\n", R, R + h / 2) +
             "bodies: {drum: {" + drum + fmt::format(", radius: {:.17g} m}}, mass: 20 kg}}", R) +
             ", plank: {box: {center: G, sides: [[2 m, 0, 0], [0, 0.2 m, 0], [0, 0, 0.2 m]]}, mass: 2 kg}}\n"
             "joints: {base: {weld: O, to: drum}" +
             joints +
             "}\ncontacts: {top: {of: drum, against: plank, at: C, normal: -y, no_slip: true}}\ninstants: {now: rest}\n"
             "ask: {s: stable(plank), g: growth_rate(plank), f: frequencies(plank)}\n";
    };
    const auto rate = [&](double length) {
      return std::sqrt(std::abs(stiffness) / (length * length / 12 + h * h / 3));
    };
    const std::string flat =
                          text("cylinder: {center: O, axis: z, length: 1 m", ", flat: {planar: z, at: G, to: plank}"),
                      round = text("sphere: {center: O", "");
    const Near rocks = solved_near(flat).front(), both = solved_near(round).front();
    EXPECT_EQ(rocks.stable, stiffness > 0) << flat;
    EXPECT_EQ(both.stable, stiffness > 0) << round;
    if (stiffness > 0) {
      expect_swings(rocks, {rate(L)}, flat);
      expect_swings(both, {rate(L), rate(depth)}, round);
    } else {
      EXPECT_NEAR(rocks.growth, rate(L), 1e-9 * rate(L)) << flat;
      EXPECT_NEAR(both.growth, rate(depth), 1e-9 * rate(depth)) << round;
    }
  }
}

// A wheel that rolls straight on, told from a frame that rides along without turning.
TEST(StabilityBesideEquilibria, WheelInAFrameThatRidesAlong) {
  const double r = 0.3;
  for (const double s : {2.0, 9.0}) {
    const std::string text =
        "title: t\ngravity: [0, -9.81 m/s^2, 0]\npoints: {C: [0, 0, 0], G: [0, 0.3 m, 0]}\n"
        "bodies: {disk: {disk: {center: G, normal: z, radius: 0.3 m}, mass: 2 kg}}\n"
        "contacts: {floor: {of: disk, at: C, normal: y, no_slip: true}}\n" +
        fmt::format(
            "frames: {{figure: {{origin: G, velocity: [-{0:.17g} m/s, 0, 0]}}}}\n"
            "steady: {{frame: figure, spins: {{disk: {{about: z, rate: {1:.17g} rad/s}}}}}}\n",
            r * s, s) +
        "ask: {s: stable(disk), g: growth_rate(disk), f: frequencies(disk)}\n";
    const double square = (12 * s * s - 4 * g / r) / 5;
    const Near near = solved_near(text).front();
    EXPECT_EQ(near.stable, square > 0) << text;
    if (square > 0)
      expect_swings(near, {std::sqrt(square)}, text);
    else
      EXPECT_NEAR(near.growth, std::sqrt(-square), 1e-9 * std::sqrt(-square)) << text;
  }
}

// Who asks for frequencies only is told that something grows beside them.
TEST(StabilityNotes, FrequenciesBesideGrowth) {
  const auto notes = [](const std::string& gravity) {
    const SolvedText solved(
        "title: t\ngravity: " + gravity +
        "\npoints: {O: [0, 0, 0], B: [0, 1 m, 0], P: [2 m, 0, 0], Q: [2 m, -1 m, 0]}\n"
        "bodies: {one: {particle: B, mass: 1 kg}, two: {particle: Q, mass: 1 kg}}\n"
        "joints: {p1: {revolute: z, at: O, to: one}, p2: {revolute: z, at: P, to: two}}\ninstants: {now: rest}\n"
        "ask: {f: frequencies(system)}\n");
    EXPECT_EQ(solved.found("f").value.items.size(), gravity == "-y" ? 1U : 0U);
    return solved.notes();
  };
  const std::vector<std::string> told = notes("-y");
  ASSERT_EQ(told.size(), 1U);
  EXPECT_TRUE(told[0].starts_with("rest is unstable: a disturbance grows as exp(3.13")) << told[0];
  EXPECT_TRUE(notes("none").empty());
}

}  // namespace
}  // namespace poinsot::problem
