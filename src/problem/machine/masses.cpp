#include "problem/machine/masses.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <optional>

#include "poinsot/engine/mass/composition.h"
#include "poinsot/engine/mass/particles.h"
#include "poinsot/engine/math/algebra/plain.h"
#include "poinsot/engine/work/work.h"
#include "problem/language/diagnostic.h"
#include "problem/language/exact_numbers.h"
#include "problem/machine/shapes.h"
#include "problem/machine/stated_sizes.h"

namespace poinsot::problem {
namespace {

using poinsot::plain;

template <class Scalar>
MassProperties<double> plain(const MassProperties<Scalar>& body) {
  return {plain(body.mass), plain(body.center), plain(body.inertia_center)};
}

template <class Scalar>
class MassReader {
 public:
  MassReader(const Body& body, DataScope<Scalar>& data, const AnyValue& any, bool lenient, bool particles)
      : body_(body), data_(data), any_(any), lenient_(lenient), particles_(particles) {}

  BodyMassOf<Scalar> of_shapes();
  BodyMassOf<Scalar> of_numbers();
  void absorb(BodyMassOf<Scalar>& whole);
  // The parts that of_shapes, of_numbers and absorb have put together.
  std::vector<MassProperties<Scalar>> parts() && { return std::move(parts_); }

 private:
  using Vector = Vector3<Scalar>;

  const std::string& file() const { return data_.situation().file; }

  // Particles are made for plain numbers, and only if the answer will be checked with them.
  bool wants_particles() const { return std::same_as<Scalar, double> && (!lenient_ || particles_); }

  Scalar number(const Expression& expression, const Dimension& dimension) {
    return is_any(expression) ? open(dimension) : data_.number(expression, dimension);
  }
  Scalar positive(const Expression& expression, const Dimension& dimension, const std::string& what) {
    Scalar value = number(expression, dimension);
    if (!lenient_ && !(plain(value) >= 0))
      fail(file(), expression.mark(), what + " is negative", "a part that is cut out has hole: true");
    return value;
  }
  // A value for what is left open, as large as what is stated, so that neither drowns in the other's rounding.
  Scalar open(const Dimension& dimension) { return Scalar(any_(dimension) * stated_size(data_, dimension)); }
  // A weight under mass: or a mass under weight: is a common mistake and gets a message of its own.
  Scalar mass_of(const Expression& expression, const std::string& owner) {
    if (!is_any(expression)) {
      const Value<Scalar> value = data_.value(expression);
      if (value.is_number() && same_kind(value.dimension, dimensions::force)) {
        const Number* literal = expression.as<Number>();
        const std::string text = literal ? literal->text : "...";
        std::string other;
        if (literal && literal->unit.text == "lb") other = " or mass: " + text.substr(0, text.size() - 2) + "lbm";
        if (literal && literal->unit.text == "oz") other = " or mass: " + text.substr(0, text.size() - 2) + "ozm";
        fail(file(), expression.mark(), "the mass of " + owner + " is given as a force",
             "write weight: " + text + other);
      }
    }
    return positive(expression, dimensions::mass, "the mass of " + owner);
  }
  Scalar weight_of(const Expression& expression, const std::string& owner) {
    if (!is_any(expression)) {
      const Value<Scalar> value = data_.value(expression);
      if (value.is_number() && same_kind(value.dimension, dimensions::mass))
        fail(file(), expression.mark(), "the weight of " + owner + " is given as a mass",
             "write mass: " + to_string(expression));
    }
    return positive(expression, dimensions::force, "the weight of " + owner) / data_.gravity_size();
  }
  // The mass per length, area or volume.
  Scalar density_of(const Expression& expression, Extent extent, bool weight, const std::string& owner) {
    if (extent == Extent::point)
      fail(file(), expression.mark(), owner + " is a particle: it has no density", "write mass:");
    const int power = extent == Extent::length ? 1 : extent == Extent::area ? 2 : 3;
    Dimension dimension = (weight ? dimensions::force : dimensions::mass) / Dimension::of(power, 0, 0);
    if (is_any(expression)) return open(dimension);
    const Value<Scalar> value = data_.value(expression);
    if (!value.is_number() || !same_kind(value.dimension, dimension)) {
      static constexpr std::array<const char*, 4> words{"", "length", "area", "volume"};
      fail(file(), expression.mark(),
           "the " + std::string(weight ? "specific weight" : "density") + " of " + owner + " is " +
               to_string(value.dimension) + "; expected " + (weight ? "weight" : "mass") + " per " + words[power],
           weight ? "" : "a weight per length, area or volume stands under specific_weight:");
    }
    if (!(plain(value.number) >= 0)) fail(file(), expression.mark(), "the density of " + owner + " is negative");
    return weight ? value.number / data_.gravity_size() : value.number;
  }
  bool states(const Amount& amount) const {
    return amount.mass || amount.weight || amount.density || amount.specific_weight;
  }
  Scalar amount_of(const Amount& amount, const ShapeValues<Scalar>& shape, const std::string& owner) {
    if (amount.mass) return mass_of(*amount.mass, owner);
    if (amount.weight) return weight_of(*amount.weight, owner);
    if (amount.density) return density_of(*amount.density, shape.extent, false, owner) * shape.properties.measure;
    return density_of(*amount.specific_weight, shape.extent, true, owner) * shape.properties.measure;
  }
  void append(BodyMassOf<Scalar>& whole, std::vector<MassProperties<Scalar>>& list, const Part& part,
              const ShapeValues<Scalar>& shape, const Scalar& mass) const;
  bool in_central_gravity() const { return data_.situation().central_gravity.has_value(); }

  const Body& body_;
  DataScope<Scalar>& data_;
  const AnyValue& any_;
  bool lenient_, particles_;
  std::vector<MassProperties<Scalar>> parts_;
};

template <class Scalar>
void MassReader<Scalar>::append(BodyMassOf<Scalar>& whole, std::vector<MassProperties<Scalar>>& list, const Part& part,
                                const ShapeValues<Scalar>& shape, const Scalar& mass) const {
  list.push_back(of_mass(shape.properties, mass));
  if (in_central_gravity()) {
    const bool round = part.shape.kind == "sphere" || part.shape.kind == "sphere_shell";
    whole.pulled.push_back(
        {list.back(), &part, shape.extent != Extent::point && !round, shape.particles.particles.size()});
  }
  if (!wants_particles()) return;
  constexpr Work of_a_particle = 20;
  whole.particles.reserve(whole.particles.size() + shape.particles.particles.size());
  for (const WeightedParticle<double>& particle : shape.particles.particles) {
    count_work(of_a_particle);
    whole.particles.push_back({plain(mass) * particle.fraction, particle.position});
  }
}

template <class Scalar>
BodyMassOf<Scalar> MassReader<Scalar>::of_shapes() {
  BodyMassOf<Scalar> whole;
  std::vector<MassProperties<Scalar>> list;
  const std::string owner = "body '" + body_.name + "'";
  std::vector<ShapeValues<Scalar>> shapes;
  Scalar shared_measure(0), stated_mass(0);
  std::optional<Extent> shared_extent;
  for (const Part& part : body_.parts) {
    shapes.push_back(shape_values(part.shape, data_, part.name, wants_particles()));
    const ShapeValues<Scalar>& shape = shapes.back();
    const std::string part_owner = body_.parts.size() == 1 ? owner : "part '" + part.name + "' of " + owner;
    const Scalar sign(part.hole ? -1 : 1);
    if (states(part.amount)) {
      stated_mass += sign * amount_of(part.amount, shape, part_owner);
      continue;
    }
    if (body_.amount.density || body_.amount.specific_weight) continue;
    if (!states(body_.amount)) fail(file(), part.mark, part_owner + " has no mass", "write mass:, weight: or density:");
    if (shared_extent && *shared_extent != shape.extent)
      fail(file(), part.mark,
           "the parts of " + owner + " have lengths, areas and volumes: its mass cannot be shared among them",
           "state the mass of each part");
    if (shape.extent == Extent::point && body_.parts.size() > 1)
      fail(file(), part.mark, part_owner + " is a particle without mass", "state its mass");
    shared_extent = shape.extent;
    shared_measure += sign * shape.properties.measure;
  }
  Scalar shared_mass(0);
  if (shared_extent) {
    const Scalar total =
        body_.amount.mass ? mass_of(*body_.amount.mass, owner) : weight_of(*body_.amount.weight, owner);
    shared_mass = total - stated_mass;
    if (plain(shared_mass) < 0) fail(file(), body_.mark, "the parts of " + owner + " weigh more than the whole");
    if (*shared_extent != Extent::point && !(plain(shared_measure) > 0))
      fail(file(), body_.mark, "the holes of " + owner + " leave nothing of it");
  } else if (body_.amount.mass || body_.amount.weight) {
    const Scalar total =
        body_.amount.mass ? mass_of(*body_.amount.mass, owner) : weight_of(*body_.amount.weight, owner);
    constexpr double same_mass = 1e-9;  // of the whole: thirds of it are stated with nine digits
    if (std::abs(plain(total - stated_mass)) > same_mass * std::abs(plain(total)))
      fail(file(), body_.mark, "the masses of the parts of " + owner + " do not add up to its mass",
           "leave one of them out");
  }
  for (std::size_t i = 0; i < body_.parts.size(); ++i) {
    const Part& part = body_.parts[i];
    const std::string part_owner = body_.parts.size() == 1 ? owner : "part '" + part.name + "' of " + owner;
    Scalar mass(0);
    if (states(part.amount))
      mass = amount_of(part.amount, shapes[i], part_owner);
    else if (body_.amount.density || body_.amount.specific_weight)
      mass = amount_of(body_.amount, shapes[i], part_owner);
    else
      mass =
          *shared_extent == Extent::point ? shared_mass : shared_mass * shapes[i].properties.measure / shared_measure;
    append(whole, list, part, shapes[i], part.hole ? -mass : mass);
  }
  for (const Part& part : body_.added) {
    const std::string part_owner = "the added '" + part.name + "' of " + owner;
    const ShapeValues<Scalar> shape = shape_values(part.shape, data_, part.name, wants_particles());
    if (!states(part.amount)) fail(file(), part.mark, part_owner + " has no mass", "write mass:");
    append(whole, list, part, shape, Scalar(part.hole ? -1 : 1) * amount_of(part.amount, shape, part_owner));
  }
  whole.properties = sum(list);
  parts_ = std::move(list);
  return whole;
}

template <class Scalar>
BodyMassOf<Scalar> MassReader<Scalar>::of_numbers() {
  BodyMassOf<Scalar> whole;
  const std::string owner = "body '" + body_.name + "'";
  const Scalar mass = body_.amount.mass ? mass_of(*body_.amount.mass, owner) : weight_of(*body_.amount.weight, owner);
  Vector center = Vector::zero();
  if (const List* list = body_.center->as<List>(); list && list->items.size() == 3)
    for (int i = 0; i < 3; ++i) center[i] = number(list->items[i], dimensions::length);
  else
    center = data_.place(*body_.center);
  SymmetricMatrix3<Scalar> tensor = SymmetricMatrix3<Scalar>::zero();
  if (body_.inertia) {
    const StatedInertia& inertia = *body_.inertia;
    tensor = stated_tensor(inertia, mass, center, {body_.name, data_, any_});
    whole.properties = inertia.about ? from_inertia_about(data_.place(*inertia.about), mass, center, tensor)
                                     : MassProperties<Scalar>{mass, center, tensor};
  } else {
    whole.properties = {mass, center, tensor};
  }
  if (!lenient_ || wants_particles())
    if (const auto report =
            validate(plain(whole.properties), body_.name, usual_tolerance_of_moments, moment_unit(data_.situation())))
      fail(file(), body_.inertia ? body_.inertia->mark : body_.mark, report->message);
  if (wants_particles()) whole.particles = equivalent_particles(plain(whole.properties));
  if (in_central_gravity())
    whole.pulled.push_back({whole.properties, nullptr, body_.inertia.has_value(), whole.particles.size()});
  std::vector<MassProperties<Scalar>> list{whole.properties};
  for (const Part& part : body_.added) {
    const ShapeValues<Scalar> shape = shape_values(part.shape, data_, part.name, wants_particles());
    if (!states(part.amount))
      fail(file(), part.mark, "the added '" + part.name + "' of " + owner + " has no mass", "write mass:");
    append(whole, list, part, shape,
           Scalar(part.hole ? -1 : 1) * amount_of(part.amount, shape, "the added '" + part.name + "' of " + owner));
  }
  whole.properties = sum(list);
  parts_ = std::move(list);
  return whole;
}

template <class Scalar>
void MassReader<Scalar>::absorb(BodyMassOf<Scalar>& whole) {
  if (body_.absorbed.empty()) return;
  std::vector<MassProperties<Scalar>> list{whole.properties};
  for (const Part& part : body_.absorbed) {
    const ShapeValues<Scalar> shape = shape_values(part.shape, data_, part.name, wants_particles());
    append(whole, list, part, shape, amount_of(part.amount, shape, "the particle of strike '" + part.name + "'"));
  }
  whole.properties = sum(list);
  parts_.insert(parts_.end(), list.begin() + 1, list.end());
}

}  // namespace

template <class Scalar>
BodyMassOf<Scalar> body_mass(const Body& body, DataScope<Scalar>& data, const AnyValue& any, bool lenient,
                             bool particles) {
  if (body.massless) return {massless<Scalar>(), Vector3<Scalar>::zero(), {}};
  MassReader<Scalar> reader(body, data, any, lenient, particles);
  BodyMassOf<Scalar> result = body.parts.empty() ? reader.of_numbers() : reader.of_shapes();
  result.center = result.properties.center;
  reader.absorb(result);
  if (lenient) return result;
  if (const auto report =
          validate(plain(result.properties), body.name, usual_tolerance_of_moments, moment_unit(data.situation())))
    fail(data.situation().file, body.mark, report->message);
  return result;
}

MomentUnit moment_unit(const Situation& situation) {
  const Unit unit = situation.habits.unit_for(dimensions::moment_of_inertia);
  return unit.factor == 1 ? MomentUnit{} : MomentUnit{unit.factor, unit.text};
}

template <class Scalar>
std::vector<MassProperties<Scalar>> part_masses(const Body& body, DataScope<Scalar>& data) {
  if (body.massless) return {};
  const AnyValue none = [&](const Dimension&) -> double {
    fail(data.situation().file, body.mark, "a part of body '" + body.name + "' has any value");
  };
  MassReader<Scalar> reader(body, data, none, true, false);
  BodyMassOf<Scalar> whole = body.parts.empty() ? reader.of_numbers() : reader.of_shapes();
  reader.absorb(whole);
  return std::move(reader).parts();
}

template std::vector<MassProperties<double>> part_masses(const Body&, DataScope<double>&);
template std::vector<MassProperties<Formula>> part_masses(const Body&, DataScope<Formula>&);
template BodyMassOf<double> body_mass(const Body&, DataScope<double>&, const AnyValue&, bool, bool);
template BodyMassOf<Dual<1>> body_mass(const Body&, DataScope<Dual<1>>&, const AnyValue&, bool, bool);
template BodyMassOf<Formula> body_mass(const Body&, DataScope<Formula>&, const AnyValue&, bool, bool);

}  // namespace poinsot::problem
