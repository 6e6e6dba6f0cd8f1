// A uniform cylinder of radius R and length h has the moments m R^2/2 about its axis and m (3 R^2 + h^2)/12 across it;
// a cone of radius R and height h has 3 m R^2/10 about its axis and its center at 3 h/4 from its apex; an ellipsoid of
// semi-axes a, b, c has m (b^2 + c^2)/5 about the first.
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

// Whether a body turns about an axis of a joint through its center.
std::optional<Vector3<double>> axis_of_turning(const scene::Scene& scene, int body, const Vector3<double>& center) {
  using scene::SymbolKind;
  for (const scene::Symbol& symbol : scene.symbols) {
    const bool turns = symbol.kind == SymbolKind::revolute || symbol.kind == SymbolKind::journal ||
                       symbol.kind == SymbolKind::thrust || symbol.kind == SymbolKind::hinge;
    if (!turns || symbol.to != body || symbol.place.body != body || !(norm(symbol.axis) > 0)) continue;
    const Vector3<double> axis = normalized(symbol.axis);
    if (norm(Vector3<double>(cross(symbol.place.at - center, axis))) < 1e-6 * scene.length) return axis;
  }
  return std::nullopt;
}

// What only slides: a block of the moments, whose sides squared are 6 (I_2 + I_3 - I_1)/m.
bool only_slides(const scene::Scene& scene, int body) {
  using scene::SymbolKind;
  bool slides = false;
  for (const scene::Symbol& symbol : scene.symbols) {
    if (symbol.to != body) continue;
    if (symbol.kind != SymbolKind::prismatic && symbol.kind != SymbolKind::slot && symbol.kind != SymbolKind::screw)
      return false;
    slides = slides || symbol.kind != SymbolKind::screw;
  }
  return slides;
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

scene::Shape shape_of(Outline outline, const std::string& kind) {
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

// The solid of revolution that has the moments, if all that holds the body leaves it room.
std::optional<scene::Shape> solid_of_revolution(const scene::Scene& scene, int number, const Body& body,
                                                const MassProperties<double>& mass,
                                                const PrincipalAxes<double>& principal) {
  if (principal.symmetry == InertiaSymmetry::triaxial) return std::nullopt;
  const Vector3<double>& moments = principal.moments;
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
    if (const std::optional<Vector3<double>> turning = axis_of_turning(scene, number, own.center);
        turning && held_on_axis(scene, number, own.center, *turning) &&
        !touching_radius(scene, number, own.center, *turning)) {
      // About its axis alone it is as a wheel.
      constexpr double width = 0.2;  // of the radius
      const double rim = std::sqrt(2 * moments.x / mass.mass);
      return shape_of(picture(own.center, *turning, {rim, width * rim}), "cylinder");
    }
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
    const std::optional<Vector3<double>> turning = axis_of_turning(scene, number, own.center);
    const bool is_shaft = turning && norm(Vector3<double>(cross(*turning, axis))) < equal_moments * 1e3;
    if ((size.length > 2 * size.radius && !is_shaft) || !held_on_axis(scene, number, own.center, axis))
      return std::nullopt;
    if (swallows_a_holder(scene, number, own.center, axis, size)) return std::nullopt;
    outline = picture(own.center, axis, size);
    kind = outline.triangles.empty() ? "rod" : size.length < flat * size.radius ? "disk" : "cylinder";
  }
  return shape_of(std::move(outline), kind);
}

bool touches(const scene::Symbol& symbol) {
  return symbol.kind == scene::SymbolKind::contact || symbol.kind == scene::SymbolKind::rolling_contact;
}

// Where joints, supports, cords and springs hold a body or are held by it, each place once.
std::vector<Vector3<double>> held_places(const SceneFigure& figure, int body) {
  const scene::Scene& scene = figure.scene();
  const scene::Pose& pose = scene.bodies[static_cast<std::size_t>(body)].pose;
  std::vector<Vector3<double>> places;
  const auto add = [&](const scene::Place& place) {
    const Vector3<double> at = transpose_times(pose.R, Vector3<double>(figure.on_ground(place) - pose.p));
    constexpr double same = 1e-6;
    if (std::none_of(places.begin(), places.end(), [&](const Vector3<double>& other) {
          return norm(Vector3<double>(other - at)) <= same * norm(at);
        }))
      places.push_back(at);
  };
  for (const scene::Symbol& symbol : scene.symbols)
    if (!touches(symbol) && (symbol.to == body || symbol.from == body)) add(symbol.place);
  for (const scene::Link& link : scene.links)
    for (const scene::Place& place : {link.from, link.to})
      if (place.body == body) add(place);
  return places;
}

// Whether a body is a link of a mechanism, held at places that no one axis of a joint runs through: its arms show it.
bool is_link(const SceneFigure& figure, int body, const std::vector<Vector3<double>>& places) {
  if (places.size() < 2) return false;
  double size = 0;
  for (const Vector3<double>& place : places) size = std::max(size, norm(Vector3<double>(place - places.front())));
  return std::none_of(figure.scene().symbols.begin(), figure.scene().symbols.end(), [&](const scene::Symbol& symbol) {
    if (symbol.to != body || !(norm(symbol.axis) > 0)) return false;
    return std::all_of(places.begin(), places.end(), [&](const Vector3<double>& place) {
      constexpr double aside = 1e-6;
      return norm(Vector3<double>(cross(place - symbol.place.at, symbol.axis))) < aside * size * norm(symbol.axis);
    });
  });
}

// Whether a pin slides in a slot of a body out of reach of its solid: a lever, which its arms show.
bool has_slot_beyond(const SceneFigure& figure, int body, const scene::Shape& solid) {
  const scene::Body& own = figure.scene().bodies[static_cast<std::size_t>(body)];
  const Vector3<double> center = figure.on_ground({body, own.center});
  return std::ranges::any_of(figure.scene().symbols, [&](const scene::Symbol& symbol) {
    if (symbol.kind != scene::SymbolKind::slot || symbol.from != body) return false;
    const Vector3<double> arm = transpose_times(own.pose.R, Vector3<double>(figure.on_ground(symbol.place) - center));
    // Of the length of a cylinder along its axis nothing need be stated in a plane.
    return std::ranges::all_of(solid.vertices, [&](const Vector3<double>& vertex) {
      return dot(arm, vertex - own.center) < norm_squared(arm);
    });
  });
}

// Whether a body is held at its mass center, or about an axis through it.
bool is_middle(const SceneFigure& figure, const scene::Symbol& symbol, int body) {
  const Vector3<double> center = figure.on_ground({body, figure.scene().bodies[static_cast<std::size_t>(body)].center});
  constexpr double same = 1e-6;
  const Vector3<double> arm = figure.on_ground(symbol.place) - center;
  if (norm(arm) <= same * norm(center)) return true;
  const Vector3<double> axis = figure.scene().bodies[static_cast<std::size_t>(body)].pose.R * symbol.axis;
  return norm(axis) > 0 && norm(Vector3<double>(cross(arm, axis))) <= same * norm(arm) * norm(axis);
}

// A top: the cone on the tip at which a body of revolution is held, with its center and its moment about the axis.
std::optional<scene::Shape> cone_on_tip(const SceneFigure& figure, int body, const MassProperties<double>& mass,
                                        const PrincipalAxes<double>& principal,
                                        const std::vector<Vector3<double>>& places) {
  const scene::Scene& scene = figure.scene();
  const scene::Body& own = scene.bodies[static_cast<std::size_t>(body)];
  if (places.size() != 1 || principal.symmetry == InertiaSymmetry::triaxial) return std::nullopt;
  const bool on_tip = std::any_of(scene.symbols.begin(), scene.symbols.end(), [&](const scene::Symbol& symbol) {
    return symbol.to == body &&
           (symbol.kind == scene::SymbolKind::ball || symbol.kind == scene::SymbolKind::ball_support);
  });
  const Vector3<double> arm = own.center - places.front();
  const double distance = norm(arm);
  if (!on_tip || !(distance > 0)) return std::nullopt;
  const Vector3<double> axis = arm / distance;
  double axial = principal.moments.y;
  if (principal.symmetry == InertiaSymmetry::axisymmetric) {
    constexpr double aside = 1e-6;
    if (norm(Vector3<double>(cross(axis, principal.axes.column(principal.symmetry_axis)))) > aside) return std::nullopt;
    axial = principal.moments[principal.symmetry_axis];
  }
  constexpr double center_part = 0.75, widest = 0.7, slimmest = 0.25;  // of the height
  const double height = distance / center_part;
  const double radius =
      std::clamp(std::sqrt(std::max(0.0, axial) / (0.3 * mass.mass)), slimmest * height, widest * height);
  return shape_of(outlines::cone(places.front(), places.front() + height * axis, radius), "cone");
}

// The block of the moments.
std::optional<scene::Shape> block(const scene::Body& own, const MassProperties<double>& mass,
                                  const PrincipalAxes<double>& principal) {
  const double sum = principal.moments.x + principal.moments.y + principal.moments.z;
  Vector3<double> sides;
  for (std::size_t k = 0; k < 3; ++k)
    sides[k] = std::sqrt(std::max(0.0, 6 / mass.mass * (sum - 2 * principal.moments[k])));
  const double longest = std::max({sides.x, sides.y, sides.z});
  constexpr double flattest = 0.2;  // of the longest
  if (!(longest > 0) || !std::isfinite(longest)) return std::nullopt;
  for (std::size_t k = 0; k < 3; ++k) sides[k] = std::max(sides[k], flattest * longest);
  return shape_of(outlines::box(own.center, sides.x * principal.axes.column(0), sides.y * principal.axes.column(1),
                                sides.z * principal.axes.column(2)),
                  "box");
}

// The ellipsoid of the moments. What holds or touches the body stands on it or outside of it.
std::optional<scene::Shape> ellipsoid(const SceneFigure& figure, int body, const MassProperties<double>& mass,
                                      const PrincipalAxes<double>& principal,
                                      const std::vector<Vector3<double>>& places) {
  const scene::Scene& scene = figure.scene();
  const scene::Body& own = scene.bodies[static_cast<std::size_t>(body)];
  const double sum = principal.moments.x + principal.moments.y + principal.moments.z;
  Vector3<double> semi_axes;
  for (std::size_t k = 0; k < 3; ++k)
    semi_axes[k] = std::sqrt(std::max(0.0, 2.5 / mass.mass * (sum - 2 * principal.moments[k])));
  const double longest = std::max({semi_axes.x, semi_axes.y, semi_axes.z});
  constexpr double flattest = 0.12;  // of the longest: a body that is thinner is not seen as one
  for (std::size_t k = 0; k < 3; ++k) semi_axes[k] = std::max(semi_axes[k], flattest * longest);
  // A place's distance from the center beside that of the surface in its direction.
  const auto reach = [&](const Vector3<double>& place) {
    const Vector3<double> d = transpose_times(principal.axes, Vector3<double>(place - own.center));
    return norm(Vector3<double>{d.x / semi_axes.x, d.y / semi_axes.y, d.z / semi_axes.z});
  };
  double scale = 1;
  constexpr double smallest = 0.3;
  for (const Vector3<double>& place : places)
    if (const double own_reach = reach(place); own_reach > 1e-6) scale = std::min(scale, std::max(own_reach, smallest));
  for (const scene::Symbol& symbol : scene.symbols)
    if (touches(symbol) && symbol.to == body) scale = reach(symbol.place.at);
  if (!(scale > 0) || !std::isfinite(scale * longest)) return std::nullopt;
  semi_axes = scale * semi_axes;
  return shape_of(outlines::ellipsoid(own.center, semi_axes.x * principal.axes.column(0),
                                      semi_axes.y * principal.axes.column(1), semi_axes.z * principal.axes.column(2)),
                  "ellipsoid");
}

// Of a body whose moments are left open the wheel about the axis of its joint that reaches its points; if it has none
// beside the axis, those of the ground.
std::optional<scene::Shape> wheel_through_points(const SceneFigure& figure, int body) {
  const scene::Scene& scene = figure.scene();
  const auto held = std::find_if(scene.symbols.begin(), scene.symbols.end(), [&](const scene::Symbol& symbol) {
    return symbol.to == body && symbol.place.body == body && !touches(symbol) && norm(symbol.axis) > 0;
  });
  if (held == scene.symbols.end()) return std::nullopt;
  const Vector3<double> axis = normalized(held->axis);
  const scene::Pose& pose = scene.bodies[static_cast<std::size_t>(body)].pose;
  for (const int owner : {body, scene::ground}) {
    double radius = 0, low = 0, high = 0;
    for (const scene::Point& point : scene.points) {
      if (point.place.body != owner) continue;
      const Vector3<double> d =
          transpose_times(pose.R, Vector3<double>(figure.on_ground(point.place) - pose.p)) - held->place.at;
      radius = std::max(radius, norm(Vector3<double>(cross(d, axis))));
      low = std::min(low, dot(d, axis));
      high = std::max(high, dot(d, axis));
    }
    constexpr double out_of_balance = 0.1;
    const double off_axis =
        norm(Vector3<double>(cross(scene.bodies[static_cast<std::size_t>(body)].center - held->place.at, axis)));
    if (!(radius > thin * (high - low)) || off_axis > out_of_balance * radius) continue;
    const Vector3<double> from = held->place.at + low * axis, to = held->place.at + high * axis;
    if (high - low < flat * radius) return shape_of(outlines::disk(from, axis, radius), "disk");
    return shape_of(outlines::cylinder(from, to, radius), "cylinder");
  }
  return std::nullopt;
}

std::optional<scene::Shape> stand_in(const SceneFigure& figure, int number, const Body& body,
                                     const MassProperties<double>& mass) {
  const PrincipalAxes<double> principal = principal_axes(mass.inertia_center, equal_moments);
  if (!(mass.mass > 0) || !body.inertia || !std::isfinite(norm(principal.moments))) return std::nullopt;
  const std::vector<Vector3<double>> places = held_places(figure, number);
  const bool solid = principal.moments.x > 0;
  if (solid && only_slides(figure.scene(), number))
    return block(figure.scene().bodies[static_cast<std::size_t>(number)], mass, principal);
  if (solid)
    if (std::optional<scene::Shape> shape = solid_of_revolution(figure.scene(), number, body, mass, principal)) {
      if (has_slot_beyond(figure, number, *shape)) return std::nullopt;
      return shape;
    }
  if (std::optional<scene::Shape> shape = cone_on_tip(figure, number, mass, principal, places)) return shape;
  if (body.inertia->rest_any)
    if (std::optional<scene::Shape> shape = wheel_through_points(figure, number)) return shape;
  if (!solid || is_link(figure, number, places)) return std::nullopt;
  // What hangs on a link that its arms show is shown in the same way.
  for (const scene::Symbol& symbol : figure.scene().symbols)
    if (const int carrier = symbol.from; symbol.to == number && carrier >= 0 && !touches(symbol) &&
                                         is_link(figure, carrier, held_places(figure, carrier)) &&
                                         figure.scene().bodies[static_cast<std::size_t>(carrier)].shapes.empty() &&
                                         !is_middle(figure, symbol, number))
      return std::nullopt;
  return ellipsoid(figure, number, mass, principal, places);
}

struct StandIn {
  std::size_t body;
  scene::Shape shape;
  double reach = 0;  // from the mass center
};

// Whether the middle of another body would be inside: what is inside a solid is not seen. Of several stand-ins about
// one middle the smallest remains, as a rotor in rings that have masses.
bool holds_another(const SceneFigure& figure, const StandIn& own, const std::vector<StandIn>& all) {
  const auto middle = [&](std::size_t body) {
    return figure.on_ground({static_cast<int>(body), figure.scene().bodies[body].center});
  };
  for (std::size_t k = 0; k < figure.situation().bodies.size(); ++k) {
    if (k == own.body || figure.scene().bodies[k].massless) continue;
    if (!(norm(Vector3<double>(middle(k) - middle(own.body))) < 0.5 * own.reach)) continue;
    const auto other = std::ranges::find(all, k, &StandIn::body);
    if (other == all.end() || std::pair(other->reach, k) < std::pair(own.reach, own.body)) return true;
  }
  return false;
}

}  // namespace

void add_stand_ins(SceneFigure& figure) {
  std::vector<StandIn> all;
  for (std::size_t k = 0; k < figure.situation().bodies.size(); ++k) {
    const scene::Body& drawn = figure.scene().bodies[k];
    if (drawn.massless || !drawn.shapes.empty()) continue;
    // What stands on corners is no round solid: arms from its center to them show it.
    if (std::ranges::any_of(figure.situation().contacts,
                            [&](const Contact& contact) { return contact.corner && contact.of == drawn.name; }))
      continue;
    std::optional<scene::Shape> shape = stand_in(figure, static_cast<int>(k), figure.situation().bodies[k],
                                                 figure.machine().masses[k].second.properties);
    if (!shape) continue;
    double reach = 0;
    for (const Vector3<double>& vertex : shape->vertices)
      reach = std::max(reach, norm(Vector3<double>(vertex - drawn.center)));
    all.push_back({k, std::move(*shape), reach});
  }
  for (const StandIn& one : all)
    if (!holds_another(figure, one, all)) figure.scene().bodies[one.body].shapes.push_back(one.shape);
}

}  // namespace poinsot::problem
