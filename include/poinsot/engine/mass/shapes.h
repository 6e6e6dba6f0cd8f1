// Every uniform shape whose mass properties have a closed form: shapes::NAME(placement...) -> ShapeProperties, then
// of_mass or of_density. The same names and arguments give particles in poinsot/engine/mass/particles.h and checks in
// poinsot/engine/mass/shape_faults.h.
#pragma once

#include "poinsot/engine/mass/lines.h"
#include "poinsot/engine/mass/plates.h"
#include "poinsot/engine/mass/shells.h"
#include "poinsot/engine/mass/solids.h"
