// Motions of what cannot move, and stages that cannot be.
#include <gtest/gtest.h>

#include <string>

#include "problem/answers/solve_statement.h"
#include "problem/course/motion_support.h"
#include "problem/language/failure.h"

namespace poinsot::problem {
namespace nothing_moves_test {

const std::string welded = R"(
points: {A: [0 m, 0 m, 0 m], B: [1 m, 0 m, 0 m]}
bodies:
  arm: {rod: [A, B], mass: 2 kg}
joints:
  wall: {weld: A, to: arm}
gravity: none
)";

TEST(NothingMoves, AnswersOverAMotionAreThoseOfRest) {
  const SolvedText solved(welded + R"(
ask:
  most: max(kinetic_energy(arm))
  later: kinetic_energy(arm) @ 1 s
  end: position(B of arm) @ 2 s
)");
  EXPECT_EQ(solved.number("most"), 0);
  EXPECT_EQ(solved.number("later"), 0);
  EXPECT_EQ(solved.vector("end").x, 1);
}

TEST(NothingMoves, WhatNeverHappensIsToldSo) {
  const SolvedText solved(welded + R"(
ask:
  again: period(kinetic_energy(arm))
  once: {first_time: kinetic_energy(arm) == 1 J}
)");
  EXPECT_EQ(solved.ask("again").state, AskState::undetermined);
  EXPECT_EQ(solved.ask("again").reason, "'kinetic_energy(arm)' does not change: it has no period");
  EXPECT_EQ(solved.ask("once").state, AskState::undetermined);
}

// The message is the same whoever asks first: a stage without a good duration has not begun.
TEST(NothingMoves, StagesThatLastNoTimeAreRefusedWhoeverAsks) {
  const auto message = [](const std::string& lasts) {
    return failure_of([&] {
      solve_statement(read_statement(R"(
given: {T: 2 s, U: 0 s}
points: {A: [0 m, 0 m, 0 m], B: [1 m, 0 m, 0 m]}
bodies:
  arm: {rod: [A, B], mass: 2 kg}
joints:
  pin: {revolute: z, at: A, to: arm}
gravity: none
stages:
  one: {lasts: )" + lasts + R"(}
  two: {lasts: 1 s}
instants:
  one: rest
ask:
  T: kinetic_energy(arm) @ 1 s
)",
                                     "test.yaml"),
                      {});
    });
  };
  EXPECT_EQ(message("-T"), "test.yaml:10:16: error: a stage lasts no negative time");
  EXPECT_EQ(message("T*T/U"), "test.yaml:10:19: error: division by zero");
}

}  // namespace nothing_moves_test
}  // namespace poinsot::problem
