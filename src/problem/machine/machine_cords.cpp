// The cords of a machine: straight ones, long ones, and those that are led over wheels.
//
// A cord over wheels is a row of straight parts between what it touches (engine/dynamics/cord_span.h). Over a smooth
// wheel or through an eyelet it slides: the parts on both sides pull with one force, and grow by nothing together. On
// a wheel that turns it does not slip, so that each side has a force of its own. Where there is friction it does the
// one or the other, and as it slips one force is a part of the other (engine/dynamics/capstan.h).
//
// A cord that is longer than drawn is slack at the start. As a contact that is open then it exerts no force at an
// instant, and along a motion it is there: it goes taut where its ends are as far apart as it is long.
#include "problem/machine/led_cord.h"

namespace poinsot::problem {

namespace {

// By how much a cord is longer than it is drawn: zero where its length is not stated, or is that of the figure.
template <class Scalar>
Scalar beyond_figure(const MachineDraft<Scalar>& draft, const Cord& cord, const Scalar& drawn) {
  if (!cord.length) return Scalar(0);
  const Scalar length = draft.data.number(*cord.length, dimensions::length);
  Scalar more = length - drawn;
  constexpr double as_long = 1e-9;  // of its length: places computed from the data have the rounding of some steps
  if (vanishes(more) || std::abs(plain(more)) <= as_long * plain(drawn)) return Scalar(0);
  if (!decided_negative(more)) return more;
  // Values that are tried for unknowns may make it too short.
  if (draft.options.lenient) return Scalar(0);
  fail(draft.situation.file, cord.length->mark(),
       "cord '" + cord.name + "' is " + with_digits(plain(length), 6) + " m long and drawn over " +
           with_digits(plain(drawn), 6) + " m",
       "correct its length or the points; a cord that is taut at the start needs no length:");
}

template <class Scalar>
class LedCord {
 public:
  LedCord(MachineDraft<Scalar>& draft, const Cord& cord)
      : draft_(draft), cord_(cord), way_(draft, "cord '" + cord.name + "'", cord.mark, false) {}

  void add() {
    if (cord_.off_from)
      way_.add_wheel(*cord_.off_from, nullptr);
    else
      way_.add_end(cord_.from, *cord_.at);
    for (const CordWheel& wheel : cord_.over) way_.add_wheel(wheel, rubbing_on(draft_.situation, cord_.name, wheel));
    if (cord_.on_to)
      way_.add_wheel(*cord_.on_to, nullptr);
    else
      way_.add_end(cord_.to, *cord_.end);
    for (const auto& [wheel, stop] :
         {std::pair{&cord_.off_from, &way_.stops.front()}, std::pair{&cord_.on_to, &way_.stops.back()}})
      if (*wheel && !stop->is_wheel())
        way_.refuse((*wheel)->mark, "winds on '" + stop->name + "', which is no wheel there",
                    "state its radius, or the point to which the cord is tied");
    way_.find_way();
    if (cord_.length) longer_ = beyond_figure(draft_, cord_, way_.length());
    if (cord_.length) require_sliding();
    if (!vanishes(longer_) && !draft_.options.open_contacts) {
      for (std::size_t i = 0; i < way_.spans.size(); ++i) way_.add_part(cord_.name, i);
      return;
    }
    add_parts();
  }

 private:
  // What is slack slips over the wheels that it turns, and how far is not known.
  void require_sliding() const {
    for (std::size_t i = 1; i + 1 < way_.stops.size(); ++i) {
      const CordStop<Scalar>& stop = way_.stops[i];
      if (stop.slides && !stop.rubbing) continue;
      way_.refuse(stop.mark,
                  std::string(stop.rubbing ? "has friction on '" : "turns '") + stop.name +
                      "' and states its length: what it does slack is not followed there",
                  "remove length:, or write " + stop.name + ": {smooth: true}");
    }
  }

  void add_parts() {
    Mechanism<Scalar>& mechanism = draft_.machine.mechanism;
    // Where each row of parts whose tensions go together begins.
    std::vector<std::size_t> begins{0};
    std::vector<int> actions;
    int leader = -1;
    for (std::size_t i = 0; i < way_.spans.size(); ++i) {
      const CordStop<Scalar>& stop = way_.stops[i];
      const bool own = i == 0 || !stop.slides;
      if (i > 0 && own) begins.push_back(i);
      actions.push_back(way_.add_part(cord_.name, i));
      const Scalar gain =
          stop.rubbing ? way_.add_rubbing(i, actions[i - 1], actions[i],
                                          {way_.spans.begin() + static_cast<std::ptrdiff_t>(i), way_.spans.end()})
                       : Scalar(0);
      Component<Scalar>& pull = way_.add_pull(actions[i], i);
      if (own) {
        pull.one_sided = true;
        leader = static_cast<int>(mechanism.components.size()) - 1;
        continue;
      }
      pull.follows = leader;
      pull.part = i > begins.back() + 1 ? mechanism.components[mechanism.components.size() - 2].part : Scalar(1);
      if (vanishes(gain)) continue;
      pull.gain = gain;
      pull.wrap = stop.wrap;
      pull.part *= plain(gain) > 0 ? capstan_ratio(Scalar(gain * stop.wrap))
                                   : Scalar(1) / capstan_ratio(Scalar(-gain * stop.wrap));
    }
    begins.push_back(way_.spans.size());
    const bool keeps = !cord_.off_from && !cord_.on_to;
    for (std::size_t run = 0; run + 1 < begins.size(); ++run) {
      // Where the whole length is kept, that and all parts but the first tell the same as all parts.
      const bool whole = keeps && run == 0;
      const std::size_t first = begins[run], last = whole ? way_.spans.size() : begins[run + 1];
      VelocityConstraint<Scalar>& taut =
          way_.add_tautness(actions[first], first, last - first,
                            "cord '" + cord_.name + "' taut" +
                                (whole || begins.size() == 2
                                     ? std::string()
                                     : " from '" + way_.stops[first].name + "' to '" + way_.stops[last].name + "'"));
      taut.keeps_length = whole;
      for (std::size_t i = first; whole && i < last; ++i) taut.length += way_.lines[i].length;
      if (whole) taut.length += longer_;
    }
  }

  MachineDraft<Scalar>& draft_;
  const Cord& cord_;
  CordWay<Scalar> way_;
  Scalar longer_{};  // than drawn
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
  const Scalar drawn = norm(end - start), longer = beyond_figure(draft, cord, drawn);
  if (!vanishes(longer) && !draft.options.open_contacts) return;
  const Vector3<Scalar> inward = normalized(start - end);
  Component<Scalar>& pull = draft.add_component(action, "", false, at, {ground, inward});
  pull.toward = draft.machine.place(from, start);
  pull.one_sided = true;
  VelocityConstraint<Scalar>& taut =
      draft.add_constraint(VelocityConstraintKind::cord_length, "cord '" + cord.name + "' taut", on, from, at, inward);
  taut.toward = draft.machine.place(from, start);
  taut.length = drawn + longer;
  taut.action = action;
}

template void add_cord(MachineDraft<double>&, const Cord&);
template void add_cord(MachineDraft<Dual<1>>&, const Cord&);
template void add_cord(MachineDraft<Formula>&, const Cord&);

}  // namespace poinsot::problem
