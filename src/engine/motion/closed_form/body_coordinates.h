// The coordinates by which joints say how one rigid body stands, and the ways between them and its pose.
#pragma once

#include <array>
#include <memory>
#include <span>

#include "poinsot/engine/math/algebra/quaternion.h"
#include "poinsot/engine/math/algebra/spatial.h"

namespace poinsot {

// On the working axes of the body's last joint.
struct BodyPose {
  Quaternion<double> attitude = Quaternion<double>::identity();  // body to ground
  Vector3<double> angular_velocity{};                            // body axes, rad/s
  // Of the mass center of a free body, ground axes: m, m/s. Else without meaning.
  Vector3<double> center{};
  Vector3<double> center_velocity{};
};

// Of a state: coordinates, then velocities.
class BodyCoordinates {
 public:
  virtual ~BodyCoordinates() = default;
  virtual BodyPose read(std::span<const double> state) const = 0;
  // Angles are those nearest to the ones in `before`, quaternions of the nearer sign.
  virtual void write(const BodyPose& pose, std::span<const double> before, std::span<double> state) const = 0;
  // The largest change of an angle, rad; 0 for coordinates that do not wind.
  virtual double turned(std::span<const double>, std::span<const double>) const { return 0; }
  virtual bool winds() const { return false; }
};

// A ball joint: joint_axes are the joint's axes as columns on ground axes; places of q and v in a state.
std::unique_ptr<BodyCoordinates> ball_coordinates(const Matrix3<double>& joint_axes, std::size_t q, std::size_t v);
// A free joint; frame: its joint frame in the ground. center: of mass, on body axes, m.
std::unique_ptr<BodyCoordinates> free_coordinates(const SpatialTransform<double>& frame, const Vector3<double>& center,
                                                  std::size_t q, std::size_t v);

// Two or three angles about axes that meet in a point, each perpendicular to the one before, as those of Euler, Cardan
// and of gimbals. axes: unit vectors on ground axes with all angles zero, attitude that of the body then. Of two angles
// the third axis is the direction in the body whose motion they describe.
struct AxesAtZero {
  std::array<Vector3<double>, 3> axes;
  Matrix3<double> attitude;
};
std::unique_ptr<BodyCoordinates> angle_coordinates(const AxesAtZero& zero, std::span<const std::size_t> q,
                                                   std::span<const std::size_t> v);

}  // namespace poinsot
