#include "pictures/drawing/markup.h"

#include <gtest/gtest.h>

#include <random>
#include <string>
#include <utility>
#include <vector>

namespace poinsot::pictures {
namespace {

TEST(Markup, ShowsAnyTextAsItIs) {
  std::mt19937 generator(1);
  const std::string letters = "ab<>&\"' \n=/;#";
  std::uniform_int_distribution<std::size_t> letter(0, letters.size() - 1);
  int escaped = 0;
  for (int i = 0; i < 300; ++i) {
    std::string text;
    for (int k = 0; k < 12; ++k) text += letters[letter(generator)];
    std::string markup = escaped_markup(text);
    EXPECT_EQ(markup.find_first_of("<>\"'"), std::string::npos);
    escaped += markup != text ? 1 : 0;
    for (const auto& [entity, sign] : std::vector<std::pair<std::string, std::string>>{
             {"&lt;", "<"}, {"&gt;", ">"}, {"&quot;", "\""}, {"&#39;", "'"}, {"&amp;", "&"}})
      for (std::size_t at = markup.find(entity); at != std::string::npos; at = markup.find(entity, at + 1))
        markup.replace(at, entity.size(), sign);
    EXPECT_EQ(markup, text);
  }
  EXPECT_GT(escaped, 200);
}

}  // namespace
}  // namespace poinsot::pictures
