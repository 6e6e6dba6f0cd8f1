// The stated impulses, impacts and strikes, for the machine in its pose and with its velocities before the blow.
#include "problem/instant/instant_conditions.h"
#include "problem/language/exact_numbers.h"

namespace poinsot::problem {

namespace {

template <class Scalar>
Vector3<Scalar> center_velocity(const solve::MechanismStateOf<Scalar>& state, int body) {
  if (body == ground) return Vector3<Scalar>::zero();
  const Model<Scalar>& tree = state.mechanism().tree;
  const Scalar& mass = tree.body(body).inertia.mass;
  if (!(plain(mass) > 0)) return Vector3<Scalar>::zero();
  return body_momentum(tree, state.workspace(), body, Vector3<Scalar>::zero()).linear / mass;
}

}  // namespace

template <class Scalar>
std::vector<FlyingParticle<Scalar>> flying_particles(const Situation& situation, const MachineOf<Scalar>& machine,
                                                     const solve::MechanismStateOf<Scalar>& before,
                                                     const solve::BlowOf<Scalar>* blow) {
  std::vector<FlyingParticle<Scalar>> particles;
  const std::size_t first = machine.impulses.size() - situation.strikes.size();
  for (std::size_t i = 0; i < situation.strikes.size(); ++i) {
    const StatedImpulseOf<Scalar>& strike = machine.impulses[first + i];
    const Scalar& mass = strike.particle_mass;
    if (!(plain(mass) > 0) || (blow && situation.strikes[i].stays)) continue;
    Vector3<Scalar> momentum =
        before.on_ground_axes(strike.axes, strike.vector) + mass * center_velocity(before, *strike.relative_to);
    if (blow) momentum = momentum - blow->impulses[first + i].wrench.force;
    particles.push_back({mass, before.position(strike.at), momentum / mass});
  }
  return particles;
}

template <class Scalar>
solve::BlowOf<Scalar> stated_blow(const InstantView<Scalar>& view) {
  using Vector = Vector3<Scalar>;
  const solve::MechanismStateOf<Scalar>& state = view.mechanism_state;
  const Model<Scalar>& tree = view.machine.mechanism.tree;
  solve::BlowOf<Scalar> blow;
  for (const StatedImpulseOf<Scalar>& stated : view.machine.impulses) {
    solve::KnownImpulseOf<Scalar> impulse{stated.action, stated.on, SpatialForce<Scalar>::zero(), stated.absorbed,
                                          stated.at};
    Vector vector = state.on_ground_axes(stated.axes, stated.vector);
    if (stated.relative_to) {
      // The momentum that the particle gives to the body: its own, less what it keeps relative to the body.
      const Vector absolute = vector + stated.particle_mass * center_velocity(state, *stated.relative_to);
      const Vector relative = absolute - stated.particle_mass * center_velocity(state, stated.on);
      vector = plain(stated.absorbed) > 0 ? absolute : (Scalar(1) - stated.kept) * relative;
    }
    impulse.wrench = stated.couple ? SpatialForce<Scalar>{vector, Vector::zero()}
                                   : SpatialForce<Scalar>{cross(state.position(stated.at), vector), vector};
    blow.impulses.push_back(impulse);
  }
  blow.impacts = view.machine.impacts;
  for (const Frame& frame : view.situation.frames) {
    const auto& body = tree.body(view.machine.index.at(frame.name));
    for (int k = 0; k < velocity_size(body.joint); ++k) blow.held_coordinates.push_back(body.v + k);
  }
  return blow;
}

template std::vector<FlyingParticle<double>> flying_particles(const Situation&, const Machine&,
                                                              const solve::MechanismState&, const solve::Blow*);
template std::vector<FlyingParticle<Dual<1>>> flying_particles(const Situation&, const MachineOf<Dual<1>>&,
                                                               const solve::MechanismStateOf<Dual<1>>&,
                                                               const solve::BlowOf<Dual<1>>*);
template std::vector<FlyingParticle<Formula>> flying_particles(const Situation&, const MachineOf<Formula>&,
                                                               const solve::MechanismStateOf<Formula>&,
                                                               const solve::BlowOf<Formula>*);
template solve::Blow stated_blow(const InstantView<double>&);
template solve::BlowOf<Dual<1>> stated_blow(const InstantView<Dual<1>>&);
template solve::BlowOf<Formula> stated_blow(const InstantView<Formula>&);

}  // namespace poinsot::problem
