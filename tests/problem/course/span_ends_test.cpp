// What happens just at the ends of a span of time that is looked at.
#include <fmt/format.h>

#include "problem/course/motion_support.h"

namespace poinsot::problem {
namespace {
namespace span_ends_test {

std::vector<double> times(const SolvedText& solved, const std::string& name) {
  std::vector<double> found;
  for (const Value<double>& item : solved.found(name).value.items) found.push_back(item.number);
  return found;
}
void expect_times(const SolvedText& solved, const std::string& name, const std::vector<double>& expected) {
  const std::vector<double> found = times(solved, name);
  ASSERT_EQ(found.size(), expected.size()) << name;
  for (std::size_t i = 0; i < found.size(); ++i) EXPECT_NEAR(found[i], expected[i], 1e-9) << name;
}

// x = sin(pi t) m/pi: it becomes positive at even seconds and negative at odd ones.
TEST(SpanEnds, TellInWhichSenseACrossingIs) {
  for (int n = 1; n <= 6; ++n) {
    const SolvedText solved(fmt::format(
        "given: {{m: 2 kg, k: 2 kg * (pi/(1 s))^2}}\npoints: {{O: [0, 0, 0]}}\nbodies: {{b: {{particle: O, mass: "
        "m}}}}\n"
        "joints: {{r: {{prismatic: x, at: O, to: b, displacement: x1, spring: {{stiffness: k}}}}}}\ngravity: none\n"
        "instants: {{start: {{x1: 0, x1': 1 m/s}}}}\n"
        "ask: {{zero: {{times: x1 == 0, from: 0 s, to: {0} s}}, up: {{times: x1 > 0, from: 0 s, to: {0} s}}, "
        "down: {{times: x1 < 0, from: 0 s, to: {0} s}}}}\n",
        n));
    std::vector<double> zero, up, down;
    for (int i = 0; i <= n; ++i) {
      zero.push_back(i);
      (i % 2 == 0 ? up : down).push_back(i);
    }
    expect_times(solved, "zero", zero);
    expect_times(solved, "up", up);
    expect_times(solved, "down", down);
  }
}

}  // namespace span_ends_test
}  // namespace
}  // namespace poinsot::problem
