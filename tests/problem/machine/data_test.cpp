// Values of data, and how they follow the time.
#include "problem/machine/data.h"

#include <gtest/gtest.h>

#include "problem/entries/statement.h"

namespace poinsot::problem {
namespace data_test {

constexpr const char* text = R"(
given: {m: 2 kg, rate: 3 rad/s, turned: rate*time, twice: 2*turned}
points: {A: [1 m, 0, 0], B: 'A + [0, time*(1 m/s), 0]'}
bodies: {ball: {particle: A, mass: m}}
ask: {a: mass(ball)}
)";

class DataInTime : public ::testing::Test {
 protected:
  Statement statement_ = read_statement(text, "data.yaml");
  const Situation& problem_ = statement_.situations.front();
  Settings settings_;
  Expression of(const char* words) { return parse_expression(words, "data.yaml", Mark{}); }
};

TEST_F(DataInTime, EachTimeHasItsValues) {
  DataScope<double> moving(problem_, settings_, 0.5);
  for (const double time : {0.5, 1.0, 1.0, 7.0, 0.0}) {
    moving.set_time(time);
    DataScope<double> fresh(problem_, settings_, time);
    for (const char* words : {"turned", "twice", "time"})
      EXPECT_EQ(moving.value(of(words)).number, fresh.value(of(words)).number) << words << " at " << time;
    for (const char* place : {"A", "B"})
      EXPECT_EQ(norm(moving.place(of(place)) - fresh.place(of(place))), 0) << place << " at " << time;
    EXPECT_EQ(moving.number(of("m"), dimensions::mass), 2);
    EXPECT_DOUBLE_EQ(moving.value(of("twice")).number, 6 * time);
  }
}

TEST_F(DataInTime, WhatFollowsTheTimeIsKnown) {
  DataScope<double> data(problem_, settings_, 2);
  data.value(of("m*norm(A)"));
  EXPECT_FALSE(data.follows_time());
  data.value(of("twice"));
  EXPECT_TRUE(data.follows_time());
  data.set_time(3);
  EXPECT_FALSE(data.follows_time());
  data.place(of("B"));
  EXPECT_TRUE(data.follows_time());
}

// What had no value may be asked again: it is not in the middle of its definition.
TEST(Data, WhatFailsFailsAgainForTheSameReason) {
  const Statement statement = read_statement(R"(
given: {m: 2 kg, lost: 'sqrt(-m/(1 kg))', behind: 2*lost}
points: {A: [0, 0, 0]}
bodies: {ball: {particle: A, mass: m}}
ask: {a: mass(ball)}
)",
                                             "data.yaml");
  const Settings settings;
  DataScope<double> data(statement.situations.front(), settings);
  const Expression behind = parse_expression("behind", "data.yaml", Mark{});
  std::string first;
  for (int time = 0; time < 2; ++time) {
    try {
      data.value(behind);
      ADD_FAILURE() << "it has no value";
    } catch (const DomainError& error) {
      if (time == 0) first = error.what();
      EXPECT_EQ(error.what(), first);
    }
  }
}

// What nothing uses is read all the same.
TEST(Data, AreEvaluatedWhetherSomethingUsesThemOrNot) {
  const std::string rest = "bodies: {ball: {particle: A, mass: m}}\nask: {a: mass(ball)}\n";
  const auto fault = [&](const std::string& data) -> std::string {
    try {
      check_every_datum(read_statement(data + rest, "data.yaml"));
    } catch (const StatementError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(fault("given: {m: 2 kg, M: 5 N*mmm}\npoints: {A: [0, 0, 0]}\n"),
            "data.yaml:1:25: error: 'mmm' is not defined (if a unit is meant, write 'mm'; if a datum, define it under "
            "given: or letters:)");
  EXPECT_EQ(fault("given: {m: 2 kg, M: m + 3 N}\npoints: {A: [0, 0, 0]}\n"),
            "data.yaml:1:23: error: a force cannot be added to a mass");
  EXPECT_EQ(fault("given: {m: 2 kg, b: 20 deg, d: 40 mm*cosine(b)}\npoints: {A: [0, 0, 0]}\n"),
            "data.yaml:1:38: error: there is no function 'cosine' (write cos(b))");
  EXPECT_EQ(fault("given: {m: 2 kg}\npoints: {A: [0, 0, 0], B: [0, L, 0]}\n"),
            "data.yaml:2:31: error: 'L' is not defined (define it under given:, letters:, points: or directions:)");
  EXPECT_EQ(fault("given: {m: 2 kg}\npoints: {A: [0, 0, 0]}\ndirections: {u: Q->A}\n"),
            "data.yaml:3:17: error: 'Q' is not defined (define it under given:, letters:, points: or directions:)");
  // Letters and unknowns have no value yet, and a root may have one elsewhere.
  EXPECT_EQ(
      fault("letters: {m: kg, c: m, b: deg}\nfind: {d: m, u: {vector: m/s}}\ngiven: {e: sqrt(c - 9*d), f: "
            "sin(b), k: norm(u), t: time/(2 s), o: any}\npoints: {A: [0, d, 0]}\ndirections: {u1: [c - d, 0, 0]}\n"
            "instants: {now: {velocity(ball): u}}\n"),
      "");
  // A datum that makes sense in one situation need not do so in all.
  const std::string both = "given: {m: 2 kg, b: 2*a}\npoints: {A: [0, 0, 0]}\n";
  EXPECT_EQ(fault(both + "situations: {one: {given: {a: 1 m}}, two: {}}\n"), "");
  EXPECT_EQ(fault(both + "situations: {one: {}, two: {}}\n"),
            "data.yaml:1:23: error: 'a' is not defined (did you mean 'A'?)");
}

}  // namespace data_test
}  // namespace poinsot::problem
