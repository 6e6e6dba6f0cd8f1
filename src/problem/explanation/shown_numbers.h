// The numbers that a worked solution or a picture shows: those of one solution, and drawn ones for letters without
// value.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "problem/explanation/explanation_questions.h"
#include "problem/formulas/formula_instant.h"
#include "problem/results/solution.h"
#include "problem/unknowns/sample.h"

namespace poinsot::problem {

// How the values of letters are drawn.
enum class LetterSizes {
  usual,  // about the unit, as trials are
  alike,  // those of the file's own example, else near the unit, so that a figure has the proportions that a reader
          // expects; later more freely
};

class ShownNumbers {
 public:
  // The arguments must outlive the object.
  ShownNumbers(const Statement& statement, const std::vector<std::pair<std::string, std::string>>& sets,
               const SolvedStatement& solved, std::size_t solution, LetterSizes sizes = LetterSizes::usual);

  // Takes the unknowns found, and draws open letters until everything can be solved. Returns whether it can.
  bool choose();

  // As they are set, and after choose() with values for unknowns and letters.
  const AllSettings& settings() const { return settings_; }
  // Situations that are shown at a limit, with the ask for that limit.
  const std::map<std::size_t, std::size_t>& limits() const { return limits_; }
  // The letters that have no value, in a situation.
  std::vector<std::string> open_letters(std::optional<std::size_t> situation = std::nullopt) const;
  // The values drawn for them, in SI units.
  const std::map<std::string, double>& drawn() const { return drawn_; }

  // Data that are single numbers, letters, unknowns and standard gravity as letters, after choose(); `lettered` gets
  // what it lacks for them, `point` their values.
  FormulaValues formula_values(std::size_t situation, Situation& lettered, LetterValues& point) const;

  // After choose().
  bool has_sample() const { return sample_ != nullptr; }
  Sample& sample() const { return *sample_; }
  const StatementQuestions& questions() const { return questions_; }

 private:
  const Situation& situation(std::size_t situation) const { return statement_.situations[situation]; }
  void find_limits();
  bool choose_numbers();
  std::map<std::string, double> drawn_values(int attempt) const;
  bool set_limits();
  bool set_unknowns(const std::map<std::string, double>& letters);
  bool wants_forces(const Sample::Home& home, const InstantQuestions& questions) const;

  const Statement& statement_;
  const SolvedStatement& solved_;
  const Solution& solution_;
  LetterSizes sizes_;
  AllSettings stated_, settings_;
  std::map<std::string, double> drawn_;
  std::map<std::size_t, std::size_t> limits_;
  std::unique_ptr<Sample> sample_;
  StatementQuestions questions_;
};

// A mass that may be any has a letter in formulas, so that it is seen to cancel; it has the number that instants take
// for it. Returns these letters.
std::vector<std::string> letters_of_any_masses(Situation& lettered, FormulaValues& values, LetterValues& point);

}  // namespace poinsot::problem
