// The parts of the module poinsot._core. Each file binds one subject.
#pragma once

#include <nanobind/nanobind.h>

namespace poinsot::python {

void bind_errors(nanobind::module_& module);
void bind_document(nanobind::module_& module);
void bind_motion(nanobind::module_& module);
void bind_problem(nanobind::module_& module);
void bind_studies(nanobind::module_& module);

}  // namespace poinsot::python
