#include "problem/formulas/formula_reach.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "poinsot/engine/math/formula/formula_exponential.h"
#include "poinsot/engine/math/formula/formula_sign.h"
#include "poinsot/engine/work/work.h"
#include "problem/formulas/formula_answers.h"
#include "problem/formulas/formula_conditions.h"
#include "problem/formulas/letter_scan.h"
#include "problem/language/expression_walk.h"
#include "problem/machine/machine.h"
#include "problem/machine/masses.h"
#include "problem/quantities/quantity_functions.h"
#include "problem/results/compare_values.h"
#include "problem/unknowns/asked_value.h"

namespace poinsot::problem {
namespace {

constexpr std::size_t most_points = 24;        // at which the statement is solved by numbers
constexpr std::size_t most_scanned = 10;       // of these, where all letters are far from their ordinary values
constexpr std::size_t most_near = 8;           // of these, where all are near them: far off there may be no such body
constexpr std::size_t condition_points = 250;  // at which the formula of a condition is looked at
constexpr int most_confirmations = 12;         // of what it shows, by numbers
constexpr double branch_tolerance = 1e-6;  // relative difference of answers from which they are on different branches
// The search far off may take as much as the formulas took, and this in any case.
constexpr Work least_far_work = 20'000'000;
constexpr Work most_far_work = 400'000'000;

// A point at which letters have values far from the ordinary. `only` names the letter if it is a single one.
struct FarPoint {
  LetterValues letters;
  std::string only;
};

std::vector<FarPoint> far_points(const std::vector<Letter>& open, const LetterValues& base, const LetterScan& scan) {
  std::vector<FarPoint> single;
  for (const Letter& letter : open) {
    const auto moved = [&](double value) {
      FarPoint point{base, letter.name};
      point.letters[letter.name] = value;
      single.push_back(std::move(point));
    };
    const double value = base.at(letter.name);
    if (is_angle(letter)) {
      for (const double quadrant : {2.3, -2.2, -0.8}) moved(quadrant);
      continue;
    }
    for (const double far : {1e2, 1e-2, 1e4, 1e-4}) moved(far * value);
    if (letter.either_sign) moved(-value);
  }
  std::vector<FarPoint> points;
  for (std::size_t k = 0; k < most_scanned; ++k) points.push_back({scan.point(k), ""});
  for (std::size_t k = 0; k < most_near; ++k) points.push_back({scan.near(k), ""});
  if (points.size() + single.size() > most_points) {
    std::mt19937_64 random(6100);
    std::shuffle(single.begin(), single.end(), random);
    single.resize(most_points - points.size());
  }
  points.insert(points.end(), single.begin(), single.end());
  return points;
}

class FarSearch {
 public:
  FarSearch(const FormulaTask& task, const FormulaGrounds& grounds, Solution& solution)
      : task_(task),
        solution_(solution),
        grounds_(grounds),
        base_(letters_of(task)),
        scan_(task.open, base_),
        limit_(std::clamp(grounds.work, least_far_work, most_far_work)) {}

  std::vector<HeldCondition> run() {
    for (const Ask& ask : task_.statement.asks) at_instant_.push_back(is_at_instant(task_, ask));
    collect_conditions();
    for (const FarPoint& point : far_points(task_.open, base_, scan_)) {
      if (limit_.spent()) break;
      hold_at(point, {});
    }
    if (has_formulas())
      for (const OneSidedForce& force : grounds_.forces)
        if (!force.of_state) look_where_negative(force);
    for (std::size_t k = 0; k < conditions_.size(); ++k) look_where_it_fails(k);
    for (const std::vector<std::size_t>& any : doubtful_)
      if (std::ranges::none_of(any, [&](std::size_t k) { return conditions_[k].needed; }))
        for (const std::size_t k : any) conditions_[k].needed = true;
    if (misfit_) {
      double& check = solution_.checks["formulas"];
      check = std::max(check, *misfit_);
    }
    return told();
  }

 private:
  static LetterValues letters_of(const FormulaTask& task) {
    LetterValues base;
    for (const Letter& letter : task.open) base[letter.name] = task.settings.front().at(letter.name).number;
    return base;
  }
  bool has_formula(std::size_t i) const { return solution_.asks[i].formula.has_value() && at_instant_[i]; }
  bool has_formulas() const {
    for (std::size_t i = 0; i < solution_.asks.size(); ++i)
      if (has_formula(i)) return true;
    return false;
  }

  void collect_conditions() {
    std::vector<std::size_t> all;
    for (std::size_t i = 0; i < solution_.asks.size(); ++i)
      if (has_formula(i)) all.push_back(i);
    const auto add_domain = [&](const Value<Formula>& formula, const std::vector<std::size_t>& asks) {
      for (const Formula& one : domain_of(formula)) {
        const auto known = std::ranges::find(conditions_, one, &HeldCondition::positive);
        if (known == conditions_.end())
          conditions_.push_back({one, asks, true, true});
        else
          known->domain = true;
      }
    };
    for (const Formula& bound : grounds_.bounds) conditions_.push_back({bound, all, true});
    for (const UnknownFormula& unknown : grounds_.unknowns) add_domain(unknown.value, all);
    for (const std::size_t i : all) add_domain(*solution_.asks[i].formula, {i});
    for (const std::size_t i : all)
      for (const Formula& sign : grounds_.signs[i]) {
        if (seen_sign(sign).sign > 0) continue;
        const auto known = std::ranges::find(conditions_, sign, &HeldCondition::positive);
        if (known == conditions_.end())
          conditions_.push_back({sign, {i}});
        else if (std::ranges::find(known->asks, i) == known->asks.end())
          known->asks.push_back(i);
      }
  }

  // Solves the statement at a point and holds the answers against it, all of them if none are named.
  // Returns whether any of them has been.
  bool hold_at(const FarPoint& point, const std::vector<std::size_t>& asks) {
    const std::optional<AllSettings> settings = settings_at(point.letters);
    if (!settings) return false;
    bool held = false;
    Sample sample(task_.statement, *settings, OpenChoice{});
    for (std::size_t i = 0; i < solution_.asks.size(); ++i) {
      if (!asks.empty() && std::ranges::find(asks, i) == asks.end()) continue;
      try {
        hold(i, point, sample);
        held = true;
      } catch (const StatementError&) {
        // Either the statement makes no sense at this point, or what it states cannot be with these unknowns.
        if (has_formula(i) && is_in_states(point.letters) && numbers_would_tell(point.letters) &&
            !assume_where_negative(point.letters) && makes_sense_but_for_what_is_stated(*settings, i))
          disagree(i, point);
      } catch (const std::domain_error&) {
        disagree(i, point);
      }
    }
    return held;
  }

  // Whether numbers hold both sides of cords round posts: of those that differ e^20 times eight digits are left, and of
  // others none that would tell whether a cord slips.
  bool numbers_would_tell(const LetterValues& letters) const {
    constexpr double most = 20;
    const auto are_within = [&](const Formula& x) {
      return std::ranges::all_of(exponents_of(x),
                                 [&](const Formula& one) { return std::abs(value_at(one, letters)) < most; });
    };
    return std::ranges::all_of(solution_.asks, [&](const SolvedAsk& ask) {
      if (!ask.formula) return true;
      const Value<Formula>& value = *ask.formula;
      if (value.is_number()) return are_within(value.number);
      return !value.is_vector() ||
             (are_within(value.vector.x) && are_within(value.vector.y) && are_within(value.vector.z));
    });
  }

  // Whether the contacts with friction are in their states, outside which nothing is told.
  bool is_in_states(const LetterValues& letters) const {
    return std::ranges::all_of(grounds_.forces, [&](const OneSidedForce& force) {
      return !force.of_state || value_at(force.value, letters) > 0;
    });
  }

  bool makes_sense_but_for_what_is_stated(const AllSettings& settings, std::size_t i) const {
    try {
      // Trials do not mind bodies that cannot be.
      for (std::size_t k = 0; k < settings.size(); ++k) {
        const Situation& situation = task_.statement.situations[k];
        DataScope<double> data(situation, settings[k]);
        const AnyValue one = [](const Dimension&) { return 1.0; };
        for (const Body& body : situation.bodies) body_mass<double>(body, data, one);
        // Nor gears and joints, which no formula has a part in where nothing is to be found.
        if (!task_.unknowns.empty()) continue;
        DataScope<TimeJet> timed(situation, settings[k], time_jet(0.0));
        build_machine(situation, data, timed, one, MachineOptions{});
      }
      Sample sample(task_.statement, settings, OpenChoice{.trial = true});
      asked_value(sample, task_.statement.asks[i]);
      return true;
    } catch (const StatementError&) {
      return false;
    }
  }

  void hold(std::size_t i, const FarPoint& point, Sample& sample) {
    const Ask& ask = task_.statement.asks[i];
    SolvedAsk& solved = solution_.asks[i];
    const bool fixed = solved.state == AskState::found && !solved.formula;
    if (!at_instant_[i] || (!fixed && !solved.formula)) return;
    if (solved.state != AskState::found && solved.state != AskState::needs_letters) return;
    const Value<double> value = asked_value(sample, ask);
    // A word or a truth is told of the letters that are assumed.
    if ((is_word(value) || is_decided_truth(ask, value)) && !is_assumed(task_.statement, sample.settings())) return;
    SolvedInstant& instant = sample.instant_of(ask);
    if (instant.forces_solved() && assume_physical(instant, sample.home(ask.of.front(), ask.mark), point.letters))
      return;
    if (!confirmed_by_particles(sample)) return;
    const double natural = instant.natural_size(dimension_of(value));
    if (solved.formula) {
      const double misfit = misfit_of(*solved.formula, value, point.letters, natural);
      if (!(misfit <= branch_tolerance))
        disagree(i, point);
      else
        misfit_ = std::max(misfit_.value_or(0), misfit);
    } else if (!same(solved.value, value, branch_tolerance * size_of(value) + 1e-8 * natural)) {
      take_back(i, point);
    }
  }

  // The formula of an ask is another one at a point: either because something that was decided is otherwise there, or
  // because it holds for some values only.
  void disagree(std::size_t i, const FarPoint& point) {
    // Beyond what it assumes of its roots, which is told with it, a formula says nothing.
    if (solution_.asks[i].formula &&
        std::ranges::any_of(assumed_roots_of(*solution_.asks[i].formula),
                            [&](const Formula& inside) { return value_at(inside, point.letters) < 0; }))
      return;
    std::vector<std::size_t> failing;
    for (std::size_t k = 0; k < conditions_.size(); ++k)
      if (std::ranges::find(conditions_[k].asks, i) != conditions_[k].asks.end() &&
          !(value_at(conditions_[k].positive, point.letters) > 0))
        failing.push_back(k);
    if (failing.empty()) return take_back(i, point);
    if (std::ranges::any_of(failing, [&](std::size_t k) { return conditions_[k].needed; })) return;
    if (failing.size() == 1)
      conditions_[failing.front()].needed = true;
    else
      doubtful_.push_back(std::move(failing));
  }

  void take_back(std::size_t i, const FarPoint& point) {
    SolvedAsk& solved = solution_.asks[i];
    if (solved.formula) solved.no_formula = "the formula found holds for some values of the letters only";
    solved.formula.reset();
    solved.formula_road.clear();
    solved.state = AskState::needs_letters;
    for (const Letter& letter : task_.open) {
      const bool concerned = point.only.empty() ? solved.letters.empty() : letter.name == point.only;
      if (concerned && std::find(solved.letters.begin(), solved.letters.end(), letter.name) == solved.letters.end())
        solved.letters.push_back(letter.name);
    }
  }

  // Looks for letters at which a condition fails, and sees by numbers whether the formulas then fail with it.
  void look_where_it_fails(std::size_t k) {
    const HeldCondition& condition = conditions_[k];
    const auto fails = [&](const HeldCondition& one, const LetterValues& letters) {
      return value_at(one.positive, letters) <= 0;
    };
    int confirmations = 0, heard = 0;
    // First where nothing else fails, so that what is seen comes from this condition.
    const auto look = [&](bool alone, bool far) {
      for (std::size_t i = 0; i < condition_points && confirmations < most_confirmations; ++i) {
        if (condition.needed) return;
        const LetterValues letters = far ? scan_.point(most_scanned + i) : scan_.near(i);
        if (!fails(condition, letters)) continue;
        // To look at a bound takes the formula alone. What was not looked at is told.
        if (limit_.spent() && !condition.bound) {
          conditions_[k].needed = true;
          return;
        }
        if (alone && std::ranges::any_of(conditions_, [&](const HeldCondition& other) {
              return &other != &condition && fails(other, letters);
            }))
          continue;
        if (condition.bound) {
          if (condition.domain || settings_at(letters)) conditions_[k].needed = true;
          continue;
        }
        ++confirmations;
        if (hold_at({letters, ""}, condition.asks)) ++heard;
      }
    };
    look(true, true);
    look(false, true);
    // Far off there may be no such body, however the condition is.
    if (heard > 0 || condition.bound) return;
    confirmations = 0;
    look(true, false);
    look(false, false);
  }

  std::vector<HeldCondition> told() const {
    std::vector<HeldCondition> all;
    for (const HeldCondition& condition : conditions_)
      if (condition.needed && !is_implied(condition, conditions_)) all.push_back(condition);
    return all;
  }

  static const std::string& name_of(const SolvedInstant& instant, const SolvedInstant::OneSidedFault& fault) {
    return instant.machine().mechanism.actions[fault.action].name;
  }

  // Whether a cord or contact acts the wrong way at the instant. The solution then assumes that this does not happen.
  bool assume_physical(const SolvedInstant& instant, const Sample::Home& home, const LetterValues& letters) {
    const std::vector<SolvedInstant::OneSidedFault> faults = instant.one_sided_faults();
    // The conditions of contacts with friction are told in any case.
    for (const SolvedInstant::OneSidedFault& fault : faults)
      if (std::ranges::none_of(grounds_.forces, [&](const OneSidedForce& force) {
            return force.of_state && force.action == name_of(instant, fault);
          }))
        assume(holding_words(name_of(instant, fault), fault.broken), home, letters);
    return !faults.empty();
  }

  // The same by the formulas of the forces, where numbers tell nothing.
  bool assume_where_negative(const LetterValues& letters) {
    bool any = false;
    for (const OneSidedForce& force : grounds_.forces) {
      if (force.of_state || !(value_at(force.value, letters) < 0)) continue;
      any = true;
      assume(force.assumption, force.home, letters);
    }
    return any;
  }

  // Adds an assumption, and tells with the formula of the force where it is known not to hold.
  void assume(const std::string& assumption, const Sample::Home& home, const LetterValues& letters) {
    auto& all = solution_.assumptions;
    if (std::find(all.begin(), all.end(), assumption) != all.end()) return;
    all.push_back(assumption);
    for (const OneSidedForce& force : grounds_.forces)
      if (force.assumption == assumption && !(force.home < home) && !(home < force.home) &&
          value_at(force.value, letters) < 0) {
        solution_.conditions.push_back({assumption, force.value});
        return;
      }
  }

  // Looks for letters at which the tension of a cord or the push of a contact is negative by its formula, and
  // confirms this by numbers.
  void look_where_negative(const OneSidedForce& force) {
    auto& all = solution_.assumptions;
    if (std::find(all.begin(), all.end(), force.assumption) != all.end()) return;
    int confirmations = 0;
    for (std::size_t i = 0; i < condition_points && confirmations < most_confirmations; ++i) {
      const LetterValues letters = scan_.point(most_scanned + i);
      if (!(value_at(force.value, letters) < 0)) continue;
      ++confirmations;
      try {
        const std::optional<AllSettings> settings = settings_at(letters);
        if (!settings) continue;
        Sample sample(task_.statement, *settings, OpenChoice{});
        SolvedInstant& instant = sample.instant(force.home);
        instant.solve_forces();
        for (const SolvedInstant::OneSidedFault& fault : instant.one_sided_faults())
          if (name_of(instant, fault) == force.action) return assume(force.assumption, force.home, letters);
      } catch (const StatementError&) {
        // The statement makes no sense at this point.
      }
    }
  }

  // The settings with these letters and what the unknowns then are; nothing where a formula of these has no value.
  std::optional<AllSettings> settings_at(const LetterValues& letters) const {
    AllSettings settings = task_.settings;
    for (Settings& one : settings)
      for (const Letter& letter : task_.open)
        one[letter.name] = Value<double>::of_number(letters.at(letter.name), letter.unit.dimension);
    for (const UnknownFormula& unknown : grounds_.unknowns) {
      Value<double> value = task_.settings[unknown.situation.value_or(0)].at(unknown.name);
      if (unknown.value.is_number()) value.number = value_at(unknown.value.number, letters);
      for (std::size_t k = 0; unknown.value.is_vector() && k < 3; ++k)
        value.vector[k] = value_at(unknown.value.vector[k], letters);
      if (!std::isfinite(size_of(value))) return std::nullopt;
      for (std::size_t i = 0; i < settings.size(); ++i)
        if (unknown.situation.value_or(i) == i) settings[i][unknown.name] = value;
    }
    return settings;
  }

  const FormulaTask& task_;
  Solution& solution_;
  const FormulaGrounds& grounds_;
  const LetterValues base_;
  const LetterScan scan_;
  const WorkLimit limit_;
  std::vector<bool> at_instant_;  // of each ask
  std::vector<HeldCondition> conditions_;
  std::vector<std::vector<std::size_t>> doubtful_;  // conditions of which one at least is needed
  std::optional<double> misfit_;
};

}  // namespace

std::vector<HeldCondition> hold_far_off(const FormulaTask& task, const FormulaGrounds& grounds, Solution& solution) {
  // Unknowns without formulas are what they are at the first values of the letters only.
  if (!task.unknowns.empty() && grounds.unknowns.empty()) return {};
  return FarSearch(task, grounds, solution).run();
}

}  // namespace poinsot::problem
