#include "engine/solve/stability/redundant_bodies.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <type_traits>

#include "poinsot/engine/dynamics/velocity_constraint.h"
#include "poinsot/engine/work/budget.h"

namespace poinsot::solve {
namespace {

Place3 wide(const Vector3<double>& a) { return {a.x, a.y, a.z}; }
Turn3 wide(const Matrix3<double>& M) {
  return Turn3::NullaryExpr(
      [&](Eigen::Index i, Eigen::Index k) { return Real(M(static_cast<int>(i), static_cast<int>(k))); });
}
Turn3 wide(const SymmetricMatrix3<double>& I) {
  Turn3 M;
  M << I.xx, I.xy, I.zx, I.xy, I.yy, I.yz, I.zx, I.yz, I.zz;
  return M;
}

// Two unit vectors across a third.
std::pair<Place3, Place3> across(const Place3& axis) {
  const Place3 a = axis.unitOrthogonal();
  return {a, axis.cross(a)};
}

// Of its size: what counts as none of a spin or of a sine. Velocities and directions come from the solved instant,
// where facts may hold to 1e-9 only; a spin that is meant is no billionth of the turning beside it.
constexpr Real nothing = 1e-9L;

}  // namespace

Turn3 crossing(const Place3& a) {
  Turn3 M;
  M << 0, -a.z(), a.y(), a.z(), 0, -a.x(), -a.y(), a.x(), 0;
  return M;
}
Turn3 turned_by(const Place3& turn) {
  const Real angle = turn.norm();
  if (angle == 0) return Turn3::Identity();
  return Eigen::AngleAxis<Real>(angle, turn / angle).toRotationMatrix();
}

std::unique_ptr<RedundantBodies> RedundantBodies::find(const SteadyMotion& motion) {
  std::unique_ptr<RedundantBodies> found(new RedundantBodies(motion));
  return found->read() ? std::move(found) : nullptr;
}

RedundantBodies::RedundantBodies(const SteadyMotion& motion)
    : motion_(motion), mechanism_(*motion.mechanism), w_(mechanism_.tree), turning_(wide(motion.turning)) {
  update_velocities<double>(mechanism_.tree, w_, State<double>{motion.q, motion.v});
  for (int i = 0; i < mechanism_.tree.body_count(); ++i) {
    const Body<double>& body = mechanism_.tree.body(i);
    const BodyMotion<double>& at = w_.motion[static_cast<std::size_t>(i + 1)];
    SteadyBody found;
    // Links within a joint take no part either, but are driven: only frames move as stated.
    found.moves = mechanism_.takes_part[static_cast<std::size_t>(i)] ||
                  std::ranges::any_of(mechanism_.drives, [&](const Drive<double>& drive) {
                    return drive.coordinate >= body.v && drive.coordinate < body.v + velocity_size(body.joint);
                  });
    found.mass = body.inertia.mass;
    const Place3 c = found.mass > 0 ? Place3(wide(body.inertia.first_moment) / found.mass) : Place3(Place3::Zero());
    const Turn3 R = wide(at.R), cross = crossing(c);
    const Turn3 inertia = wide(body.inertia.inertia) + found.mass * cross * cross;
    found.inertia = R * inertia * R.transpose();
    found.center = wide(at.p) + R * c;
    found.angular = wide(at.w);
    found.velocity = wide(at.v) + found.angular.cross(R * c);
    bodies_.push_back(found);
  }
  // The axis of the frame: mass centers go round it, and along it as fast as they may.
  axis_point_ = drift_ = Place3::Zero();
  for (const SteadyBody& body : bodies_)
    if (body.moves && body.mass > 0) {
      axis_point_ = body.center;
      if (turning_.norm() > 0) axis_point_ += turning_.cross(body.velocity) / turning_.squaredNorm();
      drift_ = body.velocity - turning_.cross(body.center - axis_point_);
      break;
    }
}

Place3 RedundantBodies::drawn(const Place<double>& place) const {
  return wide(point_position(mechanism_.tree, w_, place.body, place.point));
}
Place3 RedundantBodies::drawn(const Direction<double>& direction) const {
  return wide(direction_on_ground(mechanism_.tree, w_, direction.body, direction.vector));
}
Place3 RedundantBodies::moved(int body, const Displacements& at, const Place3& drawn) const {
  if (body == ground) return drawn;
  const Place3& c = bodies_[index(body)].center;
  return c + at[index(body)].shift + at[index(body)].turn * (drawn - c);
}
Place3 RedundantBodies::center(int body, const Displacements& at) const {
  return body == ground ? Place3(Place3::Zero()) : Place3(bodies_[index(body)].center + at[index(body)].shift);
}
Place3 RedundantBodies::velocity(int body, const Displacements& at, const Place3& place, const Place3& rate,
                                 const Place3& turn) const {
  if (body == ground) return Place3::Zero();
  const SteadyBody& one = bodies_[index(body)];
  if (!one.moves) return one.velocity + one.angular.cross(place - one.center);
  const Place3 relative = turn + at[index(body)].turn * spin(index(body)), c = center(body, at);
  return drift_ + turning_.cross(place - axis_point_) + rate + relative.cross(place - c);
}

// The angle of one body relative to another about an axis that both share.
Real RedundantBodies::turned_about(int on, int from, const Displacements& at, const Place3& axis) const {
  const Place3 u = turned(from, at, axis);
  const Place3 a = across(axis).first, one = turned(from, at, a), other = turned(on, at, a);
  return std::atan2(u.dot(one.cross(other)), one.dot(other));
}

bool RedundantBodies::read() {
  // What a velocity that was solved for has of the fastest turning is rounding.
  Real fastest = turning_.norm();
  for (const SteadyBody& body : bodies_) fastest = std::max(fastest, body.angular.norm());
  const auto spins = [&](int body) {
    return body != ground && bodies_[index(body)].moves && spin(index(body)).norm() > nothing * fastest;
  };
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    // A body whose inertia goes round as it spins is in no steady motion on these axes.
    const Place3 s = spin(i);
    const Turn3 change = crossing(s) * bodies_[i].inertia - bodies_[i].inertia * crossing(s);
    if (spins(static_cast<int>(i)) && change.norm() > nothing * (s.norm() * bodies_[i].inertia.norm())) return false;
    if (bodies_[i].moves && !(read_joint(static_cast<int>(i)) && read_held(static_cast<int>(i)))) return false;
  }
  for_each_law(mechanism_, []<class Law>(const Law&) {
    static_assert(
        std::is_same_v<Law, KnownForce<double>> || std::is_same_v<Law, SpringLaw<double>> ||
            std::is_same_v<Law, TorsionLaw<double>> || std::is_same_v<Law, AttractionLaw<double>>,
        "write the law's energy, pushes and dampers below on a road of its own, or return false where one is stated");
  });
  // What a damper on a body that spins loses is no matter of lengths and angles alone.
  const auto damps_spin = [&](const auto& law, int on, int from) {
    return law.damping != 0 && (spins(on) || spins(from));
  };
  for (const SpringLaw<double>& spring : mechanism_.springs)
    if (damps_spin(spring, spring.at.body, spring.toward.body)) return false;
  for (const TorsionLaw<double>& spring : mechanism_.torsions)
    if (damps_spin(spring, spring.on, spring.along.body)) return false;
  for (const Drive<double>& drive : mechanism_.drives) {
    const Action& action = mechanism_.actions[static_cast<std::size_t>(drive.action)];
    if (!drive.held && damps_spin(drive, action.on, action.from)) return false;
  }
  for (const Drive<double>& drive : mechanism_.drives) {
    const JointType joint = mechanism_.tree.body(mechanism_.actions[static_cast<std::size_t>(drive.action)].on).joint;
    const bool single = joint == JointType::revolute || joint == JointType::prismatic;
    if (!drive.held && (!single || !drive.others.empty()) && (drive.stores() || drive.drains() || drive.feeds()))
      return false;
  }
  return read_constraints();
}

Turn3 RedundantBodies::read_axes(int body) const { return wide(w_.motion[static_cast<std::size_t>(body + 1)].R); }

bool RedundantBodies::read_joint(int i) {
  const Body<double>& body = mechanism_.tree.body(i);
  const int parent = body.parent;
  const BodyMotion<double>& now = w_.motion[static_cast<std::size_t>(i + 1)];
  const Place3 origin = wide(now.p);
  const Turn3 axes = wide(now.R);
  const Place3 z = axes.col(2);
  const auto sides = across(z);
  const Place3 &x = sides.first, &y = sides.second;
  const auto apart = [this, i, parent, origin](const Displacements& at) {
    return Place3(moved(i, at, origin) - moved(parent, at, origin));
  };
  const auto meet = [&](const Place3& d) {
    gaps_.push_back([apart, d](const Displacements& at) { return d.dot(apart(at)); });
  };
  // Two directions, one on each body, that stay perpendicular.
  const auto square = [&](const Place3& own, const Place3& other) {
    gaps_.push_back([this, i, parent, own, other](const Displacements& at) {
      return turned(i, at, own).dot(turned(parent, at, other));
    });
  };
  const auto stay_on_line = [&] {
    for (const Place3& d : {x, y})
      gaps_.push_back(
          [this, apart, parent, d](const Displacements& at) { return turned(parent, at, d).dot(apart(at)); });
  };
  const auto meet_everywhere = [&] {
    for (int k = 0; k < 3; ++k) meet(Place3::Unit(k));
  };
  switch (body.joint) {
    case JointType::free:
      return true;
    case JointType::ball:
      meet_everywhere();
      return true;
    case JointType::revolute:
      meet_everywhere();
      square(z, x);
      square(z, y);
      return true;
    case JointType::prismatic:
      stay_on_line();
      break;
    case JointType::weld:
      meet_everywhere();
      break;
    default:
      return false;
  }
  square(x, y);
  square(y, z);
  square(z, x);
  return true;
}

bool RedundantBodies::read_held(int i) {
  const Body<double>& body = mechanism_.tree.body(i);
  const Turn3 axes = wide(w_.motion[static_cast<std::size_t>(i + 1)].R);
  const Place3 origin = wide(w_.motion[static_cast<std::size_t>(i + 1)].p), z = axes.col(2);
  for (int k = body.v; k < body.v + velocity_size(body.joint); ++k) {
    const bool unseen =
        std::ranges::any_of(motion_.unseen, [&](const UnseenMotion& one) { return one.coordinate == k; });
    if (!motion_.held[static_cast<std::size_t>(k)] && !unseen) continue;
    const int parent = body.parent;
    if (body.joint == JointType::revolute || body.joint == JointType::prismatic)
      held_gaps_.emplace_back(k, gaps_.size());
    if (body.joint == JointType::revolute) {
      gaps_.push_back([this, i, parent, z](const Displacements& at) { return turned_about(i, parent, at, z); });
    } else if (body.joint == JointType::prismatic) {
      gaps_.push_back([this, i, parent, z, origin](const Displacements& at) {
        return turned(parent, at, z).dot(moved(i, at, origin) - moved(parent, at, origin));
      });
    } else if (k < body.v + 3) {
      const Place3 axis = axes.col(k - body.v);
      gaps_.push_back([this, i, parent, axis](const Displacements& at) {
        const Turn3 R = at[index(parent)].turn.transpose() * at[index(i)].turn;
        return axis.dot(Place3(R(2, 1) - R(1, 2), R(0, 2) - R(2, 0), R(1, 0) - R(0, 1))) / 2;
      });
    } else {
      const Place3 axis = axes.col(k - body.v - 3);
      gaps_.push_back(
          [this, i, axis, origin](const Displacements& at) { return axis.dot(moved(i, at, origin) - origin); });
    }
  }
  return true;
}

RedundantBodies::Straight RedundantBodies::straight(const CordSpan<double>& span, const Displacements& at) const {
  const Place3 A = moved(span.from.body(), at, drawn(span.from.center)),
               B = moved(span.to.body(), at, drawn(span.to.center)), D = B - A;
  if (span.from.reach == 0 && span.to.reach == 0) return {A, B, Place3::Zero()};
  const Place3 e = turned(span.axis.body, at, drawn(span.axis));
  const Place3 across = D - D.dot(e) * e, x = across.normalized(), y = e.cross(x);
  const Real angle = -std::asin((Real(span.from.reach) - Real(span.to.reach)) / across.norm());
  const Place3 n = std::cos(angle) * y - std::sin(angle) * x;
  return {A + Real(span.from.reach) * n, B + Real(span.to.reach) * n, e};
}

// Of a cord that slides over its wheels, but for what lies on them at `from`.
Real RedundantBodies::led_length(const VelocityConstraint<double>& c, const Displacements& at,
                                 const Displacements& from) const {
  Real length = 0;
  for (std::size_t i = 0; i < c.spans.size(); ++i) {
    const Straight part = straight(c.spans[i], at);
    length += (part.end - part.start).norm();
    if (i == 0 || c.spans[i].from.reach == 0) continue;
    const auto turn = [&](const Displacements& where) {
      const Straight one = straight(c.spans[i - 1], where), next = straight(c.spans[i], where);
      const Place3 before = one.end - one.start, behind = next.end - next.start;
      return std::atan2(next.axis.dot(before.cross(behind)), before.dot(behind));
    };
    length -= Real(c.spans[i].from.reach) * std::remainder(turn(at) - turn(from), 2 * std::numbers::pi_v<Real>);
  }
  return length;
}

// Where two curved shapes touch, by the equations of their surfaces.
std::optional<drawn::NearestPlace> RedundantBodies::touching(const VelocityConstraint<double>& c,
                                                             const Displacements& at) const {
  const auto slim = [](const Place3& a) { return drawn::Vector{a.x(), a.y(), a.z()}; };
  const auto placed = [&](int body, const ContactSurface<double>& s, const Displacements& then) {
    return converted_surface<Real>(
        s,
        [&](const Vector3<double>& p) {
          return slim(moved(body, then, drawn(Place<double>{body, p})));
        },
        [&](const Vector3<double>& d) {
          return slim(turned(body, then, drawn(Direction<double>{body, d})));
        },
        [](double x) { return Real(x); });
  };
  const CurvedContact<double>& both = *c.surfaces;
  const Place3 guess = moved(c.on, at, wide(constraint_point(mechanism_.tree, w_, c)));
  return drawn::nearest_place(placed(c.on, both.shape_on, at), placed(c.from, both.shape_from, at), slim(guess));
}

bool RedundantBodies::read_constraints() {
  for (const VelocityConstraint<double>& c : mechanism_.constraints) {
    const int on = c.on, from = c.from;
    const Place3 at_on = drawn(c.at), d = drawn(c.along), other = drawn(c.toward);
    switch (c.kind) {
      case VelocityConstraintKind::angular:
        gaps_.push_back([this, on, from, d](const Displacements& at) {
          const Turn3 R = at[index(from)].turn.transpose() * at[index(on)].turn;
          return d.dot(Place3(R(2, 1) - R(1, 2), R(0, 2) - R(2, 0), R(1, 0) - R(0, 1))) / 2;
        });
        break;
      case VelocityConstraintKind::cord_length: {
        const Real length = (at_on - other).norm();
        gaps_.push_back([this, on, from, at_on, other, length](const Displacements& at) {
          return (moved(on, at, at_on) - moved(from, at, other)).norm() - length;
        });
        break;
      }
      case VelocityConstraintKind::led_cord: {
        // What does not slip over several parts together touches at no one place.
        if (!c.keeps_length && c.spans.size() > 1) return false;
        if (!c.keeps_length) break;
        const Displacements none(bodies_.size() + 1);
        gaps_.push_back([this, &c, as_now = led_length(c, none, none)](const Displacements& at) {
          return led_length(c, at, Displacements(bodies_.size() + 1)) - as_now;
        });
        break;
      }
      case VelocityConstraintKind::point:
        if (c.action >= 0 && !c.normal) break;
        gaps_.push_back([this, on, from, at_on, d](const Displacements& at) {
          return turned(from, at, d).dot(moved(on, at, at_on) - moved(from, at, at_on));
        });
        break;
      case VelocityConstraintKind::touching:
        if (!touching(c, Displacements(bodies_.size() + 1))) return false;
        if (!c.normal) break;
        gaps_.push_back([this, &c](const Displacements& at) {
          const auto place = touching(c, at);
          return place ? place->gap : std::numeric_limits<Real>::quiet_NaN();
        });
        break;
      case VelocityConstraintKind::rolling: {
        const Place3 n = drawn(c.surface_axis), center = drawn(Place<double>{on, c.center});
        const Place3 e = norm(c.axis) > 0 ? drawn(Direction<double>{on, c.axis}) : Place3(Place3::Zero());
        if ((n - n.dot(e) * e).norm() < nothing) return false;
        if (!c.normal) break;
        const Real radius = c.radius, side = (center - other).dot(n) < 0 ? -1 : 1;
        // Of all points of the circle the lowest one touches.
        gaps_.push_back([this, on, from, n, e, center, other, radius, side](const Displacements& at) {
          const Place3 up = turned(from, at, n);
          const Real along = up.dot(turned(on, at, e));
          return up.dot(moved(on, at, center) - moved(from, at, other)) - side * radius * std::sqrt(1 - along * along);
        });
        break;
      }
    }
  }
  return true;
}

std::vector<Real> RedundantBodies::gaps(const Displacements& at) const {
  check_budget();
  std::vector<Real> found;
  for (const auto& gap : gaps_) found.push_back(gap(at));
  return found;
}

std::optional<std::size_t> RedundantBodies::gap_of(int coordinate) const {
  const auto found = std::ranges::find(held_gaps_, coordinate, &std::pair<int, std::size_t>::first);
  if (found == held_gaps_.end()) return std::nullopt;
  return found->second;
}

std::vector<RedundantBodies::Touch> RedundantBodies::touches(const Displacements& at) const {
  std::vector<Touch> found;
  for (const VelocityConstraint<double>& c : mechanism_.constraints) {
    if (c.action < 0 || c.normal || is_cord_length(c)) continue;
    if (c.kind == VelocityConstraintKind::led_cord) {
      const Straight part = straight(c.spans.front(), at);
      found.push_back({c.on, c.from, part.end, (part.end - part.start).normalized()});
      continue;
    }
    Touch touch{c.on, c.from, moved(c.at.body, at, drawn(c.at)), turned(c.along.body, at, drawn(c.along))};
    if (c.kind == VelocityConstraintKind::rolling) {
      const Place3 up = turned(c.from, at, drawn(c.surface_axis)), center = drawn(Place<double>{c.on, c.center});
      const Place3 e =
          norm(c.axis) > 0 ? turned(c.on, at, drawn(Direction<double>{c.on, c.axis})) : Place3(Place3::Zero());
      const Real side = (center - drawn(c.toward)).dot(up) < 0 ? -1 : 1;
      touch.place = moved(c.on, at, center) - side * c.radius * (up - up.dot(e) * e).normalized();
    }
    if (c.kind == VelocityConstraintKind::touching)
      if (const auto place = touching(c, at)) touch.place = {place->point.x, place->point.y, place->point.z};
    found.push_back(touch);
  }
  return found;
}

// A center that pulls rests in the frame as it does on the ground: it lies on the axis. What the energy is beyond that
// of the motion itself is told without their difference, in which a turn of a small body would be lost:
//
//   1/r - 1/r0 = (r0^2 - r^2)/(r r0 (r + r0)),      r^2 - r0^2 = (2 r0 + d) . d.
Real RedundantBodies::energy_of_pull(const AttractionLaw<double>& pull, const Displacements& at) const {
  const int body = pull.at.body;
  const Turn3 axes = wide(body_rotation(mechanism_.tree, w_, body));
  const Place3 origin = wide(w_.motion[static_cast<std::size_t>(body + 1)].p);
  const Place3& G = bodies_[index(body)].center;
  const Displaced& displaced = at[index(body)];
  Real V = 0;
  for (const AttractedPart<double>& part : pull.parts) {
    const Place3 arm = axes * wide(part.center), before = origin + arm - drawn(pull.toward);
    const Place3 off = displaced.shift + (displaced.turn - Turn3::Identity()) * (origin - G + arm);
    const Place3 now = before + off;
    const Real r = now.norm(), r0 = before.norm();
    V += pull.parameter * part.mass * (2 * before + off).dot(off) / (r * r0 * (r + r0));
    if (!part.by_moments) continue;
    const Turn3 I = axes * wide(part.inertia) * axes.transpose();
    const Place3 seen = displaced.turn.transpose() * (now / r);
    V -= pull.parameter * (I.trace() - 3 * seen.dot(I * seen)) / (2 * r * r * r);
  }
  return V;
}

Real RedundantBodies::energy(const Displacements& at) const {
  check_budget();
  Real V = 0;
  const Place3 g = wide(mechanism_.tree.gravity());
  for (std::size_t i = 0; i < bodies_.size(); ++i)
    if (bodies_[i].moves) V -= bodies_[i].mass * g.dot(bodies_[i].center + at[i].shift);
  const auto ends = [&](const SpringLaw<double>& spring) {
    return (moved(spring.at.body, at, drawn(spring.at)) - moved(spring.toward.body, at, drawn(spring.toward))).norm();
  };
  for (const SpringLaw<double>& spring : mechanism_.springs) {
    const Real stretch = ends(spring) - spring.free_length;
    V += spring.stiffness * stretch * stretch / 2;
  }
  for (const TorsionLaw<double>& spring : mechanism_.torsions) {
    const Real now = spring.angle(mechanism_.tree, w_) - spring.free_angle;
    const Real turned = now + turned_about(spring.on, spring.along.body, at, drawn(spring.along));
    V += spring.stiffness * turned * turned / 2;
  }
  for (const AttractionLaw<double>& pull : mechanism_.attractions) V += energy_of_pull(pull, at);
  for (const Drive<double>& drive : mechanism_.drives) {
    if (drive.held || !(drive.stores() || drive.feeds())) continue;
    const Action& action = mechanism_.actions[static_cast<std::size_t>(drive.action)];
    const Place3 axis = drawn(drive.along), here = drawn(drive.at);
    const Real moves =
        drive.turning ? turned_about(action.on, action.from, at, axis)
                      : turned(action.from, at, axis).dot(moved(action.on, at, here) - moved(action.from, at, here));
    const Real from_free = motion_.q[static_cast<std::size_t>(drive.position)] - drive.free_position + moves;
    V += drive.stiffness * from_free * from_free / 2 - drive.effort * moves;
  }
  return V;
}

std::vector<std::pair<Real, Real>> RedundantBodies::damped(const Displacements& at) const {
  std::vector<std::pair<Real, Real>> found;
  for (const SpringLaw<double>& spring : mechanism_.springs)
    if (spring.damping != 0)
      found.emplace_back(
          (moved(spring.at.body, at, drawn(spring.at)) - moved(spring.toward.body, at, drawn(spring.toward))).norm(),
          spring.damping);
  for (const TorsionLaw<double>& spring : mechanism_.torsions)
    if (spring.damping != 0)
      found.emplace_back(turned_about(spring.on, spring.along.body, at, drawn(spring.along)), spring.damping);
  for (const Drive<double>& drive : mechanism_.drives) {
    if (drive.held || drive.damping == 0) continue;
    const Action& action = mechanism_.actions[static_cast<std::size_t>(drive.action)];
    const Place3 axis = drawn(drive.along), here = drawn(drive.at);
    found.emplace_back(
        drive.turning ? turned_about(action.on, action.from, at, axis)
                      : turned(action.from, at, axis).dot(moved(action.on, at, here) - moved(action.from, at, here)),
        drive.damping);
  }
  return found;
}

}  // namespace poinsot::solve
