// A caller that does not wait: deadlines and flags end a long call within some milliseconds, and the document says so.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <numbers>
#include <string>
#include <thread>

#include "poinsot/engine/work/work.h"
#include "poinsot/problem.h"
#include "poinsot/rendering.h"

namespace poinsot::document {
namespace problem_budget_test {

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

// The same in counted work, an operation taken for a nanosecond, so that the result is the same on every machine: what
// is told of files that take long, wherever the end comes, is at most what fifty milliseconds can do.
TEST(ProblemBudget, TheEndIsSeenWithinFiftyMillisecondsOfWork) {
  constexpr Work allowed = 50'000'000;
  const auto by_work = [] { return Clock::time_point{} + std::chrono::nanoseconds(work_done()); };
  int ended = 0;
  for (const char* const name : {"textbook/18.122", "published/turntable", "benchmarks/A05"}) {
    const Problem problem = Problem::from_file(POINSOT_SOURCE_DIR "/examples/" + std::string(name) + ".yaml");
    const Work begin = work_done();
    const Document whole = problem.solve();
    const Work full = work_done() - begin;
    EXPECT_FALSE(whole.ended);
    EXPECT_GT(full, 2 * allowed) << name << " takes too little to show anything";
    for (const double part : {0.13, 0.62}) {
      const Work deadline = work_done() + static_cast<Work>(part * static_cast<double>(full));
      const Document document = problem.solve(
          {}, Budget().by_clock(by_work).end_at(Clock::time_point{} + std::chrono::nanoseconds(deadline)));
      ended += document.ended == BudgetEnd::deadline;
      EXPECT_LE(work_done(), deadline + allowed) << name << " at " << part;
    }
  }
  EXPECT_EQ(ended, 6);
}

// What a mesh of many triangles takes is counted, and a caller ends it while it is read, weighed and checked.
TEST(ProblemBudget, AMeshOfManyTrianglesIsEnded) {
  // A ring of n by n squares.
  class Ring : public FileProvider {
   public:
    std::string bytes(const std::string& /*name*/) const override {
      constexpr int n = 120;
      std::string text;
      for (int i = 0; i < n * n; ++i) {
        const double u = 2 * std::numbers::pi * (i / n) / n, v = 2 * std::numbers::pi * (i % n) / n;
        text +=
            fmt::format("v {} {} {}\n", (3 + std::cos(v)) * std::cos(u), (3 + std::cos(v)) * std::sin(u), std::sin(v));
      }
      const auto corner = [](int i, int j) { return i % n * n + j % n + 1; };
      for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j)
          text +=
              fmt::format("f {} {} {} {}\n", corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1));
      return text;
    }
  };
  const std::string text =
      "title: A ring\nbodies: {ring: {mesh: {file: ring.obj, unit: m}, density: 1000 kg/m^3}}\nask: {m: mass(ring)}\n";
  const Work begin = work_done();
  const Problem problem = Problem::from_text(text, "ring.yaml", Ring());
  const Work read = work_done() - begin;
  EXPECT_GT(read, 4'000'000U);
  EXPECT_FALSE(problem.solve().ended);
  EXPECT_GT(work_done() - begin, read + 4'000'000U);
  const auto by_work = [] { return Clock::time_point{} + std::chrono::nanoseconds(work_done()); };
  const BudgetScope scope(Budget().by_clock(by_work).end_after(std::chrono::nanoseconds(read / 2)));
  EXPECT_THROW(Problem::from_text(text, "ring.yaml", Ring()), BudgetEnded);
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

}  // namespace problem_budget_test
}  // namespace poinsot::document
