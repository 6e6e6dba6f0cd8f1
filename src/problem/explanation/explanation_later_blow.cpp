// Blows that come along a motion: momenta before + impulses = momenta after, with the velocities to which it has led.
#include <algorithm>
#include <cctype>
#include <iterator>

#include "problem/explanation/explanation_instant.h"
#include "problem/explanation/explanation_motion.h"
#include "problem/language/words.h"

namespace poinsot::problem {
namespace {

std::string words_of_meeting(const Course::LaterBlow& blow, const std::vector<Action>& actions) {
  std::vector<std::string> words;
  for (const std::size_t action : blow.actions)
    words.push_back(actions[action].kind == ActionKind::cord
                        ? "the cord *" + actions[action].name + "* goes taut"
                        : "the contact *" + actions[action].name + (blow.met.empty() ? "* closes" : "* is struck"));
  std::string all = listed(words);
  all.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(all.front())));
  return all + " at " + with_digits(blow.before.time, 6) + " s" +
         (blow.again ? ", for the first time: what it changes later follows in the same way" : "");
}

}  // namespace

void InstantExplainer::explain_later_blow(const std::string& suffix, const std::string& words) {
  suffix_ = suffix;
  followed_ = later_ = true;
  ExplainedStep start{words + ".", {}};
  for (const std::size_t k : open_coordinates()) {
    const Symbol symbol = symbol_of_coordinate(k, true);
    const Shown value = clean(Shown{figures_.numbers.before->state().v[k], {}}, symbol.dimension);
    if (value.number == 0 || !tex_.can_show(value)) continue;
    start.equations.push_back(tex_.equation(at_beginning(symbol.tex), value, symbol.dimension));
  }
  if (!start.equations.empty()) start.text += " Just before, the motion has led to";
  section("Blow").steps.push_back(std::move(start));
  std::vector<Symbol> symbols;
  section("Inertia");
  const std::vector<std::set<int>> systems = choose_systems();
  for (const std::set<int>& bodies : systems) explain_system(bodies, systems.size() == 1, symbols);
  extra_conditions(open_coordinates(), symbols, section("Impulse and momentum"));
  list_unknowns(symbols);
  std::erase_if(explanation_.sections, [](const ExplainedSection& one) { return one.steps.empty(); });
}

std::map<double, std::vector<ExplainedSection>> later_blow_sections(const Course& motion, const ExplanationTex& tex,
                                                                    const Settings& settings,
                                                                    const std::string& suffix) {
  // Numbers of letters that were drawn are shown nowhere.
  if (tex.letters_open()) return {};
  std::map<double, std::vector<ExplainedSection>> all;
  const LetterValues no_letters;
  const InstantQuestions nothing_asked;
  for (const Course::LaterBlow& blow : motion.later_blows()) {
    const Course::StruckAgain again = motion.strike_again(blow);
    Explanation told;
    InstantExplainer(*again.situation, *again.instant, nullptr, nullptr, no_letters, {}, tex, nothing_asked, settings,
                     told)
        .explain_later_blow(suffix + ", at " + with_digits(blow.before.time, 4) + " s",
                            words_of_meeting(blow, again.instant->machine().mechanism.actions));
    std::ranges::move(told.sections, std::back_inserter(all[blow.before.time]));
  }
  return all;
}

}  // namespace poinsot::problem
