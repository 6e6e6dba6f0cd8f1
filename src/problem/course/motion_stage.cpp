// Follows a stage of a motion piece by piece.
#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "poinsot/engine/work/work.h"
#include "problem/course/course.h"
#include "problem/course/energy_balance.h"
#include "problem/course/motion_piece.h"
#include "problem/course/work_counted.h"
#include "problem/language/diagnostic.h"
#include "problem/language/words.h"
#include "problem/machine/gimbal_lock.h"
#include "problem/results/solution.h"

namespace poinsot::problem {
namespace {

// A pose in words, if it has any: ": crank at 180 deg, joint 'B' at 0 deg".
std::string pose_in_words(const std::vector<NamedCoordinate>& coordinates, const IntegrationResult& result) {
  constexpr double degree = std::numbers::pi / 180;
  constexpr std::size_t most_told = 6;
  std::vector<std::string> words;
  for (const NamedCoordinate& c : coordinates) {
    const double value = result.q[static_cast<std::size_t>(c.position)];
    words.push_back((c.name.empty() ? "joint '" + c.joint + "'" : c.name) + " at " +
                    (c.turning ? with_digits(value / degree, 4) + " deg" : with_digits(value, 4) + " m"));
  }
  if (words.empty()) return "";
  if (words.size() <= most_told + 1) return ": " + joined(words);
  const std::size_t more = words.size() - most_told;
  words.resize(most_told);
  return ": " + joined(words) + " and " + std::to_string(more) + " more";
}

}  // namespace

// The interval from where the stage has arrived to a time, or to where loads and given motions are no longer smooth.
Driving::Span Course::smooth_span(std::size_t stage, double until) {
  const StageRun& now = stages_[stage];
  if (!timed_) return {now.time, until, 0};
  driving_.resize(stages_.size());
  if (!driving_[stage]) {
    const auto loads = stage < situation_.stages.size() ? situation_.stages[stage].loads : std::nullopt;
    const std::optional<double> lasts = now.end ? std::optional(*now.end - now.start) : std::nullopt;
    driving_[stage] = std::make_unique<Driving>(situation_, settings_, loads, now.start, lasts, pace_time_, looks_);
  }
  Driving::Span span = driving_[stage]->span_from(now.time);
  // A remainder of some hundred units in the last place would be rounding.
  constexpr double no_time = 1e-13;
  if (span.end > until - no_time * std::abs(until)) span.end = until;
  return span;
}

// Integrates a stage up to a time, or up to the event that ends it.
void Course::run(std::size_t stage, double until) {
  const WorkCounted counted(*this);
  begin(stage);
  StageRun& now = stages_[stage];
  const Expression* ending =
      stage < situation_.stages.size() && situation_.stages[stage].until ? &*situation_.stages[stage].until : nullptr;
  // An event is sought in growing intervals, until it happens or the motion was followed long enough.
  double span = 20 * pace_time_;
  double target = now.end ? std::min(until, *now.end) : ending ? std::min(until, now.time + span) : until;
  // What is known in closed form is known from its start: rounding on the way would grow where the motion comes near an
  // unstable equilibrium. So it is taken from there again, unless it goes on for a short while only, or for so long
  // that the long steps would leave its first swings without looks.
  constexpr double soon = 1e4;  // of the pace: what is sensitive is told for some forty
  if (in_closed_form_ && target < soon * pace_time_ && !ending && !now.done && !now.pieces.empty() &&
      !now.pieces.back().empty()) {
    const double begun = now.pieces.back().start_time();
    if (target - begun >= 2 * (now.time - begun)) {
      balance_energy();
      const State<double> first = now.pieces.back().state(begun);
      now.q = first.q;
      now.v = first.v;
      now.time = begun;
      now.pieces.pop_back();
      now.acting.pop_back();
      now.states.pop_back();
    }
  }
  const WorkLimit work(most_work_);
  // Contacts that begin to slide along their lines and then turn.
  struct Turning {
    double time;
    std::vector<std::string> contacts;
  };
  std::optional<Turning> turning_from;
  std::optional<double> gave_way_at;  // at the start of a piece
  std::optional<Piece::GivingWay> giving_way;
  while (!now.done && now.time < target) {
    if (now.slips) throw_slip(now);
    const Driving::Span smooth = smooth_span(stage, target);
    // Loads may jump between the spans in which they are smooth: just inside they have their new values.
    if (timed_ && rubs(now) && !now.states_fresh)
      find_contact_states(stage, now.time + 1e-12 * (smooth.end - smooth.begin), "");
    const bool fresh = std::exchange(now.states_fresh, false);
    const auto kept = std::make_shared<Piece>(*this, stage, smooth);
    Piece& piece = *kept;
    if (!fresh && piece.rubs() && now.time > now.start && piece.slip_has_ended()) {
      find_contact_states(stage, now.time, "");
      continue;
    }
    if (ending && !piece.add_ending(*ending)) {
      now.end = now.time;
      now.done = true;
      require_sides_apart(stage, *ending);
      return;
    }
    if (ending) require_comparable(*probes_[now.states_now], *ending, std::nullopt);
    if (has_later_contacts_ && !open_checked_) {
      piece.check_open();
      open_checked_ = true;
    }
    const std::vector<std::size_t> meeting = piece.meeting(std::nullopt);
    if (!meeting.empty()) strike(stage, meeting, piece);
    const std::optional<std::size_t> released = meeting.empty() ? piece.add_holds() : std::nullopt;
    if (released) {
      change_holds(stage, *released, piece);
    }
    if (happenings_.size() > choice_.most_changes)
      throw UnansweredError(situation_.file, mark_of(stage),
                            "cords and contacts give way and catch again without end in " + words_of(stage),
                            "ask for earlier times");
    if (released || !meeting.empty()) continue;
    if (const ContactLimit* limit = piece.beyond_surface()) comes_to_end(stage, *limit);
    piece.check_sides(nullptr);
    if (!piece.add_friction() || stage + 1 < stages_.size())
      rests_from_.reset();
    else if (!rests_from_)
      rests_from_ = now.time;
    double until_then = std::min(smooth.end, now.end.value_or(target));
    if (turning_from) until_then = std::min(until_then, turning_from->time);
    if (giving_way) until_then = std::min(until_then, giving_way->time);
    // Where something happened just before, what is left may be less than a step can be.
    constexpr double no_step = 64 * std::numeric_limits<double>::epsilon();
    if (!turning_from && !giving_way && std::isfinite(until_then) &&
        until_then - now.time <= no_step * std::abs(until_then)) {
      now.time = until_then;
      if (now.end && now.time >= *now.end)
        now.done = true;
      else if (ending && now.time >= target && until > target && !followed_enough(target)) {
        span *= 2;
        target = std::min(until, now.time + span);
      }
      continue;
    }
    IntegrationResult result = piece.follow(until_then, work.left());
    const bool gave_way = giving_way.has_value();
    if (piece.shares() && !gave_way) giving_way = piece.shares_give_way(result.trajectory);
    if (giving_way && !gave_way) {
      if (giving_way->time > now.time)
        now.states_fresh = true;  // the same again, up to then
      else
        piece.let_shares_give_way(*std::exchange(giving_way, std::nullopt));
      continue;
    }
    // What is let go at once with another, as two feet of a table that tips, carries nothing where the piece begins.
    if (const std::optional<std::size_t> action = piece.changes_from_start(result.trajectory)) {
      change_holds(stage, *action, piece);
      continue;
    }
    // A piece may end just where a contact comes to its limit, and so may the loads before a stage.
    if (rubs(now) && gave_way_at != now.time)
      if (const std::optional<std::size_t> event = piece.beyond_limit_from_start(result.trajectory))
        if (const std::vector<ContactState> starting = piece.at_their_limits(*event); !starting.empty()) {
          gave_way_at = now.time;
          let_slide(stage, starting);
          continue;
        }
    if (const std::vector<std::string> turning =
            turning_from ? std::vector<std::string>() : piece.off_their_lines(result.trajectory);
        !turning.empty()) {
      if (const std::optional<double> leave = piece.leave_their_lines(result.trajectory, turning)) {
        turning_from = {*leave, turning};
        now.states_fresh = true;
      } else {
        let_turn(stage, turning);
      }
      continue;
    }
    piece.check_sides(&result.trajectory);
    piece.check_winding(result.trajectory);
    piece.check_nearness(result.trajectory);
    keep(stage, kept, result);
    if (const std::optional<Piece::GivingWay> now_beyond = std::exchange(giving_way, std::nullopt);
        now_beyond && result.ending != Ending::terminal_event) {
      piece.let_shares_give_way(*now_beyond);
      continue;
    }
    if (turning_from) {
      let_turn(stage, turning_from->contacts);
      turning_from.reset();
      if (result.ending != Ending::terminal_event) continue;
    }
    if (result.ending == Ending::terminal_event) {
      if (piece.is_of_friction(result.hits.back().event)) {
        if (const std::vector<ContactState> starting = piece.at_their_limits(result.hits.back().event);
            !starting.empty())
          let_slide(stage, starting);
        else
          find_contact_states(stage, now.time, "");
      } else if (const std::optional<std::size_t> action = piece.action_of(result.hits.back().event)) {
        if (!piece.acting()[*action] && later_contact(*action))
          strike(stage, piece.meeting(action), piece);
        else
          change_holds(stage, *action, piece);
      } else if (const ContactLimit* limit = piece.end_of_surface(result.hits.back().event)) {
        comes_to_end(stage, *limit);
      } else if (const std::optional<std::size_t> cord = piece.end_of_cord(result.hits.back().event)) {
        const std::string& name = piece.machine().mechanism.actions[*cord].name;
        const auto stated = std::ranges::find(situation_.cords, name, &Cord::name);
        stops(stage, stated == situation_.cords.end() ? mark_of(stage) : stated->mark,
              "an end of the cord '" + name + "' comes to its wheel at " + with_digits(now.time, 6) +
                  " s: what it does there is not followed");
      } else {
        now.end = now.time;
        now.done = true;
        require_sides_apart(stage, *ending);
      }
    } else if (now.end && now.time >= *now.end) {
      now.done = true;
    } else if (ending && now.time >= target && until > target && !followed_enough(target)) {
      target = std::min(until, now.time + (span *= 2));
    }
  }
  if (!now.done && ending && until > target) {
    throw UnansweredError(
        situation_.file, ending->mark(),
        "what ends " + words_of(stage) + " has not happened after " + with_digits(now.time - now.start, 4) + " s",
        "check the condition, or write lasts:");
  }
}

// Adds what an integration has reached to the stage, and takes the trajectory out of it. Throws UnansweredError if it
// did not reach its end.
void Course::keep(std::size_t stage, const std::shared_ptr<Piece>& kept, IntegrationResult& result) {
  Piece& piece = *kept;
  methods_.insert(result.method);
  in_closed_form_ = in_closed_form_ && result.closed_form;
  // Sine of the angle between the two lines. A motion whose steps have become too short for rounding is as near as that
  // if it is gimbal lock that stops it; elsewhere the reason is another.
  constexpr double nearly = 1e-3;
  if (!result.complete())
    if (const auto lock = gimbal_lock(piece.machine(), result.q, nearly))
      throw UnansweredError(situation_.file, mark_of(stage),
                            words_of(stage) + " comes at " + with_digits(result.time, 6) + " s to a pose in which " +
                                *lock + ", and is followed no farther",
                            beside_gimbal_lock);
  const std::string steps = ": that took " + std::to_string(result.statistics.steps) + " steps";
  if (result.ending == Ending::step_limit && result.closed_form)
    throw UnansweredError(situation_.file, mark_of(stage),
                          "how often the angles go round is counted turn by turn, in " + words_of(stage) +
                              " no farther than to " + with_digits(result.time, 6) + " s" + steps,
                          "ask for earlier times, or leave the angles of the joint out and ask for places, velocities "
                          "and directions");
  if (result.ending == Ending::step_limit)
    throw UnansweredError(
        situation_.file, mark_of(stage),
        words_of(stage) + " moves too much to be followed farther than " + with_digits(result.time, 6) + " s" + steps,
        "ask for earlier times");
  if (result.ending == Ending::singular_pose)
    throw UnansweredError(situation_.file, mark_of(stage),
                          words_of(stage) + " comes at " + with_digits(result.time, 6) +
                              " s to a pose from which it can go on in more than one way, or in none" +
                              pose_in_words(piece.machine().coordinates, result),
                          "ask for earlier times, or draw the mechanism without this pose on its way");
  if (!result.complete())
    throw UnansweredError(situation_.file, mark_of(stage),
                          words_of(stage) + " cannot be followed: " + poinsot::describe(result), "let it last shorter");
  const Mechanism<double>& mechanism = piece.machine().mechanism;
  const bool by_motion =
      std::ranges::any_of(mechanism.forces, [](const KnownForce<double>& force) { return force.by_motion != nullptr; });
  const bool balanced = (by_motion || piece.rubs()) && !timed_ && piece.machine().accelerations.empty();
  if (!result.drift.empty() || balanced) {
    // What is left of a motion that dies out, by dampers, friction or blows, is small beside what it was.
    const double before = largest_kinetic_;
    largest_kinetic_ = std::max(before, piece.largest_kinetic_energy(result.trajectory));
    if (!result.drift.empty()) {
      const double size = std::max(std::abs(result.drift[0].start), largest_kinetic_);
      energy_drift_ = std::max(energy_drift_.value_or(0), size > 0 ? result.drift[0].largest / size : 0);
    }
    // Many short pieces are balanced as they come: each keeps a machine.
    constexpr std::size_t most_waiting = 32;
    if (balanced && to_balance_.size() >= most_waiting) balance_energy();
    if (balanced) to_balance_.push_back({kept, stage, stages_[stage].pieces.size(), before});
  }
  StageRun& now = stages_[stage];
  now.pieces.push_back(std::move(result.trajectory));
  now.acting.push_back(piece.acting());
  now.states.push_back(now.states_now);
  now.q = result.q;
  now.v = result.v;
  now.time = result.time;
  now.flight = 0;
}

std::optional<double> Course::energy_drift() {
  balance_energy();
  return energy_drift_;
}

void Course::balance_energy() {
  const WorkCounted counted(*this);
  for (const ToBalance& one : std::exchange(to_balance_, {})) {
    one.piece->let_act(stages_[one.stage].acting[one.place]);
    if (const std::optional<double> misfit =
            energy_misfit(one.piece->machine().mechanism, stages_[one.stage].pieces[one.place], one.kinetic,
                          [&](const State<double>& state) { return one.piece->rubbing_power(state); }))
      energy_drift_ = std::max(energy_drift_.value_or(0), *misfit);
  }
}

// A cord that has gone slack slips over the wheels that it turned, and one that winds on a wheel is of no one length
// again.
void Course::refuse_slack(std::size_t stage, std::size_t action, const Piece& piece) {
  const Mechanism<double>& mechanism = piece.machine().mechanism;
  const Action& cord = mechanism.actions[action];
  const auto turns_wheels = [&](const VelocityConstraint<double>& c) {
    return c.kind == VelocityConstraintKind::led_cord && !c.keeps_length &&
           act_together(mechanism.actions[static_cast<std::size_t>(c.action)], cord);
  };
  if (std::ranges::none_of(mechanism.constraints, turns_wheels)) return;
  stops(stage, std::ranges::find(situation_.cords, cord.name, &Cord::name)->mark,
        "the cord '" + cord.name + "' goes slack at " + with_digits(stages_[stage].time, 6) +
            " s: then it slips over the wheels that it turns, which is not followed");
}

// A cord or contact gives way or catches: velocities change as in a blow without rebound, and the next piece begins
// with the other set of cords and contacts.
void Course::change_holds(std::size_t stage, std::size_t action, Piece& piece) {
  StageRun& now = stages_[stage];
  std::vector<bool>& acting = piece.acting();
  if (std::ranges::find(piece.machine().belt_actions, static_cast<int>(action)) != piece.machine().belt_actions.end()) {
    const std::string& name = piece.machine().mechanism.actions[action].name;
    const auto belt = std::ranges::find(situation_.belts, name, &Belt::name);
    stops(stage, belt->mark,
          belt->words() + " has no tension left on one side at " + with_digits(now.time, 6) +
              " s: what it does slack is not followed");
  }
  for (const RoughContactOf<double>& contact : piece.machine().rough_contacts) {
    const std::vector<Action>& all = piece.machine().mechanism.actions;
    if (!contact.on_cord()) continue;
    const auto stated = std::ranges::find(situation_.contacts, contact.name, &Contact::name);
    const std::string when = " at " + with_digits(now.time, 6) + " s";
    if (act_together(all[static_cast<std::size_t>(contact.action)], all[action]))
      stops(stage, stated->friction->mark,
            "the cord of '" + contact.name + "' goes slack" + when + ", which is not followed where it has friction");
    if (!acting[action])
      stops(stage, stated->friction->mark,
            "cords and contacts that catch" + when +
                " pull at a cord with friction, and how far it slips meanwhile is not sought");
  }
  const std::vector<std::size_t> beside = piece.rubbing();
  if (acting[action] && piece.would_press_in(action)) slips(stage, action);
  const MotionState state{now.time, stage, now.q, now.v, std::vector<bool>(acting.size(), true)};
  probe_ = acting[action] ? &probe_in(now.states_now, state) : &probe_for_blow(now, state);
  probe_->move_to(state);
  const std::string time = " at " + with_digits(now.time, 6) + " s";
  refuse_slack(stage, action, piece);
  const bool acts = !acting[action];
  const std::vector<Action>& actions = probe_->machine().mechanism.actions;
  // What catches at once, as two feet of a table, takes part in one blow: one after the other would turn it.
  std::vector<std::size_t> changing{action};
  if (acts) std::ranges::copy(piece.catching_beside(action), std::back_inserter(changing));
  for (const std::size_t one : changing) {
    const Action& other = actions[one];
    for (std::size_t i = 0; i < actions.size(); ++i)
      if (i == one || act_together(actions[i], other)) acting[i] = acts;
    const bool of_cord = other.kind == ActionKind::cord;
    const std::string change = acts ? (of_cord ? "goes taut" : "touches again") : (of_cord ? "goes slack" : "is lost");
    changes_.push_back({now.time, (of_cord ? "the cord '" : "the contact '") + other.name + "' " + change});
    happenings_.push_back(changes_.back().words + time + (acts ? ", without rebound" : ""));
  }
  if (!acts) return put_in_flight(now, acting);
  // What else pulls or pushes takes part, or gives way: a rope that goes taut lifts what lies on the floor.
  std::vector<bool> striking = acting;
  for (const std::size_t other : beside) striking[other] = false;
  probe_->strike_later({}, striking, acting, mark_of(stage));
  keep_blow({state, changing, {}, striking, acting});
  const SolvedInstant::Residuals residuals = probe_->check();
  blow_misfit_ = std::max({blow_misfit_.value_or(0), residuals.impulse, residuals.particles.momentum});
  now.v = probe_->state().v;
  std::vector<bool> after = probe_->blow_acting();
  for (const std::size_t other : beside) after[other] = true;
  constexpr double opens = 1e-9;  // of the natural speed: what the blow leaves closed goes on pressing
  for (std::size_t i = 0; i < actions.size(); ++i) {
    const bool of_cord = actions[i].kind == ActionKind::cord,
               led_on = i > 0 && act_together(actions[i], actions[i - 1]);
    if (!acting[i] || after[i] || led_on) continue;
    if (actions[i].kind == ActionKind::contact && !(piece.gap_rate(i, now.v) > opens * natural_speed())) {
      after[i] = true;
      continue;
    }
    changes_.push_back({now.time, (of_cord ? "the cord '" : "the contact '") + actions[i].name +
                                      (of_cord ? "' goes slack" : "' is lost")});
    happenings_.push_back(changes_.back().words + time);
  }
  acting = std::move(after);
  put_in_flight(now, acting);
  leave_blow(stage, beside, natural_speed(), piece);
}

void Course::stops(std::size_t stage, const Mark& mark, const std::string& words) {
  StageRun& run = stages_[stage];
  run.slips = Slip{mark, words};
  throw_slip(run);
}

// The file says nothing about how a contact slips, so that the motion ends there.
void Course::slips(std::size_t stage, std::size_t action) {
  StageRun& run = stages_[stage];
  const std::string& name = start_->machine().mechanism.actions[action].name;
  const auto contact = std::ranges::find(situation_.contacts, name, &Contact::name);
  run.slips = Slip{contact == situation_.contacts.end() ? mark_of(stage) : contact->mark,
                   "the contact '" + name + "' presses no more at " + with_digits(run.time, 6) +
                       " s, where the motion still needs its friction: it slips before, and how is not stated"};
  throw_slip(run);
}

// Neither is it known how a body continues beyond the end of its round surface.
void Course::comes_to_end(std::size_t stage, const ContactLimit& limit) {
  StageRun& run = stages_[stage];
  run.slips = Slip{limit.mark, "from " + with_digits(run.time, 6) + " s on " + words_of_end(limit)};
  throw_slip(run);
}

void Course::throw_slip(const StageRun& run) const {
  throw UnansweredError(situation_.file, run.slips->mark, run.slips->words, "let the motion end before");
}

}  // namespace poinsot::problem
