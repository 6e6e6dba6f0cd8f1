#include "problem/unknowns/states_at_end.h"

#include <algorithm>

namespace poinsot::problem {
namespace {

bool asks_of(const Extremum& extremum, const Contact& contact, const char* state) {
  return std::ranges::any_of(extremum.conditions, [&](const Expression& condition) {
    const Call* call = condition.as<Call>();
    return call && call->function == state && is_about(*call, contact.name);
  });
}
bool asks_to_stick(const Extremum& extremum, const Contact& contact) { return asks_of(extremum, contact, "sticking"); }

}  // namespace

std::vector<std::string> wanted_to_stick(const Situation& situation, const Extremum& extremum) {
  std::vector<std::string> names;
  if (!situation.cords.empty() || !situation.belts.empty()) return names;
  for (const Contact& contact : situation.contacts) {
    if (!contact.rubs() || contact.friction->falls()) return {};
    if (asks_to_stick(extremum, contact)) names.push_back(contact.name);
  }
  return names;
}

bool leaves_states_open(const Situation& situation, const Extremum& extremum) {
  return std::ranges::any_of(situation.contacts, [&](const Contact& contact) {
    return contact.rubs() && (contact.grip != Grip::sticks || !asks_to_stick(extremum, contact));
  });
}

bool leaves_touching_open(const Situation& situation, const Extremum& extremum) {
  return std::ranges::any_of(situation.contacts, [&](const Contact& contact) {
    return contact.touches() && !contact.rubs() && !contact.flies && !asks_of(extremum, contact, "touching");
  });
}

}  // namespace poinsot::problem
