#include "pictures/svg/different_figures.h"

#include <algorithm>
#include <string_view>

namespace poinsot::pictures {
namespace {

// What is drawn, without the title, by which alone some drawings differ.
std::string_view drawn(std::string_view svg) {
  const std::size_t end = svg.find("</desc>");
  return end == std::string_view::npos ? svg : svg.substr(end);
}

}  // namespace

std::vector<DrawnFigure> different_figures(const Document& document, std::size_t solution) {
  std::vector<DrawnFigure> made;
  for (FigureTitle& figure : figures(document, solution)) {
    // What acts on one of several bodies stands in the figure of all.
    if (figure.section.empty()) continue;
    std::string svg = to_svg(document, solution, {.of = figure.name, .situation = figure.situation});
    if (std::ranges::any_of(made, [&](const DrawnFigure& one) { return drawn(one.svg) == drawn(svg); })) continue;
    made.push_back({std::move(figure), std::move(svg)});
  }
  return made;
}

}  // namespace poinsot::pictures
