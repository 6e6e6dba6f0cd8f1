// Worked solutions say of each quantity what it belongs to, by which terms it is found, and say it once.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "poinsot/problem.h"
#include "poinsot/rendering.h"

namespace poinsot::document {
namespace explanation_quantities_test {

std::string explained(const std::string& statement) {
  return to_markdown(Problem::from_text(statement, "explained.yaml").explain());
}
std::string of_example(const std::string& name) {
  return to_markdown(Problem::from_file(std::string(POINSOT_SOURCE_DIR "/examples/") + name + ".yaml").explain());
}
bool says(const std::string& text, const std::string& piece) { return text.find(piece) != std::string::npos; }
void expect_pieces(const std::string& text, const std::vector<std::string>& pieces) {
  for (const std::string& piece : pieces) EXPECT_TRUE(says(text, piece)) << piece << "\n" << text;
}

TEST(ExplainedQuantities, SidesOfClaimsAreThoseOfWhichComparisonAndComponent) {
  expect_pieces(of_example("textbook/18.014"),
                {"In letters the $x$ components of its sides are", "In letters the $y$ components of its sides are"});
  expect_pieces(of_example("textbook/18.145"),
                {"In letters the sides of `gamma < theta` are", "In letters the sides of `psidot*w.z > 0` are"});
}

TEST(ExplainedQuantities, KineticEnergyIsTheSumOfTheTermsThatThereAre) {
  // About the fixed point, of which the moments of inertia are told already.
  const std::string bent = of_example("mechanisms/bent-bar-on-a-ball-joint-is-struck");
  expect_pieces(bent,
                {"The point $O$ of *L* is at rest: its kinetic energy is $T = "
                 "\\tfrac12\\,\\boldsymbol{\\omega}\\cdot I_{O}\\,\\boldsymbol{\\omega}$ (Eqs. 18.18 to 18.20):"});
  EXPECT_FALSE(says(bent, "inertia about $G$"));
  const std::string atwood = of_example("mechanisms/atwood-with-a-heavy-wheel");
  expect_pieces(atwood, {"Its kinetic energy is $T = \\tfrac12 m v_{G_{\\mathrm{light}}}^2$:",
                         "Its kinetic energy is $T = \\tfrac12 I_{z}\\,\\omega^2$, as its mass center is at rest"});
  EXPECT_FALSE(says(atwood, "I_{x} &="));
  // A rod that is struck in its middle only moves along.
  expect_pieces(explained(R"(
given: {m: 2 kg, L: 1 m, J: 3 N*s}
points: {A: [0, 0, 0], B: [L, 0, 0], C: [L/2, 0, 0]}
bodies: {rod: {rod: [A, B], mass: m}}
impulses: {hit: {body: rod, at: C, value: [0, J, 0]}}
gravity: none
instants: {before: rest}
ask: {T: kinetic_energy(rod)}
)"),
                {"$T = \\tfrac12 m v_{G}^2$, as it does not turn (Eq. 18.17):"});
}

TEST(ExplainedQuantities, WhatIsNotDeterminedIsNotShown) {
  const std::string text = explained(R"(
given: {m: 2 kg, I: 3 kg*m^2, w: 4 rad/s}
bodies: {ball: {mass: m, center: [0, 0, 0], inertia: {axis: x, axial: I, transverse: 2*I}}}
gravity: none
instants: {now: {angular_velocity(ball): [w, 0, 0]}}
ask: {T: kinetic_energy(ball), H: angular_momentum(ball about center(ball))}
)");
  EXPECT_TRUE(says(text, "H_{x} = I_{x}\\omega_{x}")) << text;
  EXPECT_FALSE(says(text, "\\mathbf{v}_{G} = \\mathbf{0}")) << text;
  EXPECT_FALSE(says(text, "T =")) << text;
}

TEST(ExplainedQuantities, PointsOfBodiesAreReachedFromTheMassCenter) {
  expect_pieces(of_example("mechanisms/hinged-rods-on-ice"),
                {"The point $C$ of *two*:", "\\mathbf{r}_{C/G_{\\mathrm{two}}} &= \\frac{L}{2}\\,\\mathbf{i}",
                 "\\mathbf{a}_{C} &= \\mathbf{a}_{G_{\\mathrm{two}}} + "
                 "\\boldsymbol{\\alpha}_{\\mathrm{two}}\\times\\mathbf{r}_{C/G_{\\mathrm{two}}} = "
                 "\\frac{7 P}{2 m}\\,\\mathbf{j} = 21\\,\\mathbf{j}"});
  // Where the bead leaves the ball.
  expect_pieces(
      of_example("mechanisms/bead-on-a-ball"),
      {"The motion has led *bead* to\n\n$$\n\\mathbf{r}_{G} = (0.377146\\,\\mathbf{i} + 0.328269\\,\\mathbf{j})"});
}

TEST(ExplainedQuantities, ComponentsAreProductsWithADirection) {
  const std::string text = explained(R"(
given: {m: 3 kg, b: 40 deg}
points: {C: [0, 0, 0]}
directions: {out: '[sin(b), cos(b), 0]', down: '[cos(b), -sin(b), 0]'}
bodies: {block: {particle: C, mass: m}}
contacts: {slope: {of: block, at: C, normal: out}}
gravity: -y
instants: {now: rest}
ask: {a: component(acceleration(block) along down)}
)");
  expect_pieces(text, {"\\mathbf{e} &= (0.766044\\,\\mathbf{i} - 0.642788\\,\\mathbf{j})",
                       "a &= \\mathbf{a}\\cdot\\mathbf{e} = 4.82883\\cdot 0.766044 + 4.05187\\cdot 0.642788",
                       "touching at contact *slope* along out:",
                       "$N$ along $\\sin b\\,\\mathbf{i} + \\cos b\\,\\mathbf{j} = (0.642788\\,\\mathbf{i} + "
                       "0.766044\\,\\mathbf{j})$"});
}

TEST(ExplainedQuantities, PartsWithoutMassHaveNoRow) {
  const std::string text = explained(R"(
given: {m: 3 kg, r: 0.2 m}
points: {O: [0, 0, 0], Z: [0, 0, 1 m]}
bodies:
  wheel: {disk: {center: O, normal: z, radius: r}, mass: m, added: {rim: {ring: {center: O, normal: z, radius: r}, mass: 0 kg}}}
ask: {I: moment_of_inertia(wheel about O->Z)}
)");
  EXPECT_FALSE(says(text, "by its parts")) << text;
}

// Matrices of a castor: the side force on its wheel keeps it from slipping.
TEST(ExplainedQuantities, ConstraintsStandBesideTheEquationsNearASteadyMotion) {
  expect_pieces(of_example("mechanisms/castor-that-shimmies"),
                {"= \\mathbf{W}\\,\\mathbf{y}",
                 "\\mathbf{J}\\,\\dot{\\boldsymbol{\\xi}} + \\mathbf{B}\\,\\boldsymbol{\\xi} &= "
                 "\\mathbf{0}",
                 "\\lambda^{3}"});
}

}  // namespace explanation_quantities_test
}  // namespace poinsot::document
