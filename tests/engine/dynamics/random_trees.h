// Random trees of bodies for the tests of the dynamics, stated plainly (parents, joints, placements, masses), so that
// an oracle can read the same statement without the model.
#pragma once

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "poinsot/engine/model/builder.h"
#include "poinsot/engine/model/state.h"

namespace poinsot::testing {

class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}
  double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine_); }
  int integer(int low, int high) { return std::uniform_int_distribution<int>(low, high)(engine_); }
  bool chance(double probability) { return uniform(0.0, 1.0) < probability; }
  Vector3<double> vector(double size = 1.0) {
    return {uniform(-size, size), uniform(-size, size), uniform(-size, size)};
  }
  Vector3<double> direction() {
    for (;;) {
      const Vector3<double> a = vector();
      const double length = norm(a);
      if (length > 0.1 && length < 1.0) return a / length;
    }
  }
  Matrix3<double> rotation() { return rotation_about(direction(), uniform(-3.1, 3.1)); }
  SpatialTransform<double> pose() { return {rotation(), vector()}; }
  std::vector<double> numbers(int count, double size) {
    std::vector<double> x(count);
    for (double& entry : x) entry = uniform(-size, size);
    return x;
  }
  // A body of a few particles: every inertia made so is possible.
  MassProperties<double> mass() {
    MassProperties<double> body{0.0, Vector3<double>::zero(), SymmetricMatrix3<double>::zero()};
    std::vector<std::pair<double, Vector3<double>>> particles;
    for (int i = 0; i < 5; ++i) particles.push_back({uniform(0.1, 1.0), vector(0.6)});
    for (const auto& [m, r] : particles) {
      body.mass += m;
      body.center += m * r;
    }
    body.center = body.center / body.mass;
    for (const auto& [m, r] : particles) body.inertia_center += m * unit_mass_inertia(r - body.center);
    return body;
  }
  SpatialForce<double> wrench(double size) { return {vector(size), vector(size)}; }

 private:
  std::mt19937_64 engine_;
};

struct StatedBody {
  int parent;
  Joint<double> joint;
  SpatialTransform<double> placement;
  MassProperties<double> mass;
  std::vector<CoordinateMode> modes;
};

struct StatedTree {
  std::vector<StatedBody> bodies;
  Vector3<double> gravity;
};

struct TreeOptions {
  int least_bodies = 1;
  int most_bodies = 7;
  bool given_coordinates = false;  // some coordinates prescribed or locked
  bool massless_bodies = true;     // some joints are chains with massless bodies between
};

inline Joint<double> random_joint(Random& random) {
  switch (random.integer(0, 9)) {
    case 0:
      return Joint<double>::weld();
    case 1:
      return Joint<double>::prismatic(random.uniform(0.5, 2.0) * random.direction());
    case 2:
      return Joint<double>::screw(random.direction(), random.uniform(-0.5, 0.5));
    case 3:
      return Joint<double>::ball();
    case 4:
      return Joint<double>::free();
    case 5:
      return Joint<double>::revolute(Vector3<double>::unit(static_cast<std::size_t>(random.integer(0, 2))));
    default:
      return Joint<double>::revolute(random.uniform(0.5, 2.0) * random.direction());
  }
}

inline StatedTree random_tree(Random& random, const TreeOptions& options = {}) {
  StatedTree tree;
  tree.gravity = random.vector(10.0);
  const int count = random.integer(options.least_bodies, options.most_bodies);
  const MassProperties<double> massless{0.0, Vector3<double>::zero(), SymmetricMatrix3<double>::zero()};
  std::vector<int> massive{ground};
  for (int i = 0; i < count; ++i) {
    const auto add = [&](int parent, const Joint<double>& joint, const MassProperties<double>& mass) {
      StatedBody body{parent, joint, random.pose(), mass, {}};
      for (int k = 0; k < velocity_size(joint.type); ++k) {
        const int mode = options.given_coordinates ? random.integer(0, 5) : 5;
        body.modes.push_back(mode == 0   ? CoordinateMode::locked
                             : mode <= 2 ? CoordinateMode::prescribed
                                         : CoordinateMode::free);
      }
      tree.bodies.push_back(body);
      return static_cast<int>(tree.bodies.size()) - 1;
    };
    int parent = massive[static_cast<std::size_t>(random.integer(0, static_cast<int>(massive.size()) - 1))];
    if (options.massless_bodies && random.chance(0.25)) {
      parent = add(parent, Joint<double>::revolute(random.direction()), massless);
      massive.push_back(add(parent, Joint<double>::revolute(random.direction()), random.mass()));
    } else {
      massive.push_back(add(parent, random_joint(random), random.mass()));
    }
  }
  return tree;
}

template <class Scalar>
Vector3<Scalar> cast(const Vector3<double>& a) {
  return {Scalar(a.x), Scalar(a.y), Scalar(a.z)};
}
template <class Scalar>
SymmetricMatrix3<Scalar> cast(const SymmetricMatrix3<double>& a) {
  return {Scalar(a.xx), Scalar(a.yy), Scalar(a.zz), Scalar(a.xy), Scalar(a.yz), Scalar(a.zx)};
}
template <class Scalar>
std::vector<Scalar> cast(const std::vector<double>& a) {
  return std::vector<Scalar>(a.begin(), a.end());
}
template <class Scalar>
State<Scalar> cast(const State<double>& state) {
  return {cast<Scalar>(state.q), cast<Scalar>(state.v)};
}

inline Model<double> built(const StatedTree& tree) {
  ModelBuilder<double> builder;
  builder.set_gravity(tree.gravity);
  for (std::size_t i = 0; i < tree.bodies.size(); ++i) {
    const StatedBody& body = tree.bodies[i];
    const int index = builder.add_body("body " + std::to_string(i), body.parent, body.joint, body.placement, body.mass);
    for (std::size_t k = 0; k < body.modes.size(); ++k) builder.set_mode(index, static_cast<int>(k), body.modes[k]);
  }
  return builder.build();
}

// Random angles, displacements, attitudes and rates.
inline State<double> random_state(Random& random, const Model<double>& model) {
  State<double> state{random.numbers(model.position_size(), 2.0), random.numbers(model.velocity_size(), 2.0)};
  for (const Body<double>& body : model.bodies()) {
    if (body.joint == JointType::ball || body.joint == JointType::free) {
      const Vector3<double> turn = random.uniform(0.0, 3.1) * random.direction();
      const Quaternion<double> attitude = quaternion_exponential(turn);
      state.q[body.q] = attitude.w;
      state.q[body.q + 1] = attitude.x;
      state.q[body.q + 2] = attitude.y;
      state.q[body.q + 3] = attitude.z;
    }
  }
  return state;
}

// Largest difference of two lists, relative to the largest entry of the second (at least 1).
template <class A, class B>
double relative_difference(const A& a, const B& b) {
  if (a.size() != b.size()) return INFINITY;
  double largest = 1.0;
  double difference = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    largest = std::max(largest, std::fabs(static_cast<double>(b[i])));
    const double d = std::fabs(static_cast<double>(a[i] - b[i]));
    if (!(d <= difference)) difference = d;  // NaN stays
  }
  return difference / largest;
}
template <class Scalar>
double relative_difference(const Vector3<Scalar>& a, const Vector3<Scalar>& b) {
  return relative_difference(std::vector<Scalar>{a.x, a.y, a.z}, std::vector<Scalar>{b.x, b.y, b.z});
}

}  // namespace poinsot::testing
