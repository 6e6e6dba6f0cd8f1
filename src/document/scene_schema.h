// The definitions of the answer document's schema that concern scenes.
#pragma once

#include <string>

namespace poinsot::document {

// Members of "$defs", with a comma after the last.
std::string scene_definitions();

}  // namespace poinsot::document
