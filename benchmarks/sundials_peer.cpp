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

int rates(double, N_Vector y, N_Vector rate, void* user) {
  const auto& c = *static_cast<const RotationCase*>(user);
  // The vectors hold their numbers as the right-hand side takes them.
  const auto& from = *reinterpret_cast<const RotationNumbers*>(NV_DATA_S(y));
  auto& to = *reinterpret_cast<RotationNumbers*>(NV_DATA_S(rate));
  rotation_rates(c, from, to);
  return 0;
}

N_Vector start_vector(const RotationCase& c, SUNContext context) {
  const N_Vector y = N_VNew_Serial(7, context);
  const RotationNumbers start{c.w.x, c.w.y, c.w.z, 1.0, 0.0, 0.0, 0.0};
  std::copy(start.begin(), start.end(), NV_DATA_S(y));
  return y;
}

std::array<double, 4> attitude_in(N_Vector y) {
  const double* const q = NV_DATA_S(y) + 3;
  return {q[0], q[1], q[2], q[3]};
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

constexpr std::array<double, 4> failed{NAN, NAN, NAN, NAN};

std::array<double, 4> adams(const RotationCase& c, double tolerance) {
  SUNContext context = new_context();
  N_Vector y = start_vector(c, context);
  void* solver = CVodeCreate(CV_ADAMS, context);
  CVodeInit(solver, &rates, 0.0, y);
  SUNNonlinearSolver iteration = SUNNonlinSol_FixedPoint(y, 0, context);
  CVodeSetNonlinearSolver(solver, iteration);
  CVodeSStolerances(solver, tolerance, tolerance);
  CVodeSetUserData(solver, const_cast<RotationCase*>(&c));
  CVodeSetMaxNumSteps(solver, 10'000'000);
  CVodeSetStopTime(solver, c.end);
  double t = 0.0;
  const int flag = CVode(solver, c.end, y, &t, CV_NORMAL);
  const std::array<double, 4> result = flag >= 0 ? attitude_in(y) : failed;
  SUNNonlinSolFree(iteration);
  CVodeFree(&solver);
  N_VDestroy(y);
  SUNContext_Free(&context);
  return result;
}

std::array<double, 4> fehlberg(const RotationCase& c, double tolerance) {
  SUNContext context = new_context();
  N_Vector y = start_vector(c, context);
  void* solver = ERKStepCreate(&rates, 0.0, y, context);
  ERKStepSetTableNum(solver, ARKODE_FEHLBERG_13_7_8);
  ERKStepSStolerances(solver, tolerance, tolerance);
  ERKStepSetUserData(solver, const_cast<RotationCase*>(&c));
  ERKStepSetMaxNumSteps(solver, 10'000'000);
  ERKStepSetStopTime(solver, c.end);
  double t = 0.0;
  const int flag = ERKStepEvolve(solver, c.end, y, &t, ARK_NORMAL);
  const std::array<double, 4> result = flag >= 0 ? attitude_in(y) : failed;
  ERKStepFree(&solver);
  N_VDestroy(y);
  SUNContext_Free(&context);
  return result;
}

}  // namespace

std::vector<Integrator> sundials_integrators() {
  return {{"CVODE Adams", false, adams}, {"ARKODE Fehlberg 13-7-8", false, fehlberg}};
}

}  // namespace poinsot::bench
