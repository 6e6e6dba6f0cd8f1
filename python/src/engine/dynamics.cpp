// Dynamics of the engine for single states and batches.

#include <utility>

#include "engine/bindings.h"
#include "engine/cases.h"
#include "poinsot/engine/dynamics/forward_dynamics.h"
#include "poinsot/engine/dynamics/hybrid_dynamics.h"
#include "poinsot/engine/dynamics/inverse_dynamics.h"
#include "poinsot/engine/dynamics/mass_matrix.h"
#include "poinsot/engine/model/state.h"

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

// Packs in the memory that is made for them.
template <class Scalar>
void find_forward(const Model<Scalar>& of, Case<Scalar>& one, std::span<Scalar> acceleration) {
  if constexpr (std::floating_point<Scalar>)
    forward_dynamics<Scalar>(of, one.workspace, one.state, one.given, acceleration);
  else
    forward_dynamics<Scalar>(of, one.bodies, one.state, one.given, acceleration);
}

NumpyArray forward(const EngineModel& model, nb::handle q, nb::handle v, nb::handle tau, int threads) {
  const int nv = model.numbers.velocity_size();
  return for_cases(
      model, {{"q", q, model.numbers.position_size()}, {"v", v, nv}, {"tau", tau, nv}}, {size(nv)}, threads,
      []<class Scalar>(const Model<Scalar>& of, Case<Scalar>& one) { find_forward<Scalar>(of, one, one.found); });
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

// Of each coordinate one.given has the force, or the acceleration where that is prescribed.
template <class Scalar>
void find_accelerations(const Model<Scalar>& of, Case<Scalar>& one, bool all_free, std::span<Scalar> acceleration,
                        std::span<Scalar> force) {
  if (all_free) return find_forward<Scalar>(of, one, acceleration);
  std::ranges::copy(one.given, acceleration.begin());
  std::ranges::copy(one.given, force.begin());
  hybrid_dynamics<Scalar>(of, one.workspace, one.state, acceleration, force);
}

template <class Scalar>
void make_unit_quaternions(const Model<Scalar>& of, std::vector<Scalar>& q) {
  for (const Body<Scalar>& body : of.bodies()) {
    if (body.joint != JointType::ball && body.joint != JointType::free) continue;
    Scalar* const c = &q[static_cast<std::size_t>(body.q)];
    const Quaternion<Scalar> unit = normalized(Quaternion<Scalar>{c[0], c[1], c[2], c[3]});
    c[0] = unit.w;
    c[1] = unit.x;
    c[2] = unit.y;
    c[3] = unit.z;
  }
}

// Steps of the classical method of Runge and Kutta, of order four in the step: quaternions count as four numbers during
// a step, since the equations are smooth beside the unit ones too, and are made unit ones after it.
template <class Scalar>
void advance(const Model<Scalar>& of, Case<Scalar>& one, double dt, int steps, bool all_free) {
  const std::size_t nq = one.state.q.size(), nv = one.state.v.size();
  one.between.resize(3 * nq + 4 * nv);
  Scalar* at = one.between.data();
  const auto part = [&at](std::size_t length) { return std::span<Scalar>(std::exchange(at, at + length), length); };
  const std::span<Scalar> q0 = part(nq), q_rate = part(nq), q_sum = part(nq);
  const std::span<Scalar> v0 = part(nv), v_rate = part(nv), v_sum = part(nv), force = part(nv);
  const auto move = [](std::vector<Scalar>& to, std::span<const Scalar> from, std::span<const Scalar> rate,
                       double time) {
    for (std::size_t i = 0; i < to.size(); ++i) to[i] = from[i] + Scalar(time) * rate[i];
  };
  struct Stage {
    double weight, next;  // in the sum, and the part of the step to the next stage
  };
  constexpr Stage stages[] = {{1, 0.5}, {2, 0.5}, {2, 1}, {1, 0}};
  for (int step = 0; step < steps; ++step) {
    std::ranges::copy(one.state.q, q0.begin());
    std::ranges::copy(one.state.v, v0.begin());
    std::ranges::fill(q_sum, Scalar(0));
    std::ranges::fill(v_sum, Scalar(0));
    for (const Stage& stage : stages) {
      position_rate<Scalar>(of, one.state.q, one.state.v, q_rate);
      find_accelerations<Scalar>(of, one, all_free, v_rate, force);
      for (std::size_t i = 0; i < nq; ++i) q_sum[i] = q_sum[i] + Scalar(stage.weight) * q_rate[i];
      for (std::size_t i = 0; i < nv; ++i) v_sum[i] = v_sum[i] + Scalar(stage.weight) * v_rate[i];
      if (stage.next == 0) break;
      move(one.state.q, q0, q_rate, stage.next * dt);
      move(one.state.v, v0, v_rate, stage.next * dt);
    }
    move(one.state.q, q0, q_sum, dt / 6);
    move(one.state.v, v0, v_sum, dt / 6);
    make_unit_quaternions(of, one.state.q);
  }
}

// Found: positions, then velocities.
NumpyArray advanced(const EngineModel& model, nb::handle q, nb::handle v, nb::handle known, double dt, int steps,
                    int threads) {
  const int nq = model.numbers.position_size(), nv = model.numbers.velocity_size();
  const bool all_free =
      std::ranges::all_of(model.numbers.modes(), [](CoordinateMode mode) { return mode == CoordinateMode::free; });
  return for_cases(model, {{"q", q, nq}, {"v", v, nv}, {"tau", known, nv}}, {size(nq + nv)}, threads,
                   [=]<class Scalar>(const Model<Scalar>& of, Case<Scalar>& one) {
                     advance<Scalar>(of, one, dt, steps, all_free);
                     std::ranges::copy(one.state.v, std::ranges::copy(one.state.q, one.found.begin()).out);
                   });
}

}  // namespace

void bind_dynamics(nb::module_& module) {
  module.def("inverse_dynamics", &inverse, "model"_a, "q"_a, "v"_a, "a"_a, "threads"_a);
  module.def("forward_dynamics", &forward, "model"_a, "q"_a, "v"_a, "tau"_a, "threads"_a);
  module.def("hybrid_dynamics", &hybrid, "model"_a, "q"_a, "v"_a, "known"_a, "threads"_a);
  module.def("mass_matrix", &inertia, "model"_a, "q"_a, "threads"_a);
  module.def("advance", &advanced, "model"_a, "q"_a, "v"_a, "tau"_a, "dt"_a, "steps"_a, "threads"_a);
  module.def("integrate", &integrated, "model"_a, "q"_a, "v"_a, "dt"_a, "threads"_a);
}

}  // namespace poinsot::python
