// The motion that a problem states, from its start through its stages.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "poinsot/engine/motion/integrator/trajectory.h"
#include "problem/course/motion_features.h"
#include "problem/instant/instant.h"
#include "problem/machine/driving.h"

namespace poinsot {
struct IntegrationResult;
}

namespace poinsot::problem {

// Where a motion stands, and all that its going on depends on.
struct MotionCheckpoint {
  MotionState state;
  double stage_start = 0;  // s
};

// How far the motion may be from the true one: by how much it differs from one followed sixteen times less closely.
struct MotionError {
  double relative = 0;  // of the coordinates, to their natural sizes; infinite if the other one could not be followed
  double angle = 0;     // rad
  double length = 0;    // m
};

// One number along the motion.
using NumberInTime = std::function<double(double time)>;

class Course {
 public:
  // problem and settings must outlive the motion. Throws StatementError if the state at the start is not fixed.
  Course(const Situation& situation, const Settings& settings, const OpenChoice& choice);
  ~Course();

  // The problem that moves: particles that stay after a blow belong to their bodies.
  const Situation& situation() const { return situation_; }

  // When a stage starts and ends, s; the last one may have no end.
  double stage_start(std::size_t stage);
  std::optional<double> stage_end(std::size_t stage);
  // The end of the last stage, if it has one.
  std::optional<double> end() { return stage_end(stages_.size() - 1); }

  MotionState at(double time);
  // At the end of a stage, still in it.
  MotionState end_of(std::size_t stage);
  // A value with vectors on the asked axes.
  Value<double> value(double time, const Expression& expression, const std::optional<Expression>& axes);
  // The number that an expression is, in SI.
  NumberInTime number(const Expression& expression, const std::optional<Expression>& axes);
  NumberWithRate with_rate(const Expression& expression, const std::optional<Expression>& axes);
  Dimension dimension(const Expression& expression, const std::optional<Expression>& axes);

  // What is asked over the motion from its start on: extremes and periods (see motion_features.h).
  Value<double> feature(const Call& call, const std::optional<Expression>& axes, const Mark& mark);
  // The times, from `from` to `to`, at which a comparison comes to hold; the first one only, of a motion as long as
  // needed, if there is no `to`.
  std::vector<double> times(const Expression& comparison, const std::optional<Expression>& axes, double from,
                            std::optional<double> to);
  // The first time at which a coordinate, or any number, has a value, from the start on.
  double time_of(const Expression& quantity, double value, const Mark& mark);

  // When a later instant is, and by how much facts fail to hold at a time.
  double time_of_instant(const Instant& instant);
  std::vector<double> fact_misfits(double time, const std::vector<const Fact*>& facts);

  // Follows the motion to a time and no further, or to its end if that comes before. Where it stands then, s.
  double follow(double time);
  bool is_over() const { return stages_.back().done; }
  MotionCheckpoint checkpoint() const;
  // Forgets all of the motion but a checkpoint and goes on from there: the motion that follows, and what happens in it,
  // is to the last bit the same whatever this object was asked before. What lies before can no longer be asked.
  void continue_from(const MotionCheckpoint& checkpoint);
  // How long one integration may take, s of real time.
  void set_time_limit(double seconds) { most_seconds_ = seconds; }
  // The tolerance of a step of the integration, over the natural sizes; before the motion is followed.
  void set_tolerance(double tolerance) { tolerance_ = tolerance; }
  // The problem at a time; valid until anything else is asked.
  SolvedInstant& instant_at(double time);

  // Whether the last stage has dampers and nothing that drives it.
  bool dissipates() const;
  bool has_springs() const;

  // What is open at its start and moves no mass, so that it is taken for zero: of each direction, the names of the
  // coordinates in it. How many directions the impulses of a blow leave open.
  const std::vector<std::vector<std::string>>& open_turnings() const { return open_turnings_; }
  std::size_t open_impulses() const { return open_impulses_; }

  // The steps of the integration up to a time: where the motion is smooth. Along a closed form they are parts in which
  // it changes noticeably. No more than most_nodes, then the last.
  static constexpr std::size_t most_nodes = 500'000;
  std::vector<double> nodes(double from, double to);
  // How far it has been followed, s.
  double reached() const;
  // A time in which the motion changes noticeably, s.
  double pace_time() const { return pace_time_; }
  // Whether an endless motion is not followed beyond a time.
  bool followed_enough(double until) const;

  // What happened on the way: cords that went slack, contacts that were lost; how extremes were told.
  const std::vector<std::string>& happenings() const { return happenings_; }
  // The drift of the energy relative to its size, where it is conserved.
  std::optional<double> energy_drift() const { return energy_drift_; }
  // How it was found, in words: "closed form: symmetric top".
  const std::set<std::string>& methods() const { return methods_; }
  // The latest times on which what has been asked of it depends, s: of values and times, and of extremes.
  double values_until() const { return values_until_; }
  double extremes_until() const { return extremes_until_; }
  // Up to a time; none where the motion is known in closed form or begins with a nudge.
  std::optional<MotionError> error(double until);
  // The largest difference of the extremes that were asked from those of the motion followed less closely, as parts of
  // their own sizes; infinite if the other motion does not tell them.
  double extremes_error();

 private:
  struct Slip {
    Mark mark;
    std::string words;
  };
  struct StageRun {
    double start = 0;
    std::optional<double> end;              // known once it is reached, or from the start if it lasts a given time
    std::vector<Trajectory> pieces;         // one after the other
    std::vector<std::vector<bool>> acting;  // of each piece: which actions act
    std::vector<double> q, v;               // at the end of the last piece
    double time = 0;                        // of that end
    bool begun = false, done = false;
    std::optional<Slip> slips;  // at that end, so that nothing tells how it goes on
  };
  struct StateEntry {
    bool rate = false;
    std::size_t place = 0;
  };
  std::optional<StateEntry> state_entry(const Expression& expression) const;
  double state_number(double time, const StateEntry& entry);
  const State<double>& state_at(double time);  // valid until the next one is asked
  const Trajectory* piece_at(double time) const;
  class Piece;
  void begin(std::size_t stage);
  void run(std::size_t stage, double until);
  Driving::Span smooth_span(std::size_t stage, double until);
  void keep(std::size_t stage, Piece& piece, const IntegrationResult& result);
  void change_holds(std::size_t stage, std::size_t action, Piece& piece);
  [[noreturn]] void slips(std::size_t stage, std::size_t action);
  [[noreturn]] void comes_to_end(std::size_t stage, const ContactLimit& limit);
  [[noreturn]] void throw_slip(const StageRun& run) const;
  void set_pace(const MotionState& state);
  void follow_less_closely(Course& coarse) const;
  void tell_how(const ExtremeFound& found, const Call& call);
  std::size_t stage_at(double time);
  const Mark& mark_of(std::size_t stage) const;
  std::string words_of(std::size_t stage) const;

  const Situation& stated_;
  std::optional<Situation> changed_;  // by particles that stay after a blow
  const Situation& situation_;
  const Settings& settings_;
  OpenChoice choice_;
  bool timed_ = false;  // loads or given motions follow the time
  std::unique_ptr<SolvedInstant> start_, probe_;
  std::vector<StageRun> stages_;
  std::vector<std::vector<std::string>> open_turnings_;
  std::size_t open_impulses_ = 0;
  State<double> state_;  // the last one looked at
  double pace_time_ = 1;
  double most_seconds_ = 60;
  double values_until_ = 0, extremes_until_ = 0;
  double tolerance_ = 1e-12;  // of a step, over the natural sizes
  std::vector<std::string> happenings_;
  std::optional<double> energy_drift_;
  struct AskedExtreme {
    Call call;
    std::optional<Expression> axes;
    Mark mark;
    double value = 0;
  };
  std::vector<AskedExtreme> asked_extremes_;
  std::set<std::string> methods_;
  std::vector<std::unique_ptr<Driving>> driving_;  // of each stage that has been followed, if it follows the time
  std::size_t looks_ = 1000;                       // at what drives, in a part of the motion
};

// Whether something is stated of the motion after its start.
bool has_later_facts(const Situation& situation);
// By how much that fails to hold, in natural units. tolerance: of the integration, if it may be less close than usual.
std::vector<double> later_misfits(const Situation& situation, const Settings& settings, const OpenChoice& choice,
                                  std::optional<double> tolerance = {});

}  // namespace poinsot::problem
