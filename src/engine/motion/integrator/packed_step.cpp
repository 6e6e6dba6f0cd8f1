#include "engine/motion/integrator/packed_step.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "engine/motion/integrator/gauss_step.h"
#include "poinsot/engine/work/work.h"

namespace poinsot {

namespace {

namespace gauss = gauss_legendre_8;
constexpr int stages = gauss::stages;
constexpr Work of_eight_rates = 250;  // of one number of the state
using Stages = StageTable::Stages;
using Lanes = Stages::Lanes;

struct Tables : gauss::StagePacks {
  Stages legendre[stages];  // column j of the Legendre coefficients of f from the increments

  Tables() {
    for (int j = 0; j < stages; ++j)
      legendre[j] = Stages::from_lanes([j](int m) { return gauss::legendre[m][j] / gauss::weights[j]; });
  }
};
const Tables& tables() {
  static const Tables made;
  return made;
}

// sum_j columns_j numbers[j], in four parts that do not wait for one another.
inline Stages product(const Stages* columns, const double* numbers) {
  Stages a = columns[0] * Stages(numbers[0]);
  Stages b = columns[1] * Stages(numbers[1]);
  Stages c = columns[2] * Stages(numbers[2]);
  Stages d = columns[3] * Stages(numbers[3]);
  a += columns[4] * Stages(numbers[4]);
  b += columns[5] * Stages(numbers[5]);
  c += columns[6] * Stages(numbers[6]);
  d += columns[7] * Stages(numbers[7]);
  return (a + b) + (c + d);
}

std::array<double, stages> instants(double t, double h) {
  std::array<double, stages> at;
  for (int i = 0; i < stages; ++i) at[i] = t + gauss::nodes[i] * h;
  return at;
}

}  // namespace

StageTable::StageTable(std::size_t rows) : storage_(rows * width + width - 1) {
  void* start = storage_.data();
  std::size_t space = storage_.size() * sizeof(double);
  const std::size_t bytes = rows * width * sizeof(double);
  numbers_ = {static_cast<double*>(std::align(width * sizeof(double), bytes, start, space)), rows * width};
}

PackedStep::PackedStep(const MotionEquations& equations)
    : equations_(equations),
      nq_(static_cast<std::size_t>(equations.position_size)),
      n_(nq_ + static_cast<std::size_t>(equations.velocity_size)),
      increments_(n_),
      at_stages_(n_),
      rates_(n_),
      series_(n_),
      per_allowed_(n_) {}

bool PackedStep::start_flat(double t, std::span<const double> y, double h) {
  for (std::size_t k = 0; k < n_; ++k) at_stages_.set(k, Stages(y[k]));
  find_position_rates(t, 0.0);
  find_accelerations(t, 0.0);
  bool finite = true;
  for (std::size_t k = 0; k < n_; ++k) {
    const Stages increment = Stages(h) * tables().weights * rates_.row(k);
    increments_.set(k, increment);
    finite = finite && std::isfinite(increment.lane(0));
  }
  return finite;
}

void PackedStep::start_from_series(double h, double before, bool from_its_end) {
  const double ratio = h / before;
  const Stages x = Stages(from_its_end ? 1.0 : -1.0) + Stages(2.0 * ratio) * tables().nodes;
  Stages legendre[stages];
  legendre[0] = Stages(ratio) * tables().weights;
  legendre[1] = x * legendre[0];
  for (int m = 1; m + 1 < stages; ++m) {
    legendre[m + 1] = Stages((2.0 * m + 1.0) / (m + 1.0)) * x * legendre[m] - Stages(m / (m + 1.0)) * legendre[m - 1];
  }
  for (std::size_t k = 0; k < n_; ++k) increments_.set(k, product(legendre, series_.at(k)));
}

StepOutcome PackedStep::solve(double t, std::span<const double> y, double h, std::span<const double> allowed) {
  constexpr int most_rounds = 40;  // at a contraction of one half, twelve digits
  // Of the error allowed, what the rounds may leave: the error of the step itself is then told to two digits, and a
  // tenth of it would take one round more in most steps.
  constexpr double part = 0.02;
  for (std::size_t k = 0; k < n_; ++k) per_allowed_[k] = 1.0 / allowed[k];
  const Stages weight = Stages(h) * tables().weights;
  double last = std::numeric_limits<double>::infinity();
  for (int round = 1; round <= most_rounds; ++round) {
    Lanes changes(0.0);
    const auto renew = [&](std::size_t k) {
      const Stages increment = weight * rates_.row(k);
      const Lanes change = ((increment - increments_.row(k)) * Stages(per_allowed_[k])).lanes();
      changes += change * change;
      increments_.set(k, increment);
    };
    for (std::size_t k = nq_; k < n_; ++k) at_stages_.set(k, stage(y, k));
    if (equations_.position_rate) {
      for (std::size_t k = 0; k < nq_; ++k) at_stages_.set(k, stage(y, k));
      find_position_rates(t, h);
      for (std::size_t k = 0; k < nq_; ++k) renew(k);
    } else {
      for (std::size_t k = 0; k < nq_; ++k) increments_.set(k, weight * at_stages_.row(nq_ + k));
    }
    for (std::size_t k = 0; k < nq_; ++k) at_stages_.set(k, stage(y, k));
    find_accelerations(t, h);
    for (std::size_t k = nq_; k < n_; ++k) renew(k);

    const double change = std::sqrt(std::experimental::reduce(changes));
    if (!std::isfinite(change)) return StepOutcome::not_finite;
    contraction_ = change / last;
    last = change;
    if (change < 0.1 * part) return StepOutcome::advanced;
    if (round == 1) continue;
    if (gauss::contracted(change, contraction_, part)) return StepOutcome::advanced;
    if (round > 8 && contraction_ > 1.0) return StepOutcome::no_convergence;
  }
  return StepOutcome::no_convergence;
}

double PackedStep::find_series(std::span<const double> allowed) {
  double error = 0.0;
  double relative = 0.0;
  for (std::size_t k = 0; k < n_; ++k) {
    series_.set(k, product(tables().legendre, increments_.at(k)));
    const double* const c = series_.at(k);
    double size = 0.0;
    for (int m = 0; m < stages; ++m) size = std::max(size, std::fabs(c[m]));
    const double left_out = gauss::left_out(c);
    error = std::max(error, left_out * per_allowed_[k]);
    if (size > allowed[k]) relative = std::max(relative, left_out / size);
  }
  return error * relative;
}

void PackedStep::add_to(std::span<double> y, std::span<double> carry) const {
  for (std::size_t k = 0; k < n_; ++k) {
    gauss::add_compensated(carry[k] + gauss::sum_of_increments(increments_.at(k)), y[k], carry[k]);
  }
}

PackedStep::Stages PackedStep::stage(std::span<const double> y, std::size_t k) const {
  return Stages(y[k]) + product(tables().ratios, increments_.at(k));
}

void PackedStep::find_position_rates(double t, double h) {
  if (!equations_.position_rate) {
    for (std::size_t k = 0; k < nq_; ++k) rates_.set(k, at_stages_.row(nq_ + k));
    return;
  }
  equations_.position_rate_at_eight(instants(t, h), at_stages_.rows(0, nq_), at_stages_.rows(nq_, n_ - nq_),
                                    rates_.rows(0, nq_));
}

void PackedStep::find_accelerations(double t, double h) {
  ++rounds_;
  count_work(of_eight_rates * static_cast<Work>(n_));
  equations_.accelerations_at_eight(instants(t, h), at_stages_.rows(0, nq_), at_stages_.rows(nq_, n_ - nq_),
                                    rates_.rows(nq_, n_ - nq_));
}

}  // namespace poinsot
