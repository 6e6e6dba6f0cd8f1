// Unknowns as formulas: the steps alone, and in statements.
#include "problem/formulas/formula_unknowns.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "poinsot/engine/math/formula/formula_text.h"
#include "problem/answers/solve_statement.h"

namespace poinsot::problem {
namespace formula_unknowns_test {

Formula letter(const std::string& name) { return Formula::letter(name, poinsot::Sign::positive); }
Formula unknown(const std::string& name) { return Formula::letter(name, poinsot::Sign::real); }

// The equation f == 0 has this root, which lies near the value at a = 2, b = 3.
void expect_root(const Formula& f, const UnknownLetter& of, const Formula& root) {
  const PlainPointScope point({{"a", 2}, {"b", 3}, {of.name, of.value}});
  const auto found = solve_unknowns({f}, {of});
  EXPECT_TRUE((found.at(of.name) - root).is_zero()) << text(found.at(of.name)) << " is not " << text(root);
}

TEST(SolveUnknowns, LinearQuadraticAndSquares) {
  const Formula a = letter("a"), b = letter("b"), x = unknown("x");
  expect_root(a * x - b, {"x", false, 1.5}, b / a);
  expect_root(Formula(1) / x - a, {"x", false, 0.5}, Formula(1) / a);
  expect_root(x * x - a * b, {"x", false, 2.449489743}, sqrt(a * b));
  expect_root(x * x - a * b, {"x", false, -2.449489743}, -sqrt(a * b));
  const Formula half = sqrt(a * a + b);
  expect_root(x * x - Formula(2) * a * x - b, {"x", false, 2 + std::sqrt(7)}, a + half);
  expect_root(x * x - Formula(2) * a * x - b, {"x", false, 2 - std::sqrt(7)}, a - half);
  // A root that is zero is left out where the one that is meant is not.
  expect_root(x * (a * x - b), {"x", false, 1.5}, b / a);
  expect_root(pow(x, 4) - a * a, {"x", false, 1.41421356237}, sqrt(a));
}

TEST(SolveUnknowns, Angles) {
  const Formula a = letter("a"), b = letter("b"), x = unknown("x");
  const double third = std::acos(2.0 / 3);
  const PlainPointScope point({{"a", 2}, {"b", 3}, {"x", third}});
  const auto found = solve_unknowns({b * cos(x) - a}, {{"x", true, third}});
  EXPECT_TRUE((cos(found.at("x")) - a / b).is_zero());
  EXPECT_NEAR(value_at(found.at("x"), {{"a", 2}, {"b", 3}}), third, 1e-14);
  // A factor that vanishes elsewhere only: the pendulum that hangs.
  const auto swung = solve_unknowns({sin(x) * (b * cos(x) - a)}, {{"x", true, -third}});
  EXPECT_NEAR(value_at(swung.at("x"), {{"a", 2}, {"b", 3}}), -third, 1e-14);
}

// Where moments and products of inertia meet, the angle enters by its double.
TEST(SolveUnknowns, AnglesByTheirDouble) {
  const Formula a = letter("a"), b = letter("b"), x = unknown("x");
  const auto expect_angles = [&](const Formula& f, double first, double second) {
    // Of 2x there are two in a turn, of x four.
    for (const double one : {first, second})
      for (const double root : {one, one > 0 ? one - std::numbers::pi : one + std::numbers::pi}) {
        const PlainPointScope point({{"a", 2}, {"b", 3}, {"x", root}});
        const auto found = solve_unknowns({f}, {{"x", true, root}});
        EXPECT_NEAR(value_at(found.at("x"), {{"a", 2}, {"b", 3}}), root, 1e-14) << text(found.at("x"));
      }
  };
  const Formula s = sin(x), c = cos(x);
  const double slant = std::asin(2.0 / 3) / 2, principal = std::atan2(-4, 3) / 2;
  expect_angles(Formula(2) * b * s * c - a, slant, std::numbers::pi / 2 - slant);
  expect_angles(a * (c * c - s * s) + b * s * c, principal, principal + std::numbers::pi / 2);
  expect_angles(b * (c * c - s * s) - a, std::acos(2.0 / 3) / 2, -std::acos(2.0 / 3) / 2);
  // 2 sin 2x + 3 cos 2x = 3/2
  const double lead = std::atan2(2, 3), way = std::acos(1.5 / std::sqrt(13));
  expect_angles(Formula(2) * a * s * c + b * (c * c - s * s) - b / Formula(2), (lead + way) / 2, (lead - way) / 2);
  // Where sin 2x alone is given, so is the formula.
  const PlainPointScope point({{"a", 2}, {"b", 3}, {"x", slant}});
  EXPECT_EQ(text(solve_unknowns({Formula(2) * b * s * c - a}, {{"x", true, slant}}).at("x")), "asin(a/b)/2");
}

TEST(SolveUnknowns, SeveralOneByOne) {
  const Formula a = letter("a"), b = letter("b"), x = unknown("x"), y = unknown("y");
  const PlainPointScope point({{"a", 2}, {"b", 3}, {"x", 1}, {"y", 2}});
  // x + y = b, x y = a: x = 1, y = 2.
  const auto found = solve_unknowns({x + y - b, x * y - a}, {{"x", false, 1}, {"y", false, 2}});
  EXPECT_NEAR(value_at(found.at("x"), {{"a", 2}, {"b", 3}}), 1, 1e-14);
  EXPECT_NEAR(value_at(found.at("y"), {{"a", 2}, {"b", 3}}), 2, 1e-14);
}

// a sin x - b cos x + c = 0 is (b + c) t^2 + 2 a t + (c - b) = 0 with t = tan(x/2); with + b cos x the leading
// coefficient c - b may vanish, where x = pi is a root.
TEST(SolveUnknowns, TellsWhatMustNotVanishInHalfTangents) {
  const Formula a = letter("a"), b = letter("b"), c = letter("c"), x = unknown("x");
  const PlainPointScope point({{"a", 2}, {"b", 1}, {"c", 1.5}});
  std::vector<Formula> leading;
  const double near = 2 * std::atan((-4 + std::sqrt(16 - 4 * 0.5 * 2.5)) / (2 * 0.5));
  const auto found = solve_unknowns({a * sin(x) + b * cos(x) + c}, {{"x", true, near}}, &leading);
  EXPECT_NEAR(value_at(found.at("x"), {{"a", 2}, {"b", 1}, {"c", 1.5}}), near, 1e-12);
  ASSERT_EQ(leading.size(), 1U);
  EXPECT_NEAR(value_at(leading[0], {{"a", 2}, {"b", 1}, {"c", 1}}), 0, 1e-15);
  EXPECT_GT(std::abs(value_at(leading[0], {{"a", 2}, {"b", 1}, {"c", 1.5}})), 1e-3);
}

// k (|x| - l) sign(x) = f: on either side of the origin by another formula.
TEST(SolveUnknowns, TakesASizeWithItsSignAtTheRoot) {
  const Formula k = letter("k"), l = letter("l"), f = letter("f"), x = unknown("x");
  const Formula remainder = (abs(x) - l) * (abs(x) / x) * k - f;
  for (const double root : {4.0, -2.0}) {
    const PlainPointScope point({{"k", 1}, {"l", 3}, {"f", 1}, {"x", root}});
    const std::vector<UnknownLetter> letters{{"x", false, root}};
    const std::vector<DecidedSign> signs = signs_of_unknowns({remainder}, letters);
    ASSERT_EQ(signs.size(), 1U);
    EXPECT_EQ(signs[0].sign, root < 0 ? -1 : 1);
    EXPECT_NEAR(value_at(signs[0].positive(), {{"x", root}}), std::abs(root), 1e-15);
    const auto found = solve_unknowns({with_signs(remainder, signs)}, letters);
    EXPECT_TRUE((found.at("x") - (f / k + (root < 0 ? -l : l))).is_zero());
  }
}

TEST(SolveUnknowns, SaysWhatHasNoFormula) {
  const Formula a = letter("a"), x = unknown("x");
  const PlainPointScope point({{"a", 2}, {"x", 1}});
  EXPECT_THROW(solve_unknowns({pow(x, 5) + x - a}, {{"x", false, 1}}), NoFormula);
  EXPECT_THROW(solve_unknowns({}, {{"x", false, 1}}), NoFormula);
  // Two conditions that hold together for special letters only.
  EXPECT_THROW(solve_unknowns({x - a / Formula(2), x - Formula(1)}, {{"x", false, 1}}), NoFormula);
}

TEST(SolveUnknowns, OfASteadyPrecessionAreTheTwoRootsOfTheBooks) {
  const SolvedStatement solved = solve_statement(
      read_statement("letters: {I: kg*m^2, J: kg*m^2, S: rad/s, M: N*m}\n"
                     "given: {b: 60 deg}\n"
                     "find: {P: rad/s}\n"
                     "points: {G: [0, 0, 0]}\n"
                     "directions: {u: [sin(b), 0, cos(b)]}\n"
                     "frames: {figure: {turns: z, rate: P}}\n"
                     "bodies: {top: {mass: 1 kg, center: G, inertia: {axis: u, axial: I, transverse: J}}}\n"
                     "joints: {tip: {ball: G, to: top}}\n"
                     "loads: {weight: {couple: [0, M, 0], body: top}}\n"
                     "steady: {frame: figure, spins: {top: {about: u, rate: S}}}\n"
                     "gravity: none\nask: {P: angular_velocity(figure).z}\n",
                     "test.yaml"),
      {});
  ASSERT_EQ(solved.solutions.size(), 2U);
  for (const Solution& solution : solved.solutions) {
    ASSERT_TRUE(solution.asks.at(0).formula) << solution.asks.at(0).no_formula << solution.asks.at(0).reason;
    ASSERT_EQ(solution.unknowns.size(), 1U);
    ASSERT_TRUE(solution.unknowns.at(0).formula);
    // (I (S + P cos b) - J P cos b) P sin b = M (Eq. 18.43).
    const Formula I = Formula::letter("I", poinsot::Sign::positive), J = Formula::letter("J", poinsot::Sign::positive),
                  S = Formula::letter("S", poinsot::Sign::positive), M = Formula::letter("M", poinsot::Sign::positive);
    const Formula P = solution.asks.at(0).formula->number;
    const Formula c = Formula(1) / Formula(2), s = sqrt(Formula(3)) / Formula(2);
    EXPECT_TRUE(((I * (S + P * c) - J * P * c) * P * s - M).is_zero()) << text(P);
  }
}

}  // namespace formula_unknowns_test
}  // namespace poinsot::problem
