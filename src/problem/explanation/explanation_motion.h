// Explains a motion in time: what moves it, how it is followed, and what stays constant.
#pragma once

#include <string>
#include <vector>

#include "problem/explanation/explanation_tex.h"
#include "problem/explanation/general_motion.h"
#include "problem/unknowns/sample.h"

namespace poinsot::problem {

// general: the motion in formulas, if it has any; suffix: follows the headings. The motion has been followed for some
// time. Throws StatementError as the motion does.
std::vector<ExplainedSection> motion_sections(const Statement& statement, std::size_t situation, Sample& sample,
                                              const GeneralMotion* general, const ExplanationTex& tex,
                                              const std::string& suffix);

}  // namespace poinsot::problem
