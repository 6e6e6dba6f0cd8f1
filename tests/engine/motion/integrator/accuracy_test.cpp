// Every method of integration, on random bodies and gimbals: the error reached against the tolerance asked for.
//
// A step's error is held to the tolerance; on the way the errors of the steps add up and grow. Over a few turns the sum
// is held to a factor here, one for each method.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/dynamics/random_trees.h"
#include "engine/motion/closed_form/gyro_taylor.h"
#include "poinsot/engine/motion/integrator/integrate.h"
#include "poinsot/engine/motion/rotation/rotation.h"

namespace poinsot::testing {
namespace accuracy_test {

using Numbers = std::vector<double>;

struct Offered {
  IntegrationMethod method;
  double factor;    // the error allowed, over tolerance
  double tightest;  // the least tolerance that it is meant for
};

IntegrationOptions options_for(const Offered& offered, double tolerance) {
  IntegrationOptions options;
  options.method = offered.method;
  options.tolerance = tolerance;
  options.store = false;
  options.watch_drift = false;
  return options;
}

// The largest error over tolerance of each method, to be compared with what is allowed.
class Errors {
 public:
  explicit Errors(std::vector<Offered> offered) : offered_(std::move(offered)), largest_(offered_.size(), 0.0) {
    if (!has_stiff_solver())
      std::erase_if(offered_, [](const Offered& o) { return o.method == IntegrationMethod::stiff; });
  }

  template <class ErrorOf>  // of the options; rounding: what no tolerance can undercut
  void measure(double rounding, ErrorOf error_of) {
    for (std::size_t i = 0; i < offered_.size(); ++i) {
      for (const double tolerance : {1e-4, 1e-7, 1e-10, 1e-12}) {
        if (tolerance < offered_[i].tightest) continue;
        const double error = error_of(options_for(offered_[i], tolerance));
        largest_[i] = std::max(largest_[i], error / (tolerance + rounding));
      }
    }
  }
  void expect_within() const {
    for (std::size_t i = 0; i < offered_.size(); ++i) {
      EXPECT_LT(largest_[i], offered_[i].factor) << "method " << static_cast<int>(offered_[i].method);
      // A factor far too wide would notice nothing.
      EXPECT_GT(largest_[i], 0.02 * offered_[i].factor) << "method " << static_cast<int>(offered_[i].method);
    }
  }

 private:
  std::vector<Offered> offered_;
  std::vector<double> largest_;
};

// Heavy and free bodies about a fixed point, over some three turns, against Taylor series in long double.
TEST(Accuracy, IsWhatTheToleranceAsksForOnRandomBodies) {
  using enum IntegrationMethod;
  Errors errors({{automatic, 1, 0}, {explicit_runge_kutta, 12, 0}, {structure_preserving, 4, 0}, {stiff, 40, 1e-9}});
  Random random(3);
  for (int i = 0; i < 120; ++i) {
    RotatingBody body;
    const double I1 = random.uniform(0.5, 2.0), I2 = i % 3 == 0 ? I1 : random.uniform(0.5, 2.0);
    const double I3 = std::abs(I1 - I2) + random.uniform(0.1, 1.0) * (I1 + I2 - std::abs(I1 - I2));
    body.inertia = SymmetricMatrix3<double>::diagonal(I1, I2, I3);
    const Vector3<double> arm = i % 4 == 0 ? Vector3<double>::zero() : random.vector(0.3);
    body.first_moment = arm;
    body.gravity = {0.0, 0.0, -9.81};
    const Vector3<double> w = random.uniform(0.5, 20.0) * random.direction();
    const Quaternion<double> attitude = quaternion_exponential(random.uniform(0.0, 3.0) * random.direction());
    const double end = 20.0 / (norm(w) + 3.0);

    GyroTaylor<long double> taylor({I1, I2, I3}, {9.81L * arm.x, 9.81L * arm.y, 9.81L * arm.z}, 24, 1e-20L);
    const auto exact = taylor.advance({{w.x, w.y, w.z}, {attitude.w, attitude.x, attitude.y, attitude.z}}, end);
    errors.measure(1e-12, [&](const IntegrationOptions& options) {
      const IntegrationResult result = integrate_rotation(body, 0.0, attitude, w, end, options);
      EXPECT_TRUE(result.complete()) << describe(result);
      double error = 0.0;
      for (std::size_t k = 0; k < 4; ++k) error = std::max(error, std::fabs(result.q[k] - double(exact.q[k])));
      for (std::size_t k = 0; k < 3; ++k)
        error = std::max(error, std::fabs(result.v[k] - double(exact.w[k])) / (norm(w) + 3.0));
      return error;
    });
  }
  errors.expect_within();
}

// Gimbals with mass about skew axes, against the structure-preserving method in steps far finer than needed.
TEST(Accuracy, IsWhatTheToleranceAsksForOnRandomGimbals) {
  using enum IntegrationMethod;
  Errors errors({{automatic, 80, 0},
                 {collocation, 80, 0},
                 {explicit_runge_kutta, 200, 0},
                 {structure_preserving, 0.3, 0},
                 {stiff, 500, 1e-9}});
  Random random(4);
  for (int i = 0; i < 80; ++i) {
    ModelBuilder<double> builder;
    int body = ground;
    const int rings = random.integer(2, 3);
    for (int k = 0; k < rings; ++k) {
      // Each ring about its center, the last one heavy on one side.
      MassProperties<double> mass = random.mass();
      mass.center = k + 1 == rings ? 0.2 * random.direction() : Vector3<double>::zero();
      body = builder.add_body("ring " + std::to_string(k), body, Joint<double>::revolute(random.direction()),
                              SpatialTransform<double>::identity(), mass);
    }
    builder.set_gravity({0.0, 0.0, -9.81});
    const Model<double> model = builder.build();
    const MotionEquations equations = tree_equations(model);
    const Numbers q = random.numbers(rings, 3.0), v = random.numbers(rings, 8.0);
    const double end = 1.5;

    IntegrationOptions fine;
    fine.method = structure_preserving;
    fine.fixed_step = 0.005;
    fine.store = false;
    const IntegrationResult exact = integrate(equations, 0.0, q, v, end, fine);
    ASSERT_TRUE(exact.complete());
    double fastest = 1.0 / end;
    for (const double rate : exact.v) fastest = std::max(fastest, std::fabs(rate));
    errors.measure(1e-12, [&](const IntegrationOptions& options) {
      const IntegrationResult result = integrate(equations, 0.0, q, v, end, options);
      EXPECT_TRUE(result.complete()) << describe(result);
      double error = 0.0;
      for (std::size_t k = 0; k < q.size(); ++k) {
        error = std::max(error, std::fabs(result.q[k] - exact.q[k]));
        error = std::max(error, std::fabs(result.v[k] - exact.v[k]) / fastest);
      }
      return error;
    });
  }
  errors.expect_within();
}

}  // namespace accuracy_test
}  // namespace poinsot::testing
