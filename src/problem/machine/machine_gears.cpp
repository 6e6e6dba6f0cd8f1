// The gears of a machine.
//
// Where the pitch circles of two gears touch, their material points move with one velocity along the tangent d of the
// circles. That place is at rest in the body that carries both gears: an arm, or what is fixed. There each gear turns
// about an axis that stays, d = e x (P - C), or slides along d as a rack does. Along d the teeth exert their force.
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "poinsot/engine/math/algebra/plain.h"
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
    const auto [carrier, d] = find_carrier();
    require_in_plane(draft_, d, gear_.mark, "the force of gear '" + gear_.name + "'");
    const int on = draft_.body(gear_.of), from = draft_.body(gear_.against);
    const int action = draft_.add_action(ActionKind::mesh, gear_.name, "", on, from);
    const Place<Scalar> at = draft_.machine.place(carrier, P_);
    draft_.add_component(action, draft_.direction_name(d), false, at, {carrier, d});
    VelocityConstraint<Scalar>& alike = draft_.add_constraint(
        VelocityConstraintKind::point, "teeth meeting at gear '" + gear_.name + "'", on, from, at, d);
    alike.along = {carrier, d};
    alike.toward = at;
    alike.action = action;
  }

 private:
  using Vector = Vector3<Scalar>;
  using Way = GearFreedom<Scalar>;

  [[noreturn]] void refuse(const Mark& mark, const std::string& message, const std::string& hint) const {
    fail(draft_.situation.file, mark, "gear '" + gear_.name + "' " + message, hint);
  }

  // The freedom of the joint between two bodies that has no other.
  std::optional<Way> between(const std::string& a, const std::string& b) const {
    for (const Joint& joint : draft_.situation.joints) {
      const bool these = (joint.from == a && joint.to == b) || (joint.from == b && joint.to == a);
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
    if (gear == carrier) return std::nullopt;
    if (const auto way = between(gear, carrier)) return way;
    for (const std::string& third : names_) {
      const auto one = between(gear, third), other = between(carrier, third);
      if (third != gear && third != carrier && one && other && on_one_axis(*one, *other)) return one;
    }
    return std::nullopt;
  }

  // The direction in which a gear moves at the pitch point.
  Vector direction_of(const Way& way, const std::string& name) const {
    if (!way.turns) return way.axis;
    const Vector arm = P_ - way.at, d = cross(way.axis, arm);
    if (!(norm(plain(d)) > drawn_alike * (norm(plain(P_)) + norm(plain(way.at)))))
      refuse(gear_.at.mark(), "meets at a point on the axis of '" + name + "'",
             "at: is the point where the two pitch circles touch");
    return normalized(d);
  }

  std::pair<int, Vector> find_carrier() {
    names_ = {"ground"};
    for (const Frame& frame : draft_.situation.frames) names_.push_back(frame.name);
    for (const Body& body : draft_.situation.bodies) names_.push_back(body.name);
    for (const std::string& carrier : names_) {
      const auto one = carried(gear_.of, carrier), other = carried(gear_.against, carrier);
      if (!one || !other || (!one->turns && !other->turns)) continue;
      const Vector d = direction_of(*one, gear_.of);
      if (norm(cross(plain(d), plain(direction_of(*other, gear_.against)))) > drawn_alike)
        refuse(gear_.at.mark(),
               "does not run: at the point where they meet '" + gear_.of + "' and '" + gear_.against +
                   "' move along different directions",
               "at: is the point where the two pitch circles touch, on the line of centers");
      return {draft_.body(carrier), d};
    }
    refuse(gear_.mark, "has no body that carries '" + gear_.of + "' and '" + gear_.against + "'",
           "let each turn on one arm, or on the ground, by a revolute joint; a rack slides there by a prismatic one");
  }

  MachineDraft<Scalar>& draft_;
  const Gear& gear_;
  Vector P_;
  std::vector<std::string> names_;
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
