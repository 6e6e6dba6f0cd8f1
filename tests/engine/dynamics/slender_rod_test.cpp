// A slender rod has no moment of inertia about its own line: on a ball or free joint its accelerations have no value.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "poinsot/engine/dynamics/forward_dynamics.h"
#include "poinsot/engine/dynamics/inverse_dynamics.h"
#include "poinsot/engine/math/algebra/pack.h"
#include "poinsot/engine/model/builder.h"

namespace poinsot {
namespace slender_rod_test {

using Vector = Vector3<double>;

// Of length one from the origin along d. along: how large its moment about its own line is beside the others.
template <class Scalar>
MassProperties<Scalar> rod(const Vector& d, double along) {
  const double m = 1.7, k = m / 12;
  const auto moment = [&](double a, double b, bool same) {
    return Scalar(k * ((same ? 1 : 0) - a * b) + along * k * a * b);
  };
  return {Scalar(m),
          {Scalar(0.5 * d.x), Scalar(0.5 * d.y), Scalar(0.5 * d.z)},
          {moment(d.x, d.x, true), moment(d.y, d.y, true), moment(d.z, d.z, true), moment(d.x, d.y, false),
           moment(d.y, d.z, false), moment(d.z, d.x, false)}};
}

template <class Scalar>
std::vector<Scalar> accelerations(const Model<Scalar>& model, const State<Scalar>& state) {
  Workspace<Scalar> workspace(model);
  const std::vector<Scalar> force(static_cast<std::size_t>(model.velocity_size()), Scalar(0.3));
  std::vector<Scalar> found(force.size());
  forward_dynamics<Scalar>(model, workspace, state, force, found);
  return found;
}

Vector direction(std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  return normalized(Vector{normal(random), normal(random), normal(random)});
}

TEST(SlenderRod, OnABallOrFreeJointHasNoAcceleration) {
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (int i = 0; i < 300; ++i)
    for (const JointType type : {JointType::ball, JointType::free}) {
      ModelBuilder<double> builder;
      const Vector hung{unit(random), unit(random), unit(random)};
      const int carrier = builder.add_body(
          "carrier", ground, Joint<double>::revolute(direction(random)), SpatialTransform<double>::translation(hung),
          MassProperties<double>{1, hung, SymmetricMatrix3<double>::diagonal(1, 2, 2)});
      builder.add_body("rod", i % 2 == 0 ? ground : carrier, Joint<double>{type},
                       SpatialTransform<double>::translation(hung), rod<double>(direction(random), 0));
      builder.set_gravity({0, 0, -9.81});
      const Model<double> model = builder.build();
      State<double> state = neutral_state(model);
      state.q[0] = unit(random);
      for (double& v : state.v) v = unit(random);
      const std::vector<double> found = accelerations(model, state);
      bool finite = true;
      for (std::size_t k = 1; k < 4; ++k) finite = finite && std::isfinite(found[k]);
      EXPECT_FALSE(finite) << i;
    }
}

// In a pack the lanes of other bodies keep their values.
TEST(SlenderRod, InAPackIsInItsLaneAlone) {
  std::mt19937_64 random(3);
  const Vector d = direction(random);
  ModelBuilder<Pack<4>> builder;
  MassProperties<Pack<4>> properties = rod<Pack<4>>(d, 0);
  const MassProperties<double> thick = rod<double>(d, 0.1);
  const auto put = [](Pack<4>& pack, double number) { pack.set_lane(2, number); };
  put(properties.inertia_center.xx, thick.inertia_center.xx);
  put(properties.inertia_center.yy, thick.inertia_center.yy);
  put(properties.inertia_center.zz, thick.inertia_center.zz);
  put(properties.inertia_center.xy, thick.inertia_center.xy);
  put(properties.inertia_center.yz, thick.inertia_center.yz);
  put(properties.inertia_center.zx, thick.inertia_center.zx);
  builder.add_body("rod", ground, Joint<Pack<4>>{JointType::ball}, SpatialTransform<Pack<4>>::identity(), properties);
  const Model<Pack<4>> model = builder.build();
  State<Pack<4>> state = neutral_state(model);
  state.v = {Pack<4>(0.3), Pack<4>(-0.2), Pack<4>(0.9)};
  const std::vector<Pack<4>> found = accelerations(model, state);

  ModelBuilder<double> one;
  one.add_body("rod", ground, Joint<double>{JointType::ball}, SpatialTransform<double>::identity(), thick);
  const Model<double> alone = one.build();
  State<double> there = neutral_state(alone);
  there.v = {0.3, -0.2, 0.9};
  const std::vector<double> expected = accelerations(alone, there);
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_NEAR(found[k].lane(2), expected[k], 1e-12 * (1 + std::abs(expected[k])));
    EXPECT_FALSE(std::isfinite(found[k].lane(0)));
  }
}

// Thin is not slender: down to a thousandth of the length the forces come back from the accelerations.
TEST(SlenderRod, AThinOneHasItsAccelerations) {
  std::mt19937_64 random(4);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (const double along : {1.0, 1e-3, 1e-6, 1e-9})
    for (const JointType type : {JointType::ball, JointType::free}) {
      ModelBuilder<double> builder;
      builder.add_body("rod", ground, Joint<double>{type}, SpatialTransform<double>::identity(),
                       rod<double>(direction(random), along));
      builder.set_gravity({0, 0, -9.81});
      const Model<double> model = builder.build();
      State<double> state = neutral_state(model);
      for (double& v : state.v) v = unit(random);
      const std::vector<double> found = accelerations(model, state);
      Workspace<double> workspace(model);
      std::vector<double> force(found.size());
      inverse_dynamics<double>(model, workspace, state, found, force);
      for (const double f : force) EXPECT_NEAR(f, 0.3, 1e-14 / along + 1e-11) << along;
    }
}

}  // namespace slender_rod_test
}  // namespace poinsot
