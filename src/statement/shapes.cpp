#include "statement/shapes.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "poinsot/mass/particles.h"
#include "poinsot/mass/shape_faults.h"
#include "poinsot/mass/shapes.h"
#include "statement/mesh_shape.h"
#include "statement/reader.h"

namespace poinsot::statement {
namespace {

using Vector = Vector3<double>;

// The arguments of one shape with their values.
class Arguments {
 public:
  // owner: the body or part, for messages.
  Arguments(const Shape& shape, DataScope<double>& data, const std::string& owner)
      : shape_(shape), data_(data), owner_(owner) {}

  bool has(const std::string& name) const {
    return std::any_of(shape_.arguments.begin(), shape_.arguments.end(),
                       [&](const NamedExpression& argument) { return argument.name == name; });
  }
  const Expression& expression(const std::string& name) const { return shape_argument(shape_, name, file()); }
  Vector place(const std::string& name) const { return data_.place(expression(name)); }
  Vector direction(const std::string& name) const { return data_.direction(expression(name)); }
  // A direction, or the direction from a place to the point named.
  Vector toward(const std::string& name, const Vector& from) const {
    const Expression& e = expression(name);
    const Name* point = e.as<Name>();
    const bool is_point = point && std::any_of(data_.problem().points.begin(), data_.problem().points.end(),
                                               [&](const NamedExpression& item) { return item.name == point->name; });
    if (!is_point) return data_.direction(e);
    const Vector d = data_.place(e) - from;
    if (!(norm(d) > 0)) refuse("the point under " + name + " is where it should be seen from");
    return normalized(d);
  }
  double length(const std::string& name) const { return data_.number(expression(name), dimensions::length); }
  double angle(const std::string& name) const { return data_.number(expression(name), dimensions::angle); }
  // The items of a list of places; `count` of them unless zero.
  std::vector<Vector> places(const std::string& name, std::size_t count = 0) const {
    std::vector<Vector> result;
    for (const Expression& item : items(name, count)) result.push_back(data_.place(item));
    return result;
  }
  std::vector<Vector> directions(const std::string& name, std::size_t count) const {
    std::vector<Vector> result;
    for (const Expression& item : items(name, count)) result.push_back(data_.direction(item));
    return result;
  }
  std::vector<double> lengths(const std::string& name, std::size_t count) const {
    std::vector<double> result;
    for (const Expression& item : items(name, count)) result.push_back(data_.number(item, dimensions::length));
    return result;
  }
  const std::string& file() const { return data_.problem().file; }
  const Shape& shape() const { return shape_; }

  const std::string& owner() const { return owner_; }

  void check(const shape_faults::Fault& fault) const {
    if (fault) fail(file(), shape_.mark, fault->message);
  }
  [[noreturn]] void refuse(const std::string& message, const std::string& hint = "") const {
    fail(file(), shape_.mark, shape_.kind + " '" + owner_ + "': " + message, hint);
  }

 private:
  const std::vector<Expression>& items(const std::string& name, std::size_t count) const {
    const Expression& expression = this->expression(name);
    const List* list = expression.as<List>();
    if (!list || (count && list->items.size() != count))
      fail(file(), expression.mark(),
           "expected a list of " + (count ? std::to_string(count) + " items " : std::string()) + "in brackets for " +
               (name == "points" ? shape_.kind : name));
    return list->items;
  }

  const Shape& shape_;
  DataScope<double>& data_;
  const std::string& owner_;
};

ShapeValues arc(const Arguments& a) {
  if (a.has("diameter")) {
    const auto ends = a.places("diameter", 2);
    const Vector toward = a.toward("toward", 0.5 * (ends[0] + ends[1]));
    a.check(shape_faults::semicircular_arc(a.owner(), ends[0], ends[1], toward));
    return {Extent::length, shapes::semicircular_arc(ends[0], ends[1], toward),
            particles::semicircular_arc(ends[0], ends[1], toward)};
  }
  const Vector center = a.place("center"), start = a.place("start"), normal = a.direction("normal");
  const double angle = a.angle("angle");
  a.check(shape_faults::arc_from_point(a.owner(), center, normal, start, angle));
  return {Extent::length, shapes::arc_from_point(center, normal, start, angle),
          particles::arc_from_point(center, normal, start, angle)};
}

ShapeValues rectangle(const Arguments& a) {
  if (a.has("sides")) {
    const Vector center = a.place("center");
    const auto sides = a.places("sides", 2);
    a.check(shape_faults::rectangle(a.owner(), center, sides[0], sides[1]));
    return {Extent::area, shapes::rectangle(center, sides[0], sides[1]),
            particles::rectangle(center, sides[0], sides[1])};
  }
  const auto corners = a.places("corners");
  if (corners.size() != 3 && corners.size() != 4) a.refuse("it needs three corners in turn, or all four");
  a.check(shape_faults::rectangle_from_corners(a.owner(), corners[0], corners[1], corners[2]));
  const Vector fourth = corners[0] + corners[2] - corners[1];
  if (corners.size() == 4 &&
      norm(corners[3] - fourth) > shape_faults::default_tolerance * norm(corners[2] - corners[0]))
    a.refuse("its fourth corner does not complete the rectangle",
             "list the corners in turn; other plates are a polygon:");
  return {Extent::area, shapes::rectangle_from_corners(corners[0], corners[1], corners[2]),
          particles::rectangle_from_corners(corners[0], corners[1], corners[2])};
}

ShapeValues polygon(const Arguments& a) {
  const auto vertices = a.places("points");
  // A plate that is flat only to fewer digits has no closed form that its particles confirm.
  constexpr double flatness = 1e-8;
  a.check(shape_faults::polygon(a.owner(), vertices, flatness));
  return {Extent::area, shapes::polygon(vertices), particles::polygon(vertices)};
}

ShapeValues box(const Arguments& a) {
  if (a.has("sides")) {
    const Vector c = a.place("center");
    const auto s = a.places("sides", 3);
    a.check(shape_faults::box(a.owner(), c, s[0], s[1], s[2]));
    return {Extent::volume, shapes::box(c, s[0], s[1], s[2]), particles::box(c, s[0], s[1], s[2])};
  }
  const auto c = a.places("corners", 2);
  a.check(shape_faults::box_between(a.owner(), c[0], c[1]));
  return {Extent::volume, shapes::box_between(c[0], c[1]), particles::box_between(c[0], c[1])};
}

ShapeValues cube(const Arguments& a) {
  if (a.has("diagonal")) {
    const auto ends = a.places("diagonal", 2);
    a.check(shape_faults::cube_from_diagonal(a.owner(), ends[0], ends[1]));
    return {Extent::volume, shapes::cube_from_diagonal(ends[0], ends[1]),
            particles::cube_from_diagonal(ends[0], ends[1])};
  }
  const Vector center = a.place("center");
  const double side = a.length("side");
  a.check(shape_faults::cube(a.owner(), center, side));
  return {Extent::volume, shapes::cube(center, side), particles::cube(center, side)};
}

ShapeValues ellipsoid(const Arguments& a) {
  const Vector center = a.place("center");
  const auto s = a.lengths("semi_axes", 3);
  std::vector<Vector> axes{Vector::unit(0), Vector::unit(1), Vector::unit(2)};
  if (a.has("axes")) axes = a.directions("axes", 3);
  for (double length : s)
    if (!(length > 0)) a.refuse("its semi_axes must be more than zero");
  a.check(shape_faults::ellipsoid(a.owner(), center, s[0] * axes[0], s[1] * axes[1], s[2] * axes[2]));
  return {Extent::volume, shapes::ellipsoid(center, s[0] * axes[0], s[1] * axes[1], s[2] * axes[2]),
          particles::ellipsoid(center, s[0] * axes[0], s[1] * axes[1], s[2] * axes[2])};
}

// The two ends of a cylinder given by center, axis and length.
std::pair<Vector, Vector> ends_of(const Arguments& a) {
  const double length = a.length("length");
  if (!(length > 0)) a.refuse("its length must be more than zero");
  const Vector half = 0.5 * length * a.direction("axis");
  return {a.place("center") - half, a.place("center") + half};
}

using Builder = ShapeValues (*)(const Arguments&);

const std::map<std::string, Builder>& builders() {
  static const std::map<std::string, Builder> table{
      {"particle",
       [](const Arguments& a) -> ShapeValues {
         const Vector P = a.place("points");
         a.check(shape_faults::particle(a.owner(), P));
         return {Extent::point, shapes::particle(P), particles::particle(P)};
       }},
      {"rod",
       [](const Arguments& a) -> ShapeValues {
         const auto P = a.places("points", 2);
         a.check(shape_faults::rod(a.owner(), P[0], P[1]));
         return {Extent::length, shapes::rod(P[0], P[1]), particles::rod(P[0], P[1])};
       }},
      {"wire",
       [](const Arguments& a) -> ShapeValues {
         const auto P = a.places("points");
         a.check(shape_faults::polyline(a.owner(), P));
         return {Extent::length, shapes::polyline(P), particles::polyline(P)};
       }},
      {"arc", arc},
      {"ring",
       [](const Arguments& a) -> ShapeValues {
         const Vector c = a.place("center"), n = a.direction("normal");
         const double r = a.length("radius");
         a.check(shape_faults::ring(a.owner(), c, n, r));
         return {Extent::length, shapes::ring(c, n, r), particles::ring(c, n, r)};
       }},
      {"rectangle", rectangle},
      {"triangle",
       [](const Arguments& a) -> ShapeValues {
         const auto P = a.places("points", 3);
         a.check(shape_faults::triangle(a.owner(), P[0], P[1], P[2]));
         return {Extent::area, shapes::triangle(P[0], P[1], P[2]), particles::polygon(P)};
       }},
      {"polygon", polygon},
      {"semicircle",
       [](const Arguments& a) -> ShapeValues {
         const auto P = a.places("diameter", 2);
         const Vector toward = a.toward("toward", 0.5 * (P[0] + P[1]));
         a.check(shape_faults::semicircle(a.owner(), P[0], P[1], toward));
         return {Extent::area, shapes::semicircle(P[0], P[1], toward), particles::semicircle(P[0], P[1], toward)};
       }},
      {"disk",
       [](const Arguments& a) -> ShapeValues {
         const Vector c = a.place("center"), n = a.direction("normal");
         const double r = a.length("radius");
         a.check(shape_faults::disk(a.owner(), c, n, r));
         return {Extent::area, shapes::disk(c, n, r), particles::disk(c, n, r)};
       }},
      {"annulus",
       [](const Arguments& a) -> ShapeValues {
         const Vector c = a.place("center"), n = a.direction("normal");
         const double r = a.length("radius"), inner = a.length("inner_radius");
         a.check(shape_faults::annulus(a.owner(), c, n, r, inner));
         return {Extent::area, shapes::annulus(c, n, r, inner), particles::annulus(c, n, r, inner)};
       }},
      {"sector",
       [](const Arguments& a) -> ShapeValues {
         const Vector c = a.place("center"), n = a.direction("normal"), middle = a.toward("middle", c);
         const double r = a.length("radius"), angle = a.angle("angle");
         if (std::abs(dot(n, middle)) > shape_faults::default_tolerance)
           a.refuse("middle does not lie across the normal");
         a.check(shape_faults::sector(a.owner(), c, n, r, middle, angle));
         return {Extent::area, shapes::sector(c, n, r, middle, angle), particles::sector(c, n, r, middle, angle)};
       }},
      {"box_shell",
       [](const Arguments& a) -> ShapeValues {
         const auto c = a.places("corners", 2);
         a.check(shape_faults::box_shell_between(a.owner(), c[0], c[1]));
         return {Extent::area, shapes::box_shell_between(c[0], c[1]), particles::box_shell_between(c[0], c[1])};
       }},
      {"sphere_shell",
       [](const Arguments& a) -> ShapeValues {
         const Vector c = a.place("center");
         const double r = a.length("radius");
         a.check(shape_faults::sphere_shell(a.owner(), c, r));
         return {Extent::area, shapes::sphere_shell(c, r), particles::sphere_shell(c, r)};
       }},
      {"hemisphere_shell",
       [](const Arguments& a) -> ShapeValues {
         const Vector c = a.place("center"), toward = a.toward("toward", c);
         const double r = a.length("radius");
         a.check(shape_faults::hemisphere_shell(a.owner(), c, toward, r));
         return {Extent::area, shapes::hemisphere_shell(c, toward, r), particles::hemisphere_shell(c, toward, r)};
       }},
      {"cylinder_shell",
       [](const Arguments& a) -> ShapeValues {
         const auto [A, B] = ends_of(a);
         const double r = a.length("radius");
         a.check(shape_faults::cylinder_shell(a.owner(), A, B, r));
         return {Extent::area, shapes::cylinder_shell(A, B, r), particles::cylinder_shell(A, B, r)};
       }},
      {"closed_cylinder_shell",
       [](const Arguments& a) -> ShapeValues {
         const auto [A, B] = ends_of(a);
         const double r = a.length("radius");
         a.check(shape_faults::closed_cylinder_shell(a.owner(), A, B, r));
         return {Extent::area, shapes::closed_cylinder_shell(A, B, r), particles::closed_cylinder_shell(A, B, r)};
       }},
      {"cone_shell",
       [](const Arguments& a) -> ShapeValues {
         const Vector apex = a.place("apex"), base = a.place("base");
         const double r = a.length("radius");
         a.check(shape_faults::cone_shell(a.owner(), apex, base, r));
         return {Extent::area, shapes::cone_shell(apex, base, r), particles::cone_shell(apex, base, r)};
       }},
      {"box", box},
      {"cube", cube},
      {"sphere",
       [](const Arguments& a) -> ShapeValues {
         const Vector c = a.place("center");
         const double r = a.length("radius");
         a.check(shape_faults::sphere(a.owner(), c, r));
         return {Extent::volume, shapes::sphere(c, r), particles::sphere(c, r)};
       }},
      {"hemisphere",
       [](const Arguments& a) -> ShapeValues {
         const Vector c = a.place("center"), toward = a.toward("toward", c);
         const double r = a.length("radius");
         a.check(shape_faults::hemisphere(a.owner(), c, toward, r));
         return {Extent::volume, shapes::hemisphere(c, toward, r), particles::hemisphere(c, toward, r)};
       }},
      {"cylinder",
       [](const Arguments& a) -> ShapeValues {
         const auto [A, B] = ends_of(a);
         const double r = a.length("radius");
         a.check(shape_faults::cylinder(a.owner(), A, B, r));
         return {Extent::volume, shapes::cylinder(A, B, r), particles::cylinder(A, B, r)};
       }},
      {"tube",
       [](const Arguments& a) -> ShapeValues {
         const auto [A, B] = ends_of(a);
         const double r = a.length("radius"), inner = a.length("inner_radius");
         a.check(shape_faults::tube(a.owner(), A, B, r, inner));
         return {Extent::volume, shapes::tube(A, B, r, inner), particles::tube(A, B, r, inner)};
       }},
      {"cone",
       [](const Arguments& a) -> ShapeValues {
         const Vector apex = a.place("apex"), base = a.place("base");
         const double r = a.length("radius");
         a.check(shape_faults::cone(a.owner(), apex, base, r));
         return {Extent::volume, shapes::cone(apex, base, r), particles::cone(apex, base, r)};
       }},
      {"frustum",
       [](const Arguments& a) -> ShapeValues {
         const Vector A = a.place("base"), B = a.place("top");
         const double r_A = a.length("base_radius"), r_B = a.length("top_radius");
         a.check(shape_faults::frustum(a.owner(), A, r_A, B, r_B));
         return {Extent::volume, shapes::frustum(A, r_A, B, r_B), particles::frustum(A, r_A, B, r_B)};
       }},
      {"ellipsoid", ellipsoid},
      {"torus",
       [](const Arguments& a) -> ShapeValues {
         const Vector c = a.place("center"), n = a.direction("normal");
         const double r = a.length("radius"), section = a.length("tube_radius");
         a.check(shape_faults::torus(a.owner(), c, n, r, section));
         return {Extent::volume, shapes::torus(c, n, r, section), particles::torus(c, n, r, section)};
       }},
      {"tetrahedron",
       [](const Arguments& a) -> ShapeValues {
         const auto P = a.places("points", 4);
         a.check(shape_faults::tetrahedron(a.owner(), P[0], P[1], P[2], P[3]));
         return {Extent::volume, shapes::tetrahedron(P[0], P[1], P[2], P[3]),
                 particles::tetrahedron(P[0], P[1], P[2], P[3])};
       }},
      {"mesh",
       [](const Arguments& a) -> ShapeValues {
         return mesh_shape(a.shape(), a.has("at") ? a.place("at") : Vector::zero(), a.file());
       }},
  };
  return table;
}

}  // namespace

const Expression& shape_argument(const Shape& shape, const std::string& name, const std::string& file) {
  for (const NamedExpression& argument : shape.arguments)
    if (argument.name == name) return argument.value;
  fail(file, shape.mark, "a " + shape.kind + " needs '" + name + "'");
}

ShapeValues shape_values(const Shape& shape, DataScope<double>& data, const std::string& owner) {
  const Arguments arguments(shape, data, owner);
  const ShapeValues values = builders().at(shape.kind)(arguments);
  const double measure = values.properties.measure;
  const SymmetricMatrix3<double>& I = values.properties.inertia_center;
  if (values.extent != Extent::point && !(measure > 0))
    arguments.refuse("it has no extent", "its points coincide or lie in one line or plane");
  if (!std::isfinite(measure + I.xx + I.yy + I.zz + I.xy + I.yz + I.zx + norm(values.properties.center)))
    arguments.refuse("its mass properties are beyond the range of numbers", "its lengths are too large");
  return values;
}

}  // namespace poinsot::statement
