// An instant near whose steady motion something swings: what quantities there change by, and whether the equations of
// the instant, Newton's and Euler's for each body, hold for it.
#pragma once

#include <algorithm>
#include <array>
#include <complex>
#include <optional>
#include <string>
#include <vector>

#include "poinsot/engine/solve/stability/response.h"
#include "problem/instant/instant.h"

namespace poinsot::problem {

class ShakenInstant {
 public:
  // base: an instant in steady motion, which must outlive the object. Throws UnansweredError where the response is not
  // known, or where a second road does not confirm it.
  ShakenInstant(SolvedInstant& base, const Excitation& stated, std::optional<double> frequency, const Mark& mark);

  // The complex amplitude of a quantity, of a vector those of its components on the axes.
  struct Swing {
    bool vector = false;
    Dimension dimension;
    std::array<std::complex<double>, 3> parts{};
  };
  Swing swing(const Expression& quantity, const std::optional<Expression>& axes);

  const Excitation& stated() const { return stated_; }
  const std::optional<double>& asked_frequency() const { return asked_; }
  double misfit() const { return misfit_; }

 private:
  using Varied = Dual<1>;
  using Vector = Vector3<double>;

  void refuse(const std::string& what, const std::string& hint = "") const;
  void refuse_motion() const;
  void read(std::optional<double> frequency);
  void read_force();
  void read_unbalance();
  void read_coordinate();
  Place<double> place_of(int body) const;
  void confirm_as_drawn(int body, int axes, const Vector3<double>& drawn, const Vector3<double>& now) const;
  Vector spin_of(int body) const;
  Vector center_of(int body) const;
  void find_response();

  void build();
  // Sets the state after the frame and the spins have turned for a while, with what swings in a phase as the variable,
  // and displaced by a part of it.
  void put(double delay, double phase, double by = 0);
  void refuse_loose(const Expression& quantity, const std::optional<Expression>& axes);
  void refuse_corners(const Expression& quantity, const std::optional<Expression>& axes, double size);
  bool turns() const;
  std::vector<double> later(const std::vector<double>& along, double delay) const;
  Value<Varied> value(const Expression& quantity, const std::optional<Expression>& axes,
                      const std::vector<Varied>& unknowns);
  // In one phase everything may rest: misfits count beside the largest size of all phases.
  struct Misfit {
    double off = 0, size = 0;
    void take(const Misfit& other) {
      off = std::max(off, other.off);
      size = std::max(size, other.size);
    }
    double part() const { return size > 0 ? off / size : 0; }
  };
  Misfit balance_misfit() const;
  Misfit need_misfit(const solve::ResponseCheck& check, bool imaginary) const;
  double natural_size(const Dimension& dimension) const;

  SolvedInstant& base_;
  const Excitation& stated_;
  const std::optional<double> asked_;
  Mark mark_;
  Mechanism<double> near_;
  solve::SteadyMotion motion_;
  solve::Excitation excitation_;
  solve::Response response_;
  solve::Response::Motion shown_;  // what the state is displaced by
  double misfit_ = 0, largest_force_ = 0;

  DataScope<Varied> data_;
  MachineOf<Varied> machine_;
  std::optional<solve::MechanismStateOf<Varied>> state_;
  solve::LinearSystemOf<Varied> equations_;
  std::vector<Varied> unknowns_;
  std::vector<std::vector<double>> open_;
};

}  // namespace poinsot::problem
