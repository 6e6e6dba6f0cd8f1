// Contacts with dry friction along a motion: in which states they are from one of its events to the next.
//
// Between events a contact that sticks is held as a constraint, and one that slides has the friction of its slip: along
// a line as long as the slip stays on it, else against the slip of each instant. The states change where a slip
// vanishes, where the friction of a contact at rest comes to its limit, and where loads jump; they are then found as at
// an instant, for all contacts together.
#include <algorithm>
#include <cmath>
#include <utility>

#include "problem/course/course.h"
#include "problem/course/motion_piece.h"
#include "problem/course/state_times.h"
#include "problem/instant/contact_state_search.h"
#include "problem/instant/contact_state_words.h"
#include "problem/language/diagnostic.h"
#include "problem/language/words.h"

namespace poinsot::problem {
namespace {

// Of the natural speed: a slip that vanishes leaves across its line what the check of lines lets pass, and so that it
// is none there must be some room above that.
constexpr double none_slips = 1.25 * off_line;

const Mark& mark_of_friction(const Situation& situation) {
  return std::ranges::find_if(situation.contacts, [](const Contact& contact) { return contact.friction.has_value(); })
      ->friction->mark;
}

}  // namespace

SolvedInstant& Course::probe_in(std::size_t states, const MotionState& state) {
  if (probes_.size() < in_states_.size()) probes_.resize(in_states_.size());
  if (!probes_[states])
    probes_[states] = std::make_unique<SolvedInstant>(*in_states_[states], settings_, state, choice_);
  return *probes_[states];
}

void Course::move_probe(const MotionState& state) {
  probe_ = &probe_in(states_of(state), state);
  probe_->move_to(state);
}

// The first piece that contains its time, as in at().
std::size_t Course::states_of(const MotionState& state) const {
  const StageRun& run = stages_[state.stage];
  for (std::size_t i = 0; i < run.pieces.size(); ++i) {
    const Trajectory& piece = run.pieces[i];
    if (!piece.empty() && state.time >= piece.start_time() && state.time <= piece.end_time()) return run.states[i];
  }
  return run.states_now;
}

// time: at which the loads are taken. leaving: the contact that can stick no longer; empty if there is none.
void Course::find_contact_states(std::size_t stage, double time, const std::string& leaving) {
  StageRun& now = stages_[stage];
  if (!rubs(now)) return;
  // What has come to rest has no velocity left, whose sense would be that of rounding; after a slip that turned what
  // was left of it (piece_friction.cpp), ten times for its levers.
  const bool turned = std::ranges::any_of(in_states_[now.states_now]->contacts, &Contact::slip_turns);
  const double rounding = turned ? 1e3 * tolerance_ : 1e-11;  // of the natural pace
  const std::vector<double> sizes = natural_sizes().of_v;
  for (std::size_t k = 0; k < now.v.size(); ++k)
    if (std::abs(now.v[k]) < rounding * sizes[k] / pace_time_) now.v[k] = 0;
  const std::vector<bool> acting = now.acting.empty() ? std::vector<bool>() : now.acting.back();
  const HeldStates held =
      states_that_hold(*in_states_[now.states_now], 0, settings_,
                       {{time, stage, now.q, now.v, acting}, none_slips * natural_speed(), leaving});
  const std::string when = " at " + with_digits(now.time, 6) + " s";
  const Mark& mark = mark_of_friction(situation_);
  if (!held.doubts.empty() && held.all.size() != 1)
    stops(stage, mark,
          "which states of the contacts with friction hold" + when + " is not known: " + held.doubts.front());
  // As of an instant, what could not be judged beside the state that holds is told.
  if (!held.doubts.empty() && !std::exchange(doubt_told_, true))
    happenings_.push_back("another state of the contacts with friction could not be judged" + when + ": " +
                          held.doubts.front());
  if (held.all.empty())
    stops(stage, mark,
          "no state of the contacts with friction " +
              std::string(held.directions_sought ? "was found that holds" : "holds") + when +
              (held.directions_sought ? ""
                                      : ": rigid bodies with dry friction may have no solution (Painleve's paradox)"));
  if (held.all.size() > 1) {
    std::string words;
    for (const std::vector<ContactState>& states : held.all) {
      words += words.empty() ? ": " : "; or ";
      for (const ContactState& state : states)
        words += (&state == &states.front() ? "" : ", ") + problem::words_of(state, situation_, settings_);
    }
    stops(stage, mark, "the motion may go on in more than one way" + when + words);
  }
  if (held.directions_sought)
    happenings_.push_back("the directions in which several contacts begin to slide" + when +
                          " were sought from some starts: there may be other motions");
  put_in_contact_states(stage, held.all.front());
}

// Contacts that come to their limits begin to slide. Where friction then falls, others may change with them.
void Course::let_slide(std::size_t stage, const std::vector<ContactState>& starting) {
  const bool falls = std::ranges::any_of(starting, [&](const ContactState& state) {
    return std::ranges::find(situation_.contacts, state.contact, &Contact::name)->friction->falls();
  });
  if (!falls) return put_in_contact_states(stage, starting);
  if (starting.size() > 1)
    stops(stage, mark_of_friction(situation_),
          "several contacts begin to slide at once at " + with_digits(stages_[stage].time, 6) +
              " s with less friction than at rest, which is not followed");
  find_contact_states(stage, stages_[stage].time, starting.front().contact);
}

// Those that are not named stay as they are.
void Course::put_in_contact_states(std::size_t stage, const std::vector<ContactState>& states) {
  StageRun& now = stages_[stage];
  auto next = std::make_unique<Situation>(*in_states_[now.states_now]);
  bool any = false, part = false;
  for (const ContactState& state : states) {
    const auto before = std::ranges::find(next->contacts, state.contact, &Contact::name);
    const auto direction = [&](const Expression& slip) {
      return DataScope<double>(situation_, settings_, 0).direction(slip);
    };
    // In a blow before the motion it may have parted already.
    part = part || (state.grip == Grip::parts && !before->flies);
    constexpr double one_direction = 1e-6;
    if (before->grip == state.grip && (state.grip != Grip::slides || (before->slip_turns && !state.from_rest) ||
                                       norm(direction(*before->slip) - direction(*state.slip)) < one_direction))
      continue;
    any = true;
    changes_.push_back({now.time, problem::words_of(state, situation_, settings_)});
    happenings_.push_back(changes_.back().words + " from " + with_digits(now.time, 6) + " s on");
    before->grip = state.grip;
    before->slip = state.slip;
    before->from_rest = state.from_rest;
    before->slip_turns = false;
  }
  now.states_fresh = true;
  if (!any && !part) return;
  std::vector<bool> acting = acting_in(now);
  for (const ContactState& state : states)
    if (state.grip == Grip::parts) acting[action_of_contact(state.contact)] = false;
  now.states_now = in_states_.size();
  in_states_.push_back(next.get());
  changed_states_.push_back(std::move(next));
  if (part) put_in_flight(now, acting);
}

// The times at which a contact comes into a state, the first included if it is in it from the start. Without `to` only
// the first one is sought.
std::vector<double> Course::times_of_state(const Call& call, double from, std::optional<double> to) {
  const auto contact = std::ranges::find_if(
      situation_.contacts, [&](const Contact& one) { return one.friction && is_about(call, one.name); });
  if (contact == situation_.contacts.end()) {
    const bool cord = call.function == "taut", any = cord || call.function == "touching" || call.function == "parting";
    std::vector<std::string> known;
    for (const Contact& one : situation_.contacts)
      if (!cord && (any || one.friction)) known.push_back(one.name);
    for (const Cord& one : situation_.cords)
      if (cord) known.push_back(one.name);
    const std::string name = to_string(call.arguments.front().value), meant = did_you_mean(name, known);
    fail(situation_.file, call.arguments.front().value.mark(),
         "there is no " + std::string(cord ? "cord" : "contact") + " '" + name + "'" + (any ? "" : " with friction"),
         !meant.empty()  ? meant
         : known.empty() ? ""
                         : "known: " + joined(known));
  }
  const Grip asked = call.function == "sticking"  ? Grip::sticks
                     : call.function == "sliding" ? Grip::slides
                                                  : Grip::parts;
  double reached = 0;
  return sought_times(
      from, to, pace_time_,
      [&](double until) {
        const std::optional<UnansweredError> stopped = follow_as_far(until, reached, to.has_value());
        std::vector<double> found = entries_into(stages_, from, until, [&](const StageRun& stage, std::size_t i) {
          const auto& contacts = in_states_[stage.states[i]]->contacts;
          return std::ranges::find(contacts, contact->name, &Contact::name)->grip == asked;
        });
        if (stopped && found.empty()) throw UnansweredError(*stopped);
        values_until_ = std::max(values_until_, found.empty() ? reached : found.back());
        return found;
      },
      [&](double until) {
        if (ends_by(until) || followed_enough(until))
          throw NotHappeningError(situation_.file, call.arguments.front().value.mark(),
                                  in_vain(call.function + "(" + contact->name + ")", reached), look_until,
                                  ends_by(until) ? INFINITY : reached);
      });
}

// Contacts whose slip leaves its line: it is followed again from where the line began to be taken.
void Course::let_turn(std::size_t stage, const std::vector<std::string>& contacts) {
  StageRun& now = stages_[stage];
  auto next = std::make_unique<Situation>(*in_states_[now.states_now]);
  for (Contact& contact : next->contacts)
    if (std::ranges::find(contacts, contact.name) != contacts.end()) contact.slip_turns = true;
  now.states_fresh = true;
  now.states_now = in_states_.size();
  in_states_.push_back(next.get());
  changed_states_.push_back(std::move(next));
}

}  // namespace poinsot::problem
