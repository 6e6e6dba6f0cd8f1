#include "problem/language/dimension.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <numeric>
#include <string_view>

namespace poinsot::problem {
namespace {

constexpr int furthest = 12 * 1000;

int bounded(long long twelfths) { return static_cast<int>(std::clamp<long long>(twelfths, -furthest, furthest)); }

struct Word {
  Dimension dimension;
  std::string_view text;
};

// A dimension is looked up with its angle first, then without it.
constexpr std::array words{
    Word{dimensions::none, "a pure number"},
    Word{dimensions::angle, "an angle"},
    Word{dimensions::length, "a length"},
    Word{dimensions::area, "an area"},
    Word{dimensions::volume, "a volume"},
    Word{Dimension::of(4, 0, 0), "a second moment of area"},
    Word{dimensions::mass, "a mass"},
    Word{dimensions::time, "a time"},
    Word{dimensions::frequency, "a frequency"},
    Word{dimensions::angular_velocity, "an angular velocity"},
    Word{dimensions::angular_acceleration, "an angular acceleration"},
    Word{dimensions::velocity, "a velocity"},
    Word{dimensions::acceleration, "an acceleration"},
    Word{dimensions::gravitational_parameter, "a parameter of gravity"},
    Word{dimensions::force, "a force"},
    Word{Dimension::of(2, 1, -2, -1), "a torsional stiffness"},
    Word{dimensions::moment, "a moment or an energy"},
    Word{dimensions::power, "a power"},
    Word{dimensions::momentum, "a momentum or an impulse"},
    Word{dimensions::angular_momentum, "an angular momentum"},
    Word{dimensions::moment_of_inertia, "a moment of inertia"},
    Word{dimensions::density, "a mass per volume"},
    Word{Dimension::of(-2, 1, 0), "a mass per area"},
    Word{Dimension::of(-1, 1, 0), "a mass per length"},
    Word{dimensions::stiffness, "a force per length"},
    Word{dimensions::pressure, "a force per area"},
    Word{Dimension::of(-2, 1, -2), "a force per volume"},
    Word{Dimension::of(0, 1, -1), "a mass per time"},
    Word{Dimension::of(1, 1, 0), "a first moment of mass"},
};

void append_factor(std::string& text, std::string_view base, int twelfths, char operation) {
  if (twelfths == 0) return;
  if (operation == '/') text += text.empty() ? "1/" : "/";
  if (operation == '*' && !text.empty()) text += '*';
  text += base;
  const int size = std::abs(twelfths);
  if (size == 12) return;
  const int divisor = std::gcd(size, 12);
  text += '^';
  if (size % 12 == 0) {
    text += std::to_string(size / 12);
  } else {
    text += '(' + std::to_string(size / divisor) + '/' + std::to_string(12 / divisor) + ')';
  }
}

}  // namespace

Dimension operator*(const Dimension& a, const Dimension& b) {
  return {bounded(a.length + b.length), bounded(a.mass + b.mass), bounded(a.time + b.time), bounded(a.angle + b.angle)};
}

Dimension operator/(const Dimension& a, const Dimension& b) {
  return {bounded(a.length - b.length), bounded(a.mass - b.mass), bounded(a.time - b.time), bounded(a.angle - b.angle)};
}

std::optional<Dimension> power(const Dimension& a, int numerator, int denominator) {
  if (denominator == 0) return std::nullopt;
  Dimension result;
  for (int Dimension::*exponent : {&Dimension::length, &Dimension::mass, &Dimension::time, &Dimension::angle}) {
    const long long product = static_cast<long long>(a.*exponent) * numerator;
    if (product % denominator != 0) return std::nullopt;
    result.*exponent = bounded(product / denominator);
  }
  return result;
}

bool reasonable(const Dimension& a) {
  return std::max({std::abs(a.length), std::abs(a.mass), std::abs(a.time), std::abs(a.angle)}) <= 12 * 100;
}

bool same_kind(const Dimension& a, const Dimension& b) {
  return a.length == b.length && a.mass == b.mass && a.time == b.time;
}

bool is_pure(const Dimension& a) { return same_kind(a, dimensions::none); }

std::string to_string(const Dimension& a) {
  for (const Word& word : words) {
    if (word.dimension == a) return std::string(word.text);
  }
  for (const Word& word : words) {
    if (same_kind(word.dimension, a) && !is_pure(a)) return std::string(word.text);
  }
  return "a quantity in " + base_units(a);
}

std::string base_units(const Dimension& a) {
  std::string text;
  append_factor(text, "kg", std::max(a.mass, 0), '*');
  append_factor(text, "m", std::max(a.length, 0), '*');
  append_factor(text, "s", std::max(a.time, 0), '*');
  append_factor(text, "rad", std::max(a.angle, 0), '*');
  append_factor(text, "kg", std::min(a.mass, 0), '/');
  append_factor(text, "m", std::min(a.length, 0), '/');
  append_factor(text, "s", std::min(a.time, 0), '/');
  append_factor(text, "rad", std::min(a.angle, 0), '/');
  return text.empty() ? "1" : text;
}

}  // namespace poinsot::problem
