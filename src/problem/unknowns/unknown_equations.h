// The conditions on unknowns as equations for their values.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "poinsot/engine/solve/roots/roots.h"
#include "problem/instant/varied_instant.h"
#include "problem/unknowns/unknown_system.h"

namespace poinsot::problem {

// The misfits of a group of conditions after velocities, accelerations and forces have been eliminated.
struct GroupConditions {
  ConditionGroup group;
  std::vector<double> values;
  double size = 0;                               // the size of the largest term in the values
  std::vector<std::string> words;                // a description of each value, if asked for
  std::vector<std::vector<double>> slopes = {};  // of each value by each unknown, if asked for
};

// Units, scaling and pivots are determined once and held. So misfits at different values of the unknowns can be
// compared, and they are as smooth as the data.
class UnknownEquations {
 public:
  // The statement must outlive the object. all: every unknown of the statement. Those that are not sought in this
  // system and have no value in `settings` (one for each situation) get a trial value of one unit.
  UnknownEquations(const Statement& statement, UnknownSystem system, const AllSettings& settings,
                   const OpenChoice& choice, const std::vector<Unknown>& all);
  UnknownEquations(const UnknownEquations&) = delete;
  UnknownEquations& operator=(const UnknownEquations&) = delete;

  const UnknownSystem& system() const { return system_; }
  const std::vector<UnknownSlot>& slots() const { return slots_; }
  const AllSettings& settings() const { return settings_; }  // without the unknowns of this system
  const std::vector<solve::RootRange>& ranges() const { return ranges_; }

  AllSettings settings_at(const std::vector<double>& x) const;
  // Returns nothing where the values make no sense. Squares are neglected as the statement says.
  std::optional<solve::RootEquations> operator()(const std::vector<double>& x);
  // The smooth equations alone, for which forces are not solved; all equations if some are not smooth.
  std::optional<solve::RootEquations> smooth(const std::vector<double>& x);
  // All equations, with exact slopes of the smooth ones by each unknown, from dual numbers. Returns nothing if a
  // motion has to be followed, if squares are neglected, or if some quantity has no derivatives.
  std::optional<solve::RootEquations> with_slopes(const std::vector<double>& x,
                                                  std::vector<std::vector<double>>* slopes);
  // Whether the conditions hold for the values that the settings give to the unknowns, with a far larger tolerance
  // than for a root that is found anew.
  bool hold_as_set();
  std::optional<std::vector<GroupConditions>> conditions_at(const std::vector<double>& x);  // with words
  // The conditions of a group as their author may know them: "mass(bar) at 'now'", with the situation if there are
  // several.
  std::vector<std::string> condition_words(const GroupConditions& group) const;
  // Some places in the ranges; the first is near their middle.
  std::vector<std::vector<double>> places(std::size_t count) const;

  // The problem for solve::find_roots. It is valid as long as this object.
  solve::RootProblem problem();

  // The unknowns whose squares are neglected.
  const std::vector<std::size_t>& without_squares() const { return small_; }
  // Whether the equations had a value anywhere, the first reason why they had none, and whether that was the same
  // wherever they were tried.
  bool makes_sense() const { return makes_sense_; }
  const std::optional<StatementError>& refusal() const { return refusal_; }
  bool refused_alike() const { return refused_alike_; }

 private:
  struct Measures {
    std::map<std::size_t, solve::Scales> scales;  // for each situation
    std::map<std::pair<std::size_t, InstantSystem>, solve::LinearElimination> eliminations;
  };
  // What to evaluate: all equations, or only the smooth ones (the misfits of the groups), with or without
  // descriptions.
  enum class Wanted { everything, smooth, smooth_with_words };
  struct Evaluated {
    std::vector<double> at;
    Wanted wanted;
    solve::RootEquations equations;
    std::vector<GroupConditions> groups;
    std::map<std::size_t, std::unique_ptr<SolvedInstant>> instants = {};  // by situation
  };

  // The equations and their slopes where the unknowns whose squares are neglected are zero. If there are smooth
  // equations these are taken, since they are linear, while the others are divided by sizes that vary.
  struct LinearPart {
    std::vector<double> at, values;
    double size = 0;
    std::vector<std::vector<double>> slopes;  // of each value by each of these unknowns
  };
  std::optional<LinearPart> linear_part(const std::vector<double>& at);
  std::optional<LinearPart> linear_part_by_differences(const std::vector<double>& at);
  bool follows_motion() const;
  void refuse(const StatementError& error);
  void hold_measures();
  bool take_measures(const std::vector<double>& x);  // returns whether other places may tell more
  // The result is kept for slopes at the same place.
  const Evaluated& evaluate(const std::vector<double>& x, Wanted wanted = Wanted::everything);
  // The groups at a place, with their slopes by some unknowns.
  std::optional<std::vector<GroupConditions>> sloped_groups(const std::vector<double>& x,
                                                            const std::vector<std::size_t>& unknowns);
  std::optional<solve::RootEquations> exact(const std::vector<double>& x, Wanted wanted = Wanted::everything);
  void put(const std::vector<double>& x, AllSettings& settings) const;
  // Facts that are not linear are evaluated in the state `instant`, which the pivots' equations alone determine.
  bool add_left_over(GroupConditions& group, InstantSystem which, const SolvedInstant& instant, bool with_words) const;
  void add_slopes(std::vector<GroupConditions>& groups, std::size_t situation, const SolvedInstant& instant,
                  const std::vector<std::size_t>& unknowns) const;
  std::vector<Dual<1>> varied_left_over(std::size_t situation, InstantSystem which, VariedInstant& instant) const;

  const Statement& statement_;
  UnknownSystem system_;
  AllSettings settings_;
  OpenChoice choice_;
  AllSettings trial_;  // with values for all unknowns
  std::vector<UnknownSlot> slots_;
  std::vector<solve::RootRange> ranges_;
  std::vector<std::size_t> small_;
  Measures measures_;
  bool measured_ = false;
  bool makes_sense_ = false;
  bool all_smooth_ = true;  // at all places where this was asked
  std::optional<StatementError> refusal_;
  bool refused_alike_ = true;
  std::optional<Evaluated> evaluated_;     // the last one evaluated
  std::optional<LinearPart> linear_part_;  // the last one computed
  std::optional<double> motion_tolerance_;
};

}  // namespace poinsot::problem
