// How many random cases a test tries.
#pragma once

namespace poinsot::testing {

// The sanitizers look for faults that any case may show, and take ten times as long: there a tenth of the cases.
constexpr int case_count(int cases) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  return (cases + 9) / 10;
#else
  return cases;
#endif
}

}  // namespace poinsot::testing
