// Motions in which the direction of a slip turns, against closed forms and integrals of the motion.
#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <random>

#include "problem/course/motion_support.h"

namespace poinsot::problem {
namespace turning_slip_test {

constexpr double g = 9.80665;

std::string puck(double b, double mu, const Vector3<double>& v, const std::string& asks) {
  return fmt::format(
      "given: {{b: {} rad}}\npoints: {{C: [0, 0, 0]}}\n"
      "directions: {{down: [cos(b), -sin(b), 0], out: [sin(b), cos(b), 0]}}\n"
      "bodies: {{puck: {{particle: C, mass: 2 kg}}}}\n"
      "contacts: {{slope: {{of: puck, at: C, normal: out, friction: {}}}}}\ngravity: -y\n"
      "instants: {{start: {{velocity(puck): '({} m/s)*down + ({} m/s)*z'}}}}\nask: {{{}}}\n",
      b, mu, v.x, v.z, asks);
}

// With k = mu/tan(b) and s = tan(f/2), f from the line of slope: u sin f = C s^k, and from f until it rests the time is
// C/(2 g sin b) (s^(k-1)/(k-1) + s^(k+1)/(k+1)).
TEST(TurningSlip, APuckAcrossAnInclineStopsWhenTheHodographSays) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> slope(0.1, 0.8), ratio(1.2, 5), start(0.4, 2.6), speed(1, 5);
  for (int trial = 0; trial < 8; ++trial) {
    const double b = slope(random), k = ratio(random), f = start(random), u = speed(random), s = std::tan(f / 2);
    const double C = u * std::sin(f) / std::pow(s, k), A = g * std::sin(b);
    const double stops = C / (2 * A) * (std::pow(s, k - 1) / (k - 1) + std::pow(s, k + 1) / (k + 1));
    const double across =
        C * C / (2 * A) * (std::pow(s, 2 * k - 1) / (2 * k - 1) + std::pow(s, 2 * k + 1) / (2 * k + 1));
    const double down = C * C / (4 * A) * (std::pow(s, 2 * k - 2) / (2 * k - 2) - std::pow(s, 2 * k + 2) / (2 * k + 2));
    const SolvedText solved(puck(
        b, k * std::tan(b), {u * std::cos(f), 0, u * std::sin(f)},
        fmt::format("t: {{first_time: sticking(slope)}}, p: position(puck) @ {} s, F: friction(slope on puck) @ {} s",
                    2 * stops, 2 * stops)));
    EXPECT_NEAR(solved.number("t"), stops, 1e-8 * stops) << b << " " << k << " " << f;
    const Vector3<double> p = solved.vector("p");
    EXPECT_NEAR(p.z, across, 1e-8 * (1 + across)) << b << " " << k << " " << f;
    EXPECT_NEAR(p.x * std::cos(b) - p.y * std::sin(b), down, 1e-8 * (1 + across)) << b << " " << k << " " << f;
    // At rest friction holds what gravity pulls down the slope.
    EXPECT_NEAR(norm(solved.vector("F")), 2 * g * std::sin(b), 1e-7);
  }
}

// Less friction than holds it at rest: it never stops, and the integral of the hodograph stays.
TEST(TurningSlip, APuckTurnsDownwardsAndGoesOn) {
  std::mt19937 random(12);
  std::uniform_real_distribution<double> slope(0.2, 0.8), ratio(0.1, 0.95), start(0.4, 2.6), speed(1, 5);
  for (int trial = 0; trial < 6; ++trial) {
    const double b = slope(random), k = ratio(random), f = start(random), u = speed(random);
    const SolvedText solved(
        puck(b, k * std::tan(b), {u * std::cos(f), 0, u * std::sin(f)}, "v: velocity(puck) @ 0.7 s"));
    const Vector3<double> v = solved.vector("v");
    const double later = std::atan2(v.z, v.x * std::cos(b) - v.y * std::sin(b));
    const double before = u * std::sin(f) / std::pow(std::tan(f / 2), k);
    EXPECT_LT(later, f);
    EXPECT_NEAR(norm(v) * std::sin(later) / std::pow(std::tan(later / 2), k), before, 1e-8 * before);
  }
}

// The slip of a ball obeys the law of a puck with 1 + 1/c times the friction, c m r^2 the moment of inertia.
TEST(TurningSlip, ABallAcrossAnInclineBeginsToRoll) {
  std::mt19937 random(13);
  std::uniform_real_distribution<double> slope(0.1, 0.5), ratio(1.3, 3), start(0.4, 2.6), speed(1, 4), rate(-5, 5);
  constexpr double r = 0.1;
  for (int trial = 0; trial < 5; ++trial) {
    const double b = slope(random), k = ratio(random), f = start(random), u = speed(random), w = rate(random);
    const double s = std::tan(f / 2), C = u * std::sin(f) / std::pow(s, k), A = g * std::sin(b);
    const double T = C / (2 * A) * (std::pow(s, k - 1) / (k - 1) + std::pow(s, k + 1) / (k + 1));
    const double mu = 2.0 / 7 * k * std::tan(b);
    // Thrown with a pivoting spin, which changes nothing, and no other.
    const SolvedText solved(fmt::format(
        "given: {{b: {} rad, r: 0.1 m}}\npoints: {{C: [0, 0, 0], G: [r*sin(b), r*cos(b), 0]}}\n"
        "directions: {{down: [cos(b), -sin(b), 0], out: [sin(b), cos(b), 0]}}\n"
        "bodies: {{ball: {{sphere: {{center: G, radius: r}}, mass: 3 kg}}}}\n"
        "contacts: {{slope: {{of: ball, at: C, normal: out, friction: {}}}}}\ngravity: -y\n"
        "instants: {{start: {{velocity(ball): '({} m/s)*down + ({} m/s)*z', angular_velocity(ball): '({} "
        "rad/s)*out'}}}}\n"
        "ask: {{t: {{first_time: sticking(slope)}}, v: velocity(ball) @ {} s, w: angular_velocity(ball) @ {} s}}\n",
        b, mu, u * std::cos(f), u * std::sin(f), w, 1.5 * T, 1.5 * T));
    EXPECT_NEAR(solved.number("t"), T, 1e-8 * T);
    const Vector3<double> down{std::cos(b), -std::sin(b), 0}, out{std::sin(b), std::cos(b), 0}, z{0, 0, 1};
    const Vector3<double> expected = 5.0 / 7 * (u * std::cos(f) * down + u * std::sin(f) * z + (A * 1.5 * T) * down);
    EXPECT_NEAR(norm(solved.vector("v") - expected), 0, 1e-7 * norm(expected));
    EXPECT_NEAR(dot(solved.vector("w"), out), w, 1e-8);
    EXPECT_NEAR(norm(cross(solved.vector("w"), r * out) - expected), 0, 1e-6 * norm(expected));
  }
}

// Free to turn on a frictionless axle, table and puck keep the angular momentum about it while they rub.
TEST(TurningSlip, ATableTakesAPuckAlong) {
  const double I = 0.5 * 20 * 0.49, m = 0.5, mu = 0.2;
  const SolvedText solved(
      "given: {R: 0.7 m}\npoints: {O: [0, 0, 0], T: [0, 0, -10 mm], C: [0.3 m, 0, 0]}\n"
      "bodies:\n  table: {cylinder: {center: T, axis: z, radius: R, length: 20 mm}, mass: 20 kg}\n"
      "  puck: {particle: C, mass: 0.5 kg}\n"
      "joints: {axle: {revolute: z, at: O, to: table, rate: 2 rad/s}}\n"
      "contacts: {top: {of: puck, against: table, at: C, normal: z, friction: 0.2}}\ngravity: -z\n"
      "facts: {velocity(puck): [0, 0, 0]}\n"
      "ask: {H: angular_momentum(system about O).z @ 0.2 s, a: acceleration(puck) @ 0.2 s, "
      "u: slip_velocity(top) @ 0.2 s, E: kinetic_energy(system) @ 0.5 s}\n");
  EXPECT_NEAR(solved.number("H"), I * 2, 1e-8);
  EXPECT_NEAR(norm(solved.vector("a") + mu * g * normalized(solved.vector("u"))), 0, 1e-8);
  // Carried along at its radius the two would have this energy; what is beyond went into heat or is still slip.
  EXPECT_LT(solved.number("E"), 0.5 * I * 4);
  EXPECT_GT(solved.number("E"), 0.5 * (I * 2) * (I * 2) / (I + m * 0.49));
}

// A slip that leaves its line by less than is seen counts as one on its line for the second road, too: beside a wind of
// a millionth of the weight a ball rolls when and as fast as without it.
TEST(TurningSlip, ThatIsTooLittleToBeSeenIsNone) {
  int winds = 0;
  for (const double wind : {1e-8, 1e-7, 2e-7, 4e-7, 8e-7}) {
    const SolvedText solved(
        fmt::format("title: t\npoints: {{C: [0, 0, 0], G: [0, 0.11 m, 0]}}\n"
                    "bodies: {{ball: {{sphere: {{center: G, radius: 0.11 m}}, mass: 6 kg}}}}\n"
                    "contacts: {{lane: {{of: ball, at: C, normal: y, friction: 0.12}}}}\ngravity: -y\n"
                    "facts: {{velocity(ball): [5 m/s, 0, 0], angular_velocity(ball): [0, 0, 0]}}\n"
                    "loads: {{wind: {{force: [0, 0, {} N], at: G, body: ball}}}}\n"
                    "ask: {{rolls: {{first_time: sticking(lane)}}, v: velocity(ball).x @ 2 s}}\n",
                    wind));
    EXPECT_NEAR(solved.number("rolls"), 2 * 5 / (7 * 0.12 * g), 1e-6) << wind;
    EXPECT_NEAR(solved.number("v"), 5 * 5.0 / 7, 1e-6) << wind;
    ++winds;
  }
  EXPECT_EQ(winds, 5);
}

// On a sphere of ten kilometers a ball with spin slides as on a plane.
TEST(TurningSlip, OnAVeryLargeSphereIsThatOnAPlane) {
  const std::string motion =
      "gravity: -y\nfacts: {velocity(ball): [0, 0, 3 m/s], angular_velocity(ball): [0, 10 rad/s, 0]}\n"
      "ask: {rolls: {first_time: sticking(lane)}, v: norm(velocity(ball)) @ 2 s}\n";
  const std::string ball =
      "title: t\npoints: {C: [0, 0, 0], G: [0, 0.11 m, 0], O: [0, -10 km, 0]}\nbodies: {ball: {sphere: {center: G, "
      "radius: 0.11 m}, mass: 6 kg}";
  const SolvedText sphere(ball +
                          ", earth: {sphere: {center: O, radius: 10 km}, mass: 0 kg}}\njoints: {stand: {weld: O, to: "
                          "earth}}\ncontacts: {lane: {of: ball, against: earth, at: C, normal: y, friction: 0.12}}\n" +
                          motion);
  const double rolls = 2 * 3 / (7 * 0.12 * g);
  EXPECT_NEAR(sphere.number("rolls"), rolls, 2e-3 * rolls);
  EXPECT_NEAR(sphere.number("v"), 3 * 5.0 / 7, 0.02);
}

}  // namespace turning_slip_test
}  // namespace poinsot::problem
