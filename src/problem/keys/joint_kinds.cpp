#include "problem/keys/joint_kinds.h"

#include <algorithm>

namespace poinsot::problem {
namespace {

// "holds *A* on *B* by a universal joint at P".
std::string held_by(const JointWords& w, const std::string& what) {
  return "holds " + w.to + " on " + w.from + " by " + what + " at " + w.place + w.through;
}

}  // namespace

bool JointKind::slides() const { return advances || !std::ranges::all_of(freedoms, &FreedomOfKind::turning); }

std::span<const JointKind> joint_kinds() {
  static const std::vector<JointKind> rows{
      {"weld",
       JointGiven::point,
       {},
       [](const JointWords& w) { return "fixes " + w.to + " to " + w.from + " at " + w.place; }},
      {"revolute",
       JointGiven::axis,
       {{"", true}},
       [](const JointWords& w) {
         return "lets " + w.to + " turn on " + w.from + " about the axis " + w.place + w.through;
       }},
      {"prismatic",
       JointGiven::direction,
       {{"", false}},
       [](const JointWords& w) { return "lets " + w.to + " slide on " + w.from + " along " + w.place; }},
      {"cylindrical",
       JointGiven::axis,
       {{"turn", true}, {"slide", false}},
       [](const JointWords& w) { return held_by(w, "a cylindrical joint"); },
       false,
       false,
       CommonSlip::along_and_round},
      {"universal",
       JointGiven::two_axes,
       {{"first", true, FreedomAxis::first}, {"second", true, FreedomAxis::second}},
       [](const JointWords& w) { return held_by(w, "a universal joint"); }},
      {"ball",
       JointGiven::point,
       {},
       [](const JointWords& w) { return "holds " + w.to + " on " + w.from + " by a ball and socket at " + w.place; },
       true,
       false,
       CommonSlip::turning},
      {"planar",
       JointGiven::normal,
       {{"slide1", false, FreedomAxis::across}, {"slide2", false, FreedomAxis::across_both}, {"turn", true}},
       [](const JointWords& w) { return held_by(w, "a planar joint"); },
       false,
       false,
       CommonSlip::along_plane},
      {"screw", JointGiven::axis, {{"", true}}, [](const JointWords& w) { return held_by(w, "a screw"); }, false, true},
      {"slot",
       JointGiven::two_axes,
       {{"slide", false, FreedomAxis::first}, {"turn", true, FreedomAxis::second}},
       [](const JointWords& w) {
         return "holds " + w.to + " by a pin in a slot of " + w.from + ", slot and pin along " + w.place + w.through;
       }},
  };
  return rows;
}

std::span<const SupportKind> support_kinds() {
  static const std::vector<SupportKind> rows{
      {"journal", true, false}, {"thrust", false, false}, {"collar", true, true},       {"hinge", false, true},
      {"fork", false, true},    {"clevis", false, true},  {"ball", false, false, true},
  };
  return rows;
}

}  // namespace poinsot::problem
