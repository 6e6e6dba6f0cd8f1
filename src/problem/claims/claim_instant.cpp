#include "problem/claims/claim_instant.h"

#include <algorithm>
#include <set>

#include "poinsot/engine/math/formula/formula_decision.h"
#include "problem/claims/claim_letters.h"
#include "problem/formulas/formula_answers.h"
#include "problem/formulas/formula_unknowns.h"
#include "problem/language/diagnostic.h"
#include "problem/language/evaluate_support.h"

namespace poinsot::problem {
namespace {

// Follows names under define: to the expression that they stand for.
Expression behind_names(const Situation& situation, Expression expression) {
  for (int depth = 0; depth < 50; ++depth) {
    const Name* name = expression.as<Name>();
    if (!name || name->primes > 0) return expression;
    const auto item = std::find_if(situation.define.begin(), situation.define.end(),
                                   [&](const NamedExpression& known) { return known.name == name->name; });
    if (item == situation.define.end()) return expression;
    expression = item->value;
  }
  return expression;
}

// Whether the expression is an angle that lies between 0 and 180 deg for all values of the letters.
bool is_angle_between(const Situation& situation, const Expression& expression, const Value<Formula>& value) {
  if (value.number.is_number()) {
    const double angle = plain(value.number);
    return same_kind(value.dimension, dimensions::angle) && angle >= 0 && angle < 3.1415926535;
  }
  const Expression meant = behind_names(situation, expression);
  const Call* call = meant.as<Call>();
  if (!call) return false;
  for (const char* name : {"angle", "acute_angle", "body_cone", "space_cone", "acos"})
    if (call->function == name) return true;
  return false;
}

Relation reversed(Relation relation) {
  switch (relation) {
    case Relation::less:
      return Relation::greater;
    case Relation::less_equal:
      return Relation::greater_equal;
    case Relation::greater:
      return Relation::less;
    case Relation::greater_equal:
      return Relation::less_equal;
    case Relation::equal:
      break;
  }
  return Relation::equal;
}

// Returns what find() returns, and records the decisions on signs that it took.
template <class Find>
auto with_decisions(Decisions& decisions, const Find& find) {
  const DecisionScope scope;
  auto result = find();
  decisions.add({scope.signs(), scope.zeros_by_digits()});
  return result;
}

}  // namespace

void Decisions::add(const Decisions& other) {
  for (const Formula& sign : other.signs)
    if (std::find(signs.begin(), signs.end(), sign) == signs.end()) signs.push_back(sign);
  zeros_by_digits = zeros_by_digits || other.zeros_by_digits;
}

ClaimFormulas::ClaimFormulas(const Situation& situation, const FormulaValues& values, const Settings& settings,
                             const SolvedInstant& numbers, bool all_poses)
    : situation_(situation), values_(values), settings_(settings), numbers_(numbers) {
  open_.all_poses = open_.all_places = all_poses;
  instant_ = with_decisions(decisions_, [&] {
    auto instant = std::make_unique<FormulaInstant>(situation, values, numbers, &open_);
    if (states_forces(situation)) instant->solve_forces();
    return instant;
  });
  velocities_ = instant_->velocities_before_blow();
  if (!situation.neglect.empty()) neglect_squares();
}

void ClaimFormulas::neglect_squares() {
  small_ = neglected_letters(situation_, values_);
  std::vector<UnknownLetter> letters;
  for (const Unknown& unknown : situation_.find) {
    const Value<Formula>& value = values_.at(unknown.name);
    if (!value.number.is_number())
      letters.push_back({unknown.name, unknown.unit.dimension == dimensions::angle, plain(value.number)});
  }
  with_decisions(decisions_, [&] {
    instant_->solve_forces();
    return true;
  });
  std::vector<Formula> conditions;
  for (const Formula& remainder : instant_->remainders()) conditions.push_back(first_order(remainder, small_));
  unknowns_ = solve_unknowns(std::move(conditions), std::move(letters));
  for (Formula& sign : decisions_.signs) sign = reduced(sign);
  for (Formula& velocity : velocities_) velocity = reduced(velocity);
}

Formula ClaimFormulas::reduced(const Formula& x) const {
  return unknowns_.empty() ? x : substituted(first_order(x, small_), unknowns_);
}

Value<Formula> ClaimFormulas::reduced(Value<Formula> value) const {
  if (value.is_number()) value.number = reduced(value.number);
  if (value.is_vector())
    for (std::size_t k = 0; k < 3; ++k) value.vector[k] = reduced(value.vector[k]);
  for (Value<Formula>& item : value.items) item = reduced(std::move(item));
  return value;
}

ClaimFormulas& ClaimFormulas::before() {
  if (!before_) {
    before_numbers_ = std::make_unique<SolvedInstant>(situation_, settings_, When{0, false}, OpenChoice{});
    before_ = std::make_unique<ClaimFormulas>(situation_, values_, settings_, *before_numbers_, open_.all_poses);
  }
  return *before_;
}

Value<Formula> ClaimFormulas::elsewhere(const At& at, const Mark& mark, const std::optional<Expression>& axes) {
  if (numbers_.after_blow() && at.instant == "after") return instant_->raw(at.expression, axes, nullptr);
  if (numbers_.after_blow() && at.instant == "before") {
    const Found& found = before().value(at.expression, axes);
    for (const Formula& sign : found.decisions.signs) note_sign(sign);
    if (found.decisions.zeros_by_digits) note_zero_by_digits();
    return found.value;
  }
  fail(situation_.file, mark, "a claim is made of one instant, or of those before and after a blow",
       "remove @ " + at.instant);
}

const ClaimFormulas::Found& ClaimFormulas::value(const Expression& expression, const std::optional<Expression>& axes) {
  const std::string key = to_string(expression) + " on " + (axes ? to_string(*axes) : "");
  if (const auto known = found_.find(key); known != found_.end()) return known->second;
  Found found;
  found.value = reduced(with_decisions(found.decisions, [&] {
    return instant_->raw(expression, axes, [&](const At& at, const Mark& mark) { return elsewhere(at, mark, axes); });
  }));
  for (Formula& sign : found.decisions.signs) sign = reduced(sign);
  found.decisions.add(decisions_);
  return found_.emplace(key, std::move(found)).first->second;
}

ClaimInstant::ClaimInstant(ClaimFormulas& formulas, const Claim& claim) : formulas_(formulas) {
  decisions_ = formulas.decisions();
  for (const Expression& expression : claim.of) add_terms(expression, claim.axes, terms_);
  std::vector<ClaimTerm> assumed;
  for (const Expression& expression : formulas.situation().assume) add_terms(expression, std::nullopt, assumed);
  for (const Expression& expression : claim.assume) add_terms(expression, claim.axes, assumed);
  for (const ClaimTerm& term : assumed) assumptions_.push_back(term.comparison);
  for (const Formula& remainder : formulas.remainders())
    assumptions_.push_back({formulas.reduced(remainder), Formula(0), Relation::equal});
}

void ClaimInstant::add_terms(const Expression& expression, const std::optional<Expression>& axes,
                             std::vector<ClaimTerm>& terms) {
  const Comparison* comparison = expression.as<Comparison>();
  if (!comparison) throw NoFormula("whether this is true is told by numbers");
  const auto value = [&](const Expression& part) {
    const ClaimFormulas::Found& found = formulas_.value(part, axes);
    decisions_.add(found.decisions);
    return found.value;
  };
  std::vector<Value<Formula>> sides;
  for (const Expression& operand : comparison->operands) sides.push_back(as_vector(value(operand)));
  const Situation& situation = formulas_.situation();
  for (std::size_t i = 0; i < comparison->relations.size(); ++i) {
    Value<Formula> left = sides[i], right = sides[i + 1];
    const Relation relation = comparison->relations[i];
    // A bare zero can be compared with a vector. For all other pairs the evaluator tells what can be compared.
    const bool zero_vector = relation == Relation::equal && ((left.is_vector() && right.is_number() && right.bare) ||
                                                             (right.is_vector() && left.is_number() && left.bare));
    const bool alike = ((left.is_number() && right.is_number()) ||
                        (left.is_vector() && right.is_vector() && relation == Relation::equal)) &&
                       left.dimension == right.dimension && left.bare == right.bare;
    if (zero_vector) {
      Value<Formula>& zero = left.is_vector() ? right : left;
      if (!zero.number.is_zero()) fail(situation.file, expression.mark(), "a vector is compared with a number");
      zero = Value<Formula>::of_vector({}, left.is_vector() ? left.dimension : right.dimension);
    } else if (!alike) {
      value(expression);
    }
    const std::string of = to_string(comparison->operands[i]) + " " + std::string(symbol(relation)) + " " +
                           to_string(comparison->operands[i + 1]);
    if (left.is_vector()) {
      for (std::size_t k = 0; k < 3; ++k)
        terms.push_back(
            {{left.vector[k], right.vector[k], relation}, std::nullopt, left.dimension, of, static_cast<int>(k)});
      continue;
    }
    ClaimTerm term{{left.number, right.number, relation},
                   std::nullopt,
                   left.number.is_zero() ? right.dimension : left.dimension,
                   of};
    if (relation != Relation::equal && is_angle_between(situation, comparison->operands[i], left) &&
        is_angle_between(situation, comparison->operands[i + 1], right))
      term.by_cosines = FormulaComparison{cos(left.number), cos(right.number), reversed(relation)};
    terms.push_back(std::move(term));
  }
}

std::vector<std::string> ClaimInstant::unfixed() const {
  std::set<std::string> found;
  for (const ClaimTerm& term : terms_)
    for (const std::string& letter : term.comparison.difference().letters())
      if (formulas_.open().unfixed.contains(letter)) found.insert(letter);
  return {found.begin(), found.end()};
}

}  // namespace poinsot::problem
