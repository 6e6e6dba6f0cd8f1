// Slopes of the equations for unknowns by dual numbers, against differences of the equations.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <set>

#include "example_files.h"
#include "problem/language/units.h"
#include "problem/unknowns/hidden_data.h"
#include "problem/unknowns/unknown_equations.h"

namespace poinsot::problem {
namespace exact_slopes_test {

using namespace testing;

struct Count {
  std::size_t places = 0;   // where the equations have smooth values
  std::size_t exact = 0;    // of these, where they have exact slopes
  std::size_t varying = 0;  // of these, where some slope is not zero
};

// Differences of the eighth order of all equations by one unknown; empty where the equations take another form.
std::vector<double> differences(UnknownEquations& equations, const std::vector<double>& x, std::size_t k,
                                std::size_t size) {
  constexpr std::array<double, 4> weights{4.0 / 5, -1.0 / 5, 4.0 / 105, -1.0 / 280};
  const double h = 2e-4 * std::max(std::abs(x[k]), 0.5 * equations.ranges()[k].scale);
  std::vector<double> slopes(size, 0.0);
  for (std::size_t n = 1; n <= weights.size(); ++n)
    for (const double side : {1.0, -1.0}) {
      std::vector<double> moved = x;
      moved[k] += side * static_cast<double>(n) * h;
      const auto there = equations(moved);
      if (!there || there->smooth.size() != size) return {};
      for (std::size_t i = 0; i < size; ++i) slopes[i] += side * weights[n - 1] / h * there->smooth[i];
    }
  return slopes;
}

void compare(UnknownEquations& equations, const std::vector<double>& x, const std::string& words, Count& count) {
  const auto base = equations(x);
  if (!base || base->smooth.empty()) return;
  ++count.places;
  std::vector<std::vector<double>> exact;
  const auto same = equations.with_slopes(x, &exact);
  if (!same) return;
  ++count.exact;
  EXPECT_EQ(same->values, base->values) << words;
  EXPECT_EQ(same->smooth, base->smooth) << words;
  ASSERT_EQ(exact.size(), base->smooth.size()) << words;
  bool varying = false;
  for (std::size_t k = 0; k < x.size(); ++k) {
    const std::vector<double> slopes = differences(equations, x, k, exact.size());
    const double unit = std::max(std::abs(x[k]), equations.ranges()[k].scale);
    for (std::size_t i = 0; i < slopes.size(); ++i) {
      varying = varying || exact[i][k] != 0;
      EXPECT_NEAR(exact[i][k] * unit, slopes[i] * unit, 1e-8 * (std::abs(slopes[i] * unit) + base->smooth_size) + 1e-12)
          << words << ": equation " << i << " by " << equations.slots()[k].unknown.name << " at " << x[k];
    }
  }
  count.varying += varying;
}

UnknownSystem whole_system(const Statement& statement, const std::vector<Unknown>& unknowns) {
  UnknownSystem system{unknowns, {}};
  for (std::size_t i = 0; i < statement.situations.size(); ++i)
    for (const ConditionGroup& group : groups_of(statement, i))
      if (group.aspect != Aspect::later) system.groups.push_back(group);
  return system;
}

// The hidden data, at their values and beside them, where the facts contradict each other.
TEST(ExactSlopes, RandomProblems) {
  Random random(41);
  Count count;
  for (int attempt = 0; attempt < 300; ++attempt) {
    const ProblemData data = random_problem(random, {.most_bodies = 3});
    std::vector<Datum> eligible = data_of(data, unit_systems()[0]), hidden;
    for (int n = random.integer(1, 3); n > 0; --n) {
      const auto i = random.integer(0, static_cast<int>(eligible.size()) - 1);
      hidden.push_back(eligible[static_cast<std::size_t>(i)]);
      eligible.erase(eligible.begin() + i);
    }
    const HiddenProblem problem(data, unit_systems()[0], hidden);
    std::vector<std::string> asks;
    for (const BodyData& body : data.bodies)
      for (const char* ask : {"momentum(", "velocity(P of ", "acceleration(", "kinetic_energy(", "angular_momentum("})
        if (random.chance(0.4))
          asks.push_back(ask + body.name + (std::string(ask) == "angular_momentum(" ? " about P)" : ")"));
    for (const JointData& joint : data.joints)
      if (joint.kind != "free")
        for (const char* ask : {"force(", "norm(force("})
          if (random.chance(0.5))
            asks.push_back(ask + joint.name + " on " + joint.to + ")" + (std::string(ask) == "force(" ? "" : ")"));
    asks.push_back("rate(angular_momentum(" + data.bodies.front().name + " about P))");
    std::vector<double> truth;
    for (const Datum& datum : hidden) truth.push_back(datum.value);
    std::vector<StatedFact> facts;
    const std::vector<Value<double>> answers = problem.forward(asks, truth);
    for (std::size_t i = 0; i < asks.size(); ++i) facts.push_back({asks[i], answers[i]});
    const std::string text = problem.backward({asks.front()}, facts, {});
    const Statement statement = read_statement(text, "test.yaml");
    const std::vector<Unknown>& unknowns = statement.situations.front().find;
    UnknownEquations equations(statement, whole_system(statement, unknowns), AllSettings(1), {}, unknowns);
    compare(equations, truth, text, count);
    for (double& x : truth) x *= 1 + random.uniform(-0.1, 0.1);
    compare(equations, truth, text, count);
    ASSERT_FALSE(HasFailure()) << "attempt " << attempt;
  }
  EXPECT_GT(count.places, 500u);
  EXPECT_GT(count.exact, count.places * 97 / 100);  // the size of a force that vanishes has none
  EXPECT_GT(count.varying, count.places * 9 / 10);
}

Statement read_example(const std::filesystem::path& path) {
  std::ifstream stream(path);
  return read_statement(std::string{std::istreambuf_iterator<char>(stream), {}}, path.string());
}

// What the examples seek, at places in its range.
TEST(ExactSlopes, UnknownsOfTheExamples) {
  Count count;
  for (const std::filesystem::path& file : poinsot::testing::example_files("textbook", 1)) {
    const Statement statement = read_example(file);
    std::vector<Unknown> unknowns;
    for (const Situation& situation : statement.situations)
      for (const Unknown& unknown : situation.find)
        if (std::none_of(unknowns.begin(), unknowns.end(), [&](const Unknown& u) { return u.name == unknown.name; }))
          unknowns.push_back(unknown);
    if (unknowns.empty()) continue;
    const AllSettings none(statement.situations.size());
    UnknownEquations equations(statement, whole_system(statement, unknowns), none, {}, unknowns);
    for (const std::vector<double>& x : equations.places(6)) compare(equations, x, file.filename().string(), count);
  }
  EXPECT_GT(count.places, 50u);
  EXPECT_EQ(count.exact, count.places);
  EXPECT_GT(count.varying, count.places * 9 / 10);
}

// Every datum of the examples as if it were sought: with all equations of motion.
TEST(ExactSlopes, EveryDatumOfTheExamples) {
  std::size_t files = 0;
  Count count;
  for (const std::filesystem::path& file : poinsot::testing::example_files("textbook")) {
    const Statement statement = read_example(file);
    ++files;
    Settings letters;
    std::vector<Unknown> unknowns;
    std::vector<double> x;
    for (const Situation& situation : statement.situations) {
      for (const Letter& letter : situation.letters)
        letters[letter.name] = Value<double>::of_number(0.7 * letter.unit.factor, letter.unit.dimension);
      DataScope<double> scope(situation, letters);
      for (const NamedExpression& datum : situation.given) {
        const bool known = std::any_of(unknowns.begin(), unknowns.end(),
                                       [&](const Unknown& unknown) { return unknown.name == datum.name; });
        try {
          const Value<double> value = scope.value(datum.value);
          if (known || !value.is_number() || value.number == 0) continue;
          unknowns.push_back({.name = datum.name, .unit = si_unit(value.dimension), .mark = datum.mark});
          x.push_back(value.number);
        } catch (const StatementError&) {
          // It rests on an unknown.
        }
      }
    }
    std::vector<Unknown> all = unknowns;
    for (const Situation& situation : statement.situations)
      all.insert(all.end(), situation.find.begin(), situation.find.end());
    UnknownSystem system = whole_system(statement, unknowns);
    for (std::size_t i = 0; i < statement.situations.size(); ++i)
      if (!system.has({i, Aspect::forces})) system.groups.push_back({i, Aspect::forces});
    UnknownEquations equations(statement, system, AllSettings(statement.situations.size(), letters), {}, all);
    if (!unknowns.empty()) compare(equations, x, file.filename().string(), count);
  }
  EXPECT_GT(count.places, files / 3);
  EXPECT_EQ(count.exact, count.places);
}

Count compare_at(const std::string& text, const std::vector<std::vector<double>>& places) {
  const Statement statement = read_statement(text, "test.yaml");
  const std::vector<Unknown>& unknowns = statement.situations.front().find;
  UnknownEquations equations(statement, whole_system(statement, unknowns), AllSettings(1), {}, unknowns);
  Count count;
  for (const std::vector<double>& x : places) compare(equations, x, text, count);
  EXPECT_EQ(count.places, places.size());
  EXPECT_EQ(count.exact, places.size());
  EXPECT_EQ(count.varying, places.size());
  return count;
}

TEST(ExactSlopes, ALoopThatClosesAwayFromTheDrawnPose) {
  compare_at(R"(title: Crank, coupler and slider
given: {n: 4 rad/s}
points: {O: [0, 0, 0], A: [a, 0, 0], B: [a + b, 0, 0]}
bodies:
  crank: {rod: [O, A], mass: m}
  coupler: {rod: [A, B], mass: m}
  slider: {particle: B, mass: m}
joints:
  main: {revolute: z, at: O, to: crank, angle: q, rate: n}
  big: {revolute: z, at: A, from: crank, to: coupler}
  guide: {prismatic: x, at: B, to: slider}
  small: {revolute: z, at: B, from: coupler, to: slider}
gravity: -y
find: {a: m, b: m, q: rad, m: kg}
instants:
  now: {velocity(slider).x: -1 m/s, norm(velocity(coupler)): 2 m/s, force(guide on slider).y: 3 N, center(coupler).x: 0.5 m}
ask: {a: a}
)",
             {{0.3, 0.8, 0.9, 2}, {0.25, 0.7, 2, 1}});
}

TEST(ExactSlopes, ABlowAndWhatFollowsIt) {
  compare_at(R"(title: A bar that swings and strikes
points: {O: [0, 0, 0], A: [0, -L, 0], B: [0, -b, 0]}
bodies:
  bar: {rod: [O, A], mass: 3 kg}
  block: {particle: A, mass: m}
joints:
  pin: {revolute: z, at: O, to: bar, rate: 2 rad/s}
  rail: {prismatic: x, at: A, to: block, rate: 0 m/s}
impacts:
  hit: {of: block, against: bar, at: A, pushes: x, restitution: e}
gravity: -y
find: {L: m, m: kg, e: 1, b: m}
instants:
  before: {kinetic_energy(bar): 2 J}
  after: {velocity(block).x: 1 m/s, norm(velocity(B of bar)): 0.2 m/s, impulse(hit on block).x: 1 N*s}
ask: {e: e}
)",
             {{0.9, 1.2, 0.6, 0.5}, {0.5, 2, 0.2, 0.1}});
}

TEST(ExactSlopes, SteadyMotionAndItsCones) {
  compare_at(R"(title: A disk on a turning arm
points: {O: [0, 0, 0], A: [b, 0, 0], C: [b, 0, 0]}
frames:
  arm: {turns: y, rate: w}
bodies:
  disk: {disk: {center: A, normal: x, radius: r}, mass: 3 kg}
joints:
  axle: {revolute: x, at: A, from: arm, to: disk, rate: p}
gravity: -y
find: {w: rad/s, p: rad/s, r: m, b: m}
instants:
  now:
    angular_momentum(disk about O).y: 2 kg*m^2/s
    space_cone(disk): 20 deg
    body_cone(disk): 30 deg
    couple(axle on disk about A).z: 4 N*m
ask: {w: w}
)",
             {{2, 3, 0.4, 0.5}, {-1, 8, 0.2, 0.1}});
}

}  // namespace exact_slopes_test
}  // namespace poinsot::problem
