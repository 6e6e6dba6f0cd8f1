// Laws that hold in different parts of the letters: u_max = d, or 2*s - d where s > d.
//
// Where a law fails far from where it was found, another is sought there by the same trials, until each point that was
// tried has its law. What parts them is the sign of a formula that is made of the laws themselves: their difference,
// where one goes over into the other, or what stands under a root; or the bound that was found for the first.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "poinsot/engine/work/work.h"
#include "problem/formulas/law_reach.h"

namespace poinsot::problem {

struct LawRegime {
  Value<Formula> law;
  std::vector<Formula> positive;  // wherever it holds; nothing if it holds everywhere
};

// first: the law found at the base, which fails at some letters, none of which is an angle. bound: what is positive
// where it holds, if that is known. find: the law around other letters. Nothing unless every point tried belongs to a
// law whose condition is known and was confirmed on both sides of its border.
std::optional<std::vector<LawRegime>> law_regimes(
    const HeldLaw& first, const std::optional<Formula>& bound, const std::vector<Letter>& letters,
    const LetterValues& base, const ScalingTrials::Solve& solve,
    const std::function<std::optional<Value<Formula>>(const LetterValues& around)>& find, double tolerance, Work most);

}  // namespace poinsot::problem
