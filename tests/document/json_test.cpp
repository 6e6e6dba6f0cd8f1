#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>
#include <random>

#include "document/sample_documents.h"
#include "poinsot/rendering.h"

namespace poinsot::document {
namespace json_test {

using nlohmann::json;

TEST(AnswerJson, every_kind_of_answer_is_as_in_the_golden_document) {
  EXPECT_EQ(to_json(every_kind()) + "\n", golden("every_kind.json"));
}

TEST(AnswerJson, every_state_of_an_answer_is_as_in_the_golden_document) {
  EXPECT_EQ(to_json(every_state()) + "\n", golden("every_state.json"));
}

TEST(AnswerJson, gives_the_version) { EXPECT_EQ(json::parse(to_json({})).at("poinsot"), POINSOT_VERSION); }

TEST(AnswerJson, a_document_without_content_has_empty_lists) {
  const json document = json::parse(to_json({}));
  EXPECT_TRUE(document.at("solutions").is_array());
  EXPECT_TRUE(document.at("solutions").empty());
  EXPECT_TRUE(document.at("warnings").is_array());
}

TEST(AnswerJson, answers_keep_the_order_of_the_file) {
  Document document = document_of(found("z", Datum{1.0}, "", Datum{1.0}));
  document.solutions[0].answers.push_back(found("a", Datum{2.0}, "", Datum{2.0}));
  const auto answers = nlohmann::ordered_json::parse(to_json(document)).at("solutions").at(0).at("answers");
  EXPECT_EQ(answers.begin().key(), "z");
  EXPECT_EQ(std::next(answers.begin()).key(), "a");
}

TEST(AnswerJson, one_thousand_random_doubles_read_back_as_the_same_bits) {
  std::mt19937_64 random(18);
  std::uniform_real_distribution<double> mantissa(-10, 10);
  std::uniform_int_distribution<int> power(-300, 300);
  std::vector<double> values{0.1, -0.0, 5e-324, std::numeric_limits<double>::max(), 1.0 / 3};
  for (int i = 0; i < 1000; ++i) values.push_back(mantissa(random) * std::pow(10.0, power(random)));
  const json answer = json::parse(to_json(document_of(found("a", numbers(values), "", numbers(values)))))
                          .at("solutions")
                          .at(0)
                          .at("answers")
                          .at("a");
  ASSERT_EQ(answer.at("value").size(), values.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    EXPECT_EQ(answer.at("value").at(i).get<double>(), values[i]);
    EXPECT_EQ(std::signbit(answer.at("si").at(i).get<double>()), std::signbit(values[i]));
  }
}

TEST(AnswerJson, stays_on_one_line_whatever_the_texts) {
  Document document = document_of(found("a", Datum{std::string("two\nlines")}, "", {}));
  document.title = "title\nwith \"quotes\"\r\n";
  document.warnings = {"tab\t, line\n"};
  const std::string text = to_json(document);
  EXPECT_EQ(text.find('\n'), std::string::npos);
  EXPECT_EQ(json::parse(text).at("title"), document.title);
}

TEST(AnswerJson, bytes_that_are_no_utf8_are_replaced) {
  Document document;
  document.file = "caf\xE9.yaml";
  EXPECT_EQ(json::parse(to_json(document)).at("file"), "caf\xEF\xBF\xBD.yaml");
}

TEST(AnswerJson, a_residual_that_could_not_be_formed_is_null) {
  Document document = document_of(found("a", Datum{1.0}, "", {}));
  document.solutions[0].checks = {{"momentum", std::numeric_limits<double>::quiet_NaN()}};
  const json checks = json::parse(to_json(document)).at("solutions").at(0).at("checks");
  EXPECT_TRUE(checks.at("momentum").is_null());
}

TEST(AnswerJson, si_of_an_answer_without_unit_is_its_value) {
  const json document = json::parse(to_json(document_of(found("a", texts({"B", "C"}), "", {}))));
  EXPECT_EQ(document.at("solutions").at(0).at("answers").at("a").at("si"), json({"B", "C"}));
}

}  // namespace json_test
}  // namespace poinsot::document
