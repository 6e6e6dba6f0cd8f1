// What `steady:` says of velocities and accelerations.
#include <algorithm>
#include <cmath>

#include "statement/instant.h"

namespace poinsot::statement {
namespace {

using Vector = Vector3<double>;

}  // namespace

bool SolvedInstant::hangs_on(int body, int ancestor) const {
  for (int i = body; i != ground; i = machine_.mechanism.tree.body(i).parent)
    if (i == ancestor) return true;
  return ancestor == ground;
}

// Rest relative to a frame with constant spins: the coordinates of bodies that hang on it do not change, but those of
// bodies of revolution about their own axes; other bodies have the frame's angular velocity and their spin, and their
// mass centers go with it.
void SolvedInstant::add_steady(std::vector<solve::Condition>& conditions, bool accelerations) const {
  const Steady& steady = *problem_.steady;
  const Model<double>& tree = machine_.mechanism.tree;
  const int frame = machine_.index.at(steady.frame);
  const std::size_t size =
      accelerations ? solve::force_unknowns(machine_.mechanism).size() : static_cast<std::size_t>(tree.velocity_size());
  const std::string words = "steady motion in '" + steady.frame + "'";
  const auto stated = [&](const std::vector<StatedRate>& list, int k) {
    return std::any_of(list.begin(), list.end(), [&](const StatedRate& rate) { return rate.velocity == k; });
  };
  const auto rides = std::find_if(problem_.frames.begin(), problem_.frames.end(),
                                  [&](const Frame& f) { return f.name == steady.frame; });
  const Workspace<double>& w = moment_->workspace();
  const BodyMotion<double>& F = w.motion[static_cast<std::size_t>(frame + 1)];
  for (int i = 0; i < tree.body_count(); ++i) {
    const auto& body = tree.body(i);
    const std::string& name = tree.name(i);
    const bool is_frame = std::any_of(problem_.frames.begin(), problem_.frames.end(),
                                      [&](const Frame& f) { return machine_.index.at(f.name) == i; });
    if (is_frame || i == frame) continue;
    const auto spin =
        std::find_if(steady.spins.begin(), steady.spins.end(), [&](const Spin& s) { return s.body == name; });
    if (hangs_on(i, frame) && frame != ground && spin == steady.spins.end()) {
      for (int k = body.v; k < body.v + velocity_size(body.joint); ++k) {
        if (stated(accelerations ? machine_.accelerations : machine_.rates, k)) continue;
        if (!accelerations && stated(machine_.accelerations, k)) continue;
        // A body of revolution may turn about its own axis unseen.
        if (!accelerations && turns_unseen(i)) continue;
        solve::Condition condition{words, std::vector<double>(size), 0, 1};
        condition.coefficients[static_cast<std::size_t>(k)] = 1;
        conditions.push_back(std::move(condition));
      }
      continue;
    }
    if (!machine_.mechanism.takes_part[static_cast<std::size_t>(i)]) continue;
    // What is fixed to the ground stays there, whatever turns about it.
    bool fixed = true;
    for (int j = i; j != ground; j = tree.body(j).parent) fixed = fixed && tree.body(j).joint == JointType::weld;
    if (fixed) continue;
    if (hangs_on(frame, i)) continue;  // it carries the frame
    // w = W + s u, alpha = dW/dt + W x s u; the mass center goes with the frame.
    Vector spin_vector = Vector::zero();
    if (spin != steady.spins.end())
      spin_vector = data_->number(spin->rate, dimensions::angular_velocity) * data_->direction(spin->about);
    const bool rides_here = rides != problem_.frames.end() && rides->rides_on == name;
    const double mass = body.inertia.mass;
    const Vector G = mass > 0 ? body_mass_center(tree, w, i) : w.motion[static_cast<std::size_t>(i + 1)].p;
    const Vector r = G - F.p;
    for (std::size_t k = 0; k < 6; ++k) {
      const bool angular = k < 3;
      if (!angular && rides_here) break;
      const std::size_t c = k % 3;
      solve::Condition condition{words, std::vector<double>(size), 0, angular ? 1 : scales_.length};
      const auto add = [&](int moved, double sign, const Vector& p) {
        for_each_coordinate_motion(tree, w, moved, p, [&](int coordinate, const SpatialMotion<double>& S) {
          condition.coefficients[static_cast<std::size_t>(coordinate)] += sign * (angular ? S.angular[c] : S.linear[c]);
        });
      };
      add(i, 1, G);
      add(frame, -1, G);
      if (!accelerations) {
        condition.value = angular ? spin_vector[c] : 0;
      } else {
        // What the velocities bring, with all accelerations of coordinates zero.
        const BodyMotion<double>& B = w.motion[static_cast<std::size_t>(i + 1)];
        const Vector own = B.a + cross(B.alpha, G - B.p) + cross(B.w, cross(B.w, G - B.p));
        const Vector carried = F.a + cross(F.alpha, r) + cross(F.w, cross(F.w, r));
        condition.value = angular ? (F.alpha + cross(F.w, spin_vector) - B.alpha)[c] : (carried - own)[c];
      }
      conditions.push_back(std::move(condition));
    }
  }
}

// Whether a body is one of revolution about the axis of its own joint, its mass center on it.
bool SolvedInstant::turns_unseen(int body) const {
  const auto& link = machine_.mechanism.tree.body(body);
  if (link.joint != JointType::revolute || !(link.inertia.mass > 0)) return false;
  // On the working axes the joint's axis is z.
  const SpatialInertia<double>& I = link.inertia;
  const Vector c = I.first_moment / I.mass;
  const SymmetricMatrix3<double> central = I.inertia - I.mass * unit_mass_inertia(c);
  const double size = central.xx + central.yy + central.zz, off = std::abs(c.x) + std::abs(c.y);
  return off <= 1e-9 * (scales_.length + std::abs(c.z)) && std::abs(central.xx - central.yy) <= 1e-9 * size &&
         std::abs(central.xy) + std::abs(central.yz) + std::abs(central.zx) <= 1e-9 * size;
}

}  // namespace poinsot::statement
