// One situation with values, solved at an instant.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "poinsot/engine/solve/instant/equations.h"
#include "poinsot/engine/solve/instant/particle_check.h"
#include "problem/instant/friction_shares.h"
#include "problem/instant/instant_conditions.h"
#include "problem/instant/rough_blow.h"
#include "problem/quantities/possible_slips.h"
#include "problem/quantities/quantities.h"
#include "problem/quantities/rough_contact.h"

namespace poinsot::solve {
struct ContactRate;
}

namespace poinsot::problem {

// How to choose what a statement leaves open. An answer is determined if it is the same for every choice.
struct OpenChoice {
  std::uint64_t seed = 0;     // of the random choices
  bool any = false;           // values given as `any`
  double gravity = 0;         // the size of gravity, m/s^2, if nothing is said of it and it is to be varied; else 0
  bool velocities = false;    // whether to vary velocities that nothing determines
  bool forces = false;        // the same for accelerations, forces and impulses
  std::size_t direction = 0;  // the index of the open direction that is varied, or `every`

  static constexpr std::size_t every = static_cast<std::size_t>(-1);
  bool trial = false;      // whether unknowns have trial values, so that what does not hold is a misfit and no error
  bool particles = false;  // whether it is checked with particles in a trial too
  // In a trial, which of the cords and one-sided contacts give way in a blow, a bit each in the order of the machine.
  std::size_t giving_way = 0;
  std::optional<solve::Scales> scales = {};  // units of misfits; those natural to the machine if left out
  std::size_t most_changes = 500;            // of contacts and cords that hold, until a motion is given up
};

// The instant: the start of a stage (or the only instant), or the instant just after a blow.
struct When {
  std::size_t stage = 0;
  bool after_blow = false;
};

// Whether loads or given motions depend on the time.
bool follows_time(const Situation& situation);
// Whether a coordinate turns a body about a line on which all of its mass lies. The second function lists all such
// coordinates.
bool turns_nothing(const Machine& machine, int coordinate);
// Whether the motion leads to an instant: it is given by a time or by a condition.
bool is_later(const Situation& situation, const Instant& instant);

// The instants stated for the start: that of the only state, of the first stage, or before a blow. Throws
// StatementError.
std::vector<const Instant*> instants_at_start(const Situation& situation);

// A state that a motion has reached.
struct MotionState {
  double time = 0;  // s
  std::size_t stage = 0;
  std::vector<double> q, v;
  std::vector<bool> acting;  // for each action whether it acts (a slack cord does not); if empty, all do
  double off_line = 0;       // m/s: how fast contacts may slip across the lines that the motion takes for their slips
};

// How far a stated number is from what is found, and the size of what is found, at least one; in natural units.
struct FactMisfit {
  double value = 0, size = 1;
  double found = 0, stated = 0;  // both sides, SI
  Dimension dimension{};
};

class ShakenInstant;
// A bound on the largest eigenvalue of a matrix without negative elements: of how much the frictions of joints change
// what presses in them there is one solution where it is below one.
double bound_on_eigenvalues(const std::vector<std::vector<double>>& a);

class SolvedInstant {
 public:
  // Situation and settings must outlive the object. Throws StatementError.
  SolvedInstant(const Situation& situation, const Settings& settings, const When& when, const OpenChoice& choice);
  SolvedInstant(const Situation& situation, const Settings& settings, const MotionState& state,
                const OpenChoice& choice);

  // The state along a motion, and the way to move to another one in the same situation.
  MotionState state() const { return {time_, 0, machine_.q, v_, {}}; }
  void move_to(const MotionState& state);
  // The machine at a time with the loads of a stage (with all loads if these are left out).
  Machine machine_at(double time, const std::optional<std::vector<std::string>>& loads);
  // The blow at contacts that meet along a motion, as instants before and after it; the state must be the one with all
  // contacts. acting: what may take part besides; touching: what touches or pulls before, and of which what takes no
  // part must part. Restitution is Newton's where several meet and where there is no friction.
  struct Met {
    std::size_t action = 0;  // among those of the mechanism
    double restitution = 0;
    std::optional<double> friction{};
  };
  void strike_later(const std::vector<Met>& met, const std::vector<bool>& acting, const std::vector<bool>& touching,
                    const Mark& mark);
  // The velocities just after cords and contacts have caught, without rebound. acting: those that act then.
  std::vector<double> caught(const std::vector<bool>& acting);
  double data_number(const Expression& expression, const Dimension& dimension) {
    return data_->number(expression, dimension);
  }
  // Whether it uses values that are given as `any`.
  bool uses_any() const { return !any_values_.empty(); }
  // The largest rate with which something moves or would begin to move, 1/s.
  double pace() const { return natural_size(dimensions::none / dimensions::time); }
  // The way on which the fastest body changes its velocity by as much as that is, v^2/a, and whether it slows down.
  // Needs the accelerations; nothing where nothing moves, or is pushed.
  struct WayOfChange {
    double length = 0;  // m
    bool slows = false;
  };
  std::optional<WayOfChange> way_of_change() const;

  // Solves for accelerations and forces. Quantities that need them call this themselves.
  void solve_forces();
  bool forces_solved() const { return motion_.has_value(); }
  // Assembles the equations for these, and solves them only if there are facts about them that are not linear.
  void assemble_forces();

  // Evaluates what stands before an `@`, at another instant.
  using Elsewhere = std::function<Value<double>(const At& at, const Mark& mark)>;
  // The value of an ask on the given axes, or on ground axes if none are given; vectors have components on these
  // axes. `features` are the values of extremes and periods over the motion that stand in the expression.
  Value<double> ask(const Expression& expression, const std::optional<Expression>& axes, const Elsewhere& elsewhere,
                    const MotionFeatureValues& features = {});
  // The same, but vectors are on ground axes.
  Value<double> raw(const Expression& expression, const std::optional<Expression>& axes, const Elsewhere& elsewhere,
                    const MotionFeatureValues& features = {});
  // The value of an expression that is a number, in SI units.
  double number(const Expression& expression, const std::optional<Expression>& axes);
  // How far the facts fail to hold here.
  std::vector<FactMisfit> fact_misfits(const std::vector<const Fact*>& facts, const MotionFeatureValues& features = {});
  // The natural size of a quantity of this dimension here.
  double natural_size(const Dimension& dimension) const;
  // Of the natural size of couples and moments of inertia: the part that counts for bodies on their way round a center
  // that pulls; 1 for all else.
  double part_of_turning(const Dimension& dimension) const;

  // Goes from the state just before the blow to the one just after it.
  void strike() { solve_blow(); }
  bool after_blow() const { return before_.has_value(); }
  const std::vector<double>& velocities_before() const { return before_->state().v; }  // the blow
  const solve::LinearSolution& blow() const { return blow_solution_; }
  const solve::Blow& struck() const { return blow_; }
  const std::optional<RoughBlow>& rough_blow() const { return rough_blow_; }
  const std::vector<int>& blow_flanks() const { return blow_flanks_; }   // of each component, in the blow
  const std::vector<bool>& blow_acting() const { return blow_acting_; }  // of each action, in the blow
  const solve::LinearSystem& blow_equations() const { return blow_equations_; }
  const solve::LinearSolution& velocities() const { return velocities_; }
  const solve::LinearSystem& velocity_equations() const { return velocity_equations_; }
  const solve::LinearSolution& motion() const { return *motion_; }
  const solve::LinearSystem& motion_equations() const { return motion_equations_; }
  const Machine& machine() const { return machine_; }

  // For trial values, how far the equations fail to hold, in natural units.
  const std::vector<double>& misfits() const { return misfits_; }
  // The number of misfits at the beginning that belong to facts about positions.
  std::size_t position_misfits() const { return position_misfits_; }
  const std::vector<ConditionSource>& position_sources() const { return position_sources_; }  // what states each
  const solve::Scales& scales() const { return scales_; }
  double misfit_size() const { return misfit_size_; }  // the size of the largest term in these equations
  // What is left of facts that are not linear if the unknowns of a system have these values.
  using System = InstantSystem;
  struct NonlinearMisfit {
    ConditionSource source;
    double value = 0, size = 0;  // in natural units; the size is that of the sides
  };
  std::vector<NonlinearMisfit> nonlinear_misfits(System system, const std::vector<double>& unknowns) const;
  const solve::LinearSystem& equations_of(System system) const;
  // What states an equation of a system; no instant for those that nothing under instants: or facts: states.
  ConditionSource source_of(System system, std::size_t equation) const;

  // A cord that would have to push, a contact that would have to pull, or one with friction that does not stay in its
  // state.
  struct OneSidedFault {
    std::size_t action = 0;  // its place among the actions of the mechanism
    Holding broken = Holding::presses;
  };
  // All of them. solve_forces() must be called before. off_line: how fast what slides may slip across the line that is
  // taken for it (m/s).
  std::vector<OneSidedFault> one_sided_faults(double off_line = 0) const;
  // Describes them: "the cord 'AB' would have to push: it goes slack".
  std::vector<std::string> unphysical(double off_line = 0) const;

  // Of a contact with friction, by its place among those of the machine and on the axes of the figure as drawn: its
  // normal, and how it comes apart and slips, by the velocities or (after solve_forces()) by the accelerations.
  Vector3<double> rough_normal(std::size_t contact) const;
  RoughMotion<double> rough_motion_as_drawn(std::size_t contact, bool accelerations) const;
  // Which states of them the bodies allow together, where nothing moves.
  PossibleSlips possible_slips() const { return PossibleSlips(*mechanism_state_, machine_.rough_contacts); }
  // The least m N - |F| of all that sticks, beside the larger of both: below zero where something slips. Of joints and
  // cords too, unlike sticking_margin(), which polishes ends to the last digits beside the largest force. Forces must
  // be solved; nothing where nothing sticks.
  std::optional<double> least_margin_at_rest() const;

  // Where contacts and cords share a load: the least and the largest value of a number, or of each component of a
  // vector, over all shares in which none pulls or pushes the wrong way; infinite where nothing bounds it. Nothing if
  // that is not all that is open, or if the value is not linear in the forces.
  struct Between {
    double least = 0, largest = 0;
  };
  std::optional<std::vector<Between>> over_all_shares(const Expression& expression,
                                                      const std::optional<Expression>& axes);

  // From now on it is written down what is told of bodies and forces; and by how much that differs from what the bodies
  // as particles tell, relative to the size of its terms, with the function that differs most.
  void write_down_what_is_told() { writes_told_ = true; }
  struct ToldMisfit {
    double misfit = 0;
    std::string function{};
    int checked = 0;  // the number of values for which there is a second road
  };
  ToldMisfit misfit_of_told() const;

  // The linearised equations near this motion, which must be steady. Errors are reported at the mark.
  const solve::Linearisation& linearisation(const Mark& mark, bool with_shapes = false);

  // The amplitude and the phase of response(X to F), of a vector those of each component on the axes of an ask. The
  // motion must be steady and may not be unstable.
  Value<double> response(const Call& call, const Mark& mark, const std::optional<Expression>& axes);

  // Compares the solution with one for particles; forces are included if they are solved.
  struct Residuals {
    solve::CheckResult particles;
    double impulse = 0;                   // momenta before + impulses - momenta after (Eq. 17.4), relative
    std::optional<double> constraints{};  // if there are any: by how much they are open or come apart, relative
    // If rates were told and a second road to them is known: how far from these they are, as a part of the pace.
    std::optional<double> stability{};
    // If responses were told: how far they are from those of a second road, relative.
    std::optional<double> response{};
    // If contacts have friction and forces are solved: how far its laws are from being fulfilled, relative.
    std::optional<double> friction{};
    // After a blow with friction: how far the impulses are from those of a second road, relative.
    std::optional<double> blow{};
    // If there are loads, springs, motors or slanted teeth and forces are solved: how far these are from what is
    // stated, relative.
    std::optional<double> laws{};
  };
  Residuals check() const;

  // The forces or impulses of cords and one-sided contacts among unknowns in which those of components begin at
  // `first`.
  std::vector<std::size_t> one_sided_unknowns(std::size_t first) const;
  // The same for the contacts that stick.
  std::vector<FrictionCone> friction_cones(std::size_t first) const;

 private:
  friend class VariedInstant;
  friend class ShakenInstant;
  void build(double time, const std::optional<std::vector<std::string>>& loads);
  Machine machine_from(DataScope<double>& data, double time, const std::optional<std::vector<std::string>>& loads);
  MachineOptions machine_options(double time, const std::optional<std::vector<std::string>>& loads) const;
  void refuse_misnamed_positions(const std::vector<const Instant*>& instants) const;
  void set_positions(const std::vector<const Instant*>& instants);
  void solve_velocities(const std::vector<const Instant*>& instants, const std::optional<std::vector<double>>& v);
  void position_facts(const std::vector<const Instant*>& instants);
  InstantView<double> view() const;
  ConditionSource source_of(const Fact& fact) const;
  std::vector<const Fact*> state_motion_equations();  // returns the facts that are not linear
  void solve_motion_equations(const std::vector<const Fact*>& nonlinear);
  // Finds which flanks of teeth carry, and leaves the motion equations stated so.
  void find_flanks(const std::vector<solve::Condition>& conditions);
  // Ties flanks of teeth to the forces that turn the wheels, as far as these are determined.
  solve::LinearSolution tie_motion(const std::vector<solve::Condition>& conditions);
  // Finds how what presses in joints points whose friction follows from it, and assembles the equations with that.
  void assemble_motion_equations();
  void find_pressing();
  void require_known_pressing(const solve::LinearSolution& solution) const;
  void refuse_several_frictions(const std::vector<RoughContactOf<double>*>& moving);
  // Checks that facts which are not linear hold for the solution.
  void hold_nonlinear(System system, const std::vector<const Fact*>& facts, const solve::LinearSolution& solution);
  struct FactSides {
    std::vector<Difference<double>> differences;
    double size = 0;  // the size of the larger side
  };
  FactSides sides_of(const Fact& fact, System system, const std::vector<double>& unknowns) const;
  // This motion as a steady one, told of a mechanism that must outlive it.
  solve::SteadyMotion steady_motion(const Mark& mark, Mechanism<double>& mechanism) const;
  void release(const std::vector<bool>& acting);
  void turn_slips();
  double misfit_in_joint(const RoughContactOf<double>& contact) const;
  double misfit_in_all_ways(const RoughContactOf<double>& contact, const Joint& joint, const Friction& stated) const;
  double misfit_on_cord(const RoughContactOf<double>& contact, double slip, double slip_rate, double force_size) const;
  std::vector<VelocityConstraint<double>> ways_of_contacts() const;
  Vector3<double> slip_of(const solve::ContactRate* way, int from, bool change) const;
  // Of the friction in a joint, along or about its axis in the sense of its freedom and in the other.
  struct LimitsOfFriction {
    double forward = 0, backward = 0;
  };
  LimitsOfFriction limits_in_bearing(const RoughContactOf<double>& contact, const Joint& joint,
                                     double coefficient) const;
  double friction_misfit() const;
  double rough_blow_misfit() const;
  double blow_friction_misfit() const;
  std::optional<double> law_misfit() const;
  double belt_misfit() const;
  std::optional<double> tooth_misfit() const;
  void solve_blow();
  std::mt19937_64& random();
  void take_misfits(const solve::LinearSolution& solution);
  void move_along(const solve::LinearSolution& solution, std::vector<double>& values, double pace = 1);
  double natural_unit(const Dimension& dimension) const { return problem::natural_unit(scales_, dimension); }
  [[noreturn]] void contradiction(System system, const solve::LinearSolution& solution);
  QuantityScope<double> scope_for(const Expression& expression, const std::optional<Expression>& axes,
                                  const Elsewhere& elsewhere, const MotionFeatureValues& features);

  const Situation& situation_;
  const Settings& settings_;
  OpenChoice choice_;
  std::unique_ptr<std::mt19937_64> random_;  // large and rarely needed
  std::vector<double> any_values_;           // values chosen so far, which are the same each time the machine is built
  std::unique_ptr<DataScope<double>> data_;
  std::unique_ptr<DataScope<double>> elsewhen_;            // for the machine at other times
  std::optional<std::vector<BodyMassOf<double>>> masses_;  // once they are found, unless they depend on the time
  std::size_t any_in_masses_ = 0;                          // the number of any_values_ that belong to masses
  Machine machine_;
  solve::Scales scales_;
  std::optional<solve::MechanismState> mechanism_state_;
  double time_ = 0;
  std::optional<bool> timed_;  // whether the machine depends on the time
  bool whole_ = false;         // whether contacts are there that do not touch at the start
  bool moving_ = false;        // whether it moves along a motion, so that nothing is stated about this instant
  std::optional<std::size_t> built_stage_;  // the stage of a motion for which the machine is built
  std::vector<bool> built_acting_;
  std::vector<const Instant*> facts_;
  std::vector<double> v_;
  solve::LinearSystem velocity_equations_, motion_equations_;
  solve::LinearSolution velocities_;
  std::optional<solve::LinearSolution> motion_;
  std::vector<double> unknowns_;
  std::optional<solve::Linearisation> linearisation_;
  std::vector<std::shared_ptr<ShakenInstant>> shaken_;  // each for one excitation
  std::optional<double> response_misfit_;
  std::vector<double> misfits_;
  std::size_t position_misfits_ = 0;
  std::vector<ConditionSource> position_sources_;
  double misfit_size_ = 0;
  std::map<System, std::vector<const Fact*>> nonlinear_;
  std::map<System, std::vector<ConditionSource>> sources_;  // of the conditions among the equations of each system
  // If this is the instant after a blow: the state before it, and the velocities after it with all impulses.
  std::optional<solve::MechanismState> before_;
  solve::Blow blow_;
  std::optional<RoughBlow> rough_blow_;  // if it is one with friction
  std::vector<bool> blow_acting_;        // for each action
  std::vector<int> blow_flanks_;         // for each component, which flanks of teeth carry
  solve::LinearSystem blow_equations_;
  solve::LinearSolution blow_solution_;
  std::vector<double> impulses_;
  bool writes_told_ = false;
  std::vector<ToldQuantity> told_;
};

}  // namespace poinsot::problem
