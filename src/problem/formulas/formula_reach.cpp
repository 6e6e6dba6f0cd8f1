#include "problem/formulas/formula_reach.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "poinsot/engine/work/work.h"
#include "problem/formulas/formula_answers.h"
#include "problem/quantities/quantity_functions.h"
#include "problem/results/compare_values.h"
#include "problem/unknowns/asked_value.h"

namespace poinsot::problem {
namespace {

constexpr std::size_t most_points = 24;
constexpr Work most_far_work = 400'000'000;
constexpr int most_condition_points = 200;  // at which a formula is looked at
constexpr int most_confirmations = 3;       // of what it shows, by numbers
constexpr double branch_tolerance = 1e-6;   // relative difference of answers from which they are on different branches

// A point at which letters have values far from the ordinary. `only` names the letter if it is a single one.
struct FarPoint {
  LetterValues letters;
  std::string only;
};

bool is_angle(const Letter& letter) { return letter.unit.dimension == dimensions::angle; }

std::vector<FarPoint> far_points(const std::vector<Letter>& open, const LetterValues& base) {
  std::vector<FarPoint> points;
  std::mt19937_64 random(6100);
  const auto part = [&] { return std::uniform_real_distribution<double>(-1, 1)(random); };
  const auto moved = [&](const Letter& letter, double value) {
    FarPoint point{base, letter.name};
    point.letters[letter.name] = value;
    points.push_back(std::move(point));
  };
  for (const Letter& letter : open) {
    const double value = base.at(letter.name);
    if (is_angle(letter)) {
      for (const double quadrant : {2.3, -2.2, -0.8}) moved(letter, quadrant);
      continue;
    }
    for (const double far : {1e2, 1e-2, 1e4, 1e-4}) moved(letter, far * value);
    if (letter.either_sign) moved(letter, -value);
  }
  // Finally points at which all letters are far from their ordinary values.
  for (int i = 0; i < 4; ++i) {
    FarPoint point{base, ""};
    for (const Letter& letter : open) {
      double& value = point.letters[letter.name];
      value = is_angle(letter) ? std::numbers::pi * part() : value * std::pow(10, 1.5 * part());
      if (letter.either_sign && part() < 0) value = -value;
    }
    points.push_back(std::move(point));
  }
  if (points.size() > most_points) {
    std::shuffle(points.begin(), points.end(), random);
    points.resize(most_points);
  }
  return points;
}

class FarSearch {
 public:
  FarSearch(const FormulaTask& task, const std::vector<OneSidedForce>& forces, Solution& solution)
      : task_(task), solution_(solution), forces_(forces) {}

  void run() {
    LetterValues base;
    for (const Letter& letter : task_.open) base[letter.name] = task_.settings.front().at(letter.name).number;
    const WorkLimit limit(most_far_work);
    for (const FarPoint& point : far_points(task_.open, base)) {
      if (limit.spent()) break;
      const AllSettings settings = settings_at(point.letters);
      Sample sample(task_.statement, settings, OpenChoice{});
      for (std::size_t i = 0; i < solution_.asks.size(); ++i) {
        try {
          hold(i, point, sample);
        } catch (const StatementError&) {
          // The statement makes no sense at this point.
        } catch (const std::domain_error&) {
          take_back(i, point);
        }
      }
    }
    const bool any = std::any_of(solution_.asks.begin(), solution_.asks.end(),
                                 [](const SolvedAsk& ask) { return ask.formula.has_value(); });
    for (const OneSidedForce& force : forces_)
      if (any) look_where_negative(force, base);
  }

 private:
  void hold(std::size_t i, const FarPoint& point, Sample& sample) {
    const Ask& ask = task_.statement.asks[i];
    SolvedAsk& solved = solution_.asks[i];
    const bool fixed = solved.state == AskState::found && !solved.formula;
    if (ask.table || ask.when || ask.extremum || (!fixed && !solved.formula)) return;
    if (solved.state != AskState::found && solved.state != AskState::needs_letters) return;
    const Value<double> value = asked_value(sample, ask);
    SolvedInstant& instant = sample.instant_of(ask);
    if (instant.forces_solved() && assume_physical(instant, sample.home(ask.of.front(), ask.mark), point.letters))
      return;
    if (!confirmed_by_particles(sample)) return;
    const double natural = instant.natural_size(dimension_of(value));
    const bool agree = solved.formula ? agrees(*solved.formula, value, point.letters, branch_tolerance, natural)
                                      : same(solved.value, value, branch_tolerance * size_of(value) + 1e-8 * natural);
    if (!agree) take_back(i, point);
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

  static const std::string& name_of(const SolvedInstant& instant, const SolvedInstant::OneSidedFault& fault) {
    return instant.machine().mechanism.actions[fault.action].name;
  }

  // Whether a cord or contact acts the wrong way at the instant. The solution then assumes that this does not happen.
  bool assume_physical(const SolvedInstant& instant, const Sample::Home& home, const LetterValues& letters) {
    const std::vector<SolvedInstant::OneSidedFault> faults = instant.one_sided_faults();
    for (const SolvedInstant::OneSidedFault& fault : faults)
      assume(holding_words(name_of(instant, fault), fault.cord), home, letters);
    return !faults.empty();
  }

  // Adds an assumption, and tells with the formula of the force where it is known not to hold.
  void assume(const std::string& assumption, const Sample::Home& home, const LetterValues& letters) {
    auto& all = solution_.assumptions;
    if (std::find(all.begin(), all.end(), assumption) != all.end()) return;
    all.push_back(assumption);
    for (const OneSidedForce& force : forces_)
      if (force.assumption == assumption && !(force.home < home) && !(home < force.home) &&
          value_at(force.value, letters) < 0) {
        solution_.conditions.push_back({assumption, force.value});
        return;
      }
  }

  // Looks for letters at which the tension of a cord or the push of a contact is negative by its formula, and
  // confirms this by numbers.
  void look_where_negative(const OneSidedForce& force, const LetterValues& base) {
    auto& all = solution_.assumptions;
    if (std::find(all.begin(), all.end(), force.assumption) != all.end()) return;
    std::mt19937_64 random(6300);
    const auto part = [&] { return std::uniform_real_distribution<double>(-1, 1)(random); };
    int confirmations = 0;
    for (int i = 0; i < most_condition_points && confirmations < most_confirmations; ++i) {
      LetterValues letters = base;
      for (const Letter& letter : task_.open) {
        double& value = letters[letter.name];
        value = is_angle(letter) ? std::numbers::pi * part() : value * std::pow(10, 1.5 * part());
        if (letter.either_sign && part() < 0) value = -value;
      }
      if (!(value_at(force.value, letters) < 0)) continue;
      ++confirmations;
      try {
        const AllSettings settings = settings_at(letters);
        Sample sample(task_.statement, settings, OpenChoice{});
        SolvedInstant& instant = sample.instant(force.home);
        instant.solve_forces();
        for (const SolvedInstant::OneSidedFault& fault : instant.one_sided_faults())
          if (name_of(instant, fault) == force.action) return assume(force.assumption, force.home, letters);
      } catch (const StatementError&) {
        // The statement makes no sense at this point.
      }
    }
  }

  AllSettings settings_at(const LetterValues& letters) const {
    AllSettings settings = task_.settings;
    for (Settings& one : settings)
      for (const Letter& letter : task_.open)
        one[letter.name] = Value<double>::of_number(letters.at(letter.name), letter.unit.dimension);
    return settings;
  }

  const FormulaTask& task_;
  Solution& solution_;
  const std::vector<OneSidedForce>& forces_;
};

}  // namespace

void hold_far_off(const FormulaTask& task, const std::vector<OneSidedForce>& forces, Solution& solution) {
  if (task.unknowns.empty() && task.sample.motions().empty()) FarSearch(task, forces, solution).run();
}

}  // namespace poinsot::problem
