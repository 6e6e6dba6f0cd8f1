// Whether a steady motion is stable, contacts push and cords pull.
#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "poinsot/engine/math/formula/formula_decision.h"
#include "problem/language/diagnostic.h"
#include "problem/language/exact_numbers.h"
#include "problem/language/words.h"
#include "problem/quantities/quantities.h"
#include "problem/quantities/quantity_values.h"
#include "problem/quantities/rough_contact.h"

namespace poinsot::problem {

template <class Scalar, class Base>
Value<Scalar> QuantityScope<Scalar, Base>::holding(const Call& call, const Evaluator<Scalar>& evaluator) {
  const Expression& what = call.arguments[0].value;
  if (!mechanism_state_ || !unknowns_)
    evaluator.fail(what.mark(), call.function + "() cannot stand inside rate() or among what is known");
  require_one_of(call.function, {"taut", "touching"});
  const ActionKind kind = call.function == "taut" ? ActionKind::cord : ActionKind::contact;
  const Mechanism<Base>& mechanism = machine_.mechanism;
  std::vector<std::string> known;
  const std::size_t first = solve::force_unknowns(mechanism).accelerations;
  for (const Action& named : mechanism.actions) {
    if (named.kind != kind) continue;
    known.push_back(named.name);
    if (!plain_name(what) || plain_name(what)->name != named.name) continue;
    double least = 0, largest = 0;
    bool acts = false;
    for (std::size_t k = 0; k < mechanism.components.size(); ++k) {
      const Component<Base>& component = mechanism.components[k];
      if (!component.couple) largest = std::max(largest, std::abs(plain((*unknowns_)[first + k])));
      const Action& action = mechanism.actions[static_cast<std::size_t>(component.action)];
      if (action.kind != kind || action.name != named.name || !component.one_sided) continue;
      const double push = plain((*unknowns_)[first + k]);
      least = acts ? std::min(least, push) : push;
      acts = true;
    }
    for (const int side : machine_.belt_actions) {
      if (mechanism.actions[static_cast<std::size_t>(side)].name != named.name) continue;
      const double pull = plain(tension_of(*mechanism_state_, *unknowns_, side));
      least = acts ? std::min(least, pull) : pull;
      acts = true;
    }
    constexpr double no_pull = 1e-12;  // of the largest force: the rounding of equations of a few dozen terms
    return Result::of_truth(acts && least >= -no_pull * largest);
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
  if constexpr (std::is_same_v<Base, Formula>) {
    if constexpr (std::is_same_v<Scalar, Formula>)
      if (near_in_letters_) return near_in_letters_(call, mark);
    throw NoFormula("no formula is known for " + call.function + "()");
  }
  if (call.function == "response") {
    if constexpr (std::is_same_v<Scalar, double>)
      if (respond_) return respond_(call, mark);
    evaluator.fail(mark, "response() cannot stand inside rate() or among what is known");
  }
  const int asked = body_of(what, evaluator, true);
  if (!linearisation_) evaluator.fail(mark, call.function + "() cannot stand inside rate() or among what is known");
  const solve::Linearisation& near = linearisation_(mark, call.function == "modes");
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
  const bool all = call.function == "modes" || call.function == "eigenvalues";
  if (all &&
      std::ranges::any_of(near.modes, [&](const solve::Mode& mode) { return !(mode.doubt <= 1e-3 * near.pace); }))
    throw UnansweredError(situation_.file, mark, "rates near this motion meet, so that they are not known one by one",
                          machine_.mechanism.attractions.empty()
                              ? "change a datum by a little"
                              : "beside an orbit state the turning of a body on a joint of the orbit's frame: "
                                "{ball: G, from: orbit, to: satellite}");
  if (call.function == "modes") return modes(near, body);
  std::vector<Result> items;
  if (call.function == "eigenvalues") {
    const auto rate = [](double part) { return number_value(Scalar(part), dimensions::none / dimensions::time); };
    for (const solve::ToldMode& mode : solve::told_modes(near, body))
      items.push_back(Result::of_list({rate(mode.growth_rate), rate(mode.frequency)}));
    return Result::of_list(std::move(items));
  }
  require_one_of(call.function, {"frequencies"});
  for (double frequency : solve::frequencies(near, body))
    items.push_back(number_value(Scalar(frequency), dimensions::angular_velocity));
  return Result::of_list(std::move(items));
}

namespace {

// The displacements of some coordinates in a mode, scaled so that the largest, as a part of its natural size, is one
// and the first of the largest has no phase.
std::vector<std::complex<double>> scaled_shape(std::vector<std::complex<double>> parts,
                                               const std::vector<double>& natural) {
  constexpr double alike = 1e-6;    // of the largest: as large, but for rounding
  constexpr double resting = 1e-9;  // of the largest: what is rounding
  double largest = 0;
  for (std::size_t k = 0; k < parts.size(); ++k) largest = std::max(largest, std::abs(parts[k]) / natural[k]);
  if (!(largest > 0)) return parts;
  std::size_t first = 0;
  while (std::abs(parts[first]) / natural[first] < (1 - alike) * largest) ++first;
  const std::complex<double> one = parts[first];
  for (std::size_t k = 0; k < parts.size(); ++k) {
    parts[k] /= one;
    const double size = resting * natural[k] / natural[first];
    if (std::abs(parts[k].real()) < size) parts[k].real(0);
    if (std::abs(parts[k].imag()) < size) parts[k].imag(0);
  }
  return parts;
}

}  // namespace

// Of each mode its rates, and by amplitude and phase the coordinates that have names and move in one of them.
template <class Scalar, class Base>
Value<Scalar> QuantityScope<Scalar, Base>::modes(const solve::Linearisation& near, int body) {
  const std::vector<solve::ToldMode> told = solve::told_modes(near, body);
  const bool shaped = std::ranges::none_of(told, [&](const auto& mode) { return near.modes[mode.mode].shape.empty(); });
  std::vector<const NamedCoordinate*> named;
  std::vector<double> natural;
  for (const NamedCoordinate& coordinate : machine_.coordinates) {
    const auto moves = [&](const solve::ToldMode& mode) {
      return near.modes[mode.mode].shape[static_cast<std::size_t>(coordinate.velocity)] != 0.0;
    };
    if (coordinate.name.empty() || !shaped || std::ranges::none_of(told, moves)) continue;
    named.push_back(&coordinate);
  }
  // Where several move as far, the first has no phase: which it is does not depend on the order of the file.
  std::ranges::sort(named, {}, &NamedCoordinate::name);
  // Lengths are told beside angles, or by themselves as parts of the largest.
  const bool turns = std::ranges::any_of(named, &NamedCoordinate::turning);
  for (const NamedCoordinate* coordinate : named) natural.push_back(coordinate->turning ? 1 : near.length);
  const auto dimension_of_part = [&](const NamedCoordinate& coordinate) {
    return coordinate.turning ? dimensions::angle : turns ? dimensions::length : dimensions::none;
  };
  std::vector<std::string> names{"growth_rate", "frequency", "damping_ratio"};
  for (const NamedCoordinate* coordinate : named) {
    names.push_back(coordinate->name);
    names.push_back(coordinate->name + "_phase");
  }
  std::vector<Result> items;
  for (const solve::ToldMode& mode : told) {
    std::vector<Result> parts{number_value(Scalar(mode.growth_rate), dimensions::none / dimensions::time),
                              number_value(Scalar(mode.frequency), dimensions::angular_velocity),
                              number_value(Scalar(mode.damping_ratio), dimensions::none)};
    std::vector<std::complex<double>> shape;
    for (const NamedCoordinate* coordinate : named)
      shape.push_back(near.modes[mode.mode].shape[static_cast<std::size_t>(coordinate->velocity)]);
    shape = scaled_shape(std::move(shape), natural);
    for (std::size_t k = 0; k < shape.size(); ++k) {
      parts.push_back(number_value(Scalar(std::abs(shape[k])), dimension_of_part(*named[k])));
      const double phase = shape[k].imag() == 0 ? (shape[k].real() < 0 ? std::numbers::pi : 0) : std::arg(shape[k]);
      parts.push_back(number_value(Scalar(phase), dimensions::angle));
    }
    for (std::size_t k = 0; k < parts.size(); ++k) parts[k].text = names[k];
    items.push_back(Result::of_list(std::move(parts)));
  }
  return Result::of_list(std::move(items));
}

// max(frequencies(disk))
template <class Scalar, class Base>
Value<Scalar> QuantityScope<Scalar, Base>::extreme_of_list(const Call& call, const Mark& mark,
                                                           const Evaluator<Scalar>& evaluator) {
  const Result list = evaluator(call.arguments.front().value);
  if (list.items.empty())
    throw UnansweredError(situation_.file, mark, "there is no " + call.function + "() of a list that is empty");
  const auto less = [](const Result& a, const Result& b) { return decided_negative(Scalar(a.number - b.number)); };
  return call.function == "min" ? *std::ranges::min_element(list.items, less)
                                : *std::ranges::max_element(list.items, less);
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

template Value<double> QuantityScope<double>::extreme_of_list(const Call&, const Mark&, const Evaluator<double>&);
template Value<Dual<1>> QuantityScope<Dual<1>, double>::extreme_of_list(const Call&, const Mark&,
                                                                        const Evaluator<Dual<1>>&);
template Value<Dual<1>> QuantityScope<Dual<1>>::extreme_of_list(const Call&, const Mark&, const Evaluator<Dual<1>>&);
template Value<Dual<1, Dual<1>>> QuantityScope<Dual<1, Dual<1>>, Dual<1>>::extreme_of_list(
    const Call&, const Mark&, const Evaluator<Dual<1, Dual<1>>>&);
template Value<Formula> QuantityScope<Formula>::extreme_of_list(const Call&, const Mark&, const Evaluator<Formula>&);
template Value<Dual<1, Formula>> QuantityScope<Dual<1, Formula>, Formula>::extreme_of_list(
    const Call&, const Mark&, const Evaluator<Dual<1, Formula>>&);
template Value<double> QuantityScope<double>::modes(const solve::Linearisation&, int);
template Value<Dual<1>> QuantityScope<Dual<1>, double>::modes(const solve::Linearisation&, int);
template Value<Dual<1>> QuantityScope<Dual<1>>::modes(const solve::Linearisation&, int);
template Value<Dual<1, Dual<1>>> QuantityScope<Dual<1, Dual<1>>, Dual<1>>::modes(const solve::Linearisation&, int);
template Value<Formula> QuantityScope<Formula>::modes(const solve::Linearisation&, int);
template Value<Dual<1, Formula>> QuantityScope<Dual<1, Formula>, Formula>::modes(const solve::Linearisation&, int);

}  // namespace poinsot::problem
