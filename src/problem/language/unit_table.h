// The units the language knows, and the common wrong words for them.
#pragma once

#include <span>
#include <string_view>

#include "problem/language/dimension.h"

namespace poinsot::problem {

struct NamedUnit {
  std::string_view name;
  double factor;  // in SI base units, radians
  Dimension dimension;
  bool customary = false;  // of the US customary system
};

std::span<const NamedUnit> unit_table();
const NamedUnit* find_unit(std::string_view name);

// A word written for a unit that the language does not have: what is wrong, what to write instead.
struct WrongUnit {
  std::string_view word;
  std::string_view message;  // "" for a mere other spelling of `repair`
  std::string_view repair;
};

// Compared as written first, then in lower case.
const WrongUnit* find_wrong_unit(std::string_view word);

}  // namespace poinsot::problem
