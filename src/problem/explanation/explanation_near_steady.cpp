#include "problem/explanation/explanation_near_steady.h"

#include <algorithm>
#include <cmath>
#include <complex>

#include "poinsot/engine/work/work.h"
#include "problem/explanation/shared_factors.h"
#include "problem/language/evaluate_support.h"
#include "problem/language/expression_walk.h"
#include "problem/language/words.h"
#include "problem/near/near_steady_formulas.h"

namespace poinsot::problem {
namespace {

constexpr std::size_t most_freedoms = 4;    // of which the equations are shown
constexpr std::size_t readable_line = 240;  // of TeX
// For the characteristic polynomial, of which more would not be read.
constexpr std::size_t readable_terms_near = 600;
constexpr Work readable_work_near = 300'000'000;
// Of the terms of the characteristic polynomial: what its coefficients and the rates, found on two roads, leave where a
// rate is put in.
constexpr double same_rates = 1e-7;
// The same at a limit, which was closed in to nine digits.
constexpr double vanishes_at_limit = 1e-6;

class NearSteadySteps {
 public:
  NearSteadySteps(const NearSteady& near, const ExplanationTex& tex)
      : near_(near), tex_(tex), rates_(near.numbers.linearisation({})) {}

  std::vector<ExplainedStep> steps() {
    try {
      const FormulaLimitScope limits({readable_terms_near, readable_work_near});
      add_formulas();
    } catch (const std::domain_error&) {
      steps_.clear();
    } catch (const FormulaTooLarge&) {
      steps_.clear();
    } catch (const std::invalid_argument&) {
      steps_.clear();
    } catch (const NoFormula&) {
      steps_.clear();
    } catch (const StatementError&) {
      steps_.clear();  // of forces that are not determined
    }
    add_rates();
    add_responses();
    return std::move(steps_);
  }

 private:
  double value(const Formula& x) const { return x.is_zero() ? 0 : value_at(x, near_.letters); }

  void add_formulas() {
    if (!near_.formulas || rides()) return;
    FormulaInstant& formulas = *near_.formulas;
    SteadyFormulas motion = steady_formulas(near_.situation, formulas.machine(), formulas.positions(),
                                            formulas.velocities(), near_.numbers.machine());
    std::vector<std::size_t> free = free_coordinates(motion);
    if (free.empty() || free.size() > most_freedoms) return;
    const bool held = !formulas.machine().mechanism.constraints.empty();
    std::optional<LinearisedFormulas> found;
    if (held) {
      formulas.solve_forces();
      const auto first = formulas.unknowns().begin() + static_cast<std::ptrdiff_t>(motion.v.size());
      motion.components.assign(first,
                               first + static_cast<std::ptrdiff_t>(formulas.machine().mechanism.components.size()));
      found = linearised_with_constraints(motion, free);
    } else {
      found = linearised(motion, free);
    }
    if (!found) return;
    LinearisedFormulas& equations = *found;
    if (!held) leave_out_idle(equations, free);
    if (free.empty()) return;
    std::vector<Formula> all;
    for (const FormulaMatrix* matrix : {&equations.M, &equations.C, &equations.K, &equations.W})
      for (const auto& row : *matrix) all.insert(all.end(), row.begin(), row.end());
    const std::vector<Formula> reduced = without_shared_factors(all, near_.factors).rest;
    auto next = reduced.begin();
    for (FormulaMatrix* matrix : {&equations.M, &equations.C, &equations.K, &equations.W})
      for (auto& row : *matrix)
        for (Formula& entry : row) entry = *next++;
    polynomial_ = without_shared_factors(characteristic_polynomial(equations), near_.factors).rest;
    while (!polynomial_.empty() && polynomial_.front().is_zero()) polynomial_.erase(polynomial_.begin());
    if (polynomial_.size() < 2 || !has_these_rates() || !fits_units()) return;
    if (free.size() == 1 && !held)
      add_one(equations, free.front());
    else
      add_matrices(equations, free);
    add_limit();
  }

  // A coordinate that nothing pulls back and that moves no other, as a spin that keeps its rate, is not looked at.
  static void leave_out_idle(LinearisedFormulas& equations, std::vector<std::size_t>& free) {
    for (std::size_t i = free.size(); i-- > 0;) {
      bool idle = true;
      for (std::size_t k = 0; k < free.size(); ++k) {
        for (const FormulaMatrix* matrix : {&equations.C, &equations.K})
          idle = idle && (*matrix)[i][k].is_zero() && (*matrix)[k][i].is_zero();
        idle = idle && (k == i || (equations.M[i][k].is_zero() && equations.M[k][i].is_zero()));
      }
      if (!idle) continue;
      const auto at = static_cast<std::ptrdiff_t>(i);
      free.erase(free.begin() + at);
      for (FormulaMatrix* matrix : {&equations.M, &equations.C, &equations.K}) {
        matrix->erase(matrix->begin() + at);
        for (auto& row : *matrix) row.erase(row.begin() + at);
      }
    }
  }

  bool rides() const {
    if (!near_.situation.steady) return false;
    return std::ranges::any_of(near_.situation.frames, [&](const Frame& frame) {
      return frame.name == near_.situation.steady->frame && !frame.rides_on.empty();
    });
  }

  // Whether the rates found in numbers are roots of the polynomial.
  bool has_these_rates() const {
    std::vector<double> c;
    for (const Formula& one : polynomial_) c.push_back(value(one));
    std::size_t count = 0;
    for (const solve::Mode& mode : rates_.modes) {
      if (mode.moves.empty()) continue;
      count += mode.frequency > 0 ? 2 : 1;
      const std::complex<double> rate(mode.growth_rate, mode.frequency);
      std::complex<double> sum = 0, power = 1;
      double size = 0;
      for (const double coefficient : c) {
        sum += coefficient * power;
        size = std::max(size, std::abs(coefficient * power));
        power *= rate;
      }
      // Near zero a rate is known to the root of what the polynomial is.
      if (std::abs(sum) > same_rates * size && std::abs(rate) > std::sqrt(same_rates) * rates_.pace) return false;
    }
    return count > 0 && count <= c.size();
  }

  // Whether the polynomial is the same with the letters in the units that are shown, which have the second in common: a
  // number with a unit that stands in it would be one of SI.
  bool fits_units() const {
    if (tex_.letters().empty()) return true;
    constexpr double same_units = 1e-7;  // units differ by factors of ten and more
    return std::ranges::all_of(polynomial_, [&](const Formula& one) {
      const Formula ratio = one / polynomial_.back();
      return ratio.is_zero() || has_value(ratio, tex_.letters(), value(ratio), same_units);
    });
  }

  std::string words_of(std::size_t k) const {
    const Machine& machine = near_.numbers.machine();
    for (const NamedCoordinate& coordinate : machine.coordinates)
      if (coordinate.velocity == static_cast<int>(k) && !coordinate.name.empty())
        return "$" + ExplanationTex::symbol(coordinate.name) + "$";
    return machine.mechanism.coordinate_names[k];
  }

  void add_one(const LinearisedFormulas& equations, std::size_t k) {
    const Formula &A = equations.M[0][0], &B = equations.C[0][0], &C = equations.K[0][0];
    ExplainedStep step{"Let $\\xi$ be a small deviation of " + words_of(k) +
                           " from this motion. To first order in it the equation of motion, without what its terms "
                           "share, is",
                       {}};
    std::string sum;
    for (const auto& [factor, symbol] :
         {std::pair{&A, "\\ddot{\\xi}"}, std::pair{&B, "\\dot{\\xi}"}, std::pair{&C, "\\xi"}}) {
      if (factor->is_zero()) continue;
      const auto tex = ExplanationTex::formula(*factor);
      if (!tex) return;
      ExplanationTex::add_term(sum, *tex, symbol);
    }
    step.equations.push_back({"", sum + " = 0", {}, 0});
    steps_.push_back(std::move(step));
    if (!B.is_zero() || A.is_zero() || C.is_zero()) return;
    const double square = value(C) / value(A);
    if (near_.limit) return;
    ExplainedStep rate{square >= 0 ? "The deviation swings with the frequency $\\omega$:"
                                   : "The square of a frequency would be negative: the deviation grows.",
                       {}};
    rate.equations.push_back(tex_.kept("\\omega^{2}", {square, C / A}, inverse_square_time()));
    steps_.push_back(std::move(rate));
  }

  static Dimension inverse_square_time() { return dimensions::angular_velocity * dimensions::angular_velocity; }

  static std::optional<std::string> matrix_tex(const FormulaMatrix& matrix) {
    std::string tex = "\\begin{pmatrix}";
    for (std::size_t i = 0; i < matrix.size(); ++i) {
      for (std::size_t k = 0; k < matrix[i].size(); ++k) {
        const auto entry = ExplanationTex::formula(matrix[i][k]);
        if (!entry && !matrix[i][k].is_zero()) return std::nullopt;
        tex += (k == 0 ? " " : " & ") + (matrix[i][k].is_zero() ? "0" : *entry);
      }
      if (i + 1 < matrix.size()) tex += " \\\\";
    }
    return tex + " \\end{pmatrix}";
  }

  void add_matrices(const LinearisedFormulas& equations, const std::vector<std::size_t>& free) {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < free.size(); ++i)
      names.push_back("$\\xi_{" + std::to_string(i + 1) + "}$ of " + words_of(free[i]));
    std::string sum;
    ExplainedStep step;
    for (const auto& [matrix, name, symbol] : {std::tuple{&equations.M, "M", "\\ddot{\\boldsymbol{\\xi}}"},
                                               std::tuple{&equations.C, "C", "\\dot{\\boldsymbol{\\xi}}"},
                                               std::tuple{&equations.K, "K", "\\boldsymbol{\\xi}"}}) {
      if (vanishes(*matrix)) continue;
      ExplanationTex::add_term(sum, std::string("\\mathbf{") + name + "}", symbol);
      if (const auto tex = matrix_tex(*matrix); tex && tex->size() <= 3 * readable_line)
        step.equations.push_back({"", std::string("\\mathbf{") + name + "} = " + *tex, {}, 0});
    }
    const bool held = !equations.J.empty();
    step.equations.insert(step.equations.begin(),
                          {"", sum + " = " + (held ? "\\mathbf{W}\\,\\mathbf{y}" : "\\mathbf{0}"), {}, 0});
    step.text =
        "Let " + listed(names) +
        " be small deviations from this motion. To first order in them the equations of motion, without what "
        "their terms share, " +
        (held ? "and what holds the bodies beyond their joints, by forces that change with $\\mathbf{y}$, are" : "are");
    if (held) {
      std::string rates;
      for (const auto& [matrix, name, symbol] : {std::tuple{&equations.J, "J", "\\dot{\\boldsymbol{\\xi}}"},
                                                 std::tuple{&equations.B, "B", "\\boldsymbol{\\xi}"}})
        if (!vanishes(*matrix)) ExplanationTex::add_term(rates, std::string("\\mathbf{") + name + "}", symbol);
      step.equations.insert(step.equations.begin() + 1, {"", rates + " = \\mathbf{0}", {}, 0});
      for (const auto& [matrix, name] :
           {std::pair{&equations.W, "W"}, std::pair{&equations.J, "J"}, std::pair{&equations.B, "B"}})
        if (const auto tex = matrix_tex(*matrix); tex && !vanishes(*matrix) && tex->size() <= 3 * readable_line)
          step.equations.push_back({"", std::string("\\mathbf{") + name + "} = " + *tex, {}, 0});
    }
    steps_.push_back(std::move(step));
    add_polynomial(!vanishes(equations.C), held);
  }

  // det(M l^2 + C l + K), of which only even powers are written by the frequency w with l^2 = -w^2.
  void add_polynomial(bool gyroscopic, bool held) {
    const bool even = is_even();
    const std::string symbol = even ? "\\omega" : "\\lambda";
    std::string sum, numbers;
    bool readable = true;
    const double first = value(polynomial_.back());
    const std::size_t degree = polynomial_.size() - 1;
    const double first_sign = even && degree / 2 % 2 == 1 ? -1 : 1;
    ExplainedEquation monic;
    for (std::size_t k = degree + 1; k-- > 0;) {
      if (polynomial_[k].is_zero()) continue;
      // Beside the rates of the others, what vanishes at a limit is rounding.
      constexpr double rounding = 1e-12;
      const double part = value(polynomial_[k]) / first;
      const bool lost = std::abs(part) <= rounding * std::pow(largest_rate(), static_cast<double>(degree - k));
      const double sign = first_sign * (even && k / 2 % 2 == 1 ? -1 : 1);
      const std::string power = k == 0 ? "" : k == 1 ? symbol : symbol + "^{" + std::to_string(k) + "}";
      const auto tex = ExplanationTex::formula(sign < 0 ? -polynomial_[k] : polynomial_[k]);
      readable = readable && tex && sum.size() + tex->size() <= 2 * readable_line;
      if (readable) ExplanationTex::add_term(sum, *tex, power);
      if (!lost) ExplanationTex::add_term(numbers, tex_.number(sign * part, dimensions::none), power);
    }
    const bool known = std::ranges::all_of(polynomial_, [&](const Formula& one) {
      return tex_.is_known({0, one / polynomial_.back()});
    });
    ExplainedStep step{
        even ? "Solutions $\\boldsymbol{\\xi} \\sim e^{i\\omega t}$ exist where a determinant vanishes, $\\left| "
               "\\mathbf{K} " +
                   std::string(gyroscopic ? "+ i\\omega\\,\\mathbf{C} " : "") +
                   "- \\omega^{2}\\,\\mathbf{M} \\right| = 0$:"
             : "Solutions $\\boldsymbol{\\xi} \\sim e^{\\lambda t}$ exist where a determinant vanishes, "
               "$\\left| \\lambda^{2}\\,\\mathbf{M} + \\lambda\\,\\mathbf{C} + \\mathbf{K} \\right| = 0$:",
        {}};
    if (held)
      step.text =
          "Solutions $\\boldsymbol{\\xi} \\sim e^{\\lambda t}$ exist where the determinant of both together vanishes, "
          "$\\left| \\begin{smallmatrix} \\lambda^{2}\\,\\mathbf{M} + " +
          std::string(gyroscopic ? "\\lambda\\,\\mathbf{C} + " : "") +
          "\\mathbf{K} & "
          "-\\mathbf{W} \\\\ \\lambda\\,\\mathbf{J} + \\mathbf{B} & \\mathbf{0} \\end{smallmatrix} \\right| = 0$" +
          std::string(even ? ", with $\\lambda^{2} = -\\omega^{2}$:" : ":");
    if (readable) step.equations.push_back({"", sum + " = 0", {}, 0});
    if (known) step.equations.push_back({"", numbers + " = 0", {}, 0});
    if (!step.equations.empty()) steps_.push_back(std::move(step));
  }

  // About the size of the largest root.
  double largest_rate() const {
    double largest = 0;
    const std::size_t degree = polynomial_.size() - 1;
    for (std::size_t k = 0; k < degree; ++k)
      if (!polynomial_[k].is_zero())
        largest = std::max(largest, std::pow(std::abs(value(polynomial_[k]) / value(polynomial_.back())),
                                             1.0 / static_cast<double>(degree - k)));
    return largest;
  }

  bool is_even() const {
    for (std::size_t k = 1; k < polynomial_.size(); k += 2)
      if (!polynomial_[k].is_zero()) return false;
    return true;
  }

  // What vanishes at a limit: the last coefficient, where a deviation begins to creep away, or the discriminant of the
  // quadratic in the squares, where two frequencies meet.
  void add_limit() {
    if (!near_.limit || !is_even()) return;
    const std::vector<Formula>& c = polynomial_;
    const double pace = rates_.pace;
    const auto negligible = [&](const Formula& x, double size) {
      return std::abs(value(x)) <= vanishes_at_limit * size;
    };
    const double last_size = std::abs(value(c.back())) * std::pow(pace, static_cast<double>(c.size() - 1));
    if (negligible(c.front(), last_size)) {
      add_end(c.front(), c.size() == 3
                             ? "Deviations swing as long as the coefficient of $\\xi$ is positive, beside that of "
                               "$\\ddot{\\xi}$. At the limit it vanishes."
                             : "At the limit the last coefficient vanishes: beyond it deviations grow.");
    } else if (c.size() == 5) {
      const Formula discriminant = c[2] * c[2] - Formula(4) * c[0] * c[4];
      if (negligible(discriminant, value(c[2]) * value(c[2])))
        add_end(
            discriminant,
            "Deviations swing as long as both squares of frequencies are real. At the limit the discriminant of this "
            "quadratic in $\\omega^{2}$ vanishes: the frequencies meet.");
    }
  }
  void add_end(const Formula& vanishing, const std::string& text) {
    steps_.push_back({text, {}});
    const UnknownConditions at_limit{{vanishing}, {*near_.limit}, near_.factors, {}, "That is"};
    for (ExplainedStep& step : condition_steps(at_limit, near_.letters, tex_)) steps_.push_back(std::move(step));
  }

  void add_rates() {
    std::vector<std::string> swings, grows;
    if (near_.limit && !steps_.empty()) return;
    if (tex_.numbers_open()) return;
    const auto shown = [&](double rate, const Dimension& dimension) {
      return "$" + tex_.with_unit(rate, dimension) + "$";
    };
    constexpr double zero = 1e-9;  // of the pace
    for (const solve::Mode& mode : rates_.modes) {
      if (mode.moves.empty()) continue;
      const bool still = std::abs(mode.growth_rate) <= std::max(mode.doubt, zero * rates_.pace);
      if (mode.frequency > 0 && still)
        swings.push_back(shown(mode.frequency, dimensions::angular_velocity));
      else if (!still)
        grows.push_back(shown(mode.growth_rate, dimensions::none / dimensions::time) +
                        (mode.frequency > 0
                             ? " while swinging at " + shown(mode.frequency, dimensions::angular_velocity)
                             : std::string()));
    }
    if (swings.empty() && grows.empty()) return;
    std::string text = steps_.empty() ? "The equations of motion are linearised about this motion, in numbers." : "";
    const auto add = [&](const std::string& sentence) { text += (text.empty() ? "" : " ") + sentence; };
    if (!swings.empty()) add((swings.size() > 1 ? "The frequencies are " : "The frequency is ") + listed(swings) + ".");
    if (!grows.empty())
      add("Deviations change like $e^{\\lambda t}$ with $\\lambda$ = " + listed(grows) + ": they " +
          (rates_.modes.front().growth_rate > 0 ? "grow." : "die away."));
    steps_.push_back({text, {}});
  }

  // What swings at one frequency when free swings have died out.
  void add_responses() {
    if (near_.responses.empty()) return;
    steps_.push_back(
        {"What shakes the motion swings as $\\cos\\omega t$, and what remains when all free swings have "
         "died out is the real part of $\\mathbf{X} e^{i\\omega t}$, which the same equations determine:",
         {{"",
           "\\left( \\mathbf{K} - \\omega^{2}\\,\\mathbf{M} + i\\omega\\,\\mathbf{C} \\right) "
           "\\mathbf{X} = \\mathbf{F}",
           {},
           0}}});
    if (tex_.numbers_open()) {
      steps_.push_back(
          {"The response is what is asked of $\\mathbf{X}$: its size, and its phase, negative where it lags.", {}});
      return;
    }
    const auto shown = [&](double x, const Dimension& dimension) { return "$" + tex_.with_unit(x, dimension) + "$"; };
    std::string told;
    for (const Call& call : near_.responses) {
      const Expression asked = built(call, Mark{1, 1});
      const Value<double> found = near_.numbers.raw(asked, std::nullopt, nullptr);
      const std::vector<Value<double>> rows = is_record(found) ? std::vector<Value<double>>{found} : found.items;
      std::string parts;
      for (const Value<double>& row : rows)
        parts += (parts.empty() ? "" : "; ") + shown(row.items[0].number, row.items[0].dimension) + " at " +
                 shown(row.items[1].number, row.items[1].dimension);
      told += (told.empty() ? "" : ", ") + std::string("of ") + to_string(call.arguments[0].value) + " to " +
              to_string(*call.argument("to")) + " " + parts;
    }
    steps_.push_back({"Amplitudes and phases of the response, negative where it lags: " + told + ".", {}});
  }

  const NearSteady& near_;
  const ExplanationTex& tex_;
  const solve::Linearisation& rates_;
  std::vector<Formula> polynomial_;
  std::vector<ExplainedStep> steps_;
};

}  // namespace

std::vector<ExplainedStep> near_steady_steps(const NearSteady& near, const ExplanationTex& tex) {
  return NearSteadySteps(near, tex).steps();
}

}  // namespace poinsot::problem
