#include "problem/unknowns/states_at_end.h"

#include <algorithm>
#include <utility>

#include "problem/instant/contact_state_words.h"
#include "problem/language/diagnostic.h"
#include "problem/unknowns/extremum.h"

namespace poinsot::problem {
namespace {

bool asks_of(const Extremum& extremum, const Contact& contact, const char* state) {
  return std::ranges::any_of(extremum.conditions, [&](const Expression& condition) {
    const Call* call = condition.as<Call>();
    return call && call->function == state && is_about(*call, contact.name);
  });
}
bool asks_to_stick(const Extremum& extremum, const Contact& contact) { return asks_of(extremum, contact, "sticking"); }

}  // namespace

std::vector<std::string> wanted_to_stick(const Situation& situation, const Extremum& extremum) {
  std::vector<std::string> names;
  if (!situation.cords.empty() || !situation.belts.empty()) return names;
  for (const Contact& contact : situation.contacts) {
    if (!contact.rubs() || contact.friction->falls()) return {};
    if (asks_to_stick(extremum, contact)) names.push_back(contact.name);
  }
  return names;
}

bool leaves_states_open(const Situation& situation, const Extremum& extremum) {
  return std::ranges::any_of(situation.contacts, [&](const Contact& contact) {
    return contact.rubs() && (contact.grip != Grip::sticks || !asks_to_stick(extremum, contact));
  });
}

// Whether what is asked of a contact may hold in a state.
bool ExtremumSearch::may_be(const Contact& contact, Grip grip) const {
  return std::ranges::none_of(ask_.extremum->conditions, [&](const Expression& condition) {
    const Call* call = condition.as<Call>();
    if (!call || call->arguments.empty() || !is_about(*call, contact.name)) return false;
    return (call->function == "sticking" && grip != Grip::sticks) ||
           (call->function == "sliding" && grip != Grip::slides) ||
           (call->function == "parting" && grip != Grip::parts) ||
           (call->function == "touching" && grip == Grip::parts);
  });
}

// The unknowns are sought in each combination, and count where the contacts keep their states with them. One in which
// all holds that is asked is enough.
std::vector<ExtremumSearch::Found> ExtremumSearch::found_beside_unknowns(double value) {
  const std::size_t home = situation_of(statement_, ask_);
  if (combinations_.empty()) {
    combinations_.push_back(std::make_shared<Statement>(statement_));
    constexpr std::size_t most = 200;  // of a search for unknowns each, at some hundred values
    for (const Contact& contact : situation_.contacts) {
      if (!contact.rubs()) continue;
      std::vector<std::shared_ptr<const Statement>> longer;
      for (const std::shared_ptr<const Statement>& one : combinations_)
        for (const ContactState& state : possible_states(situation_, home, contact, settings_[home])) {
          if (!may_be(contact, state.grip)) continue;
          auto statement = std::make_shared<Statement>(*one);
          put_in_states(statement->situations[home], home, {state});
          longer.push_back(std::move(statement));
        }
      combinations_ = std::move(longer);
      if (combinations_.size() > most)
        fail(situation_.file, ask_.mark,
             "so many contacts with friction have too many states together to seek unknowns in each",
             "leave out the friction where it does not matter, or give the unknowns values");
    }
  }
  std::vector<Found> found;
  std::optional<StatementError> refusal;
  bool any = false;
  for (std::size_t k = 0; k < combinations_.size(); ++k) try {
      const std::shared_ptr<const Statement> statement = combinations_[k];
      for (AllSettings& root : settings_at(value, *statement)) {
        any = true;
        Sample sample(statement, root, choice_);
        if (!sample.contact_states_hold()) continue;
        const bool enough = conditions_hold_in(sample);
        found.push_back({statement, std::move(root)});
        if (!enough) continue;
        std::swap(combinations_[k], combinations_.front());
        std::swap(found.front(), found.back());
        return found;
      }
    } catch (const StatementError& error) {
      if (!refusal) refusal = error;
    }
  if (!any && refusal) throw *refusal;
  return found;
}

}  // namespace poinsot::problem
