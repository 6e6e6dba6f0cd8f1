#include "poinsot/engine/solve/instant/mechanism_state.h"

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "poinsot/engine/dynamics/action_forces.h"
#include "poinsot/engine/math/algebra/plain.h"
#include "poinsot/engine/math/formula/formula.h"
#include "poinsot/engine/work/work.h"

namespace poinsot::solve {
namespace {

template <class Scalar, class Law>
SpatialForce<Scalar> law_about(const Model<Scalar>& tree, const Workspace<Scalar>& w, const Law& law,
                               const Vector3<Scalar>& point) {
  return wrench_about(law.exerted(tree, w), point);
}
// The mass center of a body is known by the arm to it, however far both are from the origin of the ground: about it the
// couple of a pull keeps its digits.
template <class Scalar>
SpatialForce<Scalar> law_about(const Model<Scalar>& tree, const Workspace<Scalar>& w, const AttractionLaw<Scalar>& law,
                               const Vector3<Scalar>& point) {
  const PlacedForce<Scalar> pull = law.exerted(tree, w);
  const Vector3<Scalar> arm = direction_on_ground(tree, w, law.at.body, law.at.point), to_point = point - pull.point;
  // Formulas are exact and hold no rounding.
  if constexpr (std::is_same_v<Scalar, Formula>) return {pull.couple - cross(to_point, pull.force), pull.force};
  // Of places and of the way to the center that pulls: a body that is carried round it is where it is but for that.
  constexpr double rounding = 1e-14;
  const Vector3<Scalar> way = point_position(tree, w, law.toward.body, law.toward.point) - pull.point;
  const bool is_center =
      norm(plain(Vector3<Scalar>(to_point - arm))) <= rounding * (norm(plain(point)) + norm(plain(way)));
  return {pull.couple - cross(is_center ? arm : to_point, pull.force), pull.force};
}

}  // namespace

template <class Scalar>
MechanismStateOf<Scalar>::MechanismStateOf(const Mechanism<Scalar>& mechanism)
    : mechanism_(mechanism), workspace_(mechanism.tree), state_(neutral_state(mechanism.tree)) {
  accelerations_.assign(static_cast<std::size_t>(mechanism.tree.velocity_size()), Scalar(0));
  set_positions(state_.q);
}

template <class Scalar>
void MechanismStateOf<Scalar>::set_positions(const std::vector<Scalar>& q) {
  state_.q = q;
  std::fill(state_.v.begin(), state_.v.end(), Scalar(0));
  set_velocities(state_.v);
}

template <class Scalar>
void MechanismStateOf<Scalar>::set_velocities(const std::vector<Scalar>& v) {
  state_.v = v;
  std::fill(accelerations_.begin(), accelerations_.end(), Scalar(0));
  set_accelerations(accelerations_);
}

template <class Scalar>
void MechanismStateOf<Scalar>::set_accelerations(const std::vector<Scalar>& a) {
  constexpr Work of_a_freedom = 300;
  count_work(of_a_freedom * (1 + a.size()));
  accelerations_ = a;
  update_accelerations<Scalar>(mechanism_.tree, workspace_, state_, accelerations_);
}

template <class Scalar>
Vector3<Scalar> MechanismStateOf<Scalar>::position(const Place<Scalar>& place) const {
  return point_position(mechanism_.tree, workspace_, place.body, place.point);
}
template <class Scalar>
Vector3<Scalar> MechanismStateOf<Scalar>::velocity(const Place<Scalar>& place) const {
  return point_velocity(mechanism_.tree, workspace_, place.body, place.point);
}
template <class Scalar>
Vector3<Scalar> MechanismStateOf<Scalar>::direction(const Direction<Scalar>& direction) const {
  return direction_on_ground(mechanism_.tree, workspace_, direction.body, direction.vector);
}
template <class Scalar>
Vector3<Scalar> MechanismStateOf<Scalar>::on_ground_axes(int axes, const Vector3<Scalar>& vector) const {
  return direction_on_ground(mechanism_.tree, workspace_, axes, vector);
}

template <class Scalar>
SpatialForce<Scalar> MechanismStateOf<Scalar>::component_wrench(const Component<Scalar>& component) const {
  return wrench_of(component_force(mechanism_.tree, workspace_, component));
}

// The wrench per unit effort. A motor on an axis within gimbals that turn freely passes on a couple that has the
// component one along its own axis and none along the axes of the gimbals.
template <class Scalar>
SpatialForce<Scalar> MechanismStateOf<Scalar>::drive_wrench(const Drive<Scalar>& drive) const {
  const Vector3<Scalar> d = direction(drive.along);
  if (!drive.turning) return wrench_of<Scalar>({position(drive.at), d, Vector3<Scalar>::zero()});
  Vector3<Scalar> couple = d;
  if (drive.others.size() == 1) {
    const Vector3<Scalar> other = direction(drive.others[0]);
    couple = d - dot(d, other) * other;
  } else if (drive.others.size() == 2) {
    couple = cross(direction(drive.others[0]), direction(drive.others[1]));
  }
  // If the axes lie in one plane there is no such couple, and the couple along the motor's own axis is taken.
  const Scalar about_own = dot(couple, d);
  constexpr double in_one_plane = 1e-9;  // the cosine to the axis across the others: rounding of directions, magnified
  return {std::abs(plain(about_own)) < in_one_plane ? d : couple / about_own, Vector3<Scalar>::zero()};
}

template <class Scalar>
auto MechanismStateOf<Scalar>::known_forces() const -> std::vector<KnownForceOf> {
  std::vector<KnownForceOf> forces;
  for (const Drive<Scalar>& drive : mechanism_.drives) {
    const SpatialForce<Scalar> wrench = drive.known_effort(state_) * drive_wrench(drive);
    forces.push_back({drive.action, {Vector3<Scalar>::zero(), wrench.force, wrench.moment}});
  }
  for_each_law(mechanism_, [&](const auto& law) {
    forces.push_back({law.action, law.exerted(mechanism_.tree, workspace_)});
  });
  return forces;
}

template <class Scalar>
SpatialForce<Scalar> MechanismStateOf<Scalar>::known_wrench(int action, const Vector3<Scalar>& about) const {
  SpatialForce<Scalar> total = SpatialForce<Scalar>::zero();
  for (const Drive<Scalar>& drive : mechanism_.drives) {
    if (drive.action != action) continue;
    const SpatialForce<Scalar> wrench = drive.known_effort(state_) * drive_wrench(drive);
    total += SpatialForce<Scalar>{wrench.moment - cross(about, wrench.force), wrench.force};
  }
  for_each_law(mechanism_, [&](const auto& law) {
    if (law.action == action) total += law_about(mechanism_.tree, workspace_, law, about);
  });
  return total;
}

template class MechanismStateOf<double>;
template class MechanismStateOf<Dual<1>>;
template class MechanismStateOf<Formula>;

}  // namespace poinsot::solve
