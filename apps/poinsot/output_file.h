// Files that a command writes whole.
#pragma once

#include <string>
#include <string_view>

#include "poinsot/document.h"

// Whether the output may be written over what is there, or a message why not: never over the problem file; over another
// file only with `force`.
[[nodiscard]] bool may_be_written(const std::string& problem_file, const std::string& output, bool force);

// False if the machine does not let it be written; errno says why.
[[nodiscard]] bool write_file(const std::string& path, std::string_view text);

// Writes a file, or to standard output if no path is given. False after a message if that cannot be done.
[[nodiscard]] bool write_output(const std::string& path, std::string_view text);

// Names the output on standard output once it is written, and gives the exit code: whether all is answered, unless the
// interrupt key was pressed meanwhile.
int told_of_output(const std::string& output, const poinsot::Document& document);
