// Where SUNDIALS is not installed.
#include "integration_case.h"

namespace poinsot::bench {

template <class Case>
std::vector<Integrator<Case>> sundials_integrators() {
  return {};
}
template std::vector<Integrator<RotationCase>> sundials_integrators();
template std::vector<Integrator<ForkCase>> sundials_integrators();

}  // namespace poinsot::bench
