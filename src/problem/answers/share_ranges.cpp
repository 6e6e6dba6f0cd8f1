#include "problem/answers/share_ranges.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "problem/language/words.h"

namespace poinsot::problem {

std::string range_in_words(const Ask& ask, const SolvedAsk& solved, Sample& sample) {
  if (ask.table || ask.when || ask.extremum || ask.of.size() != 1) return "";
  const auto ranges = sample.instant_of(ask).over_all_shares(ask.of.front(), ask.axes);
  if (!ranges) return "";
  double size = 0;
  for (const SolvedInstant::Between& range : *ranges)
    for (const double end : {range.least, range.largest})
      if (std::isfinite(end)) size = std::max(size, std::abs(end));
  constexpr double same = 1e-9;  // of the largest: what a linear program leaves of nothing
  const auto number = [&](double value) {
    return with_digits(std::abs(value) <= same * size ? 0 : value / solved.unit.factor, 6);
  };
  const std::string unit = solved.unit.text.empty() ? "" : " " + solved.unit.text;
  std::vector<std::string> told;
  for (std::size_t k = 0; k < ranges->size(); ++k) {
    const auto& [least, largest] = (*ranges)[k];
    if (largest - least <= same * size || (std::isinf(least) && std::isinf(largest))) continue;
    told.push_back((ranges->size() > 1 ? "." + sample.situation_at(ask).axes[k] : std::string("it")) +
                   (std::isinf(largest) ? " is " + number(least) + unit + " or more"
                    : std::isinf(least) ? " is " + number(largest) + unit + " or less"
                                        : " lies between " + number(least) + " and " + number(largest) + unit));
  }
  return told.empty() ? "" : "as none of them pulls, " + joined(told);
}

}  // namespace poinsot::problem
