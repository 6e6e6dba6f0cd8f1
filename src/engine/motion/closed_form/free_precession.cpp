#include "poinsot/engine/motion/closed_form/free_precession.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

namespace poinsot {

FreePrecession free_precession(double axial_moment, double transverse_moment, double axial_rate,
                               double transverse_rate) {
  const auto require = [](bool holds, const char* what, double value, const char* rule) {
    if (!holds) {
      throw std::invalid_argument(fmt::format("free_precession: {} is {}; it must be {}", what, value, rule));
    }
  };
  require(axial_moment > 0 && std::isfinite(axial_moment), "the axial moment", axial_moment, "positive and finite");
  require(transverse_moment > 0 && std::isfinite(transverse_moment), "the transverse moment", transverse_moment,
          "positive and finite");
  require(std::isfinite(axial_rate), "the axial rate", axial_rate, "finite");
  require(transverse_rate >= 0 && std::isfinite(transverse_rate), "the transverse rate", transverse_rate,
          "finite and not negative");

  const double I = axial_moment, J = transverse_moment;
  const double w_z = axial_rate, w_t = transverse_rate;
  FreePrecession p;
  p.angular_momentum = std::hypot(I * w_z, J * w_t);
  p.momentum_angle = std::atan2(J * w_t, I * w_z);
  p.velocity_angle = std::atan2(w_t, w_z);
  p.precession_rate = p.angular_momentum / J;
  p.spin_rate = w_z * ((J - I) / J);
  p.body_cone = std::min(p.velocity_angle, std::numbers::pi - p.velocity_angle);
  // From |H x w| and H . w: the difference of the angles would lose digits.
  p.space_cone = std::atan2(std::fabs(J - I) * std::fabs(w_t * w_z), I * w_z * w_z + J * w_t * w_t);
  if (w_z != 0 && w_t != 0 && I != J) p.sense = I < J ? PrecessionSense::direct : PrecessionSense::retrograde;
  return p;
}

}  // namespace poinsot
