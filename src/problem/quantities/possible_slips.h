// Which states of contacts with friction the bodies allow together, whatever their forces: two feet of a table that
// stick let no third one slide.
//
// Where nothing moves yet, how fast a contact begins to come apart and to slip is linear in the accelerations a of the
// coordinates, and so is what stays closed and at rest:
//   it sticks:  n.a = 0 and t.a = 0;   it slides:  n.a = 0;   C a = 0 of all of them, a = N c.
// One that is to slide does not where t N = 0, and one that is to part does not where n N = 0. Other constraints take
// more motions away, so that what is not allowed here never holds. Where the rows t N are multiples of one, it slips
// along one line whatever the forces, as what a joint holds in a plane does.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "problem/quantities/rough_contact.h"

namespace poinsot::problem {

class PossibleSlips {
 public:
  // Allows everything.
  PossibleSlips() = default;
  // Of contacts at a state.
  PossibleSlips(const solve::MechanismStateOf<double>& state, const std::vector<RoughContactOf<double>>& contacts);

  // grips: of each contact. Where something moves already everything is allowed.
  bool allow(const std::vector<Grip>& grips) const;
  // Whether contact k can slip along one line only.
  bool along_one_line(std::size_t k, const std::vector<Grip>& grips) const;

 private:
  // How it comes apart and slips, by coordinate; empty where that is not looked at, as of cords.
  struct Rows {
    std::vector<double> apart;
    std::vector<std::vector<double>> slips;
  };
  // The columns span the motions that the grips leave.
  Eigen::MatrixXd free_motions(const std::vector<Grip>& grips) const;

  std::vector<Rows> rows_;
  std::size_t coordinates_ = 0;
  bool moves_already_ = false;
};

}  // namespace poinsot::problem
