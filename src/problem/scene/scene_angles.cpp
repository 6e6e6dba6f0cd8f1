// A datum is the angle between a line of the figure and another one, or an axis, at one point, if they make it and the
// angle grows as the datum does: told by the derivatives of their directions, so that numbers which are equal by chance
// are not confused.
#include "problem/scene/scene_angles.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include "problem/language/diagnostic.h"
#include "problem/language/expression_walk.h"
#include "problem/machine/shapes.h"

namespace poinsot::problem {
namespace {

using Scalar = Dual<1>;
using VariedVector = Vector3<Scalar>;

constexpr double exact = 1e-9;
constexpr double arm_part = 0.2;  // of the figure: the length of the lines between which an arc is drawn

Vector3<double> plain(const VariedVector& v) { return {v.x.value, v.y.value, v.z.value}; }
Vector3<double> derivative(const VariedVector& v) { return {v.x.partial[0], v.y.partial[0], v.z.partial[0]}; }

// A line that leaves a point, on the axes of a body as drawn.
struct Ray {
  scene::Place from;
  VariedVector along;
};

// The angle between two rays and its derivative.
std::pair<double, double> angle_between(const VariedVector& a, const VariedVector& b) {
  const Vector3<double> u = plain(a), v = plain(b), du = derivative(a), dv = derivative(b);
  const double lengths = norm(u) * norm(v);
  if (!(lengths > 0)) return {0, 0};
  const double cosine = dot(u, v) / lengths;
  const Vector3<double> normal = cross(u, v);
  const double sine = norm(normal) / lengths;
  if (sine < exact) return {0, 0};
  // d cos = -sin d(angle)
  const double lengths_rate = dot(u, du) / norm_squared(u) + dot(v, dv) / norm_squared(v);
  const double cosine_rate = (dot(du, v) + dot(u, dv)) / lengths - cosine * lengths_rate;
  return {std::atan2(sine, cosine), -cosine_rate / sine};
}

class AngleFinder {
 public:
  AngleFinder(SceneFigure& figure, const NamedAngle& angle)
      : figure_(figure), angle_(angle), data_(figure.situation(), figure.data().settings()) {
    Value<double> value = figure.data().value(built(Name{angle.name}, Mark{}));
    data_.vary(angle.name, as_variable(value));
  }

  void add() {
    if (!(angle_.value > exact) || !(angle_.value < std::numbers::pi - exact)) return;
    if (of_slopes() || of_rays(shape_rays()) || of_rays(segment_rays()) || of_rays(edge_rays()) ||
        of_rays(spin_rays()) || of_rays(load_rays()) || of_rays(turning_rays()))
      return;
    of_coordinates();
  }

 private:
  void put(const scene::Place& corner, const scene::Place& from, const scene::Place& to) {
    scene::Dimension dimension;
    dimension.name = angle_.name;
    dimension.text = angle_.text;
    dimension.angle = true;
    dimension.corner = corner;
    dimension.from = from;
    dimension.to = to;
    figure_.scene().dimensions.push_back(std::move(dimension));
  }
  scene::Place beyond(const scene::Place& corner, const Vector3<double>& along) const {
    return {corner.body, corner.at + arm_part * figure_.scene().length * normalized(along)};
  }

  template <class Find>
  void or_none(const Find& find) {
    try {
      find();
    } catch (const StatementError&) {
      // What has no value yet has no place in the figure.
    }
  }

  // The arc between a ray that varies and another one or an axis at the same point.
  bool of_rays(const std::vector<Ray>& rays) {
    for (const Ray& ray : rays) {
      if (norm(derivative(ray.along)) == 0) continue;
      for (const double sense : {1.0, -1.0})
        for (std::size_t k = 0; k < 3; ++k)
          if (makes(ray, VariedVector::unit(k) * Scalar(sense))) return true;
      for (const Ray& other : rays)
        if (&other != &ray && other.from.body == ray.from.body &&
            norm(Vector3<double>(other.from.at - ray.from.at)) < exact * figure_.scene().length &&
            makes(ray, other.along))
          return true;
    }
    return false;
  }
  bool makes(const Ray& ray, const VariedVector& other) {
    const auto [angle, rate] = angle_between(ray.along, other);
    if (std::abs(angle - angle_.value) > exact || std::abs(rate - 1) > exact) return false;
    put(ray.from, beyond(ray.from, plain(other)), beyond(ray.from, plain(ray.along)));
    return true;
  }

  // Between a surface that is touched and an axis that runs into what is touched.
  bool of_slopes() {
    bool found = false;
    for (const Contact& contact : figure_.situation().contacts)
      or_none([&] {
        if (found || !contact.touches()) return;
        const VariedVector normal = data_.direction(contact.normal);
        const Vector3<double> turning = derivative(normal);
        // The slope turns with its normal, as fast as the angle grows.
        if (std::abs(norm(turning) - 1) > exact) return;
        VariedVector slope;
        for (std::size_t k = 0; k < 3; ++k) {
          slope[k].value = turning[k];
          slope[k].partial[0] = -normal[k].value;
        }
        const scene::Place at{scene::ground,
                              figure_.on_ground(figure_.scene_place(figure_.machine().place(
                                  figure_.machine().index.at(contact.of), figure_.data().place(contact.at))))};
        for (const double sense : {1.0, -1.0})
          for (const double other : {1.0, -1.0})
            for (std::size_t k = 0; k < 3; ++k) {
              const VariedVector axis = VariedVector::unit(k) * Scalar(other);
              if (dot(plain(axis), plain(normal)) < -exact && !found) found = makes({at, slope * Scalar(sense)}, axis);
            }
      });
    return found;
  }

  // Axes of frames that turn, and of inertia.
  std::vector<Ray> turning_rays() {
    std::vector<Ray> rays;
    for (const Frame& frame : figure_.situation().frames)
      if (frame.turns && frame.origin)
        or_none([&] {
          rays.push_back({{scene::ground, figure_.data().place(*frame.origin)}, data_.direction(*frame.turns)});
        });
    for (std::size_t k = 0; k < figure_.situation().bodies.size(); ++k)
      if (const auto& inertia = figure_.situation().bodies[k].inertia; inertia && inertia->axis)
        or_none([&] {
          rays.push_back({{static_cast<int>(k), figure_.scene().bodies.at(k).center}, data_.direction(*inertia->axis)});
        });
    return rays;
  }

  // Normals and axes of shapes, at their middles.
  std::vector<Ray> shape_rays() {
    std::vector<Ray> rays;
    for (std::size_t k = 0; k < figure_.situation().bodies.size(); ++k)
      for (const Part& part : figure_.situation().bodies[k].parts) {
        std::optional<VariedVector> center;
        or_none([&] {
          for (const NamedExpression& argument : part.shape.arguments)
            if (argument.name == "center") center = data_.place(argument.value);
        });
        if (!center) continue;
        for (const NamedExpression& argument : part.shape.arguments)
          if (argument.name == "normal" || argument.name == "axis")
            or_none([&] { rays.push_back({{static_cast<int>(k), plain(*center)}, data_.direction(argument.value)}); });
      }
    return rays;
  }

  // The axes about which bodies of a steady motion spin, at their centers.
  std::vector<Ray> spin_rays() {
    std::vector<Ray> rays;
    if (!figure_.situation().steady) return rays;
    for (const Spin& spin : figure_.situation().steady->spins)
      or_none([&] {
        const int body = figure_.scene_body(figure_.machine().index.at(spin.body));
        rays.push_back(
            {{body, figure_.scene().bodies.at(static_cast<std::size_t>(body)).center}, data_.direction(spin.about)});
      });
    return rays;
  }

  // The edges of plates from their ends, and the sides of rectangles from the middles of the edges that they join;
  // those that leave a joint or a named point come first.
  std::vector<Ray> edge_rays() {
    std::vector<Ray> rays;
    for (std::size_t k = 0; k < figure_.situation().bodies.size(); ++k)
      for (const Part& part : figure_.situation().bodies[k].parts)
        or_none([&] {
          const int body = static_cast<int>(k);
          const std::vector<VariedVector> sides = listed(part.shape, "sides");
          if (sides.size() == 2) {
            const VariedVector center = data_.place(shape_argument(part.shape, "center", figure_.situation().file));
            for (const auto& [side, other] : {std::pair{sides[0], sides[1]}, std::pair{sides[1], sides[0]}})
              for (const double sense : {1.0, -1.0})
                for (const double aside : {0.0, -0.5, 0.5})
                  rays.push_back(
                      {{body, plain(center) - 0.5 * sense * plain(side) + aside * plain(other)}, side * Scalar(sense)});
          }
          for (const char* list : {"corners", "points"}) {
            const std::vector<VariedVector> corners = listed(part.shape, list);
            for (std::size_t i = 0; i + 1 < corners.size(); ++i) {
              rays.push_back({{body, plain(corners[i])}, corners[i + 1] - corners[i]});
              rays.push_back({{body, plain(corners[i + 1])}, corners[i] - corners[i + 1]});
            }
          }
        });
    std::stable_partition(rays.begin(), rays.end(), [&](const Ray& ray) { return is_marked(ray.from); });
    return rays;
  }
  // The places or vectors of a plane shape that stand in a list.
  std::vector<VariedVector> listed(const Shape& shape, const std::string& name) {
    std::vector<VariedVector> values;
    if (shape.kind != "rectangle" && shape.kind != "polygon" && shape.kind != "triangle") return values;
    for (const NamedExpression& argument : shape.arguments)
      if (const List* list = argument.value.as<List>(); list != nullptr && argument.name == name)
        for (const Expression& item : list->items) values.push_back(data_.place(item));
    return values;
  }
  // Whether a joint or a named point stands there.
  bool is_marked(const scene::Place& place) const {
    const Vector3<double> at = figure_.on_ground(place);
    const auto is_there = [&](const scene::Place& other) {
      return norm(Vector3<double>(figure_.on_ground(other) - at)) < exact * figure_.scene().length;
    };
    const scene::Scene& scene = figure_.scene();
    return std::any_of(scene.symbols.begin(), scene.symbols.end(), [&](const auto& s) { return is_there(s.place); }) ||
           std::any_of(scene.points.begin(), scene.points.end(), [&](const auto& p) { return is_there(p.place); });
  }

  // Segments between named points along what is drawn, from either end.
  std::vector<Ray> segment_rays() {
    constexpr std::size_t most_points = 40;
    struct Known {
      scene::Place place;
      VariedVector drawn;
    };
    std::vector<Known> points;
    for (const scene::Point& point : figure_.scene().points)
      if (points.size() < most_points)
        or_none([&] { points.push_back({point.place, data_.place(built(Name{point.name}, Mark{}))}); });
    std::vector<Ray> rays;
    for (const Known& from : points)
      for (const Known& to : points)
        if (&from != &to && along_something(from.place, to.place)) rays.push_back({from.place, to.drawn - from.drawn});
    return rays;
  }
  // Whether an edge of a body, a cord, or the line from where a body is held to its center runs along the segment.
  bool along_something(const scene::Place& from, const scene::Place& to) const {
    const Vector3<double> a = figure_.on_ground(from), b = figure_.on_ground(to), d = b - a;
    const double length = norm(d), near = 1e-6 * figure_.scene().length;
    if (!(length > near)) return false;
    const auto on_line = [&](const Vector3<double>& p) {
      return norm(Vector3<double>(cross(p - a, d))) < near * length;
    };
    for (const scene::Body& body : figure_.scene().bodies)
      for (const scene::Shape& shape : body.shapes)
        for (const auto& edge : shape.edges)
          for (std::size_t i = 0; i + 1 < edge.size(); ++i) {
            const Vector3<double> p = body.pose.R * shape.vertices[edge[i]] + body.pose.p;
            const Vector3<double> q = body.pose.R * shape.vertices[edge[i + 1]] + body.pose.p;
            if (on_line(p) && on_line(q)) return true;
          }
    for (const scene::Symbol& symbol : figure_.scene().symbols) {
      if (symbol.to < 0 || figure_.scene().bodies[static_cast<std::size_t>(symbol.to)].massless) continue;
      const scene::Place center{symbol.to, figure_.scene().bodies[static_cast<std::size_t>(symbol.to)].center};
      const Vector3<double> p = figure_.on_ground(symbol.place), q = figure_.on_ground(center);
      if (norm(Vector3<double>(q - p)) > near && on_line(p) && on_line(q)) return true;
    }
    for (const scene::Link& link : figure_.scene().links)
      if (link.kind == scene::LinkKind::cord && on_line(figure_.on_ground(link.from)) &&
          on_line(figure_.on_ground(link.to)))
        return true;
    return false;
  }

  // Forces and impulses that lean, from where they act.
  std::vector<Ray> load_rays() {
    std::vector<Ray> rays;
    const auto add = [&](const std::optional<Expression>& at, const std::string& body,
                         const std::optional<Expression>& direction, const std::optional<Expression>& value) {
      if (!at || (!direction && !value)) return;
      or_none([&] {
        const int number = figure_.scene_body(figure_.machine().index.at(body));
        VariedVector along;
        if (direction) {
          along = data_.direction(*direction);
        } else {
          const Value<Scalar> force = data_.value(*value);
          if (!force.is_vector()) return;
          along = force.vector;
        }
        rays.push_back({{number, figure_.data().place(*at)}, along});
      });
    };
    for (const Load& load : figure_.situation().loads)
      if (load.axes.empty() || load.axes == "ground") add(load.at, load.body, load.direction, load.force);
    for (const Impulse& impulse : figure_.situation().impulses)
      if (impulse.axes.empty() || impulse.axes == "ground")
        add(impulse.at, impulse.body, impulse.direction, impulse.value);
    return rays;
  }

  // How far a hinge has turned its body away from where it is drawn: between the arm to the body's center as drawn and
  // as it is.
  void of_coordinates() {
    for (const Joint& joint : figure_.situation().joints)
      for (const Freedom& freedom : joint.freedoms) {
        const Name* name = freedom.position && freedom.turning ? freedom.position->as<Name>() : nullptr;
        if (name == nullptr || name->name != angle_.name || joint.freedoms.size() != 1) continue;
        const JointPlace& place = figure_.machine().joints.at(joint.name);
        const int from = figure_.scene_body(place.from), to = figure_.scene_body(place.to);
        if (to < 0 || !place.axis) continue;
        const scene::Place corner = figure_.scene_place(place.at);
        if (corner.body != to) continue;
        const Vector3<double>& axis = place.axis->vector;
        Vector3<double> arm = figure_.scene().bodies[static_cast<std::size_t>(to)].center - corner.at;
        arm = arm - dot(arm, axis) / norm_squared(axis) * axis;
        if (!(norm(arm) > exact * figure_.scene().length)) arm = carried_axis(to, axis);
        if (!(norm(arm) > exact * figure_.scene().length)) continue;
        // As drawn, the axes of all bodies are those of the ground.
        const scene::Place fixed{from, corner.at};
        if (norm(Vector3<double>(figure_.on_ground(fixed) - figure_.on_ground(corner))) >
            exact * figure_.scene().length)
          continue;
        put(corner, beyond(fixed, arm), beyond(corner, arm));
        return;
      }
  }

  // Of what a body carries in gimbals the axis, across that of the body; zero if there is none.
  Vector3<double> carried_axis(int body, const Vector3<double>& axis) const {
    for (const scene::Symbol& symbol : figure_.scene().symbols)
      if (symbol.from == body && norm(symbol.axis) > 0)
        if (const Vector3<double> arm = symbol.axis - dot(symbol.axis, axis) / norm_squared(axis) * axis;
            norm(arm) > 0.1 * norm(symbol.axis))
          return figure_.scene().length * arm;
    return {};
  }

  SceneFigure& figure_;
  const NamedAngle& angle_;
  DataScope<Scalar> data_;
};

}  // namespace

void add_angle(SceneFigure& figure, const NamedAngle& angle) { AngleFinder(figure, angle).add(); }

}  // namespace poinsot::problem
