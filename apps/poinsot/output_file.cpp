#include "output_file.h"

#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <memory>

std::string not_to_be_written(const std::string& problem_file, const std::string& output, bool force) {
  namespace fs = std::filesystem;
  std::error_code error;
  if (output.empty() || !fs::exists(output, error)) return "";
  if (fs::equivalent(problem_file, output, error))
    return fmt::format("cannot write {}: it is the problem file", output);
  // A device such as /dev/stdout loses nothing.
  if (force || !fs::is_regular_file(output, error)) return "";
  return fmt::format("{} is there already and is not overwritten: add --force, or name another file", output);
}

bool write_file(const std::string& path, std::string_view text) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "wb"), &std::fclose);
  return file && std::fwrite(text.data(), 1, text.size(), file.get()) == text.size() && std::fflush(file.get()) == 0;
}
