#include "problem/machine/machine.h"

#include "poinsot/engine/math/algebra/plain.h"
#include "poinsot/engine/model/fixed_particles.h"
#include "problem/language/exact_numbers.h"
#include "problem/machine/machine_draft.h"

namespace poinsot::problem {

template <class Scalar>
Place<Scalar> MachineOf<Scalar>::place(int body, const Vector3<Scalar>& drawn) const {
  return {body, drawn - drawn_origin.at(body)};
}

template <class Scalar>
const NamedCoordinate* MachineOf<Scalar>::coordinate(const std::string& name) const {
  for (const NamedCoordinate& c : coordinates)
    if (c.name == name) return &c;
  return nullptr;
}

template <class Scalar>
std::vector<std::size_t> MachineOf<Scalar>::actions_of(const std::string& name, const std::string& joint) const {
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < mechanism.actions.size(); ++i) {
    const Action& action = mechanism.actions[i];
    const bool of_joint = (action.kind == ActionKind::support || action.kind == ActionKind::drive ||
                           action.kind == ActionKind::friction) &&
                          action.joint == name;
    const bool itself = action.kind != ActionKind::drive && action.kind != ActionKind::friction &&
                        action.name == name && (joint.empty() || action.joint == joint);
    if (of_joint || itself) found.push_back(i);
  }
  return found;
}

namespace {

// After a blow, particles that stay are parts of the bodies that they have struck.
template <class Scalar>
void add_struck_tree(MachineOf<Scalar>& machine) {
  std::vector<FixedParticle<Scalar>> particles;
  for (const StatedImpulseOf<Scalar>& impulse : machine.impulses)
    if (plain(impulse.absorbed) > 0 && impulse.on != ground)
      particles.push_back({impulse.on, impulse.absorbed, impulse.at.point});
  if (!particles.empty()) machine.struck_tree.emplace(with_particles(machine.mechanism.tree, particles));
}

}  // namespace

template <class Scalar>
std::vector<BodyMassOf<Scalar>> body_masses(const Situation& situation, DataScope<Scalar>& data, const AnyValue& any,
                                            const MachineOptions& options) {
  std::vector<BodyMassOf<Scalar>> masses;
  for (const Body& body : situation.bodies)
    masses.push_back(body_mass(body, data, any, options.lenient, options.particles));
  return masses;
}

template <class Scalar>
MachineOf<Scalar> build_machine(const Situation& situation, DataScope<Scalar>& data,
                                DataScope<TimeJetOf<Scalar>>& timed, const AnyValue& any,
                                const MachineOptions& options) {
  return build_machine(situation, body_masses(situation, data, any, options), data, timed, any, options);
}

template <class Scalar>
MachineOf<Scalar> build_machine(const Situation& situation, std::vector<BodyMassOf<Scalar>> masses,
                                DataScope<Scalar>& data, DataScope<TimeJetOf<Scalar>>& timed, const AnyValue& any,
                                const MachineOptions& options) {
  MachineDraft<Scalar> draft{situation, data, timed, any, options};
  draft.masses = std::move(masses);
  MachineOf<Scalar>& machine = draft.machine;
  machine.index["ground"] = ground;
  machine.drawn_origin[ground] = Vector3<Scalar>::zero();
  set_gravity(draft);
  for (const Frame& frame : situation.frames) add_frame(draft, frame);
  add_tree(draft);
  machine.mechanism.tree = draft.builder.build();
  machine.mechanism.takes_part.resize(static_cast<std::size_t>(machine.mechanism.tree.body_count()), false);
  for (const Body& body : situation.bodies)
    machine.mechanism.takes_part[static_cast<std::size_t>(machine.index.at(body.name))] = true;
  hold_in_plane(draft);
  for (const Joint& joint : situation.joints) add_joint_actions(draft, joint);
  for (const Contact& contact : situation.contacts) add_contact(draft, contact);
  for (const Cord& cord : situation.cords) add_cord(draft, cord);
  for (const Belt& belt : situation.belts) add_belt(draft, belt);
  for (const Gear& gear : situation.gears) add_gear(draft, gear);
  for_each_stated_law(situation, [&](const auto& law) { add_law(draft, law); });
  add_efforts_by_motion(draft);
  add_attractions(draft);
  for (const Impulse& impulse : situation.impulses) add_impulse(draft, impulse);
  for (const Impact& impact : situation.impacts) add_impact(draft, impact);
  for (const Strike& strike : situation.strikes) add_strike(draft, strike);
  if (data.follows_time()) require_steady_data(situation);
  add_struck_tree(machine);
  for (std::size_t i = 0; i < situation.bodies.size(); ++i)
    machine.masses.emplace_back(machine.index.at(situation.bodies[i].name), std::move(draft.masses[i]));
  return std::move(machine);
}

template struct MachineOf<double>;
template struct MachineOf<Dual<1>>;
template std::vector<BodyMassOf<double>> body_masses(const Situation&, DataScope<double>&, const AnyValue&,
                                                     const MachineOptions&);
template Machine build_machine(const Situation&, DataScope<double>&, DataScope<TimeJet>&, const AnyValue&,
                               const MachineOptions&);
template Machine build_machine(const Situation&, std::vector<BodyMassOf<double>>, DataScope<double>&,
                               DataScope<TimeJet>&, const AnyValue&, const MachineOptions&);
template MachineOf<Dual<1>> build_machine(const Situation&, DataScope<Dual<1>>&, DataScope<TimeJetOf<Dual<1>>>&,
                                          const AnyValue&, const MachineOptions&);
template struct MachineOf<Formula>;
template MachineOf<Formula> build_machine(const Situation&, DataScope<Formula>&, DataScope<TimeJetOf<Formula>>&,
                                          const AnyValue&, const MachineOptions&);

}  // namespace poinsot::problem
