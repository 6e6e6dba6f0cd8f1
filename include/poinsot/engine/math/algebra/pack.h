// Several cases at once: a pack holds W doubles, one per lane, and computes on all with one instruction where the
// processor has vectors of that size. There are no comparisons: nothing may branch on a pack's value.
#pragma once

#include <cstddef>
#include <experimental/simd>
#include <type_traits>

#include "poinsot/engine/math/algebra/angle_functions.h"
#include "poinsot/engine/math/algebra/scalar.h"
#include "poinsot/engine/math/algebra/sine_cosine.h"

namespace poinsot {

template <int W>
class Pack {
 public:
  using Lanes = std::experimental::simd<double, std::experimental::simd_abi::deduce_t<double, W>>;
  static constexpr int width = W;

  Pack() : lanes_(0.0) {}
  // The same number in every lane.
  template <class Number>
  requires std::is_arithmetic_v<Number> Pack(Number number) : lanes_(static_cast<double>(number)) {}
  explicit Pack(const Lanes& lanes) : lanes_(lanes) {}
  Pack(const Pack&) = default;
  ~Pack() = default;
  // Not defaulted on purpose: with a trivial assignment g++ 12 builds the right side of v = {v.y, v.z, v.x} inside v
  // where the lanes do not fill one register, and reads components that it has overwritten.
  Pack& operator=(const Pack& b) {
    lanes_ = b.lanes_;
    return *this;
  }

  // Lane i holds of(i).
  template <class Of>
  requires std::is_invocable_r_v<double, Of, int>
  static Pack from_lanes(Of of) {
    Pack pack;
    for (int i = 0; i < W; ++i) pack.set_lane(i, of(i));
    return pack;
  }
  double lane(int i) const { return lanes_[static_cast<std::size_t>(i)]; }
  void set_lane(int i, double number) { lanes_[static_cast<std::size_t>(i)] = number; }
  const Lanes& lanes() const { return lanes_; }

  Pack& operator+=(const Pack& b) {
    lanes_ += b.lanes_;
    return *this;
  }
  Pack& operator-=(const Pack& b) {
    lanes_ -= b.lanes_;
    return *this;
  }
  Pack& operator*=(const Pack& b) {
    lanes_ *= b.lanes_;
    return *this;
  }
  Pack& operator/=(const Pack& b) {
    lanes_ /= b.lanes_;
    return *this;
  }
  friend Pack operator+(const Pack& a) { return a; }
  friend Pack operator-(const Pack& a) { return Pack(-a.lanes_); }
  friend Pack operator+(const Pack& a, const Pack& b) { return Pack(a.lanes_ + b.lanes_); }
  friend Pack operator-(const Pack& a, const Pack& b) { return Pack(a.lanes_ - b.lanes_); }
  friend Pack operator*(const Pack& a, const Pack& b) { return Pack(a.lanes_ * b.lanes_); }
  friend Pack operator/(const Pack& a, const Pack& b) { return Pack(a.lanes_ / b.lanes_); }

 private:
  Lanes lanes_;
};

template <int W>
Pack<W> sqrt(const Pack<W>& x) {
  return Pack<W>(std::experimental::sqrt(x.lanes()));
}
// x y + z, rounded once.
template <int W>
Pack<W> fma(const Pack<W>& x, const Pack<W>& y, const Pack<W>& z) {
  return Pack<W>(std::experimental::fma(x.lanes(), y.lanes(), z.lanes()));
}

template <int W>
SineCosine<Pack<W>> sine_cosine(const Pack<W>& x) {
  using Lanes = typename Pack<W>::Lanes;
  if (!std::experimental::all_of(std::experimental::fabs(x.lanes()) <= Lanes(sine_cosine_kernel_range))) {
    SineCosine<Pack<W>> each;
    for (int i = 0; i < W; ++i) {
      const auto [s, c] = sine_cosine(x.lane(i));
      each.sine.set_lane(i, s);
      each.cosine.set_lane(i, c);
    }
    return each;
  }
  const auto select = [](const auto& mask, const Lanes& a, Lanes b) {
    std::experimental::where(mask, b) = a;
    return b;
  };
  const auto [s, c] = sine_cosine_kernel<Lanes>(x.lanes(), select);
  return {Pack<W>(s), Pack<W>(c)};
}
template <int W>
Pack<W> sin(const Pack<W>& x) {
  return sine_cosine(x).sine;
}
template <int W>
Pack<W> cos(const Pack<W>& x) {
  return sine_cosine(x).cosine;
}

template <int W>
Pack<W> sinc_of_square(const Pack<W>& x) {
  return Pack<W>::from_lanes([&x](int i) { return sinc_of_square(x.lane(i)); });
}
template <int W>
Pack<W> cosine_of_square(const Pack<W>& x) {
  return Pack<W>::from_lanes([&x](int i) { return cosine_of_square(x.lane(i)); });
}
template <int W>
Pack<W> cosine_rest_of_square(const Pack<W>& x) {
  return Pack<W>::from_lanes([&x](int i) { return cosine_rest_of_square(x.lane(i)); });
}
template <int W>
Pack<W> sine_rest_of_square(const Pack<W>& x) {
  return Pack<W>::from_lanes([&x](int i) { return sine_rest_of_square(x.lane(i)); });
}

template <int W, class Predicate>
bool every_value(const Pack<W>& x, Predicate predicate) {
  for (int i = 0; i < W; ++i) {
    if (!predicate(x.lane(i))) return false;
  }
  return true;
}
template <int W>
Pack<W> positive_sign(const Pack<W>& x) {
  return Pack<W>::from_lanes([&x](int i) { return positive_sign(x.lane(i)); });
}

}  // namespace poinsot
