// A piece of a motion, with its equations and events, from one change of contacts and cords to the next.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "poinsot/engine/motion/integrator/integrate.h"
#include "poinsot/engine/motion/mechanism/lone_body.h"
#include "poinsot/engine/motion/mechanism/mechanism_dynamics.h"
#include "poinsot/engine/work/work.h"
#include "problem/course/course.h"
#include "problem/course/driving.h"
#include "problem/course/lost_contact.h"
#include "problem/instant/massless_turning.h"
#include "problem/machine/contact_limits.h"

namespace poinsot::problem {

// Of the natural speed: a slip that leaves its line by less stays on it. What integration leaves across a line is some
// hundred times less (1e-12 a step, over hundreds of steps, magnified by levers); a slip that does turn is seen a
// little later than it begins to, and what it is off until then is far below the last digit told of a motion.
inline constexpr double off_line = 4e-8;

// The equations and events of a motion while the same cords and contacts act.
class Course::Piece {
 public:
  static constexpr std::int64_t most_steps = 400'000;  // after which a motion is given up

  // span: in which loads and given motions are smooth.
  Piece(Course& motion, std::size_t stage, const Driving::Span& span);
  Piece(const Piece&) = delete;
  Piece& operator=(const Piece&) = delete;

  // Adds the event that ends the stage. Returns false if the motion has reached it already.
  bool add_ending(const Expression& condition);
  // Adds the events at which cords and contacts give way or catch. Returns the action of one that would pull or push
  // the wrong way from the start and therefore does not act; nothing if there is none.
  std::optional<std::size_t> add_holds();
  // most: of work.
  IntegrationResult follow(double end, Work most);
  // The cord or contact that gives way or catches at an event; nothing if the event ends the stage.
  std::optional<std::size_t> action_of(std::size_t event) const { return event_action_[event]; }

  // The contact that reaches the end of its surface at an event; the contact that is there already and moves beyond
  // it.
  const ContactLimit* end_of_surface(std::size_t event) const { return event_limit_[event]; }
  const ContactLimit* beyond_surface() const;
  // The cord whose end comes to a wheel at an event; nothing if none does.
  std::optional<std::size_t> end_of_cord(std::size_t event) const {
    const auto found = event_cord_.find(event);
    return found == event_cord_.end() ? std::nullopt : std::optional(found->second);
  }
  // Adds the events at which contacts with friction cease to slide or come to the limit of what they hold at rest.
  // Returns whether there are none as friction holds all that could move.
  bool add_friction();
  bool stays_at_rest();
  // Whether a contact with friction ceases to slide or comes to its limit at an event; if it comes to that, all
  // contacts that do then, with the directions in which they begin to slide.
  bool is_of_friction(std::size_t event) const { return event_contact_.contains(event); }
  std::vector<ContactState> at_their_limits(std::size_t event);
  // Whether contacts at rest share what they carry, so that the friction of one by itself says nothing; when on the way
  // no share keeps all of them at rest any more, and where the motion would be a little later. Nothing if one always
  // does.
  bool shares() const { return shares_; }
  struct GivingWay {
    double time = 0, later = 0;
    State<double> there;  // later
  };
  std::optional<GivingWay> shares_give_way(const Trajectory& way);
  // Finds the states from then on, at the end of the piece.
  void let_shares_give_way(GivingWay giving);
  // The event of a contact that is at its limit where the piece begins and goes beyond it on the way; nothing if none
  // is.
  std::optional<std::size_t> beyond_limit_from_start(const Trajectory& way);
  // The cord or contact that is just about to give way or to catch where the piece begins, and would have to on the
  // way; nothing if there is none.
  std::optional<std::size_t> changes_from_start(const Trajectory& way);
  // Whether a slip vanishes where the piece begins: the motion was followed so far before, and no further.
  bool slip_has_ended();
  // The contacts that slide otherwise than along the line that was taken for them on the way.
  std::vector<std::string> off_their_lines(const Trajectory& way);
  // When those that begin to slide leave their lines; nothing if they slide from the start of the way.
  std::optional<double> leave_their_lines(const Trajectory& way, const std::vector<std::string>& contacts);
  bool is_off_its_line(const RoughContactOf<double>& contact, const State<double>& there);
  // Whether contacts slide with friction, and the power that they take.
  bool rubs() const;
  double rubbing_power(const State<double>& state);
  // Throws UnansweredError if a straight side turns out of the plane that it touches, at the start or on the way.
  void check_sides(const Trajectory* way) const;
  // Throws UnansweredError if a torsional spring is wound by more than half a turn on the way.
  void check_winding(const Trajectory& way) const;
  // Throws UnansweredError if a center that pulls comes within a body.
  void check_nearness(const Trajectory& way) const;

  // Contacts that meet later (later_blows.cpp): those that do here; the rate of the gap of one, the acceleration with
  // which it opens and the kinetic energy, with these velocities; to what its gap is known. Throws StatementError if
  // one that is open at the start is none.
  std::vector<std::size_t> meeting(std::optional<std::size_t> at_event);
  double gap_rate(std::size_t action, std::span<const double> v);
  // The contacts and cords that would catch where another one does, one action for each.
  std::vector<std::size_t> catching_beside(std::size_t action);
  double opening(std::size_t action, std::span<const double> v);
  double kinetic_energy(std::span<const double> v);
  double rounding_of_gap(std::size_t action);
  void check_open();

  bool would_press_in(std::size_t action) {
    return problem::would_press_in(*dynamics_, action, now_.q, now_.v, motion_.start_->scales().length,
                                   motion_.pace_time_);
  }
  // The contacts with friction that touch (flying_contacts.cpp).
  std::vector<std::size_t> rubbing() const;
  // Looked for at some steps of the way, its ends among them.
  double largest_kinetic_energy(const Trajectory& way);
  std::vector<bool>& acting() { return acting_; }
  // What acts, as it did on the way, whatever has changed behind it.
  void let_act(const std::vector<bool>& acting) {
    acting_ = acting;
    set_given_motion();
  }
  const Machine& machine() const { return machine_; }

 private:
  std::optional<std::size_t> normal_of(std::size_t action) const;
  void set_up_dynamics();
  void set_given_motion();
  void set_up_equations();
  void refresh(double time);
  std::optional<std::size_t> add_belts();
  void add_ends_of_surfaces();
  void add_ends_of_cords();
  double inside(double time) const;
  Event slack(std::size_t component);
  std::pair<double, double> tensions(const RoughContactOf<double>& contact) const;
  Vector3<double> slip(const RoughContactOf<double>& contact, std::span<const double> q, std::span<const double> v);
  std::size_t push_of(const RoughContactOf<double>& contact) const;
  Vector3<double> as_drawn(const RoughContactOf<double>& contact, const Vector3<double>& vector) const;
  double natural_slip(const RoughContactOf<double>& contact) const;
  Vector3<double> holding_friction(const RoughContactOf<double>& contact) const;
  void accelerate(std::span<const double> q, std::span<const double> v, std::span<double> a);
  bool moves_anything(const VelocityConstraint<double>& way);
  [[noreturn]] void refuse_shares(const std::string& contact) const;
  std::optional<double> margin_of_shares(double time, const State<double>& there);
  std::optional<Event> taut(const Component<double>& component);
  // Friction in joints that is found with the reactions (piece_joints.cpp).
  struct JointLoad {
    const RoughContactOf<double>* contact = nullptr;
    std::vector<bool> beyond{};             // of each body of the tree: whether the joint carries it
    std::vector<std::size_t> components{};  // of the joint and its supports
    double friction = 0;                    // along its slip, while it moves
  };
  void set_up_joint_friction();
  void check_joint_loads();
  [[noreturn]] void refuse_load(const RoughContactOf<double>& contact, const std::string& why,
                                const std::string& hint) const;
  // How much each component of a joint carries of what the bodies beyond it need; empty where statics does not tell.
  std::vector<double> shares_of(const JointLoad& load, const SpatialForce<double>& needed) const;
  std::vector<Vector3<double>> pressing_at(const JointLoad& load) const;
  double effort_of(const JointLoad& load, const RubbingWay<double>& way) const;
  double limit_in_joint(const RoughContactOf<double>& contact);
  double pressing_now(const RoughContactOf<double>& contact, std::span<const double> a);
  void accelerate_with_joints(std::span<const double> q, std::span<const double> v, std::span<double> a);
  double power_of_joints(const State<double>& state) const;

  Course& motion_;
  const std::size_t stage_;
  const Driving::Span span_;
  StageRun& now_;
  std::optional<std::vector<std::string>> loads_;
  Machine machine_;
  const std::vector<Component<double>> drawn_;  // before contacts move
  solve::MechanismState limit_state_;
  std::vector<bool> acting_;
  std::optional<MechanismDynamics> dynamics_;
  std::vector<MasslessSpin> spins_;
  bool still_ = false;  // whether all that moves is rounding, of what friction holds
  std::optional<LoneBody> lone_;
  MotionEquations equations_;
  std::vector<Event> events_;
  std::vector<std::optional<std::size_t>> event_action_;
  std::vector<const ContactLimit*> event_limit_;
  std::map<std::size_t, const RoughContactOf<double>*> event_contact_;
  std::map<std::size_t, std::size_t> event_cord_;
  std::vector<double> acceleration_;
  bool slips_turn_ = false;
  bool shares_ = false;
  std::vector<JointLoad> loads_on_joints_;
  double compared_size_ = 0;  // of the numbers that the ending event compares
};

}  // namespace poinsot::problem
