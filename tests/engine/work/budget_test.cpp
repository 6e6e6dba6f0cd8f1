#include "poinsot/engine/work/budget.h"

#include <gtest/gtest.h>

#include <string>
#include <thread>
#include <type_traits>
#include <vector>

#include "poinsot/engine/work/work.h"

namespace poinsot {
namespace budget_test {

using Clock = Budget::Clock;
using std::chrono::microseconds;
using std::chrono::milliseconds;

// A clock that goes on by a step whenever it is looked at.
struct SteppingClock {
  Clock::duration step;
  Clock::time_point now{};
  int looks = 0;
  Clock::time_point operator()() {
    ++looks;
    return now += step;
  }
};

TEST(Budget, nothing_ends_without_a_scope) {
  EXPECT_FALSE(budget_ended());
  EXPECT_NO_THROW(check_budget());
  EXPECT_NO_THROW(ProgressTeller("roots").tell(0.5));
}

TEST(Budget, nothing_ends_and_no_clock_is_read_where_a_budget_bounds_nothing) {
  SteppingClock clock{milliseconds(1)};
  const BudgetScope scope(Budget().by_clock(std::ref(clock)));
  for (int i = 0; i < 1000; ++i) ASSERT_FALSE(budget_ended());
  EXPECT_EQ(clock.looks, 0);
}

TEST(Budget, a_deadline_ends_the_work_and_stays) {
  Clock::time_point now{};
  const BudgetScope scope(Budget().by_clock([&now] { return now; }).end_after(milliseconds(5)));
  EXPECT_FALSE(budget_ended());
  now += milliseconds(6);
  for (int i = 0; i < 16; ++i) budget_ended();
  EXPECT_EQ(how_budget_ended(), BudgetEnd::deadline);
  now = {};
  EXPECT_TRUE(budget_ended());
}

TEST(Budget, the_end_says_what_it_was) {
  const std::atomic<bool> flag = true;
  const BudgetScope scope(Budget().end_when(&flag));
  try {
    check_budget();
    FAIL() << "the flag was not seen";
  } catch (const BudgetEnded& ended) {
    EXPECT_EQ(words_of(ended.end), "interrupted");
  }
  EXPECT_EQ(words_of(BudgetEnd::deadline), "ended by the deadline");
}

// Code that answers errors by "there is no formula" must let the end pass.
TEST(Budget, the_end_is_no_error) { EXPECT_FALSE((std::is_base_of_v<std::exception, BudgetEnded>)); }

TEST(Budget, a_flag_or_a_stop_ends_at_the_next_call) {
  std::atomic<bool> flag = false;
  const BudgetScope outer(Budget().end_when(&flag));
  {
    std::stop_source source;
    const BudgetScope scope(Budget().end_when(source.get_token()));
    EXPECT_FALSE(budget_ended());
    source.request_stop();
    EXPECT_EQ(how_budget_ended(), BudgetEnd::interrupted);
  }
  EXPECT_FALSE(budget_ended());
  flag = true;
  EXPECT_TRUE(budget_ended());
}

TEST(Budget, a_scope_ends_with_those_around_it_and_leaves_them_as_they_were) {
  Clock::time_point now{};
  const auto clock = [&now] { return now; };
  const BudgetScope outer(Budget().by_clock(clock).end_after(milliseconds(50)));
  {
    const BudgetScope inner(Budget().by_clock(clock).end_after(milliseconds(10)));
    EXPECT_FALSE(budget_ended());
    now += milliseconds(20);
    for (int i = 0; i < 16; ++i) budget_ended();
    EXPECT_TRUE(budget_ended());
  }
  EXPECT_FALSE(budget_ended());
  const BudgetScope inner(Budget().by_clock(clock).end_after(milliseconds(1000)));
  now += milliseconds(50);
  for (int i = 0; i < 16; ++i) budget_ended();
  EXPECT_TRUE(budget_ended());
}

TEST(Budget, a_respite_sets_it_aside) {
  const std::atomic<bool> flag = true;
  const BudgetScope scope(Budget().end_when(&flag));
  {
    const BudgetRespite respite;
    EXPECT_FALSE(budget_ended());
  }
  EXPECT_TRUE(budget_ended());
}

TEST(Budget, a_grace_gives_a_little_time_after_the_end) {
  const std::atomic<bool> flag = true;
  const BudgetScope scope(Budget().end_when(&flag));
  {
    const BudgetGrace grace;
    EXPECT_FALSE(budget_ended());
    EXPECT_NO_THROW(count_work(10'000'000));
    const auto work_on = [] {
      for (int i = 0; i < 20; ++i) count_work(1'000'000);
    };
    EXPECT_THROW(work_on(), BudgetEnded);
  }
  EXPECT_EQ(how_budget_ended(), BudgetEnd::interrupted);
}

// Work that counts too little for the time it takes ends by the clock of what has ended.
TEST(Budget, a_grace_ends_by_the_clock_as_well) {
  Clock::time_point now{};
  const BudgetScope scope(Budget().by_clock([&now] { return now; }).end_after(milliseconds(10)));
  now += milliseconds(10);
  EXPECT_TRUE(budget_ended());
  const BudgetGrace grace;
  EXPECT_FALSE(budget_ended());
  now += milliseconds(20);
  for (int i = 0; i < 16; ++i) EXPECT_FALSE(budget_ended());
  now += milliseconds(25);
  bool ended = false;
  for (int i = 0; i < 16; ++i) ended = ended || budget_ended();
  EXPECT_TRUE(ended);
}

// Calls every microsecond look at the clock seldom; when each call takes three milliseconds the deadline is still seen
// within fifty.
TEST(Budget, the_clock_is_looked_at_seldom_and_the_deadline_is_seen_in_time) {
  Clock::time_point now{};
  int looks = 0;
  const auto clock = [&] {
    ++looks;
    return now;
  };
  const BudgetScope scope(Budget().by_clock(clock).end_after(milliseconds(100)));
  for (int i = 0; i < 16000; ++i) {
    now += microseconds(1);
    ASSERT_FALSE(budget_ended());
  }
  EXPECT_LT(looks, 1100);
  while (!budget_ended()) now += milliseconds(3);
  EXPECT_LT(now - Clock::time_point{}, milliseconds(150));
}

// Eigenvalues of many bodies take some forty milliseconds a call, and the calls before them next to nothing.
TEST(Budget, a_call_that_counts_much_looks_at_the_clock) {
  Clock::time_point now{};
  const BudgetScope scope(Budget().by_clock([&] { return now; }).end_after(milliseconds(100)));
  const auto count = [&] {
    try {
      for (int i = 0; i < 31; ++i) count_work(10);
      for (int i = 0; i < 15; ++i) {
        now += milliseconds(40);
        count_work(2'000'000);
      }
    } catch (const BudgetEnded&) {
      return false;
    }
    return true;
  };
  while (count())
    ;
  EXPECT_LE(now - Clock::time_point{}, milliseconds(120));
}

TEST(Budget, progress_is_told_ten_times_a_second) {
  SteppingClock clock{milliseconds(1)};
  std::vector<std::string> told;
  const BudgetScope outer(
      Budget().by_clock(std::ref(clock)).tell([&](const Progress& progress) { told.emplace_back(progress.doing); }));
  const BudgetScope inner{Budget()};  // one without a listener leaves it to the next one
  const ProgressTeller steps("steps");
  for (int i = 0; i < 1000; ++i) steps.tell({}, 1);
  EXPECT_EQ(told, std::vector<std::string>(10, "steps"));
}

TEST(Budget, progress_is_told_of_the_whole_and_not_of_what_is_done_within_it) {
  SteppingClock clock{milliseconds(200)};
  std::vector<std::string> told;
  const BudgetScope scope(
      Budget().by_clock(std::ref(clock)).tell([&](const Progress& progress) { told.emplace_back(progress.doing); }));
  {
    const ProgressTeller search("search");
    search.tell({}, 1);
    const ProgressTeller motion("motion");
    motion.tell(0.5);
    search.tell({}, 2);
  }
  ProgressTeller("motion").tell(0.5);
  EXPECT_EQ(told, (std::vector<std::string>{"search", "search", "motion"}));
}

TEST(Budget, it_holds_for_its_thread_alone) {
  const std::atomic<bool> flag = true;
  const BudgetScope scope(Budget().end_when(&flag));
  bool ended_elsewhere = true;
  std::thread([&] { ended_elsewhere = budget_ended(); }).join();
  EXPECT_FALSE(ended_elsewhere);
  EXPECT_TRUE(budget_ended());
}

}  // namespace budget_test
}  // namespace poinsot
