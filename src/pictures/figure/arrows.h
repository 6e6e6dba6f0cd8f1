// Vectors as arrows: how long, where, with which head.
#pragma once

#include <array>
#include <vector>

#include "pictures/figure/panel.h"

namespace poinsot::pictures {

// Quantities that are drawn to one scale: those that stand in one equation.
enum class Scale {
  force,
  couple,
  impulse,
  angular_impulse,
  velocity,
  angular_velocity,
  acceleration,
  angular_acceleration,
  displacement,
  angular_displacement,
  unbalance
};
constexpr std::size_t scale_count = 11;
Scale scale_of(scene::Quantity quantity);
// Whether it is a turning: drawn with a double head and a curved arrow around it.
bool turns(scene::Quantity quantity);

// The largest vector of each scale in a figure.
struct Largest {
  std::array<double, scale_count> of{};
  void include(const scene::Arrow& arrow);
};

// Lengths are as the vectors' sizes; an arrow that would be shorter than the least length has that and a mark.
constexpr double longest_arrow = 92, shortest_arrow = 22;
// What is rounding beside the largest is not drawn.
constexpr double rounding_part = 1e-9;

void draw_arrows(Panel& panel, const std::vector<scene::Arrow>& arrows, const Largest& largest);

// A straight arrow with a filled head.
void plain_arrow(Panel& panel, Point2 from, Point2 to, Role role, double width, Ink ink, double head = 7);

// The value of an arrow with its unit, as text.
std::string value_text(double value, const std::string& unit, int digits = 4);

}  // namespace poinsot::pictures
