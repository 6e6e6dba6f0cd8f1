// Linear equations with names: what they determine, what they leave open, where they contradict each other, and how
// their solution and misfit follow when coefficients and right sides vary.
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
  std::vector<double> value;                    // one solution; open unknowns that nothing fixes are zero in it
  std::vector<std::vector<double>> open;        // basis of the solutions of the homogeneous equations
  std::vector<std::vector<std::size_t>> share;  // for each of `open`: the unknowns that it moves
  std::vector<std::size_t> conflict;            // equations that cannot hold together; empty when all hold
  std::vector<double> misfit;                   // of each equation, in its natural unit
  double size = 0;                              // of the largest term of any equation, in natural units
  double residual = 0;                          // largest misfit, relative to the largest term of any equation
  double condition = 1;                         // ratio of the extreme pivots, after scaling

  // Whether the equations fix this unknown.
  bool determined(std::size_t unknown) const;
};

// Equations sum_j a_ij x_j = b_i. Every unknown and equation comes with the size of one natural unit of it in the
// problem at hand, so that lengths in millimetres and couples in kilonewton metres meet as numbers near one.
// Scalar: double or Dual<1>; they are solved in doubles.
template <class Scalar>
class LinearSystemOf {
 public:
  // The parts of a name follow one another; they are not to be names of this system.
  std::size_t add_unknown(std::initializer_list<std::string_view> name, double scale = 1);
  std::size_t add_unknown(std::string_view name, double scale = 1) { return add_unknown({name}, scale); }
  std::size_t add_equation(std::initializer_list<std::string_view> words, double scale = 1);
  std::size_t add_equation(std::string_view words, double scale = 1) { return add_equation({words}, scale); }
  // rounding: up to which a coefficient may be what rounding left of zero, in its own unit; a small part of the largest
  // one of the equation when left out. Coefficients below it count as zero.
  void add(std::size_t equation, std::size_t unknown, const Scalar& coefficient, std::optional<double> rounding = {});
  // size: of the terms that the value was made from, where they may have cancelled.
  void add_right_side(std::size_t equation, const Scalar& value, double size = 0);

  std::size_t unknowns() const { return unknowns_.size(); }
  std::size_t equations() const { return equations_.size(); }
  // Good until something is added.
  std::string_view name(std::size_t unknown) const { return text_of(unknowns_[unknown].name); }
  std::string_view words(std::size_t equation) const { return text_of(equations_[equation].words); }
  // a_ij as added, row by row, and b_i.
  std::vector<std::vector<Scalar>> coefficients() const;
  std::vector<Scalar> right_sides() const;

  // By Householder QR with column pivoting on the scaled equations. Never throws; see LinearSolution::conflict, which
  // also names equations whose numbers are not finite.
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
    Scalar right_side{};
    double right_size = 0;  // sum of the magnitudes added to the right side, which may cancel there
  };
  Text text_from(std::initializer_list<std::string_view> parts);
  std::string_view text_of(const Text& text) const { return std::string_view(text_).substr(text.begin, text.size); }
  // Equations are set up far more often than their names are read: all names stand in one text.
  std::string text_;
  std::vector<Unknown> unknowns_;
  std::vector<Equation> equations_;
  std::vector<Entry> entries_;
};
using LinearSystem = LinearSystemOf<double>;

// What is left of overdetermined equations when all unknowns are eliminated.
template <class Scalar>
struct LinearRemainderOf {
  std::vector<Scalar> values;          // zero wherever the equations can be satisfied
  std::vector<std::size_t> equations;  // of each value: the equation that is left over
  double size = 0;                     // of the largest term in them
  std::vector<Scalar> solution;        // the unknowns as the other equations fix them; those they leave open are zero
};

// The scaling and the pivots of one system, held for all systems of a family, so that what is left when the unknowns
// are eliminated varies as smoothly as coefficients and right sides do: it consists of determinants.
class LinearElimination {
 public:
  // system: best one of the highest rank in the family. late: of each equation, whether it is a pivot's only where the
  // others do not suffice (facts, so that they are what is left over).
  explicit LinearElimination(const LinearSystemOf<double>& system, const std::vector<bool>& late = {});

  std::size_t rank() const;
  // Nothing where the remainder has no value: where the pivots are singular to the last digit or belong to a system of
  // lower rank, where numbers are not finite, or for a system of another size. Scalar: double, or Dual<1> for the
  // derivatives as well.
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

// A system solved, with its factors kept for derivatives.
class LinearFactors {
 public:
  template <class Scalar>
  explicit LinearFactors(const LinearSystemOf<Scalar>& system);
  LinearFactors(LinearFactors&&) noexcept;
  LinearFactors& operator=(LinearFactors&&) noexcept;
  ~LinearFactors();

  const LinearSolution& solution() const;

  // How solution and misfit change with the variable of the duals; `varied` has the values of the system that was
  // factored. With y = A^+ b on the columns that the basic solution uses, r = b - A y and h = db - dA y:
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
