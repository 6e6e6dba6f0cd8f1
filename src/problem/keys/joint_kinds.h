// The kinds of joints and of their supports, a row each: what the language calls a kind, how its joints move, and how a
// worked solution puts it. All that depends on a kind is asked of its row. What a joint carries is not said: it follows
// from how the joint moves (machine_joints.cpp).
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace poinsot::problem {

// What the key of a kind gives.
enum class JointGiven {
  point,
  axis,       // with a point on it
  direction,  // without a place
  normal,     // with a point
  two_axes    // through one point, not parallel
};

// The direction along or about which a freedom moves.
enum class FreedomAxis {
  main,         // the axis, direction or normal that the key gives
  across,       // across the normal, and in the plane
  across_both,  // across these two
  first,
  second,  // of two axes
};

struct FreedomOfKind {
  std::string_view name;  // "" for the only freedom of its joint
  bool turning = true;    // whether it is an angle; else it is a displacement
  FreedomAxis axis = FreedomAxis::main;
};

// The parts of the sentence about a joint, as Markdown: the body held and the one that holds, the place that its key
// gives, and " through P" if it has a point of its own.
struct JointWords {
  std::string to, from, place, through;
};

// In which ways a joint of several freedoms slips on one surface, so that one friction is against them all together.
enum class CommonSlip {
  none,
  turning,          // of a ball in its socket, about any axis
  along_plane,      // of two slides
  along_and_round,  // of a sleeve on its post
};

struct JointKind {
  std::string name;  // its key
  JointGiven given = JointGiven::point;
  // From `from` to `to`: each moves along an axis that the freedoms before it carry.
  std::vector<FreedomOfKind> freedoms;
  std::string (*words)(const JointWords&) = nullptr;
  bool any_turning = false;  // whether it turns about its point in any way, or by angles that the author orders
  bool advances = false;     // whether turning moves it along its axis, by a pitch
  CommonSlip common_slip = CommonSlip::none;

  bool slides() const;
};

struct SupportKind {
  std::string name;
  bool across_only = false;  // whether it carries no force along the axis of its joint
  bool couples = false;      // whether it carries couples across the axis
  bool needs_no_axis = false;
};

std::span<const JointKind> joint_kinds();
std::span<const SupportKind> support_kinds();

}  // namespace poinsot::problem
