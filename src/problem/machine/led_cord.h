// The way of a cord, belt or chain that is led over wheels, as drawn: what it touches, on which sides, and its straight
// parts between.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "poinsot/engine/dynamics/capstan.h"
#include "poinsot/engine/math/algebra/plain.h"
#include "poinsot/engine/math/formula/formula_angle.h"
#include "poinsot/engine/math/formula/formula_decision.h"
#include "problem/keys/joint_kinds.h"
#include "problem/language/diagnostic.h"
#include "problem/language/exact_numbers.h"
#include "problem/language/words.h"
#include "problem/machine/machine_draft.h"
#include "problem/machine/shape_row.h"

namespace poinsot::problem {

// Of sizes in the figure, whose data may have six digits: what lies off a plane or a parallel by less is meant to lie
// in it.
inline constexpr double as_drawn = 1e-6;

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
  const Contact* rubbing = nullptr;  // the friction of the cord on it
  std::optional<Scalar> turns{};     // how often the cord goes round it, where that is stated
  Scalar wrap{};                     // the angle of that
  std::string carrier;               // of a wheel that turns: what its joint holds it on
  double sense = 0;                  // the side of the wheel that it touches, 1 or -1
  Mark mark;

  bool is_wheel() const { return plain(radius) > 0; }
};

// The friction of a cord or belt on what it is led over, in its state; null if there is none.
inline const Contact* rubbing_on(const Situation& situation, const std::string& cord, const CordWheel& wheel) {
  if (!wheel.friction) return nullptr;
  const auto found = std::ranges::find(situation.contacts, cord + " on " + wheel.name, &Contact::name);
  return found == situation.contacts.end() ? nullptr : &*found;
}

template <class Scalar>
class CordWay {
 public:
  // words: "cord 'rope'". A closed one goes on from its last stop to the first.
  CordWay(MachineDraft<Scalar>& draft, std::string words, const Mark& mark, bool closed)
      : draft_(draft), words_(std::move(words)), mark_(mark), closed_(closed) {}

  // Adds the stops of a closed one or of a cord with its ends, in their order.
  void add_end(const std::string& body, const Expression& place) { stops.push_back(end_of(body, place)); }
  void add_wheel(const CordWheel& wheel, const Contact* rubbing) {
    stops.push_back(wheel_of(wheel));
    stops.back().rubbing = rubbing;
    if (!rubbing) return;
    // As long as it is not known what it does, nothing keeps it from slipping.
    stops.back().slides = !rubbing->of_belt && rubbing->grip != Grip::sticks;
  }
  // A belt that crosses itself between its two wheels passes them on different sides.
  void find_way(bool crossed = false) {
    find_axes();
    bring_into_plane();
    find_sides(crossed);
    find_spans();
  }

  std::vector<CordStop<Scalar>> stops;
  std::vector<CordSpan<Scalar>> spans;  // the one from each stop to the next
  std::vector<SpanLine<Scalar>> lines;

  // Of a cord with its ends, as drawn: its straight parts and what lies on the wheels between them.
  Scalar length() const {
    Scalar whole(0);
    for (const SpanLine<Scalar>& line : lines) whole += line.length;
    for (std::size_t i = 1; i < spans.size(); ++i)
      if (stops[i].is_wheel()) whole += stops[i].radius * angle_on(spans[i]);
    return whole;
  }
  std::size_t span_count() const { return closed_ ? stops.size() : stops.size() - 1; }
  const CordStop<Scalar>& behind(std::size_t i) const { return stops[(i + 1) % stops.size()]; }

  [[noreturn]] void refuse(const Mark& mark, const std::string& message, const std::string& hint = "") const {
    fail(draft_.situation.file, mark, words_ + " " + message, hint);
  }

  // Adds a straight part with the force in it.
  Component<Scalar>& add_pull(int action, std::size_t i) {
    Component<Scalar>& pull = draft_.add_component(
        action, "", false, draft_.machine.place(spans[i].to.body(), lines[i].end), {ground, -lines[i].along});
    pull.toward = draft_.machine.place(spans[i].from.body(), lines[i].start);
    pull.span = spans[i];
    return pull;
  }
  int add_part(const std::string& name, std::size_t i) {
    const int action = draft_.add_action(ActionKind::cord, name, "", spans[i].to.body(), spans[i].from.body());
    draft_.machine.cord_parts.push_back({name, stops[i].name, behind(i).name, action});
    return action;
  }
  // Adds that several parts grow by nothing together.
  VelocityConstraint<Scalar>& add_tautness(int action, std::size_t first, std::size_t count, const std::string& words) {
    VelocityConstraint<Scalar>& taut =
        draft_.add_constraint(VelocityConstraintKind::led_cord, words, spans[first].to.body(), spans[first].from.body(),
                              draft_.machine.place(spans[first].to.body(), lines[first].end), lines[first].along);
    taut.action = action;
    for (std::size_t i = first; i < first + count; ++i) taut.spans.push_back(spans[i % spans.size()]);
    return taut;
  }

  // Adds the friction on the wheel between two parts by their actions, and what the parts behind it grow by as the cord
  // slips over it. Returns the part of the tension before it that is behind it, if it slips, as an exponent per angle.
  Scalar add_rubbing(std::size_t stop, int before, int behind_it, const std::vector<CordSpan<Scalar>>& after) {
    const Contact& contact = *stops[stop].rubbing;
    RoughContactOf<Scalar> rough;
    rough.name = contact.name;
    rough.action = before;
    rough.behind = behind_it;
    rough.of_belt = contact.of_belt;
    rough.grip = contact.grip;
    std::tie(rough.friction_at_rest, rough.friction_in_slip) = friction_of(draft_, contact, dimensions::none);
    rough.wrap = stops[stop].wrap;
    rough.resting = capstan_coefficient(capstan_ratio(Scalar(rough.friction_at_rest * rough.wrap)));
    rough.sliding = capstan_coefficient(capstan_ratio(Scalar(rough.friction_in_slip * rough.wrap)));
    const Vector x{Scalar(1), Scalar(0), Scalar(0)}, y{Scalar(0), Scalar(1), Scalar(0)},
        z{Scalar(0), Scalar(0), Scalar(1)};
    rough.normal = {ground, y};
    rough.motions[1].kind = VelocityConstraintKind::led_cord;
    rough.motions[1].along = {ground, x};
    rough.motions[2].along = {ground, z};
    if (!after.empty()) {
      rough.motions[1].on = after.front().to.body();
      rough.motions[1].from = after.front().from.body();
      rough.motions[1].spans = after;
    }
    Scalar gain(0);
    if (contact.grip == Grip::slides) {
      const bool forward = plain(dot(draft_.data.direction(*contact.slip), x)) > 0;
      rough.slip = {ground, forward ? x : -x};
      gain = forward ? rough.friction_in_slip : -rough.friction_in_slip;
    }
    draft_.machine.rough_contacts.push_back(std::move(rough));
    return gain;
  }

 private:
  using Vector = Vector3<Scalar>;
  using Stop = CordStop<Scalar>;

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
    if (wheel.turns) {
      stop.turns = draft_.data.number(*wheel.turns, dimensions::none);
      if (!(plain(*stop.turns) > 0) && !draft_.options.lenient)
        refuse(wheel.turns->mark(), "goes round '" + wheel.name + "' by no turn", "turns: is a positive number");
    }
    const auto body = draft_.machine.index.find(wheel.name);
    if (body == draft_.machine.index.end()) {
      for (const auto* said : {&wheel.at, wheel.radius ? &wheel.at : &wheel.side})
        if (*said)
          refuse((*said)->mark(), "is led through the point '" + wheel.name + "', of which nothing more is said",
                 "of a post that is fixed there write " + wheel.name + ": {radius: r}");
      stop.center = draft_.data.place(wheel.named);
      if (wheel.radius) stop.radius = radius_of(wheel);
      return stop;
    }
    stop.body = body->second;
    if (wheel.at && !wheel.radius) {
      stop.center = draft_.data.place(*wheel.at);
      return stop;
    }
    find_wheel(wheel, stop);
    if (wheel.at) stop.center = draft_.data.place(*wheel.at);
    if (wheel.radius) stop.radius = radius_of(wheel);
    if (!(plain(stop.radius) > 0))
      refuse(wheel.mark, "is led over '" + wheel.name + "', whose radius there is not known",
             "write " + wheel.name + ": {radius: r}, or {at: P} for an eyelet");
    return stop;
  }
  Scalar radius_of(const CordWheel& wheel) const { return draft_.data.number(*wheel.radius, dimensions::length); }

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
      const bool turns_only = joint.freedoms.size() == 1 && joint.freedoms.front().turning && !joint.kind->advances;
      if (turns_only && (joint.to == wheel.name || stop.carrier.empty()))
        stop.carrier = joint.to == wheel.name ? joint.from : joint.to;
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

  // A wheel of which no axis is known turns about that of another wheel of the cord or about the normal of a planar
  // problem, or stands across it as drawn.
  void find_axes() {
    std::optional<Vector> known;
    for (const Stop& stop : stops)
      if (stop.axis && !known) known = stop.axis;
    if (const auto& plane = draft_.situation.plane; plane && !known) known = Vector::unit(plane->normal());
    for (std::size_t i = 0; i < stops.size(); ++i) {
      if (!stops[i].is_wheel() || stops[i].axis) continue;
      if (known) {
        stops[i].axis = known;
        continue;
      }
      const Vector& C = stops[i].center;
      const Vector comes = i > 0 || closed_ ? Vector(C - before(i).center) : Vector::zero(),
                   leaves = i + 1 < stops.size() || closed_ ? Vector(behind(i).center - C) : Vector::zero();
      const Vector normal = cross(comes, leaves);
      if (!(norm(plain(normal)) > as_drawn * norm(plain(comes)) * norm(plain(leaves))))
        refuse(stops[i].mark, "does not tell the plane of the wheel of '" + stops[i].name + "'",
               "let it be a body that turns about an axis");
      stops[i].axis = normalized(normal);
    }
  }

  // A wheel may be drawn beside the cord's plane: it is met where its axis goes through that.
  void bring_into_plane() {
    std::size_t first = 0;
    while (first < stops.size() && stops[first].is_wheel()) ++first;
    if (first == stops.size()) first = 0;
    const auto bring = [&](Stop& stop, const Stop& beside) {
      if (!stop.is_wheel()) return;
      const Scalar off = dot(beside.center - stop.center, *stop.axis);
      if (!vanishes(off)) stop.center += off * *stop.axis;
    };
    for (std::size_t i = first; i > 0; --i) bring(stops[i - 1], stops[i]);
    for (std::size_t i = first; i + 1 < stops.size(); ++i) bring(stops[i + 1], stops[i]);
    for (const Stop& stop : stops)
      if (stop.is_wheel()) require_along_normal(draft_, *stop.axis, mark_, "the axis of a wheel of " + words_);
    for (std::size_t i = 0; i < span_count(); ++i) {
      const Stop &a = stops[i], &b = behind(i);
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

  void find_sides(bool crossed) {
    for (std::size_t i = 0; i < stops.size(); ++i) {
      Stop& stop = stops[i];
      if (!stop.is_wheel()) continue;
      const Vector &e = *stop.axis, &C = stop.center;
      const Vector comes = i > 0 || closed_ ? C - before(i).center : stops[1].center - C;
      if (stop.side) {
        const Vector aside = cross(e, comes);
        if (std::abs(dot(normalized(plain(aside)), plain(*stop.side))) < slight)
          refuse(stop.mark, "comes to the wheel '" + stop.name + "' along the direction that is stated as its side",
                 "the side lies across the cord: the left or the right one of a wheel above it");
        stop.sense = decided_negative(dot(aside, *stop.side)) ? -1 : 1;
        continue;
      }
      if (closed_ && stops.size() == 2 && (i == 0 || !stops[0].side)) {
        // Round two wheels it goes the way in which the first turns about its axis.
        const bool alike = i == 0 || dot(plain(e), plain(*stops[0].axis)) > 0;
        stop.sense = alike != (i == 1 && crossed) ? -1 : 1;
        continue;
      }
      const bool end = !closed_ && (i == 0 || i + 1 == stops.size());
      if (closed_ && stops.size() == 2) {
        stop.sense = ((dot(plain(e), plain(*stops[0].axis)) > 0) != crossed ? 1 : -1) * stops[0].sense;
        continue;
      }
      const Vector leaves = end ? comes : Vector(behind(i).center - C);
      if (std::abs(dot(plain(e), cross(normalized(plain(comes)), normalized(plain(leaves))))) < slight)
        refuse(stop.mark,
               end ? "does not say on which side of '" + stop.name + "' it winds"
                   : "may pass '" + stop.name + "' on either side",
               "write " + stop.name + ": {side: +x}, the side of the center on which the cord " +
                   (i == 0 ? "leaves it" : "comes to it"));
      stop.sense = decided_negative(dot(e, cross(comes, leaves))) ? 1 : -1;
    }
  }

  void find_spans() {
    for (std::size_t i = 0; i < span_count(); ++i) {
      const Stop &a = stops[i], &b = behind(i);
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
      lines.push_back(line_between<Scalar>(a.center, b.center, e, span.from.reach, span.to.reach));
      require_in_plane(draft_, lines.back().along, mark_, words_);
      spans.push_back(std::move(span));
    }
    for (std::size_t i = closed_ ? 0 : 1; i < span_count(); ++i)
      find_turn(stops[i], lines[(i + lines.size() - 1) % lines.size()].along, lines[i].along, spans[i]);
  }

  // By how much a cord turns at a stop from one straight part to the next.
  void find_turn(Stop& stop, const Vector& comes, const Vector& leaves, CordSpan<Scalar>& span) const {
    if (!stop.is_wheel() && !stop.rubbing) return;
    const Vector turn = cross(comes, leaves);
    span.turn_cosine = dot(comes, leaves);
    span.turn_sine = stop.is_wheel()                ? dot(span.axis.vector, turn)
                     : norm(plain(turn)) > as_drawn ? norm(turn)
                                                    : Scalar(0);
    const Scalar sine = sine_on(span);
    // By how far it lies on the wheel, of which -90 deg to 0 is nearly all of it: a side that was not meant.
    const double on_wheel = std::atan2(plain(sine), plain(span.turn_cosine));
    if (stop.is_wheel() && !stop.side && !stop.turns && on_wheel <= 0 && on_wheel > -std::numbers::pi / 2)
      refuse(stop.mark, "may pass '" + stop.name + "' on either side",
             "write " + stop.name + ": {side: +x}, the side of the center on which the cord comes to it");
    if (stop.rubbing) find_wrap(stop, std::abs(on_wheel) > as_drawn ? angle_of(sine, span.turn_cosine) : Scalar(0));
  }

  // Of the angle by which the cord lies on the wheel before a straight part, turning as it goes round that.
  static Scalar sine_on(const CordSpan<Scalar>& span) {
    return plain(span.from.reach) > 0 ? Scalar(-span.turn_sine) : span.turn_sine;
  }
  static Scalar angle_on(const CordSpan<Scalar>& span) {
    const Scalar angle = angle_of(sine_on(span), span.turn_cosine);
    return decided_negative(angle) ? Scalar(angle + Scalar(2) * pi_value<Scalar>()) : angle;
  }

  // Between -pi and pi, by letters of angles where that is such a one.
  static Scalar angle_of(const Scalar& sine, const Scalar& cosine) {
    using std::atan2;
    if constexpr (std::is_same_v<Scalar, Formula>)
      if (const std::optional<Formula> letters = letters_of_angle(sine, cosine)) return *letters;
    return atan2(sine, cosine);
  }

  // The angle round a wheel of which the figure shows all but whole turns.
  void find_wrap(Stop& stop, const Scalar& shown_of_it) const {
    constexpr double full = 2 * std::numbers::pi;
    const Scalar full_turn = Scalar(2) * pi_value<Scalar>();
    stop.wrap = decided_negative(shown_of_it) ? shown_of_it + full_turn : shown_of_it;
    if (!stop.turns) return;
    // Whole turns more or less than what the figure shows of it.
    constexpr double as_stated = 0.02;
    const double stated = plain(*stop.turns), shown = plain(stop.wrap) / full, off = std::remainder(stated - shown, 1);
    if (std::abs(off) > as_stated && !draft_.options.lenient)
      refuse(stop.mark,
             "goes round '" + stop.name + "' by " + with_digits(stated, 4) + " turns, and as drawn by " +
                 with_digits(shown, 3) + ", or whole turns more",
             "correct the points, its side or turns:");
    stop.wrap = full_turn * *stop.turns;
  }

  const Stop& before(std::size_t i) const { return stops[(i + stops.size() - 1) % stops.size()]; }

  // A sine: a cord that turns at a wheel by less does not tell the side, as its data may have few digits.
  static constexpr double slight = 1e-3;

  MachineDraft<Scalar>& draft_;
  const std::string words_;
  const Mark& mark_;
  const bool closed_;
};

}  // namespace poinsot::problem
