// Contacts that meet along a motion: blows with restitution, one after the other, and without end in a finite time.
//
// With the restitution e < 1 and pressed together by an acceleration a, a contact that leaves with the speed u comes
// back after 2 u/a with the same speed and leaves with e u: infinitely many blows take (2 u/a)/(1 - e) (Goldsmith,
// Impact, ch. 2). Once u is small beside the first speed of approach, a changes no more meanwhile, and the contact is
// held from there on: the momenta are the same, and places differ by u times that time. The same holds once the height
// of a flight, u^2/(2 a), is hardly more than what places are known to: far down a slope that is so much sooner.
#include <algorithm>
#include <cmath>
#include <limits>

#include "poinsot/engine/dynamics/velocity_constraint.h"
#include "problem/course/course.h"
#include "problem/course/lost_contact.h"
#include "problem/course/motion_piece.h"
#include "problem/language/diagnostic.h"
#include "problem/language/words.h"

namespace poinsot::problem {
namespace {

constexpr double small_speed = 3e-6;  // of the first speed of approach: its square is rounding of the motion
constexpr double no_speed = 1e-8;     // of the same: where the motion itself is hardly known
constexpr double seen_height = 1e4;   // times the rounding of places: speeds after flights are then good to its inverse
constexpr double short_flight = 0.1;  // of the time in which the motion changes noticeably
constexpr double meets = 1e-10;       // of the natural length and speed: where a contact is closed, and approached

}  // namespace

const Contact* Course::later_contact(std::size_t action) const {
  const Action& named = start_->machine().mechanism.actions[action];
  if (named.kind != ActionKind::contact) return nullptr;
  const auto contact = std::ranges::find(situation_.contacts, named.name, &Contact::name);
  return contact != situation_.contacts.end() && contact->may_be_struck() ? &*contact : nullptr;
}

std::optional<std::size_t> Course::Piece::normal_of(std::size_t action) const {
  const auto& constraints = machine_.mechanism.constraints;
  const auto found = std::ranges::find_if(constraints, [&](const VelocityConstraint<double>& constraint) {
    return constraint.action == static_cast<int>(action) && constraint.normal;
  });
  if (found == constraints.end()) return std::nullopt;
  return static_cast<std::size_t>(found - constraints.begin());
}

double Course::Piece::gap_rate(std::size_t action, std::span<const double> v) {
  return dynamics_->gap_rate(*normal_of(action), now_.q, v);
}

double Course::Piece::opening(std::size_t action, std::span<const double> v) {
  return opening_acceleration(*dynamics_, *normal_of(action), now_.q, v, motion_.pace_time_);
}

double Course::Piece::rounding_of_gap(std::size_t action) {
  limit_state_.set_positions({now_.q.begin(), now_.q.end()});
  const Vector3<double> place = constraint_point(machine_.mechanism.tree, limit_state_.workspace(),
                                                 machine_.mechanism.constraints[*normal_of(action)]);
  return std::numeric_limits<double>::epsilon() * (motion_.start_->natural_size(dimensions::length) + norm(place));
}

double Course::Piece::kinetic_energy(std::span<const double> v) { return dynamics_->kinetic_energy(now_.q, v); }

// The contacts that are closed and approached, and those given.
std::vector<std::size_t> Course::Piece::meeting(std::optional<std::size_t> at_event) {
  std::vector<std::size_t> found;
  if (!motion_.has_later_contacts_) return found;
  const double length = motion_.start_->natural_size(dimensions::length);
  for (std::size_t action = 0; action < acting_.size(); ++action) {
    if (acting_[action] || !motion_.later_contact(action)) continue;
    const std::optional<std::size_t> normal = normal_of(action);
    if (!normal) continue;
    if (action == at_event || (std::abs(dynamics_->gap(*normal, now_.q)) <= meets * length &&
                               gap_rate(action, now_.v) < -meets * motion_.natural_speed()))
      found.push_back(action);
  }
  return found;
}

std::vector<std::size_t> Course::Piece::catching_beside(std::size_t action) {
  const Mechanism<double>& mechanism = machine_.mechanism;
  const double length = meets * motion_.start_->natural_size(dimensions::length),
               speed = meets * motion_.natural_speed();
  std::vector<std::size_t> found;
  for (std::size_t c = 0; c < mechanism.constraints.size(); ++c) {
    const VelocityConstraint<double>& constraint = mechanism.constraints[c];
    const bool of_cord = is_cord_length(constraint);
    const auto other = static_cast<std::size_t>(constraint.action);
    const auto together = [&](std::size_t one) {
      return one == other || act_together(mechanism.actions[one], mechanism.actions[other]);
    };
    if (!(constraint.normal || of_cord) || acting_[other] || motion_.later_contact(other) || together(action) ||
        std::ranges::any_of(found, together))
      continue;
    const double rate = dynamics_->gap_rate(c, now_.q, now_.v);
    if (std::abs(dynamics_->gap(c, now_.q)) <= length && (of_cord ? rate > speed : rate < -speed))
      found.push_back(other);
  }
  return found;
}

// What is said to be open must not overlap, nor be pressed together.
void Course::Piece::check_open() {
  const double length = motion_.start_->natural_size(dimensions::length);
  for (std::size_t action = 0; action < acting_.size(); ++action) {
    const Contact* contact = motion_.later_contact(action);
    if (!contact || !contact->open || acting_[action]) continue;
    const std::optional<std::size_t> normal = normal_of(action);
    if (!normal) continue;
    const double gap = dynamics_->gap(*normal, now_.q), rate = gap_rate(action, now_.v);
    if (gap < -meets * length)
      fail(motion_.situation_.file, contact->mark,
           "contact '" + contact->name + "' is open, and at the start the bodies overlap there by " +
               with_digits(-gap, 4) + " m",
           "correct the place of the body, or the point under surface:");
    if (gap > meets * length) continue;
    if (rate < -meets * motion_.natural_speed())
      fail(motion_.situation_.file, contact->mark,
           "contact '" + contact->name + "' is open, and the bodies strike each other there at the very start",
           "state the blow under impacts:");
    const double acceleration = motion_.natural_speed() / motion_.pace_time_;
    constexpr double none = 1e-6;  // as in would_press_in()
    if (rate <= meets * motion_.natural_speed() && opening(action, now_.v) < -none * acceleration)
      fail(motion_.situation_.file, contact->mark,
           "contact '" + contact->name + "' is open, and the bodies are pressed together there from the start",
           "leave out open: true");
  }
}

// The restitution and the friction of a contact.
SolvedInstant::Met Course::met(std::size_t action) {
  const Contact& contact = *later_contact(action);
  SolvedInstant::Met one{action, 0, std::nullopt};
  if (contact.restitution) one.restitution = start_->data_number(*contact.restitution, dimensions::none);
  if (!(one.restitution >= 0 && one.restitution <= 1))
    fail(situation_.file, contact.restitution->mark(),
         "a coefficient of restitution lies between 0 and 1, and that of contact '" + contact.name + "' is " +
             with_digits(one.restitution, 6));
  if (contact.friction) {
    one.friction = start_->data_number(contact.friction->sliding, dimensions::none);
    if (!(*one.friction >= 0))
      fail(situation_.file, contact.friction->sliding.mark(),
           "the coefficient of friction of contact '" + contact.name + "' is negative");
    if (*one.friction == 0 && !contact.friction->falls()) one.friction.reset();
  }
  return one;
}

// Several contacts that meet at once are struck one by one if none changes the approach of the others. Else their
// blows are taken together, each with its restitution: Newton's law for all of them, which has one motion after it as
// far as it has any (a bar that lands flat on two supports leaves them as it came). With friction none is known but
// without rebound.
std::vector<std::size_t> Course::struck_together(const std::vector<std::size_t>& meeting, const MotionState& state,
                                                 Piece& piece, const std::vector<bool>& besides) {
  if (meeting.size() < 2) return meeting;
  probe_->strike_later({met(meeting.front())}, besides, piece.acting(), later_contact(meeting.front())->mark);
  const std::vector<double> after = probe_->state().v;
  bool apart = true, plastic = true, smooth = true;
  for (std::size_t k = 0; k < meeting.size(); ++k) {
    const SolvedInstant::Met one = met(meeting[k]);
    plastic = plastic && one.restitution == 0;
    smooth = smooth && !one.friction;
    const double before = piece.gap_rate(meeting[k], state.v);
    constexpr double same = 1e-9;
    if (k > 0) apart = apart && std::abs(piece.gap_rate(meeting[k], after) - before) <= same * std::abs(before);
  }
  probe_->move_to(state);
  if (apart) return {meeting.front()};
  // Without rebound the laws of friction hold for all of them together (landing.cpp).
  if (!smooth && plastic) return meeting;
  if (!smooth)
    stops(state.stage, later_contact(meeting.front())->mark,
          "the contacts '" + later_contact(meeting[0])->name + "' and '" + later_contact(meeting[1])->name +
              "' are struck at the same time, at " + with_digits(state.time, 6) +
              " s, with friction: which is struck first, on which the motion depends, is open: state a gap between "
              "them, by their points or surface:, so that one is first");
  if (!plastic) {
    const std::string told =
        "contacts that are struck at the same time and whose blows change each other's have them together, each with "
        "its restitution; with a gap between them, however small, one would follow the other";
    if (std::ranges::find(happenings_, told) == happenings_.end()) happenings_.push_back(told);
  }
  return meeting;
}

// Of many blows the first one of each kind is kept.
void Course::keep_blow(LaterBlow blow) {
  constexpr std::size_t most_kinds = 8;
  const auto known = std::ranges::find(later_blows_, blow.actions, &LaterBlow::actions);
  if (known != later_blows_.end()) {
    known->again = true;
    return;
  }
  if (later_blows_.size() >= most_kinds) return;
  blow.states = static_cast<std::size_t>(
      std::ranges::find(probes_, probe_, [](const auto& probe) { return probe.get(); }) - probes_.begin());
  later_blows_.push_back(std::move(blow));
}

Course::StruckAgain Course::strike_again(const LaterBlow& blow) const {
  StruckAgain again{in_states_[blow.states], nullptr};
  again.instant = std::make_unique<SolvedInstant>(*again.situation, settings_, blow.before, choice_);
  again.instant->strike_later(blow.met, blow.acting, blow.touching, mark_of(blow.before.stage));
  return again;
}

void Course::strike(std::size_t stage, const std::vector<std::size_t>& meeting, Piece& piece) {
  StageRun& now = stages_[stage];
  std::vector<bool>& acting = piece.acting();
  const MotionState state{now.time, stage, now.q, now.v, std::vector<bool>(acting.size(), true)};
  probe_ = &probe_for_blow(now, state);
  probe_->move_to(state);
  const std::vector<std::size_t> beside = piece.rubbing();
  std::vector<bool> besides = acting;
  for (const std::size_t action : beside) besides[action] = false;
  const std::vector<std::size_t> struck = struck_together(meeting, state, piece, besides);
  std::vector<SolvedInstant::Met> all;
  for (const std::size_t action : struck) all.push_back(met(action));
  const bool plastic = std::ranges::all_of(all, [](const SolvedInstant::Met& one) { return one.restitution == 0; });
  if (all.size() > 1 &&
      std::ranges::any_of(all, [](const SolvedInstant::Met& one) { return one.friction.has_value(); }))
    return land(stage, struck, beside, piece);
  for (const SolvedInstant::Met& one : all)
    if (one.friction && later_contact(one.action)->friction->falls())
      stops(stage, later_contact(one.action)->friction->mark,
            "the contact '" + later_contact(one.action)->name + "' is struck at " + with_digits(now.time, 6) +
                " s with less friction while it slides than at rest, and in a blow there is one coefficient");
  // A blow without rebound may press others that touch, with which it is shared then.
  const bool shares = plastic && all.front().friction && !beside.empty();
  const auto land_on_all = [&] {
    probe_->move_to(state);
    land(stage, struck, beside, piece);
  };
  try {
    probe_->strike_later(all, besides, acting, later_contact(struck.front())->mark);
  } catch (const UnansweredError&) {
    if (!shares) throw;
    return land_on_all();
  }
  const std::vector<double> after = probe_->state().v;
  if (shares && std::ranges::any_of(beside, [&](std::size_t action) {
        return piece.gap_rate(action, after) < -meets * natural_speed();
      }))
    return land_on_all();
  const SolvedInstant::Residuals residuals = probe_->check();
  blow_misfit_ = std::max({blow_misfit_.value_or(0), residuals.impulse, residuals.particles.momentum});
  if (residuals.blow) rough_blow_misfit_ = std::max(rough_blow_misfit_.value_or(0), *residuals.blow);
  keep_blow({state, struck, all, besides, acting});
  const std::string when = " at " + with_digits(now.time, 6) + " s";
  const double lost = piece.kinetic_energy(now.v) - piece.kinetic_energy(after);
  acting = probe_->blow_acting();
  for (const std::size_t action : beside) acting[action] = true;
  now.flight = 0;
  std::vector<std::size_t> held;
  double speed = natural_speed();
  for (const SolvedInstant::Met& one : all) {
    const Contact& contact = *later_contact(one.action);
    const double before = piece.gap_rate(one.action, now.v), leaves = piece.gap_rate(one.action, after);
    // By the gaps of the motion, which are not in the equations of the blow, and the restitution as it is stated.
    const double stated = contact.restitution ? start_->data_number(*contact.restitution, dimensions::none) : 0;
    if (!one.friction && before < 0)
      blow_misfit_ = std::max(*blow_misfit_, std::abs(leaves + stated * before) / -before);
    struck_.resize(acting.size());
    BlowsOfAction& blows = struck_[one.action];
    blows.fastest = std::max(blows.fastest, -before);
    speed = std::max(speed, -before);
    settled_.erase(contact.name);
    std::string change = "the contact '" + contact.name + "' is struck";
    if (one.restitution == 0) {
      change += " without rebound";
    } else {
      const double opening = piece.opening(one.action, after);
      constexpr double none = 1e-6;  // of the natural acceleration, as in would_press_in()
      const bool comes_back = opening < 0;
      const double flight = comes_back ? 2 * leaves / -opening : std::numeric_limits<double>::infinity();
      if (comes_back) now.flight = now.flight > 0 ? std::min(now.flight, flight) : flight;
      const double ratio = before < 0 ? leaves / -before : one.restitution;
      // The sum of all flights is known where they are so short that nothing else changes meanwhile. What comes back by
      // itself, as a pendulum to a stop at its lowest place, flies as long each time: that never ends, and is followed
      // until nothing is to be seen of it.
      const bool ends = flight <= short_flight * pace_time_;
      const bool unseen = ends && leaves * flight / 4 <= seen_height * piece.rounding_of_gap(one.action);
      const bool pushed_away = opening > none * natural_speed() / pace_time_;
      // Where nothing presses it back just then, it has come back by itself before: from the last blow to this one.
      const bool returns = comes_back || (!blows_.empty() && blows_.back().action == one.action);
      if (returns && (unseen || leaves <= (ends ? small_speed : no_speed) * blows.fastest) && !pushed_away &&
          ratio < 1 && one.restitution < 1) {
        const double end = ends ? now.time + flight / (1 - ratio) : std::numeric_limits<double>::infinity();
        settled_[contact.name] = end;
        change = "the contact '" + contact.name +
                 (ends ? "' bounces no more after infinitely many blows until " + with_digits(end, 9) + " s"
                       : "' bounces without end, from " + with_digits(now.time, 6) + " s on too weakly to be told");
        happenings_.push_back(change);
      }
    }
    const bool stays = one.restitution == 0 || settled_.contains(contact.name);
    changes_.push_back({now.time, change});
    blows_.push_back({now.time, one.action});
    // Of many blows the first ones are told, and the end.
    constexpr int most_told = 3;
    const bool told = !settled_.contains(contact.name) && ++blows.told <= most_told;
    if (told)
      happenings_.push_back(change + when +
                            (lost > 0 && &one == &all.front() ? ", which takes " + with_digits(lost, 4) + " J" : ""));
    if (told && probe_->rough_blow())
      happenings_.back() += ": " + words_of_blow(*probe_->rough_blow(), probe_->struck().impacts.front());
    if (stays) held.push_back(one.action);
  }
  now.v = after;
  if (!held.empty()) {
    now.flight = 0;
    for (const std::size_t action : held) acting[action] = true;
    besides = acting;
    for (const std::size_t action : beside) besides[action] = false;
    probe_->move_to({now.time, stage, now.q, now.v, std::vector<bool>(acting.size(), true)});
    now.v = probe_->caught(besides);
  }
  put_in_flight(now, acting);
  leave_blow(stage, beside, speed, piece);
}

double Course::end_of_bouncing(const Expression& of) {
  const Name* name = of.as<Name>();
  const auto contact =
      name ? std::ranges::find(situation_.contacts, name->name, &Contact::name) : situation_.contacts.end();
  if (contact == situation_.contacts.end() || !contact->restitution)
    fail(situation_.file, of.mark(), "'" + to_string(of) + "' is no contact with a restitution",
         "write end_of_bouncing(floor) for a contact that states restitution: 0.8");
  for (double until = 20 * pace_time_;; until *= 2) {
    double reached = 0;
    try {
      reached = follow(until);
    } catch (const UnansweredError&) {
      if (!settled_.contains(contact->name)) throw;
    }
    if (const auto end = settled_.find(contact->name); end != settled_.end() && std::isfinite(end->second)) {
      values_until_ = std::max(values_until_, std::min(end->second, reached));
      return end->second;
    }
    if (ends_by(until) || followed_enough(until) || settled_.contains(contact->name))
      throw UnansweredError(situation_.file, of.mark(),
                            "bouncing on '" + contact->name + "' has not ended after " + with_digits(until, 4) + " s");
  }
}

}  // namespace poinsot::problem
