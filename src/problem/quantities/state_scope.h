// Evaluates expressions of coordinates, their rates and data, which need no kinematics.
#pragma once

#include "poinsot/engine/model/state.h"
#include "problem/machine/data.h"
#include "problem/machine/machine.h"

namespace poinsot::problem {

// Whether an expression consists of these only, combined by arithmetic and functions of one number.
bool is_of_state(const Situation& situation, const Machine& machine, const Expression& expression);

// The scope of such expressions. All arguments must outlive it.
class StateScope : public Scope<double> {
 public:
  StateScope(const Machine& machine, DataScope<double>& data, const State<double>& state)
      : machine_(machine), data_(data), state_(state) {}

  Value<double> name(const Name& name, const Mark& mark, const Evaluator<double>& evaluator) override;
  Value<double> call(const Call& call, const Mark& mark, const Evaluator<double>& evaluator) override;

 private:
  const Machine& machine_;
  DataScope<double>& data_;
  const State<double>& state_;
};

}  // namespace poinsot::problem
