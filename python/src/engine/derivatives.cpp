// Derivatives of the dynamics by the state and by the inertias.

#include "engine/bindings.h"
#include "engine/cases.h"
#include "poinsot/engine/dynamics/inertia_regressor.h"

namespace nb = nanobind;
using namespace nb::literals;

namespace poinsot::python {
namespace {

std::size_t size(int count) { return static_cast<std::size_t>(count); }

// The part number i of three that stand in `found` one after the other.
template <class Scalar>
std::span<Scalar> third(std::vector<Scalar>& found, std::size_t i) {
  const std::size_t part = found.size() / 3;
  return std::span<Scalar>(found).subspan(i * part, part);
}

NumpyArray of_inverse(const EngineModel& model, nb::handle q, nb::handle v, nb::handle a, int threads) {
  const int nv = model.numbers.velocity_size();
  return for_cases(model, {{"q", q, model.numbers.position_size()}, {"v", v, nv}, {"a", a, nv}},
                   {3, size(nv), size(nv)}, threads, []<class Scalar>(const Model<Scalar>& of, Case<Scalar>& one) {
                     inverse_dynamics_derivatives<Scalar>(
                         of, one.for_derivatives(of), one.state, one.given,
                         {third(one.found, 0), third(one.found, 1), third(one.found, 2)});
                   });
}

NumpyArray of_forward(const EngineModel& model, nb::handle q, nb::handle v, nb::handle tau, int threads) {
  const int nv = model.numbers.velocity_size();
  return for_cases(model, {{"q", q, model.numbers.position_size()}, {"v", v, nv}, {"tau", tau, nv}},
                   {3, size(nv), size(nv)}, threads, []<class Scalar>(const Model<Scalar>& of, Case<Scalar>& one) {
                     forward_dynamics_derivatives<Scalar>(
                         of, one.for_derivatives(of), one.state, one.given,
                         {third(one.found, 0), third(one.found, 1), third(one.found, 2)});
                   });
}

NumpyArray regressors(const EngineModel& model, nb::handle q, nb::handle v, nb::handle a, int threads) {
  const int nv = model.numbers.velocity_size();
  const std::size_t columns = size(inertia_numbers * model.numbers.body_count());
  return for_cases(model, {{"q", q, model.numbers.position_size()}, {"v", v, nv}, {"a", a, nv}}, {size(nv), columns},
                   threads, []<class Scalar>(const Model<Scalar>& of, Case<Scalar>& one) {
                     inertia_regressor<Scalar>(of, one.workspace, one.state, one.given, one.found);
                   });
}

// Ten numbers of each body.
NumpyArray inertias(const EngineModel& model) {
  const int bodies = model.numbers.body_count();
  const ResultArray found = new_result({size(bodies), size(inertia_numbers)}, {});
  for (int body = 0; body < bodies; ++body) {
    const auto numbers = inertia_numbers_of(model.numbers, body);
    std::ranges::copy(numbers, found.data + inertia_numbers * body);
  }
  return found.array;
}

}  // namespace

void bind_derivatives(nb::module_& module) {
  module.def("inverse_dynamics_derivatives", &of_inverse, "model"_a, "q"_a, "v"_a, "a"_a, "threads"_a);
  module.def("forward_dynamics_derivatives", &of_forward, "model"_a, "q"_a, "v"_a, "tau"_a, "threads"_a);
  module.def("inertia_regressor", &regressors, "model"_a, "q"_a, "v"_a, "a"_a, "threads"_a);
  module.def("inertia_numbers", &inertias, "model"_a);
}

}  // namespace poinsot::python
