#include "statement/masses.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "poinsot/mass/composition.h"
#include "poinsot/mass/particles.h"
#include "poinsot/mass/principal_axes.h"
#include "poinsot/mass/validity.h"
#include "statement/reader.h"
#include "statement/shapes.h"

namespace poinsot::statement {
namespace {

using Vector = Vector3<double>;

bool is_any(const Expression& expression) {
  const Name* name = expression.as<Name>();
  return name && name->name == "any" && name->primes == 0;
}

class MassReader {
 public:
  MassReader(const Body& body, DataScope<double>& data, const AnyValue& any, bool lenient)
      : body_(body), data_(data), any_(any), lenient_(lenient) {}

  BodyMass of_shapes();
  BodyMass of_numbers();

 private:
  const std::string& file() const { return data_.problem().file; }

  double number(const Expression& expression, const Dimension& dimension) {
    return is_any(expression) ? any_(dimension) : data_.number(expression, dimension);
  }
  double positive(const Expression& expression, const Dimension& dimension, const std::string& what) {
    const double value = number(expression, dimension);
    if (!lenient_ && !(value > 0) && !(value == 0))
      fail(file(), expression.mark(), what + " is negative", "a part that is cut out has hole: true");
    return value;
  }
  // mass: 10 lb and weight: 10 kg are the mistakes that people make.
  double mass_of(const Expression& expression, const std::string& owner) {
    if (!is_any(expression)) {
      const Value<double> value = data_.value(expression);
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
  double weight_of(const Expression& expression, const std::string& owner) {
    if (!is_any(expression)) {
      const Value<double> value = data_.value(expression);
      if (value.is_number() && same_kind(value.dimension, dimensions::mass))
        fail(file(), expression.mark(), "the weight of " + owner + " is given as a mass",
             "write mass: " + to_string(expression));
    }
    return positive(expression, dimensions::force, "the weight of " + owner) / data_.gravity_size();
  }
  // Mass per length, area or volume.
  double density_of(const Expression& expression, Extent extent, bool weight, const std::string& owner) {
    if (extent == Extent::point)
      fail(file(), expression.mark(), owner + " is a particle: it has no density", "write mass:");
    const int power = extent == Extent::length ? 1 : extent == Extent::area ? 2 : 3;
    Dimension dimension = (weight ? dimensions::force : dimensions::mass) / Dimension::of(power, 0, 0);
    if (is_any(expression)) return any_(dimension);
    const Value<double> value = data_.value(expression);
    if (!value.is_number() || !same_kind(value.dimension, dimension)) {
      static constexpr std::array<const char*, 4> words{"", "length", "area", "volume"};
      fail(file(), expression.mark(),
           "the " + std::string(weight ? "specific weight" : "density") + " of " + owner + " is " +
               to_string(value.dimension) + "; expected " + (weight ? "weight" : "mass") + " per " + words[power],
           weight ? "" : "a weight per length, area or volume stands under specific_weight:");
    }
    if (!(value.number >= 0)) fail(file(), expression.mark(), "the density of " + owner + " is negative");
    return weight ? value.number / data_.gravity_size() : value.number;
  }
  bool states(const Amount& amount) const {
    return amount.mass || amount.weight || amount.density || amount.specific_weight;
  }
  double amount_of(const Amount& amount, const ShapeValues& shape, const std::string& owner) {
    if (amount.mass) return mass_of(*amount.mass, owner);
    if (amount.weight) return weight_of(*amount.weight, owner);
    if (amount.density) return density_of(*amount.density, shape.extent, false, owner) * shape.properties.measure;
    return density_of(*amount.specific_weight, shape.extent, true, owner) * shape.properties.measure;
  }
  Matrix3<double> axes_of(const StatedInertia& inertia) {
    if (inertia.axes.empty()) return Matrix3<double>::identity();
    if (inertia.axes.size() != 3) fail(file(), inertia.mark, "axes are three directions");
    Vector a[3];
    for (int i = 0; i < 3; ++i) a[i] = data_.direction(inertia.axes[i]);
    for (int i = 0; i < 3; ++i)
      if (std::abs(dot(a[i], a[(i + 1) % 3])) > 1e-9)
        fail(file(), inertia.axes[i].mark(), "the axes are not at right angles");
    if (dot(a[0], cross(a[1], a[2])) < 0)
      fail(file(), inertia.mark, "the axes are not right-handed", "reverse one of them");
    return Matrix3<double>::from_columns(a[0], a[1], a[2]);
  }
  // spread: square of the distance from the mass center to the point of the moments, m^2.
  SymmetricMatrix3<double> stated_tensor(const StatedInertia& inertia, double mass, double spread);

  const Body& body_;
  DataScope<double>& data_;
  const AnyValue& any_;
  bool lenient_;
};

void append(BodyMass& whole, std::vector<MassProperties<double>>& list, const ShapeValues& shape, double mass,
            bool lenient) {
  list.push_back(of_mass(shape.properties, mass));
  if (lenient) return;  // a trial is not checked
  for (const Particle<double>& particle : particles_of_mass(shape.particles, mass)) whole.particles.push_back(particle);
}

BodyMass MassReader::of_shapes() {
  BodyMass whole;
  std::vector<MassProperties<double>> list;
  const std::string owner = "body '" + body_.name + "'";
  std::vector<ShapeValues> shapes;
  double shared_measure = 0, stated_mass = 0;
  std::optional<Extent> shared_extent;
  for (const Part& part : body_.parts) {
    shapes.push_back(shape_values(part.shape, data_, part.name));
    const ShapeValues& shape = shapes.back();
    const std::string part_owner = body_.parts.size() == 1 ? owner : "part '" + part.name + "' of " + owner;
    const double sign = part.hole ? -1 : 1;
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
  double shared_mass = 0;
  if (shared_extent) {
    const double total =
        body_.amount.mass ? mass_of(*body_.amount.mass, owner) : weight_of(*body_.amount.weight, owner);
    shared_mass = total - stated_mass;
    if (shared_mass < 0) fail(file(), body_.mark, "the parts of " + owner + " weigh more than the whole");
    if (*shared_extent != Extent::point && !(shared_measure > 0))
      fail(file(), body_.mark, "the holes of " + owner + " leave nothing of it");
  } else if (body_.amount.mass || body_.amount.weight) {
    const double total =
        body_.amount.mass ? mass_of(*body_.amount.mass, owner) : weight_of(*body_.amount.weight, owner);
    if (std::abs(total - stated_mass) > 1e-9 * std::abs(total))
      fail(file(), body_.mark, "the masses of the parts of " + owner + " do not add up to its mass",
           "leave one of them out");
  }
  for (std::size_t i = 0; i < body_.parts.size(); ++i) {
    const Part& part = body_.parts[i];
    const std::string part_owner = body_.parts.size() == 1 ? owner : "part '" + part.name + "' of " + owner;
    double mass = 0;
    if (states(part.amount))
      mass = amount_of(part.amount, shapes[i], part_owner);
    else if (body_.amount.density || body_.amount.specific_weight)
      mass = amount_of(body_.amount, shapes[i], part_owner);
    else
      mass =
          *shared_extent == Extent::point ? shared_mass : shared_mass * shapes[i].properties.measure / shared_measure;
    append(whole, list, shapes[i], part.hole ? -mass : mass, lenient_);
  }
  for (const Part& part : body_.added) {
    const std::string part_owner = "the added '" + part.name + "' of " + owner;
    const ShapeValues shape = shape_values(part.shape, data_, part.name);
    if (!states(part.amount)) fail(file(), part.mark, part_owner + " has no mass", "write mass:");
    append(whole, list, shape, (part.hole ? -1 : 1) * amount_of(part.amount, shape, part_owner), lenient_);
  }
  whole.properties = sum(list);
  return whole;
}

SymmetricMatrix3<double> MassReader::stated_tensor(const StatedInertia& inertia, double mass, double spread) {
  const Dimension dimension = inertia.radii ? dimensions::length : dimensions::moment_of_inertia;
  const auto moment = [&](const Expression& expression) {
    const double value = number(expression, dimension);
    if (!(value >= 0))
      fail(file(), expression.mark(),
           std::string("a ") + (inertia.radii ? "radius of gyration" : "moment of inertia") + " of body '" +
               body_.name + "' is negative");
    return inertia.radii ? mass * value * value : value;
  };
  if (inertia.matrix) {
    const Value<double> rows = data_.value(*inertia.matrix);
    if (!rows.is_list() || rows.items.size() != 3)
      fail(file(), inertia.matrix->mark(), "an inertia matrix has three rows of three");
    Matrix3<double> I = Matrix3<double>::zero();
    for (int i = 0; i < 3; ++i) {
      if (!rows.items[i].is_vector() || !(same_kind(rows.items[i].dimension, dimension) || rows.items[i].bare))
        fail(file(), inertia.matrix->mark(), "an inertia matrix has three rows of three moments of inertia");
      I.row(i) = rows.items[i].vector;
    }
    if (const auto report = validate(mass, Vector::zero(), I, body_.name);
        report && report->rule == MassRule::symmetric_tensor)
      fail(file(), inertia.mark, report->message);
    return symmetric_part(I);
  }
  if (inertia.axis) {
    const Vector axis = data_.direction(*inertia.axis);
    return axisymmetric_tensor(axis, moment(*inertia.axial), moment(*inertia.transverse));
  }
  Vector moments = Vector::zero();
  ProductsOfInertia<double> products;
  double size = mass * spread;
  for (int i = 0; i < 3; ++i) {
    const double product = inertia.products[i] ? number(*inertia.products[i], dimension) : 0;
    (i == 0 ? products.xy : i == 1 ? products.yz : products.zx) = product;
    size += std::abs(product);
  }
  // Moments left open become such as a body with the others can have: two open ones are large and nearly equal, one
  // alone lies between the difference and the sum of the others.
  std::vector<int> open;
  double smallest = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 3; ++i) {
    if (inertia.moments[i] && !is_any(*inertia.moments[i])) {
      moments[i] = moment(*inertia.moments[i]);
      smallest = std::min(smallest, moments[i]);
      size += moments[i];
    } else {
      open.push_back(i);
    }
  }
  for (int i : open) {
    const double choice = any_(dimensions::moment_of_inertia);  // from 0.5 to 2
    const double a = moments[(i + 1) % 3], b = moments[(i + 2) % 3];
    moments[i] = open.size() == 1 ? std::abs(a - b) + (0.2 + 0.3 * choice) * (a + b - std::abs(a - b))
                                  : 8 * std::max(size, 1e-300) + 0.25 * choice * std::min(smallest, size);
  }
  return inertia_tensor(moments, products);
}

BodyMass MassReader::of_numbers() {
  BodyMass whole;
  const std::string owner = "body '" + body_.name + "'";
  const double mass = body_.amount.mass ? mass_of(*body_.amount.mass, owner) : weight_of(*body_.amount.weight, owner);
  Vector center = Vector::zero();
  if (const List* list = body_.center->as<List>(); list && list->items.size() == 3)
    for (int i = 0; i < 3; ++i) center[i] = number(list->items[i], dimensions::length);
  else
    center = data_.place(*body_.center);
  SymmetricMatrix3<double> tensor = SymmetricMatrix3<double>::zero();
  if (body_.inertia) {
    const StatedInertia& inertia = *body_.inertia;
    const double spread = inertia.about ? norm_squared(center - data_.place(*inertia.about)) : 0;
    tensor = rotated(axes_of(inertia), stated_tensor(inertia, mass, spread));
    if (inertia.about) {
      const Vector about = data_.place(*inertia.about);
      whole.properties = from_inertia_about(about, mass, center, tensor);
    } else {
      whole.properties = {mass, center, tensor};
    }
  } else {
    whole.properties = {mass, center, tensor};
  }
  if (const auto report = validate(whole.properties, body_.name); report && !lenient_)
    fail(file(), body_.inertia ? body_.inertia->mark : body_.mark, report->message);
  if (!lenient_) whole.particles = equivalent_particles(whole.properties);
  std::vector<MassProperties<double>> list{whole.properties};
  for (const Part& part : body_.added) {
    const ShapeValues shape = shape_values(part.shape, data_, part.name);
    if (!states(part.amount))
      fail(file(), part.mark, "the added '" + part.name + "' of " + owner + " has no mass", "write mass:");
    append(whole, list, shape,
           (part.hole ? -1 : 1) * amount_of(part.amount, shape, "the added '" + part.name + "' of " + owner), lenient_);
  }
  whole.properties = sum(list);
  return whole;
}

}  // namespace

BodyMass body_mass(const Body& body, DataScope<double>& data, const AnyValue& any, bool lenient) {
  if (body.massless) return {massless<double>(), {}};
  MassReader reader(body, data, any, lenient);
  BodyMass result = body.parts.empty() ? reader.of_numbers() : reader.of_shapes();
  if (const auto report = validate(result.properties, body.name); report && !lenient)
    fail(data.problem().file, body.mark, report->message);
  return result;
}

RollingSurface rolling_surface(const Body& body, DataScope<double>& data, const Vector& p_OC,
                               const Vector& center_of_mass) {
  constexpr double on_surface = 1e-6;  // of its radius
  const std::string& file = data.problem().file;
  RollingSurface nearest_surface;
  double nearest_gap = std::numeric_limits<double>::infinity();
  bool other_shapes = false;
  // A circle about an axis (a sphere for a zero axis) on which the point may lie, `gap` off it.
  const auto offer = [&](const Vector& center, const Vector& axis, double radius, double gap) {
    if (gap / radius >= nearest_gap) return;
    nearest_gap = gap / radius;
    nearest_surface = {ContactShape::round, center, axis, radius, gap};
  };
  for (const Part& part : body.parts) {
    const std::string& kind = part.shape.kind;
    const auto place = [&](const char* name) { return data.place(shape_argument(part.shape, name, file)); };
    const auto direction = [&](const char* name) { return data.direction(shape_argument(part.shape, name, file)); };
    const auto length = [&](const char* name) {
      return data.number(shape_argument(part.shape, name, file), dimensions::length);
    };
    // A frustum from A (radius r_A) to B (radius r_B): the circle about its axis through the point.
    const auto frustum = [&](const Vector& A, double r_A, const Vector& B, double r_B) {
      const Vector axis = normalized(B - A);
      const double height = norm(B - A), along = dot(p_OC - A, axis);
      const Vector foot = A + std::clamp(along, 0.0, height) * axis;
      const double radius = r_A + (r_B - r_A) * std::clamp(along, 0.0, height) / height;
      const double rho = norm(p_OC - (A + along * axis));
      offer(foot, axis, std::max(radius, 1e-300), std::hypot(rho - radius, along - std::clamp(along, 0.0, height)));
    };
    if (kind == "sphere" || kind == "sphere_shell" || kind == "hemisphere" || kind == "hemisphere_shell") {
      const Vector center = place("center");
      offer(center, Vector::zero(), length("radius"), std::abs(norm(p_OC - center) - length("radius")));
    } else if (kind == "disk" || kind == "ring" || kind == "annulus") {
      const Vector center = place("center"), axis = direction("normal");
      const double along = dot(p_OC - center, axis), radius = length("radius");
      offer(center, axis, radius, std::hypot(norm(p_OC - center - along * axis) - radius, along));
    } else if (kind == "cylinder" || kind == "tube" || kind == "cylinder_shell" || kind == "closed_cylinder_shell") {
      const Vector half = 0.5 * length("length") * direction("axis");
      frustum(place("center") - half, length("radius"), place("center") + half, length("radius"));
    } else if (kind == "cone" || kind == "cone_shell") {
      frustum(place("apex"), 0, place("base"), length("radius"));
    } else if (kind == "frustum") {
      frustum(place("base"), length("base_radius"), place("top"), length("top_radius"));
    } else {
      other_shapes = true;
    }
  }
  if (nearest_gap <= on_surface) return nearest_surface;
  if (body.parts.empty()) {
    if (body.inertia && body.inertia->axis) {
      const Vector axis = data.direction(*body.inertia->axis);
      const Vector foot = center_of_mass + dot(p_OC - center_of_mass, axis) * axis;
      return {ContactShape::round, foot, axis, norm(p_OC - foot), 0};
    }
    return {ContactShape::unknown, {}, {}, 0, 0};
  }
  if (!other_shapes) return {ContactShape::missed, {}, {}, nearest_surface.radius, nearest_surface.gap};
  const bool curved = std::any_of(body.parts.begin(), body.parts.end(), [](const Part& part) {
    return part.shape.kind == "torus" || part.shape.kind == "ellipsoid" || part.shape.kind == "mesh" ||
           part.shape.kind == "arc";
  });
  return {curved ? ContactShape::unknown : ContactShape::corner, {}, {}, 0, 0};
}

}  // namespace poinsot::statement
