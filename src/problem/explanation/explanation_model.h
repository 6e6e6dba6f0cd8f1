// The beginning of a worked solution: the model, what is known, the principle.
#pragma once

#include <set>
#include <string>

#include "problem/explanation/explanation_questions.h"
#include "problem/explanation/explanation_tex.h"

namespace poinsot::problem {

// Describes the bodies and how they are held, what acts, what is known of the motion and what is sought. heading:
// that of the section.
ExplainedSection model_section(const Situation& situation, const Settings& settings,
                               const std::set<std::string>& hidden, const ExplanationTex& tex,
                               const std::string& heading);

// Names the principle that answers the questions about these instants, and why it does.
ExplainedSection principle_section(const Statement& statement, const StatementQuestions& questions);

// Leaves out sections on inertia that say what one before them has said: of what a blow or the time does not change.
void leave_out_said_inertia(std::vector<ExplainedSection>& sections);

// Adds the lines at limits. of_same: whether all lines are of the same situation; then what acts at a limit, and how
// bodies move, is told by the equations there once it has been listed above.
void append_at_limits(std::vector<ExplainedSection>& sections, std::vector<ExplainedSection> at_limits, bool of_same);

}  // namespace poinsot::problem
