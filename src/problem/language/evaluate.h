// The value of an expression: arithmetic with dimensions, vectors and the mathematical functions. The scope says what
// names and all other calls mean.
#pragma once

#include <string>
#include <vector>

#include "poinsot/engine/math/algebra/dual.h"
#include "problem/language/expression.h"
#include "problem/language/value.h"

namespace poinsot::problem {

template <class Scalar>
class Scope;

// Evaluates expressions in one scope. Scopes receive it, so that they can evaluate the arguments of their own calls.
template <class Scalar>
class Evaluator {
 public:
  // Scope and file must outlive the evaluator.
  Evaluator(Scope<Scalar>& scope, const std::string& file) : scope_(scope), file_(file) {}

  Value<Scalar> operator()(const Expression& expression) const;

  // The value, which must be a number or a vector of the given dimension. Exponents of angle are ignored, but a
  // number without unit is no angle. A zero without unit fits every dimension, and is the zero vector too.
  Scalar number(const Expression& expression, const Dimension& dimension) const;
  Vector3<Scalar> vector(const Expression& expression, const Dimension& dimension) const;

  // The value with its dimension checked if it is a number or vector; anything else (lists, `any`) is left to the
  // caller.
  Value<Scalar> quantity(const Expression& expression, const Dimension& dimension) const;

  const std::string& file() const { return file_; }

  [[noreturn]] void fail(const Mark& mark, std::string message, std::string hint = "") const;
  // Reports a call that is neither a mathematical function nor one of the scope's: if the name is right, it says how
  // the function is written; otherwise it suggests the nearest name among the functions and `others`.
  [[noreturn]] void unknown_call(const Call& call, const Mark& mark, const std::vector<std::string>& others = {}) const;

 private:
  Scope<Scalar>& scope_;
  const std::string& file_;
};

// The meaning of names and calls. Hooks that are not overridden behave as their comments say.
template <class Scalar>
class Scope {
 public:
  virtual ~Scope() = default;

  // The value of a name other than `pi` and `any`.
  virtual Value<Scalar> name(const Name& name, const Mark& mark, const Evaluator<Scalar>& evaluator) = 0;
  // The value of a call other than a mathematical function in its own form (see mathematical_functions()). An unknown
  // call is to be reported by evaluator.unknown_call().
  virtual Value<Scalar> call(const Call& call, const Mark& mark, const Evaluator<Scalar>& evaluator) = 0;
  // A->B: the value of B minus that of A, both vectors.
  virtual Value<Scalar> arrow(const Arrow& arrow, const Mark& mark, const Evaluator<Scalar>& evaluator);
  // `A of plate`. By default this is refused.
  virtual Value<Scalar> of(const Of& of, const Mark& mark, const Evaluator<Scalar>& evaluator);
  // `.x`, `.y` or `.z` of a vector. By default anything else is refused.
  virtual Value<Scalar> member(const Member& member, const Mark& mark, const Evaluator<Scalar>& evaluator);
  // `X @ instant`. By default this is refused.
  virtual Value<Scalar> at(const At& at, const Mark& mark, const Evaluator<Scalar>& evaluator);
};

// Throws StatementError for an expression that can never be right (lb added to ft, cos(25)), and the derived
// DomainError for one that has no value with the data at hand (division by zero, square root of a negative number,
// asin beyond 1, infinite results).
//
// A number without unit is `bare`, and so is what is computed from bare numbers only. A bare zero fits every
// dimension. Any other bare number is no angle: sin(25) and `90 - theta` are refused, with what to write instead. A
// list of three numbers of one dimension is a vector. The sum of m/s and rad*m/s is in m/s, that of a pure number and
// an angle is an angle.
template <class Scalar>
Value<Scalar> evaluate(const Expression& expression, Scope<Scalar>& scope, const std::string& file);

// The functions that need no scope, by name, and how each is written: "cross(u with v)".
struct FunctionForm {
  std::string name;
  std::string form;
};
const std::vector<FunctionForm>& mathematical_functions();

extern template class Evaluator<double>;
extern template class Scope<double>;
extern template Value<double> evaluate(const Expression&, Scope<double>&, const std::string&);
extern template class Evaluator<Dual<1>>;
extern template class Scope<Dual<1>>;
extern template Value<Dual<1>> evaluate(const Expression&, Scope<Dual<1>>&, const std::string&);
extern template class Evaluator<Dual<1, Dual<1>>>;
extern template class Scope<Dual<1, Dual<1>>>;
extern template Value<Dual<1, Dual<1>>> evaluate(const Expression&, Scope<Dual<1, Dual<1>>>&, const std::string&);
extern template class Evaluator<Dual<1, Dual<1, Dual<1>>>>;
extern template class Scope<Dual<1, Dual<1, Dual<1>>>>;
extern template Value<Dual<1, Dual<1, Dual<1>>>> evaluate(const Expression&, Scope<Dual<1, Dual<1, Dual<1>>>>&,
                                                          const std::string&);

}  // namespace poinsot::problem
