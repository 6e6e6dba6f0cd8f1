// A motion through a span of time: the state at any instant of it, from the steps that an integrator has stored.
#pragma once

#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "poinsot/engine/model/state.h"

namespace poinsot {

// How a step gives the states within it.
enum class StepForm {
  nested,  // polynomial in s = (t - start)/length: c0 + s (c1 + (1 - s) (c2 + s (c3 + (1 - s) (...)))), as Dormand and
           // Prince's dense output is written (Hairer, Norsett, Wanner 1993, Eq. II.6.39)
  power,   // polynomial in s: c0 + s (c1 + s (c2 + ...))
  flow     // c0 is the state at the start; the method is applied over the part of the step
};

// Takes a state (coordinates, then velocities) from one instant to another by a method without polynomials.
class StateFlow {
 public:
  virtual ~StateFlow() = default;
  virtual void advance(double from, std::span<const double> start, double to, std::span<double> state) const = 0;
  // In which the motion changes noticeably, where steps may be longer than that: s.
  virtual double natural_time() const { return std::numeric_limits<double>::infinity(); }
};

// One step: start < end, or start > end where time runs backwards. The spans belong to whoever gives the step away.
struct StepView {
  double start = 0.0;
  double length = 0.0;  // negative where time runs backwards
  double end = 0.0;     // start + length, or before that where an event has cut the step
  StepForm form = StepForm::power;
  std::span<const double> coefficients;  // c0, c1, ...: each position_size + velocity_size numbers
  const StateFlow* flow = nullptr;

  // Writes coordinates and velocities at t; quaternions are not normalised.
  void evaluate(double t, std::span<double> state) const;
};

class Trajectory {
 public:
  Trajectory() = default;
  Trajectory(int position_size, int velocity_size, std::vector<int> quaternions)
      : position_size_(position_size), velocity_size_(velocity_size), quaternions_(std::move(quaternions)) {}

  int position_size() const { return position_size_; }
  int velocity_size() const { return velocity_size_; }
  bool empty() const { return steps_.empty(); }
  std::size_t step_count() const { return steps_.size(); }
  // s. Errors, for these and those below: std::out_of_range if there is no step.
  double start_time() const;
  double end_time() const;
  StepView step(std::size_t i) const;

  // The state at t, quaternions normalised: as accurate as the integration's tolerance asks. Within 1e-12 of the span
  // outside it, the end's state. Errors: std::out_of_range if t lies outside.
  void state(double t, std::span<double> q, std::span<double> v) const;
  State<double> state(double t) const;

  // For integrators: appends a step, copying its coefficients. A flow stays with the trajectory.
  void append(const StepView& step);
  void keep(std::shared_ptr<const StateFlow> flow) { flow_ = std::move(flow); }

 private:
  struct Stored {
    double start;
    double length;
    double end;
    StepForm form;
    std::size_t chunk;
    std::size_t first;  // in the chunk
    std::size_t count;
  };
  int position_size_ = 0;
  int velocity_size_ = 0;
  std::vector<int> quaternions_;
  std::vector<Stored> steps_;
  // In chunks, so that a long trajectory is not copied when it grows.
  std::vector<std::vector<double>> coefficients_;
  std::shared_ptr<const StateFlow> flow_;
};

}  // namespace poinsot
