// What holds the bodies of a figure: joints, supports, contacts, cords, springs.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <type_traits>
#include <utility>

#include "problem/keys/joint_kinds.h"
#include "problem/language/diagnostic.h"
#include "problem/scene/scene_figure.h"
#include "problem/scene/scene_wheels.h"
#include "problem/scene/scene_words.h"

namespace poinsot::problem {
namespace {

using scene::SymbolKind;

// The symbols by the names that the language gives to kinds; the ball of a joint is another one than that of a support.
SymbolKind joint_symbol(const JointKind& kind) { return kind_of_word<SymbolKind>(kind.name).value(); }
SymbolKind support_symbol(const SupportKind* kind) {
  if (kind == nullptr) return SymbolKind::listed_support;
  return kind->name == "ball" ? SymbolKind::ball_support : kind_of_word<SymbolKind>(kind->name).value();
}

// Whether a joint's axis is named by two points at both of which it holds its body: the place that is told for it is
// between them, or none is.
bool is_held_at_both(const Joint& joint, const Vector3<double>& from, const Vector3<double>& to,
                     const std::optional<Vector3<double>>& at) {
  if (joint.kind->name != "revolute") return false;
  if (!at) return true;
  const Vector3<double> d = to - from, arm = *at - from;
  constexpr double exact = 1e-9;
  const double part = dot(arm, d) / norm_squared(d);
  return joint.from == "ground" && part > exact && part < 1 - exact &&
         norm(Vector3<double>(arm - part * d)) < exact * norm(d);
}

}  // namespace

void SceneFigure::add_symbols() {
  for (const Joint& joint : situation_.joints) {
    const JointPlace& place = machine_.joints.at(joint.name);
    scene::Symbol symbol;
    symbol.kind = joint_symbol(*joint.kind);
    symbol.name = joint.name;
    symbol.from = scene_body(place.from);
    symbol.to = scene_body(place.to);
    symbol.place = scene_place(place.at);
    // As drawn, the axes of all bodies are those of the ground.
    if (joint.kind->given == JointGiven::two_axes) {
      const List* axes = joint.place.as<List>();
      symbol.axis = data_.direction(axes->items[0]);
      symbol.second_axis = data_.direction(axes->items[1]);
    } else if (place.axis) {
      symbol.axis = place.axis->vector;
    }
    if (!joint.supports_stated) {
      if (const Arrow* axis = joint.place.as<Arrow>()) {
        const Vector3<double> from = data_.place(axis->from), to = data_.place(axis->to);
        std::optional<Vector3<double>> at;
        if (joint.at) at = data_.place(*joint.at);
        if (is_held_at_both(joint, from, to, at)) {
          for (const Vector3<double>& end : {from, to}) {
            symbol.place = scene_place(machine_.place(place.to, end));
            scene_.symbols.push_back(symbol);
          }
          continue;
        }
      }
      scene_.symbols.push_back(symbol);
      continue;
    }
    for (const Support& support : joint.supports) {
      symbol.kind = support_symbol(support.kind);
      symbol.name = support.name;
      symbol.place = scene_place(machine_.place(place.to, data_.place(*support.at)));
      scene_.symbols.push_back(symbol);
    }
  }
  // Where bodies touch. The normal is on the axes of what they touch.
  const auto add_touching = [&](SymbolKind kind, const auto& touching, const auto& normal) {
    scene::Symbol symbol;
    symbol.kind = kind;
    symbol.name = touching.name;
    const int of = machine_.index.at(touching.of), against = machine_.index.at(touching.against);
    symbol.from = scene_body(against);
    symbol.to = scene_body(of);
    symbol.place = scene_place(machine_.place(of, data_.place(touching.at)));
    symbol.axis = transpose_times(pose_of(of, state_).R, state_.on_ground_axes(against, data_.direction(normal)));
    scene_.symbols.push_back(symbol);
  };
  for (const Contact& contact : situation_.contacts)
    if (!contact.open && contact.touches())
      add_touching(contact.no_slip || contact.grip == Grip::sticks ? SymbolKind::rolling_contact : SymbolKind::contact,
                   contact, contact.normal);
  // A floor or wall that is met later stands where it will be met.
  for (const Contact& contact : situation_.contacts) {
    if (!contact.open || !contact.touches() || machine_.index.at(contact.against) != ground) continue;
    const Vector3<double> place = data_.place(contact.surface ? *contact.surface : contact.at);
    scene::Symbol symbol;
    symbol.kind = SymbolKind::contact;
    symbol.name = contact.name;
    symbol.from = symbol.to = scene::ground;
    symbol.place = {scene::ground, place};
    symbol.axis = data_.direction(contact.normal);
    scene_.symbols.push_back(std::move(symbol));
  }
  for (const Impact& impact : situation_.impacts) add_touching(SymbolKind::contact, impact, impact.pushes);
}

void SceneFigure::stand_hinges_at_bodies() {
  constexpr double much_nearer = 0.6;
  for (scene::Symbol& symbol : scene_.symbols) {
    if (symbol.kind != SymbolKind::revolute || symbol.from < 0 || symbol.to < 0) continue;
    const Vector3<double> at = on_ground(symbol.place);
    const Vector3<double> axis =
        normalized(Vector3<double>(scene_.bodies[static_cast<std::size_t>(symbol.to)].pose.R * symbol.axis));
    double along = 0;
    bool nearer = true;
    for (const int body : {symbol.from, symbol.to}) {
      const scene::Body& own = scene_.bodies[static_cast<std::size_t>(body)];
      const Vector3<double> arm = on_ground({body, own.center}) - at;
      const double own_along = dot(arm, axis);
      nearer = nearer && !own.frame && !own.massless && own.shapes.empty() &&
               norm(Vector3<double>(arm - own_along * axis)) < much_nearer * norm(arm);
      along += 0.5 * own_along;
    }
    if (nearer) symbol.place.at += along * normalized(symbol.axis);
  }
}

namespace {

// Where along its axis the carrier of a slide is met, so that the spring of the joint runs from there: its center, or
// where it is held itself. Nothing if it is met nowhere but at the slide.
std::optional<Vector3<double>> met_on_axis(const SceneFigure& figure, int carrier, const Vector3<double>& at,
                                           const Vector3<double>& way) {
  const scene::Scene& scene = figure.scene();
  if (carrier < 0) return std::nullopt;
  std::optional<Vector3<double>> nearest;
  constexpr double aside = 1e-6, apart = 0.05;  // of the figure
  const auto offer = [&](const Vector3<double>& place) {
    const Vector3<double> d = place - at;
    if (norm(d) < apart * scene.length || norm(Vector3<double>(cross(d, way))) > aside * scene.length * norm(way))
      return;
    if (!nearest || norm(d) < norm(Vector3<double>(*nearest - at))) nearest = place;
  };
  const scene::Body& own = scene.bodies[static_cast<std::size_t>(carrier)];
  if (!own.massless && !own.frame) offer(figure.on_ground({carrier, own.center}));
  for (const scene::Symbol& symbol : scene.symbols)
    if (symbol.to == carrier || symbol.from == carrier) offer(figure.on_ground(symbol.place));
  return nearest;
}

}  // namespace

void SceneFigure::add_joint_springs() {
  constexpr double part = 0.25;  // of the figure: how far from what slides its spring is held
  for (const Joint& joint : situation_.joints) {
    if (joint.freedoms.size() != 1) continue;
    const Freedom& freedom = joint.freedoms.front();
    const JointPlace& place = machine_.joints.at(joint.name);
    scene::Link link;
    link.name = joint.name;
    link.to = scene_place(place.at);
    if (freedom.turning) {
      if (!freedom.stiffness) continue;
      link.kind = scene::LinkKind::torsion;
      link.from = link.to;
      scene_.links.push_back(link);
      continue;
    }
    if (!place.axis || link.to.body == scene::ground) continue;
    const Vector3<double> at = on_ground(link.to);
    const Vector3<double> way =
        part * scene_.length *
        normalized(Vector3<double>(scene_.bodies[static_cast<std::size_t>(link.to.body)].pose.R * place.axis->vector));
    const auto add = [&](scene::LinkKind kind, const Vector3<double>& end) {
      link.kind = kind;
      link.from = riding(place.from, end);
      scene_.links.push_back(link);
    };
    const std::optional<Vector3<double>> met = met_on_axis(*this, scene_body(place.from), at, way);
    if (freedom.stiffness) add(scene::LinkKind::spring, met.value_or(at - way));
    if (freedom.damping) add(scene::LinkKind::damper, met.value_or(at + way));
  }
}

void SceneFigure::add_pitch_circles() {
  // A wheel that meets several others has one circle.
  const auto is_drawn = [&](int body, const Vector3<double>& center, double radius) {
    constexpr double alike = 1e-6;
    return std::ranges::any_of(scene_.curves, [&](const scene::Curve& curve) {
      if (curve.kind != scene::CurveKind::pitch_circle || curve.body != scene_body(body)) return false;
      Vector3<double> middle{};
      for (const Vector3<double>& point : curve.points) middle += point / static_cast<double>(curve.points.size());
      return norm(middle - center) <= alike * radius &&
             std::abs(norm(curve.points.front() - middle) - radius) <= alike * radius;
    });
  };
  for (const ToothMeshOf<double>& mesh : machine_.tooth_meshes) {
    const Gear& gear = *std::ranges::find(situation_.gears, mesh.name, &Gear::name);
    const Vector3<double> P = state_.position(mesh.at);
    for (const auto& [side, body] :
         {std::pair{&mesh.of, machine_.index.at(gear.of)}, std::pair{&mesh.against, machine_.index.at(gear.against)}}) {
      const double radius = norm(side->arm);
      if (radius == 0) continue;  // a rack
      const Vector3<double> arm = state_.direction({mesh.carrier, side->arm}),
                            round = radius * state_.direction({mesh.carrier, side->tangential});
      scene::Curve circle{scene::CurveKind::pitch_circle, mesh.name, scene_body(body), true, {}};
      constexpr int count = 72;
      for (int i = 0; i < count; ++i) {
        const double angle = 2 * std::numbers::pi * i / count;
        circle.points.push_back(riding(body, P - arm + std::cos(angle) * arm + std::sin(angle) * round).at);
      }
      if (!is_drawn(body, riding(body, P - arm).at, radius)) scene_.curves.push_back(std::move(circle));
    }
  }
}

void SceneFigure::add_links() {
  const auto add_parts = [&](const std::string& name) {
    for (const Component<double>* part : straight_parts(machine_.mechanism, name)) {
      scene::Link link;
      link.name = name;
      link.from = scene_place(part->at);
      link.to = scene_place(*part->toward);
      scene_.links.push_back(std::move(link));
    }
  };
  for (const Cord& cord : situation_.cords) {
    if (cord.is_led()) {
      add_parts(cord.name);
      continue;
    }
    scene::Link link;
    link.kind = scene::LinkKind::cord;
    link.name = cord.name;
    const Place<double> end = machine_.place(machine_.index.at(cord.to), data_.place(*cord.end));
    link.from = scene_place(end);
    if (cord.direction) {
      link.far = true;
      link.to = {scene::ground, state_.position(end) + data_.direction(*cord.direction)};
    } else {
      link.to = scene_place(machine_.place(machine_.index.at(cord.from), data_.place(*cord.at)));
    }
    // As long as it is slack it exerts no force.
    const Mechanism<double>& mechanism = machine_.mechanism;
    link.slack = std::ranges::none_of(mechanism.components, [&](const Component<double>& component) {
      const Action& action = mechanism.actions[static_cast<std::size_t>(component.action)];
      return action.kind == ActionKind::cord && action.name == cord.name;
    });
    scene_.links.push_back(link);
  }
  for (const Belt& belt : situation_.belts) add_parts(belt.name);
  add_pitch_circles();
  for_each_stated_law(situation_, []<class Law>(const Law&) {
    static_assert(std::is_same_v<Law, Spring> || std::is_same_v<Law, Load>,
                  "add below what is drawn of the law, if it is, and to scene_points.cpp the points at its ends");
  });
  for (const Spring& spring : situation_.springs) {
    scene::Link link;
    link.name = spring.name;
    const int to = machine_.index.at(spring.to), from = machine_.index.at(spring.from);
    if (spring.about) {
      link.kind = scene::LinkKind::torsion;
      // It has no place of its own: it is drawn where the two bodies are held together.
      scene::Place place = scene_place({to, Vector3<double>::zero()});
      for (const auto& [name, joint] : machine_.joints)
        if ((joint.to == to && joint.from == from) || (joint.to == from && joint.from == to))
          place = scene_place(joint.at);
      link.from = link.to = place;
    } else {
      link.kind = spring.stiffness ? scene::LinkKind::spring : scene::LinkKind::damper;
      link.from = scene_place(machine_.place(from, data_.place(*spring.at)));
      link.to = scene_place(machine_.place(to, data_.place(*spring.end)));
    }
    scene_.links.push_back(link);
  }
}

}  // namespace poinsot::problem
