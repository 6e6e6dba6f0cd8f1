#include "statement/formula_reach.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>
#include <random>
#include <set>

#include "statement/compare_values.h"
#include "statement/formula_answers.h"
#include "statement/quantity_functions.h"

namespace poinsot::statement {
namespace {

constexpr std::size_t most_points = 24;
constexpr double most_seconds = 0.4;
constexpr double tolerance = 1e-6;  // of answers, relative: another branch is another number

// Letters far off; `only`: the one that alone is so.
struct FarPoint {
  LetterValues letters;
  std::string only;
};

bool is_angle(const Letter& letter) { return letter.unit.dimension == dimensions::angle; }

std::vector<FarPoint> far_points(const std::vector<Letter>& open, const LetterValues& base) {
  constexpr double pi = std::numbers::pi;
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
  // All together.
  for (int i = 0; i < 4; ++i) {
    FarPoint point{base, ""};
    for (const Letter& letter : open) {
      double& value = point.letters[letter.name];
      value = is_angle(letter) ? pi * part() : value * std::pow(10, 1.5 * part());
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
  FarSearch(const FormulaTask& task, Solution& solution) : task_(task), solution_(solution) {}

  void run() {
    LetterValues base;
    for (const Letter& letter : task_.open) base[letter.name] = task_.settings.front().at(letter.name).number;
    const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(most_seconds);
    for (const FarPoint& point : far_points(task_.open, base)) {
      if (std::chrono::steady_clock::now() > end) break;
      AllSettings settings = task_.settings;
      for (Settings& one : settings)
        for (const Letter& letter : task_.open)
          one[letter.name] = Value<double>::of_number(point.letters.at(letter.name), letter.unit.dimension);
      Sample sample(task_.statement, settings, OpenChoice{});
      for (std::size_t i = 0; i < solution_.asks.size(); ++i) {
        try {
          hold(i, point, sample);
        } catch (const StatementError&) {
          // Without sense there.
        } catch (const std::domain_error&) {
          take_back(i, point);
        }
      }
    }
  }

 private:
  void hold(std::size_t i, const FarPoint& point, Sample& sample) {
    const Ask& ask = task_.statement.asks[i];
    SolvedAsk& solved = solution_.asks[i];
    const bool fixed = solved.state == AskState::found && !solved.formula;
    if (ask.table || ask.when || ask.extremum || (!fixed && !solved.formula)) return;
    if (solved.state != AskState::found && solved.state != AskState::needs_letters) return;
    const Value<double> value = sample.value(ask);
    SolvedInstant& instant = sample.instant_of(ask);
    if (instant.forces_solved() && assume_physical(instant)) return;
    if (!confirmed_by_particles(sample)) return;
    const double natural = instant.natural_size(dimension_of(value));
    const bool agree = solved.formula ? agrees(*solved.formula, value, point.letters, tolerance, natural)
                                      : same(solved.value, value, tolerance * size_of(value) + 1e-8 * natural);
    if (!agree) take_back(i, point);
  }

  void take_back(std::size_t i, const FarPoint& point) {
    SolvedAsk& solved = solution_.asks[i];
    if (solved.formula) solved.no_formula = "the formula found holds for some values of the letters only";
    solved.formula.reset();
    solved.state = AskState::needs_letters;
    for (const Letter& letter : task_.open) {
      const bool concerned = point.only.empty() ? solved.letters.empty() : letter.name == point.only;
      if (concerned && std::find(solved.letters.begin(), solved.letters.end(), letter.name) == solved.letters.end())
        solved.letters.push_back(letter.name);
    }
  }

  // Whether something is unphysical at the instant, which the solution then assumes not to happen.
  bool assume_physical(const SolvedInstant& instant) {
    const std::vector<std::string> reasons = instant.unphysical();
    for (const std::string& reason : reasons) {
      // "the cord 'AB' would have to push: it goes slack"
      const std::string who = reason.substr(0, reason.find(" would"));
      const std::string assumption = who + (who.starts_with("the cord") ? " stays taut" : " presses");
      auto& all = solution_.assumptions;
      if (std::find(all.begin(), all.end(), assumption) == all.end()) all.push_back(assumption);
    }
    return !reasons.empty();
  }

  const FormulaTask& task_;
  Solution& solution_;
};

}  // namespace

void hold_far_off(const FormulaTask& task, Solution& solution) {
  if (task.unknowns.empty() && task.sample.motions().empty()) FarSearch(task, solution).run();
}

}  // namespace poinsot::statement
