// Up to which load contacts with friction stick, beside others that may slip, and unknowns that are found with
// friction.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "problem/answers/solve_statement.h"
#include "problem/language/diagnostic.h"
#include "problem/plane/planar_statement.h"

namespace poinsot::problem {
namespace friction_limits_test {

constexpr double g = 9.80665;

SolvedStatement solved(const std::string& text) { return solve_statement(read_statement(text, "test.yaml"), {}); }

std::string refusal(const std::string& text) {
  try {
    solved(text);
  } catch (const StatementError& error) {
    return error.diagnostics().front().message;
  }
  return "";
}

double number(const Solution& solution, std::size_t ask) {
  EXPECT_EQ(solution.asks.at(ask).state, AskState::found) << solution.asks.at(ask).reason;
  return solution.asks.at(ask).value.number;
}

std::string stack(double m, double M, double u, double w, const char* pulled, const char* asked) {
  return fmt::format(
      "given: {{m: {} kg, M: {} kg, P: 1 N}}\npoints: {{C: [0, 0.5 m, 0], D: [0, 0, 0], T: [0, 0.25 m, 0]}}\n"
      "bodies:\n  top: {{particle: C, mass: m}}\n"
      "  low: {{box: {{center: T, sides: [[1 m, 0, 0], [0, 0.5 m, 0], [0, 0, 0.5 m]]}}, mass: M}}\n"
      "joints: {{guide: {{planar: z, at: T, to: low, freedoms: {{turn: {{rate: 0, accel: 0}}}}}}}}\n"
      "contacts:\n  mid: {{of: top, against: low, at: C, normal: y, friction: {}}}\n"
      "  floor: {{of: low, at: D, normal: y, friction: {}}}\n"
      "loads: {{pull: {{force: [P, 0, 0], body: {}}}}}\ngravity: -y\ninstants: {{now: rest}}\n"
      "ask: {{most: {{largest: P, while: {}}}}}\n",
      m, M, u, w, pulled, asked);
}

TEST(FrictionLimits, of_one_contact_are_found_whatever_the_others_do) {
  constexpr double m = 2, M = 5, all = (m + M) * g;
  const auto most = [](double u, double w, const char* body, const char* asked) {
    return number(solved(stack(m, M, u, w, body, asked)).solutions.at(0), 0);
  };
  EXPECT_NEAR(most(0.3, 0.2, "low", "[sticking(mid), sticking(floor)]"), 0.2 * all, 1e-8 * all);
  // The lower block takes the upper along with the acceleration (P - w (m + M) g)/(m + M), of u g at most.
  EXPECT_NEAR(most(0.3, 0.2, "low", "sticking(mid)"), (0.3 + 0.2) * all, 1e-8 * all);
  // Pulled by the upper block, either the upper slips on the lower at rest, or the lower comes along first.
  EXPECT_NEAR(most(0.3, 0.2, "top", "sticking(mid)"), 0.3 * m * g, 1e-8 * all);
  EXPECT_NEAR(most(0.7, 0.1, "top", "sticking(mid)"), (0.7 - 0.1) * all * m / M, 1e-8 * all);
}

// What makes no sense where the block lifts off is no reason, as it slides.
TEST(FrictionLimits, unknowns_that_no_state_has_are_said_not_to_be_found) {
  const std::string said = refusal(
      "find: {mu: 1}\nwhere: [0.05 < mu < 1.5]\npoints: {E: [0, 0, 0]}\nbodies: {b: {particle: E, mass: 1 kg}}\n"
      "contacts: {c: {of: b, at: E, normal: y, friction: mu}}\ngravity: -y\n"
      "instants: {start: {velocity(b): [3 m/s, 0, 0]}, 1 s: {velocity(b).x: 5 m/s}}\nask: {mu: mu}\n");
  EXPECT_EQ(said, "no state of the contacts with friction was found that holds");
}

TEST(FrictionLimits, that_lie_below_zero_are_not_told_as_zero) {
  // With more friction than the slope has, it holds while nothing pushes, and while something pulls.
  const SolvedStatement found = solved(
      "given: {m: 10 kg, P: 120 N}\npoints: {C: [0, 0, 0]}\n"
      "directions: {out: ['-sin(30 deg)', 'cos(30 deg)', 0]}\nbodies: {block: {particle: C, mass: m}}\n"
      "contacts: {slope: {of: block, at: C, normal: out, friction: 0.9}}\n"
      "loads: {push: {force: [P, 0, 0], at: C, body: block}}\ngravity: -y\ninstants: {now: rest}\n"
      "ask: {least: {smallest: P, while: sticking(slope)}}\n");
  const SolvedAsk& least = found.solutions.at(0).asks.at(0);
  EXPECT_NE(least.state, AskState::found);
  EXPECT_NE(least.reason.find("opposite sense"), std::string::npos) << least.reason;
}

std::string pulled(const std::string& friction, const std::string& stated) {
  return "given: {m: 3 kg}\nfind: {P: N}\npoints: {C: [0, 0, 0]}\nbodies: {block: {particle: C, mass: m}}\n"
         "contacts: {floor: {of: block, at: C, normal: y, friction: " +
         friction +
         "}}\nloads: {pull: {force: [P, 0, 0], at: C, body: block}}\ngravity: -y\n"
         "instants: {now: {velocity(block): [0, 0, 0], " +
         stated + "}}\nask: {P: P, s: sliding(floor)}\n";
}

TEST(FrictionLimits, are_passed_by_a_load_that_is_found) {
  for (const double a : {0.5, 2.0, 7.0}) {
    const SolvedStatement found = solved(pulled("0.3", fmt::format("acceleration(block).x: '{} m/s^2'", a)));
    ASSERT_EQ(found.solutions.size(), 1U);
    EXPECT_NEAR(number(found.solutions[0], 0), 3 * (a + 0.3 * g), 1e-8 * g);
    EXPECT_TRUE(found.solutions[0].asks[1].value.truth);
    EXPECT_TRUE(found.warnings.empty()) << found.warnings.front();
    EXPECT_NE(found.solutions[0].notes.back().find("begins to slide along x"), std::string::npos);
  }
  const SolvedStatement at_rest = solved(pulled("0.3", "friction(floor on block).x: -5 N"));
  ASSERT_EQ(at_rest.solutions.size(), 1U);
  EXPECT_NEAR(number(at_rest.solutions[0], 0), 5, 1e-8);
  EXPECT_TRUE(at_rest.warnings.empty());
  EXPECT_NE(refusal(pulled("{static: 0.4, kinetic: 0.3}", "acceleration(block).x: 0.1 m/s^2"))
                .find("begins to slide with less friction than at rest"),
            std::string::npos);
}

// At any size and mass: shares of what several contacts carry come in the unit of the equations that leave them open.
TEST(FrictionLimits, are_the_same_at_every_scale) {
  for (const auto& [length, mass] : {std::pair(1e6, 1e4), {1e-3, 1.0}, {1.0, 1e5}, {1e3, 1e-6}}) {
    const SolvedStatement found = solved(fmt::format(
        "given: {{m: '2*{1} kg', M: '5*{1} kg', P: '60*{0}*{1} N', g: '9.80665*{0} m/s^2'}}\n"
        "points: {{C: ['0', '0.5*{0} m', '0'], D: [0, 0, 0], T: ['0', '0.25*{0} m', '0']}}\n"
        "bodies:\n  top: {{particle: C, mass: m}}\n"
        "  low: {{box: {{center: T, sides: [['{0} m', 0, 0], [0, '0.5*{0} m', 0], [0, 0, '0.5*{0} m']]}}, mass: M}}\n"
        "joints: {{guide: {{planar: z, at: T, to: low, freedoms: {{turn: {{rate: 0, accel: 0}}}}}}}}\n"
        "contacts:\n  mid: {{of: top, against: low, at: C, normal: y, friction: 0.3}}\n"
        "  floor: {{of: low, at: D, normal: y, friction: 0.2}}\n"
        "loads: {{pull: {{force: [P, 0, 0], body: low}}}}\ngravity: -y\ninstants: {{now: rest}}\n"
        "ask: {{most: {{largest: P, while: [sticking(mid), sticking(floor)]}}}}\n",
        length, mass));
    const double most = 0.2 * 7 * 9.80665 * length * mass;
    EXPECT_NEAR(number(found.solutions.at(0), 0), most, 1e-8 * most) << length << " " << mass;
  }
}

// A crate that slides on two feet, b apart, pushed at a height: it tips where the push and the friction at the floor
// have the moment of half its breadth about its mass center.
TEST(FrictionLimits, up_to_which_a_contact_touches_are_found_while_others_slide) {
  constexpr double m = 20, b = 0.5, H = 1.4, h = 1.1, mu = 0.2;
  const std::string text = fmt::format(
      "given: {{P: 1 N}}\npoints: {{A: [0, 0, 0], B: [{0} m, 0, 0], Q: [0, {2} m, 0]}}\n"
      "bodies: {{crate: {{box: {{center: [{0} m/2, {1} m/2, 0], sides: [{0} m * x, {1} m * y, 0.5 m * z]}}, mass: 20 "
      "kg}}}}\n"
      "joints: {{plane: {{planar: z, at: [0, 0, 0], to: crate}}}}\n"
      "contacts:\n  l: {{of: crate, at: A, normal: y, friction: {3}}}\n  r: {{of: crate, at: B, normal: y, friction: "
      "{3}}}\n"
      "loads: {{push: {{force: [P, 0, 0], at: Q, body: crate}}}}\ngravity: -y\n"
      "instants: {{now: {{velocity(crate): [1 m/s, 0, 0], angular_velocity(crate): [0, 0, 0]}}}}\n"
      "ask: {{most: {{largest: P, while: touching(l)}}, quick: {{smallest: P, while: acceleration(crate).x > 0.5 "
      "m/s^2}}}}\n",
      b, H, h, mu);
  const Solution solution = solved(text).solutions.at(0);
  EXPECT_NEAR(number(solution, 0), m * g * (b / 2 - mu * H / 2) / (h - H / 2), 1e-5);
  EXPECT_NEAR(number(solution, 1), m * (0.5 + mu * g), 1e-5);
}

// A block is pressed by a force that is found from the load on the floor: it slides from mu N on, and with more than an
// acceleration from mu N + m a on.
TEST(FrictionLimits, beside_a_load_that_is_found_at_each_value) {
  const std::string text =
      "plane: [x, y]\ngiven: {m: 2 kg, P: 1 N}\nfind: {Q: N}\npoints: {C: [0, 0]}\n"
      "bodies: {block: {particle: C, mass: m}}\ncontacts: {floor: {of: block, at: C, normal: y, friction: 0.4}}\n"
      "loads: {pull: {force: [P, 0], at: C, body: block}, press: {force: [0, -Q], at: C, body: block}}\ngravity: -y\n"
      "instants: {now: {velocity(block): [0, 0], normal_force(floor): 30 N}}\n"
      "ask: {most: {largest: P, while: sticking(floor)}, quick: {smallest: P, while: acceleration(block).x > 1 "
      "m/s^2}}\n";
  Statement statement = read_statement(text, "test.yaml");
  restrict_to_plane(statement);
  const Solution solution = solve_statement(statement, {}).solutions.at(0);
  EXPECT_NEAR(number(solution, 0), 0.4 * 30, 1e-5);
  EXPECT_NEAR(number(solution, 1), 0.4 * 30 + 2 * 1, 1e-5);
}

TEST(FrictionLimits, a_function_that_there_is_not_is_what_is_told) {
  Statement statement = read_statement(
      "plane: [x, y]\ngiven: {m: 2 kg, P: 1 N}\npoints: {C: [0, 0]}\nbodies: {block: {particle: C, mass: m}}\n"
      "contacts: {floor: {of: block, at: C, normal: y, friction: 0.4}}\n"
      "loads: {pull: {force: [P, 0], at: C, body: block}}\ngravity: -y\ninstants: {now: rest}\n"
      "ask: {most: {largest: P, while: stick(floor)}}\n",
      "test.yaml");
  restrict_to_plane(statement);
  try {
    solve_statement(statement, {});
    FAIL() << "stick() is no function";
  } catch (const StatementError& error) {
    EXPECT_EQ(error.diagnostics().front().message, "there is no function 'stick'");
    EXPECT_EQ(error.diagnostics().front().hint, "write sticking(floor)");
    EXPECT_EQ(error.diagnostics().front().mark.line, 9);
  }
}

}  // namespace friction_limits_test
}  // namespace poinsot::problem
