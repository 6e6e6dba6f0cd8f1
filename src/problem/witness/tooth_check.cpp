// The forces of slanted teeth by the geometry of teeth, from the statement and the bodies on their way from the figure.
//
// The thread of a gear is drawn: from the pitch point along the line in which the pitch surfaces touch, turned about
// the axis as its helix has it. What touches without friction exerts no force along it, with friction mu times the rest
// of it, against the slip. And whatever the flanks, a force on a tooth has about the axis the arm of the base circle, R
// cos(phi): with F the force, or its part across the line where the pressure angle is that across the line,
//
//   |M| = R cos(phi) |F|   or   |M| = R cos(psi) cos(phi_n) |F|,
//
// and it pushes the wheel off the other (Norton, Design of Machinery, 9.2).
#include <algorithm>
#include <cmath>

#include "problem/instant/instant.h"
#include "problem/keys/joint_kinds.h"
#include "problem/quantities/rough_contact.h"
#include "problem/witness/stated_springs.h"

namespace poinsot::problem {
namespace {

using solve::ParticlePaths;
using Real = ParticlePaths::Real;
using Vector = ParticlePaths::Vector;

// The axis of a gear as it stands now, with the arm from it to the pitch point.
struct WheelAxis {
  Vector at, along, arm;
};

class DrawnTeeth {
 public:
  DrawnTeeth(const ParticlePaths& paths, const Machine& machine, DataScope<double>& data, const Gear& gear, int carrier)
      : paths_(paths), machine_(machine), data_(data), gear_(gear), carrier_(carrier) {
    P_ = paths.place(carrier, widened(data.place(gear.at)));
    of_ = axis_of(machine.index.at(gear.of));
    against_ = axis_of(machine.index.at(gear.against));
  }

  // By how much a force on `of` is not one that teeth can exert, as a part of its size. slip: the velocity of `of` over
  // `against` where they touch.
  Real misfit(const Vector& exerted, const Vector& slip, bool with_parting) const {
    const Vector thread_now = gear_.hand == Hand::both ? line_of_contact() : thread(line_of_contact(), helix_angle());
    // Without what rubs along the thread.
    const Vector force = gear_.friction ? exerted - dot(exerted, thread_now) * thread_now : exerted;
    const WheelAxis& wheel = of_ ? *of_ : *against_;
    const Vector g = line_of_contact(), radial = normalized(wheel.arm), round = cross(wheel.along, radial);
    const Real psi = helix_angle(), size = norm(exerted);
    Real worst = 0;
    const auto none = [&](Real off) { worst = std::max(worst, std::abs(off) / size); };
    const Real rubs = !gear_.friction || !with_parting
                          ? 0
                          : -std::copysign(Real(data_.number(*gear_.friction, dimensions::none)) * norm(force),
                                           dot(slip, thread_now));
    if (!gear_.friction || with_parting) none(dot(exerted, thread_now) - rubs);
    if (!with_parting) return worst;
    const Real R = norm(wheel.arm), moment = std::abs(dot(wheel.along, cross(wheel.arm, force)));
    const Vector across = force - dot(force, g) * g;
    if (gear_.normal_pressure_angle)
      none(moment / R - std::cos(psi) * std::cos(number(*gear_.normal_pressure_angle)) *
                            (gear_.hand == Hand::both ? norm_of_rows(force, g, round, psi) : norm(force)));
    else
      none(moment / R - (gear_.pressure_angle ? std::cos(number(*gear_.pressure_angle)) : 1) * norm(across));
    // Off the other wheel: towards the axis of the one that lies about its own.
    const Vector parting = across - dot(across, round) * round;
    const Real push = of_ ? dot(parting, inward(*of_)) : -dot(parting, inward(*against_));
    const bool ring =
        of_ && against_ && dot(inward(*of_), inward(*against_)) > 0 && norm(of_->arm) > norm(against_->arm);
    if (const Real apart = ring ? -push : push; apart < 0) none(apart);
    return worst;
  }

 private:
  Real number(const Expression& expression) const { return data_.number(expression, dimensions::angle); }

  Vector inward(const WheelAxis& wheel) const { return -normalized(wheel.arm); }

  // The force in one of two rows of teeth, of which each exerts half and the thrusts cancel: what is across the line,
  // with the thrust of a row beside it.
  static Real norm_of_rows(const Vector& force, const Vector& g, const Vector& round, Real psi) {
    const Vector across = force - dot(force, g) * g;
    return std::hypot(norm(across), dot(across, round) * std::tan(psi));
  }

  // The only joint about whose axis a body turns on another.
  std::optional<WheelAxis> joint_axis(int one, int other) const {
    for (const Joint& joint : data_.situation().joints) {
      const int from = machine_.index.at(joint.from), to = machine_.index.at(joint.to);
      const bool these = (from == one && to == other) || (from == other && to == one);
      const JointPlace& place = machine_.joints.at(joint.name);
      if (!these || joint.freedoms.size() != 1 || !joint.freedoms.front().turning || !place.axis) continue;
      const Vector at = paths_.place(place.at.body, widened(place.at.point + machine_.drawn_origin.at(place.at.body))),
                   along = normalized(paths_.turn(place.axis->body) * widened(place.axis->vector));
      const Vector from_axis = P_ - at;
      return WheelAxis{at, along, from_axis - dot(from_axis, along) * along};
    }
    return std::nullopt;
  }

  std::optional<WheelAxis> axis_of(int body) const {
    if (const auto own = joint_axis(body, carrier_)) return own;
    for (const auto& [name, third] : machine_.index) {
      const auto own = joint_axis(body, third), beside = joint_axis(carrier_, third);
      constexpr Real alike = 1e-5L;
      if (own && beside && norm(cross(own->along, beside->along)) < alike &&
          norm(own->arm - beside->arm) < alike * norm(own->arm))
        return own;
    }
    return std::nullopt;  // a rack
  }

  Vector line_of_contact() const {
    if (!of_) return against_->along;
    if (!against_ || norm(cross(of_->along, against_->along)) < 1e-5L) return of_->along;
    // Towards the place where the axes come nearest to each other, if they meet there.
    const Vector n = cross(of_->along, against_->along), apart = against_->at - of_->at;
    const Vector own = of_->at + dot(cross(apart, against_->along), n) / norm_squared(n) * of_->along,
                 others = against_->at + dot(cross(apart, of_->along), n) / norm_squared(n) * against_->along;
    if (norm(own - others) > 1e-5L * (norm(of_->arm) + norm(against_->arm))) return of_->along;
    return normalized(P_ - own);
  }

  Real helix_angle() const {
    if (gear_.helix_angle) return number(*gear_.helix_angle);
    if (!gear_.lead) return 0;
    return std::atan2(2 * std::acos(Real(-1)) * norm(of_->arm), Real(data_.number(*gear_.lead, dimensions::length)));
  }

  // Along the thread through the pitch point, from two points on it: as far along the line of contact as the turn about
  // the axis says, in the sense of a right-handed screw or against it.
  Vector thread(const Vector& g, Real psi) const {
    if (gear_.hand == Hand::none) return g;
    const Real R = norm(of_->arm), small = 1e-6L * R;
    const Real sense = (gear_.hand == Hand::right ? 1 : -1) * (dot(of_->along, g) < 0 ? -1 : 1);
    const auto point = [&](Real step) {
      const Real turn = sense * step * std::sin(psi) / R;
      const Vector drawn = of_->arm + step * std::cos(psi) * g;
      const Vector& e = of_->along;
      return std::cos(turn) * drawn + std::sin(turn) * cross(e, drawn) + (1 - std::cos(turn)) * dot(e, drawn) * e;
    };
    return normalized(point(small) - point(-small));
  }

  const ParticlePaths& paths_;
  const Machine& machine_;
  DataScope<double>& data_;
  const Gear& gear_;
  int carrier_;
  Vector P_{};
  std::optional<WheelAxis> of_, against_;
};

}  // namespace

std::optional<double> SolvedInstant::tooth_misfit() const {
  const auto slanted = [](const Gear& gear) { return gear.has_pressure_angle() || gear.has_helix(); };
  if (std::ranges::none_of(situation_.gears, slanted)) return std::nullopt;
  const ParticlePaths paths(machine_.links, {}, machine_.q, v_, mechanism_state_->accelerations());
  const double largest = largest_force(*mechanism_state_, unknowns_);
  double worst = 0;
  for (const ToothMeshOf<double>& mesh : machine_.tooth_meshes) {
    const Gear& gear = *std::ranges::find(situation_.gears, mesh.name, &Gear::name);
    if (!slanted(gear)) continue;
    const bool open = std::ranges::any_of(machine_.mechanism.components, [&](const Component<double>& component) {
      return component.action == mesh.action && component.parts_wheels && component.flank == 0;
    });
    const Vector force =
        widened(solve::action_wrench(*mechanism_state_, unknowns_, static_cast<std::size_t>(mesh.action)).force);
    // What is left of teeth that carry nothing beside other forces.
    constexpr Real rounding = 1e-9L;
    if (!(norm(force) > rounding * largest)) continue;
    const DrawnTeeth teeth(paths, machine_, *data_, gear, mesh.carrier);
    const Vector P = paths.place(mesh.carrier, widened(data_->place(gear.at)));
    const auto velocity = [&](const std::string& body) -> Vector {
      const int link = machine_.index.at(body);
      return link == ground ? Vector::zero() : paths.velocity(link, P, ground);
    };
    const Vector slip = gear.friction ? Vector(velocity(gear.of) - velocity(gear.against)) : Vector::zero();
    worst = std::max(worst, static_cast<double>(teeth.misfit(force, slip, !open)));
  }
  return worst;
}

}  // namespace poinsot::problem
