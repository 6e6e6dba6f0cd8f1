// Dimensions of quantities: exponents of length, mass, time and angle.
//
// Angles are tracked softly: the radian has the exponent 1 of angle so that an answer can come in degrees or rpm, but
// two quantities are of the same kind whatever their angle exponents (v = omega r mixes them freely).
#pragma once

#include <optional>
#include <string>

namespace poinsot::problem {

// Exponents in twelfths, so that square, cube and fourth roots are exact.
struct Dimension {
  int length = 0;
  int mass = 0;
  int time = 0;
  int angle = 0;

  friend bool operator==(const Dimension&, const Dimension&) = default;

  // Whole exponents.
  static constexpr Dimension of(int length, int mass, int time, int angle = 0) {
    return {12 * length, 12 * mass, 12 * time, 12 * angle};
  }
};

namespace dimensions {
inline constexpr Dimension none{};
inline constexpr Dimension angle = Dimension::of(0, 0, 0, 1);
inline constexpr Dimension length = Dimension::of(1, 0, 0);
inline constexpr Dimension area = Dimension::of(2, 0, 0);
inline constexpr Dimension volume = Dimension::of(3, 0, 0);
inline constexpr Dimension mass = Dimension::of(0, 1, 0);
inline constexpr Dimension time = Dimension::of(0, 0, 1);
inline constexpr Dimension frequency = Dimension::of(0, 0, -1);
inline constexpr Dimension velocity = Dimension::of(1, 0, -1);
inline constexpr Dimension acceleration = Dimension::of(1, 0, -2);
inline constexpr Dimension gravitational_parameter = Dimension::of(3, 0, -2);
inline constexpr Dimension angular_velocity = Dimension::of(0, 0, -1, 1);
inline constexpr Dimension angular_acceleration = Dimension::of(0, 0, -2, 1);
inline constexpr Dimension force = Dimension::of(1, 1, -2);
inline constexpr Dimension moment = Dimension::of(2, 1, -2);
inline constexpr Dimension energy = Dimension::of(2, 1, -2);
inline constexpr Dimension power = Dimension::of(2, 1, -3);
inline constexpr Dimension momentum = Dimension::of(1, 1, -1);
inline constexpr Dimension angular_momentum = Dimension::of(2, 1, -1);
inline constexpr Dimension moment_of_inertia = Dimension::of(2, 1, 0);
inline constexpr Dimension density = Dimension::of(-3, 1, 0);
inline constexpr Dimension stiffness = Dimension::of(0, 1, -2);
inline constexpr Dimension pressure = Dimension::of(-1, 1, -2);
}  // namespace dimensions

// Product and quotient of quantities. Exponents beyond +-1000 stay there, so that nothing overflows; such a dimension
// is not `reasonable`.
Dimension operator*(const Dimension& a, const Dimension& b);
Dimension operator/(const Dimension& a, const Dimension& b);

// A power with the exponent numerator/denominator; nothing if exponents would be no whole twelfths or the denominator
// is zero.
std::optional<Dimension> power(const Dimension& a, int numerator, int denominator = 1);

// Whether all exponents are within +-100.
bool reasonable(const Dimension& a);

// Whether two dimensions are equal but for the exponent of angle.
bool same_kind(const Dimension& a, const Dimension& b);

// Whether there is no length, mass or time: a pure number or an angle.
bool is_pure(const Dimension& a);

// In words: "a force", "an angular velocity", "a pure number"; a dimension without a word of its own is "a quantity
// in kg*m^2/s^3".
std::string to_string(const Dimension& a);

// In SI base units: "kg*m/s^2", "rad/s", "1" for a pure number, "m^(1/2)" for a root.
std::string base_units(const Dimension& a);

}  // namespace poinsot::problem
