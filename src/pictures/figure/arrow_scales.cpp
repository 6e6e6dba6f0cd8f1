// Which vectors share a scale, and how values are written.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "pictures/figure/arrows.h"

namespace poinsot::pictures {

using scene::Quantity;

Scale scale_of(Quantity quantity) {
  switch (quantity) {
    case Quantity::force:
    case Quantity::weight:
    case Quantity::rate_of_momentum:
      return Scale::force;
    case Quantity::couple:
    case Quantity::rate_of_angular_momentum:
      return Scale::couple;
    case Quantity::impulse:
    case Quantity::linear_momentum:
      return Scale::impulse;
    case Quantity::angular_impulse:
    case Quantity::angular_momentum:
      return Scale::angular_impulse;
    case Quantity::velocity:
      return Scale::velocity;
    case Quantity::angular_velocity:
      return Scale::angular_velocity;
    case Quantity::acceleration:
      return Scale::acceleration;
    case Quantity::angular_acceleration:
      return Scale::angular_acceleration;
    case Quantity::displacement:
      return Scale::displacement;
    case Quantity::angular_displacement:
      return Scale::angular_displacement;
    case Quantity::unbalance:
      return Scale::unbalance;
  }
  return Scale::force;
}

bool turns(Quantity quantity) {
  switch (quantity) {
    case Quantity::couple:
    case Quantity::angular_impulse:
    case Quantity::angular_velocity:
    case Quantity::angular_acceleration:
    case Quantity::angular_momentum:
    case Quantity::rate_of_angular_momentum:
    case Quantity::angular_displacement:
      return true;
    default:
      return false;
  }
}

void Largest::include(const scene::Arrow& arrow) {
  if (arrow.open) return;
  double& largest = of[static_cast<std::size_t>(scale_of(arrow.quantity))];
  if (const double size = norm(arrow.vector); std::isfinite(size)) largest = std::max(largest, size);
}

std::string value_text(double value, const std::string& unit, int digits) {
  std::string text = fmt::format("{:.{}g}", value, digits);
  if (const std::size_t e = text.find('e'); e != std::string::npos) {
    int exponent = 0;
    for (std::size_t i = e + 2; i < text.size(); ++i) exponent = exponent * 10 + (text[i] - '0');
    text = fmt::format("{}·10^{}{}", text.substr(0, e), text[e + 1] == '-' ? "−" : "", exponent);
  }
  if (!text.empty() && text[0] == '-') text = "−" + text.substr(1);
  std::string spaced;
  for (std::size_t i = 0; i < unit.size(); ++i) {
    if (unit[i] == '*')
      spaced += "·";
    else if (unit[i] == '^' && i + 1 < unit.size() && (unit[i + 1] == '2' || unit[i + 1] == '3'))
      spaced += unit[++i] == '2' ? "²" : "³";
    else
      spaced += unit[i];
  }
  if (spaced == "deg") return text + "°";
  return spaced.empty() || spaced == "1" ? text : text + " " + spaced;
}

}  // namespace poinsot::pictures
