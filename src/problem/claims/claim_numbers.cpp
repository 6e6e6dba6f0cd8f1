#include "problem/claims/claim_numbers.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "poinsot/engine/work/work.h"
#include "problem/claims/claim_attack.h"
#include "problem/claims/claim_letters.h"
#include "problem/course/motion_witness.h"
#include "problem/language/diagnostic.h"
#include "problem/unknowns/sample.h"

namespace poinsot::problem {
namespace {

constexpr Work most_number_work = 10'000'000'000;  // of the samples of a claim
constexpr int most_motions = 10;      // points from which a claim that is meant along the motion is followed in time
constexpr int most_long_motions = 3;  // of these, until a machine has gone round
constexpr Work most_attack_work = 300'000'000;  // on making smaller by what a claim holds
constexpr int most_edge_starts = 4;  // points from which letters are moved, one by one, to where the assumptions end
// Towards an edge in growing steps, until one is beyond it; halvings then come to a thousandth of that step.
constexpr int most_edge_steps = 6, most_edge_halvings = 10;
// Without letters only what the statement leaves open can vary.
constexpr int most_points_without_letters = 10;
// Of the size of a quantity: one that particles tell otherwise by more decides nothing. Letters that are far apart
// leave more than the 1e-8 that answers are held to; a wrong sign is a whole.
constexpr double told_wrongly = 1e-6;

// The number of eigenvalues of the linearised steady motion, where each oscillation has two.
std::size_t modes_of(const Situation& situation, SolvedInstant& start) {
  std::size_t modes = 0;
  for (const solve::Mode& mode : start.linearisation(situation.steady->mark).modes) modes += mode.frequency > 0 ? 2 : 1;
  return modes;
}

// What is assumed holds clearly, or where it ends and may just hold.
bool may_be_assumed(const Verdict& assumed) { return assumed.holds && (!assumed.close || assumed.at_end); }

class NumberTrier {
 public:
  NumberTrier(const Statement& statement, std::size_t situation_index, const Claim& claim, ClaimGround& ground)
      : statement_(statement),
        situation_index_(situation_index),
        situation_(ground.situation()),
        claim_(claim),
        ground_(ground) {}

  NumberTrials run() {
    const WorkLimit limit(most_number_work);
    const int most = ground_.letters().empty() ? most_points_without_letters : most_solved_points;
    ClaimFaults faults, of_claim;
    for (int attempt = 0; attempt < most && !found_.refuted && !limit.spent(); ++attempt) {
      const Point point = draw_point(ground_.letters(), attempt, ground_.sizes());
      try {
        try_at(point, attempt);
      } catch (const StatementError& error) {
        (judged_ ? of_claim : faults).note(error, point);
      }
    }
    // What is assumed may hold only at sizes that were not drawn.
    if (const bool none = !found_.possible && !found_.refuted; none && understood_)
      for (int attempt = 0; attempt < most && !found_.refuted && !limit.spent(); ++attempt) try_far(attempt, faults);
    // A claim may fail only where its assumptions just hold.
    for (int attempt = 0, tried = 0; attempt < most && tried < most_edge_starts && !found_.refuted; ++attempt) {
      if (limit.spent()) break;
      tried += try_at_edges(attempt, limit);
    }
    if (found_.possible && !found_.refuted && is_strict(claim_.of) && !claims_stability(situation_, claim_))
      try_alike();
    if (found_.possible && !found_.refuted && !states_equality(claim_.of)) attack(most);
    // If the samples all failed before any assumption could be evaluated, the reason is not in the values, and it is
    // reported.
    const bool assumes = !claim_.assume.empty() || !situation_.assume.empty();
    // What is wrong with the claim where there is such a machine says more than that most values are of none.
    const ClaimFaults& chief = of_claim.empty() ? faults : of_claim;
    if (!found_.possible && !chief.empty() && !(understood_ && assumes))
      throw StatementError(chief.most_frequent(ground_.letters()));
    return std::move(found_);
  }

 private:
  static OpenChoice choice_of(int attempt) {
    return {.seed = 100 + static_cast<std::uint64_t>(attempt), .velocities = true, .direction = OpenChoice::every};
  }

  // Tries the claim at a point with sizes of six decades.
  void try_far(int attempt, ClaimFaults& faults) {
    constexpr double decades = 3;  // to either side
    Point point = draw_point(ground_.letters(), attempt, ground_.sizes());
    std::size_t k = static_cast<std::size_t>(attempt) * ground_.letters().size();
    for (const Letter& letter : ground_.letters())
      if (const double place = spread_evenly(k++); letter.unit.dimension != dimensions::angle)
        point[letter.name] *= std::pow(10, decades * (2 * place - 1));
    try {
      try_at(point, attempt);
    } catch (const StatementError& error) {
      faults.note(error, point);
    }
  }

  // to_the_end: whether sides that are closer than rounding of an instant allows to tell count as they stand.
  bool is_assumed_at(const Point& point, int attempt, bool to_the_end = false) {
    const Settings settings = ground_.with_letters(point);  // must outlive the instant, which refers to it
    try {
      SolvedInstant start(situation_, settings, When{0, situation_.has_blow()}, choice_of(attempt));
      if (states_forces(situation_)) start.solve_forces();
      Verdict assumed;
      for (const Expression& expression : situation_.assume)
        judge_numbers(assumed, situation_, start, nullptr, expression, std::nullopt);
      for (const Expression& expression : claim_.assume)
        judge_numbers(assumed, situation_, start, nullptr, expression, claim_.axes);
      const bool may_be = to_the_end ? assumed.holds && !assumed.past_end : may_be_assumed(assumed);
      return may_be && is_in_its_states(situation_, settings, start);
    } catch (const StatementError&) {
      return false;
    }
  }

  // Moves one letter at a time from a point that satisfies the assumptions to where they end, and tries the claim
  // there. Returns whether there was such a point.
  bool try_at_edges(int attempt, const WorkLimit& limit) {
    if (situation_.has_blow() || (claim_.assume.empty() && situation_.assume.empty())) return false;
    const Point from = draw_point(ground_.letters(), attempt, ground_.sizes());
    if (!is_assumed_at(from, attempt)) return false;
    for (const Letter& letter : ground_.letters())
      for (const double step : {0.5, 2.0}) {
        if (found_.refuted || limit.spent()) return true;
        Point inside = from, outside = from;
        bool ends = false;
        for (int i = 0; i < most_edge_steps && !ends; ++i) {
          outside[letter.name] *= step;
          ends = !is_assumed_at(outside, attempt);
          if (!ends) inside = outside;
        }
        if (!ends) continue;
        for (int i = 0; i < most_edge_halvings; ++i) {
          Point middle = inside;
          middle[letter.name] = (inside[letter.name] + outside[letter.name]) / 2;
          (is_assumed_at(middle, attempt) ? inside : outside) = middle;
        }
        try {
          try_at(inside, attempt);
          if (ends_closed_ && !edges_met_) try_at_end(inside, outside, attempt);
        } catch (const StatementError&) {
          // There the situation has no solution, and nothing is claimed.
        }
      }
    edges_met_ = true;
    return true;
  }

  // Tries a claim that may fail nowhere but where an assumption just holds: between a point that is assumed and one
  // that is not. There numbers do not tell stability, and a strict inequality only where it fails clearly.
  void try_at_end(Point inside, Point outside, int attempt) {
    constexpr int to_the_last_digit = 56;
    for (int i = 0; i < to_the_last_digit; ++i) {
      Point middle = inside;
      for (auto& [name, value] : middle) value = (value + outside.at(name)) / 2;
      (is_assumed_at(middle, attempt, true) ? inside : outside) = middle;
    }
    const std::optional<Verdict> verdict = verdict_at(inside, attempt);
    if (!verdict || !just_assumed_) return;
    if (verdict->close || (!verdict->holds && claims_stability(situation_, claim_)))
      found_.close_at_end = inside;
    else if (!verdict->holds)
      found_.refuted = {inside, *verdict};
  }

  // Tries the claim where letters are equal. What comes too near to its edge there is not taken for true.
  void try_alike() {
    for (const Point& point : alike_points(ground_.letters(), draw_point(ground_.letters(), 0, ground_.sizes()))) {
      if (found_.refuted) return;
      try {
        const std::optional<Verdict> verdict = verdict_at(point, most_motions);
        if (verdict && verdict->holds && verdict->close)
          found_.close_alike = point;
        else
          try_at(point, most_motions);
      } catch (const StatementError&) {
        // There the situation has no solution, and nothing is claimed.
      }
    }
  }

  // Goes on from the points tried to where the claim holds more and more narrowly.
  void attack(int starts) {
    std::optional<Verdict> last;
    ClaimAttack attack(
        ground_.letters(),
        [&](const Point& point) -> std::optional<double> {
          last.reset();
          try {
            last = verdict_at(point, most_motions);
          } catch (const StatementError&) {
            // There the situation has no solution.
          }
          if (!last || (last->close && last->holds)) return std::nullopt;
          return last->holds ? std::max(last->margin, std::numeric_limits<double>::min()) : 0;
        },
        [](const Point&) { return true; }, most_attack_work);
    std::vector<Point> from;
    for (int attempt = 0; attempt < starts; ++attempt)
      from.push_back(draw_point(ground_.letters(), attempt, ground_.sizes()));
    const std::optional<Point> failing = attack.from(from);
    found_.tried += attack.tried();
    if (failing) try_at(*failing, most_motions);
  }

  void try_at(const Point& point, int attempt) {
    ++found_.tried;
    const std::optional<Verdict> verdict = verdict_at(point, attempt);
    if (!verdict) return;
    if (verdict->close && verdict->holds) {
      found_.close = true;
      return;
    }
    found_.possible = true;
    if (!verdict->holds)
      found_.refuted = {point, *verdict};
    else
      found_.most_modes = std::max(found_.most_modes, modes_);
  }

  // Nothing where an assumption fails or rounding might decide on it, or contacts with friction are in other states.
  std::optional<Verdict> verdict_at(const Point& point, int attempt) {
    modes_ = 0;
    judged_ = false;
    const Settings settings = ground_.with_letters(point);
    const OpenChoice choice = choice_of(attempt);
    SolvedInstant start(situation_, settings, When{0, situation_.has_blow()}, choice);
    start.write_down_what_is_told();
    if (states_forces(situation_)) start.solve_forces();
    std::unique_ptr<SolvedInstant> before;
    const ClaimElsewhere elsewhere = [&](const At& at, const Mark& mark) {
      if (!situation_.has_blow() || (at.instant != "before" && at.instant != "after"))
        fail(situation_.file, mark, "a claim is made of one instant, or of those before and after a blow",
             "remove @ " + at.instant);
      if (at.instant == "after") return start.raw(at.expression, claim_.axes, nullptr);
      if (!before) before = std::make_unique<SolvedInstant>(situation_, settings, When{0, false}, choice);
      return before->raw(at.expression, claim_.axes, nullptr);
    };
    const auto judge = [&](Verdict& verdict, const Expression& expression, const std::optional<Expression>& axes) {
      judge_numbers(verdict, situation_, start, elsewhere, expression, axes);
    };
    Verdict assumed;
    for (const Expression& expression : situation_.assume) judge(assumed, expression, std::nullopt);
    for (const Expression& expression : claim_.assume) judge(assumed, expression, claim_.axes);
    understood_ = judged_ = true;
    just_assumed_ = assumed.close;
    if (!may_be_assumed(assumed) || !is_in_its_states(situation_, settings, start)) return std::nullopt;
    Verdict verdict;
    for (const Expression& expression : claim_.of) judge(verdict, expression, claim_.axes);
    if ((!verdict.holds || attempt == 0) && !(start.misfit_of_told().misfit < told_wrongly)) return std::nullopt;
    if (verdict.holds && attempt < most_motions && is_along_motion(situation_, claim_))
      verdict = further_on(verdict, settings, choice, attempt);
    if (verdict.holds && !verdict.close && claims_stability(situation_, claim_)) modes_ = modes_of(situation_, start);
    return verdict;
  }

  // A claim along the motion is also tried later, where the pose is another one, while all contacts and cords hold and
  // wherever what it assumes holds.
  // From some points it is followed until a machine has gone round, if it can be.
  Verdict further_on(Verdict verdict, const Settings& settings, const OpenChoice& choice, int attempt) const {
    AllSettings all(statement_.situations.size(), settings);
    Sample sample(statement_, all, choice);
    const auto held = [](const SolvedInstant& instant) { return instant.machine().mechanism.components.size(); };
    const SolvedInstant& start = sample.instant_at(situation_index_, 0);
    const double pace = start.pace();
    const std::size_t held_at_start = held(start);
    constexpr double near = 1;
    for (const double part : {0.3, 0.8, 2.5, 6.0}) {  // of the time in which the motion changes noticeably
      if (part > near && attempt >= most_long_motions) break;
      try {
        SolvedInstant& there = sample.instant_at(situation_index_, pace > 0 ? part / pace : part);
        if (held(there) < held_at_start) break;
        Verdict assumed;
        for (const Expression& expression : situation_.assume)
          judge_numbers(assumed, situation_, there, nullptr, expression, std::nullopt);
        for (const Expression& expression : claim_.assume)
          judge_numbers(assumed, situation_, there, nullptr, expression, claim_.axes);
        if (!may_be_assumed(assumed)) continue;
        Verdict later;
        for (const Expression& expression : claim_.of)
          judge_numbers(later, situation_, there, nullptr, expression, claim_.axes);
        if (part < near || !later.holds || !later.close) verdict = later;
      } catch (const StatementError&) {
        if (part < near) throw;
        break;
      }
      if (!verdict.holds) break;
    }
    return verdict;
  }

  const Statement& statement_;
  std::size_t situation_index_;
  const Situation& situation_;
  const Claim& claim_;
  ClaimGround& ground_;
  bool understood_ = false;
  bool judged_ = false;  // whether that was so at the point tried last, where the claim itself was looked at
  // Whether the claim may fail just where an assumption ends, and whether that has been looked at from a point.
  const bool ends_closed_ = (is_strict(claim_.of) || claims_stability(situation_, claim_)) &&
                            (has_closed_end(claim_.assume) || has_closed_end(situation_.assume));
  bool edges_met_ = false;
  bool just_assumed_ = false;  // whether an assumption just held at the last point
  std::size_t modes_ = 0;      // of a steady motion at the last point
  NumberTrials found_;
};

}  // namespace

bool claims_stability(const Situation& situation, const Claim& claim) {
  return situation.steady && std::all_of(claim.of.begin(), claim.of.end(), [](const Expression& expression) {
           const Call* call = expression.as<Call>();
           return call && call->function == "stable";
         });
}

NumberTrials try_by_numbers(const Statement& statement, std::size_t situation_index, const Claim& claim,
                            ClaimGround& ground) {
  return NumberTrier(statement, situation_index, claim, ground).run();
}

}  // namespace poinsot::problem
