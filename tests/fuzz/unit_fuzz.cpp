// Any text as a unit: a unit that reads back, or a UnitError with an offset in the text.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "problem/language/units.h"

using namespace poinsot::problem;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  try {
    const Unit unit = parse_unit(text);
    if (!(unit.factor > 0) || !std::isfinite(unit.factor) || unit.text != text) std::abort();
    UnitHabits habits;
    habits.note(unit);
    for (const bool energy : {false, true}) {
      const Unit answer = habits.unit_for(unit.dimension, energy);
      if (!same_kind(answer.dimension, unit.dimension) || !(answer.factor > 0)) std::abort();
      if (!answer.text.empty() && !same_kind(parse_unit(answer.text).dimension, unit.dimension)) std::abort();
      const Unit si = si_unit(unit.dimension, energy);
      if (!si.text.empty() && std::abs(parse_unit(si.text).factor - 1) > 1e-12) std::abort();
    }
  } catch (const UnitError& error) {
    if (error.message.empty() || error.offset > size) std::abort();
  }
  return 0;
}
