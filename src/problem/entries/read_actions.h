// Reads what carries bodies, strikes or shakes them: frames, contacts, cords, gears, blows, excitations.
#pragma once

#include <string>

#include "problem/entries/statement.h"

namespace poinsot::problem {

Frame read_frame(const Key& name, const Entry& entry, const std::string& file);
// One coefficient of dry friction, or one at rest and one for sliding; of a joint couples or forces.
Friction read_friction(const Entry& entry, const Mark& mark, const std::string& file);
Contact read_contact(const Key& name, const Entry& entry, const std::string& file);
Cord read_cord(const Key& name, const Entry& entry, const std::string& file);
Belt read_belt(const Key& name, const Entry& entry, const std::string& file, bool chain);
// The friction of cords and belts on what they are led over, whose states are found with those of contacts.
std::vector<Contact> frictions_on(const Situation& situation);
Gear read_gear(const Key& name, const Entry& entry, const std::string& file);
Impulse read_impulse(const Key& name, const Entry& entry, const std::string& file);
Impact read_impact(const Key& name, const Entry& entry, const std::string& file);
Strike read_strike(const Key& name, const Entry& entry, const std::string& file);
Excitation read_excitation(const Key& name, const Entry& entry, const std::string& file);

}  // namespace poinsot::problem
