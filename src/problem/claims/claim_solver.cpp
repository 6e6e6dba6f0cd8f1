#include "problem/claims/claim_solver.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <set>
#include <utility>

#include "poinsot/engine/math/formula/formula_decision.h"
#include "poinsot/engine/work/work.h"
#include "problem/claims/claim_attack.h"
#include "problem/claims/claim_letters.h"
#include "problem/claims/claim_numbers.h"
#include "problem/claims/claim_rates.h"
#include "problem/claims/claim_steady.h"
#include "problem/claims/claim_trials.h"
#include "problem/formulas/formula_answers.h"
#include "problem/language/diagnostic.h"
#include "problem/quantities/asks_model.h"

namespace poinsot::problem {
namespace {

constexpr int most_points = 400;                   // at which a claim without proof is tried
constexpr int confirming_points = 2;               // at which numbers must confirm a proof
constexpr Work most_sample_work = 10'000'000'000;  // on these points, all together
constexpr int most_edge_points = 4;                // from which edges are looked for
constexpr Work most_telling_work = 1'000'000'000;  // on the sides that a worked solution shows
constexpr Work most_attack_work = 300'000'000;     // on making smaller by what a claim without proof holds
constexpr std::size_t most_attack_starts = 60;     // of the points, at which that begins
constexpr int shown_digits = 6;                    // of the values at which a claim fails

double rounded_to(double value, int digits) {
  if (value == 0) return 0;
  const double unit = std::pow(10, digits - 1 - std::floor(std::log10(std::abs(value))));
  return std::round(value * unit) / unit;
}

class ClaimSolver {
 public:
  ClaimSolver(const Statement& statement, std::size_t situation_index, const Claim& claim, ClaimGround& ground,
              bool tell)
      : statement_(statement),
        situation_index_(situation_index),
        situation_(ground.situation()),
        claim_(claim),
        ground_(ground),
        tell_(tell) {}

  SolvedClaim solve() {
    require_quantity();
    if (!find_formulas())
      decide_by_numbers();
    else if (const auto unfixed = formulas_->unfixed(); !unfixed.empty())
      undetermined("it speaks of " + unfixed.front() + ", which the statement does not fix");
    else
      decide_by_formulas();
    if (tell_ && formulas_ && result_.state == AskState::found) tell_formulas();
    return std::move(result_);
  }

 private:
  void require_quantity() const {
    for (const Expression& expression : claim_.of)
      if (asks_model(situation_, expression)) return;
    fail(situation_.file, claim_.mark,
         "'" + claim_.name + "' claims nothing of the model: it compares formulas of the data",
         "claim something of a quantity, such as angular_momentum(BODY about POINT)");
  }

  void undetermined(const std::string& reason) {
    result_.state = AskState::undetermined;
    result_.reason = reason;
  }

  // Finds the formulas of the claim and tries to prove it. Returns false if it has no formulas.
  bool find_formulas() {
    const FormulaLimitScope limits({most_formula_terms, most_formula_work});
    try {
      ClaimFormulas* formulas = ground_.formulas(is_along_motion(situation_, claim_));
      if (!formulas) return false;
      const PlainPointScope decisions(ground_.base_point());
      formulas_ = std::make_unique<ClaimInstant>(*formulas, claim_);
      std::vector<std::string> positive;
      for (const Letter& letter : all_letters())
        if (is_positive(letter)) positive.push_back(letter.name);
      worked_ = std::make_unique<WorkedAssumptions>(formulas_->assumptions(), positive);
      letters_ = all_letters();
      trials_ = std::make_unique<ClaimTrials>(*formulas_, *worked_, letters_, ground_.sizes());
    } catch (const NoFormula&) {
      return formulas_ = nullptr, false;
    } catch (const std::domain_error&) {
      return formulas_ = nullptr, false;
    } catch (const FormulaTooLarge&) {
      return formulas_ = nullptr, false;
    } catch (const StatementError&) {
      // The numbers meet the same fault and report it, or are not affected by it.
      return formulas_ = nullptr, false;
    }
    try {
      proved_ = is_proved();
    } catch (const FormulaTooLarge&) {
      // The proof would take more terms than allowed.
    } catch (const std::domain_error&) {
      // The proof would need a formula that does not exist.
    }
    return true;
  }

  bool is_proved() const {
    const Decisions& decisions = formulas_->decisions();
    if (decisions.zeros_by_digits) return false;
    const DecisionScope reduction;
    for (const Formula& sign : decisions.signs)
      if (!worked_->keeps_sign(sign, base_sign(sign))) return false;
    const bool all = std::all_of(formulas_->terms().begin(), formulas_->terms().end(), [&](const ClaimTerm& term) {
      return worked_->proves(term.comparison) || (term.by_cosines && worked_->proves(*term.by_cosines));
    });
    return all && !reduction.zeros_by_digits();
  }

  // The sign of a formula at the base point, where the formulas were decided.
  int base_sign(const Formula& sign) const {
    const PlainPointScope base(ground_.base_point());
    return plain(sign) < 0 ? -1 : 1;
  }

  // The letters without value and those for what the statement leaves open.
  std::vector<Letter> all_letters() const {
    std::vector<Letter> all = ground_.letters();
    if (formulas_) all.insert(all.end(), formulas_->open().begin(), formulas_->open().end());
    return all;
  }

  // Whether the formulas hold at a point: the signs that were decided at the base must be the same there.
  bool decided_alike(const Point& point) {
    if (decided_.empty())
      for (const Formula& sign : formulas_->decisions().signs)
        decided_.push_back({sign, base_sign(sign), sign.letters()});
    return std::ranges::all_of(decided_, [&](const DecidedSign& decided) {
      return std::ranges::all_of(decided.letters, [&](const std::string& name) { return point.contains(name); }) &&
             value_at(decided.of, point) * decided.at_base >= 0;
    });
  }

  enum class Outcome { skipped, holds, decided };

  Outcome try_at(const ClaimTrials::Drawn& drawn, int& confirmed_points, bool& possible) {
    const bool by_digits = formulas_->decisions().zeros_by_digits;
    const bool formulas_hold = decided_alike(drawn.point) && !by_digits;
    Verdict verdict = trials_->verdict(drawn);
    if (verdict.close && verdict.holds && !proved_ && formulas_hold) return Outcome::skipped;
    const bool check =
        !formulas_hold || !verdict.holds || (proved_ && confirmed_points < confirming_points) || !possible;
    if (!check) return proved_ ? Outcome::decided : Outcome::holds;
    const std::optional<Verdict> numbers = ground_.verdict_at(claim_, formulas_->formulas(), drawn.point);
    if (!numbers) return Outcome::skipped;
    if (takes_derivatives(situation_, claim_) || ground_.neglects()) {
      // Derivatives by letters and neglected squares have no numbers. The formulas decide wherever the situation has
      // a solution.
      if (!formulas_hold) return Outcome::skipped;
    } else if (!formulas_hold) {
      if (numbers->close) return Outcome::skipped;
      verdict = *numbers;
    } else if ((verdict.difference && numbers->holds) || found_alike(*numbers, verdict) ||
               (proved_ && numbers->close && verdict.holds)) {
      // Rounding hides from the numbers what the exact formulas tell; or they have the same two sides, which count as
      // equal beside forces that have no part in them; or the sides are equal, as the proof tells.
    } else if (too_fine(*numbers, verdict)) {
      // Formulas that no number confirms refute nothing: another point has to show it.
      unconfirmed_ = true;
      return Outcome::skipped;
    } else if (numbers->close ? !verdict.close : numbers->holds != verdict.holds) {
      if (numbers->close) return Outcome::skipped;
      undetermined("formulas and numbers do not agree on it");
      return Outcome::decided;
    }
    if (confirmed_points < confirming_points || !verdict.holds)
      switch (ground_.confirmed_at(claim_, formulas_->formulas(), drawn.point)) {
        case Confirmation::confirmed:
          break;
        case Confirmation::open:
          off_particles_ = true;
          return Outcome::skipped;
        case Confirmation::contradicted:
          undetermined("the bodies as particles do not confirm it");
          return Outcome::decided;
      }
    possible = true;
    ++confirmed_points;
    if (proved_ && !verdict.holds) {
      undetermined("formulas and numbers do not agree on it");
      return Outcome::decided;
    }
    if (verdict.holds) return Outcome::holds;
    if (!refute_clearly(drawn)) refute_simply(drawn.point, verdict);
    return Outcome::decided;
  }

  void decide_by_formulas() {
    int confirmed_points = 0, searched_edges = 0;
    bool possible = false;
    const WorkLimit limit(most_sample_work);
    // As long as this exists, a formula that vanishes at one point only is not taken for zero.
    const DecisionScope elsewhere;
    std::vector<ClaimTrials::Drawn> starts;
    for (int attempt = 0; attempt < most_points && !limit.spent(); ++attempt) {
      const std::optional<ClaimTrials::Drawn> drawn = trials_->draw(attempt);
      if (!drawn) continue;
      if (starts.size() < most_attack_starts) starts.push_back(*drawn);
      const Outcome outcome = try_at(*drawn, confirmed_points, possible);
      if (outcome == Outcome::decided && !proved_) return;
      if (outcome == Outcome::decided && result_.state == AskState::undetermined) return;
      if (outcome == Outcome::decided) break;
      if (proved_ || attempt % 3 != 0 || searched_edges++ >= most_edge_points) continue;
      for (const ClaimTrials::Drawn& edge : trials_->at_edges(*drawn, attempt / 3))
        if (try_at(edge, confirmed_points, possible) == Outcome::decided) return;
    }
    if (!proved_ && possible)
      for (const WorkedCase& one : worked_->cases())
        if (attack(one, starts, confirmed_points, possible)) return;
    finish(possible);
  }

  // Looks for a point of a case at which the claim fails. Returns whether that decided it.
  bool attack(const WorkedCase& one, const std::vector<ClaimTrials::Drawn>& starts, int& confirmed_points,
              bool& possible) {
    // Where numbers made sense last, and whether they did.
    std::optional<std::pair<Point, bool>> by_numbers;
    // A point is looked at twice, one time after the other.
    std::optional<Point> none_at;
    std::optional<ClaimTrials::Drawn> drawn;
    const auto draw = [&](const Point& free) {
      if (drawn ? drawn->free == free : none_at == free) return;
      drawn = trials_->at(one, free);
      if (!drawn) none_at = free;
    };
    ClaimAttack attack(
        trials_->free_letters(one),
        [&](const Point& free) -> std::optional<double> {
          draw(free);
          if (!drawn) return std::nullopt;
          if (decided_alike(drawn->point)) return trials_->margin(*drawn);
          // The formulas are of another branch than the one there.
          if (takes_derivatives(situation_, claim_) || ground_.neglects() || states_equality(claim_.of))
            return std::nullopt;
          const std::optional<Verdict> numbers = ground_.verdict_at(claim_, formulas_->formulas(), drawn->point);
          by_numbers.emplace(free, numbers.has_value());
          return numbers ? std::optional(numbers->margin) : std::nullopt;
        },
        [&](const Point& free) {
          if (by_numbers && by_numbers->first == free) return by_numbers->second;
          draw(free);
          return drawn && ground_.verdict_at(claim_, formulas_->formulas(), drawn->point).has_value();
        },
        most_attack_work);
    // Where the formulas hold all over, numbers have no part in it.
    if (formulas_->decisions().signs.empty()) attack.let_margin_read(trials_->read_by_margin(one));
    std::vector<Point> from;
    for (const ClaimTrials::Drawn& start : starts)
      if (start.of == &one) from.push_back(start.free);
    const std::optional<Point> failing = attack.from(from);
    if (!failing) return false;
    draw(*failing);
    return drawn && try_at(*drawn, confirmed_points, possible) == Outcome::decided;
  }

  void finish(bool possible) {
    if (!possible && off_particles_)
      return undetermined("the bodies as particles do not confirm it wherever it was tried");
    if (!possible && unconfirmed_)
      return undetermined("wherever it fails, it fails by less than the numbers there can confirm");
    if (!possible) {
      const ClaimFaults& faults = ground_.faults();
      const bool assuming = !claim_.assume.empty() || !situation_.assume.empty();
      undetermined(
          (!assuming ? "no values of the letters were found for which the statement makes sense"
           : all_letters().empty()
               ? "what it assumes does not hold at the values that all letters have (leave letters open, or change "
                 "their values)"
               : "no values of the letters were found that satisfy what is assumed") +
          (faults.empty() ? "" : ": " + faults.words(ground_.letters())));
      return;
    }
    result_.holds = true;
    result_.proved = proved_;
    list_assumptions();
    for (std::string& hold : assumed_holds(situation_, claim_)) result_.assumptions.push_back(std::move(hold));
  }

  // Decides a claim that has no formulas.
  void decide_by_numbers() {
    if (takes_derivatives(situation_, claim_))
      return undetermined("the claim takes a derivative by a letter, which formulas tell, and this has none");
    if (ground_.neglects())
      return undetermined(
          "squares of unknowns are neglected, and it has no formula from which these could be left out");
    const NumberTrials trials = try_by_numbers(statement_, situation_index_, claim_, ground_);
    if (trials.refuted) return refute(trials.refuted->first, trials.refuted->second);
    if (!trials.possible && trials.close)
      return undetermined(claims_stability(situation_, claim_)
                              ? "the linearised equations do not decide it"
                              : "wherever it was tried, it is too near the edge to be decided by numbers");
    if (trials.close_alike)
      return undetermined("where letters are equal, as at " + words_of_point(ground_.letters(), *trials.close_alike) +
                          ", it is too near the edge to be decided by numbers");
    if (trials.close_at_end)
      return undetermined("where what it assumes just holds, as at " +
                          words_of_point(ground_.letters(), *trials.close_at_end) + ", " +
                          (claims_stability(situation_, claim_) ? "the linearised equations do not decide it"
                                                                : "it is too near the edge to be decided by numbers"));
    finish(trials.possible);
    if (result_.holds && claims_stability(situation_, claim_))
      result_.proved =
          proves_steady_stability(claim_, ground_, trials.most_modes, tell_ ? &result_.stability : nullptr);
  }

  static bool is_turn_of_body(const Letter& open) { return open.unit.dimension == dimensions::none; }

  // The way to where a claim fails may end where it only just does. It is told at round numbers, if it fails by more
  // there. Returns whether there are such.
  bool refute_clearly(const ClaimTrials::Drawn& drawn) {
    if (takes_derivatives(situation_, claim_) || ground_.neglects() || !drawn.of) return false;
    const double least = std::min(trials_->margin(drawn).value_or(0), 0.0);
    for (int digits = 1; digits < shown_digits; ++digits) {
      Point round = drawn.free;
      for (auto& [letter, value] : round) value = rounded_to(value, digits);
      const std::optional<ClaimTrials::Drawn> there = trials_->at(*drawn.of, round);
      if (!there || !decided_alike(there->point) || !(trials_->margin(*there).value_or(0) < least)) continue;
      const std::optional<Verdict> numbers = ground_.verdict_at(claim_, formulas_->formulas(), there->point);
      const Verdict verdict = trials_->verdict(*there);
      if (!numbers || verdict.holds || verdict.close) continue;
      // Beside what is far larger rounding hides from the numbers what the formulas tell.
      if ((numbers->holds || numbers->close) && !verdict.difference && !found_alike(*numbers, verdict)) continue;
      refute_simply(there->point, verdict);
      return true;
    }
    return false;
  }

  // What fails with the bodies turned as they are drawn as well is refuted there, where their turns need no numbers.
  void refute_simply(const Point& point, const Verdict& verdict) {
    Point as_drawn = point;
    for (const Letter& open : formulas_->open())
      if (is_turn_of_body(open)) as_drawn[open.name] = 0;
    if (as_drawn == point || takes_derivatives(situation_, claim_) || ground_.neglects()) return refute(point, verdict);
    const std::optional<Verdict> numbers = ground_.verdict_at(claim_, formulas_->formulas(), as_drawn);
    as_drawn_ = numbers && !numbers->holds && !numbers->close;
    if (as_drawn_) return refute(as_drawn, *numbers);
    refute(point, verdict);
  }

  void refute(const Point& point, const Verdict& verdict) {
    result_.holds = false;
    std::set<std::string> used;
    if (formulas_)
      for (const ClaimTerm& term : formulas_->terms())
        for (const Formula* side : {&term.comparison.left, &term.comparison.right})
          for (const std::string& letter : side->letters()) used.insert(letter);
    for (const Letter& letter : all_letters()) {
      // The counterexample shows the letters that the file declares, and those for what it leaves open if the claim
      // depends on them.
      const std::vector<Letter>& own = ground_.letters();
      const bool declared = std::any_of(own.begin(), own.end(), [&](const Letter& known) {
        return known.name == letter.name && is_name(known.name);
      });
      if (!declared && formulas_ && (!used.contains(letter.name) || (as_drawn_ && is_turn_of_body(letter)))) continue;
      const auto value = point.find(letter.name);
      if (value != point.end()) result_.counterexample.push_back({letter.name, letter.unit, value->second});
    }
    if (!verdict.sides) return;
    result_.unit = situation_.habits.unit_for(verdict.dimension);
    result_.sides = {verdict.sides->first / result_.unit.factor, verdict.sides->second / result_.unit.factor};
    if (verdict.difference) result_.difference = *verdict.difference / result_.unit.factor;
    list_assumptions();
  }

  void list_assumptions() {
    for (const auto* list : {&situation_.assume, &claim_.assume})
      for (const Expression& assumption : *list) result_.assumptions.push_back(to_string(assumption));
    for (const Expression& square : situation_.neglect)
      result_.assumptions.push_back(to_string(square) + " is neglected");
    // The unknowns may be roots, which have values only if what stands under the root is not negative.
    std::set<std::string> known(result_.assumptions.begin(), result_.assumptions.end());
    for (const auto& [name, value] : ground_.unknowns())
      for (std::size_t k = 0; k < (value.is_vector() ? 3U : 1U); ++k)
        for (const std::string& one : (value.is_vector() ? value.vector[k] : value.number).root_assumptions())
          if (known.insert(one).second) result_.assumptions.push_back(one);
  }

  // Collects what a reader needs to follow the proof.
  void tell_formulas() {
    const FormulaLimitScope limits({most_formula_terms, most_telling_work});
    const PlainPointScope decisions(ground_.base_point());
    const DecisionScope elsewhere;
    const WorkedCase* one = worked_->cases().size() == 1 ? &worked_->cases().front() : nullptr;
    // New letters are renamed p1, p2 and so on.
    std::map<std::string, Formula> parts;
    for (std::size_t k = 0; one && k < one->letters().size(); ++k)
      parts[one->letters()[k]] = Formula::letter("p" + std::to_string(k + 1), poinsot::Sign::positive);
    // Beside a letter p of the author they would be misread.
    for (std::size_t k = 0; one && k < letters_.size(); ++k)
      if (!parts.empty() && letters_[k].name.front() == 'p') one = nullptr;
    try {
      if (one)
        for (const auto& [letter, value] : one->values())
          result_.assumed.emplace_back(letter, poinsot::substituted(value, parts));
      if (one)
        for (const auto& [name, part] : parts) result_.positive_parts.push_back(part.letters().front());
      for (const ClaimTerm& term : formulas_->terms()) {
        const FormulaComparison& comparison = term.comparison;
        SolvedClaim::Comparison told{comparison.left, comparison.right, std::string(symbol(comparison.relation)),
                                     term.dimension,  std::nullopt,     {},
                                     term.of,         term.component};
        if (one) told.reduced = poinsot::substituted(one->apply(comparison.difference()), parts);
        result_.comparisons.push_back(std::move(told));
      }
      add_rate_parts(formulas_->formulas(), claim_, result_.comparisons);
    } catch (const std::domain_error&) {
    } catch (const FormulaTooLarge&) {
      // The parts found so far are shown.
    }
  }

  const Statement& statement_;
  std::size_t situation_index_;
  const Situation& situation_;
  const Claim& claim_;
  ClaimGround& ground_;
  bool tell_;
  std::unique_ptr<ClaimInstant> formulas_;
  std::unique_ptr<WorkedAssumptions> worked_;
  bool unconfirmed_ = false;     // whether formulas refuted the claim at a point where numbers cannot tell
  bool off_particles_ = false;   // whether the bodies as particles did not confirm the numbers of a point
  std::vector<Letter> letters_;  // all letters that may occur in the formulas
  std::unique_ptr<ClaimTrials> trials_;
  struct DecidedSign {
    Formula of;
    int at_base;
    std::vector<std::string> letters;
  };
  std::vector<DecidedSign> decided_;
  bool proved_ = false;
  bool as_drawn_ = false;  // whether it is refuted with all bodies turned as they are drawn
  SolvedClaim result_;
};

}  // namespace

SolvedClaim solve_claim(const Statement& statement, std::size_t situation_index, const Claim& claim,
                        ClaimGround& ground, bool tell) {
  return ClaimSolver(statement, situation_index, claim, ground, tell).solve();
}

}  // namespace poinsot::problem
