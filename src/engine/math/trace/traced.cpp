#include "poinsot/engine/math/trace/traced.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <stdexcept>
#include <utility>

#include "engine/math/trace/trace_nodes.h"
#include "poinsot/engine/work/budget.h"

namespace poinsot {

using symbolic::mixed;
using symbolic::Residue;

namespace {

using Op = TracedOperation;

constexpr std::uint64_t input_seed = 0x1b873593U, function_seed = 0xcc9e2d51U;

// How far the value of an operation, computed in doubles, may be off.
double rounding_of(Op operation, const Rounded& a, const Rounded& b, double value) {
  const auto beside = [](const Rounded& sine) { return sqrt((Rounded(1) - sine) * (Rounded(1) + sine)); };
  const auto error = [&]() -> long double {
    switch (operation) {
      case Op::constant:
      case Op::input:
        return 0;
      case Op::add:
        return (a + b).error;
      case Op::multiply:
        return (a * b).error;
      case Op::divide:
        return (a / b).error;
      case Op::square_root:
        return sqrt(a).error;
      case Op::sine:
        return sine_cosine(a).sine.error;
      case Op::cosine:
        return sine_cosine(a).cosine.error;
      case Op::arc_sine:
        return atan2(a, beside(a)).error;
      case Op::arc_cosine:
        return atan2(beside(a), a).error;
      case Op::arc_tangent:
        return atan2(a, Rounded(1)).error;
      case Op::arc_tangent_2:
        return atan2(a, b).error;
      case Op::absolute:
        return a.error;
    }
    return 0;
  };
  return static_cast<double>(error()) + std::numeric_limits<double>::epsilon() * std::fabs(value);
}

}  // namespace

// What the operations do with the trace that is being recorded.
struct TraceAccess {
  static thread_local Trace::State* current;

  static Trace::State& trace() {
    if (!current) throw std::logic_error("a Traced number is computed with while no TraceScope lives");
    return *current;
  }
  static const Trace::Node& node(const Traced& x) { return trace().nodes[x.node()]; }
  static double value(const Traced& x) {
    if (x.node() == 0) return 0;
    const double size = node(x).value;
    return x.negative() ? -size : size;
  }
  static Rounded rounded(const Traced& x) { return {value(x), x.node() == 0 ? 0 : node(x).rounding}; }
  static Residue residue(const Traced& x) {
    if (x.node() == 0) return Residue();
    const Residue& r = node(x).residue;
    return x.negative() ? -r : r;
  }
  static bool constant(const Traced& x) { return x.node() == 0 || node(x).operation == Op::constant; }
  static bool is_one(const Traced& x) { return x.node() == 1; }

  // The same value somewhere in the trace, if there is one.
  static bool find(const Residue& r, const Rounded& value, Traced& found) {
    if (r.is_zero()) {
      found = Traced();
      return true;
    }
    const Trace::State& t = trace();
    const auto it = t.known.find(r.hash_up_to_sign());
    if (it == t.known.end()) return false;
    const Trace::Node& node = t.nodes[it->second];
    const bool negative = !(node.residue == r);
    if (negative && !(node.residue == -r)) return false;
    if (!same_at_sample(negative ? -node.rounded() : node.rounded(), value)) return false;
    found = Traced(it->second, negative);
    return true;
  }
  // Another residue than it has stands for a number that is there already with this one, or minus it, but takes another
  // value at the sample: equal residues are one number, and opposite ones add up to zero.
  static Traced add(Trace::Node node) {
    check_budget();
    Trace::State& t = trace();
    const auto id = static_cast<std::uint32_t>(t.nodes.size());
    if (!t.known.try_emplace(node.residue.hash_up_to_sign(), id).second) {
      node.residue = Residue::random(mixed(t.nodes.size()) ^ function_seed);
      t.known.emplace(node.residue.hash_up_to_sign(), id);
    }
    t.nodes.push_back(node);
    return Traced(id, false);
  }
  static Traced found_or_added(Op operation, const Traced& a, const Traced& b, double value, const Residue& r) {
    const double rounding = rounding_of(operation, rounded(a), rounded(b), value);
    Traced found;
    if (find(r, {value, rounding}, found)) return found;
    if (!r.is_unit()) return add({operation, a, b, value, 0, r, rounding});
    const std::uint64_t direction = direction_hash(r);
    Trace::State& t = trace();
    if (const auto it = t.directions.find(direction); it != t.directions.end()) {
      // A multiple of what is there, by a fraction of small numbers.
      const Traced other(it->second, false);
      const double ratio = value / TraceAccess::value(other);
      const Residue factor = r * inverse(residue(other));
      // Of values that may have cancelled; the residue tells which fraction it is, the value only which of its signs.
      constexpr double ratio_of_values = 1e-9;
      const SmallFraction fraction = small_fraction(ratio < 0 ? -factor : factor, std::fabs(ratio), ratio_of_values);
      if (fraction.denominator != 0) {
        const double size = static_cast<double>(fraction.numerator) / static_cast<double>(fraction.denominator);
        const Traced coefficient = traced_constant(ratio < 0 ? -size : size, factor);
        const bool plain_product = operation == Op::multiply && constant(a);
        if (!plain_product) return coefficient * other;
      }
    }
    const Traced added = add({operation, a, b, value, 0, r, rounding});
    t.directions.emplace(direction, added.node());
    return added;
  }

  static Traced constant(double value, const Residue& r, double rounding) {
    Traced found;
    if (find(r, {value, rounding}, found) && constant(found)) return found;
    if (value < 0) return -add({Op::constant, {}, {}, -value, 0, -r, rounding});
    return add({Op::constant, {}, {}, value, 0, r, rounding});
  }
  // An operation on constants.
  static Traced constant(Op operation, const Traced& a, const Traced& b, double value, const Residue& r) {
    return r.is_zero() ? Traced() : constant(value, r, rounding_of(operation, rounded(a), rounded(b), value));
  }

  // f(x), opaque: known by its argument.
  static Traced call(Op f, const Traced& x, const Traced& y, double value) {
    if (constant(x) && constant(y)) {
      if (!std::isfinite(value)) throw std::domain_error("a function has no finite value at a constant");
      return constant_of(value);
    }
    const std::uint64_t seed =
        mixed(residue(x).hash() + 3 * residue(y).hash()) ^ mixed(function_seed + static_cast<std::uint64_t>(f));
    return found_or_added(f, x, y, value, Residue::random(seed));
  }
  static Traced constant_of(double value) {
    if (!std::isfinite(value)) throw std::domain_error("a number of a traced computation is not finite");
    if (value == 0) return Traced();
    const Residue r = residue_of(std::fabs(value));
    return constant(value, value < 0 ? -r : r, rounding_of(Op::constant, {}, {}, value));
  }
};
thread_local Trace::State* TraceAccess::current = nullptr;

Trace::Trace() : state_(std::make_unique<State>()) {
  // Zero and one come first.
  state_->nodes.push_back({});
  state_->nodes.push_back({Op::constant, {}, {}, 1, 0, Residue::of_integer(1)});
  state_->known.emplace(state_->nodes[0].residue.hash_up_to_sign(), 0);
  state_->known.emplace(state_->nodes[1].residue.hash_up_to_sign(), 1);
  state_->directions.emplace(direction_hash(state_->nodes[1].residue), 1);
}
Trace::~Trace() = default;
Trace::Trace(Trace&&) noexcept = default;
Trace& Trace::operator=(Trace&&) noexcept = default;

Traced Trace::input(double sample) {
  const TraceScope scope(*this);
  const std::uint32_t number = state_->inputs++;
  Node node;
  node.operation = Op::input;
  node.value = sample;
  node.input = number;
  node.residue = Residue::random(input_seed + number);
  const Traced added = TraceAccess::add(node);
  state_->directions.emplace(direction_hash(state_->nodes[added.node()].residue), added.node());
  return added;
}
const std::vector<Traced>& Trace::assumed_positive() const { return state_->assumed_positive; }
std::size_t Trace::input_count() const { return state_->inputs; }
const std::vector<Trace::Node>& Trace::nodes() const { return state_->nodes; }

TraceScope::TraceScope(Trace& trace) : outer_(std::exchange(TraceAccess::current, trace.state_.get())) {}
TraceScope::~TraceScope() { TraceAccess::current = outer_; }

Traced operated(TracedOperation operation, const Traced& first, const Traced& second) {
  using Op = TracedOperation;
  switch (operation) {
    case Op::constant:
    case Op::input:
      break;
    case Op::add:
      return first + second;
    case Op::multiply:
      return first * second;
    case Op::divide:
      return first / second;
    case Op::square_root:
      return sqrt(first);
    case Op::sine:
      return sin(first);
    case Op::cosine:
      return cos(first);
    case Op::arc_sine:
      return asin(first);
    case Op::arc_cosine:
      return acos(first);
    case Op::arc_tangent:
      return atan(first);
    case Op::arc_tangent_2:
      return atan2(first, second);
    case Op::absolute:
      return abs(first);
  }
  return {};
}

Traced traced_constant(double value, const Residue& residue, double rounding) {
  if (residue.is_zero()) return Traced();
  return TraceAccess::constant(value, residue, std::max(rounding, rounding_of(Op::constant, {}, {}, value)));
}

Traced Traced::constant(double number) { return number == 0 ? Traced() : TraceAccess::constant_of(number); }

Traced operator+(const Traced& a, const Traced& b) {
  if (a.node() == 0) return b;
  if (b.node() == 0) return a;
  if (a.node() == b.node() && a.negative() != b.negative()) return Traced();
  const double value = TraceAccess::value(a) + TraceAccess::value(b);
  const Residue r = TraceAccess::residue(a) + TraceAccess::residue(b);
  if (TraceAccess::constant(a) && TraceAccess::constant(b)) return TraceAccess::constant(Op::add, a, b, value, r);
  if (a.node() == b.node()) return Traced(2) * a;
  // The first operand is positive, and the earlier one where both are.
  const bool turned = a.negative() && b.negative();
  Traced first = turned ? -a : a, second = turned ? -b : b;
  if (first.negative() || (!second.negative() && second.node() < first.node())) std::swap(first, second);
  const Traced sum = TraceAccess::found_or_added(Op::add, first, second, turned ? -value : value, turned ? -r : r);
  return turned ? -sum : sum;
}

Traced operator*(const Traced& a, const Traced& b) {
  if (a.node() == 0 || b.node() == 0) return Traced();
  const bool negative = a.negative() != b.negative();
  Traced first(a.node(), false), second(b.node(), false);
  const auto with_sign = [negative](const Traced& x) { return negative ? -x : x; };
  if (TraceAccess::is_one(first)) return with_sign(second);
  if (TraceAccess::is_one(second)) return with_sign(first);
  if (second.node() < first.node()) std::swap(first, second);
  if (TraceAccess::constant(second)) std::swap(first, second);
  const double value = TraceAccess::value(first) * TraceAccess::value(second);
  const Residue r = TraceAccess::residue(first) * TraceAccess::residue(second);
  if (TraceAccess::constant(first)) {
    if (TraceAccess::constant(second)) return with_sign(TraceAccess::constant(Op::multiply, first, second, value, r));
    // Of several constant factors one is left.
    const Trace::Node inner = TraceAccess::node(second);
    if (inner.operation == Op::multiply && TraceAccess::constant(inner.first))
      return with_sign((first * inner.first) * inner.second);
  }
  if (first == second && TraceAccess::node(first).operation == Op::square_root)
    return with_sign(Traced(TraceAccess::node(first).first));
  return with_sign(TraceAccess::found_or_added(Op::multiply, first, second, value, r));
}

Traced operator/(const Traced& a, const Traced& b) {
  if (b.node() == 0) throw std::domain_error("a division by zero: what stands below the line vanishes everywhere");
  if (a.node() == 0) return Traced();
  const bool negative = a.negative() != b.negative();
  const Traced above(a.node(), false), below(b.node(), false);
  const auto with_sign = [negative](const Traced& x) { return negative ? -x : x; };
  if (TraceAccess::is_one(below)) return with_sign(above);
  const Residue divisor = TraceAccess::residue(below);
  const Residue r = divisor.is_unit() ? TraceAccess::residue(above) * inverse(divisor)
                                      : Residue::random(divisor.hash() + 3 * TraceAccess::residue(above).hash());
  const double value = TraceAccess::value(above) / TraceAccess::value(below);
  if (TraceAccess::constant(below)) {
    if (TraceAccess::constant(above)) return with_sign(TraceAccess::constant(Op::divide, above, below, value, r));
    const double factor = 1 / TraceAccess::value(below);
    return with_sign(TraceAccess::constant(Op::divide, Traced(1), below, factor, inverse(divisor)) * above);
  }
  return with_sign(TraceAccess::found_or_added(Op::divide, above, below, value, r));
}

Traced sqrt(const Traced& x) {
  if (x.node() == 0) return x;
  const double value = std::sqrt(TraceAccess::value(x));
  const bool constant = is_constant(x);
  if (constant && x.negative()) throw std::domain_error("the square root of a negative number");
  const Residue square = TraceAccess::residue(x);
  if (constant) {
    if (const SmallFraction f = small_fraction(square, plain(x)); f.denominator != 0) {
      const auto n = std::llround(std::sqrt(static_cast<double>(f.numerator)));
      const auto d = std::llround(std::sqrt(static_cast<double>(f.denominator)));
      if (n * n == f.numerator && d * d == f.denominator) return Traced(n) / Traced(d);
    }
  }
  const auto root = square_root(square);
  const Residue r = root ? *root : Residue::random(square.hash() ^ function_seed);
  if (constant) return TraceAccess::constant(Op::square_root, x, {}, value, r);
  // Of a square that is known, whatever signs its roots at the two points have.
  if (root) {
    const double rounding = rounding_of(Op::square_root, TraceAccess::rounded(x), {}, value);
    for (const Residue& candidate : {*root, -*root, other_sign(*root), -other_sign(*root)}) {
      Traced known;
      if (!TraceAccess::find(candidate, {value, rounding}, known)) continue;
      TraceAccess::trace().assumed_positive.push_back(known);
      return known;
    }
  }
  return TraceAccess::found_or_added(Op::square_root, x, {}, value, r);
}

SineCosine<Traced> sine_cosine(const Traced& x) {
  if (x.node() == 0) return {Traced(), Traced(1)};
  if (x.negative()) {
    const auto [s, c] = sine_cosine(-x);
    return {-s, c};
  }
  const double value = TraceAccess::value(x), sine = std::sin(value), cosine = std::cos(value);
  if (is_constant(x)) return {Traced(sine), Traced(cosine)};
  // sin = 2t / (1 + t^2), cos = (1 - t^2) / (1 + t^2) with a random tangent t of half the angle.
  const Residue one = Residue::of_integer(1);
  const Residue t = Residue::random(TraceAccess::residue(x).hash() ^ mixed(function_seed));
  const Residue below = inverse(one + t * t);
  return {TraceAccess::found_or_added(Op::sine, x, {}, sine, (t + t) * below),
          TraceAccess::found_or_added(Op::cosine, x, {}, cosine, (one - t * t) * below)};
}

SineVersine<Traced> sine_versine(const Traced& x) {
  const auto [s, c] = sine_cosine(x);
  return {s, Traced(1) - c};
}
Traced sin(const Traced& x) { return sine_cosine(x).sine; }
Traced cos(const Traced& x) { return sine_cosine(x).cosine; }
Traced tan(const Traced& x) {
  const auto [s, c] = sine_cosine(x);
  return s / c;
}
Traced asin(const Traced& x) {
  return x.negative() ? -asin(-x) : TraceAccess::call(Op::arc_sine, x, {}, std::asin(plain(x)));
}
Traced acos(const Traced& x) { return TraceAccess::call(Op::arc_cosine, x, {}, std::acos(plain(x))); }
Traced atan(const Traced& x) {
  return x.negative() ? -atan(-x) : TraceAccess::call(Op::arc_tangent, x, {}, std::atan(plain(x)));
}
Traced atan2(const Traced& y, const Traced& x) {
  return TraceAccess::call(Op::arc_tangent_2, y, x, std::atan2(plain(y), plain(x)));
}
Traced abs(const Traced& x) {
  const Traced size(x.node(), false);
  return is_constant(x) ? size : TraceAccess::call(Op::absolute, size, {}, std::fabs(plain(x)));
}

double plain(const Traced& x) { return TraceAccess::value(x); }
bool is_constant(const Traced& x) { return TraceAccess::constant(x); }

}  // namespace poinsot
