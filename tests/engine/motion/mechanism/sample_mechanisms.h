// A few mechanisms as books draw them.
#pragma once

#include <string>
#include <vector>

#include "engine/motion/mechanism/random_mechanisms.h"

namespace poinsot::testing {

// A uniform rod of mass m and length l that turns about the axis z at its end, drawn along x.
inline MassProperties<double> rod(double m, double l) {
  return {m, {l / 2, 0, 0}, SymmetricMatrix3<double>::diagonal(0, m * l * l / 12, m * l * l / 12)};
}
// A thin disk of mass m and radius r across the axis z, its center at c.
inline MassProperties<double> disk(double m, double r, const Vector& c) {
  return {m, c, SymmetricMatrix3<double>::diagonal(m * r * r / 4, m * r * r / 4, m * r * r / 2)};
}

inline Joint<double> about(const Vector& axis) { return Joint<double>::revolute(axis); }

// A four-bar linkage of bars a, b, c on a ground of length d; the crank is drawn at an angle. The loop closes at a
// hinge, so that three of its five constraints are redundant, or at a ball. R turns the figure.
struct FourBar {
  double a = 0.3, b = 0.7, c = 0.6, d = 0.8;
  Matrix3<double> R = Matrix3<double>::identity();
  double crank_angle = 0.8;
  double coupler_mass = 1.5;
  bool hinge = true;

  Mechanism<double> mechanism() const {
    MechanismMaker maker;
    const Vector A = Vector::zero(), B{a * std::cos(crank_angle), a * std::sin(crank_angle), 0}, D{d, 0, 0};
    // The coupler's end C, above the line from B to D.
    const Vector span = D - B;
    const double s = norm(span), along = (b * b - c * c + s * s) / (2 * s);
    const Vector u = span / s, up{-u.y, u.x, 0};
    const Vector C = B + along * u + std::sqrt(std::max(0.0, b * b - along * along)) * up;
    const auto bar = [&](const Vector& from, const Vector& to, double m) {
      const Vector r = R * Vector(to - from);
      const MassProperties<double> mass{m, 0.5 * r, (m / 12) * unit_mass_inertia(r)};
      return m > 0 ? mass : massless<double>();
    };
    const Vector z = R * Vector{0, 0, 1};
    const int crank = maker.add_body(ground, about(z), R * A, bar(A, B, 1));
    const int coupler = maker.add_body(crank, about(z), R * B, bar(B, C, coupler_mass));
    const int rocker = maker.add_body(ground, about(z), R * D, bar(D, C, 2));
    maker.finish_tree(R * Vector{0, -9.81, 0});
    maker.close_loop(rocker, coupler, R * C, hinge ? std::optional<Vector>(z) : std::nullopt);
    return maker.mechanism;
  }
};

struct SampleMechanism {
  std::string name;
  Mechanism<double> mechanism;
  State<double> state;
};

inline std::vector<SampleMechanism> sample_mechanisms() {
  const Vector x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  std::vector<SampleMechanism> list;
  {
    MechanismMaker maker;
    maker.add_body(ground, about(z), Vector::zero(), rod(2, 0.6));
    maker.finish_tree({0, -9.81, 0});
    list.push_back({"pendulum", maker.mechanism, {{0.4}, {1.5}}});
  }
  {
    MechanismMaker maker;
    maker.add_body(ground, Joint<double>::ball(), Vector::zero(), disk(1, 0.1, {0, 0, 0.2}));
    maker.finish_tree({0, 0, -9.81});
    list.push_back({"top", maker.mechanism, {{std::cos(0.2), std::sin(0.2), 0, 0}, {0.2, 0.3, 100}}});
  }
  {
    // Precession, nutation and spin of a disk on massless gimbals.
    MechanismMaker maker;
    const int outer = maker.add_body(ground, about(z), Vector::zero(), massless<double>());
    const int inner = maker.add_body(outer, about(x), Vector::zero(), massless<double>());
    maker.add_body(inner, about(z), Vector::zero(), disk(1, 0.1, {0, 0, 0.2}));
    maker.finish_tree({0, 0, -9.81});
    list.push_back({"gimbals", maker.mechanism, {{0.1, 0.5, 0.3}, {2, 0.1, 100}}});
  }
  {
    // The same driven at given rates of precession and spin, under a load.
    MechanismMaker maker;
    const int outer = maker.add_body(ground, about(z), Vector::zero(), massless<double>());
    const int inner = maker.add_body(outer, about(x), Vector::zero(), massless<double>());
    const int wheel = maker.add_body(inner, about(z), Vector::zero(), disk(1, 0.1, {0, 0, 0.2}));
    maker.finish_tree({0, 0, -9.81});
    maker.mechanism.drives[0].held = maker.mechanism.drives[2].held = true;
    KnownForce<double> force;
    force.action = maker.add_action(ActionKind::load, wheel, ground);
    force.at = {wheel, {0, 0.1, 0.2}};
    force.vector = {1, 2, 3};
    maker.mechanism.forces.push_back(force);
    list.push_back({"driven gimbals", maker.mechanism, {{0.1, 0.5, 0.3}, {2, 0.1, 100}}});
  }
  list.push_back({"four-bar with hinge", FourBar().mechanism(), {{0, 0, 0}, {3, 0, 0}}});
  {
    FourBar four_bar;
    four_bar.hinge = false;
    list.push_back({"four-bar with ball", four_bar.mechanism(), {{0, 0, 0}, {3, 0, 0}}});
  }
  {
    MechanismMaker maker;
    const int wheel = maker.add_body(ground, Joint<double>::free(), {0, 0, 0.1}, disk(1, 0.1, Vector::zero()));
    maker.finish_tree({0, 0, -9.81});
    maker.add_contact(wheel, ground, {0, 0, 0}, z, true, 0.1, y);
    State<double> state = neutral_state(maker.mechanism.tree);
    state.v = {0.1, 0.2, 5, 0, 0, 0};
    list.push_back({"rolling disk", maker.mechanism, state});
  }
  return list;
}

}  // namespace poinsot::testing
