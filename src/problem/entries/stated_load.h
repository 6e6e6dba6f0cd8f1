// A load as a statement says it: a force or couple on a body, of given size and direction.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "problem/entries/stated_law.h"

namespace poinsot::problem {

struct Load {
  static constexpr const char* list = "loads";
  static constexpr bool may_follow_time = true;

  std::string name, body, axes;
  Mark body_mark, axes_mark;
  std::optional<Expression> force, couple, direction, at;
  Mark mark;

  static Load read(const Key& name, const Entry& entry, const std::string& file);
  std::vector<LawBody> bodies() const { return {{body, body_mark}, {axes, axes_mark, true}}; }
  std::string words(const WrittenExpression& written) const;

  template <class Visit>
  void for_each_part(const Visit& visit) const {
    visit(LawPart::effort, force);
    visit(LawPart::effort, couple);
    visit(LawPart::place, at);
    visit(LawPart::direction, direction);
  }
};
static_assert(StatedLaw<Load>);

}  // namespace poinsot::problem
