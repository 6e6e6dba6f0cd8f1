// The page of one answer document. What it looks like is the affair of the script (web/src); here it gets its data.
#include <algorithm>
#include <nlohmann/json.hpp>
#include <string_view>
#include <vector>

#include "pictures/page/html.h"
#include "pictures/solids/solid.h"
#include "pictures/svg/different_figures.h"
#include "poinsot/pictures.h"
#include "poinsot/rendering.h"

namespace poinsot {
namespace pictures {
namespace {

using Json = nlohmann::ordered_json;

Json situation_json(const StatedSituation& situation) {
  Json data = Json::array(), letters = Json::array(), unknowns = Json::array();
  for (const StatedDatum& one : situation.data) data.push_back({{"name", one.name}, {"text", one.text}});
  for (const Letter& one : situation.letters) letters.push_back({{"name", one.name}, {"unit", one.unit}});
  for (const StatedUnknown& one : situation.unknowns) unknowns.push_back({{"name", one.name}, {"unit", one.unit}});
  return {{"name", situation.name}, {"data", data}, {"letters", letters}, {"unknowns", unknowns}};
}

Json questions_json(const std::vector<StatedQuestion>& questions) {
  Json list = Json::array();
  for (const StatedQuestion& one : questions) list.push_back({{"name", one.name}, {"text", one.text}});
  return list;
}

Json situations_json(const Problem& problem) {
  Json list = Json::array();
  for (const StatedSituation& situation : problem.situations()) list.push_back(situation_json(situation));
  return list;
}

// The line drawings of each solution, the figure of the statement first, and none twice.
Json figures_json(const Document& document) {
  Json solutions = Json::array();
  for (std::size_t i = 0; i < document.solutions.size(); ++i) {
    Json drawings = Json::array();
    for (const DrawnFigure& figure : different_figures(document, i))
      drawings.push_back({{"title", figure.title.title},
                          {"section", figure.title.section},
                          {"situation", figure.title.situation},
                          {"svg", figure.svg}});
    solutions.push_back(drawings);
  }
  return solutions;
}

// What joins the shapes of each body with what holds it: pairs of points on the body's axes.
Json arms_json(const scene::Scene& scene) {
  Json bodies = Json::array();
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    Json arms = Json::array();
    for (const auto& [from, to] : arms_of(scene, static_cast<int>(i)))
      arms.push_back({{from.x, from.y, from.z}, {to.x, to.y, to.z}});
    bodies.push_back(std::move(arms));
  }
  return bodies;
}

// The same by solution and scene, that which is shown first before those of other situations.
Json arms_json(const Document& document) {
  Json solutions = Json::array();
  for (const Solution& solution : document.solutions) {
    Json scenes = Json::array();
    if (solution.scene) scenes.push_back(arms_json(*solution.scene));
    for (const auto& other : solution.other_scenes) scenes.push_back(arms_json(*other));
    solutions.push_back(std::move(scenes));
  }
  return solutions;
}

std::string dumped(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

}  // namespace
}  // namespace pictures

std::string to_html(const Problem& problem, std::string_view text, const Document& document,
                    const PageOptions& options) {
  using namespace pictures;
  const Json beside{{"problem", {{"name", problem.name()}, {"text", text}}},
                    {"situations", situations_json(problem)},
                    {"questions", questions_json(problem.questions())},
                    {"claims", questions_json(problem.claims())},
                    {"figures", figures_json(document)},
                    {"arms", arms_json(document)},
                    {"gallery", options.gallery}};
  // The document is text already, and may be long.
  std::string data = dumped(beside);
  data.replace(0, 1, "{\"document\":" + to_json(document) + ",");
  return page_html({.title = document.title.empty() ? document.file : document.title,
                    .data_id = "poinsot-page",
                    .data = std::move(data),
                    .fallback = to_terminal(document)},
                   options.shared);
}

}  // namespace poinsot
