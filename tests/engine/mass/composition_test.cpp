#include "poinsot/engine/mass/composition.h"

#include "engine/mass/random_shapes.h"

namespace poinsot {
namespace composition_test {

using testing::near;
using testing::Random;
using Vector = Vector3<double>;
using Body = MassProperties<double>;

std::vector<Particle<double>> random_particles(Random<double>& random, int count) {
  std::vector<Particle<double>> particles;
  for (int i = 0; i < count; ++i) particles.push_back({random.between(0.1, 2), random.point()});
  return particles;
}

TEST(Composition, SumOfPartsIsSumOfTheirParticles) {
  Random<double> random(5);
  for (int i = 0; i < 1000; ++i) {
    std::vector<Particle<double>> all;
    std::vector<Body> bodies;
    for (int part = random.whole(1, 5); part > 0; --part) {
      auto particles = random_particles(random, random.whole(1, 6));
      // Some parts are holes, but the first is heavy.
      if (part > 1 && random.whole(0, 3) == 0) {
        for (auto& p : particles) p.mass *= -0.1;
      }
      bodies.push_back(mass_properties(particles));
      all.insert(all.end(), particles.begin(), particles.end());
    }
    ASSERT_TRUE(near(sum(bodies), mass_properties(all), 1e-10));
  }
}

TEST(Composition, SumDoesNotDependOnOrderAndTakesMasslessParts) {
  Random<double> random(6);
  for (int i = 0; i < 100; ++i) {
    const Body a = random.body();
    const Body b = random.body();
    const Body c = random.body();
    EXPECT_TRUE(near(sum<double>({a, b, c}), sum<double>({c, sum<double>({massless<double>(), b, a})}), 1e-12));
    // A part taken away again.
    EXPECT_TRUE(near(sum<double>({a, b, scaled(-1.0, b)}), a, 1e-11));
  }
  const Body nothing = sum<double>({massless<double>(), massless<double>()});
  EXPECT_EQ(nothing.mass, 0);
  EXPECT_EQ(norm(nothing.center), 0);
  EXPECT_EQ(testing::largest_entry(nothing.inertia_center), 0);
  const Body empty = sum<double>({});
  EXPECT_EQ(empty.mass, 0);
  // Mass and hole of equal size: the inertia is about the origin.
  const Body couple =
      sum<double>({of_mass(shapes::particle(Vector{1, 0, 0}), 1.0), of_mass(shapes::particle(Vector{0, 2, 0}), -1.0)});
  EXPECT_EQ(couple.mass, 0);
  EXPECT_EQ(couple.inertia_center.zz, -3);
}

// Parts in one place have that place for their center, and particles there no moment of inertia at all.
TEST(Composition, PartsInOnePlaceKeepTheirCenterToTheLastDigit) {
  Random<double> random(61);
  int off = 0;
  for (int i = 0; i < 1000; ++i) {
    const Vector place = random.point();
    std::vector<Body> bodies;
    if (random.whole(0, 1) == 1) bodies.push_back(massless<double>());
    double mass = 0;
    Vector first_moment = Vector::zero();
    for (int part = random.whole(1, 5); part > 0; --part) {
      bodies.push_back(of_mass(shapes::particle(place), random.between(0.1, 20)));
      mass += bodies.back().mass;
      first_moment += bodies.back().mass * place;
    }
    const Body whole = sum(bodies);
    ASSERT_EQ(norm(whole.center - place), 0);
    ASSERT_EQ(testing::largest_entry(whole.inertia_center), 0);
    off += norm(first_moment / mass - place) > 0;
  }
  EXPECT_GT(off, 100) << "by first moments about the origin the center is often off";
}

TEST(Composition, ParallelAxesBothWays) {
  Random<double> random(7);
  for (int i = 0; i < 1000; ++i) {
    const auto particles = random_particles(random, 5);
    const Body body = mass_properties(particles);
    const Vector P = random.point();
    // By the definition about P.
    auto about_P = SymmetricMatrix3<double>::zero();
    for (const auto& p : particles) about_P += p.mass * unit_mass_inertia(p.position - P);
    EXPECT_TRUE(near(inertia_about(body, P), about_P, 1e-12));
    EXPECT_TRUE(near(from_inertia_about(P, body.mass, body.center, about_P), body, 1e-11));
    EXPECT_TRUE(near(
        from_moments_and_products(P, body.mass, body.center, moments_of_inertia(about_P), products_of_inertia(about_P)),
        body, 1e-11));
    // Moments about the mass center are the smallest.
    EXPECT_LE(moment_about_axis(body, body.center, P), moment_about_axis(body, random.point(), P) * (1 + 1e-12));
    // About a line: the sum of m times the squared distance from it.
    const Vector n = random.unit();
    double moment = 0;
    for (const auto& p : particles) moment += p.mass * norm_squared(cross(n, p.position - P));
    EXPECT_TRUE(near(moment_about_axis(body, P, Vector(3.0 * n)), moment, 1e-12));
  }
}

TEST(Composition, MovedTurnedAndMirroredBodiesAreThatOfTheirParticles) {
  Random<double> random(8);
  for (int i = 0; i < 1000; ++i) {
    const auto particles = random_particles(random, 5);
    const Body body = mass_properties(particles);
    const Matrix3<double> R = transpose(random.axes());
    const Vector p = random.point();
    const Vector n = random.unit();
    auto moved = particles;
    auto turned = particles;
    auto both = particles;
    auto image = particles;
    for (std::size_t k = 0; k < particles.size(); ++k) {
      const Vector r = particles[k].position;
      moved[k].position = r + p;
      turned[k].position = R * r;
      both[k].position = R * r + p;
      image[k].position = r - 2.0 * dot(r - p, n) * n;
    }
    EXPECT_TRUE(near(translated(p, body), mass_properties(moved), 1e-12));
    EXPECT_TRUE(near(rotated(R, body), mass_properties(turned), 1e-12));
    EXPECT_TRUE(near(transformed(R, p, body), mass_properties(both), 1e-12));
    EXPECT_TRUE(near(mirrored(p, Vector(2.5 * n), body), mass_properties(image), 1e-12));
    EXPECT_TRUE(near(mirrored(p, n, mirrored(p, n, body)), body, 1e-12));
    // A body and its mirror image have no products of inertia with the normal.
    const Body pair = sum<double>({body, mirrored(p, n, body)});
    EXPECT_TRUE(near(cross(pair.inertia_center * n, n), Vector::zero(), 1e-10));
  }
}

TEST(Composition, ProductsOfInertiaHaveThePlusSign) {
  // One particle: I_xy = m x y (Eq. 18.6), and the tensor holds minus that (Eq. 18.8).
  const auto body = of_mass(shapes::particle(Vector{2, 3, 5}), 2.0);
  const auto tensor = inertia_about(body, Vector::zero());
  const auto products = products_of_inertia(tensor);
  EXPECT_EQ(products.xy, 12);
  EXPECT_EQ(products.yz, 30);
  EXPECT_EQ(products.zx, 20);
  EXPECT_EQ(tensor.xy, -12);
  const auto back = inertia_tensor(moments_of_inertia(tensor), products);
  EXPECT_EQ(testing::largest_entry(back - tensor), 0);
}

TEST(Composition, RadiiOfGyration) {
  // A box by the radii of its table entry, on turned axes and about a corner.
  Random<double> random(9);
  for (int i = 0; i < 200; ++i) {
    const auto axes = random.axes();
    const Vector size{random.length(), random.length(), random.length()};
    const Vector C = random.point();
    const Body box = of_mass(shapes::box(C, Vector(size.x * axes.column(0)), Vector(size.y * axes.column(1)),
                                         Vector(size.z * axes.column(2))),
                             4.0);
    const Vector radii{std::hypot(size.y, size.z) / std::sqrt(12.0), std::hypot(size.z, size.x) / std::sqrt(12.0),
                       std::hypot(size.x, size.y) / std::sqrt(12.0)};
    EXPECT_TRUE(near(from_radii_of_gyration(4.0, C, radii, axes), box, 1e-12));
  }
  // A rod about its end has the radius l/sqrt(3).
  const double k = 2 / std::sqrt(3.0);
  EXPECT_TRUE(near(from_radii_of_gyration_about(Vector{1, 1, 1}, 5.0, Vector{1, 1, 2}, Vector{k, k, 0}),
                   of_mass(shapes::rod(Vector{1, 1, 1}, Vector{1, 1, 3}), 5.0), 1e-14));
}

TEST(Composition, AxisymmetricBodies) {
  Random<double> random(10);
  for (int i = 0; i < 200; ++i) {
    const Vector apex = random.point();
    const Vector base = random.point_apart_from(apex);
    const double r = random.length();
    const double h = norm(base - apex);
    const Body cone = of_mass(shapes::cone(apex, base, r), 2.0);
    EXPECT_TRUE(near(axisymmetric(2.0, cone.center, Vector(base - apex), 0.6 * r * r, 0.3 * r * r + 0.075 * h * h),
                     cone, 1e-12));
    // About its apex, as for a top: 3/5 m (r^2/4 + h^2).
    EXPECT_TRUE(
        near(axisymmetric_about(apex, 2.0, cone.center, Vector(apex - base), 0.6 * r * r, 1.2 * (r * r / 4 + h * h)),
             cone, 1e-11));
  }
}

TEST(Composition, ALoneParticleGetsNoInertiaFromRounding) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> within(-3, 3);
  for (int i = 0; i < 1000; ++i) {
    MassProperties<double> particle = massless<double>();
    particle.mass = std::exp(within(random));
    particle.center = {within(random), within(random), within(random)};
    const MassProperties<double> whole = sum<double>({particle});
    EXPECT_EQ(norm(whole.center - particle.center), 0);
    EXPECT_EQ(whole.inertia_center.xx + whole.inertia_center.yy + whole.inertia_center.zz, 0);
  }
}

}  // namespace composition_test
}  // namespace poinsot
