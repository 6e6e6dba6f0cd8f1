// A spring without free length pulls as its span: also where its ends meet.
#include <fmt/format.h>

#include "problem/course/motion_support.h"

namespace poinsot::problem {
namespace zero_length_spring_test {

TEST(ZeroLengthSpring, SwingsThroughItsAnchor) {
  for (const double v : {0.3, 1.0, 7.0}) {
    const SolvedText solved(fmt::format(
        "title: t\npoints: {{O: [0, 0, 0], A: [1 m, 0, 0]}}\nbodies: {{cart: {{particle: A, mass: 1 kg}}}}\n"
        "joints: {{rail: {{prismatic: x, at: O, to: cart, displacement: s}}}}\n"
        "springs: {{k: {{at: O, to: cart, end: A, stiffness: 100 N/m, free_length: 0 m}}}}\ngravity: none\n"
        "instants: {{start: {{s: -1 m, s': {:.17g} m/s}}}}\n"
        "ask: {{a: acceleration(cart).x @ start, s: s @ 1 s, m: max(s)}}\n",
        v));
    EXPECT_EQ(solved.number("a"), 0);
    EXPECT_NEAR(solved.number("s"), -1 + v / 10 * std::sin(10.0), 1e-9 * v);
    EXPECT_NEAR(solved.number("m"), -1 + v / 10, 1e-9 * v);
  }
}

}  // namespace zero_length_spring_test
}  // namespace poinsot::problem
