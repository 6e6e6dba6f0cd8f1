// Contacts with dry friction, held against closed forms and against the enumeration of states by hand.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "problem/answers/solve_statement.h"
#include "problem/language/diagnostic.h"

namespace poinsot::problem {
namespace friction_test {

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
bool truth(const Solution& solution, std::size_t ask) {
  EXPECT_EQ(solution.asks.at(ask).state, AskState::found) << solution.asks.at(ask).reason;
  return solution.asks.at(ask).value.truth;
}

std::string incline(double angle, double at_rest, double sliding, double pull, const std::string& rest = "") {
  return fmt::format(
      "given: {{m: 3 kg, b: {} rad, P: {} N}}\npoints: {{C: [0, 0, 0]}}\n"
      "directions: {{down: [cos(b), -sin(b), 0], out: [sin(b), cos(b), 0]}}\n"
      "bodies: {{block: {{particle: C, mass: m}}}}\n"
      "contacts: {{slope: {{of: block, at: C, normal: out, friction: {{static: {}, kinetic: {}}}}}}}\n"
      "loads: {{pull: {{force: P*down, at: C, body: block}}}}\ngravity: -y\n"
      "{}\nask: {{a: component(acceleration(block) along down), N: normal_force(slope), s: sticking(slope), "
      "F: component(friction(slope on block) along down)}}\n",
      angle, pull, at_rest, sliding, rest.empty() ? "instants: {now: rest}" : rest);
}

TEST(Friction, of_a_block_on_an_incline_is_the_closed_form) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> angle(0.05, 1.4), coefficient(0.05, 1.2), pull(-40, 40);
  int sticks = 0, slides = 0;
  for (int trial = 0; trial < 60; ++trial) {
    const double b = angle(random), s = coefficient(random), k = s * (trial % 2 ? 1 : 0.8), P = pull(random);
    const SolvedStatement found = solved(incline(b, s, k, P));
    ASSERT_EQ(found.solutions.size(), 1U);
    const Solution& solution = found.solutions.front();
    const double m = 3, N = m * g * std::cos(b), drive = P + m * g * std::sin(b);
    const bool stuck = std::abs(drive) <= s * N;
    ++(stuck ? sticks : slides);
    const double F = stuck ? -drive : -std::copysign(k * N, drive);
    EXPECT_EQ(truth(solution, 2), stuck);
    EXPECT_NEAR(number(solution, 0), (drive + F) / m, 1e-9 * g);
    EXPECT_NEAR(number(solution, 1), N, 1e-9 * N);
    EXPECT_NEAR(number(solution, 3), F, 1e-9 * N);
  }
  EXPECT_GT(sticks, 10);
  EXPECT_GT(slides, 10);
}

TEST(Friction, is_against_a_slip_in_any_direction) {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> speed(-3, 3);
  for (int trial = 0; trial < 20; ++trial) {
    const double u = speed(random), w = speed(random), size = std::hypot(u, w);
    const SolvedStatement found =
        solved(fmt::format("points: {{C: [0, 0, 0]}}\nbodies: {{block: {{particle: C, mass: 2 kg}}}}\n"
                           "contacts: {{floor: {{of: block, at: C, normal: y, friction: 0.3}}}}\ngravity: -y\n"
                           "facts: {{velocity(block): ['{} m/s', 0, '{} m/s']}}\nask: {{x: acceleration(block).x, z: "
                           "acceleration(block).z}}\n",
                           u, w));
    ASSERT_EQ(found.solutions.size(), 1U);
    EXPECT_NEAR(number(found.solutions.front(), 0), -0.3 * g * u / size, 1e-9 * g);
    EXPECT_NEAR(number(found.solutions.front(), 1), -0.3 * g * w / size, 1e-9 * g);
  }
}

TEST(Friction, begins_to_slide_where_it_is_pulled) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> pull(-30, 30);
  int slides = 0;
  for (int trial = 0; trial < 20; ++trial) {
    const double P = pull(random), Q = pull(random), size = std::hypot(P, Q), limit = 0.5 * 2 * g;
    const SolvedStatement found =
        solved(fmt::format("points: {{C: [0, 0, 0]}}\nbodies: {{block: {{particle: C, mass: 2 kg}}}}\n"
                           "contacts: {{floor: {{of: block, at: C, normal: y, friction: 0.5}}}}\ngravity: -y\n"
                           "loads: {{pull: {{force: ['{} N', 0, '{} N'], at: C, body: block}}}}\n"
                           "instants: {{now: rest}}\nask: {{x: acceleration(block).x, z: acceleration(block).z}}\n",
                           P, Q));
    ASSERT_EQ(found.solutions.size(), 1U);
    const double a = std::max(0.0, size - limit) / 2;
    slides += a > 0;
    EXPECT_NEAR(number(found.solutions.front(), 0), a * P / size, 1e-8 * g);
    EXPECT_NEAR(number(found.solutions.front(), 1), a * Q / size, 1e-8 * g);
  }
  EXPECT_GT(slides, 5);
}

std::string crate(double pull, double height, double friction, const std::string& word = "friction") {
  const std::string rough = word == "friction"  ? fmt::format(", friction: {}", friction)
                            : word == "no_slip" ? ", no_slip: true"
                                                : "";
  return fmt::format(
      "given: {{m: 50 kg, P: {} N, c: 0.4 m, h: {} m}}\n"
      "points: {{A: [-c, 0, 0], B: [c, 0, 0], G: [0, 1 m, 0], K: [c, h, 0]}}\n"
      "bodies: {{crate: {{box: {{center: G, sides: [[2*c, 0, 0], [0, 2 m, 0], [0, 0, 1 m]]}}, mass: m}}}}\n"
      "contacts:\n  left: {{of: crate, at: A, normal: y{}}}\n  right: {{of: crate, at: B, normal: y{}}}\n"
      "loads: {{pull: {{force: [P, 0, 0], at: K, body: crate}}}}\ngravity: -y\ninstants: {{now: rest}}\n"
      "ask: {{a: acceleration(crate).x, w: angular_acceleration(crate).z}}\n",
      pull, height, rough, rough);
}

// By hand: it stays, slides on both corners, tips about the right one, or slides and tips.
struct Planar {
  double a = 0, w = 0;
};
std::vector<Planar> crate_by_hand(double P, double h, double mu) {
  const double m = 50, c = 0.4, H = 1, W = m * g, I = m * (4 * c * c + 4 * H * H) / 12;
  std::vector<Planar> found;
  // Moments about the right corner tip it by P h against W c.
  if (std::abs(P) <= mu * W && P * h <= W * c) found.push_back({});
  {
    const double a = (P - mu * W) / m;  // both press: N = W
    // About the mass center, clockwise: P (h - H) + mu W H = c (right - left).
    const double difference = (P * (h - H) + mu * W * H) / c;
    if (a > 0 && std::abs(difference) <= W) found.push_back({a, 0});
  }
  {
    // It turns about B: I + m (c^2 + H^2) times w' = W c - P h (positive about z), tipping is w' < 0.
    const double w = (W * c - P * h) / (I + m * (c * c + H * H));
    const double ax = -w * H, ay = -w * c, F = m * ax - P, N = W + m * ay;
    if (w < 0 && N >= 0 && std::abs(F) <= mu * N) found.push_back({ax, w});
  }
  {
    // It slides on B along x and tips: N, a, w from three equations.
    // m ax = P - mu N; N - W = m ay, ay = -w c; I w = N c - mu N H - P (h - H).
    const double N = (W - m * c * P * (H - h) / I) / (1 + m * c * (c - mu * H) / I);
    const double w = (N * (c - mu * H) - P * (h - H)) / I, ax = (P - mu * N) / m;
    const double slip = ax + w * H;
    if (w < 0 && N >= 0 && slip > 0) found.push_back({ax, w});
  }
  return found;
}

TEST(Friction, tips_or_slides_a_crate_as_by_hand) {
  std::mt19937 random(6);
  std::uniform_real_distribution<double> pull(20, 500), height(0.1, 1.9), coefficient(0.1, 0.9);
  std::array<int, 3> kinds{};
  for (int trial = 0; trial < 40; ++trial) {
    const double P = std::round(pull(random)), h = std::round(100 * height(random)) / 100,
                 mu = std::round(100 * coefficient(random)) / 100;
    const std::vector<Planar> right = crate_by_hand(P, h, mu);
    if (right.size() != 1) continue;
    const SolvedStatement found = solved(crate(P, h, mu));
    ASSERT_EQ(found.solutions.size(), 1U) << P << " " << h << " " << mu;
    EXPECT_NEAR(number(found.solutions.front(), 0), right.front().a, 1e-8 * g) << P << " " << h << " " << mu;
    EXPECT_NEAR(number(found.solutions.front(), 1), right.front().w, 1e-8 * g) << P << " " << h << " " << mu;
    ++kinds[right.front().w != 0 ? 2 : right.front().a != 0 ? 1 : 0];
  }
  for (const int kind : kinds) EXPECT_GT(kind, 3);
}

TEST(Friction, that_is_zero_is_smooth_and_a_large_one_does_not_slip) {
  for (const double P : {30.0, 100.0}) {
    const Solution none = solved(crate(P, 0.9, 0)).solutions.at(0),
                   smooth = solved(crate(P, 0.9, 0, "")).solutions.at(0);
    EXPECT_NEAR(number(none, 0), number(smooth, 0), 1e-10 * g);
    const Solution large = solved(crate(P, 0.9, 1e6)).solutions.at(0),
                   no_slip = solved(crate(P, 0.9, 0, "no_slip")).solutions.at(0);
    EXPECT_NEAR(number(large, 0), number(no_slip, 0), 1e-10 * g);
    EXPECT_NEAR(number(large, 1), number(no_slip, 1), 1e-10 * g);
  }
}

// Painleve's rod slides on its end with the speed v: m ay = N - m g, I w' = N (l/2) (mu sin b -+ cos b).
std::string rod(double friction, double speed) {
  return fmt::format(
      "given: {{m: 1 kg, L: 2 m, b: 55 deg, v: {} m/s}}\npoints: {{A: [0, 0, 0], B: [L*cos(b), L*sin(b), 0]}}\n"
      "bodies: {{rod: {{rod: [A, B], mass: m}}}}\ncontacts: {{floor: {{of: rod, at: A, normal: y, friction: {}}}}}\n"
      "gravity: -y\nfacts: {{velocity(A of rod): [v, 0, 0], angular_velocity(rod): [0, 0, 0]}}\n"
      "ask: {{w: angular_acceleration(rod).z, N: normal_force(floor)}}\n",
      speed, friction);
}

TEST(Friction, of_painleves_rod_has_one_solution_several_or_none) {
  const double m = 1, l = 1, b = 55 * M_PI / 180, I = m * 4 * l * l / 12;
  for (const double mu : {0.3, 1.0, 2.0, 3.0})
    for (const double v : {1.0, -1.0}) {
      // The normal acceleration of A is N (1/m + l^2 cos b (cos b - s mu sin b)/I) - g, with s the sense of the slip
      // that presses the end down.
      const double s = v < 0 ? 1 : -1;
      const double p = 1 / m + l * l * std::cos(b) * (std::cos(b) - s * mu * std::sin(b)) / I;
      const std::string text = rod(mu, v);
      if (p > 0) {
        const SolvedStatement found = solved(text);
        ASSERT_EQ(found.solutions.size(), 1U);
        EXPECT_NEAR(number(found.solutions.front(), 1), g / p, 1e-9 * g / p);
      } else {
        EXPECT_NE(refusal(text).find("no state of the contacts with friction holds"), std::string::npos);
      }
    }
  // Thrown upwards about its end the rod may part as well: with a turning the surface recedes.
  const std::string turning = [] {
    std::string text = rod(3, -1);
    text.replace(text.find("angular_velocity(rod): [0, 0, 0]"), 32, "angular_velocity(rod): '[0, 0, -5 rad/s]'");
    return text;
  }();
  // Of A the normal acceleration without contact is -g + w^2 l sin b.
  const double free = -g + 25 * l * std::sin(b);
  const double p = 1 / m + l * l * std::cos(b) * (std::cos(b) - 3 * std::sin(b)) / I;
  ASSERT_LT(p, 0);
  ASSERT_GT(free, 0);
  const SolvedStatement both = solved(turning);
  ASSERT_EQ(both.solutions.size(), 2U);
  EXPECT_NEAR(number(both.solutions[0], 1), -free / p, 1e-9 * g);
  EXPECT_EQ(number(both.solutions[1], 1), 0);
}

TEST(Friction, in_letters_tells_its_conditions) {
  const SolvedStatement found = solved(
      "letters: {m: kg, P: N, mu: 1}\npoints: {C: [0, 0, 0]}\nbodies: {block: {particle: C, mass: m}}\n"
      "contacts: {floor: {of: block, at: C, normal: y, friction: mu}}\n"
      "loads: {pull: {force: [P, 0, 0], at: C, body: block}}\ngravity: -y\ninstants: {now: rest}\n"
      "ask: {a: acceleration(block).x}\n");
  ASSERT_EQ(found.solutions.size(), 2U);
  for (const Solution& solution : found.solutions) {
    ASSERT_FALSE(solution.grounds.empty());
    // At these letters m g mu = 3 g and 12 g: of P = 5 g the block slides at the first and sticks at the second.
    const bool sticks = solution.contact_states.front().grip == Grip::sticks;
    for (const bool holds : {false, true}) {
      const LetterValues letters{{"m", 6}, {"P", 5 * g}, {"mu", holds ? 2 : 0.5}};
      bool all = true;
      for (const FormulaCondition& ground : solution.grounds) all = all && value_at(ground.positive, letters) > 0;
      EXPECT_EQ(all, holds == sticks);
    }
    if (!sticks) {
      ASSERT_TRUE(solution.asks[0].formula);
      EXPECT_NEAR(value_at(solution.asks[0].formula->number, {{"m", 6}, {"P", 5 * g}, {"mu", 0.5}}), g / 3, 1e-12);
    }
  }
}

// How far and how long it slides, by the work of the friction.
TEST(Friction, in_letters_tells_where_motions_end) {
  const SolvedStatement found = solved(
      "letters: {m: kg, v: m/s, mu: 1}\npoints: {C: [0, 0, 0]}\nbodies: {block: {particle: C, mass: m}}\n"
      "contacts: {floor: {of: block, at: C, normal: y, friction: mu}}\ngravity: -y\n"
      "instants: {start: {velocity(block): [v, 0, 0]}, rests: {first_time: sticking(floor)}}\n"
      "ask: {t: {first_time: sticking(floor)}, s: position(block).x @ rests}\n");
  ASSERT_EQ(found.solutions.size(), 1U);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> draw(0.2, 3);
  for (int i = 0; i < 20; ++i) {
    const double v = draw(random), mu = draw(random);
    const LetterValues at{{"m", draw(random)}, {"v", v}, {"mu", mu}};
    const auto& asks = found.solutions[0].asks;
    ASSERT_TRUE(asks[0].formula && asks[1].formula) << asks[0].no_formula << asks[1].no_formula;
    EXPECT_NEAR(value_at(asks[0].formula->number, at), v / (mu * g), 1e-9 * v / mu);
    EXPECT_NEAR(value_at(asks[1].formula->number, at), v * v / (2 * mu * g), 1e-9 * v * v / mu);
  }
}

TEST(Friction, is_found_from_what_is_known_later) {
  const SolvedStatement found = solved(
      "given: {v: 4 m/s, t: 1.5 s, s: 4 m}\nfind: {mu: 1}\nwhere: [0 < mu < 2]\npoints: {C: [0, 0, 0]}\n"
      "bodies: {block: {particle: C, mass: 2 kg}}\n"
      "contacts: {floor: {of: block, at: C, normal: y, friction: mu}}\ngravity: -y\n"
      "instants: {start: {velocity(block): [v, 0, 0]}, t: {center(block).x: s}}\nask: {mu: mu}\n");
  ASSERT_EQ(found.solutions.size(), 1U);
  EXPECT_NEAR(number(found.solutions[0], 0), 2 * (4 * 1.5 - 4) / (g * 1.5 * 1.5), 1e-8);
}

// A block on an incline stays or slides: what is claimed is decided in each of both.
TEST(Friction, claims_are_decided_in_each_state) {
  const SolvedStatement found = solved(
      "letters: {m: kg, mu: 1, b: rad}\nassume: [0 < b < 1.5 rad]\npoints: {C: [0, 0, 0]}\n"
      "directions: {out: [sin(b), cos(b), 0], down: [cos(b), -sin(b), 0]}\n"
      "bodies: {block: {particle: C, mass: m}}\n"
      "contacts: {slope: {of: block, at: C, normal: out, friction: mu}}\ngravity: -y\ninstants: {now: rest}\n"
      "ask: {a: component(acceleration(block) along down)}\n"
      "claim: {pressed: normal_force(slope) == m*g*cos(b), rests: component(acceleration(block) along down) == 0}\n");
  ASSERT_EQ(found.solutions.size(), 2U);
  for (const Solution& solution : found.solutions) {
    const bool sticks = solution.contact_states.front().grip == Grip::sticks;
    for (const SolvedClaim& claim : solution.claims) EXPECT_EQ(claim.state, AskState::found) << claim.reason;
    EXPECT_TRUE(solution.claims[0].holds);
    EXPECT_EQ(solution.claims[1].holds, sticks);
  }
}

TEST(Friction, of_a_smooth_contact_is_told_to_be_its_force) {
  EXPECT_NE(refusal("points: {C: [0, 0, 0]}\nbodies: {block: {particle: C, mass: 1 kg}}\n"
                    "contacts: {floor: {of: block, at: C, normal: y}}\ngravity: -y\ninstants: {now: rest}\n"
                    "ask: {F: friction(floor on block)}\n")
                .find("contact 'floor' has no friction stated"),
            std::string::npos);
}

TEST(Friction, is_refused_where_it_is_not_solved) {
  const std::string block =
      "points: {C: [0, 0, 0]}\nbodies: {block: {particle: C, mass: 1 kg}}\n"
      "contacts: {floor: {of: block, at: C, normal: y, friction: 0.3}}\ngravity: -y\ninstants: {now: rest}\n";
  EXPECT_NE(
      refusal("points: {C: [0, 0, 0], G: [1 m, 0, 0]}\nbodies: {arm: {rod: [C, G], mass: 1 kg}}\n"
              "joints: {pin: {revolute: z, at: C, to: arm, friction: {coefficient: 0.2, radius: 10 mm}}}\n"
              "gravity: -y\nimpulses: {hit: {value: [0, '1 N*s', 0], at: G, body: arm}}\ninstants: {before: rest}\n"
              "ask: {w: angular_velocity(arm)}\n")
          .find("a blow is not solved beside joint 'pin'"),
      std::string::npos);
  std::string sliding = block;
  sliding.replace(sliding.find("rest"), 4, "{velocity(block): [1 m/s, 0, 0]}");
  EXPECT_NE(
      refusal(sliding + "ask: {s: stable(block)}\n").find("told where all that has friction are contacts that stick"),
      std::string::npos);
  EXPECT_NE(refusal("points: {C: [0, 0, 0]}\nbodies: {block: {particle: C, mass: 1 kg}}\n"
                    "contacts: {floor: {of: block, at: C, normal: y, friction: -0.3}}\ngravity: -y\n"
                    "instants: {now: rest}\nask: {a: acceleration(block)}\n")
                .find("negative coefficient"),
            std::string::npos);
  EXPECT_NE(refusal("points: {C: [0, 0, 0]}\nbodies: {block: {particle: C, mass: 1 kg}}\n"
                    "contacts: {floor: {of: block, at: C, normal: y, friction: {static: 0.2, kinetic: 0.3}}}\n"
                    "gravity: -y\ninstants: {now: rest}\nask: {a: acceleration(block)}\n")
                .find("more friction while it slides"),
            std::string::npos);
  EXPECT_NE(refusal("points: {C: [0, 0, 0]}\nbodies: {block: {particle: C, mass: 1 kg}}\n"
                    "contacts: {floor: {of: block, at: C, normal: y, friction: 0.3, no_slip: true}}\n"
                    "gravity: -y\ninstants: {now: rest}\nask: {a: acceleration(block)}\n")
                .find("states friction and no_slip"),
            std::string::npos);
}

}  // namespace friction_test
}  // namespace poinsot::problem
