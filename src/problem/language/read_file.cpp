// Reads the bytes of a file up to a limit, whatever kind of file the path leads to.
#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>
#include <system_error>
#include <vector>

#include "problem/language/tree.h"

namespace poinsot::problem {
namespace {

constexpr Mark head_of_file{1, 1};

std::string read_stream(std::FILE* stream, const std::string& name) {
  std::string bytes;
  std::array<char, 16384> piece;
  // Reading may go one piece beyond the limit: this tells a file of just the largest size from a larger one.
  for (std::size_t count = 1; count > 0 && bytes.size() <= TreeLimits::bytes;) {
    count = std::fread(piece.data(), 1, piece.size(), stream);
    bytes.append(piece.data(), count);
  }
  if (std::ferror(stream)) {
    throw StatementError(name, head_of_file, std::string("the file cannot be read: ") + std::strerror(errno));
  }
  if (bytes.size() > TreeLimits::bytes) {
    throw StatementError(name, head_of_file, "the file is larger than " + std::to_string(TreeLimits::bytes) + " bytes",
                         "a problem file is a page or two of text");
  }
  return bytes;
}

// What was meant by a path at which there is nothing: a file of nearly that name.
std::string where_else(const std::filesystem::path& path) {
  if (path.string().find("://") != std::string::npos) return "a file is read from a disk: save it first";
  std::error_code fault;
  const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : std::filesystem::path(".");
  std::vector<std::string> names;
  constexpr std::size_t most = 10'000;  // a folder with more is searched in part
  std::filesystem::directory_iterator entry(folder, fault);
  if (fault) return "there is no folder '" + folder.string() + "' either: check the path";
  for (; entry != std::filesystem::directory_iterator() && names.size() < most; entry.increment(fault)) {
    if (fault) break;
    const std::filesystem::path& name = entry->path();
    if (name.extension() != ".yaml" && name.extension() != ".yml") continue;
    names.push_back(name.filename().string());
    // The ending left out.
    if (path.filename() == name.stem())
      return "did you mean '" + (path.parent_path() / name.filename()).string() + "'?";
  }
  std::ranges::sort(names);
  const std::string near = nearest(path.filename().string(), names);
  return near.empty() ? "check the path" : "did you mean '" + (path.parent_path() / near).string() + "'?";
}

}  // namespace

std::string read_file(const std::string& path) {
  if (path == "-") return read_stream(stdin, "-");
  std::error_code fault;
  const std::filesystem::file_status status = std::filesystem::status(path, fault);
  if (std::filesystem::is_directory(status)) {
    throw StatementError(path, head_of_file, "this is a folder, not a problem file", "name the files in it");
  }
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> stream(std::fopen(path.c_str(), "rb"), &std::fclose);
  if (!stream) {
    const std::string reason = std::strerror(errno);
    if (status.type() == std::filesystem::file_type::not_found) {
      throw StatementError(path, head_of_file, "there is no such file", where_else(path));
    }
    throw StatementError(path, head_of_file, "the file cannot be opened: " + reason);
  }
  return read_stream(stream.get(), path);
}

}  // namespace poinsot::problem
