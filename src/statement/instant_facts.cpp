// What is stated about rates, velocities, accelerations and forces, as linear conditions.
#include <algorithm>
#include <cmath>

#include "statement/instant.h"
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

// Facts about positions, mass centers and mass properties demand something of unknowns, or must hold as it is.
void SolvedInstant::position_facts(const std::vector<const Instant*>& instants) {
  for (const Instant* instant : instants)
    for (const Fact& fact : instant->facts) {
      if (level_of(problem_, fact.quantity) != Level::position || fact.quantity.as<Name>()) continue;
      QuantityScope<double> scope(
          machine_, machine_.mechanism.tree, *data_,
          State<double>{machine_.q, std::vector<double>(machine_.mechanism.tree.velocity_size())});
      for (const auto& difference : differences(fact, scope, problem_.file)) {
        const double misfit = difference.value / natural_unit(difference.dimension);
        if (choice_.trial) {
          misfits_.push_back(misfit);
          misfit_size_ = std::max(misfit_size_, 1.0);
        } else if (!(std::abs(misfit) <= 1e-9)) {
          fail(problem_.file, fact.mark,
               "'" + to_string(fact.quantity) + "' is not what is stated: it follows from the data",
               "correct it, or leave a datum that it follows from to be found");
        }
      }
    }
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
      if (past.instant != "before" || !before_)
        fail(problem_.file, mark, "a fact can look back to `before` a blow only, not to '" + past.instant + "'");
      QuantityScope<double> earlier(machine_, machine_.mechanism.tree, *data_, before_->state());
      return lifted<Dual<1>>(earlier.value(past.expression));
    });
    return differences(fact, scope, problem_.file);
  };
  for (const Instant* instant : instants) {
    if (instant->rest) {
      for (std::size_t k = 0; k < n; ++k) {
        // Frames move as they state.
        const auto moved =
            std::find_if(machine_.links.begin(), machine_.links.end(), [&](const solve::CheckLink& link) {
              return static_cast<int>(k) >= link.velocity &&
                     static_cast<int>(k) < link.velocity + velocity_size(link.type);
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
        conditions.push_back({"'" + instant->name + "': " + to_string(fact.quantity), std::vector<double>(n),
                              -base[i].value.value, natural_unit(base[i].dimension)});
      const std::size_t first = conditions.size() - base.size();
      for (std::size_t k = 0; k < n; ++k) {
        const auto slope = at(zero, k, fact);
        for (std::size_t i = 0; i < slope.size(); ++i)
          conditions[first + i].coefficients[k] = slope[i].value.partial[0];
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
          fail(problem_.file, fact.mark,
               "'" + to_string(fact.quantity) + "' is not linear in the velocities: it does not fix them alone",
               "state rates, velocities or momenta");
      }
    }
  }
  return conditions;
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
        conditions.push_back({"'" + instant->name + "': " + to_string(fact.quantity), std::vector<double>(n),
                              -difference.value, natural_unit(difference.dimension)});
      for (std::size_t k = 0; k < n; ++k) {
        unknowns[k] = 1;
        const auto one = at(unknowns, fact);
        for (std::size_t i = 0; i < one.size(); ++i)
          conditions[first + i].coefficients[k] = one[i].value - base[i].value;
        unknowns[k] = 0;
      }
    }
  }
  if (problem_.steady && !moving_) add_steady(conditions, true);
  return conditions;
}

}  // namespace poinsot::statement
