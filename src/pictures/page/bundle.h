// What web/build.mjs makes of the folder web: the script and the style of all pages.
#pragma once

#include <string_view>

namespace poinsot::pictures {

extern const std::string_view page_script, page_style;  // empty if the program was built without them
extern const std::string_view page_script_hash;         // as a content security policy wants it: "sha256-..."

}  // namespace poinsot::pictures
