#include "problem/language/unit_table.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <numbers>
#include <string>

namespace poinsot::problem {
namespace {

using namespace dimensions;

// These are exact by definition (NIST SP 811): the international foot and pound, and standard gravity for the
// pound-force.
constexpr double foot = 0.3048;
constexpr double pound_mass = 0.45359237;
constexpr double standard_gravity = 9.80665;
constexpr double pound_force = pound_mass * standard_gravity;
constexpr double inch = foot / 12;
constexpr double turn = 2 * std::numbers::pi;

static_assert(pound_force == 4.4482216152605);

constexpr std::array table{
    NamedUnit{"m", 1, length},
    NamedUnit{"km", 1e3, length},
    NamedUnit{"dm", 1e-1, length},
    NamedUnit{"cm", 1e-2, length},
    NamedUnit{"mm", 1e-3, length},
    NamedUnit{"um", 1e-6, length},
    NamedUnit{"kg", 1, mass},
    NamedUnit{"g", 1e-3, mass},
    NamedUnit{"mg", 1e-6, mass},
    NamedUnit{"Mg", 1e3, mass},
    NamedUnit{"t", 1e3, mass},
    NamedUnit{"s", 1, dimensions::time},
    NamedUnit{"ms", 1e-3, dimensions::time},
    NamedUnit{"us", 1e-6, dimensions::time},
    NamedUnit{"min", 60, dimensions::time},
    NamedUnit{"h", 3600, dimensions::time},
    NamedUnit{"day", 86400, dimensions::time},
    NamedUnit{"N", 1, force},
    NamedUnit{"mN", 1e-3, force},
    NamedUnit{"kN", 1e3, force},
    NamedUnit{"MN", 1e6, force},
    NamedUnit{"Pa", 1, pressure},
    NamedUnit{"kPa", 1e3, pressure},
    NamedUnit{"MPa", 1e6, pressure},
    NamedUnit{"GPa", 1e9, pressure},
    NamedUnit{"J", 1, energy},
    NamedUnit{"mJ", 1e-3, energy},
    NamedUnit{"kJ", 1e3, energy},
    NamedUnit{"MJ", 1e6, energy},
    NamedUnit{"W", 1, dimensions::power},
    NamedUnit{"mW", 1e-3, dimensions::power},
    NamedUnit{"kW", 1e3, dimensions::power},
    NamedUnit{"MW", 1e6, dimensions::power},
    NamedUnit{"rad", 1, dimensions::angle},
    NamedUnit{"mrad", 1e-3, dimensions::angle},
    NamedUnit{"deg", turn / 360, dimensions::angle},
    NamedUnit{"rev", turn, dimensions::angle},
    NamedUnit{"turn", turn, dimensions::angle},
    NamedUnit{"rpm", turn / 60, angular_velocity},
    NamedUnit{"%", 0.01, none},
    NamedUnit{"ft", foot, length, true},
    NamedUnit{"in", inch, length, true},
    NamedUnit{"yd", 3 * foot, length, true},
    NamedUnit{"mi", 5280 * foot, length, true},
    NamedUnit{"lb", pound_force, force, true},
    NamedUnit{"oz", pound_force / 16, force, true},
    NamedUnit{"kip", 1000 * pound_force, force, true},
    NamedUnit{"lbm", pound_mass, mass, true},
    NamedUnit{"ozm", pound_mass / 16, mass, true},
    NamedUnit{"slug", pound_force / foot, mass, true},
    NamedUnit{"slinch", pound_force / inch, mass, true},
    NamedUnit{"mph", 5280 * foot / 3600, velocity, true},
    NamedUnit{"knot", 1852.0 / 3600, velocity},
    NamedUnit{"psi", pound_force / (inch * inch), pressure, true},
    NamedUnit{"ksi", 1000 * pound_force / (inch * inch), pressure, true},
    NamedUnit{"hp", 550 * foot* pound_force, dimensions::power, true},
};

constexpr std::array wrong_words{
    WrongUnit{"Hz", "'Hz' is ambiguous: a hertz may count turns or radians", "'rev/s' or 'rad/s'"},
    WrongUnit{"kHz", "'kHz' is ambiguous: a hertz may count turns or radians", "'rev/s' or 'rad/s'"},
    WrongUnit{"ton", "'ton' is ambiguous: there are three of them", "'2000 lb', '2000 lbm' or '1 Mg'"},
    WrongUnit{"tons", "'tons' is ambiguous: there are three kinds", "'2000 lb', '2000 lbm' or '1 Mg'"},
    WrongUnit{"kgf", "'kgf', the kilogram-force, is no unit of the language", "9.80665 N"},
    WrongUnit{"kp", "'kp', the kilopond, is no unit of the language", "9.80665 N"},
    WrongUnit{"dyn", "'dyn' is no unit of the language", "1e-5 N"},
    WrongUnit{"cycle", "'cycle' is ambiguous", "rev"},
    WrongUnit{"cps", "'cps' is ambiguous", "rev/s"},
    WrongUnit{"lbs", "", "lb"},
    WrongUnit{"lbf", "", "lb"},
    WrongUnit{"pound", "", "'lb' (a force) or 'lbm' (a mass)"},
    WrongUnit{"pounds", "", "'lb' (a force) or 'lbm' (a mass)"},
    WrongUnit{"ozf", "", "oz"},
    WrongUnit{"ounce", "", "'oz' (a force) or 'ozm' (a mass)"},
    WrongUnit{"ounces", "", "'oz' (a force) or 'ozm' (a mass)"},
    WrongUnit{"kips", "", "kip"},
    WrongUnit{"lbft", "", "lb*ft"},
    WrongUnit{"ftlb", "", "ft*lb"},
    WrongUnit{"ftlbs", "", "ft*lb"},
    WrongUnit{"inlb", "", "in*lb"},
    WrongUnit{"lbin", "", "lb*in"},
    WrongUnit{"slugs", "", "slug"},
    WrongUnit{"feet", "", "ft"},
    WrongUnit{"foot", "", "ft"},
    WrongUnit{"fps", "", "ft/s"},
    WrongUnit{"inch", "", "in"},
    WrongUnit{"inches", "", "in"},
    WrongUnit{"ins", "", "in"},
    WrongUnit{"yard", "", "yd"},
    WrongUnit{"yards", "", "yd"},
    WrongUnit{"mile", "", "mi"},
    WrongUnit{"miles", "", "mi"},
    WrongUnit{"knots", "", "knot"},
    WrongUnit{"kn", "", "'kN' (a force) or 'knot'"},
    WrongUnit{"kt", "", "knot"},
    WrongUnit{"kts", "", "knot"},
    WrongUnit{"kph", "", "km/h"},
    WrongUnit{"kmh", "", "km/h"},
    WrongUnit{"mps", "", "m/s"},
    WrongUnit{"meter", "", "m"},
    WrongUnit{"meters", "", "m"},
    WrongUnit{"metre", "", "m"},
    WrongUnit{"metres", "", "m"},
    WrongUnit{"micron", "", "um"},
    WrongUnit{"\xc2\xb5m", "", "um"},
    WrongUnit{"\xce\xbcm", "", "um"},
    WrongUnit{"\xc2\xb5s", "", "us"},
    WrongUnit{"\xce\xbcs", "", "us"},
    WrongUnit{"gram", "", "g"},
    WrongUnit{"grams", "", "g"},
    WrongUnit{"gm", "", "g"},
    WrongUnit{"kgs", "", "kg"},
    WrongUnit{"kilogram", "", "kg"},
    WrongUnit{"kilograms", "", "kg"},
    WrongUnit{"tonne", "", "t"},
    WrongUnit{"tonnes", "", "t"},
    WrongUnit{"sec", "", "s"},
    WrongUnit{"secs", "", "s"},
    WrongUnit{"second", "", "s"},
    WrongUnit{"seconds", "", "s"},
    WrongUnit{"minute", "", "min"},
    WrongUnit{"minutes", "", "min"},
    WrongUnit{"mins", "", "min"},
    WrongUnit{"hr", "", "h"},
    WrongUnit{"hrs", "", "h"},
    WrongUnit{"hour", "", "h"},
    WrongUnit{"hours", "", "h"},
    WrongUnit{"days", "", "day"},
    WrongUnit{"d", "", "day"},
    WrongUnit{"year", "'year' is no unit of the language: years differ", "365.25*24 h"},
    WrongUnit{"years", "'years' is no unit of the language: years differ", "365.25*24 h"},
    WrongUnit{"Nm", "", "N*m"},
    WrongUnit{"kNm", "", "kN*m"},
    WrongUnit{"mNm", "", "mN*m"},
    WrongUnit{"Ns", "", "N*s"},
    WrongUnit{"Nms", "", "N*m*s"},
    WrongUnit{"newton", "", "N"},
    WrongUnit{"newtons", "", "N"},
    WrongUnit{"joule", "", "J"},
    WrongUnit{"joules", "", "J"},
    WrongUnit{"watt", "", "W"},
    WrongUnit{"watts", "", "W"},
    WrongUnit{"degree", "", "deg"},
    WrongUnit{"degrees", "", "deg"},
    WrongUnit{"degs", "", "deg"},
    WrongUnit{"\xc2\xb0", "", "deg"},
    WrongUnit{"radian", "", "rad"},
    WrongUnit{"radians", "", "rad"},
    WrongUnit{"rads", "", "rad"},
    WrongUnit{"revs", "", "rev"},
    WrongUnit{"revolution", "", "rev"},
    WrongUnit{"revolutions", "", "rev"},
    WrongUnit{"turns", "", "turn"},
    WrongUnit{"r/min", "", "rpm"},
    WrongUnit{"rps", "", "rev/s"},
    WrongUnit{"percent", "", "%"},
    WrongUnit{"\"", "", "in"},
    WrongUnit{"''", "", "in"},
    WrongUnit{"'", "", "ft"},
};

}  // namespace

std::span<const NamedUnit> unit_table() { return table; }

const NamedUnit* find_unit(std::string_view name) {
  const auto found = std::find_if(table.begin(), table.end(), [&](const NamedUnit& unit) { return unit.name == name; });
  return found == table.end() ? nullptr : &*found;
}

const WrongUnit* find_wrong_unit(std::string_view word) {
  const auto find = [](std::string_view wanted) {
    const auto found = std::find_if(wrong_words.begin(), wrong_words.end(),
                                    [&](const WrongUnit& wrong) { return wrong.word == wanted; });
    return found == wrong_words.end() ? nullptr : &*found;
  };
  if (const WrongUnit* found = find(word)) return found;
  std::string lower(word);
  for (char& c : lower) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return find(lower);
}

}  // namespace poinsot::problem
