// The files that a problem file names beside its own text.
#pragma once

#include <cstddef>
#include <functional>
#include <stdexcept>
#include <string>
#include <utility>

namespace poinsot::problem {

// A named file cannot be had: what() says why, as the end of a sentence that begins with its name.
class FileRefused : public std::runtime_error {
 public:
  explicit FileRefused(const std::string& message, std::string hint = "")
      : std::runtime_error(message), hint_(std::move(hint)) {}
  const std::string& hint() const { return hint_; }

 private:
  std::string hint_;
};

// The bytes of the file of this name. Throws FileRefused.
using ReadNamedFile = std::function<std::string(const std::string& name)>;

// A problem has to be small; the files that it names may be large, but not without bound.
constexpr std::size_t most_bytes_of_named_file = std::size_t{64} << 20;

// Reads files from the disk: those in the folder of the problem file, or below it, and no others, wherever links lead.
// Standard input, "-", has the present folder.
ReadNamedFile files_beside(const std::string& problem_file);

}  // namespace poinsot::problem
