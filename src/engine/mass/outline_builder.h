// Puts outlines together from flat faces and from profiles that are turned about an axis.
#pragma once

#include <cstdint>
#include <vector>

#include "poinsot/engine/mass/outlines.h"
#include "poinsot/engine/mass/particle_set.h"

namespace poinsot::outlines {

using Triad = cubature::Triad<double>;

// A point of a profile: its distance from the axis, its height on it.
struct ProfilePoint {
  double radius = 0, height = 0;
};
// A smooth part of a profile, with the normal of the surface at each point as (outward from the axis, along it).
struct ProfilePart {
  std::vector<ProfilePoint> points, normals;
};

// Part of a turn about the third direction of a triad, from its first; rad.
struct Turn {
  double from = 0, angle = 0;  // the whole turn if the angle is zero
  int segments = usual_segments;

  bool whole() const { return angle == 0; }
};
// For a part of a turn, as fine as this many segments in a full one.
Turn part_of_turn(double from, double angle, int per_turn);
Turn whole_turn(int per_turn);

class OutlineBuilder {
 public:
  std::uint32_t vertex(const Point& point);
  // A triangle with these normals, turned so that it agrees with them. One without area is left out.
  void triangle(const std::array<std::uint32_t, 3>& corners, const std::array<Point, 3>& normals);
  // A flat convex face by its corners in turn, seen from the side of the normal.
  void face(const std::vector<std::uint32_t>& corners, const Point& normal);
  void edge(std::vector<std::uint32_t> vertices);
  // The surface that the parts leave when they turn about the third direction. Neighbouring parts share the vertices
  // where they meet. Ends of parts are edges if they are marked; `rims` has an entry for the start of each part and one
  // for the end of the last.
  void turned(const Point& center, const Triad& triad, const std::vector<ProfilePart>& parts,
              const std::vector<bool>& rims, const Turn& turn);
  // Vertices on a circle, or part of it. That of a whole turn ends with its first vertex. A circle without radius is
  // one vertex.
  std::vector<std::uint32_t> circle(const Point& center, const Triad& triad, double radius, const Turn& turn);
  Outline finish() { return std::move(outline_); }

 private:
  Outline outline_;
};

// Straight from one point to another, with the normal on the right as one goes up: outward where the solid lies on
// the left.
ProfilePart straight(const ProfilePoint& from, const ProfilePoint& to);
// On a circle about a point of the profile's plane; angles from the outward direction towards the axis, rad.
ProfilePart round(const ProfilePoint& center, double radius, double from, double to, int per_turn);

// The same with all points x moved to center + x.x a + x.y b + x.z c.
Outline mapped(Outline outline, const Point& center, const Point& a, const Point& b, const Point& c);

}  // namespace poinsot::outlines
