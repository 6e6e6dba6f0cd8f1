#include "problem/formulas/formula_search.h"

#include <algorithm>
#include <memory>
#include <random>
#include <set>

#include "poinsot/engine/math/formula/formula_domain.h"
#include "poinsot/engine/math/formula/formula_sign.h"
#include "problem/formulas/formula_conditions.h"
#include "problem/formulas/formula_unknowns.h"
#include "problem/formulas/law_search.h"
#include "problem/plane/planar_words.h"
#include "problem/quantities/quantity_functions.h"
#include "problem/results/compare_values.h"
#include "problem/unknowns/asked_value.h"
#include "problem/unknowns/unknown_ranges.h"
#include "problem/unknowns/unknown_search.h"

namespace poinsot::problem {
namespace {

constexpr int draws = 2;                    // random points at which every formula is checked, besides the first
constexpr int most_attempts = 30;           // attempts to draw a point at which the statement makes sense
constexpr double formula_tolerance = 1e-8;  // relative difference allowed between formula and numbers
constexpr double rounding_of_natural = 1e-14;
constexpr double unknown_tolerance = 1e-7;  // the same for unknowns, which are found by a search

// The letter for an unknown or for one of its components.
std::string letter_of(const Statement& statement, const std::string& unknown, std::size_t situation,
                      const std::string& component = "") {
  const std::string name =
      is_common(statement, unknown) ? unknown : unknown + "_" + statement.situations[situation].name;
  return component.empty() ? name : name + "_" + component;
}

// The statement solved at some values of the letters.
struct Checkpoint {
  LetterValues letters;
  Sample* sample = nullptr;
  std::unique_ptr<Sample> owned;
};

class FormulaSearch {
 public:
  FormulaSearch(const FormulaTask& task, Solution& solution)
      : task_(task), solution_(solution), values_(values_of(task)), answers_(task.statement, values_, task.sample) {}

  void run() {
    checkpoints_.push_back({letters_of(task_.settings.front()), &task_.sample, nullptr});
    if (const auto reason = why_no_formula([&] { find_unknowns(); })) {
      for (SolvedAsk& ask : solution_.asks)
        if (ask.state == AskState::needs_letters) ask.no_formula = *reason;
      return;
    }
    grounds_.signs.resize(task_.statement.asks.size());
    std::set<std::string> assumptions;
    for (const UnknownFormula& unknown : grounds_.unknowns)
      for (const std::string& assumption : assumptions_of(unknown.value)) assumptions.insert(assumption);
    const ProgressTeller progress("looking for formulas");
    const std::size_t count = task_.statement.asks.size();
    for (std::size_t i = 0; i < count; ++i) {
      progress.tell(static_cast<double>(i) / static_cast<double>(count), i);
      SolvedAsk& ask = solution_.asks[i];
      if (ask.state != AskState::found && ask.state != AskState::needs_letters) continue;
      const auto reason = why_no_formula([&] {
        if (is_word(ask.value) || is_decided_truth(task_.statement.asks[i], ask.value)) return decide_word(i);
        Value<Formula> formula = formula_of_ask(i);
        for (const std::string& assumption : assumptions_of(formula)) assumptions.insert(assumption);
        ask.formula = std::move(formula);
        decide_by_formula(ask);
      });
      if (reason) ask.no_formula = *reason;
    }
    solution_.assumptions.assign(assumptions.begin(), assumptions.end());
    for (const Formula& leading : leading_) tell_not_zero(leading, "", {});
    for (const auto& [i, positive] : strict_)
      tell_positive(positive, count == 1 ? "" : " for '" + task_.statement.asks[i].name + "'", {i});
  }

  // That a formula does not vanish. of: of which answers, in words, and their places; of all if none are named.
  void tell_not_zero(const Formula& x, const std::string& of, const std::vector<std::size_t>& asks) {
    const std::vector<Formula> assumed = assumed_positive(task_);
    for (const auto& [words, factor] : not_zero_conditions(numerator(x), task_.open))
      if (!is_assumed_positive(factor, assumed) && !is_assumed_positive(-factor, assumed))
        tell(words, of, factor * factor, asks);
  }
  void tell_positive(const Formula& x, const std::string& of, const std::vector<std::size_t>& asks) {
    if (seen_sign(x).sign > 0) return tell_not_zero(x, of, asks);
    tell(condition_words(x, task_.open), of, x, asks);
  }
  // What is told of all answers need not be told of some.
  void tell(const std::string& words, const std::string& of, const Formula& positive,
            const std::vector<std::size_t>& asks) {
    for (const std::string& told : {words, words + of})
      if (std::ranges::find(solution_.assumptions, told) != solution_.assumptions.end()) return;
    solution_.assumptions.push_back(words + of);
    solution_.grounds.push_back({words + of, positive, "", asks});
  }

  FormulaGrounds grounds() {
    // A law of a motion need not hold where a cord would push or a contact pull at its start.
    if (acts_on_one_side(task_.statement) && std::ranges::any_of(solution_.asks, [](const SolvedAsk& ask) {
          return ask.state == AskState::needs_letters && !ask.formula;
        }))
      static_cast<void>(why_no_formula([&] { answers_.solve_all(); }));
    std::vector<OneSidedForce> forces = answers_.one_sided_forces();
    answers_.add_approaches(forces);
    for (OneSidedForce& force : forces) {
      try {
        force.value = substituted(force.value, unknowns_);
        grounds_.forces.push_back(std::move(force));
      } catch (const std::domain_error&) {
        // With the formulas of the unknowns it has no value.
      }
    }
    const auto reason = why_no_formula([&] { answers_.add_state_conditions(grounds_.forces); });
    withheld_ = reason.has_value();
    if (reason) withhold_formulas(task_, solution_, "the conditions of its contacts have no formulas: " + *reason);
    return std::move(grounds_);
  }
  // Whether formulas would be told outside the state of the contacts in which they hold. So would laws.
  bool withheld() const { return withheld_; }

 private:
  Value<Formula> formula_of_ask(std::size_t i) {
    const Ask& ask = task_.statement.asks[i];
    const DecidedFormula found = answers_of(ask).value(ask);
    Value<Formula> formula = in_letters(found.value);
    require_no_remainders();
    grounds_.signs[i] = positive(found.signs);
    confirm(formula, i);
    return formula;
  }

  // That a motion is steady shows only with the unknowns as they were found.
  FormulaAnswers& answers_of(const Ask& ask) {
    if (unknowns_.empty() || std::ranges::none_of(ask.of, asks_stability)) return answers_;
    if (!found_answers_) {
      found_values_ = values_;
      for (FormulaValues& values : found_values_)
        for (auto& [name, value] : values) value = in_letters(value);
      found_answers_.emplace(task_.statement, found_values_, task_.sample);
    }
    return *found_answers_;
  }

  void require_no_remainders() const {
    const std::vector<Formula> remainders = answers_.remainders();
    if (std::any_of(remainders.begin(), remainders.end(),
                    [&](const Formula& rest) { return !substituted(rest, unknowns_).is_zero(); }))
      throw NoFormula("what is stated holds for special values of the letters only");
  }

  // A word is the same for all letters if no sign that decides it can change.
  void decide_word(std::size_t i) {
    SolvedAsk& ask = solution_.asks[i];
    const std::vector<Formula> decided = answers_of(task_.statement.asks[i]).signs_of_word(task_.statement.asks[i]);
    require_no_remainders();
    if (std::ranges::any_of(decided, [&](const Formula& x) { return substituted(x, unknowns_).is_zero(); }))
      throw NoFormula("both sides are the same whatever the letters are");
    const std::vector<Formula> signs = positive(decided);
    const bool assuming = std::ranges::any_of(task_.statement.situations,
                                              [](const Situation& situation) { return !situation.assume.empty(); });
    std::vector<Formula> open, strict;
    for (const Formula& sign : signs) {
      const SeenSign seen = seen_sign(sign);
      if (seen.sign > 0 && !seen.strict) strict.push_back(sign);
      if (seen.sign > 0) continue;
      if (const std::optional<Formula> inside = inside_behind(sign, grounds_.unknowns))
        strict.push_back(*inside);
      else
        open.push_back(sign);
    }
    if (!open.empty() && !(assuming && positive_where_assumed(task_, open, !ask.value.is_boolean())))
      throw NoFormula(assuming ? "it is not the same for all letters that are assumed"
                               : "it is not the same for all letters");
    while (checkpoints_.size() <= draws) draw();
    for (const Checkpoint& point : checkpoints_)
      if (is_assumed(task_.statement, point.sample->settings()) &&
          !same(ask.value, asked_value(*point.sample, task_.statement.asks[i]), 0))
        throw NoFormula("it is not the same for all letters");
    for (const Formula& one : strict) strict_.emplace_back(i, one);
    ask.letters.clear();
    ask.state = AskState::found;
  }

  // What was decided, in letters and such that it is positive where it was.
  std::vector<Formula> positive(const std::vector<Formula>& signs) const {
    std::vector<Formula> all;
    for (const Formula& sign : signs) {
      Formula one = substituted(sign, unknowns_);
      if (one.is_number()) continue;
      if (plain(one) < 0) one = -one;
      if (std::find(all.begin(), all.end(), one) == all.end()) all.push_back(std::move(one));
    }
    return all;
  }
  // Whether what was decided for an ask is so at other values of the letters.
  bool decided_alike(std::size_t i, const LetterValues& letters) const {
    return std::all_of(grounds_.signs[i].begin(), grounds_.signs[i].end(),
                       [&](const Formula& sign) { return value_at(sign, letters) > 0; });
  }

  // Whether the formulas of the unknowns solve the conditions with this sign alone.
  bool rests_on_sign(std::size_t k) const {
    std::vector<DecidedSign> other = decided_;
    other[k].sign = -other[k].sign;
    return std::ranges::any_of(answers_.remainders(), [&](const Formula& rest) {
      try {
        return !poinsot::substituted(with_signs(rest, other), unknowns_).is_zero();
      } catch (const std::domain_error&) {
        return true;
      }
    });
  }
  // The bounds of the unknowns: those on which the signs in their conditions rest, those that are stated, and those of
  // what is never negative.
  void find_bounds() {
    const auto add = [&](const Formula& positive) {
      const Formula bound = bound_without_inverse(substituted(positive, unknowns_));
      if (!bound.is_number() && plain(bound) > 0 && seen_sign(bound).sign <= 0 &&
          std::find(grounds_.bounds.begin(), grounds_.bounds.end(), bound) == grounds_.bounds.end())
        grounds_.bounds.push_back(bound);
    };
    for (std::size_t k = 0; k < decided_.size(); ++k)
      if (rests_on_sign(k)) add(decided_[k].positive());
    for (std::size_t i = 0; i < task_.statement.situations.size(); ++i) {
      for (const Expression& condition : task_.statement.situations[i].where) {
        const Comparison* comparison = condition.as<Comparison>();
        for (std::size_t k = 0; comparison && k < comparison->relations.size(); ++k) try {
            const Formula rise = answers_.at_start(i, comparison->operands[k + 1]).value.number -
                                 answers_.at_start(i, comparison->operands[k]).value.number;
            const Relation relation = comparison->relations[k];
            add(relation == Relation::less || relation == Relation::less_equal ? rise : -rise);
          } catch (const NoFormula&) {
            // Such a bound is looked at by numbers.
          } catch (const std::domain_error&) {
          }
      }
    }
    for_each_unknown([&](const Unknown& unknown, std::size_t situation, const std::string&) {
      if (!unknown.vector && is_never_negative(task_.statement, task_.statement.situations[situation], unknown))
        add(value_of(task_.statement, unknown, situation).number);
    });
  }

  // What an answer depends on, and what of it is zero, its formula knows exactly. Numbers cannot tell a letter that
  // matters little from one that does not matter.
  void decide_by_formula(SolvedAsk& ask) const {
    const std::vector<std::string> of_formula = letters_in(*ask.formula);
    ask.letters.clear();
    for (const Letter& letter : task_.open)
      if (std::find(of_formula.begin(), of_formula.end(), letter.name) != of_formula.end())
        ask.letters.push_back(letter.name);
    ask.state = ask.letters.empty() ? AskState::found : AskState::needs_letters;
    if (ask.state == AskState::found) take_zeros(*ask.formula, ask.value);
  }

  void find_unknowns() {
    if (task_.unknowns.empty()) return;
    for (const Situation& situation : task_.statement.situations) {
      if (!situation.choose.empty()) throw NoFormula("what is to be chosen is found by numbers");
      if (situation.instants.size() > 1 && !situation.has_blow())
        throw NoFormula("what is stated of later instants is followed by numbers");
    }
    answers_.solve_all();
    std::vector<UnknownLetter> letters;
    for_each_unknown([&](const Unknown& unknown, std::size_t situation, const std::string& name) {
      const Value<double>& value = task_.settings[situation].at(unknown.name);
      const bool angle = unknown.unit.dimension == dimensions::angle;
      double natural = 0;
      for (const auto& [home, instant] : task_.sample.instants())
        natural = std::max(natural, instant->natural_size(unknown.unit.dimension));
      if (!unknown.vector) letters.push_back({name, angle, value.number, natural});
      if (!unknown.vector) return;
      for (const std::size_t k : sought_components(unknown, task_.statement.situations.front().plane))
        letters.push_back({component_name(unknown, situation, k), angle, value.vector[k], natural});
    });
    std::vector<Formula> remainders = answers_.remainders();
    decided_ = signs_of_unknowns(remainders, letters);
    for (Formula& remainder : remainders) remainder = with_signs(remainder, decided_);
    unknowns_ = solve_unknowns(std::move(remainders), std::move(letters), &leading_);
    for_each_unknown([&](const Unknown& unknown, std::size_t situation, const std::string&) {
      SolvedUnknown solved{unknown.name, unknown.unit, task_.settings[situation].at(unknown.name)};
      if (!is_common(task_.statement, unknown.name)) {
        solved.name += " @ " + task_.statement.situations[situation].name;
        solved.situation = situation;
      }
      solved.formula = in_letters(value_of(task_.statement, unknown, situation));
      found_.push_back(std::move(solved));
    });
    while (checkpoints_.size() <= draws) draw();
    for (const SolvedUnknown& one : found_) grounds_.unknowns.push_back({one.own_name, one.situation, *one.formula});
    solution_.unknowns = found_;
    find_bounds();
  }

  // Visits each unknown once, or once for each situation if it belongs to situations.
  template <class Visit>
  void for_each_unknown(const Visit& visit) const {
    for (std::size_t i = 0; i < task_.statement.situations.size(); ++i)
      for (const Unknown& unknown : task_.unknowns) {
        const bool common = is_common(task_.statement, unknown.name);
        if (common ? i == 0 : is_own(task_.statement, i, unknown.name))
          visit(unknown, i, letter_of(task_.statement, unknown.name, i));
      }
  }
  std::string component_name(const Unknown& unknown, std::size_t situation, std::size_t k) const {
    return letter_of(task_.statement, unknown.name, situation, std::to_string(k + 1));
  }
  static Value<Formula> value_of(const Statement& statement, const Unknown& unknown, std::size_t situation) {
    const auto letter = [](const std::string& name) { return Formula::letter(name, poinsot::Sign::real); };
    if (!unknown.vector)
      return Value<Formula>::of_number(letter(letter_of(statement, unknown.name, situation)), unknown.unit.dimension);
    Vector3<Formula> vector = Vector3<Formula>::zero();
    for (const std::size_t k : sought_components(unknown, statement.situations.front().plane))
      vector[k] = letter(letter_of(statement, unknown.name, situation, std::to_string(k + 1)));
    return Value<Formula>::of_vector(vector, unknown.unit.dimension);
  }
  Value<Formula> in_letters(const Value<Formula>& formula) const {
    return unknowns_.empty() ? formula : with_sizes(substituted(formula, unknowns_), grounds_.bounds);
  }
  Formula substituted(const Formula& formula, const std::map<std::string, Formula>& letters) const {
    return letters.empty() ? formula : poinsot::substituted(with_signs(formula, decided_), letters);
  }
  Value<Formula> substituted(const Value<Formula>& formula, const std::map<std::string, Formula>& letters) const {
    return problem::substituted(with_signs(formula, decided_), letters);
  }

  void confirm(const Value<Formula>& formula, std::size_t i) {
    const Ask& ask = task_.statement.asks[i];
    while (checkpoints_.size() <= draws) draw();
    for (const Checkpoint& point : checkpoints_) {
      // Where another branch is taken, this formula says nothing.
      if (&point != &checkpoints_.front() && !decided_alike(i, point.letters)) continue;
      bool same = false;
      try {
        const double tolerance = task_.unknowns.empty() ? formula_tolerance : unknown_tolerance;
        same = agrees(formula, asked_value(*point.sample, ask), point.letters, tolerance, natural_at(point, i)) &&
               confirmed_by_particles(*point.sample);
      } catch (const StatementError& error) {
        throw NoFormula("it cannot be checked: " + error.diagnostics().front().message);
      }
      if (!same) throw NoFormula("the formula found does not agree with numbers everywhere");
    }
  }

  // The size beside which an answer is compared: of what is asked, but of the whole instant for what is rounding there.
  double natural_at(const Checkpoint& point, std::size_t i) const {
    const Ask& ask = task_.statement.asks[i];
    const Value<double> value = asked_value(*point.sample, ask);
    const double of_all = point.sample->instant_of(ask).natural_size(dimension_of(value));
    return size_of(value) <= rounding_of_natural * of_all ? std::max(of_all, task_.natural[i]) : task_.natural[i];
  }

  // What a motion tells has no formula here, and need not have an answer where the letters are drawn: a ball that rolls
  // downhill goes as far as one likes.
  bool at_instant(std::size_t i) {
    if (at_instant_.empty())
      for (const Ask& ask : task_.statement.asks) at_instant_.push_back(is_at_instant(task_, ask));
    return at_instant_[i];
  }

  // Solves the statement at random values of the letters.
  void draw() {
    for (int attempt = 0; attempt < most_attempts; ++attempt) {
      AllSettings settings = task_.settings;
      for (const Letter& letter : task_.open) {
        const double value = task_.drawn(letter, random_);
        for (Settings& one : settings) one[letter.name] = Value<double>::of_number(value, letter.unit.dimension);
      }
      if (!task_.unknowns.empty()) {
        try {
          const std::optional<AllSettings> root = root_near(settings.front());
          if (!root) continue;
          settings = *root;
        } catch (const StatementError&) {
          // The statement makes no sense there.
          continue;
        }
      }
      auto sample = std::make_unique<Sample>(task_.statement, settings, OpenChoice{});
      sample->write_down_what_is_told();
      bool makes_sense = true;
      try {
        for (std::size_t i = 0; i < task_.statement.asks.size(); ++i)
          if (solution_.asks[i].state != AskState::undetermined && at_instant(i))
            asked_value(*sample, task_.statement.asks[i]);
        makes_sense = sample->contact_states_hold();
      } catch (const StatementError&) {
        makes_sense = false;
      }
      if (!makes_sense) continue;
      Checkpoint point{letters_of(settings.front()), sample.get(), nullptr};
      point.owned = std::move(sample);
      checkpoints_.push_back(std::move(point));
      return;
    }
    throw NoFormula("no other values of the letters were found at which the statement makes sense");
  }

  // The root, at other values of the letters, that agrees with the formulas of the unknowns; nothing if there is no
  // root. Throws NoFormula if there are roots but none agrees.
  std::optional<AllSettings> root_near(const Settings& with_letters) const {
    Settings settings = task_.known;
    for (const Letter& letter : task_.open) settings[letter.name] = with_letters.at(letter.name);
    UnknownSearch search(task_.statement, task_.known);
    RootsFound found;
    try {
      found = search.find(settings);
    } catch (const StatementError&) {
      return std::nullopt;
    }
    const LetterValues letters = letters_of(settings);
    for (const AllSettings& root : found.roots) {
      bool same = true;
      for_each_unknown([&](const Unknown& unknown, std::size_t situation, const std::string&) {
        const Value<Formula> formula = in_letters(value_of(task_.statement, unknown, situation));
        same = same && agrees(formula, root[situation].at(unknown.name), letters, unknown_tolerance, 0);
      });
      if (same) return root;
    }
    // Where a sign on which the formulas rest is another one the roots are others, and a search passes over some.
    if (found.roots.empty() || std::ranges::any_of(decided_, [&](const DecidedSign& decided) {
          return !(value_at(poinsot::substituted(decided.positive(), unknowns_), letters) > 0);
        }))
      return std::nullopt;
    const AllSettings root = with_unknowns(AllSettings(task_.settings.size(), settings), found_, letters);
    if (!search.still_holds(root, OpenChoice{}))
      throw NoFormula("the formulas found for the unknowns are no root everywhere");
    return root;
  }

  static std::vector<FormulaValues> values_of(const FormulaTask& task) {
    std::vector<FormulaValues> all;
    for (std::size_t i = 0; i < task.statement.situations.size(); ++i) {
      const Situation& situation = task.statement.situations[i];
      FormulaValues values = task.given;
      for (const Letter& letter : situation.letters)
        if (!values.contains(letter.name)) values[letter.name] = formula_of(letter);
      for (const Unknown& unknown : task.unknowns)
        if (is_common(task.statement, unknown.name) || is_own(task.statement, i, unknown.name))
          values[unknown.name] = value_of(task.statement, unknown, i);
      all.push_back(std::move(values));
    }
    return all;
  }

  LetterValues letters_of(const Settings& settings) const {
    LetterValues values;
    for (const Letter& letter : task_.open) values[letter.name] = settings.at(letter.name).number;
    return values;
  }

  const FormulaTask& task_;
  Solution& solution_;
  std::map<std::string, Formula> unknowns_;
  std::vector<SolvedUnknown> found_;
  std::vector<DecidedSign> decided_;                     // in what must vanish, as at the first solution
  std::vector<Formula> leading_;                         // what must not vanish in these formulas, as in solve_unknowns
  std::vector<std::pair<std::size_t, Formula>> strict_;  // what is positive, and not only not negative, for a word
  std::vector<FormulaValues> values_;
  FormulaAnswers answers_;
  std::vector<FormulaValues> found_values_;  // with the formulas of the unknowns
  std::optional<FormulaAnswers> found_answers_;
  FormulaGrounds grounds_;
  std::vector<Checkpoint> checkpoints_;
  std::vector<bool> at_instant_;  // of each ask, whether it is one of an instant that no motion leads to
  std::mt19937_64 random_{4000};
  bool withheld_ = false;
};

}  // namespace

FormulaGrounds find_formulas(const FormulaTask& task, Solution& solution) {
  const FormulaLimitScope limits({most_formula_terms, most_formula_work});
  const Work begin = work_done();
  // Signs that are decided on the way are decided as at the numbers of the first solution.
  LetterValues point;
  for (const Letter& letter : task.open) point[letter.name] = task.settings.front().at(letter.name).number;
  for (std::size_t i = 0; i < task.settings.size(); ++i)
    for (const Unknown& unknown : task.unknowns) {
      const auto value = task.settings[i].find(unknown.name);
      if (value == task.settings[i].end()) continue;
      point[letter_of(task.statement, unknown.name, i)] = value->second.number;
      for (std::size_t k = 0; unknown.vector && k < 3; ++k)
        point[letter_of(task.statement, unknown.name, i, std::to_string(k + 1))] = value->second.vector[k];
    }
  const PlainPointScope decisions(std::move(point));
  FormulaSearch search(task, solution);
  search.run();
  FormulaGrounds grounds = search.grounds();
  grounds.work = work_done() - begin;
  if (!search.withheld()) find_laws(task, grounds.forces, solution);
  return grounds;
}

}  // namespace poinsot::problem
