#include "poinsot/document.h"

#include <gtest/gtest.h>

#include <limits>

#include "document/sample_documents.h"
#include "poinsot/rendering.h"

namespace poinsot::document {
namespace document_test {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

TEST(FullyAnswered, needs_a_solution_and_every_answer) {
  EXPECT_FALSE(fully_answered({}));
  EXPECT_TRUE(fully_answered(every_kind()));
  EXPECT_FALSE(fully_answered(every_state()));
  for (AnswerState state : {AnswerState::needs_letters, AnswerState::undetermined, AnswerState::refused}) {
    EXPECT_FALSE(fully_answered(document_of(unanswered("a", state, "reason"))));
  }
}

std::string message_of(const Document& document) {
  try {
    require_values(document);
  } catch (const std::domain_error& error) {
    return error.what();
  }
  return "";
}

TEST(RequireValues, lets_pass_what_may_be_shown) {
  EXPECT_EQ(message_of({}), "");
  EXPECT_EQ(message_of(every_kind()), "");
  EXPECT_EQ(message_of(every_state()), "");
}

TEST(RequireValues, names_the_place_of_a_number_that_is_not_finite) {
  EXPECT_EQ(message_of(document_of(found("a", Datum{infinity}, "m", Datum{1.0}))),
            "the answer to 'a' has infinity in place of a number");
  EXPECT_EQ(message_of(document_of(found("a", Datum{1.0}, "m", list({numbers({0, nan, 0})})))),
            "the answer to 'a' has NaN in place of a number");

  Document unknown = document_of(found("a", Datum{1.0}, "", {}));
  unknown.solutions[0].unknowns.push_back({"w", Datum{-infinity}, "rad/s", Datum{0.0}});
  EXPECT_EQ(message_of(unknown), "the unknown 'w' has infinity in place of a number");

  Answer table = found("b", {}, "", {});
  table.columns = {{"t", "s", {0, 1}, {0, nan}}};
  EXPECT_EQ(message_of(document_of(table)), "the answer to 'b' (column t) has NaN in place of a number");
}

TEST(RequireValues, names_what_counts_as_found_and_has_no_value) {
  EXPECT_EQ(message_of(document_of(found("a", {}, "", {}))), "the answer to 'a' has no value");
  Document unknown;
  unknown.solutions.push_back({{{"w", {}, "", {}}}, {}, {}, {}});
  EXPECT_EQ(message_of(unknown), "the unknown 'w' has no value");
}

TEST(RequireValues, is_asked_by_every_rendering) {
  const Document document = document_of(found("a", Datum{nan}, "", {}));
  EXPECT_THROW(to_json(document), std::domain_error);
  EXPECT_THROW(to_terminal(document), std::domain_error);
}

}  // namespace document_test
}  // namespace poinsot::document
