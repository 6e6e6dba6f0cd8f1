// poinsot equations.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <utility>

#include "commands.h"
#include "exit_codes.h"
#include "output_file.h"
#include "poinsot/problem.h"
#include "poinsot/rendering.h"
#include "progress_line.h"
#include "streams.h"

namespace {

using poinsot::EquationForm;
using poinsot::EquationPart;

constexpr std::array<std::pair<const char*, EquationForm>, 6> forms{{{"text", EquationForm::text},
                                                                     {"tex", EquationForm::tex},
                                                                     {"c", EquationForm::c},
                                                                     {"c++", EquationForm::cpp},
                                                                     {"python", EquationForm::python},
                                                                     {"sympy", EquationForm::sympy}}};
constexpr std::array<std::pair<const char*, EquationPart>, 7> parts{
    {{"mass-matrix", EquationPart::mass_matrix},
     {"right-hand-side", EquationPart::right_side},
     {"constraint-matrix", EquationPart::constraint_matrix},
     {"reduced", EquationPart::reduced},
     {"position-rate", EquationPart::position_rate},
     {"forward-dynamics", EquationPart::forward_dynamics},
     {"inverse-dynamics", EquationPart::inverse_dynamics}}};

// A word of the command line that is none of those expected.
struct WordError : std::invalid_argument {
  using std::invalid_argument::invalid_argument;
};

template <class Table>
auto chosen(const Table& table, const std::string& option, const std::string& word) {
  std::vector<std::string> known;
  for (const auto& [name, value] : table) {
    if (name == word) return value;
    known.emplace_back(name);
  }
  const std::string hint = poinsot::did_you_mean(word, known);
  throw WordError(fmt::format("{} knows no '{}': expected {}{}", option, word, fmt::join(known, ", "),
                              hint.empty() ? "" : " (" + hint + ")"));
}

std::string equations_until_interrupted(const poinsot::Problem& problem, const poinsot::EquationsOptions& options) {
  const InterruptCatcher catcher;
  ProgressLine line;
  return problem.equations(options, line.budget());
}

}  // namespace

int equations(const EquationsArguments& arguments) {
  poinsot::EquationsOptions options;
  try {
    options.form = chosen(forms, "--form", arguments.form);
    for (const std::string& part : arguments.of) options.parts.push_back(chosen(parts, "--of", part));
    const auto wanted = [&](EquationPart part) { return std::count(options.parts.begin(), options.parts.end(), part); };
    if (wanted(EquationPart::forward_dynamics) && wanted(EquationPart::inverse_dynamics))
      throw WordError("--of: forward-dynamics and inverse-dynamics are two functions; ask for one at a time");
    if (!poinsot::is_function_name(arguments.function))
      throw WordError(fmt::format("--name: '{}' cannot be the name of a function", arguments.function));
  } catch (const WordError& error) {
    write_message(fmt::format("poinsot: {}\nTry 'poinsot equations --help'.", error.what()));
    return exit_wrong_input;
  }
  if (!may_be_written(arguments.file, arguments.output, arguments.force)) return exit_wrong_input;
  options.function = arguments.function;
  options.situation = arguments.situation;
  options.sets = arguments.sets;
  options.letters = arguments.letters;
  try {
    const poinsot::Problem problem = poinsot::Problem::from_file(arguments.file);
    const std::string text = equations_until_interrupted(problem, options);
    return write_output(arguments.output, text) ? exit_answered : exit_internal;
  } catch (const poinsot::BudgetEnded&) {
    write_message("poinsot: interrupted");
    return exit_interrupted;
  } catch (const poinsot::NoEquations& error) {
    write_message(fmt::format("{}: no equations of motion: {}", arguments.file, error.what()));
    return exit_unanswered;
  }
}
