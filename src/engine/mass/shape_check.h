// The rules for shapes one by one; the first that is broken is kept.
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <initializer_list>
#include <numbers>
#include <string>
#include <string_view>

#include "poinsot/engine/mass/shape_faults.h"

namespace poinsot::shape_faults {

// Below this part of the largest length a length is zero to rounding: lengths are differences of coordinates that were
// carried through units and expressions. A sheet of one atom on a kilometre is ten times thicker.
inline constexpr double zero_length = 1e-12;

// A point in a message.
struct PointText {
  const Point& point;
};
inline PointText text(const Point& v) { return {v}; }

}  // namespace poinsot::shape_faults

template <>
struct fmt::formatter<poinsot::shape_faults::PointText> {
  constexpr auto parse(format_parse_context& context) { return context.begin(); }
  template <class Context>
  auto format(const poinsot::shape_faults::PointText& text, Context& context) const {
    const poinsot::shape_faults::Point& v = text.point;
    return fmt::format_to(context.out(), "({:.10g}, {:.10g}, {:.10g})", v.x, v.y, v.z);
  }
};

namespace poinsot::shape_faults {

class ShapeCheck {
 public:
  // What the views show must outlive the check.
  ShapeCheck(std::string_view shape, std::string_view name) : shape_(shape), name_(name) {}

  bool good() const { return !fault_; }
  Fault result() const { return fault_; }

  // The message is written only where the rule is broken.
  template <class... Parts>
  ShapeCheck& require(bool holds, ShapeRule rule, fmt::format_string<const Parts&...> message, const Parts&... parts) {
    if (good() && !holds)
      fault_ = ShapeFault{rule, fmt::format("{} '{}': ", shape_, name_) + fmt::format(message, parts...)};
    return *this;
  }
  ShapeCheck& point(std::string_view what, const Point& p) {
    return require(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z), ShapeRule::finite_values,
                   "{} is {}; coordinates must be finite numbers", what, text(p));
  }
  ShapeCheck& positive(std::string_view what, double length) {
    require(std::isfinite(length), ShapeRule::finite_values, "{} is {}; it must be a finite number", what, length);
    return require(length > 0, ShapeRule::positive_extent, "{} is {:.10g} m; it must be more than zero", what, length);
  }
  ShapeCheck& not_negative(std::string_view what, double length) {
    require(std::isfinite(length), ShapeRule::finite_values, "{} is {}; it must be a finite number", what, length);
    return require(length >= 0, ShapeRule::positive_extent, "{} is {:.10g} m; it must not be negative", what, length);
  }
  ShapeCheck& direction(std::string_view what, const Point& d) {
    point(what, d);
    return require(norm_squared(d) > 0, ShapeRule::given_direction, "{} is the zero vector; give a direction", what);
  }
  ShapeCheck& edge(std::string_view what, const Point& e) {
    point(what, e);
    return require(norm_squared(e) > 0, ShapeRule::positive_extent, "{} is the zero vector; it must have a length",
                   what);
  }
  ShapeCheck& distinct(std::string_view what_A, const Point& A, std::string_view what_B, const Point& B) {
    point(what_A, A).point(what_B, B);
    return require(norm(B - A) > zero_length * std::max(norm(A), norm(B)), ShapeRule::distinct_points,
                   "{} and {} coincide at {}; give two different points", what_A, what_B, text(A));
  }
  // The direction must have a part across the line.
  ShapeCheck& across(std::string_view what, const Point& d, std::string_view what_line, const Point& line) {
    direction(what, d);
    return require(norm(cross(d, line)) > zero_length * norm(d) * norm(line), ShapeRule::clear_direction,
                   "{} {} is along {} {}; give a direction across it", what, text(d), what_line, text(line));
  }
  ShapeCheck& perpendicular(std::string_view what_a, const Point& a, std::string_view what_b, const Point& b,
                            double tolerance) {
    if (!good()) return *this;
    const double cosine = dot(a, b) / (norm(a) * norm(b));
    return require(std::abs(cosine) <= tolerance, ShapeRule::right_angle,
                   "{} {} and {} {} must be perpendicular, but make an angle of {:.10g} deg", what_a, text(a), what_b,
                   text(b), std::acos(std::clamp(cosine, -1.0, 1.0)) * 180 / std::numbers::pi);
  }
  ShapeCheck& turn(std::string_view what, double angle) {
    require(std::isfinite(angle), ShapeRule::finite_values, "{} is {}; it must be a finite number", what, angle);
    constexpr double decimals = 1e-9;  // 6.283185307, as people write a full turn, is one
    return require(angle > 0 && angle <= 2 * std::numbers::pi * (1 + decimals), ShapeRule::angle_range,
                   "{} is {:.10g} rad; it must be more than zero and at most a full turn, 2 pi", what, angle);
  }

 private:
  std::string_view shape_, name_;
  Fault fault_;
};

// The outline of a polygon, in polygon_faults.cpp.
void check_outline(ShapeCheck& check, const std::vector<Point>& vertices, double tolerance);

}  // namespace poinsot::shape_faults
