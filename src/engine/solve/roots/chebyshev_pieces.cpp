#include "engine/solve/roots/chebyshev_pieces.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/solve/linear/decompositions.h"

namespace poinsot::solve {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// half widths below which a piece is not divided further: if there are many pieces, and in any case
constexpr double small_half = 1.0 / 2048, least_half = 1e-7;
// As parts of the half width of the square: the rounding of a place in it, and the half width of a part below which
// places in it differ in their last three digits only.
constexpr double last_digits = 1e-15, narrowest_half = 1e-13;
constexpr std::size_t many = 60;
constexpr double noise_factor = 30;  // a piece is left undecided if its polynomial is within this many errors of zero
constexpr std::size_t suspicious = 300;    // with more pieces than this alive at a time, a curve of zeros is looked for
constexpr std::size_t most_pieces = 2500;  // with more pieces than this alive at a time, the division ends

struct Part {
  Piece piece;
  ChebyshevSeries series;  // on the piece
  double error;
};

// The polynomial of a part on a smaller rectangle from lower to upper, in the part's variables |s_k| <= 1.
Part narrowed(const Part& part, const Pair& lower, const Pair& upper) {
  Part result = part;
  for (int k = 0; k < 2; ++k) {
    const auto i = static_cast<std::size_t>(k);
    const double middle = (lower[i] + upper[i]) / 2, half = (upper[i] - lower[i]) / 2;
    if (half >= 1) continue;
    if (part.series.size(k) > 1) result.series = result.series.restricted(k, middle, half);
    result.piece.middle[i] += part.piece.half[i] * middle;
    result.piece.half[i] *= half;
  }
  return result;
}

// By how much the constant coefficient exceeds the sum of the others, for the combination of components given by a
// unit vector. If this is positive the combination has no zero.
double excess(const MatrixXd& coefficients, const VectorXd& unit) {
  const VectorXd c = coefficients.transpose() * unit;
  return 2 * std::abs(c[0]) - c.cwiseAbs().sum();
}

// Damped Gauss-Newton steps to the smallest value of the polynomial in or near the square.
Pair settled(const ChebyshevSeries& series, Pair s) {
  MatrixXd J;
  VectorXd F = series.with_slopes(s, J);
  double lambda = 1e-6;
  for (int iteration = 0; iteration < 60; ++iteration) {
    const Eigen::Matrix2d A = J.transpose() * J;
    const Eigen::Vector2d g = J.transpose() * F;
    bool better = false;
    for (int attempt = 0; attempt < 10 && !better; ++attempt, lambda *= 10) {
      Eigen::Matrix2d damped = A;
      damped.diagonal().array() += lambda * A.trace() + 1e-300;
      const Eigen::Vector2d step = damped.ldlt().solve(-g);
      if (!step.allFinite()) break;
      const Pair next{std::clamp(s[0] + step[0], -1.0, 1.0), std::clamp(s[1] + step[1], -1.0, 1.0)};
      MatrixXd J_next;
      const VectorXd F_next = series.with_slopes(next, J_next);
      if (F_next.norm() >= F.norm()) continue;
      s = next;
      F = F_next;
      J = J_next;
      better = true;
      lambda /= 1000;
    }
    lambda = std::clamp(lambda, 1e-14, 1e6);
    if (!better) break;
  }
  return s;
}

class PieceDivision {
 public:
  PieceDivision(const ChebyshevSeries& series, double error, double touching) : whole_(series), touching_(touching) {
    for (int k = 0; k < 2; ++k)
      if (series.size(k) > 1) active_.push_back(k);
    Part first{{}, series, error};
    for (int k = 0; k < 2; ++k)
      if (series.size(k) == 1) first.piece.half[static_cast<std::size_t>(k)] = 0;
    first.error += first.series.trim(0.01 * error);
    error_ = error;
    alive_.push_back(std::move(first));
  }

  PieceZeros run() {
    // All pieces of one size are treated before smaller ones: their number tells a curve of zeros from single points.
    while (!alive_.empty()) {
      std::vector<Part> level;
      level.swap(alive_);
      least_half_now_ = level.size() > many ? small_half : least_half;
      for (Part& part : level) treat(part);
      if (alive_.size() > suspicious && !looked_for_curve_) {
        looked_for_curve_ = true;
        std::vector<Piece> pieces;
        for (const Part& part : alive_) pieces.push_back(part.piece);
        result_.curve = curve_among(pieces);
      }
      if (result_.curve || alive_.size() > most_pieces) {
        for (const Part& part : alive_) result_.left.push_back(part.piece);
        alive_.clear();
      }
    }
    if (!result_.left.empty() && !result_.curve) result_.curve = curve_among(result_.left);
    return std::move(result_);
  }

 private:
  void treat(Part& part) {
    const MatrixXd& C = part.series.coefficients();
    const VectorXd constant = C.col(0);
    const double size = constant.norm();
    double others = 0;
    for (Index k = 1; k < C.cols(); ++k) others += C.col(k).norm();
    const double clearance = size > 0 ? std::max(size - others, excess(C, constant / size)) : 0;
    if (clearance > part.error) {
      if (clearance < touching_) note_touching(part);
      return;
    }
    if (size + others <= noise_factor * part.error || active_.empty()) {
      result_.left.push_back(part.piece);
      return;
    }

    // J holds the slopes in the middle of the piece; narrow() also looks at the combinations of components
    // perpendicular to its columns, which can vanish only by curvature.
    const auto n = static_cast<Index>(active_.size());
    MatrixXd J(C.rows(), n);
    for (Index k = 0; k < n; ++k) {
      const int variable = active_[static_cast<std::size_t>(k)];
      J.col(k).setZero();
      if (part.series.size(variable) > 1) J.col(k) = part.series.coefficient(variable == 0, variable == 1);
    }
    const Eigen::ColPivHouseholderQR<MatrixXd> qr(J);
    // Slopes that differ less are those of one direction, as far as the polynomial's own error, 1e-12, tells.
    constexpr double one_direction = 1e-12;
    const bool regular = C.rows() >= n && qr.rank() == n && qr.maxPivot() > 0 &&
                         std::abs(qr.matrixR()(n - 1, n - 1)) > one_direction * qr.maxPivot();
    if (regular && narrow(part, J, qr)) return;

    bool small = true;
    for (int k : active_) small = small && part.piece.half[static_cast<std::size_t>(k)] < least_half_now_;
    if (small)
      result_.left.push_back(part.piece);
    else
      divide(part);
  }

  void note_touching(const Part& part) {
    constexpr std::size_t enough = 100;
    if (result_.touching.size() >= enough) return;
    const Pair s = settled(part.series, {0, 0});
    if (part.series(s).norm() > touching_) return;
    Pair lowest = part.piece.middle;
    for (std::size_t k = 0; k < 2; ++k) lowest[k] += part.piece.half[k] * s[k];
    result_.touching.push_back(lowest);
  }

  // Returns whether the part is done with: it has no zero, or its only zero is found, or a narrower part has replaced
  // it.
  bool narrow(Part& part, const MatrixXd& J, const Eigen::ColPivHouseholderQR<MatrixXd>& qr) {
    const Index n = J.cols();
    const MatrixXd& C = part.series.coefficients();
    const MatrixXd P = qr.solve(MatrixXd::Identity(C.rows(), C.rows()));
    VectorXd rest = C.col(0) - J * (P * C.col(0));
    if (C.rows() > n && rest.norm() > part.error) {
      const double clearance = excess(C, rest.normalized());
      if (clearance > std::max(part.error, touching_)) return true;
      if (clearance > part.error) {
        note_touching(part);
        return true;
      }
    }

    // G = P F, with P the pseudo-inverse of the slopes, is nearly s - s_zero.
    ChebyshevSeries G(n, part.series.size(0), part.series.size(1));
    G.coefficients() = P * C;
    VectorXd error(n), departure = VectorXd::Zero(n);
    for (Index i = 0; i < n; ++i) {
      error[i] = P.row(i).norm() * part.error;
      if (excess(G.coefficients(), VectorXd::Unit(n, i)) > error[i]) return true;
    }
    for (Index k = 0; k < n; ++k) {
      const int variable = active_[static_cast<std::size_t>(k)];
      ChebyshevSeries slope = G.derivative(variable);
      // The slopes of the error are bounded by Markov's inequality: at most the square of the degree times the error.
      const double degree = static_cast<double>(part.series.size(variable) - 1);
      slope.coefficient(0, 0)[k] -= 1;
      departure += slope.coefficients().cwiseAbs().rowwise().sum() + degree * degree * error;
    }
    if (!(departure.maxCoeff() < 1)) return false;

    // The part has at most one zero. Newton's method on G finds it.
    VectorXd s = -G({0, 0});
    const auto place = [&](const VectorXd& v) {
      Pair pair{0, 0};
      for (Index k = 0; k < n; ++k)
        pair[static_cast<std::size_t>(active_[static_cast<std::size_t>(k)])] = std::clamp(v[k], -1.5, 1.5);
      return pair;
    };
    const VectorXd start = s;
    for (int iteration = 0; iteration < 12; ++iteration) {
      MatrixXd slopes;
      const VectorXd value = G.with_slopes(place(s), slopes);
      MatrixXd active_slopes(n, n);
      for (Index k = 0; k < n; ++k) active_slopes.col(k) = slopes.col(active_[static_cast<std::size_t>(k)]);
      const VectorXd step = active_slopes.partialPivLu().solve(value);
      if (!step.allFinite() || s.cwiseAbs().maxCoeff() > 1.5) break;
      s -= step;
      if (step.norm() < last_digits) break;
    }
    // The square goes from -1 to 1. A zero on the border of two is taken in both rather than in none.
    constexpr double border = 1e-9;
    if (s.allFinite() && s.cwiseAbs().maxCoeff() <= 1 + border) {
      // The zero of G must be one of F too: G combines the components of F, and the others may not vanish there.
      if (part.series(place(s)).norm() > std::max(5 * part.error, touching_)) return true;
      Pair zero = part.piece.middle;
      const Pair at = place(s);
      for (std::size_t k = 0; k < 2; ++k) zero[k] += part.piece.half[k] * at[k];
      result_.zeros.push_back(zero);
      return true;
    }
    Pair lower{-1, -1}, upper{1, 1};
    double narrowest = 1;
    for (Index k = 0; k < n; ++k) {
      const auto i = static_cast<std::size_t>(active_[static_cast<std::size_t>(k)]);
      lower[i] = std::max(-1.0, start[k] - departure[k] - error[k]);
      upper[i] = std::min(1.0, start[k] + departure[k] + error[k]);
      if (!(lower[i] <= upper[i])) return true;
      // A part must not shrink to a point, on which every polynomial is constant.
      const double least = 1e-3;
      if (upper[i] - lower[i] < least) {
        lower[i] = std::max(-1.0, std::min(lower[i], 1 - least));
        upper[i] = lower[i] + least;
      }
      narrowest = std::min(narrowest, (upper[i] - lower[i]) / 2);
    }
    if (narrowest > 0.7) return false;
    Part narrower = narrowed(part, lower, upper);
    for (int k : active_)
      if (narrower.piece.half[static_cast<std::size_t>(k)] < narrowest_half) {
        result_.left.push_back(narrower.piece);
        return true;
      }
    narrower.error += narrower.series.trim(0.01 * part.error);
    alive_.push_back(std::move(narrower));
    return true;
  }

  // The part is divided across the variable in which the polynomial changes most, a little off the middle: zeros of
  // symmetrical problems lie in the middle.
  void divide(const Part& part) {
    int across = active_.front();
    double largest = -1;
    for (int k : active_) {
      double change = 0;
      for (Index j = 0; j < part.series.size(1); ++j)
        for (Index i = 0; i < part.series.size(0); ++i)
          change += static_cast<double>(k == 0 ? i * i : j * j) * part.series.coefficient(i, j).norm();
      if (part.piece.half[static_cast<std::size_t>(k)] < least_half_now_) change = -0.5;
      if (change > largest) {
        largest = change;
        across = k;
      }
    }
    constexpr double cut = 0.0137;
    const auto i = static_cast<std::size_t>(across);
    Pair lower{-1, -1}, upper{1, 1};
    upper[i] = cut;
    Part first = narrowed(part, lower, upper);
    upper[i] = 1;
    lower[i] = cut;
    Part second = narrowed(part, lower, upper);
    for (Part* half : {&first, &second}) {
      half->error += half->series.trim(0.01 * error_);
      alive_.push_back(std::move(*half));
    }
  }

  // Walks from a zero near the undecided pieces along the direction in which the polynomial does not change. If it
  // stays zero there, it vanishes along a curve.
  std::optional<std::array<Pair, 2>> curve_among(const std::vector<Piece>& pieces) const {
    const double zero = noise_factor * error_ + 1e-12 * whole_.coefficients().cwiseAbs().maxCoeff();
    constexpr double walk = 0.02;
    for (const double part : {0.5, 0.1, 0.9}) {
      const Piece& piece = pieces[static_cast<std::size_t>(part * static_cast<double>(pieces.size() - 1))];
      const Pair a = settled(whole_, piece.middle);
      MatrixXd J;
      if (whole_.with_slopes(a, J).norm() > zero) continue;
      const Eigen::JacobiSVD<MatrixXd> svd(J, Eigen::ComputeFullV);
      if (J.rows() >= 2 && svd.singularValues()[1] > 1e-3 * svd.singularValues()[0]) continue;
      for (const double way : {walk, -walk}) {
        Pair ahead{a[0] + way * svd.matrixV()(0, 1), a[1] + way * svd.matrixV()(1, 1)};
        if (active_.size() == 1) ahead = {a[0] + (active_[0] == 0 ? way : 0), a[1] + (active_[0] == 1 ? way : 0)};
        if (std::max(std::abs(ahead[0]), std::abs(ahead[1])) > 1) continue;
        const Pair b = settled(whole_, ahead);
        if (whole_(b).norm() <= zero && std::hypot(b[0] - a[0], b[1] - a[1]) > 0.5 * walk)
          return std::array<Pair, 2>{a, b};
      }
    }
    return std::nullopt;
  }

  const ChebyshevSeries& whole_;
  std::vector<int> active_;
  double error_, touching_, least_half_now_ = least_half;
  std::vector<Part> alive_;
  bool looked_for_curve_ = false;
  PieceZeros result_;
};

}  // namespace

PieceZeros zeros_of_pieces(const ChebyshevSeries& series, double error, double touching) {
  return PieceDivision(series, error, touching).run();
}

}  // namespace poinsot::solve
