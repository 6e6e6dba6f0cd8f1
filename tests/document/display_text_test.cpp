#include "document/display_text.h"

#include <gtest/gtest.h>

#include <random>

namespace poinsot::document {
namespace display_text_test {

constexpr const char* replacement = "\xEF\xBF\xBD";

TEST(DisplayWidth, counts_columns_and_not_bytes) {
  EXPECT_EQ(display_width(""), 0U);
  EXPECT_EQ(display_width("kg*m^2/s"), 8U);
  EXPECT_EQ(display_width("ωθφ"), 3U);
  EXPECT_EQ(display_width("高さ"), 4U);
  EXPECT_EQ(display_width("e\u0301"), 1U);
  EXPECT_EQ(display_width("🚀"), 2U);
  EXPECT_EQ(display_width("\xFF"), 1U);
}

TEST(Padded, up_to_the_width_and_no_further) {
  EXPECT_EQ(padded_right("θ", 3), "θ  ");
  EXPECT_EQ(padded_left("θ", 3), "  θ");
  EXPECT_EQ(padded_right("abcd", 3), "abcd");
  EXPECT_EQ(padded_left("abcd", 3), "abcd");
}

TEST(Printable, keeps_text_in_any_script) { EXPECT_EQ(printable("Kreisel ωθ 高さ 🚀"), "Kreisel ωθ 高さ 🚀"); }

TEST(Printable, takes_power_from_control_characters) {
  EXPECT_EQ(printable("a\nb\tc\rd"), "a b c d");
  EXPECT_EQ(printable(std::string_view("\0", 1)), replacement);
  EXPECT_EQ(printable("\x1b[2J"), std::string(replacement) + "[2J");
  EXPECT_EQ(printable("\x7F"), replacement);
  EXPECT_EQ(printable("\u009B"), replacement);
  EXPECT_EQ(printable("\u202E"), replacement);
}

TEST(Printable, shows_what_is_invisible) {
  for (const char* hidden : {"\u00AD", "\u061C", "\u200B", "\u200F", "\u2060", "\u2066", "\uFEFF", "\U000E0041"})
    EXPECT_EQ(printable(std::string("m") + hidden + "ass"), std::string("m") + replacement + "ass");
}

TEST(Printable, replaces_what_is_no_utf8) {
  for (const char* bad : {"\x80", "\xC0\xAF", "\xE0\x80\x80", "\xED\xA0\x80", "\xF4\x90\x80\x80", "\xF5", "\xCE"}) {
    const std::string text = printable(bad);
    EXPECT_EQ(text.substr(0, 3), replacement) << text;
    EXPECT_EQ(printable(text), text);
  }
}

TEST(Printable, of_random_bytes_is_printable_and_of_the_same_width_when_printed_again) {
  std::mt19937_64 random(18);
  std::uniform_int_distribution<int> byte(0, 255);
  for (int i = 0; i < 1000; ++i) {
    std::string bytes;
    for (int j = 0; j < 40; ++j) bytes += static_cast<char>(byte(random));
    const std::string text = printable(bytes);
    EXPECT_EQ(printable(text), text);
    EXPECT_LE(display_width(text), 80U);
    for (char c : text) EXPECT_FALSE(static_cast<unsigned char>(c) < 0x20 || c == 0x7F);
  }
}

}  // namespace display_text_test
}  // namespace poinsot::document
