#include "engine/solve/stability/told_rates.h"

#include <algorithm>
#include <cmath>

namespace poinsot::solve {
namespace {

// Whether each rate of this road that is no slow one is told once, with its damping ratio, and none else.
bool agrees_one_by_one(const Linearisation& found, const ComplexVector& own) {
  struct Listed {
    std::complex<Real> rate;
    Real damping_ratio;
    bool again;  // a slow swing, which differences may take for two rates that nearly meet
  };
  std::vector<Listed> told;
  const auto list = [&](double growth, double frequency, double ratio) {
    const std::complex<Real> rate = std::complex<Real>(growth, frequency) / Real(found.pace);
    told.push_back({rate, ratio, false});
    if (rate.imag() > 0 && rate.imag() <= far_rate) told.push_back({rate, ratio, true});
  };
  for (const ToldMode& one : told_modes(found)) list(one.growth_rate, one.frequency, one.damping_ratio);
  for (const Mode& mode : found.modes)
    if (mode.moves.empty()) list(0, mode.frequency, 0);
  for (const std::complex<Real>& rate : own) {
    if (rate.imag() < -far_rate || std::abs(rate) <= slow_rate) continue;
    const auto nearest =
        std::ranges::min_element(told, {}, [&](const Listed& one) { return std::abs(one.rate - rate); });
    const bool met = nearest != told.end() && std::abs(nearest->rate - rate) <= far_rate &&
                     std::abs(nearest->damping_ratio + rate.real() / std::abs(rate)) <= 2 * far_rate / std::abs(rate);
    if (met)
      told.erase(nearest);
    else if (rate.imag() >= 0)
      return false;
  }
  return std::ranges::all_of(told,
                             [](const Listed& one) { return one.again || std::abs(one.rate) <= slow_rate + far_rate; });
}

}  // namespace

// Whether what is told of all modes together is what the rates of this road say.
bool agrees(const Linearisation& found, const ComplexVector& own) {
  const auto in_pace = [&](double rate) { return Real(rate) / Real(found.pace); };
  std::vector<Real> frequencies;
  Real growth = 0;
  for (const std::complex<Real>& rate : own) {
    growth = std::max(growth, rate.real());
    if (rate.imag() > slow_rate) frequencies.push_back(rate.imag());
  }
  // Displacements that only go round are no oscillations.
  // Rates that meet exactly are not told one by one.
  const bool known =
      std::ranges::all_of(found.modes, [&](const Mode& mode) { return mode.doubt <= far_rate * Real(found.pace); });
  if (known && !agrees_one_by_one(found, own)) return false;
  std::vector<double> told = solve::frequencies(found);
  for (const Mode& mode : found.modes)
    if (mode.moves.empty()) told.push_back(mode.frequency);
  for (const Real frequency : frequencies) {
    const auto nearest =
        std::ranges::min_element(told, {}, [&](double one) { return std::abs(in_pace(one) - frequency); });
    if (nearest == told.end() || std::abs(in_pace(*nearest) - frequency) > far_rate) return false;
    told.erase(nearest);
  }
  if (std::ranges::any_of(told, [&](double one) { return in_pace(one) > slow_rate + far_rate; })) return false;
  const bool grows = stability(found) == Stability::unstable;
  if (growth > slow_rate && (!grows || std::abs(in_pace(growth_rate(found)) - growth) > far_rate)) return false;
  return !grows || in_pace(growth_rate(found)) <= slow_rate + far_rate || growth > slow_rate - far_rate;
}

}  // namespace poinsot::solve
