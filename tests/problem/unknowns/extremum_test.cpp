// The ends of the values of a datum for which something holds: what ends there.
#include <gtest/gtest.h>

#include <cmath>

#include "problem/course/motion_support.h"

namespace poinsot::problem {
namespace {

constexpr double g = 9.81;

// A sleeping top: I^2 s^2 > 4 J m g c, and moments about its center that a body may have: 2 (J - m c^2) > I.
std::string sleeping_top(double s, const std::string& ask) {
  return "title: t\ngiven: {I: 0.0006 kg*m^2, J: 0.0021 kg*m^2, m: 0.4 kg, c: 2 mm, s: " + std::to_string(s) +
         " rad/s}\npoints: {O: [0, 0, 0], G: [0, 0, c]}\n"
         "bodies: {top: {mass: m, center: G, inertia: {about: O, axis: z, axial: I, transverse: J}}}\n"
         "joints: {tip: {ball: O, to: top}}\ngravity: [0, 0, -9.81 m/s^2]\n"
         "instants: {now: {angular_velocity(top): [0, 0, s]}}\nask: {end: {" +
         ask + ", while: stable(top)}}\n";
}

bool notes(const SolvedText& solved, const std::string& begin) {
  for (const std::string& note : solved.notes())
    if (note.starts_with(begin)) return true;
  return false;
}

TEST(Extremum, WhereStabilityEndsNothingElseIsTold) {
  const SolvedText solved(sleeping_top(20, "largest: c"));
  const double expected = 0.0006 * 0.0006 * 400 / (4 * 0.0021 * 0.4 * g);
  EXPECT_NEAR(solved.number("end"), expected, 1e-6 * expected);
  EXPECT_FALSE(notes(solved, "end:"));
}

TEST(Extremum, WhereNoBodyHasSuchMomentsThatIsTold) {
  const SolvedText solved(sleeping_top(80, "largest: c"));
  const double expected = std::sqrt((0.0021 - 0.0003) / 0.4);
  EXPECT_NEAR(solved.number("end"), expected, 1e-6 * expected);
  EXPECT_TRUE(notes(solved, "end: what is stated ends at 0.06708")) << solved.notes().size();
}

TEST(Extremum, WhatMayBeAsSmallAsOneLikesHasNoLeastValue) {
  const SolvedText solved(sleeping_top(80, "smallest: m"));
  EXPECT_TRUE(solved.reason("end").starts_with("there is no smallest value")) << solved.reason("end");
}

}  // namespace
}  // namespace poinsot::problem
