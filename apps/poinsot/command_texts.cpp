#include "command_texts.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace {

std::vector<std::string> option_names(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    for (const std::string& name : option->get_snames()) names.push_back("-" + name);
  }
  return names;
}

std::vector<std::string> command_names(const CLI::App& program) {
  std::vector<std::string> names;
  for (const CLI::App* command : program.get_subcommands({})) names.push_back(command->get_name());
  return names;
}

// The description in quotes for zsh and fish, in which only these need a backslash.
std::string quoted(const std::string& text) {
  std::string result = "'";
  for (const char c : text) {
    if (c == '\'' || c == '\\') result += '\\';
    result += c;
  }
  return result + "'";
}

std::string bash_script(const CLI::App& program) {
  std::string cases;
  for (const CLI::App* command : program.get_subcommands({}))
    cases += fmt::format("    {}) options=\"{}\" ;;\n", command->get_name(), fmt::join(option_names(*command), " "));
  return fmt::format(
      "# Completion of poinsot for bash.\n"
      "_poinsot() {{\n"
      "  local current=${{COMP_WORDS[COMP_CWORD]}} options=\"\"\n"
      "  if ((COMP_CWORD == 1)); then\n"
      "    mapfile -t COMPREPLY < <(compgen -W \"{} {}\" -- \"$current\")\n"
      "    return\n"
      "  fi\n"
      "  case ${{COMP_WORDS[1]}} in\n{}"
      "  esac\n"
      "  if [[ $current == -* ]]; then\n"
      "    mapfile -t COMPREPLY < <(compgen -W \"$options\" -- \"$current\")\n"
      "  elif [[ ${{COMP_WORDS[1]}} == help ]]; then\n"
      "    mapfile -t COMPREPLY < <(compgen -W \"{} $(poinsot help --words)\" -- \"$current\")\n"
      "  elif [[ ${{COMP_WORDS[1]}} == completion ]]; then\n"
      "    mapfile -t COMPREPLY < <(compgen -W \"{}\" -- \"$current\")\n"
      "  else\n"
      "    mapfile -t COMPREPLY < <(compgen -f -- \"$current\")\n"
      "  fi\n"
      "}}\n"
      "complete -o filenames -F _poinsot poinsot\n",
      fmt::join(command_names(program), " "), fmt::join(option_names(program), " "), cases,
      fmt::join(command_names(program), " "), fmt::join(known_shells(), " "));
}

std::string zsh_script(const CLI::App& program) {
  std::string commands, cases;
  for (const CLI::App* command : program.get_subcommands({})) {
    commands += fmt::format("    {}\n", quoted(command->get_name() + ":" + command->get_description()));
    cases += fmt::format("    {}) options=({}) ;;\n", command->get_name(), fmt::join(option_names(*command), " "));
  }
  return fmt::format(
      "#compdef poinsot\n"
      "_poinsot() {{\n"
      "  local -a commands options\n"
      "  commands=(\n{}  )\n"
      "  if ((CURRENT == 2)); then\n"
      "    _describe command commands\n"
      "    return\n"
      "  fi\n"
      "  case $words[2] in\n{}"
      "  esac\n"
      "  if [[ $words[CURRENT] == -* ]]; then\n"
      "    compadd -- $options\n"
      "  elif [[ $words[2] == help ]]; then\n"
      "    compadd -- {} ${{(f)\"$(poinsot help --words)\"}}\n"
      "  elif [[ $words[2] == completion ]]; then\n"
      "    compadd -- {}\n"
      "  else\n"
      "    _files\n"
      "  fi\n"
      "}}\n"
      "_poinsot \"$@\"\n",
      commands, cases, fmt::join(command_names(program), " "), fmt::join(known_shells(), " "));
}

std::string fish_script(const CLI::App& program) {
  std::string text = "# Completion of poinsot for fish.\n";
  for (const CLI::App* command : program.get_subcommands({})) {
    text += fmt::format("complete -c poinsot -f -n __fish_use_subcommand -a {} -d {}\n", command->get_name(),
                        quoted(command->get_description()));
    for (const CLI::Option* option : command->get_options()) {
      std::string names;
      for (const std::string& name : option->get_lnames()) names += " -l " + name;
      for (const std::string& name : option->get_snames()) names += " -s " + name;
      if (names.empty()) continue;
      text += fmt::format("complete -c poinsot -n '__fish_seen_subcommand_from {}'{} -d {}\n", command->get_name(),
                          names, quoted(option->get_description()));
    }
  }
  text += "complete -c poinsot -f -n '__fish_seen_subcommand_from help' -a '(poinsot help --words)'\n";
  text += fmt::format("complete -c poinsot -f -n '__fish_seen_subcommand_from help' -a '{}'\n",
                      fmt::join(command_names(program), " "));
  text += fmt::format("complete -c poinsot -f -n '__fish_seen_subcommand_from completion' -a '{}'\n",
                      fmt::join(known_shells(), " "));
  return text;
}

// The text for troff: no line begins a request, and dashes can be searched for.
std::string troff(const std::string& text) {
  std::string result;
  for (const char c : text) {
    const bool at_begin = result.empty() || result.back() == '\n';
    if (at_begin && (c == '.' || c == '\'')) result += "\\&";
    if (c == '\\' || c == '-') result += '\\';
    result += c == '\\' ? 'e' : c;
  }
  return result;
}

std::string options_for_manual(const CLI::App& command) {
  std::string text;
  for (const CLI::Option* option : command.get_options()) {
    const std::string name = option->nonpositional() ? option->get_name(false, true) : option->get_name(true);
    const std::string type = option->nonpositional() && option->get_expected_max() > 0 ? option->get_type_name() : "";
    text += fmt::format(".TP\n.B {}\n{}\n", troff(type.empty() ? name : name + " " + type),
                        troff(option->get_description()));
  }
  return text;
}

}  // namespace

std::vector<std::string> known_shells() { return {"bash", "zsh", "fish"}; }

std::string completion_script(const CLI::App& program, const std::string& shell) {
  if (shell == "bash") return bash_script(program);
  return shell == "zsh" ? zsh_script(program) : fish_script(program);
}

std::string manual_page(const CLI::App& program, const std::string& version) {
  std::string text = fmt::format(
      ".TH POINSOT 1 \"\" \"poinsot {}\" \"User Commands\"\n"
      ".SH NAME\npoinsot \\- kinetics of rigid bodies in three dimensions\n"
      ".SH SYNOPSIS\n.B poinsot\nCOMMAND [ARGUMENTS]\n"
      ".SH DESCRIPTION\n{}\n",
      troff(version), troff(program.get_description()));
  text += ".SH OPTIONS\n" + options_for_manual(program);
  text += ".SH COMMANDS\n";
  for (const CLI::App* command : program.get_subcommands({}))
    text += fmt::format(".SS {}\n{}\n{}", troff(command->get_name()), troff(command->get_description()),
                        options_for_manual(*command));
  text += ".SH EXIT STATUS\n.nf\n" + troff(program.get_footer()) + "\n.fi\n";
  return text;
}
