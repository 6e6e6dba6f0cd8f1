#include "engine/solve/roots/chebyshev_fit.h"

#include <algorithm>
#include <cmath>

#include "engine/solve/linear/decompositions.h"

namespace poinsot::solve {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// The accuracy of a polynomial, as a part of the largest value. On a line it is near what the rounding of cancelling
// terms allows, so that a double zero, which is found to the root of this, is known to six digits. On a square, where
// values are many, a coarse polynomial does: what it leaves unresolved gets a new one on a smaller square.
constexpr double wanted_on_line = 1e-12, wanted_on_square = 1e-7;
constexpr double rounding_of_fit = 2e-15;  // of the size of the terms
// Accuracy where noise allows no better, of the size of the terms: a tenth of what counts as zero, or else such a zero
// could hide in the error.
constexpr double still_usable = 1e-10;
// the largest slope that far_from_zero reckons with, as a multiple of that of the whole range
constexpr double steepest = 1e6;
constexpr double safety = 4;  // factor by which the largest error may exceed those seen at a few places

// Whether a variable has an extent in the box; one without plays no part.
bool active(const Piece& box, int k) { return box.half[static_cast<std::size_t>(k)] > 0; }

}  // namespace

// The values of the equations along a line through a box, at growing numbers of inner Chebyshev points.
struct ChebyshevFitter::Line {
  enum class Outcome { polynomial, rough, partly_valued, no_value } outcome = Outcome::rough;
  Index degree = 0;
  MatrixXd values;
  double size = 0;     // of the terms
  double largest = 0;  // norm of values
  double least = 0;
  double tail = 0;  // the sum of the norms of the last coefficients
  double cut = 0;   // the place where the equations begin or cease to have values
};

Pair ChebyshevFitter::random_place(const Piece& box) {
  std::uniform_real_distribution<double> part(-1, 1);
  Pair t = box.middle;
  for (std::size_t k = 0; k < 2; ++k)
    if (box.half[k] > 0) t[k] += box.half[k] * part(random_);
  return t;
}

bool ChebyshevFitter::no_value_anywhere(const Piece& box, int places) {
  for (int i = 0; i < places; ++i)
    if (function_.at(random_place(box))) return false;
  return true;
}

// Decides a tiny box in which no polynomial fits, because of a jump or a corner. If its values stay large there is no
// root in it: else slopes would be more than `steepest` times those of the whole range.
bool ChebyshevFitter::far_from_zero(const Piece& box, double least, double largest) const {
  const Piece whole = function_.whole();
  double width = 0;
  for (std::size_t k = 0; k < 2; ++k)
    if (whole.half[k] > 0) width = std::max(width, box.half[k] / whole.half[k]);
  return least > 0.1 * largest && least > steepest * width * std::max(typical_, largest);
}

// Near a pole of F the function F / |F|^2 is smooth and bounded. Where it has a polynomial that fits, F has no zero.
bool ChebyshevFitter::smooth_inverse(const MatrixXd& values, double size) {
  // A value smaller than this part of the terms keeps less than ten digits, too few for the inverse to look smooth; and
  // of a smooth one the last fifth of the coefficients is below them.
  constexpr double least_value = 1e-6, least_tail = 1e-10;
  const VectorXd norms = values.colwise().norm();
  if (!(norms.minCoeff() > least_value * size)) return false;
  const MatrixXd inverse = values * norms.cwiseInverse().cwiseAbs2().asDiagonal();
  const VectorXd c = interpolated(inverse, values.cols(), 1).coefficients().colwise().norm();
  return c.tail(std::max<Index>(2, values.cols() / 5)).sum() < least_tail * c.maxCoeff();
}

ChebyshevFitter::Line ChebyshevFitter::along(const Piece& box, int variable, double other, int depth) {
  const auto k = static_cast<std::size_t>(variable);
  const auto place = [&](double s) {
    Pair t = box.middle;
    t[1 - k] += box.half[1 - k] * other;
    t[k] += box.half[k] * s;
    return t;
  };
  Line line;
  std::vector<std::optional<VectorXd>> known;
  line.least = std::numeric_limits<double>::infinity();
  Index most = depth > 3 ? 15 : 31;
  double tail_before = 0;
  for (Index count = 7; count <= most; count = 2 * count + 1) {
    // Every second point belongs to the coarser line as well, and its value is known.
    std::vector<std::optional<VectorXd>> values(static_cast<std::size_t>(count));
    std::size_t missing = 0;
    Index rows = -1;
    for (Index i = 0; i < count; ++i) {
      auto& value = values[static_cast<std::size_t>(i)];
      if (i % 2 == 1 && !known.empty()) {
        value = known[static_cast<std::size_t>(i / 2)];
      } else if (const auto sample = function_.at(place(inner_point(count, i)))) {
        value = sample->values;
        line.size = std::max(line.size, sample->size);
        line.largest = std::max(line.largest, sample->values.norm());
        line.least = std::min(line.least, sample->values.norm());
      }
      if (value && rows < 0) rows = value->size();
      if (value && value->size() != rows) value.reset();
      missing += !value;
    }
    if (missing == values.size()) {
      line.outcome = Line::Outcome::no_value;
      return line;
    }
    if (missing > 0) {
      // Some places have values and others have none: bisection finds the place where the values begin or cease.
      line.outcome = Line::Outcome::partly_valued;
      for (Index i = 0; i + 1 < count; ++i) {
        if (values[static_cast<std::size_t>(i)].has_value() == values[static_cast<std::size_t>(i + 1)].has_value())
          continue;
        double with = inner_point(count, i), without = inner_point(count, i + 1);
        if (!values[static_cast<std::size_t>(i)]) std::swap(with, without);
        for (int step = 0; step < 40; ++step) {
          const double between = (with + without) / 2;
          (function_.at(place(between)) ? with : without) = between;
        }
        line.cut = place((with + without) / 2)[k];
        return line;
      }
    }
    line.values.resize(rows, count);
    for (Index i = 0; i < count; ++i) line.values.col(i) = *values[static_cast<std::size_t>(i)];
    known = std::move(values);

    const VectorXd norms = interpolated(line.values, count, 1).coefficients().colwise().norm();
    const double wanted = function_.unknowns() == 1 ? wanted_on_line : wanted_on_square;
    const double tolerance = std::max(wanted * line.largest, rounding_of_fit * line.size);
    const Index last = count == 7 ? 2 : count / 5;
    line.tail = norms.tail(last).sum();
    const double worst = norms.tail(last).maxCoeff();
    const bool stagnant = count >= 31 && worst <= still_usable * line.size && worst > 0.1 * tail_before;
    if (worst <= tolerance || stagnant) {
      line.outcome = Line::Outcome::polynomial;
      const double floor = std::max(tolerance, worst);
      for (Index i = 0; i < count; ++i)
        if (norms[i] > floor) line.degree = i;
      return line;
    }
    // A higher degree is worth its evaluations if the coefficients fall quickly.
    if (count == 31 && function_.unknowns() == 1 && worst < 1e-2 * tail_before && depth <= 3) most = 63;
    tail_before = worst;
  }
  return line;
}

Fit ChebyshevFitter::fit(const Piece& box, int depth) {
  const bool line = !active(box, 0) || !active(box, 1);
  return line ? fit_line(box, depth) : fit_square(box, depth);
}

// Where the equations depend on each other, the polynomial is written for fewer combinations of them.
void ChebyshevFitter::finish(Fit& fit, const MatrixXd& values, double size) const {
  const auto norms = values.colwise().norm();
  fit.largest = norms.maxCoeff();
  fit.size = size;
  Eigen::ColPivHouseholderQR<MatrixXd> qr(fit.series.coefficients());
  const double negligible = 0.1 * rounding_of_fit * std::max(size, fit.largest);
  Index rank = 0;
  while (rank < std::min(qr.rows(), qr.cols()) && std::abs(qr.matrixR()(rank, rank)) > negligible) ++rank;
  rank = std::max<Index>(rank, 1);
  fit.basis = MatrixXd(qr.householderQ()).leftCols(rank);
  fit.error += 2 * negligible + rounding_of_fit * size;
  ChebyshevSeries reduced(rank, fit.series.size(0), fit.series.size(1));
  reduced.coefficients() = fit.basis.transpose() * fit.series.coefficients();
  fit.series = std::move(reduced);
}

std::optional<double> ChebyshevFitter::mismatch(const Piece& box, const Fit& fit, int places) {
  double worst = 0;
  for (int i = 0; i < places; ++i) {
    const Pair t = random_place(box);
    const auto sample = function_.at(t);
    if (!sample || sample->values.size() != fit.basis.rows()) return std::nullopt;
    Pair s{0, 0};
    for (std::size_t k = 0; k < 2; ++k)
      if (box.half[k] > 0) s[k] = (t[k] - box.middle[k]) / box.half[k];
    worst = std::max(worst, (sample->values - fit.basis * fit.series(s)).norm());
  }
  return worst;
}

Fit ChebyshevFitter::fit_line(const Piece& box, int depth) {
  const int variable = active(box, 0) ? 0 : 1;
  Fit fit;
  fit.across = variable;
  fit.cut = box.middle[static_cast<std::size_t>(variable)] + 0.0137 * box.half[static_cast<std::size_t>(variable)];
  const Line line = along(box, variable, 0, depth);
  if (line.outcome == Line::Outcome::no_value) {
    if (no_value_anywhere(box, 4)) fit.outcome = Fit::Outcome::no_value;
    return fit;
  }
  if (line.outcome == Line::Outcome::partly_valued) {
    fit.cut = line.cut;
    return fit;
  }
  if (!(typical_ > 0)) {
    std::vector<double> norms;
    for (Index i = 0; i < line.values.cols(); ++i) norms.push_back(line.values.col(i).norm());
    std::nth_element(norms.begin(), norms.begin() + static_cast<std::ptrdiff_t>(norms.size() / 2), norms.end());
    typical_ = norms[norms.size() / 2];
  }
  const Index count = line.values.cols();
  fit.series = variable == 0 ? interpolated(line.values, count, 1) : interpolated(line.values, 1, count);
  finish(fit, line.values, line.size);
  const bool polynomial = line.outcome == Line::Outcome::polynomial;
  const double estimate = fit.error + line.tail * (polynomial ? 1 : 4);
  const auto off = mismatch(box, fit, polynomial ? 2 : 4);
  if (!off) return fit;
  if (polynomial && *off <= std::max(100 * estimate, 10 * wanted_on_line * line.largest)) {
    fit.error = estimate + safety * *off;
    fit.error += fit.series.trim(0.1 * fit.error);
    fit.outcome = Fit::Outcome::polynomial;
    return fit;
  }
  // The degree does not suffice yet, but the box can be excluded if the constant term exceeds all others and the
  // error. This is trusted only if the coefficients fall, as those of a pole with a root beside it do not.
  const VectorXd norms = fit.series.coefficients().colwise().norm();
  const Index third = count / 3;
  const bool falling = norms.tail(third).maxCoeff() <= 0.2 * norms.segment(third, third).maxCoeff();
  const bool constant_exceeds =
      falling && *off <= estimate && norms[0] > norms.tail(norms.size() - 1).sum() + 2 * estimate;
  if (constant_exceeds || smooth_inverse(line.values, line.size) || far_from_zero(box, line.least, line.largest))
    fit.outcome = Fit::Outcome::no_root;
  return fit;
}

ChebyshevFitter::Square ChebyshevFitter::fit_square_with(const Piece& box, Index count0, Index count1) {
  Square square;
  Fit& fit = square.fit;
  MatrixXd values;
  double size = 0;
  for (Index j = 0; j < count1; ++j)
    for (Index i = 0; i < count0; ++i) {
      const auto sample = function_.at(
          {box.middle[0] + box.half[0] * inner_point(count0, i), box.middle[1] + box.half[1] * inner_point(count1, j)});
      if (!sample) return square;
      if (i == 0 && j == 0) values.resize(sample->values.size(), count0 * count1);
      if (sample->values.size() != values.rows()) return square;
      values.col(i + count0 * j) = sample->values;
      size = std::max(size, sample->size);
    }
  fit.series = interpolated(values, count0, count1);
  finish(fit, values, size);
  // The sizes of the last coefficients in each direction estimate what the polynomial leaves out.
  for (Index j = 0; j < count1 && count0 > 1; ++j) square.tail[0] += fit.series.coefficient(count0 - 1, j).norm();
  for (Index i = 0; i < count0 && count1 > 1; ++i) square.tail[1] += fit.series.coefficient(i, count1 - 1).norm();
  const auto off = mismatch(box, fit, 4);
  if (!off) return square;
  square.valued = true;
  const double worst = std::max({square.tail[0], square.tail[1], *off});
  square.converged = worst <= std::max(10 * wanted_on_square * fit.largest, 100 * rounding_of_fit * size);
  fit.error += square.tail[0] + square.tail[1] + safety * *off;
  fit.outcome = Fit::Outcome::polynomial;
  const VectorXd norms = fit.series.coefficients().colwise().norm();
  square.excludes_zero = norms[0] > norms.tail(norms.size() - 1).sum() + safety * fit.error;
  return square;
}

Fit ChebyshevFitter::fit_square(const Piece& box, int depth) {
  Fit divide;
  const Piece whole = function_.whole();
  const auto cut_across = [&](int k) {
    const auto i = static_cast<std::size_t>(k);
    divide.across = k;
    divide.cut = box.middle[i] + 0.0137 * box.half[i];
  };
  const int wider = box.half[0] / whole.half[0] >= box.half[1] / whole.half[1] ? 0 : 1;
  cut_across(wider);

  // The degrees are found on a line along each variable, and on a second line unless the degree on either is low: a
  // square costs little then, and shows by itself whether the degrees suffice.
  constexpr std::array<Pair, 2> offsets{{{-0.2718, 0.3142}, {0.8147, -0.7319}}};
  constexpr Index low_degree = 4;
  std::array<Index, 2> degree{};
  std::array<bool, 2> rough{};
  double least = std::numeric_limits<double>::infinity(), largest = 0;
  for (const Pair& offset : offsets)
    for (std::size_t k = 0; k < 2; ++k) {
      if (&offset != offsets.data() && (std::min(degree[0], degree[1]) <= low_degree || rough[k])) continue;
      const Line line = along(box, static_cast<int>(k), offset[k], depth);
      if (line.outcome == Line::Outcome::no_value) {
        if (no_value_anywhere(box, 12)) divide.outcome = Fit::Outcome::no_value;
        return divide;
      }
      if (line.outcome == Line::Outcome::partly_valued) {
        divide.across = static_cast<int>(k);
        divide.cut = line.cut;
        return divide;
      }
      if (!(typical_ > 0)) typical_ = line.largest / 2;
      least = std::min(least, line.least);
      largest = std::max(largest, line.largest);
      degree[k] = std::max(degree[k], line.degree);
      rough[k] = rough[k] || line.outcome == Line::Outcome::rough;
    }
  if (rough[0] || rough[1]) {
    cut_across(rough[0] && rough[1] ? wider : rough[0] ? 0 : 1);
    // Far from zero a polynomial of low degree suffices to show that there is no root.
    const Square coarse = fit_square_with(box, 5, 5);
    if (coarse.valued && (coarse.excludes_zero || far_from_zero(box, least, largest)))
      divide.outcome = Fit::Outcome::no_root;
    return divide;
  }
  // One degree more than the lines need shows what the polynomial leaves out.
  constexpr Index most_count = 30;
  std::array<Index, 2> count{};
  for (std::size_t k = 0; k < 2; ++k) count[k] = degree[k] == 0 ? 1 : degree[k] + 2;
  for (int attempt = 0; attempt < 3; ++attempt) {
    Square square = fit_square_with(box, count[0], count[1]);
    if (!square.valued) return divide;
    if (square.converged) {
      square.fit.error += square.fit.series.trim(0.1 * square.fit.error);
      return square.fit;
    }
    if (square.excludes_zero) {
      divide.outcome = Fit::Outcome::no_root;
      return divide;
    }
    // The box is divided, and the degree raised, in the variable whose last coefficients are larger; where they are
    // alike, in both.
    const bool first = square.tail[0] > 0.1 * square.tail[1], second = square.tail[1] > 0.1 * square.tail[0];
    if (first != second) cut_across(first ? 0 : 1);
    if (first) count[0] += std::max<Index>(2, count[0] / 2);
    if (second || !first) count[1] += std::max<Index>(2, count[1] / 2);
    if (std::max(count[0], count[1]) > most_count) break;
  }
  return divide;
}

}  // namespace poinsot::solve
