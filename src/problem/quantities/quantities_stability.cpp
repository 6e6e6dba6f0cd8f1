// Whether a steady motion is stable, contacts push and cords pull.
#include <algorithm>

#include "problem/language/diagnostic.h"
#include "problem/language/exact_numbers.h"
#include "problem/language/words.h"
#include "problem/quantities/quantities.h"
#include "problem/quantities/quantity_values.h"

namespace poinsot::problem {

template <class Scalar, class Base>
Value<Scalar> QuantityScope<Scalar, Base>::holding(const Call& call, const Evaluator<Scalar>& evaluator) {
  const Expression& what = call.arguments[0].value;
  if (!mechanism_state_ || !unknowns_)
    evaluator.fail(what.mark(), call.function + "() cannot stand inside rate() or among what is known");
  const ActionKind kind = call.function == "taut" ? ActionKind::cord : ActionKind::contact;
  const Mechanism<Base>& mechanism = machine_.mechanism;
  std::vector<std::string> known;
  const std::size_t first = solve::force_unknowns(mechanism).accelerations;
  for (std::size_t i = 0; i < mechanism.actions.size(); ++i) {
    const Action& action = mechanism.actions[i];
    if (action.kind != kind) continue;
    known.push_back(action.name);
    if (!plain_name(what) || plain_name(what)->name != action.name) continue;
    double push = 0, largest = 0;
    bool acts = false;
    for (std::size_t k = 0; k < mechanism.components.size(); ++k) {
      const Component<Base>& component = mechanism.components[k];
      if (!component.couple) largest = std::max(largest, std::abs(plain((*unknowns_)[first + k])));
      if (component.action != static_cast<int>(i) || !component.one_sided) continue;
      push = plain((*unknowns_)[first + k]);
      acts = true;
    }
    constexpr double no_pull = 1e-12;  // of the largest force: the rounding of equations of a few dozen terms
    return Result::of_truth(acts && push >= -no_pull * largest);
  }
  const std::string all = joined(known);
  const std::string hint = did_you_mean(to_string(what), known);
  evaluator.fail(
      what.mark(),
      std::string("there is no ") + (kind == ActionKind::cord ? "cord" : "contact") + " '" + to_string(what) + "'",
      !hint.empty() ? hint
      : all.empty() ? ""
                    : "known: " + all);
}

template <class Scalar, class Base>
Value<Scalar> QuantityScope<Scalar, Base>::stability(const Call& call, const Mark& mark,
                                                     const Evaluator<Scalar>& evaluator) {
  const Expression& what = call.arguments[0].value;
  const int asked = body_of(what, evaluator, true);
  if constexpr (std::is_same_v<Base, Formula>)
    if (!linearisation_) throw NoFormula("no formula is known for " + call.function + "()");
  if (!linearisation_) evaluator.fail(mark, call.function + "() cannot stand inside rate() or among what is known");
  const solve::Linearisation& near = linearisation_(mark);
  const int body = asked == whole_system ? solve::everything : asked;
  if (body == ground) evaluator.fail(what.mark(), "the ground does not move");
  if (call.function == "stable") return Result::of_truth(solve::stability(near, body) == solve::Stability::stable);
  if (call.function == "stability") {
    const solve::Stability found = solve::stability(near, body);
    return Result::of_text(found == solve::Stability::stable     ? "stable"
                           : found == solve::Stability::unstable ? "unstable"
                                                                 : "undecided by the linearised equations");
  }
  if (call.function == "growth_rate")
    return number_value(Scalar(solve::growth_rate(near, body)), dimensions::none / dimensions::time);
  std::vector<Result> items;
  for (double frequency : solve::frequencies(near, body))
    items.push_back(number_value(Scalar(frequency), dimensions::angular_velocity));
  return Result::of_list(std::move(items));
}

template Value<double> QuantityScope<double>::holding(const Call&, const Evaluator<double>&);
template Value<Dual<1>> QuantityScope<Dual<1>, double>::holding(const Call&, const Evaluator<Dual<1>>&);
template Value<double> QuantityScope<double>::stability(const Call&, const Mark&, const Evaluator<double>&);
template Value<Dual<1>> QuantityScope<Dual<1>, double>::stability(const Call&, const Mark&, const Evaluator<Dual<1>>&);
template Value<Dual<1>> QuantityScope<Dual<1>>::holding(const Call&, const Evaluator<Dual<1>>&);
template Value<Dual<1, Dual<1>>> QuantityScope<Dual<1, Dual<1>>, Dual<1>>::holding(const Call&,
                                                                                   const Evaluator<Dual<1, Dual<1>>>&);
template Value<Dual<1>> QuantityScope<Dual<1>>::stability(const Call&, const Mark&, const Evaluator<Dual<1>>&);
template Value<Dual<1, Dual<1>>> QuantityScope<Dual<1, Dual<1>>, Dual<1>>::stability(
    const Call&, const Mark&, const Evaluator<Dual<1, Dual<1>>>&);
template Value<Formula> QuantityScope<Formula>::holding(const Call&, const Evaluator<Formula>&);
template Value<Dual<1, Formula>> QuantityScope<Dual<1, Formula>, Formula>::holding(const Call&,
                                                                                   const Evaluator<Dual<1, Formula>>&);
template Value<Formula> QuantityScope<Formula>::stability(const Call&, const Mark&, const Evaluator<Formula>&);
template Value<Dual<1, Formula>> QuantityScope<Dual<1, Formula>, Formula>::stability(
    const Call&, const Mark&, const Evaluator<Dual<1, Formula>>&);

}  // namespace poinsot::problem
