// The motion near a steady one in formulas: the linearised equations of the deviations of its free coordinates.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "poinsot/engine/math/formula/formula.h"
#include "poinsot/engine/solve/stability/near_equations.h"
#include "problem/entries/statement.h"
#include "problem/machine/machine.h"

namespace poinsot::problem {

using FormulaMatrix = solve::Rows<Formula>;

// A steady motion whose numbers are formulas.
struct SteadyFormulas {
  const MachineOf<Formula>& machine;
  const std::vector<Formula>&q, &v;
  int frame = 0;          // in which everything rests but for spins
  std::vector<int> held;  // velocity coordinates whose motion is given, and those of massless turning
  // How many eigenvalues vanish because the whole can be displaced without changing the motion.
  std::size_t symmetries = 0;
};

// That of a mechanism without constraints, in a frame of the situation or at rest. numbers: the same machine in
// numbers.
SteadyFormulas steady_formulas(const Situation& situation, const MachineOf<Formula>& machine,
                               const std::vector<Formula>& q, const std::vector<Formula>& v, const Machine& numbers);

std::vector<std::size_t> free_coordinates(const SteadyFormulas& motion);

// The linearised equations M x'' + C x' + K x = 0 of the deviations of the free coordinates.
struct LinearisedFormulas {
  FormulaMatrix M, C, K;
  bool follows_spin = false;    // whether axes turn relative to those of the coordinates
  std::vector<Formula> unrest;  // vanishes if the motion is steady
};
LinearisedFormulas linearised(const SteadyFormulas& motion, const std::vector<std::size_t>& free);

// The coefficients of a polynomial by a letter of at most this degree, in ascending powers.
std::vector<Formula> coefficients_by(Formula polynomial, const std::string& letter, std::size_t degree);
// Those of det(M l^2 + C l + K) by l.
std::vector<Formula> characteristic_polynomial(const LinearisedFormulas& near);

FormulaMatrix zeros(std::size_t n);
// Whether every entry is zero.
bool vanishes(const FormulaMatrix& A);

// Expands by the first row. Number: a formula, or a complex number of two.
template <class Number>
Number determinant(const std::vector<std::vector<Number>>& A) {
  if (A.empty()) return {Formula(1)};
  if (A.size() == 1) return A[0][0];
  Number total;
  for (std::size_t k = 0; k < A.size(); ++k) {
    if (A[0][k].is_zero()) continue;
    std::vector<std::vector<Number>> minor;
    for (std::size_t i = 1; i < A.size(); ++i) {
      minor.emplace_back();
      for (std::size_t j = 0; j < A.size(); ++j)
        if (j != k) minor.back().push_back(A[i][j]);
    }
    const Number part = A[0][k] * determinant(minor);
    total += k % 2 == 0 ? part : -part;
  }
  return total;
}

}  // namespace poinsot::problem
