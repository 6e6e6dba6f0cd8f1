// The bodies of a motion in formulas whose letters are the data, the coordinates and their rates: what holds at every
// time of the motion is said with these.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "problem/explanation/explanation_tex.h"
#include "problem/formulas/formula_instant.h"

namespace poinsot::problem {

class GeneralMotion {
 public:
  // situation: the one that moves, with its data as letters, of which `values` gives the formulas; settings, now: the
  // numbers of a time of the motion; letters: the values of the letters of the data. Nothing if it has no formulas.
  static std::unique_ptr<GeneralMotion> of(const Situation& situation, const FormulaValues& values,
                                           const Settings& settings, const MotionState& now, LetterValues letters);

  const FormulaInstant& formulas() const { return *formulas_; }
  FormulaInstant& formulas() { return *formulas_; }
  SolvedInstant& numbers() { return *numbers_; }
  const Situation& situation() const { return situation_; }
  // The coordinates, if the statement names all of them; else none.
  std::vector<std::string> named_coordinates() const;
  const solve::MechanismStateOf<Formula>& state() const { return formulas_->mechanism_state(); }
  // The letter of the rate of a coordinate.
  static std::string rate_letter(const std::string& coordinate) { return coordinate + "'"; }
  // Values for all letters at a time of the motion; nothing where the coordinates have none.
  std::optional<LetterValues> letters_at(const MotionState& now) const;
  // A formula of the data, the coordinates and their rates at the start, in the data alone: with what the instants
  // state of it, and zero for what is as drawn. Nothing where a coordinate is otherwise there. Throws StatementError.
  std::optional<Formula> at_start(const Formula& formula, const MotionState& start,
                                  const std::vector<const Instant*>& stated) const;
  // The values of letters in the units that are shown.
  LetterValues in_shown_units(const LetterValues& letters, const ExplanationTex& tex) const;
  // Whether a formula has letters of coordinates that the statement names, and of no other.
  bool is_named(const Formula& formula) const;
  // Whether it is the letter of a named coordinate or of its rate, and what dimension such a letter has.
  bool is_of_motion(const std::string& letter) const;
  Dimension dimension_of(const std::string& letter) const;

 private:
  GeneralMotion() = default;
  // Null if the letter is of no named coordinate.
  const NamedCoordinate* coordinate_of(const std::string& letter) const;

  Situation situation_;
  Settings settings_;
  LetterValues letters_;                           // of the data
  std::map<std::string, Dimension> dimensions_{};  // of these
  std::unique_ptr<SolvedInstant> numbers_;
  std::unique_ptr<FormulaInstant> formulas_;
  OpenLetters open_;
};

}  // namespace poinsot::problem
