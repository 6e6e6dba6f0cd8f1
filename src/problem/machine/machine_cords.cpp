// The cords of a machine: straight ones, long ones, and those that are led over wheels.
//
// A cord over wheels is a row of straight parts between what it touches (engine/dynamics/cord_span.h). Over a smooth
// wheel or through an eyelet it slides: the parts on both sides pull with one force, and grow by nothing together. On
// a wheel that turns it does not slip, so that each side has a force of its own. Where there is friction it does the
// one or the other, and as it slips one force is a part of the other (engine/dynamics/capstan.h).
#include "problem/machine/led_cord.h"

namespace poinsot::problem {

namespace {

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
    add_parts();
  }

 private:
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
    }
  }

  MachineDraft<Scalar>& draft_;
  const Cord& cord_;
  CordWay<Scalar> way_;
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
