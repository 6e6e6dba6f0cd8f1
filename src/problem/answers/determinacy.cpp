#include "problem/answers/determinacy.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <string_view>
#include <utility>

#include "poinsot/engine/work/work_scope.h"
#include "problem/answers/share_ranges.h"
#include "problem/instant/open_words.h"
#include "problem/language/diagnostic.h"
#include "problem/language/expression_walk.h"
#include "problem/language/words.h"
#include "problem/results/compare_values.h"
#include "problem/unknowns/extremum.h"

namespace poinsot::problem {
namespace {

// Relative difference between two choices up to which an answer is the same. Rounding makes 1e-12 of it in long chains
// of bodies; what is open enters an answer by more than this wherever it is varied by its own size.
constexpr double same_tolerance = 1e-9;
// The same if unknowns are found anew, to 1e-9 of themselves and worse where roots nearly meet.
constexpr double refound_tolerance = 1e-7;
// Of the natural size of an ask, where an answer is next to nothing beside its terms: ten times their rounding.
constexpr double rounding_of_terms = 1e-11;

// Times the work that all answers were; and what a motion may take that was followed before there were answers.
constexpr Work most_of_the_work = 10, work_of_a_motion = 500'000'000;

using Values = std::vector<std::optional<WatchedValue>>;

class Variation {
 public:
  Variation(const AnswersFound& found, Solution& result)
      : found_(found), result_(result), fixed_(found.asked.values.size(), {true, true, true}) {}

  std::set<std::string> mark() {
    bool any = false, gravity = false;
    for (const Situation& situation : found_.statement.situations) gravity = gravity || !situation.gravity;
    for (const auto& [home, instant] : found_.sample.instants()) any = any || instant->uses_any();
    for (const std::unique_ptr<Sample>& sample : found_.asked.extremal)
      for (const auto& [home, instant] : sample->instants()) any = any || instant->uses_any();
    if (any) vary({.seed = 11, .any = true}, [reason = reason_of_any()](const Ask&) { return reason; });
    if (gravity)
      vary({.seed = 12, .gravity = size_of_gravity()}, [](const Ask&) {
        return std::string("it depends on gravity, of which nothing is said: write gravity: -y or gravity: none");
      });
    // Each open direction is varied by itself, so that only what changes an answer is named.
    std::size_t velocities = 0, forces = 0;
    for (const auto& [home, instant] : found_.sample.instants()) {
      velocities = std::max(velocities, instant->velocities().open.size());
      if (instant->forces_solved()) forces = std::max(forces, instant->motion().open.size());
      if (instant->after_blow()) forces = std::max(forces, instant->blow().open.size());
    }
    std::size_t turnings = 0;
    for (const auto& [situation, motion] : found_.sample.motions()) {
      turnings = std::max(turnings, motion->open_turnings().size());
      forces = std::max({forces, motion->open_impulses(), motion->open_forces().size()});
    }
    vary_velocities(std::min(velocities, most_directions));
    // In a motion all open directions at its start are varied together, since each variation follows the motion anew.
    if (velocities == 0 && turnings > 0)
      vary(
          {.seed = 13, .velocities = true, .direction = OpenChoice::every},
          [&](const Ask& ask) {
            std::vector<std::string> names;
            for (std::size_t d = 0; d < turnings; ++d) add_open_names(ask, d, names);
            return open_velocities(names, turnings);
          },
          [&](std::size_t i, const auto& other) { return differs_beyond_following(i, other); });
    const auto is_found = [](const SolvedAsk& ask) { return ask.state == AskState::found; };
    std::vector<bool> until_now;
    std::ranges::transform(result_.asks, std::back_inserter(until_now), is_found);
    for (std::size_t d = 0; d < std::min(forces, most_directions); ++d)
      vary(
          {.seed = 14, .forces = true, .direction = d}, [&](const Ask& ask) { return open_force_of(ask, d); },
          [&](std::size_t i, const auto& other) { return differs_by_forces(i, other); });
    for (std::size_t i = 0; i < until_now.size(); ++i)
      if (until_now[i] && !is_found(result_.asks[i]))
        if (const std::string range = range_in_words(found_.statement.asks[i], result_.asks[i], found_.sample);
            !range.empty())
          add_reason(result_.asks[i], range);
    // A single one is varied once more too, where no motion has to be followed again for it.
    const std::size_t open = any + gravity + velocities + forces;
    if (open > 1 || (open > 0 && found_.sample.motions().empty()))
      vary_together(any, gravity, velocities > 0, forces > 0);
    tell_fixed_components();
    return moved_unknowns_;
  }

 private:
  static constexpr std::size_t most_directions = 60;
  static constexpr double tiny = 1e-300;  // in place of a size of zero

  std::string reason_of_any() const {
    std::vector<std::string> bodies;
    for (const Body& body : found_.statement.situations.front().bodies)
      if (body.inertia && body.inertia->rest_any && body.inertia->mark == body.mark)
        bodies.push_back("'" + body.name + "'");
    const std::string reason = "it depends on a value that is given as `any`";
    return bodies.empty() ? reason : reason + ", or on the inertia of " + listed(bodies) + ", which is not stated";
  }

  // Gravity of which nothing is said is varied by what the machine itself is accelerated with, or else its effect would
  // drown in the rounding of the rest. Where nothing moves or pushes any gravity is seen: that of the earth serves.
  double size_of_gravity() const {
    constexpr double on_earth = 10;  // m/s^2
    double size = 0;
    for (const auto& [home, instant] : found_.sample.instants())
      size = std::max(size, instant->natural_size(dimensions::acceleration));
    return size > 0 ? size : on_earth;
  }

  // The settings with the unknowns found anew, if they may depend on the choice; nothing if no solution is found.
  std::optional<AllSettings> settings_for(const OpenChoice& choice) {
    if (found_.search.unknowns().empty() || !(choice.any || choice.gravity > 0 || choice.velocities))
      return found_.settings;
    if (found_.search.still_holds(found_.settings, choice)) return found_.settings;
    Settings known = found_.settings.front();
    for (const Unknown& unknown : found_.search.unknowns()) known.erase(unknown.name);
    const RootsFound found = found_.search.find(known, choice);
    const auto distance = [&](const AllSettings& root) {
      double sum = 0;
      for (std::size_t i = 0; i < root.size(); ++i)
        for (const Unknown& unknown : found_.search.unknowns())
          if (const auto moved = distance_of(unknown, root[i], i); moved && *moved > 0)
            sum += *moved / std::max(size_of_unknown(unknown, i), tiny);
      return sum;
    };
    const auto nearest =
        std::min_element(found.roots.begin(), found.roots.end(),
                         [&](const AllSettings& a, const AllSettings& b) { return distance(a) < distance(b); });
    if (nearest == found.roots.end()) return std::nullopt;
    return *nearest;
  }
  // The distance of an unknown from its value in the solution; nothing if it has no value.
  std::optional<double> distance_of(const Unknown& unknown, const Settings& settings, std::size_t situation) const {
    const auto& base = std::as_const(found_.settings[situation]);
    const auto a = settings.find(unknown.name);
    const auto b = base.find(unknown.name);
    if (a == settings.end() || b == base.end()) return std::nullopt;
    return std::abs(a->second.number - b->second.number) + norm(a->second.vector - b->second.vector);
  }
  void note_moved_unknowns(const AllSettings& settings) {
    for (const Unknown& unknown : found_.search.unknowns())
      for (std::size_t i = 0; i < settings.size(); ++i) {
        const std::optional<double> moved = distance_of(unknown, settings[i], i);
        if (!moved) continue;
        if (*moved > refound_tolerance * size_of_unknown(unknown, i)) moved_unknowns_.insert(unknown.name);
      }
  }
  // The size of an unknown in the solution, which must have it. One that is next to nothing beside the others of its
  // kind, or beside what is natural to the machine, is found to a part of these.
  double size_of_unknown(const Unknown& unknown, std::size_t situation) const {
    constexpr double next_to_nothing = 1e-6;  // of the others: it then counts as a millionth of them
    const auto& base = std::as_const(found_.settings[situation]);
    double beside = 0;
    for (const auto& [home, instant] : found_.sample.instants())
      beside = std::max(beside, instant->natural_size(unknown.unit.dimension));
    for (const Unknown& other : found_.search.unknowns())
      if (const auto value = base.find(other.name);
          value != base.end() && same_kind(other.unit.dimension, unknown.unit.dimension))
        beside = std::max(beside, size_of(value->second));
    return std::max(size_of(base.at(unknown.name)), next_to_nothing * beside);
  }

  Values varied(const OpenChoice& choice) {
    const std::vector<Ask>& asks = found_.statement.asks;
    const Values& base = found_.asked.values;
    const std::optional<AllSettings> settings = settings_for(choice);
    if (!settings) return Values(asks.size(), std::nullopt);
    note_moved_unknowns(*settings);
    Sample sample(found_.statement, *settings, choice);
    Values values;
    for (std::size_t i = 0; i < asks.size(); ++i) {
      // Nothing is held against an answer that was not found, and to follow a motion for it may take long.
      if (!base[i]) {
        values.emplace_back(std::nullopt);
        continue;
      }
      // Open forces have no influence on anything but forces.
      const bool only_forces = choice.forces && !choice.any && choice.gravity == 0 && !choice.velocities;
      if (only_forces && !rests_on_forces(asks[i])) {
        values.push_back(base[i]);
        continue;
      }
      try {
        // What they do not change takes the work that it took; what varies without order may be sought for long.
        std::optional<WorkScope> scope;
        if (only_forces) scope.emplace(std::max(most_of_the_work * found_.asked.work, work_of_a_motion));
        if (!asks[i].extremum)
          values.emplace_back(watched_value(found_.statement, sample, asks[i]));
        else if (base[i] && ExtremumSearch(found_.statement, asks[i], *settings, choice).is_at(base[i]->answer.number))
          values.push_back(base[i]);
        else
          values.emplace_back(std::nullopt);
      } catch (const StatementError&) {
        values.emplace_back(std::nullopt);
      } catch (const BudgetEnded&) {
        // Either this takes too long, or the caller waits no longer.
        check_budget();
        values.emplace_back(std::nullopt);
      }
    }
    return values;
  }

  // What is open of forces where the ask asks for them: at its instant, or along the motion.
  std::string open_force_of(const Ask& ask, std::size_t direction) {
    const SolvedInstant& instant = found_.sample.instant_of(ask);
    if (!instant.forces_solved())
      for (const auto& [situation, motion] : found_.sample.motions())
        if (direction < motion->open_forces().size()) return motion->open_forces()[direction];
    std::set<std::string> names;
    for (const Expression& expression : ask.of) collect_names(expression, names, true);
    return open_force(instant, direction, names);
  }

  bool rests_on_forces(const Ask& ask) const {
    std::vector<const Expression*> asked;
    for (const Expression& expression : ask.of) asked.push_back(&expression);
    if (ask.extremum)
      for (const Expression& expression : ask.extremum->conditions) asked.push_back(&expression);
    if (ask.when) asked.push_back(&ask.when->condition);
    if (ask.table) {
      asked.push_back(&ask.table->values);
      for (const NamedExpression& column : ask.table->columns) asked.push_back(&column.value);
    }
    const Situation& situation = found_.statement.situations.front();
    return situation.has_blow() || std::any_of(asked.begin(), asked.end(), [&](const Expression* expression) {
             return asks_forces(situation, *expression);
           });
  }

  template <class Reason>
  void vary(const OpenChoice& choice, const Reason& reason) {
    vary(choice, reason, [&](std::size_t i, const auto& other) { return differs(found_, i, other); });
  }
  template <class Reason, class Differs>
  void vary(const OpenChoice& choice, const Reason& reason, const Differs& differs_here) {
    const Values other = varied(choice);
    for (std::size_t i = 0; i < other.size(); ++i) {
      if (!differs_here(i, other[i])) continue;
      SolvedAsk& ask = result_.asks[i];
      ask.state = AskState::undetermined;
      if (const std::string why = reason(found_.statement.asks[i]); ask.reason.find(why) == std::string::npos)
        add_reason(ask, why);
      note_fixed_components(i, other[i]);
    }
  }

  // Whether an ask is about a state that a motion reaches. A motion starts only where all velocities of masses are
  // known.
  bool follows_motion(const Ask& ask) {
    if (found_.sample.motions().empty()) return false;
    return ask.when || ask.table || found_.sample.instant_of(ask).velocities().open.empty() ||
           std::any_of(ask.of.begin(), ask.of.end(), asks_motion_feature);
  }
  // Massless turning changes a motion by no more than the error with which it is followed; only a larger difference
  // counts. How bodies fly changes all that depends on it by far more than the rounding of another motion.
  bool differs_beyond_following(std::size_t i, const std::optional<WatchedValue>& other) const {
    const bool flies = std::ranges::any_of(found_.sample.motions(),
                                           [](const auto& motion) { return motion.second->has_open_flights(); });
    const double following = flies ? 1e-8 : 1e-5;  // the second as motion_tolerance in answer_checks.cpp
    return differs_by(following, i, other);
  }
  bool differs_by(double part, std::size_t i, const std::optional<WatchedValue>& other) const {
    const std::optional<WatchedValue>& base = found_.asked.values[i];
    if (!base || !differs(found_, i, other)) return false;
    if (!other) return true;
    const double size = std::max(size_of(base->answer), size_of(other->answer));
    return !same(base->answer, other->answer, part * size + 1e-9 * found_.natural_sizes[i]);
  }
  // A motion that is followed again with other open forces is rounded otherwise: of the end of many flights, the last
  // of which are next to nothing beside the way down a slope, that leaves 3e-8.
  bool differs_by_forces(std::size_t i, const std::optional<WatchedValue>& other) {
    constexpr double following = 1e-7;
    // An instant that is sought need not come.
    if (!found_.asked.values[i]) return false;
    return follows_motion(found_.statement.asks[i]) ? differs_by(following, i, other) : differs(found_, i, other);
  }

  bool differs_by_velocities(std::size_t i, const std::optional<WatchedValue>& other) {
    // An instant that is sought need not come.
    if (!found_.asked.values[i]) return false;
    return follows_motion(found_.statement.asks[i]) ? differs_beyond_following(i, other) : differs(found_, i, other);
  }

  // Adds the coordinates that move in one of the open directions, at the instant of an ask or at the start of its
  // motion.
  void add_open_names(const Ask& ask, std::size_t direction, std::vector<std::string>& names) {
    const auto add = [&](std::string_view name) {
      if (std::find(names.begin(), names.end(), name) == names.end()) names.emplace_back(name);
    };
    const SolvedInstant& instant = found_.sample.instant_of(ask);
    if (direction < instant.velocities().share.size()) {
      for (std::size_t k : instant.velocities().share[direction]) add(instant.velocity_equations().name(k));
      return;
    }
    for (const auto& [situation, motion] : found_.sample.motions())
      if (direction < motion->open_turnings().size())
        for (const std::string& name : motion->open_turnings()[direction]) add(name);
  }

  // What can be asked in place of the kinetic energy of a body of which nothing says how it flies, but how it turns.
  std::string words_of_turning(const Ask& ask) const {
    std::string words;
    const SolvedInstant& instant = found_.sample.instant_of(ask);
    const Machine& machine = instant.machine();
    const auto look = [&](const auto& self, const Expression& expression) -> void {
      for_each_child(expression, [&](const Expression& child) { self(self, child); });
      const Call* call = expression.as<Call>();
      const Name* name = call && call->function == "kinetic_energy" && call->arguments.size() == 1
                             ? call->arguments.front().value.as<Name>()
                             : nullptr;
      const auto found = name ? machine.index.find(name->name) : machine.index.end();
      if (found == machine.index.end() || found->second < 0) return;
      const auto& body = machine.mechanism.tree.body(found->second);
      const auto flies = [&](const std::vector<std::size_t>& share) {
        return std::ranges::all_of(share, [&](std::size_t k) {
          const int own = static_cast<int>(k) - body.v;
          return own >= 3 && own < 6;
        });
      };
      if (body.joint == JointType::free && std::ranges::all_of(instant.velocities().share, flies))
        words = "; kinetic_energy(" + name->name + " about center(" + name->name + ")) is that of its turning alone";
    };
    for (const Expression& expression : ask.of) look(look, expression);
    return words;
  }

  void vary_velocities(std::size_t directions) {
    const std::size_t asks = found_.statement.asks.size();
    std::vector<std::vector<std::string>> rates(asks);  // for each ask, rates that it depends on and nothing determines
    std::vector<std::size_t> missing(asks, 0);
    for (std::size_t d = 0; d < directions; ++d) {
      const Values other = varied({.seed = 13, .velocities = true, .direction = d});
      for (std::size_t i = 0; i < asks; ++i) {
        if (!differs_by_velocities(i, other[i])) continue;
        result_.asks[i].state = AskState::undetermined;
        ++missing[i];
        add_open_names(found_.statement.asks[i], d, rates[i]);
        note_fixed_components(i, other[i]);
      }
    }
    for (std::size_t i = 0; i < asks; ++i)
      if (missing[i] > 0)
        add_reason(result_.asks[i], open_velocities(rates[i], missing[i]) + words_of_turning(found_.statement.asks[i]));
  }

  // An answer that is a product of two open values, as of gravity and a velocity, does not change with either alone
  // if both are zero. So all are varied together too.
  void vary_together(bool any, bool gravity, bool velocities, bool forces) {
    const Values other = varied({.seed = 15,
                                 .any = any,
                                 .gravity = gravity ? size_of_gravity() : 0,
                                 .velocities = velocities,
                                 .forces = forces,
                                 .direction = OpenChoice::every});
    std::vector<std::string> open;
    if (any) open.emplace_back("the values given as `any`");
    if (gravity) open.emplace_back("gravity");
    if (velocities) open.emplace_back("velocities");
    if (forces) open.emplace_back("accelerations or forces");
    for (std::size_t i = 0; i < other.size(); ++i) {
      if (result_.asks[i].state != AskState::found) continue;
      if (!(velocities ? differs_by_velocities(i, other[i])
            : forces   ? differs_by_forces(i, other[i])
                       : differs(found_, i, other[i])))
        continue;
      result_.asks[i].state = AskState::undetermined;
      result_.asks[i].reason = "it depends on several things that are left open: " + listed(open);
      fixed_[i] = {false, false, false};
    }
  }

  static void add_reason(SolvedAsk& ask, const std::string& why) {
    // The remedy, which is the same for all forces that share a load, is told once, at the end.
    if (const std::size_t told = ask.reason.find(remedy_of_shares);
        told != std::string::npos && why.ends_with(remedy_of_shares))
      ask.reason.erase(told, remedy_of_shares.size());
    ask.reason += (ask.reason.empty() ? "" : "; ") + why;
  }

  // Records which components of a vector that is not determined are so nevertheless.
  void note_fixed_components(std::size_t i, const std::optional<WatchedValue>& varied) {
    const Value<double>& base = found_.asked.values[i]->answer;
    const Value<double>* other = varied ? &varied->answer : nullptr;
    for (std::size_t k = 0; k < 3; ++k)
      fixed_[i][k] = fixed_[i][k] && base.is_vector() && other && other->is_vector() &&
                     std::abs(base.vector[k] - other->vector[k]) <= same_answer_tolerance(found_, i, base, *other);
  }
  void tell_fixed_components() {
    for (std::size_t i = 0; i < fixed_.size(); ++i) {
      const Ask& ask = found_.statement.asks[i];
      if (result_.asks[i].state != AskState::undetermined || result_.asks[i].ended ||
          found_.asked.unanswered.contains(ask.name))
        continue;
      std::vector<std::string> names;
      for (std::size_t k = 0; k < 3; ++k)
        if (fixed_[i][k]) names.push_back("." + found_.sample.situation_at(ask).axes[k]);
      if (names.empty()) continue;
      const bool several = names.size() > 1;
      result_.asks[i].reason += "; its component" + std::string(several ? "s " : " ") + listed(names) +
                                (several ? " are" : " is") + " fixed: ask for " + (several ? "them" : "it");
    }
  }

  const AnswersFound& found_;
  Solution& result_;
  std::vector<std::array<bool, 3>> fixed_;  // for each ask, the components that no variation changes
  std::set<std::string> moved_unknowns_;
};

}  // namespace

double same_answer_tolerance(const AnswersFound& found, std::size_t index, const Value<double>& a,
                             const Value<double>& b) {
  return (found.search.unknowns().empty() ? same_tolerance : refound_tolerance) * std::max(size_of(a), size_of(b)) +
         rounding_of_terms * found.natural_sizes[index];
}

bool is_left_alone(const AnswersFound& found, std::size_t index, const std::vector<OpenUnknown>& open,
                   const Value<double>& value, const Value<double>& other) {
  if (!same(value, other, same_answer_tolerance(found, index, value, other))) return false;
  std::set<std::string> names;
  for (const Expression& asked : found.statement.asks[index].of) collect_names(asked, names);
  if (std::ranges::none_of(open, [&](const OpenUnknown& one) { return names.contains(one.name); })) return true;
  // The range of an open unknown may be so narrow that beside the natural sizes of the problem all its values are one.
  return same(value, other, refound_tolerance * std::max(size_of(value), size_of(other)));
}

namespace {

// Whether two values differ by rounding only. Below the rounding of the whole machine this is decided by the numbers
// themselves, computed with different rounding.
bool is_rounding(const AnswersFound& found, std::size_t index, const Value<double>& a, const Value<double>& b) {
  const Ask& ask = found.statement.asks[index];
  if (ask.table || ask.when || ask.extremum || !found.sample.motions().empty()) return false;
  const double natural = found.sample.instant_of(ask).natural_size(dimension_of(a));
  if (!same(a, b, rounding_of_terms * natural)) return false;
  // The three roundings that were tried are a sample: other values of what is open may add up worse.
  constexpr double beyond_sample = 1e2;
  return same(a, b, beyond_sample * found.rounded.spread(ask, a));
}

}  // namespace

bool differs(const AnswersFound& found, std::size_t index, const std::optional<WatchedValue>& other) {
  const std::optional<WatchedValue>& base = found.asked.values[index];
  if (!base) return false;
  if (!other || other->deciding.size() != base->deciding.size()) return true;
  const Value<double>&answer = base->answer, &another = other->answer;
  for (std::size_t k = 0; k < base->deciding.size(); ++k) {
    const Value<double>&a = base->deciding[k], &b = other->deciding[k];
    const double natural = found.sample.instant_of(found.statement.asks[index]).natural_size(dimension_of(a));
    if (!same(a, b, same_tolerance * std::max(size_of(a), size_of(b)) + rounding_of_terms * natural)) return true;
  }
  // Without unknowns, motions and deciding values the comparison of rounded numbers is sharper than one by sizes.
  const bool told = base->deciding.empty() && found.search.unknowns().empty() && found.sample.motions().empty();
  if (!told) return !same(answer, another, same_answer_tolerance(found, index, answer, another));
  const double tolerance =
      same_tolerance * std::max(size_of(answer), size_of(another)) + 1e-14 * found.natural_sizes[index];
  return !same(answer, another, tolerance) && !is_rounding(found, index, answer, another);
}

std::set<std::string> mark_undetermined(const AnswersFound& found, Solution& result) {
  return Variation(found, result).mark();
}

}  // namespace poinsot::problem
