// The pull of a center against the sum of the pulls on particles, each by itself.
#include "poinsot/engine/dynamics/attraction_law.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "poinsot/engine/dynamics/momentum.h"
#include "poinsot/engine/mass/particle_set.h"
#include "poinsot/engine/model/builder.h"
#include "poinsot/engine/model/state.h"

namespace poinsot {
namespace attraction_law_test {

using Long = long double;
using LongVector = Vector3<Long>;

LongVector widened(const Vector3<double>& a) { return {a.x, a.y, a.z}; }

class RandomNumbers {
 public:
  explicit RandomNumbers(unsigned seed) : random_(seed) {}
  double number(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  Vector3<double> vector(double size) { return {number(-size, size), number(-size, size), number(-size, size)}; }

 private:
  std::mt19937_64 random_;
};

struct Pull {
  LongVector force = LongVector::zero(), couple = LongVector::zero();  // about the mass center
  Long energy = 0;
};

// Of particles that a pose takes to R d + p, by Newton's law.
Pull pull_on(const std::vector<Particle<double>>& particles, const Vector3<double>& G, const Matrix3<double>& R,
             const Vector3<double>& p, const Vector3<double>& center, double parameter) {
  Pull sum;
  const auto placed = [&](const Vector3<double>& d) {
    LongVector x = widened(p);
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t k = 0; k < 3; ++k) x[i] += Long(R(static_cast<int>(i), static_cast<int>(k))) * Long(d[k]);
    return x;
  };
  for (const Particle<double>& one : particles) {
    const LongVector x = placed(one.position), way = x - widened(center);
    const Long r = norm(way), strength = Long(parameter) * one.mass;
    const LongVector force = -(strength / (r * r * r)) * way;
    sum.force += force;
    sum.couple += cross(LongVector(x - placed(G)), force);
    sum.energy -= strength / r;
  }
  return sum;
}

struct Body {
  std::vector<Particle<double>> particles;
  MassProperties<double> mass;
  double reach = 0, spread = 0;  // the farthest particle from the center, and the sum of m d^2
};
Body some_body(RandomNumbers& random) {
  Body body;
  for (int i = 0; i < 7; ++i) body.particles.push_back({random.number(0.2, 2), random.vector(1)});
  body.mass = mass_properties(body.particles);
  for (const Particle<double>& one : body.particles) {
    const Vector3<double> d = one.position - body.mass.center;
    body.reach = std::max(body.reach, norm(d));
    body.spread += one.mass * norm_squared(d);
  }
  return body;
}

// The sum of (n + 1) e^(n-2) over n from 3.
double tail(double e) { return (1 / ((1 - e) * (1 - e)) - 1 - 2 * e - 3 * e * e) / (e * e); }

TEST(AttractionLaw, IsThatOfTheParticlesUpToWhatItsTextSaysIsLeftOut) {
  RandomNumbers random(17);
  int tried = 0;
  double least_used = 1, most_used = 0;
  for (; tried < 300; ++tried) {
    const Body body = some_body(random);
    ModelBuilder<double> builder;
    builder.add_body("a", ground, Joint<double>::free(), {Matrix3<double>::identity(), Vector3<double>::zero()},
                     body.mass);
    const Model<double> tree = builder.build();
    State<double> state = neutral_state(tree);
    for (double& v : state.v) v = random.number(-2, 2);
    integrate_position<double>(tree, state.q, state.v, 1.0);
    Workspace<double> workspace(tree);
    update_velocities(tree, workspace, state);
    const double far = std::pow(10.0, random.number(0.5, 2.5));
    const Vector3<double> center = far * body.reach * normalized(random.vector(1));
    const double parameter = random.number(0.5, 50);
    const AttractionLaw<double> law{0,
                                    {0, body.mass.center},
                                    {ground, center},
                                    parameter,
                                    {{body.mass.center, body.mass.mass, true, body.mass.inertia_center, body.reach}}};
    const Vector3<double> G = body_mass_center(tree, workspace, 0);
    const Vector3<double> p = point_position(tree, workspace, 0, Vector3<double>::zero());
    const Pull exact =
        pull_on(body.particles, body.mass.center, body_rotation(tree, workspace, 0), p, center, parameter);
    const double r = norm(Vector3<double>(G - center)), e = body.reach / r;
    if (e > 0.5) continue;
    const SpatialForce<double> found = wrench_about(law.exerted(tree, workspace), G);
    const double left = parameter * body.spread * tail(e) / (r * r * r), rounding = 1e-15 * parameter * body.mass.mass;
    EXPECT_LE(norm(LongVector(widened(found.force) - exact.force)), left / r + rounding / (r * r)) << r;
    EXPECT_LE(norm(LongVector(widened(found.moment) - exact.couple)), left + rounding / r) << r;
    EXPECT_LE(std::abs(Long(law.stored_energy(tree, workspace)) - exact.energy), left + 4 * rounding / r) << r;
    // A particle in its place would be off by more: the second order is there, and with its sign.
    const AttractionLaw<double> as_particle{0, law.at, law.toward, parameter, {{body.mass.center, body.mass.mass}}};
    const Long off = norm(LongVector(widened(as_particle.exerted(tree, workspace).force) - exact.force)),
               off_by_moments = norm(LongVector(widened(found.force) - exact.force));
    if (e < 0.02) {
      EXPECT_LT(off_by_moments, off);
    }
    most_used = std::max(most_used, static_cast<double>(norm(LongVector(widened(found.moment) - exact.couple)) / left));
    least_used = std::min(least_used, e);
  }
  EXPECT_EQ(tried, 300);
  // The bound is no empty one, and far distances were among them.
  EXPECT_GT(most_used, 0.02);
  EXPECT_LT(least_used, 0.01);
}

TEST(AttractionLaw, OfAParticleIsNewtons) {
  ModelBuilder<double> builder;
  builder.add_body("a", ground, Joint<double>::free(), {Matrix3<double>::identity(), Vector3<double>::zero()},
                   {2, {0, 0, 0}, SymmetricMatrix3<double>::diagonal(1, 2, 2.5)});
  const Model<double> tree = builder.build();
  Workspace<double> workspace(tree);
  update_velocities(tree, workspace, neutral_state(tree));
  const AttractionLaw<double> law{0, {0, {1, 2, 2}}, {ground, {0, 0, 0}}, 18, {{{1, 2, 2}, 2}}};
  const PlacedForce<double> found = law.exerted(tree, workspace);
  EXPECT_NEAR(found.force.x, -4.0 / 3, 1e-15);
  EXPECT_NEAR(found.force.y, -8.0 / 3, 1e-15);
  EXPECT_NEAR(found.force.z, -8.0 / 3, 1e-15);
  EXPECT_EQ(norm(found.couple), 0);
  EXPECT_NEAR(law.stored_energy(tree, workspace), -12, 1e-14);
}

}  // namespace attraction_law_test
}  // namespace poinsot
