// MechanismDynamics allocates nothing once it is made: every call of operator new in this program is counted. A
// sanitizer brings an operator new of its own, so that only builds without one count.
#include <gtest/gtest.h>

#include <cstdlib>
#include <new>

#include "motion/sample_mechanisms.h"

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)

TEST(MechanismAllocation, NoCallOfTheMotionAllocates) { GTEST_SKIP() << "the sanitizer allocates in its own way"; }

#else

namespace {

long allocations = 0;

void* counted(std::size_t size, std::size_t alignment) {
  ++allocations;
  void* memory = std::aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment);
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}

}  // namespace

// Inlined, g++ sees free() on what came from the operator new below and takes the pair for a mismatch.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wmismatched-new-delete"
#endif

void* operator new(std::size_t size) { return counted(size, alignof(std::max_align_t)); }
void* operator new(std::size_t size, std::align_val_t alignment) {
  return counted(size, static_cast<std::size_t>(alignment));
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }

namespace poinsot {
namespace {

TEST(MechanismAllocation, NoCallOfTheMotionAllocates) {
  for (const testing::SampleMechanism& sample : testing::sample_mechanisms()) {
    SCOPED_TRACE(sample.name);
    MechanismDynamics dynamics(sample.mechanism);
    State<double> state = sample.state;
    std::vector<double> a(state.v.size());
    double sum = 0;
    const auto use = [&] {
      for (const int k : dynamics.held_coordinates()) dynamics.set_held_acceleration(k, 0.5);
      if (!dynamics.mechanism().forces.empty()) dynamics.set_force(0, {1, 2, 3});
      if (!dynamics.mechanism().constraints.empty()) {
        const int action = dynamics.mechanism().constraints[0].action;
        if (action >= 0) {
          dynamics.set_acting(action, false);
          dynamics.accelerations(state.q, state.v, a);
          dynamics.set_acting(action, true);
        }
        sum += dynamics.gap(0, state.q) + dynamics.gap_rate(0, state.q, state.v);
      }
      sum += dynamics.project(state.q, state.v);
      dynamics.accelerations(state.q, state.v, a);
      for (std::size_t j = 0; j < dynamics.mechanism().components.size(); ++j) sum += dynamics.component_force(j);
      sum += dynamics.constraint_misfit() + dynamics.power() + dynamics.largest_gap(state.q) +
             dynamics.largest_rate(state.q, state.v) + dynamics.kinetic_energy(state.q, state.v) +
             dynamics.potential_energy(state.q);
    };
    const long before = allocations;
    use();
    const long after = allocations;
    EXPECT_EQ(after, before);
    EXPECT_TRUE(std::isfinite(sum));
    // The counter counts.
    const MechanismDynamics another(sample.mechanism);
    EXPECT_GT(allocations, after);
  }
}

}  // namespace
}  // namespace poinsot

#endif
