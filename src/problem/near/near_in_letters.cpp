// The rates l of growth are the roots of det(M l^2 + C l + K) = 0, of which each factor that is linear or quadratic in
// l, or in l^2 where no odd powers occur, has its roots in formulas. The response to forces f exp(i w t) is
//
//   x = (K - w^2 M + i w C)^-1 f,
//
// by Cramer's rule, and of a coordinate j that is driven by a exp(i w t) that to f = -(K_j - w^2 M_j + i w C_j) a.
#include "problem/near/near_in_letters.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <utility>

#include "poinsot/engine/dynamics/kinematics.h"
#include "poinsot/engine/math/formula/formula_decision.h"
#include "poinsot/engine/math/formula/formula_sign.h"
#include "problem/language/exact_numbers.h"
#include "problem/near/near_steady_formulas.h"
#include "problem/quantities/quantities.h"
#include "problem/quantities/quantity_functions.h"
#include "problem/quantities/quantity_values.h"

namespace poinsot::problem {
namespace {

// Of formulas that are read; determinants of more have thousands of terms.
constexpr std::size_t most_freedoms_in_letters = 4;
constexpr std::size_t most_shaken_in_letters = 3;

struct Rate {
  Formula growth, frequency;
};

// That of `steady:`, if it is stated.
const Frame* frame_of(const Situation& situation) {
  if (!situation.steady) return nullptr;
  const auto frame = std::ranges::find(situation.frames, situation.steady->frame, &Frame::name);
  return frame == situation.frames.end() ? nullptr : &*frame;
}

void require_tree(const InstantInLetters& instant) {
  const Situation& situation = instant.situation;
  if (!instant.machine.mechanism.constraints.empty())
    throw NoFormula("where loops, contacts or cords hold, the motion near this one is found by numbers");
  if (situation.has_friction()) throw NoFormula("with dry friction the motion near this one is found by numbers");
  if (const Frame* frame = frame_of(situation); frame && frame->acceleration)
    throw NoFormula("in such a frame the motion near this one is found by numbers");
}

SteadyFormulas motion_of(const InstantInLetters& instant) {
  require_tree(instant);
  return steady_formulas(instant.situation, instant.machine, instant.q, instant.v, instant.numbers);
}

// The coordinates by which the mass center moves that the frame rides on: `steady:` says nothing of them.
std::vector<std::size_t> ridden_coordinates(const InstantInLetters& instant) {
  const Frame* frame = frame_of(instant.situation);
  if (!frame || frame->rides_on.empty()) return {};
  const auto& body = instant.machine.mechanism.tree.body(instant.machine.index.at(frame->rides_on));
  if (body.joint != JointType::free) return {};
  const auto first = static_cast<std::size_t>(body.v) + 3;
  return {first, first + 1, first + 2};
}

// Takes out coordinates that the motion of the others does not depend on.
void leave_out(const std::vector<std::size_t>& out, const std::vector<std::size_t>& free, LinearisedFormulas& near) {
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < free.size(); ++i)
    if (std::ranges::find(out, free[i]) == out.end()) kept.push_back(i);
  std::vector<Formula> unrest;
  for (const std::size_t i : kept) unrest.push_back(near.unrest[i]);
  near.unrest = std::move(unrest);
  for (FormulaMatrix* matrix : {&near.M, &near.C, &near.K}) {
    FormulaMatrix rest;
    for (const std::size_t i : kept) {
      rest.emplace_back();
      for (std::size_t k = 0; k < free.size(); ++k)
        if (std::ranges::find(kept, k) != kept.end())
          rest.back().push_back((*matrix)[i][k]);
        else if (!(*matrix)[i][k].is_zero())
          throw NoFormula("of what moves with the mass center that the frame rides on it is found by numbers");
    }
    *matrix = std::move(rest);
  }
}

LinearisedFormulas equations_of(const SteadyFormulas& motion, const std::vector<std::size_t>& free,
                                const std::vector<std::size_t>& out = {}) {
  if (free.size() <= out.size()) throw NoFormula("nothing moves near this motion");
  if (free.size() > most_freedoms_in_letters + out.size())
    throw NoFormula("so many freedoms near this motion are solved by numbers");
  LinearisedFormulas near = linearised(motion, free);
  if (!out.empty()) leave_out(out, free, near);
  if (std::ranges::any_of(near.unrest, [](const Formula& left) { return !left.is_zero(); }))
    throw NoFormula("that the motion is steady is not seen in letters");
  return near;
}

// The rates for which c0 + c1 z + c2 z^2 vanishes, z a rate or, of even polynomials, its square.
void add_rates_of(const std::vector<Formula>& c, bool of_square, std::vector<Rate>& rates) {
  const auto add = [&](const Formula& z) {
    if (!of_square) return rates.push_back({z, Formula()});
    if (decided_negative(z)) return rates.push_back({Formula(), sqrt(-z)});
    for (const int sign : {1, -1}) rates.push_back({Formula(sign) * sqrt(z), Formula()});
  };
  if (c.size() == 2) return add(-c[0] / c[1]);
  if (c.size() != 3) throw NoFormula("its characteristic polynomial has a factor of higher degree");
  const Formula square = c[1] * c[1] - Formula(4) * c[0] * c[2], twice = Formula(2) * c[2];
  if (square.is_zero()) throw NoFormula("two of its rates are the same");
  if (!decided_negative(square)) {
    const Formula root = sqrt(square);
    add((-c[1] - root) / twice);
    return add((-c[1] + root) / twice);
  }
  if (of_square) {
    // The square z = p + i q of a rate and its conjugate: the rates are the four roots of both.
    const Formula size = sqrt(c[0] / c[2]), p = -c[1] / twice;
    const Formula growth = sqrt((size + p) / Formula(2)), frequency = sqrt((size - p) / Formula(2));
    for (const int sign : {1, -1}) rates.push_back({Formula(sign) * growth, frequency});
    return;
  }
  rates.push_back({-c[1] / twice, sqrt(-square) / (decided_negative(twice) ? -twice : twice)});
}

// What is tilted in free space stays so, and goes round in a frame that turns by W: l^2 + W^2 is a factor that tells of
// no swing.
void take_out_going_round(const Formula& W_squared, std::vector<Formula>& c) {
  if (W_squared.is_zero() || c.size() < 3) return;
  std::vector<Formula> rest = c, quotient(c.size() - 2);
  for (std::size_t k = c.size() - 1; k >= 2; --k) {
    quotient[k - 2] = rest[k];
    rest[k - 2] -= W_squared * rest[k];
  }
  if (rest[0].is_zero() && rest[1].is_zero()) c = std::move(quotient);
}

// in_space: the square of the rate of a frame that rides on a mass center.
std::vector<Rate> rates_of(const LinearisedFormulas& near, const Formula& in_space = Formula()) {
  std::vector<Formula> c = characteristic_polynomial(near);
  while (!c.empty() && c.front().is_zero()) c.erase(c.begin());
  take_out_going_round(in_space, c);
  bool even = true;
  for (std::size_t k = 1; k < c.size(); k += 2) even = even && c[k].is_zero();
  const std::string name = "unknown rate";
  const Formula z = Formula::letter(name, poinsot::Sign::real);
  Formula polynomial, power(1);
  std::size_t degree = 0;
  for (std::size_t k = 0; k < c.size(); k += even ? 2 : 1, power *= z) {
    polynomial += c[k] * power;
    if (!c[k].is_zero()) degree = even ? k / 2 : k;
  }
  std::vector<Rate> rates;
  if (degree <= 2) {
    if (degree > 0) add_rates_of(coefficients_by(polynomial, name, degree), even, rates);
    return rates;
  }
  std::size_t found = 0;
  for (const Formula& factor : vanishing_factors(polynomial)) {
    const std::vector<Formula> of_factor = coefficients_by(factor, name, degree);
    if (of_factor.size() < 2) continue;
    found += of_factor.size() - 1;
    add_rates_of(of_factor, even, rates);
  }
  if (found != degree) throw NoFormula("its characteristic polynomial is not seen as a product");
  return rates;
}

Value<Formula> inverse_time(const Formula& x) { return number_value(x, dimensions::none / dimensions::time); }

Value<Formula> told_rates(const std::string& function, std::vector<Rate> rates) {
  std::ranges::sort(rates, [](const Rate& a, const Rate& b) {
    const double fa = plain(a.frequency), fb = plain(b.frequency);
    return fa != fb ? fa < fb : plain(a.growth) < plain(b.growth);
  });
  if (function == "growth_rate") {
    // The fastest growth, zero where nothing grows.
    Formula fastest;
    for (const Rate& rate : rates)
      if (!rate.growth.is_zero() && decided_negative(fastest - rate.growth)) fastest = rate.growth;
    return inverse_time(fastest);
  }
  std::vector<Value<Formula>> items;
  for (const Rate& rate : rates) {
    if (function == "eigenvalues")
      items.push_back(Value<Formula>::of_list({inverse_time(rate.growth), inverse_time(rate.frequency)}));
    else if (!rate.frequency.is_zero())
      items.push_back(number_value(rate.frequency, dimensions::angular_velocity));
  }
  return Value<Formula>::of_list(std::move(items));
}

// Of rates of which none vanishes. Which of them grow, and which only swing, the letters decide.
Value<Formula> told_stability(const std::string& function, const std::vector<Rate>& rates) {
  if (rates.empty()) throw NoFormula("nothing swings near this motion: what decides its stability is found by numbers");
  bool grows = false;
  for (const Rate& rate : rates) grows = (!rate.growth.is_zero() && !decided_negative(rate.growth)) || grows;
  if (function == "stable") return Value<Formula>::of_truth(!grows);
  return Value<Formula>::of_text(grows ? "unstable" : "stable");
}

struct Complex {
  Formula real{}, imaginary{};

  friend Complex operator*(const Complex& a, const Complex& b) {
    return {a.real * b.real - a.imaginary * b.imaginary, a.real * b.imaginary + a.imaginary * b.real};
  }
  Complex& operator+=(const Complex& b) {
    real += b.real;
    imaginary += b.imaginary;
    return *this;
  }
  Complex operator-() const { return {-real, -imaginary}; }
  bool is_zero() const { return real.is_zero() && imaginary.is_zero(); }
};
using ComplexMatrix = std::vector<std::vector<Complex>>;

// The response of a mechanism at rest to what shakes it.
class ResponseInLetters {
 public:
  ResponseInLetters(const InstantInLetters& instant, const Call& call)
      : instant_(instant), motion_(motion_of(instant)), free_(free_coordinates(motion_)) {
    if (motion_.frame != ground || std::ranges::any_of(free_, [&](std::size_t k) { return !instant.v[k].is_zero(); }))
      throw NoFormula("the response of what moves, but for spins, is found by numbers");
    const Name* name = call.argument("to")->as<Name>();
    const auto stated = name ? std::ranges::find(instant.situation.excitations, name->name, &Excitation::name)
                             : instant.situation.excitations.end();
    if (stated == instant.situation.excitations.end()) throw NoFormula("what shakes is not known");
    if (free_.size() > most_shaken_in_letters) throw NoFormula("the response of so many freedoms is found by numbers");
    const Expression* at = call.argument("at");
    if (!at && !stated->frequency && !stated->unbalance) throw NoFormula("its frequency is not stated");
    if (!stated->unbalance) w_ = instant.data.number(at ? *at : *stated->frequency, dimensions::angular_velocity);
    solve(*stated);
  }

  // Of a quantity that follows from places.
  Value<Formula> of(const Expression& quantity) const {
    if (level_of(instant_.situation, quantity) != Level::position)
      throw NoFormula("the response of what does not follow from places is found by numbers");
    std::vector<Complex> swings;
    Dimension dimension;
    bool vector = false;
    for (std::size_t k = 0; k < moving_.size(); ++k) {
      const Value<Formula> slope = rate_along(quantity, moving_[k]);
      vector = slope.is_vector();
      dimension = slope.dimension * dimensions::time;
      const std::vector<Formula> parts = vector ? std::vector<Formula>{slope.vector.x, slope.vector.y, slope.vector.z}
                                                : std::vector<Formula>{slope.number};
      swings.resize(parts.size());
      for (std::size_t part = 0; part < parts.size(); ++part)
        swings[part] += Complex{parts[part], Formula()} * above_[k];
    }
    std::vector<Value<Formula>> rows;
    const auto& plane = instant_.situation.plane;
    for (std::size_t part = 0; part < swings.size(); ++part)
      if (!vector || !plane || part != plane->normal()) rows.push_back(told(swings[part], dimension));
    return vector ? Value<Formula>::of_list(std::move(rows)) : rows.front();
  }

 private:
  Complex stiffness(const LinearisedFormulas& near, std::size_t i, std::size_t k) const {
    return {near.K[i][k] - w_ * w_ * near.M[i][k], w_ * near.C[i][k]};
  }

  void solve(const Excitation& stated) {
    const std::optional<Shaking> shaking = stated.coordinate.empty() ? std::optional(shaking_of(stated)) : std::nullopt;
    const LinearisedFormulas near = equations_of(motion_, free_);
    if (near.follows_spin) throw NoFormula("the response on axes that do not follow the spin is found by numbers");
    std::vector<Complex> f(free_.size());
    moving_ = free_;
    std::optional<Complex> driven;
    if (!stated.coordinate.empty()) {
      const NamedCoordinate* coordinate = instant_.machine.coordinate(stated.coordinate);
      if (!coordinate) throw NoFormula("what is shaken is not known");
      const auto j = static_cast<std::size_t>(coordinate->velocity);
      std::vector<std::size_t> all = free_;
      all.push_back(j);
      const LinearisedFormulas with = linearised(motion_, all);
      driven = Complex{instant_.data.number(*stated.by, coordinate->turning ? dimensions::angle : dimensions::length),
                       Formula()};
      for (std::size_t i = 0; i < free_.size(); ++i) f[i] = -(stiffness(with, i, free_.size()) * *driven);
      moving_.push_back(j);
    } else {
      for (std::size_t i = 0; i < free_.size(); ++i) f[i] = work_along(stated, *shaking, free_[i]);
    }
    ComplexMatrix Z(free_.size());
    for (std::size_t i = 0; i < free_.size(); ++i)
      for (std::size_t k = 0; k < free_.size(); ++k) Z[i].push_back(stiffness(near, i, k));
    below_ = determinant(Z);
    if (below_.is_zero()) throw NoFormula("a free swing has this frequency");
    for (std::size_t k = 0; k < free_.size(); ++k) {
      ComplexMatrix with = Z;
      for (std::size_t i = 0; i < free_.size(); ++i) with[i][k] = f[i];
      above_.push_back(determinant(with));
    }
    if (driven) above_.push_back(*driven * below_);
  }

  State<Formula> state_along(std::size_t k) const {
    State<Formula> state{instant_.q, std::vector<Formula>(instant_.v.size())};
    state.v[k] = Formula(1);
    return state;
  }

  // The force and the couple that shake, each by its real and imaginary part: what goes round about n, from u on, is
  // the real part of (u - i n x u) exp(i w t).
  using Parts = std::array<Vector3<Formula>, 2>;
  struct Shaking {
    int body;
    Parts force{}, couple{};
  };
  static Parts going_round(const Vector3<Formula>& u, const Vector3<Formula>& n) { return {u, -cross(n, u)}; }

  Shaking shaking_of(const Excitation& stated) {
    const Model<Formula>& tree = instant_.machine.mechanism.tree;
    Workspace<Formula> w(tree);
    update_velocities(tree, w, State<Formula>{instant_.q, instant_.v});
    Shaking shaking{instant_.machine.index.at(stated.body)};
    DataScope<Formula>& data = instant_.data;
    if (stated.unbalance) {
      // A mass to the side of the axis takes the force U w^2 towards it, and the couple of its weight.
      const auto [rate, n] = size_and_direction(angular_velocity(w, shaking.body));
      w_ = rate;
      const Formula U = data.number(*stated.unbalance, dimensions::mass * dimensions::length);
      const Parts u = going_round(direction_on_ground(tree, w, shaking.body, data.direction(*stated.direction)), n);
      for (const std::size_t k : {0U, 1U}) {
        shaking.force[k] = U * rate * rate * u[k];
        shaking.couple[k] = U * cross(u[k], tree.gravity());
      }
      return shaking;
    }
    const Expression& size = stated.couple ? *stated.couple : *stated.force;
    const Dimension dimension = stated.couple ? dimensions::moment : dimensions::force;
    const Vector3<Formula> own = stated.direction ? data.number(size, dimension) * data.direction(*stated.direction)
                                                  : data.vector(size, dimension);
    const auto on_ground = [&](const Vector3<Formula>& v) {
      return direction_on_ground(tree, w, instant_.machine.index.at(stated.axes), v);
    };
    (stated.couple ? shaking.couple : shaking.force) =
        stated.turns ? going_round(on_ground(own), on_ground(data.direction(*stated.turns)))
                     : Parts{on_ground(own), Vector3<Formula>::zero()};
    return shaking;
  }
  static std::pair<Formula, Vector3<Formula>> size_and_direction(const Vector3<Formula>& v) {
    std::optional<std::size_t> along;
    for (std::size_t k = 0; k < 3; ++k) {
      if (v[k].is_zero()) continue;
      if (along) throw NoFormula("the unbalance of what spins about no axis of the figure is found by numbers");
      along = k;
    }
    if (!along) throw NoFormula("what does not spin has no unbalance that goes round");
    const int sign = decided_negative(v[*along]) ? -1 : 1;
    Vector3<Formula> axis = Vector3<Formula>::zero();
    axis[*along] = Formula(sign);
    return {Formula(sign) * v[*along], axis};
  }

  // What shakes does such work as a coordinate moves by one.
  Complex work_along(const Excitation& stated, const Shaking& shaking, std::size_t k) const {
    const Model<Formula>& tree = instant_.machine.mechanism.tree;
    Workspace<Formula> w(tree);
    update_velocities(tree, w, state_along(k));
    Vector3<Formula> moved = Vector3<Formula>::zero();
    const SpatialInertia<Formula>& mass = tree.body(shaking.body).inertia;
    if (stated.at)
      moved = point_velocity(tree, w, shaking.body,
                             instant_.machine.place(shaking.body, instant_.data.place(*stated.at)).point);
    else if (!mass.mass.is_zero())
      moved = point_velocity(tree, w, shaking.body, Vector3<Formula>(mass.first_moment / mass.mass));
    else if (!stated.couple)
      throw NoFormula("where the force acts is not known");
    const Vector3<Formula> turned = angular_velocity(w, shaking.body);
    const auto work = [&](std::size_t part) {
      return dot(shaking.force[part], moved) + dot(shaking.couple[part], turned);
    };
    return {work(0), work(1)};
  }

  // By how much a quantity changes as a coordinate moves by one.
  Value<Formula> rate_along(const Expression& quantity, std::size_t k) const {
    QuantityScope<Formula> scope(instant_.machine, instant_.machine.mechanism.tree, instant_.data, state_along(k));
    scope.set_accelerations(std::vector<Formula>(instant_.v.size()));
    const Expression rate{
        std::make_shared<Node>(Node{Call{"rate", {{"", quantity}}}, quantity.mark(), quantity->height + 1})};
    return scope.value(rate);
  }

  // Of a swing N/D with the determinant D: its amplitude and its phase, from -180 deg up.
  Value<Formula> told(const Complex& N, const Dimension& dimension) const {
    const Complex& D = below_;
    const Formula real = N.real * D.real + N.imaginary * D.imaginary,
                  imaginary = N.imaginary * D.real - N.real * D.imaginary;
    Formula amplitude, phase;
    if (imaginary.is_zero()) {
      const bool opposite = decided_negative(real);
      amplitude = real / (D.real * D.real + D.imaginary * D.imaginary);
      if (opposite) amplitude = -amplitude, phase = -Formula::pi();
    } else {
      amplitude = sqrt(N.real * N.real + N.imaginary * N.imaginary) / sqrt(D.real * D.real + D.imaginary * D.imaginary);
      phase = atan2(imaginary, real);
    }
    std::vector<Value<Formula>> both{number_value(amplitude, dimension), number_value(phase, dimensions::angle)};
    both[0].text = "amplitude";
    both[1].text = "phase";
    return Value<Formula>::of_list(std::move(both));
  }

  const InstantInLetters& instant_;
  const SteadyFormulas motion_;
  const std::vector<std::size_t> free_;
  Formula w_;
  std::vector<std::size_t> moving_;  // the free coordinates, and behind them one that is driven
  std::vector<Complex> above_;       // of each of them, over below_
  Complex below_;
};

}  // namespace

Value<Formula> near_in_letters(const InstantInLetters& instant, const Call& call) {
  if (call.function == "response") return ResponseInLetters(instant, call).of(call.arguments[0].value);
  const bool in_words = call.function == "stability" || call.function == "stable";
  if (!in_words && call.function != "frequencies" && call.function != "growth_rate" && call.function != "eigenvalues")
    throw NoFormula("no formula is known for " + call.function + "()");
  const SteadyFormulas motion = motion_of(instant);
  const std::vector<std::size_t> free = free_coordinates(motion), ridden = ridden_coordinates(instant);
  Formula in_space;
  if (const Frame* frame = frame_of(instant.situation); frame && !frame->rides_on.empty()) {
    Workspace<Formula> w(instant.machine.mechanism.tree);
    update_velocities(instant.machine.mechanism.tree, w, State<Formula>{instant.q, instant.v});
    in_space = norm_squared(angular_velocity(w, motion.frame));
  }
  const std::vector<Rate> rates = rates_of(equations_of(motion, free, ridden), in_space);
  return in_words ? told_stability(call.function, rates) : told_rates(call.function, rates);
}

}  // namespace poinsot::problem
