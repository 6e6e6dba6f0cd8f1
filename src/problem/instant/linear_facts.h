// Recognises facts that are linear in the unknowns of an instant, and turns them into linear conditions.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "poinsot/engine/math/algebra/plain.h"
#include "poinsot/engine/solve/instant/equations.h"
#include "problem/instant/instant_conditions.h"

namespace poinsot::problem {

template <class Scalar>
using Conditions = std::vector<solve::ConditionOf<Scalar>>;

// Whether the linear conditions, which were found at other places, predict these values. unit: the least natural unit
// of an unknown, by which rounding is measured; if it is infinite, rounding is that of the terms alone.
template <class Scalar, class Values>
bool foretell(const Conditions<Scalar>& conditions, const std::vector<Scalar>& x, double unit, const Values& values) {
  if (values.size() != conditions.size()) return false;
  double reach = 0;
  for (const Scalar& each : x) reach = std::max(reach, std::abs(plain(each)) / unit);
  for (std::size_t i = 0; i < conditions.size(); ++i) {
    Scalar linear = -conditions[i].value;
    double size = std::abs(plain(linear));
    for (std::size_t k = 0; k < x.size(); ++k) {
      linear += conditions[i].coefficients[k] * x[k];
      size += std::abs(plain(conditions[i].coefficients[k]) * plain(x[k]));
    }
    const double value = plain(values[i].value);
    // Of the terms, of which a linear fact is foretold to 1e-14. At the farthest place, 1e12, the square of an unknown
    // shows beside the unknown itself with a factor of 1e-21.
    constexpr double foretold = 1e-9;
    // Where a coefficient vanishes, as that of a rate in a momentum that is to be zero, rounding is all that there is.
    constexpr double rounding = 1e-14;
    if (!(std::abs(value - plain(linear)) <=
          foretold * (size + std::abs(value)) + rounding * conditions[i].scale * reach))
      return false;
  }
  return true;
}

// Whether values change by clearly more than their rounding.
template <class Values>
bool notice(const Values& from, const Values& to) {
  constexpr double seen = 1e-6;  // of the value, so that ten digits of the change are left
  for (std::size_t i = 0; i < from.size(); ++i) {
    const double base = plain(from[i].value), change = plain(to[i].value) - base;
    if (!(std::abs(change) >= seen * std::abs(base))) return false;
  }
  return true;
}

// The numbered places at which facts are tried for being linear in some unknowns. The first is zero. Then come far
// ones: to both sides, as a size may look linear on one side, and farther and farther, as the stated value must not
// drown the unknowns. In the others one unknown is one and all else is zero. The places are the same for all facts,
// which can share what is computed there.
template <class Scalar>
class ProbePlaces {
 public:
  explicit ProbePlaces(std::size_t unknowns) : n_(unknowns) {}
  static constexpr std::size_t zero = 0, reaches = 4, far_places = 2 * reaches;
  static std::size_t far(std::size_t side, std::size_t reach) { return 1 + side * reaches + reach; }
  static std::size_t one(std::size_t unknown) { return 1 + far_places + unknown; }

  std::size_t unknowns() const { return n_; }
  std::vector<Scalar> operator[](std::size_t place) const {
    std::vector<Scalar> x(n_, Scalar(0));
    if (place >= one(0)) {
      x[place - one(0)] = Scalar(1);
    } else if (place > zero) {
      const std::size_t side = (place - 1) / reaches, reach = (place - 1) % reaches;
      std::minstd_rand random(static_cast<unsigned>(7 + place));
      std::uniform_real_distribution<double> part(0.5, 1.5);
      for (Scalar& each : x)
        each = Scalar((side == 0 ? 1 : -1) * std::pow(1e4, static_cast<double>(reach)) * part(random));
    }
    return x;
  }

 private:
  std::size_t n_;
};

// Scopes by number. Each is made when it is first used.
template <class Scope>
class NumberedScopes {
 public:
  using Make = std::function<std::unique_ptr<Scope>(std::size_t)>;
  explicit NumberedScopes(Make make) : make_(std::move(make)) {}
  Scope& operator[](std::size_t number) {
    std::unique_ptr<Scope>& scope = scopes_[number];
    if (!scope) scope = make_(number);
    return *scope;
  }

 private:
  Make make_;
  std::map<std::size_t, std::unique_ptr<Scope>> scopes_;
};

// A fact as linear conditions on the unknowns. values(place) gives the differences that must vanish; slopes(k, values
// there) gives their slopes by unknown k around zero. Returns nothing if the fact is not linear: it would not be
// known which of several solutions is meant.
template <class Scalar, class ValuesAt, class Slopes>
std::optional<Conditions<Scalar>> as_linear(const std::string& words, const solve::Scales& scales,
                                            const ProbePlaces<Scalar>& places, const ValuesAt& values,
                                            const Slopes& slopes,
                                            double unit = std::numeric_limits<double>::infinity()) {
  using Places = ProbePlaces<Scalar>;
  const std::size_t n = places.unknowns();
  try {
    const std::vector<Difference<Scalar>> base = values(Places::zero);
    Conditions<Scalar> conditions;
    for (const Difference<Scalar>& difference : base)
      conditions.push_back(
          {words, std::vector<Scalar>(n), -difference.value, natural_unit(scales, difference.dimension)});
    for (std::size_t k = 0; k < n; ++k) {
      const std::vector<Scalar> column = slopes(k, base);
      if (column.size() != conditions.size()) return std::nullopt;
      for (std::size_t i = 0; i < column.size(); ++i) conditions[i].coefficients[k] = column[i];
    }
    for (const std::size_t side : {0, 1})
      for (std::size_t reach = 0; reach < Places::reaches; ++reach) {
        const std::size_t place = Places::far(side, reach);
        const std::vector<Difference<Scalar>> there = values(place);
        if (!foretell(conditions, places[place], unit, there)) return std::nullopt;
        if (notice(base, there)) break;
      }
    return conditions;
  } catch (const StatementError&) {
    // A quantity that has no value at rest, such as a direction, is not linear. Errors are reported when the solution
    // is checked.
  } catch (const std::domain_error&) {
  }
  return std::nullopt;
}

// The same, where slopes are the changes when one unknown goes from zero to one. This is exact for linear facts.
template <class Scalar, class ValuesAt>
std::optional<Conditions<Scalar>> as_linear(const std::string& words, const solve::Scales& scales,
                                            const ProbePlaces<Scalar>& places, const ValuesAt& values) {
  return as_linear<Scalar>(words, scales, places, values,
                           [&](std::size_t k, const std::vector<Difference<Scalar>>& base) {
                             std::vector<Scalar> slopes;
                             const std::vector<Difference<Scalar>> there = values(ProbePlaces<Scalar>::one(k));
                             for (std::size_t i = 0; i < std::min(there.size(), base.size()); ++i)
                               slopes.push_back(there[i].value - base[i].value);
                             return slopes;
                           });
}

}  // namespace poinsot::problem
