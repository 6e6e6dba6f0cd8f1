#include "problem/near/near_steady_formulas.h"

#include <algorithm>
#include <utility>

#include "problem/instant/massless_turning.h"

namespace poinsot::problem {
namespace {

FormulaMatrix product(const FormulaMatrix& A, const FormulaMatrix& B) {
  FormulaMatrix C(A.size(), std::vector<Formula>(B.empty() ? 0 : B.front().size()));
  for (std::size_t i = 0; i < A.size(); ++i)
    for (std::size_t k = 0; k < B.size(); ++k) {
      if (A[i][k].is_zero()) continue;
      for (std::size_t j = 0; j < B[k].size(); ++j)
        if (!B[k][j].is_zero()) C[i][j] += A[i][k] * B[k][j];
    }
  return C;
}
FormulaMatrix sum(const FormulaMatrix& A, const FormulaMatrix& B, int sign = 1) {
  FormulaMatrix C = A;
  for (std::size_t i = 0; i < A.size(); ++i)
    for (std::size_t j = 0; j < A[i].size(); ++j) C[i][j] += Formula(sign) * B[i][j];
  return C;
}
Vector3<Formula> center_of(const SpatialInertia<Formula>& I) {
  return I.mass.is_zero() ? Vector3<Formula>::zero() : Vector3<Formula>(I.first_moment / I.mass);
}

// Whether a body's mass is symmetric about the axis through its mass center along w, so that its turning about it
// changes nothing.
bool looks_the_same(const SpatialInertia<Formula>& I, const Vector3<Formula>& w) {
  if (w.x.is_zero() && w.y.is_zero() && w.z.is_zero()) return false;
  if (I.mass.is_zero()) return true;
  const Matrix3<Formula> central = as_matrix(I.inertia - I.mass * unit_mass_inertia(center_of(I)));
  for (std::size_t k = 0; k < 3; ++k) {
    const Vector3<Formula> e = Vector3<Formula>::unit(k);
    const Vector3<Formula> difference = central * cross(w, e) - cross(w, central * e);
    if (!difference.x.is_zero() || !difference.y.is_zero() || !difference.z.is_zero()) return false;
  }
  return true;
}

// The spins of bodies on ball and free joints in the frame, about their mass centers, that nobody sees.
std::vector<std::pair<int, SpatialMotion<Formula>>> unseen_spins(const SteadyFormulas& motion) {
  const Model<Formula>& tree = motion.machine.mechanism.tree;
  Workspace<Formula> workspace(tree);
  update_velocities(tree, workspace, State<Formula>{motion.q, motion.v});
  const Vector3<Formula> turning =
      motion.frame == ground ? Vector3<Formula>::zero() : angular_velocity(workspace, motion.frame);
  std::vector<std::pair<int, SpatialMotion<Formula>>> spins;
  for (int i = 0; i < tree.body_count(); ++i) {
    const auto& body = tree.body(i);
    if (body.joint != JointType::ball && body.joint != JointType::free) continue;
    const Vector3<Formula> own = direction_on_body(tree, workspace, i, angular_velocity(workspace, i) - turning);
    if (looks_the_same(body.inertia, own)) spins.push_back({i, {own, cross(center_of(body.inertia), own)}});
  }
  return spins;
}

}  // namespace

FormulaMatrix zeros(std::size_t n) { return FormulaMatrix(n, std::vector<Formula>(n)); }

bool vanishes(const FormulaMatrix& A) {
  return std::all_of(A.begin(), A.end(), [](const auto& row) {
    return std::all_of(row.begin(), row.end(), [](const Formula& x) { return x.is_zero(); });
  });
}

SteadyFormulas steady_formulas(const Situation& situation, const MachineOf<Formula>& machine,
                               const std::vector<Formula>& q, const std::vector<Formula>& v, const Machine& numbers) {
  SteadyFormulas motion{machine, q, v, situation.steady ? machine.index.at(situation.steady->frame) : ground, {}, 0};
  for (const auto& rate : machine.accelerations) motion.held.push_back(rate.velocity);
  // Deviations that differ by a motion that moves no mass are the same. Of these the one is looked at in which the
  // coordinate by which that motion is known does not deviate.
  for (const solve::UnseenMotion& unseen : unseen_motions(numbers.mechanism, numbers.q, motion.held))
    motion.held.push_back(unseen.coordinate);
  std::sort(motion.held.begin(), motion.held.end());
  motion.held.erase(std::unique(motion.held.begin(), motion.held.end()), motion.held.end());
  return motion;
}

std::vector<std::size_t> free_coordinates(const SteadyFormulas& motion) {
  std::vector<std::size_t> free;
  for (std::size_t k = 0; k < motion.v.size(); ++k)
    if (std::find(motion.held.begin(), motion.held.end(), static_cast<int>(k)) == motion.held.end()) free.push_back(k);
  return free;
}

LinearisedFormulas linearised(const SteadyFormulas& motion, const std::vector<std::size_t>& free) {
  const Mechanism<Formula>& mechanism = motion.machine.mechanism;
  const FormulaMatrix S = solve::adjoint_rows(mechanism.tree, unseen_spins(motion));
  const FormulaMatrix D = solve::adjoint_rows(mechanism.tree, solve::own_twists(mechanism.tree, motion.v));
  // The accelerations of the steady motion: v is constant on axes that follow the frame and not the spin.
  const std::size_t n = motion.v.size();
  std::vector<Formula> a(n);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t k = 0; k < n; ++k) a[i] -= S[i][k] * motion.v[k];
  for (const auto& rate : motion.machine.accelerations) a[static_cast<std::size_t>(rate.velocity)] = rate.value;

  // How M a + h - Q varies, which is zero along the motion.
  LinearisedFormulas result;
  const State<Formula> state{motion.q, motion.v};
  const std::vector<Formula> left = solve::remainder_of(mechanism, state, a, {}).forces;
  for (const std::size_t i : free) result.unrest.push_back(left[i]);
  // Axes that turn with a body carry deviations of its free coordinates over to one that does not deviate itself, whose
  // velocity then does.
  const FormulaMatrix drift = sum(D, S, -1);
  std::vector<std::size_t> carried = free;
  for (std::size_t k = 0; k < n; ++k)
    if (std::ranges::find(free, k) == free.end() && !(vanishes({drift[k]}) && vanishes({S[k]}))) carried.push_back(k);
  const solve::RemainderSlopes<Formula> slopes(mechanism, state, a, {});
  FormulaMatrix by_position = zeros(n), by_velocity = zeros(n);
  for (const std::size_t k : carried) {
    const std::vector<Formula> hastened = slopes.by_velocity(k).forces;
    for (const std::size_t i : free) by_velocity[i][k] = hastened[i];
  }
  for (const std::size_t k : free) {
    const std::vector<Formula> moved = slopes.by_position(k).forces;
    for (const std::size_t i : free) by_position[i][k] = moved[i];
  }
  const auto part = [](const FormulaMatrix& A, const std::vector<std::size_t>& rows,
                       const std::vector<std::size_t>& columns) {
    FormulaMatrix some;
    for (const std::size_t i : rows) {
      some.emplace_back();
      for (const std::size_t k : columns) some.back().push_back(A[i][k]);
    }
    return some;
  };
  // With y = (l - S + D) x the deviations of the velocities, M (l - S) y + r_v y + r_q x = 0.
  const FormulaMatrix all_mass = solve::mass_rows(mechanism.tree, motion.q);
  const FormulaMatrix M = part(all_mass, free, carried), Rv = part(by_velocity, free, carried);
  const FormulaMatrix spin = part(S, carried, free), all_spin = part(S, carried, carried);
  const FormulaMatrix carries = part(drift, carried, free);
  result.M = part(all_mass, free, free);
  result.C = sum(product(M, sum(carries, spin, -1)), part(by_velocity, free, free));
  result.K = sum(sum(product(Rv, carries), product(product(M, all_spin), carries), -1), part(by_position, free, free));
  result.follows_spin = !vanishes(spin) || !vanishes(carries);
  return result;
}

std::optional<LinearisedFormulas> linearised_with_constraints(const SteadyFormulas& motion,
                                                              const std::vector<std::size_t>& free) {
  const Mechanism<Formula>& mechanism = motion.machine.mechanism;
  const std::size_t n = motion.v.size();
  if (motion.components.size() != mechanism.components.size()) return std::nullopt;
  // Axes do not turn relative to those of the coordinates.
  for (int i = 0; i < mechanism.tree.body_count(); ++i)
    if (velocity_size(mechanism.tree.body(i).joint) > 1) return std::nullopt;
  std::vector<Formula> a(n);
  for (const auto& rate : motion.machine.accelerations) a[static_cast<std::size_t>(rate.velocity)] = rate.value;
  const solve::EquationMatrices<Formula> all = solve::equation_matrices(mechanism, motion.q);
  const solve::RemainderSlopes<Formula> slopes(mechanism, State<Formula>{motion.q, motion.v}, a, motion.components);
  const std::size_t count = free.size();
  LinearisedFormulas near{zeros(count), zeros(count), zeros(count)};
  FormulaMatrix by_position(all.J.size()), by_velocity(all.J.size());
  for (std::size_t k = 0; k < count; ++k) {
    const solve::Remainder<Formula> moved = slopes.by_position(free[k]), hastened = slopes.by_velocity(free[k]);
    for (std::size_t i = 0; i < count; ++i) {
      near.M[i][k] = all.M[free[i]][free[k]];
      near.C[i][k] = hastened.forces[free[i]];
      near.K[i][k] = moved.forces[free[i]];
    }
    for (std::size_t i = 0; i < all.J.size(); ++i) {
      by_position[i].push_back(moved.rates[i]);
      by_velocity[i].push_back(hastened.rates[i]);
    }
  }
  for (std::size_t i = 0; i < all.J.size(); ++i) {
    if (vanishes({by_velocity[i]}) && vanishes({by_position[i]})) continue;
    near.J.push_back(by_velocity[i]);
    near.B.push_back(by_position[i]);
  }
  near.W.resize(count);
  for (std::size_t j = 0; j < mechanism.components.size(); ++j) {
    if (std::ranges::all_of(free, [&](std::size_t k) { return all.C[k][j].is_zero(); })) continue;
    for (std::size_t i = 0; i < count; ++i) near.W[i].push_back(all.C[free[i]][j]);
  }
  if (near.J.empty() || near.W.front().size() != near.J.size()) return std::nullopt;
  return near;
}

std::vector<Formula> coefficients_by(Formula rest, const std::string& letter, std::size_t degree) {
  std::vector<Formula> c;
  Formula factorial(1);
  for (std::size_t k = 0; !rest.is_zero() && k <= degree; ++k) {
    if (k > 0) factorial *= Formula(static_cast<std::int64_t>(k));
    c.push_back(poinsot::substituted(rest, {{letter, Formula(0)}}) / factorial);
    rest = derivative(rest, letter);
  }
  return c;
}

std::vector<Formula> characteristic_polynomial(const LinearisedFormulas& near) {
  const std::string name = "rate of growth";
  const Formula l = Formula::letter(name, poinsot::Sign::real);
  FormulaMatrix P = near.K;
  for (std::size_t i = 0; i < P.size(); ++i)
    for (std::size_t k = 0; k < P.size(); ++k) P[i][k] += l * near.C[i][k] + l * l * near.M[i][k];
  const std::size_t free = P.size();
  for (std::size_t i = 0; i < free && !near.J.empty(); ++i)
    for (const Formula& one : near.W[i]) P[i].push_back(-one);
  for (std::size_t i = 0; i < near.J.size(); ++i) {
    P.emplace_back();
    for (std::size_t k = 0; k < free; ++k) P.back().push_back(l * near.J[i][k] + near.B[i][k]);
    P.back().resize(free + near.J.size());
  }
  return coefficients_by(numerator(determinant(P)), name, 2 * P.size());
}

}  // namespace poinsot::problem
