#include "problem/entries/drawn_letters.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "poinsot/engine/math/algebra/spatial.h"

namespace poinsot::problem {
namespace {

using Random = std::mt19937_64;

int among(Random& random, int low, int high) { return std::uniform_int_distribution<int>(low, high)(random); }

// Values that a body is likely to have: moments of inertia of similar size, with products and offsets small beside
// them; or one small moment, as a slender body has.
double likely_of_a_body(const Letter& letter, int attempt, double value, Random& random) {
  const Dimension& kind = letter.unit.dimension;
  if (kind == dimensions::moment_of_inertia)
    value = letter.either_sign ? among(random, 1, 4) / 4.0 : 4 + among(random, 0, 8) / 4.0;
  if (kind == dimensions::mass) value = among(random, 1, 4) / 2.0;
  if (kind == dimensions::length) value = among(random, 1, 4) / 8.0;
  if (attempt % 4 != 3) return value;
  if (kind == dimensions::moment_of_inertia)
    value = among(random, 0, 2) == 0 ? among(random, 1, 2) / 4.0 : 3 + attempt % 3;
  if (kind == dimensions::mass) value = among(random, 1, 2) / 4.0;
  if (letter.either_sign && (kind == dimensions::moment_of_inertia || kind == dimensions::length)) value = 0;
  return value;
}

}  // namespace

double DrawnSizes::of(const Dimension& dimension) const {
  constexpr double whole = 12;  // exponents of dimensions are counted in twelfths
  return std::pow(length, dimension.length / whole) * std::pow(mass, dimension.mass / whole) *
         std::pow(time, dimension.time / whole);
}

// The least logarithms x of the three sizes with A x = b as nearly as can be, where a row of A has the exponents of a
// datum and b its logarithm: what minimises |A x - b|^2 + |x|^2 / 10^6.
DrawnSizes drawn_sizes(const std::vector<std::pair<double, Dimension>>& data) {
  // In decades; and so little that it decides only what the data leave open.
  constexpr double far = 4, drawn_to_si = 1e-6;
  SymmetricMatrix3<double> square{};
  Vector3<double> right{};
  bool is_far = false;
  for (const auto& [number, dimension] : data) {
    const Vector3<double> row{dimension.length / 12.0, dimension.mass / 12.0, dimension.time / 12.0};
    if (!std::isfinite(number) || number == 0 || norm(row) == 0) continue;
    const double decades = std::log10(std::abs(number));
    is_far = is_far || std::abs(decades) > far;
    square = square + SymmetricMatrix3<double>{row.x * row.x, row.y * row.y, row.z * row.z,
                                               row.x * row.y, row.y * row.z, row.z * row.x};
    right = right + decades * row;
  }
  if (!is_far) return {};
  square = square + SymmetricMatrix3<double>::diagonal(drawn_to_si, drawn_to_si, drawn_to_si);
  const Vector3<double> x = inverse(square) * right;
  // Whole decades leave the digits of what is drawn as they are.
  return {std::pow(10, std::round(x.x)), std::pow(10, std::round(x.y)), std::pow(10, std::round(x.z))};
}

// The first points have small whole numbers, later ones quarters. Angles are multiples of 15 deg or quarters of a
// radian, now and then more than half a turn. Every other point has values that a rigid body is likely to have; some
// have large or small numbers.
Point draw_point(const std::vector<Letter>& letters, int attempt, const DrawnSizes& sizes) {
  Random random(7000 + static_cast<std::uint64_t>(attempt));
  Point point;
  // By name, so that the order of a file has no part in it.
  std::vector<const Letter*> by_name;
  for (const Letter& letter : letters) by_name.push_back(&letter);
  std::ranges::sort(by_name, {}, [](const Letter* letter) -> const std::string& { return letter->name; });
  for (const Letter* each : by_name) {
    const Letter& letter = *each;
    double value = attempt < simple_points ? among(random, 1, 3 + attempt / 10) : among(random, 1, 24) / 4.0;
    const bool angle = letter.unit.dimension == dimensions::angle;
    if (attempt % 2 == 1) value = likely_of_a_body(letter, attempt, value, random);
    if (angle) {
      const bool degrees = letter.unit.text == "deg";
      value = degrees ? 15 * among(random, 1, 11) : among(random, 1, 12) / 4.0;
      if (attempt % 5 == 4) value += (degrees ? 360 : 6.25) * among(random, 0, 2) + (degrees ? 90 : 1.5);
    } else if (attempt % 8 == 6) {
      value *= std::pow(10.0, among(random, -4, 4));
    }
    if ((letter.either_sign || (angle && attempt % 3 == 2)) && among(random, 0, 1) == 0) value = -value;
    if (letter.either_sign && attempt % 4 == 2 && among(random, 0, 3) == 0) value = 0;
    if (letter.either_sign && attempt % 16 == 12) value = 0;
    point[letter.name] = value * letter.unit.factor * sizes.of(letter.unit.dimension);
  }
  return point;
}

double drawn_letter(const Letter& letter, std::mt19937_64& random, int spread) {
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  if (letter.unit.dimension == dimensions::angle) return between(0.2, 1.2);
  if (spread == 0) return letter.unit.factor * between(0.5, 2);
  return letter.unit.factor * std::exp(std::min(0.7 + 0.4 * spread, 9.2) * between(-1, 1));
}

double drawn_near(double value, std::mt19937_64& random) {
  return value * std::uniform_real_distribution<double>(0.8, 1.25)(random);
}

Value<double> value_of_unknown(const Unknown& unknown, const Vector3<double>& components,
                               const std::optional<MotionPlane>& plane) {
  if (!unknown.vector) return Value<double>::of_number(components.x, unknown.unit.dimension);
  Value<double> value = Value<double>::of_vector(components, unknown.unit.dimension);
  if (plane) value.vector[plane->normal()] = 0;
  return value;
}

}  // namespace poinsot::problem
