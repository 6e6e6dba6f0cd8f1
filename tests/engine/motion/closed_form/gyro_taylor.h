// An independent road to the motion of a heavy or free rigid body about a fixed point: the Taylor series of the
// Euler-Poisson equations and of the quaternion, in any precision. It shares no formula with the closed forms.
//
//   I dw/dt + w x I w = -r x g_Z,   dg_Z/dt = g_Z x w,   dq/dt = q w / 2,   g_Z the vertical and all else on body axes
//
// All are quadratic, so that each coefficient follows from products of those before it.
#pragma once

#include <array>
#include <cmath>
#include <vector>

namespace poinsot {

template <class Number>
struct GyroState {
  std::array<Number, 3> w;  // angular velocity on principal body axes
  std::array<Number, 4> q;  // attitude, w x y z
};

template <class Number>
class GyroTaylor {
 public:
  // moments: principal moments at the fixed point. weight_moment: weight times the position of G, on body axes. order
  // of the series; tolerance: size of the first term left out.
  GyroTaylor(const std::array<Number, 3>& moments, const std::array<Number, 3>& weight_moment, int order,
             const Number& tolerance)
      : I_(moments), c_(weight_moment), order_(static_cast<std::size_t>(order)), tolerance_(tolerance) {
    for (auto& x : x_) x.resize(order_ + 1);
  }

  GyroState<Number> advance(const GyroState<Number>& start, const Number& duration) {
    const auto& [qw, qx, qy, qz] = start.q;
    std::array<Number, size> x{start.w[0],
                               start.w[1],
                               start.w[2],
                               qw,
                               qx,
                               qy,
                               qz,
                               2 * (qx * qz - qw * qy),
                               2 * (qy * qz + qw * qx),
                               qw * qw - qx * qx - qy * qy + qz * qz};
    Number left = duration;
    const Number sense = duration < 0 ? Number(-1) : Number(1);
    while (left * sense > 0) {
      expand(x);
      Number h = sense * step();
      if (h * sense > left * sense) h = left;
      for (std::size_t i = 0; i < size; ++i) {
        Number sum = x_[i][order_];
        for (std::size_t k = order_; k-- > 0;) sum = sum * h + x_[i][k];
        x[i] = sum;
      }
      left -= h;
    }
    return {{x[0], x[1], x[2]}, {x[3], x[4], x[5], x[6]}};
  }

 private:
  static constexpr std::size_t size = 10;

  // Coefficient n of the product of two series.
  Number product(std::size_t a, std::size_t b, std::size_t n) const {
    Number sum = 0;
    for (std::size_t k = 0; k <= n; ++k) sum += x_[a][k] * x_[b][n - k];
    return sum;
  }

  void expand(const std::array<Number, size>& x) {
    const bool heavy = c_[0] != 0 || c_[1] != 0 || c_[2] != 0;
    for (std::size_t i = 0; i < size; ++i) x_[i][0] = x[i];
    for (std::size_t n = 0; n < order_; ++n) {
      const Number next = static_cast<int>(n) + 1;
      for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
        const Number moment = heavy ? Number(c_[k] * x_[7 + j][n] - c_[j] * x_[7 + k][n]) : Number(0);
        x_[i][n + 1] = ((I_[j] - I_[k]) * product(j, k, n) + moment) / (I_[i] * next);
        if (heavy) x_[7 + i][n + 1] = (product(7 + j, k, n) - product(7 + k, j, n)) / next;
      }
      const Number half = 2 * next;
      x_[3][n + 1] = -(product(4, 0, n) + product(5, 1, n) + product(6, 2, n)) / half;
      x_[4][n + 1] = (product(3, 0, n) + product(5, 2, n) - product(6, 1, n)) / half;
      x_[5][n + 1] = (product(3, 1, n) + product(6, 0, n) - product(4, 2, n)) / half;
      x_[6][n + 1] = (product(3, 2, n) + product(4, 1, n) - product(5, 0, n)) / half;
    }
  }

  // The step at which the last two terms reach the tolerance, relative to the angular velocity where that is large.
  Number step() const {
    using std::exp;
    using std::fabs;
    using std::log;
    using std::sqrt;
    Number w_size = 1;
    for (std::size_t i = 0; i < 3; ++i) w_size += fabs(x_[i][0]);
    Number h = 0;
    bool first = true;
    for (std::size_t k = order_ - 1; k <= order_; ++k) {
      Number largest = 0;
      for (std::size_t i = 0; i < size; ++i) {
        const Number a = Number(fabs(x_[i][k])) / (i < 3 ? w_size : Number(1));
        if (a > largest) largest = a;
      }
      if (largest == 0) continue;
      const Number candidate = exp(log(Number(tolerance_ / largest)) / static_cast<int>(k));
      if (first || candidate < h) h = candidate;
      first = false;
    }
    return first ? Number(1) / w_size : h;
  }

  std::array<Number, 3> I_, c_;
  std::size_t order_;
  Number tolerance_;
  std::array<std::vector<Number>, size> x_;
};

}  // namespace poinsot
