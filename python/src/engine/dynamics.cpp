// Dynamics of the engine for single states and batches.

#include "engine/bindings.h"
#include "engine/cases.h"
#include "poinsot/engine/dynamics/forward_dynamics.h"
#include "poinsot/engine/dynamics/hybrid_dynamics.h"
#include "poinsot/engine/dynamics/inverse_dynamics.h"
#include "poinsot/engine/dynamics/mass_matrix.h"

namespace nb = nanobind;
using namespace nb::literals;

namespace poinsot::python {
namespace {

std::size_t size(int count) { return static_cast<std::size_t>(count); }

NumpyArray inverse(const EngineModel& model, nb::handle q, nb::handle v, nb::handle a, int threads) {
  const int nv = model.numbers.velocity_size();
  return for_cases(model, {{"q", q, model.numbers.position_size()}, {"v", v, nv}, {"a", a, nv}}, {size(nv)}, threads,
                   []<class Scalar>(const Model<Scalar>& of, Case<Scalar>& one) {
                     inverse_dynamics<Scalar>(of, one.workspace, one.state, one.given, one.found);
                   });
}

NumpyArray forward(const EngineModel& model, nb::handle q, nb::handle v, nb::handle tau, int threads) {
  const int nv = model.numbers.velocity_size();
  return for_cases(model, {{"q", q, model.numbers.position_size()}, {"v", v, nv}, {"tau", tau, nv}}, {size(nv)},
                   threads, []<class Scalar>(const Model<Scalar>& of, Case<Scalar>& one) {
                     forward_dynamics<Scalar>(of, one.workspace, one.state, one.given, one.found);
                   });
}

// known: of each coordinate the acceleration where that is prescribed, else the force. Found: accelerations, then
// forces.
NumpyArray hybrid(const EngineModel& model, nb::handle q, nb::handle v, nb::handle known, int threads) {
  const int nv = model.numbers.velocity_size();
  return for_cases(model, {{"q", q, model.numbers.position_size()}, {"v", v, nv}, {"known", known, nv}}, {2, size(nv)},
                   threads, [nv]<class Scalar>(const Model<Scalar>& of, Case<Scalar>& one) {
                     const std::span<Scalar> acceleration(one.found.data(), size(nv)),
                         force(acceleration.end(), size(nv));
                     std::ranges::copy(one.given, acceleration.begin());
                     std::ranges::copy(one.given, force.begin());
                     hybrid_dynamics<Scalar>(of, one.workspace, one.state, acceleration, force);
                   });
}

NumpyArray inertia(const EngineModel& model, nb::handle q, int threads) {
  const int nv = model.numbers.velocity_size();
  return for_cases(model, {{"q", q, model.numbers.position_size()}}, {size(nv), size(nv)}, threads,
                   []<class Scalar>(const Model<Scalar>& of, Case<Scalar>& one) {
                     mass_matrix<Scalar>(of, one.workspace, one.state.q, one.found);
                     mirror_lower_triangle<Scalar>(one.found, of.velocity_size());
                   });
}

NumpyArray integrated(const EngineModel& model, nb::handle q, nb::handle v, double dt, int threads) {
  const int nq = model.numbers.position_size();
  return for_cases(model, {{"q", q, nq}, {"v", v, model.numbers.velocity_size()}}, {size(nq)}, threads,
                   [dt]<class Scalar>(const Model<Scalar>& of, Case<Scalar>& one) {
                     one.found = one.state.q;
                     integrate_position<Scalar>(of, one.found, one.state.v, Scalar(dt));
                   });
}

}  // namespace

void bind_dynamics(nb::module_& module) {
  module.def("inverse_dynamics", &inverse, "model"_a, "q"_a, "v"_a, "a"_a, "threads"_a);
  module.def("forward_dynamics", &forward, "model"_a, "q"_a, "v"_a, "tau"_a, "threads"_a);
  module.def("hybrid_dynamics", &hybrid, "model"_a, "q"_a, "v"_a, "known"_a, "threads"_a);
  module.def("mass_matrix", &inertia, "model"_a, "q"_a, "threads"_a);
  module.def("integrate", &integrated, "model"_a, "q"_a, "v"_a, "dt"_a, "threads"_a);
}

}  // namespace poinsot::python
