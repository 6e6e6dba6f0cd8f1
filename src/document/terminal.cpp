// The answer document as text for a reader.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <functional>
#include <iterator>
#include <string_view>

#include "document/datum_text.h"
#include "document/display_text.h"
#include "document/named_constants.h"
#include "document/rounding.h"
#include "poinsot/rendering.h"

namespace poinsot::document {
namespace {

constexpr std::size_t widest_words = 60;  // a longer text gets a line of its own
constexpr int all_digits = 17;            // of a number

enum class Role { heading, name, faint, failure, warning };

class TerminalText {
 public:
  explicit TerminalText(const TerminalStyle& style) : style_(style) {}

  std::string render(const Document& document) {
    heading(document);
    if (document.solutions.empty()) text_ += "\n  " + painted(Role::failure, "no solution") + "\n";
    for (std::size_t i = 0; i < document.solutions.size(); ++i) solution(document.solutions[i], i, document);
    open_letters(document);
    for (const std::string& warning : document.warnings) {
      text_ += "\n" + painted(Role::warning, "warning:") + " " + printable(warning) + "\n";
    }
    return text_;
  }

 private:
  std::string painted(Role role, const std::string& text) const {
    if (!style_.color) return text;
    constexpr std::array<const char*, 5> codes{"1", "36", "2", "31", "33"};
    return fmt::format("\x1b[{}m{}\x1b[0m", codes[static_cast<std::size_t>(role)], text);
  }

  void heading(const Document& document) {
    const std::string file = document.file == "-" ? "standard input" : printable(document.file);
    if (document.title.empty()) {
      text_ += painted(Role::heading, file) + "\n";
    } else {
      text_ += painted(Role::heading, printable(document.title)) + "  " + painted(Role::faint, "(" + file + ")") + "\n";
    }
  }

  void solution(const Solution& solution, std::size_t index, const Document& document) {
    text_ += "\n";
    const std::size_t count = document.solutions.size();
    std::vector<std::string> unknowns;
    for (const Unknown& unknown : solution.unknowns) {
      // Roots are told apart by their unknowns. A single one is not said twice.
      if (count == 1 && is_asked(unknown, solution.answers)) continue;
      unknowns.push_back(fmt::format("{} = {}", printable(unknown.name),
                                     unknown.value.empty()
                                         ? datum_text(unknown.formula, "", style_.digits)
                                         : datum_text(unknown.value, printable(unknown.unit), style_.digits)));
    }
    if (count > 1 || !unknowns.empty()) {
      const std::string number = count > 1 ? fmt::format("Solution {} of {}", index + 1, count) : "Solution";
      text_ += painted(Role::heading, number);
      text_ += unknowns.empty() ? "\n" : fmt::format(": {}\n", fmt::join(unknowns, ", "));
    }
    answers(solution.answers);
    const std::vector<std::string> assumptions = assumptions_in_words(solution);
    if (!assumptions.empty())
      text_ += "  " + painted(Role::faint, printable(fmt::format("where {}", fmt::join(assumptions, ", ")))) + "\n";
    for (const std::string& note : solution.notes) text_ += "  " + printable(note) + "\n";
    if (!solution.checks.empty()) text_ += "  " + painted(Role::faint, check_line(solution.checks)) + "\n";
  }

  // Whether a question asks for the unknown itself and has its answer.
  static bool is_asked(const Unknown& unknown, const std::vector<Answer>& answers) {
    return std::ranges::any_of(answers, [&](const Answer& answer) {
      return answer.ask == unknown.name && answer.columns.empty() &&
             (answer.state == AnswerState::found ||
              (answer.state == AnswerState::needs_letters && !answer.formula.empty()));
    });
  }

  // Shows the questions in three columns: name, words, answer.
  void answers(const std::vector<Answer>& answers) {
    std::size_t name_width = 0;
    std::size_t words_width = 0;
    for (const Answer& answer : answers) name_width = std::max(name_width, display_width(printable(answer.name)));
    const std::size_t words_begin = 2 + name_width + 2;
    const auto fits = [&](const Answer& answer, std::size_t begin) {
      return style_.columns == 0 || begin + width_of_lines(answer) <= style_.columns;
    };
    for (const Answer& answer : answers) {
      const std::size_t width = display_width(words_of(answer));
      if (width <= widest_words && (is_table(answer) || fits(answer, words_begin + width + 2)))
        words_width = std::max(words_width, width);
    }
    const std::size_t aligned = words_begin + words_width + 2;
    for (const Answer& answer : answers) {
      const std::string words = words_of(answer);
      text_ += "  " + painted(Role::name, padded_right(printable(answer.name), name_width)) + "  ";
      const std::vector<std::string> lines = found_lines(answer);
      const bool below = is_table(answer) || display_width(words) > words_width || !fits(answer, aligned);
      text_ += below ? words + "\n" : padded_right(words, words_width) + "  ";
      // A table starts below its name, where there is more room; what is too wide for its column below the words.
      const std::size_t begin = is_table(answer) ? 4 : fits(answer, aligned) ? aligned : words_begin + 2;
      for (std::size_t i = 0; i < lines.size(); ++i) {
        if (i > 0 || below) text_ += std::string(begin, ' ');
        text_ += lines[i] + "\n";
      }
    }
  }

  static bool is_table(const Answer& answer) {
    return !answer.columns.empty() && (answer.state == AnswerState::found || !answer.formula.empty());
  }

  // Of the widest line of an answer. Colors take no room.
  std::size_t width_of_lines(const Answer& answer) const {
    TerminalStyle plain = style_;
    plain.color = false;
    std::size_t width = 0;
    for (const std::string& line : TerminalText(plain).found_lines(answer))
      width = std::max(width, display_width(line));
    return width;
  }

  static std::string words_of(const Answer& answer) {
    return printable(answer.words.empty() ? answer.ask : answer.words);
  }

  std::vector<std::string> found_lines(const Answer& answer) const {
    switch (answer.state) {
      case AnswerState::found:
        break;
      case AnswerState::needs_letters:
        if (!answer.formula.empty()) return formula_lines(answer);
        return {painted(
            Role::warning,
            "needs values for " + printable(fmt::format("{}{}", fmt::join(answer.letters, ", "),
                                                        answer.no_formula.empty() ? "" : ": " + answer.no_formula)))};
      case AnswerState::undetermined:
        return {painted(Role::failure, "not determined: " + printable(answer.reason))};
      case AnswerState::refused:
        return {painted(Role::failure, "refused: " + printable(answer.reason))};
    }
    if (!answer.columns.empty()) return table_lines(shown_columns(answer), answer.component_names);
    if (answer.claim) return claim_lines(*answer.claim);
    std::vector<std::string> lines =
        datum_lines(answer.value, printable(answer.unit), style_.digits, answer.component_names.size());
    if (!answer.component_names.empty()) {
      const std::string axes = printable(fmt::format("on {}", fmt::join(answer.component_names, ", ")));
      lines.back() += "  " + painted(Role::faint, axes);
    }
    return lines;
  }

  // With more digits where it would look like a rounder number that it is not.
  std::string distinct_text(double value, const std::string& unit) const {
    const auto shown = [&](int digits) {
      const std::string text = fmt::format("{:.{}g}", value, digits);
      double number = value;
      std::from_chars(text.data(), text.data() + text.size(), number);
      return number;
    };
    constexpr int of_round = 3;
    constexpr double same = 1e-12;
    int digits = style_.digits;
    if (digits > of_round && shown(digits) == shown(of_round))
      while (digits < all_digits && std::abs(shown(digits) - value) > same * std::abs(value)) ++digits;
    return datum_text({value}, unit, digits);
  }

  std::vector<std::string> claim_lines(const ClaimOutcome& claim) const {
    int digits = style_.digits;
    const auto number = [&](double value, const std::string& unit) {
      return datum_text({value}, printable(unit), digits);
    };
    // Close to where a claim begins to fail its two sides differ in later digits.
    if (claim.sides.size() == 2 && claim.sides[0] != claim.sides[1] && !claim.difference)
      while (digits < all_digits && number(claim.sides[0], "") == number(claim.sides[1], "")) ++digits;
    std::vector<std::string> lines;
    if (claim.holds) {
      lines.push_back("holds, " + claim.how);
    } else {
      std::vector<std::string> values;
      // Rounded, a number at which a claim just fails may be one at which it holds.
      for (const ClaimOutcome::Value& item : claim.counterexample)
        values.push_back(printable(item.letter) + " = " + distinct_text(item.value, printable(item.unit)));
      lines.push_back(values.empty() ? "fails" : fmt::format("fails: for {}", fmt::join(values, ", ")));
      if (claim.sides.size() == 2)
        lines.push_back(fmt::format("the left side is {}, the right {}", number(claim.sides[0], claim.unit),
                                    number(claim.sides[1], claim.unit)) +
                        (claim.difference
                             ? fmt::format("; the left is {} by {}", *claim.difference < 0 ? "less" : "more",
                                           number(std::abs(*claim.difference), claim.unit))
                             : ""));
    }
    if (!claim.assumptions.empty())
      lines.push_back(painted(Role::faint, printable(fmt::format("if {}", fmt::join(claim.assumptions, ", ")))));
    return lines;
  }

  std::vector<std::string> formula_lines(const Answer& answer) const {
    if (answer.formulas.empty()) return formula_lines(answer, answer.formula);
    std::vector<std::string> lines;
    for (const FormulaWhere& one : answer.formulas) {
      for (const std::string& line : formula_lines(answer, one.formula)) lines.push_back(line);
      lines.back() += "  " + painted(Role::faint, printable(fmt::format("where {}", fmt::join(one.where, ", "))));
    }
    return lines;
  }
  std::vector<std::string> formula_lines(const Answer& answer, const Datum& formula) const {
    if (!answer.columns.empty()) return formula_table_lines(answer, formula);
    std::vector<std::string> lines = datum_lines(formula, "", style_.digits, 0);
    if (!answer.component_names.empty() && std::holds_alternative<std::vector<Datum>>(formula.content)) {
      const std::string axes = printable(fmt::format("on {}", fmt::join(answer.component_names, ", ")));
      // A vector gets parentheses; the rows of a matrix have brackets.
      if (lines.size() == 1 && !has_brackets(formula, 0)) lines.front() = "(" + lines.front() + ")";
      lines.back() += "  " + painted(Role::faint, axes);
    }
    return lines;
  }

  // Columns of formulas begin with their names. One row has no axis.
  std::vector<std::string> formula_table_lines(const Answer& answer, const Datum& formula) const {
    const std::vector<std::vector<std::string>> rows = formula_rows(formula);
    std::vector<std::string> lines(rows.size() + 1);
    const auto add = [&](const std::string& head, const std::function<std::string(std::size_t)>& cell) {
      std::size_t width = display_width(head);
      for (std::size_t i = 0; i < rows.size(); ++i) width = std::max(width, display_width(cell(i)));
      for (std::size_t i = 0; i < lines.size(); ++i)
        lines[i] += "  " + padded_right(i == 0 ? head : cell(i - 1), width);
    };
    const std::vector<std::string>& axes = answer.component_names;
    if (!axes.empty()) add("", [&](std::size_t i) { return i < axes.size() ? printable(axes[i]) : std::string(); });
    for (std::size_t c = 0; c < answer.columns.size(); ++c)
      add(printable(answer.columns[c].name), [&](std::size_t i) { return c < rows[i].size() ? rows[i][c] : ""; });
    for (std::string& line : lines) line.erase(line.find_last_not_of(' ') + 1);
    lines[0] = painted(Role::name, lines[0]);
    return lines;
  }

  // The columns begin with names and units; numbers are right-aligned. Rows of components begin with their axis.
  std::vector<std::string> table_lines(const std::vector<Column>& columns,
                                       const std::vector<std::string>& axes = {}) const {
    std::size_t rows = 0;
    for (const Column& column : columns) rows = std::max(rows, column.value.size());
    std::vector<std::string> lines(rows + 2);
    std::size_t widest = 0;
    for (const std::string& axis : axes) widest = std::max(widest, display_width(printable(axis)));
    for (std::size_t i = 0; !axes.empty() && i < lines.size(); ++i)
      lines[i] = "  " + padded_right(i >= 2 && i - 2 < axes.size() ? printable(axes[i - 2]) : "", widest);
    for (const Column& column : columns) {
      std::vector<std::string> cells{printable(column.name), printable(column.unit)};
      std::ranges::move(rounded_column(column.value, style_.digits), std::back_inserter(cells));
      cells.resize(rows + 2);
      std::size_t width = 0;
      for (const std::string& cell : cells) width = std::max(width, display_width(cell));
      for (std::size_t i = 0; i < cells.size(); ++i) lines[i] += "  " + padded_left(cells[i], width);
    }
    lines[0] = painted(Role::name, lines[0]);
    lines[1] = painted(Role::faint, lines[1]);
    return lines;
  }

  static std::string check_line(const std::map<std::string, double>& checks) {
    std::vector<std::string> parts, of_motion;
    for (const auto& [name, residual] : checks) {
      static const std::map<std::string, std::string, std::less<>> words_of_motion{
          {"energy_drift", "its energy kept to "},
          {"motion_error", "its error below "},
          {"course", "its course that of single instants to "},
          {"scan", "a scan tells the same to "}};
      if (const auto words = words_of_motion.find(name); words != words_of_motion.end()) {
        of_motion.push_back(words->second + (residual == 0 ? "rounding" : rounded_residual(residual)));
        continue;
      }
      if (name == "facts" || name == "roots" || name == "formulas") continue;
      std::string words = name == "newton_euler" ? "Newton-Euler" : printable(name);
      std::ranges::replace(words, '_', ' ');
      parts.push_back(words + " " + rounded_residual(residual));
    }
    std::vector<std::string> said;
    if (!parts.empty()) said.push_back(fmt::format("checked on particles: {}", fmt::join(parts, ", ")));
    if (const auto facts = checks.find("facts"); facts != checks.end())
      said.push_back("facts hold to " + rounded_residual(facts->second));
    if (const auto roots = checks.find("roots"); roots != checks.end())
      said.push_back("a scan finds no other roots" +
                     (roots->second == 0 ? std::string() : ", and these within " + rounded_residual(roots->second)));
    if (const auto formulas = checks.find("formulas"); formulas != checks.end())
      said.push_back("formulas agree with numbers to " + rounded_residual(formulas->second));
    if (!of_motion.empty()) said.push_back(fmt::format("the motion: {}", fmt::join(of_motion, ", ")));
    return fmt::format("{}", fmt::join(said, "; "));
  }

  // Shows how to give values to the letters that answers need.
  void open_letters(const Document& document) {
    std::vector<std::string> settings;
    for (const Letter& letter : document.open_letters) {
      const bool needed = std::ranges::any_of(document.solutions, [&](const Solution& solution) {
        return std::ranges::any_of(solution.answers, [&](const Answer& answer) {
          return answer.state == AnswerState::needs_letters && std::ranges::count(answer.letters, letter.name) > 0;
        });
      });
      if (!needed) continue;
      settings.push_back(letter.unit.empty() ? fmt::format("--set {}=...", letter.name)
                                             : fmt::format("--set '{}=... {}'", letter.name, letter.unit));
    }
    if (settings.empty()) return;
    text_ += printable(fmt::format("To give values: {}", fmt::join(settings, " "))).insert(0, "\n") + "\n";
  }

  TerminalStyle style_;
  std::string text_;
};

}  // namespace
}  // namespace poinsot::document

namespace poinsot {

std::string to_terminal(const Document& document, const TerminalStyle& style) {
  require_values(document);
  return document::TerminalText(style).render(document::with_named_constants(document));
}

}  // namespace poinsot
