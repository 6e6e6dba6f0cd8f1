#include "problem/answers/contact_states.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <string>

#include "problem/answers/friction_refusals.h"
#include "problem/answers/idle_contacts.h"
#include "problem/answers/letter_draws.h"
#include "problem/answers/untold_states.h"
#include "problem/formulas/formula_task.h"
#include "problem/instant/blow_as_loads.h"
#include "problem/instant/contact_state_search.h"
#include "problem/instant/contact_state_words.h"
#include "problem/language/diagnostic.h"
#include "problem/language/expression.h"
#include "problem/language/expression_walk.h"
#include "problem/language/words.h"
#include "problem/limits/limit_in_letters.h"
#include "problem/quantities/quantity_functions.h"
#include "problem/results/insert_answers.h"
#include "problem/unknowns/sample.h"

namespace poinsot::problem {
namespace {

constexpr std::size_t most_searched = 1024;  // in which unknowns are sought

using States = std::vector<ContactState>;

bool is_before(const States& a, const States& b) {
  return std::ranges::lexicographical_compare(a, b, {}, &ContactState::grip, &ContactState::grip);
}

class ContactStates {
 public:
  ContactStates(const Statement& statement, const Settings& settings,
                const std::function<SolvedStatement(const Statement&)>& solve)
      : statement_(statement), settings_(settings), solve_(solve), draws_(statement, settings) {}

  SolvedStatement solve() {
    const bool searched =
        std::ranges::any_of(statement_.situations, [](const Situation& s) { return !s.find.empty(); });
    if (searched && !draws_.none())
      fail(statement_.file, first_rough().friction->mark,
           "with friction, unknowns are found for numbers only, and letters have no values here",
           "give the letters values by --set, or leave out find:");
    if (searched)
      solve_with_unknowns();
    else
      solve_what_holds();
    if (result_.solutions.empty()) none_holds(searched);
    return std::move(result_);
  }

 private:
  const Contact& first_rough() const {
    for (const Situation& situation : statement_.situations)
      for (const Contact& contact : situation.contacts)
        if (contact.rubs()) return contact;
    throw std::logic_error("no contact has friction");
  }

  // Without unknowns: the states of each situation by itself, and every combination of these.
  void solve_what_holds() {
    std::vector<States> all{{}};
    for (std::size_t i = 0; i < statement_.situations.size(); ++i) {
      if (!statement_.situations[i].has_friction()) continue;
      const std::vector<States> own = statement_.situations[i].steady ? std::vector<States>{all_at_rest(i)}
                                      : draws_.none()                 ? held_at_numbers(i)
                                                                      : held_at_draws(i);
      std::vector<States> longer;
      for (const States& states : all)
        for (const States& more : own) {
          longer.push_back(states);
          longer.back().insert(longer.back().end(), more.begin(), more.end());
        }
      all = std::move(longer);
    }
    for (const States& states : all) {
      require_sticking(states);
      const Statement found = in_contact_states(statement_, states);
      const bool sought = std::ranges::any_of(statement_.situations, is_steady_and_rough);
      take(solve_(found), states, [&](const Solution& solution, States& held) {
        return !sought || !draws_.none() || holds(found, solution, held);
      });
    }
    if (!draws_.none() && !result_.solutions.empty())
      for (const std::string& words : untold_states(statement_, settings_, all)) add_once(result_.warnings, words);
    constexpr std::size_t listed = 2;
    for (std::size_t k = 0; k < std::min(listed, doubts_.size()); ++k)
      add_once(result_.warnings, "a state of the contacts with friction could not be judged: " + doubts_[k]);
    if (doubts_.size() > listed)
      add_once(result_.warnings,
               fmt::format("{} other states of the contacts with friction could not be judged, either",
                           doubts_.size() - listed));
    if (directions_sought_)
      add_once(
          result_.warnings,
          std::string("the directions in which several contacts begin to slide were sought from some starts: there "
                      "may be other states"));
  }

  std::vector<States> held_at_numbers(std::size_t i) {
    const Situation& stated = statement_.situations[i];
    HeldStates held;
    if (stated.has_blow()) {
      if (std::optional<States> idle = idle_in_blow(stated, i, settings_)) return {std::move(*idle)};
      require_rest(stated);
      const Situation loads = blow_as_loads(stated);
      held = states_that_hold(loads, i, settings_, false);
      for (States& states : held.all) add_joints_in_blow(stated, i, states);
    } else {
      held = states_that_hold(stated, i, settings_, false);
    }
    note(held);
    for (States& states : held.all)
      for (ContactState& state : states)
        if (state.has_direction()) name_direction(state, statement_.situations[i], settings_);
    return std::move(held.all);
  }

  static bool is_steady_and_rough(const Situation& situation) { return situation.steady && situation.has_friction(); }

  // In a steady motion contacts with friction are taken to stick. That they do is looked at in what is found.
  States all_at_rest(std::size_t i) const {
    States states;
    for (const Contact& contact : statement_.situations[i].contacts)
      if (contact.rubs()) states.push_back({contact.name, i, Grip::sticks, {}, false, contact.in_joint});
    if (!draws_.none())
      fail(statement_.file, first_rough().friction->mark,
           "in letters, steady motions with friction are not solved: whether contacts stick in them depends on '" +
               draws_.letters().front().name + "'",
           "give the letters values by --set, or state no_slip: true and ask for the forces");
    return states;
  }

  // Near a steady motion what sticks is a constraint, as long as it does so within its limit; what slides or parts has
  // no linear equations.
  void require_sticking(const States& states) const {
    for (const Ask& ask : statement_.asks) {
      std::set<std::string> functions;
      for (const Expression& expression : ask.of) collect_functions(expression, functions, true);
      if (ask.table)
        for (const NamedExpression& column : ask.table->columns) collect_functions(column.value, functions, true);
      for (const std::string& name : functions) {
        const QuantityFunction* function = find_quantity(name);
        if (!function || function->kind != QuantityKind::stability) continue;
        for (const ContactState& state : states)
          if (state.grip != Grip::sticks || state.in_joint)
            fail(statement_.file, ask.mark,
                 name + "() is told where all that has friction are contacts that stick, and " + words_of(state),
                 "leave out the friction, or state what does not move");
      }
    }
  }

  // What a blow leaves is found for bodies at rest before it (instant/blow_as_loads.h).
  void require_rest(const Situation& situation) const {
    if (!rests_before_blow(situation, settings_))
      fail(situation.file, first_rough().friction->mark,
           "blows on bodies with rough contacts are solved where everything is at rest before",
           "write instants: {before: rest}, or leave out the friction");
  }

  void note(const HeldStates& held) {
    for (const std::string& doubt : held.doubts) add_once(doubts_, doubt);
    directions_sought_ = directions_sought_ || held.directions_sought;
  }

  Settings settings_at(int draw) const {
    Settings settings = settings_;
    const std::vector<Value<double>> drawn = draws_.values(draw, spread_of_state_draw(draw));
    for (std::size_t k = 0; k < drawn.size(); ++k) settings[draws_.letters()[k].name] = drawn[k];
    return settings;
  }

  // The states that hold at some values of the letters. Directions must be those of names, as formulas need them.
  std::vector<States> held_at_draws(std::size_t i) {
    const Situation& situation = statement_.situations[i];
    if (situation.has_blow()) return {untouched_at_draws(i)};
    std::vector<States> all;
    std::optional<StatementError> refusal;
    bool any = false;
    for (int draw = 0; draw < most_state_draws; ++draw) {
      const Settings settings = settings_at(draw);
      if (!is_assumed(statement_, AllSettings(statement_.situations.size(), settings))) continue;
      HeldStates held;
      try {
        held = states_that_hold(situation, i, settings, true);
      } catch (const StatementError& error) {
        if (!refusal) refusal = error;
        continue;
      }
      any = true;
      note(held);
      for (States& states : held.all) {
        for (ContactState& state : states)
          if (state.has_direction() && !name_line(state, situation, settings)) direction_changes(situation, state);
        if (std::ranges::none_of(all, [&](const States& known) { return are_same(known, states); }))
          all.push_back(std::move(states));
      }
      if (held.directions_sought) direction_changes(situation, {first_rough().name, i, Grip::slides, {}, true});
    }
    if (!any && refusal) throw StatementError(*refusal);
    std::ranges::stable_sort(all, is_before);
    return all;
  }

  States untouched_at_draws(std::size_t i) const {
    constexpr std::size_t enough = 24;
    std::vector<Settings> at;
    for (int draw = 0; draw < most_state_draws && at.size() < enough; ++draw)
      if (Settings settings = settings_at(draw);
          is_assumed(statement_, AllSettings(statement_.situations.size(), settings)))
        at.push_back(std::move(settings));
    return untouched_in_blow(statement_.situations[i], i, at, draws_.letters().front().name);
  }

  [[noreturn]] static void direction_changes(const Situation& situation, const ContactState& state) {
    const auto contact = std::ranges::find(situation.contacts, state.contact, &Contact::name);
    fail(situation.file, contact->friction->mark,
         "in letters, " + contact->words() + " slides in a direction that is none of the axes and none of directions:",
         "give the letters values by --set, or name the direction under directions:");
  }

  // With unknowns: these are sought in every combination, with slips along axes and named directions.
  void solve_with_unknowns() {
    std::vector<States> all{{}};
    for (std::size_t i = 0; i < statement_.situations.size(); ++i)
      for (const Contact& contact : statement_.situations[i].contacts) {
        if (!contact.rubs()) continue;
        std::vector<States> longer;
        for (const States& states : all)
          for (ContactState& state : possible_states(statement_.situations[i], i, contact, settings_)) {
            longer.push_back(states);
            longer.back().push_back(std::move(state));
          }
        all = std::move(longer);
        if (all.size() > most_searched)
          fail(statement_.file, contact.friction->mark,
               "so many contacts with friction have too many states together to seek unknowns in each",
               "leave out the friction where it does not matter, or give the unknowns values");
      }
    for (const States& states : all) {
      require_sticking(states);
      const Statement tried = in_contact_states(statement_, states);
      try {
        SolvedStatement solved = solve_(tried);
        some_without_solution_ = some_without_solution_ || solved.solutions.empty();
        take(std::move(solved), states,
             [&](const Solution& solution, States& found) { return holds(tried, solution, found); });
      } catch (const StatementError& error) {
        if (!senseless_) senseless_ = error;
      }
    }
  }

  // Whether the contacts are in their states with the unknowns of a root; notes which of them begin to slide.
  bool holds(const Statement& tried, const Solution& solution, States& states) {
    const std::vector<Settings> settings = settings_of_root(tried, settings_, solution);
    try {
      Sample sample(tried, settings, OpenChoice{});
      if (!sample.contact_states_hold()) return false;
      for (ContactState& state : states) {
        if (state.grip != Grip::slides) continue;
        const Situation& situation = tried.situations[state.situation];
        const States start = states_at_start(situation, state.situation, settings[state.situation]);
        state.from_rest = std::ranges::find(start, state.contact, &ContactState::contact)->grip == Grip::sticks;
        const auto contact = std::ranges::find(situation.contacts, state.contact, &Contact::name);
        if (state.from_rest && contact->friction->falls())
          fail(statement_.file, contact->friction->mark,
               "unknowns are not found where contact '" + state.contact +
                   "' begins to slide with less friction than at rest: it might stay at rest as well",
               "give the contact a single coefficient, or the unknowns values");
      }
      return true;
    } catch (const StatementError& error) {
      if (!refusal_) refusal_ = error;
      return false;
    }
  }

  template <class Holds>
  void take(SolvedStatement solved, const States& states, const Holds& holds) {
    bool any = false;
    for (Solution& solution : solved.solutions) {
      States found = states;
      if (!holds(solution, found)) continue;
      any = true;
      for (const ContactState& state : found) {
        const Situation& situation = statement_.situations[state.situation];
        if (state.idle) {
          if (!state.in_joint)
            solution.notes.push_back("the blow does not press contact '" + state.contact +
                                     "', which takes no part in it" +
                                     (situation.name.empty() ? "" : " @ " + situation.name));
          continue;
        }
        solution.notes.push_back((situation.has_blow() ? "in the blow, " : "") + words_of(state, situation, settings_) +
                                 (situation.name.empty() ? "" : " @ " + situation.name));
      }
      solution.contact_states = std::move(found);
      result_.solutions.push_back(std::move(solution));
    }
    result_.open_letters = solved.open_letters;
    // What was noticed in states that do not hold is of no use to anybody.
    if (any)
      for (const std::string& warning : solved.warnings) add_once(result_.warnings, warning);
    if (solved.ended) result_.ended = solved.ended;
  }

  [[noreturn]] void none_holds(bool searched) const {
    if (refusal_) throw StatementError(*refusal_);
    // What makes no sense in one state says nothing where another was looked through to its end.
    if (senseless_ && !some_without_solution_) throw StatementError(*senseless_);
    if (const auto cord = cord_beyond_digits(statement_, settings_))
      fail(
          statement_.file, first_rough().friction->mark,
          "friction lets one side of '" + *cord +
              "' pull more than a billion times as hard as the other: whether it slips is beyond the digits of numbers",
          "leave the friction or a load a letter: formulas are told all the same, or wind it less often");
    const Mark& mark = first_rough().friction->mark;
    if (!doubts_.empty())
      fail(statement_.file, mark,
           "no state of the contacts with friction was found, and one could not be judged: " + doubts_.front());
    if (std::ranges::any_of(statement_.situations, is_steady_and_rough))
      fail(statement_.file, mark,
           "in this steady motion a contact with friction would need more friction to stick, and steady motions in "
           "which one slides are not sought",
           "ask for its limit, {largest: n, while: sticking(" + first_rough().name + ")}, or correct the data");
    for (const Situation& situation : statement_.situations)
      for (const Contact& contact : situation.contacts)
        if (contact.friction && contact.of_belt)
          fail(
              statement_.file, contact.friction->mark,
              "belt '" + contact.of + "' slips: its friction does not hold the load" +
                  (searched ? " at any values of the unknowns that were tried" : "") +
                  ", and a belt that slips is not followed",
              "ask how far it holds: {smallest: T0, while: sticking(" + contact.name + ")}, or leave out the friction");
    if (searched || directions_sought_)
      fail(statement_.file, mark, "no state of the contacts with friction was found that holds",
           "give the unknowns values or narrower ranges under where:, or name the directions in which contacts slide "
           "under directions:");
    throw NoStateError(
        statement_.file, mark,
        "no state of the contacts with friction holds: sticking, sliding and parting each contradict Coulomb's law "
        "here" +
            std::string(draws_.none() ? "" : ", at all values that were tried for the letters"),
        states_accelerations(statement_)
            ? "leave stated accelerations to be found: friction is against the slip, and what is to roll along slides "
              "if it is a particle"
            : "rigid bodies with dry friction may have no solution (Painleve's paradox): reduce the friction, or "
              "correct the data");
  }

  const Statement& statement_;
  const Settings& settings_;
  const std::function<SolvedStatement(const Statement&)>& solve_;
  const LetterDraws draws_;
  SolvedStatement result_;
  std::vector<std::string> doubts_;
  bool directions_sought_ = false;
  std::optional<StatementError> refusal_;    // of a state in which there is a solution
  std::optional<StatementError> senseless_;  // of one in which there can be none
  bool some_without_solution_ = false;       // whether a state was looked through in which there is none
};

// For limits up to which contacts stick: those that slip sliding, those at rest sticking. Where it is not known how
// they slip, because something is to be found, they are taken to be at rest.
States states_of_limits(const Statement& statement, const Settings& settings) {
  const Settings drawn = LetterDraws(statement, settings).settings();
  States states;
  for (std::size_t i = 0; i < statement.situations.size(); ++i) {
    const Situation& situation = statement.situations[i];
    if (!situation.has_friction()) continue;
    try {
      for (ContactState& state : states_at_start(situation, i, drawn)) {
        if (state.has_direction()) name_line(state, situation, drawn);
        states.push_back(std::move(state));
      }
    } catch (const StatementError&) {
      for (const Contact& contact : situation.contacts)
        if (contact.rubs()) states.push_back({contact.name, i, Grip::sticks, {}, false, !contact.touches()});
    }
  }
  return states;
}

// With values for all letters, drawn one time after the other.
std::vector<Settings> settings_of_draws(const Statement& statement, const Settings& settings) {
  const LetterDraws draws(statement, settings);
  std::vector<Settings> all;
  for (int draw = 0; draw < most_state_draws; ++draw) {
    const std::vector<Value<double>> drawn = draws.values(draw, spread_of_state_draw(draw));
    all.push_back(settings);
    for (std::size_t k = 0; k < drawn.size(); ++k) all.back()[draws.letters()[k].name] = drawn[k];
  }
  return all;
}

// Up to which value contacts stick or touch is sought by itself, whatever they do at the values stated: in letters
// where others than what is varied have no value.
SolvedStatement solve_limits(const Statement& limits, const Settings& settings, const FormulaValues& exact,
                             const std::function<SolvedStatement(const Statement&)>& solve) {
  const std::vector<Letter> open = open_letters(limits, settings);
  const auto in_letters = [&](const Ask& ask) {
    return std::ranges::any_of(open, [&](const Letter& letter) { return letter.name != ask.extremum->name; });
  };
  const States sticking = states_of_limits(limits, settings);
  Statement by_numbers = limits;
  std::erase_if(by_numbers.asks, in_letters);
  SolvedStatement found;
  found.open_letters = open;
  if (by_numbers.asks.empty())
    found.solutions.emplace_back();
  else
    found = solve(in_contact_states(by_numbers, sticking));
  for (Solution& solution : found.solutions) {
    solution.contact_states = sticking;
    // What is said there of the letter that is varied is said of a value that it was given on the way.
    solution.assumptions.clear();
    solution.grounds.clear();
  }
  const std::vector<Settings> draws = settings_of_draws(limits, settings);
  for (std::size_t i = 0; i < limits.asks.size(); ++i) {
    if (!in_letters(limits.asks[i])) continue;
    const Solution limit = limit_in_letters(limits, limits.asks[i], open, draws, exact);
    for (Solution& solution : found.solutions) insert_answers(solution, {i}, limit);
  }
  return found;
}

}  // namespace

bool has_open_contact_states(const Statement& statement) {
  return std::ranges::any_of(statement.situations, [](const Situation& situation) {
    return std::ranges::any_of(situation.contacts,
                               [](const Contact& contact) { return contact.rubs() && contact.grip == Grip::unknown; });
  });
}

Statement in_contact_states(const Statement& statement, const std::vector<ContactState>& states) {
  Statement result = statement;
  for (std::size_t i = 0; i < result.situations.size(); ++i) put_in_states(result.situations[i], i, states);
  return result;
}

std::vector<FormulaValues> formulas_of_root(const Statement& statement, const Solution& solution) {
  std::vector<FormulaValues> all(statement.situations.size());
  for (const SolvedUnknown& unknown : solution.unknowns)
    for (std::size_t i = 0; i < all.size() && unknown.formula; ++i)
      if (unknown.is_of(i)) all[i][unknown.own_name] = *unknown.formula;
  return all;
}

std::vector<Settings> settings_of_root(const Statement& statement, const Settings& settings, const Solution& solution) {
  std::vector<Settings> all(statement.situations.size(), settings);
  for (const SolvedUnknown& unknown : solution.unknowns)
    for (std::size_t i = 0; i < all.size(); ++i)
      if (!unknown.formula && unknown.is_of(i)) all[i][unknown.own_name] = unknown.value;
  return all;
}

SolvedStatement solve_contact_states(const Statement& statement, const Settings& settings, const FormulaValues& exact,
                                     const std::function<SolvedStatement(const Statement&)>& solve) {
  refuse_beside_friction(statement);
  if (std::optional<SolvedStatement> rest = solve_without_refused(statement, solve)) return *std::move(rest);
  Statement limits = statement, others = statement;
  std::erase_if(limits.asks, [](const Ask& ask) { return !is_limit_of_states(ask); });
  std::erase_if(others.asks, is_limit_of_states);
  if (limits.asks.empty()) return ContactStates(statement, settings, solve).solve();
  SolvedStatement found = solve_limits(limits, settings, exact, solve);
  if (others.asks.empty() || found.solutions.empty()) return found;
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < statement.asks.size(); ++i)
    if (is_limit_of_states(statement.asks[i])) places.push_back(i);
  SolvedStatement result = ContactStates(others, settings, solve).solve();
  for (Solution& solution : result.solutions) insert_answers(solution, places, found.solutions.front());
  return result;
}

}  // namespace poinsot::problem
