#include "engine/motion/rotation/rotation_collocation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "engine/motion/integrator/gauss_step.h"
#include "poinsot/engine/math/algebra/pack.h"
#include "poinsot/engine/math/algebra/rotation.h"

namespace poinsot {

namespace {

namespace gauss = gauss_legendre_8;
constexpr int stages = gauss::stages;
using Stages = Pack<stages>;  // one number per stage
using Vector = Vector3<double>;
using Vectors = Vector3<Stages>;

struct alignas(64) StageNumbers {
  double at[stages];
};

StageNumbers numbers_of(const Stages& pack) {
  StageNumbers numbers;
  pack.lanes().copy_to(numbers.at, std::experimental::vector_aligned);
  return numbers;
}

Vectors spread(const Vector& v) { return {Stages(v.x), Stages(v.y), Stages(v.z)}; }

struct Tables : gauss::StagePacks {
  StageNumbers last;         // row 7 of the Legendre coefficients over the weights
  StageNumbers before_last;  // row 6

  Tables() {
    for (int j = 0; j < stages; ++j) {
      last.at[j] = gauss::legendre[7][j] / gauss::weights[j];
      before_last.at[j] = gauss::legendre[6][j] / gauss::weights[j];
    }
  }
};
const Tables& tables() {
  static const Tables made;
  return made;
}

// Reciprocal moments seen from the principal axis i.
struct Around {
  std::size_t i;
  std::size_t j;
  std::size_t k;
  double own;               // 1/I_i
  double mean;              // of 1/I_j and 1/I_k
  double difference;        // half of it
  Quaternion<double> axes;  // (j, k, i) axes to principal axes
};

Around around(const PrincipalBody& body, std::size_t i) {
  const std::size_t j = (i + 1) % 3;
  const std::size_t k = (i + 2) % 3;
  const double Rj = 1.0 / body.moments[j];
  const double Rk = 1.0 / body.moments[k];
  const Quaternion<double> cycle[3] = {{0.5, 0.5, 0.5, 0.5}, {0.5, -0.5, -0.5, -0.5}, {1.0, 0.0, 0.0, 0.0}};
  return {i, j, k, 1.0 / body.moments[i], 0.5 * (Rj + Rk), 0.5 * (Rj - Rk), cycle[i]};
}

// The axis about which the body is most nearly symmetric, for the momentum m on principal axes.
Around symmetry_axis(const PrincipalBody& body, const Vector& m) {
  std::size_t best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const std::size_t k = (i + 2) % 3;
    const double unequal = std::fabs(1.0 / body.moments[j] - 1.0 / body.moments[k]);
    const double departure = unequal * unequal * (m[j] * m[j] + m[k] * m[k]);
    if (departure < least) {
      least = departure;
      best = i;
    }
  }
  return around(body, best);
}

// The iteration over the stages of one step.
template <bool HasTorque>
class Iteration {
 public:
  static constexpr int count = HasTorque ? 7 : 4;

  Iteration(const PrincipalBody& body, const RotationState& state, double t, double h, double momentum_size)
      : body_(body),
        L0_(state.momentum),
        carry_(state.carry),
        t_(t),
        h_(h),
        per_momentum_(1.0 / momentum_size),
        around_(symmetry_axis(body, transpose_times(rotation_matrix(state.attitude), state.momentum))) {
    const Tables& T = tables();
    const Quaternion<double> start = state.attitude * around_.axes;
    const Matrix3<double> R = rotation_matrix(start);
    const double m_z = R.row0.z * L0_.x + R.row1.z * L0_.y + R.row2.z * L0_.z;
    spin_ = m_z * (around_.own - around_.mean);
    turning_ = around_.mean * L0_;
    rate_ = norm(turning_);
    axis_ = rate_ > 0.0 ? turning_ / rate_ : Vector{0.0, 0.0, 1.0};

    const auto [s, c] = sine_cosine(Stages(spin_ * h) * T.nodes);
    double fastest = around_.difference != 0.0 ? 2.0 * std::fabs(spin_) : 0.0;
    const Stages d(around_.difference);
    d_cosine_ = d * (c * c - s * s);
    d_sine_ = (d + d) * s * c;
    weight_ = Stages(h) * T.weights;
    start_ = {start.w, start.x, start.y, start.z, 0.0, 0.0, 0.0};
    if constexpr (HasTorque) {
      const auto [sine, cosine] = sine_cosine(Stages(rate_ * h) * T.nodes);
      precession_sine_ = sine;
      precession_cosine_ = cosine;
      if (body.has_weight) {
        // Gravity on the axes of S, the arm on those of F.
        down_ = into_precessing(body.down);
        const Vector arm{body.weight_arm[around_.j], body.weight_arm[around_.k], body.weight_arm[around_.i]};
        arm_ = {Stages(arm.x) * c - Stages(arm.y) * s, Stages(arm.x) * s + Stages(arm.y) * c, Stages(arm.z)};
        arm_along_axis_ = arm.x == 0.0 && arm.y == 0.0;
        if (!arm_along_axis_) fastest = std::max(fastest, std::fabs(spin_));
      }
      // A torque may well have the period of half a turn.
      fastest = std::max(fastest, body.body ? 2.0 * (std::fabs(spin_) + rate_) : rate_);
    }
    // Of a top's, most is an error of the energy, which is given back (rotation_method.cpp).
    missed_ = missed_part(fastest * h, HasTorque && body.keeps_energy() ? 0.3 : 1.0);
  }

  // The first round: the rates of the state at rest in its frames. As the next ones, returns the square of the change.
  double begin() {
    for (Stages& increment : increments_) increment = Stages(0.0);
    return update(rates(Quaternion<double>{start_[0], start_[1], start_[2], start_[3]}, Vector3<double>{}));
  }

  // One round more.
  double improve() {
    const Tables& T = tables();
    std::array<Stages, count> y;
    for (int n = 0; n < count; ++n) {
      const StageNumbers inc = numbers_of(increments_[n]);
      Stages even = Stages(start_[n]) + T.ratios[0] * Stages(inc.at[0]);
      Stages odd = T.ratios[1] * Stages(inc.at[1]);
      for (int j = 2; j < stages; j += 2) {
        even = even + T.ratios[j] * Stages(inc.at[j]);
        odd = odd + T.ratios[j + 1] * Stages(inc.at[j + 1]);
      }
      y[n] = even + odd;
    }
    Vectors l{};
    if constexpr (HasTorque) l = {y[4], y[5], y[6]};
    return update(rates(Quaternion<Stages>{y[0], y[1], y[2], y[3]}, l));
  }

  // What the polynomials in the step leave over, times a factor as small: for the slow part of the motion, which the
  // adjoint motion shares, itself (order 16 in all); for what turns with the body, the error of the quadrature.
  double estimated_error() const {
    const Tables& T = tables();
    double largest = 0.0;
    for (int n = 0; n < count; ++n) {
      const StageNumbers inc = numbers_of(increments_[n]);
      double last = 0.0;
      double before_last = 0.0;
      for (int j = 0; j < stages; ++j) {
        last += T.last.at[j] * inc.at[j];
        before_last += T.before_last.at[j] * inc.at[j];
      }
      const double left = std::max(std::fabs(last), 0.3 * std::fabs(before_last));
      largest = std::max(largest, n < 4 ? left : left * per_momentum_);
    }
    return largest * (0.1 * largest + missed_);
  }

  RotationState end() const {
    std::array<double, count> y;
    for (int n = 0; n < count; ++n) {
      const StageNumbers inc = numbers_of(increments_[n]);
      y[n] = start_[n] + gauss::sum_of_increments(inc.at);
    }
    const auto [half_sine, half_cosine] = sine_cosine(0.5 * rate_ * h_);
    const Quaternion<double> precession{half_cosine, half_sine * axis_.x, half_sine * axis_.y, half_sine * axis_.z};
    const auto [spin_sine, spin_cosine] = sine_cosine(0.5 * spin_ * h_);
    RotationState state;
    state.attitude = normalized(precession * Quaternion<double>{y[0], y[1], y[2], y[3]} *
                                Quaternion<double>{spin_cosine, 0.0, 0.0, spin_sine} * conjugate(around_.axes));
    state.momentum = L0_;
    state.carry = carry_;
    if constexpr (HasTorque) {
      // L0 lies along the axis of the precession: only what was gained turns.
      state.gain(rotation_matrix(precession) * Vector{y[4], y[5], y[6]});
    }
    return state;
  }

 private:
  // Increments from rates. Returns the sum of squares of their changes, which is no number if one of them is none.
  [[gnu::always_inline]] double update(const std::array<Stages, count>& rate) {
    using Lanes = Stages::Lanes;
    Lanes attitude_change(0.0);
    Lanes momentum_change(0.0);
    for (int n = 0; n < count; ++n) {
      const Stages increment = weight_ * rate[n];
      const Lanes change = (increment - increments_[n]).lanes();
      Lanes& sum = n < 4 ? attitude_change : momentum_change;
      sum += change * change;
      increments_[n] = increment;
    }
    return std::experimental::reduce(attitude_change + (per_momentum_ * per_momentum_) * momentum_change);
  }

  // By how much eight Gauss points miss the integral of a wave that turns by the angle on the way, at most all of it:
  // the part that counts of its leading term in the angle.
  static double missed_part(double angle, double counted) {
    const double x = std::fabs(angle) / 20.0;
    const double x2 = x * x;
    const double x4 = x2 * x2;
    const double x8 = x4 * x4;
    return std::min(1.0, counted * 0.022 * x8 * x8);
  }

  // Components on the axes of S at the stages from those on the ground's: turned back about the axis.
  Vectors into_precessing(const Vector& v) const {
    const Vector along = dot(axis_, v) * axis_;
    const Vector across = v - along;
    const Vector turned = cross(axis_, v);
    return spread(along) + precession_cosine_ * spread(across) - precession_sine_ * spread(turned);
  }

  // Number: double for a state that is the same at all stages.
  template <class Number>
  [[gnu::always_inline]] std::array<Stages, count> rates(const Quaternion<Number>& one,
                                                         const Vector3<Number>& gained) const {
    constexpr bool rests = std::is_same_v<Number, double>;
    const Matrix3<Number> R_one = rotation_matrix(one);
    Vector3<Number> L_one;
    if constexpr (rests)
      L_one = L0_;
    else
      L_one = spread(L0_) + gained;
    const Vector3<Number> m_one = transpose_times(R_one, L_one);
    const auto lanes = [](const Number& x) { return Stages(x); };
    const Quaternion<Stages> q{lanes(one.w), lanes(one.x), lanes(one.y), lanes(one.z)};
    const Vectors m{lanes(m_one.x), lanes(m_one.y), lanes(m_one.z)};
    Vectors w{d_cosine_ * m.x + d_sine_ * m.y, d_sine_ * m.x - d_cosine_ * m.y,
              lanes(Number(around_.own - around_.mean) * m_one.z - Number(spin_))};
    std::array<Stages, count> rate;
    if constexpr (HasTorque) {
      const Matrix3<Stages> R{{lanes(R_one.row0.x), lanes(R_one.row0.y), lanes(R_one.row0.z)},
                              {lanes(R_one.row1.x), lanes(R_one.row1.y), lanes(R_one.row1.z)},
                              {lanes(R_one.row2.x), lanes(R_one.row2.y), lanes(R_one.row2.z)}};
      Vectors torque{Stages(0.0), Stages(0.0), Stages(0.0)};
      if constexpr (!rests) {
        w += transpose_times(R, Stages(around_.mean) * gained);
        torque = cross(gained, spread(turning_));
      }
      if (body_.has_weight)
        torque += cross(arm_along_axis_ ? arm_.z * Vectors{R.row0.z, R.row1.z, R.row2.z} : R * arm_, down_);
      if (body_.body) torque += further_torque(q, {lanes(L_one.x), lanes(L_one.y), lanes(L_one.z)});
      rate[4] = torque.x;
      rate[5] = torque.y;
      rate[6] = torque.z;
    }
    // q (0, w)/2.
    const Vectors half = Stages(0.5) * w;
    rate[0] = -(q.x * half.x + q.y * half.y + q.z * half.z);
    rate[1] = q.w * half.x + q.y * half.z - q.z * half.y;
    rate[2] = q.w * half.y + q.z * half.x - q.x * half.z;
    rate[3] = q.w * half.z + q.x * half.y - q.y * half.x;
    return rate;
  }

  // Stage by stage on ground axes, then on those of S.
  Vectors further_torque(const Quaternion<Stages>& q, const Vectors& L) const {
    Vectors torque;
    for (int i = 0; i < stages; ++i) {
      const double time = gauss::nodes[i] * h_;
      const auto [half_sine, half_cosine] = sine_cosine(0.5 * rate_ * time);
      const Quaternion<double> precession{half_cosine, half_sine * axis_.x, half_sine * axis_.y, half_sine * axis_.z};
      const auto [spin_sine, spin_cosine] = sine_cosine(0.5 * spin_ * time);
      const Quaternion<double> attitude =
          normalized(precession * Quaternion<double>{q.w.lane(i), q.x.lane(i), q.y.lane(i), q.z.lane(i)} *
                     Quaternion<double>{spin_cosine, 0.0, 0.0, spin_sine} * conjugate(around_.axes));
      const Matrix3<double> R_GS = rotation_about(axis_, rate_ * time);
      const Vector momentum = R_GS * Vector{L.x.lane(i), L.y.lane(i), L.z.lane(i)};
      const Vector on_body = body_.angular_velocity(attitude, momentum);
      const Vector own = rotation_matrix(body_.axes) * on_body;
      const Vector given = body_.body->torque(t_ + time, attitude * conjugate(body_.axes), own);
      const Vector here = transpose_times(R_GS, given);
      torque.x.set_lane(i, here.x);
      torque.y.set_lane(i, here.y);
      torque.z.set_lane(i, here.z);
    }
    return torque;
  }

  const PrincipalBody& body_;
  Vector L0_;
  Vector carry_;
  double t_;
  double h_;
  double per_momentum_;
  Around around_;
  double spin_;
  Vector turning_;
  double rate_;
  Vector axis_;
  std::array<double, 7> start_;
  double missed_;
  Stages d_cosine_;
  Stages d_sine_;
  Stages weight_;
  Stages precession_sine_;
  Stages precession_cosine_;
  Vectors down_;
  Vectors arm_;
  bool arm_along_axis_ = false;
  std::array<Stages, count> increments_;
};

template <bool HasTorque>
RotationStep solve(const PrincipalBody& body, const RotationState& state, double t, double h, double momentum_size,
                   double accuracy) {
  constexpr int most_iterations = 40;  // at a contraction of one half, twelve digits
  constexpr double rounding = 1e-16;   // of angles and of the momentum
  Iteration<HasTorque> iteration(body, state, t, h, momentum_size);
  RotationStep step;
  double last = 0.0;
  for (step.iterations = 1; step.iterations <= most_iterations; ++step.iterations) {
    const double change = std::sqrt(step.iterations == 1 ? iteration.begin() : iteration.improve());
    if (!std::isfinite(change)) {
      step.finite = false;
      return step;
    }
    if (step.iterations > 1) {
      step.contraction = last > 0.0 ? change / last : 0.0;
      // The rounds to come change no more, or rounding stirs the last bits.
      const bool small = gauss::contracted(change, step.contraction, accuracy);
      const bool stirred = change < 64.0 * rounding && (step.contraction >= 1.0 || accuracy > rounding);
      if (small || change == 0.0 || stirred) {
        step.converged = true;
        break;
      }
      // Contraction comes late, as for any Picard iteration, but not that late.
      if (step.iterations > 6 && step.contraction > 1.0) return step;
    }
    last = change;
  }
  if (!step.converged) return step;
  step.error = iteration.estimated_error();
  step.end = iteration.end();
  return step;
}

}  // namespace

RotationStep rotation_step(const PrincipalBody& body, const RotationState& state, double t, double h,
                           double momentum_size, double accuracy) {
  return body.has_torque() ? solve<true>(body, state, t, h, momentum_size, accuracy)
                           : solve<false>(body, state, t, h, momentum_size, accuracy);
}

double natural_step(const PrincipalBody& body, const RotationState& state, double t, double span) {
  const Vector m = transpose_times(rotation_matrix(state.attitude), state.momentum);
  const Around a = symmetry_axis(body, m);
  const double torque = body.has_torque() ? norm(body.torque(t, state.attitude, state.momentum)) : 0.0;
  const double weight = body.has_weight ? norm(body.weight_arm) : 0.0;
  const double momentum = norm(state.momentum);
  const double rate = std::fabs(a.difference) * std::hypot(m[a.j], m[a.k]) +
                      std::sqrt(std::max(torque, weight) * std::max(a.mean, a.own)) +
                      (momentum > 0.0 ? std::min(torque / momentum, 1e3 / span) : 0.0) + 1.0 / span;
  return 1.0 / rate;
}

}  // namespace poinsot
