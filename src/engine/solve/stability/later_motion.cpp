#include "engine/solve/stability/later_motion.h"

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "poinsot/engine/dynamics/kinematics.h"
#include "poinsot/engine/model/state.h"
#include "poinsot/engine/solve/stability/near_equations.h"

namespace poinsot::solve {
namespace {

using Index = Eigen::Index;

}  // namespace

LaterMotion later_motion(const SteadyMotion& motion, double delay) {
  const Model<double>& tree = motion.mechanism->tree;
  const auto n = static_cast<Index>(motion.v.size());
  LaterMotion later{motion, Matrix::Identity(n, n)};
  std::vector<double> carried = motion.v, spun(motion.v.size(), 0.0);
  for (const auto& [body, twist] : motion.spins) {
    const Vector3<double> parts[] = {twist.angular, twist.linear};
    for (int k = 0; k < velocity_size(tree.body(body).joint); ++k)
      spun[static_cast<std::size_t>(tree.body(body).v + k)] = parts[k / 3][static_cast<std::size_t>(k % 3)];
  }
  for (std::size_t k = 0; k < carried.size(); ++k) carried[k] -= spun[k];
  integrate_position<double>(tree, later.motion.q, carried, delay);
  integrate_position<double>(tree, later.motion.q, spun, delay);

  const Rows<double> S = adjoint_rows(tree, motion.spins);
  Matrix rates = Matrix::NullaryExpr(
      n, n, [&](Index i, Index k) { return Real(S[static_cast<std::size_t>(i)][static_cast<std::size_t>(k)]); });
  // The series of a small part of a turn, squared until it is the whole: what turns slowly beside what spins goes round
  // millions of times.
  const Real turns = 8 * rates.cwiseAbs().maxCoeff() * std::abs(Real(delay));
  const int squares = turns > 1 ? std::ilogb(turns) + 1 : 0;
  rates *= -std::ldexp(Real(delay), -squares);
  Matrix term = later.turned;
  for (int order = 1; order <= 20; ++order) {
    term = (term * rates / Real(order)).eval();
    later.turned += term;
  }
  for (int i = 0; i < squares; ++i) later.turned = (later.turned * later.turned).eval();
  for (Index i = 0; i < n; ++i) {
    Real turned = 0;
    for (Index k = 0; k < n; ++k) turned += later.turned(i, k) * Real(motion.v[static_cast<std::size_t>(k)]);
    later.motion.v[static_cast<std::size_t>(i)] = static_cast<double>(turned);
  }
  return later;
}

std::vector<double> uneven_spins(const SteadyMotion& motion) {
  const Mechanism<double>& mechanism = *motion.mechanism;
  // The pull of a center goes by mass, of which the inertias below tell.
  for_each_law(mechanism, []<class Law>(const Law&) {
    static_assert(std::is_same_v<Law, KnownForce<double>> || std::is_same_v<Law, SpringLaw<double>> ||
                      std::is_same_v<Law, TorsionLaw<double>> || std::is_same_v<Law, AttractionLaw<double>>,
                  "say below whether the law goes round with a body that spins, or stands where one goes by");
  });
  const Model<double>& tree = mechanism.tree;
  Workspace<double> w(tree);
  update_velocities<double>(tree, w, State<double>{motion.q, motion.v});
  double fastest = norm(motion.turning);
  for (int i = 0; i < tree.body_count(); ++i) fastest = std::max(fastest, norm(angular_velocity(w, i)));
  // Of its size: what velocities and places have as rounding of facts that hold to nine digits.
  constexpr double nothing = 1e-9;
  std::vector<double> found;
  for (int i = 0; i < tree.body_count(); ++i) {
    const Body<double>& body = tree.body(i);
    const Vector3<double> spin = angular_velocity(w, i) - motion.turning;
    if (!(norm(spin) > nothing * fastest)) continue;
    const auto fastened = [i](int one, int other) { return one == i || other == i; };
    bool uneven =
        std::ranges::any_of(mechanism.springs,
                            [&](const SpringLaw<double>& law) { return fastened(law.at.body, law.toward.body); }) ||
        std::ranges::any_of(mechanism.torsions,
                            [&](const TorsionLaw<double>& law) { return fastened(law.on, law.along.body); }) ||
        std::ranges::any_of(mechanism.forces, [&](const KnownForce<double>& law) { return law.at.body == i; });
    if (body.inertia.mass > 0) {
      const Vector3<double> s = transpose_times(w.motion[static_cast<std::size_t>(i + 1)].R, spin),
                            c = body.inertia.first_moment / body.inertia.mass;
      const SymmetricMatrix3<double> own = body.inertia.inertia - body.inertia.mass * unit_mass_inertia(c);
      for (std::size_t k = 0; k < 3; ++k) {
        const Vector3<double> e = Vector3<double>::unit(k);
        if (norm(cross(s, own * e) - own * cross(s, e)) > nothing * norm(s) * norm(own * e)) uneven = true;
      }
      if (body.joint == JointType::revolute && norm(cross(s, c)) > nothing * norm(s) * motion.length) uneven = true;
    }
    if (uneven) found.push_back(norm(spin));
  }
  // What stands on the ground goes round as seen from the frame.
  const double turning = norm(motion.turning);
  const auto on_ground = [](int one, int other) { return one == ground || other == ground; };
  if (turning > nothing * fastest &&
      (norm(cross(motion.turning, tree.gravity())) > nothing * turning * norm(tree.gravity()) ||
       !mechanism.forces.empty() ||
       std::ranges::any_of(mechanism.springs,
                           [&](const SpringLaw<double>& law) { return on_ground(law.at.body, law.toward.body); }) ||
       std::ranges::any_of(mechanism.torsions,
                           [&](const TorsionLaw<double>& law) { return on_ground(law.on, law.along.body); }) ||
       std::ranges::any_of(mechanism.constraints, [&](const VelocityConstraint<double>& constraint) {
         return on_ground(constraint.on, constraint.from);
       })))
    found.push_back(turning);
  // A body that moves straight on comes past the springs and cords that stand there.
  const auto passes = [&](int one, int other) {
    const int body = one == ground ? other : one;
    if (turning > nothing * fastest || body == ground || !on_ground(one, other)) return;
    const double speed = norm(w.motion[static_cast<std::size_t>(body + 1)].v);
    if (speed * motion.time > nothing * motion.length) found.push_back(speed / motion.length);
  };
  for (const SpringLaw<double>& law : mechanism.springs) passes(law.at.body, law.toward.body);
  for (const VelocityConstraint<double>& constraint : mechanism.constraints)
    if (is_cord_length(constraint)) passes(constraint.on, constraint.from);
  return found;
}

}  // namespace poinsot::solve
