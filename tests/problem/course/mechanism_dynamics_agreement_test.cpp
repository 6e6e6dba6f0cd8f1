// The equations for motion through time against those in which every force is named, for mechanisms as problem files
// make them.
#include <gtest/gtest.h>

#include <filesystem>
#include <optional>

#include "engine/motion/mechanism/random_mechanisms.h"
#include "example_files.h"
#include "problem/entries/random_problems.h"
#include "problem/instant/instant.h"

namespace poinsot::problem {
namespace mechanism_dynamics_agreement_test {

using poinsot::testing::NamedMotion;
using poinsot::testing::Random;

struct Tally {
  int cases = 0, determined = 0, held = 0, contradictory = 0, constrained = 0, components = 0;
};

void compare(const SolvedInstant& instant, Tally& tally) {
  const auto& machine = instant.machine();
  MechanismDynamics dynamics(machine.mechanism);
  const int n = machine.mechanism.tree.velocity_size();
  const State<double> state{machine.q, instant.velocities().value};
  std::vector<double> given(static_cast<std::size_t>(n), 0.0), a(static_cast<std::size_t>(n));
  for (const auto& stated : machine.accelerations) {
    if (!dynamics.is_held(stated.velocity)) continue;
    given[stated.velocity] = stated.value;
    dynamics.set_held_acceleration(stated.velocity, stated.value);
    ++tally.held;
  }
  dynamics.accelerations(state.q, state.v, a);
  const NamedMotion named(dynamics, state, given);
  if (!named.solution.conflict.empty()) {
    ++tally.contradictory;
    return;
  }
  ++tally.cases;
  tally.constrained += !machine.mechanism.constraints.empty();
  double size = 1, force_size = 0;
  for (const double x : a) size = std::max(size, std::abs(x));
  for (std::size_t k = 0; k < named.components; ++k) {
    if (!named.solution.determined(k)) continue;
    ++tally.determined;
    EXPECT_NEAR(a[k], named.solution.value[k], 1e-9 * size) << machine.mechanism.coordinate_names[k];
  }
  for (std::size_t j = named.components; j < named.efforts; ++j)
    force_size = std::max(force_size, std::abs(named.solution.value[j]));
  for (std::size_t j = 0; j < machine.mechanism.components.size(); ++j) {
    if (!dynamics.component_determined(j) || !named.solution.determined(named.components + j)) continue;
    ++tally.components;
    EXPECT_NEAR(dynamics.component_force(j), named.solution.value[named.components + j], 1e-9 * force_size);
  }
}

TEST(MechanismDynamicsAgreement, RandomProblemFiles) {
  Random random(31);
  Tally tally;
  for (int i = 0; i < 300; ++i) {
    testing::RandomOptions options;
    options.planar = random.chance(0.5);
    testing::ProblemData problem = testing::random_problem(random, options);
    testing::ask_everything(problem);
    SCOPED_TRACE(problem.text());
    const Statement statement = read_statement(problem.text(), "test.yaml");
    const Settings settings;
    SolvedInstant instant(statement.situations.front(), settings, When{}, OpenChoice{});
    compare(instant, tally);
    if (HasFailure()) break;
  }
  EXPECT_EQ(tally.contradictory, 0);
  EXPECT_EQ(tally.cases, 300);
  EXPECT_GT(tally.determined, 900);
}

TEST(MechanismDynamicsAgreement, TextbookFiles) {
  Tally tally;
  int without_body = 0;
  for (const std::filesystem::path& file : poinsot::testing::example_files("textbook")) {
    SCOPED_TRACE(file.filename());
    const Statement statement = read_statement(read_file(file.string()), file.string());
    const SolvedStatement solved = solve_statement(statement, {});
    for (const Solution& solution : solved.solutions) {
      for (const Situation& situation : statement.situations) {
        if (!situation.stages.empty()) continue;
        // "L @ spinning" is the unknown L of the situation `spinning`.
        Settings settings;
        for (const SolvedUnknown& unknown : solution.unknowns) {
          const std::size_t at = unknown.name.find(" @ ");
          if (at == std::string::npos || unknown.name.substr(at + 3) == situation.name)
            settings[unknown.name.substr(0, at)] = unknown.value;
        }
        double letter_value = 1.1;
        for (const Letter& letter : solved.open_letters)
          settings[letter.name] = Value<double>::of_number(letter_value *= 1.3, letter.unit.dimension);
        std::optional<SolvedInstant> instant;
        try {
          instant.emplace(situation, settings, When{}, OpenChoice{});
        } catch (const StatementError&) {
          // Letters may stay without a value, or with one that belongs to no body; unknowns may not have been found.
          const bool without_unknowns = solution.unknowns.empty() && !situation.find.empty();
          if (situation.letters.empty() && !without_unknowns) throw;
          ++without_body;
          continue;
        }
        compare(*instant, tally);
      }
    }
  }
  EXPECT_LT(5 * without_body, tally.cases);
  EXPECT_EQ(tally.contradictory, 0);
  EXPECT_GT(tally.cases, poinsot::testing::at_least(80));
  EXPECT_GT(tally.determined, poinsot::testing::at_least(250));
  EXPECT_GT(tally.held, poinsot::testing::at_least(80));
  EXPECT_GT(tally.constrained, poinsot::testing::at_least(8));
  EXPECT_GT(tally.components, poinsot::testing::at_least(8));
}

}  // namespace mechanism_dynamics_agreement_test
}  // namespace poinsot::problem
