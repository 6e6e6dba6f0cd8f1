// Dormand and Prince's explicit method of order 8 in steps chosen by its error estimates of orders 5 and 3, with dense
// output of order 7 (Hairer, Norsett, Wanner 1993, Sections II.5, II.6; the program DOP853 there).
#pragma once

#include <vector>

#include "engine/motion/integrator/dormand_prince_853_tableau.h"
#include "engine/motion/integrator/step_method.h"

namespace poinsot {

class DormandPrince853 final : public StepMethod {
 public:
  // first, largest: steps, 0 for none stated. The right side and the scale must outlive this.
  DormandPrince853(RightSide& right_side, const ErrorScale& scale, double first, double largest);

  StepOutcome begin(double t, std::span<const double> y, double limit) override;
  StepOutcome advance(double limit) override;
  double time() const override { return t_; }
  std::span<double> state() override { return y_; }
  void state_changed(bool noticeably) override;
  StepView last_step() override;
  void state_within(double t, std::span<double> y) override;
  std::int64_t rejected() const override { return rejected_; }

 private:
  template <int Stage>
  bool evaluate_stage(double h);
  template <int... Stages>
  bool evaluate_stages(double h, std::integer_sequence<int, Stages...>);
  template <int Row>
  double stage_sum(std::size_t i) const;
  double estimated_error(double h) const;
  bool seems_stiff(double h);
  double* stage(int s) { return k_.data() + static_cast<std::size_t>(s) * n_; }
  const double* stage(int s) const { return k_.data() + static_cast<std::size_t>(s) * n_; }

  RightSide& right_side_;
  const ErrorScale& scale_;
  std::size_t n_;
  double first_;
  double largest_;
  double t_ = 0.0;
  double h_ = 0.0;  // proposed, signed
  bool after_rejection_ = false;
  int stiff_signs_ = 0;
  int calm_signs_ = 0;
  bool rate_is_current_ = false;  // stage 12 holds dy/dt at (t_, y_)
  bool dense_is_ready_ = false;
  std::int64_t rejected_ = 0;
  double start_ = 0.0;   // of the last step
  double length_ = 0.0;  // of the last step
  std::vector<double> y_;
  std::vector<double> carry_;  // what rounding took off y_ (Kahan)
  std::vector<double> y_start_;
  std::vector<double> y_end_;  // the end of the last step before any projection
  std::vector<double> y_stage_;
  std::vector<double> k_;
  std::vector<double> dense_;
};

}  // namespace poinsot
