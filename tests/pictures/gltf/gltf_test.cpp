#include "pictures/gltf/gltf.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <nlohmann/json.hpp>
#include <optional>
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

// What stands at a node: a point of its mesh brought to the ground, at the shown instant or a frame of the animation.
struct Placed {
  Vector3<double> place, stretch{1, 1, 1};
  Quaternion<double> turn = Quaternion<double>::identity();
  Vector3<double> operator()(const Vector3<double>& point) const {
    const Vector3<double> p{stretch.x * point.x, stretch.y * point.y, stretch.z * point.z};
    return place + rotation_matrix(turn) * p;
  }
};

Placed placed(const File& file, std::size_t node, std::optional<std::size_t> frame) {
  Placed found;
  const auto vector = [](const auto& v, std::size_t at) { return Vector3<double>{v[at], v[at + 1], v[at + 2]}; };
  const auto turn = [](const auto& v, std::size_t at) {
    return Quaternion<double>{v[at + 3], v[at], v[at + 1], v[at + 2]};
  };
  const Json& json = file.json["nodes"][node];
  found.place = vector(json["translation"].get<std::vector<double>>(), 0);
  found.turn = turn(json["rotation"].get<std::vector<double>>(), 0);
  if (json.contains("scale")) found.stretch = vector(json["scale"].get<std::vector<double>>(), 0);
  if (!frame) return found;
  const Json& animation = file.json["animations"][0];
  for (const Json& channel : animation["channels"]) {
    if (channel["target"]["node"] != node) continue;
    const std::vector<float> values =
        file.numbers(animation["samplers"][channel["sampler"].get<std::size_t>()]["output"]);
    if (channel["target"]["path"] == "translation") found.place = vector(values, 3 * *frame);
    if (channel["target"]["path"] == "scale") found.stretch = vector(values, 3 * *frame);
    if (channel["target"]["path"] == "rotation") found.turn = turn(values, 4 * *frame);
  }
  return found;
}

std::vector<std::size_t> nodes_called(const File& file, const std::string& name) {
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < file.json["nodes"].size(); ++i)
    if (file.json["nodes"][i]["name"] == name) found.push_back(i);
  return found;
}

Matrix3<double> turn_about_z(double angle) {
  return {{std::cos(angle), -std::sin(angle), 0}, {std::sin(angle), std::cos(angle), 0}, {0, 0, 1}};
}

// A weight on a spring, which swings and turns.
TEST(Gltf, links_run_from_end_to_end_all_the_while) {
  scene::Scene scene;
  scene::Body weight;
  weight.name = "weight";
  scene.bodies = {weight};
  const Vector3<double> hook{1, 2, 3}, eye{0.1, -0.2, 0.3};
  scene.links = {{scene::LinkKind::spring, "spring", {scene::ground, hook}, {0, eye}},
                 {scene::LinkKind::damper, "damper", {0, eye}, {scene::ground, hook}},
                 {scene::LinkKind::cord, "cord", {0, eye}, {0, eye}}};
  scene::Motion motion;
  for (int i = 0; i < 6; ++i) {
    motion.times.push_back(0.1 * i);
    motion.poses.push_back({scene::Pose{.R = turn_about_z(2.2 * i), .p = {1.0 - i, std::cos(i), -0.7 * i}}});
  }
  scene.motion = motion;
  const File file(pictures::gltf_of(scene, ""));
  for (const char* name : {"spring", "damper"}) {
    const std::vector<std::size_t> nodes = nodes_called(file, name);
    ASSERT_EQ(nodes.size(), 1U);
    for (std::size_t i = 0; i < 6; ++i) {
      const Placed here = placed(file, nodes.front(), i);
      const Vector3<double> held = motion.poses[i][0].R * eye + motion.poses[i][0].p;
      const bool spring = std::string(name) == "spring";
      EXPECT_NEAR(norm(Vector3<double>(here({0, 0, 0}) - (spring ? hook : held))), 0, 1e-6);
      EXPECT_NEAR(norm(Vector3<double>(here({0, 0, 1}) - (spring ? held : hook))), 0, 1e-5);
      // Coils keep their thickness.
      EXPECT_EQ(here.stretch.x, 1);
    }
  }
  EXPECT_EQ(norm(placed(file, nodes_called(file, "cord").front(), 3).stretch), 0);
}

// A cord over a wheel of radius 2 about z that hangs down on both sides, one of which swings out.
TEST(Gltf, an_arc_on_a_wheel_covers_what_lies_between_the_straight_parts) {
  constexpr double radius = 2;
  for (const bool grows : {false, true}) {
    scene::Scene scene;
    scene::Body wheel;
    wheel.name = "wheel";
    scene.bodies = {wheel};
    const auto end_at = [](double angle) {
      return Vector3<double>{radius * std::cos(angle), radius * std::sin(angle), 0};
    };
    scene.links = {{scene::LinkKind::cord, "rope", {scene::ground, end_at(0)}, {scene::ground, {2, -5, 0}}},
                   {scene::LinkKind::cord, "rope", {scene::ground, {-2, -5, 0}}, {scene::ground, end_at(2)}}};
    scene.wraps = {{"rope", 0, 1, {0, {0, 0, 0}}, {0, 0, 1}}};
    scene::Motion motion;
    scene::MovingLink led{1};
    std::vector<double> angles;
    for (int i = 0; i < 8; ++i) {
      angles.push_back(grows ? 2 + 0.4 * i : 2);
      motion.times.push_back(i);
      motion.poses.push_back({scene::Pose{.R = turn_about_z(0.3 * i)}});
      led.from.push_back({-2, -5, 0});
      led.to.push_back(end_at(angles.back()));
    }
    motion.links = {led};
    scene.motion = motion;
    const File file(pictures::gltf_of(scene, ""));
    std::vector<std::size_t> pieces;
    for (const std::size_t node : nodes_called(file, "rope")) {
      const Json& mesh = file.json["meshes"][file.json["nodes"][node]["mesh"].get<std::size_t>()];
      if (file.numbers(mesh["primitives"][0]["attributes"]["POSITION"]).size() > 6) pieces.push_back(node);
    }
    ASSERT_EQ(pieces.size(), grows ? 3U : 1U);
    for (std::size_t i = 0; i < angles.size(); ++i) {
      // The angles that the pieces cover, in steps.
      std::vector<bool> covered(100, false);
      for (const std::size_t node : pieces) {
        const Json& mesh = file.json["meshes"][file.json["nodes"][node]["mesh"].get<std::size_t>()];
        const std::vector<float> line = file.numbers(mesh["primitives"][0]["attributes"]["POSITION"]);
        double first = 10, last = -10;
        for (std::size_t k = 0; k < line.size(); k += 3) {
          const Vector3<double> point = placed(file, node, i)({line[k], line[k + 1], line[k + 2]});
          EXPECT_NEAR(norm(point), radius, 1e-5);
          double angle = std::atan2(point.y, point.x);
          if (angle < -1e-5) angle += 6.283185307179586;
          first = std::min(first, angle);
          last = std::max(last, angle);
        }
        EXPECT_GT(first, -1e-5);
        EXPECT_LT(last, angles[i] + 1e-5);
        for (std::size_t k = 0; k < covered.size(); ++k) {
          const double at = angles[i] * (static_cast<double>(k) + 0.5) / static_cast<double>(covered.size());
          if (at > first - 1e-5 && at < last + 1e-5) covered[k] = true;
        }
      }
      EXPECT_EQ(std::ranges::count(covered, true), 100) << i;
    }
  }
}

// Of one kind the arrows share a scale; a couple has an arc around its axis and two heads.
TEST(Gltf, arrows_point_along_their_vectors) {
  scene::Scene scene = turning_triangle();
  scene.motion.reset();
  scene.length = 10;
  scene::Arrow force, half, couple;
  force.text = "F";
  force.at = {0, {1, 0, 0}};
  force.vector = {0, -3, 4};
  half = force;
  half.text = "E";
  half.vector = {0, 0, -2.5};
  couple.text = "C";
  couple.quantity = scene::Quantity::couple;
  couple.vector = {7, 0, 0};
  scene::Diagram model;
  model.arrows = {force, half, couple};
  scene.diagrams = {model};
  const File file(pictures::gltf_of(scene, ""));
  const auto tip = [&](const std::string& name, std::size_t primitive) {
    const std::size_t node = nodes_called(file, name).front();
    const Json& mesh = file.json["meshes"][file.json["nodes"][node]["mesh"].get<std::size_t>()];
    const std::vector<float> all = file.numbers(mesh["primitives"][primitive]["attributes"]["POSITION"]);
    float most = 0;
    for (std::size_t k = 2; k < all.size(); k += 3) most = std::max(most, all[k]);
    return placed(file, node, {})({0, 0, most});
  };
  const Vector3<double> F = tip("F", 0) - Vector3<double>{1, 0, 0}, E = tip("E", 0) - Vector3<double>{1, 0, 0};
  EXPECT_NEAR(norm(Vector3<double>(F - norm(F) * Vector3<double>{0, -0.6, 0.8})), 0, 1e-5);
  EXPECT_NEAR(norm(Vector3<double>(E - norm(E) * Vector3<double>{0, 0, -1})), 0, 1e-5);
  EXPECT_NEAR(norm(F) / norm(E), 2, 1e-5);
  const std::size_t node = nodes_called(file, "C").front();
  const Json& mesh = file.json["meshes"][file.json["nodes"][node]["mesh"].get<std::size_t>()];
  ASSERT_EQ(mesh["primitives"].size(), 2U);
  EXPECT_EQ(mesh["primitives"][0]["mode"], 1);
  EXPECT_NEAR(tip("C", 1).x, 3.4, 1e-5);
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
