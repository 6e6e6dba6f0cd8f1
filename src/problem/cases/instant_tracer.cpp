#include "problem/cases/instant_tracer.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <stdexcept>
#include <utility>

#include "poinsot/engine/math/formula/formula_domain.h"
#include "poinsot/engine/math/trace/traced_derivative.h"
#include "poinsot/engine/math/trace/traced_formula.h"
#include "poinsot/engine/solve/linear/traced_elimination.h"
#include "problem/language/diagnostic.h"
#include "problem/unknowns/unknown_ranges.h"

namespace poinsot::problem {
namespace {

// The solution of an equation that is longer stands as a letter.
constexpr std::size_t short_terms = 40;
// Of the size of an equation's terms: how far it may be open.
constexpr double holding = 1e-9;
// Beside this a sum of terms that all vanish is positive.
constexpr double nothing = 1e-250;

Formula letter_of(const std::string& name) { return Formula::letter(name, poinsot::Sign::real); }

bool is_positive(const Letter& letter) { return !letter.either_sign && !(letter.unit.dimension == dimensions::angle); }

}  // namespace

InstantTracer::InstantTracer(const ProgramSample& sample)
    : sample_(sample), values_(sample.statement.situations.size(), sample.given) {
  add_data();
  add_unknowns();
  FormulaAnswers answers(sample.statement, values_, sample.numbers,
                         [this](const solve::LinearSystemOf<Formula>& system) { return solve(system); });
  if (!roots_.empty()) answers.solve_all();
  add_answers(answers);
  Outputs conditions;
  for (const Formula& remainder : answers.remainders()) add_equation(traced_one(remainder), conditions);
  parts_.push_back(std::move(conditions));
  add_ranges(answers);
  for (const Formula& sign : answers.signs_of_instants()) add_sign(sign);
  for (const OneSidedForce& force : answers.one_sided_forces()) {
    const Traced push = traced_one(force.value);
    refuse_open(push);
    add_positive(push);
  }
  for (const Traced& positive : trace_.assumed_positive()) add_positive(positive);
  if (equations_.size() < roots_.size()) throw std::domain_error("the equations leave an unknown open");
}

Traced InstantTracer::input(const std::string& name, double value) {
  const Traced number = trace_.input(value);
  if (!name.empty()) {
    letters_[name] = number;
    point_[name] = value;
  }
  ++inputs_;
  return number;
}

void InstantTracer::look_at_point() {
  decisions_.reset();
  decisions_.emplace(point_);
}

void InstantTracer::add_data() {
  for (const VariedDatum& datum : sample_.data) {
    input(datum.name, sample_.numbers.settings().front().at(datum.name).number);
    for (std::size_t i = 0; i < values_.size(); ++i) {
      const std::vector<Letter>& letters = sample_.statement.situations[i].letters;
      const auto letter = std::ranges::find(letters, datum.name, &Letter::name);
      values_[i][datum.name] = letter == letters.end()
                                   ? Value<Formula>::of_number(letter_of(datum.name), datum.dimension)
                                   : formula_of(*letter);
    }
  }
  for (const std::size_t one : sample_.by) by_.emplace_back(inputs_)[one] = Traced(1);
  look_at_point();
  for (const VariedDatum& datum : sample_.data)
    if (std::ranges::any_of(sample_.statement.situations, [&](const Situation& situation) {
          return std::ranges::any_of(situation.letters, [&](const Letter& letter) {
            return letter.name == datum.name && is_positive(letter);
          });
        }))
      add_positive(letters_.at(datum.name));
}

void InstantTracer::add_unknowns() {
  for (const Unknown& unknown : sample_.unknowns) {
    const bool common = is_common(sample_.statement, unknown.name);
    for (std::size_t i = 0; i < values_.size(); ++i)
      if (common ? i == 0 : is_own(sample_.statement, i, unknown.name)) add_unknown(unknown, i);
    for (std::size_t i = 1; common && i < values_.size(); ++i) values_[i][unknown.name] = values_[0][unknown.name];
  }
  for (std::size_t k = 0; k < roots_.size(); ++k) {
    roots_[k].rates.resize(inputs_);
    roots_[k].rates[roots_[k].input] = Traced(1);
  }
  look_at_point();
}

void InstantTracer::add_unknown(const Unknown& unknown, std::size_t situation) {
  const Value<double>& value = sample_.numbers.settings()[situation].at(unknown.name);
  // A name that nothing in a file has.
  const std::string name = unknown.name + " @ " + std::to_string(situation);
  if (!unknown.vector) {
    values_[situation][unknown.name] =
        Value<Formula>::of_number(add_root(name, unknown, value.number), unknown.unit.dimension);
    if (is_never_negative(sample_.statement, sample_.statement.situations[situation], unknown))
      add_positive(letters_.at(name));
    if (unknown.unit.dimension == dimensions::angle) add_positive(Traced(std::numbers::pi) - abs(letters_.at(name)));
    return;
  }
  Vector3<Formula> vector;
  for (std::size_t k = 0; k < 3; ++k) vector[k] = add_root(name + std::to_string(k), unknown, value.vector[k]);
  values_[situation][unknown.name] = Value<Formula>::of_vector(vector, unknown.unit.dimension);
}

Formula InstantTracer::add_root(const std::string& name, const Unknown& unknown, double value) {
  Root root{inputs_, value, std::fabs(value), {}};
  for (const auto& [home, instant] : sample_.numbers.instants())
    root.size = std::max(root.size, instant->natural_size(unknown.unit.dimension));
  if (!(root.size > 0)) throw std::domain_error("the size of '" + unknown.name + "' is not known");
  input(name, value);
  roots_.push_back(std::move(root));
  return letter_of(name);
}

Traced InstantTracer::traced_one(const Formula& formula) {
  const auto letter = [this](const std::string& name) {
    const auto known = letters_.find(name);
    if (known == letters_.end()) throw std::domain_error("'" + name + "' has no value");
    return known->second;
  };
  for (const Formula& one : assumed_not_negative(formula)) add_positive(traced(one, letter));
  return traced(formula, letter);
}

solve::ExactSolution InstantTracer::solve(const solve::LinearSystemOf<Formula>& system) {
  const std::size_t n = system.unknowns();
  const std::vector<std::vector<Formula>> coefficients = system.coefficients();
  std::vector<Formula> rest = system.right_sides();
  solve::ExactSolution solution{std::vector<Formula>(n), std::vector<bool>(n, false), {}};
  std::vector<bool> done(rest.size(), false);
  for (bool more = true; more;) {
    more = false;
    for (std::size_t i = 0; i < rest.size(); ++i) {
      std::size_t open = 0, last = n;
      for (std::size_t k = 0; k < n; ++k)
        if (!solution.determined[k] && !coefficients[i][k].is_zero()) ++open, last = k;
      if (done[i] || open != 1) continue;
      Formula value = rest[i] / coefficients[i][last];
      if (value.terms() > short_terms) continue;
      for (std::size_t j = 0; j < rest.size(); ++j)
        if (!coefficients[j][last].is_zero()) rest[j] -= coefficients[j][last] * value;
      solution.value[last] = std::move(value);
      solution.determined[last] = true;
      done[i] = more = true;
    }
  }
  std::vector<std::size_t> open;
  for (std::size_t k = 0; k < n; ++k)
    if (!solution.determined[k]) open.push_back(k);
  std::vector<solve::TracedEquation> equations;
  for (std::size_t i = 0; i < rest.size(); ++i) {
    if (done[i]) continue;
    solve::TracedEquation& equation = equations.emplace_back();
    equation.right_side = traced_one(rest[i]);
    for (std::size_t k = 0; k < open.size(); ++k)
      if (!coefficients[i][open[k]].is_zero()) equation.coefficients[k] = traced_one(coefficients[i][open[k]]);
  }
  std::set<std::size_t> left_open;
  const solve::TracedSolution found = solve::eliminated(std::move(equations), open.size(), [&](std::size_t k) {
    left_open.insert(k);
    solution.value[open[k]] = new_open();
    return traced_one(solution.value[open[k]]);
  });
  Outputs part;
  for (const Traced& sound : found.sound) positive_.push_back(extra(sound, part));
  for (const Traced& remainder : found.remainders) add_equation(remainder, part);
  for (std::size_t k = 0; k < open.size(); ++k) {
    if (left_open.contains(k)) continue;
    solution.value[open[k]] = new_letter(found.value[k], part);
    solution.determined[open[k]] = true;
  }
  if (!part.empty()) parts_.push_back(std::move(part));
  look_at_point();
  if (!open.empty()) hold(system, solution.value);
  return solution;
}

Formula InstantTracer::new_letter(const Traced& value, Outputs& part) {
  if (vanishes(value)) return {};
  const std::uint32_t place = inputs_;
  const std::string name = "solved " + std::to_string(place);
  part.push_back({value, place, true});
  input(name, plain(value));
  const auto follow = [&](std::vector<Traced>& rates) {
    const Traced rate = traced_derivative(trace_, {value}, rates).front();
    if (vanishes(rate)) return;
    part.push_back({rate, inputs_, true});
    const Traced letter = input("", plain(rate));
    rates.resize(inputs_);
    rates[place] = letter;
  };
  for (Root& root : roots_) follow(root.rates);
  for (std::vector<Traced>& rates : by_) follow(rates);
  for (std::vector<Traced>& rates : open_) {
    const Traced rate = traced_derivative(trace_, {value}, rates).front();
    rates.resize(inputs_);
    rates[place] = rate;
  }
  return letter_of(name);
}

Formula InstantTracer::new_open() {
  const std::string name = "open " + std::to_string(inputs_);
  const std::uint32_t place = inputs_;
  input(name, 0);
  open_.emplace_back(inputs_)[place] = Traced(1);
  look_at_point();
  return letter_of(name);
}

void InstantTracer::refuse_open(const Traced& number) const {
  for (const std::vector<Traced>& rates : open_)
    if (!vanishes(traced_derivative(trace_, {number}, rates).front())) throw NoFormula("something is left open");
}

std::uint32_t InstantTracer::extra(const Traced& number, Outputs& part) {
  part.push_back({number, extras_, false});
  return extras_++;
}

void InstantTracer::add_equation(const Traced& remainder, Outputs& part) {
  if (vanishes(remainder)) return;
  refuse_open(remainder);
  Equation equation{extra(remainder, part), {}, {}, 0};
  double largest = 0;
  for (const Root& root : roots_) {
    const Traced slope = traced_derivative(trace_, {remainder}, root.rates).front();
    largest = std::max(largest, std::fabs(plain(slope)) * root.size);
    equation.slopes.push_back(extra(slope, part));
  }
  if (!(largest > 0)) throw std::domain_error("what is stated holds for these values alone");
  for (const std::vector<Traced>& rates : by_)
    equation.by.push_back(extra(traced_derivative(trace_, {remainder}, rates).front(), part));
  equation.weight = 1 / largest;
  equations_.push_back(std::move(equation));
}

void InstantTracer::add_positive(const Traced& number) {
  if (is_constant(number) && !(plain(number) < 0)) return;
  if (!(plain(number) > 0)) throw std::domain_error("a condition is at its border");
  positive_.push_back(extra(number, last_));
}

void InstantTracer::add_sign(const Formula& sign) {
  const Traced number = traced_one(sign);
  if (!is_constant(number)) add_positive(plain(number) < 0 ? -number : number);
}

// What was solved must meet the equations that it was solved from, and those that were left over.
void InstantTracer::hold(const solve::LinearSystemOf<Formula>& system, const std::vector<Formula>& values) {
  const std::vector<std::vector<Formula>> coefficients = system.coefficients();
  const std::vector<Formula> right_sides = system.right_sides();
  for (std::size_t i = 0; i < right_sides.size(); ++i) {
    Traced misfit = -traced_one(right_sides[i]);
    Traced size = abs(misfit);
    for (std::size_t k = 0; k < values.size(); ++k) {
      if (coefficients[i][k].is_zero() || values[k].is_zero()) continue;
      const Traced term = traced_one(coefficients[i][k]) * traced_one(values[k]);
      misfit += term;
      size += abs(term);
    }
    if (!vanishes(misfit)) add_positive(Traced(holding) * size - abs(misfit) + Traced(nothing));
  }
}

void InstantTracer::add_ranges(FormulaAnswers& answers) {
  const auto side = [&](std::size_t situation, const Expression& expression) {
    const DecidedFormula found = answers.at_start(situation, expression);
    for (const Formula& sign : found.signs) add_sign(sign);
    if (!found.value.is_number()) throw NoFormula("a condition compares what are no numbers");
    return traced_one(found.value.number);
  };
  for (std::size_t i = 0; i < values_.size(); ++i)
    for (const Expression& condition : sample_.statement.situations[i].where) {
      const Comparison* comparison = condition.as<Comparison>();
      if (!comparison) throw NoFormula("a condition is no comparison");
      for (std::size_t k = 0; k < comparison->relations.size(); ++k) {
        const Relation relation = comparison->relations[k];
        const Traced rise = side(i, comparison->operands[k + 1]) - side(i, comparison->operands[k]);
        if (relation == Relation::less || relation == Relation::less_equal)
          add_positive(rise);
        else if (relation == Relation::greater || relation == Relation::greater_equal)
          add_positive(-rise);
        else
          throw NoFormula("a condition is no inequality");
      }
    }
}

void InstantTracer::add_answers(FormulaAnswers& answers) {
  std::vector<Traced> results;
  for (const Ask& ask : sample_.statement.asks) {
    const DecidedFormula found = answers.value(ask);
    for (const Formula& sign : found.signs) add_sign(sign);
    std::vector<Formula> numbers;
    if (found.value.is_number()) numbers = {found.value.number};
    if (found.value.is_vector()) numbers = {found.value.vector[0], found.value.vector[1], found.value.vector[2]};
    if (numbers.empty()) throw NoFormula("an answer is no number and no vector");
    for (const Formula& number : numbers) {
      const Traced result = traced_one(number);
      refuse_open(result);
      results_.push_back(extra(result, last_));
      results.push_back(result);
    }
  }
  if (!by_.empty()) add_derivatives(results);
}

void InstantTracer::add_derivatives(const std::vector<Traced>& results) {
  for (const std::vector<Traced>& rates : by_)
    for (const Traced& derivative : traced_derivative(trace_, results, rates))
      results_.push_back(extra(derivative, last_));
  if (roots_.empty()) return;
  slopes_.resize(results.size());
  for (const Root& root : roots_) {
    const std::vector<Traced> slopes = traced_derivative(trace_, results, root.rates);
    for (std::size_t i = 0; i < slopes.size(); ++i) slopes_[i].push_back(extra(slopes[i], last_));
  }
}

InstantProgram InstantTracer::program() const {
  InstantProgram made;
  made.slots_ = inputs_ + extras_;
  const auto add = [&](const Outputs& outputs) {
    std::vector<Traced> numbers;
    std::vector<InstantProgram::Slot> slots;
    for (const Output& output : outputs) {
      numbers.push_back(output.number);
      slots.push_back(output.is_input ? output.index : inputs_ + output.index);
    }
    made.parts_.push_back({ColumnProgram(StraightLine(trace_, numbers, StraightLine::Shortening::quick)), slots});
  };
  for (const Outputs& part : parts_)
    if (!part.empty()) add(part);
  add(last_);
  for (const Root& root : roots_) made.roots_.push_back({root.input, root.start, root.size});
  for (const Equation& equation : equations_) {
    InstantProgram::Equation& one = made.equations_.emplace_back();
    one = {inputs_ + equation.value, {}, {}, equation.weight};
    for (const std::uint32_t slope : equation.slopes) one.slopes.push_back(inputs_ + slope);
    for (const std::uint32_t slope : equation.by) one.by.push_back(inputs_ + slope);
  }
  for (const std::uint32_t one : positive_) made.positive_.push_back(inputs_ + one);
  for (const std::uint32_t one : results_) made.results_.push_back(inputs_ + one);
  for (const std::vector<std::uint32_t>& slopes : slopes_) {
    made.slopes_.emplace_back();
    for (const std::uint32_t slope : slopes) made.slopes_.back().push_back(inputs_ + slope);
  }
  return made;
}

std::optional<InstantProgram> InstantProgram::made(const ProgramSample& sample, std::string& reason) {
  const FormulaLimitScope limits({most_formula_terms, most_formula_work});
  try {
    return InstantTracer(sample).program();
  } catch (const std::domain_error& error) {
    reason = error.what();
  } catch (const NoFormula& error) {
    reason = error.what();
  } catch (const FormulaTooLarge& error) {
    reason = error.what();
  } catch (const StatementError& error) {
    reason = error.diagnostics().front().message;
  }
  return std::nullopt;
}

}  // namespace poinsot::problem
