// What worked solutions derive for data that are to be found, for motions near steady ones and in a plane, held against
// closed forms.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <optional>
#include <random>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "document/tex_sums.h"
#include "poinsot/problem.h"
#include "poinsot/rendering.h"
#include "problem/explanation/explanation.h"

namespace poinsot::document {
namespace explanation_equations_test {

Document explained_document(const std::string& statement) {
  return Problem::from_text(statement, "explained.yaml").explain();
}
std::string explained(const std::string& statement, std::size_t solution = 0) {
  return to_markdown(explained_document(statement), solution);
}

// The value of a displayed sum of powers "x^{4} - 78.5\,x^{2} + 769.4 = 0" at a number, as a part of its largest term;
// nothing if there is no line that begins so.
std::optional<double> polynomial_at(const std::string& text, const std::string& letter, std::size_t degree, double x) {
  const std::string power = degree == 1 ? letter : letter + fmt::format("^{{{}}}", degree);
  std::size_t begin = text.find("\n" + power + " ");
  if (begin == std::string::npos) return std::nullopt;
  ++begin;
  std::string line = text.substr(begin, text.find('\n', begin) - begin);
  for (const std::string& mark : {std::string("&"), std::string(" \\\\")})
    if (const std::size_t at = line.find(mark); at != std::string::npos) line.erase(at, mark.size());
  line = line.substr(0, line.find(" = 0"));
  std::vector<std::pair<std::string, double>> symbols{{letter, x}};
  for (std::size_t k = 2; k <= degree; ++k) symbols.emplace_back(letter + fmt::format("^{{{}}}", k), std::pow(x, k));
  const auto sum = testing::TexSumReader(line, symbols).read();
  if (!sum) return std::nullopt;
  return std::abs(sum->value) / sum->size;
}

// The rates of steady precession are the roots of (I (s + p cos theta) - I' p cos theta) p = m g c.
TEST(ExplainedEquations, PrecessionIsTheQuadraticOfTheTopWithBothRoots) {
  std::mt19937_64 random(3);
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  int tried = 0;
  for (int i = 0; i < 6; ++i) {
    const double I = between(1, 2), J = I * between(1.1, 3), c = between(0.05, 0.2), m = between(1, 3);
    const double theta = i == 0 ? std::numbers::pi / 6 : between(0.3, 1.2), s = between(20, 60), g = 9.81;
    const double a = (J - I) * std::cos(theta), b = -I * s, d = m * g * c;
    if (!(b * b - 4 * a * d > 0)) continue;
    const Document document = explained_document(fmt::format(
        R"(given: {{I: {} kg*m^2, J: {} kg*m^2, c: {} m, m: {} kg, b: {} deg, s: {} rad/s, g: {} m/s^2}}
find: {{p: rad/s}}
gravity: -z
points: {{O: [0, 0, 0], G: 'c*[sin(b), 0, cos(b)]'}}
bodies: {{top: {{mass: m, center: G, inertia: {{about: O, axis: O->G, axial: I, transverse: J}}}}}}
joints: {{tip: {{ball: O, to: top}}}}
frames: {{figure: {{origin: O, turns: z, rate: p}}}}
steady: {{frame: figure, spins: {{top: {{about: O->G, rate: s}}}}}}
ask: {{a: p}}
)",
        I, J, c, m, theta * 180 / std::numbers::pi, s, g));
    ASSERT_EQ(document.solutions.size(), 2u);
    const double q = -0.5 * (b - std::sqrt(b * b - 4 * a * d)), fast = q / a, slow = d / q;
    const std::string text = to_markdown(document, 0);
    for (const double root : {slow, fast}) {
      const auto left = polynomial_at(text, "p", 2, root);
      ASSERT_TRUE(left) << text;
      EXPECT_LT(*left, 1e-5) << text;
    }
    EXPECT_GT(*polynomial_at(text, "p", 2, 1.01 * fast), 1e-3);
    EXPECT_NE(text.find(fmt::format("the other root ${:.6g}", fast)), std::string::npos) << fast << text;
    // The letter of the angle stays, also where its sine is a simple number.
    EXPECT_NE(text.find("\\cos b"), std::string::npos) << text;
    EXPECT_EQ(text.find("\\sqrt{3}"), std::string::npos) << text;
    ++tried;
  }
  EXPECT_GE(tried, 4);
}

TEST(ExplainedEquations, AnAngleFollowsByItsSineAndAnyMassCancels) {
  // A rod on a turning shaft: cos(a) = 3 g/(2 L w^2) from the vertical.
  const std::string text = explained(R"(
given: {L: 0.83 m, w: 6 rad/s, g: 9.81 m/s^2}
find: {a: deg}
where: [1 deg < a < 89 deg]
gravity: -y
points: {O: [0, 0, 0], A: 'L*[sin(a), -cos(a), 0]'}
bodies: {clevis: massless, rod: {rod: [O, A], mass: any}}
joints:
  shaft: {revolute: y, at: O, to: clevis, rate: w, accel: 0}
  hinge: {revolute: z, at: O, from: clevis, to: rod}
steady: {frame: clevis}
ask: {a: a}
)");
  EXPECT_NE(text.find("apart from $\\sin a = 0$"), std::string::npos) << text;
  EXPECT_NE(text.find(fmt::format("\\cos a &= \\frac{{3 g}}{{2 L w^{{2}}}} = {:.6g}", 3 * 9.81 / (2 * 0.83 * 36))),
            std::string::npos)
      << text;
  EXPECT_NE(
      text.find(fmt::format("a &= {:.6g}^{{\\circ}}", std::acos(3 * 9.81 / (2 * 0.83 * 36)) * 180 / std::numbers::pi)),
      std::string::npos)
      << text;
  EXPECT_EQ(text.find("mass $1"), std::string::npos) << text;
}

TEST(ExplainedEquations, OneFreedomSwingsAtTheRootOfItsStiffnessOverItsInertia) {
  const std::string text = explained(R"(
given: {m: 3 kg, L: 0.7 m, k: 40 N*m/rad, g: 9.81 m/s^2}
points: {O: [0, 0, 0], A: [0, -L, 0]}
bodies: {bar: {rod: [O, A], mass: m}}
joints: {pin: {revolute: z, at: O, to: bar, angle: t, spring: {stiffness: k, free_angle: 0 deg}}}
gravity: -y
instants: {now: rest}
ask: {swing: frequencies(bar)}
)");
  const double square = (40 + 3 * 9.81 * 0.35) / (3 * 0.49 / 3);
  EXPECT_NE(text.find("\\ddot{\\xi}"), std::string::npos) << text;
  EXPECT_NE(text.find(fmt::format("= {:.6g}\\ \\mathrm{{rad^{{2}}/s^{{2}}}}", square)), std::string::npos) << text;
  EXPECT_NE(text.find(fmt::format("The frequency is ${:.6g}\\ \\mathrm{{rad/s}}$", std::sqrt(square))),
            std::string::npos)
      << text;
}

TEST(ExplainedEquations, SeveralFreedomsHaveTheirCharacteristicPolynomial) {
  const std::string text = explained(R"(
given: {m: 1 kg, L: 0.5 m, g: 9.81 m/s^2}
points: {O: [0, 0, 0], A: [0, -L, 0], B: [0, -2*L, 0]}
bodies: {one: {particle: A, mass: m}, two: {particle: B, mass: m}}
joints:
  upper: {revolute: z, at: O, to: one, angle: a}
  lower: {revolute: z, at: A, from: one, to: two, angle: b}
gravity: -y
instants: {now: rest}
ask: {swing: frequencies(system)}
)");
  for (const double sign : {-1.0, 1.0}) {
    const auto left = polynomial_at(text, "\\omega", 4, std::sqrt((2 + sign * std::sqrt(2.0)) * 9.81 / 0.5));
    ASSERT_TRUE(left) << text;
    EXPECT_LT(*left, 1e-5) << text;
  }
  EXPECT_GT(*polynomial_at(text, "\\omega", 4, 5), 1e-2);
  EXPECT_NE(text.find("\\mathbf{M} &= \\begin{pmatrix}"), std::string::npos) << text;
}

TEST(ExplainedEquations, ALimitOfStabilityIsWhereTheStiffnessVanishes) {
  // A rod that hangs from a turning shaft begins to leave it at w^2 = 3 g/(2 L).
  const std::string text = explained(R"(
given: {L: 0.83 m, w: 1 rad/s, g: 9.81 m/s^2}
gravity: -y
points: {O: [0, 0, 0], A: [0, -L, 0]}
bodies: {clevis: massless, rod: {rod: [O, A], mass: any}}
joints:
  shaft: {revolute: y, at: O, to: clevis, rate: w, accel: 0}
  hinge: {revolute: z, at: O, from: clevis, to: rod, angle: a}
instants: {now: {a: 0 deg}}
steady: {frame: clevis}
ask: {most: {largest: w, while: stable(rod)}}
)");
  EXPECT_NE(text.find(fmt::format("w^{{2}} &= \\frac{{3 g}}{{2 L}} = {:.6g}", 1.5 * 9.81 / 0.83)), std::string::npos)
      << text;
  EXPECT_NE(text.find(fmt::format("w &= {:.6g}\\ \\mathrm{{rad/s}}", std::sqrt(1.5 * 9.81 / 0.83))), std::string::npos)
      << text;
}

constexpr const char* bar_in_a_plane = R"(
given: {m: 3 kg, L: 0.7 m, b: 30 deg, g: 9.81 m/s^2}
points: {O: [0, 0, 0], A: 'L*[sin(b), -cos(b), 0]'}
bodies: {bar: {rod: [O, A], mass: m}}
joints: {pin: {revolute: z, at: O, to: bar}}
gravity: -y
instants: {now: rest}
ask: {O: reaction(pin)}
)";

TEST(ExplainedEquations, InAPlaneThreeEquationsAreShown) {
  const std::string text = explained(bar_in_a_plane);
  EXPECT_NE(text.find("Everything starts from rest, and nothing is known to act across the $xy$ plane: of the six"),
            std::string::npos)
      << text;
  for (const char* piece : {"\\Sigma F_{x}", "\\Sigma F_{y}", "\\Sigma M_{z}", "O_{x}", "O_{y}", "I_{z}"})
    EXPECT_NE(text.find(piece), std::string::npos) << piece << text;
  for (const char* piece : {"\\Sigma F_{z}", "\\Sigma M_{x}", "\\Sigma M_{y}", "O_{z}", "M_{O,x}", "I_{x}"})
    EXPECT_EQ(text.find(piece), std::string::npos) << piece << text;
}

// What turns about an axis in the plane of its forces does not move in that plane.
TEST(ExplainedEquations, AnAskewRotorDoesNotMoveInAPlane) {
  const std::string text = explained(R"(
given: {m: 8 kg, r: 150 mm, b: 20 deg, n: 1200 rpm, L: 500 mm}
points: {A: [-L/2, 0, 0], G: [0, 0, 0], B: [L/2, 0, 0]}
directions: {across: [cos(b), sin(b), 0]}
bodies: {disk: {disk: {center: G, normal: across, radius: r}, mass: m}}
joints: {shaft: {revolute: A->B, at: A, to: disk, rate: n, accel: 0, supports: {A: [x, y, z], B: [y, z]}}}
gravity: none
ask: {A: reaction(A)}
)");
  EXPECT_EQ(text.find("moves in the"), std::string::npos) << text;
  EXPECT_NE(text.find("A_{z}"), std::string::npos) << text;
}

// A force across the plane needs the other equations.
TEST(ExplainedEquations, AForceAcrossThePlaneKeepsAllEquations) {
  std::string statement = bar_in_a_plane;
  statement += "loads: {push: {force: [0, 0, 5 N], at: A, body: bar}}\n";
  const std::string text = explained(statement);
  EXPECT_EQ(text.find("moves in the"), std::string::npos) << text;
  EXPECT_NE(text.find("O_{z}"), std::string::npos) << text;
}

// A free body whose motion stays in a plane has the three equations of it, and no word of the others.
TEST(ExplainedEquations, AFreeBodyThatStaysInAPlaneHasThreeEquations) {
  const std::string text = explained(R"(
given: {m: 50 kg, P: 300 N, c: 0.4 m, H: 1 m, W: 1 m, mu: 0.8, h: 0.8 m}
points: {A: [-c, 0, 0], B: [c, 0, 0], G: [0, H, 0], K: [c, h, 0]}
bodies: {crate: {box: {center: G, sides: [2*c*x, 2*H*y, W*z]}, mass: m}}
contacts:
  left: {of: crate, at: A, normal: y, friction: mu}
  right: {of: crate, at: B, normal: y, friction: mu}
loads: {pull: {force: [P, 0, 0], at: K, body: crate}}
gravity: -y
instants: {now: rest}
ask: {turns: angular_acceleration(crate).z}
)");
  EXPECT_NE(text.find("Everything starts from rest, and nothing is known to act across the $xy$ plane: of the six"),
            std::string::npos)
      << text;
  for (const char* piece : {"I_{z}", "\\dot{\\omega}_{z}", "sticking at contact *right* along x"})
    EXPECT_NE(text.find(piece), std::string::npos) << piece << text;
  // What rests has no velocities to be found.
  for (const char* piece :
       {"I_{x}", "\\dot{\\omega}_{x}", "\\dot{v}_{z}", "along z", "F_{\\mathrm{right},z}", "says of the velocities"})
    EXPECT_EQ(text.find(piece), std::string::npos) << piece << text;
}

TEST(ExplainedEquations, FrictionThatIsAskedForFollowsFromTheEquations) {
  const std::string rest =
      "mu: 0.4, k: 0.3}\npoints: {C: [0, 0, 0]}\nbodies: {book: {particle: C, mass: m}}\n"
      "contacts: {wall: {of: book, at: C, normal: x, friction: {static: mu, kinetic: k}}}\n"
      "loads: {hand: {force: [-P, 0, 0], at: C, body: book}}\ngravity: -y\n";
  const std::string held = explained("\ngiven: {m: 1.2 kg, P: 40 N, " + rest +
                                     "instants: {now: rest}\nask: {F: friction(wall on book).y}\n");
  for (const char* piece : {"\\Sigma F_{y}", "F_{\\mathrm{wall},y} &= m g = 11.768"})
    EXPECT_NE(held.find(piece), std::string::npos) << piece << held;
  const std::string sliding =
      explained("\ngiven: {m: 1.2 kg, P: 4 N, " + rest + "instants: {now: rest}\nask: {F: friction(wall on book).y}\n");
  EXPECT_NE(sliding.find("along the normal, and the friction $k\\,N$ against the sliding"), std::string::npos)
      << sliding;
  EXPECT_NE(sliding.find("N &= P = 4\\ \\mathrm{N}"), std::string::npos) << sliding;
}

// What multiplies one symbol on one side of a displayed equation is one sum.
TEST(ExplainedEquations, EachSymbolStandsOnceOnASide) {
  const std::string text = explained(R"(given: {T0: 200 N, M: 8 N*m, I: 0.01 kg*m^2, J: 0.4 kg*m^2, K: 0.001 kg*m^2}
points: {A: [0, 0, 0], B: [500 mm, 0, 0], D: [200 mm, 100 mm, 0]}
bodies:
  motor: {mass: 3 kg, center: A, inertia: {axis: z, axial: I, transverse: J}}
  fan: {mass: 9 kg, center: B, inertia: {axis: z, axial: J, transverse: J}}
  idler: {mass: 0.5 kg, center: D, inertia: {axis: z, axial: K, transverse: K}}
joints:
  shaft: {revolute: z, at: A, to: motor, couple: M}
  axle: {revolute: z, at: B, to: fan}
  pin: {revolute: z, at: D, to: idler}
belts:
  belt:
    over: [{motor: {radius: 60 mm, side: -x}}, {fan: {radius: 150 mm, side: -y}}, {idler: {radius: 40 mm, side: -y}}]
    tension: T0
gravity: none
instants: {now: rest}
ask: {T1: tension(belt from motor to fan), T2: tension(belt from fan to idler), pin: force(pin on idler)}
)");
  std::size_t seen = 0;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (line.find(" &= ") == std::string::npos) continue;
    const std::string left = line.substr(0, line.find(" &= "));
    for (const std::string symbol : {"T_{1}", "T_{2}"}) {
      const std::size_t first = left.find(symbol);
      if (first == std::string::npos) continue;
      EXPECT_EQ(left.find(symbol, first + 1), std::string::npos) << line;
      ++seen;
    }
  }
  EXPECT_GE(seen, 6U);
  // Each side of the belt is listed once among what acts on a wheel, in the direction in which it acts there.
  const std::size_t idler = text.find("Take *idler*");
  ASSERT_NE(idler, std::string::npos);
  const std::string list = text.substr(idler, text.find("\n#", idler) - idler);
  const std::string last = "from *idler* to *motor*";
  ASSERT_NE(list.find(last), std::string::npos) << list;
  EXPECT_EQ(list.find(last, list.find(last) + 1), std::string::npos) << list;
  EXPECT_EQ(list.find("opposite sign"), std::string::npos) << list;
}

// Of a particle that cords hold the moments say again what the forces do, and it does not turn.
TEST(ExplainedEquations, AParticleHasNeitherMomentsNorTurning) {
  const std::string text = explained(R"(points: {O: [0, 0, 0], A: [-0.2 m, -1 m, 0], B: [0.2 m, -0.5 m, 0]}
bodies: {wheel: massless, light: {particle: A, mass: 2 kg}, heavy: {particle: B, mass: 5 kg}}
joints: {pin: {revolute: z, at: O, to: wheel}}
cords: {cord: {from: light, at: A, over: [{wheel: {radius: 0.2 m}}], to: heavy, end: B}}
gravity: -y
instants: {now: {velocity(light): [0, 1 m/s, 0], velocity(heavy): [0, -1 m/s, 0]}}
ask: {T: tension(cord from light to wheel), a: acceleration(light), v: velocity(heavy)}
)");
  const std::size_t of_light = text.find("(Eqs. 18.1, 18.2) of *light*:"),
                    of_heavy = text.find("of *heavy*:", of_light);
  ASSERT_NE(of_light, std::string::npos) << text;
  ASSERT_NE(of_heavy, std::string::npos) << text;
  const std::string equations = text.substr(of_light, text.find("What holds", of_heavy) - of_light);
  EXPECT_NE(equations.find("\\Sigma F_{y}"), std::string::npos) << equations;
  EXPECT_EQ(equations.find("\\Sigma M"), std::string::npos) << equations;
  const std::size_t motion = text.find("The motion of *light*");
  ASSERT_NE(motion, std::string::npos) << text;
  EXPECT_EQ(text.find("\\boldsymbol{\\omega}_{\\mathrm{light}}", motion), std::string::npos) << text;
  EXPECT_EQ(text.find("\\boldsymbol{\\omega}_{\\mathrm{heavy}}", motion), std::string::npos) << text;
}

TEST(ExplainedEquations, ATableOverADatumShowsTheDatum) {
  const Document document = explained_document(R"(given: {L: 0.5 m, w: 30 rpm}
points: {O: [0, 0, 0], P: [L, 0, 0]}
bodies: {bob: {particle: P, mass: 2 kg}}
joints: {axle: {revolute: z, at: O, to: bob, rate: w, accel: 0}}
gravity: none
instants: {now: {}}
ask:
  pull: {table: {F: norm(force(axle on bob))}, over: {w: [30 rpm, 60 rpm]}}
  both: {table: {n: w, F: norm(force(axle on bob))}, over: {w: [30 rpm, 60 rpm]}}
)");
  const Answer& pull = document.solutions.at(0).answers.at(0);
  ASSERT_TRUE(pull.over);
  EXPECT_EQ(pull.over->name, "w");
  EXPECT_EQ(pull.over->unit, "rpm");
  ASSERT_EQ(pull.over->value.size(), 2U);
  EXPECT_NEAR(pull.over->value[1], 60, 1e-9);
  EXPECT_NEAR(pull.over->si[1], 2 * std::numbers::pi, 1e-9);
  // m L w^2 at each.
  ASSERT_EQ(pull.columns.size(), 1U);
  for (std::size_t row = 0; row < 2; ++row)
    EXPECT_NEAR(pull.columns[0].si[row], 2 * 0.5 * std::pow(pull.over->si[row], 2), 1e-9);
  // A column that shows it already is enough.
  EXPECT_FALSE(document.solutions[0].answers.at(1).over);
  EXPECT_NE(to_terminal(document).find("w        F\n"), std::string::npos) << to_terminal(document);
  EXPECT_NE(to_markdown(document, 0).find("| w in rpm | F in N |"), std::string::npos) << to_markdown(document, 0);
}

// Velocities that nothing names are symbols in claims, too.
TEST(ExplainedEquations, ClaimsTellVelocitiesBySymbols) {
  const std::string text = explained(R"(letters: {m: kg, Ix: kg*m^2, Iy: kg*m^2, Iz: kg*m^2}
points: {O: [0, 0, 0]}
bodies: {rigid_one: {mass: m, center: O, inertia: {x: Ix, y: Iy, z: Iz}}}
joints: {pivot: {ball: O, to: rigid_one}}
gravity: -z
define: {H: angular_momentum(rigid_one about O), w: angular_velocity(rigid_one), wx: w.x}
claim:
  kept: ["rate(H) == 0"]
  constant: {claim: "wx' == 0", axes: rigid_one}
)");
  EXPECT_EQ(text.find("\\text{angular"), std::string::npos) << text;
  EXPECT_NE(text.find("\\omega_{y,\\mathrm{rigid\\_one}}"), std::string::npos) << text;
  EXPECT_NE(text.find("Take $"), std::string::npos) << text;
}

// To a later instant the motion has led: no conditions are solved there for velocities. What a turned body has on its
// own axes is told as such.
TEST(ExplainedEquations, AtLaterInstantsVelocitiesAreThoseOfTheMotion) {
  const std::string text = explained(R"(given: {r: 0.1 m}
points: {C: [0, 0, 0], G: [0, r, 0]}
bodies: {ball: {sphere: {center: G, radius: r}, mass: 2 kg}}
contacts: {floor: {of: ball, at: C, normal: y, no_slip: true}}
loads: {pull: {force: [3 N, 0, 0], at: G, body: ball}}
gravity: -y
instants: {start: {velocity(ball): [1 m/s, 0, 0], angular_velocity(ball): [0, 0, -10 rad/s]}}
ask: {N: reaction(floor) @ 1 s, N0: reaction(floor), v: velocity(ball) @ 1 s}
)");
  EXPECT_NE(text.find("Component equations, at 1 s"), std::string::npos) << text;
  EXPECT_EQ(text.find("## Velocities, at 1 s"), std::string::npos) << text;
  const std::string words = "are on the axes of the body, which have turned with it";
  const std::size_t said = text.find(words);
  ASSERT_NE(said, std::string::npos) << text;
  EXPECT_GT(said, text.find("Component equations, at 1 s"));
  EXPECT_EQ(text.find(words, said + 1), std::string::npos);
}

// Beer and Johnston's rate of H is asked for about a point: the solution has that point and no other.
TEST(ExplainedEquations, TheRateOfAnAngularMomentumIsDerivedAboutThePointThatIsAskedFor) {
  const auto text_about = [](const char* point) {
    return explained(fmt::format(
        "title: t\npoints: {{D: [0, 0, 0], A: [-1 m, 0, 0], B: [1 m, 0, 0], C: [-0.3 m, 0.6 m, 0], E: [0.3 m, -0.6 m, "
        "0]}}\nbodies: {{r: {{rod: [C, E], mass: 2 kg}}}}\njoints: {{b: {{revolute: A->B, to: r, rate: 12 rad/s, "
        "accel: "
        "0}}}}\nask: {{a: 'rate(angular_momentum(r about {}))'}}\n",
        point));
  };
  const std::string about_center = text_about("D"), about_end = text_about("B");
  EXPECT_NE(about_center.find("\\dot{\\mathbf{H}}_{G}"), std::string::npos) << about_center;
  EXPECT_EQ(about_center.find("\\mathbf{H}_{A}"), std::string::npos) << about_center;
  EXPECT_EQ(about_center.find("about $A$"), std::string::npos) << about_center;
  EXPECT_NE(about_end.find("\\dot{\\mathbf{H}}_{B}"), std::string::npos) << about_end;
  EXPECT_EQ(about_end.find("\\mathbf{H}_{A}"), std::string::npos) << about_end;
}

// A constant couple M on a wheel of moment I for a time t gives it the rate M t/I.
TEST(ExplainedEquations, AStageInWhichNothingChangesIsDerivedAtItsStart) {
  const auto with_couple = [](const char* couple) {
    return explained(fmt::format(
        "title: t\npoints: {{O: [0, 0, 0], A: [0.3 m, 0, 0]}}\nbodies: {{w: {{disk: {{center: O, normal: z, radius: "
        "0.5 "
        "m}}, mass: 4 kg, added: {{lump: {{particle: A, mass: 1 kg}}}}}}}}\njoints: {{axle: {{revolute: z, at: O, to: "
        "w, "
        "angle: q}}}}\nloads: {{drive: {{couple: [0, 0, {}], body: w}}}}\ngravity: none\nstages: {{driven: {{lasts: 3 "
        "s}}, coasting: {{loads: []}}}}\ninstants: {{driven.start: {{q': 0.4 rad/s, q: 0}}}}\n"
        "ask: {{F: {{of: reaction(axle) @ coasting, axes: w}}}}\n",
        couple));
  };
  const std::string text = with_couple("0.59 N*m");
  // I = 4*0.5^2/2 + 0.3^2 = 0.59 kg m^2: the rate grows by 1 rad/s each second.
  EXPECT_NE(text.find("## Stage *driven*"), std::string::npos) << text;
  EXPECT_NE(text.find("\\dot{q} = \\dot{q}_{0} + \\ddot{q}\\,\\Delta t = 3.4\\ \\mathrm{rad/s}"), std::string::npos)
      << text;
  EXPECT_NE(text.find("\\ddot{q} = 1\\ \\mathrm{rad/s^{2}}"), std::string::npos) << text;
  // The force toward the axle is 1*0.3*3.4^2 on the axes of the wheel, which has turned by 0.4*3 + 3^2/2 rad.
  const std::size_t axes = text.find("## On the axes of *w*");
  ASSERT_NE(axes, std::string::npos) << text;
  EXPECT_NE(text.find("\\mathbf{F}\\cdot\\mathbf{i}' = -3.468\\ \\mathrm{N}", axes), std::string::npos) << text;
  EXPECT_NE(text.find(fmt::format("{:.6g}", std::cos(5.7)), axes), std::string::npos) << text;
  // Where the couple changes, nothing of that kind is said.
  EXPECT_EQ(with_couple("0.59 N*m - 0.1 N*m*s * q'").find("## Stage *driven*"), std::string::npos);
}

TEST(ExplainedEquations, ATableHasALineForEachOfItsRows) {
  const std::string text = explained(
      "title: t\ngiven: {m: 2 kg, v: 3 m/s}\npoints: {O: [0, 0, 0]}\nbodies: {b: {particle: O, mass: m}}\n"
      "instants: {now: {velocity(b): [v, 0, 0]}}\nask: {T: {table: {v: v, E: kinetic_energy(b)}, over: {v: 1 m/s .. 3 "
      "m/s by 1 m/s}}}\n");
  EXPECT_NE(text.find(":\n\n  | v in m/s | E in "), std::string::npos) << text;
  EXPECT_NE(text.find("|\n  |---:|---:|\n  | 1"), std::string::npos) << text;
  EXPECT_NE(text.find("|\n  | 3"), std::string::npos) << text;
}

// A body of revolution with I = 2, I' = 5 kg m^2 that turns at (3, 0, 4) rad/s: H = (15, 0, 8), |H| = 17.
TEST(ExplainedEquations, FreePrecessionFollowsFromTheAngularMomentum) {
  const std::string text = explained(
      "title: t\npoints: {G: [0, 0, 0]}\nbodies: {can: {mass: 20 kg, center: G, inertia: {axis: z, axial: 2 kg*m^2, "
      "transverse: 5 kg*m^2}}}\ngravity: none\ninstants: {now: {angular_velocity(can): [3 rad/s, 0, 4 rad/s], "
      "velocity(can): [0, 0, 0]}}\nask: {p: precession_rate(can), s: spin_rate(can), g: body_cone(can)}\n");
  const std::size_t free = text.find("## Free motion");
  ASSERT_NE(free, std::string::npos) << text;
  EXPECT_NE(text.find("\\mathbf{H}_{G} = (15\\,\\mathbf{i} + 8\\,\\mathbf{k})", free), std::string::npos) << text;
  const auto tells = [&](const std::string& symbol, double value) {
    const std::size_t at = text.find(symbol, free);
    return at != std::string::npos &&
           text.substr(at, text.find('\n', at) - at).find(fmt::format("{:.6g}", value)) != std::string::npos;
  };
  EXPECT_TRUE(tells("\\theta &= ", std::atan2(15, 8) * 180 / std::numbers::pi)) << text;
  EXPECT_TRUE(tells("\\dot{\\phi} &= \\frac{H_{G}}{I'} = ", 17.0 / 5)) << text;
  // The spin is what is left of the turning about the axis: 4 - 3.4*8/17.
  EXPECT_TRUE(tells("\\dot{\\psi} &= ", 2.4)) << text;
  EXPECT_TRUE(tells("\\gamma &= ", std::atan2(3, 4) * 180 / std::numbers::pi)) << text;
}

// P against nothing moves a car of mass m: a particle at which its forces meet has no other equation.
TEST(ExplainedEquations, AParticleWhoseForcesMeetHasTheEquationOfItsForces) {
  const std::string text = explained(
      "title: t\ngiven: {m: 1200 kg, P: 6 kN}\npoints: {O: [0, 0, 0]}\nbodies: {car: {particle: O, mass: m}}\njoints: "
      "{road: {prismatic: x, at: O, to: car, displacement: s, force: P}}\ngravity: none\ninstants: {start: {s: 0, s': "
      "3 "
      "m/s}}\nask: {a: s''}\n");
  EXPECT_NE(text.find("\\Sigma F_{x}: && P &= m\\,\\ddot{s}"), std::string::npos) << text;
}

// A spring that is held a hundred metres away makes no moment of a hundredth of a newton metre a rounding.
TEST(ExplainedEquations, WhatIsHeldFarAwayMakesNothingARounding) {
  const std::string text = explained(
      "title: t\ngiven: {k: 500 N/m, b: 50 mm, s: 100 rad/s, W: 0.3 rad/s}\npoints: {O: [0, 0, 0], A: [0, 0, b], C: "
      "[0, "
      "-100 m, b]}\nfind: {tilt: deg}\nwhere: [-45 deg < tilt < 45 deg]\nframes: {airplane: {turns: y, rate: W}}\n"
      "bodies: {yoke: massless, disk: {disk: {center: O, normal: z, radius: 40 mm}, mass: 0.2 kg}}\n"
      "joints: {pivot: {revolute: x, at: O, from: airplane, to: yoke, angle: tilt}, axle: {revolute: z, at: O, from: "
      "yoke, "
      "to: disk, rate: s, accel: 0}}\nsprings: {AC: {from: airplane, at: C, to: yoke, end: A, stiffness: k, "
      "free_length: "
      "100 m}}\ngravity: none\nsteady: {frame: airplane}\nask: {a: tilt}\n");
  EXPECT_EQ(text.find("\\dot{\\mathbf{H}}_{O} = \\mathbf{0}"), std::string::npos) << text;
  EXPECT_NE(text.find("\\Sigma M_{x}: &&"), std::string::npos) << text;
}

}  // namespace explanation_equations_test
}  // namespace poinsot::document
