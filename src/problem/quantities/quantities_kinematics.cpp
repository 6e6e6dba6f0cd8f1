// Positions, velocities and accelerations, distances and directions.
#include <cmath>
#include <string_view>
#include <vector>

#include "problem/language/diagnostic.h"
#include "problem/language/exact_numbers.h"
#include "problem/quantities/quantities.h"
#include "problem/quantities/quantity_values.h"

namespace poinsot::problem {

template <class Scalar, class Base>
Value<Scalar> QuantityScope<Scalar, Base>::kinematic(const Call& call, const Evaluator<Scalar>& evaluator) {
  const std::string_view f = call.function;
  const Expression& what = call.arguments[0].value;
  using Kind = ToldQuantity::Kind;
  const auto told = [&](Kind kind, int body, int from, const Vector& place, const Vector& value,
                        const Dimension& dimension) {
    // Particles that fly on their own are of no body.
    if (tells() && (body != whole_system || flying_.empty()))
      told_->push_back({.kind = kind,
                        .body = body,
                        .from = from,
                        .place = plain_vector(place),
                        .value = plain_vector(value),
                        .words = call.function,
                        .as_rate = tells_rates,
                        .place_rate = rate_of(place),
                        .value_rate = rate_of(value)});
    return vector_value(value, dimension);
  };
  const Vector nowhere = Vector::zero();
  if (f == "center") {
    const int body = body_of(what, evaluator, true);
    return told(Kind::center, body, ground, nowhere, mass_center_of(body, what, evaluator), dimensions::length);
  }
  if (f == "position") {
    if (plain_name(what) && !machine_.index.contains(plain_name(what)->name))
      return vector_value(place(what, evaluator), dimensions::length);
    const Riding point = riding(what, evaluator);
    const Vector now = point_position(model_, workspace_, point.body, point.local);
    tell_position(point.body, point.drawn, now, call.function);
    return vector_value(now, dimensions::length);
  }
  if ((f == "acceleration" || f == "angular_acceleration") && !has_accelerations_)
    evaluator.fail(what.mark(), call.function + " cannot stand inside rate() or among what is known of the velocities");
  const Expression* relative_to = call.argument("relative to");
  const int frame = relative_to ? body_of(*relative_to, evaluator) : ground;
  const BodyMotion<Scalar>& F = workspace_.motion[static_cast<std::size_t>(frame + 1)];
  if (f == "angular_velocity") {
    const int body = body_of(what, evaluator);
    return told(Kind::angular_velocity, body, frame, nowhere, Vector(angular_velocity(workspace_, body) - F.w),
                dimensions::angular_velocity);
  }
  if (f == "angular_acceleration") {
    const int body = body_of(what, evaluator);
    return told(Kind::angular_acceleration, body, ground, nowhere, Vector(angular_acceleration(workspace_, body)),
                dimensions::angular_acceleration);
  }
  // The velocity of the system is that of its mass center.
  if (const Name* name = plain_name(what); name && name->name == "system" && f == "velocity") {
    Vector momentum = poinsot::momentum(model_, workspace_, Vector::zero()).linear;
    Scalar mass = total_mass(model_);
    for (const FlyingParticle<Base>& particle : flying_) {
      momentum = momentum + lifted<Scalar>(particle.mass) * lifted<Scalar>(particle.velocity);
      mass = mass + lifted<Scalar>(particle.mass);
    }
    return told(Kind::velocity, whole_system, ground, nowhere, momentum / mass, dimensions::velocity);
  }
  const Riding point = riding(what, evaluator);
  const Vector place = point_position(model_, workspace_, point.body, point.local), r = place - F.p;
  tell_position(point.body, point.drawn, place, call.function);
  const Vector v = point_velocity(model_, workspace_, point.body, point.local) - F.v - cross(F.w, r);
  if (f == "velocity") return told(Kind::velocity, point.body, frame, place, v, dimensions::velocity);
  require_one_of(f, {"acceleration"});
  const Vector a = point_acceleration(model_, workspace_, point.body, point.local) - F.a - cross(F.alpha, r) -
                   cross(F.w, cross(F.w, r)) - Scalar(2) * cross(F.w, v);
  return told(Kind::acceleration, point.body, frame, place, a, dimensions::acceleration);
}

template <class Scalar, class Base>
void QuantityScope<Scalar, Base>::tell_position(int body, const std::optional<Vector3<Base>>& drawn,
                                                const Vector& position, const std::string& words) {
  if (!tells()) return;
  // What is no place of the figure is the mass center of the body.
  told_->push_back({.kind = drawn ? ToldQuantity::Kind::position : ToldQuantity::Kind::center,
                    .body = body,
                    .first = drawn ? plain_vector(lifted<Scalar>(*drawn)) : Vector3<double>::zero(),
                    .value = plain_vector(position),
                    .words = words,
                    .as_rate = tells_rates,
                    .value_rate = rate_of(position)});
}

template <class Scalar, class Base>
void QuantityScope<Scalar, Base>::tell_direction(int body, const Vector3<Base>& drawn, const Vector& direction,
                                                 const std::string& words) {
  if (!tells()) return;
  told_->push_back({.kind = ToldQuantity::Kind::direction,
                    .body = body,
                    .first = plain_vector(lifted<Scalar>(drawn)),
                    .value = plain_vector(direction),
                    .words = words,
                    .as_rate = tells_rates,
                    .value_rate = rate_of(direction)});
}

template <class Scalar, class Base>
void QuantityScope<Scalar, Base>::tell_geometry(ToldQuantity::Kind kind, const Vector& place, const Vector& first,
                                                const Vector& second, const Scalar& value, const std::string& words) {
  if (!tells() || tells_rates) return;
  told_->push_back({.kind = kind,
                    .place = plain_vector(place),
                    .first = plain_vector(first),
                    .second = plain_vector(second),
                    .value = {plain(value), 0, 0},
                    .words = words});
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
  const std::string_view f = call.function;
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
    const Direction<Base>& axis = *found->second.axis;
    const Vector now = direction_on_ground(model_, workspace_, axis.body, lifted<Scalar>(axis.vector));
    tell_direction(axis.body, axis.vector, now, call.function);
    return vector_value(now, dimensions::none);
  }
  if (f == "direction_angles") {
    const Result v = evaluator(what);
    if (!v.is_vector()) evaluator.fail(what.mark(), "direction angles are asked of a vector");
    const Scalar size = norm(v.vector);
    if (!(plain(size) > 0))
      throw UnansweredError(evaluator.file(), what.mark(), "the zero vector has no direction angles");
    std::vector<Result> items;
    for (std::size_t k = 0; k < 3; ++k) {
      Scalar cosine = dot(v.vector, axes_.column(k)) / size;
      if (plain(cosine) > 1) cosine = Scalar(1);
      if (plain(cosine) < -1) cosine = Scalar(-1);
      items.push_back(number_value(Scalar(acos(cosine)), dimensions::angle));
      tell_geometry(ToldQuantity::Kind::direction_angle, Vector::zero(), v.vector, axes_.column(k), items.back().number,
                    call.function);
    }
    return Result::of_list(std::move(items));
  }
  require_one_of(f, {"distance"});
  const Expression& to = *call.argument("to");
  const Vector A = place(what, evaluator);
  const Call* axis = to.as<Call>();
  const auto told = [&](const Vector& from, const Vector& along, const Scalar& distance) {
    tell_geometry(ToldQuantity::Kind::distance, A, from, along, distance, call.function);
    return number_value(distance, dimensions::length);
  };
  if (to.as<Arrow>() || (axis && axis->function == "axis")) {
    const auto [P, d] = line(Call{"distance", {Argument{"", what}, Argument{"about", to}}}, evaluator);
    return told(P, d, norm(cross(d, Vector(A - P))));
  }
  const Vector B = place(to, evaluator);
  return told(B, Vector::zero(), norm(Vector(B - A)));
}

template Value<double> QuantityScope<double>::kinematic(const Call&, const Evaluator<double>&);
template Value<Dual<1>> QuantityScope<Dual<1>, double>::kinematic(const Call&, const Evaluator<Dual<1>>&);
template Value<Dual<1>> QuantityScope<Dual<1>>::kinematic(const Call&, const Evaluator<Dual<1>>&);
template Value<Dual<1, Dual<1>>> QuantityScope<Dual<1, Dual<1>>, Dual<1>>::kinematic(
    const Call&, const Evaluator<Dual<1, Dual<1>>>&);
template std::pair<Vector3<Dual<1>>, Vector3<Dual<1>>> QuantityScope<Dual<1>>::line(const Call&,
                                                                                    const Evaluator<Dual<1>>&);
template std::pair<Vector3<Dual<1, Dual<1>>>, Vector3<Dual<1, Dual<1>>>> QuantityScope<Dual<1, Dual<1>>, Dual<1>>::line(
    const Call&, const Evaluator<Dual<1, Dual<1>>>&);
template Value<Dual<1>> QuantityScope<Dual<1>>::geometry(const Call&, const Evaluator<Dual<1>>&);
template Value<Dual<1, Dual<1>>> QuantityScope<Dual<1, Dual<1>>, Dual<1>>::geometry(const Call&,
                                                                                    const Evaluator<Dual<1, Dual<1>>>&);
template Value<Formula> QuantityScope<Formula>::kinematic(const Call&, const Evaluator<Formula>&);
template Value<Dual<1, Formula>> QuantityScope<Dual<1, Formula>, Formula>::kinematic(
    const Call&, const Evaluator<Dual<1, Formula>>&);
template std::pair<Vector3<double>, Vector3<double>> QuantityScope<double>::line(const Call&, const Evaluator<double>&);
template std::pair<Vector3<Dual<1>>, Vector3<Dual<1>>> QuantityScope<Dual<1>, double>::line(const Call&,
                                                                                            const Evaluator<Dual<1>>&);
template std::pair<Vector3<Formula>, Vector3<Formula>> QuantityScope<Formula>::line(const Call&,
                                                                                    const Evaluator<Formula>&);
template std::pair<Vector3<Dual<1, Formula>>, Vector3<Dual<1, Formula>>> QuantityScope<Dual<1, Formula>, Formula>::line(
    const Call&, const Evaluator<Dual<1, Formula>>&);
template Value<double> QuantityScope<double>::geometry(const Call&, const Evaluator<double>&);
template Value<Dual<1>> QuantityScope<Dual<1>, double>::geometry(const Call&, const Evaluator<Dual<1>>&);
template Value<Formula> QuantityScope<Formula>::geometry(const Call&, const Evaluator<Formula>&);
template Value<Dual<1, Formula>> QuantityScope<Dual<1, Formula>, Formula>::geometry(const Call&,
                                                                                    const Evaluator<Dual<1, Formula>>&);
template void QuantityScope<double>::tell_position(int, const std::optional<Vector3<double>>&, const Vector3<double>&,
                                                   const std::string&);
template void QuantityScope<double>::tell_direction(int, const Vector3<double>&, const Vector3<double>&,
                                                    const std::string&);
template void QuantityScope<double>::tell_geometry(ToldQuantity::Kind, const Vector3<double>&, const Vector3<double>&,
                                                   const Vector3<double>&, const double&, const std::string&);
template void QuantityScope<Dual<1>, double>::tell_position(int, const std::optional<Vector3<double>>&,
                                                            const Vector3<Dual<1>>&, const std::string&);
template void QuantityScope<Dual<1>, double>::tell_direction(int, const Vector3<double>&, const Vector3<Dual<1>>&,
                                                             const std::string&);
template void QuantityScope<Dual<1>, double>::tell_geometry(ToldQuantity::Kind, const Vector3<Dual<1>>&,
                                                            const Vector3<Dual<1>>&, const Vector3<Dual<1>>&,
                                                            const Dual<1>&, const std::string&);
template void QuantityScope<Dual<1>>::tell_position(int, const std::optional<Vector3<Dual<1>>>&,
                                                    const Vector3<Dual<1>>&, const std::string&);
template void QuantityScope<Dual<1>>::tell_direction(int, const Vector3<Dual<1>>&, const Vector3<Dual<1>>&,
                                                     const std::string&);
template void QuantityScope<Dual<1>>::tell_geometry(ToldQuantity::Kind, const Vector3<Dual<1>>&,
                                                    const Vector3<Dual<1>>&, const Vector3<Dual<1>>&, const Dual<1>&,
                                                    const std::string&);
template void QuantityScope<Dual<1, Dual<1>>, Dual<1>>::tell_position(int, const std::optional<Vector3<Dual<1>>>&,
                                                                      const Vector3<Dual<1, Dual<1>>>&,
                                                                      const std::string&);
template void QuantityScope<Dual<1, Dual<1>>, Dual<1>>::tell_direction(int, const Vector3<Dual<1>>&,
                                                                       const Vector3<Dual<1, Dual<1>>>&,
                                                                       const std::string&);
template void QuantityScope<Dual<1, Dual<1>>, Dual<1>>::tell_geometry(ToldQuantity::Kind,
                                                                      const Vector3<Dual<1, Dual<1>>>&,
                                                                      const Vector3<Dual<1, Dual<1>>>&,
                                                                      const Vector3<Dual<1, Dual<1>>>&,
                                                                      const Dual<1, Dual<1>>&, const std::string&);
template void QuantityScope<Formula>::tell_position(int, const std::optional<Vector3<Formula>>&,
                                                    const Vector3<Formula>&, const std::string&);
template void QuantityScope<Formula>::tell_direction(int, const Vector3<Formula>&, const Vector3<Formula>&,
                                                     const std::string&);
template void QuantityScope<Formula>::tell_geometry(ToldQuantity::Kind, const Vector3<Formula>&,
                                                    const Vector3<Formula>&, const Vector3<Formula>&, const Formula&,
                                                    const std::string&);
template void QuantityScope<Dual<1, Formula>, Formula>::tell_position(int, const std::optional<Vector3<Formula>>&,
                                                                      const Vector3<Dual<1, Formula>>&,
                                                                      const std::string&);
template void QuantityScope<Dual<1, Formula>, Formula>::tell_direction(int, const Vector3<Formula>&,
                                                                       const Vector3<Dual<1, Formula>>&,
                                                                       const std::string&);
template void QuantityScope<Dual<1, Formula>, Formula>::tell_geometry(ToldQuantity::Kind,
                                                                      const Vector3<Dual<1, Formula>>&,
                                                                      const Vector3<Dual<1, Formula>>&,
                                                                      const Vector3<Dual<1, Formula>>&,
                                                                      const Dual<1, Formula>&, const std::string&);

}  // namespace poinsot::problem
