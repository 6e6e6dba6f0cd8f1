#include "problem/equations/rough_states.h"

#include <algorithm>
#include <optional>

#include "problem/answers/letter_draws.h"
#include "problem/equations/equations.h"
#include "problem/instant/contact_state_search.h"
#include "problem/instant/contact_state_words.h"
#include "problem/language/diagnostic.h"
#include "problem/language/words.h"

namespace poinsot::problem {
namespace {

using States = std::vector<ContactState>;

constexpr int most_draws = 12, draws_of_a_spread = 4;  // of letters, whose sizes may part one state from another

std::string words_of_all(const States& states, const Situation& situation, const Settings& settings) {
  std::vector<std::string> words;
  for (const ContactState& state : states) words.push_back(words_of(state, situation, settings));
  return listed(words);
}

void refuse_forces_of_their_own(const Situation& situation) {
  for (const Contact& contact : situation.contacts) {
    if (!contact.rubs()) continue;
    if (contact.on_cord)
      throw NoEquations(contact.words() +
                        " has friction: how its tension grows round what it slips on has no place in these equations");
    if (contact.friction->bearing && contact.grip == Grip::slides)
      throw NoEquations(contact.words() +
                        " has friction that follows from the size of what it carries, which no linear equations tell: "
                        "state it as a couple or force");
  }
}

}  // namespace

SituationInStates in_stated_states(const Statement& statement, const Situation& situation, const Settings& settings) {
  SituationInStates found{situation, {}};
  refuse_forces_of_their_own(situation);
  const LetterDraws draws(statement, settings);
  const auto number = static_cast<std::size_t>(
      std::ranges::find(statement.situations, situation.name, &Situation::name) - statement.situations.begin());
  std::vector<States> all;
  std::vector<std::string> told;
  std::optional<StatementError> refusal;
  for (int draw = 0; draw < (draws.none() ? 1 : most_draws); ++draw) {
    Settings drawn = settings;
    const std::vector<Value<double>> values = draws.values(draw, draw / draws_of_a_spread);
    for (std::size_t k = 0; k < values.size(); ++k) drawn[draws.letters()[k].name] = values[k];
    try {
      for (States& states : states_that_hold(situation, number, drawn, !draws.none()).all) {
        for (ContactState& state : states)
          if (state.has_direction()) name_line(state, situation, drawn);
        if (std::ranges::any_of(all, [&](const States& known) { return are_same(known, states); })) continue;
        told.push_back(words_of_all(states, situation, drawn));
        all.push_back(std::move(states));
      }
    } catch (const StatementError& error) {
      if (!refusal) refusal = error;
    }
  }
  if (all.empty() && refusal) throw StatementError(*refusal);
  if (all.empty()) throw NoEquations("no state of the contacts with friction holds as it is stated");
  if (all.size() > 1)
    throw NoEquations("the contacts with friction may be in several states as it is stated: " + joined(told, "; or ") +
                      " (state velocities, or values by --set, that leave one)");
  put_in_states(found.situation, number, all.front());
  refuse_forces_of_their_own(found.situation);
  for (ContactState& state : all.front()) {
    const bool presses = !state.in_joint && state.grip != Grip::parts;
    state.from_rest = false;
    // Its friction turns with its slip, whichever way that is.
    const bool any_way = state.sought && state.grip == Grip::slides;
    found.words.push_back(
        "while " +
        (any_way ? "joint '" + state.contact + "' moves against its friction" : words_of(state, situation, settings)) +
        (presses ? " and presses" : ""));
  }
  return found;
}

}  // namespace poinsot::problem
