// Until when formulas are sought.
#pragma once

#include <chrono>

namespace poinsot::problem {

// By how much the address and thread sanitizers slow formulas down: what is found should not depend on them.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr double formula_slowdown = 8;
#else
inline constexpr double formula_slowdown = 1;
#endif

inline std::chrono::steady_clock::time_point formula_deadline(double seconds) {
  using Clock = std::chrono::steady_clock;
  return Clock::now() +
         std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(formula_slowdown * seconds));
}

}  // namespace poinsot::problem
