#include "problem/answers/letter_draws.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>

#include "problem/entries/drawn_letters.h"
#include "problem/formulas/formula_conditions.h"
#include "problem/formulas/formula_task.h"
#include "problem/formulas/formula_words.h"
#include "problem/language/words.h"
#include "problem/results/compare_values.h"

namespace poinsot::problem {
namespace {

constexpr int most_first_draws = 32;          // of letters, until unknowns have a solution
constexpr std::size_t places_elsewhere = 10;  // at which other roots are sought
constexpr double same_root_to = 1e-6;         // relative difference of a root from its formula

LetterValues letters_in(const Settings& settings, const std::vector<Letter>& letters) {
  LetterValues values;
  for (const Letter& letter : letters) values[letter.name] = settings.at(letter.name).number;
  return values;
}

// Whether a condition is one of a solution, and not of some of its answers alone.
bool is_of_unknowns(const FormulaCondition& condition) {
  return condition.asks.empty() || condition.words == condition.inequality;
}

// Whether there are such bodies, and cords pull and contacts press as they do in a solution.
bool makes_sense_at(const Statement& statement, const AllSettings& root) {
  try {
    Sample sample(statement, root, OpenChoice{});
    for (std::size_t i = 0; i < statement.situations.size(); ++i) {
      const Situation& situation = statement.situations[i];
      SolvedInstant& start = sample.instant(sample.start_of(i));
      if (situation.has_blow() || (situation.contacts.empty() && situation.cords.empty())) continue;
      try {
        start.solve_forces();
      } catch (const UnansweredError&) {
        // Where nothing of forces is stated they may be open.
        continue;
      }
      if (!start.unphysical().empty()) return false;
    }
    return sample.contact_states_hold();
  } catch (const StatementError&) {
    return false;
  }
}

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

RootsElsewhere::RootsElsewhere(const Statement& statement, const Settings& settings, const std::vector<Letter>& letters,
                               const std::vector<Unknown>& unknowns, const Settings& found_at, Work most)
    : statement_(statement),
      settings_(settings),
      letters_(letters),
      unknowns_(unknowns),
      found_at_(found_at),
      scan_(letters, letters_in(found_at, letters)),
      limit_(most) {}

// Every third point is within half a decade of the first letters, the next within one, the last within two. Angles are
// acute, as beyond a right angle formulas may be told by other branches of the same inverse functions.
Settings RootsElsewhere::point(std::size_t index) const {
  const double nearer = std::pow(2.0, static_cast<double>(index % 3)) / 6;
  const LetterValues far = scan_.point(index);
  Settings there = found_at_;
  for (const Letter& letter : letters_) {
    Value<double>& value = there.at(letter.name);
    if (is_angle(letter)) {
      value.number = 0.05 + 0.47 * std::abs(far.at(letter.name));
      continue;
    }
    const double first = std::abs(value.number);
    value.number = std::copysign(first * std::pow(std::abs(far.at(letter.name)) / first, nearer), far.at(letter.name));
  }
  return there;
}

std::optional<AllSettings> RootsElsewhere::next(const std::vector<Solution>& solutions) {
  const auto has_formulas = [](const Solution& solution) {
    return !solution.unknowns.empty() &&
           std::ranges::all_of(solution.unknowns, [](const SolvedUnknown& one) { return one.formula.has_value(); });
  };
  while (true) {
    std::erase_if(roots_, [&](const AllSettings& root) {
      return std::ranges::any_of(solutions, [&](const Solution& one) { return is_told_by(one, root); });
    });
    const auto without = static_cast<std::size_t>(
        std::ranges::count_if(solutions, [&](const Solution& solution) { return !has_formulas(solution); }));
    if (roots_.size() > without) {
      AllSettings root = std::move(roots_.back());
      roots_.pop_back();
      return root;
    }
    if (looked_at_ == places_elsewhere || limit_.spent()) return std::nullopt;
    const Settings there = point(looked_at_++);
    roots_.clear();
    try {
      if (!is_assumed(statement_, AllSettings(statement_.situations.size(), there))) continue;
      RootsFound found = UnknownSearch(statement_, settings_).find(there);
      if (found.open.empty() && found.warnings.empty() && !found.roots.empty())
        searched_.push_back({there, found.roots});
      if (found.open.empty()) roots_ = std::move(found.roots);
    } catch (const StatementError&) {
      // The statement makes no sense at these letters.
    }
    std::erase_if(roots_, [&](const AllSettings& root) { return !makes_sense_at(statement_, root); });
  }
}

bool RootsElsewhere::is_told_by(const Solution& solution, const AllSettings& root) const {
  const LetterValues letters = letters_in(root.front(), letters_);
  return !solution.unknowns.empty() && std::ranges::all_of(solution.unknowns, [&](const SolvedUnknown& unknown) {
    if (!unknown.formula) return false;
    const Value<double>& value = root[unknown.situation.value_or(0)].at(unknown.own_name);
    return same(at_letters(*unknown.formula, value, letters), value, same_root_to * size_of(value));
  });
}

bool RootsElsewhere::repeats(const Solution& solution, const std::vector<Solution>& others) {
  return std::ranges::any_of(others, [&](const Solution& other) {
    return !solution.unknowns.empty() && std::ranges::all_of(solution.unknowns, [&](const SolvedUnknown& unknown) {
      const auto same = std::ranges::find(other.unknowns, unknown.name, &SolvedUnknown::name);
      return same != other.unknowns.end() && unknown.formula && same->formula &&
             formulas_in(*unknown.formula) == formulas_in(*same->formula);
    });
  });
}

bool RootsElsewhere::stands_beside(const Solution& solution) const {
  std::size_t known = 0;
  for (const SolvedUnknown& unknown : solution.unknowns) known += unknown.formula ? 1 : 0;
  if (known == 0 || known < solution.unknowns.size()) return false;
  const LetterValues first = letters_in(found_at_, letters_);
  const bool excluded = std::ranges::any_of(solution.grounds, [&](const FormulaCondition& condition) {
    return is_of_unknowns(condition) && !(value_at(condition.positive, first) > 0);
  });
  return excluded || std::ranges::any_of(solution.unknowns, [&](const SolvedUnknown& unknown) {
           return !std::isfinite(size_of(at_letters(*unknown.formula, unknown.value, first)));
         });
}

// Asked of the conditions themselves, since a search passes over a root now and then.
bool RootsElsewhere::holds_at(const Solution& solution, const Settings& there) const {
  const AllSettings root =
      with_unknowns(AllSettings(statement_.situations.size(), there), solution.unknowns, letters_in(there, letters_));
  try {
    return UnknownSearch(statement_, settings_).still_holds(root, OpenChoice{});
  } catch (const StatementError&) {
    return false;
  }
}

void RootsElsewhere::tell_where_there_is_none(std::vector<Solution>& solutions) const {
  for (Solution& solution : solutions)
    for (const Place& place : searched_) {
      const LetterValues letters = letters_in(place.letters, letters_);
      const bool claimed =
          !solution.unknowns.empty() &&
          std::ranges::all_of(solution.unknowns,
                              [&](const SolvedUnknown& unknown) {
                                return unknown.formula &&
                                       std::isfinite(size_of(at_letters(*unknown.formula, unknown.value, letters)));
                              }) &&
          std::ranges::all_of(solution.grounds, [&](const FormulaCondition& condition) {
            return !is_of_unknowns(condition) || value_at(condition.positive, letters) > 0;
          });
      if (!claimed || holds_at(solution, place.letters) ||
          std::ranges::any_of(place.roots, [&](const AllSettings& root) { return is_told_by(solution, root); }))
        continue;
      solution.assumptions.push_back("the letters are such that there is this solution: there is none at " +
                                     values_in_words(letters_, letters));
      break;
    }
}

std::string RootsElsewhere::words_of(const AllSettings& root) const {
  std::vector<std::string> values;
  for (const Unknown& unknown : unknowns_)
    for (std::size_t i = 0; i < root.size(); ++i) {
      if (is_common(statement_, unknown.name) ? i > 0 : !is_own(statement_, i, unknown.name)) continue;
      const Value<double>& value = root[i].at(unknown.name);
      if (value.is_number())
        values.push_back(unknown.name + " = " + with_digits(value.number / unknown.unit.factor, 4) +
                         (unknown.unit.text.empty() ? "" : " " + unknown.unit.text));
    }
  return "at other values of the letters there are other solutions, which have no formulas here: with " +
         values_in_words(letters_, letters_in(root.front(), letters_)) + " there is " + listed(values) +
         "; letters get values by --set";
}

}  // namespace poinsot::problem
