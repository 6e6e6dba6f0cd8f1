// The second road to a blow with dry friction. How the bodies answer to impulses at the contact is told by their
// particles, each body by itself with six velocities, held together by what joints, contacts and cords can carry:
//   M dV = F + C l,   C^T dV = 0.
// The blow is then followed by small steps of the push, in each of which the friction is the one in the disk of radius
// mu dp that opposes the slip at the end of the step most (Moreau's time-stepping), with no regard to stretches,
// directions or stops.
#include <algorithm>
#include <cmath>

#include "engine/solve/linear/decompositions.h"
#include "problem/instant/instant.h"

namespace poinsot::problem {
namespace {

using Dense = Eigen::MatrixXd;

// A row of the wrench (force, moment about the origin) or of velocities (of the origin, angular).
void add_six(Dense& matrix, Eigen::Index row, Eigen::Index column, double factor, const Vector3<double>& first,
             const Vector3<double>& second) {
  for (int k = 0; k < 3; ++k) {
    const auto part = static_cast<std::size_t>(k);
    matrix(row + k, column) += factor * first[part];
    matrix(row + 3 + k, column) += factor * second[part];
  }
}

// Takes out of W and of the velocity u before a blow the direction across the push in which no impulse moves anything:
// there no slip arises, and what is left of W is rounding.
void take_out_immovable(Matrix3<double>& W, Vector3<double>& u) {
  constexpr double rounding = 1e-10;  // of the mobility along the push
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> principal(
      (Eigen::Matrix2d() << W(1, 1), W(1, 2), W(2, 1), W(2, 2)).finished());
  for (int k = 0; k < 2; ++k) {
    if (principal.eigenvalues()[k] > rounding * W(0, 0)) continue;
    const Vector3<double> d{0, principal.eigenvectors()(0, k), principal.eigenvectors()(1, k)};
    Matrix3<double> without;
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) without(i, j) = (i == j ? 1 : 0) - d[i] * d[j];
    W = without * W * without;
    u = without * u;
  }
}

// The impulse after a blow by steps, of which `count` make the compression of a point that nothing couples.
struct Steps {
  const Matrix3<double>& W;
  const Vector3<double> before;
  const solve::RoughImpactLaw law;

  Vector3<double> follow(int count) const {
    const double dp = -before.x / W(0, 0) / count, limit = law.friction * dp,
                 step = 1 / std::max(W(1, 1) + W(2, 2), 1e-9 * W(0, 0));
    Vector3<double> u = before, P{}, friction{};
    double compressed = 0, work_in = 0, work_out = 0;
    constexpr int most = 200;  // times as long as without friction
    for (int i = 0; i < most * count; ++i) {
      Vector3<double> next = u;
      for (int round = 0; round < 400; ++round) {
        next = u + W * Vector3<double>{dp, friction.y, friction.z};
        Vector3<double> better{0, friction.y - step * next.y, friction.z - step * next.z};
        if (const double size = norm(better); size > limit) better = (limit / size) * better;
        const double change = norm(better - friction);
        friction = better;
        if (change <= 1e-7 * limit) break;
      }
      next = u + W * Vector3<double>{dp, friction.y, friction.z};
      const double work = 0.5 * (u.x + next.x) * dp;
      double part = 1;
      if (compressed == 0 && next.x < 0) {
        work_in += work;
      } else if (compressed == 0) {
        const double reached = next.x > u.x ? -u.x / (next.x - u.x) : 1;
        compressed = P.x + reached * dp;
        work_in += 0.5 * reached * u.x * dp;
        work_out += 0.5 * (1 - reached) * next.x * dp;
        if (law.restitution == 0) return P + reached * Vector3<double>{dp, friction.y, friction.z};
      } else {
        work_out += work;
      }
      if (compressed > 0) {
        const double wanted = law.restitution * law.restitution * -work_in;
        double beyond = 0, gained = 1;  // of what ends the blow, and by this step
        switch (law.hypothesis) {
          case solve::RestitutionLaw::energetic:
            beyond = work_out - wanted;
            gained = work;
            break;
          case solve::RestitutionLaw::poisson:
            beyond = P.x + dp - (1 + law.restitution) * compressed;
            gained = dp;
            break;
          case solve::RestitutionLaw::newton:
            beyond = next.x + law.restitution * before.x;
            gained = next.x - u.x;
            break;
        }
        if (beyond >= 0) {
          if (gained > 0) part = std::clamp(1 - beyond / gained, 0.0, 1.0);
          return P + part * Vector3<double>{dp, friction.y, friction.z};
        }
      }
      P += Vector3<double>{dp, friction.y, friction.z};
      u = next;
    }
    return P;
  }
};

}  // namespace

double SolvedInstant::rough_blow_misfit() const {
  const RoughBlow& rough = *rough_blow_;
  const solve::Impact& impact = blow_.impacts[rough.impact];
  const Mechanism<double>& mechanism = machine_.mechanism;
  const double length = scales_.length, mass_unit = scales_.mass;
  std::vector<Eigen::Index> first(static_cast<std::size_t>(mechanism.tree.body_count()), -1);
  Eigen::Index rows = 0;
  for (const auto& [index, mass] : machine_.masses) {
    first[static_cast<std::size_t>(index)] = rows;
    rows += 6;
  }
  std::vector<std::pair<int, SpatialForce<double>>> holds;
  for (const Component<double>& component : mechanism.components)
    if (blow_acting_[static_cast<std::size_t>(component.action)])
      holds.emplace_back(component.action, before_->component_wrench(component));
  for (const std::size_t drive : solve::impulse_unknowns(mechanism, blow_).drive_of_effort)
    holds.emplace_back(mechanism.drives[drive].action, before_->drive_wrench(mechanism.drives[drive]));
  const Eigen::Index size = rows + static_cast<Eigen::Index>(holds.size());
  Dense system = Dense::Zero(size, size), columns = Dense::Zero(size, 3);
  for (const auto& [index, mass] : machine_.masses) {
    const Eigen::Index row = first[static_cast<std::size_t>(index)];
    for (const Particle<double>& particle : mass.particles) {
      const Vector3<double> r = (1 / length) * before_->position(machine_.place(index, particle.position));
      const double m = particle.mass / mass_unit;
      for (std::size_t k = 0; k < 3; ++k) {
        const Vector3<double> by_origin = m * Vector3<double>::unit(k),
                              by_turning = m * cross(Vector3<double>::unit(k), r);
        const auto column = row + static_cast<Eigen::Index>(k);
        add_six(system, row, column, 1, by_origin, cross(r, by_origin));
        add_six(system, row, column + 3, 1, by_turning, cross(r, by_turning));
      }
    }
  }
  const auto add_wrench = [&](Dense& matrix, Eigen::Index column, double sign, int on, int from,
                              const SpatialForce<double>& wrench) {
    for (const auto& [body, side] : {std::pair{on, sign}, std::pair{from, -sign}})
      if (body != ground && first[static_cast<std::size_t>(body)] >= 0)
        add_six(matrix, first[static_cast<std::size_t>(body)], column, side, wrench.force,
                (1 / length) * wrench.moment);
  };
  for (std::size_t i = 0; i < holds.size(); ++i) {
    const Action& action = mechanism.actions[static_cast<std::size_t>(holds[i].first)];
    add_wrench(system, rows + static_cast<Eigen::Index>(i), -1, action.on, action.from, holds[i].second);
  }
  system.bottomLeftCorner(size - rows, rows) = system.topRightCorner(rows, size - rows).transpose();
  const Vector3<double> P = before_->position(impact.at);
  for (std::size_t k = 0; k < 3; ++k)
    add_wrench(columns, static_cast<Eigen::Index>(k), 1, impact.on, impact.from,
               {cross(P, rough.axes[k]), rough.axes[k]});
  const Eigen::CompleteOrthogonalDecomposition<Dense> decomposed(system);
  Matrix3<double> W;
  for (std::size_t k = 0; k < 3; ++k) {
    const Eigen::VectorXd side = columns.col(static_cast<Eigen::Index>(k));
    const Eigen::VectorXd moved = decomposed.solve(side);
    for (std::size_t j = 0; j < 3; ++j)
      W(j, k) = columns.col(static_cast<Eigen::Index>(j)).head(rows).dot(moved.head(rows)) / mass_unit;
  }
  const Vector3<double> u = solve::impact_velocity(*before_, impact);
  solve::RoughImpactLaw law{impact.restitution, *impact.friction, impact.hypothesis};
  // Where contacts meet later, as stated.
  if (const auto stated = std::ranges::find(situation_.contacts, impact.name, &Contact::name);
      moving_ && stated != situation_.contacts.end() && stated->friction) {
    law.friction = data_->number(stated->friction->sliding, dimensions::none);
    law.restitution = stated->restitution ? data_->number(*stated->restitution, dimensions::none) : 0;
  }
  Vector3<double> before{dot(u, rough.axes[0]), dot(u, rough.axes[1]), dot(u, rough.axes[2])};
  take_out_immovable(W, before);
  const Steps steps{W, before, law};
  // The error of a step is of first order: so is extrapolated from twice as many.
  constexpr int count = 5'000;
  const Vector3<double> expected = 2.0 * steps.follow(2 * count) - steps.follow(count);
  const Vector3<double> told =
      solve::action_impulse(*before_, blow_, impulses_, static_cast<std::size_t>(impact.action)).force;
  const Vector3<double> by_axes{dot(told, rough.axes[0]), dot(told, rough.axes[1]), dot(told, rough.axes[2])};
  double misfit = norm(by_axes - expected) / norm(told);
  misfit = std::max(misfit, (std::hypot(by_axes.y, by_axes.z) - law.friction * by_axes.x) / norm(told));
  if (law.hypothesis == solve::RestitutionLaw::energetic && rough.gained > 0) misfit = 1;
  return misfit;
}

}  // namespace poinsot::problem
