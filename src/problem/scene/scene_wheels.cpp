#include "problem/scene/scene_wheels.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <iterator>
#include <numbers>
#include <set>

#include "poinsot/engine/mass/outlines.h"
#include "poinsot/engine/mass/particle_set.h"
#include "problem/language/diagnostic.h"

namespace poinsot::problem {
namespace {

constexpr double same_part = 1e-6;  // of the radius: what wheels that are one differ by

bool lie_in_one_plane(const SceneWheel& a, const SceneWheel& b) {
  return a.body == b.body && norm(Vector3<double>(a.center - b.center)) <= same_part * a.radius &&
         norm(Vector3<double>(cross(a.axis, b.axis))) <= same_part;
}

// Whether a shape of the body is round with the radius about the axis of the wheel.
bool is_seen(const SceneFigure& figure, const SceneWheel& wheel) {
  const scene::Body& body = figure.scene().bodies[static_cast<std::size_t>(wheel.body)];
  const Vector3<double> center = transpose_times(body.pose.R, Vector3<double>(wheel.center - body.pose.p));
  const Vector3<double> axis = transpose_times(body.pose.R, wheel.axis);
  constexpr double alike = 1e-3;
  return std::ranges::any_of(body.shapes, [&](const scene::Shape& shape) {
    constexpr std::ptrdiff_t round = 8;  // vertices: corners may lie as far from the axis
    return std::ranges::count_if(shape.vertices, [&](const Vector3<double>& vertex) {
             return std::abs(norm(Vector3<double>(cross(vertex - center, axis))) - wheel.radius) < alike * wheel.radius;
           }) >= round;
  });
}

scene::Curve circle_of(const SceneFigure& figure, const SceneWheel& wheel, scene::CurveKind kind) {
  const cubature::Triad<double> triad(wheel.axis);
  scene::Curve circle{kind, "", wheel.body, true, {}};
  constexpr int count = 72;
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * std::numbers::pi * i / count;
    const Vector3<double> at =
        wheel.center + wheel.radius * (std::cos(angle) * triad.first + std::sin(angle) * triad.second);
    if (wheel.body == scene::ground) {
      circle.points.push_back(at);
      continue;
    }
    const scene::Pose& pose = figure.scene().bodies[static_cast<std::size_t>(wheel.body)].pose;
    circle.points.push_back(transpose_times(pose.R, Vector3<double>(at - pose.p)));
  }
  return circle;
}

// On the axes of the body.
Outline disk_of(const SceneFigure& figure, const SceneWheel& wheel) {
  const scene::Pose& pose = figure.scene().bodies[static_cast<std::size_t>(wheel.body)].pose;
  return outlines::disk(transpose_times(pose.R, Vector3<double>(wheel.center - pose.p)),
                        transpose_times(pose.R, wheel.axis), wheel.radius);
}

void add_disks(SceneFigure& figure, int body, const std::vector<SceneWheel>& wheels) {
  scene::Body& drawn = figure.scene().bodies[static_cast<std::size_t>(body)];
  std::vector<bool> taken(wheels.size());
  // The largest first: smaller ones in its plane are steps on it.
  for (std::size_t i = 0; i < wheels.size(); ++i) {
    if (wheels[i].body != body || taken[i]) continue;
    Outline outline = disk_of(figure, wheels[i]);
    for (std::size_t k = i + 1; k < wheels.size(); ++k) {
      if (!lie_in_one_plane(wheels[i], wheels[k])) continue;
      taken[k] = true;
      const Outline step = disk_of(figure, wheels[k]);
      const auto before = static_cast<std::uint32_t>(outline.vertices.size());
      std::ranges::copy(step.vertices, std::back_inserter(outline.vertices));
      for (std::vector<std::uint32_t> edge : step.edges) {
        for (std::uint32_t& vertex : edge) vertex += before;
        outline.edges.push_back(std::move(edge));
      }
    }
    scene::Shape shape;
    shape.kind = "disk";
    shape.extent = scene::Extent::surface;
    shape.vertices = std::move(outline.vertices);
    shape.triangles = std::move(outline.triangles);
    shape.normals = std::move(outline.normals);
    shape.edges = std::move(outline.edges);
    drawn.shapes.push_back(std::move(shape));
  }
  // The rim tells where teeth meet.
  std::erase_if(figure.scene().curves, [&](const scene::Curve& curve) {
    return curve.kind == scene::CurveKind::pitch_circle && curve.body == body;
  });
}

// Whether a cord ends on a wheel or goes round it, rather than teeth meeting there.
bool leads_a_cord(const SceneFigure& figure, const SceneWheel& wheel) {
  return std::ranges::any_of(figure.mechanism().components, [&](const Component<double>& part) {
    if (!part.span) return false;
    return std::ranges::any_of(std::array{part.span->from, part.span->to}, [&](const CordEnd<double>& end) {
      return end.reach != 0 && figure.scene_body(end.body()) == wheel.body &&
             std::abs(std::abs(end.reach) - wheel.radius) <= same_part * wheel.radius;
    });
  });
}

}  // namespace

std::vector<const Component<double>*> straight_parts(const Mechanism<double>& mechanism, const std::string& cord) {
  std::vector<const Component<double>*> parts;
  std::set<int> actions;
  for (const Component<double>& part : mechanism.components)
    if (part.span && mechanism.actions[static_cast<std::size_t>(part.action)].name == cord &&
        actions.insert(part.action).second)
      parts.push_back(&part);
  return parts;
}

std::vector<SceneWheel> wheels_of(const SceneFigure& figure) {
  std::vector<SceneWheel> wheels;
  const auto add = [&](int tree_body, const Vector3<double>& center, const Vector3<double>& axis, double radius) {
    // A massless link between the freedoms of a joint is nothing that is drawn.
    const int body = figure.scene_body(tree_body);
    if (!(radius > 0) || !(norm(axis) > 0) || (body == scene::ground && tree_body != ground)) return;
    const SceneWheel wheel{body, center, normalized(axis), radius};
    if (std::ranges::none_of(wheels, [&](const SceneWheel& other) {
          return lie_in_one_plane(wheel, other) && std::abs(other.radius - radius) <= same_part * radius;
        }))
      wheels.push_back(wheel);
  };
  for (const Component<double>& part : figure.mechanism().components) {
    if (!part.span) continue;
    for (const CordEnd<double>& end : {part.span->from, part.span->to})
      if (end.reach != 0)
        add(end.body(), figure.state().position(end.center), figure.state().direction(part.span->axis),
            std::abs(end.reach));
  }
  for (const ToothMeshOf<double>& mesh : figure.machine().tooth_meshes) {
    const Gear& gear = *std::ranges::find(figure.situation().gears, mesh.name, &Gear::name);
    const Vector3<double> P = figure.state().position(mesh.at);
    // A ring with teeth on its inside holds the other wheel, and is no disk.
    const bool inside = dot(mesh.of.arm, mesh.against.arm) > 0;
    const double least = std::min(norm(mesh.of.arm), norm(mesh.against.arm));
    for (const auto& [side, name] : {std::pair{&mesh.of, &gear.of}, std::pair{&mesh.against, &gear.against}})
      if (*name != "ground" && !(inside && norm(side->arm) > least))
        add(figure.machine().index.at(*name), P - figure.state().direction({mesh.carrier, side->arm}),
            cross(figure.state().direction({mesh.carrier, side->arm}),
                  figure.state().direction({mesh.carrier, side->tangential})),
            norm(side->arm));
  }
  std::ranges::stable_sort(wheels, std::ranges::greater{}, &SceneWheel::radius);
  return wheels;
}

void add_wheels(SceneFigure& figure) {
  const std::vector<SceneWheel> wheels = wheels_of(figure);
  for (const SceneWheel& wheel : wheels) {
    if (wheel.body == scene::ground) {
      figure.scene().curves.push_back(circle_of(figure, wheel, scene::CurveKind::post));
      continue;
    }
    const auto& shapes = figure.scene().bodies[static_cast<std::size_t>(wheel.body)].shapes;
    if (shapes.empty())
      add_disks(figure, wheel.body, wheels);
    else if (leads_a_cord(figure, wheel) && !is_seen(figure, wheel))
      // What a cord winds on, as the hub of a reel whose rim alone is stated.
      figure.scene().curves.push_back(circle_of(figure, wheel, scene::CurveKind::pitch_circle));
  }
}

void add_wraps(SceneFigure& figure) {
  const std::vector<scene::Link>& links = figure.scene().links;
  std::set<std::string> seen;
  for (std::size_t first = 0; first < links.size(); ++first) {
    if (links[first].kind != scene::LinkKind::cord || !seen.insert(links[first].name).second) continue;
    const std::string& name = links[first].name;
    const std::vector<const Component<double>*> parts = straight_parts(figure.mechanism(), name);
    const bool closed =
        std::ranges::find(figure.situation().belts, name, &Belt::name) != figure.situation().belts.end();
    for (std::size_t k = 0; k < parts.size(); ++k) {
      if (k + 1 == parts.size() && !closed) break;
      const std::size_t next = (k + 1) % parts.size();
      const CordEnd<double>& wheel = parts[k]->span->to;
      if (wheel.reach == 0) continue;
      // With its center on its right, where it is left of that, a cord turns against the axis.
      const Vector3<double> axis =
          (wheel.reach > 0 ? -1.0 : 1.0) * normalized(figure.state().direction(parts[k]->span->axis));
      const scene::Place center = figure.riding(wheel.body(), figure.state().position(wheel.center));
      const Matrix3<double> R = center.body == scene::ground
                                    ? Matrix3<double>::identity()
                                    : figure.scene().bodies[static_cast<std::size_t>(center.body)].pose.R;
      figure.scene().wraps.push_back({name, first + k, first + next, center, transpose_times(R, axis)});
    }
  }
}

void add_later_surfaces(SceneFigure& figure) {
  if (const std::optional<CentralGravity>& central = figure.situation().central_gravity)
    figure.scene().curves.push_back(
        {scene::CurveKind::attractor, name_of_gravity, scene::ground, false, {figure.data().place(central->toward)}});
  for (const Contact& contact : figure.situation().contacts) {
    if (!contact.open || !contact.surface || contact.against != "ground" || !contact.inside.empty()) continue;
    try {
      const Vector3<double> at = figure.data().place(*contact.surface);
      figure.scene().curves.push_back({scene::CurveKind::surface,
                                       contact.name,
                                       scene::ground,
                                       false,
                                       {at, at + figure.data().direction(contact.normal)}});
    } catch (const StatementError&) {
      // What has no place yet is not drawn.
    }
  }
}

void name_tensions(SceneFigure& figure, const Statement& statement) {
  for (const Ask& ask : statement.asks) {
    if (ask.of.size() != 1 || ask.table || ask.when || ask.extremum) continue;
    const At* at = ask.of.front().as<At>();
    const Call* call = (at ? at->expression : ask.of.front()).as<Call>();
    if (call == nullptr || call->function != "tension" || call->arguments.empty()) continue;
    const std::string cord = to_string(call->arguments.front().value);
    const Expression *from = call->argument("from"), *to = call->argument("to");
    std::size_t number = 0;
    const std::vector<const Component<double>*> parts = straight_parts(figure.mechanism(), cord);
    for (scene::Link& link : figure.scene().links) {
      if (link.kind != scene::LinkKind::cord || link.name != cord) continue;
      const Component<double>* part = number < parts.size() ? parts[number++] : nullptr;
      const bool is_meant =
          from == nullptr || to == nullptr ||
          (part && std::ranges::any_of(figure.machine().cord_parts, [&](const CordPart& one) {
             return one.action == part->action && one.from == to_string(*from) && one.to == to_string(*to);
           }));
      if (!is_meant || !link.symbol.empty()) continue;
      const std::string& name = ask.name;
      // A small letter tells which part of the question it is.
      const bool is_part = name.size() == 1 && std::islower(static_cast<unsigned char>(name.front())) != 0;
      link.symbol = is_part ? (figure.situation().cords.size() == 1 ? "T" : "T_{" + ExplanationTex::upright(cord) + "}")
                    : name.size() == 1                        ? name
                    : name.front() == 'T' && name.size() <= 3 ? "T_{" + std::string(name.begin() + 1, name.end()) + "}"
                                                              : "T_{" + ExplanationTex::upright(name) + "}";
      if (from == nullptr) break;  // One tension is told once.
    }
  }
}

}  // namespace poinsot::problem
