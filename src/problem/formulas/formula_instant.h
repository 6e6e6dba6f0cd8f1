// One situation, solved at an instant with formulas in the letters without value.
//
// Machine, conditions and equations are those of SolvedInstant, over exact scalars. The linear equations are solved
// exactly for letters in general position, which are no special values.
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "poinsot/engine/solve/linear/exact_solution.h"
#include "problem/instant/instant.h"
#include "problem/language/exact_numbers.h"

namespace poinsot::problem {

// Letters, data from outside the file and unknowns by name, each as a formula.
using FormulaValues = std::map<std::string, Value<Formula>>;

// Letters that stand in place of zero for what a statement leaves open. Claims use them, as they hold for all values.
struct OpenLetters {
  bool all_poses = false;         // whether coordinates without name become letters too
  bool all_places = false;        // and the places of free bodies, as far as nothing binds them
  std::vector<Letter> made;       // for positions and velocities
  std::set<std::string> unfixed;  // accelerations, forces and impulses that nothing determines
};

// The letter of the turn of a body that no joint or a ball holds, one for each axis from 0 to 2: the turn about an axis
// by an angle is that axis times the tangent of half the angle.
std::string letter_of_turn(const std::string& body, std::size_t axis);

// How linear equations over formulas are solved, if not exactly.
using FormulaLinearSolve = std::function<solve::ExactSolution(const solve::LinearSystemOf<Formula>&)>;

class FormulaInstant {
 public:
  // numbers: the same instant solved at some values of the letters, which decides what formulas leave open, such as
  // which cords and contacts act in a blow. Situation and numbers must outlive the object. open: receives letters for
  // what the statement leaves open; without it this is zero. Throws NoFormula for loops that close in another pose
  // than the one drawn and for later stages, and what the evaluation of expressions throws (StatementError,
  // std::domain_error, FormulaTooLarge). linear_solve: used in place of solve::solve_exactly, without `open`.
  FormulaInstant(const Situation& situation, const FormulaValues& values, const SolvedInstant& numbers,
                 OpenLetters* open = nullptr, FormulaLinearSolve linear_solve = {});

  // The value of an ask on the given axes, or on ground axes if none are given.
  using Elsewhere = std::function<Value<Formula>(const At& at, const Mark& mark)>;
  Value<Formula> ask(const Expression& expression, const std::optional<Expression>& axes, const Elsewhere& elsewhere);
  // The same, but vectors are on ground axes.
  Value<Formula> raw(const Expression& expression, const std::optional<Expression>& axes, const Elsewhere& elsewhere);

  void solve_forces();
  const MachineOf<Formula>& machine() const { return machine_; }
  DataScope<Formula>& data() { return *data_; }
  const Situation& situation() const { return situation_; }
  const std::vector<Formula>& positions() const { return machine_.q; }
  const std::vector<Formula>& velocities() const { return v_; }
  // The state, which has accelerations once forces are solved. The unknowns are those of the motion; if there is a
  // blow, those of the motion before it.
  const solve::MechanismStateOf<Formula>& mechanism_state() const { return *mechanism_state_; }
  const std::vector<Formula>& unknowns() const { return unknowns_; }
  const std::optional<solve::MechanismStateOf<Formula>>& before() const { return before_; }
  const solve::BlowOf<Formula>& blow() const { return blow_; }
  const std::vector<Formula>& impulses() const { return impulses_; }
  const std::vector<Formula>& velocities_before_blow() const { return v_before_; }
  // What is left of the facts and equations solved so far. It vanishes if all of them hold.
  const std::vector<Formula>& remainders() const { return remainders_; }

 private:
  bool decides_sizes() const;
  bool decides_lengths() const;
  void set_positions(const std::vector<const Instant*>& instants);
  void open_positions();
  void open_places();
  bool all_gaps_are_closed() const;
  void solve_velocities();
  void solve_blow();
  void note_rough_blow(const RoughBlow& rough) const;
  void note_who_acts() const;
  void take_flanks();
  void note_flanks(const std::vector<Formula>& unknowns) const;
  void find_pressing();
  void find_forces();
  void hold_nonlinear(const std::vector<const Fact*>& facts);
  solve::ExactSolution solved(const solve::LinearSystemOf<Formula>& equations) const;
  solve::ExactSolution solve_with_unfixed(const solve::LinearSystemOf<Formula>& equations);
  InstantView<Formula> view() const;
  const QuantityScope<Formula>& present_scope();
  QuantityScope<Formula> scope_for(const Expression& expression, const std::optional<Expression>& axes,
                                   const Elsewhere& elsewhere);

  const Situation& situation_;
  const SolvedInstant& numbers_;
  OpenLetters* open_ = nullptr;
  FormulaLinearSolve linear_solve_;
  Formula time_;
  Settings no_settings_;
  std::unique_ptr<DataScope<Formula>> data_;
  MachineOf<Formula> machine_;
  solve::Scales scales_;
  std::optional<solve::MechanismStateOf<Formula>> mechanism_state_, before_;
  std::vector<const Instant*> facts_;
  solve::BlowOf<Formula> blow_;
  std::vector<Formula> v_, v_before_, unknowns_, impulses_;
  bool forces_solved_ = false;
  // The scope of the present state, and the decisions on signs taken on the way to it.
  struct Present {
    bool with_forces, noted;
    QuantityScope<Formula> scope;
    std::vector<Formula> signs;
    bool zeros_by_digits;
  };
  std::optional<Present> present_;
  std::string no_forces_;  // why forces have no formulas, once this was tried
  // What was decided on the way to them.
  std::vector<Formula> signs_of_forces_;
  bool forces_by_digits_ = false;
  std::vector<Formula> remainders_;
};

}  // namespace poinsot::problem
