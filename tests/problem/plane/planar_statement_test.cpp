// Planar problems against the same said in space, and what they refuse.
#include "problem/plane/planar_statement.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>
#include <string>

#include "problem/answers/solve_statement.h"
#include "problem/language/failure.h"

namespace poinsot::problem {
namespace planar_statement_test {

std::map<std::string, SolvedAsk> answers(const std::string& text) {
  Statement statement = read_statement(text, "test.yaml");
  restrict_to_plane(statement);
  const SolvedStatement solved = solve_statement(statement, {});
  std::map<std::string, SolvedAsk> found;
  EXPECT_EQ(solved.solutions.size(), 1U) << text;
  for (std::size_t i = 0; i < statement.asks.size(); ++i)
    found[statement.asks[i].name] = solved.solutions.at(0).asks[i];
  return found;
}

std::string failure(const std::string& text) {
  return failure_of([&] { answers(text); });
}

// What is said of two bars that hang one on the other, with vectors, moments and questions in the words of the plane or
// of space.
struct TwoBars {
  double x, y, u, v, mass, inertia, push, twist, rate, other_rate;

  std::string said(bool plane) const {
    const std::string third = plane ? "" : ", 0", along = plane ? "" : ".z";
    const auto point = [&](double a, double b) { return fmt::format("[{:.17g} m, {:.17g} m{}]", a, b, third); };
    // Products of inertia in space are taken by the pins.
    const std::string rest =
        plane ? ""
              : fmt::format(", x: {0:.17g} kg*m^2, y: {0:.17g} kg*m^2, yz: {1:.17g} kg*m^2, xy: 0, zx: 0", inertia,
                            inertia / 10);
    return "title: t\ngravity: -y\n" + std::string(plane ? "plane: [x, y]\n" : "") + "points: {O: " + point(0, 0) +
           ", A: " + point(x, y) + ", B: " + point(u, v) + ", G: " + point(x, v) +
           fmt::format(
               "}}\nbodies: {{one: {{rod: [O, A], mass: 2 kg}}, two: {{mass: {:.17g} kg, center: G, inertia: "
               "{{z: {:.17g} kg*m^2{}}}}}}}\n",
               mass, inertia, rest) +
           "joints: {pin: {revolute: z, at: O, to: one}, hinge: {revolute: z, at: A, from: one, to: two}}\n" +
           fmt::format(
               "loads: {{push: {{force: [{0:.17g} N, 3 N{1}], at: B, body: two}}, twist: {{couple: {2:.17g} "
               "N*m{3}, body: one}}}}\n",
               push, third, twist, plane ? "" : ", about: z") +
           fmt::format(
               "facts: {{angular_velocity(one){0}: {1:.17g} rad/s, angular_velocity(two){0}: {2:.17g} rad/s}}\n", along,
               rate, other_rate) +
           fmt::format(
               "ask: {{alpha: angular_acceleration(two){0}, H: angular_momentum(system about A){0}, a: "
               "acceleration(B of two), F: reaction(pin)}}\n",
               along);
  }
};

TEST(PlanarStatement, OnlyComponentsOfOneVectorAreOnTheAxesOfThePlane) {
  const auto found = answers(
      "title: t\ngravity: -y\nplane: [y, x]\npoints: {O: [0, 0], A: [1 m, 2 m]}\n"
      "bodies: {one: {rod: [O, A], mass: 2 kg}}\njoints: {pin: {revolute: z, at: O, to: one}}\n"
      "facts: {angular_velocity(one): 3 rad/s}\n"
      "ask: {v: velocity(A of one), two: [velocity(A of one).x, velocity(A of one).x], back: [velocity(A of one).y, "
      "velocity(A of one).x], points: [velocity(A of one).y, velocity(O of one).x]}\n");
  EXPECT_EQ(found.at("v").component_names, (std::vector<std::string>{"x", "y"}));
  for (const char* name : {"two", "back", "points"}) EXPECT_TRUE(found.at(name).component_names.empty()) << name;
}

TEST(PlanarStatement, SaysOfTwoBarsWhatSpaceSays) {
  std::mt19937_64 random(20);
  std::uniform_real_distribution<double> any(-1, 1), size(0.3, 2);
  int tried = 0;
  for (; tried < 12; ++tried) {
    const TwoBars bars{any(random),  size(random), any(random), size(random), size(random),
                       size(random), any(random),  any(random), any(random),  any(random)};
    const auto plane = answers(bars.said(true)), space = answers(bars.said(false));
    const auto close = [](double one, double other) { EXPECT_NEAR(one, other, 1e-9 * (1 + std::abs(other))); };
    for (const char* name : {"alpha", "H"}) close(plane.at(name).value.number, space.at(name).value.number);
    for (const char* name : {"a", "F"})
      for (std::size_t k = 0; k < 2; ++k)
        close(plane.at(name).value.items.at(k).number, space.at(name).value.vector[k]);
    for (const char* name : {"a", "F"})
      EXPECT_EQ(plane.at(name).component_names, (std::vector<std::string>{"x", "y"})) << name;
    for (const char* name : {"alpha", "H"}) EXPECT_TRUE(plane.at(name).component_names.empty()) << name;
  }
  EXPECT_EQ(tried, 12);
}

// In the plane of the axes x and z angles are counted about -y.
TEST(PlanarStatement, CountsAnglesFromTheFirstAxisToTheSecond) {
  const std::string rest =
      "points: {O: [0, 0], P: [1 m, 0]}\nbodies: {bar: {rod: [O, P], mass: 3 kg}}\njoints: {pin: {revolute: y, at: O, "
      "to: "
      "bar}}\ngravity: -z\nfacts: {velocity(P of bar): [0, 2 m/s]}\nask: {w: angular_velocity(bar), v: "
      "velocity(bar)}\n";
  const auto up = answers("title: t\nplane: [x, z]\n" + rest);
  EXPECT_NEAR(up.at("w").value.number, 2, 1e-12);
  EXPECT_NEAR(up.at("v").value.items.at(1).number, 1, 1e-12);
}

// A free body turns about the normal alone, whatever its products of inertia.
TEST(PlanarStatement, HoldsAFreeBodyInThePlane) {
  const auto found = answers(
      "title: t\nplane: [x, y]\npoints: {G: [0, 0], P: [0.4 m, 0.1 m]}\nbodies: {plate: {mass: 2 kg, center: G, "
      "inertia: "
      "{z: 0.3 kg*m^2, yz: 0.05 kg*m^2, zx: -0.02 kg*m^2}}}\nloads: {push: {force: [0, 6 N], at: P, body: plate}}\n"
      "gravity: none\nfacts: {velocity(plate): [1 m/s, 0], angular_velocity(plate): 3 rad/s}\n"
      "ask: {alpha: angular_acceleration(plate), a: acceleration(plate), w: angular_velocity(plate) @ 0.5 s}\n");
  EXPECT_NEAR(found.at("alpha").value.number, 0.4 * 6 / 0.3, 1e-11);
  EXPECT_NEAR(found.at("a").value.items.at(1).number, 3, 1e-12);
  EXPECT_GT(found.at("w").value.number, 3);
}

// Lists of two are vectors in quotes and within expressions, and lists of numbers where these are asked for.
TEST(PlanarStatement, TakesListsInQuotesForVectors) {
  for (const char* axes : {"[x, y]", "[y, z]", "[z, x]"}) {
    const std::string first(1, axes[1]), second(1, axes[4]);
    const auto file = [&](const std::string& B, const std::string& force, const std::string& velocity) {
      return "title: t\nplane: " + std::string(axes) + "\ngiven: {a: 0.3 m, b: 0.2 m}\npoints: {A: [a, b], B: " + B +
             "}\nbodies: {bar: {rod: [A, B], mass: 2 kg}}\nloads: {push: {force: " + force +
             ", at: B, body: bar}}\ngravity: none\ninstants: {now: {velocity(bar): " + velocity +
             ", angular_velocity(bar): 'max([1, 2])*1 rad/s'}}\nask: {a: acceleration(B of bar), w: "
             "angular_velocity(bar)}\n";
    };
    const auto plain = answers(file("[3*a, 2*b]", "[3 N, 4 N]", "[1 m/s, 2 m/s]"));
    const auto quoted = answers(file("'A + 2*[a, (b + 0 m)/2]'", "'[3 N, 4 N]'", "'[1 m/s, 2 m/s]'"));
    ASSERT_EQ(plain.at("a").value.items.size(), 2U) << axes;
    for (std::size_t k = 0; k < 2; ++k)
      EXPECT_NEAR(quoted.at("a").value.items[k].number, plain.at("a").value.items[k].number, 1e-12) << axes << k;
    EXPECT_EQ(quoted.at("w").value.number, 2) << axes;
  }
}

// In questions, claims and conditions, too; there a list by itself is one of several things.
TEST(PlanarStatement, TakesCornersInQuotes) {
  const auto center = [](const std::string& corners) {
    Statement statement = read_statement(
        "plane: [x, y]\ngiven: {b: 3 m}\nbodies: {a: {polygon: [" + corners + "], mass: 1 kg}}\nask: {c: center(a)}\n",
        "x.yaml");
    restrict_to_plane(statement);
    return solve_statement(statement, {}).solutions.at(0).asks.at(0).value.items;
  };
  for (const char* corners : {"'[0, 0]', '[b, 0]', '[b, 2*b]'", "[0, 0], [b, 0], [b, 2*b]"}) {
    const auto parts = center(corners);
    ASSERT_EQ(parts.size(), 2U) << corners;
    EXPECT_NEAR(parts[0].number, 2, 1e-12) << corners;
    EXPECT_NEAR(parts[1].number, 2, 1e-12) << corners;
  }
}

TEST(PlanarStatement, TakesListsInQuestionsForVectors) {
  const auto found = answers(
      "title: t\nplane: [z, x]\npoints: {A: [3 m, 4 m]}\nbodies: {p: {particle: A, mass: 2 kg}}\ngravity: none\n"
      "facts: {velocity(p): [3 m/s, 6 m/s]}\n"
      "ask: {dot: 'dot(velocity(p) with [0.6, 0.8])', cross: 'cross(position(p) with [1 N, 2 N])', "
      "norm: 'norm(velocity(p) - [3 m/s, 2 m/s])', "
      "sum: '2*[1 m, 2 m] + position(p)', off: 'momentum(p) - 2 kg*[1 m/s, 0 m/s]', far: 'distance([0 m, 0 m] to "
      "center(p))', H: 'angular_momentum(p about [1 m, 1 m])', two: ['max([position(p).x, position(p).z])', "
      "'norm(position(p) + [2 m, 8 m])'], holds: {of: 'velocity(p) == 3*[1 m/s, 2 m/s]'}}\n"
      "claim: {straight: 'cross(velocity(p) with [1, 2]) == 0'}\n");
  EXPECT_NEAR(found.at("dot").value.number, 3 * 0.6 + 6 * 0.8, 1e-14);
  // Angles are counted from z to x, about y.
  EXPECT_NEAR(found.at("cross").value.number, -(3 * 2 - 4 * 1), 1e-14);
  EXPECT_NEAR(found.at("norm").value.number, 4, 1e-14);
  EXPECT_NEAR(found.at("far").value.number, 5, 1e-14);
  EXPECT_NEAR(found.at("H").value.number, -2.0 * (2 * 6 - 3 * 3), 1e-13);
  // On x and z, as they are written.
  EXPECT_NEAR(found.at("sum").value.items.at(0).number, 5, 1e-14);
  EXPECT_NEAR(found.at("sum").value.items.at(1).number, 8, 1e-14);
  EXPECT_NEAR(found.at("off").value.items.at(0).number, 4, 1e-14);
  EXPECT_NEAR(found.at("two").value.items.at(0).number, 4, 1e-14);
  EXPECT_NEAR(found.at("two").value.items.at(1).number, 13, 1e-14);
  EXPECT_TRUE(found.at("holds").value.truth);
}

// Whichever axis angles are counted from, a file's own numbers come back in the order in which it wrote them.
TEST(PlanarStatement, TellsComponentsInTheOrderInWhichTheyAreWritten) {
  for (const char* axes : {"[x, y]", "[y, x]", "[y, z]", "[z, y]", "[z, x]", "[x, z]"}) {
    const auto found = answers("title: t\nplane: " + std::string(axes) +
                               "\npoints: {A: [3 m, 4 m]}\nbodies: {p: {particle: A, mass: 2 kg}}\ngravity: none\n"
                               "facts: {velocity(p): [5 m/s, 6 m/s]}\nask: {A: center(p), v: velocity(p)}\n");
    for (const auto& [name, first] : {std::pair{"A", 3.0}, std::pair{"v", 5.0}}) {
      ASSERT_EQ(found.at(name).value.items.size(), 2U) << axes;
      EXPECT_EQ(found.at(name).value.items[0].number, first) << axes;
      EXPECT_EQ(found.at(name).value.items[1].number, first + 1) << axes;
      EXPECT_LT(found.at(name).component_names[0], found.at(name).component_names[1]) << axes;
    }
  }
}

// A vector to be found has the two components that everything in the plane has.
TEST(PlanarStatement, SeeksVectorsInThePlane) {
  const std::string rest =
      "points: {O: [0, 0], A: [2 m, 0]}\nbodies: {bar: {rod: [O, A], mass: 3 kg}, p: {particle: O, mass: 2 kg}}\n"
      "impulses: {caught: {body: bar, at: O, value: J}}\ngravity: none\ninstants: {before: {velocity(bar): [u, v], "
      "angular_velocity(bar): 0}, after: {velocity(O of bar): [0, 0]}}\n"
      "ask: {J: J, x: J.x, size: norm(J), w: angular_velocity(bar)}\n";
  const auto found = answers("title: t\nplane: [x, y]\ngiven: {u: 1 m/s, v: 4 m/s}\nfind: {J: {vector: N*s}}\n" + rest);
  // About the end 3/4 of the momentum across the bar is left.
  EXPECT_NEAR(found.at("J").value.items.at(0).number, -3, 1e-12);
  EXPECT_NEAR(found.at("J").value.items.at(1).number, -3, 1e-12);
  EXPECT_NEAR(found.at("x").value.number, -3, 1e-12);
  EXPECT_NEAR(found.at("size").value.number, 3 * std::sqrt(2.0), 1e-12);
  EXPECT_NEAR(found.at("w").value.number, 3, 1e-12);
  EXPECT_EQ(found.at("J").unit.text, "N*s");
  const auto letters = answers("title: t\nplane: [x, y]\nletters: {u: m/s, v: m/s}\nfind: {J: {vector: N*s}}\n" + rest);
  ASSERT_TRUE(letters.at("J").formula);
  EXPECT_EQ(letters.at("w").formula->number, Formula::letter("v", Sign::positive) * Formula(3) / Formula(4));
}

// A load that hangs in the loop of a cord, as on a pulley without mass, turns about the normal alone.
TEST(PlanarStatement, HoldsAParticleRoundWhichACordGoes) {
  const auto found = answers(
      "title: t\nplane: [x, y]\npoints: {A: [-1 m, 3 m], B: [1 m, 3 m], L: [0, 0]}\n"
      "bodies: {load: {particle: L, mass: 2 kg}, hook: {particle: B, mass: 1 kg}}\njoints: {nail: {weld: B, to: "
      "hook}}\n"
      "cords: {rope: {from: ground, at: A, over: [{load: {at: L, radius: 1 m, side: -x, smooth: true}}], to: hook, "
      "end: B}}\ngravity: -y\nfacts: {velocity(load): [0, 0]}\nask: {T: tension(rope)}\n");
  EXPECT_NEAR(found.at("T").value.number, 2 * 9.80665 / 2, 1e-11);
}

// What moves in a plane keeps disks parallel: they roll on each other as circles do.
TEST(PlanarStatement, LetsDisksTouchEachOther) {
  const auto found = answers(
      "title: t\nplane: [x, y]\ngiven: {r: 0.1 m, R: 0.6 m}\npoints: {O: [0, 0], C: [0, -R], G: [0, r - R]}\n"
      "bodies: {drum: {ring: {center: O, normal: z, radius: R}, mass: 0 kg}, roll: {disk: {center: G, normal: z, "
      "radius: r}, mass: 3 kg}}\njoints: {stand: {weld: O, to: drum}}\ncontacts: {c: {of: roll, against: drum, at: C, "
      "normal: y, inside: drum, no_slip: true}}\ngravity: -y\ninstants: {now: rest}\nask: {f: frequencies(roll)}\n");
  ASSERT_EQ(found.at("f").value.items.size(), 1U);
  EXPECT_NEAR(found.at("f").value.items[0].number, std::sqrt(2 * 9.80665 / (3 * 0.5)), 1e-9);
}

TEST(PlanarStatement, RefusesWhatPointsOutOfThePlane) {
  const std::string bar =
      "title: t\nplane: [x, y]\npoints: {O: [0, 0], P: [1 m, 0]}\nbodies: {bar: {rod: [O, P], mass: 3 kg}}\ngravity: "
      "-y\n";
  const std::string pin = "joints: {pin: {revolute: z, at: O, to: bar, rate: 1 rad/s}}\n";
  const auto contains = [](const std::string& text, const std::string& part) {
    EXPECT_NE(text.find(part), std::string::npos) << text;
  };
  contains(failure(bar + "joints: {pin: {revolute: x, at: O, to: bar}}\nask: {w: angular_velocity(bar)}\n"),
           "does not stand across the plane");
  contains(failure(bar + "joints: {pin: {ball: O, to: bar}}\nask: {w: angular_velocity(bar)}\n"),
           "moves across the plane, as a ball joint does");
  contains(failure(bar + pin + "ask: {F: reaction(pin).z}\n"), "points across the plane");
  contains(failure(bar + pin + "ask: {w: angular_velocity(bar).x}\n"), "it is a number: write angular_velocity(bar)");
  contains(failure(bar + pin + "ask: {I: principal_moments(bar about O)}\n"), "directions across the plane");
  contains(failure(bar + pin + "ask: {I: moment_of_inertia(bar about O->P)}\n"), "this axis lies in the plane");
  contains(failure(bar + pin + "loads: {push: {force: '[0, 0, 3 N]', body: bar}}\nask: {F: reaction(pin)}\n"),
           "points out of the plane");
  contains(
      failure(bar + "joints: {pin: {revolute: z, at: O, to: bar, supports: {O: [x, y, z]}}}\nask: {F: reaction(O)}\n"),
      "points out of the plane");
  contains(failure("title: t\nplane: [x, x]\nask: {w: pi}\n"), "two different axes of the figure");
  contains(
      failure("title: t\nplane: [x, y]\npoints: {O: [0, 0, 1 m]}\nbodies: {b: {particle: O, mass: 1 kg}}\ngravity: "
              "none\nask: {a: acceleration(b)}\n"),
      "point 'O' points out of the plane");
}

TEST(PlanarStatement, ResponsesOfVectorsHaveTwoComponents) {
  const auto found = answers(
      "title: t\nplane: [x, y]\npoints: {O: [0, 0]}\nbodies: {cart: {particle: O, mass: 2 kg}}\n"
      "joints: {rail: {prismatic: x, at: O, to: cart, displacement: s, spring: {stiffness: 100 N/m}}}\n"
      "excitations: {push: {force: 3 N, along: x, body: cart}}\ngravity: none\ninstants: {now: rest}\n"
      "ask: {cart: response(center(cart) to push at 0 rad/s)}\n");
  const SolvedAsk& cart = found.at("cart");
  ASSERT_FALSE(cart.columns.empty());
  ASSERT_EQ(cart.columns[0].values.size(), 2U);
  EXPECT_NEAR(cart.columns[0].values[0], 0.03, 1e-12);
  EXPECT_EQ(cart.columns[0].values[1], 0.0);
  EXPECT_EQ(cart.columns[1].unit.text, "deg");
}

TEST(PlanarStatement, ListsOfTwoAreVectorsInFacts) {
  const std::string text =
      "title: t\nplane: [x, y]\ngiven: {b: 0.5 rad, v: 2 m/s}\npoints: {A: [0, 0]}\n"
      "bodies: {puck: {particle: A, mass: 2 kg}}\nloads: {push: {force: '(3 N)*[cos(b), sin(b)]', body: puck}}\n"
      "gravity: none\ninstants: {start: {velocity(puck): 'v*[cos(b), sin(b)]'}}\n"
      "ask:\n  x: velocity(puck).x\n  y: velocity(puck).y\n";
  const std::map<std::string, SolvedAsk> found = answers(text);
  EXPECT_NEAR(found.at("x").value.number, 2 * std::cos(0.5), 1e-12);
  EXPECT_NEAR(found.at("y").value.number, 2 * std::sin(0.5), 1e-12);
}

}  // namespace planar_statement_test
}  // namespace poinsot::problem
