// SVG as text: well-formed whatever the names are, and what is wrong with a call.
#include "pictures/svg/svg.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "pictures/figure/scenes.h"
#include "poinsot/pictures.h"

namespace poinsot {
namespace svg_test {

Document document_of(scene::Scene scene) {
  Document document;
  document.title = "A problem";
  document.solutions.emplace_back();
  document.solutions[0].scene = std::make_shared<const scene::Scene>(std::move(scene));
  return document;
}

// What is wrong with the text as XML of elements, attributes in double quotes and text; "" if nothing is.
std::string fault_in(const std::string& xml) {
  std::vector<std::string> open;
  for (std::size_t i = 0; i < xml.size();) {
    const char c = xml[i];
    if (static_cast<unsigned char>(c) < 0x20 && c != '\n') return "a control character";
    if (c == '&') {
      const std::size_t end = xml.find(';', i);
      const std::string name = xml.substr(i + 1, end - i - 1);
      if (name != "lt" && name != "gt" && name != "amp" && name != "quot") return "an unknown entity";
      i = end;
    }
    if (c != '<') {
      ++i;
      continue;
    }
    std::size_t end = i + 1;
    bool quoted = false;
    for (; end < xml.size() && (quoted || xml[end] != '>'); ++end) {
      if (xml[end] == '"') quoted = !quoted;
      if (xml[end] == '<') return "a '<' in a tag";
    }
    if (end >= xml.size()) return "a tag that does not end";
    const std::string tag = xml.substr(i + 1, end - i - 1);
    const std::string name = tag.substr(tag[0] == '/' ? 1 : 0, tag.find_first_of(" >", 1) - (tag[0] == '/' ? 1 : 0));
    if (tag[0] == '/') {
      if (open.empty() || open.back() != name) return "</" + name + ">";
      open.pop_back();
    } else if (tag.back() != '/') {
      open.push_back(name);
    }
    i = end + 1;
  }
  return open.empty() ? "" : "<" + open.back() + "> stays open";
}

TEST(Svg, is_well_formed_and_keeps_names_as_text) {
  const std::vector<std::string> hostile{"<script>alert(1)</script>",
                                         "a&b",
                                         "\"quoted\"",
                                         "line\nbreak\x01",
                                         "]]>",
                                         "\xff\xfe",
                                         std::string(5000, 'x'),
                                         "}{\\mathbf{",
                                         "_",
                                         "^",
                                         "\\"};
  for (const std::string& name : hostile) {
    scene::Scene scene = pictures_test::plate_scene();
    scene.axes = {name, name, name};
    for (scene::Body& body : scene.bodies) body.name = name;
    for (scene::Point& point : scene.points) point.name = name;
    for (scene::Arrow& arrow : scene.diagrams[0].arrows) arrow.symbol = arrow.text = arrow.unit = arrow.name = name;
    scene.dimensions = {{.name = name, .text = name + " = " + name, .from = {0, {-0.5, 0, 0}}, .to = {0, {0.5, 0, 0}}}};
    scene.drawn_letters = {{name, name, 1.5}};
    Document document = document_of(scene);
    document.title = name;
    const std::string svg = to_svg(document, 0, {.values = true});
    EXPECT_EQ(fault_in(svg), "") << name;
    EXPECT_EQ(svg.find("<script"), std::string::npos);
    EXPECT_LT(svg.size(), 200000U);
  }
  EXPECT_EQ(fault_in("<svg><path/></g>"), "</g>");
}

TEST(Svg, has_title_description_and_a_white_ground) {
  const std::string svg = to_svg(document_of(pictures_test::shaft_scene()), 0, {.of = "free-body"});
  EXPECT_NE(svg.find("<title>A problem</title>"), std::string::npos);
  // Several drawings may stand in one document, as in a notebook.
  EXPECT_EQ(svg.find(" id="), std::string::npos);
  EXPECT_NE(svg.find("Bodies: disk, shaft."), std::string::npos);
  EXPECT_NE(svg.find("fill=\"#ffffff\"/>"), std::string::npos);
  EXPECT_EQ(fault_in(svg), "");
}

std::string refusal(const FigureOptions& options) {
  try {
    static_cast<void>(to_svg(document_of(pictures_test::shaft_scene()), 0, options));
  } catch (const FigureError& error) {
    return error.what();
  }
  return "";
}

TEST(Svg, unknown_figures_and_views_are_refused) {
  EXPECT_EQ(refusal({.of = "free-boddy"}),
            "there is no figure 'free-boddy': there are model, free-body, disk, shaft (did you mean 'free-body'?)");
  EXPECT_EQ(refusal({.of = "impulse"}),
            "there is no figure 'impulse': there are model, free-body, disk, shaft (that of 'impulse' is drawn where "
            "something is struck)");
  EXPECT_NE(refusal({.view = "frnt"}).find("did you mean 'front'?"), std::string::npos);
  for (const char* view : {"1", "1,2,3,4", "0,0,0", "nan,1", "1,,2", "1,2,", "inf,1,1", "1 2"})
    EXPECT_NE(refusal({.view = view}), "") << view;
  for (const char* view : {"top", "30,20", "1,-2,0.5", " 1 , 2 , 3 ", "+1,2"})
    EXPECT_EQ(refusal({.view = view}), "") << view;
  Document without = document_of({});
  without.solutions[0].scene = nullptr;
  EXPECT_TRUE(figures(without, 0).empty());
  EXPECT_THROW(static_cast<void>(to_svg(without, 0)), FigureError);
  EXPECT_THROW(static_cast<void>(to_svg(without, 1)), std::out_of_range);
}

TEST(Svg, an_empty_scene_and_a_huge_mesh_are_drawn) {
  EXPECT_EQ(fault_in(to_svg(document_of({}), 0)), "");
  scene::Shape sphere{.kind = "mesh", .part = ""};
  constexpr std::uint32_t rows = 300, columns = 600;
  for (std::uint32_t i = 0; i <= rows; ++i)
    for (std::uint32_t k = 0; k < columns; ++k) {
      const double u = std::numbers::pi * i / rows, v = 2 * std::numbers::pi * k / columns;
      sphere.vertices.push_back({std::sin(u) * std::cos(v), std::sin(u) * std::sin(v), std::cos(u)});
    }
  for (std::uint32_t i = 0; i < rows; ++i)
    for (std::uint32_t k = 0; k < columns; ++k) {
      const std::uint32_t a = i * columns + k, b = i * columns + (k + 1) % columns;
      sphere.triangles.push_back({a, a + columns, b});
      sphere.triangles.push_back({b, a + columns, b + columns});
    }
  scene::Scene scene;
  scene.bodies = {{.name = "moon", .mass = 1, .shapes = {sphere}}};
  const std::string svg = to_svg(document_of(scene), 0);
  EXPECT_EQ(fault_in(svg), "");
  EXPECT_LT(svg.size(), 150000U);
}

}  // namespace svg_test
}  // namespace poinsot
