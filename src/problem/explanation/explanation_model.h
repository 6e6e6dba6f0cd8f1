// What a worked solution says before it calculates: the model, what is known, the principle.
#pragma once

#include "problem/explanation/explanation_questions.h"
#include "problem/explanation/explanation_tex.h"

namespace poinsot::problem {

// The bodies and how they are held, what acts, what is known of the motion, what is to be found. heading: of the
// section.
ExplainedSection model_section(const Situation& situation, const Settings& settings, const ExplanationTex& tex,
                               const std::string& heading);

// Which principle answers the questions about these instants, and why.
ExplainedSection principle_section(const Statement& statement, const StatementQuestions& questions);

}  // namespace poinsot::problem
