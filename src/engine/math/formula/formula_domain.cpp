#include "poinsot/engine/math/formula/formula_domain.h"

#include <algorithm>

#include "engine/math/formula/formula_fraction.h"
#include "poinsot/engine/math/formula/formula_sign.h"

namespace poinsot {
namespace symbolic {
namespace {

void collect_domain(const Formula& x, std::vector<Formula>& found) {
  if (!x.fraction()) return;
  for (const GeneratorPointer& g : *x.fraction()->generators) {
    collect_domain(g->argument, found);
    collect_domain(g->second, found);
    if (g->kind == Kind::inverse && g->name == "ln" && seen_sign(g->argument).sign <= 0 &&
        std::ranges::find(found, g->argument) == found.end())
      found.push_back(g->argument);
    if (g->kind != Kind::inverse || (g->name != "asin" && g->name != "acos")) continue;
    for (const Formula& rest : {1 - g->argument, 1 + g->argument})
      if (seen_sign(rest).sign <= 0 && std::ranges::find(found, rest) == found.end()) found.push_back(rest);
  }
}

// x with the generator's value in its place.
Formula with_value(const Formula& x, const GeneratorPointer& generator, int value) {
  return replaced(x, [&](const GeneratorPointer& g) {
    return same(g, generator) ? std::make_unique<Replacement>(Replacement{Formula(value), Formula(1)}) : nullptr;
  });
}

// slope * (inverse function) + rest, both numbers.
struct OfInverse {
  GeneratorPointer inverse;
  Formula slope, rest;
};
std::optional<OfInverse> of_inverse(const Formula& x) {
  if (x.is_number()) return std::nullopt;
  OfInverse found;
  for (const GeneratorPointer& g : *x.fraction()->generators) {
    if (g->kind == Kind::inverse && !g->constant) {
      if (found.inverse || g->name == "atan2" || g->name == "ln") return std::nullopt;
      found.inverse = g;
    }
  }
  if (!found.inverse) return std::nullopt;
  found.rest = with_value(x, found.inverse, 0);
  found.slope = with_value(x, found.inverse, 1) - found.rest;
  if (!found.rest.is_number() || !found.slope.is_number() || found.slope.is_zero()) return std::nullopt;
  if (found.slope * generator_formula(found.inverse) + found.rest != x) return std::nullopt;
  return found;
}

}  // namespace
}  // namespace symbolic

std::vector<Formula> not_negative_in_domain(const Formula& x) {
  std::vector<Formula> found;
  symbolic::collect_domain(x, found);
  return found;
}

std::vector<Formula> assumed_not_negative(const Formula& x) {
  std::vector<Formula> found;
  if (x.fraction() && x.fraction()->assumptions)
    for (const symbolic::Assumption& assumption : *x.fraction()->assumptions)
      if (!assumption.not_negative.is_zero()) found.push_back(assumption.not_negative);
  return found;
}

Formula bound_without_inverse(const Formula& x) {
  const auto parts = symbolic::of_inverse(x);
  if (!parts) return x;
  const symbolic::Generator& g = *parts->inverse;
  // The angle lies above or below the limit; acos falls from pi to 0 as its argument rises, the others rise from -pi/2
  // to pi/2.
  const Formula limit = -parts->rest / parts->slope;
  const bool falls = g.name == "acos";
  const Formula least = falls ? Formula(0) : -Formula::pi() / 2, most = least + Formula::pi();
  const bool above = plain(parts->slope) > 0;
  if (above ? plain(limit - most) >= 0 : plain(limit - least) <= 0) return x;  // holds nowhere
  if (above ? plain(limit - least) < 0 : plain(limit - most) > 0) return Formula(1);
  if (g.name == "atan" && (limit == least || limit == most)) return Formula(1);
  // Of a number of radians the function is no shorter than the angle.
  if (!(limit / Formula::pi()).is_rational()) return x;
  const Formula at_limit = falls ? cos(limit) : g.name == "asin" ? sin(limit) : tan(limit);
  return above == falls ? at_limit - g.argument : g.argument - at_limit;
}

}  // namespace poinsot
