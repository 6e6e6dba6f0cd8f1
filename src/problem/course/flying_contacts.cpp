// Contacts with dry friction that are lost along a motion and struck: in the states of a motion they fly, and act no
// more, until a blow closes them.
//
// In a blow friction has an impulse only where the push has one (Coulomb's law on impulses), and friction in a joint,
// where it is limited, has none. So contacts with friction beside a blow take no part in it as long as it does not
// press them together: where it leaves them closed they slip on as it has left them, where it opens them they part.
#include <algorithm>
#include <cmath>

#include "problem/course/course.h"
#include "problem/course/motion_piece.h"
#include "problem/instant/contact_state_search.h"
#include "problem/language/words.h"

namespace poinsot::problem {

std::vector<bool> Course::acting_in(const StageRun& run) const {
  return run.acting.empty() ? std::vector<bool>(start_->machine().mechanism.actions.size(), true) : run.acting.back();
}

std::size_t Course::action_of_contact(const std::string& name) const {
  const std::vector<Action>& actions = start_->machine().mechanism.actions;
  return static_cast<std::size_t>(
      std::ranges::find_if(
          actions, [&](const Action& action) { return action.kind == ActionKind::contact && action.name == name; }) -
      actions.begin());
}

// Contacts with friction that do not act fly, and those that do touch, in a state that is to be found.
void Course::put_in_flight(StageRun& run, const std::vector<bool>& acting) {
  auto next = std::make_unique<Situation>(*in_states_[run.states_now]);
  bool any = false;
  for (Contact& contact : next->contacts) {
    if (!contact.friction || !contact.touches()) continue;
    const bool flies = !acting[action_of_contact(contact.name)];
    if (contact.flies == flies) continue;
    any = true;
    contact.flies = flies;
    contact.grip = flies ? Grip::parts : Grip::unknown;
    contact.slip.reset();
    contact.from_rest = contact.slip_turns = false;
    has_later_contacts_ = true;
  }
  if (any) {
    run.states_now = in_states_.size();
    in_states_.push_back(next.get());
    changed_states_.push_back(std::move(next));
  }
  run.begin_piece(acting);
}

// Those with friction that touch, but for joints and cords. With `friction: 0` a contact is smooth.
std::vector<std::size_t> Course::Piece::rubbing() const {
  std::vector<std::size_t> found;
  for (const RoughContactOf<double>& contact : machine_.rough_contacts)
    if (!contact.in_joint() && !contact.on_cord() && (contact.resting != 0 || contact.sliding != 0))
      found.push_back(static_cast<std::size_t>(contact.action));
  return found;
}

// What is held by friction in its joints alone is free in a blow, and contacts without friction, whatever is stated of
// it, take part as smooth ones.
SolvedInstant& Course::probe_for_blow(StageRun& run, const MotionState& state) {
  auto free = std::make_unique<Situation>(*in_states_[run.states_now]);
  bool any = false;
  for (Contact& contact : free->contacts) {
    if (contact.on_cord || (contact.in_joint && contact.friction->bearing))
      stops(state.stage, contact.friction->mark,
            "there is a blow at " + with_digits(state.time, 6) + " s beside " + contact.words() +
                ", whose friction follows from what it carries, and how far that slips meanwhile is not sought");
    if (contact.all_ways)
      stops(state.stage, contact.friction->mark,
            "there is a blow at " + with_digits(state.time, 6) + " s beside " + contact.words() +
                " with friction in several ways together, and which way it slips then is not sought");
    if (contact.friction && !contact.in_joint && !contact.on_cord &&
        start_->data_number(contact.friction->resting, dimensions::none) == 0 &&
        start_->data_number(contact.friction->sliding, dimensions::none) == 0) {
      any = true;
      contact.friction.reset();
      contact.slip.reset();
      contact.grip = Grip::unknown;
      continue;
    }
    if (!contact.in_joint || contact.grip != Grip::sticks) continue;
    any = true;
    contact.grip = Grip::slides;
    contact.slip = joint_direction(contact, false);
  }
  if (!any) return probe_in(run.states_now, state);
  in_states_.push_back(free.get());
  changed_states_.push_back(std::move(free));
  return probe_in(in_states_.size() - 1, state);
}

// The states of contacts with friction after a blow, with the velocities that it has left. beside: those that touched.
// speed: of the blow.
void Course::leave_blow(std::size_t stage, const std::vector<std::size_t>& beside, double speed, Piece& piece) {
  StageRun& now = stages_[stage];
  constexpr double rounding = 1e-9;  // of the speeds in a blow, which is solved to 1e-11 at worst
  std::vector<bool> acting = acting_in(now);
  bool part = false;
  for (const std::size_t action : beside) {
    const double rate = piece.gap_rate(action, now.v);
    const std::string& name = start_->machine().mechanism.actions[action].name;
    if (rate < -rounding * speed)
      stops(stage, std::ranges::find(situation_.contacts, name, &Contact::name)->friction->mark,
            "the blow at " + with_digits(now.time, 6) + " s presses contact '" + name +
                "', which has friction, and how far that slips meanwhile is not sought");
    if (!(rate > rounding * speed)) continue;
    part = true;
    acting[action] = false;
    changes_.push_back({now.time, "the contact '" + name + "' is lost"});
    happenings_.push_back(changes_.back().words + " at " + with_digits(now.time, 6) + " s");
  }
  if (part) put_in_flight(now, acting);
  find_contact_states(stage, now.time, "");
}

}  // namespace poinsot::problem
