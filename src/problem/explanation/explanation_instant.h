// Explains one solved instant as steps of a worked solution.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "problem/explanation/explanation_figures.h"
#include "problem/explanation/explanation_questions.h"
#include "problem/explanation/explanation_tex.h"
#include "problem/explanation/explanation_unknowns.h"
#include "problem/formulas/formula_instant.h"

namespace poinsot::problem {

// The figures of an instant in numbers, and in formulas if there are any.
struct ExplainedFigures {
  InstantFigures<double> numbers;
  std::optional<InstantFigures<Formula>> formulas{};
};

// before: the instant before the blow of `solved`, if this is one; it is that of the blow itself if left out.
InstantFigures<double> figures_of(const SolvedInstant& solved, const SolvedInstant* before);
// forces: whether those are solved.
InstantFigures<Formula> figures_of(const FormulaInstant& formulas, bool forces);

// A point of the drawing with its label.
struct ExplainedPoint {
  std::string label;
  ShownVector position;
};

// The position of a point as number or formula. Throws std::domain_error if it has no formula.
template <class Scalar>
Vector3<Scalar> position_of(const ExplainedPoint& point) {
  if constexpr (std::is_same_v<Scalar, double>) {
    return point.position.number;
  } else {
    if (!point.position.formula) throw std::domain_error("a point without formula");
    return *point.position.formula;
  }
}
// The scalar type of some figures.
template <class Scalar>
Scalar scalar_of(const InstantFigures<Scalar>& figures);
template <class Figures>
using ScalarOf = decltype(scalar_of(std::declval<Figures>()));

// The letter for a component of a vector that is to be found: J_x.
inline std::string component_letter(const Situation& situation, const std::string& vector, std::size_t k) {
  return vector + "_" + situation.axes[k];
}

class InstantExplainer {
 public:
  // formulas: the same instant as formulas, if there are any; letters: the values of their letters; factors: what the
  // terms of a condition on the data may share. All arguments but these must outlive the object.
  InstantExplainer(const Situation& situation, SolvedInstant& solved, SolvedInstant* before, FormulaInstant* formulas,
                   const LetterValues& letters, std::vector<Formula> factors, const ExplanationTex& tex,
                   const InstantQuestions& questions, const Settings& settings, Explanation& explanation);

  // Adds sections with everything that the questions need.
  // followed: whether a motion has led here.
  void explain(const std::string& suffix, bool followed);

  // Adds the equations of a blow in a motion, of which the arguments are the instant just after it. words: what meets
  // there. Defined in explanation_later_blow.cpp.
  void explain_later_blow(const std::string& suffix, const std::string& words);

  // The symbol of an unknown.
  struct Symbol {
    std::string tex;
    double value = 0;  // SI
    double sign = 1;   // symbol = sign times the unknown of the model
    Dimension dimension;
    bool determined = true;
    Shown shown;
  };
  // A row of the balance: rows 0 to 2 are those of forces, 3 to 5 those of moments.
  struct Row {
    std::vector<ShownTerm> left, right;
  };
  // Bodies that are cut free, with the symbols of the unknown forces on them and of their open coordinates.
  struct System {
    BalancePlan plan;
    std::vector<Symbol> unknown, open;
  };
  // Those whose equations give what is asked for; none if no forces are needed.
  std::vector<System> systems() const;
  const InstantFigures<double>& figures() const { return figures_.numbers; }
  // The letter for the forces of an action: the point at which it holds, if it has one, otherwise its name.
  std::string action_symbol(const Action& action) const;
  std::string center_label(int body) const;
  std::string names_of(const std::set<int>& bodies) const;
  bool several_bodies() const { return bodies_with_mass().size() > 1; }
  // Whether a vector is rounding.
  bool vanishes(const Vector3<double>& vector, const Dimension& dimension) const {
    return is_rounding(norm(vector), noise_size(dimension));
  }

 private:
  // The value as a number, and as a formula if this agrees with the number.
  template <class Get>
  Shown shown(const Get& get) const {
    return confirmed(get(figures_.numbers), in_formulas<Formula>(get));
  }
  template <class Get>
  ShownVector shown_vector(const Get& get) const {
    return confirmed(get(figures_.numbers), in_formulas<Vector3<Formula>>(get));
  }
  template <class Result, class Get>
  std::optional<Result> in_formulas(const Get& get) const {
    if (!figures_.formulas) return std::nullopt;
    try {
      return Result(get(*figures_.formulas));
    } catch (const std::domain_error&) {
      return std::nullopt;
    } catch (const FormulaTooLarge&) {
      return std::nullopt;
    }
  }
  Shown confirmed(double number, const std::optional<Formula>& formula) const;
  // A hundredth of the unit of each dimension that the machine sets: arms and masses that count beside others.
  NaturalCoefficient natural_coefficient() const {
    constexpr double part = 1e-2;
    return [this](const Dimension& dimension) {
      return part * natural_unit(solved_.scales(), dimension) * solved_.part_of_turning(dimension);
    };
  }
  double noise_size(const Dimension& dimension) const;
  double natural_size(const Dimension& dimension) const;
  double part_of_length() const;
  Shown clean(Shown value, const Dimension& dimension) const;
  ShownVector clean(ShownVector value, const Dimension& dimension) const;
  ShownVector confirmed(const Vector3<double>& number, const std::optional<Vector3<Formula>>& formula) const;

  // These are defined in explanation_instant.cpp.
  void explain_masses();
  void explain_momenta();
  bool has_absorbed(int body) const;
  ExplainedStep absorbed_step(const MomentumQuestion& question, int body, const std::optional<ExplainedPoint>& about,
                              const std::string& index);
  void explain_momentum(const MomentumQuestion& question);
  void explain_kinematics();
  // These are defined in explanation_kinetics.cpp.
  void explain_points();
  std::optional<Vector3<Formula>> asked_formula(const Expression& asked);
  ExplainedStep motion_of_point(const PointQuestion& question, const std::string& label, const ShownVector& vector);
  bool place_changes_as_told(int body) const;
  bool turns_as_told(int body) const;
  std::optional<std::size_t> turning_axis(int body) const;
  std::optional<ExplainedPoint> told_pivot(int body) const;
  ExplainedStep energy_step(int body, const std::string& index, bool central, const ExplainedPoint* pivot);
  void explain_free_motion();
  std::optional<ExplainedStep> precession_step(int body, const std::string& name, const Expression* about, bool cone);
  void motion_step(std::vector<ExplainedStep>& steps, int body, const std::string& index, bool with_velocity,
                   bool with_accelerations);
  // plane: the axis across which nothing turns, if motion and forces lie in a plane.
  using Plane = std::optional<std::size_t>;
  void inertia_step(ExplainedSection& section, int body, const ExplainedPoint* fixed, Plane plane = {});
  // These are defined in explanation_parts.cpp.
  void parts_step(ExplainedSection& section, int body, const ExplainedPoint& point);
  ExplainedPoint point_of(const Expression& expression);
  ExplainedPoint mass_center(int body);
  std::optional<std::string> named_point(const Vector3<double>& position) const;
  bool rests(int body, const Vector3<double>& point) const;  // whether the body's point at this place rests
  std::string body_name(int body) const;
  bool is_particle(int body) const;
  std::vector<int> bodies_with_mass() const;

  // These are defined in explanation_balance.cpp.
  bool needs_balance() const;
  bool states_momenta() const;
  void explain_balance();
  std::vector<FoundDatum> found_data() const;
  bool found_along_motion() const;
  void explain_found();
  void choice_steps(const std::vector<FoundDatum>& found, std::set<std::string>& said, ExplainedSection& here);
  bool neglects(const std::string& unknown) const;
  std::size_t action_of(const UnknownForce& force) const;
  bool is_asked(const UnknownForce& force) const;
  bool has_pure_equation(const std::set<int>& bodies) const;
  BalancePlan plan_for(const std::set<int>& bodies) const;
  std::vector<std::set<int>> choose_systems() const;
  std::vector<std::set<int>> whole_systems() const;
  std::vector<std::set<int>> only_needed(std::vector<std::set<int>> whole) const;
  bool is_struck(const std::set<int>& bodies) const;
  bool determines(const std::vector<std::set<int>>& systems) const;
  std::vector<std::set<int>> pieces(const std::set<std::size_t>& cut) const;
  Symbol symbol_of(const UnknownForce& force) const;
  // Rates: whether for its velocity, otherwise for its acceleration.
  Symbol symbol_of_coordinate(std::size_t k, bool rates) const;
  std::string index_among_others(const NamedCoordinate& coordinate) const;
  void velocity_conditions();
  System system_of(const std::set<int>& bodies) const;
  std::vector<std::string> turned_axes(const System& system) const;
  void explain_system(const std::set<int>& bodies, bool only, std::vector<Symbol>& listed);
  std::optional<ExplainedPoint> best_point(const BalancePlan& plan) const;
  std::string free_point_name() const;
  std::string where(const ExplainedPoint& point) const;
  std::optional<ExplainedPoint> asked_point(const std::set<int>& bodies);
  // moments_only: no equation of forces follows.
  void kinetic_steps(const std::string& heading, const System& system, const ExplainedPoint& point, bool moments_only,
                     Plane plane);
  Row row_of(const System& system, const MotionBalance<double>& numbers,
             const std::optional<MotionBalance<Formula>>& formulas, std::size_t row) const;
  Dimension row_dimension(std::size_t row) const;
  bool acts_in(const ShownTerm& term, std::size_t row) const;
  // The axis across which neither motion nor forces go, if the rows of the plane stand alone.
  Plane plane_of(const System& system, const std::vector<Row>& rows) const;
  bool moves_in_plane(const std::set<int>& bodies, std::size_t axis) const;
  // Whether one of the bodies has a velocity, or had one before a blow.
  bool moves(const std::set<int>& bodies) const;
  // The unknowns that act across it.
  std::set<std::string> symbols_across(const std::vector<Row>& rows, Plane plane) const;
  // The unknown forces that meet in the reference point.
  struct Meeting {
    std::vector<bool> meets;           // of each unknown
    std::vector<std::string> symbols;  // of those that do
    bool moments_only = false;         // whether the equations of forces are left out
  };
  bool is_particle_at_held_point(const BalancePlan& plan) const;
  Meeting meeting(const System& system, const MotionBalance<double>& numbers, bool held) const;
  void rate_step(ExplainedSection& section, int body, const ExplainedPoint& about, bool fixed);
  void force_list(ExplainedSection& section, const System& system, const std::set<std::string>& across) const;
  std::string factor_in_tex(const Shown& value, const Dimension& dimension) const;
  std::string sliding_coefficient(std::size_t action) const;
  std::string words_of_cord(const std::string& name) const;
  std::string law_of_bearing(std::size_t action) const;
  void friction_step(std::size_t impact, ExplainedSection& section);
  void extra_conditions(const std::vector<std::size_t>& open, std::vector<Symbol>& listed, ExplainedSection& section);
  void list_unknowns(const std::vector<Symbol>& listed);
  // The name of a direction of the statement along which, or against which (sign -1), a vector is; "" for another.
  std::pair<std::string, double> named_direction(const Vector3<double>& along) const;
  std::optional<std::string> law_in_letters(const std::vector<Symbol>& friction, const std::string& coefficient,
                                            const Symbol& push) const;
  void sticking_step(const std::vector<Symbol>& listed);
  // The laws of friction in joints and of cords on what they are led over, beside the forces that were found.
  void law_steps(const std::vector<Symbol>& listed);
  std::optional<ExplainedStep> law_of_joint(std::size_t contact, const std::vector<Symbol>& listed) const;
  std::optional<ExplainedStep> law_of_cord(std::size_t contact) const;
  std::string coefficient_in_tex(std::size_t contact) const;
  std::string tension_in_tex(int action) const;
  std::string words_of_bearing(std::size_t contact) const;
  std::vector<std::size_t> open_coordinates() const;
  std::vector<std::size_t> blocked_coordinates() const;
  bool leaves_plane(std::size_t k) const { return leads_across(k, everything_in_); }
  bool leads_across(std::size_t k, Plane plane) const;
  bool stays_at_rest(int body) const;

  bool sudden() const { return figures_.numbers.before.has_value(); }
  const Mechanism<double>& mechanism() const { return figures_.numbers.mechanism(); }
  ExplainedSection& section(const std::string& heading);

  const Situation& situation_;
  SolvedInstant& solved_;
  FormulaInstant* formula_instant_;
  const LetterValues& letters_;
  ExplanationTex tex_;  // which hides data until they are found
  const InstantQuestions& questions_;
  Explanation& explanation_;
  ExplainedFigures figures_;
  DataScope<double> data_;
  double part_of_length_ = 1;  // of what moves and is held, beside the length of the machine
  std::string suffix_;
  bool followed_ = false;  // whether velocities are those to which a motion has led
  bool later_ = false;     // whether it is a blow along a motion
  // What has been shown already, so that it is shown once.
  std::set<int> inertia_said_, mass_said_;
  std::map<int, ExplainedPoint> pivots_;  // the fixed points of bodies about which moments of inertia are told
  std::vector<Formula> conditions_;       // what rows without unknown forces say of the data
  std::set<std::string> motion_said_;
  // By what is said of them, the step that tells of bodies whose accelerations are unknown.
  struct OpenRates {
    std::size_t step = 0;
    std::vector<std::string> bodies;
  };
  std::map<std::string, OpenRates> open_rates_;
  bool any_said_ = false;
  Plane everything_in_{};         // the axis across which nothing moves
  bool forces_unknown_ = false;   // whether some unknown force acts on what has been cut free
  std::set<std::string> across_;  // unknowns across the planes of motions, of which nothing is said
  std::vector<Formula> factors_;  // that terms of a condition may share
};

}  // namespace poinsot::problem
