// With dq the displacements of the coordinates, measured like velocities, S the adjoint of spins and D that of all
// twists (near_equations.h), a swing at the frequency w has
//
//   dv = P dq,  P = i w - S + D,      da = Q dv,  Q = i w - S,
//
// and what the equations of motion leave is to be zero,
//
//   (M Q P + r_v P + r_q) dq - C dy = f,      J dq = 0  or  (J P + s_q) dq = 0,
//
// with r_q and r_v the slopes of M a + h - Q - C y, and s_q those of J v, of constraints that bind no positions.
#include "poinsot/engine/solve/stability/response.h"

#include <cmath>
#include <limits>

#include "engine/solve/stability/acceleration_slopes.h"
#include "poinsot/engine/dynamics/velocity_constraint.h"
#include "poinsot/engine/solve/stability/near_equations.h"

namespace poinsot::solve {
namespace {

using Index = Eigen::Index;
using Complex = std::complex<Real>;
// In units in which the largest entry of each row is one: what counts as a repetition of others. The entries have the
// rounding of doubles, and a response that is a billion times the deflection at rest is still told.
constexpr Real repeats_others = 1e-13L;
// Of an unknown: what may be left open, or over, by what repeats others.
constexpr Real left_over = 1e-7L;
// Of a unit: the generalised force of a component that moves nothing. Directions are drawn to about 1e-12.
constexpr Real does_nothing = 1e-11L;
// Of the largest in natural units: what is rounding of doubles, through a few operations.
constexpr Real is_rounding = 1e-13L;

Matrix plain_matrix(const Rows<double>& rows, Index height, Index width) {
  return Matrix::NullaryExpr(height, width, [&](Index i, Index k) {
    return Real(rows[static_cast<std::size_t>(i)][static_cast<std::size_t>(k)]);
  });
}
ComplexMatrix as_complex(const Matrix& A) { return A.cast<Complex>(); }

std::vector<double> plain_numbers(const Vector& x) {
  std::vector<double> all;
  for (const Real number : x) all.push_back(static_cast<double>(number));
  return all;
}
std::vector<std::complex<double>> plain_numbers(const ComplexVector& x) {
  std::vector<std::complex<double>> all;
  for (const Complex& number : x)
    all.emplace_back(static_cast<double>(number.real()), static_cast<double>(number.imag()));
  return all;
}

// The generalised forces of a force and a couple on a body.
ComplexVector generalised(const SteadyMotion& motion, const Excitation& excitation) {
  const Model<double>& tree = motion.mechanism->tree;
  const auto n = static_cast<Index>(motion.v.size());
  ComplexVector f = ComplexVector::Zero(n);
  if (excitation.at.body == ground) return f;
  Workspace<double> workspace(tree);
  const std::vector<double> rest(motion.v.size(), 0.0);
  update_accelerations<double>(tree, workspace, State<double>{motion.q, rest}, rest);
  const Vector3<double> point = point_position(tree, workspace, excitation.at.body, excitation.at.point);
  for (const bool imaginary : {false, true}) {
    const auto part = [&](const ComplexVector3& v) {
      Vector3<double> one;
      for (std::size_t k = 0; k < 3; ++k) one[k] = imaginary ? v[k].imag() : v[k].real();
      return one;
    };
    std::vector<double> forces(motion.v.size(), 0.0);
    add_generalised_force(tree, workspace, excitation.at.body, ground,
                          PlacedForce<double>{point, part(excitation.force), part(excitation.couple)}, forces);
    for (Index k = 0; k < n; ++k)
      f[k] += Complex(imaginary ? 0 : forces[static_cast<std::size_t>(k)],
                      imaginary ? forces[static_cast<std::size_t>(k)] : 0);
  }
  return f;
}

// K x = right for complex numbers, each row and column by its own size.
struct SwingEquations {
  ComplexMatrix K;
  ComplexVector right;
  Index coordinates = 0;
  Vector units;          // natural sizes of the coordinates
  bool at_rest = false;  // at the frequency zero, where K is real

  struct Found {
    Response::Fault fault = Response::Fault::none;
    ComplexVector x;
    Matrix loose;  // displacements that the equations leave open, one a column
  };
  Found solve() const {
    const Index rows = K.rows(), columns = K.cols();
    Vector row(rows), column(columns);
    column.head(coordinates) = units;
    for (Index i = 0; i < rows; ++i) {
      const Real moved = (K.row(i).head(coordinates).transpose().cwiseAbs().cwiseProduct(units)).maxCoeff();
      const Real size = moved > 0 ? moved : K.row(i).cwiseAbs().maxCoeff();
      row[i] = size > 0 ? 1 / size : 1;
    }
    for (Index k = coordinates; k < columns; ++k) {
      const Real size = K.col(k).cwiseAbs().cwiseProduct(row).maxCoeff();
      column[k] = size > 0 ? 1 / size : 1;
    }
    Matrix even(2 * rows, 2 * columns), wanted(2 * rows, 1);
    for (Index i = 0; i < rows; ++i) {
      for (Index k = 0; k < columns; ++k) {
        const Complex entry = row[i] * K(i, k) * column[k];
        even(i, k) = even(rows + i, columns + k) = entry.real();
        even(rows + i, k) = entry.imag();
        even(i, columns + k) = -entry.imag();
      }
      wanted(i, 0) = row[i] * right[i].real();
      wanted(rows + i, 0) = row[i] * right[i].imag();
    }
    Eigen::CompleteOrthogonalDecomposition<Matrix> decomposition;
    decomposition.setThreshold(repeats_others);
    decomposition.compute(even);
    const Matrix inverse = decomposition.solve(Matrix::Identity(2 * rows, 2 * rows).eval());
    const Matrix open = Matrix::Identity(2 * columns, 2 * columns) - inverse * even;
    Found found;
    bool is_open = false;
    for (const Index first : {Index(0), columns})
      if (coordinates > 0 && open.middleRows(first, coordinates).cwiseAbs().maxCoeff() > left_over) is_open = true;
    const Matrix x = inverse * wanted, left = even * x - wanted;
    const bool met = left.cwiseAbs().maxCoeff() <= left_over * (wanted.cwiseAbs().maxCoeff() + x.cwiseAbs().maxCoeff());
    if (is_open && at_rest && met) {
      const Eigen::JacobiSVD<Matrix> svd(open.topLeftCorner(coordinates, columns), Eigen::ComputeThinU);
      const Index count = (svd.singularValues().array() > left_over).count();
      found.loose = column.head(coordinates).asDiagonal() * svd.matrixU().leftCols(count);
    } else if (is_open) {
      found.fault = Response::Fault::undetermined;
    } else if (!met) {
      found.fault = Response::Fault::contradicts;
    }
    Vector size(columns);
    for (Index k = 0; k < columns; ++k) size[k] = std::hypot(x(k, 0), x(columns + k, 0));
    // Displacements and forces have no common unit: each counts beside its own kind.
    const auto largest = [&](Index first, Index count) {
      return count > 0 ? size.segment(first, count).maxCoeff() : Real(0);
    };
    const Real most_moved = largest(0, coordinates), most_pushed = largest(coordinates, columns - coordinates);
    found.x = ComplexVector::Zero(columns);
    for (Index k = 0; k < columns; ++k) {
      if (size[k] <= is_rounding * (k < coordinates ? most_moved : most_pushed)) continue;
      const Real least = is_rounding * size[k];
      const auto clean = [&](Real part) { return std::abs(part) <= least ? Real(0) : part; };
      found.x[k] = column[k] * Complex(clean(x(k, 0)), clean(x(columns + k, 0)));
    }
    return found;
  }
};

}  // namespace

Response response(const SteadyMotion& motion, const Excitation& excitation) {
  const Mechanism<double>& mechanism = *motion.mechanism;
  const auto n = static_cast<Index>(motion.v.size());
  const auto components = static_cast<Index>(mechanism.components.size());
  const auto constraints = static_cast<Index>(mechanism.constraints.size());
  const AccelerationSlopes steady = acceleration_slopes(motion);
  const EquationMatrices<double> matrices = equation_matrices(mechanism, motion.q);
  const Matrix M = plain_matrix(matrices.M, n, n), J = plain_matrix(matrices.J, constraints, n);
  Matrix C = plain_matrix(matrices.C, n, components);
  // What a component does not move has rounding for it, which counted by its own size would be a force.
  for (Index i = 0; i < n; ++i)
    for (Index k = 0; k < components; ++k) {
      const bool arm = natural_size_of(motion, i) == 1 && !mechanism.components[static_cast<std::size_t>(k)].couple;
      if (std::abs(C(i, k)) <= does_nothing * (arm ? Real(motion.length) : Real(1))) C(i, k) = 0;
    }
  const RemainderSlopes<double> remainder(mechanism, State<double>{motion.q, motion.v}, plain_numbers(steady.a),
                                          plain_numbers(steady.components));
  Matrix by_position(n, n), by_velocity(n, n), rates_by_position(constraints, n);
  for (Index k = 0; k < n; ++k) {
    const auto coordinate = static_cast<std::size_t>(k);
    const Remainder<double> moved = remainder.by_position(coordinate), hastened = remainder.by_velocity(coordinate);
    for (Index i = 0; i < n; ++i) {
      by_position(i, k) = moved.forces[static_cast<std::size_t>(i)];
      by_velocity(i, k) = hastened.forces[static_cast<std::size_t>(i)];
    }
    for (Index i = 0; i < constraints; ++i) rates_by_position(i, k) = moved.rates[static_cast<std::size_t>(i)];
  }
  const Complex rate(0, excitation.frequency);
  const Matrix S = plain_matrix(adjoint_rows(mechanism.tree, motion.spins), n, n),
               D = plain_matrix(adjoint_rows(mechanism.tree, own_twists(mechanism.tree, motion.v)), n, n);
  ComplexMatrix Q = as_complex(-S), P = as_complex(D - S);
  Q.diagonal().array() += rate;
  P.diagonal().array() += rate;
  const ComplexMatrix QP = Q * P, inertia = as_complex(M) * QP, rates = as_complex(by_velocity) * P;
  const ComplexMatrix dynamics = inertia + rates + as_complex(by_position);
  const ComplexMatrix allowed = as_complex(J) * P + as_complex(rates_by_position);
  const ComplexVector f = generalised(motion, excitation);

  SwingEquations equations;
  equations.coordinates = n;
  equations.at_rest = excitation.frequency == 0;
  equations.K = ComplexMatrix::Zero(n + constraints, n + components);
  equations.right = ComplexVector::Zero(n + constraints);
  equations.units.resize(n);
  for (Index k = 0; k < n; ++k) {
    equations.units[k] = natural_size_of(motion, k);
    // What is held, or differs in nothing from what is not displaced.
    if (motion.held[static_cast<std::size_t>(k)] ||
        std::ranges::any_of(motion.unseen, [&](const UnseenMotion& unseen) { return unseen.coordinate == k; })) {
      equations.K(k, k) = 1;
      if (k == excitation.coordinate) equations.right[k] = excitation.amplitude;
      continue;
    }
    equations.K.row(k).head(n) = dynamics.row(k);
    equations.K.row(k).tail(components) = -as_complex(C).row(k);
    equations.right[k] = f[k];
  }
  const ComplexMatrix closed = as_complex(J);
  for (Index i = 0; i < constraints; ++i)
    equations.K.row(n + i).head(n) = (steady.binds_positions[static_cast<std::size_t>(i)] ? closed : allowed).row(i);
  const SwingEquations::Found found = equations.solve();

  Response result;
  result.fault = found.fault;
  const auto motion_along = [&](const ComplexMatrix& dq) {
    const ComplexMatrix dv = P * dq, da = Q * dv;
    return Response::Motion{plain_numbers(ComplexVector(dq.col(0))), plain_numbers(ComplexVector(dv.col(0))),
                            plain_numbers(ComplexVector(da.col(0)))};
  };
  result.motion = motion_along(found.x.head(n));
  for (Index k = 0; k < found.loose.cols(); ++k) result.loose.push_back(motion_along(as_complex(found.loose.col(k))));
  return result;
}

}  // namespace poinsot::solve
