// poinsot solve --explain -o: worked solutions with figures beside them.
#include <fmt/format.h>

#include <filesystem>

#include "commands.h"
#include "exit_codes.h"
#include "output_file.h"
#include "poinsot/pictures.h"
#include "progress_line.h"
#include "report.h"
#include "streams.h"

int write_worked_solutions(const SolveArguments& arguments) {
  namespace fs = std::filesystem;
  const fs::path output = arguments.output;
  const auto refused = [](const std::string& reason) {
    write_message("poinsot: " + reason);
    return exit_wrong_input;
  };
  std::error_code error;
  if (arguments.files.size() != 1 || fs::is_directory(arguments.files.front(), error))
    return refused("-o takes the worked solution of one file; pages of a folder are made by poinsot report");
  if (output.extension() != ".md")
    return refused(fmt::format("'{}' should end in .md: a worked solution is Markdown", output.string()));
  const std::string& file = arguments.files.front();
  const poinsot::Problem problem = poinsot::Problem::from_file(file);
  poinsot::Document document;
  {
    const InterruptCatcher catcher;
    ProgressLine line;
    document = problem.illustrate(arguments.sets, line.budget(), true);
  }
  const poinsot::IllustratedMarkdown solution = to_illustrated_markdown(document, output.stem().string());
  // Nothing is written before it is known that all of it may be.
  std::vector<std::pair<std::string, std::string_view>> files{{output.string(), solution.text}};
  for (const auto& figure : solution.figures)
    files.emplace_back((output.parent_path() / figure.name).string(), figure.svg);
  for (const auto& [name, content] : files)
    if (!may_be_written(file, name, arguments.force)) return exit_wrong_input;
  for (const auto& [name, content] : files)
    if (!write_output(name, content)) return exit_internal;
  return told_of_output(arguments.output, document);
}
