#include "poinsot/engine/solve/stability/linearisation.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>

#include "engine/solve/stability/doubted_rates.h"
#include "engine/solve/stability/same_motion.h"
#include "poinsot/engine/dynamics/kinematics.h"

namespace poinsot::solve {
namespace {

using Index = Eigen::Index;
using VectorXd = Eigen::VectorXd;
constexpr double epsilon = std::numeric_limits<double>::epsilon();
// An oscillation is called stable only if its rate is known to this part of itself: the growth is hidden in the error
// else.
constexpr double decisive = 1e-7;

// The adjoint of a twist, which gives the rate of a deviation's components on axes that move with the twist.
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

bool is_doubtful(const Mode& mode) {
  return vanishes(mode) || mode.doubt > decisive * std::hypot(mode.growth_rate, mode.frequency);
}

class Lineariser {
 public:
  explicit Lineariser(const SteadyMotion& motion)
      : motion_(motion), tree_(*motion.tree), n_(static_cast<Index>(motion.v.size())) {}

  Linearisation linearise() {
    Linearisation result;
    const VectorXd a = accelerations(motion_.q, motion_.v);
    // The state is described on axes that follow the frame and not the spin: there the velocities of a steady motion
    // are constant, and deviations obey equations with constant coefficients.
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
    A.doubt += 4 * epsilon * A.value.cwiseAbs();
    // From here on deviations are in natural units, and rates are parts of the pace.
    Vector scale(2 * n_);
    for (Index k = 0; k < n_; ++k) {
      scale[k] = unit(k);
      scale[n_ + k] = unit(k) * result.pace;
    }
    for (Matrix* each : {&A.value, &A.doubt})
      *each = (scale.cwiseInverse().asDiagonal() * *each * scale.asDiagonal()).eval() / Real(result.pace);
    // As far as the velocities are not quite constant, the matrix belongs to a steady motion near by, which adds to
    // its doubt.
    A.doubt.bottomRows(n_).array() += Real(*unrest);
    Vector coupled = Vector::Zero(2 * n_);
    const DeviationRows rows = rows_of(scale, coupled);
    const SameMotion same = same_motion(A, rows, displacements(scale));
    const Matrix basis = deviations(rows, same.elsewhere, coupled);
    // The error of the basis adds to that of the entries.
    const Matrix size = basis.cwiseAbs();
    const Matrix off = coupled * Matrix::Ones(1, basis.cols());
    const Doubted reduced{basis.transpose() * A.value * basis, size.transpose() * A.doubt * size +
                                                                   off.transpose() * A.value.cwiseAbs() * size +
                                                                   size.transpose() * A.value.cwiseAbs() * off};
    find_modes(result, reduced, basis);
    // A symmetry brings a conserved momentum, and with it one more eigenvalue zero that says nothing about stability.
    leave_out(result, same.momenta);
    if (std::ranges::any_of(result.modes, is_doubtful)) look_without_momenta(result, reduced, basis, same.momenta);
    for (const double frequency : same.going_round) result.modes.push_back({0, frequency * result.pace, 0, {}});
    std::sort(result.modes.begin(), result.modes.end(), [](const Mode& one, const Mode& other) {
      return one.growth_rate != other.growth_rate ? one.growth_rate > other.growth_rate
                                                  : one.frequency < other.frequency;
    });
    return result;
  }

 private:
  void find_modes(Linearisation& result, const Doubted& reduced, const Matrix& basis) const {
    const Rates rates = rates_of(reduced);
    result.modes.clear();
    for (Index m = 0; m < rates.value.size(); ++m) {
      const std::complex<Real> rate = rates.value[m];
      if (rate.imag() < 0) continue;  // its conjugate stands for it
      Mode mode;
      mode.growth_rate = static_cast<double>(rate.real() * Real(result.pace));
      mode.frequency = static_cast<double>(rate.imag() * Real(result.pace));
      // The doubts of the entries are estimated from a few differences only: the factor is a margin for that.
      mode.doubt = 4 * rates.doubt[m] * result.pace;
      const VectorXd moved = (basis * rates.motion.col(m).normalized()).cwiseAbs().cast<double>();
      for (int i = 0; i < tree_.body_count(); ++i) mode.moves.push_back(moves(i, moved));
      result.modes.push_back(std::move(mode));
    }
  }

  // Slow modes beside the zero eigenvalues of conserved momenta are known badly, as nearly equal eigenvalues disturb
  // each other. This computes the modes again without the directions n for which A n vanishes within its doubt: these
  // are motions with other momenta, and A has the other eigenvalues on their complement.
  void look_without_momenta(Linearisation& result, const Doubted& A, const Matrix& basis, Index momenta) const {
    const Eigen::JacobiSVD<Matrix> svd(A.value, Eigen::ComputeFullV);
    const Matrix& all = svd.matrixV();
    Index count = 0;
    Matrix doubt = A.doubt;
    for (; count < all.cols(); ++count) {
      const Vector n = all.col(all.cols() - 1 - count), left = (A.value * n).cwiseAbs();
      if (!((left - 10 * (A.doubt * n.cwiseAbs())).array() <= 0).all()) break;
      doubt += left * n.cwiseAbs().transpose();
    }
    // If more directions vanish than there are momenta, some of them are slow motions, and this way is closed.
    if (count == 0 || count > momenta) return;
    const Matrix others = complement(all.rightCols(count)), size = others.cwiseAbs();
    find_modes(result, {others.transpose() * A.value * others, size.transpose() * doubt * size}, basis * others);
    leave_out(result, momenta - count);
  }

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
  // The derivative at zero by differences of sixth order, and an error estimate from differences with other steps.
  // Where a displacement by h leads far away (a disk that lies nearly flat passes through the floor), shorter steps
  // are taken. Where the function is quadratic, as accelerations are in the velocities, the slopes over the three
  // steps agree but for rounding, and one difference is enough.
  struct Slope {
    VectorXd value, doubt;
    bool of_quadratic = false;  // then shorter steps would only increase the rounding
  };
  template <class Function>
  static Slope slope(Function&& f, double h) {
    constexpr double closely = 1e-8, shorter = 1.0 / 16;
    Slope found = slope_by(f, h);
    for (int i = 0; i < 3 && !found.of_quadratic && !(found.doubt.norm() <= closely * found.value.norm()); ++i) {
      h *= shorter;
      Slope other = slope_by(f, h);
      if (!(other.doubt.norm() < found.doubt.norm())) break;
      found = std::move(other);
    }
    return found;
  }
  template <class Function>
  static Slope slope_by(Function&& f, double h) {
    // The steps are no multiples of each other: those would round alike and agree by chance.
    constexpr std::array<double, 3> ratios{1, 1.618, 2.718};
    VectorXd sizes = VectorXd::Zero(0);  // the sizes of the values that cancel in a difference
    const auto slopes_over = [&](double step) {
      std::array<VectorXd, 3> slopes;
      for (std::size_t k = 0; k < 3; ++k) {
        const double far = ratios[k] * step;
        const VectorXd after = f(far), before = f(-far);
        const VectorXd largest = after.cwiseAbs().cwiseMax(before.cwiseAbs());
        sizes = sizes.size() == 0 ? largest : VectorXd(sizes.cwiseMax(largest));
        slopes[k] = (after - before) / (2 * far);
      }
      return slopes;
    };
    // The combination of the three slopes in which the terms of third and fifth order cancel.
    const auto sixth_order = [&](const std::array<VectorXd, 3>& slopes) -> VectorXd {
      VectorXd sum = VectorXd::Zero(slopes[0].size());
      for (std::size_t i = 0; i < 3; ++i) {
        double weight = 1;
        for (std::size_t k = 0; k < 3; ++k)
          if (k != i) weight *= ratios[k] * ratios[k] / (ratios[k] * ratios[k] - ratios[i] * ratios[i]);
        sum += weight * slopes[i];
      }
      return sum;
    };
    const auto spread = [](const std::array<VectorXd, 3>& d) -> VectorXd {
      return d[0].cwiseMax(d[1]).cwiseMax(d[2]) - d[0].cwiseMin(d[1]).cwiseMin(d[2]);
    };
    const std::array<VectorXd, 3> slopes = slopes_over(h);
    const VectorXd apart = spread(slopes), noise = epsilon / h * sizes;
    // Solving for accelerations leaves some tens of times the rounding of the values. The longest step has the least
    // of it; a cubic term would add less than twice what the slopes are apart.
    if ((apart.array() <= 64 * noise.array()).all()) return {slopes[2], (2 * apart).cwiseMax(noise), true};
    const std::array<VectorXd, 3> all{sixth_order(slopes), sixth_order(slopes_over(0.7 * h)),
                                      sixth_order(slopes_over(1.3 * h))};
    return {(all[0] + all[1] + all[2]) / 3, spread(all)};
  }

  // The largest change of a velocity in natural units, as a part of the pace; nothing if it exceeds what the errors
  // of the pose and the velocities explain: then the motion is not steady. A: the matrix before the spin is added.
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
      if (std::abs(change[k]) > closely * terms + 64 * epsilon * unit(k) * pace * pace) return std::nullopt;
      largest = std::max(largest, std::abs(change[k]) / unit(k) / (pace * pace));
    }
    return largest;
  }

  // The conditions that deviations satisfy: held coordinates do not deviate, and constraints go on holding. coupled:
  // receives the possible error of deviations that follow from others.
  DeviationRows rows_of(const Vector& scale, Vector& coupled) const {
    std::vector<Vector> rows;
    std::vector<Real> doubts;
    for (Index k = 0; k < n_; ++k)
      if (motion_.held[static_cast<std::size_t>(k)])
        for (Index part : {k, n_ + k}) {
          Vector row = Vector::Zero(2 * n_);
          row[part] = 1;
          rows.push_back(row);
          doubts.push_back(0);
        }
    const auto J = motion_.constraints(motion_.q);
    // The derivative of J v along each coordinate, J the rates of the constraints.
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
    const auto add = [&](const Vector& row, Real doubt) {
      const Vector scaled = row.cwiseProduct(scale);
      const Real size = scaled.norm();
      if (!(size > 0)) return;
      mark(coupled, scaled, 8 * epsilon + doubt / size);
      rows.push_back(scaled / size);
      doubts.push_back(doubt / size);
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
    const auto count = static_cast<Index>(rows.size());
    DeviationRows all{Matrix(count, 2 * n_), Eigen::Map<const Vector>(doubts.data(), count)};
    for (Index i = 0; i < count; ++i) all.value.row(i) = rows[static_cast<std::size_t>(i)].transpose();
    return all;
  }
  static void mark(Vector& coupled, const Vector& row, Real doubt) {
    for (Index k = 0; k < row.size(); ++k)
      if (row[k] != 0) coupled[k] = std::max(coupled[k], doubt);
  }

  // An orthonormal basis of the possible deviations, without those that lead to the same motion elsewhere.
  Matrix deviations(const DeviationRows& rows, const Matrix& elsewhere, Vector& coupled) const {
    for (Index s = 0; s < elsewhere.cols(); ++s)
      if ((elsewhere.col(s).array() != 0).count() > 1) mark(coupled, elsewhere.col(s), 8 * epsilon);
    Matrix kernel = Matrix::Identity(2 * n_, 2 * n_);
    if (rows.value.rows() > 0) kernel = complement(rows.value.transpose());
    return elsewhere.cols() == 0 ? kernel : Matrix(kernel * complement(kernel.transpose() * elsewhere));
  }
  // The stated symmetries of the motion as displacements of length one.
  std::vector<Vector> displacements(const Vector& scale) const {
    std::vector<Vector> all;
    for (const std::vector<double>& stated : motion_.symmetries) {
      const Vector x = Eigen::Map<const VectorXd>(stated.data(), 2 * n_).cast<Real>().cwiseQuotient(scale);
      if (x.norm() > 0) all.push_back(x.normalized());
    }
    return all;
  }
  static void leave_out(Linearisation& result, Index count) {
    for (; count > 0; --count) {
      const auto least = std::min_element(result.modes.begin(), result.modes.end(), [](const Mode& a, const Mode& b) {
        return std::hypot(a.growth_rate, a.frequency) < std::hypot(b.growth_rate, b.frequency);
      });
      if (least == result.modes.end() || !vanishes(*least)) return;
      result.modes.erase(least);
    }
  }

  // A body takes part in a mode if one of its coordinates does, or one of a body that carries it.
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
    if (!mode.moves.empty() && (body == everything || mode.moves[static_cast<std::size_t>(body)])) use(mode);
}

}  // namespace

Linearisation linearise(const SteadyMotion& motion) { return Lineariser(motion).linearise(); }

Stability stability(const Linearisation& linearisation, int body) {
  Stability found = Stability::stable;
  of_body(linearisation, body, [&](const Mode& mode) {
    const bool grows = mode.growth_rate > mode.doubt, dies_out = mode.growth_rate < -mode.doubt;
    if (grows)
      found = Stability::unstable;
    else if (found == Stability::stable && !dies_out && is_doubtful(mode))
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
