#include "problem/formulas/law_search.h"

#include <algorithm>
#include <functional>
#include <map>
#include <set>

#include "poinsot/engine/work/work.h"
#include "poinsot/engine/work/work_scope.h"
#include "problem/formulas/formula_answers.h"
#include "problem/formulas/formula_conditions.h"
#include "problem/formulas/formula_words.h"
#include "problem/formulas/law_reach.h"
#include "problem/formulas/law_regimes.h"
#include "problem/formulas/letter_dimensions.h"
#include "problem/formulas/scaling_law.h"
#include "problem/instant/open_words.h"
#include "problem/language/evaluate_support.h"
#include "problem/language/expression_walk.h"
#include "problem/language/words.h"
#include "problem/results/compare_values.h"
#include "problem/unknowns/asked_value.h"
#include "problem/unknowns/extremum.h"
#include "problem/unknowns/unknown_search.h"

namespace poinsot::problem {
namespace {

constexpr Work most_work_each = 400'000'000;  // of a trial, of which there are some twenty
constexpr Work most_work_of_all = 2'500'000'000;
constexpr const char* takes_too_long = "it takes too long to find it at other values of the letters";
constexpr std::size_t most_changes_each = 50;
constexpr Work least_reach_work = 100'000'000;  // on holding laws far from where they were found
constexpr Work least_regime_search = 400'000'000, regimes_over_reach = 10;  // on finding others there
// A trial there may take so many times the first, and this besides.
constexpr Work slower_there = 6, at_least_there = 5'000'000;

bool has_numbers(const Value<double>& value) {
  if (value.is_list()) return !value.items.empty() && std::ranges::all_of(value.items, has_numbers);
  return value.is_number() || value.is_vector();
}

// Whether all letters are sizes of independent dimensions.
bool make_no_group(const std::vector<Letter>& letters) {
  const std::vector<Units> units{Units::length, Units::mass, Units::time};
  return std::ranges::none_of(letters,
                              [](const Letter& letter) {
                                return letter.either_sign || letter.unit.dimension == dimensions::angle ||
                                       same_kind(letter.unit.dimension, dimensions::none);
                              }) &&
         LetterDimensions(letters, units).pivots().size() == letters.size();
}

std::string road_of(const ScalingLaw& law) {
  std::string road = "by dimensional analysis";
  if (!law.by_trial.empty()) road += " and trials of " + listed(law.by_trial);
  return law.digits == 0 ? road : road + ", with numbers of " + std::to_string(law.digits) + " digits";
}

class LawSearch {
 public:
  LawSearch(const FormulaTask& task, const std::vector<OneSidedForce>& forces, Solution& solution)
      : task_(task), forces_(forces), solution_(solution) {
    if (!task.unknowns.empty() && solution.unknowns.empty())
      for (std::size_t i = 0; i < task.statement.situations.size(); ++i)
        for (const Unknown& unknown : task.unknowns)
          if (is_common(task.statement, unknown.name) ? i == 0 : is_own(task.statement, i, unknown.name))
            unknowns_.push_back({&unknown, i});
    if (std::ranges::all_of(task.statement.asks, [](const Ask& ask) { return is_event(ask); })) return;
    for (std::size_t i = 0; i < task.statement.situations.size(); ++i)
      for (const Instant& instant : task.statement.situations[i].instants)
        if (instant.found_when) events_.push_back({*instant.found_when, i, instant.name});
  }

  void run() {
    const Work begin = work_done();
    std::vector<std::size_t> wanted;
    for (std::size_t i = 0; i < solution_.asks.size(); ++i) {
      const SolvedAsk& ask = solution_.asks[i];
      if (ask.state == AskState::needs_letters && !ask.formula && !task_.statement.asks[i].table &&
          has_numbers(ask.value))
        wanted.push_back(i);
      if (ask.state == AskState::found && !ask.formula && has_numbers(ask.value) &&
          !is_at_instant(task_, task_.statement.asks[i]) && !speaks_of_no_letter(task_, task_.statement.asks[i]))
        fixed_.push_back(i);
    }
    if (wanted.empty() && fixed_.empty()) return;
    const std::map<std::string, double>& checks = solution_.checks;
    error_ = checks.contains("motion_error") ? checks.at("motion_error") : 0;
    // As motion_tolerance in answer_checks.cpp: what is not known as a number tells no law.
    constexpr double followed = 1e-5;
    if (!(error_ <= followed)) return;
    LetterValues base;
    for (const Letter& letter : task_.open) base[letter.name] = task_.settings.front().at(letter.name).number;
    const std::vector<std::string> names = all_letters();
    const Work before = work_done();
    try {
      static_cast<void>(why_no_formula([&] { kept_answers_at(base); }));
    } catch (const StatementError& error) {
      for (const std::size_t i : wanted) solution_.asks[i].no_formula = error.diagnostics().front().message;
      return;
    }
    each_there_ = slower_there * (work_done() - before) + at_least_there;
    ScalingTrials trials(task_.open, base, !task_.unknowns.empty(), error_,
                         [this](const LetterValues& letters) { return kept_answers_at(letters); });
    for (const std::size_t i : wanted) add_law(trials, i);
    for (std::size_t k = 0; k < unknowns_.size(); ++k) add_unknown(trials, k, names);
    for (std::size_t k = 0; k < events_.size(); ++k)
      static_cast<void>(why_no_formula([&] {
        const std::size_t place = solution_.asks.size() + unknowns_.size() + k;
        times_of_events_.push_back({place, scaling_law(trials, place, names).formula, true, {}});
      }));
    hold_far_off(wanted, base, std::max(1e-6, 16 * error_), work_done() - begin);
  }

 private:
  struct Sought {
    const Unknown* unknown;
    std::size_t situation;
  };
  // What happens at an instant of the statement.
  struct Event {
    Expression condition;
    std::size_t situation;
    std::string name;
  };
  // The places of the times of what happens at the instants of an ask.
  std::vector<std::size_t> events_of(const Ask& ask) const {
    std::set<std::string> names;
    for (const Expression& expression : ask.of) collect_instants(expression, names);
    std::vector<std::size_t> places;
    for (std::size_t k = 0; k < events_.size(); ++k)
      if (names.contains(events_[k].name)) places.push_back(solution_.asks.size() + unknowns_.size() + k);
    return places;
  }
  static bool is_event(const Ask& ask) { return ask.when && ask.when->first; }

  std::vector<std::string> all_letters() const {
    std::vector<std::string> names;
    for (const Letter& letter : task_.open) names.push_back(letter.name);
    return names;
  }

  void add_law(ScalingTrials& trials, std::size_t i) {
    SolvedAsk& ask = solution_.asks[i];
    const auto found = [&](const std::vector<std::string>& letters) {
      return why_no_formula([&] {
        const ScalingLaw law = scaling_law(trials, i, letters);
        hold_all_round(trials, i, law);
        by_dimensions_ = by_dimensions_ && law.by_trial.empty();
        ask.formula = law.formula;
        ask.formula_road = road_of(law);
      });
    };
    std::optional<std::string> reason = found(ask.letters);
    // A letter may not matter at the values that were seen: of two the larger counts.
    if (const std::vector<std::string> all = all_letters(); reason && ask.letters.size() < all.size() && !found(all)) {
      reason.reset();
      ask.letters.clear();
      for (const std::string& letter : letters_in(*ask.formula)) ask.letters.push_back(letter);
    }
    ask.no_formula = reason.value_or("");
  }

  // Tries a law at angles all round, as beyond a right angle another extreme may be the largest. If it holds for
  // positive angles only, or could not be tried at some, the solution says so in its assumptions.
  void hold_all_round(ScalingTrials& trials, std::size_t i, const ScalingLaw& law) {
    std::set<std::string> assumed;
    for (const std::string& name : solution_.asks[i].letters) {
      const auto letter = std::ranges::find(task_.open, name, &Letter::name);
      if (letter == task_.open.end() || letter->unit.dimension != dimensions::angle) continue;
      std::string none, untried;
      for (const ScalingTrials::Point& point : trials.turned(name)) {
        const double angle = point.letters.at(name);
        const std::string text = with_digits(angle, 3) + " rad";
        if (point.answers.empty() || !point.answers[i]) {
          std::string& there = point.answers.empty() ? untried : none;
          there += (there.empty() ? "" : ", ") + text;
          continue;
        }
        if (agrees(law.formula, *point.answers[i], point.letters, 1e-6, size_of(*trials.base().answers[i])) ||
            is_beyond(point.letters))
          continue;
        if (angle > 0)
          throw NoFormula("the formula found holds for some values of the letters only, not at " + name + " = " + text);
        assumed.insert(name + " is not negative");
      }
      if (!none.empty()) assumed.insert(name + " is such that there is an answer: none was found at " + none);
      if (!untried.empty()) assumed.insert(name + " is none of these, which could not be tried: " + untried);
    }
    for (const std::string& words : assumed)
      if (std::ranges::find(solution_.assumptions, words) == solution_.assumptions.end())
        solution_.assumptions.push_back(words);
  }

  // Whether a cord would push or a contact pull at an instant with these letters; it is then assumed that none does.
  bool is_beyond(const LetterValues& letters) {
    for (const OneSidedForce& force : forces_) {
      if (!(value_at(force.value, letters) < 0)) continue;
      if (std::ranges::find(solution_.assumptions, force.assumption) == solution_.assumptions.end()) {
        solution_.assumptions.push_back(force.assumption);
        solution_.conditions.push_back({force.assumption, force.value});
      }
      return true;
    }
    return false;
  }

  // Tries the laws, and what is said to be the same for all letters, where letters are far from where they were found.
  // What holds on one side only gets the condition, or is withdrawn.
  void hold_far_off(const std::vector<std::size_t>& wanted, const LetterValues& base, double tolerance, Work spent) {
    std::vector<HeldLaw> laws;
    for (const std::size_t i : wanted)
      if (const Ask& ask = task_.statement.asks[i]; solution_.asks[i].formula)
        laws.push_back({i, *solution_.asks[i].formula, is_event(ask), events_of(ask)});
    for (const std::size_t i : fixed_)
      laws.push_back({i, as_formula(solution_.asks[i].value), false, events_of(task_.statement.asks[i])});
    for (std::size_t k = 0; k < unknowns_.size(); ++k)
      if (const SolvedUnknown* known = listed_unknown(k)) laws.push_back({solution_.asks.size() + k, *known->formula});
    if (laws.empty()) return;
    const std::size_t told = laws.size();
    laws.insert(laws.end(), times_of_events_.begin(), times_of_events_.end());
    double misfit = 0;
    const ScalingTrials::Solve solve = [this](const LetterValues& letters) {
      return within(each_there_, [&] { return kept_answers_at(letters); });
    };
    const ScalingTrials::Solve solve_there = [this](const LetterValues& letters) { return kept_answers_at(letters); };
    const Work most = std::max(spent, least_reach_work);
    const auto sought_in_vain = [this](std::size_t answer, const LetterValues& at) -> std::optional<double> {
      const auto known = in_vain_.find({answer, at});
      return known == in_vain_.end() ? std::nullopt : std::optional(known->second);
    };
    const std::vector<LawReach> reaches =
        reach_of({laws, task_.open, base, solve_there, tolerance, most, each_there_,
                  [this](const LetterValues& letters) { return is_beyond(letters); }, sought_in_vain,
                  by_dimensions_ && fixed_.empty() && make_no_group(task_.open)},
                 misfit);
    laws.resize(told);
    for (std::size_t n = 0; n < told; ++n)
      if (!take_regimes(laws[n], reaches[n], base, solve, tolerance,
                        std::max(regimes_over_reach * most, least_regime_search)))
        take(laws[n], reaches[n]);
    const std::vector<Formula> bounds = stated_bounds(task_, solution_.unknowns);
    for (const Formula& bound : bounds) {
      solution_.assumptions.push_back(condition_words(bound, task_.open));
      solution_.grounds.push_back({solution_.assumptions.back(), bound, solution_.assumptions.back(), {}});
    }
    for (const HeldLaw& law : laws) tell_roots(law, bounds);
    solution_.checks["formulas"] = std::max(solution_.checks["formulas"], misfit);
  }
  // Where roots and inverse functions of a law have values. bounds: what is told to be positive.
  void tell_roots(const HeldLaw& law, const std::vector<Formula>& bounds) {
    if (law.answer >= solution_.asks.size()) return;
    const SolvedAsk& ask = solution_.asks[law.answer];
    if (!ask.formula || ask.formula_road.empty() || !ask.regimes.empty()) return;
    for (const std::string& words : root_conditions_of(*ask.formula, bounds))
      solution_.assumptions.push_back(words + " for '" + task_.statement.asks[law.answer].name + "'");
  }
  // Looks for the laws where the first one fails. Whether all of them were found, with what parts them.
  bool take_regimes(const HeldLaw& first, const LawReach& reach, const LetterValues& base,
                    const ScalingTrials::Solve& solve, double tolerance, Work most) {
    const bool sizes_only = std::ranges::none_of(task_.open, [](const Letter& letter) {
      return letter.either_sign || letter.unit.dimension == dimensions::angle;
    });
    if (!reach.fails || first.answer >= solution_.asks.size() || !task_.unknowns.empty() || !sizes_only) return false;
    SolvedAsk& ask = solution_.asks[first.answer];
    const std::vector<std::string> names = all_letters();
    std::string road = ask.formula_road;
    const auto find = [&](const LetterValues& around) {
      std::optional<Value<Formula>> law;
      static_cast<void>(why_no_formula([&] {
        ScalingTrials trials(task_.open, around, true, error_, solve);
        const ScalingLaw found = scaling_law(trials, first.answer, names);
        law = found.formula;
        if (road.empty()) road = road_of(found);
      }));
      return law;
    };
    const std::optional<Formula> bound = reach.positive.empty() ? std::nullopt : std::optional(reach.positive.back());
    const auto regimes = law_regimes(first, bound, task_.open, base, solve, find, tolerance, most);
    if (!regimes) return false;
    // Where something does not happen no law is told.
    for (const LawRegime& regime : *regimes)
      if (std::ranges::any_of(reach.not_there, [&](const LetterValues& there) {
            return std::ranges::all_of(regime.positive, [&](const Formula& one) { return value_at(one, there) > 0; });
          }))
        return false;
    ask.formula = regimes->front().law;
    ask.formula_road = road;
    ask.state = AskState::needs_letters;
    std::set<std::string> letters;
    for (const LawRegime& regime : *regimes) {
      for (const std::string& letter : letters_in(regime.law)) letters.insert(letter);
      RegimeFormula told{regime.law, {}};
      for (const Formula& positive : regime.positive) {
        for (const std::string& letter : positive.letters()) letters.insert(letter);
        told.where.push_back(condition_words(positive, task_.open));
      }
      if (regimes->size() > 1) ask.regimes.push_back(std::move(told));
    }
    if (!ask.regimes.empty())
      for (const std::string& words : ask.regimes.front().where)
        solution_.assumptions.push_back(words + " for '" + task_.statement.asks[first.answer].name + "'");
    ask.letters.assign(letters.begin(), letters.end());
    return true;
  }
  void take(const HeldLaw& law, const LawReach& reach) {
    const bool of_ask = law.answer < solution_.asks.size();
    const std::string name =
        of_ask ? task_.statement.asks[law.answer].name : unknowns_[law.answer - solution_.asks.size()].unknown->name;
    if (reach.told || !reach.fails)
      for (const Formula& positive : reach.positive) {
        const bool of_time = law.of_event || !law.at_events.empty();
        const std::string words = of_time ? condition_words(positive, task_.open) : formula_words(positive) + " > 0";
        solution_.assumptions.push_back(words + " for '" + name + "'");
        solution_.grounds.push_back({solution_.assumptions.back(), positive, words, {}});
        if (of_ask) solution_.grounds.back().asks = {law.answer};
      }
    if (reach.told && reach.untried.empty()) return;
    if (!reach.told && !reach.fails) {
      solution_.assumptions.push_back("the letters are such that there is an answer to '" + name +
                                      "': there is none at " + values_in_words(task_.open, reach.not_there.front()));
      return;
    }
    if (!of_ask) {
      const SolvedUnknown* withdrawn = listed_unknown(law.answer - solution_.asks.size());
      std::erase_if(solution_.unknowns, [&](const SolvedUnknown& known) { return &known == withdrawn; });
      return;
    }
    SolvedAsk& ask = solution_.asks[law.answer];
    ask.no_formula = reach.fails ? "what was found holds for some values of the letters only, not at " +
                                       values_in_words(task_.open, *reach.fails)
                                 : "what was found does not hang on " + reach.untried +
                                       " nearby, but there is no answer at much larger and smaller ones to confirm it";
    ask.formula.reset();
    ask.formula_road.clear();
    ask.state = AskState::needs_letters;
    if (ask.letters.empty()) ask.letters = all_letters();
    if (!reach.hangs_on.empty()) add_once(ask.letters, reach.hangs_on);
  }
  const SolvedUnknown* listed_unknown(std::size_t k) const {
    const auto found = std::ranges::find_if(solution_.unknowns, [&](const SolvedUnknown& known) {
      return known.own_name == unknowns_[k].unknown->name && known.formula && !known.formula_road.empty() &&
             (!known.situation || *known.situation == unknowns_[k].situation);
    });
    return found == solution_.unknowns.end() ? nullptr : &*found;
  }

  void add_unknown(ScalingTrials& trials, std::size_t k, const std::vector<std::string>& letters) {
    const Unknown& unknown = *unknowns_[k].unknown;
    const std::size_t situation = unknowns_[k].situation;
    // The asks report why there is no law.
    static_cast<void>(why_no_formula([&] {
      const ScalingLaw law = scaling_law(trials, solution_.asks.size() + k, letters);
      by_dimensions_ = by_dimensions_ && law.by_trial.empty();
      SolvedUnknown solved{unknown.name, unknown.unit, task_.settings[situation].at(unknown.name), law.formula};
      if (!is_common(task_.statement, unknown.name)) {
        solved.name += " @ " + task_.statement.situations[situation].name;
        solved.situation = situation;
      }
      solved.formula_road = road_of(law);
      solution_.unknowns.push_back(std::move(solved));
    }));
  }

  // What was found at the same letters before is not found again.
  ScalingTrials::Answers kept_answers_at(const LetterValues& letters) {
    const auto known = kept_.find(letters);
    return known != kept_.end() ? known->second : (kept_[letters] = bounded_answers_at(letters));
  }
  ScalingTrials::Answers bounded_answers_at(const LetterValues& letters) {
    if (work_done() - begin_ > most_work_of_all) throw NoFormula(takes_too_long);
    return within(most_work_each, [&] { return answers_at(letters); });
  }
  // What find returns if it takes no more work.
  static ScalingTrials::Answers within(Work most, const std::function<ScalingTrials::Answers()>& find) {
    try {
      const WorkScope scope(most);
      return find();
    } catch (const BudgetEnded&) {
      // Either this takes too long, or the caller waits no longer.
      check_budget();
      throw NoFormula(takes_too_long);
    }
  }
  bool seeks_ends() const {
    return std::ranges::any_of(task_.statement.asks, [](const Ask& ask) { return ask.extremum.has_value(); });
  }
  // The answers of the asks, followed by the unknowns.
  ScalingTrials::Answers answers_at(const LetterValues& letters) {
    ScalingTrials::Answers answers(solution_.asks.size() + unknowns_.size() + events_.size());
    const std::optional<AllSettings> settings = settings_at(letters);
    if (!settings || !is_assumed(task_.statement, *settings))
      fail(task_.statement.file, {1, 1}, "nothing is found at other values of the letters, or they are not assumed");
    const OpenChoice choice{.most_changes = most_changes_each};
    Sample sample(task_.statement, *settings, choice);
    sample.write_down_what_is_told();
    // A law of a motion is one of the states in which it begins; ends of states lie between several.
    if (task_.has_friction() && !seeks_ends() && !sample.contact_states_hold())
      fail(task_.statement.file, {1, 1}, "there the contacts with friction are in other states");
    for (std::size_t i = 0; i < solution_.asks.size(); ++i) {
      const Ask& ask = task_.statement.asks[i];
      const bool fixed = std::ranges::find(fixed_, i) != fixed_.end();
      if ((solution_.asks[i].state != AskState::needs_letters && !fixed) || ask.table) continue;
      try {
        answers[i] = ask.extremum ? ExtremumSearch(task_.statement, ask, *settings, choice).find().value
                                  : asked_value(sample, ask);
        // Modes are a table of numbers of several kinds.
        if (is_record(*answers[i]) || records_of(*answers[i])) answers[i].reset();
      } catch (const NotHappeningError& error) {
        in_vain_[{i, letters}] = error.until();
      } catch (const StatementError&) {
        continue;
      }
    }
    for (std::size_t k = 0; k < unknowns_.size(); ++k)
      answers[solution_.asks.size() + k] = (*settings)[unknowns_[k].situation].at(unknowns_[k].unknown->name);
    for (std::size_t k = 0; k < events_.size(); ++k) try {
        const double time =
            sample.motion(events_[k].situation).times(events_[k].condition, std::nullopt, 0, {}).front();
        answers[solution_.asks.size() + unknowns_.size() + k] = Value<double>::of_number(time, dimensions::time);
      } catch (const StatementError&) {
        // What it then is at that instant has no answer either.
      }
    if (!confirmed_by_particles(sample)) throw NoFormula("the check on particles does not confirm its numbers");
    return answers;
  }

  // The settings at these letters, with the unknowns; nothing unless there are as many roots as at the first letters.
  std::optional<AllSettings> settings_at(const LetterValues& letters) {
    AllSettings settings = task_.settings;
    for (AllSettings::value_type& one : settings)
      for (const Letter& letter : task_.open)
        one[letter.name] = Value<double>::of_number(letters.at(letter.name), letter.unit.dimension);
    if (task_.unknowns.empty()) return settings;
    Settings known = task_.known;
    for (const Letter& letter : task_.open) known[letter.name] = settings.front().at(letter.name);
    RootsFound found;
    try {
      found = UnknownSearch(task_.statement, task_.known).find(known);
    } catch (const StatementError&) {
      return std::nullopt;
    }
    if (!found.open.empty()) return std::nullopt;
    if (!root_) {
      for (std::size_t k = 0; k < found.roots.size(); ++k)
        if (is_root(found.roots[k])) root_ = k;
      roots_ = found.roots.size();
    }
    if (!root_ || found.roots.size() != roots_) return std::nullopt;
    return found.roots[*root_];
  }
  bool is_root(const AllSettings& root) const {
    for (std::size_t i = 0; i < root.size(); ++i)
      for (const Unknown& unknown : task_.unknowns) {
        const auto known = task_.settings[i].find(unknown.name), here = root[i].find(unknown.name);
        if (known == task_.settings[i].end() || here == root[i].end()) continue;
        if (!same(known->second, here->second, 1e-6 * size_of(known->second))) return false;
      }
    return true;
  }

  const FormulaTask& task_;
  const std::vector<OneSidedForce>& forces_;
  Solution& solution_;
  std::vector<Sought> unknowns_;
  std::vector<Event> events_;  // whose times tell where what is asked at their instants has an answer
  std::vector<HeldLaw> times_of_events_;
  // How far it was looked, by the place of an answer and the letters, for what does not happen.
  std::map<std::pair<std::size_t, LetterValues>, double> in_vain_;
  std::vector<std::size_t> fixed_;   // asks over a motion that no letter was seen to change
  std::optional<std::size_t> root_;  // the index of this solution's root, in ascending order
  std::size_t roots_ = 0;
  double error_ = 0;           // of the motion
  bool by_dimensions_ = true;  // whether no law that was found needed trials
  const Work begin_ = work_done();
  Work each_there_ = 0;
  std::map<LetterValues, ScalingTrials::Answers> kept_;
};

}  // namespace

void find_laws(const FormulaTask& task, const std::vector<OneSidedForce>& forces, Solution& solution) {
  LawSearch(task, forces, solution).run();
}

void tell_laws(const Statement& statement, Solution& solution) {
  std::map<std::string, std::vector<std::string>> found_by;
  const auto add = [&](const std::string& name, const std::string& road) {
    if (road.empty()) return;
    std::vector<std::string>& names = found_by[road];
    if (std::ranges::find(names, name) == names.end()) names.push_back(name);
  };
  for (std::size_t i = 0; i < solution.asks.size(); ++i) add(statement.asks[i].name, solution.asks[i].formula_road);
  for (const SolvedUnknown& unknown : solution.unknowns) add(unknown.name, unknown.formula_road);
  for (const auto& [road, names] : found_by) solution.notes.push_back(listed(names) + " " + road);
}

}  // namespace poinsot::problem
