// What is stated about rates, velocities, accelerations and forces, as linear conditions.
#include <algorithm>
#include <cmath>
#include <random>
#include <type_traits>

#include "statement/exact_numbers.h"
#include "statement/instant.h"
#include "statement/instant_conditions.h"
#include "statement/reader.h"
#include "statement/scalar_value.h"

namespace poinsot::statement {
namespace {

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
State<Scalar> at_rest(const InstantView<Scalar>& view) {
  return {view.machine.q, std::vector<Scalar>(static_cast<std::size_t>(view.machine.mechanism.tree.velocity_size()))};
}

std::string words_of(const Instant& instant, const Fact& fact) {
  return "'" + instant.name + "': " + to_string(fact.quantity);
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

template <class Scalar>
std::vector<solve::ConditionOf<Scalar>> rate_conditions(const InstantView<Scalar>& view) {
  std::vector<solve::ConditionOf<Scalar>> conditions;
  const auto n = static_cast<std::size_t>(view.machine.mechanism.tree.velocity_size());
  for (const StatedRateOf<Scalar>& rate : view.machine.rates) {
    solve::ConditionOf<Scalar> condition{rate.words, std::vector<Scalar>(n), rate.value,
                                         rate.turning ? 1 : view.scales.length};
    condition.coefficients[static_cast<std::size_t>(rate.velocity)] = Scalar(1);
    conditions.push_back(std::move(condition));
  }
  return conditions;
}

template <class Scalar>
std::vector<std::pair<const Fact*, Difference<Scalar>>> position_differences(
    const InstantView<Scalar>& view, const std::vector<const Instant*>& instants) {
  std::vector<std::pair<const Fact*, Difference<Scalar>>> all;
  for (const Instant* instant : instants)
    for (const Fact& fact : instant->facts) {
      if (level_of(view.problem, fact.quantity) != Level::position || fact.quantity.as<Name>()) continue;
      QuantityScope<Scalar> scope(view.machine, view.machine.mechanism.tree, view.data, at_rest(view));
      for (Difference<Scalar>& difference : differences(fact, scope, view.problem.file))
        all.emplace_back(&fact, std::move(difference));
    }
  return all;
}

// Facts about velocities are linear in them: their coefficients are derivatives, by dual numbers.
template <class Scalar>
std::vector<solve::ConditionOf<Scalar>> velocity_facts(const InstantView<Scalar>& view,
                                                       const std::vector<const Instant*>& instants) {
  using Varied = Dual<1, Scalar>;
  const MachineOf<Scalar>& machine = view.machine;
  std::vector<solve::ConditionOf<Scalar>> conditions;
  const auto n = static_cast<std::size_t>(machine.mechanism.tree.velocity_size());
  const Model<Varied> model = convert<Varied>(machine.mechanism.tree);
  DataScope<Varied> data(view.problem, view.data.settings(), Varied(view.time));
  data.vary_as(view.data);
  const auto at = [&](const std::vector<Scalar>& v, std::size_t seed, const Fact& fact) {
    State<Varied> state;
    for (const Scalar& q : machine.q) state.q.emplace_back(q);
    for (std::size_t k = 0; k < n; ++k) state.v.push_back(k == seed ? Varied::variable(v[k], 0) : Varied(v[k]));
    QuantityScope<Varied, Scalar> scope(machine, model, data, std::move(state));
    scope.set_elsewhere([&](const At& past, const Mark& mark) {
      if (past.instant != "before" || !view.before)
        fail(view.problem.file, mark, "a fact can look back to `before` a blow only, not to '" + past.instant + "'");
      QuantityScope<Scalar> earlier(machine, machine.mechanism.tree, view.data, view.before->state());
      return lifted<Varied>(earlier.value(past.expression));
    });
    return differences(fact, scope, view.problem.file);
  };
  for (const Instant* instant : instants) {
    if (instant->rest) {
      for (std::size_t k = 0; k < n; ++k) {
        // Frames move as they state.
        const auto moved = std::find_if(machine.links.begin(), machine.links.end(), [&](const solve::CheckLink& link) {
          return static_cast<int>(k) >= link.velocity && static_cast<int>(k) < link.velocity + velocity_size(link.type);
        });
        const auto body = static_cast<std::size_t>(moved - machine.links.begin());
        const bool frame = std::any_of(view.problem.frames.begin(), view.problem.frames.end(), [&](const Frame& f) {
          return machine.index.at(f.name) == static_cast<int>(body);
        });
        if (frame) continue;
        solve::ConditionOf<Scalar> condition{"'" + instant->name + "': rest", std::vector<Scalar>(n), Scalar(0), 1};
        condition.coefficients[k] = Scalar(1);
        conditions.push_back(std::move(condition));
      }
    }
    for (const Fact& fact : instant->facts) {
      if (level_of(view.problem, fact.quantity) != Level::velocity) continue;
      const std::vector<Scalar> zero(n, Scalar(0));
      const auto base = at(zero, n, fact);
      for (std::size_t i = 0; i < base.size(); ++i)
        conditions.push_back({words_of(*instant, fact), std::vector<Scalar>(n), -base[i].value.value,
                              natural_unit(view.scales, base[i].dimension)});
      const std::size_t first = conditions.size() - base.size();
      for (std::size_t k = 0; k < n; ++k) {
        const auto slope = at(zero, k, fact);
        for (std::size_t i = 0; i < slope.size(); ++i)
          conditions[first + i].coefficients[k] = slope[i].value.partial[0];
      }
      // A fact that is not linear would give one of several motions, silently.
      std::vector<Scalar> other(n);
      std::mt19937_64 random(7);
      for (Scalar& x : other) x = Scalar(std::uniform_real_distribution<double>(0.5, 1.5)(random));
      const auto there = at(other, n, fact);
      for (std::size_t i = 0; i < there.size(); ++i) {
        const solve::ConditionOf<Scalar>& condition = conditions[first + i];
        Scalar linear = -condition.value;
        double size = std::abs(plain(linear));
        for (std::size_t k = 0; k < n; ++k) {
          linear += condition.coefficients[k] * other[k];
          size += std::abs(plain(condition.coefficients[k]) * plain(other[k]));
        }
        const double value = plain(there[i].value.value);
        if (std::abs(value - plain(linear)) > 1e-9 * (size + std::abs(value)))
          fail(view.problem.file, fact.mark,
               "'" + to_string(fact.quantity) + "' is not linear in the velocities: it does not fix them alone",
               "state rates, velocities or momenta");
      }
    }
  }
  return conditions;
}

template <class Scalar>
std::vector<solve::ConditionOf<Scalar>> force_facts(const InstantView<Scalar>& view,
                                                    const std::vector<const Instant*>& instants) {
  const MachineOf<Scalar>& machine = view.machine;
  std::vector<solve::ConditionOf<Scalar>> conditions;
  const std::size_t n = solve::force_unknowns(machine.mechanism).size();
  for (const StatedRateOf<Scalar>& rate : machine.accelerations) {
    solve::ConditionOf<Scalar> condition{rate.words, std::vector<Scalar>(n), rate.value,
                                         rate.turning ? 1 : view.scales.length};
    condition.coefficients[static_cast<std::size_t>(rate.velocity)] = Scalar(1);
    conditions.push_back(std::move(condition));
  }
  // Facts about accelerations and forces are linear in these unknowns: their values at zero and at each unit.
  const auto at = [&](const std::vector<Scalar>& unknowns, const Fact& fact) {
    QuantityScope<Scalar> quantities(machine, machine.mechanism.tree, view.data,
                                     State<Scalar>{machine.q, view.moment.state().v});
    const auto count = static_cast<std::ptrdiff_t>(machine.mechanism.tree.velocity_size());
    quantities.set_accelerations(std::vector<Scalar>(unknowns.begin(), unknowns.begin() + count));
    quantities.set_forces(&view.moment, &unknowns);
    return differences(fact, quantities, view.problem.file);
  };
  for (const Instant* instant : instants) {
    for (const Fact& fact : instant->facts) {
      if (level_of(view.problem, fact.quantity) != Level::force) continue;
      std::vector<Scalar> unknowns(n, Scalar(0));
      const auto base = at(unknowns, fact);
      const std::size_t first = conditions.size();
      for (const auto& difference : base)
        conditions.push_back({words_of(*instant, fact), std::vector<Scalar>(n), -difference.value,
                              natural_unit(view.scales, difference.dimension)});
      for (std::size_t k = 0; k < n; ++k) {
        unknowns[k] = Scalar(1);
        const auto one = at(unknowns, fact);
        for (std::size_t i = 0; i < one.size(); ++i)
          conditions[first + i].coefficients[k] = one[i].value - base[i].value;
        unknowns[k] = Scalar(0);
      }
    }
  }
  return conditions;
}

InstantView<double> SolvedInstant::view() const {
  return {problem_, *data_, machine_, *moment_, scales_, time_, before_ ? &*before_ : nullptr};
}

// Facts about positions, mass centers and mass properties demand something of unknowns, or must hold as it is.
void SolvedInstant::position_facts(const std::vector<const Instant*>& instants) {
  for (const auto& [fact, difference] : position_differences(view(), instants)) {
    const double misfit = difference.value / natural_unit(difference.dimension);
    if (choice_.trial) {
      misfits_.push_back(misfit);
      misfit_size_ = std::max(misfit_size_, 1.0);
    } else if (!(std::abs(misfit) <= 1e-9)) {
      fail(problem_.file, fact->mark,
           "'" + to_string(fact->quantity) + "' is not what is stated: it follows from the data",
           "correct it, or leave a datum that it follows from to be found");
    }
  }
}

std::vector<double> SolvedInstant::fact_misfits(const std::vector<const Fact*>& facts) {
  std::vector<double> misfits;
  for (const Fact* fact : facts) {
    if (level_of(problem_, fact->quantity) == Level::force) solve_forces();
    QuantityScope<double> scope(machine_, machine_.mechanism.tree, *data_, State<double>{machine_.q, v_});
    if (motion_) {
      scope.set_accelerations(moment_->accelerations());
      scope.set_forces(&*moment_, &unknowns_);
    }
    scope.set_motion(feature_);
    for (const auto& difference : differences(*fact, scope, problem_.file))
      misfits.push_back(difference.value / natural_unit(difference.dimension));
  }
  return misfits;
}

std::vector<solve::Condition> SolvedInstant::force_conditions() {
  std::vector<solve::Condition> conditions = force_facts(view(), facts_);
  if (problem_.steady && !moving_) add_steady(view(), conditions, true);
  return conditions;
}

template std::vector<solve::ConditionOf<double>> rate_conditions(const InstantView<double>&);
template std::vector<solve::ConditionOf<double>> velocity_facts(const InstantView<double>&,
                                                                const std::vector<const Instant*>&);
template std::vector<solve::ConditionOf<double>> force_facts(const InstantView<double>&,
                                                             const std::vector<const Instant*>&);
template std::vector<std::pair<const Fact*, Difference<double>>> position_differences(
    const InstantView<double>&, const std::vector<const Instant*>&);
template std::vector<solve::ConditionOf<Formula>> rate_conditions(const InstantView<Formula>&);
template std::vector<solve::ConditionOf<Formula>> velocity_facts(const InstantView<Formula>&,
                                                                 const std::vector<const Instant*>&);
template std::vector<solve::ConditionOf<Formula>> force_facts(const InstantView<Formula>&,
                                                              const std::vector<const Instant*>&);
template std::vector<std::pair<const Fact*, Difference<Formula>>> position_differences(
    const InstantView<Formula>&, const std::vector<const Instant*>&);

}  // namespace poinsot::statement
