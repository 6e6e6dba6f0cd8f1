// A datum is the distance of two points along an axis of the figure, or the length of an edge, if this grows as the
// datum does: told by derivatives, so that numbers which are equal by chance are not confused.
#include "problem/scene/scene_dimensions.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include "poinsot/engine/mass/particle_set.h"
#include "problem/entries/read_joints.h"
#include "problem/language/diagnostic.h"
#include "problem/language/expression_walk.h"
#include "problem/language/words.h"
#include "problem/machine/shapes.h"
#include "problem/scene/scene_angles.h"
#include "problem/scene/scene_wheels.h"

namespace poinsot::problem {
namespace {

class Dimensions {
 public:
  explicit Dimensions(SceneFigure& figure) : figure_(figure) {}

  void add() {
    const Situation& situation = figure_.situation();
    for (const NamedExpression& item : situation.given)
      if (item.value.as<Number>()) add(item.name, &item.value, nullptr);
    for (const Letter& letter : situation.letters) add(letter.name, nullptr, &letter.unit);
    // The figure of the statement does not tell what is to be found.
    for (const Unknown& unknown : situation.find)
      if (!unknown.vector) add(unknown.name, nullptr, &unknown.unit, false);
    add_friction();
  }

 private:
  // stated: its value in the file; unit: the one that the file gives it; told: whether its value is shown.
  void add(const std::string& name, const Expression* stated, const Unit* unit, bool told = true) {
    try {
      const Value<double> value = figure_.data().value(built(Name{name}, Mark{}));
      const bool angle = value.dimension == dimensions::angle;
      if (!value.is_number() || (value.dimension != dimensions::length && !angle) || !(value.number > 0)) return;
      text_ = stated && !figure_.data().settings().contains(name) ? name + " = " + to_string(*stated)
              : is_open(name) || !told                            ? name
                                                                  : name + " = " + in_unit(value, unit);
      if (angle) return add_angle(figure_, {name, text_, value.number});
      if (!between_points(name, value) && !of_shapes(name, value.number) && !of_wheels(name, value.number))
        of_edges(name, value);
    } catch (const StatementError&) {
      // What has no value yet has no place in the figure.
    }
  }
  // Where friction acts: at a surface that is or will be touched, in a joint, on what a cord is led over.
  std::optional<scene::Place> place_of_friction(const Contact& contact) {
    const scene::Scene& scene = figure_.scene();
    if (contact.on_cord) {
      for (const SceneWheel& wheel : wheels_of(figure_)) {
        const int tree_body = machine_body(contact.against);
        if (tree_body == ground ? wheel.body != scene::ground : wheel.body != figure_.scene_body(tree_body)) continue;
        if (tree_body == ground &&
            norm(Vector3<double>(wheel.center - figure_.data().place(built(Name{contact.against}, Mark{})))) >
                1e-6 * wheel.radius)
          continue;
        return wheel.body == scene::ground ? scene::Place{scene::ground, wheel.center}
                                           : figure_.riding(tree_body, wheel.center);
      }
      // An eyelet, which has no size.
      const auto is_point = [&](const scene::Point& point) { return point.name == contact.against; };
      const auto eyelet = std::ranges::find_if(scene.points, is_point);
      return eyelet == scene.points.end() ? std::nullopt : std::optional(eyelet->place);
    }
    const std::string& named =
        contact.in_joint ? rubbing_joint(figure_.situation().joints, contact.name).joint.name : contact.name;
    const auto symbol = std::ranges::find(scene.symbols, named, &scene::Symbol::name);
    if (symbol != scene.symbols.end()) return symbol->place;
    for (const scene::Curve& curve : scene.curves)
      if (curve.kind == scene::CurveKind::surface && curve.name == contact.name)
        return scene::Place{curve.body, curve.points.front()};
    return std::nullopt;
  }
  int machine_body(const std::string& name) const {
    const auto found = figure_.machine().index.find(name);
    return found == figure_.machine().index.end() ? ground : found->second;
  }
  // The coefficients of friction, or of a joint its couple or force.
  void add_friction() {
    for (const Gear& gear : figure_.situation().gears) {
      if (!gear.friction) continue;
      text_ = coefficient_text(*gear.friction, "mu");
      const auto mesh = std::ranges::find(figure_.machine().tooth_meshes, gear.name, &ToothMeshOf<double>::name);
      if (mesh == figure_.machine().tooth_meshes.end()) continue;
      const scene::Place at = figure_.scene_place(mesh->at);
      put(to_string(*gear.friction), at, at);
    }
    for (const Contact& contact : figure_.situation().contacts) {
      if (!contact.friction) continue;
      const std::optional<scene::Place> place = place_of_friction(contact);
      if (!place) continue;
      std::string name;
      if (contact.in_joint && !contact.friction->bearing) {
        name = to_string(contact.friction->resting);
        text_ = effort_text(contact.friction->resting);
        put(name, *place, *place);
        continue;
      }
      text_.clear();
      for (const Expression* coefficient : {&contact.friction->resting, &contact.friction->sliding}) {
        if (coefficient == &contact.friction->sliding && !contact.friction->falls()) continue;
        const std::string letter = !contact.friction->falls()                  ? "mu"
                                   : coefficient == &contact.friction->resting ? "mu_s"
                                                                               : "mu_k";
        name += (name.empty() ? "" : ", ") + to_string(*coefficient);
        text_ += (text_.empty() ? "" : ", ") + coefficient_text(*coefficient, letter);
      }
      put(name, *place, *place);
    }
  }
  // A datum with its value, or what stands for one.
  std::string effort_text(const Expression& effort) {
    std::string written = to_string(effort);
    const auto given = std::ranges::find(figure_.situation().given, written, &NamedExpression::name);
    if (given == figure_.situation().given.end()) {
      std::ranges::replace(written, '*', ' ');
      return "friction " + written;
    }
    if (is_open(written)) return written;
    return written + " = " + to_string(given->value);
  }
  // Its value behind the letter that everybody writes for it; of what is to be found, of letters and of formulas what
  // the file has.
  std::string coefficient_text(const Expression& coefficient, const std::string& symbol) {
    const std::string written = to_string(coefficient);
    const auto& find = figure_.situation().find;
    const bool as_written = coefficient.as<Name>() == nullptr || is_open(written) ||
                            std::ranges::any_of(find, [&](const Unknown& unknown) { return unknown.name == written; });
    // A datum that is called so keeps its own index.
    const bool is_mu = coefficient.as<Name>() && (written == "mu" ? symbol == "mu" : is_indexed_coefficient(written));
    if (as_written) return is_mu || written == symbol ? written : symbol + " = " + written;
    try {
      constexpr int digits = 5;
      return (is_mu ? written : symbol) + " = " +
             with_digits(figure_.data().number(coefficient, dimensions::none), digits);
    } catch (const StatementError&) {
      return symbol + " = " + written;
    }
  }

  // What texts write where there are several coefficients of friction.
  static bool is_indexed_coefficient(const std::string& name) {
    static const std::set<std::string> names{"mu0",  "mu1",  "mu2",  "mu3",  "mu4",  "mu_0", "mu_1", "mu_2", "mu_3",
                                             "mu_4", "mu_s", "mu_k", "mu_A", "mu_B", "mu_C", "mu_D", "mus",  "muk"};
    return names.contains(name);
  }
  bool is_open(const std::string& name) const {
    return std::any_of(figure_.scene().drawn_letters.begin(), figure_.scene().drawn_letters.end(),
                       [&](const scene::DrawnLetter& letter) { return letter.name == name; });
  }
  std::string in_unit(const Value<double>& value, const Unit* stated) const {
    const Unit& unit = stated ? *stated : figure_.tex().unit(value.dimension);
    constexpr int digits = 5;
    return with_digits(value.number / unit.factor, digits) + " " + unit.text;
  }

  void put(const std::string& name, const scene::Place& from, const scene::Place& to,
           const Vector3<double>& axis = {}) {
    scene::Dimension dimension;
    dimension.name = name;
    dimension.text = text_;
    dimension.from = from;
    dimension.to = to;
    dimension.axis = axis;
    figure_.scene().dimensions.push_back(std::move(dimension));
  }

  // The two points, nearest to each other across it, that lie apart by the datum along an axis of the figure.
  bool between_points(const std::string& name, const Value<double>& value) {
    DataScope<Dual<1>> data(figure_.situation(), figure_.data().settings());
    data.vary(name, as_variable(value));
    std::vector<std::pair<const scene::Point*, Vector3<Dual<1>>>> points;
    for (const scene::Point& point : figure_.scene().points) {
      if (points.size() >= most_points) break;
      points.emplace_back(&point, data.place(built(Name{point.name}, Mark{})));
    }
    const scene::Point origin{"", {}};
    points.emplace_back(&origin, Vector3<Dual<1>>::zero());
    constexpr double exact = 1e-9;
    double nearest = exact * value.number;
    const scene::Point *from = nullptr, *to = nullptr;
    bool better = false;
    for (std::size_t i = 0; i < points.size() && !better; ++i)
      for (std::size_t j = i + 1; j < points.size() && !better; ++j)
        for (std::size_t k = 0; k < 3; ++k) {
          const Vector3<Dual<1>> d = points[j].second - points[i].second;
          const double sense = d[k].value < 0 ? -1 : 1;
          if (std::abs(sense * d[k].value - value.number) > exact * value.number) continue;
          if (std::abs(sense * d[k].partial[0] - 1) > exact) continue;
          const double across = std::hypot(d[(k + 1) % 3].value, d[(k + 2) % 3].value);
          if (across > nearest) continue;
          from = points[i].first;
          to = points[j].first;
          better = true;
        }
    if (from == nullptr) return false;
    put(name, from->place, to->place);
    return true;
  }

  // A radius or a length that a shape names.
  bool of_shapes(const std::string& name, double value) {
    for (std::size_t k = 0; k < figure_.situation().bodies.size(); ++k)
      for (const Part& part : figure_.situation().bodies[k].parts)
        for (const NamedExpression& argument : part.shape.arguments) {
          const Name* datum = argument.value.as<Name>();
          if (datum == nullptr || datum->name != name) continue;
          if (of_shape(name, value, part.shape, argument.name, static_cast<int>(k))) return true;
        }
    return false;
  }
  bool of_shape(const std::string& name, double value, const Shape& shape, const std::string& argument, int body) {
    const auto has = [&](const char* other) {
      return std::any_of(shape.arguments.begin(), shape.arguments.end(),
                         [&](const NamedExpression& one) { return one.name == other; });
    };
    const std::string& file = figure_.situation().file;
    if (!has("center")) return false;
    const Vector3<double> center = figure_.data().place(shape_argument(shape, "center", file));
    Vector3<double> axis{0, 0, 1};
    for (const char* given : {"normal", "axis"})
      if (has(given)) axis = figure_.data().direction(shape_argument(shape, given, file));
    if ((argument == "radius" || argument == "inner_radius") && has("middle") && has("angle")) {
      // Of a part of a disk or ring the radii are drawn where it is, the two apart.
      constexpr double aside = 0.6;
      const Value<double> toward = figure_.data().value(shape_argument(shape, "middle", file));
      const double turn = (argument == "radius" ? aside : -aside) / 2 *
                          figure_.data().number(shape_argument(shape, "angle", file), dimensions::angle);
      Vector3<double> middle = toward.dimension == dimensions::length ? toward.vector - center : toward.vector;
      middle = normalized(Vector3<double>(middle - dot(middle, axis) * axis));
      put(name, {body, center},
          {body, center + value * (std::cos(turn) * middle + std::sin(turn) * cross(axis, middle))});
      return true;
    }
    if (argument == "radius" || argument == "inner_radius") {
      // Of a sphere the horizontal radii: one of them is seen at its length.
      if (shape.kind == "sphere") {
        const scene::Scene& scene = figure_.scene();
        axis = transpose_times(scene.bodies[static_cast<std::size_t>(body)].pose.R, scene.up);
      }
      const bool any_direction = shape.kind != "hemisphere";
      put(name, {body, center}, {body, center + value * cubature::Triad<double>(axis).first},
          any_direction ? axis : Vector3<double>{});
    } else if (argument == "length") {
      put(name, {body, center - 0.5 * value * axis}, {body, center + 0.5 * value * axis});
    } else {
      return false;
    }
    return true;
  }

  // The radius of what a cord or belt is led over.
  bool of_wheels(const std::string& name, double value) {
    const auto names_it = [&](const CordWheel& wheel) {
      const Name* datum = wheel.radius ? wheel.radius->as<Name>() : nullptr;
      return datum != nullptr && datum->name == name;
    };
    const Situation& situation = figure_.situation();
    const bool named =
        std::ranges::any_of(situation.belts,
                            [&](const Belt& belt) { return std::ranges::any_of(belt.over, names_it); }) ||
        std::ranges::any_of(situation.cords, [&](const Cord& cord) {
          return std::ranges::any_of(cord.over, names_it) || (cord.off_from && names_it(*cord.off_from)) ||
                 (cord.on_to && names_it(*cord.on_to));
        });
    if (!named) return false;
    for (const SceneWheel& wheel : wheels_of(figure_)) {
      constexpr double exact = 1e-9;
      if (std::abs(wheel.radius - value) > exact * value) continue;
      const int tree_body = wheel.body == scene::ground ? ground : figure_.tree_body(wheel.body);
      const scene::Place center = figure_.riding(tree_body, wheel.center);
      const scene::Place rim =
          figure_.riding(tree_body, wheel.center + value * cubature::Triad<double>(wheel.axis).first);
      Vector3<double> axis = wheel.axis;
      if (wheel.body != scene::ground)
        axis = transpose_times(figure_.scene().bodies[static_cast<std::size_t>(wheel.body)].pose.R, wheel.axis);
      put(name, center, rim, axis);
      return true;
    }
    return false;
  }

  // A straight edge of a shape that is as long as the datum says, or twice as long, and grows as it does.
  void of_edges(const std::string& name, const Value<double>& value) {
    constexpr double growth = 1e-4;
    Settings grown = figure_.data().settings();
    Value<double> more = value;
    more.number *= 1 + growth;
    grown[name] = more;
    DataScope<double> data(figure_.situation(), grown);
    for (const double times : {1.0, 2.0})
      for (std::size_t k = 0; k < figure_.situation().bodies.size(); ++k) {
        const Body& body = figure_.situation().bodies[k];
        for (const Part& part : body.parts) {
          if (part.shape.kind == "mesh") continue;
          if (of_edges(name, times * value.number, growth, times == 2, static_cast<int>(k),
                       shape_picture(part.shape, figure_.data(), body.name),
                       shape_picture(part.shape, data, body.name)))
            return;
        }
      }
  }
  // Whether one end of an edge is nearer than the other to a named point, or of ends alike the lower one.
  bool stands_nearer(int body, const Vector3<double>& one, const Vector3<double>& other) const {
    const auto distance = [&](const Vector3<double>& end) {
      double least = 1e300;
      for (const scene::Point& point : figure_.scene().points)
        least = std::min(least, norm(Vector3<double>(figure_.on_ground(point.place) - figure_.on_ground({body, end}))));
      return least;
    };
    const double a = distance(one), b = distance(other);
    constexpr double alike = 1e-9;
    if (std::abs(a - b) > alike * (a + b)) return a < b;
    const Vector3<double> apart = figure_.on_ground({body, one}) - figure_.on_ground({body, other});
    return dot(apart, figure_.scene().up) < -alike * norm(apart);
  }
  // here, there: the shape as it is, and with the grown datum.
  bool of_edges(const std::string& name, double told, double growth, bool half, int body, const Outline& here,
                const Outline& there) {
    constexpr double exact = 1e-9, alike = 1e-6;
    if (here.vertices.size() != there.vertices.size()) return false;
    for (const auto& edge : here.edges)
      for (std::size_t i = 0; i + 1 < edge.size(); ++i) {
        const auto length = [&](const Outline& outline) {
          return norm(Vector3<double>(outline.vertices[edge[i + 1]] - outline.vertices[edge[i]]));
        };
        const double now = length(here), then = length(there);
        if (std::abs(now - told) > exact * told) continue;
        if (std::abs(then - now - growth * told) > alike * growth * told) continue;
        Vector3<double> from = here.vertices[edge[i]], to = here.vertices[edge[i + 1]];
        // Of two halves the one at whose end more is named, or which stands on the ground.
        if (half && stands_nearer(body, from, to)) std::swap(from, to);
        put(name, {body, half ? Vector3<double>(0.5 * (from + to)) : from}, {body, to});
        return true;
      }
    return false;
  }

  static constexpr std::size_t most_points = 60;  // pairs of them are looked at
  SceneFigure& figure_;
  std::string text_;
};

}  // namespace

void add_dimensions(SceneFigure& figure) { Dimensions(figure).add(); }

}  // namespace poinsot::problem
