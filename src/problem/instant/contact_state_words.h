// States of contacts with friction as a user reads them, and the names of the directions in which they slide.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "problem/machine/data.h"
#include "problem/results/solution.h"

namespace poinsot::problem {

Expression number_expression(double value);
// A direction as an expression: by its components as drawn, or by a name.
Expression direction_expression(const Vector3<double>& d);
Expression named_direction(const std::string& name, bool opposite);
// The axis of a joint with friction, in whose sense `to` moves or in the opposite one.
Expression joint_direction(const Contact& friction, bool opposite);
// The situation with its contacts in these states; those that name another situation are passed over.
void put_in_states(Situation& situation, std::size_t number, const std::vector<ContactState>& states);
// The situation with all states of contacts still to be found.
Situation with_states_open(const Situation& situation);

// "contact 'floor' slides along x". along: the components of the direction, if it slides in one without a name.
std::string words_of(const ContactState& state, const std::vector<double>& along = {});
// The same with numbers wherever the direction has no name.
std::string words_of(const ContactState& state, const Situation& situation, const Settings& settings);

// "where 'a' sticks, 'b' slides", of states that are tried.
std::string words_of_trial(const std::vector<ContactState>& states);

// The directions that have names, the axes and those of the file, each with its opposite.
std::vector<Expression> named_directions(const Situation& situation);
// What an expression tells of a direction; nothing if it depends on an unknown, or is none.
std::optional<Vector3<double>> direction_told(DataScope<double>& data, const Expression& expression);

// Gives a direction its name where it has one, for which formulas are exact; false if it has none.
bool name_direction(ContactState& state, const Situation& situation, const Settings& settings);
// The same; one without a name is told by the normal of its contact where it lies across an axis.
bool name_line(ContactState& state, const Situation& situation, const Settings& settings);
// Directions across the normal of a contact and across an axis, each with its opposite: of an incline its steepest
// line. In a planar problem these are the two in the plane.
std::vector<Expression> lines_across(const Situation& situation, const Contact& contact);

// The states of a contact in which unknowns are sought: sticking, sliding along axes, named directions and lines across
// its normal, and parting. Throws StatementError where its slips have no such lines.
std::vector<ContactState> possible_states(const Situation& situation, std::size_t number, const Contact& contact,
                                          const Settings& settings);

// Whether two combinations are the same, with directions by name.
bool are_same(const std::vector<ContactState>& a, const std::vector<ContactState>& b);

}  // namespace poinsot::problem
