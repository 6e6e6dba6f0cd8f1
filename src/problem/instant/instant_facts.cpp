// Facts about rates, velocities, accelerations and forces as linear conditions, if they are linear.
#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <set>
#include <type_traits>

#include "problem/instant/instant.h"
#include "problem/instant/instant_conditions.h"
#include "problem/instant/linear_facts.h"
#include "problem/language/diagnostic.h"
#include "problem/language/exact_numbers.h"
#include "problem/language/expression_walk.h"
#include "problem/language/scalar_value.h"
#include "problem/quantities/asks_model.h"
#include "problem/quantities/joint_pressing.h"

namespace poinsot::problem {
namespace {

template <class Scalar>
State<Scalar> at_rest(const InstantView<Scalar>& view) {
  return {view.machine.q, std::vector<Scalar>(static_cast<std::size_t>(view.machine.mechanism.tree.velocity_size()))};
}

std::string words_of(const Instant& instant, const Fact& fact) {
  return "'" + instant.name + "': " + to_string(fact.quantity);
}

// Adds the rates, or the accelerations, that joints and frames state; n: the number of unknowns.
template <class Scalar>
void add_rates(const InstantView<Scalar>& view, const std::vector<StatedRateOf<Scalar>>& rates, std::size_t n,
               StatedConditions<Scalar>& conditions) {
  for (const StatedRateOf<Scalar>& rate : rates) {
    solve::ConditionOf<Scalar> condition{rate.words, std::vector<Scalar>(n), rate.value,
                                         rate.turning ? 1 : view.scales.length};
    condition.coefficients[static_cast<std::size_t>(rate.velocity)] = Scalar(1);
    conditions.add(std::move(condition), {rate.mark});
  }
}

// Adds the laws of friction in joints that move, by what presses in them.
template <class Scalar>
void add_joint_friction(const InstantView<Scalar>& view, StatedConditions<Scalar>& conditions) {
  for (const RoughContactOf<Scalar>& contact : view.machine.rough_contacts) {
    if (!contact.found_with_reactions()) continue;
    const Mark& mark = std::ranges::find(view.situation.contacts, contact.name, &Contact::name)->friction->mark;
    for (const RubbingWay<Scalar>& way : contact.ways) {
      const bool couple = view.machine.mechanism.drives[way.drive].turning;
      conditions.add({"friction of joint '" + contact.name + "'", friction_by_load(view.mechanism_state, contact, way),
                      effort_without_load(view.mechanism_state, contact, way),
                      natural_unit(view.scales, couple ? dimensions::moment : dimensions::force)},
                     {mark});
    }
  }
}

// Adds a fact by its linear conditions, if it has such.
template <class Scalar>
void add_fact(const Instant& instant, const Fact& fact, std::optional<Conditions<Scalar>> found,
              StatedConditions<Scalar>& conditions) {
  if (!found) {
    conditions.nonlinear.push_back(&fact);
    return;
  }
  for (solve::ConditionOf<Scalar>& condition : *found)
    conditions.add(std::move(condition), {fact.mark, &instant, &fact});
}

// Whether an expression asks for impulses, directly or by a name.
bool asks_impulses(const Situation& situation, const Expression& expression, int depth = 0) {
  std::set<std::string> functions, names;
  collect_functions(expression, functions, true);
  if (functions.contains("impulse") || functions.contains("impulsive_couple")) return true;
  collect_names(expression, names);
  return depth < 200 && std::any_of(situation.define.begin(), situation.define.end(), [&](const NamedExpression& item) {
           return names.contains(item.name) && asks_impulses(situation, item.value, depth + 1);
         });
}

// Whether what an expression asks of the model goes into a function with a corner. It may be linear on either side of
// it, so that places on one side do not tell.
bool has_corner(const Situation& situation, const Expression& expression, int depth = 0) {
  const Call* call = expression.as<Call>();
  static const std::set<std::string> corners{"abs", "norm", "max", "min", "acute_angle"};
  if (call && corners.contains(call->function) && asks_model(situation, expression)) return true;
  if (const Name* name = expression.as<Name>(); name && depth < 200)
    for (const NamedExpression& item : situation.define)
      if (item.name == name->name && has_corner(situation, item.value, depth + 1)) return true;
  return any_child(expression, [&](const Expression& child) { return has_corner(situation, child, depth); });
}
bool has_corner(const Situation& situation, const Fact& fact) {
  return has_corner(situation, fact.quantity) || has_corner(situation, fact.value);
}

}  // namespace

double natural_unit(const solve::Scales& scales, const Dimension& d) {
  return std::pow(scales.length, d.length / 12.0) * std::pow(scales.mass, d.mass / 12.0) *
         std::pow(scales.time, d.time / 12.0);
}

template <class Scalar, class Base>
std::vector<Difference<Scalar>> differences(const Fact& fact, QuantityScope<Scalar, Base>& scope,
                                            const std::string& file) {
  const Evaluator<Scalar> evaluator(scope, file);
  const Value<Scalar> quantity = evaluator(fact.quantity);
  std::vector<Difference<Scalar>> list;
  if (is_any(fact.value)) return list;
  if (quantity.is_number()) {
    list.push_back(
        {quantity.number - evaluator.number(fact.value, quantity.dimension), quantity.dimension, quantity.number});
  } else if (quantity.is_vector()) {
    list.reserve(3);
    if (const List* components = fact.value.as<List>(); components && components->items.size() == 3) {
      for (std::size_t k = 0; k < 3; ++k)
        if (const Expression& item = components->items[k]; !is_any(item))
          list.push_back({quantity.vector[k] - evaluator.number(item, quantity.dimension), quantity.dimension,
                          quantity.vector[k]});
    } else {
      const Vector3<Scalar> value = evaluator.vector(fact.value, quantity.dimension);
      for (std::size_t k = 0; k < 3; ++k)
        list.push_back({quantity.vector[k] - value[k], quantity.dimension, quantity.vector[k]});
    }
  } else {
    const List* stated = fact.value.as<List>();
    const std::vector<Value<Scalar>>& items = quantity.items;
    const auto is_number = [](const Value<Scalar>& item) { return item.is_number(); };
    if (!quantity.is_list() || !std::ranges::all_of(items, is_number))
      evaluator.fail(fact.mark, "a fact states a number, a vector or a list of numbers");
    if (!stated || stated->items.size() != items.size())
      evaluator.fail(
          fact.mark, "this is a list of " + std::to_string(items.size()) + " numbers",
          "state as many, any for those that are not known, or one of them: " + to_string(fact.quantity) + "[1]");
    for (std::size_t k = 0; k < items.size(); ++k)
      if (const Expression& item = stated->items[k]; !is_any(item))
        list.push_back(
            {items[k].number - evaluator.number(item, items[k].dimension), items[k].dimension, items[k].number});
  }
  return list;
}

namespace {

// Adds rest and facts about velocities. Coefficients are derivatives by dual numbers. For impulses they are
// differences, which are exact for linear conditions.
template <class Scalar>
void add_velocity_facts(const InstantView<Scalar>& view, const std::vector<const Instant*>& instants,
                        const solve::BlowOf<Scalar>* blow, StatedConditions<Scalar>& conditions) {
  using Varied = Dual<1, Scalar>;
  const MachineOf<Scalar>& machine = view.machine;
  if (instants.empty()) return;
  const auto n = static_cast<std::size_t>(machine.mechanism.tree.velocity_size());
  const Model<Scalar>& tree = blow ? machine.tree_after_blow() : machine.mechanism.tree;
  const Model<Varied> model = convert<Varied>(tree);
  DataScope<Varied> data(view.situation, view.data.settings(), Varied(view.time));
  data.vary_as(view.data);
  const auto earlier = [&](const At& past, const Mark& mark) {
    if (past.instant != "before" || !view.before)
      fail(view.situation.file, mark, "a fact can look back to `before` a blow only, not to '" + past.instant + "'");
    QuantityScope<Scalar> scope(machine, machine.mechanism.tree, view.data, view.before->state());
    scope.set_flying(flying_particles<Scalar>(view.situation, machine, *view.before, nullptr));
    return scope.value(past.expression);
  };
  const ProbePlaces<Scalar> velocities(n);
  const auto scope_at_velocities = [&](const std::vector<Scalar>& v, std::optional<std::size_t> seed) {
    State<Varied> state;
    state.q.reserve(machine.q.size());
    state.v.reserve(n);
    for (const Scalar& q : machine.q) state.q.emplace_back(q);
    for (std::size_t k = 0; k < n; ++k) state.v.push_back(k == seed ? Varied::variable(v[k], 0) : Varied(v[k]));
    auto scope = std::make_unique<QuantityScope<Varied, Scalar>>(machine, model, data, std::move(state));
    if (blow && !view.situation.strikes.empty())
      scope->set_flying(flying_particles(view.situation, machine, *view.before, blow));
    scope->set_elsewhere([&](const At& past, const Mark& mark) { return lifted<Varied>(earlier(past, mark)); });
    return scope;
  };
  using Scopes = NumberedScopes<QuantityScope<Varied, Scalar>>;
  Scopes at_places([&](std::size_t place) { return scope_at_velocities(velocities[place], std::nullopt); });
  Scopes varied_at_rest(
      [&](std::size_t coordinate) { return scope_at_velocities(velocities[ProbePlaces<Scalar>::zero], coordinate); });
  const auto linear_in_velocities = [&](const Instant& instant, const Fact& fact) {
    return as_linear<Scalar>(
        words_of(instant, fact), view.scales, velocities,
        [&](std::size_t place) {
          std::vector<Difference<Scalar>> values;
          for (const Difference<Varied>& difference : differences(fact, at_places[place], view.situation.file))
            values.push_back({difference.value.value, difference.dimension});
          return values;
        },
        [&](std::size_t k, const std::vector<Difference<Scalar>>&) {
          std::vector<Scalar> slopes;
          for (const Difference<Varied>& difference : differences(fact, varied_at_rest[k], view.situation.file))
            slopes.push_back(difference.value.partial[0]);
          return slopes;
        },
        std::min(1.0, view.scales.length));
  };
  const auto linear_in_impulses = [&](const Instant& instant, const Fact& fact) {
    const ProbePlaces<Scalar> places(solve::impulse_unknowns(machine.mechanism, *blow).size());
    return as_linear<Scalar>(words_of(instant, fact), view.scales, places, [&](std::size_t place) {
      const std::vector<Scalar> x = places[place];
      const std::vector<Scalar> v(x.begin(), x.begin() + static_cast<std::ptrdiff_t>(n));
      QuantityScope<Scalar> scope(machine, tree, view.data, State<Scalar>{machine.q, v});
      if (!view.situation.strikes.empty())
        scope.set_flying(flying_particles(view.situation, machine, *view.before, blow));
      scope.set_elsewhere(earlier);
      scope.set_blow(view.before, blow, &x);
      return differences(fact, scope, view.situation.file);
    });
  };
  for (const Instant* instant : instants) {
    if (instant->rest) {
      for (std::size_t k = 0; k < n; ++k) {
        // The motion of frames is stated by themselves and not by these facts.
        const auto moved = std::find_if(machine.links.begin(), machine.links.end(), [&](const solve::CheckLink& link) {
          return static_cast<int>(k) >= link.velocity && static_cast<int>(k) < link.velocity + velocity_size(link.type);
        });
        const auto body = static_cast<std::size_t>(moved - machine.links.begin());
        const bool frame = std::any_of(view.situation.frames.begin(), view.situation.frames.end(), [&](const Frame& f) {
          return machine.index.at(f.name) == static_cast<int>(body);
        });
        if (frame) continue;
        solve::ConditionOf<Scalar> condition{"'" + instant->name + "': rest", std::vector<Scalar>(n), Scalar(0), 1};
        condition.coefficients[k] = Scalar(1);
        conditions.add(std::move(condition), {instant->mark, instant});
      }
    }
    for (const Fact& fact : instant->facts) {
      if (level_of(view.situation, fact.quantity) != Level::velocity) continue;
      const bool impulses =
          blow && (asks_impulses(view.situation, fact.quantity) || asks_impulses(view.situation, fact.value));
      add_fact(*instant, fact,
               has_corner(view.situation, fact) ? std::nullopt
               : impulses                       ? linear_in_impulses(*instant, fact)
                                                : linear_in_velocities(*instant, fact),
               conditions);
    }
  }
}

}  // namespace

template <class Scalar>
std::vector<std::pair<const Fact*, Difference<Scalar>>> position_differences(
    const InstantView<Scalar>& view, const std::vector<const Instant*>& instants) {
  std::vector<std::pair<const Fact*, Difference<Scalar>>> all;
  for (const Instant* instant : instants)
    for (const Fact& fact : instant->facts) {
      if (level_of(view.situation, fact.quantity) != Level::position || fact.quantity.as<Name>()) continue;
      QuantityScope<Scalar> scope(view.machine, view.machine.mechanism.tree, view.data, at_rest(view));
      for (Difference<Scalar>& difference : differences(fact, scope, view.situation.file))
        all.emplace_back(&fact, std::move(difference));
    }
  return all;
}

template <class Scalar>
StatedConditions<Scalar> velocity_conditions(const InstantView<Scalar>& view,
                                             const std::vector<const Instant*>& instants) {
  StatedConditions<Scalar> conditions;
  add_rates(view, view.machine.rates, static_cast<std::size_t>(view.machine.mechanism.tree.velocity_size()),
            conditions);
  add_velocity_facts<Scalar>(view, instants, nullptr, conditions);
  if (view.situation.steady) add_steady(view, false, conditions);
  return conditions;
}

template <class Scalar>
StatedConditions<Scalar> blow_conditions(const InstantView<Scalar>& view, const solve::BlowOf<Scalar>& blow) {
  std::vector<const Instant*> after;
  for (const Instant& instant : view.situation.instants)
    if (instant.name == "after") after.push_back(&instant);
  StatedConditions<Scalar> conditions;
  add_velocity_facts(view, after, &blow, conditions);
  return conditions;
}

template <class Scalar>
StatedConditions<Scalar> force_conditions(const InstantView<Scalar>& view, const std::vector<const Instant*>& instants,
                                          bool steady) {
  const MachineOf<Scalar>& machine = view.machine;
  StatedConditions<Scalar> conditions;
  const std::size_t n = solve::force_unknowns(machine.mechanism).size();
  add_rates(view, machine.accelerations, n, conditions);
  add_joint_friction(view, conditions);
  const auto count = static_cast<std::ptrdiff_t>(machine.mechanism.tree.velocity_size());
  const ProbePlaces<Scalar> places(n);
  for (const Instant* instant : instants)
    for (const Fact& fact : instant->facts) {
      if (level_of(view.situation, fact.quantity) != Level::force) continue;
      const auto differences_at = [&](std::size_t place) {
        const std::vector<Scalar> unknowns = places[place];
        QuantityScope<Scalar> quantities(machine, machine.mechanism.tree, view.data,
                                         State<Scalar>{machine.q, view.mechanism_state.state().v});
        quantities.set_accelerations(std::vector<Scalar>(unknowns.begin(), unknowns.begin() + count));
        quantities.set_forces(&view.mechanism_state, &unknowns);
        return differences(fact, quantities, view.situation.file);
      };
      add_fact(*instant, fact,
               has_corner(view.situation, fact)
                   ? std::nullopt
                   : as_linear<Scalar>(words_of(*instant, fact), view.scales, places, differences_at),
               conditions);
    }
  if (steady && view.situation.steady) add_steady(view, true, conditions);
  return conditions;
}

InstantView<double> SolvedInstant::view() const {
  return {situation_, *data_, machine_, *mechanism_state_, scales_, time_, before_ ? &*before_ : nullptr};
}

ConditionSource SolvedInstant::source_of(const Fact& fact) const {
  for (const Instant& instant : situation_.instants)
    for (const Fact& own : instant.facts)
      if (&own == &fact) return {fact.mark, &instant, &fact};
  return {fact.mark, nullptr, &fact};
}

ConditionSource SolvedInstant::source_of(System system, std::size_t equation) const {
  const solve::EquationSource& source = equations_of(system).source(equation);
  return source.kind == solve::EquationKind::condition ? sources_.at(system).at(source.index) : ConditionSource{};
}

// Facts about positions, mass centers and mass properties are conditions on unknowns. Without unknowns they must
// hold.
void SolvedInstant::position_facts(const std::vector<const Instant*>& instants) {
  for (const auto& [fact, difference] : position_differences(view(), instants)) {
    const double misfit = difference.value / natural_unit(difference.dimension);
    if (choice_.trial) {
      misfits_.push_back(misfit);
      misfit_size_ = std::max(misfit_size_, 1.0);
      position_sources_.push_back(source_of(*fact));
    } else if (!(std::abs(misfit) <= 1e-9)) {
      fail(situation_.file, fact->mark,
           "'" + to_string(fact->quantity) + "' is not what is stated: it follows from the data",
           "correct it, or leave a datum that it follows from to be found");
    }
  }
}

std::vector<FactMisfit> SolvedInstant::fact_misfits(const std::vector<const Fact*>& facts,
                                                    const MotionFeatureValues& features) {
  std::vector<FactMisfit> misfits;
  for (const Fact* fact : facts) {
    if (level_of(situation_, fact->quantity) == Level::force) solve_forces();
    QuantityScope<double> scope(machine_, machine_.mechanism.tree, *data_, State<double>{machine_.q, v_});
    if (motion_) {
      scope.set_accelerations(mechanism_state_->accelerations());
      scope.set_forces(&*mechanism_state_, &unknowns_);
    }
    if (writes_told_) scope.set_told(&told_);
    scope.set_motion_features(features);
    const Value<double> found = scope.value(fact->quantity);
    const double size = std::max(std::abs(found.number), norm(found.vector));
    for (const auto& difference : differences(*fact, scope, situation_.file)) {
      const double unit = natural_unit(difference.dimension);
      misfits.push_back({difference.value / unit, std::max(1.0, size / unit), difference.found,
                         difference.found - difference.value, difference.dimension});
    }
  }
  return misfits;
}

template StatedConditions<double> velocity_conditions(const InstantView<double>&, const std::vector<const Instant*>&);
template StatedConditions<double> blow_conditions(const InstantView<double>&, const solve::BlowOf<double>&);
template StatedConditions<double> force_conditions(const InstantView<double>&, const std::vector<const Instant*>&,
                                                   bool);
template std::vector<std::pair<const Fact*, Difference<double>>> position_differences(
    const InstantView<double>&, const std::vector<const Instant*>&);
template std::vector<Difference<double>> differences(const Fact&, QuantityScope<double>&, const std::string&);
template StatedConditions<Dual<1>> velocity_conditions(const InstantView<Dual<1>>&, const std::vector<const Instant*>&);
template StatedConditions<Dual<1>> blow_conditions(const InstantView<Dual<1>>&, const solve::BlowOf<Dual<1>>&);
template StatedConditions<Dual<1>> force_conditions(const InstantView<Dual<1>>&, const std::vector<const Instant*>&,
                                                    bool);
template std::vector<std::pair<const Fact*, Difference<Dual<1>>>> position_differences(
    const InstantView<Dual<1>>&, const std::vector<const Instant*>&);
template std::vector<Difference<Dual<1>>> differences(const Fact&, QuantityScope<Dual<1>>&, const std::string&);
template StatedConditions<Formula> velocity_conditions(const InstantView<Formula>&, const std::vector<const Instant*>&);
template StatedConditions<Formula> blow_conditions(const InstantView<Formula>&, const solve::BlowOf<Formula>&);
template StatedConditions<Formula> force_conditions(const InstantView<Formula>&, const std::vector<const Instant*>&,
                                                    bool);
template std::vector<std::pair<const Fact*, Difference<Formula>>> position_differences(
    const InstantView<Formula>&, const std::vector<const Instant*>&);
template std::vector<Difference<Formula>> differences(const Fact&, QuantityScope<Formula>&, const std::string&);

}  // namespace poinsot::problem
