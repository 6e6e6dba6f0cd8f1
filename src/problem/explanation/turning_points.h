// Where a coordinate is largest or smallest its rate vanishes: what the motion keeps says there how far it goes.
#pragma once

#include <vector>

#include "problem/explanation/explanation_tex.h"
#include "problem/explanation/general_motion.h"
#include "problem/explanation/kept_values.h"

namespace poinsot::problem {

// A step for each extreme of a named coordinate that the statement asks for, or states, with the kept values as
// equations there and their solution. What has no formula, or does not hold in numbers, is left out.
std::vector<ExplainedStep> turning_points(const Statement& statement, std::size_t situation, Sample& sample,
                                          const std::vector<KeptValue>& kept, const GeneralMotion& general,
                                          const ExplanationTex& tex);

}  // namespace poinsot::problem
