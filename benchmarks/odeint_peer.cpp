// Boost.odeint, with the right-hand side inlined and the state in an array of fixed size.
#include <boost/numeric/odeint.hpp>

#include "integration_case.h"

namespace poinsot::bench {

namespace odeint = boost::numeric::odeint;

namespace {

template <class Stepper>
Integrator integrator(const char* name) {
  return {name, false, [](const RotationCase& c, double tolerance) {
            RotationNumbers y{c.w.x, c.w.y, c.w.z, 1.0, 0.0, 0.0, 0.0};
            odeint::integrate_adaptive(
                odeint::make_controlled<Stepper>(tolerance, tolerance),
                [&c](const RotationNumbers& state, RotationNumbers& rate, double) { rotation_rates(c, state, rate); },
                y, 0.0, c.end, 1e-3 / (1.0 + norm(c.w)));
            return std::array<double, 4>{y[3], y[4], y[5], y[6]};
          }};
}

}  // namespace

std::vector<Integrator> odeint_integrators() {
  return {integrator<odeint::runge_kutta_dopri5<RotationNumbers>>("odeint dopri5"),
          integrator<odeint::runge_kutta_fehlberg78<RotationNumbers>>("odeint Fehlberg 7(8)")};
}

}  // namespace poinsot::bench
