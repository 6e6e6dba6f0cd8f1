// What decided each claim, as a section of a worked solution.
#pragma once

#include "problem/answers/solve_statement.h"
#include "problem/explanation/explanation_tex.h"

namespace poinsot::problem {

// solution: of solve_statement with what it tells of claims. Without steps where there are no claims.
ExplainedSection claims_section(const Statement& statement, const Solution& solution, const ExplanationTex& tex);

}  // namespace poinsot::problem
