#include "problem/unknowns/extremum.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "problem/instant/contact_state_search.h"
#include "problem/language/diagnostic.h"
#include "problem/language/words.h"
#include "problem/unknowns/states_at_end.h"
#include "problem/witness/particle_witness.h"

namespace poinsot::problem {
namespace {

constexpr double boundless = std::numeric_limits<double>::infinity();
// Of the scale of the datum: a value below this counts as vanishing, since bisection towards zero would never end.
constexpr double nothing = 1e-6;
// From a value inside to one at which it is doubtful, and so much farther on what is asked fails: not as far again, or
// the place between both would be the doubtful one.
constexpr double past_the_end = 0.7;

}  // namespace

std::size_t situation_of(const Statement& statement, const Ask& ask) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < statement.situations.size(); ++i) {
    names.push_back(statement.situations[i].name);
    if (names.back() == ask.extremum->situation) return i;
  }
  const std::string all = joined(names);
  if (!ask.extremum->situation.empty())
    fail(statement.file, ask.extremum->situation_mark, "there is no situation '" + ask.extremum->situation + "'",
         all.empty() ? "the file states none: remove situation:" : "known: " + all);
  if (names.size() > 1)
    fail(statement.file, ask.mark, "in which situation is this asked?", "write situation: one of " + all);
  return 0;
}

ExtremumSearch::ExtremumSearch(const Statement& statement, const Ask& ask, const AllSettings& settings,
                               const OpenChoice& choice)
    : statement_(statement),
      ask_(ask),
      settings_(settings),
      choice_(choice),
      situation_(statement.situations[situation_of(statement, ask)]),
      seeks_states_(leaves_states_open(situation_, *ask.extremum)) {
  const std::string& name = ask.extremum->name;
  std::vector<std::string> names;
  for (const Letter& letter : situation_.letters) {
    names.push_back(letter.name);
    if (letter.name == name) dimension_ = letter.unit.dimension;
  }
  for (const Unknown& unknown : situation_.find) {
    names.push_back(unknown.name);
    if (unknown.name == name) dimension_ = unknown.unit.dimension;
  }
  for (const NamedExpression& item : situation_.given) names.push_back(item.name);
  if (std::ranges::find(names, name) == names.end())
    fail(situation_.file, ask.extremum->name_mark, "'" + name + "' is no datum and no letter",
         names.empty() ? "name what is varied under letters:" : "one of these is varied: " + joined(names));
  for (const NamedExpression& item : situation_.given)
    if (item.name == name) {
      DataScope<double> data(situation_, settings_[situation_of(statement, ask)]);
      const Value<double> value = data.value(item.value);
      if (!value.is_number()) fail(situation_.file, ask.extremum->name_mark, "'" + name + "' is no number");
      dimension_ = value.dimension;
    }
}

double ExtremumSearch::natural_size(const Settings& settings) const {
  OpenChoice choice = choice_;
  choice.trial = true;
  try {
    return SolvedInstant(situation_, settings, When{}, choice).natural_size(dimension_);
  } catch (const StatementError&) {
    return 0;
  }
}

// Data are positive unless they are angles or stated as signed.
ExtremumSearch::Span ExtremumSearch::span() const {
  const std::string& name = ask_.extremum->name;
  const bool signed_letter =
      std::any_of(situation_.letters.begin(), situation_.letters.end(),
                  [&](const Letter& letter) { return letter.name == name && letter.either_sign; });
  Span span{signed_letter ? -boundless : 0, boundless, 1};
  if (dimension_ == dimensions::angle) span = {-3.141592653589793, 3.141592653589793, 1};
  for (const Letter& letter : situation_.letters)
    if (letter.name == name) span.scale = letter.unit.factor;
  for (const Unknown& unknown : situation_.find)
    if (unknown.name == name) span.scale = unknown.unit.factor;
  const Settings& own = settings_[situation_of(statement_, ask_)];
  // A unit is a natural size, unless the problem is of another order.
  if (!is_pure(dimension_)) {
    // Four orders, as for unknowns (unknown_ranges.cpp): people choose units within a thousand of what they measure.
    constexpr double far = 1e4;
    const double natural = natural_size(own);
    if (natural > far * span.scale || (natural > 0 && natural < span.scale / far)) span.scale = natural;
  }
  for (const NamedExpression& item : situation_.given) {
    if (item.name != name) continue;
    DataScope<double> data(situation_, own);
    if (const double size = std::abs(data.value(item.value).number); size > 0) span.scale = size;
  }
  std::vector<solve::RootRange> ranges{{span.lower, span.upper, span.scale, false, false}};
  narrow_ranges(situation_, own, ranges, [&](const std::string& word) -> std::optional<std::size_t> {
    return word == name ? std::optional<std::size_t>(0) : std::nullopt;
  });
  return {ranges[0].lower, ranges[0].upper, span.scale};
}

std::optional<double> ExtremumSearch::own_value() const {
  const std::string& name = ask_.extremum->name;
  const Settings& own = settings_[situation_of(statement_, ask_)];
  if (const auto set = own.find(name); set != own.end()) return set->second.number;
  for (const NamedExpression& item : situation_.given)
    if (item.name == name) return DataScope<double>(situation_, own).value(item.value).number;
  return std::nullopt;
}

bool ExtremumSearch::has_unknowns() const {
  return std::any_of(situation_.find.begin(), situation_.find.end(),
                     [&](const Unknown& unknown) { return unknown.name != ask_.extremum->name; });
}

std::vector<AllSettings> ExtremumSearch::settings_at(double value, const Statement& statement) const {
  const std::size_t home = situation_of(statement_, ask_);
  AllSettings all = settings_;
  for (Settings& one : all) one[ask_.extremum->name] = Value<double>::of_number(value, dimension_);
  // The other unknowns of the situation are found for each value of the datum.
  if (!has_unknowns()) return {std::move(all)};
  Settings known = all[home];
  for (const Unknown& unknown : situation_.find)
    if (unknown.name != ask_.extremum->name) known.erase(unknown.name);
  UnknownSearch search(statement, known);
  return search.find(known).roots;
}

std::vector<ExtremumSearch::Found> ExtremumSearch::found_at(double value) {
  if (seeks_states_ && has_unknowns()) return found_beside_unknowns(value);
  std::vector<Found> found;
  const std::size_t home = situation_of(statement_, ask_);
  for (AllSettings& root : settings_at(value, statement_)) {
    // What the caller keeps is shared without an owner.
    if (!seeks_states_) {
      found.push_back({std::shared_ptr<const Statement>(std::shared_ptr<void>(), &statement_), std::move(root)});
      continue;
    }
    const HeldStates held = states_that_hold(with_states_open(situation_), home, root[home], false,
                                             wanted_to_stick(situation_, *ask_.extremum));
    if (held.all.empty() && !held.doubts.empty())
      fail(situation_.file, ask_.extremum->name_mark, "what contacts do could not be judged " + held.doubts.front());
    for (const std::vector<ContactState>& states : held.all) {
      auto statement = std::make_shared<Statement>(statement_);
      put_in_states(statement->situations[home], home, states);
      found.push_back({std::move(statement), root});
    }
  }
  return found;
}

bool ExtremumSearch::conditions_hold_in(Sample& sample) {
  const std::size_t home = situation_of(statement_, ask_);
  for (const Expression& condition : ask_.extremum->conditions) {
    const Value<double> truth = sample.value_in(home, condition);
    if (!truth.is_boolean())
      fail(situation_.file, condition.mark(), "'" + to_string(condition) + "' neither holds nor fails",
           "write stable(plate), touching(mesh), taut(wire), or a comparison");
    ever_ = true;
    if (truth.truth) continue;
    failed_ = &condition;
    const Call* call = condition.as<Call>();
    doubtful_ = doubtful_ || (call && call->function == "stable" &&
                              sample.value_in(home, with_function(*call, condition, "stability")).text != "unstable");
    return false;
  }
  return true;
}

std::unique_ptr<Sample> ExtremumSearch::sample_at(double value) {
  for (Found& found : found_at(value)) {
    auto sample = std::make_unique<Sample>(found.statement, found.settings, choice_);
    if (!conditions_hold_in(*sample)) continue;
    confirm(value, *sample);
    return sample;
  }
  return nullptr;
}

// At the far end that a search begins from, what is wrong may be nothing beside what grows faster: conditions are
// confirmed where they hold on the way, unless that was done nearby.
void ExtremumSearch::confirm(double value, const Sample& sample) {
  if (choice_.trial || (confirmed_at_ && std::abs(value - *confirmed_at_) <= 0.5 * std::abs(value))) return;
  confirmed_at_ = value;
  for (const auto& [home, instant] : sample.instants())
    unconfirmed_ = unconfirmed_ || !confirmed_by_particles(*instant);
}

std::optional<NearMotion> ExtremumSearch::near_motion(const Expression& stable, double value) try {
  const std::vector<AllSettings> roots = settings_at(value, statement_);
  if (roots.size() != 1) return std::nullopt;
  const std::size_t home = situation_of(statement_, ask_);
  Sample sample(statement_, roots.front(), choice_);
  const Call& call = *stable.as<Call>();
  NearMotion motion{sample.value_in(home, with_function(call, stable, "growth_rate")).number, {}};
  for (const Value<double>& frequency : sample.value_in(home, with_function(call, stable, "frequencies")).items)
    motion.frequencies.push_back(frequency.number);
  return motion;
} catch (const StatementError&) {
  return std::nullopt;
}

std::optional<StabilityEnd> ExtremumSearch::stability_ends(double inside, double outside) {
  failed_ = nullptr;
  Truth beyond = truth_at(outside);
  if (beyond == Truth::doubtful) {
    // The end itself lies there, as where it is a round number and one of the values that are tried.
    const Span range = span();
    outside += past_the_end * (outside - inside);
    if (outside < range.lower || outside > range.upper) return std::nullopt;
    beyond = truth_at(outside);
  }
  if (beyond != Truth::fails || !failed_) return std::nullopt;
  const Expression& stable = *failed_;
  const Call* call = stable.as<Call>();
  if (!call || call->function != "stable") return std::nullopt;
  const auto end = stability_end([&](double value) { return near_motion(stable, value); }, inside, outside);
  if (!end || !holds(end->steady_at)) return std::nullopt;
  return end;
}

ExtremumSearch::Truth ExtremumSearch::truth_at(double value) {
  try {
    doubtful_ = false;
    if (sample_at(value)) return Truth::holds;
    return doubtful_ ? Truth::doubtful : Truth::fails;
  } catch (const ContradictionError& error) {
    refusal_ = error;
    contradicted_ = true;
    unanswered_ = false;
    return Truth::refused;
  } catch (const StatementError& error) {
    refusal_ = error;
    contradicted_ = false;
    unanswered_ = dynamic_cast<const UnansweredError*>(&error);
    return Truth::refused;
  }
}

std::string ExtremumSearch::in_unit(double value) const {
  Unit unit = situation_.habits.unit_for(dimension_);
  for (const Letter& letter : situation_.letters)
    if (letter.name == ask_.extremum->name) unit = letter.unit;
  for (const Unknown& unknown : situation_.find)
    if (unknown.name == ask_.extremum->name) unit = unknown.unit;
  if (ask_.unit) unit = *ask_.unit;
  return with_digits(value / unit.factor, 8) + (unit.text.empty() || unit.text == "1" ? "" : " " + unit.text);
}

bool ExtremumSearch::is_at(double value) {
  const double side = ask_.extremum->largest ? 1 : -1;
  const Span range = span();
  // Far above what ends are found to, and no more than is shown of them.
  const double step = 1e-6 * (value != 0 ? std::abs(value) : range.scale);
  // Beyond the end of its range a datum has no values.
  const bool at_end = side > 0 ? value >= range.upper : value <= range.lower;
  return holds(at_end ? value : value - side * step) && (at_end || !holds(value + side * step));
}

ExtremumFound ExtremumSearch::find() {
  ExtremumFound found = found_end();
  if (found.value && found.note.empty() && sticks_beyond(found.value->number))
    return {{}, "the laws of friction do not confirm that it ends at " + in_unit(found.value->number), {}, {}};
  if (const double end = found.value ? found.value->number : holds_to_;
      !unconfirmed_ && (found.value || holds_to_ != 0)) {
    const Nearer nearer = look_nearer(end);
    if (found.value && !nearer.by_intervals.empty()) return {{}, nearer.by_intervals, {}, {}};
    if (!nearer.note.empty()) {
      std::string& told = found.value ? found.note : found.reason;
      told += (told.empty() ? "" : "; ") + nearer.note;
    }
  }
  if (!unconfirmed_) return found;
  return {{}, "the bodies as particles do not confirm its conditions where they were tried", {}, {}};
}

// No end: it holds as far as values were tried, or as the equations tell.
ExtremumFound ExtremumSearch::no_end_up_to(double value, bool tried) {
  holds_to_ = value;
  return {{},
          std::string("no ") + (ask_.extremum->largest ? "largest" : "smallest") + " value was found: it holds up to " +
              in_unit(value) + "; beyond, " + (tried ? "no values were tried" : "nothing can be told"),
          {},
          {}};
}

ExtremumFound ExtremumSearch::found_end() {
  const Span range = span();
  const double side = ask_.extremum->largest ? 1 : -1;
  // The grid of values runs towards the end that is asked for: evenly if the range is finite, otherwise in decades.
  // Six values to each of the six decades about the scale: what holds on less than a sixth of a decade
  // alone is sought by its margin (held_between).
  constexpr int count = 36;
  std::vector<double> grid;
  for (int i = 0; i <= count; ++i) {
    const double t = static_cast<double>(i) / count;
    const double far = range.scale * std::pow(10, 6 * t - 3);
    if (std::isfinite(range.lower) && std::isfinite(range.upper)) {
      grid.push_back(range.lower + t * (range.upper - range.lower));
      continue;
    }
    if (!std::isfinite(range.upper)) grid.push_back(std::isfinite(range.lower) ? range.lower + far : far);
    if (!std::isfinite(range.lower)) grid.push_back(std::isfinite(range.upper) ? range.upper - far : -far);
  }
  if (!std::isfinite(range.upper) || !std::isfinite(range.lower))
    grid.push_back(std::isfinite(range.lower) ? range.lower : std::isfinite(range.upper) ? range.upper : 0);
  // What holds nearby alone holds at the value that the datum has, if anywhere.
  if (const auto own = own_value(); own && *own >= range.lower && *own <= range.upper) grid.push_back(*own);
  std::sort(grid.begin(), grid.end());
  grid.erase(std::unique(grid.begin(), grid.end()), grid.end());
  if (side < 0) std::reverse(grid.begin(), grid.end());
  // Where nothing in the problem gives the datum a size, its unit is a guess: the end may lie many decades farther out.
  // With the three of the grid that is more than lies between any two units of one quantity.
  constexpr int more_decades = 15;
  const double by_units = grid.back();
  for (int i = 0; i < more_decades && !std::isfinite(side > 0 ? range.upper : range.lower) && holds(grid.back()); ++i)
    grid.push_back(10 * grid.back());
  ExtremumFound found;
  const std::string what = std::string(side > 0 ? "largest" : "smallest") + " value";
  // The search goes inwards from that end to the first value at which the conditions hold.
  auto at = std::find_if(grid.rbegin(), grid.rend(), [&](double value) { return holds(value); });
  // It may hold farther out on the other side: the unit that somebody chose for the datum is no measure.
  constexpr int decades = 6;
  if (at == grid.rend() && ever_ && !std::isfinite(side > 0 ? range.lower : range.upper))
    for (int i = 0; i < decades && at == grid.rend(); ++i) {
      grid.insert(grid.begin(), 10 * grid.front());
      if (holds(grid.front())) at = std::prev(grid.rend());
    }
  // What holds within a narrow range of values alone, as a force with little friction, has its largest margin there.
  if (const std::optional<double> between = at == grid.rend() && ever_ ? held_between(grid) : std::nullopt) {
    grid.insert(std::ranges::find_if(grid, [&](double value) { return side * (value - *between) > 0; }), *between);
    at = std::find(grid.rbegin(), grid.rend(), *between);
  }
  if (at == grid.rend()) {
    // At the ends of the grid, at zero above all, something else may be wrong than at values that are meant.
    if (!ever_ && refusal_ && truth_at(grid[grid.size() / 2]) == Truth::refused) {
      if (!unanswered_) throw *refusal_;
      const Diagnostic& why = refusal_->diagnostics().front();
      found.reason = why.message + (why.hint.empty() ? "" : ": " + why.hint);
      return found;
    }
    found.reason = "it holds at none of " + std::to_string(grid.size()) + " values from " +
                   in_unit(*std::min_element(grid.begin(), grid.end())) + " to " +
                   in_unit(*std::max_element(grid.begin(), grid.end()));
    return found;
  }
  double inside = *at, outside = at == grid.rbegin() ? *at : *std::prev(at);
  const bool open_end = !std::isfinite(side > 0 ? range.upper : range.lower);
  if (at == grid.rbegin() && open_end) {
    // So it may end farther out.
    const double anchor =
        side > 0 ? (std::isfinite(range.lower) ? range.lower : 0) : (std::isfinite(range.upper) ? range.upper : 0);
    Truth beyond = Truth::holds;
    for (int i = 0; i < decades && beyond == Truth::holds; ++i) {
      inside = outside;
      outside = anchor + 10 * (outside - anchor);
      beyond = truth_at(outside);
    }
    // So far out what is doubtful or makes no sense may be so by rounding alone.
    if (beyond != Truth::fails) return no_end_up_to(beyond == Truth::holds ? outside : inside, beyond == Truth::holds);
  } else if (at == grid.rbegin() && situation_.has_friction() && !is_pure(dimension_) && *at == 0) {
    // A load that is asked for may well turn round; a coefficient of friction cannot.
    found.reason = "there is no " + what +
                   " above zero, where the values that are tried end: it holds there too. State '" +
                   ask_.extremum->name + "' with the opposite sense, and ask for its " +
                   (side > 0 ? "smallest" : "largest") + " value";
    return found;
  } else if (at == grid.rbegin()) {
    found.value = Value<double>::of_number(*at, dimension_);
    found.sample = sample_at(*at);
    found.note = "it holds at " + in_unit(*at) + ", where the values that are tried end";
    return found;
  }
  // Bisection finds the border between this value and the one before, if it is no end of stability that is found from
  // some distance: where the values are as close as this part of themselves, and at last a hundred times closer.
  double close = 3e-2;
  for (int i = 0; i < 200; ++i) {
    const double middle = 0.5 * (inside + outside), width = std::abs(outside - inside);
    if (width <= 4e-15 * std::abs(middle) || middle == inside || middle == outside) break;
    if (width <= close * std::abs(middle) && close > 1e-4) {
      if (const std::optional<StabilityEnd> end = stability_ends(inside, outside)) {
        found.value = Value<double>::of_number(end->value, dimension_);
        found.sample = sample_at(end->steady_at);
        return found;
      }
      close /= 100;
    }
    (holds(middle) ? inside : outside) = middle;
  }
  // A datum that may be arbitrarily small has no least value.
  const bool to_nothing = range.lower == 0 && side < 0 && inside < nothing * range.scale;
  if (to_nothing && truth_at(outside) != Truth::fails) {
    found.reason =
        "there is no " + what + ": it holds down to " + in_unit(inside) + ", below which nothing can be told";
    return found;
  }
  // Equations that contradict each other everywhere beyond hold up to here within their rounding alone: what grows in
  // them with the datum is as small as that. No answer to what was asked ends there.
  if (truth_at(outside) == Truth::refused && contradicted_) {
    found.reason = "there is no " + what + " of what is stated: beyond " + in_unit(inside) + ", " +
                   refusal_->diagnostics().front().message;
    return found;
  }
  // What contacts do is decided up to the rounding of forces, so that what ends at zero does so a little beyond it.
  constexpr double decided = 1e-8;  // of the natural size of the datum
  if (side > 0 && range.lower == 0 && situation_.has_friction() &&
      inside < decided * natural_size(settings_[situation_of(statement_, ask_)]) && holds(0)) {
    found.value = Value<double>::of_number(0, dimension_);
    found.sample = sample_at(0);
    found.note = "it holds at zero alone, as far as forces are told apart";
    return found;
  }
  // Beyond any unit that would be chosen rates of motions are so unlike that rounding hides which of them vanish.
  if (open_end && std::abs(inside) > std::abs(by_units) && truth_at(outside) == Truth::doubtful &&
      !told_beyond(inside, outside).empty())
    return no_end_up_to(inside, false);
  if (const std::optional<double> end = sticking_ends(inside, outside)) inside = *end;
  found.note = told_beyond(inside, outside);
  found.value = Value<double>::of_number(inside, dimension_);
  found.sample = sample_at(inside);
  return found;
}

}  // namespace poinsot::problem
