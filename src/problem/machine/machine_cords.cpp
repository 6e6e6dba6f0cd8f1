// The cords of a machine: straight ones, long ones, and those that are led over wheels.
//
// A cord over wheels is a row of straight parts between what it touches (engine/dynamics/cord_span.h). Over a smooth
// wheel or through an eyelet it slides: the parts on both sides pull with one force, and grow by nothing together. On
// a wheel that turns it does not slip, so that each side has a force of its own.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <variant>

#include "poinsot/engine/math/algebra/plain.h"
#include "problem/keys/joint_kinds.h"
#include "problem/language/diagnostic.h"
#include "problem/language/exact_numbers.h"
#include "problem/machine/machine_draft.h"
#include "problem/machine/shape_row.h"

namespace poinsot::problem {

namespace {

// Of sizes in the figure, whose data may have six digits: what lies off a plane or a parallel by less is meant to lie
// in it.
constexpr double as_drawn = 1e-6;

// What a cord touches, as drawn.
template <class Scalar>
struct CordStop {
  std::string name;
  int body = ground;
  Vector3<Scalar> center{};
  Scalar radius{};                        // 0: a point
  std::optional<Vector3<Scalar>> axis{};  // of a wheel; not yet known of a circle of the ground
  std::optional<Vector3<Scalar>> side{};
  bool slides = true;
  double sense = 0;  // the side of the wheel that it touches, 1 or -1
  Mark mark;

  bool is_wheel() const { return plain(radius) > 0; }
};

template <class Scalar>
class LedCord {
 public:
  LedCord(MachineDraft<Scalar>& draft, const Cord& cord) : draft_(draft), cord_(cord) {}

  void add() {
    find_stops();
    find_axes();
    bring_into_plane();
    find_sides();
    find_spans();
    add_parts();
  }

 private:
  using Vector = Vector3<Scalar>;
  using Stop = CordStop<Scalar>;

  [[noreturn]] void refuse(const Mark& mark, const std::string& message, const std::string& hint = "") const {
    fail(draft_.situation.file, mark, "cord '" + cord_.name + "' " + message, hint);
  }

  void find_stops() {
    stops_.push_back(cord_.off_from ? wheel_of(*cord_.off_from) : end_of(cord_.from, *cord_.at));
    for (const CordWheel& wheel : cord_.over) stops_.push_back(wheel_of(wheel));
    stops_.push_back(cord_.on_to ? wheel_of(*cord_.on_to) : end_of(cord_.to, *cord_.end));
    for (const auto& [wheel, stop] :
         {std::pair{&cord_.off_from, &stops_.front()}, std::pair{&cord_.on_to, &stops_.back()}})
      if (*wheel && !stop->is_wheel())
        refuse((*wheel)->mark, "winds on '" + stop->name + "', which is no wheel there",
               "state its radius, or the point to which the cord is tied");
  }

  Stop end_of(const std::string& body, const Expression& place) const {
    Stop stop;
    stop.name = body;
    stop.body = draft_.body(body);
    stop.center = draft_.data.place(place);
    stop.mark = place.mark();
    return stop;
  }

  Stop wheel_of(const CordWheel& wheel) const {
    Stop stop;
    stop.name = wheel.name;
    stop.mark = wheel.mark;
    if (wheel.side) stop.side = draft_.data.direction(*wheel.side);
    const auto body = draft_.machine.index.find(wheel.name);
    if (body == draft_.machine.index.end()) {
      for (const auto* said : {&wheel.at, &wheel.radius, &wheel.side})
        if (*said)
          refuse((*said)->mark(), "is led through the point '" + wheel.name + "', of which nothing more is said",
                 "of a wheel that is fixed write ground: {at: " + wheel.name + ", radius: r}");
      stop.center = draft_.data.place(wheel.named);
      return stop;
    }
    stop.body = body->second;
    if (wheel.at && !wheel.radius) {
      stop.center = draft_.data.place(*wheel.at);
      return stop;
    }
    find_wheel(wheel, stop);
    if (wheel.at) stop.center = draft_.data.place(*wheel.at);
    if (wheel.radius) stop.radius = draft_.data.number(*wheel.radius, dimensions::length);
    if (!(plain(stop.radius) > 0))
      refuse(wheel.mark, "is led over '" + wheel.name + "', whose radius there is not known",
             "write " + wheel.name + ": {radius: r}, or {at: P} for an eyelet");
    return stop;
  }

  // Center and axis of a wheel by the joint that it turns in or by its shape, its radius by the shape, and whether it
  // turns.
  void find_wheel(const CordWheel& wheel, Stop& stop) const {
    bool held = false, turns = false;
    std::optional<Vector> center, axis;
    for (const Joint& joint : draft_.situation.joints) {
      if (stop.body == ground || (joint.to != wheel.name && joint.from != wheel.name)) continue;
      held = held || joint.to == wheel.name;
      const bool turning = joint.kind->any_turning || std::ranges::any_of(joint.freedoms, &Freedom::turning);
      if (joint.to == wheel.name) turns = turns || turning;
      const JointPlaceOf<Scalar>& place = draft_.machine.joints.at(joint.name);
      if (!turning || joint.freedoms.size() != 1 || !place.axis || (axis && joint.to != wheel.name)) continue;
      center = place.at.point + draft_.machine.drawn_origin.at(place.at.body);
      axis = place.axis->vector;
    }
    const auto body = std::ranges::find(draft_.situation.bodies, wheel.name, &Body::name);
    if (body != draft_.situation.bodies.end()) {
      std::vector<double> radii;
      for (const Part& part : body->parts) {
        const ShapeRow<Scalar>& row = shape_row<Scalar>(part.shape.kind);
        if (!row.round) continue;
        const auto circle = circle_of(row.round(ShapeArguments<Scalar>(part.shape, draft_.data, part.name, false)));
        if (!circle || (axis && norm(plain(cross(*axis, circle->axis))) > as_drawn)) continue;
        if (!center) {
          center = circle->center;
          axis = circle->axis;
        }
        if (radii.empty()) stop.radius = circle->radius;
        radii.push_back(plain(circle->radius));
      }
      const auto other = [&](double r) { return std::abs(r - radii.front()) > as_drawn * r; };
      if (!wheel.radius && std::ranges::any_of(radii, other))
        refuse(wheel.mark, "is led over '" + wheel.name + "', which is round with several radii",
               "write " + wheel.name + ": {radius: r}");
    }
    if (!center && !wheel.at)
      refuse(wheel.mark, "is led over '" + wheel.name + "', which is no wheel: it turns about no axis and is not round",
             "write " + wheel.name + ": {at: P} for an eyelet of it, {at: C, radius: r} for a wheel of it");
    if (center) stop.center = *center;
    stop.axis = axis;
    stop.slides = wheel.smooth || stop.body == ground || (held && !turns);
  }

  static std::optional<CircleSurface<Scalar>> circle_of(const RoundSurface<Scalar>& surface) {
    if (const auto* circle = std::get_if<CircleSurface<Scalar>>(&surface)) return *circle;
    if (const auto* frustum = std::get_if<FrustumSurface<Scalar>>(&surface))
      if (std::abs(plain(frustum->r_A - frustum->r_B)) <= as_drawn * plain(frustum->r_A))
        return CircleSurface<Scalar>{Scalar(0.5) * (frustum->A + frustum->B), normalized(frustum->B - frustum->A),
                                     frustum->r_A};
    return std::nullopt;
  }

  // A wheel of which no axis is known turns about that of another wheel of the cord, or stands across it as drawn.
  void find_axes() {
    std::optional<Vector> known;
    for (const Stop& stop : stops_)
      if (stop.axis && !known) known = stop.axis;
    for (std::size_t i = 0; i < stops_.size(); ++i) {
      if (!stops_[i].is_wheel() || stops_[i].axis) continue;
      if (known) {
        stops_[i].axis = known;
        continue;
      }
      const Vector& C = stops_[i].center;
      const Vector before = i > 0 ? Vector(C - stops_[i - 1].center) : Vector::zero(),
                   behind = i + 1 < stops_.size() ? Vector(stops_[i + 1].center - C) : Vector::zero();
      const Vector normal = cross(before, behind);
      if (!(norm(plain(normal)) > as_drawn * norm(plain(before)) * norm(plain(behind))))
        refuse(stops_[i].mark, "does not tell the plane of the wheel of '" + stops_[i].name + "'",
               "let it be a body that turns about an axis");
      stops_[i].axis = normalized(normal);
    }
  }

  // A wheel may be drawn beside the cord's plane: it is met where its axis goes through that.
  void bring_into_plane() {
    std::size_t first = 0;
    while (first < stops_.size() && stops_[first].is_wheel()) ++first;
    if (first == stops_.size()) first = 0;
    const auto bring = [&](Stop& stop, const Stop& beside) {
      if (!stop.is_wheel()) return;
      const Scalar off = dot(beside.center - stop.center, *stop.axis);
      if (!vanishes(off)) stop.center += off * *stop.axis;
    };
    for (std::size_t i = first; i > 0; --i) bring(stops_[i - 1], stops_[i]);
    for (std::size_t i = first; i + 1 < stops_.size(); ++i) bring(stops_[i + 1], stops_[i]);
    for (const Stop& stop : stops_)
      if (stop.is_wheel())
        require_along_normal(draft_, *stop.axis, cord_.mark, "the axis of a wheel of cord '" + cord_.name + "'");
    for (std::size_t i = 0; i + 1 < stops_.size(); ++i) {
      const Stop &a = stops_[i], &b = stops_[i + 1];
      const Vector3<double> D = plain(b.center - a.center);
      if (!(norm(D) > 0)) refuse(b.mark, "has no length between '" + a.name + "' and '" + b.name + "'");
      if (a.is_wheel() && b.is_wheel() && norm(cross(plain(*a.axis), plain(*b.axis))) > as_drawn)
        refuse(b.mark,
               "is led over wheels that turn about axes that are not parallel, '" + a.name + "' and '" + b.name + "'",
               "lead it through an eyelet, a point, between them");
      for (const Stop* stop : {&a, &b})
        if (stop->is_wheel() && std::abs(dot(D, plain(*stop->axis))) > as_drawn * norm(D))
          refuse(stop->mark,
                 "leaves the plane of the wheel '" + stop->name + "' between '" + a.name + "' and '" + b.name + "'",
                 "both its sides lie across the axis of the wheel");
    }
  }

  void find_sides() {
    for (std::size_t i = 0; i < stops_.size(); ++i) {
      Stop& stop = stops_[i];
      if (!stop.is_wheel()) continue;
      const Vector3<double> e = plain(*stop.axis), C = plain(stop.center);
      const Vector3<double> comes = i > 0 ? C - plain(stops_[i - 1].center) : plain(stops_[1].center) - C;
      if (stop.side) {
        const double beside = dot(normalized(cross(e, comes)), plain(*stop.side));
        if (std::abs(beside) < slight)
          refuse(stop.mark, "comes to the wheel '" + stop.name + "' along the direction that is stated as its side",
                 "the side lies across the cord: the left or the right one of a wheel above it");
        stop.sense = beside > 0 ? 1 : -1;
        continue;
      }
      const bool end = i == 0 || i + 1 == stops_.size();
      const Vector3<double> leaves = end ? comes : plain(stops_[i + 1].center) - C;
      const double turn = dot(e, cross(normalized(comes), normalized(leaves)));
      if (std::abs(turn) < slight)
        refuse(stop.mark,
               end ? "does not say on which side of '" + stop.name + "' it winds"
                   : "may pass '" + stop.name + "' on either side",
               "write " + stop.name + ": {side: +x}, the side of the center on which the cord " +
                   (i == 0 ? "leaves it" : "comes to it"));
      stop.sense = turn < 0 ? 1 : -1;
    }
  }

  void find_spans() {
    std::optional<Vector> before;
    for (std::size_t i = 0; i + 1 < stops_.size(); ++i) {
      const Stop &a = stops_[i], &b = stops_[i + 1];
      const Stop& wheel = a.is_wheel() ? a : b;
      const Vector e = wheel.is_wheel() ? *wheel.axis : Vector::zero();
      const auto end = [&](const Stop& stop) {
        // The senses are told by each wheel's own axis.
        const double same = stop.is_wheel() && dot(plain(*stop.axis), plain(e)) < 0 ? -1 : 1;
        return CordEnd<Scalar>{draft_.machine.place(stop.body, stop.center), Scalar(same * stop.sense) * stop.radius};
      };
      CordSpan<Scalar> span{end(a), end(b), {wheel.is_wheel() ? wheel.body : ground, e}};
      const double distance = norm(plain(b.center - a.center));
      if (!(std::abs(plain(span.from.reach - span.to.reach)) < distance))
        refuse(b.mark, "cannot be drawn straight from '" + a.name + "' to '" + b.name + "'",
               a.is_wheel() && b.is_wheel() ? "the wheels overlap" : "the point lies within the wheel");
      lines_.push_back(line_between<Scalar>(a.center, b.center, e, span.from.reach, span.to.reach));
      const Vector& along = lines_.back().along;
      require_in_plane(draft_, along, cord_.mark, "cord '" + cord_.name + "'");
      if (before && a.is_wheel()) {
        span.turn_cosine = dot(*before, along);
        span.turn_sine = dot(e, cross(*before, along));
        // By how far it lies on the wheel, of which -90 deg to 0 is nearly all of it: a side that was not meant.
        const double on_wheel =
            std::atan2(-plain(span.turn_sine) * (plain(span.from.reach) > 0 ? 1 : -1), plain(span.turn_cosine));
        if (!a.side && on_wheel <= 0 && on_wheel > -std::numbers::pi / 2)
          refuse(a.mark, "may pass '" + a.name + "' on either side",
                 "write " + a.name + ": {side: +x}, the side of the center on which the cord comes to it");
      }
      before = along;
      spans_.push_back(std::move(span));
    }
  }

  void add_parts() {
    Mechanism<Scalar>& mechanism = draft_.machine.mechanism;
    // Where each row of parts with one tension begins.
    std::vector<std::size_t> begins{0};
    std::vector<int> actions;
    for (std::size_t i = 0; i < spans_.size(); ++i) {
      const CordSpan<Scalar>& span = spans_[i];
      const bool own = i == 0 || !stops_[i].slides;
      if (i > 0 && own) begins.push_back(i);
      const int action = draft_.add_action(ActionKind::cord, cord_.name, "", span.to.body(), span.from.body());
      actions.push_back(action);
      Component<Scalar>& pull = draft_.add_component(
          action, "", false, draft_.machine.place(span.to.body(), lines_[i].end), {ground, -lines_[i].along});
      pull.toward = draft_.machine.place(span.from.body(), lines_[i].start);
      pull.span = span;
      if (own) {
        pull.one_sided = true;
        leader_ = static_cast<int>(mechanism.components.size()) - 1;
      } else {
        pull.follows = leader_;
      }
    }
    begins.push_back(spans_.size());
    const bool keeps = !cord_.off_from && !cord_.on_to;
    for (std::size_t run = 0; run + 1 < begins.size(); ++run) {
      // Where the whole length is kept, that and all parts but the first tell the same as all parts.
      const bool whole = keeps && run == 0;
      const std::size_t first = begins[run], last = whole ? spans_.size() : begins[run + 1];
      const std::string words =
          "cord '" + cord_.name + "' taut" +
          (whole || begins.size() == 2 ? std::string()
                                       : " from '" + stops_[first].name + "' to '" + stops_[last].name + "'");
      const CordSpan<Scalar>& one = spans_[first];
      VelocityConstraint<Scalar>& taut =
          draft_.add_constraint(VelocityConstraintKind::led_cord, words, one.to.body(), one.from.body(),
                                draft_.machine.place(one.to.body(), lines_[first].end), lines_[first].along);
      taut.action = actions[first];
      taut.spans.assign(spans_.begin() + static_cast<std::ptrdiff_t>(first),
                        spans_.begin() + static_cast<std::ptrdiff_t>(last));
      taut.keeps_length = whole;
      for (std::size_t i = first; whole && i < last; ++i) taut.length += lines_[i].length;
    }
  }

  // A sine: a cord that turns at a wheel by less does not tell the side, as its data may have few digits.
  static constexpr double slight = 1e-3;

  MachineDraft<Scalar>& draft_;
  const Cord& cord_;
  std::vector<Stop> stops_;
  std::vector<CordSpan<Scalar>> spans_;
  std::vector<SpanLine<Scalar>> lines_;
  int leader_ = -1;
};

}  // namespace

template <class Scalar>
void add_cord(MachineDraft<Scalar>& draft, const Cord& cord) {
  if (cord.is_led()) return LedCord<Scalar>(draft, cord).add();
  const int on = draft.body(cord.to), from = draft.body(cord.from);
  const int action = draft.add_action(ActionKind::cord, cord.name, "", on, from);
  const Vector3<Scalar> end = draft.data.place(*cord.end);
  const Place<Scalar> at = draft.machine.place(on, end);
  if (cord.direction) {
    const Vector3<Scalar> d = draft.data.direction(*cord.direction);
    require_in_plane(draft, d, cord.mark, "cord '" + cord.name + "'");
    draft.add_component(action, "", false, at, {ground, d}).one_sided = true;
    draft.add_constraint(VelocityConstraintKind::point, "cord '" + cord.name + "' taut", on, from, at, d).action =
        action;
    return;
  }
  const Vector3<Scalar> start = draft.data.place(*cord.at);
  if (!(norm(plain(end - start)) > 0))
    fail(draft.situation.file, cord.mark, "cord '" + cord.name + "' has length zero");
  require_in_plane<Scalar>(draft, start - end, cord.mark, "cord '" + cord.name + "'");
  const Vector3<Scalar> inward = normalized(start - end);
  Component<Scalar>& pull = draft.add_component(action, "", false, at, {ground, inward});
  pull.toward = draft.machine.place(from, start);
  pull.one_sided = true;
  VelocityConstraint<Scalar>& taut =
      draft.add_constraint(VelocityConstraintKind::cord_length, "cord '" + cord.name + "' taut", on, from, at, inward);
  taut.toward = draft.machine.place(from, start);
  taut.length = norm(end - start);
  taut.action = action;
}

template void add_cord(MachineDraft<double>&, const Cord&);
template void add_cord(MachineDraft<Dual<1>>&, const Cord&);
template void add_cord(MachineDraft<Formula>&, const Cord&);

}  // namespace poinsot::problem
