#include "poinsot/engine/solve/instant/rough_impact.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace poinsot::solve {
namespace {

constexpr double of_products = 1e-12;  // rounding of W times an impulse

Vector3<double> across(const Vector3<double>& u) { return {0, u.y, u.z}; }
double slip_speed(const Vector3<double>& u) { return std::hypot(u.y, u.z); }

// The part of W that maps friction to slip, by its principal directions.
struct SlipMobility {
  std::array<double, 2> size{};            // not negative
  std::array<Vector3<double>, 2> along{};  // directions across the push
  std::array<double, 2> coupled{};         // the slip for each unit of the push
};

SlipMobility slip_mobility(const Matrix3<double>& W) {
  const double angle = 0.5 * std::atan2(2 * W(1, 2), W(1, 1) - W(2, 2));
  SlipMobility mobility;
  mobility.along = {Vector3<double>{0, std::cos(angle), std::sin(angle)},
                    Vector3<double>{0, -std::sin(angle), std::cos(angle)}};
  const Vector3<double> by_push = across(W.column(0));
  for (std::size_t i = 0; i < 2; ++i) {
    mobility.size[i] = dot(mobility.along[i], W * mobility.along[i]);
    mobility.coupled[i] = dot(mobility.along[i], by_push);
  }
  return mobility;
}

// The blow on its way, and where it ends.
class Way {
 public:
  Way(const Matrix3<double>& W, const Vector3<double>& before, const RoughImpactLaw& law, double still)
      : W_(W), law_(law), still_(still), approach_(-before.x), size_(0) {
    course_.velocity = before;
    for (std::size_t i = 0; i < 3; ++i) size_ = std::max(size_, W(i, i));
  }

  RoughImpactCourse follow() {
    if (slip_speed(course_.velocity) > still_) slide_until_slip_vanishes();
    if (!ended_) go_on_from_no_slip();
    return course_;
  }

 private:
  // The impulse for each unit of the push while the point slips along d.
  Vector3<double> sliding(const Vector3<double>& d) const { return Vector3<double>{1, 0, 0} - law_.friction * d; }

  void slide_until_slip_vanishes() {
    RoughImpactCourse::Stretch stretch;
    Vector3<double> d = normalized(across(course_.velocity));
    stretch.from_slip = std::atan2(d.z, d.y);
    if (!keeps_direction(d)) {
      follow_turning_slip();
      if (ended_) return close(stretch, d);
      d = normalized(across(course_.velocity));
    }
    const Vector3<double> course = sliding(d);
    const double change = dot(d, W_ * course);  // of the slip, which is along d, by the push
    const double speed = slip_speed(course_.velocity);
    go_straight(course, change < 0 ? speed / -change : std::numeric_limits<double>::infinity());
    close(stretch, d);
    if (!ended_) course_.velocity = {course_.velocity.x, 0, 0};
  }

  void close(RoughImpactCourse::Stretch stretch, const Vector3<double>& d) {
    stretch.impulse = course_.impulse;
    stretch.velocity = course_.velocity;
    const Vector3<double> from{0, std::cos(stretch.from_slip), std::sin(stretch.from_slip)};
    const Vector3<double> to = slip_speed(course_.velocity) > still_ ? normalized(across(course_.velocity)) : d;
    stretch.turned = std::atan2(norm(cross(from, to)), dot(from, to));
    course_.stretches.push_back(stretch);
  }

  bool keeps_direction(const Vector3<double>& d) const {
    return norm(cross(across(W_ * sliding(d)), d)) <= 1e-13 * size_ * (1 + law_.friction);
  }

  // Sticks, or slips on along the direction that stays.
  void go_on_from_no_slip() {
    const SlipMobility mobility = slip_mobility(W_);
    Vector3<double> needed{};
    for (std::size_t i = 0; i < 2; ++i)
      if (mobility.size[i] > of_products * size_)
        needed += (-mobility.coupled[i] / mobility.size[i]) * mobility.along[i];
    RoughImpactCourse::Stretch stretch;
    Vector3<double> d = needed;
    if (norm(needed) <= law_.friction * (1 + of_products)) {
      stretch.sticks = true;
      go_straight(Vector3<double>{1, 0, 0} + needed, std::numeric_limits<double>::infinity());
    } else {
      d = outgoing_slip(mobility);
      stretch.from_slip = std::atan2(d.z, d.y);
      go_straight(sliding(d), std::numeric_limits<double>::infinity());
    }
    close(stretch, d);
    if (!ended_) course_.end = RoughImpactCourse::End::endless;
  }

  // The d of size one with coupled - mu W_tt d = k d, k > 0: |(mu W_tt + k)^-1 coupled| falls with k, from |a|/mu > 1.
  Vector3<double> outgoing_slip(const SlipMobility& mobility) const {
    const auto direction = [&](double k) {
      Vector3<double> d{};
      for (std::size_t i = 0; i < 2; ++i)
        if (mobility.coupled[i] != 0)
          d += (mobility.coupled[i] / (law_.friction * mobility.size[i] + k)) * mobility.along[i];
      return d;
    };
    double low = 0, high = std::hypot(mobility.coupled[0], mobility.coupled[1]);
    for (int halving = 0; halving < 200 && low < high; ++halving) {
      const double middle = 0.5 * (low + high);
      if (middle <= low || middle >= high) break;
      (norm(direction(middle)) > 1 ? low : high) = middle;
    }
    return normalized(direction(high));
  }

  // The work and the velocity along a stretch are known: u changes linearly with the push.
  void go_straight(const Vector3<double>& course, double most) {
    const double f = (W_ * course).x, no_change = of_products * size_ * (1 + norm(course));
    double left = most;
    if (!compressed_) {
      // A point that cannot be pressed further has its greatest compression where nothing moves any more.
      const bool at_rest = std::abs(course_.velocity.x) <= of_products * approach_;
      const double until = at_rest         ? 0
                           : f > no_change ? -course_.velocity.x / f
                                           : std::numeric_limits<double>::infinity();
      if (!(until <= left)) {
        if (std::isfinite(left)) advance(course, left);
        return;
      }
      advance(course, until);
      left -= until;
      reach_compression();
      if (ended_) return;
    }
    if (!std::isfinite(left) && f <= no_change) {
      course_.end = RoughImpactCourse::End::wedged;
      ended_ = true;
      return;
    }
    const double until = f > no_change ? rest_of_push(f) : std::numeric_limits<double>::infinity();
    if (until <= left) {
      advance(course, until);
      ended_ = true;
    } else if (std::isfinite(left)) {
      if (course_.velocity.x + f * left < -of_products * approach_) {
        course_.end = RoughImpactCourse::End::endless;
        ended_ = true;
        return;
      }
      advance(course, left);
    }
  }

  // The push that is left to the end of the blow if u . n grows by f for each unit of it.
  double rest_of_push(double f) const {
    const double v = course_.velocity.x;
    double rest = 0;
    switch (law_.hypothesis) {
      case RestitutionLaw::newton:
        rest = (law_.restitution * approach_ - v) / f;
        break;
      case RestitutionLaw::poisson:
        rest = (1 + law_.restitution) * course_.compression - course_.impulse.x;
        break;
      case RestitutionLaw::energetic: {
        const double work = missing_work();
        rest = 2 * work / (v + std::sqrt(std::max(0.0, v * v + 2 * f * work)));
        break;
      }
    }
    return std::max(0.0, rest);
  }
  double missing_work() const {
    return law_.restitution * law_.restitution * -course_.work_in_compression - course_.work_in_restitution;
  }

  void advance(const Vector3<double>& course, double push) {
    const Vector3<double> change = W_ * course;
    count_work((course_.velocity.x + 0.5 * change.x * push) * push);
    course_.impulse += push * course;
    course_.velocity += push * change;
    course_.way.push_back(course_.impulse);
  }
  void count_work(double work) { (compressed_ ? course_.work_in_restitution : course_.work_in_compression) += work; }

  void reach_compression() {
    compressed_ = true;
    course_.velocity.x = 0;
    course_.compression = course_.impulse.x;
    ended_ = law_.restitution == 0;
  }

  // With dp = |s| dl the slip has the rate ds/dl = |s| (W (n - mu d))_t, in which its direction turns at a finite rate
  // also where it vanishes.
  struct Turning {
    Vector3<double> velocity, impulse;
    double work = 0;
    Turning plus(const Turning& other, double factor) const {
      return {velocity + factor * other.velocity, impulse + factor * other.impulse, work + factor * other.work};
    }
  };
  Turning rate(const Turning& at) const {
    const double speed = slip_speed(at.velocity);
    const Vector3<double> course = speed * Vector3<double>{1, 0, 0} - law_.friction * across(at.velocity);
    return {W_ * course, course, at.velocity.x * speed};
  }

  // One step by the modified midpoint rule with 2, 4, 6 ... substeps, extrapolated to vanishing ones (Gragg, Bulirsch,
  // Stoer).
  Turning step(const Turning& from, double length) const {
    constexpr std::size_t rows = 8;
    std::array<Turning, rows> before{}, now{};
    for (std::size_t j = 0; j < rows; ++j) {
      const std::size_t substeps = 2 * (j + 1);
      const double h = length / static_cast<double>(substeps);
      Turning last = from, here = from.plus(rate(from), h);
      for (std::size_t k = 1; k < substeps; ++k) {
        const Turning next = last.plus(rate(here), 2 * h);
        last = here;
        here = next;
      }
      now[0] = Turning{}.plus(last.plus(here, 1).plus(rate(here), h), 0.5);
      for (std::size_t k = 1; k <= j; ++k) {
        const double ratio = static_cast<double>(j + 1) / static_cast<double>(j + 1 - k);
        now[k] = now[k - 1].plus(now[k - 1].plus(before[k - 1], -1), 1 / (ratio * ratio - 1));
      }
      before = now;
    }
    return now[rows - 1];
  }

  // What vanishes where the stretch of compression or of restitution ends, and grows towards it.
  double short_of_end(const Turning& at) const {
    if (!compressed_) return at.velocity.x;
    if (law_.hypothesis == RestitutionLaw::newton) return at.velocity.x - law_.restitution * approach_;
    if (law_.hypothesis == RestitutionLaw::poisson) return at.impulse.x - (1 + law_.restitution) * course_.compression;
    return at.work - law_.restitution * law_.restitution * -course_.work_in_compression;
  }

  void take(const Turning& at) {
    course_.velocity = at.velocity;
    course_.impulse = at.impulse;
    course_.way.push_back(at.impulse);
    (compressed_ ? course_.work_in_restitution : course_.work_in_compression) = at.work;
  }

  // To where the blow ends, or where the slip vanishes or keeps its direction.
  void follow_turning_slip() {
    constexpr int most_steps = 100'000;
    const double length = 0.25 / (size_ * (1 + law_.friction)), first_slip = slip_speed(course_.velocity);
    Turning here{course_.velocity, course_.impulse, 0};
    for (int count = 0; count < most_steps; ++count) {
      const double speed = slip_speed(here.velocity);
      constexpr double vanished = 1e-15;  // of the slip before: the rest changes nothing
      if (speed <= vanished * first_slip || keeps_direction(normalized(across(here.velocity)))) {
        take(here);
        return;
      }
      const Turning there = step(here, length);
      if (short_of_end(there) < 0) {
        if (compressed_ && there.velocity.x < 0) break;
        here = there;
        course_.way.push_back(here.impulse);
        continue;
      }
      double low = 0, high = length;
      for (int halving = 0; halving < 60; ++halving) {
        const double middle = 0.5 * (low + high);
        (short_of_end(step(here, middle)) < 0 ? low : high) = middle;
      }
      here = step(here, high);
      take(here);
      if (compressed_) {
        ended_ = true;
        return;
      }
      reach_compression();
      if (ended_) return;
      here = {course_.velocity, course_.impulse, 0};
    }
    course_.end = RoughImpactCourse::End::endless;
    ended_ = true;
  }

  const Matrix3<double>& W_;
  const RoughImpactLaw law_;
  const double still_, approach_;
  double size_;
  RoughImpactCourse course_;
  bool compressed_ = false, ended_ = false;
};

}  // namespace

RoughImpactCourse follow_rough_impact(const Matrix3<double>& inverse_mass, const Vector3<double>& before,
                                      const RoughImpactLaw& law, double still) {
  return Way(inverse_mass, before, law, still).follow();
}

}  // namespace poinsot::solve
