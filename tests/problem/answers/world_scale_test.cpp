// No tolerance is a metre, a kilogram or a second by itself: the same problem a million times smaller, lighter or
// faster has the same answers, scaled by their dimensions, and the same verdicts.
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>

#include "case_count.h"
#include "example_files.h"
#include "problem/answers/solve_statement.h"
#include "problem/entries/random_problems.h"
#include "problem/entries/scaled_text.h"

namespace poinsot::problem {
namespace world_scale_test {

using namespace testing;
namespace fs = std::filesystem;

struct TextbookItem {
  std::string name, text;
};

// The problems with plain data, and with letters if the file says at which values it expects its answers.
std::vector<TextbookItem> textbook(std::size_t every) {
  std::vector<TextbookItem> items;
  for (const fs::path& file : poinsot::testing::example_files("textbook", every)) {
    std::ifstream in(file);
    std::stringstream text;
    text << in.rdbuf();
    items.push_back({file.filename().string(), text.str()});
  }
  return items;
}

std::optional<SolvedStatement> solved_at(const TextbookItem& item, const WorldScale& scale) {
  const fs::path file = fs::path(POINSOT_SOURCE_DIR) / "examples" / "textbook" / item.name;
  Statement statement = read_statement(scaled_text(item.text, scale), file.string());
  statement.claims.clear();
  const bool letters = std::any_of(statement.situations.begin(), statement.situations.end(),
                                   [](const Situation& situation) { return !situation.letters.empty(); });
  const auto& cases = statement.expected;
  if (statement.asks.empty() || (letters && (cases.empty() || cases.front().sets.empty()))) return std::nullopt;
  return solve_statement(statement, cases.empty() ? decltype(cases.front().sets){} : cases.front().sets);
}

// That the value b of the scaled world is a times the scale of its dimension, to 1e-7 of the size (in the first world).
void expect_scaled(const Value<double>& a, const Value<double>& b, const WorldScale& scale, double size,
                   const std::string& where) {
  ASSERT_EQ(a.kind, b.kind) << where;
  const double factor = scale.of(a.dimension);
  if (a.is_number()) {
    EXPECT_NEAR(a.number, b.number / factor, 1e-7 * size) << where;
  }
  if (a.is_vector()) {
    EXPECT_LE(norm(a.vector - b.vector / factor), 1e-7 * size) << where;
  }
  if (a.is_boolean()) {
    EXPECT_EQ(a.truth, b.truth) << where;
  }
  ASSERT_EQ(a.items.size(), b.items.size()) << where;
  for (std::size_t i = 0; i < a.items.size(); ++i)
    expect_scaled(a.items[i], b.items[i], scale, std::max(size_of(a.items[i]), size_of(a)), where);
}

// base: the item as it stands.
void expect_same_world(const TextbookItem& item, const std::optional<SolvedStatement>& base, const WorldScale& scale,
                       int& compared) {
  const std::string where =
      fmt::format("{} at lengths, masses, times by {:g}, {:g}, {:g}", item.name, scale.length, scale.mass, scale.time);
  if (!base) return;
  std::optional<SolvedStatement> other;
  try {
    other = solved_at(item, scale);
  } catch (const StatementError& error) {
    ADD_FAILURE() << where << ": " << error.what();
    return;
  }
  ASSERT_EQ(base->solutions.size(), other->solutions.size()) << where;
  for (std::size_t s = 0; s < base->solutions.size(); ++s) {
    const Solution &a = base->solutions[s], &b = other->solutions[s];
    std::map<std::string, double> sizes = sizes_of(a);
    for (std::size_t k = 0; k < a.unknowns.size(); ++k) {
      const Value<double>& value = a.unknowns[k].value;
      expect_scaled(value, b.unknowns[k].value, scale, std::max(size_of(value), sizes[to_string(value.dimension)]),
                    where + ", " + a.unknowns[k].name);
    }
    for (std::size_t i = 0; i < a.asks.size(); ++i) {
      const std::string of = where + ", answer " + std::to_string(i) + " " + b.asks[i].reason;
      ASSERT_EQ(a.asks[i].state, b.asks[i].state) << of;
      if (a.asks[i].state != AskState::found) continue;
      const Value<double>& value = a.asks[i].value;
      expect_scaled(value, b.asks[i].value, scale, sizes[to_string(value.dimension)], of);
      ++compared;
    }
    for (const auto& [name, residual] : b.checks) EXPECT_LE(residual, name == "motion_error" ? 1e-5 : 1e-8) << where;
  }
}

TEST(WorldScale, TheTextbookHasTheSameAnswersAtEverySizeWeightAndPace) {
  int compared = 0;
  for (const TextbookItem& item : textbook(poinsot::testing::examples_thinned)) {
    const auto base = solved_at(item, {});
    for (const double far : {1e-6, 1e6})
      for (const WorldScale& scale : {WorldScale{far, 1, 1}, WorldScale{1, far, 1}, WorldScale{1, 1, far}})
        expect_same_world(item, base, scale, compared);
  }
  // As many as there are, so that none is left out unseen.
  EXPECT_GE(compared, poinsot::testing::at_least(1000));
}

TEST(WorldScale, SomeOfTheTextbookAtAllScalesTogether) {
  int compared = 0;
  for (const TextbookItem& item : textbook(6 * poinsot::testing::examples_thinned)) {
    const auto base = solved_at(item, {});
    for (const double length : {1e-6, 1.0, 1e6})
      for (const double mass : {1e-6, 1.0, 1e6})
        for (const double time : {1e-6, 1.0, 1e6}) expect_same_world(item, base, {length, mass, time}, compared);
  }
  EXPECT_GE(compared, poinsot::testing::at_least(500));
}

// Random trees of bodies from a nanometre to a gigametre, from a nanogram to a billion tons: written in units that are
// no longer what they are called.
TEST(WorldScale, RandomProblemsFromNanometresToGigametres) {
  Random random(511);
  constexpr int trials = poinsot::testing::case_count(300);
  for (int trial = 0; trial < trials; ++trial) {
    ProblemData problem = random_problem(random);
    ask_everything(problem);
    // Of some, one freedom is left open: the verdict that an answer is not determined must be the same, too.
    const bool open = trial % 3 == 0;
    if (open) problem.joints.front().freedoms.clear();
    const double length = std::pow(10, random.uniform(-9, 9)), mass = std::pow(10, random.uniform(-12, 12));
    Style style;
    style.units.length.size = 1 / length;
    style.units.mass.size = 1 / mass;
    style.units.force.size = 1 / (length * mass);
    const WorldScale scale{length, mass, 1};
    const std::string here = problem.text(), there = problem.text(style);
    Solution a, b;
    try {
      a = solved(here);
    } catch (const StatementError&) {
      EXPECT_THROW(solved(there), StatementError) << there;
      continue;
    }
    ASSERT_NO_THROW(b = solved(there)) << there;
    const std::map<std::string, double> sizes = sizes_of(a);
    for (std::size_t i = 0; i < a.asks.size(); ++i) {
      // Whether a rate hangs on what is open may be decided by the rounding of terms that cancel.
      const bool by_rounding = open && !problem.asks[i].starts_with("momentum") &&
                               !problem.asks[i].starts_with("angular_") && !problem.asks[i].starts_with("mass");
      if (by_rounding && a.asks[i].state != b.asks[i].state) continue;
      ASSERT_EQ(a.asks[i].state, b.asks[i].state) << i << ": " << b.asks[i].reason << "\n" << there;
      if (a.asks[i].state != AskState::found) continue;
      const Value<double>& value = a.asks[i].value;
      expect_scaled(value, b.asks[i].value, scale, sizes.at(to_string(value.dimension)), there);
    }
    for (const auto& [name, residual] : b.checks) ASSERT_LT(residual, 1e-9) << name << "\n" << there;
    if (HasFatalFailure()) return;
  }
}

struct ClaimVerdicts {
  std::vector<std::string> reasons;
  std::vector<bool> found, hold;
};
ClaimVerdicts verdicts_at(const std::string& folder, const std::string& name, const WorldScale& scale) {
  const fs::path file = fs::path(POINSOT_SOURCE_DIR) / "examples" / folder / name;
  std::ifstream in(file);
  std::stringstream text;
  text << in.rdbuf();
  Statement statement = read_statement(scaled_text(text.str(), scale), file.string());
  statement.asks.clear();
  ClaimVerdicts verdicts;
  if (statement.claims.empty()) return verdicts;
  const auto& cases = statement.expected;
  const SolvedStatement solved =
      solve_statement(statement, cases.empty() ? decltype(cases.front().sets){} : cases.front().sets);
  for (const SolvedClaim& claim : solved.solutions.front().claims) {
    verdicts.reasons.push_back(claim.reason);
    verdicts.found.push_back(claim.state == AskState::found);
    verdicts.hold.push_back(claim.holds);
  }
  return verdicts;
}

// Standard gravity beside letters without values: that it is a million times weaker or stronger does not change what
// is true of all tops.
TEST(WorldScale, ClaimsHaveTheSameVerdictsAtEverySizeWeightAndPace) {
  std::vector<std::pair<std::string, std::string>> files;
  for (const TextbookItem& item : textbook(poinsot::testing::examples_thinned))
    if (item.text.find("\nclaim:") != std::string::npos) files.emplace_back("textbook", item.name);
  for (const char* name : {"kovalevskaya.yaml", "goryachev-chaplygin.yaml", "lagrange-top.yaml"})
    files.emplace_back("published", name);
  EXPECT_GE(files.size(), 3U + static_cast<std::size_t>(poinsot::testing::at_least(12)));
  for (const auto& [folder, name] : files) {
    const ClaimVerdicts base = verdicts_at(folder, name, {});
    for (const double far : {1e-6, 1e6})
      for (const WorldScale& scale : {WorldScale{far, 1, 1}, WorldScale{1, far, 1}, WorldScale{1, 1, far}}) {
        const ClaimVerdicts other = verdicts_at(folder, name, scale);
        const std::string where =
            fmt::format("{} at lengths, masses, times by {:g}, {:g}, {:g}", name, scale.length, scale.mass, scale.time);
        EXPECT_EQ(base.found, other.found) << where << ": " << fmt::format("{}", fmt::join(other.reasons, "; "));
        EXPECT_EQ(base.hold, other.hold) << where;
      }
  }
}

// A massless link between turning and sliding parts counts as light beside them in any unit of length. (At 1e9 lengths
// the second road, in which gaps of angles stand beside gaps of lengths, does not confirm it, and it is refused.)
TEST(WorldScale, AGovernorSwingsAtEverySize) {
  const fs::path file = fs::path(POINSOT_SOURCE_DIR) / "examples" / "published" / "watt-governor.yaml";
  std::ifstream in(file);
  std::stringstream text;
  text << in.rdbuf();
  for (const double length : {1e-9, 1e-6, 1.0, 1e6})
    for (const double mass : {1e-12, 1.0, 1e12})
      for (const double time : {1e-6, 1.0, 1e6}) {
        const Solution found = solved(scaled_text(text.str(), {length, mass, time}));
        const double part = (2 + 3) * 9.81 / (2 * 0.4 * 12 * 12), square = 1 - part * part;  // cos(b), sin(b)^2
        ASSERT_EQ(found.asks[1].state, AskState::found) << length << " " << mass << " " << time << found.asks[1].reason;
        EXPECT_NEAR(found.asks[1].value.items.at(0).number * time, 12 * std::sqrt(2 * square / (2 + 2 * 3 * square)),
                    1e-8);
      }
}

// An energy that is not that of the stated rate is refused, however slow or small the world is.
TEST(WorldScale, WhatDoesNotFollowIsRefusedAtEveryPace) {
  const std::string text =
      "title: a disk\npoints: {O: [0, 0, 0]}\nbodies: {b: {disk: {center: O, normal: z, radius: 2 m}, mass: 3 kg}}\n"
      "joints: {pin: {revolute: z, at: O, to: b, rate: 5 rad/s}}\ngravity: none\n"
      "instants: {now: {kinetic_energy(b): ENERGY J}}\nask: {a: angular_momentum(b about O)}\n";
  for (const double length : {1e-6, 1.0, 1e6})
    for (const double mass : {1e-6, 1.0, 1e6})
      for (const double time : {1e-9, 1e-6, 1.0, 1e6, 1e9}) {
        std::string right = text, wrong = text;
        right.replace(right.find("ENERGY"), 6, "75");
        wrong.replace(wrong.find("ENERGY"), 6, "75.001");
        EXPECT_NO_THROW(solved(scaled_text(right, {length, mass, time}))) << length << " " << mass << " " << time;
        EXPECT_THROW(solved(scaled_text(wrong, {length, mass, time})), StatementError)
            << length << " " << mass << " " << time;
      }
}

// A disk on a fork turns about a diameter, which is unstable: its weight, which is balanced, neither hastens nor delays
// this, however much it is.
TEST(WorldScale, AnUnstableSpinIsLeftWhateverTheBalancedWeight) {
  for (const double g : {0.0, 9.81, 9.81e3, 9.81e6, 9.81e8}) {
    const Solution found =
        solved("title: a disk on a fork\ngiven: {a: 0.4 m, m: 3 kg, g: " + in_digits(g) + " m/s^2}\naxes: [X, Y, Z]\n" +
               (g > 0 ? "gravity: -Z\n" : "gravity: none\n") +
               "points: {G: [0, 0, 0]}\n"
               "bodies: {fork: massless, disk: {disk: {center: G, normal: Z, radius: a}, mass: m}}\n"
               "joints:\n  shaft: {revolute: Z, at: G, to: fork, angle: phi}\n"
               "  diameter: {revolute: Y, at: G, from: fork, to: disk, angle: theta}\n"
               "instants: {start: {phi: 0, theta: 90 deg, theta': 0, phi': 8 rad/s, nudged: theta}}\n"
               "ask: {a: min(phi'), b: max(abs(theta'))}\n");
    EXPECT_NEAR(found.asks[0].value.number, 4, 1e-6) << g;
    EXPECT_NEAR(found.asks[1].value.number, 4 * std::sqrt(2), 1e-6) << g;
  }
}

// A top that sleeps, faster or slower than it must be to stand: the same verdict at all sizes.
TEST(WorldScale, ATopSleepsOrFallsAtEverySize) {
  const std::string text =
      "title: a sleeping top\ngiven: {m: 85 g, c: 37.5 mm, kz: 21 mm, kp: 45 mm, w: SPIN rad/s, g: 9.81 m/s^2}\n"
      "axes: [X, Y, Z]\ngravity: -Z\npoints: {O: [0, 0, 0], G: [0, 0, c]}\n"
      "frames: {figure: {turns: Z, rate: 0}}\n"
      "bodies: {top: {mass: m, center: G, radii_of_gyration: {about: O, axis: O->G, axial: kz, transverse: kp}}}\n"
      "joints: {tip: {ball: O, to: top}}\n"
      "steady: {frame: figure, spins: {top: {about: O->G, rate: w}}}\nask: {a: stable(top)}\n";
  // It stands from the spin 2 sqrt(m g c It)/Ia = 123.8 rad/s on.
  for (const auto& [spin, stands] : {std::pair{"110", false}, std::pair{"140", true}})
    for (const double length : {1e-9, 1e-6, 1.0, 1e6, 1e9})
      for (const double mass : {1e-12, 1.0, 1e12})
        for (const double time : {1e-6, 1.0, 1e6}) {
          std::string own = text;
          own.replace(own.find("SPIN"), 4, spin);
          const Solution found = solved(scaled_text(own, {length, mass, time}));
          ASSERT_EQ(found.asks[0].state, AskState::found) << found.asks[0].reason;
          EXPECT_EQ(found.asks[0].value.truth, stands) << spin << " " << length << " " << mass << " " << time;
        }
}

// The crank is too long to go there.
TEST(WorldScale, AnOpenFourBarIsRefusedAtEverySize) {
  const std::string text =
      "title: a four-bar\ngiven: {L: 1 m, W: 1 kg}\ngravity: none\n"
      "points: {A: [0, 0, 0], B: [0, 3*L, 0], C: [2*L, L, 0], D: [2*L, 0, 0]}\n"
      "bodies:\n  crank: {rod: [A, B], mass: W}\n  coupler: {rod: [B, C], mass: W}\n  rocker: {rod: [C, D], mass: W}\n"
      "joints:\n  a: {revolute: z, at: A, to: crank, angle: ANGLE deg, rate: 2 rad/s}\n"
      "  b: {revolute: z, at: B, from: crank, to: coupler}\n  c: {revolute: z, at: C, from: coupler, to: rocker}\n"
      "  d: {revolute: z, at: D, to: rocker}\n"
      "ask: {v: angular_velocity(rocker), f: force(c on rocker)}\n";
  for (const double length : {1e-9, 1e-6, 1e-3, 1.0, 1e3, 1e6, 1e9})
    for (const double mass : {1e-12, 1.0, 1e12}) {
      std::string open = scaled_text(text, {length, mass, 1}), closed = open;
      // At 90 degrees B and D are 5 L apart, and coupler and rocker together 3.83 L long.
      open.replace(open.find("ANGLE"), 5, "90");
      closed.replace(closed.find("ANGLE"), 5, "-10");
      const Solution found = solved(closed);
      EXPECT_EQ(found.asks[0].state, AskState::found) << found.asks[0].reason;
      ASSERT_TRUE(found.checks.contains("constraints"));
      EXPECT_LT(found.checks.at("constraints"), 1e-12) << length;
      EXPECT_THROW(solved(open), StatementError) << length << " " << mass;
    }
}

}  // namespace world_scale_test
}  // namespace poinsot::problem
