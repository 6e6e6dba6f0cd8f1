#include "engine/solve/linear/assembled_system.h"
#include "engine/solve/linear/held_elimination.h"
#include "poinsot/engine/solve/linear/linear_system.h"
#include "poinsot/engine/work/work.h"

namespace poinsot::solve {

struct LinearElimination::Parts {
  std::size_t equations = 0;
  Eigen::VectorXd row, column;  // Ruiz's scaling, applied to the system in natural units
  HeldPivots pivots;
  std::vector<std::size_t> left_over;  // the equations without a pivot, in the order of the remainder
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

template <class Scalar>
std::optional<LinearRemainderOf<Scalar>> LinearElimination::remainder(const LinearSystemOf<Scalar>& system) const {
  const Parts& parts = *parts_;
  if (system.equations() != parts.equations) return std::nullopt;
  if (system.equations() == 0) return LinearRemainderOf<Scalar>{{}, {}, 0, std::vector<Scalar>(system.unknowns())};
  const AssembledSystem<Scalar> assembled(system);
  if (!assembled.bad.empty() || assembled.A.cols() != parts.column.size()) return std::nullopt;
  const Eigen::MatrixXd A = parts.row.asDiagonal() * assembled.A * parts.column.asDiagonal();
  count_work(work_of_factors(static_cast<Work>(A.rows()), static_cast<Work>(A.cols())));
  const auto left =
      remainder_of(parts.pivots, A, parts.row.cwiseProduct(assembled.b), parts.row.cwiseProduct(assembled.b_size));
  if (!left) return std::nullopt;
  const Eigen::VectorXd unit = assembled.column.cwiseProduct(parts.column);
  const Eigen::VectorXd solution = unit.cwiseProduct(left->solution);
  LinearRemainderOf<Scalar> remainder{
      {left->values.begin(), left->values.end()}, parts.left_over, left->size, {solution.begin(), solution.end()}};
  if constexpr (std::is_same_v<Scalar, Dual<1>>) {
    const RemainderRates rates =
        remainder_rates(parts.pivots, A, *left, parts.row.asDiagonal() * assembled.A_rate * parts.column.asDiagonal(),
                        parts.row.cwiseProduct(assembled.b_rate));
    for (Eigen::Index i = 0; i < rates.values.size(); ++i)
      remainder.values[static_cast<std::size_t>(i)].partial[0] = rates.values[i];
    for (Eigen::Index j = 0; j < rates.solution.size(); ++j)
      remainder.solution[static_cast<std::size_t>(j)].partial[0] = unit[j] * rates.solution[j];
  }
  return remainder;
}

template std::optional<LinearRemainderOf<double>> LinearElimination::remainder(const LinearSystemOf<double>&) const;
template std::optional<LinearRemainderOf<Dual<1>>> LinearElimination::remainder(const LinearSystemOf<Dual<1>>&) const;

}  // namespace poinsot::solve
