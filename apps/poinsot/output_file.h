// Files that a command writes whole.
#pragma once

#include <string>
#include <string_view>

// Why the output may not be written over what is there; "" if it may. It is never the problem file; another file only
// with `force`.
std::string not_to_be_written(const std::string& problem_file, const std::string& output, bool force);

// False if the machine does not let it be written; errno says why.
[[nodiscard]] bool write_file(const std::string& path, std::string_view text);
