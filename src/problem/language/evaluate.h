// The value of an expression: arithmetic with dimensions, vectors and the mathematical functions. What names and other
// calls mean is the scope's business.
#pragma once

#include <string>
#include <vector>

#include "poinsot/engine/math/algebra/dual.h"
#include "problem/language/expression.h"
#include "problem/language/value.h"

namespace poinsot::problem {

template <class Scalar>
class Scope;

// Evaluates in one scope; what a scope is handed so that it can evaluate the arguments of its own calls.
template <class Scalar>
class Evaluator {
 public:
  // Scope and file must outlive the evaluator.
  Evaluator(Scope<Scalar>& scope, const std::string& file) : scope_(scope), file_(file) {}

  Value<Scalar> operator()(const Expression& expression) const;

  // The value, which must be a number or a vector of the given dimension (angles ignored, but a bare number is no
  // angle; a bare zero fits all, a scalar bare zero is also the zero vector).
  Scalar number(const Expression& expression, const Dimension& dimension) const;
  Vector3<Scalar> vector(const Expression& expression, const Dimension& dimension) const;

  // The value with its dimension checked if it is a number or vector; anything else (lists, `any`) is left to the
  // caller.
  Value<Scalar> quantity(const Expression& expression, const Dimension& dimension) const;

  const std::string& file() const { return file_; }

  [[noreturn]] void fail(const Mark& mark, std::string message, std::string hint = "") const;
  // For a call that is neither one of the mathematical functions nor one of the scope's: says how the function is
  // written if the name is right, otherwise the nearest name among the functions and `others`.
  [[noreturn]] void unknown_call(const Call& call, const Mark& mark, const std::vector<std::string>& others = {}) const;

 private:
  Scope<Scalar>& scope_;
  const std::string& file_;
};

// The meaning of names and calls. Hooks that are not overridden do what their comment says.
template <class Scalar>
class Scope {
 public:
  virtual ~Scope() = default;

  // Names but `pi` and `any`.
  virtual Value<Scalar> name(const Name& name, const Mark& mark, const Evaluator<Scalar>& evaluator) = 0;
  // Calls but the mathematical functions in their own form (see mathematical_functions()). An unknown one is to be
  // reported by evaluator.unknown_call().
  virtual Value<Scalar> call(const Call& call, const Mark& mark, const Evaluator<Scalar>& evaluator) = 0;
  // A->B: the value of B minus that of A, both vectors.
  virtual Value<Scalar> arrow(const Arrow& arrow, const Mark& mark, const Evaluator<Scalar>& evaluator);
  // A of plate: refused.
  virtual Value<Scalar> of(const Of& of, const Mark& mark, const Evaluator<Scalar>& evaluator);
  // .x .y .z of a vector; anything else is refused.
  virtual Value<Scalar> member(const Member& member, const Mark& mark, const Evaluator<Scalar>& evaluator);
  // X @ instant: refused.
  virtual Value<Scalar> at(const At& at, const Mark& mark, const Evaluator<Scalar>& evaluator);
};

// Throws StatementError for what can never be right (lb added to ft, cos(25)), its kind DomainError for what has no
// value with the data at hand (division by zero, sqrt of a negative number, asin beyond 1, infinite results).
//
// Numbers: a literal without unit is `bare`, as is all that is built only from such. A bare zero fits every dimension.
// A bare number that is not zero is no angle: sin(25) and `90 - theta` are refused with the repair. A list of three
// numbers of one dimension is a vector. Angles are soft: the sum of m/s and rad*m/s is in m/s, that of a pure number
// and an angle is an angle.
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
