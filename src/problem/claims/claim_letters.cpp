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
  Point all = from, at_zero;
  for (const Letter& letter : letters) {
    const auto first = std::ranges::find_if(letters, [&](const Letter& other) { return alike(letter, other); });
    if (first != letters.end()) all[letter.name] = std::abs(from.at(first->name));
  }
  at_zero = all;
  for (const Letter& letter : letters)
    if (letter.either_sign) at_zero[letter.name] = 0;
  for (const Point& point : {all, at_zero})
    if (point != from) points.push_back(point);
  constexpr std::size_t most_points = 12;
  for (std::size_t i = 0; i < letters.size(); ++i)
    for (std::size_t k = i + 1; k < letters.size() && points.size() < most_points; ++k)
      if (alike(letters[i], letters[k])) {
        points.push_back(from);
        points.back()[letters[k].name] = std::abs(from.at(letters[i].name));
      }
  return points;
}

bool is_strict(const Claim& claim) {
  const auto strict = [](const auto& self, const Expression& expression) -> bool {
    if (const Comparison* comparison = expression.as<Comparison>())
      if (std::ranges::any_of(comparison->relations,
                              [](Relation r) { return r == Relation::less || r == Relation::greater; }))
        return true;
    return any_child(expression, [&](const Expression& part) { return self(self, part); });
  };
  return std::ranges::any_of(claim.of, [&](const Expression& one) { return strict(strict, one); });
}

}  // namespace poinsot::problem
