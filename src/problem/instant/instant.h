// One situation of a statement, with values, solved at an instant.
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
#include "problem/instant/instant_conditions.h"
#include "problem/quantities/quantities.h"

namespace poinsot::problem {

// How to choose what a statement leaves open. An answer is determined when no choice changes it.
struct OpenChoice {
  std::uint64_t seed = 0;     // of the random choices
  bool any = false;           // values given as `any`
  bool gravity = false;       // gravity, where nothing is said of it
  bool velocities = false;    // velocities that nothing fixes
  bool forces = false;        // accelerations and forces that nothing fixes; impulses at a blow
  std::size_t direction = 0;  // which of the open directions of these, or `every`

  static constexpr std::size_t every = static_cast<std::size_t>(-1);
  bool trial = false;                        // unknowns have trial values: what does not hold is a misfit, not an error
  std::optional<solve::Scales> scales = {};  // units of misfits; those natural to the machine when left out
  std::size_t most_changes = 500;            // of what holds, until a motion is given up
};

// Where in time: the only instant or the start of the first stage, or just after a blow.
struct When {
  std::size_t stage = 0;
  bool after_blow = false;
};

// Whether loads or given motions follow the time.
bool follows_time(const Situation& situation);
// Whether a coordinate turns a body about a line on which all its mass lies; all such coordinates.
bool turns_nothing(const Machine& machine, int coordinate);
std::vector<int> still_coordinates(const Machine& machine);
// Whether an instant is reached by the motion: a time, or found by a condition.
bool is_later(const Situation& situation, const Instant& instant);

// What is known at the start: of the only instant, of the first stage, or before a blow. Throws StatementError.
std::vector<const Instant*> instants_at_start(const Situation& situation);

// A state that a motion has reached.
struct MotionState {
  double time = 0;  // s
  std::size_t stage = 0;
  std::vector<double> q, v;
  std::vector<bool> acting;  // of each action, whether it acts (a slack cord does not); empty: all do
};

class SolvedInstant {
 public:
  // problem and settings must outlive it. Throws StatementError.
  SolvedInstant(const Situation& situation, const Settings& settings, const When& when, const OpenChoice& choice);
  SolvedInstant(const Situation& situation, const Settings& settings, const MotionState& state,
                const OpenChoice& choice);

  // Along a motion: the state now, and the same problem in another state.
  MotionState state() const { return {time_, 0, machine_.q, v_, {}}; }
  void move_to(const MotionState& state);
  // The machine with the loads of a stage (all of them when left out) at a time.
  Machine machine_at(double time, const std::optional<std::vector<std::string>>& loads);
  // Velocities just after cords and contacts have caught, without rebound; those that act.
  std::vector<double> caught(const std::vector<bool>& acting);
  double data_number(const Expression& expression, const Dimension& dimension) {
    return data_->number(expression, dimension);
  }
  // Whether it has values that are given as `any`.
  bool uses_any() const { return !any_values_.empty(); }
  // The largest rate at which anything moves or would move, 1/s.
  double pace() const;

  // Solves for accelerations and forces; done by itself when a quantity needs them.
  void solve_forces();
  bool forces_solved() const { return motion_.has_value(); }
  // Only assembles the equations for these; solves them where facts are stated of them that are not linear.
  void assemble_forces();

  // What stands before an `@`, at another instant.
  using Elsewhere = std::function<Value<double>(const At& at, const Mark& mark)>;
  // The value of an ask on the given axes (ground axes where none are stated); vectors have components on these axes.
  Value<double> ask(const Expression& expression, const std::optional<Expression>& axes, const Elsewhere& elsewhere);
  // The same with vectors on ground axes.
  Value<double> raw(const Expression& expression, const std::optional<Expression>& axes, const Elsewhere& elsewhere);
  // The number that an expression is, in SI.
  double number(const Expression& expression, const std::optional<Expression>& axes);
  // By how much facts fail to hold here, in natural units.
  std::vector<double> fact_misfits(const std::vector<const Fact*>& facts);
  // What extremes and periods over the motion are, for expressions that ask for them.
  using Feature =
      std::function<Value<double>(const Call& call, const std::optional<Expression>& axes, const Mark& mark)>;
  void set_motion(Feature feature) { feature_ = std::move(feature); }
  // The size that a quantity of this dimension naturally has here.
  double natural_size(const Dimension& dimension) const;

  // From the state just before the blow to just after it.
  void strike() { solve_blow(); }
  bool after_blow() const { return before_.has_value(); }
  const solve::LinearSolution& blow() const { return blow_solution_; }
  const std::vector<bool>& blow_acting() const { return blow_acting_; }  // of each action, in the blow
  const solve::LinearSystem& blow_equations() const { return blow_equations_; }
  const solve::LinearSolution& velocities() const { return velocities_; }
  const solve::LinearSystem& velocity_equations() const { return velocity_equations_; }
  const solve::LinearSolution& motion() const { return *motion_; }
  const solve::LinearSystem& motion_equations() const { return motion_equations_; }
  const Machine& machine() const { return machine_; }

  // In a trial: by how much the equations fail to hold, in natural units.
  const std::vector<double>& misfits() const { return misfits_; }
  std::size_t position_misfits() const { return position_misfits_; }  // the first ones: of facts about positions
  const std::vector<std::string>& position_words() const { return position_words_; }  // of these
  const solve::Scales& scales() const { return scales_; }
  double misfit_size() const { return misfit_size_; }  // of the largest term in these equations
  // What facts that are not linear leave open, where the unknowns of a system have these values.
  using System = InstantSystem;
  struct NonlinearMisfit {
    std::string words;
    double value = 0, size = 0;  // in natural units; the size is that of its sides
  };
  std::vector<NonlinearMisfit> nonlinear_misfits(System system, const std::vector<double>& unknowns) const;

  // Cords that would have to push and contacts that would have to pull, in words. After solve_forces().
  std::vector<std::string> unphysical() const;

  // The motion near this one, which must be steady; asked for at the mark.
  const solve::Linearisation& linearisation(const Mark& mark);

  // The solution on the road of particles; forces are checked if they are solved.
  struct Residuals {
    solve::CheckResult particles;
    double impulse = 0;  // momenta before + impulses - momenta after, relative
  };
  Residuals check() const;

 private:
  friend class VariedInstant;
  void build(double time, const std::optional<std::vector<std::string>>& loads);
  Machine machine_from(DataScope<double>& data, double time, const std::optional<std::vector<std::string>>& loads);
  MachineOptions machine_options(double time, const std::optional<std::vector<std::string>>& loads) const;
  void set_positions(const std::vector<const Instant*>& instants);
  void solve_velocities(const std::vector<const Instant*>& instants, const std::optional<std::vector<double>>& v);
  void position_facts(const std::vector<const Instant*>& instants);
  InstantView<double> view() const;
  // "'now': mass(bar)"
  std::string fact_words(const Fact& fact) const;
  std::vector<const Fact*> state_motion_equations();  // returns the facts that are not linear
  void solve_motion_equations(const std::vector<const Fact*>& nonlinear);
  // Facts that are not linear must hold of the solution.
  void hold_nonlinear(System system, const std::vector<const Fact*>& facts, const solve::LinearSolution& solution);
  struct FactSides {
    std::vector<Difference<double>> differences;
    double size = 0;  // of the larger side
  };
  FactSides sides_of(const Fact& fact, System system, const std::vector<double>& unknowns) const;
  void release(const std::vector<bool>& acting);
  void solve_blow();
  std::mt19937_64& random();
  void take_misfits(const solve::LinearSolution& solution);
  void move_along(const solve::LinearSolution& solution, std::vector<double>& values, double pace = 1);
  double natural_unit(const Dimension& dimension) const { return problem::natural_unit(scales_, dimension); }
  [[noreturn]] void contradiction(const solve::LinearSystem& equations, const solve::LinearSolution& solution,
                                  bool forces);
  QuantityScope<double> scope_for(const Expression& expression, const std::optional<Expression>& axes,
                                  const Elsewhere& elsewhere);

  const Situation& situation_;
  const Settings& settings_;
  OpenChoice choice_;
  std::unique_ptr<std::mt19937_64> random_;  // large, and seldom wanted
  std::vector<double> any_values_;           // chosen so far, so that every building of the machine takes the same
  std::unique_ptr<DataScope<double>> data_;
  std::unique_ptr<DataScope<double>> elsewhen_;            // for machines at other times
  std::optional<std::vector<BodyMassOf<double>>> masses_;  // once they are found, if they do not follow the time
  std::size_t any_in_masses_ = 0;                          // of any_values_, those of the masses
  Machine machine_;
  solve::Scales scales_;
  std::optional<solve::MechanismState> moment_;
  double time_ = 0;
  std::optional<bool> timed_;               // whether the machine follows the time
  bool moving_ = false;                     // along a motion: nothing is stated of this instant
  std::optional<std::size_t> built_stage_;  // for which stage of a motion the machine is built
  std::vector<bool> built_acting_;
  Feature feature_;
  std::vector<const Instant*> facts_;
  std::vector<double> v_;
  solve::LinearSystem velocity_equations_, motion_equations_;
  solve::LinearSolution velocities_;
  std::optional<solve::LinearSolution> motion_;
  std::vector<double> unknowns_;
  std::optional<solve::Linearisation> linearisation_;
  std::vector<double> misfits_;
  std::size_t position_misfits_ = 0;
  std::vector<std::string> position_words_;
  double misfit_size_ = 0;
  std::map<System, std::vector<const Fact*>> nonlinear_;
  // A blow, if this is the instant after it: what was before, and velocities after with all impulses.
  std::optional<solve::MechanismState> before_;
  solve::Blow blow_;
  std::vector<bool> blow_acting_;  // of each action
  solve::LinearSystem blow_equations_;
  solve::LinearSolution blow_solution_;
  std::vector<double> impulses_;
};

}  // namespace poinsot::problem
