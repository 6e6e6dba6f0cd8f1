#include "problem/explanation/explanation_unknowns.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "poinsot/engine/work/work.h"
#include "problem/explanation/shared_factors.h"
#include "problem/formulas/formula_unknowns.h"
#include "problem/language/words.h"

namespace poinsot::problem {
namespace {

// Of the largest term: what searching for an unknown leaves of an equation for it, and what is no rounding.
constexpr double left_by_search = 1e-6;

// What has more terms is not read by anybody, whatever its terms share.
constexpr std::size_t readable_terms = 60;
constexpr Work readable_work = 100'000'000;

std::string power_of(const std::string& symbol, std::size_t k) {
  return k == 0 ? "" : k == 1 ? symbol : symbol + "^{" + std::to_string(k) + "}";
}

class ConditionSteps {
 public:
  ConditionSteps(const UnknownConditions& stated, const LetterValues& letters, const ExplanationTex& tex)
      : stated_(stated), letters_(letters), tex_(tex) {}

  std::vector<ExplainedStep> steps() {
    std::vector<Formula> left = stated_.conditions;
    std::set<std::string> open;
    for (const FoundDatum& one : stated_.unknown) open.insert(one.name);
    // A condition on one unknown alone comes before those in which it has a value already.
    while (!left.empty()) {
      const auto among = [&](const Formula& condition) {
        std::vector<std::string> names;
        for (const std::string& name : condition.letters())
          if (open.contains(name)) names.push_back(name);
        return names;
      };
      const auto next = std::ranges::min_element(left, {}, [&](const Formula& one) { return among(one).size(); });
      const std::vector<std::string> names = among(*next);
      if (names.size() == 1) {
        const std::size_t before = steps_.size();
        add_single(*next, datum(names.front()));
        // What is no polynomial is at least written down.
        if (steps_.size() == before) add_shared(*next, names);
        open.erase(names.front());
      } else if (names.size() > 1) {
        add_shared(*next, names);
      }
      left.erase(next);
    }
    return std::move(steps_);
  }

 private:
  const FoundDatum& datum(const std::string& name) const {
    return *std::ranges::find(stated_.unknown, name, &FoundDatum::name);
  }
  static std::string symbol(const FoundDatum& one) { return ExplanationTex::symbol(one.name); }

  void add_single(const Formula& condition, const FoundDatum& unknown) {
    if (unknown.dimension == dimensions::angle)
      add_angle(condition, unknown);
    else
      add_polynomial(condition, unknown);
  }

  // Whether it vanishes at what was found but for what the search leaves, also with the letters in the units shown.
  bool holds(const Formula& condition, const std::vector<std::string>& names) const {
    for (const LetterValues* letters : {&letters_, &tex_.letters()}) {
      if (letters->empty()) continue;
      LetterValues moved = *letters;
      const double left = value_at(condition, moved);
      double allowed = 0;
      for (const std::string& name : names) {
        const auto letter = moved.find(name);
        if (letter == moved.end()) return false;
        const double own = letter->second;
        letter->second *= 1 + left_by_search;
        allowed += std::abs(value_at(condition, moved) - left);
        letter->second = own;
      }
      if (!(std::abs(left) <= allowed)) return false;
    }
    return true;
  }

  // What vanishes is written with the sign that leaves it shorter.
  static std::optional<std::string> that_vanishes(const Formula& formula) {
    const auto tex = ExplanationTex::formula(formula), opposite = ExplanationTex::formula(-formula);
    return tex && opposite && opposite->size() < tex->size() ? opposite : tex;
  }

  // Several unknowns in one equation: it is shown without what its terms share, with others of the kind.
  void add_shared(const Formula& condition, const std::vector<std::string>& names) {
    const std::vector<Formula> reduced = without_shared_factors({numerator(condition)}, stated_.factors).rest;
    const auto tex = that_vanishes(reduced.front());
    if (!tex || tex->size() > longest_line || !holds(reduced.front(), names)) return;
    for (const FoundDatum& one : stated_.unknown)
      if (std::ranges::find(names, one.name) != names.end()) shared_.insert("$" + symbol(one) + "$");
    if (!shared_step_) {
      shared_step_ = steps_.size();
      steps_.emplace_back();
    }
    ExplainedStep& step = steps_[*shared_step_];
    step.equations.push_back({"", *tex + " = 0", {}, 0});
    step.text =
        (step.equations.size() > 1 ? stated_.from_several + " equations for " : stated_.from + " an equation for ") +
        listed({shared_.begin(), shared_.end()}) + ":";
  }

  void add_polynomial(Formula condition, const FoundDatum& unknown) {
    if (std::ranges::find(stated_.first_order, unknown.name) != stated_.first_order.end())
      condition = first_order(condition, {unknown.name});
    auto found = polynomial_in(condition, unknown.name);
    if (!found) found = polynomial_in(numerator(condition), unknown.name);
    if (!found || found->size() < 2) return;
    std::size_t vanishing = 0;
    while (found->size() > 2 && found->front().is_zero()) {
      found->erase(found->begin());
      ++vanishing;
    }
    std::vector<Formula> c = without_shared_factors(*found, stated_.factors).rest;
    const double u = unknown.value;
    std::vector<double> numbers;
    for (const Formula& one : c) numbers.push_back(one.is_zero() ? 0 : value_at(one, letters_));
    if (numbers.back() < 0)
      for (std::size_t k = 0; k < c.size(); ++k) {
        c[k] = -c[k];
        numbers[k] = -numbers[k];
      }
    if (!vanishes_at(numbers, u) || !fits_units(c, unknown)) return;
    const std::string name = symbol(unknown);
    ExplainedStep step{stated_.from + " an equation for $" + name + "$ alone" +
                           (vanishing > 0 ? "; apart from $" + name + " = 0$ it is" : std::string()) + ":",
                       {}};
    const std::size_t degree = c.size() - 1;
    if (degree > 1) add_collected(step, c, numbers, name, u);
    if (degree == 1) {
      step.equations.push_back(tex_.kept(name, {u, -c[0] / c[1]}, unknown.dimension));
    } else if (degree == 2 && c[1].is_zero()) {
      const Shown square{u * u, -c[0] / c[2]};
      step.equations.push_back(tex_.kept(name + "^{2}", square, unknown.dimension * unknown.dimension));
      add_value(step, unknown);
    } else if (degree == 2 && known(c)) {
      add_monic(step, numbers, name, unknown);
      add_roots(step, numbers, name, unknown);
    } else if (known(c)) {
      add_monic(step, numbers, name, unknown);
      add_value(step, unknown);
    }
    if (!step.equations.empty()) steps_.push_back(std::move(step));
  }

  bool known(const std::vector<Formula>& c) const {
    return std::ranges::all_of(c, [&](const Formula& one) { return tex_.is_known({0, one / c.back()}); });
  }

  // Whether it vanishes with the letters in the units that are shown, too: a number with a unit that stands in it would
  // be one of SI.
  bool fits_units(const std::vector<Formula>& c, const FoundDatum& unknown) const {
    if (tex_.letters().empty()) return true;
    std::vector<double> shown;
    for (const Formula& one : c) shown.push_back(one.is_zero() ? 0 : value_at(one, tex_.letters()));
    return vanishes_at(shown, unknown.value / tex_.unit(unknown.dimension).factor);
  }

  bool vanishes_at(const std::vector<double>& c, double u) const {
    double sum = 0, size = 0;
    for (std::size_t k = 0; k < c.size(); ++k) {
      const double term = c[k] * std::pow(u, static_cast<double>(k));
      sum += term;
      size = std::max(size, std::abs(term));
    }
    return std::abs(sum) <= left_by_search * size;
  }

  // What was found, unless letters without value stand behind it.
  void add_value(ExplainedStep& step, const FoundDatum& unknown) const {
    if (!tex_.numbers_open())
      step.equations.push_back(tex_.equation(symbol(unknown), known_number(unknown.value), unknown.dimension));
  }

  // The polynomial in letters. In other units than SI a number that has a unit would be wrong in it.
  void add_collected(ExplainedStep& step, const std::vector<Formula>& c, const std::vector<double>& numbers,
                     const std::string& name, double u) const {
    std::string sum;
    double size = 0, left = 0;
    for (std::size_t k = c.size(); k-- > 0;) {
      if (c[k].is_zero()) continue;
      const auto tex = ExplanationTex::formula(c[k]);
      if (!tex || sum.size() + tex->size() > 2 * longest_line) return;
      ExplanationTex::add_term(sum, *tex, power_of(name, k));
      const double term = numbers[k] * std::pow(u, static_cast<double>(k));
      left += term;
      size = std::max(size, std::abs(term));
    }
    step.equations.push_back({"", sum + " = 0", {left, 0.0}, size});
  }

  // The same in numbers, divided by its first coefficient.
  void add_monic(ExplainedStep& step, const std::vector<double>& c, const std::string& name,
                 const FoundDatum& unknown) const {
    const double unit = tex_.unit(unknown.dimension).factor, u = unknown.value / unit;
    std::string sum;
    ExplainedEquation equation;
    double left = 0;
    for (std::size_t k = c.size(); k-- > 0;) {
      const double factor = c[k] / c.back() / std::pow(unit, static_cast<double>(c.size() - 1 - k));
      if (factor == 0) continue;
      const double shown = tex_.rounded(factor, dimensions::none), power = std::pow(u, static_cast<double>(k));
      ExplanationTex::add_term(sum, tex_.number(factor, dimensions::none), power_of(name, k));
      if (k > 0) equation.symbols.push_back({power_of(name, k), power});
      left += shown * power;
      equation.size = std::max(equation.size, std::abs(shown * power));
    }
    equation.tex = sum + " = 0";
    equation.sides = {left, 0.0};
    step.equations.push_back(std::move(equation));
  }

  void add_roots(ExplainedStep& step, const std::vector<double>& c, const std::string& name,
                 const FoundDatum& unknown) const {
    const double middle = -c[1] / (2 * c[2]);
    const double apart = std::sqrt(std::max(0.0, middle * middle - c[0] / c[2]));
    const Dimension& dimension = unknown.dimension;
    const double sign = unknown.value < middle ? -1 : 1, other = middle - sign * apart;
    step.equations.push_back({"",
                              name + " = " + tex_.number(middle, dimension) + " \\pm " + tex_.number(apart, dimension) +
                                  tex_.unit_tex(dimension),
                              {unknown.value, tex_.rounded(middle, dimension) + sign * tex_.rounded(apart, dimension)},
                              std::abs(middle) + apart});
    add_value(step, unknown);
    // A root that cancels to less than its digits is no second root.
    if (apart > left_by_search * std::abs(middle))
      step.text.insert(step.text.size() - 1,
                       ", a quadratic with the other root $" + tex_.with_unit(other, dimension) + "$");
  }

  // What is linear in the sine or in the cosine of the angle.
  void add_angle(const Formula& condition, const FoundDatum& unknown) {
    std::vector<Formula> factors = stated_.factors;
    const WithoutShared reduced = without_shared_factors({condition}, factors);
    const Formula& rest = reduced.rest.front();
    const std::string name = symbol(unknown);
    std::vector<std::string> elsewhere;
    for (const Formula& factor : reduced.divided) {
      const std::vector<std::string> names = factor.letters();
      const auto tex = ExplanationTex::formula(factor);
      if (tex && names == std::vector<std::string>{unknown.name}) elsewhere.push_back("$" + *tex + " = 0$");
    }
    ExplainedStep step{stated_.from + " an equation for $" + name + "$ alone" +
                           (elsewhere.empty() ? std::string() : "; apart from " + listed(elsewhere) + " it is") + ":",
                       {}};
    const auto tex = that_vanishes(rest);
    if (tex && tex->size() <= 2 * longest_line) step.equations.push_back({"", *tex + " = 0", {}, 0});
    add_function(step, rest, unknown);
    add_value(step, unknown);
    if (step.equations.size() > 1) steps_.push_back(std::move(step));
  }

  void add_function(ExplainedStep& step, const Formula& rest, const FoundDatum& unknown) const {
    const Formula half_turn = Formula::pi(), quarter = half_turn / Formula(2);
    const auto at = [&](const Formula& angle) { return substituted(rest, {{unknown.name, angle}}); };
    const Formula u = Formula::letter(unknown.name, poinsot::Sign::real);
    struct Function {
      const char* tex;
      Formula of_unknown, largest, smallest;
      double value;
    };
    for (const Function& f : {Function{"\\sin ", sin(u), quarter, -quarter, std::sin(unknown.value)},
                              Function{"\\cos ", cos(u), Formula(0), half_turn, std::cos(unknown.value)}}) {
      try {
        const Formula most = at(f.largest), least = at(f.smallest);
        const Formula constant = (most + least) / Formula(2), slope = (most - least) / Formula(2);
        if (slope.is_zero() || !(rest - constant - slope * f.of_unknown).is_zero()) continue;
        const Formula value = -constant / slope;
        if (!has_value(value, letters_, f.value, left_by_search)) continue;
        step.equations.push_back(tex_.kept(f.tex + symbol(unknown), {f.value, value}, dimensions::none));
        return;
      } catch (const std::domain_error&) {
        // The other one may do.
      }
    }
  }

  static constexpr std::size_t longest_line = 240;  // of TeX

  const UnknownConditions& stated_;
  const LetterValues& letters_;
  const ExplanationTex& tex_;
  std::vector<ExplainedStep> steps_;
  std::optional<std::size_t> shared_step_;  // the one that has equations for several unknowns
  std::set<std::string> shared_;            // their symbols
};

}  // namespace

std::vector<ExplainedStep> condition_steps(const UnknownConditions& stated, const LetterValues& letters,
                                           const ExplanationTex& tex) {
  try {
    const FormulaLimitScope limits({readable_terms, readable_work});
    UnknownConditions readable = stated;
    std::erase_if(readable.conditions, [](const Formula& one) { return one.terms() > readable_terms; });
    return ConditionSteps(readable, letters, tex).steps();
  } catch (const std::domain_error&) {
  } catch (const FormulaTooLarge&) {
  } catch (const std::invalid_argument&) {
    // A letter without a value: what it is for is not told by a formula.
  }
  return {};
}

}  // namespace poinsot::problem
