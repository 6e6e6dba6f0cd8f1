#include "poinsot/solve/linear_system.h"
#include "solve/assembled_system.h"
#include "solve/held_elimination.h"

namespace poinsot::solve {

struct LinearElimination::Parts {
  std::size_t equations = 0;
  Eigen::VectorXd row, column;  // Ruiz's scaling of the system in natural units
  HeldPivots pivots;
  std::vector<std::size_t> left_over;  // equations, in the order of the remainder
};

LinearElimination::LinearElimination(const LinearSystem& system, const std::vector<bool>& late) {
  const auto parts = std::make_shared<Parts>();
  parts_ = parts;
  parts->equations = system.equations();
  AssembledSystem<double> assembled(system);
  Eigen::MatrixXd& A = assembled.A;
  parts->row = Eigen::VectorXd::Ones(A.rows());
  parts->column = Eigen::VectorXd::Ones(A.cols());
  if (!assembled.bad.empty() || system.equations() == 0) return;
  equilibrate(A, parts->row, parts->column);
  parts->pivots = pivots_of(A, rank_tolerance, late);
  parts->left_over.resize(static_cast<std::size_t>(A.rows() - parts->pivots.rank));
  for (Eigen::Index i = 0; i < A.rows(); ++i)
    if (const Eigen::Index place = parts->pivots.rows.indices()[i] - parts->pivots.rank; place >= 0)
      parts->left_over[static_cast<std::size_t>(place)] = static_cast<std::size_t>(i);
}

std::size_t LinearElimination::rank() const { return static_cast<std::size_t>(parts_->pivots.rank); }

std::optional<LinearRemainder> LinearElimination::remainder(const LinearSystem& system) const {
  const Parts& parts = *parts_;
  if (system.equations() != parts.equations) return std::nullopt;
  if (system.equations() == 0) return LinearRemainder{{}, {}, 0, std::vector<double>(system.unknowns())};
  const AssembledSystem<double> assembled(system);
  if (!assembled.bad.empty() || assembled.A.cols() != parts.column.size()) return std::nullopt;
  const auto left = remainder_of(parts.pivots, parts.row.asDiagonal() * assembled.A * parts.column.asDiagonal(),
                                 parts.row.cwiseProduct(assembled.b), parts.row.cwiseProduct(assembled.b_size));
  if (!left) return std::nullopt;
  const Eigen::VectorXd solution = assembled.column.cwiseProduct(parts.column.cwiseProduct(left->solution));
  return LinearRemainder{
      {left->values.begin(), left->values.end()}, parts.left_over, left->size, {solution.begin(), solution.end()}};
}

}  // namespace poinsot::solve
