// What ModelBuilder builds and what it refuses.
#include "poinsot/engine/model/builder.h"

#include <gtest/gtest.h>

#include "poinsot/engine/math/algebra/dual.h"
#include "poinsot/engine/math/algebra/pack.h"
#include "poinsot/engine/model/state.h"

namespace poinsot {
namespace builder_test {

const MassProperties<double> block{2.0, {0.1, 0.2, 0.3}, SymmetricMatrix3<double>::diagonal(1.0, 2.0, 2.5)};

std::string message(const std::function<void(ModelBuilder<double>&)>& build) {
  ModelBuilder<double> builder;
  builder.add_body("base", ground, Joint<double>::free(), {}, block);
  try {
    build(builder);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "nothing";
}

TEST(ModelBuilder, lays_out_bodies_and_coordinates_in_order) {
  ModelBuilder<double> builder;
  builder.set_gravity({0.0, 0.0, -9.81});
  const int base = builder.add_body("base", ground, Joint<double>::free(), {}, block);
  const int plate = builder.add_body("plate", base, Joint<double>::weld(), {}, block);
  const int ball = builder.add_body("ball", "plate", Joint<double>::ball(), {}, block);
  const int arm =
      builder.add_body("arm", base, Joint<double>::revolute({0.0, 2.0, 0.0}), {}, block, CoordinateMode::prescribed);
  builder.set_mode(ball, 1, CoordinateMode::locked);
  const Model<double> model = builder.build();
  EXPECT_EQ(model.body_count(), 4);
  EXPECT_EQ(model.position_size(), 7 + 0 + 4 + 1);
  EXPECT_EQ(model.velocity_size(), 6 + 0 + 3 + 1);
  EXPECT_EQ(model.body(ball).q, 7);
  EXPECT_EQ(model.body(ball).v, 6);
  EXPECT_EQ(model.body(arm).parent, base);
  EXPECT_EQ(model.body(arm).v, 9);
  EXPECT_EQ(model.name(plate), "plate");
  EXPECT_EQ(model.find("arm"), arm);
  EXPECT_EQ(model.find("leg"), std::nullopt);
  EXPECT_EQ(model.mode(7), CoordinateMode::locked);
  EXPECT_EQ(model.mode(9), CoordinateMode::prescribed);
  EXPECT_FALSE(model.body(ball).all_free);
  EXPECT_TRUE(model.body(base).all_free);
  EXPECT_EQ(model.gravity().z, -9.81);
  // Only coordinates inboard move a body.
  ASSERT_EQ(model.moving_coordinates(ball).size(), 1u);
  EXPECT_EQ(model.moving_coordinates(ball)[0].last, 9);
  ASSERT_EQ(model.moving_coordinates(arm).size(), 2u);
  EXPECT_EQ(model.moving_coordinates(arm)[0].last, 6);
  EXPECT_EQ(model.moving_coordinates(arm)[1].first, 9);
  EXPECT_EQ(model.moving_coordinates(arm)[1].last, 10);
}

TEST(ModelBuilder, compounds_are_chains_of_massless_bodies) {
  ModelBuilder<double> builder;
  const int cross = builder.add_universal("cross", ground, {1, 0, 0}, {0, 1, 0}, {}, block);
  const int sleeve = builder.add_cylindrical("sleeve", cross, {0, 0, 1}, {}, block);
  const int plate = builder.add_planar("plate", sleeve, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {}, block);
  const Model<double> model = builder.build();
  EXPECT_EQ(cross, 1);
  EXPECT_EQ(sleeve, 3);
  EXPECT_EQ(plate, 6);
  EXPECT_EQ(model.velocity_size(), 7);
  EXPECT_EQ(model.name(4), "plate.1");
  EXPECT_EQ(model.name(5), "plate.2");
  EXPECT_EQ(model.body(4).joint, JointType::prismatic);
  EXPECT_EQ(model.body(4).inertia.mass, 0.0);
  EXPECT_EQ(model.body(6).inertia.mass, 2.0);
}

TEST(ModelBuilder, refuses_wrong_data_naming_the_body) {
  using J = Joint<double>;
  using B = ModelBuilder<double>;
  EXPECT_EQ(message([](B& b) { b.add_body("arm", 7, J::ball(), {}, block); }),
            "body 'arm': its parent 7 is unknown; expected ground or a body added before (0 to 0)");
  EXPECT_EQ(message([](B& b) { b.add_body("arm", -2, J::ball(), {}, block); }),
            "body 'arm': its parent -2 is unknown; expected ground or a body added before (0 to 0)");
  EXPECT_EQ(message([](B& b) { b.add_body("arm", "bass", J::ball(), {}, block); }),
            "body 'arm': its parent 'bass' is unknown; add the parent first");
  EXPECT_EQ(message([](B& b) { b.add_body("base", ground, J::ball(), {}, block); }),
            "body 'base': the name is taken by another body");
  EXPECT_EQ(message([](B& b) { b.add_body("ground", ground, J::ball(), {}, block); }),
            "body 'ground': this name is kept for the ground");
  EXPECT_EQ(message([](B& b) { b.add_body("", ground, J::ball(), {}, block); }), "body number 1 has no name");
  EXPECT_EQ(message([](B& b) {
              b.add_body("arm", 0, J::revolute({0, 0, 0}), {}, block);
            }),
            "body 'arm': the axis of its joint has length zero");
  EXPECT_EQ(message([](B& b) {
              b.add_body("arm", 0, J::revolute({0, NAN, 0}), {}, block);
            }),
            "body 'arm': the axis of its joint is not finite");
  EXPECT_EQ(message([](B& b) {
              b.add_body("arm", 0, J::screw({0, 0, 1}, INFINITY), {}, block);
            }),
            "body 'arm': the pitch of its joint is not finite");
  EXPECT_EQ(message([](B& b) {
              b.add_body("arm", 0, J::ball(), SpatialTransform<double>::translation({INFINITY, 0, 0}), block);
            }),
            "body 'arm': the place of its joint is not finite");
  EXPECT_EQ(message([](B& b) {
              SpatialTransform<double> mirrored;
              mirrored.R.row2.z = -1.0;
              b.add_body("arm", 0, J::ball(), mirrored, block);
            }),
            "body 'arm': the axes of its joint frame are not right-handed, orthogonal unit vectors (to 1e-9)");
  MassProperties<double> bad = block;
  bad.mass = -1.0;
  EXPECT_EQ(message([&](B& b) { b.add_body("arm", 0, J::ball(), {}, bad); }), "body 'arm': its mass is negative");
  bad = block;
  bad.inertia_center.yy = -1e-3;
  EXPECT_EQ(message([&](B& b) { b.add_body("arm", 0, J::ball(), {}, bad); }),
            "body 'arm': a moment of inertia about its mass center is negative");
  bad = block;
  bad.inertia_center.xy = NAN;
  EXPECT_EQ(message([&](B& b) { b.add_body("arm", 0, J::ball(), {}, bad); }),
            "body 'arm': its mass properties are not finite");
  EXPECT_EQ(message([](B& b) { b.add_chain("arm", 0, {}, {}, block); }), "body 'arm': its chain of joints is empty");
  EXPECT_EQ(message([](B& b) { b.set_mode(3, 0, CoordinateMode::free); }), "set_mode: there is no body 3");
  EXPECT_EQ(message([](B& b) { b.set_mode(0, 6, CoordinateMode::free); }),
            "body 'base': its joint has 6 velocity coordinates, there is no coordinate 6");
  EXPECT_EQ(message([](B& b) { b.set_gravity({0, 0, -INFINITY}); }), "set_gravity: the gravity is not finite");
}

// A refused body leaves the builder as it was.
TEST(ModelBuilder, goes_on_after_a_refusal) {
  ModelBuilder<double> builder;
  EXPECT_THROW(builder.add_body("arm", 3, Joint<double>::ball(), {}, block), std::invalid_argument);
  builder.add_body("arm", ground, Joint<double>::ball(), {}, block);
  EXPECT_EQ(builder.build().body_count(), 1);
  EXPECT_EQ(builder.build().position_size(), 4);
}

TEST(ModelBuilder, checks_the_values_of_duals_and_every_lane_of_packs) {
  using D = Dual<1>;
  using P = Pack<4>;
  const auto massive = []<class S>(const S& mass) {
    return MassProperties<S>{mass, Vector3<S>::zero(), SymmetricMatrix3<S>::diagonal(S(1), S(1), S(1))};
  };
  ModelBuilder<D> duals;
  EXPECT_NO_THROW(duals.add_body("fine", ground, Joint<D>::revolute({D(0), D::variable(1.0, 0), D(0)}), {},
                                 massive(D::variable(1.0, 0))));
  EXPECT_THROW(duals.add_body("arm", ground, Joint<D>::ball(), {}, massive(D(-1.0))), std::invalid_argument);
  ModelBuilder<P> packs;
  EXPECT_NO_THROW(packs.add_body("fine", ground, Joint<P>::revolute({P(0), P(1), P(0)}), {}, massive(P(1.0))));
  P one_negative(1.0);
  one_negative.set_lane(2, -1.0);
  EXPECT_THROW(packs.add_body("arm", ground, Joint<P>::ball(), {}, massive(one_negative)), std::invalid_argument);
}

TEST(Model, packs_of_models_need_one_model_per_lane_and_one_tree) {
  const auto model = [](const Joint<double>& joint, CoordinateMode mode) {
    ModelBuilder<double> builder;
    builder.add_body("body", ground, joint, {}, block, mode);
    return builder.build();
  };
  using J = Joint<double>;
  std::vector<Model<double>> models(3, model(J::ball(), CoordinateMode::free));
  EXPECT_THROW(pack_models<Pack<4>>(models), std::invalid_argument);
  models.push_back(model(J::ball(), CoordinateMode::free));
  EXPECT_EQ(pack_models<Pack<4>>(models).body_count(), 1);
  models[2] = model(J::ball(), CoordinateMode::locked);
  EXPECT_THROW(pack_models<Pack<4>>(models), std::invalid_argument);
  models[2] = model(J::free(), CoordinateMode::free);
  EXPECT_THROW(pack_models<Pack<4>>(models), std::invalid_argument);
}

}  // namespace builder_test
}  // namespace poinsot
