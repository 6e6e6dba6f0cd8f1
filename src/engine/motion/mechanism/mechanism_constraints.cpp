// Rows of the constraints, which of them are independent, and the way back onto them.
#include <algorithm>
#include <cmath>
#include <random>

#include "engine/motion/mechanism/mechanism_parts.h"
#include "poinsot/engine/motion/integrator/motion_equations.h"

namespace poinsot {
namespace {

// In scaled units, in which rows have length one: what counts as dependent when independent rows are selected. The
// poses in which that is done are closed to 1e-9 at worst; rows that repeat others there differ by as much.
constexpr double selection_tolerance = 1e-8;
// The same when the selected ones meet a singular pose: the next pose may be anything but that itself, so that only
// rounding of poses that are closed to 1e-15, magnified by the rows, counts.
constexpr double singular_tolerance = 1e-11;
// Of natural lengths or rad: a pose that is closed by more is none in which rows can be compared.
constexpr double closed_to_compare = 1e-9;
// Of its natural size: a row that moves nothing free has only rounding left.
constexpr double empty_row = 1e-11;
// Of the row of one that repeats others: a share in it that is less is none. Shares are known to the gap over the
// tolerance of the selection.
constexpr double takes_share = 1e-7;
// Of a radian or the machine's length: how far from the drawn pose rows are compared once more. So far that what is
// singular by chance in a drawing is so no more, and so near that the loops close again.
constexpr double beside_drawing = 0.03;
// Of the constraints where they are most independent. Rates along a branch that crosses another one are known to the
// rounding of gaps over the square of this, 1e-15/1e-7: to eight digits, and with a third of it to seven.
constexpr double lost_independence = 3e-4;
// In natural lengths or rad: what given motions tear apart. Steps leave gaps of 1e-12, which Newton's method closes to
// 1e-15; a loop that can no longer close opens by the square of the step beyond its end.
constexpr double open_gap = 1e-6;

}  // namespace

double MechanismDynamics::Parts::unit_of(int constraint) const {
  return mechanism.constraints[static_cast<std::size_t>(constraint)].kind == VelocityConstraintKind::angular ? 1
                                                                                                             : length;
}

// unit: its unit force, or of a cord over wheels that of its first part. After update_poses and find_axes.
void MechanismDynamics::Parts::add_row(int constraint, const PlacedForce<double>& unit) {
  const auto i = static_cast<std::size_t>(constraint);
  const VelocityConstraint<double>& c = mechanism.constraints[i];
  double* const J = row.data() + constraint * n;
  std::fill(J, J + n, 0.0);
  std::size_t span = 0;
  for_each_unit_force(mechanism.tree, workspace, c, unit, [&](int, int, const PlacedForce<double>& force) {
    add_generalised(c.spans.empty() ? of_constraint[i] : of_spans[i][span++], force, 1, J);
  });
}

// After update_accelerations and find_axes.
void MechanismDynamics::Parts::find_row(int constraint) {
  const auto i = static_cast<std::size_t>(constraint);
  const ConstraintLine<double> line = constraint_line(mechanism.tree, workspace, mechanism.constraints[i]);
  add_row(constraint, line.unit);
  row_bias[i] = line.bias;
}

// J^T = Q R for these constraints, on scaled coordinates with rows of length one. After find_row and find_mass.
void MechanismDynamics::Parts::factor_rows(const std::vector<int>& constraints, double tolerance, bool positions_first,
                                           int most) {
  factored = constraints;
  qr.resize(static_cast<int>(free.size()), static_cast<int>(constraints.size()));
  for (std::size_t c = 0; c < constraints.size(); ++c) {
    const auto i = static_cast<std::size_t>(constraints[c]);
    const double* const J = row.data() + constraints[c] * n;
    const auto out = [&](std::size_t f) -> double& { return qr.entry(static_cast<int>(f), static_cast<int>(c)); };
    double natural = 0, scaled = 0;
    for (std::size_t f = 0; f < free.size(); ++f) {
      const double entry = J[free[f]];
      out(f) = entry * scale[f];
      scaled += out(f) * out(f);
      natural += std::pow(entry * (turns[free[f]] ? 1 : length), 2);
    }
    const bool empty = !(std::sqrt(natural) > empty_row * unit_of(constraints[c]));
    row_size[i] = std::sqrt(scaled);
    for (std::size_t f = 0; f < free.size(); ++f) out(f) = empty ? 0 : out(f) / row_size[i];
    classes[c] = positions_first && binds_positions(mechanism.constraints[i]);
  }
  qr.factor(tolerance, std::span<const char>(classes.data(), constraints.size()), most);
}

// The independent ones among all that act, here: rows of positions first. After update_velocities and find_axes.
void MechanismDynamics::Parts::choose_rows(int most) {
  for (const int i : acting_rows) find_row(i);
  factor_rows(acting_rows, selection_tolerance, true, most);
}

// What qr has chosen becomes the selection. The multipliers of constraints that repeat others are not determined, nor
// are those of the others in which they are combined.
void MechanismDynamics::Parts::adopt_chosen() {
  selected.clear();
  std::fill(shared.begin(), shared.end(), static_cast<char>(0));
  for (int k = 0; k < qr.rank(); ++k) selected.push_back(factored[static_cast<std::size_t>(qr.chosen(k))]);
  for (int k = qr.rank(); k < qr.columns(); ++k) {
    for (int i = 0; i < qr.rank(); ++i) rest[static_cast<std::size_t>(i)] = qr.R(i, k);
    qr.solve_upper(rest.data());
    for (int i = 0; i < qr.rank(); ++i)
      if (std::abs(rest[static_cast<std::size_t>(i)]) > takes_share)
        shared[static_cast<std::size_t>(factored[static_cast<std::size_t>(qr.chosen(i))])] = 1;
    shared[static_cast<std::size_t>(factored[static_cast<std::size_t>(qr.chosen(k))])] = 1;
  }
}

// At the present pose and a little way along its free motions, where it stands nearly so but for a singularity: the
// selection that finds most.
void MechanismDynamics::Parts::select_rows() {
  stale = false;
  saved_q = state.q;
  saved_v = state.v;
  std::fill(state.v.begin(), state.v.end(), 0.0);
  const auto choose_here = [&] {
    update_accelerations<double>(mechanism.tree, workspace, state, rest_accelerations);
    find_axes();
    find_mass();
    choose_rows();
  };
  std::mt19937 random(7);
  std::uniform_real_distribution<double> part(-1, 1);
  int most = -1;
  for (int attempt = 0; attempt < 4; ++attempt) {
    state.q = saved_q;
    if (close_positions(false) > closed_to_compare && attempt > 0) continue;
    choose_here();
    if (attempt > 0) {
      for (std::size_t f = 0; f < free.size(); ++f) motion[f] = part(random);
      qr.apply_transposed(motion.data());
      std::fill(motion.begin(), motion.begin() + qr.rank(), 0.0);
      qr.apply(motion.data());
      double largest = 0;
      for (std::size_t f = 0; f < free.size(); ++f)
        largest = std::max(largest, std::abs(motion[f] * scale[f] / (turns[free[f]] ? 1 : length)));
      if (!(largest > 0)) break;
      std::fill(step.begin(), step.end(), 0.0);
      for (std::size_t f = 0; f < free.size(); ++f) step[free[f]] = beside_drawing * motion[f] * scale[f] / largest;
      integrate_position<double>(mechanism.tree, state.q, step, 1.0);
      if (close_positions(false) > closed_to_compare) continue;
      choose_here();
    }
    if (qr.rank() < most) continue;
    most = qr.rank();
    adopt_chosen();
  }
  state.q = saved_q;
  state.v = saved_v;
  independent = static_cast<int>(selected.size());
  chosen_pivot = 1;
}

// The selected rows at the present state. After update_velocities, find_axes and find_mass.
void MechanismDynamics::Parts::factor_selected() {
  for (const int i : selected) find_row(i);
  factor_rows(selected, singular_tolerance, true);
  const int rank = qr.rank();
  const double least = qr.least_pivot();
  if (rank == independent && least > 0.5 * chosen_pivot) {
    chosen_pivot = std::max(chosen_pivot, least);
    return;
  }
  // Others may serve better here, but never more: in a state a little off the constraints, those that repeat others
  // seem to demand something of their own.
  choose_rows(independent);
  if (qr.rank() > rank || (qr.rank() == rank && qr.least_pivot() > 2 * least)) adopt_chosen();
  for (const int i : selected) find_row(i);
  factor_rows(selected, singular_tolerance, true);
  chosen_pivot = qr.least_pivot();
}

double MechanismDynamics::Parts::natural_gap(int constraint) const {
  const auto i = static_cast<std::size_t>(constraint);
  return std::abs(constraint_gap(mechanism.tree, workspace, mechanism.constraints[i], free_axis[i])) /
         unit_of(constraint);
}

// Newton's method for the positions of `state`, each step the least in the metric of the inertia; selected: with the
// selected constraints, else with all that are independent where it stands. Returns the largest gap left.
double MechanismDynamics::Parts::close_positions(bool chosen_only) {
  const Model<double>& tree = mechanism.tree;
  // Newton's method doubles the digits and ends where rounding stops it; forty halvings are what a start beside a
  // singular pose takes.
  constexpr int most_steps = 40;
  constexpr double closed = 1e-15;  // in natural lengths: a few units in the last place
  const std::vector<int>& candidates = chosen_only ? selected : acting_rows;
  double best = 0;
  for (int count = 0;; ++count) {
    update_poses<double>(tree, workspace, state.q);
    double worst = 0;
    for (const int i : acting_rows)
      if (binds_positions(mechanism.constraints[static_cast<std::size_t>(i)])) worst = std::max(worst, natural_gap(i));
    // Rounding stops the descent.
    if (count > 0 && !(worst < best)) {
      state.q = best_q;
      update_poses<double>(tree, workspace, state.q);
      return best;
    }
    const bool slow = count > 8 && worst > 0.9 * best;
    best = worst;
    best_q = state.q;
    if (worst <= closed || count == most_steps || slow) return best;

    find_axes();
    find_mass();
    factored.clear();
    for (const int i : candidates) {
      const VelocityConstraint<double>& c = mechanism.constraints[static_cast<std::size_t>(i)];
      if (!binds_positions(c)) continue;
      add_row(i, constraint_force(tree, workspace, c));
      factored.push_back(i);
    }
    position_rows = factored;
    factor_rows(position_rows, chosen_only ? singular_tolerance : selection_tolerance, false);
    for (int k = 0; k < qr.rank(); ++k) {
      const auto i = static_cast<std::size_t>(factored[static_cast<std::size_t>(qr.chosen(k))]);
      motion[static_cast<std::size_t>(k)] =
          -constraint_gap(tree, workspace, mechanism.constraints[i], free_axis[i]) / row_size[i];
    }
    qr.solve_transposed(motion.data());
    std::fill(motion.begin() + qr.rank(), motion.begin() + static_cast<std::ptrdiff_t>(free.size()), 0.0);
    qr.apply(motion.data());
    double largest = 0;
    for (std::size_t f = 0; f < free.size(); ++f)
      largest = std::max(largest, std::abs(motion[f] * scale[f] / (turns[free[f]] ? 1 : length)));
    // A longer step would leave the linear equations behind: half a radian or half the machine.
    constexpr double longest = 0.5;
    const double part = largest > longest ? longest / largest : 1;
    std::fill(step.begin(), step.end(), 0.0);
    for (std::size_t f = 0; f < free.size(); ++f) step[free[f]] = part * motion[f] * scale[f];
    integrate_position<double>(tree, state.q, step, 1.0);
  }
}

// The least change of the free velocities of `state` after which the constraints hold.
void MechanismDynamics::Parts::settle_velocities() {
  update_accelerations<double>(mechanism.tree, workspace, state, rest_accelerations);
  find_axes();
  find_mass();
  factor_selected();
  // Twice: what rounding leaves of large rates goes in the second pass.
  for (int pass = 0; pass < 2; ++pass) {
    for (int k = 0; k < qr.rank(); ++k) {
      const int i = factored[static_cast<std::size_t>(qr.chosen(k))];
      double rate = 0;
      for (int j = 0; j < n; ++j) rate += row[i * n + j] * state.v[j];
      motion[static_cast<std::size_t>(k)] = -rate / row_size[i];
    }
    qr.solve_transposed(motion.data());
    std::fill(motion.begin() + qr.rank(), motion.begin() + static_cast<std::ptrdiff_t>(free.size()), 0.0);
    qr.apply(motion.data());
    for (std::size_t f = 0; f < free.size(); ++f) state.v[free[f]] += motion[f] * scale[f];
  }
}

void MechanismDynamics::Parts::make_quaternions_unit() {
  std::fill(step.begin(), step.end(), 0.0);
  integrate_position<double>(mechanism.tree, state.q, step, 0.0);
}

double MechanismDynamics::project_positions(std::span<double> q) {
  Parts& p = *parts_;
  p.load_positions(q);
  if (p.stale && !p.acting_rows.empty()) p.select_rows();
  p.make_quaternions_unit();
  const double gap = p.acting_rows.empty() ? 0 : p.close_positions(true);
  std::copy(p.state.q.begin(), p.state.q.end(), q.begin());
  return gap;
}

void MechanismDynamics::project_velocities(std::span<const double> q, std::span<double> v) {
  Parts& p = *parts_;
  p.load(q, v);
  if (p.acting_rows.empty()) return;
  if (p.stale) p.select_rows();
  p.settle_velocities();
  std::copy(p.state.v.begin(), p.state.v.end(), v.begin());
}

double MechanismDynamics::project(std::span<double> q, std::span<double> v) {
  const double gap = project_positions(q);
  project_velocities(q, v);
  return gap;
}

double MechanismDynamics::gap(std::size_t constraint, std::span<const double> q) {
  Parts& p = *parts_;
  detail::require_index("gap", "constraint", static_cast<std::ptrdiff_t>(constraint), p.of_constraint.size());
  p.load_positions(q);
  update_poses<double>(p.mechanism.tree, p.workspace, p.state.q);
  return constraint_gap(p.mechanism.tree, p.workspace, p.mechanism.constraints[constraint], p.free_axis[constraint]);
}

double MechanismDynamics::gap_rate(std::size_t constraint, std::span<const double> q, std::span<const double> v) {
  Parts& p = *parts_;
  detail::require_index("gap_rate", "constraint", static_cast<std::ptrdiff_t>(constraint), p.of_constraint.size());
  p.load(q, v);
  const VelocityConstraint<double>& c = p.mechanism.constraints[constraint];
  update_velocities<double>(p.mechanism.tree, p.workspace, p.state);
  double rate = 0;
  for_each_unit_force(
      p.mechanism.tree, p.workspace, c, constraint_force(p.mechanism.tree, p.workspace, c),
      [&](int on, int from, const PlacedForce<double>& unit) { rate += power_between(p.workspace, on, from, unit); });
  return rate;
}

double MechanismDynamics::largest_gap(std::span<const double> q) {
  double worst = 0;
  for (const int i : parts_->acting_rows)
    if (binds_positions(parts_->mechanism.constraints[static_cast<std::size_t>(i)]))
      worst = std::max(worst, std::abs(gap(static_cast<std::size_t>(i), q)));
  return worst;
}

double MechanismDynamics::largest_rate(std::span<const double> q, std::span<const double> v) {
  double worst = 0;
  for (const int i : parts_->acting_rows)
    worst = std::max(worst, std::abs(gap_rate(static_cast<std::size_t>(i), q, v)));
  return worst;
}

void MechanismDynamics::hold(std::span<double> q, std::span<double> v) {
  const double gap = project(q, v);
  const double here = independence();
  parts_->most_independence = std::max(parts_->most_independence, here);
  if (!(gap < open_gap)) throw SingularPose("the constraints cannot hold here");
  if (!(here > lost_independence * parts_->most_independence))
    throw SingularPose("the constraints depend on one another here");
}

// After factor_selected: of the directions of the rows, and of their sizes, since one may vanish by itself.
double MechanismDynamics::Parts::selected_independence() const {
  if (acting_rows.empty() || selected.empty()) return 1;
  if (qr.rank() < static_cast<int>(selected.size())) return 0;
  double least = std::numeric_limits<double>::infinity(), largest = 0;
  for (const int i : selected) {
    const double size = row_size[static_cast<std::size_t>(i)] / unit_of(i);
    least = std::min(least, size);
    largest = std::max(largest, size);
  }
  return largest > 0 ? qr.least_pivot() * least / largest : 0;
}

double MechanismDynamics::independence() const { return parts_->selected_independence(); }

std::vector<std::size_t> MechanismDynamics::redundant_constraints() const {
  std::vector<std::size_t> redundant;
  for (const int i : parts_->acting_rows)
    if (std::find(parts_->selected.begin(), parts_->selected.end(), i) == parts_->selected.end())
      redundant.push_back(static_cast<std::size_t>(i));
  return redundant;
}

}  // namespace poinsot
