#include "statement/claims.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <list>
#include <memory>
#include <random>

#include "statement/claim_instant.h"
#include "statement/formula_answers.h"
#include "statement/sample.h"

namespace poinsot::statement {
namespace {

constexpr int most_points = 400;          // at which a claim is tried that is not proved
constexpr int most_solved_points = 40;    // the same where each is a statement solved by numbers
constexpr int simple_points = 60;         // the first of them, of small whole numbers
constexpr int confirming_points = 2;      // at which the numbers must confirm a proof
constexpr double equal_tolerance = 1e-9;  // between two sides, relative
constexpr double most_seconds = 10;       // for the samples of a claim

// Values of letters, and of what the statement leaves open.
using Point = std::map<std::string, double>;

// What is found at one point.
struct Verdict {
  bool holds = true;
  bool close = false;  // so near the edge that rounding might decide
  std::optional<std::pair<double, double>> sides;
  Dimension dimension;
};

void judge(Verdict& verdict, double left, double right, Relation relation, double natural, const Dimension& dimension) {
  const double size = std::max({std::abs(left), std::abs(right), natural});
  const bool equal = std::abs(left - right) <= equal_tolerance * size;
  bool holds = false;
  switch (relation) {
    case Relation::equal:
      holds = equal;
      break;
    case Relation::less:
    case Relation::less_equal:
      holds = left < right;
      break;
    case Relation::greater:
    case Relation::greater_equal:
      holds = left > right;
      break;
  }
  if (relation != Relation::equal && equal) {
    verdict.close = true;
    return;
  }
  if (holds || !verdict.holds) return;
  verdict.holds = false;
  verdict.sides = {left, right};
  verdict.dimension = dimension;
}

class ClaimSolver {
 public:
  // All arguments must outlive it.
  ClaimSolver(const Statement& statement, std::size_t situation, const Claim& claim, const Settings& settings,
              const FormulaValues& exact)
      : statement_(statement),
        situation_(situation),
        problem_(statement.situations[situation].problem),
        claim_(claim),
        settings_(settings),
        exact_(exact) {
    for (const Letter& letter : problem_.letters)
      if (!settings_.contains(letter.name)) letters_.push_back(letter);
  }

  SolvedClaim solve() {
    require_quantity();
    const bool exact = std::all_of(settings_.begin(), settings_.end(),
                                   [&](const auto& setting) { return exact_.contains(setting.first); });
    if (exact && find_formulas()) {
      if (const auto unfixed = formulas_->unfixed(); !unfixed.empty())
        undetermined("it speaks of " + unfixed.front() + ", which the statement does not fix");
      else
        decide_by_formulas();
    } else {
      decide_by_numbers();
    }
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

  // The claim as formulas; false where it has none.
  bool find_formulas() {
    const auto deadline =
        std::chrono::steady_clock::now() + std::chrono::milliseconds(static_cast<int>(1000 * most_formula_seconds));
    const ExpressionLimitScope limits({most_formula_terms, deadline});
    for (const Letter& letter : letters_) values_[letter.name] = formula_of(letter);
    for (const auto& [name, value] : exact_) values_[name] = value;
    find_base();
    const PlainPointScope decisions(base_point_);
    try {
      formulas_ = std::make_unique<ClaimInstant>(problem_, claim_, values_, *base_);
      std::vector<std::string> positive;
      for (const Letter& letter : all_letters())
        if (!letter.either_sign && letter.unit.dimension != dimensions::angle) positive.push_back(letter.name);
      worked_ = std::make_unique<WorkedAssumptions>(formulas_->assumptions(), positive);
      try {
        proved_ = worked_->unsolved().empty() && std::all_of(formulas_->terms().begin(), formulas_->terms().end(),
                                                             [&](const ClaimTerm& term) { return is_proved(term); });
      } catch (const ExpressionTooLarge&) {
        // The reduction does not end within its bounds.
      }
      return true;
    } catch (const NoFormula&) {
    } catch (const std::domain_error&) {
    } catch (const ExpressionTooLarge&) {
    } catch (const StatementError&) {
      // The same fault is found by numbers, or it is none there.
    }
    formulas_.reset();
    return false;
  }

  // Letters without value, and what the statement leaves open.
  std::vector<Letter> all_letters() const {
    std::vector<Letter> all = letters_;
    if (formulas_) all.insert(all.end(), formulas_->open().begin(), formulas_->open().end());
    return all;
  }

  bool is_proved(const ClaimTerm& term) const {
    return worked_->proves(term.comparison) || (term.by_cosines && worked_->proves(*term.by_cosines));
  }

  // The statement solved at some point; where it holds for special values of the letters only, at one at which its
  // bodies are possible; else as a trial.
  void find_base() {
    std::unique_ptr<SolvedInstant> possible;
    Point possible_point;
    const When when{0, problem_.has_blow()};
    for (int attempt = 0; attempt < most_solved_points && !base_; ++attempt) {
      base_point_ = draw(letters_, attempt);
      // What refers to the settings must find them at their place.
      bases_.push_back(with_letters(base_point_));
      std::unique_ptr<SolvedInstant> found;
      try {
        found = std::make_unique<SolvedInstant>(problem_, bases_.back(), when, OpenChoice{});
        if (states_forces(problem_)) found->solve_forces();
        base_ = std::move(found);
      } catch (const StatementError&) {
        if (!found || possible) continue;
        possible = std::move(found);
        possible_point = base_point_;
      }
    }
    if (base_) return;
    if (possible) {
      base_ = std::move(possible);
      base_point_ = possible_point;
      return;
    }
    OpenChoice choice;
    choice.trial = true;
    base_ = std::make_unique<SolvedInstant>(problem_, bases_.back(), when, choice);
  }

  Settings with_letters(const Point& point) const {
    Settings settings = settings_;
    for (const Letter& letter : problem_.letters)
      if (const auto value = point.find(letter.name); value != point.end())
        settings[letter.name] = Value<double>::of_number(value->second, letter.unit.dimension);
    return settings;
  }

  // Small whole numbers first, then quarters; angles in multiples of 15 deg or quarters of a radian. At every other
  // point numbers that a rigid body is likely to have: moments of inertia alike, products and offsets small beside
  // them; or a slender body, one of whose moments is small.
  Point draw(const std::vector<Letter>& letters, int attempt) const {
    std::mt19937_64 random(7000 + static_cast<std::uint64_t>(attempt));
    const auto among = [&](int low, int high) { return std::uniform_int_distribution<int>(low, high)(random); };
    Point point;
    for (const Letter& letter : letters) {
      double value = attempt < simple_points ? among(1, 3 + attempt / 10) : among(1, 24) / 4.0;
      const bool angle = letter.unit.dimension == dimensions::angle;
      if (attempt % 2 == 1) {
        const Dimension& kind = letter.unit.dimension;
        if (kind == dimensions::moment_of_inertia)
          value = letter.either_sign ? among(1, 4) / 4.0 : 4 + among(0, 8) / 4.0;
        if (kind == dimensions::mass) value = among(1, 4) / 2.0;
        if (kind == dimensions::length) value = among(1, 4) / 8.0;
        if (attempt % 4 == 3) {
          if (kind == dimensions::moment_of_inertia) value = among(0, 2) == 0 ? among(1, 2) / 4.0 : 3 + attempt % 3;
          if (kind == dimensions::mass) value = among(1, 2) / 4.0;
          if (letter.either_sign && (kind == dimensions::moment_of_inertia || kind == dimensions::length)) value = 0;
        }
      }
      if (angle) value = letter.unit.text == "deg" ? 15 * among(1, 11) : among(1, 12) / 4.0;
      if ((letter.either_sign || (angle && attempt % 3 == 2)) && among(0, 1) == 0) value = -value;
      if (letter.either_sign && attempt % 4 == 2 && among(0, 3) == 0) value = 0;
      point[letter.name] = value * letter.unit.factor;
    }
    return point;
  }

  // A point that satisfies what is worked into the letters.
  std::optional<Point> draw_formula_point(int attempt) const {
    std::vector<Letter> letters;
    for (const Letter& letter : all_letters())
      if (!worked_->values().contains(letter.name)) letters.push_back(letter);
    for (const std::string& part : worked_->letters()) letters.push_back({part, {}, {}});
    Point point = draw(letters, attempt);
    // Parts of a letter are small as often as large.
    if (attempt % 2 == 1)
      for (const std::string& part : worked_->letters()) point[part] /= 4;
    Point all = point;
    for (const auto& [letter, value] : worked_->values()) {
      all[letter] = value_at(value, point);
      if (!std::isfinite(all[letter])) return std::nullopt;
    }
    for (const std::string& part : worked_->letters()) all.erase(part);
    for (const Letter& letter : all_letters())
      if (!letter.either_sign && letter.unit.dimension != dimensions::angle && !(all.at(letter.name) > 0))
        return std::nullopt;
    Verdict assumed;
    // Equations that are worked into the letters hold but for rounding.
    for (const FormulaComparison& assumption : formulas_->assumptions())
      if (assumption.relation != Relation::equal || !worked_->unsolved().empty())
        judge(assumed, value_at(assumption.left, all), value_at(assumption.right, all), assumption.relation, 0, {});
    if (!assumed.holds || assumed.close) return std::nullopt;
    return all;
  }

  Verdict by_formulas(const Point& point) const {
    Verdict verdict;
    for (const ClaimTerm& term : formulas_->terms()) {
      // What vanishes identically does so but for rounding.
      if (term.comparison.relation == Relation::equal && worked_->proves(term.comparison)) continue;
      const double left = value_at(term.comparison.left, point), right = value_at(term.comparison.right, point);
      if (!std::isfinite(left) || !std::isfinite(right))
        verdict.close = true;
      else
        judge(verdict, left, right, term.comparison.relation, 0, term.dimension);
    }
    return verdict;
  }

  // The claim in the statement solved by numbers at that point; nothing where it cannot be solved, or the claim takes
  // derivatives by letters and the point is possible.
  std::optional<Verdict> confirmed(const Point& point, const Verdict& expected) const {
    try {
      const Settings settings = with_letters(point);
      std::unique_ptr<SolvedInstant> instant;
      if (problem_.has_blow()) {
        instant = std::make_unique<SolvedInstant>(problem_, settings, When{0, true}, OpenChoice{});
      } else {
        MotionState state;
        if (const auto time = point.find("time"); time != point.end()) state.time = time->second;
        for (const Formula& q : formulas_->positions()) state.q.push_back(value_at(q, point));
        for (const Formula& v : formulas_->velocities()) state.v.push_back(value_at(v, point));
        instant = std::make_unique<SolvedInstant>(problem_, settings, state, OpenChoice{});
      }
      if (takes_derivatives(problem_, claim_)) return expected;
      return by_numbers(*instant);
    } catch (const StatementError&) {
      return std::nullopt;
    }
  }

  Verdict by_numbers(SolvedInstant& instant) const {
    Verdict verdict;
    for (const Expression& expression : claim_.of) judge_expression(verdict, instant, expression, claim_.axes);
    return verdict;
  }

  void judge_expression(Verdict& verdict, SolvedInstant& instant, const Expression& expression,
                        const std::optional<Expression>& axes) const {
    const auto value = [&](const Expression& part) { return instant.raw(part, axes, nullptr); };
    const Comparison* comparison = expression.as<Comparison>();
    if (!comparison) {
      const Value<double> truth = value(expression);
      if (!truth.is_boolean())
        fail(problem_.file, expression.mark(), "'" + to_string(expression) + "' claims nothing",
             "compare it with something");
      verdict.holds = verdict.holds && truth.truth;
      return;
    }
    std::vector<Value<double>> sides;
    for (const Expression& operand : comparison->operands) sides.push_back(value(operand));
    for (std::size_t i = 0; i < comparison->relations.size(); ++i) {
      const Value<double>&left = sides[i], &right = sides[i + 1];
      const bool zero = (left.is_vector() && right.is_number() && right.bare && right.number == 0) ||
                        (right.is_vector() && left.is_number() && left.bare && left.number == 0);
      if (i == 0 && !zero) value(expression);
      const Dimension dimension = left.bare ? right.dimension : left.dimension;
      const double natural = instant.natural_size(dimension);
      if (!left.is_vector() && !right.is_vector()) {
        judge(verdict, left.number, right.number, comparison->relations[i], natural, dimension);
        continue;
      }
      const double size = std::max({natural, norm(left.vector), norm(right.vector)});
      for (std::size_t k = 0; k < 3; ++k)
        judge(verdict, left.vector[k], right.vector[k], comparison->relations[i], size, dimension);
    }
  }

  void decide_by_formulas() {
    int confirmed_points = 0;
    bool possible = false;
    const auto end =
        std::chrono::steady_clock::now() + std::chrono::milliseconds(static_cast<int>(1000 * most_seconds));
    for (int attempt = 0; attempt < most_points && std::chrono::steady_clock::now() < end; ++attempt) {
      const std::optional<Point> point = draw_formula_point(attempt);
      if (!point) continue;
      const Verdict verdict = by_formulas(*point);
      if (verdict.close && verdict.holds) continue;
      const bool check = !verdict.holds || (proved_ && confirmed_points < confirming_points) || !possible;
      if (!check) {
        if (proved_) break;
        continue;
      }
      const std::optional<Verdict> numbers = confirmed(*point, verdict);
      if (!numbers || numbers->close) continue;
      possible = true;
      if (numbers->holds != verdict.holds || (proved_ && !verdict.holds)) {
        undetermined("formulas and numbers do not agree on it");
        return;
      }
      ++confirmed_points;
      if (!verdict.holds) {
        refute(*point, verdict);
        return;
      }
    }
    finish(possible);
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
    const auto end =
        std::chrono::steady_clock::now() + std::chrono::milliseconds(static_cast<int>(1000 * most_seconds));
    for (int attempt = 0; attempt < most_solved_points && std::chrono::steady_clock::now() < end; ++attempt) {
      const Point point = draw(letters_, attempt);
      const Settings settings = with_letters(point);
      const OpenChoice choice{
          .seed = 100 + static_cast<std::uint64_t>(attempt), .velocities = true, .direction = OpenChoice::every};
      try {
        SolvedInstant start(problem_, settings, When{0, problem_.has_blow()}, choice);
        if (states_forces(problem_)) start.solve_forces();
        Verdict assumed;
        for (const Expression& expression : problem_.assume) judge_expression(assumed, start, expression, std::nullopt);
        for (const Expression& expression : claim_.assume) judge_expression(assumed, start, expression, claim_.axes);
        understood = true;
        if (!assumed.holds || assumed.close) continue;
        Verdict verdict = by_numbers(start);
        if (along && verdict.holds && attempt < 10) {
          // Further on along the motion the pose is another.
          AllSettings all(statement_.situations.size(), settings);
          Sample sample(statement_, all, choice);
          for (const double time : {0.3, 0.8}) verdict = by_numbers(sample.instant_at(situation_, time));
        }
        if (verdict.close && verdict.holds) continue;
        possible = true;
        if (verdict.holds) continue;
        refute(point, verdict);
        return;
      } catch (const StatementError& error) {
        fault = error;
      }
      // Without letters nothing varies but what is open.
      if (letters_.empty() && attempt > 8) break;
    }
    // What fails everywhere, before it is looked whether the assumptions hold, is no matter of values.
    if (!possible && fault && (!understood || (claim_.assume.empty() && problem_.assume.empty())))
      throw StatementError(*fault);
    finish(possible);
  }

  void refute(const Point& point, const Verdict& verdict) {
    result_.holds = false;
    const std::vector<Letter> letters = all_letters();
    std::set<std::string> used;
    if (formulas_)
      for (const ClaimTerm& term : formulas_->terms())
        for (const Formula* side : {&term.comparison.left, &term.comparison.right})
          for (const std::string& letter : side->letters()) used.insert(letter);
    for (const Letter& letter : letters) {
      // Those that the file declares, and what it leaves open where the claim depends on it.
      const bool declared = std::any_of(letters_.begin(), letters_.end(), [&](const Letter& known) {
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
    std::vector<std::string> all;
    for (const auto* list : {&problem_.assume, &claim_.assume})
      for (const Expression& assumption : *list) all.push_back(to_string(assumption));
    result_.assumptions = all;
  }

  const Statement& statement_;
  std::size_t situation_;
  const Problem& problem_;
  const Claim& claim_;
  const Settings& settings_;
  const FormulaValues& exact_;
  std::vector<Letter> letters_;  // without value
  FormulaValues values_;
  Point base_point_;
  std::list<Settings> bases_;
  std::unique_ptr<SolvedInstant> base_;
  std::unique_ptr<ClaimInstant> formulas_;
  std::unique_ptr<WorkedAssumptions> worked_;
  bool proved_ = false;
  SolvedClaim result_;
};

std::size_t situation_of_claim(const Statement& statement, const Claim& claim) {
  if (claim.situation.empty()) {
    if (statement.situations.size() == 1) return 0;
    fail(statement.file, claim.mark, "in which situation does claim '" + claim.name + "' hold?",
         "write {claim: ..., situation: " + statement.situations.front().name + "}");
  }
  std::vector<std::string> names;
  for (std::size_t i = 0; i < statement.situations.size(); ++i) {
    if (statement.situations[i].name == claim.situation) return i;
    names.push_back(statement.situations[i].name);
  }
  fail(statement.file, claim.situation_mark, "there is no situation '" + claim.situation + "'",
       did_you_mean(claim.situation, names));
}

}  // namespace

std::vector<SolvedClaim> solve_claims(const Statement& statement, const std::vector<Settings>& settings,
                                      const FormulaValues& exact) {
  if (statement.claims.empty()) return {};
  Statement prepared = statement;
  for (Situation& situation : prepared.situations) situation.problem = with_letters_for_any(situation.problem);
  std::vector<SolvedClaim> solved;
  for (const Claim& claim : prepared.claims) {
    const std::size_t situation = situation_of_claim(prepared, claim);
    solved.push_back(ClaimSolver(prepared, situation, claim, settings[situation], exact).solve());
  }
  return solved;
}

}  // namespace poinsot::statement
