// The range in which an unknown is sought: as `where:` states it, and as nature has it where nothing is stated.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "poinsot/engine/solve/roots/roots.h"
#include "problem/unknowns/unknown_system.h"

namespace poinsot::problem {

// `where:` comparisons between one unknown and values narrow its range; slot_of tells which range is that of a name.
using SlotOf = std::function<std::optional<std::size_t>(const std::string& name)>;
void narrow_ranges(const Situation& situation, const Settings& settings, std::vector<solve::RootRange>& ranges,
                   const SlotOf& slot_of);

// natural: the size that a quantity of each slot's dimension has in the problem, 0 where that is not known. A stated
// range is the range. Else masses, durations, lengths that are no coordinates of places, stiffnesses, dampings and
// pushes that are chosen among are not negative; angles are within a half turn.
std::vector<solve::RootRange> ranges_of(const Statement& statement, const UnknownSystem& system,
                                        const AllSettings& settings, const std::vector<double>& natural);

// Whether what stands under `where:` holds, as far as it does not speak of `sought` unknowns without a value.
bool satisfies_where(const Statement& statement, const std::vector<std::size_t>& situations,
                     const AllSettings& settings, const std::set<std::string>& sought);

}  // namespace poinsot::problem
