// Forms of products: which factors stand above and below the line and under the root.
#include <algorithm>
#include <optional>
#include <string>
#include <unordered_map>
#include <utility>

#include "engine/math/formula/formula_form.h"

namespace poinsot::symbolic {
namespace {

struct Power {
  Polynomial base;
  int exponent;
};

// The formula in those fractions of its angles with which its form is shortest.
struct Choice {
  Formula x;
  Form form;
};
Choice choice_of(const Formula& x);

// Of what is a product or quotient of even powers alone, the same with half of them.
std::optional<Form> root_of_square(const Form& form) {
  if (form.kind == Form::Kind::power && form.exponent % 2 == 0) return power_form(form.parts[0], form.exponent / 2);
  if (form.kind == Form::Kind::number && form.text == "1") return form;
  if (form.kind != Form::Kind::product && form.kind != Form::Kind::quotient) return std::nullopt;
  Form root = form;
  for (Form& part : root.parts) {
    std::optional<Form> own = root_of_square(part);
    if (!own) return std::nullopt;
    part = std::move(*own);
  }
  return root;
}

constexpr std::size_t longest_united = 16;  // terms of factors that are tried together

// What a formula without sums is made of, and its sums.
class Builder {
 public:
  explicit Builder(const Formula& x) : generators_(with_signed(*x.fraction()->generators)), half_(generators_.size()) {
    const Factors above = factored(here(*x.fraction(), x.fraction()->numerator));
    const Factors below = factored(here(*x.fraction(), x.fraction()->denominator));
    fmpz_abs(coefficient_.get(), above.constant.get());
    negative_ = fmpz_sgn(above.constant.get()) < 0;
    divisor_ = below.constant;
    for (const auto& [base, exponent] : above.powers) take(base, exponent);
    for (const auto& [base, exponent] : below.powers) take(base, -exponent);
  }

  Form form() {
    write_parts();
    return assembled_product(negative_, coefficient_, divisor_, std::move(written_));
  }
  // The number before the rest of the form.
  Formula coefficient() {
    write_parts();
    return integer_formula(coefficient_) / integer_formula(divisor_);
  }

 private:
  void write_parts() {
    settle_roots();
    balance_sums();
    unite_angles();
    unite_differences();
    std::vector<ScaledForm> sums;
    std::vector<int> exponents;
    for (const Power& power : powers_) {
      if (power.exponent == 0) continue;
      const std::vector<int> halves = half_degrees(generators_, power.base);
      for (std::size_t v = 0; v < halves.size(); ++v) half_[v].one += power.exponent * halves[v];
      sums.push_back(trigonometric_form(generators_, power.base));
      exponents.push_back(power.exponent);
    }
    for (std::size_t v = 0; v < generators_.size(); ++v) {
      if (!is_angle(*generators_[v])) continue;
      const AnglePowers angle = angle_powers(*generators_[v], half_[v]);
      scale_by_two(angle.twos);
      written_.insert(written_.end(), angle.powers.begin(), angle.powers.end());
    }
    for (std::size_t k = 0; k < sums.size(); ++k) add_sum(sums[k], exponents[k]);
    write_root();
  }

  // Sorts an irreducible factor into its place.
  void take(const Polynomial& base, int exponent) {
    const std::vector<bool> used = base.used();
    if (std::count(used.begin(), used.end(), true) == 1) {
      const auto v = static_cast<std::size_t>(std::find(used.begin(), used.end(), true) - used.begin());
      const Polynomial x = Polynomial::variable(generators_.size(), v);
      const Polynomial one(generators_.size(), Integer(1));
      if (base == x) {
        single(v, exponent);
        return;
      }
      if (is_angle(*generators_[v])) {
        if (base == x + one) {
          half_[v].plus += exponent;
          return;
        }
        if (base == x - one) {
          half_[v].minus += exponent;
          if (exponent % 2 != 0) negative_ = !negative_;
          return;
        }
        if (base == x * x + one) {
          half_[v].one += exponent;
          return;
        }
      }
    }
    powers_.push_back({base, exponent});
  }

  void single(std::size_t v, int exponent) {
    const GeneratorPointer& g = generators_[v];
    if (is_angle(*g)) {
      half_[v].sine += exponent;
    } else if (g->kind == Kind::root) {
      roots_.push_back(g);
    } else if (g->kind == Kind::sign) {
      signs_.push_back(g);
    } else {
      powers_.push_back({Polynomial::variable(generators_.size(), v), exponent});
    }
  }

  // The generators and those that signs are taken of.
  static Generators with_signed(const Generators& generators) {
    Generators all = generators;
    for (const GeneratorPointer& g : generators) {
      if (g->kind != Kind::sign) continue;
      for (const GeneratorPointer& h : *g->argument.fraction()->generators) {
        const auto place = std::lower_bound(all.begin(), all.end(), h, before);
        if (place == all.end() || !same(*place, h)) all.insert(place, h);
      }
    }
    return all;
  }

  Polynomial here(const Fraction& f, const Polynomial& polynomial) const {
    std::vector<int> place;
    for (const GeneratorPointer& g : *f.generators) {
      const auto found =
          std::find_if(generators_.begin(), generators_.end(), [&g](const auto& h) { return same(g, h); });
      place.push_back(static_cast<int>(found - generators_.begin()));
    }
    return polynomial.moved(place, generators_.size());
  }
  Polynomial here(const Formula& polynomial) const {
    return here(*polynomial.fraction(), polynomial.fraction()->numerator);
  }

  // All roots under one sign; what is under it also takes sizes |p| = sqrt(p^2), and factors p/sqrt(p) = sqrt(p).
  void settle_roots() {
    radicand_ = Formula(1);
    for (const GeneratorPointer& g : roots_) {
      const Power* power = place_of(g->argument);
      if (power && power->exponent < 0) {
        change(g->argument, 1);
        radicand_ /= g->argument;
      } else {
        radicand_ *= g->argument;
      }
    }
    for (const GeneratorPointer& g : signs_) {
      const int own = exponent_of(g->argument) < 0 ? -1 : 1;
      change(g->argument, -own);
      radicand_ *= pow(g->argument, 2 * own);
    }
    // What is under the root is divided by the even powers of 1 + t^2 that make it a function of sines and cosines.
    if (radicand_.is_rational()) return;
    const Fraction f = *radicand_.fraction();
    for (std::size_t v = 0; v < f.generators->size(); ++v) {
      const GeneratorPointer& g = (*f.generators)[v];
      if (!is_angle(*g)) continue;
      const auto own = std::find_if(generators_.begin(), generators_.end(), [&g](const auto& h) { return same(g, h); });
      if (own == generators_.end()) continue;
      const int degree = f.numerator.degree(v) - f.denominator.degree(v);
      const int half = degree >= 0 ? (degree + 1) / 2 : degree / 2;
      int even = half - half % 2;
      const auto place = static_cast<std::size_t>(own - generators_.begin());
      // Of two even powers that which leaves less outside.
      if (half % 2 != 0 && std::abs(excess(place) + even + 2) < std::abs(excess(place) + even)) even += 2;
      const Formula t = generator_formula(g);
      radicand_ /= pow(1 + t * t, even);
      half_[place].one += even / 2;
    }
  }
  // The degree in a tangent of what is outside of roots; zero for a function of sines and cosines alone.
  int excess(std::size_t v) const {
    const HalfTangents& half = half_[v];
    int degree = half.sine + half.plus + half.minus + 2 * half.one;
    for (const Power& power : powers_) degree += power.exponent * power.base.degree(v);
    return degree;
  }

  const Power* place_of(const Formula& polynomial) const {
    const Polynomial p = here(polynomial);
    const auto found = std::find_if(powers_.begin(), powers_.end(), [&p](const Power& q) { return q.base == p; });
    return found == powers_.end() ? nullptr : &*found;
  }
  // With what power a factor stands outside of roots.
  int exponent_of(const Formula& polynomial) const {
    const Polynomial p = here(polynomial);
    for (std::size_t v = 0; v < generators_.size(); ++v)
      if (is_angle(*generators_[v]) && p == Polynomial::variable(generators_.size(), v)) return half_[v].sine;
    const Power* power = place_of(polynomial);
    return power ? power->exponent : 0;
  }
  void change(const Formula& polynomial, int by) {
    const Polynomial p = here(polynomial);
    for (Power& power : powers_) {
      if (power.base == p) {
        power.exponent += by;
        return;
      }
    }
    take(p, by);
  }

  bool odd(const Polynomial& base) const {
    for (std::size_t v = 0; v < generators_.size(); ++v) {
      if (is_angle(*generators_[v]) && base.degree(v) % 2 != 0) return true;
    }
    return false;
  }

  // Factors of odd degree in a tangent, such as those of sin(a + b), are sines and cosines only together.
  void balance_sums() {
    for (std::size_t v = 0; v < generators_.size(); ++v) {
      HalfTangents& half = half_[v];
      if ((half.plus - half.minus) % 2 == 0) continue;
      const int sign = half.plus + half.minus < 0 ? -1 : 1;
      half.plus -= sign;
      powers_.push_back(
          {Polynomial::variable(generators_.size(), v) + Polynomial(generators_.size(), Integer(1)), sign});
    }
    Polynomial above(generators_.size(), Integer(1));
    Polynomial below = above;
    std::vector<Power> squares;
    for (Power& power : powers_) {
      if (!odd(power.base)) continue;
      if (power.exponent % 2 != 0) {
        Polynomial& group = power.exponent > 0 ? above : below;
        group = group * power.base;
        power.exponent -= power.exponent > 0 ? 1 : -1;
      }
      if (power.exponent != 0) squares.push_back({power.base * power.base, power.exponent / 2});
      power.exponent = 0;
    }
    powers_.insert(powers_.end(), squares.begin(), squares.end());
    if (!above.is_constant()) powers_.push_back({above, 1});
    if (!below.is_constant()) powers_.push_back({below, -1});
  }

  // Sums and differences of the same two terms together, as what their product is: a^2 - b^2.
  void unite_differences() {
    const auto is_binomial = [&](const Power& power) {
      const std::vector<bool> used = power.base.used();
      for (std::size_t v = 0; v < generators_.size(); ++v)
        if (used[v] && (is_angle(*generators_[v]) || is_algebraic(*generators_[v]))) return false;
      return power.exponent != 0 && power.base.length() == 2;
    };
    for (std::size_t i = 0; i < powers_.size(); ++i)
      for (std::size_t k = i + 1; k < powers_.size(); ++k) {
        if (powers_[k].exponent != powers_[i].exponent || !is_binomial(powers_[i]) || !is_binomial(powers_[k]))
          continue;
        Polynomial both = powers_[i].base * powers_[k].base;
        if (both.length() != 2) continue;
        powers_[i].base = std::move(both);
        powers_[k].exponent = 0;
      }
  }

  // Factors of angles alone together where that is shorter: (cos(a) + sin(a)) (cos(a) - sin(a)) is cos(2 a).
  void unite_angles() {
    const auto of_angles = [&](const Power& power) {
      const std::vector<bool> used = power.base.used();
      for (std::size_t v = 0; v < generators_.size(); ++v)
        if (used[v] && !is_angle(*generators_[v])) return false;
      return power.exponent != 0 && !power.base.is_constant() && power.base.length() <= longest_united;
    };
    const auto length = [&](const Polynomial& p) { return operators(trigonometric_form(generators_, p).form); };
    for (std::size_t i = 0; i < powers_.size(); ++i)
      for (std::size_t k = i + 1; k < powers_.size() && of_angles(powers_[i]); ++k) {
        if (powers_[k].exponent != powers_[i].exponent || !of_angles(powers_[k])) continue;
        const Polynomial both = powers_[i].base * powers_[k].base;
        if (length(both) > length(powers_[i].base) + length(powers_[k].base)) continue;
        powers_[i].base = both;
        powers_[k].exponent = 0;
      }
  }

  void scale_by_two(int exponent) {
    Integer factor;
    fmpz_one_2exp(factor.get(), static_cast<ulong>(std::abs(exponent)));
    Integer& part = exponent > 0 ? coefficient_ : divisor_;
    fmpz_mul(part.get(), part.get(), factor.get());
  }

  void write_root() {
    if (radicand_ == Formula(1)) return;
    // A whole number without squares is left of the size of the number under the root, whose sign stays there.
    const Formula coefficient = Builder(choice_of(radicand_).x).coefficient();
    const Formula number = plain(coefficient) < 0 ? -coefficient : coefficient;
    const Rational n = rational_of(number);
    const Formula product = integer_formula(n.numerator) * integer_formula(n.denominator);
    const Integer outside = sqrt(product).fraction()->numerator.coefficient(0);
    const Formula square = integer_formula(outside) * integer_formula(outside);
    radicand_ *= product / square / number;
    fmpz_mul(coefficient_.get(), coefficient_.get(), outside.get());
    fmpz_mul(divisor_.get(), divisor_.get(), n.denominator.get());
    if (radicand_ == Formula(1)) return;
    const Form under = form_of(radicand_);
    const bool below =
        under.kind == Form::Kind::quotient && under.parts[0].kind == Form::Kind::number && under.parts[0].text == "1";
    Form radicand = below ? under.parts[1] : under;
    // The size of a product.
    if (std::optional<Form> root = root_of_square(radicand)) radicand = power_form(std::move(*root), 2);
    written_.push_back({call_form("sqrt", std::move(radicand)), below ? -1 : 1});
  }

  void add_sum(const ScaledForm& sum, int exponent) {
    Integer above;
    Integer below;
    fmpz_pow_ui(above.get(), sum.numerator.get(), static_cast<ulong>(std::abs(exponent)));
    fmpz_pow_ui(below.get(), sum.denominator.get(), static_cast<ulong>(std::abs(exponent)));
    if (exponent < 0) std::swap(above, below);
    fmpz_mul(coefficient_.get(), coefficient_.get(), above.get());
    fmpz_mul(divisor_.get(), divisor_.get(), below.get());
    written_.push_back({sum.form, exponent});
  }

  Generators generators_;
  Integer coefficient_, divisor_;
  bool negative_ = false;
  std::vector<Power> powers_;
  std::vector<HalfTangents> half_;
  Generators roots_, signs_;
  Formula radicand_;
  std::vector<FormPower> written_;
};

Choice choice_of(const Formula& x) {
  const Formula coarsest = with_coarsest_angles(x);
  Choice best{coarsest, Builder(coarsest).form()};
  // The squares of sines that hide in cosines of twice the angle.
  const Generators generators = *coarsest.fraction()->generators;
  for (const GeneratorPointer& g : generators) {
    if (g->kind != Kind::tangent) continue;
    const Formula finer = with_half_angle(best.x, g);
    Form form = Builder(finer).form();
    if (is_shorter(form, best.form)) best = {finer, std::move(form)};
  }
  return best;
}

}  // namespace

bool is_angle(const Generator& generator) {
  return generator.kind == Kind::tangent || generator.kind == Kind::constant_tangent;
}

Form angle_form(const Generator& tangent, std::int64_t times) {
  return form_of(ratio_formula(tangent.multiple) * Formula(times) * tangent.argument);
}

namespace {

Form written_form(const Formula& x) {
  if (x.is_zero()) return number_form(Integer(0));
  // pi - acos(u) is acos(-u).
  if (x.fraction()->generators->size() == 2)
    for (const GeneratorPointer& g : *x.fraction()->generators)
      if (g->kind == Kind::inverse && g->name == "acos" && x == Formula::pi() - generator_formula(g))
        return call_form("acos", form_of(-g->argument));
  return choice_of(x).form;
}

// What stands under a root or in a function is met again in each way that is tried for the whole: until that is
// written, the forms of its parts are kept, by their keys.
thread_local std::unordered_map<std::string, Form>* forms_of_parts = nullptr;

}  // namespace

Form form_of(const Formula& x) {
  if (!forms_of_parts) {
    std::unordered_map<std::string, Form> forms;
    struct Kept {
      explicit Kept(std::unordered_map<std::string, Form>& forms) { forms_of_parts = &forms; }
      Kept(const Kept&) = delete;
      Kept& operator=(const Kept&) = delete;
      ~Kept() { forms_of_parts = nullptr; }
    } const kept(forms);
    return written_form(x);
  }
  std::string key = key_of(x);
  if (const auto known = forms_of_parts->find(key); known != forms_of_parts->end()) return known->second;
  Form form = written_form(x);
  forms_of_parts->emplace(std::move(key), form);
  return form;
}

}  // namespace poinsot::symbolic
