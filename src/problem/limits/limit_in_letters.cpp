#include "problem/limits/limit_in_letters.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "poinsot/engine/math/formula/formula_sign.h"
#include "problem/formulas/formula_answers.h"
#include "problem/formulas/formula_conditions.h"
#include "problem/formulas/formula_task.h"
#include "problem/formulas/formula_unknowns.h"
#include "problem/formulas/formula_words.h"
#include "problem/formulas/letter_scan.h"
#include "problem/instant/contact_state_search.h"
#include "problem/instant/contact_state_words.h"
#include "problem/language/diagnostic.h"
#include "problem/language/words.h"
#include "problem/quantities/describe.h"
#include "problem/unknowns/extremum.h"

namespace poinsot::problem {
namespace {

constexpr int most_ends = 24;        // that are found by numbers: each takes some hundred instants
constexpr int most_without = 16;     // of these, where there is none before the first formula
constexpr int most_tried = 5;        // of these, where the conditions of no formula hold, from then on
constexpr int most_found = 2;        // ends at which each formula is held against what is found there
constexpr int most_confirmed = 8;    // letters at which it is seen to be an end
constexpr double same_end = 1e-5;    // relative difference: ends are found to a few millionths
constexpr double beside_end = 1e-4;  // a part of the end: so far from it the states are those on its side

// A formula of the end, and what is positive wherever it is one.
struct LimitFormula {
  Formula end;
  std::vector<Formula> positive;
  int confirmed = 0;
  LetterValues found_at{};  // and the end there
  double value = 0;
};

class LimitSearch {
 public:
  LimitSearch(const Statement& statement, const Ask& ask, const std::vector<Letter>& open, const FormulaValues& given)
      : statement_(statement),
        ask_(ask),
        open_(open),
        given_(given),
        home_(situation_of(statement, ask)),
        situation_(statement.situations[home_]),
        name_(ask.extremum->name),
        side_(ask.extremum->largest ? 1 : -1) {}

  Solution solve(const std::vector<Settings>& draws) {
    const std::optional<std::string> reason = why_no_formula([&] { search(draws); });
    if (!found_at_ && refusal_) throw StatementError(*refusal_);
    return told(reason);
  }

 private:
  // Letters at which the formula of an end may be another one; that of the end itself has no part in it.
  LetterValues letters_of(const Settings& settings) const {
    LetterValues letters;
    for (const Letter& letter : open_)
      if (letter.name != name_) letters[letter.name] = settings.at(letter.name).number;
    return letters;
  }

  void search(const std::vector<Settings>& draws) {
    if (!situation_.find.empty()) throw NoFormula("beside unknowns it is found by numbers");
    if (situation_.steady) throw NoFormula("in a steady motion the limits of contacts are found by numbers");
    if (situation_.has_blow()) throw NoFormula("after a blow the limits of contacts are found by numbers");
    int ends = 0, tried = 0;
    for (const Settings& drawn : draws) {
      const AllSettings settings(statement_.situations.size(), drawn);
      if (!is_assumed(statement_, settings)) continue;
      const LetterValues letters = letters_of(drawn);
      drawn_.push_back(letters);
      const auto known = std::ranges::find_if(formulas_, [&](const LimitFormula& one) { return covers(one, letters); });
      if (known != formulas_.end()) {
        if (known->confirmed < most_confirmed && !confirm(settings, letters, known->confirmed < most_found)) wrong();
        continue;
      }
      if (ends == most_ends || tried == (formulas_.empty() ? most_without : most_tried)) continue;
      ++ends;
      ++tried;
      const std::optional<double> end = end_by_numbers(settings);
      if (!end) continue;
      if (!found_at_) found_at_ = {letters, *end};
      std::optional<LimitFormula> formula;
      if (std::abs(*end) > 0) formula = formula_of(settings, letters, *end);
      if (!formula) {
        without_ = without_ ? without_ : letters;
        continue;
      }
      formula->found_at = letters;
      formula->value = *end;
      formulas_.push_back(std::move(*formula));
      if (formulas_.size() == 1) tried = 0;
      if (!hold(letters, *end)) wrong();
    }
    if (formulas_.empty())
      throw NoFormula(reason_.empty() ? "no end was found at values drawn for the letters" : reason_);
    for (const LimitFormula& one : formulas_)
      if (one.confirmed < most_found && !without_) without_ = one.found_at;
    std::erase_if(formulas_, [](const LimitFormula& one) { return one.confirmed < most_found; });
    if (formulas_.empty()) throw NoFormula("the formula found was met at one choice of letters only");
    found_at_ = {formulas_.front().found_at, formulas_.front().value};
  }

  [[noreturn]] static void wrong() { throw NoFormula("the formula found holds for some values of the letters only"); }
  // Whether it ends where the formulas say whose conditions hold. sought: by the whole search for the end; else by what
  // holds on either side of it.
  bool confirm(const AllSettings& settings, const LetterValues& letters, bool sought) {
    if (sought) {
      const std::optional<double> end = end_by_numbers(settings);
      return end && hold(letters, *end);
    }
    ExtremumSearch numbers(statement_, ask_, settings, OpenChoice{});
    for (LimitFormula& one : formulas_) {
      if (!covers(one, letters)) continue;
      if (!numbers.is_at(value_at(one.end, letters))) return false;
      ++one.confirmed;
    }
    return true;
  }
  static bool covers(const LimitFormula& one, const LetterValues& letters) {
    return std::ranges::all_of(one.positive, [&](const Formula& positive) { return value_at(positive, letters) > 0; });
  }
  // Whether all formulas whose conditions hold at these letters have the value that was found there.
  bool hold(const LetterValues& letters, double end) {
    bool all = true;
    for (LimitFormula& one : formulas_) {
      if (!covers(one, letters)) continue;
      const double off = std::abs(value_at(one.end, letters) - end) / std::abs(end);
      if (!(off <= same_end)) all = false;
      misfit_ = std::max(misfit_, off);
      ++one.confirmed;
    }
    return all;
  }

  // Nothing where there is none, or it is only that of the values that are tried.
  std::optional<double> end_by_numbers(const AllSettings& settings) {
    try {
      const ExtremumFound found = ExtremumSearch(statement_, ask_, settings, OpenChoice{}).find();
      if (!found.value) {
        if (reason_.empty()) reason_ = "at values drawn for the letters " + found.reason;
        return std::nullopt;
      }
      dimension_ = found.value->dimension;
      return found.value->number;
    } catch (const StatementError& error) {
      if (!refusal_) refusal_ = error;
      return std::nullopt;
    }
  }

  // From the states on either side of the end, those before it first: at rest the formulas are the shortest.
  std::optional<LimitFormula> formula_of(const AllSettings& settings, const LetterValues& letters, double end) {
    for (const bool beyond : {false, true}) {
      AllSettings near = settings;
      const double there = end + (beyond ? side_ : -side_) * beside_end * std::abs(end);
      for (Settings& one : near) one[name_] = Value<double>::of_number(there, dimension_);
      std::vector<std::vector<ContactState>> all;
      try {
        all = states_that_hold(with_states_open(situation_), home_, near[home_], true).all;
      } catch (const StatementError& error) {
        note(error.diagnostics().front().message);
      }
      for (std::vector<ContactState>& states : all) {
        const auto unnamed = std::ranges::find_if(states, [&](ContactState& state) {
          return state.has_direction() && !name_line(state, situation_, near[home_]);
        });
        if (unnamed != states.end()) {
          note("the direction in which contact '" + unnamed->contact + "' slides has no name");
          continue;
        }
        Statement in = statement_;
        put_in_states(in.situations[home_], home_, states);
        std::optional<LimitFormula> found;
        const auto reason = why_no_formula([&] { found = formula_in(in, near, letters, end, beyond); });
        if (reason) note(*reason);
        if (found) return found;
      }
    }
    note("what ends there has no formula");
    return std::nullopt;
  }
  void note(const std::string& reason) {
    if (reason_.empty()) reason_ = reason;
  }

  // Letters and data as formulas; what is varied is a letter too.
  std::vector<FormulaValues> values() const {
    std::vector<FormulaValues> all;
    for (const Situation& situation : statement_.situations) {
      FormulaValues values = given_;
      for (const Letter& letter : situation.letters)
        if (!values.contains(letter.name)) values[letter.name] = problem::formula_of(letter);
      values[name_] = Value<Formula>::of_number(
          Formula::letter(name_, is_signed() ? poinsot::Sign::real : poinsot::Sign::positive), dimension_);
      all.push_back(std::move(values));
    }
    return all;
  }
  bool is_signed() const {
    const auto letter = std::ranges::find(open_, name_, &Letter::name);
    return dimension_ == dimensions::angle || (letter != open_.end() && letter->either_sign);
  }

  // near: beside the end, in the states in which the statement is there.
  std::optional<LimitFormula> formula_in(const Statement& in, const AllSettings& near, const LetterValues& letters,
                                         double end, bool beyond) const {
    const FormulaLimitScope limits({most_formula_terms, most_formula_work / 10});
    LetterValues point = letters;
    point[name_] = near[home_].at(name_).number;
    const PlainPointScope decisions(point);
    const std::vector<FormulaValues> formulas = values();
    Sample numbers(in, near, OpenChoice{});
    FormulaAnswers answers(in, formulas, numbers);
    std::vector<Formula> positive = answers.positive_in_states(home_);
    for (const Formula& rise : rises(answers)) positive.push_back(rise);
    for (Formula& one : positive)
      if (value_at(one, point) < 0) one = -one;
    LetterValues at_end = point;
    at_end[name_] = end;
    for (std::size_t k = 0; k < positive.size(); ++k) {
      if (!vanishes_at(positive[k], point, at_end)) continue;
      std::optional<LimitFormula> found;
      const auto no_root = why_no_formula([&] {
        found = {
            solve_unknowns({positive[k]}, {{name_, dimension_ == dimensions::angle, end, std::abs(end)}}).at(name_),
            {},
            0};
        if (!(std::abs(value_at(found->end, letters) - end) <= same_end * std::abs(end)) ||
            !add_conditions(*found, positive, k, letters, beyond))
          found.reset();
      });
      if (found && !no_root) return found;
    }
    return std::nullopt;
  }

  // Whether a formula has a zero at the end, which is known to a few digits, to its first order there.
  bool vanishes_at(const Formula& one, const LetterValues& point, const LetterValues& at_end) const {
    const double left = value_at(one, at_end), slope = value_at(derivative(one, name_), at_end), end = at_end.at(name_);
    return std::isfinite(left) && slope != 0 && std::abs(left / slope) <= same_end * std::abs(end) &&
           std::abs(left) < std::abs(value_at(one, point));
  }

  // By how much the comparisons hold that are asked.
  std::vector<Formula> rises(FormulaAnswers& answers) const {
    std::vector<Formula> all;
    for (const Expression& condition : ask_.extremum->conditions) {
      const Comparison* comparison = condition.as<Comparison>();
      for (std::size_t k = 0; comparison && k < comparison->relations.size(); ++k)
        all.push_back(answers.at_start(home_, comparison->operands[k + 1]).value.number -
                      answers.at_start(home_, comparison->operands[k]).value.number);
    }
    return all;
  }

  // What is positive besides, at the end: all else that must be so in these states, the end itself if it must be, and
  // how fast what vanishes falls towards it. False where one of them is not at these letters.
  bool add_conditions(LimitFormula& found, const std::vector<Formula>& positive, std::size_t ending,
                      const LetterValues& letters, bool beyond) const {
    std::vector<Formula> all;
    const std::map<std::string, Formula> at{{name_, found.end}};
    for (std::size_t k = 0; k < positive.size(); ++k)
      if (k != ending) all.push_back(poinsot::substituted(positive[k], at));
    all.push_back(Formula(beyond ? side_ : -side_) * poinsot::substituted(derivative(positive[ending], name_), at));
    if (!is_signed()) all.push_back(found.end);
    for (const Formula& root : domain_of(Value<Formula>::of_number(found.end, dimension_))) all.push_back(root);
    for (const Formula& one : all) {
      if (one.is_zero()) continue;
      const double here = value_at(one, letters);
      if (!(here > 0)) return false;
      if (seen_sign(one).sign > 0) continue;
      if (std::ranges::find(found.positive, one) == found.positive.end()) found.positive.push_back(one);
    }
    drop_implied(found, letters);
    return true;
  }

  // What is positive wherever all the others are need not be told, nor what is so for all letters that are assumed:
  // as far as letters show that lie all over six decades around these. Where too few of them tell it stays: to be told
  // once more than it must be is no fault, to be left out where it matters would be one.
  void drop_implied(LimitFormula& found, const LetterValues& letters) const {
    std::vector<Formula>& positive = found.positive;
    constexpr std::size_t points = 3000, enough = 300;
    const LetterScan scan(open_but_the_end(), letters);
    std::vector<LetterValues> assumed;
    for (std::size_t n = 0; n < points; ++n) {
      LetterValues there = scan.point(n);
      Settings settings;
      for (const Letter& letter : open_)
        settings[letter.name] = Value<double>::of_number(
            letter.name == name_ ? value_at(found.end, there) : there.at(letter.name), letter.unit.dimension);
      if (is_assumed(statement_, AllSettings(statement_.situations.size(), settings)))
        assumed.push_back(std::move(there));
    }
    for (std::size_t k = positive.size(); k-- > 0;) {
      std::size_t seen = 0, failing = 0;
      for (const LetterValues& there : assumed) {
        bool others = true;
        for (std::size_t i = 0; i < positive.size() && others; ++i) others = i == k || value_at(positive[i], there) > 0;
        if (!others) continue;
        ++seen;
        failing += value_at(positive[k], there) > 0 ? 0 : 1;
      }
      if (seen >= enough && failing == 0) positive.erase(positive.begin() + static_cast<std::ptrdiff_t>(k));
    }
  }

  Solution told(const std::optional<std::string>& reason) const {
    Solution solution;
    SolvedAsk& solved = solution.asks.emplace_back();
    solved.words = describe(ask_, situation_, false);
    solved.state = AskState::needs_letters;
    if (ask_.unit && found_at_ && !same_kind(ask_.unit->dimension, dimension_))
      fail(situation_.file, ask_.mark,
           "'" + name_ + "' is " + to_string(dimension_) + ", but " + ask_.unit->text + " is a unit of " +
               to_string(ask_.unit->dimension),
           "ask for it in a unit such as " + situation_.habits.unit_for(dimension_).text);
    solved.unit = ask_.unit ? *ask_.unit : situation_.habits.unit_for(dimension_);
    if (found_at_) solved.value = Value<double>::of_number(found_at_->second, dimension_);
    if (reason) {
      solved.no_formula = *reason;
      for (const Letter& letter : open_)
        if (letter.name != name_) solved.letters.push_back(letter.name);
      return solution;
    }
    tell_formulas(solution);
    return solution;
  }

  void tell_formulas(Solution& solution) const {
    SolvedAsk& solved = solution.asks.front();
    const auto value_of = [&](const Formula& end) { return Value<Formula>::of_number(end, dimension_); };
    solved.formula = value_of(formulas_.front().end);
    solution.checks["formulas"] = misfit_;
    std::set<std::string> letters;
    for (const LimitFormula& one : formulas_) {
      for (const std::string& letter : one.end.letters()) letters.insert(letter);
      for (const std::string& words : assumptions_of(value_of(one.end)))
        if (std::ranges::find(solution.assumptions, words) == solution.assumptions.end())
          solution.assumptions.push_back(words);
      RegimeFormula regime{value_of(one.end), {}};
      for (const Formula& positive : one.positive) {
        if (formulas_.size() > 1)
          for (const std::string& letter : positive.letters()) letters.insert(letter);
        regime.where.push_back(condition_words(positive, open_));
        if (formulas_.size() > 1) continue;
        const std::string words = regime.where.back() + " for '" + ask_.name + "'";
        solution.assumptions.push_back(words);
        solution.grounds.push_back({words, positive, regime.where.back(), {0}});
      }
      if (formulas_.size() > 1) solved.regimes.push_back(std::move(regime));
    }
    for (const Letter& letter : open_)
      if (letters.contains(letter.name)) solved.letters.push_back(letter.name);
    if (solved.letters.empty()) solved.state = AskState::found;
    if (without_)
      solution.notes.push_back("no formula of '" + ask_.name + "' was found for letters such as " +
                               values_in_words(open_but_the_end(), *without_));
    hold_conditions_as_told(open_but_the_end(), found_at_->first, drawn_, solution);
  }
  std::vector<Letter> open_but_the_end() const {
    std::vector<Letter> letters = open_;
    std::erase_if(letters, [&](const Letter& letter) { return letter.name == name_; });
    return letters;
  }

  const Statement& statement_;
  const Ask& ask_;
  const std::vector<Letter>& open_;
  const FormulaValues& given_;
  const std::size_t home_;
  const Situation& situation_;
  const std::string name_;
  const int side_;  // in which sense of the datum it ends
  Dimension dimension_;
  std::vector<LimitFormula> formulas_;
  std::optional<std::pair<LetterValues, double>> found_at_;  // where the first formula was found, and the end there
  std::vector<LetterValues> drawn_;                          // at which formulas were looked at
  std::optional<LetterValues> without_;                      // where there is an end, and no formula
  std::string reason_;
  std::optional<StatementError> refusal_;
  double misfit_ = 0;
};

}  // namespace

Solution limit_in_letters(const Statement& statement, const Ask& ask, const std::vector<Letter>& open,
                          const std::vector<Settings>& draws, const FormulaValues& given) {
  return LimitSearch(statement, ask, open, given).solve(draws);
}

}  // namespace poinsot::problem
