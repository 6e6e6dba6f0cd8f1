// The conditions on velocities and accelerations in a steady motion.
#include <algorithm>
#include <cmath>

#include "poinsot/engine/math/algebra/plain.h"
#include "problem/instant/instant_conditions.h"
#include "problem/language/diagnostic.h"
#include "problem/language/exact_numbers.h"

namespace poinsot::problem {
namespace {

template <class Scalar>
bool hangs_on(const Model<Scalar>& tree, int body, int ancestor) {
  for (int i = body; i != ground; i = tree.body(i).parent)
    if (i == ancestor) return true;
  return ancestor == ground;
}

// The axis of a spin, which may be that of a joint in its pose.
template <class Scalar>
Vector3<Scalar> axis_of(const InstantView<Scalar>& view, const Spin& spin) {
  const Call* call = spin.about.as<Call>();
  if (!call || call->function != "axis" || call->arguments.size() != 1) return view.data.direction(spin.about);
  const auto joint = view.machine.joints.find(to_string(call->arguments.front().value));
  if (joint == view.machine.joints.end() || !joint->second.axis)
    fail(view.situation.file, spin.about.mark(),
         "there is no joint '" + to_string(call->arguments.front().value) + "' that has an axis",
         "name a joint that turns about one axis, or write the axis itself: A->B");
  return view.mechanism_state.direction(*joint->second.axis);
}

}  // namespace

template <class Scalar>
bool turns_unseen(const Model<Scalar>& tree, int body, double length) {
  const auto& link = tree.body(body);
  if (link.joint != JointType::revolute || !(plain(link.inertia.mass) > 0)) return false;
  // The working axes have their z along the axis of the joint.
  const SpatialInertia<Scalar>& I = link.inertia;
  const Vector3<Scalar> center = I.first_moment / I.mass;
  const SymmetricMatrix3<double> central = plain(I.inertia - I.mass * unit_mass_inertia(center));
  const Vector3<double> c = plain(center);
  const double size = central.xx + central.yy + central.zz, off = std::abs(c.x) + std::abs(c.y);
  // Of lengths and of the moments: data may be stated to nine digits. A rotor that is out of balance by more is felt.
  constexpr double balanced = 1e-9;
  return off <= balanced * (length + std::abs(c.z)) && std::abs(central.xx - central.yy) <= balanced * size &&
         std::abs(central.xy) + std::abs(central.yz) + std::abs(central.zx) <= balanced * size;
}

template <class Scalar>
void add_steady(const InstantView<Scalar>& view, bool accelerations, StatedConditions<Scalar>& conditions) {
  using Vector = Vector3<Scalar>;
  const Situation& situation = view.situation;
  const MachineOf<Scalar>& machine = view.machine;
  const Steady& steady = *situation.steady;
  const Model<Scalar>& tree = machine.mechanism.tree;
  const int frame = machine.index.at(steady.frame);
  const std::size_t size =
      accelerations ? solve::force_unknowns(machine.mechanism).size() : static_cast<std::size_t>(tree.velocity_size());
  const std::string words = "steady motion in '" + steady.frame + "'";
  const auto stated = [&](const std::vector<StatedRateOf<Scalar>>& list, int k) {
    return std::any_of(list.begin(), list.end(), [&](const StatedRateOf<Scalar>& rate) { return rate.velocity == k; });
  };
  const auto rides = std::find_if(situation.frames.begin(), situation.frames.end(),
                                  [&](const Frame& f) { return f.name == steady.frame; });
  const Workspace<Scalar>& w = view.mechanism_state.workspace();
  const BodyMotion<Scalar>& F = w.motion[static_cast<std::size_t>(frame + 1)];
  for (int i = 0; i < tree.body_count(); ++i) {
    const auto& body = tree.body(i);
    const std::string& name = tree.name(i);
    const bool is_frame =
        std::any_of(situation.frames.begin(), situation.frames.end(), [&](const Frame& f) { return f.name == name; });
    if (is_frame || i == frame) continue;
    const auto spin =
        std::find_if(steady.spins.begin(), steady.spins.end(), [&](const Spin& s) { return s.body == name; });
    if (hangs_on(tree, i, frame) && frame != ground && spin == steady.spins.end()) {
      for (int k = body.v; k < body.v + velocity_size(body.joint); ++k) {
        if (stated(accelerations ? machine.accelerations : machine.rates, k)) continue;
        if (!accelerations && stated(machine.accelerations, k)) continue;
        // A body of revolution may turn about its own axis, which changes nothing.
        if (!accelerations && turns_unseen(tree, i, view.scales.length)) continue;
        solve::ConditionOf<Scalar> condition{words, std::vector<Scalar>(size), Scalar(0), 1};
        condition.coefficients[static_cast<std::size_t>(k)] = Scalar(1);
        conditions.add(std::move(condition), {});
      }
      continue;
    }
    if (!machine.mechanism.takes_part[static_cast<std::size_t>(i)]) continue;
    // What is fixed to the ground stays there, even if the frame turns.
    bool fixed = true;
    for (int j = i; j != ground; j = tree.body(j).parent) fixed = fixed && tree.body(j).joint == JointType::weld;
    if (fixed) continue;
    if (hangs_on(tree, frame, i)) continue;  // it carries the frame
    // The body has w = W + s u and alpha = dW/dt + W x s u, and its mass center moves with the frame.
    Vector spin_vector = Vector::zero();
    if (spin != steady.spins.end())
      spin_vector = view.data.number(spin->rate, dimensions::angular_velocity) * axis_of(view, *spin);
    const bool rides_here = rides != situation.frames.end() && rides->rides_on == name;
    const Vector G =
        plain(body.inertia.mass) > 0 ? body_mass_center(tree, w, i) : w.motion[static_cast<std::size_t>(i + 1)].p;
    const Vector r = G - F.p;
    const std::size_t first = conditions.linear.size(), count = rides_here ? 3 : 6;
    for (std::size_t k = 0; k < count; ++k)
      conditions.add({words, std::vector<Scalar>(size), Scalar(0), k < 3 ? 1 : view.scales.length}, {});
    const auto add = [&](int moved, double sign) {
      for_each_coordinate_motion(tree, w, moved, G, [&](int coordinate, const SpatialMotion<Scalar>& S) {
        for (std::size_t k = 0; k < count; ++k)
          conditions.linear[first + k].coefficients[static_cast<std::size_t>(coordinate)] +=
              Scalar(sign) * (k < 3 ? S.angular[k] : S.linear[k - 3]);
      });
    };
    add(i, 1);
    add(frame, -1);
    for (std::size_t k = 0; k < count; ++k) {
      const bool angular = k < 3;
      const std::size_t c = k % 3;
      solve::ConditionOf<Scalar>& condition = conditions.linear[first + k];
      if (!accelerations) {
        condition.value = angular ? spin_vector[c] : Scalar(0);
      } else {
        // The part of the acceleration that depends on the velocities alone, with the coordinates' accelerations at
        // zero.
        const BodyMotion<Scalar>& B = w.motion[static_cast<std::size_t>(i + 1)];
        const Vector own = B.a + cross(B.alpha, G - B.p) + cross(B.w, cross(B.w, G - B.p));
        const Vector carried = F.a + cross(F.alpha, r) + cross(F.w, cross(F.w, r));
        condition.value = angular ? (F.alpha + cross(F.w, spin_vector) - B.alpha)[c] : (carried - own)[c];
      }
    }
  }
}

template bool turns_unseen(const Model<double>&, int, double);
template void add_steady(const InstantView<double>&, bool, StatedConditions<double>&);
template void add_steady(const InstantView<Dual<1>>&, bool, StatedConditions<Dual<1>>&);
template void add_steady(const InstantView<Formula>&, bool, StatedConditions<Formula>&);

}  // namespace poinsot::problem
