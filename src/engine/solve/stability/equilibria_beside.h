// The equilibria beside one at rest. Where nothing may slip, bodies that roll rest in more places than one: a plank
// that is shoved along a drum finds its balance at another inclination. With p conditions on positions and p + s on
// velocities, n coordinates have n - p - s equations of equilibrium for n - p ways to be displaced: near an equilibrium
// there is a family of others, of s dimensions unless some of these equations are empty (implicit function theorem).
// Along the family rates vanish, and deviations stay as they are: they say nothing about stability.
#pragma once

#include "engine/solve/stability/same_motion.h"

namespace poinsot::solve {

// Displacements along the family, as columns of coordinates followed by velocities, which are zero; none if more rates
// vanish than such a family explains. A, rows and elsewhere: as for and from same_motion, at rest.
Matrix equilibria_beside(const Doubted& A, const DeviationRows& rows, const Matrix& elsewhere);

}  // namespace poinsot::solve
