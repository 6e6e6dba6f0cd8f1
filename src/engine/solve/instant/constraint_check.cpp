#include "poinsot/engine/solve/instant/constraint_check.h"

#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <optional>

#include "engine/solve/instant/drawn_motion.h"
#include "engine/solve/instant/true_surfaces.h"

namespace poinsot::solve {
namespace {

using drawn::Displacement;
using drawn::Real;
using drawn::Vector;
using drawn::widened;

using Constraint = VelocityConstraint<double>;

// Quantities over the nine times of a difference, from four steps before the instant to four after.
constexpr int reach = 4;
using Nine = std::array<Real, 2 * reach + 1>;

Real first_derivative(const Nine& value, Real h) {
  Real sum = 0;
  for (std::size_t j = 1; j <= reach; ++j)
    sum += drawn::first_weights[j - 1] * (value[reach + j] - value[reach - j]) / h;
  return sum;
}
Real second_derivative(const Nine& value, Real h) {
  Real sum = 0;
  for (std::size_t j = 1; j <= reach; ++j)
    sum += drawn::second_weights[j - 1] * ((value[reach + j] - value[reach]) + (value[reach - j] - value[reach]));
  return sum / (h * h);
}

// The vector of an antisymmetric matrix's part: w x r = M r.
Vector axial(const Matrix3<Real>& M) {
  return Real(0.5) * Vector{M(2, 1) - M(1, 2), M(0, 2) - M(2, 0), M(1, 0) - M(0, 1)};
}

// The bodies over seventeen times: nine, and those that the velocities at each of the nine are differences of.
class CarriedBodies {
 public:
  CarriedBodies(const std::vector<CheckLink>& links, const std::vector<double>& q, const std::vector<double>& v,
                const std::vector<double>& a, Real h)
      : links_(links), h_(h) {
    for (int j = -2 * reach; j <= 2 * reach; ++j)
      at_.push_back(drawn::displacements(links, q, v, a, static_cast<Real>(j) * h));
  }

  Real h() const { return h_; }

  // Time j counts steps from the instant, -8 to 8. The ground stays.
  const Displacement& displacement(int body, int j) const {
    static const Displacement none;
    return body == ground ? none : at_[static_cast<std::size_t>(j + 2 * reach)][static_cast<std::size_t>(body)];
  }
  // A point on a body's axes from its origin, as drawn: the axes of all bodies lie along those of the ground.
  Vector drawn_point(int body, const Vector3<double>& point) const {
    const Vector own = widened(point);
    return body == ground ? own : widened(links_[static_cast<std::size_t>(body)].anchor) + own;
  }
  Vector point(int body, const Vector3<double>& point, int j) const {
    return displacement(body, j)(drawn_point(body, point));
  }
  Vector direction(int body, const Vector3<double>& direction, int j) const {
    return displacement(body, j).turn * widened(direction);
  }
  // Of the particle of a body that is at the place P at time j: the velocity there.
  Vector velocity_at(int body, const Vector& P, int j) const {
    if (body == ground) return Vector::zero();
    const Displacement& now = displacement(body, j);
    const Vector own = transpose_times(now.turn, P - now.shift);
    Vector sum = Vector::zero();
    for (int k = 1; k <= reach; ++k)
      sum += drawn::first_weights[static_cast<std::size_t>(k - 1)] / h_ *
             (displacement(body, j + k)(own) - displacement(body, j - k)(own));
    return sum;
  }
  // dR/dt R^T = w x.
  Vector angular_velocity(int body, int j) const {
    Matrix3<Real> rate = Matrix3<Real>::zero();
    for (int k = 1; k <= reach; ++k) {
      const Real weight = drawn::first_weights[static_cast<std::size_t>(k - 1)] / h_;
      rate = rate + weight * displacement(body, j + k).turn - weight * displacement(body, j - k).turn;
    }
    return axial(rate * transpose(displacement(body, j).turn));
  }

 private:
  const std::vector<CheckLink>& links_;
  Real h_;
  std::vector<std::vector<Displacement>> at_;
};

// What must vanish: a gap (m, or of axes its sine) with its rates, or where only velocities are bound a rate with its
// rate. Nothing where the constraint binds none.
struct Bound {
  std::optional<Nine> gap;
  std::optional<Nine> rate;
  bool angular = false;
};

Nine over_time(const std::function<Real(int)>& value) {
  Nine nine{};
  for (int j = -reach; j <= reach; ++j) nine[static_cast<std::size_t>(j + reach)] = value(j);
  return nine;
}

class BoundFinder {
 public:
  BoundFinder(const CarriedBodies& bodies, const std::vector<Constraint>& constraints)
      : bodies_(bodies), constraints_(constraints) {}

  // The normal of a contact, by its surfaces.
  Vector3<double> normal(std::size_t index) const {
    const Constraint& c = constraints_[index];
    const Vector n = c.kind == VelocityConstraintKind::touching ? nearest_now(c).normal
                                                                : bodies_.direction(c.along.body, c.along.vector, 0);
    return {static_cast<double>(n.x), static_cast<double>(n.y), static_cast<double>(n.z)};
  }

  Bound of(std::size_t index) const {
    const Constraint& c = constraints_[index];
    switch (c.kind) {
      case VelocityConstraintKind::angular:
        return turning(index);
      case VelocityConstraintKind::cord_length:
        return {
            over_time([&](int j) {
              return norm(bodies_.point(c.at.body, c.at.point, j) - bodies_.point(c.toward.body, c.toward.point, j)) -
                     Real(c.length);
            }),
            std::nullopt};
      case VelocityConstraintKind::led_cord:
        return led_cord(c);
      case VelocityConstraintKind::point:
      case VelocityConstraintKind::rolling:
        return c.action < 0 ? joined_points(c) : contact(c);
      case VelocityConstraintKind::touching:
        return touching(c);
    }
    return {};
  }

 private:
  Bound joined_points(const Constraint& c) const {
    return {over_time([&](int j) {
              return dot(bodies_.direction(c.along.body, c.along.vector, j),
                         bodies_.point(c.at.body, c.at.point, j) - bodies_.point(c.toward.body, c.toward.point, j));
            }),
            std::nullopt};
  }

  // A straight part of a cord at time j, by its angle to the line of centers.
  struct Straight {
    Vector start, end, along, axis;
    Real length = 0;
    bool lies = true;  // in the plane of the wheels
  };
  Straight straight(const CordSpan<double>& span, int j) const {
    const auto center = [&](const CordEnd<double>& end) { return bodies_.point(end.center.body, end.center.point, j); };
    const Vector A = center(span.from), B = center(span.to), D = B - A;
    Straight part{A, B, normalized(D), bodies_.direction(span.axis.body, span.axis.vector, j), norm(D), true};
    if (span.from.reach == 0 && span.to.reach == 0) return part;
    const Vector& e = part.axis;
    const Real tilt = dot(D, e);
    const Vector across = D - tilt * e, x = normalized(across), y = cross(e, x);
    const Real angle = -std::asin((Real(span.from.reach) - Real(span.to.reach)) / norm(across));
    const Vector n = std::cos(angle) * y - std::sin(angle) * x;
    part.start = A + Real(span.from.reach) * n;
    part.end = B + Real(span.to.reach) * n;
    part.length = norm(part.end - part.start);
    part.along = normalized(part.end - part.start);
    part.lies = std::abs(tilt) <= in_plane * norm(D);
    return part;
  }

  // A cord that slides over its wheels is as long as drawn. Between two wheels on which it does not slip, the material
  // points there come no closer along it.
  Bound led_cord(const Constraint& c) const {
    Bound bound;
    bound.rate = over_time([&](int j) {
      Real rate = 0;
      for (const CordSpan<double>& span : c.spans) {
        const Straight part = straight(span, j);
        rate += dot(part.along, bodies_.velocity_at(span.to.body(), part.end, j) -
                                    bodies_.velocity_at(span.from.body(), part.start, j));
      }
      return rate;
    });
    if (!c.keeps_length) return bound;
    bound.gap = over_time([&](int j) {
      Real length = -Real(c.length);
      std::optional<Vector> before;
      for (const CordSpan<double>& span : c.spans) {
        const Straight part = straight(span, j);
        length += part.length;
        if (!part.lies) return std::numeric_limits<Real>::infinity();
        if (before && span.from.reach != 0) {
          // How far the cord goes round the wheel; where it has left it, it is another cord.
          const Real side = span.from.reach > 0 ? 1 : -1, full = 2 * std::numbers::pi_v<Real>;
          const Real drawn = -side * std::atan2(Real(span.turn_sine), Real(span.turn_cosine)),
                     now = -side * std::atan2(dot(part.axis, cross(*before, part.along)), dot(*before, part.along));
          const Real whole = drawn < 0 ? drawn + full : drawn, change = std::remainder(now - drawn, full);
          if (whole + change < -in_plane) return std::numeric_limits<Real>::infinity();
          length += std::abs(Real(span.from.reach)) * change;
        }
        before = part.along;
      }
      return length;
    });
    return bound;
  }

  // A joint that leaves an axis free keeps that axis of both bodies together: its part along the constraint's direction
  // vanishes, which stands across it. One that leaves none lets the bodies not turn from each other at all.
  Bound turning(std::size_t index) const {
    const Constraint& c = constraints_[index];
    std::vector<Vector3<double>> others;
    for (std::size_t i = 0; i < constraints_.size(); ++i) {
      const Constraint& other = constraints_[i];
      if (i != index && other.kind == c.kind && other.on == c.on && other.from == c.from && other.action == c.action &&
          norm(other.at.point - c.at.point) == 0)
        others.push_back(other.along.vector);
    }
    Bound bound;
    bound.angular = true;
    if (others.size() == 1) {
      const Vector3<double> axis = normalized(cross(c.along.vector, others.front()));
      bound.gap = over_time(
          [&](int j) { return dot(bodies_.direction(c.from, c.along.vector, j), bodies_.direction(c.on, axis, j)); });
    } else if (others.size() == 2) {
      bound.gap = over_time([&](int j) {
        const Matrix3<Real> R = transpose(bodies_.displacement(c.from, j).turn) * bodies_.displacement(c.on, j).turn;
        // By more than a quarter turn the sine would come back to zero.
        if (R(0, 0) + R(1, 1) + R(2, 2) < 1) return Real(1);
        return dot(widened(c.along.vector), axial(R));
      });
    }
    bound.rate = over_time([&](int j) {
      return dot(bodies_.direction(c.from, c.along.vector, j),
                 bodies_.angular_velocity(c.on, j) - bodies_.angular_velocity(c.from, j));
    });
    return bound;
  }

  // Where the bodies touch, at time j.
  Vector contact_point(const Constraint& c, int j) const {
    if (c.carried_by) {
      // In a steady motion the place rests in a frame; where that only turns, beside the mass center of a body. That
      // center is not known here, but at the instant itself it does not matter.
      const Displacement &frame = bodies_.displacement(*c.carried_by, j), &now = bodies_.displacement(*c.carried_by, 0);
      return frame(transpose_times(now.turn, touching_now(c, 0) - now.shift));
    }
    return touching_now(c, j);
  }
  // By the geometry of the surfaces: a circle about an axis touches a plane at its lowest point.
  Vector touching_now(const Constraint& c, int j) const {
    if (c.kind == VelocityConstraintKind::point) return bodies_.point(c.at.body, c.at.point, j);
    const Vector C = bodies_.point(c.on, c.center, j),
                 n = bodies_.direction(c.surface_axis.body, c.surface_axis.vector, j);
    Vector down = n;
    if (norm(c.axis) > 0) {
      const Vector e = bodies_.direction(c.on, c.axis, j);
      down = n - dot(n, e) * e;
    }
    // A disk that lies flat touches all around: any of its points will do, and the drawn one is at hand.
    if (norm(down) < flat) return bodies_.point(c.at.body, c.at.point, j);
    const Real side = dot(C - bodies_.point(c.toward.body, c.toward.point, j), n) > 0 ? -1 : 1;
    return C + (side * Real(c.radius)) * normalized(down);
  }

  // No relative velocity of the two particles that touch, along the constraint's direction; across the surface they
  // keep their places, too.
  Bound contact(const Constraint& c) const {
    Bound bound;
    const auto along = [&](int j) {
      if (!c.carried_by) return bodies_.direction(c.along.body, c.along.vector, j);
      const Vector now = bodies_.direction(c.along.body, c.along.vector, 0);
      return Vector(bodies_.displacement(*c.carried_by, j).turn *
                    transpose_times(bodies_.displacement(*c.carried_by, 0).turn, now));
    };
    bound.rate = over_time([&](int j) {
      const Vector P = contact_point(c, j);
      return dot(along(j), bodies_.velocity_at(c.on, P, j) - bodies_.velocity_at(c.from, P, j));
    });
    if (!c.normal || c.shape_unknown) return bound;
    bound.gap = over_time([&](int j) {
      const Vector n = bodies_.direction(c.along.body, c.along.vector, j);
      return dot(n, touching_now(c, j) - bodies_.point(c.toward.body, c.toward.point, j));
    });
    return bound;
  }

  // Of a cord's part, or a radian: by more it leaves the plane of its wheels, or a wheel. Places have the six digits of
  // a figure.
  static constexpr Real in_plane = 1e-6L;
  ContactSurface<Real> placed(int body, const ContactSurface<double>& s, int j) const {
    return converted_surface<Real>(
        s, [&](const Vector3<double>& p) { return bodies_.point(body, p, j); },
        [&](const Vector3<double>& d) { return bodies_.direction(body, d, j); }, [](double x) { return Real(x); });
  }

  std::pair<ContactSurface<Real>, ContactSurface<Real>> placed_at(const Constraint& c, int j) const {
    return {placed(c.on, c.surfaces->shape_on, j), placed(c.from, c.surfaces->shape_from, j)};
  }
  static drawn::NearestPlace missing(const Vector& x) { return {x, x, std::numeric_limits<Real>::quiet_NaN()}; }
  drawn::NearestPlace nearest_now(const Constraint& c) const {
    const auto [on, from] = placed_at(c, 0);
    const Vector guess = drawn::place_of_solver(placed(c.on, c.surfaces->on, 0), placed(c.from, c.surfaces->from, 0),
                                                c.surfaces->branch);
    return drawn::nearest_place(on, from, guess).value_or(missing(guess));
  }

  // Two shapes by the equations of their surfaces. What does not slip has no relative velocity at all where it touches,
  // so that directions across may stay as they are.
  Bound touching(const Constraint& c) const {
    const drawn::NearestPlace now = nearest_now(c);
    const auto place = [&](int j) {
      if (j == 0) return now;
      const auto [on, from] = placed_at(c, j);
      return drawn::nearest_place(on, from, now.point).value_or(missing(now.point));
    };
    Bound bound;
    bound.rate = over_time([&](int j) {
      const drawn::NearestPlace then = place(j);
      const Vector d = c.normal ? then.normal : bodies_.direction(c.along.body, c.along.vector, j);
      return dot(d, bodies_.velocity_at(c.on, then.point, j) - bodies_.velocity_at(c.from, then.point, j));
    });
    if (c.normal) bound.gap = over_time([&](int j) { return place(j).gap; });
    return bound;
  }

  // Below this sine a circle lies flat on a plane: rounding leaves no more of the sine of zero.
  static constexpr Real flat = 1e-9L;

  const CarriedBodies& bodies_;
  const std::vector<Constraint>& constraints_;
};

Real worse(Real a, Real b) {
  return std::isfinite(b) ? std::max(a, std::abs(b)) : std::numeric_limits<Real>::infinity();
}

}  // namespace

namespace {

// pace: in units of which rates are told. h: the step of the differences.
Real misfit_by_steps(const std::vector<CheckLink>& links, const std::vector<VelocityConstraint<double>>& constraints,
                     const ConstraintClaim& claim, const std::vector<double>& q, const std::vector<double>& v,
                     const std::vector<double>& a, Real pace, Real h) {
  const Real length = claim.length;
  const CarriedBodies bodies(links, q, v, a, h);
  const BoundFinder finder(bodies, constraints);
  Real worst = 0;
  for (std::size_t i = 0; i < constraints.size(); ++i) {
    const Constraint& c = constraints[i];
    const bool lets_go = c.action >= 0 && !claim.lets_go.empty() && claim.lets_go[static_cast<std::size_t>(c.action)];
    const Bound bound = finder.of(i);
    const Real unit = bound.angular ? 1 : length;
    if (bound.gap) worst = worse(worst, (*bound.gap)[reach] / unit);
    if (lets_go || !(pace > 0)) continue;
    // How a place moves on that rests in a frame about a mass center, or on a surface that is not known, is not known.
    const bool accelerations = claim.accelerations && !c.carried_along && !(c.shape_unknown && !c.carried_by);
    // In a steady motion the surfaces may be curved in any way that leaves the place at rest in the frame: then the
    // rates tell, and not the gap of a plane.
    if (bound.gap && !c.carried_by) {
      worst = worse(worst, first_derivative(*bound.gap, bodies.h()) / (unit * pace));
      if (accelerations) worst = worse(worst, second_derivative(*bound.gap, bodies.h()) / (unit * pace * pace));
    }
    if (bound.rate) {
      worst = worse(worst, (*bound.rate)[reach] / (unit * pace));
      if (accelerations) worst = worse(worst, first_derivative(*bound.rate, bodies.h()) / (unit * pace * pace));
    }
  }
  return worst;
}

}  // namespace

double check_constraints(const std::vector<CheckLink>& links,
                         const std::vector<VelocityConstraint<double>>& constraints, const ConstraintClaim& claim,
                         const std::vector<double>& q, const std::vector<double>& v, const std::vector<double>& a) {
  if (constraints.empty()) return 0;
  const Real pace = std::max(drawn::pace_of(links, v, a, claim.length), Real(claim.pace));
  Real h = drawn::step_of_pace / (pace > 0 ? pace : 1);
  Real misfit = misfit_by_steps(links, constraints, claim, q, v, a, pace, h);
  // What goes round on a short cord beside a long one changes faster than the pace of the whole. A rate that does not
  // vanish is the same by smaller steps.
  constexpr Real good = 1e-10L, smaller = 0.1L;
  constexpr int most_refinements = 3;
  for (int k = 0; k < most_refinements && misfit > good; ++k)
    misfit = std::min(misfit, misfit_by_steps(links, constraints, claim, q, v, a, pace, h *= smaller));
  return static_cast<double>(misfit);
}

std::vector<ContactRate> contact_rates(const std::vector<CheckLink>& links, const std::vector<Constraint>& contacts,
                                       const ConstraintClaim& claim, const std::vector<double>& q,
                                       const std::vector<double>& v, const std::vector<double>& a) {
  const Real pace = std::max(drawn::pace_of(links, v, a, claim.length), Real(claim.pace));
  const CarriedBodies bodies(links, q, v, a, drawn::step_of_pace / (pace > 0 ? pace : 1));
  const BoundFinder finder(bodies, contacts);
  std::vector<ContactRate> rates;
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const Bound bound = finder.of(i);
    rates.push_back({static_cast<double>((*bound.rate)[reach]),
                     static_cast<double>(first_derivative(*bound.rate, bodies.h())),
                     contacts[i].normal ? finder.normal(i) : Vector3<double>{}});
  }
  return rates;
}

namespace {

// The velocities of bodies that rest.
std::vector<double> at_rest(const std::vector<CheckLink>& links) {
  std::vector<double> rest;
  for (const CheckLink& link : links)
    rest.resize(std::max(rest.size(), static_cast<std::size_t>(link.velocity + velocity_size(link.type))), 0);
  return rest;
}

}  // namespace

double largest_overlap(const std::vector<CheckLink>& links, const std::vector<VelocityConstraint<double>>& constraints,
                       double length, const std::vector<bool>& acting, const std::vector<double>& q) {
  const std::vector<double> rest = at_rest(links);
  const CarriedBodies bodies(links, q, rest, rest, 1);
  const BoundFinder finder(bodies, constraints);
  Real deepest = 0;
  for (std::size_t i = 0; i < constraints.size(); ++i) {
    const Constraint& c = constraints[i];
    if (c.action < 0 || acting[static_cast<std::size_t>(c.action)]) continue;
    const Bound bound = finder.of(i);
    if (!bound.gap) continue;
    const Real gap = (*bound.gap)[reach];
    deepest = std::max(deepest, (is_cord_length(c) ? gap : -gap) / Real(length));
  }
  return static_cast<double>(deepest);
}

double gap_of(const std::vector<CheckLink>& links, const std::vector<VelocityConstraint<double>>& constraints,
              int action, const std::vector<double>& q) {
  const std::vector<double> rest = at_rest(links);
  const CarriedBodies bodies(links, q, rest, rest, 1);
  const BoundFinder finder(bodies, constraints);
  for (std::size_t i = 0; i < constraints.size(); ++i) {
    const Constraint& c = constraints[i];
    if (c.action != action || !(c.normal || is_cord_length(c))) continue;
    if (const Bound bound = finder.of(i); bound.gap)
      return static_cast<double>(is_cord_length(c) ? -(*bound.gap)[reach] : (*bound.gap)[reach]);
  }
  return 0;
}

}  // namespace poinsot::solve
