#include "problem/unknowns/stability_end.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace poinsot::problem {
namespace {

// Polynomials of degree eight: within a hundredth of the datum they leave some 1e-15 where nothing else happens nearby.
constexpr std::size_t count = 9;
// Two polynomials through different values must agree to this part of the datum: the rounding of squares of rates is a
// hundred times smaller, and an end that two degrees give differently is not known.
constexpr double agreement = 1e-11;

// Of the largest value: how well a polynomial foretells a value that it does not go through. Where no two rates meet,
// as where damped motions begin to grow, the squares on the two sides have nothing to do with each other.
constexpr double foretold = 1e-8;

struct Values {
  std::array<double, count> at{}, square{};
};

// Lagrange's polynomial through all values but one, in the barycentric form (J.-P. Berrut and L. N. Trefethen, SIAM
// Review 46, 501, 2004).
double polynomial(const Values& values, std::size_t without, double x) {
  double above = 0, below = 0;
  for (std::size_t i = 0; i < count; ++i) {
    if (i == without) continue;
    if (x == values.at[i]) return values.square[i];
    double weight = 1 / (x - values.at[i]);
    for (std::size_t k = 0; k < count; ++k)
      if (k != i && k != without) weight /= values.at[i] - values.at[k];
    above += weight * values.square[i];
    below += weight;
  }
  return above / below;
}

bool is_smooth(const Values& values) {
  double largest = 0;
  for (const double square : values.square) largest = std::max(largest, std::abs(square));
  for (std::size_t i = 0; i < count; ++i)
    if (!(std::abs(polynomial(values, i, values.at[i]) - values.square[i]) <= foretold * largest)) return false;
  return true;
}

double zero_between(const Values& values, std::size_t without, double negative, double positive) {
  while (true) {
    const double middle = 0.5 * (negative + positive);
    if (middle == negative || middle == positive) return middle;
    (polynomial(values, without, middle) < 0 ? negative : positive) = middle;
  }
}

// The difference of two rates i w: of a frequency and the one before it, or of the least and its conjugate.
double difference(const std::vector<double>& frequencies, std::size_t pair) {
  return pair == 0 ? 2 * frequencies[0] : frequencies[pair] - frequencies[pair - 1];
}

class Trial {
 public:
  // Looks at values around a place; they are not good if growth and stability do not lie on two sides.
  Trial(const std::function<std::optional<NearMotion>(double)>& near, double place, double reach) {
    for (std::size_t i = 0; i < count; ++i) {
      values_.at[i] = place + reach * std::cos((static_cast<double>(i) + 0.5) * M_PI / count);
      const std::optional<NearMotion> motion = near(values_.at[i]);
      if (!motion) return;
      motions_[i] = *motion;
    }
    std::size_t changes = 0;
    for (std::size_t i = 1; i < count; ++i)
      if (grows(i) != grows(i - 1)) {
        ++changes;
        last_ = grows(i) ? i - 1 : i;
        first_ = grows(i) ? i : i - 1;
      }
    good_ = changes == 1;
    for (std::size_t i = 0; i < count && good_; ++i)
      good_ = grows(i) || (!motions_[i].frequencies.empty() &&
                           motions_[i].frequencies.size() == motions_[last_].frequencies.size());
  }
  bool good() const { return good_; }
  double last_stable() const { return values_.at[last_]; }
  // The end, if the polynomials through the squares of some difference agree about it.
  std::optional<double> end() {
    const std::vector<double>& frequencies = motions_[last_].frequencies;
    std::vector<std::size_t> pairs(frequencies.size());
    for (std::size_t k = 0; k < pairs.size(); ++k) pairs[k] = k;
    std::ranges::sort(pairs, {}, [&](std::size_t k) { return difference(frequencies, k); });
    for (const std::size_t pair : pairs) {
      for (std::size_t i = 0; i < count; ++i) {
        const double size = grows(i) ? 2 * motions_[i].growth : difference(motions_[i].frequencies, pair);
        values_.square[i] = grows(i) ? size * size : -size * size;
      }
      const double stable = values_.at[last_], growing = values_.at[first_];
      near_ = zero_between(values_, count, stable, growing);
      if (!is_smooth(values_)) continue;
      const bool rising = std::abs(values_.at[0] - near_) < std::abs(values_.at[count - 1] - near_);
      const double other = zero_between(values_, rising ? count - 1 : 0, stable, growing);
      if (std::abs(other - near_) <= agreement * std::abs(near_)) return near_;
    }
    return std::nullopt;
  }
  double guess() const { return near_; }

 private:
  bool grows(std::size_t i) const { return motions_[i].growth > 0; }

  Values values_;
  std::array<NearMotion, count> motions_;
  std::size_t last_ = 0, first_ = 0;  // the last value on the stable side, and the first one on the other
  double near_ = 0;
  bool good_ = false;
};

}  // namespace

std::optional<StabilityEnd> stability_end(const std::function<std::optional<NearMotion>(double)>& near, double stable,
                                          double growing) {
  double place = 0.5 * (stable + growing), reach = std::abs(growing - stable);
  // Where other rates meet close by, a smaller neighbourhood has room for a polynomial.
  for (int narrowings = 0; narrowings < 4; ++narrowings) {
    Trial trial(near, place, reach);
    if (!trial.good()) return std::nullopt;
    if (const std::optional<double> end = trial.end()) return StabilityEnd{*end, trial.last_stable()};
    place = trial.guess();
    reach /= 8;
  }
  return std::nullopt;
}

}  // namespace poinsot::problem
