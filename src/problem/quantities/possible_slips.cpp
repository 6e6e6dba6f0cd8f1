#include "problem/quantities/possible_slips.h"

#include <algorithm>

#include "engine/solve/linear/decompositions.h"

namespace poinsot::problem {
namespace {

// Parts of the largest singular value, and of a row. A constraint that is nearly one of the others takes away no
// motion, and a slip is none only where it is rounding: what is allowed in vain is tried, and what is not is never
// seen.
constexpr double one_of_the_others = 1e-7, no_motion = 1e-11;

Eigen::RowVectorXd as_row(const std::vector<double>& values) {
  Eigen::RowVectorXd row(static_cast<Eigen::Index>(values.size()));
  for (std::size_t k = 0; k < values.size(); ++k) row[static_cast<Eigen::Index>(k)] = values[k];
  const double size = row.norm();
  return size > 0 ? Eigen::RowVectorXd(row / size) : row;
}

}  // namespace

PossibleSlips::PossibleSlips(const solve::MechanismStateOf<double>& state,
                             const std::vector<RoughContactOf<double>>& contacts) {
  const std::vector<double>& v = state.state().v;
  moves_already_ = std::ranges::any_of(v, [](double rate) { return rate != 0; });
  coordinates_ = v.size();
  for (const RoughContactOf<double>& contact : contacts) {
    Rows& rows = rows_.emplace_back();
    if (contact.on_cord()) continue;
    if (contact.in_joint()) {
      for (const RubbingWay<double>& way : contact.ways) {
        rows.slips.emplace_back(coordinates_, 0.0);
        rows.slips.back()[static_cast<std::size_t>(way.coordinate)] = 1;
      }
      continue;
    }
    for (std::size_t i = 0; i < contact.motions.size(); ++i) {
      VelocityConstraint<double> way = contact.motions[i];
      way.at = place_of(state.mechanism(), contact);
      std::vector<double> row = solve::constraint_row(state, way).coefficients;
      if (i == 0)
        rows.apart = std::move(row);
      else
        rows.slips.push_back(std::move(row));
    }
  }
}

Eigen::MatrixXd PossibleSlips::free_motions(const std::vector<Grip>& grips) const {
  const auto n = static_cast<Eigen::Index>(coordinates_);
  std::vector<Eigen::RowVectorXd> held;
  for (std::size_t k = 0; k < rows_.size(); ++k) {
    if (grips[k] != Grip::parts && !rows_[k].apart.empty()) held.push_back(as_row(rows_[k].apart));
    if (grips[k] == Grip::sticks)
      for (const std::vector<double>& slip : rows_[k].slips) held.push_back(as_row(slip));
  }
  if (held.empty()) return Eigen::MatrixXd::Identity(n, n);
  Eigen::MatrixXd C(std::max(static_cast<Eigen::Index>(held.size()), n), n);
  C.setZero();
  for (std::size_t i = 0; i < held.size(); ++i) C.row(static_cast<Eigen::Index>(i)) = held[i];
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(C, Eigen::ComputeFullV);
  const Eigen::VectorXd& sizes = svd.singularValues();
  Eigen::Index rank = 0;
  while (rank < sizes.size() && sizes[rank] > one_of_the_others * sizes[0]) ++rank;
  return svd.matrixV().rightCols(n - rank);
}

bool PossibleSlips::allow(const std::vector<Grip>& grips) const {
  if (rows_.empty() || moves_already_) return true;
  const Eigen::MatrixXd free = free_motions(grips);
  const auto moves = [&](const std::vector<double>& row) { return (as_row(row) * free).norm() > no_motion; };
  for (std::size_t k = 0; k < rows_.size(); ++k) {
    if (grips[k] == Grip::parts && !rows_[k].apart.empty() && !moves(rows_[k].apart)) return false;
    if (grips[k] == Grip::slides && !rows_[k].slips.empty() && std::ranges::none_of(rows_[k].slips, moves))
      return false;
  }
  return true;
}

bool PossibleSlips::along_one_line(std::size_t k, const std::vector<Grip>& grips) const {
  if (rows_.empty() || rows_[k].slips.empty()) return false;
  const Eigen::MatrixXd free = free_motions(grips);
  Eigen::MatrixXd slips(static_cast<Eigen::Index>(rows_[k].slips.size()), free.cols());
  for (Eigen::Index i = 0; i < slips.rows(); ++i)
    slips.row(i) = as_row(rows_[k].slips[static_cast<std::size_t>(i)]) * free;
  const Eigen::VectorXd sizes = Eigen::JacobiSVD<Eigen::MatrixXd>(slips).singularValues();
  return sizes.size() < 2 || !(sizes[1] > no_motion * sizes[0]);
}

}  // namespace poinsot::problem
