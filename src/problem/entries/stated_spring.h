// A spring or damper as a statement says it: between two points (`at`, `end`), or a torsional one about an axis
// (`about`).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "problem/entries/stated_law.h"

namespace poinsot::problem {

struct Spring {
  static constexpr const char* list = "springs";
  static constexpr bool may_follow_time = false;

  std::string name, from, to;
  Mark from_mark, to_mark;
  std::optional<Expression> at, end, about;
  std::optional<Expression> stiffness, free_length, free_angle, tension, damping;
  Mark mark;

  static Spring read(const Key& name, const Entry& entry, const std::string& file);
  std::vector<LawBody> bodies() const { return {{from, from_mark, true}, {to, to_mark}}; }
  std::string words(const WrittenExpression& written) const;

  template <class Visit>
  void for_each_part(const Visit& visit) const {
    visit(LawPart::place, at);
    visit(LawPart::place, end);
    visit(LawPart::direction, about);
    visit(LawPart::resistance, stiffness);
    visit(LawPart::extent, free_length);
    visit(LawPart::angle, free_angle);
    visit(LawPart::effort, tension);
    visit(LawPart::resistance, damping);
  }
};
static_assert(StatedLaw<Spring>);

}  // namespace poinsot::problem
