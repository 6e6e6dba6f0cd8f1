// Symbols set as labels.
#include "pictures/drawing/label_text.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <string_view>

#include "pictures/drawing/font_metrics.h"

namespace poinsot {
namespace label_text_test {

using namespace pictures;

// The runs as text, each with a letter for its face: i, u, b, B.
std::string told(const Label& label) {
  std::string text;
  for (const pictures::Run& run : label.runs) {
    text += text.empty() ? "" : " ";
    text += "uibB"[static_cast<std::size_t>(run.face)];
    text += run.offset.y > 0 ? "_" : run.offset.y < 0 ? "^" : ":";
    text += run.text;
  }
  for (const Accent& accent : label.accents)
    text += accent.kind == Accent::Kind::bar ? " bar" : accent.kind == Accent::Kind::dot ? " dot" : " dots";
  return text;
}

TEST(LabelText, raises_powers_of_ten_in_words) {
  EXPECT_EQ(told(words_label("2·10^6 s")), "u:2·10 u^6 u: s");
  EXPECT_EQ(told(words_label("1·10^−12")), "u:1·10 u^−12");
  EXPECT_EQ(told(words_label("a ^ b")), "u:a ^ b");
}

TEST(LabelText, reads_the_tex_of_worked_solutions) {
  EXPECT_EQ(told(tex_label("\\mathbf{C}")), "b:C");
  EXPECT_EQ(told(tex_label("m_1\\bar{\\mathbf{a}}")), "i:m u_1 b:a bar");
  EXPECT_EQ(told(tex_label("\\dot{\\mathbf{H}}_{G}")), "b:H i_G dot");
  EXPECT_EQ(told(tex_label("\\boldsymbol{\\omega}_{\\mathrm{disk}}")), "B:ω u_disk");
  EXPECT_EQ(told(tex_label("\\ddot{x}^2")), "i:x u^2 dots");
  EXPECT_EQ(told(tex_label("-F\\,\\Delta t")), "u:− i:F u:Δ i:t");
  EXPECT_EQ(told(name_label("omega_0 max")), "i:ω u_0 u:  i:max");
  EXPECT_EQ(told(name_label("P12")), "i:P u_12");
  EXPECT_EQ(told(name_label("phidot")), "i:φ dot");
  EXPECT_EQ(told(name_label("thetaddot1'")), "i:θ u_1 u:′ dots");
  EXPECT_EQ(told(name_label("robot, A")), "i:robot u:,  i:A");
  EXPECT_EQ(told(name_label("m v_ball")), "i:m u:  i:v i_ball");
  EXPECT_EQ(with_greek_letters("omega1"), "ω1");
  EXPECT_EQ(with_greek_letters("times"), "times");
  EXPECT_EQ(told(formula_label("-m*b*omega1^2*sin(2*beta)/12")), "u:− i:m i:b i:ω u_1 u^2 u:sin(2 i:β u:)/12");
  EXPECT_EQ(told(words_label("R = 5 N")), "u:R = 5 N");
}

// The center of a body among several: its name is no part of the word that the G would begin.
TEST(LabelText, an_index_of_an_index_stands_lower) {
  const Label label = tex_label("\\mathbf{H}_{G_{\\mathrm{one}}}c");
  ASSERT_EQ(label.runs.size(), 4U);
  EXPECT_EQ(label.runs[1].text, "G");
  EXPECT_EQ(label.runs[2].text, "one");
  EXPECT_GT(label.runs[2].offset.y, label.runs[1].offset.y);
  EXPECT_LT(label.runs[2].size, label.runs[1].size);
  EXPECT_GT(label.runs[2].size, 0.55 * label.runs[0].size);
  EXPECT_EQ(label.runs[3].offset.y, 0);
  EXPECT_EQ(label.runs[3].size, label.runs[0].size);
  EXPECT_GE(label.box.bottom, label.runs[2].offset.y);
}

TEST(LabelText, a_root_has_a_bar_over_all_of_it) {
  EXPECT_EQ(told(formula_label("-sqrt(2)*m*a/96")), "u:−√2 i:m i:a u:/96 bar");
  EXPECT_EQ(told(formula_label("sqrt(a + sqrt(b))*c")), "u:√ i:a u: + √ i:b i:c bar bar");
  EXPECT_EQ(told(formula_label("sqrt(a")), "u:sqrt( i:a");
  const Label label = formula_label("2*sqrt(g + h)*t");
  ASSERT_EQ(label.accents.size(), 1U);
  const auto run = [&](std::string_view text) { return *std::ranges::find(label.runs, text, &pictures::Run::text); };
  EXPECT_NEAR(label.accents[0].from.x, run("g").offset.x, 1e-9);
  EXPECT_NEAR(label.accents[0].to.x, run("h").offset.x + run("h").width, 1e-9);
  EXPECT_GT(run("t").offset.x, label.accents[0].to.x);
  EXPECT_LT(label.accents[0].from.y, 0);
}

TEST(LabelText, a_prime_stands_clear_of_a_bar) {
  const Label label = tex_label("\\bar{\\mathbf{v}}'");
  ASSERT_EQ(label.accents.size(), 1U);
  ASSERT_EQ(label.runs.size(), 2U);
  EXPECT_GT(label.runs[1].offset.x, label.accents[0].to.x + 1);
  EXPECT_EQ(tex_label("\\mathbf{v}'").runs.back().offset.x, tex_label("\\mathbf{v}").box.right);
}

TEST(LabelText, bears_with_any_text) {
  for (const char* text :
       {"", "\\", "\\mathbf", "{", "}", "{{{{", "_", "^_^", "\\bar", "\\dot{", "\\unknown{x}", "a_{b_{c_d}}"}) {
    const Label label = tex_label(text);
    for (const pictures::Run& run : label.runs) EXPECT_GE(run.width, 0) << text;
  }
  std::string deep;
  for (int i = 0; i < 20000; ++i) deep += "{\\mathbf{";
  EXPECT_LE(tex_label(deep).box.width(), longest_label + 40);
  EXPECT_LE(words_label(std::string(10000, 'W')).box.width(), longest_label + 40);
}

TEST(LabelText, widths_are_those_of_the_font) {
  // Times New Roman: W is 944 thousandths of the size, i 278, a digit 500; an italic W 833.
  EXPECT_DOUBLE_EQ(text_width("W", Face::upright, 1000), 944);
  EXPECT_DOUBLE_EQ(text_width("i5", Face::upright, 1000), 778);
  EXPECT_DOUBLE_EQ(text_width("W", Face::italic, 1000), 833);
  EXPECT_GT(text_width("ω", Face::italic, 1000), 400);
}

}  // namespace label_text_test
}  // namespace poinsot
