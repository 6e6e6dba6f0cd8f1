// The events of contacts with dry friction within a piece of a motion: with the push N and the friction F on the body,
// a contact that slides along a line d ceases to where its slip comes to u . d = 0, and one at rest begins to where
// m0^2 N^2 - F^2 comes to zero. Where the slip turns, d = u/|u| in every instant, which has no value where it ceases:
// as |u| falls the steps become shorter in the same measure, and where |u| is rounding beside the motion it is taken
// for none.
#include <algorithm>
#include <cmath>
#include <limits>

#include "poinsot/engine/solve/instant/closure.h"
#include "problem/course/motion_piece.h"
#include "problem/instant/contact_state_search.h"
#include "problem/instant/sticking_margin.h"
#include "problem/language/diagnostic.h"
#include "problem/language/words.h"
#include "problem/quantities/rough_contact.h"

namespace poinsot::problem {
namespace {

// In tolerances of the motion, of the natural speed: a slip that turns is none below. A step that ended beyond its end
// would be seen only if it were far above one; what it would still do is as much as the motion's error.
constexpr double slip_ends = 100;
// Of the natural speed: a slip along a line is where it vanishes, but for rounding.
constexpr double slip_is_none = 1e-11;

// One behind the last component of an action that begins at a place: that of a contact at rest is the push and two
// across it, or in a planar problem one.
std::size_t end_of_components(const Mechanism<double>& mechanism, std::size_t first) {
  std::size_t end = first;
  while (end < mechanism.components.size() && mechanism.components[end].action == mechanism.components[first].action)
    ++end;
  return end;
}

// The motion of a contact along the direction of one of its forces.
const VelocityConstraint<double>& way_along(const RoughContactOf<double>& contact, const Component<double>& force) {
  return *std::ranges::max_element(contact.motions, {}, [&](const VelocityConstraint<double>& way) {
    return std::abs(dot(way.along.vector, force.along.vector));
  });
}

}  // namespace

Vector3<double> Course::Piece::slip(const RoughContactOf<double>& contact, std::span<const double> q,
                                    std::span<const double> v) {
  limit_state_.set_positions({q.begin(), q.end()});
  solve::update_contacts(machine_.mechanism, limit_state_);
  limit_state_.set_velocities({v.begin(), v.end()});
  return rough_motion(limit_state_, contact, false).slip;
}

// The place of its first component: of one that slides the only one, of one that sticks the push before the friction.
std::size_t Course::Piece::push_of(const RoughContactOf<double>& contact) const {
  const auto& components = machine_.mechanism.components;
  return static_cast<std::size_t>(std::ranges::find(components, contact.action, &Component<double>::action) -
                                  components.begin());
}

// The tensions of a cord before and behind a wheel. After accelerate.
std::pair<double, double> Course::Piece::tensions(const RoughContactOf<double>& contact) const {
  double before = 0, behind = 0;
  for (std::size_t k = 0; k < machine_.mechanism.components.size(); ++k) {
    const int action = machine_.mechanism.components[k].action;
    if (action == contact.action) before += dynamics_->component_force(k);
    if (action == contact.behind) behind += dynamics_->component_force(k);
  }
  return {before, behind};
}

// The accelerations, with the friction of slips that turn against the slip of this state.
void Course::Piece::accelerate(std::span<const double> q, std::span<const double> v, std::span<double> a) {
  if (slips_turn_)
    for (RoughContactOf<double>& contact : machine_.rough_contacts) {
      if (!contact.turns) continue;
      const Vector3<double> u = slip(contact, q, v);
      if (!(norm(u) > 0)) continue;
      if (contact.in_joint()) {
        contact.slip->vector = as_drawn(contact, normalized(u));
        continue;
      }
      Vector3<double> d{};
      for (const std::size_t k : {1, 2})
        d += dot(u, direction_now(limit_state_, contact, contact.motions[k].along)) * contact.motions[k].along.vector;
      contact.slip->vector = normalized(d);
      const std::size_t push = push_of(contact);
      const Vector3<double> along = along_sliding_force(contact);
      if (!loads_on_joints_.empty()) machine_.mechanism.components[push].along.vector = along;
      dynamics_->set_direction(push, along);
    }
  if (loads_on_joints_.empty())
    dynamics_->accelerations(q, v, a);
  else
    accelerate_with_joints(q, v, a);
}

// A vector of a joint with friction in several ways on the axes of the body on which its slip is told. Needs the pose.
Vector3<double> Course::Piece::as_drawn(const RoughContactOf<double>& contact, const Vector3<double>& vector) const {
  return direction_on_body(machine_.mechanism.tree, limit_state_.workspace(), contact.normal.body, vector);
}

// Of one unit of slip, beside which what is left of it counts.
double Course::Piece::natural_slip(const RoughContactOf<double>& contact) const {
  return motion_.natural_speed() / (contact.all_ways && contact.turning ? motion_.start_->scales().length : 1);
}

// The friction of a joint at rest. After accelerate(), with the pose.
Vector3<double> Course::Piece::holding_friction(const RoughContactOf<double>& contact) const {
  Vector3<double> friction{};
  for (const RubbingWay<double>& way : contact.ways)
    friction += dynamics_->held_effort(way.coordinate) / way.arm * limit_state_.direction(way.along);
  return friction;
}

// Whether nothing moves or would move, and no load changes: then nothing will.
bool Course::Piece::stays_at_rest() {
  std::ptrdiff_t stuck = 0;
  for (const RoughContactOf<double>& contact : machine_.rough_contacts)
    if (contact.grip == Grip::sticks) stuck += std::ssize(contact.ways);
  if (motion_.timed_ || std::ssize(machine_.accelerations) > stuck) return false;
  std::vector<double> v = now_.v, a(now_.v.size());
  dynamics_->project_velocities(now_.q, v);
  accelerate(now_.q, v, a);
  const std::vector<double> sizes = motion_.natural_sizes().of_v;
  double most = 0;  // of the natural speeds and accelerations
  for (std::size_t k = 0; k < v.size(); ++k) {
    if (turns_nothing(machine_, static_cast<int>(k))) continue;  // as of a particle
    const double speed = sizes[k] / motion_.pace_time_;
    most = std::max({most, std::abs(v[k]) / speed, std::abs(a[k]) * motion_.pace_time_ / speed});
  }
  // What balanced forces leave of an acceleration. Followed, it would take what rests along in the course of hours.
  constexpr double rounding = 1e-14;
  still_ = most <= rounding;
  constexpr double at_rest = 1e-9;
  return most <= at_rest;
}

// Whether a force along a constraint moves anything. What a guide takes altogether needs no friction.
bool Course::Piece::moves_anything(const VelocityConstraint<double>& way) {
  limit_state_.set_positions(now_.q);
  const std::vector<double> row = solve::constraint_row(limit_state_, way).coefficients;
  constexpr double rounding = 1e-12;  // of a lever of the natural length
  for (std::size_t k = 0; k < row.size(); ++k)
    if (!dynamics_->is_held(static_cast<int>(k)) && std::abs(row[k]) > rounding * motion_.start_->scales().length)
      return true;
  return false;
}

// With which friction holds a joint, after accelerate().
double Course::Piece::limit_in_joint(const RoughContactOf<double>& contact) {
  return contact.resting * (contact.pressing.empty() ? 1 : pressing_now(contact, acceleration_));
}

void Course::Piece::refuse_shares(const std::string& contact) const {
  const auto stated = std::ranges::find(motion_.situation_.contacts, contact, &Contact::name);
  motion_.stops(stage_, stated->friction->mark,
                "how contacts at rest share what they carry from " + with_digits(now_.time, 6) +
                    " s on is open, and so is when '" + contact + "' begins to slide");
}

// How far the contacts at rest are from sliding, in the share that keeps them farthest from it. Nothing where that is
// not known.
std::optional<double> Course::Piece::margin_of_shares(double time, const State<double>& there) {
  const MotionState state{inside(time), stage_, there.q, there.v, acting_};
  SolvedInstant& probe = motion_.probe_in(now_.states_now, state);
  probe.move_to(state);
  probe.solve_forces();
  return sticking_margin(probe);
}

// The margin has corners where another share is the best, so that it is looked at and closed in and is no event.
std::optional<Course::Piece::GivingWay> Course::Piece::shares_give_way(const Trajectory& way) {
  if (way.empty()) return std::nullopt;
  constexpr int looks = 8;  // in each step
  // Of the largest force: less is rounding; beside what touches and carries nothing there is no margin at all.
  constexpr double rounding = 1e-9, clear = 1e-7;
  const auto margin = [&](double time) {
    return margin_of_shares(time, way.state(time)).value_or(std::numeric_limits<double>::infinity());
  };
  const double start = way.start_time(), none = margin(start) > rounding ? 0 : -rounding;
  double within = start;
  for (std::size_t i = 0; i < way.step_count(); ++i) {
    const StepView step = way.step(i);
    for (int k = 1; k <= looks; ++k) {
      const double look = step.start + (step.end - step.start) * k / looks;
      if (margin(look) >= none - rounding) {
        within = look;
        continue;
      }
      double beyond = look;
      for (int halving = 0; halving < 60; ++halving) {
        const double middle = 0.5 * (within + beyond);
        (margin(middle) >= none ? within : beyond) = middle;
      }
      double later = beyond;
      for (double span = 1e-9 * motion_.pace_time_; later < look && margin(later) > -clear; span *= 2)
        later = std::min(look, beyond + span);
      return GivingWay{beyond, later, way.state(later)};
    }
  }
  return std::nullopt;
}

// Where it gives way the states of before hold as well, but for rounding: what holds is seen a little later.
void Course::Piece::let_shares_give_way(GivingWay giving) {
  std::swap(now_.q, giving.there.q);
  std::swap(now_.v, giving.there.v);
  const std::size_t before = now_.states_now;
  motion_.find_contact_states(stage_, giving.later, "");
  std::swap(now_.q, giving.there.q);
  std::swap(now_.v, giving.there.v);
  if (now_.states_now == before) refuse_shares(machine_.rough_contacts.front().name);
}

bool Course::Piece::add_friction() {
  if (machine_.rough_contacts.empty()) return false;
  if (stays_at_rest()) return true;
  check_joint_loads();
  const double force = motion_.start_->natural_size(dimensions::force);
  for (const RoughContactOf<double>& contact : machine_.rough_contacts) {
    Event event;
    event.crossing = Crossing::falling;
    event.terminal = true;
    const std::size_t first = push_of(contact);
    if (contact.turns) {
      event.name = "slip comes to rest";
      event.size = motion_.natural_speed() > 0 ? natural_slip(contact) : 1;
      event.value = [this, &contact](double, std::span<const double> q, std::span<const double> v) {
        return norm(slip(contact, q, v)) - slip_ends * motion_.tolerance_ * natural_slip(contact);
      };
    } else if (contact.grip == Grip::slides) {
      event.name = "slip vanishes";
      event.size = motion_.natural_speed() > 0 ? motion_.natural_speed() : 1;
      const auto along = [this, &contact](std::span<const double> q, std::span<const double> v) {
        const Vector3<double> u = slip(contact, q, v);
        return dot(u, direction_now(limit_state_, contact, *contact.slip));
      };
      // What begins to slide at its limit has no slip and next to no acceleration, which may point backwards by
      // rounding. For a hundredth of the pace that is not the end of the slip; afterwards the end is as exact as ever.
      const double none =
          std::min(0.5 * off_line, std::max(slip_is_none, slip_ends * motion_.tolerance_)) * motion_.natural_speed();
      const double slack = along(now_.q, now_.v) <= none ? none : 0, begun = now_.time,
                   while_it_begins = 0.01 * motion_.pace_time_;
      event.value = [along, slack, begun, while_it_begins](double time, std::span<const double> q,
                                                           std::span<const double> v) {
        return along(q, v) + slack * std::max(0.0, 1 - (time - begun) / while_it_begins);
      };
    } else if (contact.in_joint()) {
      event.name = "friction at its limit";
      const double limit = limit_in_joint(contact);
      event.size = limit > 0 ? limit * limit : 1;
      event.value = [this, &contact](double time, std::span<const double> q, std::span<const double> v) {
        refresh(time);
        accelerate(q, v, acceleration_);
        double left = std::pow(limit_in_joint(contact), 2);
        for (const RubbingWay<double>& way : contact.ways)
          left -= std::pow(dynamics_->held_effort(way.coordinate) / way.arm, 2);
        return left;
      };
    } else if (contact.on_cord()) {
      accelerate(now_.q, now_.v, acceleration_);
      for (std::size_t k = 0; k < machine_.mechanism.components.size(); ++k)
        if (const int action = machine_.mechanism.components[k].action;
            (action == contact.action || action == contact.behind) && !dynamics_->component_determined(k))
          motion_.stops(stage_,
                        std::ranges::find(motion_.situation_.contacts, contact.name, &Contact::name)->friction->mark,
                        "a tension of the cord beside '" + contact.name + "' is open from " +
                            with_digits(now_.time, 6) + " s on, and so is when it slips");
      event.name = "friction at its limit";
      event.size = force > 0 ? force * force : 1;
      event.value = [this, &contact](double time, std::span<const double> q, std::span<const double> v) {
        refresh(time);
        accelerate(q, v, acceleration_);
        limit_state_.set_positions({q.begin(), q.end()});
        const auto [before, behind] = tensions(contact);
        return std::pow(resting_of(limit_state_, contact) * (before + behind), 2) - std::pow(before - behind, 2);
      };
    } else {
      accelerate(now_.q, now_.v, acceleration_);
      const std::size_t end = end_of_components(machine_.mechanism, first);
      bool open = false;
      for (std::size_t k = first; k < end && !open; ++k)
        open = !dynamics_->component_determined(k) && moves_anything(way_along(contact, drawn_[k]));
      if (open) {
        if (!shares_ && !margin_of_shares(now_.time, {now_.q, now_.v})) refuse_shares(contact.name);
        shares_ = true;
        continue;
      }
      event.name = "friction at its limit";
      event.size = force > 0 ? force * force : 1;
      event.value = [this, &contact, first, end](double time, std::span<const double> q, std::span<const double> v) {
        refresh(time);
        accelerate(q, v, acceleration_);
        double left = std::pow(contact.resting * dynamics_->component_force(first), 2);
        for (std::size_t k = first + 1; k < end; ++k) left -= std::pow(dynamics_->component_force(k), 2);
        return left;
      };
    }
    event_contact_[events_.size()] = &contact;
    events_.push_back(std::move(event));
    event_action_.push_back(std::nullopt);
    event_limit_.push_back(nullptr);
  }
  return false;
}

namespace {

// Whether an event's value is zero where a way begins and has passed through it after that: a search for zeros does not
// see one from which it begins.
bool happens_from_start(const Event& event, const Trajectory& way) {
  constexpr double zero = 1e-9;      // of the size of the value
  constexpr int most_halvings = 20;  // of the way, from which the value is looked at
  const double start = way.start_time(), length = way.end_time() - start, none = zero * event.size;
  const auto value_at = [&](double time) {
    const State<double> there = way.state(time);
    return event.value(time, there.q, there.v);
  };
  if (std::abs(value_at(start)) > none) return false;
  for (int halvings = most_halvings; halvings > 0; --halvings)
    if (const double value = value_at(start + std::ldexp(length, -halvings)); std::abs(value) > none)
      return (value < 0) == (event.crossing == Crossing::falling);
  return false;
}

}  // namespace

std::optional<std::size_t> Course::Piece::beyond_limit_from_start(const Trajectory& way) {
  if (way.empty()) return std::nullopt;
  const auto found = std::ranges::find_if(event_contact_, [&](const auto& item) {
    return item.second->grip == Grip::sticks && happens_from_start(events_[item.first], way);
  });
  const bool any = found != event_contact_.end();
  // The looks have left loads that follow the time at other times.
  refresh(any ? way.start_time() : way.end_time());
  return any ? std::optional(found->first) : std::nullopt;
}

std::optional<std::size_t> Course::Piece::changes_from_start(const Trajectory& way) {
  if (way.empty()) return std::nullopt;
  // What rubs or may be struck is seen by its states and blows.
  const auto rubs = [&](std::size_t action) {
    return std::ranges::any_of(machine_.rough_contacts,
                               [&](const auto& contact) { return contact.action == static_cast<int>(action); });
  };
  for (std::size_t i = 0; i < events_.size(); ++i)
    if (const std::optional<std::size_t> action = event_action_[i];
        action && !rubs(*action) && (acting_[*action] || !motion_.later_contact(*action)) &&
        happens_from_start(events_[i], way)) {
      refresh(way.start_time());
      return action;
    }
  refresh(way.end_time());
  return std::nullopt;
}

std::vector<ContactState> Course::Piece::at_their_limits(std::size_t event) {
  std::vector<ContactState> starting;
  const RoughContactOf<double>* const come = event_contact_.at(event);
  if (come->grip != Grip::sticks) return starting;
  refresh(now_.time);
  accelerate(now_.q, now_.v, acceleration_);
  for (const RoughContactOf<double>& contact : machine_.rough_contacts) {
    if (contact.grip != Grip::sticks) continue;
    constexpr double at_limit = 1e-9;  // of the limit: the time of an event is known to 1e-12 of the pace and better
    if (contact.in_joint()) {
      limit_state_.set_positions(now_.q);
      const Vector3<double> friction = holding_friction(contact);
      if (&contact != come && norm(friction) < (1 - at_limit) * limit_in_joint(contact)) continue;
      const auto stated = std::ranges::find(motion_.situation_.contacts, contact.name, &Contact::name);
      const bool against = dot(friction, limit_state_.direction(contact.motions[1].along)) > 0;
      starting.push_back({contact.name, 0, Grip::slides,
                          contact.all_ways ? direction_expression(-1.0 * normalized(as_drawn(contact, friction)))
                                           : joint_direction(*stated, against),
                          true, true, false, contact.all_ways});
      continue;
    }
    if (contact.on_cord()) {
      limit_state_.set_positions(now_.q);
      const auto [before, behind] = tensions(contact);
      if (&contact != come &&
          std::abs(before - behind) < (1 - at_limit) * resting_of(limit_state_, contact) * (before + behind))
        continue;
      const auto stated = std::ranges::find(motion_.situation_.contacts, contact.name, &Contact::name);
      if (contact.of_belt)
        motion_.stops(
            stage_, stated->friction->mark,
            contact.name + " slips at " + with_digits(now_.time, 6) + " s: a belt that slips is not followed");
      starting.push_back({contact.name, 0, Grip::slides, joint_direction(*stated, before > behind), true, true});
      continue;
    }
    const std::size_t first = push_of(contact);
    const double limit = contact.resting * dynamics_->component_force(first);
    Vector3<double> friction{};
    for (std::size_t k = first + 1; k < end_of_components(machine_.mechanism, first); ++k)
      friction += dynamics_->component_force(k) * drawn_[k].along.vector;
    if (&contact != come && norm(friction) < (1 - at_limit) * limit) continue;
    starting.push_back({contact.name, 0, Grip::slides, direction_expression(-1.0 * normalized(friction)), true, false});
  }
  return starting;
}

bool Course::Piece::slip_has_ended() {
  accelerate(now_.q, now_.v, acceleration_);
  return std::ranges::any_of(machine_.rough_contacts, [&](const RoughContactOf<double>& contact) {
    if (contact.grip != Grip::slides) return false;
    const Vector3<double> u = slip(contact, now_.q, now_.v), d = direction_now(limit_state_, contact, *contact.slip);
    limit_state_.set_accelerations(acceleration_);
    return dot(u, d) <= (contact.turns ? slip_ends * motion_.tolerance_ : slip_is_none) * natural_slip(contact) &&
           dot(rough_motion(limit_state_, contact, true).slip, d) < 0;
  });
}

namespace {

constexpr int looks_at_lines = 4;  // in each step

}  // namespace

bool Course::Piece::is_off_its_line(const RoughContactOf<double>& contact, const State<double>& there) {
  const Vector3<double> u = slip(contact, there.q, there.v), d = direction_now(limit_state_, contact, *contact.slip);
  const double most = off_line * natural_slip(contact);
  return norm(cross(u, d)) > most || dot(u, d) < -most;
}

// At its limit a slip begins without acceleration, and with next to no slip there is no direction that could be
// followed: friction against it turns the faster the less it is. So what it leaves its line by is waited for.
std::optional<double> Course::Piece::leave_their_lines(const Trajectory& way,
                                                       const std::vector<std::string>& contacts) {
  std::vector<const RoughContactOf<double>*> turning;
  for (const RoughContactOf<double>& contact : machine_.rough_contacts)
    if (std::ranges::find(contacts, contact.name) != contacts.end()) turning.push_back(&contact);
  const State<double> start = way.state(way.start_time());
  for (const RoughContactOf<double>* contact : turning)
    if (norm(slip(*contact, start.q, start.v)) > off_line * natural_slip(*contact)) return std::nullopt;
  const auto any_off = [&](double time) {
    const State<double> there = way.state(time);
    return std::ranges::any_of(turning, [&](const auto* contact) { return is_off_its_line(*contact, there); });
  };
  double on = way.start_time(), off = way.end_time();
  bool left = false;
  for (std::size_t i = 0; i < way.step_count() && !left; ++i) {
    const StepView step = way.step(i);
    for (int k = 1; k <= looks_at_lines && !left; ++k) {
      const double time = step.start + (step.end - step.start) * k / looks_at_lines;
      left = any_off(time);
      (left ? off : on) = time;
    }
  }
  for (int halving = 0; halving < 50; ++halving) {
    const double middle = 0.5 * (on + off);
    (any_off(middle) ? off : on) = middle;
  }
  return on > way.start_time() ? std::optional(on) : std::nullopt;
}

std::vector<std::string> Course::Piece::off_their_lines(const Trajectory& way) {
  std::vector<std::string> names;
  if (!rubs()) return names;
  for (const RoughContactOf<double>& contact : machine_.rough_contacts) {
    if (contact.grip != Grip::slides || contact.turns || (contact.in_joint() && !contact.all_ways) ||
        contact.on_cord() || !(contact.sliding > 0))
      continue;
    bool off = false;
    for (std::size_t i = 0; i < way.step_count() && !off; ++i) {
      const StepView step = way.step(i);
      for (int k = 1; k <= looks_at_lines && !off; ++k)
        off = is_off_its_line(contact, way.state(step.start + (step.end - step.start) * k / looks_at_lines));
    }
    if (off) names.push_back(contact.name);
  }
  return names;
}

bool Course::Piece::rubs() const {
  return std::ranges::any_of(machine_.rough_contacts, [](const auto& contact) { return contact.grip == Grip::slides; });
}

double Course::Piece::rubbing_power(const State<double>& state) {
  if (!rubs()) return 0;
  accelerate(state.q, state.v, acceleration_);
  double power = power_of_joints(state);
  for (const RoughContactOf<double>& contact : machine_.rough_contacts) {
    // What friction in joints takes that is stated is counted with their drives.
    if (contact.grip != Grip::slides || contact.in_joint()) continue;
    if (contact.on_cord()) {
      const auto [before, behind] = tensions(contact);
      power -= std::abs(before - behind) * norm(slip(contact, state.q, state.v));
      continue;
    }
    const double N = dynamics_->component_force(push_of(contact));
    const Vector3<double> u = slip(contact, state.q, state.v);  // sets the pose of limit_state_
    power -= contact.sliding * N * dot(u, direction_now(limit_state_, contact, *contact.slip));
  }
  return power;
}

}  // namespace poinsot::problem
