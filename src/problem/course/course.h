// The motion of a situation, from its start through its stages.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "poinsot/engine/motion/integrator/trajectory.h"
#include "poinsot/engine/work/work.h"
#include "problem/course/driving.h"
#include "problem/course/followed_motion.h"
#include "problem/course/motion_features.h"
#include "problem/course/motion_witness.h"
#include "problem/instant/instant.h"

namespace poinsot {
struct IntegrationResult;
}

namespace poinsot::problem {

struct ContactState;

// What the blows of a contact so far have to do with those that follow.
struct BlowsOfAction {
  double fastest = 0;  // the largest speed of approach, m/s
  int told = 0;        // in notes
};

// A state of the motion with all that its continuation depends on.
struct MotionCheckpoint {
  MotionState state;
  double stage_start = 0;               // s
  std::vector<BlowsOfAction> struck{};  // of each action; empty if no contact has been struck
  double flight = 0;                    // s, from a blow there to the next one as it began; none if zero
};

// How far the motion may be from the true one: its difference from one that is followed with a sixteen times larger
// tolerance.
struct MotionError {
  // Of the coordinates, relative to their natural sizes; infinite if the other motion could not be followed.
  double relative = 0;
  double angle = 0;   // rad
  double length = 0;  // m
};

// A number as a function of time along the motion.
using NumberInTime = std::function<double(double time)>;

class Course : public FollowedMotion {
 public:
  // Situation and settings must outlive the motion. Throws StatementError if the state at the start is not
  // determined.
  // flights_open: whether free bodies may start with velocities that nothing states, as of a satellite of which only
  // the turning is asked. Whoever lets them must vary them (determinacy.h): nothing tells which answers depend on them.
  Course(const Situation& situation, const Settings& settings, const OpenChoice& choice, bool flights_open = false);
  ~Course() override;

  // The situation that moves: after a blow, particles that stay are parts of their bodies.
  const Situation& situation() const { return situation_; }
  // The same with the contacts that have friction in the states in which they are in a state of the motion.
  const Situation& situation_of(const MotionState& state) const { return *in_states_[states_of(state)]; }

  // The start and the end of a stage, s. The last stage may have no end.
  double stage_start(std::size_t stage);
  std::optional<double> stage_end(std::size_t stage);
  // The end of the last stage, if it has one.
  std::optional<double> end() override { return stage_end(stages_.size() - 1); }

  MotionState at(double time);
  // The state at the end of a stage, which still belongs to it.
  MotionState end_of(std::size_t stage);
  // A value, with vectors on the axes that were asked for.
  Value<double> value(double time, const Expression& expression, const std::optional<Expression>& axes);
  // The value of an expression that is a number, in SI units, over time.
  NumberInTime number(const Expression& expression, const std::optional<Expression>& axes);
  NumberWithRate with_rate(const Expression& expression, const std::optional<Expression>& axes);
  Dimension dimension(const Expression& expression, const std::optional<Expression>& axes);

  // The value of a question about the whole motion: an extreme or a period (see motion_features.h).
  Value<double> feature(const Call& call, const std::optional<Expression>& axes, const Mark& mark);
  // The values of all such questions in these expressions, also in names under define:.
  MotionFeatureValues features_in(const std::vector<Expression>& expressions, const std::optional<Expression>& axes);
  // The times between `from` and `to` at which a comparison begins to hold. Without `to` only the first one is
  // sought, for as long as the motion needs.
  std::vector<double> times(const Expression& comparison, const std::optional<Expression>& axes, double from,
                            std::optional<double> to);
  // Refuses sides of different kinds and angles without unit, as wherever values are compared. Throws StatementError.
  static void require_comparable(SolvedInstant& instant, const Expression& comparison,
                                 const std::optional<Expression>& axes);
  // Throws UnansweredError if the sides of what has ended a stage were equal all along it, but for rounding.
  void require_sides_apart(std::size_t stage, const Expression& ending);
  // The first time, from the start, at which a coordinate or any number has a value.
  double time_of(const Expression& quantity, double value, const Mark& mark);

  // The time of a later instant, and how far facts fail to hold at a time.
  double time_of_instant(const Instant& instant);
  std::vector<FactMisfit> fact_misfits(double time, const std::vector<const Fact*>& facts);

  // Follows the motion to a time and no further, or to its end if this comes first. Returns the time reached, s.
  double follow(double time);
  bool is_over() const { return stages_.back().done; }
  // Whether it has its end no later than a time.
  bool ends_by(double time) const { return is_over() && time >= reached(); }
  MotionCheckpoint checkpoint() const;
  // Forgets all of the motion except for a checkpoint, and goes on from there. What follows is then the same to the
  // last bit, whatever was asked before. What lies before the checkpoint can no longer be asked.
  void continue_from(const MotionCheckpoint& checkpoint);
  // How much work one integration may be.
  void set_work_limit(Work most) { most_work_ = most; }
  // The tolerance for a step of the integration, relative to natural sizes. It must be set before the motion is
  // followed.
  void set_tolerance(double tolerance) { tolerance_ = tolerance; }
  // The situation at a time. It is valid until something else is asked.
  SolvedInstant& instant_at(double time);

  // Whether the last stage has dampers and nothing that drives it.
  bool dissipates() const override;
  bool may_come_to_rest() const override;
  bool has_springs() const override;
  bool rests_at(double time) const override { return rests_from_ && time >= *rests_from_ && time <= reached(); }
  bool ends_in_center(double time) override;
  double repeats_to(double range) const override;

  // Velocities that are open at the start and move no mass, so that they are taken as zero: for each open direction
  // the names of its coordinates. Then the number of directions that the impulses of a blow leave open.
  const std::vector<std::vector<std::string>>& open_turnings() const { return open_turnings_; }
  std::size_t open_impulses() const { return open_impulses_; }
  // Whether free bodies start with velocities that nothing states.
  bool has_open_flights() const { return open_flights_; }
  // What is open of forces at the instants that were asked for along the motion: a sentence for each direction, as many
  // as were open at once.
  const std::vector<std::string>& open_forces() const { return open_forces_; }

  // The steps of the integration up to a time; within each the motion is smooth. For a closed form they are intervals
  // in which the motion changes noticeably. After most_nodes of them only the last one is added.
  static constexpr std::size_t most_nodes = 500'000;
  std::vector<double> nodes(double from, double to) override;
  std::vector<double> breaks(double from, double to) override;
  // The time to which the motion was followed, s.
  double reached() const override;
  // A time in which the motion changes noticeably, s.
  double pace_time() const override { return pace_time_; }
  // Whether an endless motion is not followed beyond a time: for the number of its steps, or also for its length.
  bool followed_by_many_steps(double until) const override;
  bool followed_enough(double until) const override;
  // The time in which the coordinates change noticeably at the largest rate that they have had so far, s: longer than
  // the pace time where a load sets the pace that moves nothing, as the weight of a balanced gyroscope. The pace time
  // where nothing moves.
  double turning_time(double until) override;

  // Events of the motion, such as cords that went slack and contacts that were lost, and remarks on how extremes were
  // found.
  const std::vector<std::string>& happenings() const { return happenings_; }
  // A cord or contact that gave way or caught.
  struct Change {
    double time = 0;
    std::string words;  // "the cord 'AB' goes slack"
  };
  const std::vector<Change>& changes() const { return changes_; }
  // What was struck or caught along the motion, the first time of each set of contacts and cords, and with what else it
  // was solved: it can be struck again and looked at.
  struct LaterBlow {
    MotionState before;                   // in which all contacts are
    std::vector<std::size_t> actions;     // those that met
    std::vector<SolvedInstant::Met> met;  // the same if they are struck; nothing if they catch
    std::vector<bool> acting, touching;   // see SolvedInstant::strike_later()
    std::size_t states = 0;               // of contacts with friction, as in in_states_
    bool again = false;                   // whether the same ones met later, too
  };
  const std::vector<LaterBlow>& later_blows() const { return later_blows_; }
  // The instant just after it, which knows what was before, and the situation that it is of, which the motion keeps.
  struct StruckAgain {
    const Situation* situation = nullptr;
    std::unique_ptr<SolvedInstant> instant;
  };
  StruckAgain strike_again(const LaterBlow& blow) const;
  // The drift of the energy relative to its size, if the energy is conserved; or how far it is from the work of what
  // feeds and drains it.
  std::optional<double> energy_drift();
  // How far the blows along the motion are from momenta of particles and from their restitution, and those with
  // friction from a second road; nothing if there were none.
  std::optional<double> blow_misfit() const { return blow_misfit_; }
  std::optional<double> rough_blow_misfit() const { return rough_blow_misfit_; }
  // How the motion was found, in words: "closed form: symmetric top".
  const std::set<std::string>& methods() const { return methods_; }
  // The latest time on which the values and times asked so far depend, and the same for extremes, s.
  double values_until() const { return values_until_; }
  double extremes_until() const { return extremes_until_; }
  // The error up to a time; nothing if the motion is known in closed form or begins with a push of arbitrary size.
  std::optional<MotionError> error(double until);
  // The largest difference between the extremes that were asked for and those of the motion followed with a larger
  // tolerance, relative to their own sizes; infinite if that motion does not answer.
  double extremes_error();
  // The motion against its forces, at times that no search has looked at: between two instants it changes as the
  // equations of instants tell, cords pull and contacts push, and what has parted does not overlap. look: is shown
  // some of the instants. Nothing where nothing was followed. Costs no more than the motion did.
  std::optional<MotionDoubt> course_misfit(const std::function<void(const SolvedInstant&)>& look);
  // Extremes, periods and times that were told, against a scan; nothing if there are none.
  std::optional<MotionDoubt> scan_misfit();

 private:
  struct Slip {
    Mark mark;
    std::string words;
  };
  struct StageRun {
    double start = 0;
    std::optional<double> end;              // known once it is reached, or from the start if the duration is given
    std::vector<Trajectory> pieces;         // in the order of time
    std::vector<std::vector<bool>> acting;  // for each piece, which actions act
    std::vector<std::size_t> states;        // for each piece, those of contacts with friction, as in in_states_
    std::size_t states_now = 0;             // the same where the stage has arrived
    bool states_fresh = false;              // whether they were found for that very time
    std::vector<double> q, v;               // at the end of the last piece
    double time = 0;                        // of that end
    bool begun = false, done = false;
    double flight = 0;  // s, from a blow to the next one there as it began; none if zero
    // A piece without steps, in which these act.
    void begin_piece(const std::vector<bool>& act) {
      pieces.emplace_back();
      acting.push_back(act);
      states.push_back(states_now);
    }
    std::optional<Slip> slips;  // if a contact slips at that end, so that the motion ends
  };
  struct StateEntry {
    bool rate = false;
    std::size_t place = 0;
  };
  std::optional<StateEntry> state_entry(const Expression& expression) const;
  double state_number(double time, const StateEntry& entry);
  const State<double>& state_at(double time);  // valid until the next call
  const Trajectory* piece_at(double time) const;
  class Piece;
  class WorkCounted;
  struct SmoothPart {
    double from = 0, to = 0, step = 0;
  };
  std::vector<SmoothPart> windows(std::size_t count) const;
  std::optional<WitnessedState> witnessed(double time);
  NaturalSizes natural_sizes() const;
  MotionDoubt contact_doubt(double time);
  void begin(std::size_t stage);
  void run(std::size_t stage, double until);
  Driving::Span smooth_span(std::size_t stage, double until);
  void keep(std::size_t stage, const std::shared_ptr<Piece>& kept, IntegrationResult& result);
  void balance_energy();
  void refuse_slack(std::size_t stage, std::size_t action, const Piece& piece);
  void change_holds(std::size_t stage, std::size_t action, Piece& piece);
  // Contacts that meet later (later_blows.cpp).
  const Contact* later_contact(std::size_t action) const;
  SolvedInstant::Met met(std::size_t action);
  std::vector<std::size_t> struck_together(const std::vector<std::size_t>& meeting, const MotionState& state,
                                           Piece& piece, const std::vector<bool>& besides);
  void strike(std::size_t stage, const std::vector<std::size_t>& meeting, Piece& piece);
  // Contacts with friction that are struck together, and those beside that touch (landing.cpp).
  void land(std::size_t stage, const std::vector<std::size_t>& meeting, const std::vector<std::size_t>& beside,
            Piece& piece);
  void keep_blow(LaterBlow blow);
  double end_of_bouncing(const Expression& of);
  // Contacts with friction (motion_friction.cpp).
  void find_contact_states(std::size_t stage, double time, const std::string& leaving);
  void let_slide(std::size_t stage, const std::vector<ContactState>& starting);
  void put_in_contact_states(std::size_t stage, const std::vector<ContactState>& states);
  std::vector<double> times_of_state(const Call& call, double from, std::optional<double> to);
  // The same of smooth contacts and of cords, which are told apart by whether they act (motion_holds.cpp).
  std::optional<std::size_t> smooth_hold(const Call& call) const;
  std::vector<double> times_of_hold(const Call& call, double from, std::optional<double> to);
  void tell_of_hold(const Expression& condition, const std::vector<double>& found, double from,
                    std::optional<double> to);
  void let_turn(std::size_t stage, const std::vector<std::string>& contacts);
  // Contacts with friction that are lost and struck (flying_contacts.cpp).
  bool rubs(const StageRun& run) const { return in_states_[run.states_now]->has_friction(); }
  std::vector<bool> acting_in(const StageRun& run) const;
  std::size_t action_of_contact(const std::string& name) const;
  void put_in_flight(StageRun& run, const std::vector<bool>& acting);
  SolvedInstant& probe_for_blow(StageRun& run, const MotionState& state);
  void leave_blow(std::size_t stage, const std::vector<std::size_t>& beside, double speed, Piece& piece);
  std::size_t states_of(const MotionState& state) const;
  void move_probe(const MotionState& state);
  SolvedInstant& probe_in(std::size_t states, const MotionState& state);
  double natural_speed() const { return start_->scales().length / pace_time_; }
  [[noreturn]] void stops(std::size_t stage, const Mark& mark, const std::string& words);
  [[noreturn]] void slips(std::size_t stage, std::size_t action);
  [[noreturn]] void comes_to_end(std::size_t stage, const ContactLimit& limit);
  [[noreturn]] void throw_slip(const StageRun& run) const;
  std::optional<solve::Scales> own_scales(const When& begins) const;
  std::vector<double> ways_of(const std::vector<const Fact*>& facts, const MotionFeatureValues& features, double time,
                              const std::vector<FactMisfit>& misfits);
  void measure_by_what_is_stated(std::vector<FactMisfit>& misfits, const std::vector<double>& ways) const;
  void set_pace(const MotionState& state);
  void follow_less_closely(Course& coarse) const;
  void tell_how(const ExtremeFound& found, const Call& call);
  std::size_t stage_at(double time);
  // Follows the motion to `until` and says how far that `reached`. If it cannot be followed further, what happens
  // before is known nevertheless: both are then the last time it came to, and the reason is returned; or thrown, if
  // `all` up to the time is wanted.
  std::optional<UnansweredError> follow_as_far(double& until, double& reached, bool all);
  const Mark& mark_of(std::size_t stage) const;
  std::string words_of(std::size_t stage) const;

  const Situation& stated_;
  std::optional<Situation> changed_;  // by particles that stay after a blow
  const Situation& situation_;
  const Settings& settings_;
  OpenChoice choice_;
  bool timed_ = false;  // whether loads or given motions depend on the time
  std::unique_ptr<SolvedInstant> start_;
  // The situation, then copies of it with contacts in other states, and for each an instant that goes along the motion.
  std::vector<const Situation*> in_states_;
  std::vector<std::unique_ptr<const Situation>> changed_states_;
  std::vector<std::unique_ptr<SolvedInstant>> probes_;
  SolvedInstant* probe_ = nullptr;  // the one that was asked last
  std::vector<StageRun> stages_;
  std::vector<std::vector<std::string>> open_turnings_;
  std::size_t open_impulses_ = 0;
  bool open_flights_ = false;
  std::vector<std::string> open_forces_;
  State<double> state_;  // the last one computed
  double pace_time_ = 1;
  Work most_work_ = 60'000'000'000;
  double values_until_ = 0, extremes_until_ = 0;
  static constexpr double usual_tolerance = 1e-12;
  double tolerance_ = usual_tolerance;  // for a step, relative to natural sizes
  std::vector<std::string> happenings_;
  std::vector<Change> changes_;
  std::optional<double> energy_drift_;
  // A piece whose energy was not yet balanced. That takes longer than to follow it, and of most motions, which are
  // tried at other values, nobody asks.
  struct ToBalance {
    std::shared_ptr<Piece> piece;
    std::size_t stage = 0, place = 0;  // among the pieces of the stage
    double kinetic = 0;                // the largest before, J
  };
  std::vector<ToBalance> to_balance_;
  bool has_later_contacts_ = false, open_checked_ = false;
  std::optional<double> rests_from_;   // since when friction holds all that could move in the last stage, s
  std::vector<BlowsOfAction> struck_;  // of each action of the mechanism
  struct Blow {
    double time = 0;
    std::size_t action = 0;
  };
  // The time of the blow that falls on this time but for rounding.
  std::optional<double> blow_at(double time) const;
  std::vector<Blow> blows_;  // at which contacts met, in the order of time
  std::vector<LaterBlow> later_blows_;
  double largest_kinetic_ = 0;             // of the motion so far, where its energy is balanced, J
  std::map<std::string, double> settled_;  // when contacts ceased to bounce, s
  bool doubt_told_ = false;                // of states of contacts with friction that could not be judged
  std::optional<double> blow_misfit_, rough_blow_misfit_;
  std::optional<Machine> whole_machine_;  // with contacts that are open at the start
  struct AskedExtreme {
    Call call;
    std::optional<Expression> axes;
    Mark mark;
    double value = 0;
  };
  std::vector<AskedExtreme> asked_extremes_;
  // What was told of the whole motion, to be held against a scan of the number from a time on, to the end of the
  // motion or to where a first event was found.
  struct Told {
    std::string words;
    NumberInTime number;
    double from = 0;
    std::optional<double> to;
    std::function<ScanMisfit(const MotionScan&)> against;
  };
  std::vector<Told> told_;
  void tell(Told told);
  void note_open_forces();  // of the instant that was asked last
  NumberInTime number_at_instants(const Expression& expression, const std::optional<Expression>& axes);
  // The work that the motion and its questions were.
  Work work_ = 0;
  bool counting_ = false;
  std::set<std::string> methods_;
  bool in_closed_form_ = true;                     // whether all that was followed so far is known in closed form
  std::vector<std::unique_ptr<Driving>> driving_;  // for each stage that was followed, if it depends on the time
  std::size_t looks_ = 1000;                       // samples of loads and given motions in a part of the motion
};

// Whether something is stated about the motion after its start.
bool has_later_facts(const Situation& situation);
// How far that fails to hold. tolerance: that of the integration, if it may be larger than usual.
std::vector<FactMisfit> later_misfits(const Situation& situation, const Settings& settings, const OpenChoice& choice,
                                      std::optional<double> tolerance = {});

}  // namespace poinsot::problem
