// A piece of a motion, with its equations and events: from one change of what holds to the next.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "poinsot/engine/motion/integrator/integrate.h"
#include "poinsot/engine/motion/mechanism/lone_body.h"
#include "poinsot/engine/motion/mechanism/mechanism_dynamics.h"
#include "problem/course/course.h"
#include "problem/course/lost_contact.h"
#include "problem/instant/massless_turning.h"
#include "problem/machine/contact_limits.h"
#include "problem/machine/driving.h"

namespace poinsot::problem {

// The equations and events of a motion in which the same cords and contacts hold.
class Course::Piece {
 public:
  static constexpr std::int64_t most_steps = 400'000;  // that it is followed

  // span: in which what drives is smooth.
  Piece(Course& motion, std::size_t stage, const Driving::Span& span);
  Piece(const Piece&) = delete;
  Piece& operator=(const Piece&) = delete;

  // The event that ends the stage. False if the motion stands at it already.
  bool add_ending(const Expression& condition);
  // The events of all that may give way or catch. The action of one that would have to pull or push the wrong way
  // from the start on, and does not act at all.
  std::optional<std::size_t> add_holds();
  // seconds: of real time.
  IntegrationResult follow(double end, double seconds);
  // The action that an event gives way to or catches; none if it ends the stage.
  std::optional<std::size_t> action_of(std::size_t event) const { return event_action_[event]; }

  // The contact that comes to the end of its surface by an event, or stands there and goes on beyond it.
  const ContactLimit* end_of_surface(std::size_t event) const { return event_limit_[event]; }
  const ContactLimit* beyond_surface() const;
  // Throws UnansweredError if a straight side turns out of the plane that it touches, on the way or at the start.
  void check_sides(const Trajectory* way) const;

  bool would_press_in(std::size_t action) {
    return problem::would_press_in(*dynamics_, action, now_.q, now_.v, motion_.pace_time_);
  }
  double kinetic_energy(std::span<const double> q, std::span<const double> v) {
    return dynamics_->kinetic_energy(q, v);
  }
  std::vector<bool>& acting() { return acting_; }
  const Machine& machine() const { return machine_; }

 private:
  void set_up_dynamics();
  void set_given_motion();
  void set_up_equations();
  void refresh(double time);
  void add_ends_of_surfaces();
  double inside(double time) const;
  Event slack(std::size_t component);
  std::optional<Event> taut(const Component<double>& component);

  Course& motion_;
  const std::size_t stage_;
  const Driving::Span span_;
  StageRun& now_;
  std::optional<std::vector<std::string>> loads_;
  Machine machine_;
  solve::MechanismState limit_moment_;
  std::vector<bool> acting_;
  std::optional<MechanismDynamics> dynamics_;
  std::vector<MasslessSpin> spins_;
  std::optional<LoneBody> lone_;
  MotionEquations equations_;
  std::vector<Event> events_;
  std::vector<std::optional<std::size_t>> event_action_;
  std::vector<const ContactLimit*> event_limit_;
  std::vector<double> acceleration_;
  double compared_size_ = 0;  // of what the event that ends the stage compares
};

}  // namespace poinsot::problem
