// The forces of the second road that are no energy's. Those that depend on the motion are given places, velocities and
// angles of displaced bodies by geometry; only their arithmetic is that of the law.
#include <cmath>

#include "engine/solve/stability/redundant_bodies.h"

namespace poinsot::solve {
namespace {

Place3 widened(const Vector3<double>& a) { return {a.x, a.y, a.z}; }

}  // namespace

Place3 RedundantBodies::angular_velocity_of(int body, const Displacements& at, const DisplacedRates& rates) const {
  if (body == ground) return Place3::Zero();
  const SteadyBody& one = bodies_[index(body)];
  if (!one.moves) return one.angular;
  return turning_ + rates[index(body)].turn + at[index(body)].turn * spin(index(body));
}

Place3 RedundantBodies::velocity_of(int body, const Displacements& at, const DisplacedRates& rates,
                                    const Place3& place) const {
  if (body == ground) return Place3::Zero();
  return velocity(body, at, place, rates[index(body)].shift, rates[index(body)].turn);
}

// A position coordinate of a joint of one freedom, or its rate.
Real RedundantBodies::coordinate(int coordinate, bool rate, const Displacements& at,
                                 const DisplacedRates& rates) const {
  const Model<double>& tree = mechanism_.tree;
  for (int i = 0; i < tree.body_count(); ++i) {
    const Body<double>& body = tree.body(i);
    const bool own = (rate ? body.v : body.q) == coordinate;
    if (!own || (body.joint != JointType::revolute && body.joint != JointType::prismatic)) continue;
    const int parent = body.parent;
    const Turn3 axes = read_axes(i);
    const Place3 z = axes.col(2), origin = widened(w_.motion[static_cast<std::size_t>(i + 1)].p);
    const Place3 along = turned(parent, at, z), here = moved(i, at, origin), there = moved(parent, at, origin);
    if (body.joint == JointType::revolute) {
      if (!rate) return motion_.q[static_cast<std::size_t>(body.q)] + turned_about(i, parent, at, z);
      return along.dot(angular_velocity_of(i, at, rates) - angular_velocity_of(parent, at, rates));
    }
    if (!rate) return motion_.q[static_cast<std::size_t>(body.q)] + along.dot(here - there);
    const Place3 apart = velocity_of(i, at, rates, here) - velocity_of(parent, at, rates, there);
    return along.dot(apart) + angular_velocity_of(parent, at, rates).cross(along).dot(here - there);
  }
  return std::nanl("");
}

Place3 RedundantBodies::part_of_motion(const MotionPart<double>& part, const Displacements& at,
                                       const DisplacedRates& rates) const {
  const int body = part.at.body;
  switch (part.kind) {
    case MotionPartKind::coordinate:
    case MotionPartKind::rate:
      return {coordinate(part.coordinate, part.kind == MotionPartKind::rate, at, rates), 0, 0};
    case MotionPartKind::direction:
      return turned(body, at, drawn(Direction<double>{body, part.at.point}));
    case MotionPartKind::angular_velocity:
      return angular_velocity_of(body, at, rates) - angular_velocity_of(part.seen_from, at, rates);
    case MotionPartKind::position:
    case MotionPartKind::velocity:
      break;
  }
  Place3 place = moved(body, at, drawn(part.at));
  if (part.kind == MotionPartKind::position) return place;
  return velocity_of(body, at, rates, place) - velocity_of(part.seen_from, at, rates, place);
}

Place3 RedundantBodies::size_by_motion(const MotionExpression<double>& load, const Displacements& at,
                                       const DisplacedRates& rates) const {
  Turn3 axes;
  for (int k = 0; k < 3; ++k)
    axes.col(k) = turned(load.axes, at, drawn(Direction<double>{load.axes, Vector3<double>::unit(k)}));
  std::vector<Place3> now;
  for (const MotionPart<double>& part : load.parts) {
    const bool number = part.kind == MotionPartKind::coordinate || part.kind == MotionPartKind::rate;
    const Place3 value = part_of_motion(part, at, rates);
    now.push_back(number ? value : Place3(axes.transpose() * value));
  }
  const auto found = detail::run_motion_steps<Real>(
      load.steps, load.results, [&](int i, int k) { return now[static_cast<std::size_t>(i)][k]; },
      [&](int i) { return Real(load.constants[static_cast<std::size_t>(i)]); });
  return axes * Place3(found[0], found[1], found[2]);
}

std::vector<RedundantBodies::Push> RedundantBodies::pushes(const Displacements& at, const DisplacedRates& rates) const {
  std::vector<Push> found;
  for (const KnownForce<double>& force : mechanism_.forces) {
    const Action& action = mechanism_.actions[static_cast<std::size_t>(force.action)];
    const Place3 size = force.by_motion ? size_by_motion(*force.by_motion, at, rates)
                                        : turned(force.axes, at, drawn(Direction<double>{force.axes, force.vector}));
    const Place3 none = Place3::Zero();
    const Place3 place = force.couple ? none : moved(force.at.body, at, drawn(force.at));
    found.push_back({action.on, action.from, place, force.couple ? none : size, force.couple ? size : none});
  }
  return found;
}

}  // namespace poinsot::solve
