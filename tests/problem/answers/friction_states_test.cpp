// Which states of contacts with friction hold for bodies that move and for those that leave rest, held against closed
// forms and against the enumeration of states by hand.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "problem/answers/solve_statement.h"
#include "problem/language/diagnostic.h"
#include "problem/plane/planar_statement.h"

namespace poinsot::problem {
namespace friction_states_test {

constexpr double g = 9.80665;

SolvedStatement solved(const std::string& text) { return solve_statement(read_statement(text, "test.yaml"), {}); }

double number(const Solution& solution, std::size_t ask) {
  EXPECT_EQ(solution.asks.at(ask).state, AskState::found) << solution.asks.at(ask).reason;
  return solution.asks.at(ask).value.number;
}

// A ball moves up a slope with the speed v and turns forward with w.
TEST(FrictionStates, of_a_ball_that_rolls_or_slips_are_one) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> speed(-4, 4), angle(0, 1.2), coefficient(0.05, 0.9), rate(-80, 80);
  constexpr double r = 0.1;
  int rolls = 0;
  for (int trial = 0; trial < 60; ++trial) {
    const double b = angle(random), mu = coefficient(random), v = speed(random);
    const bool starts_rolling = trial % 3 == 0;
    const double w = starts_rolling ? v / r : rate(random), u = v - w * r;
    const SolvedStatement found = solved(
        fmt::format("given: {{b: {} rad, r: {} m, v: {} m/s, w: {} rad/s}}\n"
                    "directions: {{up: [cos(b), sin(b), 0], out: [-sin(b), cos(b), 0]}}\npoints: {{C: [0, 0, 0]}}\n"
                    "bodies: {{ball: {{sphere: {{center: r*out, radius: r}}, mass: 2 kg}}}}\n"
                    "contacts: {{slope: {{of: ball, at: C, normal: out, friction: {}}}}}\ngravity: -y\n"
                    "facts: {{velocity(ball): v*up, angular_velocity(ball): [0, 0, {}]}}\n"
                    "ask: {{a: component(acceleration(ball) along up), al: angular_acceleration(ball).z, N: "
                    "normal_force(slope)}}\n",
                    b, r, v, w, mu, starts_rolling ? "-v/r" : "-w"));
    ASSERT_EQ(found.solutions.size(), 1U) << b << " " << mu << " " << v << " " << w;
    const double N = 2 * g * std::cos(b), needed = 2.0 / 7 * 2 * g * std::sin(b);
    const bool sticks = starts_rolling && needed <= mu * N;
    // What rolls would slip down the slope.
    const double F = sticks ? needed : -std::copysign(mu * N, starts_rolling ? -1.0 : u);
    rolls += sticks;
    EXPECT_NEAR(number(found.solutions[0], 0), F / 2 - g * std::sin(b), 1e-8 * g);
    EXPECT_NEAR(number(found.solutions[0], 1), F * r / (0.4 * 2 * r * r), 1e-8 * g / r);
    EXPECT_NEAR(number(found.solutions[0], 2), N, 1e-9 * N);
  }
  EXPECT_GT(rolls, 5);
}

TEST(FrictionStates, of_a_turning_disk_in_letters_never_part) {
  const SolvedStatement found = solved(
      "letters: {m: kg, r: m, w: rad/s, mu: 1}\npoints: {C: [0, 0, 0], G: [0, r, 0]}\n"
      "bodies: {disk: {disk: {center: G, normal: z, radius: r}, mass: m}}\n"
      "contacts: {floor: {of: disk, at: C, normal: y, friction: mu}}\ngravity: -y\n"
      "facts: {velocity(disk): [0, 0, 0], angular_velocity(disk): [0, 0, -w]}\n"
      "ask: {a: acceleration(disk).x, N: normal_force(floor)}\n");
  ASSERT_EQ(found.solutions.size(), 1U);
  EXPECT_EQ(found.solutions[0].contact_states[0].grip, Grip::slides);
  const LetterValues letters{{"m", 3}, {"r", 0.2}, {"w", 70}, {"mu", 0.3}};
  ASSERT_TRUE(found.solutions[0].asks[0].formula);
  EXPECT_NEAR(value_at(found.solutions[0].asks[0].formula->number, letters), 0.3 * g, 1e-12);
  EXPECT_NEAR(value_at(found.solutions[0].asks[1].formula->number, letters), 3 * g, 1e-12);
  EXPECT_TRUE(found.warnings.empty()) << found.warnings.front();
}

// A rod slides on its lower end and turns: its end parts if it would rise when free, and it presses if what a push of
// one newton does to the end lifts it.
TEST(FrictionStates, of_a_rod_that_turns_are_as_by_hand) {
  std::mt19937 random(12);
  std::uniform_real_distribution<double> angle(0.2, 1.4), coefficient(0.1, 3), rate(-8, 8), speed(0.5, 3);
  int several = 0, none = 0;
  for (int trial = 0; trial < 60; ++trial) {
    const double b = angle(random), mu = coefficient(random), w = rate(random),
                 v = trial % 2 ? speed(random) : -speed(random);
    const double l = 1, I = 4 * l * l / 12, sense = v > 0 ? 1 : -1;
    const double lift = 1 + l * l * std::cos(b) * (std::cos(b) + sense * mu * std::sin(b)) / I;
    const double free = -g + w * w * l * std::sin(b);
    std::vector<double> pushes;
    if (-free / lift > 0) pushes.push_back(-free / lift);
    if (free > 0) pushes.push_back(0);
    const std::string text = fmt::format(
        "given: {{b: {} rad}}\npoints: {{A: [0, 0, 0], B: ['(2 m)*cos(b)', '(2 m)*sin(b)', 0]}}\n"
        "bodies: {{rod: {{rod: [A, B], mass: 1 kg}}}}\n"
        "contacts: {{floor: {{of: rod, at: A, normal: y, friction: {}}}}}\ngravity: -y\n"
        "facts: {{velocity(A of rod): ['{} m/s', 0, 0], angular_velocity(rod): [0, 0, '{} rad/s']}}\n"
        "ask: {{N: normal_force(floor)}}\n",
        b, mu, v, w);
    if (pushes.empty()) {
      ++none;
      EXPECT_THROW(solved(text), StatementError) << text;
      continue;
    }
    several += pushes.size() > 1;
    const SolvedStatement found = solved(text);
    ASSERT_EQ(found.solutions.size(), pushes.size()) << text;
    for (std::size_t i = 0; i < pushes.size(); ++i)
      EXPECT_NEAR(number(found.solutions[i], 0), pushes[i], 1e-8 * (g + pushes[i])) << text;
  }
  EXPECT_GT(several, 2);
  EXPECT_GT(none, 2);
}

// The lower block is kept from turning: what its equations leave of a turning is rounding, and no tilting of its side.
TEST(FrictionStates, of_stacked_blocks_that_are_braked_together) {
  for (const double u : {0.5, 0.3}) {
    const double w = 0.4, m = 2, M = 5;
    const SolvedStatement found = solved(fmt::format(
        "points: {{C: [0, 0.5 m, 0], D: [0, 0, 0], T: [0, 0.25 m, 0]}}\nbodies:\n  top: {{particle: C, mass: "
        "2 kg}}\n  low: {{box: {{center: T, sides: [[1 m, 0, 0], [0, 0.5 m, 0], [0, 0, 0.5 m]]}}, mass: 5 "
        "kg}}\njoints: {{rail: {{planar: z, at: T, to: low, freedoms: {{turn: {{rate: 0, accel: 0}}}}}}}}\n"
        "contacts:\n  mid: {{of: top, against: low, at: C, normal: y, friction: {}}}\n"
        "  floor: {{of: low, at: D, normal: y, friction: 0.4}}\ngravity: -y\n"
        "facts: {{velocity(low): ['2 m/s', 0, 0], velocity(top): ['2 m/s', 0, 0]}}\n"
        "ask: {{a: acceleration(top).x, A: acceleration(low).x}}\n",
        u));
    ASSERT_EQ(found.solutions.size(), 1U);
    EXPECT_TRUE(found.warnings.empty()) << found.warnings.front();
    EXPECT_NEAR(number(found.solutions[0], 0), -std::min(u, w) * g, 1e-9 * g);
    EXPECT_NEAR(number(found.solutions[0], 1), u > w ? -w * g : (u * m - w * (m + M)) * g / M, 1e-9 * g);
  }
}

// A crate on two corners, pulled at the height h: by hand with the coefficients s at rest and k while it slides.
struct Planar {
  double a = 0, w = 0;
};
std::vector<Planar> crate_by_hand(double P, double h, double s, double k) {
  const double m = 50, c = 0.4, H = 1, W = m * g, I = m * (4 * c * c + 4 * H * H) / 12;
  if (P <= s * W && P * h <= W * c) return {{}};
  {
    const double w = (W * c - P * h) / (I + m * (c * c + H * H)), ax = -w * H, N = W - m * w * c;
    if (w < 0 && N >= 0 && std::abs(m * ax - P) <= s * N) return {{ax, w}};
  }
  std::vector<Planar> found;
  if (P > k * W && std::abs(P * (h - H) + k * W * H) <= W * c) found.push_back({(P - k * W) / m, 0});
  const double N = (W - m * c * P * (H - h) / I) / (1 + m * c * (c - k * H) / I);
  const double w = (N * (c - k * H) - P * (h - H)) / I, ax = (P - k * N) / m;
  if (w < 0 && N >= 0 && ax + w * H > 0) found.push_back({ax, w});
  return found;
}

TEST(FrictionStates, of_a_crate_that_is_harder_to_start_than_to_keep_going_are_as_by_hand) {
  std::mt19937 random(13);
  std::uniform_real_distribution<double> pull(20, 500), height(0.1, 1.9), coefficient(0.2, 0.9), part(0.3, 1);
  int between = 0;
  for (int trial = 0; trial < 60; ++trial) {
    const double P = std::round(pull(random)), h = std::round(100 * height(random)) / 100,
                 s = std::round(100 * coefficient(random)) / 100, k = std::round(100 * part(random) * s) / 100;
    const std::vector<Planar> right = crate_by_hand(P, h, s, k);
    between += P > k * 50 * g && P < s * 50 * g;
    const std::string text = fmt::format(
        "given: {{c: 0.4 m, h: {} m}}\npoints: {{A: [-c, 0, 0], B: [c, 0, 0], G: [0, 1 m, 0], K: [c, h, 0]}}\n"
        "bodies: {{crate: {{box: {{center: G, sides: [[2*c, 0, 0], [0, 2 m, 0], [0, 0, 1 m]]}}, mass: 50 kg}}}}\n"
        "contacts:\n  left: {{of: crate, at: A, normal: y, friction: {{static: {}, kinetic: {}}}}}\n"
        "  right: {{of: crate, at: B, normal: y, friction: {{static: {}, kinetic: {}}}}}\n"
        "loads: {{pull: {{force: ['{} N', 0, 0], at: K, body: crate}}}}\ngravity: -y\ninstants: {{now: rest}}\n"
        "ask: {{a: acceleration(crate).x, w: angular_acceleration(crate).z}}\n",
        h, s, k, s, k, P);
    ASSERT_FALSE(right.empty()) << text;
    const SolvedStatement found = solved(text);
    ASSERT_EQ(found.solutions.size(), right.size()) << text;
    for (std::size_t i = 0; i < right.size(); ++i) {
      EXPECT_NEAR(number(found.solutions[i], 0), right[i].a, 1e-8 * g) << text;
      EXPECT_NEAR(number(found.solutions[i], 1), right[i].w, 1e-8 * g) << text;
    }
  }
  EXPECT_GT(between, 5);
}

// Pulled at an angle: it rests while P cos t <= s (m g - P sin t), and slides beyond.
TEST(FrictionStates, in_letters_that_leave_rest_tell_the_limit_at_rest) {
  for (const char* friction : {"{static: 0.5, kinetic: 0.3}", "{static: s, kinetic: k}", "{static: 0.5, kinetic: k}"}) {
    const std::string own = std::string(friction).find("static: s") != std::string::npos    ? ", s: 1, k: 1"
                            : std::string(friction).find("kinetic: k") != std::string::npos ? ", k: 1"
                                                                                            : "";
    const SolvedStatement found =
        solved("letters: {m: kg, P: N" + own +
               "}\ngiven: {t: 30 deg}\npoints: {C: [0, 0, 0]}\n"
               "bodies: {block: {particle: C, mass: m}}\ncontacts: {floor: {of: block, at: C, normal: y, friction: " +
               friction +
               "}}\nloads: {pull: {force: [P*cos(t), P*sin(t), 0], at: C, body: block}}\ngravity: -y\n"
               "instants: {now: rest}\nask: {a: acceleration(block).x}\n");
    std::mt19937 random(14);
    std::uniform_real_distribution<double> pull(1, 60), unit(0.05, 1);
    const double c = std::cos(M_PI / 6);
    for (int trial = 0; trial < 60; ++trial) {
      const double m = 3, P = pull(random);
      const double s = own.find("s:") == std::string::npos ? 0.5 : unit(random),
                   k = own.empty() ? 0.3 : s * unit(random);
      const LetterValues letters{{"m", m}, {"P", P}, {"s", s}, {"k", k}};
      const double N = m * g - P / 2, a = P / 2 > m * g ? P * c / m : P * c <= s * N ? 0 : (P * c - k * N) / m;
      int told = 0;
      for (const Solution& solution : found.solutions) {
        if (!std::ranges::all_of(solution.grounds, [&](const FormulaCondition& ground) {
              return value_at(ground.positive, letters) > 0;
            }))
          continue;
        ++told;
        ASSERT_TRUE(solution.asks[0].formula) << friction << ": " << solution.asks[0].no_formula;
        EXPECT_NEAR(value_at(solution.asks[0].formula->number, letters), a, 1e-10 * g) << friction << " " << P;
      }
      EXPECT_EQ(told, 1) << friction << " P = " << P << ", s = " << s << ", k = " << k;
    }
  }
}

TEST(FrictionStates, that_letters_may_reach_are_said) {
  const SolvedStatement found = solved(
      "letters: {m: kg, b: rad, mu: 1}\npoints: {C: [0, 0, 0]}\n"
      "directions: {down: [cos(b), -sin(b), 0], out: [sin(b), cos(b), 0]}\n"
      "bodies: {block: {particle: C, mass: m}}\n"
      "contacts: {slope: {of: block, at: C, normal: out, friction: mu}}\ngravity: -y\n"
      "instants: {now: rest}\nask: {a: component(acceleration(block) along down)}\n");
  const auto said = [&](const char* words) {
    return std::ranges::any_of(found.warnings,
                               [&](const std::string& warning) { return warning.find(words) != std::string::npos; });
  };
  EXPECT_EQ(found.solutions.size(), 2U);
  EXPECT_TRUE(said("contact 'slope' begins to slide along -down"));
  EXPECT_TRUE(said("contact 'slope' parts"));
}

// The only share of the forces is that the wall carries nothing.
TEST(FrictionStates, of_a_roller_at_rest_in_a_corner_is_one) {
  for (const double mu : {0.1, 0.3, 0.9, 1.5}) {
    const SolvedStatement found = solved(
        fmt::format("given: {{r: 0.1 m, mu: {}}}\npoints: {{O: [r, r, 0], F: [r, 0, 0], W: [0, r, 0]}}\n"
                    "bodies: {{roller: {{cylinder: {{center: O, axis: z, radius: r, length: r}}, mass: 5 kg}}}}\n"
                    "contacts: {{floor: {{of: roller, at: F, normal: y, friction: mu}}, "
                    "wall: {{of: roller, at: W, normal: x, friction: mu}}}}\ngravity: -y\ninstants: {{now: rest}}\n"
                    "ask: {{a: norm(acceleration(roller)), w: norm(angular_acceleration(roller))}}\n",
                    mu));
    ASSERT_EQ(found.solutions.size(), 1U) << mu;
    EXPECT_NEAR(number(found.solutions[0], 0), 0, 1e-9) << mu;
    EXPECT_NEAR(number(found.solutions[0], 1), 0, 1e-9) << mu;
  }
}

// On a slope of which only the normal has a name, with the coefficient or the angle unknown.
TEST(FrictionStates, with_unknowns_slide_along_lines_that_the_normal_tells) {
  const auto slope = [](const char* data) {
    return solved(std::string(data) +
                  "points: {C: [0, 0, 0]}\ndirections: {out: [sin(b), cos(b), 0]}\n"
                  "bodies: {block: {particle: C, mass: 2 kg}}\n"
                  "contacts: {slope: {of: block, at: C, normal: out, friction: mu}}\ngravity: -y\n"
                  "instants: {now: {rest: true, norm(acceleration(block)): 2 m/s^2}}\nask: {u: u}\n");
  };
  const SolvedStatement rough = slope("given: {b: 30 deg, mu: u}\nfind: {u: 1}\nwhere: [0.01 < u < 1]\n");
  ASSERT_EQ(rough.solutions.size(), 1U);
  EXPECT_NEAR(number(rough.solutions[0], 0), std::tan(std::numbers::pi / 6) - 2 / (g * std::cos(std::numbers::pi / 6)),
              1e-9);
  const SolvedStatement steep = slope("given: {mu: 0.3, b: u}\nfind: {u: deg}\nwhere: [1 deg < u < 80 deg]\n");
  ASSERT_EQ(steep.solutions.size(), 1U);
  const double b = number(steep.solutions[0], 0);
  EXPECT_NEAR(g * (std::sin(b) - 0.3 * std::cos(b)), 2, 1e-8);
}

// In letters, too.
TEST(FrictionStates, of_a_slope_in_letters_need_no_named_line) {
  const SolvedStatement found = solved(
      "letters: {mu: 1}\ngiven: {b: 25 deg}\npoints: {C: [0, 0, 0]}\ndirections: {out: [sin(b), cos(b), 0]}\n"
      "bodies: {block: {particle: C, mass: 2 kg}}\n"
      "contacts: {slope: {of: block, at: C, normal: out, friction: mu}}\ngravity: -y\n"
      "instants: {now: rest}\nask: {a: norm(acceleration(block))}\n");
  ASSERT_EQ(found.solutions.size(), 2U);
  ASSERT_TRUE(found.solutions[1].asks[0].formula);
  const double b = 25 * std::numbers::pi / 180;
  EXPECT_NEAR(value_at(found.solutions[1].asks[0].formula->number, {{"mu", 0.2}}),
              g * (std::sin(b) - 0.2 * std::cos(b)), 1e-9);
}

// A claim about what a contact does is decided where the contact is in that state.
TEST(FrictionStates, claims_of_words_are_held_in_their_states_alone) {
  const SolvedStatement found = solved(
      "letters: {m: kg, b: rad, mu: 1}\npoints: {C: [0, 0, 0]}\n"
      "directions: {down: [cos(b), -sin(b), 0], out: [sin(b), cos(b), 0]}\nassume: [0 < b < 90 deg]\n"
      "bodies: {block: {particle: C, mass: m}}\n"
      "contacts: {slope: {of: block, at: C, normal: out, friction: mu}}\ngravity: -y\ninstants: {now: rest}\n"
      "claim: {holds: {claim: sticking(slope), assume: [mu > tan(b)]}, "
      "slides: {claim: sliding(slope), assume: [mu < tan(b)]}}\n");
  ASSERT_EQ(found.solutions.size(), 2U);
  for (const std::size_t own : {0U, 1U}) {
    EXPECT_TRUE(found.solutions[own].claims[own].holds) << own;
    // No letters fulfil what is assumed in the other state.
    EXPECT_EQ(found.solutions[own].claims[1 - own].state, AskState::undetermined) << own;
  }
}

// Three that lie on each other, of which the lowest is driven: the middle one begins to slide on it, and the upper one
// on that where its friction is less than it needs, whatever way all of them move.
TEST(FrictionStates, of_three_on_each_other_do_not_depend_on_how_all_of_them_move) {
  constexpr double F = 17.65, Q = 9.8;
  for (const double v : {-2.0, 0.0, 2.0})
    for (const double mu : {0.3, 0.19}) {
      Statement statement = read_statement(
          fmt::format(
              "plane: [x, y]\ngiven: {{v: {} m/s, F: {} N, Q: {} N, mu: {}}}\npoints: {{C: [0, 0]}}\nbodies:\n"
              "  a: {{box: {{center: [0, -0.3 m, 0], sides: [100 m * x, 0.2 m * y, 1 m * z]}}, mass: 1 kg}}\n"
              "  b: {{box: {{center: [0, -0.1 m, 0], sides: [100 m * x, 0.2 m * y, 1 m * z]}}, mass: 2 kg}}\n"
              "  c: {{particle: C, mass: 3 kg}}\njoints:\n  low: {{prismatic: x, at: C, to: a, rate: v, force: F}}\n"
              "  mid: {{prismatic: x, at: C, from: a, to: b, rate: 0, friction: Q}}\n"
              "contacts: {{top: {{of: c, against: b, at: C, normal: y, friction: mu}}}}\ngravity: -y\n"
              "instants: {{start: {{velocity(c): [v, 0]}}}}\n"
              "ask: {{a: acceleration(a).x, b: acceleration(b).x, c: acceleration(c).x}}\n",
              v, F, Q, mu),
          "test.yaml");
      restrict_to_plane(statement);
      const SolvedStatement found = solve_statement(statement, {});
      ASSERT_EQ(found.solutions.size(), 1U) << v << " " << mu;
      const double together = Q / 5, most = mu * g, upper = std::min(together, most);
      EXPECT_NEAR(number(found.solutions[0], 0), F - Q, 1e-9) << v << " " << mu;
      EXPECT_NEAR(number(found.solutions[0], 1), (Q - 3 * upper) / 2, 1e-9) << v << " " << mu;
      EXPECT_NEAR(number(found.solutions[0], 2), upper, 1e-9) << v << " " << mu;
    }
}

// Pulled harder than its floor holds, whatever the letters, a block slides: nothing is told of its rest.
TEST(FrictionStates, that_assumptions_about_letters_exclude_are_none) {
  const std::string text =
      "letters: {m: kg, P: N, mu: 1}\nassume: [P > 2*mu*m*g, mu < 1]\npoints: {C: [0, 0, 0]}\n"
      "bodies: {block: {particle: C, mass: m}}\ncontacts: {floor: {of: block, at: C, normal: y, friction: mu}}\n"
      "loads: {pull: {force: [P, 0, 0], at: C, body: block}}\ngravity: -y\ninstants: {now: rest}\n"
      "ask: {a: acceleration(block).x}\n";
  const SolvedStatement found = solved(text);
  ASSERT_EQ(found.solutions.size(), 1U);
  ASSERT_TRUE(found.solutions[0].asks[0].formula) << found.solutions[0].asks[0].no_formula;
  EXPECT_NEAR(value_at(found.solutions[0].asks[0].formula->number, {{"m", 2}, {"P", 40}, {"mu", 0.3}}), 20 - 0.3 * g,
              1e-9);
}

// A block on a rough table, hit by a bullet that stays. Struck along the table the contact has no impulse, and so no
// friction; struck from above it has, which numbers tell.
std::string block_hit(const std::string& head, const std::string& blow) {
  return head +
         "plane: [x, y]\npoints: {C: [0, 0]}\nbodies: {block: {particle: C, mass: M}}\n"
         "contacts: {table: {of: block, at: C, normal: y, friction: mu}}\n" +
         blow +
         "gravity: -y\ninstants: {before: rest}\nask: {u: velocity(block).x @ after, far: max(center(block).x)}\n";
}

TEST(FrictionStates, that_a_blow_does_not_touch_are_told_in_letters) {
  const std::string letters = "letters: {m: kg, M: kg, v: m/s, mu: 1}\n";
  Statement statement = read_statement(
      block_hit(letters, "strikes: {bullet: {hits: block, at: C, mass: m, velocity: [v, 0], stays: true}}\n"),
      "test.yaml");
  restrict_to_plane(statement);
  const SolvedStatement found = solve_statement(statement, {});
  ASSERT_EQ(found.solutions.size(), 1U);
  EXPECT_TRUE(found.warnings.empty());
  const auto& asks = found.solutions[0].asks;
  ASSERT_TRUE(asks[0].formula && asks[1].formula) << asks[0].no_formula << asks[1].no_formula;
  std::mt19937 random(31);
  std::uniform_real_distribution<double> draw(0.5, 2);
  for (int trial = 0; trial < 10; ++trial) {
    const double m = draw(random), M = draw(random), v = draw(random), mu = draw(random), u = m * v / (M + m);
    const LetterValues at{{"m", m}, {"M", M}, {"v", v}, {"mu", mu}};
    EXPECT_NEAR(value_at(asks[0].formula->number, at), u, 1e-12);
    EXPECT_NEAR(value_at(asks[1].formula->number, at), u * u / (2 * mu * g), 1e-9);
  }
}

TEST(FrictionStates, that_a_blow_touches_are_left_to_numbers) {
  for (const std::string along : {"[1, -1]", "[1, 1]"}) {
    Statement statement =
        read_statement(block_hit("letters: {M: kg, S: N*s, mu: 1}\n",
                                 "impulses: {blow: {value: S, along: " + along + ", at: C, body: block}}\n"),
                       "test.yaml");
    restrict_to_plane(statement);
    try {
      solve_statement(statement, {});
      ADD_FAILURE() << along;
    } catch (const StatementError& error) {
      EXPECT_EQ(error.diagnostics().front().message,
                "the blow presses or lifts contacts with friction: that is solved for numbers, and 'M' has no value");
    }
  }
}

}  // namespace friction_states_test
}  // namespace poinsot::problem
