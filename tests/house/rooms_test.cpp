// The rules of the house about includes: a room uses the rooms before it and never those after it; public headers
// include no private ones; those of the engine include nothing but the project's and the standard library's.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace poinsot {
namespace {

namespace fs = std::filesystem;

using Lines = std::vector<std::string>;

const Lines rooms{"math", "mass", "model", "dynamics", "motion", "solve", "statement", "answer"};
constexpr std::size_t rooms_of_engine = 6;

std::size_t place_of(const std::string& room) {
  return static_cast<std::size_t>(std::ranges::find(rooms, room) - rooms.begin());
}

// The room of a project header as an include names it ("poinsot/mass/shapes.h", "mass/shape_check.h"), or "".
std::string room_of(const std::string& include) {
  std::smatch match;
  static const std::regex form("(?:poinsot/)?([a-z]+)/.*");
  return std::regex_match(include, match, form) && place_of(match[1]) < rooms.size() ? match[1].str() : "";
}

bool of_standard_library(const std::string& include) {
  static const std::regex form("[a-z_0-9]+|experimental/[a-z_]+");
  return std::regex_match(include, form);
}

// What breaks the rules in the source of a file, headed by the file's name and the line.
Lines breaches(const std::string& file, const std::string& room, bool is_public, const std::string& source) {
  static const std::regex directive(R"re(\s*#\s*include\s*([<"])([^>"]*)[>"].*)re");
  const bool engine = place_of(room) < rooms_of_engine;
  Lines found;
  std::istringstream lines(source);
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    std::smatch match;
    if (!std::regex_match(line, match, directive)) continue;
    const std::string include = match[2];
    const std::string used = room_of(include);
    const auto breach = [&](const std::string& rule) {
      found.push_back(fmt::format("{}:{}: {} {}", file, number, include, rule));
    };
    if (!used.empty() && place_of(used) > place_of(room)) {
      breach(fmt::format("is of {}, which comes after {}", used, room));
    } else if (is_public && match[1] == "\"" && !include.starts_with("poinsot/")) {
      breach("is no public header, and stands in one");
    } else if (is_public && engine && match[1] == "<" && !of_standard_library(include)) {
      breach("is of another library, in a public header of the engine");
    }
  }
  return found;
}

// Breaches in all files below a folder that holds one folder for each room.
Lines breaches_below(const fs::path& folder, bool is_public, std::size_t& files) {
  Lines found;
  for (const fs::directory_entry& room : fs::directory_iterator(folder)) {
    if (!room.is_directory()) continue;
    if (place_of(room.path().filename()) == rooms.size()) {
      found.push_back(room.path().string() + " is no room of the house");
      continue;
    }
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(room)) {
      if (!entry.is_regular_file()) continue;
      std::ostringstream source;
      source << std::ifstream(entry.path()).rdbuf();
      ++files;
      std::ranges::move(breaches(fs::relative(entry.path(), folder), room.path().filename(), is_public, source.str()),
                        std::back_inserter(found));
    }
  }
  return found;
}

TEST(House, public_headers_keep_the_rules) {
  std::size_t files = 0;
  EXPECT_EQ(breaches_below(fs::path(POINSOT_SOURCE_DIR) / "include/poinsot", true, files), Lines{});
  EXPECT_GT(files, 20U);
}

TEST(House, sources_keep_the_rules) {
  std::size_t files = 0;
  EXPECT_EQ(breaches_below(fs::path(POINSOT_SOURCE_DIR) / "src", false, files), Lines{});
  EXPECT_GT(files, 20U);
}

TEST(House, a_later_room_is_noticed) {
  EXPECT_EQ(breaches("mass/a.cpp", "mass", false, "// text\n#include \"poinsot/model/model.h\"\n"),
            Lines{"mass/a.cpp:2: poinsot/model/model.h is of model, which comes after mass"});
  EXPECT_EQ(breaches("solve/a.cpp", "solve", false, " # include <statement/reader.h> // x"),
            Lines{"solve/a.cpp:1: statement/reader.h is of statement, which comes after solve"});
  EXPECT_EQ(breaches("model/a.cpp", "model", false, "#include \"poinsot/mass/shapes.h\"\n#include \"model/b.h\"\n"),
            Lines{});
}

TEST(House, a_private_header_in_a_public_one_is_noticed) {
  EXPECT_EQ(breaches("mass/a.h", "mass", true, "#include \"mass/shape_check.h\"\n"),
            Lines{"mass/a.h:1: mass/shape_check.h is no public header, and stands in one"});
  EXPECT_EQ(breaches("mass/a.h", "mass", true, "#include \"b.h\"\n").size(), 1U);
  EXPECT_EQ(breaches("mass/a.cpp", "mass", false, "#include \"mass/shape_check.h\"\n"), Lines{});
}

TEST(House, another_library_in_a_public_header_of_the_engine_is_noticed) {
  for (const char* include : {"Eigen/Dense", "fmt/format.h", "boost/math/constants/constants.hpp", "immintrin.h"}) {
    const std::string source = fmt::format("#include <{}>\n", include);
    EXPECT_EQ(breaches("math/a.h", "math", true, source),
              Lines{fmt::format("math/a.h:1: {} is of another library, in a public header of the engine", include)});
    EXPECT_EQ(breaches("math/a.cpp", "math", false, source), Lines{});
    EXPECT_EQ(breaches("answer/a.h", "answer", true, source), Lines{});
  }
  EXPECT_EQ(breaches("math/a.h", "math", true, "#include <cmath>\n#include <experimental/simd>\n#include <version>\n"),
            Lines{});
}

}  // namespace
}  // namespace poinsot
