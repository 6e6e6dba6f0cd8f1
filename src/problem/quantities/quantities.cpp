#include "problem/quantities/quantities.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <type_traits>

#include "poinsot/engine/mass/composition.h"
#include "problem/language/diagnostic.h"
#include "problem/language/evaluate_functions.h"
#include "problem/language/exact_numbers.h"
#include "problem/language/expression_walk.h"
#include "problem/language/misread.h"
#include "problem/language/words.h"
#include "problem/quantities/quantity_values.h"

namespace poinsot::problem {
namespace {

template <class Scalar>
std::vector<std::string> body_names(const MachineOf<Scalar>& machine) {
  std::vector<std::string> names;
  for (const auto& [name, index] : machine.index) names.push_back(name);
  return names;
}

}  // namespace

template <class Scalar, class Base>
QuantityScope<Scalar, Base>::QuantityScope(const MachineOf<Base>& machine, const Model<Scalar>& model,
                                           DataScope<Scalar>& data, State<Scalar> state)
    : machine_(machine),
      model_(model),
      data_(data),
      situation_(data.situation()),
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
void QuantityScope<Scalar, Base>::set_forces(const solve::MechanismStateOf<Base>* state,
                                             const std::vector<Base>* unknowns) {
  mechanism_state_ = state;
  unknowns_ = unknowns;
}

template <class Scalar, class Base>
Value<Scalar> QuantityScope<Scalar, Base>::value(const Expression& expression) {
  return evaluate(expression, static_cast<Scope<Scalar>&>(*this), situation_.file);
}

template <class Scalar, class Base>
Matrix3<Scalar> QuantityScope<Scalar, Base>::axes_of(const Expression& expression) {
  const Evaluator<Scalar> evaluator(*this, situation_.file);
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
      if (constexpr double right_angle = 1e-9;  // cosine: directions may be stated to nine digits
          std::abs(plain(dot(d[i], d[(i + 1) % 3]))) > right_angle)
        evaluator.fail(expression.mark(), "the axes are not at right angles");
    if (plain(dot(d[0], cross(d[1], d[2]))) < 0) evaluator.fail(expression.mark(), "the axes are not right-handed");
    return Matrix3<Scalar>::from_columns(d[0], d[1], d[2]);
  }
  const int body = body_of(expression, evaluator);
  const Matrix3<Scalar>& axes = body_rotation(model_, workspace_, body);
  for (std::size_t k = 0; k < 3; ++k) tell_direction(body, Vector3<Base>::unit(k), axes.column(k), "axes");
  return axes;
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
  const std::string all = joined(known);
  evaluator.fail(expression.mark(), "there is no body '" + name->name + "'", hint.empty() ? "known: " + all : hint);
}

template <class Scalar, class Base>
Vector3<Scalar> QuantityScope<Scalar, Base>::mass_center_of(int body, const Expression& expression,
                                                            const Evaluator<Scalar>& evaluator) {
  if (body == whole_system) {
    Scalar mass = total_mass(model_);
    Vector first = mass * mass_center(model_, workspace_);
    for (const FlyingParticle<Base>& particle : flying_) {
      mass = mass + lifted<Scalar>(particle.mass);
      first = first + lifted<Scalar>(particle.mass) * lifted<Scalar>(particle.position);
    }
    return flying_.empty() ? mass_center(model_, workspace_) : Vector(first / mass);
  }
  if (is_frame(body)) return point_position(model_, workspace_, body, Vector::zero());
  if (!(plain(model_.body(body).inertia.mass) > 0))
    evaluator.fail(expression.mark(), "'" + to_string(expression) + "' is massless: it has no mass center",
                   "say which point is meant, such as A of " + to_string(expression));
  return body_mass_center(model_, workspace_, body);
}

namespace {

// Who writes `momentum of disk` means no point.
template <class Data, class Scalar>
void refuse_quantity_as_point(const Of& of, const Data& data, const Evaluator<Scalar>& evaluator) {
  const Name* point = plain_name(of.point);
  if (const QuantityFunction* quantity = point && !data.knows(point->name) ? find_quantity(point->name) : nullptr)
    evaluator.fail(of.point.mark(), "'" + point->name + "' is a quantity: what it is of stands in brackets",
                   std::string("write ") + quantity->form);
}

}  // namespace

template <class Scalar, class Base>
typename QuantityScope<Scalar, Base>::Riding QuantityScope<Scalar, Base>::riding(const Expression& expression,
                                                                                 const Evaluator<Scalar>& evaluator) {
  const auto at = [&](int body, const Vector& position) {
    return Riding{body,
                  direction_on_body(model_, workspace_, body,
                                    position - point_position(model_, workspace_, body, Vector::zero())),
                  {}};
  };
  if (const Of* of = expression.as<Of>()) {
    const int body = body_of(of->body, evaluator);
    refuse_quantity_as_point(*of, data_, evaluator);
    const Vector3<Base> drawn = as_base(data_.place(of->point));
    return {body, lifted<Scalar>(machine_.place(body, drawn).point), drawn};
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
  if (const Name* name = plain_name(expression)) {
    std::vector<std::string> bodies;
    for (const Body& body : situation_.bodies) bodies.push_back(body.name);
    if (std::ranges::find(situation_.points, name->name, &NamedExpression::name) != situation_.points.end())
      evaluator.fail(expression.mark(), "of which body is the point '" + name->name + "' meant?",
                     "write " + name->name + " of " + (bodies.size() == 1 ? bodies.front() : "plate") +
                         ", with the body that it moves with");
    if (const std::string hint = did_you_mean(name->name, bodies); !hint.empty())
      evaluator.fail(expression.mark(), "there is no body '" + name->name + "'", hint);
  }
  evaluator.fail(expression.mark(), "which point of which body is meant by '" + to_string(expression) + "'?",
                 "write A of plate for a point that moves with a body, or the body for its mass center");
}

template <class Scalar, class Base>
Vector3<Scalar> QuantityScope<Scalar, Base>::place(const Expression& expression, const Evaluator<Scalar>& evaluator) {
  // The digit stands beside the letter that names most origins, and as a vector it would be taken for the origin.
  if (const Number* number = expression.as<Number>(); number && number->value == 0) {
    const bool letter = std::ranges::find(situation_.points, "O", &NamedExpression::name) != situation_.points.end();
    evaluator.fail(expression.mark(), "0 is a number, and a point is meant here",
                   letter ? "write O, the letter, for the point of that name; of the origin write [0, 0, 0]"
                          : "name the point under points:, or write [0, 0, 0] for the origin");
  }
  return evaluator.vector(expression, dimensions::length);
}

// The mass properties of the body in its present pose, on ground axes.
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
  const auto defined = std::find_if(situation_.define.begin(), situation_.define.end(),
                                    [&](const NamedExpression& item) { return item.name == name.name; });
  const bool is_defined = defined != situation_.define.end();
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
    const struct Removed {
      std::vector<std::string>& list;
      ~Removed() { list.pop_back(); }
    } removed{pending_};
    return evaluator(defined->value);
  }
  if (name.primes > 0 && data_.knows(name.name))
    evaluator.fail(mark, "'" + name.name + "' is a datum, no coordinate: it has no rate",
                   "name the coordinate at its joint: angle: " + name.name);
  const auto axis = std::find(situation_.axes.begin(), situation_.axes.end(), name.name);
  if (axis != situation_.axes.end() && name.primes == 0) {
    data_.name(name, mark, Evaluator<Scalar>(data_, situation_.file));
    return vector_value(axes_.column(static_cast<std::size_t>(axis - situation_.axes.begin())), dimensions::none);
  }
  if (!data_.knows(name.name) && machine_.index.contains(name.name))
    evaluator.fail(mark, "'" + name.name + "' is a body",
                   "ask for a quantity of it, such as velocity(" + name.name + ")");
  if (!data_.knows(name.name)) {
    std::vector<std::string> known = settable_names(situation_);
    for (const NamedCoordinate& c : machine_.coordinates)
      if (!c.name.empty()) known.push_back(c.name);
    for (const NamedExpression& item : situation_.define) known.push_back(item.name);
    for (const NamedExpression& item : situation_.points) known.push_back(item.name);
    evaluator.fail(mark, "'" + name.name + "' is not defined", undefined_name_hint(name.name, known));
  }
  return data_.name(name, mark, Evaluator<Scalar>(data_, situation_.file));
}

template <class Scalar, class Base>
Value<Scalar> QuantityScope<Scalar, Base>::of(const Of& of, const Mark& mark, const Evaluator<Scalar>& evaluator) {
  refuse_quantity_as_point(of, data_, evaluator);
  const int body = body_of(of.body, evaluator);
  (void)mark;
  const Vector3<Base> drawn = as_base(data_.place(of.point));
  const Vector now = point_position(model_, workspace_, body, lifted<Scalar>(machine_.place(body, drawn).point));
  tell_position(body, drawn, now, "position");
  return vector_value(now, dimensions::length);
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
  if (is_record(object)) return named_item(object, member.name, mark, evaluator);
  const auto axis = std::find(situation_.axes.begin(), situation_.axes.end(), member.name);
  if (!object.is_vector())
    evaluator.fail(mark, "only vectors have components",
                   object.is_list() ? "an element of a list is taken by [1]" : "");
  if (axis == situation_.axes.end())
    evaluator.fail(mark, "there is no component '" + member.name + "'",
                   "the components are ." + situation_.axes[0] + " ." + situation_.axes[1] + " ." + situation_.axes[2]);
  const Vector column = axes_.column(static_cast<std::size_t>(axis - situation_.axes.begin()));
  return number_value(dot(object.vector, column), object.dimension);
}

template <class Scalar, class Base>
Value<Scalar> QuantityScope<Scalar, Base>::call(const Call& call, const Mark& mark,
                                                const Evaluator<Scalar>& evaluator) {
  if (is_motion_feature(call)) {
    if constexpr (std::is_same_v<Scalar, double>)
      if (features_)
        if (const auto told = features_->find(&call); told != features_->end()) return told->second;
    evaluator.fail(mark, call.function + "() over the motion cannot stand here");
  }
  if (call.function == "derivative" && call.pattern() == "by") return derivative_by(call, mark, evaluator);
  if (is_extreme_of_list(call)) return extreme_of_list(call, mark, evaluator);
  const QuantityFunction* function = find_quantity(call.function);
  if (!function) {
    std::vector<std::string> names;
    for (const QuantityFunction& known : quantity_table()) names.emplace_back(known.name);
    evaluator.unknown_call(call, mark, names);
  }
  // The parser reads reaction(A of bearings) as a single argument.
  if (call.arguments.empty() ||
      std::find(function->patterns.begin(), function->patterns.end(), call.pattern()) == function->patterns.end())
    evaluator.fail(mark, call.function + " is not written like this", std::string("write ") + function->form);
  switch (function->kind) {
    case QuantityKind::kinematic:
      return kinematic(call, evaluator);
    case QuantityKind::momentum:
      return momentum(call, evaluator);
    case QuantityKind::inertia:
      return inertia(call, mark, evaluator);
    case QuantityKind::free_motion:
      return free_motion(call, mark, evaluator);
    case QuantityKind::geometry:
      return geometry(call, evaluator);
    case QuantityKind::rate:
      return rate(call, mark, evaluator);
    case QuantityKind::force:
      return force(call, mark, evaluator);
    case QuantityKind::holding:
      return holding(call, evaluator);
    case QuantityKind::friction:
      return friction(call, evaluator);
    case QuantityKind::stability:
      return stability(call, mark, evaluator);
    case QuantityKind::motion_feature:
      break;
  }
  evaluator.fail(mark, call.function + "() over the motion cannot stand here");
}

// derivative(X by m): the derivative of X by a letter, while all other letters are held.
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
Value<Scalar> QuantityScope<Scalar, Base>::rate(const Call& call, const Mark& mark,
                                                const Evaluator<Scalar>& evaluator) {
  if constexpr (!std::is_same_v<Scalar, Base>) {
    evaluator.fail(mark, "the rate of a rate cannot be asked", "ask for acceleration() or angular_acceleration()");
  } else {
    if (!has_accelerations_) evaluator.fail(mark, "rate() cannot stand among what is known of the velocities");
    // What changes at the rate is told too, so that particles may confirm it.
    if (tells()) evaluator(call.arguments.front().value);
    using Timed = Dual<1, Base>;
    // The state as a function of time: each value has its rate as dual part.
    const Model<Timed> model = convert<Timed>(model_);
    State<Timed> state;
    std::vector<Base> q_rate(state_.q.size());
    position_rate<Base>(model_, state_.q, state_.v, q_rate);
    for (std::size_t i = 0; i < state_.q.size(); ++i) state.q.push_back(Timed(state_.q[i], {q_rate[i]}));
    for (std::size_t i = 0; i < state_.v.size(); ++i) state.v.push_back(Timed(state_.v[i], {accelerations_[i]}));
    const Timed now = Timed::variable(data_.value(built(Name{"time"}, mark)).number, 0);
    DataScope<Timed> data(situation_, data_.settings(), now);
    data.vary_as(data_);
    QuantityScope<Timed, Base> timed(machine_, model, data, std::move(state));
    if (axes_expression_) timed.set_axes(*axes_expression_);
    if (tells()) timed.set_told(told_);
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
template class QuantityScope<Dual<1>>;
template class QuantityScope<Dual<1, Dual<1>>, Dual<1>>;
template class QuantityScope<Formula>;
template class QuantityScope<Dual<1, Formula>, Formula>;

}  // namespace poinsot::problem
