// What is told of the values between the one that a datum has and the end of what was asked, and of those beyond.
#include <algorithm>
#include <cmath>

#include "problem/language/diagnostic.h"
#include "problem/unknowns/extremum.h"

namespace poinsot::problem {
namespace {

// Of the end: it is known if the conditions are decided within this. Answers are shown to six digits, so that ten times
// more would be seen in them; linearised equations decide to some 1e-7.
constexpr double unseen = 2e-6;

// From one value to another in even steps, and where that is far also in even ratios, as the end was searched for: even
// steps pass over what lies near the first value.
std::vector<double> steps_between(double from, double to) {
  constexpr int count = 24, to_a_decade = 12;
  std::vector<double> steps;
  for (int i = 0; i <= count; ++i) steps.push_back(i == count ? to : from + i * (to - from) / count);
  constexpr double far = 10;
  if (from != 0 && (to / from > far || (to / from > 0 && from / to > far))) {
    const int ratios = static_cast<int>(to_a_decade * std::abs(std::log10(to / from)));
    for (int i = 1; i < ratios; ++i) steps.push_back(from * std::pow(to / from, static_cast<double>(i) / ratios));
  }
  std::sort(steps.begin(), steps.end());
  if (to < from) std::reverse(steps.begin(), steps.end());
  steps.erase(std::unique(steps.begin(), steps.end()), steps.end());
  return steps;
}

}  // namespace

// Explains an end beyond which the conditions do not clearly fail.
std::string ExtremumSearch::told_beyond(double inside, double outside) {
  const Truth beyond = truth_at(outside);
  const std::string here = in_unit(inside);
  if (beyond == Truth::refused)
    return "what is stated ends at " + here + ", not what is asked: beyond, " + refusal_->diagnostics().front().message;
  if (beyond != Truth::doubtful) return "";
  constexpr int doublings = 18;  // to half of it
  for (int i = 0; i <= doublings; ++i) {
    const double part = std::ldexp(unseen, i);
    const double further = inside + (outside > inside ? 1 : -1) * part * std::abs(inside);
    const Truth there = truth_at(further);
    if (there != Truth::fails && there != Truth::refused) continue;
    if (i == 0) return "";
    return "from " + in_unit(inside) + " to " + in_unit(further) + " the linearised equations do not decide";
  }
  return "beyond " + here + " the linearised equations do not decide";
}

double ExtremumSearch::border(double inside, double outside) {
  while (std::abs(outside - inside) > 1e-9 * std::abs(inside)) {
    const double middle = 0.5 * (inside + outside);
    if (middle == inside || middle == outside) break;
    (holds(middle) ? inside : outside) = middle;
  }
  return inside;
}

std::optional<double> ExtremumSearch::holds_again(double end, double gap) {
  constexpr int looks = 12;
  constexpr double to_a_gap = 3;
  const Span range = span();
  for (int i = 1; i <= looks; ++i) {
    const double further = end + gap * i / to_a_gap;
    if (further <= range.upper && further >= range.lower && holds(further)) return further;
  }
  return std::nullopt;
}

// The conditions may also end nearer than at an end: they fail at some of the values on this side of it, and hold again
// nearer still, or fail at the value that the datum has.
ExtremumSearch::Nearer ExtremumSearch::look_nearer(double end) {
  const std::string& name = ask_.extremum->name;
  const bool rising = ask_.extremum->largest;
  const bool is_datum =
      std::ranges::any_of(situation_.given, [&](const NamedExpression& item) { return item.name == name; });
  const std::optional<double> stated = own_value();
  if (choice_.trial || !is_datum || !stated || !((rising ? 1 : -1) * (end - *stated) > 0)) return {};
  const std::vector<double> steps = steps_between(*stated, end);
  // From the end towards the datum's value: where they fail, the last step outside at which they hold, and where they
  // hold again.
  std::optional<std::size_t> failing;
  std::size_t outside = steps.size() - 1;
  for (std::size_t i = steps.size() - 1; i-- > 0;) {
    const Truth there = truth_at(steps[i]);
    if (there == Truth::fails && !failing) failing = i;
    if (there == Truth::holds && !failing) outside = i;
    if (there != Truth::holds || !failing) continue;
    const double ends = border(steps[i], steps[i + 1]), again = border(steps[outside], steps[*failing]);
    const std::string rises =
        (rising ? "smaller values it holds up to " : "larger values it holds down to ") + in_unit(ends);
    Nearer nearer{"between " + in_unit(ends) + " and " + in_unit(again) + " it does not hold: from " + rises};
    if (const std::optional<double> further = holds_again(end, again - ends))
      nearer.by_intervals = "it holds by intervals: from " + rises + ", again from " + in_unit(again) + " to " +
                            in_unit(end) + ", again at " + in_unit(*further) + ": give '" + name +
                            "' a range under where:";
    return nearer;
  }
  if (!failing || truth_at(steps.front()) != Truth::fails) return {};
  return {"it does not hold at " + in_unit(*stated) + ", the value of '" + name + "', but from " +
          in_unit(border(steps[outside], steps[*failing])) + (rising ? " up" : " down")};
}

}  // namespace poinsot::problem
