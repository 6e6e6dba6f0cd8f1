// Holes that reach out of their bodies or overlap are refused; others, up to those that end on the surface, are not.
#include "problem/witness/cut_parts.h"

#include <gtest/gtest.h>

#include "problem/answers/solve_statement.h"

namespace poinsot::problem {
namespace cut_parts_test {

SolvedAsk mass_of(const std::string& parts, const std::string& density) {
  const std::string text =
      "points: {O: [0, 0, 0]}\nbodies: {b: {parts: {" + parts + "}, density: " + density + "}}\nask: {m: mass(b)}\n";
  return solve_statement(read_statement(text, "hole.yaml"), {}).solutions.at(0).asks.at(0);
}
void expect_refused(const std::string& parts, const std::string& density, const std::string& words) {
  const SolvedAsk ask = mass_of(parts, density);
  EXPECT_EQ(ask.state, AskState::refused) << parts;
  EXPECT_NE(ask.reason.find(words), std::string::npos) << ask.reason;
}
void expect_told(const std::string& parts, const std::string& density) {
  const SolvedAsk ask = mass_of(parts, density);
  EXPECT_EQ(ask.state, AskState::found) << parts << ask.reason;
}

const std::string solid = "1000 kg/m^3", thin = "5 kg/m^2";
const std::string ball = "whole: {sphere: {center: O, radius: 0.1 m}}";
const std::string plate = "whole: {rectangle: {center: O, sides: [[1 m, 0, 0], [0, 0.6 m, 0]]}}";
const std::string block = "whole: {box: {center: O, sides: [[1 m, 0, 0], [0, 0.6 m, 0], [0, 0, 0.2 m]]}}";
std::string bore(const std::string& name, const std::string& x, const std::string& length) {
  return ", " + name + ": {cylinder: {center: [" + x + ", 0, 0], axis: z, radius: 50 mm, length: " + length +
         "}, hole: true}";
}

TEST(CutParts, what_reaches_out_is_refused) {
  const std::string out = "reaches out of it";
  expect_refused(ball + ", h: {sphere: {center: [80 mm, 0, 0], radius: 50 mm}, hole: true}", solid, out);
  expect_refused(plate + ", h: {disk: {center: [0.5 m, 0, 0], normal: z, radius: 0.1 m}, hole: true}", thin, out);
  expect_refused(block + bore("h", "0 m", "0.3 m"), solid, out);
}

TEST(CutParts, what_overlaps_is_refused) {
  const std::string twice = "would count twice";
  expect_refused(block + bore("h", "0 m", "0.2 m") + bore("k", "60 mm", "0.2 m"), solid, twice);
  expect_refused(ball +
                     ", h: {cylinder: {center: O, axis: z, radius: 20 mm, length: 100 mm}, hole: true}"
                     ", k: {cylinder: {center: O, axis: x, radius: 20 mm, length: 100 mm}, hole: true}",
                 solid, twice);
  expect_refused(plate +
                     ", h: {disk: {center: O, normal: z, radius: 0.1 m}, hole: true}"
                     ", k: {rectangle: {center: [0.1 m, 0, 0], sides: [[0.2 m, 0, 0], [0, 0.1 m, 0]]}, hole: true}",
                 thin, twice);
}

TEST(CutParts, what_is_there_is_cut) {
  expect_told(ball + ", h: {sphere: {center: [40 mm, 0, 0], radius: 60 mm}, hole: true}", solid);
  expect_told(block + bore("h", "0 m", "0.2 m") + bore("k", "100 mm", "0.2 m"), solid);
  expect_told(plate + ", h: {semicircle: {diameter: [[0.5 m, 0.1 m, 0], [0.5 m, -0.1 m, 0]], toward: -x}, hole: true}",
              thin);
  expect_told(plate +
                  ", h: {rectangle: {center: [0.1 m, 0, 0], sides: [[0.2 m, 0, 0], [0, 0.2 m, 0]]}, hole: true}"
                  ", k: {rectangle: {center: [-0.1 m, 0, 0], sides: [[0.2 m, 0, 0], [0, 0.2 m, 0]]}, hole: true}",
              thin);
  // Within two parts together.
  expect_told(
      "one: {box: {center: [0.5 m, 0, 0], sides: [[1 m, 0, 0], [0, 1 m, 0], [0, 0, 1 m]]}}, two: {box: {center: [-0.5 "
      "m, 0, "
      "0], sides: [[1 m, 0, 0], [0, 1 m, 0], [0, 0, 1 m]]}}, h: {sphere: {center: O, radius: 0.3 m}, hole: true}",
      solid);
}

// Sizes that are found are looked at where they are found.
TEST(CutParts, found_holes_are_looked_at) {
  const std::string text =
      "find: {r: m}\nwhere: [r > 0]\npoints: {O: [0, 0, 0]}\nbodies: {b: {parts: {whole: {disk: {center: O, normal: z, "
      "radius: 1 m}}, h: {disk: {center: [0.6 m, 0, 0], normal: z, radius: r}, hole: true}}, density: 1 kg/m^2}}\n"
      "instants: {now: {mass(b): M}}\nask: {r: r}\ngiven: {M: ";
  const auto asked = [&](const std::string& mass) {
    return solve_statement(read_statement(text + mass + "}\n", "hole.yaml"), {}).solutions.at(0).asks.at(0);
  };
  EXPECT_EQ(asked("3 kg").state, AskState::found);
  EXPECT_EQ(asked("2 kg").state, AskState::refused);
}

}  // namespace cut_parts_test
}  // namespace poinsot::problem
