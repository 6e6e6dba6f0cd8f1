// Free precession against the general motion and the relations of the two cones.
#include "poinsot/engine/motion/closed_form/free_precession.h"

#include <gtest/gtest.h>

#include <numbers>
#include <stdexcept>

#include "engine/motion/closed_form/closed_form_support.h"
#include "poinsot/engine/motion/closed_form/torque_free.h"

namespace poinsot {
namespace free_precession_test {

TEST(FreePrecession, obeys_the_law_of_sines_and_the_cones) {
  RandomMotion random(1);
  for (int i = 0; i < 1000; ++i) {
    const double J = random.uniform(0.2, 1), I = random.uniform(0.01, 2 * J);
    const double w_z = random.uniform(0.1, 3), w_t = random.uniform(0.1, 3);
    const FreePrecession p = free_precession(I, J, w_z, w_t);
    const double theta = p.momentum_angle, gamma = p.velocity_angle, w = std::hypot(w_z, w_t);
    EXPECT_NEAR(std::tan(gamma), I / J * std::tan(theta), 1e-13 * std::tan(gamma));  // Eq. 18.49
    EXPECT_NEAR(p.precession_rate * std::sin(theta), w * std::sin(gamma), 1e-14 * w);
    EXPECT_NEAR(p.spin_rate * std::sin(theta), w * std::sin(theta - gamma), 1e-14 * w);
    EXPECT_NEAR(p.spin_rate + p.precession_rate * std::cos(theta), w_z, 1e-13 * w);  // Eq. 18.35
    EXPECT_NEAR(p.space_cone, std::fabs(theta - gamma), 1e-15);
    EXPECT_EQ(p.body_cone, gamma);
    EXPECT_EQ(p.sense, I < J ? PrecessionSense::direct : PrecessionSense::retrograde);
    const Polhode polhode({J, J, I}, Matrix3<double>::identity(), {w_t, 0, w_z});
    EXPECT_EQ(p.sense, polhode.sense());
    EXPECT_NEAR(polhode.nutation_range({0, 0, 1}).maximum, theta, 1e-14);
    EXPECT_NEAR(polhode.nutation_range({0, 0, 1}).minimum, theta, 1e-14);
  }
}

TEST(FreePrecession, takes_spins_of_either_sign_and_none) {
  const FreePrecession back = free_precession(1, 2, -3, 4), forth = free_precession(1, 2, 3, 4);
  EXPECT_NEAR(back.momentum_angle, std::numbers::pi - forth.momentum_angle, 1e-15);
  EXPECT_EQ(back.spin_rate, -forth.spin_rate);
  EXPECT_NEAR(back.body_cone, forth.body_cone, 1e-15);
  EXPECT_EQ(back.space_cone, forth.space_cone);
  EXPECT_EQ(free_precession(1, 2, 3, 0).sense, PrecessionSense::none);
  EXPECT_EQ(free_precession(1, 2, 0, 3).sense, PrecessionSense::none);
  EXPECT_EQ(free_precession(2, 2, 1, 3).space_cone, 0);
  EXPECT_EQ(free_precession(2, 2, 1, 3).spin_rate, 0);
}

TEST(FreePrecession, refuses_what_is_no_body) {
  const auto message = [](double I, double J, double w_z, double w_t) -> std::string {
    try {
      free_precession(I, J, w_z, w_t);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "accepted";
  };
  EXPECT_EQ(message(0, 1, 1, 1), "free_precession: the axial moment is 0; it must be positive and finite");
  EXPECT_EQ(message(1, -1, 1, 1), "free_precession: the transverse moment is -1; it must be positive and finite");
  EXPECT_EQ(message(1, 1, INFINITY, 1), "free_precession: the axial rate is inf; it must be finite");
  EXPECT_EQ(message(1, 1, 1, -2), "free_precession: the transverse rate is -2; it must be finite and not negative");
}

}  // namespace free_precession_test
}  // namespace poinsot
