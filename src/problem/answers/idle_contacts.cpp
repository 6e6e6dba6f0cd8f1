#include "problem/answers/idle_contacts.h"

#include <algorithm>
#include <cmath>

#include "problem/instant/blow_as_loads.h"
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

namespace {

void refuse_rough_joints(const Situation& situation) {
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
}

// The states in which no contact or joint with friction takes part.
std::vector<ContactState> idle_states(const Situation& situation, std::size_t number) {
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
  return states;
}

constexpr double rounding = 1e-9;  // of the speeds in a blow

// Calls seen(contact, speed) with how fast each contact with friction parts after the blow if none takes part in it, as
// a part of the speeds.
template <class Seen>
void look_at_contacts(const Situation& situation, std::size_t number, const Settings& settings,
                      const std::vector<ContactState>& states, const Seen& seen) {
  Situation idle = situation;
  put_in_states(idle, number, states);
  const SolvedInstant after(idle, settings, When{0, true}, OpenChoice{});
  for (std::size_t k = 0; k < after.machine().rough_contacts.size(); ++k) {
    const RoughContactOf<double>& contact = after.machine().rough_contacts[k];
    if (!contact.in_joint())
      seen(contact, after.rough_motion_as_drawn(k, false).apart / after.natural_size(dimensions::velocity));
  }
}

}  // namespace

std::optional<std::vector<ContactState>> idle_in_blow(const Situation& situation, std::size_t number,
                                                      const Settings& settings) {
  refuse_rough_joints(situation);
  const bool only_joints =
      std::ranges::all_of(situation.contacts, [](const Contact& one) { return !one.rubs() || one.in_joint; });
  const bool from_rest = !only_joints && situation.impacts.empty() && rests_before_blow(situation, settings);
  if (from_rest) return std::nullopt;
  std::vector<ContactState> states = idle_states(situation, number);
  look_at_contacts(situation, number, settings, states, [&](const RoughContactOf<double>& contact, double apart) {
    if (apart < -rounding)
      fail(situation.file, std::ranges::find(situation.contacts, contact.name, &Contact::name)->friction->mark,
           "the blow presses contact '" + contact.name +
               "', which has friction: that is solved for impulses and strikes on what is at rest before",
           "leave out the friction of the contact, or state what strikes as a strike on bodies at rest");
  });
  return states;
}

std::vector<ContactState> untouched_in_blow(const Situation& situation, std::size_t number,
                                            const std::vector<Settings>& at, const std::string& letter) {
  refuse_rough_joints(situation);
  const std::vector<ContactState> states = idle_states(situation, number);
  const auto refuse = [&](const std::string& message) {
    fail(situation.file, std::ranges::find_if(situation.contacts, &Contact::rubs)->friction->mark,
         message + ": that is solved for numbers, and '" + letter + "' has no value",
         "give the letters values by --set or under given:");
  };
  std::optional<StatementError> refusal;
  // Friction that nothing presses may jam all the same.
  constexpr std::size_t looked_at_for_others = 4;
  std::size_t seen = 0;
  for (const Settings& settings : at) {
    bool untouched = true, several = false;
    try {
      look_at_contacts(situation, number, settings, states,
                       [&](const RoughContactOf<double>& /*contact*/, double apart) {
                         untouched = untouched && std::abs(apart) <= rounding;
                       });
      several = untouched && seen < looked_at_for_others && situation.impacts.empty() &&
                rests_before_blow(situation, settings) &&
                states_that_hold(blow_as_loads(situation), number, settings, false).all.size() > 1;
    } catch (const StatementError& error) {
      if (!refusal) refusal = error;
      continue;
    }
    ++seen;
    if (!untouched) refuse("the blow presses or lifts contacts with friction");
    if (several) refuse("several states of the contacts with friction hold in the blow");
  }
  if (seen == 0 && refusal) throw StatementError(*refusal);
  if (seen == 0) refuse("no letters were found for which what is assumed holds");
  return states;
}

}  // namespace poinsot::problem
