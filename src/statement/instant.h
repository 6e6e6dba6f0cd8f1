// One situation of a statement, with values, solved at an instant.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "poinsot/solve/equations.h"
#include "poinsot/solve/particle_check.h"
#include "statement/quantities.h"

namespace poinsot::statement {

// How to choose what a statement leaves open. An answer is determined when no choice changes it.
struct OpenChoice {
  std::uint64_t seed = 0;     // of the random choices
  bool any = false;           // values given as `any`
  bool gravity = false;       // gravity, where nothing is said of it
  bool velocities = false;    // velocities that nothing fixes
  bool forces = false;        // accelerations and forces that nothing fixes; impulses at a blow
  std::size_t direction = 0;  // which of the open directions of these, or `every`

  static constexpr std::size_t every = static_cast<std::size_t>(-1);
  bool trial = false;  // unknowns have trial values: what does not hold is a misfit, not an error
};

// Where in time: the only instant, the start of a stage, or just before or after a blow.
struct When {
  std::size_t stage = 0;  // number of stages passed before
  bool after_blow = false;
};

class SolvedInstant {
 public:
  // problem and settings must outlive it. Throws StatementError.
  SolvedInstant(const Problem& problem, const Settings& settings, const When& when, const OpenChoice& choice);

  // Solves for accelerations and forces; done by itself when a quantity needs them.
  void solve_forces();
  bool forces_solved() const { return motion_.has_value(); }

  // What stands before an `@`, at another instant.
  using Elsewhere = std::function<Value<double>(const At& at, const Mark& mark)>;
  // The value of an ask on the given axes (ground axes where none are stated); vectors have components on these axes.
  Value<double> ask(const Expression& expression, const std::optional<Expression>& axes, const Elsewhere& elsewhere);
  // The same with vectors on ground axes.
  Value<double> raw(const Expression& expression, const std::optional<Expression>& axes, const Elsewhere& elsewhere);
  // The size that a quantity of this dimension naturally has here.
  double natural_size(const Dimension& dimension) const;

  bool after_blow() const { return before_.has_value(); }
  const solve::LinearSolution& blow() const { return blow_solution_; }
  const solve::LinearSystem& blow_equations() const { return blow_equations_; }
  const solve::LinearSolution& velocities() const { return velocities_; }
  const solve::LinearSystem& velocity_equations() const { return velocity_equations_; }
  const solve::LinearSolution& motion() const { return *motion_; }
  const solve::LinearSystem& motion_equations() const { return motion_equations_; }
  const Machine& machine() const { return machine_; }

  // In a trial: by how much the equations fail to hold, in natural units.
  const std::vector<double>& misfits() const { return misfits_; }
  double misfit_size() const { return misfit_size_; }  // of the largest term in these equations

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
  struct Start {
    std::vector<double> q, v;
    double time = 0;
  };
  void build(double time, const std::optional<std::vector<std::string>>& loads);
  void set_positions(const std::vector<const Instant*>& instants);
  void solve_velocities(const std::vector<const Instant*>& instants, const std::optional<std::vector<double>>& v);
  std::vector<solve::Condition> rate_conditions() const;
  void position_facts(const std::vector<const Instant*>& instants);
  std::vector<solve::Condition> velocity_facts(const std::vector<const Instant*>& instants);
  std::vector<solve::Condition> force_conditions();
  void add_steady(std::vector<solve::Condition>& conditions, bool accelerations) const;
  bool hangs_on(int body, int ancestor) const;
  bool turns_unseen(int body) const;
  std::vector<const Instant*> instants_at(std::size_t stage) const;
  void solve_blow();
  void take_misfits(const solve::LinearSolution& solution);
  void move_along(const solve::LinearSolution& solution, std::vector<double>& values);
  void run_stages(std::size_t count);
  std::vector<double> accelerations_at(double time, const std::vector<double>& q, const std::vector<double>& v,
                                       std::size_t stage);
  double natural_unit(const Dimension& dimension) const;
  [[noreturn]] void contradiction(const solve::LinearSystem& equations, const solve::LinearSolution& solution,
                                  bool forces);
  QuantityScope<double> scope_for(const Expression& expression, const std::optional<Expression>& axes,
                                  const Elsewhere& elsewhere);

  const Problem& problem_;
  const Settings& settings_;
  OpenChoice choice_;
  std::mt19937_64 random_;
  std::vector<double> any_values_;  // chosen so far, so that every building of the machine takes the same
  std::unique_ptr<DataScope<double>> data_;
  std::unique_ptr<DataScope<TimeJet>> timed_;
  Machine machine_;
  solve::Scales scales_;
  std::optional<solve::Moment> moment_;
  double time_ = 0;
  std::vector<const Instant*> facts_;
  std::vector<double> v_;
  solve::LinearSystem velocity_equations_, motion_equations_;
  solve::LinearSolution velocities_;
  std::optional<solve::LinearSolution> motion_;
  std::vector<double> unknowns_;
  std::optional<solve::Linearisation> linearisation_;
  std::vector<double> misfits_;
  double misfit_size_ = 0;
  // A blow, if this is the instant after it: what was before, and velocities after with all impulses.
  std::optional<solve::Moment> before_;
  solve::Blow blow_;
  solve::LinearSystem blow_equations_;
  solve::LinearSolution blow_solution_;
  std::vector<double> impulses_;
};

}  // namespace poinsot::statement
