// Moments and principal axes of inertia, and the free motion that they determine (section 18.11).
#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <type_traits>

#include "poinsot/engine/mass/composition.h"
#include "poinsot/engine/mass/principal_axes.h"
#include "poinsot/engine/math/formula/formula_decision.h"
#include "problem/language/diagnostic.h"
#include "problem/language/exact_numbers.h"
#include "problem/quantities/quantities.h"
#include "problem/quantities/quantity_values.h"

namespace poinsot::problem {
namespace {

template <class Scalar>
struct Revolution {
  InertiaSymmetry symmetry;
  Scalar axial, transverse;
  Vector3<Scalar> axis;
};

// Of the largest moment: moments that are the same but for data stated to nine digits. The axes of moments that differ
// by less are known to no digit.
constexpr double equal_moments = 1e-9;

Revolution<double> revolution_of(const SymmetricMatrix3<double>& I) {
  const PrincipalAxes<double> principal = principal_axes(I, equal_moments);
  const auto axis = static_cast<std::size_t>(principal.symmetry_axis);
  if (principal.symmetry != InertiaSymmetry::axisymmetric) return {principal.symmetry, 0, 0, {}};
  return {principal.symmetry, principal.moments[axis], principal.moments[axis == 0 ? 1 : 0],
          principal.axes.column(axis)};
}

// The rates of the axial moment A and of the axis u to first order: dA = u . dI u, du = (1 - u u^T) dI u / (A - B).
Revolution<Dual<1>> revolution_of(const SymmetricMatrix3<Dual<1>>& I) {
  const Revolution<double> now = revolution_of(plain(I));
  if (now.symmetry != InertiaSymmetry::axisymmetric) return {now.symmetry, {}, {}, {}};
  const Vector3<Dual<1>> Iu = I * lifted<Dual<1>>(now.axis);
  const Dual<1> axial = dot(lifted<Dual<1>>(now.axis), Iu);
  Vector3<Dual<1>> axis;
  for (std::size_t k = 0; k < 3; ++k)
    axis[k] = {now.axis[k], {(Iu[k].partial[0] - axial.partial[0] * now.axis[k]) / (now.axial - now.transverse)}};
  return {now.symmetry, axial, (I.xx + I.yy + I.zz - axial) / Dual<1>(2), axis};
}

// The tensor of a body of revolution is I = B 1 + (A - B) u u^T. B is the double root of the characteristic
// polynomial x^3 - c x^2 + d x - e.
Revolution<Formula> revolution_of(const SymmetricMatrix3<Formula>& I) {
  const Formula c = I.xx + I.yy + I.zz;
  const Formula d = I.xx * I.yy + I.yy * I.zz + I.zz * I.xx - I.xy * I.xy - I.yz * I.yz - I.zx * I.zx;
  const Formula e = determinant(as_matrix(I));
  const Formula spread = c * c - Formula(3) * d;
  if (spread.is_zero()) return {InertiaSymmetry::spherical, {}, {}, {}};
  const Formula transverse = (c * d - Formula(9) * e) / (Formula(2) * spread);
  const Formula axial = c - Formula(2) * transverse;
  if (axial == transverse) return {InertiaSymmetry::triaxial, {}, {}, {}};
  const Matrix3<Formula> uu =
      (Formula(1) / (axial - transverse)) * (as_matrix(I) - transverse * Matrix3<Formula>::identity());
  std::size_t k = 0;
  while (k < 3 && uu(k, k).is_zero()) ++k;
  if (k == 3) return {InertiaSymmetry::triaxial, {}, {}, {}};
  const Vector3<Formula> u = uu.column(k) / sqrt(uu(k, k));
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      if (!(uu(i, j) - u[i] * u[j]).is_zero()) return {InertiaSymmetry::triaxial, {}, {}, {}};
  return {InertiaSymmetry::axisymmetric, axial, transverse, u};
}

// The principal moments in ascending order, where the numbers of the letters decide the order. They have a formula if
// at most one product of inertia is not zero.
Vector3<Formula> principal_moments(const SymmetricMatrix3<Formula>& I) {
  const std::array<Formula, 3> moments{I.xx, I.yy, I.zz}, products{I.yz, I.zx, I.xy};
  std::size_t alone = 0;  // the axis perpendicular to the plane of that product
  int count = 0;
  for (std::size_t k = 0; k < 3; ++k)
    if (!products[k].is_zero()) {
      alone = k;
      ++count;
    }
  if (count > 1) {
    const Revolution<Formula> body = revolution_of(I);
    if (body.symmetry != InertiaSymmetry::axisymmetric)
      throw NoFormula("the principal moments are the roots of a cubic equation");
    return decided_negative(body.axial - body.transverse)
               ? Vector3<Formula>{body.axial, body.transverse, body.transverse}
               : Vector3<Formula>{body.transverse, body.transverse, body.axial};
  }
  const Formula &a = moments[(alone + 1) % 3], &b = moments[(alone + 2) % 3];
  const Formula mean = (a + b) / Formula(2), half = (a - b) / Formula(2);
  const Formula radius = count == 0 ? half : sqrt(half * half + products[alone] * products[alone]);
  std::array<Formula, 3> found{moments[alone], mean - radius, mean + radius};
  std::sort(found.begin(), found.end(), [](const Formula& x, const Formula& y) { return decided_negative(x - y); });
  return {found[0], found[1], found[2]};
}

// The principal axes of a tensor without products, in the order of the moments. Where two moments are the same whatever
// the letters are, the axes come in the order of the figure's.
std::array<Vector3<Formula>, 3> principal_axes(const SymmetricMatrix3<Formula>& I) {
  if (!I.xy.is_zero() || !I.yz.is_zero() || !I.zx.is_zero())
    throw NoFormula("principal axes that are none of the figure's are found by numbers");
  const std::array<Formula, 3> moments{I.xx, I.yy, I.zz};
  std::array<std::size_t, 3> order{0, 1, 2};
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t i, std::size_t k) { return decided_negative(moments[i] - moments[k]); });
  const Vector3<Formula> first = Vector3<Formula>::unit(order[0]), second = Vector3<Formula>::unit(order[1]);
  return {first, second, cross(first, second)};
}

// Which rotations about principal axes are stable: in the order of the moments. That two of these differ is noted as
// the sign of the square of their difference.
std::array<const char*, 3> axis_stability(const SymmetricMatrix3<Formula>& I) {
  const Vector3<Formula> m = [&] {
    const DecisionScope order;  // which matters to none of the words
    return principal_moments(I);
  }();
  const Formula difference[3] = {m.y - m.z, m.z - m.x, m.x - m.y};
  const auto equal = std::ranges::count_if(difference, &Formula::is_zero);
  if (equal == 3) return {"neutral", "neutral", "neutral"};
  if (equal == 0) {
    for (const Formula& one : difference) note_sign(one * one);
    return {"stable", "unstable", "stable"};
  }
  const auto alone =
      static_cast<std::size_t>(std::ranges::find_if(difference, &Formula::is_zero) - std::begin(difference));
  if (decided_negative(m[alone] - m[(alone + 1) % 3])) return {"stable", "neutral", "neutral"};
  return {"neutral", "neutral", "stable"};
}

// twice_energy: of the turning.
Value<Formula> construction_in_letters(const Call& call, const SymmetricMatrix3<Formula>& I,
                                       const Formula& twice_energy) {
  std::vector<Value<Formula>> items;
  if (call.function == "axis_stability") {
    for (const char* word : axis_stability(I)) items.push_back(Value<Formula>::of_text(word));
  } else if (call.function == "poinsot_ellipsoid") {
    const Vector3<Formula> moments = principal_moments(I);
    for (std::size_t k = 0; k < 3; ++k)
      items.push_back(number_value(sqrt(twice_energy / moments[k]), dimensions::angular_velocity));
  } else {
    throw NoFormula(call.function + "() is found by numbers");
  }
  return Value<Formula>::of_list(std::move(items));
}

}  // namespace

template <class Scalar, class Base>
Value<Scalar> QuantityScope<Scalar, Base>::inertia(const Call& call, const Mark& mark,
                                                   const Evaluator<Scalar>& evaluator) {
  const std::string_view f = call.function;
  const Expression& what = call.arguments[0].value;
  const int body = body_of(what, evaluator, true);
  if (body == ground) evaluator.fail(what.mark(), "the ground has no inertia");
  const MassProperties<Scalar> mass = current_mass(body);
  const auto told = [&](ToldQuantity::Kind kind, const Vector& P, const Vector& first, const Vector& second,
                        const Scalar& value) {
    if (tells() && !tells_rates)
      told_->push_back({.kind = kind,
                        .body = body,
                        .place = plain_vector(P),
                        .first = plain_vector(first),
                        .second = plain_vector(second),
                        .value = {plain(value), 0, 0},
                        .words = call.function});
  };
  const auto told_tensor = [&](const Vector& P, const Matrix3<Scalar>& axes, const SymmetricMatrix3<Scalar>& I) {
    using Kind = ToldQuantity::Kind;
    const Vector x = axes.column(0), y = axes.column(1), z = axes.column(2);
    told(Kind::moment_of_inertia, P, x, x, I.xx);
    told(Kind::moment_of_inertia, P, y, y, I.yy);
    told(Kind::moment_of_inertia, P, z, z, I.zz);
    told(Kind::product_of_inertia, P, x, y, Scalar(-I.xy));
    told(Kind::product_of_inertia, P, y, z, Scalar(-I.yz));
    told(Kind::product_of_inertia, P, z, x, Scalar(-I.zx));
  };
  if (f == "moment_of_inertia" || f == "radius_of_gyration") {
    const auto [P, d] = line(call, evaluator);
    const Scalar I = moment_about_axis(mass, P, d);
    told(ToldQuantity::Kind::moment_of_inertia, P, d, d, I);
    if (f == "moment_of_inertia") return number_value(I, dimensions::moment_of_inertia);
    if (!(plain(mass.mass) > 0)) evaluator.fail(mark, "a massless body has no radius of gyration");
    using std::sqrt;
    const Scalar radius(sqrt(I / mass.mass));
    told(ToldQuantity::Kind::radius_of_gyration, P, d, d, radius);
    return number_value(radius, dimensions::length);
  }
  const Vector P = place(*call.argument("about"), evaluator);
  const SymmetricMatrix3<Scalar> I = rotated(transpose(axes_), inertia_about(mass, P));
  const auto numbers = [&](std::array<Scalar, 3> list) {
    std::vector<Result> items;
    items.reserve(list.size());
    for (const Scalar& x : list) items.push_back(number_value(x, dimensions::moment_of_inertia));
    return Result::of_list(std::move(items));
  };
  if (f == "moments_of_inertia" || f == "inertia_matrix") told_tensor(P, axes_, I);
  if (f == "moments_of_inertia") return numbers({I.xx, I.yy, I.zz});
  if (f == "products_of_inertia") {
    const std::array<Scalar, 3> products{Scalar(-I.xy), Scalar(-I.yz), Scalar(-I.zx)};
    for (std::size_t k = 0; k < 3; ++k)
      told(ToldQuantity::Kind::product_of_inertia, P, axes_.column(k), axes_.column((k + 1) % 3), products[k]);
    return numbers(products);
  }
  if (f == "inertia_matrix") {
    const Matrix3<Scalar> M = as_matrix(I);
    return Result::of_list({numbers({M.row0.x, M.row0.y, M.row0.z}), numbers({M.row1.x, M.row1.y, M.row1.z}),
                            numbers({M.row2.x, M.row2.y, M.row2.z})});
  }
  require_one_of(f, {"principal_moments", "principal_axes"});
  if constexpr (std::is_same_v<Scalar, Formula>) {
    if (f == "principal_axes") {
      std::vector<Result> items;
      for (const Vector& axis : principal_axes(I)) items.push_back(vector_value(axes_ * axis, dimensions::none));
      return Result::of_list(std::move(items));
    }
    const Vector moments = principal_moments(I);
    return numbers({moments.x, moments.y, moments.z});
  } else if constexpr (std::is_same_v<Scalar, double>) {
    const PrincipalAxes<double> principal = principal_axes(I);
    SymmetricMatrix3<double> diagonal{};
    diagonal.xx = principal.moments.x;
    diagonal.yy = principal.moments.y;
    diagonal.zz = principal.moments.z;
    told_tensor(P, axes_ * principal.axes, diagonal);
    if (f == "principal_moments") return numbers({principal.moments.x, principal.moments.y, principal.moments.z});
    // The axes are given on the axes that were asked for, as the caller converts vectors but not lists.
    std::vector<Result> items;
    for (std::size_t k = 0; k < 3; ++k) {
      items.push_back(vector_value(axes_ * principal.axes.column(k), dimensions::none));
      const Vector& axis = items.back().vector;
      told(ToldQuantity::Kind::moment_of_inertia, P, axis, axis, principal.moments[k]);
    }
    return Result::of_list(std::move(items));
  } else {
    evaluator.fail(mark, call.function + " cannot stand inside rate()");
  }
}

// A body of revolution under no moment about its mass center precesses about its angular momentum H_G at the rate
// H_G/I' and spins about its axis at H_G cos(theta) (I' - I)/(I I') (Eqs. 18.46 to 18.49), where H_G cos(theta)/I is
// the angular velocity along the axis, which a slender rod has though no moment.
template <class Scalar, class Base>
Value<Scalar> QuantityScope<Scalar, Base>::free_motion(const Call& call, const Mark& mark,
                                                       const Evaluator<Scalar>& evaluator) {
  if constexpr (!std::is_same_v<Scalar, Base>) {
    evaluator.fail(mark, call.function + "() cannot stand inside rate() or among what is known of the velocities");
  } else {
    using std::atan2;
    const std::string_view f = call.function;
    const Expression& what = call.arguments[0].value;
    const int body = body_of(what, evaluator);
    if (is_frame(body)) evaluator.fail(what.mark(), "'" + to_string(what) + "' is no body");
    const Vector G = mass_center_of(body, what, evaluator);
    const Vector H = body_momentum(model_, workspace_, body, G).angular;
    const Vector& w = angular_velocity(workspace_, body);
    using Kind = ToldQuantity::Kind;
    Vector axis = Vector::zero();
    const auto told = [&](Kind kind, const Vector& value) {
      if (tells())
        told_->push_back({.kind = kind,
                          .body = body,
                          .place = plain_vector(G),
                          .first = plain_vector(axis),
                          .value = plain_vector(value),
                          .words = call.function});
    };
    const auto vector = [&](Kind kind, const Vector& value) {
      told(kind, value);
      return vector_value(value, dimensions::none);
    };
    const auto number = [&](Kind kind, const Scalar& value, const Dimension& dimension) {
      told(kind, {value, Scalar(0), Scalar(0)});
      return number_value(value, dimension);
    };
    if (f == "precession_axis" || f == "invariable_plane") {
      if (!(plain(norm(H)) > 0))
        throw UnansweredError(evaluator.file(), mark,
                              "'" + to_string(what) + "' does not turn: it has no angular momentum");
      if (f == "precession_axis") return vector(Kind::precession_axis, normalized(H));
      return number(Kind::invariable_plane, Scalar(dot(w, H) / norm(H)), dimensions::angular_velocity);
    }
    if (f == "axis_stability" || f == "poinsot_ellipsoid" || f == "polhode") {
      if constexpr (std::is_same_v<Scalar, double>)
        return poinsot_construction(call, mark, evaluator, body, H, w);
      else if constexpr (!std::is_same_v<Scalar, Formula>)
        throw NoFormula(call.function + "() is found by numbers");
      else
        return construction_in_letters(call, current_mass(body).inertia_center, dot(w, H));
    }
    const Revolution<Scalar> revolution = revolution_of(current_mass(body).inertia_center);
    // Where all axes are alike the angular velocity is along the angular momentum; where none are it goes round on no
    // cone.
    const bool has_space_cone = revolution.symmetry != InertiaSymmetry::triaxial;
    if (f == "space_cone" && has_space_cone)
      return number(Kind::space_cone, Scalar(atan2(norm(cross(H, w)), dot(H, w))), dimensions::angle);
    if (revolution.symmetry != InertiaSymmetry::axisymmetric)
      throw UnansweredError(
          evaluator.file(), what.mark(),
          "'" + to_string(what) + "' is no body of revolution: " +
              (revolution.symmetry == InertiaSymmetry::spherical ? "all its axes are alike"
                                                                 : "its three principal moments differ"),
          "its motion is no steady precession");
    const Scalar &axial = revolution.axial, &transverse = revolution.transverse;
    if (f == "precession_sense") {
      // The second road asks for the axis on the side of the angular velocity; the moments alone decide the sense.
      axis = plain(dot(revolution.axis, w)) < 0 ? -revolution.axis : revolution.axis;
      const bool direct = decided_negative(axial - transverse);
      told(Kind::precession_sense, {Scalar(direct ? 1 : -1), Scalar(0), Scalar(0)});
      return Result::of_text(direct ? "direct" : "retrograde");
    }
    // The axis has the sense of the angular velocity, unless the caller states another.
    axis = revolution.axis;
    if (decided_negative(dot(axis, w))) axis = -axis;
    if (const Expression* about = call.argument("about")) {
      const Result sense = evaluator(*about);
      constexpr double same_axis = 1e-6;  // sine: an axis that is stated with the six digits of a figure
      if (!sense.is_vector() || plain(norm(cross(sense.vector, axis))) > same_axis * plain(norm(sense.vector)))
        evaluator.fail(about->mark(),
                       "'" + to_string(*about) + "' is not the axis of revolution of '" + to_string(what) + "'");
      if (decided_negative(dot(sense.vector, axis))) axis = -axis;
    }
    if (f == "symmetry_axis") return vector(Kind::symmetry_axis, axis);
    if (f == "body_cone") {
      const Scalar along = dot(axis, w);
      return number(Kind::body_cone,
                    Scalar(atan2(norm(cross(axis, w)), decided_negative(along) ? Scalar(-along) : along)),
                    dimensions::angle);
    }
    if (f == "precession_rate")
      return number(Kind::precession_rate, Scalar(norm(H) / transverse), dimensions::angular_velocity);
    require_one_of(f, {"spin_rate"});
    return number(Kind::spin_rate, Scalar(dot(w, axis) * (transverse - axial) / transverse),
                  dimensions::angular_velocity);
  }
}

// Poinsot's construction: the semi-axes of the ellipsoid, the principal axis about which the tip of the angular
// velocity runs, and which rotations about principal axes are stable.
template <class Scalar, class Base>
Value<Scalar> QuantityScope<Scalar, Base>::poinsot_construction(const Call& call, const Mark& mark,
                                                                const Evaluator<Scalar>& evaluator, int body,
                                                                const Vector& H, const Vector& w) {
  const std::string_view f = call.function;
  const PrincipalAxes<double> principal = principal_axes(current_mass(body).inertia_center, equal_moments);
  const Vector3<double>& I = principal.moments;
  const auto equal = [&](std::size_t a, std::size_t b) { return std::abs(I[a] - I[b]) <= equal_moments * I[2]; };
  const auto told = [&](ToldQuantity::Kind kind, const Vector3<double>& value) {
    if (!tells()) return;
    const Vector3<double> G = plain_vector(body_mass_center(model_, workspace_, body));
    told_->push_back({.kind = kind, .body = body, .place = G, .value = value, .words = call.function});
  };
  if (f == "axis_stability") {
    // These belong to the smallest, the intermediate and the largest moment. If two moments are equal, a rotation
    // about one of their axes drifts to the others when it is disturbed.
    const char* outer[2] = {equal(0, 1) ? "neutral" : "stable", equal(1, 2) ? "neutral" : "stable"};
    const char* middle = equal(0, 1) || equal(1, 2) ? "neutral" : "unstable";
    const auto as_number = [](std::string_view word) {
      return word == "stable" ? 1.0 : word == "unstable" ? -1.0 : 0.0;
    };
    told(ToldQuantity::Kind::axis_stability, {as_number(outer[0]), as_number(middle), as_number(outer[1])});
    return Result::of_list({Result::of_text(outer[0]), Result::of_text(middle), Result::of_text(outer[1])});
  }
  if (!(norm(H) > 0))
    throw UnansweredError(evaluator.file(), mark,
                          "'" + to_string(call.arguments[0].value) + "' does not turn: it has no angular momentum");
  if (f == "poinsot_ellipsoid") {
    std::vector<Result> semiaxes;
    Vector3<double> lengths{};
    for (std::size_t k = 0; k < 3; ++k) {
      lengths[k] = std::sqrt(dot(w, H) / I[k]);
      semiaxes.push_back(number_value(lengths[k], dimensions::angular_velocity));
    }
    told(ToldQuantity::Kind::poinsot_ellipsoid, lengths);
    return Result::of_list(std::move(semiaxes));
  }
  // The sign of H^2 - 2 T I_2 tells about which axis the tip of w runs. It is formed from its terms, as the
  // difference would cancel.
  const Vector3<double> own = transpose_times(principal.axes, w);
  const double towards_largest = I.z * (I.z - I.y) * own.z * own.z,
               towards_smallest = I.x * (I.y - I.x) * own.x * own.x;
  const double size = I.z * (I.z - I.x) * norm_squared(own);
  // Moments that differ little turn the angular momentum little away from any axis.
  const double around =
      norm(Vector3<double>{(I.z - I.y) * own.y * own.z, (I.x - I.z) * own.z * own.x, (I.y - I.x) * own.x * own.y}) /
      ((I.z - I.x) * norm_squared(own));
  // Parts of the largest that the product of w and H and the difference can be: what data of nine digits leave of zero.
  constexpr double nine_digits = 1e-9;
  if (equal(0, 2) || around <= nine_digits) return Result::of_text("a point: the rotation about a principal axis");
  if (std::abs(towards_largest - towards_smallest) <= nine_digits * size)
    return Result::of_text("on the separatrix, towards the intermediate axis");
  const bool around_largest = towards_largest > towards_smallest;
  told(ToldQuantity::Kind::polhode, {around_largest ? 1.0 : -1.0, 0, 0});
  return Result::of_text(around_largest ? "around the axis of the largest moment"
                                        : "around the axis of the smallest moment");
}

template Value<double> QuantityScope<double>::inertia(const Call&, const Mark&, const Evaluator<double>&);
template Value<Dual<1>> QuantityScope<Dual<1>, double>::inertia(const Call&, const Mark&, const Evaluator<Dual<1>>&);
template Value<double> QuantityScope<double>::poinsot_construction(const Call&, const Mark&, const Evaluator<double>&,
                                                                   int, const Vector3<double>&, const Vector3<double>&);
template Value<double> QuantityScope<double>::free_motion(const Call&, const Mark&, const Evaluator<double>&);
template Value<Dual<1>> QuantityScope<Dual<1>, double>::free_motion(const Call&, const Mark&,
                                                                    const Evaluator<Dual<1>>&);
template Value<Dual<1>> QuantityScope<Dual<1>>::inertia(const Call&, const Mark&, const Evaluator<Dual<1>>&);
template Value<Dual<1, Dual<1>>> QuantityScope<Dual<1, Dual<1>>, Dual<1>>::inertia(const Call&, const Mark&,
                                                                                   const Evaluator<Dual<1, Dual<1>>>&);
template Value<Dual<1>> QuantityScope<Dual<1>>::free_motion(const Call&, const Mark&, const Evaluator<Dual<1>>&);
template Value<Dual<1, Dual<1>>> QuantityScope<Dual<1, Dual<1>>, Dual<1>>::free_motion(
    const Call&, const Mark&, const Evaluator<Dual<1, Dual<1>>>&);
template Value<Formula> QuantityScope<Formula>::inertia(const Call&, const Mark&, const Evaluator<Formula>&);
template Value<Dual<1, Formula>> QuantityScope<Dual<1, Formula>, Formula>::inertia(const Call&, const Mark&,
                                                                                   const Evaluator<Dual<1, Formula>>&);
template Value<Formula> QuantityScope<Formula>::free_motion(const Call&, const Mark&, const Evaluator<Formula>&);
template Value<Dual<1, Formula>> QuantityScope<Dual<1, Formula>, Formula>::free_motion(
    const Call&, const Mark&, const Evaluator<Dual<1, Formula>>&);

}  // namespace poinsot::problem
