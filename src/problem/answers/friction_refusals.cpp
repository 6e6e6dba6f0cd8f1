#include "problem/answers/friction_refusals.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <string_view>

#include "problem/answers/letter_draws.h"
#include "problem/course/course.h"
#include "problem/instant/instant.h"
#include "problem/language/diagnostic.h"
#include "problem/language/evaluate_support.h"
#include "problem/language/expression_walk.h"
#include "problem/machine/data.h"
#include "problem/machine/machine.h"
#include "problem/quantities/describe.h"
#include "problem/quantities/quantity_functions.h"
#include "problem/results/insert_answers.h"

namespace poinsot::problem {
namespace {

void refuse_situation(const Situation& situation) {
  const auto rough = std::ranges::find_if(situation.contacts, &Contact::rubs);
  if (rough == situation.contacts.end()) return;
  const auto refuse = [&](const std::string& message, const std::string& hint) {
    fail(situation.file, rough->friction->mark, message, hint);
  };
  if (situation.has_blow() && !situation.find.empty())
    refuse("unknowns are not found from blows on what " + rough->words() + " holds with friction", "give them values");
  const auto slipping = std::ranges::find_if(situation.contacts, &Contact::on_cord);
  if (slipping != situation.contacts.end() && situation.has_blow())
    fail(
        situation.file, slipping->friction->mark,
        "a blow with friction of a cord is not solved: how far " + slipping->words() + " slips meanwhile is not sought",
        "leave out the friction of the cord");
  if (slipping != situation.contacts.end() && situation.steady)
    fail(situation.file, slipping->friction->mark,
         "steady motions with friction of a cord are not sought: whether " + slipping->words() + " slips is not tried",
         "leave out the friction of the cord");
  if (!situation.choose.empty())
    refuse("what is to be chosen is not sought where contacts have friction",
           "give it a value, or list it under find:");
  if (!situation.gravity)
    refuse("nothing is said of gravity, which decides how " + rough->words() + " is loaded",
           "write gravity: -y or gravity: none");
}

bool asks_acceleration(const Expression& quantity) {
  const Call* call = quantity.as<Call>();
  return (call && (call->function == "acceleration" || call->function == "angular_acceleration")) ||
         any_child(quantity, asks_acceleration);
}

}  // namespace

namespace {

bool calls(const Expression& expression, std::initializer_list<std::string_view> functions) {
  const Call* call = expression.as<Call>();
  return call && std::ranges::find(functions, call->function) != functions.end();
}

// Whether it is said of the instant itself, and not of other times.
bool is_of_instant(const Expression& expression) {
  return !expression.as<At>() && !asks_motion_feature(expression) &&
         !any_child(expression, [](const Expression& part) { return !is_of_instant(part); });
}

}  // namespace

bool is_limit_of_states(const Ask& ask) {
  if (!ask.extremum || ask.extremum->conditions.empty()) return false;
  return std::ranges::all_of(ask.extremum->conditions, [](const Expression& condition) {
    return calls(condition, {"sticking", "sliding", "parting", "touching", "taut"}) ||
           (condition.as<Comparison>() && is_of_instant(condition));
  });
}

namespace {

void refuse_beside_rough_teeth(const Statement& statement) {
  for (const Situation& situation : statement.situations) {
    const auto rough =
        std::ranges::find_if(situation.gears, [](const Gear& gear) { return gear.friction.has_value(); });
    if (rough == situation.gears.end()) continue;
    const auto refuse = [&](const std::string& message, const std::string& hint) {
      fail(situation.file, rough->friction->mark(), message, hint);
    };
    if (situation.has_blow())
      refuse("a blow with friction in the teeth of gear '" + rough->name + "' is not solved", "leave out the friction");
    if (std::ranges::any_of(situation.contacts, &Contact::strikes_later))
      refuse("blows that come later are not solved beside friction in the teeth of gear '" + rough->name + "'",
             "leave out the friction");
    if (situation.has_friction())
      refuse("friction in the teeth of gear '" + rough->name + "' and in contacts or joints is not solved together",
             "leave out one of them");
    if (situation.steady)
      refuse("steady motions with friction in the teeth of gear '" + rough->name + "' are not sought",
             "state rates and accelerations of joints instead");
    if (!statement.claims.empty())
      refuse("claims are not decided where teeth have friction: they would have to hold for either flank",
             "ask for the quantity, or leave out the friction");
    for (const Ask& ask : statement.asks)
      for (const Expression& expression : ask.of)
        if (asks_stability(expression))
          fail(statement.file, ask.mark,
               "stability is not told where the teeth of gear '" + rough->name +
                   "' have friction: a disturbance may "
                   "let other flanks carry",
               "leave out the friction");
  }
}

}  // namespace

void refuse_beside_rough_blows(const Statement& statement) {
  refuse_beside_rough_teeth(statement);
  for (const Situation& situation : statement.situations) {
    const auto rough =
        std::ranges::find_if(situation.impacts, [](const Impact& impact) { return impact.friction.has_value(); });
    if (rough == situation.impacts.end()) continue;
    const auto refuse = [&](const std::string& message, const std::string& hint) {
      fail(situation.file, rough->friction->mark(), message, hint);
    };
    if (!statement.claims.empty())
      refuse("claims are not decided where blows have friction: slipping and sticking would have to be told apart",
             "ask for the quantity, or leave out the friction");
    if (!situation.choose.empty())
      refuse("what is to be chosen is not sought where blows have friction", "list it under find:");
  }
}

namespace {

// A function that there is not, as stick(floor): that is what is to be mended, and not what the whole then seems to
// ask.
void refuse_unknown_functions(const Statement& statement, const Expression& expression) {
  if (const Call* call = expression.as<Call>()) {
    const bool known = find_quantity(call->function) ||
                       std::ranges::any_of(mathematical_functions(),
                                           [&](const FunctionForm& form) { return form.name == call->function; });
    std::vector<std::string> quantities;
    for (const FunctionForm& form : quantity_functions()) quantities.push_back(form.name);
    if (!known) {
      const UnknownCall words = describe_unknown_call(*call, quantities);
      fail(statement.file, expression.mark(), words.message, words.hint);
    }
  }
  for_each_child(expression, [&](const Expression& part) { refuse_unknown_functions(statement, part); });
}

}  // namespace

void refuse_beside_friction(const Statement& statement) {
  for (const Situation& situation : statement.situations) {
    refuse_situation(situation);
    if (!situation.has_blow() || !situation.has_friction()) continue;
    if (!statement.claims.empty())
      fail(statement.file, statement.claims.front().mark,
           "claims are not decided in blows where contacts have friction: what sticks and slides after them changes "
           "with "
           "the letters",
           "ask for the quantity, or leave out the friction");
    for (const Ask& ask : statement.asks)
      if (is_limit_of_states(ask))
        fail(statement.file, ask.mark, "up to where contacts stick is not sought in a blow",
             "ask what they do at single values: a note tells it");
  }
}

namespace {

// Why a question is not answered, whatever the rest of the file is.
std::optional<Diagnostic> refused_beside_friction(const Statement& statement, const Ask& ask) {
  const std::vector<std::string> data = settable_names(statement.situations.front());
  if (ask.table && std::ranges::find(data, ask.table->over) != data.end() &&
      std::ranges::any_of(statement.situations, [](const Situation& situation) { return !situation.find.empty(); }))
    return Diagnostic{statement.file, ask.mark,
                      "in tables over data unknowns are not found anew where contacts have friction: their states may "
                      "differ from row to row",
                      "ask for single values, with --set for others"};
  if (!ask.extremum) return std::nullopt;
  const bool steady =
      std::ranges::any_of(statement.situations, [](const Situation& one) { return one.steady.has_value(); });
  for (const Expression& condition : ask.extremum->conditions) refuse_unknown_functions(statement, condition);
  const auto sticks = [](const Expression& condition) { return calls(condition, {"sticking"}); };
  if (is_limit_of_states(ask) && (!steady || std::ranges::all_of(ask.extremum->conditions, sticks)))
    return std::nullopt;
  return Diagnostic{
      statement.file, ask.mark,
      steady ? "extrema are not sought in a steady motion where contacts have friction, but for the limit up to "
               "which they stick"
             : "extrema are not sought where contacts have friction, but for what they do at an instant",
      "write {smallest: mu, while: sticking(floor)}"};
}

}  // namespace

std::optional<SolvedStatement> solve_without_refused(const Statement& statement,
                                                     const std::function<SolvedStatement(const Statement&)>& solve) {
  Statement rest = statement;
  rest.asks.clear();
  std::vector<std::size_t> places;
  Solution unanswered;
  std::optional<Diagnostic> first;
  for (std::size_t i = 0; i < statement.asks.size(); ++i) {
    const std::optional<Diagnostic> why = refused_beside_friction(statement, statement.asks[i]);
    if (!why) {
      rest.asks.push_back(statement.asks[i]);
      continue;
    }
    if (!first) first = why;
    places.push_back(i);
    SolvedAsk& ask = unanswered.asks.emplace_back();
    ask.state = AskState::undetermined;
    ask.reason = why->message + ": " + why->hint;
    ask.words = describe(statement.asks[i], statement.situations.front(), false);
  }
  if (!first) return std::nullopt;
  if (rest.asks.empty()) throw StatementError(*first);
  SolvedStatement solved = solve(rest);
  for (Solution& solution : solved.solutions) insert_answers(solution, places, unanswered);
  return solved;
}

std::optional<std::string> cord_beyond_digits(const Statement& statement, const Settings& settings) {
  constexpr double most = 1e9;
  for (const Situation& situation : statement.situations) try {
      DataScope<double> data(situation, settings);
      DataScope<TimeJet> timed(situation, settings, time_jet(0.0));
      const AnyValue one = [](const Dimension&) { return 1.0; };
      for (const auto& contact : build_machine(situation, data, timed, one, MachineOptions{}).rough_contacts)
        if (contact.on_cord() && contact.friction_at_rest * contact.wrap > std::log(most)) return contact.name;
    } catch (const StatementError&) {
      // Letters may have no value.
    }
  return std::nullopt;
}

bool states_accelerations(const Statement& statement) {
  return std::ranges::any_of(statement.situations, [](const Situation& situation) {
    return std::ranges::any_of(situation.instants, [](const Instant& instant) {
      return std::ranges::any_of(instant.facts, [](const Fact& fact) { return asks_acceleration(fact.quantity); });
    });
  });
}

}  // namespace poinsot::problem
