// What can be written out of the tree of commands: completion for shells, and the manual page.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

// The shells for which there is a completion.
std::vector<std::string> known_shells();

// A script that teaches a shell to complete commands, options, files and words of the language. `shell` is one of
// known_shells().
std::string completion_script(const CLI::App& program, const std::string& shell);

// The manual page in the man macros of troff.
std::string manual_page(const CLI::App& program, const std::string& version);
