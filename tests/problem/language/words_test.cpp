#include "problem/language/words.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace poinsot::problem {
namespace words_test {

using Words = std::vector<std::string>;

TEST(Words, JoinsAndLists) {
  EXPECT_EQ(joined({}), "");
  EXPECT_EQ(joined({"a"}), "a");
  EXPECT_EQ(joined({"a", "b", "c"}), "a, b, c");
  EXPECT_EQ(joined({"a", "b"}, "; "), "a; b");
  EXPECT_EQ(joined({"", "b"}), ", b");
  EXPECT_EQ(listed({}), "");
  EXPECT_EQ(listed({"a"}), "a");
  EXPECT_EQ(listed({"a", "b"}), "a and b");
  EXPECT_EQ(listed({"a", "b", "c"}, "or"), "a, b or c");
}

TEST(Words, CountsThings) {
  EXPECT_EQ(counted(0, "start"), "no starts");
  EXPECT_EQ(counted(1, "start"), "one start");
  EXPECT_EQ(counted(12, "start"), "12 starts");
}

TEST(Words, NamesThingsAndKeepsEachOnce) {
  struct Thing {
    std::string name;
  };
  EXPECT_EQ(names_of(std::vector<Thing>{{"pin"}, {"rod"}}), (Words{"pin", "rod"}));
  Words list{"pin"};
  add_once<std::string>(list, "rod");
  add_once<std::string>(list, "pin");
  EXPECT_EQ(list, (Words{"pin", "rod"}));
}

TEST(Words, GivesNumbersTheirSignificantDigits) {
  EXPECT_EQ(with_digits(1.0 / 3, 4), "0.3333");
  EXPECT_EQ(with_digits(1234567, 4), "1.235e+06");
  EXPECT_EQ(with_digits(-2.5, 6), "-2.5");
  EXPECT_EQ(with_digits(0.1, 17), "0.10000000000000001");
}

}  // namespace words_test
}  // namespace poinsot::problem
