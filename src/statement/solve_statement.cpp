#include "poinsot/statement/solve_statement.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <set>

#include "statement/claims.h"
#include "statement/compare_values.h"
#include "statement/describe.h"
#include "statement/extremum.h"
#include "statement/formula_search.h"
#include "statement/reader.h"
#include "statement/sample.h"
#include "statement/unknown_search.h"

namespace poinsot::statement {
namespace {

constexpr double check_tolerance = 1e-8;    // residual on the road of particles, relative
constexpr double motion_tolerance = 1e-5;   // error of a motion, relative; as measured some sixteen times what it is
constexpr double same_tolerance = 1e-9;     // between two choices of what is open, relative
constexpr double refound_tolerance = 1e-7;  // the same where unknowns are found anew

constexpr int most_first_draws = 16;  // of letters, until unknowns have a solution

bool asks_energy(const Expression& expression) {
  std::set<std::string> names;
  const std::string text = to_string(expression);
  return text.find("energy(") != std::string::npos;
}

// spread: how far from one unit later draws reach.
double draw(const Letter& letter, std::mt19937_64& random, int spread = 0) {
  if (spread > 0 && letter.unit.dimension != dimensions::angle)
    return letter.unit.factor * std::exp((0.7 + 0.4 * spread) * std::uniform_real_distribution<double>(-1, 1)(random));
  if (letter.unit.dimension == dimensions::angle) return std::uniform_real_distribution<double>(0.2, 1.2)(random);
  return letter.unit.factor * std::uniform_real_distribution<double>(0.5, 2)(random);
}

// What the values of all asks are for one choice; a missing value where it could not be found.
using Values = std::vector<std::optional<Value<double>>>;

class StatementSolver {
 public:
  // exact: the settings as formulas.
  StatementSolver(const Statement& statement, Settings settings, FormulaValues exact)
      : statement_(statement), settings_(std::move(settings)), exact_(std::move(exact)), search_(statement, settings_) {
    for (const Situation& situation : statement.situations) {
      for (const Letter& letter : situation.problem.letters) add_once(open_, letter);
    }
  }

  SolvedStatement solve() {
    SolvedStatement result;
    result.open_letters = open_;
    if (search_.unknowns().empty()) {
      if (open_.empty()) hold_later_facts();
      result.solutions.push_back(solve_one(AllSettings(statement_.situations.size(), settings_)));
      if (!open_.empty())
        find_formulas({statement_, open_, exact_, settings_, {}, base_, *sample_, natural_}, result.solutions.back());
      return result;
    }
    // With letters open, roots are sought at drawn values, to see which answers depend on which letters.
    RootsFound found = search_.find(settings_with_letters());
    while (!open_.empty() && !makes_sense(found) && ++first_draw_ < most_first_draws)
      found = UnknownSearch(statement_, settings_).find(settings_with_letters());
    result.warnings = found.warnings;
    for (const AllSettings& root : found.roots) {
      undetermined_.clear();
      Solution solution = solve_one(root);
      list_unknowns(root, solution);
      if (!open_.empty()) {
        for (SolvedAsk& ask : solution.asks) {
          ask.state = AskState::needs_letters;
          ask.letters.clear();
          for (const Letter& letter : open_) ask.letters.push_back(letter.name);
        }
        solution.unknowns.clear();
        if (found.open.empty())
          find_formulas({statement_, open_, exact_, settings_, search_.unknowns(), base_, *sample_, natural_},
                        solution);
      }
      if (!found.open.empty()) {
        // What another solution of the conditions changes is not determined.
        const std::vector<double> natural = natural_;
        const Solution other = found.alternative ? solve_one(*found.alternative) : Solution{};
        natural_ = natural;
        std::string names;
        for (const std::string& name : found.open) names += (names.empty() ? "'" : ", '") + name + "'";
        for (std::size_t i = 0; i < solution.asks.size(); ++i) {
          SolvedAsk& ask = solution.asks[i];
          // What varies with something else that is open may only follow the unknowns.
          if (ask.state != AskState::found && ask.state != AskState::undetermined) continue;
          if (found.alternative && same(ask.value, other.asks[i].value, tolerance(i, ask.value, other.asks[i].value)))
            continue;
          ask.state = AskState::undetermined;
          ask.reason = "the conditions leave " + names + " open: one more fact is needed";
        }
        std::erase_if(solution.unknowns, [&](const SolvedUnknown& unknown) {
          return std::find(found.open.begin(), found.open.end(), unknown.name) != found.open.end();
        });
      }
      result.solutions.push_back(std::move(solution));
    }
    return result;
  }

 private:
  // What is stated of later instants, of extremes and periods follows from the rest: it must be true.
  void hold_later_facts() const {
    for (const Situation& situation : statement_.situations) {
      if (!has_later_facts(situation.problem)) continue;
      for (const double misfit : later_misfits(situation.problem, settings_, OpenChoice{})) {
        if (std::abs(misfit) <= 1e-7) continue;
        const auto later = std::find_if(
            situation.problem.instants.begin(), situation.problem.instants.end(),
            [&](const Instant& instant) { return is_later(situation.problem, instant) && !instant.facts.empty(); });
        fail(situation.problem.file,
             later != situation.problem.instants.end() ? later->mark : situation.problem.instants.front().mark,
             "what is stated of the motion after its start does not hold: it follows from the start and the loads",
             "correct it, or list under find: a datum that it fixes");
      }
    }
  }

  void list_unknowns(const AllSettings& root, Solution& solution) const {
    for (const Unknown& unknown : search_.unknowns()) {
      if (undetermined_.contains(unknown.name)) continue;
      if (search_.is_common(unknown.name))
        solution.unknowns.push_back({unknown.name, unknown.unit, root.front().at(unknown.name)});
      for (std::size_t i = 0; i < root.size(); ++i)
        if (search_.is_own(i, unknown.name))
          solution.unknowns.push_back(
              {unknown.name + " @ " + statement_.situations[i].name, unknown.unit, root[i].at(unknown.name)});
    }
  }

  template <class Item>
  void add_once(std::vector<Item>& list, const Item& item) const {
    const bool known = settings_.contains(item.name) || std::any_of(list.begin(), list.end(), [&](const Item& other) {
                         return other.name == item.name;
                       });
    if (!known) list.push_back(item);
  }

  Settings settings_with_letters() const {
    Settings settings = settings_;
    std::mt19937_64 random(1000 + static_cast<std::uint64_t>(first_draw_));
    for (const Letter& letter : open_)
      settings[letter.name] = Value<double>::of_number(draw(letter, random, first_draw_), letter.unit.dimension);
    return settings;
  }

  // The answers with everything known that will be known.
  Solution solve_one(const AllSettings& settings) {
    base_ = settings;
    sample_.reset();
    natural_.clear();
    Solution result;
    Values values = with_letters(OpenChoice{}, nullptr);
    Sample& base = *sample_;
    result.asks.resize(statement_.asks.size());
    for (std::size_t i = 0; i < statement_.asks.size(); ++i) {
      if (const auto missing = unanswered_.find(statement_.asks[i].name); missing != unanswered_.end()) {
        natural_.push_back(0);
        result.asks[i].state = AskState::undetermined;
        result.asks[i].reason =
            missing->second.message + (missing->second.hint.empty() ? "" : ": " + missing->second.hint);
        result.asks[i].words = describe(statement_.asks[i], statement_.situations.front().problem, false);
        continue;
      }
      if (statement_.asks[i].table)
        finish_table(statement_.asks[i], *values[i], result.asks[i]);
      else if (statement_.asks[i].extremum)
        finish_extremum(statement_.asks[i], values[i], result.asks[i]);
      else
        finish(statement_.asks[i], *values[i], base, result.asks[i]);
    }
    find_dependencies(values, result);
    if (open_.empty()) physical(result);
    check(result);
    if (open_.empty()) note(result);
    return result;
  }

  Values evaluate(Sample& sample, const AllSettings& settings, const OpenChoice& choice) {
    Values values;
    extremal_.clear();
    no_extremum_.clear();
    unanswered_.clear();
    for (const Ask& ask : statement_.asks) {
      if (!ask.extremum) {
        try {
          values.emplace_back(sample.value(ask));
        } catch (const UnansweredError& error) {
          values.emplace_back(std::nullopt);
          unanswered_[ask.name] = error.diagnostics().front();
        } catch (const StatementError&) {
          std::optional<Diagnostic> open = fails_where_open(sample, ask, settings);
          if (!open) throw;
          values.emplace_back(std::nullopt);
          unanswered_[ask.name] = *std::move(open);
        }
        continue;
      }
      ExtremumFound found = ExtremumSearch(statement_, ask, settings, choice).find();
      values.push_back(found.value);
      no_extremum_.push_back(found.reason);
      if (found.sample) extremal_.push_back(std::move(found.sample));
    }
    return values;
  }

  // What has no value where all open velocities are taken for zero, but has one elsewhere, is not determined.
  std::optional<Diagnostic> fails_where_open(Sample& sample, const Ask& ask, const AllSettings& settings) {
    const auto has_value = [&](std::size_t direction) {
      try {
        Sample moved(statement_, settings, {.seed = 16, .velocities = true, .direction = direction});
        moved.value(ask);
        return true;
      } catch (const StatementError&) {
        return false;
      }
    };
    try {
      const SolvedInstant& instant = sample.instant_of(ask);
      const solve::LinearSolution& velocities = instant.velocities();
      if (velocities.open.empty() || !has_value(OpenChoice::every)) return std::nullopt;
      std::vector<std::string> names;
      std::size_t missing = 0;
      for (const bool alone : {true, false})
        for (std::size_t d = 0; d < velocities.open.size() && (alone || missing == 0); ++d) {
          if (alone && !has_value(d)) continue;
          ++missing;
          for (std::size_t k : velocities.share[d])
            if (const std::string& name = instant.velocity_equations().name(k);
                std::find(names.begin(), names.end(), name) == names.end())
              names.push_back(name);
        }
      return Diagnostic{statement_.situations.front().problem.file, ask.mark, open_velocities(names, missing), {}};
    } catch (const StatementError&) {
      return std::nullopt;
    }
  }

  // Whether there are roots, at letters for which the statement can be solved.
  bool makes_sense(const RootsFound& found) {
    try {
      for (const AllSettings& root : found.roots) {
        Sample sample(statement_, root, OpenChoice{});
        evaluate(sample, root, OpenChoice{});
      }
    } catch (const StatementError&) {
      return false;
    }
    return !found.roots.empty();
  }

  // With open letters drawn at random until the statement makes sense; the draw is kept in base_.
  Values with_letters(const OpenChoice& choice, const std::string* only) {
    constexpr int most_draws = 40;
    for (int attempt = 0;; ++attempt) {
      AllSettings settings = base_;
      std::mt19937_64 random(1000 + static_cast<std::uint64_t>(first_draw_ + attempt) + (only ? 500 : 0));
      for (const Letter& letter : open_) {
        const double value = draw(letter, random, first_draw_);
        // A root comes with the values of the letters at which it was found.
        if (!search_.unknowns().empty() || (only && *only != letter.name)) continue;
        for (Settings& one : settings) one[letter.name] = Value<double>::of_number(value, letter.unit.dimension);
      }
      try {
        auto sample = std::make_unique<Sample>(statement_, settings, choice);
        Values values = evaluate(*sample, settings, choice);
        if (!only && !sample_) {
          sample_ = std::move(sample);
          base_ = settings;
        }
        return values;
      } catch (const StatementError&) {
        if (open_.empty() || !search_.unknowns().empty() || attempt == most_draws) throw;
      }
    }
  }

  std::vector<const Sample*> samples() const {
    std::vector<const Sample*> all{sample_.get()};
    for (const std::unique_ptr<Sample>& sample : extremal_) all.push_back(sample.get());
    return all;
  }

  // An ask that has no value for this choice depends on it.
  Values varied(const OpenChoice& choice, const Values& base) {
    AllSettings settings = base_;
    // What is found from the conditions may depend on what is open as well.
    if (!search_.unknowns().empty() && (choice.any || choice.gravity || choice.velocities)) {
      Settings known = base_.front();
      for (const Unknown& unknown : search_.unknowns()) known.erase(unknown.name);
      const RootsFound found = search_.find(known, choice);
      const auto distance = [&](const AllSettings& root) {
        double sum = 0;
        for (std::size_t i = 0; i < root.size(); ++i)
          for (const Unknown& unknown : search_.unknowns()) {
            const auto a = root[i].find(unknown.name), b = std::as_const(base_[i]).find(unknown.name);
            if (a == root[i].end() || b == base_[i].end()) continue;
            sum += std::abs(a->second.number - b->second.number) / unknown.unit.factor +
                   norm(a->second.vector - b->second.vector) / unknown.unit.factor;
          }
        return sum;
      };
      const auto nearest =
          std::min_element(found.roots.begin(), found.roots.end(),
                           [&](const AllSettings& a, const AllSettings& b) { return distance(a) < distance(b); });
      if (nearest == found.roots.end()) return Values(statement_.asks.size(), std::nullopt);
      settings = *nearest;
    }
    for (const Unknown& unknown : search_.unknowns())
      for (std::size_t i = 0; i < settings.size(); ++i) {
        const auto a = std::as_const(settings[i]).find(unknown.name), b = std::as_const(base_[i]).find(unknown.name);
        if (a == settings[i].end() || b == base_[i].end()) continue;
        const double moved = std::abs(a->second.number - b->second.number) + norm(a->second.vector - b->second.vector);
        const double size = std::max({std::abs(b->second.number), norm(b->second.vector), 1e-6 * unknown.unit.factor});
        if (moved > refound_tolerance * size) undetermined_.insert(unknown.name);
      }
    Sample sample(statement_, settings, choice);
    Values values;
    for (std::size_t i = 0; i < statement_.asks.size(); ++i) {
      const Ask& ask = statement_.asks[i];
      // What forces are open changes nothing but forces.
      if (choice.forces && !choice.any && !choice.gravity && !choice.velocities && !asks_forces(ask)) {
        values.push_back(base[i]);
        continue;
      }
      try {
        if (!ask.extremum)
          values.emplace_back(sample.value(ask));
        else if (base[i] && ExtremumSearch(statement_, ask, settings, choice).is_at(base[i]->number))
          values.push_back(base[i]);
        else
          values.emplace_back(std::nullopt);
      } catch (const StatementError&) {
        values.emplace_back(std::nullopt);
      }
    }
    return values;
  }

  bool asks_forces(const Ask& ask) const {
    std::vector<const Expression*> asked;
    for (const Expression& expression : ask.of) asked.push_back(&expression);
    if (ask.extremum)
      for (const Expression& expression : ask.extremum->conditions) asked.push_back(&expression);
    if (ask.when) asked.push_back(&ask.when->condition);
    if (ask.table) {
      asked.push_back(&ask.table->values);
      for (const NamedExpression& column : ask.table->columns) asked.push_back(&column.value);
    }
    const Problem& problem = statement_.situations.front().problem;
    return problem.has_blow() || std::any_of(asked.begin(), asked.end(), [&](const Expression* expression) {
             return statement::asks_forces(problem, *expression);
           });
  }

  double tolerance(std::size_t i, const Value<double>& a, const Value<double>& b) {
    return (search_.unknowns().empty() ? same_tolerance : refound_tolerance) * std::max(size_of(a), size_of(b)) +
           1e-11 * natural_[i];
  }

  void find_dependencies(const Values& base, Solution& result) {
    const auto differs = [&](const Values& other, std::size_t i) {
      if (!base[i]) return false;
      return !other[i] || !same(*base[i], *other[i], tolerance(i, *base[i], *other[i]));
    };
    for (const Letter& letter : open_) {
      // Where there are unknowns, they follow the letters: solve() tells what depends on them.
      if (!search_.unknowns().empty()) break;
      const Values other = with_letters(OpenChoice{}, &letter.name);
      for (std::size_t i = 0; i < base.size(); ++i)
        if (differs(other, i)) {
          result.asks[i].state = AskState::needs_letters;
          result.asks[i].letters.push_back(letter.name);
        }
    }
    const auto undetermined = [&](const OpenChoice& choice, auto&& reason) {
      const Values other = varied(choice, base);
      for (std::size_t i = 0; i < base.size(); ++i) {
        if (!differs(other, i)) continue;
        result.asks[i].state = AskState::undetermined;
        std::string why = reason(statement_.asks[i]);
        if (result.asks[i].reason.find(why) == std::string::npos)
          result.asks[i].reason += (result.asks[i].reason.empty() ? "" : "; ") + why;
        note_fixed_components(*base[i], other[i], i);
      }
    };
    fixed_.assign(base.size(), {true, true, true});
    bool any = false, gravity = false;
    for (const Situation& situation : statement_.situations) {
      gravity = gravity || !situation.problem.gravity;
    }
    for (const Sample* sample : samples())
      for (const auto& [home, instant] : sample->instants()) any = any || instant->uses_any();
    if (any)
      undetermined({.seed = 11, .any = true},
                   [](const Ask&) { return std::string("it depends on a value that is given as `any`"); });
    if (gravity)
      undetermined({.seed = 12, .gravity = true}, [](const Ask&) {
        return std::string("it depends on gravity, of which nothing is said: write gravity: -y or gravity: none");
      });
    // Every open direction by itself, so that only what moves an answer is named.
    std::size_t velocities = 0, forces = 0;
    for (const auto& [key, instant] : sample_->instants()) {
      velocities = std::max(velocities, instant->velocities().open.size());
      if (instant->forces_solved()) forces = std::max(forces, instant->motion().open.size());
      if (instant->after_blow()) forces = std::max(forces, instant->blow().open.size());
    }
    constexpr std::size_t most = 60;
    std::vector<std::vector<std::string>> rates(base.size());  // that an ask depends on and nothing fixes
    std::vector<std::size_t> missing(base.size(), 0);
    for (std::size_t d = 0; d < std::min(velocities, most); ++d) {
      const Values other = varied({.seed = 13, .velocities = true, .direction = d}, base);
      for (std::size_t i = 0; i < base.size(); ++i) {
        if (!differs(other, i)) continue;
        result.asks[i].state = AskState::undetermined;
        ++missing[i];
        const SolvedInstant& instant = sample_->instant_of(statement_.asks[i]);
        for (std::size_t k :
             d < instant.velocities().share.size() ? instant.velocities().share[d] : std::vector<std::size_t>{})
          if (const std::string& name = instant.velocity_equations().name(k);
              std::find(rates[i].begin(), rates[i].end(), name) == rates[i].end())
            rates[i].push_back(name);
        note_fixed_components(*base[i], other[i], i);
      }
    }
    for (std::size_t i = 0; i < base.size(); ++i)
      if (missing[i] > 0)
        result.asks[i].reason += (result.asks[i].reason.empty() ? "" : "; ") + open_velocities(rates[i], missing[i]);
    for (std::size_t d = 0; d < std::min(forces, most); ++d)
      undetermined({.seed = 14, .forces = true, .direction = d},
                   [&](const Ask& ask) { return open_force(sample_->instant_of(ask), d); });
    // What rests on several of them at once, as the product of gravity and a velocity, moves with none by itself.
    if (any + gravity + velocities + forces > 1) {
      const Values other = varied({.seed = 15,
                                   .any = any,
                                   .gravity = gravity,
                                   .velocities = velocities > 0,
                                   .forces = forces > 0,
                                   .direction = OpenChoice::every},
                                  base);
      for (std::size_t i = 0; i < base.size(); ++i) {
        if (result.asks[i].state != AskState::found || !differs(other, i)) continue;
        result.asks[i].state = AskState::undetermined;
        std::vector<std::string> open;
        if (any) open.emplace_back("the values given as `any`");
        if (gravity) open.emplace_back("gravity");
        if (velocities) open.emplace_back("velocities");
        if (forces) open.emplace_back("accelerations or forces");
        result.asks[i].reason = "it depends on several things that are left open: " + listed(open, "and");
        fixed_[i] = {false, false, false};
      }
    }
    tell_fixed_components(result);
  }

  // Of a vector that is not determined, the components that are.
  void note_fixed_components(const Value<double>& base, const std::optional<Value<double>>& other, std::size_t i) {
    for (std::size_t k = 0; k < 3; ++k)
      fixed_[i][k] = fixed_[i][k] && base.is_vector() && other && other->is_vector() &&
                     std::abs(base.vector[k] - other->vector[k]) <= tolerance(i, base, *other);
  }
  void tell_fixed_components(Solution& result) {
    for (std::size_t i = 0; i < fixed_.size(); ++i) {
      if (result.asks[i].state != AskState::undetermined || unanswered_.contains(statement_.asks[i].name)) continue;
      std::vector<std::string> names;
      for (std::size_t k = 0; k < 3; ++k)
        if (fixed_[i][k]) names.push_back("." + sample_->problem_of(statement_.asks[i]).axes[k]);
      if (!names.empty())
        result.asks[i].reason += "; its component" + std::string(names.size() > 1 ? "s " : " ") + listed(names, "and") +
                                 (names.size() > 1 ? " are" : " is") + " fixed: ask for " +
                                 (names.size() > 1 ? "them" : "it");
    }
  }

  static std::string listed(const std::vector<std::string>& names, const char* last) {
    std::string text;
    for (std::size_t i = 0; i < names.size(); ++i)
      text += (i == 0 ? "" : i + 1 == names.size() ? std::string(" ") + last + " " : ", ") + names[i];
    return text;
  }

  // The names of the unknowns that one open direction moves.
  static std::vector<std::string> moved_names(const solve::LinearSystem& equations,
                                              const solve::LinearSolution& solution, std::size_t direction,
                                              std::size_t first, std::size_t last) {
    std::vector<std::string> names;
    if (direction >= solution.share.size()) return names;
    for (std::size_t k : solution.share[direction])
      if (k >= first && k < last) names.push_back(equations.name(k));
    if (names.size() > 6) {
      names.resize(5);
      names.emplace_back("more");
    }
    return names;
  }

  static std::string open_velocities(std::vector<std::string> names, std::size_t missing) {
    const std::size_t count = names.size();
    if (count > 6) {
      names.resize(5);
      names.emplace_back("more");
    }
    const std::string enough = missing >= count ? ""
                                                : " (" + (missing == 1 ? std::string("one") : std::to_string(missing)) +
                                                      " of them would do, or another fact)";
    return "nothing fixes " + listed(names, "and") + enough + ": state " +
           (count == 1 || missing == 1 ? "it" : "them") + " under joints: or instants:";
  }

  static std::string open_force(const SolvedInstant& instant, std::size_t direction) {
    if (instant.after_blow() && !instant.forces_solved())
      return "the blow does not fix " +
             listed(moved_names(instant.blow_equations(), instant.blow(), direction, 0,
                                instant.blow_equations().unknowns()),
                    "and") +
             " one by one";
    const auto& equations = instant.motion_equations();
    const std::size_t accelerations = solve::force_unknowns(instant.machine().mechanism).accelerations;
    const std::vector<std::string> motions = moved_names(equations, instant.motion(), direction, 0, accelerations);
    if (!motions.empty())
      return "nothing fixes the " + listed(motions, "and the") + ": state it, or the couple or force that causes it";
    return listed(moved_names(equations, instant.motion(), direction, accelerations, equations.unknowns()), "and") +
           " share the same load: the statement does not fix them one by one";
  }

  void finish_extremum(const Ask& ask, const std::optional<Value<double>>& value, SolvedAsk& solved) {
    const Problem& problem = statement_.situations[situation_of(statement_, ask)].problem;
    natural_.push_back(0);
    solved.words = describe(ask, problem, false);
    const std::string reason = no_extremum_.front();
    no_extremum_.erase(no_extremum_.begin());
    if (!value) {
      solved.state = AskState::refused;
      solved.reason = reason;
      return;
    }
    solved.value = *value;
    if (ask.unit && !same_kind(ask.unit->dimension, value->dimension))
      fail(problem.file, ask.mark,
           "'" + ask.extremum->name + "' is " + to_string(value->dimension) + ", but " + ask.unit->text +
               " is a unit of " + to_string(ask.unit->dimension),
           "ask for it in a unit such as " + problem.habits.unit_for(value->dimension).text);
    solved.unit = ask.unit ? *ask.unit : problem.habits.unit_for(value->dimension);
  }

  void finish_table(const Ask& ask, const Value<double>& value, SolvedAsk& solved) {
    const Problem& problem = statement_.situations.front().problem;
    natural_.push_back(0);
    solved.words = describe(ask, problem, false);
    const std::size_t count = ask.table->columns.size();
    for (std::size_t c = 0; c < count; ++c) {
      const NamedExpression& stated = ask.table->columns[c];
      SolvedColumn column;
      column.name = stated.name;
      std::optional<Dimension> dimension;
      for (std::size_t row = c; row < value.items.size(); row += count) {
        column.values.push_back(value.items[row].number);
        if (!dimension || dimension == dimensions::none) dimension = value.items[row].dimension;
      }
      const auto unit = ask.table->units.find(stated.name);
      if (unit != ask.table->units.end()) {
        if (dimension && !same_kind(unit->second.dimension, *dimension))
          fail(problem.file, stated.mark,
               "column '" + stated.name + "' is " + to_string(*dimension) + ", but " + unit->second.text +
                   " is a unit of " + to_string(unit->second.dimension));
        column.unit = unit->second;
      } else {
        column.unit = problem.habits.unit_for(dimension.value_or(dimensions::none), asks_energy(stated.value));
      }
      solved.columns.push_back(std::move(column));
    }
    solved.value = value;
  }

  void finish(const Ask& ask, const Value<double>& value, Sample& sample, SolvedAsk& solved) {
    const Problem& problem = sample.problem_of(ask);
    if (!ask.when &&
        std::none_of(ask.of.begin(), ask.of.end(), [&](const Expression& e) { return asks_model(problem, e); }))
      fail(problem.file, ask.mark, "'" + ask.name + "' asks nothing of the model: it is a formula of the data",
           "ask for a quantity, such as angular_momentum(BODY about POINT)");
    solved.value = value;
    const Dimension dimension = dimension_of(value);
    natural_.push_back(sample.instant_of(ask).natural_size(dimension));
    drop_noise(solved.value, std::max(size_of(value), natural_.back()));
    for (const Value<double>& item : value.items)
      if (!same_kind(dimension_of(item), dimension))
        fail(problem.file, ask.mark,
             "the items of this list are of different kinds: " + to_string(dimension) + " and " +
                 to_string(dimension_of(item)),
             "ask them one by one");
    if (ask.unit) {
      if (!same_kind(ask.unit->dimension, dimension))
        fail(problem.file, ask.mark,
             "the answer is " + to_string(dimension) + ", but " + ask.unit->text + " is a unit of " +
                 to_string(ask.unit->dimension),
             "ask for it in a unit such as " + problem.habits.unit_for(dimension).text);
      solved.unit = *ask.unit;
    } else if (const Name* name = ask.of.size() == 1 ? ask.of.front().as<Name>() : nullptr;
               name && unknown_unit(problem, name->name)) {
      solved.unit = *unknown_unit(problem, name->name);
    } else if (!value.is_boolean() && !value.is_text() && !dimension_is_text(value)) {
      solved.unit = problem.habits.unit_for(dimension, std::all_of(ask.of.begin(), ask.of.end(), asks_energy));
    }
    solved.words = describe(ask, problem, has_vector(value));
    if (has_vector(value)) solved.component_names.assign(problem.axes.begin(), problem.axes.end());
  }

  static const Unit* unknown_unit(const Problem& problem, const std::string& name) {
    for (const Unknown& unknown : problem.find)
      if (unknown.name == name) return &unknown.unit;
    return nullptr;
  }
  static bool dimension_is_text(const Value<double>& value) {
    return value.is_list() && !value.items.empty() && value.items.front().is_text();
  }

  // A cord that would push or a contact that would pull: what depends on forces is refused.
  void physical(Solution& result) {
    for (std::size_t i = 0; i < statement_.asks.size(); ++i) {
      const Ask& ask = statement_.asks[i];
      if (ask.extremum || ask.table || ask.when || result.asks[i].value.is_boolean()) continue;
      if (result.asks[i].state != AskState::found) continue;
      SolvedInstant& instant = sample_->instant_of(ask);
      const Problem& problem = sample_->problem_of(ask);
      const bool needs_forces = std::any_of(ask.of.begin(), ask.of.end(), [&](const Expression& e) {
        return level_of(problem, e, true) == Level::force;
      });
      if (!needs_forces || !instant.forces_solved() || result.asks[i].state != AskState::found) continue;
      for (const std::string& reason : instant.unphysical()) {
        result.asks[i].state = AskState::refused;
        result.asks[i].reason = reason;
      }
    }
  }

  // What the reader of a steady motion or of a motion wants to know besides.
  void note(Solution& result) {
    for (const auto& [home, instant] : sample_->instants()) {
      const Situation& situation = statement_.situations[home.situation];
      if (!situation.problem.steady || home.time || home.instant > 0) continue;
      try {
        result.notes.push_back("the steady motion" + (situation.name.empty() ? "" : " @ " + situation.name) + " is " +
                               stability_words(instant->linearisation(situation.problem.steady->mark)));
      } catch (const StatementError&) {
        // The statement does not say enough of what holds the motion: stability is not told.
      }
    }
    for (const auto& [situation, motion] : sample_->motions()) {
      result.notes.insert(result.notes.end(), motion->happenings().begin(), motion->happenings().end());
      const std::string& name = statement_.situations[situation].name;
      for (const std::string& method : motion->methods())
        result.notes.push_back("the motion" + (name.empty() ? "" : " @ " + name) + ": " + method);
    }
  }
  static std::string stability_words(const solve::Linearisation& near) {
    char text[60];
    switch (solve::stability(near)) {
      case solve::Stability::unstable:
        std::snprintf(text, sizeof text, "unstable: a disturbance grows as exp(%.4g t/s)", solve::growth_rate(near));
        return text;
      case solve::Stability::undecided:
        return "neither stable nor unstable by the linearised equations, which do not decide it";
      case solve::Stability::stable:
        break;
    }
    std::string words;
    for (double frequency : solve::frequencies(near)) {
      std::snprintf(text, sizeof text, "%.4g", frequency);
      words += (words.empty() ? "" : ", ") + std::string(text);
    }
    return words.empty() ? "stable" : "stable: disturbed, it swings at " + words + " rad/s";
  }

  void check(Solution& result) {
    std::map<std::size_t, double> latest;
    for (const auto& [home, instant] : sample_->instants())
      if (home.time) latest[home.situation] = std::max(latest[home.situation], *home.time);
    // Some instants of each motion.
    for (const auto& [situation, motion] : sample_->motions())
      for (const double part : {0.31, 0.67, 1.0})
        sample_->instant_at(situation, part * motion->reached()).solve_forces();
    std::vector<SolvedInstant*> instants;
    for (const auto& [key, instant] : sample_->instants()) instants.push_back(instant.get());
    for (const std::unique_ptr<Sample>& sample : extremal_)
      for (const auto& [key, instant] : sample->instants()) instants.push_back(instant.get());
    for (SolvedInstant* instant : instants) {
      const SolvedInstant::Residuals residuals = instant->check();
      const solve::CheckResult& residual = residuals.particles;
      const auto keep = [&](const char* name, double value) {
        auto [entry, fresh] = result.checks.emplace(name, value);
        if (!fresh) entry->second = std::max(entry->second, value);
      };
      keep("momentum", residual.momentum);
      keep("energy", residual.energy);
      if (instant->forces_solved()) keep("newton_euler", residual.newton_euler);
      if (instant->after_blow()) keep("impulse", residuals.impulse);
    }
    for (const auto& [situation, motion] : sample_->motions())
      if (const auto drift = motion->energy_drift()) {
        auto [entry, fresh] = result.checks.emplace("energy_drift", *drift);
        if (!fresh) entry->second = std::max(entry->second, *drift);
      }
    for (const auto& [situation, motion] : sample_->motions()) {
      const double at_times = std::max(motion->values_until(), latest[situation]);
      std::optional<MotionError> error = motion->error(std::max(at_times, motion->extremes_until()));
      if (error && error->relative > motion_tolerance && motion->extremes_until() > at_times) {
        // How far an extreme goes does not depend on when it comes.
        result.notes.push_back("the motion is sensitive: when it comes to the extremes found is not certain");
        error = at_times > 0 ? motion->error(at_times) : std::nullopt;
      }
      if (!error) continue;
      auto [entry, fresh] = result.checks.emplace("motion_error", error->relative);
      if (!fresh) entry->second = std::max(entry->second, error->relative);
    }
    for (const auto& [name, residual] : result.checks) {
      const bool of_motion = name == "motion_error";
      if (residual <= (of_motion ? motion_tolerance : check_tolerance)) continue;
      for (SolvedAsk& ask : result.asks) {
        if (ask.state != AskState::found) continue;
        ask.state = AskState::refused;
        if (of_motion) {
          char text[120];
          std::snprintf(text, sizeof text,
                        "the motion is so sensitive that it may be off by %.1g of its size: let it last shorter",
                        residual);
          ask.reason = text;
          continue;
        }
        ask.reason = "the independent check with particles does not confirm it (" + name + " off by " +
                     std::to_string(residual) + ")";
      }
    }
  }

  const Statement& statement_;
  Settings settings_;
  FormulaValues exact_;
  UnknownSearch search_;
  AllSettings base_;
  std::vector<Letter> open_;
  int first_draw_ = 0;  // of letters at which unknowns have a solution
  std::unique_ptr<Sample> sample_;
  std::vector<std::unique_ptr<Sample>> extremal_;  // at the extrema that are asked
  std::map<std::string, Diagnostic> unanswered_;   // what a motion does not tell, by ask
  std::vector<std::string> no_extremum_;           // of each extremum that is asked: why there is none
  std::vector<double> natural_;
  std::vector<std::array<bool, 3>> fixed_;
  std::set<std::string> undetermined_;  // unknowns that a variation moves
};

}  // namespace

Settings read_settings(const Statement& statement, const std::vector<std::pair<std::string, std::string>>& sets) {
  Settings settings;
  for (const auto& [name, text] : sets) {
    std::vector<std::string> known;
    const Problem* owner = nullptr;
    for (const Situation& situation : statement.situations) {
      const std::vector<std::string> names = settable_names(situation.problem);
      if (!owner && std::find(names.begin(), names.end(), name) != names.end()) owner = &situation.problem;
      known.insert(known.end(), names.begin(), names.end());
    }
    if (!owner) {
      std::string all;
      std::set<std::string> unique(known.begin(), known.end());
      for (const std::string& word : unique) all += (all.empty() ? "" : ", ") + word;
      const std::string hint = did_you_mean(name, known);
      fail("--set " + name, {}, "the problem has no letter or datum '" + name + "'",
           !hint.empty() ? hint
           : all.empty() ? "it has none at all"
                         : "it has " + all);
    }
    settings[name] = read_setting(*owner, name, text);
  }
  return settings;
}

namespace {

// Letters without value.
std::vector<Letter> open_letters(const Statement& statement, const Settings& settings) {
  std::vector<Letter> open;
  for (const Situation& situation : statement.situations)
    for (const Letter& letter : situation.problem.letters)
      if (!settings.contains(letter.name) &&
          std::none_of(open.begin(), open.end(), [&](const Letter& known) { return known.name == letter.name; }))
        open.push_back(letter);
  return open;
}

// Without the situations that claims alone speak of: their letters are no data of the questions.
Statement for_questions(const Statement& statement) {
  Statement result = statement;
  std::erase_if(result.situations, [&](const Situation& situation) {
    const bool claimed = std::any_of(statement.claims.begin(), statement.claims.end(),
                                     [&](const Claim& claim) { return claim.situation == situation.name; });
    return claimed && !situation.name.empty() &&
           std::none_of(statement.asks.begin(), statement.asks.end(), [&](const Ask& ask) {
             return ask.table || ask.when || (ask.extremum && ask.extremum->situation == situation.name) ||
                    ask.text.find("@ " + situation.name) != std::string::npos;
           });
  });
  return result.situations.empty() ? statement : result;
}

// The settings with the unknowns found, in each situation.
AllSettings settings_of_root(const Statement& statement, const Settings& settings, const Solution& solution) {
  AllSettings all(statement.situations.size(), settings);
  for (const SolvedUnknown& unknown : solution.unknowns)
    for (std::size_t i = 0; i < all.size(); ++i) {
      const std::string own = " @ " + statement.situations[i].name;
      const std::string name = unknown.name.substr(0, unknown.name.find(" @ "));
      if (!unknown.formula && (unknown.name == name || unknown.name == name + own)) all[i][name] = unknown.value;
    }
  return all;
}

}  // namespace

SolvedStatement solve_statement(const Statement& statement,
                                const std::vector<std::pair<std::string, std::string>>& sets) {
  if (statement.asks.empty() && statement.claims.empty())
    fail(statement.file, Mark{1, 1}, "the file asks nothing", "write ask: {a: angular_momentum(disk about G)}");
  Settings settings = read_settings(statement, sets);
  FormulaValues exact;
  for (const auto& [name, text] : sets)
    for (const Situation& situation : statement.situations) {
      const std::vector<std::string> names = settable_names(situation.problem);
      if (std::find(names.begin(), names.end(), name) == names.end()) continue;
      exact[name] = exact_setting(situation.problem, name, text);
      break;
    }
  SolvedStatement solved;
  const bool only_claims =
      statement.asks.empty() && std::all_of(statement.situations.begin(), statement.situations.end(),
                                            [](const Situation& s) { return s.problem.find.empty(); });
  if (only_claims) {
    solved.open_letters = open_letters(statement, settings);
    solved.solutions.emplace_back();
  } else {
    const Statement questions = for_questions(statement);
    solved = StatementSolver(questions, settings, exact).solve();
  }
  for (Solution& solution : solved.solutions)
    solution.claims = solve_claims(statement, settings_of_root(statement, settings, solution), exact);
  return solved;
}

}  // namespace poinsot::statement
