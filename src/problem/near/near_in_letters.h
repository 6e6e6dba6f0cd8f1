// What is told of the motion near a steady one in letters: frequencies, rates of growth, responses.
#pragma once

#include <vector>

#include "poinsot/engine/math/formula/formula.h"
#include "problem/entries/statement.h"
#include "problem/language/value.h"
#include "problem/machine/data.h"
#include "problem/machine/machine.h"

namespace poinsot::problem {

// An instant in formulas, and its machine in numbers.
struct InstantInLetters {
  const Situation& situation;
  DataScope<Formula>& data;
  const MachineOf<Formula>& machine;
  const std::vector<Formula>&q, &v;
  const Machine& numbers;
};

// frequencies(B), growth_rate(B), eigenvalues(B) of all that moves near the instant, and response(X to F) where nothing
// moves in it. Of a body that takes no part in some of the modes they are not those of the body: whoever asks compares
// with numbers. Throws NoFormula where there is no formula.
Value<Formula> near_in_letters(const InstantInLetters& instant, const Call& call);

}  // namespace poinsot::problem
