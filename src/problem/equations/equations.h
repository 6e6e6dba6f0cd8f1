// The equations of motion of a problem file as formulas and as code.
//
// Letters and unknowns remain letters, data become numbers. The equations hold for all values of the coordinates and
// velocities; what the file states of an instant is not used.
#pragma once

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "poinsot/engine/math/trace/straight_line_text.h"
#include "problem/entries/statement.h"

namespace poinsot::problem {

// The parts of the equations M dv/dt = F + J^T y, J dv/dt = b.
enum class EquationPart {
  // These are matrices and vectors.
  mass_matrix,        // M
  right_side,         // F: loads, springs, weights, and the terms that depend on velocities
  constraint_matrix,  // J and b
  reduced,            // in independent coordinates u: dv/dt = N du/dt + g, (N^T M N) du/dt = N^T (F - M g)
  // These are functions.
  position_rate,     // dq/dt
  forward_dynamics,  // dv/dt
  inverse_dynamics   // M a - F
};

struct EquationsOptions {
  std::vector<EquationPart> parts;  // if empty: M and F, and with constraints J and b
  TextForm form = TextForm::plain;
  std::string function = "equations";
  std::string situation;  // one of several in the file; "" if there is only one
  std::vector<std::pair<std::string, std::string>> sets;
  std::vector<std::string> letters;  // data that remain letters
};

// Thrown if the problem has no such equations; what() says why.
class NoEquations : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// The text of the equations. Throws StatementError if the file or a setting is wrong, and NoEquations.
std::string equations_text(const Statement& statement, const EquationsOptions& options);

}  // namespace poinsot::problem
