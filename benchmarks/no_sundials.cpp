// Where SUNDIALS is not installed.
#include "integration_case.h"

namespace poinsot::bench {

std::vector<Integrator> sundials_integrators() { return {}; }

}  // namespace poinsot::bench
