// Motions (poinsot/problem.h), their values as arrays.
#include <nanobind/ndarray.h>
#include <nanobind/stl/map.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <memory>
#include <utility>

#include "all_or_nothing.h"
#include "bindings.h"
#include "owned_array.h"
#include "poinsot/problem.h"

namespace nb = nanobind;
using namespace nb::literals;

namespace poinsot::python {

void bind_motion(nb::module_& module) {
  nb::class_<MotionSeries>(module, "MotionSeries")
      .def_ro("name", &MotionSeries::name)
      .def_ro("unit", &MotionSeries::unit)
      .def_ro("axes", &MotionSeries::component_names)
      .def_prop_ro(
          "si", [](const MotionSeries& series) { return owned_array(series.si, series.component_names.size()); },
          nb::rv_policy::automatic);
  nb::class_<MotionValues>(module, "MotionValues")
      .def_ro("series", &MotionValues::series)
      .def_ro("checks", &MotionValues::checks)
      .def_ro("notes", &MotionValues::notes);
  nb::class_<Motion>(module, "Motion")
      .def(
          "coordinates",
          [](const Motion& motion, Timeout timeout, nb::object listener) {
            return all_or_nothing(timeout, std::move(listener),
                                  [&](const Budget& budget) { return motion.coordinates(budget); });
          },
          "timeout"_a.none(), "listener"_a.none())
      .def(
          "values",
          [](const Motion& motion, const std::vector<double>& times, const std::vector<std::string>& quantities,
             const std::string& axes, Timeout timeout, nb::object listener) {
            return all_or_nothing(timeout, std::move(listener),
                                  [&](const Budget& budget) { return motion.values(times, quantities, axes, budget); });
          },
          "times"_a, "quantities"_a, "axes"_a, "timeout"_a.none(), "listener"_a.none());
}

}  // namespace poinsot::python
