#include "problem/equations/traced_machine.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <optional>
#include <set>

#include "poinsot/engine/dynamics/convert_mechanism.h"
#include "poinsot/engine/math/trace/traced_formula.h"
#include "poinsot/engine/motion/mechanism/mechanism_dynamics.h"
#include "poinsot/engine/solve/instant/equations.h"
#include "poinsot/engine/work/work.h"
#include "problem/entries/drawn_letters.h"
#include "problem/formulas/formula_answers.h"
#include "problem/language/diagnostic.h"
#include "problem/language/scalar_value.h"

namespace poinsot::problem {
namespace {

constexpr std::size_t most_terms = 5000;  // of a formula of the file that becomes operations
// On the equations, and on finding values of letters at which the situation makes sense.
constexpr Work most_work = 10'000'000'000, most_trying_work = 1'000'000'000;
constexpr int most_points = 50;  // at which the situation is tried until it makes sense

// A letter of the equations: a letter of the file, an unknown, or a datum that remains a letter.
struct Parameter {
  std::string name;
  Dimension dimension;
  bool positive = false;
};

// The values of the names in a file, as formulas in the parameters.
class Names {
 public:
  Names(const Situation& situation, const EquationsOptions& options) : situation_(situation) {
    if (!situation.choose.empty())
      throw NoEquations("what is chosen (choose: " + situation.choose.front().name +
                        ") has no place in equations of motion; state which of them act");
    std::set<std::string> set;
    const std::vector<std::string> known = settable_names(situation);
    for (const auto& [name, text] : options.sets) {
      // Settings for names of other situations are not used here.
      if (std::find(known.begin(), known.end(), name) == known.end()) continue;
      set.insert(name);
      values_[name] = exact_setting(situation, name, text);
    }
    for (const Letter& letter : situation.letters)
      if (!set.contains(letter.name)) add_letter(letter.name, letter.unit.dimension, !letter.either_sign);
    for (const std::string& name : options.letters) {
      const auto given = std::find_if(situation.given.begin(), situation.given.end(),
                                      [&](const NamedExpression& item) { return item.name == name; });
      if (given == situation.given.end()) {
        std::vector<std::string> names;
        for (const NamedExpression& item : situation.given) names.push_back(item.name);
        const std::string hint = did_you_mean(name, names);
        fail("--letter " + name, {}, "the problem gives no datum '" + name + "'",
             hint.empty() ? "name one of its given data" : hint);
      }
      if (set.contains(name)) continue;
      const Value<double> value = value_of(*given);
      if (!value.is_number())
        fail("--letter " + name, {}, "'" + name + "' is no number", "only numbers can be letters");
      add_letter(name, value.dimension, value.number > 0);
    }
    for (const Unknown& unknown : situation.find) {
      if (set.contains(unknown.name)) continue;
      if (!unknown.vector) {
        add_letter(unknown.name, unknown.unit.dimension, false);
        continue;
      }
      Vector3<Formula> components;
      for (std::size_t k = 0; k < 3; ++k) {
        const std::string name = unknown.name + "_" + situation.axes[k];
        parameters_.push_back({name, unknown.unit.dimension, false});
        components[k] = Formula::letter(name, poinsot::Sign::real);
      }
      values_[unknown.name] = Value<Formula>::of_vector(components, unknown.unit.dimension);
    }
    parameters_.push_back({"time", dimensions::time, false});
  }

  const std::map<std::string, Value<Formula>>& values() const { return values_; }
  const std::vector<Parameter>& parameters() const { return parameters_; }
  // Values that a body is likely to have and that are not special: none is zero or in a simple ratio to another.
  LetterValues likely_values(int attempt) const {
    std::vector<Letter> letters;
    for (const Parameter& parameter : parameters_) {
      Letter& letter = letters.emplace_back();
      letter.name = parameter.name;
      letter.unit.dimension = parameter.dimension;
      letter.either_sign = !parameter.positive;
    }
    LetterValues values;
    // Drawn points have simple ratios, which may be special: each value is moved by up to 1.4 %, no two by the same
    // part.
    for (const auto& [name, value] : draw_point(letters, simple_points + 1 + 4 * attempt))
      values[name] = value * (1 + 0.01 * std::numbers::sqrt2 *
                                      std::fmod(static_cast<double>(values.size()) * std::numbers::phi, 1.0));
    return values;
  }

 private:
  void add_letter(const std::string& name, const Dimension& dimension, bool positive) {
    const bool sure = positive && !(dimension == dimensions::angle);
    parameters_.push_back({name, dimension, sure});
    values_[name] = Value<Formula>::of_number(
        Formula::letter(name, sure ? poinsot::Sign::positive : poinsot::Sign::real), dimension);
  }
  // A datum may be computed from letters. Only its dimension and its sign are needed here.
  Value<double> value_of(const NamedExpression& item) const {
    Settings ones;
    for (const Letter& letter : situation_.letters)
      ones[letter.name] = Value<double>::of_number(1, letter.unit.dimension);
    for (const Unknown& unknown : situation_.find)
      ones[unknown.name] = value_of_unknown(unknown, {1, 1, 1}, situation_.plane);
    DataScope<double> data(situation_, ones);
    return data.value(item.value);
  }

  const Situation& situation_;
  std::map<std::string, Value<Formula>> values_;
  std::vector<Parameter> parameters_;
};

MachineOf<Formula> formula_machine(const Situation& situation, const Names& names) {
  const Settings nothing;
  const Formula time = Formula::letter("time", poinsot::Sign::real);
  DataScope<Formula> data(situation, nothing, time);
  DataScope<TimeJetOf<Formula>> timed(situation, nothing, time_jet(time));
  for (const auto& [name, value] : names.values()) {
    data.vary(name, value);
    timed.vary(name, lifted<TimeJetOf<Formula>>(value));
  }
  MachineOptions options;
  if (!situation.stages.empty()) options.loads = situation.stages.front().loads;
  const AnyValue any = [](const Dimension&) -> double {
    throw NoEquations("a mass property is given as `any`: the equations of motion need it");
  };
  return build_machine(situation, data, timed, any, options);
}

// The machine at values of the letters for which the situation makes sense, such as possible moments of inertia.
// decisions: receives the scope in which signs are decided at these values.
MachineOf<Formula> possible_machine(const Situation& situation, const Names& names,
                                    std::optional<PlainPointScope>& decisions) {
  // The time is always one of the parameters.
  if (names.parameters().size() == 1) return formula_machine(situation, names);
  std::optional<StatementError> refusal;
  const WorkLimit limit(most_trying_work);
  for (int attempt = 0; attempt <= most_points; ++attempt) {
    if (attempt > 1 && limit.spent()) break;
    if (attempt > 0) decisions.emplace(names.likely_values(attempt));
    try {
      return formula_machine(situation, names);
    } catch (const StatementError& error) {
      if (!refusal) refusal = error;
    }
  }
  std::vector<Diagnostic> told = refusal->diagnostics();
  for (Diagnostic& one : told)
    one.message += "; so it is at all values of the letters that were tried, of which these are the first";
  throw StatementError(std::move(told));
}

// Checks that contacts and cords carry forces only along what they forbid. Other forces do not follow from the
// equations of motion.
void check_actions(Mechanism<Formula>& mechanism, const Situation& situation) {
  for (const Contact& contact : situation.contacts)
    if (contact.strikes_later())
      throw NoEquations("contact '" + contact.name +
                        "' is struck later: a motion with blows is not told by one set of equations");
  for (const Cord& cord : situation.cords)
    if (cord.length)
      throw NoEquations("cord '" + cord.name +
                        "' states its length: slack and taut it has equations of its own, and between them a blow");
  for (const Gear& gear : situation.gears)
    if (gear.friction)
      throw NoEquations("gear '" + gear.name +
                        "' has friction: which flanks of its teeth carry is told at an instant, not by one set of "
                        "equations");
  for (VelocityConstraint<Formula>& c : mechanism.constraints) {
    if (c.shape_unknown)
      throw NoEquations("how the point of contact moves has no formula (" + c.words +
                        "): it has one for a plane with any shape, for a sphere or particle with any but an ellipsoid, "
                        "and for cylinders, cones and rods that cross; a body given by numbers needs its surface as a "
                        "massless part under added:");
    // A contact of a steady motion is treated as one of any motion.
    c.carried_by.reset();
    c.carried_along.reset();
  }
  for (std::size_t i = 0; i < mechanism.actions.size(); ++i) {
    const Action& action = mechanism.actions[i];
    if (action.kind != ActionKind::contact && action.kind != ActionKind::cord && action.kind != ActionKind::mesh)
      continue;
    const int index = static_cast<int>(i);
    const auto of_action = [index](const auto& item) {
      if constexpr (requires { item.follows; })
        if (item.follows >= 0) return false;
      return item.action == index;
    };
    if (std::count_if(mechanism.components.begin(), mechanism.components.end(), of_action) !=
        std::count_if(mechanism.constraints.begin(), mechanism.constraints.end(), of_action))
      throw NoEquations(
          "contact '" + action.name +
          "' carries other forces than those that its constraints need: no equation of motion gives them");
  }
}

std::vector<bool> find_held(const Mechanism<Formula>& mechanism) {
  const auto n = static_cast<std::size_t>(mechanism.tree.velocity_size());
  std::vector<bool> driven(n, false), held(n, false);
  for (const Drive<Formula>& drive : mechanism.drives) {
    driven[static_cast<std::size_t>(drive.coordinate)] = true;
    if (drive.held) held[static_cast<std::size_t>(drive.coordinate)] = true;
  }
  for (int i = 0; i < mechanism.tree.body_count(); ++i) {
    const poinsot::Body<Formula>& body = mechanism.tree.body(i);
    if (mechanism.takes_part[static_cast<std::size_t>(i)]) continue;
    for (int k = body.v; k < body.v + velocity_size(body.joint); ++k)
      if (!driven[static_cast<std::size_t>(k)]) held[static_cast<std::size_t>(k)] = true;
  }
  return held;
}

std::vector<int> find_rubbing(const MachineOf<Formula>& machine) {
  std::vector<int> rubbing;
  for (const VelocityConstraint<Formula>& constraint : machine.mechanism.constraints) {
    const bool slides = std::ranges::any_of(machine.rough_contacts, [&](const RoughContactOf<Formula>& contact) {
      return !contact.in_joint() && contact.action == constraint.action && contact.grip == Grip::slides;
    });
    const auto component =
        std::ranges::find(machine.mechanism.components, constraint.action, &Component<Formula>::action);
    rubbing.push_back(slides ? static_cast<int>(component - machine.mechanism.components.begin()) : -1);
  }
  return rubbing;
}

// Whether a joint moves against a couple or force F of friction in all its ways together: F against its whole slip,
//   s = sqrt(sum (r_k v_k)^2),   and on each coordinate   -F r_k^2 v_k / s.
bool slips_in_all_ways(const RoughContactOf<Formula>& contact) {
  return contact.all_ways && contact.pressing.empty() && contact.grip == Grip::slides;
}

// Their motors have an effort that is known, and until the velocities are inputs it is F.
void free_slipping_joints(MachineOf<Formula>& machine) {
  for (const RoughContactOf<Formula>& contact : machine.rough_contacts)
    for (const RubbingWay<Formula>& way : contact.ways) {
      if (!slips_in_all_ways(contact)) continue;
      Drive<Formula>& drive = machine.mechanism.drives[way.drive];
      drive.held = false;
      drive.effort = contact.sliding;
    }
}

void turn_friction_against_slip(const MachineOf<Formula>& machine, TracedMachine& traced_machine,
                                const std::function<Traced(const Formula&)>& as_traced) {
  for (const RoughContactOf<Formula>& contact : machine.rough_contacts) {
    if (!slips_in_all_ways(contact)) continue;
    const auto rate = [&](const RubbingWay<Formula>& way) {
      return as_traced(way.arm) * traced_machine.state.v[static_cast<std::size_t>(way.coordinate)];
    };
    Traced squares(0);
    for (const RubbingWay<Formula>& way : contact.ways) squares += rate(way) * rate(way);
    const Traced slip = sqrt(squares);
    for (const RubbingWay<Formula>& way : contact.ways) {
      Traced& effort = traced_machine.mechanism.drives[way.drive].effort;
      effort = -effort * as_traced(way.arm) * rate(way) / slip;
    }
  }
}

// The state in which signs are decided. It is close to the drawn or stated pose and not special, but satisfies the
// constraints, so that redundant constraints are recognised.
State<double> sample_state(const MachineOf<Formula>& machine) {
  const Mechanism<double> mechanism =
      convert_mechanism<double>(machine.mechanism, [](const Formula& x) { return plain(x); });
  // Some hundredths of a radian or of the machine's length, and rates of about one: no two alike.
  constexpr double beside = 0.01;
  const double length = solve::natural_scales(mechanism).length;
  State<double> state;
  for (std::size_t k = 0; k < machine.q.size(); ++k) state.q.push_back(beside / (1.37 + 0.61 * static_cast<double>(k)));
  for (int k = 0; k < mechanism.tree.velocity_size(); ++k) state.v.push_back(0.53 + 0.29 * k);
  for (const poinsot::Body<double>& body : mechanism.tree.bodies()) {
    if (body.joint == JointType::prismatic) state.q[static_cast<std::size_t>(body.q)] *= length;
    if (body.joint == JointType::prismatic) state.v[static_cast<std::size_t>(body.v)] *= length;
    for (int k = 0; body.joint == JointType::free && k < 3; ++k) {
      state.q[static_cast<std::size_t>(body.q + 4 + k)] *= length;
      state.v[static_cast<std::size_t>(body.v + 3 + k)] *= length;
    }
  }
  for (std::size_t k = 0; k < machine.q.size(); ++k) state.q[k] += plain(machine.q[k]);
  if (machine.mechanism.constraints.empty()) return state;
  State<double> before = state;
  try {
    MechanismDynamics dynamics(mechanism);
    constexpr double closed = 1e-10;  // of natural lengths: Newton's method that arrives leaves 1e-14
    if (dynamics.project(state.q, state.v) <= closed) return state;
    for (std::size_t k = 0; k < machine.q.size(); ++k) state.q[k] = plain(machine.q[k]);
    if (dynamics.project(state.q, state.v) <= closed) return state;
  } catch (const std::logic_error&) {
    return before;
  }
  return before;
}

// The names and units of the coordinates.
class CoordinateNames {
 public:
  CoordinateNames(const Situation& situation, const MachineOf<Formula>& machine,
                  const std::vector<Parameter>& parameters)
      : situation_(situation), machine_(machine) {
    for (const Parameter& parameter : parameters) taken_.insert(parameter.name);
  }

  struct Named {
    std::string name, meaning;
    bool turns = false;
  };
  std::vector<Named> positions() {
    const Model<Formula>& tree = machine_.mechanism.tree;
    std::vector<Named> names(static_cast<std::size_t>(tree.position_size()));
    for (int i = 0; i < tree.body_count(); ++i) {
      const poinsot::Body<Formula>& body = tree.body(i);
      for (int k = 0; k < position_size(body.joint); ++k) {
        Named& named = names[static_cast<std::size_t>(body.q + k)];
        named.name = free_name("q", body.q + k);
        if (k < 4)
          named.meaning = "1: attitude of " + tree.name(i) + ", quaternion " + std::string(1, "wxyz"[k]);
        else
          named.meaning = "m: place of " + tree.name(i) + " from where it is drawn, along " +
                          situation_.axes[static_cast<std::size_t>(k - 4)];
      }
    }
    for (const NamedCoordinate& c : machine_.coordinates) {
      Named& named = names[static_cast<std::size_t>(c.position)];
      if (!c.name.empty()) named.name = c.name;
      named.meaning = std::string(c.turning ? "rad: angle" : "m: displacement") + " of joint '" + c.joint +
                      "' from where it is drawn";
    }
    return names;
  }
  std::vector<Named> velocities() {
    const Model<Formula>& tree = machine_.mechanism.tree;
    std::vector<Named> names(static_cast<std::size_t>(tree.velocity_size()));
    for (int i = 0; i < tree.body_count(); ++i) {
      const poinsot::Body<Formula>& body = tree.body(i);
      for (int k = 0; k < velocity_size(body.joint); ++k) {
        const auto at = static_cast<std::size_t>(body.v + k);
        const bool turns = body.joint != JointType::prismatic && k < 3;
        names[at] = {free_name("v", body.v + k),
                     std::string(turns ? "rad/s: " : "m/s: ") + machine_.mechanism.coordinate_names[at], turns};
        if (body.joint == JointType::ball || body.joint == JointType::free) names[at].meaning += ", on its own axes";
      }
    }
    for (const NamedCoordinate& c : machine_.coordinates)
      if (!c.name.empty()) names[static_cast<std::size_t>(c.velocity)].name = c.name + "'";
    return names;
  }
  // A letter with a number that is not the name of anything else.
  std::string free_name(std::string base, int index) {
    const std::string number = std::to_string(index + 1);
    while (taken_.contains(base + number)) base += base[0];
    return base + number;
  }

 private:
  const Situation& situation_;
  const MachineOf<Formula>& machine_;
  std::set<std::string> taken_;
};

}  // namespace

TracedMachine traced_machine(const Situation& situation, const EquationsOptions& options,
                             const std::string& third_array) {
  const FormulaLimitScope limits({most_terms, most_work});
  const Names names(situation, options);
  TracedMachine traced_machine;
  std::optional<PlainPointScope> decisions;
  traced_machine.stated = possible_machine(situation, names, decisions);
  MachineOf<Formula>& machine = traced_machine.stated;
  if (machine.mechanism.tree.velocity_size() == 0) throw NoEquations("nothing in it can move");
  check_actions(machine.mechanism, situation);
  if (situation.sought_effort()) throw NoEquations("what drives a joint is to be found: state it in place of any");
  free_slipping_joints(machine);
  traced_machine.held = find_held(machine.mechanism);
  traced_machine.rubbing = find_rubbing(machine);

  Trace& trace = traced_machine.trace;
  const TraceScope scope(trace);
  CoordinateNames coordinates(situation, machine, names.parameters());
  std::vector<TextInput>& inputs = traced_machine.inputs;
  const State<double> sample = sample_state(machine);
  const auto positions = coordinates.positions(), velocities = coordinates.velocities();
  for (std::size_t k = 0; k < positions.size(); ++k) {
    const auto index = static_cast<int>(k);
    inputs.push_back({"q", index, positions[k].name, positions[k].meaning, false});
    traced_machine.state.q.push_back(trace.input(sample.q[k]));
  }
  for (std::size_t k = 0; k < velocities.size(); ++k) {
    inputs.push_back({"v", static_cast<int>(k), velocities[k].name, velocities[k].meaning, false});
    traced_machine.state.v.push_back(trace.input(sample.v[k]));
  }
  for (std::size_t k = 0; k < velocities.size(); ++k) {
    const bool acceleration = third_array == "a" || traced_machine.held[k];
    const bool turns = velocities[k].turns;
    const std::string base = coordinates.free_name(third_array == "a" ? "a" : "u", static_cast<int>(k));
    const std::string meaning =
        acceleration
            ? std::string(turns ? "rad/s^2" : "m/s^2") + ": acceleration that goes with " + velocities[k].name
            : std::string(turns ? "N*m" : "N") + ": generalised force beside those stated, on " + velocities[k].name;
    inputs.push_back({third_array, static_cast<int>(k), base, meaning, false});
    traced_machine.third.push_back(trace.input(0.37 - 0.23 * static_cast<double>(k)));
  }

  std::set<std::string> used;
  convert_mechanism<Formula>(machine.mechanism, [&](const Formula& x) {
    for (const std::string& letter : x.letters()) used.insert(letter);
    return x;
  });
  std::map<std::string, Traced> letters;
  for (const Parameter& parameter : names.parameters()) {
    if (!used.contains(parameter.name)) continue;
    const auto index = static_cast<int>(letters.size());
    const std::string unit = format_unit(parameter.dimension);
    inputs.push_back({"parameters", index, parameter.name, unit.empty() ? "1" : unit, parameter.positive});
    const poinsot::Sign sign = parameter.positive ? poinsot::Sign::positive : poinsot::Sign::real;
    letters[parameter.name] = trace.input(plain(Formula::letter(parameter.name, sign)));
  }
  const auto letter = [&](const std::string& name) { return letters.at(name); };
  const auto as_traced = [&](const Formula& x) { return traced(x, letter); };
  traced_machine.mechanism = convert_mechanism<Traced>(machine.mechanism, as_traced);
  turn_friction_against_slip(machine, traced_machine, as_traced);
  return traced_machine;
}

}  // namespace poinsot::problem
