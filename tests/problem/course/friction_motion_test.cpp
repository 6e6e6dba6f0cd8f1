// Motions in which contacts with dry friction slide, stick and begin to roll, against closed forms.
#include <fmt/format.h>

#include <algorithm>
#include <random>

#include "problem/course/motion_support.h"

namespace poinsot::problem {
namespace friction_motion_test {

constexpr double g = 9.80665;

std::string particle(const std::string& data, const std::string& friction) {
  return "given: {m: 2 kg, b: 0 rad, " + data +
         "}\npoints: {C: [0, 0, 0]}\ndirections: {up: [cos(b), sin(b), 0], out: [-sin(b), cos(b), 0]}\n"
         "bodies: {block: {particle: C, mass: m}}\n"
         "contacts: {slope: {of: block, at: C, normal: out, friction: " +
         friction + "}}\ngravity: -y\n";
}

bool is_noted(const SolvedText& solved, const std::string& beginning) {
  return std::ranges::any_of(solved.notes(), [&](const std::string& note) { return note.starts_with(beginning); });
}

TEST(FrictionMotion, ABlockStopsAndStays) {
  const SolvedText solved(
      particle("v: 3 m/s", "0.3") +
      "instants: {start: {velocity(block): [v, 0, 0]}}\n"
      "ask: {x: position(block).x @ 0.5 s, far: position(block).x @ 5 s, u: velocity(block).x @ 5 s, "
      "F: friction(slope on block).x @ 0.5 s, late: friction(slope on block).x @ 5 s, "
      "stuck: sticking(slope) @ 5 s, stops: {first_time: norm(velocity(block)) < 1e-9 m/s}}\n");
  EXPECT_NEAR(solved.number("x"), 3 * 0.5 - 0.3 * g * 0.125, 1e-9);
  EXPECT_NEAR(solved.number("far"), 9 / (0.6 * g), 1e-9);
  EXPECT_NEAR(solved.number("u"), 0, 1e-10);
  EXPECT_NEAR(solved.number("F"), -0.6 * g, 1e-8);
  EXPECT_NEAR(solved.number("late"), 0, 1e-8);
  EXPECT_TRUE(solved.found("stuck").value.truth);
  EXPECT_NEAR(solved.number("stops"), 1 / (0.1 * g), 1e-8);
  EXPECT_TRUE(is_noted(solved, "contact 'slope' sticks from 1.01")) << solved.notes().front();
}

// Up a slope with the speed v: where friction holds it at rest it stays, elsewhere it comes back.
TEST(FrictionMotion, ABlockUpASlopeStaysOrComesBack) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> slope(0.1, 1), coefficient(0.05, 1), speed(1, 6);
  int back = 0;
  for (int trial = 0; trial < 8; ++trial) {
    const double b = slope(random), k = coefficient(random), s = 1.2 * k, v = speed(random);
    const SolvedText solved(
        particle(fmt::format("c: {} rad, v: {} m/s", b, v), fmt::format("{{static: {}, kinetic: {}}}", s, k)) +
            "instants: {start: {velocity(block): v*up}}\n"
            "ask: {s: component(position(block) along up) @ 2 s}\n",
        {{"b", fmt::format("{} rad", b)}});
    const double braked = g * (std::sin(b) + k * std::cos(b)), stops = v / braked, after = std::max(0.0, 2 - stops);
    const bool slides = std::tan(b) > s;
    back += slides && after > 0;
    const double expected =
        after > 0 ? v * v / (2 * braked) - (slides ? g * (std::sin(b) - k * std::cos(b)) * after * after / 2 : 0)
                  : 2 * v - braked * 2;
    EXPECT_NEAR(solved.number("s"), expected, 1e-8 * (1 + std::abs(expected))) << b << " " << k << " " << v;
  }
  EXPECT_GT(back, 1);
  EXPECT_LT(back, 8);
}

// With the moment of inertia c m r^2: it rolls after the slip u/((1 + 1/c) mu g), and has lost 1/(1 + 1/c) of the slip.
TEST(FrictionMotion, RoundBodiesBeginToRoll) {
  std::mt19937 random(6);
  std::uniform_real_distribution<double> speed(-4, 4), rate(-30, 30), coefficient(0.1, 0.5);
  constexpr double r = 0.2;
  for (const auto& [shape, c] :
       {std::pair{"sphere: {center: G, radius: r}", 0.4}, std::pair{"ring: {center: G, normal: z, radius: r}", 1.0},
        std::pair{"disk: {center: G, normal: z, radius: r}", 0.5}})
    for (int trial = 0; trial < 3; ++trial) {
      const double v = speed(random), w = rate(random), mu = coefficient(random), u = v + w * r;
      const double rolls = std::abs(u) / ((1 + 1 / c) * mu * g), after = v - u / (1 + 1 / c), t = 1.5 * rolls;
      const SolvedText solved(
          fmt::format("given: {{r: {} m, v: {} m/s, w: {} rad/s, t: {} s}}\npoints: {{C: [0, 0, 0], G: [0, r, 0]}}\n"
                      "bodies: {{ball: {{{}, mass: 3 kg}}}}\njoints: {{plane: {{planar: z, at: G, to: ball}}}}\n"
                      "contacts: {{lane: {{of: ball, at: C, normal: y, friction: {}}}}}\ngravity: -y\n"
                      "instants: {{start: {{velocity(ball): [v, 0, 0], angular_velocity(ball): [0, 0, w]}}}}\n"
                      "ask: {{t: {{first_time: norm(slip_velocity(lane)) < 1e-9 m/s}}, u: velocity(ball).x @ t, "
                      "w: angular_velocity(ball).z @ t, x: position(ball).x @ t, E: kinetic_energy(ball) @ t, "
                      "rolls: sticking(lane) @ t}}\n",
                      r, v, w, t, shape, mu));
      EXPECT_NEAR(solved.number("t"), rolls, 1e-7 * rolls) << shape;
      EXPECT_NEAR(solved.number("u"), after, 1e-8) << shape;
      EXPECT_NEAR(solved.number("w"), -after / r, 1e-7) << shape;
      EXPECT_NEAR(solved.number("x"), (v + after) / 2 * rolls + after * (t - rolls), 1e-8) << shape;
      EXPECT_NEAR(solved.number("E"), 1.5 * (1 + c) * after * after, 1e-7) << shape;
      EXPECT_TRUE(solved.found("rolls").value.truth);
    }
}

// The path is a parabola while the ball slips, as its slip keeps its direction.
TEST(FrictionMotion, ABowlingBallCurvesUntilItRolls) {
  const double v = 6, w = 40, r = 0.11, mu = 0.1, u = std::hypot(v, w * r);
  const SolvedText solved(
      "given: {r: 0.11 m}\npoints: {C: [0, 0, 0], G: [0, r, 0]}\n"
      "bodies: {ball: {sphere: {center: G, radius: r}, mass: 6 kg}}\n"
      "contacts: {lane: {of: ball, at: C, normal: y, friction: 0.1}}\ngravity: -y\n"
      "instants: {start: {velocity(ball): [6 m/s, 0, 0], angular_velocity(ball): [40 rad/s, 3 rad/s, 0]}}\n"
      "ask: {p: position(ball) @ 1 s, u: velocity(ball) @ 4 s, w: angular_velocity(ball) @ 4 s, "
      "t: {first_time: norm(slip_velocity(lane)) < 1e-9 m/s}}\n");
  const Vector3<double> p = solved.vector("p"), after = solved.vector("u");
  EXPECT_NEAR(p.x, v - mu * g * v / u / 2, 1e-9);
  EXPECT_NEAR(p.z, mu * g * w * r / u / 2, 1e-9);
  EXPECT_NEAR(norm(after - Vector3<double>{5 * v / 7, 0, 2 * w * r / 7}), 0, 1e-8);
  EXPECT_NEAR(solved.vector("w").y, 3, 1e-9);
  EXPECT_NEAR(solved.number("t"), 2 * u / (7 * mu * g), 1e-8);
}

TEST(FrictionMotion, APushThatGrowsOvercomesTheFriction) {
  const double m = 2, K = 10;
  for (const auto& [s, k] : {std::pair{0.5, 0.5}, std::pair{0.5, 0.3}}) {
    const SolvedText solved(particle("K: 10 N/s", fmt::format("{{static: {}, kinetic: {}}}", s, k)) +
                            "loads: {push: {force: [K*time, 0, 0], at: C, body: block}}\n"
                            "instants: {start: {velocity(block): [0, 0, 0]}}\n"
                            "ask: {F: friction(slope on block).x @ 0.5 s, u: velocity(block).x @ 3 s}\n");
    const double begins = s * m * g / K;
    EXPECT_NEAR(solved.number("F"), -K * 0.5, 1e-8);
    EXPECT_NEAR(solved.number("u"), K * (9 - begins * begins) / (2 * m) - k * g * (3 - begins), 1e-7);
  }
}

TEST(FrictionMotion, ABlockOnASpringStopsWhereFrictionHoldsIt) {
  // Half swings lose 2 k m g/stiffness each: from 0.2 m over -0.141 m and 0.082 m to -0.0235 m, within 0.034 m.
  const double lost = 2 * 0.3 * g / 100;
  const SolvedText solved(
      "points: {O: [0, 0, 0], C: [1 m, 0, 0]}\nbodies: {block: {particle: C, mass: 1 kg}}\n"
      "contacts: {floor: {of: block, at: C, normal: y, friction: {static: 0.35, kinetic: 0.3}}}\n"
      "springs: {s: {from: ground, at: O, to: block, end: C, stiffness: 100 N/m, free_length: 0.8 m}}\ngravity: -y\n"
      "instants: {start: {velocity(block): [0, 0, 0]}}\nask: {x: position(block).x @ 5 s}\n");
  EXPECT_NEAR(solved.number("x"), 0.8 - (0.2 - 3 * lost), 1e-8);
}

TEST(FrictionMotion, TwoBlocksComeToMoveTogetherAndStop) {
  const double m = 2, M = 5, V = 4, u = 0.4, w = 0.1, A = (u * m - w * (m + M)) * g / M, t = V / (u * g + A);
  const SolvedText solved(
      "points: {C: [0, 0.5 m, 0], D: [0, 0, 0], T: [0, 0.25 m, 0]}\nbodies:\n  top: {particle: C, mass: 2 kg}\n"
      "  low: {box: {center: T, sides: [[6 m, 0, 0], [0, 0.5 m, 0], [0, 0, 0.5 m]]}, mass: 5 kg}\n"
      "joints: {rail: {planar: z, at: T, to: low, freedoms: {turn: {rate: 0, accel: 0}}}}\n"
      "contacts:\n  mid: {of: top, against: low, at: C, normal: y, friction: 0.4}\n"
      "  floor: {of: low, at: D, normal: y, friction: 0.1}\ngravity: -y\n"
      "instants: {start: {velocity(low): [0, 0, 0], velocity(top): [4 m/s, 0, 0]}}\n"
      "ask: {t: {first_time: norm(slip_velocity(mid)) < 1e-9 m/s}, x: position(low).x @ 6 s, y: position(top).x @ 6 "
      "s}\n");
  EXPECT_NEAR(solved.number("t"), t, 1e-7);
  const double together = A * t * A * t / (2 * w * g);
  EXPECT_NEAR(solved.number("x"), A * t * t / 2 + together, 1e-8);
  EXPECT_NEAR(solved.number("y"), V * t - u * g * t * t / 2 + together, 1e-8);
}

// Up the slope it slides, rests for no time and slides back: with less friction than holds it, it never sticks.
TEST(FrictionMotion, TimesOfStatesAreTold) {
  const SolvedText solved(particle("v: 3 m/s", "0.2") +
                          "instants: {start: {velocity(block): [v, 0, 0]}}\n"
                          "ask: {stops: {first_time: sticking(slope)}, slides: {first_time: sliding(slope)}, "
                          "all: {times: sticking(slope), to: 3 s}}\n");
  EXPECT_NEAR(solved.number("stops"), 3 / (0.2 * g), 1e-9);
  EXPECT_NEAR(solved.number("slides"), 0, 1e-12);
  EXPECT_EQ(solved.found("all").value.items.size(), 1u);
  EXPECT_NE(failure_of_text(particle("v: 3 m/s", "0.2") + "instants: {start: {velocity(block): [v, 0, 0]}}\n"
                                                          "ask: {t: {first_time: sticking(roof)}}\n")
                .find("there is no contact 'roof' with friction"),
            std::string::npos);
}

TEST(FrictionMotion, WhatIsLiftedIsLost) {
  const SolvedText lifted(particle("v: 3 m/s", "0.1") +
                          "loads: {lift: {force: [0, '(10 N/s)*time', 0], at: C, body: block}}\n"
                          "instants: {start: {velocity(block): [v, 0, 0]}}\n"
                          "ask: {t: {first_time: parting(slope)}, v: velocity(block).x @ 3 s, "
                          "y: position(block).y @ 3 s}\n");
  // m g = k t, then y'' = k (t - t0)/m; until then the friction took mu g t0/2 of the speed.
  const double left = 2 * g / 10, flight = 3 - left;
  EXPECT_NEAR(lifted.number("t"), left, 1e-9);
  EXPECT_NEAR(lifted.number("v"), 3 - 0.1 * g * left / 2, 1e-9);
  EXPECT_NEAR(lifted.number("y"), 10 * std::pow(flight, 3) / 12, 1e-9);
}

// With the largest friction a blow and what follows are rolling, with none they are smooth.
TEST(FrictionMotion, WithoutFrictionItIsSmoothAndWithALotOfItRolls) {
  const auto bounced = [](const std::string& friction) {
    return SolvedText(
        "title: t\npoints: {C: [0, 0.3 m, 0], G: [0, 0.4 m, 0], O: [0, 0, 0]}\n"
        "bodies: {ball: {sphere: {center: G, radius: 0.1 m}, mass: 2 kg}}\ngravity: -y\n"
        "contacts: {floor: {of: ball, at: C, normal: y, open: true, surface: O" +
        friction +
        "}}\ninstants: {start: {velocity(ball): [1 m/s, 0, 0], angular_velocity(ball): [0, 0, 0]}}\n"
        "ask: {x: position(ball).x @ 2 s, w: angular_velocity(ball).z @ 2 s}\n");
  };
  const SolvedText smooth = bounced(""), none = bounced(", friction: 0"), rolls = bounced(", friction: 1e6");
  EXPECT_NEAR(none.number("x"), smooth.number("x"), 1e-9);
  EXPECT_NEAR(none.number("w"), 0, 1e-12);
  const double fall = std::sqrt(0.6 / g);
  EXPECT_NEAR(rolls.number("x"), fall + 5.0 / 7 * (2 - fall), 1e-9);
  EXPECT_NEAR(rolls.number("w"), -50.0 / 7, 1e-9);
}

}  // namespace friction_motion_test
}  // namespace poinsot::problem
