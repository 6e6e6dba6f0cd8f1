// Forms of polynomials in tangents of half angles: sums in sines and cosines, by the shortest of several ways.
#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "engine/math/formula/formula_form.h"

namespace poinsot::symbolic {
namespace {

using Exponents = std::vector<int>;

// Beyond so many terms only the plainest forms are tried, since each further one is a formula of that size.
constexpr std::size_t few_terms = 60;

Form generator_form(const GeneratorPointer& g);

std::vector<Form> generator_forms(const Generators& generators) {
  std::vector<Form> forms;
  for (const GeneratorPointer& g : generators) forms.push_back(generator_form(g));
  return forms;
}

// How often 1 + t^2 of each tangent goes into the square of a root, so that a function of sines and cosines is left.
std::vector<int> root_halves(const Generators& generators, const Generator& root) {
  std::vector<int> halves(generators.size(), 0);
  const Fraction& f = *root.argument.fraction();
  for (std::size_t v = 0; v < f.generators->size(); ++v) {
    if (!is_angle(*(*f.generators)[v])) continue;
    const int half = (f.numerator.degree(v) + 1) / 2;
    for (std::size_t k = 0; k < generators.size(); ++k) {
      if (same(generators[k], (*f.generators)[v])) halves[k] = half - half % 2;
    }
  }
  return halves;
}

// atan2 of two sides, which may be divided by powers of 1 + t^2 such that sines and cosines are left.
Form sides_form(Formula y, Formula x) {
  const auto form = [&] {
    Form sides = call_form("atan2", form_of(y));
    sides.parts.push_back(form_of(x));
    return sides;
  };
  const Form plain_form = form();
  std::map<std::string, std::pair<Formula, int>> halves;  // of each tangent
  for (const Formula* side : {&y, &x}) {
    if (!side->fraction()) continue;
    const Fraction& f = *side->fraction();
    for (std::size_t v = 0; v < f.generators->size(); ++v) {
      if (!is_angle(*(*f.generators)[v])) continue;
      const int half = (f.numerator.degree(v) - f.denominator.degree(v) + 1) / 2;
      const Formula t = generator_formula((*f.generators)[v]);
      auto [known, fresh] = halves.try_emplace(key_of(t), t, half);
      if (!fresh) known->second.second = std::max(known->second.second, half);
    }
  }
  for (const auto& [key, tangent] : halves) {
    const auto& [t, half] = tangent;
    if (half <= 0) continue;
    y /= pow(1 + t * t, half);
    x /= pow(1 + t * t, half);
  }
  Form settled = form();
  return is_shorter(settled, plain_form) ? settled : plain_form;
}

Form generator_form(const GeneratorPointer& g) {
  switch (g->kind) {
    case Kind::letter:
    case Kind::pi:
      return {Form::Kind::name, g->name};
    case Kind::tangent:
    case Kind::constant_tangent:
      return call_form("tan", form_of(ratio_formula(g->multiple) * g->argument / 2));
    case Kind::inverse:
      return g->name == "atan2" ? sides_form(g->argument, g->second) : call_form(g->name, form_of(g->argument));
    case Kind::exponential:
      return call_form("exp", form_of(ratio_formula(g->multiple) * g->argument));
    case Kind::sign:
      return {Form::Kind::quotient, "", {call_form("sqrt", power_form(form_of(g->argument), 2)), form_of(g->argument)}};
    case Kind::root:
      break;
  }
  Formula radicand = g->argument;
  const Generators& generators = *g->argument.fraction()->generators;
  const std::vector<int> halves = root_halves(generators, *g);
  for (std::size_t v = 0; v < generators.size(); ++v) {
    const Formula t = generator_formula(generators[v]);
    radicand /= pow(1 + t * t, halves[v]);
  }
  return call_form("sqrt", form_of(radicand));
}

// The polynomial with roots that are functions of sines and cosines in place of roots of polynomials in tangents.
Polynomial with_settled_roots(const Generators& generators, Polynomial p) {
  const std::size_t n = generators.size();
  for (std::size_t v = 0; v < n; ++v) {
    if (generators[v]->kind != Kind::root || p.degree(v) != 1) continue;
    const std::vector<int> halves = root_halves(generators, *generators[v]);
    Polynomial factor = Polynomial::variable(n, v);
    for (std::size_t k = 0; k < n; ++k) {
      const Polynomial t = Polynomial::variable(n, k);
      factor = factor * power(t * t + Polynomial(n, Integer(1)), halves[k] / 2);
    }
    const std::vector<Polynomial> parts = p.coefficients_by(v);
    p = parts[0] + parts[1] * factor;
  }
  return p;
}

// 2^halves t^k / (1 + t^2)^half by t^2 = (1 - c)/(1 + c), t = s/(1 + c): at most the first power of s.
Polynomial with_cosines(const Polynomial& p, const Angles& angles) {
  const std::size_t n = angles.variables();
  std::vector<int> places(angles.generators);
  for (std::size_t i = 0; i < places.size(); ++i) places[i] = static_cast<int>(i);
  Polynomial result = p.moved(places, n);
  const Polynomial one(n, Integer(1));
  for (std::size_t k = 0; k < angles.tangents.size(); ++k) {
    const Polynomial s = Polynomial::variable(n, angles.sine(k));
    const Polynomial c = Polynomial::variable(n, angles.cosine(k));
    const std::vector<Polynomial> parts = result.coefficients_by(angles.tangents[k]);
    result = Polynomial(n);
    for (std::size_t j = 0; j < parts.size(); ++j) {
      const int minus = static_cast<int>(j / 2);
      const int odd = static_cast<int>(j % 2);
      const int rest = angles.halves[k] - minus - odd;
      result = result + parts[j] * power(s, odd) * power(one - c, minus) * power(one + c, rest);
    }
  }
  return result;
}

// c^2 = 1 - s^2 for angle k.
Polynomial with_sines(const Polynomial& p, const Angles& angles, std::size_t k) {
  const std::size_t n = angles.variables();
  const Polynomial s = Polynomial::variable(n, angles.sine(k));
  const Polynomial c = Polynomial::variable(n, angles.cosine(k));
  const Polynomial square = Polynomial(n, Integer(1)) - s * s;
  const std::vector<Polynomial> parts = p.coefficients_by(angles.cosine(k));
  Polynomial result(n);
  for (std::size_t j = 0; j < parts.size(); ++j) {
    result = result + parts[j] * power(c, static_cast<int>(j % 2)) * power(square, static_cast<int>(j / 2));
  }
  return result;
}

// Powers of s and c of equal degree, as far as parity allows, by 1 = s^2 + c^2.
Polynomial of_equal_degree(const Polynomial& p, const Angles& angles, std::size_t k) {
  const std::size_t n = angles.variables();
  const Polynomial s = Polynomial::variable(n, angles.sine(k));
  const Polynomial c = Polynomial::variable(n, angles.cosine(k));
  const Polynomial unit = s * s + c * c;
  int most[2] = {0, 0};
  std::map<int, Polynomial> by_degree;
  for (std::size_t i = 0; i < p.length(); ++i) {
    const Exponents exponents = p.exponents(i);
    const int degree = exponents[angles.sine(k)] + exponents[angles.cosine(k)];
    most[degree % 2] = std::max(most[degree % 2], degree);
    by_degree.try_emplace(degree, n).first->second.push(p.coefficient(i), exponents);
  }
  Polynomial result(n);
  for (auto& [degree, part] : by_degree) {
    part.tidy();
    result = result + part * power(unit, (most[degree % 2] - degree) / 2);
  }
  return result;
}

}  // namespace

std::vector<int> half_degrees(const Generators& generators, const Polynomial& polynomial) {
  const Polynomial p = with_settled_roots(generators, polynomial);
  std::vector<int> halves(generators.size(), 0);
  for (std::size_t v = 0; v < generators.size(); ++v) {
    if (is_angle(*generators[v])) halves[v] = (p.degree(v) + 1) / 2;
  }
  return halves;
}

ScaledForm trigonometric_form(const Generators& generators, const Polynomial& polynomial) {
  const Polynomial p = with_settled_roots(generators, polynomial);
  Angles angles;
  angles.generators = generators.size();
  int twos = 0;
  const std::vector<int> halves = half_degrees(generators, polynomial);
  for (std::size_t v = 0; v < generators.size(); ++v) {
    if (halves[v] == 0) continue;
    angles.tangents.push_back(v);
    angles.halves.push_back(halves[v]);
    twos += halves[v];
  }
  std::vector<Form> variables = generator_forms(generators);
  if (angles.tangents.empty()) return polynomial_form(p, variables);
  for (const std::size_t v : angles.tangents) {
    variables.push_back(call_form("sin", angle_form(*generators[v], 1)));
    variables.push_back(call_form("cos", angle_form(*generators[v], 1)));
  }

  // All ways to write it, of which those that are shortest as they stand are worked out.
  const Polynomial base = with_cosines(p, angles);
  std::vector<TrigonometricSum> sums{{base, variables, twos}};
  const std::size_t count = angles.tangents.size();
  if (base.length() <= few_terms && count <= 3) {
    // For each angle: cosines, sines, or both of equal degree.
    int ways = 1;
    for (std::size_t k = 0; k < count; ++k) ways *= 3;
    for (int way = 1; way < ways; ++way) {
      Polynomial q = base;
      int rest = way;
      for (std::size_t k = 0; k < count; ++k, rest /= 3) {
        if (rest % 3 == 1) q = with_sines(q, angles, k);
        if (rest % 3 == 2) q = of_equal_degree(q, angles, k);
      }
      sums.push_back({std::move(q), variables, twos});
    }
  }
  if (base.length() <= 4 * few_terms) {
    for (TrigonometricSum& sum : harmonic_sums(generators, base, angles, twos, variables))
      sums.push_back(std::move(sum));
  }
  std::vector<std::pair<int, std::size_t>> order;
  for (std::size_t k = 0; k < sums.size(); ++k)
    order.emplace_back(flat_operators(sums[k].polynomial, sums[k].variables), k);
  std::sort(order.begin(), order.end());
  constexpr std::size_t worked_out = 4;  // of those that are shortest before factors are pulled out
  if (order.size() > worked_out) order.resize(worked_out);

  std::optional<ScaledForm> best;
  for (const auto& [cost, k] : order) {
    ScaledForm form = polynomial_form(sums[k].polynomial, sums[k].variables);
    if (best && !is_shorter(form.form, best->form)) continue;
    fmpz_one_2exp(form.denominator.get(), static_cast<ulong>(sums[k].twos));
    best = std::move(form);
  }
  return *best;
}

}  // namespace poinsot::symbolic
