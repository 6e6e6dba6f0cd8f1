// MechanismDynamics allocates nothing once it is made: every call of operator new in this program is counted.
#include <gtest/gtest.h>

#include "allocation_counter.h"
#include "engine/motion/mechanism/sample_mechanisms.h"

namespace poinsot {
namespace mechanism_allocation_test {

TEST(MechanismAllocation, NoCallOfTheMotionAllocates) {
  if (!counts_allocations) GTEST_SKIP() << "the sanitizer allocates in its own way";
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

}  // namespace mechanism_allocation_test
}  // namespace poinsot
