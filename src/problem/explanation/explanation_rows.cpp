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

bool is_plain_number(const std::string& side) { return side.find_first_not_of("0123456789.-+ ") == std::string::npos; }

// The terms of the left side that have symbols, and what all numbers come to on the right; nothing for the latter if
// the sides do not both have numbers, or none has a symbol.
std::pair<std::vector<ShownTerm>, std::optional<ShownTerm>> without_numbers(const std::vector<ShownTerm>& left,
                                                                            const std::vector<ShownTerm>& right) {
  std::vector<ShownTerm> unknown;
  double left_number = 0, right_number = 0;
  for (const ShownTerm& term : left) {
    if (term.symbol.empty())
      left_number += term.coefficient.number * term.value;
    else if (!term.coefficient.formula || !term.coefficient.formula->is_zero())
      unknown.push_back(term);
  }
  for (const ShownTerm& term : right) {
    if (!term.symbol.empty()) return {left, std::nullopt};
    right_number += term.coefficient.number * term.value;
  }
  if (unknown.empty() || left_number == 0 || right_number == 0) return {left, std::nullopt};
  return {unknown, ShownTerm{{right_number - left_number, std::nullopt}}};
}

}  // namespace

std::vector<ExplainedEquation> ExplanationTex::balance(const std::string& name, const std::vector<ShownTerm>& left,
                                                       const std::vector<ShownTerm>& right, const Dimension& dimension,
                                                       double natural,
                                                       const NaturalCoefficient& natural_coefficient) const {
  std::vector<ExplainedEquation> equations;
  double left_sum = 0, right_sum = 0, size = 0;
  std::string left_numbers = side_in_numbers(left, dimension, natural, natural_coefficient, left_sum, size);
  std::string right_numbers = side_in_numbers(right, dimension, natural, natural_coefficient, right_sum, size);
  if (left_numbers == "0" && right_numbers == "0") return {};
  const auto has_letters = [&](const std::vector<ShownTerm>& terms) {
    return std::any_of(terms.begin(), terms.end(), [](const ShownTerm& term) {
      return term.coefficient.formula && !term.coefficient.formula->letters().empty();
    });
  };
  std::string tex, left_shown;
  if (has_letters(left) || has_letters(right)) {
    const auto left_symbols = side_in_symbols(left, dimension), right_symbols = side_in_symbols(right, dimension);
    const std::size_t longest = letters_open() ? 8 * longest_alone : 2 * longest_line;
    if (left_symbols && right_symbols && left_symbols->size() + right_symbols->size() <= longest) {
      left_shown = *left_symbols;
      tex = *left_symbols + " = " + *right_symbols;
    }
  }
  const auto known = [&](const std::vector<ShownTerm>& terms) {
    return std::all_of(terms.begin(), terms.end(), [&](const ShownTerm& term) { return is_known(term.coefficient); });
  };
  const auto sought = [&](const std::vector<ShownTerm>& terms) {
    return std::ranges::any_of(terms, [&](const ShownTerm& term) { return is_sought(term.coefficient); });
  };
  const bool numbers = known(left) && known(right) && (tex.empty() || !(sought(left) || sought(right)));
  if (numbers && !tex.empty() && left_shown != left_numbers) {
    // Where symbols are shown with the forces on the left and the momenta on the right, the numbers below them stand on
    // one side.
    const auto [unknown, constant] = without_numbers(left, right);
    if (constant) {
      left_sum = right_sum = size = 0;
      left_numbers = side_in_numbers(unknown, dimension, natural, natural_coefficient, left_sum, size);
      right_numbers = side_in_numbers({*constant}, dimension, natural, natural_coefficient, right_sum, size);
    }
  }
  const bool alone = right_numbers == "0" && (left_numbers == "0" || !is_plain_number(left_numbers));
  const std::string right_end = alone ? right_numbers : right_numbers + unit_tex(dimension);
  if (numbers && !tex.empty() && left_shown == left_numbers) {
    // The left side reads the same in symbols and in numbers and is shown once.
    equations.push_back({name, tex + " = " + right_end, {left_sum, right_sum}, size, symbols_in(left, right)});
    return equations;
  }
  if (!tex.empty()) equations.push_back({name, tex, {}, size});
  // Two numbers say nothing that the symbols above them have not said.
  if (!tex.empty() && is_plain_number(left_numbers) && is_plain_number(right_numbers)) {
    if (numbers) equations.back().sides = {left_sum, right_sum};
    return equations;
  }
  if (numbers)
    equations.push_back({equations.empty() ? name : "",
                         left_numbers + " = " + right_end,
                         {left_sum, right_sum},
                         size,
                         symbols_in(left, right)});
  return equations;
}

InstantExplainer::Row InstantExplainer::row_of(const System& system, const MotionBalance<double>& numbers,
                                               const std::optional<MotionBalance<Formula>>& formulas,
                                               std::size_t row) const {
  const auto pair = [&](const SpatialForce<double>& number, const SpatialForce<Formula>* formula) {
    // What is nothing in letters is rounding in numbers.
    if (formula && entry(*formula, row).is_zero() && is_rounding(entry(number, row), noise_size(row_dimension(row))))
      return Shown{0, Formula(0)};
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
  const auto has_mass = [&](int body) { return mechanism().tree.body(body).inertia.mass > 0; };
  // What has no mass counts where nothing else is there.
  const bool massless = std::ranges::none_of(bodies, has_mass);
  const auto within = [&](const solve::MechanismState& state, int body) {
    const auto& motion = state.workspace().motion[static_cast<std::size_t>(body + 1)];
    Vector3<double> v = motion.v;
    if (has_mass(body)) v += cross(motion.w, Vector3<double>(mass_of(state, body).center - motion.p));
    return is_rounding(v[axis], noise_size(dimensions::velocity)) &&
           is_rounding(norm(cross(motion.w, Vector3<double>::unit(axis))), noise_size(dimensions::angular_velocity));
  };
  return std::ranges::all_of(bodies, [&](int body) {
    if (!has_mass(body) && !massless) return true;
    return within(figures_.numbers.now, body) && (!figures_.numbers.before || within(*figures_.numbers.before, body));
  });
}

bool InstantExplainer::moves(const std::set<int>& bodies) const {
  const auto within = [&](const solve::MechanismState& state, int body) {
    const auto& motion = state.workspace().motion[static_cast<std::size_t>(body + 1)];
    const Vector3<double> v = motion.v + cross(motion.w, Vector3<double>(mass_of(state, body).center - motion.p));
    return !is_rounding(norm(v), noise_size(dimensions::velocity)) ||
           !is_rounding(norm(motion.w), noise_size(dimensions::angular_velocity));
  };
  return std::ranges::any_of(bodies, [&](int body) {
    return within(figures_.numbers.now, body) || (figures_.numbers.before && within(*figures_.numbers.before, body));
  });
}

InstantExplainer::Plane InstantExplainer::plane_of(const System& system, const std::vector<Row>& rows) const {
  if (situation_.plane) return situation_.plane->normal();
  // What another body, or how it moves, is found to exert across a plane is more than open.
  const auto exerts = [&](const std::string& symbol) {
    return std::ranges::any_of(system.unknown, [&](const Symbol& one) {
      return one.tex == symbol && one.determined && !is_rounding(one.value, noise_size(one.dimension));
    });
  };
  for (const std::size_t axis : {2, 1, 0}) {
    if (!moves_in_plane(system.plan.bodies, axis)) continue;
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
          } else if (term.symbol.empty() || exerts(term.symbol) ||
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
