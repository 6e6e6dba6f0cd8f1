// One statement for many cases that differ in the values of some data. What is the same for all cases is done once:
// reading, which data matter, and, where there are formulas, solving.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "problem/cases/case_formulas.h"
#include "problem/cases/instant_program.h"
#include "problem/cases/varied_data.h"
#include "problem/results/solution.h"
#include "problem/unknowns/sample.h"

namespace poinsot::problem {

// One number of the answers: "T", or "A.x" of a vector.
struct CaseColumn {
  std::string name;
  std::string unit;  // the coherent SI unit
};

// How the answers of a case were found.
enum class CaseRoad : std::uint8_t { in_full, by_instant, by_formula };

// Derivatives by differences, and how far they may be wrong.
struct Differences {
  std::vector<double> value, doubt;
};

struct SolvedCases {
  std::vector<std::vector<double>> columns;                  // in SI units; NaN where a case has no answer
  std::vector<CaseRoad> roads;                               // of each case
  std::vector<std::pair<std::size_t, std::string>> reasons;  // of cases in which an answer is missing, ascending
  std::size_t checked = 0;  // cases by formula or instant that were solved in full as well
  std::size_t refuted = 0;  // those among them where that gave something else
};

// What is asked about cases.
struct CasesAsked {
  std::vector<std::string> over;                          // the data that differ from case to case
  std::vector<std::string> asks;                          // the names of the questions, all if there are none
  std::vector<std::pair<std::string, std::string>> sets;  // settings that are the same for all cases
  std::vector<double> first;  // the values of the data in some case: shows the shape of answers where letters do not
  bool with_formulas = true;
  std::vector<std::string> sensitivities;  // those of `over` by which the answers are differentiated
  std::vector<double> usual{};             // how large the data usually are; by default as in `first`
};

class CompiledCases {
 public:
  // Throws StatementError if the file, a name or a setting is wrong, or a question has neither numbers nor vectors for
  // an answer, and std::invalid_argument if the parts of what is asked do not fit each other.
  CompiledCases(const Statement& statement, CasesAsked asked);

  const std::vector<VariedDatum>& data() const { return data_; }
  const std::vector<CaseColumn>& columns() const { return columns_; }
  bool has_formulas() const { return formulas_.has_value(); }
  // Why there are no formulas; else "".
  const std::string& no_formulas() const { return no_formulas_; }
  // Whether cases without formulas go by their instants.
  bool by_instants() const { return by_instants_ || program_; }
  // Why instants are not put as programs; else "".
  const std::string& no_program() const { return no_program_; }

  // data: a column for each datum. first: the number of the first case in the study: every thousandth case is compared
  // with a full solution, and where they differ, all of these cases are solved in full.
  SolvedCases solved(const std::vector<std::span<const double>>& data, std::uint64_t first) const;

 private:
  using Columns = std::vector<std::span<const double>>;
  // Whether a full solution is what is told of a case, or is held against what was found on another road.
  enum class Purpose : std::uint8_t { told, compared };
  SolvedStatement solved_in_full(const Columns& data, std::size_t row, Purpose purpose) const;
  // Writes the numbers of the answers in one case, NaN without answer; returns why one is missing, or "".
  std::string solve_row(const Columns& data, std::size_t row, Purpose purpose, std::vector<double>& numbers) const;
  // By a program that takes columns of data and room for results, and tells which cases it answers.
  template <class Program>
  static void go_by(const Program& program, CaseRoad road, const Columns& data, SolvedCases& found);
  // Takes back the answers of cases in which there can be no such machine.
  void leave_out_what_cannot_exist(const Columns& data, SolvedCases& found) const;
  bool exists(const std::vector<double>& values) const;
  void find_roots();
  void go_by_instants(const Columns& data, SolvedCases& found) const;
  void solve_the_rest(const Columns& data, SolvedCases& found) const;
  // Adds the derivatives of answers where no program has them.
  void add_differences(const Columns& data, SolvedCases& found) const;
  // The derivatives of the answers of a case by a datum, by differences of solutions beside it; returns why there are
  // none, or "". here: the answers of the case.
  std::string differences(const Columns& data, std::size_t row, std::size_t datum, const std::vector<double>& here,
                          Differences& found) const;
  // The answers of one case; returns why one is missing, or "".
  std::string answers_at(const std::vector<double>& data, std::vector<double>& numbers) const;
  bool derivatives_differ(const Columns& data, std::size_t row, const SolvedCases& found) const;
  // Compares every thousandth case with a full solution.
  void check(const Columns& data, std::uint64_t first, SolvedCases& found) const;
  // quickly: whether the cheaper of two ways is tried first; and whether it was enough.
  bool is_refuted(const Columns& data, std::size_t row, const SolvedCases& found, bool& quickly) const;
  // Whether numbers found on another road are those of a case.
  bool agree(const std::vector<double>& numbers, std::size_t row, const SolvedCases& found) const;
  void find_places(const std::vector<std::string>& sensitivities);
  void find_formulas();
  void make_program();
  void take_shape(const Solution& solution);
  [[noreturn]] void refuse_shapeless(const Solution& first) const;
  bool no_letters_left() const;
  Settings settings_in(const Columns& data, std::size_t row) const;
  AllSettings settings_at(const Columns& data, std::size_t row) const;  // for each situation

  Statement statement_;
  std::vector<std::pair<std::string, std::string>> sets_;
  std::vector<VariedDatum> data_;
  std::vector<double> first_;    // their values in some case
  std::vector<double> usual_;    // how large they usually are
  std::vector<std::size_t> by_;  // the places of those by which answers are differentiated
  // The answers, and then their derivatives, all by the first datum before those by the next.
  std::vector<CaseColumn> columns_;
  std::size_t answers_ = 0;       // how many of the columns are answers
  Settings settings_;             // those of sets_
  bool all_have_values_ = false;  // whether no letter is left open, nor the state of what rubs
  bool by_instants_ = false;
  std::vector<std::size_t> sizes_;  // how many numbers the answer to each question has
  std::optional<CaseFormulas> formulas_;
  std::string no_formulas_;
  std::optional<InstantProgram> program_;  // where there are no formulas
  std::string no_program_;
  AllSettings roots_;              // the values of unknowns in the first case, for each situation
  bool existence_is_told_ = true;  // whether with these the machine of the first case exists
  // The last least and largest values of the data between which all machines exist.
  mutable std::mutex known_box_mutex_;
  mutable std::pair<std::vector<double>, std::vector<double>> known_box_;
};

}  // namespace poinsot::problem
