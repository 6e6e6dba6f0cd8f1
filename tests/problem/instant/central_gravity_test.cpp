// Gravity towards a center, against closed forms by hand, uniform gravity far from the center, and its messages.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>

#include "problem/course/motion_support.h"

namespace poinsot::problem {
namespace central_gravity_test {

std::string satellite(const std::string& gravity, const std::string& more) {
  return "title: t\npoints: {O: [0, 0, 0], G: [3000 km, 5000 km, -4000 km]}\nbodies: {sat: {mass: 40 kg, center: G, "
         "inertia: {x: 30 kg*m^2, y: 50 kg*m^2, z: 45 kg*m^2, xy: 4 kg*m^2, yz: -3 kg*m^2, zx: 2 kg*m^2}}}\ngravity: " +
         gravity + "\n" + more;
}

TEST(CentralGravity, CoupleIsThatOfTheMomentsOfInertia) {
  const SolvedText solved(satellite("{toward: O, parameter: 398600 km^3/s^2}",
                                    "instants: {now: rest}\nask: {M: couple(gravity on sat about G), a: "
                                    "angular_acceleration(sat), W: weight(sat), V: potential_energy(sat)}\n"));
  const double mu = 398600e9, r = std::sqrt(50.0) * 1e6;
  const Vector3<double> u{3 / std::sqrt(50.0), 5 / std::sqrt(50.0), -4 / std::sqrt(50.0)};
  // Products of inertia are integrals of x y dm: they enter the tensor with the other sign.
  const Vector3<double> I_u{30 * u.x - 4 * u.y - 2 * u.z, -4 * u.x + 50 * u.y + 3 * u.z, -2 * u.x + 3 * u.y + 45 * u.z};
  const Vector3<double> M = (3 * mu / (r * r * r)) * cross(u, I_u), found = solved.vector("M");
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(found[k], M[k], 1e-9 * norm(M));
  EXPECT_NEAR(solved.number("W"), 40 * mu / (r * r), 1e-9 * 40 * mu / (r * r));
  EXPECT_NEAR(solved.number("V"), -40 * mu / r, 1e-9 * 40 * mu / r);
  // I alpha = M at rest.
  const Vector3<double> a = solved.vector("a");
  EXPECT_NEAR(30 * a.x - 4 * a.y - 2 * a.z, M.x, 1e-9 * norm(M));
  EXPECT_NEAR(-4 * a.x + 50 * a.y + 3 * a.z, M.y, 1e-9 * norm(M));
  EXPECT_NEAR(-2 * a.x + 3 * a.y + 45 * a.z, M.z, 1e-9 * norm(M));
}

// From far below, a center pulls as uniform gravity does.
TEST(CentralGravity, FarAwayIsUniform) {
  const auto pendulum = [](const std::string& gravity) {
    return "title: t\npoints: {O: [0, 0, 0], C: [0, 0, -1e7 m], A: [0.8 m, 0, 0.3 m]}\nbodies: {rod: {rod: [O, A], "
           "mass: 2 "
           "kg}}\njoints: {pin: {revolute: y, at: O, to: rod, angle: q, rate: 0.4 rad/s}}\ngravity: " +
           gravity + "\nask: {a: angular_acceleration(rod), q: q @ 0.7 s, R: reaction(pin), P: period(q)}\n";
  };
  const SolvedText far(pendulum("{toward: C, parameter: 9.80665e14 m^3/s^2}")), uniform(pendulum("-z"));
  EXPECT_NEAR(far.vector("a").y, uniform.vector("a").y, 1e-6 * std::abs(uniform.vector("a").y));
  EXPECT_NEAR(far.number("q"), uniform.number("q"), 2e-6);
  EXPECT_NEAR(far.number("P"), uniform.number("P"), 1e-6 * uniform.number("P"));
  EXPECT_NEAR(far.vector("R").z, uniform.vector("R").z, 1e-6 * norm(uniform.vector("R")));
}

TEST(CentralGravity, TellsHowExactlyItIsKnown) {
  const auto notes = [](const std::string& body) {
    const SolvedText solved("title: t\npoints: {O: [0, 0, 0], A: [100 m, 0, 0], B: [103 m, 4 m, 0]}\nbodies: {it: {" +
                            body +
                            ", mass: 3 kg}}\ngravity: {toward: O, parameter: 5 m^3/s^2}\ninstants: {now: rest}\nask: "
                            "{F: force(gravity on it)}\n");
    solved.vector("F");
    return solved.notes().empty() ? std::string() : solved.notes().front();
  };
  EXPECT_EQ(notes("particle: A"), "gravity pulls 'it' exactly, as particles and spheres are");
  EXPECT_EQ(notes("sphere: {center: A, radius: 2 m}"), "gravity pulls 'it' exactly, as particles and spheres are");
  // J = m l^2/12, s = l/2, e = s/r; the first term of what is left out of the force is at most 4 J e/(m r^2).
  const std::string rod = notes("rod: [A, B]");
  EXPECT_NE(rod.find("by its moments of inertia, to the second order"), std::string::npos) << rod;
  EXPECT_NE(rod.find("at most 2e-05 of the pull"), std::string::npos) << rod;
}

TEST(CentralGravity, RefusesWhatItDoesNotKnow) {
  const auto refused = [](const std::string& gravity, const std::string& more = "ask: {W: weight(sat)}\n") {
    return failure_of_text(satellite(gravity, "instants: {now: rest}\n" + more));
  };
  EXPECT_NE(refused("{toward: O, parameter: -3 m^3/s^2}").find("is positive"), std::string::npos);
  EXPECT_NE(refused("{toward: O, parameter: 3 m/s^2}").find("expected"), std::string::npos);
  EXPECT_NE(refused("{toward: G, parameter: 3 m^3/s^2}").find("in the middle of body 'sat'"), std::string::npos);
  EXPECT_NE(refused("{toward: [3000 km, 5000 km, -3999999.5 m], parameter: 3 m^3/s^2}").find("within body 'sat'"),
            std::string::npos);
  EXPECT_NE(refused("{towards: O, parameter: 3 m^3/s^2}").find("unknown key 'towards'"), std::string::npos);
  EXPECT_NE(refused("{toward: O}").find("parameter"), std::string::npos);
  EXPECT_NE(refused("{toward: O, parameter: 3 m^3/s^2}",
                    "loads: {gravity: {body: sat, force: [1 N, 0, 0]}}\n"
                    "ask: {W: weight(sat)}\n")
                .find("is the name of the pull of the center"),
            std::string::npos);
  EXPECT_NE(refused("{toward: O, parameter: 3 m^3/s^2}",
                    "strikes: {dart: {hits: sat, at: G, mass: 1 kg, velocity: [1 m/s, 0, 0], stays: true}}\n"
                    "ask: {W: weight(sat)}\n")
                .find("is not pulled by the center"),
            std::string::npos);
}

// Near a steady motion a center must rest in its frame.
TEST(CentralGravity, LeavesNoSteadyMotionAboutAnotherAxis) {
  const SolvedText solved(
      "title: t\npoints: {O: [0, 0, 0], C: [0, 0.1 m, 0], A: [1 m, 0, 0]}\nbodies: {bead: {particle: A, mass: 1 kg}}\n"
      "frames: {table: {turns: z, rate: 2 rad/s}}\njoints: {slot: {prismatic: x, at: A, from: table, to: bead, rate: "
      "0}}\n"
      "gravity: {toward: C, parameter: 4 m^3/s^2}\nsteady: {frame: table}\nask: {f: frequencies(bead)}\n");
  EXPECT_NE(solved.reason("f").find("does not rest in the frame"), std::string::npos) << solved.reason("f");
}

TEST(CentralGravity, IsFeltByMomentsInThePlane) {
  EXPECT_NE(
      failure_of_text("title: t\nplane: [x, y]\npoints: {O: [0, 0], G: [9 m, 0]}\nbodies: {b: {mass: 1 kg, center: "
                      "G, inertia: {z: 2 kg*m^2}}}\ngravity: {toward: O, parameter: 3 m^3/s^2}\ninstants: {now: "
                      "rest}\nask: {W: weight(b)}\n")
          .find("leaves out x"),
      std::string::npos);
}

// However far: what turns on joints is as large as itself, and the couples on what is carried round are those of the
// differences of the pull, -(3/2) n^2 J sin 2b with the transverse moment J = m l^2/12 of a rod.
TEST(CentralGravity, BodiesAreSmallBesideTheWayToItsCenter) {
  const auto hung = [](const std::string& gravity) {
    return "title: t\npoints: {P: [0.1 m, 0.6 m, -0.9 m], C: 'P + [0.1 m, -0.2 m, 0.1 m]', far: [0, -1e10 m, 0]}\n"
           "bodies: {hoop: {ring: {center: C, normal: [-3, 1, -3], radius: 0.1 m}, mass: 4 kg}}\n"
           "joints: {j: {universal: [x, z], at: P, to: hoop, freedoms: {first: {angle: p}, second: {angle: q}}}}\n"
           "gravity: " +
           gravity +
           "\ninstants: {start: {p: 0.8 rad, p': -0.4 rad/s, q: 0.2 rad, q': 1 rad/s}}\n"
           "ask: {a: angular_acceleration(hoop), f: force(j on hoop)}\n";
  };
  const SolvedText far(hung("{toward: far, parameter: 9.80665e20 m^3/s^2}")), uniform(hung("-y"));
  for (const char* ask : {"a", "f"})
    EXPECT_LE(norm(far.vector(ask) - uniform.vector(ask)), 1e-8 * norm(uniform.vector(ask))) << ask;
  for (const double r : {1e9, 1e10, 1.5e11}) {
    const SolvedText carried(fmt::format(
        "title: t\ngiven: {{r: {} m, n: 1e-3 rad/s, m: 40 kg, l: 1 m, b: 20 deg}}\n"
        "points: {{O: [-r, 0, 0], G: [0, 0, 0], A: [l/2, 0, 0], B: [-l/2, 0, 0], C: [0, 3 m, 0],"
        " D: '[l*cos(b)/2, 3 m + l*sin(b)/2, 0]', E: '[-l*cos(b)/2, 3 m - l*sin(b)/2, 0]'}}\n"
        "bodies: {{bar: {{rod: [A, B], mass: m}}, tilted: {{rod: [D, E], mass: m}}}}\n"
        "frames: {{orbit: {{origin: O, turns: z, rate: n}}}}\n"
        "joints: {{swings: {{revolute: z, at: G, from: orbit, to: bar, angle: q}}, held: {{weld: C, from: orbit, to: "
        "tilted}}}}\n"
        "gravity: {{toward: O, parameter: n^2*r^3}}\nsteady: {{frame: orbit}}\n"
        "ask: {{f: frequencies(bar), M: couple(gravity on tilted about C).z}}\n",
        r));
    EXPECT_NEAR(carried.found("f").value.items.at(0).number, std::sqrt(3.0) * 1e-3, 1e-9) << r;
    const double couple = -1.5e-6 * 40 / 12.0 * std::sin(40 * M_PI / 180);
    EXPECT_NEAR(carried.number("M"), couple, 1e-6 * std::abs(couple)) << r;
  }
}

}  // namespace central_gravity_test
}  // namespace poinsot::problem
