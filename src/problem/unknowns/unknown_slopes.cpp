// The slopes of the conditions by the unknowns, from dual numbers.
#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "problem/language/exact_numbers.h"
#include "problem/unknowns/unknown_equations.h"

namespace poinsot::problem {

std::vector<Dual<1>> UnknownEquations::varied_left_over(std::size_t situation, InstantSystem which,
                                                        VariedInstant& instant) const {
  const auto left = measures_.eliminations.at({situation, which}).remainder(instant.equations(which));
  if (!left) throw std::domain_error("what is left over has no value over dual numbers");
  std::vector<Dual<1>> values = left->values;
  const std::vector<Dual<1>> more = instant.nonlinear_misfits(which, left->solution);
  values.insert(values.end(), more.begin(), more.end());
  return values;
}

void UnknownEquations::add_slopes(std::vector<GroupConditions>& groups, std::size_t situation,
                                  const SolvedInstant& instant, const std::vector<std::size_t>& unknowns) const {
  // Of the larger of both: the values with slopes come by the same steps as those without and differ by roundings; a
  // condition that is another one differs in its first digits.
  constexpr double same = 1e-9;
  const std::vector<std::string> names = settable_names(statement_.situations[situation]);
  const auto own = [&](const GroupConditions& group) { return group.group.situation == situation; };
  for (GroupConditions& group : groups)
    if (own(group)) group.slopes.assign(group.values.size(), std::vector<double>(slots_.size()));
  for (const std::size_t k : unknowns) {
    if (std::find(names.begin(), names.end(), slots_[k].unknown.name) == names.end()) continue;
    VariedInstant varied(instant, slots_[k].unknown.name, slots_[k].component);
    for (GroupConditions& group : groups) {
      if (!own(group)) continue;
      std::vector<Dual<1>> values;
      if (group.group.aspect == Aspect::positions) values = varied.position_misfits();
      if (group.group.aspect == Aspect::forces) values = varied_left_over(situation, InstantSystem::motion, varied);
      if (group.group.aspect == Aspect::velocities) {
        values = varied_left_over(situation, InstantSystem::velocities, varied);
        if (instant.after_blow())
          for (const Dual<1>& value : varied_left_over(situation, InstantSystem::blow, varied)) values.push_back(value);
      }
      if (values.size() != group.values.size()) throw std::domain_error("conditions differ over dual numbers");
      for (std::size_t i = 0; i < values.size(); ++i) {
        if (!(std::abs(values[i].value - group.values[i]) <= same * group.size))
          throw std::domain_error("conditions differ over dual numbers");
        if (!std::isfinite(values[i].partial[0])) throw std::domain_error("a condition has no derivative here");
        group.slopes[i][k] = values[i].partial[0];
      }
    }
  }
}

std::optional<std::vector<GroupConditions>> UnknownEquations::sloped_groups(const std::vector<double>& x,
                                                                            const std::vector<std::size_t>& unknowns) {
  if (follows_motion()) return std::nullopt;
  try {
    const Evaluated& all =
        evaluated_ && evaluated_->at == x && evaluated_->wanted == Wanted::everything ? *evaluated_ : evaluate(x);
    if (all.equations.smooth.empty()) return std::nullopt;
    std::vector<GroupConditions> groups = all.groups;
    for (const auto& [situation, instant] : all.instants) add_slopes(groups, situation, *instant, unknowns);
    return groups;
  } catch (const StatementError&) {
    // The quantity has no derivatives. Differences will show whether it has values.
  } catch (const std::domain_error&) {
  } catch (const NoFormula&) {
  }
  return std::nullopt;
}

std::optional<solve::RootEquations> UnknownEquations::with_slopes(const std::vector<double>& x,
                                                                  std::vector<std::vector<double>>* slopes) {
  if (!small_.empty()) return std::nullopt;
  std::vector<std::size_t> every(slots_.size());
  std::iota(every.begin(), every.end(), std::size_t{0});
  const auto groups = sloped_groups(x, every);
  if (!groups) return std::nullopt;
  slopes->clear();
  for (const GroupConditions& group : *groups) slopes->insert(slopes->end(), group.slopes.begin(), group.slopes.end());
  return evaluated_->equations;
}

std::optional<UnknownEquations::LinearPart> UnknownEquations::linear_part(const std::vector<double>& at) {
  const auto groups = sloped_groups(at, small_);
  if (!groups) return linear_part_by_differences(at);
  makes_sense_ = true;
  LinearPart part{at, evaluated_->equations.smooth, evaluated_->equations.smooth_size, {}};
  for (const GroupConditions& group : *groups)
    for (const std::vector<double>& slopes : group.slopes) {
      std::vector<double>& row = part.slopes.emplace_back();
      for (const std::size_t k : small_) row.push_back(slopes[k]);
    }
  return part;
}

std::optional<UnknownEquations::LinearPart> UnknownEquations::linear_part_by_differences(
    const std::vector<double>& at) {
  const auto values_at = [&](const std::vector<double>& x, double* size) -> std::optional<std::vector<double>> {
    const auto equations = exact(x);
    if (!equations) return std::nullopt;
    if (size) *size = equations->smooth.empty() ? equations->size : equations->smooth_size;
    return equations->smooth.empty() ? equations->values : equations->smooth;
  };
  LinearPart part{at, {}, 0, {}};
  const auto base = values_at(at, &part.size);
  if (!base) return std::nullopt;
  part.values = *base;
  part.slopes.assign(base->size(), std::vector<double>(small_.size()));
  for (std::size_t i = 0; i < small_.size(); ++i)
    // The differences are of sixth order: rounding and the seventh derivative leave about 1e-13 of the terms.
    for (const auto& [step, weight] : {std::pair{1, 0.75}, {2, -0.15}, {3, 1.0 / 60}})
      for (const double side : {1.0, -1.0}) {
        const double h = 1e-2 * ranges_[small_[i]].scale;
        std::vector<double> beside = at;
        beside[small_[i]] = side * step * h;
        const auto there = values_at(beside, nullptr);
        if (!there || there->size() != base->size()) return std::nullopt;
        for (std::size_t row = 0; row < base->size(); ++row) part.slopes[row][i] += side * weight / h * (*there)[row];
      }
  return part;
}

}  // namespace poinsot::problem
