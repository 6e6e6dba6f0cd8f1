// Worked solutions as Markdown with mathematics in TeX.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>
#include <string_view>
#include <vector>

#include "document/datum_text.h"
#include "document/display_text.h"
#include "document/named_constants.h"
#include "document/rounding.h"
#include "poinsot/rendering.h"
#include "problem/explanation/explanation.h"
#include "problem/language/words.h"

namespace poinsot::document {
namespace {

constexpr int significant_digits = 6;

// Marks the first equals sign of an equation for alignment with its neighbours.
std::string aligned(const problem::ExplainedEquation& equation, bool names) {
  const std::size_t sign = equation.tex.find(" = ");
  std::string line = equation.tex;
  if (sign != std::string::npos) line.replace(sign, 3, " &= ");
  if (!names) return line;
  return (equation.name.empty() ? "" : equation.name + ":") + std::string(" && ") + line;
}

std::string displayed(const std::vector<problem::ExplainedEquation>& equations) {
  if (equations.empty()) return "";
  bool names = false;
  for (const problem::ExplainedEquation& equation : equations) names = names || !equation.name.empty();
  if (equations.size() == 1 && !names) return "\n$$\n" + equations.front().tex + "\n$$\n";
  std::string text = "\n$$\n\\begin{aligned}\n";
  for (std::size_t i = 0; i < equations.size(); ++i)
    text += aligned(equations[i], names) + (i + 1 < equations.size() ? " \\\\\n" : "\n");
  return text + "\\end{aligned}\n$$\n";
}

// The lines of a text without characters that control a terminal.
std::string printable_lines(std::string_view text) {
  std::string result;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    result += printable(text.substr(begin, end - begin)) + "\n";
    begin = end + 1;
  }
  return result;
}

// A text that somebody wrote, on one line, without a meaning to Markdown, HTML or TeX.
std::string markdown_text(std::string_view text) {
  std::string result;
  const std::string line = printable(text);
  for (std::size_t i = 0; i < line.size(); ++i) {
    // Addresses become links by themselves: http://, www. and those of mail.
    const bool address =
        line.compare(i, 3, "://") == 0 || (line[i] == '.' && i >= 3 && line.compare(i - 3, 3, "www") == 0);
    if (address || std::string_view("\\`*_[]<>#$|&~@").find(line[i]) != std::string_view::npos) result += '\\';
    result += line[i];
  }
  return result;
}

// The same as code, for text that is part of the language.
std::string markdown_code(std::string_view text) {
  const std::string line = printable(text);
  return line.find('`') == std::string::npos ? "`" + line + "`" : "`` " + line + " ``";
}

std::string markdown_picture(const MarkdownPicture& picture) {
  // Between angle brackets an address may have blanks and parentheses.
  std::string address;
  for (const char letter : printable(picture.address))
    address += letter == '<' ? "%3C" : letter == '>' ? "%3E" : std::string(1, letter);
  return "\n![" + markdown_text(picture.title) + "](<" + address + ">)\n";
}

// The pictures that belong to a section, which are taken out of those left. A heading may tell more after a comma:
// which situation or instant of several it is about.
std::string pictures_of(const std::string& heading, std::vector<MarkdownPicture>& left) {
  std::string text;
  std::erase_if(left, [&](const MarkdownPicture& picture) {
    const bool here = heading == picture.section || heading.starts_with(picture.section + ",");
    if (here) text += markdown_picture(picture);
    return here;
  });
  return text;
}

// A table, indented so that it belongs to the item of its question: a name and the cells of each column.
std::string markdown_table(const std::vector<std::string>& heads, const std::vector<std::vector<std::string>>& cells) {
  std::string table = fmt::format("\n\n  | {} |\n  |", fmt::join(heads, " | "));
  for (std::size_t i = 0; i < heads.size(); ++i) table += "---:|";
  for (std::size_t row = 0; row < cells.front().size(); ++row) {
    table += "\n  |";
    for (const std::vector<std::string>& column : cells) table += " " + column[row] + " |";
  }
  return table;
}

std::string formula_code(const Answer& answer, const Datum& formula) {
  if (!answer.columns.empty()) {
    const std::vector<std::vector<std::string>> rows = formula_rows(formula);
    std::vector<std::string> heads;
    std::vector<std::vector<std::string>> cells;
    if (!answer.component_names.empty()) {
      heads.emplace_back("on");
      cells.push_back(answer.component_names);
      cells.back().resize(rows.size());
    }
    for (std::size_t c = 0; c < answer.columns.size(); ++c) {
      heads.push_back(answer.columns[c].name);
      cells.emplace_back();
      for (const std::vector<std::string>& row : rows) cells.back().push_back(c < row.size() ? "`" + row[c] + "`" : "");
    }
    return markdown_table(heads, cells);
  }
  const std::string text = datum_text(formula, "", significant_digits);
  return answer.component_names.empty() || has_brackets(formula) ? "`" + text + "`" : "`(" + text + ")`";
}

// What takes lines of its own.
bool is_table(const Answer& answer) {
  return !answer.columns.empty() && !answer.claim && (answer.state == AnswerState::found || !answer.formula.empty());
}

std::string answer_value(const Answer& answer) {
  switch (answer.state) {
    case AnswerState::found:
      break;
    case AnswerState::needs_letters:
      if (!answer.formulas.empty()) {
        std::vector<std::string> all;
        for (const FormulaWhere& one : answer.formulas)
          all.push_back(formula_code(answer, one.formula) + fmt::format(" where `{}`", fmt::join(one.where, "`, `")));
        return fmt::format("{}", fmt::join(all, "; "));
      }
      if (!answer.formula.empty()) return formula_code(answer, answer.formula);
      return fmt::format("needs values for {}", fmt::join(answer.letters, ", "));
    case AnswerState::undetermined:
      return "not determined: " + answer.reason;
    case AnswerState::refused:
      return "refused: " + answer.reason;
  }
  if (answer.claim) return answer.claim->holds ? "holds, " + answer.claim->how : "does not hold";
  if (is_table(answer)) {
    std::vector<std::string> heads;
    std::vector<std::vector<std::string>> cells;
    if (!answer.component_names.empty()) {
      heads.emplace_back("on");
      cells.push_back(answer.component_names);
      cells.front().resize(answer.columns.front().value.size());
    }
    for (const Column& column : shown_columns(answer)) {
      heads.push_back(printable(column.name + (column.unit.empty() ? "" : " in " + column.unit)));
      cells.push_back(rounded_column(column.value, significant_digits));
    }
    return markdown_table(heads, cells);
  }
  // A vector of a planar problem has two components, and axes to be told by.
  const std::size_t components = answer.component_names.empty() ? 3 : answer.component_names.size();
  return "**" + datum_text(answer.value, answer.unit, significant_digits, components) + "**";
}

std::string answers_section(const Solution& solution) {
  std::string text = "\n## Answers\n\n";
  for (const Unknown& unknown : solution.unknowns) {
    // Who asks for what is to be found by its own name is told it once.
    if (std::ranges::any_of(solution.answers, [&](const Answer& answer) {
          return answer.name == unknown.name && answer.ask == unknown.name && answer.state != AnswerState::refused;
        }))
      continue;
    text +=
        printable(fmt::format("* *{}* = {}", unknown.name,
                              unknown.value.empty() ? "`" + datum_text(unknown.formula, "", significant_digits) + "`"
                                                    : datum_text(unknown.value, unknown.unit, significant_digits))) +
        "\n";
  }
  for (const Answer& answer : solution.answers)
    text += printable(fmt::format("* *{}*, {}:", answer.name,
                                  answer.words.empty() ? markdown_code(answer.ask) : answer.words)) +
            (is_table(answer) ? answer_value(answer) : printable(" " + answer_value(answer))) + "\n";
  const std::vector<std::string> assumptions = assumptions_in_words(solution);
  if (!assumptions.empty()) text += fmt::format("\nwhere {}\n", fmt::join(assumptions, ", "));
  for (const std::string& note : solution.notes) text += "\n" + printable(note) + "\n";
  std::vector<std::string> checks;
  for (const auto& [name, residual] : solution.checks)
    checks.push_back((name == "newton_euler"   ? "Newton-Euler"
                      : name == "energy_drift" ? "energy along the motion"
                      : name == "motion_error" ? "error of the motion"
                      : name == "course"       ? "course of the motion"
                      : name == "scan"         ? "extremes and times by a scan"
                      : name == "roots"        ? "roots by a scan"
                                               : name) +
                     " " + rounded_residual(residual));
  if (!checks.empty())
    text += fmt::format("\nChecked with the bodies as particles, relative misfits: {}.\n", fmt::join(checks, ", "));
  return text;
}

}  // namespace
}  // namespace poinsot::document

namespace poinsot {

namespace {

// A heading may tell more after a comma: which situation, instant or limit it is about.
std::pair<std::string, std::string> parts_of(const std::string& heading) {
  const std::size_t comma = heading.find(", ");
  return {heading.substr(0, comma), comma == std::string::npos ? "" : heading.substr(comma + 2)};
}

bool same_steps(const problem::ExplainedSection& one, const problem::ExplainedSection& other) {
  return parts_of(one.heading).first == parts_of(other.heading).first &&
         std::ranges::equal(
             one.steps, other.steps, [](const problem::ExplainedStep& first, const problem::ExplainedStep& second) {
               return first.text == second.text &&
                      std::ranges::equal(first.equations, second.equations, {}, &problem::ExplainedEquation::tex,
                                         &problem::ExplainedEquation::tex);
             });
}

// The number of the first solution that has the same section, before the one at `index`.
std::optional<std::size_t> solution_with(const problem::ExplainedSection& section, const Document& document,
                                         std::size_t index) {
  for (std::size_t i = 0; i < index; ++i)
    if (const auto& other = document.solutions[i].explanation)
      if (std::ranges::any_of(other->sections, [&](const auto& one) {
            return one.heading == section.heading && same_steps(one, section);
          }))
        return i + 1;
  return std::nullopt;
}

// Where a section of one solution has been said before, as the equations of a limit at which nothing else differs.
std::optional<std::string> said_before(const std::vector<problem::ExplainedSection>& sections,
                                       const problem::ExplainedSection& section) {
  constexpr std::size_t worth_it = 2;  // equations: fewer are read faster than looked for
  std::size_t equations = 0;
  for (const problem::ExplainedStep& step : section.steps) equations += step.equations.size();
  if (equations < worth_it) return std::nullopt;
  for (const problem::ExplainedSection& one : sections) {
    if (&one == &section) break;
    if (!same_steps(one, section)) continue;
    const std::string where = parts_of(one.heading).second;
    return where.empty() ? "above" : where;
  }
  return std::nullopt;
}

// after_others: whether the solutions before it stand above.
std::string one_solution(const Document& found, std::size_t index, const std::vector<MarkdownPicture>& pictures,
                         bool after_others) {
  require_values(found);
  const Document document = document::with_named_constants(found);
  const Solution& solution = document.solutions.at(index);
  std::string text = "# " + document::markdown_text(document.title.empty() ? document.file : document.title) + "\n";
  if (document.solutions.size() > 1)
    text += fmt::format("\nSolution {} of {}.\n", index + 1, document.solutions.size());
  std::vector<MarkdownPicture> left = pictures;
  // Sections that follow one another and stand in the same solution are named in one heading.
  std::vector<std::string> same;
  std::size_t same_as = 0;
  const auto tell_same = [&] {
    if (same.empty()) return;
    text += "\n## " + problem::listed(same) + fmt::format("\n\nAs in solution {}.\n", same_as);
    same.clear();
  };
  if (solution.explanation)
    for (const problem::ExplainedSection& section : solution.explanation->sections) {
      if (const auto before = after_others ? solution_with(section, document, index) : std::nullopt) {
        if (*before != same_as) tell_same();
        same_as = *before;
        same.push_back(printable(section.heading));
        if (const std::string shown = document::pictures_of(section.heading, left); !shown.empty()) {
          tell_same();
          text += shown;
        }
        continue;
      }
      tell_same();
      text += "\n## " + printable(section.heading) + "\n";
      if (const auto before = said_before(solution.explanation->sections, section)) {
        text += "\nAs " + printable(*before) + ".\n" + document::pictures_of(section.heading, left);
        continue;
      }
      for (const problem::ExplainedStep& step : section.steps)
        text += "\n" + document::printable_lines(step.text) + document::displayed(step.equations);
      text += document::pictures_of(section.heading, left);
    }
  tell_same();
  text += document::answers_section(solution);
  for (const MarkdownPicture& picture : left) text += document::markdown_picture(picture);
  return text;
}

}  // namespace

std::string to_markdown(const Document& found, std::size_t index, const std::vector<MarkdownPicture>& pictures) {
  return one_solution(found, index, pictures, false);
}

std::string to_markdown(const Document& document, const std::vector<std::vector<MarkdownPicture>>& pictures) {
  std::string text;
  for (std::size_t i = 0; i < document.solutions.size(); ++i)
    text += (i == 0 ? "" : "\n") +
            one_solution(document, i, i < pictures.size() ? pictures[i] : std::vector<MarkdownPicture>{}, true);
  if (document.solutions.empty()) {
    text = "# " + document::markdown_text(document.title) + "\n\nThere is no solution.\n";
  }
  for (const std::string& warning : document.warnings) text += "\nWarning: " + printable(warning) + "\n";
  return text;
}

}  // namespace poinsot
