#include "problem/answers/letter_draws.h"

#include <algorithm>
#include <cstdint>
#include <random>

#include "problem/entries/drawn_letters.h"
#include "problem/formulas/formula_task.h"
#include "problem/language/words.h"

namespace poinsot::problem {
namespace {

constexpr int most_first_draws = 32;  // of letters, until unknowns have a solution

}  // namespace

std::vector<Letter> open_letters(const Statement& statement, const Settings& settings) {
  std::vector<Letter> open;
  for (const Situation& situation : statement.situations)
    for (const Letter& letter : situation.letters)
      if (!settings.contains(letter.name) &&
          std::none_of(open.begin(), open.end(), [&](const Letter& known) { return known.name == letter.name; }))
        open.push_back(letter);
  return open;
}

LetterDraws::LetterDraws(const Statement& statement, const Settings& settings)
    : settings_(settings), letters_(open_letters(statement, settings)) {
  if (letters_.empty()) return;
  do
    if (is_assumed(statement, AllSettings(statement.situations.size(), this->settings()))) return;
  while (next());
  draw_ = 0;
}

std::vector<Value<double>> LetterDraws::values(int after, int spread) const {
  std::mt19937_64 random(seed_of_draws + static_cast<std::uint64_t>(draw_ + after));
  std::vector<Value<double>> values;
  values.reserve(letters_.size());
  for (const Letter& letter : letters_)
    values.push_back(Value<double>::of_number(drawn_letter(letter, random, draw_ + spread), letter.unit.dimension));
  return values;
}

Settings LetterDraws::settings() const {
  Settings settings = settings_;
  const std::vector<Value<double>> drawn = values();
  for (std::size_t i = 0; i < letters_.size(); ++i) settings[letters_[i].name] = drawn[i];
  return settings;
}

bool LetterDraws::next() { return ++draw_ < most_first_draws; }

StatementError LetterDraws::told(const StatementError& error, bool alike) const {
  if (none() || alike) return StatementError(error);
  Diagnostic told = error.diagnostics().front();
  told.message =
      "the problem makes no sense at any values drawn for the letters without value; at the first of "
      "them: " +
      told.message;
  if (told.hint.empty()) told.hint = "give letters values by --set";
  return StatementError(told);
}

void LetterDraws::tell(std::vector<std::string>& warnings) const {
  const int draws = std::min(draw_ + 1, most_first_draws);
  std::string told;
  const std::vector<Value<double>> drawn = values();
  for (std::size_t i = 0; i < letters_.size(); ++i) {
    const Unit& unit = letters_[i].unit;
    told += (told.empty() ? "" : ", ") + letters_[i].name + " = " + with_digits(drawn[i].number / unit.factor, 4) +
            (unit.text.empty() ? "" : " " + unit.text);
  }
  for (std::string& warning : warnings)
    warning += "; the letters have no values: they were drawn " + std::to_string(draws) +
               (draws == 1 ? " time" : " times") + ", the last time " + told +
               "; at other values there may be solutions: give them by --set";
}

}  // namespace poinsot::problem
