// Integration of equations of motion through time, with the state at any instant, events, the drift of what should be
// conserved and an estimate of the error reached.
//
// Who calls what: a single rigid body, free or with a fixed point, is served many times faster by rigid_body_motion.h;
// this is for everything else.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "poinsot/engine/motion/integrator/event.h"
#include "poinsot/engine/motion/integrator/motion_equations.h"
#include "poinsot/engine/motion/integrator/trajectory.h"
#include "poinsot/engine/work/work.h"

namespace poinsot {

enum class IntegrationMethod {
  // Explicit. Where the equations prove to be stiff, `stiff` takes over if there is a solver for them. If
  // accelerations at eight instants are given and only the last state is wanted (no store, observer or events),
  // `collocation` is tried first.
  automatic,
  explicit_runge_kutta,  // Dormand and Prince's order 8(5,3) with dense output of order 7
  collocation,           // Gauss-Legendre of order 16 in chosen steps; needs accelerations at eight instants
  structure_preserving,  // Gauss-Legendre collocation of order 16 in fixed steps: symmetric, keeps quadratic invariants
  stiff                  // backward differentiation formulas of order 1 to 5, from SUNDIALS
};

enum class Ending {
  reached_end,
  terminal_event,
  interrupted,      // the observer asked for it
  step_limit,       // most_steps was reached
  work_limit,       // `work` was done
  step_too_small,   // a singularity, a discontinuity, or a tolerance below rounding
  not_finite,       // the equations give no finite accelerations at `time`
  stiff,            // an explicit method would need steps far below what accuracy asks
  no_convergence,   // the implicit equations of a step could not be solved
  singular_pose,    // the motion can go on in more than one way, or in none
  no_stiff_solver,  // `stiff` was asked for, and poinsot was built without SUNDIALS
};

struct IntegrationOptions {
  IntegrationMethod method = IntegrationMethod::automatic;
  // Error of a step over the natural size of each coordinate. Over a few turns of random bodies and gimbals the errors
  // add up to at most some hundred times that (tests/engine/motion/integrator/accuracy_test.cpp).
  double tolerance = 1e-10;
  double first_step = 0.0;    // s; 0: chosen
  double largest_step = 0.0;  // s; 0: no limit
  // Step of the structure-preserving method, s; 0: the largest that keeps a step's error within the tolerance at the
  // start and over some steps from there.
  double fixed_step = 0.0;
  std::int64_t most_steps = 10'000'000;
  Work work = unlimited_work;
  bool store = true;            // whether to keep the steps in the trajectory
  bool watch_drift = true;      // whether to report it for the conserved quantities, at each step
  bool estimate_error = false;  // whether to integrate a second time with another tolerance and compare
  // Called after each step with the step, which gives the state within it; returning false ends the integration.
  std::function<bool(const StepView& step)> observer;
};

struct IntegrationStatistics {
  std::int64_t steps = 0;
  std::int64_t rejected = 0;
  std::int64_t evaluations = 0;  // of the accelerations, both integrations together
};

struct Drift {
  std::string name;
  double start = 0.0;    // the value at the start
  double end = 0.0;      // its change at the end
  double largest = 0.0;  // its largest change at the end of a step
};

// How far the motion may be from the true one: the difference from an integration with a larger tolerance. It is a
// bound if the error falls with the tolerance, as it does unless rounding or chaos dominates.
struct ErrorEstimate {
  std::vector<double> q;  // at the end, magnitudes in the units of the coordinates
  std::vector<double> v;
  double largest = 0.0;  // over the whole span, of error over natural size; of the end only if steps are not stored
};

struct IntegrationResult {
  std::string method;        // how it was found, in words: "integrated by Dormand and Prince's method of order 8"
  bool closed_form = false;  // whether the motion is known, so that only rounding separates it from the true one
  Ending ending = Ending::reached_end;
  double time = 0.0;  // s, where it ended
  std::vector<double> q;
  std::vector<double> v;
  Trajectory trajectory;
  std::vector<EventHit> hits;  // in the order of time's run
  IntegrationStatistics statistics;
  std::vector<Drift> drift;  // of the conserved quantities, in their order; empty if not to be watched
  ErrorEstimate error;       // empty unless asked for

  bool complete() const { return ending == Ending::reached_end || ending == Ending::terminal_event; }
};

// The motion from the state (q, v) at start to end (s, before or after start). The start is projected first. Events are
// found after the start; one whose value is zero at the start counts from when it has left zero.
// Errors: std::invalid_argument if a size is wrong, an argument is not finite or an option makes no sense.
IntegrationResult integrate(const MotionEquations& equations, double start, std::span<const double> q,
                            std::span<const double> v, double end, const IntegrationOptions& options = {},
                            std::span<const Event> events = {});

// Describes what ended the integration: "the steps became too small at 0.3 s: ...".
std::string describe(const IntegrationResult& result);

// Whether stiff equations can be integrated: poinsot was built with SUNDIALS.
bool has_stiff_solver();

}  // namespace poinsot
