#include "problem/instant/rough_blow.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <type_traits>

#include "poinsot/engine/dynamics/momentum.h"
#include "poinsot/engine/math/formula/formula.h"
#include "poinsot/engine/math/formula/formula_decision.h"
#include "poinsot/engine/solve/instant/equations.h"
#include "problem/language/words.h"

namespace poinsot::problem {
namespace {

using Vector = Vector3<double>;
using Course = solve::RoughImpactCourse;

constexpr double solved_to = 1e-10;  // by the equations of a blow, 1e-11 at worst

std::vector<Vector> axes_of_contact(const Vector& push) {
  Vector along = Vector::unit(0);
  for (std::size_t k = 1; k < 3; ++k)
    if (std::abs(push[k]) < std::abs(dot(push, along))) along = Vector::unit(k);
  const Vector across = normalized(along - dot(along, push) * push);
  return {push, across, cross(push, across)};
}

// The velocities of all coordinates, and the impulses of the mechanism's components, for an impulse of size one along
// each axis of the contact.
struct Responses {
  std::vector<std::vector<double>> by_axis;
  Matrix3<double> inverse_mass;
};

Responses responses(const RoughBlowSetting& setting, const std::vector<Vector>& axes) {
  const solve::Impact& impact = setting.blow.impacts.front();
  const auto n = setting.before.state().v.size();
  solve::MechanismState at_rest = setting.before;
  at_rest.set_velocities(std::vector<double>(n, 0.0));
  Responses all;
  solve::MechanismState struck = at_rest;
  for (std::size_t i = 0; i < 3; ++i) {
    solve::Blow unit;
    unit.held_coordinates = setting.blow.held_coordinates;
    unit.impacts.push_back(impact);
    unit.impacts.front().push = {ground, axes[i]};
    unit.impacts.front().given = 1;
    all.by_axis.push_back(solve::solve_impulse(at_rest, setting.scales, unit, {}, setting.acting).value);
    struck.set_velocities({all.by_axis[i].begin(), all.by_axis[i].begin() + static_cast<std::ptrdiff_t>(n)});
    const Vector moved = impact_velocity(struck, impact);
    for (std::size_t j = 0; j < 3; ++j) all.inverse_mass(j, i) = dot(axes[j], moved);
  }
  // It is symmetric but for rounding.
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < i; ++j)
      all.inverse_mass(i, j) = all.inverse_mass(j, i) = 0.5 * (all.inverse_mass(i, j) + all.inverse_mass(j, i));
  return all;
}

double kinetic_energy_with(solve::MechanismState& state, const std::vector<double>& v) {
  state.set_velocities(v);
  return kinetic_energy(state.mechanism().tree, state.workspace());
}

// Whether all cords and contacts that act pull or push at every part of the blow, and the others part.
// speed: of what moves before.
bool others_agree(const RoughBlowSetting& setting, const Responses& by, const Course& course, double speed) {
  const Mechanism<double>& mechanism = setting.before.mechanism();
  const std::vector<double>& v = setting.before.state().v;
  const auto total = [&](std::size_t unknown, const Vector& impulse) {
    double sum = 0;
    for (std::size_t i = 0; i < 3; ++i) sum += impulse[i] * by.by_axis[i][unknown];
    return sum;
  };
  for (std::size_t k = 0; k < mechanism.components.size(); ++k) {
    const auto action = static_cast<std::size_t>(mechanism.components[k].action);
    if (!mechanism.components[k].one_sided || !setting.acting[action]) continue;
    Vector last{};
    for (const Vector& point : course.way) {
      if (total(v.size() + k, point - last) < -solved_to * norm(course.impulse)) return false;
      last = point;
    }
  }
  for (const VelocityConstraint<double>& constraint : mechanism.constraints) {
    if (constraint.action < 0 || constraint.action == setting.blow.impacts.front().action ||
        setting.acting[static_cast<std::size_t>(constraint.action)])
      continue;
    if (setting.touching && !(*setting.touching)[static_cast<std::size_t>(constraint.action)]) continue;
    if (!constraint.normal && !is_cord_length(constraint)) continue;
    if (constraint.kind == VelocityConstraintKind::led_cord && !constraint.keeps_length) continue;
    const std::vector<double> row = solve::constraint_coefficients(setting.before, constraint);
    for (const Vector& point : course.way) {
      double rate = 0, size = 0;
      for (std::size_t k = 0; k < v.size(); ++k) {
        const double term = row[k] * (v[k] + total(k, point));
        rate += term;
        size += std::abs(term);
      }
      if (is_cord_length(constraint)) rate = -rate;
      if (rate < -solved_to * (size + speed)) return false;
    }
  }
  return true;
}

// Whether nothing jumps by itself: a cord that goes taut meanwhile would strike too.
bool is_alone(const RoughBlowSetting& setting) {
  solve::Blow nothing;
  nothing.held_coordinates = setting.blow.held_coordinates;
  const std::vector<double>& v = setting.before.state().v;
  const solve::LinearSolution solved =
      solve::solve_impulse(setting.before, setting.scales, nothing, {}, setting.acting);
  const std::vector<double>& after = solved.value;
  double largest = 0, jump = 0;
  for (std::size_t k = 0; k < v.size(); ++k) {
    // What moves no mass, as the turning of a particle, is whatever it was.
    if (!solved.determined(k)) continue;
    const double unit =
        solve::coordinate_turns(setting.before.mechanism().tree, static_cast<int>(k)) ? setting.scales.length : 1;
    largest = std::max(largest, unit * std::abs(v[k]));
    jump = std::max(jump, unit * std::abs(after[k] - v[k]));
  }
  return jump <= 100 * solved_to * largest;
}

}  // namespace

RoughBlowResult follow_rough_blow(const RoughBlowSetting& setting) {
  const solve::Impact& impact = setting.blow.impacts.front();
  RoughBlowResult result;
  if (!is_alone(setting)) {
    result.words = "a cord or contact catches in the same blow, and with friction it matters which of them comes first";
    result.hint = "let one thing strike at a time";
    result.by_others = true;
    return result;
  }
  RoughBlow rough;
  const Vector push = setting.before.direction(impact.push), u = impact_velocity(setting.before, impact);
  rough.axes = axes_of_contact(push);
  const Responses by = responses(setting, rough.axes);
  const Vector before{dot(rough.axes[0], u), dot(rough.axes[1], u), dot(rough.axes[2], u)};
  double speed = norm(u);
  for (const BodyMotion<double>& motion : setting.before.workspace().motion)
    speed = std::max({speed, norm(motion.v), norm(motion.w) * setting.scales.length});
  constexpr double none = 1e-12;
  const solve::RoughImpactLaw law{impact.restitution, *impact.friction, impact.hypothesis};
  if (!(by.inverse_mass(0, 0) > 0)) {
    result.words = "nothing can move where impact '" + impact.name + "' pushes";
    return result;
  }
  rough.course = solve::follow_rough_impact(by.inverse_mass, before, law, none * speed);
  if (rough.course.end == Course::End::wedged) {
    result.words = "in the greatest compression impact '" + impact.name +
                   "' is wedged: its friction holds it against any rebound, and how hard it presses is open";
    result.hint = "state restitution: 0 if it stays there";
    return result;
  }
  if (rough.course.end == Course::End::endless) {
    result.words = "the blow at impact '" + impact.name +
                   "' does not end: friction presses the bodies together anew, and how they part is not settled by "
                   "a coefficient of restitution";
    result.hint = "reduce the friction";
    return result;
  }
  if (!others_agree(setting, by, rough.course, speed)) {
    result.words = "in the course of the blow a cord or another contact begins or ceases to act, which is not followed";
    result.hint = "leave out the friction, or what gives way";
    result.by_others = true;
    return result;
  }
  rough.friction = rough.course.impulse.y * rough.axes[1] + rough.course.impulse.z * rough.axes[2];
  const Vector slip = u - dot(u, push) * push;
  const bool slips = norm(slip) > none * speed;
  const bool one_line = slips && norm(cross(rough.friction, slip)) <= 1e-12 * norm(slip) * norm(rough.course.impulse);
  const bool uncoupled = std::hypot(by.inverse_mass(1, 0), by.inverse_mass(2, 0)) <= 1e-12 * by.inverse_mass(0, 0);
  if (one_line && rough.course.stretches.size() == 1 && rough.course.stretches.front().turned < 1e-9)
    rough.form = RoughBlow::Form::slides;
  else if (!slips && uncoupled)
    rough.form = RoughBlow::Form::still;
  else if (one_line && uncoupled && rough.course.stretches.back().sticks)
    rough.form = RoughBlow::Form::stops;
  std::vector<double> after = setting.before.state().v;
  solve::MechanismState state = setting.before;
  const double energy = kinetic_energy_with(state, after);
  for (std::size_t k = 0; k < after.size(); ++k)
    for (std::size_t i = 0; i < 3; ++i) after[k] += rough.course.impulse[i] * by.by_axis[i][k];
  rough.gained = kinetic_energy_with(state, after) - energy;
  constexpr double seen = 1e-9;
  // What moves as stated may give energy.
  const bool driven = !setting.blow.held_coordinates.empty() ||
                      solve::impulse_unknowns(setting.before.mechanism(), setting.blow).efforts > 0;
  if (driven || std::abs(rough.gained) <= seen * energy) rough.gained = 0;
  result.found = std::move(rough);
  return result;
}

namespace {

// |V|; of formulas where it lies along an axis with the sense of the numbers, so that no root is left.
template <class Scalar>
Scalar size_of_slip(const Vector3<Scalar>& V) {
  if constexpr (std::is_same_v<Scalar, Formula>) {
    const Formula* only = nullptr;
    int parts = 0;
    for (const Formula* part : {&V.x, &V.y, &V.z})
      if (!part->is_zero()) only = part, ++parts;
    if (parts == 1) return decided_negative(*only) ? -*only : *only;
  }
  using std::sqrt;
  return sqrt(dot(V, V));
}

}  // namespace

template <class Scalar>
void put_friction(solve::BlowOf<Scalar>& blow, const solve::MechanismStateOf<Scalar>& before, const RoughBlow& rough) {
  using Form = RoughBlow::Form;
  solve::ImpactOf<Scalar> friction = blow.impacts[rough.impact];
  friction.is_friction = true;
  if (rough.form == Form::numbers) {
    if constexpr (std::is_same_v<Scalar, double>) {
      blow.impacts[rough.impact].leaves = rough.course.velocity.x;
      const double size = norm(rough.friction);
      if (size == 0) return;
      friction.push = {ground, (1 / size) * rough.friction};
      friction.given = size;
    }
  } else if (rough.form == Form::still) {
    return;
  } else {
    const Vector3<Scalar> push = before.direction(blow.impacts[rough.impact].push);
    const Vector3<Scalar> u = solve::impact_velocity(before, blow.impacts[rough.impact]);
    const Vector3<Scalar> slip = u - dot(u, push) * push;
    friction.push = {ground, (Scalar(-1) / size_of_slip(slip)) * slip};
    if (rough.form == Form::slides)
      friction.per_push = *friction.friction;
    else
      friction.leaves = Scalar(0);
  }
  blow.impacts.insert(blow.impacts.begin() + static_cast<std::ptrdiff_t>(rough.impact) + 1, friction);
}

std::string words_of_blow(const RoughBlow& rough, const solve::Impact& impact) {
  const auto& stretches = rough.course.stretches;
  constexpr double degree = std::numbers::pi / 180, turns = 1e-6;
  const auto turning = [&](const Course::Stretch& stretch) {
    return stretch.turned > turns ? ", in a direction that turns by " + with_digits(stretch.turned / degree, 4) + " deg"
                                  : std::string();
  };
  std::string words = "impact '" + impact.name + "' ";
  if (stretches.size() == 1)
    words += stretches.front().sticks ? std::string("sticks") : "slips to the end" + turning(stretches.front());
  else
    words += "slips" + turning(stretches.front()) + ", " +
             (stretches.back().sticks ? "then sticks" : "stops slipping and slips on in another direction");
  // Where all hypotheses agree none is named.
  if (impact.restitution > 0 && rough.form == RoughBlow::Form::numbers) {
    words += "; restitution by the ";
    switch (impact.hypothesis) {
      case solve::RestitutionLaw::energetic:
        words += "energetic hypothesis (Stronge's)";
        break;
      case solve::RestitutionLaw::poisson:
        words += "kinetic hypothesis (Poisson's)";
        break;
      case solve::RestitutionLaw::newton:
        words += "kinematic hypothesis (Newton's)";
        break;
    }
  }
  if (rough.gained > 0) words += ": the kinetic energy rises in it, which no real blow does";
  return words;
}

template void put_friction(solve::BlowOf<double>&, const solve::MechanismStateOf<double>&, const RoughBlow&);
template void put_friction(solve::BlowOf<Dual<1>>&, const solve::MechanismStateOf<Dual<1>>&, const RoughBlow&);
template void put_friction(solve::BlowOf<Formula>&, const solve::MechanismStateOf<Formula>&, const RoughBlow&);

}  // namespace poinsot::problem
