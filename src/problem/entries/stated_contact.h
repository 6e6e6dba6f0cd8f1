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

// The coefficients of dry friction of a contact at rest and of one that slides.
struct Friction {
  Expression resting, sliding;
  Mark mark;

  // Whether it may be less while it slides.
  bool falls() const { return to_string(resting) != to_string(sliding); }
};

struct Contact {
  std::string name, of, against;
  Mark of_mark, against_mark;
  Expression at, normal;
  std::string inside{};  // the body among them whose hollow side touches; empty if none
  Mark inside_mark{};
  bool no_slip = false;
  std::vector<Expression> no_slip_along{};  // of a knife edge: only these directions, which turn with `of`
  std::optional<Friction> friction{};
  Grip grip = Grip::unknown;
  std::optional<Expression> slip{};                // if it slides: the direction in which `of` slides over `against`
  bool from_rest = false;                          // if it slides: whether it only begins to
  bool open = false;                               // whether it does not touch at the start
  std::optional<Expression> surface{};             // if so: a point of the surface on `against`; `at` when left out
  std::optional<Expression> restitution{};         // of blows that come later
  std::optional<Expression> blow_friction{};       // the same, its coefficient of friction
  bool slip_turns = false;                         // whether the direction of the slip is that of each instant
  std::optional<std::vector<Expression>> carries;  // directions, or the word "push" for the normal
  // Whether it is no contact but the friction in the joint of this name, of `of` on `against`.
  bool in_joint = false;
  Mark mark;

  // Whether what meets there later rebounds, or is struck with friction.
  bool strikes_later() const { return open || restitution.has_value(); }
  // "contact 'floor'", "joint 'pin'".
  std::string words() const { return std::string(in_joint ? "joint" : "contact") + " '" + name + "'"; }
  // Whether it begins to slide with less friction than at rest, so that it must have left its limit at rest.
  bool leaves_limit() const { return from_rest && friction && friction->falls(); }
};

}  // namespace poinsot::problem
