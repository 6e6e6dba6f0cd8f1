#include "document/datum_text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>

#include "document/display_text.h"
#include "document/rounding.h"

namespace poinsot::document {
namespace {

using List = std::vector<Datum>;

// The numbers of a non-empty list that consists of numbers only.
std::optional<std::vector<double>> numbers_of(const Datum& datum) {
  const auto* list = std::get_if<List>(&datum.content);
  if (list == nullptr || list->empty()) return std::nullopt;
  std::vector<double> numbers;
  for (const Datum& item : *list) {
    const auto* number = std::get_if<double>(&item.content);
    if (number == nullptr) return std::nullopt;
    numbers.push_back(*number);
  }
  return numbers;
}

// The rows of a matrix: at least two lists of equally many numbers.
std::optional<std::vector<std::vector<double>>> rows_of(const Datum& datum) {
  const auto* list = std::get_if<List>(&datum.content);
  if (list == nullptr || list->size() < 2) return std::nullopt;
  std::vector<std::vector<double>> rows;
  for (const Datum& item : *list) {
    std::optional<std::vector<double>> row = numbers_of(item);
    if (!row || (!rows.empty() && row->size() != rows.front().size())) return std::nullopt;
    rows.push_back(std::move(*row));
  }
  return rows;
}

// The rows of a matrix, rounded together and with right-aligned columns.
std::vector<std::string> matrix_lines(const std::vector<std::vector<double>>& rows, int digits) {
  std::vector<double> entries;
  for (const std::vector<double>& row : rows) entries.insert(entries.end(), row.begin(), row.end());
  const std::vector<std::string> texts = rounded_together(entries, digits);
  const std::size_t columns = rows.front().size();
  std::vector<std::string> lines(rows.size(), "[");
  for (std::size_t column = 0; column < columns; ++column) {
    std::size_t width = 0;
    for (std::size_t row = 0; row < rows.size(); ++row) width = std::max(width, texts[row * columns + column].size());
    for (std::size_t row = 0; row < rows.size(); ++row) {
      lines[row] += (column > 0 ? "  " : "") + padded_left(texts[row * columns + column], width);
    }
  }
  for (std::string& line : lines) line += "]";
  return lines;
}

bool only_texts(const List& items) {
  return std::ranges::all_of(items,
                             [](const Datum& item) { return std::holds_alternative<std::string>(item.content); });
}

std::string text_without_unit(const Datum& datum, int digits, std::size_t vector) {
  if (const auto* number = std::get_if<double>(&datum.content)) return rounded(*number, digits);
  if (const auto* truth = std::get_if<bool>(&datum.content)) return *truth ? "true" : "false";
  if (const auto* text = std::get_if<std::string>(&datum.content)) return printable(*text);
  const auto* list = std::get_if<List>(&datum.content);
  if (list == nullptr || list->empty()) return "none";
  if (const std::optional<std::vector<double>> numbers = numbers_of(datum)) {
    if (numbers->size() == vector) return fmt::format("({})", fmt::join(rounded_together(*numbers, digits), ", "));
    std::vector<std::string> texts;
    for (double number : *numbers) texts.push_back(rounded(number, digits));
    return fmt::format("[{}]", fmt::join(texts, ", "));
  }
  std::vector<std::string> texts;
  for (const Datum& item : *list) {
    const auto* row = std::get_if<List>(&item.content);
    const std::string text = text_without_unit(item, digits, vector);
    texts.push_back(row != nullptr && !row->empty() && only_texts(*row) ? "[" + text + "]" : text);
  }
  const std::string joined = fmt::format("{}", fmt::join(texts, ", "));
  return only_texts(*list) ? joined : "[" + joined + "]";
}

// The rows of a matrix of texts: at least two lists of the same length, which is at least two.
std::vector<std::string> text_matrix_lines(const Datum& datum) {
  const auto* list = std::get_if<List>(&datum.content);
  if (list == nullptr || list->size() < 2) return {};
  std::vector<std::size_t> widths;
  std::vector<std::vector<std::string>> rows;
  for (const Datum& item : *list) {
    const auto* row = std::get_if<List>(&item.content);
    if (row == nullptr || row->size() < 2) return {};
    rows.emplace_back();
    for (const Datum& entry : *row) {
      const auto* text = std::get_if<std::string>(&entry.content);
      if (text == nullptr) return {};
      rows.back().push_back(printable(*text));
    }
    widths.resize(rows.front().size());
    if (rows.back().size() != widths.size()) return {};
    for (std::size_t k = 0; k < widths.size(); ++k) widths[k] = std::max(widths[k], display_width(rows.back()[k]));
  }
  std::vector<std::string> lines;
  for (const std::vector<std::string>& row : rows) {
    std::string& line = lines.emplace_back("[");
    for (std::size_t k = 0; k < row.size(); ++k) line += (k > 0 ? "  " : "") + padded_right(row[k], widths[k]);
    line += "]";
  }
  return lines;
}

}  // namespace

std::vector<std::string> datum_lines(const Datum& datum, const std::string& unit, int digits, std::size_t vector) {
  const std::optional<std::vector<std::vector<double>>> rows = rows_of(datum);
  std::vector<std::string> lines = rows ? matrix_lines(*rows, digits) : text_matrix_lines(datum);
  if (lines.empty()) lines.push_back(text_without_unit(datum, digits, vector));
  if (!unit.empty()) lines.back() += " " + unit;
  return lines;
}

bool has_brackets(const Datum& datum, std::size_t vector) {
  const auto* list = std::get_if<List>(&datum.content);
  if (list == nullptr || list->empty()) return false;
  if (numbers_of(datum)) return list->size() != vector;
  return !only_texts(*list);
}

std::string datum_text(const Datum& datum, const std::string& unit, int digits, std::size_t vector) {
  return text_without_unit(datum, digits, vector) + (unit.empty() ? "" : " " + unit);
}

std::vector<std::vector<std::string>> formula_rows(const Datum& formula) {
  const auto row = [](const List& items) {
    std::vector<std::string> texts;
    for (const Datum& item : items) texts.push_back(text_without_unit(item, 0, 0));
    return texts;
  };
  const List& list = std::get<List>(formula.content);
  std::vector<std::vector<std::string>> rows;
  for (const Datum& item : list)
    if (const auto* items = std::get_if<List>(&item.content)) rows.push_back(row(*items));
  if (rows.empty()) rows.push_back(row(list));
  return rows;
}

std::vector<std::string> assumptions_in_words(const Solution& solution) {
  std::vector<std::string> words = solution.assumptions;
  // What stands beside one of several formulas is not said again.
  for (const Answer& answer : solution.answers)
    for (const FormulaWhere& formula : answer.formulas)
      for (const std::string& where : formula.where) std::erase(words, where + " for '" + answer.name + "'");
  for (std::string& one : words)
    for (const Condition& condition : solution.conditions)
      if (condition.words == one) {
        one += ": " + condition.formula;
        break;
      }
  return words;
}

std::vector<Column> shown_columns(const Answer& answer) {
  std::vector<Column> columns = answer.columns;
  if (answer.over) columns.insert(columns.begin(), *answer.over);
  return columns;
}

}  // namespace poinsot::document
