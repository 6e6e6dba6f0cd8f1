#include "poinsot/pictures.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "pictures/figure/figure.h"
#include "pictures/svg/svg.h"
#include "poinsot/rendering.h"

namespace poinsot {
namespace {

std::string with_hint(std::string message, const std::string& word, const std::vector<std::string>& known) {
  if (const std::string hint = did_you_mean(word, known); !hint.empty()) message += fmt::format(" ({})", hint);
  return message;
}

// The heading of the worked solution's section to which a figure belongs. What acts on one of several bodies is a part
// of what acts on all, and belongs to none.
std::string section_of(pictures::FigureKind kind) {
  switch (kind) {
    case pictures::FigureKind::model:
      return "Model";
    case pictures::FigureKind::free_body:
      return "Component equations";
    case pictures::FigureKind::impulse:
      return "Impulse and momentum";
    case pictures::FigureKind::motion:
      return "Motion through time";
    case pictures::FigureKind::cones:
    case pictures::FigureKind::answers:
      return "Answers";
    case pictures::FigureKind::body:
      break;
  }
  return "";
}

}  // namespace

std::vector<FigureTitle> figures(const Document& document, std::size_t solution) {
  std::vector<FigureTitle> titles;
  const Solution& own = document.solutions.at(solution);
  if (!own.scene) return titles;
  for (const pictures::FigureName& name : pictures::figures_of(*own.scene))
    titles.push_back({name.name, name.title, section_of(name.kind)});
  return titles;
}

std::string to_svg(const Document& document, std::size_t solution, const FigureOptions& options) {
  const Solution& own = document.solutions.at(solution);
  if (!own.scene) throw FigureError("the solution has no scene to be drawn");
  const std::vector<pictures::FigureName> names = pictures::figures_of(*own.scene);
  const auto name = std::ranges::find(names, options.of, &pictures::FigureName::name);
  if (name == names.end()) {
    std::vector<std::string> known;
    for (const pictures::FigureName& other : names) known.push_back(other.name);
    throw FigureError(with_hint(
        fmt::format("there is no figure '{}': there are {}", options.of, fmt::join(known, ", ")), options.of, known));
  }
  pictures::Looks looks{.values = options.values};
  if (!options.view.empty()) {
    looks.view = pictures::view_of_words(options.view, own.scene->up);
    if (!looks.view)
      throw FigureError(with_hint(
          fmt::format("there is no view '{}': expected front, back, left, right, top, bottom, AZIMUTH,ELEVATION in "
                      "degrees or X,Y,Z towards the viewer",
                      options.view),
          options.view, {"front", "back", "left", "right", "top", "bottom"}));
  }
  return pictures::svg_of(pictures::figure(*own.scene, *name, document.title, looks));
}

}  // namespace poinsot
