// Friction in joints that follows from what they carry, while they move: the couple or force M of each along its slip
// with the reactions on which it depends, M + m (|V1| + |V2| + ...) = 0 (quantities/joint_pressing.h).
//
// The reactions are linear in the frictions, so that h(x) = x - m |V(x)|, with x = -M of a single joint, is concave
// and starts at or below zero. Newton's method from x = 0 rises to the smallest root, or finds a slope that has none.
// With a = m |dV/dx| there is just one root for a < 1; for a > 1 there is none or there are two (as of Painleve's rod,
// and of guides that jam). Several joints have one solution where the matrix of the a has no eigenvalue of one or more.
#include <algorithm>
#include <cmath>

#include "problem/instant/instant.h"
#include "problem/language/diagnostic.h"

namespace poinsot::problem {

// By powers (Collatz and Wielandt).
double bound_on_eigenvalues(const std::vector<std::vector<double>>& a) {
  std::vector<double> x(a.size(), 1);
  double bound = INFINITY;
  constexpr int powers = 30;
  for (int k = 0; k < powers; ++k) {
    std::vector<double> next(a.size());
    double ratio = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
      // The small part keeps every element above zero where joints do not act on one another.
      constexpr double part = 1e-9;
      next[i] = part * x[i];
      for (std::size_t j = 0; j < a.size(); ++j) next[i] += a[i][j] * x[j];
      ratio = std::max(ratio, next[i] / x[i]);
    }
    bound = std::min(bound, ratio);
    const double size = *std::ranges::max_element(next);
    for (std::size_t i = 0; i < a.size(); ++i) x[i] = std::max(next[i] / size, 1e-12);
  }
  return bound;
}

void SolvedInstant::find_pressing() {
  std::vector<RoughContactOf<double>*> moving;
  for (RoughContactOf<double>& contact : machine_.rough_contacts)
    if (contact.found_with_reactions()) moving.push_back(&contact);
  if (moving.empty()) return;
  constexpr int most_steps = 60;  // far more than Newton's method needs where there is a root
  // Between two directions, weighed by the largest force: what the friction is wrong by is of its square.
  constexpr double exactly = 1e-10;
  bool found = false;
  for (int step = 0; step < most_steps && !found; ++step) {
    if (step > 0) assemble_motion_equations();
    const std::vector<double> unknowns = motion_equations_.solve().value;
    const double force = largest_force(*mechanism_state_, unknowns);
    found = true;
    for (RoughContactOf<double>* contact : moving) {
      const std::vector<Vector3<double>> pressing = pressing_in(*mechanism_state_, unknowns, *contact);
      for (std::size_t i = 0; i < pressing.size(); ++i) {
        const double size = norm(pressing[i]);
        if (!(size > 0)) continue;
        auto& toward = contact->pressing[i].toward;
        const Vector3<double> u = pressing[i] / size;
        if (toward && norm(u - *toward) * size <= exactly * contact->pressing[i].lever * force) continue;
        toward = u;
        found = false;
      }
    }
  }
  if (found && !choice_.trial && !moving_) refuse_several_frictions(moving);
}

// Friction that follows from a load that the equations leave open is open, too, though not in them: at each direction
// of what presses they have a friction.
void SolvedInstant::require_known_pressing(const solve::LinearSolution& solution) const {
  constexpr double rounding = 1e-9;  // of an open direction
  for (const RoughContactOf<double>& contact : machine_.rough_contacts) {
    if (contact.pressing.empty()) continue;
    for (const std::vector<double>& direction : solution.open) {
      double size = 0;
      for (const double part : direction) size = std::max(size, std::abs(part));
      std::vector<Vector3<double>> moved = pressing_in(*mechanism_state_, direction, contact);
      double lever = scales_.length * rounding;
      for (const PressingPart<double>& part : contact.pressing) lever = std::max(lever, part.lever);
      // Joints at rest that hold one another share their frictions, each up to its own limit.
      if (contact.grip == Grip::sticks) moved.push_back(rough_force(*mechanism_state_, direction, contact).friction);
      if (std::ranges::none_of(moved, [&](const Vector3<double>& V) { return norm(V) > rounding * size * lever; }))
        continue;
      const Contact& stated = *std::ranges::find(situation_.contacts, contact.name, &Contact::name);
      fail(situation_.file, stated.friction->mark,
           "what " + stated.words() +
               " carries, or the part that its friction has in holding, is open: several joints or supports share it",
           "let each carry only what the others do not, or state the problem in a plane, plane: [x, y]");
    }
  }
}

// By how much what presses in each joint changes with the friction of each.
void SolvedInstant::refuse_several_frictions(const std::vector<RoughContactOf<double>*>& moving) {
  const auto friction_of = [&](const RoughContactOf<double>& contact, const std::vector<double>& unknowns) {
    return dot(rough_force(*mechanism_state_, unknowns, contact).friction, mechanism_state_->direction(*contact.slip));
  };
  const std::vector<double> found = motion_equations_.solve().value;
  std::vector<std::vector<Vector3<double>>> here;
  for (RoughContactOf<double>* contact : moving) {
    here.push_back(pressing_in(*mechanism_state_, found, *contact));
    contact->friction_known = friction_of(*contact, found);
  }
  std::vector<std::vector<double>> a(moving.size(), std::vector<double>(moving.size()));
  for (std::size_t j = 0; j < moving.size(); ++j) {
    const double before = *moving[j]->friction_known;
    const double more = natural_size(moving[j]->turning ? dimensions::moment : dimensions::force);
    if (!(more > 0)) continue;
    moving[j]->friction_known = before + more;
    assemble_motion_equations();
    const std::vector<double> there = motion_equations_.solve().value;
    moving[j]->friction_known = before;
    for (std::size_t i = 0; i < moving.size(); ++i) {
      const std::vector<Vector3<double>> V = pressing_in(*mechanism_state_, there, *moving[i]);
      for (std::size_t k = 0; k < V.size(); ++k) a[i][j] += moving[i]->sliding * norm(V[k] - here[i][k]) / more;
    }
  }
  for (RoughContactOf<double>* contact : moving) contact->friction_known.reset();
  assemble_motion_equations();
  constexpr double less_than_one = 1 - 1e-9;  // beyond the rounding of what presses
  if (bound_on_eigenvalues(a) < less_than_one) return;
  const Contact& stated = *std::ranges::find(situation_.contacts, moving.front()->name, &Contact::name);
  fail(situation_.file, stated.friction->mark,
       "so much friction in " + stated.words() + (moving.size() > 1 ? " and others" : "") +
           " that what it carries grows faster with its friction than its friction with that: as it moves there may be "
           "two frictions, and which acts is not known",
       "reduce the friction, or let the joint bear at a greater length or smaller radius");
}

}  // namespace poinsot::problem
