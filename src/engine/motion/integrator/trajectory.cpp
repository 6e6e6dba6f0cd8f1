#include "poinsot/engine/motion/integrator/trajectory.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace poinsot {

void StepView::evaluate(double t, std::span<double> state) const {
  const std::size_t n = state.size();
  if (n == 0) return;  // What has no freedoms has no coefficients either.
  if (form == StepForm::flow) {
    flow->advance(start, coefficients.first(n), t, state);
    return;
  }
  const std::size_t count = coefficients.size() / n;
  const double s = (t - start) / length;
  const double* c = coefficients.data() + (count - 1) * n;
  std::copy(c, c + n, state.begin());
  for (std::size_t k = count - 1; k-- > 0;) {
    const double factor = form == StepForm::nested && k % 2 == 1 ? 1.0 - s : s;
    c = coefficients.data() + k * n;
    for (std::size_t i = 0; i < n; ++i) state[i] = c[i] + factor * state[i];
  }
}

double Trajectory::start_time() const {
  if (empty()) throw std::out_of_range("Trajectory: it has no steps, and so no start");
  return steps_.front().start;
}

double Trajectory::end_time() const {
  if (empty()) throw std::out_of_range("Trajectory: it has no steps, and so no end");
  return steps_.back().end;
}

StepView Trajectory::step(std::size_t i) const {
  if (i >= steps_.size()) throw std::out_of_range("Trajectory: there are fewer steps than that");
  const Stored& s = steps_[i];
  return {
      s.start,    s.length, s.end, s.form, std::span<const double>(coefficients_[s.chunk]).subspan(s.first, s.count),
      flow_.get()};
}

void Trajectory::state(double t, std::span<double> q, std::span<double> v) const {
  if (empty()) throw std::out_of_range("Trajectory: it has no steps, and so no states");
  detail::require_size("Trajectory::state", "q", q.size(), position_size_);
  detail::require_size("Trajectory::state", "v", v.size(), velocity_size_);
  const double first = start_time();
  const double last = end_time();
  const double low = std::min(first, last);
  const double high = std::max(first, last);
  // A time that was computed from the same data in another way is off by some roundings of a sum.
  constexpr double rounding = 1e-12;
  const double slack = rounding * std::max({high - low, std::fabs(low), std::fabs(high)});
  if (!(t >= low - slack && t <= high + slack))
    throw std::out_of_range(
        fmt::format("Trajectory: asked for the state at {} s, but the motion runs from {} s to {} s", t, first, last));
  t = std::clamp(t, low, high);

  // The last step that starts no later than t.
  const double sense = last >= first ? 1.0 : -1.0;
  auto found = std::upper_bound(steps_.begin(), steps_.end(), t,
                                [&](double time, const Stored& s) { return sense * time < sense * s.start; });
  if (found != steps_.begin()) --found;
  std::array<double, 64> few;
  std::vector<double> many(q.size() + v.size() > few.size() ? q.size() + v.size() : 0);
  const std::span<double> y =
      many.empty() ? std::span<double>(few).first(q.size() + v.size()) : std::span<double>(many);
  step(static_cast<std::size_t>(found - steps_.begin())).evaluate(t, y);
  std::copy(y.begin(), y.begin() + position_size_, q.begin());
  std::copy(y.begin() + position_size_, y.end(), v.begin());
  for (const int k : quaternions_) {
    double* c = &q[static_cast<std::size_t>(k)];
    const double inverse = 1.0 / std::sqrt(c[0] * c[0] + c[1] * c[1] + c[2] * c[2] + c[3] * c[3]);
    for (int i = 0; i < 4; ++i) c[i] *= inverse;
  }
}

State<double> Trajectory::state(double t) const {
  State<double> at{std::vector<double>(static_cast<std::size_t>(position_size_)),
                   std::vector<double>(static_cast<std::size_t>(velocity_size_))};
  state(t, at.q, at.v);
  return at;
}

void Trajectory::append(const StepView& step) {
  const std::size_t count = step.coefficients.size();
  if (coefficients_.empty() || coefficients_.back().size() + count > coefficients_.back().capacity()) {
    // Numbers of a chunk: half a megabyte, so that what lies idle of the last one is little; and a kilobyte, for
    // motions of a few steps.
    constexpr std::size_t most = 65'536, fewest = 128;
    const std::size_t before = coefficients_.empty() ? 0 : coefficients_.back().size();
    coefficients_.emplace_back().reserve(std::max(std::clamp(2 * before, fewest, most), count));
  }
  std::vector<double>& chunk = coefficients_.back();
  steps_.push_back({step.start, step.length, step.end, step.form, coefficients_.size() - 1, chunk.size(), count});
  chunk.insert(chunk.end(), step.coefficients.begin(), step.coefficients.end());
}

}  // namespace poinsot
