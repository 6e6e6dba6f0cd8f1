// What a motion holds constant: masses, shapes, the places of joints, springs and dampers.
#pragma once

#include "problem/entries/statement.h"

namespace poinsot::problem {

// Throws StatementError if one of these is stated as a function of time, which the equations of motion would not know.
void require_steady_data(const Situation& situation);

}  // namespace poinsot::problem
