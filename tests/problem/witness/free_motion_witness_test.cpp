// What particles tell of a free motion against its closed form (H/I' and H cos(theta) (I' - I)/(I I')), for random
// bodies of revolution; and what is told wrongly is found.
#include "problem/witness/free_motion_witness.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "case_count.h"

namespace poinsot::problem {
namespace free_motion_witness_test {

using solve::ParticlePaths;
using Real = ParticlePaths::Real;
using Vector = ParticlePaths::Vector;
using Kind = ToldQuantity::Kind;

struct Turning {
  Vector axis, w, H;
  Real axial = 0, transverse = 0;
  ParticlePaths::Sums sums;
};

// Six particles on the axes of the body have any moments that a body of revolution may have.
Turning turning(std::mt19937& random) {
  std::uniform_real_distribution<double> part(-1, 1), size(0.2, 3);
  const auto vector = [&] { return Vector{part(random), part(random), part(random)}; };
  Turning body;
  const Vector u = normalized(vector()), a = normalized(cross(u, vector())), b = cross(u, a);
  const Real along = size(random), across = size(random), mass = size(random);
  body.axis = u;
  body.w = Real(size(random)) * vector();
  body.axial = 4 * mass * across * across;
  body.transverse = 2 * mass * (across * across + along * along);
  body.H = body.transverse * body.w + (body.axial - body.transverse) * dot(body.w, u) * u;
  body.sums.moments = {Vector::zero(), Vector::zero(), Vector::zero()};
  const Vector shift = vector();  // a velocity of the center, which changes nothing
  for (const Vector& r : {along * u, -along * u, across * a, -across * a, across * b, -across * b}) {
    const Vector v = shift + cross(body.w, r);
    body.sums.mass += mass;
    body.sums.momentum += mass * v;
    body.sums.angular_momentum += mass * cross(r, v);
    body.sums.kinetic_energy += mass * norm_squared(v) / 2;
    body.sums.moments.row0 += (mass * r.x) * r;
    body.sums.moments.row1 += (mass * r.y) * r;
    body.sums.moments.row2 += (mass * r.z) * r;
    body.sums.moments_size += mass * norm_squared(r);
  }
  return body;
}

double off(const ToldQuantity& told, const Turning& body) {
  const auto witness = free_motion_of(told, body.sums, body.w);
  if (!witness) return -1;
  const Vector value{told.value.x, told.value.y, told.value.z};
  return static_cast<double>(norm(value - witness->value) / (witness->size + norm(value)));
}

ToldQuantity said(const Turning& body, Kind kind, const Vector& value) {
  const auto narrow = [](const Vector& v) {
    return Vector3<double>{static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)};
  };
  const Vector sense = dot(body.axis, body.w) < 0 ? -body.axis : body.axis;
  return {.kind = kind, .first = narrow(sense), .value = narrow(value)};
}

TEST(FreeMotionWitness, SaysWhatTheClosedFormSays) {
  std::mt19937 random(7);
  int compared = 0;
  for (int i = 0; i < poinsot::testing::case_count(200); ++i) {
    const Turning body = turning(random);
    const Vector u = dot(body.axis, body.w) < 0 ? -body.axis : body.axis;
    const Real H = norm(body.H), I = body.axial, J = body.transverse;
    const Real spin = dot(body.H, u) * (J - I) / (I * J), energy = dot(body.w, body.H);
    const auto angle = [](const Vector& a, const Vector& b) { return std::atan2(norm(cross(a, b)), dot(a, b)); };
    const Vector moments = I < J ? Vector{I, J, J} : Vector{J, J, I};
    const Vector semiaxes{std::sqrt(energy / moments.x), std::sqrt(energy / moments.y), std::sqrt(energy / moments.z)};
    const std::vector<std::pair<Kind, Vector>> right{
        {Kind::precession_axis, body.H / H},
        {Kind::symmetry_axis, u},
        {Kind::precession_rate, {H / J, 0, 0}},
        {Kind::spin_rate, {spin, 0, 0}},
        {Kind::precession_sense, {spin > 0 ? Real(1) : Real(-1), 0, 0}},
        {Kind::body_cone, {angle(u, body.w), 0, 0}},
        {Kind::space_cone, {angle(body.H, body.w), 0, 0}},
        {Kind::invariable_plane, {energy / H, 0, 0}},
        {Kind::poinsot_ellipsoid, semiaxes},
    };
    for (const auto& [kind, value] : right) {
      const double misfit = off(said(body, kind, value), body);
      EXPECT_GE(misfit, 0) << static_cast<int>(kind);
      EXPECT_LT(misfit, 1e-11) << static_cast<int>(kind);
      const double wrong = off(said(body, kind, Real(0.9) * value), body);
      EXPECT_GT(wrong, 1e-7) << static_cast<int>(kind);
    }
    ++compared;
  }
  EXPECT_EQ(compared, poinsot::testing::case_count(200));
}

// The polhode of a body with three moments, along which energy and momentum are kept.
TEST(FreeMotionWitness, TellsAboutWhichAxisThePolhodeRuns) {
  Turning body;
  const auto around = [&](const Vector& w) {
    body.w = w;
    body.sums = {};
    body.sums.moments = {Vector::zero(), Vector::zero(), Vector::zero()};
    // Moments 5, 8 and 9: second moments 6, 3 and 2 along the axes.
    const Vector r[] = {{std::sqrt(Real(3)), 0, 0}, {0, std::sqrt(Real(1.5)), 0}, {0, 0, 1}};
    for (const Vector& one : r)
      for (const Vector& place : {one, -one}) {
        const Vector v = cross(w, place);
        body.sums.mass += 1;
        body.sums.angular_momentum += cross(place, v);
        body.sums.kinetic_energy += norm_squared(v) / 2;
        body.sums.moments.row0 += place.x * place;
        body.sums.moments.row1 += place.y * place;
        body.sums.moments.row2 += place.z * place;
        body.sums.moments_size += norm_squared(place);
      }
    return off(said(body, Kind::polhode, {1, 0, 0}), body);
  };
  EXPECT_EQ(around({0.1L, 0.1L, 1}), 0);
  EXPECT_GT(around({1, 0.1L, 0.1L}), 0.5);
}

}  // namespace free_motion_witness_test
}  // namespace poinsot::problem
