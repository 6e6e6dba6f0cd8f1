// SUNDIALS: CVODE's Adams methods with fixed-point iteration, and ARKODE's explicit Fehlberg 13-7-8.
#include <arkode/arkode_erkstep.h>
#include <cvode/cvode.h>
#include <nvector/nvector_serial.h>
#include <sundials/sundials_context.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

#include <algorithm>
#include <cmath>

#include "integration_case.h"

namespace poinsot::bench {

namespace {

template <class Case>
int rates(double, N_Vector y, N_Vector rate, void* user) {
  static_cast<const Case*>(user)->rates(NV_DATA_S(y), NV_DATA_S(rate));
  return 0;
}

template <class Case>
N_Vector start_vector(const Case& c, SUNContext context) {
  const auto start = c.start();
  const N_Vector y = N_VNew_Serial(static_cast<sunindextype>(start.size()), context);
  std::copy(start.begin(), start.end(), NV_DATA_S(y));
  return y;
}

SUNContext new_context() {
  SUNContext context = nullptr;
#if SUNDIALS_VERSION_MAJOR >= 7
  SUNContext_Create(SUN_COMM_NULL, &context);
#else
  SUNContext_Create(nullptr, &context);
#endif
  return context;
}

constexpr Attitude failed{NAN, NAN, NAN, NAN};

template <class Case>
Attitude adams(const Case& c, double tolerance) {
  SUNContext context = new_context();
  N_Vector y = start_vector(c, context);
  void* solver = CVodeCreate(CV_ADAMS, context);
  CVodeInit(solver, &rates<Case>, 0.0, y);
  SUNNonlinearSolver iteration = SUNNonlinSol_FixedPoint(y, 0, context);
  CVodeSetNonlinearSolver(solver, iteration);
  CVodeSStolerances(solver, tolerance, tolerance);
  CVodeSetUserData(solver, const_cast<Case*>(&c));
  CVodeSetMaxNumSteps(solver, 10'000'000);
  CVodeSetStopTime(solver, c.end);
  double t = 0.0;
  const int flag = CVode(solver, c.end, y, &t, CV_NORMAL);
  const Attitude result = flag >= 0 ? Case::attitude(NV_DATA_S(y)) : failed;
  SUNNonlinSolFree(iteration);
  CVodeFree(&solver);
  N_VDestroy(y);
  SUNContext_Free(&context);
  return result;
}

template <class Case>
Attitude fehlberg(const Case& c, double tolerance) {
  SUNContext context = new_context();
  N_Vector y = start_vector(c, context);
  void* solver = ERKStepCreate(&rates<Case>, 0.0, y, context);
  ERKStepSetTableNum(solver, ARKODE_FEHLBERG_13_7_8);
  ERKStepSStolerances(solver, tolerance, tolerance);
  ERKStepSetUserData(solver, const_cast<Case*>(&c));
  ERKStepSetMaxNumSteps(solver, 10'000'000);
  ERKStepSetStopTime(solver, c.end);
  double t = 0.0;
  const int flag = ERKStepEvolve(solver, c.end, y, &t, ARK_NORMAL);
  const Attitude result = flag >= 0 ? Case::attitude(NV_DATA_S(y)) : failed;
  ERKStepFree(&solver);
  N_VDestroy(y);
  SUNContext_Free(&context);
  return result;
}

}  // namespace

template <class Case>
std::vector<Integrator<Case>> sundials_integrators() {
  return {{"CVODE Adams", false, adams<Case>}, {"ARKODE Fehlberg 13-7-8", false, fehlberg<Case>}};
}
template std::vector<Integrator<RotationCase>> sundials_integrators();
template std::vector<Integrator<ForkCase>> sundials_integrators();

}  // namespace poinsot::bench
