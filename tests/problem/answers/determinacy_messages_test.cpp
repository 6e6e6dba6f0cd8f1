// Textbook problems with too little, too much and contradictory information: what is open is named, a redundant truth
// changes nothing, and a falsehood is met with the facts that clash, in words of the file and with their place.
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "poinsot/engine/work/work.h"
#include "problem/entries/random_problems.h"
#include "problem/formulas/textbook_variations.h"

namespace poinsot::problem {
namespace determinacy_messages_test {

using namespace testing;

// The file as it stands, without the answers it expects.
std::string text_of(const std::string& name) {
  std::ifstream file(std::string(POINSOT_SOURCE_DIR) + "/examples/textbook/" + name + ".yaml");
  std::stringstream text;
  text << file.rdbuf();
  return text.str().substr(0, text.str().find("\nexpect:") + 1);
}

// Each edit applies to exactly one place.
std::string edited(std::string text, const Edits& edits) {
  for (const auto& [old_text, new_text] : edits) {
    const std::size_t at = text.find(old_text);
    if (at == std::string::npos || text.find(old_text, at + 1) != std::string::npos)
      throw std::logic_error("not at exactly one place: " + old_text);
    text.replace(at, old_text.size(), new_text);
  }
  return text;
}

SolvedStatement solve(const std::string& text, const Item& item) {
  return solve_statement(read_statement(text, std::string(item.file) + ".yaml"), item.sets);
}

// Line and column at which some text first stands.
std::string place_of(const std::string& text, const std::string& words) {
  const std::size_t at = text.find(words);
  const auto line = 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n');
  const std::size_t begin = at == 0 ? 0 : text.rfind('\n', at - 1) + 1;
  return std::to_string(line) + ":" + std::to_string(at - begin + 1);
}

// Everything that is said of answers that are not given, and where there is no solution.
std::string complaints(const SolvedStatement& solved) {
  std::string all;
  if (solved.solutions.empty())
    for (const std::string& warning : solved.warnings) all += warning + "\n";
  for (const Solution& solution : solved.solutions)
    for (const SolvedAsk& ask : solution.asks)
      if (ask.state == AskState::undetermined) all += ask.reason + "\n";
  return all;
}

void expect_words(const std::string& message, const Words& words) {
  for (const std::string& word : words) EXPECT_NE(message.find(word), std::string::npos) << word << "\nin: " << message;
}

void expect_close(const Value<double>& a, const Value<double>& b) {
  ASSERT_EQ(a.kind, b.kind);
  const double size = std::max(size_of(a), size_of(b));
  EXPECT_LE(std::abs(a.number - b.number), 1e-8 * size);
  EXPECT_LE(norm(a.vector - b.vector), 1e-8 * size);
  EXPECT_EQ(a.text, b.text);
  ASSERT_EQ(a.items.size(), b.items.size());
  for (std::size_t i = 0; i < a.items.size(); ++i) expect_close(a.items[i], b.items[i]);
}

class DeterminacyMessages : public ::testing::TestWithParam<Item> {};

TEST_P(DeterminacyMessages, TooLittleNamesWhatIsOpen) {
  const Item& item = GetParam();
  std::string said;
  try {
    said = complaints(solve(edited(text_of(item.file), item.under), item));
  } catch (const StatementError& error) {
    said = error.what();
  }
  expect_words(said, item.open);
}

TEST_P(DeterminacyMessages, ARedundantTruthChangesNothing) {
  const Item& item = GetParam();
  const SolvedStatement plain = solve(text_of(item.file), item);
  const SolvedStatement more = solve(edited(text_of(item.file), item.redundant), item);
  ASSERT_GE(plain.solutions.size(), 1U);
  ASSERT_EQ(plain.solutions.size(), more.solutions.size());
  for (std::size_t i = 0; i < plain.solutions.size(); ++i)
    for (std::size_t k = 0; k < plain.solutions[i].asks.size(); ++k) {
      const SolvedAsk &a = plain.solutions[i].asks[k], &b = more.solutions[i].asks[k];
      ASSERT_EQ(a.state, AskState::found) << a.reason;
      ASSERT_EQ(b.state, AskState::found) << b.reason;
      expect_close(a.value, b.value);
    }
}

TEST_P(DeterminacyMessages, AContradictionNamesWhatClashes) {
  const Item& item = GetParam();
  const std::string text = edited(text_of(item.file), item.contradictory);
  if (!item.place) {
    // No values of the unknowns satisfy the conditions; these are named.
    const SolvedStatement solved = solve(text, item);
    EXPECT_TRUE(solved.solutions.empty());
    std::string said;
    for (const std::string& warning : solved.warnings) said += warning + "\n";
    expect_words(said, item.clash);
    return;
  }
  try {
    solve(text, item);
    ADD_FAILURE() << "no contradiction";
  } catch (const StatementError& error) {
    const std::string said = error.what();
    EXPECT_EQ(said.rfind(std::string(item.file) + ".yaml:" + place_of(text, item.place) + ": error: ", 0), 0U)
        << said << "\nexpected at " << place_of(text, item.place);
    expect_words(said, item.clash);
  }
}

std::string name_of(const ::testing::TestParamInfo<Item>& info) {
  std::string name = info.param.file;
  std::replace(name.begin(), name.end(), '.', '_');
  return "Problem" + name;
}
INSTANTIATE_TEST_SUITE_P(Motions, DeterminacyMessages, ::testing::ValuesIn(motions()), name_of);
INSTANTIATE_TEST_SUITE_P(Blows, DeterminacyMessages, ::testing::ValuesIn(blows()), name_of);
INSTANTIATE_TEST_SUITE_P(Finds, DeterminacyMessages, ::testing::ValuesIn(finds()), name_of);

// What is given as `any` is varied wherever it stands.
TEST(Determinacy, AnyWhereverItStands) {
  for (const char* body :
       {"{rod: [O, A], mass: any}", "{parts: {one: {rod: [O, A], mass: any}, two: {particle: A, mass: 1 kg}}}",
        "{parts: {one: {rod: [O, A], weight: any}, two: {particle: A, mass: 1 kg}}}",
        "{parts: {one: {rod: [O, A], density: any}, two: {particle: A, mass: 1 kg}}}",
        "{parts: {one: {rod: [O, A], specific_weight: any}, two: {particle: A, mass: 1 kg}}}",
        "{rod: [O, A], specific_weight: any}", "{rod: [O, A], mass: 1 kg, added: {tip: {particle: A, mass: any}}}",
        "{mass: 2 kg, center: [any, 0, 0], inertia: {x: 1 kg*m^2, y: 2 kg*m^2, z: 2 kg*m^2}}",
        "{mass: 2 kg, center: A, inertia: {x: 1 kg*m^2, y: 2 kg*m^2, z: any}}",
        "{mass: 2 kg, center: A, inertia: {axis: z, axial: any, transverse: any}}",
        "{mass: 2 kg, center: A, inertia: {axis: x, axial: 1 kg*m^2, transverse: any}}",
        "{mass: 2 kg, center: A, radii_of_gyration: {axis: z, axial: any, transverse: any}}"}) {
    const SolvedStatement solved = solve_statement(read_statement("title: any\npoints: {O: [0, 0, 0], A: [1 m, 0, 0]}\n"
                                                                  "bodies:\n  bar: " +
                                                                      std::string(body) +
                                                                      "\njoints: {pin: {revolute: z, at: O, to: bar, "
                                                                      "rate: 2 rad/s}}\n"
                                                                      "ask: {H: angular_momentum(bar about O).z}\n",
                                                                  "test.yaml"),
                                                   {});
    ASSERT_EQ(solved.solutions.size(), 1U);
    EXPECT_EQ(solved.solutions.front().asks.front().state, AskState::undetermined) << body;
    EXPECT_EQ(solved.solutions.front().asks.front().reason, by_any) << body;
  }
}

// An unknown that is found from what is open is itself not determined.
TEST(Determinacy, AnUnknownFoundFromWhatIsOpen) {
  const auto complaint = [](const std::string& gravity, const std::string& mass, const std::string& mast,
                            const std::string& accel) {
    return complaints(solve_statement(
        read_statement("title: a couple to be found\n" + gravity + "points: {O: [0, 0, 0], A: [1 m, 0, 0]}\n" +
                           "bodies: {arm: massless, bar: {rod: [O, A], mass: " + mass + "}}\n" +
                           "joints: {mast: {revolute: y, at: O, to: arm" + mast +
                           "}, pin: {revolute: z, at: O, from: arm, to: bar, angle: 30 deg, rate: 0}}\n" +
                           "loads: {twist: {couple: [0, 0, M], body: bar, axes: bar}}\nfind: {M: N*m}\n" +
                           "instants: {now: {angular_acceleration(bar).z: " + accel + "}}\nask: {M: M}\n",
                       "test.yaml"),
        {}));
  };
  const std::string none = "gravity: none\n", still = ", rate: 0, accel: 0";
  EXPECT_EQ(complaint(none, "3 kg", still, "2 rad/s^2"), "");
  expect_words(complaint(none, "any", still, "2 rad/s^2"), {by_any});
  expect_words(complaint("", "3 kg", still, "2 rad/s^2"), {by_gravity});
  expect_words(complaint(none, "3 kg", "", "2 rad/s^2"), {"nothing fixes the rate of joint 'mast'"});
  // Of no mass at all the couple would be zero whatever is open.
  EXPECT_EQ(complaint(none, "any", still, "0"), "");
}

// A question over a motion that has no answer is not asked again with other gravity: here the motion would be followed
// to see when a shared force, which is zero but for rounding, passes through zero.
TEST(Determinacy, WhatHasNoAnswerIsNotSoughtAgain) {
  const Work begin = work_done();
  const SolvedStatement solved = solve_statement(read_statement(R"(title: two like joints
points: {A: [-1 ft, 0, 0], B: [1 ft, 0, 0]}
bodies: {sheet: {polygon: [[6 in, 0, 0], B, [6 in, 0, -6 in]], weight: 2.7 lb}}
joints:
  bearings: {revolute: x, at: A, to: sheet, angle: turn, supports: {A: [y, z]}}
  like_it: {revolute: x, at: A, to: sheet}
ask: {first: {first_time: reaction(A).z == 0}, alpha: "turn''"}
)",
                                                                "test.yaml"),
                                                 {});
  // The answers take some ten million units, and following the motion took thousands of times as many.
  EXPECT_LT(work_done() - begin, 500'000'000);
  ASSERT_EQ(solved.solutions.size(), 1U);
  const std::vector<SolvedAsk>& asks = solved.solutions.front().asks;
  EXPECT_NE(asks[0].reason.find("the rate of 'turn' at joint 'bearings' is unknown"), std::string::npos);
  EXPECT_NE(asks[1].reason.find(by_gravity), std::string::npos);
}

}  // namespace determinacy_messages_test
}  // namespace poinsot::problem
