#include "problem/claims/claim_ground.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "problem/claims/claim_letters.h"
#include "problem/formulas/formula_answers.h"
#include "problem/instant/contact_state_search.h"
#include "problem/language/diagnostic.h"
#include "problem/language/expression_walk.h"
#include "problem/witness/particle_witness.h"

namespace poinsot::problem {

bool is_in_its_states(const Situation& situation, const Settings& settings, SolvedInstant& instant) {
  if (!situation.has_friction()) return true;
  instant.solve_forces();
  return instant.one_sided_faults().empty() && leaves_limits(situation, settings);
}

ClaimGround::ClaimGround(const Situation& situation, const Settings& settings, const FormulaValues& exact,
                         const FormulaValues& unknowns)
    : situation_(situation), settings_(settings), exact_(exact), unknowns_(unknowns) {
  for (const Letter& letter : situation.letters)
    if (!settings.contains(letter.name)) letters_.push_back(letter);
  std::vector<std::pair<double, Dimension>> data;
  for (const NamedExpression& datum : situation.given)
    if (const Number* number = datum.value.as<Number>())
      data.emplace_back(number->value * number->unit.factor, number->unit.dimension);
  sizes_ = drawn_sizes(data);
}

Settings ClaimGround::with_letters(const Point& point) const {
  Settings settings = settings_;
  for (const Letter& letter : situation_.letters)
    if (const auto value = point.find(letter.name); value != point.end())
      settings[letter.name] = Value<double>::of_number(value->second, letter.unit.dimension);
  for (const auto& [name, formula] : unknowns_) {
    Value<double>& value = settings[name];
    value = formula.is_vector() ? Value<double>::of_vector(Vector3<double>::zero(), formula.dimension)
                                : Value<double>::of_number(0, formula.dimension);
    for (std::size_t k = 0; k < (formula.is_vector() ? 3U : 1U); ++k) {
      double& number = formula.is_vector() ? value.vector[k] : value.number;
      number = value_at(formula.is_vector() ? formula.vector[k] : formula.number, point);
      if (!std::isfinite(number)) fail(situation_.file, {}, "the unknown '" + name + "' has no value there");
    }
  }
  return settings;
}

// Solves the situation at some point, where formulas then decide signs. If what is stated of forces holds at none, a
// point is taken at which at least positions and velocities have a solution; failing that, the situation is solved as
// a trial.
void ClaimGround::find_base() {
  if (base_) return;
  std::unique_ptr<SolvedInstant> possible;
  Point possible_point;
  const When when{0, situation_.has_blow()};
  for (int attempt = 0; attempt < most_solved_points && !base_; ++attempt) {
    base_point_ = draw_point(letters_, attempt, sizes_);
    std::unique_ptr<SolvedInstant> found;
    try {
      // The instant refers to the settings and so needs them at a lasting address.
      bases_.push_back(with_letters(base_point_));
      if (neglects()) break;
      found = std::make_unique<SolvedInstant>(situation_, bases_.back(), when, OpenChoice{});
      if (states_forces(situation_)) found->solve_forces();
      if (!is_in_its_states(situation_, bases_.back(), *found)) continue;
      base_ = std::move(found);
    } catch (const StatementError&) {
      if (!found || possible) continue;
      possible = std::move(found);
      possible_point = base_point_;
    }
  }
  if (base_) return;
  if (possible) {
    base_ = std::move(possible);
    base_point_ = possible_point;
    return;
  }
  if (bases_.empty()) throw NoFormula("no letters were found at which the unknowns have values");
  OpenChoice choice;
  choice.trial = true;
  base_ = std::make_unique<SolvedInstant>(situation_, bases_.back(), when, choice);
}

ClaimFormulas* ClaimGround::formulas(bool all_poses) {
  Road& road = all_poses ? along_ : drawn_;
  if (road.tried) return road.formulas.get();
  road.tried = true;
  // An unknown that was found as a number has no formula, and neither has the claim. Where squares are neglected the
  // unknowns are found anew as formulas.
  const auto is_found_anew = [&](const std::string& name) {
    return neglects() && std::any_of(situation_.find.begin(), situation_.find.end(),
                                     [&](const Unknown& unknown) { return unknown.name == name; });
  };
  if (std::any_of(settings_.begin(), settings_.end(), [&](const auto& setting) {
        return !exact_.contains(setting.first) && !is_found_anew(setting.first);
      }))
    return nullptr;
  for (const Letter& letter : letters_) values_[letter.name] = formula_of(letter);
  for (const auto& [name, value] : unknowns_) values_[name] = value;
  for (const auto& [name, value] : exact_) values_[name] = value;
  find_base();
  for (const Unknown& unknown : situation_.find) {
    if (!is_found_anew(unknown.name) || exact_.contains(unknown.name)) continue;
    if (unknown.vector) throw NoFormula("squares are neglected beside an unknown vector");
    values_[unknown.name] =
        Value<Formula>::of_number(Formula::letter(unknown.name, poinsot::Sign::real), unknown.unit.dimension);
    base_point_[unknown.name] = bases_.back().at(unknown.name).number;
  }
  const PlainPointScope decisions(base_point_);
  road.formulas = std::make_unique<ClaimFormulas>(situation_, values_, bases_.back(), *base_, all_poses);
  return road.formulas.get();
}

namespace {

// The instant of a point, and if there is a blow and something is asked before it, that before it.
class PointInstant {
 public:
  PointInstant(const Situation& situation, const Settings& settings, const MotionState& state, const OpenChoice& choice)
      : situation_(situation),
        settings_(settings),
        state_(state),
        choice_(choice),
        instant_(situation, settings, state, choice) {}

  bool is_in_its_states() { return problem::is_in_its_states(situation_, settings_, instant_); }
  void write_down_what_is_told() {
    writes_ = true;
    instant_.write_down_what_is_told();
  }
  Verdict verdict(const Claim& claim) {
    if (situation_.has_blow()) instant_.strike();
    const ClaimElsewhere elsewhere = [&](const At& at, const Mark&) {
      return (at.instant == "before" ? before() : instant_).raw(at.expression, claim.axes, nullptr);
    };
    Verdict verdict;
    for (const Expression& expression : claim.of)
      judge_numbers(verdict, situation_, instant_, elsewhere, expression, claim.axes);
    return verdict;
  }
  double misfit() const { return std::max(misfit_by_particles(instant_), before_ ? misfit_by_particles(*before_) : 0); }

 private:
  SolvedInstant& before() {
    if (!before_) {
      before_.emplace(situation_, settings_, state_, choice_);
      if (writes_) before_->write_down_what_is_told();
    }
    return *before_;
  }

  const Situation& situation_;
  const Settings& settings_;
  const MotionState& state_;
  const OpenChoice& choice_;
  SolvedInstant instant_;
  std::optional<SolvedInstant> before_;
  bool writes_ = false;
};

}  // namespace

MotionState ClaimGround::state_at(const ClaimFormulas& formulas, const Point& point) {
  MotionState state;
  if (point.contains("time")) state.time = point.at("time");
  for (const Formula& q : formulas.positions()) state.q.push_back(value_at(q, point));
  for (const Formula& v : formulas.velocities()) state.v.push_back(value_at(v, point));
  return state;
}

std::optional<Verdict> ClaimGround::verdict_at(const Claim& claim, const ClaimFormulas& formulas, const Point& point) {
  try {
    const Settings settings = with_letters(point);
    const MotionState state = state_at(formulas, point);
    OpenChoice choice;
    choice.trial = neglects();
    PointInstant instant(situation_, settings, state, choice);
    if (!instant.is_in_its_states()) return std::nullopt;
    const bool by_formulas = takes_derivatives(situation_, claim) || neglects();
    const Verdict verdict = by_formulas ? Verdict() : instant.verdict(claim);
    if (!verdict.holds && situation_.has_friction() && is_at_end_of_states(formulas, point)) return std::nullopt;
    return verdict;
  } catch (const StatementError& error) {
    faults_.note(error, point);
    return std::nullopt;
  }
}

// Whether contacts with friction come into other states with letters next to these. There a claim fails by the
// rounding to which a state holds.
bool ClaimGround::is_at_end_of_states(const ClaimFormulas& formulas, const Point& point) const {
  constexpr double beside = 1e-6;  // of each letter: a thousand times that rounding
  for (const auto& [name, value] : point)
    for (const double part : {1 - beside, 1 + beside}) {
      Point other = point;
      other[name] = part * value;
      const Settings settings = with_letters(other);
      const MotionState state = state_at(formulas, other);
      const OpenChoice choice;
      if (!PointInstant(situation_, settings, state, choice).is_in_its_states()) return true;
    }
  return false;
}

Confirmation ClaimGround::confirmed_at(const Claim& claim, const ClaimFormulas& formulas, const Point& point) {
  if (takes_derivatives(situation_, claim) || neglects()) return Confirmation::confirmed;
  try {
    const Settings settings = with_letters(point);
    const MotionState state = state_at(formulas, point);
    const OpenChoice choice;
    PointInstant instant(situation_, settings, state, choice);
    instant.write_down_what_is_told();
    instant.verdict(claim);
    // Letters that are far apart leave more than the tolerance; a wrong sign or a lost term is a whole.
    constexpr double wrong = 1e-3;
    const double misfit = instant.misfit();
    return misfit <= check_tolerance ? Confirmation::confirmed
           : misfit <= wrong         ? Confirmation::open
                                     : Confirmation::contradicted;
  } catch (const StatementError&) {
    return Confirmation::open;
  }
}

std::vector<std::string> assumed_holds(const Situation& situation, const Claim& claim) {
  std::vector<std::string> holds;
  std::set<std::string> functions;
  for (const Expression& expression : claim.of) collect_functions(expression, functions, true);
  const bool rests_on_them = std::any_of(claim.of.begin(), claim.of.end(), [&](const Expression& expression) {
    return asks_forces(situation, expression);
  });
  if (!rests_on_them || situation.has_blow() || functions.contains("touching") || functions.contains("taut"))
    return holds;
  for (const Contact& contact : situation.contacts) {
    const bool one_sided =
        !contact.carries || std::any_of(contact.carries->begin(), contact.carries->end(), [](const Expression& e) {
          return e.as<Name>() && e.as<Name>()->name == "push";
        });
    if (one_sided) holds.push_back(holding_words(contact.name, Holding::presses));
  }
  for (const Cord& cord : situation.cords) holds.push_back(holding_words(cord.name, Holding::pulls));
  return holds;
}

}  // namespace poinsot::problem
