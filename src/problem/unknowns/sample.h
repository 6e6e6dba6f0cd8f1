// The instants of a statement, solved for one choice of what it leaves open.
#pragma once

#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "problem/course/course.h"
#include "problem/instant/instant.h"
#include "problem/unknowns/situated.h"

namespace poinsot::problem {

// For each situation the values that come from outside the file or were found.
using AllSettings = std::vector<Settings>;

// The situation in which an extremum is sought. Throws StatementError if it is not named or does not exist.
std::size_t situation_of(const Statement& statement, const Ask& ask);

// One choice of what the statement leaves open, and the instants solved for it so far.
class Sample {
 public:
  Sample(const Statement& statement, AllSettings settings, const OpenChoice& choice)
      : statement_(statement), settings_(std::move(settings)), choice_(choice) {}
  // Of a statement that nobody else keeps.
  Sample(std::shared_ptr<const Statement> statement, AllSettings settings, const OpenChoice& choice)
      : own_(std::move(statement)), statement_(*own_), settings_(std::move(settings)), choice_(choice) {}

  // The situation and the instant for which something is asked.
  struct Home {
    std::size_t situation = 0;
    std::size_t instant = 0;     // the stage whose beginning is meant; with a blow, 0 is before it and 1 after it
    std::optional<double> time;  // along the motion, s
    bool ending = false;         // the end of that stage, while its own loads still act
    bool operator<(const Home& other) const {
      return std::tie(situation, instant, time, ending) <
             std::tie(other.situation, other.instant, other.time, other.ending);
    }
  };

  // The value of an expression at an instant, with vectors on the asked axes.
  Value<double> value_at(const Home& place, const Expression& expression, const std::optional<Expression>& axes);
  // The value at the start of a situation, after its blow if it has one.
  Value<double> value_in(std::size_t situation_index, const Expression& expression) {
    return value_at(start_of(situation_index), expression, std::nullopt);
  }
  const std::map<Home, std::unique_ptr<SolvedInstant>>& instants() const { return instants_; }
  const std::map<std::size_t, std::unique_ptr<Course>>& motions() const { return motions_; }
  // The instant at some time of a motion.
  SolvedInstant& instant_at(std::size_t situation_index, double time) { return instant({situation_index, 0, time}); }
  SolvedInstant& instant_of(const Ask& ask) { return instant(home_of(ask)); }
  const Situation& situation_at(const Ask& ask) { return statement_.situations[home_of(ask).situation]; }

  // The situation and instant that stand after an @; the mark is for messages.
  Home resolve(const At& at, const Mark& mark);

  // The motion of a situation.
  Course& motion(std::size_t situation_index);

  // The instant that an expression without @ means: it exists if there is only one situation with at most one stage,
  // and is that after a blow if there is one. An expression each of whose quantities has an @ belongs to the first of
  // these instants.
  Home home(const Expression& expression, const Mark& mark);
  SolvedInstant& instant(const Home& home);
  // Of instants that are solved from now on.
  void write_down_what_is_told() { writes_told_ = true; }
  bool writes_told() const { return writes_told_; }

  // For a table, the first situation that it asks about.
  Home home_of(const Ask& ask);
  // The only instant, or the one just after the blow.
  Home start_of(std::size_t situation_index) const {
    return {situation_index, statement_.situations[situation_index].has_blow() ? 1u : 0u, std::nullopt};
  }
  // Whether all contacts with friction stay in their states at the starts of the situations.
  bool contact_states_hold();
  // Accelerations and forces that are stated at a start hold whatever is asked. Throws StatementError where they do
  // not.
  void hold_forces_at_starts();
  // The situation that an expression means, `otherwise` if it asks for nothing of the model.
  Situated situated_in(const Expression& expression, std::size_t otherwise) const;

  const Statement& statement() const { return statement_; }
  const AllSettings& settings() const { return settings_; }
  const OpenChoice& choice() const { return choice_; }

  // For tables over a datum, by ask: what is unphysical in the first row in which something is.
  const std::map<std::string, std::string>& unphysical_rows() const { return unphysical_rows_; }
  void note_unphysical_row(const std::string& ask, std::string reason) {
    unphysical_rows_.emplace(ask, std::move(reason));
  }
  // By ask: which rows of its table are left out, and why.
  const std::map<std::string, std::vector<std::string>>& rows_left_out() const { return rows_left_out_; }
  void note_row(const std::string& ask, std::string words) {
    std::vector<std::string>& known = rows_left_out_[ask];
    if (std::find(known.begin(), known.end(), words) == known.end()) known.push_back(std::move(words));
  }

 private:
  // The names are those without the situation's own; `known` receives what the situation has.
  std::optional<Home> resolve_in(std::size_t i, const At& at, std::span<const std::string> names, const Mark& mark,
                                 std::vector<std::string>& known);
  bool asks_instant(const Expression& expression) const;
  bool asks_own_unknown(const Expression& expression) const;
  // What the extremes and periods in an expression are, which the motion tells.
  MotionFeatureValues features_in(const Home& place, const Expression& expression,
                                  const std::optional<Expression>& axes);

  std::shared_ptr<const Statement> own_;
  const Statement& statement_;
  AllSettings settings_;
  OpenChoice choice_;
  std::map<Home, std::unique_ptr<SolvedInstant>> instants_;
  std::map<std::size_t, std::unique_ptr<Course>> motions_;
  std::map<std::string, std::string> unphysical_rows_;
  std::map<std::string, std::vector<std::string>> rows_left_out_;
  bool writes_told_ = false;
};

}  // namespace poinsot::problem
