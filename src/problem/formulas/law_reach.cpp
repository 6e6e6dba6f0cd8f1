#include "problem/formulas/law_reach.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "poinsot/engine/work/work_scope.h"
#include "problem/formulas/formula_answers.h"
#include "problem/formulas/letter_groups.h"
#include "problem/formulas/letter_scan.h"
#include "problem/language/diagnostic.h"
#include "problem/results/compare_values.h"

namespace poinsot::problem {
namespace {

constexpr std::size_t most_scanned_laws = 12;     // points at which all letters are far from their ordinary values
constexpr std::size_t most_beside = 8;            // points at which all are up to a decade from these
constexpr std::size_t more_beside = 16;           // such points, if the others leave time for them
constexpr std::size_t scanned_by_dimensions = 2;  // where dimensions alone tell the laws
constexpr Work looking_nearer = 2;                // times as much work may go into what lies before far points
constexpr Work closing_in = 3;                    // and into the bounds
constexpr int most_halvings = 40;
constexpr int largest_guess = 12;       // denominator of a bound that is guessed
constexpr double simple_to = 1e-3;      // relative distance at which a guess is tried on either side
constexpr double closed_in = 1e-6;      // relative distance of the two ends between which a bound lies
constexpr double leaves_at_once = 100;  // of the tolerance: by how much a law fails at that distance beyond a bound
constexpr double beside_bound = 0.02;   // of a bound: where it is tried, on either side

class Reach {
 public:
  Reach(const ReachTask& task, double& misfit)
      : task_(task),
        laws_(task.laws),
        letters_(task.letters),
        base_(task.base),
        scan_(task.letters, task.base),
        misfit_(misfit),
        limit_(task.most) {}

  std::vector<LawReach> found() {
    keep(base_);
    for (const FarPoint& point : far_points())
      if (!limit_.spent() || (!point.much.empty() && left_out(point.much))) keep(point.letters, point.much);
    limit_ = WorkLimit(looking_nearer * task_.most);
    look_longer();
    look_nearer();
    see_what_matters();
    std::vector<LawReach> all;
    // To close a bound in takes as many points again; few laws need it.
    limit_ = WorkLimit(closing_in * task_.most);
    for (std::size_t k = 0; k < laws_.size(); ++k) all.push_back(reach(k));
    return all;
  }

 private:
  // For each law whether it holds there; nothing where there is no answer.
  using Holds = std::vector<std::optional<bool>>;
  struct Tried {
    LetterValues letters;
    Holds holds;
    std::vector<double> misfit;  // of each law that holds
    std::string much;            // the letter that alone is much larger or smaller than at the base
    bool too_long = false;       // whether it took more work than a point may
  };

  // A point far from the base. `much` names the letter that alone is much larger or smaller there, if it is a single
  // one.
  struct FarPoint {
    LetterValues letters;
    std::string much{};
  };
  std::vector<FarPoint> far_points() const {
    std::vector<FarPoint> points;
    const auto moved = [&](const Letter& letter, double value, bool much) {
      points.push_back({base_, much ? letter.name : ""});
      points.back().letters[letter.name] = value;
    };
    // What a tiny number stands before matters only where it is huge.
    const auto far_off_where_left_out = [&] {
      for (const double far : {1e3, 1e6})
        for (const Letter& letter : letters_)
          if (letter.unit.dimension != dimensions::angle && left_out(letter.name))
            moved(letter, far * base_.at(letter.name), true);
    };
    // With no group of the letters there is none that a bound could be at: all far points are one motion in other
    // units, and where all letters are others at once none is left out. But numbers of the file may make one: how long
    // the motion lasts, where something stops it.
    if (task_.by_dimensions) {
      for (std::size_t i = 0; i < scanned_by_dimensions; ++i) points.push_back({scanned(i)});
      for (const double far : {20.0, 0.05})
        for (const Letter& letter : letters_) moved(letter, far * base_.at(letter.name), true);
      far_off_where_left_out();
      return points;
    }
    for (const Letter& letter : letters_)
      if (letter.either_sign) moved(letter, -base_.at(letter.name), false);
    for (const double far : {20.0, 0.05})
      for (const Letter& letter : letters_)
        if (letter.unit.dimension != dimensions::angle) moved(letter, far * base_.at(letter.name), true);
    far_off_where_left_out();
    // Far off there may be no answer, or one that takes long, where a bound is close by.
    for (const double times : {4.0, 0.25})
      for (const Letter& letter : letters_)
        if (letter.unit.dimension != dimensions::angle) moved(letter, times * base_.at(letter.name), false);
    for (std::size_t i = 0; i < most_beside; ++i) points.push_back({beside(i)});
    for (std::size_t i = 0; i < most_scanned_laws; ++i) points.push_back({scanned(i)});
    for (std::size_t i = 0; i < more_beside; ++i) points.push_back({beside(most_beside + i)});
    return points;
  }

  static bool has_no_value(const Value<Formula>& law, const LetterValues& letters) {
    if (law.is_number()) return !std::isfinite(value_at(law.number, letters));
    return std::ranges::any_of(law.items, [&](const Value<Formula>& item) { return has_no_value(item, letters); });
  }
  static bool stands_in(const std::string& letter, const Value<Formula>& law) {
    const auto in = [&](const Formula& x) { return std::ranges::count(x.letters(), letter) > 0; };
    if (law.is_list())
      return std::ranges::any_of(law.items, [&](const Value<Formula>& item) { return stands_in(letter, item); });
    return law.is_vector() ? in(law.vector.x) || in(law.vector.y) || in(law.vector.z) : in(law.number);
  }
  // Whether a law held where this letter alone, or with others, is much larger or smaller.
  bool held_far(std::size_t k, const std::string& letter) const {
    constexpr double much = 10;
    return std::ranges::any_of(tried_, [&](const Tried& one) {
      const double times = std::abs(one.letters.at(letter) / base_.at(letter));
      return one.holds[k] == true && (times > much || times < 1 / much);
    });
  }
  // The first letter that a law leaves out without having been tried far off; "" if there is none.
  std::string untried(std::size_t k) const {
    for (const Letter& letter : letters_)
      if (letter.unit.dimension != dimensions::angle && !stands_in(letter.name, laws_[k].law) &&
          !held_far(k, letter.name))
        return letter.name;
    return "";
  }
  bool left_out(const std::string& letter) const {
    return std::ranges::any_of(laws_, [&](const HeldLaw& one) { return !stands_in(letter, one.law); });
  }
  // What is asked at an instant that is sought has no answer where nothing happens, and to look for it in vain takes
  // far longer than to find it. Points that took too long are tried again with more work, those next to the base first;
  // what does not happen at one of them is then looked for so long everywhere.
  void look_longer() {
    constexpr Work longer = 12;
    constexpr std::size_t looks = 2;
    if (std::ranges::none_of(laws_, [](const HeldLaw& law) { return law.of_event || !law.at_events.empty(); })) return;
    const auto in_vain = [](const Tried& one) {
      return std::ranges::any_of(one.holds, [](const std::optional<bool>& holds) { return holds == false; });
    };
    if (std::ranges::any_of(tried_, in_vain)) return;
    const auto apart = [&](const Tried* one) {
      double farthest = 0;
      for (const auto& [letter, value] : one->letters)
        farthest = std::max(farthest, std::abs(std::log(std::abs(value / base_.at(letter)))));
      return farthest;
    };
    std::vector<Tried*> again;
    for (Tried& one : tried_)
      if (one.too_long) again.push_back(&one);
    std::ranges::stable_sort(again, {}, apart);
    if (again.size() > looks) again.resize(looks);
    each_ = longer * task_.each;
    bool any = false;
    for (Tried* one : again) {
      if (limit_.spent()) break;
      one->holds = at(one->letters);
      one->misfit = misfits_;
      any = any || in_vain(*one);
    }
    if (!any) each_ = task_.each;
  }
  // Where a letter alone is much larger or smaller there may be no answer, since something comes to its end. On the way
  // there a bound may lie at which there still is one.
  void look_nearer() {
    struct Way {
      std::string letter;
      double times = 1;  // of its value at the base
    };
    std::vector<Way> ways;
    const auto answered = [](const Tried& one) {
      return std::ranges::any_of(one.holds, [](const std::optional<bool>& holds) { return holds.has_value(); });
    };
    for (const Tried& one : tried_)
      if (!one.much.empty() && !answered(one))
        ways.push_back({one.much, one.letters.at(one.much) / base_.at(one.much)});
    constexpr int looks = 4;
    for (const Way& way : ways) {
      double near = 1, far = way.times;
      for (int i = 0; i < looks && !limit_.spent(); ++i) {
        const double middle = std::sqrt(near * far);
        LetterValues letters = base_;
        letters[way.letter] *= middle;
        keep(letters);
        (answered(tried_.back()) ? near : far) = middle;
      }
    }
  }
  // A letter that a law leaves out may matter by less than the tolerance as far as it was tried. Where it alone is
  // large or small on one side, the answer then differs by far more than rounding, which the other side shows.
  void see_what_matters() {
    constexpr double far_more = 100, rounding = 1e-9;
    for (std::size_t k = 0; k < laws_.size(); ++k)
      for (Tried& one : tried_) {
        if (one.much.empty() || one.holds[k] != true || stands_in(one.much, laws_[k].law)) continue;
        for (const Tried& other : tried_)
          if (&other != &one && other.much == one.much && other.holds[k] == true &&
              one.misfit[k] > std::max(rounding, far_more * other.misfit[k]))
            one.holds[k] = false;
      }
  }
  // Angles keep to the first quadrant: what a law is beyond it has been seen where it was found.
  LetterValues scanned(std::size_t index) const {
    LetterValues values = scan_.point(index);
    for (const Letter& letter : letters_)
      if (letter.unit.dimension == dimensions::angle) {
        double& angle = values[letter.name];
        angle = 0.15 + 1.25 * (angle / std::numbers::pi + 1) / 2;
      }
    return values;
  }

  LetterValues beside(std::size_t index) const {
    LetterValues values = scanned(index);
    for (const Letter& letter : letters_) {
      double& value = values[letter.name];
      const double ordinary = std::abs(base_.at(letter.name));
      if (letter.unit.dimension != dimensions::angle && ordinary > 0)
        value = std::copysign(ordinary * std::cbrt(std::abs(value) / ordinary), value);
    }
    return values;
  }

  Holds at(const LetterValues& letters) {
    Holds holds(laws_.size());
    misfits_.assign(laws_.size(), 0);
    ScalingTrials::Answers answers;
    too_long_ = false;
    try {
      const WorkScope scope(each_);
      answers = task_.solve(letters);
    } catch (const BudgetEnded&) {
      // Either this point takes too long, or the caller waits no longer.
      check_budget();
      too_long_ = true;
      return holds;
    } catch (const StatementError&) {
      return holds;
    } catch (const NoFormula&) {
      too_long_ = true;
      return holds;
    }
    for (std::size_t k = 0; k < laws_.size(); ++k) {
      const std::optional<Value<double>>& value = answers.at(laws_[k].answer);
      if (!value) {
        if (tells_in_vain(laws_[k], letters)) {
          holds[k] = false;
          misfits_[k] = INFINITY;
        }
        continue;
      }
      // Nothing swings where what is under the root of a frequency is negative.
      if (value->is_list() && value->items.empty() && has_no_value(laws_[k].law, letters)) continue;
      const double misfit = misfit_of(laws_[k].law, *value, letters, size_of(*value));
      const bool met = misfit <= task_.tolerance;
      if (!met && task_.is_beyond(letters)) continue;
      holds[k] = met;
      misfits_[k] = misfit;
      if (met) misfit_ = std::max(misfit_, misfit);
    }
    return holds;
  }
  void keep(const LetterValues& letters, const std::string& much = "") {
    Holds holds = at(letters);
    tried_.push_back({letters, std::move(holds), misfits_, much, too_long_});
  }

  // Whether a law tells something where it does not happen. What would happen later than it was looked for may.
  bool tells_in_vain(const HeldLaw& law, const LetterValues& letters) const {
    const std::optional<double> until = task_.sought_in_vain(law.answer, letters);
    if (!until || has_no_value(law.law, letters) || task_.is_beyond(letters)) return false;
    const auto comes_later = [&](const HeldLaw& event) {
      return event.of_event && event.law.is_number() && value_at(event.law.number, letters) > *until;
    };
    return law.of_event ? !comes_later(law) : std::ranges::none_of(laws_, comes_later);
  }

  LawReach reach(std::size_t k) {
    LawReach result;
    for (const Tried& one : tried_) {
      if (one.holds[k] != false) continue;
      if (task_.sought_in_vain(laws_[k].answer, one.letters))
        result.not_there.push_back(one.letters);
      else if (!result.fails)
        result.fails = one.letters;
      if (result.hangs_on.empty()) result.hangs_on = one.much;
    }
    // No time is negative, and what is asked at one needs one.
    for (const HeldLaw& law : laws_) {
      const bool own = law.answer == laws_[k].answer && law.of_event;
      if ((own || std::ranges::count(laws_[k].at_events, law.answer) > 0) && changes_sign(law.law.number))
        result.positive.push_back(law.law.number);
    }
    if (result.fails || !result.not_there.empty()) {
      result.told = tried_.front().holds[k] == true && add_conditions(k, result.positive);
    } else if (!task_.by_dimensions) {
      result.untried = untried(k);
    }
    return result;
  }
  bool changes_sign(const Formula& law) const {
    constexpr std::size_t points = 100;
    if (!(value_at(law, base_) > 0)) return false;
    for (std::size_t i = 0; i < points; ++i)
      if (value_at(law, scanned(i)) < 0) return true;
    return std::ranges::any_of(tried_, [&](const Tried& one) { return value_at(law, one.letters) < 0; });
  }

  // Adds what else must be positive where a law holds. Whether it holds wherever all of it is.
  bool add_conditions(std::size_t k, std::vector<Formula>& positive) {
    inside_ = positive;
    if (std::ranges::none_of(tried_, [&](const Tried& one) { return one.holds[k] == false && is_inside(one.letters); }))
      return true;
    const std::optional<Formula> found = parting(k);
    if (found) positive.push_back(*found);
    return found.has_value();
  }
  bool is_inside(const LetterValues& letters) const {
    return std::ranges::all_of(inside_, [&](const Formula& one) { return value_at(one, letters) > 0; });
  }
  // What is positive where a law holds and negative where it fails.
  std::optional<Formula> parting(std::size_t k) {
    for (const Letter& letter : letters_)
      if (letter.either_sign && parts(k, [&](const LetterValues& at) { return at.at(letter.name) < 0; })) {
        const Formula x = formula_of(letter).number;
        return base_.at(letter.name) > 0 ? x : -x;
      }
    for (const Formula& one : turned_round(laws_[k].law))
      if (parts(k, [&](const LetterValues& at) { return !(value_at(one, at) > 0); }) && confirmed(k, one)) return one;
    for (const LetterGroup& group : groups_of(letters_))
      if (std::optional<Formula> found = bound_by(k, group)) return found;
    return std::nullopt;
  }
  // A law with one letter turned round, of the sign that it has at the base: after a slip friction acts the other way,
  // and holds where it is large enough for that.
  std::vector<Formula> turned_round(const Value<Formula>& law) const {
    std::vector<Formula> all;
    if (!law.is_number()) return all;
    for (const Letter& letter : letters_) {
      if (!stands_in(letter.name, law)) continue;
      try {
        const Formula turned = substituted(law.number, {{letter.name, -formula_of(letter).number}});
        if (const double here = value_at(turned, base_); here != 0 && std::isfinite(here))
          all.push_back(here > 0 ? turned : -turned);
      } catch (const std::domain_error&) {
        // It has no value then.
      }
    }
    return all;
  }
  // Whether a law holds at other letters where something is positive, and nowhere else.
  bool confirmed(std::size_t k, const Formula& positive) {
    constexpr std::size_t wanted = 3;
    std::size_t inside = 0, outside = 0;
    for (std::size_t i = most_scanned_laws; i < 4 * most_scanned_laws && std::min(inside, outside) < wanted; ++i) {
      const LetterValues letters = beside(i);
      if (limit_.spent()) return false;
      const std::optional<bool> holds = is_inside(letters) ? at(letters)[k] : std::nullopt;
      if (!holds) continue;
      if (*holds != (value_at(positive, letters) > 0)) return false;
      ++(*holds ? inside : outside);
    }
    return inside > 0 && outside > 0;
  }
  // Whether the law fails at just those points at which something is true.
  template <class True>
  bool parts(std::size_t k, const True& is_true) const {
    return std::ranges::all_of(tried_, [&](const Tried& one) {
      return !one.holds[k].has_value() || !is_inside(one.letters) || *one.holds[k] != is_true(one.letters);
    });
  }

  std::optional<Formula> bound_by(std::size_t k, const LetterGroup& group) {
    double low_holds = INFINITY, high_holds = 0, low_fails = INFINITY, high_fails = 0;
    for (const Tried& one : tried_) {
      if (!one.holds[k].has_value() || !is_inside(one.letters)) continue;
      const double value = group.at(one.letters);
      (*one.holds[k] ? low_holds : low_fails) = std::min(*one.holds[k] ? low_holds : low_fails, value);
      (*one.holds[k] ? high_holds : high_fails) = std::max(*one.holds[k] ? high_holds : high_fails, value);
    }
    const bool below = high_holds < low_fails;
    if (!below && !(high_fails < low_holds)) return std::nullopt;
    double holds = below ? high_holds : low_holds, fails = below ? low_fails : high_fails;
    const std::optional<Formula> found = closed(k, group, holds, fails);
    if (!found) return std::nullopt;
    const double bound = plain(*found);
    // The bound is the same whatever the other letters are, or it is none of this group alone.
    int confirmed = 0;
    for (std::size_t i = most_scanned_laws; i < 3 * most_scanned_laws && confirmed < 3; ++i) {
      if (limit_.spent()) return std::nullopt;
      const LetterValues other = scanned(i);
      const LetterValues before = group.moved(other, bound * (below ? 1 - beside_bound : 1 + beside_bound));
      const LetterValues beyond = group.moved(other, bound * (below ? 1 + beside_bound : 1 - beside_bound));
      if (!is_inside(before) || !is_inside(beyond)) continue;
      const auto inside = at(before)[k], outside = at(beyond)[k];
      if (!inside.has_value() || !outside.has_value()) continue;
      if (!*inside || *outside) return std::nullopt;
      ++confirmed;
    }
    if (confirmed == 0) return std::nullopt;
    const Formula positive = group.below(*found);
    return below ? positive : -positive;
  }
  // The bound between two values of a group, with the other letters as at the base: a simple number that parts them, or
  // the one that is closed in. Just at a bound there is often no answer, or a motion that takes for ever.
  std::optional<Formula> closed(std::size_t k, const LetterGroup& group, double holds, double fails) {
    const auto holds_at = [&](double value) {
      return limit_.spent() ? std::nullopt : at(group.moved(base_, value))[k];
    };
    std::optional<double> guessed;
    for (int i = 0; i < most_halvings && std::abs(holds - fails) > closed_in * holds; ++i) {
      const double simple = simplest_between(std::min(holds, fails), std::max(holds, fails));
      if (simple != guessed && simple > 0) {
        guessed = simple;
        const double inwards = holds < fails ? -1 : 1;
        if (holds_at(simple * (1 + inwards * simple_to)) == true &&
            holds_at(simple * (1 - inwards * simple_to)) == false && misfits_[k] > leaves_at_once * task_.tolerance &&
            !is_contradicted(simple, inwards, holds_at))
          return simple_number(simple, closed_in);
      }
      const double middle = std::sqrt(holds * fails);
      const std::optional<bool> there = holds_at(middle);
      if (!there) return std::nullopt;
      (*there ? holds : fails) = middle;
    }
    const double bound = std::sqrt(holds * fails);
    const double outwards = holds < fails ? 1 : -1;
    const auto misfit = misfit_at(k, group, bound * (1 + outwards * simple_to));
    if (misfit && *misfit > leaves_at_once * task_.tolerance) return simple_number(bound, 10 * closed_in);
    // It takes a dozen points more, and few laws need it.
    if (!std::exchange(flat_begun_, true)) limit_ = WorkLimit(closing_in * task_.most);
    const auto edge = flat_edge(bound, outwards, [&](double value) { return misfit_at(k, group, value); });
    return edge ? std::optional(simple_number(*edge, flat_edge_error)) : std::nullopt;
  }
  std::optional<double> misfit_at(std::size_t k, const LetterGroup& group, double value) {
    if (limit_.spent()) return std::nullopt;
    const std::optional<bool> there = at(group.moved(base_, value))[k];
    return there && misfits_[k] > 0 ? std::optional(misfits_[k]) : std::nullopt;
  }
  // Whether a bound that is guessed is none, nearer and nearer to it: 9.8 m/s^2 is not the standard gravity.
  template <class HoldsAt>
  static bool is_contradicted(double simple, double inwards, const HoldsAt& holds_at) {
    for (const double aside : {simple_to / 10, simple_to / 100})
      if (holds_at(simple * (1 + inwards * aside)) == false || holds_at(simple * (1 - inwards * aside)) == true)
        return true;
    return false;
  }
  // The fraction of smallest denominator between two numbers; 0 if it is not small.
  static double simplest_between(double low, double high) {
    for (int below = 1; below <= largest_guess; ++below)
      if (const double above = std::floor(low * below) + 1; above < high * below) return above / below;
    return 0;
  }

  const ReachTask& task_;
  const std::vector<HeldLaw>& laws_;
  const std::vector<Letter>& letters_;
  const LetterValues& base_;
  const LetterScan scan_;
  double& misfit_;
  WorkLimit limit_;
  bool flat_begun_ = false;      // whether a bound was looked for that is left flatly
  Work each_ = task_.each;       // that a point may take
  bool too_long_ = false;        // whether the point tried last took more
  std::vector<Tried> tried_;     // the base first
  std::vector<double> misfits_;  // of the laws at the point tried last
  std::vector<Formula> inside_;  // what is positive where more conditions are sought
};

}  // namespace

std::vector<LawReach> reach_of(const ReachTask& task, double& misfit) { return Reach(task, misfit).found(); }

}  // namespace poinsot::problem
