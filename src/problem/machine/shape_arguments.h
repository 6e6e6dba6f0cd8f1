// The arguments of one shape, with their values.
#pragma once

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "poinsot/engine/mass/shape_faults.h"
#include "poinsot/engine/math/algebra/plain.h"
#include "problem/language/diagnostic.h"
#include "problem/machine/shapes.h"

namespace poinsot::problem {

template <class Scalar>
class ShapeArguments {
 public:
  using Vector = Vector3<Scalar>;

  // owner: the name of the body or part in messages. It must outlive the arguments.
  ShapeArguments(const Shape& shape, DataScope<Scalar>& data, const std::string& owner, bool particles)
      : shape_(shape), data_(data), owner_(owner), particles_(particles) {}

  bool has(const std::string& name) const {
    return std::any_of(shape_.arguments.begin(), shape_.arguments.end(),
                       [&](const NamedExpression& argument) { return argument.name == name; });
  }
  const Expression& expression(const std::string& name) const { return shape_argument(shape_, name, file()); }
  Vector place(const std::string& name) const { return data_.place(expression(name)); }
  Vector direction(const std::string& name) const { return data_.direction(expression(name)); }
  // A direction, or the direction from a place to the point that is named.
  Vector toward(const std::string& name, const Vector& from) const {
    const Expression& e = expression(name);
    const Name* point = e.as<Name>();
    const bool is_point = point && std::any_of(data_.situation().points.begin(), data_.situation().points.end(),
                                               [&](const NamedExpression& item) { return item.name == point->name; });
    if (!is_point) return data_.direction(e);
    const Vector d = data_.place(e) - from;
    if (!(norm(plain(d)) > 0)) refuse("the point under " + name + " is where it should be seen from");
    return normalized(d);
  }
  Scalar length(const std::string& name) const { return data_.number(expression(name), dimensions::length); }
  Scalar angle(const std::string& name) const { return data_.number(expression(name), dimensions::angle); }
  // The places in a list, which must have `count` items unless this is zero.
  std::vector<Vector> places(const std::string& name, std::size_t count = 0) const {
    std::vector<Vector> result;
    for (const Expression& item : items(name, count)) result.push_back(data_.place(item));
    return result;
  }
  // The sides of a rectangle or box, of which people give the lengths alone.
  std::vector<Vector> sides(std::size_t count) const {
    for (const Expression& item : items("sides", count))
      if (data_.value(item).is_number()) {
        const std::string length = to_string(item);
        fail(file(), item.mark(), "a side has a direction, and " + length + " is a length alone",
             "write it as a vector: [" + length + ", 0, 0] along x");
      }
    return places("sides", count);
  }
  std::vector<Vector> directions(const std::string& name, std::size_t count) const {
    std::vector<Vector> result;
    for (const Expression& item : items(name, count)) result.push_back(data_.direction(item));
    return result;
  }
  std::vector<Scalar> lengths(const std::string& name, std::size_t count) const {
    std::vector<Scalar> result;
    for (const Expression& item : items(name, count)) result.push_back(data_.number(item, dimensions::length));
    return result;
  }
  // Both ends of a cylinder that is given by center, axis and length.
  std::pair<Vector, Vector> ends() const {
    const Scalar length = this->length("length");
    if (!(plain(length) > 0)) refuse("its length must be more than zero");
    const Vector center = place("center"), half = Scalar(0.5) * length * direction("axis");
    return {center - half, center + half};
  }
  const std::string& file() const { return data_.situation().file; }
  const Shape& shape() const { return shape_; }
  const std::string& owner() const { return owner_; }

  // The values of the shape. `particles` makes the particles of the shape, if they are wanted.
  template <class Particles>
  ShapeValues<Scalar> values(Extent extent, const ShapeProperties<Scalar>& properties, Particles particles) const {
    return {extent, properties, particles_ ? particles() : ParticleSet<double>{}};
  }
  void check(const shape_faults::Fault& fault) const {
    if (fault) fail(file(), shape_.mark, fault->message);
  }
  [[noreturn]] void refuse(const std::string& message, const std::string& hint = "") const {
    fail(file(), shape_.mark, shape_.kind + " '" + owner_ + "': " + message, hint);
  }

 private:
  const std::vector<Expression>& items(const std::string& name, std::size_t count) const {
    const Expression& list_expression = expression(name);
    const List* list = list_expression.as<List>();
    if (!list || (count && list->items.size() != count))
      fail(file(), list_expression.mark(),
           "expected a list of " + (count ? std::to_string(count) + " items " : std::string()) + "in brackets for " +
               (name == "points" ? shape_.kind : name));
    return list->items;
  }

  const Shape& shape_;
  DataScope<Scalar>& data_;
  const std::string& owner_;
  bool particles_;
};

}  // namespace poinsot::problem
