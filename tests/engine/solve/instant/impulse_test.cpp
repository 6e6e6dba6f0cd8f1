#include "poinsot/engine/solve/instant/impulse.h"

#include <gtest/gtest.h>

#include <random>

#include "poinsot/engine/mass/composition.h"
#include "poinsot/engine/mass/shapes.h"
#include "poinsot/engine/model/builder.h"

namespace poinsot::solve {
namespace impulse_test {

using Vector = Vector3<double>;

class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}
  double number(double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine_); }
  Vector vector(double size) { return {number(-size, size), number(-size, size), number(-size, size)}; }
  MassProperties<double> body() {
    const Vector r{number(0.2, 1), number(0.2, 1), number(0.2, 1)};
    return of_mass(shapes::box(vector(0.3), {r.x, 0.0, 0.0}, {0.0, r.y, 0.0}, {0.0, 0.0, r.z}), number(0.5, 3));
  }

 private:
  std::mt19937_64 engine_;
};

Mechanism<double> mechanism_of(Model<double> tree) {
  Mechanism<double> mechanism;
  mechanism.tree = std::move(tree);
  mechanism.takes_part.assign(static_cast<std::size_t>(mechanism.tree.body_count()), true);
  mechanism.coordinate_names.assign(static_cast<std::size_t>(mechanism.tree.velocity_size()), "v");
  return mechanism;
}

// Two free bodies that strike each other at a point.
struct Collision {
  explicit Collision(std::uint64_t seed, double restitution) : random(seed) {
    ModelBuilder<double> builder;
    for (const char* name : {"one", "other"})
      builder.add_body(name, ground, Joint<double>::free(), SpatialTransform<double>::translation(random.vector(0.5)),
                       random.body());
    mechanism = mechanism_of(builder.build());
    mechanism.actions.push_back({ActionKind::impact, "stop", "", 0, 1});
    before.emplace(mechanism);
    std::vector<double> v(12);
    for (double& x : v) x = random.number(-2, 2);
    before->set_velocities(v);
    const Vector P = random.vector(0.6);
    const auto place = [&](int body) { return P - before->workspace().motion[static_cast<std::size_t>(body + 1)].p; };
    Impact impact{"stop", 0, 0, 1, {0, place(0)}, {1, normalized(random.vector(1))}, restitution};
    if (approach(*before, impact) > 0) impact.push.vector = -impact.push.vector;
    blow.impacts.push_back(impact);
  }
  Random random;
  Mechanism<double> mechanism;
  std::optional<MechanismState> before;
  Blow blow;
};

TEST(Impact, ConservesMomentaReversesTheApproachAndNeverGainsEnergy) {
  for (std::uint64_t seed = 0; seed < 1000; ++seed) {
    const double e = Random(seed).number(0, 1);
    Collision collision(seed, e);
    const MechanismState& before = *collision.before;
    const LinearSolution solution = solve_impulse(before, Scales{}, collision.blow, {}, {true});
    ASSERT_TRUE(solution.conflict.empty());
    ASSERT_TRUE(solution.open.empty());
    MechanismState after = before;
    after.set_velocities({solution.value.begin(), solution.value.begin() + 12});
    const Model<double>& tree = collision.mechanism.tree;
    const auto p0 = momentum(tree, before.workspace(), Vector::zero()),
               p1 = momentum(tree, after.workspace(), Vector::zero());
    EXPECT_LT(norm(p1.linear - p0.linear), 1e-10 * (1 + norm(p0.linear)));
    EXPECT_LT(norm(p1.angular - p0.angular), 1e-10 * (1 + norm(p0.angular)));
    const Impact& impact = collision.blow.impacts[0];
    EXPECT_NEAR(approach(after, impact), -e * approach(before, impact), 1e-10);
    EXPECT_GE(solution.value.back(), -1e-12) << "an impact pushes";
    const double T0 = kinetic_energy(tree, before.workspace()), T1 = kinetic_energy(tree, after.workspace());
    EXPECT_LE(T1, T0 * (1 + 1e-12));
    // Carnot: the loss is (1 - e^2)/2 times the impulse of a plastic impact times the approach, here from the impulse
    // itself.
    const double J = solution.value.back(), v = -approach(before, impact);
    EXPECT_NEAR(T0 - T1, 0.5 * J * v * (1 - e), 1e-9 * (1 + T0));
  }
}

// The limit of a stiff spring that acts for a short time, integrated with small steps: restitution 1.
TEST(Impact, AgreesWithAStiffShortForce) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    Collision collision(seed, 1.0);
    const MechanismState& before = *collision.before;
    const LinearSolution solution = solve_impulse(before, Scales{}, collision.blow, {}, {true});
    const Impact& impact = collision.blow.impacts[0];
    const Model<double>& tree = collision.mechanism.tree;
    const Vector P = before.position(impact.at), n = before.direction(impact.push);
    // In the frozen pose dv = M^-1 J^T dS: the gap rate changes linearly with the impulse until it is reversed.
    MechanismState now = before;
    std::vector<double> v = before.state().v;
    double gap = 0, gap_rate = approach(before, impact), impulse = 0;
    const double stiffness = 1e8, step = 1e-8;
    while (gap <= 0 || gap_rate < 0) {
      const double dS = stiffness * std::max(0.0, -gap) * step;
      for (const auto& [body, sign] : {std::pair{0, 1.0}, std::pair{1, -1.0}}) {
        const auto& motion = now.workspace().motion[static_cast<std::size_t>(body + 1)];
        const SpatialInertia<double>& I = tree.body(body).inertia;
        const Vector c = I.first_moment / I.mass, G = motion.p + motion.R * c;
        const SymmetricMatrix3<double> central = I.inertia - I.mass * unit_mass_inertia(c);
        const Vector dw = motion.R * (inverse(central) * transpose_times(motion.R, sign * dS * cross(P - G, n)));
        const Vector dv_G = (sign * dS / I.mass) * n, dv = dv_G - cross(dw, G - motion.p);
        for (std::size_t k = 0; k < 3; ++k) {
          v[static_cast<std::size_t>(6 * body) + k] += dw[k];
          v[static_cast<std::size_t>(6 * body + 3) + k] += dv[k];
        }
      }
      impulse += dS;
      now.set_velocities(v);
      gap_rate = approach(now, impact);
      gap += gap_rate * step;
      if (gap > 0 && gap_rate > 0) break;
    }
    for (std::size_t k = 0; k < v.size(); ++k)
      EXPECT_NEAR(v[k], solution.value[k], 2e-3 * (1 + std::abs(v[k]))) << seed;
    EXPECT_NEAR(impulse, solution.value.back(), 2e-3 * (1 + impulse));
  }
}

// A uniform rod on a pin, struck at a distance d: w = J d / (m L^2/3), pin impulse J (3 d/(2 L) - 1).
TEST(Impulse, ARodOnAPinFeelsNothingAtItsCenterOfPercussion) {
  for (const double d : {0.3, 2.0 / 3.0, 0.9}) {
    const double m = 2, L = 1, J = 5;
    ModelBuilder<double> builder;
    builder.add_body("rod", ground, Joint<double>::revolute({0.0, 0.0, 1.0}), SpatialTransform<double>::identity(),
                     of_mass(shapes::rod(Vector{0.0, 0.0, 0.0}, Vector{L, 0.0, 0.0}), m));
    Mechanism<double> mechanism = mechanism_of(builder.build());
    mechanism.actions.push_back({ActionKind::joint, "pin", "", 0, ground});
    mechanism.actions.push_back({ActionKind::impulse, "blow", "", 0, ground});
    for (std::size_t k = 0; k < 3; ++k)
      for (const bool couple : {false, true}) {
        if (couple && k == 2) continue;
        Component<double> component;
        component.action = 0;
        component.couple = couple;
        component.at = {0, Vector::zero()};
        component.along = {ground, Vector::unit(k)};
        mechanism.components.push_back(component);
      }
    const MechanismState before(mechanism);
    Blow blow;
    const Vector P{d, 0.0, 0.0}, F{0.0, J, 0.0};
    blow.impulses.push_back({1, 0, {cross(P, F), F}, 0, {}});
    const LinearSolution solution = solve_impulse(before, Scales{}, blow, {}, {true, true});
    ASSERT_TRUE(solution.open.empty());
    EXPECT_NEAR(solution.value[0], J * d / (m * L * L / 3), 1e-12);
    const SpatialForce<double> pin = action_impulse(before, blow, solution.value, 0);
    EXPECT_NEAR(pin.force.y, J * (1.5 * d / L - 1), 1e-12);
    EXPECT_NEAR(pin.force.x, 0, 1e-12);
  }
}

}  // namespace impulse_test
}  // namespace poinsot::solve
