#include "problem/language/units.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>

#include "problem/language/expression.h"
#include "problem/language/failure.h"

namespace poinsot::problem {
namespace units_test {

constexpr double pi = std::numbers::pi;

std::string unit_failure(const std::string& text) {
  try {
    parse_unit(text);
  } catch (const UnitError& error) {
    EXPECT_LE(error.offset, text.size());
    return error.what();
  }
  return "no error";
}

struct Known {
  const char* text;
  double factor;
  Dimension dimension;
};

TEST(Units, SingleUnitsHaveTheirDefinedFactors) {
  using namespace dimensions;
  const Known table[] = {
      {"m", 1, length},
      {"km", 1000, length},
      {"dm", 0.1, length},
      {"cm", 0.01, length},
      {"mm", 0.001, length},
      {"um", 1e-6, length},
      {"ft", 0.3048, length},
      {"in", 0.0254, length},
      {"yd", 0.9144, length},
      {"mi", 1609.344, length},
      {"kg", 1, mass},
      {"g", 1e-3, mass},
      {"mg", 1e-6, mass},
      {"Mg", 1000, mass},
      {"t", 1000, mass},
      {"lbm", 0.45359237, mass},
      {"ozm", 0.028349523125, mass},
      {"slug", 4.4482216152605 / 0.3048, mass},
      {"s", 1, dimensions::time},
      {"ms", 1e-3, dimensions::time},
      {"us", 1e-6, dimensions::time},
      {"min", 60, dimensions::time},
      {"h", 3600, dimensions::time},
      {"day", 86400, dimensions::time},
      {"N", 1, force},
      {"kN", 1e3, force},
      {"MN", 1e6, force},
      {"mN", 1e-3, force},
      {"lb", 4.4482216152605, force},
      {"oz", 0.27801385095378125, force},
      {"kip", 4448.2216152605, force},
      {"Pa", 1, pressure},
      {"psi", 6894.757293168361, pressure},
      {"J", 1, energy},
      {"kJ", 1e3, energy},
      {"W", 1, dimensions::power},
      {"hp", 745.6998715822702, dimensions::power},
      {"rad", 1, dimensions::angle},
      {"mrad", 1e-3, dimensions::angle},
      {"deg", pi / 180, dimensions::angle},
      {"rev", 2 * pi, dimensions::angle},
      {"turn", 2 * pi, dimensions::angle},
      {"rpm", pi / 30, angular_velocity},
      {"mph", 0.44704, velocity},
      {"knot", 1852.0 / 3600, velocity},
      {"%", 0.01, none},
      {"slinch", 4.4482216152605 / 0.0254, mass},
  };
  for (const Known& known : table) {
    const Unit unit = parse_unit(known.text);
    EXPECT_DOUBLE_EQ(unit.factor, known.factor) << known.text;
    EXPECT_EQ(unit.dimension, known.dimension) << known.text;
    EXPECT_EQ(unit.text, known.text);
  }
}

TEST(Units, NamesOfTheTableAreDifferentAndAllReadable) {
  std::set<std::string> names;
  for (const std::string& name : unit_names()) {
    EXPECT_TRUE(names.insert(name).second) << name;
    EXPECT_EQ(parse_unit(name).text, name);
    EXPECT_TRUE(is_unit_name(name));
    EXPECT_EQ(wrong_unit_message(name), "") << name;
  }
}

TEST(Units, ComposedUnits) {
  const Unit momentum = parse_unit("kg*m^2/s");
  EXPECT_EQ(momentum.factor, 1);
  EXPECT_EQ(momentum.dimension, dimensions::angular_momentum);
  EXPECT_DOUBLE_EQ(parse_unit("lb*ft*s").factor, 4.4482216152605 * 0.3048);
  EXPECT_EQ(parse_unit("lb*ft*s").dimension, dimensions::angular_momentum);
  EXPECT_EQ(parse_unit("1/s").dimension, dimensions::frequency);
  EXPECT_EQ(parse_unit("oz/ft").dimension, dimensions::stiffness);
  EXPECT_DOUBLE_EQ(parse_unit("rev/h").factor, 2 * pi / 3600);
  EXPECT_EQ(parse_unit("N*m/rad").dimension, Dimension::of(2, 1, -2, -1));
  EXPECT_DOUBLE_EQ(parse_unit("g/cm^3").factor, 1000);
  EXPECT_EQ(parse_unit("m^-2").dimension, Dimension::of(-2, 0, 0));
  EXPECT_EQ(parse_unit("m^(1/2)").dimension, (Dimension{6, 0, 0, 0}));
  EXPECT_EQ(parse_unit("1").dimension, dimensions::none);
}

TEST(Units, DivisionBindsOneFactorFromLeftToRight) {
  EXPECT_EQ(parse_unit("kg/m*s").dimension, Dimension::of(-1, 1, 1)) << "a/b*c = (a/b)*c";
  EXPECT_EQ(parse_unit("kg/m/s").dimension, Dimension::of(-1, 1, -1));
  EXPECT_EQ(parse_unit("km/h").factor, 1000.0 / 3600);
}

TEST(Units, ProductsOfUnitsAreUnitsOfProducts) {
  for (const std::string& a : unit_names()) {
    for (const std::string& b : unit_names()) {
      const Unit ua = parse_unit(a), ub = parse_unit(b);
      const Unit product = parse_unit(a + "*" + b), quotient = parse_unit(a + "/" + b);
      ASSERT_DOUBLE_EQ(product.factor, ua.factor * ub.factor) << a << " " << b;
      ASSERT_EQ(product.dimension, ua.dimension * ub.dimension);
      ASSERT_DOUBLE_EQ(quotient.factor, ua.factor / ub.factor);
      ASSERT_EQ(quotient.dimension, ua.dimension / ub.dimension);
    }
  }
}

TEST(Units, WrongSpellingsAreRepaired) {
  const std::pair<const char*, const char*> table[] = {
      {"lbs", "'lbs' is not how the unit is written (write 'lb')"},
      {"lbf", "'lbf' is not how the unit is written (write 'lb')"},
      {"lbf*ft", "'lbf' is not how the unit is written (write 'lb*ft')"},
      {"sec", "'sec' is not how the unit is written (write 's')"},
      {"ft/sec^2", "'sec' is not how the unit is written (write 'ft/s^2')"},
      {"Nm", "'Nm' is not how the unit is written (write 'N*m')"},
      {"degrees", "'degrees' is not how the unit is written (write 'deg')"},
      {"\xc2\xb0", "'\xc2\xb0' is not how the unit is written (write 'deg')"},
      {"RPM", "'RPM' is not a unit (did you mean 'rpm'?)"},
      {"\"", "'\"' is not how the unit is written (write 'in')"},
      {"pounds", "'pounds' is not how the unit is written (write 'lb' (a force) or 'lbm' (a mass))"},
      {"m2", "'m2' is not a unit (write 'm^2')"},
      {"kg.m2", "'.' does not belong into a unit (write 'kg*m^2')"},
      {"kg-m2", "'-' does not belong into a unit (write 'kg*m^2')"},
      {"ft-lb", "'-' does not belong into a unit (write 'ft*lb')"},
      {"N\xc2\xb7m", "'\xc2\xb7' does not belong into a unit (write 'N*m')"},
      {"m/s\xc2\xb2", "'\xc2\xb2' does not belong into a unit (write 'm/s^2')"},
      {"m**2", "a unit is missing before '*' (write 'm^2')"},
      {"kgf", "'kgf', the kilogram-force, is no unit of the language (write '9.80665 N')"},
      {"Hz", "'Hz' is ambiguous: a hertz may count turns or radians (write 'rev/s' or 'rad/s')"},
      {"ton", "'ton' is ambiguous: there are three of them (write '2000 lb', '2000 lbm' or '1 Mg')"},
  };
  for (const auto& [text, message] : table) EXPECT_EQ(unit_failure(text), message) << text;
}

TEST(Units, MalformedUnitsSayWhatIsWrong) {
  const std::pair<const char*, const char*> table[] = {
      {"", "a unit is missing (write one such as m, kg*m^2/s or 1/s)"},
      {"foo", "'foo' is not a unit"},
      {"kgg", "'kgg' is not a unit (did you mean 'kg'?)"},
      {"kg*", "a unit is missing after '*' (complete the unit)"},
      {"/s", "a unit is missing before '/' (write it like N*m or 1/s)"},
      {"kg/(m*s)", "a unit has no parentheses (kg/(m*s) is written kg/m/s)"},
      {"N m", "a blank stands within a unit (write it without blanks, as in N*m)"},
      {"2/s", "a number stands within a unit (put the number before the unit)"},
      {"m^0", "an exponent of a unit must be a whole number up to 100, not 0 (write it like m^2, s^-1 or m^(1/2))"},
      {"m^101", "an exponent of a unit must be a whole number up to 100, not 0 (write it like m^2, s^-1 or m^(1/2))"},
      {"m^1.5", "an exponent of a unit must be a whole number up to 100, not 0 (write it like m^2, s^-1 or m^(1/2))"},
      {"m^(1/5)",
       "this exponent is not possible for a unit (exponents go by halves, thirds, quarters, sixths or twelfths)"},
      {"^2", "an exponent stands without a unit before it (write it like m^2)"},
  };
  for (const auto& [text, message] : table) EXPECT_EQ(unit_failure(text), message) << text;
  EXPECT_EQ(unit_failure(std::string(5000, 'm')), "this unit is too long (write at most 100 letters)");
  EXPECT_EQ(unit_failure("GPa^9*GPa^9*GPa^9*GPa^9*GPa^9"),
            "the exponents of this unit are beyond all measure (use fewer factors)");
}

TEST(Units, InAnEntryTheErrorHasItsPlace) {
  const Entry root = read_tree("unit: lb*fot\nlist: [1]\n", "f");
  EXPECT_EQ(failure_of([&] { parse_unit(*root.find("unit"), "f"); }),
            "f:1:10: error: 'fot' is not a unit (did you mean 'ft'?)");
  EXPECT_EQ(failure_of([&] { parse_unit(*root.find("list"), "f"); }),
            "f:2:7: error: expected a unit, not a list (write one such as m, kg*m^2/s or rpm)");
}

TEST(SiUnit, IsCoherentAndNamed) {
  using namespace dimensions;
  EXPECT_EQ(format_unit(force), "N");
  EXPECT_EQ(format_unit(moment), "N*m");
  EXPECT_EQ(format_unit(energy, true), "J");
  EXPECT_EQ(format_unit(angular_momentum), "kg*m^2/s");
  EXPECT_EQ(format_unit(angular_velocity), "rad/s");
  EXPECT_EQ(format_unit(none), "");
  EXPECT_EQ(format_unit(moment / dimensions::angle), "N*m/rad");
  EXPECT_EQ(format_unit(velocity * dimensions::angle), "m/s") << "the radian idles";
  EXPECT_EQ(format_unit(*problem::power(length, 1, 2)), "m^(1/2)");
  EXPECT_EQ(format_unit(none / length), "1/m");
  for (int l = -2; l <= 3; ++l) {
    for (int m = -1; m <= 1; ++m) {
      for (int t = -3; t <= 2; ++t) {
        const Dimension d = Dimension::of(l, m, t);
        const Unit unit = si_unit(d);
        EXPECT_EQ(unit.factor, 1) << unit.text;
        if (d == none) continue;
        EXPECT_EQ(parse_unit(unit.text).dimension, d) << unit.text;
        EXPECT_EQ(parse_unit(unit.text).factor, 1) << unit.text;
      }
    }
  }
}

UnitHabits habits_of(std::initializer_list<const char*> units) {
  UnitHabits habits;
  for (const char* unit : units) habits.note(parse_unit(unit));
  return habits;
}

TEST(UnitHabits, TheMostUsedStatedUnitWins) {
  const UnitHabits habits = habits_of({"mm", "m", "mm", "kg", "rpm"});
  EXPECT_EQ(habits.unit_for(dimensions::length).text, "mm");
  EXPECT_EQ(habits.unit_for(dimensions::mass).text, "kg");
  EXPECT_EQ(habits.unit_for(dimensions::time / dimensions::angle).text, "s");  // a period is 2 pi/omega
  EXPECT_EQ(habits.unit_for(dimensions::length / dimensions::angle).text, "m/rad");
  EXPECT_EQ(habits_of({"m", "mm"}).unit_for(dimensions::length).text, "m") << "the first of equally many";
}

TEST(UnitHabits, SiWhereNothingIsStated) {
  const UnitHabits habits = habits_of({"kg", "mm"});
  EXPECT_FALSE(habits.customary());
  EXPECT_EQ(habits.unit_for(dimensions::force).text, "N");
  EXPECT_EQ(habits.unit_for(dimensions::moment).text, "N*m");
  EXPECT_EQ(habits.unit_for(dimensions::energy, true).text, "J");
  EXPECT_EQ(habits.unit_for(dimensions::angular_momentum).text, "kg*m^2/s");
  EXPECT_EQ(habits.unit_for(dimensions::velocity).text, "m/s");
  EXPECT_EQ(habits.unit_for(dimensions::none).text, "");
}

TEST(UnitHabits, CustomaryWhereItWasUsed) {
  const UnitHabits habits = habits_of({"ft/s^2", "in"});
  EXPECT_TRUE(habits.customary());
  EXPECT_EQ(habits.unit_for(dimensions::length).text, "in");
  EXPECT_EQ(habits.unit_for(dimensions::force).text, "lb");
  EXPECT_EQ(habits.unit_for(dimensions::mass).text, "slug");
  EXPECT_EQ(habits.unit_for(dimensions::moment).text, "lb*ft");
  EXPECT_EQ(habits.unit_for(dimensions::energy, true).text, "ft*lb");
  EXPECT_EQ(habits.unit_for(dimensions::power).text, "ft*lb/s");
  EXPECT_EQ(habits.unit_for(dimensions::momentum).text, "lb*s");
  EXPECT_EQ(habits.unit_for(dimensions::angular_momentum).text, "lb*ft*s");
  EXPECT_EQ(habits.unit_for(dimensions::moment_of_inertia).text, "slug*ft^2");
  EXPECT_EQ(habits.unit_for(dimensions::velocity).text, "ft/s");
  EXPECT_EQ(habits.unit_for(dimensions::angular_velocity).text, "rad/s");
  EXPECT_EQ(habits.unit_for(dimensions::frequency).text, "1/s");
  EXPECT_EQ(habits.unit_for(dimensions::time).text, "s");
}

TEST(UnitHabits, ComposedUnitsAreWhatTheirTextSays) {
  const UnitHabits systems[] = {habits_of({"lb"}), habits_of({"kg"})};
  for (const UnitHabits& habits : systems) {
    for (int l = -2; l <= 3; ++l) {
      for (int m = -1; m <= 2; ++m) {
        for (int t = -3; t <= 2; ++t) {
          const Unit unit = habits.unit_for(Dimension::of(l, m, t));
          if (unit.text.empty()) continue;
          const Unit read = parse_unit(unit.text);
          EXPECT_EQ(read.dimension, Dimension::of(l, m, t)) << unit.text;
          EXPECT_NEAR(read.factor / unit.factor, 1, 1e-14) << unit.text;
        }
      }
    }
  }
  // Also where the exponents grow large.
  for (const char* power : {"W^4", "J^9/s^8", "N^(35/12)"}) {
    const Dimension dimension = parse_unit(power).dimension;
    EXPECT_EQ(parse_unit(si_unit(dimension, false).text).dimension, dimension) << power;
  }
}

TEST(UnitHabits, Angles) {
  EXPECT_EQ(habits_of({"rev"}).unit_for(dimensions::angle).text, "rad");
  EXPECT_EQ(habits_of({"rad", "rad", "deg"}).unit_for(dimensions::angle).text, "deg");
  EXPECT_EQ(habits_of({"rpm"}).unit_for(dimensions::angular_velocity).text, "rpm");
  EXPECT_EQ(habits_of({"rpm", "rpm", "rad/s"}).unit_for(dimensions::angular_velocity).text, "rad/s");
  EXPECT_EQ(habits_of({"kg"}).unit_for(dimensions::angular_acceleration).text, "rad/s^2");
}

TEST(UnitHabits, MomentsAndEnergiesKeepTheirUnitsApart) {
  const UnitHabits habits = habits_of({"kN*m", "kN*m", "kJ"});
  EXPECT_EQ(habits.unit_for(dimensions::moment).text, "kN*m");
  EXPECT_EQ(habits.unit_for(dimensions::energy, true).text, "kJ");
}

TEST(UnitHabits, AnIdleRadianDoesNotShow) {
  const UnitHabits habits = habits_of({"km/h"});
  EXPECT_EQ(habits.unit_for(dimensions::velocity * dimensions::angle).text, "km/h");
}

TEST(UnitHabits, ReadsAllLiteralsOfAnExpression) {
  UnitHabits habits;
  habits.note(parse_expression("2 s .. 4 s by 1 s", "f"));
  EXPECT_EQ(habits.unit_for(dimensions::time).text, "s");
  EXPECT_FALSE(habits.customary());
  habits.note(parse_expression(
      "[-(5 deg) < a^2, (3 slug)*f(b along 4 mph) @ 3 s, f(7 yd).x, A->f(5 psi), A of f(1 kip)]", "f"));
  EXPECT_TRUE(habits.customary());
  EXPECT_EQ(habits.unit_for(dimensions::angle).text, "deg");
  EXPECT_EQ(habits.unit_for(dimensions::mass).text, "slug");
  EXPECT_EQ(habits.unit_for(dimensions::velocity).text, "mph");
  EXPECT_EQ(habits.unit_for(dimensions::pressure).text, "psi");
  EXPECT_EQ(habits.unit_for(dimensions::force).text, "kip");
}

}  // namespace units_test
}  // namespace poinsot::problem
