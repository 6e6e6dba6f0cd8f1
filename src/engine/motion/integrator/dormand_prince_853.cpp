#include "engine/motion/integrator/dormand_prince_853.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace poinsot {

namespace tableau = dormand_prince_853;

double first_step(RightSide& right_side, double t, std::span<const double> y, std::span<const double> rate,
                  std::span<const double> scale, double span, int order) {
  const std::size_t n = y.size();
  double state_size = 0.0;
  double rate_size = 0.0;
  for (std::size_t i = 0; i < n; ++i) {
    state_size = std::max(state_size, std::fabs(y[i]) / scale[i]);
    rate_size = std::max(rate_size, std::fabs(rate[i]) / scale[i]);
  }
  const double length = std::fabs(span);
  const bool moves = state_size > 0.0 && rate_size > 0.0;
  double h = moves ? std::min(0.01 * state_size / rate_size, length) : 1e-6 * length;
  // Rates and their rates are compared in a unit of time that stands for the second of the book: some times that in
  // which the state changes by as much as it is. The tolerance is so much smaller than one that its size hardly
  // matters.
  const double unit = moves ? 256.0 * h : length;
  std::vector<double> ahead(n);
  std::vector<double> rate_ahead(n);
  double curvature = 0.0;
  for (int attempt = 0; attempt < 40; ++attempt) {
    const double signed_h = std::copysign(h, span);
    for (std::size_t i = 0; i < n; ++i) ahead[i] = y[i] + signed_h * rate[i];
    if (right_side(t + signed_h, ahead, rate_ahead)) break;
    h *= 0.1;
  }
  for (std::size_t i = 0; i < n; ++i)
    curvature = std::max(curvature, std::fabs(rate_ahead[i] - rate[i]) / scale[i] / h);
  const double steepest = std::max(curvature * unit, rate_size) * unit;
  if (!std::isfinite(steepest)) return h;
  const double by_order =
      steepest > 0.0 ? unit * std::pow(0.01 / steepest, 1.0 / order) : std::max(1e-6 * length, 1e-3 * h);
  return std::min({100.0 * h, by_order, length});
}

DormandPrince853::DormandPrince853(RightSide& right_side, const ErrorScale& scale, double first, double largest)
    : right_side_(right_side),
      scale_(scale),
      n_(static_cast<std::size_t>(right_side.size())),
      first_(first),
      largest_(largest > 0.0 ? largest : std::numeric_limits<double>::infinity()),
      y_(n_),
      carry_(n_),
      y_start_(n_),
      y_end_(n_),
      y_stage_(n_),
      k_(n_ * tableau::stages),
      dense_(n_ * 8) {}

StepOutcome DormandPrince853::begin(double t, std::span<const double> y, double limit) {
  t_ = t;
  std::copy(y.begin(), y.end(), y_.begin());
  std::fill(carry_.begin(), carry_.end(), 0.0);
  after_rejection_ = false;
  stiff_signs_ = 0;
  if (!right_side_(t_, y_, {stage(tableau::step_stages), n_})) return StepOutcome::not_finite;
  rate_is_current_ = true;
  if (limit == t) return StepOutcome::advanced;
  const double h =
      first_ > 0.0 ? first_
                   : first_step(right_side_, t_, y_, {stage(tableau::step_stages), n_}, scale_.allowed(), limit - t, 8);
  h_ = std::copysign(std::min(h, largest_), limit - t);
  return StepOutcome::advanced;
}

template <int Row>
double DormandPrince853::stage_sum(std::size_t i) const {
  double sum = tableau::coefficients[Row][0] * k_[i];
  [&]<int... Stage>(std::integer_sequence<int, Stage...>) {
    const auto add = [&]<int S>() {
      if constexpr (S > 0 && tableau::coefficients[Row][S] != 0.0) {
        sum += tableau::coefficients[Row][S] * k_[static_cast<std::size_t>(S) * n_ + i];
      }
    };
    (add.template operator()<Stage>(), ...);
  }
  (std::make_integer_sequence<int, Row>{});
  return sum;
}

template <int Stage>
bool DormandPrince853::evaluate_stage(double h) {
  for (std::size_t i = 0; i < n_; ++i) y_stage_[i] = y_start_[i] + h * stage_sum<Stage>(i);
  return right_side_(start_ + tableau::nodes[Stage] * h, y_stage_, {stage(Stage), n_});
}

template <int... Stages>
bool DormandPrince853::evaluate_stages(double h, std::integer_sequence<int, Stages...>) {
  return (evaluate_stage<Stages + 1>(h) && ...);
}

double DormandPrince853::estimated_error(double h) const {
  const std::span<const double> scale = scale_.allowed();
  double fifth = 0.0;
  double third = 0.0;
  for (std::size_t i = 0; i < n_; ++i) {
    double by_fifth = 0.0;
    double by_third = 0.0;
    for (int s = 0; s < tableau::step_stages; ++s) {
      const double k = stage(s)[i];
      by_fifth += tableau::fifth_order_error[s] * k;
      by_third += (tableau::coefficients[tableau::step_stages][s] - tableau::third_order_weights[s]) * k;
    }
    fifth = std::max(fifth, std::fabs(by_fifth) / scale[i]);
    third = std::max(third, std::fabs(by_third) / scale[i]);
  }
  if (fifth == 0.0) return 0.0;
  return std::fabs(h) * fifth * fifth / std::sqrt(fifth * fifth + 0.01 * third * third);
}

// The dominant eigenvalue from the last two stages, which stand at the same instant (DOP853; Section IV.2): the region
// of stability ends near 6.1.
bool DormandPrince853::seems_stiff(double h) {
  double rates = 0.0;
  double states = 0.0;
  for (std::size_t i = 0; i < n_; ++i) {
    const double rate = stage(12)[i] - stage(11)[i];
    const double state = y_[i] - y_stage_[i];
    rates += rate * rate;
    states += state * state;
  }
  if (states > 0.0 && std::fabs(h) * std::sqrt(rates / states) > 6.1) {
    calm_signs_ = 0;
    return ++stiff_signs_ >= 15;
  }
  if (++calm_signs_ >= 6) stiff_signs_ = 0;
  return false;
}

StepOutcome DormandPrince853::advance(double limit) {
  if (!rate_is_current_ && !right_side_(t_, y_, {stage(tableau::step_stages), n_})) return StepOutcome::not_finite;
  std::copy(stage(tableau::step_stages), stage(tableau::step_stages) + n_, stage(0));
  std::copy(y_.begin(), y_.end(), y_start_.begin());
  start_ = t_;
  bool refused_as_not_finite = false;
  for (;;) {
    const auto [h, end, at_limit, smallest] = step_towards(limit, start_, h_, largest_);
    if (std::fabs(h) <= smallest && !at_limit) {
      return refused_as_not_finite ? StepOutcome::not_finite : StepOutcome::too_small;
    }

    const bool finite = evaluate_stages(h, std::make_integer_sequence<int, tableau::step_stages - 1>{});
    const double error = finite ? estimated_error(h) : std::numeric_limits<double>::infinity();
    if (!(error <= 1.0)) {
      ++rejected_;
      refused_as_not_finite = !std::isfinite(error);
      after_rejection_ = true;
      if (at_limit && std::fabs(h) <= smallest)
        return refused_as_not_finite ? StepOutcome::not_finite : StepOutcome::too_small;
      h_ = h * (refused_as_not_finite ? 0.1 : std::max(0.333, 0.9 * std::pow(error, -1.0 / 8.0)));
      continue;
    }

    // The new state, with what rounding took off the old one.
    for (std::size_t i = 0; i < n_; ++i) {
      const double gain = h * stage_sum<tableau::step_stages>(i) + carry_[i];
      y_[i] = y_start_[i] + gain;
      carry_[i] = gain - (y_[i] - y_start_[i]);
    }
    if (!right_side_(end, y_, {stage(tableau::step_stages), n_})) {
      ++rejected_;
      refused_as_not_finite = true;
      after_rejection_ = true;
      std::copy(y_start_.begin(), y_start_.end(), y_.begin());
      std::fill(carry_.begin(), carry_.end(), 0.0);
      h_ = 0.1 * h;
      continue;
    }
    std::copy(y_.begin(), y_.end(), y_end_.begin());
    t_ = end;
    length_ = h;
    rate_is_current_ = true;
    dense_is_ready_ = false;
    double growth = error > 0.0 ? 0.9 * std::pow(error, -1.0 / 8.0) : 6.0;
    growth = std::clamp(growth, 0.333, after_rejection_ ? 1.0 : 6.0);
    // A step shortened to end at the limit says nothing against the longer one proposed before.
    h_ = at_limit && growth >= 1.0 ? std::copysign(std::max(std::fabs(h_), growth * std::fabs(h)), h) : growth * h;
    after_rejection_ = false;
    return seems_stiff(h) ? StepOutcome::stiff : StepOutcome::advanced;
  }
}

void DormandPrince853::state_changed(bool noticeably) {
  std::fill(carry_.begin(), carry_.end(), 0.0);
  if (noticeably) rate_is_current_ = false;
}

StepView DormandPrince853::last_step() {
  if (!dense_is_ready_) {
    const double h = length_;
    evaluate_stage<13>(h);
    evaluate_stage<14>(h);
    evaluate_stage<15>(h);
    for (std::size_t i = 0; i < n_; ++i) {
      const double change = y_end_[i] - y_start_[i];
      const double first = h * stage(0)[i];
      dense_[i] = y_start_[i];
      dense_[n_ + i] = change;
      dense_[2 * n_ + i] = first - change;
      dense_[3 * n_ + i] = 2.0 * change - h * stage(12)[i] - first;
      for (std::size_t row = 0; row < 4; ++row) {
        double sum = 0.0;
        for (int s = 0; s < tableau::stages; ++s) sum += tableau::dense_weights[row][s] * stage(s)[i];
        dense_[(4 + row) * n_ + i] = h * sum;
      }
    }
    dense_is_ready_ = true;
  }
  return {start_, length_, t_, StepForm::nested, dense_, nullptr};
}

// A shorter step of the method itself.
void DormandPrince853::state_within(double t, std::span<double> y) {
  last_step();
  const double h = t - start_;
  if (h == 0.0 || !evaluate_stages(h, std::make_integer_sequence<int, tableau::step_stages - 1>{})) {
    last_step().evaluate(t, y);
    return;
  }
  for (std::size_t i = 0; i < n_; ++i) y[i] = y_start_[i] + h * stage_sum<tableau::step_stages>(i);
}

}  // namespace poinsot
