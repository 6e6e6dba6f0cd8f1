// Which way the values of expressions point in a planar problem, and expressions with numbers in place of vectors along
// the normal.
#pragma once

#include "problem/entries/statement.h"

namespace poinsot::problem {

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

}  // namespace poinsot::problem
