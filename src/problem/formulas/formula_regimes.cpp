#include "problem/formulas/formula_regimes.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <set>

#include "poinsot/engine/work/work.h"
#include "problem/formulas/formula_reach.h"
#include "problem/formulas/formula_words.h"
#include "problem/formulas/letter_scan.h"
#include "problem/language/words.h"
#include "problem/results/compare_values.h"
#include "problem/unknowns/asked_value.h"

namespace poinsot::problem {
namespace {

constexpr std::size_t near_points = 50;      // points near the ordinary values at which conditions are looked at
constexpr std::size_t regime_points = 300;   // the same with those all over their decades
constexpr std::size_t most_held = 60;        // of these, at which the only formula told is held against numbers
constexpr std::size_t most_formulas = 6;     // of one answer
constexpr std::size_t most_places = 8;       // to find one more, each from another point
constexpr double same_branch = 1e-6;         // relative difference of numbers on one branch
constexpr double rounding_of_terms = 1e-11;  // of the natural size; of what is next to nothing beside its terms
constexpr Work least_regime_work = 20'000'000;
constexpr Work times_first = 8;  // what the first formulas took, so many times, may go into all others

class RegimeSearch {
 public:
  RegimeSearch(const FormulaTask& task, const FormulaGrounds& grounds, std::vector<HeldCondition>& held,
               Solution& solution)
      : task_(task),
        solution_(solution),
        held_(held),
        scan_(task.open, letters_of(task)),
        most_(times_first * grounds.work) {}

  void run() {
    std::map<std::size_t, std::vector<Formula>> positive;  // of each ask
    for (const HeldCondition& condition : held_)
      for (const std::size_t i : condition.asks)
        if (!condition.bound && solution_.asks[i].formula) positive[i].push_back(condition.positive);
    for (auto& [i, conditions] : positive) {
      // Each has its share, so that what the first ones take is no loss to the last.
      limit_ = WorkLimit(std::max(least_regime_work, most_ / positive.size()));
      look_elsewhere(i, std::move(conditions));
    }
    std::erase_if(held_, [](const HeldCondition& condition) { return condition.asks.empty() && !condition.bound; });
  }

 private:
  struct Regime {
    Value<Formula> formula;
    std::vector<Formula> positive;   // wherever the formula holds
    std::vector<std::string> words;  // what it rests on besides
  };
  struct Place {
    LetterValues letters;
    AllSettings settings;
    std::unique_ptr<Sample> sample;
    Value<double> value;
  };

  static LetterValues letters_of(const FormulaTask& task) {
    LetterValues letters;
    for (const Letter& letter : task.open) letters[letter.name] = task.settings.front().at(letter.name).number;
    return letters;
  }
  static bool concerns(const HeldCondition& condition, std::size_t i) {
    return std::ranges::find(condition.asks, i) != condition.asks.end();
  }
  static bool covers(const Regime& regime, const LetterValues& letters) {
    return std::ranges::all_of(regime.positive, [&](const Formula& one) { return value_at(one, letters) > 0; });
  }
  // Borders, and what lies so near that rounding decides, belong to no side.
  static bool on_border(const std::vector<Regime>& regimes, const LetterValues& letters) {
    return std::ranges::any_of(regimes, [&](const Regime& regime) {
      return std::ranges::any_of(regime.positive, [&](const Formula& one) { return value_at(one, letters) == 0; });
    });
  }

  // The statement with these letters, if they are as is assumed and the question has an answer there.
  std::optional<Place> place_at(const LetterValues& letters, std::size_t i) const {
    Place place{letters, task_.settings, nullptr, {}};
    for (Settings& one : place.settings)
      for (const Letter& letter : task_.open)
        one[letter.name] = Value<double>::of_number(letters.at(letter.name), letter.unit.dimension);
    if (!is_assumed(task_.statement, place.settings)) return std::nullopt;
    place.sample = std::make_unique<Sample>(task_.statement, place.settings, OpenChoice{});
    try {
      place.value = asked_value(*place.sample, task_.statement.asks[i]);
      const SolvedInstant& instant = place.sample->instant_of(task_.statement.asks[i]);
      if (instant.forces_solved() && !instant.one_sided_faults().empty()) return std::nullopt;
    } catch (const StatementError&) {
      return std::nullopt;
    }
    return place;
  }

  // Whether a formula of an answer is that of the branch on which a place is.
  static bool fits(const Value<Formula>& formula, const Place& place, double natural) {
    const double size = std::max(size_of(place.value), rounding_of_terms / same_branch * natural);
    return misfit_of(formula, place.value, place.letters, size) <= same_branch;
  }
  double natural_size(const Place& place, std::size_t i) const {
    return place.sample->instant_of(task_.statement.asks[i]).natural_size(dimension_of(place.value));
  }

  // An answer without formula is no number: it differs beyond a border.
  void take_back(std::size_t i, const std::vector<Regime>& regimes) const {
    SolvedAsk& ask = solution_.asks[i];
    depend_on_all(ask, regimes);
    ask.formula.reset();
    ask.no_formula = "the formula found holds for some values of the letters only";
  }

  void look_elsewhere(std::size_t i, std::vector<Formula> positive) {
    SolvedAsk& ask = solution_.asks[i];
    std::vector<Regime> regimes{{*ask.formula, std::move(positive), {}}};
    std::optional<LetterValues> without;  // letters at which there is an answer, and no formula
    std::size_t attempts = 0;
    for (std::size_t n = 0; n < regime_points; ++n) {
      const LetterValues letters = point(n);
      if (on_border(regimes, letters) ||
          std::ranges::any_of(regimes, [&](const Regime& one) { return covers(one, letters); }))
        continue;
      if (limit_.spent() || attempts == most_places || regimes.size() == most_formulas) {
        if (!without) without = letters;
        break;
      }
      const std::optional<Place> place = place_at(letters, i);
      if (!place) continue;
      ++attempts;
      std::optional<Regime> found = regime_at(*place, i);
      if (found && found->positive.empty() && found->words.empty()) {
        regimes.push_back(std::move(*found));
        take_everywhere(i, regimes);
        return;
      }
      if (found && covers(*found, letters))
        regimes.push_back(std::move(*found));
      else if (!without)
        without = letters;
    }
    hold_together(i, regimes);
    if (regimes.empty()) return;
    const std::vector<Formula> before = regimes.front().positive;
    join(regimes);
    if (regimes.front().positive != before) hold_under(i, regimes.front().positive);
    if (regimes.size() > 1) {
      for (const Regime& regime : regimes) ask.regimes.push_back(written(regime));
      depend_on_all(ask, regimes);
    }
    if (without) tell_rest(i, *without);
  }

  // Near the ordinary values first: from far off, where one letter is next to nothing beside another, the borders of a
  // formula with others are seldom met.
  LetterValues point(std::size_t n) const { return n < near_points ? scan_.near(n) : scan_.point(n - near_points); }

  // Where the conditions of several formulas hold, these agree, and where those of one do, it is right; else numbers
  // tell which is wrong, and its conditions with it.
  void hold_together(std::size_t i, std::vector<Regime>& regimes) const {
    std::size_t alone = 0;
    for (std::size_t n = 0; n < regime_points; ++n) {
      const LetterValues letters = point(n);
      const auto covering = std::ranges::count_if(regimes, [&](const Regime& one) { return covers(one, letters); });
      if (covering == 0 || (covering == 1 && (alone == most_held || limit_.spent()))) continue;
      const std::optional<Place> place = place_at(letters, i);
      if (!place) continue;
      if (covering == 1) ++alone;
      const double natural = natural_size(*place, i);
      const auto wrong = [&](const Regime& one) { return covers(one, letters) && !fits(one.formula, *place, natural); };
      if (covering == 1 && std::ranges::any_of(regimes, wrong) && !confirmed_by_particles(*place->sample)) continue;
      if (wrong(regimes.front())) {
        take_back(i, regimes);
        regimes.clear();
        return;
      }
      std::erase_if(regimes, wrong);
    }
  }

  // Of the same formula on either side of a border one is left: where a < b and where b < a. A single one without
  // condition would say that there is no border.
  void join(std::vector<Regime>& regimes) const {
    for (std::size_t k = 1; k < regimes.size(); ++k)
      for (std::size_t j = 0; j < k; ++j)
        if (auto one = joined(regimes[j], regimes[k]); one && (regimes.size() > 2 || !one->empty())) {
          regimes[j].positive = std::move(*one);
          regimes.erase(regimes.begin() + static_cast<std::ptrdiff_t>(k));
          k = 0;
          break;
        }
  }
  // The conditions under which one or the other holds: what is positive in either, without what has opposite signs in
  // them, or those of the wider one.
  std::optional<std::vector<Formula>> joined(const Regime& one, const Regime& other) const {
    if (!is_same(one.formula, other.formula) || one.words != other.words) return std::nullopt;
    std::vector<Formula> all;
    const auto add = [&](const std::vector<Formula>& positive, const std::vector<Formula>& opposite) {
      for (const Formula& sign : positive)
        if (std::ranges::find(opposite, -sign) == opposite.end() && std::ranges::find(all, sign) == all.end())
          all.push_back(sign);
    };
    add(one.positive, other.positive);
    add(other.positive, one.positive);
    const auto holds_where_either_does = [&](const std::vector<Formula>& positive) {
      const Regime together{one.formula, positive, one.words};
      for (std::size_t n = 0; n < regime_points; ++n) {
        const LetterValues letters = scan_.point(n);
        if (on_border({one, other}, letters)) continue;
        if (covers(together, letters) != (covers(one, letters) || covers(other, letters))) return false;
      }
      return true;
    };
    for (const std::vector<Formula>& positive : {all, one.positive, other.positive})
      if (holds_where_either_does(positive)) return positive;
    return std::nullopt;
  }

  static bool is_same(const Value<Formula>& one, const Value<Formula>& other) {
    if (one.is_number() && other.is_number()) return one.number == other.number;
    if (one.is_vector() && other.is_vector())
      return one.vector.x == other.vector.x && one.vector.y == other.vector.y && one.vector.z == other.vector.z;
    return one.is_list() && other.is_list() && std::ranges::equal(one.items, other.items, is_same);
  }

  // The conditions held of an answer become these.
  void hold_under(std::size_t i, const std::vector<Formula>& positive) const {
    for (HeldCondition& condition : held_)
      if (!condition.bound) std::erase(condition.asks, i);
    for (const Formula& one : positive) {
      const auto known = std::ranges::find_if(
          held_, [&](const HeldCondition& condition) { return !condition.bound && condition.positive == one; });
      if (known == held_.end())
        held_.push_back({one, {i}, false, false, true});
      else
        known->asks.push_back(i);
    }
  }

  // The formula that holds around a place, with its conditions.
  std::optional<Regime> regime_at(const Place& place, std::size_t i) const {
    Solution part = solution_;
    part.assumptions.clear();
    part.conditions.clear();
    part.notes.clear();
    for (SolvedAsk& other : part.asks) other.state = AskState::refused;
    SolvedAsk& ask = part.asks[i];
    ask.state = AskState::needs_letters;
    ask.value = place.value;
    ask.formula.reset();
    std::vector<double> natural = task_.natural;
    natural[i] = natural_size(place, i);
    const FormulaTask task{task_.statement, task_.open,     task_.given,   task_.known,
                           task_.unknowns,  place.settings, *place.sample, natural};
    const FormulaGrounds grounds = find_formulas(task, part);
    if (!ask.formula || !ask.formula_road.empty()) return std::nullopt;
    const std::vector<HeldCondition> held = hold_far_off(task, grounds, part);
    if (!ask.formula) return std::nullopt;
    Regime regime{*ask.formula, {}, {}};
    for (const HeldCondition& condition : held)
      if (concerns(condition, i)) regime.positive.push_back(condition.positive);
    for (const std::string& words : part.assumptions) {
      if (std::ranges::find(solution_.assumptions, words) != solution_.assumptions.end()) continue;
      const auto known = std::ranges::find(part.conditions, words, &FormulaCondition::words);
      if (says_that_positive(words))
        solution_.assumptions.push_back(words);
      else if (known != part.conditions.end())
        regime.positive.push_back(known->positive);
      else
        regime.words.push_back(words);
    }
    double& check = solution_.checks["formulas"];
    if (part.checks.contains("formulas")) check = std::max(check, part.checks.at("formulas"));
    return regime;
  }

  // Whether it says no more than that a letter is positive, which all but those of either sign are.
  bool says_that_positive(const std::string& words) const {
    return std::ranges::any_of(task_.open, [&](const Letter& letter) {
      return !letter.either_sign && !is_angle(letter) && words == letter.name + " > 0";
    });
  }

  // The last of the formulas has no condition.
  void take_everywhere(std::size_t i, std::vector<Regime>& regimes) const {
    std::size_t held = 0;
    for (std::size_t n = 0; n < regime_points && held < most_places; ++n) {
      const std::optional<Place> place = place_at(scan_.point(n), i);
      if (!place) continue;
      ++held;
      if (fits(regimes.back().formula, *place, natural_size(*place, i))) continue;
      take_back(i, regimes);
      return;
    }
    solution_.asks[i].formula = std::move(regimes.back().formula);
    for (HeldCondition& condition : held_)
      if (!condition.bound) std::erase(condition.asks, i);
  }

  // The answer depends on the letters of all its formulas and of what parts them, also where one of them has none.
  void depend_on_all(SolvedAsk& ask, const std::vector<Regime>& regimes) const {
    std::set<std::string> letters;
    for (const Regime& regime : regimes) {
      for (const std::string& letter : letters_in(regime.formula)) letters.insert(letter);
      for (const Formula& one : regime.positive)
        for (const std::string& letter : one.letters()) letters.insert(letter);
    }
    ask.state = AskState::needs_letters;
    ask.letters.clear();
    for (const Letter& letter : task_.open)
      if (letters.contains(letter.name)) ask.letters.push_back(letter.name);
  }

  RegimeFormula written(const Regime& regime) const {
    RegimeFormula result{regime.formula, regime.words};
    for (const Formula& one : regime.positive) {
      std::string words = condition_words(one, task_.open);
      if (std::ranges::find(result.where, words) == result.where.end()) result.where.push_back(std::move(words));
    }
    return result;
  }

  void tell_rest(std::size_t i, const LetterValues& letters) const {
    solution_.notes.push_back("no formula of '" + task_.statement.asks[i].name + "' was found for letters such as " +
                              values_in_words(task_.open, letters));
  }

  const FormulaTask& task_;
  Solution& solution_;
  std::vector<HeldCondition>& held_;
  const LetterScan scan_;
  const Work most_;  // for all asks
  WorkLimit limit_{0};
};

// What is told of conditions is read back at the letters at which the formulas were found and all over their decades.
void hold_told_conditions(const FormulaTask& task, Solution& solution) {
  constexpr std::size_t points = 40;
  LetterValues found_at;
  for (const Letter& letter : task.open) found_at[letter.name] = task.settings.front().at(letter.name).number;
  const LetterScan scan(task.open, found_at);
  std::vector<LetterValues> others;
  for (std::size_t i = 0; i < points; ++i) others.push_back(scan.point(i));
  hold_conditions_as_told(task.open, found_at, others, solution);
}

}  // namespace

void find_regimes(const FormulaTask& task, const FormulaGrounds& grounds, std::vector<HeldCondition>& held,
                  Solution& solution) {
  if (task.unknowns.empty()) RegimeSearch(task, grounds, held, solution).run();
}

void tell_conditions(const FormulaTask& task, const FormulaGrounds& grounds, const std::vector<HeldCondition>& held,
                     Solution& solution) {
  // of: whose formulas it is said to be of, "" if of all.
  const std::vector<Formula> assumed = assumed_positive(task);
  const auto tell = [&](const std::string& inequality, const std::string& of, const std::vector<std::size_t>& asks,
                        const Formula& positive) {
    if (is_assumed_positive(positive, assumed)) return;
    const std::string words = of.empty() ? inequality : inequality + " for " + of;
    if (std::ranges::find(solution.assumptions, words) == solution.assumptions.end())
      solution.assumptions.push_back(words);
    solution.grounds.push_back({words, positive, inequality, asks});
  };
  for (const OneSidedForce& force : grounds.forces)
    if (force.of_state) tell(condition_words(force.value, task.open), "", {}, force.value);
  const auto count = std::ranges::count_if(task.statement.asks, [&](const Ask& ask) {
    const auto i = static_cast<std::size_t>(&ask - task.statement.asks.data());
    return solution.asks[i].formula && is_at_instant(task, ask);
  });
  for (const HeldCondition& condition : held) {
    const std::string words = condition_words(condition.positive, task.open);
    std::vector<std::string> together;
    for (const std::size_t i : condition.asks) {
      if (!solution.asks[i].formula) continue;
      const std::string name = "'" + task.statement.asks[i].name + "'";
      // What stands beside each of several formulas is told of each question by itself.
      if (solution.asks[i].regimes.empty())
        together.push_back(name);
      else
        tell(words, name, {i}, condition.positive);
    }
    // Bounds are of the unknowns, which have formulas even where no answer has.
    const bool of_unknowns = condition.bound && !grounds.unknowns.empty();
    if (together.empty() && !of_unknowns) continue;
    const bool of_all = static_cast<std::ptrdiff_t>(together.size()) == count;
    tell(words, of_all ? "" : listed(together), condition.asks, condition.positive);
  }
  hold_told_conditions(task, solution);
}

}  // namespace poinsot::problem
