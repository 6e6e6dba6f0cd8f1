#include "document/check.h"

#include <gtest/gtest.h>

#include <cmath>

#include "document/sample_documents.h"

namespace poinsot::document {
namespace check_test {

using Lines = std::vector<std::string>;

// The shortfalls of one answer `a` against one expectation.
Lines compare(const Datum& answer, const Datum& expected, double relative_tolerance = 1e-6) {
  return shortfalls(document_of(found("a", answer, "", answer)),
                    {{.part = "a", .si = expected, .columns = {}, .relative_tolerance = relative_tolerance}});
}

Document with_roots(const std::vector<double>& values) {
  Document document;
  for (double value : values) document.solutions.push_back({{}, {found("a", Datum{value}, "", Datum{value})}, {}, {}});
  return document;
}

TEST(Check, a_number_within_its_tolerance_agrees) {
  EXPECT_EQ(compare(Datum{1000.0009}, Datum{1000.0}), Lines{});
  EXPECT_EQ(compare(Datum{1000.0011}, Datum{1000.0}),
            Lines{"a: 1000.0011, expected 1000 (off by 0.0011, allowed 0.001)"});
  EXPECT_EQ(compare(Datum{-999.0}, Datum{-1000.0}, 1e-2), Lines{});
}

TEST(Check, a_sign_matters) {
  EXPECT_EQ(compare(Datum{-3.0}, Datum{3.0}), Lines{"a: -3, expected 3 (off by 6, allowed 3e-6)"});
}

// The largest answer in the same unit says how large such a quantity is; where there is none, a zero is held to 1e-9
// SI.
TEST(Check, zero_is_held_to_the_other_answers_in_its_unit) {
  EXPECT_EQ(compare(Datum{0.0}, Datum{0.0}), Lines{});
  EXPECT_EQ(compare(Datum{0.9e-9}, Datum{0.0}), Lines{});
  EXPECT_EQ(compare(Datum{1.1e-9}, Datum{0.0}).size(), 1U);
  const auto beside = [](double zero, double size, const std::string& unit) {
    Document document = document_of(found("a", Datum{zero}, "N", Datum{zero}));
    document.solutions.front().answers.push_back(found("b", Datum{size}, unit, Datum{size}));
    return shortfalls(document,
                      {{.part = "a", .si = Datum{0.0}, .columns = {}}, {.part = "b", .si = Datum{size}, .columns = {}}})
        .size();
  };
  for (const double size : {1e-9, 1.0, 1e9}) {
    EXPECT_EQ(beside(0.9e-6 * size, size, "N"), 0U) << size;
    EXPECT_EQ(beside(1.1e-6 * size, size, "N"), 1U) << size;
    EXPECT_EQ(beside(0.9e-9, size, "m"), 0U) << size;
    EXPECT_EQ(beside(1.1e-9, size, "m"), 1U) << size;
  }
}

TEST(Check, an_absolute_tolerance_is_added) {
  const Document document = document_of(found("a", Datum{0.05}, "", Datum{0.05}));
  EXPECT_EQ(shortfalls(document, {{.part = "a", .si = Datum{0.0}, .columns = {}, .absolute_tolerance = 0.06}}),
            Lines{});
  EXPECT_EQ(shortfalls(document, {{.part = "a", .si = Datum{0.0}, .columns = {}, .absolute_tolerance = 0.04}}).size(),
            1U);
}

TEST(Check, what_is_no_number_never_agrees) {
  EXPECT_EQ(compare(Datum{std::nan("")}, Datum{1.0}).size(), 1U);
  EXPECT_EQ(compare(Datum{INFINITY}, Datum{1.0}).size(), 1U);
  EXPECT_EQ(compare(numbers({1, std::nan(""), 0}), numbers({1, 0, 0})).size(), 1U);
  EXPECT_EQ(compare(Datum{true}, Datum{1.0}), Lines{"a: true, expected the number 1"});
}

TEST(Check, a_component_is_measured_by_the_largest) {
  EXPECT_EQ(compare(numbers({100, 0.00009, 0}), numbers({100, 0, 0})), Lines{});
  EXPECT_EQ(compare(numbers({100, 0.0002, 0}), numbers({100, 0, 0})),
            Lines{"a: (100, 0.0002, 0), expected (100, 0, 0) (off by 0.0002, allowed 0.0001)"});
}

TEST(Check, each_row_of_a_matrix_has_its_own_scale) {
  EXPECT_EQ(compare(list({numbers({100, 0}), numbers({0, 1})}), list({numbers({100, 0}), numbers({0, 1})})), Lines{});
  EXPECT_EQ(compare(list({numbers({100, 0.00005}), numbers({0, 1})}), list({numbers({100, 0}), numbers({0, 1})})),
            Lines{});
  EXPECT_EQ(
      compare(list({numbers({100, 0}), numbers({0.00005, 1})}), list({numbers({100, 0}), numbers({0, 1})})).size(), 1U);
}

TEST(Check, lists_must_have_the_same_length) {
  EXPECT_EQ(compare(numbers({1, 2}), numbers({1, 2, 3})), Lines{"a: [1, 2], expected (1, 2, 3)"});
  EXPECT_EQ(compare(Datum{1.0}, numbers({1, 2})), Lines{"a: 1, expected the list [1, 2]"});
  EXPECT_EQ(compare(numbers({1, 2}), Datum{1.0}), Lines{"a: [1, 2], expected the number 1"});
}

TEST(Check, truth_values_and_texts_must_be_equal) {
  EXPECT_EQ(compare(Datum{true}, Datum{true}), Lines{});
  EXPECT_EQ(compare(Datum{true}, Datum{false}), Lines{"a: true, expected false"});
  EXPECT_EQ(compare(Datum{1.0}, Datum{true}), Lines{"a: 1, expected true"});
  EXPECT_EQ(compare(Datum{std::string("direct")}, Datum{std::string("direct")}), Lines{});
  EXPECT_EQ(compare(Datum{std::string("direct")}, Datum{std::string("retrograde")}),
            Lines{"a: direct, expected retrograde"});
}

TEST(Check, names_may_stand_in_any_order) {
  EXPECT_EQ(compare(texts({"C", "B"}), texts({"B", "C"})), Lines{});
  EXPECT_EQ(compare(texts({"B", "D"}), texts({"B", "C"})), Lines{"a: B, D, expected B, C"});
  EXPECT_EQ(compare(texts({"B", "B"}), texts({"B", "C"})), Lines{"a: B, B, expected B, C"});
  EXPECT_EQ(compare(numbers({1, 2}), texts({"B", "C"})), Lines{"a: [1, 2], expected B, C"});
}

TEST(Check, the_value_serves_where_si_is_empty) {
  EXPECT_EQ(
      shortfalls(document_of(found("a", texts({"B"}), "", {})), {{.part = "a", .si = texts({"B"}), .columns = {}}}),
      Lines{});
}

TEST(Check, every_solution_must_agree) {
  EXPECT_EQ(shortfalls(with_roots({3, 3}), {{.part = "a", .si = Datum{3.0}, .columns = {}}}), Lines{});
  EXPECT_EQ(shortfalls(with_roots({3, 4}), {{.part = "a", .si = Datum{3.0}, .columns = {}}}),
            Lines{"a (solution 2): 4, expected 3 (off by 1, allowed 3e-6)"});
}

TEST(Check, roots_are_one_number_for_each_solution) {
  const auto roots = [](const std::vector<double>& values) {
    return std::vector<Expectation>{{.part = "a", .si = numbers(values), .columns = {}, .roots = true}};
  };
  EXPECT_EQ(shortfalls(with_roots({5.5, 395}), roots({395, 5.5})), Lines{});
  EXPECT_EQ(shortfalls(with_roots({5.5}), roots({395, 5.5})), Lines{"a: roots [5.5], expected [5.5, 395]"});
  EXPECT_EQ(shortfalls(with_roots({5.5001, 395}), roots({5.5, 395})),
            Lines{"a: root 5.5001, expected 5.5 (off by 0.0001, allowed 5.5e-6)"});
  EXPECT_EQ(shortfalls(with_roots({5.5, 5.5}), roots({5.5, 395})).size(), 1U);
  EXPECT_EQ(shortfalls(with_roots({5.5}), {{.part = "a", .si = Datum{5.5}, .columns = {}, .roots = true}}),
            Lines{"a: the expected roots must be a list, not 5.5"});
}

TEST(Check, columns_of_a_table) {
  Answer table = found("a", {}, "", {});
  table.columns = {{"t", "s", {0, 1}, {0, 1}}, {"Ay", "lb", {0, 2}, {1e-10, 8.896}}};
  const Document document = document_of(table);
  const auto expected = [](std::vector<ExpectedColumn> columns) {
    return std::vector<Expectation>{{.part = "a", .si = {}, .columns = std::move(columns)}};
  };
  const ExpectedColumn t{"t", {0, 1}}, Ay{"Ay", {0, 8.896}};
  EXPECT_EQ(shortfalls(document, expected({t, Ay})), Lines{});
  EXPECT_EQ(shortfalls(document, expected({Ay, t})), Lines{});
  EXPECT_EQ(shortfalls(document, expected({t})), Lines{"a: 2 columns, expected 1"});
  EXPECT_EQ(shortfalls(document, expected({t, {"Az", Ay.si}})), Lines{"a: no column 'Az': there are t, Ay"});
  EXPECT_EQ(shortfalls(document, expected({t, {"Ay", {0}}})), Lines{"a: column Ay has 2 rows, expected 1"});
  EXPECT_EQ(shortfalls(document, expected({t, {"Ay", {0, 9}}})),
            Lines{"a: column Ay, row 2: 8.896, expected 9 (off by 0.1, allowed 9e-6)"});
  EXPECT_EQ(shortfalls(document, {{.part = "a", .si = Datum{1.0}, .columns = {}}}), Lines{"a: a table, expected 1"});
}

TEST(Check, no_solution_is_expected_by_no_roots_of_any_part) {
  Document none = document_of(found("a", Datum{1.0}, "", Datum{1.0}));
  none.solutions.clear();
  const Expectation no_root{.part = "a", .si = numbers({}), .columns = {}, .roots = true};
  EXPECT_EQ(shortfalls(none, {no_root}), Lines{});
  EXPECT_EQ(shortfalls(none, {no_root, {.part = "b", .si = Datum{1.0}, .columns = {}}}), Lines{"no solution"});
  EXPECT_EQ(shortfalls(none, {}), Lines{"no solution"});
  const Document one = document_of(found("a", Datum{1.0}, "", Datum{1.0}));
  EXPECT_EQ(shortfalls(one, {no_root}), Lines{"a: roots [1], expected none"});
}

TEST(Check, an_answer_that_is_not_there_falls_short_with_its_reason) {
  const std::vector<Expectation> expectations{{.part = "a", .si = Datum{1.0}, .columns = {}}};
  Answer letters = unanswered("a", AnswerState::needs_letters, "");
  letters.letters = {"m", "r"};
  EXPECT_EQ(shortfalls(document_of(letters), expectations), Lines{"a: needs values for m, r"});
  EXPECT_EQ(shortfalls(document_of(unanswered("a", AnswerState::undetermined, "one equation short")), expectations),
            Lines{"a: not determined: one equation short"});
  EXPECT_EQ(shortfalls(document_of(unanswered("a", AnswerState::refused, "momentum 3e-2")), expectations),
            Lines{"a: refused: momentum 3e-2"});
}

TEST(Check, questions_and_expectations_must_match) {
  const Document document = document_of(found("a", Datum{1.0}, "", Datum{1.0}));
  EXPECT_EQ(shortfalls(document, {}), Lines{"a: no answer is expected"});
  EXPECT_EQ(shortfalls(document, {{.part = "a", .si = Datum{1.0}, .columns = {}},
                                  {.part = "b", .si = Datum{1.0}, .columns = {}}}),
            Lines{"b: the file does not ask for it"});
}

TEST(Check, without_solution_nothing_agrees) { EXPECT_EQ(shortfalls({}, {}), Lines{"no solution"}); }

}  // namespace check_test
}  // namespace poinsot::document
