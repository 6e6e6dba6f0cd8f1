#include <nanobind/nanobind.h>
#include <nanobind/stl/array.h>
#include <nanobind/stl/string.h>

#include <array>

#include "bindings.h"
#include "poinsot/engine/mass/validity.h"

namespace {

using Three = std::array<double, 3>;

// Why there is no rigid body with these mass properties; "" if there is one. It stands here, since the modules of the
// engine have templates alone, each for its instructions.
std::string mass_fault(const std::string& name, double mass, const Three& center, const std::array<Three, 3>& inertia) {
  poinsot::Matrix3<double> tensor;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) tensor(i, j) = inertia[i][j];
  const auto report = poinsot::validate(mass, {center[0], center[1], center[2]}, tensor, name);
  return report ? report->message : "";
}

// The largest of the sets of instructions that the engine is compiled for and this processor has.
const char* instruction_set() {
#ifdef __x86_64__
  if (__builtin_cpu_supports("x86-64-v4")) return "x86_64_v4";
  if (__builtin_cpu_supports("x86-64-v3")) return "x86_64_v3";
#endif
  return "";
}

}  // namespace

NB_MODULE(_core, module) {
  module.doc() = "The part of poinsot that is written in C++. Use the package poinsot, which stands on it.";
  module.attr("version") = POINSOT_VERSION;
  module.def("instruction_set", &instruction_set);
  module.def("mass_fault", &mass_fault, nanobind::arg("name"), nanobind::arg("mass"), nanobind::arg("center"),
             nanobind::arg("inertia"));
  poinsot::python::bind_errors(module);
  poinsot::python::bind_document(module);
  poinsot::python::bind_motion(module);
  poinsot::python::bind_studies(module);
  poinsot::python::bind_problem(module);
}
