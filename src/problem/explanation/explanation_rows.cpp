// The rows of a balance, three of forces and three of moments, and which of them are needed: where motion and forces
// lie in a plane three, where the forces that meet in the reference point are not asked for those of moments.
#include <algorithm>
#include <cmath>

#include "poinsot/engine/solve/instant/equations.h"
#include "problem/explanation/explanation_instant.h"

namespace poinsot::problem {
namespace {

// Adds a term to a side: what multiplies the same symbol, as where a cord comes and goes, is one sum.
void add_to(std::vector<ShownTerm>& side, ShownTerm term) {
  const auto same = std::ranges::find(side, term.symbol, &ShownTerm::symbol);
  if (same == side.end()) {
    side.push_back(std::move(term));
    return;
  }
  Shown& sum = same->coefficient;
  sum.number += term.coefficient.number;
  try {
    if (sum.formula && term.coefficient.formula)
      *sum.formula += *term.coefficient.formula;
    else
      sum.formula.reset();
  } catch (const FormulaTooLarge&) {
    sum.formula.reset();
  }
}

}  // namespace

InstantExplainer::Row InstantExplainer::row_of(const System& system, const MotionBalance<double>& numbers,
                                               const std::optional<MotionBalance<Formula>>& formulas,
                                               std::size_t row) const {
  const auto pair = [&](const SpatialForce<double>& number, const SpatialForce<Formula>* formula) {
    return confirmed(entry(number, row), formula ? std::optional(entry(*formula, row)) : std::nullopt);
  };
  const auto at = [&](const std::vector<SpatialForce<double>>& list, const std::vector<SpatialForce<Formula>>* exact,
                      std::size_t i) { return pair(list[i], exact ? &(*exact)[i] : nullptr); };
  const auto signed_by = [](Shown coefficient, double sign) {
    if (sign < 0) {
      coefficient.number = -coefficient.number;
      if (coefficient.formula) coefficient.formula = -*coefficient.formula;
    }
    return coefficient;
  };
  Row terms;
  if (sudden()) terms.left.push_back({pair(numbers.before, formulas ? &formulas->before : nullptr)});
  for (std::size_t i = 0; i < numbers.unknown.size(); ++i)
    add_to(terms.left,
           {signed_by(at(numbers.unknown, formulas ? &formulas->unknown : nullptr, i), system.unknown[i].sign),
            system.unknown[i].tex, system.unknown[i].value, system.unknown[i].dimension});
  for (std::size_t i = 0; i < numbers.known.size(); ++i)
    terms.left.push_back({at(numbers.known, formulas ? &formulas->known : nullptr, i)});
  for (std::size_t i = 0; i < numbers.weights.size(); ++i)
    terms.left.push_back({at(numbers.weights, formulas ? &formulas->weights : nullptr, i)});
  for (std::size_t i = 0; i < numbers.motion.size(); ++i)
    terms.right.push_back({at(numbers.motion, formulas ? &formulas->motion : nullptr, i), system.open[i].tex,
                           system.open[i].value, system.open[i].dimension});
  terms.right.push_back({pair(numbers.rest, formulas ? &formulas->rest : nullptr)});
  return terms;
}

Dimension InstantExplainer::row_dimension(std::size_t row) const {
  return row < 3 ? (sudden() ? dimensions::momentum : dimensions::force)
                 : (sudden() ? dimensions::angular_momentum : dimensions::moment);
}

bool InstantExplainer::acts_in(const ShownTerm& term, std::size_t row) const {
  const Dimension dimension = row_dimension(row);
  const double size = term.symbol.empty() ? noise_size(dimension) : natural_coefficient()(dimension / term.dimension);
  return !is_rounding(term.coefficient.number, size);
}

bool InstantExplainer::moves_in_plane(const std::set<int>& bodies, std::size_t axis) const {
  const auto within = [&](const solve::MechanismState& state, int body) {
    const auto& motion = state.workspace().motion[static_cast<std::size_t>(body + 1)];
    const Vector3<double> v = motion.v + cross(motion.w, Vector3<double>(mass_of(state, body).center - motion.p));
    return is_rounding(v[axis], noise_size(dimensions::velocity)) &&
           is_rounding(norm(cross(motion.w, Vector3<double>::unit(axis))), noise_size(dimensions::angular_velocity));
  };
  return std::ranges::all_of(bodies, [&](int body) {
    if (!(mechanism().tree.body(body).inertia.mass > 0)) return true;
    return within(figures_.numbers.now, body) && (!figures_.numbers.before || within(*figures_.numbers.before, body));
  });
}

InstantExplainer::Plane InstantExplainer::plane_of(const std::set<int>& bodies, const std::vector<Row>& rows) const {
  if (situation_.plane) return situation_.plane->normal();
  for (const std::size_t axis : {2, 1, 0}) {
    if (!moves_in_plane(bodies, axis)) continue;
    std::set<std::string> within, across;
    bool plane = true, anything = false;
    for (std::size_t row = 0; row < rows.size(); ++row) {
      const bool crosses = row < 3 ? row == axis : row - 3 != axis;
      for (const auto* side : {&rows[row].left, &rows[row].right})
        for (const ShownTerm& term : *side) {
          if (!acts_in(term, row)) continue;
          if (!crosses) {
            anything = true;
            if (!term.symbol.empty()) within.insert(term.symbol);
          } else if (term.symbol.empty() ||
                     (side == &rows[row].right && !is_rounding(term.value, noise_size(term.dimension)))) {
            plane = false;
          } else {
            // Forces that are open, and motions of which nothing is left.
            across.insert(term.symbol);
          }
        }
    }
    const bool apart = std::ranges::none_of(across, [&](const std::string& one) { return within.contains(one); });
    if (plane && anything && apart) return axis;
  }
  return std::nullopt;
}

std::set<std::string> InstantExplainer::symbols_across(const std::vector<Row>& rows, Plane plane) const {
  std::set<std::string> across;
  if (!plane) return across;
  for (std::size_t row = 0; row < rows.size(); ++row)
    for (const auto* side : {&rows[row].left, &rows[row].right})
      for (const ShownTerm& term : *side)
        if ((row < 3 ? row == *plane : row - 3 != *plane) && !term.symbol.empty() && acts_in(term, row))
          across.insert(term.symbol);
  return across;
}

// Of a particle moments about its place say nothing.
bool InstantExplainer::is_particle_at_held_point(const BalancePlan& plan) const {
  std::vector<int> massive;
  for (const int body : plan.bodies)
    if (mechanism().tree.body(body).inertia.mass > 0) massive.push_back(body);
  if (massive.size() != 1 || !is_particle(massive.front())) return false;
  const std::optional<ExplainedPoint> held = best_point(plan);
  const Vector3<double> center = mass_of(figures_.numbers.now, massive.front()).center;
  return held && norm(Vector3<double>(held->position.number - center)) <= 1e-9 * solved_.scales().length;
}

// If forces meet at the reference point and are not asked for, no equations of forces are needed.
InstantExplainer::Meeting InstantExplainer::meeting(const System& system, const MotionBalance<double>& numbers,
                                                    bool held) const {
  Meeting found;
  bool asked = false;
  for (std::size_t i = 0; i < numbers.unknown.size(); ++i) {
    found.meets.push_back(held && norm(numbers.unknown[i].force) > 0 &&
                          norm(numbers.unknown[i].moment) <= 1e-9 * solved_.scales().length);
    if (!found.meets.back()) continue;
    found.symbols.push_back(system.unknown[i].tex);
    asked = asked || is_asked(system.plan.unknown[i]);
  }
  found.moments_only = !asked && !found.symbols.empty() && !is_particle_at_held_point(system.plan);
  for (std::size_t row = 0; row < 3 && found.moments_only; ++row) {
    bool needed = std::abs(numbers.rest.force[row] - numbers.before.force[row]) > noise_size(dimensions::force);
    bool in_met = false;
    // A force that is the only one to say how fast something is accelerated is needed, too.
    for (std::size_t i = 0; i < numbers.motion.size(); ++i) {
      const bool turning = solve::coordinate_turns(mechanism().tree, static_cast<int>(system.plan.open[i]));
      const double size = solved_.scales().mass * (turning ? solved_.scales().length : 1);
      needed = needed || std::abs(numbers.motion[i].force[row]) > 1e-9 * size;
    }
    for (std::size_t i = 0; i < numbers.unknown.size(); ++i) {
      if (std::abs(numbers.unknown[i].force[row]) <= 1e-9) continue;
      needed = true;
      in_met = in_met || found.meets[i];
    }
    found.moments_only = !needed || in_met;
  }
  return found;
}

// What moves may be much smaller than the machine: a spring that is held far away counts for the length of this, and
// not for what rounding is beside.
double InstantExplainer::part_of_length() const {
  std::vector<Vector3<double>> places;
  double around = 0;
  for (const int body : bodies_with_mass()) {
    const MassProperties<double> mass = mass_of(figures_.numbers.now, body);
    const SymmetricMatrix3<double>& I = mass.inertia_center;
    places.push_back(mass.center);
    around = std::max(around, std::sqrt(std::max(0.0, I.xx + I.yy + I.zz) / mass.mass));
  }
  for (const Component<double>& component : mechanism().components)
    places.push_back(figures_.numbers.now.position(component.at));
  for (const Vector3<double>& place : places) around = std::max(around, norm(Vector3<double>(place - places.front())));
  constexpr double least = 1e-4;  // places themselves are rounded as parts of the machine's length
  const double part = around / solved_.scales().length;
  return part > 0 && part < 1 ? std::max(part, least) : 1;
}

double InstantExplainer::natural_size(const Dimension& dimension) const {
  constexpr double twelfths = 12;
  return solved_.natural_size(dimension) * std::pow(part_of_length_, dimension.length / twelfths);
}

}  // namespace poinsot::problem
