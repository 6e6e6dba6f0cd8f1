#include "output_file.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>

#include "exit_codes.h"
#include "streams.h"

bool may_be_written(const std::string& problem_file, const std::string& output, bool force) {
  namespace fs = std::filesystem;
  std::error_code error;
  if (output.empty() || !fs::exists(output, error)) return true;
  if (fs::equivalent(problem_file, output, error)) {
    write_message(fmt::format("poinsot: cannot write {}: it is the problem file", output));
    return false;
  }
  // A device such as /dev/stdout loses nothing.
  if (force || !fs::is_regular_file(output, error)) return true;
  write_message(
      fmt::format("poinsot: {} is there already and is not overwritten: add --force, or name another file", output));
  return false;
}

bool write_file(const std::string& path, std::string_view text) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "wb"), &std::fclose);
  return file && std::fwrite(text.data(), 1, text.size(), file.get()) == text.size() && std::fflush(file.get()) == 0;
}

bool write_output(const std::string& path, std::string_view text) {
  if (path.empty()) {
    static_cast<void>(write_answer(text));
    return true;
  }
  if (write_file(path, text)) return true;
  write_message(fmt::format("poinsot: cannot write {}: {}", path, std::strerror(errno)));
  return false;
}

int told_of_output(const std::string& output, const poinsot::Document& document) {
  if (!write_answer(output + "\n")) return exit_answered;
  if (interrupted()) {
    write_message("poinsot: interrupted; the output shows what was found until then");
    return exit_interrupted;
  }
  return fully_answered(document) ? exit_answered : exit_unanswered;
}
