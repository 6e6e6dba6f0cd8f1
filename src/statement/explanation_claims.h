// What decided each claim, as a section of a worked solution.
#pragma once

#include "poinsot/statement/solve_statement.h"
#include "statement/explanation_tex.h"

namespace poinsot::statement {

// solution: of solve_statement with what it tells of claims. Without steps where there are no claims.
ExplainedSection claims_section(const Statement& statement, const Solution& solution, const ExplanationTex& tex);

}  // namespace poinsot::statement
