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

// What is left of one group of conditions when velocities, accelerations and forces are eliminated.
struct GroupConditions {
  ConditionGroup group;
  std::vector<double> values;
  double size = 0;                               // of the largest term in them
  std::vector<std::string> words;                // of each, where they are asked for
  std::vector<std::vector<double>> slopes = {};  // of each by each unknown, where they are asked for
};

// Units, scaling and pivots are taken once and held, so that misfits at different values of the unknowns compare, and
// vary as smoothly as the data do.
class UnknownEquations {
 public:
  // statement must outlive it. all: every unknown of the statement; those that the system does not seek and that
  // `settings` (of each situation) do not know take a trial value of one unit.
  UnknownEquations(const Statement& statement, UnknownSystem system, const AllSettings& settings,
                   const OpenChoice& choice, const std::vector<Unknown>& all);
  UnknownEquations(const UnknownEquations&) = delete;
  UnknownEquations& operator=(const UnknownEquations&) = delete;

  const UnknownSystem& system() const { return system_; }
  const std::vector<UnknownSlot>& slots() const { return slots_; }
  const std::vector<solve::RootRange>& ranges() const { return ranges_; }

  AllSettings settings_at(const std::vector<double>& x) const;
  // Nothing where the values make no sense. Without the squares that are neglected, as stated.
  std::optional<solve::RootEquations> operator()(const std::vector<double>& x);
  // Only those that are smooth, without forces being solved; all, where they are not all smooth.
  std::optional<solve::RootEquations> smooth(const std::vector<double>& x);
  // All with exact slopes of the smooth equations by each unknown: by dual numbers. Nothing where a motion is followed,
  // where squares are neglected or where something has no derivatives.
  std::optional<solve::RootEquations> with_slopes(const std::vector<double>& x,
                                                  std::vector<std::vector<double>>* slopes);
  // With the values that the settings give to the unknowns: whether the conditions hold, to far less than is asked of a
  // root that is found anew.
  bool hold_as_set();
  std::optional<std::vector<GroupConditions>> conditions_at(const std::vector<double>& x);  // with words
  // Its conditions as an author may know them: "mass(bar) at 'now'", with the situation where there are several.
  std::vector<std::string> condition_words(const GroupConditions& group) const;
  // Some places in the ranges, among them their middle.
  std::vector<std::vector<double>> places(std::size_t count) const;

  // For solve::find_roots; valid as long as this object.
  solve::RootProblem problem();

  // Which unknowns enter without their squares.
  const std::vector<std::size_t>& without_squares() const { return small_; }
  // Whether there was a value anywhere, and the last reason why there was none.
  bool makes_sense() const { return makes_sense_; }
  const std::optional<StatementError>& refusal() const { return refusal_; }

 private:
  using Level = InstantSystem;
  struct Measures {
    std::map<std::size_t, solve::Scales> scales;  // of each situation
    std::map<std::pair<std::size_t, Level>, solve::LinearElimination> eliminations;
  };
  // All equations, or only the smooth ones: what is left of the groups; with the words of each or without.
  enum class Wanted { everything, smooth, smooth_with_words };
  struct Evaluated {
    std::vector<double> at;
    Wanted wanted;
    solve::RootEquations equations;
    std::vector<GroupConditions> groups;
    std::map<std::size_t, std::unique_ptr<SolvedInstant>> instants = {};  // of situations
  };

  // The equations at zero values of the unknowns that enter without their squares, and their slopes by these: those of
  // the smooth equations, if there are such, as these are linear where the others are divided by what varies.
  struct LinearPart {
    std::vector<double> at, values;
    double size = 0;
    std::vector<std::vector<double>> slopes;  // of each value by each of the unknowns
  };
  std::optional<LinearPart> linear_part(const std::vector<double>& at);
  std::optional<LinearPart> linear_part_by_differences(const std::vector<double>& at);
  bool follows_motion() const;
  void hold_measures();
  bool take_measures(const std::vector<double>& x);  // whether others may tell more
  // Kept for the slopes at the same place.
  const Evaluated& evaluate(const std::vector<double>& x, Wanted wanted = Wanted::everything);
  // The groups there with their slopes by some unknowns.
  std::optional<std::vector<GroupConditions>> sloped_groups(const std::vector<double>& x,
                                                            const std::vector<std::size_t>& unknowns);
  std::optional<solve::RootEquations> exact(const std::vector<double>& x, Wanted wanted = Wanted::everything);
  void put(const std::vector<double>& x, AllSettings& settings) const;
  // Facts in `instant` that are not linear are taken where the pivots' equations alone have brought it.
  bool add_left_over(GroupConditions& group, Level level, const solve::LinearSystem& system,
                     const SolvedInstant& instant, bool with_words) const;
  void add_slopes(std::vector<GroupConditions>& groups, std::size_t situation, const SolvedInstant& instant,
                  const std::vector<std::size_t>& unknowns) const;
  std::vector<Dual<1>> varied_left_over(std::size_t situation, Level level, VariedInstant& instant) const;

  const Statement& statement_;
  UnknownSystem system_;
  AllSettings settings_;
  OpenChoice choice_;
  AllSettings trial_;  // with values for everything
  std::vector<UnknownSlot> slots_;
  std::vector<solve::RootRange> ranges_;
  std::vector<std::size_t> small_;
  Measures measures_;
  bool measured_ = false;
  bool makes_sense_ = false;
  bool all_smooth_ = true;  // wherever it was asked for
  std::optional<StatementError> refusal_;
  std::optional<Evaluated> evaluated_;     // the last one
  std::optional<LinearPart> linear_part_;  // likewise
  std::optional<double> motion_tolerance_;
};

}  // namespace poinsot::problem
