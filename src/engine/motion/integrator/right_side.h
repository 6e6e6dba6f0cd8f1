// Equations of motion as one function of one vector y = (q, v), its calls counted; and the sizes errors are measured
// in.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "poinsot/engine/motion/integrator/motion_equations.h"

namespace poinsot {

class RightSide {
 public:
  explicit RightSide(const MotionEquations& equations) : equations_(equations) {}

  int size() const { return equations_.position_size + equations_.velocity_size; }
  const MotionEquations& equations() const { return equations_; }
  std::int64_t evaluations() const { return evaluations_; }

  // dy/dt. False if it is not finite.
  bool operator()(double t, std::span<const double> y, std::span<double> rate);

  std::span<const double> q(std::span<const double> y) const { return y.first(position_count()); }
  std::span<const double> v(std::span<const double> y) const { return y.subspan(position_count()); }

  // Back on the constraints, quaternions to unit length. Returns the largest change over its scale.
  double project(double t, std::span<double> y, std::span<const double> scale);

 private:
  std::size_t position_count() const { return static_cast<std::size_t>(equations_.position_size); }

  const MotionEquations& equations_;
  std::int64_t evaluations_ = 0;
  std::vector<double> before_;
};

// The error allowed in each component of y: tolerance times natural size, and the rounding of the component itself.
class ErrorScale {
 public:
  ErrorScale(const MotionEquations& equations, double tolerance, double span);

  // Minds the magnitudes met. Called with each state that the integration passes.
  void update(std::span<const double> y);
  std::span<const double> allowed() const { return allowed_; }
  double size(std::size_t i) const { return sizes_[i]; }

 private:
  double tolerance_;
  std::size_t position_count_;
  bool velocities_grow_;
  std::vector<double> sizes_;
  std::vector<double> allowed_;
};

}  // namespace poinsot
