// From a stated problem with values to a mechanism: bodies, frames and joints become a tree, everything else acts on
// it.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "poinsot/model/mechanism.h"
#include "poinsot/solve/impulse.h"
#include "poinsot/solve/particle_check.h"
#include "poinsot/statement/data.h"
#include "statement/masses.h"

namespace poinsot::statement {

// A coordinate that has a name in the statement, or belongs to a joint of one freedom.
struct NamedCoordinate {
  std::string name;  // "" if only its joint names it
  std::string joint;
  int position = 0;  // in q
  int velocity = 0;  // in v
  bool turning = true;
  Mark mark;
};

// The rate or acceleration of a coordinate as the statement gives it.
struct StatedRate {
  std::string words;
  int velocity = 0;
  double value = 0;
  bool turning = true;
  Mark mark;
};

struct JointPlace {
  Place<double> at;  // rides with the held body
  std::optional<Direction<double>> axis;
  int from = ground, to = ground;
};

// An impulse on a body in any pose; `absorbed`: mass of a particle that stays in the body at the place.
struct StatedImpulse {
  int action = 0;
  int on = ground;
  bool couple = false;
  Place<double> at;
  Vector3<double> vector{};  // on the axes of `axes`
  int axes = ground;
  double absorbed = 0;
  double particle_mass = 0;        // of a strike
  std::optional<int> relative_to;  // of a strike: the vector is the particle's mass times its velocity relative to this
  double kept = 0;                 // of a strike: the part of its momentum relative to the body that it keeps
};

struct Machine {
  Mechanism<double> mechanism;
  std::vector<solve::CheckLink> links;           // of each body of the tree, as drawn
  std::map<std::string, int> index;              // of bodies and frames, and "ground"
  std::map<int, Vector3<double>> drawn_origin;   // of each tree body, on ground axes
  std::vector<std::pair<int, BodyMass>> masses;  // of each body of the statement
  std::vector<NamedCoordinate> coordinates;
  std::vector<double> q;             // positions that the data give; the rest as drawn
  std::vector<bool> position_given;  // of each entry of q
  std::vector<StatedRate> rates, accelerations;
  std::vector<StatedImpulse> impulses;
  std::vector<solve::Impact> impacts;
  std::map<std::string, JointPlace> joints;
  std::vector<std::string> loop_joints;  // joints that close loops

  // The place that a point as drawn takes on a body.
  Place<double> place(int body, const Vector3<double>& drawn) const;
  const NamedCoordinate* coordinate(const std::string& name) const;
  // The actions that the name stands for: joints with their supports and drives, supports, contacts, cords, springs.
  std::vector<std::size_t> actions_of(const std::string& name, const std::string& joint = "") const;
};

struct MachineOptions {
  bool lenient = false;                           // unknowns have trial values
  double time = 0;                                // s
  Vector3<double> open_gravity{};                 // taken if the statement says nothing of gravity
  std::optional<std::vector<std::string>> loads;  // those that act; all when left out
};

// data must have been made for the same problem and time. Throws StatementError.
Machine build_machine(const Problem& problem, DataScope<double>& data, DataScope<TimeJet>& timed, const AnyValue& any,
                      const MachineOptions& options);

}  // namespace poinsot::statement
