// The letters and functions that formulas are made of.
#include <algorithm>
#include <stdexcept>

#include "engine/math/formula/formula_fraction.h"

namespace poinsot::symbolic {
namespace {

std::string key_of(const Fraction& f, const Polynomial& polynomial) {
  std::string key;
  for (std::size_t i = 0; i < polynomial.length(); ++i) {
    key += polynomial.coefficient(i).text();
    const std::vector<int> powers = polynomial.exponents(i);
    for (std::size_t v = 0; v < f.generators->size(); ++v) {
      if (powers[v] != 0) key += "*" + (*f.generators)[v]->key + "^" + std::to_string(powers[v]);
    }
    key += ";";
  }
  return "(" + key + ")";
}

// Roots in roots come after those they hold, so that squares can be replaced from the last to the first.
std::size_t depth_of(const Formula& x) {
  std::size_t depth = 0;
  if (!x.fraction()) return depth;
  for (const GeneratorPointer& g : *x.fraction()->generators) {
    if (g->kind == Kind::root) depth = std::max(depth, depth_of(g->argument) + 1);
  }
  return depth;
}

bool has_roots(const Formula& x) { return depth_of(x) > 0; }

}  // namespace

std::string key_of(const Formula& x) {
  if (!x.fraction()) return "(0)";
  const Fraction& f = *x.fraction();
  return key_of(f, f.numerator) + "/" + key_of(f, f.denominator);
}

GeneratorPointer letter_generator(const std::string& name, Sign sign) {
  Generator g;
  g.kind = Kind::letter;
  g.name = name;
  g.key = name;
  g.sign = sign;
  g.positive = sign == Sign::positive;
  return std::make_shared<const Generator>(std::move(g));
}

GeneratorPointer pi_generator() {
  static const GeneratorPointer pi = [] {
    Generator g;
    g.kind = Kind::pi;
    g.name = g.key = "pi";
    g.positive = g.constant = true;
    return std::make_shared<const Generator>(std::move(g));
  }();
  return pi;
}

GeneratorPointer tangent_generator(Kind kind, const Formula& argument, Ratio multiple) {
  Generator g;
  g.kind = kind;
  g.argument = argument;
  g.multiple = multiple;
  g.key = "tan[" + key_of(argument) + "@" + std::to_string(multiple.numerator) + "/" +
          std::to_string(multiple.denominator) + "]";
  g.constant = g.doubtful = argument.is_number();
  // Parts of pi are brought to the first octant, where the tangent of the half is positive.
  g.positive = g.constant && !argument.is_rational() && kind == Kind::constant_tangent;
  return std::make_shared<const Generator>(std::move(g));
}

GeneratorPointer inverse_generator(const std::string& function, const Formula& argument, const Formula& second) {
  Generator g;
  g.kind = Kind::inverse;
  g.name = function;
  g.argument = argument;
  g.second = second;
  g.key = function + "[" + key_of(argument) + "," + key_of(second) + "]";
  g.constant = argument.is_number() && second.is_number();
  g.doubtful = true;
  return std::make_shared<const Generator>(std::move(g));
}

GeneratorPointer exponential_generator(const Formula& argument, Ratio multiple) {
  Generator g;
  g.kind = Kind::exponential;
  g.argument = argument;
  g.multiple = multiple;
  g.key = "exp[" + key_of(argument) + "@" + std::to_string(multiple.numerator) + "/" +
          std::to_string(multiple.denominator) + "]";
  g.positive = true;
  g.constant = argument.is_number();
  // e^(a/2) and e^(a/3) depend on each other, and of numbers little is known.
  g.doubtful = g.constant || !(multiple == Ratio{1, 1}) ||
               std::ranges::any_of(*argument.fraction()->generators, &Generator::doubtful);
  return std::make_shared<const Generator>(std::move(g));
}

GeneratorPointer sign_generator(const Formula& argument) {
  Generator g;
  g.kind = Kind::sign;
  g.argument = argument;
  g.key = "sign[" + key_of(argument) + "]";
  g.needs = *argument.fraction()->generators;
  g.constant = argument.is_number();
  return std::make_shared<const Generator>(std::move(g));
}

GeneratorPointer root_generator(const Formula& radicand, bool dependent) {
  Generator g;
  g.kind = Kind::root;
  g.argument = radicand;
  // A letter stands for each level: roots sort by depth first.
  g.key = std::string(1, static_cast<char>('a' + std::min<std::size_t>(depth_of(radicand), 25))) + "[" +
          key_of(radicand) + "]";
  g.needs = *radicand.fraction()->generators;
  g.positive = true;
  g.constant = radicand.is_number();
  g.doubtful = dependent || has_roots(radicand);
  return std::make_shared<const Generator>(std::move(g));
}

bool before(const GeneratorPointer& a, const GeneratorPointer& b) {
  return a->kind != b->kind ? a->kind < b->kind : a->key < b->key;
}

bool same(const GeneratorPointer& a, const GeneratorPointer& b) {
  if (a == b) return true;
  if (a->kind != b->kind || a->key != b->key) return false;
  if (a->sign != b->sign) throw std::invalid_argument("the letter " + a->name + " is both positive and of any sign");
  return true;
}

bool has_arguments(const Generator& generator) {
  return is_algebraic(generator) || generator.kind == Kind::inverse || generator.kind == Kind::exponential;
}

bool is_algebraic(const Generator& generator) { return generator.kind == Kind::root || generator.kind == Kind::sign; }

}  // namespace poinsot::symbolic
