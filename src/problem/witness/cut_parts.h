// Whether what is cut out of a body is there to be cut.
//
// The mass of a body is the sum of its parts less that of its holes. It is wrong where a hole reaches out of the parts
// (a round notch on an edge stated as a whole disk) or two holes overlap (bores that cross). No sum shows it: this
// looks at points of the shapes themselves.
#pragma once

#include <optional>
#include <string>

#include "problem/machine/data.h"

namespace poinsot::problem {

// Why a body of the situation is none, with what to do; nothing where all holes are sound, or have parts of which
// nothing is drawn. Finds what reaches out by more than some thousandths of the size of the parts.
std::optional<std::string> unsound_hole(const Situation& situation, DataScope<double>& data);

}  // namespace poinsot::problem
