// poinsot report.
#include "report.h"

#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>

#include "exit_codes.h"
#include "output_file.h"
#include "poinsot/pictures.h"
#include "progress_line.h"
#include "streams.h"

namespace {

using poinsot::Document;
using poinsot::Problem;

// The document with its scenes, or what was found before the interrupt key was pressed.
Document illustrated(const Problem& problem, const ReportArguments& arguments) {
  const InterruptCatcher catcher;
  ProgressLine line;
  return problem.illustrate(arguments.sets, line.budget(), true);
}

// The page, or the bodies of the first solution, by the ending of the output; "" if there is nothing to show.
std::string rendered(const ReadProblem& read, const Document& document, bool page) {
  if (page) return to_html(read.problem, read.text, document);
  if (document.solutions.empty() || !document.solutions.front().scene) return "";
  return to_gltf(document, 0);
}

int one_file(const ReportArguments& arguments) {
  const std::string& file = arguments.paths.front();
  const auto refused = [](const std::string& reason) {
    write_message("poinsot: " + reason);
    return exit_wrong_input;
  };
  const std::filesystem::path ending = std::filesystem::path(arguments.output).extension();
  if (ending != ".html" && ending != ".glb")
    return refused(
        fmt::format("'{}' should end in .html for a page, or in .glb for the bodies as solids", arguments.output));
  if (!may_be_written(file, arguments.output, arguments.force)) return exit_wrong_input;
  const ReadProblem read = read_problem(file);
  const Document document = illustrated(read.problem, arguments);
  const std::string content = rendered(read, document, ending == ".html");
  if (content.empty()) {
    write_message(fmt::format("{}: no solution, and nothing to show", file));
    return interrupted() ? exit_interrupted : exit_unanswered;
  }
  return write_output(arguments.output, content) ? told_of_output(arguments.output, document) : exit_internal;
}

}  // namespace

ReadProblem read_problem(const std::string& file) {
  const auto all_of = [](std::istream& stream) {
    return std::string(std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>());
  };
  if (file == "-") {
    const std::string text = all_of(std::cin);
    return {Problem::from_text(text, file), text};
  }
  Problem problem = Problem::from_file(file);
  std::ifstream stream(file, std::ios::binary);
  return {std::move(problem), all_of(stream)};
}

int report(const ReportArguments& arguments) {
  std::error_code error;
  const bool folders = arguments.paths.size() > 1 || std::filesystem::is_directory(arguments.paths.front(), error);
  try {
    return folders ? gallery(arguments) : one_file(arguments);
  } catch (const poinsot::NoPages& reason) {
    write_message(fmt::format("poinsot: {}", reason.what()));
    return exit_wrong_input;
  }
}
