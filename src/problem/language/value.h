// The value of an expression, with its dimension.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "poinsot/engine/math/algebra/vector3.h"
#include "problem/language/dimension.h"

namespace poinsot::problem {

// The scalar is double, Dual<N> or Formula. Values are in SI base units and radians.
template <class Scalar>
struct Value {
  enum class Kind { number, vector, list, boolean, text, any };

  Kind kind = Kind::any;
  Dimension dimension;  // of a number or vector
  // whether a number (or vector of such) was written without unit, or computed from such numbers only; pi is never
  // bare
  bool bare = false;
  Scalar number{};         // of a number
  Vector3<Scalar> vector;  // of a vector
  std::vector<Value> items;
  bool truth = false;
  std::string text;

  static Value of_number(Scalar number, const Dimension& dimension, bool bare = false) {
    Value value;
    value.kind = Kind::number;
    value.number = std::move(number);
    value.dimension = dimension;
    value.bare = bare;
    return value;
  }
  static Value of_vector(Vector3<Scalar> vector, const Dimension& dimension, bool bare = false) {
    Value value;
    value.kind = Kind::vector;
    value.vector = std::move(vector);
    value.dimension = dimension;
    value.bare = bare;
    return value;
  }
  static Value of_list(std::vector<Value> items) {
    Value value;
    value.kind = Kind::list;
    value.items = std::move(items);
    return value;
  }
  static Value of_truth(bool truth) {
    Value value;
    value.kind = Kind::boolean;
    value.truth = truth;
    return value;
  }
  // NOLINTNEXTLINE(performance-unnecessary-value-param): it is moved from, which is not seen in a template.
  static Value of_text(std::string text) {
    Value value;
    value.kind = Kind::text;
    value.text = std::move(text);
    return value;
  }
  // The value `any`: it is unknown and not asked for.
  static Value any() { return {}; }

  bool is_number() const { return kind == Kind::number; }
  bool is_vector() const { return kind == Kind::vector; }
  bool is_list() const { return kind == Kind::list; }
  bool is_boolean() const { return kind == Kind::boolean; }
  bool is_text() const { return kind == Kind::text; }
  bool is_any() const { return kind == Kind::any; }
};

}  // namespace poinsot::problem
