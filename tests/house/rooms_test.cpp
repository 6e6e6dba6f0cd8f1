// The rules of the house about includes: a room uses the rooms before it and never those after it; public headers
// include nothing but public headers and the standard library's; the program is a caller like any other.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace poinsot {
namespace rooms_test {

namespace fs = std::filesystem;

using Lines = std::vector<std::string>;

// The house from the ground up: each room may use those before it. A floor is the first part of a room's name.
const Lines rooms{"engine/work",
                  "engine/math/algebra",
                  "engine/math/elliptic",
                  "engine/math/formula",
                  "engine/math/trace",
                  "engine/mass",
                  "engine/model",
                  "engine/dynamics",
                  "engine/motion/integrator",
                  "engine/motion/closed_form",
                  "engine/motion/rotation",
                  "engine/motion/mechanism",
                  "engine/solve/linear",
                  "engine/solve/instant",
                  "engine/solve/stability",
                  "engine/solve/roots",
                  "problem/habits",
                  "problem/language",
                  "problem/keys",
                  "problem/entries",
                  "problem/plane",
                  "problem/machine",
                  "problem/quantities",
                  "problem/results",
                  "problem/instant",
                  "problem/witness",
                  "problem/response",
                  "problem/course",
                  "problem/unknowns",
                  "problem/near",
                  "problem/formulas",
                  "problem/limits",
                  "problem/claims",
                  "problem/answers",
                  "problem/cases",
                  "problem/equations",
                  "problem/explanation",
                  "problem/scene",
                  "document",
                  "pictures/drawing",
                  "pictures/solids",
                  "pictures/figure",
                  "pictures/svg",
                  "pictures/page",
                  "pictures/gltf"};
constexpr std::size_t most_files = 40;  // in one folder: more than a newcomer takes in

std::size_t place_of(const std::string& room) {
  return static_cast<std::size_t>(std::ranges::find(rooms, room) - rooms.begin());
}

bool is_room(const std::string& folder) { return place_of(folder) < rooms.size(); }

// The folder of a project header as an include names it ("poinsot/engine/mass/shapes.h", "problem/language/units.h"),
// or "" for a header of another library or one that stands on top of the house ("poinsot/problem.h").
std::string room_of(const std::string& include) {
  std::smatch match;
  static const std::regex form(
      "(?:poinsot/)?((?:engine|problem|document|pictures)(?:/[a-z_]+)*)/[a-z_0-9]+\\.(?:h|inc)");
  return std::regex_match(include, match, form) ? match[1].str() : "";
}

bool of_standard_library(const std::string& include) {
  static const std::regex form("[a-z_0-9]+|experimental/[a-z_]+");
  return std::regex_match(include, form);
}

// What breaks the rules in the source of a file, headed by the file's name and the line.
Lines breaches(const std::string& file, const std::string& room, bool is_public, const std::string& source) {
  static const std::regex directive(R"re(\s*#\s*include\s*([<"])([^>"]*)[>"].*)re");
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
    if (!used.empty() && !is_room(used)) {
      breach("is of no room of the house");
    } else if (!used.empty() && place_of(used) > place_of(room)) {
      breach(fmt::format("is of {}, which comes after {}", used, room));
    } else if (is_public && match[1] == "\"" && !include.starts_with("poinsot/")) {
      breach("is no public header, and stands in one");
    } else if (is_public && match[1] == "<" && !of_standard_library(include)) {
      breach("is of another library, in a public header");
    }
  }
  return found;
}

// Files by the folder, relative to `root`, in which they stand.
std::map<std::string, std::vector<fs::path>> files_by_folder(const fs::path& root) {
  std::map<std::string, std::vector<fs::path>> folders;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(root))
    if (entry.is_regular_file())
      folders[fs::relative(entry.path().parent_path(), root).generic_string()].push_back(entry.path());
  return folders;
}

// Breaches in all files below a folder that holds the rooms.
Lines breaches_below(const fs::path& root, bool is_public, std::size_t& files) {
  Lines found;
  for (const auto& [folder, paths] : files_by_folder(root)) {
    const bool on_top = is_public && folder == ".";  // the public headers of problems and documents
    if (!is_room(folder) && !on_top) {
      found.push_back(folder + " is no room of the house");
      continue;
    }
    if (paths.size() > most_files) found.push_back(fmt::format("{} holds {} files", folder, paths.size()));
    for (const fs::path& path : paths) {
      std::ostringstream source;
      source << std::ifstream(path).rdbuf();
      ++files;
      std::ranges::move(
          breaches(fs::relative(path, root).generic_string(), on_top ? rooms.back() : folder, is_public, source.str()),
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

// Headers of the project that a program's source includes, but those that stand beside it and those for callers of
// problems.
// With `engine`, public headers of the engine may be included too.
Lines not_for_callers(const std::string& source, const std::set<std::string>& beside, bool engine = false) {
  static const std::set<std::string> for_callers{"poinsot/document.h",  "poinsot/pictures.h", "poinsot/problem.h",
                                                 "poinsot/rendering.h", "poinsot/scene.h",    "poinsot/cases.h"};
  static const std::regex quoted(R"re(#\s*include\s*"([^"]*)")re");
  Lines found;
  for (std::sregex_iterator it(source.begin(), source.end(), quoted), none; it != none; ++it)
    if (const std::string include = (*it)[1]; !beside.contains(include) && !for_callers.contains(include) &&
                                              !(engine && include.starts_with("poinsot/engine/")))
      found.push_back(include);
  return found;
}

// What the sources of a folder include beside each other and the public headers.
void expect_caller(const fs::path& folder, const std::set<std::string>& written_by_the_build, bool engine = false) {
  std::set<std::string> beside = written_by_the_build;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) beside.insert(entry.path().filename());
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    std::ostringstream source;
    source << std::ifstream(entry.path()).rdbuf();
    EXPECT_EQ(not_for_callers(source.str(), beside, engine), Lines{}) << entry.path();
  }
  EXPECT_GT(beside.size(), 5U);
}

TEST(House, the_program_uses_the_public_headers_for_problems_and_nothing_else) {
  EXPECT_EQ(not_for_callers("#include <map>\n#include \"a.h\"\n#include \"poinsot/problem.h\"\n", {"a.h"}), Lines{});
  EXPECT_EQ(not_for_callers("#include \"problem/language/tree.h\"\n", {}), Lines{"problem/language/tree.h"});
  EXPECT_EQ(not_for_callers("#include \"poinsot/engine/mass/mesh.h\"\n", {}), Lines{"poinsot/engine/mass/mesh.h"});
  expect_caller(fs::path(POINSOT_SOURCE_DIR) / "apps/poinsot", {"flint_functions.inc"});
}

TEST(House, the_python_package_uses_public_headers_and_nothing_else) {
  EXPECT_EQ(not_for_callers("#include \"engine/mass/shape_check.h\"\n", {}, true), Lines{"engine/mass/shape_check.h"});
  expect_caller(fs::path(POINSOT_SOURCE_DIR) / "python/src", {}, true);
}

TEST(House, callers_of_problems_have_few_headers) {
  std::set<std::string> on_top;
  for (const fs::directory_entry& entry : fs::directory_iterator(fs::path(POINSOT_SOURCE_DIR) / "include/poinsot"))
    if (entry.is_regular_file()) on_top.insert(entry.path().filename());
  EXPECT_EQ(on_top,
            (std::set<std::string>{"cases.h", "document.h", "pictures.h", "problem.h", "rendering.h", "scene.h"}));
}

TEST(House, tests_stand_in_the_rooms_that_they_test) {
  const std::set<std::string> others{".",
                                     "apps",
                                     "docs",
                                     "document/golden",
                                     "faults",
                                     "faults/statements",
                                     "fuzz",
                                     "house",
                                     "hunt",
                                     "install",
                                     "install/engine_client",
                                     "install/problem_client",
                                     "python",
                                     "threads",
                                     "web"};
  for (const auto& [folder, paths] : files_by_folder(fs::path(POINSOT_SOURCE_DIR) / "tests")) {
    EXPECT_TRUE(is_room(folder) || others.contains(folder)) << folder;
    EXPECT_LE(paths.size(), most_files) << folder;
  }
}

TEST(House, a_later_room_is_noticed) {
  EXPECT_EQ(breaches("mass/a.cpp", "engine/mass", false, "// text\n#include \"poinsot/engine/model/model.h\"\n"),
            Lines{"mass/a.cpp:2: poinsot/engine/model/model.h is of engine/model, which comes after engine/mass"});
  EXPECT_EQ(breaches("solve/a.cpp", "engine/solve/linear", false, " # include <problem/entries/reader.h> // x"),
            Lines{"solve/a.cpp:1: problem/entries/reader.h is of problem/entries, which comes after "
                  "engine/solve/linear"});
  EXPECT_EQ(breaches("a.cpp", "engine/math/elliptic", false, "#include \"engine/math/trace/residue.h\"\n"),
            Lines{"a.cpp:1: engine/math/trace/residue.h is of engine/math/trace, which comes after "
                  "engine/math/elliptic"});
  EXPECT_EQ(breaches("mass/a.cpp", "engine/model", false,
                     "#include \"poinsot/engine/mass/shapes.h\"\n#include \"engine/model/b.h\"\n"),
            Lines{});
}

TEST(House, an_unknown_room_is_noticed) {
  EXPECT_EQ(breaches("a.cpp", "document", false, "#include \"problem/attic/a.h\"\n"),
            Lines{"a.cpp:1: problem/attic/a.h is of no room of the house"});
  EXPECT_EQ(breaches("a.cpp", "document", false, "#include \"engine/math/a.h\"\n").size(), 1U);
}

TEST(House, a_private_header_in_a_public_one_is_noticed) {
  EXPECT_EQ(breaches("mass/a.h", "engine/mass", true, "#include \"engine/mass/shape_check.h\"\n"),
            Lines{"mass/a.h:1: engine/mass/shape_check.h is no public header, and stands in one"});
  EXPECT_EQ(breaches("mass/a.h", "engine/mass", true, "#include \"b.h\"\n").size(), 1U);
  EXPECT_EQ(breaches("mass/a.cpp", "engine/mass", false, "#include \"engine/mass/shape_check.h\"\n"), Lines{});
}

TEST(House, another_library_in_a_public_header_is_noticed) {
  for (const char* include : {"Eigen/Dense", "fmt/format.h", "boost/math/constants/constants.hpp", "immintrin.h"}) {
    const std::string source = fmt::format("#include <{}>\n", include);
    EXPECT_EQ(breaches("a.h", "engine/model", true, source),
              Lines{fmt::format("a.h:1: {} is of another library, in a public header", include)});
    EXPECT_EQ(breaches("a.cpp", "engine/model", false, source), Lines{});
  }
  EXPECT_EQ(
      breaches("a.h", "engine/model", true, "#include <cmath>\n#include <experimental/simd>\n#include <version>\n"),
      Lines{});
}

}  // namespace rooms_test
}  // namespace poinsot
