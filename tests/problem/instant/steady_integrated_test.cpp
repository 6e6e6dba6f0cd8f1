// Steady motions and what grows or swings near them, against an independent integration of the equations of motion.
#include <gtest/gtest.h>

#include <array>

#include "case_count.h"
#include "problem/instant/near_steady.h"

namespace poinsot::problem {
namespace steady_integrated_test {

using namespace testing;

constexpr double g = 9.81;

// The classical method of Runge and Kutta, of fourth order.
template <std::size_t N, class Slopes>
std::array<double, N> stepped(const std::array<double, N>& y, double h, const Slopes& slopes) {
  const auto moved = [&](const std::array<double, N>& k, double part) {
    std::array<double, N> z = y;
    for (std::size_t i = 0; i < N; ++i) z[i] += part * h * k[i];
    return z;
  };
  const auto k1 = slopes(y), k2 = slopes(moved(k1, 0.5)), k3 = slopes(moved(k2, 0.5)), k4 = slopes(moved(k3, 1));
  std::array<double, N> next = y;
  for (std::size_t i = 0; i < N; ++i) next[i] += h / 6 * (k1[i] + 2 * k2[i] + 2 * k3[i] + k4[i]);
  return next;
}

// The axis u of a top and its angular momentum H about the fixed point: u' = w x u, H' = l u x m g.
class FlyingTop {
 public:
  FlyingTop(const Top& top, const Vector& axis, const Vector& w) : top_(top) {
    const Vector H = top.J * w + (top.I - top.J) * dot(w, axis) * axis;
    y_ = {axis.x, axis.y, axis.z, H.x, H.y, H.z};
  }
  Vector axis() const { return {y_[0], y_[1], y_[2]}; }
  void push(const Vector& impulse) {
    for (std::size_t k = 0; k < 3; ++k) y_[3 + k] += impulse[k];
  }
  void step(double h) {
    y_ = stepped(y_, h, [&](const std::array<double, 6>& y) {
      const Vector u{y[0], y[1], y[2]}, H{y[3], y[4], y[5]};
      const Vector w = H / top_.J + (1 / top_.I - 1 / top_.J) * dot(H, u) * u;
      const Vector du = cross(w, u), dH = cross(top_.l * u, Vector{0, 0, -top_.m * g});
      return std::array<double, 6>{du.x, du.y, du.z, dH.x, dH.y, dH.z};
    });
  }

 private:
  const Top& top_;
  std::array<double, 6> y_{};
};

// A steady precession with a root of the file, and the fastest rate in it.
struct Precession {
  double theta, S, P, fastest;
  Vector axis() const { return {std::sin(theta), 0, std::cos(theta)}; }
  Vector turning() const { return Vector{0, 0, P} + S * axis(); }
};
double fastest_of(const Top& top, double P, double S, double c) {
  return std::max({std::abs(P), top.I * std::abs(S + P * c) / top.J, std::sqrt(top.m * g * top.l / top.J)});
}

TEST(SteadyIntegrated, PrecessionFoundStaysSteady) {
  Random random(421);
  constexpr int cases = poinsot::testing::case_count(1000);
  int integrated = 0;
  for (int trial = 0; trial < cases; ++trial) {
    const Top top(random);
    const double theta = random.uniform(0.2, 2.9), S = random.uniform(5, 200) * (random.chance(0.5) ? 1 : -1);
    for (const Near& found : solved_near(top.precessing(theta, S, g))) {
      const Precession steady{theta, S, found.unknown, fastest_of(top, found.unknown, S, std::cos(theta))};
      FlyingTop flying(top, steady.axis(), steady.turning());
      constexpr int steps = 400;
      const double h = 0.01 / steady.fastest;
      for (int i = 0; i < steps; ++i) flying.step(h);
      const double turned = steady.P * steps * h;
      const Vector expected{std::sin(theta) * std::cos(turned), std::sin(theta) * std::sin(turned), std::cos(theta)};
      ASSERT_LE(norm(flying.axis() - expected), 1e-8) << found.unknown << "\n" << top.precessing(theta, S, g);
      ++integrated;
    }
  }
  EXPECT_GT(integrated, cases);
}

// The period of a small nutation, from the maxima of the height of the axis.
TEST(SteadyIntegrated, NutationMeasured) {
  Random random(422);
  for (int trial = 0; trial < 100; ++trial) {
    const Top top(random);
    const double theta = random.uniform(0.4, 2.7), S = random.uniform(20, 200);
    for (const Near& found : solved_near(top.precessing(theta, S, g))) {
      ASSERT_EQ(found.frequencies.size(), 1U);
      const Precession steady{theta, S, found.unknown, fastest_of(top, found.unknown, S, std::cos(theta))};
      FlyingTop flying(top, steady.axis(), steady.turning());
      // A push across the axis, in the vertical plane through it and out of it.
      flying.push(1e-5 * top.J * steady.fastest * cross(steady.axis(), Vector{0, 1, 0}));
      const double h = 0.02 / steady.fastest;
      std::vector<double> maxima;
      double before = flying.axis().z, now = before;
      for (int i = 0; maxima.size() < 6 && i < 200000; ++i) {
        flying.step(h);
        const double next = flying.axis().z;
        if (i > 0 && now > before && now >= next)
          maxima.push_back(h * (i + 0.5 * (before - next) / (before - 2 * now + next)));
        before = now;
        now = next;
      }
      ASSERT_EQ(maxima.size(), 6U);
      const double measured = 2 * 3.141592653589793 * 5 / (maxima[5] - maxima[0]);
      EXPECT_NEAR(found.frequencies[0], measured, 1e-3 * measured) << top.precessing(theta, S, g);
    }
  }
}

// How fast the axis of a top that does not spin fast enough to sleep leaves the vertical.
TEST(SteadyIntegrated, GrowthOfASleepingTopMeasured) {
  Random random(423);
  for (int trial = 0; trial < 100; ++trial) {
    const Top top(random);
    const double S = random.uniform(0.1, 0.9) * std::sqrt(4 * top.J * top.m * g * top.l) / top.I;
    const std::string text = fmt::format("title: a top that falls\ngravity: [0, 0, -{:.17g} m/s^2]\n", g) +
                             top.text({0, 0, 1}) +
                             fmt::format(
                                 "steady: {{frame: ground, spins: {{top: {{about: O->G, rate: {:.17g} rad/s}}}}}}\n"
                                 "ask: {{s: stable(top), g: growth_rate(top), f: frequencies(top)}}\n",
                                 S);
    const double growth = solved_near(text).front().growth;
    ASSERT_GT(growth, 0) << text;
    FlyingTop flying(top, {0, 0, 1}, {0, 0, S});
    flying.push(1e-7 * top.J * growth * Vector{1, 0.3, 0});
    const auto away = [&] { return std::hypot(flying.axis().x, flying.axis().y); };
    // Between e^6 and e^9 times the start what dies out is gone, and the deviation is still small.
    const int steps = 3 * static_cast<int>(std::ceil(300 * fastest_of(top, growth, S, 1) / growth));
    const double h = 9 / growth / steps;
    double early = 0;
    for (int i = 0; i < steps; ++i) {
      if (3 * i == 2 * steps) early = away();
      flying.step(h);
    }
    EXPECT_NEAR(std::log(away() / early) / (3 / growth), growth, 1e-3 * growth) << text;
  }
}

// Euler's equations of a free body about its intermediate axis.
TEST(SteadyIntegrated, GrowthAboutTheIntermediateAxisMeasured) {
  Random random(424);
  for (int trial = 0; trial < 100; ++trial) {
    const double A = random.uniform(1, 2), B = A * random.uniform(1.1, 1.5), w = random.uniform(0.5, 20);
    const double C = B + random.uniform(0.2, 0.9) * A;  // less than A + B
    const std::string text = fmt::format(
        "title: a body thrown into the air\ngravity: none\npoints: {{G: [0, 0, 0]}}\n"
        "bodies: {{body: {{mass: 2 kg, center: G, inertia: {{x: {:.17g} kg*m^2, y: {:.17g} kg*m^2, z: {:.17g} "
        "kg*m^2}}}}}}\n"
        "frames: {{figure: {{rides_on: center(body), turns: y, rate: {:.17g} rad/s}}}}\nsteady: {{frame: figure}}\n"
        "instants: {{now: {{velocity(body): 0}}}}\n"
        "ask: {{s: stable(body), g: growth_rate(body), f: frequencies(body)}}\n",
        A, B, C, w);
    const double growth = solved_near(text).front().growth;
    ASSERT_GT(growth, 0) << text;
    std::array<double, 3> y{1e-7 * w, w, 2e-7 * w};
    constexpr int steps = 3000;
    const double h = 9 / growth / steps;
    double early = 0;
    for (int i = 0; i < steps; ++i) {
      if (3 * i == 2 * steps) early = std::abs(y[0]);
      y = stepped(y, h, [&](const std::array<double, 3>& v) {
        return std::array<double, 3>{(B - C) / A * v[1] * v[2], (C - A) / B * v[2] * v[0], (A - B) / C * v[0] * v[1]};
      });
    }
    EXPECT_NEAR(std::log(std::abs(y[0]) / early) / (3 / growth), growth, 1e-3 * growth) << text;
  }
}

}  // namespace steady_integrated_test
}  // namespace poinsot::problem
