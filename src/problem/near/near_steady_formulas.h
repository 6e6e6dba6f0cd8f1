// The motion near a steady one in formulas: the linearised equations of the deviations of its free coordinates.
#pragma once

#include <cstddef>
#include <optional>
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
  // What the components of supports, contacts and cords are along the motion, if the mechanism has constraints.
  std::vector<Formula> components{};
};

// That of a mechanism, without components, in a frame of the situation or at rest. numbers: the same machine in
// numbers.
SteadyFormulas steady_formulas(const Situation& situation, const MachineOf<Formula>& machine,
                               const std::vector<Formula>& q, const std::vector<Formula>& v, const Machine& numbers);

std::vector<std::size_t> free_coordinates(const SteadyFormulas& motion);

// The linearised equations M x'' + C x' + K x = 0 of the deviations of the free coordinates; with constraints
// M x'' + C x' + K x = W y and J x' + B x = 0, y being how the sizes of components change.
struct LinearisedFormulas {
  FormulaMatrix M, C, K, W{}, J{}, B{};
  bool follows_spin = false;      // whether axes turn relative to those of the coordinates
  std::vector<Formula> unrest{};  // vanishes if the motion is steady
};
LinearisedFormulas linearised(const SteadyFormulas& motion, const std::vector<std::size_t>& free);
// The same with constraints, where every joint has one coordinate at most and as many components do work on the free
// coordinates as there are constraints on them; nothing else.
std::optional<LinearisedFormulas> linearised_with_constraints(const SteadyFormulas& motion,
                                                              const std::vector<std::size_t>& free);

// The coefficients of a polynomial by a letter of at most this degree, in ascending powers.
std::vector<Formula> coefficients_by(Formula polynomial, const std::string& letter, std::size_t degree);
// Those of det(M l^2 + C l + K) by l, with constraints of that of ((M l^2 + C l + K, -W), (J l + B, 0)).
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
