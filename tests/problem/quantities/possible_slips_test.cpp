// Which feet of a rigid table can slide, rest and rise together, by its geometry alone.
#include "problem/quantities/possible_slips.h"

#include <gtest/gtest.h>

#include <string>

#include "problem/answers/solve_statement.h"
#include "problem/instant/instant.h"

namespace poinsot::problem {
namespace possible_slips_test {

constexpr Grip S = Grip::sticks, L = Grip::slides, P = Grip::parts;

// Four feet at the corners of a square, or at whatever places.
std::string table(const std::string& rate,
                  const std::string& feet =
                      "A: [1 m, 1 m, 0], B: [-1 m, 1 m, 0], C: [-1 m, -1 m, 0], D: [1 m, -1 m, "
                      "0]") {
  return "points: {" + feet +
         ", G: [0, 0, 1 m]}\nbodies: {table: {mass: 5 kg, center: G, inertia: {axis: z, axial: 2 kg*m^2, transverse: 3 "
         "kg*m^2}}}\ncontacts:\n  a: {of: table, corner: A, normal: z, friction: 0.3}\n"
         "  b: {of: table, corner: B, normal: z, friction: 0.3}\n  c: {of: table, corner: C, normal: z, friction: "
         "0.3}\n"
         "  d: {of: table, corner: D, normal: z, friction: 0.3}\ngravity: -z\n"
         "instants: {now: {velocity(table): [" +
         rate + ", 0, 0], angular_velocity(table): [0, 0, 0]}}\nask: {a: acceleration(table).x}\n";
}

PossibleSlips possible(const std::string& text) {
  const Statement statement = read_statement(text, "test.yaml");
  return SolvedInstant(statement.situations.front(), {}, When{}, OpenChoice{}).possible_slips();
}

TEST(PossibleSlips, of_a_table_on_four_feet) {
  const PossibleSlips table_slips = possible(table("0 m/s"));
  // All rest; one rests and the others go round it; all slide; two rise about the line of the others, or all do.
  EXPECT_TRUE(table_slips.allow({S, S, S, S}));
  EXPECT_TRUE(table_slips.allow({S, L, L, L}));
  EXPECT_TRUE(table_slips.allow({L, L, L, L}));
  EXPECT_TRUE(table_slips.allow({S, S, P, P}));
  EXPECT_TRUE(table_slips.allow({S, L, P, P}));
  EXPECT_TRUE(table_slips.allow({P, P, P, P}));
  // Beside two that rest none slides, and where three touch the fourth does.
  EXPECT_FALSE(table_slips.allow({S, S, L, L}));
  EXPECT_FALSE(table_slips.allow({S, L, S, P}));
  EXPECT_FALSE(table_slips.allow({S, S, S, P}));
  EXPECT_FALSE(table_slips.allow({L, L, L, P}));
}

// Of three feet on one line and a fourth beside it, those on the line keep it in place.
TEST(PossibleSlips, of_feet_on_a_line) {
  const PossibleSlips slips = possible(table("0 m/s", "A: [0, 0, 0], B: [1 m, 0, 0], C: [2 m, 0, 0], D: [0, 3 m, 0]"));
  EXPECT_TRUE(slips.allow({S, S, S, P}));
  EXPECT_FALSE(slips.allow({S, S, P, S}));
  EXPECT_FALSE(slips.allow({S, P, S, P}));
  EXPECT_TRUE(slips.allow({S, P, P, P}));
}

TEST(PossibleSlips, are_all_where_something_moves) {
  EXPECT_TRUE(possible(table("1 m/s")).allow({S, S, L, L}));
  EXPECT_TRUE(PossibleSlips().allow({S, S, L, L}));
}

// With one foot at rest the others go round it, each along a line; with none at rest the table slides any way.
TEST(PossibleSlips, along_one_line) {
  for (const char* rate : {"0 m/s", "0.3 m/s"}) {
    const PossibleSlips slips = possible(table(rate));
    EXPECT_TRUE(slips.along_one_line(1, {S, L, L, L}));
    EXPECT_TRUE(slips.along_one_line(3, {S, L, L, L}));
    EXPECT_FALSE(slips.along_one_line(0, {L, L, L, L}));
    EXPECT_FALSE(slips.along_one_line(2, {P, P, L, P}));
  }
}

// What a planar joint holds slips along the line in which its plane meets the floor.
TEST(PossibleSlips, along_one_line_in_a_planar_joint) {
  const PossibleSlips slips = possible(
      "points: {A: [0, 0, 0], B: [1 m, 0, 0], G: [0.5 m, 1 m, 0]}\n"
      "bodies: {block: {mass: 5 kg, center: G, inertia: {axis: z, axial: 2 kg*m^2, transverse: 3 kg*m^2}}}\n"
      "joints: {frame: {planar: z, at: A, to: block}}\n"
      "contacts: {a: {of: block, corner: A, normal: y, friction: 0.3}, "
      "b: {of: block, corner: B, normal: y, friction: 0.3}}\n"
      "gravity: -y\ninstants: {now: {velocity(block): [0, 0, 0], angular_velocity(block): [0, 0, 0]}}\n"
      "ask: {a: acceleration(block).x}\n");
  EXPECT_TRUE(slips.along_one_line(0, {L, P}));
  EXPECT_TRUE(slips.along_one_line(0, {L, L}));
}

}  // namespace possible_slips_test
}  // namespace poinsot::problem
