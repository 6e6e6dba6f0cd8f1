#include "problem/plane/planar_words.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "problem/language/diagnostic.h"
#include "problem/language/expression_walk.h"

namespace poinsot::problem {
namespace {

using Pointing = PlanarWords::Pointing;

template <std::size_t N>
bool one_of(std::string_view name, const std::array<std::string_view, N>& names) {
  return std::ranges::find(names, name) != names.end();
}

constexpr std::array<std::string_view, 12> in_plane{"position",      "center",   "velocity",         "acceleration",
                                                    "momentum",      "force",    "reaction",         "impulse",
                                                    "slip_velocity", "friction", "tangential_force", "radial_force"};
constexpr std::array<std::string_view, 7> along_normal{"angular_velocity",
                                                       "angular_acceleration",
                                                       "angular_momentum",
                                                       "couple",
                                                       "reaction_couple",
                                                       "impulsive_couple",
                                                       "axis"};
// Functions that take vectors as they are.
constexpr std::array<std::string_view, 10> of_vectors{"cross", "dot",       "norm", "unit",        "direction",
                                                      "angle", "component", "rate", "acute_angle", "distance"};
// Quantities that say something of directions across the plane.
constexpr std::array<std::string_view, 18> spatial{
    "moments_of_inertia", "products_of_inertia", "inertia_matrix",    "principal_moments",
    "principal_axes",     "direction_angles",    "symmetry_axis",     "precession_axis",
    "precession_rate",    "precession_sense",    "spin_rate",         "body_cone",
    "space_cone",         "invariable_plane",    "poinsot_ellipsoid", "polhode",
    "axis_stability",     "axial_force"};

constexpr int deepest = 200;  // names under define: that stand behind each other

Pointing joined(Pointing one, Pointing other) { return one == Pointing::none ? other : one; }

}  // namespace

std::array<std::size_t, 2> component_axes(const MotionPlane& plane) {
  return {std::min(plane.first, plane.second), std::max(plane.first, plane.second)};
}

std::vector<std::size_t> sought_components(const Unknown& unknown, const std::optional<MotionPlane>& plane) {
  if (!unknown.vector) return {0};
  if (!plane) return {0, 1, 2};
  const auto [first, second] = component_axes(*plane);
  return {first, second};
}

Pointing PlanarWords::of_name(const Name& name, int depth) const {
  for (std::size_t k = 0; k < 3; ++k)
    if (situation_.axes[k] == name.name) return k == plane_.normal() ? Pointing::normal : Pointing::in_plane;
  const auto named = [&](const std::vector<NamedExpression>& list) {
    return std::ranges::find(list, name.name, &NamedExpression::name);
  };
  if (named(situation_.points) != situation_.points.end()) return Pointing::in_plane;
  if (const auto found = named(situation_.directions); found != situation_.directions.end()) {
    const Pointing of_value = pointing(found->value, depth + 1);
    return of_value == Pointing::none ? Pointing::in_plane : of_value;
  }
  if (const auto found = std::ranges::find(situation_.find, name.name, &Unknown::name); found != situation_.find.end())
    return found->vector ? Pointing::in_plane : Pointing::none;
  for (const auto* list : {&situation_.define, &situation_.given})
    if (const auto found = named(*list); found != list->end()) return pointing(found->value, depth + 1);
  return Pointing::none;
}

Pointing PlanarWords::of_call(const Call& call, int depth) const {
  const std::string_view f = call.function;
  if (call.arguments.empty()) return Pointing::none;
  const Expression& first = call.arguments.front().value;
  // Of a joint that turns, or of a freedom that does, it is a couple.
  if (f == "friction") {
    const Of* freedom = first.as<Of>();
    const Name* name = (freedom ? freedom->body : first).as<Name>();
    for (const Joint& joint : situation_.joints) {
      if (!name || joint.name != name->name) continue;
      if (!freedom && (joint.freedoms.empty() || joint.freedoms.front().turning)) return Pointing::normal;
      for (const Freedom& one : joint.freedoms)
        if (freedom && one.turning && to_string(freedom->point) == one.name) return Pointing::normal;
    }
  }
  if (one_of(f, in_plane)) return Pointing::in_plane;
  if (one_of(f, along_normal)) {
    if (f != "axis") return Pointing::normal;
    const Name* name = first.as<Name>();
    for (const Joint& joint : situation_.joints)
      if (name && joint.name == name->name) return pointing(joint.place, depth + 1);
    return Pointing::none;
  }
  if (f == "rate" || f == "unit" || f == "direction") return pointing(first, depth + 1);
  if (f == "cross") {
    const Expression* with = call.argument("with");
    if (!with) return Pointing::none;
    return pointing(first, depth + 1) == pointing(*with, depth + 1) ? Pointing::normal : Pointing::in_plane;
  }
  if (f == "load") {
    const Name* name = first.as<Name>();
    for (const Load& load : situation_.loads)
      if (name && load.name == name->name) return load.couple ? Pointing::normal : Pointing::in_plane;
  }
  if (f == "drive") {
    const Of* freedom = first.as<Of>();
    const Name* name = (freedom ? freedom->body : first).as<Name>();
    for (const Joint& joint : situation_.joints)
      for (const Freedom& one : joint.freedoms)
        if (name && joint.name == name->name && (!freedom || to_string(freedom->point) == one.name))
          return one.turning ? Pointing::normal : Pointing::in_plane;
  }
  return Pointing::none;
}

Pointing PlanarWords::pointing(const Expression& expression, int depth) const {
  if (!expression || depth > deepest) return Pointing::none;
  if (const Name* name = expression.as<Name>()) return of_name(*name, depth);
  if (const Call* call = expression.as<Call>()) return of_call(*call, depth);
  if (const At* at = expression.as<At>()) return pointing(at->expression, depth + 1);
  if (const Unary* unary = expression.as<Unary>()) return pointing(unary->operand, depth + 1);
  if (expression.as<Arrow>() || expression.as<Of>()) return Pointing::in_plane;
  // Two components that were written, completed by the one across the plane.
  if (const List* list = expression.as<List>()) return list->items.size() == 3 ? Pointing::in_plane : Pointing::none;
  if (const Binary* binary = expression.as<Binary>()) {
    if (binary->operation == '^') return Pointing::none;
    const Pointing left = pointing(binary->left, depth + 1);
    return binary->operation == '/' ? left : joined(left, pointing(binary->right, depth + 1));
  }
  return Pointing::none;
}

Expression PlanarWords::normal(const Mark& mark) const {
  const Expression axis = built(Name{situation_.axes[plane_.normal()]}, mark);
  return plane_.sign() > 0 ? axis : built(Unary{'-', axis}, mark);
}

// Of `X @ t` the component of X is taken there.
Expression PlanarWords::component(const Expression& expression, std::size_t axis) const {
  if (const At* at = expression.as<At>()) {
    At of_component = *at;
    of_component.expression = component(at->expression, axis);
    return built(std::move(of_component), expression.mark());
  }
  return built(Member{expression, situation_.axes[axis]}, beginning(expression));
}

Expression PlanarWords::number_along_normal(const Expression& expression) const {
  const Expression number = component(expression, plane_.normal());
  return plane_.sign() > 0 ? number : built(Unary{'-', number}, expression.mark());
}

Expression PlanarWords::as_vector(const Expression& list, const Expression& across) const {
  const List* items = list.as<List>();
  if (!items || items->items.size() != 2) return list;
  List three = *items;
  three.items.insert(three.items.begin() + static_cast<std::ptrdiff_t>(plane_.normal()), across);
  return built(std::move(three), list.mark());
}

std::vector<Expression> PlanarWords::components(const Expression& expression) const {
  const auto [first, second] = component_axes(plane_);
  return {component(expression, first), component(expression, second)};
}

void PlanarWords::refuse_across(const Expression& expression, const Call& call) const {
  const std::string axis = situation_.axes[plane_.normal()];
  if (one_of(call.function, spatial))
    fail(situation_.file, expression.mark(), call.function + "() says something of directions across the plane",
         "leave plane: out, or ask moment_of_inertia(B about P), angular_velocity(B), angular_momentum(B about P)");
  if (call.function != "moment_of_inertia" && call.function != "radius_of_gyration") return;
  const Expression* about = call.argument("about");
  if (about && pointing(*about) == Pointing::in_plane && (about->as<Arrow>() || call.argument("at")))
    fail(situation_.file, expression.mark(), "this axis lies in the plane, about which nothing turns",
         "ask for it about " + axis + " at P, or leave plane: out");
}

Expression PlanarWords::call_with_numbers(const Expression& expression, const Call& stated) const {
  Call call = stated;
  refuse_across(expression, call);
  const bool inertia = call.function == "moment_of_inertia" || call.function == "radius_of_gyration";
  if (inertia && call.arguments.size() == 2 && pointing(call.arguments[1].value) == Pointing::in_plane) {
    // About a point is about the normal through it.
    const Expression point = call.arguments[1].value;
    call.arguments[1] = {"about", normal(point.mark())};
    call.arguments.push_back({"at", point});
  }
  for (Argument& argument : call.arguments) {
    argument.value = with_numbers(argument.value);
    const bool vector = one_of(call.function, of_vectors) || one_of(call.function, in_plane) ||
                        one_of(call.function, along_normal) || inertia;
    if (!vector && pointing(argument.value) == Pointing::normal) argument.value = number_along_normal(argument.value);
  }
  return built(std::move(call), expression.mark());
}

Expression PlanarWords::with_numbers(const Expression& expression) const {
  if (!expression) return expression;
  if (const Call* call = expression.as<Call>()) return call_with_numbers(expression, *call);
  if (const Member* member = expression.as<Member>()) {
    const auto axis = std::ranges::find(situation_.axes, member->name);
    const Pointing of = pointing(member->object);
    if (axis != situation_.axes.end() && of != Pointing::none) {
      const bool normal = static_cast<std::size_t>(axis - situation_.axes.begin()) == plane_.normal();
      if (normal != (of == Pointing::normal))
        fail(situation_.file, expression.mark(),
             "the component ." + member->name + " of " + to_string(member->object) +
                 " points across the plane: it is "
                 "zero",
             normal ? "its components are ." + situation_.axes[component_axes(plane_)[0]] + " and ." +
                          situation_.axes[component_axes(plane_)[1]]
                    : "it is a number: write " + to_string(member->object));
    }
    return transformed(expression, [&](const Expression& child) { return with_numbers(child); });
  }
  Expression inside = transformed(expression, [&](const Expression& child) { return with_numbers(child); });
  const auto number = [&](const Expression& one) {
    return pointing(one) == Pointing::normal ? number_along_normal(one) : one;
  };
  if (const Binary* binary = inside.as<Binary>()) {
    Binary changed = *binary;
    const bool left = pointing(changed.left) == Pointing::normal, right = pointing(changed.right) == Pointing::normal;
    const bool sum = changed.operation == '+' || changed.operation == '-';
    // Beside numbers it is a number; the product of two is one of numbers.
    if (sum ? left != right : changed.operation == '^' || (left && right)) {
      changed.left = number(changed.left);
      changed.right = number(changed.right);
    } else if (changed.operation == '/' && right) {
      changed.right = number(changed.right);
    }
    return built(std::move(changed), inside.mark());
  }
  if (const Comparison* comparison = inside.as<Comparison>()) {
    Comparison changed = *comparison;
    for (Expression& operand : changed.operands) {
      const Expression zero = built(Number{0, Unit{}, false, "0"}, operand.mark());
      operand = as_vector(number(operand), zero);
    }
    return built(std::move(changed), inside.mark());
  }
  return inside;
}

Expression PlanarWords::as_number(const Expression& expression) const {
  const Expression inside = with_numbers(expression);
  return pointing(inside) == Pointing::normal ? number_along_normal(inside) : inside;
}

}  // namespace poinsot::problem
