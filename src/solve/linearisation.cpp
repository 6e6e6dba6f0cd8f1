#include "poinsot/solve/linearisation.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>

#include "poinsot/dynamics/kinematics.h"
#include "solve/doubted_rates.h"

namespace poinsot::solve {
namespace {

using Index = Eigen::Index;
using VectorXd = Eigen::VectorXd;
constexpr double rounding = std::numeric_limits<double>::epsilon();
// An oscillation whose rate is known less closely than this, of itself, is too near to growing.
constexpr double decisive = 1e-7;

// The adjoint of a twist: d/dt of a deviation's components on axes that move with the twist.
Eigen::Matrix<double, 6, 6> adjoint(const SpatialMotion<double>& twist) {
  const auto tilde = [](const Vector3<double>& a) {
    Eigen::Matrix3d m;
    m << 0, -a.z, a.y, a.z, 0, -a.x, -a.y, a.x, 0;
    return m;
  };
  Eigen::Matrix<double, 6, 6> ad = Eigen::Matrix<double, 6, 6>::Zero();
  ad.topLeftCorner<3, 3>() = tilde(twist.angular);
  ad.bottomLeftCorner<3, 3>() = tilde(twist.linear);
  ad.bottomRightCorner<3, 3>() = tilde(twist.angular);
  return ad;
}

bool vanishes(const Mode& mode) { return !(std::hypot(mode.growth_rate, mode.frequency) > mode.doubt); }

class Lineariser {
 public:
  explicit Lineariser(const SteadyMotion& motion)
      : motion_(motion), tree_(*motion.tree), n_(static_cast<Index>(motion.v.size())) {}

  Linearisation linearise() {
    Linearisation result;
    const VectorXd a = accelerations(motion_.q, motion_.v);
    // On axes that follow the frame but not the spin, velocities of a steady motion are constant.
    Eigen::MatrixXd spin = Eigen::MatrixXd::Zero(n_, n_), drift = Eigen::MatrixXd::Zero(n_, n_);
    for (int i = 0; i < tree_.body_count(); ++i) {
      const auto& body = tree_.body(i);
      if (body.joint != JointType::ball && body.joint != JointType::free) continue;
      const Index size = velocity_size(body.joint);
      SpatialMotion<double> twist = SpatialMotion<double>::zero();
      for (std::size_t k = 0; k < 3; ++k) {
        twist.angular[k] = motion_.v[static_cast<std::size_t>(body.v) + k];
        if (size == 6) twist.linear[k] = motion_.v[static_cast<std::size_t>(body.v) + 3 + k];
      }
      drift.block(body.v, body.v, size, size) = adjoint(twist).topLeftCorner(size, size);
      for (const auto& [spinning, own] : motion_.spins)
        if (spinning == i) spin.block(body.v, body.v, size, size) = adjoint(own).topLeftCorner(size, size);
    }
    result.pace = std::max(pace(), 1e-300);

    Doubted A{Matrix::Zero(2 * n_, 2 * n_), Matrix::Zero(2 * n_, 2 * n_)};
    A.value.topLeftCorner(n_, n_) = (spin - drift).cast<Real>();
    A.value.topRightCorner(n_, n_).setIdentity();
    const auto put = [&](Index column, const Slope& slope, Real length) {
      A.value.col(column).tail(n_) = slope.value.cast<Real>() / length;
      A.doubt.col(column).tail(n_) = slope.doubt.cast<Real>() / length;
    };
    for (Index k = 0; k < n_; ++k) {
      put(k, slope([&](double h) { return accelerations(displaced(k, h), motion_.v); }, 2e-3), unit(k));
      put(n_ + k, slope([&](double h) { return accelerations(motion_.q, hastened(k, h)); }, 2e-3 * result.pace),
          unit(k));
    }
    const std::optional<double> unrest = unrest_of(a, spin, A.value, result.pace);
    if (!unrest) {
      result.steady = false;
      return result;
    }
    A.value.bottomRightCorner(n_, n_) += spin.cast<Real>();
    A.doubt += 4 * rounding * A.value.cwiseAbs();
    // In natural units, rates as parts of the pace.
    Vector scale(2 * n_);
    for (Index k = 0; k < n_; ++k) {
      scale[k] = unit(k);
      scale[n_ + k] = unit(k) * result.pace;
    }
    for (Matrix* each : {&A.value, &A.doubt})
      *each = (scale.cwiseInverse().asDiagonal() * *each * scale.asDiagonal()).eval() / Real(result.pace);
    // As far as it does not quite rest, the entries belong to another motion near by.
    A.doubt.bottomRows(n_).array() += Real(*unrest);
    const Matrix symmetries = symmetries_of(A, scale);
    Vector coupled = Vector::Zero(2 * n_);
    const Matrix basis = deviations(scale, symmetries, coupled);
    // What is uncertain of the basis adds to what is of the entries.
    const Matrix size = basis.cwiseAbs();
    const Matrix off = coupled * Matrix::Ones(1, basis.cols());
    const Doubted reduced{basis.transpose() * A.value * basis, size.transpose() * A.doubt * size +
                                                                   off.transpose() * A.value.cwiseAbs() * size +
                                                                   size.transpose() * A.value.cwiseAbs() * off};
    const Rates rates = rates_of(reduced);
    for (Index m = 0; m < rates.value.size(); ++m) {
      const std::complex<Real> rate = rates.value[m];
      if (rate.imag() < 0) continue;  // its conjugate stands for it
      Mode mode;
      mode.growth_rate = static_cast<double>(rate.real() * Real(result.pace));
      mode.frequency = static_cast<double>(rate.imag() * Real(result.pace));
      // A margin, as the doubts of the entries are seen on a few differences only.
      mode.doubt = 4 * rates.doubt[m] * result.pace;
      const VectorXd moved = (basis * rates.motion.col(m).normalized()).cwiseAbs().cast<double>();
      for (int i = 0; i < tree_.body_count(); ++i) mode.moves.push_back(moves(i, moved));
      result.modes.push_back(std::move(mode));
    }
    leave_out(result, symmetries.cols());
    leave_out_drifts(result, turning_frequencies(A, scale));
    std::sort(result.modes.begin(), result.modes.end(), [](const Mode& one, const Mode& other) {
      return one.growth_rate != other.growth_rate ? one.growth_rate > other.growth_rate
                                                  : one.frequency < other.frequency;
    });
    return result;
  }

 private:
  double unit(Index coordinate) const {
    for (const auto& body : tree_.bodies()) {
      const Index k = coordinate - body.v;
      if (k < 0 || k >= velocity_size(body.joint)) continue;
      return body.joint == JointType::prismatic || (body.joint == JointType::free && k >= 3) ? motion_.length : 1;
    }
    return 1;
  }
  double pace() const {
    double fastest = 1 / motion_.time;
    for (Index k = 0; k < n_; ++k)
      fastest = std::max(fastest, std::abs(motion_.v[static_cast<std::size_t>(k)]) / unit(k));
    return fastest;
  }
  VectorXd accelerations(const std::vector<double>& q, const std::vector<double>& v) const {
    const auto a = motion_.accelerations(q, v);
    if (!a) throw std::runtime_error("the accelerations near the steady motion are not determined");
    return Eigen::Map<const VectorXd>(a->data(), n_);
  }
  std::vector<double> displaced(Index k, double h) const {
    std::vector<double> q = motion_.q, along(static_cast<std::size_t>(n_), 0.0);
    along[static_cast<std::size_t>(k)] = unit(k);
    integrate_position<double>(tree_, q, along, h);
    return q;
  }
  std::vector<double> hastened(Index k, double h) const {
    std::vector<double> v = motion_.v;
    v[static_cast<std::size_t>(k)] += h * unit(k);
    return v;
  }
  // The derivative at zero by differences of sixth order, and by how much those with other steps differ.
  struct Slope {
    VectorXd value, doubt;
  };
  template <class Function>
  static Slope slope(Function&& f, double h) {
    const auto difference = [&](double step) -> VectorXd {
      return (45.0 * (f(step) - f(-step)) - 9.0 * (f(2 * step) - f(-2 * step)) + (f(3 * step) - f(-3 * step))) /
             (60 * step);
    };
    const VectorXd one = difference(h), other = difference(0.7 * h), third = difference(1.3 * h);
    const VectorXd least = one.cwiseMin(other).cwiseMin(third), most = one.cwiseMax(other).cwiseMax(third);
    return {(one + other + third) / 3, most - least};
  }

  // By how much the velocities change, in natural units and parts of the pace; nothing if by more than the pose and
  // they may be off. A: before the spin is added.
  std::optional<double> unrest_of(const VectorXd& a, const Eigen::MatrixXd& spin, const Matrix& A, double pace) const {
    constexpr double closely = 1e-7;
    const Eigen::Map<const VectorXd> v(motion_.v.data(), n_);
    const VectorXd change = a + spin * v;
    const VectorXd turned = spin.cwiseAbs() * v.cwiseAbs();
    double largest = 0;
    for (Index k = 0; k < n_; ++k) {
      double terms = turned[k] + unit(k) / (motion_.time * motion_.time);
      for (Index j = 0; j < n_; ++j)
        terms += std::abs(static_cast<double>(A(n_ + k, j))) * unit(j) +
                 std::abs(static_cast<double>(A(n_ + k, n_ + j)) * v[j]);
      if (std::abs(change[k]) > closely * terms + 64 * rounding * unit(k) * pace * pace) return std::nullopt;
      largest = std::max(largest, std::abs(change[k]) / unit(k) / (pace * pace));
    }
    return largest;
  }

  // An orthonormal basis of the deviations that are possible: held coordinates do not deviate, constraints hold, and
  // displacements by a symmetry are none. coupled: by how much the basis may be off, of those deviations that depend on
  // others.
  Matrix deviations(const Vector& scale, const Matrix& symmetries, Vector& coupled) const {
    std::vector<Vector> rows;
    for (Index k = 0; k < n_; ++k)
      if (motion_.held[static_cast<std::size_t>(k)])
        for (Index part : {k, n_ + k}) {
          Vector row = Vector::Zero(2 * n_);
          row[part] = 1;
          rows.push_back(row);
        }
    const auto J = motion_.constraints(motion_.q);
    // d(J v)/dq v along each coordinate.
    const auto rates = [&](const std::vector<double>& q) {
      const auto there = motion_.constraints(q);
      VectorXd result(static_cast<Index>(there.size()));
      for (std::size_t i = 0; i < there.size(); ++i) {
        double sum = 0;
        for (std::size_t k = 0; k < motion_.v.size(); ++k) sum += there[i][k] * motion_.v[k];
        result[static_cast<Index>(i)] = sum;
      }
      return result;
    };
    Matrix bias(static_cast<Index>(J.size()), n_), bias_doubt = bias;
    if (!J.empty())
      for (Index k = 0; k < n_; ++k) {
        const Slope found = slope([&](double h) { return rates(displaced(k, h)); }, 2e-3);
        bias.col(k) = found.value.cast<Real>() / unit(k);
        bias_doubt.col(k) = found.doubt.cast<Real>() / unit(k);
      }
    const auto mark = [&](const Vector& row, Real doubt) {
      for (Index k = 0; k < 2 * n_; ++k)
        if (row[k] != 0) coupled[k] = std::max(coupled[k], doubt);
    };
    const auto add = [&](const Vector& row, Real doubt) {
      const Vector scaled = row.cwiseProduct(scale);
      const Real size = scaled.norm();
      if (!(size > 0)) return;
      mark(scaled, 8 * rounding + doubt / size);
      rows.push_back(scaled / size);
    };
    for (std::size_t i = 0; i < J.size(); ++i) {
      const auto at = static_cast<Index>(i);
      const Vector coefficients = Eigen::Map<const VectorXd>(J[i].data(), n_).cast<Real>();
      Vector row = Vector::Zero(2 * n_);
      row.head(n_) = coefficients;
      if (i < motion_.position_constraints) add(row, 0);
      row.head(n_) = bias.row(at).transpose();
      row.tail(n_) = coefficients;
      add(row, bias_doubt.row(at).transpose().cwiseProduct(scale.head(n_)).norm());
    }
    Matrix all(static_cast<Index>(rows.size()), 2 * n_);
    for (std::size_t i = 0; i < rows.size(); ++i) all.row(static_cast<Index>(i)) = rows[i].transpose();
    for (Index s = 0; s < symmetries.cols(); ++s)
      if ((symmetries.col(s).array() != 0).count() > 1) mark(symmetries.col(s), 8 * rounding);
    Matrix kernel = Matrix::Identity(2 * n_, 2 * n_);
    if (all.rows() > 0) kernel = complement(all.transpose());
    return symmetries.cols() == 0 ? kernel : Matrix(kernel * complement(kernel.transpose() * symmetries));
  }
  // An orthonormal basis of what is at right angles to all columns.
  static Matrix complement(const Matrix& columns) {
    Eigen::ColPivHouseholderQR<Matrix> qr(columns);
    qr.setThreshold(1e-9L);
    const Matrix Q = qr.householderQ() * Matrix::Identity(columns.rows(), columns.rows());
    return Q.rightCols(columns.rows() - qr.rank());
  }

  // Those displacements that do lead to the same motion again, independent of each other. What is left of A x must be
  // no more than the uncertainty of the terms that cancel in it: a slow motion beside a fast one has small entries that
  // are not zero.
  Matrix symmetries_of(const Doubted& A, const Vector& scale) const {
    Matrix found(2 * n_, 0);
    for (const Vector& x : displacements(scale)) {
      if (!is_rounding(A.value * x, A, x.cwiseAbs())) continue;
      Matrix more(2 * n_, found.cols() + 1);
      more << found, x;
      Eigen::ColPivHouseholderQR<Matrix> qr(more);
      qr.setThreshold(1e-9L);
      if (qr.rank() == more.cols()) found = more;
    }
    return found;
  }
  // The stated displacements, of length one.
  std::vector<Vector> displacements(const Vector& scale) const {
    std::vector<Vector> all;
    for (const std::vector<double>& stated : motion_.symmetries) {
      const Vector x = Eigen::Map<const VectorXd>(stated.data(), 2 * n_).cast<Real>().cwiseQuotient(scale);
      if (x.norm() > 0) all.push_back(x.normalized());
    }
    return all;
  }
  // Whether what is left is no more than the uncertainty of A x, with the sizes of x.
  bool is_rounding(const Vector& left, const Doubted& A, const Vector& size) const {
    constexpr Real closely = 1e-9L;
    const Real stiffness = n_ > 0 ? A.value.bottomLeftCorner(n_, n_).cwiseAbs().maxCoeff() : 0;
    // A spinning body whose center is on its axis but for rounding pulls as it turns, by as little of the square of the
    // pace. What is no small part of the stiffness there is, is taken for that of a slow motion.
    const Real unbalance = std::min<Real>(20 * rounding, 1e-4L * stiffness);
    const Vector allowed =
        10 * (A.doubt * size) + closely * (A.value.cwiseAbs() * size) + Vector::Constant(2 * n_, unbalance);
    return ((left.cwiseAbs() - allowed).array() <= 0).all();
  }
  // In a frame that turns, displacements across its axis that lead to the same motion go round in it: the frequencies
  // of the pairs that go over into each other.
  std::vector<Real> turning_frequencies(const Doubted& A, const Vector& scale) const {
    std::vector<Real> found;
    const std::vector<Vector> all = displacements(scale);
    for (std::size_t i = 0; i < all.size(); ++i)
      for (std::size_t k = i + 1; k < all.size(); ++k) {
        const Real common = all[i].dot(all[k]);
        const Vector &x = all[i], y = all[k] - common * x;
        if (!(y.norm() > 1e-6L)) continue;
        const Vector u = y.normalized(), size = x.cwiseAbs() + u.cwiseAbs();
        const Vector Ax = A.value * x, Au = A.value * u;
        const Real xx = x.dot(Ax), ux = u.dot(Ax), xu = x.dot(Au), uu = u.dot(Au);
        if (!(ux * xu < 0) || !is_rounding(Ax - xx * x - ux * u, A, size) ||
            !is_rounding(Au - xu * x - uu * u, A, size))
          continue;
        found.push_back(std::sqrt(-ux * xu));
      }
    return found;
  }
  // A symmetry has a conserved momentum: one more rate that vanishes and says nothing of stability.
  static void leave_out(Linearisation& result, Index count) {
    for (; count > 0; --count) {
      const auto least = std::min_element(result.modes.begin(), result.modes.end(), [](const Mode& a, const Mode& b) {
        return std::hypot(a.growth_rate, a.frequency) < std::hypot(b.growth_rate, b.frequency);
      });
      if (least == result.modes.end() || !vanishes(*least)) return;
      result.modes.erase(least);
    }
  }

  // Such a displacement at a steady rate goes round ever farther away: like that along the axis it is none of the
  // motion.
  static void leave_out_drifts(Linearisation& result, const std::vector<Real>& frequencies) {
    std::erase_if(result.modes, [&](const Mode& mode) {
      const bool meets_another = mode.doubt > decisive * mode.frequency && std::abs(mode.growth_rate) <= mode.doubt;
      return meets_another && std::ranges::any_of(frequencies, [&](Real frequency) {
               const double turning = static_cast<double>(frequency) * result.pace;
               return std::abs(mode.frequency - turning) <= 1e-6 * turning;
             });
    });
  }

  // A body moves in a mode if a coordinate of it or of a body that it hangs on does.
  bool moves(int body, const VectorXd& size) const {
    for (int i = body; i != ground; i = tree_.body(i).parent)
      for (int k = tree_.body(i).v; k < tree_.body(i).v + velocity_size(tree_.body(i).joint); ++k)
        if (size[k] > 1e-7 || size[n_ + k] > 1e-7) return true;
    return false;
  }

  const SteadyMotion& motion_;
  const Model<double>& tree_;
  Index n_;
};

template <class Use>
void of_body(const Linearisation& linearisation, int body, Use&& use) {
  for (const Mode& mode : linearisation.modes)
    if (body == everything || mode.moves[static_cast<std::size_t>(body)]) use(mode);
}

}  // namespace

Linearisation linearise(const SteadyMotion& motion) { return Lineariser(motion).linearise(); }

Stability stability(const Linearisation& linearisation, int body) {
  Stability found = Stability::stable;
  of_body(linearisation, body, [&](const Mode& mode) {
    const double size = std::hypot(mode.growth_rate, mode.frequency);
    const bool grows = mode.growth_rate > mode.doubt, dies_out = mode.growth_rate < -mode.doubt;
    if (grows)
      found = Stability::unstable;
    else if (found == Stability::stable && !dies_out && (vanishes(mode) || mode.doubt > decisive * size))
      found = Stability::undecided;
  });
  return found;
}

double growth_rate(const Linearisation& linearisation, int body) {
  double largest = 0;
  of_body(linearisation, body, [&](const Mode& mode) {
    if (mode.growth_rate > mode.doubt) largest = std::max(largest, mode.growth_rate);
  });
  return largest;
}

std::vector<double> frequencies(const Linearisation& linearisation, int body) {
  std::vector<double> found;
  of_body(linearisation, body, [&](const Mode& mode) {
    if (mode.frequency > mode.doubt) found.push_back(mode.frequency);
  });
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace poinsot::solve
