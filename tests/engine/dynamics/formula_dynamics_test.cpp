// The algorithms of this room on exact scalars: the textbook's equations, and the numbers of the same algorithms in
// double.
#include <gtest/gtest.h>

#include <random>

#include "engine/math/formula/formula_reader.h"
#include "poinsot/engine/dynamics/forward_dynamics.h"
#include "poinsot/engine/dynamics/inverse_dynamics.h"
#include "poinsot/engine/dynamics/mass_matrix.h"
#include "poinsot/engine/dynamics/momentum.h"
#include "poinsot/engine/mass/shapes.h"
#include "poinsot/engine/math/formula/formula.h"
#include "poinsot/engine/math/formula/formula_text.h"
#include "poinsot/engine/model/builder.h"

namespace poinsot {
namespace formula_dynamics_test {

// A letter in one scalar, its value in another.
template <class Scalar>
struct Letters;
template <>
struct Letters<Formula> {
  Formula positive(const std::string& name) const { return Formula::letter(name, Sign::positive); }
  Formula real(const std::string& name) const { return Formula::letter(name, Sign::real); }
};
template <>
struct Letters<double> {
  LetterValues values;
  double positive(const std::string& name) const { return values.at(name); }
  double real(const std::string& name) const { return values.at(name); }
};

template <class Scalar>
struct Case {
  Model<Scalar> model;
  State<Scalar> state;
  std::vector<Scalar> given;  // forces or accelerations
};

// Two particles on massless rods, hung up one below the other.
template <class Scalar>
Case<Scalar> double_pendulum(const Letters<Scalar>& letters) {
  using Vector = Vector3<Scalar>;
  const Scalar L1 = letters.positive("L1");
  const Scalar L2 = letters.positive("L2");
  const auto particle = [](const Scalar& mass, const Scalar& length) {
    return of_mass(shapes::particle<Scalar>(Vector{Scalar(0), -length, Scalar(0)}), mass);
  };
  ModelBuilder<Scalar> builder;
  builder.set_gravity(Vector{Scalar(0), -letters.positive("g"), Scalar(0)});
  const auto hinge = Joint<Scalar>::revolute(Vector::unit(2));
  const auto identity = Matrix3<Scalar>::identity();
  builder.add_body("upper", ground, hinge, {identity, Vector::zero()}, particle(letters.positive("m1"), L1));
  builder.add_body("lower", 0, hinge, {identity, Vector{Scalar(0), -L1, Scalar(0)}},
                   particle(letters.positive("m2"), L2));
  return {builder.build(),
          {{letters.real("a"), letters.real("b")}, {letters.real("u"), letters.real("v")}},
          {letters.real("f1"), letters.real("f2")}};
}

// A disk in a gimbal on a turntable.
template <class Scalar>
Case<Scalar> gyroscope(const Letters<Scalar>& letters) {
  using Vector = Vector3<Scalar>;
  ModelBuilder<Scalar> builder;
  builder.set_gravity(Vector{Scalar(0), Scalar(0), -letters.positive("g")});
  const auto identity = Matrix3<Scalar>::identity();
  const MassProperties<Scalar> massless{Scalar(0), Vector::zero(), SymmetricMatrix3<Scalar>::zero()};
  builder.add_body("turntable", ground, Joint<Scalar>::revolute(Vector::unit(2)), {identity, Vector::zero()}, massless);
  builder.add_body("gimbal", 0, Joint<Scalar>::revolute(Vector::unit(0)), {identity, Vector::zero()}, massless);
  const Vector center{Scalar(0), Scalar(0), letters.positive("h")};
  builder.add_body(
      "disk", 1, Joint<Scalar>::revolute(Vector::unit(2)), {identity, Vector::zero()},
      of_mass(shapes::disk<Scalar>(center, Vector::unit(2), letters.positive("r")), letters.positive("m")));
  return {builder.build(),
          {{letters.real("p"), letters.real("a"), letters.real("s")},
           {letters.real("u"), letters.real("v"), letters.real("w")}},
          {letters.real("f1"), letters.real("f2"), letters.real("f3")}};
}

template <class Scalar>
std::vector<Scalar> accelerations(const Case<Scalar>& c) {
  Workspace<Scalar> workspace(c.model);
  std::vector<Scalar> result(c.given.size());
  forward_dynamics<Scalar>(c.model, workspace, c.state, c.given, result);
  return result;
}
template <class Scalar>
std::vector<Scalar> forces(const Case<Scalar>& c) {
  Workspace<Scalar> workspace(c.model);
  std::vector<Scalar> result(c.given.size());
  inverse_dynamics<Scalar>(c.model, workspace, c.state, c.given, result);
  return result;
}

void expect_same(const std::vector<Formula>& formulas, const std::vector<double>& numbers, const LetterValues& values) {
  ASSERT_EQ(formulas.size(), numbers.size());
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    EXPECT_NEAR(value_at(formulas[i], values), numbers[i], 1e-11 * (1 + std::abs(numbers[i]))) << text(formulas[i]);
  }
}

LetterValues random_values(std::mt19937_64& random) {
  LetterValues values;
  for (const char* name : {"L1", "L2", "m1", "m2", "g", "h", "r", "m"}) {
    values[name] = std::uniform_real_distribution<double>(0.3, 2)(random);
  }
  for (const char* name : {"a", "b", "p", "s", "u", "v", "w", "f1", "f2", "f3"}) {
    values[name] = std::uniform_real_distribution<double>(-2, 2)(random);
  }
  return values;
}

TEST(FormulaDynamics, FormulasHaveTheValuesOfDoubles) {
  std::mt19937_64 random(31);
  const auto pendulum = double_pendulum<Formula>({});
  const auto gyro = gyroscope<Formula>({});
  const auto pendulum_accelerations = accelerations(pendulum);
  const auto pendulum_forces = forces(pendulum);
  const auto gyro_accelerations = accelerations(gyro);
  const auto gyro_forces = forces(gyro);
  for (int trial = 0; trial < 20; ++trial) {
    const Letters<double> letters{random_values(random)};
    expect_same(pendulum_accelerations, accelerations(double_pendulum<double>(letters)), letters.values);
    expect_same(pendulum_forces, forces(double_pendulum<double>(letters)), letters.values);
    expect_same(gyro_accelerations, accelerations(gyroscope<double>(letters)), letters.values);
    expect_same(gyro_forces, forces(gyroscope<double>(letters)), letters.values);
  }
}

// Forces that follow from accelerations that follow from forces are the forces.
TEST(FormulaDynamics, InverseAndForwardDynamicsUndoEachOtherExactly) {
  for (auto c : {double_pendulum<Formula>({}), gyroscope<Formula>({})}) {
    const std::vector<Formula> given = c.given;
    c.given = accelerations(c);
    const std::vector<Formula> found = forces(c);
    for (std::size_t i = 0; i < given.size(); ++i) EXPECT_EQ(found[i], given[i]) << text(found[i]);
  }
}

TEST(FormulaDynamics, HasTheTextbooksEquations) {
  auto pendulum = double_pendulum<Formula>({});
  const Formula L1 = Formula::letter("L1", Sign::positive);
  const Formula L2 = Formula::letter("L2", Sign::positive);
  const Formula m2 = Formula::letter("m2", Sign::positive);
  const Formula b = Formula::letter("b", Sign::real);
  Workspace<Formula> workspace(pendulum.model);
  std::vector<Formula> M(4);
  mass_matrix<Formula>(pendulum.model, workspace, pendulum.state.q, M);
  EXPECT_EQ(text(M[3]), "m2*L2^2");
  EXPECT_EQ(M[2], m2 * L2 * (L2 + L1 * cos(b)));
  EXPECT_EQ(text(M[2]), "m2*L2*(L1*cos(b) + L2)");

  // At rest only weight acts: on the lower hinge m2 g L2 sin(a + b).
  pendulum.state.v = {0, 0};
  pendulum.given = {0, 0};
  EXPECT_EQ(text(forces(pendulum)[1]), "m2*g*L2*sin(a + b)");

  // In steady precession: no couple about the vertical and the spin axis, and on the gimbal that of Eq. 18.44 with
  // I = m r^2/2 about the axis of the disk and I' = m r^2/4 + m h^2 across it.
  auto gyro = gyroscope<Formula>({});
  gyro.given = {0, 0, 0};
  gyro.state.v[1] = 0;
  EXPECT_EQ(text(forces(gyro)[0]), "0");
  EXPECT_EQ(text(forces(gyro)[2]), "0");
  EXPECT_EQ(text(substituted(forces(gyro)[1], {{"g", 0}})), "m*u*sin(a)*(u*(r^2 - 4*h^2)*cos(a) + 2*r^2*w)/4");
}

}  // namespace formula_dynamics_test
}  // namespace poinsot
