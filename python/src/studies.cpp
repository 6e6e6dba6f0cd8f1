// Many cases of a problem (poinsot/cases.h).
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>
#include <nanobind/stl/vector.h>

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <span>
#include <tuple>
#include <utility>

#include "bindings.h"
#include "owned_array.h"
#include "poinsot/cases.h"

namespace nb = nanobind;
using namespace nb::literals;

namespace poinsot::python {
namespace {

// Set by one thread, it ends the calls of others.
struct StopFlag {
  std::atomic<bool> set = false;
};

using Column = nb::ndarray<const double, nb::ndim<1>, nb::c_contig, nb::device::cpu>;
using Numbers = nb::ndarray<nb::numpy, double>;

// The columns, the road of each case (in full, by instant, by formula), reasons by case, and how many cases were
// checked and refuted.
using Solved = std::tuple<std::vector<Numbers>, nb::ndarray<nb::numpy, std::uint8_t>,
                          std::vector<std::pair<std::size_t, std::string>>, std::size_t, std::size_t>;

Solved solve(const Cases& cases, const std::vector<Column>& values, std::uint64_t first, const StopFlag& stop) {
  std::vector<std::span<const double>> columns;
  for (const Column& column : values) columns.emplace_back(column.data(), column.shape(0));
  CaseRows found;
  {
    const nb::gil_scoped_release released;
    found = cases.solve(columns, first, Budget().end_when(&stop.set));
  }
  std::vector<Numbers> numbers;
  for (std::vector<double>& column : found.columns) numbers.push_back(owned_array(std::move(column)));
  std::vector<std::uint8_t> roads(found.roads.size());
  std::ranges::transform(found.roads, roads.begin(), [](CaseRoad road) { return static_cast<std::uint8_t>(road); });
  return {std::move(numbers), owned_array(std::move(roads)), std::move(found.reasons), found.checked, found.refuted};
}

}  // namespace

void bind_studies(nb::module_& module) {
  nb::class_<StopFlag>(module, "StopFlag").def(nb::init<>()).def("set", [](StopFlag& flag) { flag.set = true; });
  nb::class_<CaseColumn>(module, "CaseColumn").def_ro("name", &CaseColumn::name).def_ro("unit", &CaseColumn::unit);
  nb::class_<CaseQuestions>(module, "CaseQuestions")
      .def(
          "__init__",
          [](CaseQuestions* questions, std::vector<std::string> over, std::vector<std::string> asks,
             std::vector<std::pair<std::string, std::string>> sets, std::vector<double> first, bool formulas,
             std::vector<std::string> sensitivities, std::vector<double> usual) {
            new (questions) CaseQuestions{std::move(over), std::move(asks),          std::move(sets), std::move(first),
                                          formulas,        std::move(sensitivities), std::move(usual)};
          },
          "over"_a, "asks"_a, "sets"_a, "first"_a, "formulas"_a = true, "sensitivities"_a = std::vector<std::string>(),
          "usual"_a = std::vector<double>());
  nb::class_<Cases>(module, "Cases")
      .def_prop_ro("over", &Cases::over)
      .def_prop_ro("columns", &Cases::columns)
      .def_prop_ro("has_formulas", &Cases::has_formulas)
      .def_prop_ro("no_formulas", &Cases::no_formulas)
      .def_prop_ro("by_instants", &Cases::by_instants)
      .def_prop_ro("no_program", &Cases::no_program)
      .def("solve", &solve, "values"_a, "first"_a, "stop"_a);
}

}  // namespace poinsot::python
