// Equations of motion with known motions, for the tests of integrators.
#pragma once

#include <cmath>
#include <vector>

#include "poinsot/engine/math/algebra/quaternion.h"
#include "poinsot/engine/motion/integrator/motion_equations.h"

namespace poinsot {

// d2q/dt2 = -w^2 q.
inline MotionEquations oscillator(double w) {
  MotionEquations equations;
  equations.position_size = equations.velocity_size = 1;
  equations.accelerations = [w](double, std::span<const double> q, std::span<const double>, std::span<double> a) {
    a[0] = -w * w * q[0];
  };
  equations.conserved.push_back({"energy", [w](double, std::span<const double> q, std::span<const double> v) {
                                   return 0.5 * (v[0] * v[0] + w * w * q[0] * q[0]);
                                 }});
  return equations;
}

// A plane pendulum: d2q/dt2 = -w^2 sin q, q from the lowest point.
inline MotionEquations pendulum(double w) {
  MotionEquations equations = oscillator(w);
  equations.accelerations = [w](double, std::span<const double> q, std::span<const double>, std::span<double> a) {
    a[0] = -w * w * std::sin(q[0]);
  };
  equations.conserved[0].value = [w](double, std::span<const double> q, std::span<const double> v) {
    return 0.5 * v[0] * v[0] - w * w * std::cos(q[0]);
  };
  return equations;
}

// The same pendulum as a point (x, y) of a circle of radius 1, held there by projection; y downwards, w^2 = g.
inline MotionEquations pendulum_on_circle(double g) {
  MotionEquations equations;
  equations.position_size = equations.velocity_size = 2;
  equations.accelerations = [g](double, std::span<const double> q, std::span<const double> v, std::span<double> a) {
    const double tension = (v[0] * v[0] + v[1] * v[1] + g * q[1]) / (q[0] * q[0] + q[1] * q[1]);
    a[0] = -tension * q[0];
    a[1] = g - tension * q[1];
  };
  equations.project = [](double, std::span<double> q, std::span<double> v) {
    const double r = std::hypot(q[0], q[1]);
    q[0] /= r;
    q[1] /= r;
    const double along = q[0] * v[0] + q[1] * v[1];
    v[0] -= along * q[0];
    v[1] -= along * q[1];
  };
  return equations;
}

// A body that turns about a fixed point: attitude quaternion and angular velocity on principal axes, moments of inertia
// I; its mass center along z of the body, `weight` its weight times the distance (N m), gravity along -z of the ground.
inline MotionEquations fixed_point_body(Vector3<double> I, double weight) {
  MotionEquations equations;
  equations.position_size = 4;
  equations.velocity_size = 3;
  equations.quaternions = {0};
  const auto up = [](std::span<const double> q) {
    return transpose_times(rotation_matrix(Quaternion<double>{q[0], q[1], q[2], q[3]}), Vector3<double>{0.0, 0.0, 1.0});
  };
  equations.position_rate = [](double, std::span<const double> q, std::span<const double> v, std::span<double> rate) {
    const Quaternion<double> d =
        quaternion_rate(Quaternion<double>{q[0], q[1], q[2], q[3]}, Vector3<double>{v[0], v[1], v[2]});
    rate[0] = d.w;
    rate[1] = d.x;
    rate[2] = d.y;
    rate[3] = d.z;
  };
  equations.accelerations = [I, weight, up](double, std::span<const double> q, std::span<const double> v,
                                            std::span<double> a) {
    const Vector3<double> moment = weight * cross(up(q), Vector3<double>{0.0, 0.0, 1.0});
    a[0] = (moment.x + (I.y - I.z) * v[1] * v[2]) / I.x;
    a[1] = (moment.y + (I.z - I.x) * v[2] * v[0]) / I.y;
    a[2] = (moment.z + (I.x - I.y) * v[0] * v[1]) / I.z;
  };
  equations.conserved.push_back(
      {"energy", [I, weight, up](double, std::span<const double> q, std::span<const double> v) {
         return 0.5 * (I.x * v[0] * v[0] + I.y * v[1] * v[1] + I.z * v[2] * v[2]) + weight * up(q).z;
       }});
  equations.conserved.push_back(
      {"vertical angular momentum", [I, up](double, std::span<const double> q, std::span<const double> v) {
         return dot(up(q), Vector3<double>{I.x * v[0], I.y * v[1], I.z * v[2]});
       }});
  return equations;
}

}  // namespace poinsot
