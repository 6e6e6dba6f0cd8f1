// Cords do not push and contacts do not pull: what rests on it is refused, wherever it is asked. Facts hold.
#include "problem/answers/answer_checks.h"

#include <gtest/gtest.h>

#include <string>

#include "problem/answers/fact_check.h"
#include "problem/answers/solve_statement.h"
#include "problem/unknowns/asked_value.h"

namespace poinsot::problem {
namespace answer_checks_test {

Solution solved(const std::string& text) {
  return solve_statement(read_statement(text, "test.yaml"), {}).solutions.at(0);
}

std::string hanging(const std::string& force, const std::string& ask) {
  return "given: {F: " + force +
         "}\npoints: {A: [0, 0, 0], C: [0, 1 m, 0]}\nbodies: {p: {particle: A, mass: 2 kg}}\n"
         "cords: {c: {at: C, to: p, end: A}}\nloads: {f: {force: [0, F, 0], body: p}}\n"
         "gravity: -y\nfacts: rest\nask: {" +
         ask + "}\n";
}

TEST(Unphysical, a_light_cord_beside_a_ship_does_not_push) {
  const Solution solution = solved(R"(
points: {O: [0, 0, 0], A: [10 m, 0, 0], C: [10 m, 1 m, 0]}
bodies:
  ship: {box: {center: O, sides: [200 m * x, 30 m * y, 30 m * z]}, mass: 5e7 kg}
  p: {particle: A, mass: 20 g}
joints: {s: {weld: O, to: ship}}
cords: {c: {at: C, to: p, end: A}}
loads: {f: {force: [0, 2 N, 0], body: p}}
gravity: -y
instants: {now: rest}
ask: {t: tension(c), a: acceleration(p), p: momentum(p)}
)");
  EXPECT_EQ(solution.asks[0].state, AskState::refused);
  EXPECT_EQ(solution.asks[0].reason, "the cord 'c' would have to push: it goes slack");
  EXPECT_EQ(solution.asks[1].state, AskState::refused);
  EXPECT_EQ(solution.asks[2].state, AskState::found);
}

// A couple leaves nothing but rounding of linear momenta, which is not held against itself.
TEST(Unphysical, a_twist_in_no_time_is_no_fault) {
  const std::string wheel = R"(
points: {O: [0, 0, 0]}
bodies: {wheel: {mass: 5 kg, center: O, inertia: {axis: x, axial: 2 kg*m^2, transverse: 2 kg*m^2}}}
gravity: none
find: {M: N*m*s}
impulses: {twist: {body: wheel, couple: [M, 0, 0]}}
ask: {M: M}
)";
  for (const std::string& motion :
       {std::string("joints: {axle: {revolute: x, at: O, to: wheel, angle: q}}\n"
                    "instants: {before: {q': 0}, after: {q': 3 rad/s}}\n"),
        std::string("instants: {before: rest, after: {angular_velocity(wheel): [3 rad/s, 0, 0]}}\n")}) {
    const Solution solution = solved(wheel + motion);
    EXPECT_EQ(solution.asks[0].state, AskState::found) << solution.asks[0].reason;
    EXPECT_NEAR(solution.asks[0].value.number, 6, 1e-12);
  }
}

// The tilt of a turn indicator follows from couples: forces are checked though none is asked for.
TEST(Checks, unknowns_found_from_forces_are_checked_by_forces) {
  const Solution solution = solved(R"(
given: {m: 0.2 kg, r: 40 mm, k: 500 N/m}
find: {tilt: deg}
where: [-45 deg < tilt < 45 deg]
gravity: none
points: {O: [0, 0, 0], A: [0, 0, -50 mm], B: [0, 0, 50 mm], C: A - 100 m * y, D: B - 100 m * y}
frames: {airplane: {origin: O, turns: y, rate: -0.3 rad/s}}
bodies: {yoke: massless, disk: {disk: {center: O, normal: z, radius: r}, mass: m}}
joints:
  pivot: {revolute: x, at: O, from: airplane, to: yoke, angle: tilt}
  axle: {revolute: z, at: O, from: yoke, to: disk, rate: 10000 rpm, accel: 0}
springs:
  AC: {from: airplane, at: C, to: yoke, end: A, stiffness: k, tension: 5 N}
  BD: {from: airplane, at: D, to: yoke, end: B, stiffness: k, tension: 5 N}
steady: {frame: airplane}
ask: {a: tilt}
)");
  ASSERT_EQ(solution.asks[0].state, AskState::found);
  ASSERT_TRUE(solution.checks.contains("newton_euler"));
  EXPECT_LT(solution.checks.at("newton_euler"), 1e-10);
}

// The bodies as particles confirm what is told; forces that others share are no reason to doubt what is determined.
TEST(Checks, what_is_told_is_confirmed_beside_shared_forces) {
  const Solution solution = solved(R"(
points: {O: [0, 0, 0], G: [200 mm, 0, 0], C: [200 mm, -100 mm, 0]}
bodies: {arm: massless, gear: {disk: {center: G, normal: x, radius: 100 mm}, mass: 3 kg}}
joints:
  column: {revolute: y, at: O, to: arm, rate: 90 rpm, accel: 0}
  pin: {revolute: x, at: G, from: arm, to: gear}
contacts: {mesh: {of: gear, at: C, normal: y, no_slip: true, carries: [push]}}
gravity: -y
ask: {N: force(mesh on gear).y, F: force(pin on gear).x, H: angular_momentum(gear about O), v: velocity(gear relative to arm)}
)");
  EXPECT_EQ(solution.asks[0].state, AskState::undetermined);
  for (std::size_t i = 1; i < 4; ++i) EXPECT_EQ(solution.asks[i].state, AskState::found) << solution.asks[i].reason;
  ASSERT_TRUE(solution.checks.contains("quantities"));
  EXPECT_LT(solution.checks.at("quantities"), 1e-10);
}

TEST(Unphysical, rows_of_tables_are_left_out) {
  const std::string table = "t: {table: {F: F, t: tension(c), a: acceleration(p).y}, over: {F: RANGE}}";
  const auto over = [&](const std::string& range) {
    std::string text = table;
    return solved(hanging("5 N", text.replace(text.find("RANGE"), 5, range)));
  };
  EXPECT_EQ(over("0 N .. 19 N by 1 N").asks[0].state, AskState::found);
  const Solution some = over("0 N .. 30 N by 10 N");
  ASSERT_EQ(some.asks[0].state, AskState::found);
  EXPECT_EQ(some.asks[0].columns.front().values, (std::vector<double>{0, 10}));
  EXPECT_TRUE(std::ranges::count(some.notes,
                                 "t: the rows F = 20 N and F = 30 N have no answer and are left out: the cord "
                                 "'c' would have to push: it goes slack"));
  const SolvedAsk none = over("20 N .. 30 N by 10 N").asks[0];
  EXPECT_EQ(none.state, AskState::undetermined);
  EXPECT_TRUE(none.reason.starts_with("in every row: the cord 'c' would have to push: it goes slack")) << none.reason;
}

TEST(Unphysical, truths_about_forces_are_refused_but_for_what_tells_it) {
  const Solution solution =
      solved(hanging("30 N", "t: tension(c) < 0 N, a: norm(acceleration(p)) < 1e-9 m/s^2, taut: taut(c)"));
  EXPECT_EQ(solution.asks[0].state, AskState::refused);
  EXPECT_EQ(solution.asks[1].state, AskState::refused);
  EXPECT_EQ(solution.asks[2].state, AskState::found);
  EXPECT_FALSE(solution.asks[2].value.truth);
}

TEST(Unphysical, extrema_beyond_it_are_refused) {
  const std::string ask = "e: {largest: F, while: [CONDITION]}";
  const auto largest = [&](const std::string& condition) {
    std::string text = ask;
    return solved(hanging("5 N", text.replace(text.find("CONDITION"), 9, condition))).asks[0];
  };
  const SolvedAsk pushed = largest("tension(c) > -3 N");
  EXPECT_EQ(pushed.state, AskState::refused);
  const SolvedAsk taut = largest("taut(c)");
  EXPECT_EQ(taut.state, AskState::found);
  EXPECT_NEAR(taut.value.number, 2 * 9.80665, 1e-9);
}

TEST(Unphysical, unknowns_that_follow_from_a_pull_are_refused) {
  const Solution solution = solved(R"(
find: {F: N}
gravity: -y
points: {G: [0, 0, 0], C: [0, -30 mm, 0]}
bodies: {ball: {sphere: {center: G, radius: 30 mm}, mass: 2 kg}}
contacts: {table: {of: ball, against: ground, at: C, normal: y}}
loads: {pull: {force: '[0, F, 0]', body: ball}}
facts: {velocity(ball): 0, force(table on ball).y: -5 N}
ask: {F: F}
)");
  EXPECT_EQ(solution.asks[0].state, AskState::refused);
}

TEST(Facts, hold_in_the_answer_and_are_told) {
  const Solution solution = solved(R"(
find: {w: rad/s}
where: [w > 0]
points: {O: [0, 0, 0], A: [0.8 m, 0, 0]}
bodies: {bar: {rod: [O, A], mass: 3 kg}}
joints: {pin: {revolute: z, at: O, to: bar, rate: w}}
facts: {norm(velocity(bar)): 2 m/s}
gravity: -y
ask: {w: w}
)");
  EXPECT_NEAR(solution.asks[0].value.number, 5, 1e-9);
  ASSERT_TRUE(solution.checks.contains("facts"));
  EXPECT_LT(solution.checks.at("facts"), 1e-9);
}

// Solved with one rate, checked against a statement with another.
TEST(Facts, that_do_not_hold_are_seen) {
  const std::string text = R"yaml(
points: {O: [0, 0, 0], A: [0.8 m, 0, 0]}
bodies: {bar: {rod: [O, A], mass: 3 kg}}
joints: {pin: {revolute: z, at: O, to: bar}}
facts: {"velocity(A of bar)": [0, 2 m/s, 0]}
gravity: -y
ask: {H: momentum(bar)}
)yaml";
  std::string other = text;
  other.replace(other.find("2 m/s"), 5, "3 m/s");
  const Statement statement = read_statement(text, "test.yaml"), false_statement = read_statement(other, "test.yaml");
  Sample sample(statement, AllSettings(1), OpenChoice{});
  asked_value(sample, statement.asks.front());
  EXPECT_LT(largest_fact_misfit(statement, sample).value(), 1e-15);
  EXPECT_NEAR(largest_fact_misfit(false_statement, sample).value(), 1.0 / 3, 0.2);
}

// A contact that is said not to slip, but to carry no friction: what follows a disturbance depends on which is meant.
TEST(Checks, of_a_stability_that_nobody_asks_for_are_not_told_beside_other_answers) {
  const std::string car = R"(
points: {O: [0, 0, 0], G: [9 m, 0, 0.5 m], A: [10 m, 0, 0], B: [8 m, 0, 0]}
frames: {road: {turns: z, rate: 0.2 rad/s}}
bodies: {car: {mass: 1500 kg, center: G, inertia: {x: 400 kg*m^2, y: 900 kg*m^2, z: 1000 kg*m^2}}}
contacts:
  outer: {of: car, against: road, corner: A, normal: z, no_slip: true, carries: [push, x, y]}
  inner: {of: car, against: road, corner: B, normal: z, no_slip: true, carries: [push]}
steady: {frame: road}
gravity: -z
)";
  const Solution push = solved(car + "ask: {N: normal_force(outer)}\n");
  EXPECT_EQ(push.asks[0].state, AskState::found);
  EXPECT_FALSE(push.checks.contains("stability"));
  ASSERT_EQ(push.notes.size(), 1U);
  EXPECT_EQ(push.notes[0],
            "whether the steady motion is stable is not told: the motion of its bodies, each by itself, does not "
            "confirm it");
  const Solution stable = solved(car + "ask: {s: stable(car)}\n");
  EXPECT_EQ(stable.asks[0].state, AskState::refused);
  EXPECT_GT(stable.checks.at("stability"), 1e-3);
}

// What is stated of accelerations and forces at the start is held whatever is asked: k s / m is 2.5 m/s^2 there.
TEST(Facts, AccelerationsAndForcesAtTheStartHoldWhateverIsAsked) {
  const auto told = [](const std::string& stated, const std::string& ask) -> std::string {
    try {
      solved(
          "given: {m: 2 kg, k: 50 N/m}\npoints: {B: [0, 0, 0]}\nbodies: {b: {particle: B, mass: m}}\n"
          "joints: {rail: {prismatic: x, at: B, to: b, displacement: s, spring: {stiffness: k}}}\ngravity: none\n"
          "instants: {start: {s: 0.1 m, s': 1 m/s, " +
          stated + "}}\nask: {a: " + ask + "}\n");
    } catch (const StatementError& error) {
      return error.what();
    }
    return "";
  };
  for (const char* ask : {"s @ 0.3 s", "max(s)", "kinetic_energy(b)"}) {
    EXPECT_EQ(told("s'': 7 m/s^2", ask),
              "test.yaml:6:41: error: these cannot all hold together: forces on b along x; 'start': s'' (correct or "
              "remove one of them)")
        << ask;
    EXPECT_NE(told("'reaction(rail).y': 3 N", ask), "") << ask;
    EXPECT_EQ(told("s'': -2.5 m/s^2", ask), "") << ask;
    EXPECT_EQ(told("'reaction(rail).y': 0 N", ask), "") << ask;
  }
}

// A box that spins about an axis round which it is not alike precesses steadily on no ball joint: the moments balance
// in the position that is drawn alone. A body of revolution in its place is told to be stable or not.
TEST(Checks, a_steady_motion_that_is_none_is_told) {
  const auto notes = [](const std::string& body) {
    const Solution solution = solved(
        "given: {m: 2 kg, h: 0.1 m, P: 3 rad/s}\nfind: {s: rad/s}\n"
        "points: {O: [0, 0, 0], G: [h, 0, 0]}\nframes: {f: {turns: z, rate: P}}\n"
        "bodies: {b: {" +
        body +
        ", mass: m}}\njoints: {tip: {ball: O, to: b}}\n"
        "steady: {frame: f, spins: {b: {about: O->G, rate: s}}}\ngravity: -z\n"
        "ask: {s: s}\n");
    std::string all;
    for (const std::string& note : solution.notes) all += note + "\n";
    return all;
  };
  const std::string looked_at = "the steady motion is looked at where it is drawn; as it goes on, ";
  for (const char* sides : {"[2 cm*x, 10 cm*y, 20 cm*z]", "[2 cm*x, 20 cm*y, 10 cm*z]"})
    EXPECT_NE(notes("box: {center: G, sides: " + std::string(sides) + "}").find(looked_at), std::string::npos) << sides;
  EXPECT_EQ(notes("disk: {center: G, normal: x, radius: 10 cm}").find(looked_at), std::string::npos);
}

}  // namespace answer_checks_test
}  // namespace poinsot::problem
