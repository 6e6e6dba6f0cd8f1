// The equations of motion of a problem file, as formulas and as code.
//
// Letters and unknowns stay letters, data are numbers. What is written holds for every position and velocity of the
// coordinates; what the file says of an instant does not enter.
#pragma once

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "poinsot/engine/math/trace/straight_line_text.h"
#include "problem/entries/statement.h"

namespace poinsot::problem {

// M dv/dt = F + J^T y, J dv/dt = b.
enum class EquationPart {
  // of the matrices
  mass_matrix,        // M
  right_side,         // F: loads, springs, weights, and what the velocities bring
  constraint_matrix,  // J and b
  reduced,            // independent coordinates u: dv/dt = N du/dt + g, (N^T M N) du/dt = N^T (F - M g)
  // others
  position_rate,     // dq/dt
  forward_dynamics,  // dv/dt
  inverse_dynamics   // M a - F
};

struct EquationsOptions {
  std::vector<EquationPart> parts;  // empty: M and F, and where there are constraints J and b
  TextForm form = TextForm::plain;
  std::string function = "equations";
  std::string situation;  // of several in the file; "": the only one
  std::vector<std::pair<std::string, std::string>> sets;
  std::vector<std::string> letters;  // data that are to stay letters
};

// Equations that cannot be had for this problem, with the reason.
class NoEquations : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// Throws StatementError where the file, or a value set, is wrong; NoEquations.
std::string equations_text(const Statement& statement, const EquationsOptions& options);

}  // namespace poinsot::problem
