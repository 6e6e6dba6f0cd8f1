// The parts of the module poinsot._engine, which is compiled once for each set of instructions: each file binds one
// subject.
#pragma once

#include <nanobind/nanobind.h>

namespace poinsot::python {

// NumPy's own interface for C, by which arrays come in and go out (cases.cpp): to ask an array for its buffer, as any
// object can be asked, takes as long as the dynamics of a small model.
void load_numpy();

void bind_derivatives(nanobind::module_& module);
void bind_dynamics(nanobind::module_& module);
void bind_kinematics(nanobind::module_& module);
void bind_model(nanobind::module_& module);

}  // namespace poinsot::python
