// Both sides of the equations of motion (Eqs. 18.1, 18.2) or of a blow (Eq. 17.4): the external forces on bodies, and
// the change of their momenta, component by component, solved for the unknowns.
#include <algorithm>
#include <cmath>

#include "problem/explanation/explanation_instant.h"
#include "problem/explanation/explanation_unknowns.h"
#include "problem/language/expression_walk.h"
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

// What a row without symbols says of the data in letters: it vanishes.
std::optional<Formula> condition_of(const std::vector<ShownTerm>& left, const std::vector<ShownTerm>& right) {
  try {
    Formula sum(0);
    for (const auto* side : {&left, &right})
      for (const ShownTerm& term : *side) {
        if (!term.coefficient.formula) return std::nullopt;
        if (!term.symbol.empty() && !term.coefficient.formula->is_zero()) return std::nullopt;
        if (term.symbol.empty()) sum += side == &left ? *term.coefficient.formula : -*term.coefficient.formula;
      }
    return sum.is_zero() ? std::nullopt : std::optional(sum);
  } catch (const FormulaTooLarge&) {
    return std::nullopt;
  }
}

// Whether all forces act at a place, told from the point about which moments are taken, and no couples with them.
bool all_act_at(const Vector3<double>& arm, const MotionBalance<double>& balance, double length) {
  constexpr double exact = 1e-9;
  const auto acts_there = [&](const SpatialForce<double>& one) {
    const Vector3<double> apart = one.moment - cross(arm, one.force);
    return norm(apart) <= exact * (norm(one.moment) + length * norm(one.force));
  };
  return std::ranges::all_of(balance.unknown, acts_there) && std::ranges::all_of(balance.known, acts_there);
}

}  // namespace

bool InstantExplainer::needs_balance() const {
  return sudden() ||
         (figures_.numbers.forces && (questions_.asks_forces() || (situation_.steady && !situation_.find.empty())));
}

// Whether data are to be found of which a momentum or an energy is stated.
bool InstantExplainer::states_momenta() const {
  if (situation_.find.empty()) return false;
  return std::ranges::any_of(situation_.instants, [](const Instant& instant) {
    return std::ranges::any_of(instant.facts, [](const Fact& fact) { return speaks_of_momentum(fact.quantity); });
  });
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

// The bodies on whose own axes velocities are told, where these are no longer those of the figure.
std::vector<std::string> InstantExplainer::turned_axes(const System& system) const {
  constexpr double noticeable = 1e-9;
  std::vector<std::string> names;
  for (const int body : system.plan.bodies) {
    const auto& own = mechanism().tree.body(body);
    const bool by_axes = velocity_size(own.joint) >= 3;
    const bool moves = std::ranges::any_of(system.plan.open, [&](std::size_t k) {
      return static_cast<int>(k) >= own.v && static_cast<int>(k) < own.v + velocity_size(own.joint);
    });
    const Matrix3<double>& R = figures_.numbers.now.workspace().motion[static_cast<std::size_t>(body + 1)].R;
    double off = 0;
    for (std::size_t k = 0; k < 3; ++k)
      off = std::max(off, norm(Vector3<double>(R * Vector3<double>::unit(k) - Vector3<double>::unit(k))));
    if (by_axes && moves && off > noticeable) names.push_back("*" + body_name(body) + "*");
  }
  return names;
}

// The point about which the rate of an angular momentum of these bodies is asked for; their mass center if it is there.
std::optional<ExplainedPoint> InstantExplainer::asked_point(const std::set<int>& bodies) {
  for (const MomentumQuestion& question : questions_.momenta) {
    if (!question.rate || !question.angular || !question.about) continue;
    if (question.body != whole_system && !bodies.contains(question.body)) continue;
    const ExplainedPoint point = point_of(*question.about);
    if (question.body == whole_system) return point;
    const ExplainedPoint G = mass_center(question.body);
    return norm(point.position.number - G.position.number) <= 1e-9 * solved_.scales().length ? G : point;
  }
  return std::nullopt;
}

void InstantExplainer::explain_system(const std::set<int>& bodies, bool only, std::vector<Symbol>& symbols) {
  const System system = system_of(bodies);
  forces_unknown_ = forces_unknown_ || !system.unknown.empty();
  const std::vector<Symbol>& open = system.open;
  std::vector<int> massive;
  for (const int body : bodies)
    if (mechanism().tree.body(body).inertia.mass > 0) massive.push_back(body);
  // If rates of momenta are asked for and all accelerations are known, there is nothing to solve.
  const bool rates_only =
      !sudden() && !situation_.steady && questions_.forces.empty() && questions_.pushes.empty() && open.empty();
  std::optional<ExplainedPoint> held = rates_only ? asked_point(bodies) : std::nullopt;
  if (!held) held = best_point(system.plan);
  const ExplainedPoint point =
      held ? *held
      : massive.size() == 1
          ? mass_center(massive.front())
          : ExplainedPoint{
                "O", shown_vector([&](const auto& figures) { return Vector3<ScalarOf<decltype(figures)>>::zero(); })};
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
  std::vector<Row> rows;
  for (std::size_t row = 0; row < 6; ++row) rows.push_back(row_of(system, numbers, formulas, row));
  const Plane plane = plane_of(system, rows);
  const std::set<std::string> across = symbols_across(rows, plane);
  const Meeting meet = meeting(system, numbers, held.has_value());
  const std::string who = only ? "" : " of " + names_of(bodies);
  if (!sudden()) {
    section("Kinetic side");
    kinetic_steps("Kinetic side", system, point, meet.moments_only && !rates_only, plane);
  } else {
    for (const int body : massive) {
      const bool fixed = rests(body, point.position.number);
      inertia_step(section("Inertia"), body, fixed ? &point : nullptr, plane);
    }
  }
  if (rates_only) return;
  ExplainedSection& free_body = section(sudden() ? "Impulses" : "Free-body side");
  if (situation_.bodies.size() > 1)
    free_body.steps.push_back({"Take " + names_of(bodies) +
                                   (bodies.size() > 1 ? " as one: what they exert on each "
                                                        "other drops out."
                                                      : " by itself."),
                               {}});
  force_list(free_body, system, across);

  ExplainedSection& equations = section(sudden() ? "Impulse and momentum" : "Component equations");
  if (plane) {
    const auto all = bodies_with_mass();
    const bool everything = moves_in_plane({all.begin(), all.end()}, *plane);
    if (everything) everything_in_ = plane;
    const std::set<int> who_moves = everything ? std::set<int>(all.begin(), all.end()) : bodies;
    const std::string name = "$" + tex_.axis((*plane + 1) % 3) + tex_.axis((*plane + 2) % 3) + "$ plane";
    const std::string left = std::ranges::all_of(who_moves, [&](int body) { return is_particle(body); })
                                 ? ": of the three equations of a particle the two of the plane are left."
                                 : ": of the six equations those of the plane are left, two of forces and one of "
                                   "moments.";
    const bool several = !everything && bodies.size() > 1;
    const std::string subject = everything ? "Everything" : names_of(bodies);
    const bool starts = !sudden() && !std::ranges::all_of(who_moves, [&](int body) { return stays_at_rest(body); });
    const std::string at_rest = subject + (starts ? " start" : " rest") + (several ? "" : "s") +
                                (starts ? " from rest" : "") + ", and nothing is known to act across the " + name +
                                left,
                      moving = subject + (several ? " move" : " moves") + " in the " + name +
                               ", and nothing is known to act across it" + left;
    // For several bodies and instants it is said once.
    const bool said = std::ranges::any_of(explanation_.sections, [&](const ExplainedSection& one) {
      return std::ranges::any_of(
          one.steps, [&](const ExplainedStep& step) { return step.text == at_rest || step.text == moving; });
    });
    if (!said) equations.steps.push_back({moves(who_moves) ? moving : at_rest, {}});
  }
  if (const std::vector<std::string> turned = turned_axes(system); !turned.empty())
    equations.steps.push_back(
        {"Components of the velocities of " + listed(turned) + " and of their rates are on the axes of " +
             (turned.size() > 1 ? "each body, which have turned with it." : "the body, which have turned with it."),
         {}});
  std::vector<std::string> met;
  for (const std::string& symbol : meet.symbols)
    if (!across.contains(symbol)) met.push_back("$" + symbol + "$");
  // Moments of the forces on one particle say again what the forces do.
  const bool one_particle = massive.size() == 1 && bodies.size() == 1 && is_particle(massive.front()) &&
                            all_act_at(mass_center(massive.front()).position.number - point.position.number, numbers,
                                       solved_.scales().length);
  std::string text = sudden() ? "Momenta before plus impulses equal momenta after (Eq. 17.4)"
                              : "The forces from outside are equivalent to the kinetic side (Eqs. 18.1, 18.2)";
  text += who;
  if (meet.moments_only)
    text += ". About $" + point.label + "$" + where(point) + ", " + listed(met) + (met.size() > 1 ? " have" : " has") +
            " no moment:";
  else
    text += one_particle ? ":" : "; moments about $" + point.label + "$" + where(point) + ":";
  ExplainedStep step{text, {}};
  std::vector<std::string> vanishing;
  const auto natural_of = [&](const Dimension& dimension) { return noise_size(dimension); };
  const std::size_t rows_shown = one_particle && !meet.moments_only ? 3 : 6;
  for (std::size_t row = meet.moments_only ? 3 : 0; row < rows_shown; ++row) {
    if (plane && (row < 3 ? row == *plane : row - 3 != *plane)) continue;
    const auto& [left, right] = rows[row];
    const std::string& axis = tex_.axis(row % 3);
    const std::string name = sudden() ? (row < 3 ? axis + "\\text{ components}" : axis + "\\text{ moments}")
                                      : (row < 3 ? "\\Sigma F_{" + axis + "}" : "\\Sigma M_{" + axis + "}");
    const Dimension dimension = row_dimension(row);
    if (auto condition = situation_.find.empty() ? std::nullopt : condition_of(left, right))
      conditions_.push_back(std::move(*condition));
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
  // A coordinate that moves no mass, such as the turning of a thin rod about itself, stands in no row.
  const auto stands_in_rows = [&](const Symbol& symbol) {
    return std::ranges::any_of(rows, [&](const Row& one) {
      const auto row = static_cast<std::size_t>(&one - rows.data());
      return std::ranges::any_of(
          one.right, [&](const ShownTerm& term) { return term.symbol == symbol.tex && acts_in(term, row); });
    });
  };
  for (const Symbol& symbol : system.open)
    if (!across.contains(symbol.tex) && stands_in_rows(symbol)) list(symbol);
  across_.insert(across.begin(), across.end());
  for (std::size_t i = 0; i < system.unknown.size(); ++i)
    if ((!meet.moments_only || !meet.meets[i]) && !across.contains(system.unknown[i].tex)) list(system.unknown[i]);
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
  if (!found_along_motion()) {
    explain_found();
    tex_.hide_until_found({});
  }
  list_unknowns(symbols);
  sticking_step(symbols);
  law_steps(symbols);
  tex_.hide_until_found({});
}

// Whether what is stated of later instants fixes what is to be found, so that the equations of this one leave it open.
bool InstantExplainer::found_along_motion() const {
  return !situation_.find.empty() && std::ranges::any_of(situation_.instants, [&](const Instant& instant) {
    return is_later(situation_, instant) && !instant.facts.empty();
  });
}

// Those that have values, of a vector its components.
std::vector<FoundDatum> InstantExplainer::found_data() const {
  std::vector<FoundDatum> found;
  for (const Unknown& unknown : situation_.find) {
    const auto value = data_.settings().find(unknown.name);
    if (value == data_.settings().end()) continue;
    if (value->second.is_number()) found.push_back({unknown.name, unknown.unit.dimension, value->second.number});
    if (!value->second.is_vector()) continue;
    for (std::size_t k = 0; k < 3; ++k)
      if (const double component = value->second.vector[k]; component != 0)
        found.push_back({component_letter(situation_, unknown.name, k), unknown.unit.dimension, component});
  }
  return found;
}

// The data that are to be found: what the rows without unknown forces say of them, or what is left of that which is
// stated, once the forces are solved for.
void InstantExplainer::explain_found() {
  UnknownConditions stated{{}, found_data(), factors_, {}};
  if (stated.unknown.empty()) return;
  const auto speaks_of = [](const Formula& condition, const FoundDatum& datum) {
    const std::vector<std::string> letters = condition.letters();
    return std::ranges::find(letters, datum.name) != letters.end();
  };
  const auto take = [&](const std::vector<Formula>& from) {
    for (const Formula& one : from)
      if (std::ranges::any_of(stated.unknown, [&](const FoundDatum& datum) { return speaks_of(one, datum); }))
        stated.conditions.push_back(one);
  };
  take(conditions_);
  const bool by_rows = std::ranges::all_of(stated.unknown, [&](const FoundDatum& datum) {
    return std::ranges::any_of(stated.conditions, [&](const Formula& one) { return speaks_of(one, datum); });
  });
  if (!by_rows && formula_instant_) {
    stated.conditions.clear();
    if (!needs_balance()) {
      stated.from = stated.from_several = "What is known of the momenta gives";
    } else {
      const std::string solved =
          forces_unknown_ ? std::string("Once solved for the ") + (sudden() ? "impulses" : "forces") + ", there "
                          : "With what is known there ";
      const std::string known = forces_unknown_ ? " with what is known" : "";
      stated.from = solved + "remains" + known;
      stated.from_several = solved + "remain" + known;
    }
    take(formula_instant_->remainders());
  }
  if (formula_instant_)
    for (const FoundDatum& datum : stated.unknown)
      if (neglects(datum.name)) stated.first_order.push_back(datum.name);
  tex_.hide_until_found({});
  std::vector<ExplainedStep> steps = condition_steps(stated, letters_, tex_);
  ExplainedSection& here = section("Unknowns");
  std::set<std::string> said;
  choice_steps(stated.unknown, said, here);
  for (const ExplainedStep& step : steps)
    for (const FoundDatum& datum : stated.unknown)
      for (const ExplainedEquation& equation : step.equations)
        if (equation.tex.starts_with(ExplanationTex::symbol(datum.name) + " = ")) said.insert(datum.name);
  std::vector<std::string> conditions;
  for (const Instant& instant : situation_.instants)
    for (const Fact& fact : instant.facts)
      if (level_of(situation_, fact.quantity) == Level::force || sudden() ||
          (!needs_balance() && speaks_of_momentum(fact.quantity)))
        conditions.push_back("`" + to_string(fact.quantity) + " = " + to_string(fact.value) + "`");
  ExplainedStep found{(steps.empty() ? "Of the data to be found, the equations" : "The equations") +
                          (conditions.empty() ? std::string() : " with what is known, " + listed(conditions) + ",") +
                          " leave",
                      {}};
  for (const FoundDatum& datum : stated.unknown) {
    const Shown one = known_number(datum.value);
    if (!tex_.numbers_open() && !said.contains(datum.name))
      found.equations.push_back(tex_.equation(ExplanationTex::symbol(datum.name), one, datum.dimension));
  }
  if (!found.equations.empty()) steps.push_back(std::move(found));
  for (ExplainedStep& step : steps) here.steps.push_back(std::move(step));
}

// Which of the impulses act of which a number is chosen; what is to be found of the others vanishes.
void InstantExplainer::choice_steps(const std::vector<FoundDatum>& found, std::set<std::string>& said,
                                    ExplainedSection& here) {
  for (const Choice& choice : situation_.choose) {
    std::vector<std::string> all, acting, vanishing;
    for (const std::string& name : choice.of) {
      const auto impulse = std::ranges::find(situation_.impulses, name, &Impulse::name);
      if (impulse == situation_.impulses.end()) return;
      std::set<std::string> names;
      for (const auto* part : {&impulse->lasts, &impulse->value, &impulse->force, &impulse->couple})
        if (*part) collect_names(**part, names);
      bool idle = false;
      for (const FoundDatum& datum : found) {
        if (datum.value != 0 || !names.contains(datum.name)) continue;
        idle = true;
        said.insert(datum.name);
        vanishing.push_back("$" + ExplanationTex::symbol(datum.name) + " = 0$");
      }
      all.push_back("*" + name + "*");
      if (!idle) acting.push_back(all.back());
    }
    if (vanishing.empty() || acting.empty()) return;
    here.steps.push_back(
        {"*" + choice.name + "*: of " + listed(all) +
             (choice.least_total ? ", those act that meet what is known with the least sum: "
                                 : ", exactly " + std::to_string(choice.exactly) + " act. What is known is met with ") +
             listed(acting) + ", so that " + listed(vanishing) + ".",
         {}});
  }
}

// Whether squares of an unknown are neglected.
bool InstantExplainer::neglects(const std::string& unknown) const {
  return std::ranges::any_of(situation_.neglect, [&](const Expression& item) {
    std::set<std::string> names;
    collect_names(item, names);
    return names.contains(unknown);
  });
}

}  // namespace poinsot::problem
