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
  EXPECT_GE(count_of(text, "As in solution 1."), 3U);
  EXPECT_EQ(count_of(text, "*cone* is a cone of any mass"), 1U);
}

TEST(ExplanationSteps, NothingIsSaidAcrossThePlaneOfAProblem) {
  const std::string text = of_example("mechanisms/planar-ladder-between-rough-walls");
  for (const char* piece : {"v}_{z}", "omega}_{x}", "omega}_{y}"})
    EXPECT_EQ(text.find(piece), std::string::npos) << piece << "\n" << text;
  EXPECT_EQ(count_of(text, "What holds the bodies says"), 1U);
}

// Which of two cases a magnitude is, is seen in the number alone.
TEST(ExplanationSteps, FormulasWithMagnitudesAreLeftOutBesideTheirNumbers) {
  const std::string text = of_example("textbook/18.067");
  EXPECT_EQ(text.find("\\left|\\mathit"), std::string::npos) << text;
  expect_pieces(text, {"B_{z} &= -3.35404\\ \\mathrm{lb}"});
}

}  // namespace explanation_steps_test
}  // namespace poinsot::document
