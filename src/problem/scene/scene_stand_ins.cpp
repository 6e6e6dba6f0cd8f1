// A uniform cylinder of radius R and length h has the moments m R^2/2 about its axis and m (3 R^2 + h^2)/12 across it.
#include "problem/scene/scene_stand_ins.h"

#include <algorithm>
#include <cmath>

#include "poinsot/engine/mass/outlines.h"
#include "poinsot/engine/mass/principal_axes.h"

namespace poinsot::problem {
namespace {

constexpr double equal_moments = 1e-9;  // as a part of the moments: what axisymmetric data differ by
constexpr double thin = 0.02;           // of the length: a thinner cylinder is drawn as a line
constexpr double flat = 0.01;           // of the radius: a shorter one as a disk

// The distance from the axis of a body to where it touches another, if it does.
std::optional<double> touching_radius(const scene::Scene& scene, int body, const Vector3<double>& center,
                                      const Vector3<double>& axis) {
  for (const scene::Symbol& symbol : scene.symbols) {
    if (symbol.kind != scene::SymbolKind::contact && symbol.kind != scene::SymbolKind::rolling_contact) continue;
    if (symbol.to != body || symbol.place.body != body) continue;
    const double radius = norm(Vector3<double>(cross(symbol.place.at - center, axis)));
    if (radius > 0) return radius;
  }
  return std::nullopt;
}

// Whether all that holds a body does so on its axis through the center, as a shaft holds a rotor.
bool held_on_axis(const scene::Scene& scene, int body, const Vector3<double>& center, const Vector3<double>& axis) {
  const double near = 1e-6 * std::max(scene.length, norm(center));
  return std::all_of(scene.symbols.begin(), scene.symbols.end(), [&](const scene::Symbol& symbol) {
    if (symbol.kind == scene::SymbolKind::contact || symbol.kind == scene::SymbolKind::rolling_contact) return true;
    if (symbol.to != body && symbol.from != body) return true;
    if (symbol.place.body != body) return symbol.from == body;
    return norm(Vector3<double>(cross(symbol.place.at - center, axis))) < near;
  });
}

// The radius about the axis and the length along it.
struct Cylinder {
  double radius = 0, length = 0;
};

Outline picture(const Vector3<double>& center, const Vector3<double>& axis, const Cylinder& size) {
  const Vector3<double> half = 0.5 * size.length * axis;
  if (size.radius < thin * size.length) return outlines::rod(center - half, center + half);
  if (size.length < flat * size.radius) return outlines::disk(center, axis, size.radius);
  return outlines::cylinder(center - half, center + half, size.radius);
}

bool is_open(const StatedInertia& inertia) {
  const auto any = [](const std::optional<Expression>& value) { return value && is_any(*value); };
  return inertia.rest_any || any(inertia.transverse) || any(inertia.axial) ||
         std::any_of(inertia.moments.begin(), inertia.moments.end(), any);
}

// Whether a body is held at a point that its solid would swallow. Where it turns about its axis the shaft comes out of
// the solid, and at its center it may be held in gimbals; a top stands on a tip.
bool swallows_a_holder(const scene::Scene& scene, int body, const Vector3<double>& center, const Vector3<double>& axis,
                       const Cylinder& size) {
  return std::any_of(scene.symbols.begin(), scene.symbols.end(), [&](const scene::Symbol& symbol) {
    if (symbol.place.body != body || symbol.kind == scene::SymbolKind::contact ||
        symbol.kind == scene::SymbolKind::rolling_contact)
      return false;
    const Vector3<double> d = symbol.place.at - center;
    const double along = std::abs(dot(d, axis)), near = 1e-6 * scene.length;
    if (norm(d) < near) return false;
    const bool about_axis =
        norm(symbol.axis) > 0 && norm(Vector3<double>(cross(symbol.axis, axis))) < 1e-6 * norm(symbol.axis);
    return !about_axis && along < 0.5 * size.length + near &&
           norm(Vector3<double>(d - dot(d, axis) * axis)) < size.radius;
  });
}

std::optional<scene::Shape> stand_in(const scene::Scene& scene, int number, const Body& body,
                                     const MassProperties<double>& mass) {
  const PrincipalAxes<double> principal = principal_axes(mass.inertia_center, equal_moments);
  const Vector3<double>& moments = principal.moments;
  if (!(mass.mass > 0) || !(moments.x > 0) || !std::isfinite(norm(moments))) return std::nullopt;
  if (principal.symmetry == InertiaSymmetry::triaxial) return std::nullopt;
  const scene::Body& own = scene.bodies[static_cast<std::size_t>(number)];
  Outline outline;
  std::string kind;
  if (principal.symmetry == InertiaSymmetry::spherical) {
    const Vector3<double> any_axis = principal.axes.column(2);
    // Every line through the center is an axis.
    const auto holding = std::find_if(scene.symbols.begin(), scene.symbols.end(), [&](const scene::Symbol& symbol) {
      return symbol.place.body == number && norm(Vector3<double>(symbol.place.at - own.center)) > 0;
    });
    if (holding != scene.symbols.end() &&
        !held_on_axis(scene, number, own.center, normalized(Vector3<double>(holding->place.at - own.center))))
      return std::nullopt;
    const double radius =
        touching_radius(scene, number, own.center, any_axis).value_or(std::sqrt(2.5 * moments.x / mass.mass));
    if (swallows_a_holder(scene, number, own.center, any_axis, {radius, 2 * radius})) return std::nullopt;
    outline = outlines::sphere(own.center, radius);
    kind = "sphere";
  } else {
    const std::size_t along = principal.symmetry_axis;
    const Vector3<double> axis = principal.axes.column(along);
    const double axial = moments[along], transverse = moments[1];
    Cylinder size{std::sqrt(2 * axial / mass.mass)};
    // What is open about the moments across the axis leaves the length open.
    if (!body.inertia || !is_open(*body.inertia))
      size.length = std::sqrt(std::max(0.0, 12 * transverse / mass.mass - 3 * size.radius * size.radius));
    if (const std::optional<double> touching = touching_radius(scene, number, own.center, axis)) {
      size.radius = *touching;
      size.length = std::min(size.length, size.radius);
    }
    // What is longer than wide is a link rather than a rotor, and has arms to what it links.
    if (size.length > 2 * size.radius || !held_on_axis(scene, number, own.center, axis)) return std::nullopt;
    if (swallows_a_holder(scene, number, own.center, axis, size)) return std::nullopt;
    outline = picture(own.center, axis, size);
    kind = outline.triangles.empty() ? "rod" : size.length < flat * size.radius ? "disk" : "cylinder";
  }
  scene::Shape shape;
  shape.kind = kind;
  shape.stand_in = true;
  shape.extent = outline.triangles.empty() ? scene::Extent::line
                 : kind == "disk"          ? scene::Extent::surface
                                           : scene::Extent::volume;
  shape.vertices = std::move(outline.vertices);
  shape.triangles = std::move(outline.triangles);
  shape.normals = std::move(outline.normals);
  shape.edges = std::move(outline.edges);
  return shape;
}

// Whether the middle of another body would be inside: what is inside a solid is not seen.
bool holds_another(const SceneFigure& figure, std::size_t number, const scene::Shape& shape) {
  const scene::Body& own = figure.scene().bodies[number];
  double reach = 0;
  for (const Vector3<double>& vertex : shape.vertices)
    reach = std::max(reach, norm(Vector3<double>(vertex - own.center)));
  const Vector3<double> middle = figure.on_ground({static_cast<int>(number), own.center});
  for (std::size_t k = 0; k < figure.situation().bodies.size(); ++k) {
    const scene::Body& other = figure.scene().bodies[k];
    if (k == number || other.massless) continue;
    if (norm(Vector3<double>(figure.on_ground({static_cast<int>(k), other.center}) - middle)) < 0.5 * reach)
      return true;
  }
  return false;
}

}  // namespace

void add_stand_ins(SceneFigure& figure) {
  for (std::size_t k = 0; k < figure.situation().bodies.size(); ++k) {
    scene::Body& drawn = figure.scene().bodies[k];
    if (drawn.massless || !drawn.shapes.empty()) continue;
    if (std::optional<scene::Shape> shape = stand_in(figure.scene(), static_cast<int>(k), figure.situation().bodies[k],
                                                     figure.machine().masses[k].second.properties);
        shape && !holds_another(figure, k, *shape))
      drawn.shapes.push_back(std::move(*shape));
  }
}

}  // namespace poinsot::problem
