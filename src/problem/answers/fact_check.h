// Whether what is stated holds in the answer, one fact after the other, evaluated there as it stands.
#pragma once

#include <optional>

#include "problem/unknowns/sample.h"

namespace poinsot::problem {

// The largest difference between what facts state and what is found, at the start and before and after a blow, relative
// to the larger side or the natural size of such a quantity; rates and accelerations that joints state included. Facts
// about forces count where forces are solved. Nothing where no instant has facts. Throws StatementError where a fact
// has no value.
std::optional<double> largest_fact_misfit(const Statement& statement, Sample& sample);

}  // namespace poinsot::problem
