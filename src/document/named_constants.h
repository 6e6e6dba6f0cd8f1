// The constants that stand in formulas, by their digits for programs and by their names for people.
#pragma once

#include <vector>

#include "poinsot/document.h"

namespace poinsot::document {

// Those of the constants that stand in formulas, assumptions or conditions of the solutions.
std::vector<Constant> constants_in(const std::vector<Solution>& solutions, const std::vector<Constant>& constants);

// The document as people read it: 5*m*g/2 in place of 5*m*9.80665/2, and what g is among the assumptions of each
// solution in which it stands.
Document with_named_constants(Document document);

}  // namespace poinsot::document
