#include "poinsot/engine/motion/mechanism/mechanism_dynamics.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "engine/motion/mechanism/mechanism_parts.h"
#include "poinsot/engine/dynamics/capstan.h"
#include "poinsot/engine/dynamics/constraint.h"
#include "poinsot/engine/dynamics/hybrid_dynamics.h"
#include "poinsot/engine/dynamics/inverse_dynamics.h"
#include "poinsot/engine/dynamics/mass_matrix.h"

namespace poinsot {
namespace {

// Of the inertia that a coordinate moves, what counts as none: rounding of a slender body's about its own line, some
// ten units in the last place. A thousand times more would take the moment of a wire of a metre and a micrometre for
// none.
constexpr double no_inertia = 1e-14;
// What moves no mass counts as this part of the largest, so that it gives way first when a state is projected: so
// little that it yields a hundred times as far as what has mass, and no less, as the scales of rows would go apart.
constexpr double light = 1e-4;
// In scaled units, where each coordinate has inertia one: what is left of the inertia of a combination of coordinates
// that moves nothing, the rounding of a few hundred terms near one.
constexpr double no_free_inertia = 1e-13;
// Of columns of length one, unknown forces that have the same effect: points of action and directions are drawn to
// 1e-12.
constexpr double dependent = 1e-11;
// Poses whose constraints are less independent than this part of the most: there a step's error of 1e-12 across the
// branch is magnified by the square of one over it, four hundred times, and begins to be seen. A second pass takes it
// out, which costs as much as the first, so that poses farther off do without.
constexpr double nearly_singular = 0.05;

// Of a direction of length one in which forces are open: a component that is less of it takes no part.
constexpr double part_of_open = 1e-9;

}  // namespace

void MechanismDynamics::Parts::load_positions(std::span<const double> q) {
  detail::require_size("MechanismDynamics", "q", q.size(), mechanism.tree.position_size());
  std::copy(q.begin(), q.end(), state.q.begin());
}

void MechanismDynamics::Parts::load(std::span<const double> q, std::span<const double> v) {
  load_positions(q);
  detail::require_size("MechanismDynamics", "v", v.size(), n);
  std::copy(v.begin(), v.end(), state.v.begin());
}

// Of each coordinate: the motion of its body per unit of it. After update_poses.
void MechanismDynamics::Parts::find_axes() {
  for (int k = 0; k < n; ++k) {
    const BodyMotion<double>& motion_of_body = workspace.motion[static_cast<std::size_t>(body_of[k] + 1)];
    const SpatialMotion<double> S =
        detail::coordinate_motion(mechanism.tree.body(body_of[k]), place_in_joint[k], motion_of_body.R);
    angular[k] = S.angular;
    linear[k] = S.linear;
    origin[k] = motion_of_body.p;
  }
}

// Power of a force on the body of a coordinate, per unit of the coordinate's rate.
double MechanismDynamics::Parts::rate_of(int k, const PlacedForce<double>& force) const {
  return dot(linear[k], force.force) + dot(angular[k], force.couple + cross(force.point - origin[k], force.force));
}

void MechanismDynamics::Parts::add_generalised(const Range& range, const PlacedForce<double>& force, double factor,
                                               double* into) const {
  for (int i = range.first; i < range.last; ++i) {
    const Coupling& coupling = couplings[static_cast<std::size_t>(i)];
    into[coupling.coordinate] += factor * coupling.sign * rate_of(coupling.coordinate, force);
  }
}

PlacedForce<double> MechanismDynamics::Parts::force_of_component(int component) const {
  const auto j = static_cast<std::size_t>(component);
  PlacedForce<double> force = poinsot::component_force(mechanism.tree, workspace, mechanism.components[j]);
  if (links[j].rolling >= 0)
    follow_contact(mechanism.tree, workspace, mechanism.constraints[static_cast<std::size_t>(links[j].rolling)], force);
  return force;
}

// Generalised forces of drives and of the laws of force. After update_velocities and find_axes where there are laws.
void MechanismDynamics::Parts::find_known_forces() {
  std::fill(known.begin(), known.end(), 0.0);
  for (const Drive<double>& drive : mechanism.drives) known[drive.coordinate] += drive.known_effort(state);
  const Range* range = of_law.data();
  for_each_law(mechanism, [&](const auto& law) {
    add_generalised(*range++, law.exerted(mechanism.tree, workspace), 1, known.data());
  });
  // What the sides of belts pull however they are loaded. Belts have constraints, so that all axes are known here.
  for (const int k : with_offset)
    add_generalised(of_component[static_cast<std::size_t>(k)], force_of_component(k),
                    mechanism.components[static_cast<std::size_t>(k)].offset, known.data());
}

void MechanismDynamics::Parts::find_accelerations(std::span<double> result) {
  if (stale && !acting_rows.empty()) select_rows();
  by_tree = acting_rows.empty() && !forces_unknown && !inertia_singular;
  if (by_tree) {
    find_by_tree(result);
    return;
  }
  find_under_constraints(result);
  // Where branches of the motion cross (a parallelogram linkage lies flat), errors across the branch are magnified
  // without bound by the accelerations there. On the branch itself they go smoothly through.
  const double here = selected_independence();
  most_independence = std::max(most_independence, here);
  if (qr.rank() == 0 || here > nearly_singular * most_independence) return;
  make_quaternions_unit();
  close_positions(true);
  settle_velocities();
  find_under_constraints(result);
}

void MechanismDynamics::Parts::find_by_tree(std::span<double> result) {
  if (!of_law.empty()) {
    update_velocities(mechanism.tree, workspace, state);
    find_axes();
  }
  find_known_forces();
  for (int k = 0; k < n; ++k) {
    acceleration[k] = given[k];
    held_force[k] = known[k];
  }
  hybrid_dynamics(mechanism.tree, workspace, state, std::span<double>(acceleration), std::span<double>(held_force));
  for (const int k : held) held_force[k] -= known[k];
  std::copy(acceleration.begin(), acceleration.end(), result.begin());
}

// The mass matrix and the scales that make its diagonal one. After find_axes or without it: reads state.q alone.
void MechanismDynamics::Parts::find_mass() {
  mass_matrix<double>(mechanism.tree, workspace, state.q, mass);
  for (std::size_t f = 0; f < free.size(); ++f) {
    const int k = free[f];
    const SpatialInertia<double>& I = workspace.composite[static_cast<std::size_t>(body_of[k] + 1)].inertia;
    const double own = mass[k * n + k];
    const double moved = turns[k] ? I.inertia.xx + I.inertia.yy + I.inertia.zz : I.mass;
    without_inertia[f] = !(own > no_inertia * moved);
    scale[f] = 1 / std::sqrt(without_inertia[f] ? light * largest_mass * (turns[k] ? length * length : 1) : own);
  }
}

// Q^T M Q on scaled coordinates, for the Q of the constraints. After find_mass.
void MechanismDynamics::Parts::split_mass() {
  const std::size_t size = free.size();
  for (std::size_t j = 0; j < size; ++j)
    for (std::size_t i = 0; i <= j; ++i) {
      const bool none = without_inertia[i] || without_inertia[j];
      split[j * size + i] = split[i * size + j] = none ? 0 : scale[i] * scale[j] * mass_entry(free[i], free[j]);
    }
  if (qr.rank() == 0) return;
  for (int pass = 0; pass < 2; ++pass) {
    qr.apply_transposed(split.data(), static_cast<int>(size));
    for (std::size_t j = 0; j < size; ++j)
      for (std::size_t i = 0; i < j; ++i) std::swap(split[j * size + i], split[i * size + j]);
  }
}

void MechanismDynamics::Parts::find_under_constraints(std::span<double> result) {
  const std::size_t size = free.size();
  update_accelerations<double>(mechanism.tree, workspace, state, given);
  find_axes();
  if (capstans) update_capstans(mechanism, workspace);
  find_known_forces();
  inverse_dynamics<double>(mechanism.tree, workspace, state, given, bias_force);
  find_mass();
  factor_selected();
  split_mass();
  const auto rank = static_cast<std::size_t>(qr.rank());

  // Q^T (Q - h), and R^T u = -b.
  for (std::size_t f = 0; f < size; ++f) right[f] = scale[f] * (known[free[f]] - bias_force[free[f]]);
  qr.apply_transposed(right.data());
  for (std::size_t k = 0; k < rank; ++k) {
    const auto i = static_cast<std::size_t>(factored[static_cast<std::size_t>(qr.chosen(static_cast<int>(k)))]);
    motion[k] = -row_bias[i] / row_size[i];
  }
  qr.solve_transposed(motion.data());

  std::fill(multiplier.begin(), multiplier.end(), 0.0);
  force_misfit = 0;
  if (forces_unknown) {
    find_with_unknown_forces();
  } else {
    // What the constraints leave free.
    const std::size_t left = size - rank;
    for (std::size_t i = 0; i < left; ++i) {
      double sum = right[rank + i];
      for (std::size_t k = 0; k < rank; ++k) sum -= split[(rank + i) * size + k] * motion[k];
      motion[rank + i] = sum;
      const bool none = !(split[(rank + i) * size + rank + i] > no_free_inertia);
      for (std::size_t j = 0; j <= i; ++j) {
        const bool other_none = !(split[(rank + j) * size + rank + j] > no_free_inertia);
        block[i * left + j] = none || other_none ? 0 : split[(rank + i) * size + rank + j];
      }
    }
    detail::solve_semidefinite(std::span<double>(block.data(), left * left),
                               std::span<double>(motion.data() + rank, left), std::span<int>(block_order.data(), left),
                               std::span<double>(block_diagonal.data(), left), no_free_inertia);
    // The multipliers.
    for (std::size_t i = 0; i < rank; ++i) {
      double sum = -right[i];
      for (std::size_t k = 0; k < size; ++k) sum += split[k * size + i] * motion[k];
      rest[i] = sum;
    }
    qr.solve_upper(rest.data());
    for (std::size_t k = 0; k < rank; ++k) {
      const auto i = static_cast<std::size_t>(factored[static_cast<std::size_t>(qr.chosen(static_cast<int>(k)))]);
      multiplier[i] = rest[k] / row_size[i];
    }
  }
  qr.apply(motion.data());
  acceleration = given;
  for (std::size_t f = 0; f < size; ++f) acceleration[free[f]] = scale[f] * motion[f];
  std::copy(acceleration.begin(), acceleration.end(), result.begin());
  for (const int k : held) held_force[k] = find_held_effort(k);
}

// Unknown are what the constraints leave free, z, and the sizes p of the components that work: in the turned
// coordinates, M' [u; z] = Q^T (Q - h) + Q^T C p. Their basic solution.
void MechanismDynamics::Parts::find_with_unknown_forces() {
  const std::size_t size = free.size();
  const auto rank = static_cast<std::size_t>(qr.rank());
  const std::size_t left = size - rank;
  force_qr.resize(static_cast<int>(size), static_cast<int>(left + acting_columns.size()));
  const auto set_column = [&](std::size_t j, const double* x) {
    for (std::size_t i = 0; i < size; ++i) force_qr.entry(static_cast<int>(i), static_cast<int>(j)) = x[i];
  };
  for (std::size_t j = 0; j < left; ++j) set_column(j, split.data() + (rank + j) * size);
  for (std::size_t c = 0; c < acting_columns.size(); ++c) {
    const auto component = static_cast<std::size_t>(acting_columns[c]);
    double* const C = column.data() + component * static_cast<std::size_t>(n);
    std::fill(C, C + n, 0.0);
    for_each_follower(mechanism.components, component, [&](std::size_t k) {
      const double part = mechanism.components[k].follows < 0 ? 1 : mechanism.components[k].followed_part();
      add_generalised(of_component[k], force_of_component(static_cast<int>(k)), -part, C);
    });
    double* const out = rest.data();
    double sum = 0;
    for (std::size_t f = 0; f < size; ++f) {
      out[f] = scale[f] * C[free[f]];
      sum += out[f] * out[f];
    }
    column_size[component] = std::sqrt(sum);
    if (sum > 0)
      for (std::size_t f = 0; f < size; ++f) out[f] /= column_size[component];
    qr.apply_transposed(out);
    set_column(left + c, out);
  }
  for (std::size_t i = 0; i < size; ++i) {
    rest[i] = right[i];
    for (std::size_t k = 0; k < rank; ++k) rest[i] -= split[k * size + i] * motion[k];
  }
  force_qr.factor(dependent);
  force_qr.apply_transposed(rest.data());
  double largest = 0, misfit = 0;
  for (std::size_t i = 0; i < size; ++i) {
    largest = std::max({largest, std::abs(rest[i]), std::abs(right[i])});
    if (i >= static_cast<std::size_t>(force_qr.rank())) misfit = std::max(misfit, std::abs(rest[i]));
  }
  force_misfit = largest > 0 ? misfit / largest : 0;
  force_qr.solve_upper(rest.data());
  std::fill(component_size.begin(), component_size.end(), 0.0);
  std::fill(motion.begin() + static_cast<std::ptrdiff_t>(rank), motion.begin() + static_cast<std::ptrdiff_t>(size),
            0.0);
  for (int k = 0; k < force_qr.rank(); ++k) {
    const auto place = static_cast<std::size_t>(force_qr.chosen(k));
    if (place < left) {
      motion[rank + place] = rest[static_cast<std::size_t>(k)];
    } else {
      const auto component = static_cast<std::size_t>(acting_columns[place - left]);
      component_size[component] = rest[static_cast<std::size_t>(k)] / column_size[component];
    }
  }
}

double MechanismDynamics::Parts::find_held_effort(int coordinate) const {
  double effort = bias_force[coordinate] - known[coordinate];
  for (const int k : free) effort += mass_entry(coordinate, k) * acceleration[k];
  if (forces_unknown) {
    for (const int j : acting_columns)
      effort += column[static_cast<std::size_t>(j * n + coordinate)] * component_size[static_cast<std::size_t>(j)];
  } else {
    for (const int i : selected)
      effort -= row[static_cast<std::size_t>(i * n + coordinate)] * multiplier[static_cast<std::size_t>(i)];
  }
  return effort;
}

MechanismDynamics::MechanismDynamics(const Mechanism<double>& mechanism, std::span<const int> also_held)
    : parts_(std::make_unique<Parts>(mechanism, also_held)) {}
MechanismDynamics::MechanismDynamics(MechanismDynamics&& other) noexcept = default;
MechanismDynamics& MechanismDynamics::operator=(MechanismDynamics&& other) noexcept = default;
MechanismDynamics::~MechanismDynamics() = default;

const Mechanism<double>& MechanismDynamics::mechanism() const { return parts_->mechanism; }

double MechanismDynamics::natural_length() const { return parts_->length; }

bool MechanismDynamics::is_held(int coordinate) const {
  detail::require_index("is_held", "coordinate", coordinate, parts_->is_held.size());
  return parts_->is_held[coordinate];
}

std::span<const int> MechanismDynamics::held_coordinates() const { return parts_->held; }

void MechanismDynamics::set_held_acceleration(int coordinate, double acceleration) {
  if (!is_held(coordinate))
    throw std::invalid_argument("set_held_acceleration: coordinate " + std::to_string(coordinate) +
                                " is not held; its acceleration follows from the forces");
  parts_->given[coordinate] = acceleration;
}

void MechanismDynamics::set_force(std::size_t force, const Vector3<double>& vector) {
  detail::require_index("set_force", "force", static_cast<std::ptrdiff_t>(force), parts_->mechanism.forces.size());
  parts_->mechanism.forces[force].vector = vector;
}

void MechanismDynamics::set_effort(std::size_t drive, double effort) {
  detail::require_index("set_effort", "drive", static_cast<std::ptrdiff_t>(drive), parts_->mechanism.drives.size());
  parts_->mechanism.drives[drive].effort = effort;
}

void MechanismDynamics::set_direction(std::size_t component, const Vector3<double>& along) {
  detail::require_index("set_direction", "component", static_cast<std::ptrdiff_t>(component),
                        parts_->mechanism.components.size());
  parts_->mechanism.components[component].along.vector = along;
}

void MechanismDynamics::set_acting(int action, bool acting) {
  detail::require_index("set_acting", "action", action, parts_->acting.size());
  if (parts_->acting[action] == static_cast<char>(acting)) return;
  parts_->acting[action] = acting;
  parts_->find_acting();
}

bool MechanismDynamics::is_acting(int action) const {
  detail::require_index("is_acting", "action", action, parts_->acting.size());
  return parts_->acting[action];
}

void MechanismDynamics::accelerations(std::span<const double> q, std::span<const double> v,
                                      std::span<double> acceleration) {
  parts_->load(q, v);
  detail::require_size("MechanismDynamics", "acceleration", acceleration.size(), parts_->n);
  parts_->find_accelerations(acceleration);
}

double MechanismDynamics::component_force(std::size_t component) const {
  const Parts& p = *parts_;
  detail::require_index("component_force", "component", static_cast<std::ptrdiff_t>(component), p.links.size());
  const Component<double>& own = p.mechanism.components[component];
  if (own.follows >= 0)
    return own.followed_part() * component_force(static_cast<std::size_t>(own.follows)) + own.offset;
  const Parts::Link& link = p.links[component];
  if (p.by_tree || !link.works || !p.acting[p.mechanism.components[component].action]) return 0;
  if (p.forces_unknown) return p.component_size[component];
  return link.sign * p.multiplier[link.constraint];
}

bool MechanismDynamics::component_determined(std::size_t component) const {
  const Parts& p = *parts_;
  detail::require_index("component_determined", "component", static_cast<std::ptrdiff_t>(component), p.links.size());
  if (const int follows = p.mechanism.components[component].follows; follows >= 0)
    return component_determined(static_cast<std::size_t>(follows));
  const Parts::Link& link = p.links[component];
  if (!p.acting[p.mechanism.components[component].action]) return true;
  if (!link.works) return false;
  if (!p.forces_unknown) return !p.shared[link.constraint];
  // It must have no part in what the equations leave open.
  const std::size_t left = p.free.size() - static_cast<std::size_t>(p.qr.rank());
  std::vector<double> open(p.free.size() + p.links.size());
  for (int k = p.force_qr.rank(); k < p.force_qr.columns(); ++k) {
    const auto place = [&](int at) { return static_cast<std::size_t>(p.force_qr.chosen(at)); };
    const auto is_component = [&](int at) {
      return place(at) >= left && p.acting_columns[place(at) - left] == static_cast<int>(component);
    };
    if (is_component(k)) return false;
    for (int i = 0; i < p.force_qr.rank(); ++i) open[i] = p.force_qr.R(i, k);
    p.force_qr.solve_upper(open.data());
    for (int i = 0; i < p.force_qr.rank(); ++i)
      if (is_component(i) && std::abs(open[i]) > part_of_open) return false;
  }
  return true;
}

double MechanismDynamics::held_effort(int coordinate) const {
  if (!is_held(coordinate))
    throw std::invalid_argument("held_effort: coordinate " + std::to_string(coordinate) + " is not held");
  return parts_->held_force[coordinate];
}

}  // namespace poinsot
