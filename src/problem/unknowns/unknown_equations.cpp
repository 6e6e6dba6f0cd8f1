#include "problem/unknowns/unknown_equations.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <string_view>

#include "problem/course/course.h"
#include "problem/entries/drawn_letters.h"
#include "problem/instant/instant_conditions.h"
#include "problem/language/words.h"
#include "problem/unknowns/unknown_ranges.h"

namespace poinsot::problem {
namespace {

std::string words_of(const ConditionSource& source) {
  const std::string where = source.instant ? " at '" + source.instant->name + "'" : "";
  return (source.fact ? to_string(source.fact->quantity) : "rest") + where;
}

// The latest of the instants that are called by their time.
std::optional<double> latest_time(const Situation& situation, SolvedInstant& instant) {
  std::optional<double> latest;
  for (const Instant& one : situation.instants) {
    if (!one.when || !is_later(situation, one) || one.found_when) continue;
    try {
      const double time = instant.data_number(one.when, dimensions::time);
      if (time > latest.value_or(0)) latest = time;
    } catch (const StatementError&) {
      // Stages and their ends have names.
    }
  }
  return latest;
}

}  // namespace

UnknownEquations::UnknownEquations(const Statement& statement, UnknownSystem system, const AllSettings& settings,
                                   const OpenChoice& choice, const std::vector<Unknown>& all)
    : statement_(statement),
      system_(std::move(system)),
      settings_(settings),
      choice_(choice),
      trial_(settings),
      slots_(system_.slots(statement_)) {
  choice_.trial = true;
  for (Settings& one : trial_)
    for (const Unknown& unknown : all) {
      const double unit = unknown.unit.factor;
      one.emplace(unknown.name, value_of_unknown(unknown, {unit, unit, unit}, statement.situations.front().plane));
    }
  const std::vector<std::size_t> situations = system_.situations();
  // Natural sizes come from the problem, with each unknown at one unit.
  std::vector<double> natural(slots_.size(), 0.0);
  try {
    const auto natural_sizes = [&](double units) {
      std::vector<double> values, sizes;
      for (const UnknownSlot& slot : slots_) values.push_back(units * slot.unknown.unit.factor);
      put(values, trial_);
      const std::size_t first = situations.empty() ? 0 : situations.front();
      SolvedInstant instant(statement_.situations[first], trial_[first], When{}, choice_);
      const std::optional<double> time = latest_time(statement_.situations[first], instant);
      for (const UnknownSlot& slot : slots_) {
        const Dimension& dimension = slot.unknown.unit.dimension;
        sizes.push_back(instant.natural_size(dimension));
        // Where nothing moves or pulls at the start, the time until which something is asked sets the pace.
        if (sizes.back() == 0 && dimension.time < 0 && time)
          sizes.back() = natural_unit(instant.scales(), dimension) * std::pow(*time, dimension.time / 12.0);
      }
      return sizes;
    };
    natural = natural_sizes(1);
    // An unknown as large as its unit may be what sets the size of all, as 1 kg m^2 does in a watch. With next to
    // nothing in place of the unknowns the data alone set it; what then vanishes with the unknowns has no size by them.
    constexpr double next_to_nothing = 1e-15, far = 1e4;
    const std::vector<double> by_data = natural_sizes(next_to_nothing);
    for (std::size_t k = 0; k < slots_.size(); ++k) {
      const double unit = slots_[k].unknown.unit.factor;
      if (by_data[k] > far * next_to_nothing * unit && by_data[k] < unit / far) natural[k] = by_data[k];
    }
  } catch (const StatementError&) {
    // The problem makes no sense at these values, and units serve as natural sizes.
  }
  ranges_ = ranges_of(statement_, system_, settings_, natural);
  for (std::size_t i : situations)
    for (const Expression& square : statement_.situations[i].neglect)
      for (std::size_t k = 0; k < slots_.size(); ++k)
        if (slots_[k].unknown.name == square.as<Binary>()->left.as<Name>()->name) add_once(small_, k);
}

void UnknownEquations::refuse(const StatementError& error) {
  refused_alike_ = refused_alike_ && (!refusal_ || std::string_view(refusal_->what()) == error.what());
  if (!refusal_) refusal_ = error;
}

void UnknownEquations::put(const std::vector<double>& x, AllSettings& settings) const {
  const std::vector<std::size_t> reached = system_.situations();
  for (std::size_t k = 0; k < slots_.size(); ++k) {
    const Unknown& unknown = slots_[k].unknown;
    const bool common = is_common(statement_, unknown.name);
    for (std::size_t i = 0; i < settings.size(); ++i) {
      if (!common && std::find(reached.begin(), reached.end(), i) == reached.end()) continue;
      Value<double>& value = settings[i][unknown.name];
      if (unknown.vector) {
        if (!value.is_vector()) value = Value<double>::of_vector(Vector3<double>::zero(), unknown.unit.dimension);
        value.vector[slots_[k].component] = x[k];
      } else {
        value = Value<double>::of_number(x[k], unknown.unit.dimension);
      }
    }
  }
}

AllSettings UnknownEquations::settings_at(const std::vector<double>& x) const {
  AllSettings settings = settings_;
  put(x, settings);
  return settings;
}

std::vector<std::string> UnknownEquations::condition_words(const GroupConditions& group) const {
  const std::string& situation = statement_.situations[group.group.situation].name;
  std::vector<std::string> list;
  for (const std::string& words : group.words)
    list.push_back(words + (statement_.situations.size() > 1 ? " @ " + situation : ""));
  return list;
}

std::vector<std::vector<double>> UnknownEquations::places(std::size_t count) const {
  std::vector<std::vector<double>> list;
  std::mt19937_64 random(23);
  std::uniform_real_distribution<double> part(0.6, 1.4);
  for (std::size_t i = 0; i < count; ++i) {
    std::vector<double>& x = list.emplace_back();
    for (const solve::RootRange& range : ranges_) {
      const bool low = std::isfinite(range.lower), high = std::isfinite(range.upper);
      const double draw = i == 0 ? 1.05 : part(random);
      x.push_back(low && high ? range.lower + (range.upper - range.lower) * (draw - 0.5)
                  : low       ? range.lower + range.scale * draw
                  : high      ? range.upper - range.scale * draw
                              : range.scale * draw * (i % 2 == 0 ? 1 : -1));
    }
  }
  return list;
}

bool UnknownEquations::follows_motion() const {
  return std::any_of(system_.groups.begin(), system_.groups.end(),
                     [](const ConditionGroup& group) { return group.aspect == Aspect::later; });
}

bool UnknownEquations::add_left_over(GroupConditions& group, InstantSystem which, const SolvedInstant& instant,
                                     bool with_words) const {
  const solve::LinearSystem& system = instant.equations_of(which);
  const auto held = measures_.eliminations.find({group.group.situation, which});
  const auto left = held == measures_.eliminations.end() ? std::nullopt : held->second.remainder(system);
  if (!left) return false;
  group.values.insert(group.values.end(), left->values.begin(), left->values.end());
  if (with_words)
    for (const std::size_t equation : left->equations) {
      const ConditionSource source = instant.source_of(which, equation);
      group.words.push_back(source.instant ? words_of(source) : std::string(system.words(equation)));
    }
  group.size = std::max(group.size, left->size);
  for (const SolvedInstant::NonlinearMisfit& misfit : instant.nonlinear_misfits(which, left->solution)) {
    group.values.push_back(misfit.value);
    if (with_words) group.words.push_back(words_of(misfit.source));
    group.size = std::max(group.size, misfit.size);
  }
  return true;
}

const UnknownEquations::Evaluated& UnknownEquations::evaluate(const std::vector<double>& x, Wanted wanted) {
  const bool with_words = wanted == Wanted::smooth_with_words;
  hold_measures();
  evaluated_.reset();
  put(x, trial_);
  Evaluated all{x, wanted, {}, {}};
  bool smooth = true, complete = true;
  const auto add = [](std::vector<double>& list, auto first, auto last) { list.insert(list.end(), first, last); };
  solve::RootEquations& equations = all.equations;
  std::vector<std::pair<std::size_t, double>> later_sizes;  // by the place of the value
  for (std::size_t i : system_.situations()) {
    const Situation& situation = statement_.situations[i];
    const auto has = [&](Aspect aspect) { return system_.has({i, aspect}); };
    const auto group_of = [&](Aspect aspect) -> GroupConditions& {
      all.groups.push_back({{i, aspect}, {}, 0, {}});
      return all.groups.back();
    };
    if (has(Aspect::later)) {
      GroupConditions& group = group_of(Aspect::later);
      for (const FactMisfit& misfit : later_misfits(situation, trial_[i], choice_, motion_tolerance_)) {
        group.values.push_back(misfit.value);
        later_sizes.push_back({equations.values.size() + group.values.size() - 1, misfit.size});
      }
      group.size = 1;
      if (with_words) group.words.assign(group.values.size(), "what is stated of the motion");
      add(equations.values, group.values.begin(), group.values.end());
      equations.size = std::max(equations.size, 1.0);
      smooth = false;
    }
    if (!has(Aspect::positions) && !has(Aspect::velocities) && !has(Aspect::forces)) continue;
    OpenChoice choice = choice_;
    if (const auto held = measures_.scales.find(i); held != measures_.scales.end()) choice.scales = held->second;
    auto& solved = all.instants[i];
    solved = std::make_unique<SolvedInstant>(situation, trial_[i], When{0, situation.has_blow()}, choice);
    SolvedInstant& instant = *solved;
    const auto positions = static_cast<std::ptrdiff_t>(instant.position_misfits());
    const auto velocities = static_cast<std::ptrdiff_t>(instant.misfits().size());
    if (has(Aspect::forces)) {
      // The misfits can be formed without solving the equations for forces.
      if (wanted == Wanted::everything)
        instant.solve_forces();
      else
        instant.assemble_forces();
    }
    const auto& values = instant.misfits();
    if (has(Aspect::positions)) {
      GroupConditions& group = group_of(Aspect::positions);
      add(group.values, values.begin(), values.begin() + positions);
      group.size = 1;
      if (with_words)
        for (const ConditionSource& source : instant.position_sources()) group.words.push_back(words_of(source));
      add(equations.values, values.begin(), values.begin() + positions);
    }
    if (has(Aspect::velocities)) {
      GroupConditions& group = group_of(Aspect::velocities);
      complete = complete && add_left_over(group, InstantSystem::velocities, instant, with_words);
      if (instant.after_blow()) complete = complete && add_left_over(group, InstantSystem::blow, instant, with_words);
      add(equations.values, values.begin() + positions, values.begin() + velocities);
    }
    if (has(Aspect::forces)) {
      GroupConditions& group = group_of(Aspect::forces);
      complete = complete && add_left_over(group, InstantSystem::motion, instant, with_words);
      add(equations.values, values.begin() + velocities, values.end());
    }
    equations.size = std::max(equations.size, instant.misfit_size());
  }
  // What follows from a motion is not measured by the terms of the equations at its start.
  if (!later_sizes.empty()) {
    equations.sizes.assign(equations.values.size(), equations.size);
    for (const auto& [place, size] : later_sizes) equations.sizes[place] = size;
  }
  if (!complete) all.groups.clear();
  std::sort(all.groups.begin(), all.groups.end(), [&](const GroupConditions& a, const GroupConditions& b) {
    const auto place = [&](const ConditionGroup& group) {
      return std::find(system_.groups.begin(), system_.groups.end(), group);
    };
    return place(a.group) < place(b.group);
  });
  if (smooth)
    for (const GroupConditions& group : all.groups) {
      add(equations.smooth, group.values.begin(), group.values.end());
      equations.smooth_size = std::max(equations.smooth_size, group.size);
    }
  return evaluated_.emplace(std::move(all));
}

std::optional<solve::RootEquations> UnknownEquations::exact(const std::vector<double>& x, Wanted wanted) {
  try {
    solve::RootEquations equations = evaluate(x, wanted).equations;
    makes_sense_ = true;
    return equations;
  } catch (const StatementError& error) {
    // If only these values make no sense, they are outside the range; a statement that makes no sense has values
    // nowhere.
    refuse(error);
    return std::nullopt;
  }
}

std::optional<std::vector<GroupConditions>> UnknownEquations::conditions_at(const std::vector<double>& x) {
  try {
    return evaluate(x, Wanted::smooth_with_words).groups;
  } catch (const StatementError& error) {
    refuse(error);
    return std::nullopt;
  }
}

// Where squares are neglected, the equations are replaced by their linear part around zero.
std::optional<solve::RootEquations> UnknownEquations::operator()(const std::vector<double>& x) {
  if (small_.empty()) return exact(x);
  std::vector<double> at = x;
  for (std::size_t k : small_) at[k] = 0;
  if (!linear_part_ || linear_part_->at != at) linear_part_ = linear_part(at);
  if (!linear_part_) return std::nullopt;
  solve::RootEquations sum{linear_part_->values, linear_part_->size};
  for (std::size_t row = 0; row < sum.values.size(); ++row)
    for (std::size_t i = 0; i < small_.size(); ++i) {
      const double term = linear_part_->slopes[row][i] * x[small_[i]];
      sum.values[row] += term;
      sum.size = std::max(sum.size, std::abs(term));
    }
  return sum;
}

std::optional<solve::RootEquations> UnknownEquations::smooth(const std::vector<double>& x) {
  if (all_smooth_) {
    auto equations = exact(x, Wanted::smooth);
    if (!equations) return std::nullopt;
    all_smooth_ = !equations->smooth.empty();
    equations->values.clear();
    if (all_smooth_) return equations;
  }
  return exact(x);
}

bool UnknownEquations::hold_as_set() {
  const std::vector<std::size_t> reached = system_.situations();
  if (reached.empty()) return false;
  std::vector<double> x;
  for (const UnknownSlot& slot : slots_) {
    const auto known = settings_[reached.front()].find(slot.unknown.name);
    if (known == settings_[reached.front()].end()) return false;
    x.push_back(slot.unknown.vector ? known->second.vector[slot.component] : known->second.number);
  }
  const auto equations = (*this)(x);
  const auto vanish = [](const std::vector<double>& values, double size) {
    // Of the terms: values in the settings have the digits of a search or of a file, of which ten are reckoned with.
    constexpr double as_written = 1e-10;
    return std::all_of(values.begin(), values.end(),
                       [&](double value) { return std::abs(value) <= as_written * size; });
  };
  return equations && vanish(equations->values, equations->size) && vanish(equations->smooth, equations->smooth_size);
}

solve::RootProblem UnknownEquations::problem() {
  solve::RootProblem problem;
  problem.ranges = ranges_;
  problem.corners = statement_.corners;
  problem.costly = follows_motion();
  problem.equations = [this](const std::vector<double>& x) { return (*this)(x); };
  if (!problem.costly && small_.empty()) {
    // Smooth equations alone are evaluated faster, as forces need not be solved.
    if (std::any_of(system_.groups.begin(), system_.groups.end(),
                    [](const ConditionGroup& group) { return group.aspect == Aspect::forces; }))
      problem.smooth = [this](const std::vector<double>& x) { return smooth(x); };
    problem.slopes = [this](const std::vector<double>& x, std::vector<std::vector<double>>* slopes) {
      return with_slopes(x, slopes);
    };
  }
  if (problem.costly)
    problem.rough = [this](const std::vector<double>& x) {
      // For a step, where 1e-12 is usual: a scan must see signs, and what it finds is polished with the usual one.
      motion_tolerance_ = 1e-9;
      linear_part_.reset();
      auto equations = (*this)(x);
      motion_tolerance_.reset();
      linear_part_.reset();
      return equations;
    };
  return problem;
}

}  // namespace poinsot::problem
