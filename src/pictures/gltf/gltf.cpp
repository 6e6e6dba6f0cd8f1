#include "pictures/gltf/gltf.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "document/program_version.h"
#include "pictures/gltf/glb.h"
#include "pictures/gltf/moving_parts.h"
#include "pictures/solids/solid.h"
#include "poinsot/engine/math/algebra/quaternion.h"
#include "poinsot/pictures.h"

namespace poinsot::pictures {
namespace {

using Json = Glb::Json;
using Numbers3 = std::array<float, 3>;
using Numbers4 = std::array<float, 4>;

// Tones that the colour-blind tell apart (Okabe and Ito), as on the page, in linear light.
constexpr std::array<std::array<double, 3>, 8> tones{{{0.093, 0.456, 0.815},
                                                      {0.791, 0.347, 0.0},
                                                      {0.0, 0.342, 0.171},
                                                      {0.604, 0.191, 0.386},
                                                      {0.871, 0.775, 0.054},
                                                      {0.0, 0.168, 0.445},
                                                      {0.665, 0.112, 0.0},
                                                      {0.319, 0.319, 0.319}}};
// Those of cords, springs, curves and arrows, in the order of PartTone.
constexpr std::array<std::array<double, 3>, 8> part_tones{{{0.02, 0.02, 0.02},
                                                           {0.25, 0.3, 0.36},
                                                           {0.665, 0.112, 0.0},
                                                           {0.533, 0.02, 0.026},
                                                           {0.462, 0.008, 0.337},
                                                           {0.003, 0.156, 0.087},
                                                           {0.105, 0.05, 0.672},
                                                           {0.006, 0.095, 0.479}}};
static_assert(part_tones.size() == static_cast<std::size_t>(PartTone::momentum) + 1, "a tone for each, in their order");
enum Mode { points = 0, lines = 1, triangles = 4 };

Numbers3 numbers(const Vector3<double>& v) {
  return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

// Of length one in single precision too; a direction that has none becomes the first.
template <std::size_t n>
std::array<float, n> unit(const std::array<double, n>& parts) {
  double square = 0;
  for (const double part : parts) square += part * part;
  const double length = std::sqrt(square);
  std::array<float, n> result{1};
  if (!(length > 0) || !std::isfinite(length)) return result;
  for (std::size_t i = 0; i < n; ++i) result[i] = static_cast<float>(parts[i] / length);
  return result;
}

// x, y, z, w
Numbers4 rotation(const Quaternion<double>& q) { return unit<4>({q.x, q.y, q.z, q.w}); }

class SceneWriter {
 public:
  SceneWriter(const scene::Scene& scene, const std::string& title) : scene_(scene), title_(title) {}

  std::string file() {
    Json children = Json::array();
    for (std::size_t i = 0; i < scene_.bodies.size(); ++i) {
      nodes_.push_back(body_node(i));
      children.push_back(nodes_.size() - 1);
    }
    const std::vector<MovingPart> parts = moving_parts(scene_);
    for (const MovingPart& part : parts) {
      nodes_.push_back(part_node(part));
      children.push_back(nodes_.size() - 1);
    }
    if (scene_.motion) add_animation(parts);
    Json root{{"name", title_.empty() ? "scene" : title_}, {"rotation", upright()}};
    if (!children.empty()) root["children"] = children;
    nodes_.push_back(root);
    Json content{{"asset", {{"version", "2.0"}, {"generator", "poinsot " + std::string(document::program_version())}}},
                 {"scene", 0},
                 {"scenes", Json::array({{{"nodes", Json::array({nodes_.size() - 1})}}})},
                 {"nodes", nodes_}};
    if (!meshes_.empty()) content["meshes"] = meshes_;
    if (!materials_.empty()) content["materials"] = materials_;
    if (!channels_.empty())
      content["animations"] = Json::array({{{"name", "motion"}, {"channels", channels_}, {"samplers", samplers_}}});
    return glb_.file(content);
  }

 private:
  // In glTF y points up: the turn that brings `up` there.
  Numbers4 upright() const {
    const Vector3<double> from = scene_.up / norm(scene_.up), to{0, 1, 0};
    const double cosine = dot(from, to);
    if (cosine < -0.999999) return {1, 0, 0, 0};
    const Vector3<double> axis = cross(from, to);
    return unit<4>({axis.x, axis.y, axis.z, 1 + cosine});
  }

  Json body_node(std::size_t index) {
    const scene::Body& body = scene_.bodies[index];
    Json node{
        {"name", body.name}, {"translation", numbers(body.pose.p)}, {"rotation", rotation(quaternion_of(body.pose.R))}};
    Json primitives = Json::array();
    for (const scene::Shape& shape : body.shapes) add_shape(primitives, shape, body, index);
    std::vector<Numbers3> arms;
    for (const auto& arm : arms_of(scene_, static_cast<int>(index)))
      for (const Vector3<double>& end : arm) arms.push_back(numbers(end));
    if (!arms.empty()) add_primitive(primitives, arms, {}, lines, material(body.name, index));
    if (!primitives.empty()) {
      meshes_.push_back({{"name", body.name}, {"primitives", primitives}});
      node["mesh"] = meshes_.size() - 1;
    }
    return node;
  }

  Json part_node(const MovingPart& part) {
    Json primitives = Json::array();
    const auto add = [&](const std::vector<Vector3<double>>& places, Mode mode) {
      std::vector<Numbers3> all;
      for (const Vector3<double>& place : places) all.push_back(numbers(place));
      add_primitive(primitives, all, {}, mode, tone(part.tone));
    };
    if (!part.shape.lines.empty()) add(part.shape.lines, lines);
    if (!part.shape.triangles.empty()) add(part.shape.triangles, triangles);
    meshes_.push_back({{"name", part.name}, {"primitives", primitives}});
    return {{"name", part.name},
            {"translation", numbers(part.now.place)},
            {"rotation", rotation(part.now.turn)},
            {"scale", numbers(part.now.stretch)},
            {"mesh", meshes_.size() - 1}};
  }

  void add_shape(Json& primitives, const scene::Shape& shape, const scene::Body& body, std::size_t index) {
    if (shape.extent == scene::Extent::point) {
      std::vector<Numbers3> places;
      for (const Vector3<double>& vertex : shape.vertices) places.push_back(numbers(vertex));
      add_primitive(primitives, places, {}, points, material(body.name, index));
      return;
    }
    if (!shape.hole) {
      std::vector<Numbers3> places, normals;
      for (std::size_t i = 0; i < shape.triangles.size(); ++i)
        for (std::size_t corner = 0; corner < 3; ++corner) {
          const Vector3<double>& normal = shape.normals[i][corner];
          places.push_back(numbers(shape.vertices[shape.triangles[i][corner]]));
          normals.push_back(unit<3>({normal.x, normal.y, normal.z}));
        }
      add_primitive(primitives, places, normals, triangles, material(body.name, index));
    }
    std::vector<Numbers3> ends;
    for (const std::vector<std::uint32_t>& edge : shape.edges)
      for (std::size_t i = 0; i + 1 < edge.size(); ++i)
        for (const std::uint32_t end : {edge[i], edge[i + 1]}) ends.push_back(numbers(shape.vertices[end]));
    const bool wire = shape.extent == scene::Extent::line;
    add_primitive(primitives, ends, {}, lines, wire ? material(body.name, index) : edges());
  }

  void add_primitive(Json& primitives, const std::vector<Numbers3>& places, const std::vector<Numbers3>& normals,
                     Mode mode, std::size_t material) {
    if (places.empty()) return;
    Json attributes{{"POSITION", glb_.add_vectors(places)}};
    if (!normals.empty()) attributes["NORMAL"] = glb_.add_vectors(normals);
    primitives.push_back({{"attributes", attributes}, {"mode", static_cast<int>(mode)}, {"material", material}});
  }

  std::size_t add_material(const std::string& name, const std::array<double, 3>& tone) {
    materials_.push_back(
        {{"name", name},
         {"pbrMetallicRoughness",
          {{"baseColorFactor", {tone[0], tone[1], tone[2], 1.0}}, {"metallicFactor", 0.0}, {"roughnessFactor", 0.9}}},
         {"doubleSided", true}});
    return materials_.size() - 1;
  }

  std::size_t material(const std::string& name, std::size_t body) {
    if (!of_body_ || of_body_->first != body) of_body_ = {body, add_material(name, tones[body % tones.size()])};
    return of_body_->second;
  }

  std::size_t edges() {
    if (!edges_) edges_ = add_material("edges", {0.02, 0.02, 0.02});
    return *edges_;
  }

  std::size_t tone(PartTone one) {
    const auto index = static_cast<std::size_t>(one);
    constexpr std::array<const char*, part_tones.size()> names{"cords",   "springs",    "curves",        "forces",
                                                               "couples", "velocities", "accelerations", "momenta"};
    if (!of_tones_[index]) of_tones_[index] = add_material(names[index], part_tones[index]);
    return *of_tones_[index];
  }

  // Times begin at zero and ascend in single precision too; what falls together there is left out.
  void add_animation(const std::vector<MovingPart>& parts) {
    const scene::Motion& motion = *scene_.motion;
    std::vector<float> times;
    std::vector<std::size_t> kept;
    for (std::size_t i = 0; i < motion.times.size(); ++i) {
      const auto time = static_cast<float>(motion.times[i] - motion.times.front());
      if (!times.empty() && !(time > times.back())) continue;
      times.push_back(time);
      kept.push_back(i);
    }
    if (times.size() < 2) return;
    const std::size_t input = glb_.add_scalars(times);
    for (std::size_t body = 0; body < scene_.bodies.size(); ++body) {
      std::vector<Numbers3> places;
      std::vector<Numbers4> turns;
      for (const std::size_t i : kept) {
        const scene::Pose& pose = motion.poses[i][body];
        places.push_back(numbers(pose.p));
        add_turn(turns, quaternion_of(pose.R));
      }
      add_channel(input, glb_.add_vectors(places), body, "translation");
      add_channel(input, glb_.add_quaternions(turns), body, "rotation");
    }
    for (std::size_t k = 0; k < parts.size(); ++k) {
      std::vector<Numbers3> places, stretches;
      std::vector<Numbers4> turns;
      for (const std::size_t i : kept) {
        const Stance& stance = parts[k].along[i];
        places.push_back(numbers(stance.place));
        stretches.push_back(numbers(stance.stretch));
        add_turn(turns, stance.turn);
      }
      const std::size_t node = scene_.bodies.size() + k;
      const auto changes = [](const auto& all, const auto& now) {
        return std::ranges::any_of(all, [&](const auto& one) { return one != now; });
      };
      if (changes(places, numbers(parts[k].now.place)))
        add_channel(input, glb_.add_vectors(places), node, "translation");
      if (changes(turns, rotation(parts[k].now.turn)))
        add_channel(input, glb_.add_quaternions(turns), node, "rotation");
      if (changes(stretches, numbers(parts[k].now.stretch)))
        add_channel(input, glb_.add_vectors(stretches), node, "scale");
    }
  }

  // Of the two quaternions of a turn the one nearer to that before, so that what lies between is short.
  static void add_turn(std::vector<Numbers4>& turns, const Quaternion<double>& next) {
    Numbers4 turn = rotation(next);
    if (!turns.empty()) {
      float cosine = 0;
      for (std::size_t k = 0; k < 4; ++k) cosine += turn[k] * turns.back()[k];
      if (cosine < 0)
        for (float& part : turn) part = -part;
    }
    turns.push_back(turn);
  }

  void add_channel(std::size_t input, std::size_t output, std::size_t node, const char* path) {
    samplers_.push_back({{"input", input}, {"output", output}, {"interpolation", "LINEAR"}});
    channels_.push_back({{"sampler", samplers_.size() - 1}, {"target", {{"node", node}, {"path", path}}}});
  }

  const scene::Scene& scene_;
  const std::string& title_;
  Glb glb_;
  Json nodes_ = Json::array(), meshes_ = Json::array(), materials_ = Json::array(), samplers_ = Json::array(),
       channels_ = Json::array();
  std::optional<std::pair<std::size_t, std::size_t>> of_body_{};  // the last body, and its material
  std::optional<std::size_t> edges_{};
  std::array<std::optional<std::size_t>, part_tones.size()> of_tones_{};
};

}  // namespace

std::string gltf_of(const scene::Scene& scene, const std::string& title) { return SceneWriter(scene, title).file(); }

}  // namespace poinsot::pictures

namespace poinsot {

std::string to_gltf(const Document& document, std::size_t solution) {
  const Solution& one = document.solutions.at(solution);
  if (!one.scene) throw std::invalid_argument("the solution has no scene");
  return pictures::gltf_of(*one.scene, document.title.empty() ? document.file : document.title);
}

}  // namespace poinsot
