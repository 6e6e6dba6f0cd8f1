#include "problem/scene/scene_points.h"

#include <algorithm>
#include <set>
#include <string>

#include "problem/language/expression_walk.h"

namespace poinsot::problem {
namespace {

// The names that an expression uses, also through the points that it names.
std::set<std::string> names_behind(const Expression& expression, const Situation& situation) {
  std::set<std::string> found, open;
  collect_names(expression, open);
  while (!open.empty()) {
    const std::string name = *open.begin();
    open.erase(open.begin());
    if (!found.insert(name).second) continue;
    for (const NamedExpression& point : situation.points)
      if (point.name == name) collect_names(point.value, open);
  }
  return found;
}

class PointBodies {
 public:
  explicit PointBodies(const Situation& situation) : situation_(situation) {
    // What names a point itself comes before what uses it for other points.
    for (const bool through_points : {false, true}) {
      for (const Body& body : situation.bodies) {
        for (const Part& part : body.parts) of_shape(part, body.name, through_points);
        if (body.center) of(*body.center, body.name, through_points);
        for (const Part& part : body.added) of_shape(part, body.name, through_points);
      }
      const auto at = [&](const std::optional<Expression>& place, const std::string& body) {
        if (place) of(*place, body, through_points);
      };
      for (const Load& load : situation.loads) at(load.at, load.body);
      for (const Impulse& impulse : situation.impulses) at(impulse.at, impulse.body);
      for (const Strike& strike : situation.strikes) at(strike.at, strike.hits);
      for (const Joint& joint : situation.joints) {
        at(joint.place, joint.to);
        at(joint.at, joint.to);
        for (const Support& support : joint.supports) at(support.at, joint.to);
      }
      for (const Contact& contact : situation.contacts)
        if (contact.touches()) at(contact.at, contact.of);
      for (const Cord& cord : situation.cords) {
        at(cord.end, cord.to);
        at(cord.at, cord.from);
      }
      for (const Spring& spring : situation.springs) {
        at(spring.end, spring.to);
        at(spring.at, spring.from);
      }
    }
  }

  std::string body_of(const std::string& point) const {
    const auto found = bodies_.find(point);
    return found == bodies_.end() ? "ground" : found->second;
  }

 private:
  void of_shape(const Part& part, const std::string& body, bool through_points) {
    for (const NamedExpression& argument : part.shape.arguments) of(argument.value, body, through_points);
  }
  void of(const Expression& place, const std::string& body, bool through_points) {
    std::set<std::string> names;
    if (through_points)
      names = names_behind(place, situation_);
    else
      collect_names(place, names);
    for (const std::string& name : names) bodies_.try_emplace(name, body);
  }

  const Situation& situation_;
  std::map<std::string, std::string> bodies_;
};

// The points that questions, claims and facts name.
std::set<std::string> asked_points(const SceneFigure& figure, const Statement& statement) {
  std::set<std::string> names;
  const Situation& situation = figure.situation();
  for (const Ask& ask : statement.asks)
    for (const Expression& of : ask.of) collect_names(of, names);
  for (const Claim& claim : statement.claims)
    if (claim.situation.empty() || claim.situation == situation.name)
      for (const Expression& of : claim.of) collect_names(of, names);
  for (const Instant& instant : situation.instants)
    for (const Fact& fact : instant.facts) collect_names(fact.quantity, names);
  return names;
}

}  // namespace

void SceneFigure::add_points() {
  const PointBodies bodies(situation_);
  for (const NamedExpression& point : situation_.points) {
    try {
      const Vector3<double> drawn = data_.place(point.value);
      const int body = machine_.index.at(bodies.body_of(point.name));
      scene_.points.push_back({point.name, scene_place(machine_.place(body, drawn))});
    } catch (const StatementError&) {
      scene_.notes.push_back("the point '" + point.name + "' has no place yet");
    }
  }
}

void leave_out_idle_points(SceneFigure& figure, const Statement& statement) {
  const std::set<std::string> asked = asked_points(figure, statement);
  const scene::Scene& scene = figure.scene();
  std::vector<Vector3<double>> held;
  for (const scene::Symbol& symbol : scene.symbols) held.push_back(figure.on_ground(symbol.place));
  for (const scene::Link& link : scene.links)
    for (const scene::Place& place : {link.from, link.to}) held.push_back(figure.on_ground(place));
  for (const scene::Diagram& diagram : scene.diagrams)
    for (const scene::Arrow& arrow : diagram.arrows) held.push_back(figure.on_ground(arrow.at));
  for (const scene::Dimension& dimension : scene.dimensions)
    for (const scene::Place& place : {dimension.from, dimension.to, dimension.corner})
      held.push_back(figure.on_ground(place));
  for (const scene::Body& body : scene.bodies)
    if (!body.frame && !body.massless) held.push_back(body.pose.R * body.center + body.pose.p);
  for (const scene::Curve& curve : scene.curves)
    if (curve.kind == scene::CurveKind::attractor || curve.kind == scene::CurveKind::surface)
      held.push_back(curve.points.front());
  constexpr double same_place = 1e-6;
  std::erase_if(figure.scene().points, [&](const scene::Point& point) {
    if (point.place.body != scene::ground || asked.contains(point.name)) return false;
    return std::none_of(held.begin(), held.end(), [&](const Vector3<double>& place) {
      return norm(Vector3<double>(place - point.place.at)) < same_place * scene.length;
    });
  });
}

}  // namespace poinsot::problem
