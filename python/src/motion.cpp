// Motions (poinsot/problem.h), their values as arrays.
#include <nanobind/ndarray.h>
#include <nanobind/stl/array.h>
#include <nanobind/stl/map.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <array>
#include <memory>
#include <utility>

#include "all_or_nothing.h"
#include "bindings.h"
#include "owned_array.h"
#include "poinsot/problem.h"

namespace nb = nanobind;
using namespace nb::literals;

namespace poinsot::python {
namespace {

void put(std::vector<double>& numbers, const Vector3<double>& a) { numbers.insert(numbers.end(), {a.x, a.y, a.z}); }
void put(std::vector<double>& numbers, const Matrix3<double>& A) {
  for (std::size_t i = 0; i < 3; ++i) put(numbers, A.row(i));
}
void put(std::vector<double>& numbers, const SymmetricMatrix3<double>& S) {
  numbers.insert(numbers.end(), {S.xx, S.yy, S.zz, S.xy, S.yz, S.zx});
}

// What poinsot._engine makes the same tree of (engine/model.cpp reads it): the modules share no types.
std::vector<std::vector<double>> tree_numbers(const Model<double>& tree) {
  std::vector<std::vector<double>> bodies;
  for (const Body<double>& body : tree.bodies()) {
    std::vector<double>& numbers = bodies.emplace_back();
    numbers = {static_cast<double>(body.joint), static_cast<double>(body.parent), body.pitch};
    put(numbers, body.placement.R);
    put(numbers, body.placement.p);
    numbers.push_back(body.inertia.mass);
    put(numbers, body.inertia.first_moment);
    put(numbers, body.inertia.inertia);
    put(numbers, body.second_moment);
    put(numbers, body.R_WB);
  }
  return bodies;
}

std::vector<bool> prescribed(const Model<double>& tree) {
  std::vector<bool> prescribed;
  for (const CoordinateMode mode : tree.modes()) prescribed.push_back(mode != CoordinateMode::free);
  return prescribed;
}

}  // namespace

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
  nb::class_<MotionStart>(module, "MotionStart")
      .def_prop_ro("names", [](const MotionStart& start) { return start.tree.names(); })
      .def_prop_ro("bodies", [](const MotionStart& start) { return tree_numbers(start.tree); })
      .def_prop_ro("prescribed", [](const MotionStart& start) { return prescribed(start.tree); })
      .def_prop_ro("gravity",
                   [](const MotionStart& start) {
                     const Vector3<double>& g = start.tree.gravity();
                     return std::array<double, 3>{g.x, g.y, g.z};
                   })
      .def_prop_ro("q", [](const MotionStart& start) { return start.state.q; })
      .def_prop_ro("v", [](const MotionStart& start) { return start.state.v; })
      .def_ro("coordinates", &MotionStart::coordinates)
      .def_prop_ro("origins",
                   [](const MotionStart& start) {
                     std::vector<std::array<double, 3>> origins;
                     for (const Vector3<double>& a : start.origins) origins.push_back({a.x, a.y, a.z});
                     return origins;
                   })
      .def_ro("others", &MotionStart::others);
  nb::class_<Motion>(module, "Motion")
      .def(
          "start",
          [](const Motion& motion, Timeout timeout, nb::object listener) {
            return all_or_nothing(timeout, std::move(listener),
                                  [&](const Budget& budget) { return motion.start(budget); });
          },
          "timeout"_a.none(), "listener"_a.none())
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
