// Newton-Euler equations in redundant coordinates, as an oracle for the algorithms of the dynamics room.
//
// Unknown are the six accelerations of every body, the six components of every joint's reaction and the accelerations
// of all joint coordinates, in one dense linear system on ground axes: 6 equations of motion per body, 6 kinematic
// equations per joint, and per coordinate either its force or its acceleration. Kinematics is written here anew, with
// Eigen, on the bodies' own frames; nothing is shared with the engine but the statement of the tree.
#pragma once

#include <Eigen/Dense>
#include <vector>

#include "engine/dynamics/random_trees.h"

namespace poinsot::testing {

inline Eigen::Vector3d eigen(const Vector3<double>& a) { return {a.x, a.y, a.z}; }
inline Eigen::Matrix3d eigen(const Matrix3<double>& a) {
  Eigen::Matrix3d b;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) b(i, j) = a(static_cast<std::size_t>(i), static_cast<std::size_t>(j));
  }
  return b;
}
inline Eigen::Matrix3d eigen(const SymmetricMatrix3<double>& a) { return eigen(as_matrix(a)); }
inline Eigen::Matrix3d skew(const Eigen::Vector3d& a) {
  Eigen::Matrix3d b;
  b << 0, -a.z(), a.y(), a.z(), 0, -a.x(), -a.y(), a.x(), 0;
  return b;
}

struct OracleBody {
  Eigen::Matrix3d R = Eigen::Matrix3d::Identity();  // body axes to ground axes
  Eigen::Vector3d p = Eigen::Vector3d::Zero();      // origin
  Eigen::Vector3d w = Eigen::Vector3d::Zero();
  Eigen::Vector3d v = Eigen::Vector3d::Zero();  // of the origin
  Eigen::Matrix<double, 6, Eigen::Dynamic> S;   // joint motion per coordinate, angular above linear, at the origin
  Eigen::Matrix<double, 6, 1> bias =
      Eigen::Matrix<double, 6, 1>::Zero();  // accelerations relative to the parent's point while nothing accelerates
  Eigen::Vector3d alpha = Eigen::Vector3d::Zero();
  Eigen::Vector3d a = Eigen::Vector3d::Zero();
  Eigen::Vector3d n = Eigen::Vector3d::Zero();  // reaction of the parent about the origin
  Eigen::Vector3d f = Eigen::Vector3d::Zero();
};

struct OracleResult {
  std::vector<OracleBody> bodies;
  std::vector<double> acceleration;
  std::vector<double> force;
};

// Poses and velocities.
inline std::vector<OracleBody> oracle_motion(const StatedTree& tree, const State<double>& state) {
  std::vector<OracleBody> bodies;
  std::size_t q = 0;
  int v = 0;
  for (const StatedBody& stated : tree.bodies) {
    OracleBody parent;
    if (stated.parent != ground) parent = bodies[static_cast<std::size_t>(stated.parent)];
    const Eigen::Matrix3d R_F = parent.R * eigen(stated.placement.R);
    const Eigen::Vector3d p_F = parent.p + parent.R * eigen(stated.placement.p);
    const Eigen::Vector3d axis_F = eigen(stated.joint.axis).normalized();
    const Eigen::Vector3d axis = R_F * axis_F;
    OracleBody body;
    body.R = R_F;
    body.p = p_F;
    const int count = velocity_size(stated.joint.type);
    body.S.setZero(6, count);
    switch (stated.joint.type) {
      case JointType::weld:
        break;
      case JointType::revolute:
        body.R = R_F * Eigen::AngleAxisd(state.q[q], axis_F).toRotationMatrix();
        body.S.col(0).head<3>() = axis;
        break;
      case JointType::prismatic:
        body.p = p_F + state.q[q] * axis;
        body.S.col(0).tail<3>() = axis;
        break;
      case JointType::screw:
        body.R = R_F * Eigen::AngleAxisd(state.q[q], axis_F).toRotationMatrix();
        body.p = p_F + stated.joint.pitch * state.q[q] * axis;
        body.S.col(0) << axis, stated.joint.pitch * axis;
        break;
      case JointType::free:
        body.p = p_F + R_F * Eigen::Vector3d(state.q[q + 4], state.q[q + 5], state.q[q + 6]);
        [[fallthrough]];
      case JointType::ball:
        body.R =
            R_F * Eigen::Quaterniond(state.q[q], state.q[q + 1], state.q[q + 2], state.q[q + 3]).toRotationMatrix();
        body.S.block<3, 3>(0, 0) = body.R;
        if (count == 6) body.S.block<3, 3>(3, 3) = body.R;
        break;
    }
    Eigen::Matrix<double, 6, 1> relative = Eigen::Matrix<double, 6, 1>::Zero();
    for (int k = 0; k < count; ++k) relative += body.S.col(k) * state.v[static_cast<std::size_t>(v + k)];
    const Eigen::Vector3d w_J = relative.head<3>();
    const Eigen::Vector3d v_J = relative.tail<3>();
    const Eigen::Vector3d r = body.p - parent.p;
    body.w = parent.w + w_J;
    body.v = parent.v + parent.w.cross(r) + v_J;
    // Coriolis and centripetal parts; the columns of S of a free joint turn with the body, the axes of the others with
    // the parent.
    body.bias.head<3>() = parent.w.cross(w_J);
    body.bias.tail<3>() = parent.w.cross(parent.w.cross(r)) + 2.0 * parent.w.cross(v_J);
    if (stated.joint.type == JointType::free) body.bias.tail<3>() += w_J.cross(v_J);
    bodies.push_back(body);
    q += static_cast<std::size_t>(position_size(stated.joint.type));
    v += count;
  }
  return bodies;
}

// modes, given: per coordinate; given is the force of a free coordinate, the acceleration of a prescribed one.
// external: per body a wrench on body axes about the body's origin.
inline OracleResult oracle_dynamics(const StatedTree& tree, const State<double>& state,
                                    const std::vector<CoordinateMode>& modes, const std::vector<double>& given_force,
                                    const std::vector<double>& given_acceleration,
                                    const std::vector<SpatialForce<double>>& external) {
  OracleResult result;
  result.bodies = oracle_motion(tree, state);
  const int count = static_cast<int>(tree.bodies.size());
  const int coordinates = static_cast<int>(modes.size());
  const int size = 12 * count + coordinates;
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(size, size);
  Eigen::VectorXd b = Eigen::VectorXd::Zero(size);
  const auto alpha = [](int i) { return 12 * i; };
  const auto acceleration = [](int i) { return 12 * i + 3; };
  const auto moment = [](int i) { return 12 * i + 6; };
  const auto force = [](int i) { return 12 * i + 9; };
  const Eigen::Matrix3d one = Eigen::Matrix3d::Identity();
  int v = 0;
  for (int i = 0; i < count; ++i) {
    const StatedBody& stated = tree.bodies[static_cast<std::size_t>(i)];
    const OracleBody& body = result.bodies[static_cast<std::size_t>(i)];
    const double m = stated.mass.mass;
    const Eigen::Vector3d r = body.R * eigen(stated.mass.center);
    const Eigen::Matrix3d I_G = body.R * eigen(stated.mass.inertia_center) * body.R.transpose();
    // m (a + alpha x r + w x (w x r)) = f + external + m g - reactions of the children.
    const int newton = 12 * i;
    A.block<3, 3>(newton, acceleration(i)) += m * one;
    A.block<3, 3>(newton, alpha(i)) -= m * skew(r);
    A.block<3, 3>(newton, force(i)) -= one;
    Eigen::Vector3d load = m * eigen(tree.gravity) - m * body.w.cross(body.w.cross(r));
    Eigen::Vector3d couple = -body.w.cross(I_G * body.w);
    if (!external.empty()) {
      const Eigen::Vector3d external_force = body.R * eigen(external[static_cast<std::size_t>(i)].force);
      load += external_force;
      couple += body.R * eigen(external[static_cast<std::size_t>(i)].moment) - r.cross(external_force);
    }
    b.segment<3>(newton) += load;
    // I_G alpha + w x I_G w = n - r x f + ...
    A.block<3, 3>(newton + 3, alpha(i)) += I_G;
    A.block<3, 3>(newton + 3, moment(i)) -= one;
    A.block<3, 3>(newton + 3, force(i)) += skew(r);
    b.segment<3>(newton + 3) += couple;
    if (stated.parent != ground) {
      const StatedBody& stated_parent = tree.bodies[static_cast<std::size_t>(stated.parent)];
      const OracleBody& parent = result.bodies[static_cast<std::size_t>(stated.parent)];
      const Eigen::Vector3d p_G = parent.p + parent.R * eigen(stated_parent.mass.center);
      const int newton_parent = 12 * stated.parent;
      A.block<3, 3>(newton_parent, force(i)) += one;
      A.block<3, 3>(newton_parent + 3, moment(i)) += one;
      A.block<3, 3>(newton_parent + 3, force(i)) += skew(body.p - p_G);
    }
    // alpha - alpha_parent = bias + S qdd; a - a_parent - alpha_parent x r = bias + S qdd.
    const int kinematic = 12 * i + 6;
    A.block<3, 3>(kinematic, alpha(i)) += one;
    A.block<3, 3>(kinematic + 3, acceleration(i)) += one;
    if (stated.parent != ground) {
      const OracleBody& parent = result.bodies[static_cast<std::size_t>(stated.parent)];
      A.block<3, 3>(kinematic, alpha(stated.parent)) -= one;
      A.block<3, 3>(kinematic + 3, acceleration(stated.parent)) -= one;
      A.block<3, 3>(kinematic + 3, alpha(stated.parent)) += skew(body.p - parent.p);
    }
    b.segment<6>(kinematic) += body.bias;
    for (int k = 0; k < body.S.cols(); ++k) {
      const int column = 12 * count + v + k;
      A.block<6, 1>(kinematic, column) -= body.S.col(k);
      const std::size_t coordinate = static_cast<std::size_t>(v + k);
      if (modes[coordinate] == CoordinateMode::free) {
        A.block<1, 6>(column, moment(i)) = body.S.col(k).transpose();
        b(column) = given_force[coordinate];
      } else {
        A(column, column) = 1.0;
        b(column) = modes[coordinate] == CoordinateMode::locked ? 0.0 : given_acceleration[coordinate];
      }
    }
    v += static_cast<int>(body.S.cols());
  }
  const Eigen::PartialPivLU<Eigen::MatrixXd> lu(A);
  Eigen::VectorXd x = lu.solve(b);
  x += lu.solve(b - A * x);
  v = 0;
  for (int i = 0; i < count; ++i) {
    OracleBody& body = result.bodies[static_cast<std::size_t>(i)];
    body.alpha = x.segment<3>(alpha(i));
    body.a = x.segment<3>(acceleration(i));
    body.n = x.segment<3>(moment(i));
    body.f = x.segment<3>(force(i));
    for (int k = 0; k < body.S.cols(); ++k) {
      result.acceleration.push_back(x(12 * count + v + k));
      result.force.push_back(body.S.col(k).head<3>().dot(body.n) + body.S.col(k).tail<3>().dot(body.f));
    }
    v += static_cast<int>(body.S.cols());
  }
  return result;
}

}  // namespace poinsot::testing
