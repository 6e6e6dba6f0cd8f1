// Reads what carries bodies or strikes them: frames, contacts, cords, and blows.
#pragma once

#include <string>

#include "problem/entries/statement.h"

namespace poinsot::problem {

Frame read_frame(const Key& name, const Entry& entry, const std::string& file);
Contact read_contact(const Key& name, const Entry& entry, const std::string& file);
Cord read_cord(const Key& name, const Entry& entry, const std::string& file);
Impulse read_impulse(const Key& name, const Entry& entry, const std::string& file);
Impact read_impact(const Key& name, const Entry& entry, const std::string& file);
Strike read_strike(const Key& name, const Entry& entry, const std::string& file);

}  // namespace poinsot::problem
