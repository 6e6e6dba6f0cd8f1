// Kinematics, momenta and energies of the engine for single states and batches.
#include "poinsot/engine/dynamics/kinematics.h"

#include <nanobind/stl/array.h>

#include <array>

#include "engine/bindings.h"
#include "engine/cases.h"
#include "poinsot/engine/dynamics/momentum.h"

namespace nb = nanobind;
using namespace nb::literals;

namespace poinsot::python {
namespace {

using Three = std::array<double, 3>;

std::size_t size(int count) { return static_cast<std::size_t>(count); }

template <class Scalar>
Vector3<Scalar> vector(const Three& a) {
  return {Scalar(a[0]), Scalar(a[1]), Scalar(a[2])};
}

template <class Scalar>
void put(std::vector<Scalar>& found, std::size_t at, const Vector3<Scalar>& a) {
  found[at] = a.x;
  found[at + 1] = a.y;
  found[at + 2] = a.z;
}

void require_body(const EngineModel& model, int body) {
  if (body < 0 || body >= model.numbers.body_count()) throw nb::index_error("there is no such body");
}

// What needs positions alone.
template <class Work>
NumpyArray of_pose(const EngineModel& model, nb::handle q, const std::vector<std::size_t>& shape, int threads,
                   const Work& work) {
  return for_cases(model, {{"q", q, model.numbers.position_size()}}, shape, threads,
                   [&]<class Scalar>(const Model<Scalar>& of, Case<Scalar>& one) {
                     update_poses<Scalar>(of, one.workspace, one.state.q);
                     work(of, one);
                   });
}

// What needs velocities too.
template <class Work>
NumpyArray of_motion(const EngineModel& model, nb::handle q, nb::handle v, const std::vector<std::size_t>& shape,
                     int threads, const Work& work) {
  return for_cases(model, {{"q", q, model.numbers.position_size()}, {"v", v, model.numbers.velocity_size()}}, shape,
                   threads, [&]<class Scalar>(const Model<Scalar>& of, Case<Scalar>& one) {
                     update_velocities<Scalar>(of, one.workspace, one.state);
                     work(of, one);
                   });
}

NumpyArray rotations(const EngineModel& model, nb::handle q, int body, int threads) {
  require_body(model, body);
  return of_pose(model, q, {3, 3}, threads, [body]<class Scalar>(const Model<Scalar>& of, Case<Scalar>& one) {
    const Matrix3<Scalar> R = body_rotation(of, one.workspace, body);
    for (std::size_t i = 0; i < 3; ++i) put(one.found, 3 * i, R.row(i));
  });
}

NumpyArray positions(const EngineModel& model, nb::handle q, int body, const Three& point, int threads) {
  require_body(model, body);
  return of_pose(model, q, {3}, threads, [&]<class Scalar>(const Model<Scalar>& of, Case<Scalar>& one) {
    put(one.found, 0, point_position(of, one.workspace, body, vector<Scalar>(point)));
  });
}

NumpyArray mass_centers(const EngineModel& model, nb::handle q, int threads) {
  return of_pose(model, q, {3}, threads, []<class Scalar>(const Model<Scalar>& of, Case<Scalar>& one) {
    put(one.found, 0, mass_center(of, one.workspace));
  });
}

// Three rows of the velocity of a point, then three of the angular velocity.
NumpyArray jacobians(const EngineModel& model, nb::handle q, int body, const Three& point, int threads) {
  require_body(model, body);
  const std::size_t nv = size(model.numbers.velocity_size());
  return of_pose(model, q, {6, nv}, threads, [&]<class Scalar>(const Model<Scalar>& of, Case<Scalar>& one) {
    const std::span<Scalar> rows(one.found);
    point_jacobian<Scalar>(of, one.workspace, body, vector<Scalar>(point), rows.first(3 * nv));
    angular_jacobian<Scalar>(of, one.workspace, body, rows.last(3 * nv));
  });
}

// Linear, then angular about the ground point.
NumpyArray momenta(const EngineModel& model, nb::handle q, nb::handle v, const Three& about, int threads) {
  return of_motion(model, q, v, {6}, threads, [&]<class Scalar>(const Model<Scalar>& of, Case<Scalar>& one) {
    const Momentum<Scalar> all = momentum(of, one.workspace, vector<Scalar>(about));
    put(one.found, 0, all.linear);
    put(one.found, 3, all.angular);
  });
}

NumpyArray kinetic_energies(const EngineModel& model, nb::handle q, nb::handle v, int threads) {
  return of_motion(model, q, v, {1}, threads, []<class Scalar>(const Model<Scalar>& of, Case<Scalar>& one) {
    one.found[0] = kinetic_energy(of, one.workspace);
  });
}

NumpyArray potential_energies(const EngineModel& model, nb::handle q, int threads) {
  return of_pose(model, q, {1}, threads, []<class Scalar>(const Model<Scalar>& of, Case<Scalar>& one) {
    one.found[0] = potential_energy(of, one.workspace);
  });
}

}  // namespace

void bind_kinematics(nb::module_& module) {
  module.def("body_rotation", &rotations, "model"_a, "q"_a, "body"_a, "threads"_a);
  module.def("point_position", &positions, "model"_a, "q"_a, "body"_a, "point"_a, "threads"_a);
  module.def("mass_center", &mass_centers, "model"_a, "q"_a, "threads"_a);
  module.def("jacobian", &jacobians, "model"_a, "q"_a, "body"_a, "point"_a, "threads"_a);
  module.def("momentum", &momenta, "model"_a, "q"_a, "v"_a, "about"_a, "threads"_a);
  module.def("kinetic_energy", &kinetic_energies, "model"_a, "q"_a, "v"_a, "threads"_a);
  module.def("potential_energy", &potential_energies, "model"_a, "q"_a, "threads"_a);
}

}  // namespace poinsot::python
