// What evaluates quantities says of one whose value stands nowhere.
#include "problem/quantities/quantity_values.h"

#include <gtest/gtest.h>

namespace poinsot::problem {
namespace quantity_values_test {

TEST(QuantityValues, ARowWithoutAValueIsNamedAndGetsNoOther) {
  EXPECT_NO_THROW(require_one_of("sliding", {"sticking", "sliding", "parting"}));
  try {
    require_one_of("virial", {"kinetic_energy"});
    FAIL();
  } catch (const std::logic_error& error) {
    EXPECT_STREQ(error.what(), "the quantity 'virial' has a row in its table and no value");
  }
}

}  // namespace quantity_values_test
}  // namespace poinsot::problem
