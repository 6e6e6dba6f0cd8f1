// The fenced blocks of a page of the manual.
#pragma once

#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace poinsot {

struct FencedBlock {
  std::string kind;  // the first word after the fence: "yaml", "obj", "text"
  std::string name;  // the second: the name of the file that the block is
  int line = 0;      // of the fence
  std::string text;
};

inline std::string text_of_page(const std::string& page) {
  const std::filesystem::path path = std::filesystem::path(POINSOT_SOURCE_DIR) / page;
  std::ifstream stream(path);
  if (!stream) throw std::runtime_error("cannot read " + path.string());
  return {std::istreambuf_iterator<char>(stream), {}};
}

inline std::vector<FencedBlock> fenced_blocks(const std::string& page) {
  std::vector<FencedBlock> blocks;
  std::istringstream lines(text_of_page(page));
  std::string line;
  bool inside = false;
  for (int number = 1; std::getline(lines, line); ++number) {
    if (!line.starts_with("```")) {
      if (inside) blocks.back().text += line + "\n";
      continue;
    }
    inside = !inside;
    if (!inside) continue;
    FencedBlock block;
    block.line = number;
    std::istringstream(line.substr(3)) >> block.kind >> block.name;
    blocks.push_back(block);
  }
  if (inside) throw std::runtime_error(page + ": the last block is not closed");
  return blocks;
}

}  // namespace poinsot
