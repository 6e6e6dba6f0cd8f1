#include "engine/solve/roots/few_evaluations.h"

#include <algorithm>
#include <cmath>

#include "engine/solve/roots/linear_roots.h"
#include "engine/solve/roots/scattered_starts.h"

namespace poinsot::solve {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr int places_on_line = 31;
constexpr std::size_t random_places = 40, most_starts = 8;

struct Place {
  double u = 0;
  RootSample sample;
};

std::optional<Place> place_at(RootFunction& function, double u) {
  const auto sample = function.at(VectorXd::Constant(1, u));
  if (!sample || function.limit().spent()) return std::nullopt;
  return Place{u, *sample};
}

// Narrows a change of sign down by false position (Illinois' variant), until the bracket is small.
double narrowed_down(RootFunction& function, Place a, Place b, Index component) {
  // Newton's method starts from here and doubles the digits in each step, so that four are enough; a value that is
  // known from a motion followed to 1e-9 is zero to seven.
  constexpr double narrow = 1e-4, small = 1e-7;
  double at_a = a.sample.values[component], at_b = b.sample.values[component];
  for (int i = 0; i < 12 && std::abs(b.u - a.u) > narrow * std::max(std::abs(a.u), std::abs(b.u)); ++i) {
    const auto c = place_at(function, (at_a * b.u - at_b * a.u) / (at_a - at_b));
    if (!c || c->sample.values.size() != a.sample.values.size()) break;
    const double at_c = c->sample.values[component];
    if (std::abs(at_c) <= small * c->sample.size) return c->u;
    if ((at_c < 0) == (at_b < 0)) {
      at_a /= 2;
    } else {
      a = b;
      at_a = at_b;
    }
    b = *c;
    at_b = at_c;
  }
  return b.u;
}

std::vector<VectorXd> starts_on_line(RootFunction& function) {
  const RootRange& range = function.problem().ranges.front();
  std::vector<Place> places;
  for (int i = 0; i < places_on_line; ++i) {
    const double part = (i + 0.5) / places_on_line;
    if (auto place = place_at(function, place_in_range(range, part, 2))) places.push_back(std::move(*place));
  }
  std::vector<std::pair<double, VectorXd>> starts;  // with the misfit there
  const auto misfit = [&](std::size_t i) {
    return places[i].sample.values.norm() / std::max(places[i].sample.size, 1e-300);
  };
  const auto add = [&](double u, double value) { starts.emplace_back(value, VectorXd::Constant(1, u)); };
  for (std::size_t i = 0; i < places.size(); ++i) {
    const bool before = i > 0, after = i + 1 < places.size();
    bool changes = false;
    if (after && places[i].sample.values.size() == places[i + 1].sample.values.size())
      for (Index k = 0; k < places[i].sample.values.size() && !changes; ++k) {
        changes = (places[i].sample.values[k] < 0) != (places[i + 1].sample.values[k] < 0);
        if (changes) add(narrowed_down(function, places[i], places[i + 1], k), 0);
      }
    if ((!before || misfit(i) <= misfit(i - 1)) && (!after || misfit(i) <= misfit(i + 1))) add(places[i].u, misfit(i));
  }
  std::stable_sort(starts.begin(), starts.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<VectorXd> list;
  for (const auto& [value, start] : starts)
    if (list.size() < 2 * most_starts) list.push_back(start);
  return list;
}

}  // namespace

std::vector<VectorXd> starts_from_few_evaluations(RootFunction& function) {
  if (function.unknowns() == 1) return starts_on_line(function);
  std::vector<VectorXd> list = starts_at_random(function.problem(), random_places);
  list.insert(list.begin(), middle_of_ranges(function.problem()));
  std::vector<std::pair<double, VectorXd>> valued;
  for (const VectorXd& u : list) {
    if (function.limit().spent()) break;
    if (const auto sample = function.at(u)) valued.emplace_back(sample->values.norm(), u);
  }
  std::stable_sort(valued.begin(), valued.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<VectorXd> starts;
  for (const auto& [misfit, u] : valued)
    if (starts.size() < most_starts) starts.push_back(u);
  return starts;
}

}  // namespace poinsot::solve
