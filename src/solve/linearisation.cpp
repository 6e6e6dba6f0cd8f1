#include "poinsot/solve/linearisation.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "poinsot/dynamics/kinematics.h"

namespace poinsot::solve {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using Index = Eigen::Index;

constexpr double vanishing = 1e-5;  // rates below this part of the pace count as zero

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

class Lineariser {
 public:
  explicit Lineariser(const SteadyMotion& motion)
      : motion_(motion), tree_(*motion.tree), n_(static_cast<Index>(motion.v.size())) {}

  Linearisation linearise() {
    Linearisation result;
    const VectorXd a = accelerations(motion_.q, motion_.v);
    // On axes that follow the frame but not the spin, velocities of a steady motion are constant.
    MatrixXd spin = MatrixXd::Zero(n_, n_), drift = MatrixXd::Zero(n_, n_);
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
    const Eigen::Map<const VectorXd> v(motion_.v.data(), n_);
    result.pace = std::max(pace(), 1e-300);
    const VectorXd change = a + spin * v;
    for (Index k = 0; k < n_; ++k)
      if (std::abs(change[k]) > 1e-7 * unit(k) * result.pace * result.pace) result.steady = false;
    if (!result.steady) return result;

    MatrixXd A = MatrixXd::Zero(2 * n_, 2 * n_);
    A.topLeftCorner(n_, n_) = spin - drift;
    A.topRightCorner(n_, n_).setIdentity();
    for (Index k = 0; k < n_; ++k) {
      A.col(k).tail(n_) =
          difference([&](double h) { return accelerations(displaced(k, h), motion_.v); }, 2e-3) / unit(k);
      A.col(n_ + k).tail(n_) =
          difference([&](double h) { return accelerations(motion_.q, hastened(k, h)); }, 2e-3 * result.pace) / unit(k);
    }
    A.bottomRightCorner(n_, n_) += spin;
    // In natural units, rates as parts of the pace.
    VectorXd scale(2 * n_);
    for (Index k = 0; k < n_; ++k) {
      scale[k] = unit(k);
      scale[n_ + k] = unit(k) * result.pace;
    }
    A = (scale.cwiseInverse().asDiagonal() * A * scale.asDiagonal()).eval() / result.pace;
    const MatrixXd symmetries = symmetries_of(A, scale);
    const MatrixXd basis = deviations(scale, symmetries);
    const MatrixXd reduced = basis.transpose() * A * basis;
    Eigen::EigenSolver<MatrixXd> solver(reduced);
    for (Index m = 0; m < reduced.rows(); ++m) {
      const std::complex<double> rate = solver.eigenvalues()[m];
      if (rate.imag() < 0) continue;  // its conjugate stands for it
      Mode mode{rate.real() * result.pace, rate.imag() * result.pace, {}};
      const VectorXd size = (basis * solver.eigenvectors().col(m).normalized()).cwiseAbs();
      for (int i = 0; i < tree_.body_count(); ++i) mode.moves.push_back(moves(i, size));
      result.modes.push_back(std::move(mode));
    }
    leave_out(result, symmetries.cols());
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
  // The derivative at zero, of sixth order.
  template <class Function>
  static VectorXd difference(Function&& f, double h) {
    return (45.0 * (f(h) - f(-h)) - 9.0 * (f(2 * h) - f(-2 * h)) + (f(3 * h) - f(-3 * h))) / (60 * h);
  }

  // An orthonormal basis of the deviations that are possible: held coordinates do not deviate, constraints hold, and
  // displacements by a symmetry are none.
  MatrixXd deviations(const VectorXd& scale, const MatrixXd& symmetries) const {
    std::vector<VectorXd> rows;
    for (Index k = 0; k < n_; ++k)
      if (motion_.held[static_cast<std::size_t>(k)])
        for (Index part : {k, n_ + k}) {
          VectorXd row = VectorXd::Zero(2 * n_);
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
    MatrixXd bias(static_cast<Index>(J.size()), n_);
    if (!J.empty())
      for (Index k = 0; k < n_; ++k)
        bias.col(k) = difference([&](double h) { return rates(displaced(k, h)); }, 2e-3) / unit(k);
    for (std::size_t i = 0; i < J.size(); ++i) {
      const VectorXd coefficients = Eigen::Map<const VectorXd>(J[i].data(), n_);
      if (i < motion_.position_constraints) {
        VectorXd row = VectorXd::Zero(2 * n_);
        row.head(n_) = coefficients;
        rows.push_back(row);
      }
      VectorXd row = VectorXd::Zero(2 * n_);
      row.head(n_) = bias.row(static_cast<Index>(i)).transpose();
      row.tail(n_) = coefficients;
      rows.push_back(row);
    }
    MatrixXd all(static_cast<Index>(rows.size()), 2 * n_);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const VectorXd row = rows[i].cwiseProduct(scale);
      all.row(static_cast<Index>(i)) = row.transpose() / std::max(row.norm(), 1e-300);
    }
    MatrixXd kernel = MatrixXd::Identity(2 * n_, 2 * n_);
    if (all.rows() > 0) kernel = complement(all.transpose());
    return symmetries.cols() == 0 ? kernel : MatrixXd(kernel * complement(kernel.transpose() * symmetries));
  }
  // An orthonormal basis of what is at right angles to all columns.
  static MatrixXd complement(const MatrixXd& columns) {
    Eigen::ColPivHouseholderQR<MatrixXd> qr(columns);
    qr.setThreshold(1e-9);
    const MatrixXd Q = qr.householderQ() * MatrixXd::Identity(columns.rows(), columns.rows());
    return Q.rightCols(columns.rows() - qr.rank());
  }

  // Those displacements that do lead to the same motion again, independent of each other.
  MatrixXd symmetries_of(const MatrixXd& A, const VectorXd& scale) const {
    MatrixXd found(2 * n_, 0);
    for (const std::vector<double>& stated : motion_.symmetries) {
      VectorXd x = Eigen::Map<const VectorXd>(stated.data(), 2 * n_).cwiseQuotient(scale);
      if (!(x.norm() > 0)) continue;
      x.normalize();
      if ((A * x).norm() > 1e-8 * (1 + A.norm())) continue;
      MatrixXd more(2 * n_, found.cols() + 1);
      more << found, x;
      Eigen::ColPivHouseholderQR<MatrixXd> qr(more);
      qr.setThreshold(1e-9);
      if (qr.rank() == more.cols()) found = more;
    }
    return found;
  }
  // A symmetry has a conserved momentum: one more rate that vanishes and says nothing of stability.
  static void leave_out(Linearisation& result, Index count) {
    for (; count > 0; --count) {
      const auto least = std::min_element(result.modes.begin(), result.modes.end(), [](const Mode& a, const Mode& b) {
        return std::hypot(a.growth_rate, a.frequency) < std::hypot(b.growth_rate, b.frequency);
      });
      if (least == result.modes.end() || std::hypot(least->growth_rate, least->frequency) > vanishing * result.pace)
        return;
      result.modes.erase(least);
    }
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
    const double zero = vanishing * linearisation.pace;
    if (mode.growth_rate > zero)
      found = Stability::unstable;
    else if (found == Stability::stable && std::hypot(mode.growth_rate, mode.frequency) <= zero)
      found = Stability::undecided;
  });
  return found;
}

double growth_rate(const Linearisation& linearisation, int body) {
  double largest = 0;
  of_body(linearisation, body, [&](const Mode& mode) {
    if (mode.growth_rate > vanishing * linearisation.pace) largest = std::max(largest, mode.growth_rate);
  });
  return largest;
}

std::vector<double> frequencies(const Linearisation& linearisation, int body) {
  std::vector<double> found;
  of_body(linearisation, body, [&](const Mode& mode) {
    if (mode.frequency > vanishing * linearisation.pace) found.push_back(mode.frequency);
  });
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace poinsot::solve
