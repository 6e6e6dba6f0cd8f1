// Programs within second-order cones: the least value of a linear function of unknowns that are held in cones.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <vector>

namespace poinsot::solve {

// The least c . x for which h - G x lies in all cones and |x| <= reach. The rows of G come cone by cone, sizes[i] of
// them: the first is at least the size of the vector of the others; a cone of one row holds what is not negative. Some
// x must lie inside all cones. Coefficients should be near one.
struct ConeProgram {
  Eigen::VectorXd c;
  Eigen::MatrixXd G;
  Eigen::VectorXd h;
  std::vector<Eigen::Index> sizes;
  double reach = 1e3;
};

struct ConeOptimum {
  Eigen::VectorXd x;            // that may lie outside of cones by rounding
  Eigen::VectorXd multipliers;  // z of the rows of G: in all cones, with G' z + c as small as `bound` tells
  double bound = 0;             // no x has a lesser c . x:  -h . z - reach |G' z + c|
};

// Nothing if the way is lost in rounding before there is any bound. enough: whether what was found so far will do; it
// goes on to the last digits where that is empty.
std::optional<ConeOptimum> minimise(const ConeProgram& program,
                                    const std::function<bool(const ConeOptimum&)>& enough = {});

}  // namespace poinsot::solve
