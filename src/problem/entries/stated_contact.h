// A contact as a statement says it, with the state that is found for one with dry friction.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "problem/language/diagnostic.h"
#include "problem/language/expression.h"

namespace poinsot::problem {

// How a contact with friction holds at an instant. The file does not say it: it is found for all of them together
// (answers/contact_states.h).
enum class Grip { unknown, sticks, slides, parts };

// Of friction in a joint that follows from what the joint carries: what presses, and at which radius.
struct Bearing {
  std::optional<Expression> radius{};         // of a journal, a ball or, in the mean, of a thread
  std::optional<Expression> thrust_radius{};  // at which a journal rests against its collar, in the mean
  std::optional<Expression> length{};         // between the two ends at which it bears
  std::optional<Expression> thread_angle{};   // between the flanks of a thread; square when left out
};

// The coefficients of dry friction of a contact at rest and of one that slides; in a joint without a bearing its
// couples or forces.
struct Friction {
  Expression resting, sliding;
  Mark mark;
  std::optional<Bearing> bearing{};

  // Whether it may be less while it slides.
  bool falls() const { return to_string(resting) != to_string(sliding); }
};

struct Contact {
  std::string name, of, against;
  Mark of_mark, against_mark;
  Expression at, normal;
  bool corner = false;   // whether the place is a point fixed in `of`, whatever is known of its shape
  std::string inside{};  // the body among them whose hollow side touches; empty if none
  Mark inside_mark{};
  bool no_slip = false;
  std::vector<Expression> no_slip_along{};  // of a knife edge: only these directions, which turn with `of`
  std::optional<Friction> friction{};
  Grip grip = Grip::unknown;
  std::optional<Expression> slip{};         // if it slides: the direction in which `of` slides over `against`
  bool from_rest = false;                   // if it slides: whether it only begins to
  bool open = false;                        // whether it does not touch at the start
  std::optional<Expression> surface{};      // if so: a point of the surface on `against`; `at` when left out
  std::optional<Expression> restitution{};  // of blows that come later
  // Whether it has friction and does not touch: from the start, or since it parted in a motion. Its state is `parts`
  // then, and is not sought until it is struck.
  bool flies = false;
  bool slip_turns = false;                         // whether the direction of the slip is that of each instant
  std::optional<std::vector<Expression>> carries;  // directions, or the word "push" for the normal
  // Whether it is no contact but the friction in the joint of this name, of `of` on `against`; or that of the cord or
  // belt `of` on what it is led over, `against`, and whether that is a belt's.
  bool in_joint = false, on_cord = false, of_belt = false;
  // Of friction in a joint: whether it is against its slip in all its ways together.
  bool all_ways = false;
  Mark mark;

  // Whether it has friction and touches, so that it sticks, slides or parts.
  bool rubs() const { return friction.has_value() && !flies; }
  // Whether it states what meets there later, and whether anything is known of that.
  bool strikes_later() const { return open || restitution.has_value(); }
  bool may_be_struck() const { return strikes_later() || (friction && touches()); }
  // Whether two bodies touch there.
  bool touches() const { return !in_joint && !on_cord; }
  // "contact 'floor'", "joint 'pin'", "cord 'rope on post'".
  std::string words() const {
    const char* const kind = in_joint ? "joint" : of_belt ? "belt" : on_cord ? "cord" : "contact";
    return std::string(kind) + " '" + name + "'";
  }
  // Whether it begins to slide with less friction than at rest, so that it must have left its limit at rest.
  bool leaves_limit() const { return from_rest && friction && friction->falls(); }
};

// Whether a call such as sticking(floor) or sticking(rope on post) is about the friction of this name; that of a cord
// on the only thing on which it has friction may be called by the cord alone.
inline bool is_about(const Call& call, const std::string& name) {
  const std::string first = to_string(call.arguments.front().value);
  const Expression* on = call.argument("on");
  return name == first || (on ? name == first + " on " + to_string(*on) : name.starts_with(first + " on "));
}

}  // namespace poinsot::problem
