// Belts and chains: closed cords round wheels.
//
// A belt slips nowhere, so that the wheels' rates go as their radii do, and each of its sides between two wheels that
// it turns has a tension T_k of its own. It is a little elastic: as long as the wheels keep their places the lengths of
// the strained sides together stay what they are, so that with the initial tension T_0
//
//   sum L_k T_k = T_0 sum L_k,
//
// L_k the length of side k: for two wheels T_1 + T_2 = 2 T_0. (What lies on the wheels is left out, where the tension
// goes over from one to the other.) So all sides but the last have unknown tensions, the last has what is left of the
// sum, and as many conditions hold. A belt without initial tension, and a chain, is a closed cord of one length, every
// side of which has a tension of its own; where the wheels keep their places these are open by an equal amount each,
// of which a chain has none: its slackest side has no tension.
#include "problem/machine/led_cord.h"

namespace poinsot::problem {
namespace {

template <class Scalar>
class ClosedCord {
 public:
  ClosedCord(MachineDraft<Scalar>& draft, const Belt& belt)
      : draft_(draft), belt_(belt), way_(draft, belt.words(), belt.mark, true) {}

  void add() {
    for (const CordWheel& wheel : wheels_in_order())
      way_.add_wheel(wheel, rubbing_on(draft_.situation, belt_.name, wheel));
    const std::size_t first = first_that_turns();
    // The way is told before the wheels are put in another order: it is the one of the statement.
    way_.find_way(belt_.crossed);
    check_crossing();
    rotate(first);
    add_sides();
    add_rubbings();
  }

 private:
  const std::vector<CordWheel>& wheels_in_order() const { return belt_.over; }

  // By the straight parts as drawn: round two wheels a crossed belt goes from one side of the line of centers to the
  // other, and an open one does not. Where sides are stated these tell it.
  void check_crossing() const {
    const auto has_side = [](const CordWheel& wheel) { return wheel.side.has_value(); };
    if (way_.stops.size() != 2 || (!belt_.crossed && std::ranges::any_of(belt_.over, has_side))) return;
    const Vector3<double> C = plain(way_.stops[0].center), D = plain(way_.stops[1].center) - C;
    const auto side = [&](const Vector3<Scalar>& point) { return cross(D, Vector3<double>(plain(point) - C)); };
    for (const SpanLine<Scalar>& line : way_.lines)
      if ((dot(side(line.start), side(line.end)) < 0) != belt_.crossed)
        way_.refuse(belt_.mark,
                    belt_.crossed ? "is crossed, and as drawn it is open" : "is open, and as drawn it is crossed",
                    "correct the sides of its wheels, or crossed:");
  }

  // Sides begin at wheels that the belt turns.
  std::size_t first_that_turns() const {
    std::size_t first = way_.stops.size(), turning = 0;
    std::string carrier;
    for (std::size_t i = 0; i < way_.stops.size(); ++i) {
      const CordStop<Scalar>& stop = way_.stops[i];
      if (!stop.is_wheel())
        way_.refuse(stop.mark, "goes round '" + stop.name + "', which is no wheel there", "state its radius");
      if (stop.slides) continue;
      ++turning;
      first = std::min(first, i);
    }
    for (const CordStop<Scalar>& stop : way_.stops) {
      if (belt_.tension && stop.body != ground && stop.carrier.empty())
        way_.refuse(
            belt_.tension->mark(),
            "has an initial tension, and the center of '" + stop.name + "' is held by no joint in which it turns",
            "let it turn on the same body as the other wheels, by a revolute joint");
      const std::string own = stop.body == ground ? "ground" : stop.carrier;
      if (belt_.tension && !carrier.empty() && own != carrier)
        way_.refuse(
            belt_.tension->mark(),
            "has an initial tension, and '" + stop.name + "' is carried by '" + own + "', another wheel by '" +
                carrier + "'",
            "where a wheel can move its load tells the tension: leave out tension:, or let all wheels turn on one "
            "body");
      carrier = own;
    }
    if (turning < 2)
      way_.refuse(belt_.mark, "turns fewer than two wheels",
                  "let two or more of them turn about axes, by revolute joints, and none of these be smooth");
    return first;
  }

  void rotate(std::size_t first) {
    const auto turn = [&](auto& list) {
      std::rotate(list.begin(), list.begin() + static_cast<std::ptrdiff_t>(first), list.end());
    };
    turn(way_.stops);
    turn(way_.spans);
    turn(way_.lines);
  }

  void add_sides() {
    MachineOf<Scalar>& machine = draft_.machine;
    std::vector<std::size_t> begins;
    for (std::size_t i = 0; i < way_.spans.size(); ++i) {
      if (!way_.stops[i].slides) begins.push_back(i);
      actions_.push_back(way_.add_part(belt_.name, i));
      machine.belt_actions.push_back(actions_.back());
    }
    begins.push_back(way_.spans.size());
    const std::size_t sides = begins.size() - 1, last = sides - 1;
    std::vector<Scalar> length;
    Scalar whole(0);
    for (std::size_t side = 0; side < sides; ++side) {
      length.emplace_back(0);
      for (std::size_t i = begins[side]; i < begins[side + 1]; ++i) length.back() += way_.lines[i].length;
      whole += length.back();
    }
    std::vector<int> leaders;
    for (std::size_t side = 0; side < (belt_.tension ? last : sides); ++side) {
      const int leader = static_cast<int>(machine.mechanism.components.size());
      leaders.push_back(leader);
      const auto pull = [&](std::size_t of, const Scalar& part, const Scalar& offset) {
        for (std::size_t i = begins[of]; i < begins[of + 1]; ++i) {
          Component<Scalar>& one = way_.add_pull(actions_[i], i);
          if (static_cast<int>(machine.mechanism.components.size()) - 1 == leader) continue;
          one.follows = leader;
          one.part = part;
          one.offset = offset;
        }
      };
      pull(side, Scalar(1), Scalar(0));
      if (!belt_.tension) continue;
      const Scalar initial = draft_.data.number(*belt_.tension, dimensions::force);
      if (plain(initial) < 0 && !draft_.options.lenient)
        way_.refuse(belt_.tension->mark(), "has a negative initial tension", "belts pull: write one that is positive");
      pull(last, -length[side] / length[last], side == 0 ? initial * whole / length[last] : Scalar(0));
    }
    for (std::size_t side = 0; side < leaders.size(); ++side)
      way_.add_tautness(actions_[begins[side]], begins[side], begins[side + 1] - begins[side],
                        belt_.words() + " not slipping from '" + way_.stops[begins[side]].name + "' to '" +
                            way_.behind(begins[side + 1] - 1).name + "'");
    if (belt_.chain) machine.chains.push_back(leaders);
  }

  void add_rubbings() {
    // In the order of the statement, in which the states are told.
    for (const CordWheel& wheel : belt_.over) {
      if (!wheel.friction) continue;
      for (std::size_t i = 0; i < way_.stops.size(); ++i)
        if (way_.stops[i].rubbing && way_.stops[i].name == wheel.name)
          way_.add_rubbing(i, actions_[(i + actions_.size() - 1) % actions_.size()], actions_[i], {});
    }
  }

  MachineDraft<Scalar>& draft_;
  const Belt& belt_;
  CordWay<Scalar> way_;
  std::vector<int> actions_;
};

}  // namespace

template <class Scalar>
void add_belt(MachineDraft<Scalar>& draft, const Belt& belt) {
  ClosedCord<Scalar>(draft, belt).add();
}

template void add_belt(MachineDraft<double>&, const Belt&);
template void add_belt(MachineDraft<Dual<1>>&, const Belt&);
template void add_belt(MachineDraft<Formula>&, const Belt&);

}  // namespace poinsot::problem
