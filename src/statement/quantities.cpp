#include "statement/quantities.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <type_traits>

#include "poinsot/mass/composition.h"
#include "statement/exact_numbers.h"
#include "statement/quantity_values.h"
#include "statement/reader.h"

namespace poinsot::statement {
namespace {

struct QuantityFunction {
  const char* name;
  const char* form;
  Level level;
};

constexpr QuantityFunction functions[] = {
    {"position", "position(A of plate)", Level::position},
    {"center", "center(plate)", Level::position},
    {"velocity", "velocity(A of plate), velocity(plate) for its mass center", Level::velocity},
    {"acceleration", "acceleration(A of plate), acceleration(plate) for its mass center", Level::force},
    {"angular_velocity", "angular_velocity(disk), angular_velocity(disk relative to arm)", Level::velocity},
    {"angular_acceleration", "angular_acceleration(disk)", Level::force},
    {"momentum", "momentum(disk)", Level::velocity},
    {"angular_momentum", "angular_momentum(disk about G)", Level::velocity},
    {"kinetic_energy", "kinetic_energy(disk), kinetic_energy(disk about center(disk)) for its rotation",
     Level::velocity},
    {"potential_energy", "potential_energy(disk)", Level::position},
    {"rate", "rate(angular_momentum(disk about G)), rate(X relative to frame)", Level::force},
    {"mass", "mass(disk)", Level::position},
    {"weight", "weight(disk)", Level::position},
    {"moment_of_inertia", "moment_of_inertia(plate about A->B), moment_of_inertia(plate about x at A)",
     Level::position},
    {"radius_of_gyration", "radius_of_gyration(plate about A->B)", Level::position},
    {"moments_of_inertia", "moments_of_inertia(plate about A)", Level::position},
    {"products_of_inertia", "products_of_inertia(plate about A)", Level::position},
    {"inertia_matrix", "inertia_matrix(plate about A)", Level::position},
    {"principal_moments", "principal_moments(plate about A)", Level::position},
    {"principal_axes", "principal_axes(plate about A)", Level::position},
    {"axis", "axis(hinge)", Level::position},
    {"distance", "distance(A to B), distance(center(wheel) to axis(spindle))", Level::position},
    {"direction_angles", "direction_angles(angular_momentum(disk about G))", Level::position},
    {"force", "force(pin on rod)", Level::force},
    {"couple", "couple(pin on rod about A)", Level::force},
    {"reaction", "reaction(A), reaction(A of bearings)", Level::force},
    {"reaction_couple", "reaction_couple(A)", Level::force},
    {"drive", "drive(shaft), drive(slide of collar)", Level::force},
    {"tension", "tension(wire)", Level::force},
    {"load", "load(push)", Level::force},
    {"symmetry_axis", "symmetry_axis(satellite)", Level::position},
    {"precession_axis", "precession_axis(satellite)", Level::velocity},
    {"precession_rate", "precession_rate(satellite)", Level::velocity},
    {"spin_rate", "spin_rate(satellite), spin_rate(satellite about z) for its sense", Level::velocity},
    {"precession_sense", "precession_sense(satellite)", Level::velocity},
    {"body_cone", "body_cone(satellite)", Level::velocity},
    {"space_cone", "space_cone(satellite)", Level::velocity},
    {"invariable_plane", "invariable_plane(satellite)", Level::velocity},
    {"poinsot_ellipsoid", "poinsot_ellipsoid(satellite)", Level::velocity},
    {"polhode", "polhode(satellite)", Level::velocity},
    {"axis_stability", "axis_stability(satellite)", Level::velocity},
    {"period", "period(theta)", Level::motion},
    {"touching", "touching(mesh)", Level::force},
    {"taut", "taut(wire)", Level::force},
    {"stable", "stable(plate), stable(system)", Level::force},
    {"stability", "stability(plate), stability(system)", Level::force},
    {"growth_rate", "growth_rate(plate), growth_rate(system)", Level::force},
    {"frequencies", "frequencies(plate), frequencies(system)", Level::force},
    {"impulse", "impulse(A), impulse(stop on plate)", Level::velocity},
    {"impulsive_couple", "impulsive_couple(A), impulsive_couple(hinge on plate about A)", Level::velocity},
};

const QuantityFunction* find_function(const std::string& name) {
  for (const QuantityFunction& function : functions)
    if (name == function.name) return &function;
  return nullptr;
}

struct LevelFinder {
  const Problem& problem;
  bool through_at = false;
  bool through_features = false;  // min(), max(), period(): of what?
  int depth = 0;

  Level of(const Expression& expression) const {
    return expression ? std::visit(LevelFinder{problem, through_at, through_features, depth + 1}, expression->content)
                      : Level::position;
  }
  Level operator()(const Number&) const { return Level::position; }
  Level operator()(const Name& name) const {
    if (name.primes >= 2) return Level::force;
    // The rate of what is defined follows from accelerations.
    if (depth < 200)
      for (const NamedExpression& item : problem.define)
        if (item.name == name.name) return name.primes > 0 ? Level::force : of(item.value);
    return name.primes > 0 ? Level::velocity : Level::position;
  }
  Level operator()(const Member& member) const { return of(member.object); }
  Level operator()(const Arrow& arrow) const { return std::max(of(arrow.from), of(arrow.to)); }
  Level operator()(const Of& item) const { return of(item.point); }
  Level operator()(const Call& call) const {
    if (is_motion_feature(call) && !through_features) return Level::motion;
    Level level = Level::position;
    if (const QuantityFunction* function = find_function(call.function)) level = function->level;
    for (const Argument& argument : call.arguments) level = std::max(level, of(argument.value));
    return level;
  }
  Level operator()(const Unary& unary) const { return of(unary.operand); }
  Level operator()(const Binary& binary) const { return std::max(of(binary.left), of(binary.right)); }
  Level operator()(const Comparison& comparison) const { return largest(comparison.operands); }
  // What is asked at another instant finds its own forces there.
  Level operator()(const At& at) const { return through_at ? of(at.expression) : Level::position; }
  Level operator()(const List& list) const { return largest(list.items); }
  Level operator()(const Range& range) const { return std::max({of(range.from), of(range.to), of(range.step)}); }
  Level largest(const std::vector<Expression>& items) const {
    Level level = Level::position;
    for (const Expression& item : items) level = std::max(level, of(item));
    return level;
  }
};

template <class Scalar>
std::vector<std::string> body_names(const MachineOf<Scalar>& machine) {
  std::vector<std::string> names;
  for (const auto& [name, index] : machine.index) names.push_back(name);
  return names;
}

}  // namespace

Level level_of(const Problem& problem, const Expression& expression, bool through_at) {
  return LevelFinder{problem, through_at}.of(expression);
}

bool asks_forces(const Problem& problem, const Expression& expression) {
  std::set<std::string> functions;
  collect_functions(expression, functions, true);
  // The linearised motion is told by accelerations, which no open share of a load changes.
  for (const char* name : {"stable", "stability", "growth_rate", "frequencies"})
    if (functions.contains(name)) return false;
  return LevelFinder{problem, true, true}.of(expression) >= Level::force;
}

bool asks_motion_feature(const Expression& expression) {
  const Problem nothing;
  return level_of(nothing, expression, true) == Level::motion;
}

const std::vector<FunctionForm>& quantity_functions() {
  static const std::vector<FunctionForm> forms = [] {
    std::vector<FunctionForm> list;
    for (const QuantityFunction& function : functions) list.push_back({function.name, function.form});
    return list;
  }();
  return forms;
}

template <class Scalar, class Base>
QuantityScope<Scalar, Base>::QuantityScope(const MachineOf<Base>& machine, const Model<Scalar>& model,
                                           DataScope<Scalar>& data, State<Scalar> state)
    : machine_(machine),
      model_(model),
      data_(data),
      problem_(data.problem()),
      state_(std::move(state)),
      workspace_(model) {
  update_velocities(model_, workspace_, state_);
}

template <class Scalar, class Base>
void QuantityScope<Scalar, Base>::set_accelerations(const std::vector<Base>& accelerations) {
  if constexpr (std::is_same_v<Scalar, Base>) {
    accelerations_ = accelerations;
    has_accelerations_ = true;
    update_accelerations<Base>(model_, workspace_, state_, accelerations_);
  }
}

template <class Scalar, class Base>
void QuantityScope<Scalar, Base>::set_forces(const solve::MomentOf<Base>* moment, const std::vector<Base>* unknowns) {
  moment_ = moment;
  unknowns_ = unknowns;
}

template <class Scalar, class Base>
Value<Scalar> QuantityScope<Scalar, Base>::value(const Expression& expression) {
  return evaluate(expression, static_cast<Scope<Scalar>&>(*this), problem_.file);
}

template <class Scalar, class Base>
Matrix3<Scalar> QuantityScope<Scalar, Base>::axes_of(const Expression& expression) {
  const Evaluator<Scalar> evaluator(*this, problem_.file);
  if (const List* list = expression.as<List>()) {
    if (list->items.size() != 3) evaluator.fail(expression.mark(), "axes are three directions");
    std::array<Vector, 3> d;
    for (std::size_t i = 0; i < 3; ++i) {
      const Result value = evaluator(list->items[i]);
      if (!value.is_vector() || plain(norm_squared(value.vector)) == 0)
        evaluator.fail(list->items[i].mark(), "expected a direction");
      d[i] = normalized(value.vector);
    }
    for (std::size_t i = 0; i < 3; ++i)
      if (std::abs(plain(dot(d[i], d[(i + 1) % 3]))) > 1e-9)
        evaluator.fail(expression.mark(), "the axes are not at right angles");
    if (plain(dot(d[0], cross(d[1], d[2]))) < 0) evaluator.fail(expression.mark(), "the axes are not right-handed");
    return Matrix3<Scalar>::from_columns(d[0], d[1], d[2]);
  }
  return body_rotation(model_, workspace_, body_of(expression, evaluator));
}

template <class Scalar, class Base>
bool QuantityScope<Scalar, Base>::is_frame(int body) const {
  return body == ground || !machine_.mechanism.takes_part[static_cast<std::size_t>(body)];
}

template <class Scalar, class Base>
int QuantityScope<Scalar, Base>::body_of(const Expression& expression, const Evaluator<Scalar>& evaluator,
                                         bool system_allowed) {
  const Name* name = plain_name(expression);
  if (!name) evaluator.fail(expression.mark(), "expected the name of a body");
  if (name->name == "system") {
    if (system_allowed) return whole_system;
    evaluator.fail(expression.mark(), "this is asked of one body, not of the system");
  }
  const auto found = machine_.index.find(name->name);
  if (found != machine_.index.end()) return found->second;
  std::vector<std::string> known = body_names(machine_);
  if (system_allowed) known.push_back("system");
  const std::string hint = did_you_mean(name->name, known);
  std::string all;
  for (const std::string& word : known) all += (all.empty() ? "" : ", ") + word;
  evaluator.fail(expression.mark(), "there is no body '" + name->name + "'", hint.empty() ? "known: " + all : hint);
}

template <class Scalar, class Base>
Vector3<Scalar> QuantityScope<Scalar, Base>::mass_center_of(int body, const Expression& expression,
                                                            const Evaluator<Scalar>& evaluator) {
  if (body == whole_system) return mass_center(model_, workspace_);
  if (is_frame(body)) return point_position(model_, workspace_, body, Vector::zero());
  if (!(plain(model_.body(body).inertia.mass) > 0))
    evaluator.fail(expression.mark(), "'" + to_string(expression) + "' is massless: it has no mass center",
                   "say which point is meant, such as A of " + to_string(expression));
  return body_mass_center(model_, workspace_, body);
}

template <class Scalar, class Base>
typename QuantityScope<Scalar, Base>::Riding QuantityScope<Scalar, Base>::riding(const Expression& expression,
                                                                                 const Evaluator<Scalar>& evaluator) {
  const auto at = [&](int body, const Vector& position) {
    return Riding{body, direction_on_body(model_, workspace_, body,
                                          position - point_position(model_, workspace_, body, Vector::zero()))};
  };
  if (const Of* of = expression.as<Of>()) {
    const int body = body_of(of->body, evaluator);
    const Vector3<Base> drawn = as_base(data_.place(of->point));
    return {body, lifted<Scalar>(machine_.place(body, drawn).point)};
  }
  if (const Call* call = expression.as<Call>();
      call && call->function == "center" && call->pattern().empty() && call->arguments.size() == 1) {
    const int body = body_of(call->arguments[0].value, evaluator);
    return at(body, mass_center_of(body, call->arguments[0].value, evaluator));
  }
  if (const Name* name = plain_name(expression);
      name && machine_.index.contains(name->name) && name->name != "ground") {
    const int body = machine_.index.at(name->name);
    return at(body, mass_center_of(body, expression, evaluator));
  }
  evaluator.fail(expression.mark(), "which point of which body is meant by '" + to_string(expression) + "'?",
                 "write A of plate for a point that moves with a body, or the body for its mass center");
}

template <class Scalar, class Base>
Vector3<Scalar> QuantityScope<Scalar, Base>::place(const Expression& expression, const Evaluator<Scalar>& evaluator) {
  return evaluator.vector(expression, dimensions::length);
}

// The body's mass properties in its present pose, on ground axes.
template <class Scalar, class Base>
MassProperties<Scalar> QuantityScope<Scalar, Base>::current_mass(int body) {
  const auto one = [&](int i) {
    const SpatialInertia<Scalar>& I = model_.body(i).inertia;
    if (!(plain(I.mass) > 0)) return massless<Scalar>();
    const Matrix3<Scalar>& R = workspace_.motion[static_cast<std::size_t>(i + 1)].R;
    const Vector c = I.first_moment / I.mass;
    const SymmetricMatrix3<Scalar> central = I.inertia - I.mass * unit_mass_inertia(c);
    return MassProperties<Scalar>{I.mass, body_mass_center(model_, workspace_, i), rotated(R, central)};
  };
  if (body >= 0) return one(body);
  std::vector<MassProperties<Scalar>> all;
  for (int i = 0; i < model_.body_count(); ++i)
    if (plain(model_.body(i).inertia.mass) > 0) all.push_back(one(i));
  return sum(all);
}

template <class Scalar, class Base>
Value<Scalar> QuantityScope<Scalar, Base>::name(const Name& name, const Mark& mark,
                                                const Evaluator<Scalar>& evaluator) {
  const NamedCoordinate* coordinate = machine_.coordinate(name.name);
  const auto defined = std::find_if(problem_.define.begin(), problem_.define.end(),
                                    [&](const NamedExpression& item) { return item.name == name.name; });
  const bool is_defined = defined != problem_.define.end();
  if (is_defined && (coordinate || data_.knows(name.name)))
    evaluator.fail(
        mark,
        "'" + name.name + "' could mean what is defined under define: or " + (coordinate ? "a coordinate" : "a datum"),
        "rename one of them");
  if (coordinate) {
    const Dimension dimension = coordinate->turning ? dimensions::angle : dimensions::length;
    const auto q = static_cast<std::size_t>(coordinate->position), v = static_cast<std::size_t>(coordinate->velocity);
    if (name.primes == 0) return number_value(state_.q[q], dimension);
    if (name.primes == 1) return number_value(state_.v[v], dimension / dimensions::time);
    if (name.primes == 2) {
      if (has_accelerations_)
        return number_value(lifted<Scalar>(accelerations_[v]), dimension / dimensions::time / dimensions::time);
      evaluator.fail(mark, "the acceleration " + name.name + "'' cannot stand inside rate() or among the velocities");
    }
    evaluator.fail(mark, "only first and second derivatives are known: " + name.name + "' and " + name.name + "''");
  }
  if (is_defined) {
    if (name.primes > 1) evaluator.fail(mark, "only the first derivative of '" + name.name + "' can be asked");
    if (name.primes == 1) {
      Call call{"rate", {Argument{"", defined->value}}};
      return rate(call, mark, evaluator);
    }
    if (std::find(pending_.begin(), pending_.end(), name.name) != pending_.end())
      evaluator.fail(mark, "'" + name.name + "' is defined by itself");
    pending_.push_back(name.name);
    Result value = evaluator(defined->value);
    pending_.pop_back();
    return value;
  }
  if (name.primes > 0 && data_.knows(name.name))
    evaluator.fail(mark, "'" + name.name + "' is a datum, no coordinate: it has no rate",
                   "name the coordinate at its joint: angle: " + name.name);
  const auto axis = std::find(problem_.axes.begin(), problem_.axes.end(), name.name);
  if (axis != problem_.axes.end() && name.primes == 0) {
    data_.name(name, mark, Evaluator<Scalar>(data_, problem_.file));
    return vector_value(axes_.column(static_cast<std::size_t>(axis - problem_.axes.begin())), dimensions::none);
  }
  if (!data_.knows(name.name) && machine_.index.contains(name.name))
    evaluator.fail(mark, "'" + name.name + "' is a body",
                   "ask for a quantity of it, such as velocity(" + name.name + ")");
  if (!data_.knows(name.name)) {
    std::vector<std::string> known = settable_names(problem_);
    for (const NamedCoordinate& c : machine_.coordinates)
      if (!c.name.empty()) known.push_back(c.name);
    for (const NamedExpression& item : problem_.define) known.push_back(item.name);
    for (const NamedExpression& item : problem_.points) known.push_back(item.name);
    const std::string hint = did_you_mean(name.name, known);
    evaluator.fail(mark, "'" + name.name + "' is not defined", hint);
  }
  return data_.name(name, mark, Evaluator<Scalar>(data_, problem_.file));
}

template <class Scalar, class Base>
Value<Scalar> QuantityScope<Scalar, Base>::of(const Of& of, const Mark& mark, const Evaluator<Scalar>& evaluator) {
  const int body = body_of(of.body, evaluator);
  (void)mark;
  const Vector3<Base> drawn = as_base(data_.place(of.point));
  return vector_value(point_position(model_, workspace_, body, lifted<Scalar>(machine_.place(body, drawn).point)),
                      dimensions::length);
}

template <class Scalar, class Base>
Value<Scalar> QuantityScope<Scalar, Base>::at(const At& at, const Mark& mark, const Evaluator<Scalar>& evaluator) {
  if (!elsewhere_) evaluator.fail(mark, "'@ " + at.instant + "' cannot stand here");
  return elsewhere_(at, at.instant_mark);
}

template <class Scalar, class Base>
Value<Scalar> QuantityScope<Scalar, Base>::member(const Member& member, const Mark& mark,
                                                  const Evaluator<Scalar>& evaluator) {
  const Result object = evaluator(member.object);
  const auto axis = std::find(problem_.axes.begin(), problem_.axes.end(), member.name);
  if (!object.is_vector()) evaluator.fail(mark, "only vectors have components");
  if (axis == problem_.axes.end())
    evaluator.fail(mark, "there is no component '" + member.name + "'",
                   "the components are ." + problem_.axes[0] + " ." + problem_.axes[1] + " ." + problem_.axes[2]);
  const Vector column = axes_.column(static_cast<std::size_t>(axis - problem_.axes.begin()));
  return number_value(dot(object.vector, column), object.dimension);
}

template <class Scalar, class Base>
Value<Scalar> QuantityScope<Scalar, Base>::call(const Call& call, const Mark& mark,
                                                const Evaluator<Scalar>& evaluator) {
  static const std::map<std::string, std::vector<std::string>> patterns{
      {"position", {""}},
      {"center", {""}},
      {"velocity", {"", "relative to"}},
      {"acceleration", {"", "relative to"}},
      {"angular_velocity", {"", "relative to"}},
      {"angular_acceleration", {""}},
      {"momentum", {""}},
      {"angular_momentum", {"about"}},
      {"kinetic_energy", {"", "about"}},
      {"potential_energy", {""}},
      {"rate", {"", "relative to"}},
      {"mass", {""}},
      {"weight", {""}},
      {"moment_of_inertia", {"about", "about at"}},
      {"radius_of_gyration", {"about", "about at"}},
      {"moments_of_inertia", {"about"}},
      {"products_of_inertia", {"about"}},
      {"inertia_matrix", {"about"}},
      {"principal_moments", {"about"}},
      {"principal_axes", {"about"}},
      {"axis", {""}},
      {"distance", {"to"}},
      {"direction_angles", {""}},
      {"force", {"on"}},
      {"couple", {"on about"}},
      {"reaction", {"", "of"}},
      {"reaction_couple", {"", "of"}},
      {"drive", {""}},
      {"tension", {""}},
      {"load", {""}},
      {"symmetry_axis", {""}},
      {"precession_axis", {""}},
      {"precession_rate", {""}},
      {"spin_rate", {"", "about"}},
      {"precession_sense", {""}},
      {"body_cone", {""}},
      {"space_cone", {""}},
      {"invariable_plane", {""}},
      {"poinsot_ellipsoid", {""}},
      {"polhode", {""}},
      {"axis_stability", {""}},
      {"period", {""}},
      {"touching", {""}},
      {"taut", {""}},
      {"stable", {""}},
      {"stability", {""}},
      {"growth_rate", {""}},
      {"frequencies", {""}},
      {"impulse", {"", "of", "on"}},
      {"impulsive_couple", {"", "of", "on about"}},
  };
  if (is_motion_feature(call)) {
    if constexpr (std::is_same_v<Scalar, double>)
      if (feature_) return feature_(call, axes_expression_, mark);
    evaluator.fail(mark, call.function + "() over the motion cannot stand here");
  }
  if (call.function == "derivative" && call.pattern() == "by") return derivative_by(call, mark, evaluator);
  const QuantityFunction* function = find_function(call.function);
  if (!function) {
    std::vector<std::string> names;
    for (const QuantityFunction& known : functions) names.emplace_back(known.name);
    evaluator.unknown_call(call, mark, names);
  }
  const auto& allowed = patterns.at(call.function);
  // reaction(A of bearings) reads as one argument.
  if (call.arguments.empty() || std::find(allowed.begin(), allowed.end(), call.pattern()) == allowed.end())
    evaluator.fail(mark, call.function + " is not written like this", std::string("write ") + function->form);
  const std::string& f = call.function;
  if (f == "velocity" || f == "acceleration" || f == "angular_velocity" || f == "angular_acceleration" ||
      f == "position" || f == "center")
    return kinematic(call, evaluator);
  if (f == "momentum" || f == "angular_momentum" || f == "kinetic_energy" || f == "potential_energy" || f == "mass" ||
      f == "weight")
    return momentum(call, evaluator);
  if (f == "symmetry_axis" || f == "precession_axis" || f == "precession_rate" || f == "spin_rate" ||
      f == "precession_sense" || f == "body_cone" || f == "space_cone" || f == "invariable_plane" ||
      f == "poinsot_ellipsoid" || f == "polhode" || f == "axis_stability")
    return free_motion(call, mark, evaluator);
  if (f == "axis" || f == "distance" || f == "direction_angles") return geometry(call, evaluator);
  if (f == "rate") return rate(call, mark, evaluator);
  if (f == "touching" || f == "taut") return holding(call, evaluator);
  if (f == "stable" || f == "stability" || f == "growth_rate" || f == "frequencies")
    return stability(call, mark, evaluator);
  if (function->level == Level::force || f == "impulse" || f == "impulsive_couple") return force(call, mark, evaluator);
  return inertia(call, mark, evaluator);
}

// derivative(X by m): how X changes with a letter, all other letters held.
template <class Scalar, class Base>
Value<Scalar> QuantityScope<Scalar, Base>::derivative_by(const Call& call, const Mark& mark,
                                                         const Evaluator<Scalar>& evaluator) {
  if constexpr (std::is_same_v<Scalar, Formula>) {
    const Name* name = plain_name(*call.argument("by"));
    if (const Name* primed = call.argument("by")->as<Name>(); primed && primed->primes == 1) name = primed;
    if (!name) evaluator.fail(call.argument("by")->mark(), "a derivative is by a letter", "write derivative(X by m)");
    const Result by = evaluator(*call.argument("by"));
    const std::string letter = name->name + std::string(static_cast<std::size_t>(name->primes), '\'');
    const std::vector<std::string> letters = by.is_number() ? by.number.letters() : std::vector<std::string>{};
    if (letters != std::vector<std::string>{letter})
      evaluator.fail(call.argument("by")->mark(), "'" + letter + "' is no letter whose value is open");
    Result value = evaluator(call.arguments.front().value);
    if (!value.is_number() && !value.is_vector()) evaluator.fail(mark, "only numbers and vectors have a derivative");
    if (value.is_number()) value.number = poinsot::derivative(value.number, letter);
    for (std::size_t k = 0; value.is_vector() && k < 3; ++k)
      value.vector[k] = poinsot::derivative(value.vector[k], letter);
    value.dimension = value.dimension / by.dimension;
    value.bare = false;
    return value;
  } else {
    evaluator.fail(mark, "a derivative by a letter stands in claims only");
  }
}

template <class Scalar, class Base>
Value<Scalar> QuantityScope<Scalar, Base>::kinematic(const Call& call, const Evaluator<Scalar>& evaluator) {
  const std::string& f = call.function;
  const Expression& what = call.arguments[0].value;
  if (f == "center")
    return vector_value(mass_center_of(body_of(what, evaluator, true), what, evaluator), dimensions::length);
  if (f == "position") {
    if (plain_name(what) && !machine_.index.contains(plain_name(what)->name))
      return vector_value(place(what, evaluator), dimensions::length);
    const Riding point = riding(what, evaluator);
    return vector_value(point_position(model_, workspace_, point.body, point.local), dimensions::length);
  }
  if ((f == "acceleration" || f == "angular_acceleration") && !has_accelerations_)
    evaluator.fail(what.mark(), f + " cannot stand inside rate() or among what is known of the velocities");
  const Expression* relative_to = call.argument("relative to");
  const int frame = relative_to ? body_of(*relative_to, evaluator) : ground;
  const BodyMotion<Scalar>& F = workspace_.motion[static_cast<std::size_t>(frame + 1)];
  if (f == "angular_velocity")
    return vector_value(Vector(angular_velocity(workspace_, body_of(what, evaluator)) - F.w),
                        dimensions::angular_velocity);
  if (f == "angular_acceleration")
    return vector_value(Vector(angular_acceleration(workspace_, body_of(what, evaluator))),
                        dimensions::angular_acceleration);
  // The system moves as its mass center.
  if (const Name* name = plain_name(what); name && name->name == "system" && f == "velocity")
    return vector_value(poinsot::momentum(model_, workspace_, Vector::zero()).linear / total_mass(model_),
                        dimensions::velocity);
  const Riding point = riding(what, evaluator);
  const Vector r = point_position(model_, workspace_, point.body, point.local) - F.p;
  const Vector v = point_velocity(model_, workspace_, point.body, point.local) - F.v - cross(F.w, r);
  if (f == "velocity") return vector_value(v, dimensions::velocity);
  const Vector a = point_acceleration(model_, workspace_, point.body, point.local) - F.a - cross(F.alpha, r) -
                   cross(F.w, cross(F.w, r)) - Scalar(2) * cross(F.w, v);
  return vector_value(a, dimensions::acceleration);
}

template <class Scalar, class Base>
Value<Scalar> QuantityScope<Scalar, Base>::momentum(const Call& call, const Evaluator<Scalar>& evaluator) {
  const std::string& f = call.function;
  const Expression& what = call.arguments[0].value;
  const int body = body_of(what, evaluator, true);
  if (body == ground) evaluator.fail(what.mark(), "the ground has no " + f);
  const bool all = body == whole_system;
  if (f == "mass" || f == "weight") {
    const Scalar mass = all ? total_mass(model_) : model_.body(body).inertia.mass;
    if (f == "mass") return number_value(mass, dimensions::mass);
    return number_value(mass * data_.gravity_size(), dimensions::force);
  }
  if (f == "momentum") {
    const auto total = all ? poinsot::momentum(model_, workspace_, Vector::zero())
                           : body_momentum(model_, workspace_, body, Vector::zero());
    return vector_value(total.linear, dimensions::momentum);
  }
  if (f == "angular_momentum") {
    const Vector P = place(*call.argument("about"), evaluator);
    const auto total = all ? poinsot::momentum(model_, workspace_, P) : body_momentum(model_, workspace_, body, P);
    return vector_value(total.angular, dimensions::angular_momentum);
  }
  if (f == "potential_energy") {
    Scalar sum(0);
    for (int i = 0; i < model_.body_count(); ++i)
      if ((all || i == body) && plain(model_.body(i).inertia.mass) > 0)
        sum = sum - model_.body(i).inertia.mass * dot(model_.gravity(), body_mass_center(model_, workspace_, i));
    return number_value(sum, dimensions::energy);
  }
  const Scalar T = all ? poinsot::kinetic_energy(model_, workspace_) : body_kinetic_energy(model_, workspace_, body);
  if (const Expression* about = call.argument("about")) {
    const Vector P = place(*about, evaluator), G = mass_center_of(body, what, evaluator);
    if (plain(norm(P - G)) > 1e-9 * (1 + plain(norm(G))))
      evaluator.fail(about->mark(), "the kinetic energy of the motion about a point is meant about the mass center",
                     "write kinetic_energy(" + to_string(what) + " about center(" + to_string(what) + "))");
    const Vector L =
        (all ? poinsot::momentum(model_, workspace_, P) : body_momentum(model_, workspace_, body, P)).linear;
    const Scalar mass = all ? total_mass(model_) : model_.body(body).inertia.mass;
    return number_value(Scalar(T - Scalar(0.5) * norm_squared(L) / mass), dimensions::energy);
  }
  return number_value(T, dimensions::energy);
}

template <class Scalar, class Base>
std::pair<Vector3<Scalar>, Vector3<Scalar>> QuantityScope<Scalar, Base>::line(const Call& call,
                                                                              const Evaluator<Scalar>& evaluator) {
  const Expression& about = *call.argument("about");
  if (const Expression* at = call.argument("at")) {
    const Result d = evaluator(about);
    if (!d.is_vector() || plain(norm_squared(d.vector)) == 0) evaluator.fail(about.mark(), "expected an axis");
    return {place(*at, evaluator), normalized(d.vector)};
  }
  if (const Arrow* arrow = about.as<Arrow>()) {
    const Vector A = place(arrow->from, evaluator), B = place(arrow->to, evaluator);
    if (plain(norm_squared(B - A)) == 0) evaluator.fail(about.mark(), "the two points of this axis coincide");
    return {A, normalized(Vector(B - A))};
  }
  if (const Call* axis = about.as<Call>(); axis && axis->function == "axis" && axis->arguments.size() == 1) {
    const Vector d = evaluator(about).vector;
    const JointPlaceOf<Base>& joint = machine_.joints.at(plain_name(axis->arguments[0].value)->name);
    return {point_position(model_, workspace_, joint.at.body, lifted<Scalar>(joint.at.point)), d};
  }
  evaluator.fail(about.mark(), "this axis has a direction but no place",
                 "write about A->B, about axis(hinge), or about x at A");
}

template <class Scalar, class Base>
Value<Scalar> QuantityScope<Scalar, Base>::geometry(const Call& call, const Evaluator<Scalar>& evaluator) {
  using std::acos;
  const std::string& f = call.function;
  const Expression& what = call.arguments[0].value;
  if (f == "axis") {
    const Name* name = plain_name(what);
    const auto found = name ? machine_.joints.find(name->name) : machine_.joints.end();
    if (found == machine_.joints.end()) {
      std::vector<std::string> joints;
      for (const auto& [joint, place] : machine_.joints) joints.push_back(joint);
      evaluator.fail(what.mark(), "there is no joint '" + to_string(what) + "'", did_you_mean(to_string(what), joints));
    }
    if (!found->second.axis) evaluator.fail(what.mark(), "joint '" + name->name + "' has no axis of its own");
    return vector_value(
        direction_on_ground(model_, workspace_, found->second.axis->body, lifted<Scalar>(found->second.axis->vector)),
        dimensions::none);
  }
  if (f == "direction_angles") {
    const Result v = evaluator(what);
    if (!v.is_vector()) evaluator.fail(what.mark(), "direction angles are asked of a vector");
    const Scalar size = norm(v.vector);
    if (!(plain(size) > 0)) evaluator.fail(what.mark(), "the zero vector has no direction angles");
    std::vector<Result> items;
    for (std::size_t k = 0; k < 3; ++k) {
      Scalar cosine = dot(v.vector, axes_.column(k)) / size;
      if (plain(cosine) > 1) cosine = Scalar(1);
      if (plain(cosine) < -1) cosine = Scalar(-1);
      items.push_back(number_value(Scalar(acos(cosine)), dimensions::angle));
    }
    return Result::of_list(std::move(items));
  }
  // distance
  const Expression& to = *call.argument("to");
  const Vector A = place(what, evaluator);
  const Call* axis = to.as<Call>();
  if (to.as<Arrow>() || (axis && axis->function == "axis")) {
    const auto [P, d] = line(Call{"distance", {Argument{"", what}, Argument{"about", to}}}, evaluator);
    return number_value(norm(cross(d, Vector(A - P))), dimensions::length);
  }
  return number_value(norm(Vector(place(to, evaluator) - A)), dimensions::length);
}

template <class Scalar, class Base>
Value<Scalar> QuantityScope<Scalar, Base>::rate(const Call& call, const Mark& mark,
                                                const Evaluator<Scalar>& evaluator) {
  if constexpr (!std::is_same_v<Scalar, Base>) {
    evaluator.fail(mark, "the rate of a rate cannot be asked", "ask for acceleration() or angular_acceleration()");
  } else {
    if (!has_accelerations_) evaluator.fail(mark, "rate() cannot stand among what is known of the velocities");
    using Timed = Dual<1, Base>;
    // The state as a function of time: values with their rates.
    const Model<Timed> model = convert<Timed>(model_);
    State<Timed> state;
    std::vector<Base> q_rate(state_.q.size());
    position_rate<Base>(model_, state_.q, state_.v, q_rate);
    for (std::size_t i = 0; i < state_.q.size(); ++i) state.q.push_back(Timed(state_.q[i], {q_rate[i]}));
    for (std::size_t i = 0; i < state_.v.size(); ++i) state.v.push_back(Timed(state_.v[i], {accelerations_[i]}));
    const Timed now = Timed::variable(data_.value(parse_expression("time", problem_.file, mark)).number, 0);
    DataScope<Timed> data(problem_, data_.settings(), now);
    data.vary_as(data_);
    QuantityScope<Timed, Base> timed(machine_, model, data, std::move(state));
    if (axes_expression_) timed.set_axes(*axes_expression_);
    const Value<Timed> value = timed.value(call.arguments[0].value);
    const Dimension dimension = value.dimension / dimensions::time;
    if (value.is_number()) return number_value(value.number.partial[0], dimension);
    if (!value.is_vector()) evaluator.fail(mark, "only numbers and vectors have a rate");
    Vector derivative{value.vector.x.partial[0], value.vector.y.partial[0], value.vector.z.partial[0]};
    if (const Expression* relative_to = call.argument("relative to")) {
      const int frame = body_of(*relative_to, evaluator);
      derivative = derivative - cross(angular_velocity(workspace_, frame),
                                      Vector{value.vector.x.value, value.vector.y.value, value.vector.z.value});
    }
    return vector_value(derivative, dimension);
  }
}

template class QuantityScope<double>;
template class QuantityScope<Dual<1>, double>;
template class QuantityScope<Formula>;
template class QuantityScope<Dual<1, Formula>, Formula>;

}  // namespace poinsot::statement
