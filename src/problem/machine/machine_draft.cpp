#include "problem/machine/machine_draft.h"

#include <cmath>
#include <exception>
#include <stdexcept>

#include "poinsot/engine/mass/composition.h"
#include "poinsot/engine/math/algebra/plain.h"
#include "problem/language/diagnostic.h"
#include "problem/language/exact_numbers.h"
#include "problem/language/words.h"

namespace poinsot::problem {

template <class Scalar>
std::size_t MachineDraft<Scalar>::body_number(const std::string& name) const {
  for (std::size_t i = 0; i < situation.bodies.size(); ++i)
    if (situation.bodies[i].name == name) return i;
  return 0;
}

template <class Scalar>
TimedNumber<Scalar> MachineDraft<Scalar>::timed_number(const Expression& expression, const Dimension& dimension) const {
  if (!depends_on_time(situation, expression)) return {data.number(expression, dimension), std::nullopt, std::nullopt};
  const TimeJetOf<Scalar> value = timed.number(expression, dimension);
  return {value.value.value, value.partial[0].value, value.partial[0].partial[0]};
}

template <class Scalar>
std::string MachineDraft<Scalar>::direction_name(const Vector3<Scalar>& direction) const {
  const Vector3<double> d = plain(direction);
  for (std::size_t k = 0; k < 3; ++k)
    if (constexpr double off = 1e-9;  // which is an angle of nine seconds: three digits of a direction do not show it
        std::abs(std::abs(d[k]) - 1) < off)
      return situation.axes[k];
  // A direction of the statement has a name.
  for (const NamedExpression& stated : situation.directions) {
    try {
      constexpr double off = 1e-9;
      if (std::abs(std::abs(dot(plain(data.direction(stated.value)), d)) - 1) < off) return stated.name;
    } catch (const std::exception&) {
      // One without a value, or without a formula where the machine is made of formulas, is not the one sought.
    }
  }
  return "[" + with_digits(d.x, 3) + ", " + with_digits(d.y, 3) + ", " + with_digits(d.z, 3) + "]";
}

template <class Scalar>
int MachineDraft<Scalar>::add_link(const std::string& name, int parent, const poinsot::Joint<Scalar>& joint,
                                   const Vector3<Scalar>& origin, const MassProperties<Scalar>& mass) {
  int link = 0;
  try {
    link = builder.add_body(name, parent, joint,
                            SpatialTransform<Scalar>::translation(origin - machine.drawn_origin.at(parent)),
                            translated(-origin, mass));
  } catch (const std::invalid_argument& error) {
    Mark mark{1, 1};
    for (const Body& body : situation.bodies)
      if (body.name == name) mark = body.mark;
    fail(situation.file, mark, error.what());
  }
  machine.drawn_origin[link] = origin;
  machine.links.push_back({joint.type, parent, plain(origin), plain(joint.axis), plain(joint.pitch),
                           static_cast<int>(machine.q.size()),
                           static_cast<int>(machine.mechanism.coordinate_names.size())});
  for (int k = 0; k < velocity_size(joint.type); ++k) machine.mechanism.coordinate_names.emplace_back();
  for (int k = 0; k < position_size(joint.type); ++k) {
    const bool unit_quaternion = k == 0 && position_size(joint.type) > 1;
    machine.q.push_back(Scalar(unit_quaternion ? 1 : 0));
    machine.position_given.push_back(false);
  }
  return link;
}

template <class Scalar>
void MachineDraft<Scalar>::name_free(const std::string& owner, std::size_t first, int count) {
  for (int k = 0; k < count; ++k)
    machine.mechanism.coordinate_names[first + k] =
        std::string(k < 3 ? "angular velocity of " : "velocity of ") + owner + " along " + situation.axes[k % 3];
}

template <class Scalar>
int MachineDraft<Scalar>::add_action(ActionKind kind, const std::string& name, const std::string& joint, int on,
                                     int from) {
  machine.mechanism.actions.push_back({kind, name, joint, on, from});
  return static_cast<int>(machine.mechanism.actions.size()) - 1;
}

template <class Scalar>
Component<Scalar>& MachineDraft<Scalar>::add_component(int action, const std::string& axis, bool couple,
                                                       const Place<Scalar>& at, const Direction<Scalar>& along) {
  Component<Scalar> c;
  c.action = action;
  c.axis = axis;
  c.couple = couple;
  c.at = at;
  c.along = along;
  machine.mechanism.components.push_back(std::move(c));
  return machine.mechanism.components.back();
}

template <class Scalar>
VelocityConstraint<Scalar>& MachineDraft<Scalar>::add_constraint(VelocityConstraintKind kind, const std::string& words,
                                                                 int on, int from, const Place<Scalar>& at,
                                                                 const Vector3<Scalar>& drawn,
                                                                 const std::string& joint) {
  VelocityConstraint<Scalar> c;
  c.kind = kind;
  c.words = words;
  c.on = on;
  c.from = from;
  c.at = at;
  c.along = {from, drawn};
  c.toward = machine.place(from, at.point + machine.drawn_origin.at(on));
  machine.constraint_joints.push_back(joint);
  machine.mechanism.constraints.push_back(std::move(c));
  return machine.mechanism.constraints.back();
}

template <class Scalar>
std::pair<Vector3<Scalar>, Vector3<Scalar>> across(const Vector3<Scalar>& u) {
  using Vector = Vector3<Scalar>;
  std::size_t smallest = 0;
  for (std::size_t i = 1; i < 3; ++i)
    if (constexpr double clearly = 1e-12;  // so that rounding of a unit vector does not choose between equal components
        std::abs(plain(u[i])) < std::abs(plain(u[smallest])) - clearly)
      smallest = i;
  const Vector first = normalized(Vector::unit(smallest) - dot(Vector::unit(smallest), u) * u);
  return {first, cross(u, first)};
}

template struct MachineDraft<double>;
template struct MachineDraft<Dual<1>>;
template std::pair<Vector3<double>, Vector3<double>> across(const Vector3<double>&);
template std::pair<Vector3<Dual<1>>, Vector3<Dual<1>>> across(const Vector3<Dual<1>>&);
template struct MachineDraft<Formula>;
template std::pair<Vector3<Formula>, Vector3<Formula>> across(const Vector3<Formula>&);

}  // namespace poinsot::problem
