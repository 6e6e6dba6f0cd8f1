// Reads what carries bodies or strikes them: frames, contacts, cords, gears, and blows.
#pragma once

#include <string>

#include "problem/entries/statement.h"

namespace poinsot::problem {

Frame read_frame(const Key& name, const Entry& entry, const std::string& file);
// One coefficient of dry friction, or one at rest and one for sliding; of a joint couples or forces.
Friction read_friction(const Entry& entry, const Mark& mark, const std::string& file);
Contact read_contact(const Key& name, const Entry& entry, const std::string& file);
Cord read_cord(const Key& name, const Entry& entry, const std::string& file);
Gear read_gear(const Key& name, const Entry& entry, const std::string& file);
Impulse read_impulse(const Key& name, const Entry& entry, const std::string& file);
Impact read_impact(const Key& name, const Entry& entry, const std::string& file);
Strike read_strike(const Key& name, const Entry& entry, const std::string& file);

}  // namespace poinsot::problem
