// Times and tables of the motions of several situations.
#include "problem/unknowns/situated.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "problem/course/motion_support.h"
#include "problem/quantities/describe.h"

namespace poinsot::problem {
namespace situated_test {

// Two pendulums let go from different angles; K(k) by the arithmetic-geometric mean gives a quarter of the period.
const std::string swings =
    "title: t\ngiven: {g: 9.81 m/s^2, L: 0.9 m}\npoints: {O: [0, 0, 0], P: [0, -L, 0]}\n"
    "bodies: {bob: {particle: P, mass: 1 kg}}\njoints: {pin: {revolute: z, at: O, to: bob, angle: theta}}\n"
    "gravity: -y\n"
    "situations:\n  small: {instants: {start: {theta: 10 deg, theta': 0}}}\n"
    "  large: {instants: {start: {theta: 100 deg, theta': 0}}}\n";

double quarter(double length, double angle) {
  double a = 1, b = std::cos(0.5 * angle);
  for (int k = 0; k < 20; ++k) {
    const double mean = 0.5 * (a + b);
    b = std::sqrt(a * b);
    a = mean;
  }
  return std::sqrt(length / 9.81) * std::numbers::pi / (2 * a);
}
constexpr double degree = std::numbers::pi / 180;

TEST(Situated, TimesAreThoseOfTheSituationNamed) {
  const SolvedText solved(swings +
                          "ask:\n  a: {first_time: theta @ small == 0}\n  b: {first_time: theta @ large == 0}\n"
                          "  all: {times: theta @ large == 0, from: 0 s, to: 4 s}\n"
                          "  back: {first_time: theta @ large == min(theta) @ large}\n");
  EXPECT_NEAR(solved.number("a"), quarter(0.9, 10 * degree), 1e-10);
  const double large = quarter(0.9, 100 * degree);
  EXPECT_NEAR(solved.number("b"), large, 1e-10);
  EXPECT_NEAR(solved.number("back"), 2 * large, 1e-6);
  const Value<double>& all = solved.found("all").value;
  ASSERT_EQ(all.items.size(), 3U);
  for (std::size_t k = 0; k < 3; ++k)
    EXPECT_NEAR(all.items[k].number, (2.0 * static_cast<double>(k) + 1) * large, 1e-9);
}

// What is found for the whole statement is asked without saying when.
TEST(Situated, AnUnknownOfSeveralStagesIsOne) {
  const std::string text =
      "title: t\nfind: {t: s}\npoints: {O: [0, 0, 0]}\n"
      "bodies: {w: {mass: 4 kg, center: O, inertia: {axis: z, axial: 3 kg*m^2, transverse: 3 kg*m^2}}}\n"
      "joints: {axle: {revolute: z, at: O, to: w, angle: a}}\nloads: {motor: {couple: [0, 0, 6 N*m], body: w}}\n"
      "gravity: none\nstages: {driven: {lasts: t}, coasting: {loads: [], lasts: 10 s}}\n"
      "instants: {start: rest, driven.end: {\"a'\": 8 rad/s}}\nask: {WHAT}\n";
  const auto asking = [&](const std::string& what) {
    std::string whole = text;
    return whole.replace(whole.find("WHAT"), 4, what);
  };
  EXPECT_NEAR(SolvedText(asking("t: t")).number("t"), 4, 1e-9);
  EXPECT_NE(failure_of_text(asking("w: \"a'\"")).find("in which stage is this asked?"), std::string::npos);
}

// An energy at one time and another at the next are no sum.
TEST(Situated, WhatIsMeantLaterSaysSoOfEveryPart) {
  const auto asking = [](const std::string& what) {
    return "title: t\npoints: {O: [0, 0, 0], P: [1 m, 0, 0]}\nbodies: {rod: {rod: [O, P], mass: 2 kg}}\n"
           "joints: {pin: {revolute: z, at: O, to: rod, angle: q}}\ngravity: -y\n"
           "instants: {start: {q: 0, \"q'\": 1 rad/s}, low: {first_time: q == -90 deg}}\n"
           "stages: {run: {lasts: 3 s}}\nask: {E: '" +
           what + "'}\n";
  };
  for (const std::string when : {"low", "run.end", "0.1 s"}) {
    EXPECT_NE(failure_of_text(asking("kinetic_energy(rod) + potential_energy(rod) @ " + when))
                  .find("a part of this stands without @: when is it meant? (write @ " + when),
              std::string::npos)
        << when;
    const SolvedText whole(asking("(kinetic_energy(rod) + potential_energy(rod)) @ " + when));
    EXPECT_NEAR(whole.number("E"), 1.0 / 3, 1e-9) << when;
  }
  const Statement statement =
      read_statement(asking("(kinetic_energy(rod) + potential_energy(rod)) @ low"), "test.yaml");
  EXPECT_EQ(describe(statement.asks.front(), statement.situations.front(), false),
            "(kinetic_energy(rod) + potential_energy(rod)) @ low");
  // The beginning is where everything without @ is meant.
  EXPECT_NEAR(SolvedText(asking("kinetic_energy(rod) + potential_energy(rod) @ start")).number("E"), 1.0 / 3, 1e-9);
}

TEST(Situated, ATableMayCompareSituations) {
  const SolvedText solved(
      swings +
      "ask:\n  t: {table: {t: time, a: theta @ small, b: theta @ large}, over: {time: [0 s, 0.3 s]}}\n"
      "  L: {table: {L: L, a: period(theta) @ small, b: period(theta) @ large}, over: {L: [0.4 m, 1.6 m]}}\n"
      "  q: {table: {t: time, a: theta' @ large}, over: {theta: [50 deg, 20 deg]}}\n"
      "  one: theta @ large\n");
  EXPECT_NEAR(solved.column("t", 1)[0], 10 * degree, 1e-12);
  EXPECT_NEAR(solved.column("t", 2)[0], 100 * degree, 1e-12);
  EXPECT_NE(solved.column("t", 1)[1], solved.column("t", 2)[1]);
  for (std::size_t row = 0; row < 2; ++row) {
    const double L = row == 0 ? 0.4 : 1.6;
    EXPECT_NEAR(solved.column("L", 1)[row], 4 * quarter(L, 10 * degree), 1e-8);
    EXPECT_NEAR(solved.column("L", 2)[row], 4 * quarter(L, 100 * degree), 1e-8);
    const double angle = row == 0 ? 50 : 20;
    const double rate = -std::sqrt(2 * 9.81 / 0.9 * (std::cos(angle * degree) - std::cos(100 * degree)));
    EXPECT_NEAR(solved.column("q", 1)[row], rate, 1e-8);
  }
}

TEST(Situated, WithoutASituationTheMessageSaysWhatToWrite) {
  const auto message = [](const std::string& ask) { return failure_of_text(swings + "ask: {a: " + ask + "}\n"); };
  EXPECT_EQ(
      message("{first_time: theta == 0}"),
      "test.yaml:10:23: error: in which situation is 'theta == 0' asked? (write @ small behind each quantity, as in "
      "theta @ small (the situations are small, large))");
  EXPECT_NE(message("{first_time: theta @ small == theta}").find("in which situation"), std::string::npos);
  EXPECT_NE(message("{table: {a: theta}, over: {time: [0 s]}}").find("in which situation is 'theta' asked?"),
            std::string::npos);
  EXPECT_NE(message("{first_time: theta @ small == theta @ large}")
                .find("'@ large' is another situation than '@ small': times are asked of the motion of one"),
            std::string::npos);
  EXPECT_NE(message("{first_time: theta @ small == 0, situation: large}").find("no situation stands beside it"),
            std::string::npos);
}

// A name that begins like that of a situation is not that situation.
TEST(Situated, AnAskNamesTheSituationsBehindItsQuantities) {
  const Statement statement =
      read_statement(swings +
                         "ask:\n  one: theta @ large\n  two: [theta @ small.start, 2*theta' @ large]\n"
                         "  when: {first_time: theta @ large == 0}\n"
                         "  table: {table: {t: time, a: theta @ small}, over: {time: [0 s]}}\n",
                     "test.yaml");
  const std::vector<std::pair<bool, bool>> expected{{false, true}, {true, true}, {false, true}, {true, false}};
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_EQ(names_situation(statement.asks.at(i), "small"), expected[i].first) << i;
    EXPECT_EQ(names_situation(statement.asks.at(i), "large"), expected[i].second) << i;
    EXPECT_FALSE(names_situation(statement.asks.at(i), "lar")) << i;
  }
}

// Of two forces the conditions of `a` fix the sum alone; those of `b` fix what is left.
TEST(Situated, AnUnknownThatOneSituationLeavesOpenIsNotListedThere) {
  const SolvedText solved(
      "title: t\npoints: {O: [0, 0, 0]}\nbodies: {block: {particle: O, mass: 2 kg}}\n"
      "joints: {guide: {prismatic: x, at: O, to: block, displacement: s}}\ngravity: none\n"
      "loads: {P: {force: F, along: x, body: block, at: O}, Q: {force: G, along: x, body: block, at: O}}\n"
      "instants: {now: {s': 0, s'': 3 m/s^2}}\n"
      "situations:\n  a: {find: {F: N, G: N}}\n  b: {given: {G: 1 N}, find: {F: N}}\n"
      "ask: {f: force(P on block) @ b}\n");
  std::map<std::string, double> listed;
  for (const SolvedUnknown& unknown : solved.solved().solutions.at(0).unknowns)
    listed[unknown.name] = unknown.value.number;
  ASSERT_EQ(listed.size(), 1U);
  EXPECT_NEAR(listed.at("F @ b"), 5, 1e-12);
}

}  // namespace situated_test
}  // namespace poinsot::problem
