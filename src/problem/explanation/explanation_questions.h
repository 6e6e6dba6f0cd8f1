// What the questions and facts of a statement are about, instant by instant: which bodies' momenta, which forces.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <vector>

#include "problem/unknowns/sample.h"

namespace poinsot::problem {

struct MomentumQuestion {
  int body = whole_system;
  std::optional<Expression> about;  // of an angular momentum or energy; the mass center where nothing is said
  bool angular = false, linear = false, energy = false;
  bool rate = false;  // how it changes is asked
};

// What is asked, or stated as a condition, at one instant.
struct InstantQuestions {
  std::vector<MomentumQuestion> momenta;
  std::set<int> moving, accelerated;  // bodies whose velocities or accelerations are asked
  std::set<int> masses;               // bodies whose mass, center or inertia is asked
  std::set<std::size_t> forces;       // actions whose forces, couples or impulses are asked
  std::set<std::size_t> pushes;       // contacts and cords of which only what can push or pull counts
  bool accelerations = false;         // of anything
  bool energies = false;
  bool positions = false;  // nothing but places and masses

  bool asks_forces() const { return !forces.empty() || !pushes.empty() || accelerations; }
};

struct StatementQuestions {
  std::map<Sample::Home, InstantQuestions> instants;
  std::set<std::size_t> motions;  // situations whose motion through time is asked
};

// limits: situations with the ask whose conditions are asked at them. Throws StatementError as the evaluation of the
// asks does.
StatementQuestions questions_of(const Statement& statement, Sample& sample,
                                const std::map<std::size_t, std::size_t>& limits);

}  // namespace poinsot::problem
