// Prepares the linearised equations near a steady motion.
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "poinsot/engine/mass/principal_axes.h"
#include "poinsot/engine/motion/mechanism/mechanism_dynamics.h"
#include "poinsot/engine/solve/stability/changing_equations.h"
#include "poinsot/engine/solve/stability/steady_loads.h"
#include "problem/instant/accelerated_frame.h"
#include "problem/instant/instant.h"
#include "problem/instant/instant_conditions.h"
#include "problem/instant/massless_turning.h"
#include "problem/instant/open_words.h"
#include "problem/language/diagnostic.h"

namespace poinsot::problem {
namespace {

using Vector = Vector3<double>;
using Twist = SpatialMotion<double>;

// Of moments, sines and lengths: what is the same or nothing but for data that are stated to nine digits. The
// symmetries that follow from it are looked at once more by their effect on the equations (same_motion.h).
constexpr double nine_digits = 1e-9;

// The axes of symmetry of a body's inertia about its mass center: three for a body whose moments are all equal.
std::vector<Vector> symmetry_axes(const SpatialInertia<double>& I) {
  if (!(I.mass > 0)) return {};
  const Vector c = I.first_moment / I.mass;
  const auto principal = principal_axes(I.inertia - I.mass * unit_mass_inertia(c));
  const Vector& m = principal.moments;
  const auto equal = [&](std::size_t a, std::size_t b) {
    return std::abs(m[a] - m[b]) <= nine_digits * (m[0] + m[1] + m[2]);
  };
  if (equal(0, 1) && equal(1, 2)) return {Vector::unit(0), Vector::unit(1), Vector::unit(2)};
  std::vector<Vector> axes;
  for (std::size_t k = 0; k < 3; ++k)
    if (equal((k + 1) % 3, (k + 2) % 3)) axes.push_back(principal.axes.column(k));
  return axes;
}

// Near a steady motion a load that depends on the motion must keep its coefficients.
void refuse_unsteady_loads(const Situation& situation, const Mark& mark, const solve::SteadyMotion& motion,
                           double pace) {
  const auto& forces = motion.mechanism->forces;
  const auto by_motion = std::ranges::find_if(forces, [](const auto& force) { return force.by_motion != nullptr; });
  if (by_motion == forces.end()) return;
  const auto name = [&](const KnownForce<double>& force) {
    return motion.mechanism->actions[static_cast<std::size_t>(force.action)].name;
  };
  const auto rides = [&](const Frame& frame) {
    return situation.steady && frame.name == situation.steady->frame && !frame.rides_on.empty();
  };
  if (std::ranges::any_of(situation.frames, rides))
    throw UnansweredError(
        situation.file, mark,
        "the load '" + name(*by_motion) +
            "' depends on the motion, of which a frame that rides on a mass center states only a part",
        "state the steady motion in a frame that turns about an axis of the ground");
  const auto unsteady = solve::unsteady_load(motion, pace);
  if (unsteady && unsteady->corner)
    throw UnansweredError(situation.file, mark,
                          "the load '" + name(forces[unsteady->force]) +
                              "' has a corner at this motion: it has no slope there that the motion near by could have",
                          "state it without abs, norm, min or max where their arguments vanish or are equal");
  if (unsteady)
    throw UnansweredError(situation.file, mark,
                          "the load '" + name(forces[unsteady->force]) +
                              "' does not go round with the frame of the steady motion: near it the equations have "
                              "coefficients that change with time",
                          "let it depend on what goes round with the frame alone");
}

// Near a steady motion a center that pulls must rest in its frame: it lies on the axis about which the frame turns.
void refuse_center_off_axis(const Situation& situation, const Mark& mark, const solve::MechanismState& state, int frame,
                            double pace) {
  const Mechanism<double>& mechanism = state.mechanism();
  if (mechanism.attractions.empty()) return;
  const Vector O = state.position(mechanism.attractions.front().toward);
  const BodyMotion<double>& F = state.workspace().motion[static_cast<std::size_t>(frame + 1)];
  double length = norm(Vector(O - F.p));
  for (const AttractionLaw<double>& pull : mechanism.attractions)
    length = std::max(length, norm(Vector(O - state.position(pull.at))));
  if (norm(Vector(F.v + cross(F.w, O - F.p))) > nine_digits * pace * length)
    throw UnansweredError(
        situation.file, mark,
        "the center that pulls does not rest in the frame of the steady motion: near it the equations "
        "have coefficients that change with time",
        "let the frame turn about an axis through the center");
}

}  // namespace

solve::SteadyMotion SolvedInstant::steady_motion(const Mark& mark, Mechanism<double>& mechanism) const {
  const Model<double>& tree = machine_.mechanism.tree;
  const auto n = static_cast<std::size_t>(tree.velocity_size());
  const Workspace<double>& w = mechanism_state_->workspace();
  const int frame = situation_.steady ? machine_.index.at(situation_.steady->frame) : ground;
  // A frame that is carried along without turning has the rounding of what was solved for.
  constexpr double no_turning = 1e-12;  // of the pace
  Vector turning = angular_velocity(w, frame);
  if (norm(turning) <= no_turning * pace()) turning = Vector::zero();
  if (situation_.sought_effort())
    throw UnansweredError(situation_.file, mark,
                          "what drives the bodies is to be found here, and would have to be known nearby",
                          "state it: couple: or force: at the freedom, in place of any");
  refuse_center_off_axis(situation_, mark, *mechanism_state_, frame, pace());
  const AcceleratedFrame rides = accelerated_frame(view(), mark, pace());
  const Vector gravity = tree.gravity() - rides.acceleration;
  solve::SteadyMotion motion;
  motion.turning = turning;
  motion.q = machine_.q;
  motion.v = v_;
  motion.length = scales_.length;
  // The weight sets the least pace that is looked at; without it that is some 1e-5 of the motion's own, below which a
  // rate is lost in the rounding of the accelerations: their terms are of the size of its square.
  constexpr double slowest = 3e-5;
  motion.time = 1 / std::max(std::sqrt(norm(gravity) / scales_.length), slowest * pace());
  motion.held.assign(n, false);
  for (const StatedRate& rate : machine_.accelerations) motion.held[static_cast<std::size_t>(rate.velocity)] = true;
  // A frame that moves with a body in free space states nothing about the motion of the mass center.
  for (const Frame& f : situation_.frames) {
    if (!situation_.steady || f.name != situation_.steady->frame || f.rides_on.empty()) continue;
    const int ridden = machine_.index.at(f.rides_on);
    const auto touches = [&](const Action& action) {
      return (action.on == ridden || action.from == ridden) && action.kind != ActionKind::load &&
             action.name != hold_of_plane;
    };
    const auto& body = tree.body(ridden);
    if (body.joint != JointType::free ||
        std::any_of(machine_.mechanism.actions.begin(), machine_.mechanism.actions.end(), touches))
      continue;
    for (int k = body.v + 3; k < body.v + 6; ++k) {
      motion.held[static_cast<std::size_t>(k)] = true;
      motion.v[static_cast<std::size_t>(k)] = 0;
    }
  }

  // Contacts move over round bodies, so that the mechanism is adapted to every pose. Near a steady motion they no
  // longer rest in its frame.
  mechanism = machine_.mechanism;
  if (!rides.coordinates.empty())
    mechanism.tree = Model<double>({tree.bodies().begin(), tree.bodies().end()}, tree.names(), tree.modes(), gravity);
  for (const int k : rides.coordinates) motion.v[static_cast<std::size_t>(k)] = 0;
  for (VelocityConstraint<double>& constraint : mechanism.constraints) {
    if (constraint.kind == VelocityConstraintKind::led_cord && !constraint.keeps_length && constraint.spans.size() > 1)
      throw UnansweredError(situation_.file, mark,
                            "the motion near a steady one is not told where a cord that winds or turns wheels slides "
                            "over others as well (" +
                                constraint.words + ")",
                            "let the cord slip on no wheel: leave out smooth:, and eyelets");
    if (!constraint.carried_by && constraint.shape_unknown)
      throw UnansweredError(unknown_surface(situation_, machine_, constraint));
    if (!constraint.carried_by) continue;
    const Vector normal = mechanism_state_->direction(constraint.surface_axis);
    if (constraint.shape_unknown || norm(cross(turning, normal)) > nine_digits * norm(turning))
      throw UnansweredError(situation_.file, mark,
                            "how a contact moves near the steady motion is not known: it lies on a curved surface (" +
                                constraint.words + ")",
                            "stability is told for contacts of round bodies on planes across the axis of the frame");
    constraint.carried_by.reset();
  }
  // The axes of a particle that moves freely stay as they are.
  for (const auto& body : tree.bodies())
    for (int k = body.v; body.joint == JointType::free && body.inertia.mass > 0 && k < body.v + 3; ++k)
      if (turns_nothing(machine_, k)) motion.held[static_cast<std::size_t>(k)] = true;
  std::vector<int> held;
  for (std::size_t k = 0; k < n; ++k)
    if (motion.held[k]) held.push_back(static_cast<int>(k));
  motion.unseen = unseen_motions(mechanism, motion.q, held);
  for (const solve::UnseenMotion& unseen : motion.unseen) held.push_back(unseen.coordinate);
  MechanismDynamics dynamics(mechanism, held);
  for (const OpenCoordinate& open : dynamics.open_coordinates(machine_.q))
    throw UnansweredError(
        situation_.file, mark,
        "the motion near the steady one is not determined: nothing fixes " +
            with_article(machine_.mechanism.coordinate_names[static_cast<std::size_t>(open.coordinate)]) +
            (open.without_inertia ? ", which moves no mass" : ""),
        "say what holds or drives it");
  motion.mechanism = &mechanism;
  motion.given.resize(n);
  for (std::size_t k = 0; k < n; ++k)
    if (dynamics.is_held(static_cast<int>(k))) motion.given[k] = 0;
  // Frames and what is driven do not deviate.
  for (std::size_t k = 0; k < n; ++k)
    motion.held[k] = motion.given[k] && std::ranges::none_of(motion.unseen, [&](const solve::UnseenMotion& unseen) {
                       return unseen.coordinate == static_cast<int>(k);
                     });
  for (const StatedRate& rate : machine_.accelerations)
    motion.given[static_cast<std::size_t>(rate.velocity)] = rate.value;
  for (const int k : rides.coordinates) motion.given[static_cast<std::size_t>(k)] = 0;

  // The spin of each body on a ball or free joint, on the body's axes, as a twist about its mass center.
  const auto about = [](const Vector& angular, const Vector& c) { return Twist{angular, cross(c, angular)}; };
  const auto center_of = [&](int i) {
    const SpatialInertia<double>& I = tree.body(i).inertia;
    return I.mass > 0 ? I.first_moment / I.mass : Vector::zero();
  };
  for (int i = 0; i < tree.body_count(); ++i) {
    const auto& body = tree.body(i);
    if ((body.joint != JointType::ball && body.joint != JointType::free) || i == frame) continue;
    const Vector own = direction_on_body(tree, w, i, angular_velocity(w, i) - turning);
    // Axes that do not follow the spin suit bodies whose inertia does not change while they spin. Other bodies keep
    // their own axes.
    const std::vector<Vector> alike = symmetry_axes(body.inertia);
    const bool unseen = alike.size() != 1 ? alike.size() == 3 || !(body.inertia.mass > 0)
                                          : norm(cross(own, alike.front())) <= nine_digits * norm(own);
    if (norm(own) > 0 && unseen) motion.spins.emplace_back(i, about(own, center_of(i)));
  }

  // Displacements that may lead to the same motion again: turns of everything on the ground about the axis of the
  // frame or the vertical, shifts, and turns of a body about its axis of symmetry. Those that do not are sorted out
  // later.
  const auto add_symmetry = [&](const std::vector<double>& positions, const std::vector<double>& velocities) {
    std::vector<double> both = positions;
    both.insert(both.end(), velocities.begin(), velocities.end());
    for (std::size_t k = 0; k < n; ++k)
      if (motion.held[k]) both[k] = both[n + k] = 0;
    motion.symmetries.push_back(std::move(both));
  };
  const std::vector<double> none(n, 0.0);
  std::vector<std::pair<Vector, Vector>> displacements;  // turning about the origin and shift, on ground axes
  std::vector<Vector> axes{Vector::unit(0), Vector::unit(1), Vector::unit(2)};
  // The axis of the frame and the vertical are added, in case the axes are drawn differently, and directions
  // perpendicular to them.
  constexpr double drawn = 1e-12;  // sine between axes that are the same but for the rounding of how they were drawn
  const auto add_axis = [&](const Vector& axis) {
    const bool known =
        std::any_of(axes.begin(), axes.end(), [&](const Vector& other) { return norm(cross(axis, other)) <= drawn; });
    if (!known) axes.push_back(axis);
  };
  for (const Vector& along : {turning, gravity}) {
    if (!(norm(along) > 0)) continue;
    const Vector axis = normalized(along);
    Vector across = cross(axis, axes[0]);
    for (std::size_t k = 1; k < 3; ++k)
      if (norm(cross(axis, axes[k])) > norm(across)) across = cross(axis, axes[k]);
    across = normalized(across);
    add_axis(axis);
    add_axis(across);
    add_axis(cross(axis, across));
  }
  std::vector<Vector> places{Vector::zero()};
  for (int i = 0; i < tree.body_count(); ++i)
    if (tree.body(i).parent == ground) places.push_back(w.motion[static_cast<std::size_t>(i + 1)].p);
  if (!mechanism.attractions.empty())
    places.push_back(mechanism_state_->position(mechanism.attractions.front().toward));
  for (const Vector& axis : axes) {
    displacements.emplace_back(Vector::zero(), axis);
    for (const Vector& P : places) displacements.emplace_back(axis, cross(P, axis));
  }
  for (const auto& [turn, shift] : displacements)
    for (int only = -1; only < tree.body_count(); ++only) {
      if (only >= 0 && tree.body(only).parent != ground) continue;
      std::vector<double> positions = none, velocities = none;
      bool possible = true, any = false;
      for (int i = 0; i < tree.body_count() && possible; ++i) {
        const auto& body = tree.body(i);
        if (body.parent != ground || (only >= 0 && i != only) || velocity_size(body.joint) == 0) continue;
        if (motion.held[static_cast<std::size_t>(body.v)] &&
            motion.held[static_cast<std::size_t>(body.v + velocity_size(body.joint) - 1)])
          continue;
        const BodyMotion<double>& B = w.motion[static_cast<std::size_t>(i + 1)];
        const Vector at_origin = shift + cross(turn, B.p);
        // The motions of the coordinates at the body's origin are fitted to the displacement.
        double left = norm_squared(at_origin) + scales_.length * scales_.length * norm_squared(turn);
        const double size = left;
        for_each_coordinate_motion(tree, w, i, B.p, [&, &turn = turn](int k, const Twist& S) {
          const double own = norm_squared(S.angular) * scales_.length * scales_.length + norm_squared(S.linear);
          const double part = (dot(S.angular, turn) * scales_.length * scales_.length + dot(S.linear, at_origin)) / own;
          positions[static_cast<std::size_t>(k)] = part;
          left -= part * part * own;
        });
        // The axes of a particle are not turned, since its velocity is given on them.
        const bool keeps_axes = body.joint == JointType::free && turns_nothing(machine_, body.v) &&
                                turns_nothing(machine_, body.v + 1) && turns_nothing(machine_, body.v + 2);
        if (keeps_axes) {
          left = 0;
          const Vector change = direction_on_body(tree, w, i, cross(turn, B.v));
          for (std::size_t k = 0; k < 3; ++k) velocities[static_cast<std::size_t>(body.v) + 3 + k] = change[k];
        }
        possible = std::abs(left) <= nine_digits * std::max(size, 1e-300);
        any = true;
      }
      if (possible && any) add_symmetry(positions, velocities);
    }
  for (int i = 0; i < tree.body_count(); ++i) {
    const auto& body = tree.body(i);
    const auto first = static_cast<std::size_t>(body.v);
    if (body.joint == JointType::revolute && turns_unseen(tree, i, scales_.length)) {
      std::vector<double> positions = none;
      positions[first] = 1;
      add_symmetry(positions, none);
    }
    if (body.joint != JointType::ball && body.joint != JointType::free) continue;
    std::vector<Vector> own_axes = symmetry_axes(body.inertia);
    if (own_axes.size() == 3) {
      // If all axes are axes of symmetry, those of its spin and those through the points that hold it are used.
      const auto add = [&](const Vector& direction) {
        if (norm(direction) > nine_digits * scales_.length) own_axes.push_back(normalized(direction));
      };
      const Vector c = center_of(i);
      add(c);
      add(scales_.length * direction_on_body(tree, w, i, angular_velocity(w, i) - turning));
      for (const Component<double>& component : mechanism.components)
        if (component.at.body == i) add(component.at.point - c);
    }
    for (const Vector& axis : own_axes) {
      const Twist own = about(axis, center_of(i));
      Twist v = Twist::zero();
      for (std::size_t k = 0; k < 3; ++k) {
        v.angular[k] = v_[first + k];
        if (body.joint == JointType::free) v.linear[k] = v_[first + 3 + k];
      }
      const Twist change{cross(v.angular, own.angular), cross(v.angular, own.linear) + cross(v.linear, own.angular)};
      std::vector<double> positions = none, velocities = none;
      for (std::size_t k = 0; k < 3; ++k) {
        positions[first + k] = own.angular[k];
        velocities[first + k] = change.angular[k];
        if (body.joint == JointType::free) {
          positions[first + 3 + k] = own.linear[k];
          velocities[first + 3 + k] = change.linear[k];
        }
      }
      add_symmetry(positions, velocities);
    }
  }

  return motion;
}

const solve::Linearisation& SolvedInstant::linearisation(const Mark& mark, bool with_shapes) {
  if (linearisation_ && (linearisation_->has_shapes || !with_shapes)) return *linearisation_;
  Mechanism<double> mechanism;
  const solve::SteadyMotion motion = steady_motion(mark, mechanism);
  if (linearisation_) {
    solve::find_shapes(motion, *linearisation_);
    return *linearisation_;
  }
  refuse_unsteady_loads(situation_, mark, motion, pace());
  try {
    linearisation_ = solve::linearise(motion);
  } catch (const solve::ChangingEquations& error) {
    throw UnsteadyError(
        situation_.file, mark, error.what(),
        "stability is told where all that spins are bodies of revolution, and all that acts from the ground on what "
        "turns acts along the axis, or about it",
        std::string("what acts may change, and with it what moves freely: ") + error.what());
  } catch (const std::runtime_error& error) {
    throw UnansweredError(situation_.file, mark, error.what(),
                          "say what holds or drives every freedom, or give a body without mass a little");
  }
  if (!linearisation_->steady) {
    const auto changing = static_cast<std::size_t>(linearisation_->unsteady);
    linearisation_.reset();
    const std::string change = with_article(machine_.mechanism.coordinate_names[changing]) + " would change";
    throw UnsteadyError(situation_.file, mark, "this is no steady motion, of which alone stability is asked: " + change,
                        situation_.steady
                            ? "correct the frame, the spins or what acts, so that all stays as steady: says"
                            : "state steady: {frame: F, spins: {...}}, or rest where everything is in equilibrium",
                        change + ": it is no steady motion");
  }
  if (with_shapes) solve::find_shapes(motion, *linearisation_);
  return *linearisation_;
}

}  // namespace poinsot::problem
