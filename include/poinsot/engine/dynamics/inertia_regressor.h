// Joint forces as a linear function of the masses of the bodies: tau = Y pi, with pi the inertia of each body in ten
// numbers (Atkeson, An and Hollerbach 1986). Y is the derivative of inverse dynamics by these numbers, whatever they
// are.
#pragma once

#include <array>
#include <span>

#include "poinsot/engine/dynamics/inverse_dynamics.h"

namespace poinsot {

// Of a body, about its origin on its own axes: mass, mass times the place of its mass center (3), and the tensor of
// inertia as xx, yy, zz, xy, yz, zx.
inline constexpr int inertia_numbers = 10;

template <class Scalar>
std::array<Scalar, inertia_numbers> inertia_numbers_of(const Model<Scalar>& model, int body) {
  const SpatialInertia<Scalar> I = turned(transpose(model.body(body).R_WB), model.body(body).inertia);
  const Vector3<Scalar>& h = I.first_moment;
  const SymmetricMatrix3<Scalar>& J = I.inertia;
  return {I.mass, h.x, h.y, h.z, J.xx, J.yy, J.zz, J.xy, J.yz, J.zx};
}

namespace detail {

// The wrench on a body that has one of the ten numbers 1 and all others 0, about its origin on its axes: the force is
// m a + A h, the moment I alpha + w x I w + h x a (inverse_dynamics.h).
template <class Scalar>
std::array<SpatialForce<Scalar>, inertia_numbers> unit_wrenches(const Vector3<Scalar>& a, const Matrix3<Scalar>& A) {
  std::array<SpatialForce<Scalar>, inertia_numbers> wrenches;
  wrenches[0] = {Vector3<Scalar>::zero(), a};
  for (std::size_t k = 0; k < 3; ++k) {
    const Vector3<Scalar> e = Vector3<Scalar>::unit(k);
    wrenches[1 + k] = {cross(e, a), A.column(k)};
  }
  const Scalar half(0.5), none(0), minus(-1);
  const auto of_second_moment = [&](const SymmetricMatrix3<Scalar>& E) {
    return SpatialForce<Scalar>{euler_moment(A, E), Vector3<Scalar>::zero()};
  };
  wrenches[4] = of_second_moment(SymmetricMatrix3<Scalar>::diagonal(-half, half, half));
  wrenches[5] = of_second_moment(SymmetricMatrix3<Scalar>::diagonal(half, -half, half));
  wrenches[6] = of_second_moment(SymmetricMatrix3<Scalar>::diagonal(half, half, -half));
  wrenches[7] = of_second_moment({none, none, none, minus, none, none});
  wrenches[8] = of_second_moment({none, none, none, none, minus, none});
  wrenches[9] = of_second_moment({none, none, none, none, none, minus});
  return wrenches;
}

}  // namespace detail

// Y: velocity_size() rows of ten numbers for each body, row after row. Errors: std::invalid_argument if a size is
// wrong.
template <class Scalar>
[[gnu::noinline]] void inertia_regressor(const Model<Scalar>& model, Workspace<Scalar>& workspace,
                                         const State<Scalar>& state, std::span<const Scalar> acceleration,
                                         std::span<Scalar> Y) {
  const int columns = inertia_numbers * model.body_count();
  detail::require_size("inertia_regressor", "Y", Y.size(), model.velocity_size() * columns);
  // The first velocity_size() of its numbers are written over below.
  inverse_dynamics<Scalar>(model, workspace, state, acceleration, Y.first(model.velocity_size()));
  for (Scalar& entry : Y) entry = Scalar(0);
  for (int of = 0; of < model.body_count(); ++of) {
    const NewtonEulerBody<Scalar>& slot = workspace.newton_euler[of + 1];
    const Matrix3<Scalar>& R = model.body(of).R_WB;
    auto wrenches = detail::unit_wrenches<Scalar>(transpose_times(R, slot.a), transpose(R) * slot.A * R);
    for (SpatialForce<Scalar>& wrench : wrenches) wrench = {R * wrench.moment, R * wrench.force};
    for (int i = of; i != ground; i = model.body(i).parent) {
      const Body<Scalar>& body = model.body(i);
      for (int k = 0; k < velocity_size(body.joint); ++k) {
        const SpatialMotion<Scalar> S = detail::coordinate_motion(body, k, Matrix3<Scalar>::identity());
        Scalar* const row = Y.data() + (body.v + k) * columns + inertia_numbers * of;
        for (std::size_t c = 0; c < wrenches.size(); ++c) row[c] = dot(S, wrenches[c]);
      }
      const NewtonEulerBody<Scalar>& joined = workspace.newton_euler[i + 1];
      for (SpatialForce<Scalar>& wrench : wrenches) {
        const Vector3<Scalar> force = joined.R * wrench.force;
        wrench = {joined.R * wrench.moment + cross(joined.p, force), force};
      }
    }
  }
}

}  // namespace poinsot
