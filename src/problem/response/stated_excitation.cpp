// What shakes a steady motion, as it is stated, and the answers response(X to F).
#include <algorithm>
#include <cmath>
#include <numbers>

#include "poinsot/engine/dynamics/momentum.h"
#include "poinsot/engine/math/algebra/rotation.h"
#include "problem/instant/accelerated_frame.h"
#include "problem/language/diagnostic.h"
#include "problem/language/words.h"
#include "problem/quantities/quantity_values.h"
#include "problem/response/shaken_instant.h"
#include "problem/witness/stated_forces.h"
#include "problem/witness/stated_springs.h"

namespace poinsot::problem {
namespace {

// Of sines, lengths and moments: what is nothing but for data that are stated to nine digits.
constexpr double as_stated = 1e-9;

// The real part of v exp(i w t) goes round about n, from u.
solve::ComplexVector3 going_round(const Vector3<double>& u, const Vector3<double>& n) {
  const Vector3<double> ahead = cross(n, u);
  return {std::complex<double>(u.x, -ahead.x), {u.y, -ahead.y}, {u.z, -ahead.z}};
}
// What a particle of one kilogram takes that goes round with the spin s in a frame that turns at W, at u from the axis
// at the time zero: minus the second difference of its place, on the axes of the frame.
Vector3<double> force_of_going_round(const Vector3<double>& u, const Vector3<double>& s, const Vector3<double>& W,
                                     double time) {
  const auto turned = [](const Vector3<double>& about, double t, const Vector3<double>& v) {
    const double rate = norm(about);
    return rate > 0 ? rotation_about<double>(about / rate, rate * t) * v : v;
  };
  // Of a radian: differences of the fourth order are good to about 1e-9 with it.
  const double h = 1e-2 / (norm(s) + norm(W));
  const auto at = [&](int step) { return turned(W, time + step * h, turned(s, time + step * h, u)); };
  const Vector3<double> twice = (16.0 * (at(1) + at(-1)) - (at(2) + at(-2)) - 30.0 * at(0)) / (12 * h * h);
  return turned(W, -time, -twice);
}
solve::ComplexVector3 swinging(const Vector3<double>& u) { return {u.x, u.y, u.z}; }

}  // namespace

ShakenInstant::ShakenInstant(SolvedInstant& base, const Excitation& stated, std::optional<double> frequency,
                             const Mark& mark)
    : base_(base),
      stated_(stated),
      asked_(frequency),
      mark_(mark),
      data_(base.situation_, base.settings_, Varied(base.time_)) {
  refuse_motion();
  motion_ = base_.steady_motion(mark, near_);
  base_.solve_forces();
  read(frequency);
  find_response();
}

void ShakenInstant::refuse(const std::string& what, const std::string& hint) const {
  throw UnansweredError(base_.situation_.file, mark_, what, hint);
}

void ShakenInstant::refuse_motion() const {
  const Situation& situation = base_.situation_;
  if (base_.before_)
    refuse("just after a blow there is no steady motion", "ask for the response of a situation without it");
  if (!base_.machine_.rough_contacts.empty())
    refuse("the response is not told where contacts or joints have dry friction: it follows from no linear equations",
           "state a damping in its place");
  for (const Frame& frame : situation.frames)
    if (situation.steady && frame.name == situation.steady->frame && !frame.rides_on.empty())
      refuse("the frame of the steady motion rides on a mass center, whose motion is not told",
             "state the steady motion in a frame that turns about an axis of the ground");
  if (const AcceleratedFrame rides = accelerated_frame(base_.view(), mark_, base_.pace());
      !rides.coordinates.empty() || norm(rides.acceleration) > 0)
    refuse("the response in a frame that accelerates is not told",
           "state the problem in a frame at rest, with the "
           "gravity that is felt there");
  const solve::Linearisation& near = base_.linearisation(mark_);
  const solve::Stability stability = solve::stability(near);
  if (stability == solve::Stability::unstable)
    refuse("the steady motion is unstable: a disturbance grows as exp(" + with_digits(solve::growth_rate(near), 4) +
               " t/s), and no response to what shakes it is ever reached",
           "ask where it is stable");
  if (stability == solve::Stability::undecided)
    refuse(
        "the linearised equations do not decide whether the motion stays near the steady one, where its response would "
        "be",
        "say what holds it");
}

Vector3<double> ShakenInstant::spin_of(int body) const {
  return angular_velocity(base_.mechanism_state_->workspace(), body) - motion_.turning;
}
// Its mass center, or the origin of a body without mass, on ground axes.
Vector3<double> ShakenInstant::center_of(int body) const {
  const Model<double>& tree = base_.machine_.mechanism.tree;
  const Workspace<double>& w = base_.mechanism_state_->workspace();
  return tree.body(body).inertia.mass > 0 ? body_mass_center(tree, w, body)
                                          : w.motion[static_cast<std::size_t>(body + 1)].p;
}

// The place at which it acts: on a body that spins it must lie on the axis.
Place<double> ShakenInstant::place_of(int body) const {
  const Situation& situation = base_.situation_;
  const auto stated = std::ranges::find(situation.bodies, stated_.body, &Body::name);
  if (!stated_.at && stated->massless)
    fail(situation.file, stated_.mark,
         "excitation '" + stated_.name + "' needs the point at which it acts: the body is massless", "write at: P");
  const Model<double>& tree = base_.machine_.mechanism.tree;
  const Workspace<double>& w = base_.mechanism_state_->workspace();
  const Vector center = center_of(body), origin = w.motion[static_cast<std::size_t>(body + 1)].p;
  Place<double> place{body, direction_on_body(tree, w, body, center - origin)};
  if (stated_.at) place = base_.machine_.place(body, base_.data_->place(*stated_.at));
  const Vector s = spin_of(body);
  const Vector arm = point_position(tree, w, body, place.point) - center;
  if (norm(s) > as_stated * base_.pace() && norm(cross(arm, s)) > as_stated * base_.scales_.length * norm(s))
    fail(situation.file, stated_.mark,
         "'" + stated_.name + "' acts beside the axis about which '" + stated_.body +
             "' spins, at a point that goes round: near this motion the equations change with time",
         "let it act on the axis, or on a body that does not spin");
  return place;
}

void ShakenInstant::read(std::optional<double> frequency) {
  const Situation& situation = base_.situation_;
  // What spins must be alike all round its axis, or the equations change with time.
  const Model<double>& tree = base_.machine_.mechanism.tree;
  const Workspace<double>& w = base_.mechanism_state_->workspace();
  for (const auto& [body, mass] : base_.machine_.masses) {
    const SpatialInertia<double>& I = tree.body(body).inertia;
    if (!(I.mass > 0)) continue;
    // The inertia is on the axes of the joint.
    const Vector s = transpose_times(w.motion[static_cast<std::size_t>(body + 1)].R, spin_of(body)),
                 c = I.first_moment / I.mass;
    if (!(norm(s) > as_stated * base_.pace())) continue;
    const SymmetricMatrix3<double> own = I.inertia - I.mass * unit_mass_inertia(c);
    double change = 0, size = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vector e = Vector::unit(k);
      change = std::max(change, norm(cross(s, own * e) - own * cross(s, e)));
      size = std::max(size, norm(own * e) * norm(s));
    }
    if (change > as_stated * size)
      refuse(
          "a body that spins is no body of revolution about its axis: near this motion the equations have "
          "coefficients that change with time, and one frequency of shaking brings forth many",
          "responses are told where all that spins are bodies of revolution");
  }
  if (stated_.unbalance && frequency)
    fail(situation.file, mark_, "'" + stated_.name + "' is an unbalance, which goes round as its body spins",
         "leave out the frequency, and vary the spin");
  if (!stated_.unbalance) {
    if (!frequency && !stated_.frequency)
      fail(situation.file, mark_, "the frequency of '" + stated_.name + "' is not stated",
           "write response(X to " + stated_.name + " at 30 rad/s), or frequency: below it");
    excitation_.frequency =
        frequency ? *frequency : base_.data_->number(*stated_.frequency, dimensions::angular_velocity);
    if (!(excitation_.frequency >= 0) || !std::isfinite(excitation_.frequency))
      fail(situation.file, stated_.frequency ? stated_.frequency->mark() : mark_, "a frequency is not negative",
           "the sense of what goes round is that of its axis, turns: -z");
  }
  if (!stated_.coordinate.empty()) return read_coordinate();
  if (stated_.unbalance) return read_unbalance();
  read_force();
}

void ShakenInstant::read_force() {
  const Situation& situation = base_.situation_;
  const int body = base_.machine_.index.at(stated_.body);
  const Expression& size = stated_.couple ? *stated_.couple : *stated_.force;
  const Dimension dimension = stated_.couple ? dimensions::moment : dimensions::force;
  const int axes = base_.machine_.index.at(stated_.axes);
  const Model<double>& tree = base_.machine_.mechanism.tree;
  const Workspace<double>& w = base_.mechanism_state_->workspace();
  const auto on_ground = [&](const Vector& v) { return direction_on_ground(tree, w, axes, v); };
  Vector u = stated_.direction ? base_.data_->number(size, dimension) * base_.data_->direction(*stated_.direction)
                               : base_.data_->vector(size, dimension);
  if (situation.plane) {
    Vector off = Vector::zero();
    for (std::size_t k = 0; k < 3; ++k)
      if ((k == situation.plane->normal()) != stated_.couple.has_value()) off[k] = u[k];
    if (norm(off) > as_stated * norm(u))
      fail(situation.file, stated_.mark, "'" + stated_.name + "' points out of the plane of the problem",
           stated_.couple ? "a couple is about the normal" : "a force lies in the plane");
  }
  const Vector drawn = u;
  u = on_ground(u);
  const double turning = norm(motion_.turning);
  const Vector rides = axes == ground ? Vector::zero() : angular_velocity(w, axes);
  const bool with_frame = norm(rides - motion_.turning) <= as_stated * base_.pace();
  const auto along_axis = [&](const Vector& v) {
    return norm(cross(v, motion_.turning)) <= as_stated * norm(v) * turning;
  };
  if (!with_frame && !(axes == ground && along_axis(u) && !stated_.turns))
    fail(situation.file, stated_.mark,
         "the direction of '" + stated_.name +
             "' does not rest in the frame of the steady motion, in which it would "
             "swing at other frequencies",
         "state axes: of a body that rests in the frame, or a direction along its axis");
  solve::ComplexVector3 amplitude = swinging(u);
  if (stated_.turns) {
    const Vector n = on_ground(base_.data_->direction(*stated_.turns));
    if (std::abs(dot(u, n)) > as_stated * norm(u))
      fail(situation.file, stated_.turns->mark(),
           "'" + stated_.name + "' does not point across the axis about which it turns",
           "state a direction across the axis");
    amplitude = going_round(u, n);
    // A quarter of a turn later it points where the axis turns it to.
    const Vector later{-amplitude[0].imag(), -amplitude[1].imag(), -amplitude[2].imag()};
    if (norm(later - rotation_about<double>(n, std::numbers::pi / 2) * u) > 1e-9 * norm(u))
      refuse("'" + stated_.name + "' does not turn in it as it is stated");
  }
  if (stated_.couple) {
    excitation_.at = {body, Vector::zero()};
    excitation_.couple = amplitude;
  } else {
    excitation_.at = place_of(body);
    excitation_.force = amplitude;
  }
  confirm_as_drawn(body, axes, drawn, u);
}

// A second road to where it acts and along what: the way of the body from the figure.
void ShakenInstant::confirm_as_drawn(int body, int axes, const Vector& drawn, const Vector& now) const {
  const Model<double>& tree = base_.machine_.mechanism.tree;
  const StatedForce stated =
      drawn_force(*base_.mechanism_state_, base_.machine_, *base_.data_, body, stated_.at, axes, drawn);
  const Vector at = point_position(tree, base_.mechanism_state_->workspace(), body, excitation_.at.point);
  if (norm(widened(now) - stated.force) > as_stated * norm(now) ||
      (!stated_.couple && norm(widened(at) - stated.at) > as_stated * (base_.scales_.length + norm(at))))
    refuse("the way of the bodies from the figure does not confirm where '" + stated_.name + "' acts and along what");
}

// An unbalance U = m e is a particle m at e from a place P on the axis, less one at P, as m vanishes: with u the
// direction of e, w the angular velocity of the body and W that of the frame it takes the force U (w' x u + w x (w x
// u)), w' = W x w, and about P the moment U u x (a_P - g).
void ShakenInstant::read_unbalance() {
  const Situation& situation = base_.situation_;
  const int body = base_.machine_.index.at(stated_.body);
  const Model<double>& tree = base_.machine_.mechanism.tree;
  const Workspace<double>& w = base_.mechanism_state_->workspace();
  const Vector s = spin_of(body);
  if (!(norm(s) > as_stated * base_.pace()))
    fail(situation.file, stated_.mark, "'" + stated_.body + "' does not spin, so that its unbalance does not go round",
         "state its spin: rate: at its joint, or under spins:");
  const Vector n = s / norm(s);
  const Vector u = direction_on_ground(tree, w, body, base_.data_->direction(*stated_.direction));
  if (std::abs(dot(u, n)) > as_stated)
    fail(situation.file, stated_.direction->mark(), "an unbalance lies to the side of the axis of the spin",
         "state a direction across the axis");
  excitation_.frequency = norm(s);
  excitation_.at = place_of(body);
  confirm_as_drawn(body, body, base_.data_->direction(*stated_.direction), u);
  const double U = base_.data_->number(*stated_.unbalance, dimensions::mass * dimensions::length);
  const Vector total = angular_velocity(w, body), change = cross(motion_.turning, total);
  // The acceleration of P: that of the frame's turning, since P rests in the frame.
  const Vector v = point_velocity(tree, w, body, excitation_.at.point),
               felt = tree.gravity() - cross(motion_.turning, v);
  const solve::ComplexVector3 round = going_round(u, n);
  const Vector real{round[0].real(), round[1].real(), round[2].real()},
      imaginary{round[0].imag(), round[1].imag(), round[2].imag()};
  const auto force = [&](const Vector& r) { return -U * (cross(change, r) + cross(total, cross(total, r))); };
  const auto couple = [&](const Vector& r) { return U * cross(r, felt); };
  const Vector fr = force(real), fi = force(imaginary), cr = couple(real), ci = couple(imaginary);
  // A second road: differences of where the particle is.
  const double quarter = std::numbers::pi / (2 * excitation_.frequency);
  const Vector now = force_of_going_round(u, s, motion_.turning, 0),
               before = force_of_going_round(u, s, motion_.turning, -quarter);
  // Its moment about P is that of its weight less what its acceleration takes, for a short arm that of P.
  const double W = norm(motion_.turning), short_time = 1e-3;
  const auto turned_by = [&](double angle) {
    return W > 0 ? rotation_about<double>(motion_.turning / W, angle) * v : v;
  };
  const Vector falls = tree.gravity() - (W / (2 * short_time)) * (turned_by(short_time) - turned_by(-short_time));
  const double couple_size = U * norm(falls) + norm(cr) + norm(ci);
  if (norm(fr - U * now) + norm(fi - U * before) > 1e-6 * (norm(fr) + norm(fi)) ||
      norm(cr - U * cross(real, falls)) + norm(ci - U * cross(imaginary, falls)) > 1e-5 * couple_size)
    refuse("the path of a particle does not confirm the force of the unbalance");
  for (std::size_t k = 0; k < 3; ++k) {
    excitation_.force[k] = {fr[k], fi[k]};
    excitation_.couple[k] = {cr[k], ci[k]};
  }
}

void ShakenInstant::read_coordinate() {
  const Situation& situation = base_.situation_;
  const NamedCoordinate* coordinate = base_.machine_.coordinate(stated_.coordinate);
  if (!coordinate) {
    std::vector<std::string> names;
    for (const NamedCoordinate& one : base_.machine_.coordinates)
      if (!one.name.empty()) names.push_back(one.name);
    fail(situation.file, stated_.coordinate_mark, "there is no coordinate '" + stated_.coordinate + "'",
         did_you_mean(stated_.coordinate, names));
  }
  if (!motion_.held[static_cast<std::size_t>(coordinate->velocity)])
    fail(situation.file, stated_.coordinate_mark,
         "'" + stated_.coordinate + "' moves as forces let it: only what is driven can be said to swing",
         "state rate: 0 and accel: 0 at its joint, or shake it by a force");
  excitation_.coordinate = coordinate->velocity;
  excitation_.amplitude =
      base_.data_->number(*stated_.by, coordinate->turning ? dimensions::angle : dimensions::length);
}

Value<double> SolvedInstant::response(const Call& call, const Mark& mark, const std::optional<Expression>& axes) {
  const Expression& named = *call.argument("to");
  const Name* name = plain_name(named);
  const auto stated =
      name ? std::ranges::find(situation_.excitations, name->name, &Excitation::name) : situation_.excitations.end();
  if (stated == situation_.excitations.end()) {
    std::vector<std::string> known;
    for (const Excitation& one : situation_.excitations) known.push_back(one.name);
    const bool is_load = name && std::ranges::find(situation_.loads, name->name, &Load::name) != situation_.loads.end();
    const std::string near = did_you_mean(to_string(named), known);
    fail(situation_.file, named.mark(),
         is_load ? "'" + name->name + "' is a load, which acts in the steady motion itself"
                 : "there is no excitation '" + to_string(named) + "'",
         is_load         ? "state what swings under excitations: {" + name->name + ": {force: ..., frequency: ...}}"
         : !near.empty() ? near
         : known.empty() ? "state it: excitations: {push: {force: 5 N, along: x, body: cart, frequency: 30 rad/s}}"
                         : "known: " + joined(known));
  }
  std::optional<double> frequency;
  if (const Expression* at = call.argument("at")) {
    frequency = data_->number(*at, dimensions::angular_velocity);
    if (!(*frequency >= 0)) fail(situation_.file, at->mark(), "a frequency is not negative");
  }
  std::shared_ptr<ShakenInstant> shaken;
  for (const std::shared_ptr<ShakenInstant>& one : shaken_)
    if (&one->stated() == &*stated && one->asked_frequency() == frequency) shaken = one;
  if (!shaken) {
    shaken = shaken_.emplace_back(std::make_shared<ShakenInstant>(*this, *stated, frequency, mark));
    response_misfit_ = std::max(response_misfit_.value_or(0), shaken->misfit());
  }
  const ShakenInstant::Swing swing = shaken->swing(call.arguments[0].value, axes);
  const auto record = [&](const std::complex<double>& part) {
    // From -180 deg, as what lags is told, up to 180 deg.
    double phase = part == 0.0 ? 0 : std::arg(part);
    if (phase >= std::numbers::pi) phase = -std::numbers::pi;
    std::vector<Value<double>> both{number_value(std::abs(part), swing.dimension),
                                    number_value(phase, dimensions::angle)};
    both[0].text = "amplitude";
    both[1].text = "phase";
    // As it is read: the swing A cos(w t + phase) at the phases 0 and 90 deg.
    const double A = both[0].number, c = std::cos(both[1].number), s = std::sin(both[1].number);
    constexpr double rounding = 1e-12;
    if (!(std::hypot(A * c - part.real(), A * s - part.imag()) <= rounding * std::hypot(part.real(), part.imag())))
      throw UnansweredError(situation_.file, mark, "amplitude and phase do not tell the swing that was found");
    return Value<double>::of_list(std::move(both));
  };
  if (!swing.vector) return record(swing.parts[0]);
  std::vector<Value<double>> rows;
  for (std::size_t k = 0; k < swing.parts.size(); ++k)
    if (!situation_.plane || k != situation_.plane->normal()) rows.push_back(record(swing.parts[k]));
  return Value<double>::of_list(std::move(rows));
}

}  // namespace poinsot::problem
