// The gears of a machine.
//
// Where the pitch surfaces of two gears touch, at P, that place is at rest in the body that carries both gears: an arm,
// or what is fixed. There each gear turns about an axis that stays, d = e x (P - C), or slides along d as a rack does.
// The surfaces touch along a line g: of cylinders parallel to their axes, of cones towards the point where the axes
// meet. With the unit vector r across both surfaces, into the gear `of`, and the helix angle psi of its teeth,
//
//   the teeth run along        w = cos psi g + h sin psi e x rho,    h = 1 for a right hand, -1 for a left one,
//   across them, on the surface, stands t = cos psi d - h sin psi g  (for e along g),
//   the gears do not part there: t . (v_of - v_against) = 0,
//   the force on `of` is       F = T t + |T| tan(phi_n) r,
//
// for teeth with the pressure angle phi_n across them, which is phi_t across g: tan phi_n = tan phi_t cos psi.
// Whichever flanks carry, their normals lean towards r, which makes it |T|. (Norton, Design of Machinery, 9.2 and
// Machine Design, 11.8, 12.1, 12.2; Buckingham, Analytical Mechanics of Gears.) Where axes cross without meeting, P
// lies on their common perpendicular, the surfaces touch there alone, and g is along the axis of `of`.
#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "poinsot/engine/math/algebra/plain.h"
#include "poinsot/engine/math/formula/formula_decision.h"
#include "problem/keys/joint_kinds.h"
#include "problem/language/diagnostic.h"
#include "problem/language/exact_numbers.h"
#include "problem/machine/machine_draft.h"

namespace poinsot::problem {
namespace {

// Of sizes in the figure, whose data may have six digits: what is off a line or a parallel by less is meant to lie in
// it.
constexpr double drawn_alike = 1e-6;

// How one body moves relative to another by one joint, as drawn.
template <class Scalar>
struct GearFreedom {
  bool turns = true;
  Vector3<Scalar> at{}, axis{};
};

template <class Scalar>
class GearMesh {
 public:
  GearMesh(MachineDraft<Scalar>& draft, const Gear& gear) : draft_(draft), gear_(gear), P_(draft.data.place(gear.at)) {}

  void add() {
    require_in_plane(draft_, P_, gear_.at.mark(), "the place of gear '" + gear_.name + "'");
    find_carrier();
    const bool crossed = norm(cross(plain(d_), plain(other_d_))) > drawn_alike;
    if (crossed && (!gear_.has_helix() || gear_.hand == Hand::both))
      refuse(gear_.at.mark(),
             "does not run: at the point where they meet '" + gear_.of + "' and '" + gear_.against +
                 "' move along different directions",
             "at: is the point where the two pitch circles touch, on the line of centers; where axes cross, the teeth "
             "have a helix_angle or a lead, and a hand");
    find_sides(crossed);
    Vector t = d_;
    if (gear_.has_helix()) slant(crossed, t);
    require_in_plane(draft_, t, gear_.mark, "the force of gear '" + gear_.name + "'");
    const int on = draft_.body(gear_.of), from = draft_.body(gear_.against);
    mesh_.name = gear_.name;
    mesh_.carrier = carrier_;
    mesh_.action = draft_.add_action(ActionKind::mesh, gear_.name, "", on, from);
    const Place<Scalar> at = draft_.machine.place(carrier_, P_);
    mesh_.at = at;
    draft_.add_component(mesh_.action, draft_.direction_name(t), false, at, {carrier_, t});
    const Scalar normal_tangent = gear_.has_pressure_angle() ? push_apart(crossed, at) : Scalar(0);
    if (gear_.friction) rub(crossed, at, t, normal_tangent);
    VelocityConstraint<Scalar>& alike = draft_.add_constraint(
        VelocityConstraintKind::point, "teeth meeting at gear '" + gear_.name + "'", on, from, at, t);
    alike.along = {carrier_, t};
    alike.toward = at;
    alike.action = mesh_.action;
    draft_.machine.tooth_meshes.push_back(mesh_);
  }

 private:
  using Vector = Vector3<Scalar>;
  using Way = GearFreedom<Scalar>;

  [[noreturn]] void refuse(const Mark& mark, const std::string& message, const std::string& hint) const {
    fail(draft_.situation.file, mark, "gear '" + gear_.name + "' " + message, hint);
  }

  // What a body is welded to, by joints one after the other: with it, it moves as one.
  std::string whole(std::string name) const {
    for (std::size_t steps = 0; steps < draft_.situation.joints.size(); ++steps) {
      const auto weld = std::ranges::find_if(draft_.situation.joints, [&](const Joint& joint) {
        return joint.to == name && joint.freedoms.empty() && !joint.kind->any_turning;
      });
      if (weld == draft_.situation.joints.end()) break;
      name = weld->from;
    }
    return name;
  }

  // The freedom of the joint between two bodies that has no other.
  std::optional<Way> between(const std::string& one, const std::string& other) const {
    const std::string a = whole(one), b = whole(other);
    for (const Joint& joint : draft_.situation.joints) {
      const std::string from = whole(joint.from), to = whole(joint.to);
      const bool these = (from == a && to == b) || (from == b && to == a);
      const JointPlaceOf<Scalar>& place = draft_.machine.joints.at(joint.name);
      if (!these || joint.freedoms.size() != 1 || joint.kind->any_turning || joint.kind->advances || !place.axis)
        continue;
      return Way{joint.freedoms.front().turning, place.at.point + draft_.machine.drawn_origin.at(place.at.body),
                 place.axis->vector};
    }
    return std::nullopt;
  }

  static bool on_one_axis(const Way& a, const Way& b) {
    const Vector3<double> e = plain(a.axis), apart = plain(b.at - a.at);
    return a.turns && b.turns && norm(cross(e, plain(b.axis))) <= drawn_alike &&
           norm(cross(e, apart)) <= drawn_alike * (norm(plain(a.at)) + norm(plain(b.at)));
  }

  // How a gear moves in a body that carries it: by a joint between the two, or where both turn about one axis on a
  // third.
  std::optional<Way> carried(const std::string& gear, const std::string& carrier) const {
    if (whole(gear) == whole(carrier)) return std::nullopt;
    if (auto way = between(gear, carrier)) return way;
    for (const std::string& third : names_) {
      auto one = between(gear, third);
      const auto other = between(carrier, third);
      if (one && other && on_one_axis(*one, *other)) return one;
    }
    return std::nullopt;
  }

  // From the axis of a gear that turns to the place where it meets the other.
  Vector arm(const Way& way) const {
    const Vector from_axis = P_ - way.at;
    return from_axis - dot(from_axis, way.axis) * way.axis;
  }

  // The direction in which a gear moves at the pitch point.
  Vector direction_of(const Way& way, const std::string& name) const {
    if (!way.turns) return way.axis;
    const Vector from_axis = P_ - way.at, d = cross(way.axis, from_axis);
    if (!(norm(plain(d)) > drawn_alike * (norm(plain(P_)) + norm(plain(way.at)))))
      refuse(gear_.at.mark(), "meets at a point on the axis of '" + name + "'",
             "at: is the point where the two pitch circles touch");
    return normalized(d);
  }

  void find_carrier() {
    names_ = {"ground"};
    for (const Frame& frame : draft_.situation.frames) names_.push_back(frame.name);
    for (const Body& body : draft_.situation.bodies) names_.push_back(body.name);
    for (const std::string& carrier : names_) {
      const auto one = carried(gear_.of, carrier), other = carried(gear_.against, carrier);
      if (!one || !other || (!one->turns && !other->turns)) continue;
      carrier_ = draft_.body(carrier);
      one_ = *one;
      other_ = *other;
      d_ = direction_of(one_, gear_.of);
      other_d_ = direction_of(other_, gear_.against);
      return;
    }
    refuse(gear_.mark, "has no body that carries '" + gear_.of + "' and '" + gear_.against + "'",
           "let each turn on one arm, or on the ground, by a revolute joint; a rack slides there by a prismatic one");
  }

  // The directions of each wheel, in which forces are told; and that the wheels touch where their axes cross.
  void find_sides(bool crossed) {
    const auto side = [&](const Way& way, const Vector& d, const Way& beside, const Vector& beside_d) {
      // A rack's teeth stand on the side of its wheel.
      const Vector radial = way.turns ? cross(d, way.axis) : cross(beside.axis, beside_d);
      return typename ToothMeshOf<Scalar>::Side{d, radial, way.turns ? way.axis : normalized(cross(radial, d)),
                                                way.turns ? arm(way) : Vector::zero()};
    };
    mesh_.of = side(one_, d_, other_, other_d_);
    mesh_.against = side(other_, other_d_, one_, d_);
    const auto leaves = [&](const auto& own) { return std::abs(dot(plain(own.tangential), plain(mesh_.of.radial))); };
    if (crossed && (norm(cross(plain(mesh_.of.radial), plain(mesh_.against.radial))) > drawn_alike ||
                    std::max(leaves(mesh_.of), leaves(mesh_.against)) > drawn_alike))
      refuse(gear_.at.mark(), "does not run: '" + gear_.of + "' and '" + gear_.against + "' do not touch there",
             "where axes cross without meeting, at: lies on the line that is perpendicular to both");
  }

  // The line along which the pitch surfaces touch.
  Vector line_of_contact(bool crossed) const {
    if (crossed || !other_.turns) return one_.axis;
    if (!one_.turns) return other_.axis;
    const Vector n = cross(one_.axis, other_.axis);
    if (norm(plain(n)) <= drawn_alike) return one_.axis;
    const Vector apart = other_.at - one_.at;
    const Vector apex = one_.at + (dot(cross(apart, other_.axis), n) / norm_squared(n)) * one_.axis;
    return normalized(Vector(P_ - apex));
  }

  // What the teeth of `of` are across to, along its pitch surface, and the cosine of their helix.
  void slant(bool crossed, Vector& t) {
    if (!one_.turns)
      refuse(gear_.hand_mark, "states the hand of a rack, '" + gear_.of + "'",
             "state it for the wheel: write of: " + gear_.against);
    const Vector g = line_of_contact(crossed);
    const Scalar along = dot(one_.axis, g);
    using std::sqrt;
    Scalar sine(0);
    if (gear_.lead) {
      const Scalar lead = draft_.data.number(*gear_.lead, dimensions::length);
      if (norm(cross(plain(one_.axis), plain(g))) > drawn_alike)
        refuse(gear_.lead->mark(), "states the lead of teeth on a cone", "state their helix_angle");
      if (!draft_.options.lenient && !(plain(lead) > 0))
        refuse(gear_.lead->mark(), "has a lead that is not positive", "its hand says on which side the thread rises");
      const Scalar around = Scalar(2) * pi_value<Scalar>() * norm(arm(one_));
      const Scalar length = sqrt(lead * lead + around * around);
      cosine_ = lead / length;
      sine = around / length;
    } else {
      const Scalar psi = angle(*gear_.helix_angle, "helix_angle");
      using std::cos, std::sin;
      cosine_ = cos(psi);
      sine = sin(psi);
    }
    if (gear_.hand == Hand::both) return;
    if (std::abs(plain(along)) <= drawn_alike)
      refuse(gear_.hand_mark, "states the hand of a flat gear, '" + gear_.of + "'",
             "state it for the other: write of: " + gear_.against);
    const bool backward = decided_negative(along) != (gear_.hand == Hand::left);
    t = cosine_ * d_ + (backward ? sine : Scalar(-1) * sine) * g;
    if (crossed && std::abs(dot(plain(t), plain(other_d_))) <= drawn_alike)
      refuse(gear_.mark, "drives nothing: its teeth stand along the motion of '" + gear_.against + "'",
             "correct helix_angle, lead or hand, which are those of '" + gear_.of + "'");
  }

  // An angle of teeth; 0 only where it may be.
  Scalar angle(const Expression& expression, const std::string& key) const {
    Scalar value = draft_.data.number(expression, dimensions::angle);
    constexpr double right_angle = 1.5707963267948966;
    const bool helix = key == "helix_angle";
    if (!draft_.options.lenient && !(plain(value) < right_angle && (helix ? plain(value) > 0 : plain(value) >= 0)))
      refuse(expression.mark(), "has a " + key + " that is not between 0 and 90 deg",
             helix ? "the hand says on which side the teeth rise" : "whichever flanks carry, teeth push wheels apart");
    return value;
  }

  // How far the axis of a gear lies on the side of r from the pitch point; a rack's is nowhere.
  Scalar inward(const Way& way, const Vector& r) const { return way.turns ? Scalar(-1) * dot(arm(way), r) : Scalar(0); }

  // Across both pitch surfaces, into the teeth of `of`. A wheel lies about its axis, but for a ring, which is larger
  // than what it meets and lies on the other side.
  Vector toward_of(bool crossed) const {
    const Vector r = crossed ? mesh_.of.radial : normalized(cross(d_, line_of_contact(false)));
    const Scalar own = inward(one_, r), others = inward(other_, r);
    const double least = drawn_alike * (norm(plain(arm(one_.turns ? one_ : other_))));
    const bool flat = std::abs(plain(own)) <= least, other_flat = std::abs(plain(others)) <= least;
    if (flat && other_flat) refuse(gear_.mark, "has two flat gears", "one of them is a wheel");
    if (flat) return decided_negative(others) ? r : Vector(-r);
    Vector to_axis = decided_negative(own) ? Vector(-r) : r;
    if (other_flat || decided_negative(Scalar(own * others))) return to_axis;
    const Scalar larger = norm_squared(arm(one_)) - norm_squared(arm(other_));
    if (std::abs(plain(larger)) <= least * least)
      refuse(gear_.mark, "has a pressure angle and joins two wheels that turn about one axis",
             "such teeth push no wheels apart: leave out the angle, or join them by a weld");
    return decided_negative(larger) ? to_axis : Vector(-to_axis);
  }

  // The component by which the teeth push the wheels apart; returns the tangent of the normal pressure angle.
  Scalar push_apart(bool crossed, const Place<Scalar>& at) {
    if (crossed && gear_.pressure_angle)
      refuse(gear_.pressure_angle->mark(), "has crossed axes, across which a pressure_angle is not one of both wheels",
             "state normal_pressure_angle, that across the teeth");
    const Expression& stated = gear_.pressure_angle ? *gear_.pressure_angle : *gear_.normal_pressure_angle;
    using std::tan;
    Scalar part = tan(angle(stated, gear_.pressure_angle ? "pressure_angle" : "normal_pressure_angle"));
    if (gear_.pressure_angle && gear_.hand != Hand::both) part = part * cosine_;
    if (!gear_.pressure_angle && gear_.hand == Hand::both) part = part / cosine_;
    const Vector r = toward_of(crossed);
    require_in_plane(draft_, r, gear_.mark, "the force of gear '" + gear_.name + "'");
    const int leader = static_cast<int>(draft_.machine.mechanism.components.size()) - 1;
    Component<Scalar>& apart = draft_.add_component(mesh_.action, draft_.direction_name(r), false, at, {carrier_, r});
    apart.follows = leader;
    apart.part = part;
    apart.parts_wheels = true;
    apart.flank = 0;
    return part;
  }

  // The friction of teeth that slide along each other, mu N with N = |T|/cos(phi_n). Its sense is that of a motion.
  void rub(bool crossed, const Place<Scalar>& at, const Vector& t, const Scalar& normal_tangent) {
    if (!crossed)
      refuse(gear_.friction->mark(), "has friction, but its teeth do not slide where the pitch circles touch",
             "leave it out: only the teeth of worms and screw gears slide there");
    using std::sqrt;
    const Scalar mu = draft_.data.number(*gear_.friction, dimensions::none);
    if (!draft_.options.lenient && !(plain(mu) >= 0))
      refuse(gear_.friction->mark(), "has a coefficient of friction that is negative", "correct it");
    const Vector r = mesh_.of.radial;
    mesh_.thread = normalized(cross(r, t));
    int leader = static_cast<int>(draft_.machine.mechanism.components.size()) - 1;
    if (gear_.has_pressure_angle()) --leader;
    Component<Scalar>& rubbing = draft_.add_component(mesh_.action, "its thread", false, at, {carrier_, mesh_.thread});
    rubbing.follows = leader;
    rubbing.part = mu * sqrt(Scalar(1) + normal_tangent * normal_tangent);
    rubbing.parts_wheels = rubbing.rubs = true;
    rubbing.flank = 0;
  }

  MachineDraft<Scalar>& draft_;
  const Gear& gear_;
  Vector P_;
  std::vector<std::string> names_;
  int carrier_ = ground;
  Way one_, other_;  // of `of` and `against`, in what carries them
  Vector d_{}, other_d_{};
  Scalar cosine_{1};  // of the helix angle
  ToothMeshOf<Scalar> mesh_;
};

}  // namespace

template <class Scalar>
void add_gear(MachineDraft<Scalar>& draft, const Gear& gear) {
  GearMesh<Scalar>(draft, gear).add();
}

template void add_gear(MachineDraft<double>&, const Gear&);
template void add_gear(MachineDraft<Dual<1>>&, const Gear&);
template void add_gear(MachineDraft<Formula>&, const Gear&);

}  // namespace poinsot::problem
