// Builds a Model body by body, with checks that stay on.
#pragma once

#include <cmath>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "poinsot/engine/mass/mass_properties.h"
#include "poinsot/engine/math/algebra/scalar.h"
#include "poinsot/engine/model/model.h"

namespace poinsot {

template <class Scalar>
class ModelBuilder {
 public:
  // Adds a body and returns its index. parent: an index returned before, or ground. placement: the joint frame in the
  // parent's body frame; the body's frame lies on it in the neutral position. mass: on the body's frame. All velocity
  // coordinates of the joint get the mode.
  // Errors: std::invalid_argument naming the body, if the name is empty or taken, the parent unknown, the axis zero, a
  // number not finite, the placement no rotation, or the mass or a moment of inertia negative.
  int add_body(std::string name, int parent, const Joint<Scalar>& joint, const SpatialTransform<Scalar>& placement,
               const MassProperties<Scalar>& mass, CoordinateMode mode = CoordinateMode::free) {
    check_name(name, parent);
    check_joint(name, joint);
    check_placement(name, placement);
    check_mass(name, mass);

    Body<Scalar> body;
    body.joint = joint.type;
    body.parent = parent;
    body.q = position_size_;
    body.v = static_cast<int>(modes_.size());
    body.pitch = joint.pitch;

    // Working axes: z along the joint's axis. R_BW takes working components to body components.
    const bool has_axis =
        joint.type == JointType::revolute || joint.type == JointType::prismatic || joint.type == JointType::screw;
    const Matrix3<Scalar> R_BW = has_axis ? axes_with_z_along(normalized(joint.axis)) : Matrix3<Scalar>::identity();
    body.R_WB = transpose(R_BW);
    const Matrix3<Scalar> R_WB_parent = parent == ground ? Matrix3<Scalar>::identity() : bodies_[parent].R_WB;
    body.placement = {R_WB_parent * placement.R * R_BW, R_WB_parent * placement.p};

    body.inertia = turned(body.R_WB, SpatialInertia<Scalar>::of(mass.mass, mass.center, mass.inertia_center));
    const SymmetricMatrix3<Scalar>& I = body.inertia.inertia;
    const Scalar half_trace = Scalar(0.5) * (I.xx + I.yy + I.zz);
    body.second_moment = SymmetricMatrix3<Scalar>::diagonal(half_trace, half_trace, half_trace) - I;

    position_size_ += poinsot::position_size(joint.type);
    modes_.insert(modes_.end(), static_cast<std::size_t>(poinsot::velocity_size(joint.type)), mode);
    bodies_.push_back(std::move(body));
    names_.push_back(std::move(name));
    return static_cast<int>(bodies_.size()) - 1;
  }
  // The same, where the parent is given by its name ("ground" for the ground).
  int add_body(std::string name, std::string_view parent, const Joint<Scalar>& joint,
               const SpatialTransform<Scalar>& placement, const MassProperties<Scalar>& mass,
               CoordinateMode mode = CoordinateMode::free) {
    const int carrier = index_of(name, parent);
    return add_body(std::move(name), carrier, joint, placement, mass, mode);
  }

  // A body on a universal joint, which turns about first_axis and then about second_axis, which first_axis carries
  // along. The massless body between them is named name + ".1". The functions below return the index of the last body
  // too.
  int add_universal(const std::string& name, int parent, const Vector3<Scalar>& first_axis,
                    const Vector3<Scalar>& second_axis, const SpatialTransform<Scalar>& placement,
                    const MassProperties<Scalar>& mass) {
    return add_chain(name, parent, {Joint<Scalar>::revolute(first_axis), Joint<Scalar>::revolute(second_axis)},
                     placement, mass);
  }
  // A body that slides along an axis and turns about it.
  int add_cylindrical(const std::string& name, int parent, const Vector3<Scalar>& axis,
                      const SpatialTransform<Scalar>& placement, const MassProperties<Scalar>& mass) {
    return add_chain(name, parent, {Joint<Scalar>::prismatic(axis), Joint<Scalar>::revolute(axis)}, placement, mass);
  }
  // A body that slides along two directions and turns about a third one.
  int add_planar(const std::string& name, int parent, const Vector3<Scalar>& first_direction,
                 const Vector3<Scalar>& second_direction, const Vector3<Scalar>& normal,
                 const SpatialTransform<Scalar>& placement, const MassProperties<Scalar>& mass) {
    return add_chain(name, parent,
                     {Joint<Scalar>::prismatic(first_direction), Joint<Scalar>::prismatic(second_direction),
                      Joint<Scalar>::revolute(normal)},
                     placement, mass);
  }
  // A body on a chain of joints at one place, with massless bodies name.1, name.2, ... between them.
  int add_chain(const std::string& name, int parent, const std::vector<Joint<Scalar>>& joints,
                const SpatialTransform<Scalar>& placement, const MassProperties<Scalar>& mass) {
    if (joints.empty()) throw std::invalid_argument("body '" + name + "': its chain of joints is empty");
    const MassProperties<Scalar> massless{Scalar(0), Vector3<Scalar>::zero(), SymmetricMatrix3<Scalar>::zero()};
    for (std::size_t k = 0; k + 1 < joints.size(); ++k) {
      parent = add_body(name + "." + std::to_string(k + 1), parent, joints[k],
                        k == 0 ? placement : SpatialTransform<Scalar>::identity(), massless);
    }
    return add_body(name, parent, joints.back(), joints.size() == 1 ? placement : SpatialTransform<Scalar>::identity(),
                    mass);
  }

  // Sets the mode of one velocity coordinate of a body's joint (0 is its first).
  void set_mode(int body, int coordinate, CoordinateMode mode) {
    if (body < 0 || body >= static_cast<int>(bodies_.size())) {
      throw std::invalid_argument("set_mode: there is no body " + std::to_string(body));
    }
    const int count = poinsot::velocity_size(bodies_[body].joint);
    if (coordinate < 0 || coordinate >= count) {
      throw std::invalid_argument("body '" + names_[body] + "': its joint has " + std::to_string(count) +
                                  " velocity coordinates, there is no coordinate " + std::to_string(coordinate));
    }
    modes_[bodies_[body].v + coordinate] = mode;
  }
  // Sets the acceleration of free fall on ground axes, m/s^2. It is zero unless set.
  void set_gravity(const Vector3<Scalar>& gravity) {
    if (!finite(gravity)) throw std::invalid_argument("set_gravity: the gravity is not finite");
    gravity_ = gravity;
  }

  Model<Scalar> build() const { return Model<Scalar>(bodies_, names_, modes_, gravity_); }

 private:
  static bool finite(const Scalar& x) {
    return every_value(x, [](double value) { return std::isfinite(value); });
  }
  static bool finite(const Vector3<Scalar>& a) { return finite(a.x) && finite(a.y) && finite(a.z); }
  static bool within(const Scalar& x, double low, double high) {
    return every_value(x, [low, high](double value) { return value >= low && value <= high; });
  }
  [[noreturn]] static void refuse(const std::string& name, const std::string& why) {
    throw std::invalid_argument("body '" + name + "': " + why);
  }

  int index_of(const std::string& name, std::string_view parent) const {
    if (parent == "ground") return ground;
    for (std::size_t i = 0; i < names_.size(); ++i) {
      if (names_[i] == parent) return static_cast<int>(i);
    }
    refuse(name, "its parent '" + std::string(parent) + "' is unknown; add the parent first");
  }
  void check_name(const std::string& name, int parent) const {
    if (name.empty()) throw std::invalid_argument("body number " + std::to_string(names_.size()) + " has no name");
    if (name == "ground") refuse(name, "this name is kept for the ground");
    for (const std::string& other : names_) {
      if (other == name) refuse(name, "the name is taken by another body");
    }
    if (parent < ground || parent >= static_cast<int>(bodies_.size())) {
      refuse(name, "its parent " + std::to_string(parent) +
                       " is unknown; expected ground or a body added before (0 to " +
                       std::to_string(static_cast<int>(bodies_.size()) - 1) + ")");
    }
  }
  static void check_joint(const std::string& name, const Joint<Scalar>& joint) {
    if (joint.type == JointType::weld || joint.type == JointType::ball || joint.type == JointType::free) return;
    if (!finite(joint.axis)) refuse(name, "the axis of its joint is not finite");
    const auto positive = [](double value) { return value > 0.0; };
    if (!every_value(norm_squared(joint.axis), positive)) refuse(name, "the axis of its joint has length zero");
    if (!finite(joint.pitch)) refuse(name, "the pitch of its joint is not finite");
  }
  static void check_placement(const std::string& name, const SpatialTransform<Scalar>& placement) {
    if (!finite(placement.p)) refuse(name, "the place of its joint is not finite");
    const Matrix3<Scalar> E = transpose(placement.R) * placement.R - Matrix3<Scalar>::identity();
    constexpr double tolerance = 1e-9;
    bool rotation = within(determinant(placement.R), 0.5, 1.5);
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) rotation = rotation && within(E(i, j), -tolerance, tolerance);
    }
    if (!rotation) refuse(name, "the axes of its joint frame are not right-handed, orthogonal unit vectors (to 1e-9)");
  }
  static void check_mass(const std::string& name, const MassProperties<Scalar>& mass) {
    const auto not_negative = [](double value) { return value >= 0.0; };
    const SymmetricMatrix3<Scalar>& I = mass.inertia_center;
    if (!finite(mass.mass) || !finite(mass.center) || !finite(Vector3<Scalar>{I.xx, I.yy, I.zz}) ||
        !finite(Vector3<Scalar>{I.xy, I.yz, I.zx})) {
      refuse(name, "its mass properties are not finite");
    }
    if (!every_value(mass.mass, not_negative)) refuse(name, "its mass is negative");
    // The moment of particles on a line about this line is nothing but rounding.
    const Scalar rounding = Scalar(1e-12) * (I.xx + I.yy + I.zz + mass.mass * norm_squared(mass.center));
    if (!every_value(I.xx + rounding, not_negative) || !every_value(I.yy + rounding, not_negative) ||
        !every_value(I.zz + rounding, not_negative)) {
      refuse(name, "a moment of inertia about its mass center is negative");
    }
  }

  std::vector<Body<Scalar>> bodies_;
  std::vector<std::string> names_;
  std::vector<CoordinateMode> modes_;
  Vector3<Scalar> gravity_ = Vector3<Scalar>::zero();
  int position_size_ = 0;
};

}  // namespace poinsot
