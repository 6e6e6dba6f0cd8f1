// From problem files to answers: what the command line and other front ends call.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "document/document.h"

namespace poinsot::document {

struct RunOptions {
  // Names with the texts of their values, unit included ("m", "3 kg"); a later one for the same name counts. A letter
  // or a datum gets this value; an unknown becomes a datum.
  std::vector<std::pair<std::string, std::string>> sets;
  bool explain = false;  // with worked solutions
};

// Reads and solves one problem file; "-" is standard input. Answers that cannot be given stand in the document with
// their state and reason. Throws problem::StatementError where the file, or a value set, is wrong.
Document run_file(const std::string& path, const RunOptions& options);

struct CheckResult {
  std::string file;
  std::vector<std::string> failures;  // what falls short of the file's `expect` block; empty: all agrees
};

// Solves each file, or every `*.yaml` below a folder in the order of their names, and compares with the file's own
// `expect` block. A file that is wrong, or without `expect`, is a failure. Throws problem::StatementError for a path
// that does not exist.
std::vector<CheckResult> check_paths(const std::vector<std::string>& paths);

// The JSON Schema (draft 2020-12) of the problem file, ending in a newline.
std::string problem_schema();

}  // namespace poinsot::document
