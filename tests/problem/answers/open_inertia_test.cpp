// Inertias of which only a part is stated: what depends on the rest has no answer, all else has one.
#include <gtest/gtest.h>

#include "problem/course/motion_support.h"

namespace poinsot::problem {
namespace open_inertia_test {

const std::string shaft =
    "points: {O: [0, 0, 0], A: [0, -1 m, 0], L: [0, 0, -1 m], R: [0, 0, 1 m]}\n"
    "joints: {pin: {revolute: L->R, to: bar, rate: 2 rad/s, accel: 0, supports: {L: [x, y, z], R: [x, y]}}}\n"
    "gravity: none\nask: {Hx: angular_momentum(bar about O).x, Hz: angular_momentum(bar about O).z, R: reaction(R), "
    "F: force(pin on bar)}\n";

TEST(OpenInertia, OfWhichNothingIsStated) {
  const SolvedText solved("title: t\nbodies: {bar: {mass: 2 kg, center: A}}\n" + shaft);
  for (const char* name : {"Hx", "Hz", "R"})
    EXPECT_NE(solved.reason(name).find("the inertia of 'bar', which is not stated"), std::string::npos)
        << name << solved.reason(name);
  EXPECT_NEAR(solved.vector("F").y, 2 * 4, 1e-12);
}

TEST(OpenInertia, TheRestHasProductsToo) {
  const SolvedText solved("title: t\nbodies: {bar: {mass: 2 kg, center: A, inertia: {z: 0.5 kg*m^2, rest: any}}}\n" +
                          shaft);
  for (const char* name : {"Hx", "R"})
    EXPECT_NE(solved.reason(name).find("given as `any`"), std::string::npos) << name << solved.reason(name);
  EXPECT_NEAR(solved.number("Hz"), (0.5 + 2) * 2, 1e-12);
  EXPECT_NEAR(solved.vector("F").y, 2 * 4, 1e-12);
}

TEST(OpenInertia, StatedProductsDecideWithOpenMoments) {
  const SolvedText solved(
      "title: t\nbodies: {bar: {mass: 2 kg, center: A, inertia: {about: O, yz: 0.3 kg*m^2, zx: 0, rest: any}}}\n" +
      shaft);
  EXPECT_NEAR(solved.number("Hx"), 0, 1e-12);
  // The couple about O is w^2 I_yz about -x or x: R_y - L_y carries it over 1 m each.
  EXPECT_NEAR(std::abs(solved.vector("R").y - 4), 4 * 0.3 / 2, 1e-12);
}

TEST(OpenInertia, OfABodyOfRevolutionOneMomentWillDo) {
  for (const char* stated : {"inertia: {axis: x, axial: 900 kg*m^2, transverse: any}",
                             "inertia: {axis: x, axial: 1e-9 kg*m^2, transverse: any}",
                             "radii_of_gyration: {axis: x, axial: 3 m, transverse: any}",
                             "inertia: {axis: x, axial: 1.9 kg*m^2, transverse: any}"}) {
    const SolvedText solved(std::string("title: t\npoints: {G: [0, 0, 0]}\nbodies: {r: {mass: 100 kg, center: G, ") +
                            stated +
                            "}}\njoints: {b: {revolute: x, at: G, to: r, rate: 10 rad/s}}\ngravity: none\n"
                            "ask: {H: angular_momentum(r about G), I: moment_of_inertia(r about x at G), "
                            "J: moment_of_inertia(r about y at G)}\n");
    EXPECT_NEAR(solved.vector("H").x, 10 * solved.number("I"), 1e-12 * solved.vector("H").x) << stated;
    EXPECT_NEAR(solved.vector("H").y, 0, 1e-15);
    solved.reason("J");
  }
}

TEST(OpenInertia, TheAxialMomentOrBothMayBeOpen) {
  for (const char* stated : {"axial: any, transverse: 3 kg*m^2", "axial: any, transverse: any"}) {
    const SolvedText solved(
        std::string("title: t\npoints: {G: [0, 0, 0], P: [0.1 m, 0, 0]}\nbodies: {r: {mass: 100 kg, "
                    "center: P, inertia: {axis: x, about: G, ") +
        stated +
        "}}}\njoints: {b: {revolute: x, at: G, to: r, rate: 10 rad/s}}\ngravity: none\n"
        "ask: {H: angular_momentum(r about G), p: momentum(r)}\n");
    solved.reason("H");
    EXPECT_NEAR(solved.vector("p").x, 0, 1e-12);
  }
}

TEST(OpenInertia, AllProductsMayBeOpen) {
  const SolvedText solved(
      "title: t\npoints: {G: [0, 0, 0]}\nbodies: {r: {mass: 100 kg, center: G, inertia: {x: 1 kg*m^2, y: 2 kg*m^2, "
      "z: 2.5 kg*m^2, xy: any, yz: any, zx: any}}}\njoints: {b: {revolute: x, at: G, to: r, rate: 10 rad/s}}\n"
      "gravity: none\nask: {H: angular_momentum(r about G).x, Hy: angular_momentum(r about G).y}\n");
  EXPECT_NEAR(solved.number("H"), 10, 1e-12);
  solved.reason("Hy");
}

// A thin plate has no products of inertia with its normal, whatever else is open.
TEST(OpenInertia, APlateStaysAPlate) {
  const SolvedText solved(
      "title: t\npoints: {G: [0, 0, 0]}\nbodies: {r: {mass: 100 kg, center: G, inertia: {x: 1 kg*m^2, y: 2 kg*m^2, "
      "z: 3 kg*m^2, rest: any}}}\njoints: {b: {revolute: z, at: G, to: r, rate: 10 rad/s}}\n"
      "gravity: none\nask: {H: angular_momentum(r about G)}\n");
  EXPECT_NEAR(solved.vector("H").z, 30, 1e-12);
  EXPECT_NEAR(solved.vector("H").x, 0, 1e-6);
}

}  // namespace open_inertia_test
}  // namespace poinsot::problem
