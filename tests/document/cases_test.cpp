// Many cases of a problem at once against solving each by itself.
#include "poinsot/cases.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <random>

#include "poinsot/problem.h"

namespace poinsot {
namespace cases_test {

// The answers of a document with one solution, number by number; nothing if one is missing.
std::vector<double> numbers_of(const Document& document) {
  std::vector<double> numbers;
  if (document.solutions.size() != 1) return {};
  for (const Answer& answer : document.solutions.front().answers) {
    if (answer.claim) continue;
    if (answer.state != AnswerState::found) return {};
    if (const auto* number = std::get_if<double>(&answer.si.content)) {
      numbers.push_back(*number);
    } else if (const auto* list = std::get_if<std::vector<Datum>>(&answer.si.content)) {
      for (const Datum& item : *list) numbers.push_back(std::get<double>(item.content));
    } else {
      return {};
    }
  }
  return numbers;
}

struct Compared {
  std::size_t rows = 0, by_formula = 0, by_instant = 0, unanswered = 0;
};

// Compares rows near the data of a file with solving them one by one.
void compare(const std::string& path, bool formulas, std::mt19937_64& random, Compared& compared) {
  const Problem problem = Problem::from_file(path);
  if (problem.situations().size() != 1) return;
  CaseQuestions questions;
  questions.formulas = formulas;
  std::vector<std::vector<double>> columns;
  std::uniform_real_distribution<double> part(0.97, 1.03);
  constexpr std::size_t rows = 3, most_data = 3;
  for (const StatedDatum& datum : problem.situations().front().data) {
    if (datum.unit.empty() || questions.over.size() == most_data) continue;
    const double value = problem.value_in_si(datum.name, datum.text);
    questions.over.push_back(datum.name);
    columns.emplace_back();
    for (std::size_t row = 0; row < rows; ++row) columns.back().push_back(value * part(random));
    questions.first.push_back(columns.back().front());
  }
  if (columns.empty()) return;
  try {
    const Cases cases = problem.cases(questions);
    // The first of these cases is not the first of a thousand, which would be checked in full anyway.
    const CaseRows found = cases.solve({columns.begin(), columns.end()}, 1);
    EXPECT_EQ(found.checked, 0U);
    const std::vector<CaseColumn> over = cases.over();
    for (std::size_t row = 0; row < rows; ++row) {
      Settings sets;
      for (std::size_t k = 0; k < columns.size(); ++k)
        sets.emplace_back(over[k].name, fmt::format("{} {}", columns[k][row], over[k].unit));
      std::vector<double> expected;
      try {
        expected = numbers_of(problem.solve(sets));
      } catch (const StatementError&) {
        // As where data contradict each other once they differ.
      }
      const bool missing = std::ranges::any_of(found.reasons, [&](const auto& one) { return one.first == row; });
      ++compared.rows;
      compared.by_formula += static_cast<std::size_t>(found.roads[row] == CaseRoad::by_formula);
      compared.by_instant += static_cast<std::size_t>(found.roads[row] == CaseRoad::by_instant);
      if (expected.empty()) {
        EXPECT_TRUE(missing) << path;
        ++compared.unanswered;
        continue;
      }
      EXPECT_FALSE(missing) << path;
      ASSERT_EQ(found.columns.size(), expected.size()) << path;
      const double size = std::abs(*std::ranges::max_element(expected, {}, [](double x) { return std::abs(x); }));
      // The couple on the precessing earth is what is left of terms ten million times larger: numbers know it to eight
      // digits, where its formula knows all.
      const double same = path.ends_with("18.117.yaml") ? 2e-8 : 1e-9;
      for (std::size_t k = 0; k < expected.size(); ++k)
        EXPECT_NEAR(found.columns[k][row], expected[k], same * std::max(std::abs(expected[k]), 1e-3 * size))
            << path << " " << cases.columns()[k].name;
    }
  } catch (const StatementError&) {
    // Questions for tables, names or truth values have no columns.
  }
}

TEST(Cases, RowsAreWhatSolvingGives) {
  std::vector<std::string> paths;
  for (const auto& entry : std::filesystem::directory_iterator(POINSOT_SOURCE_DIR "/examples/textbook"))
    paths.push_back(entry.path().string());
  std::ranges::sort(paths);
  std::mt19937_64 random(6);
  Compared with_formulas, without;
  for (std::size_t i = 0; i < paths.size(); i += 9) compare(paths[i], true, random, with_formulas);
  for (std::size_t i = 0; i < paths.size(); i += 4) compare(paths[i], false, random, without);
  EXPECT_GT(with_formulas.by_formula, 12U);
  EXPECT_GT(without.by_instant, 5U);
  EXPECT_EQ(without.by_formula, 0U);
  EXPECT_GT(without.rows - without.unanswered, without.rows / 2);
}

// The tension at the top has a formula that holds while the cord is taut: beyond that rows are solved one by one.
TEST(Cases, BeyondTheConditionsOfAFormula) {
  const Problem problem = Problem::from_text(
      "title: Ball on a cord at the top of its circle\ngiven: {m: 2 kg, L: 1.2 m, v: 5 m/s}\n"
      "points: {O: [0, 0, 0], P: [0, L, 0]}\nbodies: {ball: {particle: P, mass: m}}\n"
      "cords: {c: {from: ground, at: O, to: ball, end: P}}\ngravity: -y\n"
      "instants: {top: {velocity(ball): [v, 0, 0]}}\nask: {S: tension(c)}\n",
      "cord.yaml");
  const Cases cases = problem.cases({.over = {"v"}, .asks = {"S"}, .sets = {{"L", "1 m"}}});
  EXPECT_EQ(cases.no_formulas(), "");
  const std::vector<double> speeds{2, 3, 3.2, 8};
  const CaseRows found = cases.solve({speeds}, 0);
  constexpr CaseRoad formula = CaseRoad::by_formula, full = CaseRoad::in_full;
  EXPECT_EQ(found.roads, (std::vector<CaseRoad>{full, full, formula, formula}));
  ASSERT_EQ(found.reasons.size(), 2U);
  for (const std::size_t row : {2U, 3U})
    EXPECT_NEAR(found.columns[0][row], 2 * (speeds[row] * speeds[row] - 9.80665), 1e-12);
  for (const std::size_t row : {0U, 1U}) EXPECT_TRUE(std::isnan(found.columns[0][row]));
}

std::vector<double> drawn(double low, double high, std::size_t rows, std::mt19937_64& random) {
  std::vector<double> numbers(rows);
  for (double& number : numbers) number = std::uniform_real_distribution<double>(low, high)(random);
  return numbers;
}

// The conical pendulum: with the spring at its joint cos(b) has no closed form.
constexpr const char* governor =
    "title: Rod on a turning shaft, held by a spring\n"
    "given: {m: 2 kg, L: 0.6 m, k: 3 N*m/rad, n: 90 rpm}\nfind: {b: deg}\nwhere: [5 deg < b < 85 deg]\n"
    "gravity: -y\npoints: {A: [0, 0, 0], G: \"L/2*[sin(b), -cos(b), 0]\", B: \"L*[sin(b), -cos(b), 0]\"}\n"
    "frames: {shaft: {origin: A, turns: y, rate: n}}\n"
    "bodies: {rod: {rod: [A, B], mass: m}}\n"
    "joints: {hinge: {revolute: z, at: A, from: shaft, to: rod, rate: 0, accel: 0}}\n"
    "loads: {spring: {body: rod, couple: [0, 0, -k*b]}}\n"
    "facts: {\"couple(hinge on rod about A).z\": 0 N*m}\n"
    "ask: {angle: b, S: \"force(hinge on rod)\"}\n";

// An unknown is found in each row by itself: alone, among others, and in another order it has the same bits; and what
// solving in full finds. Where it leaves its range the row says what solving in full says.
TEST(Cases, AnUnknownIsFoundInEachRow) {
  const Problem problem = Problem::from_text(governor, "governor.yaml");
  const Cases cases = problem.cases({.over = {"n", "k", "m"}, .asks = {}, .first = {9.4, 3.0, 2.0}});
  EXPECT_NE(cases.no_formulas(), "");
  EXPECT_EQ(cases.no_program(), "");
  EXPECT_TRUE(cases.by_instants());
  std::mt19937_64 random(7);
  constexpr std::size_t rows = 700;
  const std::vector<std::vector<double>> data{drawn(8, 11, rows, random), drawn(1, 4, rows, random),
                                              drawn(1.5, 2.5, rows, random)};
  const CaseRows found = cases.solve({data.begin(), data.end()}, 1);
  std::size_t by_instant = 0, compared = 0;
  for (std::size_t row = 0; row < rows; ++row) {
    by_instant += static_cast<std::size_t>(found.roads[row] == CaseRoad::by_instant);
    if (row % 23 != 0) continue;
    std::vector<std::vector<double>> one;
    for (const std::vector<double>& column : data) one.push_back({column[row]});
    const CaseRows alone = cases.solve({one.begin(), one.end()}, 1);
    std::vector<double> expected;
    try {
      expected = numbers_of(problem.solve({{"n", fmt::format("{} rad/s", data[0][row])},
                                           {"k", fmt::format("{} N*m/rad", data[1][row])},
                                           {"m", fmt::format("{} kg", data[2][row])}}));
    } catch (const StatementError&) {
    }
    EXPECT_EQ(expected.empty(), std::isnan(found.columns[0][row])) << row;
    for (std::size_t k = 0; k < expected.size(); ++k, ++compared) {
      EXPECT_EQ(found.columns[k][row], alone.columns[k][0]);
      EXPECT_NEAR(found.columns[k][row], expected[k], 1e-9 * (1 + std::abs(expected[k]))) << row;
    }
  }
  EXPECT_GT(by_instant, rows / 2);
  EXPECT_GT(compared, 50U);
}

// m g L/2 sin(b) = M has a second root below 120 deg where b is beyond 60 deg: Newton's method from the first case
// cannot see it, the row in a thousand that is solved in full does.
TEST(Cases, ASecondRootRefutesAProgram) {
  const Problem problem = Problem::from_text(
      "title: A bar that a couple holds up\ngiven: {m: 2 kg, L: 1 m, M: 4 N*m}\nfind: {b: deg}\n"
      "where: [1 deg < b < 120 deg]\npoints: {O: [0, 0, 0], P: \"[L*sin(b), -L*cos(b), 0]\"}\n"
      "bodies: {bar: {rod: [O, P], mass: m}}\njoints: {pin: {revolute: z, at: O, to: bar}}\n"
      "loads: {motor: {body: bar, couple: [0, 0, M]}}\ngravity: -y\n"
      "instants: {now: {angular_velocity(bar): 0, angular_acceleration(bar): 0}}\nask: {angle: b, R: "
      "reaction(pin).y}\n",
      "bar.yaml");
  const Cases cases = problem.cases({.over = {"M"}, .asks = {}, .first = {4.0}, .formulas = false});
  ASSERT_EQ(cases.no_program(), "");
  const double weight = 2 * 9.80665;
  const std::vector<double> few{4, 6, 8}, many{9.2, 9.3, 4};
  const CaseRows alone = cases.solve({few}, 3000);
  EXPECT_EQ(alone.checked, 1U);
  EXPECT_EQ(alone.refuted, 0U);
  for (std::size_t row = 0; row < few.size(); ++row) {
    EXPECT_EQ(alone.roads[row], CaseRoad::by_instant);
    EXPECT_NEAR(alone.columns[0][row], std::asin(2 * few[row] / weight), 1e-12);
    EXPECT_NEAR(alone.columns[1][row], weight, 1e-10);
  }
  // Between the rows that are solved in full nobody looks.
  EXPECT_EQ(cases.solve({many}, 1).roads[0], CaseRoad::by_instant);
  const CaseRows both = cases.solve({many}, 3000);
  EXPECT_EQ(both.checked, 1U);
  EXPECT_EQ(both.refuted, 1U);
  ASSERT_EQ(both.reasons.size(), 2U);
  for (const auto& [row, reason] : both.reasons) EXPECT_EQ(reason, "there are 2 solutions") << row;
  for (std::size_t row = 0; row < many.size(); ++row) EXPECT_EQ(both.roads[row], CaseRoad::in_full);
  EXPECT_NEAR(both.columns[0][2], std::asin(2 * 4 / weight), 1e-9);
  // What is wrong in a row is said without a place in the file, which is right for others.
  const std::vector<double> heavy{4, 12};
  const CaseRows none = cases.solve({heavy}, 1);
  ASSERT_EQ(none.reasons.size(), 1U);
  EXPECT_EQ(none.reasons.front().first, 1U);
  EXPECT_TRUE(none.reasons.front().second.starts_with("no values of b in their ranges satisfy all conditions"))
      << none.reasons.front().second;
  EXPECT_EQ(none.reasons.front().second.find("bar.yaml"), std::string::npos);
}

// Where data make the pivots of the first case vanish, where a contact would pull, and where numbers are none, a row
// goes another road and says why it has no answer.
TEST(Cases, RowsForWhichTheProgramDoesNotHold) {
  const Problem problem = Problem::from_text(
      "title: Crate on two feet, pulled\ngiven: {m: 20 kg, a: 0.4 m, h: 0.5 m, P: 30 N}\n"
      "points: {A: [-a, 0, 0], B: [a, 0, 0], G: [0, 0.3 m, 0], C: [a, h, 0]}\n"
      "bodies: {crate: {box: {corners: [[-a, 0, -0.2 m], [a, 0.6 m, 0.2 m]]}, mass: m}}\n"
      "joints: {floor: {planar: z, at: G, to: crate}}\n"
      "contacts: {left: {of: crate, at: A, normal: y}, right: {of: crate, at: B, normal: y}}\n"
      "loads: {pull: {body: crate, at: C, force: [P, 0, 0]}}\ngravity: -y\ninstants: {now: rest}\n"
      "ask: {N: \"force(left on crate).y\", a: \"acceleration(G of crate).x\"}\n",
      "crate.yaml");
  const Cases cases = problem.cases({.over = {"P", "a"}, .asks = {}, .first = {30.0, 0.4}, .formulas = false});
  ASSERT_EQ(cases.no_program(), "");
  const double none = std::nan("");
  const std::vector<double> pulls{30, 60, 900, none, 30}, halves{0.4, 0.3, 0.4, 0.4, 0};
  const CaseRows found = cases.solve({pulls, halves}, 1);
  EXPECT_EQ(found.roads[0], CaseRoad::by_instant);
  EXPECT_EQ(found.roads[1], CaseRoad::by_instant);
  for (const std::size_t row : {0U, 1U}) {
    const double moment = pulls[row] * (0.5 - 0.3) / (2 * halves[row]);
    EXPECT_NEAR(found.columns[0][row], 20 * 9.80665 / 2 - moment, 1e-10);
    EXPECT_NEAR(found.columns[1][row], pulls[row] / 20, 1e-13);
  }
  ASSERT_EQ(found.reasons.size(), 3U);
  for (const std::size_t row : {2U, 3U, 4U}) {
    EXPECT_EQ(found.roads[row], CaseRoad::in_full);
    EXPECT_TRUE(std::isnan(found.columns[0][row]));
  }
}

// What is true or false has no column; what is refused in the first case has its form all the same.
TEST(Cases, AnswersWithoutNumbersInTheFirstCase) {
  const Problem problem = Problem::from_text(
      "title: Ball on a cord at the top of its circle\ngiven: {m: 2 kg, L: 1.2 m, v: 5 m/s}\n"
      "points: {O: [0, 0, 0], P: [0, L, 0]}\nbodies: {ball: {particle: P, mass: m}}\n"
      "cords: {c: {from: ground, at: O, to: ball, end: P}}\ngravity: -y\n"
      "instants: {top: {velocity(ball): [v, 0, 0]}}\nask: {S: tension(c), taut: taut(c), v: velocity(ball).x}\n",
      "cord.yaml");
  for (const bool formulas : {true, false}) {
    try {
      problem.cases({.over = {"m"}, .asks = {}, .first = {2.0}, .formulas = formulas});
      ADD_FAILURE();
    } catch (const StatementError& error) {
      EXPECT_NE(std::string(error.what()).find("'taut' is no number"), std::string::npos) << error.what();
    }
    // Slack in the first case.
    const Cases cases = problem.cases({.over = {"v"}, .asks = {"S", "v"}, .first = {1.0}, .formulas = formulas});
    const std::vector<double> speeds{1, 5};
    const CaseRows found = cases.solve({speeds}, 1);
    EXPECT_TRUE(std::isnan(found.columns[0][0]));
    EXPECT_NEAR(found.columns[0][1], 2 * (25 / 1.2 - 9.80665), 1e-9);
    EXPECT_EQ(found.columns[1], speeds);
    ASSERT_EQ(found.reasons.size(), 1U);
  }
}

// Formulas and programs have numbers for a ball that rebounds faster than it came, and for moments of inertia that no
// body has: solving refuses them, and a row says so in its words.
TEST(Cases, MachinesThatCannotExistHaveNoRows) {
  const Problem ball = Problem::from_text(
      "given: {m: 1 kg, u: 4 m/s, e: 0.5}\npoints: {C: [0, 0, 0]}\nbodies: {ball: {particle: C, mass: m}}\n"
      "impacts: {floor: {of: ball, at: C, pushes: y, restitution: e}}\ngravity: none\n"
      "instants: {before: {velocity(ball): [0, -u, 0]}}\nask: {v: velocity(ball).y}\n",
      "ball.yaml");
  const Problem body = Problem::from_text(
      "given: {I: 1 kg*m^2, J: 1.5 kg*m^2, K: 2 kg*m^2, w: 3 rad/s}\npoints: {G: [0, 0, 0]}\n"
      "bodies: {b: {mass: 1 kg, center: G, inertia: {about: G, x: I, y: J, z: K}}}\njoints: {j: {ball: G, to: b}}\n"
      "gravity: none\ninstants: {now: {angular_velocity(b): [w, w, w]}}\nask: {a: angular_acceleration(b).x}\n",
      "body.yaml");
  for (const bool formulas : {true, false}) {
    const Cases bounces = ball.cases({.over = {"e", "u"}, .asks = {}, .first = {0.5, 4}, .formulas = formulas});
    EXPECT_EQ(bounces.has_formulas(), formulas);
    const std::vector<double> restitutions{0.5, 1.2, 0.7, 1}, speeds{4, 3, 2, 1};
    const CaseRows rows = bounces.solve({restitutions, speeds}, 1);
    const CaseRoad road = formulas ? CaseRoad::by_formula : CaseRoad::by_instant;
    EXPECT_EQ(rows.roads, (std::vector<CaseRoad>{road, CaseRoad::in_full, road, road}));
    ASSERT_EQ(rows.reasons.size(), 1U);
    EXPECT_EQ(rows.reasons.front().first, 1U);
    EXPECT_NE(rows.reasons.front().second.find("restitution lies between 0 and 1"), std::string::npos);
    EXPECT_TRUE(std::isnan(rows.columns[0][1]));
    for (const std::size_t row : {0U, 2U, 3U})
      EXPECT_NEAR(rows.columns[0][row], restitutions[row] * speeds[row], 1e-14);

    // At random: where I, J and K are the sides of a triangle there is an answer, (J - K) w^2/I, and else a reason.
    const Cases turns = body.cases({.over = {"I", "J", "K"}, .asks = {}, .first = {1, 1.5, 2}, .formulas = formulas});
    std::mt19937_64 random(8);
    constexpr std::size_t count = 400;
    const std::vector<std::vector<double>> sides{drawn(0.5, 2, count, random), drawn(0.5, 2, count, random),
                                                 drawn(0.5, 2, count, random)};
    const CaseRows found = turns.solve({sides.begin(), sides.end()}, 1);
    std::size_t possible = 0;
    for (std::size_t row = 0; row < count; ++row) {
      const double I = sides[0][row], J = sides[1][row], K = sides[2][row];
      const bool triangle = I + J >= K && J + K >= I && K + I >= J;
      possible += static_cast<std::size_t>(triangle);
      EXPECT_EQ(std::isnan(found.columns[0][row]), !triangle) << row;
      EXPECT_EQ(found.roads[row] == CaseRoad::in_full, !triangle) << row;
      if (triangle) {
        EXPECT_NEAR(found.columns[0][row], (J - K) * 9 / I, 1e-12) << row;
      }
    }
    EXPECT_GT(possible, count / 2);
    EXPECT_EQ(found.reasons.size(), count - possible);
    EXPECT_GT(found.reasons.size(), 20U);
  }
}

// sqrt(2 h/g) (1 + e)/(1 - e) is found in letters by trials, with numbers of some digits and for e < 1: rows are
// followed.
TEST(Cases, LawsThatWereTriedAreNoFormulasOfRows) {
  const Problem problem =
      Problem::from_file(POINSOT_SOURCE_DIR "/examples/mechanisms/ball-that-bounces-in-letters.yaml");
  const Cases cases = problem.cases({.over = {"e"}, .asks = {}, .sets = {{"m", "1 kg"}, {"h", "1 m"}}, .first = {0.5}});
  EXPECT_NE(cases.no_formulas().find("by trials"), std::string::npos) << cases.no_formulas();
  const std::vector<double> restitutions{0.5, 1.2};
  const CaseRows rows = cases.solve({restitutions}, 1);
  EXPECT_NEAR(rows.columns[0][0], std::sqrt(2 / 9.80665) * 3, 1e-9);
  ASSERT_EQ(rows.reasons.size(), 1U);
  EXPECT_NE(rows.reasons.front().second.find("restitution lies between 0 and 1"), std::string::npos);
}

TEST(Cases, WrongNamesAndColumns) {
  const Problem problem = Problem::from_file(POINSOT_SOURCE_DIR "/examples/textbook/18.005.yaml");
  EXPECT_THROW(problem.cases({.over = {"nobody"}, .asks = {}}), StatementError);
  EXPECT_THROW(problem.value_in_si("nobody", "1 m"), StatementError);
  const std::string name = problem.situations().front().data.front().name;
  EXPECT_THROW(problem.cases({.over = {name}, .asks = {"nothing"}}), StatementError);
  // Without formulas the first case shows what the answers are.
  EXPECT_THROW(problem.cases({.over = {name}, .asks = {}, .first = {}, .formulas = false}), std::invalid_argument);
  const Cases cases = problem.cases({.over = {name}, .asks = {}, .first = {1.0}});
  EXPECT_THROW(cases.solve({}, 0), std::invalid_argument);
}

TEST(Cases, ABudgetEndsThem) {
  const Problem problem = Problem::from_file(POINSOT_SOURCE_DIR "/examples/textbook/18.005.yaml");
  const std::string name = problem.situations().front().data.front().name;
  EXPECT_THROW(problem.cases({.over = {name}, .asks = {}, .first = {1.0}}, Budget().end_after(std::chrono::seconds(0))),
               BudgetEnded);
}

}  // namespace cases_test
}  // namespace poinsot
