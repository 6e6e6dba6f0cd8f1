// Powers of the tangent of half an angle as powers of sines, cosines and tangents of the angle.
#include <algorithm>
#include <cstdlib>
#include <optional>
#include <utility>
#include <vector>

#include "engine/math/formula/formula_form.h"

namespace poinsot::symbolic {
namespace {

// s^a c^b (1 + s)^p (1 - s)^q (1 + c)^r (1 - c)^u of the sine s and cosine c of an angle.
struct SineCosinePowers {
  int a, b, p, q, r, u;
};

// The functions of an angle, made once for all ways in which their powers are tried.
struct AngleFunctions {
  explicit AngleFunctions(const Generator& tangent)
      : sine(call_form("sin", angle_form(tangent, 1))),
        cosine(call_form("cos", sine.parts[0])),
        tangent(call_form("tan", sine.parts[0])),
        sine_of_double(call_form("sin", angle_form(tangent, 2))) {}

  Form sine, cosine, tangent, sine_of_double;
};

// As it is written: s c as sin(2 a) / 2, s / c as the tangent.
AnglePowers written(const AngleFunctions& of_angle, const SineCosinePowers& x) {
  const auto& [sine, cosine, tangent, sine_of_double] = of_angle;
  const Form one = number_form(Integer(1));
  AnglePowers result;
  const auto add = [&result](const Form& base, int exponent) {
    if (exponent != 0) result.powers.push_back({base, exponent});
  };
  if (x.a != 0 && x.a == x.b) {
    add(sine_of_double, x.a);
    result.twos = -x.a;
  } else if (x.a * x.b < 0) {
    const int shared = std::min(std::abs(x.a), std::abs(x.b)) * (x.a > 0 ? 1 : -1);
    add(tangent, shared);
    add(sine, x.a - shared);
    add(cosine, x.b + shared);
  } else {
    add(sine, x.a);
    add(cosine, x.b);
  }
  if (x.p != 0) add(sum_form({one, sine}), x.p);
  if (x.q != 0) add(sum_form({one, negative_form(sine)}), x.q);
  if (x.r != 0) add(sum_form({one, cosine}), x.r);
  if (x.u != 0) add(sum_form({one, negative_form(cosine)}), x.u);
  return result;
}

}  // namespace

AnglePowers angle_powers(const Generator& tangent, const HalfTangents& half) {
  if (half.sine == 0 && half.plus == 0 && half.minus == 0 && half.one == 0) return {};
  if (half.plus == 0 && half.minus == 0 && half.one == 0) {
    const Formula half_angle = ratio_formula(tangent.multiple) * tangent.argument / 2;
    return {{{call_form("tan", form_of(half_angle)), half.sine}}, 0};
  }
  std::optional<AnglePowers> best;
  int best_cost = 0;
  const AngleFunctions of_angle(tangent);
  const int reach = std::abs(half.sine) + std::abs(half.plus) + std::abs(half.minus) + std::abs(half.one) + 2;
  for (int a = -reach; a <= reach; ++a) {
    if ((a - half.sine) % 2 != 0) continue;
    for (int b = -reach; b <= reach; ++b) {
      if ((b - half.plus) % 2 != 0) continue;
      const int p = (half.plus - b) / 2, q = (half.minus - b) / 2, u = (half.sine - a) / 2;
      const int r = -(half.one + a + b + p + q + u);
      AnglePowers tried = written(of_angle, {a, b, p, q, r, u});
      const int cost = operators(product_form(Integer(1), Integer(1), tried.powers));
      if (best && cost >= best_cost) continue;
      tried.twos -= a + r + u;
      best = std::move(tried);
      best_cost = cost;
    }
  }
  return *best;
}

}  // namespace poinsot::symbolic
