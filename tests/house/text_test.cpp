// Values do not turn back to text: expressions are parsed where a file is read, and what is decided is decided by
// indices, kinds and trees, never by reading a message or a written expression. Numbers are read and written without
// the locale of the C library.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <regex>
#include <set>
#include <string>

namespace poinsot {
namespace {

namespace fs = std::filesystem;

using Test = std::function<bool(const std::string& line)>;

bool holds_one_of(const std::string& line, std::initializer_list<const char*> words) {
  // Searched by regular expressions, all sources would take seconds.
  for (const char* word : words)
    if (line.find(word) != std::string::npos) return true;
  return false;
}

bool is_comment(const std::string& line) {
  const std::size_t first = line.find_first_not_of(' ');
  return first != std::string::npos && line.compare(first, 2, "//") == 0;
}

bool parses(const std::string& line) { return holds_one_of(line, {"parse_expression(", "parse_scalar("}); }

bool cuts_text(const std::string& line) {
  if (!holds_one_of(line, {"find", "_with(", "substr(", "regex"})) return false;
  static const std::regex form(R"((\bfind|\brfind|\bstarts_with|\bends_with)\(\s*("|'|std::string\()|)"
                               R"(\bsubstr\(|\bregex_(search|match|replace)\b|\bsregex_iterator\b)");
  return std::regex_search(line, form);
}

bool follows_a_locale(const std::string& line) {
  if (!holds_one_of(line, {"printf", "scanf", "strto", "ato", "sto", "stream", "{:L", "locale"})) return false;
  static const std::regex form(R"(\bv?s?n?f?printf\(|\bv?s?f?scanf\(|\bstrto(d|f|ld)\(|\batof\(|\bsto(d|f|ld)\(|)"
                               R"(\bo?stringstream\b|\{:[^}]*L\}|\bstd::locale\b|\bsetlocale\()");
  return std::regex_search(line, form);
}

// The files below a folder of the sources in which a line passes the test. left_out: folders that do not count.
std::set<std::string> files_with(const Test& test, const fs::path& folder, const std::set<std::string>& left_out,
                                 const std::set<std::string>& may) {
  const fs::path root = POINSOT_SOURCE_DIR;
  std::set<std::string> found;
  std::size_t files = 0;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(root / folder)) {
    const std::string name = fs::relative(entry.path(), root).generic_string();
    if (!entry.is_regular_file() || left_out.contains(fs::path(name).parent_path().generic_string())) continue;
    ++files;
    std::ifstream source(entry.path());
    std::string line;
    for (int number = 1; std::getline(source, line); ++number) {
      if (is_comment(line) || !test(line)) continue;
      EXPECT_TRUE(may.contains(name)) << fmt::format("{}:{}: {}", name, number, line);
      found.insert(name);
    }
  }
  EXPECT_GT(files, 5U) << folder;
  return found;
}

// The rooms that read a file.
const std::set<std::string> readers{"src/problem/habits", "src/problem/language", "src/problem/keys",
                                    "src/problem/entries"};

TEST(Text, expressions_are_parsed_where_a_file_is_read) {
  // A value from outside the file is read when it is set, and what is asked of a motion when it is asked. The words of
  // a condition are read as their reader does, to see whether they say what is meant.
  const std::set<std::string> may{"src/problem/answers/asked_motion.cpp", "src/problem/formulas/formula_conditions.cpp",
                                  "src/problem/machine/data.cpp"};
  EXPECT_EQ(files_with(parses, "src/problem", readers, may), may) << "who no longer parses need not be let";
}

TEST(Text, nothing_is_decided_by_reading_what_was_written) {
  const std::set<std::string> may{
      "src/problem/explanation/explanation_symbols.cpp",  // a dot above a letter and not above its index
      "src/problem/explanation/explanation_tex.cpp",      // how TeX is put together
      "src/problem/instant/open_words.cpp",               // an article before a noun that has none
      "src/problem/machine/data.cpp",                     // a blank between a number and its unit, as in 3kg
      "src/problem/machine/masses.cpp",                   // what to write in place of "4 lb"
  };
  EXPECT_EQ(files_with(cuts_text, "src/problem", readers, may), may) << "who no longer reads text need not be let";
}

TEST(Text, numbers_follow_no_locale) {
  for (const char* folder : {"src", "include", "apps"})
    EXPECT_TRUE(files_with(follows_a_locale, folder, {}, {}).empty());
}

TEST(Text, what_would_be_wrong_is_noticed) {
  EXPECT_TRUE(parses("  return data.number(parse_expression(name, file, mark));"));
  for (const char* line :
       {"if (text.find(\"energy(\") != std::string::npos)", "ask.text.find(\"@ \" + name)", "words.starts_with(\"'\")",
        "one.ends_with(\">= 0\")", "name.substr(prefix.size())", "closure.where.find(std::string(\"'\") + name)"})
    EXPECT_TRUE(cuts_text(line)) << line;
  for (const char* line :
       {"const auto found = known.find(name);", "facts.contains(\"time\")", "std::ranges::find(a, b)"})
    EXPECT_FALSE(cuts_text(line)) << line;
  for (const char* line : {"std::snprintf(text, sizeof text, \"%.4g\", x);", "printf(\"%g\", x);",
                           "const double x = std::strtod(text, nullptr);", "number = std::stod(text);",
                           "std::ostringstream words;", "fmt::format(\"{:L}\", x)"})
    EXPECT_TRUE(follows_a_locale(line)) << line;
  for (const char* line : {"std::from_chars(begin, end, x)", "fmt::format(\"{:.4g}\", x)", "std::ifstream file(name);"})
    EXPECT_FALSE(follows_a_locale(line)) << line;
}

}  // namespace
}  // namespace poinsot
