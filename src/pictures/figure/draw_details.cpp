#include "pictures/figure/draw_details.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "pictures/drawing/label_text.h"

namespace poinsot::pictures {

void draw_detail(Panel& panel, const Detail& detail) {
  constexpr double radius = 74, gap = 36, spot = 2.4;
  Box own;
  for (const Detail::Line& line : detail.lines)
    for (const Point2& p : line.points) own.include(p);
  const double size = std::max(own.width(), own.height());
  if (own.empty() || !(size > 0)) return;
  const double factor = 2 * radius / size;
  const Box drawn = extent(panel.marks);
  const Point2 middle{drawn.right + gap + radius, drawn.center().y};
  const auto placed = [&](Point2 p) { return middle + factor * (p - own.center()); };
  for (const Detail::Line& line : detail.lines) {
    std::vector<Point2> points;
    for (const Point2& p : line.points) points.push_back(placed(p));
    if (!line.name.empty()) {
      std::vector<Anchor> anchors;
      for (const Point2 outward : {Point2{0, -1}, Point2{1, 0}, Point2{-1, 0}, Point2{0, 1}})
        anchors.push_back(
            {*std::ranges::max_element(points, {}, [&](Point2 p) { return dot(p, outward); }), outward, 5, 0});
      panel.labels.push_back({words_label(line.name, 12), std::move(anchors), 1});
    }
    panel.marks.emplace_back(Stroke{.points = std::move(points),
                                    .width = 1,
                                    .ink = line.ink,
                                    .dash = line.dash,
                                    .role = Role::curve,
                                    .closed = line.closed});
  }
  for (const Detail::Spot& one : detail.spots) {
    panel.area(circle(placed(one.at), spot), color_of(one.ink), Role::point);
    Label label = tex_label(one.symbol);
    label.ink = one.ink;
    panel.labels.push_back({std::move(label), {{placed(one.at), {-0.5, -0.8}, 4, 0}}, 2});
  }
  const Point2 below{middle.x, placed({0, own.bottom}).y};
  panel.labels.push_back({words_label(detail.words + ",", 12), {{below, {0, 1}, 22, 0}}, 3});
  panel.labels.push_back(
      {words_label(fmt::format("{} times as large", std::lround(factor)), 12), {{below, {0, 1}, 38, 0}}, 2.9});
}

}  // namespace poinsot::pictures
