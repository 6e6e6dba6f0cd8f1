#include "problem/formulas/formula_answers.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "poinsot/engine/math/formula/formula_decision.h"
#include "poinsot/engine/math/formula/formula_sign.h"
#include "poinsot/engine/solve/instant/equations.h"
#include "problem/formulas/formula_unknowns.h"
#include "problem/results/compare_values.h"

namespace poinsot::problem {
namespace {

// All numbers of a value in order.
template <class Scalar>
std::vector<Scalar> numbers_of(const Value<Scalar>& value) {
  if (value.is_number()) return {value.number};
  if (value.is_vector()) return {value.vector.x, value.vector.y, value.vector.z};
  std::vector<Scalar> all;
  for (const Value<Scalar>& item : value.items)
    for (const Scalar& number : numbers_of(item)) all.push_back(number);
  return all;
}

bool has_numbers_only(const Value<Formula>& value) {
  if (value.is_number() || value.is_vector()) return true;
  return value.is_list() && std::all_of(value.items.begin(), value.items.end(), has_numbers_only);
}

// Returns what `find` returns. Errors that prevent a formula become a NoFormula with the reason.
template <class Find>
auto or_no_formula(const Find& find) {
  try {
    return find();
  } catch (const StatementError& error) {
    throw NoFormula(error.diagnostics().front().message);
  } catch (const std::domain_error& error) {
    throw NoFormula(error.what());
  } catch (const FormulaTooLarge& error) {
    throw NoFormula(error.what());
  }
}

// Whether the equations leave open what a contact with friction carries.
bool shares_are_open(const SolvedInstant& instant) {
  const Mechanism<double>& mechanism = instant.machine().mechanism;
  const std::size_t first = solve::force_unknowns(mechanism).accelerations;
  constexpr double rounding = 1e-10;  // of the largest entry of a direction
  for (const std::vector<double>& open : instant.motion().open) {
    const double largest = std::abs(std::ranges::max(open, {}, [](double x) { return std::abs(x); }));
    for (std::size_t k = 0; k < mechanism.components.size(); ++k)
      if (std::abs(open[first + k]) > rounding * largest &&
          std::ranges::any_of(instant.machine().rough_contacts, [&](const RoughContactOf<double>& contact) {
            return contact.action == mechanism.components[k].action;
          }))
        return true;
  }
  return false;
}

}  // namespace

Value<Formula> formula_of(const Letter& letter) {
  const bool real = letter.either_sign || letter.unit.dimension == dimensions::angle;
  return Value<Formula>::of_number(Formula::letter(letter.name, real ? poinsot::Sign::real : poinsot::Sign::positive),
                                   letter.unit.dimension);
}

Value<Formula> exact_setting(const Situation& situation, const std::string& name, const std::string& text) {
  const Value<double> number = read_setting(situation, name, text);
  Situation nothing;
  nothing.file = "--set " + name;
  const Settings none;
  DataScope<Formula> scope(nothing, none);
  Value<Formula> value = evaluate(setting_expression(name, text), static_cast<Scope<Formula>&>(scope), nothing.file);
  value.dimension = number.dimension;
  return value;
}

FormulaInstant& FormulaAnswers::instant(const Sample::Home& home) {
  if (const auto known = instants_.find(home); known != instants_.end()) {
    for (const Formula& sign : signs_[home]) note_sign(sign);
    return *known->second;
  }
  if (const auto failed = no_instant_.find(home); failed != no_instant_.end()) throw NoFormula(failed->second);
  const Situation& situation = statement_.situations[home.situation];
  if (home.time || home.ending || home.instant > (situation.has_blow() ? 1U : 0U))
    throw NoFormula("it is reached by a motion, which is followed by numbers");
  try {
    std::unique_ptr<FormulaInstant> found;
    {
      const DecisionScope decisions;
      found = std::make_unique<FormulaInstant>(situation, values_[home.situation], numbers_.instant(home), nullptr,
                                               linear_solve_);
      signs_[home] = decisions.signs();
    }
    for (const Formula& sign : signs_[home]) note_sign(sign);
    return *(instants_[home] = std::move(found));
  } catch (const std::exception& error) {
    no_instant_[home] = error.what();
    throw;
  }
}

Value<Formula> FormulaAnswers::at_home(const Sample::Home& home, const Expression& expression,
                                       const std::optional<Expression>& axes) {
  return instant(home).ask(expression, axes, [&](const At& at, const Mark& mark) {
    return instant(numbers_.resolve(at, mark)).raw(at.expression, axes, nullptr);
  });
}

DecidedFormula FormulaAnswers::value(const Ask& ask) {
  DecidedFormula found = decided(ask);
  if (!has_numbers_only(found.value)) throw NoFormula("truths and words have no formula");
  return found;
}

std::vector<Formula> FormulaAnswers::signs_of_word(const Ask& ask) {
  std::vector<Formula> signs = decided(ask).signs;
  // What decides an inequality is how much larger one side is.
  for (const Expression& expression : ask.of) {
    const Comparison* comparison = expression.as<Comparison>();
    for (std::size_t k = 0; comparison && k < comparison->relations.size(); ++k) {
      const auto side = [&](std::size_t operand) {
        Ask of_side = ask;
        of_side.of = {comparison->operands[operand]};
        of_side.is_list = false;
        DecidedFormula found = decided(of_side);
        if (!found.value.is_number()) throw NoFormula("what is compared is no number");
        signs.insert(signs.end(), found.signs.begin(), found.signs.end());
        return found.value.number;
      };
      const Formula difference = side(k + 1) - side(k);
      if (difference.is_zero()) throw NoFormula("both sides are the same whatever the letters are");
      signs.push_back(difference);
    }
  }
  return signs;
}

DecidedFormula FormulaAnswers::decided(const Ask& ask) {
  if (ask.table || ask.when || ask.extremum) throw NoFormula("it is found by numbers");
  return or_no_formula([&] {
    const DecisionScope decisions;
    std::vector<Value<Formula>> items;
    for (const Expression& expression : ask.of) {
      if (asks_motion_feature(expression)) throw NoFormula("the motion is followed by numbers");
      items.push_back(at_home(numbers_.home(expression, ask.mark), expression, ask.axes));
    }
    Value<Formula> value = ask.is_list ? Value<Formula>::of_list(std::move(items)) : items.front();
    if (decisions.zeros_by_digits() && !has_numbers_only(value)) throw NoFormula("truths and words have no formula");
    return DecidedFormula{std::move(value), decisions.signs()};
  });
}

DecidedFormula FormulaAnswers::at_start(std::size_t situation, const Expression& expression) {
  return or_no_formula([&] {
    const DecisionScope decisions;
    Value<Formula> value = at_home(numbers_.start_of(situation), expression, std::nullopt);
    return DecidedFormula{std::move(value), decisions.signs()};
  });
}

std::vector<Formula> FormulaAnswers::signs_of_instants() const {
  std::vector<Formula> all;
  for (const auto& [home, signs] : signs_) all.insert(all.end(), signs.begin(), signs.end());
  return all;
}

std::string holding_words(const std::string& action, Holding holding) {
  switch (holding) {
    case Holding::pulls:
      return "the cord '" + action + "' stays taut";
    case Holding::presses:
      return "the contact '" + action + "' presses";
    case Holding::sticks:
      return "the contact '" + action + "' sticks";
    case Holding::slides:
      return "the contact '" + action + "' slides";
    case Holding::parts:
      break;
  }
  return "the contact '" + action + "' parts";
}

std::vector<OneSidedForce> FormulaAnswers::one_sided_forces() const {
  std::vector<OneSidedForce> forces;
  for (const auto& [home, instant] : instants_) {
    if (instant->unknowns().empty()) continue;
    const Mechanism<Formula>& mechanism = instant->machine().mechanism;
    const std::size_t first = solve::force_unknowns(mechanism).accelerations;
    for (std::size_t k = 0; k < mechanism.components.size(); ++k) {
      const Component<Formula>& component = mechanism.components[k];
      const Action& action = mechanism.actions[static_cast<std::size_t>(component.action)];
      const bool rough = std::ranges::any_of(instant->machine().rough_contacts,
                                             [&](const auto& contact) { return contact.action == component.action; });
      // The conditions of contacts with friction are those of their states.
      if (component.one_sided && !rough)
        forces.push_back(
            {home, action.name,
             holding_words(action.name, action.kind == ActionKind::cord ? Holding::pulls : Holding::presses),
             instant->unknowns()[first + k]});
    }
    for (const int side : instant->machine().belt_actions) {
      const std::string& name = mechanism.actions[static_cast<std::size_t>(side)].name;
      forces.push_back({home, name, holding_words(name, Holding::pulls),
                        tension_of(instant->mechanism_state(), instant->unknowns(), side)});
    }
  }
  return forces;
}

void FormulaAnswers::add_approaches(std::vector<OneSidedForce>& forces) const {
  for (const auto& [home, instant] : instants_) {
    if (!instant->before()) continue;
    for (const solve::ImpactOf<Formula>& impact : instant->blow().impacts) {
      const Formula approach =
          -dot(impact_velocity(*instant->before(), impact), instant->before()->direction(impact.push));
      if (seen_sign(approach).sign <= 0)
        forces.push_back({home, impact.name, "the bodies approach at impact '" + impact.name + "'", approach, true});
    }
  }
}

void FormulaAnswers::add_state_conditions(std::vector<OneSidedForce>& forces) {
  or_no_formula([&] {
    for (std::size_t i = 0; i < statement_.situations.size(); ++i) {
      const Sample::Home home = numbers_.start_of(i);
      // A blow that is solved in letters touches none of them (answers/idle_contacts.h).
      if (!statement_.situations[i].has_friction() || statement_.situations[i].has_blow()) continue;
      FormulaInstant& start = instant(home);
      start.solve_forces();
      SolvedInstant& numbers = numbers_.instant(home);
      numbers.solve_forces();
      if (shares_are_open(numbers))
        throw NoFormula("how contacts share what they carry is open, and so is the letter at which one of them slips");
      std::vector<StateCondition> conditions =
          state_conditions(start.mechanism_state(), start.unknowns(), start.machine().rough_contacts);
      if (std::ranges::any_of(statement_.situations[i].contacts, &Contact::leaves_limit))
        conditions.push_back(condition_of_leaving(i, start));
      const std::vector<RoughContactOf<Formula>>& contacts = start.machine().rough_contacts;
      for (const StateCondition& condition : conditions)
        forces.push_back(
            {home,
             start.machine()
                 .mechanism
                 .actions[static_cast<std::size_t>(
                     std::ranges::find(contacts, condition.contact, &RoughContactOf<Formula>::name)->action)]
                 .name,
             holding_words(condition.contact, condition.holding), condition.positive, true});
    }
  });
}

std::vector<Formula> FormulaAnswers::positive_in_states(std::size_t situation) {
  return or_no_formula([&] {
    const DecisionScope decisions;
    const Sample::Home at = numbers_.start_of(situation);
    FormulaInstant& start = instant(at);
    start.solve_forces();
    SolvedInstant& numbers = numbers_.instant(at);
    numbers.solve_forces();
    if (shares_are_open(numbers)) throw NoFormula("how contacts share what they carry is open");
    std::vector<Formula> positive;
    for (const StateCondition& condition :
         state_conditions(start.mechanism_state(), start.unknowns(), start.machine().rough_contacts))
      positive.push_back(condition.positive);
    for (const OneSidedForce& force : one_sided_forces())
      if (!(force.home < at) && !(at < force.home)) positive.push_back(force.value);
    for (const Formula& sign : decisions.signs()) positive.push_back(sign);
    return positive;
  });
}

// A contact with less friction while it slides than at rest begins to only beyond its limit in the state of rest.
StateCondition FormulaAnswers::condition_of_leaving(std::size_t i, const FormulaInstant& sliding) {
  const std::vector<RoughContactOf<Formula>>& contacts = sliding.machine().rough_contacts;
  if (contacts.size() > 1)
    throw NoFormula("of several contacts with less friction while they slide, which of them stay at rest has none");
  Situation resting = statement_.situations[i];
  for (Contact& contact : resting.contacts)
    if (contact.rubs()) {
      contact.grip = Grip::sticks;
      contact.slip.reset();
      contact.from_rest = false;
    }
  SolvedInstant numbers(resting, numbers_.settings()[i], When{}, numbers_.choice());
  numbers.solve_forces();
  FormulaInstant start(resting, values_[i], numbers, nullptr, linear_solve_);
  start.solve_forces();
  return leaving_condition(start.mechanism_state(), start.unknowns(), start.machine().rough_contacts.front(),
                           sliding.mechanism_state().direction(*contacts.front().slip));
}

void FormulaAnswers::solve_all() {
  or_no_formula([&] {
    for (std::size_t i = 0; i < statement_.situations.size(); ++i) {
      if (statement_.situations[i].has_blow()) instant({i, 1, std::nullopt});
      FormulaInstant& start = instant({i, 0, std::nullopt});
      if (!statement_.situations[i].has_blow()) start.solve_forces();
    }
  });
}

std::vector<Formula> FormulaAnswers::remainders() const {
  std::vector<Formula> all;
  for (const auto& [home, instant] : instants_) {
    const std::vector<std::string> small =
        neglected_letters(statement_.situations[home.situation], values_[home.situation]);
    for (const Formula& remainder : instant->remainders()) all.push_back(first_order(remainder, small));
  }
  return all;
}

std::vector<std::string> neglected_letters(const Situation& situation, const FormulaValues& values) {
  std::vector<std::string> letters;
  for (const Expression& square : situation.neglect) {
    // The reader has checked that each entry is the square of an unknown.
    const auto value = values.find(square.as<Binary>()->left.as<Name>()->name);
    if (value == values.end() || !value->second.is_number()) continue;
    for (const std::string& letter : value->second.number.letters()) letters.push_back(letter);
  }
  return letters;
}

double misfit_of(const Value<Formula>& formula, const Value<double>& value, const LetterValues& letters,
                 double natural) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  const std::vector<Formula> formulas = numbers_of(formula);
  const std::vector<double> numbers = numbers_of(value);
  if (formulas.size() != numbers.size()) return infinite;
  const double size = size_of(value) + 1e-2 * natural;
  double misfit = 0;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const double difference = std::abs(value_at(formulas[i], letters) - numbers[i]);
    // Where nothing has a size, only what is equal agrees.
    const double part = difference == 0 ? 0 : difference / size;
    if (!(part <= misfit)) misfit = std::isnan(part) ? infinite : part;
  }
  return misfit;
}

bool agrees(const Value<Formula>& formula, const Value<double>& value, const LetterValues& letters, double tolerance,
            double natural) {
  return misfit_of(formula, value, letters, natural) <= tolerance;
}

void take_zeros(const Value<Formula>& formula, Value<double>& value) {
  const auto take = [](const Formula& exact, double& number) {
    if (exact.is_zero())
      number = 0;
    else if (number == 0)
      number = value_at(exact, {});
  };
  if (formula.is_number()) take(formula.number, value.number);
  if (formula.is_vector())
    for (std::size_t k = 0; k < 3; ++k) take(formula.vector[k], value.vector[k]);
  for (std::size_t i = 0; i < std::min(formula.items.size(), value.items.size()); ++i)
    take_zeros(formula.items[i], value.items[i]);
}

Value<Formula> substituted(const Value<Formula>& formula, const std::map<std::string, Formula>& letters) {
  Value<Formula> result = formula;
  if (formula.is_number()) result.number = poinsot::substituted(formula.number, letters);
  if (formula.is_vector())
    for (std::size_t k = 0; k < 3; ++k) result.vector[k] = poinsot::substituted(formula.vector[k], letters);
  for (Value<Formula>& item : result.items) item = substituted(item, letters);
  return result;
}

Value<Formula> as_formula(const Value<double>& value) {
  if (value.is_number()) return Value<Formula>::of_number(Formula(value.number), value.dimension);
  if (value.is_vector())
    return Value<Formula>::of_vector({Formula(value.vector.x), Formula(value.vector.y), Formula(value.vector.z)},
                                     value.dimension);
  std::vector<Value<Formula>> items;
  for (const Value<double>& item : value.items) items.push_back(as_formula(item));
  return Value<Formula>::of_list(std::move(items));
}

std::vector<std::string> letters_in(const Value<Formula>& formula) {
  std::set<std::string> letters;
  for (const Formula& number : numbers_of(formula))
    for (const std::string& letter : number.letters()) letters.insert(letter);
  return {letters.begin(), letters.end()};
}

}  // namespace poinsot::problem
