#include "engine/math/formula/formula_nearest.h"

#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <unordered_map>

#include "engine/math/formula/formula_digits.h"

namespace poinsot::symbolic {
namespace {

constexpr std::size_t most_kept = 200;        // formulas that are ready
constexpr std::size_t most_terms_kept = 500;  // of each; where there are more, balls cost little beside it

Rounded unbounded() { return {0.0L, std::numeric_limits<long double>::infinity()}; }

// Functions of the library are good to one or two of the last places.
Rounded of_library(long double value, long double carried) { return {value, carried + 4 * Rounded::own(value)}; }

Rounded tangent(const Rounded& x) {
  // Far from the origin the library's reduction of the angle, and near a pole the slope, is left to balls.
  if (!(x.size() < 1e3L) || !(x.error < 1e-3L)) return unbounded();
  const long double value = std::tan(x.value);
  if (!(std::fabs(value) < 30)) return unbounded();
  const long double end = std::fabs(value) + 1;  // tan changes by less than one within a thousandth
  return of_library(value, x.error * (1 + end * end));
}

Rounded exponential(const Rounded& x) {
  if (!(x.size() < 1e3L) || !(x.error < 1e-3L)) return unbounded();
  const long double value = std::exp(x.value);
  constexpr long double steeper = 1.002L;  // e^x grows by less within a thousandth
  return of_library(value, steeper * x.error * value);
}

Rounded logarithm(const Rounded& x) {
  const long double least = x.value - x.error;
  // Beside 1 the logarithm is small and its last places are those of the difference.
  if (!(least > 0) || !(std::fabs(x.value - 1) > 1e-3L)) return unbounded();
  return of_library(std::log(x.value), x.error / least);
}

Rounded inverse(const Generator& g, const Rounded& x, const Rounded& second) {
  if (g.name == "ln") return logarithm(x);
  if (g.name == "atan") return of_library(std::atan(x.value), x.error);
  if (g.name == "asin" || g.name == "acos") {
    // The rate is that at the farther end of what the argument may be.
    const long double end = x.size() + x.error;
    if (!(end < 1)) return unbounded();
    const long double carried = x.error / std::sqrt((1 - end) * (1 + end));
    return of_library(g.name == "asin" ? std::asin(x.value) : std::acos(x.value), carried);
  }
  const Rounded angle = atan2(x, second);
  // Beside the cut the angle may be on either side of it.
  if (!(std::fabs(angle.value) + angle.error < 3.14L)) return unbounded();
  return of_library(angle.value, angle.error);
}

}  // namespace

ReadyFormula::ReadyFormula(const Formula& x) : of_(x), whole_(quotient(x)) {}

ReadyFormula::Quotient ReadyFormula::quotient(const Formula& x) {
  Quotient made;
  if (!x.fraction()) {
    made.below.terms.push_back({1, 0});
    return made;
  }
  const Fraction& f = *x.fraction();
  std::vector<std::uint32_t> nodes;
  for (const GeneratorPointer& generator : *f.generators) nodes.push_back(node(generator));
  made.above = sum(f.numerator, nodes);
  made.below = sum(f.denominator, nodes);
  return made;
}

ReadyFormula::Sum ReadyFormula::sum(const Polynomial& polynomial, const std::vector<std::uint32_t>& nodes) {
  Sum made;
  made.variables = nodes.size();
  for (std::size_t i = 0; i < polynomial.length(); ++i) {
    const Integer coefficient = polynomial.coefficient(i);
    fits_ = fits_ && fmpz_fits_si(coefficient.get()) != 0;
    if (!fits_) return made;
    const std::vector<int> powers = polynomial.exponents(i);
    made.terms.push_back({static_cast<long double>(fmpz_get_si(coefficient.get())), 0});
    for (std::size_t v = 0; v < nodes.size(); ++v) {
      if (powers[v] == 0) continue;
      made.factors.push_back({nodes[v], static_cast<std::uint32_t>(powers[v])});
      ++made.terms.back().factors;
    }
  }
  return made;
}

std::uint32_t ReadyFormula::node(const GeneratorPointer& generator) {
  if (const auto known = known_.find(generator.get()); known != known_.end()) return known->second;
  Node made{generator.get()};
  made.argument = quotient(generator->argument);
  made.second = quotient(generator->second);
  nodes_.push_back(std::move(made));
  return known_[generator.get()] = static_cast<std::uint32_t>(nodes_.size() - 1);
}

// The parts by which factors are off add up; where they are small their products are far within what is added for them.
Rounded ReadyFormula::product(const Term& term, const Factor* factors, const std::vector<Value>& nodes) {
  constexpr long double most_parts = 1e-5L, products_of_parts = 1.0001L;
  long double value = term.coefficient, parts = 0;
  for (std::uint32_t k = 0; k < term.factors; ++k) {
    const Value& node = nodes[factors[k].node];
    for (std::uint32_t p = 0; p < factors[k].power; ++p) {
      value *= node.number.value;
      parts += node.part;
    }
  }
  if (parts <= most_parts) return {value, std::fabs(value) * parts * products_of_parts};
  Rounded product(term.coefficient);
  for (std::uint32_t k = 0; k < term.factors; ++k)
    for (std::uint32_t p = 0; p < factors[k].power; ++p) product *= nodes[factors[k].node].number;
  return product;
}

Rounded ReadyFormula::value(const Sum& sum, const std::vector<Value>& nodes) {
  count_digits_of(sum.terms.size(), sum.variables, digits_of_nearest);
  Rounded total;
  const Factor* factors = sum.factors.data();
  for (const Term& term : sum.terms) {
    total += product(term, factors, nodes);
    factors += term.factors;
  }
  return total;
}

Rounded ReadyFormula::value(const Quotient& quotient, const std::vector<Value>& nodes) {
  const Rounded above = value(quotient.above, nodes);
  const bool whole = quotient.below.terms.size() == 1 && quotient.below.terms.front().factors == 0 &&
                     quotient.below.terms.front().coefficient == 1;
  return whole ? above : above / value(quotient.below, nodes);
}

Rounded ReadyFormula::value(const Node& node, const std::vector<Value>& nodes, const LetterValues& values) {
  const Generator& g = *node.generator;
  if (g.kind == Kind::letter) {
    const auto found = values.find(g.name);
    return found != values.end() && std::isfinite(found->second) ? Rounded(found->second) : unbounded();
  }
  if (g.kind == Kind::pi) return of_library(std::numbers::pi_v<long double>, 0);
  const Rounded x = value(node.argument, nodes);
  if (!std::isfinite(x.error)) return unbounded();
  switch (g.kind) {
    case Kind::tangent:
    case Kind::constant_tangent:
      return tangent(x * Rounded(g.multiple.numerator) / Rounded(2 * g.multiple.denominator));
    case Kind::exponential:
      return exponential(x * Rounded(g.multiple.numerator) / Rounded(g.multiple.denominator));
    case Kind::root:
      return x.value > x.error ? sqrt(x) : unbounded();
    case Kind::sign:
      return x.may_vanish() ? unbounded() : Rounded(x.value > 0 ? 1 : -1);
    default:
      return inverse(g, x, value(node.second, nodes));
  }
}

Rounded ReadyFormula::at(const LetterValues& values) const {
  if (!fits_) return unbounded();
  thread_local std::vector<Value> found;
  found.clear();
  for (const Node& one : nodes_) {
    const Rounded number = value(one, found, values);
    if (!std::isfinite(number.error)) return unbounded();
    const long double off = number.error == 0 ? 0 : number.error / number.size();
    found.push_back({number, off + Rounded::own(1)});
  }
  return value(whole_, found);
}

Rounded value_by_rounding(const Formula& x, const LetterValues& values) {
  if (x.terms() > most_terms_kept) return unbounded();
  thread_local std::unordered_map<const Fraction*, std::unique_ptr<const ReadyFormula>> kept;
  std::unique_ptr<const ReadyFormula>& known = kept[x.fraction().get()];
  if (!known) {
    auto made = std::make_unique<const ReadyFormula>(x);
    if (kept.size() > most_kept) kept.clear();
    return (kept[x.fraction().get()] = std::move(made))->at(values);
  }
  return known->at(values);
}

std::optional<double> nearest_by_rounding(const Formula& x, const LetterValues& values) {
  if (!x.fraction()) return 0;
  const Rounded found = value_by_rounding(x, values);
  if (!std::isfinite(found.error)) return std::nullopt;
  // The bound itself is rounded: twice as much is on the safe side.
  const auto below = static_cast<double>(found.value - 2 * found.error),
             above = static_cast<double>(found.value + 2 * found.error);
  if (!std::isfinite(below) || below != above) return std::nullopt;
  // Where doubles lose digits, rounding is of another kind.
  if (std::fabs(below) < 1e-290 && found.error != 0) return std::nullopt;
  return below;
}

}  // namespace poinsot::symbolic
