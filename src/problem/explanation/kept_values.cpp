#include "problem/explanation/kept_values.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <memory>
#include <optional>

#include "poinsot/engine/dynamics/action_forces.h"
#include "poinsot/engine/dynamics/convert_mechanism.h"
#include "problem/instant/instant_conditions.h"
#include "problem/keys/joint_kinds.h"

namespace poinsot::problem {
namespace {

using Rate = Dual<1>;  // a number and its rate of change, 1/s
using MovingState = solve::MechanismStateOf<Rate>;

// Where it is looked, as parts of the time followed: apart by parts that no two periods have in common.
constexpr std::array<double, 7> looks{0, 0.0917, 0.2339, 0.3871, 0.6143, 0.8311, 1};
// Up to this part of itself a value that is kept may differ between two places: a thousand times what integration
// leaves over long motions.
constexpr double same_value = 1e-6;
// The rates of the terms of a kept value cancel up to this part of them: accelerations of loops have seven digits at
// least.
constexpr double same_rate = 1e-8;
// Where nothing but rounding is left of these rates, they are below this part of what the terms would change at the
// pace of the motion.
constexpr double rounding_of_rates = 1e-12;

// The sum of vectors, of which the component on an axis may keep its value.
struct Candidate {
  struct Terms {
    std::vector<Vector3<Rate>> vectors;
    Vector3<Rate> axis;
  };
  std::string words, symbol;
  Dimension dimension;
  std::function<Terms(const MovingState&)> terms;
};

double size_of_value(const Vector3<Rate>& a) { return std::hypot(a[0].value, a[1].value, a[2].value); }
double size_of_rate(const Vector3<Rate>& a) { return std::hypot(a[0].partial[0], a[1].partial[0], a[2].partial[0]); }

// The energy, the angular momenta about axes and points fixed in the ground, and the spins of bodies of revolution.
std::vector<Candidate> candidates(const Situation& situation, const Machine& machine, double length) {
  std::vector<Candidate> all;
  all.push_back({"kinetic and potential energy together", "T + V", dimensions::energy, [](const MovingState& state) {
                   const auto& mechanism = state.mechanism();
                   Candidate::Terms terms{{}, Vector3<Rate>::unit(0)};
                   const auto add = [&](const Rate& energy) { terms.vectors.push_back(energy * terms.axis); };
                   for (int i = 0; i < mechanism.tree.body_count(); ++i)
                     add(body_kinetic_energy(mechanism.tree, state.workspace(), i));
                   add(potential_energy(mechanism.tree, state.workspace()));
                   add(stored_energy(mechanism, state.workspace(), state.state()));
                   return terms;
                 }});
  const auto add_momentum = [&](const std::string& point, const Vector3<double>& P, std::size_t axis,
                                const std::string& index) {
    all.push_back({"the angular momentum about " + point + " on the axis $" + index + "$", "H_{" + index + "}",
                   dimensions::angular_momentum, [P, axis](const MovingState& state) {
                     const Model<Rate>& tree = state.mechanism().tree;
                     Candidate::Terms terms{{}, Vector3<Rate>::unit(axis)};
                     for (int i = 0; i < tree.body_count(); ++i)
                       terms.vectors.push_back(
                           body_momentum(tree, state.workspace(), i, Vector3<Rate>{P[0], P[1], P[2]}).angular);
                     return terms;
                   }});
  };
  for (const Joint& joint : situation.joints) {
    const auto place = machine.joints.find(joint.name);
    if (joint.from != "ground" || place == machine.joints.end()) continue;
    solve::MechanismState drawn(machine.mechanism);
    const Vector3<double> P = drawn.position(place->second.at);
    for (std::size_t k = 0; k < 3; ++k) {
      const Vector3<double> axis = Vector3<double>::unit(k);
      const bool own = place->second.axis && norm(cross(drawn.direction(*place->second.axis), axis)) < 1e-9;
      // A joint that holds a point takes no angular momentum about an axis on which it turns freely.
      if (joint.kind->any_turning || (own && !joint.kind->slides()))
        add_momentum("*" + joint.name + "*", P, k, situation.axes[k]);
    }
  }
  for (int i = 0; i < machine.mechanism.tree.body_count(); ++i) {
    const auto& body = machine.mechanism.tree.body(i);
    if (!(body.inertia.mass > 0) || !turns_unseen(machine.mechanism.tree, i, length) ||
        body.joint != JointType::revolute)
      continue;
    all.push_back({"the angular velocity of *" + machine.mechanism.tree.name(i) + "* on its own axis",
                   "\\omega_{\\mathrm{axis}}", dimensions::angular_velocity, [i](const MovingState& state) {
                     const auto& motion = state.workspace().motion[static_cast<std::size_t>(i + 1)];
                     return Candidate::Terms{{motion.w}, motion.R.column(2)};
                   }});
  }
  return all;
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

std::vector<KeptValue> kept_values(const Situation& situation, std::size_t situation_index, Sample& sample,
                                   double end) {
  SolvedInstant& start = sample.instant_at(situation_index, 0);
  const double pace = start.pace();
  std::vector<Candidate> all = candidates(situation, start.machine(), start.scales().length);
  std::vector<double> least(all.size()), most(all.size()), natural;
  for (const Candidate& one : all) natural.push_back(start.natural_size(one.dimension));
  std::vector<bool> kept(all.size(), true);
  for (const double look : looks) {
    SolvedInstant& instant = sample.instant_at(situation_index, look * end);
    const std::optional<MovingInstant> moving = MovingInstant::of(instant);
    if (!moving) return {};
    for (std::size_t i = 0; i < all.size(); ++i) {
      const Candidate::Terms terms = all[i].terms(moving->state());
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
    values.push_back({all[i].words, all[i].symbol, all[i].dimension, is_rounding(least[i], 1e4 * size) ? 0 : least[i]});
  }
  return values;
}

}  // namespace poinsot::problem
