#include "statement/instant.h"

#include <algorithm>
#include <boost/numeric/odeint.hpp>
#include <cmath>

#include "poinsot/solve/closure.h"
#include "statement/reader.h"
#include "statement/scalar_value.h"

namespace poinsot::statement {
namespace {

using Vector = Vector3<double>;

// The facts of a vector quantity, one for each component that is not `any`.
std::vector<std::pair<std::size_t, const Expression*>> stated_components(const Expression& value) {
  std::vector<std::pair<std::size_t, const Expression*>> components;
  const List* list = value.as<List>();
  if (!list || list->items.size() != 3) return components;
  for (std::size_t k = 0; k < 3; ++k) {
    const Name* name = list->items[k].as<Name>();
    if (!(name && name->name == "any")) components.emplace_back(k, &list->items[k]);
  }
  return components;
}

bool is_any(const Expression& expression) {
  const Name* name = expression.as<Name>();
  return name && name->name == "any" && name->primes == 0;
}

template <class Scalar>
Scalar component_of(const Vector3<Scalar>& v, std::size_t k) {
  return v[k];
}

// The differences quantity - value that a fact demands to vanish, with their dimensions.
template <class Scalar>
struct Difference {
  Scalar value;
  Dimension dimension;
};
template <class Scalar>
std::vector<Difference<Scalar>> differences(const Fact& fact, QuantityScope<Scalar>& scope, const std::string& file) {
  const Evaluator<Scalar> evaluator(scope, file);
  const Value<Scalar> quantity = evaluator(fact.quantity);
  std::vector<Difference<Scalar>> list;
  if (is_any(fact.value)) return list;
  if (quantity.is_number()) {
    list.push_back({quantity.number - evaluator.number(fact.value, quantity.dimension), quantity.dimension});
  } else if (quantity.is_vector()) {
    if (fact.value.as<List>() && fact.value.as<List>()->items.size() == 3) {
      for (const auto& [k, item] : stated_components(fact.value))
        list.push_back({quantity.vector[k] - evaluator.number(*item, quantity.dimension), quantity.dimension});
    } else {
      const Vector3<Scalar> value = evaluator.vector(fact.value, quantity.dimension);
      for (std::size_t k = 0; k < 3; ++k) list.push_back({quantity.vector[k] - value[k], quantity.dimension});
    }
  } else {
    evaluator.fail(fact.mark, "a fact states a number or a vector");
  }
  return list;
}

}  // namespace

SolvedInstant::SolvedInstant(const Problem& problem, const Settings& settings, const When& when, const OpenChoice& choice)
    : problem_(problem), settings_(settings), choice_(choice), random_(choice.seed) {
  if (problem.has_blow() && !problem.stages.empty())
    fail(problem.file, problem.stages.front().mark, "a problem has stages or something sudden, not both",
         "state the blow in a file of its own, with the motion just before it under instants: {before: {...}}");
  if (problem.stages.empty()) {
    build(0, std::nullopt);
    const auto instants = instants_at(0);
    set_positions(instants);
    solve_velocities(instants, std::nullopt);
    if (when.after_blow) solve_blow();
  } else {
    run_stages(when.stage);
  }
}

void SolvedInstant::build(double time, const std::optional<std::vector<std::string>>& loads) {
  time_ = time;
  std::size_t next = 0;
  // Every building of the machine must take the same values for what is open.
  const AnyValue any = [&](const Dimension& dimension) {
    if (next == any_values_.size()) {
      const double value = choice_.any ? std::uniform_real_distribution<double>(0.5, 2)(random_) : 1;
      any_values_.push_back(value);
    }
    (void)dimension;
    return any_values_[next++];
  };
  data_ = std::make_unique<DataScope<double>>(problem_, settings_, time);
  timed_ = std::make_unique<DataScope<TimeJet>>(problem_, settings_, time_jet(time));
  MachineOptions options;
  options.time = time;
  options.lenient = choice_.trial;
  options.loads = loads;
  if (choice_.gravity) {
    std::mt19937_64 random(choice_.seed + 1);
    std::uniform_real_distribution<double> size(-10, 10);
    options.open_gravity = {size(random), size(random), size(random)};
  }
  machine_ = build_machine(problem_, *data_, *timed_, any, options);
  scales_ = solve::natural_scales(machine_.mechanism);
  moment_.emplace(machine_.mechanism);
  moment_->set_positions(machine_.q);
  motion_.reset();
}

// What is known now: the only instant, or the instants named for the start of the stage.
std::vector<const Instant*> SolvedInstant::instants_at(std::size_t stage) const {
  std::vector<const Instant*> found;
  if (problem_.has_blow()) {
    for (const Instant& instant : problem_.instants) {
      if (instant.name != "before" && instant.name != "after")
        fail(problem_.file, instant.mark, "the instants of a blow are called before and after, not '" + instant.name + "'");
      if (instant.name == "before") found.push_back(&instant);
    }
    return found;
  }
  if (problem_.stages.empty()) {
    if (problem_.instants.size() > 1)
      fail(problem_.file, problem_.instants[1].mark, "the instants '" + problem_.instants[0].name + "' and '" + problem_.instants[1].name + "' need stages that lead from one to the other",
           "state one instant, or name the stages between them");
    for (const Instant& instant : problem_.instants) found.push_back(&instant);
    return found;
  }
  for (const Instant& instant : problem_.instants) {
    bool known = instant.name == "start";
    for (std::size_t k = 0; k < problem_.stages.size(); ++k) {
      const std::string& name = problem_.stages[k].name;
      const bool here = instant.name == name || instant.name == name + ".start" || (k == 0 && instant.name == "start");
      known = known || here;
      if (here && k == stage) found.push_back(&instant);
      if (here && k > 0 && stage == k)
        fail(problem_.file, instant.mark, "what happens at '" + instant.name + "' follows from the stages before it", "state facts at the start of the first stage");
    }
    if (!known) {
      std::vector<std::string> names;
      for (const Stage& s : problem_.stages) names.insert(names.end(), {s.name, s.name + ".start"});
      const std::string hint = did_you_mean(instant.name, names);
      fail(problem_.file, instant.mark, "there is no stage for the instant '" + instant.name + "'", hint.empty() ? "the start of a stage is called STAGE.start" : hint);
    }
  }
  return found;
}

void SolvedInstant::set_positions(const std::vector<const Instant*>& instants) {
  std::vector<double> q = machine_.q;
  std::vector<bool> given = machine_.position_given;
  for (const Instant* instant : instants) {
    for (const Fact& fact : instant->facts) {
      if (level_of(problem_, fact.quantity) != Level::position) continue;
      const Name* name = fact.quantity.as<Name>();
      const NamedCoordinate* coordinate = name && name->primes == 0 ? machine_.coordinate(name->name) : nullptr;
      if (!coordinate) {
        std::vector<std::string> names;
        for (const NamedCoordinate& c : machine_.coordinates)
          if (!c.name.empty()) names.push_back(c.name);
        fail(problem_.file, fact.mark, "'" + to_string(fact.quantity) + "' is no coordinate", did_you_mean(to_string(fact.quantity), names));
      }
      const auto k = static_cast<std::size_t>(coordinate->position);
      const double value = data_->number(fact.value, coordinate->turning ? dimensions::angle : dimensions::length);
      if (given[k] && std::abs(q[k] - value) > 1e-12 * (1 + std::abs(value)))
        fail(problem_.file, fact.mark, "'" + name->name + "' already has another value", "state it once");
      q[k] = value;
      given[k] = true;
    }
  }
  const solve::Closure closure = solve::close_pose(machine_.mechanism, q, given);
  if (closure.gap > 1e-9 * (1 + scales_.length)) {
    Mark mark = problem_.joints.empty() ? Mark{1, 1} : problem_.joints.front().mark;
    for (const Joint& joint : problem_.joints)
      if (closure.where.find("'" + joint.name + "'") != std::string::npos) mark = joint.mark;
    for (const NamedCoordinate& coordinate : machine_.coordinates)
      if (given[static_cast<std::size_t>(coordinate.position)] && q[static_cast<std::size_t>(coordinate.position)] != 0) mark = coordinate.mark;
    char text[200];
    std::snprintf(text, sizeof text, "the mechanism does not close in the stated pose: %s is open by %.3g", closure.where.c_str(), closure.gap);
    fail(problem_.file, mark, text, "the values of the coordinates do not fit together, or no position of the others closes the loop");
  }
  machine_.q = closure.q;
  moment_->set_positions(machine_.q);
  solve::update_contacts(machine_.mechanism, *moment_);
}

double SolvedInstant::natural_unit(const Dimension& d) const {
  return std::pow(scales_.length, d.length / 12.0) * std::pow(scales_.mass, d.mass / 12.0) * std::pow(scales_.time, d.time / 12.0);
}

void SolvedInstant::take_misfits(const solve::LinearSolution& solution) {
  misfits_.insert(misfits_.end(), solution.misfit.begin(), solution.misfit.end());
  misfit_size_ = std::max(misfit_size_, solution.size);
}

// Another member of the family of solutions.
void SolvedInstant::move_along(const solve::LinearSolution& solution, std::vector<double>& values) {
  for (std::size_t d = 0; d < solution.open.size(); ++d) {
    if (d != choice_.direction && choice_.direction != OpenChoice::every) continue;
    const double amount = std::uniform_real_distribution<double>(0.5, 2)(random_);
    for (std::size_t k = 0; k < values.size(); ++k) values[k] += amount * solution.open[d][k];
  }
}

std::vector<solve::Condition> SolvedInstant::rate_conditions() const {
  std::vector<solve::Condition> conditions;
  const auto n = static_cast<std::size_t>(machine_.mechanism.tree.velocity_size());
  for (const StatedRate& rate : machine_.rates) {
    solve::Condition condition{rate.words, std::vector<double>(n), rate.value, rate.turning ? 1 : scales_.length};
    condition.coefficients[static_cast<std::size_t>(rate.velocity)] = 1;
    conditions.push_back(std::move(condition));
  }
  return conditions;
}

// Facts about velocities are linear in them: their coefficients are derivatives, by dual numbers.
std::vector<solve::Condition> SolvedInstant::velocity_facts(const std::vector<const Instant*>& instants) {
  std::vector<solve::Condition> conditions;
  const auto n = static_cast<std::size_t>(machine_.mechanism.tree.velocity_size());
  const Model<Dual<1>> model = convert<Dual<1>>(machine_.mechanism.tree);
  DataScope<Dual<1>> data(problem_, settings_, Dual<1>(time_));
  const auto at = [&](const std::vector<double>& v, std::size_t seed, const Fact& fact) {
    State<Dual<1>> state;
    for (double q : machine_.q) state.q.emplace_back(q);
    for (std::size_t k = 0; k < n; ++k) state.v.push_back(k == seed ? Dual<1>::variable(v[k], 0) : Dual<1>(v[k]));
    QuantityScope<Dual<1>> scope(machine_, model, data, std::move(state));
    scope.set_elsewhere([&](const At& past, const Mark& mark) {
      if (past.instant != "before" || !before_) fail(problem_.file, mark, "a fact can look back to `before` a blow only, not to '" + past.instant + "'");
      QuantityScope<double> earlier(machine_, machine_.mechanism.tree, *data_, before_->state());
      return lifted<Dual<1>>(earlier.value(past.expression));
    });
    return differences(fact, scope, problem_.file);
  };
  for (const Instant* instant : instants) {
    if (instant->rest) {
      for (std::size_t k = 0; k < n; ++k) {
        // Frames move as they state.
        const auto moved = std::find_if(machine_.links.begin(), machine_.links.end(), [&](const solve::CheckLink& link) {
          return static_cast<int>(k) >= link.velocity && static_cast<int>(k) < link.velocity + velocity_size(link.type);
        });
        const auto body = static_cast<std::size_t>(moved - machine_.links.begin());
        const bool frame = std::any_of(problem_.frames.begin(), problem_.frames.end(), [&](const Frame& f) {
          return machine_.index.at(f.name) == static_cast<int>(body);
        });
        if (frame) continue;
        solve::Condition condition{"'" + instant->name + "': rest", std::vector<double>(n), 0, 1};
        condition.coefficients[k] = 1;
        conditions.push_back(std::move(condition));
      }
    }
    for (const Fact& fact : instant->facts) {
      if (level_of(problem_, fact.quantity) != Level::velocity) continue;
      const std::vector<double> zero(n, 0.0);
      const auto base = at(zero, n, fact);
      for (std::size_t i = 0; i < base.size(); ++i)
        conditions.push_back({"'" + instant->name + "': " + to_string(fact.quantity), std::vector<double>(n), -base[i].value.value,
                              natural_unit(base[i].dimension)});
      const std::size_t first = conditions.size() - base.size();
      for (std::size_t k = 0; k < n; ++k) {
        const auto slope = at(zero, k, fact);
        for (std::size_t i = 0; i < slope.size(); ++i) conditions[first + i].coefficients[k] = slope[i].value.partial[0];
      }
      // A fact that is not linear would give one of several motions, silently.
      std::vector<double> other(n);
      std::mt19937_64 random(7);
      for (double& x : other) x = std::uniform_real_distribution<double>(0.5, 1.5)(random);
      const auto there = at(other, n, fact);
      for (std::size_t i = 0; i < there.size(); ++i) {
        double linear = -conditions[first + i].value, size = std::abs(linear);
        for (std::size_t k = 0; k < n; ++k) {
          linear += conditions[first + i].coefficients[k] * other[k];
          size += std::abs(conditions[first + i].coefficients[k] * other[k]);
        }
        if (std::abs(there[i].value.value - linear) > 1e-9 * (size + std::abs(there[i].value.value)))
          fail(problem_.file, fact.mark, "'" + to_string(fact.quantity) + "' is not linear in the velocities: it does not fix them alone",
               "state rates, velocities or momenta");
      }
    }
  }
  return conditions;
}

void SolvedInstant::solve_velocities(const std::vector<const Instant*>& instants, const std::optional<std::vector<double>>& v) {
  facts_ = instants;
  if (v) {
    // Carried over from the stage before; what is stated must still hold.
    v_ = *v;
    velocities_ = {};
    velocities_.value = v_;
    moment_->set_velocities(v_);
    return;
  }
  std::vector<solve::Condition> conditions = rate_conditions();
  for (solve::Condition& condition : velocity_facts(instants)) conditions.push_back(std::move(condition));
  if (problem_.steady) add_steady(conditions, false);
  velocities_ = solve::solve_velocities(*moment_, scales_, conditions, &velocity_equations_);
  if (choice_.trial)
    take_misfits(velocities_);
  else if (!velocities_.conflict.empty())
    contradiction(velocity_equations_, velocities_, false);
  v_ = velocities_.value;
  if (choice_.velocities) move_along(velocities_, v_);
  moment_->set_velocities(v_);
}

void SolvedInstant::solve_blow() {
  before_.emplace(*moment_);
  blow_ = {};
  for (const StatedImpulse& stated : machine_.impulses) {
    solve::KnownImpulse impulse{stated.action, stated.on, SpatialForce<double>::zero(), stated.absorbed, stated.at};
    Vector vector = moment_->on_ground_axes(stated.axes, stated.vector);
    if (stated.relative_to) {
      // The particle's momentum, less what it keeps of it relative to the body.
      const auto center_velocity = [&](int body) {
        if (body == ground) return Vector::zero();
        const double mass = machine_.mechanism.tree.body(body).inertia.mass;
        return mass > 0 ? body_momentum(machine_.mechanism.tree, moment_->workspace(), body, Vector::zero()).linear / mass : Vector::zero();
      };
      const Vector absolute = vector + stated.particle_mass * center_velocity(*stated.relative_to);
      const Vector relative = absolute - stated.particle_mass * center_velocity(stated.on);
      vector = stated.absorbed > 0 ? absolute : (1 - stated.kept) * relative;
    }
    impulse.wrench = stated.couple ? SpatialForce<double>{vector, Vector::zero()}
                                   : SpatialForce<double>{cross(moment_->position(stated.at), vector), vector};
    blow_.impulses.push_back(impulse);
  }
  for (const solve::Impact& impact : machine_.impacts) {
    if (approach(*moment_, impact) >= 0) {
      const auto stated = std::find_if(problem_.impacts.begin(), problem_.impacts.end(), [&](const Impact& i) { return i.name == impact.name; });
      fail(problem_.file, stated->mark, "nothing strikes at impact '" + impact.name + "': before it the two do not approach each other along the push",
           "check the direction under pushes: and the motion before");
    }
    blow_.impacts.push_back(impact);
  }
  for (const Frame& frame : problem_.frames) {
    const auto& body = machine_.mechanism.tree.body(machine_.index.at(frame.name));
    for (int k = 0; k < velocity_size(body.joint); ++k) blow_.held_coordinates.push_back(body.v + k);
  }
  std::vector<const Instant*> after;
  for (const Instant& instant : problem_.instants)
    if (instant.name == "after") after.push_back(&instant);
  const std::vector<solve::Condition> conditions = velocity_facts(after);

  // Cords and pushing contacts act, or give way, as the blow decides: the choice in which none has to push or pull and
  // none is overstretched or pressed in.
  const Mechanism<double>& mechanism = machine_.mechanism;
  std::vector<std::size_t> one_sided;
  for (const Component<double>& component : mechanism.components)
    if (component.one_sided) one_sided.push_back(static_cast<std::size_t>(component.action));
  if (one_sided.size() > 12) fail(problem_.file, {1, 1}, "more than 12 cords and contacts in one blow are too many");
  const std::size_t n = static_cast<std::size_t>(mechanism.tree.velocity_size());
  const double impulse_unit = natural_unit(dimensions::momentum);
  for (std::size_t choice = 0; choice < (std::size_t{1} << one_sided.size()); ++choice) {
    std::vector<bool> acting(mechanism.actions.size(), true);
    for (std::size_t k = 0; k < one_sided.size(); ++k) acting[one_sided[k]] = !(choice >> k & 1);
    solve::LinearSystem equations;
    solve::LinearSolution solution = solve::solve_impulse(*before_, scales_, blow_, conditions, acting, &equations);
    const bool last = choice + 1 == (std::size_t{1} << one_sided.size());
    double largest = 0;
    for (std::size_t k = n; k < solution.value.size(); ++k) largest = std::max(largest, std::abs(solution.value[k]));
    bool good = choice_.trial || solution.conflict.empty();
    for (std::size_t k = 0; good && k < mechanism.components.size(); ++k) {
      const auto action = static_cast<std::size_t>(mechanism.components[k].action);
      if (mechanism.components[k].one_sided && acting[action]) good = solution.value[n + k] >= -1e-9 * (largest + 1e-6 * impulse_unit);
    }
    for (std::size_t i = 0; good && i < mechanism.constraints.size(); ++i) {
      const VelocityConstraint<double>& constraint = mechanism.constraints[i];
      if (constraint.action < 0 || acting[static_cast<std::size_t>(constraint.action)]) continue;
      const std::vector<double> row = solve::constraint_coefficients(*before_, constraint);
      double rate = 0, size = 0;
      for (std::size_t k = 0; k < n; ++k) {
        rate += row[k] * solution.value[k];
        size += std::abs(row[k] * solution.value[k]);
      }
      good = constraint.kind == VelocityConstraintKind::cord_length ? rate <= 1e-9 * size : rate >= -1e-9 * size;
    }
    if (!good && !last && !choice_.trial) continue;
    blow_equations_ = std::move(equations);
    blow_solution_ = std::move(solution);
    if (choice_.trial) take_misfits(blow_solution_);
    if (!good && !choice_.trial) {
      if (one_sided.empty()) contradiction(blow_equations_, blow_solution_, true);
      fail(problem_.file, {1, 1}, "no motion after the blow fits: whichever cords and contacts act, one would have to push or pull the wrong way");
    }
    break;
  }
  impulses_ = blow_solution_.value;
  if (choice_.forces) move_along(blow_solution_, impulses_);
  for (std::size_t k = 0; k < blow_.impacts.size(); ++k)
    if (impulses_[impulses_.size() - blow_.impacts.size() + k] < -1e-9 * impulse_unit && !choice_.forces)
      fail(problem_.file, {1, 1}, "the impact '" + blow_.impacts[k].name + "' would have to pull", "check the direction under pushes:");
  v_.assign(impulses_.begin(), impulses_.begin() + static_cast<std::ptrdiff_t>(n));
  moment_->set_velocities(v_);
}

std::vector<solve::Condition> SolvedInstant::force_conditions() {
  std::vector<solve::Condition> conditions;
  const std::size_t n = solve::force_unknowns(machine_.mechanism).size();
  for (const StatedRate& rate : machine_.accelerations) {
    solve::Condition condition{rate.words, std::vector<double>(n), rate.value, rate.turning ? 1 : scales_.length};
    condition.coefficients[static_cast<std::size_t>(rate.velocity)] = 1;
    conditions.push_back(std::move(condition));
  }
  // Facts about accelerations and forces are linear in these unknowns: their values at zero and at each unit.
  const auto at = [&](const std::vector<double>& unknowns, const Fact& fact) {
    QuantityScope<double> quantities(machine_, machine_.mechanism.tree, *data_, State<double>{machine_.q, v_});
    const auto count = static_cast<std::ptrdiff_t>(machine_.mechanism.tree.velocity_size());
    quantities.set_accelerations(std::vector<double>(unknowns.begin(), unknowns.begin() + count));
    quantities.set_forces(&*moment_, &unknowns);
    return differences(fact, quantities, problem_.file);
  };
  for (const Instant* instant : facts_) {
    for (const Fact& fact : instant->facts) {
      if (level_of(problem_, fact.quantity) != Level::force) continue;
      std::vector<double> unknowns(n, 0.0);
      const auto base = at(unknowns, fact);
      const std::size_t first = conditions.size();
      for (const auto& difference : base)
        conditions.push_back({"'" + instant->name + "': " + to_string(fact.quantity), std::vector<double>(n), -difference.value, natural_unit(difference.dimension)});
      for (std::size_t k = 0; k < n; ++k) {
        unknowns[k] = 1;
        const auto one = at(unknowns, fact);
        for (std::size_t i = 0; i < one.size(); ++i) conditions[first + i].coefficients[k] = one[i].value - base[i].value;
        unknowns[k] = 0;
      }
    }
  }
  if (problem_.steady) add_steady(conditions, true);
  return conditions;
}

bool SolvedInstant::hangs_on(int body, int ancestor) const {
  for (int i = body; i != ground; i = machine_.mechanism.tree.body(i).parent)
    if (i == ancestor) return true;
  return ancestor == ground;
}

// Rest relative to a frame with constant spins: the coordinates of bodies that hang on it do not change, but those of
// bodies of revolution about their own axes; other bodies have the frame's angular velocity and their spin, and their
// mass centers go with it.
void SolvedInstant::add_steady(std::vector<solve::Condition>& conditions, bool accelerations) const {
  const Steady& steady = *problem_.steady;
  const Model<double>& tree = machine_.mechanism.tree;
  const int frame = machine_.index.at(steady.frame);
  const std::size_t size = accelerations ? solve::force_unknowns(machine_.mechanism).size() : static_cast<std::size_t>(tree.velocity_size());
  const std::string words = "steady motion in '" + steady.frame + "'";
  const auto stated = [&](const std::vector<StatedRate>& list, int k) {
    return std::any_of(list.begin(), list.end(), [&](const StatedRate& rate) { return rate.velocity == k; });
  };
  const auto rides = std::find_if(problem_.frames.begin(), problem_.frames.end(), [&](const Frame& f) { return f.name == steady.frame; });
  const Workspace<double>& w = moment_->workspace();
  const BodyMotion<double>& F = w.motion[static_cast<std::size_t>(frame + 1)];
  for (int i = 0; i < tree.body_count(); ++i) {
    const auto& body = tree.body(i);
    const std::string& name = tree.name(i);
    const bool is_frame = std::any_of(problem_.frames.begin(), problem_.frames.end(), [&](const Frame& f) { return machine_.index.at(f.name) == i; });
    if (is_frame || i == frame) continue;
    const auto spin = std::find_if(steady.spins.begin(), steady.spins.end(), [&](const Spin& s) { return s.body == name; });
    if (hangs_on(i, frame) && frame != ground && spin == steady.spins.end()) {
      for (int k = body.v; k < body.v + velocity_size(body.joint); ++k) {
        if (stated(accelerations ? machine_.accelerations : machine_.rates, k)) continue;
        if (!accelerations && stated(machine_.accelerations, k)) continue;
        // A body of revolution may turn about its own axis unseen.
        if (!accelerations && turns_unseen(i)) continue;
        solve::Condition condition{words, std::vector<double>(size), 0, 1};
        condition.coefficients[static_cast<std::size_t>(k)] = 1;
        conditions.push_back(std::move(condition));
      }
      continue;
    }
    if (!machine_.mechanism.takes_part[static_cast<std::size_t>(i)]) continue;
    if (hangs_on(frame, i)) continue;  // it carries the frame
    // w = W + s u, alpha = dW/dt + W x s u; the mass center goes with the frame.
    Vector spin_vector = Vector::zero();
    if (spin != steady.spins.end()) spin_vector = data_->number(spin->rate, dimensions::angular_velocity) * data_->direction(spin->about);
    const bool rides_here = rides != problem_.frames.end() && rides->rides_on == name;
    const double mass = body.inertia.mass;
    const Vector G = mass > 0 ? body_mass_center(tree, w, i) : w.motion[static_cast<std::size_t>(i + 1)].p;
    const Vector r = G - F.p;
    for (std::size_t k = 0; k < 6; ++k) {
      const bool angular = k < 3;
      if (!angular && rides_here) break;
      const std::size_t c = k % 3;
      solve::Condition condition{words, std::vector<double>(size), 0, angular ? 1 : scales_.length};
      const auto add = [&](int moved, double sign, const Vector& p) {
        for_each_coordinate_motion(tree, w, moved, p, [&](int coordinate, const SpatialMotion<double>& S) {
          condition.coefficients[static_cast<std::size_t>(coordinate)] += sign * (angular ? S.angular[c] : S.linear[c]);
        });
      };
      add(i, 1, G);
      add(frame, -1, G);
      if (!accelerations) {
        condition.value = angular ? spin_vector[c] : 0;
      } else {
        // What the velocities bring, with all accelerations of coordinates zero.
        const BodyMotion<double>& B = w.motion[static_cast<std::size_t>(i + 1)];
        const Vector own = B.a + cross(B.alpha, G - B.p) + cross(B.w, cross(B.w, G - B.p));
        const Vector carried = F.a + cross(F.alpha, r) + cross(F.w, cross(F.w, r));
        condition.value = angular ? (F.alpha + cross(F.w, spin_vector) - B.alpha)[c] : (carried - own)[c];
      }
      conditions.push_back(std::move(condition));
    }
  }
}

// Whether a body is one of revolution about the axis of its own joint, its mass center on it.
bool SolvedInstant::turns_unseen(int body) const {
  const auto& link = machine_.mechanism.tree.body(body);
  if (link.joint != JointType::revolute || !(link.inertia.mass > 0)) return false;
  // On the working axes the joint's axis is z.
  const SpatialInertia<double>& I = link.inertia;
  const Vector c = I.first_moment / I.mass;
  const SymmetricMatrix3<double> central = I.inertia - I.mass * unit_mass_inertia(c);
  const double size = central.xx + central.yy + central.zz, off = std::abs(c.x) + std::abs(c.y);
  return off <= 1e-9 * (scales_.length + std::abs(c.z)) && std::abs(central.xx - central.yy) <= 1e-9 * size &&
         std::abs(central.xy) + std::abs(central.yz) + std::abs(central.zx) <= 1e-9 * size;
}

void SolvedInstant::solve_forces() {
  if (motion_) return;
  for (const VelocityConstraint<double>& constraint : machine_.mechanism.constraints)
    if (constraint.shape_unknown) {
      const std::string& name = machine_.mechanism.actions[static_cast<std::size_t>(constraint.action)].name;
      const auto contact = std::find_if(problem_.contacts.begin(), problem_.contacts.end(), [&](const Contact& c) { return c.name == name; });
      fail(problem_.file, contact->mark, "how the point of contact '" + name + "' moves is not known: the surfaces there are no circle, sphere or corner on a plane",
           "velocities can be asked; for forces and accelerations give the body a round shape, or its inertia by axis:, axial:, transverse:");
    }
  motion_ = solve::solve_motion(*moment_, scales_, force_conditions(), &motion_equations_);
  if (choice_.trial)
    take_misfits(*motion_);
  else if (!motion_->conflict.empty())
    contradiction(motion_equations_, *motion_, true);
  unknowns_ = motion_->value;
  if (choice_.forces) move_along(*motion_, unknowns_);
  const auto n = static_cast<std::ptrdiff_t>(machine_.mechanism.tree.velocity_size());
  moment_->set_accelerations(std::vector<double>(unknowns_.begin(), unknowns_.begin() + n));
}

// The motion from the first stage's start to the start of stage `count`.
void SolvedInstant::run_stages(std::size_t count) {
  build(0, problem_.stages[0].loads);
  const auto instants = instants_at(0);
  for (std::size_t k = 1; k < problem_.stages.size(); ++k) instants_at(k);
  set_positions(instants);
  solve_velocities(instants, std::nullopt);
  if (!velocities_.open.empty() && count > 0)
    fail(problem_.file, problem_.stages[0].mark, "the motion at the start of stage '" + problem_.stages[0].name + "' is not fixed: " +
             velocity_equations_.name(velocities_.share.front().front()) + " is unknown",
         "state it under instants: {" + problem_.stages[0].name + ".start: {...}}");
  const auto n_q = machine_.q.size();
  for (std::size_t stage = 0; stage < count; ++stage) {
    const Stage& now = problem_.stages[stage];
    if (!now.lasts) fail(problem_.file, now.mark, "stage '" + now.name + "' does not say how long it lasts", "write lasts: 2 s");
    const double duration = data_->number(*now.lasts, dimensions::time);
    if (!(duration >= 0)) fail(problem_.file, now.lasts->mark(), "a stage lasts no negative time");
    // Coordinates and velocities together; a controlled method of order eight.
    std::vector<double> y = machine_.q;
    y.insert(y.end(), v_.begin(), v_.end());
    const double start = time_;
    const auto derivative = [&](const std::vector<double>& state, std::vector<double>& rate, double time) {
      const std::vector<double> q(state.begin(), state.begin() + static_cast<std::ptrdiff_t>(n_q));
      const std::vector<double> v(state.begin() + static_cast<std::ptrdiff_t>(n_q), state.end());
      rate.resize(state.size());
      position_rate<double>(machine_.mechanism.tree, q, v, std::span<double>(rate.data(), n_q));
      const std::vector<double> a = accelerations_at(time, q, v, stage);
      std::copy(a.begin(), a.end(), rate.begin() + static_cast<std::ptrdiff_t>(n_q));
    };
    namespace odeint = boost::numeric::odeint;
    auto stepper = odeint::make_controlled<odeint::runge_kutta_fehlberg78<std::vector<double>>>(1e-12, 1e-12);
    if (duration > 0) {
      constexpr int most_steps = 100'000;
      int steps = 0;
      odeint::integrate_adaptive(stepper, derivative, y, start, start + duration, duration / 100,
                                 [&](const std::vector<double>&, double) {
                                   if (++steps > most_steps)
                                     fail(problem_.file, now.mark, "stage '" + now.name + "' needs more than 100 000 steps", "let it last shorter");
                                 });
    }
    build(start + duration, problem_.stages[stage + 1].loads);
    machine_.q.assign(y.begin(), y.begin() + static_cast<std::ptrdiff_t>(n_q));
    moment_->set_positions(machine_.q);
    solve_velocities({}, std::vector<double>(y.begin() + static_cast<std::ptrdiff_t>(n_q), y.end()));
  }
}

std::vector<double> SolvedInstant::accelerations_at(double time, const std::vector<double>& q, const std::vector<double>& v, std::size_t stage) {
  build(time, problem_.stages[stage].loads);
  machine_.q = q;
  v_ = v;
  moment_->set_positions(q);
  moment_->set_velocities(v);
  solve_forces();
  for (std::size_t k = 0; k < v.size(); ++k)
    if (!motion_->determined(k))
      fail(problem_.file, problem_.stages[stage].mark, "the motion in stage '" + problem_.stages[stage].name + "' is not determined: the " + motion_equations_.name(k) + " is open");
  return moment_->accelerations();
}

void SolvedInstant::contradiction(const solve::LinearSystem& equations, const solve::LinearSolution& solution, bool forces) {
  std::vector<std::string> names;
  Mark mark{1, 1};
  std::optional<Mark> fact_mark;
  for (std::size_t equation : solution.conflict) {
    const std::string& words = equations.words(equation);
    if (std::find(names.begin(), names.end(), words) == names.end()) names.push_back(words);
  }
  for (const auto* list : {&machine_.rates, &machine_.accelerations})
    for (const StatedRate& rate : *list)
      if (std::find(names.begin(), names.end(), rate.words) != names.end()) mark = rate.mark;
  for (const Instant* instant : facts_)
    for (const std::string& name : names) {
      if (name.starts_with("'" + instant->name + "'")) mark = instant->mark;
      for (const Fact& fact : instant->facts)
        if (name == "'" + instant->name + "': " + to_string(fact.quantity)) fact_mark = fact.mark;
    }
  if (fact_mark) mark = *fact_mark;
  std::string all;
  for (std::size_t i = 0; i < names.size() && i < 8; ++i) all += (all.empty() ? "" : "; ") + names[i];
  if (names.size() > 8) all += "; ...";
  const bool only_balance = forces && std::all_of(names.begin(), names.end(), [](const std::string& name) {
    return name.starts_with("forces on ") || name.starts_with("moments on ");
  });
  if (only_balance) {
    if (mark.line == 1 && !problem_.joints.empty()) mark = problem_.joints.front().mark;
    fail(problem_.file, mark, "nothing carries what the motion needs: " + all,
         "let a support or contact carry it, or leave a freedom for it");
  }
  fail(problem_.file, mark, std::string("these cannot all hold together: ") + all, "correct or remove one of them");
}

QuantityScope<double> SolvedInstant::scope_for(const Expression& expression, const std::optional<Expression>& axes,
                                               const Elsewhere& elsewhere) {
  if (level_of(problem_, expression) == Level::force) solve_forces();
  QuantityScope<double> quantities(machine_, machine_.mechanism.tree, *data_, State<double>{machine_.q, v_});
  if (motion_) {
    quantities.set_accelerations(moment_->accelerations());
    quantities.set_forces(&*moment_, &unknowns_);
  }
  if (before_) quantities.set_blow(&*before_, &blow_, &impulses_);
  if (axes) quantities.set_axes(*axes);
  if (elsewhere) quantities.set_elsewhere(elsewhere);
  return quantities;
}

Value<double> SolvedInstant::raw(const Expression& expression, const std::optional<Expression>& axes, const Elsewhere& elsewhere) {
  return scope_for(expression, axes, elsewhere).value(expression);
}

Value<double> SolvedInstant::ask(const Expression& expression, const std::optional<Expression>& axes, const Elsewhere& elsewhere) {
  QuantityScope<double> quantities = scope_for(expression, axes, elsewhere);
  Value<double> value = quantities.value(expression);
  const auto on_axes = [&](const auto& self, Value<double>& v) -> void {
    if (v.is_vector()) v.vector = transpose_times(quantities.axes(), v.vector);
    for (Value<double>& item : v.items) self(self, item);
  };
  on_axes(on_axes, value);
  return value;
}

double SolvedInstant::natural_size(const Dimension& d) const {
  // Only what grows with the pace of the motion has a size that rounding is measured by; of a thing at rest that is none.
  if (d.time > 0) return 0;
  double pace = 0;
  for (const BodyMotion<double>& motion : moment_->workspace().motion) {
    pace = std::max({pace, norm(motion.w), norm(motion.v) / scales_.length});
    pace = std::max({pace, std::sqrt(norm(motion.alpha)), std::sqrt(norm(motion.a) / scales_.length)});
  }
  pace = std::max(pace, std::sqrt(norm(machine_.mechanism.tree.gravity()) / scales_.length));
  // Forces that balance each other set a pace as well.
  if (motion_)
    for (std::size_t i = 0; i < machine_.mechanism.actions.size(); ++i) {
      const SpatialForce<double> wrench = solve::action_wrench(*moment_, unknowns_, i);
      const double force = std::max(norm(wrench.force), norm(wrench.moment) / scales_.length);
      pace = std::max(pace, std::sqrt(force / (scales_.mass * scales_.length)));
    }
  return natural_unit(d) * (d.time == 0 ? 1 : std::pow(pace, -d.time / 12.0));
}

std::vector<std::string> SolvedInstant::unphysical() const {
  std::vector<std::string> found;
  const Mechanism<double>& mechanism = machine_.mechanism;
  const std::size_t first = solve::force_unknowns(mechanism).accelerations;
  const double force_unit = natural_unit(dimensions::force);
  for (std::size_t k = 0; k < mechanism.components.size(); ++k) {
    const Component<double>& component = mechanism.components[k];
    const Action& action = mechanism.actions[static_cast<std::size_t>(component.action)];
    if (!component.one_sided) continue;
    double largest = 1e-9 * force_unit;
    for (std::size_t j = 0; j < mechanism.components.size(); ++j)
      if (!mechanism.components[j].couple) largest = std::max(largest, 1e-9 * std::abs(unknowns_[first + j]));
    if (unknowns_[first + k] >= -largest) continue;
    found.push_back(action.kind == ActionKind::cord ? "the cord '" + action.name + "' would have to push: it goes slack"
                                                    : "the contact '" + action.name + "' would have to pull: it is lost");
  }
  return found;
}

SolvedInstant::Residuals SolvedInstant::check() const {
  Residuals residuals;
  std::vector<solve::CheckBody> bodies;
  double impulse_size = 0, impulse_moment_size = 0, impulse_misfit = 0, impulse_moment_misfit = 0;
  const Mechanism<double>& mechanism = machine_.mechanism;
  std::vector<double> a(v_.size(), 0.0);
  if (motion_) a = moment_->accelerations();
  for (const auto& [index, mass] : machine_.masses) {
    solve::CheckBody body;
    body.link = index;
    body.particles = mass.particles;
    const Momentum<double> momentum = body_momentum(mechanism.tree, moment_->workspace(), index, Vector::zero());
    body.momentum = momentum.linear;
    body.angular_momentum = momentum.angular;
    body.kinetic_energy = body_kinetic_energy(mechanism.tree, moment_->workspace(), index);
    body.forces_known = motion_.has_value();
    if (motion_) {
      const double m = mechanism.tree.body(index).inertia.mass;
      body.wrench = SpatialForce<double>::zero();
      if (m > 0) {
        const Vector weight = m * mechanism.tree.gravity();
        body.wrench = {cross(body_mass_center(mechanism.tree, moment_->workspace(), index), weight), weight};
        body.force_size = norm(weight);
      }
      for (std::size_t i = 0; i < mechanism.actions.size(); ++i) {
        const Action& action = mechanism.actions[i];
        if (action.on != index && action.from != index) continue;
        const SpatialForce<double> wrench = solve::action_wrench(*moment_, unknowns_, i);
        body.force_size += norm(wrench.force);
        body.moment_size += norm(wrench.moment);
        if (action.on == index) body.wrench += wrench;
        if (action.from == index) body.wrench += -1.0 * wrench;
      }
    }
    if (before_) {
      const Momentum<double> earlier = body_momentum(mechanism.tree, before_->workspace(), index, Vector::zero());
      SpatialForce<double> given = SpatialForce<double>::zero();
      for (std::size_t i = 0; i < mechanism.actions.size(); ++i) {
        const Action& action = mechanism.actions[i];
        if (action.on != index && action.from != index) continue;
        const SpatialForce<double> wrench = solve::action_impulse(*before_, blow_, impulses_, i);
        impulse_size = std::max(impulse_size, norm(wrench.force));
        impulse_moment_size = std::max(impulse_moment_size, norm(wrench.moment));
        given += (action.on == index ? 1.0 : -1.0) * wrench;
      }
      impulse_size = std::max(impulse_size, norm(momentum.linear));
      impulse_moment_size = std::max(impulse_moment_size, norm(momentum.angular));
      impulse_misfit = std::max(impulse_misfit, norm(momentum.linear - earlier.linear - given.force));
      impulse_moment_misfit = std::max(impulse_moment_misfit, norm(momentum.angular - earlier.angular - given.moment));
    }
    bodies.push_back(std::move(body));
  }
  if (impulse_size > 0) residuals.impulse = impulse_misfit / impulse_size;
  impulse_moment_size = std::max(impulse_moment_size, impulse_size * scales_.length);
  if (impulse_moment_size > 0) residuals.impulse = std::max(residuals.impulse, impulse_moment_misfit / impulse_moment_size);
  residuals.particles = solve::check_with_particles(machine_.links, bodies, machine_.q, v_, a);
  return residuals;
}

}  // namespace poinsot::statement
