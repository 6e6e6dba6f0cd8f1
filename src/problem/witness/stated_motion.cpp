#include "problem/witness/stated_motion.h"

#include <algorithm>

#include "problem/language/diagnostic.h"
#include "problem/witness/stated_springs.h"

namespace poinsot::problem {

namespace {

using Vector = StatedMotion::Vector;

}  // namespace

Vector StatedMotion::drawn_center(int body) const {
  solve::ParticlePaths::Real mass = 0;
  Vector first = Vector::zero();
  for (const auto& [link, properties] : machine_.masses) {
    if (link != body) continue;
    for (const auto& particle : properties.particles) {
      mass += particle.mass;
      first += solve::ParticlePaths::Real(particle.mass) * widened(particle.position);
    }
  }
  return first / mass;
}

Value<double> StatedMotion::seen(const Vector& on_ground, const Dimension& dimension) const {
  const Vector own = transpose(paths_.turn(axes_)) * on_ground;
  return Value<double>::of_vector({static_cast<double>(own.x), static_cast<double>(own.y), static_cast<double>(own.z)},
                                  dimension);
}

Value<double> StatedMotion::name(const Name& name, const Mark& mark, const Evaluator<double>& evaluator) {
  const bool is_datum = name.primes == 0 && data_.knows(name.name);
  if (const NamedCoordinate* coordinate = machine_.coordinate(name.name); coordinate && !is_datum) {
    const Dimension dimension = coordinate->turning ? dimensions::angle : dimensions::length;
    if (name.primes == 0)
      return Value<double>::of_number(machine_.q[static_cast<std::size_t>(coordinate->position)], dimension);
    return Value<double>::of_number(v_[static_cast<std::size_t>(coordinate->velocity)], dimension / dimensions::time);
  }
  for (const NamedExpression& defined : data_.situation().define)
    if (defined.name == name.name) return evaluator(defined.value);
  return data_.name(name, mark, Evaluator<double>(data_, data_.situation().file));
}

// A of plate, center(disk), or the body for its mass center.
StatedMotion::Point StatedMotion::point_of(const Expression& expression) const {
  if (const Of* of = expression.as<Of>()) {
    const int body = body_of(of->body);
    return {body, paths_.place(body, widened(data_.place(of->point)))};
  }
  const Call* call = expression.as<Call>();
  const int body = body_of(call ? call->arguments.front().value : expression);
  return {body, paths_.place(body, drawn_center(body))};
}

Value<double> StatedMotion::of(const Of& of, const Mark&, const Evaluator<double>&) {
  const int body = body_of(of.body);
  return seen(paths_.place(body, widened(data_.place(of.point))), dimensions::length);
}

Value<double> StatedMotion::member(const Member& member, const Mark& mark, const Evaluator<double>& evaluator) {
  const Result object = evaluator(member.object);
  const auto& axes = data_.situation().axes;
  const auto axis = std::ranges::find(axes, member.name);
  if (!object.is_vector() || axis == axes.end()) evaluator.fail(mark, "there is no such component");
  return Value<double>::of_number(object.vector[static_cast<std::size_t>(axis - axes.begin())], object.dimension,
                                  object.bare);
}

Value<double> StatedMotion::call(const Call& call, const Mark& mark, const Evaluator<double>& evaluator) {
  const std::string& f = call.function;
  const Expression& what = call.arguments.front().value;
  const Expression* relative_to = call.argument("relative to");
  const int from = relative_to ? body_of(*relative_to) : ground;
  if (f == "distance") {
    const auto apart =
        evaluator.vector(*call.argument("to"), dimensions::length) - evaluator.vector(what, dimensions::length);
    return Value<double>::of_number(norm(apart), dimensions::length);
  }
  if (f == "axis") {
    const Direction<double>& axis = *machine_.joints.at(to_string(what)).axis;
    return seen(paths_.turn(axis.body) * widened(axis.vector), dimensions::none);
  }
  if (f == "mass") {
    const auto sums = paths_.sums(body_of(what), Vector::zero());
    return Value<double>::of_number(static_cast<double>(sums.mass), dimensions::mass);
  }
  if (f == "angular_velocity") return seen(paths_.angular_velocity(body_of(what), from), dimensions::angular_velocity);
  if (f == "center" || f == "position") {
    if (const Name* name = what.as<Name>(); name && !machine_.index.contains(name->name)) return evaluator(what);
    return seen(point_of(what).now, dimensions::length);
  }
  if (f != "velocity") evaluator.fail(mark, "loads do not depend on " + f + "(...)");
  const Point point = point_of(what);
  return seen(paths_.velocity(point.body, point.now, from), dimensions::velocity);
}

}  // namespace poinsot::problem
