#include "pictures/figure/motion_figure.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>
#include <utility>
#include <variant>

#include "pictures/figure/arrows.h"
#include "pictures/figure/fitting.h"
#include "pictures/figure/layout.h"
#include "pictures/figure/view_choice.h"

namespace poinsot::pictures {
namespace {

constexpr std::size_t most_poses = 6, poses_in_rows = 4, poses_in_row = 2;

std::vector<std::size_t> spread_over(std::size_t all, std::size_t most) {
  std::vector<std::size_t> shown;
  const std::size_t count = std::min(most, all);
  for (std::size_t i = 0; i < count; ++i) shown.push_back(count == 1 ? 0 : i * (all - 1) / (count - 1));
  return shown;
}

// Whether the bodies, each together with what it holds, are small beside the way that they go.
bool is_small(const Panel& panel) {
  constexpr double readable = 110;  // units of the paper: of a body with some names at its points
  Box box;
  for (const Solid& solid : panel.solids)
    for (const Vector& vertex : solid.vertices) box.include(panel.projection(vertex));
  return !box.empty() && std::max(box.width(), box.height()) < readable;
}

// How poses lie on the paper.
struct Spread {
  double size = 0, way = 0, path = 0, whole = 0;  // of the bodies, of their middles, of traced points, of all

  // Whether bodies stay where they are, so that their poses would lie on each other and no path orders them.
  bool piled() const { return way < 0.3 * size && path < 0.05 * size; }
  // Whether the bodies are lost beside their way.
  bool lost() const { return size > 0 && size < 0.1 * whole; }
};

Spread spread_of(const scene::Scene& scene, const std::vector<int>& bodies, const std::vector<std::size_t>& shown,
                 const View& view) {
  const Projection unscaled(view, 1);
  Spread spread;
  Box whole, middles, path;
  for (const std::size_t i : shown) {
    Box box;
    for (const Solid& solid : solids_of(scene, bodies, scene.motion->poses[i]))
      for (const Vector& vertex : solid.vertices) box.include(unscaled(vertex));
    if (box.empty()) continue;
    whole.include(box);
    middles.include(box.center());
    spread.size = std::max({spread.size, box.width(), box.height()});
  }
  for (const scene::Curve& curve : scene.curves)
    if ((curve.kind == scene::CurveKind::path || curve.kind == scene::CurveKind::axis_path) && curve.body < 0)
      for (const Vector& point : curve.points) path.include(unscaled(point));
  const auto largest = [](const Box& box) { return box.empty() ? 0 : std::max(box.width(), box.height()); };
  spread.way = largest(middles);
  spread.path = largest(path);
  spread.whole = largest(whole);
  return spread;
}

// Whether some body is seen to turn: of a ball that is not seen, and where nothing turns the way is all there is.
bool turns_visibly(const scene::Scene& scene, const std::vector<std::size_t>& shown) {
  constexpr double noticeable = 0.02;
  const auto& poses = scene.motion->poses;
  for (std::size_t k = 0; k < scene.bodies.size(); ++k) {
    if (std::ranges::all_of(scene.bodies[k].shapes, [](const scene::Shape& shape) { return shape.kind == "sphere"; }))
      continue;
    for (const std::size_t i : shown)
      for (std::size_t axis = 0; axis < 3; ++axis)
        if (norm((poses[i][k].R - poses[shown.front()][k].R) * Vector::unit(axis)) > noticeable) return true;
  }
  return false;
}

// The bodies that are elsewhere or turned otherwise than in the last of these poses: what stays is drawn there alone,
// before all that is past.
std::vector<int> moving_bodies(const scene::Scene& scene, const std::vector<int>& bodies,
                               const std::vector<std::size_t>& shown) {
  constexpr double unseen = 1e-6;  // of the length of the scene, and of a full scale of its axes
  const auto& poses = scene.motion->poses;
  const auto moves = [&](int body) {
    const auto own = static_cast<std::size_t>(body);
    const scene::Pose& last = poses[shown.back()][own];
    return std::ranges::any_of(shown, [&](std::size_t i) {
      const scene::Pose& pose = poses[i][own];
      bool elsewhere = norm(pose.p - last.p) > unseen * scene.length;
      for (std::size_t axis = 0; axis < 3; ++axis)
        elsewhere = elsewhere || norm((pose.R - last.R) * Vector::unit(axis)) > unseen;
      return elsewhere;
    });
  };
  std::vector<int> moving;
  std::ranges::copy_if(bodies, std::back_inserter(moving), moves);
  return moving;
}

// Brings what runs between wheels to where it is at a time of the motion.
void move_links(Panel& panel, const scene::Motion& motion, std::size_t time) {
  for (const scene::MovingLink& moving : motion.links) {
    scene::Link& link = panel.links[moving.link];
    for (const auto& [place, at] : {std::pair{&link.from, moving.from[time]}, std::pair{&link.to, moving.to[time]}}) {
      if (place->body < 0) {
        place->at = at;
        continue;
      }
      const scene::Pose& pose = panel.poses[static_cast<std::size_t>(place->body)];
      place->at = transpose_times(pose.R, Vector(at - pose.p));
    }
  }
}

// A long and flat way has more room along it.
Size size_of_way(const View& view, const std::vector<Vector>& places) {
  constexpr double widest = 640;
  const Projection unscaled(view, 1);
  Box box;
  for (const Vector& place : places) box.include(unscaled(place));
  Size size = size_of_panels(1);
  const double flat = size.height / size.width * box.width() / std::max(box.height(), 1e-300);
  if (flat > 1) size.width = std::min(widest, std::sqrt(flat) * size.width);
  return size;
}

// The poses beside and below each other, all to one scale.
Drawing rows_of_poses(const scene::Scene& scene, const Looks& looks, const View& view, bool lost) {
  const scene::Motion& motion = *scene.motion;
  const std::vector<int> bodies = all_bodies(scene);
  const std::vector<std::size_t> shown = spread_over(motion.poses.size(), poses_in_rows);
  constexpr Size size{190, 190};
  std::vector<Projection> projections;
  double scale = 1e300;
  for (const std::size_t i : shown) {
    projections.push_back(fitted(view, places_of(scene, bodies, motion.poses[i], {}, !lost), size));
    scale = std::min(scale, projections.back().scale());
  }
  Drawing rows;
  for (std::size_t begin = 0; begin < shown.size(); begin += poses_in_row) {
    std::vector<Drawing> parts;
    std::vector<std::string> captions;
    for (std::size_t k = begin; k < std::min(begin + poses_in_row, shown.size()); ++k) {
      Panel panel(scene, bodies, motion.poses[shown[k]], Projection(view, scale, projections[k].center()));
      panel.values = looks.values;
      move_links(panel, motion, shown[k]);
      if (!lost) draw_posts(panel);
      draw_symbols(panel, Layer::behind_bodies);
      draw_bodies(panel);
      if (!lost) draw_links(panel);
      draw_symbols(panel, Layer::before_bodies);
      draw_points(panel, {}, lost);
      if (k == 0) draw_axes(panel, false);
      parts.push_back(finished(panel));
      captions.push_back(unbroken("t = " + value_text(motion.times[shown[k]], "s")));
    }
    Drawing row = side_by_side(std::move(parts), {""}, captions);
    constexpr double gap = 18;
    const double y = rows.paper.empty() ? 0 : rows.paper.bottom + gap - row.paper.top;
    append(rows, moved(std::move(row), {0, y}));
  }
  return rows;
}

}  // namespace

Drawing motion_figure(const scene::Scene& scene, const Looks& looks) {
  const scene::Motion& motion = *scene.motion;
  const std::vector<std::size_t> shown = spread_over(motion.poses.size(), most_poses);
  const std::vector<int> bodies = all_bodies(scene);
  std::vector<Vector> places;
  for (const std::size_t i : shown)
    std::ranges::move(places_of(scene, bodies, motion.poses[i], {}, i == shown.back()), std::back_inserter(places));
  for (const scene::Curve& curve : scene.curves)
    if (curve.kind == scene::CurveKind::path && curve.body < 0)
      std::ranges::copy(curve.points, std::back_inserter(places));
  const View view = looks.view ? *looks.view : chosen_view_of_motion(scene, bodies, motion.poses[shown.back()]);
  const Spread spread = spread_of(scene, bodies, shown, view);
  const bool lost = spread.lost() && turns_visibly(scene, shown);
  if (spread.piled() || lost) return rows_of_poses(scene, looks, view, lost);
  const Projection projection = fitted(view, places, size_of_way(view, places));
  std::vector<Mark> before;
  const std::vector<int> moving = moving_bodies(scene, bodies, shown);
  for (std::size_t k = 0; k + 1 < shown.size(); ++k) {
    Panel panel(scene, moving, motion.poses[shown[k]], projection);
    draw_bodies(panel, 0.25 + 0.35 * static_cast<double>(k) / static_cast<double>(shown.size()));
    // What is past stands behind labels.
    for (Mark& mark : panel.marks) {
      std::visit(
          [](auto& own) {
            if constexpr (requires { own.role; })
              if (own.role == Role::outline || own.role == Role::rod) own.role = Role::hidden;
          },
          mark);
      before.push_back(std::move(mark));
    }
  }
  Panel panel(scene, bodies, motion.poses[shown.back()], projection);
  panel.marks = std::move(before);
  move_links(panel, motion, shown.back());
  draw_posts(panel);
  draw_symbols(panel, Layer::behind_bodies);
  draw_bodies(panel);
  draw_links(panel);
  draw_symbols(panel, Layer::before_bodies);
  draw_paths(panel);
  panel.small = is_small(panel);
  draw_axes(panel, true);
  if (!panel.small) {
    draw_points(panel, {});
    draw_body_names(panel);
  }
  Drawing drawing = finished(panel);
  const bool has_path = std::ranges::any_of(scene.curves, [](const scene::Curve& curve) {
    return !curve.closed && (curve.kind == scene::CurveKind::path || curve.kind == scene::CurveKind::axis_path);
  });
  caption(drawing,
          fmt::format("From t = {} to {}, {} poses{}", value_text(motion.times[shown.front()], ""),
                      value_text(motion.times[shown.back()], "s"), shown.size(),
                      has_path ? "; paths begin at small circles" : ""),
          200);
  return drawing;
}

}  // namespace poinsot::pictures
