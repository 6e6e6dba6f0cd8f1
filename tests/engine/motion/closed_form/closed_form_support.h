// What the tests of the closed forms share: distances of attitudes, random bodies, and how many cases to try.
#pragma once

#include <algorithm>
#include <cmath>
#include <random>

#include "poinsot/engine/math/algebra/quaternion.h"
#include "poinsot/engine/math/algebra/vector3.h"

namespace poinsot {

// Fewer cases where every operation is watched.
#if defined(__SANITIZE_ADDRESS__)
constexpr int closed_form_thinning = 20;
#else
constexpr int closed_form_thinning = 1;
#endif

// The larger of two errors; what is not a number stays.
inline void raise(double& worst, double value) {
  if (!(value <= worst) && worst == worst) worst = value;
}

// Largest difference of components, q and -q being the same attitude.
template <class A, class B>
B attitude_distance(const Quaternion<A>& a, const Quaternion<B>& b) {
  using std::fabs;
  B plus = 0, minus = 0;
  const auto take = [&](const A& x, const B& y) {
    const B difference = fabs(B(B(x) - y)), sum = fabs(B(B(x) + y));
    // What is not a number stays.
    if (!(difference <= minus) && minus == minus) minus = difference;
    if (!(sum <= plus) && plus == plus) plus = sum;
  };
  take(a.w, b.w);
  take(a.x, b.x);
  take(a.y, b.y);
  take(a.z, b.z);
  return minus <= plus ? minus : plus;
}

class RandomMotion {
 public:
  explicit RandomMotion(unsigned seed) : engine_(seed) {}

  double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine_); }
  double normal() { return std::normal_distribution<double>()(engine_); }
  Vector3<double> vector() { return {normal(), normal(), normal()}; }
  // Of any length, as a caller may give it.
  Quaternion<double> attitude() { return {normal(), normal(), normal(), normal()}; }
  // Principal moments of a real body: none above the sum of the others.
  Vector3<double> moments() {
    const double a = uniform(0.1, 1.1), b = uniform(0.1, 1.1);
    return {a, b, uniform(std::fabs(a - b), a + b)};
  }

 private:
  std::mt19937_64 engine_;
};

}  // namespace poinsot
