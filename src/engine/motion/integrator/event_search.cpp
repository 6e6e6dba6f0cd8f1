#include "engine/motion/integrator/event_search.h"

#include <algorithm>
#include <array>
#include <boost/math/tools/minima.hpp>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace poinsot {

namespace {

// Of the polynomials that stand for an event's value within a step: that of the step's own polynomials.
constexpr int degree = 8;
// Of a step: a value that swings more than a few hundred times in a step that follows the motion is noise.
constexpr int most_halvings = 7;
// Of the values on a piece: what the last three coefficients of its polynomial may add up to. Extremes and zeros are
// then off by a hundredth of the piece at most, the root of this where two meet, and are refined on the value itself.
constexpr double largest_tail = 1e-4;
// Of half a piece: the zero of the polynomial, from which that of the value is sought.
constexpr double zero_to = 1e-12;
using Coefficients = std::array<double, degree + 1>;

// cos(pi k/8), from the start of the piece (-1) to its end (1).
std::array<double, degree + 1> chebyshev_points() {
  std::array<double, degree + 1> points;
  for (int k = 0; k <= degree; ++k) points[k] = -std::cos(std::numbers::pi * k / degree);
  points[degree / 2] = 0.0;
  return points;
}

// Chebyshev coefficients of the interpolant through the values at the points above.
Coefficients chebyshev_coefficients(const std::array<double, degree + 1>& values) {
  Coefficients c{};
  for (int j = 0; j <= degree; ++j) {
    double sum = 0.0;
    for (int k = 0; k <= degree; ++k) {
      // T_j(-cos(pi k/8)) = (-1)^j cos(pi j k/8)
      const double weight = k == 0 || k == degree ? 0.5 : 1.0;
      sum += weight * values[k] * std::cos(std::numbers::pi * j * k / degree);
    }
    c[j] = (j % 2 == 0 ? 1.0 : -1.0) * sum * (j == 0 || j == degree ? 1.0 : 2.0) / degree;
  }
  return c;
}

// Powers of x from Chebyshev coefficients.
Coefficients powers(const Coefficients& c) {
  Coefficients before{};
  Coefficients now{};
  Coefficients sum{};
  before[0] = 1.0;
  now[1] = 1.0;
  sum[0] = c[0];
  for (int j = 1; j <= degree; ++j) {
    for (int k = 0; k <= degree; ++k) sum[k] += c[j] * now[k];
    Coefficients next{};
    for (int k = 0; k <= degree; ++k) next[k] = (k > 0 ? 2.0 * now[k - 1] : 0.0) - before[k];
    before = now;
    now = next;
  }
  return sum;
}

double evaluate(const double* p, int top, double x) {
  double y = p[top];
  for (int k = top; k-- > 0;) y = p[k] + x * y;
  return y;
}

// All zeros in (-1, 1) of the polynomial with coefficients p[0..top], between the zeros of its derivative.
std::vector<double> polynomial_zeros(const double* p, int top) {
  if (top == 0) return {};
  Coefficients derivative{};
  for (int k = 1; k <= top; ++k) derivative[k - 1] = k * p[k];
  std::vector<double> marks = polynomial_zeros(derivative.data(), top - 1);
  marks.insert(marks.begin(), -1.0);
  marks.push_back(1.0);
  std::vector<double> zeros;
  for (std::size_t i = 0; i + 1 < marks.size(); ++i) {
    double low = marks[i];
    double high = marks[i + 1];
    double at_low = evaluate(p, top, low);
    const double at_high = evaluate(p, top, high);
    if (at_high == 0.0 && i + 2 < marks.size()) zeros.push_back(high);
    if (!(at_low * at_high < 0.0)) continue;
    for (int k = 0; k < 40 && high - low > zero_to; ++k) {
      const double middle = 0.5 * (low + high);
      const double value = evaluate(p, top, middle);
      if ((value < 0.0) == (at_low < 0.0)) {
        low = middle;
        at_low = value;
      } else {
        high = middle;
      }
    }
    zeros.push_back(0.5 * (low + high));
  }
  return zeros;
}

class Finder {
 public:
  explicit Finder(const ZeroSearch& search) : search_(search) {}

  std::vector<Zero> run() {
    double start = search_.start;
    double value = search_.value(start);
    if (search_.from_zero || value == 0.0) {
      // From where the value has left zero.
      const double sense = search_.end > search_.start ? 1.0 : -1.0;
      const double moved = start + sense * std::min(search_.resolution, 0.5 * std::fabs(search_.end - start));
      if (moved != start) {
        start = moved;
        value = search_.value(start);
      }
    }
    scan(start, value, search_.end, search_.value(search_.end), 0);
    return std::move(zeros_);
  }

 private:
  void scan(double a, double at_a, double b, double at_b, int halvings) {
    static const std::array<double, degree + 1> points = chebyshev_points();
    std::array<double, degree + 1> values;
    double largest = std::max(std::fabs(at_a), std::fabs(at_b));
    values[0] = at_a;
    values[degree] = at_b;
    for (int k = 1; k < degree; ++k) {
      values[k] = search_.value(time_of(a, b, points[k]));
      largest = std::max(largest, std::fabs(values[k]));
    }
    if (!(largest > 0.0) || !std::isfinite(largest)) return;
    const Coefficients c = chebyshev_coefficients(values);
    const double tail = std::fabs(c[degree]) + std::fabs(c[degree - 1]) + std::fabs(c[degree - 2]);
    double rest = 2.0 * tail;
    for (int k = 1; k <= degree; ++k) rest += std::fabs(c[k]);
    if (std::fabs(c[0]) > rest + search_.touch) return;
    if (tail > largest_tail * largest && halvings < most_halvings) {
      const double middle = 0.5 * (a + b);
      scan(a, at_a, middle, values[degree / 2], halvings + 1);
      scan(middle, values[degree / 2], b, at_b, halvings + 1);
      return;
    }

    // The true value at the ends and at the extremes of the interpolant.
    const Coefficients p = powers(c);
    Coefficients slope{};
    for (int k = 1; k <= degree; ++k) slope[k - 1] = k * p[k];
    std::vector<std::pair<double, double>> marks{{a, at_a}};
    for (const double x : polynomial_zeros(slope.data(), degree - 1)) {
      const double t = time_of(a, b, x);
      marks.emplace_back(t, search_.value(t));
    }
    marks.emplace_back(b, at_b);
    // Where the interpolant cannot tell whether an extreme reaches zero, the value's own extreme does.
    for (std::size_t i = 1; i + 1 < marks.size(); ++i) {
      const double sign = marks[i].second < 0.0 ? -1.0 : 1.0;
      const bool nearest = sign * marks[i - 1].second > 0.0 && sign * marks[i + 1].second > 0.0 &&
                           sign * marks[i].second > 0.0 && sign * marks[i].second <= 4.0 * tail;
      if (!nearest) continue;
      const auto found = least(sign, marks[i - 1].first, marks[i].first, marks[i + 1].first);
      // Beyond zero by no more than rounding it only touches.
      const double rounding = std::max(search_.touch, 16.0 * std::numeric_limits<double>::epsilon() * largest);
      if (sign * found.second > 0.0 || sign * found.second < -rounding) marks[i] = found;
    }
    for (std::size_t i = 0; i + 1 < marks.size(); ++i) {
      const auto& [left, at_left] = marks[i];
      const auto& [right, at_right] = marks[i + 1];
      const bool is_extreme = i + 2 < marks.size();
      if (at_left * at_right < 0.0) {
        add(locate(left, at_left, right, at_right), at_right > 0.0 ? 1 : -1);
      } else if (at_right == 0.0) {
        // Zero exactly at a mark: a crossing if the value beyond has the other sign, else a touch.
        const double beyond = is_extreme ? marks[i + 2].second : 0.0;
        if (is_extreme && beyond * at_left >= 0.0) {
          if (search_.touch > 0.0) add(right, 0);
        } else {
          add(right, at_left < 0.0 ? 1 : -1);
        }
      } else if (is_extreme && std::fabs(at_right) <= search_.touch && at_right * marks[i + 2].second > 0.0) {
        add(right, 0);
      }
    }
  }

  static double time_of(double a, double b, double x) { return 0.5 * ((1.0 - x) * a + (1.0 + x) * b); }

  // The place between two times where sign times the value is least, and the value there; near `middle`.
  std::pair<double, double> least(double sign, double a, double middle, double b) const {
    const double low = std::min(a, b), high = std::max(a, b), width = 0.1 * (high - low);
    boost::uintmax_t evaluations = 60;
    const auto [time, value] = boost::math::tools::brent_find_minima([&](double t) { return sign * search_.value(t); },
                                                                     std::max(low, middle - width),
                                                                     std::min(high, middle + width), 40, evaluations);
    return {time, sign * value};
  }

  double locate(double a, double at_a, double b, double at_b) const {
    if (a > b) {
      std::swap(a, b);
      std::swap(at_a, at_b);
    }
    boost::uintmax_t evaluations = 60;
    const auto [low, high] = boost::math::tools::toms748_solve(
        search_.value, a, b, at_a, at_b, boost::math::tools::eps_tolerance<double>(51), evaluations);
    return 0.5 * (low + high);
  }

  void add(double t, int direction) {
    if (!zeros_.empty() && zeros_.back().time == t) return;  // at the seam of two pieces
    zeros_.push_back({t, direction});
  }

  const ZeroSearch& search_;
  std::vector<Zero> zeros_;
};

// The only extreme between two times: where the slope by differences of sixth order vanishes, or if that has one sign
// there, by the values.
double extreme_between(const std::function<double(double t)>& value, double a, double b) {
  constexpr double reach = 0.02;  // of the bracket
  const double h = reach * (b - a);
  const auto slope = [&](double t) {
    return 45 * (value(t + h) - value(t - h)) - 9 * (value(t + 2 * h) - value(t - 2 * h)) +
           (value(t + 3 * h) - value(t - 3 * h));
  };
  const double low = a + 3 * h, high = b - 3 * h, at_low = slope(low), at_high = slope(high);
  boost::uintmax_t evaluations = 60;
  if ((at_low < 0) != (at_high < 0)) {
    const auto [left, right] = boost::math::tools::toms748_solve(
        slope, low, high, at_low, at_high, boost::math::tools::eps_tolerance<double>(50), evaluations);
    return 0.5 * (left + right);
  }
  const double sense = value(0.5 * (a + b)) > 0.5 * (value(a) + value(b)) ? -1 : 1;
  return boost::math::tools::brent_find_minima([&](double t) { return sense * value(t); }, a, b, 50, evaluations).first;
}

}  // namespace

std::vector<Zero> find_zeros(const ZeroSearch& search) { return Finder(search).run(); }

std::vector<double> corners_between(const std::function<double(double t)>& value, bool turns,
                                    const std::vector<double>& looks) {
  std::vector<double> seen, found;
  double largest = 0.0;
  for (const double look : looks) {
    seen.push_back(value(look));
    largest = std::max(largest, std::fabs(seen.back()));
  }
  // Of the largest value: what changes by less from look to look, at rest or at a constant value, is rounding.
  constexpr double changes = 1e-12;
  for (std::size_t i = 0; i + 1 < looks.size(); ++i) {
    if (!turns && seen[i] * seen[i + 1] < 0) {
      double a = looks[i], b = looks[i + 1], at_a = seen[i], at_b = seen[i + 1];
      if (a > b) {
        std::swap(a, b);
        std::swap(at_a, at_b);
      }
      boost::uintmax_t evaluations = 60;
      const auto [low, high] = boost::math::tools::toms748_solve(
          value, a, b, at_a, at_b, boost::math::tools::eps_tolerance<double>(52), evaluations);
      found.push_back(0.5 * (low + high));
    }
    if (turns && i > 0 && (seen[i] - seen[i - 1]) * (seen[i + 1] - seen[i]) < 0 &&
        std::max(std::fabs(seen[i] - seen[i - 1]), std::fabs(seen[i + 1] - seen[i])) > changes * largest)
      found.push_back(
          extreme_between(value, std::min(looks[i - 1], looks[i + 1]), std::max(looks[i - 1], looks[i + 1])));
  }
  return found;
}

}  // namespace poinsot
