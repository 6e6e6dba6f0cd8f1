// With a rate s of x' = A x the matrix A - s is singular but for rounding, and its inverse is
//
//   (A - s)^-1 = v w^T / d + R,
//
// with v the eigenvector, d the rounding and R of the size 1/apart, the distance to the nearest matrix that has two of
// them. Its largest column is v, and inverse iteration makes that exact.
#include "engine/solve/stability/mode_shapes.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace poinsot::solve {
namespace {

using Index = Eigen::Index;
// Of the pace: keeps A - s from being singular altogether, where its inverse has no entries.
constexpr Real beside_rate = 1e-14L;
// Of the pace: frequencies that differ by less are equal but for rounding.
constexpr double as_fast = 1e-9;

bool has_body(const Mode& mode, int body) {
  return !mode.moves.empty() && (body == everything || mode.moves[static_cast<std::size_t>(body)]);
}

}  // namespace

RateMotion motion_of_rate(const Matrix& A, std::complex<Real> rate) {
  ComplexMatrix shifted = A.cast<std::complex<Real>>();
  shifted.diagonal().array() -= rate + std::complex<Real>(beside_rate, beside_rate);
  const ComplexMatrix inverted = inverse(shifted);
  Index largest = 0;
  inverted.colwise().squaredNorm().maxCoeff(&largest);
  ComplexMatrix v = inverted.col(largest).normalized();
  for (int step = 0; step < 2; ++step) v = (inverted * v).normalized().eval();
  const ComplexMatrix turned = v.adjoint();
  const ComplexMatrix parts = turned * inverted;
  const Real rest = (inverted - v * parts).norm();
  return {v.col(0), rest > 0 ? 1 / rest : std::numeric_limits<Real>::infinity()};
}

void find_shapes(const SteadyMotion& motion, Linearisation& linearisation) {
  linearisation.has_shapes = true;
  const std::optional<AllowedDeviations> allowed = allowed_deviations(motion);
  if (!allowed) return;
  const ComplexMatrix basis = allowed->basis.cast<std::complex<Real>>();
  for (const ToldMode& told : told_modes(linearisation)) {
    Mode& mode = linearisation.modes[told.mode];
    const std::complex<Real> rate(told.growth_rate / linearisation.pace, told.frequency / linearisation.pace);
    const RateMotion found = motion_of_rate(allowed->A, rate);
    if (!(found.apart > apart_enough)) continue;
    const ComplexMatrix x = found.motion, deviation = basis * x;
    mode.shape.clear();
    for (Index k = 0; k < deviation.rows() / 2; ++k) {
      const std::complex<Real> part = deviation(k, 0) * allowed->scale[k];
      mode.shape.emplace_back(static_cast<double>(part.real()), static_cast<double>(part.imag()));
    }
  }
}

std::vector<ToldMode> told_modes(const Linearisation& linearisation, int body) {
  std::vector<ToldMode> told;
  for (std::size_t i = 0; i < linearisation.modes.size(); ++i) {
    const Mode& mode = linearisation.modes[i];
    if (!has_body(mode, body)) continue;
    const double growth = std::abs(mode.growth_rate) > mode.doubt ? mode.growth_rate : 0;
    const double frequency = mode.frequency > mode.doubt ? mode.frequency : 0;
    const double size = std::hypot(growth, frequency);
    if (!(size > 0)) continue;
    const int times = mode.frequency > 0 && frequency == 0 ? 2 : 1;
    for (int k = 0; k < times; ++k) told.push_back({growth, frequency, growth == 0 ? 0 : -growth / size, i});
  }
  std::ranges::sort(told, {}, &ToldMode::frequency);
  for (auto first = told.begin(); first != told.end();) {
    auto last = first + 1;
    while (last != told.end() && last->frequency - (last - 1)->frequency <= as_fast * linearisation.pace) ++last;
    std::sort(first, last, [](const ToldMode& a, const ToldMode& b) { return a.growth_rate < b.growth_rate; });
    first = last;
  }
  return told;
}

double growth_rate(const Linearisation& linearisation, int body) {
  double largest = 0;
  for (const Mode& mode : linearisation.modes)
    if (has_body(mode, body) && mode.growth_rate > mode.doubt) largest = std::max(largest, mode.growth_rate);
  return largest;
}

std::vector<double> frequencies(const Linearisation& linearisation, int body) {
  std::vector<double> found;
  for (const Mode& mode : linearisation.modes)
    if (has_body(mode, body) && mode.frequency > mode.doubt) found.push_back(mode.frequency);
  std::sort(found.begin(), found.end());
  return found;
}

int vanishing_modes(const Linearisation& linearisation, int body) {
  return static_cast<int>(std::ranges::count_if(linearisation.modes, [&](const Mode& mode) {
    return has_body(mode, body) && !(std::abs(mode.growth_rate) > mode.doubt || mode.frequency > mode.doubt);
  }));
}

bool is_neutral(const Mode& mode) { return !(std::hypot(mode.growth_rate, mode.frequency) > mode.doubt); }

double slowest_rate(const std::vector<Mode>& modes) {
  double slowest = 0;
  for (const Mode& mode : modes) {
    const double size = std::hypot(mode.growth_rate, mode.frequency);
    if (!is_neutral(mode) && (slowest <= 0 || size < slowest)) slowest = size;
  }
  return slowest;
}

double slowest_beside_drifts(const Linearisation& linearisation) {
  // Rates that vanish together come out as roots of their rounding: parts of the pace, and of the other rates.
  constexpr double slow = 1e-3;
  double drift = -1;
  for (const Mode& mode : linearisation.modes) {
    const double size = std::hypot(mode.growth_rate, mode.frequency);
    if (!(mode.doubt <= slow * linearisation.pace) && size <= slow * linearisation.pace) drift = std::max(drift, size);
  }
  const double slowest = slowest_rate(linearisation.modes);
  return drift >= 0 && drift <= slow * slowest ? slowest : 0;
}

}  // namespace poinsot::solve
