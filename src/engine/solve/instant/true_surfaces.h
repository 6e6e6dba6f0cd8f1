// Where two shapes touch, from the equations of their surfaces: a second road to what dynamics/contact_surface.h finds
// by normals and support points.
//
// A surface is F(x) = 0 with F > 0 outside it; a point, a circle and a straight line are curves x(s). Two shapes come
// nearest where F of the one is stationary on the other,
//
//   on a surface:  grad F = m grad G,  G = 0        on a curve:  grad F . dx/ds = 0,
//
// and they touch if F vanishes there; F / |grad F| is the gap, to first order. Normal curvatures are those of the
// equations as well: t . H t / |grad F|, with the matrix H of second derivatives.
#pragma once

#include <optional>

#include "engine/solve/instant/drawn_motion.h"
#include "poinsot/engine/dynamics/contact_surface.h"

namespace poinsot::solve::drawn {

struct NearestPlace {
  Vector point, normal;  // the normal points into `on`
  Real gap;              // positive where the two are apart
};

// Nothing for two curves, and where Newton's method does not come to the place from its guess.
std::optional<NearestPlace> nearest_place(const ContactSurface<Real>& on, const ContactSurface<Real>& from,
                                          const Vector& guess);

// The guess, which the equations above then prove: where the solver sees the two.
Vector place_of_solver(const ContactSurface<Real>& on, const ContactSurface<Real>& from, double branch);

}  // namespace poinsot::solve::drawn
