// Results do not depend on a clock: nothing reads one but what ends a computation on behalf of its caller, and a
// recording, which brings its rows to the disk now and then.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace poinsot {
namespace clocks_test {

namespace fs = std::filesystem;

bool reads_a_clock(const std::string& line) {
  // Searched by a regular expression, all sources would take seconds.
  if (line.find("time") == std::string::npos && line.find("clock") == std::string::npos &&
      line.find("rdtsc") == std::string::npos)
    return false;
  static const std::regex form(
      R"(steady_clock|system_clock|high_resolution_clock|utc_clock|file_clock|\bclock\s*\(|\bclock_gettime\b|)"
      R"(\bgettimeofday\b|\bstd::time\b|\btime\s*\(\s*(nullptr|NULL|0)\s*\)|rdtsc|\btimespec_get\b|<ctime>)");
  return std::regex_search(line, form);
}

TEST(Clocks, nothing_else_reads_one) {
  const fs::path root = POINSOT_SOURCE_DIR;
  const std::set<std::string> may{"include/poinsot/engine/work/budget.h", "src/document/recording.cpp"};
  std::set<std::string> do_so;
  std::size_t files = 0;
  for (const char* folder : {"include", "src"})
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(root / folder)) {
      if (!entry.is_regular_file()) continue;
      ++files;
      std::ifstream source(entry.path());
      const std::string name = fs::relative(entry.path(), root).generic_string();
      std::string line;
      for (int number = 1; std::getline(source, line); ++number) {
        if (!reads_a_clock(line)) continue;
        EXPECT_TRUE(may.contains(name)) << fmt::format("{}:{}: {}", name, number, line);
        do_so.insert(name);
      }
    }
  EXPECT_GT(files, 300U);
  EXPECT_EQ(do_so, may) << "who no longer reads one need not be let";
}

TEST(Clocks, one_is_noticed) {
  for (const char* line : {"const auto now = std::chrono::steady_clock::now();", "begun = std::clock();",
                           "std::time_t now = std::time(nullptr);", "#include <ctime>", "gettimeofday(&now, nullptr);"})
    EXPECT_TRUE(reads_a_clock(line)) << line;
  for (const char* line : {"Budget& by_clock(std::function<Clock::time_point()> clock);", "double time(double x);",
                           "value = motion.time(0.5);", "// against the clock"})
    EXPECT_FALSE(reads_a_clock(line)) << line;
}

}  // namespace clocks_test
}  // namespace poinsot
