#include "poinsot/engine/dynamics/contact_surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engine/dynamics/random_trees.h"
#include "poinsot/engine/dynamics/velocity_constraint.h"
#include "poinsot/engine/solve/instant/contact_curvature.h"

namespace poinsot {
namespace contact_surface_test {

using testing::Random;
using Vector = Vector3<double>;
using Surface = ContactSurface<double>;
using enum SurfaceKind;

Surface made(Random& random, SurfaceKind kind, double size) {
  Surface s;
  s.kind = kind;
  s.center = 0.2 * size * random.direction();
  s.axis = random.direction();
  s.radius = size * random.uniform(0.8, 1.2);
  s.tube = size * random.uniform(0.1, 0.3);
  const double angle = random.uniform(0.2, 1);
  if (kind == cone) {
    s.sine = std::sin(angle);
    s.cosine = std::cos(angle);
  }
  const Vector a = random.direction(), b = normalized(cross(a, random.direction()));
  s.semi_axes = {size * random.uniform(0.8, 1.1) * a, size * random.uniform(0.8, 1.1) * b,
                 size * random.uniform(0.5, 0.8) * cross(a, b)};
  return s;
}

// The distance from the surface to first order, by its equation.
double off(const Surface& s, const Vector& x) {
  const Vector r = x - s.center;
  const double z = dot(r, s.axis), rho = norm(r - z * s.axis);
  switch (s.kind) {
    case plane:
      return z;
    case sphere:
      return norm(r) - s.radius;
    case cylinder:
      return rho - s.radius;
    case cone:
      return rho * s.cosine - z * s.sine;
    case torus:
      return std::hypot(rho - s.radius, z) - s.tube;
    case ellipsoid: {
      double square = 0;
      for (const Vector& a : s.semi_axes) square += std::pow(dot(a, r) / norm_squared(a), 2);
      return std::sqrt(square) - 1;
    }
  }
  return 0;
}
Vector slope(const Surface& s, const Vector& x) {
  Vector sum = Vector::zero();
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector h = 1e-5 * Vector::unit(i);
    sum[i] = (off(s, x + h) - off(s, x - h)) / 2e-5;
  }
  return normalized(sum);
}

// A pair that may touch: the first one's size, the second one's, and which is hollow.
struct Kinds {
  SurfaceKind on, from;
  double on_size, from_size;
  int hollow = 0;  // 1: the second, -1: the first
};
const std::vector<Kinds> pairs{{ellipsoid, plane, 1, 1},
                               {torus, plane, 1, 1},
                               {plane, ellipsoid, 1, 1},
                               {plane, torus, 1, 1},
                               {sphere, sphere, 1, 1},
                               {sphere, sphere, 0.3, 2, 1},
                               {sphere, sphere, 2, 0.3, -1},
                               {sphere, cylinder, 1, 1},
                               {sphere, cylinder, 0.3, 2, 1},
                               {cylinder, sphere, 2, 0.3, -1},
                               {sphere, cone, 1, 1},
                               {cone, sphere, 1, 1},
                               {sphere, torus, 1, 1},
                               {torus, sphere, 0.5, 3, 1},
                               {sphere, ellipsoid, 1, 1},
                               {ellipsoid, sphere, 1, 1},
                               {ellipsoid, sphere, 0.5, 3, 1},
                               {sphere, ellipsoid, 0.1, 2, 1},
                               {cylinder, cylinder, 1, 1},
                               {ellipsoid, ellipsoid, 1, 1},
                               {ellipsoid, torus, 1, 1},
                               {ellipsoid, cylinder, 1, 1},
                               {cylinder, ellipsoid, 1, 1},
                               {ellipsoid, cylinder, 0.4, 3, 1},
                               {ellipsoid, ellipsoid, 0.3, 4, 1}};

// Two of these that have come nearest to each other at a place before their ends.
struct Case {
  Surface on, from;
  Touching<double> at;
  std::string words;
};
std::optional<Case> random_case(Random& random, const Kinds& kinds) {
  Case c{made(random, kinds.on, kinds.on_size), made(random, kinds.from, kinds.from_size), {}, {}};
  c.on.inside = kinds.hollow < 0;
  c.from.inside = kinds.hollow > 0;
  if (kinds.hollow == 0) c.on.center += 4.0 * random.direction();
  if (kinds.on == torus && kinds.from == sphere && kinds.hollow > 0) c.on.half = -1;
  c.at = nearest_points(c.on, c.from, 1);
  c.words = std::to_string(static_cast<int>(kinds.on)) + " at " + std::to_string(static_cast<int>(kinds.from)) +
            (kinds.hollow != 0 ? ", hollow" : "");
  // A cone goes on behind its apex as it does not in the world; a flat torus touches all around.
  for (const auto& [s, x] : {std::pair{&c.on, c.at.on}, std::pair{&c.from, c.at.from}}) {
    if (s->kind == cone && !(dot(x - s->center, s->axis) > 0.1)) return std::nullopt;
    if (s->kind == torus && norm(cross(c.at.normal, s->axis)) < 0.2) return std::nullopt;
  }
  return c;
}

TEST(ContactSurface, NearestPointsLieOnBothSurfacesAndFaceEachOther) {
  Random random(5);
  int tried = 0;
  for (int i = 0; i < 40; ++i)
    for (const Kinds& kinds : pairs) {
      const auto c = random_case(random, kinds);
      if (!c) continue;
      ++tried;
      const Vector n = c->at.normal, between = c->at.on - c->at.from;
      EXPECT_NEAR(norm(n), 1, 1e-13) << c->words;
      EXPECT_NEAR(off(c->on, c->at.on), 0, 1e-12) << c->words;
      EXPECT_NEAR(off(c->from, c->at.from), 0, 1e-12) << c->words;
      EXPECT_NEAR(norm(cross(between, n)), 0, 1e-12) << c->words;
      EXPECT_GT(dot(slope(c->from, c->at.from), c->from.inside ? -n : n), 1 - 1e-8) << c->words;
      EXPECT_GT(dot(slope(c->on, c->at.on), c->on.inside ? n : -n), 1 - 1e-8) << c->words;
    }
  EXPECT_GT(tried, 800);
}

// Two free bodies with these surfaces, the second moved along the normal until they touch.
struct Moving {
  Model<double> model;
  Workspace<double> workspace;
  State<double> state;
  VelocityConstraint<double> constraint;

  Moving(Random& random, Case c) : model(bodies(random)), workspace(model), state(neutral_state(model)) {
    const double gap = dot(c.at.normal, c.at.on - c.at.from);
    c.from.center += gap * c.at.normal;
    CurvedContact<double> both{
        c.on, c.from, c.on, c.from, 1, c.at.normal, normalized(cross(c.at.normal, random.direction()))};
    constraint.kind = VelocityConstraintKind::touching;
    constraint.on = 1;
    constraint.from = 0;
    constraint.along = {0, random.chance(0.5) ? c.at.normal : both.tangent};
    constraint.normal = true;
    constraint.surfaces = std::make_shared<const CurvedContact<double>>(both);
    state.v = random.numbers(12, 1.5);
  }
  static Model<double> bodies(Random& random) {
    ModelBuilder<double> builder;
    for (const char* name : {"a", "b"})
      builder.add_body(name, ground, Joint<double>::free(), SpatialTransform<double>::identity(), random.mass());
    return builder.build();
  }
  State<double> later(const std::vector<double>& a, double t) const {
    State<double> moved = state;
    std::vector<double> mean = state.v;
    for (std::size_t k = 0; k < a.size(); ++k) {
      mean[k] += 0.5 * t * a[k];
      moved.v[k] += t * a[k];
    }
    integrate_position<double>(model, moved.q, mean, t);
    return moved;
  }
};

// Long and flat ellipsoids beside each other, beside other surfaces and within each other, laid where they have a given
// normal in common.
TEST(ContactSurface, TheNormalIsFoundWhereverTwoTouch) {
  Random random(77);
  int tried = 0;
  const auto long_ellipsoid = [&] {
    Surface s = made(random, ellipsoid, 1);
    for (Vector& a : s.semi_axes) a = random.uniform(0.05, 0.6) * normalized(a);
    s.center = Vector::zero();
    return s;
  };
  const auto check = [&](Surface on, const Surface& from, const Vector& n, const Vector& place) {
    on.center = place - detail::support_point(on, Vector(-n));
    const Touching<double> now = nearest_points(on, from, 1.0);
    EXPECT_LE(norm(now.normal - n), 1e-9) << tried;
    EXPECT_LE(norm(now.on - place), 1e-7) << tried;
    ++tried;
  };
  for (int i = 0; i < 200; ++i) {
    Vector n = random.direction();
    const Surface other = long_ellipsoid();
    check(long_ellipsoid(), other, n, detail::support_point(other, n));
    Surface tire = made(random, torus, 0.5);
    tire.center = Vector::zero();
    const Vector across = normalized(cross(tire.axis, n));
    n = normalized(Vector(across + random.uniform(-0.9, 0.9) * tire.axis));
    check(long_ellipsoid(), tire, n, tire.radius * across + tire.tube * n);
    Surface pipe = made(random, cylinder, 0.5);
    pipe.center = Vector::zero();
    n = normalized(cross(pipe.axis, n));
    check(long_ellipsoid(), pipe, n, pipe.radius * n + random.uniform(-1, 1) * pipe.axis);
    // Inside it must bend more everywhere.
    Surface bowl = long_ellipsoid(), stone = long_ellipsoid();
    const auto sizes = [](const Surface& s) {
      const double a = norm(s.semi_axes[0]), b = norm(s.semi_axes[1]), c = norm(s.semi_axes[2]);
      return std::pair{std::min({a, b, c}), std::max({a, b, c})};
    };
    const auto [low, high] = sizes(bowl);
    const auto [flat, wide] = sizes(stone);
    for (Vector& a : stone.semi_axes) a = 0.9 * (low * low / high) / (wide * wide / flat) * a;
    bowl.inside = true;
    n = random.direction();
    check(stone, bowl, n, detail::support_point(bowl, Vector(-n)));
  }
  EXPECT_EQ(tried, 800);
}

TEST(ContactSurface, RateGapAndBiasFitTheirDifferencesAtRandomPoses) {
  Random random(6);
  int tried = 0;
  for (int i = 0; i < 20; ++i)
    for (const Kinds& kinds : pairs) {
      const auto c = random_case(random, kinds);
      if (!c) continue;
      ++tried;
      Moving pair(random, *c);
      const std::vector<double> a = random.numbers(12, 2);
      const auto rate_and_gap = [&](double t) {
        Workspace<double> w(pair.model);
        update_velocities(pair.model, w, pair.later(a, t));
        const PlacedForce<double> unit = constraint_force(pair.model, w, pair.constraint);
        return std::pair{dot(unit.force, detail::velocity_at(w, 1, unit.point) - detail::velocity_at(w, 0, unit.point)),
                         constraint_gap(pair.model, w, pair.constraint, std::optional<Vector>())};
      };
      update_accelerations<double>(pair.model, pair.workspace, pair.state, a);
      const ConstraintLine<double> line = constraint_line(pair.model, pair.workspace, pair.constraint);
      constexpr double t = 2e-6;
      const auto before = rate_and_gap(-t), now = rate_and_gap(0), after = rate_and_gap(t);
      EXPECT_NEAR((after.first - before.first) / (2 * t), line.bias, 1e-6 * (1 + std::abs(line.bias))) << c->words;
      EXPECT_NEAR(now.second, 0, 1e-12) << c->words;
      const Touching<double> at = detail::touching_now(pair.model, pair.workspace, pair.constraint);
      const double approach =
          dot(at.normal, detail::velocity_at(pair.workspace, 1, at.on) - detail::velocity_at(pair.workspace, 0, at.on));
      EXPECT_NEAR((after.second - before.second) / (2 * t), approach, 1e-7 * (1 + std::abs(approach))) << c->words;
    }
  EXPECT_GT(tried, 400);
}

// Montana's equations of contact, with the curvatures of both surfaces as their normals vary: seen from `from` the
// place moves with u, seen from `on` with u - v, v the velocity of slip; the normal n turns as each surface bends, and
// relative to each other the bodies turn with w: dn(u) of `from` = dn(u - v) of `on` + w x n.
TEST(ContactSurface, ThePlaceMovesAsMontanasEquationsSay) {
  Random random(7);
  int tried = 0;
  for (int i = 0; i < 20; ++i)
    for (const Kinds& kinds : pairs) {
      const auto c = random_case(random, kinds);
      if (!c || c->on.kind == plane || c->from.kind == plane) continue;
      ++tried;
      Moving pair(random, *c);
      update_velocities(pair.model, pair.workspace, pair.state);
      // Slip along the surfaces only: the rate of the normal row is taken away.
      const Workspace<double>& w = pair.workspace;
      const auto now = detail::touching_as_it_moves(pair.model, w, pair.constraint);
      const Vector n = detail::value_of(now.normal), P = detail::value_of(now.on);
      const Vector v_on = detail::velocity_at(w, 1, P), v_from = detail::velocity_at(w, 0, P);
      const Vector u_on = detail::rate_of(now.on) - v_on, u_from = detail::rate_of(now.from) - v_from;
      const auto flat = [&](const Vector& a) { return a - dot(a, n) * n; };
      EXPECT_NEAR(norm(flat(u_from - u_on - (v_on - v_from))), 0, 1e-9 * (1 + norm(u_from))) << c->words;
      const Surface from = detail::placed_surface(pair.model, w, 0, pair.constraint.surfaces->from);
      const Surface on = detail::placed_surface(pair.model, w, 1, pair.constraint.surfaces->on);
      const auto bend = [&](const Surface& s, const Vector& u) {
        const double h = 1e-5 / (1 + norm(u));
        const Vector change = (slope(s, P + h * u) - slope(s, P - h * u)) / (2 * h);
        return dot(slope(s, P), n) < 0 ? -change : change;
      };
      const Vector turn = cross(angular_velocity(w, 1) - angular_velocity(w, 0), n);
      const Vector of_from = bend(from, flat(u_from)), of_on = bend(on, flat(u_on)) + turn;
      EXPECT_NEAR(norm(of_from - of_on), 0, 2e-4 * (1 + norm(of_from))) << c->words;
    }
  EXPECT_GT(tried, 300);
}

TEST(ContactSurface, CurvaturesTellWhatFits) {
  Surface ball, bowl;
  ball.kind = bowl.kind = sphere;
  ball.radius = 0.2;
  ball.center = {0, 0, 0.2};
  bowl.radius = 0.5;
  bowl.center = {0, 0, 0.5};
  bowl.inside = true;
  const Vector up{0, 0, 1}, P = Vector::zero();
  EXPECT_NEAR(solve::least_relative_curvature(ball, bowl, P, up).value(), 5 - 2, 1e-12);
  EXPECT_NEAR(solve::least_relative_curvature(bowl, ball, P, -up).value(), 5 - 2, 1e-12);
  std::swap(ball.radius, bowl.radius);
  std::swap(ball.center, bowl.center);
  EXPECT_NEAR(solve::least_relative_curvature(ball, bowl, P, up).value(), 2 - 5, 1e-12);
  Surface trough;
  trough.kind = cylinder;
  trough.axis = {1, 0, 0};
  trough.radius = 0.8;
  trough.center = {0, 0, 0.8};
  trough.inside = true;
  EXPECT_NEAR(solve::least_relative_curvature(ball, trough, P, up).value(), 1 / 0.5 - 1 / 0.8, 1e-12);
  Surface log = trough, table;
  log.inside = false;
  table.axis = up;
  EXPECT_NEAR(solve::least_relative_curvature(log, table, P, up).value(), 0, 1e-12);
  Surface edge;
  edge.kind = torus;
  edge.axis = {1, 0, 0};
  edge.radius = 0.3;
  edge.center = {0, 0, 0.3};
  EXPECT_NEAR(solve::least_relative_curvature(edge, trough, P, up).value(), 1 / 0.3 - 1 / 0.8, 1e-12);
  EXPECT_FALSE(solve::least_relative_curvature(edge, edge, P, up).has_value());
}

}  // namespace contact_surface_test
}  // namespace poinsot
