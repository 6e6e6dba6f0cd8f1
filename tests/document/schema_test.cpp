// The schema is held against documents, with a validator of its own, in tests/apps/command_line_test.py.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>

#include "poinsot/rendering.h"

namespace poinsot::document {
namespace schema_test {

TEST(AnswerSchema, is_json_that_ends_in_a_newline) {
  EXPECT_EQ(answer_schema().back(), '\n');
  const auto schema = nlohmann::json::parse(answer_schema());
  EXPECT_EQ(schema.at("$schema"), "https://json-schema.org/draft/2020-12/schema");
}

// Every reference points to a definition, and every definition is referred to.
TEST(AnswerSchema, references_and_definitions_agree) {
  const auto schema = nlohmann::json::parse(answer_schema());
  std::set<std::string> referred;
  const auto flat = schema.flatten();
  for (const auto& [path, value] : flat.items()) {
    if (path.ends_with("/$ref")) referred.insert(value.get<std::string>());
  }
  std::set<std::string> defined;
  for (const auto& [name, definition] : schema.at("$defs").items()) defined.insert("#/$defs/" + name);
  EXPECT_EQ(referred, defined);
}

}  // namespace schema_test
}  // namespace poinsot::document
