// The range in which an unknown is sought: the one stated under `where:`, or else the one that its nature allows.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "poinsot/engine/solve/roots/roots.h"
#include "problem/unknowns/unknown_system.h"

namespace poinsot::problem {

// Narrows ranges by the comparisons of single unknowns with values under `where:`. slot_of gives the index of the
// range that belongs to a name.
using SlotOf = std::function<std::optional<std::size_t>(const std::string& name)>;
void narrow_ranges(const Situation& situation, const Settings& settings, std::vector<solve::RootRange>& ranges,
                   const SlotOf& slot_of);

// natural: the size of a quantity of each slot's dimension in this problem, or 0 if unknown. A range that is stated
// is taken. Otherwise masses, weights, densities, durations, lengths that are not coordinates, stiffnesses, dampings
// and pushes to choose from are not negative, and angles are within half a turn of zero.
std::vector<solve::RootRange> ranges_of(const Statement& statement, const UnknownSystem& system,
                                        const AllSettings& settings, const std::vector<double>& natural);

// Which slots are lengths that are taken as not negative although nothing says so: no extent of a shape, no coordinate
// that stands by itself, and no stated range.
std::vector<std::size_t> lengths_of_doubtful_sign(const Statement& statement, const UnknownSystem& system,
                                                  const AllSettings& settings);

// Whether an unknown is a number that nature does not let be negative: a mass, a duration, the length of a body.
bool is_never_negative(const Statement& statement, const Situation& situation, const Unknown& unknown);

// Whether an unknown is an amount of matter, which {signed: UNIT} lets be negative in no body.
bool is_amount_of_matter(const Situation& situation, const Unknown& unknown);

// Whether the conditions under `where:` hold, except those on `sought` unknowns without value.
bool satisfies_where(const Statement& statement, const std::vector<std::size_t>& situations,
                     const AllSettings& settings, const std::set<std::string>& sought);

}  // namespace poinsot::problem
