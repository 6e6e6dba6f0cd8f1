#include "statement/claim_solver.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <set>

#include "poinsot/math/expression_decision.h"
#include "poinsot/math/expression_sign.h"
#include "statement/claim_letters.h"
#include "statement/claim_stability.h"
#include "statement/formula_answers.h"
#include "statement/reader.h"
#include "statement/sample.h"

namespace poinsot::statement {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int most_points = 400;      // at which a claim is tried that is not proved
constexpr int confirming_points = 2;  // at which the numbers must confirm a proof
constexpr double most_seconds = 10;   // for the samples of a claim
constexpr int most_edge_points = 4;   // from which edges are sought
constexpr std::size_t most_edge_terms = 60;
constexpr std::size_t most_edge_letters = 3;  // that are moved, in turn
constexpr double most_edge_seconds = 0.05;

Clock::time_point in_seconds(double seconds) {
  return Clock::now() + std::chrono::milliseconds(static_cast<int>(1000 * seconds));
}

bool is_strict(Relation relation) { return relation == Relation::less || relation == Relation::greater; }

class ClaimSolver {
 public:
  ClaimSolver(const Statement& statement, std::size_t situation, const Claim& claim, ClaimGround& ground)
      : statement_(statement), situation_(situation), problem_(ground.problem()), claim_(claim), ground_(ground) {}

  SolvedClaim solve() {
    require_quantity();
    if (!find_formulas())
      decide_by_numbers();
    else if (const auto unfixed = formulas_->unfixed(); !unfixed.empty())
      undetermined("it speaks of " + unfixed.front() + ", which the statement does not fix");
    else
      decide_by_formulas();
    return std::move(result_);
  }

 private:
  void require_quantity() const {
    for (const Expression& expression : claim_.of)
      if (asks_model(problem_, expression)) return;
    fail(problem_.file, claim_.mark,
         "'" + claim_.name + "' claims nothing of the model: it compares formulas of the data",
         "claim something of a quantity, such as angular_momentum(BODY about POINT)");
  }

  void undetermined(const std::string& reason) {
    result_.state = AskState::undetermined;
    result_.reason = reason;
  }

  // The claim as formulas, proved or not; false where it has none.
  bool find_formulas() {
    const ExpressionLimitScope limits({most_formula_terms, in_seconds(most_formula_seconds)});
    try {
      ClaimFormulas* formulas = ground_.formulas(is_along_motion(problem_, claim_));
      if (!formulas) return false;
      const PlainPointScope decisions(ground_.base_point());
      formulas_ = std::make_unique<ClaimInstant>(*formulas, claim_);
      std::vector<std::string> positive;
      for (const Letter& letter : all_letters())
        if (is_positive(letter)) positive.push_back(letter.name);
      worked_ = std::make_unique<WorkedAssumptions>(formulas_->assumptions(), positive);
    } catch (const NoFormula&) {
      return formulas_ = nullptr, false;
    } catch (const std::domain_error&) {
      return formulas_ = nullptr, false;
    } catch (const ExpressionTooLarge&) {
      return formulas_ = nullptr, false;
    } catch (const StatementError&) {
      // The same fault is found by numbers, or it is none there.
      return formulas_ = nullptr, false;
    }
    try {
      proved_ = is_proved();
    } catch (const ExpressionTooLarge&) {
      // The reduction does not end within its bounds.
    } catch (const std::domain_error&) {
      // It needs a formula where there is none.
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

  // Where the formulas were decided.
  int base_sign(const Formula& sign) const {
    const PlainPointScope base(ground_.base_point());
    return plain(sign) < 0 ? -1 : 1;
  }

  static bool is_positive(const Letter& letter) {
    return !letter.either_sign && letter.unit.dimension != dimensions::angle;
  }

  // Letters without value, and what the statement leaves open.
  std::vector<Letter> all_letters() const {
    std::vector<Letter> all = ground_.letters();
    if (formulas_) all.insert(all.end(), formulas_->open().begin(), formulas_->open().end());
    return all;
  }

  // A point of one of the cases, on which what is assumed holds.
  struct Drawn {
    Point point;
    const WorkedCase* of = nullptr;
    Point free;         // the letters of the case that were drawn
    bool edge = false;  // chosen so that sides meet
  };
  std::optional<Drawn> draw(int attempt) const {
    const std::vector<WorkedCase>& cases = worked_->cases();
    if (cases.empty()) return std::nullopt;
    const WorkedCase& one = cases[attempt % 3 != 0 ? 0 : static_cast<std::size_t>(attempt / 3) % cases.size()];
    std::vector<Letter> letters;
    for (const Letter& letter : all_letters())
      if (!one.values().contains(letter.name)) letters.push_back(letter);
    for (const std::string& part : one.letters())
      if (!one.values().contains(part)) letters.push_back({part, {}, {}});
    Point free = draw_point(letters, attempt);
    // Parts of a letter are small as often as large.
    if (attempt % 2 == 1)
      for (const std::string& part : one.letters())
        if (free.contains(part)) free[part] /= 4;
    return completed(one, std::move(free));
  }
  std::optional<Drawn> completed(const WorkedCase& one, Point free, bool edge = false) const {
    Point all = free;
    for (const auto& [letter, value] : one.values()) {
      all[letter] = value_at(value, free);
      if (!std::isfinite(all[letter])) return std::nullopt;
    }
    for (const std::string& part : one.letters()) all.erase(part);
    for (const Letter& letter : all_letters())
      if (is_positive(letter) && !(all.at(letter.name) > 0)) return std::nullopt;
    Drawn drawn{std::move(all), &one, std::move(free), edge};
    // Equations that are worked into the letters hold but for rounding.
    for (const FormulaComparison& assumption : formulas_->assumptions())
      if (assumption.relation != Relation::equal || !one.unsolved().empty()) {
        const Verdict assumed = compared(assumption, drawn, {});
        if (!assumed.holds || (assumed.close && !assumed.exact)) return std::nullopt;
      }
    return drawn;
  }

  // The difference of two sides at a point, where rounding cannot tell it from zero.
  static std::optional<Formula> exactly(const Formula& difference, const Drawn& drawn) {
    std::map<std::string, Formula> numbers;
    for (const auto& [letter, value] : drawn.free) numbers[letter] = Formula(value);
    try {
      return poinsot::substituted(drawn.of->apply(difference), numbers);
    } catch (const std::domain_error&) {
      return std::nullopt;
    } catch (const ExpressionTooLarge&) {
      // As the sine of a number with many digits.
      return std::nullopt;
    }
  }

  // One comparison at a point; where rounding might decide, and at edges, it is exact if that can be had.
  static Verdict compared(const FormulaComparison& comparison, const Drawn& drawn, const Dimension& dimension) {
    Verdict verdict;
    const double left = value_at(comparison.left, drawn.point), right = value_at(comparison.right, drawn.point);
    if (!std::isfinite(left) || !std::isfinite(right)) {
      verdict.close = true;
      return verdict;
    }
    verdict.judge(left, right, comparison.relation, 0, dimension);
    if (comparison.relation == Relation::equal || (!verdict.close && !drawn.edge)) return verdict;
    const auto difference = exactly(comparison.difference(), drawn);
    if (!difference || !difference->is_number()) return verdict;
    verdict = {};
    verdict.close = verdict.exact = true;
    const double exact = plain(*difference);
    const bool greater = comparison.relation == Relation::greater || comparison.relation == Relation::greater_equal;
    if (exact == 0 ? is_strict(comparison.relation) : (exact > 0) != greater) verdict.refute(left, right, dimension);
    return verdict;
  }

  Verdict by_formulas(const Drawn& drawn) const {
    Verdict verdict;
    for (const ClaimTerm& term : formulas_->terms()) {
      // What vanishes identically does so but for rounding.
      if (term.comparison.relation == Relation::equal && drawn.of->proves(term.comparison)) continue;
      const Verdict own = compared(term.comparison, drawn, term.dimension);
      if (!own.holds && verdict.holds) {
        verdict = own;
      } else if (own.holds && own.close && !own.exact) {
        verdict.close = true;
      }
    }
    return verdict;
  }

  // Whether the formulas hold there: they were decided on signs.
  bool decided_alike(const Point& point) const {
    return std::all_of(formulas_->decisions().signs.begin(), formulas_->decisions().signs.end(),
                       [&](const Formula& sign) {
                         const std::vector<std::string> letters = sign.letters();
                         return std::all_of(letters.begin(), letters.end(),
                                            [&](const std::string& letter) { return point.contains(letter); }) &&
                                value_at(sign, point) * base_sign(sign) >= 0;
                       });
  }

  enum class Outcome { skipped, holds, decided };

  Outcome try_at(const Drawn& drawn, int& confirmed_points, bool& possible) {
    const bool by_digits = formulas_->decisions().zeros_by_digits;
    const bool formulas_hold = decided_alike(drawn.point) && !by_digits;
    Verdict verdict = by_formulas(drawn);
    if (verdict.close && verdict.holds && formulas_hold) return Outcome::skipped;
    const bool check =
        !formulas_hold || !verdict.holds || (proved_ && confirmed_points < confirming_points) || !possible;
    if (!check) return proved_ ? Outcome::decided : Outcome::holds;
    const std::optional<Verdict> numbers = ground_.verdict_at(claim_, formulas_->formulas(), drawn.point);
    if (!numbers) return Outcome::skipped;
    if (takes_derivatives(problem_, claim_)) {
      // They have no numbers: where the statement makes sense, the formulas count.
      if (!formulas_hold) return Outcome::skipped;
    } else if (!formulas_hold) {
      if (numbers->close) return Outcome::skipped;
      verdict = *numbers;
    } else if (numbers->close ? !verdict.close : numbers->holds != verdict.holds) {
      if (numbers->close) return Outcome::skipped;
      undetermined("formulas and numbers do not agree on it");
      return Outcome::decided;
    }
    possible = true;
    ++confirmed_points;
    if (proved_ && !verdict.holds) {
      undetermined("formulas and numbers do not agree on it");
      return Outcome::decided;
    }
    if (verdict.holds) return Outcome::holds;
    refute(drawn.point, verdict);
    return Outcome::decided;
  }

  void decide_by_formulas() {
    int confirmed_points = 0, searched_edges = 0;
    bool possible = false;
    const auto end = in_seconds(most_seconds);
    // While it lives, what vanishes at one point alone is not taken for zero.
    const DecisionScope elsewhere;
    for (int attempt = 0; attempt < most_points && Clock::now() < end; ++attempt) {
      const std::optional<Drawn> drawn = draw(attempt);
      if (!drawn) continue;
      const Outcome outcome = try_at(*drawn, confirmed_points, possible);
      if (outcome == Outcome::decided && !proved_) return;
      if (outcome == Outcome::decided && result_.state == AskState::undetermined) return;
      if (outcome == Outcome::decided) break;
      if (proved_ || attempt % 3 != 0 || searched_edges++ >= most_edge_points) continue;
      for (const Drawn& edge : at_edges(*drawn, attempt / 3))
        if (try_at(edge, confirmed_points, possible) == Outcome::decided) return;
    }
    finish(possible);
  }

  // Where the sides of inequalities meet: factors of their differences, in each case.
  struct Edge {
    const WorkedCase* of;
    Formula factor;
  };
  const std::vector<Edge>& edges() {
    if (edges_) return *edges_;
    edges_.emplace();
    const ExpressionLimitScope limits({most_edge_terms, in_seconds(most_edge_seconds)});
    for (const WorkedCase& one : worked_->cases())
      for (const ClaimTerm& term : formulas_->terms()) {
        if (term.comparison.relation == Relation::equal) continue;
        try {
          const Formula difference = one.apply(term.comparison.difference());
          if (difference.terms() > most_edge_terms) continue;
          for (const Formula& factor : vanishing_factors(difference)) edges_->push_back({&one, factor});
        } catch (const std::domain_error&) {
        } catch (const ExpressionTooLarge&) {
          // Such a case is tried at random points alone.
        }
      }
    return *edges_;
  }

  // Points where the sides of an inequality meet, and on either side of these: one letter moved, the others kept. What
  // an assumption sets apart meets too, where it allows that.
  std::vector<Drawn> at_edges(const Drawn& from, int attempt) {
    std::vector<Drawn> found;
    const auto add = [&](const std::string& letter, double place) {
      Point moved = from.free;
      moved[letter] = place;
      if (auto drawn = completed(*from.of, std::move(moved), true)) found.push_back(std::move(*drawn));
    };
    const std::vector<std::string>& parts = from.of->letters();
    const auto is_part = [&](const std::string& letter) {
      return std::find(parts.begin(), parts.end(), letter) != parts.end();
    };
    if (from.of->is_weak())
      for (const auto& [letter, value] : from.free)
        if (is_part(letter)) add(letter, 0);
    const ExpressionLimitScope limits({most_edge_terms, in_seconds(most_edge_seconds)});
    for (const Edge& edge : edges()) {
      if (edge.of != from.of) continue;
      const std::vector<std::string> letters = edge.factor.letters();
      for (std::size_t k = 0; k < std::min(letters.size(), most_edge_letters); ++k) try {
          const std::string& letter = letters[(static_cast<std::size_t>(attempt) + k) % letters.size()];
          std::map<std::string, Formula> others;
          for (const auto& [name, number] : from.free)
            if (name != letter) others[name] = Formula(number);
          const Formula line = poinsot::substituted(edge.factor, others);
          const Formula slope = derivative(line, letter);
          if (!slope.is_number() || slope.is_zero()) continue;
          const Formula start = poinsot::substituted(line, {{letter, Formula(0)}});
          if (!start.is_number()) continue;
          const double root = plain(-start / slope);
          for (const double place : {root, root * (1 + 1e-6) + 1e-9, root * (1 - 1e-6) - 1e-9})
            if (!is_part(letter) || place > 0) add(letter, place);
        } catch (const std::domain_error&) {
        } catch (const ExpressionTooLarge&) {
          // No value there, or none that is found soon.
        }
    }
    return found;
  }

  void finish(bool possible) {
    if (!possible) {
      undetermined(claim_.assume.empty() && problem_.assume.empty()
                       ? "no values of the letters were found for which the statement makes sense"
                       : "no values of the letters were found that satisfy what is assumed");
      return;
    }
    result_.holds = true;
    result_.proved = proved_;
    list_assumptions();
    for (std::string& hold : assumed_holds(problem_, claim_)) result_.assumptions.push_back(std::move(hold));
  }

  bool claims_stability() const {
    return problem_.steady && std::all_of(claim_.of.begin(), claim_.of.end(), [](const Expression& expression) {
             const Call* call = expression.as<Call>();
             return call && call->function == "stable";
           });
  }
  void count_modes(SolvedInstant& start) {
    std::size_t modes = 0;
    for (const solve::Mode& mode : start.linearisation(problem_.steady->mark).modes)
      modes += mode.frequency > 0 ? 2 : 1;
    most_modes_ = std::max(most_modes_, modes);
  }

  // Where all that is claimed is that something is stable, which numbers have confirmed at many points.
  void prove_stability() {
    if (!claims_stability() || most_modes_ == 0 || problem_.has_blow()) return;
    for (const Frame& frame : problem_.frames)
      if (frame.name == problem_.steady->frame && !frame.rides_on.empty()) return;
    const ExpressionLimitScope limits({most_formula_terms, in_seconds(most_formula_seconds)});
    try {
      ClaimFormulas* formulas = ground_.formulas(false);
      if (!formulas) return;
      const PlainPointScope decisions(ground_.base_point());
      const DecisionScope taken;
      Claim assumed = claim_;
      assumed.of.clear();
      const ClaimInstant instant(*formulas, assumed);
      std::vector<std::string> positive;
      for (const Letter& letter : ground_.letters())
        if (is_positive(letter)) positive.push_back(letter.name);
      const WorkedAssumptions worked(instant.assumptions(), positive);
      const MachineOf<Formula>& machine = formulas->instant().machine();
      SteadyFormulas motion{machine,
                            formulas->positions(),
                            formulas->velocities(),
                            machine.index.at(problem_.steady->frame),
                            still_coordinates(ground_.base().machine()),
                            0};
      for (const auto& rate : machine.accelerations) motion.held.push_back(rate.velocity);
      std::sort(motion.held.begin(), motion.held.end());
      motion.held.erase(std::unique(motion.held.begin(), motion.held.end()), motion.held.end());
      // What has no rate of growth among the modes are displacements to the same motion.
      const std::size_t all = 2 * (motion.v.size() - motion.held.size());
      if (most_modes_ > all) return;
      motion.symmetries = all - most_modes_;
      const bool decided =
          instant.decisions().signs.empty() && !instant.decisions().zeros_by_digits && taken.signs().empty();
      result_.proved = decided && proves_stability(motion, worked) && !taken.zeros_by_digits();
    } catch (const NoFormula&) {
    } catch (const std::domain_error&) {
    } catch (const ExpressionTooLarge&) {
    } catch (const StatementError&) {
      // Then it stays with the samples.
    }
  }

  // Where there are no formulas: statements solved by numbers, with open velocities drawn too.
  void decide_by_numbers() {
    if (takes_derivatives(problem_, claim_)) {
      undetermined("the claim takes a derivative by a letter, which formulas tell, and this has none");
      return;
    }
    bool possible = false, understood = false;
    std::optional<StatementError> fault;
    const bool along = is_along_motion(problem_, claim_);
    const auto end = in_seconds(most_seconds);
    for (int attempt = 0; attempt < most_solved_points && Clock::now() < end; ++attempt) {
      const Point point = draw_point(ground_.letters(), attempt);
      const Settings settings = ground_.with_letters(point);
      const OpenChoice choice{
          .seed = 100 + static_cast<std::uint64_t>(attempt), .velocities = true, .direction = OpenChoice::every};
      try {
        SolvedInstant start(problem_, settings, When{0, problem_.has_blow()}, choice);
        if (states_forces(problem_)) start.solve_forces();
        std::unique_ptr<SolvedInstant> before;
        const ClaimElsewhere elsewhere = [&](const At& at, const Mark& mark) {
          if (!problem_.has_blow() || (at.instant != "before" && at.instant != "after"))
            fail(problem_.file, mark, "a claim is made of one instant, or of those before and after a blow",
                 "remove @ " + at.instant);
          if (at.instant == "after") return start.raw(at.expression, claim_.axes, nullptr);
          if (!before) before = std::make_unique<SolvedInstant>(problem_, settings, When{0, false}, choice);
          return before->raw(at.expression, claim_.axes, nullptr);
        };
        const auto judge = [&](Verdict& verdict, const Expression& expression, const std::optional<Expression>& axes) {
          judge_numbers(verdict, problem_, start, elsewhere, expression, axes);
        };
        Verdict assumed;
        for (const Expression& expression : problem_.assume) judge(assumed, expression, std::nullopt);
        for (const Expression& expression : claim_.assume) judge(assumed, expression, claim_.axes);
        understood = true;
        if (!assumed.holds || assumed.close) continue;
        Verdict verdict;
        for (const Expression& expression : claim_.of) judge(verdict, expression, claim_.axes);
        if (along && verdict.holds && attempt < 10) {
          // Further on along the motion the pose is another.
          AllSettings all(statement_.situations.size(), settings);
          Sample sample(statement_, all, choice);
          for (const double time : {0.3, 0.8}) {
            verdict = {};
            for (const Expression& expression : claim_.of)
              judge_numbers(verdict, problem_, sample.instant_at(situation_, time), nullptr, expression, claim_.axes);
            if (!verdict.holds) break;
          }
        }
        if (verdict.close && verdict.holds) continue;
        possible = true;
        if (verdict.holds && claims_stability()) count_modes(start);
        if (verdict.holds) continue;
        refute(point, verdict);
        return;
      } catch (const StatementError& error) {
        fault = error;
      }
      // Without letters nothing varies but what is open.
      if (ground_.letters().empty() && attempt > 8) break;
    }
    // What fails everywhere, before it is looked whether the assumptions hold, is no matter of values.
    if (!possible && fault && (!understood || (claim_.assume.empty() && problem_.assume.empty())))
      throw StatementError(*fault);
    finish(possible);
    if (result_.holds && !result_.proved) prove_stability();
  }

  void refute(const Point& point, const Verdict& verdict) {
    result_.holds = false;
    std::set<std::string> used;
    if (formulas_)
      for (const ClaimTerm& term : formulas_->terms())
        for (const Formula* side : {&term.comparison.left, &term.comparison.right})
          for (const std::string& letter : side->letters()) used.insert(letter);
    for (const Letter& letter : all_letters()) {
      // Those that the file declares, and what it leaves open where the claim depends on it.
      const std::vector<Letter>& own = ground_.letters();
      const bool declared = std::any_of(own.begin(), own.end(), [&](const Letter& known) {
        return known.name == letter.name && is_name(known.name);
      });
      if (!declared && formulas_ && !used.contains(letter.name)) continue;
      const auto value = point.find(letter.name);
      if (value != point.end()) result_.counterexample.push_back({letter.name, letter.unit, value->second});
    }
    if (!verdict.sides) return;
    result_.unit = problem_.habits.unit_for(verdict.dimension);
    result_.sides = {verdict.sides->first / result_.unit.factor, verdict.sides->second / result_.unit.factor};
    list_assumptions();
  }

  void list_assumptions() {
    for (const auto* list : {&problem_.assume, &claim_.assume})
      for (const Expression& assumption : *list) result_.assumptions.push_back(to_string(assumption));
  }

  const Statement& statement_;
  std::size_t situation_;
  const Problem& problem_;
  const Claim& claim_;
  ClaimGround& ground_;
  std::unique_ptr<ClaimInstant> formulas_;
  std::unique_ptr<WorkedAssumptions> worked_;
  bool proved_ = false;
  std::optional<std::vector<Edge>> edges_;
  std::size_t most_modes_ = 0;  // of the steady motion, at the samples where it is stable
  SolvedClaim result_;
};

}  // namespace

SolvedClaim solve_claim(const Statement& statement, std::size_t situation, const Claim& claim, ClaimGround& ground) {
  return ClaimSolver(statement, situation, claim, ground).solve();
}

}  // namespace poinsot::statement
