// The command line: the tree of commands, their options, and what is wrong with a call.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include "command_texts.h"
#include "commands.h"
#include "exit_codes.h"
#include "poinsot/problem.h"
#include "poinsot/rendering.h"
#include "streams.h"

namespace {

// The words of the command line that no option or command takes, in their order.
std::vector<std::string> stray_words(const CLI::App& app) {
  std::vector<std::string> words = app.remaining(true);
  std::erase(words, "--");
  return words;
}

// Words that people bring from other programs for what a command does here, and what to write.
std::string command_for(const std::string& word) {
  static const std::map<std::string, std::string, std::less<>> calls{{"explain", "solve --explain FILE"},
                                                                     {"solution", "solve --explain FILE"},
                                                                     {"steps", "solve --explain FILE"},
                                                                     {"run", "solve FILE"},
                                                                     {"answer", "solve FILE"},
                                                                     {"compute", "solve FILE"},
                                                                     {"json", "solve --json FILE"},
                                                                     {"test", "check FILE"},
                                                                     {"validate", "check FILE"},
                                                                     {"verify", "check FILE"},
                                                                     {"lint", "check FILE"},
                                                                     {"draw", "figure FILE -o OUT.svg"},
                                                                     {"plot", "figure FILE -o OUT.svg"},
                                                                     {"picture", "figure FILE -o OUT.svg"},
                                                                     {"svg", "figure FILE -o OUT.svg"},
                                                                     {"view", "report FILE -o OUT.html"},
                                                                     {"show", "report FILE -o OUT.html"},
                                                                     {"html", "report FILE -o OUT.html"},
                                                                     {"page", "report FILE -o OUT.html"},
                                                                     {"animate", "report FILE -o OUT.html"},
                                                                     {"gallery", "report FOLDER -o OUT"},
                                                                     {"gltf", "report FILE -o OUT.glb"},
                                                                     {"export", "record FILE -o OUT.csv"},
                                                                     {"csv", "record FILE -o OUT.csv"},
                                                                     {"simulate", "record FILE -o OUT.csv"},
                                                                     {"integrate", "record FILE -o OUT.csv"},
                                                                     {"derive", "equations FILE"},
                                                                     {"codegen", "equations FILE --form c"},
                                                                     {"man", "manual"},
                                                                     {"version", "--version"}};
  const auto call = calls.find(word);
  return call == calls.end() ? "" : "write poinsot " + call->second;
}

// What is wrong with a word that nothing takes, for the command that was to take it.
std::string stray_message(const std::string& word, const CLI::App& program) {
  const std::vector<CLI::App*> chosen = program.get_subcommands();
  const CLI::App& command = chosen.empty() ? program : *chosen.front();
  std::vector<std::string> candidates;
  if (word.size() > 1 && word[0] == '-') {
    const std::string option = word.substr(0, word.find('='));
    for (const CLI::Option* known : command.get_options()) {
      for (const std::string& name : known->get_lnames()) candidates.push_back("--" + name);
    }
    const std::string message = chosen.empty() ? fmt::format("unknown option '{}'", option)
                                               : fmt::format("unknown option '{}' of {}", option, command.get_name());
    std::string hint = poinsot::did_you_mean(option, candidates);
    if (option == "-v" || option == "-V") hint = "did you mean '--version'?";
    // An option that the command has, but before it, is the program's, which has few.
    const auto takes = [&](const CLI::App* other) { return other->get_option_no_throw(option) != nullptr; };
    if (chosen.empty() ? std::ranges::any_of(program.get_subcommands({}), takes) : takes(chosen.front()))
      return fmt::format("option '{}' stands before the command (write it behind: poinsot {} FILE {} ...)", option,
                         chosen.empty() ? "COMMAND" : command.get_name(), option);
    return hint.empty() ? message : fmt::format("{} ({})", message, hint);
  }
  if (!chosen.empty()) return fmt::format("{} takes no '{}'", command.get_name(), word);
  for (const CLI::App* known : program.get_subcommands({})) candidates.push_back(known->get_name());
  std::string hint = word.ends_with(".yaml") || word.ends_with(".yml") ? fmt::format("write poinsot solve {}", word)
                                                                       : command_for(word);
  if (hint.empty()) hint = poinsot::did_you_mean(word, candidates);
  const std::string message =
      fmt::format("unknown command '{}': expected one of {}", word, fmt::join(candidates, ", "));
  return hint.empty() ? message : fmt::format("{} ({})", message, hint);
}

int usage_error(const std::string& message, const CLI::App& program) {
  const std::vector<CLI::App*> chosen = program.get_subcommands();
  const std::string command = chosen.empty() ? "poinsot" : "poinsot " + chosen.front()->get_name();
  write_message(fmt::format("poinsot: {}\nTry '{} --help'.", message, command));
  return exit_wrong_input;
}

// NAME and VALUE of `NAME=VALUE`; CLI::ValidationError if it has another form.
std::pair<std::string, std::string> split_setting(const std::string& text) {
  const std::size_t sign = text.find('=');
  if (sign == std::string::npos || sign == 0 || sign + 1 == text.size()) {
    throw CLI::ValidationError("--set", fmt::format("'{}' should be NAME=VALUE, for example --set 'm=3 kg'", text));
  }
  const auto trimmed = [](const std::string& part) {
    const std::size_t begin = part.find_first_not_of(' '), end = part.find_last_not_of(' ');
    return begin == std::string::npos ? std::string() : part.substr(begin, end - begin + 1);
  };
  return {trimmed(text.substr(0, sign)), trimmed(text.substr(sign + 1))};
}

void add_sets(CLI::App& command, std::vector<std::string>& settings) {
  command.add_option("--set", settings, "Give a letter, a datum or an unknown this value, with its unit (repeatable)")
      ->type_name("NAME=VALUE")
      ->allow_extra_args(false);
}

int print(const std::string& text) {
  static_cast<void>(write_answer(fitted_to_terminal(text)));
  return exit_answered;
}

struct HelpArguments {
  std::vector<std::string> words;
  bool list = false;
};

// What each word means: in the language, and as a command.
int help(const HelpArguments& arguments, const CLI::App& program) {
  if (arguments.list) return print(fmt::format("{}\n", fmt::join(poinsot::language_words(), "\n")));
  if (arguments.words.empty())
    return print(program.get_formatter()->make_help(&program, "poinsot", CLI::AppFormatMode::Normal) +
                 "\n`poinsot help WORD` says what a word of the problem language means: a key, a function, a unit.\n");
  std::string text;
  int code = exit_answered;
  for (const std::string& word : arguments.words) {
    std::string found;
    for (const CLI::App* command : program.get_subcommands({}))
      if (command->get_name() == word) found = command->help("poinsot");
    // Of a command only that is told beside it which is a word of the language as well.
    const std::vector<std::string> known = poinsot::language_words();
    if (found.empty() || std::ranges::find(known, word) != known.end()) {
      if (!found.empty()) found += "\n";
      found += poinsot::language_help(word);
    }
    if (found.empty()) {
      const std::string hint = poinsot::did_you_mean(word, poinsot::language_words());
      write_message(fmt::format("poinsot: the language has no word '{}'{}", word,
                                hint.empty() ? "" : fmt::format(" ({})", hint)));
      code = exit_wrong_input;
      continue;
    }
    text += (text.empty() ? "" : "\n") + found;
  }
  static_cast<void>(write_answer(fitted_to_terminal(text)));
  return code;
}

int run(int argument_count, const char* const* arguments) {
  CLI::App program("Kinetics of rigid bodies in three dimensions: states a problem, finds the answers.", "poinsot");
  program.set_version_flag("--version", "poinsot " POINSOT_VERSION);
  program.require_subcommand(1);
  program.footer(
      "Exit codes:\n"
      "  0    all answered\n"
      "  1    without answer, or an answer that failed its check\n"
      "  2    wrong input\n"
      "  3    internal failure\n"
      "  130  interrupted");

  SolveArguments solve_arguments;
  std::vector<std::string> settings;
  CLI::App* solve_command = program.add_subcommand("solve", "Solve problem files and print the answers");
  solve_command
      ->add_option("FILE", solve_arguments.files, "Problem files, or folders of *.yaml files; - for standard input")
      ->required();
  solve_command->add_flag("--json", solve_arguments.json, "Print one answer document per file, one per line");
  solve_command->add_flag("--explain", solve_arguments.explain,
                          "Print worked solutions, as Markdown with formulas in TeX; with --json as a field of it");
  solve_command
      ->add_flag("--scene", solve_arguments.scene, "With --json: what a picture of each solution shows, as numbers")
      ->needs("--json");
  solve_command
      ->add_option("-o,--output", solve_arguments.output,
                   "With --explain: the worked solution of one file with its figures beside it, NAME.md")
      ->needs("--explain")
      ->excludes("--json")
      ->type_name("OUTPUT");
  solve_command->add_flag("--force", solve_arguments.force, "With -o: replace files that are there")->needs("--output");
  add_sets(*solve_command, settings);

  CheckArguments check_arguments;
  CLI::App* check_command = program.add_subcommand("check", "Compare problem files with the answers they expect");
  check_command->add_option("PATH", check_arguments.paths, "Problem files, or folders of *.yaml files")->required();
  check_command->add_flag("--list", check_arguments.list, "Name the files that pass as well");
  check_command->add_flag("--json", check_arguments.json, "Print one JSON document about all files");

  RecordArguments record_arguments;
  std::vector<std::string> record_settings;
  CLI::App* record_command = program.add_subcommand(
      "record", "Record the motion as the file says under record:, to a table; a run that stopped goes on");
  record_command->add_option("FILE", record_arguments.file, "Problem file; - for standard input")->required();
  record_command
      ->add_option("-o,--output", record_arguments.output,
                   "The table: NAME.csv or NAME.h5; NAME.csv.journal beside it keeps what has been recorded")
      ->required()
      ->type_name("OUTPUT");
  record_command->add_flag("--force", record_arguments.force,
                           "Replace the table if it is there and no recording of this program wrote it");
  add_sets(*record_command, record_settings);

  EquationsArguments equations_arguments;
  std::vector<std::string> equations_settings;
  CLI::App* equations_command =
      program.add_subcommand("equations", "Write the equations of motion as formulas or as code");
  equations_command->add_option("FILE", equations_arguments.file, "Problem file; - for standard input")->required();
  equations_command->add_option("--form", equations_arguments.form, "text, tex, c, c++, python or sympy")
      ->capture_default_str();
  equations_command
      ->add_option("--of", equations_arguments.of,
                   "mass-matrix, right-hand-side, constraint-matrix, reduced, position-rate, forward-dynamics or "
                   "inverse-dynamics; several with commas")
      ->delimiter(',')
      ->allow_extra_args(false);
  equations_command->add_option("--name", equations_arguments.function, "The function's name in code")
      ->capture_default_str();
  equations_command->add_option("--situation", equations_arguments.situation, "One of the situations of the file");
  equations_command
      ->add_option("--letter", equations_arguments.letters, "Keep this datum a letter, whatever its value (repeatable)")
      ->type_name("NAME")
      ->allow_extra_args(false);
  equations_command->add_option("-o,--output", equations_arguments.output, "A file in place of standard output");
  equations_command->add_flag("--force", equations_arguments.force, "Replace the output file if it is there");
  add_sets(*equations_command, equations_settings);

  ReportArguments report_arguments;
  std::vector<std::string> report_settings;
  CLI::App* report_command = program.add_subcommand(
      "report",
      "Write a page for a browser: statement, view in space, answers, worked solution; or a gallery of pages");
  report_command->add_option("PATH", report_arguments.paths, "Problem file, - for standard input; or folders of *.yaml")
      ->required();
  report_command
      ->add_option("-o,--output", report_arguments.output,
                   "NAME.html, or NAME.glb for solids alone; for folders another folder, which gets index.html")
      ->required()
      ->type_name("OUTPUT");
  report_command->add_flag("--force", report_arguments.force, "Replace the output if it is there");
  add_sets(*report_command, report_settings);
  FigureArguments figure_arguments;
  std::vector<std::string> figure_settings;
  CLI::App* figure_command = program.add_subcommand("figure", "Draw the problem, or what acts in it, as SVG");
  figure_command->add_option("FILE", figure_arguments.file, "Problem file; - for standard input")->required();
  figure_command
      ->add_option("--of", figure_arguments.options.of,
                   "model, free-body, impulse, cones, motion, answers, or the name of a body on which something acts")
      ->capture_default_str()
      ->type_name("FIGURE");
  figure_command
      ->add_option(
          "--view", figure_arguments.options.view,
          "front, back, left, right, top, bottom; AZIMUTH,ELEVATION in degrees from the front, to the right and "
          "up; X,Y,Z towards the viewer. Without it that of the file, or the one in which least is lost")
      ->type_name("VIEW");
  figure_command->add_option("--situation", figure_arguments.options.situation, "Which of several situations")
      ->type_name("NAME");
  figure_command->add_flag("--values", figure_arguments.options.values, "Write values beside symbols");
  figure_command->add_flag("--list", figure_arguments.list, "Name the figures that there are");
  figure_command->add_option("--solution", figure_arguments.solution, "Which of several solutions")
      ->capture_default_str();
  figure_command->add_option("-o,--output", figure_arguments.output, "A file in place of standard output");
  figure_command->add_flag("--force", figure_arguments.force, "Replace the output file if it is there");
  add_sets(*figure_command, figure_settings);

  bool of_answer = false;
  CLI::App* schema_command = program.add_subcommand("schema", "Print the JSON Schema of the problem file");
  schema_command->add_flag("--answer", of_answer, "Print that of the answer document");

  HelpArguments help_arguments;
  CLI::App* help_command =
      program.add_subcommand("help", "Say what a word of the problem language, or a command, means");
  help_command->add_option("WORD", help_arguments.words, "Keys, functions, units or commands");
  help_command->add_flag("--words", help_arguments.list, "List the words that the language knows");

  std::string shell;
  CLI::App* completion_command = program.add_subcommand(
      "completion", "Print a script that completes calls of poinsot in a shell, to be read by its start file");
  completion_command->add_option("SHELL", shell, "bash, zsh or fish")->required()->check(CLI::IsMember(known_shells()));
  CLI::App* manual_command = program.add_subcommand("manual", "Print the manual page, in the form that man reads");

  if (argument_count <= 1) {
    write_message(program.help());
    return exit_wrong_input;
  }
  try {
    program.parse(argument_count, arguments);
    for (const std::string& setting : settings) solve_arguments.sets.push_back(split_setting(setting));
    for (const std::string& setting : record_settings) record_arguments.sets.push_back(split_setting(setting));
    for (const std::string& setting : report_settings) report_arguments.sets.push_back(split_setting(setting));
    for (const std::string& setting : figure_settings) figure_arguments.sets.push_back(split_setting(setting));
    for (const std::string& setting : equations_settings) equations_arguments.sets.push_back(split_setting(setting));
  } catch (const CLI::CallForHelp&) {
    const std::vector<CLI::App*> chosen = program.get_subcommands();
    static_cast<void>(
        write_answer(fitted_to_terminal(chosen.empty() ? program.help() : chosen.front()->help("poinsot"))));
    return exit_answered;
  } catch (const CLI::CallForVersion& version) {
    static_cast<void>(write_answer(fmt::format("{}\n", version.what())));
    return exit_answered;
  } catch (const CLI::ParseError& error) {
    const std::vector<std::string> stray = stray_words(program);
    // A flag with a value, as in --json=all.
    if (const std::string what = error.what(); stray.empty() && what.starts_with("Could not convert: --"))
      return usage_error(fmt::format("{} takes no value", what.substr(19, what.find(' ', 19) - 19)), program);
    return usage_error(stray.empty() ? error.what() : stray_message(stray.front(), program), program);
  }

  if (solve_command->parsed()) return solve(solve_arguments);
  if (check_command->parsed()) return check(check_arguments);
  if (record_command->parsed()) return record(record_arguments);
  if (figure_command->parsed()) return figure(figure_arguments);
  if (equations_command->parsed()) return equations(equations_arguments);
  if (help_command->parsed()) return help(help_arguments, program);
  if (completion_command->parsed()) return print(completion_script(program, shell));
  if (manual_command->parsed()) return print(manual_page(program, POINSOT_VERSION));
  if (report_command->parsed()) return report(report_arguments);
  return schema(of_answer);
}

}  // namespace

int main(int argument_count, char** arguments) {
  prepare_streams();
  try {
    return run(argument_count, arguments);
  } catch (const poinsot::StatementError& error) {
    write_message(error.what());
    return exit_wrong_input;
  } catch (const OutputError& error) {
    write_message(fmt::format("poinsot: {}", error.what()));
    return exit_internal;
  } catch (const std::exception& error) {
    write_message(fmt::format("poinsot: internal failure: {}", error.what()));
    return exit_internal;
  }
}
