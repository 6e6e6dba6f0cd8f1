#include <nanobind/nanobind.h>

#include "engine/bindings.h"

NB_MODULE(POINSOT_ENGINE_MODULE, module) {
  module.doc() = "The engine, compiled for one set of instructions. Use poinsot.engine, which chooses among them.";
  poinsot::python::load_numpy();
  poinsot::python::bind_model(module);
  poinsot::python::bind_dynamics(module);
  poinsot::python::bind_derivatives(module);
  poinsot::python::bind_kinematics(module);
}
