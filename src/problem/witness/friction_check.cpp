// The second road to the laws of dry friction: how contacts come apart and slip is told by the bodies carried along
// from the figure (engine/solve/instant/constraint_check.h), and holds the forces of the answer against Coulomb's law.
// That these forces are those which the bodies need is the check with particles.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "poinsot/engine/solve/instant/constraint_check.h"
#include "problem/entries/read_joints.h"
#include "problem/instant/instant.h"
#include "problem/keys/joint_kinds.h"

namespace poinsot::problem {

// Of friction in a joint: what the relative motion of its bodies tells of the effort, as a part of the largest; by what
// it exceeds the limit at which it holds is weighed by the largest force, as of contacts, since its rounding is that of
// the whole mechanism.
double SolvedInstant::misfit_in_joint(const RoughContactOf<double>& contact) const {
  const RubbingJoint rubbing = rubbing_joint(situation_.joints, contact.name);
  const Joint& joint = rubbing.joint;
  const Friction& stated = rubbing.stated();
  if (!rubbing.freedom) return misfit_in_all_ways(contact, joint, stated);
  const Dimension dimension = contact.turning ? dimensions::moment : dimensions::force;
  const Vector3<double> axis = mechanism_state_->direction(contact.motions[1].along),
                        friction = rough_force(*mechanism_state_, unknowns_, contact).friction;
  const double effort = dot(friction, axis);
  const double coefficient = data_->number(contact.grip == Grip::sticks ? stated.resting : stated.sliding,
                                           stated.bearing ? dimensions::none : dimension);
  const LimitsOfFriction limits =
      stated.bearing ? limits_in_bearing(contact, joint, coefficient) : LimitsOfFriction{coefficient, coefficient};
  const double size = largest_force(*mechanism_state_, unknowns_) * (contact.turning ? scales_.length : 1);
  if (contact.grip == Grip::sticks)
    return std::max({0.0, effort - limits.forward, -effort - limits.backward}) /
           std::max({limits.forward, limits.backward, size});
  // How `to` turns over `from`, or how a point of it slides.
  const int on = machine_.index.at(joint.to), from = machine_.index.at(joint.from);
  const Workspace<double>& w = mechanism_state_->workspace();
  // Beside another axis about which the joint turns, the part that is no turning about that.
  Vector3<double> measured = axis;
  for (const Direction<double>& other : machine_.mechanism.drives[contact.ways.front().drive].others) {
    const Vector3<double> b = mechanism_state_->direction(other);
    measured = (axis - dot(axis, b) * b) / (1 - dot(axis, b) * dot(axis, b));
  }
  const auto along = [&](const Vector3<double>& one, const Vector3<double>& other) {
    return dot(one - other, measured);
  };
  const Vector3<double> P = mechanism_state_->position(machine_.joints.at(joint.name).at);
  const auto velocity_at = [&](int body) {
    const BodyMotion<double>& motion = w.motion[static_cast<std::size_t>(body + 1)];
    return motion.v + cross(motion.w, P - motion.p);
  };
  double rate = contact.turning ? along(angular_velocity(w, on), angular_velocity(w, from))
                                : along(velocity_at(on), velocity_at(from));
  constexpr double rest = 1e-9;  // of the pace
  if (std::abs(rate) <= rest * (contact.turning ? 1 : scales_.length) * pace())
    rate = mechanism_state_->accelerations()[static_cast<std::size_t>(contact.ways.front().coordinate)];
  // It resists motion backwards forwards.
  const double limit = rate > 0 ? limits.backward : limits.forward;
  if (stated.bearing) return size > 0 ? std::abs(effort + (rate > 0 ? limit : -limit)) / std::max(limit, size) : 0;
  if (!(limit > 0)) return effort == 0 ? 0 : 1;
  return std::abs(effort + (rate > 0 ? limit : -limit)) / limit;
}

// Of a joint whose friction is against its slip in several ways together: how the bodies move over each other where it
// is, what the friction exerts in that, by the figure, and what presses. A ball turns and rubs by a couple, what slides
// in a plane by a force, a sleeve by a force along its post and a couple round it, whose slip is the radius times the
// turning.
double SolvedInstant::misfit_in_all_ways(const RoughContactOf<double>& contact, const Joint& joint,
                                         const Friction& stated) const {
  const JointPlace& place = machine_.joints.at(joint.name);
  const Workspace<double>& w = mechanism_state_->workspace();
  const Vector3<double> P = mechanism_state_->position(place.at);
  const int on = place.to, from = place.from;
  const CommonSlip slip_kind = joint.kind->common_slip;
  const double r =
      stated.bearing && stated.bearing->radius ? data_->number(*stated.bearing->radius, dimensions::length) : 1;
  const Vector3<double> n = place.axis ? mechanism_state_->direction(*place.axis) : Vector3<double>{};
  const auto velocity_at = [&](int body) {
    const BodyMotion<double>& motion = w.motion[static_cast<std::size_t>(body + 1)];
    return motion.v + cross(motion.w, P - motion.p);
  };
  const Vector3<double> turning = angular_velocity(w, on) - angular_velocity(w, from),
                        sliding = velocity_at(on) - velocity_at(from);
  const SpatialForce<double> rubs =
      solve::action_wrench(*mechanism_state_, unknowns_, static_cast<std::size_t>(contact.action));
  const Vector3<double> couple = rubs.moment - cross(P, rubs.force);
  // Of a sleeve: the axial part along the first axis, that round it along the second.
  const auto on_sleeve = [&](double along, double round) { return Vector3<double>{along, round, 0}; };
  Vector3<double> slip = turning, friction = couple;
  if (slip_kind == CommonSlip::along_plane) {
    slip = sliding - dot(sliding, n) * n;
    friction = rubs.force;
  } else if (slip_kind == CommonSlip::along_and_round) {
    slip = on_sleeve(dot(sliding, n), r * dot(turning, n));
    friction = on_sleeve(dot(rubs.force, n), dot(couple, n) / r);
  }
  double pressed = 1;
  if (stated.bearing) {
    SpatialForce<double> carried = SpatialForce<double>::zero();
    for (const std::size_t i : machine_.actions_of(joint.name)) {
      const ActionKind kind = machine_.mechanism.actions[i].kind;
      if (kind == ActionKind::joint || kind == ActionKind::support)
        carried += solve::action_wrench(*mechanism_state_, unknowns_, i);
    }
    if (slip_kind == CommonSlip::turning) {
      pressed = r * norm(carried.force);
    } else if (slip_kind == CommonSlip::along_plane) {
      pressed = std::abs(dot(carried.force, n));
    } else if (stated.bearing->length) {
      const double L = data_->number(*stated.bearing->length, dimensions::length);
      // The moment about each end is that of the force at the other one.
      pressed = 0;
      for (const double end : {0.5, -0.5})
        pressed += norm(cross(n, carried.moment - cross(Vector3<double>(P - end * L * n), carried.force))) / L;
    } else {
      pressed = norm(cross(n, carried.force));
    }
  }
  const Dimension dimension = stated.bearing                     ? dimensions::none
                              : slip_kind == CommonSlip::turning ? dimensions::moment
                                                                 : dimensions::force;
  const double limit =
      pressed * data_->number(contact.grip == Grip::sticks ? stated.resting : stated.sliding, dimension);
  const double size =
      std::max(limit, largest_force(*mechanism_state_, unknowns_) * (contact.turning ? scales_.length : 1));
  if (!(size > 0)) return 0;
  if (contact.grip == Grip::sticks) return std::max(0.0, norm(friction) - limit) / size;
  // The smaller a slip is beside the motion the less its direction tells, as of contacts.
  constexpr double rest = 1e-9;
  const double speed = (contact.turning ? 1 : scales_.length) * pace();
  const bool slips = norm(slip) > (contact.turns ? 0 : rest * speed);
  const Vector3<double> begins = rough_motion(*mechanism_state_, contact, true).slip;
  // What begins to slip is told by its accelerations along the ways of its coordinates, on a sleeve unrolled.
  const Vector3<double> unrolled =
      slip_kind == CommonSlip::along_and_round
          ? on_sleeve(dot(begins, n), dot(begins, mechanism_state_->direction(contact.ways.front().along)))
          : begins;
  const Vector3<double> along = slips ? slip : unrolled;
  if (!(norm(along) > 0)) return 1;
  const double told = std::min(1.0, norm(along) / (slips ? speed : speed * pace()));
  return told * norm(friction + limit * normalized(along)) / size;
}

// What a bearing resists with at most, from the force and the moment that it carries: at two ends as the moments about
// each of them tell, and on a thread as the textbooks have it, with t = h/r, the force X on the screw along its axis
// and k = cos b_n: turned against X the thread takes the couple r |X| (k t + m)/(k - m t) in all, and turned with it r
// |X| (m - k t)/(k + m t).
SolvedInstant::LimitsOfFriction SolvedInstant::limits_in_bearing(const RoughContactOf<double>& contact,
                                                                 const Joint& joint, double coefficient) const {
  const Bearing& bearing = *joint.freedoms.front().friction->bearing;
  const auto length = [&](const std::optional<Expression>& stated) {
    return stated ? data_->number(*stated, dimensions::length) : 0.0;
  };
  const Vector3<double> axis = mechanism_state_->direction(contact.motions[1].along),
                        P = mechanism_state_->position(machine_.joints.at(contact.name).at);
  const auto across = [&](const Vector3<double>& v) { return norm(cross(axis, v)); };
  double pressed = 0;
  for (const std::size_t i : machine_.actions_of(joint.name)) {
    const ActionKind kind = machine_.mechanism.actions[i].kind;
    if (kind != ActionKind::joint && kind != ActionKind::support) continue;
    const SpatialForce<double> wrench = solve::action_wrench(*mechanism_state_, unknowns_, i);
    const double along = dot(wrench.force, axis);
    if (joint.kind->advances) {
      const double h = data_->value(*joint.pitch).number, r = length(bearing.radius), t = std::abs(h) / r;
      const double half = bearing.thread_angle ? data_->number(*bearing.thread_angle, dimensions::angle) / 2 : 0.0;
      const double k = 1 / std::hypot(1.0, std::tan(half) / std::hypot(1.0, t));
      // A friction beside the couple -h X of a smooth thread. What no couple turns has no limit.
      const double of_smooth = t * std::abs(along) * r;
      const double against = k > coefficient * t
                                 ? r * std::abs(along) * (k * t + coefficient) / (k - coefficient * t) - of_smooth
                                 : INFINITY,
                   with = r * std::abs(along) * (coefficient - k * t) / (k + coefficient * t) + of_smooth;
      // Turned forwards it goes against the load where X and h have one sign, and is resisted backwards.
      return along * h > 0 ? LimitsOfFriction{with, against} : LimitsOfFriction{against, with};
    }
    if (bearing.length) {
      const double L = length(bearing.length);
      for (const double end : {0.5, -0.5}) {
        // The moment about the other end is that of the force at this one.
        const Vector3<double> other = P - end * L * axis;
        pressed +=
            across(wrench.moment - cross(other, wrench.force)) / L * (contact.turning ? length(bearing.radius) : 1);
      }
    } else if (bearing.radius || !contact.turning) {
      pressed += across(wrench.force) * (contact.turning ? length(bearing.radius) : 1);
    }
    if (bearing.thrust_radius) pressed += std::abs(along) * length(bearing.thrust_radius);
  }
  return {coefficient * pressed, coefficient * pressed};
}

// How contacts come apart, and how their bodies move where they touch along the three axes of one of them: the normal
// that is not theirs is told by the surfaces.
std::vector<VelocityConstraint<double>> SolvedInstant::ways_of_contacts() const {
  std::vector<VelocityConstraint<double>> ways;
  for (const RoughContactOf<double>& contact : machine_.rough_contacts) {
    if (contact.in_joint() || contact.on_cord()) continue;
    ways.push_back(contact.motions.front());
    for (int k = 0; k < 3; ++k) {
      ways.push_back(contact.motions.front());
      ways.back().normal = false;
      ways.back().along.vector = Vector3<double>::unit(k);
    }
  }
  return ways;
}

// Of the four ways of a contact: the slip, by their rates or by the changes of these.
Vector3<double> SolvedInstant::slip_of(const solve::ContactRate* way, int from, bool change) const {
  Vector3<double> motion{};
  for (int k = 0; k < 3; ++k)
    motion +=
        (change ? way[k + 1].change : way[k + 1].rate) * mechanism_state_->direction({from, Vector3<double>::unit(k)});
  return motion - dot(motion, way->normal) * way->normal;
}

// Of a cord on a wheel: its angle round that from where it comes to it to where it leaves it, and the tension followed
// along it by small steps of Gauss's rule of order four for dT = mu T dtheta.
double SolvedInstant::misfit_on_cord(const RoughContactOf<double>& contact, double slip, double slip_rate,
                                     double force_size) const {
  const auto part_of = [&](int action) {
    return std::ranges::find(machine_.mechanism.components, action, &Component<double>::action);
  };
  const auto before = part_of(contact.action), behind = part_of(contact.behind);
  if (before == machine_.mechanism.components.end() || behind == machine_.mechanism.components.end()) return 1;
  const auto at = [&](const Place<double>& place) { return mechanism_state_->position(place); };
  const Vector3<double> comes = normalized(at(before->at) - at(*before->toward)),
                        leaves = normalized(at(behind->at) - at(*behind->toward)), C = at(behind->span->from.center);
  double angle = 0;
  if (behind->span->from.reach == 0) {
    angle = std::acos(std::clamp(dot(comes, leaves), -1.0, 1.0));
  } else {
    const Vector3<double> in = at(before->at) - C, out = at(*behind->toward) - C, axis = cross(in, comes);
    angle = std::atan2(dot(axis, cross(in, out)) / norm(axis), dot(in, out));
    if (angle < 0) angle += 2 * std::numbers::pi;
  }
  // How often it goes round besides is as stated; else it may have passed the place where its angle begins anew.
  constexpr double full = 2 * std::numbers::pi, alike = 0.5;
  std::optional<double> turns;
  for (const Cord& cord : situation_.cords)
    for (const CordWheel& wheel : cord.over)
      if (contact.name == cord.name + " on " + wheel.name && wheel.turns)
        turns = data_->number(*wheel.turns, dimensions::none);
  const double drawn = turns ? full * *turns : contact.wrap, whole = full * std::round((drawn - angle) / full);
  const bool may_pass = moving_ || whole < 0;
  if (turns || (may_pass && std::abs(drawn - angle - whole) < alike)) angle += whole;
  const Friction& stated = *std::ranges::find(situation_.contacts, contact.name, &Contact::name)->friction;
  const bool sticks = contact.grip == Grip::sticks;
  const double mu = data_->number(sticks ? stated.resting : stated.sliding, dimensions::none);
  constexpr int steps = 20000;
  constexpr double as_good_as_held = 40;  // e to it is beyond what doubles tell apart
  const double half = std::min(mu * angle, as_good_as_held) / steps / 2;
  double ratio = 1;
  for (int i = 0; i < steps; ++i) ratio *= (1 + half + half * half / 3) / (1 - half + half * half / 3);
  const auto tension = [&](int action) {
    return norm(solve::action_wrench(*mechanism_state_, unknowns_, static_cast<std::size_t>(action)).force);
  };
  const double T = tension(contact.action), T_behind = tension(contact.behind);
  if (sticks) return std::max(0.0, std::max(T, T_behind) - ratio * std::min(T, T_behind)) / force_size;
  const bool forward = (slip != 0 ? slip : slip_rate) > 0;
  return std::abs(forward ? T_behind - ratio * T : T - ratio * T_behind) / force_size;
}

namespace {

// The situation with all contacts and joints taken to stick that begin to slide although they have less friction while
// they slide than at rest; nothing if there are none.
std::optional<Situation> held_at_rest(const Situation& situation) {
  Situation held = situation;
  bool any = false;
  for (Contact& contact : held.contacts) {
    if (!contact.from_rest || !contact.friction->falls()) continue;
    contact.grip = Grip::sticks;
    contact.slip.reset();
    contact.from_rest = false;
    any = true;
  }
  return any ? std::optional(std::move(held)) : std::nullopt;
}

}  // namespace

double SolvedInstant::friction_misfit() const {
  const std::vector<VelocityConstraint<double>> ways = ways_of_contacts();
  const solve::ConstraintClaim claim{scales_.length, pace(), true, {}};
  const std::vector<solve::ContactRate> rates =
      solve::contact_rates(machine_.links, ways, claim, machine_.q, v_, mechanism_state_->accelerations());
  double force_size = largest_force(*mechanism_state_, unknowns_);
  for (int i = 0; i < machine_.mechanism.tree.body_count(); ++i)
    force_size =
        std::max(force_size, machine_.mechanism.tree.body(i).inertia.mass * norm(machine_.mechanism.tree.gravity()));
  if (!(force_size > 0)) return 0;
  // What the friction that is stated for rest can hold does not begin to slide.
  if (!moving_ && !before_ && !choice_.trial)
    if (const std::optional<Situation> held = held_at_rest(situation_)) try {
        SolvedInstant resting(*held, settings_, When{built_stage_.value_or(0), false}, {});
        resting.solve_forces();
        // Of a limit that is just passed the search leaves ten times as much.
        constexpr double held_for_sure = 1e-10;
        const bool parts = std::ranges::any_of(resting.one_sided_faults(), [](const OneSidedFault& fault) {
          return fault.broken == Holding::pulls || fault.broken == Holding::presses;
        });
        // Where it may be shared in several ways, one that holds is enough.
        if (!parts && !resting.uses_any() && resting.friction_misfit() <= held_for_sure) return 1;
      } catch (const StatementError&) {
        // What is stated does not go with rest there.
      }
  const double speed = scales_.length * claim.pace, acceleration = speed * claim.pace;
  double worst = 0;
  const auto vanishes = [&](double value, double size) {
    if (value != 0) worst = std::max(worst, size > 0 ? std::abs(value) / size : 1.0);
  };
  const auto* next = rates.data();
  for (const RoughContactOf<double>& contact : machine_.rough_contacts) {
    if (contact.in_joint()) {
      worst = std::max(worst, misfit_in_joint(contact));
      continue;
    }
    if (contact.on_cord()) {
      // A belt does not slip: that its wheels go as its sides do is told by its constraints.
      solve::ContactRate way{};
      if (!contact.of_belt)
        way = solve::contact_rates(machine_.links, {contact.motions[1]}, claim, machine_.q, v_,
                                   mechanism_state_->accelerations())
                  .front();
      constexpr double none = 1e-9;  // of the pace: a slip that is rounding has no sense
      const double slip = std::abs(way.rate) > none * speed ? way.rate : 0;
      if (contact.grip == Grip::sticks) {
        vanishes(way.rate, speed);
        vanishes(way.change, acceleration);
      }
      worst = std::max(worst, misfit_on_cord(contact, slip, way.change, force_size));
      continue;
    }
    const Friction& stated = *std::ranges::find(situation_.contacts, contact.name, &Contact::name)->friction;
    const auto* way = std::exchange(next, next + 4);
    const int from = contact.motions.front().along.body;
    const Vector3<double> slip = slip_of(way, from, false), slip_rate = slip_of(way, from, true);
    const Vector3<double> whole =
        solve::action_wrench(*mechanism_state_, unknowns_, static_cast<std::size_t>(contact.action)).force;
    const double push = dot(whole, way->normal);
    const RoughForce<double> force{push, whole - push * way->normal};
    vanishes(std::min(0.0, force.push), force_size);
    if (contact.grip == Grip::parts) {
      vanishes(norm(force.friction) + force.push, force_size);
      vanishes(std::min(0.0, way[0].change), acceleration);
      continue;
    }
    vanishes(way[0].rate, speed);
    vanishes(way[0].change, acceleration);
    if (contact.grip == Grip::sticks) {
      vanishes(norm(slip), speed);
      vanishes(norm(slip_rate), acceleration);
      vanishes(std::max(0.0, norm(force.friction) - data_->number(stated.resting, dimensions::none) * force.push),
               force_size);
      continue;
    }
    // A slip that is rounding beside the motion has no direction; the smaller it is the less its direction tells. One
    // that turns is followed until there is next to nothing of it.
    constexpr double rest = 1e-9;
    const bool slips = norm(slip) > (contact.turns ? 0 : rest * speed);
    const Vector3<double> along = slips ? slip : slip_rate;
    const double size = slips ? speed : acceleration;
    if (!(norm(along) > 0)) return 1;
    const double coefficient = data_->number(stated.sliding, dimensions::none);
    vanishes(std::min(1.0, norm(along) / size) * norm(force.friction + (coefficient * force.push) * normalized(along)),
             force_size);
  }
  return worst;
}

// The same for the impulses of a blow that starts from rest, and the velocities after it.
double SolvedInstant::blow_friction_misfit() const {
  const std::vector<VelocityConstraint<double>> ways = ways_of_contacts();
  const solve::ConstraintClaim claim{scales_.length, pace(), false, {}};
  const std::vector<solve::ContactRate> rates =
      solve::contact_rates(machine_.links, ways, claim, machine_.q, v_, std::vector<double>(v_.size(), 0.0));
  double largest = 0;
  for (std::size_t i = 0; i < machine_.mechanism.actions.size(); ++i)
    largest = std::max(largest, norm(solve::action_impulse(*before_, blow_, impulses_, i).force));
  if (!(largest > 0)) return 0;
  const double speed = scales_.length * claim.pace;
  double worst = 0;
  const auto* next = rates.data();
  for (const RoughContactOf<double>& contact : machine_.rough_contacts) {
    // What is limited has no impulse.
    if (contact.in_joint() || contact.on_cord()) continue;
    const auto* way = std::exchange(next, next + 4);
    const Friction& stated = *std::ranges::find(situation_.contacts, contact.name, &Contact::name)->friction;
    const Vector3<double> impulse =
        solve::action_impulse(*before_, blow_, impulses_, static_cast<std::size_t>(contact.action)).force;
    const double push = dot(impulse, way->normal), apart = way->rate / speed;
    const Vector3<double> friction = impulse - push * way->normal;
    const Vector3<double> slip = slip_of(way, contact.motions.front().along.body, false);
    worst = std::max({worst, -push / largest, -apart});
    // Either it parts, and nothing acts, or it stays, and its friction is that of its slip.
    worst = std::max(worst, std::min(std::abs(push) / largest + norm(friction) / largest, std::abs(apart)));
    const double resting = data_->number(stated.resting, dimensions::none) * push,
                 sliding = data_->number(stated.sliding, dimensions::none) * push;
    constexpr double rest = 1e-9;
    worst = std::max(worst, norm(slip) > rest * speed ? std::min(1.0, norm(slip) / speed) *
                                                            norm(friction + sliding * normalized(slip)) / largest
                                                      : (norm(friction) - resting) / largest);
  }
  return worst;
}

}  // namespace poinsot::problem
