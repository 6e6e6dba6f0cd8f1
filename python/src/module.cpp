#include <nanobind/nanobind.h>

#include "bindings.h"

namespace {

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
  poinsot::python::bind_errors(module);
  poinsot::python::bind_document(module);
  poinsot::python::bind_motion(module);
  poinsot::python::bind_studies(module);
  poinsot::python::bind_problem(module);
}
