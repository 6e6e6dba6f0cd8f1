// The table of joints: every kind holds what it does not leave free, in the tree and where it closes a loop.
#include "problem/keys/joint_kinds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "problem/keys/keys.h"
#include "problem/machine/data.h"
#include "problem/machine/machine.h"

namespace poinsot::problem {
namespace joint_kinds_test {

std::string stated(const JointKind& kind) {
  const std::string key(kind.name);
  const bool pitch = kind.advances;
  std::string place = "k";
  if (kind.given == JointGiven::point) place = "P";
  if (kind.given == JointGiven::two_axes) place = "[k, u]";
  return "{" + key + ": " + place + (kind.given == JointGiven::point ? "" : ", at: P") +
         (pitch ? ", pitch: 2 mm/rev" : "") + ", ";
}

Machine built(const std::string& joints) {
  static Statement statement;
  statement = read_statement(
      "title: t\npoints: {P: [1 m, 2 m, 3 m], Q: [0, 1 m, 0]}\ndirections: {k: [1, 2, 2], u: [0, 1, 3]}\n"
      "bodies: {one: {rod: [P, Q], mass: 1 kg}, other: {rod: [P, Q], mass: 2 kg}}\njoints: {" +
          joints + "}\n",
      "test.yaml");
  static const Settings none;
  DataScope<double> data(statement.situations[0], none);
  DataScope<TimeJet> timed(statement.situations[0], none);
  return build_machine(
      statement.situations[0], data, timed, [](const Dimension&) { return 0.0; }, MachineOptions{});
}

std::size_t freedoms_of(const JointKind& kind) { return kind.freedoms.size() + (kind.any_turning ? 3 : 0); }

TEST(JointKinds, EveryKindIsAKeyOfTheLanguage) {
  const std::vector<std::string> keys = keys_of("joint");
  for (const JointKind& kind : joint_kinds()) EXPECT_NE(std::ranges::find(keys, kind.name), keys.end()) << kind.name;
}

TEST(JointKinds, ForcesAndFreedomsAreSixTogether) {
  for (const JointKind& kind : joint_kinds()) {
    const Machine machine = built("held: " + stated(kind) + "to: one}");
    EXPECT_EQ(machine.mechanism.components.size() + freedoms_of(kind), 6U) << kind.name;
    // Six more for the other body, which is free.
    EXPECT_EQ(static_cast<std::size_t>(machine.mechanism.tree.velocity_size()), freedoms_of(kind) + 6) << kind.name;
  }
}

TEST(JointKinds, WhatAKindHoldsDoesNoWorkOnItsFreedoms) {
  for (const JointKind& kind : joint_kinds()) {
    Machine machine = built("held: " + stated(kind) + "to: one}");
    solve::MechanismState state(machine.mechanism);
    state.set_positions(machine.q);
    const int n = machine.mechanism.tree.velocity_size();
    int looked = 0;
    for (int k = 0; k < n; ++k) {
      std::vector<double> v(static_cast<std::size_t>(n), 0.0);
      v[static_cast<std::size_t>(k)] = 1;
      state.set_velocities(v);
      for (const Component<double>& component : machine.mechanism.components) {
        const SpatialForce<double> wrench = state.component_wrench(component);
        const int body = machine.index.at("one");
        const Vector3<double> w = angular_velocity(state.workspace(), body);
        const Vector3<double> p = state.workspace().motion[static_cast<std::size_t>(body + 1)].p;
        const Vector3<double> v_origin = state.workspace().motion[static_cast<std::size_t>(body + 1)].v - cross(w, p);
        EXPECT_NEAR(dot(wrench.force, v_origin) + dot(wrench.moment, w), 0, 1e-12) << kind.name << " " << k;
        ++looked;
      }
    }
    EXPECT_GT(looked, 0) << kind.name;
  }
}

TEST(JointKinds, InALoopConstraintsTakeThePlaceOfForces) {
  for (const JointKind& kind : joint_kinds()) {
    if (kind.advances) continue;
    const Machine machine = built(
        "first: {weld: Q, to: one}, second: {weld: Q, from: one, to: other}, held: " + stated(kind) + "to: other}");
    // A joint that turns about two axes brings a link, which turns about the first, and one constraint more for it.
    const auto links = static_cast<std::size_t>(machine.mechanism.tree.velocity_size());
    EXPECT_EQ(machine.mechanism.constraints.size() - links + freedoms_of(kind), 6U) << kind.name;
    EXPECT_EQ(links, kind.name == "universal" ? 1U : 0U);
  }
}

}  // namespace joint_kinds_test
}  // namespace poinsot::problem
