// Whether a point of a body is fixed: what a worked solution may call a fixed point.
#pragma once

#include "poinsot/engine/solve/instant/mechanism_state.h"

namespace poinsot::problem {

// Whether the point of a body that is at a place (m, ground axes) stays there however the mechanism moves from its
// present pose: its velocity vanishes for all velocities that the constraints allow, and so does its acceleration. The
// point of a wheel that touches the road has no velocity either, but an acceleration. Forces are not asked: a contact
// that could open or a cord that could go slack counts as holding. length: a typical length of the mechanism, m.
bool is_held(const solve::MechanismState& state, int body, const Vector3<double>& place, double length);

}  // namespace poinsot::problem
