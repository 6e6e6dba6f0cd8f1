// Jacobi's elliptic functions sn, cn, dn and the amplitude, of one parameter and many arguments.
//
// As ratios of theta functions (DLMF 22.2): series in the nome for m <= 1/2, in the complementary nome, by Jacobi's
// imaginary transformation, for m > 1/2. The nome is at most 0.043 in either, and the series need four terms. Prepared
// once, an evaluation takes some tens of nanoseconds and allocates nothing.
#pragma once

#include "poinsot/engine/math/elliptic/elliptic_integrals.h"

namespace poinsot {

class JacobiFunctions {
 public:
  struct Values {
    double sn, cn, dn;
  };

  // For 0 <= m <= 1; otherwise the functions are NaN.
  explicit JacobiFunctions(const EllipticParameter<long double>& parameter);
  explicit JacobiFunctions(const EllipticParameter<double>& parameter)
      : JacobiFunctions(EllipticParameter<long double>{parameter.m, parameter.complement}) {}

  // K; infinite where the parameter is one.
  long double quarter_period() const { return K_; }

  // For any u. Errors: some 1e-16, plus those that the rounding of u stands for. dn, and sn near its zero at u = 0,
  // keep their relative precision.
  Values at(double u) const;
  // The same for |u| <= K (1 + 1e-8), without reduction by the period.
  Values in_middle_cell(double u) const;

  // am u, rad: sn u = sin(am u), cn u = cos(am u), continuous in u.
  double amplitude(double u) const;

 private:
  // u - 2 K n with |u - 2 K n| <= K.
  struct Reduced {
    double u, n;
  };
  Reduced reduced(double u) const;

  bool trigonometric_ = true;  // m <= 1/2
  long double K_ = 0, K1_ = 0;
  double period_high_ = 0, period_low_ = 0;                     // 2 K
  double rate_ = 0;                                             // of z = pi u / (2 K) or X = pi u / (2 K')
  double p_ = 0, p2_ = 0, p4_ = 0, p6_ = 0, p9_ = 0, p12_ = 0;  // powers of the nome
  double sn_factor_ = 1, cn_factor_ = 1, dn_factor_ = 1;
};

}  // namespace poinsot
