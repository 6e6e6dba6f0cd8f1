// The events of contacts with dry friction within a piece of a motion: with the push N and the friction F on the body,
// a contact that slides along d ceases to where its slip comes to u . d = 0, and one at rest begins to where
// m0^2 N^2 - F^2 comes to zero.
#include <algorithm>
#include <cmath>

#include "poinsot/engine/solve/instant/closure.h"
#include "problem/course/motion_piece.h"
#include "problem/instant/contact_state_search.h"
#include "problem/language/diagnostic.h"
#include "problem/language/words.h"
#include "problem/quantities/rough_contact.h"

namespace poinsot::problem {

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

// Whether nothing moves or would move, and no load changes: then nothing will.
bool Course::Piece::stays_at_rest() {
  if (motion_.timed_ || !machine_.accelerations.empty()) return false;
  std::vector<double> v = now_.v, a(now_.v.size());
  dynamics_->project_velocities(now_.q, v);
  dynamics_->accelerations(now_.q, v, a);
  const std::vector<double> sizes = motion_.natural_sizes().of_v;
  constexpr double rounding = 1e-9;  // of the natural speed and acceleration
  for (std::size_t k = 0; k < v.size(); ++k) {
    const double rest = rounding * sizes[k] / motion_.pace_time_;
    if (std::abs(v[k]) > rest || std::abs(a[k]) > rest / motion_.pace_time_) return false;
  }
  return true;
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

void Course::Piece::add_friction() {
  if (machine_.rough_contacts.empty() || stays_at_rest()) return;
  const double force = motion_.start_->natural_size(dimensions::force);
  for (const RoughContactOf<double>& contact : machine_.rough_contacts) {
    Event event;
    event.crossing = Crossing::falling;
    event.terminal = true;
    const std::size_t first = push_of(contact);
    if (contact.grip == Grip::slides) {
      event.name = "slip vanishes";
      event.size = motion_.natural_speed();
      event.value = [this, &contact](double, std::span<const double> q, std::span<const double> v) {
        const Vector3<double> u = slip(contact, q, v);
        return dot(u, limit_state_.direction(*contact.slip));
      };
    } else {
      dynamics_->accelerations(now_.q, now_.v, acceleration_);
      for (std::size_t k = first; k < first + 3; ++k)
        if (!dynamics_->component_determined(k) && moves_anything(contact.motions[k - first])) {
          const auto stated = std::ranges::find(motion_.situation_.contacts, contact.name, &Contact::name);
          motion_.stops(stage_, stated->friction->mark,
                        "how contacts at rest share what they carry from " + with_digits(now_.time, 6) +
                            " s on is open, and so is when '" + contact.name + "' begins to slide");
        }
      event.name = "friction at its limit";
      event.size = force * force;
      event.value = [this, &contact, first](double time, std::span<const double> q, std::span<const double> v) {
        refresh(time);
        dynamics_->accelerations(q, v, acceleration_);
        const double N = dynamics_->component_force(first);
        return std::pow(contact.resting * N, 2) - std::pow(dynamics_->component_force(first + 1), 2) -
               std::pow(dynamics_->component_force(first + 2), 2);
      };
    }
    event_contact_[events_.size()] = &contact;
    events_.push_back(std::move(event));
    event_action_.push_back(std::nullopt);
    event_limit_.push_back(nullptr);
  }
}

std::vector<ContactState> Course::Piece::at_their_limits(std::size_t event) {
  std::vector<ContactState> starting;
  const RoughContactOf<double>* const come = event_contact_.at(event);
  if (come->grip != Grip::sticks) return starting;
  refresh(now_.time);
  dynamics_->accelerations(now_.q, now_.v, acceleration_);
  for (const RoughContactOf<double>& contact : machine_.rough_contacts) {
    if (contact.grip != Grip::sticks) continue;
    const std::size_t first = push_of(contact);
    const double limit = contact.resting * dynamics_->component_force(first);
    Vector3<double> friction{};
    for (std::size_t k = first + 1; k < first + 3; ++k)
      friction += dynamics_->component_force(k) * machine_.mechanism.components[k].along.vector;
    constexpr double at_limit = 1e-9;  // of the limit: the time of an event is known to 1e-12 of the pace and better
    if (&contact != come && norm(friction) < (1 - at_limit) * limit) continue;
    starting.push_back({contact.name, 0, Grip::slides, direction_expression(-1.0 * normalized(friction)), true});
  }
  return starting;
}

void Course::Piece::check_slips(const Trajectory& way) {
  if (!rubs()) return;
  constexpr int looks = 4;
  constexpr double rounding = 4e-8;  // of the natural speed
  const double speed = motion_.natural_speed();
  for (std::size_t i = 0; i < way.step_count(); ++i) {
    const StepView step = way.step(i);
    for (int k = 1; k <= looks; ++k) {
      const double time = step.start + (step.end - step.start) * k / looks;
      const State<double> there = way.state(time);
      for (const RoughContactOf<double>& contact : machine_.rough_contacts) {
        if (contact.grip != Grip::slides) continue;
        const Vector3<double> u = slip(contact, there.q, there.v), d = limit_state_.direction(*contact.slip);
        if (norm(cross(u, d)) <= rounding * speed && dot(u, d) >= -rounding * speed) continue;
        const auto stated = std::ranges::find(motion_.situation_.contacts, contact.name, &Contact::name);
        motion_.stops(stage_, stated->friction->mark,
                      "the direction in which contact '" + contact.name + "' slides turns from " +
                          with_digits(now_.time, 6) + " s on, and motions in which it does are not followed");
      }
    }
  }
}

bool Course::Piece::rubs() const {
  return std::ranges::any_of(machine_.rough_contacts, [](const auto& contact) { return contact.grip == Grip::slides; });
}

double Course::Piece::rubbing_power(const State<double>& state) {
  if (!rubs()) return 0;
  dynamics_->accelerations(state.q, state.v, acceleration_);
  double power = 0;
  for (const RoughContactOf<double>& contact : machine_.rough_contacts) {
    if (contact.grip != Grip::slides) continue;
    const double N = dynamics_->component_force(push_of(contact));
    const Vector3<double> u = slip(contact, state.q, state.v);
    power -= contact.sliding * N * dot(u, limit_state_.direction(*contact.slip));
  }
  return power;
}

}  // namespace poinsot::problem
