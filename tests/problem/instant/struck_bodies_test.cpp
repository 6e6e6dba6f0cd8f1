// Particles that strike: to whom their mass, momentum and energy belong before and after.
#include <gtest/gtest.h>

#include <cmath>

#include "problem/course/motion_support.h"

namespace poinsot::problem {
namespace struck_bodies_test {

using Vector = Vector3<double>;

std::string probe(const std::string& strike, const std::string& asks) {
  return "title: t\ngiven: {m: 1200 kg, mm: 150 g}\npoints: {G: [0, 0, 0], P: [2 m, -0.5 m, 1.2 m]}\n"
         "bodies: {probe: {mass: m, center: G, radii_of_gyration: {x: 1.1 m, y: 1.3 m, z: 0.9 m}}}\n"
         "strikes: {met: {mass: mm, hits: probe, at: P, velocity: [-1500 m/s, 2000 m/s, 700 m/s], " +
         strike + "}}\ninstants: {before: rest}\ngravity: none\nask: {" + asks + "}\n";
}

TEST(StruckBodies, TheSystemKeepsItsMomenta) {
  for (const char* strike : {"stays: true", "loses: 40 %"}) {
    const SolvedText solved(
        probe(strike,
              "p0: momentum(system) @ before, p: momentum(system), H0: angular_momentum(system about G) @ before, "
              "H: angular_momentum(system about G), m0: mass(system) @ before, m: mass(system), "
              "c0: center(system) @ before, c: center(system), v0: velocity(system) @ before, v: velocity(system)"));
    const Vector momentum = 0.15 * Vector{-1500, 2000, 700}, P{2, -0.5, 1.2};
    EXPECT_LT(norm(solved.vector("p0") - momentum), 1e-10) << strike;
    EXPECT_LT(norm(solved.vector("p") - momentum), 1e-10) << strike;
    EXPECT_LT(norm(solved.vector("H0") - cross(P, momentum)), 1e-9) << strike;
    EXPECT_LT(norm(solved.vector("H") - cross(P, momentum)), 1e-9) << strike;
    EXPECT_NEAR(solved.number("m0"), 1200.15, 1e-10);
    EXPECT_NEAR(solved.number("m"), 1200.15, 1e-10);
    EXPECT_LT(norm(solved.vector("c0") - (0.15 / 1200.15) * P), 1e-14);
    EXPECT_LT(norm(solved.vector("c") - (0.15 / 1200.15) * P), 1e-14);
    for (const char* velocity : {"v0", "v"})
      EXPECT_LT(norm(solved.vector(velocity) - momentum / 1200.15), 1e-13) << strike;
  }
}

// A bullet into a hinged door, and through one: what is lost is what it brings less what is left.
TEST(StruckBodies, TheEnergyThatIsLost) {
  const auto door = [](const std::string& strike) {
    return SolvedText(
        "title: t\npoints: {O: [0, 0, 0], A: [0, 2 m, 0], P: [0.7 m, 1.2 m, 0]}\n"
        "bodies: {door: {rectangle: {corners: [A, O, [0.9 m, 0, 0]]}, mass: 15 kg}}\n"
        "joints: {h: {revolute: y, at: O, to: door}}\n"
        "strikes: {bullet: {mass: 0.02 kg, hits: door, at: P, velocity: [0, 0, -400 m/s], " +
        strike +
        "}}\ninstants: {before: rest}\ngravity: none\nask: {w: angular_velocity(door).y, T: kinetic_energy(door), "
        "lost: kinetic_energy(system) @ before - kinetic_energy(system)}\n");
  };
  const double I = 15 * 0.81 / 3, J = I + 0.02 * 0.49;
  const SolvedText stays = door("stays: true");
  const double w = 0.02 * 400 * 0.7 / J;
  EXPECT_NEAR(stays.number("w"), w, 1e-12);
  EXPECT_NEAR(stays.number("T"), J * w * w / 2, 1e-12);
  EXPECT_NEAR(stays.number("lost"), 0.01 * 400 * 400 - J * w * w / 2, 1e-9);
  const SolvedText through = door("loses: 25 %");
  const double u = 0.02 * 100 * 0.7 / I;
  EXPECT_NEAR(through.number("w"), u, 1e-12);
  EXPECT_NEAR(through.number("lost"), 0.01 * (400 * 400 - 300 * 300) - I * u * u / 2, 1e-9);
  const SolvedText light = door("stays: true, mass_added: neglected");
  const double v = 0.02 * 400 * 0.7 / I;
  EXPECT_NEAR(light.number("lost"), 0.01 * 400 * 400 - I * v * v / 2, 1e-9);
}

TEST(StruckBodies, JustAfterIsTheStartOfTheMotion) {
  const SolvedText solved(
      "title: t\npoints: {O: [0, 0, 0], P: [0, -1 m, 0]}\nbodies: {bar: {rod: [O, P], mass: 3 kg}}\n"
      "joints: {h: {revolute: z, at: O, to: bar, angle: q}}\n"
      "strikes: {bullet: {mass: 0.5 kg, hits: bar, at: P, velocity: [12 m/s, 0, 0], stays: true}}\n"
      "instants: {before: rest}\ngravity: -y\n"
      "ask: {T: kinetic_energy(bar), T0: kinetic_energy(bar) @ 0 s, m: mass(bar), m0: mass(bar) @ 0 s, c: "
      "center(bar).y, "
      "c0: center(bar).y @ 0 s, v: velocity(bar).x, v0: velocity(bar).x @ 0 s, I: moment_of_inertia(bar about z at O), "
      "E: kinetic_energy(bar) + potential_energy(bar), E1: kinetic_energy(bar) @ 0.5 s + potential_energy(bar) @ 0.5 "
      "s, "
      "mb: mass(bar) @ before}\n");
  EXPECT_NEAR(solved.number("T"), 12, 1e-12);
  EXPECT_NEAR(solved.number("m"), 3.5, 1e-12);
  EXPECT_NEAR(solved.number("mb"), 3, 1e-12);
  EXPECT_NEAR(solved.number("I"), 1.5, 1e-12);
  EXPECT_NEAR(solved.number("c"), -2.0 / 3.5, 1e-12);
  for (const auto& [after, start] : {std::pair{"T", "T0"}, {"m", "m0"}, {"c", "c0"}, {"v", "v0"}, {"E", "E1"}})
    EXPECT_NEAR(solved.number(after), solved.number(start), 1e-9) << after;
}

TEST(StruckBodies, InLetters) {
  const SolvedText solved(
      "title: t\nletters: {m: kg, M: kg, L: m, v: m/s}\npoints: {O: [0, 0, 0], P: [0, -L, 0]}\n"
      "bodies: {bar: {rod: [O, P], mass: M}}\njoints: {h: {revolute: z, at: O, to: bar}}\n"
      "strikes: {bullet: {mass: m, hits: bar, at: P, velocity: [v, 0, 0], stays: true}}\n"
      "instants: {before: rest}\ngravity: none\nask: {T: kinetic_energy(bar), "
      "lost: kinetic_energy(system) @ before - kinetic_energy(system)}\n",
      {{"m", "2 kg"}, {"M", "3 kg"}, {"L", "1 m"}, {"v", "6 m/s"}});
  EXPECT_NEAR(solved.number("T"), 0.5 * 144 / 3, 1e-12);
  EXPECT_NEAR(solved.number("lost"), 36 - 0.5 * 144 / 3, 1e-12);
}

}  // namespace struck_bodies_test
}  // namespace poinsot::problem
