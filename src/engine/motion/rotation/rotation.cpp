#include "poinsot/engine/motion/rotation/rotation.h"

#include <array>
#include <memory>

#include "engine/motion/integrator/methods.h"
#include "engine/motion/rotation/rotation_method.h"

namespace poinsot {

namespace {

using Numbers = std::array<double, 7>;

MotionEquations equations_of(const std::shared_ptr<const Rotor>& rotor) {
  MotionEquations equations;
  equations.position_size = 4;
  equations.velocity_size = 3;
  equations.quaternions = {0};
  equations.position_rate = [](double, std::span<const double> q, std::span<const double> v, std::span<double> rate) {
    const Quaternion<double> d =
        quaternion_rate(Quaternion<double>{q[0], q[1], q[2], q[3]}, Vector3<double>{v[0], v[1], v[2]});
    rate[0] = d.w;
    rate[1] = d.x;
    rate[2] = d.y;
    rate[3] = d.z;
  };
  // I dw/dt = torque - w x I w (Eq. 18.22), on principal axes.
  equations.accelerations = [rotor](double t, std::span<const double> q, std::span<const double> v,
                                    std::span<double> a) {
    const Numbers y{q[0], q[1], q[2], q[3], v[0], v[1], v[2]};
    const PrincipalBody& body = rotor->principal;
    const RotationState state = read_rotation(body, y.data());
    const Matrix3<double> R = rotation_matrix(state.attitude);
    const Vector3<double> m = transpose_times(R, state.momentum);
    const Vector3<double> w = body.angular_velocity(state.attitude, state.momentum);
    const Vector3<double> torque =
        body.has_torque() ? transpose_times(R, body.torque(t, state.attitude, state.momentum)) : Vector3<double>{};
    const Vector3<double> rate = torque + cross(m, w);
    const Vector3<double> on_body =
        rotation_matrix(body.axes) *
        Vector3<double>{rate.x / body.moments.x, rate.y / body.moments.y, rate.z / body.moments.z};
    a[0] = on_body.x;
    a[1] = on_body.y;
    a[2] = on_body.z;
  };
  if (rotor->given.torque) return equations;

  const auto conserve = [&](const char* name, auto value) {
    equations.conserved.push_back({name, [rotor, value](double, std::span<const double> q, std::span<const double> v) {
                                     const Numbers y{q[0], q[1], q[2], q[3], v[0], v[1], v[2]};
                                     return value(rotor->principal, read_rotation(rotor->principal, y.data()));
                                   }});
  };
  conserve("energy", [](const PrincipalBody& body, const RotationState& state) { return body.energy(state); });
  if (rotor->principal.has_weight) {
    conserve("angular momentum about the vertical",
             [](const PrincipalBody& body, const RotationState& state) { return -dot(body.down, state.momentum); });
  } else {
    conserve("angular momentum along x",
             [](const PrincipalBody&, const RotationState& state) { return state.momentum.x; });
    conserve("angular momentum along y",
             [](const PrincipalBody&, const RotationState& state) { return state.momentum.y; });
    conserve("angular momentum along z",
             [](const PrincipalBody&, const RotationState& state) { return state.momentum.z; });
  }
  return equations;
}

}  // namespace

MotionEquations rotation_equations(const RotatingBody& body) { return equations_of(std::make_shared<Rotor>(body)); }

IntegrationResult integrate_rotation(const RotatingBody& body, double start, const Quaternion<double>& attitude,
                                     const Vector3<double>& angular_velocity, double end,
                                     const IntegrationOptions& options, std::span<const Event> events) {
  const auto rotor = std::make_shared<const Rotor>(body);
  const MethodMaker make = [&rotor](IntegrationMethod method, RightSide& right_side, const ErrorScale& scale,
                                    const IntegrationOptions& o) -> std::unique_ptr<StepMethod> {
    switch (method) {
      case IntegrationMethod::automatic:
      case IntegrationMethod::collocation:
        return make_rotation_collocation(rotor, o);
      case IntegrationMethod::structure_preserving:
        return make_rotation_in_equal_steps(rotor, o);
      case IntegrationMethod::explicit_runge_kutta:
      case IntegrationMethod::stiff:
        break;
    }
    return make_general_method(method, right_side, scale, o);
  };
  const std::array<double, 4> q{attitude.w, attitude.x, attitude.y, attitude.z};
  const std::array<double, 3> v{angular_velocity.x, angular_velocity.y, angular_velocity.z};
  IntegrationResult result = integrate_by(make, equations_of(rotor), start, q, v, end, options, events);
  if (options.method == IntegrationMethod::automatic) result.method = "integrated about the free motion of the body";
  return result;
}

}  // namespace poinsot
