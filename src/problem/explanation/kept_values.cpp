#include "problem/explanation/kept_values.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <memory>
#include <optional>

#include "poinsot/engine/dynamics/action_forces.h"
#include "poinsot/engine/dynamics/convert_mechanism.h"
#include "problem/explanation/explanation_tex.h"
#include "problem/instant/instant_conditions.h"
#include "problem/keys/joint_kinds.h"

namespace poinsot::problem {
namespace {

using Rate = Dual<1>;  // a number and its rate of change, 1/s
using MovingState = solve::MechanismStateOf<Rate>;

// Where it is looked, as parts of the time followed: apart by parts that no two periods have in common.
constexpr std::array<double, 7> looks{0, 0.0917, 0.2339, 0.3871, 0.6143, 0.8311, 1};
// The place of these at which formulas are held against numbers: inside, where nothing is special.
constexpr std::size_t general_look = 3;
// Up to this part of itself a value that is kept may differ between two places: a thousand times what integration
// leaves over long motions.
constexpr double same_value = 1e-6;
// The rates of the terms of a kept value cancel up to this part of them: accelerations of loops have seven digits at
// least.
constexpr double same_rate = 1e-8;
// Where nothing but rounding is left of these rates, they are below this part of what the terms would change at the
// pace of the motion.
constexpr double rounding_of_rates = 1e-12;
// The sine of the angle between directions that the statement gives as one: rounding, and digits that were left out.
constexpr double same_direction = 1e-9;

// What may keep its value: the sum of vectors on an axis.
struct Candidate {
  enum class Kind { energy, angular_momentum, spin } kind = Kind::energy;
  std::string words, symbol;
  Dimension dimension;
  std::string joint{};   // about which the angular momentum is taken
  std::size_t axis = 0;  // of the ground, for the angular momentum
  int body = ground;     // that spins
};

template <class Scalar>
struct Terms {
  std::vector<Vector3<Scalar>> vectors;
  Vector3<Scalar> axis;
};

template <class Scalar>
Terms<Scalar> terms_of(const Candidate& candidate, const solve::MechanismStateOf<Scalar>& state,
                       const Vector3<Scalar>& about) {
  const Mechanism<Scalar>& mechanism = state.mechanism();
  const Model<Scalar>& tree = mechanism.tree;
  Terms<Scalar> terms{{}, Vector3<Scalar>::unit(candidate.axis)};
  switch (candidate.kind) {
    case Candidate::Kind::energy: {
      const auto add = [&](const Scalar& energy) { terms.vectors.push_back(energy * terms.axis); };
      for (int i = 0; i < tree.body_count(); ++i) add(body_kinetic_energy(tree, state.workspace(), i));
      add(potential_energy(tree, state.workspace()));
      add(stored_energy(mechanism, state.workspace(), state.state()));
      break;
    }
    case Candidate::Kind::angular_momentum:
      for (int i = 0; i < tree.body_count(); ++i)
        terms.vectors.push_back(body_momentum(tree, state.workspace(), i, about).angular);
      break;
    case Candidate::Kind::spin: {
      const auto& motion = state.workspace().motion[static_cast<std::size_t>(candidate.body + 1)];
      terms = {{motion.w}, motion.R.column(2)};
      break;
    }
  }
  return terms;
}

double size_of_value(const Vector3<Rate>& a) { return std::hypot(a[0].value, a[1].value, a[2].value); }
double size_of_rate(const Vector3<Rate>& a) { return std::hypot(a[0].partial[0], a[1].partial[0], a[2].partial[0]); }

// The energy, the angular momenta about axes and points fixed in the ground, and the spins of bodies of revolution.
std::vector<Candidate> candidates(const Situation& situation, const Machine& machine, double length) {
  std::vector<Candidate> all{
      {Candidate::Kind::energy, "the sum of kinetic and potential energy", "T + V", dimensions::energy}};
  for (const Joint& joint : situation.joints) {
    const auto place = machine.joints.find(joint.name);
    if (joint.from != "ground" || place == machine.joints.end()) continue;
    const solve::MechanismState drawn(machine.mechanism);
    for (std::size_t k = 0; k < 3; ++k) {
      const Vector3<double> axis = Vector3<double>::unit(k);
      const bool own = place->second.axis && norm(cross(drawn.direction(*place->second.axis), axis)) < same_direction;
      // A joint that holds a point takes no angular momentum about an axis on which it turns freely.
      if (!joint.kind->any_turning && (!own || joint.kind->slides())) continue;
      const std::string& index = situation.axes[k];
      all.push_back({Candidate::Kind::angular_momentum,
                     "the angular momentum about *" + joint.name + "* on the axis $" + index + "$", "H_{" + index + "}",
                     dimensions::angular_momentum, joint.name, k});
    }
  }
  for (int i = 0; i < machine.mechanism.tree.body_count(); ++i) {
    const auto& body = machine.mechanism.tree.body(i);
    if (!(body.inertia.mass > 0) || !turns_unseen(machine.mechanism.tree, i, length) ||
        body.joint != JointType::revolute)
      continue;
    all.push_back({Candidate::Kind::spin,
                   "the angular velocity of *" + machine.mechanism.tree.name(i) + "* on its own axis",
                   "\\omega_{\\mathrm{axis}}", dimensions::angular_velocity, "", 0, i});
  }
  return all;
}

// The point about which an angular momentum is taken, which does not move.
template <class Scalar>
Vector3<Scalar> point_of(const Candidate& candidate, const MachineOf<Scalar>& machine,
                         const solve::MechanismStateOf<Scalar>& state) {
  return candidate.joint.empty() ? Vector3<Scalar>::zero() : state.position(machine.joints.at(candidate.joint).at);
}

// The kept value in letters, if it has there what it has in numbers.
std::optional<Formula> formula_of(const Candidate& candidate, const GeneralMotion& general, const MotionState& now,
                                  double value, double size) {
  try {
    const auto letters = general.letters_at(now);
    if (!letters) return std::nullopt;
    const PlainPointScope decisions(*letters);
    const Terms<Formula> terms =
        terms_of(candidate, general.state(), point_of(candidate, general.formulas().machine(), general.state()));
    Formula sum(0);
    for (const Vector3<Formula>& term : terms.vectors) sum += dot(terms.axis, term);
    if (!general.is_named(sum) || !(std::abs(value_at(sum, *letters) - value) <= same_value * size))
      return std::nullopt;
    return sum;
  } catch (const std::domain_error&) {
    return std::nullopt;
  } catch (const FormulaTooLarge&) {
    return std::nullopt;
  }
}

// The kept value as the start states it, if the data give it there the number that it has all along.
std::optional<Formula> at_start_of(const KeptValue& kept, const GeneralMotion& general, const MotionState& start,
                                   const std::vector<const Instant*>& stated) {
  try {
    const auto letters = general.letters_at(start);
    if (!letters) return std::nullopt;
    const PlainPointScope decisions(*letters);
    std::optional<Formula> formula = general.at_start(*kept.formula, start, stated);
    if (!formula || !(std::abs(value_at(*formula, *letters) - kept.value) <= same_value * kept.size))
      return std::nullopt;
    return formula;
  } catch (const StatementError&) {
    return std::nullopt;
  } catch (const std::domain_error&) {
    return std::nullopt;
  } catch (const FormulaTooLarge&) {
    return std::nullopt;
  }
}

// The state of an instant with the rates of its coordinates; none if its accelerations are not determined.
class MovingInstant {
 public:
  static std::optional<MovingInstant> of(SolvedInstant& instant) {
    try {
      instant.solve_forces();
    } catch (const StatementError&) {
      return std::nullopt;
    }
    const MotionState now = instant.state();
    const solve::LinearSolution& motion = instant.motion();
    for (std::size_t k = 0; k < now.v.size(); ++k)
      if (!motion.determined(k)) return std::nullopt;
    return MovingInstant(instant.machine().mechanism, now, motion.value);
  }
  const MovingState& state() const { return state_; }

 private:
  MovingInstant(const Mechanism<double>& mechanism, const MotionState& now, const std::vector<double>& a)
      : mechanism_(
            std::make_shared<Mechanism<Rate>>(convert_mechanism<Rate>(mechanism, [](double x) { return Rate(x); }))),
        state_(*mechanism_) {
    std::vector<double> q_rate(now.q.size());
    position_rate<double>(mechanism.tree, now.q, now.v, q_rate);
    std::vector<Rate> q, v;
    for (std::size_t k = 0; k < now.q.size(); ++k) q.push_back({now.q[k], {q_rate[k]}});
    for (std::size_t k = 0; k < now.v.size(); ++k) v.push_back({now.v[k], {a[k]}});
    state_.set_positions(q);
    state_.set_velocities(v);
  }

  std::shared_ptr<const Mechanism<Rate>> mechanism_;
  MovingState state_;
};

}  // namespace

std::vector<KeptValue> kept_values(const Situation& situation, std::size_t situation_index, Sample& sample, double end,
                                   const GeneralMotion* general) {
  SolvedInstant& start = sample.instant_at(situation_index, 0);
  const double pace = start.pace();
  std::vector<Candidate> all = candidates(situation, start.machine(), start.scales().length);
  std::vector<double> least(all.size()), most(all.size()), natural;
  for (const Candidate& one : all) natural.push_back(start.natural_size(one.dimension));
  std::vector<bool> kept(all.size(), true);
  std::vector<Vector3<Rate>> points;
  {
    const solve::MechanismState drawn(start.machine().mechanism);
    for (const Candidate& one : all) {
      const Vector3<double> P = point_of(one, start.machine(), drawn);
      points.push_back({P[0], P[1], P[2]});
    }
  }
  for (const double look : looks) {
    SolvedInstant& instant = sample.instant_at(situation_index, look * end);
    const std::optional<MovingInstant> moving = MovingInstant::of(instant);
    if (!moving) return {};
    for (std::size_t i = 0; i < all.size(); ++i) {
      const Terms<Rate> terms = terms_of(all[i], moving->state(), points[i]);
      Rate sum(0);
      double size = 0, rates = 0;
      for (const Vector3<Rate>& term : terms.vectors) {
        sum += dot(terms.axis, term);
        size += size_of_value(term);
        rates += size_of_rate(term) + size_of_value(term) * size_of_rate(terms.axis);
      }
      kept[i] = kept[i] && std::abs(sum.partial[0]) <= same_rate * rates + rounding_of_rates * pace * size;
      least[i] = look == looks.front() ? sum.value : std::min(least[i], sum.value);
      most[i] = look == looks.front() ? sum.value : std::max(most[i], sum.value);
    }
  }
  std::vector<KeptValue> values;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const double size = std::max({std::abs(least[i]), std::abs(most[i]), natural[i]});
    if (!kept[i] || most[i] - least[i] > same_value * size) continue;
    // Integration leaves more than rounding of what vanishes.
    constexpr double left_by_integration = 1e4;
    const double value = is_rounding(least[i], left_by_integration * size) ? 0 : least[i];
    values.push_back({all[i].words, all[i].symbol, all[i].dimension, value, size});
    if (!general) continue;
    values.back().formula = formula_of(
        all[i], *general, sample.instant_at(situation_index, looks[general_look] * end).state(), value, size);
    if (values.back().formula)
      values.back().at_start = at_start_of(values.back(), *general, start.state(), instants_at_start(situation));
  }
  return values;
}

}  // namespace poinsot::problem
