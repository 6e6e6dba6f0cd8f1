// The largest or smallest value of a datum for which conditions hold: {largest: w, while: stable(plate)}.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "problem/unknowns/sample.h"
#include "problem/unknowns/stability_end.h"
#include "problem/unknowns/unknown_ranges.h"
#include "problem/unknowns/unknown_search.h"

namespace poinsot::problem {

struct ExtremumFound {
  std::optional<Value<double>> value;
  std::string reason;              // why there is no such value
  std::string note;                // tells if the conditions do not clearly fail beyond the value
  std::unique_ptr<Sample> sample;  // the instants at the value, where the conditions still hold
};

class ExtremumSearch {
 public:
  // All arguments must outlive the search. settings: one for each situation.
  ExtremumSearch(const Statement& statement, const Ask& ask, const AllSettings& settings, const OpenChoice& choice);

  ExtremumFound find();
  // Whether the conditions hold on one side of the value and not on the other.
  bool is_at(double value);

 private:
  ExtremumFound found_end();
  ExtremumFound no_end_up_to(double value, bool tried);
  bool sticks_beyond(double end);
  void confirm(double value, const Sample& sample);
  struct Span {
    double lower = 0, upper = 0, scale = 1;
  };
  Span span() const;
  // How large the datum is by nature in this problem, with the value that it has; 0 if that cannot be told.
  double natural_size(const Settings& settings) const;
  // What the conditions come to at a value. Doubtful: the linearised equations do not decide about stability.
  // Refused: there is no such motion.
  enum class Truth { holds, fails, doubtful, refused };
  Truth truth_at(double value);
  bool holds(double value) { return truth_at(value) == Truth::holds; }
  std::string told_beyond(double inside, double outside);
  // A value of the datum in the unit of the answer.
  std::string in_unit(double value) const;
  // What lies nearer than an end: a note, and why it is no end where the conditions hold by intervals beyond it too.
  struct Nearer {
    std::string note{}, by_intervals{};
  };
  Nearer look_nearer(double end);
  // A value beyond an end at which they hold once more, as far as the gap before it is wide.
  std::optional<double> holds_again(double end, double gap);
  double border(double inside, double outside);
  // How far the conditions are from failing at a value: below zero where one does. Nothing where that is not known.
  std::optional<double> margin_at(double value);
  std::optional<double> margin_of(const Expression& condition, Sample& sample);
  // A value between those of a grid at which the conditions hold, though they do at none of these: nearest to the end
  // of the grid, where the margin is largest. Nothing if there is none.
  std::optional<double> held_between(const std::vector<double>& grid);
  // The settings of all situations at a value, one for each root of the other unknowns of a statement.
  std::vector<AllSettings> settings_at(double value, const Statement& statement) const;
  // The statement with the values of a root; for each combination of states of contacts with friction where these are
  // sought, beside unknowns for each in which the root keeps them.
  struct Found {
    std::shared_ptr<const Statement> statement;
    AllSettings settings;
  };
  std::vector<Found> found_at(double value);
  // The value that the datum has by itself; nothing if it has none.
  std::optional<double> own_value() const;
  bool has_unknowns() const;
  bool may_be(const Contact& contact, Grip grip) const;
  std::vector<Found> found_beside_unknowns(double value);
  std::unique_ptr<Sample> sample_at(double value);
  bool conditions_hold_in(Sample& sample);
  // The motion that a condition stable(X) looks at; nothing if the statement refuses the value.
  std::optional<NearMotion> near_motion(const Expression& stable, double value);
  // The end of stability between two values; nothing if that is not what ends there or if it is not known closely.
  std::optional<StabilityEnd> stability_ends(double inside, double outside);

  // The end of sticking to the last digits; nothing if that is not what ends there.
  std::optional<double> sticking_ends(double inside, double outside);

  const Statement& statement_;
  const Ask& ask_;
  const AllSettings& settings_;
  OpenChoice choice_;
  const Situation& situation_;
  const bool seeks_states_;  // of contacts with friction, anew at each value
  Dimension dimension_;
  std::optional<StatementError> refusal_;
  bool unanswered_ = false;             // whether the last refusal was that of a motion which does not answer
  bool contradicted_ = false;           // whether that is so because what is stated contradicts itself
  std::optional<double> confirmed_at_;  // where the particles were asked last
  bool unconfirmed_ = false;
  bool doubtful_ = false;               // of the value tried last
  const Expression* failed_ = nullptr;  // the condition that failed at it
  // Beside unknowns, the combinations of states, those first that held last.
  std::vector<std::shared_ptr<const Statement>> combinations_{};
  double holds_to_ = 0;  // where no end was found: how far it was seen to hold
  bool ever_ = false;    // whether the conditions could be evaluated at any value
};

}  // namespace poinsot::problem
