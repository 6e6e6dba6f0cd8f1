// Two curved surfaces that touch as a contact states it: which they are, and whether they can.
#pragma once

#include <optional>

#include "poinsot/engine/dynamics/contact_surface.h"
#include "problem/machine/machine_draft.h"

namespace poinsot::problem {

// On the axes of the two bodies, from their origins; with the ends of the surface of each.
template <class Scalar>
struct TouchingSurfaces {
  CurvedContact<Scalar> surfaces;
  std::optional<ContactLimit::End> end_on, end_from;
  bool along_line = false;  // whether they touch along a line, and are taken to at one point of it
};

// C, S: places on the surfaces of the two bodies, one place unless the contact is open.
// The surfaces of a contact in which one that a body rolls on is curved, or that which rolls is no circle or sphere.
// Nothing where a circle, sphere or corner is on a plane, where the surface of a body is not known, and in letters
// where the place of contact has no closed form. Throws StatementError for surfaces that do not touch as stated.
// The scalar is double, Dual<1> or Formula.
template <class Scalar>
std::optional<TouchingSurfaces<Scalar>> touching_surfaces(MachineDraft<Scalar>& draft, const Contact& contact,
                                                          const Vector3<Scalar>& C, const Vector3<Scalar>& S,
                                                          const Vector3<Scalar>& n);

}  // namespace poinsot::problem
