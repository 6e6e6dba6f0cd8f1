// Any bytes as a problem file, read and solved: a solved statement or a StatementError with a place, nothing else.
//
// Sizes are bounded, so that a slow input is a finding and not merely a large problem.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "problem/answers/solve_statement.h"
#include "problem/entries/statement.h"

using namespace poinsot::problem;

namespace {

constexpr std::size_t most_bytes = 3000, most_bodies = 6, most_stages = 0, most_letters = 4, most_unknowns = 2;

bool small_enough(const Statement& statement) {
  if (statement.situations.size() > 3 || statement.asks.size() > 12) return false;
  for (const Situation& situation : statement.situations) {
    if (situation.bodies.size() + situation.frames.size() > most_bodies || situation.joints.size() > 2 * most_bodies)
      return false;
    if (situation.find.size() > most_unknowns || !situation.choose.empty()) return false;
    if (situation.stages.size() > most_stages || situation.letters.size() > most_letters) return false;
  }
  return true;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size > most_bytes) return 0;
  try {
    const Statement statement = read_statement({reinterpret_cast<const char*>(data), size}, "fuzz");
    if (!small_enough(statement)) return 0;
    const SolvedStatement solved = solve_statement(statement, {});
    if (solved.solutions.empty() && solved.warnings.empty()) std::abort();
    for (const Solution& solution : solved.solutions) {
      if (solution.asks.size() != statement.asks.size()) std::abort();
      for (const SolvedAsk& ask : solution.asks)
        if (ask.state != AskState::found && ask.reason.empty() && ask.letters.empty()) std::abort();
    }
  } catch (const StatementError& error) {
    for (const Diagnostic& diagnostic : error.diagnostics())
      if (diagnostic.mark.line < 1 || diagnostic.mark.column < 1 || diagnostic.message.empty()) std::abort();
  }
  return 0;
}
