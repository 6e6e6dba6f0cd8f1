// Explains a motion in time: what moves it, how it is followed, and what stays constant.
#pragma once

#include <string>
#include <vector>

#include "problem/explanation/explanation_tex.h"
#include "problem/unknowns/sample.h"

namespace poinsot::problem {

// suffix: follows the headings. Throws StatementError as the motion does.
std::vector<ExplainedSection> motion_sections(const Statement& statement, std::size_t situation, Sample& sample,
                                              const ExplanationTex& tex, const std::string& suffix);

}  // namespace poinsot::problem
