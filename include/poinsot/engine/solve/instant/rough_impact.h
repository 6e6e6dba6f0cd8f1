// A blow at one contact with dry friction, by Routh's method (Routh, Dynamics of a System of Rigid Bodies, Part 1,
// arts. 187-195; Stronge, Impact Mechanics, ch. 3-5; Batlle, J. Appl. Mech. 60, 978 (1993)).
//
// The normal impulse p grows from zero and takes the place of time. With the impulse P = p n + P_t on the body that
// strikes, the velocity u of its point relative to what it strikes is
//   u = u_0 + W P,                                       W the inverse effective mass at the contact,
// and Coulomb's law holds for its increments: while the point slips,
//   dP_t = -mu d dp,   d the direction of the slip s = u - (u . n) n,     so that  ds/dp = (W (n - mu d))_t,
// along a curve in the plane of slip. Where the slip vanishes the point sticks if the friction that this needs, dP_t =
// a dp with (W (n + a))_t = 0, is within the cone, |a| <= mu; else it slips on in the one direction that then stays, (W
// (n - mu d))_t = k d with k > 0. Compression ends where u . n = 0. Where the blow ends is a hypothesis on restitution,
// by a coefficient e:
//   energetic (Stronge)  the work of the push while the bodies part is -e^2 times that of compression,
//   kinetic (Poisson)    the push while they part is e times that of compression,
//   kinematic (Newton)   u . n is -e times what it was before.
// They agree where the slip keeps one direction, or where W does not couple the push with the slip.
#pragma once

#include <vector>

#include "poinsot/engine/math/algebra/matrix3.h"

namespace poinsot::solve {

enum class RestitutionLaw { energetic, poisson, newton };

struct RoughImpactLaw {
  double restitution = 0, friction = 0;
  RestitutionLaw hypothesis = RestitutionLaw::energetic;
};

// Components here are along the push and two directions across it, in this order.
struct RoughImpactCourse {
  enum class End {
    found,
    wedged,   // friction holds the point in the greatest compression against any rebound
    endless,  // the push grows without end, or the bodies are pressed together a second time
  };
  // A stretch in which the point slips, or sticks to the end.
  struct Stretch {
    bool sticks = false;
    double turned = 0;                  // rad, how far the direction of the slip turns
    Vector3<double> impulse, velocity;  // at its end
    double from_slip = 0;               // angle of the slip in its plane, rad, at the beginning
  };
  End end = End::found;
  std::vector<Stretch> stretches;
  std::vector<Vector3<double>> way;                         // the impulses from one to the next point of the blow
  Vector3<double> impulse, velocity;                        // at the end of the blow
  double compression = 0;                                   // the push up to the greatest compression, N s
  double work_in_compression = 0, work_in_restitution = 0;  // of the push, J
};

// before: the relative velocity; its part along the push is negative. still: a slip below this is none, m/s.
RoughImpactCourse follow_rough_impact(const Matrix3<double>& inverse_mass, const Vector3<double>& before,
                                      const RoughImpactLaw& law, double still);

}  // namespace poinsot::solve
