// The parts of the module poinsot._engine, which is compiled once for each set of instructions: each file binds one
// subject.
#pragma once

#include <nanobind/nanobind.h>

namespace poinsot::python {

void bind_derivatives(nanobind::module_& module);
void bind_dynamics(nanobind::module_& module);
void bind_kinematics(nanobind::module_& module);
void bind_model(nanobind::module_& module);

}  // namespace poinsot::python
