#include "problem/answers/idle_contacts.h"

#include <algorithm>
#include <cmath>

#include "problem/instant/contact_state_search.h"
#include "problem/instant/instant.h"
#include "problem/instant/massless_turning.h"
#include "problem/language/diagnostic.h"

namespace poinsot::problem {

bool rests_before_blow(const Situation& situation, const Settings& settings) {
  const SolvedInstant before(situation, settings, When{0, false}, OpenChoice{});
  // A particle has no turning that could be stated.
  std::vector<std::vector<double>> open = before.velocities().open;
  take_massless(before.machine(), open);
  return open.empty() && std::ranges::none_of(before.state().v, [](double rate) { return std::abs(rate) > 0; });
}

void add_joints_in_blow(const Situation& situation, std::size_t number, std::vector<ContactState>& states) {
  for (const Contact& contact : situation.contacts)
    if (contact.in_joint)
      states.push_back({contact.name, number, Grip::slides, joint_direction(contact, false), false, true, true});
}

std::optional<std::vector<ContactState>> idle_in_blow(const Situation& situation, std::size_t number,
                                                      const Settings& settings) {
  for (const Contact& contact : situation.contacts)
    if (contact.in_joint && contact.all_ways && !contact.friction->bearing)
      fail(situation.file, contact.friction->mark,
           "a blow is not solved beside joint '" + contact.name + "' with friction in several ways together",
           "leave out its friction, which is limited and has no impulse, or ask after the blow");
    else if (contact.in_joint && contact.friction->bearing)
      fail(situation.file, contact.friction->mark,
           "a blow is not solved beside joint '" + contact.name +
               "', whose friction follows from what it carries: how far it moves in the blow is not sought",
           "leave out the friction of the joint, or state it as a couple or force, which a blow does not feel");
  const bool only_joints =
      std::ranges::all_of(situation.contacts, [](const Contact& one) { return !one.rubs() || one.in_joint; });
  const bool from_rest = !only_joints && situation.impacts.empty() && rests_before_blow(situation, settings);
  if (from_rest) return std::nullopt;
  std::vector<ContactState> states;
  for (const Contact& contact : situation.contacts) {
    if (!contact.rubs() || contact.in_joint) continue;
    if (situation.has_rough_blow())
      fail(situation.file, contact.friction->mark,
           "an impact with friction is not solved beside contact '" + contact.name + "', which has friction as well",
           "leave out the friction of one of them");
    states.push_back({contact.name, number, Grip::parts, {}, false, false, true});
  }
  add_joints_in_blow(situation, number, states);
  Situation idle = situation;
  put_in_states(idle, number, states);
  const SolvedInstant after(idle, settings, When{0, true}, OpenChoice{});
  constexpr double rounding = 1e-9;  // of the speeds in a blow
  for (std::size_t k = 0; k < after.machine().rough_contacts.size(); ++k) {
    const RoughContactOf<double>& contact = after.machine().rough_contacts[k];
    if (!contact.in_joint() &&
        after.rough_motion_as_drawn(k, false).apart < -rounding * after.natural_size(dimensions::velocity))
      fail(situation.file, std::ranges::find(situation.contacts, contact.name, &Contact::name)->friction->mark,
           "the blow presses contact '" + contact.name +
               "', which has friction: that is solved for impulses and strikes on what is at rest before",
           "leave out the friction of the contact, or state what strikes as a strike on bodies at rest");
  }
  return states;
}

}  // namespace poinsot::problem
