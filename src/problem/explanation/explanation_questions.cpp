#include "problem/explanation/explanation_questions.h"

#include <algorithm>
#include <string_view>

#include "problem/language/expression_walk.h"
#include "problem/machine/data.h"
#include "problem/quantities/quantity_functions.h"

namespace poinsot::problem {
namespace {

// Walks through an expression and records what it asks of the model at its instant.
class Collector {
 public:
  // along: whether all that is asked belongs to no time of a motion in particular.
  Collector(const Statement& statement, Sample& sample, StatementQuestions& found, bool along = false)
      : statement_(statement), sample_(sample), found_(found), along_(along) {}

  void collect(const Expression& expression, const Sample::Home& home) {
    home_ = home;
    walk(expression);
  }

 private:
  void walk(const Expression& expression) {
    if (!expression) return;
    if (const Call* call = expression.as<Call>()) return of_call(*call);
    if (const Name* name = expression.as<Name>()) return of_name(*name);
    if (const At* at = expression.as<At>()) return of_at(*at);
    for_each_child(expression, [&](const Expression& part) { walk(part); });
  }

  void of_at(const At& at) {
    if (along_) return walk(at.expression);
    const Sample::Home outer = home_;
    home_ = sample_.resolve(at, at.instant_mark);
    walk(at.expression);
    home_ = outer;
  }

  void of_name(const Name& name) {
    const Situation& situation = statement_.situations[home_.situation];
    for (const NamedExpression& item : situation.define) {
      if (item.name != name.name || depth_ > 50) continue;
      ++depth_;
      const bool outer = rate_;
      rate_ = rate_ || name.primes > 0;
      walk(item.value);
      rate_ = outer;
      --depth_;
    }
    for (const Joint& joint : situation.joints)
      for (const Freedom& freedom : joint.freedoms) {
        const Name* coordinate = freedom.position ? freedom.position->as<Name>() : nullptr;
        if (!coordinate || coordinate->name != name.name) continue;
        const int body = machine().index.at(joint.to);
        if (name.primes >= 1) here().moving.insert(body);
        if (name.primes >= 1) here().going.insert(body);
        if (name.primes == 2) accelerate(body);
      }
  }

  void of_call(const Call& call) {
    const std::string_view f = call.function;
    if (is_motion_feature(call)) {
      if (along_)
        for (const Argument& argument : call.arguments) walk(argument.value);
      found_.motions.insert(home_.situation);
      return;
    }
    const auto is = [&](std::initializer_list<const char*> words) {
      return std::any_of(words.begin(), words.end(), [&](const char* word) { return f == word; });
    };
    if (f == "rate") {
      const bool outer = rate_;
      rate_ = true;
      walk(call.arguments.front().value);
      rate_ = outer;
      return;
    }
    if (is({"angular_momentum", "momentum", "kinetic_energy"})) return of_momentum(call);
    const QuantityFunction* quantity = find_quantity(call.function);
    const auto is_kind = [&](QuantityKind kind) { return quantity && quantity->kind == kind; };
    if (is_kind(QuantityKind::force) || is_kind(QuantityKind::holding) ||
        (is_kind(QuantityKind::friction) && f != "slip_velocity"))
      return of_force(call);
    if (is({"velocity", "angular_velocity", "acceleration", "angular_acceleration"})) {
      for (const int body : bodies_in(call.arguments.front().value)) {
        here().moving.insert(body);
        if (is({"velocity", "acceleration"})) here().going.insert(body);
        if (rate_ || is({"acceleration", "angular_acceleration"})) accelerate(body);
      }
      if (is({"velocity", "acceleration"}) && call.arguments.size() == 1 && !rate_)
        of_point(call, f == "velocity" ? PointQuestion::Kind::velocity : PointQuestion::Kind::acceleration);
      return;
    }
    if (is_kind(QuantityKind::free_motion)) {
      here().free_motions.push_back(call);
      return;
    }
    if (is_kind(QuantityKind::stability)) {
      here().stability = true;
      if (f == "response") here().responses.push_back(call);
      return;
    }
    // Where a body has come to is told by the motion.
    if (is({"center", "position"}) && (home_.time || home_.ending)) {
      of_point(call, PointQuestion::Kind::place);
      return;
    }
    if (is_kind(QuantityKind::inertia) || is({"mass", "weight", "center"}))
      for (const int body : bodies_in(call.arguments.front().value)) here().masses.insert(body);
    for (const Argument& argument : call.arguments) walk(argument.value);
  }

  void of_point(const Call& call, PointQuestion::Kind kind) {
    const Expression& of = call.arguments.front().value;
    const std::vector<int> bodies = bodies_in(of);
    const auto same = [&](const PointQuestion& one) {
      return one.kind == kind && same_tree(one.call.arguments.front().value, of);
    };
    if (bodies.size() != 1 || (kind != PointQuestion::Kind::place && !of.as<Of>()) ||
        std::ranges::any_of(here().points, same))
      return;
    here().points.push_back({kind, bodies.front(), call});
  }

  void of_momentum(const Call& call) {
    MomentumQuestion question;
    const std::vector<int> bodies = bodies_in(call.arguments.front().value);
    question.body = bodies.empty() ? whole_system : bodies.front();
    if (const Expression* about = call.argument("about")) question.about = *about;
    question.angular = call.function == "angular_momentum";
    question.linear = call.function == "momentum";
    question.energy = call.function == "kinetic_energy";
    question.rate = rate_;
    if (rate_) here().accelerations = true;
    for (MomentumQuestion& known : here().momenta) {
      const bool same_point = known.about.has_value() == question.about.has_value() &&
                              (!known.about || same_tree(*known.about, *question.about));
      if (known.body != question.body || !(same_point || (known.angular && question.linear) || question.linear))
        continue;
      known.angular = known.angular || question.angular;
      known.linear = known.linear || question.linear;
      known.energy = known.energy || question.energy;
      known.rate = known.rate || question.rate;
      return;
    }
    here().momenta.push_back(question);
  }

  void of_force(const Call& call) {
    std::string name, joint;
    const Expression& what = call.arguments.front().value;
    if (const Of* of = what.as<Of>()) {
      name = to_string(of->point);
      joint = to_string(of->body);
    } else {
      name = to_string(what);
    }
    for (const std::size_t action : machine().actions_of(name, joint)) {
      const ActionKind kind = machine().mechanism.actions[action].kind;
      if (call.function == "touching" || call.function == "taut" || call.function == "tension")
        here().pushes.insert(action);
      else if (call.function == "drive" ? kind == ActionKind::drive : true)
        here().forces.insert(action);
    }
    if (call.function == "drive" && joint.empty() && machine().actions_of(name).empty()) here().accelerations = true;
  }

  void accelerate(int body) {
    here().accelerated.insert(body);
    here().accelerations = true;
  }

  // The bodies named in `plate` or `A of plate`.
  std::vector<int> bodies_in(const Expression& expression) {
    std::set<std::string> names;
    collect_names(expression, names);
    std::vector<int> bodies;
    for (const auto& [name, index] : machine().index)
      if (names.contains(name) && index != ground) bodies.push_back(index);
    return bodies;
  }

  InstantQuestions& here() { return found_.instants[home_]; }
  const Machine& machine() { return sample_.instant(home_).machine(); }

  const Statement& statement_;
  Sample& sample_;
  StatementQuestions& found_;
  bool along_;
  Sample::Home home_;
  bool rate_ = false;
  int depth_ = 0;
};

bool runs_over_datum(const Statement& statement, const Table& table) {
  const std::vector<std::string> data = settable_names(statement.situations.front());
  return std::ranges::find(data, table.over) != data.end();
}

// The columns of a table over a datum, with this as it is stated.
void collect_table(const Statement& statement, const Table& table, Sample& sample, Collector& collector,
                   StatementQuestions& found) {
  for (const NamedExpression& column : table.columns) {
    const Sample::Home home = sample.home(column.value, column.mark);
    if (asks_motion_feature(column.value)) {
      found.motions.insert(home.situation);
      continue;
    }
    try {
      // The stated value may be none at which anything is asked.
      SolvedInstant& instant = sample.instant(home);
      if (!statement.situations[home.situation].has_blow()) instant.solve_forces();
    } catch (const StatementError&) {
      continue;
    }
    found.instants[home];
    collector.collect(column.value, home);
  }
}

// What is asked for of whole motions.
void collect_along(const Statement& statement, Sample& sample, StatementQuestions& found) {
  StatementQuestions all;
  Collector collector(statement, sample, all, true);
  for (const Ask& ask : statement.asks) {
    if (ask.extremum || (ask.table && runs_over_datum(statement, *ask.table))) continue;
    try {
      const Sample::Home start = sample.start_of(sample.home_of(ask).situation);
      if (ask.when || ask.table) found.motions.insert(start.situation);
      if (ask.when) collector.collect(ask.when->condition, start);
      if (ask.table)
        for (const NamedExpression& column : ask.table->columns) collector.collect(column.value, start);
      for (const Expression& one : ask.of) {
        const bool feature = asks_motion_feature(one);
        const Sample::Home home = feature ? start : sample.home(one, ask.mark);
        if (feature || home.time || home.ending) collector.collect(one, sample.start_of(home.situation));
      }
    } catch (const StatementError&) {
      // The asks themselves tell of this.
    }
  }
  for (auto& [home, questions] : all.instants) found.along[home.situation] = std::move(questions);
}

}  // namespace

bool speaks_of_momentum(const Expression& expression) {
  if (const Call* call = expression.as<Call>())
    if (call->function == "angular_momentum" || call->function == "momentum" || call->function == "kinetic_energy")
      return true;
  bool found = false;
  for_each_child(expression, [&](const Expression& part) { found = found || speaks_of_momentum(part); });
  return found;
}

StatementQuestions questions_of(const Statement& statement, Sample& sample, const Solution& solution,
                                const std::map<std::size_t, std::size_t>& limits) {
  StatementQuestions found;
  Collector collector(statement, sample, found);
  for (std::size_t i = 0; i < statement.asks.size(); ++i) {
    const Ask& ask = statement.asks[i];
    // How bodies move that what is stated leaves open is not told. Of forces the equations show what is open.
    const bool is_open = i < solution.asks.size() && solution.asks[i].state == AskState::undetermined;
    if (ask.table && runs_over_datum(statement, *ask.table))
      collect_table(statement, *ask.table, sample, collector, found);
    if (ask.table || ask.when || ask.extremum) continue;
    for (const Expression& expression : ask.of) {
      if (asks_motion_feature(expression)) {
        found.motions.insert(sample.home(expression, ask.mark).situation);
        continue;
      }
      const Sample::Home home = sample.home(expression, ask.mark);
      InstantQuestions& here = found.instants[home];
      if (is_open && level_of(statement.situations[home.situation], expression) != Level::force) continue;
      const std::vector<PointQuestion> determined = here.points;
      collector.collect(expression, home);
      if (is_open) here.points = determined;
    }
  }
  for (const auto& [situation, ask] : limits) {
    const Sample::Home start{situation, statement.situations[situation].has_blow() ? 1U : 0U, std::nullopt};
    found.instants[start];
    for (const Expression& condition : statement.asks[ask].extremum->conditions) collector.collect(condition, start);
  }
  // Facts count as questions as well, since equations for them determine what would otherwise be open.
  for (std::size_t i = 0; i < statement.situations.size(); ++i) {
    const Situation& situation = statement.situations[i];
    if (situation.find.empty()) continue;
    const Sample::Home start{i, situation.has_blow() ? 1U : 0U, std::nullopt};
    for (const Instant& instant : situation.instants) {
      if (is_later(situation, instant)) {
        found.motions.insert(i);
        continue;
      }
      for (const Fact& fact : instant.facts) {
        if (asks_motion_feature(fact.quantity)) {
          found.motions.insert(i);
          continue;
        }
        if (level_of(situation, fact.quantity) != Level::force && !speaks_of_momentum(fact.quantity)) continue;
        collector.collect(fact.quantity, instant.name == "before" ? Sample::Home{i, 0, std::nullopt} : start);
      }
    }
    if (situation.steady) found.instants[start];
  }
  collect_along(statement, sample, found);
  for (const auto& [home, questions] : found.instants)
    if (home.time || home.ending) found.motions.insert(home.situation);
  return found;
}

}  // namespace poinsot::problem
