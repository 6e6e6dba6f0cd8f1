#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "engine/math/formula/formula_fraction.h"
#include "poinsot/engine/math/formula/formula_angle.h"
#include "poinsot/engine/math/formula/formula_decision.h"

namespace poinsot {
namespace {

using namespace symbolic;

constexpr std::size_t most_angles = 2;   // letters of which a sum is sought
constexpr int most_times = 2;            // that each may stand in it
constexpr int parts_of_half_turn = 180;  // the parts of pi that are tried
constexpr double to_a_part = 1e-9;       // rad: what figures have as a part of pi is one but for rounding

// The angles whose sines and cosines are in a formula.
void add_angles(const Formula& x, std::vector<Formula>& angles) {
  if (!x.fraction()) return;
  for (const GeneratorPointer& g : *x.fraction()->generators) {
    if (g->kind != Kind::tangent) continue;
    const Formula angle = ratio_formula(g->multiple) * g->argument;
    if (std::find(angles.begin(), angles.end(), angle) == angles.end()) angles.push_back(angle);
  }
}

bool is_angle_of(const Formula& angle, const Formula& sine, const Formula& cosine) {
  const auto [s, c] = sine_cosine(angle);
  return (sine * c - cosine * s).is_zero();
}

}  // namespace

std::optional<Formula> letters_of_angle(const Formula& sine, const Formula& cosine) {
  std::vector<Formula> angles;
  for (const Formula* one : {&sine, &cosine}) add_angles(*one, angles);
  if (angles.empty() || angles.size() > most_angles) return std::nullopt;
  const double value = std::atan2(plain(sine), plain(cosine));
  if (angles.size() < most_angles) angles.resize(most_angles);
  for (int m = -most_times; m <= most_times; ++m)
    for (int n = -most_times; n <= most_times; ++n) {
      if (angles[1].is_zero() && n != 0) continue;
      const Formula sum = Formula(m) * angles[0] + Formula(n) * angles[1];
      if (sum.is_zero()) continue;
      const double parts = (value - plain(sum)) * parts_of_half_turn / std::numbers::pi, whole = std::round(parts);
      if (std::abs(parts - whole) > to_a_part * parts_of_half_turn || std::abs(whole) > 100 * parts_of_half_turn)
        continue;
      const Formula angle =
          sum + Formula(static_cast<std::int64_t>(whole)) * Formula::pi() / Formula(parts_of_half_turn);
      if (!is_angle_of(angle, sine, cosine)) continue;
      note_sign(Formula::pi() - angle);
      note_sign(Formula::pi() + angle);
      return angle;
    }
  return std::nullopt;
}

}  // namespace poinsot
