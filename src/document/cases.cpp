#include "poinsot/cases.h"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>

#include "problem/cases/cases.h"
#include "problem/language/units.h"

namespace poinsot {

Cases::Cases(std::shared_ptr<const problem::CompiledCases> parts) : parts_(std::move(parts)) {
  for (const problem::CaseColumn& column : parts_->columns()) columns_.push_back({column.name, column.unit});
}

std::vector<CaseColumn> Cases::over() const {
  std::vector<CaseColumn> over;
  for (const problem::VariedDatum& datum : parts_->data())
    over.push_back({datum.name, problem::format_unit(datum.dimension)});
  return over;
}

bool Cases::has_formulas() const { return parts_->has_formulas(); }
std::string Cases::no_formulas() const { return parts_->no_formulas(); }
bool Cases::by_instants() const { return parts_->by_instants(); }
std::string Cases::no_program() const { return parts_->no_program(); }

CaseRows Cases::solve(const std::vector<std::span<const double>>& values, std::uint64_t first,
                      const Budget& budget) const {
  if (values.size() != parts_->data().size())
    throw std::invalid_argument("Cases::solve: got " + std::to_string(values.size()) + " columns for " +
                                std::to_string(parts_->data().size()));
  for (const std::span<const double>& column : values)
    if (column.size() != values.front().size())
      throw std::invalid_argument("Cases::solve: the columns have different numbers of cases");
  const BudgetScope scope(budget);
  problem::SolvedCases found = parts_->solved(values, first);
  CaseRows rows{std::move(found.columns), std::vector<CaseRoad>(found.roads.size()), std::move(found.reasons),
                found.checked, found.refuted};
  std::ranges::transform(found.roads, rows.roads.begin(),
                         [](problem::CaseRoad road) { return static_cast<CaseRoad>(road); });
  return rows;
}

}  // namespace poinsot
