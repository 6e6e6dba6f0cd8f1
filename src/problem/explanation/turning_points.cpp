#include "problem/explanation/turning_points.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "problem/language/expression_walk.h"
#include "problem/language/words.h"

namespace poinsot::problem {
namespace {

// An extreme of a coordinate: min(theta) or max(theta).
struct Turn {
  std::string coordinate;
  bool largest = false;
  Expression extreme;  // the call
  bool operator<(const Turn& other) const {
    return std::tie(coordinate, largest) < std::tie(other.coordinate, other.largest);
  }
};

void collect_turns(const Situation& situation, const Machine& machine, const Expression& expression,
                   std::set<Turn>& turns) {
  for (const MotionFeatureCall& feature : motion_features_in(situation, expression)) {
    const Name* name = feature.call->arguments.front().value.as<Name>();
    if (!name || name->primes > 0 || feature.call->function == "period" || !machine.coordinate(name->name)) continue;
    turns.insert({name->name, feature.call->function == "max", built(*feature.call, feature.mark)});
  }
}

std::set<Turn> turns_of(const Statement& statement, std::size_t index, Sample& sample) {
  const Situation& situation = statement.situations[index];
  const Machine& machine = sample.instant_at(index, 0).machine();
  std::set<Turn> turns;
  for (const Ask& ask : statement.asks)
    for (const Expression& one : ask.of)
      if (sample.home_of(ask).situation == index) collect_turns(situation, machine, one, turns);
  for (const Instant& instant : situation.instants)
    for (const Fact& fact : instant.facts) collect_turns(situation, machine, fact.quantity, turns);
  return turns;
}

// The first time at which the coordinate is at its extreme.
std::optional<double> time_of(const Turn& turn, Course& motion) {
  const Expression& coordinate = turn.extreme.as<Call>()->arguments.front().value;
  Comparison equal;
  equal.operands = {coordinate, turn.extreme};
  equal.relations = {Relation::equal};
  const std::vector<double> times =
      motion.times(built(std::move(equal), turn.extreme.mark()), std::nullopt, 0, std::nullopt);
  return times.empty() ? std::nullopt : std::optional(times.front());
}

std::string words_of_turn(const Turn& turn, const std::string& extreme) {
  return "Where $" + ExplanationTex::formula(Formula::letter(turn.coordinate, Sign::real)).value_or("") + "$ is " +
         extreme + " its rate vanishes, and what is kept says";
}

std::optional<ExplainedStep> step_of(const Turn& turn, Course& motion, const std::vector<KeptValue>& kept,
                                     const GeneralMotion& general, ExplanationTex tex) {
  // Digits of a value that was integrated, and of the extreme's place.
  constexpr double same_value = 1e-6;
  const auto time = time_of(turn, motion);
  if (!time) return std::nullopt;
  const MotionState there = motion.at(*time);
  const auto letters = general.letters_at(there);
  const std::string rate = GeneralMotion::rate_letter(turn.coordinate);
  if (!letters) return std::nullopt;
  tex.set_letters(general.in_shown_units(*letters, tex));
  ExplainedStep step;
  std::set<std::string> solved;
  for (const KeptValue& one : kept) {
    if (!one.formula) continue;
    const Formula formula = substituted(*one.formula, {{rate, Formula(0)}});
    const std::vector<std::string> names = formula.letters();
    if (!(std::abs(value_at(formula, *letters) - one.value) <= same_value * one.size)) return std::nullopt;
    ExplainedEquation equation = tex.kept(one.symbol, {one.value, formula}, one.dimension);
    if (equation.sides.empty()) return std::nullopt;
    step.equations.push_back(std::move(equation));
    for (const std::string& name : names)
      if (general.is_of_motion(name)) solved.insert(name);
  }
  if (!solved.contains(turn.coordinate)) return std::nullopt;
  // With more to be found than is said this is no way to the answer.
  if (solved.size() > step.equations.size()) return std::nullopt;
  step.text = words_of_turn(turn, turn.largest ? "largest" : "smallest");
  std::vector<std::string> found;
  for (const std::string& name : solved)
    found.push_back(tex.inline_equation(*ExplanationTex::formula(Formula::letter(name, Sign::real)),
                                        {letters->at(name), std::nullopt}, general.dimension_of(name)));
  if (!tex.letters_open()) step.text += ", for " + listed(found);
  step.text += ":";
  return step;
}

}  // namespace

std::vector<ExplainedStep> turning_points(const Statement& statement, std::size_t situation, Sample& sample,
                                          const std::vector<KeptValue>& kept, const GeneralMotion& general,
                                          const ExplanationTex& tex) {
  std::vector<ExplainedStep> steps;
  Course& motion = sample.motion(situation);
  for (const Turn& turn : turns_of(statement, situation, sample)) {
    try {
      auto step = step_of(turn, motion, kept, general, tex);
      if (!step) continue;
      // What is kept says in letters the same of both ends.
      const auto same = std::ranges::find_if(steps, [&](const ExplainedStep& other) {
        return tex.letters_open() && std::ranges::equal(other.equations, step->equations, {}, &ExplainedEquation::tex,
                                                        &ExplainedEquation::tex);
      });
      if (same == steps.end())
        steps.push_back(std::move(*step));
      else
        same->text = words_of_turn(turn, "largest or smallest") + ":";
    } catch (const StatementError&) {
      // What has no time has no step.
    } catch (const std::domain_error&) {
    } catch (const FormulaTooLarge&) {
    }
  }
  return steps;
}

}  // namespace poinsot::problem
