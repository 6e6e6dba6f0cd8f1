#include <cmath>
#include <utility>

#include "engine/math/trace/trace_nodes.h"

namespace poinsot {

using symbolic::Modular;
using symbolic::Residue;

namespace {

// The fraction n/d with d up to 10000 whose nearest double is x, by continued fractions.
bool find_fraction(double x, std::int64_t& numerator, std::int64_t& denominator) {
  double rest = x;
  std::int64_t n0 = 0, n1 = 1, d0 = 1, d1 = 0;
  for (int step = 0; step < 40; ++step) {
    const double whole = std::floor(rest);
    if (!(std::fabs(whole) < 1e12)) return false;
    const auto a = static_cast<std::int64_t>(whole);
    const std::int64_t n2 = a * n1 + n0, d2 = a * d1 + d0;
    if (d2 > 10000 || std::abs(n2) > (std::int64_t{1} << 52)) return false;
    n0 = std::exchange(n1, n2);
    d0 = std::exchange(d1, d2);
    if (static_cast<double>(n1) / static_cast<double>(d1) == x) {
      numerator = n1;
      denominator = d1;
      return true;
    }
    if (rest == whole) return false;
    rest = 1 / (rest - whole);
  }
  return false;
}

}  // namespace

Residue residue_of(double x) {
  std::int64_t n = 0, d = 0;
  if (find_fraction(x, n, d)) {
    const Residue above = Residue::of_integer(static_cast<std::uint64_t>(n));
    return d == 1 ? above : above * inverse(Residue::of_integer(static_cast<std::uint64_t>(d)));
  }
  int exponent = 0;
  const double mantissa = std::frexp(x, &exponent);
  const auto digits = static_cast<std::uint64_t>(std::ldexp(mantissa, 53));
  const int shift = exponent - 53;
  const Modular two = shift < 0 ? inverse(Modular(2)) : Modular(2);
  const Modular factor = power(two, static_cast<std::uint64_t>(std::abs(shift)));
  return Residue::of_integer((Modular(digits) * factor).number());
}

Residue residue_of_digits(const std::string& digits) {
  Residue r, tenth = Residue::of_integer(1);
  const Residue ten = Residue::of_integer(10);
  bool below = false;
  for (const char c : digits) {
    if (c == '.') {
      below = true;
      continue;
    }
    r = r * ten + Residue::of_integer(static_cast<std::uint64_t>(c - '0'));
    if (below) tenth = tenth * ten;
  }
  return below ? r * inverse(tenth) : r;
}

SmallFraction small_fraction(const Residue& residue, double value, double tolerance) {
  if (!(residue.at(0).imaginary == Modular()) || !(residue.at(0) == residue.at(1))) return {};
  // Of all n/d the one with small numbers, by Euclid's algorithm (Wang, SYMSAC 1981).
  std::int64_t r0 = static_cast<std::int64_t>(Modular::prime), s0 = 0;
  auto r1 = static_cast<std::int64_t>(residue.at(0).real.number());
  std::int64_t s1 = 1;
  while (r1 > 1'000'000'000) {
    const std::int64_t q = r0 / r1;
    r0 = std::exchange(r1, r0 - q * r1);
    s0 = std::exchange(s1, s0 - q * s1);
  }
  if (s1 < 0) {
    s1 = -s1;
    r1 = -r1;
  }
  if (s1 == 0 || s1 > 1'000'000) return {};
  const double quotient = static_cast<double>(r1) / static_cast<double>(s1);
  return std::fabs(quotient - value) <= tolerance * std::fabs(value) ? SmallFraction{r1, s1} : SmallFraction{};
}

}  // namespace poinsot
