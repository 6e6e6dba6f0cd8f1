// Chooses the bodies that are taken as one, finds the external forces on them, and the point about which moments are
// taken.
#include <algorithm>
#include <cmath>

#include "poinsot/engine/solve/linear/linear_system.h"
#include "problem/explanation/explanation_instant.h"
#include "problem/language/words.h"

namespace poinsot::problem {

// Coordinates whose accelerations (velocities after the blow) the statement does not give.
std::vector<std::size_t> InstantExplainer::open_coordinates() const {
  const Machine& machine = *figures_.numbers.machine;
  const auto count = static_cast<std::size_t>(mechanism().tree.velocity_size());
  std::vector<bool> given(count, false);
  for (int i = 0; i < mechanism().tree.body_count(); ++i) {
    const auto& body = mechanism().tree.body(i);
    const bool frame = std::any_of(situation_.frames.begin(), situation_.frames.end(),
                                   [&](const Frame& f) { return machine.index.at(f.name) == i; });
    for (int k = 0; frame && k < velocity_size(body.joint); ++k) given[static_cast<std::size_t>(body.v + k)] = true;
  }
  if (sudden()) {
    for (const int k : figures_.numbers.blow.held_coordinates) given[static_cast<std::size_t>(k)] = true;
  } else {
    for (const StatedRate& stated : machine.accelerations) given[static_cast<std::size_t>(stated.velocity)] = true;
    if (situation_.steady) given.assign(count, true);
  }
  for (const std::size_t k : blocked_coordinates()) given[k] = true;
  for (int i = 0; later_ && i < mechanism().tree.body_count(); ++i) {
    const auto& body = mechanism().tree.body(i);
    for (int k = 0; !is_struck({i}) && k < velocity_size(body.joint); ++k)
      given[static_cast<std::size_t>(body.v + k)] = true;
  }
  std::vector<std::size_t> open;
  for (std::size_t k = 0; k < count; ++k)
    if (!given[k]) open.push_back(k);
  return open;
}

// Coordinates that a single cord, contact or loop keeps from moving, and from beginning to move.
std::vector<std::size_t> InstantExplainer::blocked_coordinates() const {
  if (sudden()) return {};
  std::vector<std::size_t> blocked;
  for (const VelocityConstraint<double>& constraint : mechanism().constraints) {
    const std::vector<double> row = solve::constraint_coefficients(figures_.numbers.now, constraint);
    std::vector<std::size_t> moved;
    for (std::size_t k = 0; k < row.size(); ++k)
      if (!is_rounding(row[k], solved_.scales().length)) moved.push_back(k);
    if (moved.size() != 1) continue;
    const std::size_t k = moved.front();
    if (is_rounding(figures_.numbers.now.accelerations()[k], noise_size(dimensions::angular_acceleration)) &&
        is_rounding(figures_.numbers.now.state().v[k], noise_size(dimensions::angular_velocity)))
      blocked.push_back(k);
  }
  if (blocked.size() == mechanism().constraints.size()) return blocked;
  // At rest several of them together keep from moving what no single one does.
  if (std::ranges::any_of(figures_.numbers.now.state().v, [](double one) { return one != 0; })) return blocked;
  const auto count = static_cast<std::size_t>(mechanism().tree.velocity_size());
  const auto idle = [&](std::size_t k) {
    return is_rounding(figures_.numbers.now.accelerations()[k], noise_size(dimensions::angular_acceleration));
  };
  solve::LinearSystem together;
  std::vector<std::size_t> unknown;
  for (std::size_t k = 0; k < count; ++k) {
    const auto& stated = figures_.numbers.machine->accelerations;
    if (idle(k) &&
        std::ranges::any_of(stated, [&](const StatedRate& one) { return static_cast<std::size_t>(one.velocity) == k; }))
      continue;
    const bool turns = solve::coordinate_turns(mechanism().tree, static_cast<int>(k));
    together.add_unknown("a" + std::to_string(k), turns ? 1 : solved_.scales().length);
    unknown.push_back(k);
  }
  for (const VelocityConstraint<double>& constraint : mechanism().constraints) {
    const std::vector<double> row = solve::constraint_coefficients(figures_.numbers.now, constraint);
    const std::size_t equation = together.add_equation(constraint.words, solved_.scales().length);
    for (std::size_t i = 0; i < unknown.size(); ++i) together.add(equation, i, row[unknown[i]]);
  }
  const solve::LinearSolution held = together.solve();
  for (std::size_t i = 0; i < unknown.size(); ++i)
    if (held.determined(i) && idle(unknown[i]) && std::ranges::find(blocked, unknown[i]) == blocked.end())
      blocked.push_back(unknown[i]);
  return blocked;
}

BalancePlan InstantExplainer::plan_for(const std::set<int>& bodies) const {
  BalancePlan plan;
  plan.bodies = bodies;
  plan.sudden = sudden();
  const Mechanism<double>& m = mechanism();
  // On which side of an action the bodies are: 1, -1, or 0 if on both or neither.
  const auto sign = [&](int action) -> double {
    const Action& a = m.actions[static_cast<std::size_t>(action)];
    const bool on = bodies.contains(a.on), from = bodies.contains(a.from);
    return on == from ? 0 : on ? 1 : -1;
  };
  const auto acts = [&](int action) {
    return !sudden() || solved_.blow_acting().empty() || solved_.blow_acting()[static_cast<std::size_t>(action)];
  };
  const solve::ForceUnknowns order = solve::force_unknowns(m);
  const std::size_t first = static_cast<std::size_t>(m.tree.velocity_size());
  for (std::size_t k = 0; k < m.components.size(); ++k)
    if (const double s = sign(m.components[k].action);
        s != 0 && acts(m.components[k].action) &&
        m.actions[static_cast<std::size_t>(m.components[k].action)].name != hold_of_plane) {
      // Teeth push wheels apart by a part of the force that turns these, which brings it along.
      const bool parts_wheels = m.components[k].parts_wheels;
      if (parts_wheels && m.components[k].flank != 0 && !sudden()) continue;
      // A cord pulls with one tension on both sides of a smooth wheel.
      const int follows = parts_wheels ? -1 : m.components[k].follows;
      plan.unknown.push_back(
          {UnknownForce::Kind::component, k, first + (follows < 0 ? k : static_cast<std::size_t>(follows)), s});
    }
  std::vector<bool> held(m.actions.size(), false);
  for (std::size_t k = 0; k < order.drive_of_effort.size(); ++k) {
    const Drive<double>& drive = m.drives[order.drive_of_effort[k]];
    held[static_cast<std::size_t>(drive.action)] = true;
    if (const double s = sign(drive.action); s != 0)
      plan.unknown.push_back(
          {UnknownForce::Kind::effort, order.drive_of_effort[k], first + m.components.size() + k, s});
  }
  if (sudden()) {
    const auto& impacts = figures_.numbers.blow.impacts;
    for (std::size_t k = 0; k < impacts.size(); ++k)
      if (const double s = sign(impacts[k].action); s != 0)
        plan.unknown.push_back(
            {UnknownForce::Kind::impact, k, first + m.components.size() + order.drive_of_effort.size() + k, s});
  }
  for (std::size_t a = 0; a < m.actions.size(); ++a) {
    const ActionKind kind = m.actions[a].kind;
    const bool given = sudden()
                           ? kind == ActionKind::impulse
                           : has_law(kind) || ((kind == ActionKind::drive || kind == ActionKind::friction) && !held[a]);
    const double s = sign(static_cast<int>(a));
    if (!given || s == 0) continue;
    plan.known.push_back({a, s});
  }
  plan.open = open_coordinates();
  return plan;
}

std::size_t InstantExplainer::action_of(const UnknownForce& force) const {
  const int action = force.kind == UnknownForce::Kind::component ? mechanism().components[force.index].action
                     : force.kind == UnknownForce::Kind::effort  ? mechanism().drives[force.index].action
                                                                 : figures_.numbers.blow.impacts[force.index].action;
  return static_cast<std::size_t>(action);
}

bool InstantExplainer::is_asked(const UnknownForce& force) const {
  const std::size_t action = action_of(force);
  // What pushes or pulls: the sides of a belt are pulled tight from the start.
  const bool pushes = force.kind == UnknownForce::Kind::component &&
                      (mechanism().components[force.index].one_sided || mechanism().components[force.index].span);
  return questions_.forces.contains(action) || (pushes && questions_.pushes.contains(action));
}

// Cuts some actions and returns the sets of bodies that are still connected.
std::vector<std::set<int>> InstantExplainer::pieces(const std::set<std::size_t>& cut) const {
  const Mechanism<double>& m = mechanism();
  std::set<int> left;
  const Machine& machine = *figures_.numbers.machine;
  for (const Body& body : situation_.bodies) left.insert(machine.index.at(body.name));
  std::vector<std::set<int>> found;
  while (!left.empty()) {
    std::set<int> piece{*left.begin()};
    for (bool grown = true; grown;) {
      grown = false;
      for (std::size_t a = 0; a < m.actions.size(); ++a) {
        if (cut.contains(a)) continue;
        const Action& action = m.actions[a];
        // The supports and the drive of one joint are cut together.
        for (const auto& [one, other] : {std::pair{action.on, action.from}, std::pair{action.from, action.on}})
          if (piece.contains(one) && left.contains(other) && piece.insert(other).second) grown = true;
      }
    }
    for (const int body : piece) left.erase(body);
    found.push_back(std::move(piece));
  }
  return found;
}

// Whether the equations for these sets of bodies, together with the constraints, determine what is asked for.
bool InstantExplainer::determines(const std::vector<std::set<int>>& systems) const {
  const solve::Scales& scales = solved_.scales();
  const double force = scales.mass * scales.length / (scales.time * scales.time) * (sudden() ? scales.time : 1);
  solve::LinearSystem equations;
  std::map<std::size_t, std::size_t> unknown_of;  // by column of the instant's unknowns
  const auto unknown = [&](std::size_t column, double scale) {
    const auto found = unknown_of.find(column);
    if (found != unknown_of.end()) return found->second;
    return unknown_of[column] = equations.add_unknown("u" + std::to_string(column), scale);
  };
  const auto coordinate_scale = [&](std::size_t k) {
    return solve::coordinate_turns(mechanism().tree, static_cast<int>(k)) ? 1 : scales.length;
  };
  std::set<std::size_t> asked;
  const std::vector<std::size_t> open = open_coordinates();
  for (const std::set<int>& bodies : systems) {
    const BalancePlan plan = plan_for(bodies);
    const MotionBalance<double> balance = balance_of(figures_.numbers, plan, Vector3<double>::zero());
    for (std::size_t row = 0; row < 6; ++row) {
      const std::size_t equation = equations.add_equation("balance", row < 3 ? force : force * scales.length);
      for (std::size_t i = 0; i < plan.unknown.size(); ++i) {
        const UnknownForce& f = plan.unknown[i];
        const bool couple = f.kind == UnknownForce::Kind::component ? mechanism().components[f.index].couple
                            : f.kind == UnknownForce::Kind::effort  ? mechanism().drives[f.index].turning
                                                                    : false;
        equations.add(equation, unknown(f.column, couple ? force * scales.length : force),
                      entry(balance.unknown[i], row));
      }
      for (std::size_t i = 0; i < plan.open.size(); ++i)
        equations.add(equation, unknown(plan.open[i], coordinate_scale(plan.open[i])), -entry(balance.motion[i], row));
    }
  }
  for (const std::size_t k : open)
    if (sudden() || questions_.accelerations) asked.insert(k);
  for (const Body& body : situation_.bodies)
    for (const UnknownForce& f : plan_for({figures_.numbers.machine->index.at(body.name)}).unknown)
      if (is_asked(f)) asked.insert(f.column);
  for (const VelocityConstraint<double>& constraint : mechanism().constraints) {
    const std::size_t equation = equations.add_equation(constraint.words, scales.length);
    const std::vector<double> row = solve::constraint_coefficients(figures_.numbers.now, constraint);
    for (const std::size_t k : open) equations.add(equation, unknown(k, coordinate_scale(k)), row[k]);
  }
  if (sudden())
    for (const solve::Impact& impact : figures_.numbers.blow.impacts) {
      const std::size_t equation = equations.add_equation("impact", scales.length);
      solve::MechanismState state = *figures_.numbers.before;
      for (const std::size_t k : open) {
        std::vector<double> one(static_cast<std::size_t>(mechanism().tree.velocity_size()), 0.0);
        one[k] = 1;
        state.set_velocities(one);
        equations.add(equation, unknown(k, coordinate_scale(k)), approach_of(state, impact));
      }
    }
  const solve::LinearSolution solution = equations.solve();
  return std::all_of(asked.begin(), asked.end(), [&](std::size_t column) {
    const auto found = unknown_of.find(column);
    const auto& whole = sudden() ? solved_.blow() : solved_.motion();
    // What the statement itself leaves open need not be determined.
    return !whole.determined(column) || (found != unknown_of.end() && solution.determined(found->second));
  });
}

// Whether a component of the balance about the best point contains no unknown force, but something else.
bool InstantExplainer::has_pure_equation(const std::set<int>& bodies) const {
  const BalancePlan plan = plan_for(bodies);
  const std::optional<ExplainedPoint> point = best_point(plan);
  if (!point) return false;
  const MotionBalance<double> balance = balance_of(figures_.numbers, plan, point->position.number);
  for (std::size_t row = 0; row < 6; ++row) {
    double unknown = 0, other = std::abs(entry(balance.rest, row));
    for (const auto& one : balance.unknown) unknown = std::max(unknown, std::abs(entry(one, row)));
    for (const auto& one : balance.weights) other = std::max(other, std::abs(entry(one, row)));
    for (const auto& one : balance.known) other = std::max(other, std::abs(entry(one, row)));
    const double size = noise_size(row < 3 ? dimensions::force : dimensions::moment);
    if (unknown <= 1e-9 * solved_.scales().length && other > 1e-9 * size) return true;
  }
  return false;
}

// Whether a blow along the motion changes how bodies move.
bool InstantExplainer::is_struck(const std::set<int>& bodies) const {
  return std::ranges::any_of(bodies, [&](int body) {
    const auto at = static_cast<std::size_t>(body + 1);
    const auto &after = figures_.numbers.now.workspace().motion[at],
               &before = figures_.numbers.before->workspace().motion[at];
    return !vanishes(after.w - before.w, dimensions::angular_velocity) ||
           !vanishes(after.v - before.v, dimensions::velocity);
  });
}

// All bodies as one, as far as they are connected. In a blow along the motion only what takes part in it connects them,
// and nothing is said of those that are not struck.
std::vector<std::set<int>> InstantExplainer::whole_systems() const {
  std::set<std::size_t> idle;
  const auto& impacts = figures_.numbers.blow.impacts;
  for (std::size_t a = 0; later_ && a < mechanism().actions.size(); ++a)
    if (!solved_.blow_acting()[a] &&
        std::ranges::find(impacts, static_cast<int>(a), &solve::Impact::action) == impacts.end())
      idle.insert(a);
  std::vector<std::set<int>> whole = pieces(idle);
  std::erase_if(whole, [&](const std::set<int>& piece) {
    return (later_ && !is_struck(piece)) ||
           std::ranges::none_of(piece, [&](int body) { return mechanism().tree.body(body).inertia.mass > 0; });
  });
  return whole;
}

// Those of several whole systems without which the others do not determine what is asked for.
std::vector<std::set<int>> InstantExplainer::only_needed(std::vector<std::set<int>> whole) const {
  // Their equations may fix data.
  if (!situation_.find.empty()) return whole;
  for (std::size_t k = whole.size(); k-- > 0 && whole.size() > 1;) {
    std::vector<std::set<int>> others = whole;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(k));
    if (determines(others)) whole = std::move(others);
  }
  return whole;
}

// The smallest collection of sets of bodies whose equations give what is asked for: all bodies as one, those that
// remain connected after one cut, single bodies.
std::vector<std::set<int>> InstantExplainer::choose_systems() const {
  const auto with_mass = [&](const std::set<int>& bodies) {
    return std::any_of(bodies.begin(), bodies.end(),
                       [&](int body) { return mechanism().tree.body(body).inertia.mass > 0; });
  };
  std::vector<std::set<int>> whole = whole_systems();
  // The candidates are what remains connected after one cut, and single bodies.
  const Mechanism<double>& m = mechanism();
  const auto between = [&](const Action& action) {
    std::set<std::size_t> all;
    for (std::size_t b = 0; b < m.actions.size(); ++b)
      if ((m.actions[b].on == action.on && m.actions[b].from == action.from) ||
          (m.actions[b].on == action.from && m.actions[b].from == action.on))
        all.insert(b);
    return all;
  };
  std::vector<std::set<int>> smaller;
  const auto add = [&](const std::set<int>& bodies) {
    const auto known = [&](const std::vector<std::set<int>>& list) {
      return std::find(list.begin(), list.end(), bodies) != list.end();
    };
    if (with_mass(bodies) && !known(whole) && !known(smaller)) smaller.push_back(bodies);
  };
  for (const Action& action : m.actions)
    if (action.on != ground && action.from != ground)
      for (const std::set<int>& piece : pieces(between(action))) add(piece);
  for (const Body& body : situation_.bodies) add({figures_.numbers.machine->index.at(body.name)});
  const bool anything_asked = !questions_.forces.empty() || !questions_.pushes.empty() || questions_.accelerations;
  if (!sudden() && !anything_asked) {
    // A datum is determined by an equation without unknown forces.
    if (std::any_of(whole.begin(), whole.end(), [&](const std::set<int>& one) { return has_pure_equation(one); }))
      return whole;
    for (const std::set<int>& bodies : smaller)
      if (has_pure_equation(bodies)) return {bodies};
  }
  if (determines(whole)) return only_needed(whole);
  for (const std::set<int>& bodies : smaller)
    if (determines({bodies})) return {bodies};
  std::set<std::size_t> forces = questions_.forces, cut;
  forces.insert(questions_.pushes.begin(), questions_.pushes.end());
  for (const std::size_t a : forces)
    if (m.actions[a].on != ground && m.actions[a].from != ground) cut.merge(between(m.actions[a]));
  std::vector<std::set<int>> parts = pieces(cut);
  if (determines(parts)) return parts;
  std::vector<std::set<int>> single;
  for (const Body& body : situation_.bodies) {
    const std::set<int> alone{figures_.numbers.machine->index.at(body.name)};
    if (!later_ || is_struck(alone)) single.push_back(alone);
  }
  return single;
}

std::string InstantExplainer::names_of(const std::set<int>& bodies) const {
  std::vector<std::string> names;
  for (const Body& body : situation_.bodies)
    if (bodies.contains(figures_.numbers.machine->index.at(body.name))) names.push_back("*" + body.name + "*");
  return listed(names);
}

// The point through which most unknown forces pass, so that they have no moment about it.
std::optional<ExplainedPoint> InstantExplainer::best_point(const BalancePlan& plan) const {
  const double near = 1e-9 * solved_.scales().length;
  std::size_t best = 0;
  std::optional<std::size_t> component;
  const solve::MechanismState& placed = sudden() ? *figures_.numbers.before : figures_.numbers.now;
  for (const UnknownForce& candidate : plan.unknown) {
    if (candidate.kind != UnknownForce::Kind::component || mechanism().components[candidate.index].couple) continue;
    const Vector3<double> P = placed.position(mechanism().components[candidate.index].at);
    // If the end of a cord or a contact moves, it has no advantage over the mass center.
    const ActionKind kind = mechanism().actions[action_of(candidate)].kind;
    const bool resting = std::all_of(plan.bodies.begin(), plan.bodies.end(), [&](int body) { return rests(body, P); });
    if ((kind == ActionKind::cord || kind == ActionKind::contact) && !resting) continue;
    std::size_t count = 0;
    for (const UnknownForce& other : plan.unknown) {
      const SpatialForce<double> one = other.kind == UnknownForce::Kind::component
                                           ? placed.component_wrench(mechanism().components[other.index])
                                       : other.kind == UnknownForce::Kind::effort
                                           ? placed.drive_wrench(mechanism().drives[other.index])
                                           : impact_wrench(placed, figures_.numbers.blow.impacts[other.index]);
      if (norm(one.force) > 0 && norm(about(one, P).moment) <= near) ++count;
    }
    if (count > best) {
      best = count;
      component = candidate.index;
    }
  }
  if (!component) return std::nullopt;
  const std::size_t k = *component;
  ExplainedPoint point;
  point.position = shown_vector([&](const auto& figures) {
    return (sudden() ? *figures.before : figures.now).position(figures.mechanism().components[k].at);
  });
  const auto name = named_point(point.position.number);
  point.label = ExplanationTex::symbol(name ? *name : free_point_name());
  return point;
}

// A letter for a point that has no name in the statement.
std::string InstantExplainer::free_point_name() const {
  const auto taken = [&](const std::string& letter) {
    return std::ranges::find(situation_.points, letter, &NamedExpression::name) != situation_.points.end() ||
           std::ranges::find(situation_.given, letter, &NamedExpression::name) != situation_.given.end();
  };
  for (const char* const letter : {"P", "Q", "R", "S", "K"})
    if (!taken(letter)) return letter;
  return "P_0";
}

// Where a point is that has no name in the statement.
std::string InstantExplainer::where(const ExplainedPoint& point) const {
  if (point.label != ExplanationTex::symbol(free_point_name()) || !tex_.can_show(point.position)) return "";
  return ", at " + tex_.inline_both(point.position, dimensions::length);
}

}  // namespace poinsot::problem
