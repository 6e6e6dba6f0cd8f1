// Makes an InstantProgram.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "poinsot/engine/math/trace/traced.h"
#include "problem/cases/instant_program.h"
#include "problem/formulas/formula_answers.h"

namespace poinsot::problem {

class InstantTracer {
 public:
  // Throws std::domain_error, NoFormula, StatementError or FormulaTooLarge if it cannot be made.
  explicit InstantTracer(const ProgramSample& sample);

  InstantProgram program() const;

 private:
  // A number that a program tells, and where it goes: to an input of the trace, or to a slot after all of these.
  struct Output {
    Traced number;
    std::uint32_t index = 0;
    bool is_input = false;
  };
  using Outputs = std::vector<Output>;
  struct Root {
    std::uint32_t input = 0;
    double start = 0, size = 1;
    std::vector<Traced> rates;  // of the inputs of the trace, if this unknown changes at the rate one
  };
  struct Equation {
    std::uint32_t value = 0;
    std::vector<std::uint32_t> slopes, by;
    double weight = 1;
  };

  Traced input(const std::string& name, double value);
  void look_at_point();
  void add_data();
  void add_unknowns();
  void add_unknown(const Unknown& unknown, std::size_t situation);
  Formula add_root(const std::string& name, const Unknown& unknown, double value);
  Formula new_open();
  Traced traced_one(const Formula& formula);
  // Solves equations as far as their solution is short; the rest is recorded, and its solution stands as letters.
  solve::ExactSolution solve(const solve::LinearSystemOf<Formula>& system);
  Formula new_letter(const Traced& value, Outputs& part);
  std::uint32_t extra(const Traced& number, Outputs& part);
  void add_equation(const Traced& remainder, Outputs& part);
  void refuse_open(const Traced& number) const;
  void add_positive(const Traced& number);
  void add_sign(const Formula& sign);
  void add_ranges(FormulaAnswers& answers);
  void add_answers(FormulaAnswers& answers);
  void add_derivatives(const std::vector<Traced>& results);
  void hold(const solve::LinearSystemOf<Formula>& system, const std::vector<Formula>& values);

  const ProgramSample& sample_;
  Trace trace_;
  TraceScope recording_{trace_};
  LetterValues point_;
  std::optional<PlainPointScope> decisions_;
  std::map<std::string, Traced> letters_;
  std::vector<FormulaValues> values_;  // of each situation
  std::vector<Root> roots_;
  // Of each datum that answers are differentiated by: the rates of the inputs of the trace, if it changes at the rate
  // one and the unknowns stay.
  std::vector<std::vector<Traced>> by_;
  // Of what is left open: the rates of the inputs of the trace, if this changes at the rate one. Such numbers are zero.
  std::vector<std::vector<Traced>> open_;
  std::vector<Equation> equations_;
  std::vector<Outputs> parts_;
  Outputs last_;  // of the last part
  std::vector<std::uint32_t> positive_, results_;
  std::vector<std::vector<std::uint32_t>> slopes_;
  std::uint32_t inputs_ = 0, extras_ = 0;
};

}  // namespace poinsot::problem
