// The units the language knows, and the common wrong words for them.
#pragma once

#include <span>
#include <string_view>

#include "problem/language/dimension.h"

namespace poinsot::problem {

// In m/s^2, by definition: it makes a force of the pound, and is g where a file says nothing of it.
inline constexpr std::string_view standard_gravity_digits = "9.80665";

struct NamedUnit {
  std::string_view name;
  double factor;  // one of it in SI base units and radians
  Dimension dimension;
  bool customary = false;  // whether it belongs to the US customary system
};

std::span<const NamedUnit> unit_table();
const NamedUnit* find_unit(std::string_view name);

// A word used for a unit that the language does not have: what is wrong with it, and what to write instead.
struct WrongUnit {
  std::string_view word;
  std::string_view message;  // "" if `word` is only another spelling of `repair`
  std::string_view repair;
};

// Looks a word up as it is written, then in lower case.
const WrongUnit* find_wrong_unit(std::string_view word);

}  // namespace poinsot::problem
