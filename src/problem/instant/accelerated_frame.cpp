#include "problem/instant/accelerated_frame.h"

#include <algorithm>
#include <optional>
#include <string>

#include "problem/language/diagnostic.h"

namespace poinsot::problem {
namespace {

class RidingParts {
 public:
  RidingParts(const InstantView<double>& view, const Mark& mark)
      : view_(view),
        mark_(mark),
        tree_(view.machine.mechanism.tree),
        frame_(view.machine.index.at(view.situation.steady->frame)) {}

  // The velocity coordinates of the frame and of what carries it; nothing if one of them follows from forces.
  std::optional<std::vector<int>> coordinates() const {
    std::vector<int> found;
    for (int i = frame_; i != ground; i = tree_.body(i).parent)
      for (int k = tree_.body(i).v; k < tree_.body(i).v + velocity_size(tree_.body(i).joint); ++k) {
        if (std::ranges::find(view_.machine.accelerations, k, &StatedRate::velocity) ==
            view_.machine.accelerations.end())
          return std::nullopt;
        found.push_back(k);
      }
    return found;
  }

  void refuse_unsteady() const {
    const auto follows_time = [&](const std::optional<Expression>& one) {
      return one && depends_on_time(view_.situation, *one);
    };
    bool unsteady = false;
    for (const Frame& frame : view_.situation.frames)
      unsteady = unsteady || (frame.name == view_.situation.steady->frame &&
                              (follows_time(frame.velocity) || follows_time(frame.acceleration)));
    for (const Joint& joint : view_.situation.joints)
      for (const Freedom& freedom : joint.freedoms)
        unsteady = unsteady ||
                   ((follows_time(freedom.position) || follows_time(freedom.rate) || follows_time(freedom.accel)) &&
                    carries(view_.machine.index.at(joint.to)));
    if (unsteady)
      refuse("the acceleration of the frame changes with time, so that nothing is steady in it",
             "state a constant acceleration");
  }

  void refuse_joined() const {
    for (const Action& action : view_.machine.mechanism.actions) {
      if (action.kind == ActionKind::load || action.name == hold_of_plane) continue;
      if (rides(action.on) == rides(action.from) || (!hangs(action.on) && !hangs(action.from))) continue;
      refuse("'" + action.name +
                 "' joins what rides in the accelerated frame to what does not: near there the equations "
                 "change with time",
             "let all that moves near the steady motion ride in the frame");
    }
    for (const Cord& cord : view_.situation.cords)
      if (cord.is_led())
        refuse("cord '" + cord.name + "' is led over what may not ride in the accelerated frame",
               "stability in an accelerated frame is told without cords over wheels");
    for (const Belt& belt : view_.situation.belts)
      refuse(belt.words() + " goes round what may not ride in the accelerated frame",
             "stability in an accelerated frame is told without belts");
    for (const KnownForce<double>& force : view_.machine.mechanism.forces)
      if (force.by_motion)
        refuse("the load '" + view_.machine.mechanism.actions[static_cast<std::size_t>(force.action)].name +
                   "' depends on the motion, and the frame of the steady motion accelerates",
               "stability in an accelerated frame is told for constant loads");
    for (const Body& body : view_.situation.bodies)
      if (const int i = view_.machine.index.at(body.name); !rides(i) && !rests(i))
        refuse("body '" + body.name + "' does not ride in the accelerated frame", "join it to the frame");
  }

 private:
  [[noreturn]] void refuse(const std::string& what, const std::string& hint) const {
    throw UnansweredError(view_.situation.file, mark_, what, hint);
  }
  bool is_on(int body, int link) const {
    for (int i = body; i != ground; i = tree_.body(i).parent)
      if (i == link) return true;
    return false;
  }
  // Whether a body hangs on the frame, carries it, or one of both.
  bool hangs(int body) const { return body != ground && is_on(body, frame_) && body != frame_; }
  bool carries(int body) const { return body != ground && is_on(frame_, body); }
  bool rides(int body) const { return hangs(body) || carries(body); }
  bool rests(int body) const {
    for (int i = body; i != ground; i = tree_.body(i).parent)
      if (tree_.body(i).joint != JointType::weld) return false;
    return true;
  }

  const InstantView<double>& view_;
  const Mark& mark_;
  const Model<double>& tree_;
  int frame_;
};

}  // namespace

AcceleratedFrame accelerated_frame(const InstantView<double>& view, const Mark& mark, double pace) {
  using Vector = Vector3<double>;
  if (!view.situation.steady) return {};
  const int frame = view.machine.index.at(view.situation.steady->frame);
  if (frame == ground) return {};
  const RidingParts parts(view, mark);
  const auto coordinates = parts.coordinates();
  if (!coordinates) return {};
  const Model<double>& tree = view.machine.mechanism.tree;
  const Workspace<double>& w = view.mechanism_state.workspace();
  Vector acceleration = Vector::zero(), turning = angular_velocity(w, frame), quickening = Vector::zero();
  const Vector origin = w.motion[static_cast<std::size_t>(frame + 1)].p;
  for_each_coordinate_motion(tree, w, frame, origin, [&](int k, const SpatialMotion<double>& S) {
    const auto stated = std::ranges::find(view.machine.accelerations, k, &StatedRate::velocity);
    acceleration += stated->value * S.linear;
    quickening += stated->value * S.angular;
  });
  // What is that much slower than the motion itself is the rounding of what was solved for.
  constexpr double none = 1e-12;
  if (norm(turning) > none * pace || norm(quickening) > none * pace * pace || norm(acceleration) == 0) return {};
  parts.refuse_unsteady();
  parts.refuse_joined();
  return {acceleration, *coordinates};
}

}  // namespace poinsot::problem
