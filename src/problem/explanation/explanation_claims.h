// The section of a worked solution that shows what decided each claim.
#pragma once

#include "problem/answers/solve_statement.h"
#include "problem/explanation/explanation_tex.h"

namespace poinsot::problem {

// solution: from solve_statement, with what it keeps of claims. The section has no steps if there are no claims.
ExplainedSection claims_section(const Statement& statement, const Solution& solution, const ExplanationTex& tex);

}  // namespace poinsot::problem
