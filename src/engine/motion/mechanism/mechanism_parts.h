// What MechanismDynamics keeps: the mechanism with the memory of its equations of motion.
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "engine/motion/mechanism/pivoted_qr.h"
#include "poinsot/engine/dynamics/action_forces.h"
#include "poinsot/engine/dynamics/velocity_constraint.h"
#include "poinsot/engine/motion/mechanism/mechanism_dynamics.h"

namespace poinsot {

namespace detail {

inline void require_index(const char* function, const char* what, std::ptrdiff_t index, std::size_t size) {
  if (index >= 0 && static_cast<std::size_t>(index) < size) return;
  throw std::invalid_argument(std::string(function) + ": there is no " + what + " " + std::to_string(index) +
                              "; the mechanism has " + std::to_string(size));
}

}  // namespace detail

// Indices into lists are int, as those of bodies and coordinates are.
struct MechanismDynamics::Parts {
  using Vector = Vector3<double>;

  Parts(const Mechanism<double>& stated, std::span<const int> also_held);

  // A coordinate that moves `on` (sign 1) or `from` (-1), but not both.
  struct Coupling {
    int coordinate;
    double sign;
  };
  struct Range {
    int first = 0, last = 0;
  };
  // What a component has to do with the constraints.
  struct Link {
    bool works = false;   // it has power on free coordinates
    int constraint = -1;  // the one that it enforces: its force is sign times the multiplier
    double sign = 1;
    int rolling = -1;  // a constraint that tells where it acts
  };

  // mechanism_dynamics.cpp
  void load_positions(std::span<const double> q);
  void load(std::span<const double> q, std::span<const double> v);
  void find_axes();
  double rate_of(int coordinate, const PlacedForce<double>& force) const;
  void add_generalised(const Range& range, const PlacedForce<double>& force, double factor, double* into) const;
  void find_known_forces();
  void find_accelerations(std::span<double> acceleration);
  void find_by_tree(std::span<double> acceleration);
  void find_under_constraints(std::span<double> acceleration);
  void find_mass();
  void split_mass();
  void find_with_unknown_forces();
  PlacedForce<double> force_of_component(int component) const;
  double find_held_effort(int coordinate) const;
  double selected_independence() const;

  // mechanism_constraints.cpp
  void add_row(int constraint, const PlacedForce<double>& unit);
  void find_row(int constraint);
  void factor_rows(const std::vector<int>& constraints, double tolerance, bool positions_first,
                   int most = std::numeric_limits<int>::max());
  void choose_rows(int most = std::numeric_limits<int>::max());
  void adopt_chosen();
  void select_rows();
  void factor_selected();
  double close_positions(bool selected);
  void make_quaternions_unit();
  void settle_velocities();
  double natural_gap(int constraint) const;
  double unit_of(int constraint) const;

  // mechanism_structure.cpp
  void find_couplings();
  Range couple(int on, int from);
  void link_components();
  std::size_t parts_with(const Component<double>& component) const;  // it and those that follow it
  bool enforces(const Component<double>& component, const VelocityConstraint<double>& c, double& sign) const;
  void take_random_pose(unsigned seed);
  void find_structure();
  void find_acting();

  double mass_entry(int i, int j) const { return i < j ? mass[j * n + i] : mass[i * n + j]; }

  Mechanism<double> mechanism;  // its tree knows the modes of the coordinates
  int n = 0;                    // velocity coordinates
  Workspace<double> workspace;
  State<double> state;
  double length = 1, largest_mass = 1;

  std::vector<char> is_held;
  std::vector<int> held, free;
  std::vector<int> body_of, place_in_joint;  // of each coordinate
  std::vector<char> turns;                   // each coordinate

  std::vector<Coupling> couplings;
  std::vector<Range> of_constraint, of_component, of_law;
  std::vector<std::vector<Range>> of_spans;      // of each constraint: those of a cord led over wheels
  std::vector<std::optional<Vector>> free_axis;  // of each constraint
  std::vector<Link> links;                       // of each component
  std::vector<int> with_offset;                  // components that are more than a part of another
  bool capstans = false;                         // whether a cord slips with friction

  // What acts now.
  std::vector<char> acting;         // each action
  std::vector<int> acting_rows;     // constraints
  std::vector<int> acting_columns;  // components that work
  bool forces_unknown = false;      // components do not all stand along constraints
  bool inertia_singular = false;    // of the tree, in every pose
  bool stale = true;                // the selection is
  std::vector<int> selected;        // independent constraints among those that act
  int independent = 0;              // how many of these there are but in singular poses
  double most_independence = 0;     // of the poses met
  double chosen_pivot = 1;          // the least pivot of the selected ones since they were compared with the others
  std::vector<char> shared;         // each constraint: its multiplier is not determined

  // At the present state. Motions of each coordinate's body about `origin`, on ground axes.
  std::vector<Vector> angular, linear, origin;
  std::vector<double> given, known, bias_force, held_force;  // n each
  std::vector<double> step, rest_accelerations;              // n each; the latter stay zero
  std::vector<double> mass;                                  // n by n, lower triangle
  std::vector<double> scale;                                 // of each free coordinate
  std::vector<char> without_inertia;                         // each free coordinate
  std::vector<double> row, row_bias, row_size;               // J: n numbers per constraint; row_size: in scaled units
  std::vector<double> column, column_size;                   // the same of components that work
  std::vector<double> multiplier;                            // each constraint
  std::vector<double> component_size;                        // each component, where forces are unknown
  std::vector<double> acceleration;                          // n
  double force_misfit = 0;
  bool by_tree = true;  // how the last accelerations were found
  detail::PivotedQr qr, force_qr;
  std::vector<double> split, block, block_diagonal, right, motion, rest;
  std::vector<int> block_order;
  std::vector<int> factored, position_rows;  // constraints in the columns of qr
  std::vector<char> classes;
  std::vector<double> saved_q, saved_v, best_q;
};

}  // namespace poinsot
