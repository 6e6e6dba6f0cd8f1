// The pull of a center on a rigid body, which is the sum of those on its parts.
//
// r u is the way from the center to the mass center C of the part, mu the parameter of the center: the constant of
// gravitation times its mass, m^3/s^2. A particle, or a sphere whose density depends on the distance from its own
// center alone, is pulled as if all its mass m were at C,
//
//   V = -mu m/r,      F = -(mu m/r^2) u.
//
// Of any other part its moments of inertia I about C tell the next terms (MacCullagh), up to the second order of its
// size over the distance:
//
//   V = -mu m/r - mu (tr I - 3 u . I u)/(2 r^3),
//   F = -(mu m/r^2) u - 3 mu/(2 r^4) ((tr I - 5 u . I u) u + 2 I u),      M_C = (3 mu/r^3) u x I u.
//
// F and M_C are the exact slopes of this V, so that the energy that is told is kept. P. C. Hughes, Spacecraft Attitude
// Dynamics (1986), section 8.1; F. P. J. Rimrott, Introductory Attitude Dynamics (1989), chapter 10.
//
// The arms from the origin of the body to its parts are turned by themselves, never taken as differences of places: of
// places that are thousands of kilometres from the ground's origin, so that the couple that the pulls on two ends of a
// body make would be rounding.
#pragma once

#include <vector>

#include "poinsot/engine/dynamics/force_law.h"
#include "poinsot/engine/dynamics/place.h"

namespace poinsot {

template <class Scalar>
struct AttractedPart {
  Vector3<Scalar> center{};  // C from the origin of the body, on its axes, m
  Scalar mass{};
  bool by_moments = false;             // else it is pulled as a particle
  SymmetricMatrix3<Scalar> inertia{};  // about C, on the axes of the body
  double reach = 0;  // no matter of it is farther than this from C, m; nearer to the center nothing holds
};

template <class Scalar>
struct AttractionLaw {
  int action = 0;
  Place<Scalar> at;      // the mass center of the body
  Place<Scalar> toward;  // the center
  Scalar parameter{};
  std::vector<AttractedPart<Scalar>> parts;

  // At the origin of the body.
  PlacedForce<Scalar> exerted(const Model<Scalar>& tree, const Workspace<Scalar>& w) const {
    const Vector3<Scalar> none = Vector3<Scalar>::zero();
    PlacedForce<Scalar> sum{w.motion[static_cast<std::size_t>(at.body + 1)].p, none, none};
    for (const AttractedPart<Scalar>& part : parts) {
      const Line line = line_of(tree, w, part);
      const Scalar by_mass = parameter / (line.distance * line.distance);
      Vector3<Scalar> force = -(by_mass * part.mass) * line.out;
      if (part.by_moments) {
        const Scalar fall = Scalar(1.5) * by_mass / (line.distance * line.distance);
        const Vector3<Scalar> I_u = inertia_along(tree, w, part, line.out);
        const Scalar along = trace_of(part.inertia) - Scalar(5) * dot(line.out, I_u);
        force = force - (fall * along) * line.out - (Scalar(2) * fall) * I_u;
        sum.couple = sum.couple + (Scalar(3) * by_mass / line.distance) * cross(line.out, I_u);
      }
      sum.force = sum.force + force;
      sum.couple = sum.couple + cross(line.arm, force);
    }
    return sum;
  }
  Scalar stored_energy(const Model<Scalar>& tree, const Workspace<Scalar>& w) const {
    Scalar energy(0);
    for (const AttractedPart<Scalar>& part : parts) {
      const Line line = line_of(tree, w, part);
      const Scalar near = parameter / line.distance;
      energy = energy - near * part.mass;
      if (!part.by_moments) continue;
      const Scalar across = trace_of(part.inertia) - Scalar(3) * dot(line.out, inertia_along(tree, w, part, line.out));
      energy = energy - near * across / (Scalar(2) * line.distance * line.distance);
    }
    return energy;
  }
  Scalar unstored_power(const Model<Scalar>&, const Workspace<Scalar>&, int, int) const { return Scalar(0); }
  bool feeds() const { return false; }
  bool drains() const { return false; }
  bool stores() const { return true; }

  // From the center to a part, on ground axes. After update_poses.
  Vector3<Scalar> way_to(const Model<Scalar>& tree, const Workspace<Scalar>& w,
                         const AttractedPart<Scalar>& part) const {
    return w.motion[static_cast<std::size_t>(at.body + 1)].p - point_position(tree, w, toward.body, toward.point) +
           direction_on_ground(tree, w, at.body, part.center);
  }

  template <class Target, class Convert>
  AttractionLaw<Target> converted(const Convert& to) const {
    AttractionLaw<Target> law{action, to(at), to(toward), to(parameter), {}};
    for (const AttractedPart<Scalar>& part : parts)
      law.parts.push_back({to(part.center), to(part.mass), part.by_moments, to(part.inertia), part.reach});
    return law;
  }

 private:
  struct Line {
    Vector3<Scalar> arm, out;  // from the body's origin; from the center. On ground axes
    Scalar distance;
  };
  Line line_of(const Model<Scalar>& tree, const Workspace<Scalar>& w, const AttractedPart<Scalar>& part) const {
    Line line;
    line.arm = direction_on_ground(tree, w, at.body, part.center);
    const Vector3<Scalar> way = way_to(tree, w, part);
    line.distance = norm(way);
    line.out = way / line.distance;
    return line;
  }
  // I u, on ground axes.
  Vector3<Scalar> inertia_along(const Model<Scalar>& tree, const Workspace<Scalar>& w,
                                const AttractedPart<Scalar>& part, const Vector3<Scalar>& u) const {
    return direction_on_ground(tree, w, at.body, part.inertia * direction_on_body(tree, w, at.body, u));
  }
  static Scalar trace_of(const SymmetricMatrix3<Scalar>& I) { return I.xx + I.yy + I.zz; }
};

}  // namespace poinsot
