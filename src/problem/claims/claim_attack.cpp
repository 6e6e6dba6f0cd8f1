#include "problem/claims/claim_attack.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "problem/formulas/letter_scan.h"

namespace poinsot::problem {
namespace {

constexpr std::size_t scanned_points = 200;  // all over six decades
constexpr std::size_t most_narrowed = 6;     // places from which the margin is made smaller
constexpr int most_rounds = 40;              // eight quarterings lead from the first step to the last: the others gain
constexpr double first_step = 2;             // in powers of ten; of an angle in radians
constexpr double last_step = 1e-4;           // the search ends where such steps bring nothing
constexpr double farthest = 1e8;             // times the unit of a letter, and as small a part of it
constexpr int random_moves = 6;              // of all letters together, in each round
constexpr int neighbours = 6;                // of a find, at which it is looked at too
constexpr double aside = 1e-5;          // of each letter: far more than moments are out of true by the rounding of data
constexpr double margin_gained = 1e-9;  // a part of the margin; what gains less is the rounding of its two sides
constexpr double leads_on = 1e-2;       // a part of the margin, or of what is left of it to one side

bool is_angle(const Letter& letter) { return letter.unit.dimension == dimensions::angle; }

// Whether an edge makes so much of a margin that steps as long as before may follow. Edges that do not would be met in
// all rounds one after the other, each by a little. A margin near one is that of sides whose ratio counts.
bool leads_on_from(double margin, double less) {
  return less < (1 - leads_on) * margin || (margin < 1 && 1 - less > (1 + leads_on) * (1 - margin));
}

}  // namespace

ClaimAttack::ClaimAttack(std::vector<Letter> letters, Margin margin, MakesSense makes_sense, Work most)
    : letters_(std::move(letters)), margin_(std::move(margin)), makes_sense_(std::move(makes_sense)), limit_(most) {
  std::ranges::sort(letters_, {}, &Letter::name);
}

// The place, if its margin is below a bound and the statement makes sense there.
std::optional<ClaimAttack::Place> ClaimAttack::look(Point point, double below) {
  ++tried_;
  const std::optional<double> margin = margin_(point);
  if (!margin || !(*margin < below) || !makes_sense_(point)) return std::nullopt;
  return Place{std::move(point), *margin};
}

std::optional<Point> ClaimAttack::from(const std::vector<Point>& starts) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  if (letters_.empty()) return std::nullopt;
  LetterValues units;
  for (const Letter& letter : letters_) units[letter.name] = letter.unit.factor;
  const LetterScan scan(letters_, units);
  std::vector<Place> places;
  const auto add = [&](const Point& point) {
    if (std::optional<Place> place = look(point, infinite)) places.push_back(std::move(*place));
  };
  for (const Point& point : starts) {
    if (limit_.spent()) break;
    add(point);
  }
  for (std::size_t i = 0; i < scanned_points && !limit_.spent(); ++i) add(scan.point(i));
  std::ranges::stable_sort(places, {}, &Place::margin);
  if (places.size() > most_narrowed) places.resize(most_narrowed);
  for (std::size_t k = 0; k < places.size(); ++k) {
    if (places[k].margin > 0) narrow(places[k], k);
    if (places[k].margin <= 0 && stands(places[k].point)) return places[k].point;
  }
  return std::nullopt;
}

// Whether the claim fails all around a point as well. A body that counts as possible by the rounding of its data only
// has a moment that is negative by as much, and next to it there are none that are possible and fail.
bool ClaimAttack::stands(const Point& point) {
  std::mt19937_64 random(9500);
  for (int i = 0; i < neighbours; ++i) {
    Point moved = point;
    for (const Letter& letter : letters_) {
      const double part = aside * std::uniform_real_distribution<double>(-1, 1)(random);
      double& value = moved[letter.name];
      value = is_angle(letter) ? value + part : value * (1 + part);
    }
    if (!look(std::move(moved), std::numeric_limits<double>::min())) return false;
  }
  return true;
}

// That with the least margin below a bound at which the statement makes sense. To see whether it does takes longer than
// a margin: the others are not asked.
std::optional<ClaimAttack::Place> ClaimAttack::best_of(std::vector<Point>& points, double below) {
  std::vector<Place> near;
  for (Point& point : points) {
    if (limit_.spent()) return std::nullopt;
    ++tried_;
    if (const std::optional<double> margin = margin_(point); margin && *margin < below)
      near.push_back({std::move(point), *margin});
  }
  std::ranges::stable_sort(near, {}, &Place::margin);
  const auto found = std::ranges::find_if(near, [&](const Place& place) { return makes_sense_(place.point); });
  return found == near.end() ? std::nullopt : std::optional(std::move(*found));
}

// Takes the best of all moves in each round. Where no step is better the edges are tried, once from each place, and
// then shorter steps.
void ClaimAttack::narrow(Place& place, std::size_t seed) {
  std::mt19937_64 random(9000 + seed);
  double step = first_step;
  Moves which = Moves::steps;
  bool edges_tried = false;  // from this place
  for (int round = 0; round < most_rounds && step > last_step && place.margin > 0; ++round) {
    std::vector<Point> all = moves(place.point, step, which);
    for (int i = 0; which == Moves::steps && i < random_moves; ++i) {
      Point moved = place.point;
      for (const Letter& letter : letters_) {
        const double part = std::uniform_real_distribution<double>(-1, 1)(random);
        double& value = moved[letter.name];
        value = is_angle(letter) ? value + part * step : value * std::pow(10, part * step);
      }
      all.push_back(std::move(moved));
    }
    const std::optional<Place> found = best_of(all, place.margin - margin_gained * std::abs(place.margin));
    if (limit_.spent()) return;
    const bool better = found && (which == Moves::steps || leads_on_from(place.margin, found->margin));
    if (found) place = *found;
    if (place.margin <= 0) return;
    if (better) edges_tried = false;
    if (!better && which == Moves::edges) edges_tried = true;
    if (!better && edges_tried) step /= 4;
    which = better || edges_tried ? Moves::steps : Moves::edges;
  }
}

std::vector<Point> ClaimAttack::moves(const Point& from, double step, Moves which) const {
  std::vector<Point> all;
  std::vector<double> met;  // values of a letter, of which a place like this has some more than once
  const auto add = [&](const Letter& letter, double value) {
    if (std::ranges::find(met, value) != met.end()) return;
    met.push_back(value);
    const double size = std::abs(value) / letter.unit.factor;
    const bool signed_or_angle = letter.either_sign || is_angle(letter);
    if (!std::isfinite(value) || size > farthest || (!signed_or_angle && !(size > 1 / farthest && value > 0))) return;
    Point moved = from;
    moved[letter.name] = value;
    all.push_back(std::move(moved));
  };
  for (const Letter& letter : letters_) {
    if (read_ && !read_->contains(letter.name)) continue;
    const double value = from.at(letter.name);
    met.assign(1, value);
    if (which == Moves::steps) {
      for (const double way : {step, -step}) add(letter, is_angle(letter) ? value + way : value * std::pow(10, way));
      continue;
    }
    if (is_angle(letter)) continue;
    if (letter.either_sign) {
      add(letter, -value);
      if (value != 0) add(letter, 0);
    }
    std::vector<double> others;  // of the same kind
    for (const Letter& other : letters_)
      if (other.name != letter.name && other.unit.dimension == letter.unit.dimension)
        others.push_back(from.at(other.name));
    for (std::size_t i = 0; i < others.size(); ++i) {
      add(letter, others[i]);
      for (std::size_t k = i + 1; k < others.size(); ++k) {
        add(letter, others[i] + others[k]);
        add(letter, std::abs(others[i] - others[k]));
      }
    }
  }
  return all;
}

}  // namespace poinsot::problem
