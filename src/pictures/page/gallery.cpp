// The index of a folder of pages.
#include <algorithm>
#include <nlohmann/json.hpp>
#include <regex>

#include "pictures/page/bundle.h"
#include "pictures/page/html.h"
#include "poinsot/pictures.h"

namespace poinsot {

std::vector<PageFile> shared_page_files() {
  if (pictures::page_script.empty()) throw NoPages("this poinsot was built without pages");
  return {{"page.js", pictures::page_script}, {"page.css", pictures::page_style}};
}

std::vector<std::string> kinds_of(std::string_view text, const Document& document) {
  const auto any = [&](const auto& holds) { return std::ranges::any_of(document.solutions, holds); };
  const auto any_answer = [&](const auto& holds) {
    return any([&](const Solution& solution) { return std::ranges::any_of(solution.answers, holds); });
  };
  static const std::regex steady_key("(^|\n) *steady *:", std::regex::optimize);
  const bool motion = any([](const Solution& solution) {
    return (solution.scene && solution.scene->motion) || solution.checks.contains("energy_drift") ||
           solution.checks.contains("motion_error");
  });
  const bool blow = any([](const Solution& solution) { return solution.checks.contains("impulse"); });
  const bool steady = std::regex_search(text.begin(), text.end(), steady_key);
  std::vector<std::string> kinds;
  const auto add = [&](bool holds, const char* kind) {
    if (holds) kinds.emplace_back(kind);
  };
  add(motion, "motion");
  add(blow, "blow");
  add(steady, "steady");
  add(!motion && !blow && !steady, "instant");
  add(any_answer([](const Answer& answer) { return answer.claim.has_value(); }), "claim");
  add(any_answer([](const Answer& answer) { return !answer.formula.empty(); }), "formula");
  add(any([](const Solution& solution) { return !solution.unknowns.empty(); }), "unknowns");
  add(document.solutions.size() > 1, "several solutions");
  add(!fully_answered(document), "not fully answered");
  return kinds;
}

std::string gallery_html(const std::string& title, const std::vector<GalleryEntry>& entries) {
  using Json = nlohmann::ordered_json;
  Json list = Json::array();
  std::string fallback = title + "\n\n";
  for (const GalleryEntry& one : entries) {
    list.push_back({{"page", one.page},
                    {"figure", one.figure},
                    {"title", one.title},
                    {"file", one.file},
                    {"kinds", one.kinds},
                    {"note", one.note}});
    fallback += one.file + "  " + one.title + "\n";
  }
  const Json data{{"title", title}, {"entries", list}};
  return pictures::page_html({.title = title,
                              .data_id = "poinsot-gallery",
                              .data = data.dump(-1, ' ', false, Json::error_handler_t::replace),
                              .fallback = fallback},
                             "./");
}

}  // namespace poinsot
