// Sizes whose sign is decided by the pose, against those that hold for any.
#include "poinsot/engine/math/formula/formula_sizes.h"

#include <gtest/gtest.h>

#include "poinsot/engine/math/formula/formula_decision.h"

namespace poinsot {
namespace formula_sizes_test {

const Formula a = Formula::letter("a", Sign::positive), u = Formula::letter("u", Sign::real);

TEST(DecidedSizes, have_the_sign_at_the_point_of_decisions_which_is_recorded) {
  for (const double at : {0.7, -0.7}) {
    const PlainPointScope point({{"u", at}});
    const Formula expected = at < 0 ? -u : u;
    const DecisionScope decisions;
    {
      const DecidedSizesScope sizes;
      EXPECT_EQ(sqrt(u * u), expected);
      EXPECT_EQ(abs(a * u), a * expected);
      EXPECT_EQ(sqrt(a * a * u * u), a * expected);
      EXPECT_EQ(sqrt(a * a), a);
    }
    ASSERT_EQ(decisions.signs().size(), 1U);
    EXPECT_EQ(decisions.signs().front(), u);
  }
}

TEST(DecidedSizes, hold_within_their_scope_only) {
  const PlainPointScope point({{"u", 0.7}});
  { const DecidedSizesScope sizes; }
  EXPECT_NE(sqrt(u * u), u);
  {
    const DecidedSizesScope none(false);
    EXPECT_NE(abs(u), u);
    {
      const DecidedSizesScope sizes;
      const DecidedSizesScope within(false);
      EXPECT_EQ(abs(u), u);
    }
    EXPECT_NE(abs(u), u);
  }
}

// The root of what has no square in it is the same.
TEST(DecidedSizes, leave_roots_of_other_things) {
  const Formula x = u * u * u + a;
  const Formula outside = sqrt(x);
  const DecidedSizesScope sizes;
  EXPECT_EQ(sqrt(x), outside);
}

}  // namespace formula_sizes_test
}  // namespace poinsot
