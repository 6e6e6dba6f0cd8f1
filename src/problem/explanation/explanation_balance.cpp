// Both sides of the equations of motion (Eqs. 18.1, 18.2) or of a blow (Eq. 17.4): the external forces on bodies, and
// the change of their momenta, component by component, solved for the unknowns.
#include <algorithm>
#include <cmath>

#include "problem/explanation/explanation_instant.h"
#include "problem/language/words.h"

namespace poinsot::problem {
namespace {

// If the row says only that a single symbol is zero, this symbol.
std::optional<std::string> vanishing_symbol(const std::vector<ShownTerm>& left, const std::vector<ShownTerm>& right,
                                            const Dimension& dimension, double natural,
                                            const NaturalCoefficient& natural_coefficient) {
  std::optional<std::string> symbol;
  for (const auto* side : {&left, &right})
    for (const ShownTerm& term : *side) {
      const double size = term.symbol.empty() ? natural : natural_coefficient(dimension / term.dimension);
      if (is_rounding(term.coefficient.number, size)) continue;
      if (symbol || term.symbol.empty() || term.value != 0) return std::nullopt;
      symbol = term.symbol;
    }
  return symbol;
}

}  // namespace

bool InstantExplainer::needs_balance() const {
  return sudden() || (figures_.numbers.forces && (questions_.asks_forces() || situation_.steady));
}

std::vector<InstantExplainer::System> InstantExplainer::systems() const {
  std::vector<System> cut;
  if (!needs_balance()) return cut;
  for (const std::set<int>& bodies : choose_systems()) cut.push_back(system_of(bodies));
  return cut;
}

InstantExplainer::System InstantExplainer::system_of(const std::set<int>& bodies) const {
  System system;
  system.plan = plan_for(bodies);
  // Coordinates that do not move these bodies take no part.
  const MotionBalance<double> trial = balance_of(figures_.numbers, system.plan, Vector3<double>::zero());
  std::vector<std::size_t> open;
  for (std::size_t i = 0; i < system.plan.open.size(); ++i)
    if (norm(trial.motion[i].force) + norm(trial.motion[i].moment) > 0) open.push_back(system.plan.open[i]);
  system.plan.open = open;
  for (const UnknownForce& force : system.plan.unknown) system.unknown.push_back(symbol_of(force));
  for (const std::size_t k : open) system.open.push_back(symbol_of_coordinate(k, sudden()));
  return system;
}

void InstantExplainer::explain_system(const std::set<int>& bodies, bool only, std::vector<Symbol>& symbols) {
  const System system = system_of(bodies);
  const std::vector<Symbol>& open = system.open;
  std::vector<int> massive;
  for (const int body : bodies)
    if (mechanism().tree.body(body).inertia.mass > 0) massive.push_back(body);
  std::optional<ExplainedPoint> held = best_point(system.plan);
  const ExplainedPoint point =
      held ? *held
      : massive.size() == 1
          ? mass_center(massive.front())
          : ExplainedPoint{
                "O", shown_vector([&](const auto& figures) { return Vector3<ScalarOf<decltype(figures)>>::zero(); })};
  const std::string who = only ? "" : " of " + names_of(bodies);
  if (!sudden()) {
    section("Kinetic side");
    kinetic_steps("Kinetic side", system, point);
  } else {
    for (const int body : massive) {
      const bool fixed = rests(body, point.position.number);
      inertia_step(section("Inertia"), body, fixed ? &point : nullptr);
    }
  }
  // If rates of momenta are asked for and all accelerations are known, there is nothing to solve.
  if (!sudden() && !situation_.steady && questions_.forces.empty() && questions_.pushes.empty() && open.empty()) return;
  ExplainedSection& free_body = section(sudden() ? "Impulses" : "Free-body side");
  if (situation_.bodies.size() > 1)
    free_body.steps.push_back({"Take " + names_of(bodies) +
                                   (bodies.size() > 1 ? " as one: what they exert on each "
                                                        "other drops out."
                                                      : " by itself."),
                               {}});
  force_list(free_body, system);

  ExplainedSection& equations = section(sudden() ? "Impulse and momentum" : "Component equations");
  const MotionBalance<double> numbers = balance_of(figures_.numbers, system.plan, point.position.number);
  std::optional<MotionBalance<Formula>> formulas;
  if (figures_.formulas && point.position.formula) {
    try {
      formulas = balance_of(*figures_.formulas, system.plan, *point.position.formula);
    } catch (const std::domain_error&) {
      formulas.reset();
    } catch (const FormulaTooLarge&) {
      formulas.reset();
    }
  }
  // If forces meet at the reference point and are not asked for, no equations of forces are needed.
  std::vector<bool> meets;
  std::vector<std::string> met;
  bool asked = false;
  for (std::size_t i = 0; i < numbers.unknown.size(); ++i) {
    meets.push_back(held && norm(numbers.unknown[i].force) > 0 &&
                    norm(numbers.unknown[i].moment) <= 1e-9 * solved_.scales().length);
    if (!meets.back()) continue;
    met.push_back("$" + system.unknown[i].tex + "$");
    asked = asked || is_asked(system.plan.unknown[i]);
  }
  bool moments_only = !asked && !met.empty();
  for (std::size_t row = 0; row < 3 && moments_only; ++row) {
    bool needed = std::abs(numbers.rest.force[row] - numbers.before.force[row]) > noise_size(dimensions::force);
    bool in_met = false;
    for (std::size_t i = 0; i < numbers.unknown.size(); ++i) {
      if (std::abs(numbers.unknown[i].force[row]) <= 1e-9) continue;
      needed = true;
      in_met = in_met || meets[i];
    }
    moments_only = !needed || in_met;
  }
  std::string text = sudden() ? "Momenta before plus impulses equal momenta after (Eq. 17.4)"
                              : "The forces from outside are equivalent to the kinetic side (Eqs. 18.1, 18.2)";
  text += who;
  if (moments_only)
    text += ". About $" + point.label + "$, " + listed(met) + (met.size() > 1 ? " have" : " has") + " no moment:";
  else
    text += "; moments about $" + point.label + "$:";
  ExplainedStep step{text, {}};
  std::vector<std::string> vanishing;
  const auto natural_of = [&](const Dimension& dimension) { return noise_size(dimension); };
  const Dimension force_dimension = sudden() ? dimensions::momentum : dimensions::force;
  const Dimension moment_dimension = sudden() ? dimensions::angular_momentum : dimensions::moment;
  for (std::size_t row = moments_only ? 3 : 0; row < 6; ++row) {
    const auto pair = [&](const SpatialForce<double>& number, const SpatialForce<Formula>* formula) {
      return confirmed(entry(number, row), formula ? std::optional(entry(*formula, row)) : std::nullopt);
    };
    const auto at = [&](const std::vector<SpatialForce<double>>& list, const std::vector<SpatialForce<Formula>>* exact,
                        std::size_t i) { return pair(list[i], exact ? &(*exact)[i] : nullptr); };
    std::vector<ShownTerm> left, right;
    const auto signed_by = [](Shown coefficient, double sign) {
      if (sign < 0) {
        coefficient.number = -coefficient.number;
        if (coefficient.formula) coefficient.formula = -*coefficient.formula;
      }
      return coefficient;
    };
    if (sudden()) left.push_back({pair(numbers.before, formulas ? &formulas->before : nullptr)});
    for (std::size_t i = 0; i < numbers.unknown.size(); ++i)
      left.push_back(
          {signed_by(at(numbers.unknown, formulas ? &formulas->unknown : nullptr, i), system.unknown[i].sign),
           system.unknown[i].tex, system.unknown[i].value, system.unknown[i].dimension});
    for (std::size_t i = 0; i < numbers.known.size(); ++i)
      left.push_back({at(numbers.known, formulas ? &formulas->known : nullptr, i)});
    for (std::size_t i = 0; i < numbers.weights.size(); ++i)
      left.push_back({at(numbers.weights, formulas ? &formulas->weights : nullptr, i)});
    for (std::size_t i = 0; i < numbers.motion.size(); ++i)
      right.push_back({at(numbers.motion, formulas ? &formulas->motion : nullptr, i), system.open[i].tex,
                       system.open[i].value, system.open[i].dimension});
    right.push_back({pair(numbers.rest, formulas ? &formulas->rest : nullptr)});
    const std::string axis = tex_.axis(row % 3);
    const std::string name = sudden() ? (row < 3 ? axis + "\\text{ components}" : axis + "\\text{ moments}")
                                      : (row < 3 ? "\\Sigma F_{" + axis + "}" : "\\Sigma M_{" + axis + "}");
    const Dimension& dimension = row < 3 ? force_dimension : moment_dimension;
    if (const std::optional<std::string> alone =
            vanishing_symbol(left, right, dimension, natural_of(dimension), natural_coefficient())) {
      vanishing.push_back("$" + *alone + "$");
      continue;
    }
    for (ExplainedEquation& equation :
         tex_.balance(name, left, right, dimension, natural_of(dimension), natural_coefficient())) {
      if (!situation_.neglect.empty()) {
        // The sides differ by the neglected squares.
        equation.sides.clear();
        equation.symbols.clear();
      }
      step.equations.push_back(std::move(equation));
    }
  }
  if (!situation_.neglect.empty() && !step.equations.empty()) {
    std::vector<std::string> neglected;
    for (const Expression& item : situation_.neglect) neglected.push_back("`" + to_string(item) + "`");
    step.text.back() = ',';
    step.text += " up to " + listed(neglected) + ", which is neglected:";
  }
  if (!step.equations.empty()) equations.steps.push_back(std::move(step));
  if (!vanishing.empty())
    equations.steps.push_back(
        {"The other components only say that " + listed(vanishing) + (vanishing.size() > 1 ? " vanish." : " vanishes."),
         {}});
  const auto list = [&](const Symbol& symbol) {
    const bool known =
        std::any_of(symbols.begin(), symbols.end(), [&](const Symbol& one) { return one.tex == symbol.tex; });
    const bool said = std::find(vanishing.begin(), vanishing.end(), "$" + symbol.tex + "$") != vanishing.end();
    if (!known && !said) symbols.push_back(symbol);
  };
  for (const Symbol& symbol : system.open) list(symbol);
  for (std::size_t i = 0; i < system.unknown.size(); ++i)
    if (!moments_only || !meets[i]) list(system.unknown[i]);
}

void InstantExplainer::explain_balance() {
  const std::vector<std::set<int>> systems = choose_systems();
  std::vector<Symbol> symbols;
  section("Inertia");
  if (!sudden()) velocity_conditions();
  for (const std::set<int>& bodies : systems) explain_system(bodies, systems.size() == 1, symbols);
  std::vector<std::size_t> open;
  for (const std::size_t k : open_coordinates()) open.push_back(k);
  extra_conditions(open, symbols, section(sudden() ? "Impulse and momentum" : "Component equations"));
  list_unknowns(symbols);
  std::vector<std::string> conditions;
  for (const Instant& instant : situation_.instants)
    for (const Fact& fact : instant.facts)
      if (level_of(situation_, fact.quantity) == Level::force || sudden())
        conditions.push_back("`" + to_string(fact.quantity) + " = " + to_string(fact.value) + "`");
  ExplainedStep found{"Of the data to be found, the equations" +
                          (conditions.empty() ? std::string() : " with what is known, " + listed(conditions) + ",") +
                          " leave",
                      {}};
  for (const Unknown& unknown : situation_.find) {
    const auto value = data_.settings().find(unknown.name);
    if (value == data_.settings().end() || !value->second.is_number()) continue;
    const Shown one{value->second.number, std::nullopt};
    if (tex_.can_show(one))
      found.equations.push_back(tex_.equation(ExplanationTex::symbol(unknown.name), one, unknown.unit.dimension));
  }
  if (!found.equations.empty()) section("Unknowns").steps.push_back(std::move(found));
}

}  // namespace poinsot::problem
