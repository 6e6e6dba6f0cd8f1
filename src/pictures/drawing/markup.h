// Text as it stands in SVG and HTML.
#pragma once

#include <string>
#include <string_view>

namespace poinsot::pictures {

// With the five signs that mean something in markup written as entities; right in texts and in quoted attributes.
std::string escaped_markup(std::string_view text);

}  // namespace poinsot::pictures
