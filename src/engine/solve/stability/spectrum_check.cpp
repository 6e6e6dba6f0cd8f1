// The rates and shapes of the redundant equations (redundant_pencil.h) beside those that were found.
#include "poinsot/engine/solve/stability/spectrum_check.h"

#include <algorithm>
#include <cmath>

#include "engine/solve/stability/doubted_rates.h"
#include "engine/solve/stability/mode_shapes.h"
#include "engine/solve/stability/redundant_pencil.h"
#include "engine/solve/stability/same_motion.h"
#include "engine/solve/stability/told_rates.h"

namespace poinsot::solve {
namespace {

using Index = Eigen::Index;
// How far a number is from being a rate of x' = A x: the least change of A that makes it one.
Real distance(const Matrix& A, std::complex<Real> rate) {
  ComplexMatrix shifted = A.cast<std::complex<Real>>();
  shifted.diagonal().array() -= rate;
  const Real size = inverse(shifted).norm();
  return std::isfinite(size) ? 1 / size : 0;
}

// How far the shapes are from those of this road: the sine of the angle between both, in the space of all displacements
// and their rates. As far as rates nearly meet, the slopes of this road, which are differences, say less.
double shape_misfit(const RedundantPencil& pencil, const RedundantPencil::Allowed& allowed, const SteadyMotion& motion,
                    const Linearisation& found) {
  Real misfit = 0;
  const ComplexMatrix onto = Matrix(allowed.basis.transpose()).cast<std::complex<Real>>();
  for (const ToldMode& told : told_modes(found)) {
    const std::vector<std::complex<double>>& shape = found.modes[told.mode].shape;
    if (shape.empty()) continue;
    std::vector<double> real, imaginary;
    for (const std::complex<double>& part : shape) {
      real.push_back(part.real());
      imaginary.push_back(part.imag());
    }
    const Vector along = pencil.displacement(motion, real), across = pencil.displacement(motion, imaginary);
    const std::complex<Real> rate = std::complex<Real>(told.growth_rate, told.frequency) / Real(found.pace);
    ComplexMatrix x(2 * along.size(), 1);
    for (Index k = 0; k < along.size(); ++k) {
      x(k, 0) = {along[k], across[k]};
      x(along.size() + k, 0) = rate * x(k, 0);
    }
    const Real size = x.norm();
    if (!(size > 0)) return 1;
    const ComplexMatrix z = onto * x;
    const RateMotion own = motion_of_rate(allowed.A, rate);
    const std::complex<Real> common = own.motion.dot(z.col(0));
    // What no deviation that this road allows has, and what its own shape has not.
    const Real outside = std::sqrt(std::max(Real(0), size * size - z.squaredNorm())) / size;
    const Real beside = (z.col(0) - common * own.motion).norm() / size;
    misfit = std::max({misfit, outside, beside * std::min(Real(1), own.apart)});
  }
  return static_cast<double>(misfit);
}

std::complex<Real> nearest_to(const std::complex<Real>& rate, const ComplexVector& rates) {
  return *std::ranges::min_element(rates, {}, [&](const std::complex<Real>& one) { return std::abs(one - rate); });
}

// Swings that are slow beside a fast spin are no part of the pace that is looked at: whether they are told to the
// digits that are shown, where this road knows them to more. That it tells by steps of another length, with which what
// it leaves out changes.
bool slow_rates_agree(const RedundantBodies& bodies, const SteadyMotion& motion, const Linearisation& found,
                      const ComplexVector& own) {
  constexpr Real slow = 3e-2L, shown = 1e-5L, known = 1e-7L, doubted = 1e-6L;
  constexpr double stretched = 8;
  std::vector<std::complex<Real>> told;
  for (const Mode& mode : found.modes) {
    const std::complex<Real> rate(mode.growth_rate / found.pace, mode.frequency / found.pace);
    const Real size = std::abs(rate);
    if (size > 0 && size <= slow && Real(mode.doubt) <= doubted * size * Real(found.pace)) told.push_back(rate);
  }
  if (told.empty() || own.size() == 0) return true;
  const auto allowed = RedundantPencil(bodies, motion, found.pace, stretched).allowed();
  const std::optional<Spectrum> again = allowed ? spectrum_of(allowed->A, false) : std::nullopt;
  if (!again || again->value.size() != own.size()) return true;
  return std::ranges::all_of(told, [&](const std::complex<Real>& rate) {
    const std::complex<Real> here = nearest_to(rate, own), there = nearest_to(here, again->value);
    return std::abs(here - there) > known * std::abs(here) || std::abs(here - rate) <= shown * std::abs(rate);
  });
}

}  // namespace

std::optional<double> spectrum_misfit(const SteadyMotion& motion, const Linearisation& found) {
  if (!found.steady) return std::nullopt;
  const std::unique_ptr<RedundantBodies> bodies = RedundantBodies::find(motion);
  if (!bodies) return std::nullopt;
  const RedundantPencil pencil(*bodies, motion, found.pace);
  const std::optional<RedundantPencil::Allowed> allowed = pencil.allowed();
  if (!allowed) return std::nullopt;
  const Matrix& A = allowed->A;
  if (A.rows() != found.deviations) return 1;
  if (A.rows() == 0) return 0;
  std::vector<std::complex<Real>> told;
  Real misfit = 0;
  for (const Mode& mode : found.modes) {
    const std::complex<Real> rate(mode.growth_rate / found.pace, mode.frequency / found.pace);
    told.push_back(rate);
    if (mode.frequency != 0) told.push_back(std::conj(rate));
    misfit = std::max(misfit, distance(A, rate));
  }
  const std::optional<Spectrum> spectrum = spectrum_of(A, false);
  if (!spectrum) return 1;
  const ComplexVector& own = spectrum->value;
  for (Index m = 0; m < own.size(); ++m) {
    const auto nearest =
        std::ranges::min_element(told, {}, [&](const std::complex<Real>& rate) { return std::abs(rate - own[m]); });
    const Real off = nearest == told.end() ? 2 * far_rate + std::abs(own[m]) : std::abs(*nearest - own[m]);
    if (off <= far_rate) {
      told.erase(nearest);
    } else if (std::abs(own[m]) > slow_rate) {
      return 1;
    }
  }
  if (!agrees(found, own) || !slow_rates_agree(*bodies, motion, found, own)) return 1;
  return std::max(static_cast<double>(misfit), shape_misfit(pencil, *allowed, motion, found));
}

}  // namespace poinsot::solve
