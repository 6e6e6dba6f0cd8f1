// Checks each stated fact in the solution, evaluated as it stands in the file.
#pragma once

#include <optional>

#include "problem/unknowns/sample.h"

namespace poinsot::problem {

// The largest difference between stated and found values of facts, at the start and before and after a blow. It is
// relative to the larger side or to the natural size of the quantity. Rates and accelerations stated in joints are
// included, and facts about forces if forces are solved. Nothing if no instant has facts. Throws StatementError if a
// fact has no value.
std::optional<double> largest_fact_misfit(const Statement& statement, Sample& sample);

// Facts about later instants, extremes and periods follow from the others, and must be true. Throws StatementError
// where they are not.
void hold_later_facts(const Statement& statement, const Settings& settings);

}  // namespace poinsot::problem
