// When smooth contacts touch and part, and cords are taut, along a motion.
//
// A smooth contact or a cord acts over whole pieces of the motion or not at all; where bodies meet and leave each other
// with restitution it acts in blows alone, which lie between pieces. The second road to the times is geometry: where
// bodies come to touch, or a cord is stretched, the gap between the surfaces as drawn is closed (constraint_check.h).
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "poinsot/engine/solve/instant/constraint_check.h"
#include "problem/course/course.h"
#include "problem/course/state_times.h"
#include "problem/language/diagnostic.h"
#include "problem/language/expression_walk.h"
#include "problem/language/words.h"

namespace poinsot::problem {

// The action of the smooth contact or of the cord that touching(), parting() or taut() is about. Contacts with friction
// have states of their own.
std::optional<std::size_t> Course::smooth_hold(const Call& call) const {
  const bool cord = call.function == "taut";
  const auto& actions = start_->machine().mechanism.actions;
  for (std::size_t i = 0; i < actions.size(); ++i) {
    if (actions[i].kind != (cord ? ActionKind::cord : ActionKind::contact) || !is_about(call, actions[i].name))
      continue;
    const auto rough = std::ranges::find_if(situation_.contacts, [&](const Contact& contact) {
      return contact.name == actions[i].name && contact.friction.has_value();
    });
    if (cord || call.function == "touching" || (call.function == "parting" && rough == situation_.contacts.end()))
      return i;
  }
  return std::nullopt;
}

// The times at which it comes into the state, the first included if it is in it from the start. Without `to` only the
// first one is sought.
std::vector<double> Course::times_of_hold(const Call& call, double from, std::optional<double> to) {
  const std::size_t action = *smooth_hold(call);
  const bool wants_apart = call.function == "parting";
  const auto acts = [&](const StageRun& stage, std::size_t i) {
    return stage.acting[i].empty() || stage.acting[i][action];
  };
  // In a blow it touches, and parts unless it acts from then on.
  const auto stays_from = [&](double time) {
    for (const StageRun& stage : stages_)
      for (std::size_t i = 0; i < stage.pieces.size(); ++i)
        if (!stage.pieces[i].empty() && stage.pieces[i].start_time() == time) return acts(stage, i);
    return false;
  };
  double reached = 0;
  const auto find = [&](double until) {
    const std::optional<UnansweredError> stopped = follow_as_far(until, reached, to.has_value());
    std::vector<double> found = entries_into(
        stages_, from, until, [&](const StageRun& stage, std::size_t i) { return acts(stage, i) != wants_apart; });
    for (const Blow& blow : blows_)
      if (blow.action == action && blow.time >= from && blow.time <= until && !(wants_apart && stays_from(blow.time)))
        found.push_back(blow.time);
    std::ranges::sort(found);
    found.erase(std::unique(found.begin(), found.end()), found.end());
    if (stopped && found.empty()) throw UnansweredError(*stopped);
    values_until_ = std::max(values_until_, found.empty() ? reached : found.back());
    return found;
  };
  return sought_times(from, to, pace_time_, find, [&](double until) {
    if (ends_by(until) || followed_enough(until))
      throw NotHappeningError(situation_.file, call.arguments.front().value.mark(),
                              in_vain(call.function + "(" + to_string(call.arguments.front().value) + ")", reached),
                              look_until, ends_by(until) ? INFINITY : reached);
  });
}

// In a blow the gap is closed that was open before and is open after. Elsewhere it is closed all the time that they
// touch, and the forces at an instant tell whether they do.
void Course::tell_of_hold(const Expression& condition, const std::vector<double>& found, double from,
                          std::optional<double> to) {
  Call call = *condition.as<Call>();
  const std::size_t action = *smooth_hold(call);
  const bool in_blow = std::ranges::any_of(blows_, [&](const Blow& blow) {
    return blow.action == action && std::ranges::find(found, blow.time) != found.end();
  });
  const int sense = in_blow ? 0 : call.function == "parting" ? -1 : 1;
  if (call.function == "parting") call.function = "touching";
  NumberInTime number = [this, holds = built(call, condition.mark())](double time) {
    move_probe(at(time));
    return probe_->raw(holds, std::nullopt, nullptr).truth ? 1.0 : -1.0;
  };
  if (in_blow)
    number = [this, action](double time) {
      const MotionState now = at(time);
      if (has_later_contacts_ && !whole_machine_) {
        move_probe(now);
        whole_machine_ = probe_->machine_at(time, std::nullopt);
      }
      const Machine& machine = whole_machine_ ? *whole_machine_ : start_->machine();
      const double gap = solve::gap_of(machine.links, machine.mechanism.constraints, static_cast<int>(action), now.q);
      // Beside the sizes of the figure: what rounding leaves between bodies that rest on each other.
      constexpr double closed = 1e-12;
      return std::abs(gap) <= closed * start_->natural_size(dimensions::length) ? 0 : gap;
    };
  tell({to_string(condition), std::move(number), from, to ? *to : found.front(),
        [found, sense](const MotionScan& scan) { return scan.of_zeros(found, sense); }});
}

}  // namespace poinsot::problem
