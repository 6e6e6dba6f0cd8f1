// The examples that a test goes through, by folder.
#pragma once

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace poinsot::testing {

// The sanitizers see every example solved by the test `examples`. What looks at the answers through the same code, one
// example like another, goes there through every fourth, always the same.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr std::size_t examples_thinned = 4;
#else
inline constexpr std::size_t examples_thinned = 1;
#endif

// Of what all examples show so often at least, what those that are gone through show: half of their part, since a
// selection is not an even one.
constexpr int at_least(int count) {
  return examples_thinned == 1 ? count : count / static_cast<int>(2 * examples_thinned);
}

// In the order of their names, so that a smaller selection is the same everywhere.
inline std::vector<std::filesystem::path> example_files(const std::string& folder,
                                                        std::size_t every = examples_thinned) {
  std::vector<std::filesystem::path> all;
  for (const auto& entry :
       std::filesystem::directory_iterator(std::filesystem::path(POINSOT_SOURCE_DIR) / "examples" / folder))
    if (entry.path().extension() == ".yaml") all.push_back(entry.path());
  std::ranges::sort(all);
  std::vector<std::filesystem::path> some;
  for (std::size_t i = 0; i < all.size(); i += every) some.push_back(all[i]);
  return some;
}

}  // namespace poinsot::testing
