#include "problem/witness/attraction_bound.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "poinsot/engine/mass/principal_axes.h"
#include "problem/language/words.h"

namespace poinsot::problem {
namespace {

// The sum of (n + 1) e^(n-2) over n from 3.
double tail(double e) {
  constexpr double series = 1e-2;  // below it the difference has lost four of its digits
  if (e < series) return e * (4 + e * (5 + e * (6 + e * (7 + e * 8))));
  return (1 / ((1 - e) * (1 - e)) - 1 - 2 * e - 3 * e * e) / (e * e);
}

bool is_exact(const Body& body) {
  const auto round = [](const Part& part) {
    return part.shape.kind == "particle" || part.shape.kind == "sphere" || part.shape.kind == "sphere_shell";
  };
  return !body.inertia && std::ranges::all_of(body.parts, round) && std::ranges::all_of(body.added, round);
}

// What is left out, as a part of the pull and of the largest couple that the moments of inertia allow.
struct LeftOut {
  double of_force = 0;
  std::optional<double> of_couple{};  // nothing where all moments are equal
};
LeftOut left_out(const Machine& machine, const Workspace<double>& workspace, int body) {
  const Model<double>& tree = machine.mechanism.tree;
  double force = 0, couple = 0, pull = 0, farthest = 0;
  for (const AttractionLaw<double>& law : machine.mechanism.attractions) {
    if (law.at.body != body) continue;
    for (const AttractedPart<double>& part : law.parts) {
      const double r = norm(law.way_to(tree, workspace, part));
      pull += part.mass / (r * r);
      farthest = std::max(farthest, r);
      if (!part.by_moments) continue;
      const double J = std::abs(part.inertia.xx + part.inertia.yy + part.inertia.zz) / 2, rest = tail(part.reach / r);
      force += J * rest / (r * r * r * r);
      couple += J * rest / (r * r * r);
    }
  }
  const SpatialInertia<double>& I = tree.body(body).inertia;
  const Vector3<double> moments =
      principal_axes(I.inertia - I.mass * unit_mass_inertia(I.first_moment / I.mass)).moments;
  const double spread = std::max({moments.x, moments.y, moments.z}) - std::min({moments.x, moments.y, moments.z});
  constexpr double same = 1e-9;  // data may be stated to nine digits
  LeftOut found{force / std::abs(pull)};
  if (spread > same * (moments.x + moments.y + moments.z))
    found.of_couple = couple / (1.5 * spread / (farthest * farthest * farthest));
  return found;
}

std::vector<std::string> told(const Situation& situation, const Machine* machine, const Workspace<double>* workspace) {
  std::vector<std::string> lines, exact;
  if (!situation.central_gravity) return lines;
  const std::string where = situation.name.empty() ? "" : " @ " + situation.name;
  for (const Body& body : situation.bodies) {
    if (body.massless) continue;
    if (is_exact(body)) {
      exact.push_back("'" + body.name + "'");
      continue;
    }
    std::string line = "gravity pulls '" + body.name + "'" + where +
                       " by its moments of inertia, to the second order of its size over its distance";
    if (machine) {
      const bool by_numbers = body.parts.empty();
      const LeftOut rest = left_out(*machine, *workspace, machine->index.at(body.name));
      line += std::string(by_numbers ? "; of its shape nothing is known: what is left out is of the order of "
                                     : "; what is left out is at most ") +
              with_digits(rest.of_force, 1) + " of the pull";
      if (rest.of_couple) line += " and " + with_digits(*rest.of_couple, 1) + " of the largest couple";
    }
    lines.push_back(line);
  }
  if (!exact.empty())
    lines.insert(lines.begin(), "gravity pulls " + listed(exact) + where + " exactly, as particles and spheres are");
  return lines;
}

}  // namespace

std::vector<std::string> words_of_attraction(const Situation& situation, const Machine& machine,
                                             const std::vector<double>& q) {
  if (!situation.central_gravity) return {};
  Workspace<double> workspace(machine.mechanism.tree);
  update_poses<double>(machine.mechanism.tree, workspace, q);
  return told(situation, &machine, &workspace);
}

std::vector<std::string> words_of_attraction(const Situation& situation) { return told(situation, nullptr, nullptr); }

}  // namespace poinsot::problem
