// Chooses the unit of an answer from those that a statement uses.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

#include "problem/language/expression.h"
#include "problem/language/expression_walk.h"
#include "problem/language/unit_table.h"
#include "problem/language/units.h"

namespace poinsot::problem {
namespace {

using namespace dimensions;

Unit named(const char* text) { return text[0] == '\0' ? Unit{} : parse_unit(text); }

// One factor of a composed unit such as m^2/s^3, with its exponent in twelfths.
struct Base {
  const char* name;
  int twelfths;
};

std::string exponent_text(int twelfths) {
  if (twelfths == 12) return "";
  if (twelfths % 12 == 0) return '^' + std::to_string(twelfths / 12);
  int divisor = 12;
  while (twelfths % divisor != 0 || 12 % divisor != 0) --divisor;
  return "^(" + std::to_string(twelfths / divisor) + '/' + std::to_string(12 / divisor) + ')';
}

Unit composed(std::initializer_list<Base> bases, double factor, const Dimension& dimension) {
  Unit unit{factor, dimension, ""};
  for (const Base& base : bases) {
    if (base.twelfths > 0)
      unit.text += (unit.text.empty() ? "" : "*") + std::string(base.name) + exponent_text(base.twelfths);
  }
  for (const Base& base : bases) {
    if (base.twelfths < 0)
      unit.text += (unit.text.empty() ? "1/" : "/") + std::string(base.name) + exponent_text(-base.twelfths);
  }
  return unit;
}

// The dimension without a radian in the numerator beside other units (v = omega r is in m/s). In a denominator the
// radian stays (N*m/rad), but beside times alone, as of the period 2 pi/omega.
Dimension without_idle_angle(const Dimension& dimension) {
  Dimension plain = dimension;
  const bool of_time = plain.length == 0 && plain.mass == 0;
  if (of_time ? plain.angle < 0 && plain.time > 0 : plain.angle > 0) plain.angle = 0;
  return plain;
}

Unit customary_unit(const Dimension& d, bool as_energy) {
  const double foot = find_unit("ft")->factor;
  const double slug = find_unit("slug")->factor;
  const double factor = std::pow(foot, d.length / 12.0) * std::pow(slug, d.mass / 12.0);
  if (same_kind(d, energy) && d.angle == 0) return named(as_energy ? "ft*lb" : "lb*ft");
  if (same_kind(d, dimensions::power)) return named("ft*lb/s");
  // Mass without time is given in slugs, everything else through forces: slug = lb*s^2/ft.
  if (d.time == 0) return composed({{"slug", d.mass}, {"ft", d.length}, {"rad", d.angle}}, factor, d);
  return composed({{"lb", d.mass}, {"ft", d.length - d.mass}, {"rad", d.angle}, {"s", d.time + 2 * d.mass}}, factor, d);
}

bool is_energy_text(const std::string& text) {
  return text.find('J') != std::string::npos || text == "ft*lb" || text == "in*lb" || text == "W*s" || text == "kW*h";
}

}  // namespace

Unit si_unit(const Dimension& dimension, bool as_energy) {
  struct Coherent {
    Dimension dimension;
    const char* text;
  };
  static constexpr std::array coherent{
      Coherent{none, ""},
      Coherent{force, "N"},
      Coherent{moment, "N*m"},
      Coherent{dimensions::power, "W"},
      Coherent{pressure, "Pa"},
      Coherent{stiffness, "N/m"},
      Coherent{Dimension::of(2, 1, -2, -1), "N*m/rad"},
      Coherent{Dimension::of(-2, 1, -2), "N/m^3"},
  };
  const Dimension d = without_idle_angle(dimension);
  if (as_energy && d == energy) return named("J");
  for (const Coherent& unit : coherent) {
    if (unit.dimension == d) return named(unit.text);
  }
  return composed({{"kg", d.mass}, {"m", d.length}, {"rad", d.angle}, {"s", d.time}}, 1, d);
}

std::string format_unit(const Dimension& dimension, bool as_energy) { return si_unit(dimension, as_energy).text; }

void UnitHabits::note(const Unit& unit) {
  for (std::size_t i = 0; i < unit.text.size();) {
    std::size_t end = unit.text.find_first_of("*/^()-0123456789", i);
    if (end == std::string::npos) end = unit.text.size();
    if (const NamedUnit* piece = find_unit(std::string_view(unit.text).substr(i, end - i))) {
      customary_ = customary_ || piece->customary;
    }
    i = end + 1;
  }
  degrees_ = degrees_ || unit.text == "deg";
  const auto known =
      std::find_if(uses_.begin(), uses_.end(), [&](const Use& use) { return use.unit.text == unit.text; });
  if (known == uses_.end()) {
    uses_.push_back({unit, 1});
  } else {
    ++known->count;
  }
}

void UnitHabits::note(const Expression& expression) {
  if (const Number* number = expression.as<Number>(); number && number->has_unit) note(number->unit);
  for_each_child(expression, [&](const Expression& part) { note(part); });
}

const Unit* UnitHabits::most_used(const Dimension& dimension, bool as_energy) const {
  const Use* best = nullptr;
  for (const Use& use : uses_) {
    if (use.unit.dimension != dimension) continue;
    if (dimension == energy && is_energy_text(use.unit.text) != as_energy) continue;
    if (!best || use.count > best->count) best = &use;
  }
  return best ? &best->unit : nullptr;
}

Unit UnitHabits::unit_for(const Dimension& dimension, bool as_energy) const {
  if (dimension == none) return {};
  if (dimension == dimensions::angle) return named(degrees_ ? "deg" : "rad");
  const bool stated_in_radians =
      std::any_of(uses_.begin(), uses_.end(), [](const Use& u) { return u.unit.text == "rad/s"; });
  if (dimension == angular_velocity && stated_in_radians) return named("rad/s");
  const Dimension plain = without_idle_angle(dimension);
  for (const Dimension& candidate : {dimension, plain}) {
    if (const Unit* stated = most_used(candidate, as_energy)) return *stated;
  }
  return customary_ && (plain.length != 0 || plain.mass != 0) ? customary_unit(plain, as_energy)
                                                              : si_unit(plain, as_energy);
}

}  // namespace poinsot::problem
