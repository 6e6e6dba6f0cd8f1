#include "problem/explanation/explanation_claims.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "problem/language/words.h"

namespace poinsot::problem {
namespace {

constexpr std::size_t most_values = 8;  // values of a counterexample that are shown in a sentence

std::string relation_tex(const std::string& relation) {
  if (relation == "==") return "=";
  if (relation == "<=") return "\\le";
  if (relation == ">=") return "\\ge";
  return relation;
}

class ClaimExplainer {
 public:
  ClaimExplainer(const Claim& stated, const SolvedClaim& solved, const ExplanationTex& tex)
      : stated_(stated), solved_(solved), tex_(tex) {}

  std::vector<ExplainedStep> steps() {
    std::string text = code(stated_.text) + (stated_.situation.empty() ? "" : " in *" + stated_.situation + "*");
    if (!solved_.assumptions.empty()) {
      std::vector<std::string> assumed;
      for (const std::string& assumption : solved_.assumptions) assumed.push_back(code(assumption));
      text += ", where " + listed(assumed) + ",";
    }
    if (solved_.state != AskState::found) return {{text + " is not decided: " + solved_.reason + ".", {}}};
    if (!solved_.holds)
      text += " does not hold.";
    else
      text += solved_.proved ? " holds for all values."
                             : " held at every set of exact values at which it was tried; it was not proved.";
    add(text);
    if (solved_.stability) add_stability(*solved_.stability);
    add_assumed();
    for (const SolvedClaim::Comparison& comparison : solved_.comparisons) add_comparison(comparison);
    if (!solved_.holds) add_counterexample();
    return std::move(steps_);
  }

 private:
  ExplainedStep& add(const std::string& text) { return steps_.emplace_back(ExplainedStep{text, {}}); }
  static void add_line(ExplainedStep& step, const std::string& tex) { step.equations.push_back({"", tex, {}, 0}); }

  // The formula as TeX; a number with its unit.
  std::optional<std::string> shown(const Formula& formula, const Dimension& dimension) const {
    if (formula.is_zero()) return "0";
    if (formula.is_number()) return tex_.with_unit(plain(formula), dimension);
    return ExplanationTex::formula(formula);
  }

  void add_assumed() {
    std::vector<std::string> values;
    for (const auto& [letter, value] : solved_.assumed)
      if (const auto tex = ExplanationTex::formula(value))
        values.push_back("$" + ExplanationTex::symbol(letter) + " = " + *tex + "$");
    if (values.empty() || values.size() < solved_.assumed.size()) return;
    const bool parts = std::any_of(solved_.assumed.begin(), solved_.assumed.end(), [&](const auto& item) {
      return std::ranges::any_of(item.second.letters(), [&](const std::string& name) {
        return std::ranges::find(solved_.positive_parts, name) != solved_.positive_parts.end();
      });
    });
    add("What is assumed makes " + listed(values) + (parts ? ", the letters $p$ being positive." : "."));
  }

  void add_comparison(const SolvedClaim::Comparison& comparison) {
    if (comparison.left.is_zero() && comparison.right.is_zero()) {
      if (solved_.comparisons.size() == 1 && comparison.parts.empty()) add("Both sides vanish identically.");
      if (!comparison.parts.empty()) add_parts(comparison);
      return;
    }
    const auto left = shown(comparison.left, comparison.dimension),
               right = shown(comparison.right, comparison.dimension);
    if (!comparison.parts.empty()) add_parts(comparison);
    if (!left || !right) {
      add("Its sides are too long to be shown: they have " + std::to_string(comparison.left.terms()) + " and " +
          std::to_string(comparison.right.terms()) + " terms" +
          (comparison.reduced && comparison.reduced->is_zero() ? "; their difference is zero." : "."));
      return;
    }
    ExplainedStep& step = add(words_of_sides(comparison));
    add_line(step, "\\text{left} = " + *left);
    add_line(step, "\\text{right} = " + *right);
    if (!comparison.reduced) return;
    if (const auto difference = shown(*comparison.reduced, comparison.dimension)) {
      const bool strict = !comparison.reduced->is_zero() && comparison.relation != "==" && solved_.proved;
      add_line(step, "\\text{left} - \\text{right} = " + *difference +
                         (strict ? " " + relation_tex(comparison.relation) + " 0" : ""));
    }
    if (solved_.proved && comparison.relation != "==" && !comparison.reduced->is_zero())
      add("No values of the letters give the difference another sign.");
  }

  // Which sides these are: of which of several comparisons, and which component of vectors.
  std::string words_of_sides(const SolvedClaim::Comparison& comparison) const {
    const bool several = std::ranges::any_of(
        solved_.comparisons, [&](const SolvedClaim::Comparison& other) { return other.of != comparison.of; });
    const std::string of = several ? "the sides of " + code(comparison.of) : std::string("its sides");
    if (comparison.component < 0) return "In letters " + of + " are";
    return "In letters the $" + tex_.axis(static_cast<std::size_t>(comparison.component)) + "$ components of " + of +
           " are";
  }

  // An expression of the file as a term in a formula.
  static std::string term(const std::string& expression) {
    if (is_name(expression)) return ExplanationTex::symbol(expression);
    std::string escaped;
    for (const char c : expression)
      escaped += c == '_' ? std::string("\\_") : c == '^' ? std::string("\\^{}") : std::string(1, c);
    return "\\left(\\texttt{" + escaped + "}\\right)";
  }

  // Shows the rate as a sum of parts that cancel.
  void add_parts(const SolvedClaim::Comparison& comparison) {
    std::vector<std::string> lines;
    for (const SolvedClaim::Part& part : comparison.parts) {
      const auto value = shown(part.value, comparison.dimension);
      if (!value) return;
      const std::string letter = part.by_letter ? ExplanationTex::symbol(part.of) : "";
      lines.push_back((part.by_letter ? "\\frac{\\partial f}{\\partial " + letter + "}\\,\\frac{\\mathrm{d}" + letter +
                                            "}{\\mathrm{d}t}"
                                      : "\\frac{\\mathrm{d}}{\\mathrm{d}t}\\," + term(part.of)) +
                      " = " + *value);
    }
    const Formula& sum = comparison.left.is_zero() ? comparison.right : comparison.left;
    const auto total = shown(sum, comparison.dimension);
    if (!total) return;
    ExplainedStep& step =
        add(comparison.parts.front().by_letter ? "Along the motion the rate of what is claimed, $f$, is the sum of "
                                                 "what each coordinate and velocity brings:"
                                               : "Along the motion the rate is the sum of the rates of its terms:");
    for (const std::string& line : lines) add_line(step, line);
    add_line(step, "\\text{sum} = " + *total);
  }

  void add_stability(const SolvedClaim::Stability& stability) {
    std::string sum;
    for (std::size_t k = stability.polynomial.size(); k-- > 0;) {
      const Formula& coefficient = stability.polynomial[k];
      if (coefficient.is_zero()) continue;
      const auto tex = ExplanationTex::formula(coefficient);
      if (!tex) return;
      const std::string power = k == 0 ? "" : k == 1 ? "\\lambda" : "\\lambda^{" + std::to_string(k) + "}";
      const bool one = *tex == "1" && k > 0;
      sum += (sum.empty() ? "" : " + ") + (one ? "" : "\\left(" + *tex + "\\right)") + power;
    }
    ExplainedStep& polynomial = add("Disturbances that change like $e^{\\lambda t}$ have rates $\\lambda$ with" +
                                    (stability.vanishing > 0 ? " (beside " + std::to_string(stability.vanishing) +
                                                                   " that vanish, as the motion displaced is as good)"
                                                             : std::string()));
    add_line(polynomial, sum + " = 0");
    std::vector<std::string> lines;
    for (const Formula& one : stability.positive)
      if (const auto tex = ExplanationTex::formula(one)) lines.push_back(*tex + " > 0");
    const bool all = lines.size() == stability.positive.size();
    ExplainedStep& signs = add("Here " + stability.criterion +
                               (solved_.proved ? ", as they are" : "; they were so wherever it was tried") +
                               (lines.empty() ? "."
                                : all         ? ":"
                                              : ", among them"));
    for (const std::string& line : lines) add_line(signs, line);
  }

  void add_counterexample() {
    std::vector<std::string> values;
    for (const SolvedClaim::Datum& datum : solved_.counterexample)
      values.push_back("$" + ExplanationTex::symbol(datum.name) + " = " +
                       tex_.with_unit(datum.value, datum.unit.dimension) + "$");
    const bool alike = sides_look_alike();
    if (values.size() > most_values || alike) values = {"the values that `poinsot solve` prints"};
    std::string text = values.empty() ? "" : "Take " + listed(values);
    if (solved_.sides) {
      // The sides are given in the unit of the claim.
      const auto si = [&](double number) {
        return tex_.with_unit(number * solved_.unit.factor, solved_.unit.dimension);
      };
      text += std::string(text.empty() ? "The" : ": the") + " left side is $" + si(solved_.sides->first) +
              "$, the right $" + si(solved_.sides->second) + "$";
      const double difference = solved_.difference.value_or(solved_.sides->first - solved_.sides->second);
      if (solved_.difference || alike)
        text +=
            ", the left " + std::string(difference < 0 ? "less" : "more") + " by $" + si(std::abs(difference)) + "$";
    }
    if (!text.empty()) add(text + ".");
  }

  // Close to where a claim begins to fail its two sides, and so the letters, differ in later digits than are shown.
  bool sides_look_alike() const {
    if (!solved_.sides || solved_.sides->first == solved_.sides->second) return false;
    const auto shown = [&](double number) { return tex_.with_unit(number, solved_.unit.dimension); };
    return shown(solved_.sides->first) == shown(solved_.sides->second);
  }

  const Claim& stated_;
  const SolvedClaim& solved_;
  const ExplanationTex& tex_;
  std::vector<ExplainedStep> steps_;
};

}  // namespace

ExplainedSection claims_section(const Statement& statement, const Solution& solution, const ExplanationTex& tex) {
  ExplainedSection section{"Claims", {}};
  for (std::size_t k = 0; k < statement.claims.size() && k < solution.claims.size(); ++k)
    for (ExplainedStep& step : ClaimExplainer(statement.claims[k], solution.claims[k], tex).steps())
      section.steps.push_back(std::move(step));
  return section;
}

}  // namespace poinsot::problem
