#include "problem/claims/claim_stability.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "poinsot/engine/math/formula/formula_sign.h"
#include "poinsot/engine/solve/stability/near_equations.h"

namespace poinsot::problem {
namespace {

using Matrix = solve::Rows<Formula>;

constexpr std::size_t most_freedoms = 5;  // a determinant of formulas has up to the factorial of these terms
constexpr std::size_t highest_power = 6;  // of the rate of growth in the characteristic polynomial

Matrix zeros(std::size_t n) { return Matrix(n, std::vector<Formula>(n)); }

Matrix product(const Matrix& A, const Matrix& B) {
  Matrix C = zeros(A.size());
  for (std::size_t i = 0; i < A.size(); ++i)
    for (std::size_t k = 0; k < A.size(); ++k) {
      if (A[i][k].is_zero()) continue;
      for (std::size_t j = 0; j < A.size(); ++j)
        if (!B[k][j].is_zero()) C[i][j] += A[i][k] * B[k][j];
    }
  return C;
}
Matrix sum(const Matrix& A, const Matrix& B, int sign = 1) {
  Matrix C = A;
  for (std::size_t i = 0; i < A.size(); ++i)
    for (std::size_t j = 0; j < A.size(); ++j) C[i][j] += Formula(sign) * B[i][j];
  return C;
}
bool vanishes(const Matrix& A) {
  return std::all_of(A.begin(), A.end(), [](const auto& row) {
    return std::all_of(row.begin(), row.end(), [](const Formula& x) { return x.is_zero(); });
  });
}

// Expands the determinant by the first row.
Formula determinant(const Matrix& A) {
  if (A.empty()) return Formula(1);
  if (A.size() == 1) return A[0][0];
  Formula total;
  for (std::size_t k = 0; k < A.size(); ++k) {
    if (A[0][k].is_zero()) continue;
    Matrix minor;
    for (std::size_t i = 1; i < A.size(); ++i) {
      minor.emplace_back();
      for (std::size_t j = 0; j < A.size(); ++j)
        if (j != k) minor.back().push_back(A[i][j]);
    }
    const Formula part = A[0][k] * determinant(minor);
    total += k % 2 == 0 ? part : -part;
  }
  return total;
}

// Whether the formula is seen to be positive.
bool is_positive(const Formula& x) {
  const SeenSign seen = seen_sign(x);
  return seen.sign > 0 && seen.strict;
}

// Whether a check holds for every leading principal minor.
template <class Check>
bool leading_minors(const Matrix& A, const Check& check) {
  for (std::size_t n = 1; n <= A.size(); ++n) {
    Matrix minor;
    for (std::size_t i = 0; i < n; ++i) minor.emplace_back(A[i].begin(), A[i].begin() + static_cast<std::ptrdiff_t>(n));
    if (!check(determinant(minor))) return false;
  }
  return true;
}

// The linearised equations M x'' + C x' + K x = 0 of the deviations of the free coordinates.
struct Linearised {
  Matrix M, C, K;
  bool follows_spin = false;    // whether axes turn relative to those of the coordinates
  std::vector<Formula> unrest;  // vanishes if the motion is steady
};

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

std::vector<std::size_t> free_coordinates(const SteadyFormulas& motion) {
  std::vector<std::size_t> free;
  for (std::size_t k = 0; k < motion.v.size(); ++k)
    if (std::find(motion.held.begin(), motion.held.end(), static_cast<int>(k)) == motion.held.end()) free.push_back(k);
  return free;
}

Linearised linearised(const SteadyFormulas& motion, const std::vector<std::size_t>& free) {
  const Mechanism<Formula>& mechanism = motion.machine.mechanism;
  const Matrix S = solve::adjoint_rows(mechanism.tree, unseen_spins(motion));
  const Matrix D = solve::adjoint_rows(mechanism.tree, solve::own_twists(mechanism.tree, motion.v));
  // The accelerations of the steady motion: v is constant on axes that follow the frame and not the spin.
  const std::size_t n = motion.v.size();
  std::vector<Formula> a(n);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t k = 0; k < n; ++k) a[i] -= S[i][k] * motion.v[k];
  for (const auto& rate : motion.machine.accelerations) a[static_cast<std::size_t>(rate.velocity)] = rate.value;

  // How M a + h - Q varies, which is zero along the motion.
  Linearised result;
  const State<Formula> state{motion.q, motion.v};
  const std::vector<Formula> left = solve::remainder_of(mechanism, state, a, {}).forces;
  for (const std::size_t i : free) result.unrest.push_back(left[i]);
  const solve::RemainderSlopes<Formula> slopes(mechanism, state, a, {});
  Matrix by_position = zeros(n), by_velocity = zeros(n);
  for (const std::size_t k : free) {
    const std::vector<Formula> moved = slopes.by_position(k).forces, hastened = slopes.by_velocity(k).forces;
    for (const std::size_t i : free) {
      by_position[i][k] = moved[i];
      by_velocity[i][k] = hastened[i];
    }
  }
  const auto of_free = [&](const Matrix& A) {
    Matrix part;
    for (const std::size_t i : free) {
      part.emplace_back();
      for (const std::size_t k : free) part.back().push_back(A[i][k]);
    }
    return part;
  };
  // With y = (l - S + D) x the deviations of the velocities, M (l - S) y + r_v y + r_q x = 0.
  const Matrix spin = of_free(S), drift = of_free(sum(D, S, -1));
  const Matrix M = of_free(solve::mass_rows(mechanism.tree, motion.q)), Rv = of_free(by_velocity);
  result.M = M;
  result.C = sum(product(M, sum(drift, spin, -1)), Rv);
  result.K = sum(sum(product(Rv, drift), product(product(M, spin), drift), -1), of_free(by_position));
  result.follows_spin = !vanishes(spin) || !vanishes(drift);
  return result;
}

// The coefficients of det(M l^2 + C l + K) in ascending powers of l.
std::vector<Formula> characteristic_polynomial(const Linearised& near) {
  const std::string name = "rate of growth";
  const Formula l = Formula::letter(name, poinsot::Sign::real);
  Matrix P = near.K;
  for (std::size_t i = 0; i < P.size(); ++i)
    for (std::size_t k = 0; k < P.size(); ++k) P[i][k] += l * near.C[i][k] + l * l * near.M[i][k];
  Formula rest = numerator(determinant(P));
  std::vector<Formula> coefficients;
  Formula factorial(1);
  for (std::size_t k = 0; !rest.is_zero() && k <= 2 * P.size(); ++k) {
    if (k > 0) factorial *= Formula(static_cast<std::int64_t>(k));
    coefficients.push_back(poinsot::substituted(rest, {{name, Formula(0)}}) / factorial);
    rest = derivative(rest, name);
  }
  return coefficients;
}

// The criteria of stability. Each asks that some formulas are positive, and calls a check for each of them.
enum class Criterion { negative_squares, hurwitz, energy };

// Whether all roots are negative and different: the coefficients have one sign, and the discriminant shows that all
// roots are real.
template <class Check>
bool negative_roots(const std::vector<Formula>& c, const Check& check) {
  if (!std::all_of(c.begin(), c.end(), check)) return false;
  switch (c.size()) {
    case 1:
    case 2:
      return true;
    case 3:
      return check(c[1] * c[1] - Formula(4) * c[0] * c[2]);
    case 4: {
      const Formula &d = c[0], &e = c[1], &b = c[2], &a = c[3];
      return check(Formula(18) * a * b * e * d - Formula(4) * b * b * b * d + b * b * e * e -
                   Formula(4) * a * e * e * e - Formula(27) * a * a * d * d);
    }
    default:
      return false;
  }
}

// Hurwitz's criterion: whether all roots have negative real parts.
template <class Check>
bool roots_on_the_left(const std::vector<Formula>& c, const Check& check) {
  if (!std::all_of(c.begin(), c.end(), check) || c.size() > highest_power + 1) return false;
  const std::size_t n = c.size() - 1;
  Matrix H = zeros(n);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t k = 0; k < n; ++k) {
      const auto power =
          static_cast<std::ptrdiff_t>(n) - 2 * static_cast<std::ptrdiff_t>(k + 1) + static_cast<std::ptrdiff_t>(i + 1);
      if (power >= 0 && power <= static_cast<std::ptrdiff_t>(n)) H[i][k] = c[static_cast<std::size_t>(power)];
    }
  return leading_minors(H, check);
}

// The characteristic polynomial in ascending powers, divided by l as often as l = 0 is a root identically;
// `vanishing` counts these roots.
struct Polynomial {
  std::vector<Formula> c;
  std::size_t vanishing = 0;

  std::vector<Formula> even() const {
    std::vector<Formula> powers;
    for (std::size_t k = 0; k < c.size(); k += 2) powers.push_back(c[k]);
    return powers;
  }
  bool is_even() const {
    for (std::size_t k = 1; k < c.size(); k += 2)
      if (!c[k].is_zero()) return false;
    return true;
  }
};

Polynomial polynomial_of(const Linearised& near) {
  Polynomial polynomial{characteristic_polynomial(near), 0};
  std::vector<Formula>& c = polynomial.c;
  while (polynomial.vanishing < c.size() && c[polynomial.vanishing].is_zero()) ++polynomial.vanishing;
  c.erase(c.begin(), c.begin() + static_cast<std::ptrdiff_t>(polynomial.vanishing));
  if (!c.empty() && plain(c.back()) < 0)
    for (Formula& coefficient : c) coefficient = -coefficient;
  return polynomial;
}

template <class Check>
bool holds(Criterion criterion, const Linearised& near, const Polynomial& polynomial, const Check& check) {
  switch (criterion) {
    case Criterion::negative_squares:
      return polynomial.is_even() && negative_roots(polynomial.even(), check);
    case Criterion::hurwitz:
      return !polynomial.is_even() && roots_on_the_left(polynomial.c, check);
    case Criterion::energy:
      break;
  }
  // If K is symmetric and definite and C is skew, the energy x'.M x' + x.K x is conserved and bounds x and x'
  // (Thomson and Tait).
  if (!polynomial.is_even() || near.follows_spin || polynomial.vanishing > 0) return false;
  Matrix symmetric = near.C, skew = near.K;
  for (std::size_t i = 0; i < near.K.size(); ++i)
    for (std::size_t k = 0; k < near.K.size(); ++k) {
      symmetric[i][k] = near.C[i][k] + near.C[k][i];
      skew[i][k] = near.K[i][k] - near.K[k][i];
    }
  return vanishes(symmetric) && vanishes(skew) && leading_minors(near.K, check);
}

std::optional<Criterion> stable_by(const Linearised& near, std::size_t symmetries) {
  const Polynomial polynomial = polynomial_of(near);
  // The roots that vanish identically must be those of the symmetries and no others.
  if (polynomial.vanishing != symmetries || polynomial.c.empty()) return std::nullopt;
  for (const Criterion criterion : {Criterion::negative_squares, Criterion::hurwitz, Criterion::energy})
    if (holds(criterion, near, polynomial, is_positive)) return criterion;
  return std::nullopt;
}

const char* words_of(Criterion criterion) {
  switch (criterion) {
    case Criterion::negative_squares:
      return "all squares of the rates are negative and differ if the coefficients and the discriminant are positive";
    case Criterion::hurwitz:
      return "all real parts are negative if the coefficients and Hurwitz's determinants are positive";
    case Criterion::energy:
      break;
  }
  return "the energy of a disturbance, which stays what it is, bounds it if the leading minors of its matrix are "
         "positive";
}

StabilityShown shown_of(const Linearised& near, std::optional<Criterion> criterion) {
  Polynomial polynomial = polynomial_of(near);
  if (polynomial.c.empty()) return {};
  const Formula first = polynomial.c.back();
  for (Formula& coefficient : polynomial.c) coefficient /= first;
  const Criterion looked = criterion.value_or(polynomial.is_even() ? Criterion::negative_squares : Criterion::hurwitz);
  StabilityShown shown{polynomial.c, polynomial.vanishing, words_of(looked), {}};
  holds(looked, near, polynomial, [&](const Formula& x) {
    if (!x.is_number() && std::find(shown.positive.begin(), shown.positive.end(), x) == shown.positive.end())
      shown.positive.push_back(x);
    return true;
  });
  return shown;
}

}  // namespace

bool proves_stability(const SteadyFormulas& motion, const WorkedAssumptions& assumptions,
                      std::optional<StabilityShown>* shown) {
  const Mechanism<Formula>& mechanism = motion.machine.mechanism;
  if (!mechanism.constraints.empty() || !assumptions.complete()) return false;
  const std::vector<std::size_t> free = free_coordinates(motion);
  if (free.size() > most_freedoms) return false;
  const Linearised near = linearised(motion, free);
  if (!std::all_of(near.unrest.begin(), near.unrest.end(), [&](const Formula& unrest) {
        return assumptions.proves({unrest, Formula(0), Relation::equal});
      }))
    return false;
  std::optional<Criterion> criterion;
  const bool proved = std::all_of(assumptions.cases().begin(), assumptions.cases().end(), [&](const WorkedCase& one) {
    // If an assumption allows equality, what should be positive may vanish.
    if (!one.unsolved().empty() || one.is_weak()) return false;
    Linearised applied = near;
    for (Matrix* matrix : {&applied.M, &applied.C, &applied.K})
      for (auto& row : *matrix)
        for (Formula& entry : row) entry = one.apply(entry);
    criterion = stable_by(applied, motion.symmetries);
    return criterion.has_value();
  });
  if (shown) *shown = shown_of(near, proved ? criterion : std::nullopt);
  return proved;
}

}  // namespace poinsot::problem
