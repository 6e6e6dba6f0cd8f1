#include "problem/cases/varied_data.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

#include "problem/entries/drawn_letters.h"
#include "problem/language/diagnostic.h"
#include "problem/language/words.h"
#include "problem/machine/data.h"

namespace poinsot::problem {
namespace {

// A datum of the file: of a computed one only the dimension and the sign matter, so that letters count one of their
// unit.
VariedDatum varied_datum(const Situation& situation, const NamedExpression& given, const std::string& place) {
  Settings ones;
  for (const Letter& letter : situation.letters)
    ones[letter.name] = Value<double>::of_number(letter.unit.factor, letter.unit.dimension);
  for (const Unknown& unknown : situation.find)
    ones[unknown.name] = value_of_unknown(unknown, {1, 1, 1}, situation.plane);
  DataScope<double> data(situation, ones);
  const Value<double> value = data.value(given.value);
  if (!value.is_number())
    fail(place, {}, "'" + given.name + "' is no number", "take the numbers from which it is computed");
  if (depends_on_time(situation, given.value))
    fail(place, {}, "'" + given.name + "' changes in time", "take the numbers from which it is computed");
  return {given.name, value.dimension, value.number > 0 && !(value.dimension == dimensions::angle), true};
}

VariedDatum varied_one(const Situation& situation, const std::string& name, const std::string& place) {
  for (const NamedExpression& given : situation.given)
    if (given.name == name) return varied_datum(situation, given, place);
  for (const Letter& letter : situation.letters)
    if (letter.name == name) return {name, letter.unit.dimension};
  for (const Unknown& unknown : situation.find)
    if (unknown.name == name) {
      if (unknown.vector) fail(place, {}, "'" + name + "' is a vector", "take numbers");
      return {name, unknown.unit.dimension};
    }
  return {};
}

}  // namespace

std::vector<VariedDatum> varied_data(const Statement& statement, const std::vector<std::string>& names,
                                     const std::string& what) {
  std::vector<VariedDatum> all;
  for (const std::string& name : names) {
    const std::string place = what + " " + name;
    VariedDatum found;
    std::vector<std::string> known;
    for (const Situation& situation : statement.situations) {
      if (found.name.empty()) found = varied_one(situation, name, place);
      for (const std::string& one : settable_names(situation)) known.push_back(one);
    }
    if (found.name.empty()) {
      const std::string hint = did_you_mean(name, known);
      const std::set<std::string> unique(known.begin(), known.end());
      fail(place, {}, "the problem has no letter or datum '" + name + "'",
           !hint.empty() ? hint : fmt::format("it has {}", fmt::join(unique, ", ")));
    }
    all.push_back(std::move(found));
  }
  return all;
}

Statement with_letters(const Statement& statement, const std::vector<VariedDatum>& data) {
  Statement opened = statement;
  for (Situation& situation : opened.situations)
    for (const VariedDatum& datum : data) {
      const auto given = std::ranges::find(situation.given, datum.name, &NamedExpression::name);
      if (given == situation.given.end()) continue;
      Letter letter;
      letter.name = datum.name;
      letter.unit = si_unit(datum.dimension);
      letter.mark = given->mark;
      letter.either_sign = !datum.positive;
      situation.given.erase(given);
      situation.letters.push_back(std::move(letter));
    }
  return opened;
}

std::string setting_text(const VariedDatum& datum, double value) {
  const std::string unit = format_unit(datum.dimension);
  return fmt::format("{}{}{}", value, unit.empty() ? "" : " ", unit);
}

Statement with_questions(const Statement& statement, const std::vector<std::string>& names) {
  Statement chosen = statement;
  chosen.claims.clear();
  if (names.empty()) return chosen;
  chosen.asks.clear();
  for (const std::string& name : names) {
    const auto ask = std::ranges::find(statement.asks, name, &Ask::name);
    if (ask == statement.asks.end()) {
      std::vector<std::string> known;
      for (const Ask& one : statement.asks) known.push_back(one.name);
      const std::string hint = did_you_mean(name, known);
      fail("asks", {}, "the problem asks no '" + name + "'",
           !hint.empty() ? hint : fmt::format("it asks {}", fmt::join(known, ", ")));
    }
    chosen.asks.push_back(*ask);
  }
  return chosen;
}

}  // namespace poinsot::problem
