#include "poinsot/engine/mass/particles.h"

#include <numbers>
#include <stdexcept>

#include "engine/mass/random_shapes.h"
#include "poinsot/engine/mass/principal_axes.h"

namespace poinsot {
namespace particles_test {

using testing::near;
using testing::Random;
using Vector = Vector3<double>;

TEST(Cubature, GaussRulesAreExactToTheirDegree) {
  for (int n = 1; n <= cubature::points_on_arc; ++n) {
    const auto nodes = cubature::gauss_nodes<double>(n);
    for (int degree = 0; degree <= 2 * n - 1; ++degree) {
      double integral = 0;
      for (const auto& node : nodes) integral += node.weight * std::pow(node.at, degree);
      EXPECT_NEAR(integral, 1.0 / (degree + 1), 1e-14) << n << " points, degree " << degree;
    }
    // One degree further the rule fails: its error is (n!)^4 / ((2n + 1) (2n)!^2).
    if (n <= 5) {
      double integral = 0;
      for (const auto& node : nodes) integral += node.weight * std::pow(node.at, 2 * n);
      const double error = std::pow(std::tgamma(n + 1.0), 4) / ((2 * n + 1) * std::pow(std::tgamma(2 * n + 1.0), 2));
      EXPECT_NEAR(1.0 / (2 * n + 1) - integral, error, 1e-14);
    }
  }
}

TEST(Cubature, ArcRuleIsExactToRoundingForAFullTurn) {
  long double cosines = 0;
  long double squares = 0;
  for (const auto& node : cubature::gauss<cubature::points_on_arc, long double>()) {
    const long double angle = 2 * std::numbers::pi_v<long double> * node.at;
    cosines += node.weight * std::cos(angle);
    squares += node.weight * std::cos(angle) * std::cos(angle);
  }
  EXPECT_NEAR(static_cast<double>(cosines), 0, 1e-18);
  EXPECT_NEAR(static_cast<double>(squares - 0.5L), 0, 1e-18);
}

TEST(Cubature, TriadsAreRightHanded) {
  Random<double> random(3);
  for (int i = 0; i < 1000; ++i) {
    const Vector direction = random.direction();
    const Vector toward = random.across(direction);
    for (const auto& triad : {cubature::Triad<double>(direction), cubature::Triad<double>(direction, toward)}) {
      EXPECT_TRUE(near(cross(triad.first, triad.second), triad.third, 1e-14));
      EXPECT_TRUE(near(triad.third, normalized(direction), 1e-14));
      EXPECT_NEAR(norm(triad.first), 1, 1e-14);
      EXPECT_NEAR(dot(triad.first, triad.third), 0, 1e-14);
    }
    EXPECT_GT(dot(cubature::Triad<double>(direction, toward).first, toward), 0);
  }
}

TEST(Particles, FractionsAddUpToOne) {
  const Vector O = Vector::zero();
  const Vector z = Vector::unit(2);
  for (const auto& set :
       {particles::rod(O, z), particles::torus(O, z, 2.0, 0.5), particles::sector(O, z, 1.0, Vector::unit(0), 1.0),
        particles::hemisphere(O, z, 1.0), particles::particle(z)}) {
    double total = 0;
    for (const auto& p : set.particles) total += p.fraction;
    EXPECT_NEAR(total, 1, 1e-14);
  }
}

TEST(Particles, WithoutMassInTotalInertiaIsAboutOrigin) {
  const auto body = mass_properties<double>({{1, {1, 0, 0}}, {-1, {0, 2, 0}}});
  EXPECT_EQ(body.mass, 0);
  EXPECT_EQ(norm(body.center), 0);
  EXPECT_EQ(body.inertia_center.zz, 1 - 4);
}

template <class Scalar>
void expect_equivalent_particles(double tolerance) {
  Random<Scalar> random(4);
  for (int i = 0; i < 1000; ++i) {
    const auto body = random.body();
    const auto particles = equivalent_particles(body);
    ASSERT_EQ(particles.size(), 6u);
    EXPECT_TRUE(near(mass_properties(particles), body, tolerance));
    EXPECT_TRUE(
        near(mass_properties(equivalent_particles(scaled(Scalar(-1), body))), scaled(Scalar(-1), body), tolerance));
  }
}
TEST(EquivalentParticles, HaveTheBodysProperties) {
  expect_equivalent_particles<double>(1e-12);
  expect_equivalent_particles<long double>(1e-15);
}

TEST(EquivalentParticles, ThinBodiesAndSymmetricBodies) {
  const Vector A{1, 2, 3};
  const Vector B{2, 0, 5};
  for (const auto& shape : {shapes::particle(A), shapes::rod(A, B), shapes::disk(A, B, 0.5), shapes::sphere(A, 1.0),
                            shapes::polygon<double>({A, B, Vector{0, 1, 0}})}) {
    const auto body = of_mass(shape, 2.0);
    const auto sum = mass_properties(equivalent_particles(body));
    EXPECT_DOUBLE_EQ(sum.mass, body.mass);
    EXPECT_TRUE(near(sum.center, body.center, 1e-14));
    EXPECT_LE(testing::largest_entry(sum.inertia_center - body.inertia_center), 1e-13);
  }
  EXPECT_TRUE(equivalent_particles(massless<double>()).empty());
}

TEST(EquivalentParticles, ImpossibleMomentsAreRefused) {
  const MassProperties<double> body{1, Vector::zero(), SymmetricMatrix3<double>::diagonal(2, 3, 7)};
  try {
    equivalent_particles(body);
    FAIL() << "no error";
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(
        error.what(),
        "no particles have the principal moments 2, 3, 7 m^2 per unit mass: each must be at most the sum of the "
        "two others");
  }
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(equivalent_particles({1.0, Vector::zero(), SymmetricMatrix3<double>::diagonal(nan, 1, 1)}),
               std::invalid_argument);
}

}  // namespace particles_test
}  // namespace poinsot
