#include <nanobind/nanobind.h>

#include "bindings.h"

NB_MODULE(_core, module) {
  module.doc() = "The part of poinsot that is written in C++. Use the package poinsot, which stands on it.";
  module.attr("version") = POINSOT_VERSION;
  poinsot::python::bind_errors(module);
  poinsot::python::bind_document(module);
  poinsot::python::bind_engine_model(module);
  poinsot::python::bind_engine_dynamics(module);
  poinsot::python::bind_engine_kinematics(module);
  poinsot::python::bind_motion(module);
  poinsot::python::bind_studies(module);
  poinsot::python::bind_problem(module);
}
