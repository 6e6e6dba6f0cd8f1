#include "problem/cases/case_formulas.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <utility>

#include "poinsot/engine/math/trace/traced_formula.h"
#include "problem/cases/traced_expression.h"

namespace poinsot::problem {
namespace {

// The formulas of an ask, number by number; nothing if it has none.
std::optional<std::vector<Formula>> formulas_of(const SolvedAsk& ask) {
  if (!ask.formula) return std::nullopt;
  if (ask.formula->is_number()) return std::vector{ask.formula->number};
  if (ask.formula->is_vector())
    return std::vector{ask.formula->vector[0], ask.formula->vector[1], ask.formula->vector[2]};
  return std::nullopt;
}

// "m > g for 'a', 'b'" without the answers that it concerns: it is asked of all.
std::string without_names(const std::string& words) { return words.substr(0, words.find(" for '")); }

class FormulaTracer {
 public:
  FormulaTracer(const SolvedStatement& solved, const std::vector<VariedDatum>& data) : solved_(solved) {
    if (solved.solutions.size() != 1)
      throw std::domain_error(fmt::format("there are {} solutions", solved.solutions.size()));
    const TraceScope scope(trace_);
    // Decisions of the trace, as the root of x^2, look at these numbers; they are the same as those of formulas.
    for (const VariedDatum& datum : data) inputs_[datum.name] = trace_.input(sample_of(datum));
    add_answers(solved.solutions.front());
    results_ = outputs_.size();
    add_conditions(solved.solutions.front());
    for (const VariedDatum& datum : data)
      if (is_positive_letter(datum)) outputs_.push_back(inputs_.at(datum.name));
    for (const Traced& positive : trace_.assumed_positive()) outputs_.push_back(positive);
  }

  ColumnProgram program() const { return ColumnProgram(StraightLine(trace_, outputs_)); }
  std::size_t conditions() const { return outputs_.size() - results_; }

 private:
  bool is_positive_letter(const VariedDatum& datum) const {
    return std::ranges::any_of(solved_.open_letters, [&](const Letter& letter) {
      return letter.name == datum.name && !letter.either_sign && !(letter.unit.dimension == dimensions::angle);
    });
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
    for (const SolvedAsk& ask : solution.asks) {
      if (const std::optional<std::vector<Formula>> formulas = formulas_of(ask)) {
        for (const Formula& formula : *formulas) outputs_.push_back(traced_one(formula));
      } else if (ask.state == AskState::found && ask.value.is_number()) {
        outputs_.emplace_back(ask.value.number);
      } else if (ask.state == AskState::found && ask.value.is_vector()) {
        for (std::size_t k = 0; k < 3; ++k) outputs_.emplace_back(ask.value.vector[k]);
      } else {
        throw std::domain_error(!ask.no_formula.empty() ? ask.no_formula
                                : !ask.reason.empty()   ? ask.reason
                                                        : "an answer is no number and no vector");
      }
    }
  }
  void add_conditions(const Solution& solution) {
    const auto letter = [this](const std::string& name) {
      const auto known = inputs_.find(name);
      return known == inputs_.end() ? std::nullopt : std::optional(known->second);
    };
    for (const std::string& words : solution.assumptions) {
      const auto force = std::ranges::find(solution.conditions, words, &FormulaCondition::words);
      if (force != solution.conditions.end()) {
        outputs_.push_back(traced_one(force->positive));
        continue;
      }
      const std::optional<Traced> condition = traced_condition(without_names(words), letter);
      if (!condition) throw std::domain_error("they hold where " + words + ", which is not known as a formula");
      outputs_.push_back(*condition);
    }
  }

  const SolvedStatement& solved_;
  Trace trace_;
  std::map<std::string, Traced> inputs_;
  std::vector<Traced> outputs_;
  std::size_t results_ = 0;
};

}  // namespace

std::optional<CaseFormulas> CaseFormulas::made(const SolvedStatement& solved, const std::vector<VariedDatum>& data,
                                               std::string& reason) {
  try {
    const FormulaTracer tracer(solved, data);
    return CaseFormulas(tracer.program(), tracer.conditions());
  } catch (const std::domain_error& error) {
    reason = error.what();
  } catch (const FormulaTooLarge& error) {
    reason = error.what();
  }
  return std::nullopt;
}

std::vector<char> CaseFormulas::evaluate(std::span<const double* const> data, std::size_t rows,
                                         std::span<double* const> results) const {
  std::vector<double> positive(conditions_ * rows);
  std::vector<double*> outputs(results.begin(), results.end());
  for (std::size_t k = 0; k < conditions_; ++k) outputs.push_back(positive.data() + k * rows);
  program_.evaluate(data, rows, outputs);
  std::vector<char> valid(rows, 1);
  for (std::size_t k = 0; k < outputs.size(); ++k) {
    const double* const column = outputs[k];
    if (k < results.size())
      for (std::size_t row = 0; row < rows; ++row)
        valid[row] = static_cast<char>(valid[row] & std::isfinite(column[row]));
    else
      for (std::size_t row = 0; row < rows; ++row) valid[row] = static_cast<char>(valid[row] & (column[row] > 0));
  }
  return valid;
}

}  // namespace poinsot::problem
