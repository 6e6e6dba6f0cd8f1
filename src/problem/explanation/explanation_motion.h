// Explains a motion in time: what moves it, how it is followed, and what stays constant.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "problem/explanation/explanation_tex.h"
#include "problem/explanation/general_motion.h"
#include "problem/results/solution.h"
#include "problem/unknowns/sample.h"

namespace poinsot::problem {

// general: the motion in formulas, if it has any; any_mass: the letter of the one mass that may be any, "" if there is
// none; settings: with the values of what is found; suffix: follows the headings. The motion has been followed for some
// time. Throws StatementError as the motion does.
std::vector<ExplainedSection> motion_sections(const Statement& statement, std::size_t situation, Sample& sample,
                                              const GeneralMotion* general, const std::string& any_mass,
                                              const Settings& settings, const ExplanationTex& tex,
                                              const std::string& suffix);

// The blows along the part of a motion that has been followed, each kind of them once, by their times. settings: as
// above.
std::map<double, std::vector<ExplainedSection>> later_blow_sections(const Course& motion, const ExplanationTex& tex,
                                                                    const Settings& settings,
                                                                    const std::string& suffix);

// Whether all accelerations keep, in a stage, the values that they have at its start, and some rate changes: all of its
// coordinates are then told by them. Throws StatementError as the motion does.
bool is_uniform_stage(Sample& sample, std::size_t situation, std::size_t stage);

// What such a stage leads to: the rates at its end.
ExplainedSection uniform_stage(const Situation& situation, std::size_t situation_index, std::size_t stage,
                               Sample& sample, const ExplanationTex& tex, const std::string& suffix);

// Angles between vectors and sizes of vectors that are asked for at this instant, from what was found of these.
ExplainedSection vectors_section(const Statement& statement, const Solution& solution, const Sample::Home& home,
                                 Sample& sample, const ExplanationTex& tex, const std::string& suffix);

// Vectors that are asked for on the axes of a body that has turned: these axes, and the components on them. Without
// steps if nothing is asked so at this instant.
ExplainedSection turned_axes_section(const Statement& statement, const Sample::Home& home, Sample& sample,
                                     const ExplanationTex& tex, const std::string& suffix);

}  // namespace poinsot::problem
