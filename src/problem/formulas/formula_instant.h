// One situation of a statement with letters left open, solved at an instant as formulas.
//
// The same machine, conditions and equations as in SolvedInstant, over exact scalars; the linear equations are solved
// exactly for letters in general position.
#pragma once

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

// Letters, data from outside the file and unknowns, each as a formula.
using FormulaValues = std::map<std::string, Value<Formula>>;

// Collects what a statement leaves open, as letters in place of zero: for claims, which hold whatever it is.
struct OpenLetters {
  bool all_poses = false;         // coordinates without name are open too
  std::vector<Letter> made;       // positions and velocities
  std::set<std::string> unfixed;  // accelerations, forces and impulses that nothing fixes
};

class FormulaInstant {
 public:
  // numbers: the same instant solved at some values of the letters, for what is decided on numbers: which cords and
  // contacts act in a blow. problem and numbers must outlive the instant. Throws NoFormula for what has none: loops
  // that close in another pose than drawn, later stages; what the roads of expressions throw (StatementError,
  // std::domain_error, ExpressionTooLarge).
  // open: what the statement leaves open is a letter there, and zero when left out.
  FormulaInstant(const Situation& situation, const FormulaValues& values, const SolvedInstant& numbers,
                 OpenLetters* open = nullptr);

  // The value of an ask on the given axes (ground axes where none are stated).
  using Elsewhere = std::function<Value<Formula>(const At& at, const Mark& mark)>;
  Value<Formula> ask(const Expression& expression, const std::optional<Expression>& axes, const Elsewhere& elsewhere);
  // The same with vectors on ground axes.
  Value<Formula> raw(const Expression& expression, const std::optional<Expression>& axes, const Elsewhere& elsewhere);

  void solve_forces();
  const MachineOf<Formula>& machine() const { return machine_; }
  DataScope<Formula>& data() { return *data_; }
  const Situation& situation() const { return situation_; }
  const std::vector<Formula>& positions() const { return machine_.q; }
  const std::vector<Formula>& velocities() const { return v_; }
  // With accelerations once forces are solved; the unknowns of the motion, and of a blow with the motion before it.
  const solve::MechanismStateOf<Formula>& moment() const { return *moment_; }
  const std::vector<Formula>& unknowns() const { return unknowns_; }
  const std::optional<solve::MechanismStateOf<Formula>>& before() const { return before_; }
  const solve::BlowOf<Formula>& blow() const { return blow_; }
  const std::vector<Formula>& impulses() const { return impulses_; }
  const std::vector<Formula>& velocities_before_blow() const { return v_before_; }
  // What is left of the facts and equations solved so far: it vanishes if all of them hold.
  const std::vector<Formula>& remainders() const { return remainders_; }

 private:
  void set_positions(const std::vector<const Instant*>& instants);
  void open_positions();
  void solve_velocities();
  void solve_blow();
  void note_who_acts() const;
  void find_forces();
  void hold_nonlinear(const std::vector<const Fact*>& facts);
  solve::ExactSolution solve_with_unfixed(const solve::LinearSystemOf<Formula>& equations);
  InstantView<Formula> view() const;
  const QuantityScope<Formula>& present_scope();
  QuantityScope<Formula> scope_for(const Expression& expression, const std::optional<Expression>& axes,
                                   const Elsewhere& elsewhere);

  const Situation& situation_;
  const SolvedInstant& numbers_;
  OpenLetters* open_ = nullptr;
  Formula time_;
  Settings no_settings_;
  std::unique_ptr<DataScope<Formula>> data_;
  MachineOf<Formula> machine_;
  solve::Scales scales_;
  std::optional<solve::MechanismStateOf<Formula>> moment_, before_;
  std::vector<const Instant*> facts_;
  solve::BlowOf<Formula> blow_;
  std::vector<Formula> v_, v_before_, unknowns_, impulses_;
  bool forces_solved_ = false;
  // The scope of the present state, and what was decided on the way to it.
  struct Present {
    bool with_forces, noted;
    QuantityScope<Formula> scope;
    std::vector<Formula> signs;
    bool zeros_by_digits;
  };
  std::optional<Present> present_;
  std::string no_forces_;  // why they have no formulas, once that was tried
  std::vector<Formula> remainders_;
};

}  // namespace poinsot::problem
