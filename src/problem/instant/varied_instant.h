// The derivatives of an instant by one number of its situation, in which unknowns have trial values. Machine,
// conditions and equations are those of SolvedInstant, over dual numbers.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "problem/instant/instant.h"

namespace poinsot::problem {

class VariedInstant {
 public:
  using Varied = Dual<1>;

  // base: a trial, which must outlive the object. The number is a datum, letter or unknown of its settings, or a
  // component of one. Throws std::domain_error if the instant has no derivatives or differs in form over dual
  // numbers, and what SolvedInstant throws.
  VariedInstant(const SolvedInstant& base, const std::string& name, std::size_t component);

  // The results that SolvedInstant gives by the same names; with a blow and with the motion if the base has them.
  const std::vector<Varied>& position_misfits() const { return position_misfits_; }
  const solve::LinearSystemOf<Varied>& equations(InstantSystem system) const { return systems_.at(system); }
  std::vector<Varied> nonlinear_misfits(InstantSystem system, const std::vector<Varied>& unknowns);

 private:
  InstantView<Varied> view();
  void build(const std::string& name, std::size_t component);
  void set_positions();
  void set_velocities();
  void strike();
  void set_forces();
  void expect_same(InstantSystem system, const std::vector<const Fact*>& nonlinear) const;

  const SolvedInstant& base_;
  const Situation& situation_;
  DataScope<Varied> data_;
  MachineOf<Varied> machine_;
  std::optional<solve::MechanismStateOf<Varied>> mechanism_state_, before_;
  solve::BlowOf<Varied> blow_;
  std::vector<Varied> position_misfits_;
  std::map<InstantSystem, solve::LinearSystemOf<Varied>> systems_;
};

}  // namespace poinsot::problem
