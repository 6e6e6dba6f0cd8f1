// The impulses, impacts and strikes that a statement names, on the machine in its pose with the motion before them.
#include "statement/exact_numbers.h"
#include "statement/instant_conditions.h"

namespace poinsot::statement {

template <class Scalar>
solve::BlowOf<Scalar> stated_blow(const InstantView<Scalar>& view) {
  using Vector = Vector3<Scalar>;
  const solve::MomentOf<Scalar>& moment = view.moment;
  const Model<Scalar>& tree = view.machine.mechanism.tree;
  solve::BlowOf<Scalar> blow;
  for (const StatedImpulseOf<Scalar>& stated : view.machine.impulses) {
    solve::KnownImpulseOf<Scalar> impulse{stated.action, stated.on, SpatialForce<Scalar>::zero(), stated.absorbed,
                                          stated.at};
    Vector vector = moment.on_ground_axes(stated.axes, stated.vector);
    if (stated.relative_to) {
      // The particle's momentum, less what it keeps of it relative to the body.
      const auto center_velocity = [&](int body) {
        if (body == ground) return Vector::zero();
        const Scalar& mass = tree.body(body).inertia.mass;
        if (!(plain(mass) > 0)) return Vector::zero();
        return Vector(body_momentum(tree, moment.workspace(), body, Vector::zero()).linear / mass);
      };
      const Vector absolute = vector + stated.particle_mass * center_velocity(*stated.relative_to);
      const Vector relative = absolute - stated.particle_mass * center_velocity(stated.on);
      vector = plain(stated.absorbed) > 0 ? absolute : (Scalar(1) - stated.kept) * relative;
    }
    impulse.wrench = stated.couple ? SpatialForce<Scalar>{vector, Vector::zero()}
                                   : SpatialForce<Scalar>{cross(moment.position(stated.at), vector), vector};
    blow.impulses.push_back(impulse);
  }
  blow.impacts = view.machine.impacts;
  for (const Frame& frame : view.problem.frames) {
    const auto& body = tree.body(view.machine.index.at(frame.name));
    for (int k = 0; k < velocity_size(body.joint); ++k) blow.held_coordinates.push_back(body.v + k);
  }
  return blow;
}

template solve::Blow stated_blow(const InstantView<double>&);
template solve::BlowOf<Formula> stated_blow(const InstantView<Formula>&);

}  // namespace poinsot::statement
