#include "models.h"

#include <random>

namespace poinsot::bench {
namespace {

class Random {
 public:
  double number(double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine_); }
  Vector3<double> vector(double size) { return {number(-size, size), number(-size, size), number(-size, size)}; }
  Vector3<double> direction() { return normalized(vector(1.0) + Vector3<double>{0.0, 0.0, 1.1}); }
  SpatialTransform<double> pose(double size) { return {rotation_exponential(vector(1.5)), vector(size)}; }
  MassProperties<double> mass() {
    const Matrix3<double> R = rotation_exponential(vector(1.0));
    return {number(0.5, 3.0), vector(0.1),
            turned(R, SymmetricMatrix3<double>::diagonal(number(0.02, 0.03), number(0.02, 0.03), number(0.02, 0.03)))};
  }

 private:
  std::mt19937_64 engine_{18};
};

const Vector3<double> x = Vector3<double>::unit(0);
const Vector3<double> y = Vector3<double>::unit(1);
const Vector3<double> z = Vector3<double>::unit(2);

// A chain of hinges, each 0.3 m beyond the last.
StatedModel chain(const std::string& name, const std::vector<Vector3<double>>& axes, Random& random) {
  StatedModel model{name, {}};
  for (std::size_t i = 0; i < axes.size(); ++i) {
    const Vector3<double> place = i == 0 ? Vector3<double>::zero() : Vector3<double>{0.05, 0.1, 0.28};
    model.bodies.push_back({static_cast<int>(i) - 1, Joint<double>::revolute(axes[i]),
                            SpatialTransform<double>::translation(place), random.mass()});
  }
  return model;
}

// A floating base with two legs of six hinges, a torso of two, and two arms of six on it: 32 degrees of freedom.
StatedModel humanoid(Random& random) {
  StatedModel model{"humanoid, 32 dof", {{ground, Joint<double>::free(), {}, random.mass()}}};
  const auto limb = [&](int parent, const std::vector<Vector3<double>>& axes) {
    for (const Vector3<double>& axis : axes) {
      model.bodies.push_back({parent, Joint<double>::revolute(axis), random.pose(0.3), random.mass()});
      parent = static_cast<int>(model.bodies.size()) - 1;
    }
    return parent;
  };
  limb(0, {x, y, z, y, y, x});
  limb(0, {x, y, z, y, y, x});
  const int chest = limb(0, {y, z});
  limb(chest, {x, y, z, y, y, x});
  limb(chest, {x, y, z, y, y, x});
  return model;
}

}  // namespace

std::vector<StatedModel> stated_models() {
  Random random;
  std::vector<StatedModel> models;
  models.push_back({"free body", {{ground, Joint<double>::free(), {}, random.mass()}}});
  MassProperties<double> top = random.mass();
  top.center = {0.0, 0.0, 0.5};
  models.push_back({"heavy top (ball joint)", {{ground, Joint<double>::ball(), {}, top}}});
  models.push_back(chain("arm of 7, axes z and y", {z, y, z, y, z, y, z}, random));
  std::vector<Vector3<double>> slanted;
  for (int i = 0; i < 7; ++i) slanted.push_back(random.direction());
  models.push_back(chain("arm of 7, slanted axes", slanted, random));
  models.push_back(humanoid(random));
  for (const int count : {10, 100, 1000}) {
    std::vector<Vector3<double>> axes;
    for (int i = 0; i < count; ++i) axes.push_back(i % 2 == 0 ? y : x);
    models.push_back(chain("chain of " + std::to_string(count), axes, random));
  }
  return models;
}

Model<double> built(const StatedModel& stated) {
  ModelBuilder<double> builder;
  builder.set_gravity({0.0, 0.0, -9.81});
  for (const StatedBody& body : stated.bodies) {
    std::string name = "body ";
    name += std::to_string(&body - stated.bodies.data());
    builder.add_body(name, body.parent, body.joint, body.placement, body.mass);
  }
  return builder.build();
}

std::vector<Sample> samples(const Model<double>& model, int count) {
  Random random;
  std::vector<Sample> list;
  for (int i = 0; i < count; ++i) {
    Sample sample{neutral_state(model), std::vector<double>(model.velocity_size())};
    for (double& v : sample.state.v) v = random.number(-1.0, 1.0);
    integrate_position<double>(model, sample.state.q, sample.state.v, 1.5);
    for (double& v : sample.state.v) v = random.number(-1.0, 1.0);
    for (double& g : sample.given) g = random.number(-1.0, 1.0);
    list.push_back(sample);
  }
  return list;
}

}  // namespace poinsot::bench
