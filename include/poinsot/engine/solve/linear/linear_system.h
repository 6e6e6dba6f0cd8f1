// Linear equations with names: what they determine, what they leave open and where they contradict each other, and
// the derivatives of solution and misfits.
#pragma once

#include <initializer_list>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "poinsot/engine/math/algebra/dual.h"

namespace poinsot::solve {

struct LinearSolution {
  std::vector<double> value;                    // one solution, in which open unknowns are zero as far as possible
  std::vector<std::vector<double>> open;        // a basis of the solutions of the homogeneous equations
  std::vector<std::vector<std::size_t>> share;  // for each basis vector the unknowns that change along it
  std::vector<std::size_t> conflict;            // equations that cannot hold together; empty if all hold
  std::vector<double> misfit;                   // for each equation, in its natural unit
  double size = 0;                              // of the largest term of any equation, in natural units
  double residual = 0;                          // largest misfit, relative to the largest term of any equation
  double condition = 1;                         // the ratio of the largest to the smallest pivot, after scaling

  // Whether the equations determine this unknown.
  bool determined(std::size_t unknown) const;
};

// Where an equation of mechanics comes from: the kind, and the place among the bodies, the constraints or the stated
// conditions that it was made of. So nobody has to read it off the words.
enum class EquationKind { other, balance, constraint, condition };
struct EquationSource {
  EquationKind kind = EquationKind::other;
  std::size_t index = 0;
};

// Equations sum_j a_ij x_j = b_i. Every unknown and every equation comes with the size of its natural unit in the
// problem, so that lengths in millimeters and couples in kilonewton meters become numbers near one. The scalar is
// double, Dual<1> or Formula; solve() works in doubles.
template <class Scalar>
class LinearSystemOf {
 public:
  // A name may be given in parts, which are joined. The parts must not point into the names of this system.
  std::size_t add_unknown(std::initializer_list<std::string_view> name, double scale = 1);
  std::size_t add_unknown(std::string_view name, double scale = 1) { return add_unknown({name}, scale); }
  std::size_t add_equation(std::initializer_list<std::string_view> words, double scale = 1, EquationSource source = {});
  std::size_t add_equation(std::string_view words, double scale = 1, EquationSource source = {}) {
    return add_equation({words}, scale, source);
  }
  // rounding: a coefficient of this size, in its own unit, may be what rounding left of zero and then counts as zero.
  // If left out, it is a small part of the equation's largest coefficient.
  void add(std::size_t equation, std::size_t unknown, const Scalar& coefficient, std::optional<double> rounding = {});
  // size: that of the terms of which the value is the sum, if they may have cancelled.
  void add_right_side(std::size_t equation, const Scalar& value, double size = 0);

  std::size_t unknowns() const { return unknowns_.size(); }
  std::size_t equations() const { return equations_.size(); }
  // The names are valid until something is added.
  std::string_view name(std::size_t unknown) const { return text_of(unknowns_[unknown].name); }
  std::string_view words(std::size_t equation) const { return text_of(equations_[equation].words); }
  const EquationSource& source(std::size_t equation) const { return equations_[equation].source; }
  // The coefficients a_ij as they were added, in rows, and the right sides b_i.
  std::vector<std::vector<Scalar>> coefficients() const;
  std::vector<Scalar> right_sides() const;

  // Solves the scaled equations by Householder QR with column pivoting. It never throws: LinearSolution::conflict
  // names equations that cannot hold or whose numbers are not finite.
  LinearSolution solve() const;

 private:
  template <class>
  friend struct AssembledSystem;
  friend class LinearFactors;
  struct Entry {
    std::size_t equation, unknown;
    Scalar coefficient;
    std::optional<double> rounding;
  };
  struct Text {
    std::size_t begin, size;
  };
  struct Unknown {
    Text name;
    double scale;
  };
  struct Equation {
    Text words;
    double scale;
    EquationSource source;
    Scalar right_side{};
    double right_size = 0;  // the sum of the magnitudes added to the right side, where they may cancel
  };
  Text text_from(std::initializer_list<std::string_view> parts);
  std::string_view text_of(const Text& text) const { return std::string_view(text_).substr(text.begin, text.size); }
  // Equations are set up much more often than their names are read, so that all names are in one text.
  std::string text_;
  std::vector<Unknown> unknowns_;
  std::vector<Equation> equations_;
  std::vector<Entry> entries_;
};
using LinearSystem = LinearSystemOf<double>;

// What is left of overdetermined equations after all unknowns are eliminated.
template <class Scalar>
struct LinearRemainderOf {
  std::vector<Scalar> values;          // zero where the equations have a solution
  std::vector<std::size_t> equations;  // for each value, the equation that it belongs to
  double size = 0;                     // of the largest term in them
  std::vector<Scalar> solution;        // the unknowns as the other equations determine them; open ones are zero
};

// The scaling and the pivots of one system, held for all systems of a family. The remainder of the elimination
// consists of determinants, so that it is as smooth as coefficients and right sides.
class LinearElimination {
 public:
  // system: preferably one of the highest rank in the family. late: for each equation, whether it gives a pivot only
  // if the others do not suffice. This is for facts, whose misfits are then the remainder.
  explicit LinearElimination(const LinearSystemOf<double>& system, const std::vector<bool>& late = {});

  std::size_t rank() const;
  // The remainder of a system of the family. Returns nothing if the pivots are singular to the last digit or belong
  // to a system of lower rank, if numbers are not finite, or if the system has another size. With the scalar Dual<1>
  // it has derivatives.
  template <class Scalar>
  std::optional<LinearRemainderOf<Scalar>> remainder(const LinearSystemOf<Scalar>& system) const;

 private:
  struct Parts;
  std::shared_ptr<const Parts> parts_;
};

// The derivatives of LinearSolution::value and LinearSolution::misfit.
struct LinearDerivative {
  std::vector<double> value, misfit;
};

// The solution of a system, with its factors kept for derivatives.
class LinearFactors {
 public:
  template <class Scalar>
  explicit LinearFactors(const LinearSystemOf<Scalar>& system);
  LinearFactors(LinearFactors&&) noexcept;
  LinearFactors& operator=(LinearFactors&&) noexcept;
  ~LinearFactors();

  const LinearSolution& solution() const;

  // The derivatives of solution and misfits by the variable of the dual numbers. `varied` must have the values of the
  // system that was factored. With y = A^+ b on the columns that the basic solution uses, r = b - A y and h = db - dA
  // y:
  //   dy = A^+ h + (A^T A)^+ dA^T r,   dr = (1 - A A^+) h - (A^+)^T dA^T r
  // (Golub and Pereyra, SIAM J. Numer. Anal. 10, 413, 1973), where dA and db hold how the scaling varies, which decides
  // between equations that contradict each other; for constant rank. Not a number if the system was not finite.
  LinearDerivative derivative(const LinearSystemOf<Dual<1>>& varied) const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

extern template class LinearSystemOf<double>;
extern template class LinearSystemOf<Dual<1>>;

}  // namespace poinsot::solve
