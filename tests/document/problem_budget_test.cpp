// A caller that does not wait: deadlines and flags end a long call within some milliseconds, and the document says so.
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <string>
#include <thread>

#include "poinsot/problem.h"
#include "poinsot/rendering.h"

namespace poinsot::document {
namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;

// It takes some milliseconds; here other programs, and the sanitizers, may hold it up.
constexpr milliseconds generous{2000};

// Two rods that swing for hours: following them takes minutes.
const std::string long_motion =
    "title: A long motion\npoints: {O: [0, 0, 0], P: [1 m, 0, 0], Q: [2 m, 0, 0]}\n"
    "bodies: {one: {rod: [O, P], mass: 2 kg}, two: {rod: [P, Q], mass: 1 kg}}\n"
    "joints: {pin: {revolute: z, at: O, to: one, angle: a}, knee: {revolute: z, at: P, from: one, to: two, angle: b}}\n"
    "gravity: -y\ninstants: {start: {a: 10 deg, a': 0, b: 40 deg, b': 0}}\n"
    "ask: {m: mass(one), x: {table: {t: time, a: a}, over: {time: 0 s .. 200000 s by 1000 s}}}\n";

void expect_ended(const Document& document, BudgetEnd end) {
  EXPECT_EQ(document.ended, end);
  EXPECT_FALSE(fully_answered(document));
  EXPECT_EQ(document.title, "A long motion");
  const std::string json = to_json(document);
  EXPECT_NE(json.find(end == BudgetEnd::deadline ? R"("ended":"deadline")" : R"("ended":"interrupted")"),
            std::string::npos)
      << json;
  EXPECT_NE(to_terminal(document).find(words_of(end)), std::string::npos) << to_terminal(document);
}

TEST(ProblemBudget, ADeadlineEndsTheSearch) {
  const Problem problem = Problem::from_text(long_motion, "long.yaml");
  constexpr milliseconds allowed{100};
  const Clock::time_point begin = Clock::now();
  const Document document = problem.solve({}, Budget().end_after(allowed));
  const Clock::duration taken = Clock::now() - begin;
  EXPECT_GE(taken, allowed);
  EXPECT_LT(taken, allowed + generous);
  RecordProperty("late_by_ms", static_cast<int>(std::chrono::duration_cast<milliseconds>(taken - allowed).count()));
  expect_ended(document, BudgetEnd::deadline);
}

TEST(ProblemBudget, AFlagOfAnotherThreadEndsTheSearch) {
  const Problem problem = Problem::from_text(long_motion, "long.yaml");
  std::atomic<bool> cancel{false};
  Clock::time_point canceled;
  std::thread other([&] {
    std::this_thread::sleep_for(milliseconds(100));
    canceled = Clock::now();
    cancel = true;
  });
  const Document document = problem.explain({}, Budget().end_when(&cancel));
  const Clock::time_point end = Clock::now();
  other.join();
  EXPECT_LT(end - canceled, generous);
  RecordProperty("late_by_ms", static_cast<int>(std::chrono::duration_cast<milliseconds>(end - canceled).count()));
  expect_ended(document, BudgetEnd::interrupted);
}

TEST(ProblemBudget, OtherCallsSayThatTheyWereEnded) {
  const Problem problem = Problem::from_text(
      long_motion + "expect: {m: {value: 2, unit: kg}, x: {columns: {t: [0], a: [0]}}}\n", "long.yaml");
  const std::atomic<bool> cancel{true};
  EXPECT_THROW(problem.check(Budget().end_when(&cancel)), BudgetEnded);
  EXPECT_THROW(problem.equations({}, Budget().end_when(&cancel)), BudgetEnded);
}

TEST(ProblemBudget, EnoughOfItChangesNothing) {
  const Problem problem = Problem::from_text(
      "title: A particle\nbodies: {p: {particle: [3 m, 0, 0], mass: 2 kg}}\n"
      "ask: {I: 'moment_of_inertia(p about z at [0, 0, 0])'}\n",
      "particle.yaml");
  const Document document = problem.explain({}, Budget().end_after(std::chrono::hours(1)));
  EXPECT_FALSE(document.ended);
  EXPECT_EQ(to_json(document), to_json(problem.explain()));
}

}  // namespace
}  // namespace poinsot::document
