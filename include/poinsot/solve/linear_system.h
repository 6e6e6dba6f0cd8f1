// Linear equations with names: what they determine, what they leave open, and where they contradict each other.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace poinsot::solve {

struct LinearSolution {
  std::vector<double> value;                    // one solution; open unknowns that nothing fixes are zero in it
  std::vector<std::vector<double>> open;        // basis of the solutions of the homogeneous equations
  std::vector<std::vector<std::size_t>> share;  // for each of `open`: the unknowns that it moves
  std::vector<std::size_t> conflict;            // equations that cannot hold together; empty when all hold
  std::vector<double> misfit;                   // of each equation, in its natural unit
  double size = 0;                              // of the largest term of any equation, in natural units
  double residual = 0;                          // largest misfit, relative to the largest term of any equation
  double condition = 1;                         // ratio of the extreme pivots, after scaling

  // Whether the equations fix this unknown.
  bool determined(std::size_t unknown) const;
};

// Equations sum_j a_ij x_j = b_i. Every unknown and equation comes with the size of one natural unit of it in the
// problem at hand, so that lengths in millimetres and couples in kilonewton metres meet as numbers near one.
class LinearSystem {
 public:
  std::size_t add_unknown(std::string name, double scale = 1);
  std::size_t add_equation(std::string words, double scale = 1);
  // rounding: up to which a coefficient may be what rounding left of zero, in its own unit; a small part of the largest
  // one of the equation when left out. Coefficients below it count as zero.
  void add(std::size_t equation, std::size_t unknown, double coefficient, std::optional<double> rounding = {});
  // size: of the terms that the value was made from, where they may have cancelled.
  void add_right_side(std::size_t equation, double value, double size = 0);

  std::size_t unknowns() const { return names_.size(); }
  std::size_t equations() const { return words_.size(); }
  const std::string& name(std::size_t unknown) const { return names_[unknown]; }
  const std::string& words(std::size_t equation) const { return words_[equation]; }

  // By Householder QR with column pivoting on the scaled equations. Never throws; see LinearSolution::conflict, which
  // also names equations whose numbers are not finite.
  LinearSolution solve() const;

 private:
  struct Entry {
    std::size_t equation, unknown;
    double coefficient;
    std::optional<double> rounding;
  };
  std::vector<std::string> names_, words_;
  std::vector<double> unknown_scale_, equation_scale_, right_side_;
  std::vector<double> right_size_;  // sums of the magnitudes added to each right side, which may cancel there
  std::vector<Entry> entries_;
};

}  // namespace poinsot::solve
