#include "poinsot/engine/work/work.h"

#include <gtest/gtest.h>

#include <thread>

#include "poinsot/engine/work/budget.h"

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

}  // namespace work_test
}  // namespace poinsot
