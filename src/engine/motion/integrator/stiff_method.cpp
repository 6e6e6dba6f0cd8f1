// Stiff equations: the variable-order backward differentiation formulas of CVODE (SUNDIALS), with dense Jacobians by
// differences, projection onto constraints within the method, and its interpolating polynomial as dense output.
#include "engine/motion/integrator/methods.h"
#include "poinsot/engine/motion/integrator/integrate.h"

#ifdef POINSOT_HAS_SUNDIALS

#include <cvode/cvode.h>
#include <nvector/nvector_serial.h>
#include <sundials/sundials_context.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>
#include <new>
#include <type_traits>
#include <utility>
#include <vector>

namespace poinsot {

namespace {

template <auto Free>
struct Freer {
  template <class Pointer>
  void operator()(Pointer* p) const {
    Free(p);
  }
};
void free_context(SUNContext context) { SUNContext_Free(&context); }
void free_solver(void* memory) { CVodeFree(&memory); }
void free_linear(SUNLinearSolver solver) { SUNLinSolFree(solver); }

using Context = std::unique_ptr<std::remove_pointer_t<SUNContext>, Freer<free_context>>;
using Vector = std::unique_ptr<std::remove_pointer_t<N_Vector>, Freer<N_VDestroy>>;
using Matrix = std::unique_ptr<std::remove_pointer_t<SUNMatrix>, Freer<SUNMatDestroy>>;
using Linear = std::unique_ptr<std::remove_pointer_t<SUNLinearSolver>, Freer<free_linear>>;
using Solver = std::unique_ptr<void, Freer<free_solver>>;

Context new_context() {
  SUNContext context = nullptr;
#if SUNDIALS_VERSION_MAJOR >= 7
  SUNContext_Create(SUN_COMM_NULL, &context);
  if (context) SUNContext_ClearErrHandlers(context);
#else
  SUNContext_Create(nullptr, &context);
#endif
  if (!context) throw std::bad_alloc();
  return Context(context);
}

class BackwardDifferentiation final : public StepMethod {
 public:
  BackwardDifferentiation(RightSide& right_side, const ErrorScale& scale, double first, double largest)
      : right_side_(right_side),
        scale_(scale),
        n_(static_cast<std::size_t>(right_side.size())),
        first_(first),
        largest_(largest),
        context_(new_context()),
        y_(N_VNew_Serial(static_cast<sunindextype>(n_), context_.get())),
        derivative_(N_VNew_Serial(static_cast<sunindextype>(n_), context_.get())),
        jacobian_(SUNDenseMatrix(static_cast<sunindextype>(n_), static_cast<sunindextype>(n_), context_.get())),
        linear_(SUNLinSol_Dense(y_.get(), jacobian_.get(), context_.get())),
        state_(n_),
        projected_(n_) {}

  StepOutcome begin(double t, std::span<const double> y, double limit) override {
    std::copy(y.begin(), y.end(), values(y_.get()));
    std::copy(y.begin(), y.end(), state_.begin());
    t_ = t;
    if (right_side_(t, y, {values(derivative_.get()), n_}) == false) return StepOutcome::not_finite;
    if (limit == t) return StepOutcome::advanced;
    solver_.reset(CVodeCreate(CV_BDF, context_.get()));
    void* const solver = solver_.get();
    bool good = solver && CVodeInit(solver, &rates, t, y_.get()) == CV_SUCCESS;
#if SUNDIALS_VERSION_MAJOR < 7
    good = good && CVodeSetErrFile(solver, nullptr) == CV_SUCCESS;
#endif
    good = good && CVodeSetUserData(solver, this) == CV_SUCCESS && CVodeWFtolerances(solver, &weights) == CV_SUCCESS &&
           CVodeSetLinearSolver(solver, linear_.get(), jacobian_.get()) == CV_SUCCESS &&
           CVodeSetProjFn(solver, &projection) == CV_SUCCESS && CVodeSetStopTime(solver, limit) == CV_SUCCESS &&
           CVodeSetMaxNumSteps(solver, -1) == CV_SUCCESS;
    // Errors of the projection are errors of the step all the same.
    good = good && CVodeSetProjErrEst(solver, false) == CV_SUCCESS;
    if (first_ > 0.0) good = good && CVodeSetInitStep(solver, std::copysign(first_, limit - t)) == CV_SUCCESS;
    // Steps of some fifty units in the last place of the time never end: they are a failure.
    const double shortest = 1e-14 * std::max({std::fabs(t), std::fabs(limit), std::fabs(limit - t)});
    good = good && CVodeSetMinStep(solver, std::min(shortest, std::fabs(limit - t))) == CV_SUCCESS;
    if (largest_ > 0.0) good = good && CVodeSetMaxStep(solver, largest_) == CV_SUCCESS;
    if (!good) throw std::bad_alloc();
    return StepOutcome::advanced;
  }

  StepOutcome advance(double limit) override {
    if (restart_) {
      restart_ = false;
      std::copy(state_.begin(), state_.end(), values(y_.get()));
      if (CVodeReInit(solver_.get(), t_, y_.get()) != CV_SUCCESS ||
          CVodeSetStopTime(solver_.get(), limit) != CV_SUCCESS)
        return StepOutcome::too_small;
    }
    met_not_finite_ = false;
    start_ = t_;
    double reached = t_;
    const int flag = CVode(solver_.get(), limit, y_.get(), &reached, CV_ONE_STEP);
    if (failure_) std::rethrow_exception(std::exchange(failure_, nullptr));
    if (flag < 0) {
      if (met_not_finite_) return StepOutcome::not_finite;
      return flag == CV_CONV_FAILURE || flag == CV_LSETUP_FAIL || flag == CV_LSOLVE_FAIL ? StepOutcome::no_convergence
                                                                                         : StepOutcome::too_small;
    }
    t_ = reached;
    std::copy(values(y_.get()), values(y_.get()) + n_, state_.begin());
    dense_is_ready_ = false;
    return StepOutcome::advanced;
  }

  double time() const override { return t_; }
  std::span<double> state() override { return state_; }
  // The method has projected already: only a change that matters is worth starting anew at order 1.
  void state_changed(bool noticeably) override {
    if (!noticeably) return;
    const std::span<const double> allowed = scale_.allowed();
    for (std::size_t i = 0; i < n_; ++i) {
      if (std::fabs(state_[i] - values(y_.get())[i]) > allowed[i]) restart_ = true;
    }
  }

  StepView last_step() override {
    if (!dense_is_ready_) {
      // The Taylor coefficients at the start of the interpolating polynomial.
      int order = 1;
      CVodeGetLastOrder(solver_.get(), &order);
      dense_.resize(static_cast<std::size_t>(order + 1) * n_);
      double factor = 1.0;
      for (int k = 0; k <= order; ++k) {
        if (k > 0) factor *= (t_ - start_) / k;
        CVodeGetDky(solver_.get(), start_, k, derivative_.get());
        for (std::size_t i = 0; i < n_; ++i)
          dense_[static_cast<std::size_t>(k) * n_ + i] = factor * values(derivative_.get())[i];
      }
      dense_is_ready_ = true;
    }
    return {start_, t_ - start_, t_, StepForm::power, dense_, nullptr};
  }
  std::int64_t rejected() const override {
    long failed = 0;
    long not_converged = 0;
    if (solver_) {
      CVodeGetNumErrTestFails(solver_.get(), &failed);
      CVodeGetNumNonlinSolvConvFails(solver_.get(), &not_converged);
    }
    return failed + not_converged;
  }

 private:
  static double* values(N_Vector vector) { return NV_DATA_S(vector); }

  // No exception may pass through C: it waits in failure_.
  template <class Call>
  static int guarded(void* user, Call call) {
    auto& self = *static_cast<BackwardDifferentiation*>(user);
    try {
      return call(self);
    } catch (...) {
      self.failure_ = std::current_exception();
      return -1;
    }
  }
  static int rates(double t, N_Vector y, N_Vector rate, void* user) {
    return guarded(user, [&](BackwardDifferentiation& self) {
      const bool finite = self.right_side_(t, {values(y), self.n_}, {values(rate), self.n_});
      self.met_not_finite_ = self.met_not_finite_ || !finite;
      return finite ? 0 : 1;
    });
  }
  // The method's norm is a root mean square; ours is the largest component. Backward differences gather errors of one
  // sign over many steps: a tenth of what is allowed for each, but no less than the rounding of the sums that make a
  // step, as of an angle that has gone round many times beside what has died out.
  static int weights(N_Vector y, N_Vector weight, void* user) {
    return guarded(user, [&](BackwardDifferentiation& self) {
      constexpr double rounding = 16 * std::numeric_limits<double>::epsilon();
      const std::span<const double> allowed = self.scale_.allowed();
      const double strictness = 10.0 * std::sqrt(static_cast<double>(self.n_));
      for (std::size_t i = 0; i < self.n_; ++i)
        values(weight)[i] = std::min(strictness / allowed[i], 1.0 / (rounding * std::fabs(values(y)[i])));
      return 0;
    });
  }
  static int projection(double t, N_Vector y, N_Vector correction, double, N_Vector, void* user) {
    return guarded(user, [&](BackwardDifferentiation& self) {
      std::copy(values(y), values(y) + self.n_, self.projected_.begin());
      self.right_side_.project(t, self.projected_, self.scale_.allowed());
      for (std::size_t i = 0; i < self.n_; ++i) values(correction)[i] = self.projected_[i] - values(y)[i];
      return 0;
    });
  }

  RightSide& right_side_;
  const ErrorScale& scale_;
  std::size_t n_;
  double first_;
  double largest_;
  Context context_;
  Vector y_;
  Vector derivative_;
  Matrix jacobian_;
  Linear linear_;
  Solver solver_;
  double t_ = 0.0;
  double start_ = 0.0;
  bool restart_ = false;
  bool met_not_finite_ = false;
  bool dense_is_ready_ = false;
  std::exception_ptr failure_;
  std::vector<double> state_;
  std::vector<double> projected_;
  std::vector<double> dense_;
};

}  // namespace

std::unique_ptr<StepMethod> make_stiff_method(RightSide& right_side, const ErrorScale& scale, double first,
                                              double largest) {
  return std::make_unique<BackwardDifferentiation>(right_side, scale, first, largest);
}

bool has_stiff_solver() { return true; }

}  // namespace poinsot

#else

namespace poinsot {

std::unique_ptr<StepMethod> make_stiff_method(RightSide&, const ErrorScale&, double, double) { return nullptr; }

bool has_stiff_solver() { return false; }

}  // namespace poinsot

#endif
