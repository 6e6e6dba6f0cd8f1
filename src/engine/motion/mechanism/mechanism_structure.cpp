// What does not change with the motion: who moves whom, which component enforces which constraint, what has inertia.
#include <algorithm>
#include <cmath>
#include <random>
#include <string>

#include "engine/motion/mechanism/mechanism_parts.h"
#include "poinsot/engine/dynamics/capstan.h"
#include "poinsot/engine/dynamics/mass_matrix.h"

namespace poinsot {
namespace {

using Vector = Vector3<double>;

// The same tree with the modes of held coordinates.
Model<double> with_modes(const Model<double>& tree, const std::vector<char>& is_held) {
  std::vector<CoordinateMode> modes;
  modes.reserve(is_held.size());
  for (const char held : is_held) modes.push_back(held ? CoordinateMode::prescribed : CoordinateMode::free);
  return Model<double>(std::vector<Body<double>>(tree.bodies().begin(), tree.bodies().end()), tree.names(),
                       std::move(modes), tree.gravity());
}

std::vector<char> find_held(const Mechanism<double>& mechanism, std::span<const int> also_held) {
  const int n = mechanism.tree.velocity_size();
  std::vector<char> driven(static_cast<std::size_t>(n), 0), held(static_cast<std::size_t>(n), 0);
  for (const Drive<double>& drive : mechanism.drives) {
    driven[static_cast<std::size_t>(drive.coordinate)] = 1;
    if (drive.held) held[static_cast<std::size_t>(drive.coordinate)] = 1;
  }
  for (int i = 0; i < mechanism.tree.body_count(); ++i) {
    if (mechanism.takes_part[static_cast<std::size_t>(i)]) continue;
    const Body<double>& body = mechanism.tree.body(i);
    for (int k = body.v; k < body.v + velocity_size(body.joint); ++k)
      if (!driven[static_cast<std::size_t>(k)]) held[static_cast<std::size_t>(k)] = 1;
  }
  for (const int k : also_held) {
    detail::require_index("MechanismDynamics", "coordinate to be held", k, held.size());
    held[static_cast<std::size_t>(k)] = 1;
  }
  return held;
}

Mechanism<double> with_held(Mechanism<double> mechanism, const std::vector<char>& is_held) {
  mechanism.tree = with_modes(mechanism.tree, is_held);
  return mechanism;
}

// Two vectors that were made from the same data: apart by the rounding of a few operations on numbers of a size, and at
// most by ten times less than what a joint's place could be told apart by in a drawing of eleven digits.
bool same(const Vector& a, const Vector& b, double size) {
  constexpr double drawn = 1e-12;  // points and directions are computed from data, in a few hundred roundings
  return norm(a - b) <= drawn * (size + norm(a));
}

}  // namespace

MechanismDynamics::Parts::Parts(const Mechanism<double>& stated, std::span<const int> also_held)
    : mechanism(with_held(stated, find_held(stated, also_held))),
      n(mechanism.tree.velocity_size()),
      workspace(mechanism.tree),
      state(neutral_state(mechanism.tree)) {
  const Model<double>& tree = mechanism.tree;
  const auto size = static_cast<std::size_t>(n);
  for (int i = 0; i < tree.body_count(); ++i) {
    const Body<double>& body = tree.body(i);
    for (int k = 0; k < velocity_size(body.joint); ++k) {
      body_of.push_back(i);
      place_in_joint.push_back(k);
      turns.push_back(body.joint != JointType::prismatic && !(body.joint == JointType::free && k >= 3));
      const bool given_here = tree.mode(body.v + k) != CoordinateMode::free;
      is_held.push_back(given_here);
      (given_here ? held : free).push_back(body.v + k);
    }
  }
  acting.assign(mechanism.actions.size(), 1);
  links.resize(mechanism.components.size());
  capstans = has_capstans(mechanism);
  for (std::size_t k = 0; k < mechanism.components.size(); ++k)
    if (mechanism.components[k].offset != 0) with_offset.push_back(static_cast<int>(k));
  find_couplings();

  for (std::vector<Vector>* list : {&angular, &linear, &origin}) list->assign(size, Vector::zero());
  for (std::vector<double>* list :
       {&given, &known, &bias_force, &held_force, &acceleration, &step, &rest_accelerations})
    list->assign(size, 0.0);
  const std::size_t f = free.size(), m = mechanism.constraints.size(), c = mechanism.components.size();
  mass.assign(size * size, 0.0);
  for (std::vector<double>* list : {&scale, &right, &motion, &block_diagonal, &rest}) list->assign(f + m + c, 0.0);
  without_inertia.assign(f, 0);
  row.assign(m * size, 0.0);
  column.assign(c * size, 0.0);
  for (std::vector<double>* list : {&row_bias, &row_size, &multiplier}) list->assign(m, 0.0);
  for (std::vector<double>* list : {&column_size, &component_size}) list->assign(c, 0.0);
  shared.assign(m, 0);
  classes.assign(m, 0);
  split.assign(f * f, 0.0);
  block.assign(f * f, 0.0);
  block_order.assign(f, 0);
  qr.reserve(static_cast<int>(f), static_cast<int>(m));
  force_qr.reserve(static_cast<int>(f), static_cast<int>(f + c));
  for (std::vector<int>* list : {&acting_rows, &selected, &factored, &position_rows}) list->reserve(m);
  acting_columns.reserve(c);
  saved_q = best_q = state.q;
  saved_v = state.v;
  find_structure();
}

MechanismDynamics::Parts::Range MechanismDynamics::Parts::couple(int on, int from) {
  const Model<double>& tree = mechanism.tree;
  const int first = static_cast<int>(couplings.size());
  const auto hangs_on = [&](int body, int ancestor) {
    for (int i = body; i != ground; i = tree.body(i).parent)
      if (i == ancestor) return true;
    return false;
  };
  for (const auto& [end, other, sign] : {std::tuple{on, from, 1.0}, std::tuple{from, on, -1.0}})
    for (int i = end; i != ground && !hangs_on(other, i); i = tree.body(i).parent)
      for (int k = 0; k < velocity_size(tree.body(i).joint); ++k) couplings.push_back({tree.body(i).v + k, sign});
  return {first, static_cast<int>(couplings.size())};
}

void MechanismDynamics::Parts::find_couplings() {
  const auto of_action = [&](int index) {
    const Action& action = mechanism.actions[static_cast<std::size_t>(index)];
    return couple(action.on, action.from);
  };
  for (std::size_t i = 0; i < mechanism.constraints.size(); ++i) {
    const VelocityConstraint<double>& c = mechanism.constraints[i];
    of_constraint.push_back(couple(c.on, c.from));
    of_spans.emplace_back();
    for (const CordSpan<double>& span : c.spans) of_spans.back().push_back(couple(span.to.body(), span.from.body()));
    free_axis.push_back(c.kind == VelocityConstraintKind::angular ? axis_left_free(mechanism.constraints, i)
                                                                  : std::nullopt);
  }
  for (const Component<double>& component : mechanism.components) of_component.push_back(of_action(component.action));
  for_each_law(mechanism, [&](const auto& law) { of_law.push_back(of_action(law.action)); });
}

// Whether a component stands along a constraint wherever the mechanism goes.
bool MechanismDynamics::Parts::enforces(const Component<double>& component, const VelocityConstraint<double>& c,
                                        double& sign) const {
  // A cord pulls along all its parts between two wheels that it does not slip on. The length of a whole cord over such
  // wheels is no force's own.
  if (component.span) {
    sign = -1;
    bool alike = true;  // Where it slips with friction its parts pull with forces of their own.
    for_each_follower(mechanism.components, static_cast<std::size_t>(&component - mechanism.components.data()),
                      [&](std::size_t k) {
                        alike = alike && mechanism.components[k].gain == 0 && mechanism.components[k].offset == 0;
                      });
    return alike && c.action == component.action && c.spans.size() == parts_with(component) && component.follows < 0;
  }
  const Action& action = mechanism.actions[static_cast<std::size_t>(component.action)];
  if (action.on != c.on || action.from != c.from || (c.action >= 0 && c.action != component.action)) return false;
  if (component.couple != (c.kind == VelocityConstraintKind::angular)) return false;
  if (component.at.body != c.at.body || component.couple_per_force != 0) return false;
  // Couples act alike everywhere.
  if (!component.couple && !same(component.at.point, c.at.point, length)) return false;
  if (component.toward.has_value() != (c.kind == VelocityConstraintKind::cord_length)) return false;
  if (component.toward) {
    sign = -1;
    return component.toward->body == c.toward.body && same(component.toward->point, c.toward.point, length);
  }
  if (component.along.body != c.along.body) return false;
  sign = dot(component.along.vector, c.along.vector) < 0 ? -1 : 1;
  return same(sign * component.along.vector, c.along.vector, 1);
}

std::size_t MechanismDynamics::Parts::parts_with(const Component<double>& component) const {
  std::size_t count = 0;
  for_each_follower(mechanism.components, static_cast<std::size_t>(&component - mechanism.components.data()),
                    [&](std::size_t) { ++count; });
  return count;
}

void MechanismDynamics::Parts::link_components() {
  std::vector<char> taken(mechanism.constraints.size(), 0);
  for (std::size_t j = 0; j < mechanism.components.size(); ++j) {
    const Component<double>& component = mechanism.components[j];
    for (std::size_t i = 0; i < mechanism.constraints.size(); ++i) {
      const VelocityConstraint<double>& c = mechanism.constraints[i];
      if (moves_over_surfaces(c) && c.action == component.action) links[j].rolling = static_cast<int>(i);
      if (links[j].constraint >= 0 || taken[i] || !enforces(component, c, links[j].sign)) continue;
      links[j].constraint = static_cast<int>(i);
      taken[i] = 1;
    }
  }
}

// Anywhere: for what holds in every pose.
void MechanismDynamics::Parts::take_random_pose(unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> part(-1, 1);
  state = neutral_state(mechanism.tree);
  for (int k = 0; k < n; ++k) step[static_cast<std::size_t>(k)] = part(random) * (turns[k] ? 1 : length);
  integrate_position<double>(mechanism.tree, state.q, step, 1.0);
}

void MechanismDynamics::Parts::find_structure() {
  const Model<double>& tree = mechanism.tree;
  update_poses<double>(tree, workspace, state.q);
  length = 0;
  largest_mass = 0;
  Vector first = Vector::zero();
  const auto reach = [&](const Vector& p) { length = std::max(length, norm(p - first)); };
  for (int i = 0; i < tree.body_count(); ++i) {
    const SpatialInertia<double>& I = tree.body(i).inertia;
    const Vector p = workspace.motion[static_cast<std::size_t>(i + 1)].p;
    if (i == 0) first = p;
    reach(p);
    if (!(I.mass > 0)) continue;
    largest_mass = std::max(largest_mass, I.mass);
    length = std::max({length, std::sqrt((I.inertia.xx + I.inertia.yy + I.inertia.zz) / (2 * I.mass)),
                       norm(I.first_moment) / I.mass});
  }
  for (const Component<double>& component : mechanism.components)
    reach(point_position(tree, workspace, component.at.body, component.at.point));
  for (const VelocityConstraint<double>& c : mechanism.constraints) reach(constraint_point(tree, workspace, c));
  if (!(length > 0)) length = 1;
  if (!(largest_mass > 0)) largest_mass = 1;

  // Which components work, and whether the tree alone has inertia in every direction.
  link_components();
  inertia_singular = true;
  for (const unsigned seed : {1U, 2U}) {
    take_random_pose(seed);
    update_poses<double>(tree, workspace, state.q);
    find_axes();
    for (std::size_t j = 0; j < links.size(); ++j) {
      const PlacedForce<double> force = force_of_component(static_cast<int>(j));
      const double lever = mechanism.components[j].couple ? 1 : length;
      for (int i = of_component[j].first; i < of_component[j].last; ++i) {
        const int k = couplings[static_cast<std::size_t>(i)].coordinate;
        const double power = rate_of(k, force) * (turns[k] ? 1 : length);
        if (!is_held[k] && std::abs(power) > 1e-9 * lever) links[j].works = true;
      }
    }
    find_mass();
    force_qr.resize(static_cast<int>(free.size()), static_cast<int>(free.size()));
    for (std::size_t j = 0; j < free.size(); ++j)
      for (std::size_t i = 0; i < free.size(); ++i)
        force_qr.entry(static_cast<int>(i), static_cast<int>(j)) =
            without_inertia[i] || without_inertia[j] ? 0 : scale[i] * scale[j] * mass_entry(free[i], free[j]);
    force_qr.factor(1e-12);
    inertia_singular = inertia_singular && force_qr.rank() < force_qr.rows();
  }
  state = neutral_state(tree);
  find_acting();
  if (!acting_rows.empty()) select_rows();
}

void MechanismDynamics::Parts::find_acting() {
  acting_rows.clear();
  acting_columns.clear();
  forces_unknown = false;
  std::fill(classes.begin(), classes.end(), static_cast<char>(0));
  for (std::size_t i = 0; i < mechanism.constraints.size(); ++i) {
    const VelocityConstraint<double>& c = mechanism.constraints[i];
    if (c.action < 0 || acting[static_cast<std::size_t>(c.action)]) acting_rows.push_back(static_cast<int>(i));
  }
  // Each component that works must enforce a constraint, and each constraint must be enforced by a component.
  for (std::size_t j = 0; j < links.size(); ++j) {
    if (links[j].constraint >= 0) classes[static_cast<std::size_t>(links[j].constraint)] = 1;
    if (mechanism.components[j].follows >= 0) continue;
    if (!links[j].works || !acting[static_cast<std::size_t>(mechanism.components[j].action)]) continue;
    acting_columns.push_back(static_cast<int>(j));
    forces_unknown = forces_unknown || links[j].constraint < 0;
  }
  for (const int i : acting_rows) forces_unknown = forces_unknown || !classes[static_cast<std::size_t>(i)];
  stale = true;
  most_independence = 0;
}

}  // namespace poinsot
