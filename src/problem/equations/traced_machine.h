// The mechanism of a situation over a scalar that records the operations done with it.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "poinsot/engine/dynamics/equations_of_motion.h"
#include "poinsot/engine/math/trace/traced.h"
#include "problem/equations/equations.h"
#include "problem/language/exact_numbers.h"
#include "problem/machine/machine.h"

namespace poinsot::problem {

struct TracedMachine {
  MachineOf<Formula> stated;
  Mechanism<Traced> mechanism;
  Trace trace;
  // The inputs of the trace in this order: q, v, third (accelerations or forces), parameters.
  State<Traced> state;
  std::vector<Traced> third;
  std::vector<TextInput> inputs;
  std::vector<bool> held;  // for each velocity coordinate, whether its motion is given
  // For each constraint that is a contact which slides against friction, the component that pushes and rubs; else -1.
  std::vector<int> rubbing;

  bool rubs() const {
    return std::ranges::any_of(rubbing, [](int component) { return component >= 0; });
  }
};

// Throws StatementError and NoEquations.
TracedMachine traced_machine(const Situation& situation, const EquationsOptions& options,
                             const std::string& third_array);

}  // namespace poinsot::problem
