#include "problem/language/evaluate.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "problem/language/evaluate_support.h"
#include "problem/language/failure.h"

namespace poinsot::problem {
namespace evaluate_test {

constexpr double pi = std::numbers::pi;

// A few names of known value, and one function `double(v)` of the scope's own.
template <class Scalar>
class TestScope : public Scope<Scalar> {
 public:
  using Result = Value<Scalar>;

  explicit TestScope(Scalar t = Scalar(2)) : t_(t) {}

  Result name(const Name& name, const Mark& mark, const Evaluator<Scalar>& evaluator) override {
    using namespace dimensions;
    if (name.name == "F") return Result::of_number(Scalar(10), force);
    if (name.name == "r") return Result::of_number(Scalar(3), length);
    if (name.name == "m") return Result::of_number(Scalar(2), mass);
    if (name.name == "t") return Result::of_number(t_, none);
    if (name.name == "T") return Result::of_number(t_, dimensions::time);
    if (name.name == "theta") return Result::of_number(Scalar(0.5), dimensions::angle);
    if (name.name == "w") return Result::of_number(Scalar(4), angular_velocity);
    if (name.name == "v") return Result::of_number(Scalar(12), velocity);
    if (name.name == "n") return Result::of_number(Scalar(7), none, true);
    if (name.name == "zero") return Result::of_number(Scalar(0), none, true);
    if (name.name == "x") return Result::of_vector(Vector3<Scalar>::unit(0), none);
    if (name.name == "A") return Result::of_vector({Scalar(1), Scalar(2), Scalar(3)}, length);
    if (name.name == "B") return Result::of_vector({Scalar(4), Scalar(6), Scalar(3)}, length);
    if (name.name == "yes") return Result::of_truth(true);
    evaluator.fail(mark, "unknown name '" + name.name + "'");
  }
  Result call(const Call& call, const Mark& mark, const Evaluator<Scalar>& evaluator) override {
    if (call.function == "double") {
      Result value = evaluator(call.arguments.at(0).value);
      value.number = value.number + value.number;
      return value;
    }
    if (call.function == "min" && call.pattern().empty()) return Result::of_text("the least of a motion");
    evaluator.unknown_call(call, mark, {"velocity", "double"});
  }

 private:
  Scalar t_;
};

Value<double> value_of(const std::string& text) {
  TestScope<double> scope;
  return evaluate<double>(parse_expression(text, "f"), scope, "f");
}

std::string failure(const std::string& text) {
  return failure_of([&] { value_of(text); });
}

// The value is a number, near `expected` to rounding, of the dimension.
void expect_number(const std::string& text, double expected, const Dimension& dimension) {
  const Value<double> value = value_of(text);
  ASSERT_TRUE(value.is_number()) << text;
  EXPECT_DOUBLE_EQ(value.number, expected) << text;
  EXPECT_EQ(value.dimension, dimension) << text << ": " << base_units(value.dimension);
}

void expect_vector(const std::string& text, const Vector3<double>& expected, const Dimension& dimension) {
  const Value<double> value = value_of(text);
  ASSERT_TRUE(value.is_vector()) << text;
  for (std::size_t i = 0; i < 3; ++i) EXPECT_DOUBLE_EQ(value.vector[i], expected[i]) << text << " component " << i;
  EXPECT_EQ(value.dimension, dimension) << text << ": " << base_units(value.dimension);
}

TEST(Evaluate, ArithmeticWithUnits) {
  using namespace dimensions;
  expect_number("12.5 lb", 12.5 * 4.4482216152605, force);
  expect_number("5/8 oz/ft", 0.625 * 4.4482216152605 / 16 / 0.3048, stiffness);
  expect_number("1/23.93 rev/h", 2 * pi / 23.93 / 3600, angular_velocity);
  expect_number("(1 rev)/(5 s)", 2 * pi / 5, angular_velocity);
  expect_number("365.24*24 h", 365.24 * 24 * 3600, dimensions::time);
  expect_number("F*r + 2 N*m", 32, moment);
  expect_number("1 m + 20 cm - 3 mm", 1.197, length);
  expect_number("m*r^2/2", 9, moment_of_inertia);
  expect_number("-r^2", -9, area);
  expect_number("sqrt(r^2 + 16 m^2)", 5, length);
  expect_number("(4 m^2)^0.5", 2, length);
  expect_number("(8 m^3)^(1/3)", 2, length);
  expect_number("2^3^2", 512, none);
  expect_number("2^-2", 0.25, none);
  expect_number("(-2)^3", -8, none);
  expect_number("0^0", 1, none);
  expect_number("7/2 - 3.5", 0, none);
  expect_number("+F", 10, force);
  expect_number("5 %", 0.05, none);
}

TEST(Evaluate, ABareZeroFitsEveryDimension) {
  using namespace dimensions;
  expect_number("F + 0", 10, force);
  expect_number("0 - F", -10, force);
  expect_number("F - zero", 10, force);
  expect_vector("A + 0", {1, 2, 3}, length);
  expect_vector("0 - A", {-1, -2, -3}, length);
  expect_vector("[0, 0, 3 m]", {0, 0, 3}, length);
  EXPECT_TRUE(value_of("F > 0").truth);
  EXPECT_EQ(failure("F + 0 m"), "f:1:3: error: a length cannot be added to a force")
      << "a zero with a unit is not bare";
}

TEST(Evaluate, BareNumbersAreThoseWithoutUnitAndWhatIsBuiltFromThem) {
  for (const char* text :
       {"2", "2/3 + 1", "-(2*3)^2", "sqrt(2)", "abs(-1)", "n", "[1, 2, 3]", "[1, 2, 3].x", "min(1 with 2)"}) {
    EXPECT_TRUE(value_of(text).bare) << text;
  }
  for (const char* text : {"pi", "2*pi", "t", "2 rad", "2 m/(1 m)", "sin(theta)", "5 %", "[t, 1, 2]", "t + 1"}) {
    EXPECT_FALSE(value_of(text).bare) << text;
  }
}

TEST(Evaluate, DifferentKindsAreNotAdded) {
  const std::pair<const char*, const char*> table[] = {
      {"F + r", "f:1:3: error: a length cannot be added to a force"},
      {"r - F", "f:1:3: error: a force cannot be subtracted from a length"},
      {"10 lb + 3 ft", "f:1:7: error: a length cannot be added to a force"},
      {"r + F*r/r", "f:1:3: error: a force cannot be added to a length"},
      {"F + 3",
       "f:1:3: error: the number 3 without unit cannot be added to a force (a number without unit is a pure number; a "
       "unit stands "
       "after it and a blank)"},
      {"r < F", "f:1:3: error: a force cannot be compared with a length"},
      {"0 m < r < F", "f:1:5: error: a force cannot be compared with a length"},
      {"A + [1 N, 0, 0]", "f:1:3: error: a force cannot be added to a length"},
      {"A + r", "f:1:3: error: a number cannot be added to a vector"},
      {"r - A", "f:1:3: error: a vector cannot be subtracted from a number"},
      {"min(r with F)", "f:1:12: error: min takes quantities of one kind, not a length and a force"},
      {"atan2(r to F)", "f:1:12: error: atan2 takes quantities of one kind, not a length and a force"},
      {"r*F^5/(1 s) + r", "f:1:13: error: a length cannot be added to a quantity in kg^5*m^6/s^11"},
  };
  for (const auto& [text, message] : table) EXPECT_EQ(failure(text), message) << text;
}

TEST(Evaluate, AnglesAreSoft) {
  using namespace dimensions;
  expect_number("w*r - v", 0, velocity);
  expect_number("v + w*r", 24, velocity);
  expect_number("w + 2*pi/(1 s)", 4 + 2 * pi, angular_velocity);
  expect_number("pi/2 - theta", pi / 2 - 0.5, dimensions::angle);
  expect_number("1 - theta^2/2", 0.875, none);
  expect_number("w*r/v - 1", 0, none);
  expect_number("theta + asin(0.5)", 0.5 + pi / 6, dimensions::angle);
  expect_number("90 deg - theta", pi / 2 - 0.5, dimensions::angle);
  EXPECT_TRUE(value_of("w*r == v").truth);
}

TEST(Evaluate, ANumberWithoutUnitIsNoAngle) {
  const std::pair<const char*, const char*> table[] = {
      {"cos(25)", "f:1:5: error: the unit of the angle is missing in cos(25) (write 25 deg or 25 rad)"},
      {"2*sin(45/2)", "f:1:7: error: the unit of the angle is missing in sin(45/2) (give it the unit deg or rad)"},
      {"tan(n)", "f:1:5: error: the unit of the angle is missing in tan(n) (give it the unit deg or rad)"},
      {"90 - theta", "f:1:1: error: a number without unit meets an angle (write 90 deg or 90 rad)"},
      {"theta < 90", "f:1:9: error: a number without unit meets an angle (write 90 deg or 90 rad)"},
      {"-theta + 2*45", "f:1:10: error: a number without unit meets an angle (give it the unit deg or rad)"},
      {"sin(r)", "f:1:5: error: sin takes an angle, not a length"},
  };
  for (const auto& [text, message] : table) EXPECT_EQ(failure(text), message) << text;
  expect_number("cos(0)", 1, dimensions::none);
  expect_number("sin(pi/6)", 0.5, dimensions::none);
  expect_number("cos(60 deg)", 0.5000000000000001, dimensions::none);
  expect_number("sin(t)", std::sin(2), dimensions::none);
}

TEST(Evaluate, FunctionsOfNumbers) {
  using namespace dimensions;
  expect_number("sqrt(9 m^2)", 3, length);
  expect_number("sqrt(r)", std::sqrt(3), Dimension{6, 0, 0, 0});
  expect_number("abs(-3 N)", 3, force);
  expect_number("tan(45 deg)", std::tan(pi / 4), none);
  expect_number("asin(1/2)", pi / 6, dimensions::angle);
  expect_number("acos(-1)", pi, dimensions::angle);
  expect_number("atan(1)", pi / 4, dimensions::angle);
  expect_number("exp(2)", std::exp(2), none);
  expect_number("ln(2)", std::log(2), none);
  expect_number("atan2(-1 m to 0)", -pi / 2, dimensions::angle);
  expect_number("atan2(1 m to -1 m)", 3 * pi / 4, dimensions::angle);
  expect_number("min(1 ft with 1 m)", 0.3048, length);
  expect_number("max(1 ft with 1 m)", 1, length);
  expect_number("max([1 m, 0, 5 cm, 7 mm])", 1, length);
  expect_number("min([-1 m, 0, 5 cm])", -1, length);
  expect_number("asin(1 + 1e-15)", pi / 2, dimensions::angle);
}

TEST(Evaluate, Vectors) {
  using namespace dimensions;
  expect_vector("A->B", {3, 4, 0}, length);
  expect_vector("2*A", {2, 4, 6}, length);
  expect_vector("A*F", {10, 20, 30}, moment);
  expect_vector("A/(2 s)", {0.5, 1, 1.5}, velocity);
  expect_vector("-A + B - A", {2, 2, -3}, length);
  expect_vector("A - r*[1, 0, 1]", {-2, 2, 0}, length);
  expect_vector("cross(x with A)", {0, -3, 2}, length);
  expect_number("dot(A with B)", 25, area);
  expect_number("norm(A->B)", 5, length);
  expect_vector("unit(A->B)", {0.6, 0.8, 0}, none);
  expect_vector("direction(B - A)", {0.6, 0.8, 0}, none);
  expect_number("component(A along 7*x)", 1, length);
  expect_number("angle(x to [0, 1, 0])", pi / 2, dimensions::angle);
  expect_number("angle(x to [-1, 0, 0])", pi, dimensions::angle);
  expect_number("acute_angle(x to [-1, 0, 0])", 0, dimensions::angle);
  expect_number("A.y", 2, length);
  expect_number("(A->B).x", 3, length);
  expect_number("[1 N, 2 N, 3 N].z", 3, force);
  EXPECT_TRUE(value_of("A == A").truth);
  EXPECT_FALSE(value_of("A == B").truth);
}

TEST(Evaluate, AnglesOfVectorsKeepTheirDigits) {
  // 1e-9 rad apart: the arc cosine would give 0 or 2e-8.
  EXPECT_NEAR(value_of("angle([1, 0, 0] to [1, 1e-9, 0])").number, 1e-9, 1e-24);
  // Of any size.
  for (const std::string size : {"1e200", "1e-200", "5e-324"})
    for (const std::string other : {"1", "1e300", "1e-300"})
      expect_number("angle([" + size + ", 0, 0] to [" + other + ", " + other + ", 0])", pi / 4, dimensions::angle);
}

TEST(Evaluate, NormsNeitherOverflowNorVanish) {
  EXPECT_DOUBLE_EQ(value_of("norm([3e200, 4e200, 0])").number, 5e200);
  EXPECT_DOUBLE_EQ(value_of("norm([3e-200, 4e-200, 0])").number, 5e-200);
  EXPECT_DOUBLE_EQ(value_of("unit([0, 1e-300, 0])").vector.y, 1);
  EXPECT_EQ(value_of("norm([0, 0, 0])").number, 0);
}

TEST(Evaluate, ListsOfThreeNumbersOfOneKindAreVectors) {
  EXPECT_TRUE(value_of("[1 m, 2 ft, 0]").is_vector());
  EXPECT_TRUE(value_of("[0, 0, 0]").is_vector());
  EXPECT_EQ(value_of("[0, w, 2 rad/s]").dimension, dimensions::angular_velocity);
  for (const char* text :
       {"[1 m, 2 N, 0]", "[1 m, 2, 0]", "[1, 2]", "[1, 2, 3, 4]", "[any, 1, 2]", "[A, A, A]", "[]", "[yes, 1, 2]"}) {
    EXPECT_TRUE(value_of(text).is_list()) << text;
  }
  EXPECT_TRUE(value_of("[any, 1, 2]").items[0].is_any());
}

TEST(Evaluate, Comparisons) {
  EXPECT_TRUE(value_of("-45 deg < theta < 45 deg").truth);
  EXPECT_FALSE(value_of("-45 deg < theta < 20 deg").truth);
  EXPECT_FALSE(value_of("1 < 0 < 2").truth);
  EXPECT_TRUE(value_of("1 ft <= 12.0 in").truth);
  EXPECT_TRUE(value_of("2 >= 2 > 1 == 1").truth);
  EXPECT_FALSE(value_of("1 m == 2 m").truth);
}

TEST(Evaluate, WhatHasNoValueIsADomainError) {
  const std::pair<const char*, const char*> table[] = {
      {"F/(r - 3 m)", "f:1:2: error: division by zero"},
      {"A/zero", "f:1:2: error: division by zero"},
      {"0^-1", "f:1:2: error: division by zero: zero to the power -1"},
      {"sqrt(-4 m^2)", "f:1:1: error: sqrt of the negative number -4"},
      {"1 + (-8)^(1/3)", "f:1:9: error: the negative number -8 has no power 0.333333"},
      {"asin(1.5)", "f:1:1: error: asin of 1.5 does not exist: the argument must be between -1 and 1"},
      {"acos(-2)", "f:1:1: error: acos of -2 does not exist: the argument must be between -1 and 1"},
      {"1e300*1e300", "f:1:6: error: the result is beyond the range of numbers or undefined"},
      {"10^400", "f:1:3: error: the result is beyond the range of numbers or undefined"},
      {"1e300 + A.x/(1e-100 m)*1e300", "f:1:23: error: the result is beyond the range of numbers or undefined"},
      {"atan2(0 to 0)", "f:1:1: error: atan2 of two zeros has no direction"},
      {"ln(-2)", "f:1:1: error: ln of -2 does not exist: the argument must be positive"},
      {"unit([0, 0, 0])", "f:1:6: error: the zero vector has no direction"},
      {"component(A along B - B)", "f:1:19: error: the zero vector has no direction"},
      {"angle(x to A - A)", "f:1:12: error: the zero vector has no direction"},
  };
  for (const auto& [text, message] : table) {
    EXPECT_EQ(failure(text), message) << text;
    EXPECT_THROW(value_of(text), DomainError) << text;
  }
}

TEST(Evaluate, WhatCanNeverBeRightIsNoDomainError) {
  const std::pair<const char*, const char*> table[] = {
      {"A*B", "f:1:2: error: two vectors have two products (write dot(a with b) or cross(a with b))"},
      {"r/A", "f:1:2: error: nothing can be divided by a vector (divide by its magnitude, norm(v))"},
      {"A^2", "f:1:2: error: a vector has no powers (write dot(v with v) or norm(v)^2)"},
      {"2^A", "f:1:2: error: an exponent must be a number, not a vector"},
      {"2^r", "f:1:2: error: an exponent must be a pure number, not a length"},
      {"r^0.3", "f:1:2: error: a length to the power 0.3 is no quantity that has a unit"},
      {"sqrt((2 m)^(1/12))", "f:1:7: error: the root of a quantity in m^(1/12) is no quantity that has a unit"},
      {"any + 1", "f:1:5: error: nothing can be added to 'any'"},
      {"1 - any", "f:1:3: error: nothing can be subtracted from or by 'any'"},
      {"2*yes", "f:1:2: error: there is no product with a truth value"},
      {"-[1, 2]", "f:1:1: error: a sign cannot stand before a list"},
      {"[1, 2] < 3", "f:1:8: error: a list cannot be compared with '<'"},
      {"A < B", "f:1:3: error: a vector cannot be compared with '<' (compare components, v.x, or magnitudes, norm(v))"},
      {"abs(A)", "f:1:5: error: abs takes a number, not a vector (the magnitude of a vector is norm(v))"},
      {"asin(r)", "f:1:6: error: asin takes a pure number, not a length"},
      {"norm(r)", "f:1:6: error: norm takes a vector, not a number"},
      {"cross(A with [1 m, 1 N, 0])",
       "f:1:14: error: cross takes a vector, and the components of this list are not of one kind"},
      {"A.w", "f:1:2: error: a vector has no component 'w' (its components are .x, .y and .z)"},
      {"A.xy", "f:1:2: error: a vector has no component 'xy' (its components are .x, .y and .z)"},
      {"r.x", "f:1:2: error: a number has no component 'x' (a vector has .x, .y and .z)"},
      {"0 s .. 1 s by 0.1 s", "f:1:5: error: a range is no value (it stands under 'over:' of a table)"},
      {"F @ start", "f:1:3: error: there are no instants here, so '@' has no meaning"},
      {"A of plate", "f:1:3: error: nothing rides on bodies here, so 'of' has no meaning"},
      {"r->A",
       "f:1:1: error: expected a length in three components, a vector, not a number (give 'r' three components where "
       "it is stated, or write [0, 0, r] for one that has this "
       "size)"},
      {"crss(A with B)", "f:1:1: error: there is no function 'crss' (did you mean 'cross'?)"},
      {"velocty(A)", "f:1:1: error: there is no function 'velocty' (did you mean 'velocity'?)"},
      {"cross(A to B)", "f:1:1: error: 'cross' is not called like this (write cross(u with v))"},
      {"sin()", "f:1:1: error: 'sin' is not called like this (write sin(theta))"},
      {"q", "f:1:1: error: unknown name 'q'"},
      {"(r^90)*(r^90)", "f:1:7: error: the dimension of the result is beyond all measure"},
  };
  for (const auto& [text, message] : table) {
    EXPECT_EQ(failure(text), message) << text;
    try {
      value_of(text);
    } catch (const DomainError&) {
      ADD_FAILURE() << text;
    } catch (const StatementError&) {
    }
  }
}

TEST(Evaluate, AHintNamesWhatWasWritten) {
  const auto hint = [](const std::string& call) {
    const Expression written = parse_expression(call, "f");
    return describe_unknown_call(*written.as<Call>(), {"frequencies", "norm"}).hint;
  };
  EXPECT_EQ(hint("frequency(lower)"), "write frequencies(lower)");
  EXPECT_EQ(hint("arcsin(a/b)"), "write asin(a/b)");
  EXPECT_EQ(hint("frequency(lower to upper)"), "write frequencies(plate)");
}

TEST(Evaluate, CallsOfTheScope) {
  expect_number("double(3 m) + r", 9, dimensions::length);
  EXPECT_EQ(value_of("min(theta)").text, "the least of a motion") << "min of one quantity is over time: the scope's";
  EXPECT_TRUE(value_of("any").is_any());
}

TEST(Evaluator, NumbersOfAnExpectedDimension) {
  TestScope<double> scope;
  const std::string file = "f";
  const Evaluator<double> evaluator(scope, file);
  const auto number = [&](const char* text, const Dimension& d) {
    return evaluator.number(parse_expression(text, file), d);
  };
  EXPECT_EQ(number("F", dimensions::force), 10);
  EXPECT_EQ(number("0", dimensions::force), 0);
  EXPECT_EQ(number("w*r", dimensions::velocity), 12);
  EXPECT_EQ(number("2", dimensions::none), 2);
  EXPECT_EQ(number("0", dimensions::angle), 0);
  const auto refusal = [&](const char* text, const Dimension& d) { return failure_of([&] { number(text, d); }); };
  EXPECT_EQ(refusal("10 lb", dimensions::mass),
            "f:1:1: error: expected a mass, not a force (a force stands in it in place of a mass: write lbm or ozm for "
            "lb or oz, or divide by g)");
  EXPECT_NE(refusal("10 lb*ft^2", dimensions::moment_of_inertia).find("lbm*ft^2 or lb*ft*s^2"), std::string::npos);
  EXPECT_EQ(
      refusal("25", dimensions::length),
      "f:1:1: error: expected a length, not the number 25 without unit (write its unit after a blank, as in 25 m)");
  EXPECT_EQ(refusal("25", dimensions::angle),
            "f:1:1: error: the unit of this angle is missing (write 25 deg or 25 rad)");
  EXPECT_EQ(refusal("20 + 5", dimensions::angle),
            "f:1:1: error: the unit of this angle is missing (give it the unit deg or rad)");
  EXPECT_EQ(
      refusal("r*A", dimensions::area),
      "f:1:1: error: expected one number, an area, not a vector (take a component, v.x, or the magnitude, norm(v))");
  EXPECT_EQ(refusal("any", dimensions::area), "f:1:1: error: expected one number, an area, not 'any'");
}

TEST(Evaluator, VectorsOfAnExpectedDimension) {
  TestScope<double> scope;
  const std::string file = "f";
  const Evaluator<double> evaluator(scope, file);
  const auto vector = [&](const char* text, const Dimension& d) {
    return evaluator.vector(parse_expression(text, file), d);
  };
  EXPECT_EQ(vector("A", dimensions::length).z, 3);
  EXPECT_EQ(norm(vector("0", dimensions::force)), 0);
  EXPECT_EQ(norm(vector("[0, 0, 0]", dimensions::force)), 0);
  const auto refusal = [&](const char* text, const Dimension& d) { return failure_of([&] { vector(text, d); }); };
  EXPECT_EQ(refusal("A", dimensions::force), "f:1:1: error: expected a force, not a length");
  EXPECT_EQ(
      refusal("[1, 2, 3]", dimensions::length),
      "f:1:1: error: expected a length, not a vector without unit (a direction has no size: write one before it, as in "
      "2 m * [1, 2, 3])");
  EXPECT_EQ(refusal("[1 m, 2 N, 0]", dimensions::length),
            "f:1:7: error: component 2 of this vector should be a length, not a force");
  EXPECT_EQ(refusal("[1 m, 0, 4]", dimensions::length),
            "f:1:10: error: component 3 of this vector should be a length, not the number 4 without unit");
  EXPECT_EQ(refusal("[1 m, 2 m]", dimensions::length),
            "f:1:1: error: expected a length in three components, a vector, not a list (write it as [a, b, c])");
}

// Functions of t and their derivatives, which the dual must give.
TEST(EvaluateDual, DerivativesAreExact) {
  struct Case {
    const char* text;
    double derivative;  // at t = 2 (T = 2 s)
  };
  const Case table[] = {
      {"3*t^2 - t", 11},
      {"1/t", -0.25},
      {"sqrt(t)", 0.5 / std::sqrt(2)},
      {"t^-2", -0.25},
      {"t^1.5", 1.5 * std::sqrt(2)},
      {"t^t", 4 * (std::log(2) + 1)},
      {"2^t", 4 * std::log(2)},
      {"sin(t)*cos(t)", std::cos(4)},
      {"tan(t)", 1 / (std::cos(2) * std::cos(2))},
      {"asin(t/4)", 1 / std::sqrt(12)},
      {"acos(t/4)", -1 / std::sqrt(12)},
      {"atan(t)", 0.2},
      {"exp(-t)", -std::exp(-2)},
      {"ln(t)", 0.5},
      {"atan2(t to 1)", 0.2},
      {"abs(-t)", 1},
      {"max(t with 1)", 1},
      {"min(t with 1)", 0},
      {"norm([t, 1, 2])", 2.0 / 3},
      {"dot([t, 1, t^2] with [t, 3, 1])", 8},
      {"cross([t, 0, 0] with [0, t, 0]).z", 4},
      {"unit([t, 0, 1]).x", 1 / std::pow(5, 1.5)},
      {"component([t, 1, 0] along [1, 1, 0])", 1 / std::sqrt(2)},
      {"angle([1, 0, 0] to [1, t, 0])", 0.2},
      {"acute_angle([-1, 0, 0] to [1, t, 0])", 0.2},
      {"[0, 5*T, 0].y", 5},
      {"double(t)", 2},
  };
  TestScope<Dual<1>> scope(Dual<1>::variable(2, 0));
  for (const Case& c : table) {
    const Value<Dual<1>> value = evaluate<Dual<1>>(parse_expression(c.text, "f"), scope, "f");
    ASSERT_TRUE(value.is_number()) << c.text;
    EXPECT_NEAR(value.number.partial[0], c.derivative, 1e-14 * std::max(1.0, std::abs(c.derivative))) << c.text;
    EXPECT_DOUBLE_EQ(value.number.value, value_of(c.text).number) << c.text;
  }
}

TEST(EvaluateDual, AnExponentThatMovesFitsPureNumbersOnly) {
  TestScope<Dual<1>> scope(Dual<1>::variable(2, 0));
  EXPECT_EQ(failure_of([&] { evaluate<Dual<1>>(parse_expression("r^t", "f"), scope, "f"); }),
            "f:1:2: error: a length to the power 2 is no quantity that has a unit");
  EXPECT_EQ(value_of("r^t").dimension, dimensions::area) << "a fixed exponent may";
}

TEST(EvaluateDual, PowersHaveDerivativesAtZero) {
  TestScope<Dual<1>> scope(Dual<1>::variable(0, 0));
  const auto derivative = [&](const char* text) {
    return evaluate<Dual<1>>(parse_expression(text, "f"), scope, "f").number.partial[0];
  };
  EXPECT_EQ(derivative("t^1"), 1);
  EXPECT_EQ(derivative("t^2"), 0);
  EXPECT_EQ(derivative("t^0"), 0);
}

// Random arithmetic on pure numbers against the same arithmetic in C++.
TEST(Evaluate, RandomArithmeticEqualsThatOfTheMachine) {
  std::mt19937_64 random(5);
  for (int i = 0; i < 2000; ++i) {
    std::string text = "t";
    double expected = 2;
    for (std::uint64_t n = random() % 8; n > 0; --n) {
      const double operand = 1 + static_cast<double>(random() % 1000) / 64;
      const std::string literal = to_string(parse_expression(std::to_string(operand), "f"));
      switch (random() % 4) {
        case 0:
          text = "(" + text + " + " + literal + ")";
          expected += std::stod(literal);
          break;
        case 1:
          text = literal + " - " + text;
          expected = std::stod(literal) - expected;
          text = "(" + text + ")";
          break;
        case 2:
          text = text + "*" + literal;
          expected *= std::stod(literal);
          break;
        default:
          text = "(" + text + ")/" + literal;
          expected /= std::stod(literal);
      }
    }
    ASSERT_EQ(value_of(text).number, expected) << text;
  }
}

}  // namespace evaluate_test
}  // namespace poinsot::problem
