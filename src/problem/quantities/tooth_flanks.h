// Which flanks of the teeth of gears carry, and where these rub.
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "poinsot/engine/math/algebra/plain.h"
#include "poinsot/engine/math/formula/formula_decision.h"
#include "poinsot/engine/solve/instant/equations.h"
#include "poinsot/engine/solve/linear/linear_system.h"
#include "problem/machine/machine.h"

namespace poinsot::problem {

// Of each component of a mechanism.
inline std::vector<int> flanks_of(const Mechanism<double>& mechanism) {
  std::vector<int> flanks;
  for (const Component<double>& component : mechanism.components) flanks.push_back(component.flank);
  return flanks;
}

template <class Scalar>
void put_flanks(Mechanism<Scalar>& mechanism, const std::vector<int>& flanks) {
  if (flanks.size() != mechanism.components.size()) return;
  for (std::size_t k = 0; k < flanks.size(); ++k) mechanism.components[k].flank = flanks[k];
}

// Whether any teeth lean or rub; and, if so, leaves open which flanks carry.
inline bool untie_flanks(Mechanism<double>& mechanism) {
  bool any = false;
  for (Component<double>& component : mechanism.components) {
    if (!component.parts_wheels) continue;
    component.flank = 0;
    any = true;
  }
  return any;
}

// Ties what teeth exert beside the force that turns the wheels to that force, where this is determined. Returns whether
// more is tied than before. first: the place of the first component among the unknowns.
inline bool tie_flanks(Mechanism<double>& mechanism, const solve::LinearSolution& solution, std::size_t first) {
  bool tied = false;
  for (Component<double>& component : mechanism.components) {
    if (!component.parts_wheels || component.flank != 0) continue;
    const std::size_t turning = first + static_cast<std::size_t>(component.follows);
    if (!solution.determined(turning)) continue;
    component.flank = solution.value[turning] < 0 ? -1 : 1;
    tied = true;
  }
  return tied;
}

// Lets the friction of teeth act against the slip of `of` over `against` along their thread. Returns a mesh that does
// not slip, if there is one.
template <class Scalar>
const ToothMeshOf<Scalar>* turn_against_slip(MachineOf<Scalar>& machine, const solve::MechanismStateOf<Scalar>& state) {
  const auto velocity_at = [&](int body, const Vector3<Scalar>& P) -> Vector3<Scalar> {
    const BodyMotion<Scalar>& motion = state.workspace().motion[static_cast<std::size_t>(body + 1)];
    return motion.v + cross(motion.w, P - motion.p);
  };
  const ToothMeshOf<Scalar>* resting = nullptr;
  for (Component<Scalar>& component : machine.mechanism.components) {
    if (!component.rubs) continue;
    for (const ToothMeshOf<Scalar>& mesh : machine.tooth_meshes) {
      if (mesh.action != component.action) continue;
      const Action& action = machine.mechanism.actions[static_cast<std::size_t>(mesh.action)];
      const Vector3<Scalar> P = state.position(component.at), on = velocity_at(action.on, P),
                            from = velocity_at(action.from, P);
      const Scalar slip = dot(Vector3<Scalar>(on - from), state.direction({mesh.carrier, mesh.thread}));
      // A slip that is rounding of the velocities is none.
      constexpr double rounding = 1e-12;
      if (std::abs(plain(slip)) <= rounding * (norm(plain(on)) + norm(plain(from)))) {
        resting = &mesh;
        continue;
      }
      component.along.vector = decided_negative(slip) ? mesh.thread : Vector3<Scalar>(-mesh.thread);
    }
  }
  return resting;
}

}  // namespace poinsot::problem
