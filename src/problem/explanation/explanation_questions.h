// For each instant, what the questions and facts of a statement are about: the momenta of which bodies, which forces.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <vector>

#include "problem/results/solution.h"
#include "problem/unknowns/sample.h"

namespace poinsot::problem {

struct MomentumQuestion {
  int body = whole_system;
  std::optional<Expression> about;  // the point of an angular momentum or energy; the mass center if it is not stated
  bool angular = false, linear = false, energy = false;
  bool rate = false;  // whether its rate is asked for
};

// How a point of a body moves, or where it or the mass center is.
struct PointQuestion {
  enum class Kind { place, velocity, acceleration } kind = Kind::velocity;
  int body = whole_system;
  Call call;  // velocity(A of plate), center(plate)
};

// What is asked for, or stated as a condition, at one instant.
struct InstantQuestions {
  std::vector<MomentumQuestion> momenta;
  std::set<int> moving, accelerated;  // bodies whose velocities or accelerations are asked for
  std::set<int> going;                // those of them of which not only the turning is asked for
  std::set<int> masses;               // bodies whose mass, center or inertia is asked for
  std::set<std::size_t> forces;       // actions whose forces, couples or impulses are asked for
  std::set<std::size_t> pushes;       // contacts and cords of which only whether they push or pull is asked
  bool accelerations = false;         // of any body
  bool stability = false;             // whether what is near this motion is asked for: frequencies, rates of growth
  std::vector<Call> responses;        // response(X to F)
  std::vector<Call> free_motions;     // precession_rate(satellite) and its like
  std::vector<PointQuestion>
      points;  // velocity(A of plate), acceleration(A of plate), later center(plate) and its like

  bool asks_forces() const { return !forces.empty() || !pushes.empty() || accelerations; }
};

struct StatementQuestions {
  std::map<Sample::Home, InstantQuestions> instants;
  std::set<std::size_t> motions;  // situations whose motion in time is asked for
  // By situation, what is asked for of all its motion: over time, at later instants, as an extreme.
  std::map<std::size_t, InstantQuestions> along;
};

// Whether an expression has a momentum or a kinetic energy in it.
bool speaks_of_momentum(const Expression& expression);

// solution: which asks are answered. limits: situations to be explained at a limit, with the ask whose conditions count
// there. Throws StatementError as the evaluation of the asks does.
StatementQuestions questions_of(const Statement& statement, Sample& sample, const Solution& solution,
                                const std::map<std::size_t, std::size_t>& limits);

}  // namespace poinsot::problem
