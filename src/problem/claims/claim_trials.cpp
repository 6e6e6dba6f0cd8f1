#include "problem/claims/claim_trials.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "poinsot/engine/math/formula/certain_value.h"
#include "poinsot/engine/math/formula/formula_sign.h"
#include "poinsot/engine/work/work.h"
#include "problem/claims/claim_letters.h"

namespace poinsot::problem {
namespace {

constexpr std::size_t most_edge_terms = 60;      // of a difference whose factors may vanish at an edge
constexpr std::size_t most_edge_letters = 3;     // letters that are moved to an edge, in turn
constexpr Work most_edge_work = 50'000'000;      // on each formula of an edge
constexpr int most_exact_equalities = 8;         // of one claim, whose sides numbers cannot tell apart
constexpr Work most_exact_work = 200'000'000;    // on each of these
constexpr std::size_t most_exact_terms = 20000;  // of their formulas, as of answers

bool is_strict(Relation relation) { return relation == Relation::less || relation == Relation::greater; }

bool is_identity(const WorkedCase& one, const FormulaComparison& comparison) {
  try {
    return one.proves(comparison);
  } catch (const std::domain_error&) {
    return false;
  } catch (const FormulaTooLarge&) {
    return false;
  }
}

// Whether a formula has the first digits of a value beside a point too, so that it does not vanish at what decimals the
// letters of the point are: these are ten thousand times nearer.
bool is_alike_beside(const Formula& x, const Point& at, double value) {
  constexpr double beside = 1e-12, digits = 1e-3;  // parts of each letter and of the value
  constexpr int neighbours = 2;
  std::mt19937_64 random(9700);
  for (int n = 0; n < neighbours; ++n) {
    Point moved = at;
    for (auto& [letter, number] : moved) number *= 1 + std::uniform_real_distribution<double>(-beside, beside)(random);
    if (!(std::abs(near_value_at(x, moved) - value) < digits * std::abs(value))) return false;
  }
  return true;
}

// Where a line vanishes, the other letters being as at a point.
std::optional<double> root_at(const ClaimTrials::Line& line, const Point& at) {
  const double root = -value_at(line.start, at) / value_at(line.slope, at);
  return std::isfinite(root) ? std::optional(root) : std::nullopt;
}

}  // namespace

bool is_positive(const Letter& letter) { return !letter.either_sign && letter.unit.dimension != dimensions::angle; }

std::optional<ClaimTrials::Drawn> ClaimTrials::draw(int attempt) {
  const std::vector<WorkedCase>& cases = worked_.cases();
  if (cases.empty()) return std::nullopt;
  const WorkedCase& one = cases[attempt % 3 != 0 ? 0 : static_cast<std::size_t>(attempt / 3) % cases.size()];
  Point free = draw_point(free_letters(one), attempt, sizes_);
  // In half of the attempts the new letters are small beside the others.
  if (attempt % 2 == 1)
    for (const std::string& part : one.letters())
      if (free.contains(part)) free[part] /= 4;
  return completed(one, std::move(free));
}

std::vector<Letter> ClaimTrials::free_letters(const WorkedCase& one) const {
  std::vector<Letter> letters;
  for (const Letter& letter : letters_)
    if (!one.values().contains(letter.name)) letters.push_back(letter);
  for (const std::string& part : one.letters())
    if (!one.values().contains(part)) letters.push_back({part, {}, {}});
  return letters;
}

std::optional<double> ClaimTrials::margin(const Drawn& drawn) {
  auto [identities, fresh] = identities_.try_emplace(drawn.of);
  if (fresh)
    for (const ClaimTerm& term : formulas_.terms())
      identities->second.push_back(term.comparison.relation == Relation::equal &&
                                   is_identity(*drawn.of, term.comparison));
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < formulas_.terms().size(); ++k) {
    if (identities->second[k]) continue;
    const FormulaComparison& comparison = formulas_.terms()[k].comparison;
    const double left = near_value_at(comparison.left, drawn.point),
                 right = near_value_at(comparison.right, drawn.point);
    if (!std::isfinite(left) || !std::isfinite(right)) return std::nullopt;
    least = std::min(least, margin_of(left, right, comparison.relation));
  }
  return least;
}

std::set<std::string> ClaimTrials::read_by_margin(const WorkedCase& one) const {
  std::set<std::string> read;
  for (const ClaimTerm& term : formulas_.terms())
    for (const Formula* side : {&term.comparison.left, &term.comparison.right})
      for (std::string& letter : side->letters()) read.insert(std::move(letter));
  for (const auto& [letter, value] : one.values())
    if (read.contains(letter))
      for (std::string& part : value.letters()) read.insert(std::move(part));
  return read;
}

std::optional<ClaimTrials::Drawn> ClaimTrials::completed(const WorkedCase& one, Point free, bool edge) {
  Point all = free;
  for (const auto& [letter, value] : one.values()) {
    all[letter] = value_at(value, free);
    if (!std::isfinite(all[letter])) return std::nullopt;
  }
  for (const std::string& part : one.letters()) all.erase(part);
  for (const Letter& letter : letters_)
    if (is_positive(letter) && !(all.at(letter.name) > 0)) return std::nullopt;
  Drawn drawn{std::move(all), &one, std::move(free), edge};
  // Assumed equations that are worked into the letters hold up to rounding and need no check.
  for (const FormulaComparison& assumption : formulas_.assumptions())
    if (assumption.relation != Relation::equal || !one.unsolved().empty()) {
      const Verdict assumed = compared(assumption, drawn, {});
      if (!assumed.holds || (assumed.close && !assumed.exact)) return std::nullopt;
    }
  return drawn;
}

// The difference of two sides of a comparison at a point, for where rounding hides it. size: of the sides.
std::optional<double> ClaimTrials::exactly(const FormulaComparison& comparison, const Drawn& drawn, double size) {
  const FormulaLimitScope limits({most_exact_terms, most_exact_work});
  try {
    auto [known, fresh] = differences_.try_emplace({drawn.of, &comparison});
    if (fresh) known->second = drawn.of->apply(comparison.difference());
    if (!known->second) return std::nullopt;
    // The letters of a point are the decimals that are read of it. Where that may matter, formulas are made of these.
    constexpr double decimal = 1e-13;
    if (const std::optional<double> certain = certain_value_at(*known->second, drawn.free);
        certain &&
        (drawn.edge ? is_alike_beside(*known->second, drawn.free, *certain) : std::abs(*certain) > decimal * size))
      return certain;
    std::map<std::string, Formula> numbers;
    for (const auto& [letter, value] : drawn.free) numbers[letter] = Formula(value);
    const Formula difference = poinsot::substituted(*known->second, numbers);
    return difference.is_number() ? std::optional(plain(difference)) : std::nullopt;
  } catch (const std::domain_error&) {
    return std::nullopt;
  } catch (const FormulaTooLarge&) {
    // An example is the sine of a number with many digits.
    return std::nullopt;
  }
}

// Judges a comparison at a point by numbers. Where rounding might decide, and at edges, it is judged exactly if
// possible.
Verdict ClaimTrials::compared(const FormulaComparison& comparison, const Drawn& drawn, const Dimension& dimension) {
  Verdict verdict;
  const double left = value_at(comparison.left, drawn.point), right = value_at(comparison.right, drawn.point);
  if (!std::isfinite(left) || !std::isfinite(right)) {
    verdict.close = true;
    return verdict;
  }
  verdict.judge(left, right, comparison.relation, 0, dimension);
  if (comparison.relation == Relation::equal) {
    if (!verdict.holds || exact_equalities_ >= most_exact_equalities) return verdict;
    // The sides may differ by less than rounding.
    ++exact_equalities_;
    const std::optional<double> difference = exactly(comparison, drawn, std::max(std::abs(left), std::abs(right)));
    if (!difference || *difference == 0) return verdict;
    verdict.refute(left, right, dimension);
    verdict.exact = true;
    verdict.difference = *difference;
    return verdict;
  }
  if (!verdict.close && !drawn.edge) return verdict;
  const std::optional<double> difference = exactly(comparison, drawn, std::max(std::abs(left), std::abs(right)));
  if (!difference) return verdict;
  verdict = {};
  verdict.close = verdict.exact = true;
  const double exact = *difference;
  const bool greater = comparison.relation == Relation::greater || comparison.relation == Relation::greater_equal;
  if (exact == 0 ? is_strict(comparison.relation) : (exact > 0) != greater) verdict.refute(left, right, dimension);
  return verdict;
}

Verdict ClaimTrials::verdict(const Drawn& drawn) {
  Verdict verdict;
  for (const ClaimTerm& term : formulas_.terms()) {
    // Sides that are identical differ by rounding only.
    if (term.comparison.relation == Relation::equal && is_identity(*drawn.of, term.comparison)) continue;
    const Verdict own = compared(term.comparison, drawn, term.dimension);
    if (!own.holds && verdict.holds) {
      verdict = own;
    } else if (own.holds && own.close && !own.exact) {
      verdict.close = true;
    }
  }
  return verdict;
}

const std::optional<ClaimTrials::Line>& ClaimTrials::Edge::line_along(const std::string& letter) {
  const auto [known, fresh] = lines.try_emplace(letter);
  if (!fresh) return known->second;
  try {
    const Formula slope = derivative(factor, letter);
    const std::vector<std::string> in_slope = slope.letters();
    if (!slope.is_zero() && std::ranges::find(in_slope, letter) == in_slope.end())
      known->second = Line{poinsot::substituted(factor, {{letter, Formula(0)}}), slope};
  } catch (const std::domain_error&) {
  } catch (const FormulaTooLarge&) {
    // It is told by no line: the edge is met along other letters.
  }
  return known->second;
}

std::vector<ClaimTrials::Edge>& ClaimTrials::edges() {
  if (edges_) return *edges_;
  edges_.emplace();
  const FormulaLimitScope limits({most_edge_terms, most_edge_work});
  // Both claims and assumptions have edges.
  std::vector<FormulaComparison> comparisons;
  for (const ClaimTerm& term : formulas_.terms()) comparisons.push_back(term.comparison);
  for (const FormulaComparison& assumption : formulas_.assumptions()) comparisons.push_back(assumption);
  for (const WorkedCase& one : worked_.cases())
    for (const FormulaComparison& comparison : comparisons) {
      if (comparison.relation == Relation::equal) continue;
      try {
        const Formula difference = one.apply(comparison.difference());
        if (difference.terms() > most_edge_terms) continue;
        for (const Formula& factor : vanishing_factors(difference)) edges_->push_back({&one, factor, {}});
      } catch (const std::domain_error&) {
      } catch (const FormulaTooLarge&) {
        // Such a comparison is tried at random points only.
      }
    }
  return *edges_;
}

// Points of an edge at which one of three moments is the sum or the difference of two others as well: a flat body has
// such moments, and one whose products of inertia reach what its moments allow is thin, which an edge alone does not
// meet. The other moments of the edge are taken as large as a product in it, so that all of them have few digits.
std::vector<Point> ClaimTrials::where_bodies_end(const Drawn& from, const Edge& edge, const std::string& letter) const {
  const std::vector<std::string> on = edge.factor.letters();
  const auto on_edge = [&](const std::string& name) { return std::ranges::find(on, name) != on.end(); };
  std::vector<std::string> moments;
  std::optional<double> product;
  for (const Letter& one : letters_) {
    if (one.unit.dimension != dimensions::moment_of_inertia || !from.free.contains(one.name)) continue;
    if (is_positive(one))
      moments.push_back(one.name);
    else if (const double size = std::abs(from.free.at(one.name)); on_edge(one.name) && size > 0)
      product = size;
  }
  Point at_edge = from.free;
  for (const std::string& moment : moments)
    if (product && on_edge(moment)) at_edge[moment] = *product;
  const std::optional<double> root = root_at(*edge.lines.at(letter), at_edge);
  if (!root) return {};
  at_edge[letter] = *root;
  std::vector<Point> points;
  for (const std::string& moved : moments) {
    if (on_edge(moved)) continue;
    for (std::size_t i = 0; i < moments.size(); ++i)
      for (std::size_t k = i + 1; k < moments.size(); ++k) {
        if (moments[i] == moved || moments[k] == moved) continue;
        const double one = at_edge.at(moments[i]), other = at_edge.at(moments[k]);
        for (const double moment : {one + other, std::abs(one - other)}) {
          points.push_back(at_edge);
          points.back()[moved] = moment;
        }
      }
  }
  return points;
}

std::vector<ClaimTrials::Drawn> ClaimTrials::at_edges(const Drawn& from, int attempt) {
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
  if (attempt == 0)
    for (Point& alike : alike_points(free_letters(*from.of), from.free))
      if (auto drawn = completed(*from.of, std::move(alike), true)) found.push_back(std::move(*drawn));
  const FormulaLimitScope limits({most_edge_terms, most_edge_work});
  for (Edge& edge : edges()) {
    if (edge.of != from.of) continue;
    const std::vector<std::string> letters = edge.factor.letters();
    for (std::size_t k = 0; k < std::min(letters.size(), most_edge_letters); ++k) try {
        const std::string& letter = letters[(static_cast<std::size_t>(attempt) + k) % letters.size()];
        const std::optional<Line>& line = edge.line_along(letter);
        if (!line) continue;
        for (Point& thin : where_bodies_end(from, edge, letter))
          if (auto drawn = completed(*from.of, std::move(thin), true)) found.push_back(std::move(*drawn));
        const std::optional<double> where = root_at(*line, from.free);
        if (!where) continue;
        const double root = *where;
        // Just beside the edge: near enough for what fails only there, and far enough that the digits of a formula show
        // on which side it is. An edge at zero is left by a part of the value from which the letter comes.
        constexpr double beside = 1e-6, beside_zero = 1e-9;
        const double step = beside * std::abs(root) + beside_zero * std::abs(from.free.at(letter));
        for (const double place : {root, root + step, root - step})
          if (!is_part(letter) || place > 0) add(letter, place);
      } catch (const std::domain_error&) {
      } catch (const FormulaTooLarge&) {
        // The formula has no value there, or its value takes too many terms.
      }
  }
  return found;
}

}  // namespace poinsot::problem
