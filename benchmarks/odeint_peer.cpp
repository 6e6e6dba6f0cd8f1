// Boost.odeint, with the right-hand side inlined and the state in an array of fixed size.
#include <boost/numeric/odeint.hpp>

#include "integration_case.h"

namespace poinsot::bench {

namespace odeint = boost::numeric::odeint;

namespace {

template <class Case, class Stepper>
Integrator<Case> integrator(const char* name) {
  return {name, false, [](const Case& c, double tolerance) {
            using Numbers = typename Case::Numbers;
            Numbers y = c.start();
            odeint::integrate_adaptive(
                odeint::make_controlled<Stepper>(tolerance, tolerance),
                [&c](const Numbers& state, Numbers& rate, double) { c.rates(state.data(), rate.data()); }, y, 0.0,
                c.end, c.first_step());
            return Case::attitude(y.data());
          }};
}

}  // namespace

template <class Case>
std::vector<Integrator<Case>> odeint_integrators() {
  using Numbers = typename Case::Numbers;
  return {integrator<Case, odeint::runge_kutta_dopri5<Numbers>>("odeint dopri5"),
          integrator<Case, odeint::runge_kutta_fehlberg78<Numbers>>("odeint Fehlberg 7(8)")};
}
template std::vector<Integrator<RotationCase>> odeint_integrators();
template std::vector<Integrator<ForkCase>> odeint_integrators();

}  // namespace poinsot::bench
