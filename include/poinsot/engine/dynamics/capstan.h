// A cord that slips on a wheel or post with dry friction.
//
// Over an angle dtheta of the wheel the tension T presses with T dtheta, so that friction changes it by at most
// mu T dtheta (Euler, Eytelwein). Round the angle beta the tensions T behind and T' in front are
//
//   T' = T e^(mu beta) where it slips the way it is led, T' = T e^(-mu beta) where it slips back,
//
// and between the two where it does not slip. With N = T + T' and F = T - T', the friction on the cord the way it is
// led, this is Coulomb's law |F| <= k N with
//
//   k = (e^(mu beta) - 1)/(e^(mu beta) + 1) = tanh(mu beta/2).
//
// The cord is massless: what an arc of it that moves round the wheel would need is nothing beside the tensions.
#pragma once

#include <cmath>
#include <vector>

#include "poinsot/engine/dynamics/cord_span.h"
#include "poinsot/engine/dynamics/mechanism.h"
#include "poinsot/engine/math/algebra/plain.h"
#include "poinsot/engine/math/formula/formula_exponential.h"

namespace poinsot {

// The larger tension over the smaller one where a cord slips: e^(mu beta), of numbers up to what doubles tell apart.
template <class Scalar>
Scalar capstan_ratio(const Scalar& exponent) {
  using std::exp;
  constexpr double most = 40;
  return is_constant(exponent) && plain(exponent) > most ? exp(Scalar(most)) : exp(exponent);
}

// k of the ratio, as of a contact that presses with the sum of both tensions.
template <class Scalar>
Scalar capstan_coefficient(const Scalar& ratio) {
  return (ratio - Scalar(1)) / (ratio + Scalar(1));
}

// By how much the angle round the wheel at the beginning of a straight part is larger than as drawn, within half a turn
// of it, if the part before it goes along `before`. Round a point it is the angle between the two.
template <class Scalar>
Scalar wrap_change(const Model<Scalar>& tree, const Workspace<Scalar>& w, const CordSpan<Scalar>& span,
                   const Vector3<Scalar>& before, const Vector3<Scalar>& along) {
  using std::atan2;
  if (!vanishes(span.from.reach))
    return taken_up(tree, w, span, before, along) / (plain(span.from.reach) > 0 ? span.from.reach : -span.from.reach);
  const Vector3<Scalar> turn = cross(before, along);
  if (vanishes(turn.x) && vanishes(turn.y) && vanishes(turn.z)) return -atan2(span.turn_sine, span.turn_cosine);
  return atan2(norm(turn), dot(before, along)) - atan2(span.turn_sine, span.turn_cosine);
}

// The parts of the tensions of cords that slip, by the angles of this pose.
template <class Scalar>
void update_capstans(Mechanism<Scalar>& mechanism, const Workspace<Scalar>& w) {
  bool slips = false;
  Scalar part(1);
  for (std::size_t k = 0; k < mechanism.components.size(); ++k) {
    Component<Scalar>& component = mechanism.components[k];
    if (component.follows < 0 || !component.span) {
      slips = false;
      part = Scalar(1);
      continue;
    }
    if (!vanishes(component.gain)) {
      slips = true;
      const Vector3<Scalar> before = line_of(mechanism.tree, w, *mechanism.components[k - 1].span).along,
                            along = line_of(mechanism.tree, w, *component.span).along;
      const Scalar exponent =
          component.gain * (component.wrap + wrap_change(mechanism.tree, w, *component.span, before, along));
      part = plain(exponent) < 0 ? part / capstan_ratio(Scalar(-exponent)) : part * capstan_ratio(exponent);
    }
    if (slips) component.part = part;
  }
}

// Whether a cord of the mechanism slips.
template <class Scalar>
bool has_capstans(const Mechanism<Scalar>& mechanism) {
  for (const Component<Scalar>& component : mechanism.components)
    if (!vanishes(component.gain)) return true;
  return false;
}

}  // namespace poinsot
