// Further conditions on unknown motions: restitution, and the constraints of joints, cords and contacts.
#include <algorithm>
#include <cmath>

#include "problem/explanation/explanation_instant.h"
#include "problem/instant/sticking_margin.h"
#include "problem/language/words.h"
#include "problem/quantities/rough_contact.h"

namespace poinsot::problem {
namespace {

// Of the force that friction could take: a limit is found to some ten digits.
constexpr double about_to_slip = 1e-6;

// Several constraints may hold one coordinate.
void note_once(ExplainedSection& section, const std::string& text) {
  if (std::ranges::none_of(section.steps, [&](const ExplainedStep& step) { return step.text == text; }))
    section.steps.push_back({text, {}});
}

// An equation as people write it: its first term is positive.
void with_positive_lead(std::vector<ShownTerm>& left, Shown& right) {
  const auto lead = std::ranges::find_if(left, [](const ShownTerm& term) { return term.coefficient.number != 0; });
  if (lead == left.end() || lead->coefficient.number > 0) return;
  const auto reversed = [](Shown& value) {
    value.number = -value.number;
    if (value.formula) value.formula = -*value.formula;
  };
  for (ShownTerm& term : left) reversed(term.coefficient);
  reversed(right);
}

// The size of a vector with these components.
std::string size_of_sum(const std::vector<InstantExplainer::Symbol>& components) {
  if (components.empty()) return "0";
  if (components.size() == 1) return "\\left|" + components.front().tex + "\\right|";
  std::string sum;
  for (const InstantExplainer::Symbol& one : components) sum += (sum.empty() ? "" : " + ") + one.tex + "^{2}";
  return "\\sqrt{" + sum + "}";
}

}  // namespace

// What Coulomb's law says of the friction of an impact.
void InstantExplainer::friction_step(std::size_t i, ExplainedSection& here) {
  const solve::Impact& impact = figures_.numbers.blow.impacts[i];
  const std::string coefficient = "$\\mu = " + tex_.number(*impact.friction, dimensions::none) + "$";
  if (impact.per_push)
    here.steps.push_back({"At *" + impact.name + "* the points slip in one direction to the end of the blow, and the " +
                              "impulse of friction is $\\mu$ times that of the push, " + coefficient + ".",
                          {}});
  if (impact.given)
    here.steps.push_back({"The impulse of friction at *" + impact.name +
                              "* is summed along the blow by Coulomb's law with " + coefficient + ": $" +
                              tex_.with_unit(*impact.given, dimensions::momentum) + "$.",
                          {}});
}

// The law at its limit with what the equations have given for both sides: an equation for what is sought.
std::optional<std::string> InstantExplainer::law_in_letters(const std::vector<Symbol>& friction,
                                                            const std::string& coefficient, const Symbol& push) const {
  if (friction.size() != 1 || !friction.front().shown.formula || !push.shown.formula) return std::nullopt;
  const Formula& along = *friction.front().shown.formula;
  const std::optional<std::string> left = ExplanationTex::formula(friction.front().value < 0 ? -along : along),
                                   right = ExplanationTex::formula(*push.shown.formula);
  if (!left || !right) return std::nullopt;
  const bool several = push.shown.formula->terms() > 2;  // one above and one below the line is a product
  return *left + " = " + coefficient + (several ? "\\left(" + *right + "\\right)" : *right);
}

// By Coulomb's law the contacts stick whose friction the equations tell; what they leave open is shared so that they
// do. At a limit of sticking there is one share, and the law holds as an equality where something is about to slip:
// that alone is told of letters without value.
void InstantExplainer::sticking_step(const std::vector<Symbol>& unknowns) {
  if (sudden() || !figures_.numbers.forces) return;
  const bool known = !tex_.letters_open();
  const std::optional<StickingForces> sticking = sticking_forces(solved_);
  if (!sticking) return;
  const std::size_t first = solve::force_unknowns(mechanism()).accelerations;
  const auto force = [&](std::size_t column) {
    return symbol_of({UnknownForce::Kind::component, column - first, column, 1});
  };
  double size = 0;
  for (const FrictionCone& cone : sticking->cones) size = std::max(size, std::abs(force(cone.push).value));
  std::vector<std::string> idle, slipping;
  std::vector<ExplainedEquation> shares, laws, at_limit;
  bool open = false;
  for (const FrictionCone& cone : sticking->cones) {
    const Symbol push = force(cone.push);
    // What is not cut free tells nothing here.
    if (std::ranges::find(unknowns, push.tex, &Symbol::tex) == unknowns.end()) continue;
    std::vector<Symbol> friction{force(cone.first)};
    if (cone.second) friction.push_back(force(*cone.second));
    const auto action = static_cast<std::size_t>(mechanism().components[cone.push - first].action);
    const std::string name = "*" + mechanism().actions[action].name + "*";
    std::erase_if(friction, [&](const Symbol& one) {
      return across_.contains(one.tex) || is_rounding(one.value, noise_size(dimensions::force));
    });
    open = open || !push.determined || std::ranges::any_of(friction, [](const Symbol& one) { return !one.determined; });
    shares.push_back(tex_.equation(push.tex, known_number(push.value), dimensions::force));
    for (const Symbol& one : friction)
      shares.push_back(tex_.equation(one.tex, known_number(one.value), dimensions::force));
    if (!(push.value > about_to_slip * size)) {
      idle.push_back(name);
      continue;
    }
    double amount = 0;
    for (const Symbol& one : friction) amount = std::hypot(amount, one.value);
    const std::string left = size_of_sum(friction);
    const double limit = cone.coefficient * push.value;
    const auto& rough = figures_.numbers.machine->rough_contacts;
    const auto contact = std::ranges::find(rough, static_cast<int>(action), &RoughContactOf<double>::action);
    const std::string coefficient =
        (contact == rough.end() ? tex_.number(cone.coefficient, dimensions::none)
                                : coefficient_in_tex(static_cast<std::size_t>(contact - rough.begin()))) +
        "\\,";
    const auto in_newtons = [&](double value) { return tex_.with_unit(value, dimensions::force); };
    if (amount > (1 - about_to_slip) * limit && !known) {
      slipping.push_back(name);
      at_limit.push_back({"", left + " = " + coefficient + push.tex, {}, 0});
      if (const std::optional<std::string> law = law_in_letters(friction, coefficient, push))
        at_limit.push_back({"", *law, {}, 0});
    } else if (amount > (1 - about_to_slip) * limit) {
      slipping.push_back(name);
      at_limit.push_back(
          {"", left + " = " + coefficient + push.tex + " = " + in_newtons(limit), {amount, limit, limit}, limit});
    } else {
      laws.push_back({"",
                      left + (friction.empty() ? "" : " = " + in_newtons(amount)) + " < " + coefficient + push.tex +
                          " = " + in_newtons(limit),
                      {},
                      0});
    }
  }
  ExplainedSection& here = section("Friction");
  const auto all_names = [&](const std::vector<std::string>& names, const char* one, const char* many) {
    return listed(names) + (names.size() > 1 ? many : one);
  };
  if (!at_limit.empty())
    here.steps.push_back(
        {all_names(slipping, " is", " are") + " about to slip, where Coulomb's law holds as an equality:", at_limit});
  if (!known) return;
  if (!idle.empty()) here.steps.push_back({all_names(idle, " carries", " carry") + " nothing.", {}});
  if (open)
    here.steps.push_back({at_limit.empty() && idle.empty()
                              ? "How the contacts share the load is left open; one way in which all of them stick is"
                              : "With this the forces are",
                          shares});
  if (!laws.empty())
    here.steps.push_back({"By Coulomb's law a contact sticks whose friction is less than it can be:", laws});
}

// The coefficient of friction that counts in the state of a contact.
std::string InstantExplainer::coefficient_in_tex(std::size_t contact) const {
  const auto& rough = figures_.numbers.machine->rough_contacts[contact];
  const Friction& stated = *std::ranges::find(situation_.contacts, rough.name, &Contact::name)->friction;
  const bool holds = rough.grip == Grip::sticks;
  if (const Name* name = (holds ? stated.resting : stated.sliding).as<Name>())
    return ExplanationTex::symbol(name->name);
  return factor_in_tex(shown([&](const auto& figures) {
                         const auto& own = figures.machine->rough_contacts[contact];
                         return own.on_cord() ? (holds ? own.friction_at_rest : own.friction_in_slip)
                                              : (holds ? own.resting : own.sliding);
                       }),
                       dimensions::none);
}

// The tension of a straight part of a cord or belt, by the symbols of the unknowns.
std::string InstantExplainer::tension_in_tex(int action) const {
  const std::size_t first = solve::force_unknowns(mechanism()).accelerations;
  std::string sum;
  for (std::size_t k = 0; k < mechanism().components.size(); ++k) {
    const Component<double>& component = mechanism().components[k];
    if (component.action != action || !component.span) continue;
    const bool follows = component.follows >= 0;
    const double part = follows ? component.followed_part() : 1;
    const std::size_t own = follows ? static_cast<std::size_t>(component.follows) : k;
    const std::string symbol = symbol_of({UnknownForce::Kind::component, own, first + own, 1}).tex;
    if (component.offset != 0) ExplanationTex::add_term(sum, tex_.number(component.offset, dimensions::force), "");
    ExplanationTex::add_term(sum, part == 1 ? "" : part == -1 ? "-" : tex_.number(part, dimensions::none), symbol);
  }
  return sum;
}

// The larger tension is at most e^(mu beta) times the smaller one (engine/dynamics/capstan.h).
std::optional<ExplainedStep> InstantExplainer::law_of_cord(std::size_t contact) const {
  const auto& rough = figures_.numbers.machine->rough_contacts[contact];
  const double here = tension_of(figures_.numbers.now, figures_.numbers.unknowns, rough.action),
               behind = tension_of(figures_.numbers.now, figures_.numbers.unknowns, rough.behind);
  const std::optional<double> angle = angle_round(figures_.numbers.now, rough);
  if (!angle || !(std::min(here, behind) > 0)) return std::nullopt;
  const bool sticks = rough.grip == Grip::sticks;
  const double ratio = std::max(here, behind) / std::min(here, behind),
               most = std::exp((sticks ? rough.friction_at_rest : rough.friction_in_slip) * *angle);
  const bool at_limit = !sticks || ratio > (1 - about_to_slip) * most;
  const bool known = !tex_.letters_open();
  // How the tensions of letters compare is not known but where the cord slips.
  if (!known && !at_limit) return std::nullopt;
  const Contact& stated = *std::ranges::find(situation_.contacts, rough.name, &Contact::name);
  const std::string cord = words_of_cord(stated.of), place = " *" + stated.against + "*";
  ExplainedStep step{
      (sticks && at_limit ? "Where " + cord + " is about to slip on" + place
       : sticks           ? "As long as " + cord + " does not slip on" + place
                          : "Where " + cord + " slips on" + place) +
          ", round which it goes with the angle $\\beta$, the larger tension is " +
          (at_limit ? "$e^{\\mu\\beta}$ times the smaller one:" : "less than $e^{\\mu\\beta}$ times the smaller one:"),
      {}};
  const Shown beta =
      shown([&](const auto& figures) { return *angle_round(figures.now, figures.machine->rough_contacts[contact]); });
  if (tex_.can_show(beta)) step.equations.push_back(tex_.equation("\\beta", beta, dimensions::none));
  const auto larger = here >= behind ? rough.action : rough.behind,
             smaller = here >= behind ? rough.behind : rough.action;
  const std::string left = "\\frac{" + tension_in_tex(larger) + "}{" + tension_in_tex(smaller) + "}",
                    right = "e^{" + coefficient_in_tex(contact) + "\\,\\beta}";
  const auto number = [&](double value) { return tex_.number(value, dimensions::none); };
  if (!known)
    step.equations.push_back({"", left + " = " + right, {}, 0});
  else if (at_limit)
    step.equations.push_back({"", left + " = " + right + " = " + number(most), {ratio, most}, most});
  else
    step.equations.push_back({"", left + " = " + number(ratio) + " < " + right + " = " + number(most), {}, 0});
  return step;
}

// Of the friction of a joint that holds: at most what is stated, or the coefficient times what presses in it.
std::optional<ExplainedStep> InstantExplainer::law_of_joint(std::size_t contact,
                                                            const std::vector<Symbol>& unknowns) const {
  const auto& rough = figures_.numbers.machine->rough_contacts[contact];
  const bool sticks = rough.grip == Grip::sticks;
  const solve::ForceUnknowns order = solve::force_unknowns(mechanism());
  // While it moves a friction that is stated is no unknown.
  if (!sticks && rough.pressing.empty()) return std::nullopt;
  std::vector<Symbol> frictions;
  double amount = 0;
  for (const auto& way : rough.ways) {
    const auto effort = std::ranges::find(order.drive_of_effort, way.drive);
    if (effort == order.drive_of_effort.end() || (rough.ways.size() > 1 && way.arm != 1)) return std::nullopt;
    const auto place = static_cast<std::size_t>(effort - order.drive_of_effort.begin());
    const Symbol friction = symbol_of(
        {UnknownForce::Kind::effort, way.drive, order.accelerations + mechanism().components.size() + place, 1});
    if (std::ranges::find(unknowns, friction.tex, &Symbol::tex) == unknowns.end() || !friction.determined)
      return std::nullopt;
    amount = std::hypot(amount, friction.value);
    frictions.push_back(friction);
  }
  const double coefficient = sticks ? rough.resting : rough.sliding;
  const Dimension dimension = rough.turning ? dimensions::moment : dimensions::force;
  std::string sum;
  double pressed = rough.pressing.empty() ? 1 : 0;
  const std::vector<Vector3<double>> pressing = pressing_in(figures_.numbers.now, figures_.numbers.unknowns, rough);
  int terms = 0;
  for (std::size_t i = 0; i < pressing.size(); ++i) {
    const double lever = rough.pressing[i].lever, size = norm(pressing[i]);
    pressed += size;
    if (is_rounding(size, lever * noise_size(dimensions::force)) || !(lever > 0)) continue;
    const std::string force = tex_.number(size / lever, dimensions::force);
    sum += (terms++ > 0 ? " + " : "") +
           (rough.turning ? tex_.number(lever, dimensions::length) + "\\cdot " + force : force);
  }
  const double limit = coefficient * pressed;
  const bool at_limit = amount > (1 - about_to_slip) * limit;
  if (!(limit > 0)) return std::nullopt;
  const std::string name = "*" + rough.name + "*";
  ExplainedStep step{(!sticks    ? "While " + name + " moves its friction is "
                      : at_limit ? name + " is about to move, where its friction is as large as it can be, "
                                 : name + " holds, as its friction is less than it can be, ") +
                         (rough.pressing.empty() ? "as stated" : words_of_bearing(contact)) + ":",
                     {}};
  const std::string left = size_of_sum(frictions), value = tex_.with_unit(limit, dimension);
  if (tex_.letters_open()) {
    const std::string largest =
        tex_.value(shown([&](const auto& figures) {
                     const auto& own = figures.machine->rough_contacts[contact];
                     return (sticks ? own.resting : own.sliding) * rough_force(figures.now, figures.unknowns, own).push;
                   }),
                   dimension);
    if (!at_limit || largest.empty()) return std::nullopt;
    step.equations.push_back({"", left + " = " + largest, {}, 0});
    return step;
  }
  const std::string product = sum.empty() ? ""
                                          : tex_.number(coefficient, dimensions::none) +
                                                (terms > 1 ? "\\left(" + sum + "\\right)" : "\\cdot " + sum) + " = ";
  if (at_limit)
    step.equations.push_back({"", left + " = " + product + value, {amount, limit}, limit});
  else
    step.equations.push_back({"", left + " = " + tex_.with_unit(amount, dimension) + " < " + product + value, {}, 0});
  return step;
}

void InstantExplainer::law_steps(const std::vector<Symbol>& unknowns) {
  if (sudden() || !figures_.numbers.forces) return;
  const auto& rough = figures_.numbers.machine->rough_contacts;
  for (std::size_t k = 0; k < rough.size(); ++k) {
    if (rough[k].grip != Grip::sticks && rough[k].grip != Grip::slides) continue;
    std::optional<ExplainedStep> step;
    if (rough[k].on_cord())
      step = law_of_cord(k);
    else if (rough[k].in_joint())
      step = law_of_joint(k, unknowns);
    if (step) section("Friction").steps.push_back(std::move(*step));
  }
}

// Whether a coordinate of a free body leads out of a plane, such as that in which everything moves.
bool InstantExplainer::leads_across(std::size_t k, Plane plane) const {
  if (!plane) return false;
  for (int i = 0; i < mechanism().tree.body_count(); ++i) {
    const auto& body = mechanism().tree.body(i);
    const int at = static_cast<int>(k) - body.v;
    if (at < 0 || at >= velocity_size(body.joint)) continue;
    const bool across = static_cast<std::size_t>(at % 3) == *plane;
    return body.joint == JointType::free && across != solve::coordinate_turns(mechanism().tree, static_cast<int>(k));
  }
  return false;
}

// Shows restitution and the constraints between coordinates.
void InstantExplainer::extra_conditions(const std::vector<std::size_t>& open, std::vector<Symbol>& listed,
                                        ExplainedSection& here) {
  const InstantFigures<double>& numbers = figures_.numbers;
  std::vector<std::string> holding, held;  // what holds, and what does not begin to move
  const Dimension dimension = sudden() ? dimensions::velocity : dimensions::acceleration;
  const auto coordinate_terms = [&](const auto& coefficient) {
    std::vector<ShownTerm> terms;
    for (const std::size_t k : open) {
      const Shown factor = coefficient(k);
      if (is_rounding(factor.number, solved_.scales().length)) continue;
      const Symbol symbol = symbol_of_coordinate(k, sudden());
      if (!across_.contains(symbol.tex) &&
          std::none_of(listed.begin(), listed.end(), [&](const Symbol& known) { return known.tex == symbol.tex; }))
        listed.push_back(symbol);
      terms.push_back({factor, symbol.tex, symbol.value, symbol.dimension});
    }
    return terms;
  };
  for (std::size_t i = 0; sudden() && i < numbers.blow.impacts.size(); ++i) {
    if (numbers.blow.impacts[i].is_friction) {
      friction_step(i, here);
      if (!numbers.blow.impacts[i].leaves) continue;
    }
    const auto along = [&](const auto& figures, std::size_t k) {
      using Scalar = ScalarOf<decltype(figures)>;
      solve::MechanismStateOf<Scalar> state = *figures.before;
      std::vector<Scalar> one(figures.now.state().v.size(), Scalar(0));
      one[k] = Scalar(1);
      state.set_velocities(one);
      return approach_of(state, figures.blow.impacts[i]);
    };
    const std::vector<ShownTerm> left =
        coordinate_terms([&](std::size_t k) { return shown([&](const auto& figures) { return along(figures, k); }); });
    const Shown right = shown([&](const auto& figures) {
      const auto& impact = figures.blow.impacts[i];
      return impact.leaves ? *impact.leaves : -(impact.restitution * approach_of(*figures.before, impact));
    });
    const solve::Impact& impact = numbers.blow.impacts[i];
    const Shown restitution = shown([&](const auto& figures) { return figures.blow.impacts[i].restitution; });
    const std::string e = tex_.inline_value(restitution, dimensions::none);
    const bool without_rebound = restitution.formula ? restitution.formula->is_zero() : restitution.number == 0;
    ExplainedStep step{
        impact.is_friction ? "The slip at *" + impact.name + "* has vanished after the blow:"
        : impact.leaves    ? "Followed along the blow with friction, with the restitution " + e + ", the points at *" +
                              impact.name + "* part along the push with:"
        : without_rebound
            ? "At *" + impact.name + "* the points do not part along the push, as the restitution is zero:"
            : "At *" + impact.name + "* the points part along the push with " + e + " times the speed of approach:",
        tex_.balance("", left, {{right}}, dimension, 1e-9 * solved_.scales().length, natural_coefficient())};
    here.steps.push_back(std::move(step));
  }
  for (std::size_t i = 0; i < mechanism().constraints.size(); ++i) {
    const VelocityConstraint<double>& constraint = mechanism().constraints[i];
    if (sudden() && constraint.action >= 0 && !solved_.blow_acting().empty() &&
        !solved_.blow_acting()[static_cast<std::size_t>(constraint.action)])
      continue;
    // With accelerations at zero, the bias is the part that depends on the velocities.
    const auto row = [&](const auto& figures) {
      using Scalar = ScalarOf<decltype(figures)>;
      solve::MechanismStateOf<Scalar> state = figures.now;
      state.set_accelerations(std::vector<Scalar>(figures.now.accelerations().size(), Scalar(0)));
      return solve::constraint_row(state, figures.mechanism().constraints[i]);
    };
    std::vector<ShownTerm> left = coordinate_terms(
        [&](std::size_t k) { return shown([&](const auto& figures) { return row(figures).coefficients[k]; }); });
    if (left.empty()) {
      if (constraint.action < 0) continue;
      const std::vector<std::size_t> blocked = sudden() ? std::vector<std::size_t>{} : blocked_coordinates();
      const std::vector<double> numbers_row = row(numbers).coefficients;
      for (const std::size_t k : blocked) {
        if (is_rounding(numbers_row[k], solved_.scales().length) || leaves_plane(k)) continue;
        add_once(holding, "*" + mechanism().actions[static_cast<std::size_t>(constraint.action)].name + "*");
        add_once(held, "$" + symbol_of_coordinate(k, false).tex + " = 0$");
      }
      continue;
    }
    // What holds across the plane of the motion says nothing of what moves in it.
    if (std::ranges::all_of(left, [&](const ShownTerm& term) { return across_.contains(term.symbol); })) continue;
    // The terms of coordinates with given motion go to the right side.
    Shown right = shown([&](const auto& figures) {
      using Scalar = ScalarOf<decltype(figures)>;
      const auto all = row(figures);
      Scalar rest = sudden() ? Scalar(0) : all.bias;
      const std::vector<Scalar>& values = sudden() ? figures.now.state().v : figures.now.accelerations();
      for (std::size_t k = 0; k < values.size(); ++k)
        if (std::find(open.begin(), open.end(), k) == open.end()) rest += all.coefficients[k] * values[k];
      return -rest;
    });
    right = clean(right, dimension);
    std::string words = constraint.words;
    words = with_emphasis(std::move(words));
    // A direction in numbers is that of the letters that were drawn: then only what holds is named.
    if (tex_.letters_open() && constraint.action >= 0 && words.back() == ']')
      words = "*" + mechanism().actions[static_cast<std::size_t>(constraint.action)].name + "*";
    with_positive_lead(left, right);
    ExplainedStep step{words + ":", tex_.balance("", left, {{right}}, dimension, 1e-9 * solved_.scales().length,
                                                 natural_coefficient())};
    if (step.equations.empty()) continue;
    note_once(here, std::string("What holds the bodies says of their ") +
                        (sudden() ? "velocities after the blow:" : "accelerations:"));
    here.steps.push_back(std::move(step));
  }
  if (!held.empty())
    here.steps.push_back({"Held by " + poinsot::problem::listed(holding) +
                              ", nothing begins to move there: " + poinsot::problem::listed(held) + ".",
                          {}});
}

// Shows what joints, cords and contacts beyond the tree of joints require of velocities that are not stated.
void InstantExplainer::velocity_conditions() {
  if (followed_) return;
  if (situation_.steady || sudden() || mechanism().constraints.empty() || solved_.velocities().value.empty()) return;
  // Where everything rests, nothing is to be found of velocities.
  if (std::ranges::all_of(figures_.numbers.now.state().v, [](double one) { return one == 0; })) return;
  const auto& rates = figures_.numbers.machine->rates;
  const auto stated = [&](std::size_t k) {
    return std::any_of(rates.begin(), rates.end(),
                       [&](const StatedRate& rate) { return static_cast<std::size_t>(rate.velocity) == k; });
  };
  const auto count = static_cast<std::size_t>(mechanism().tree.velocity_size());
  std::vector<Symbol> listed;
  std::vector<ExplainedStep> steps;
  for (std::size_t i = 0; i < mechanism().constraints.size(); ++i) {
    const auto row = [&](const auto& figures) {
      return solve::constraint_row(figures.now, figures.mechanism().constraints[i]).coefficients;
    };
    const std::vector<double> numbers = row(figures_.numbers);
    std::vector<ShownTerm> left;
    for (std::size_t k = 0; k < count; ++k) {
      if (stated(k) || is_rounding(numbers[k], solved_.scales().length)) continue;
      const Symbol symbol = symbol_of_coordinate(k, true);
      left.push_back(
          {shown([&](const auto& figures) { return row(figures)[k]; }), symbol.tex, symbol.value, symbol.dimension});
      if (std::none_of(listed.begin(), listed.end(), [&](const Symbol& known) { return known.tex == symbol.tex; }))
        listed.push_back(symbol);
    }
    Shown right = shown([&](const auto& figures) {
      using Scalar = ScalarOf<decltype(figures)>;
      Scalar rest(0);
      for (std::size_t k = 0; k < count; ++k)
        if (stated(k)) rest += row(figures)[k] * figures.now.state().v[k];
      return -rest;
    });
    if (left.size() < 2 && is_rounding(right.number, noise_size(dimensions::velocity))) continue;
    std::string words = mechanism().constraints[i].words;
    words = with_emphasis(std::move(words));
    with_positive_lead(left, right);
    ExplainedStep step{words + ":", tex_.balance("", left, {{right}}, dimensions::velocity,
                                                 noise_size(dimensions::velocity), natural_coefficient())};
    if (!step.equations.empty()) steps.push_back(std::move(step));
  }
  if (steps.empty()) return;
  ExplainedSection& here = section("Velocities");
  here.steps.push_back({"What holds the bodies, beyond their joints, says of the velocities:", {}});
  for (ExplainedStep& step : steps) here.steps.push_back(std::move(step));
  ExplainedStep found{"With what is known, this gives", {}};
  for (const Symbol& symbol : listed)
    if (symbol.determined && tex_.can_show(symbol.shown))
      found.equations.push_back(tex_.equation(symbol.tex, symbol.shown, symbol.dimension));
  if (!found.equations.empty()) here.steps.push_back(std::move(found));
}

}  // namespace poinsot::problem
