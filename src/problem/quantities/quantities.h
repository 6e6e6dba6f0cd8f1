// What the words of the language mean on a mechanism in motion: momenta, energies, velocities, forces, reactions.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "poinsot/engine/dynamics/momentum.h"
#include "poinsot/engine/solve/instant/equations.h"
#include "poinsot/engine/solve/stability/linearisation.h"
#include "problem/machine/data.h"
#include "problem/machine/machine.h"
#include "problem/quantities/quantity_functions.h"

namespace poinsot::problem {

// Stands for all bodies together where a body is asked.
constexpr int whole_system = -2;

// A particle that belongs to no body.
template <class Scalar>
struct FlyingParticle {
  Scalar mass{};
  Vector3<Scalar> position{}, velocity{};  // m, m/s, on ground axes
};

// A mechanism in motion as the scope of expressions.
//
// Base: the scalar of the machine. Scalar: the same, or Dual<1, Base>, which differentiates by time or by a velocity.
template <class Scalar, class Base = Scalar>
class QuantityScope : public Scope<Scalar> {
 public:
  // data: of the same scalar. All arguments must outlive the scope.
  QuantityScope(const MachineOf<Base>& machine, const Model<Scalar>& model, DataScope<Scalar>& data,
                State<Scalar> state);

  // Accelerations of the coordinates, and (for forces) the solution of the motion equations that they come from.
  void set_accelerations(const std::vector<Base>& accelerations);
  void set_forces(const solve::MechanismStateOf<Base>* moment, const std::vector<Base>* unknowns);
  // Particles of strikes that fly by themselves now: they belong to the system.
  void set_flying(std::vector<FlyingParticle<Base>> particles) { flying_ = std::move(particles); }
  void set_blow(const solve::MechanismStateOf<Base>* before, const solve::BlowOf<Base>* blow,
                const std::vector<Base>* impulses) {
    before_ = before;
    blow_ = blow;
    impulses_ = impulses;
  }
  // The axes on which x, y, z and components are meant; those of the ground when never set.
  void set_axes(const Expression& expression) {
    axes_expression_ = expression;
    axes_ = axes_of(expression);
  }
  const Matrix3<Scalar>& axes() const { return axes_; }
  // The axes that an `axes:` entry names: a body, a frame, `ground`, or a list of three directions.
  Matrix3<Scalar> axes_of(const Expression& expression);
  // What stands before an `@` is asked of another scope.
  void set_elsewhere(std::function<Value<Scalar>(const At&, const Mark&)> elsewhere) {
    elsewhere_ = std::move(elsewhere);
  }

  // What min(), max() and period() of a quantity are over the motion.
  using Feature =
      std::function<Value<double>(const Call& call, const std::optional<Expression>& axes, const Mark& mark)>;
  void set_motion(Feature feature) { feature_ = std::move(feature); }
  // The motion near this one; asked for at the mark.
  void set_linearisation(std::function<const solve::Linearisation&(const Mark&)> linearisation) {
    linearisation_ = std::move(linearisation);
  }

  Value<Scalar> value(const Expression& expression);

  Value<Scalar> name(const Name& name, const Mark& mark, const Evaluator<Scalar>& evaluator) override;
  Value<Scalar> call(const Call& call, const Mark& mark, const Evaluator<Scalar>& evaluator) override;
  Value<Scalar> of(const Of& of, const Mark& mark, const Evaluator<Scalar>& evaluator) override;
  Value<Scalar> at(const At& at, const Mark& mark, const Evaluator<Scalar>& evaluator) override;
  Value<Scalar> member(const Member& member, const Mark& mark, const Evaluator<Scalar>& evaluator) override;

 private:
  using Vector = Vector3<Scalar>;
  using Result = Value<Scalar>;

  // What the machine is made of, without the derivatives that this scope adds.
  static const Base& as_base(const Scalar& x) {
    if constexpr (std::is_same_v<Scalar, Base>)
      return x;
    else
      return x.value;
  }
  static Vector3<Base> as_base(const Vector& v) { return {as_base(v.x), as_base(v.y), as_base(v.z)}; }

  int body_of(const Expression& expression, const Evaluator<Scalar>& evaluator, bool system_allowed = false);
  bool is_frame(int body) const;
  Vector place(const Expression& expression, const Evaluator<Scalar>& evaluator);
  // A point that rides with a body: `A of plate`, `center(disk)`, or a body (its mass center).
  struct Riding {
    int body;
    Vector local;
  };
  Riding riding(const Expression& expression, const Evaluator<Scalar>& evaluator);
  Vector mass_center_of(int body, const Expression& expression, const Evaluator<Scalar>& evaluator);
  MassProperties<Scalar> current_mass(int body);
  // Axis through a point: A->B, axis(J), or a direction with its point after `at`.
  std::pair<Vector, Vector> line(const Call& call, const Evaluator<Scalar>& evaluator);

  Result kinematic(const Call& call, const Evaluator<Scalar>& evaluator);
  Result momentum(const Call& call, const Evaluator<Scalar>& evaluator);
  Result inertia(const Call& call, const Mark& mark, const Evaluator<Scalar>& evaluator);
  Result free_motion(const Call& call, const Mark& mark, const Evaluator<Scalar>& evaluator);
  Result poinsot_construction(const Call& call, const Mark& mark, const Evaluator<Scalar>& evaluator, int body,
                              const Vector& H, const Vector& w);
  Result geometry(const Call& call, const Evaluator<Scalar>& evaluator);
  Result force(const Call& call, const Mark& mark, const Evaluator<Scalar>& evaluator);
  Result holding(const Call& call, const Evaluator<Scalar>& evaluator);
  Result stability(const Call& call, const Mark& mark, const Evaluator<Scalar>& evaluator);
  Result rate(const Call& call, const Mark& mark, const Evaluator<Scalar>& evaluator);
  Result derivative_by(const Call& call, const Mark& mark, const Evaluator<Scalar>& evaluator);

  const MachineOf<Base>& machine_;
  const Model<Scalar>& model_;
  DataScope<Scalar>& data_;
  const Situation& situation_;
  State<Scalar> state_;
  Workspace<Scalar> workspace_;
  Matrix3<Scalar> axes_ = Matrix3<Scalar>::identity();
  std::optional<Expression> axes_expression_;
  std::function<Value<Scalar>(const At&, const Mark&)> elsewhere_;
  Feature feature_;
  std::function<const solve::Linearisation&(const Mark&)> linearisation_;
  bool has_accelerations_ = false;
  std::vector<Base> accelerations_;
  std::vector<FlyingParticle<Base>> flying_;
  const solve::MechanismStateOf<Base>* moment_ = nullptr;
  const std::vector<Base>* unknowns_ = nullptr;
  const solve::MechanismStateOf<Base>* before_ = nullptr;
  const solve::BlowOf<Base>* blow_ = nullptr;
  const std::vector<Base>* impulses_ = nullptr;
  std::vector<std::string> pending_;

  template <class Other, class OtherBase>
  friend class QuantityScope;
};

extern template class QuantityScope<double>;
extern template class QuantityScope<Dual<1>, double>;

}  // namespace poinsot::problem
