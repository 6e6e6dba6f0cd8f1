#include "pictures/gltf/gltf.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "poinsot/engine/math/algebra/quaternion.h"

namespace poinsot {
namespace gltf_test {

using Json = nlohmann::json;

std::uint32_t word_at(const std::string& bytes, std::size_t at) {
  std::uint32_t word = 0;
  for (std::size_t i = 0; i < 4; ++i)
    word |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[at + i])) << 8 * i;
  return word;
}

// A file read back by the rules of the format.
struct File {
  Json json;
  std::string buffer;

  explicit File(const std::string& bytes) {
    EXPECT_EQ(bytes.substr(0, 4), "glTF");
    EXPECT_EQ(word_at(bytes, 4), 2U);
    EXPECT_EQ(word_at(bytes, 8), bytes.size());
    for (std::size_t at = 12; at < bytes.size(); at += 8 + word_at(bytes, at)) {
      EXPECT_EQ(word_at(bytes, at) % 4, 0U);
      const std::string content = bytes.substr(at + 8, word_at(bytes, at));
      if (bytes.substr(at + 4, 4) == "JSON") json = Json::parse(content);
      if (bytes.substr(at + 4, 4) == std::string("BIN\0", 4)) buffer = content;
    }
  }

  std::vector<float> numbers(std::size_t accessor) const {
    const Json& one = json["accessors"][accessor];
    const Json& view = json["bufferViews"][one["bufferView"].get<std::size_t>()];
    std::vector<float> values(view["byteLength"].get<std::size_t>() / 4);
    std::memcpy(values.data(), buffer.data() + view["byteOffset"].get<std::size_t>(), 4 * values.size());
    return values;
  }
};

// A triangle that moves along x and turns about z by less than half a turn between records.
scene::Scene turning_triangle() {
  scene::Scene scene;
  scene::Body body;
  body.name = "plate";
  scene::Shape shape;
  shape.kind = "triangle";
  shape.extent = scene::Extent::surface;
  shape.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 2, 0}};
  shape.triangles = {{0, 1, 2}};
  shape.normals = {{Vector3<double>{0, 0, 2}, {0, 0, 2}, {0, 0, 2}}};
  shape.edges = {{0, 1, 2, 0}};
  body.shapes = {shape};
  scene.bodies = {body};
  scene::Motion motion;
  for (int i = 0; i < 7; ++i) {
    const double angle = 1.9 * i;
    const Matrix3<double> R{{std::cos(angle), -std::sin(angle), 0}, {std::sin(angle), std::cos(angle), 0}, {0, 0, 1}};
    motion.times.push_back(3 + 0.5 * i);
    motion.poses.push_back({scene::Pose{.R = R, .p = {0.25 * i, 0, 0}}});
  }
  scene.motion = motion;
  return scene;
}

TEST(Gltf, surfaces_and_edges_are_on_the_axes_of_the_body) {
  const File file(pictures::gltf_of(turning_triangle(), "A <plate>"));
  EXPECT_EQ(file.json["asset"]["version"], "2.0");
  EXPECT_EQ(file.json["nodes"].back()["name"], "A <plate>");
  const Json& primitives = file.json["meshes"][0]["primitives"];
  ASSERT_EQ(primitives.size(), 2U);
  EXPECT_EQ(file.numbers(primitives[0]["attributes"]["POSITION"]), (std::vector<float>{0, 0, 0, 1, 0, 0, 0, 2, 0}));
  EXPECT_EQ(file.numbers(primitives[0]["attributes"]["NORMAL"]), (std::vector<float>{0, 0, 1, 0, 0, 1, 0, 0, 1}));
  EXPECT_EQ(primitives[1]["mode"], 1);
  EXPECT_EQ(file.numbers(primitives[1]["attributes"]["POSITION"]).size(), 18U);
}

TEST(Gltf, the_motion_is_an_animation_with_the_recorded_poses) {
  const scene::Scene scene = turning_triangle();
  const File file(pictures::gltf_of(scene, ""));
  const Json& animation = file.json["animations"][0];
  ASSERT_EQ(animation["channels"].size(), 2U);
  const Json& samplers = animation["samplers"];
  const std::vector<float> times = file.numbers(samplers[0]["input"]);
  const std::vector<float> places = file.numbers(samplers[0]["output"]);
  const std::vector<float> turns = file.numbers(samplers[1]["output"]);
  ASSERT_EQ(times.size(), 7U);
  ASSERT_EQ(turns.size(), 28U);
  for (std::size_t i = 0; i < times.size(); ++i) {
    EXPECT_FLOAT_EQ(times[i], 0.5F * static_cast<float>(i));
    EXPECT_FLOAT_EQ(places[3 * i], 0.25F * static_cast<float>(i));
    // x, y, z, w of a turn about z by the angle.
    const double angle = 1.9 * static_cast<double>(i);
    EXPECT_NEAR(std::abs(turns[4 * i + 2] * std::sin(angle / 2) + turns[4 * i + 3] * std::cos(angle / 2)), 1, 1e-6);
    if (i > 0) {
      double cosine = 0;
      for (std::size_t k = 0; k < 4; ++k) cosine += static_cast<double>(turns[4 * i + k]) * turns[4 * i - 4 + k];
      EXPECT_GT(cosine, 0) << i;
    }
  }
}

// The root turns what is up in the scene to the y axis.
TEST(Gltf, up_is_y) {
  for (const Vector3<double>& up : {Vector3<double>{0, 0, 1}, {0, 1, 0}, {1, 0, 0}, {0, -1, 0}, {0, 0.6, -0.8}}) {
    scene::Scene scene = turning_triangle();
    scene.up = up;
    const Json root = File(pictures::gltf_of(scene, "")).json["nodes"].back();
    const Quaternion<double> q{root["rotation"][3], root["rotation"][0], root["rotation"][1], root["rotation"][2]};
    const Vector3<double> u{q.x, q.y, q.z};
    const Vector3<double> turned = up + 2.0 * cross(u, cross(u, up) + q.w * up);
    EXPECT_NEAR(turned.y, 1, 1e-6);
  }
}

TEST(Gltf, a_scene_without_bodies_is_a_file_too) {
  const File file(pictures::gltf_of(scene::Scene{}, "nothing"));
  EXPECT_EQ(file.json["nodes"].size(), 1U);
  EXPECT_FALSE(file.json.contains("meshes"));
  EXPECT_TRUE(file.buffer.empty());
}

TEST(Gltf, times_that_are_one_in_single_precision_stand_once) {
  scene::Scene scene = turning_triangle();
  scene.motion->times = {0, 1, 1 + 1e-12, 2, 3, 4, 5};
  const File file(pictures::gltf_of(scene, ""));
  EXPECT_EQ(file.numbers(file.json["animations"][0]["samplers"][0]["input"]), (std::vector<float>{0, 1, 2, 3, 4, 5}));
}

}  // namespace gltf_test
}  // namespace poinsot
