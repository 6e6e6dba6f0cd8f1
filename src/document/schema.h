// The form of the answer document.
#pragma once

#include <string>

namespace poinsot::document {

// The JSON Schema (draft 2020-12) of what to_json() writes, ending in a newline.
std::string answer_schema();

}  // namespace poinsot::document
