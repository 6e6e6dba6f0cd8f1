// Moments and axes of inertia, and the free motion that they decide.
#include <array>
#include <cmath>
#include <type_traits>

#include "poinsot/mass/composition.h"
#include "poinsot/mass/principal_axes.h"
#include "statement/quantities.h"
#include "statement/quantity_values.h"

namespace poinsot::statement {

template <class Scalar>
Value<Scalar> QuantityScope<Scalar>::inertia(const Call& call, const Mark& mark, const Evaluator<Scalar>& evaluator) {
  const std::string& f = call.function;
  const Expression& what = call.arguments[0].value;
  const int body = body_of(what, evaluator, true);
  if (body == ground) evaluator.fail(what.mark(), "the ground has no inertia");
  const MassProperties<Scalar> mass = current_mass(body);
  if (f == "moment_of_inertia" || f == "radius_of_gyration") {
    const auto [P, d] = line(call, evaluator);
    const Scalar I = moment_about_axis(mass, P, d);
    if (f == "moment_of_inertia") return number_value(I, dimensions::moment_of_inertia);
    if (!(plain(mass.mass) > 0)) evaluator.fail(mark, "a massless body has no radius of gyration");
    using std::sqrt;
    return number_value(Scalar(sqrt(I / mass.mass)), dimensions::length);
  }
  const Vector P = place(*call.argument("about"), evaluator);
  const SymmetricMatrix3<Scalar> I = rotated(transpose(axes_), inertia_about(mass, P));
  const auto numbers = [&](std::array<Scalar, 3> list) {
    std::vector<Result> items;
    for (const Scalar& x : list) items.push_back(number_value(x, dimensions::moment_of_inertia));
    return Result::of_list(std::move(items));
  };
  if (f == "moments_of_inertia") return numbers({I.xx, I.yy, I.zz});
  if (f == "products_of_inertia") return numbers({Scalar(-I.xy), Scalar(-I.yz), Scalar(-I.zx)});
  if (f == "inertia_matrix") {
    const Matrix3<Scalar> M = as_matrix(I);
    return Result::of_list({numbers({M.row0.x, M.row0.y, M.row0.z}), numbers({M.row1.x, M.row1.y, M.row1.z}),
                            numbers({M.row2.x, M.row2.y, M.row2.z})});
  }
  if constexpr (std::is_same_v<Scalar, double>) {
    const PrincipalAxes<double> principal = principal_axes(I);
    if (f == "principal_moments") return numbers({principal.moments.x, principal.moments.y, principal.moments.z});
    // Components on the asked axes; the caller takes vectors from ground axes.
    std::vector<Result> items;
    for (std::size_t k = 0; k < 3; ++k)
      items.push_back(vector_value(axes_ * principal.axes.column(k), dimensions::none));
    return Result::of_list(std::move(items));
  } else {
    evaluator.fail(mark, f + " cannot stand inside rate()");
  }
}

// Of a body of revolution under no moment about its mass center (Eqs. 18.46 to 18.49): it precesses about its angular
// momentum H_G at H_G/I' and spins about its axis at H_G cos(theta) (I' - I)/(I I').
template <class Scalar>
Value<Scalar> QuantityScope<Scalar>::free_motion(const Call& call, const Mark& mark,
                                                 const Evaluator<Scalar>& evaluator) {
  if constexpr (!std::is_same_v<Scalar, double>) {
    evaluator.fail(mark, call.function + "() cannot stand inside rate() or among what is known of the velocities");
  } else {
    const std::string& f = call.function;
    const Expression& what = call.arguments[0].value;
    const int body = body_of(what, evaluator);
    if (is_frame(body)) evaluator.fail(what.mark(), "'" + to_string(what) + "' is no body");
    const Vector3<double> G = mass_center_of(body, what, evaluator);
    const Vector3<double> H = body_momentum(model_, workspace_, body, G).angular;
    const Vector3<double>& w = angular_velocity(workspace_, body);
    if (f == "precession_axis") {
      if (!(norm(H) > 0)) evaluator.fail(mark, "'" + to_string(what) + "' does not turn: it has no angular momentum");
      return vector_value(normalized(H), dimensions::none);
    }
    if (f == "space_cone") return number_value(std::atan2(norm(cross(H, w)), dot(H, w)), dimensions::angle);
    const PrincipalAxes<double> principal = principal_axes(current_mass(body).inertia_center, 1e-9);
    const auto equal = [&](std::size_t a, std::size_t b) {
      return std::abs(principal.moments[a] - principal.moments[b]) <= 1e-9 * principal.moments[2];
    };
    if (f == "axis_stability") {
      // Smallest, intermediate, largest; a rotation about one of two equal axes drifts to others when disturbed.
      const char* outer[2] = {equal(0, 1) ? "neutral" : "stable", equal(1, 2) ? "neutral" : "stable"};
      const char* middle = equal(0, 1) || equal(1, 2) ? "neutral" : "unstable";
      return Result::of_list({Result::of_text(outer[0]), Result::of_text(middle), Result::of_text(outer[1])});
    }
    const double twice_energy = dot(w, H);
    if (f == "invariable_plane" || f == "poinsot_ellipsoid" || f == "polhode") {
      if (!(norm(H) > 0)) evaluator.fail(mark, "'" + to_string(what) + "' does not turn: it has no angular momentum");
      if (f == "invariable_plane") return number_value(twice_energy / norm(H), dimensions::angular_velocity);
      if (f == "poinsot_ellipsoid") {
        std::vector<Result> semiaxes;
        for (std::size_t k = 0; k < 3; ++k)
          semiaxes.push_back(
              number_value(std::sqrt(twice_energy / principal.moments[k]), dimensions::angular_velocity));
        return Result::of_list(std::move(semiaxes));
      }
      // H^2 - 2 T I_2, from its terms: its sign tells about which axis the tip of w runs.
      const Vector3<double> own = transpose_times(principal.axes, w);
      const Vector3<double>& I = principal.moments;
      const double towards_largest = I.z * (I.z - I.y) * own.z * own.z,
                   towards_smallest = I.x * (I.y - I.x) * own.x * own.x;
      const double size = I.z * (I.z - I.x) * norm_squared(own);
      const double around = norm(cross(w, H)) / (norm(w) * norm(H));
      if (around <= 1e-9) return Result::of_text("a point: the rotation about a principal axis");
      if (std::abs(towards_largest - towards_smallest) <= 1e-9 * size)
        return Result::of_text("on the separatrix, towards the intermediate axis");
      return Result::of_text(towards_largest > towards_smallest ? "around the axis of the largest moment"
                                                                : "around the axis of the smallest moment");
    }
    if (principal.symmetry != InertiaSymmetry::axisymmetric)
      evaluator.fail(what.mark(),
                     "'" + to_string(what) + "' is no body of revolution: " +
                         (principal.symmetry == InertiaSymmetry::spherical ? "all its axes are alike"
                                                                           : "its three principal moments differ"),
                     "its motion is no steady precession");
    const double axial = principal.moments[principal.symmetry_axis],
                 transverse = principal.moments[principal.symmetry_axis == 0 ? 1 : 0];
    // The sense of the axis: that of the angular velocity, unless the caller says.
    Vector3<double> axis = principal.axes.column(principal.symmetry_axis);
    if (dot(axis, w) < 0) axis = -axis;
    if (const Expression* about = call.argument("about")) {
      const Result sense = evaluator(*about);
      if (!sense.is_vector() || norm(cross(sense.vector, axis)) > 1e-6 * norm(sense.vector))
        evaluator.fail(about->mark(),
                       "'" + to_string(*about) + "' is not the axis of revolution of '" + to_string(what) + "'");
      if (dot(sense.vector, axis) < 0) axis = -axis;
    }
    if (f == "symmetry_axis") return vector_value(axis, dimensions::none);
    if (f == "body_cone")
      return number_value(std::atan2(norm(cross(axis, w)), std::abs(dot(axis, w))), dimensions::angle);
    if (f == "precession_rate") return number_value(norm(H) / transverse, dimensions::angular_velocity);
    const double spin = dot(H, axis) * (transverse - axial) / (axial * transverse);
    if (f == "spin_rate") return number_value(spin, dimensions::angular_velocity);
    return Result::of_text(axial < transverse ? "direct" : "retrograde");
  }
}

template Value<double> QuantityScope<double>::inertia(const Call&, const Mark&, const Evaluator<double>&);
template Value<Dual<1>> QuantityScope<Dual<1>>::inertia(const Call&, const Mark&, const Evaluator<Dual<1>>&);
template Value<double> QuantityScope<double>::free_motion(const Call&, const Mark&, const Evaluator<double>&);
template Value<Dual<1>> QuantityScope<Dual<1>>::free_motion(const Call&, const Mark&, const Evaluator<Dual<1>>&);

}  // namespace poinsot::statement
