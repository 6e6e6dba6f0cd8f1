// The values of quantities for a mechanism in motion: momenta, energies, velocities, forces, reactions.
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
#include "problem/quantities/told_quantity.h"

namespace poinsot::problem {

// In place of the index of a body this means all bodies together.
constexpr int whole_system = -2;

// A particle that belongs to no body, such as one that has passed through.
template <class Scalar>
struct FlyingParticle {
  Scalar mass{};
  Vector3<Scalar> position{}, velocity{};  // m, m/s, on ground axes
};

// The scope in which expressions about a mechanism in motion are evaluated.
//
// Base is the scalar of the machine. Scalar is the same, or Dual<1, Base> for derivatives by time or by a velocity.
template <class Scalar, class Base = Scalar>
class QuantityScope : public Scope<Scalar> {
 public:
  // The data must have the same scalar. All arguments must outlive the scope.
  QuantityScope(const MachineOf<Base>& machine, const Model<Scalar>& model, DataScope<Scalar>& data,
                State<Scalar> state);

  // Sets the accelerations of the coordinates, and for forces the solution of the equations of motion that they
  // belong to.
  void set_accelerations(const std::vector<Base>& accelerations);
  void set_forces(const solve::MechanismStateOf<Base>* state, const std::vector<Base>* unknowns);
  // Sets the particles of strikes that fly on their own: they belong to the system.
  void set_flying(std::vector<FlyingParticle<Base>> particles) { flying_ = std::move(particles); }
  void set_blow(const solve::MechanismStateOf<Base>* before, const solve::BlowOf<Base>* blow,
                const std::vector<Base>* impulses) {
    before_ = before;
    blow_ = blow;
    impulses_ = impulses;
  }
  // Sets the axes on which components such as x, y, z are taken. Without it these are the axes of the ground.
  void set_axes(const Expression& expression) {
    axes_expression_ = expression;
    axes_ = axes_of(expression);
  }
  const Matrix3<Scalar>& axes() const { return axes_; }
  // The axes named by an `axes:` entry: those of a body, a frame or the ground, or a list of three directions.
  Matrix3<Scalar> axes_of(const Expression& expression);
  // Sets the function that evaluates what stands before an `@`, which concerns another instant.
  void set_elsewhere(std::function<Value<Scalar>(const At&, const Mark&)> elsewhere) {
    elsewhere_ = std::move(elsewhere);
  }

  // Sets the values of min(), max() and period() over the motion. They must outlive the scope.
  void set_motion_features(const MotionFeatureValues& values) { features_ = &values; }
  // The function that linearises the motion near this one, with the shapes of its modes or without. Errors are reported
  // at the mark.
  using Linearise = std::function<const solve::Linearisation&(const Mark&, bool with_shapes)>;
  void set_linearisation(Linearise linearisation) { linearisation_ = std::move(linearisation); }

  // The function that finds the amplitude and phase of response(X to F). Errors are reported at the mark.
  using Respond = std::function<Value<double>(const Call&, const Mark&)>;
  void set_response(Respond respond) { respond_ = std::move(respond); }

  // The function that finds frequencies, rates and responses near this motion where all of it is in letters.
  using NearInLetters = std::function<Value<Base>(const Call&, const Mark&)>;
  void set_near_in_letters(NearInLetters near) { near_in_letters_ = std::move(near); }

  // Sets where it is written down what is told of the model by plain numbers. It must outlive the scope.
  void set_told(std::vector<ToldQuantity>* told) { told_ = told; }

  Value<Scalar> value(const Expression& expression);

  Value<Scalar> name(const Name& name, const Mark& mark, const Evaluator<Scalar>& evaluator) override;
  Value<Scalar> call(const Call& call, const Mark& mark, const Evaluator<Scalar>& evaluator) override;
  Value<Scalar> of(const Of& of, const Mark& mark, const Evaluator<Scalar>& evaluator) override;
  Value<Scalar> at(const At& at, const Mark& mark, const Evaluator<Scalar>& evaluator) override;
  Value<Scalar> member(const Member& member, const Mark& mark, const Evaluator<Scalar>& evaluator) override;

 private:
  using Vector = Vector3<Scalar>;
  using Result = Value<Scalar>;

  // The value in the scalar of the machine, without the derivatives that this scope adds.
  static const Base& as_base(const Scalar& x) {
    if constexpr (std::is_same_v<Scalar, Base>)
      return x;
    else
      return x.value;
  }
  static Vector3<Base> as_base(const Vector& v) { return {as_base(v.x), as_base(v.y), as_base(v.z)}; }

  // Whether it is written down what is told: only of plain numbers, and of their rates over time.
  bool tells() const { return std::is_same_v<Base, double> && told_; }
  static constexpr bool tells_rates = std::is_same_v<Scalar, Dual<1>>;
  static Vector3<double> plain_vector(const Vector& v) { return {plain(v.x), plain(v.y), plain(v.z)}; }
  static Vector3<double> rate_of(const Vector& v) {
    if constexpr (tells_rates)
      return {v.x.partial[0], v.y.partial[0], v.z.partial[0]};
    else
      return {};
  }

  int body_of(const Expression& expression, const Evaluator<Scalar>& evaluator, bool system_allowed = false);
  bool is_frame(int body) const;
  Vector place(const Expression& expression, const Evaluator<Scalar>& evaluator);
  // A point that moves with a body: `A of plate`, `center(disk)`, or a body, which stands for its mass center.
  struct Riding {
    int body;
    Vector local;
    std::optional<Vector3<Base>> drawn;  // where it was drawn, if the statement says so
  };
  Riding riding(const Expression& expression, const Evaluator<Scalar>& evaluator);
  Vector mass_center_of(int body, const Expression& expression, const Evaluator<Scalar>& evaluator);
  MassProperties<Scalar> current_mass(int body);
  // An axis as a point and a direction: A->B, axis(J), or a direction with its point after `at`.
  std::pair<Vector, Vector> line(const Call& call, const Evaluator<Scalar>& evaluator);

  // Write down what is told of places and directions that ride with bodies, and of what geometry makes of them.
  void tell_position(int body, const std::optional<Vector3<Base>>& drawn, const Vector& position,
                     const std::string& words);
  void tell_direction(int body, const Vector3<Base>& drawn, const Vector& direction, const std::string& words);
  void tell_geometry(ToldQuantity::Kind kind, const Vector& place, const Vector& first, const Vector& second,
                     const Scalar& value, const std::string& words);

  Result kinematic(const Call& call, const Evaluator<Scalar>& evaluator);
  Result momentum(const Call& call, const Evaluator<Scalar>& evaluator);
  Result inertia(const Call& call, const Mark& mark, const Evaluator<Scalar>& evaluator);
  Result free_motion(const Call& call, const Mark& mark, const Evaluator<Scalar>& evaluator);
  Result poinsot_construction(const Call& call, const Mark& mark, const Evaluator<Scalar>& evaluator, int body,
                              const Vector& H, const Vector& w);
  Result geometry(const Call& call, const Evaluator<Scalar>& evaluator);
  Result force(const Call& call, const Mark& mark, const Evaluator<Scalar>& evaluator);
  Result holding(const Call& call, const Evaluator<Scalar>& evaluator);
  Result friction(const Call& call, const Evaluator<Scalar>& evaluator);
  // Nothing if there is no contact of this name.
  std::optional<Result> push_of_smooth(const std::string& name, const Call& call, const Evaluator<Scalar>& evaluator);
  Result stability(const Call& call, const Mark& mark, const Evaluator<Scalar>& evaluator);
  Result modes(const solve::Linearisation& near, int body);
  Result extreme_of_list(const Call& call, const Mark& mark, const Evaluator<Scalar>& evaluator);
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
  const MotionFeatureValues* features_ = nullptr;
  Linearise linearisation_;
  Respond respond_;
  NearInLetters near_in_letters_;
  bool has_accelerations_ = false;
  std::vector<Base> accelerations_;
  std::vector<FlyingParticle<Base>> flying_;
  const solve::MechanismStateOf<Base>* mechanism_state_ = nullptr;
  const std::vector<Base>* unknowns_ = nullptr;
  const solve::MechanismStateOf<Base>* before_ = nullptr;
  const solve::BlowOf<Base>* blow_ = nullptr;
  const std::vector<Base>* impulses_ = nullptr;
  std::vector<std::string> pending_;
  std::vector<ToldQuantity>* told_ = nullptr;

  template <class Other, class OtherBase>
  friend class QuantityScope;
};

extern template class QuantityScope<double>;
extern template class QuantityScope<Dual<1>, double>;

}  // namespace poinsot::problem
