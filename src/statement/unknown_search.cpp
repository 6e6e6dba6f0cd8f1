#include "statement/unknown_search.h"

#include <Eigen/Dense>
#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <random>

#include "statement/reader.h"

namespace poinsot::statement {
namespace {

constexpr double most_seconds = 8;  // of all searches of a statement together

template <class Item>
void add_once(std::vector<Item>& list, const Item& item) {
  if (std::find(list.begin(), list.end(), item) == list.end()) list.push_back(item);
}

std::string listed(const std::vector<Unknown>& unknowns) {
  std::string names;
  for (const Unknown& unknown : unknowns) names += (names.empty() ? "" : ", ") + unknown.name;
  return names;
}

bool satisfies_where(const Statement& statement, const std::vector<std::size_t>& situations,
                     const AllSettings& settings, const std::set<std::string>& sought) {
  for (std::size_t i : situations)
    for (const Expression& condition : statement.situations[i].problem.where) {
      // What speaks of unknowns that are found later is judged then.
      std::set<std::string> names;
      collect_names(condition, names);
      const bool later = std::any_of(names.begin(), names.end(), [&](const std::string& name) {
        return sought.contains(name) && !settings[i].contains(name);
      });
      if (later) continue;
      DataScope<double> data(statement.situations[i].problem, settings[i]);
      const Value<double> value = data.value(condition);
      if (value.is_boolean() && !value.truth) return false;
    }
  return true;
}

// Whether forces take part in what fixes the unknowns of a problem.
bool has_force_conditions(const Problem& problem) {
  if (problem.steady) return true;
  for (const Instant& instant : problem.instants)
    for (const Fact& fact : instant.facts)
      if (level_of(problem, fact.quantity) == Level::force && !is_later(problem, instant)) return true;
  return false;
}

bool is_bare(const Expression& expression, const std::string& name) {
  if (const Unary* unary = expression.as<Unary>()) return is_bare(unary->operand, name);
  const Name* word = expression.as<Name>();
  return word && word->primes == 0 && word->name == name;
}
bool stands_in(const Expression& place, const std::string& name) {
  const List* list = place.as<List>();
  return list && std::any_of(list->items.begin(), list->items.end(),
                             [&](const Expression& item) { return is_bare(item, name) || stands_in(item, name); });
}
// A length that is a coordinate of a mass center has either sign.
bool is_center_coordinate(const Problem& problem, const std::string& name) {
  return std::any_of(problem.bodies.begin(), problem.bodies.end(),
                     [&](const Body& body) { return body.center && stands_in(*body.center, name); });
}
// A length that stands by itself in the coordinates of a place may have either sign.
bool is_place_coordinate(const Problem& problem, const std::string& name) {
  if (std::any_of(problem.points.begin(), problem.points.end(),
                  [&](const NamedExpression& point) { return stands_in(point.value, name); }))
    return true;
  for (const Body& body : problem.bodies)
    for (const auto* parts : {&body.parts, &body.added})
      for (const poinsot::statement::Part& part : *parts)
        for (const NamedExpression& argument : part.shape.arguments)
          if (stands_in(argument.value, name)) return true;
  for (const Joint& joint : problem.joints) {
    if (stands_in(joint.place, name) || (joint.at && stands_in(*joint.at, name))) return true;
    for (const Freedom& freedom : joint.freedoms)
      if (freedom.position && is_bare(*freedom.position, name)) return true;
  }
  return std::any_of(problem.loads.begin(), problem.loads.end(),
                     [&](const Load& load) { return load.at && stands_in(*load.at, name); });
}

bool same_root(const AllSettings& a, const AllSettings& b, const std::vector<Unknown>& unknowns) {
  for (const Unknown& unknown : unknowns)
    for (std::size_t i = 0; i < a.size(); ++i) {
      const auto left = a[i].find(unknown.name), right = b[i].find(unknown.name);
      if (left == a[i].end() || right == b[i].end()) continue;
      const auto close = [&](double x, double y) {
        return std::abs(x - y) <= 1e-9 * std::max({std::abs(x), std::abs(y), unknown.unit.factor});
      };
      if (!close(left->second.number, right->second.number)) return false;
      for (std::size_t k = 0; k < 3; ++k)
        if (!close(left->second.vector[k], right->second.vector[k])) return false;
    }
  return true;
}

void merge(RootsFound& all, const RootsFound& more) {
  for (const std::string& name : more.open) add_once(all.open, name);
  for (const std::string& text : more.warnings) add_once(all.warnings, text);
  if (more.alternative) all.alternative = more.alternative;
}

}  // namespace

// `where:` comparisons between one unknown and values narrow its range.
void narrow_ranges(const Problem& problem, const Settings& settings, std::vector<solve::RootRange>& ranges,
                   const SlotOf& slot_of) {
  for (const Expression& condition : problem.where) {
    const Comparison* comparison = condition.as<Comparison>();
    if (!comparison)
      fail(problem.file, condition.mark(), "a condition under where: is a comparison", "write 0 deg < b < 90 deg");
    for (std::size_t i = 0; i + 1 < comparison->operands.size(); ++i) {
      const Expression &left = comparison->operands[i], &right = comparison->operands[i + 1];
      const bool less = comparison->relations[i] == Relation::less || comparison->relations[i] == Relation::less_equal;
      const bool greater =
          comparison->relations[i] == Relation::greater || comparison->relations[i] == Relation::greater_equal;
      const auto value_of = [&](const Expression& e) -> std::optional<double> {
        DataScope<double> data(problem, settings);
        try {
          const Value<double> value = data.value(e);
          return value.is_number() ? std::optional(value.number) : std::nullopt;
        } catch (const StatementError&) {
          return std::nullopt;  // it names an unknown itself
        }
      };
      for (const auto& [name, bound, above] : {std::tuple{&left, &right, greater}, std::tuple{&right, &left, less}}) {
        const Name* word = name->template as<Name>();
        const auto slot = word && word->primes == 0 ? slot_of(word->name) : std::nullopt;
        const auto value = slot ? value_of(*bound) : std::nullopt;
        if (!value || !(less || greater)) continue;
        solve::RootRange& range = ranges[*slot];
        const bool open = comparison->relations[i] == Relation::less || comparison->relations[i] == Relation::greater;
        if (above && *value >= range.lower) {
          range.lower = *value;
          range.lower_open = open;
        } else if (!above && *value <= range.upper) {
          range.upper = *value;
          range.upper_open = open;
        }
      }
    }
  }
}

UnknownSearch::UnknownSearch(const Statement& statement, const Settings& settings) : statement_(statement) {
  for (const auto& [name, value] : settings) known_.insert(name);
  for (const Situation& situation : statement.situations)
    for (const Unknown& unknown : situation.problem.find)
      if (!known_.contains(unknown.name) &&
          std::none_of(unknowns_.begin(), unknowns_.end(), [&](const Unknown& u) { return u.name == unknown.name; }))
        unknowns_.push_back(unknown);
}

bool UnknownSearch::is_own(std::size_t situation, const std::string& name) const {
  const auto& own = statement_.situations[situation].own_unknowns;
  return std::find(own.begin(), own.end(), name) != own.end();
}
bool UnknownSearch::is_common(const std::string& name) const {
  for (std::size_t i = 0; i < statement_.situations.size(); ++i)
    if (is_own(i, name)) return false;
  return true;
}

std::vector<UnknownSearch::Group> UnknownSearch::groups_of(std::size_t situation) const {
  const Problem& problem = statement_.situations[situation].problem;
  std::vector<Group> groups{{situation, Aspect::velocities}};
  if (has_force_conditions(problem)) groups.push_back({situation, Aspect::forces});
  if (has_later_facts(problem)) groups.push_back({situation, Aspect::later});
  return groups;
}

std::vector<std::size_t> UnknownSearch::situations_of(const Search& search) const {
  std::vector<std::size_t> situations;
  for (const Group& group : search.groups) add_once(situations, group.situation);
  return situations;
}

double UnknownSearch::seconds_left() const {
  const double spent = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun_).count();
  return std::max(0.1, most_seconds - spent);
}

RootsFound UnknownSearch::find(const Settings& settings, const OpenChoice& choice) {
  choice_ = choice;
  choice_.trial = true;
  begun_ = std::chrono::steady_clock::now();
  RootsFound found;
  found.roots.push_back(AllSettings(statement_.situations.size(), settings));
  const auto refine = [&](const Search& search) {
    if (search.unknowns.empty()) return;
    std::vector<AllSettings> refined;
    for (const AllSettings& root : found.roots) {
      const RootsFound more = find_with_choices(search, root);
      refined.insert(refined.end(), more.roots.begin(), more.roots.end());
      merge(found, more);
    }
    constexpr std::size_t most_roots = 64;
    if (refined.size() > most_roots) {
      found.warnings.push_back("only the first " + std::to_string(most_roots) + " of " +
                               std::to_string(refined.size()) + " solutions are given");
      refined.resize(most_roots);
    }
    found.roots = std::move(refined);
  };
  Search common;
  for (const Unknown& unknown : unknowns_)
    if (is_common(unknown.name)) common.unknowns.push_back(unknown);
  for (std::size_t i = 0; i < statement_.situations.size(); ++i)
    if (statement_.situations[i].own_unknowns.empty())
      for (const Group& group : groups_of(i)) common.groups.push_back(group);
  refine(common);
  for (std::size_t i = 0; i < statement_.situations.size(); ++i) {
    Search own{{}, groups_of(i)};
    for (const Unknown& unknown : statement_.situations[i].problem.find)
      if (is_own(i, unknown.name) && !known_.contains(unknown.name)) own.unknowns.push_back(unknown);
    refine(own);
  }
  return found;
}

// Unknowns of what is not chosen are zero; every choice that leads to a solution gives one.
RootsFound UnknownSearch::find_with_choices(const Search& search, const AllSettings& settings) {
  std::vector<const Choice*> choices;
  for (std::size_t i : situations_of(search))
    for (const Choice& choice : statement_.situations[i].problem.choose)
      if (std::none_of(choices.begin(), choices.end(), [&](const Choice* other) { return other->name == choice.name; }))
        choices.push_back(&choice);
  if (choices.empty()) return find_by_blocks(search, settings);
  if (choices.size() > 1) fail(statement_.file, choices[1]->mark, "only one choice can be made in a problem");
  const Choice& choice = *choices.front();
  // What does not depend on the choice is found before it.
  std::set<std::string> chosen_unknowns;
  for (const std::string& name : choice.of) chosen_unknowns.merge(unknowns_of(name));
  Search rest = search;
  RootsFound all;
  all.roots.push_back(settings);
  const auto solve_first = [&](const Search& block) {
    std::vector<AllSettings> refined;
    for (const AllSettings& root : all.roots) {
      const RootsFound found = find_block(block, root, false);
      refined.insert(refined.end(), found.roots.begin(), found.roots.end());
      merge(all, found);
    }
    all.roots = std::move(refined);
    std::erase_if(rest.unknowns, [&](const Unknown& unknown) {
      return std::any_of(block.unknowns.begin(), block.unknowns.end(),
                         [&](const Unknown& u) { return u.name == unknown.name; });
    });
    std::erase_if(rest.groups, [&](const Group& group) {
      return std::find(block.groups.begin(), block.groups.end(), group) != block.groups.end();
    });
  };
  for (const Search& block : blocks_of(search, settings)) {
    if (std::any_of(block.unknowns.begin(), block.unknowns.end(),
                    [&](const Unknown& u) { return chosen_unknowns.contains(u.name); }))
      break;
    solve_first(block);
  }
  const std::vector<AllSettings> before = std::move(all.roots);
  all.roots.clear();
  for (const AllSettings& root : before) {
    // Where all holds without any of them, none is needed.
    if (RootsFound none = find_subset(rest, root, choice, 0); !none.roots.empty() && none.open.empty()) {
      all.roots.insert(all.roots.end(), none.roots.begin(), none.roots.end());
      continue;
    }
    // Of linear conditions, the least total is reached by no more amounts than there are independent conditions.
    const std::size_t most = choice.least_total ? independent_conditions(rest, root) : 0;
    double least = std::numeric_limits<double>::infinity();
    std::vector<AllSettings> chosen;
    for (std::size_t subset = 0; subset < (std::size_t{1} << choice.of.size()); ++subset) {
      const auto count = static_cast<std::size_t>(std::popcount(subset));
      if (choice.least_total ? count > most : count != static_cast<std::size_t>(choice.exactly)) continue;
      RootsFound found = find_subset(rest, root, choice, subset);
      if (choice.least_total && !found.open.empty()) continue;  // fewer would do
      for (AllSettings& more : found.roots) {
        if (choice.least_total) {
          const double total = total_of(choice, more);
          if (total > least * (1 + 1e-9)) continue;
          if (total < least * (1 - 1e-9)) chosen.clear();
          least = std::min(least, total);
        }
        const bool known = std::any_of(chosen.begin(), chosen.end(), [&](const AllSettings& other) {
          return same_root(more, other, search.unknowns);
        });
        if (!known) chosen.push_back(std::move(more));
      }
      if (found.roots.empty()) continue;
      for (const std::string& name : found.open) add_once(all.open, name);
      if (found.alternative) all.alternative = found.alternative;
    }
    all.roots.insert(all.roots.end(), chosen.begin(), chosen.end());
  }
  if (all.roots.empty() && !before.empty())
    all.warnings.push_back(
        (choice.least_total
             ? "no amounts of what stands under '" + choice.name + "' satisfy"
             : "no choice of " + std::to_string(choice.exactly) + " of them under '" + choice.name + "' satisfies") +
        " all conditions with values in their ranges (durations, masses and pushes are not negative)");
  return all;
}

// With the amounts of what is not chosen zero.
RootsFound UnknownSearch::find_subset(const Search& search, const AllSettings& settings, const Choice& choice,
                                      std::size_t subset) {
  AllSettings chosen = settings;
  Search others = search;
  std::vector<Value<double>> names;
  const auto give = [&](const std::string& name, const Value<double>& value) {
    for (Settings& one : chosen) one[name] = value;
  };
  for (std::size_t k = 0; k < choice.of.size(); ++k) {
    if (subset >> k & 1) {
      names.push_back(Value<double>::of_text(choice.of[k]));
      continue;
    }
    for (const std::string& name : unknowns_of(choice.of[k])) {
      const auto unknown = std::find_if(others.unknowns.begin(), others.unknowns.end(),
                                        [&](const Unknown& u) { return u.name == name; });
      if (unknown == others.unknowns.end()) continue;
      give(name, Value<double>::of_number(0, unknown->unit.dimension));
      others.unknowns.erase(unknown);
    }
  }
  give(choice.name, Value<double>::of_list(std::move(names)));
  if (!others.unknowns.empty()) return find_block(others, chosen, false);
  RootsFound nothing_to_find;
  const Slots none = slots_of(others, chosen, false);
  const auto equations = equations_of(others, none, chosen, nothing_to_find).equations({});
  if (!equations) return nothing_to_find;
  double misfit = 0;
  for (double value : equations->values) misfit = std::max(misfit, std::abs(value));
  if (misfit <= 1e-9 * std::max(equations->size, 1e-300)) nothing_to_find.roots.push_back(std::move(chosen));
  return nothing_to_find;
}

double UnknownSearch::total_of(const Choice& choice, const AllSettings& settings) const {
  double total = 0;
  std::optional<Dimension> dimension;
  for (const std::string& name : choice.of)
    for (const std::string& unknown : unknowns_of(name)) {
      const auto sought =
          std::find_if(unknowns_.begin(), unknowns_.end(), [&](const Unknown& u) { return u.name == unknown; });
      if (sought == unknowns_.end()) continue;
      if (sought->vector)
        fail(statement_.file, choice.mark, "the amount '" + unknown + "' is a vector: it has no place in a sum");
      if (dimension && !same_kind(*dimension, sought->unit.dimension))
        fail(statement_.file, choice.mark, "the amounts under '" + choice.name + "' are of different kinds: no sum");
      dimension = sought->unit.dimension;
      for (const Settings& one : settings)
        if (const auto found = one.find(unknown); found != one.end()) {
          total += found->second.number;
          break;
        }
    }
  return total;
}

// How many independent conditions there are on the unknowns, at some values of them.
std::size_t UnknownSearch::independent_conditions(const Search& search, const AllSettings& settings) {
  const Slots slots = slots_of(search, settings, false);
  RootsFound unused;
  const solve::RootProblem problem = equations_of(search, slots, settings, unused);
  std::vector<double> x;
  for (const solve::RootRange& range : slots.ranges)
    x.push_back(std::isfinite(range.lower) ? range.lower + range.scale : range.scale);
  const auto base = problem.equations(x);
  if (!base) return slots.slots.size();
  Eigen::MatrixXd J(static_cast<Eigen::Index>(base->values.size()), static_cast<Eigen::Index>(x.size()));
  for (std::size_t k = 0; k < x.size(); ++k) {
    std::vector<double> moved = x;
    moved[k] += 0.01 * slots.ranges[k].scale;
    const auto there = problem.equations(moved);
    if (!there || there->values.size() != base->values.size()) return slots.slots.size();
    for (std::size_t i = 0; i < base->values.size(); ++i)
      J(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(k)) = there->values[i] - base->values[i];
  }
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(J);
  qr.setThreshold(1e-3);
  return static_cast<std::size_t>(qr.rank());
}

// The unknowns that stand in the data of an impulse, a load or an added mass.
std::set<std::string> UnknownSearch::unknowns_of(const std::string& name) const {
  std::set<std::string> names;
  const auto collect = [&](const std::optional<Expression>& expression) {
    if (expression) collect_names(*expression, names);
  };
  for (const Situation& situation : statement_.situations) {
    for (const Impulse& impulse : situation.problem.impulses)
      if (impulse.name == name)
        for (const auto* expression : {&impulse.value, &impulse.force, &impulse.lasts, &impulse.couple})
          collect(*expression);
    for (const Load& load : situation.problem.loads)
      if (load.name == name)
        for (const auto* expression : {&load.force, &load.couple}) collect(*expression);
    for (const Body& body : situation.problem.bodies)
      for (const Part& part : body.added)
        if (part.name == name) {
          collect(part.amount.mass);
          collect(part.amount.weight);
        }
  }
  return names;
}

// Unknowns that are found later do not matter yet, but need some value.
Settings UnknownSearch::with_trial_values(const Settings& settings) const {
  Settings all = settings;
  for (const Unknown& unknown : unknowns_) {
    const double one = unknown.unit.factor;
    all.emplace(unknown.name, unknown.vector ? Value<double>::of_vector({one, one, one}, unknown.unit.dimension)
                                             : Value<double>::of_number(one, unknown.unit.dimension));
  }
  return all;
}

solve::RootEquations UnknownSearch::misfits(const Search& search, const AllSettings& settings) const {
  solve::RootEquations all;
  for (std::size_t i : situations_of(search)) {
    const Problem& problem = statement_.situations[i].problem;
    const Settings all_known = with_trial_values(settings[i]);
    const auto wanted = [&](Aspect aspect) {
      return std::find(search.groups.begin(), search.groups.end(), Group{i, aspect}) != search.groups.end();
    };
    if (wanted(Aspect::later)) {
      const std::vector<double> later = later_misfits(problem, all_known, choice_);
      all.values.insert(all.values.end(), later.begin(), later.end());
      all.size = std::max(all.size, 1.0);
    }
    if (!wanted(Aspect::velocities) && !wanted(Aspect::forces)) continue;
    SolvedInstant instant(problem, all_known, When{0, problem.has_blow()}, choice_);
    const auto velocities = static_cast<std::ptrdiff_t>(instant.misfits().size());
    if (wanted(Aspect::forces)) instant.solve_forces();
    const auto& values = instant.misfits();
    all.values.insert(all.values.end(), wanted(Aspect::velocities) ? values.begin() : values.begin() + velocities,
                      values.end());
    all.size = std::max(all.size, instant.misfit_size());
  }
  return all;
}

// Which unknowns can be found before which: the groups of conditions in the order in which as few new unknowns as
// possible enter, each block with as many independent conditions as unknowns.
std::vector<UnknownSearch::Search> UnknownSearch::blocks_of(const Search& search, const AllSettings& settings) {
  if (search.unknowns.size() < 2 || search.groups.size() < 2) return {search};
  const Slots slots = slots_of(search, settings, false);
  const std::size_t n = slots.slots.size();
  std::mt19937_64 random(23);
  std::uniform_real_distribution<double> part(0.6, 1.4);
  // How the conditions change with each unknown, at some values that make sense.
  std::vector<Eigen::MatrixXd> slopes;
  for (int attempt = 0; attempt < 8 && slopes.empty(); ++attempt) {
    std::vector<double> x(n);
    for (std::size_t k = 0; k < n; ++k) {
      const solve::RootRange& range = slots.ranges[k];
      const bool low = std::isfinite(range.lower), high = std::isfinite(range.upper);
      x[k] = low && high ? range.lower + (range.upper - range.lower) * (part(random) - 0.5)
             : low       ? range.lower + range.scale * part(random)
             : high      ? range.upper - range.scale * part(random)
                         : range.scale * part(random) * (attempt % 2 == 0 ? 1 : -1);
    }
    std::vector<Eigen::MatrixXd> trial;
    try {
      for (const Group& group : search.groups) {
        const Search one{search.unknowns, {group}};
        const auto values_at = [&](const std::vector<double>& at) {
          const solve::RootEquations equations = misfits(one, settings_at(search, slots, settings, at));
          return Eigen::VectorXd(Eigen::Map<const Eigen::VectorXd>(equations.values.data(),
                                                                   static_cast<Eigen::Index>(equations.values.size())));
        };
        const Eigen::VectorXd base = values_at(x);
        const double size = std::max(1e-300, misfits(one, settings_at(search, slots, settings, x)).size);
        Eigen::MatrixXd J(base.size(), static_cast<Eigen::Index>(n));
        for (std::size_t k = 0; k < n; ++k) {
          std::vector<double> moved = x;
          moved[k] += 0.03 * slots.ranges[k].scale;
          const Eigen::VectorXd there = values_at(moved);
          if (there.size() != base.size()) return {search};
          J.col(static_cast<Eigen::Index>(k)) = (there - base) / size;
        }
        trial.push_back(std::move(J));
      }
      slopes = std::move(trial);
    } catch (const StatementError& error) {
      refusal_ = error;
    }
  }
  if (slopes.empty()) return {search};
  const auto moves = [&](std::size_t group, std::size_t slot) {
    return slopes[group].rows() > 0 && slopes[group].col(static_cast<Eigen::Index>(slot)).cwiseAbs().maxCoeff() > 1e-11;
  };
  std::vector<Search> blocks;
  std::set<std::string> found;
  std::vector<bool> used(search.groups.size());
  for (;;) {
    // The new unknowns of each group; those of the group with the fewest, and more groups until they suffice.
    std::set<std::string> block;
    std::size_t best = search.groups.size();
    const auto fresh = [&](std::size_t g) {
      std::set<std::string> names;
      for (std::size_t k = 0; k < n; ++k)
        if (moves(g, k) && !found.contains(slots.slots[k].unknown->name)) names.insert(slots.slots[k].unknown->name);
      return names;
    };
    bool solved = false;
    while (!solved) {
      std::size_t fewest = static_cast<std::size_t>(-1);
      best = search.groups.size();
      for (std::size_t g = 0; g < search.groups.size(); ++g) {
        if (used[g]) continue;
        std::set<std::string> more = fresh(g);
        std::erase_if(more, [&](const std::string& name) { return block.contains(name); });
        if (more.empty() || more.size() >= fewest) continue;
        fewest = more.size();
        best = g;
      }
      if (best == search.groups.size()) break;
      block.merge(fresh(best));
      // Enough conditions among those that speak of nothing else?
      std::vector<Eigen::Index> columns;
      for (std::size_t k = 0; k < n; ++k)
        if (block.contains(slots.slots[k].unknown->name)) columns.push_back(static_cast<Eigen::Index>(k));
      Eigen::MatrixXd all(0, static_cast<Eigen::Index>(columns.size()));
      for (std::size_t g = 0; g < search.groups.size(); ++g) {
        const std::set<std::string> names = fresh(g);
        if (used[g] || !std::includes(block.begin(), block.end(), names.begin(), names.end())) continue;
        const Eigen::MatrixXd part_of = slopes[g](Eigen::all, columns);
        Eigen::MatrixXd more(all.rows() + part_of.rows(), all.cols());
        more << all, part_of;
        all = std::move(more);
      }
      Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(all);
      qr.setThreshold(1e-8);
      solved = qr.rank() == all.cols();
    }
    if (!solved) break;
    Search one;
    for (const Unknown& unknown : search.unknowns)
      if (block.contains(unknown.name)) one.unknowns.push_back(unknown);
    for (std::size_t g = 0; g < search.groups.size(); ++g) {
      const std::set<std::string> names = fresh(g);
      if (used[g] || !std::includes(block.begin(), block.end(), names.begin(), names.end())) continue;
      one.groups.push_back(search.groups[g]);
      used[g] = true;
    }
    found.merge(block);
    blocks.push_back(std::move(one));
  }
  // The rest together: it is short of conditions, or nothing is left.
  Search rest;
  for (const Unknown& unknown : search.unknowns)
    if (!found.contains(unknown.name)) rest.unknowns.push_back(unknown);
  for (std::size_t g = 0; g < search.groups.size(); ++g)
    if (!used[g]) rest.groups.push_back(search.groups[g]);
  if (!rest.unknowns.empty()) blocks.push_back(std::move(rest));
  return blocks;
}

RootsFound UnknownSearch::find_by_blocks(const Search& search, const AllSettings& settings) {
  RootsFound all;
  all.roots.push_back(settings);
  for (const Search& block : blocks_of(search, settings)) {
    std::vector<AllSettings> refined;
    for (const AllSettings& root : all.roots) {
      const RootsFound found = find_block(block, root, false);
      refined.insert(refined.end(), found.roots.begin(), found.roots.end());
      merge(all, found);
    }
    all.roots = std::move(refined);
  }
  return all;
}

UnknownSearch::Slots UnknownSearch::slots_of(const Search& search, const AllSettings& settings,
                                             bool negative_lengths) const {
  Slots slots;
  const std::vector<std::size_t> situations = situations_of(search);
  const std::size_t first = situations.empty() ? 0 : situations.front();
  const Problem& problem = statement_.situations[first].problem;
  for (const Unknown& unknown : search.unknowns) {
    for (std::size_t k = 0; k < (unknown.vector ? 3u : 1u); ++k) {
      slots.slots.push_back({&unknown, k});
      solve::RootRange range;
      range.scale = unknown.unit.factor;
      range.lower = -std::numeric_limits<double>::infinity();
      range.upper = std::numeric_limits<double>::infinity();
      slots.ranges.push_back(range);
    }
  }
  // The unit in which an unknown is wanted is a natural size of it, unless the problem is of another order altogether.
  try {
    std::vector<double> ones;
    for (const Slot& slot : slots.slots) ones.push_back(slot.unknown->unit.factor);
    const AllSettings trial = settings_at(search, slots, settings, ones);
    const Settings all_known = with_trial_values(trial[first]);
    SolvedInstant instant(problem, all_known, When{}, choice_);
    for (std::size_t k = 0; k < slots.slots.size(); ++k) {
      const double natural = instant.natural_size(slots.slots[k].unknown->unit.dimension),
                   ratio = natural / slots.ranges[k].scale;
      if (std::isfinite(ratio) && ratio > 0 && (ratio > 1e6 || ratio < 1e-6)) slots.ranges[k].scale = natural;
    }
  } catch (const StatementError&) {
    // These values make no sense; the units serve.
  }
  for (std::size_t i : situations)
    narrow_ranges(statement_.situations[i].problem, settings[i], slots.ranges,
                  [&](const std::string& name) -> std::optional<std::size_t> {
                    for (std::size_t k = 0; k < slots.slots.size(); ++k)
                      if (slots.slots[k].unknown->name == name && !slots.slots[k].unknown->vector) return k;
                    return std::nullopt;
                  });
  // A stated range is the range; where nothing is stated, nature says.
  for (std::size_t k = 0; k < slots.slots.size(); ++k) {
    const Unknown& unknown = *slots.slots[k].unknown;
    const Dimension& d = unknown.unit.dimension;
    solve::RootRange& range = slots.ranges[k];
    // What is chosen among can only push.
    const bool push = std::any_of(problem.choose.begin(), problem.choose.end(), [&](const Choice& choice) {
      return std::any_of(choice.of.begin(), choice.of.end(),
                         [&](const std::string& name) { return unknowns_of(name).contains(unknown.name); });
    });
    const bool length = d == dimensions::length && !is_center_coordinate(problem, unknown.name) &&
                        !(negative_lengths && is_place_coordinate(problem, unknown.name));
    const bool open = !std::isfinite(range.lower) && !(range.upper <= 0);
    if (open && !unknown.vector && (d == dimensions::mass || d == dimensions::time || length || push)) range.lower = 0;
    if (d != dimensions::angle) continue;
    constexpr double half_turn = 3.141592653589793;
    range.scale = 1;
    if (!std::isfinite(range.lower)) range.lower = range.upper > -half_turn ? -half_turn : range.upper - 2 * half_turn;
    if (!std::isfinite(range.upper)) range.upper = range.lower < half_turn ? half_turn : range.lower + 2 * half_turn;
  }
  return slots;
}

AllSettings UnknownSearch::settings_at(const Search& search, const Slots& slots, const AllSettings& settings,
                                       const std::vector<double>& x) const {
  AllSettings all = settings;
  const std::vector<std::size_t> reached = situations_of(search);
  for (std::size_t k = 0; k < slots.slots.size(); ++k) {
    const Unknown& unknown = *slots.slots[k].unknown;
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (std::find(reached.begin(), reached.end(), i) == reached.end() && !is_common(unknown.name)) continue;
      if (!unknown.vector) {
        all[i][unknown.name] = Value<double>::of_number(x[k], unknown.unit.dimension);
      } else {
        auto [entry, fresh] =
            all[i].emplace(unknown.name, Value<double>::of_vector(Vector3<double>::zero(), unknown.unit.dimension));
        entry->second.vector[slots.slots[k].component] = x[k];
      }
    }
  }
  return all;
}

solve::RootProblem UnknownSearch::equations_of(const Search& search, const Slots& slots, const AllSettings& settings,
                                               RootsFound& found) {
  solve::RootProblem problem;
  problem.ranges = slots.ranges;
  const auto exact = [this, search, slots,
                      settings](const std::vector<double>& x) -> std::optional<solve::RootEquations> {
    try {
      const solve::RootEquations equations = misfits(search, settings_at(search, slots, settings, x));
      makes_sense_ = true;
      return equations;
    } catch (const StatementError& error) {
      // Values without sense are outside the range; a statement without sense has no value anywhere.
      refusal_ = error;
      return std::nullopt;
    }
  };
  problem.equations = exact;
  // Without the squares of some unknowns: the equations, linear in these around zero.
  std::vector<std::size_t> small;
  for (std::size_t i : situations_of(search))
    for (const Expression& square : statement_.situations[i].problem.neglect)
      for (std::size_t k = 0; k < slots.slots.size(); ++k)
        if (slots.slots[k].unknown->name == square.as<Binary>()->left.as<Name>()->name) add_once(small, k);
  if (small.empty()) return problem;
  problem.equations = [exact, small,
                       ranges = slots.ranges](const std::vector<double>& x) -> std::optional<solve::RootEquations> {
    std::vector<double> at = x;
    for (std::size_t k : small) at[k] = 0;
    auto sum = exact(at);
    if (!sum) return std::nullopt;
    for (std::size_t k : small) {
      const double h = 0.5 * ranges[k].scale;
      at[k] = h;
      const auto ahead = exact(at);
      at[k] = -h;
      const auto behind = exact(at);
      at[k] = 0;
      if (!ahead || !behind) return std::nullopt;
      for (std::size_t i = 0; i < sum->values.size(); ++i)
        sum->values[i] += (ahead->values[i] - behind->values[i]) / (2 * h) * x[k];
    }
    return sum;
  };
  std::string names;
  for (std::size_t k : small) names += (names.empty() ? "" : ", ") + slots.slots[k].unknown->name + "^2";
  found.warnings.push_back("neglected, as stated: " + names);
  return problem;
}

// What the author states for the unknowns of one search to satisfy.
std::string UnknownSearch::conditions_in_words(const Search& search) const {
  std::vector<std::string> words;
  const bool several = statement_.situations.size() > 1;
  for (const Group& group : search.groups) {
    const Situation& situation = statement_.situations[group.situation];
    const std::string where = several ? " @ " + situation.name : "";
    for (const Instant& instant : situation.problem.instants) {
      if (instant.rest && group.aspect == Aspect::velocities) add_once(words, "rest at '" + instant.name + "'" + where);
      for (const Fact& fact : instant.facts) {
        const Level level = level_of(situation.problem, fact.quantity);
        const Aspect aspect = level == Level::motion || is_later(situation.problem, instant) ? Aspect::later
                              : level == Level::force                                        ? Aspect::forces
                                                                                             : Aspect::velocities;
        if (group.aspect == aspect &&
            (level != Level::position || !fact.quantity.as<Name>() || aspect == Aspect::later))
          add_once(words, to_string(fact.quantity) + " at '" + instant.name + "'" + where);
      }
    }
    if (situation.problem.steady && group.aspect != Aspect::later)
      add_once(words, "steady motion in '" + situation.problem.steady->frame + "'" + where);
  }
  std::string text;
  for (std::size_t i = 0; i < words.size() && i < 8; ++i) text += (i == 0 ? "" : "; ") + words[i];
  return text + (words.size() > 8 ? "; ..." : "");
}

RootsFound UnknownSearch::find_block(const Search& search, const AllSettings& settings, bool negative_lengths) {
  RootsFound found;
  const Slots slots = slots_of(search, settings, negative_lengths);
  const solve::RootProblem problem = equations_of(search, slots, settings, found);
  makes_sense_ = false;
  const solve::Roots result = solve::find_roots(problem, seconds_left());
  std::set<std::string> sought;
  for (const Unknown& unknown : unknowns_) sought.insert(unknown.name);
  bool excluded = false;
  for (std::vector<double> point : result.points) {
    // What is left of zero by rounding is zero.
    for (std::size_t k = 0; k < point.size(); ++k)
      if (std::abs(point[k]) <= 1e-13 * slots.ranges[k].scale) point[k] = 0;
    AllSettings root = settings_at(search, slots, settings, point);
    if (satisfies_where(statement_, situations_of(search), root, sought))
      found.roots.push_back(std::move(root));
    else
      excluded = true;
  }
  if (!result.alternative.empty()) found.alternative = settings_at(search, slots, settings, result.alternative);
  for (std::size_t k : result.open_unknowns) add_once(found.open, slots.slots[k].unknown->name);
  if (!found.roots.empty()) {
    if (result.search == solve::RootSearch::many_starts)
      found.warnings.push_back("the roots were found from " + std::to_string(result.starts) +
                               " starts; others are not excluded");
    return found;
  }
  // A coordinate of a point may turn out to be negative.
  const Problem& first = statement_.situations[search.groups.front().situation].problem;
  if (!negative_lengths && std::any_of(search.unknowns.begin(), search.unknowns.end(), [&](const Unknown& unknown) {
        return unknown.unit.dimension == dimensions::length && is_place_coordinate(first, unknown.name);
      }))
    return find_block(search, settings, true);
  if (!makes_sense_ && refusal_) throw *refusal_;
  const std::string conditions = conditions_in_words(search);
  std::string how = result.search == solve::RootSearch::linear
                        ? " (the equations are linear)"
                        : " (searched from " + std::to_string(result.starts) + " starts)";
  if (excluded) how += " with what stands under where:";
  found.warnings.push_back("no values of " + listed(search.unknowns) + " in their ranges satisfy all conditions" + how +
                           (conditions.empty() ? "" : ": " + conditions));
  return found;
}

}  // namespace poinsot::statement
