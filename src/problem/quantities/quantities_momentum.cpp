// Mass, weight, momenta (Eqs. 18.7, 18.11) and energies (Eq. 18.17).
#include <optional>
#include <string>
#include <string_view>

#include "poinsot/engine/dynamics/mechanism.h"
#include "problem/language/diagnostic.h"
#include "problem/language/exact_numbers.h"
#include "problem/quantities/quantities.h"
#include "problem/quantities/quantity_values.h"

namespace poinsot::problem {
namespace {

// What the springs of a name store, or those at the freedoms of the joint of that name, or if it is empty all springs;
// nothing if there are none. The workspace has its poses at the state.
template <class Scalar, class Base>
std::optional<Scalar> energy_of_springs(const Mechanism<Base>& mechanism, const std::string& name,
                                        const Model<Scalar>& model, const Workspace<Scalar>& workspace,
                                        const State<Scalar>& state) {
  const auto lift = [](const Base& x) { return lifted<Scalar>(x); };
  const LawConverter<Scalar, decltype(lift)> to{lift};
  std::optional<Scalar> energy;
  const auto add = [&](const Scalar& stored) { energy = energy ? Scalar(*energy + stored) : stored; };
  const auto action_of = [&](const auto& law) -> const Action& {
    return mechanism.actions[static_cast<std::size_t>(law.action)];
  };
  for (const Drive<Base>& drive : mechanism.drives)
    if (drive.stores() && (name.empty() || action_of(drive).joint == name))
      add(drive.template converted<Scalar>(to).stored_energy(state));
  for_each_law(mechanism, [&](const auto& law) {
    if (action_of(law).kind == ActionKind::attraction) return;
    if (law.stores() && (name.empty() || action_of(law).name == name))
      add(law.template converted<Scalar>(to).stored_energy(model, workspace));
  });
  return energy;
}

// The potential energy of a body, or of all, in the pull of a center; zero infinitely far from it.
template <class Scalar, class Base>
Scalar energy_of_pulls(const Mechanism<Base>& mechanism, int body, const Model<Scalar>& model,
                       const Workspace<Scalar>& workspace) {
  const auto lift = [](const Base& x) { return lifted<Scalar>(x); };
  const LawConverter<Scalar, decltype(lift)> to{lift};
  Scalar energy(0);
  for (const AttractionLaw<Base>& pull : mechanism.attractions)
    if (body == whole_system || pull.at.body == body)
      energy = energy + pull.template converted<Scalar>(to).stored_energy(model, workspace);
  return energy;
}
// How hard a center pulls a body.
template <class Scalar, class Base>
Scalar size_of_pull(const Mechanism<Base>& mechanism, int body, const Model<Scalar>& model,
                    const Workspace<Scalar>& workspace) {
  const auto lift = [](const Base& x) { return lifted<Scalar>(x); };
  const LawConverter<Scalar, decltype(lift)> to{lift};
  Vector3<Scalar> force = Vector3<Scalar>::zero();
  for (const AttractionLaw<Base>& pull : mechanism.attractions)
    if (pull.at.body == body) force = force + pull.template converted<Scalar>(to).exerted(model, workspace).force;
  return norm(force);
}

}  // namespace

template <class Scalar, class Base>
Value<Scalar> QuantityScope<Scalar, Base>::momentum(const Call& call, const Evaluator<Scalar>& evaluator) {
  const std::string_view f = call.function;
  const Expression& what = call.arguments[0].value;
  const auto told_springs = [&](const std::string& name, const Scalar& energy) {
    const Vector value{energy, Scalar(0), Scalar(0)};
    if (tells())
      told_->push_back({.kind = ToldQuantity::Kind::spring_energy,
                        .body = whole_system,
                        .value = plain_vector(value),
                        .words = call.function,
                        .name = name,
                        .as_rate = tells_rates,
                        .value_rate = rate_of(value)});
  };
  if (const Name* name = plain_name(what); name && f == "potential_energy" && !machine_.index.contains(name->name))
    if (const auto energy = energy_of_springs(machine_.mechanism, name->name, model_, workspace_, state_)) {
      told_springs(name->name, *energy);
      return number_value(*energy, dimensions::energy);
    }
  const int body = body_of(what, evaluator, true);
  if (body == ground) evaluator.fail(what.mark(), "the ground has no " + call.function);
  const bool all = body == whole_system;
  using Kind = ToldQuantity::Kind;
  // Particles that fly on their own are of no body.
  const auto told = [&](Kind kind, const Vector& place, const Vector& value) {
    if (tells() && (!all || flying_.empty()))
      told_->push_back({.kind = kind,
                        .body = body,
                        .place = plain_vector(place),
                        .value = plain_vector(value),
                        .words = call.function,
                        .as_rate = tells_rates,
                        .place_rate = rate_of(place),
                        .value_rate = rate_of(value)});
  };
  const auto told_number = [&](Kind kind, const Scalar& value) {
    told(kind, Vector::zero(), {value, Scalar(0), Scalar(0)});
  };
  // The contributions of flying particles to the system.
  Scalar flying_mass(0), flying_energy(0), flying_height(0);
  const auto flying_momentum = [&](const Vector& P) {
    Momentum<Scalar> total{Vector::zero(), Vector::zero()};
    for (const FlyingParticle<Base>& particle : flying_) {
      if (!all) break;
      const Vector p = lifted<Scalar>(particle.mass) * lifted<Scalar>(particle.velocity);
      total.linear = total.linear + p;
      total.angular = total.angular + cross(lifted<Scalar>(particle.position) - P, p);
    }
    return total;
  };
  for (const FlyingParticle<Base>& particle : flying_) {
    if (!all) break;
    const Scalar mass = lifted<Scalar>(particle.mass);
    flying_mass = flying_mass + mass;
    flying_energy = flying_energy + Scalar(0.5) * mass * norm_squared(lifted<Scalar>(particle.velocity));
    flying_height = flying_height + mass * dot(model_.gravity(), lifted<Scalar>(particle.position));
  }
  if (f == "mass" || f == "weight") {
    const Scalar mass = all ? Scalar(total_mass(model_) + flying_mass) : model_.body(body).inertia.mass;
    told_number(Kind::mass, mass);
    if (f == "mass") return number_value(mass, dimensions::mass);
    if (situation_.central_gravity) {
      if (all)
        evaluator.fail(what.mark(),
                       "the center pulls each body along a way of its own, and the whole has no one weight",
                       "ask for the weight of a body, or for force(gravity on BODY)");
      const Scalar pull = size_of_pull(machine_.mechanism, body, model_, workspace_);
      told_number(Kind::weight, pull);
      return number_value(pull, dimensions::force);
    }
    const Scalar weight = mass * data_.gravity_size();
    told_number(Kind::weight, weight);
    return number_value(weight, dimensions::force);
  }
  if (f == "momentum") {
    const auto total = all ? poinsot::momentum(model_, workspace_, Vector::zero())
                           : body_momentum(model_, workspace_, body, Vector::zero());
    const Vector linear = total.linear + flying_momentum(Vector::zero()).linear;
    told(Kind::momentum, Vector::zero(), linear);
    return vector_value(linear, dimensions::momentum);
  }
  if (f == "angular_momentum") {
    const Vector P = place(*call.argument("about"), evaluator);
    const auto total = all ? poinsot::momentum(model_, workspace_, P) : body_momentum(model_, workspace_, body, P);
    const Vector angular = total.angular + flying_momentum(P).angular;
    told(Kind::angular_momentum, P, angular);
    return vector_value(angular, dimensions::angular_momentum);
  }
  if (f == "potential_energy") {
    Scalar sum = -flying_height;
    for (int i = 0; i < model_.body_count(); ++i)
      if ((all || i == body) && plain(model_.body(i).inertia.mass) > 0)
        sum = sum - model_.body(i).inertia.mass * dot(model_.gravity(), body_mass_center(model_, workspace_, i));
    sum = sum + energy_of_pulls(machine_.mechanism, all ? whole_system : body, model_, workspace_);
    told_number(Kind::height_energy, sum);
    if (all)
      if (const auto energy = energy_of_springs(machine_.mechanism, "", model_, workspace_, state_)) {
        told_springs("", *energy);
        sum = sum + *energy;
      }
    return number_value(sum, dimensions::energy);
  }
  require_one_of(f, {"kinetic_energy"});
  const Scalar T = all ? Scalar(poinsot::kinetic_energy(model_, workspace_) + flying_energy)
                       : body_kinetic_energy(model_, workspace_, body);
  if (const Expression* about = call.argument("about")) {
    const Vector P = place(*about, evaluator), G = mass_center_of(body, what, evaluator);
    // A place that is stated in another way differs by the rounding of the lengths from which both are computed.
    constexpr double same_place = 1e-9;
    double length = plain(norm(P)) + plain(norm(G));
    for (int i = 0; i < model_.body_count(); ++i)
      if (plain(model_.body(i).inertia.mass) > 0)
        length = std::max(length, plain(norm(body_mass_center(model_, workspace_, i))));
    if (plain(norm(P - G)) > same_place * length)
      evaluator.fail(about->mark(), "the kinetic energy of the motion about a point is meant about the mass center",
                     "write kinetic_energy(" + to_string(what) + " about center(" + to_string(what) + "))");
    const Vector L =
        (all ? poinsot::momentum(model_, workspace_, P) : body_momentum(model_, workspace_, body, P)).linear +
        flying_momentum(P).linear;
    const Scalar mass = all ? Scalar(total_mass(model_) + flying_mass) : model_.body(body).inertia.mass;
    const Scalar within = T - Scalar(0.5) * norm_squared(L) / mass;
    told_number(Kind::kinetic_energy_within, within);
    return number_value(within, dimensions::energy);
  }
  told_number(Kind::kinetic_energy, T);
  return number_value(T, dimensions::energy);
}

template Value<double> QuantityScope<double>::momentum(const Call&, const Evaluator<double>&);
template Value<Dual<1>> QuantityScope<Dual<1>, double>::momentum(const Call&, const Evaluator<Dual<1>>&);
template Value<Dual<1>> QuantityScope<Dual<1>>::momentum(const Call&, const Evaluator<Dual<1>>&);
template Value<Dual<1, Dual<1>>> QuantityScope<Dual<1, Dual<1>>, Dual<1>>::momentum(const Call&,
                                                                                    const Evaluator<Dual<1, Dual<1>>>&);
template Value<Formula> QuantityScope<Formula>::momentum(const Call&, const Evaluator<Formula>&);
template Value<Dual<1, Formula>> QuantityScope<Dual<1, Formula>, Formula>::momentum(const Call&,
                                                                                    const Evaluator<Dual<1, Formula>>&);

}  // namespace poinsot::problem
