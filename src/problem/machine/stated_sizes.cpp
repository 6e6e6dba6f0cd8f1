#include "problem/machine/stated_sizes.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "poinsot/engine/math/algebra/plain.h"
#include "problem/language/diagnostic.h"

namespace poinsot::problem {

double StatedSizes::of(const Dimension& d) const {
  const double time = std::sqrt(length / gravity);
  return std::pow(length, d.length / 12.0) * std::pow(mass, d.mass / 12.0) * std::pow(time, d.time / 12.0);
}

template <class Scalar>
StatedSizes stated_sizes(DataScope<Scalar>& data) {
  using poinsot::plain;
  StatedSizes sizes{0, 0, plain(data.gravity_size())};
  std::optional<Vector3<double>> first;
  for (const NamedExpression& point : data.situation().points) try {
      const Vector3<double> place = plain(data.place(point.value));
      if (!first) first = place;
      sizes.length = std::max(sizes.length, norm(place - *first));
    } catch (const StatementError&) {
      // A point may hang on what is not known yet.
    }
  for (const Body& body : data.situation().bodies) {
    const auto take = [&](const std::optional<Expression>& amount, const Dimension& dimension, double per) {
      if (!amount || is_any(*amount) || !(per > 0)) return;
      try {
        sizes.mass = std::max(sizes.mass, std::abs(plain(data.number(*amount, dimension))) / per);
      } catch (const StatementError&) {
        // It may be an unknown, or of a wrong dimension, which the reader of the body tells.
      }
    };
    const auto take_all = [&](const Amount& amount) {
      take(amount.mass, dimensions::mass, 1);
      take(amount.weight, dimensions::force, sizes.gravity);
    };
    take_all(body.amount);
    for (const Part& part : body.parts) take_all(part.amount);
    for (const Part& part : body.added) take_all(part.amount);
  }
  // Powers of two: what is left open must not change with a datum that is varied a little.
  for (double* size : {&sizes.length, &sizes.mass, &sizes.gravity})
    *size = *size > 0 ? std::exp2(std::round(std::log2(*size))) : 1;
  return sizes;
}

template StatedSizes stated_sizes(DataScope<double>&);
template StatedSizes stated_sizes(DataScope<Dual<1>>&);

}  // namespace poinsot::problem
