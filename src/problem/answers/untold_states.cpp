#include "problem/answers/untold_states.h"

#include <algorithm>
#include <numbers>
#include <random>

#include "problem/answers/letter_draws.h"
#include "problem/entries/drawn_letters.h"
#include "problem/formulas/formula_task.h"
#include "problem/instant/contact_state_search.h"
#include "problem/instant/contact_state_words.h"
#include "problem/language/diagnostic.h"
#include "problem/language/words.h"

namespace poinsot::problem {
namespace {

using States = std::vector<ContactState>;

constexpr int most_draws = 60, spreads = 15;
constexpr std::size_t most_said = 4;

double drawn_anywhere(const Letter& letter, std::mt19937_64& random, int spread) {
  if (letter.unit.dimension == dimensions::angle)
    return std::uniform_real_distribution<double>(-std::numbers::pi, std::numbers::pi)(random);
  const double value = drawn_letter(letter, random, spread);
  return letter.either_sign && random() % 2 == 0 ? -value : value;
}

// "b = 1.2 rad, mu = 0.5"
std::string words_of_draw(const std::vector<Letter>& letters, const Settings& settings) {
  std::vector<std::string> words;
  constexpr int digits = 3;
  for (const Letter& letter : letters)
    words.push_back(letter.name + " = " + with_digits(settings.at(letter.name).number / letter.unit.factor, digits) +
                    (letter.unit.text.empty() || letter.unit.text == "1" ? "" : " " + letter.unit.text));
  return joined(words);
}

}  // namespace

std::vector<std::string> untold_states(const Statement& statement, const Settings& settings,
                                       const std::vector<States>& told) {
  const std::vector<Letter> letters = open_letters(statement, settings);
  std::mt19937_64 random(77);
  std::vector<States> seen = told;
  std::vector<std::string> said;
  bool none_said = false;
  for (int draw = 0; draw < most_draws && said.size() < most_said; ++draw) {
    Settings drawn = settings;
    for (const Letter& letter : letters)
      drawn[letter.name] =
          Value<double>::of_number(drawn_anywhere(letter, random, draw % spreads), letter.unit.dimension);
    if (!is_assumed(statement, AllSettings(statement.situations.size(), drawn))) continue;
    for (std::size_t i = 0; i < statement.situations.size(); ++i) {
      const Situation& situation = statement.situations[i];
      // A blow that is solved in letters touches none of them.
      if (!situation.has_friction() || situation.has_blow()) continue;
      const std::string at = situation.name.empty() ? "" : " @ " + situation.name;
      try {
        HeldStates held = states_that_hold(situation, i, drawn, true);
        if (held.all.empty() && held.doubts.empty() && !held.directions_sought && !none_said) {
          said.push_back("no state of the contacts with friction was found at some values of the letters, such as " +
                         words_of_draw(letters, drawn) + at);
          none_said = true;
        }
        for (States& states : held.all) {
          for (ContactState& state : states)
            if (state.has_direction()) name_line(state, situation, drawn);
          const auto is_known = [&](const States& known) {
            States own;
            std::ranges::copy_if(known, std::back_inserter(own),
                                 [&](const ContactState& state) { return state.situation == i; });
            return are_same(own, states);
          };
          if (std::ranges::any_of(seen, is_known)) continue;
          std::vector<std::string> words;
          for (const ContactState& state : states) words.push_back(words_of(state, situation, drawn));
          said.push_back("other states hold at some values of the letters, for which nothing is told here: " +
                         joined(words) + at + ", such as at " + words_of_draw(letters, drawn));
          seen.push_back(std::move(states));
        }
      } catch (const StatementError&) {
        // At these values the statement makes no sense.
      }
    }
  }
  return said;
}

}  // namespace poinsot::problem
