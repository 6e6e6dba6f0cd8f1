// Steady precession of a heavy symmetric top (Eq. 18.44) and the stability of its upright position.
#pragma once

#include <vector>

#include "poinsot/engine/motion/closed_form/symmetric_top.h"

namespace poinsot {

// All rates d phi/dt (rad/s, ascending) at which the top precesses steadily at the angle nutation (rad): roots of
// (I w_z - I' p cos(theta)) p = m g c. Two, one (at theta = pi/2, or where they coincide) or none. Each to its own last
// places: the slow one too, which tends to m g c/(I w_z) for fast spins.
std::vector<double> steady_precession_rates(const TopParameters& parameters, double nutation, double axial_rate);
// The same for a given spin d psi/dt: w_z = d psi/dt + p cos(theta).
std::vector<double> steady_precession_rates_of_spin(const TopParameters& parameters, double nutation, double spin_rate);

// The rate w_z (rad/s, not negative) from which on the upright sleeping position is stable: I^2 w_z^2 = 4 I' m g c.
// Zero if the weight does not upset the top; infinite if I = 0 and it does.
double least_sleeping_rate(const TopParameters& parameters);

}  // namespace poinsot
