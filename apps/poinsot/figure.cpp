// poinsot figure.
#include <fmt/format.h>

#include <filesystem>

#include "commands.h"
#include "exit_codes.h"
#include "output_file.h"
#include "poinsot/pictures.h"
#include "poinsot/problem.h"
#include "progress_line.h"
#include "streams.h"

namespace {

poinsot::Document illustrated_until_interrupted(const poinsot::Problem& problem, const poinsot::Settings& sets) {
  const InterruptCatcher catcher;
  ProgressLine line;
  return problem.illustrate(sets, line.budget());
}

}  // namespace

int figure(const FigureArguments& arguments) {
  const std::filesystem::path output = arguments.output;
  if (output.has_extension() && output.extension() != ".svg") {
    const std::string drawing = std::filesystem::path(output).replace_extension(".svg").string();
    write_message(
        fmt::format("poinsot: '{}' should end in .svg: a figure is a line drawing in that form (others are made of it: "
                    "rsvg-convert {} -o {})",
                    output.string(), drawing, output.string()));
    return exit_wrong_input;
  }
  if (!may_be_written(arguments.file, arguments.output, arguments.force)) return exit_wrong_input;
  const poinsot::Document document =
      illustrated_until_interrupted(poinsot::Problem::from_file(arguments.file), arguments.sets);
  if (interrupted()) {
    write_message("poinsot: interrupted");
    return exit_interrupted;
  }
  if (document.solutions.empty()) {
    write_message(fmt::format("{}: no solution, and so no figure", arguments.file));
    for (const std::string& warning : document.warnings)
      write_message(fmt::format("{}: warning: {}", arguments.file, warning));
    return exit_unanswered;
  }
  if (arguments.solution < 1 || arguments.solution > document.solutions.size()) {
    write_message(fmt::format("poinsot: --solution {}: {} has {} solution{}", arguments.solution, arguments.file,
                              document.solutions.size(), document.solutions.size() > 1 ? "s" : ""));
    return exit_wrong_input;
  }
  const std::size_t solution = arguments.solution - 1;
  try {
    if (arguments.list) {
      std::string text;
      for (const poinsot::FigureTitle& title : figures(document, solution))
        text += fmt::format("{:<12} {}{}\n", title.name, title.title,
                            title.situation.empty() ? "" : fmt::format(" ({})", title.situation));
      static_cast<void>(write_answer(text));
      return exit_answered;
    }
    const std::string svg = to_svg(document, solution, arguments.options);
    return write_output(arguments.output, svg) ? exit_answered : exit_internal;
  } catch (const poinsot::FigureError& error) {
    write_message(fmt::format("{}: {}", arguments.file, error.what()));
    return exit_wrong_input;
  }
}
