#include "engine/solve/instant/particle_paths.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "poinsot/engine/work/work.h"

namespace poinsot::solve {
namespace {

constexpr Work of_a_particle = 500, of_a_moving_particle = 20;

}  // namespace

ParticlePaths::ParticlePaths(const std::vector<CheckLink>& links, std::vector<Body> bodies,
                             const std::vector<double>& q, const std::vector<double>& v, const std::vector<double>& a,
                             double reach)
    : bodies_(std::move(bodies)), moving_(bodies_.size()) {
  for (const Body& body : bodies_)
    for (const auto& particle : *body.particles) length_ = std::max(length_, norm(drawn::widened(particle.position)));
  for (const CheckLink& link : links) length_ = std::max(length_, norm(drawn::widened(link.anchor)));
  pace_ = drawn::pace_of(links, v, a, std::max({length_, Real(reach), length_ > 0 || reach > 0 ? Real(0) : Real(1)}));
  step_ = drawn::step_of_pace / (pace_ > 0 ? pace_ : 1);
  for (std::size_t j = 0; j < at_.size(); ++j)
    at_[j] = drawn::displacements(links, q, v, a, (Real(j) - Real(now)) * step_);
}

drawn::Displacement ParticlePaths::relative(std::size_t time, int link, int from) const {
  const drawn::Displacement still;
  const drawn::Displacement& of = link < 0 ? still : at_[time][static_cast<std::size_t>(link)];
  if (from < 0) return of;
  const drawn::Displacement &before = at_[time][static_cast<std::size_t>(from)],
                            &present = at_[now][static_cast<std::size_t>(from)];
  const Matrix3<Real> back = present.turn * transpose(before.turn);
  return {back * of.turn, back * (of.shift - before.shift) + present.shift};
}

ParticlePaths::Vector ParticlePaths::drawn_place(int link, const Vector& place) const {
  if (link < 0) return place;
  const drawn::Displacement& present = at_[now][static_cast<std::size_t>(link)];
  return transpose(present.turn) * (place - present.shift);
}

// Differences are taken of what changes, so that a large distance from the origin does not cancel.
template <class Where>
ParticlePaths::Vector ParticlePaths::first_derivative(const Where& where) const {
  Vector sum = Vector::zero();
  for (std::size_t j = 1; j <= now; ++j)
    sum += (drawn::first_weights[j - 1] / step_) * (where(now + j) - where(now - j));
  return sum;
}
template <class Where>
ParticlePaths::Vector ParticlePaths::second_derivative(const Where& where) const {
  const Vector present = where(now);
  Vector sum = Vector::zero();
  for (std::size_t j = 1; j <= now; ++j)
    sum += (drawn::second_weights[j - 1] / (step_ * step_)) * ((where(now + j) - present) + (where(now - j) - present));
  return sum;
}

ParticlePaths::Vector ParticlePaths::velocity(int link, const Vector& place, int from) const {
  const Vector x = drawn_place(link, place);
  return first_derivative([&](std::size_t time) { return relative(time, link, from)(x); });
}

ParticlePaths::Vector ParticlePaths::acceleration(int link, const Vector& place, int from) const {
  const Vector x = drawn_place(link, place);
  return second_derivative([&](std::size_t time) { return relative(time, link, from)(x); });
}

// Arms of length one along the axes of the ground turn with the body: w is half the sum of arm x rate.
ParticlePaths::Vector ParticlePaths::angular_velocity(int link, int from) const {
  return over_arms(link, from, [this](const auto& arm) { return first_derivative(arm); });
}

// Of alpha x arm + w x (w x arm) the last part cancels in the sum.
ParticlePaths::Vector ParticlePaths::angular_acceleration(int link) const {
  return over_arms(link, -1, [this](const auto& arm) { return second_derivative(arm); });
}

// Half the sum of arm x derivative of arm.
template <class Derivative>
ParticlePaths::Vector ParticlePaths::over_arms(int link, int from, const Derivative& derivative) const {
  Vector sum = Vector::zero();
  for (std::size_t k = 0; k < 3; ++k) {
    Vector arm = Vector::zero();
    arm[k] = 1;
    const Vector x = link < 0 ? arm : transpose(at_[now][static_cast<std::size_t>(link)].turn) * arm;
    sum += Real(0.5) * cross(arm, derivative([&](std::size_t time) { return relative(time, link, from).turn * x; }));
  }
  return sum;
}

const std::vector<ParticlePaths::Moving>& ParticlePaths::moving(std::size_t body) const {
  const Body& of = bodies_[body];
  if (moving_[body].size() == of.particles->size()) return moving_[body];
  std::vector<Moving> found;  // whole or not at all, if the work ends
  found.reserve(of.particles->size());
  for (const Particle<double>& particle : *of.particles) {
    count_work(of_a_particle);
    const Vector drawn = drawn::widened(particle.position);
    const auto where = [&](std::size_t time) { return at_[time][static_cast<std::size_t>(of.link)](drawn); };
    found.push_back({particle.mass, where(now), first_derivative(where), second_derivative(where)});
  }
  return moving_[body] = std::move(found);
}

ParticlePaths::Sums ParticlePaths::sums(int link, const Vector& P) const {
  Sums sums;
  sums.moments = {Vector::zero(), Vector::zero(), Vector::zero()};
  for (std::size_t body = 0; body < bodies_.size(); ++body) {
    if (link != all && bodies_[body].link != link) continue;
    for (const auto& [m, x, velocity, acceleration] : moving(body)) {
      count_work(of_a_moving_particle);
      const Vector r = x - P;
      sums.mass += m;
      sums.first_moment += m * x;
      sums.momentum += m * velocity;
      sums.angular_momentum += m * cross(r, velocity);
      sums.kinetic_energy += m * norm_squared(velocity) / 2;
      sums.rate += m * acceleration;
      sums.angular_rate += m * cross(r, acceleration);
      sums.power += m * dot(velocity, acceleration);
      sums.moments.row0 += (m * r.x) * r;
      sums.moments.row1 += (m * r.y) * r;
      sums.moments.row2 += (m * r.z) * r;
      sums.momentum_size += std::abs(m) * norm(velocity);
      sums.angular_size += std::abs(m) * norm(r) * norm(velocity);
      sums.energy_size += std::abs(m) * norm_squared(velocity) / 2;
      sums.rate_size += std::abs(m) * norm(acceleration);
      sums.power_size += std::abs(m) * norm(velocity) * norm(acceleration);
      sums.angular_rate_size += std::abs(m) * norm(r) * norm(acceleration);
      sums.moments_size += std::abs(m) * norm_squared(r);
    }
  }
  return sums;
}

}  // namespace poinsot::solve
