// Models that say the same in other words move alike: shifted and turned body frames, reordered bodies, a body split
// and welded, a ball as three hinges, a screw without pitch, compounds.
#include <gtest/gtest.h>

#include "engine/dynamics/random_trees.h"
#include "poinsot/engine/dynamics/hybrid_dynamics.h"
#include "poinsot/engine/dynamics/inverse_dynamics.h"
#include "poinsot/engine/dynamics/kinematics.h"

namespace poinsot {
namespace equivalent_models_test {

using testing::Random;
using testing::relative_difference;
using testing::StatedBody;
using testing::StatedTree;

// The properties of a body on a frame whose pose in the old frame is X.
MassProperties<double> on_frame(const SpatialTransform<double>& X, const MassProperties<double>& mass) {
  return {mass.mass, transpose_times(X.R, mass.center - X.p), turned(transpose(X.R), mass.inertia_center)};
}

struct Solved {
  std::vector<double> acceleration;
  std::vector<double> force;
};
Solved hybrid(const Model<double>& model, const State<double>& state, std::vector<double> acceleration,
              std::vector<double> force) {
  Workspace<double> workspace(model);
  hybrid_dynamics<double>(model, workspace, state, acceleration, force);
  return {acceleration, force};
}

// A frame may be turned about the joint's own axis and shifted along it without changing the coordinates; turned in any
// way together with the axis. Children and masses follow.
TEST(EquivalentModels, turned_body_frames_change_nothing) {
  Random random(51);
  for (int trial = 0; trial < 300; ++trial) {
    testing::TreeOptions options;
    options.given_coordinates = true;
    const StatedTree tree = testing::random_tree(random, options);
    StatedTree turned_tree = tree;
    for (std::size_t i = 0; i < tree.bodies.size(); ++i) {
      StatedBody& body = turned_tree.bodies[i];
      if (body.joint.type == JointType::ball || body.joint.type == JointType::free) continue;
      const SpatialTransform<double> X{random.rotation(), Vector3<double>::zero()};
      body.placement = body.placement * X;
      body.joint.axis = transpose_times(X.R, body.joint.axis);
      body.mass = on_frame(X, body.mass);
      for (StatedBody& child : turned_tree.bodies) {
        if (child.parent == static_cast<int>(i)) child.placement = inverse(X) * child.placement;
      }
    }
    const Model<double> model = testing::built(tree);
    const Model<double> turned_model = testing::built(turned_tree);
    const State<double> state = testing::random_state(random, model);
    const std::vector<double> acceleration = random.numbers(model.velocity_size(), 3.0);
    const std::vector<double> force = random.numbers(model.velocity_size(), 3.0);
    const Solved expected = hybrid(model, state, acceleration, force);
    const Solved found = hybrid(turned_model, state, acceleration, force);
    ASSERT_LT(relative_difference(found.acceleration, expected.acceleration), 1e-10) << "trial " << trial;
    ASSERT_LT(relative_difference(found.force, expected.force), 1e-10) << "trial " << trial;
  }
}

// Hinge frames shifted along the hinge's axis.
TEST(EquivalentModels, frames_shifted_along_their_axes_change_nothing) {
  Random random(52);
  for (int trial = 0; trial < 300; ++trial) {
    const StatedTree tree = testing::random_tree(random);
    StatedTree shifted_tree = tree;
    for (std::size_t i = 0; i < tree.bodies.size(); ++i) {
      StatedBody& body = shifted_tree.bodies[i];
      if (velocity_size(body.joint.type) != 1) continue;
      const SpatialTransform<double> X =
          SpatialTransform<double>::translation(random.uniform(-1.0, 1.0) * body.joint.axis);
      body.placement = body.placement * X;
      body.mass = on_frame(X, body.mass);
      for (StatedBody& child : shifted_tree.bodies) {
        if (child.parent == static_cast<int>(i)) child.placement = inverse(X) * child.placement;
      }
    }
    const Model<double> model = testing::built(tree);
    const Model<double> shifted_model = testing::built(shifted_tree);
    const State<double> state = testing::random_state(random, model);
    const std::vector<double> force = random.numbers(model.velocity_size(), 3.0);
    const Solved expected = hybrid(model, state, force, force);
    const Solved found = hybrid(shifted_model, state, force, force);
    ASSERT_LT(relative_difference(found.acceleration, expected.acceleration), 1e-10) << "trial " << trial;
  }
}

// Two arms on one base, added in either order.
TEST(EquivalentModels, order_of_the_bodies_changes_nothing) {
  Random random(53);
  for (int trial = 0; trial < 300; ++trial) {
    const MassProperties<double> base_mass = random.mass();
    const Joint<double> joints[2] = {Joint<double>::revolute(random.direction()),
                                     Joint<double>::screw(random.direction(), 0.3)};
    const SpatialTransform<double> places[2] = {random.pose(), random.pose()};
    const MassProperties<double> masses[2] = {random.mass(), random.mass()};
    const Vector3<double> gravity = random.vector(10.0);
    const auto model = [&](int first) {
      ModelBuilder<double> builder;
      builder.set_gravity(gravity);
      builder.add_body("base", ground, Joint<double>::free(), {}, base_mass);
      for (const int i : {first, 1 - first}) {
        builder.add_body("arm " + std::to_string(i), "base", joints[i], places[i], masses[i]);
      }
      return builder.build();
    };
    const Model<double> forwards = model(0);
    const Model<double> backwards = model(1);
    const State<double> state = testing::random_state(random, forwards);
    const std::vector<double> force = random.numbers(8, 3.0);
    const auto swapped = [](std::vector<double> x) {
      std::swap(x[x.size() - 1], x[x.size() - 2]);
      return x;
    };
    const Solved expected = hybrid(forwards, state, force, force);
    const Solved found = hybrid(backwards, {swapped(state.q), swapped(state.v)}, swapped(force), swapped(force));
    ASSERT_LT(relative_difference(swapped(found.acceleration), expected.acceleration), 1e-11) << "trial " << trial;
  }
}

TEST(EquivalentModels, a_body_split_and_welded_moves_as_one) {
  Random random(54);
  for (int trial = 0; trial < 300; ++trial) {
    const MassProperties<double> one = random.mass();
    const MassProperties<double> other = random.mass();
    const SpatialTransform<double> weld = random.pose();
    const SpatialTransform<double> place = random.pose();
    const Joint<double> joint = trial % 2 == 0 ? Joint<double>::ball() : Joint<double>::revolute(random.direction());
    const Joint<double> last = Joint<double>::revolute(random.direction());
    const SpatialTransform<double> last_place = random.pose();
    const MassProperties<double> last_mass = random.mass();

    ModelBuilder<double> split;
    split.add_body("one", ground, joint, place, one);
    const int part = split.add_body("part", 0, Joint<double>::weld(), weld, other);
    split.add_body("last", part, last, last_place, last_mass);
    // The same as one body: the sum of the parts about their common center.
    MassProperties<double> whole{};
    whole.mass = one.mass + other.mass;
    const Vector3<double> other_center = weld * other.center;
    whole.center = (one.mass * one.center + other.mass * other_center) / whole.mass;
    whole.inertia_center = one.inertia_center + one.mass * unit_mass_inertia(one.center - whole.center) +
                           turned(weld.R, other.inertia_center) +
                           other.mass * unit_mass_inertia(other_center - whole.center);
    ModelBuilder<double> joined;
    joined.add_body("one", ground, joint, place, whole);
    joined.add_body("last", 0, last, weld * last_place, last_mass);

    split.set_gravity({1.0, 2.0, 3.0});
    joined.set_gravity({1.0, 2.0, 3.0});
    const Model<double> split_model = split.build();
    const State<double> state = testing::random_state(random, split_model);
    const std::vector<double> force = random.numbers(split_model.velocity_size(), 3.0);
    const Solved expected = hybrid(joined.build(), state, force, force);
    const Solved found = hybrid(split_model, state, force, force);
    ASSERT_LT(relative_difference(found.acceleration, expected.acceleration), 1e-10) << "trial " << trial;
  }
}

// A ball joint against three hinges at one place with massless bodies between: the body's points accelerate alike.
TEST(EquivalentModels, three_crossed_hinges_move_like_a_ball) {
  Random random(55);
  for (int trial = 0; trial < 300; ++trial) {
    const MassProperties<double> mass = random.mass();
    const SpatialTransform<double> place = random.pose();
    ModelBuilder<double> gimbal;
    gimbal.set_gravity({0.0, 0.0, -9.81});
    const Vector3<double> x = Vector3<double>::unit(0);
    const Vector3<double> y = Vector3<double>::unit(1);
    const Vector3<double> z = Vector3<double>::unit(2);
    const int last = gimbal.add_chain(
        "body", ground, {Joint<double>::revolute(z), Joint<double>::revolute(y), Joint<double>::revolute(x)}, place,
        mass);
    const Model<double> hinged = gimbal.build();
    const State<double> state{{random.uniform(-3.0, 3.0), random.uniform(-1.0, 1.0), random.uniform(-3.0, 3.0)},
                              random.numbers(3, 2.0)};
    const std::vector<double> none(3, 0.0);
    const Solved found = hybrid(hinged, state, none, none);
    Workspace<double> workspace(hinged);
    update_accelerations<double>(hinged, workspace, state, found.acceleration);

    ModelBuilder<double> ball;
    ball.set_gravity({0.0, 0.0, -9.81});
    ball.add_body("body", ground, Joint<double>::ball(), place, mass);
    const Model<double> model = ball.build();
    const Matrix3<double> R = body_rotation(hinged, workspace, last);
    const Quaternion<double> q = quaternion_of(transpose(place.R) * R);
    const Vector3<double> w = transpose_times(R, angular_velocity(workspace, last));
    const Solved expected = hybrid(model, {{q.w, q.x, q.y, q.z}, {w.x, w.y, w.z}}, none, none);
    const Vector3<double> alpha = transpose_times(R, angular_acceleration(workspace, last));
    ASSERT_LT(relative_difference(std::vector<double>{alpha.x, alpha.y, alpha.z}, expected.acceleration), 1e-10)
        << "trial " << trial;
  }
}

TEST(EquivalentModels, a_screw_without_pitch_is_a_hinge_and_compounds_are_chains) {
  Random random(56);
  const MassProperties<double> mass = random.mass();
  const SpatialTransform<double> place = random.pose();
  const Vector3<double> axis = random.direction();
  const auto single = [&](const Joint<double>& joint) {
    ModelBuilder<double> builder;
    builder.set_gravity({1.0, -2.0, 3.0});
    builder.add_body("body", ground, joint, place, mass);
    return builder.build();
  };
  const State<double> state{{0.4}, {1.5}};
  const Solved screw = hybrid(single(Joint<double>::screw(axis, 0.0)), state, {0.0}, {2.0});
  const Solved hinge = hybrid(single(Joint<double>::revolute(axis)), state, {0.0}, {2.0});
  EXPECT_LT(relative_difference(screw.acceleration, hinge.acceleration), 1e-14);

  // A locked pitch: the cylindrical joint whose sliding is prescribed to follow the turning is a screw.
  ModelBuilder<double> builder;
  builder.set_gravity({1.0, -2.0, 3.0});
  const int body = builder.add_cylindrical("body", ground, axis, place, mass);
  builder.set_mode(body - 1, 0, CoordinateMode::prescribed);
  builder.set_mode(body, 0, CoordinateMode::prescribed);
  const Model<double> cylindrical = builder.build();
  EXPECT_EQ(cylindrical.name(0), "body.1");
  const double pitch = 0.3;
  const Solved both = hybrid(cylindrical, {{pitch * 0.4, 0.4}, {pitch * 1.5, 1.5}}, {pitch * 0.9, 0.9}, {0.0, 0.0});
  Workspace<double> workspace(single(Joint<double>::screw(axis, pitch)));
  std::vector<double> needed(1);
  inverse_dynamics<double>(single(Joint<double>::screw(axis, pitch)), workspace, state, std::vector<double>{0.9},
                           needed);
  EXPECT_NEAR(both.force[1] + pitch * both.force[0], needed[0], 1e-12);
}

}  // namespace equivalent_models_test
}  // namespace poinsot
