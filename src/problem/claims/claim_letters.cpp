#include "problem/claims/claim_letters.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>

#include "problem/instant/instant.h"
#include "problem/language/diagnostic.h"
#include "problem/language/expression_walk.h"

namespace poinsot::problem {
namespace {

bool is_literal_zero(const Expression& expression) {
  const Number* number = expression.as<Number>();
  return number && number->value == 0;
}

// Replaces `any` by letters.
class AnyReplacer {
 public:
  explicit AnyReplacer(Situation& situation) : situation_(situation) {}

  void replace(std::optional<Expression>& expression, const std::string& name, const Dimension& dimension,
               bool either_sign = false) {
    if (expression) replace(*expression, name, dimension, either_sign);
  }
  void replace(Expression& expression, const std::string& name, const Dimension& dimension, bool either_sign = false) {
    if (is_any(expression)) expression = letter(name, dimension, expression.mark(), either_sign);
  }
  // Makes a letter of a value that is not stated at all.
  void make(std::optional<Expression>& expression, const std::string& name, const Dimension& dimension,
            const Mark& mark, bool either_sign = false) {
    if (!expression) expression = letter(name, dimension, mark, either_sign);
  }
  Expression letter(const std::string& name, const Dimension& dimension, const Mark& mark, bool either_sign) {
    situation_.letters.push_back({name, si_unit(dimension), mark, either_sign});
    return built(Name{name}, mark);
  }

 private:
  Situation& situation_;
};

// Whether an expression takes a rate, also within names under define:.
bool takes_rate(const Situation& situation, const Expression& expression, int depth = 0) {
  if (depth >= 100) return false;
  if (const Call* call = expression.as<Call>(); call && call->function == "rate") return true;
  if (const Name* name = expression.as<Name>())
    for (const NamedExpression& item : situation.define)
      if (item.name == name->name) return name->primes > 0 || takes_rate(situation, item.value, depth + 1);
  return any_child(expression, [&](const Expression& child) { return takes_rate(situation, child, depth + 1); });
}

// Collects the functions that an expression calls, also within names under define:.
void functions_behind(const Situation& situation, const Expression& expression, std::set<std::string>& functions,
                      int depth = 0) {
  collect_functions(expression, functions);
  std::set<std::string> names;
  collect_names(expression, names);
  for (const NamedExpression& item : situation.define)
    if (names.contains(item.name) && depth < 50) functions_behind(situation, item.value, functions, depth + 1);
}

// Moments and products of inertia become independent letters. Every sample is checked for values that a body can
// have; a proof holds for more values than these.
void replace_inertia(StatedInertia& inertia, const std::string& of, AnyReplacer& replacer) {
  const Dimension& dimension = inertia.radii ? dimensions::length : dimensions::moment_of_inertia;
  const std::string moment = inertia.radii ? "radius of gyration " : "I";
  const char* axes[3] = {"x", "y", "z"};
  const char* pairs[3] = {"xy", "yz", "zx"};
  for (std::size_t k = 0; k < 3; ++k) {
    const std::string moment_name = moment + axes[k] + of, product_name = std::string("I") + pairs[k] + of;
    replacer.replace(inertia.moments[k], moment_name, dimension);
    replacer.replace(inertia.products[k], product_name, dimensions::moment_of_inertia, true);
    if (!inertia.rest_any) continue;
    replacer.make(inertia.moments[k], moment_name, dimension, inertia.mark);
    if (!inertia.radii)
      replacer.make(inertia.products[k], product_name, dimensions::moment_of_inertia, inertia.mark, true);
  }
  replacer.replace(inertia.axial, (inertia.radii ? moment + "axial" : "axial") + of, dimension);
  replacer.replace(inertia.transverse, (inertia.radii ? moment + "transverse" : "transverse") + of, dimension);
}

// Whether a comparison in one of the expressions has one of two relations.
bool has_relation(const std::vector<Expression>& expressions, Relation one, Relation other) {
  const auto has = [&](const auto& self, const Expression& expression) -> bool {
    if (const Comparison* comparison = expression.as<Comparison>())
      if (std::ranges::any_of(comparison->relations, [&](Relation r) { return r == one || r == other; })) return true;
    return any_child(expression, [&](const Expression& part) { return self(self, part); });
  };
  return std::ranges::any_of(expressions, [&](const Expression& one_of) { return has(has, one_of); });
}

}  // namespace

Situation with_letters_for_any(const Situation& situation) {
  Situation result = situation;
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
      body.center = built(std::move(center), body.center->mark());
    }
    if (body.inertia) replace_inertia(*body.inertia, of, replacer);
  }
  if (!result.gravity) {
    List gravity;
    for (const std::string& axis : result.axes) {
      const std::string name = "gravity." + axis;
      result.letters.push_back({name, si_unit(dimensions::acceleration), {1, 1}, true});
      gravity.items.push_back(built(Name{name}, {1, 1}));
    }
    result.gravity = built(std::move(gravity), {1, 1});
  }
  return result;
}

bool is_along_motion(const Situation& situation, const Claim& claim) {
  return std::any_of(claim.of.begin(), claim.of.end(), [&](const Expression& expression) {
    const Comparison* comparison = expression.as<Comparison>();
    return comparison && takes_rate(situation, expression) &&
           std::any_of(comparison->operands.begin(), comparison->operands.end(), is_literal_zero);
  });
}

bool states_forces(const Situation& situation) {
  if (situation.steady) return true;
  for (const Instant* instant : instants_at_start(situation))
    for (const Fact& fact : instant->facts)
      if (level_of(situation, fact.quantity) >= Level::force) return true;
  return false;
}

bool takes_derivatives(const Situation& situation, const Claim& claim) {
  std::set<std::string> functions;
  for (const auto* list : {&claim.of, &claim.assume, &situation.assume})
    for (const Expression& expression : *list) functions_behind(situation, expression, functions);
  return functions.contains("derivative");
}

std::vector<Point> alike_points(const std::vector<Letter>& letters, const Point& from) {
  const auto alike = [](const Letter& a, const Letter& b) {
    return a.unit.dimension == b.unit.dimension && a.unit.dimension != dimensions::angle;
  };
  std::vector<Point> points;
  Point all = from;
  for (const Letter& letter : letters) {
    const auto first = std::ranges::find_if(letters, [&](const Letter& other) { return alike(letter, other); });
    if (first != letters.end()) all[letter.name] = std::abs(from.at(first->name));
  }
  const auto add_with_zeros = [&](const Point& point) {
    if (point != from) points.push_back(point);
    Point at_zero = point;
    for (const Letter& letter : letters)
      if (letter.either_sign) at_zero[letter.name] = 0;
    if (at_zero != point && at_zero != from) points.push_back(at_zero);
  };
  add_with_zeros(all);
  constexpr std::size_t most_pairs = 12;
  const auto add_pairs = [&](double ratio) {
    std::size_t added = 0;
    for (std::size_t i = 0; i < letters.size(); ++i)
      for (std::size_t k = i + 1; k < letters.size() && added < most_pairs; ++k)
        if (alike(letters[i], letters[k])) {
          points.push_back(from);
          points.back()[letters[k].name] = ratio * std::abs(from.at(letters[i].name));
          ++added;
        }
  };
  add_pairs(1);
  // Each is twice the one before of its kind, or half of it: a difference such as a - 2*b vanishes there.
  for (const double ratio : {0.5, 2.0}) {
    Point doubled = all;
    bool any = false;
    for (std::size_t k = 1; k < letters.size(); ++k)
      for (std::size_t i = k; i-- > 0;)
        if (alike(letters[i], letters[k])) {
          doubled[letters[k].name] = ratio * doubled[letters[i].name];
          any = true;
          break;
        }
    if (any) add_with_zeros(doubled);
    add_pairs(ratio);
  }
  return points;
}

bool is_strict(const std::vector<Expression>& claimed) {
  return has_relation(claimed, Relation::less, Relation::greater);
}

bool has_closed_end(const std::vector<Expression>& assumed) {
  return has_relation(assumed, Relation::less_equal, Relation::greater_equal);
}

}  // namespace poinsot::problem
