// Steps of worked solutions that lead from what is known to what is asked, with nothing left out in between.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "poinsot/problem.h"
#include "poinsot/rendering.h"

namespace poinsot::document {
namespace explanation_steps_test {

namespace fs = std::filesystem;

std::string explained(const std::string& statement) {
  const fs::path file = fs::path(::testing::TempDir()) / "explained_steps.yaml";
  std::ofstream(file) << statement;
  const std::string text = to_markdown(Problem::from_file(file.string()).explain());
  fs::remove(file);
  return text;
}

std::string of_example(const std::string& name) {
  return to_markdown(Problem::from_file(std::string(POINSOT_SOURCE_DIR "/examples/") + name + ".yaml").explain());
}

// The part of a text from a heading to the next.
std::string section(const std::string& text, const std::string& heading) {
  const std::size_t begin = text.find("\n## " + heading + "\n");
  if (begin == std::string::npos) return "";
  return text.substr(begin, text.find("\n## ", begin + 1) - begin);
}

void expect_pieces(const std::string& text, const std::vector<std::string>& pieces) {
  for (const std::string& piece : pieces) EXPECT_NE(text.find(piece), std::string::npos) << piece << "\n" << text;
}

std::size_t count_of(const std::string& text, const std::string& piece) {
  std::size_t count = 0;
  for (std::size_t at = text.find(piece); at != std::string::npos; at = text.find(piece, at + piece.size())) ++count;
  return count;
}

// Numbers of the equations have to be seen somewhere.
TEST(ExplanationSteps, DataThatTheModelDoesNotTellAreListed) {
  const std::string text = explained(R"(
given: {m: 2 kg, L: 400 mm, b: 30 deg, n: 60 rpm, F: [0, 3 N, 4 N]}
points: {O: [0, 0, 0], A: [L*cos(b), L*sin(b), 0]}
bodies: {bar: {rod: [O, A], mass: m}}
joints: {pin: {revolute: y, at: O, to: bar, rate: n, accel: 0}}
loads: {push: {force: F, at: A, body: bar}}
gravity: none
ask: {H: angular_momentum(bar about O), R: reaction(pin)}
)");
  // 60 turns a minute stand at the joint, and are not said again.
  expect_pieces(text, {"rate `n` $= 6.28319\\ \\mathrm{rad/s}$",
                       "\nData: $L = 0.4\\ \\mathrm{m}$, $b = 30^{\\circ}$ and $\\mathbf{F} = (3\\,\\mathbf{j} + "
                       "4\\,\\mathbf{k})\\ \\mathrm{N}$.\n"});
}

// What a table, an extreme or a later time asks for follows from the equations of any time.
TEST(ExplanationSteps, WhatIsAskedOfAWholeMotionIsDerivedForAnyTimeOfIt) {
  const std::string text = explained(R"(
given: {m: 2 kg, L: 0.6 m}
points: {O: [0, 0, 0], A: [0, -L, 0]}
bodies: {bar: {rod: [O, A], mass: m}}
joints: {pin: {revolute: z, at: O, to: bar, angle: theta}}
gravity: -y
instants: {start: {theta: 50 deg, theta': 0}}
ask: {R: {table: {x: reaction(pin).x, y: reaction(pin).y}, over: {time: 0 s .. 0.4 s by 0.1 s}}}
)");
  // L' = -m g L/2 sin(theta) = m L^2/3 theta''
  const std::string found = section(text, "Unknowns, at any time");
  expect_pieces(found, {"\\ddot{\\theta} &= -\\frac{3 g \\sin \\theta}{2 L}", "O_{x} &= ", "O_{y} &= "});
  expect_pieces(section(text, "Component equations, at any time"), {"\\Sigma F_{x}", "\\Sigma F_{y}", "\\Sigma M_{z}"});
  // Numbers would be those of some time that nobody asked for.
  EXPECT_EQ(found.find("mathrm{N}"), std::string::npos) << found;
  EXPECT_EQ(found.find("mathrm{rad/s"), std::string::npos) << found;
}

// A blade of a rotor, of which the largest pull on its root is asked.
TEST(ExplanationSteps, AFormulaOfAnyTimeGivesWhatTheTableTells) {
  const std::string statement = R"(
given: {m: 3 kg, c: 0.2 m, M: 1.5 N*m}
points: {O: [0, 0, 0], C: [c, 0, 0]}
bodies: {blade: {particle: C, mass: m}}
joints: {hub: {revolute: z, at: O, to: blade, angle: q, couple: M}}
gravity: none
instants: {start: {q: 0, q': 0}}
ask: {R: {table: {pull: reaction(hub).x}, over: {time: [0.4 s]}}}
)";
  const std::string text = explained(statement);
  // m c^2 q'' = M, and the pull along the arm is -m c q'^2, across it m c q''.
  expect_pieces(section(text, "Unknowns, at any time"), {"\\ddot{q} &= \\frac{M}{m c^{2}}", "\\cos q"});
  const double rate = 1.5 / (3 * 0.04), q = rate * 0.16 / 2, speed = rate * 0.4;
  const double pull = -3 * 0.2 * (speed * speed * std::cos(q) + rate * std::sin(q));
  const Document document = Problem::from_text(statement, "blade.yaml").solve();
  EXPECT_NEAR(document.solutions.front().answers.front().columns.back().value.front(), pull, 1e-9);
}

TEST(ExplanationSteps, ATableOverADatumIsDerivedInLetters) {
  const std::string text = of_example("mechanisms/acceleration-over-the-slope");
  expect_pieces(text, {"\\Sigma F_{x}", "m g"});
}

TEST(ExplanationSteps, MomentaThatAreStatedGiveWhatIsToBeFound) {
  // H_x = m kx^2 (spin + precession cos(theta)), H_y = -m ky^2 precession sin(theta)
  const std::string text = of_example("textbook/18.011");
  expect_pieces(text, {"## Momentum", "What is known of the momenta gives an equation for $\\mathit{spin}$ alone",
                       "- \\mathit{precession} \\cos \\theta = 2.9081\\ \\mathrm{rad/s}",
                       "\\sin \\theta} = 0.0550738\\ \\mathrm{rad/s}"});
}

TEST(ExplanationSteps, OneLimitInTwoUnitsIsToldOnceAndDerived) {
  const std::string text = of_example("textbook/18.094");
  EXPECT_EQ(count_of(text, "Values of `w2` are tried"), 1U) << text;
  expect_pieces(text, {"## Component equations", "The lines below are those of the largest `w2`."});
}

TEST(ExplanationSteps, AnAngleIsFoundByItsCosineAndASizeByItsComponents) {
  expect_pieces(of_example("textbook/18.004"),
                {"\\cos a &= \\frac{\\mathbf{H}_{G}\\cdot\\mathbf{j}}{\\left|\\mathbf{H}_{G}\\right|} = 0.978",
                 "a &= 11.8757^{\\circ}"});
  expect_pieces(explained(R"(
points: {O: [0, 0, 0], A: [1 m, 0, 0]}
bodies: {bar: {rod: [O, A], mass: 2 kg}}
instants: {now: {velocity(A of bar): [0, 3 m/s, 0], velocity(bar): [0, 3 m/s, 4 m/s]}}
gravity: none
ask: {v: norm(velocity(bar))}
)"),
                {"v = \\left|\\mathbf{v}\\right| = \\sqrt{3^{2} + 4^{2}}\\ \\mathrm{m/s} = 5\\ \\mathrm{m/s}"});
}

// In text a power's sign stands for an accent, and alone is a mistake.
TEST(ExplanationSteps, PowersInWordsOfTheFileAreTypeset) {
  const std::string text = of_example("published/kovalevskaya");
  expect_pieces(text, {"\\texttt{(p\\^{}2 - q\\^{}2 - m*g*a/C*up1)\\^{}2}"});
}

// A joule would be one of a mass that nobody stated.
TEST(ExplanationSteps, WhatABodyOfAnyMassKeepsIsToldForAUnitOfIt) {
  const std::string text = of_example("textbook/18.C5");
  expect_pieces(text, {"(T + V)/m &= ", "H_{Z}/m &= ", "\\mathrm{m^{2}/s^{2}}"});
  EXPECT_EQ(section(text, "Motion through time").find("\\mathrm{J}"), std::string::npos) << text;
}

TEST(ExplanationSteps, WhatTheFirstSolutionSaidIsNotSaidAgain) {
  const std::string text = of_example("textbook/18.110");
  EXPECT_EQ(count_of(text, "As in solution 1."), count_of(text.substr(text.rfind("\n# ")), "As in solution 1."));
  // Sections that follow one another are named together.
  expect_pieces(text, {"\n## Model, Principle, Inertia", "\n\nAs in solution 1.\n"});
  EXPECT_EQ(count_of(text, "*cone* is a cone of any mass"), 1U);
}

TEST(ExplanationSteps, NothingIsSaidAcrossThePlaneOfAProblem) {
  const std::string text = of_example("mechanisms/planar-ladder-between-rough-walls");
  for (const char* piece : {"v}_{z}", "omega}_{x}", "omega}_{y}"})
    EXPECT_EQ(text.find(piece), std::string::npos) << piece << "\n" << text;
  // At rest what holds a body holds all of it, whatever single contacts say.
  expect_pieces(section(text, "Component equations"), {"Held by *floor* and *wall*, nothing begins to move there: "});
  EXPECT_EQ(count_of(section(text, "Component equations"), "Held by"), 1U);
  expect_pieces(text, {"*ladder* stays at rest: nothing stands on its kinetic side."});
}

// Which of two cases a magnitude is, is seen in the number alone.
TEST(ExplanationSteps, FormulasWithMagnitudesAreLeftOutBesideTheirNumbers) {
  const std::string text = of_example("textbook/18.067");
  EXPECT_EQ(text.find("\\left|\\mathit"), std::string::npos) << text;
  expect_pieces(text, {"B_{z} &= -3.35404\\ \\mathrm{lb}"});
}

// What is to be found has no number in the equations for it.
TEST(ExplanationSteps, DataAreShownWhenTheyAreFound) {
  const std::string text = of_example("textbook/18.034");
  const std::size_t found = text.find("\\mathit{tA} &= 1.84868");
  ASSERT_NE(found, std::string::npos) << text;
  EXPECT_EQ(text.find("36.97"), std::string::npos) << text;
  expect_pieces(section(text, "Impulses"), {"the impulse of *A*: $-F_{small} \\mathit{tA}\\,\\mathbf{j}$"});
  expect_pieces(section(text, "Unknowns"),
                {"*fired*: of *A*, *B*, *C* and *D*, exactly 2 act. What is known is met with *A* and *D*, so that "
                 "$\\mathit{tB} = 0$ and $\\mathit{tC} = 0$.",
                 "With what is known there remain equations for "});
  // A vector is found by its components.
  const std::string caught = of_example("mechanisms/box-caught-at-its-corner");
  expect_pieces(section(caught, "Impulses, after the blow"), {"J_{x}\\,\\mathbf{i} + J_{y}\\,\\mathbf{j}"});
  expect_pieces(section(caught, "Unknowns, after the blow"), {"J_{x} &= 22.8911\\ \\mathrm{kg\\,m/s}"});
}

// With both ends about to slip, N = W/(1 + mu^2) at the floor and mu N at the wall: moments give the man's place.
TEST(ExplanationSteps, ALimitOfStickingHasTheLawOfFriction) {
  const std::string text = of_example("mechanisms/ladder-between-rough-walls");
  const std::string limit = text.substr(text.find("\n## Friction, at the largest *s*\n"));
  expect_pieces(limit, {"*floor* and *wall* are about to slip, where Coulomb's law holds as an equality:",
                        "\\left|F_{\\mathrm{floor},x}\\right| &= \\mu\\,N_{\\mathrm{floor}} = "});
  const double weight = 90 * 9.80665, push = weight / (1 + 0.35 * 0.35);
  const auto number_behind = [&](const std::string& piece) {
    const std::size_t at = limit.find(piece);
    return at == std::string::npos ? 0 : std::stod(limit.substr(at + piece.size()));
  };
  EXPECT_NEAR(number_behind("N_{\\mathrm{floor}} &= "), push, 1e-5 * push);
  EXPECT_NEAR(number_behind("N_{\\mathrm{wall}} &= "), 0.35 * push, 1e-5 * push);
  EXPECT_NEAR(number_behind("F_{\\mathrm{wall},y} &= "), 0.35 * 0.35 * push, 1e-5 * push);
  // Before the limit one way in which both stick is told, and no law as an equality.
  const std::string here = section(text, "Friction");
  expect_pieces(here, {"one way in which all of them stick is"});
  EXPECT_EQ(here.find("about to slip"), std::string::npos);
}

// Of letters too: with W sin b - P cos b = mu (P sin b + W cos b) the least push is told.
TEST(ExplanationSteps, ALimitOfStickingInLettersHasTheLawOfFriction) {
  const std::string push = R"yaml(
plane: [x, y]
letters: {W: N, b: rad, mu: 1, P: N}
assume: [0 < b < 90 deg]
points: {G: [0, 0]}
bodies: {block: {particle: G, mass: W/g}}
contacts: {slope: {of: block, at: G, normal: "[-sin(b), cos(b)]", friction: mu}}
loads: {push: {force: [P, 0], body: block}}
gravity: -y
instants: {now: rest}
ask: {least: {smallest: P, while: sticking(slope)}}
)yaml";
  expect_pieces(section(explained(push), "Friction"),
                {"*slope* is about to slip, where Coulomb's law holds as an equality:",
                 "\\left|F_{\\mathrm{slope},2}\\right| &= \\mu\\,N",
                 "W \\sin b - P \\cos b &= \\mu\\,\\left(P \\sin b + W \\cos b\\right)"});
  const std::string jack = R"yaml(
letters: {W: N, r: m, p: m/rad, mu: 1, C: N*m}
points: {O: [0, 0, 0]}
bodies: {load: {mass: W/g, center: O, inertia: {axis: y, axial: 1 kg*m^2, transverse: 1 kg*m^2}}}
joints: {jack: {screw: y, at: O, to: load, pitch: p, rate: 0, couple: C, friction: {coefficient: mu, radius: r}}}
gravity: -y
instants: {now: rest}
ask: {raises: {largest: C, while: sticking(jack)}}
)yaml";
  expect_pieces(section(explained(jack), "Friction"),
                {"*jack* is about to move, where its friction is as large as it can be, $\\mu$ times the push of the "
                 "flanks at the mean radius of the thread:",
                 "\\left|M_{\\mathrm{jack}}\\right| = "});
}

// No part of a sentence without its number, and no number at values that nobody stated.
TEST(ExplanationSteps, EquationsWithoutFormulasInLettersAreNotShownInPart) {
  const std::string text = explained(R"yaml(
plane: [x, y]
letters: {m: kg, L: m, b: rad, u: m/s}
assume: [0 < b < 90 deg]
points: {A: [0, 0], B: [L*cos(b), L*sin(b)]}
bodies: {rod: {rod: [A, B], mass: m}}
impacts: {floor: {of: rod, at: A, pushes: y, restitution: 0, friction: 2}}
gravity: none
instants: {before: {velocity(rod): [0, -u], angular_velocity(rod): 0}}
ask: {w: angular_velocity(rod)}
)yaml");
  EXPECT_EQ(text.find("restitution ,"), std::string::npos) << text;
  EXPECT_EQ(text.find("is summed along the blow by Coulomb's law with $\\mu = 2$: $"), std::string::npos) << text;
}

// The equations at one limit are those at another: they stand once.
TEST(ExplanationSteps, WhatIsSaidOfOneLimitIsNotRepeatedOfAnother) {
  const std::string text = explained(R"yaml(
plane: [x, y]
letters: {W: N, b: rad, mu: 1, P: N}
assume: [0 < b < 90 deg]
points: {G: [0, 0]}
bodies: {block: {particle: G, mass: W/g}}
contacts: {slope: {of: block, at: G, normal: "[-sin(b), cos(b)]", friction: mu}}
loads: {push: {force: [P, 0], body: block}}
gravity: -y
instants: {now: rest}
ask:
  least: {smallest: P, while: sticking(slope)}
  most: {largest: P, while: sticking(slope)}
  N: normal_force(slope)
)yaml");
  EXPECT_EQ(count_of(text, "-\\sin b\\,N + \\cos b\\,F_{\\mathrm{slope},2} + P &= 0"), 1u) << text;
  expect_pieces(text, {"\n## Component equations, at the smallest *P*\n\nAs above.\n"});
}

// A_x = -W BC w1^2/g is an equation of components and its solution: it is said once.
TEST(ExplanationSteps, WhatTheComponentsSayIsNotSolvedAgain) {
  const std::string text = of_example("textbook/18.097");
  EXPECT_EQ(count_of(text, "A_{x} &= "), 1u) << text;
  EXPECT_EQ(section(text, "Unknowns"), "") << text;
  expect_pieces(section(text, "Component equations"), {"M_{A,z} &= "});
}

// The cord asks for the square of the bob's velocity, which only the motion tells.
TEST(ExplanationSteps, VelocitiesToWhichAMotionHasLedAreTold) {
  const std::string text = of_example("mechanisms/swinging-atwood");
  expect_pieces(
      section(text, "Kinetic side, at 0.5 s"),
      {"The motion has led *bob* to", "\\mathbf{v}_{G_{\\mathrm{bob}}} = (", "The motion has led *weight* to"});
  EXPECT_EQ(section(text, "Kinetic side, at the start").find("has led"), std::string::npos);
}

TEST(ExplanationSteps, EnergyRelativeToTheCenterHasItsOwnName) {
  const std::string text = of_example("textbook/18.047");
  expect_pieces(section(text, "Kinetic energy"), {"\nT = ", "\nT' = "});
}

TEST(ExplanationSteps, BothEndsOfASwingAreToldTogetherWhereLettersTellThemAlike) {
  const std::string text = of_example("textbook/18.133");
  EXPECT_EQ(count_of(text, "its rate vanishes"), 1u) << text;
  expect_pieces(text, {"Where $\\theta$ is largest or smallest its rate vanishes, and what is kept says:"});
}

TEST(ExplanationSteps, ThePrincipleOfStagesIsNotHowBodiesAreHeld) {
  expect_pieces(section(of_example("textbook/18.022"), "Principle"), {"In each stage the forces from outside"});
}

// L cos(b) w^2 = g (3 cos(b)^2 + 1) has no half angle, of which both terms had the sixth power of the cosine.
TEST(ExplanationSteps, TermsOfAFrequencyShareNoPowersOfHalfAngles) {
  const std::string text = of_example("mechanisms/conical-pendulum-on-a-ball-joint");
  EXPECT_EQ(section(text, "Small disturbances").find("\\frac{b}{2}"), std::string::npos) << text;
}

// What rests moves in no plane, and a particle has three equations.
TEST(ExplanationSteps, WhatRestsOrIsAParticleIsNotSaidToBeMore) {
  const std::string of_particles = of_example("mechanisms/hawser-round-a-bollard");
  expect_pieces(of_particles,
                {"Everything rests, and nothing is known to act across the $xy$ plane: of the three equations "
                 "of a particle the two of the plane are left."});
  EXPECT_EQ(of_particles.find("moves in the"), std::string::npos);
  expect_pieces(
      of_example("mechanisms/hinged-rods-on-ice"),
      {"Everything starts from rest, and nothing is known to act across the $xy$ plane: of the six equations"});
  expect_pieces(of_example("mechanisms/planar-disks-that-collide"),
                {"Everything moves in the $xy$ plane, and nothing is known to act across it: of the six equations"});
}

// Of a limit that is asked beside other things, the lines of the rest are not those at it.
TEST(ExplanationSteps, LimitsBesideOtherQuestionsHaveLinesOfTheirOwn) {
  const std::string text = of_example("mechanisms/stacked-blocks");
  expect_pieces(
      text, {"`sticking(mid)` and `sticking(floor)` no longer hold;", "\n## Component equations, at the largest *P*\n",
             "\n## Component equations, at the largest *P* of *starts*\n"});
  expect_pieces(text.substr(text.find("\n## Friction, at the largest *P* of *starts*\n")),
                {"*floor* is about to slip"});
}

TEST(ExplanationSteps, NumbersOfDataAreDecimals) {
  const std::string text = explained(R"yaml(
letters: {m: kg, L: m}
given: {g: 9.81 m/s^2}
points: {O: [0, 0, 0], A: [0, -L, 0]}
bodies: {bar: {rod: [O, A], mass: m}}
joints: {pin: {revolute: z, at: O, to: bar, angle: turn}}
gravity: [0, -g, 0]
claim: {motion: "turn'' == -3*g*sin(turn)/(2*L)"}
)yaml");
  expect_pieces(text, {"\\text{left} &= -\\frac{14.715 \\sin \\mathit{turn}}{L}"});
}

TEST(ExplanationSteps, DirectionsHaveTheirNames) {
  const std::string text = of_example("mechanisms/least-friction-on-an-incline");
  expect_pieces(text, {"F_{\\mathrm{slope},\\mathrm{down}} &= -m g \\sin b = -20.7223\\ \\mathrm{N}"});
}

// What rounding leaves of a motion is nothing, an apostrophe is no name, and nothing is told of a rod about itself.
TEST(ExplanationSteps, NothingIsToldOfRounding) {
  const std::string text = of_example("mechanisms/bar-that-lands-flat-on-two-supports");
  EXPECT_EQ(text.find("\\cdot 10^{-1"), std::string::npos) << text;
  EXPECT_EQ(text.find("omega}_{x}"), std::string::npos) << text;
  expect_pieces(text, {"whose blows change each other's have them together"});
  EXPECT_EQ(text.find("follow from how the bodies are held"), std::string::npos) << text;
}

// When a motion in letters does what depends on them.
TEST(ExplanationSteps, NothingIsToldOfLettersThatWereDrawn) {
  const std::string text = of_example("mechanisms/clutch-in-letters");
  EXPECT_NE(section(text, "Motion through time"), "");
  EXPECT_EQ(section(text, "Motion through time").find(" s on"), std::string::npos) << text;
}

// The start of a motion says nothing of the data that its end fixes.
TEST(ExplanationSteps, WhatIsFoundByAMotionIsToldWithIt) {
  const std::string text = of_example("mechanisms/friction-from-the-time-of-a-slide");
  expect_pieces(section(text, "Unknowns"), {"g \\cos b \\left(\\sin b - \\mu \\cos b\\right) \\\\"});
  EXPECT_EQ(section(text, "Unknowns").find("0.29"), std::string::npos) << text;
  expect_pieces(section(text, "Motion through time"), {"\\mu = 0.294758"});
}

// A ball of 1 kg falls on a floor at 4.905 m/s and leaves it with half of that: the impulse is 1.5 times 4.905.
TEST(ExplanationSteps, BlowsAlongAMotionAreMomentaBeforeImpulsesAndMomentaAfter) {
  const std::string text = explained(R"(
given: {m: 1 kg, h: 1.22625 m, g: 9.81 m/s^2}
points: {C: [0, 0, 0], G: [0, h, 0]}
bodies: {ball: {particle: G, mass: m}}
contacts: {floor: {of: ball, at: G, normal: y, open: true, surface: C, restitution: 0.5}}
gravity: -y
instants: {now: rest}
ask: {v: velocity(ball).y @ 0.6 s, u: velocity(ball).y @ 0.3 s}
)");
  expect_pieces(section(text, "Blow, at 0.5 s"), {"*floor* is struck at 0.5 s", "= -4.905\\ \\mathrm{m/s}"});
  expect_pieces(section(text, "Impulse and momentum, at 0.5 s"),
                {"Momenta before plus impulses equal momenta after", "-4.905 + F_{\\mathrm{floor}}\\Delta t",
                 "$0.5$ times the speed of approach"});
  expect_pieces(section(text, "Unknowns, at 0.5 s"), {"= 2.4525\\ \\mathrm{m/s}", "= 7.3575\\ \\mathrm{kg\\,m/s}"});
  // In the order of time.
  EXPECT_LT(text.find("at 0.3 s\n"), text.find("\n## Blow, at 0.5 s\n"));
  EXPECT_LT(text.find("\n## Blow, at 0.5 s\n"), text.rfind("at 0.6 s\n"));
}

// T1/T2 = e^(mu beta) with half a turn: a post holds 100 N by 100 N/e^(0.3 pi) = 38.967 N.
TEST(ExplanationSteps, CordsWithFrictionHaveTheRatioOfTheirTensions) {
  const std::string statement = R"(
given: {W: 100 N, mu: 0.3, r: 0.1 m, h: 1 m}
letters: {P: N}
points: {O: [0, 0, 0], A: [-r, -h, 0], B: [r, -h, 0]}
bodies: {load: {particle: A, mass: 1 kg}, hand: {particle: B, mass: 1 kg}}
cords: {rope: {from: load, at: A, over: [{O: {radius: r, friction: mu, side: +y}}], to: hand, end: B}}
loads: {pull: {force: [0, -W, 0], at: A, body: load}, hold: {force: [0, -P, 0], at: B, body: hand}}
gravity: none
instants: {now: rest}
ask: {least: {smallest: P, while: sticking(rope)}}
)";
  const std::string numbers = section(explained(statement), "Friction");
  expect_pieces(numbers, {"is about to slip on *O*", "\\beta &= ", "3.14159",
                          "\\frac{T_{1}}{T_{2}} &= e^{\\mu\\,\\beta} = 2.56633"});
  std::string in_letters = statement;
  in_letters.replace(in_letters.find("given: {W: 100 N, mu: 0.3, "), 27, "given: {");
  in_letters.replace(in_letters.find("letters: {"), 10, "letters: {W: N, mu: 1, ");
  expect_pieces(section(explained(in_letters), "Friction"),
                {"is about to slip on *O*", "\\frac{T_{1}}{T_{2}} &= e^{\\mu\\,\\beta}"});
}

// A journal that carries 500 N and 611.111 N turns beside its limit mu r R = 0.2*25 mm*1111.11 N.
TEST(ExplanationSteps, FrictionInJointsStandsBesideWhatItCanBe) {
  const std::string statement = R"(
given: {W: 500 N, D: 100 mm, d: 50 mm, mu: 0.2, P: 550 N}
points: {O: [0, 0, 0], A: [-D/2, 0, 0], B: [D/2, 0, 0]}
bodies: {pulley: {mass: 1 g, center: O, inertia: {axis: z, axial: 1 kg*mm^2, transverse: 1 kg*mm^2}}}
joints: {shaft: {revolute: z, at: O, to: pulley, rate: 0, friction: {coefficient: mu, radius: d/2}}}
loads: {load: {force: [0, -W, 0], at: A, body: pulley}, pull: {force: [0, -P, 0], at: B, body: pulley}}
gravity: none
)";
  expect_pieces(section(explained(statement + "ask: {R: reaction(shaft)}\n"), "Friction"),
                {"*shaft* holds, as its friction is less than it can be",
                 "= 2.5\\ \\mathrm{N\\,m} < 0.2\\cdot 0.025\\cdot 1050 = 5.25\\ \\mathrm{N\\,m}"});
  expect_pieces(section(explained(statement + "ask: {most: {largest: P, while: sticking(shaft)}}\n"), "Friction"),
                {"*shaft* is about to move", "= 0.2\\cdot 0.025\\cdot 1111.11 = 5.55556\\ \\mathrm{N\\,m}"});
}

// The cord leaves the drum on its left, at a point that has no name.
TEST(ExplanationSteps, APointWithoutNameIsToldByItsPlaceAndHasALetterOfItsOwn) {
  const std::string statement = R"(
plane: [x, y]
given: {m: 60 g, k: 18 mm, a: 5 mm}
points: {G: [0, 0], P: [-a, 0.8 m]}
bodies: {yoyo: {mass: m, center: G, radii_of_gyration: {z: k}}}
cords: {string: {from: ground, at: P, to: {yoyo: {side: -x, at: G, radius: a}}}}
gravity: -y
instants: {now: rest}
ask: {a: acceleration(yoyo), T: tension(string)}
)";
  expect_pieces(section(explained(statement), "Component equations"), {"moments about $Q$, at $-a\\,\\mathbf{i}"});
}

// Two pulleys that have nothing to do with each other: only what is asked of is cut free.
TEST(ExplanationSteps, BodiesOfWhichNothingIsAskedAreNotCutFree) {
  const std::string text = explained(R"(
given: {m: 2 kg, M: 3 kg, g: 9.81 m/s^2}
points: {A: [0, 0, 0], B: [1 m, 0, 0], C: [0, 1 m, 0], D: [1 m, 1 m, 0]}
bodies: {one: {particle: A, mass: m}, two: {particle: B, mass: M}}
cords: {left: {from: ground, at: C, to: one, end: A}, right: {from: ground, at: D, to: two, end: B}}
gravity: -y
instants: {now: rest}
ask: {T: tension(left)}
)");
  expect_pieces(text, {"Take *one* by itself."});
  EXPECT_EQ(count_of(text, "Take *two*"), 0U) << text;
}

}  // namespace explanation_steps_test
}  // namespace poinsot::document
