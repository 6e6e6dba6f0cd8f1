#include "problem/claims/claim_rates.h"

#include <algorithm>
#include <memory>

#include "poinsot/engine/solve/instant/mechanism_state.h"
#include "problem/language/expression_walk.h"

namespace poinsot::problem {
namespace {

constexpr int most_names = 50;  // bound for names that stand for further names

const NamedExpression* definition(const Situation& situation, const std::string& name) {
  const auto found = std::find_if(situation.define.begin(), situation.define.end(),
                                  [&](const NamedExpression& item) { return item.name == name; });
  return found == situation.define.end() ? nullptr : &*found;
}

// The X of rate(X), or of a name for X with a prime; nothing for other expressions.
Expression differentiated(const Situation& situation, Expression expression) {
  for (int depth = 0; depth < most_names; ++depth) {
    if (const Call* call = expression.as<Call>())
      return call->function == "rate" && call->arguments.size() == 1 ? call->arguments.front().value : Expression{};
    const Name* name = expression.as<Name>();
    const NamedExpression* item = name ? definition(situation, name->name) : nullptr;
    if (!item || name->primes > 1) return {};
    if (name->primes == 1) return item->value;
    expression = item->value;
  }
  return {};
}

struct Addend {
  Expression expression;
  bool negative = false;
};
void collect_addends(const Situation& situation, const Expression& expression, bool negative,
                     std::vector<Addend>& addends, int depth = 0) {
  const Binary* sum = expression.as<Binary>();
  const Name* name = expression.as<Name>();
  const NamedExpression* item = name && name->primes == 0 ? definition(situation, name->name) : nullptr;
  // A name for a sum is replaced by its addends. Any other name stays, as it says more to a reader than what it
  // stands for.
  const Binary* named = item ? item->value.as<Binary>() : nullptr;
  if (sum && (sum->operation == '+' || sum->operation == '-') && depth < most_names) {
    collect_addends(situation, sum->left, negative, addends, depth + 1);
    collect_addends(situation, sum->right, sum->operation == '-' ? !negative : negative, addends, depth + 1);
  } else if (named && (named->operation == '+' || named->operation == '-') && depth < most_names) {
    collect_addends(situation, item->value, negative, addends, depth + 1);
  } else {
    addends.push_back({expression, negative});
  }
}

Expression rate_of(const Expression& expression) {
  return built(Call{"rate", {Argument{"", expression}}}, expression.mark());
}

bool add_up(const std::vector<SolvedClaim::Part>& parts, const Formula& whole) {
  Formula sum;
  for (const SolvedClaim::Part& part : parts) sum += part.value;
  return (sum - whole).is_zero();
}

std::vector<SolvedClaim::Part> by_addends(ClaimFormulas& formulas, const std::optional<Expression>& axes,
                                          const Expression& of) {
  std::vector<Addend> addends;
  collect_addends(formulas.situation(), of, false, addends);
  std::vector<SolvedClaim::Part> parts;
  if (addends.size() < 2) return parts;
  for (const Addend& addend : addends) {
    const Value<Formula>& rate = formulas.value(rate_of(addend.expression), axes).value;
    if (!rate.is_number()) return {};
    parts.push_back({(addend.negative ? "-" : "") + to_string(addend.expression), false,
                     addend.negative ? -rate.number : rate.number});
  }
  return parts;
}

// The rate of a letter that stands for a position or a velocity; nothing for other letters.
std::optional<Formula> rate_of_letter(ClaimFormulas& formulas, const std::string& name) {
  const Formula letter = Formula::letter(name, poinsot::Sign::real);
  const std::vector<Formula>& v = formulas.velocities();
  const std::vector<Formula>& a = formulas.instant().mechanism_state().accelerations();
  for (std::size_t k = 0; k < v.size() && k < a.size(); ++k)
    if (v[k] == letter) return a[k];
  const auto& tree = formulas.instant().machine().mechanism.tree;
  for (int i = 0; i < tree.body_count(); ++i) {
    const auto& body = tree.body(i);
    if (body.joint != JointType::revolute && body.joint != JointType::prismatic) continue;
    if (formulas.positions()[static_cast<std::size_t>(body.q)] == letter) return v[static_cast<std::size_t>(body.v)];
  }
  return std::nullopt;
}

std::vector<SolvedClaim::Part> by_letters(ClaimFormulas& formulas, const std::optional<Expression>& axes,
                                          const Expression& of) {
  const Value<Formula>& value = formulas.value(of, axes).value;
  std::vector<SolvedClaim::Part> parts;
  if (!value.is_number()) return parts;
  for (const Letter& letter : formulas.open().made) {
    const Formula slope = derivative(value.number, letter.name);
    if (slope.is_zero()) continue;
    const auto rate = rate_of_letter(formulas, letter.name);
    if (!rate) return {};
    if (!rate->is_zero()) parts.push_back({letter.name, true, slope * *rate});
  }
  return parts;
}

}  // namespace

void add_rate_parts(ClaimFormulas& formulas, const Claim& claim, std::vector<SolvedClaim::Comparison>& comparisons) {
  if (formulas.situation().has_blow()) return;
  std::size_t next = 0;
  for (const Expression& expression : claim.of) {
    const Comparison* comparison = expression.as<Comparison>();
    if (!comparison) return;
    for (std::size_t i = 0; i < comparison->relations.size(); ++i) {
      const bool vector = formulas.value(comparison->operands[i], claim.axes).value.is_vector() ||
                          formulas.value(comparison->operands[i + 1], claim.axes).value.is_vector();
      const std::size_t here = next;
      next += vector ? 3 : 1;
      if (vector || here >= comparisons.size()) continue;
      SolvedClaim::Comparison& told = comparisons[here];
      for (const bool left : {true, false}) {
        if (!(left ? told.right : told.left).is_zero()) continue;
        const Expression of = differentiated(formulas.situation(), comparison->operands[left ? i : i + 1]);
        if (!of) continue;
        std::vector<SolvedClaim::Part> parts = by_addends(formulas, claim.axes, of);
        if (parts.empty()) parts = by_letters(formulas, claim.axes, of);
        if (parts.size() > 1 && add_up(parts, left ? told.left : told.right)) told.parts = std::move(parts);
      }
    }
  }
}

}  // namespace poinsot::problem
