// The symbols of unknowns, and the external forces in words.
#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "problem/explanation/explanation_instant.h"
#include "problem/instant/sticking_margin.h"
#include "problem/keys/joint_kinds.h"
#include "problem/language/words.h"

namespace poinsot::problem {

// The letter for the forces of an action: the point at which it holds, if it has one, otherwise its name.
std::string InstantExplainer::action_symbol(const Action& action) const {
  for (const Joint& joint : situation_.joints) {
    if (action.kind != ActionKind::joint || joint.name != action.name) continue;
    const Name* place = joint.kind->given == JointGiven::point ? joint.place.as<Name>() : nullptr;
    if (joint.at) place = joint.at->as<Name>();
    if (!place) break;
    const auto same_letter = [&](const Action& other) { return &other != &action && other.name == place->name; };
    if (std::none_of(mechanism().actions.begin(), mechanism().actions.end(), same_letter) &&
        std::count_if(situation_.joints.begin(), situation_.joints.end(), [&](const Joint& other) {
          const Name* one = other.at ? other.at->as<Name>() : other.place.as<Name>();
          return one && one->name == place->name;
        }) == 1)
      return place->name;
  }
  return action.name;
}

std::pair<std::string, double> InstantExplainer::named_direction(const Vector3<double>& along) const {
  constexpr double same = 1e-9;
  for (const NamedExpression& direction : situation_.directions) {
    try {
      DataScope<double> data(situation_, data_.settings());
      const double cosine = dot(data.direction(direction.value), along);
      if (std::abs(std::abs(cosine) - 1) < same) return {direction.name, cosine < 0 ? -1 : 1};
    } catch (const StatementError&) {
      // One without a value is not the one sought.
    }
  }
  return {};
}

InstantExplainer::Symbol InstantExplainer::symbol_of(const UnknownForce& force) const {
  const InstantFigures<double>& numbers = figures_.numbers;
  Symbol symbol;
  bool couple = false;
  if (force.kind == UnknownForce::Kind::component) {
    const Component<double>& component = mechanism().components[force.index];
    const Action& action = mechanism().actions[static_cast<std::size_t>(component.action)];
    couple = component.couple;
    const std::string letter = action_symbol(action);
    if (action.kind == ActionKind::cord) {
      // Of the tensions of a cord that turns wheels, the number of this one.
      std::size_t number = 0, count = 0;
      const std::size_t own = component.follows < 0 ? force.index : static_cast<std::size_t>(component.follows);
      for (std::size_t k = 0; k < mechanism().components.size(); ++k) {
        const Component<double>& other = mechanism().components[k];
        if (other.follows >= 0 || !act_together(mechanism().actions[static_cast<std::size_t>(other.action)], action))
          continue;
        ++count;
        if (k <= own) ++number;
      }
      const std::string cord = situation_.cords.size() > 1 ? letter : "",
                        which = count > 1 ? (cord.empty() ? "" : ",") + std::to_string(number) : "";
      symbol.tex = cord.empty() && which.empty() ? "T" : ExplanationTex::symbol("T", cord + which);
    } else if (action.kind == ActionKind::contact && component.one_sided) {
      symbol.tex = situation_.contacts.size() > 1 ? ExplanationTex::symbol("N", letter) : "N";
    } else {
      const Vector3<double> along = numbers.now.direction(component.along);
      std::string index;
      for (std::size_t k = 0; k < 3; ++k)
        if (std::abs(std::abs(along[k]) - 1) < 1e-9) {
          index = tex_.axis(k);
          if (along[k] < 0) symbol.sign = -1;
        }
      if (index.empty()) {
        const auto [name, sign] = named_direction(along);
        index = name;
        if (!index.empty()) symbol.sign = sign;
      }
      if (index.empty()) {
        int place = 1;
        for (std::size_t k = 0; k < force.index; ++k)
          if (mechanism().components[k].action == component.action && mechanism().components[k].couple == couple)
            ++place;
        index = std::to_string(place);
      }
      // The symbol is A_x for the point A, otherwise the letter of a force with the name as index.
      const bool short_name = letter.size() <= 2;
      symbol.tex = !couple && short_name ? ExplanationTex::symbol(letter, index)
                                         : ExplanationTex::symbol(couple ? "M" : "F", letter + "," + index);
    }
  } else if (force.kind == UnknownForce::Kind::effort) {
    const Drive<double>& drive = mechanism().drives[force.index];
    couple = drive.turning;
    const std::string& name = mechanism().actions[static_cast<std::size_t>(drive.action)].name;
    // Friction in several ways has a couple or force along each.
    std::string index;
    int number = 0, count = 0;
    for (std::size_t k = 0; k < mechanism().drives.size(); ++k) {
      const Drive<double>& other = mechanism().drives[k];
      if (other.action != drive.action || other.turning != drive.turning) continue;
      ++count;
      if (k <= force.index) ++number;
    }
    if (count > 1) index = "," + std::to_string(number);
    const Vector3<double> along = numbers.now.direction(drive.along);
    for (std::size_t k = 0; count > 1 && k < 3; ++k)
      if (std::abs(std::abs(along[k]) - 1) < 1e-9) {
        index = "," + tex_.axis(k);
        if (along[k] < 0) symbol.sign = -1;
      }
    symbol.tex = ExplanationTex::symbol(couple ? "M" : "F", name + index);
  } else {
    const solve::Impact& impact = numbers.blow.impacts[force.index];
    symbol.tex = ExplanationTex::symbol("F", impact.name + (impact.is_friction ? ",t" : ""));
  }
  if (sudden()) symbol.tex += "\\Delta t";
  symbol.dimension = sudden() ? (couple ? dimensions::angular_momentum : dimensions::momentum)
                              : (couple ? dimensions::moment : dimensions::force);
  symbol.determined = (sudden() ? solved_.blow() : solved_.motion()).determined(force.column);
  const int sign = static_cast<int>(symbol.sign);
  symbol.shown = shown([&](const auto& figures) {
    using Scalar = ScalarOf<decltype(figures)>;
    return Scalar(sign) * (sudden() ? figures.impulses : figures.unknowns)[force.column];
  });
  symbol.shown = clean(symbol.shown, symbol.dimension);
  symbol.value = symbol.shown.number;
  return symbol;
}

// Of several coordinates of a joint that have no name the axis along or about which one moves, or else its number.
std::string InstantExplainer::index_among_others(const NamedCoordinate& coordinate) const {
  int number = 0, own = 0;
  for (const NamedCoordinate& other : figures_.numbers.machine->coordinates) {
    if (other.joint != coordinate.joint || other.turning != coordinate.turning || !other.name.empty()) continue;
    ++number;
    if (other.velocity == coordinate.velocity) own = number;
  }
  if (number < 2) return "";
  solve::MechanismState moved = figures_.numbers.now;
  std::vector<double> one(moved.state().v.size(), 0.0);
  one[static_cast<std::size_t>(coordinate.velocity)] = 1;
  moved.set_velocities(one);
  for (int i = 0; i < mechanism().tree.body_count(); ++i) {
    if (mechanism().tree.body(i).v != coordinate.velocity) continue;
    const auto& motion = moved.workspace().motion[static_cast<std::size_t>(i + 1)];
    const Vector3<double>& along = coordinate.turning ? motion.w : motion.v;
    constexpr double on_axis = 1 - 1e-9;
    for (std::size_t k = 0; k < 3; ++k)
      if (std::abs(along[k]) > on_axis * norm(along)) return "," + tex_.axis(k);
  }
  return "," + std::to_string(own);
}

InstantExplainer::Symbol InstantExplainer::symbol_of_coordinate(std::size_t k, bool rates) const {
  Symbol symbol;
  const Machine& machine = *figures_.numbers.machine;
  const bool turns = solve::coordinate_turns(mechanism().tree, static_cast<int>(k));
  for (const NamedCoordinate& coordinate : machine.coordinates) {
    if (static_cast<std::size_t>(coordinate.velocity) != k) continue;
    symbol.tex = !coordinate.name.empty()
                     ? ExplanationTex::symbol(coordinate.name + (rates ? "'" : "''"))
                     : ExplanationTex::symbol(rates ? (turns ? "omega" : "v") : (turns ? "alpha" : "a"),
                                              coordinate.joint + index_among_others(coordinate));
  }
  if (symbol.tex.empty()) {
    for (int i = 0; i < mechanism().tree.body_count(); ++i) {
      const auto& body = mechanism().tree.body(i);
      const int at = static_cast<int>(k) - body.v;
      if (at < 0 || at >= velocity_size(body.joint)) continue;
      const std::string axis =
          tex_.axis(static_cast<std::size_t>(at % 3)) + (several_bodies() ? "," + body_name(i) : std::string());
      const std::string letter = ExplanationTex::symbol(turns ? "omega" : "v", axis);
      symbol.tex =
          rates ? letter : "\\dot{" + letter.substr(0, letter.find('_')) + "}" + letter.substr(letter.find('_'));
    }
  }
  symbol.dimension = rates ? (turns ? dimensions::angular_velocity : dimensions::velocity)
                           : (turns ? dimensions::angular_acceleration : dimensions::acceleration);
  symbol.shown =
      shown([&](const auto& figures) { return rates ? figures.now.state().v[k] : figures.now.accelerations()[k]; });
  symbol.shown = clean(symbol.shown, symbol.dimension);
  symbol.value = symbol.shown.number;
  symbol.determined = (sudden() ? solved_.blow() : rates ? solved_.velocities() : solved_.motion()).determined(k);
  return symbol;
}

// The coefficient of friction of a contact that slides; "" for what else exerts a force.
std::string InstantExplainer::sliding_coefficient(std::size_t action) const {
  const auto& rough = figures_.numbers.machine->rough_contacts;
  const auto sliding = std::ranges::find_if(
      rough, [&](const auto& one) { return one.action == static_cast<int>(action) && one.grip == Grip::slides; });
  if (sliding == rough.end() || sliding->on_cord()) return "";
  const auto stated = std::ranges::find(situation_.contacts, sliding->name, &Contact::name);
  const Name* name =
      stated != situation_.contacts.end() && stated->friction ? stated->friction->sliding.as<Name>() : nullptr;
  if (name) return ExplanationTex::symbol(name->name);
  const auto place = static_cast<std::size_t>(sliding - rough.begin());
  return factor_in_tex(shown([&](const auto& figures) { return figures.machine->rough_contacts[place].sliding; }),
                       dimensions::none);
}

// A number, or where it hangs on letters without value its formula, within a line of mathematics.
std::string InstantExplainer::factor_in_tex(const Shown& value, const Dimension& dimension) const {
  if (tex_.is_known(value)) return tex_.number(value.number, dimension);
  const std::string formula = tex_.value(value, dimension);
  if (formula.empty()) return "\\ldots";
  const bool sum = formula.find(" + ") != std::string::npos || formula.find(" - ") != std::string::npos;
  return sum ? "\\left(" + formula + "\\right)" : formula;
}

// What the friction of a joint that moves is by what the joint carries; "" for what else acts.
std::string InstantExplainer::law_of_bearing(std::size_t action) const {
  const auto& rough = figures_.numbers.machine->rough_contacts;
  const auto found = std::ranges::find_if(
      rough, [&](const auto& one) { return one.action == static_cast<int>(action) && one.found_with_reactions(); });
  if (found == rough.end()) return "";
  if (found->pressing.empty()) return ", against its slip in all its ways together";
  return ", against the motion, " + words_of_bearing(static_cast<std::size_t>(found - rough.begin()));
}

std::string InstantExplainer::words_of_bearing(std::size_t contact) const {
  const auto& found = figures_.numbers.machine->rough_contacts[contact];
  const Bearing& bearing = *std::ranges::find(situation_.contacts, found.name, &Contact::name)->friction->bearing;
  if (found.pressing.front().form == PressingPart<double>::Form::thread)
    return "$\\mu$ times the push of the flanks at the mean radius of the thread";
  if (found.pressing.front().form == PressingPart<double>::Form::whole)
    return std::string(found.turning ? "$\\mu r R$" : "$\\mu R$") + " with the whole force that it carries";
  std::vector<std::string> parts;
  if (bearing.radius || !found.turning)
    parts.push_back(std::string(found.turning ? "$\\mu r R$" : "$\\mu N$") + " with the force across its " +
                    (found.turning ? "axis" : "direction") +
                    (found.pressing.size() > (bearing.thrust_radius ? 2 : 1) ? " at each place where it bears" : ""));
  if (bearing.thrust_radius) parts.push_back("$\\mu r_t T$ with the thrust along its axis");
  return joined(parts, " and ");
}

// "the cord *rope*".
std::string InstantExplainer::words_of_cord(const std::string& name) const {
  const auto belt = std::ranges::find(situation_.belts, name, &Belt::name);
  return std::string(belt == situation_.belts.end() ? "the cord *"
                     : belt->chain                  ? "the chain *"
                                                    : "the belt *") +
         name + "*";
}

// What the initial tension leaves for the last side of a belt, which is no longer and no shorter than it was.
constexpr const char* sum_of_sides = ", as $\\Sigma L_k T_k = T_0\\,\\Sigma L_k$ over the lengths of the sides";

// Whether the one direction that is told with a force is that in which it acts on what is cut free.
bool with_own_direction(ActionKind kind) { return kind == ActionKind::cord || kind == ActionKind::mesh; }

// Lists the external forces one by one, but for those across the plane of a problem.
void InstantExplainer::force_list(ExplainedSection& here, const System& system,
                                  const std::set<std::string>& across) const {
  std::vector<std::string> items;
  const Vector3<double> gravity = mechanism().tree.gravity();
  for (const int body : system.plan.bodies) {
    if (sudden() || !(mechanism().tree.body(body).inertia.mass > 0) || norm(gravity) == 0) continue;
    const ShownVector weight = shown_vector([&](const auto& figures) {
      return figures.mechanism().tree.body(body).inertia.mass * figures.mechanism().tree.gravity();
    });
    items.push_back(
        "the weight of *" + body_name(body) + "* at $" + center_label(body) + "$" +
        (tex_.can_show(weight) ? ": " + tex_.inline_equation("m\\mathbf{g}", weight, dimensions::force) : ""));
  }
  const MotionBalance<double> balance = balance_of(figures_.numbers, system.plan, Vector3<double>::zero());
  for (std::size_t i = 0; i < system.plan.known.size(); ++i) {
    const Action& action = mechanism().actions[system.plan.known[i].action];
    const SpatialForce<double>& wrench = balance.known[i];
    const bool couple = norm(wrench.force) == 0;
    if (couple && norm(wrench.moment) == 0) continue;
    const ShownVector value = shown_vector([&](const auto& figures) {
      const auto all = balance_of(figures, system.plan, Vector3<ScalarOf<decltype(figures)>>::zero());
      return couple ? all.known[i].moment : all.known[i].force;
    });
    if (!tex_.can_show(value)) continue;
    const Dimension dimension = sudden() ? (couple ? dimensions::angular_momentum : dimensions::momentum)
                                         : (couple ? dimensions::moment : dimensions::force);
    items.push_back(
        std::string(couple     ? "the couple"
                    : sudden() ? "the impulse"
                               : "the force") +
        " of *" + action.name + "*" +
        (action.kind == ActionKind::attraction && several_bodies() ? " on *" + body_name(action.on) + "*" : "") + ": " +
        tex_.inline_both(value, dimension));
    if (action.kind != ActionKind::attraction) continue;
    const ShownVector turning = shown_vector([&](const auto& figures) {
      const auto center = body_mass_center(figures.mechanism().tree, figures.now.workspace(), action.on);
      return figures.now.known_wrench(static_cast<int>(system.plan.known[i].action), center).moment;
    });
    if (norm(turning.number) > 0 && !vanishes(turning.number, dimensions::moment) && tex_.can_show(turning))
      items.back() += ", with the couple " + tex_.inline_vector(turning, dimensions::moment) + " about $" +
                      center_label(action.on) + "$";
  }
  // The components of one action are listed together; what a side of a belt has of the initial tension and of the
  // other sides is one sum.
  // The body on which an action is told to act is not among those that are cut free.
  const auto is_reversed = [&](std::size_t action) {
    return !system.plan.bodies.contains(mechanism().actions[action].on);
  };
  std::set<std::size_t> as_it_acts;  // those whose direction is told as it is here
  using Held = std::pair<std::size_t, std::vector<std::string>>;
  std::vector<Held> held;
  std::map<std::size_t, std::string> sums;
  for (std::size_t i = 0; i < system.plan.unknown.size(); ++i) {
    const UnknownForce& force = system.plan.unknown[i];
    const std::size_t action = action_of(force);
    if (across.contains(system.unknown[i].tex)) continue;
    std::string symbol = "$" + system.unknown[i].tex + "$";
    if (force.kind == UnknownForce::Kind::impact) {
      const ShownVector direction = shown_vector(
          [&](const auto& figures) { return impact_wrench(*figures.before, figures.blow.impacts[force.index]).force; });
      if (tex_.can_show(direction)) symbol += " along " + tex_.inline_both(direction, dimensions::none);
    }
    if (force.kind == UnknownForce::Kind::component) {
      const Component<double>& component = mechanism().components[force.index];
      const double part = component.followed_part();
      const std::string size_of_part =
          std::abs(part) == 1 ? ""
                              : factor_in_tex(shown([&](const auto& figures) {
                                                using Scalar = ScalarOf<decltype(figures)>;
                                                return Scalar(part < 0 ? -1 : 1) *
                                                       figures.mechanism().components[force.index].followed_part();
                                              }),
                                              dimensions::none) +
                                    "\\,";
      // What a cord with friction pulls behind a wheel, and what a side of a belt has of the initial tension.
      if (component.span && component.follows >= 0 && component.followed_part() != 1)
        symbol = "$" + std::string(part < 0 ? "-" : "") + size_of_part + system.unknown[i].tex + "$";
      if (component.span && component.follows >= 0 && (component.offset != 0 || sums.contains(action))) {
        std::string& sum = sums[action];
        if (component.offset != 0)
          sum = factor_in_tex(
                    shown([&](const auto& figures) { return figures.mechanism().components[force.index].offset; }),
                    dimensions::force) +
                sum;
        sum += (part < 0 ? " - " : sum.empty() ? "" : " + ") + size_of_part + system.unknown[i].tex;
        symbol = "$" + sum + "$";
        if (const auto said = std::ranges::find(held, action, &Held::first); said != held.end()) said->second.clear();
      }
      const Vector3<double> along = figures_.numbers.now.direction(component.along);
      const bool on_axis = std::max({std::abs(along.x), std::abs(along.y), std::abs(along.z)}) > 1 - 1e-9;
      const bool plain_name = mechanism().actions[action].kind != ActionKind::cord && !component.one_sided;
      const bool parts_wheels = mechanism().actions[action].kind == ActionKind::mesh && !sudden() &&
                                norm(wrench_with_parting(figures_.numbers.now, force.index).force - along) > 1e-12;
      if (!on_axis || !plain_name || parts_wheels) {
        const ShownVector direction = shown_vector([&](const auto& figures) {
          const auto one = sudden() ? figures.now.component_wrench(figures.mechanism().components[force.index])
                                    : wrench_with_parting(figures.now, force.index);
          using Scalar = ScalarOf<decltype(figures)>;
          const int told = parts_wheels ? static_cast<int>(system.unknown[i].sign) : 1;
          const Scalar sign(with_own_direction(mechanism().actions[action].kind) && is_reversed(action) ? -told : told);
          return Vector3<Scalar>(sign * (component.couple ? one.moment : one.force));
        });
        if (const std::string coefficient = sliding_coefficient(action); !coefficient.empty())
          symbol += " along the normal, and the friction $" + coefficient + "\\," + system.unknown[i].tex +
                    "$ against the sliding";
        else if (tex_.can_show(direction)) {
          symbol += " along " + tex_.inline_both(direction, dimensions::none);
          if (with_own_direction(mechanism().actions[action].kind)) as_it_acts.insert(action);
        }
      }
    }
    auto item = std::ranges::find(held, action, &Held::first);
    if (item == held.end()) item = held.insert(held.end(), {action, {}});
    item->second.push_back(symbol);
  }
  for (const auto& [index, symbols] : held) {
    const Action& action = mechanism().actions[index];
    const bool reversed = is_reversed(index) && !as_it_acts.contains(index);
    const std::string what = action.kind == ActionKind::drive      ? "the motor at *" + action.joint + "*"
                             : action.kind == ActionKind::friction ? "the friction in *" + action.name + "*"
                             : action.kind == ActionKind::cord     ? words_of_cord(action.name)
                             : action.kind == ActionKind::contact  ? "the contact *" + action.name + "*"
                             : action.kind == ActionKind::mesh     ? "the teeth *" + action.name + "*"
                             : action.kind == ActionKind::impact   ? "the impact *" + action.name + "*"
                             : action.kind == ActionKind::support
                                 ? "the support *" + action.name + "* of *" + action.joint + "*"
                                 : "the joint *" + action.name + "*";
    const auto side =
        std::ranges::find(figures_.numbers.machine->cord_parts, static_cast<int>(index), &CordPart::action);
    const std::string between =
        side == figures_.numbers.machine->cord_parts.end() ? "" : " from *" + side->from + "* to *" + side->to + "*";
    items.push_back(what + between + ": " + listed(symbols) + (sums.contains(index) ? sum_of_sides : "") +
                    (reversed ? " (here with the opposite sign)" : "") + law_of_bearing(index));
  }
  if (items.empty()) {
    here.steps.push_back({"Nothing acts from outside.", {}});
    return;
  }
  std::string text = sudden() ? "Impulses from outside:\n" : "From outside act:\n";
  for (const std::string& item : items) text += "\n* " + item;
  here.steps.push_back({text, {}});
  if (std::ranges::any_of(system.plan.bodies, [&](int body) { return has_absorbed(body); }))
    here.steps.push_back(
        {"Particles that have stuck move on with their bodies: the momenta after have theirs as well.", {}});
}

void InstantExplainer::list_unknowns(const std::vector<Symbol>& unknowns) {
  ExplainedStep step{
      situation_.find.empty() || found_along_motion() ? "Solved for the unknowns:" : "Then the other unknowns are", {}};
  std::vector<std::string> shared, zero;
  for (const Symbol& symbol : unknowns) {
    if (!symbol.determined) {
      shared.push_back("$" + symbol.tex + "$");
      continue;
    }
    if (symbol.value == 0 && (!symbol.shown.formula || symbol.shown.formula->is_zero()))
      zero.push_back("$" + symbol.tex + "$");
    else if (tex_.can_show(symbol.shown))
      step.equations.push_back(tex_.equation(symbol.tex, symbol.shown, symbol.dimension));
  }
  // Where each component equation has an unknown of its own they are solved as they stand.
  const ExplainedSection& rows = section(sudden() ? "Impulse and momentum" : "Component equations");
  const bool said = std::ranges::all_of(step.equations, [&](const ExplainedEquation& solved) {
    return std::ranges::any_of(rows.steps, [&](const ExplainedStep& one) {
      return std::ranges::find(one.equations, solved.tex, &ExplainedEquation::tex) != one.equations.end();
    });
  });
  if (said && zero.empty() && shared.empty()) return;
  ExplainedSection& here = section("Unknowns");
  if (!said) here.steps.push_back(std::move(step));
  if (!zero.empty()) here.steps.push_back({listed(zero) + (zero.size() > 1 ? " are zero." : " is zero."), {}});
  if (shared.empty()) return;
  if (shared.size() == 1) {
    here.steps.push_back({shared.front() + " is left open, and not asked.", {}});
    return;
  }
  const bool by_friction = !sudden() && figures_.numbers.forces && sticking_forces(solved_);
  here.steps.push_back({(by_friction ? "These equations determine only combinations of "
                                     : "What the equations leave open is not asked: only combinations of ") +
                            listed(shared) + (by_friction ? "." : " are determined."),
                        {}});
}

std::string ExplanationTex::plain(const std::string& tex) {
  std::string text;
  std::vector<std::string> marks;  // of the open groups: what stands behind each
  std::string mark;
  for (std::size_t i = 0; i < tex.size(); ++i) {
    if (tex[i] == '{') {
      marks.push_back(std::exchange(mark, ""));
    } else if (tex[i] == '}') {
      if (!marks.empty()) {
        text += marks.back();
        marks.pop_back();
      }
    } else if (tex[i] != '\\') {
      text += tex[i];
    } else {
      std::size_t end = i + 1;
      while (end < tex.size() && std::isalpha(static_cast<unsigned char>(tex[end])) != 0) ++end;
      const std::string word = tex.substr(i + 1, end - i - 1);
      static const std::set<std::string> of_type{"mathbf", "mathrm", "mathit", "boldsymbol", "bar", "hat", "text"};
      // What is escaped, such as \_, stands for itself, and \, is a thin space.
      if (word == "dot" || word == "ddot")
        mark = word == "dot" ? "'" : "''";
      else if (!of_type.contains(word))
        text += word;
      if (word.empty() && end < tex.size()) text += tex[end] == ',' ? ' ' : tex[end];
      i = word.empty() ? end : end - 1;
    }
  }
  return text;
}

std::string with_emphasis(std::string sentence) {
  const auto is_letter = [&](std::size_t i) {
    return i < sentence.size() && std::isalnum(static_cast<unsigned char>(sentence[i])) != 0;
  };
  bool within = false;
  for (std::size_t i = 0; i < sentence.size(); ++i) {
    if (sentence[i] != '\'') continue;
    const bool apostrophe = i > 0 && is_letter(i - 1) && (is_letter(i + 1) || !within);
    if (apostrophe) continue;
    sentence[i] = '*';
    within = !within;
  }
  return sentence;
}

bool has_parts(const std::string& tex) { return tex.find(' ') != std::string::npos; }
bool shows_rate(const std::string& tex) { return tex.find("\\dot") != std::string::npos; }
std::string at_beginning(const std::string& symbol) {
  if (!symbol.ends_with("}") || shows_rate(symbol)) return symbol + "_{0}";
  return symbol.substr(0, symbol.size() - 1) + ",0}";
}
bool is_equality(const std::string& tex) { return tex.find(" = ") != std::string::npos; }

}  // namespace poinsot::problem
