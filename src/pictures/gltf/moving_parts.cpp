#include "pictures/gltf/moving_parts.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>

#include "pictures/figure/arrows.h"
#include "pictures/gltf/thin_shapes.h"

namespace poinsot::pictures {
namespace {

using Point = Vector3<double>;
using scene::Quantity;

PartTone tone_of(Quantity quantity) {
  switch (quantity) {
    case Quantity::force:
    case Quantity::weight:
    case Quantity::impulse:
    case Quantity::unbalance:
      return PartTone::load;
    case Quantity::couple:
    case Quantity::angular_impulse:
      return PartTone::couple;
    case Quantity::velocity:
    case Quantity::angular_velocity:
    case Quantity::displacement:
    case Quantity::angular_displacement:
      return PartTone::velocity;
    case Quantity::acceleration:
    case Quantity::angular_acceleration:
      return PartTone::acceleration;
    case Quantity::linear_momentum:
    case Quantity::angular_momentum:
    case Quantity::rate_of_momentum:
    case Quantity::rate_of_angular_momentum:
      break;
  }
  return PartTone::momentum;
}

// The shortest turn that brings z to a direction.
Quaternion<double> turn_to(const Point& direction) {
  constexpr double opposite = 1e-12;
  if (1 + direction.z < opposite) return {0, 1, 0, 0};
  return normalized(Quaternion<double>{1 + direction.z, -direction.y, direction.x, 0});
}

// Nothing is the shown instant; else the number of a time of the motion.
using Frame = std::optional<std::size_t>;

class Parts {
 public:
  explicit Parts(const scene::Scene& scene) : scene_(scene), size_(scene.length) {
    if (scene.motion)
      for (const scene::MovingLink& one : scene.motion->links) moving_links_[one.link] = &one;
  }

  std::vector<MovingPart> all() {
    for (std::size_t i = 0; i < scene_.links.size(); ++i) add_link(i);
    for (const scene::Wrap& wrap : scene_.wraps) add_wrap(wrap);
    for (const scene::Curve& curve : scene_.curves) add_curve(curve);
    if (scene_.motion)
      add_moving_arrows();
    else
      add_arrows();
    return std::move(parts_);
  }

 private:
  scene::Pose pose(int body, Frame frame) const {
    if (body == scene::ground) return {};
    const auto index = static_cast<std::size_t>(body);
    return frame ? scene_.motion->poses[*frame][index] : scene_.bodies[index].pose;
  }
  Point where(const scene::Place& place, Frame frame) const {
    const scene::Pose at = pose(place.body, frame);
    return at.R * place.at + at.p;
  }
  struct Ends {
    Point from, to;
  };
  Ends ends(std::size_t link, Frame frame) const {
    if (frame)
      if (const auto moving = moving_links_.find(link); moving != moving_links_.end())
        return {moving->second->from[*frame], moving->second->to[*frame]};
    return {where(scene_.links[link].from, frame), where(scene_.links[link].to, frame)};
  }

  // stance: of a frame.
  template <class Get>
  void add(const std::string& name, PartTone tone, ThinShape shape, const Get& stance) {
    MovingPart part{name, tone, std::move(shape)};
    part.now = stance(Frame{});
    if (scene_.motion)
      for (std::size_t i = 0; i < scene_.motion->times.size(); ++i) part.along.push_back(stance(Frame{i}));
    parts_.push_back(std::move(part));
  }

  void add_link(std::size_t index) {
    const scene::Link& link = scene_.links[index];
    add(link.name, link.kind == scene::LinkKind::cord ? PartTone::cord : PartTone::metal, link_shape(link.kind, size_),
        [&](Frame frame) {
          const Ends between = ends(index, frame);
          const Point along = between.to - between.from;
          const double length = norm(along);
          if (!(length > 0)) return Stance{between.from, Quaternion<double>::identity(), Point::zero()};
          return Stance{between.from, turn_to(along / length), {1, 1, length}};
        });
  }

  // Where a cord lies on a wheel: on a circle across the axis z, from x on.
  struct Arc {
    Point center, x, axis;
    double radius = 0, angle = 0;
  };
  Arc arc_of(const scene::Wrap& wrap, Frame frame) const {
    Arc arc{where(wrap.center, frame), {1, 0, 0}, normalized(Point(pose(wrap.center.body, frame).R * wrap.axis))};
    const auto across = [&](const Point& place) {
      const Point arm = place - arc.center;
      return Point(arm - dot(arm, arc.axis) * arc.axis);
    };
    const Point begin = across(ends(wrap.comes, frame).from), end = across(ends(wrap.leaves, frame).to);
    arc.radius = norm(begin);
    if (!(arc.radius > 0)) return arc;
    arc.x = begin / arc.radius;
    arc.angle = std::atan2(dot(end, cross(arc.axis, arc.x)), dot(end, arc.x));
    // What is as good as nothing may come out a little below zero.
    constexpr double rounding = 1e-9;
    if (arc.angle < -rounding) arc.angle += 2 * std::numbers::pi;
    arc.angle = std::max(0.0, arc.angle);
    return arc;
  }

  // An arc that grows and shrinks is made of equal pieces, which lie over each other more or less.
  void add_wrap(const scene::Wrap& wrap) {
    double least = arc_of(wrap, {}).angle, most = least;
    if (scene_.motion)
      for (std::size_t i = 0; i < scene_.motion->times.size(); ++i) {
        const double angle = arc_of(wrap, i).angle;
        least = std::min(least, angle);
        most = std::max(most, angle);
      }
    if (!(most > 0)) return;
    // A piece is no longer than the shortest arc, but then too many might be needed.
    constexpr double most_pieces = 40;
    constexpr double seen = 1e-3;  // rad
    const double piece = most - least < seen ? most : std::max(least, most / most_pieces);
    const int count = std::max(1, static_cast<int>(std::ceil(most / piece - seen)));
    for (int k = 0; k < count; ++k)
      add(wrap.name, PartTone::cord, arc_shape(piece), [&](Frame frame) {
        const Arc arc = arc_of(wrap, frame);
        const double on = count == 1 ? 0 : std::max(0.0, arc.angle - piece) * k / (count - 1);
        const Point y = cross(arc.axis, arc.x);
        const Point x = std::cos(on) * arc.x + std::sin(on) * y;
        return Stance{arc.center,
                      quaternion_of(Matrix3<double>::from_columns(x, cross(arc.axis, x), arc.axis)),
                      {arc.radius, arc.radius, arc.radius}};
      });
  }

  void add_curve(const scene::Curve& curve) {
    using Kind = scene::CurveKind;
    if (curve.kind == Kind::surface || curve.kind == Kind::attractor || curve.points.size() < 2) return;
    ThinShape shape;
    const std::size_t count = curve.points.size();
    for (std::size_t i = 0; i + (curve.closed ? 0 : 1) < count; ++i)
      for (const std::size_t end : {i, (i + 1) % count}) shape.lines.push_back(curve.points[end]);
    add(curve.name, PartTone::curve, std::move(shape), [&](Frame frame) {
      const scene::Pose at = pose(curve.body, frame);
      return Stance{at.p, quaternion_of(at.R)};
    });
  }

  // Arrows that stand in one equation share a scale; the smallest stay visible. One of an open size is half as long as
  // the longest.
  void add_arrows() {
    constexpr double longest = 0.34, shortest = 0.1, open = 0.17;  // of the scene
    if (scene_.diagrams.empty()) return;
    const std::vector<scene::Arrow>& arrows = scene_.diagrams.front().arrows;
    std::map<Scale, double> largest;
    for (const scene::Arrow& arrow : arrows)
      if (!arrow.open)
        largest[scale_of(arrow.quantity)] = std::max(largest[scale_of(arrow.quantity)], norm(arrow.vector));
    for (const scene::Arrow& arrow : arrows) {
      const double size = norm(arrow.vector);
      if (!(size > 0)) continue;
      const double length =
          size_ * (arrow.open ? open : std::max(shortest, longest * size / largest.at(scale_of(arrow.quantity))));
      add(arrow.text.empty() ? arrow.name : arrow.text, tone_of(arrow.quantity),
          arrow_shape(arrow.quantity, arrow.swings, length, size_), [&](Frame frame) {
            return Stance{where(arrow.at, frame), turn_to(arrow.vector / size)};
          });
    }
  }

  // They share it over the whole motion.
  void add_moving_arrows() {
    constexpr double longest = 0.3;    // of the scene
    constexpr double shortest = 0.02;  // of the longest: what is shorter is not drawn
    constexpr double smallest = 0.3;   // of the longest: heads do not get smaller
    const std::vector<scene::MovingArrow>& arrows = scene_.motion->arrows;
    std::map<Scale, double> largest;
    for (const scene::MovingArrow& arrow : arrows)
      for (const Point& vector : arrow.vectors)
        largest[scale_of(arrow.quantity)] = std::max(largest[scale_of(arrow.quantity)], norm(vector));
    for (const scene::MovingArrow& arrow : arrows) {
      const double most = largest[scale_of(arrow.quantity)];
      if (!(most > 0)) continue;
      add(arrow.text.empty() ? arrow.name : arrow.text, tone_of(arrow.quantity),
          arrow_shape(arrow.quantity, false, longest * size_, size_), [&](Frame frame) {
            const Point& vector = arrow.vectors[frame.value_or(0)];
            const double size = norm(vector);
            const Point at = where(arrow.at, frame);
            // The shown instant has arrows of its own, which a file with a motion leaves out.
            if (!frame || !(size > shortest * most)) return Stance{at, Quaternion<double>::identity(), Point::zero()};
            const double scale = std::max(smallest, size / most);
            return Stance{at, turn_to(vector / size), {scale, scale, scale}};
          });
    }
  }

  const scene::Scene& scene_;
  double size_;
  std::map<std::size_t, const scene::MovingLink*> moving_links_;
  std::vector<MovingPart> parts_;
};

}  // namespace

std::vector<MovingPart> moving_parts(const scene::Scene& scene) { return Parts(scene).all(); }

}  // namespace poinsot::pictures
