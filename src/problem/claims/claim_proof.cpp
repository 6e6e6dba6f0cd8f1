#include "problem/claims/claim_proof.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include "poinsot/engine/math/formula/formula_sign.h"

namespace poinsot::problem {
namespace {

constexpr std::size_t most_cases = 12;  // each is a proof of its own
constexpr int most_tries = 60;          // includes cases that prove impossible

bool contains(const std::vector<std::string>& list, const std::string& item) {
  return std::find(list.begin(), list.end(), item) != list.end();
}

// x = slope * letter + rest, where neither holds the letter.
struct Line {
  Formula slope, rest;
  Formula root() const { return -rest / slope; }
};

// Writes x as a line in the letter; nothing if it is not one.
std::optional<Line> line_in(const Formula& x, const std::string& letter, poinsot::Sign sign) {
  const Formula slope = derivative(x, letter);
  if (slope.is_zero() || contains(slope.letters(), letter)) return std::nullopt;
  const Formula rest = x - slope * Formula::letter(letter, sign);
  if (contains(rest.letters(), letter)) return std::nullopt;
  return Line{slope, rest};
}

bool never_zero(const Formula& x) {
  const SeenSign seen = seen_sign(x);
  return seen.sign != 0 && seen.strict;
}

}  // namespace

// Replaces letters so that the assumptions hold for all values of the new letters, one assumption after the other.
class AssumptionWorker {
 public:
  AssumptionWorker(const std::vector<FormulaComparison>& assumptions, const std::vector<std::string>& positive)
      : positive_(positive.begin(), positive.end()) {
    for (const FormulaComparison& assumption : assumptions) {
      const Formula difference = assumption.difference();
      switch (assumption.relation) {
        case Relation::equal:
          if (!difference.is_zero()) equations_.push_back(difference);
          break;
        case Relation::greater:
        case Relation::greater_equal:
          orders_.push_back({difference, assumption.relation == Relation::greater_equal});
          break;
        case Relation::less:
        case Relation::less_equal:
          orders_.push_back({-difference, assumption.relation == Relation::less_equal});
          break;
      }
    }
  }

  std::vector<WorkedCase> work(bool& complete) {
    State start;
    start.equations = equations_;
    start.orders = orders_;
    take_ranges(start);
    part_closed_ranges(start);
    // First the ranges of those letters for which no equation can be solved, as angles: with them it may show that
    // factors of the equations cannot vanish.
    work_in_ranges(start, false);
    open_.push_back(std::move(start));
    std::vector<WorkedCase> cases;
    for (int tries = 0; !open_.empty(); ++tries) {
      if (tries == most_tries || cases.size() + open_.size() > most_cases) {
        complete = false;
        break;
      }
      State state = std::move(open_.back());
      open_.pop_back();
      if (!work_in_equations(state)) continue;
      work_in_ranges(state, true);
      if (!work_in_orders(state)) continue;
      complete = complete && state.worked.unsolved_.empty() && !state.dropped;
      cases.push_back(std::move(state.worked));
    }
    std::reverse(cases.begin(), cases.end());
    // The case in which fewest letters have special values comes first.
    std::stable_sort(cases.begin(), cases.end(), [](const WorkedCase& one, const WorkedCase& other) {
      return one.values_.size() < other.values_.size();
    });
    return cases;
  }

 private:
  struct Order {
    Formula difference;  // this is positive
    bool weak = false;   // or it may also vanish
  };
  struct Range {
    std::optional<Formula> low, high;
    bool low_weak = false, high_weak = false;  // whether an end belongs to it

    bool weak() const { return low_weak || high_weak; }
  };
  struct State {
    WorkedCase worked;
    std::vector<Formula> equations;  // each of these vanishes
    std::vector<Order> orders;
    std::map<std::string, Range> ranges;
    std::set<std::string> parts;       // new letters, all positive
    std::set<std::string> weak_parts;  // those that may vanish as well
    bool dropped = false;              // whether a case that branched off it was left out
  };

  bool is_positive(const State& state, const std::string& letter) const {
    return positive_.contains(letter) || state.parts.contains(letter);
  }
  poinsot::Sign sign_of(const State& state, const std::string& letter) const {
    return is_positive(state, letter) ? poinsot::Sign::positive : poinsot::Sign::real;
  }
  static Formula fresh_letter(State& state) {
    std::vector<std::string>& letters = state.worked.letters_;
    letters.push_back("part " + std::to_string(letters.size() + 1));
    state.parts.insert(letters.back());
    return Formula::letter(letters.back(), poinsot::Sign::positive);
  }
  static void set(State& state, const std::string& letter, const Formula& value) {
    for (auto& [name, known] : state.worked.values_) known = poinsot::substituted(known, {{letter, value}});
    state.worked.values_[letter] = value;
  }

  // Collects the ranges of letters of either sign that are compared with numbers.
  void take_ranges(State& state) const {
    std::vector<Order> others;
    for (const Order& order : state.orders) {
      const std::vector<std::string> letters = order.difference.letters();
      const auto line = letters.size() == 1 && !is_positive(state, letters.front())
                            ? line_in(order.difference, letters.front(), poinsot::Sign::real)
                            : std::nullopt;
      if (!line || !line->slope.is_number() || !line->rest.is_number()) {
        others.push_back(order);
        continue;
      }
      Range& range = state.ranges[letters.front()];
      const Formula bound = line->root();
      const bool rising = plain(line->slope) > 0;
      std::optional<Formula>& end = rising ? range.low : range.high;
      bool& weak = rising ? range.low_weak : range.high_weak;
      const bool narrower = !end || (rising ? plain(bound) > plain(*end) : plain(bound) < plain(*end));
      weak = narrower ? order.weak : weak && (order.weak || plain(bound) != plain(*end));
      if (narrower) end = bound;
    }
    state.orders = std::move(others);
  }

  // A new letter that vanishes is at one end of a range only. Where both belong to it, its upper end is a case.
  void part_closed_ranges(State& state) {
    for (auto& [letter, range] : state.ranges) {
      if (!range.low || !range.high || !range.low_weak || !range.high_weak) continue;
      State end = state;
      end.ranges.at(letter).low_weak = false;
      end.equations.push_back(Formula::letter(letter, poinsot::Sign::real) - *range.high);
      part_closed_ranges(end);
      follow(std::move(end), state);
      range.high_weak = false;
    }
  }

  // Replaces letters with ranges by positive new letters s. An angle b between 0 and at most 180 deg has tan(b/2)
  // between 0 and some number or infinity; other letters lie above or below a number, or between two. all: also
  // letters for which an equation could be solved; these are otherwise left to the equations.
  void work_in_ranges(State& state, bool all) const {
    for (auto entry = state.ranges.begin(); entry != state.ranges.end();) {
      const auto& letter = entry->first;
      const auto& range = entry->second;
      const bool solvable = std::any_of(state.equations.begin(), state.equations.end(), [&](const Formula& equation) {
        return line_in(equation, letter, poinsot::Sign::real).has_value();
      });
      if (!all && solvable) {
        ++entry;
        continue;
      }
      if (state.worked.values_.contains(letter)) {
        // An equation has given the letter a value. Its range becomes an order for that value.
        const Formula x = state.worked.values_.at(letter);
        const auto keep = [&](const Formula& difference, bool weak) {
          if (!weak || !difference.is_zero()) state.orders.push_back({difference, weak});
        };
        if (range.low) keep(x - *range.low, range.low_weak);
        if (range.high) keep(*range.high - x, range.high_weak);
      } else {
        set_range(state, letter, range);
        state.worked.weak_ = state.worked.weak_ || range.weak();
      }
      entry = state.ranges.erase(entry);
    }
  }
  static void set_range(State& state, const std::string& letter, const Range& range) {
    const Formula s = fresh_letter(state);
    if (!range.high) {
      set(state, letter, *range.low + s);
      return;
    }
    if (!range.low) {
      set(state, letter, *range.high - s);
      return;
    }
    // An end that belongs to the range is where s vanishes.
    const Formula part = (range.high_weak ? Formula(1) : s) / (Formula(1) + s);
    if (range.low->is_zero() && *range.high == Formula::pi() && !range.high_weak)
      set(state, letter, Formula(2) * atan(s));
    // An end that is a quotient of integers is that of a length, a mass or a ratio.
    else if (range.low->is_zero() && !range.high->is_rational() && plain(*range.high) < 3.1415 &&
             plain(*range.high) > 0)
      set(state, letter, Formula(2) * atan(tan(*range.high / Formula(2)) * part));
    else
      set(state, letter, *range.low + (*range.high - *range.low) * part);
  }

  // Solves the equations for letters. Returns false if they cannot hold.
  bool work_in_equations(State& state) {
    while (!state.equations.empty()) {
      const Formula equation = state.worked.apply(state.equations.back());
      state.equations.pop_back();
      if (equation.is_zero()) continue;
      // A product vanishes where one of its factors does. Each factor makes a case.
      const std::vector<Formula> factors = vanishing_factors(equation);
      if (factors.empty()) return false;
      for (std::size_t k = 1; k < factors.size(); ++k) {
        State other = state;
        other.equations.push_back(factors[k]);
        follow(std::move(other), state);
      }
      solve_for_letter(state, factors.front());
    }
    return true;
  }
  // Keeps a case to be followed later.
  void follow(State other, State& from) {
    if (open_.size() < most_cases)
      open_.push_back(std::move(other));
    else
      from.dropped = true;
  }

  // Solves an equation for a letter that occurs in it linearly. Preferred are letters whose value is seen to be
  // positive, or whose factor cannot vanish.
  void solve_for_letter(State& state, const Formula& equation) {
    struct Way {
      std::string letter;
      Line line;
      int cost;
    };
    std::optional<Way> best;
    for (const std::string& letter : equation.letters()) {
      const auto line = line_in(equation, letter, sign_of(state, letter));
      if (!line) continue;
      const bool stays = !is_positive(state, letter) || (!line->rest.is_zero() && seen_sign(line->root()).sign > 0);
      const int cost = 2 * !never_zero(line->slope) + !stays;
      if (!best || cost < best->cost) best = Way{letter, *line, cost};
    }
    if (!best) {
      state.worked.unsolved_.push_back(equation);
      return;
    }
    if (best->cost >= 2) {
      // Where the factor of the letter vanishes, the rest must vanish too, and the letter is free. That is another
      // case.
      State special = state;
      special.equations.push_back(best->line.slope);
      special.equations.push_back(best->line.rest);
      follow(std::move(special), state);
    }
    const Formula root = best->line.root();
    // If a positive letter is replaced, its value must be positive: this becomes an order.
    if (is_positive(state, best->letter) && (root.is_zero() || seen_sign(root).sign <= 0))
      state.orders.push_back({root, false});
    set(state, best->letter, root);
  }

  // Replaces letters so that the orders hold. Returns false if one of them cannot hold.
  bool work_in_orders(State& state) {
    std::vector<Order> left = state.orders;  // which stay for the cases that branch off
    for (bool progress = true; progress;) {
      progress = false;
      std::vector<Order> again;
      for (const Order& order : left) {
        const Formula difference = state.worked.apply(order.difference);
        if (difference.is_zero()) {
          if (!order.weak) return false;
          continue;
        }
        const SeenSign seen = seen_sign(difference);
        if (seen.sign < 0 && (!order.weak || seen.strict)) return false;
        if (work_in_order(state, order))
          progress = true;
        else
          again.push_back(order);
      }
      left = std::move(again);
    }
    return true;
  }

  // Replaces a letter by which the order holds for all values. Returns whether there is one.
  bool work_in_order(State& state, const Order& order) {
    const Formula difference = sign_part(state.worked.apply(order.difference), order.weak);
    for (const std::string& letter : difference.letters()) {
      const auto line = line_in(difference, letter, sign_of(state, letter));
      if (!line) continue;
      const SeenSign rising = seen_sign(line->slope);
      if (rising.sign == 0 || !rising.strict) continue;
      const Formula bound = line->root();
      const bool positive = is_positive(state, letter);
      if (rising.sign > 0) {
        // letter > bound
        if (positive && !bound.is_zero() && seen_sign(bound).sign <= 0) continue;
        set(state, letter, bound + fresh_letter(state));
        if (order.weak) state.weak_parts.insert(state.worked.letters_.back());
      } else if (!positive) {
        set(state, letter, bound - fresh_letter(state));
        if (order.weak) state.weak_parts.insert(state.worked.letters_.back());
      } else {
        // 0 < letter < bound
        const SeenSign upper = bound.is_zero() ? SeenSign{} : seen_sign(bound);
        if (upper.sign <= 0 || !upper.strict) continue;
        const bool both_ends = order.weak && state.weak_parts.contains(letter);
        if (both_ends) {
          // Where it vanishes stays within reach of the new letter, and where it is at its bound is a case.
          State end = state;
          end.equations.push_back(difference);
          follow(std::move(end), state);
        }
        const Formula s = fresh_letter(state);
        // If the bound belongs to its values, it is where s vanishes.
        set(state, letter, bound * (order.weak && !both_ends ? Formula(1) : s) / (Formula(1) + s));
        if (order.weak) state.weak_parts.insert(state.worked.letters_.back());
      }
      state.worked.weak_ = state.worked.weak_ || order.weak;
      return true;
    }
    return false;
  }

  std::set<std::string> positive_;
  std::vector<Formula> equations_;
  std::vector<Order> orders_;
  std::vector<State> open_;
};

bool WorkedCase::proves(const FormulaComparison& comparison) const {
  if (!unsolved_.empty()) return false;
  const Formula difference = apply(comparison.difference());
  if (comparison.relation == Relation::equal) return difference.is_zero();
  const bool greater = comparison.relation == Relation::greater || comparison.relation == Relation::greater_equal;
  const bool strict = comparison.relation == Relation::greater || comparison.relation == Relation::less;
  if (difference.is_zero()) return !strict;
  const SeenSign seen = seen_sign(difference);
  return seen.sign == (greater ? 1 : -1) && (!strict || (seen.strict && !weak_));
}

bool WorkedCase::keeps_sign(const Formula& x, int sign) const {
  if (!unsolved_.empty()) return false;
  const Formula applied = apply(x);
  return applied.is_zero() || seen_sign(applied).sign == sign;
}

WorkedAssumptions::WorkedAssumptions(const std::vector<FormulaComparison>& assumptions,
                                     const std::vector<std::string>& positive) {
  cases_ = AssumptionWorker(assumptions, positive).work(complete_);
}

bool WorkedAssumptions::proves(const FormulaComparison& comparison) const {
  return complete_ &&
         std::all_of(cases_.begin(), cases_.end(), [&](const WorkedCase& one) { return one.proves(comparison); });
}

bool WorkedAssumptions::keeps_sign(const Formula& x, int sign) const {
  return complete_ &&
         std::all_of(cases_.begin(), cases_.end(), [&](const WorkedCase& one) { return one.keeps_sign(x, sign); });
}

}  // namespace poinsot::problem
