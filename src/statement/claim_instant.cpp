#include "statement/claim_instant.h"

#include <algorithm>
#include <functional>

#include "statement/reader.h"

namespace poinsot::statement {
namespace {

bool is_any(const Expression& expression) {
  const Name* name = expression.as<Name>();
  return name && name->name == "any" && name->primes == 0;
}

bool is_bare_zero(const Expression& expression) {
  const Number* number = expression.as<Number>();
  return number && number->value == 0;
}

// Puts letters in place of `any`.
class AnyReplacer {
 public:
  explicit AnyReplacer(Problem& problem) : problem_(problem) {}

  void replace(std::optional<Expression>& expression, const std::string& name, const Dimension& dimension,
               bool either_sign = false) {
    if (expression) replace(*expression, name, dimension, either_sign);
  }
  void replace(Expression& expression, const std::string& name, const Dimension& dimension, bool either_sign = false) {
    if (!is_any(expression)) return;
    problem_.letters.push_back({name, si_unit(dimension), expression.mark(), either_sign});
    expression = {std::make_shared<const Node>(Node{Name{name, 0}, expression.mark(), 1})};
  }

 private:
  Problem& problem_;
};

// Whether a rate is taken in an expression, also behind define:.
struct RateFinder {
  const Problem& problem;
  int depth = 0;
  bool in(const Expression& expression) const {
    return expression && depth < 100 && std::visit(RateFinder{problem, depth + 1}, expression->content);
  }
  bool in(const std::vector<Expression>& items) const {
    return std::any_of(items.begin(), items.end(), [&](const Expression& item) { return in(item); });
  }
  bool operator()(const Name& name) const {
    for (const NamedExpression& item : problem.define)
      if (item.name == name.name) return name.primes > 0 || in(item.value);
    return false;
  }
  bool operator()(const Member& member) const { return in(member.object); }
  bool operator()(const Unary& unary) const { return in(unary.operand); }
  bool operator()(const Binary& binary) const { return in(binary.left) || in(binary.right); }
  bool operator()(const Call& call) const {
    return call.function == "rate" || std::any_of(call.arguments.begin(), call.arguments.end(),
                                                  [&](const Argument& argument) { return in(argument.value); });
  }
  bool operator()(const List& list) const { return in(list.items); }
  bool operator()(const Comparison& comparison) const { return in(comparison.operands); }
  template <class Other>
  bool operator()(const Other&) const {
    return false;
  }
};

// The functions called in an expression, also behind define:.
void functions_behind(const Problem& problem, const Expression& expression, std::set<std::string>& functions,
                      int depth = 0) {
  collect_functions(expression, functions);
  std::set<std::string> names;
  collect_names(expression, names);
  for (const NamedExpression& item : problem.define)
    if (names.contains(item.name) && depth < 50) functions_behind(problem, item.value, functions, depth + 1);
}

// What a name under define: stands for.
Expression behind_names(const Problem& problem, Expression expression) {
  for (int depth = 0; depth < 50; ++depth) {
    const Name* name = expression.as<Name>();
    if (!name || name->primes > 0) return expression;
    const auto item = std::find_if(problem.define.begin(), problem.define.end(),
                                   [&](const NamedExpression& known) { return known.name == name->name; });
    if (item == problem.define.end()) return expression;
    expression = item->value;
  }
  return expression;
}

// Whether it is an angle from 0 to 180 deg whatever the letters are.
bool is_angle_between(const Problem& problem, const Expression& expression, const Value<Formula>& value) {
  if (value.number.is_number()) {
    const double angle = plain(value.number);
    return same_kind(value.dimension, dimensions::angle) && angle >= 0 && angle < 3.1415926535;
  }
  const Expression meant = behind_names(problem, expression);
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

}  // namespace

Problem with_letters_for_any(const Problem& problem) {
  Problem result = problem;
  AnyReplacer replacer(result);
  for (Body& body : result.bodies) {
    const std::string of = "(" + body.name + ")";
    replacer.replace(body.amount.mass, "mass" + of, dimensions::mass);
    replacer.replace(body.amount.weight, "weight" + of, dimensions::force);
    for (Part& part : body.parts) {
      replacer.replace(part.amount.mass, "mass(" + part.name + " of " + body.name + ")", dimensions::mass);
      replacer.replace(part.amount.weight, "weight(" + part.name + " of " + body.name + ")", dimensions::force);
    }
    if (const List* list = body.center ? body.center->as<List>() : nullptr) {
      List center = *list;
      for (std::size_t k = 0; k < center.items.size() && k < 3; ++k)
        replacer.replace(center.items[k], "center" + of + "." + result.axes[k], dimensions::length, true);
      body.center = Expression{std::make_shared<const Node>(Node{center, body.center->mark(), (*body.center)->height})};
    }
    if (!body.inertia) continue;
    const char* pairs[3][2] = {{"x", "y"}, {"y", "z"}, {"z", "x"}};
    for (std::size_t k = 0; k < 3; ++k) {
      replacer.replace(body.inertia->products[k], std::string("I") + pairs[k][0] + pairs[k][1] + of,
                       dimensions::moment_of_inertia, true);
      // Left open beside others a moment is chosen so that the body is possible; alone it is a letter.
    }
    replacer.replace(body.inertia->axial, "axial" + of, dimensions::moment_of_inertia);
    replacer.replace(body.inertia->transverse, "transverse" + of, dimensions::moment_of_inertia);
  }
  if (!result.gravity) {
    List gravity;
    for (const std::string& axis : result.axes) {
      const std::string name = "gravity." + axis;
      result.letters.push_back({name, si_unit(dimensions::acceleration), {1, 1}, true});
      gravity.items.push_back({std::make_shared<const Node>(Node{Name{name, 0}, {1, 1}, 1})});
    }
    result.gravity = Expression{std::make_shared<const Node>(Node{gravity, {1, 1}, 2})};
  }
  return result;
}

bool is_along_motion(const Problem& problem, const Claim& claim) {
  return std::any_of(claim.of.begin(), claim.of.end(), [&](const Expression& expression) {
    const Comparison* comparison = expression.as<Comparison>();
    return comparison && RateFinder{problem}.in(comparison->operands) &&
           std::any_of(comparison->operands.begin(), comparison->operands.end(), is_bare_zero);
  });
}

bool states_forces(const Problem& problem) {
  if (problem.steady) return true;
  for (const Instant* instant : instants_at_start(problem))
    for (const Fact& fact : instant->facts)
      if (level_of(problem, fact.quantity) >= Level::force) return true;
  return false;
}

bool takes_derivatives(const Problem& problem, const Claim& claim) {
  std::set<std::string> functions;
  for (const auto* list : {&claim.of, &claim.assume, &problem.assume})
    for (const Expression& expression : *list) functions_behind(problem, expression, functions);
  return functions.contains("derivative");
}

ClaimInstant::ClaimInstant(const Problem& problem, const Claim& claim, const FormulaValues& values,
                           const SolvedInstant& numbers)
    : problem_(problem), values_(values), numbers_(numbers) {
  open_.all_poses = is_along_motion(problem, claim);
  instant_ = std::make_unique<FormulaInstant>(problem, values, numbers, &open_);
  if (states_forces(problem)) instant_->solve_forces();
  for (const Expression& expression : claim.of) add_terms(expression, claim.axes, terms_);
  std::vector<ClaimTerm> assumed;
  for (const Expression& expression : problem.assume) add_terms(expression, std::nullopt, assumed);
  for (const Expression& expression : claim.assume) add_terms(expression, claim.axes, assumed);
  for (const ClaimTerm& term : assumed) assumptions_.push_back(term.comparison);
  for (const Formula& remainder : instant_->remainders())
    assumptions_.push_back({remainder, Formula(0), Relation::equal});
}

Value<Formula> ClaimInstant::value(const Expression& expression, const std::optional<Expression>& axes) {
  return instant_->raw(expression, axes, [&](const At& at, const Mark& mark) {
    if (numbers_.after_blow() && at.instant == "after") return instant_->raw(at.expression, axes, nullptr);
    if (!numbers_.after_blow() || at.instant != "before")
      fail(problem_.file, mark, "a claim is made of one instant, or of those before and after a blow",
           "remove @ " + at.instant);
    throw NoFormula("the instant before the blow stands apart");
  });
}

void ClaimInstant::add_terms(const Expression& expression, const std::optional<Expression>& axes,
                             std::vector<ClaimTerm>& terms) {
  const Comparison* comparison = expression.as<Comparison>();
  if (!comparison) throw NoFormula("whether this is true is told by numbers");
  std::vector<Value<Formula>> sides;
  for (const Expression& operand : comparison->operands) sides.push_back(value(operand, axes));
  for (std::size_t i = 0; i < comparison->relations.size(); ++i) {
    Value<Formula> left = sides[i], right = sides[i + 1];
    const Relation relation = comparison->relations[i];
    // A bare zero is the zero vector too; for all else the evaluator says what can be compared.
    const bool zero_vector = relation == Relation::equal && ((left.is_vector() && right.is_number() && right.bare) ||
                                                             (right.is_vector() && left.is_number() && left.bare));
    if (zero_vector) {
      Value<Formula>& zero = left.is_vector() ? right : left;
      if (!zero.number.is_zero()) fail(problem_.file, expression.mark(), "a vector is compared with a number");
      zero = Value<Formula>::of_vector({}, left.is_vector() ? left.dimension : right.dimension);
    } else if (i == 0) {
      value(expression, axes);
    }
    if (left.is_vector()) {
      for (std::size_t k = 0; k < 3; ++k)
        terms.push_back({{left.vector[k], right.vector[k], relation}, std::nullopt, left.dimension});
      continue;
    }
    ClaimTerm term{
        {left.number, right.number, relation}, std::nullopt, left.number.is_zero() ? right.dimension : left.dimension};
    if (relation != Relation::equal && is_angle_between(problem_, comparison->operands[i], left) &&
        is_angle_between(problem_, comparison->operands[i + 1], right))
      term.by_cosines = FormulaComparison{cos(left.number), cos(right.number), reversed(relation)};
    terms.push_back(std::move(term));
  }
}

std::vector<std::string> ClaimInstant::unfixed() const {
  std::set<std::string> found;
  for (const ClaimTerm& term : terms_)
    for (const std::string& letter : term.comparison.difference().letters())
      if (open_.unfixed.contains(letter)) found.insert(letter);
  return {found.begin(), found.end()};
}

}  // namespace poinsot::statement
