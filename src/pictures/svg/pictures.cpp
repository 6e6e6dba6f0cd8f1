#include "poinsot/pictures.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <string>

#include "pictures/figure/figure.h"
#include "pictures/svg/svg.h"
#include "poinsot/rendering.h"
#include "problem/entries/viewing_direction.h"

namespace poinsot {
namespace {

std::string with_hint(std::string message, const std::string& word, const std::vector<std::string>& known) {
  if (const std::string hint = did_you_mean(word, known); !hint.empty()) message += fmt::format(" ({})", hint);
  return message;
}

// The heading of the worked solution's section to which a figure belongs. What acts on one of several bodies is a part
// of what acts on all, and belongs to none.
std::string section_of(pictures::FigureKind kind, const std::string& situation) {
  const std::string suffix = situation.empty() ? "" : ", *" + situation + "*";
  switch (kind) {
    case pictures::FigureKind::model:
      return "Model" + suffix;
    case pictures::FigureKind::free_body:
      return "Component equations" + suffix;
    case pictures::FigureKind::impulse:
      return "Impulse and momentum" + suffix;
    case pictures::FigureKind::motion:
      return "Motion through time" + suffix;
    case pictures::FigureKind::cones:
    case pictures::FigureKind::answers:
      return "Answers";
    case pictures::FigureKind::body:
      break;
  }
  return "";
}

std::vector<const scene::Scene*> scenes_of(const Solution& solution) {
  std::vector<const scene::Scene*> scenes;
  if (solution.scene) scenes.push_back(solution.scene.get());
  for (const auto& other : solution.other_scenes) scenes.push_back(other.get());
  return scenes;
}

const scene::Scene& scene_in(const Solution& solution, const std::string& situation) {
  const std::vector<const scene::Scene*> scenes = scenes_of(solution);
  if (scenes.empty()) throw FigureError("the solution has no scene to be drawn");
  if (situation.empty()) return *scenes.front();
  std::vector<std::string> known;
  for (const scene::Scene* scene : scenes) {
    if (scene->situation == situation) return *scene;
    if (!scene->situation.empty()) known.push_back(scene->situation);
  }
  if (known.empty()) throw FigureError(fmt::format("there is no situation '{}': the file states only one", situation));
  throw FigureError(with_hint(
      fmt::format("no situation '{}' is drawn: there are {}", situation, fmt::join(known, ", ")), situation, known));
}

}  // namespace

std::vector<FigureTitle> figures(const Document& document, std::size_t solution) {
  std::vector<FigureTitle> titles;
  for (const scene::Scene* scene : scenes_of(document.solutions.at(solution)))
    for (const pictures::FigureName& name : pictures::figures_of(*scene))
      titles.push_back({name.name, name.title, section_of(name.kind, scene->situation), scene->situation});
  return titles;
}

std::string to_svg(const Document& document, std::size_t solution, const FigureOptions& options) {
  const scene::Scene& scene = scene_in(document.solutions.at(solution), options.situation);
  const std::vector<pictures::FigureName> names = pictures::figures_of(scene);
  const auto name = std::ranges::find(names, options.of, &pictures::FigureName::name);
  if (name == names.end()) {
    std::vector<std::string> known;
    for (const pictures::FigureName& other : names) known.push_back(other.name);
    const std::string message =
        fmt::format("there is no figure '{}': there are {}", options.of, fmt::join(known, ", "));
    // One that other problems have.
    static const std::map<std::string, std::string, std::less<>> others{
        {"free-body", "where forces or accelerations are asked for"},
        {"impulse", "where something is struck"},
        {"cones", "where a body turns freely"},
        {"motion", "where something is asked about a motion through time"},
        {"answers", "where vectors are asked for"}};
    for (const auto& [other, where] : others)
      if (std::ranges::find(known, other) == known.end() &&
          (options.of == other || !did_you_mean(options.of, {other}).empty()))
        throw FigureError(fmt::format("{} (that of '{}' is drawn {})", message, other, where));
    throw FigureError(with_hint(message, options.of, known));
  }
  pictures::Looks looks{.values = options.values};
  if (!options.view.empty()) {
    looks.view = pictures::view_of_words(options.view, scene.up);
    if (!looks.view)
      throw FigureError(
          with_hint(fmt::format("there is no view '{}': expected {}", options.view, problem::viewing_words),
                    options.view, {"front", "back", "left", "right", "top", "bottom"}));
  }
  std::string title = document.title;
  if (!scene.situation.empty()) title += (title.empty() ? "" : ", ") + scene.situation;
  return pictures::svg_of(pictures::figure(scene, *name, title, looks));
}

}  // namespace poinsot
