#include "problem/formulas/law_regimes.h"

#include <algorithm>
#include <cmath>

#include "poinsot/engine/math/formula/formula_domain.h"
#include "poinsot/engine/math/formula/formula_sign.h"
#include "problem/formulas/formula_answers.h"
#include "problem/formulas/formula_conditions.h"
#include "problem/formulas/letter_scan.h"
#include "problem/language/diagnostic.h"
#include "problem/results/compare_values.h"

namespace poinsot::problem {
namespace {

constexpr std::size_t points_scanned = 24;
constexpr std::size_t most_laws = 4;
constexpr std::size_t most_borders = 3;  // at which a condition is confirmed
// Distances in the logarithms of the letters.
constexpr double near_border = 0.1, well_beyond = 0.6;
constexpr double beside_border = 0.05;
constexpr std::size_t least_on_each_side = 2;  // points tried, for a condition to be taken from them

class LawRegimes {
 public:
  LawRegimes(const HeldLaw& first, const std::vector<Letter>& letters, const LetterValues& base,
             const ScalingTrials::Solve& solve, double tolerance, Work most)
      : answer_(first.answer),
        letters_(letters),
        base_(base),
        solve_(solve),
        tolerance_(tolerance),
        limit_(most),
        laws_{first.law} {}

  std::optional<std::vector<LawRegime>> found(
      const std::optional<Formula>& bound,
      const std::function<std::optional<Value<Formula>>(const LetterValues&)>& find) {
    collect_points();
    if (!find_laws(find)) return std::nullopt;
    if (const auto one = as_size()) return std::vector{LawRegime{*one, {}}};
    if (laws_.size() < 2) return std::nullopt;
    std::vector<Formula> candidates = candidates_of(bound);
    std::vector<LawRegime> regimes;
    for (const Value<Formula>& law : laws_) {
      const auto positive = condition_of(law, candidates);
      if (!positive) return std::nullopt;
      regimes.push_back({law, *positive});
    }
    for (const Point& point : points_)
      if (std::ranges::none_of(regimes,
                               [&](const LawRegime& one) { return all_positive(one.positive, point.letters); }))
        return std::nullopt;
    return regimes;
  }

 private:
  struct Point {
    LetterValues letters;
    Value<double> value;
  };

  std::optional<Value<double>> value_at_letters(const LetterValues& letters) const {
    if (limit_.spent()) return std::nullopt;
    try {
      return solve_(letters).at(answer_);
    } catch (const StatementError&) {
      return std::nullopt;
    } catch (const NoFormula&) {
      return std::nullopt;
    }
  }
  bool holds(const Value<Formula>& law, const Point& point) const {
    return misfit_of(law, point.value, point.letters, size_of(point.value)) <= tolerance_;
  }

  void collect_points() {
    const auto add = [&](const LetterValues& letters) {
      if (const auto value = value_at_letters(letters)) points_.push_back({letters, *value});
    };
    add(base_);
    const LetterScan scan(letters_, base_);
    for (std::size_t i = 0; i < points_scanned; ++i) add(scan.point(i));
    for (const double far : {20.0, 0.05})
      for (const Letter& letter : letters_) {
        LetterValues moved = base_;
        moved[letter.name] *= far;
        add(moved);
      }
  }

  bool has_law(const Point& point) const {
    return std::ranges::any_of(laws_, [&](const Value<Formula>& law) { return holds(law, point); });
  }

  // Finds laws until each point has one. They are sought not far beyond the border of those known, where no letter is
  // so much smaller than another that it has no part in the numbers.
  bool find_laws(const std::function<std::optional<Value<Formula>>(const LetterValues&)>& find) {
    for (const Point& point : points_) {
      if (has_law(point)) continue;
      if (laws_.size() == most_laws || limit_.spent()) return false;
      std::optional<Value<Formula>> law = find(beyond_border(point));
      if (!law || !holds(*law, point)) law = find(point.letters);
      if (!law || !holds(*law, point)) return false;
      laws_.push_back(*law);
    }
    return true;
  }
  LetterValues beyond_border(const Point& point) const {
    const Point& start = points_.front();
    const double all = distance(start, point);
    double in = 0, out = 1;
    while (all * (out - in) > near_border) {
      const double middle = 0.5 * (in + out);
      const LetterValues letters = between(start, point, middle);
      const auto value = value_at_letters(letters);
      if (!value) return point.letters;
      (has_law({letters, *value}) ? in : out) = middle;
    }
    return between(start, point, std::min(1.0, out + well_beyond / all));
  }

  // The size of the first law, if the second is its opposite.
  std::optional<Value<Formula>> as_size() const {
    if (laws_.size() != 2 || !laws_[0].is_number() || !(laws_[0].number + laws_[1].number).is_zero())
      return std::nullopt;
    Value<Formula> size = laws_.front();
    size.number = sqrt(size.number * size.number);
    if (points_.front().value.number < 0) size.number = -size.number;
    const bool everywhere = std::ranges::all_of(points_, [&](const Point& point) { return holds(size, point); });
    return everywhere ? std::optional(size) : std::nullopt;
  }

  std::vector<Formula> candidates_of(const std::optional<Formula>& bound) const {
    std::vector<Formula> all;
    const auto add = [&](const Formula& one) {
      // What has one sign wherever it has a value parts nothing.
      if (one.is_number() || seen_sign(one).sign != 0) return;
      for (const Formula& side : {one, -one})
        if (std::ranges::find(all, side) == all.end()) all.push_back(side);
    };
    if (bound) add(*bound);
    for (std::size_t i = 0; i < laws_.size(); ++i) {
      for (const Formula& inside : domain_of(laws_[i])) add(inside);
      if (laws_[i].is_number())
        for (const Formula& inside : assumed_not_negative(laws_[i].number)) add(inside);
      for (std::size_t j = 0; j < i && laws_[i].is_number(); ++j) add(laws_[i].number - laws_[j].number);
    }
    return all;
  }

  static bool all_positive(const std::vector<Formula>& positive, const LetterValues& letters) {
    return std::ranges::all_of(positive, [&](const Formula& one) { return value_at(one, letters) > 0; });
  }
  // Whether a law holds wherever these are positive, and nowhere else alone.
  bool parts(const Value<Formula>& law, const std::vector<Formula>& positive) const {
    std::size_t inside = 0, outside = 0;
    for (const Point& point : points_) {
      const bool in = all_positive(positive, point.letters), does = holds(law, point);
      if (in && !does) return false;
      if (!in && does && std::ranges::none_of(laws_, [&](const Value<Formula>& other) {
            return &other != &law && holds(other, point);
          }))
        return false;
      ++(in ? inside : outside);
    }
    return inside >= least_on_each_side && outside >= least_on_each_side;
  }

  std::optional<std::vector<Formula>> condition_of(const Value<Formula>& law,
                                                   const std::vector<Formula>& candidates) const {
    std::optional<std::vector<Formula>> best;
    std::size_t length = 0;
    const auto look = [&](std::vector<Formula> positive) {
      std::size_t own = 0;
      for (const Formula& one : positive) own += condition_words(one, letters_).size();
      if ((best && own >= length) || !parts(law, positive) || !confirmed(law, positive)) return;
      best = std::move(positive);
      length = own;
    };
    for (const Formula& one : candidates) look({one});
    for (std::size_t i = 0; i < candidates.size() && !best; ++i)
      for (std::size_t j = 0; j < i; ++j) look({candidates[i], candidates[j]});
    return best;
  }

  // Goes from points inside to points outside, and looks on both sides of the border.
  bool confirmed(const Value<Formula>& law, const std::vector<Formula>& positive) const {
    std::size_t borders = 0;
    for (std::size_t i = 0; i < points_.size() && borders < most_borders; ++i) {
      const Point& start = points_[i];
      const Point& end = points_[(i * 7 + 3) % points_.size()];
      if (!all_positive(positive, start.letters) || all_positive(positive, end.letters)) continue;
      double in = 0, out = 1;
      for (int n = 0; n < 50; ++n) {
        const double middle = 0.5 * (in + out);
        (all_positive(positive, between(start, end, middle)) ? in : out) = middle;
      }
      const double step = beside_border / distance(start, end);
      const LetterValues before = between(start, end, in - step), beyond = between(start, end, out + step);
      if (!all_positive(positive, before) || all_positive(positive, beyond)) continue;
      const auto inside = value_at_letters(before), outside = value_at_letters(beyond);
      if (!inside || !outside) continue;
      if (!holds(law, {before, *inside}) || holds(law, {beyond, *outside})) return false;
      if (std::ranges::none_of(laws_, [&](const Value<Formula>& one) { return holds(one, {beyond, *outside}); }))
        return false;
      ++borders;
    }
    return borders > 0;
  }
  LetterValues between(const Point& start, const Point& end, double part) const {
    LetterValues letters = start.letters;
    for (auto& [name, value] : letters) value *= std::pow(end.letters.at(name) / value, part);
    return letters;
  }
  static double distance(const Point& start, const Point& end) {
    double most = 1e-9;
    for (const auto& [name, value] : start.letters)
      most = std::max(most, std::abs(std::log(end.letters.at(name) / value)));
    return most;
  }

  const std::size_t answer_;
  const std::vector<Letter>& letters_;
  const LetterValues& base_;
  const ScalingTrials::Solve& solve_;
  const double tolerance_;
  const WorkLimit limit_;
  std::vector<Point> points_;  // the base first
  std::vector<Value<Formula>> laws_;
};

}  // namespace

std::optional<std::vector<LawRegime>> law_regimes(
    const HeldLaw& first, const std::optional<Formula>& bound, const std::vector<Letter>& letters,
    const LetterValues& base, const ScalingTrials::Solve& solve,
    const std::function<std::optional<Value<Formula>>(const LetterValues& around)>& find, double tolerance, Work most) {
  return LawRegimes(first, letters, base, solve, tolerance, most).found(bound, find);
}

}  // namespace poinsot::problem
