// A primal-dual method with the scaling of Nesterov and Todd and the corrector of Mehrotra (L. Vandenberghe, The CVXOPT
// linear and quadratic cone program solvers, 2010, whose letters these are). With J = diag(1, -1, ..., -1) and the
// product u o v = (u . v, u0 v1 + v0 u1) of a cone, it goes along
//   G x + s = h,  G' z + c = 0,  s o z = mu e
// to mu = 0. Its steps are least squares with rows scaled by W, for which W z = W^-1 s = l.
#include "engine/solve/linear/cone_program.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>

namespace poinsot::solve {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

struct Cone {
  Index first = 0, size = 1;
};

// u0^2 - |u1|^2, as a product so that it keeps its digits near the surface.
template <class Vector>
double apart_from_surface(const Vector& u) {
  const double across = u.tail(u.size() - 1).norm();
  return (u[0] - across) * (u[0] + across);
}

template <class Vector>
bool is_inside(const Vector& u) {
  return u[0] >= u.tail(u.size() - 1).norm();
}

// The part of the way du from u inside a cone to its surface; infinite if it does not end.
double way_to_surface(const VectorXd& u, const VectorXd& du) {
  const double size = std::sqrt(std::max(apart_from_surface(u), std::numeric_limits<double>::min()));
  const Index n = u.size() - 1;
  const VectorXd v = u / size;
  const double along = v[0] * du[0] - v.tail(n).dot(du.tail(n));
  const double outwards = (du.tail(n) - (along + du[0]) / (v[0] + 1) * v.tail(n)).norm() - along;
  return outwards > 0 ? size / outwards : std::numeric_limits<double>::infinity();
}

VectorXd product(const VectorXd& u, const VectorXd& v) {
  const Index n = u.size() - 1;
  VectorXd result(n + 1);
  result << u.dot(v), u[0] * v.tail(n) + v[0] * u.tail(n);
  return result;
}

// The u with l o u = v.
VectorXd quotient(const VectorXd& v, const VectorXd& l) {
  const Index n = l.size() - 1;
  VectorXd u(n + 1);
  u[0] = (l[0] * v[0] - l.tail(n).dot(v.tail(n))) / apart_from_surface(l);
  u.tail(n) = (v.tail(n) - u[0] * l.tail(n)) / l[0];
  return u;
}

// W of one cone: eta [w0, w1'; w1, 1 + w1 w1'/(1 + w0)], whose inverse has -w1 and 1/eta.
struct Scaling {
  double eta = 1;
  VectorXd w;
  Scaling(const VectorXd& s, const VectorXd& z) {
    const double of_s = std::sqrt(apart_from_surface(s)), of_z = std::sqrt(apart_from_surface(z));
    eta = std::sqrt(of_s / of_z);
    w = z / of_z;
    w.tail(w.size() - 1) *= -1;
    const double middle = std::sqrt((1 + s.dot(z) / (of_s * of_z)) / 2);
    w = (s / of_s + w) / (2 * middle);
  }
  template <class Rows>
  void apply(bool inverse, Rows&& rows) const {
    const Index n = w.size() - 1;
    const VectorXd across = (inverse ? -1 : 1) * w.tail(n);
    const Eigen::RowVectorXd top = rows.row(0), along = across.transpose() * rows.bottomRows(n);
    rows.row(0) = w[0] * top + along;
    rows.bottomRows(n) += across * (top + along / (1 + w[0]));
    rows *= inverse ? 1 / eta : eta;
  }
};

class ConePath {
 public:
  explicit ConePath(const ConeProgram& program) : n_(program.G.cols()), c_(program.c), reach_(program.reach) {
    Index first = 0;
    for (const Index size : program.sizes) {
      cones_.push_back({first, size});
      first += size;
    }
    cones_.push_back({first, n_ + 1});
    G_ = MatrixXd::Zero(first + n_ + 1, n_);
    G_.topRows(first) = program.G;
    G_.bottomRows(n_) = -MatrixXd::Identity(n_, n_);
    h_ = VectorXd::Zero(G_.rows());
    h_.head(first) = program.h;
    h_[first] = reach_;
    e_ = VectorXd::Zero(G_.rows());
    for (const Cone& cone : cones_) e_[cone.first] = 1;
  }

  std::optional<ConeOptimum> follow(const std::function<bool(const ConeOptimum&)>& enough) {
    const Eigen::HouseholderQR<MatrixXd> qr(G_);
    x_ = qr.solve(h_);
    s_ = moved_inside(h_ - G_ * x_);
    const MatrixXd Q = qr.householderQ() * MatrixXd::Identity(G_.rows(), n_);
    const MatrixXd R = qr.matrixQR().topRows(n_).triangularView<Eigen::Upper>();
    z_ = moved_inside(-Q * R.transpose().triangularView<Eigen::Lower>().solve(c_));
    std::optional<ConeOptimum> best;
    constexpr int most_steps = 60;
    constexpr double last = 1e-16;  // of s . z, beside coefficients near one
    for (int step = 0; step < most_steps && scale(); ++step) {
      if (std::optional<ConeOptimum> now = bounded(); now && (!best || now->bound > best->bound)) best = std::move(now);
      if (best) {
        best->x = x_;
        if (enough && enough(*best)) break;
      }
      if (s_.dot(z_) < last || !advance()) break;
    }
    return best;
  }

 private:
  VectorXd part(const VectorXd& u, const Cone& cone) const { return u.segment(cone.first, cone.size); }

  VectorXd moved_inside(const VectorXd& u) const {
    double outside = -std::numeric_limits<double>::infinity();
    for (const Cone& cone : cones_)
      outside = std::max(outside, part(u, cone).tail(cone.size - 1).norm() - u[cone.first]);
    constexpr double clear = 1e-8;
    return outside < -clear ? u : VectorXd(u + (1 + outside) * e_);
  }

  // The scaling at this place, and the factors of W^-1 G; false where it is lost in rounding.
  bool scale() {
    scalings_.clear();
    for (const Cone& cone : cones_) {
      const VectorXd s = part(s_, cone), z = part(z_, cone);
      if (!(apart_from_surface(s) > 0 && apart_from_surface(z) > 0 && s[0] > 0 && z[0] > 0)) return false;
      scalings_.emplace_back(s, z);
    }
    l_ = scaled(z_, false);
    scaled_G_ = G_;
    for (std::size_t i = 0; i < cones_.size(); ++i)
      scalings_[i].apply(true, scaled_G_.middleRows(cones_[i].first, cones_[i].size));
    const Eigen::HouseholderQR<MatrixXd> qr(scaled_G_);
    Q_ = qr.householderQ() * MatrixXd::Identity(G_.rows(), n_);
    R_ = qr.matrixQR().topRows(n_).triangularView<Eigen::Upper>();
    return scaled_G_.allFinite() && R_.allFinite() && R_.diagonal().cwiseAbs().minCoeff() > 0;
  }

  VectorXd scaled(VectorXd u, bool inverse) const {
    for (std::size_t i = 0; i < cones_.size(); ++i)
      scalings_[i].apply(inverse, u.segment(cones_[i].first, cones_[i].size));
    return u;
  }
  template <class Of>
  VectorXd by_cones(const Of& of) const {
    VectorXd u(G_.rows());
    for (const Cone& cone : cones_) u.segment(cone.first, cone.size) = of(cone);
    return u;
  }

  // The multipliers, of which rounding is taken by the least change in their own scale, with what they bound.
  std::optional<ConeOptimum> bounded() const {
    VectorXd z = z_;
    for (int i = 0; i < 2; ++i)
      z -= scaled(Q_ * R_.transpose().triangularView<Eigen::Lower>().solve(VectorXd(G_.transpose() * z + c_)), true);
    for (const Cone& cone : cones_)
      if (!is_inside(part(z, cone))) return std::nullopt;
    const double left = (G_.transpose() * z + c_).norm();
    return ConeOptimum{x_, z.head(G_.rows() - n_ - 1), -h_.dot(z) - reach_ * left};
  }

  struct Change {
    VectorXd x, s, z;
  };
  // G' dz = of_x, G dx + ds = of_z, l o (W dz + W^-1 ds) = of_s.
  Change change(const VectorXd& of_x, const VectorXd& of_z, const VectorXd& of_s) const {
    const VectorXd t = by_cones([&](const Cone& cone) { return quotient(part(of_s, cone), part(l_, cone)); });
    const VectorXd r = scaled(of_z, true) - t;
    const VectorXd along = R_.transpose().triangularView<Eigen::Lower>().solve(of_x) + Q_.transpose() * r;
    const VectorXd dx = R_.triangularView<Eigen::Upper>().solve(along);
    const VectorXd scaled_dz = Q_ * along - r;
    return {dx, scaled(t - scaled_dz, false), scaled(scaled_dz, true)};
  }
  double way(const Change& change) const {
    double way = std::numeric_limits<double>::infinity();
    for (const Cone& cone : cones_)
      way = std::min({way, way_to_surface(part(s_, cone), part(change.s, cone)),
                      way_to_surface(part(z_, cone), part(change.z, cone))});
    return way;
  }

  bool advance() {
    const VectorXd of_x = -(G_.transpose() * z_ + c_), of_z = h_ - G_ * x_ - s_;
    const VectorXd ll = by_cones([&](const Cone& cone) { return product(part(l_, cone), part(l_, cone)); });
    const Change straight = change(of_x, of_z, -ll);
    const double part_of_way = std::min(1.0, way(straight));
    const double center = std::pow(1 - part_of_way, 3), mu = s_.dot(z_) / static_cast<double>(cones_.size());
    const VectorXd ds = scaled(straight.s, true), dz = scaled(straight.z, false);
    const VectorXd curved = by_cones([&](const Cone& cone) { return product(part(ds, cone), part(dz, cone)); });
    const Change to = change((1 - center) * of_x, (1 - center) * of_z, center * mu * e_ - ll - curved);
    constexpr double short_of_surface = 0.99, stands = 1e-8;
    const double length = std::min(1.0, short_of_surface * way(to));
    if (!(length > stands) || !to.x.allFinite() || !to.s.allFinite() || !to.z.allFinite()) return false;
    x_ += length * to.x;
    s_ += length * to.s;
    z_ += length * to.z;
    return true;
  }

  const Index n_;
  const VectorXd c_;
  const double reach_;
  std::vector<Cone> cones_;
  MatrixXd G_;
  VectorXd h_, e_, x_, s_, z_;
  std::vector<Scaling> scalings_;
  VectorXd l_;
  MatrixXd scaled_G_, Q_, R_;
};

}  // namespace

std::optional<ConeOptimum> minimise(const ConeProgram& program, const std::function<bool(const ConeOptimum&)>& enough) {
  return ConePath(program).follow(enough);
}

}  // namespace poinsot::solve
