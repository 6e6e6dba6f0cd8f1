#include <gtest/gtest.h>

#include "document/sample_documents.h"
#include "poinsot/rendering.h"

namespace poinsot::document {
namespace terminal_test {

TEST(Terminal, every_kind_of_answer_is_as_in_the_golden_text) {
  EXPECT_EQ(to_terminal(every_kind()), golden("every_kind.txt"));
}

TEST(Terminal, every_state_of_an_answer_is_as_in_the_golden_text) {
  EXPECT_EQ(to_terminal(every_state()), golden("every_state.txt"));
}

TEST(Terminal, color_adds_escape_sequences_and_nothing_else) {
  for (const Document& document : {every_kind(), every_state()}) {
    std::string text = to_terminal(document, {.color = true});
    EXPECT_NE(text.find("\x1b[1m"), std::string::npos);
    for (std::size_t begin = text.find('\x1b'); begin != std::string::npos; begin = text.find('\x1b')) {
      text.erase(begin, text.find('m', begin) + 1 - begin);
    }
    EXPECT_EQ(text, to_terminal(document));
  }
}

TEST(Terminal, significant_digits_are_those_of_the_style) {
  const Document document = document_of(found("a", Datum{1.23456789}, "m", Datum{1.23456789}));
  EXPECT_NE(to_terminal(document, {.digits = 3}).find("1.23 m\n"), std::string::npos);
  EXPECT_NE(to_terminal(document, {.digits = 9}).find("1.23456789 m\n"), std::string::npos);
}

TEST(Terminal, a_document_without_solution_says_so) {
  Document document;
  document.file = "a.yaml";
  document.title = "Top";
  document.warnings = {"no root between 0 and 90 deg"};
  EXPECT_EQ(to_terminal(document), "Top  (a.yaml)\n\n  no solution\n\nwarning: no root between 0 and 90 deg\n");
}

TEST(Terminal, letters_that_no_answer_needs_are_not_asked_for) {
  Document document = document_of(found("a", Datum{1.0}, "", {}));
  document.open_letters = {{"m", "kg"}};
  EXPECT_EQ(to_terminal(document).find("--set"), std::string::npos);
}

TEST(Terminal, columns_are_aligned_by_width_and_not_by_bytes) {
  Document document = document_of(found("θ", Datum{1.0}, "", {}));
  document.solutions[0].answers.push_back(found("ab", Datum{2.0}, "", {}));
  document.solutions[0].answers[0].words = "Höhe 高";
  document.solutions[0].answers[1].words = "mass";
  document.file = "f";
  EXPECT_EQ(to_terminal(document), "f\n\n  θ   Höhe 高  1\n  ab  mass     2\n");
}

TEST(Terminal, each_of_several_formulas_stands_beside_its_condition) {
  Answer answer = unanswered("top", AnswerState::needs_letters, "");
  answer.letters = {"d", "s"};
  answer.formula = Datum{std::string("d")};
  answer.formulas = {{answer.formula, {"d - s > 0"}}, {Datum{std::string("abs(s - d) + s")}, {"s - d > 0"}}};
  Document document = document_of(answer);
  document.file = "f";
  document.solutions[0].assumptions = {"d - s > 0 for 'top'"};
  EXPECT_EQ(to_terminal(document),
            "f\n\n  top  ask for top  d  where d - s > 0\n                    abs(s - d) + s  where s - d > 0\n");
  document.solutions[0].assumptions.push_back("m > 0");
  EXPECT_NE(to_terminal(document).find("  where m > 0\n"), std::string::npos);
}

TEST(Terminal, long_words_stand_on_a_line_of_their_own) {
  Document document = document_of(found("a", Datum{1.0}, "m", Datum{1.0}));
  document.file = "f";
  document.solutions[0].answers.push_back(found("long", Datum{2.0}, "m", Datum{2.0}));
  document.solutions[0].answers[0].words = "distance";
  document.solutions[0].answers[1].words = std::string(61, 'w');
  EXPECT_EQ(to_terminal(document),
            "f\n\n  a     distance  1 m\n  long  " + std::string(61, 'w') + "\n                  2 m\n");
}

TEST(Terminal, control_sequences_in_a_file_do_not_reach_the_terminal) {
  Document document = document_of(found("a\x1b[2J", Datum{std::string("\x1b]0;x\a")}, "\x1b[31m", {}));
  document.title = "\x1b[31mred\nline";
  document.file = "f\x1b";
  document.warnings = {"\x1b[0m"};
  document.open_letters = {{"m\x1b", "kg\x1b"}};
  Answer letters = unanswered("b", AnswerState::needs_letters, "");
  letters.letters = {"m\x1b"};
  document.solutions[0].answers.push_back(letters);
  document.solutions[0].answers.push_back(unanswered("c", AnswerState::undetermined, "\x1b[1m"));
  document.solutions[0].checks = {{"\x1bm", 0.0}};
  document.solutions[0].unknowns.push_back({"\x1bu", Datum{1.0}, "\x1b", {}});
  const std::string text = to_terminal(document);
  EXPECT_EQ(text.find('\x1b'), std::string::npos);
  EXPECT_EQ(text.find('\a'), std::string::npos);
  EXPECT_EQ(text.rfind("\xEF\xBF\xBD[31mred line  (f\xEF\xBF\xBD)\n", 0), 0U) << text;
}

std::string shown(const Datum& datum, const std::string& unit = "") {
  const std::string text = to_terminal(document_of(found("a", datum, unit, datum)));
  const std::string words = "ask for a  ";
  const std::size_t begin = text.find(words) + words.size();
  return text.substr(begin, text.size() - begin - 1);
}

TEST(Terminal, data_by_their_kind) {
  EXPECT_EQ(shown(Datum{-2.5}, "N*m"), "-2.5 N*m");
  EXPECT_EQ(shown(Datum{false}), "false");
  EXPECT_EQ(shown(list({})), "none");
  EXPECT_EQ(shown(texts({"A"})), "A");
  EXPECT_EQ(shown(numbers({1, 2e-12, -3}), "m"), "[1, 2e-12, -3] m");
  EXPECT_EQ(shown(numbers({1, 2e-12}), "m"), "[1, 2e-12] m");
  EXPECT_EQ(shown(list({numbers({1, 2}), numbers({3})})), "[[1, 2], [3]]");
  EXPECT_EQ(shown(list({Datum{1.0}, Datum{std::string("A")}})), "[1, A]");
}

// A value stands beside its words where it fits, or else below them: in the common column, or where that is too far to
// the right a little behind the words' beginning.
TEST(Terminal, what_does_not_fit_into_the_columns_stands_below_its_words) {
  Document document = document_of(found("ab", Datum{1.5}, "m", Datum{1.5}));
  document.file = "f";
  for (const auto& [name, words] : {std::pair("v", "velocity of A"), std::pair("w", "rate")}) {
    document.solutions[0].answers.push_back(found(name, numbers({10.25, -2.5}), "m/s", numbers({10.25, -2.5})));
    document.solutions[0].answers.back().words = words;
  }
  document.solutions[0].answers[0].words = "height of A";
  const std::string first = "f\n\n  ab  height of A  1.5 m\n  v   velocity of A\n";
  EXPECT_EQ(to_terminal(document, {.columns = 36}),
            first + "                   [10.25, -2.5] m/s\n  w   rate         [10.25, -2.5] m/s\n");
  EXPECT_EQ(to_terminal(document, {.columns = 35}),
            first + "        [10.25, -2.5] m/s\n  w   rate\n        [10.25, -2.5] m/s\n");
  EXPECT_NE(to_terminal(document).find("  v   velocity of A  [10.25, -2.5] m/s\n"), std::string::npos);
}

}  // namespace terminal_test
}  // namespace poinsot::document
