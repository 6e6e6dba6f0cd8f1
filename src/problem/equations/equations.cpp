#include "problem/equations/equations.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>

#include "poinsot/engine/model/state.h"
#include "problem/answers/read_settings.h"
#include "problem/equations/rough_states.h"
#include "problem/equations/traced_machine.h"
#include "problem/language/diagnostic.h"
#include "problem/language/words.h"

namespace poinsot::problem {
namespace {

constexpr std::size_t longest_assumption = 20;  // an assumption with more operations than this is not shown

const Situation& chosen_situation(const Statement& statement, const std::string& name) {
  if (name.empty() && statement.situations.size() == 1) return statement.situations.front();
  std::string all;
  std::vector<std::string> names;
  for (const Situation& situation : statement.situations) {
    if (!name.empty() && situation.name == name) return situation;
    all += (all.empty() ? "" : ", ") + situation.name;
    names.push_back(situation.name);
  }
  if (name.empty())
    fail(statement.file, {}, "the file states several situations: " + all, "choose one: --situation " + names.front());
  const std::string hint = did_you_mean(name, names);
  fail("--situation " + name, {}, "the file has no situation '" + name + "'",
       !hint.empty()      ? hint
       : names[0].empty() ? "it states none"
                          : "it has " + all);
}

bool contains(const std::vector<EquationPart>& parts, EquationPart part) {
  return std::find(parts.begin(), parts.end(), part) != parts.end();
}

// Collects the blocks of results under their names.
class Equations {
 public:
  Equations(TracedMachine& machine, std::vector<EquationPart> parts) : machine_(machine), parts_(std::move(parts)) {
    const TraceScope scope(machine.trace);
    for (const TextInput& input : machine.inputs) taken_.insert(input.name);
    for (const EquationPart part : parts_)
      if (part <= EquationPart::reduced) {
        matrices();
        break;
      }
    if (contains(parts_, EquationPart::position_rate)) position_rates();
    if (contains(parts_, EquationPart::forward_dynamics)) forward();
    if (contains(parts_, EquationPart::inverse_dynamics)) inverse();
  }

  const std::vector<Traced>& outputs() const { return outputs_; }
  const std::vector<TextBlock>& blocks() const { return blocks_; }
  const std::vector<int>& independent() const { return independent_; }

 private:
  // A short name for a block, or a long one if a letter has the short one.
  std::string name(const std::string& brief, const std::string& whole) const {
    return taken_.contains(brief) ? whole : brief;
  }
  void add(const std::string& brief, const std::string& whole, const std::string& meaning, std::size_t rows,
           std::size_t columns, const std::vector<Traced>& values, bool symmetric = false) {
    blocks_.push_back({name(brief, whole), meaning, rows, columns, symmetric});
    outputs_.insert(outputs_.end(), values.begin(), values.end());
  }

  void matrices() {
    const EquationsOfMotion<Traced> equations = equations_of_motion(machine_.mechanism, machine_.state);
    const auto n = static_cast<std::size_t>(equations.size);
    const bool rubs = machine_.rubs();
    if (rubs && contains(parts_, EquationPart::reduced))
      throw NoEquations(
          "the forces of a contact that slides do work, and equations without them are none of fewer velocities alone: "
          "ask for forward-dynamics, or for the matrices");
    if (contains(parts_, EquationPart::mass_matrix)) add("M", "mass_matrix", "mass matrix", n, n, equations.mass, true);
    if (contains(parts_, EquationPart::right_side))
      add("F", "right_side",
          "right-hand side, M dv/dt = F" + std::string(equations.jacobian.empty() ? ""
                                                       : rubs                     ? " + B y"
                                                                                  : " + J^T y"),
          n, 1, equations.right_side);
    const std::size_t rows = equations.jacobian.size();
    if (contains(parts_, EquationPart::constraint_matrix) && rows > 0) {
      std::vector<Traced> J, b;
      for (const std::vector<Traced>& row : equations.jacobian) J.insert(J.end(), row.begin(), row.end());
      for (const Traced& bias : equations.bias) b.push_back(-bias);
      add("J", "constraint_matrix", "constraints on the velocities, J v = 0", rows, n, J);
      add("b", "constraint_side", "of their rates, J dv/dt = b", rows, 1, b);
      if (rubs) {
        const std::vector<std::vector<Traced>> forces = forces_of_constraints(equations);
        std::vector<Traced> B;
        for (std::size_t k = 0; k < n; ++k)
          for (const std::vector<Traced>& force : forces) B.push_back(force[k]);
        add("B", "force_matrix", "forces of the constraints, each with the friction of its contact, for y = 1", n, rows,
            B);
      }
    }
    if (!contains(parts_, EquationPart::reduced)) return;
    const ReducedEquations<Traced> reduced = reduced_equations(equations, machine_.held, machine_.third);
    const std::size_t m = reduced.independent.size();
    independent_ = reduced.independent;
    std::vector<Traced> N;
    for (const std::vector<Traced>& row : reduced.basis) N.insert(N.end(), row.begin(), row.end());
    add("N", "basis", "dv/dt = N du/dt + g for the independent velocities u", n, m, N);
    add("g", "offset", "the rest of it", n, 1, reduced.offset);
    add("M_u", "reduced_mass", "N^T M N", m, m, reduced.mass, true);
    add("F_u", "reduced_side", "N^T (F - M g): M_u du/dt = F_u", m, 1, reduced.right_side);
  }

  // The generalised forces of each constraint for y = 1: its row of J, but for contacts that slide.
  std::vector<std::vector<Traced>> forces_of_constraints(const EquationsOfMotion<Traced>& equations) const {
    const Mechanism<Traced>& mechanism = machine_.mechanism;
    Workspace<Traced> workspace(mechanism.tree);
    update_velocities(mechanism.tree, workspace, machine_.state);
    std::vector<std::vector<Traced>> forces = equations.jacobian;
    for (std::size_t i = 0; i < forces.size(); ++i) {
      if (machine_.rubbing[i] < 0) continue;
      const VelocityConstraint<Traced>& c = mechanism.constraints[i];
      const Component<Traced>& push = mechanism.components[static_cast<std::size_t>(machine_.rubbing[i])];
      PlacedForce<Traced> force;
      force.point = constraint_point(mechanism.tree, workspace, c);
      force.force = direction_on_ground(mechanism.tree, workspace, push.along.body, push.along.vector);
      follow_contact(mechanism.tree, workspace, c, force);
      std::ranges::fill(forces[i], Traced(0));
      add_generalised_force(mechanism.tree, workspace, c.on, c.from, force, forces[i]);
    }
    return forces;
  }

  void position_rates() {
    std::vector<Traced> rate(machine_.state.q.size());
    position_rate<Traced>(machine_.mechanism.tree, machine_.state.q, machine_.state.v, rate);
    add("q_dot", "position_rate", "rates of the positions", rate.size(), 1, rate);
  }

  // Takes the articulated-body algorithm or elimination in the mass matrix, whichever needs fewer operations.
  void forward() {
    const auto n = machine_.third.size();
    std::vector<Traced> best;
    std::size_t operations = 0;
    const auto take = [&](const std::function<std::vector<Traced>()>& road) {
      try {
        const std::vector<Traced> accelerations = road();
        const std::size_t count =
            StraightLine(machine_.trace, accelerations, StraightLine::Shortening::quick).operations();
        if (best.empty() || count < operations) {
          best = accelerations;
          operations = count;
        }
      } catch (const std::domain_error& error) {
        why_ = error.what();
      }
    };
    if (machine_.mechanism.constraints.empty()) take([&] { return by_tree(); });
    if (machine_.rubs())
      take([&] { return by_forces(); });
    else if (!machine_.mechanism.constraints.empty() || n <= 8)
      take([&] { return by_elimination(); });
    if (best.empty()) throw NoEquations("the accelerations are not determined: " + why_);
    add("dv_dt", "accelerations", "accelerations dv/dt", n, 1, best);
  }
  std::vector<Traced> by_elimination() {
    EquationsOfMotion<Traced> equations = equations_of_motion(machine_.mechanism, machine_.state);
    for (std::size_t k = 0; k < machine_.third.size(); ++k)
      if (!machine_.held[k]) equations.right_side[k] += machine_.third[k];
    return solved_accelerations(reduced_equations(equations, machine_.held, machine_.third));
  }
  // What slides against friction has forces that depend on those of the constraints: with dv/dt = M^-1 (F + B y) these
  // follow from J dv/dt = b.
  std::vector<Traced> by_forces() {
    EquationsOfMotion<Traced> equations = equations_of_motion(machine_.mechanism, machine_.state);
    const std::vector<std::vector<Traced>> forces = forces_of_constraints(equations), J = equations.jacobian;
    const std::vector<Traced> bias = equations.bias;
    for (std::size_t k = 0; k < machine_.third.size(); ++k)
      if (!machine_.held[k]) equations.right_side[k] += machine_.third[k];
    equations.jacobian.clear();
    equations.jacobian_terms.clear();
    equations.bias.clear();
    const auto moved_by = [&](const std::vector<Traced>& force, const std::vector<Traced>& given) {
      equations.right_side = force;
      return solved_accelerations(reduced_equations(equations, machine_.held, given));
    };
    std::vector<Traced> a = moved_by(std::vector<Traced>(equations.right_side), machine_.third);
    const auto led = [](const std::vector<Traced>& row, const std::vector<Traced>& x) {
      Traced sum(0);
      for (std::size_t k = 0; k < row.size(); ++k)
        if (!vanishes(row[k]) && !vanishes(x[k])) sum += row[k] * x[k];
      return sum;
    };
    std::vector<std::vector<Traced>> moved, rows(J.size());
    for (const std::vector<Traced>& force : forces)
      moved.push_back(moved_by(force, std::vector<Traced>(machine_.third.size(), Traced(0))));
    for (std::size_t i = 0; i < J.size(); ++i) {
      for (const std::vector<Traced>& one : moved) rows[i].push_back(led(J[i], one));
      rows[i].push_back(-bias[i] - led(J[i], a));
    }
    const std::vector<Traced> y = eliminated(std::move(rows));
    for (std::size_t i = 0; i < y.size(); ++i)
      for (std::size_t k = 0; k < a.size(); ++k)
        if (!vanishes(moved[i][k])) a[k] += y[i] * moved[i][k];
    return a;
  }
  // Gauss's elimination, with the right side as the last of each row. The pivot of a row is the one that is largest in
  // its column at plain numbers.
  static std::vector<Traced> eliminated(std::vector<std::vector<Traced>> rows) {
    const std::size_t n = rows.size();
    for (std::size_t c = 0; c < n; ++c) {
      const auto size = [c](const std::vector<Traced>& row) { return std::abs(plain(row[c])); };
      const auto best = std::ranges::max_element(rows.begin() + static_cast<std::ptrdiff_t>(c), rows.end(), {}, size);
      constexpr double rounding = 1e-11;  // of the terms of the pivot
      double largest = 0;
      for (const std::vector<Traced>& row : rows) largest = std::max(largest, size(row));
      if (!(size(*best) > rounding * largest) || vanishes((*best)[c]))
        throw std::domain_error("several constraints share what they carry, and the friction of contacts with them");
      std::swap(rows[c], *best);
      for (std::size_t i = 0; i < n; ++i) {
        if (i == c || vanishes(rows[i][c])) continue;
        const Traced factor = rows[i][c] / rows[c][c];
        for (std::size_t k = c; k <= n; ++k)
          if (!vanishes(rows[c][k])) rows[i][k] = k == c ? Traced(0) : rows[i][k] - factor * rows[c][k];
      }
    }
    std::vector<Traced> x;
    for (std::size_t i = 0; i < n; ++i) x.push_back(rows[i][n] / rows[i][i]);
    return x;
  }
  std::vector<Traced> by_tree() {
    const Model<Traced>& stated = machine_.mechanism.tree;
    std::vector<CoordinateMode> modes;
    for (const bool held : machine_.held) modes.push_back(held ? CoordinateMode::prescribed : CoordinateMode::free);
    const Model<Traced> tree(std::vector<poinsot::Body<Traced>>(stated.bodies().begin(), stated.bodies().end()),
                             stated.names(), modes, stated.gravity());
    Workspace<Traced> workspace(tree);
    update_velocities(tree, workspace, machine_.state);
    std::vector<Traced> force = known_generalised_forces(machine_.mechanism, workspace, machine_.state);
    std::vector<Traced> acceleration = machine_.third;
    for (std::size_t k = 0; k < force.size(); ++k)
      if (!machine_.held[k]) force[k] += machine_.third[k];
    hybrid_dynamics<Traced>(tree, workspace, machine_.state, acceleration, force);
    return acceleration;
  }

  void inverse() {
    const std::vector<Traced> forces = needed_generalised_forces(machine_.mechanism, machine_.state, machine_.third);
    add("effort", "efforts",
        std::string("generalised forces that must act beside those stated") +
            (machine_.mechanism.constraints.empty() ? "" : ", those of the constraints included"),
        forces.size(), 1, forces);
  }

  TracedMachine& machine_;
  std::vector<EquationPart> parts_;
  std::set<std::string> taken_;
  std::vector<Traced> outputs_;
  std::vector<TextBlock> blocks_;
  std::vector<int> independent_;
  std::string why_;
};

// The assumptions that expressions are positive, as text, unless they are so by their form.
std::vector<std::string> assumptions(const TracedMachine& machine) {
  std::vector<std::string> lines;
  std::set<Traced, decltype([](const Traced& a, const Traced& b) {
             return std::pair(a.node(), a.negative()) < std::pair(b.node(), b.negative());
           })>
      seen;
  for (const Traced& x : machine.trace.assumed_positive()) {
    if (!seen.insert(x).second) continue;
    const StraightLine formula(machine.trace, {x});
    const auto by_nature = [&](const StraightLine::Step& step) {
      if (step.operation == TracedOperation::input) return machine.inputs[step.input].positive;
      return step.operation == TracedOperation::constant || step.operation == TracedOperation::multiply ||
             step.operation == TracedOperation::divide || step.operation == TracedOperation::square_root;
    };
    if (!formula.outputs()[0].negative && std::all_of(formula.steps().begin(), formula.steps().end(), by_nature))
      continue;
    add_once(lines, formula.operations() > longest_assumption
                        ? "as long as no root passes through zero on the way from the pose as drawn"
                        : "for " + formula_text(formula, machine.inputs) + " > 0");
  }
  return lines;
}

std::vector<std::string> remarks(const SituationInStates& in_states, const std::string& title,
                                 const TracedMachine& machine, const Equations& equations, std::size_t operations) {
  const Situation& situation = in_states.situation;
  std::vector<std::string> lines;
  lines.push_back(title.empty() ? "Equations of motion" : title);
  lines.insert(lines.end(), in_states.words.begin(), in_states.words.end());
  std::string data;
  for (const NamedExpression& item : situation.given)
    data += (data.empty() ? "" : ", ") + item.name + " = " + to_string(item.value);
  if (!data.empty()) lines.push_back("given: " + data);
  std::string driven;
  for (std::size_t k = 0; k < machine.held.size(); ++k)
    if (machine.held[k]) driven += (driven.empty() ? "" : ", ") + machine.inputs[machine.state.q.size() + k].name;
  if (!driven.empty()) lines.push_back("driven as given, by forces that are found from it: " + driven);
  std::string independent;
  for (const int k : equations.independent())
    independent +=
        (independent.empty() ? "" : ", ") + machine.inputs[machine.state.q.size() + static_cast<std::size_t>(k)].name;
  if (!independent.empty()) lines.push_back("independent: " + independent);
  for (const std::string& assumption : assumptions(machine)) lines.push_back(assumption);
  // Out of the plane of its wheels a cord is told to the second order only (engine/dynamics/cord_span.h).
  if (!situation.plane)
    for (const Cord& cord : situation.cords) {
      const bool on_wheels = std::ranges::any_of(machine.stated.mechanism.constraints, [&](const auto& c) {
        return std::ranges::any_of(c.spans, [&](const auto& span) {
          return machine.stated.mechanism.actions[static_cast<std::size_t>(c.action)].name == cord.name &&
                 (!vanishes(span.from.reach) || !vanishes(span.to.reach));
        });
      });
      if (on_wheels) lines.push_back("while cord '" + cord.name + "' stays in the plane of its wheels");
    }
  lines.push_back("SI units; " + std::to_string(operations) + " operations");
  return lines;
}

}  // namespace

std::string equations_text(const Statement& statement, const EquationsOptions& options) {
  const Settings settings = read_settings(statement, options.sets);
  const Situation& stated = chosen_situation(statement, options.situation);
  std::vector<EquationPart> parts = options.parts;
  if (parts.empty()) parts = {EquationPart::mass_matrix, EquationPart::right_side, EquationPart::constraint_matrix};
  const bool forward = contains(parts, EquationPart::forward_dynamics);
  if (forward && contains(parts, EquationPart::inverse_dynamics))
    throw std::invalid_argument("forward and inverse dynamics are two functions: ask for one at a time");

  try {
    const SituationInStates in_states =
        stated.has_friction() ? in_stated_states(statement, stated, settings) : SituationInStates{stated, {}};
    const Situation& situation = in_states.situation;
    const std::string third = forward ? "u" : "a";
    TracedMachine machine = traced_machine(situation, options, third);
    const Equations equations(machine, parts);
    const StraightLine program(machine.trace, equations.outputs());
    ProgramText text;
    text.function = options.function;
    text.arrays = {"q", "v", third, "parameters"};
    text.inputs = machine.inputs;
    text.blocks = equations.blocks();
    text.remarks = remarks(in_states, statement.title, machine, equations, program.operations());
    return write_program(program, text, options.form);
  } catch (const NoFormula& error) {
    throw NoEquations(error.what());
  } catch (const FormulaTooLarge& error) {
    throw NoEquations(error.what());
  } catch (const std::domain_error& error) {
    throw NoEquations(error.what());
  }
}

}  // namespace poinsot::problem
