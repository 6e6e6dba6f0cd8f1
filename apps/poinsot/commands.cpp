#include "commands.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

#include "document/document.h"
#include "document/explanation_markdown.h"
#include "document/json.h"
#include "document/schema.h"
#include "document/terminal.h"
#include "exit_codes.h"
#include "problem/language/diagnostic.h"
#include "streams.h"

namespace {

using poinsot::document::Answer;
using poinsot::document::AnswerState;
using poinsot::document::CheckResult;
using poinsot::document::Document;
using poinsot::document::Solution;

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

}  // namespace

int solve(const SolveArguments& arguments) {
  const poinsot::document::TerminalStyle style{.color = wants_color()};
  int code = exit_answered;
  bool first = true;
  for (const std::string& file : arguments.files) {
    try {
      const Document document = poinsot::document::run_file(file, arguments.run);
      std::string text;
      if (arguments.json) {
        text = to_json(document) + "\n";
      } else if (arguments.run.explain) {
        text = (first ? "" : "\n") + to_markdown(document);
      } else {
        text = (first ? "" : "\n") + to_terminal(document, style);
      }
      first = false;
      const bool answered = fully_answered(document);
      if (!answered) code = std::max(code, exit_unanswered);
      if (!write_answer(text)) return code;
      if (!answered) report_unanswered(file, document, arguments.json);
    } catch (const poinsot::problem::StatementError& error) {
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

int check(const std::vector<std::string>& paths) {
  const std::vector<CheckResult> results = poinsot::document::check_paths(paths);
  std::string text;
  std::size_t failed = 0;
  for (const CheckResult& result : results) {
    if (result.failures.empty()) continue;
    ++failed;
    constexpr std::size_t most = 4;
    const auto shown = std::min(result.failures.size(), most);
    std::string line = fmt::format(
        "{}: {}", result.file,
        fmt::join(result.failures.begin(), result.failures.begin() + static_cast<std::ptrdiff_t>(shown), "; "));
    if (result.failures.size() > shown) line += fmt::format("; {} more", result.failures.size() - shown);
    std::ranges::replace(line, '\n', ' ');
    text += line + "\n";
  }
  const std::size_t passed = results.size() - failed;
  text += fmt::format("{} passed, {} failed\n", passed, failed);
  const int code = failed == 0 && passed > 0 ? exit_answered : exit_unanswered;
  static_cast<void>(write_answer(text));
  return code;
}

int schema(bool of_answer) {
  const std::string text = of_answer ? poinsot::document::answer_schema() : poinsot::document::problem_schema();
  static_cast<void>(write_answer(text));
  return exit_answered;
}
