#include "poinsot/engine/work/work.h"

#include <gtest/gtest.h>

#include <thread>

#include "poinsot/engine/work/budget.h"
#include "poinsot/engine/work/work_scope.h"

namespace poinsot {
namespace work_test {

TEST(Work, a_limit_is_spent_by_what_is_counted_after_it_was_set) {
  count_work(1000);
  const WorkLimit limit(100);
  EXPECT_EQ(limit.left(), 100U);
  count_work(75);
  EXPECT_EQ(limit.left(), 25U);
  EXPECT_DOUBLE_EQ(limit.part_spent(), 0.75);
  count_work(25);
  EXPECT_FALSE(limit.spent());
  count_work(1);
  EXPECT_TRUE(limit.spent());
  EXPECT_EQ(limit.left(), 0U);
}

TEST(Work, what_is_unlimited_is_never_spent) {
  count_work(10);
  const WorkLimit limit(unlimited_work);
  count_work(1'000'000'000'000);
  EXPECT_FALSE(limit.spent());
  EXPECT_LT(limit.part_spent(), 1e-6);
}

TEST(Work, threads_count_apart) {
  const WorkLimit limit(100);
  std::thread([] { count_work(1000); }).join();
  EXPECT_EQ(limit.left(), 100U);
}

TEST(Work, counting_looks_at_the_budget) {
  const std::atomic<bool> flag = true;
  const BudgetScope scope(Budget().end_when(&flag));
  EXPECT_THROW(count_work(1), BudgetEnded);
}

// What is done within a scope ends with it, and what is around it goes on.
TEST(Work, a_scope_ends_what_does_more) {
  Work done = 0;
  const auto work_up_to = [&](Work most) {
    const WorkScope scope(most);
    try {
      for (done = 0; done < 1'000'000; done += 100) count_work(100);
    } catch (const BudgetEnded& ended) {
      EXPECT_EQ(ended.end, BudgetEnd::deadline);
      return true;
    }
    return false;
  };
  EXPECT_TRUE(work_up_to(100'000));
  EXPECT_GE(done, 99'000U);
  EXPECT_LE(done, 110'000U);
  EXPECT_FALSE(work_up_to(2'000'000));
  EXPECT_NO_THROW(count_work(1'000'000));
}

}  // namespace work_test
}  // namespace poinsot
