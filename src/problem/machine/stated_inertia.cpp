#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "poinsot/engine/mass/composition.h"
#include "poinsot/engine/math/algebra/plain.h"
#include "problem/language/diagnostic.h"
#include "problem/language/exact_numbers.h"
#include "problem/machine/masses.h"
#include "problem/machine/stated_sizes.h"

namespace poinsot::problem {
namespace {

using poinsot::plain;

template <class Scalar>
class InertiaReader {
 public:
  using Vector = Vector3<Scalar>;

  explicit InertiaReader(const InertiaSource<Scalar>& source) : source_(source) {}

  Matrix3<Scalar> axes_of(const StatedInertia& inertia) {
    if (inertia.axes.empty()) return Matrix3<Scalar>::identity();
    if (inertia.axes.size() != 3) fail(file(), inertia.mark, "axes are three directions");
    Vector a[3];
    for (int i = 0; i < 3; ++i) a[i] = source_.data.direction(inertia.axes[i]);
    for (int i = 0; i < 3; ++i)
      if (constexpr double right_angle = 1e-9;  // cosine: directions may be stated to nine digits
          std::abs(plain(dot(a[i], a[(i + 1) % 3]))) > right_angle)
        fail(file(), inertia.axes[i].mark(), "the axes are not at right angles");
    if (plain(dot(a[0], cross(a[1], a[2]))) < 0)
      fail(file(), inertia.mark, "the axes are not right-handed", "reverse one of them");
    return Matrix3<Scalar>::from_columns(a[0], a[1], a[2]);
  }
  // arm: from the point of the moments of inertia to the mass center, on the axes of the inertia, m.
  SymmetricMatrix3<Scalar> on_own_axes(const StatedInertia& inertia, const Scalar& mass, const Vector& arm);

 private:
  const std::string& file() const { return source_.data.situation().file; }
  SymmetricMatrix3<Scalar> axisymmetric(const StatedInertia& inertia, const Scalar& mass, const Vector& arm);
  SymmetricMatrix3<Scalar> of_moments(const StatedInertia& inertia, const Scalar& mass, const Vector& arm);
  Scalar moment(const StatedInertia& inertia, const Expression& expression, const Scalar& mass);
  // The moment of inertia of the mass at the distance of the stated points.
  Scalar moment_of_stated_size(const Scalar& mass) {
    return mass * Scalar(stated_size(source_.data, dimensions::area));
  }

  const InertiaSource<Scalar>& source_;
};

template <class Scalar>
Scalar InertiaReader<Scalar>::moment(const StatedInertia& inertia, const Expression& expression, const Scalar& mass) {
  const Scalar value =
      source_.data.number(expression, inertia.radii ? dimensions::length : dimensions::moment_of_inertia);
  if (!(plain(value) >= 0))
    fail(file(), expression.mark(),
         std::string("a ") + (inertia.radii ? "radius of gyration" : "moment of inertia") + " of body '" +
             source_.body + "' is negative");
  return inertia.radii ? mass * value * value : value;
}

template <class Scalar>
SymmetricMatrix3<Scalar> InertiaReader<Scalar>::on_own_axes(const StatedInertia& inertia, const Scalar& mass,
                                                            const Vector& arm) {
  if (inertia.matrix) {
    const Dimension dimension = dimensions::moment_of_inertia;
    const Value<Scalar> rows = source_.data.value(*inertia.matrix);
    if (!rows.is_list() || rows.items.size() != 3)
      fail(file(), inertia.matrix->mark(), "an inertia matrix has three rows of three");
    Matrix3<Scalar> I = Matrix3<Scalar>::zero();
    for (int i = 0; i < 3; ++i) {
      if (!rows.items[i].is_vector() || !(same_kind(rows.items[i].dimension, dimension) || rows.items[i].bare))
        fail(file(), inertia.matrix->mark(), "an inertia matrix has three rows of three moments of inertia");
      I.row(i) = rows.items[i].vector;
    }
    if (const auto report = validate(plain(mass), Vector3<double>::zero(), plain(I), source_.body,
                                     usual_tolerance_of_moments, moment_unit(source_.data.situation()));
        report && report->rule == MassRule::symmetric_tensor)
      fail(file(), inertia.mark, report->message);
    return symmetric_part(I);
  }
  return inertia.axis ? axisymmetric(inertia, mass, arm) : of_moments(inertia, mass, arm);
}

// Open moments get values that a body with the other moments can have: at the mass center 0 < axial < 2 transverse.
template <class Scalar>
SymmetricMatrix3<Scalar> InertiaReader<Scalar>::axisymmetric(const StatedInertia& inertia, const Scalar& mass,
                                                             const Vector& arm) {
  const Vector axis = source_.data.direction(*inertia.axis);
  const Scalar along = dot(arm, axis);
  // The mass center lies on the axis, so that only the transverse moment depends on the point of the axis.
  const Scalar shift = mass * along * along;
  const bool open_axial = is_any(*inertia.axial), open_transverse = is_any(*inertia.transverse);
  Scalar axial = open_axial ? Scalar(0) : moment(inertia, *inertia.axial, mass);
  Scalar transverse = open_transverse ? Scalar(0) : moment(inertia, *inertia.transverse, mass);
  if (open_transverse) {
    const double choice = source_.any(dimensions::moment_of_inertia);  // from 0.5 to 2
    const Scalar size = open_axial || !(plain(axial) > 0) ? moment_of_stated_size(mass) : axial;
    transverse = Scalar(0.6 + 0.65 * choice) * size + shift;
  }
  if (open_axial) axial = Scalar(0.3 + 0.4 * source_.any(dimensions::moment_of_inertia)) * (transverse - shift);
  return axisymmetric_tensor(axis, axial, transverse);
}

template <class Scalar>
SymmetricMatrix3<Scalar> InertiaReader<Scalar>::of_moments(const StatedInertia& inertia, const Scalar& mass,
                                                           const Vector& arm) {
  const auto open = [&](const std::optional<Expression>& stated) {
    return stated ? is_any(*stated) : inertia.rest_any;
  };
  if (std::ranges::none_of(inertia.moments, [](const auto& stated) { return !stated || is_any(*stated); }) &&
      std::ranges::none_of(inertia.products, open)) {
    Vector moments;
    for (int i = 0; i < 3; ++i) moments[i] = moment(inertia, *inertia.moments[i], mass);
    const auto product = [&](std::size_t i) {
      return inertia.products[i] ? source_.data.number(*inertia.products[i], dimensions::moment_of_inertia) : Scalar(0);
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
      if (product) about_products[i] = source_.data.number(*product, dimensions::moment_of_inertia);
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
  // the mass at the distance of the stated points.
  if (!(plain(size) > 0)) size = moment_of_stated_size(mass);
  const auto open_moments = std::count(open_moment.begin(), open_moment.end(), true);
  for (int i = 0; i < 3; ++i) {
    if (!open_moment[i]) continue;
    // from 0.5 to 2; in a planar problem nothing feels what is not stated, so that one value serves.
    const double choice = inertia.flat && !inertia.rest_any ? 1 : source_.any(dimensions::moment_of_inertia);
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
    const double aside = 0.5 * (source_.any(dimensions::moment_of_inertia) - 1);  // from -0.25 to 0.5
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

}  // namespace

template <class Scalar>
SymmetricMatrix3<Scalar> stated_tensor(const StatedInertia& inertia, const Scalar& mass, const Vector3<Scalar>& center,
                                       const InertiaSource<Scalar>& source) {
  InertiaReader<Scalar> reader(source);
  const Matrix3<Scalar> axes = reader.axes_of(inertia);
  const Vector3<Scalar> arm = inertia.about
                                  ? transpose_times(axes, Vector3<Scalar>(center - source.data.place(*inertia.about)))
                                  : Vector3<Scalar>::zero();
  return rotated(axes, reader.on_own_axes(inertia, mass, arm));
}

template SymmetricMatrix3<double> stated_tensor(const StatedInertia&, const double&, const Vector3<double>&,
                                                const InertiaSource<double>&);
template SymmetricMatrix3<Dual<1>> stated_tensor(const StatedInertia&, const Dual<1>&, const Vector3<Dual<1>>&,
                                                 const InertiaSource<Dual<1>>&);
template SymmetricMatrix3<Formula> stated_tensor(const StatedInertia&, const Formula&, const Vector3<Formula>&,
                                                 const InertiaSource<Formula>&);

}  // namespace poinsot::problem
