// Forms of sums: polynomials in letters and other things that have forms of their own.
#include <algorithm>
#include <map>
#include <optional>

#include "engine/math/formula/formula_form.h"

namespace poinsot::symbolic {
namespace {

using Exponents = std::vector<int>;

// Beyond so many terms only the plainest forms are tried, as in formula_trigonometry.cpp.
constexpr std::size_t few_terms_of_sum = 60;

bool is_root(const Form& form) { return form.kind == Form::Kind::call && form.text == "sqrt"; }

// The product of roots as one root.
Form united_root(const std::vector<Form>& roots) {
  Integer number(1);
  std::vector<FormPower> powers;
  for (const Form& root : roots) {
    const Form& radicand = root.parts[0];
    if (radicand.kind == Form::Kind::number && radicand.text.find_first_not_of("0123456789") == std::string::npos) {
      Integer digits;
      fmpz_set_str(digits.get(), radicand.text.c_str(), 10);
      fmpz_mul(number.get(), number.get(), digits.get());
    } else {
      powers.push_back({radicand, 1});
    }
  }
  return call_form("sqrt", product_form(number, Integer(1), powers));
}

Form monomial_form(const Integer& coefficient, const Exponents& exponents, const std::vector<Form>& variables) {
  std::vector<FormPower> powers;
  std::vector<Form> roots;
  for (std::size_t v = 0; v < variables.size(); ++v) {
    if (exponents[v] == 0) continue;
    if (is_root(variables[v]) && exponents[v] == 1) {
      roots.push_back(variables[v]);
    } else {
      powers.push_back({variables[v], exponents[v]});
    }
  }
  std::stable_sort(powers.begin(), powers.end(), stands_before);
  if (!roots.empty()) {
    Form root = roots.size() == 1 ? roots[0] : united_root(roots);
    const bool number = root.parts[0].kind == Form::Kind::number;
    powers.insert(number ? powers.begin() : powers.end(), {std::move(root), 1});
  }
  return product_form(coefficient, Integer(1), powers);
}

std::vector<Form> terms_of(const Form& form) {
  return form.kind == Form::Kind::sum ? form.parts : std::vector<Form>{form};
}

Form flat_form(const Polynomial& p, const std::vector<Form>& variables) {
  std::vector<Form> terms;
  for (std::size_t i = 0; i < p.length(); ++i) {
    Integer size = p.coefficient(i);
    const bool negative = fmpz_sgn(size.get()) < 0;
    fmpz_abs(size.get(), size.get());
    Form term = monomial_form(size, p.exponents(i), variables);
    terms.push_back(negative ? negative_form(std::move(term)) : std::move(term));
  }
  return ordered_sum(std::move(terms));
}

// Two terms of a sum and twice their mean, where there are such: a^2 + 2 a b + b^2. The rest in `rest`.
struct Square {
  Polynomial three;
  Polynomial rest;
};
std::vector<Square> squares_in(const Polynomial& p) {
  const auto n = static_cast<std::size_t>(fmpz_mpoly_ctx_nvars(p.ring()));
  std::map<Exponents, Integer> terms;
  for (std::size_t i = 0; i < p.length(); ++i) terms[p.exponents(i)] = p.coefficient(i);
  std::vector<Square> squares;
  for (auto first = terms.begin(); first != terms.end(); ++first) {
    for (auto second = std::next(first); second != terms.end(); ++second) {
      Exponents mean(n);
      bool whole = true;
      for (std::size_t v = 0; v < n; ++v) {
        const int sum = first->first[v] + second->first[v];
        whole = whole && sum % 2 == 0;
        mean[v] = sum / 2;
      }
      const auto middle = whole ? terms.find(mean) : terms.end();
      if (middle == terms.end()) continue;
      Integer product;
      Integer square;
      fmpz_mul(product.get(), first->second.get(), second->second.get());
      fmpz_mul_ui(product.get(), product.get(), 4);
      fmpz_mul(square.get(), middle->second.get(), middle->second.get());
      if (!fmpz_equal(product.get(), square.get())) continue;
      Polynomial three(n);
      for (const auto& term : {first, second, middle}) three.push(term->second, term->first);
      three.tidy();
      squares.push_back({three, p - three});
    }
  }
  return squares;
}

// Writes polynomials as sums in which common factors of some terms may be pulled out.
class SumWriter {
 public:
  explicit SumWriter(const std::vector<Form>& variables) : variables_(variables) {}

  // The sum, or where that is shorter with a factor pulled out of those terms that have it: L^2 + (r^2 - L^2) c^2.
  Form shortest(const Polynomial& p, int depth) {
    Form best = flat_form(p, variables_);
    if (p.length() < 3 || p.length() > few_terms_of_sum || depth > 3) return best;
    budget_ -= static_cast<int>(p.length());
    if (budget_ < 0) return best;
    int best_cost = operators(best);
    const auto offer = [&](const Form& first, const Polynomial& rest) {
      std::vector<Form> terms = terms_of(first);
      for (Form& term : terms_of(shortest(rest, depth + 1))) terms.push_back(std::move(term));
      Form form = ordered_sum(std::move(terms));
      if (const int cost = operators(form); cost < best_cost) {
        best = std::move(form);
        best_cost = cost;
      }
    };
    for (const auto& [three, rest] : squares_in(p)) {
      if (!rest.is_zero()) offer(factored_form(three, depth), rest);
    }
    for (const std::size_t v : shared_variables(p, depth == 0 ? variables_.size() : 3)) {
      Polynomial with(variables_.size());
      Polynomial without(variables_.size());
      for (std::size_t i = 0; i < p.length(); ++i) {
        const Exponents exponents = p.exponents(i);
        (exponents[v] != 0 ? with : without).push(p.coefficient(i), exponents);
      }
      with.tidy();
      without.tidy();
      offer(grouped_form(with, depth), without);
    }
    return best;
  }

 private:
  // Those that more than one term has, but not all; the commonest first, at most so many.
  std::vector<std::size_t> shared_variables(const Polynomial& p, std::size_t most) const {
    std::vector<std::size_t> counts(variables_.size(), 0);
    for (std::size_t i = 0; i < p.length(); ++i) {
      const Exponents exponents = p.exponents(i);
      for (std::size_t v = 0; v < counts.size(); ++v) counts[v] += exponents[v] != 0 ? 1 : 0;
    }
    std::vector<std::size_t> shared;
    for (std::size_t v = 0; v < counts.size(); ++v) {
      if (counts[v] > 1 && counts[v] < p.length()) shared.push_back(v);
    }
    std::stable_sort(shared.begin(), shared.end(), [&](std::size_t a, std::size_t b) { return counts[a] > counts[b]; });
    if (shared.size() > most) shared.resize(most);
    return shared;
  }

  // monomial * (what shares it), the sum in brackets.
  Form grouped_form(const Polynomial& group, int depth) {
    const std::size_t n = variables_.size();
    Exponents shared = group.exponents(0);
    for (std::size_t i = 1; i < group.length(); ++i) {
      const Exponents own = group.exponents(i);
      for (std::size_t v = 0; v < n; ++v) shared[v] = std::min(shared[v], own[v]);
    }
    Integer content = group.content();
    Polynomial monomial(n);
    monomial.push(content, shared);
    Form rest = shortest(divided_exactly(group, monomial), depth + 1);
    bool negative = fmpz_sgn(content.get()) < 0;
    if (negative && rest.kind == Form::Kind::sum) {
      Form turned = negated_sum(rest);
      if (operators(turned) <= operators(rest)) {
        rest = std::move(turned);
        negative = false;
      }
    }
    fmpz_abs(content.get(), content.get());
    std::vector<FormPower> powers;
    for (std::size_t v = 0; v < n; ++v) {
      if (shared[v] != 0) powers.push_back({variables_[v], shared[v]});
    }
    std::stable_sort(powers.begin(), powers.end(), stands_before);
    // Before sines and cosines, as the coefficient that it is.
    const auto place =
        std::find_if(powers.begin(), powers.end(), [](const FormPower& q) { return q.base.kind != Form::Kind::name; });
    powers.insert(place, squared_sine(rest).value_or(FormPower{rest, 1}));
    Form form = product_form(content, Integer(1), powers);
    return negative ? negative_form(std::move(form)) : form;
  }

  // sin(a)^2 of 1 - cos(a)^2, and the other way round.
  static std::optional<FormPower> squared_sine(const Form& sum) {
    if (sum.kind != Form::Kind::sum || sum.parts.size() != 2 || sum.parts[1].kind != Form::Kind::negative) return {};
    const Form &one = sum.parts[0], &square = sum.parts[1].parts[0];
    if (one.kind != Form::Kind::number || one.text != "1" || square.kind != Form::Kind::power || square.exponent != 2)
      return {};
    const Form& call = square.parts[0];
    if (call.kind != Form::Kind::call || (call.text != "cos" && call.text != "sin")) return {};
    return FormPower{call_form(call.text == "cos" ? "sin" : "cos", call.parts[0]), 2};
  }

  // The product of its factors.
  Form factored_form(const Polynomial& p, int depth) {
    const Factors factors = factored(p);
    std::vector<FormPower> powers;
    for (const auto& [base, exponent] : factors.powers) powers.push_back({shortest(base, depth + 1), exponent});
    std::stable_sort(powers.begin(), powers.end(), stands_before);
    Integer size(factors.constant);
    fmpz_abs(size.get(), size.get());
    Form form = product_form(size, Integer(1), powers);
    return fmpz_sgn(factors.constant.get()) < 0 ? negative_form(std::move(form)) : form;
  }

  const std::vector<Form>& variables_;
  int budget_ = 4000;  // of terms looked at; then sums stay as they are
};

}  // namespace

int flat_operators(const Polynomial& p, const std::vector<Form>& variables) {
  int count = static_cast<int>(p.length()) - 1;
  std::vector<int> costs;
  costs.reserve(variables.size());
  for (const Form& form : variables) costs.push_back(operators(form));
  for (std::size_t i = 0; i < p.length(); ++i) {
    const Integer c = p.coefficient(i);
    int factors = fmpz_is_pm1(c.get()) ? 0 : 1;
    const Exponents exponents = p.exponents(i);
    for (std::size_t v = 0; v < variables.size(); ++v) {
      if (exponents[v] == 0) continue;
      ++factors;
      count += costs[v] + (exponents[v] > 1 ? 1 : 0);
    }
    count += std::max(factors - 1, 0);
  }
  return count;
}

ScaledForm polynomial_form(const Polynomial& polynomial, const std::vector<Form>& variables) {
  Integer content = polynomial.content();
  // All terms negative: the sign goes before the sum. Else the sum starts with a positive term.
  bool any_positive = false;
  for (std::size_t i = 0; i < polynomial.length(); ++i) {
    any_positive = any_positive || fmpz_sgn(polynomial.coefficient(i).get()) > 0;
  }
  fmpz_abs(content.get(), content.get());
  if (!any_positive) fmpz_neg(content.get(), content.get());
  return {content, Integer(1), SumWriter(variables).shortest(divided_exactly(polynomial, content), 0)};
}

}  // namespace poinsot::symbolic
