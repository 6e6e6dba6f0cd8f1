#include "problem/entries/viewing_direction.h"

#include <array>
#include <charconv>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace poinsot::problem {
namespace {

std::vector<double> numbers_of(std::string_view words) {
  std::vector<double> numbers;
  while (true) {
    while (!words.empty() && (words.front() == ' ' || words.front() == '+')) words.remove_prefix(1);
    double number = 0;
    const auto [end, error] = std::from_chars(words.data(), words.data() + words.size(), number);
    if (error != std::errc() || !std::isfinite(number)) return {};
    numbers.push_back(number);
    words.remove_prefix(static_cast<std::size_t>(end - words.data()));
    while (!words.empty() && words.front() == ' ') words.remove_prefix(1);
    if (words.empty()) return numbers;
    if (words.front() != ',') return {};
    words.remove_prefix(1);
  }
}

}  // namespace

FrontAndRight front_and_right(const Vector3<double>& up) {
  // The first axis runs to the right where `up` leaves it.
  const Vector3<double> first = std::abs(up.x) > 0.9 ? Vector3<double>{0, 1, 0} : Vector3<double>{1, 0, 0};
  const Vector3<double> front = normalized(cross(first, up));
  return {front, cross(up, front)};
}

std::optional<Vector3<double>> viewing_direction(std::string_view words, const Vector3<double>& up) {
  const auto [front, right] = front_and_right(up);
  const std::array<std::pair<std::string_view, Vector3<double>>, 6> named{
      {{"front", front}, {"back", -front}, {"right", right}, {"left", -right}, {"top", up}, {"bottom", -up}}};
  for (const auto& [name, direction] : named)
    if (name == words) return direction;
  const std::vector<double> numbers = numbers_of(words);
  if (numbers.size() == 2) {
    const double azimuth = numbers[0] * std::numbers::pi / 180, elevation = numbers[1] * std::numbers::pi / 180;
    return std::cos(elevation) * (std::cos(azimuth) * front + std::sin(azimuth) * right) + std::sin(elevation) * up;
  }
  if (numbers.size() == 3) {
    const Vector3<double> direction{numbers[0], numbers[1], numbers[2]};
    if (const double length = norm(direction); length > 0 && std::isfinite(length)) return direction / length;
  }
  return std::nullopt;
}

}  // namespace poinsot::problem
