#include "problem/machine/masses.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <optional>

#include "poinsot/engine/mass/composition.h"
#include "poinsot/engine/mass/particles.h"
#include "poinsot/engine/mass/validity.h"
#include "poinsot/engine/math/algebra/plain.h"
#include "problem/language/diagnostic.h"
#include "problem/language/exact_numbers.h"
#include "problem/machine/part_masses.h"
#include "problem/machine/shapes.h"

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
  MassReader(const Body& body, DataScope<Scalar>& data, const AnyValue& any, bool lenient)
      : body_(body), data_(data), any_(any), lenient_(lenient) {}

  BodyMassOf<Scalar> of_shapes();
  BodyMassOf<Scalar> of_numbers();
  void absorb(BodyMassOf<Scalar>& whole);
  // The parts that of_shapes, of_numbers and absorb have put together.
  std::vector<MassProperties<Scalar>> parts() && { return std::move(parts_); }

 private:
  using Vector = Vector3<Scalar>;

  const std::string& file() const { return data_.situation().file; }

  // Particles are made for plain numbers, and only if the answer will be checked with them.
  bool wants_particles() const { return std::same_as<Scalar, double> && !lenient_; }

  Scalar number(const Expression& expression, const Dimension& dimension) {
    return is_any(expression) ? Scalar(any_(dimension)) : data_.number(expression, dimension);
  }
  Scalar positive(const Expression& expression, const Dimension& dimension, const std::string& what) {
    const Scalar value = number(expression, dimension);
    if (!lenient_ && !(plain(value) >= 0))
      fail(file(), expression.mark(), what + " is negative", "a part that is cut out has hole: true");
    return value;
  }
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
    if (is_any(expression)) return Scalar(any_(dimension));
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
  Matrix3<Scalar> axes_of(const StatedInertia& inertia) {
    if (inertia.axes.empty()) return Matrix3<Scalar>::identity();
    if (inertia.axes.size() != 3) fail(file(), inertia.mark, "axes are three directions");
    Vector a[3];
    for (int i = 0; i < 3; ++i) a[i] = data_.direction(inertia.axes[i]);
    for (int i = 0; i < 3; ++i)
      if (std::abs(plain(dot(a[i], a[(i + 1) % 3]))) > 1e-9)
        fail(file(), inertia.axes[i].mark(), "the axes are not at right angles");
    if (plain(dot(a[0], cross(a[1], a[2]))) < 0)
      fail(file(), inertia.mark, "the axes are not right-handed", "reverse one of them");
    return Matrix3<Scalar>::from_columns(a[0], a[1], a[2]);
  }
  // arm: from the point of the moments of inertia to the mass center, on the axes of the inertia, m.
  SymmetricMatrix3<Scalar> stated_tensor(const StatedInertia& inertia, const Scalar& mass, const Vector& arm);
  SymmetricMatrix3<Scalar> axisymmetric(const StatedInertia& inertia, const Scalar& mass, const Vector& arm);
  SymmetricMatrix3<Scalar> of_moments(const StatedInertia& inertia, const Scalar& mass, const Vector& arm);
  Scalar moment(const StatedInertia& inertia, const Expression& expression, const Scalar& mass);
  void append(BodyMassOf<Scalar>& whole, std::vector<MassProperties<Scalar>>& list, const ShapeValues<Scalar>& shape,
              const Scalar& mass) const;

  const Body& body_;
  DataScope<Scalar>& data_;
  const AnyValue& any_;
  bool lenient_;
  std::vector<MassProperties<Scalar>> parts_;
};

template <class Scalar>
void MassReader<Scalar>::append(BodyMassOf<Scalar>& whole, std::vector<MassProperties<Scalar>>& list,
                                const ShapeValues<Scalar>& shape, const Scalar& mass) const {
  list.push_back(of_mass(shape.properties, mass));
  if (!wants_particles()) return;
  for (const Particle<double>& particle : particles_of_mass(shape.particles, plain(mass)))
    whole.particles.push_back(particle);
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
    if (std::abs(plain(total - stated_mass)) > 1e-9 * std::abs(plain(total)))
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
    append(whole, list, shapes[i], part.hole ? -mass : mass);
  }
  for (const Part& part : body_.added) {
    const std::string part_owner = "the added '" + part.name + "' of " + owner;
    const ShapeValues<Scalar> shape = shape_values(part.shape, data_, part.name, wants_particles());
    if (!states(part.amount)) fail(file(), part.mark, part_owner + " has no mass", "write mass:");
    append(whole, list, shape, Scalar(part.hole ? -1 : 1) * amount_of(part.amount, shape, part_owner));
  }
  whole.properties = sum(list);
  parts_ = std::move(list);
  return whole;
}

template <class Scalar>
Scalar MassReader<Scalar>::moment(const StatedInertia& inertia, const Expression& expression, const Scalar& mass) {
  const Scalar value = data_.number(expression, inertia.radii ? dimensions::length : dimensions::moment_of_inertia);
  if (!(plain(value) >= 0))
    fail(file(), expression.mark(),
         std::string("a ") + (inertia.radii ? "radius of gyration" : "moment of inertia") + " of body '" + body_.name +
             "' is negative");
  return inertia.radii ? mass * value * value : value;
}

template <class Scalar>
SymmetricMatrix3<Scalar> MassReader<Scalar>::stated_tensor(const StatedInertia& inertia, const Scalar& mass,
                                                           const Vector& arm) {
  if (inertia.matrix) {
    const Dimension dimension = dimensions::moment_of_inertia;
    const Value<Scalar> rows = data_.value(*inertia.matrix);
    if (!rows.is_list() || rows.items.size() != 3)
      fail(file(), inertia.matrix->mark(), "an inertia matrix has three rows of three");
    Matrix3<Scalar> I = Matrix3<Scalar>::zero();
    for (int i = 0; i < 3; ++i) {
      if (!rows.items[i].is_vector() || !(same_kind(rows.items[i].dimension, dimension) || rows.items[i].bare))
        fail(file(), inertia.matrix->mark(), "an inertia matrix has three rows of three moments of inertia");
      I.row(i) = rows.items[i].vector;
    }
    if (const auto report = validate(plain(mass), Vector3<double>::zero(), plain(I), body_.name);
        report && report->rule == MassRule::symmetric_tensor)
      fail(file(), inertia.mark, report->message);
    return symmetric_part(I);
  }
  return inertia.axis ? axisymmetric(inertia, mass, arm) : of_moments(inertia, mass, arm);
}

// Open moments get values that a body with the other moments can have: at the mass center 0 < axial < 2 transverse.
template <class Scalar>
SymmetricMatrix3<Scalar> MassReader<Scalar>::axisymmetric(const StatedInertia& inertia, const Scalar& mass,
                                                          const Vector& arm) {
  const Vector axis = data_.direction(*inertia.axis);
  const Scalar along = dot(arm, axis);
  // The mass center lies on the axis, so that only the transverse moment depends on the point of the axis.
  const Scalar shift = mass * along * along;
  const bool open_axial = is_any(*inertia.axial), open_transverse = is_any(*inertia.transverse);
  Scalar axial = open_axial ? Scalar(0) : moment(inertia, *inertia.axial, mass);
  Scalar transverse = open_transverse ? Scalar(0) : moment(inertia, *inertia.transverse, mass);
  if (open_transverse) {
    const double choice = any_(dimensions::moment_of_inertia);  // from 0.5 to 2
    const Scalar size = open_axial || !(plain(axial) > 0) ? mass : axial;
    transverse = Scalar(0.6 + 0.65 * choice) * size + shift;
  }
  if (open_axial) axial = Scalar(0.3 + 0.4 * any_(dimensions::moment_of_inertia)) * (transverse - shift);
  return axisymmetric_tensor(axis, axial, transverse);
}

template <class Scalar>
SymmetricMatrix3<Scalar> MassReader<Scalar>::of_moments(const StatedInertia& inertia, const Scalar& mass,
                                                        const Vector& arm) {
  const auto open = [&](const std::optional<Expression>& stated) {
    return stated ? is_any(*stated) : inertia.rest_any;
  };
  if (std::ranges::none_of(inertia.moments, [](const auto& stated) { return !stated || is_any(*stated); }) &&
      std::ranges::none_of(inertia.products, open)) {
    Vector moments;
    for (int i = 0; i < 3; ++i) moments[i] = moment(inertia, *inertia.moments[i], mass);
    const auto product = [&](std::size_t i) {
      return inertia.products[i] ? data_.number(*inertia.products[i], dimensions::moment_of_inertia) : Scalar(0);
    };
    ProductsOfInertia<Scalar> products;
    products.xy = product(0);
    products.yz = product(1);
    products.zx = product(2);
    return inertia_tensor(moments, products);
  }
  // All moments are taken at the mass center: those that are known about another point are shifted there (parallel
  // axes).
  const auto magnitude = [](const Scalar& x) { return plain(x) < 0 ? -x : x; };
  const Scalar spread = norm_squared(arm);
  Vector moments = Vector::zero(), products = Vector::zero();  // the products in the order yz, zx, xy
  Vector about_moments = Vector::zero(), about_products = Vector::zero();
  std::array<bool, 3> open_moment{}, open_product{};
  std::optional<Scalar> smallest;
  Scalar size(0);
  for (int i = 0; i < 3; ++i) {
    const std::optional<Expression>& product = inertia.products[static_cast<std::size_t>((i + 1) % 3)];
    open_product[i] = open(product);
    if (!open_product[i]) {
      if (product) about_products[i] = data_.number(*product, dimensions::moment_of_inertia);
      products[i] = about_products[i] - mass * arm[(i + 1) % 3] * arm[(i + 2) % 3];
      size += magnitude(products[i]);
    }
    open_moment[i] = !inertia.moments[i] || is_any(*inertia.moments[i]);
    if (open_moment[i]) continue;
    about_moments[i] = moment(inertia, *inertia.moments[i], mass);
    moments[i] = about_moments[i] - mass * (spread - arm[i] * arm[i]);
    if (!smallest || plain(moments[i]) < plain(*smallest)) smallest = moments[i];
    size += magnitude(moments[i]);
  }
  // Open moments get values that a body with the other moments can have. Two open moments are large and nearly equal;
  // a single one lies between the difference and the sum of the others. If nothing else gives a size, it is that of
  // the mass at a distance of one meter.
  if (!(plain(size) > 0)) size = mass;
  const auto open_moments = std::count(open_moment.begin(), open_moment.end(), true);
  for (int i = 0; i < 3; ++i) {
    if (!open_moment[i]) continue;
    const double choice = any_(dimensions::moment_of_inertia);  // from 0.5 to 2
    const Scalar a = moments[(i + 1) % 3], b = moments[(i + 2) % 3];
    const Scalar difference = magnitude(a - b);
    moments[i] = open_moments == 1
                     ? difference + Scalar(0.2 + 0.3 * choice) * (a + b - difference)
                     : Scalar(8) * size +
                           Scalar(0.25 * choice) * (smallest && plain(*smallest) < plain(size) ? *smallest : size);
  }
  // Let X, Y, Z be the integrals of x^2 dm, y^2 dm, z^2 dm. Beside the other two products, P_yz may differ from P_xy
  // P_zx/X by at most the root of (Y - P_xy^2/X) (Z - P_zx^2/X). In place of this geometric mean the smaller harmonic
  // mean is taken, which needs no root.
  Vector second;
  for (int i = 0; i < 3; ++i) {
    second[i] = Scalar(0.5) * (moments[(i + 1) % 3] + moments[(i + 2) % 3] - moments[i]);
    if (!(plain(second[i]) > 0)) second[i] = Scalar(0);
  }
  for (int i = 0; i < 3; ++i) {
    if (!open_product[i]) continue;
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    const bool after_both = (!open_product[j] || j < i) && (!open_product[k] || k < i) && plain(second[i]) > 0;
    Scalar middle(0), one = second[j], other = second[k];
    if (after_both) {
      middle = products[j] * products[k] / second[i];
      one -= products[k] * products[k] / second[i];
      other -= products[j] * products[j] / second[i];
    }
    const double aside = 0.5 * (any_(dimensions::moment_of_inertia) - 1);  // from -0.25 to 0.5
    const bool free = plain(one) > 0 && plain(other) > 0;
    products[i] = free ? middle + Scalar(2 * aside) * one * other / (one + other) : middle;
  }
  for (int i = 0; i < 3; ++i) {
    if (open_moment[i]) about_moments[i] = moments[i] + mass * (spread - arm[i] * arm[i]);
    if (open_product[i]) about_products[i] = products[i] + mass * arm[(i + 1) % 3] * arm[(i + 2) % 3];
  }
  ProductsOfInertia<Scalar> named;
  named.yz = about_products[0];
  named.zx = about_products[1];
  named.xy = about_products[2];
  return inertia_tensor(about_moments, named);
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
    const Matrix3<Scalar> axes = axes_of(inertia);
    const Vector arm =
        inertia.about ? transpose_times(axes, Vector(center - data_.place(*inertia.about))) : Vector::zero();
    tensor = rotated(axes, stated_tensor(inertia, mass, arm));
    if (inertia.about) {
      const Vector about = data_.place(*inertia.about);
      whole.properties = from_inertia_about(about, mass, center, tensor);
    } else {
      whole.properties = {mass, center, tensor};
    }
  } else {
    whole.properties = {mass, center, tensor};
  }
  if (!lenient_)
    if (const auto report = validate(plain(whole.properties), body_.name))
      fail(file(), body_.inertia ? body_.inertia->mark : body_.mark, report->message);
  if (wants_particles()) whole.particles = equivalent_particles(plain(whole.properties));
  std::vector<MassProperties<Scalar>> list{whole.properties};
  for (const Part& part : body_.added) {
    const ShapeValues<Scalar> shape = shape_values(part.shape, data_, part.name, wants_particles());
    if (!states(part.amount))
      fail(file(), part.mark, "the added '" + part.name + "' of " + owner + " has no mass", "write mass:");
    append(whole, list, shape,
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
    append(whole, list, shape, amount_of(part.amount, shape, "the particle of strike '" + part.name + "'"));
  }
  whole.properties = sum(list);
  parts_.insert(parts_.end(), list.begin() + 1, list.end());
}

}  // namespace

template <class Scalar>
BodyMassOf<Scalar> body_mass(const Body& body, DataScope<Scalar>& data, const AnyValue& any, bool lenient) {
  if (body.massless) return {massless<Scalar>(), Vector3<Scalar>::zero(), {}};
  MassReader<Scalar> reader(body, data, any, lenient);
  BodyMassOf<Scalar> result = body.parts.empty() ? reader.of_numbers() : reader.of_shapes();
  result.center = result.properties.center;
  reader.absorb(result);
  if (lenient) return result;
  if (const auto report = validate(plain(result.properties), body.name))
    fail(data.situation().file, body.mark, report->message);
  return result;
}

template <class Scalar>
std::vector<MassProperties<Scalar>> part_masses(const Body& body, DataScope<Scalar>& data) {
  if (body.massless) return {};
  const AnyValue none = [&](const Dimension&) -> double {
    fail(data.situation().file, body.mark, "a part of body '" + body.name + "' has any value");
  };
  MassReader<Scalar> reader(body, data, none, true);
  BodyMassOf<Scalar> whole = body.parts.empty() ? reader.of_numbers() : reader.of_shapes();
  reader.absorb(whole);
  return std::move(reader).parts();
}

template std::vector<MassProperties<double>> part_masses(const Body&, DataScope<double>&);
template std::vector<MassProperties<Formula>> part_masses(const Body&, DataScope<Formula>&);
template BodyMassOf<double> body_mass(const Body&, DataScope<double>&, const AnyValue&, bool);
template BodyMassOf<Dual<1>> body_mass(const Body&, DataScope<Dual<1>>&, const AnyValue&, bool);
template BodyMassOf<Formula> body_mass(const Body&, DataScope<Formula>&, const AnyValue&, bool);

}  // namespace poinsot::problem
