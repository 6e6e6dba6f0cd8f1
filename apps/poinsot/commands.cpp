#include "commands.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <system_error>

#include "exit_codes.h"
#include "poinsot/document.h"
#include "poinsot/problem.h"
#include "poinsot/rendering.h"
#include "progress_line.h"
#include "streams.h"

namespace {

using poinsot::Answer;
using poinsot::AnswerState;
using poinsot::Document;
using poinsot::Problem;
using poinsot::Solution;

std::string why_unanswered(const Answer& answer) {
  switch (answer.state) {
    case AnswerState::found:
      break;
    case AnswerState::needs_letters:
      return fmt::format("needs values for {}{}", fmt::join(answer.letters, ", "),
                         answer.no_formula.empty() ? "" : ": " + answer.no_formula);
    case AnswerState::undetermined:
      return "not determined: " + answer.reason;
    case AnswerState::refused:
      return "refused: " + answer.reason;
  }
  return "";
}

// Why a document is not fully answered: in full for a program, which reads no text; in short for a reader, who has
// the reasons before him.
void report_unanswered(const std::string& file, const Document& document, bool in_full) {
  if (document.solutions.empty()) {
    write_message(fmt::format("{}: no solution", file));
    for (const std::string& warning : document.warnings) {
      if (in_full) write_message(fmt::format("{}: warning: {}", file, warning));
    }
    return;
  }
  std::set<std::string> unanswered;
  for (const Solution& solution : document.solutions) {
    for (const Answer& answer : solution.answers) {
      const bool has_formula = answer.state == AnswerState::needs_letters && !answer.formula.empty();
      if (answer.state == AnswerState::found || has_formula || !unanswered.insert(answer.name).second) continue;
      if (in_full) write_message(fmt::format("{}: no answer to '{}': {}", file, answer.name, why_unanswered(answer)));
    }
  }
  if (!in_full) {
    write_message(fmt::format("{}: {} of {} questions without an answer", file, unanswered.size(),
                              document.solutions.front().answers.size()));
  }
}

// The answers, or those that were found before the interrupt key was pressed. While the file is read, which may be
// standard input, the key ends the program.
Document found_until_interrupted(const Problem& problem, const SolveArguments& arguments) {
  const InterruptCatcher catcher;
  ProgressLine line;
  const poinsot::Budget budget = line.budget();
  if (arguments.scene) return problem.illustrate(arguments.sets, budget, arguments.explain);
  return arguments.explain ? problem.explain(arguments.sets, budget) : problem.solve(arguments.sets, budget);
}

// In what a file falls short of its own expected answers. A file that is wrong is a failure, one that does not exist an
// error of the caller.
std::vector<std::string> failures_of(const std::string& file) {
  try {
    const Problem problem = Problem::from_file(file);
    const InterruptCatcher catcher;
    ProgressLine line;
    return problem.check(line.budget());
  } catch (const poinsot::StatementError& error) {
    if (!std::filesystem::exists(file)) throw;
    return {error.what()};
  }
}

}  // namespace

std::vector<std::string> problem_files(const std::vector<std::string>& paths) {
  namespace fs = std::filesystem;
  std::vector<std::string> files;
  for (const std::string& path : paths) {
    std::error_code error;
    if (!fs::is_directory(path, error)) {
      files.push_back(path);
      continue;
    }
    std::vector<std::string> found;
    for (const auto& entry : fs::recursive_directory_iterator(path, fs::directory_options::skip_permission_denied))
      if (entry.is_regular_file() && entry.path().extension() == ".yaml") found.push_back(entry.path().string());
    if (found.empty()) write_message(fmt::format("{}: no *.yaml file in this folder", path));
    std::ranges::sort(found);
    files.insert(files.end(), found.begin(), found.end());
  }
  return files;
}

int solve(const SolveArguments& arguments) {
  if (!arguments.output.empty()) return write_worked_solutions(arguments);
  const poinsot::TerminalStyle style{.color = wants_color(), .columns = terminal_columns(STDOUT_FILENO)};
  const std::vector<std::string> files = problem_files(arguments.files);
  int code = files.empty() ? exit_wrong_input : exit_answered;
  bool first = true;
  for (const std::string& file : files) {
    try {
      const Problem problem = Problem::from_file(file);
      const Document document = found_until_interrupted(problem, arguments);
      std::string text;
      if (arguments.json) {
        text = to_json(document) + "\n";
      } else if (arguments.explain) {
        text = (first ? "" : "\n") + to_markdown(document);
      } else {
        text = (first ? "" : "\n") + fitted_to_terminal(to_terminal(document, style), Lines::of_answers);
      }
      first = false;
      const bool answered = fully_answered(document);
      if (!answered) code = std::max(code, exit_unanswered);
      if (!write_answer(text)) return code;
      if (!answered) report_unanswered(file, document, arguments.json);
      if (interrupted()) {
        write_message("poinsot: interrupted");
        return exit_interrupted;
      }
    } catch (const poinsot::StatementError& error) {
      write_message(error.what());
      code = std::max(code, exit_wrong_input);
    } catch (const OutputError&) {
      throw;
    } catch (const std::exception& error) {
      write_message(fmt::format("{}: internal failure: {}", file, error.what()));
      code = exit_internal;
    }
  }
  return code;
}

namespace {

std::string line_of(const poinsot::CheckedFile& checked) {
  if (checked.shortfalls.empty()) return fmt::format("{}: passed\n", checked.file);
  constexpr std::size_t most = 4;
  const auto shown = std::min(checked.shortfalls.size(), most);
  std::string line = fmt::format(
      "{}: {}", checked.file,
      fmt::join(checked.shortfalls.begin(), checked.shortfalls.begin() + static_cast<std::ptrdiff_t>(shown), "; "));
  if (checked.shortfalls.size() > shown) line += fmt::format("; {} more", checked.shortfalls.size() - shown);
  std::ranges::replace(line, '\n', ' ');
  return line + "\n";
}

}  // namespace

int check(const CheckArguments& arguments) {
  std::vector<poinsot::CheckedFile> all;
  for (const std::string& file : problem_files(arguments.paths)) {
    try {
      all.push_back({file, failures_of(file)});
    } catch (const poinsot::BudgetEnded&) {
      break;
    }
  }
  const auto passed =
      static_cast<std::size_t>(std::ranges::count_if(all, [](const auto& one) { return one.shortfalls.empty(); }));
  std::string text;
  if (arguments.json) {
    text = poinsot::checks_to_json(all) + "\n";
  } else {
    for (const poinsot::CheckedFile& one : all)
      if (arguments.list || !one.shortfalls.empty()) text += line_of(one);
    text += fmt::format("{} passed, {} failed\n", passed, all.size() - passed);
  }
  static_cast<void>(write_answer(text));
  if (interrupted()) {
    write_message("poinsot: interrupted");
    return exit_interrupted;
  }
  return passed == all.size() && passed > 0 ? exit_answered : exit_unanswered;
}

int schema(bool of_answer) {
  const std::string text = of_answer ? poinsot::answer_schema() : poinsot::problem_schema();
  static_cast<void>(write_answer(text));
  return exit_answered;
}
