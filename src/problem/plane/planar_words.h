// Which way the values of expressions point in a planar problem, and expressions with numbers in place of vectors along
// the normal.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "problem/entries/statement.h"
#include "problem/language/value.h"

namespace poinsot::problem {

// Components are written and told in the order of the figure's axes, whichever of the two angles are counted from.
std::array<std::size_t, 2> component_axes(const MotionPlane& plane);
// The components of an unknown that are sought: of a number the only one, of a vector those in the plane if there is
// one.
std::vector<std::size_t> sought_components(const Unknown& unknown, const std::optional<MotionPlane>& plane);

class PlanarWords {
 public:
  // The situation must have a plane and outlive the object.
  explicit PlanarWords(const Situation& situation) : situation_(situation), plane_(*situation.plane) {}

  enum class Pointing {
    none,      // a number, or what is not known to be a vector
    in_plane,  // such as a velocity or a force
    normal     // such as an angular velocity or a couple
  };
  Pointing pointing(const Expression& expression) const { return pointing(expression, 0); }

  // The expression with numbers where such stand between numbers: angular_velocity(B) + 2 rad/s. Throws StatementError
  // for what is asked across the plane.
  Expression with_numbers(const Expression& expression) const;
  // The same, itself a number if it points along the normal.
  Expression as_number(const Expression& expression) const;
  // The components in the plane.
  std::vector<Expression> components(const Expression& expression) const;
  // The axis about which angles are counted, as an expression.
  Expression normal(const Mark& mark) const;
  // A list of two as a vector, whose component across the plane is `across`.
  Expression as_vector(const Expression& list, const Expression& across) const;

 private:
  Pointing pointing(const Expression& expression, int depth) const;
  Pointing of_call(const Call& call, int depth) const;
  Pointing of_name(const Name& name, int depth) const;
  Expression call_with_numbers(const Expression& expression, const Call& call) const;
  void refuse_across(const Expression& expression, const Call& call) const;
  Expression component(const Expression& expression, std::size_t axis) const;
  Expression number_along_normal(const Expression& expression) const;

  const Situation& situation_;
  const MotionPlane& plane_;
};

// A vector by its components in the plane, if there is one: what questions of a planar problem are answered by.
template <class Scalar>
Value<Scalar> told_in_plane(const Value<Scalar>& value, const std::optional<MotionPlane>& plane) {
  if (!plane || !value.is_vector()) return value;
  std::vector<Value<Scalar>> two;
  for (const std::size_t axis : component_axes(*plane))
    two.push_back(Value<Scalar>::of_number(value.vector[axis], value.dimension));
  return Value<Scalar>::of_list(std::move(two));
}

}  // namespace poinsot::problem
