// Tables over data, records and motions that are asked where contacts have friction, against closed forms.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "problem/answers/asked_motion.h"
#include "problem/answers/recorded_motion.h"
#include "problem/course/motion_support.h"

namespace poinsot::problem {
namespace friction_rows_test {

constexpr double g = 9.80665;

// Up a slope with 3 m/s; it comes back where the friction does not hold it.
std::string up_a_slope(const std::string& more) {
  return "given: {m: 2 kg, b: 0.5 rad, mu: 0.3}\npoints: {C: [0, 0, 0]}\n"
         "directions: {up: [cos(b), sin(b), 0], out: [-sin(b), cos(b), 0]}\nbodies: {block: {particle: C, mass: m}}\n"
         "contacts: {slope: {of: block, at: C, normal: out, friction: mu}}\ngravity: -y\n"
         "facts: {velocity(block): '(3 m/s)*up'}\n" +
         more;
}
double way(double mu, double t) {
  const double b = 0.5, braked = g * (std::sin(b) + mu * std::cos(b)), stops = 3 / braked, after = t - stops;
  if (after < 0) return 3 * t - braked * t * t / 2;
  const double back = std::max(0.0, g * (std::sin(b) - mu * std::cos(b)));
  return 9 / (2 * braked) - back * after * after / 2;
}

TEST(FrictionRows, EachRowOfATableHasItsOwnStates) {
  const std::vector<double> rows{0.1, 0.5, 0.56, 0.9};
  const SolvedText solved(up_a_slope(
      "ask: {t: {table: {s: component(center(block) along up) @ 2 s, F: norm(friction(slope on block)) @ 2 s}, "
      "over: {mu: [0.1, 0.5, 0.56, 0.9]}}}\n"));
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const bool slides = rows[k] < std::tan(0.5);
    EXPECT_NEAR(solved.column("t", 0).at(k), way(rows[k], 2), 1e-8) << rows[k];
    EXPECT_NEAR(solved.column("t", 1).at(k), 2 * g * (slides ? rows[k] * std::cos(0.5) : std::sin(0.5)), 1e-7)
        << rows[k];
  }
  const SolvedText at_rest(
      "given: {m: 2 kg, P: 1 N}\npoints: {C: [0, 0, 0]}\nbodies: {block: {particle: C, mass: m}}\n"
      "contacts: {floor: {of: block, at: C, normal: y, friction: {static: 0.4, kinetic: 0.3}}}\n"
      "loads: {push: {force: [P, 0, 0], body: block}}\ngravity: -y\ninstants: {now: rest}\n"
      "ask: {t: {table: {a: acceleration(block).x}, over: {P: '-12 N .. 12 N by 4 N'}}}\n");
  for (int k = 0; k < 7; ++k) {
    const double P = -12 + 4 * k, a = std::abs(P) > 0.8 * g ? P / 2 - std::copysign(0.3 * g, P) : 0;
    EXPECT_NEAR(at_rest.column("t", 0).at(static_cast<std::size_t>(k)), a, 1e-9) << P;
  }
}

TEST(FrictionRows, ARecordFollowsTheStatesFromBlockToBlock) {
  const std::string text = up_a_slope(
      "record: {every: 1 ms, for: 1.2 s, columns: {t: time, s: component(center(block) along up), F: "
      "component(friction(slope on block) along up)}}\nask: {a: acceleration(block)}\n");
  RecordedMotion recorded(read_statement(text, "test.yaml"), {});
  std::optional<RecordedState> state = recorded.start();
  std::uint64_t row = 0;
  int blocks = 0;
  while (state) {
    const RecordedBlock block = recorded.block(row, *state);
    for (std::size_t k = 0; k + 2 < block.values.size(); k += 3) {
      EXPECT_NEAR(block.values[k + 1], way(0.3, block.values[k]), 1e-9) << block.values[k];
      const double size = 0.3 * 2 * g * std::cos(0.5), stops = 3 / (g * (std::sin(0.5) + 0.3 * std::cos(0.5)));
      if (std::abs(block.values[k] - stops) < 1e-6) continue;
      EXPECT_NEAR(block.values[k + 2], block.values[k] < stops ? -size : size, 1e-7) << block.values[k];
    }
    row += block.values.size() / 3;
    state = block.next;
    ++blocks;
  }
  EXPECT_EQ(row, 1201U);
  EXPECT_GT(blocks, 1);
}

// A ball that bounces until it rests, and a bob that its slack cord catches; blocks that a second recording makes from
// what the first one left have the same bits.
TEST(FrictionRows, ARecordGoesOnThroughBlows) {
  const std::string text =
      "title: t\npoints: {G: [0, 1.1 m, 0], C: [0, 1 m, 0], O: [0, 0, 0], P: [3 m, 0, 0], B: [3.2 m, 0, 0]}\n"
      "bodies: {ball: {sphere: {center: G, radius: 0.1 m}, mass: 2 kg}, bob: {particle: B, mass: 1 kg}}\ngravity: -y\n"
      "contacts: {floor: {of: ball, at: C, normal: y, open: true, surface: O, restitution: 0.7, friction: 0.1}}\n"
      "cords: {cord: {at: P, to: bob, end: B, length: 0.9 m}}\n"
      "instants: {start: {velocity(ball): [1 m/s, 0, 0], angular_velocity(ball): [0, 0, 0], velocity(bob): [0, 0, "
      "0]}}\n"
      "record: {every: 1 ms, for: 3 s, columns: {t: time, y: center(ball).y, far: norm(center(bob) - P)}}\n";
  RecordedMotion one(read_statement(text, "test.yaml"), {}), other(read_statement(text, "test.yaml"), {});
  const double falls = std::sqrt(2 / g), e = 0.7;
  const auto height = [&](double t) {
    double v = g * falls, from = falls;
    if (t < falls) return 1.1 - g * t * t / 2;
    for (int blow = 0; blow < 60; ++blow) {
      v *= e;
      if (t < from + 2 * v / g) return 0.1 + v * (t - from) - g * (t - from) * (t - from) / 2;
      from += 2 * v / g;
    }
    return 0.1;
  };
  std::optional<RecordedState> state = one.start();
  std::uint64_t row = 0;
  int blocks = 0;
  while (state) {
    const RecordedBlock block = one.block(row, *state), again = other.block(row, *state);
    EXPECT_EQ(block.values, again.values) << row;
    EXPECT_EQ(block.next, again.next) << row;
    EXPECT_EQ(block.notes, again.notes) << row;
    for (std::size_t k = 0; k + 2 < block.values.size(); k += 3) {
      const double t = block.values[k];
      EXPECT_NEAR(block.values[k + 1], height(t), 1e-7) << t;
      EXPECT_LE(block.values[k + 2], 0.9 + 1e-9) << t;
      if (t > std::sqrt(2 * std::sqrt(0.81 - 0.04) / g) && t < 1) {
        EXPECT_NEAR(block.values[k + 2], 0.9, 1e-9) << t;
      }
    }
    row += block.values.size() / 3;
    state = block.next;
    ++blocks;
  }
  EXPECT_EQ(row, 3001U);
  EXPECT_GT(blocks, 2);
}

TEST(FrictionRows, AMotionIsAskedAtAnyTimes) {
  AskedMotion motion(read_statement(up_a_slope("ask: {a: acceleration(block)}\n"), "test.yaml"), {{"mu", "0.2"}});
  const std::vector<double> times{0.1, 0.4, 0.9, 1.5};
  const AskedValues found = motion.values(times, {"component(center(block) along up)"}, "");
  for (std::size_t k = 0; k < times.size(); ++k) EXPECT_NEAR(found.series.at(0).values.at(k), way(0.2, times[k]), 1e-9);
}

TEST(FrictionRows, ARowInWhichNoStateHoldsOrSeveralDoIsLeftOut) {
  // Painleve's rod: with little friction it slides in one way, with much in two.
  const SolvedText rod(
      "given: {mu: 0.1, b: 55 deg}\npoints: {A: [0, 0, 0], B: [cos(b)*2 m, sin(b)*2 m, 0]}\n"
      "bodies: {rod: {rod: [A, B], mass: 1 kg}}\ncontacts: {floor: {of: rod, at: A, normal: y, friction: mu}}\n"
      "gravity: -y\nfacts: {velocity(A of rod): [-1 m/s, 0, 0], angular_velocity(rod): [0, 0, -5 rad/s]}\n"
      "ask: {N: {table: {N: normal_force(floor)}, over: {mu: [0.1, 3]}}}\n");
  EXPECT_EQ(rod.column("N", 0).size(), 1U);
  EXPECT_EQ(std::ranges::count(rod.notes(),
                               "N: the row mu = 3 has no answer and is left out: several states of the contacts with "
                               "friction hold"),
            1);
}

}  // namespace friction_rows_test
}  // namespace poinsot::problem
