#include "problem/answers/solve_statement.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <set>
#include <stdexcept>
#include <string_view>

#include "poinsot/engine/work/budget.h"
#include "poinsot/engine/work/work.h"
#include "problem/answers/answer_checks.h"
#include "problem/answers/ask_values.h"
#include "problem/answers/contact_states.h"
#include "problem/answers/determinacy.h"
#include "problem/answers/fact_check.h"
#include "problem/answers/finished_ask.h"
#include "problem/answers/friction_refusals.h"
#include "problem/answers/letter_draws.h"
#include "problem/answers/read_settings.h"
#include "problem/answers/rounded_values.h"
#include "problem/claims/claims.h"
#include "problem/formulas/formula_reach.h"
#include "problem/formulas/formula_regimes.h"
#include "problem/formulas/formula_search.h"
#include "problem/formulas/formula_task.h"
#include "problem/formulas/formula_words.h"
#include "problem/formulas/law_search.h"
#include "problem/language/diagnostic.h"
#include "problem/language/words.h"
#include "problem/quantities/describe.h"
#include "problem/results/compare_values.h"
#include "problem/unknowns/sample.h"
#include "problem/unknowns/situated.h"
#include "problem/unknowns/unknown_search.h"
#include "problem/witness/attraction_bound.h"

namespace poinsot::problem {
namespace {

constexpr Work most_draw_work = 8'000'000'000;
// Draws of letters at which a motion is asked for what does not happen there, or an end for which there is none.
constexpr int most_draws_for_answers = 12;
// What does not happen where all letters are of the size of their units may where they differ.
constexpr int wider_after_each = 2;
constexpr Work most_work_for_answers = 800'000'000;
// The search for roots at other letters takes as much as the solutions did, and this in any case.
constexpr Work least_work_elsewhere = 100'000'000, most_work_elsewhere = 2'000'000'000;

// Draws values for letters, finds the unknowns and answers the asks for each root.
class StatementSolver {
 public:
  // exact: the settings as formulas. shown: whether what is found is shown, or only compared with it.
  StatementSolver(const Statement& statement, Settings settings, FormulaValues exact, bool shown = true)
      : statement_(statement),
        settings_(std::move(settings)),
        exact_(std::move(exact)),
        shown_(shown),
        search_(statement, settings_),
        draws_(statement, settings_) {}

  // What the budget in force lets be found.
  SolvedStatement solve() {
    SolvedStatement result;
    result.open_letters = draws_.letters();
    try {
      add_solutions(result);
    } catch (const BudgetEnded& ended) {
      result.ended = ended.end;
      if (result.solutions.empty()) result.solutions.push_back(all_unanswered(ended.end));
    }
    for (const Solution& solution : result.solutions)
      for (const SolvedAsk& ask : solution.asks)
        if (ask.ended) result.ended = ask.ended;
    return result;
  }

 private:
  void add_solutions(SolvedStatement& result) {
    if (search_.unknowns().empty()) {
      if (draws_.none()) hold_later_facts(statement_, settings_);
      result.solutions.push_back(solve_one(AllSettings(statement_.situations.size(), settings_)));
      if (!draws_.none()) add_formulas(result.solutions.back());
      return;
    }
    // If letters are open, roots are sought at random values of them. Then it is seen which answers depend on which
    // letters.
    std::optional<StatementError> refusal;
    RootsFound found = roots_at_draw(search_, refusal);
    const WorkLimit limit(most_draw_work);
    while (!draws_.none() && !makes_sense(found) && draws_.next() && !limit.spent()) {
      UnknownSearch anew(statement_, settings_);
      found = roots_at_draw(anew, refusal);
    }
    if (found.roots.empty() && refusal) throw draws_.told(*refusal, refused_alike_);
    result.warnings = found.warnings;
    if (!draws_.none() && found.roots.empty()) draws_.tell(result.warnings);
    for (std::size_t k = 0; k < found.roots.size(); ++k) {
      const AllSettings& root = found.roots[k];
      if (k < at_roots_.size()) at_root_ = std::move(at_roots_[k]);
      Solution solution = solve_one(root);
      list_unknowns(root, solution);
      if (found.off_by_scan) solution.checks["roots"] = *found.off_by_scan;
      if (!draws_.none()) {
        leave_to_letters(solution);
        if (found.open.empty()) add_formulas(solution);
      }
      if (!found.open.empty()) mark_what_unknowns_leave_open(found, solution);
      result.solutions.push_back(std::move(solution));
    }
    if (!draws_.none() && found.open.empty() && !found.roots.empty()) add_solutions_elsewhere(result);
  }

  void add_solutions_elsewhere(SolvedStatement& result) {
    const std::size_t most = 2 * result.solutions.size() + 2;
    RootsElsewhere elsewhere(statement_, settings_, draws_.letters(), search_.unknowns(), draws_.settings(),
                             std::clamp(work_done() - begin_, least_work_elsewhere, most_work_elsewhere));
    while (const std::optional<AllSettings> root = elsewhere.next(result.solutions)) {
      if (result.solutions.size() < most) {
        Solution solution = solve_one(*root);
        leave_to_letters(solution);
        add_formulas(solution);
        if (solution.refused || RootsElsewhere::repeats(solution, result.solutions)) continue;
        if (elsewhere.stands_beside(solution)) {
          result.solutions.push_back(std::move(solution));
          continue;
        }
      }
      result.warnings.push_back(elsewhere.words_of(*root));
      break;
    }
    elsewhere.tell_where_there_is_none(result.solutions);
  }

  AnswersFound answers_found() { return {statement_, search_, base_, *sample_, asked_, natural_, *rounded_}; }

  // Formulas that were not tried far off by the time the budget ends are none.
  void add_formulas(Solution& solution) {
    if (!sample_) return;
    // Formulas of numbers that are wrong would be confirmed by these.
    if (solution.refused) {
      for (SolvedAsk& ask : solution.asks)
        if (ask.state == AskState::needs_letters) ask.no_formula = "the checks do not confirm its numbers";
      return;
    }
    const Solution without = solution;
    try {
      const FormulaTask task{statement_, draws_.letters(), exact_,  settings_, search_.unknowns(),
                             base_,      *sample_,         natural_};
      const FormulaGrounds grounds = find_formulas(task, solution);
      std::vector<HeldCondition> held = hold_far_off(task, grounds, solution);
      find_regimes(task, grounds, held, solution);
      tell_conditions(task, grounds, held, solution);
      tell_laws(statement_, solution);
      tell_units(task, solution);
    } catch (const BudgetEnded& ended) {
      solution = without;
      for (SolvedAsk& ask : solution.asks) {
        if (ask.state != AskState::needs_letters) continue;
        ask.no_formula = words_of(ended.end);
        ask.ended = ended.end;
      }
    }
  }

  // What was not found by the end, or of which it is not known whether it is determined.
  SolvedAsk unanswered(std::size_t i, BudgetEnd end) const {
    SolvedAsk ask;
    ask.state = AskState::undetermined;
    ask.reason = words_of(end);
    ask.ended = end;
    ask.words = describe(statement_.asks[i], statement_.situations.front(), false);
    return ask;
  }
  Solution all_unanswered(BudgetEnd end) const {
    Solution solution;
    for (std::size_t i = 0; i < statement_.asks.size(); ++i) solution.asks.push_back(unanswered(i, end));
    return solution;
  }

  // Returns no roots if the statement makes no sense at the letters (as for an impossible body), and keeps the first
  // reason.
  RootsFound roots_at_draw(UnknownSearch& search, std::optional<StatementError>& refusal) {
    try {
      return shown_ ? search.find_confirmed(draws_.settings()) : search.find(draws_.settings());
    } catch (const StatementError& error) {
      if (draws_.none()) throw;
      refused_alike_ = refused_alike_ && (!refusal || std::string_view(refusal->what()) == error.what());
      if (!refusal) refusal = error;
      return {};
    }
  }

  // Unknowns found at random values of letters depend on the letters, and so do all answers.
  void leave_to_letters(Solution& solution) const {
    for (std::size_t i = 0; i < solution.asks.size(); ++i) {
      SolvedAsk& ask = solution.asks[i];
      // An end of the only letter does not hang on the value that was drawn for it.
      const std::optional<Extremum>& extremum = statement_.asks[i].extremum;
      if (extremum &&
          std::ranges::all_of(draws_.letters(), [&](const Letter& letter) { return letter.name == extremum->name; }))
        continue;
      ask.state = AskState::needs_letters;
      ask.letters.clear();
      for (const Letter& letter : draws_.letters()) ask.letters.push_back(letter.name);
    }
    solution.unknowns.clear();
  }

  // An answer is not determined if another solution of the conditions changes it.
  void mark_what_unknowns_leave_open(const RootsFound& found, Solution& solution) {
    const std::vector<double> natural = natural_;
    const Solution other = found.alternative ? solve_one(*found.alternative) : Solution{};
    natural_ = natural;
    std::vector<std::string> names;
    for (const OpenUnknown& open : found.open) add_once(names, "'" + open.name + "'");
    for (std::size_t i = 0; i < solution.asks.size(); ++i) {
      SolvedAsk& ask = solution.asks[i];
      // A dependence on something else that is open may come from the unknowns alone.
      if (ask.state != AskState::found && ask.state != AskState::undetermined) continue;
      if (found.alternative && is_left_alone(answers_found(), i, found.open, ask.value, other.asks[i].value)) continue;
      ask.state = AskState::undetermined;
      ask.reason = "the conditions leave " + joined(names) + " open: one more fact is needed";
    }
    // So is what is noted beside it, as how fast a steady motion swings.
    if (found.alternative)
      std::erase_if(solution.notes, [&](const auto& note) { return std::ranges::count(other.notes, note) == 0; });
    std::erase_if(solution.unknowns, [&](const SolvedUnknown& unknown) {
      return std::ranges::any_of(found.open, [&](const OpenUnknown& open) {
        return open.name == unknown.own_name && (!open.situation || open.situation == unknown.situation);
      });
    });
  }

  void list_unknowns(const AllSettings& root, Solution& solution) const {
    for (const Unknown& unknown : search_.unknowns()) {
      if (undetermined_.contains(unknown.name)) continue;
      if (search_.is_common(unknown.name))
        solution.unknowns.push_back({unknown.name, unknown.unit, root.front().at(unknown.name)});
      for (std::size_t i = 0; i < root.size(); ++i)
        if (search_.is_own(i, unknown.name))
          solution.unknowns.push_back({.name = unknown.name + " @ " + statement_.situations[i].name,
                                       .unit = unknown.unit,
                                       .value = root[i].at(unknown.name),
                                       .own_name = unknown.name,
                                       .situation = i});
    }
  }

  // Solves for the answers, with values for everything that will have one.
  Solution solve_one(const AllSettings& settings) {
    base_ = settings;
    sample_.reset();
    natural_.clear();
    asked_ = with_letters(nullptr);
    Solution result;
    try {
      // What was found by the end of a budget is worth a little more time.
      std::optional<BudgetGrace> grace;
      if (asked_.ended) grace.emplace();
      finish(result);
    } catch (const BudgetEnded& ended) {
      result = all_unanswered(asked_.ended.value_or(ended.end));
    }
    return result;
  }

  // The answers with all that is to be said of them.
  void finish(Solution& result) {
    rounded_.emplace(statement_, base_);
    for (std::size_t i = 0; i < statement_.asks.size(); ++i) {
      if (asked_.was_not_reached(statement_.asks[i].name, i)) {
        result.asks.push_back(unanswered(i, *asked_.ended));
        natural_.push_back(1);
        continue;
      }
      FinishedAsk finished = finished_ask(statement_, i, asked_, *sample_, *rounded_);
      result.asks.push_back(std::move(finished.solved));
      if (draws_.none() && !finished.note.empty()) result.notes.push_back(std::move(finished.note));
      natural_.push_back(finished.natural_size);
    }
    mark_letters(result);
    mark_what_does_not_happen(result);
    undetermined_ = mark_undetermined(answers_found(), result);
    if (draws_.none()) refuse_unphysical(statement_, asked_, *sample_, result);
    check_answers(statement_, *sample_, asked_.extremal, result);
    if (draws_.none())
      add_notes(statement_, *sample_, result);
    else
      for (const Situation& situation : statement_.situations)
        for (const std::string& line : words_of_attraction(situation)) result.notes.push_back(line);
    result.notes.insert(result.notes.end(), asked_.notes.begin(), asked_.notes.end());
  }

  // Finds the letters that each answer depends on. If there are unknowns they depend on the letters, and solve()
  // deals with that.
  void mark_letters(Solution& result) {
    if (!search_.unknowns().empty()) return;
    for (const Letter& letter : draws_.letters()) {
      const AskValues other = with_letters(&letter.name);
      for (std::size_t i = 0; i < other.values.size(); ++i) {
        if (!differs(answers_found(), i, other.values[i])) continue;
        result.asks[i].state = AskState::needs_letters;
        result.asks[i].letters.push_back(letter.name);
      }
    }
  }

  // That something does not happen at the values drawn for letters says nothing of others.
  void mark_what_does_not_happen(Solution& result) {
    if (draws_.none()) return;
    for (std::size_t i = 0; i < result.asks.size(); ++i) {
      SolvedAsk& ask = result.asks[i];
      if (!statement_.asks[i].when && !asked_.unanswered.contains(statement_.asks[i].name)) continue;
      if (ask.state == AskState::found && ask.value.is_list() && ask.value.items.empty()) {
        ask.state = AskState::needs_letters;
        ask.no_formula = "it does not happen at the values that were tried for the letters";
        for (const Letter& letter : draws_.letters()) ask.letters.push_back(letter.name);
      } else if (ask.state == AskState::undetermined) {
        ask.reason = "at the values that were tried for the letters " + ask.reason;
      }
    }
  }

  // Whether there are roots, and the statement can be solved at their letters. The answers are kept.
  bool makes_sense(const RootsFound& found) {
    at_roots_.clear();
    try {
      for (const AllSettings& root : found.roots) {
        at_roots_.push_back({sample_at(root), {}});
        at_roots_.back().values = ask_values(statement_, *at_roots_.back().sample, root, OpenChoice{});
      }
    } catch (const StatementError&) {
      return false;
    }
    return !found.roots.empty();
  }
  std::unique_ptr<Sample> sample_at(const AllSettings& settings) const {
    auto sample = std::make_unique<Sample>(statement_, settings, OpenChoice{});
    sample->write_down_what_is_told();
    return sample;
  }

  // The asks at values of open letters that are drawn until the statement makes sense; base_ and sample_ keep the
  // result. only: the single letter that gets a new value.
  AskValues with_letters(const std::string* only) {
    const bool rough = std::ranges::any_of(statement_.situations, &Situation::has_friction);
    const int most_draws = rough ? most_state_draws : 40;
    std::optional<StatementError> refusal;
    bool alike = true;
    // Of draws at which something is not answered, that at which most is.
    struct Partly {
      std::unique_ptr<Sample> sample;
      AllSettings settings;
      AskValues values;
    };
    std::optional<Partly> partly;
    int tried = 0;
    const WorkLimit limit(most_work_for_answers);
    const auto keep = [&](std::unique_ptr<Sample> sample, const AllSettings& settings) {
      if (only || sample_) return;
      sample_ = std::move(sample);
      base_ = settings;
    };
    for (int attempt = 0;; ++attempt) {
      AllSettings settings = base_;
      const std::vector<Value<double>> drawn =
          draws_.values(attempt + (only ? 500 : 0), rough ? spread_of_state_draw(attempt) : wider_after_each * tried);
      for (std::size_t i = 0; i < drawn.size(); ++i) {
        const Letter& letter = draws_.letters()[i];
        // A root belongs to the values of the letters at which it was found.
        if (!search_.unknowns().empty() || (only && *only != letter.name)) continue;
        for (Settings& one : settings) one[letter.name] = drawn[i];
      }
      const bool drawn_here = !draws_.none() && search_.unknowns().empty();
      if (drawn_here && !only && attempt < most_draws && !is_assumed(statement_, settings)) continue;
      try {
        AtRoot before = std::exchange(at_root_, {});
        std::unique_ptr<Sample> sample = before.sample ? std::move(before.sample) : sample_at(settings);
        // Letters at which the contacts with friction are in other states say nothing of this one.
        if (rough && !draws_.none() && attempt < most_draws && !sample->contact_states_hold()) continue;
        sample->hold_forces_at_starts();
        AskValues values = std::move(before.values);
        try {
          while (values.values.size() < statement_.asks.size())
            add_ask_value(statement_, *sample, settings, OpenChoice{}, values);
        } catch (const BudgetEnded& ended) {
          if (only || values.values.empty()) throw;
          values.ended = ended.end;
          values.values.resize(statement_.asks.size());
        }
        // Nothing swings where a list of frequencies is empty.
        const auto open = [](const AskValues& all) {
          const auto empty = std::ranges::count_if(all.values, [](const std::optional<WatchedValue>& value) {
            return value && value->answer.is_list() && value->answer.items.empty();
          });
          return all.unanswered.size() + all.no_extremum.size() + static_cast<std::size_t>(empty);
        };
        if (!only && drawn_here && !values.ended && open(values) > 0) {
          if (!partly || open(values) < open(partly->values))
            partly = Partly{std::move(sample), settings, std::move(values)};
          if (++tried < most_draws_for_answers && attempt < most_draws && !limit.spent()) continue;
          keep(std::move(partly->sample), partly->settings);
          return std::move(partly->values);
        }
        keep(std::move(sample), settings);
        return values;
      } catch (const StatementError& error) {
        if (draws_.none() || !search_.unknowns().empty()) throw;
        alike = alike && (!refusal || std::string_view(refusal->what()) == error.what());
        if (!refusal) refusal = error;
        if (attempt < most_draws) continue;
        if (partly) {
          keep(std::move(partly->sample), partly->settings);
          return std::move(partly->values);
        }
        if (alike) throw;
        throw draws_.told(*refusal, alike);
      }
    }
  }

  const Statement& statement_;
  Settings settings_;
  FormulaValues exact_;
  bool shown_;
  UnknownSearch search_;
  LetterDraws draws_;
  const Work begin_ = work_done();
  AllSettings base_;
  bool refused_alike_ = true;  // whether all draws so far were refused for the same reason
  std::unique_ptr<Sample> sample_;
  AskValues asked_;  // the values at sample_
  struct AtRoot {
    std::unique_ptr<Sample> sample;
    AskValues values;
  };
  std::vector<AtRoot> at_roots_;  // what was answered at each root with open letters
  AtRoot at_root_;                // the same at the next one that is solved
  std::optional<RoundedValues> rounded_;
  std::vector<double> natural_;
  std::set<std::string> undetermined_;  // unknowns that a variation changes
};

std::size_t place_in(const Statement& statement, const std::string& situation) {
  const auto found = std::ranges::find(statement.situations, situation, &Situation::name);
  return static_cast<std::size_t>(found - statement.situations.begin());
}

}  // namespace

SolvedStatement solve_statement(const Statement& statement,
                                const std::vector<std::pair<std::string, std::string>>& sets, bool tell_claims) {
  if (statement.asks.empty() && statement.claims.empty())
    fail(statement.file, Mark{1, 1}, "the file asks nothing", "write ask: {a: angular_momentum(disk about G)}");
  const Settings settings = read_settings(statement, sets);
  refuse_beside_rough_blows(statement);
  // Where nothing is left to letters nobody asks for formulas.
  const bool has_letters = !open_letters(statement, settings).empty();
  const FormulaValues exact =
      has_letters || !statement.claims.empty() ? exact_settings(statement, sets) : FormulaValues{};
  if (has_open_contact_states(statement))
    return solve_contact_states(statement, settings, exact,
                                [&](const Statement& tried) { return solve_statement(tried, sets, tell_claims); });
  SolvedStatement solved;
  const bool only_claims =
      statement.asks.empty() && std::all_of(statement.situations.begin(), statement.situations.end(),
                                            [](const Situation& s) { return s.find.empty(); });
  if (only_claims) {
    solved.open_letters = open_letters(statement, settings);
    solved.solutions.emplace_back();
  } else {
    const Statement questions = for_questions(statement);
    solved = StatementSolver(questions, settings, exact).solve();
    for (Solution& solution : solved.solutions)
      for (SolvedUnknown& unknown : solution.unknowns)
        if (unknown.situation) unknown.situation = place_in(statement, questions.situations[*unknown.situation].name);
  }
  for (Solution& solution : solved.solutions) {
    solution.claims = solve_claims(statement, settings_of_root(statement, settings, solution), exact,
                                   formulas_of_root(statement, solution), tell_claims);
    for (const SolvedClaim& claim : solution.claims)
      if (claim.ended) solved.ended = claim.ended;
  }
  return solved;
}

SolvedStatement solve_questions(const Statement& statement, const Settings& settings) {
  if (!open_letters(statement, settings).empty()) throw std::invalid_argument("solve_questions: a letter has no value");
  return StatementSolver(statement, settings, {}).solve();
}

SolvedStatement solve_to_compare(const Statement& statement, const Settings& settings) {
  if (!open_letters(statement, settings).empty())
    throw std::invalid_argument("solve_to_compare: a letter has no value");
  return StatementSolver(statement, settings, {}, false).solve();
}

}  // namespace poinsot::problem
