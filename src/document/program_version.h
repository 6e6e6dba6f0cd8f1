// The version of the program, as answer documents and recordings name it.
#pragma once

#include <string_view>

namespace poinsot::document {

std::string_view program_version();

}  // namespace poinsot::document
