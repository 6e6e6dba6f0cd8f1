// How a number of a trace is made anew, of few others.
#pragma once

#include <array>
#include <cstdint>

#include "poinsot/engine/math/trace/traced.h"

namespace poinsot::symbolic {

// a b, or a + b.
struct Pair {
  bool product = false;
  Traced a, b;
};

// What a number is made of anew: the pair itself; or with one or two others, or with another pair.
struct Recipe {
  enum class Form { pair, sum, product, product_then_sum, sum_then_product, pairs_sum, pairs_product };
  Form form = Form::pair;
  Pair pair;
  Traced first, second;
  Pair other;
  bool negative = false;        // the pair
  bool negative_other = false;  // the other pair

  int cost() const {
    switch (form) {
      case Form::pair:
        return 1;
      case Form::sum:
      case Form::product:
        return 2;
      default:
        return 3;
    }
  }
  std::array<std::uint32_t, 6> numbers() const {
    return {pair.a.node(), pair.b.node(), first.node(), second.node(), other.a.node(), other.b.node()};
  }
};

// The recipe's result in any arithmetic; of: the numbers of the trace in it.
template <class Of>
auto made(const Pair& pair, const Of& of) {
  return pair.product ? of(pair.a) * of(pair.b) : of(pair.a) + of(pair.b);
}
template <class Of>
auto made(const Recipe& recipe, const Of& of) {
  using Form = Recipe::Form;
  const auto size = made(recipe.pair, of);
  const auto pair = recipe.negative ? -size : size;
  const auto other = [&] {
    const auto other_size = made(recipe.other, of);
    return recipe.negative_other ? -other_size : other_size;
  };
  switch (recipe.form) {
    case Form::sum:
      return of(recipe.first) + pair;
    case Form::product:
      return of(recipe.first) * pair;
    case Form::product_then_sum:
      return of(recipe.first) + of(recipe.second) * pair;
    case Form::sum_then_product:
      return of(recipe.second) * (of(recipe.first) + pair);
    case Form::pairs_sum:
      return other() + pair;
    case Form::pairs_product:
      return other() * pair;
    case Form::pair:
      break;
  }
  return pair;
}

}  // namespace poinsot::symbolic
