// Dual numbers over numbers with a bound on their rounding give the slopes of what the equations of motion leave
// (near_equations.h). One matrix K turns them into slopes of the accelerations a and of the components y:
//
//   K = [M -C; J 0],      K (da, dy) = -(r_q dq + r_v dv).
//
// Constraints may repeat one another and components may share a load: K is inverted as far as it goes. What is
// undetermined must not be an acceleration.
#include "engine/solve/stability/acceleration_slopes.h"

#include <cmath>
#include <stdexcept>

#include "poinsot/engine/solve/stability/near_equations.h"

namespace poinsot::solve {
namespace {

using Index = Eigen::Index;
// In units in which coordinates have inertia one and rows and columns of constraints and components length one: what
// counts as a repetition of others. Points of loops are closed to 1e-14 and drawn to about 1e-12.
constexpr Real repeats = 1e-9L;
// Inertia of what moves no mass, as a part of the largest: so little that what bears the load of masses is not taken
// for idle beside it, and so much that the square root of it stands far above what counts as a repetition.
constexpr Real light = 1e-4L;
// What of an acceleration may be left open: a part of it that rounding of directions leaves, which `repeats` magnifies
// no more than a thousandfold.
constexpr Real left_open = 1e-6L;

Matrix values(const Rows<Rounded>& rows, Index columns) {
  Matrix A(static_cast<Index>(rows.size()), columns);
  for (Index i = 0; i < A.rows(); ++i)
    for (Index k = 0; k < columns; ++k) A(i, k) = rows[static_cast<std::size_t>(i)][static_cast<std::size_t>(k)].value;
  return A;
}
Matrix errors(const Rows<Rounded>& rows, Index columns) {
  Matrix A(static_cast<Index>(rows.size()), columns);
  for (Index i = 0; i < A.rows(); ++i)
    for (Index k = 0; k < columns; ++k) A(i, k) = rows[static_cast<std::size_t>(i)][static_cast<std::size_t>(k)].error;
  return A;
}
Doubted doubted(const Rows<Rounded>& rows, Index columns) { return {values(rows, columns), errors(rows, columns)}; }
Doubted column_of(const std::vector<Rounded>& numbers) {
  const auto size = static_cast<Index>(numbers.size());
  Doubted column{Matrix(size, 1), Matrix(size, 1)};
  for (Index i = 0; i < size; ++i) {
    column.value(i, 0) = numbers[static_cast<std::size_t>(i)].value;
    column.doubt(i, 0) = numbers[static_cast<std::size_t>(i)].error;
  }
  return column;
}
std::vector<Rounded> stated(const std::vector<double>& numbers) {
  std::vector<Rounded> result;
  result.reserve(numbers.size());
  for (const double x : numbers) result.push_back(Rounded::stated(x));
  return result;
}

// Entries that may be nothing but rounding become zero, without doubt: others could be inverted.
void clear_rounding(Doubted& A) {
  const auto sure = (A.value.cwiseAbs().array() > computed * A.doubt.array()).eval();
  A.value = sure.select(A.value, Matrix::Zero(A.value.rows(), A.value.cols()));
  A.doubt = sure.select(A.doubt, Matrix::Zero(A.doubt.rows(), A.doubt.cols()));
}

// One over the length of a vector, zero of none.
Real inverse_length(const Vector& x) { return x.norm() > 0 ? 1 / x.norm() : 0; }

// K, inverted as far as it goes, of the coordinates whose accelerations follow from forces.
class ForceEquations {
 public:
  // units: the natural sizes of the free coordinates, 1 rad or a length.
  ForceEquations(const EquationMatrices<Rounded>& matrices, const std::vector<Index>& free, const Vector& units,
                 Index components)
      : n_(static_cast<Index>(free.size())), constraints_(static_cast<Index>(matrices.J.size())) {
    const auto n = static_cast<Index>(matrices.M.size());
    Doubted C = doubted(matrices.C, components), J = doubted(matrices.J, n);
    clear_rounding(C);
    clear_rounding(J);
    const Doubted M = doubted(matrices.M, n);
    K_ = {Matrix::Zero(n_ + constraints_, n_ + components), Matrix::Zero(n_ + constraints_, n_ + components)};
    for (const auto part : {&Doubted::value, &Doubted::doubt}) {
      const Real sign = part == &Doubted::value ? -1 : 1;
      (K_.*part).topLeftCorner(n_, n_) = (M.*part)(free, free);
      (K_.*part).topRightCorner(n_, components) = sign * (C.*part)(free, Eigen::all);
      (K_.*part).bottomLeftCorner(constraints_, n_) = (J.*part)(Eigen::all, free);
    }
    invert(units);
  }

  // K (da, dy) = -left, with what left and K are off by.
  Doubted solve(const Doubted& left) const {
    const Matrix x = -(inverse_ * left.value), size = inverse_.cwiseAbs(), most = x.cwiseAbs(), K = K_.value.cwiseAbs();
    const Real rounding = 8 * static_cast<Real>(K_.value.rows()) * std::numeric_limits<Real>::epsilon();
    const Matrix rounded = rounding * (left.value.cwiseAbs() + K * most), off = left.doubt + K_.doubt * most + rounded;
    return {x, size * off};
  }

 private:
  void invert(const Vector& units) {
    const Index components = K_.value.cols() - n_;
    Vector row(K_.value.rows()), column(K_.value.cols());
    // What moves no mass takes part by its constraints: it counts as light beside the most that a natural change of
    // any coordinate moves.
    Real inertia = 0;
    for (Index k = 0; k < n_; ++k) inertia = std::max(inertia, K_.value(k, k) * units[k] * units[k]);
    if (!(inertia > 0)) inertia = 1;
    for (Index k = 0; k < n_; ++k)
      row[k] = column[k] =
          K_.value(k, k) > K_.doubt(k, k) ? 1 / std::sqrt(K_.value(k, k)) : units[k] / std::sqrt(light * inertia);
    for (Index i = 0; i < constraints_; ++i)
      row[n_ + i] = inverse_length(K_.value.row(n_ + i).head(n_).transpose().cwiseProduct(column.head(n_)));
    for (Index i = 0; i < components; ++i)
      column[n_ + i] = inverse_length(K_.value.col(n_ + i).head(n_).cwiseProduct(row.head(n_)));
    const Matrix even = row.asDiagonal() * K_.value * column.asDiagonal();
    Eigen::CompleteOrthogonalDecomposition<Matrix> decomposition;
    decomposition.setThreshold(repeats);
    decomposition.compute(even);
    const Matrix inverse = decomposition.solve(Matrix::Identity(even.rows(), even.rows()).eval());
    // (1 - K^+ K) keeps what the equations leave open.
    const Matrix open = Matrix::Identity(even.cols(), even.cols()) - inverse * even;
    if (n_ > 0 && open.topRows(n_).cwiseAbs().maxCoeff() > left_open)
      throw std::runtime_error("the accelerations near the steady motion are not determined");
    inverse_ = column.asDiagonal() * inverse * row.asDiagonal();
  }

  Index n_, constraints_;
  Doubted K_;
  Matrix inverse_;
};

}  // namespace

double natural_size_of(const SteadyMotion& motion, Index coordinate) {
  for (const auto& body : motion.mechanism->tree.bodies()) {
    const Index k = coordinate - body.v;
    if (k < 0 || k >= velocity_size(body.joint)) continue;
    return body.joint == JointType::prismatic || (body.joint == JointType::free && k >= 3) ? motion.length : 1;
  }
  return 1;
}

AccelerationSlopes acceleration_slopes(const SteadyMotion& motion) {
  const Mechanism<Rounded> mechanism = convert_mechanism<Rounded>(*motion.mechanism, Rounded::stated);
  const State<Rounded> state{stated(motion.q), stated(motion.v)};
  const auto n = static_cast<Index>(motion.v.size());
  const auto components = static_cast<Index>(mechanism.components.size());
  const auto constraints = static_cast<Index>(mechanism.constraints.size());
  std::vector<Rounded> a(motion.v.size()), y(mechanism.components.size());
  std::vector<Index> free;
  for (std::size_t k = 0; k < a.size(); ++k) {
    if (motion.given[k])
      a[k] = Rounded::stated(*motion.given[k]);
    else
      free.push_back(static_cast<Index>(k));
  }
  const auto count = static_cast<Index>(free.size());
  const EquationMatrices<Rounded> matrices = equation_matrices(mechanism, state.q);
  Vector units(count);
  for (Index i = 0; i < count; ++i) units[i] = natural_size_of(motion, free[static_cast<std::size_t>(i)]);
  const ForceEquations equations(matrices, free, units, components);
  // The part of a remainder that the free accelerations and the components must make zero.
  const auto to_solve = [&](const Remainder<Rounded>& remainder) {
    const Doubted forces = column_of(remainder.forces), changes = column_of(remainder.changes);
    Doubted left{Matrix(count + constraints, 1), Matrix(count + constraints, 1)};
    for (const auto part : {&Doubted::value, &Doubted::doubt}) {
      (left.*part).topRows(count) = (forces.*part)(free, Eigen::all);
      (left.*part).bottomRows(constraints) = changes.*part;
    }
    return left;
  };

  const Doubted found = equations.solve(to_solve(remainder_of(mechanism, state, a, y)));
  for (Index i = 0; i < count; ++i)
    a[static_cast<std::size_t>(free[static_cast<std::size_t>(i)])] = {found.value(i, 0), found.doubt(i, 0)};
  for (Index i = 0; i < components; ++i)
    y[static_cast<std::size_t>(i)] = {found.value(count + i, 0), found.doubt(count + i, 0)};

  AccelerationSlopes slopes;
  slopes.a = column_of(a).value;
  slopes.components = column_of(y).value;
  slopes.constraints = doubted(matrices.J, n);
  for (Doubted* each : {&slopes.by_position, &slopes.by_velocity}) *each = {Matrix::Zero(n, n), Matrix::Zero(n, n)};
  slopes.rates_by_position = {Matrix::Zero(constraints, n), Matrix::Zero(constraints, n)};
  const RemainderSlopes<Rounded> remainder(mechanism, state, a, y);
  for (Index k = 0; k < n; ++k) {
    const auto coordinate = static_cast<std::size_t>(k);
    if (coordinate < motion.held.size() && motion.held[coordinate]) continue;  // it does not deviate
    const Remainder<Rounded> along = remainder.by_position(coordinate);
    const Doubted moved = equations.solve(to_solve(along));
    const Doubted hastened = equations.solve(to_solve(remainder.by_velocity(coordinate)));
    const Doubted rates = column_of(along.rates);
    for (const auto part : {&Doubted::value, &Doubted::doubt}) {
      for (Index i = 0; i < count; ++i) {
        (slopes.by_position.*part)(free[static_cast<std::size_t>(i)], k) = (moved.*part)(i, 0);
        (slopes.by_velocity.*part)(free[static_cast<std::size_t>(i)], k) = (hastened.*part)(i, 0);
      }
      (slopes.rates_by_position.*part).col(k) = rates.*part;
    }
  }
  for (const VelocityConstraint<double>& constraint : motion.mechanism->constraints)
    slopes.binds_positions.push_back(binds_positions(constraint));
  return slopes;
}

}  // namespace poinsot::solve
