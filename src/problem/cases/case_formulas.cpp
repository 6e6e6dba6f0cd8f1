#include "problem/cases/case_formulas.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <stdexcept>
#include <utility>

#include "poinsot/engine/math/formula/formula_domain.h"
#include "poinsot/engine/math/trace/traced_derivative.h"
#include "poinsot/engine/math/trace/traced_formula.h"

namespace poinsot::problem {
namespace {

class FormulaTracer {
 public:
  FormulaTracer(const SolvedStatement& solved, const std::vector<VariedDatum>& data, const std::vector<std::size_t>& by)
      : solved_(solved) {
    if (solved.solutions.size() != 1)
      throw std::domain_error(fmt::format("there are {} solutions", solved.solutions.size()));
    const TraceScope scope(trace_);
    // Decisions of the trace, as the root of x^2, look at these numbers; they are the same as those of formulas.
    for (const VariedDatum& datum : data) inputs_[datum.name] = trace_.input(sample_of(datum));
    add_answers(solved.solutions.front());
    add_derivatives(data.size(), by);
    add_conditions(solved.solutions.front());
    for (const VariedDatum& datum : data)
      if (is_positive_letter(datum)) outputs_.push_back(inputs_.at(datum.name));
    for (const Traced& positive : trace_.assumed_positive()) outputs_.push_back(positive);
  }

  ColumnProgram program() const { return ColumnProgram(StraightLine(trace_, outputs_)); }

 private:
  bool is_positive_letter(const VariedDatum& datum) const {
    return std::ranges::any_of(solved_.open_letters,
                               [&](const Letter& letter) { return letter.name == datum.name && is_positive(letter); });
  }
  static bool is_positive(const Letter& letter) {
    return !letter.either_sign && !(letter.unit.dimension == dimensions::angle);
  }
  double sample_of(const VariedDatum& datum) const {
    return plain(Formula::letter(datum.name, is_positive_letter(datum) ? Sign::positive : Sign::real));
  }

  Traced traced_one(const Formula& formula) const {
    return traced(formula, [this](const std::string& name) {
      const auto known = inputs_.find(name);
      if (known == inputs_.end()) throw std::domain_error("'" + name + "' has no value");
      return known->second;
    });
  }
  void add_answers(const Solution& solution) {
    // What was found by trials holds where it was tried, and to the digits of its numbers.
    const auto tried = [](const auto& one) { return !one.formula_road.empty(); };
    if (std::ranges::any_of(solution.unknowns, tried) || std::ranges::any_of(solution.asks, tried))
      throw std::domain_error("some were found by trials, and not derived");
    for (const SolvedAsk& ask : solution.asks) {
      if (!ask.regimes.empty()) throw std::domain_error("there are several, each for a part of the values");
      if (const auto formulas = ask.formula ? numbers_in(*ask.formula) : std::vector<Formula>(); !formulas.empty()) {
        for (const Formula& formula : formulas) outputs_.push_back(traced_one(formula));
      } else if (const auto numbers = numbers_in(ask.value); ask.state == AskState::found && !numbers.empty()) {
        for (const double number : numbers) outputs_.emplace_back(number);
      } else {
        throw std::domain_error(!ask.no_formula.empty() ? ask.no_formula
                                : !ask.reason.empty()   ? ask.reason
                                                        : "an answer is no number, no vector and no list of numbers");
      }
    }
  }
  void add_derivatives(std::size_t inputs, const std::vector<std::size_t>& by) {
    const std::vector<Traced> answers = outputs_;
    for (const std::size_t one : by) {
      std::vector<Traced> rates(inputs);
      rates[one] = Traced(1);
      for (const Traced& derivative : traced_derivative(trace_, answers, rates)) outputs_.push_back(derivative);
    }
  }
  // What must be positive. An assumption that is none of these is known in words alone.
  void add_conditions(const Solution& solution) {
    for (const Letter& letter : solved_.open_letters)
      if (is_positive(letter)) told_.insert(letter.name + " > 0");
    for (const auto* conditions : {&solution.conditions, &solution.grounds})
      for (const FormulaCondition& condition : *conditions) {
        told_.insert(condition.words);
        outputs_.push_back(traced_one(condition.positive));
      }
    for (const SolvedAsk& ask : solution.asks)
      if (ask.formula) add_assumed(*ask.formula);
    for (const SolvedUnknown& unknown : solution.unknowns)
      if (unknown.formula) add_assumed(*unknown.formula);
    for (const std::string& words : solution.assumptions)
      if (!told_.contains(words))
        throw std::domain_error("they hold where " + words + ", of which there is no formula");
  }
  void add_assumed(const Value<Formula>& value) {
    for (const Formula& formula : numbers_in(value)) {
      for (const std::string& words : formula.assumptions()) told_.insert(words);
      for (const Formula& one : assumed_not_negative(formula)) outputs_.push_back(traced_one(one));
    }
  }

  const SolvedStatement& solved_;
  Trace trace_;
  std::map<std::string, Traced> inputs_;
  std::vector<Traced> outputs_;
  std::set<std::string> told_;  // the words of what is among the conditions
};

}  // namespace

std::optional<CaseFormulas> CaseFormulas::made(const SolvedStatement& solved, const std::vector<VariedDatum>& data,
                                               const std::vector<std::size_t>& by, std::string& reason) {
  try {
    const FormulaTracer tracer(solved, data, by);
    return CaseFormulas(tracer.program());
  } catch (const std::domain_error& error) {
    reason = error.what();
  } catch (const FormulaTooLarge& error) {
    reason = error.what();
  }
  return std::nullopt;
}

std::vector<char> CaseFormulas::evaluate(std::span<const double* const> data, std::size_t rows,
                                         std::span<double* const> results) const {
  return program_.evaluate_where_valid(data, rows, results);
}

}  // namespace poinsot::problem
