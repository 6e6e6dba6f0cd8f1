#include "problem/entries/named_files.h"

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <system_error>

namespace poinsot::problem {
namespace {

namespace fs = std::filesystem;

fs::path path_within(const fs::path& folder, const std::string& name) {
  const fs::path root = fs::weakly_canonical(folder.empty() ? fs::path(".") : folder);
  fs::path path = fs::weakly_canonical(root / name);
  const bool inside = std::mismatch(root.begin(), root.end(), path.begin(), path.end()).first == root.end();
  if (!inside || fs::path(name).is_absolute())
    throw FileRefused("it does not lie in the folder of the problem file", "copy it there and name it without a path");
  return path;
}

std::string bytes_of(const fs::path& path) {
  // Devices and folders have no size to hold against the limit.
  std::error_code trouble;
  const fs::file_status status = fs::status(path, trouble);
  if (!fs::exists(status)) throw FileRefused("the file does not exist");
  if (!fs::is_regular_file(status)) throw FileRefused("not a file");
  const std::uintmax_t size = fs::file_size(path, trouble);
  if (trouble) throw FileRefused("cannot be read: " + trouble.message());
  if (size > most_bytes_of_named_file)
    throw FileRefused(std::to_string(size) + " bytes are more than the limit of " +
                      std::to_string(most_bytes_of_named_file));
  std::ifstream stream(path, std::ios::binary);
  std::string bytes(static_cast<std::size_t>(size), '\0');
  if (!stream || !stream.read(bytes.data(), static_cast<std::streamsize>(size)))
    throw FileRefused(std::string("cannot be read: ") + std::strerror(errno));
  return bytes;
}

}  // namespace

ReadNamedFile files_beside(const std::string& problem_file) {
  const fs::path folder = problem_file == "-" ? fs::path(".") : fs::path(problem_file).parent_path();
  return [folder](const std::string& name) { return bytes_of(path_within(folder, name)); };
}

}  // namespace poinsot::problem
