#include "problem/quantities/quantity_functions.h"

#include <algorithm>
#include <array>
#include <set>
#include <string_view>
#include <unordered_map>

#include "problem/language/diagnostic.h"
#include "problem/language/expression_walk.h"

namespace poinsot::problem {

const std::vector<QuantityFunction>& quantity_table() {
  using enum Level;
  using Kind = QuantityKind;
  static const std::vector<QuantityFunction> table{
      {"position", "position(A of plate)", "position", position, Kind::kinematic, {""}},
      {"center", "center(plate)", "mass center", position, Kind::kinematic, {""}},
      {"velocity",
       "velocity(A of plate), velocity(plate) for its mass center",
       "velocity",
       velocity,
       Kind::kinematic,
       {"", "relative to"}},
      {"acceleration",
       "acceleration(A of plate), acceleration(plate) for its mass center",
       "acceleration",
       force,
       Kind::kinematic,
       {"", "relative to"}},
      {"angular_velocity",
       "angular_velocity(disk), angular_velocity(disk relative to arm)",
       "angular velocity",
       velocity,
       Kind::kinematic,
       {"", "relative to"}},
      {"angular_acceleration", "angular_acceleration(disk)", "angular acceleration", force, Kind::kinematic, {""}},
      {"momentum", "momentum(disk)", "linear momentum", velocity, Kind::momentum, {""}},
      {"angular_momentum", "angular_momentum(disk about G)", "angular momentum", velocity, Kind::momentum, {"about"}},
      {"kinetic_energy",
       "kinetic_energy(disk), kinetic_energy(disk about center(disk)) for its rotation",
       "kinetic energy",
       velocity,
       Kind::momentum,
       {"", "about"},
       true},
      {"potential_energy",
       "potential_energy(disk), potential_energy(spring)",
       "potential energy",
       position,
       Kind::momentum,
       {""},
       true},
      {"rate",
       "rate(angular_momentum(disk about G)), rate(X relative to frame)",
       "rate of change",
       force,
       Kind::rate,
       {"", "relative to"}},
      {"mass", "mass(disk)", "mass", position, Kind::momentum, {""}},
      {"weight", "weight(disk)", "weight", position, Kind::momentum, {""}},
      {"moment_of_inertia",
       "moment_of_inertia(plate about A->B), moment_of_inertia(plate about x at A)",
       "moment of inertia",
       position,
       Kind::inertia,
       {"about", "about at"}},
      {"radius_of_gyration",
       "radius_of_gyration(plate about A->B)",
       "radius of gyration",
       position,
       Kind::inertia,
       {"about", "about at"}},
      {"moments_of_inertia",
       "moments_of_inertia(plate about A)",
       "moments of inertia",
       position,
       Kind::inertia,
       {"about"}},
      {"products_of_inertia",
       "products_of_inertia(plate about A)",
       "products of inertia",
       position,
       Kind::inertia,
       {"about"}},
      {"inertia_matrix", "inertia_matrix(plate about A)", "inertia matrix", position, Kind::inertia, {"about"}},
      {"principal_moments",
       "principal_moments(plate about A)",
       "principal moments of inertia",
       position,
       Kind::inertia,
       {"about"}},
      {"principal_axes",
       "principal_axes(plate about A)",
       "principal axes of inertia",
       position,
       Kind::inertia,
       {"about"}},
      {"axis", "axis(hinge)", "axis", position, Kind::geometry, {""}},
      {"distance",
       "distance(A to B), distance(center(wheel) to axis(spindle))",
       "distance",
       position,
       Kind::geometry,
       {"to"}},
      {"direction_angles",
       "direction_angles(angular_momentum(disk about G))",
       "direction angles",
       position,
       Kind::geometry,
       {""}},
      {"force", "force(pin on rod)", "force", force, Kind::force, {"on"}},
      {"tangential_force", "tangential_force(mesh on wheel)", "tangential force", force, Kind::force, {"on"}},
      {"radial_force", "radial_force(mesh on wheel)", "radial force", force, Kind::force, {"on"}},
      {"axial_force", "axial_force(mesh on wheel)", "axial force", force, Kind::force, {"on"}},
      {"couple", "couple(pin on rod about A)", "couple", force, Kind::force, {"on about"}},
      {"reaction", "reaction(A), reaction(A of bearings)", "reaction", force, Kind::force, {"", "of"}},
      {"reaction_couple", "reaction_couple(A)", "reaction couple", force, Kind::force, {"", "of"}},
      {"drive", "drive(shaft), drive(slide of collar)", "drive", force, Kind::force, {""}},
      {"tension",
       "tension(wire), tension(belt from motor to fan)",
       "tension",
       force,
       Kind::force,
       {"", "on", "from to"}},
      {"load", "load(push)", "load", force, Kind::force, {""}},
      {"symmetry_axis", "symmetry_axis(satellite)", "axis of revolution", position, Kind::free_motion, {""}},
      {"precession_axis", "precession_axis(satellite)", "axis of precession", velocity, Kind::free_motion, {""}},
      {"precession_rate", "precession_rate(satellite)", "rate of precession", velocity, Kind::free_motion, {""}},
      {"spin_rate",
       "spin_rate(satellite), spin_rate(satellite about z) for its sense",
       "rate of spin",
       velocity,
       Kind::free_motion,
       {"", "about"}},
      {"precession_sense", "precession_sense(satellite)", "sense of the precession", velocity, Kind::free_motion, {""}},
      {"body_cone", "body_cone(satellite)", "half angle of the body cone", velocity, Kind::free_motion, {""}},
      {"space_cone", "space_cone(satellite)", "half angle of the space cone", velocity, Kind::free_motion, {""}},
      {"invariable_plane",
       "invariable_plane(satellite)",
       "distance of the invariable plane",
       velocity,
       Kind::free_motion,
       {""}},
      {"poinsot_ellipsoid",
       "poinsot_ellipsoid(satellite)",
       "semi-axes of the Poinsot ellipsoid",
       velocity,
       Kind::free_motion,
       {""}},
      {"polhode", "polhode(satellite)", "course of the polhode", velocity, Kind::free_motion, {""}},
      {"axis_stability",
       "axis_stability(satellite)",
       "stability of rotation about the principal axes",
       velocity,
       Kind::free_motion,
       {""}},
      {"period", "period(theta)", "period", motion, Kind::motion_feature, {""}},
      {"end_of_bouncing", "end_of_bouncing(floor)", "end of bouncing", motion, Kind::motion_feature, {""}},
      {"touching", "touching(mesh)", "contact", force, Kind::holding, {""}},
      {"taut", "taut(wire)", "pull", force, Kind::holding, {""}},
      {"sticking", "sticking(floor), sticking(rope on post)", "sticking", force, Kind::friction, {"", "on"}},
      {"sliding", "sliding(floor), sliding(rope on post)", "sliding", force, Kind::friction, {"", "on"}},
      {"parting", "parting(floor)", "parting", force, Kind::friction, {""}},
      {"slip_velocity", "slip_velocity(floor)", "velocity of slipping", velocity, Kind::friction, {""}},
      {"normal_force", "normal_force(floor)", "normal force", force, Kind::friction, {""}},
      {"friction", "friction(floor on crate)", "friction", force, Kind::friction, {"", "on"}},
      {"stable", "stable(plate), stable(system)", "stability", force, Kind::stability, {""}},
      {"stability", "stability(plate), stability(system)", "stability", force, Kind::stability, {""}},
      {"growth_rate",
       "growth_rate(plate), growth_rate(system)",
       "fastest growth of a disturbance",
       force,
       Kind::stability,
       {""}},
      {"frequencies",
       "frequencies(plate), frequencies(system)",
       "frequencies of small oscillations",
       force,
       Kind::stability,
       {""}},
      {"eigenvalues",
       "eigenvalues(plate), eigenvalues(system)",
       "growth rates and frequencies of all modes",
       force,
       Kind::stability,
       {""}},
      {"modes", "modes(plate), modes(system)", "modes", force, Kind::stability, {""}},
      {"response",
       "response(theta to push), response(reaction(A) to push at 30 rad/s)",
       "response",
       force,
       Kind::stability,
       {"to", "to at"}},
      {"impulse", "impulse(A), impulse(stop on plate)", "impulse", velocity, Kind::force, {"", "of", "on"}},
      {"impulsive_couple",
       "impulsive_couple(A), impulsive_couple(hinge on plate about A)",
       "impulsive couple",
       velocity,
       Kind::force,
       {"", "of", "on about"}},
  };
  return table;
}

const QuantityFunction* find_quantity(std::string_view name) {
  static const std::unordered_map<std::string_view, const QuantityFunction*> by_name = [] {
    std::unordered_map<std::string_view, const QuantityFunction*> found;
    for (const QuantityFunction& function : quantity_table()) found.emplace(function.name, &function);
    return found;
  }();
  const auto found = by_name.find(name);
  return found == by_name.end() ? nullptr : found->second;
}

const std::vector<FunctionForm>& quantity_functions() {
  static const std::vector<FunctionForm> forms = [] {
    std::vector<FunctionForm> list;
    for (const QuantityFunction& function : quantity_table()) list.push_back({function.name, function.form});
    return list;
  }();
  return forms;
}

namespace {

// On what an expression depends, also through define:.
struct LevelFinder {
  const Situation& situation;
  bool through_at = false;
  bool through_features = false;  // whether to look at the quantity in min(), max() and period()
  int depth = 0;

  Level of(const Expression& expression) const {
    // A quantity at another instant takes its forces from that instant.
    if (!through_at && expression.as<At>()) return Level::position;
    if (const Name* name = expression.as<Name>()) return of_name(*name);
    Level level = Level::position;
    if (const Call* call = expression.as<Call>()) {
      if (is_motion_feature(*call) && !through_features) return Level::motion;
      if (const QuantityFunction* function = find_quantity(call->function)) level = function->level;
    }
    const LevelFinder below{situation, through_at, through_features, depth + 1};
    for_each_child(expression, [&](const Expression& child) { level = std::max(level, below.of(child)); });
    return level;
  }

  Level of_name(const Name& name) const {
    if (name.primes >= 2) return Level::force;
    // The rate of a defined quantity follows from accelerations.
    const LevelFinder below{situation, through_at, through_features, depth + 1};
    if (depth < 200)
      for (const NamedExpression& item : situation.define)
        if (item.name == name.name) return name.primes > 0 ? Level::force : below.of(item.value);
    return name.primes > 0 ? Level::velocity : Level::position;
  }
};

}  // namespace

Level level_of(const Situation& situation, const Expression& expression, bool through_at) {
  return LevelFinder{situation, through_at}.of(expression);
}

bool asks_stability(const Expression& expression) {
  std::set<std::string> functions;
  collect_functions(expression, functions, true);
  return std::ranges::any_of(functions, [](const std::string& name) {
    const QuantityFunction* function = find_quantity(name);
    return function && function->kind == QuantityKind::stability;
  });
}

bool is_extreme_of_list(const Call& call) {
  if ((call.function != "min" && call.function != "max") || call.arguments.size() != 1) return false;
  Expression of = call.arguments.front().value;
  while (const At* at = of.as<At>()) of = at->expression;
  const Call* list = of.as<Call>();
  constexpr std::array<std::string_view, 4> lists{"frequencies", "principal_moments", "moments_of_inertia",
                                                  "products_of_inertia"};
  return list && std::ranges::find(lists, std::string_view(list->function)) != lists.end();
}

bool asks_forces(const Situation& situation, const Expression& expression) {
  // The stability of a motion follows from accelerations, on which an open share of a load between supports has no
  // influence.
  if (asks_stability(expression)) return false;
  return LevelFinder{situation, true, true}.of(expression) >= Level::force;
}

bool asks_motion_feature(const Expression& expression) {
  const Situation nothing;
  return level_of(nothing, expression, true) == Level::motion;
}

namespace {

void add_motion_features(const Situation& situation, const Expression& expression, std::set<std::string>& names,
                         std::vector<MotionFeatureCall>& found) {
  if (!expression || expression.as<At>()) return;
  if (const Call* call = expression.as<Call>(); call && is_motion_feature(*call)) {
    found.push_back({call, expression.mark()});
    return;
  }
  if (const Name* name = expression.as<Name>(); name && names.insert(name->name).second)
    for (const NamedExpression& item : situation.define)
      if (item.name == name->name) add_motion_features(situation, item.value, names, found);
  for_each_child(expression, [&](const Expression& part) { add_motion_features(situation, part, names, found); });
}

}  // namespace

std::vector<MotionFeatureCall> motion_features_in(const Situation& situation, const Expression& expression) {
  std::set<std::string> names;
  std::vector<MotionFeatureCall> found;
  add_motion_features(situation, expression, names, found);
  return found;
}

Expression with_function(Call call, const Expression& expression, const std::string& function) {
  call.function = function;
  return built(std::move(call), expression.mark());
}

}  // namespace poinsot::problem
