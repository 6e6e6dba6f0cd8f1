// The loop that drives a method from a start to an end.
#pragma once

#include <cmath>
#include <deque>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/motion/integrator/methods.h"
#include "engine/motion/integrator/right_side.h"
#include "engine/motion/integrator/step_method.h"
#include "poinsot/engine/motion/integrator/integrate.h"
#include "poinsot/engine/work/budget.h"

namespace poinsot {

// One integration from a start to an end.
class IntegrationRun {
 public:
  IntegrationRun(const MethodMaker& make, const MotionEquations& equations, const IntegrationOptions& options,
                 std::span<const Event> events, double start, double end)
      : make_(make),
        equations_(equations),
        options_(options),
        events_(events),
        start_(start),
        end_(end),
        step_limit_(end),
        right_side_(equations),
        scale_(equations, options.tolerance, std::fabs(end - start)) {
    result_.trajectory = Trajectory(equations.position_size, equations.velocity_size, equations.quaternions);
    result_.time = start;
  }

  IntegrationResult go(std::span<const double> q, std::span<const double> v);
  double size(std::size_t i) const { return scale_.size(i); }

 private:
  // The state in which a step began, and the step's length.
  struct Beginning {
    double time = 0, length = 0;
    std::vector<double> y;
  };

  std::optional<Ending> begin(IntegrationMethod method, double start, std::span<const double> y);
  std::optional<Ending> one_step();
  void remember_beginning();
  void go_back_to(const Beginning& beginning);
  bool step_in_one(double time, std::optional<Ending>& ending);
  bool step_over_crossing(std::optional<Ending>& ending);
  bool is_watched() const { return options_.store || options_.observer || !events_.empty(); }
  std::optional<IntegrationMethod> successor(StepOutcome outcome) const;
  bool find_events(StepView& step, std::vector<double>& y_end);
  std::vector<double> smooth_parts(const Event& event, const StepView& step);
  bool watches_drift() const { return options_.watch_drift && !equations_.conserved.empty(); }
  void note_drift(double t, std::span<const double> y);
  static Ending ending_of(StepOutcome outcome);
  static std::string words_of(IntegrationMethod method);

  const MethodMaker& make_;
  const MotionEquations& equations_;
  const IntegrationOptions& options_;
  std::span<const Event> events_;
  double start_, end_;
  double step_limit_;  // no step goes further: the end, but for a step that is made again
  RightSide right_side_;
  ErrorScale scale_;
  std::unique_ptr<StepMethod> method_;
  IntegrationMethod in_use_ = IntegrationMethod::automatic;
  std::vector<double> y_;
  std::vector<double> y_sample_;
  Beginning begun_;                   // the step that is being made
  std::deque<Beginning> beginnings_;  // of steps before it
  std::vector<char> zero_at_start_;   // the event's value was zero where the next step starts
  IntegrationResult result_;
  ProgressTeller progress_{"following the motion"};
};

}  // namespace poinsot
