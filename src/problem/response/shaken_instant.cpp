// Deviations are complex amplitudes on axes that follow the frame and no spin. In a phase p of the swing they are the
// real parts of x exp(i p), so that a quantity changes by the real part of X exp(i p): X follows from its change at the
// phases 0 and -90 deg. If the change is another where frame and spins have turned meanwhile, the quantity does not
// swing at this one frequency.
#include "problem/response/shaken_instant.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "poinsot/engine/dynamics/momentum.h"
#include "poinsot/engine/math/algebra/rotation.h"
#include "poinsot/engine/solve/instant/closure.h"
#include "poinsot/engine/solve/stability/near_equations.h"
#include "poinsot/engine/solve/stability/spectrum_check.h"
#include "problem/language/diagnostic.h"
#include "problem/language/scalar_value.h"
#include "problem/language/words.h"
#include "problem/quantities/asks_model.h"
#include "problem/quantities/quantity_values.h"

namespace poinsot::problem {
namespace {

using Varied = Dual<1>;

constexpr double quarter_back = -std::numbers::pi / 2;
// Of the terms: equations that are solved in doubles, near a resonance of high quality.
constexpr double holds_closely = 1e-8;
// Of its natural size: what is rounding of a response.
constexpr double no_swing = 1e-12;

Vector3<double> part_of(const solve::ComplexVector3& v, double phase) {
  const std::complex<double> turn = std::polar(1.0, phase);
  return {(v[0] * turn).real(), (v[1] * turn).real(), (v[2] * turn).real()};
}
Vector3<double> change_of(const Vector3<Varied>& v) { return {v.x.partial[0], v.y.partial[0], v.z.partial[0]}; }

}  // namespace

void ShakenInstant::build() {
  DataScope<TimeJetOf<Varied>> timed(base_.situation_, base_.settings_, time_jet(Varied(base_.time_)));
  std::size_t next = 0;
  const AnyValue any = [&](const Dimension&) { return base_.any_values_.at(next++); };
  const auto loads = base_.situation_.stages.empty() ? std::nullopt : base_.situation_.stages.front().loads;
  machine_ = build_machine(base_.situation_, data_, timed, any, base_.machine_options(base_.time_, loads));
  Mechanism<Varied>& mechanism = machine_.mechanism;
  if (excitation_.at.body != ground) {
    KnownForce<Varied> force;
    force.action = static_cast<int>(mechanism.actions.size());
    mechanism.actions.push_back({ActionKind::load, stated_.name, "", excitation_.at.body, ground});
    const Vector3<double>& P = excitation_.at.point;
    force.at = {excitation_.at.body, {Varied(P.x), Varied(P.y), Varied(P.z)}};
    mechanism.forces.push_back(force);
    force.couple = true;
    mechanism.forces.push_back(force);
  }
  state_.emplace(mechanism);
}

bool ShakenInstant::turns() const {
  return std::ranges::any_of(motion_.v, [](double rate) { return rate != 0; });
}

// What is constant on axes that do not follow the spins, on the axes of the bodies after a while: exp(-S t) along.
std::vector<double> ShakenInstant::later(const std::vector<double>& along, double delay) const {
  if (motion_.spins.empty() || delay == 0) return along;
  const auto S = solve::adjoint_rows(machine_.mechanism.tree, [&] {
    std::vector<std::pair<int, SpatialMotion<Varied>>> spins;
    for (const auto& [body, twist] : motion_.spins) {
      const auto varied = [](const Vector3<double>& v) {
        return Vector3<Varied>{Varied(v.x), Varied(v.y), Varied(v.z)};
      };
      spins.emplace_back(body, SpatialMotion<Varied>{varied(twist.angular), varied(twist.linear)});
    }
    return spins;
  }());
  // The series in steps of a small part of a turn.
  double rate = 0;
  for (const auto& row : S)
    for (const Varied& entry : row) rate = std::max(rate, std::abs(entry.value));
  const int steps = 1 + static_cast<int>(8 * std::abs(rate * delay));
  const double step = delay / steps;
  std::vector<double> x = along;
  for (int k = 0; k < steps; ++k) {
    std::vector<double> term = x;
    for (int order = 1; order <= 20; ++order) {
      std::vector<double> next(x.size(), 0.0);
      for (std::size_t i = 0; i < x.size(); ++i)
        for (std::size_t j = 0; j < x.size(); ++j) next[i] -= S[i][j].value * term[j] * step / order;
      term = next;
      for (std::size_t i = 0; i < x.size(); ++i) x[i] += term[i];
    }
  }
  return x;
}

void ShakenInstant::put(double delay, double phase, double by) {
  const Model<double>& tree = base_.machine_.mechanism.tree;
  std::vector<double> q = base_.machine_.q, carried = base_.v_, spun(base_.v_.size(), 0.0);
  for (const auto& [body, twist] : motion_.spins) {
    const auto first = static_cast<std::size_t>(tree.body(body).v);
    for (std::size_t k = 0; k < 3; ++k) {
      spun[first + k] = twist.angular[k];
      if (tree.body(body).joint == JointType::free) spun[first + 3 + k] = twist.linear[k];
    }
  }
  for (std::size_t k = 0; k < carried.size(); ++k) carried[k] -= spun[k];
  if (delay != 0) {
    integrate_position<double>(tree, q, carried, delay);
    integrate_position<double>(tree, q, spun, delay);
  }
  const auto swung = [&](const std::vector<std::complex<double>>& x) {
    std::vector<double> now;
    for (const std::complex<double>& part : x) now.push_back((part * std::polar(1.0, phase)).real());
    return later(now, delay);
  };
  const std::vector<double> dq = swung(shown_.q), dv = swung(shown_.v), da = swung(shown_.a);
  std::vector<double> v = later(base_.v_, delay);
  std::vector<double> a = later(base_.mechanism_state_->accelerations(), delay);
  if (by != 0) {
    integrate_position<double>(tree, q, dq, by);
    for (std::size_t k = 0; k < v.size(); ++k) {
      v[k] += by * dv[k];
      a[k] += by * da[k];
    }
  }
  std::vector<double> rate(q.size());
  position_rate<double>(tree, q, dq, rate);
  const auto varied = [](const std::vector<double>& value, const std::vector<double>& change) {
    std::vector<Varied> both;
    for (std::size_t k = 0; k < value.size(); ++k) both.push_back({value[k], {change[k]}});
    return both;
  };
  const std::vector<Varied> accelerations = varied(a, da);
  if (excitation_.at.body != ground) {
    Vector force = part_of(excitation_.force, phase), couple = part_of(excitation_.couple, phase);
    const double turning = norm(motion_.turning);
    if (turning > 0) {
      const Matrix3<double> turned = rotation_about<double>(motion_.turning / turning, turning * delay);
      force = turned * force;
      couple = turned * couple;
    }
    auto& forces = machine_.mechanism.forces;
    const auto small = [by](const Vector& change) {
      return Vector3<Varied>{Varied(by * change.x, {change.x}), Varied(by * change.y, {change.y}),
                             Varied(by * change.z, {change.z})};
    };
    forces[forces.size() - 2].vector = small(force);
    forces.back().vector = small(couple);
  }
  state_->set_positions(varied(q, rate));
  solve::update_contacts(machine_.mechanism, *state_);
  state_->set_velocities(varied(v, dv));
  state_->set_accelerations(std::vector<Varied>(a.size(), Varied(0)));
  const solve::ForceUnknowns order = solve::force_unknowns(machine_.mechanism);
  std::vector<solve::ConditionOf<Varied>> conditions;
  for (std::size_t k = 0; k < a.size(); ++k) {
    solve::ConditionOf<Varied> condition;
    condition.words = "acceleration " + std::to_string(k);
    condition.coefficients.assign(order.size(), Varied(0));
    condition.coefficients[k] = Varied(1);
    condition.value = accelerations[k];
    condition.scale = (solve::coordinate_turns(tree, static_cast<int>(k)) ? 1 : base_.scales_.length) /
                      (base_.scales_.time * base_.scales_.time);
    conditions.push_back(std::move(condition));
  }
  equations_ = solve::motion_equations(*state_, base_.scales_, conditions);
  const solve::LinearFactors factors(equations_);
  unknowns_ = varied(factors.solution().value, factors.derivative(equations_).value);
  open_ = factors.solution().open;
  state_->set_accelerations(accelerations);
}

// What Newton's and Euler's equations leave of the change, as a part of their terms.
ShakenInstant::Misfit ShakenInstant::balance_misfit() const {
  const std::vector<std::vector<Varied>> rows = equations_.coefficients();
  const std::vector<Varied> right = equations_.right_sides();
  const double length = base_.scales_.length;
  double misfit = 0, size = 0;
  std::size_t place = 0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (equations_.source(i).kind != solve::EquationKind::balance) continue;
    const double unit = place++ % 6 < 3 ? 1 : length;
    double left = -right[i].partial[0], terms = std::abs(right[i].partial[0]);
    for (std::size_t k = 0; k < rows[i].size(); ++k) {
      const Varied term = rows[i][k] * unknowns_[k];
      left += term.partial[0];
      terms +=
          std::abs(rows[i][k].value * unknowns_[k].partial[0]) + std::abs(rows[i][k].partial[0] * unknowns_[k].value);
    }
    misfit = std::max(misfit, std::abs(left) / unit);
    size = std::max(size, terms / unit);
  }
  // Known forces stand in the right sides as their sum, which is rounding of each where a slow swing is held by
  // springs.
  for (std::size_t i = 0; i < machine_.mechanism.actions.size(); ++i) {
    const SpatialForce<Varied> wrench = solve::action_wrench(*state_, unknowns_, i);
    size = std::max({size, norm(change_of(wrench.force)), norm(change_of(wrench.moment)) / length});
  }
  return {misfit, size};
}

// How far what acts on each body is from what the second road says that its motion takes.
ShakenInstant::Misfit ShakenInstant::need_misfit(const solve::ResponseCheck& check, bool imaginary) const {
  const Workspace<Varied>& workspace = state_->workspace();
  const Model<Varied>& tree = machine_.mechanism.tree;
  const double length = base_.scales_.length;
  double misfit = 0, size = 0;
  for (const solve::ResponseCheck::Need& need : check.needs) {
    SpatialForce<Varied> total = SpatialForce<Varied>::zero();
    for (std::size_t i = 0; i < machine_.mechanism.actions.size(); ++i) {
      const Action& action = machine_.mechanism.actions[i];
      if (action.on != need.body && action.from != need.body) continue;
      const SpatialForce<Varied> wrench = solve::action_wrench(*state_, unknowns_, i);
      total += Varied(action.on == need.body ? 1 : -1) * wrench;
      size = std::max({size, norm(change_of(wrench.force)), norm(change_of(wrench.moment)) / length});
    }
    const bool heavy = tree.body(need.body).inertia.mass.value > 0;
    const Vector3<Varied> c = heavy ? body_mass_center(tree, workspace, need.body)
                                    : workspace.motion[static_cast<std::size_t>(need.body + 1)].p;
    const Vector force = change_of(total.force), couple = change_of(total.moment - cross(c, total.force));
    const auto part = [&](const solve::ComplexVector3& v) { return part_of(v, imaginary ? quarter_back : 0); };
    misfit = std::max({misfit, norm(force - part(need.force)), norm(couple - part(need.couple)) / length});
    size = std::max({size, norm(part(need.force)), norm(part(need.couple)) / length});
  }
  return {misfit, size};
}

void ShakenInstant::find_response() {
  const solve::Linearisation& near = base_.linearisation(mark_);
  try {
    response_ = solve::response(motion_, excitation_);
  } catch (const std::runtime_error& error) {
    throw UnansweredError(base_.situation_.file, mark_, error.what(), "say what holds or drives every freedom");
  }
  // A free swing of this frequency, as far as its rate is known. A response to a shaking a billionth beside it would be
  // a billion times the deflection at rest.
  constexpr double meets = 1e-9;  // of the pace
  const bool free_swing = std::ranges::any_of(near.modes, [&](const solve::Mode& mode) {
    const double apart = std::hypot(mode.growth_rate, mode.frequency - excitation_.frequency);
    return apart <= std::max(mode.doubt, meets * std::max(near.pace, excitation_.frequency)) &&
           mode.frequency > mode.doubt;
  });
  if (free_swing)
    refuse("there is no bounded response: a free swing near this motion has the frequency of '" + stated_.name +
               "' and does not die out",
           "state what damps it, or shake at another frequency");
  if (response_.fault == solve::Response::Fault::undetermined)
    refuse(excitation_.frequency == 0
               ? "there is no deflection at rest: nothing holds what '" + stated_.name + "' moves"
               : "the equations near this motion do not determine its response",
           "say what holds or drives every freedom");
  if (response_.fault == solve::Response::Fault::contradicts)
    refuse("'" + stated_.coordinate + "' cannot swing alone: what is joined to it does not let it",
           "leave a freedom to what it moves");
  // What is driven swings as it is stated.
  if (excitation_.coordinate >= 0) {
    const bool turns = solve::coordinate_turns(base_.machine_.mechanism.tree, excitation_.coordinate);
    const double by = base_.data_->number(*stated_.by, turns ? dimensions::angle : dimensions::length);
    const std::complex<double> swings = response_.motion.q[static_cast<std::size_t>(excitation_.coordinate)];
    if (!(std::abs(swings - by) <= holds_closely * std::abs(by)))
      refuse("'" + stated_.coordinate + "' does not swing in it as it is stated");
  }
  build();
  shown_ = response_.motion;
  const std::optional<solve::ResponseCheck> check = solve::check_response(motion_, excitation_, response_, near.pace);
  if (!check)
    refuse("no second road leads to the response here, and it is not told without one",
           "responses are told where dampers act on bodies that do not spin, and joints are no screws");
  Misfit balances, needs;
  const auto look = [&](double delay, double phase) {
    put(delay, phase);
    balances.take(balance_misfit());
  };
  for (const double phase : {0.0, quarter_back}) {
    look(0, phase);
    needs.take(need_misfit(*check, phase != 0));
    for (std::size_t i = 0; i < machine_.mechanism.actions.size(); ++i)
      largest_force_ = std::max(largest_force_, norm(change_of(solve::action_wrench(*state_, unknowns_, i).force)));
  }
  const double balance = balances.part();
  if (balance > holds_closely)
    refuse("the equations of its bodies are not fulfilled by the response (off by " + with_digits(balance, 2) + ")");
  misfit_ = std::max(check->misfit, needs.part() * check->apart);
  if (misfit_ > solve::spectrum_tolerance)
    refuse("the motion of its bodies, each by itself, does not confirm the response (off by " +
           with_digits(misfit_, 2) + ")");
}

Value<Varied> ShakenInstant::value(const Expression& quantity, const std::optional<Expression>& axes,
                                   const std::vector<Varied>& unknowns) {
  QuantityScope<Varied> scope(machine_, machine_.mechanism.tree, data_, state_->state());
  scope.set_accelerations(state_->accelerations());
  scope.set_forces(&*state_, &unknowns);
  if (axes) scope.set_axes(*axes);
  Value<Varied> found = scope.value(quantity);
  if (found.is_vector()) found.vector = transpose_times(scope.axes(), found.vector);
  return found;
}

// The size of a response of this dimension that belongs to the largest displacement and force; zero if none does.
double ShakenInstant::natural_size(const Dimension& dimension) const {
  const double length = base_.scales_.length, w = std::max(excitation_.frequency, base_.pace());
  double moved = 0;
  for (std::size_t k = 0; k < response_.motion.q.size(); ++k)
    moved =
        std::max(moved, std::abs(response_.motion.q[k]) /
                            (solve::coordinate_turns(base_.machine_.mechanism.tree, static_cast<int>(k)) ? 1 : length));
  double rates = 1;
  for (int order = 0; order <= 2; ++order, rates *= w) {
    Dimension per = dimensions::none;
    for (int k = 0; k < order; ++k) per = per / dimensions::time;
    if (same_kind(dimension, dimensions::length * per)) return moved * length * rates;
    if (same_kind(dimension, per)) return moved * rates;
  }
  if (same_kind(dimension, dimensions::force)) return largest_force_;
  if (same_kind(dimension, dimensions::moment)) return largest_force_ * length;
  return 0;
}

// A quantity with a corner here, as |s| at s = 0, or one that changes with the square of what swings and by nothing
// else, as an energy at rest, has no response of this frequency: it is looked at where it is displaced a little either
// way.
void ShakenInstant::refuse_corners(const Expression& quantity, const std::optional<Expression>& axes, double size) {
  double moved = 0;
  for (std::size_t k = 0; k < response_.motion.q.size(); ++k) {
    const bool turns = solve::coordinate_turns(base_.machine_.mechanism.tree, static_cast<int>(k));
    moved = std::max(moved, std::abs(response_.motion.q[k]) / (turns ? 1 : base_.scales_.length));
  }
  if (!(moved > 0)) return;
  // Of a radian or the length of the machine: what is smooth bends by about as little, and rounding is far less.
  constexpr double small_part = 1e-4, bends = 0.05, rounding = 1e-9;
  const double by = small_part / moved;
  for (const double phase : {0.0, quarter_back}) {
    std::array<Vector, 3> at;
    for (std::size_t side = 0; side < 3; ++side) {
      put(0, phase, (static_cast<double>(side) - 1) * by);
      const Value<Varied> found = value(quantity, axes, unknowns_);
      at[side] = found.is_vector() ? plain(found.vector) : Vector{found.number.value, 0, 0};
    }
    const double bend = norm(at[2] + at[0] - 2.0 * at[1]) / by;
    if (!(bend <= bends * size + rounding * norm(at[1]) / by))
      refuse("'" + to_string(quantity) + "' does not swing at the frequency of '" + stated_.name +
                 "': it has a corner in this motion, or changes with the square of what swings",
             "ask for a coordinate, a velocity, a force, or a component of one");
  }
}

// What nothing holds may lie anywhere at rest: only what does not depend on it has a deflection.
void ShakenInstant::refuse_loose(const Expression& quantity, const std::optional<Expression>& axes) {
  if (response_.loose.empty()) return;
  const solve::ComplexVector3 force = std::exchange(excitation_.force, {}),
                              couple = std::exchange(excitation_.couple, {});
  constexpr double nothing = 1e-9;  // of a natural unit, for a displacement of one
  bool depends = false;
  for (const solve::Response::Motion& one : response_.loose) {
    shown_ = one;
    put(0, 0);
    const Value<Varied> found = value(quantity, axes, unknowns_);
    const double change = found.is_vector() ? norm(change_of(found.vector)) : std::abs(found.number.partial[0]);
    depends = depends || !(change <= nothing * base_.natural_unit(found.dimension));
  }
  shown_ = response_.motion;
  excitation_.force = force;
  excitation_.couple = couple;
  if (depends)
    refuse("there is no deflection at rest of '" + to_string(quantity) + "': it depends on what nothing holds",
           "state what holds it, or ask for what does not depend on it");
}

ShakenInstant::Swing ShakenInstant::swing(const Expression& quantity, const std::optional<Expression>& axes) {
  const auto parts_of = [&](const Value<Varied>& found) -> std::array<double, 3> {
    if (found.is_number()) return {found.number.partial[0], 0, 0};
    if (!found.is_vector())
      fail(base_.situation_.file, quantity.mark(), "a response is that of a number or a vector",
           "ask for a coordinate, a velocity, a force, ...");
    const Vector change = change_of(found.vector);
    return {change.x, change.y, change.z};
  };
  Swing swing;
  std::array<double, 3> real{}, imaginary{};
  for (const bool quarter : {false, true}) {
    put(0, quarter ? quarter_back : 0);
    const Value<Varied> found = value(quantity, axes, unknowns_);
    swing.vector = found.is_vector();
    swing.dimension = found.dimension;
    (quarter ? imaginary : real) = parts_of(found);
  }
  // Energies have the dimension of couples, but no size of first order.
  double size = asks_energy(quantity) ? 0 : natural_size(swing.dimension);
  for (std::size_t k = 0; k < 3; ++k) size = std::max({size, std::abs(real[k]), std::abs(imaginary[k])});
  // What contacts and supports share in an open way must not matter.
  for (const std::vector<double>& way : open_) {
    std::vector<Varied> unknowns;
    double largest = 0;
    for (const double part : way) largest = std::max(largest, std::abs(part));
    for (std::size_t k = 0; k < way.size(); ++k) unknowns.push_back({unknowns_[k].value, {way[k]}});
    std::vector<Varied> still = unknowns;
    for (Varied& one : still) one.partial[0] = 0;
    const std::array<double, 3> with = parts_of(value(quantity, axes, unknowns)),
                                without = parts_of(value(quantity, axes, still));
    for (std::size_t k = 0; k < 3; ++k)
      if (std::abs(with[k] - without[k]) > holds_closely * largest)
        refuse("how the supports share what swings is not determined", "state which components each support carries");
  }
  double pace = norm(motion_.turning);
  for (const double rate : motion_.v) pace = std::max(pace, std::abs(rate));
  // Parts of a turn that no symmetry has.
  for (const double turned : {1.2345, 2.9173}) {
    const double phase = 0.7 * turned;
    put(turns() ? turned / pace : 0, phase);
    const std::array<double, 3> now = parts_of(value(quantity, axes, unknowns_));
    if (balance_misfit().part() > 1e3 * holds_closely)
      refuse(
          "near this motion the equations have coefficients that change with time: something on a body that spins is "
          "not alike all round",
          "responses are told where all that spins are bodies of revolution, shaken and held on their axes");
    for (std::size_t k = 0; k < 3; ++k) {
      const double expected = (std::complex<double>(real[k], imaginary[k]) * std::polar(1.0, phase)).real();
      if (!(std::abs(now[k] - expected) <= 1e3 * holds_closely * size))
        refuse("'" + to_string(quantity) + "' does not swing at the frequency of '" + stated_.name + "' alone" +
                   (turns() ? ": it follows the turning as well" : ""),
               "ask for what rests in the frame of the steady motion: a coordinate, or components with axes: of that "
               "frame");
    }
  }
  refuse_corners(quantity, axes, size);
  refuse_loose(quantity, axes);
  for (std::size_t k = 0; k < 3; ++k) {
    const auto clean = [&](double part) { return std::abs(part) <= no_swing * size ? 0 : part; };
    swing.parts[k] = {clean(real[k]), clean(imaginary[k])};
  }
  return swing;
}

}  // namespace poinsot::problem
