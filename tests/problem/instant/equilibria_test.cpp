// Angles at which what is hinged to a turning arm stays at rest relative to it: all of them, and no others.
#include <gtest/gtest.h>

#include "problem/entries/random_problems.h"

namespace poinsot::problem {
namespace equilibria_test {

using namespace testing;

// Rodrigues' formula.
Vector turned(const Vector& a, const Vector& axis, double angle) {
  return std::cos(angle) * a + std::sin(angle) * cross(axis, a) + (1 - std::cos(angle)) * dot(axis, a) * axis;
}

struct Load {
  double mass;
  Vector place;
};

// Rods, plates and particles on a hinge of an arm that turns about the vertical y through the origin, with springs.
class Hinged {
 public:
  explicit Hinged(Random& random) {
    A_ = {random.uniform(0, 0.6), random.uniform(-0.3, 0.3), 0};
    // Most hinges are level, as in a clevis.
    n_ = random.chance(0.6) ? Vector{0, 0, 1} : random.direction();
    w_ = random.uniform(1, 15);
    for (int i = random.integer(1, 3); i > 0; --i) add_part(random);
    if (random.chance(0.5)) {
      torsion_ = random.uniform(0.2, 10);
      free_angle_ = random.uniform(-1, 1);
    }
    if (random.chance(0.5)) {
      stiffness_ = random.uniform(1, 60);
      free_length_ = random.uniform(0, 0.6);
      Q_ = A_ + random.vector(0.8);
      E_ = A_ + random.vector(0.8);
    }
    lower_ = random.uniform(-3, -0.3);
    upper_ = random.uniform(0.3, 3);
  }

  // The moment about the hinge, seen from the arm: weights, centrifugal forces and springs.
  double moment(double b) const {
    double sum = -torsion_ * (b - free_angle_);
    for (const Load& load : particles_) {
      const Vector r = A_ + turned(load.place - A_, n_, b);
      const Vector force = load.mass * Vector{w_ * w_ * r.x, -g, w_ * w_ * r.z};
      sum += dot(n_, cross(r - A_, force));
    }
    if (stiffness_ > 0) {
      const Vector r = A_ + turned(E_ - A_, n_, b), span = Q_ - r;
      sum += dot(n_, cross(r - A_, stiffness_ * (1 - free_length_ / norm(span)) * span));
    }
    return sum;
  }

  // Roots by changes of sign over a dense scan; nothing where two roots, or one and an end, are too close to tell.
  std::optional<std::vector<double>> scanned() const {
    constexpr int count = 10000;
    const double step = (upper_ - lower_) / count;
    std::vector<double> f, roots;
    double size = 0;
    for (int i = 0; i <= count; ++i) {
      f.push_back(moment(lower_ + i * step));
      size = std::max(size, std::abs(f.back()));
    }
    if (std::abs(f.front()) < 1e-6 * size || std::abs(f.back()) < 1e-6 * size) return std::nullopt;
    for (std::size_t i = 0; i < count; ++i) {
      // A minimum of |f| that hardly misses zero or hardly passes it.
      if (i > 0 && std::abs(f[i]) <= std::abs(f[i - 1]) && std::abs(f[i]) <= std::abs(f[i + 1]) &&
          f[i - 1] * f[i + 1] > 0 && std::abs(f[i]) < 1e-5 * size)
        return std::nullopt;
      if (f[i] * f[i + 1] > 0) continue;
      double low = lower_ + static_cast<double>(i) * step, high = low + step;
      for (int halving = 0; halving < 60; ++halving) {
        const double middle = (low + high) / 2;
        (moment(low) * moment(middle) <= 0 ? high : low) = middle;
      }
      roots.push_back((low + high) / 2);
    }
    for (std::size_t i = 1; i < roots.size(); ++i)
      if (roots[i] - roots[i - 1] < 1e-3) return std::nullopt;
    return roots;
  }

  std::string text() const {
    const Style style;
    const UnitSystem& u = style.units;
    std::string parts;
    for (std::size_t i = 0; i < parts_.size(); ++i)
      parts += fmt::format("{}p{}: {{{}}}", i == 0 ? "" : ", ", i, parts_[i]);
    std::string all = "title: on a turning arm\ngravity: [0, " + style.number(-g, u.acceleration()) +
                      ", 0]\nbodies:\n  arm: massless\n  part: {parts: {" + parts + "}}\njoints:\n" +
                      "  shaft: {revolute: y, at: [0, 0, 0], to: arm, rate: " + style.number(w_, u.rate()) +
                      ", accel: 0}\n  hinge: {revolute: " + style.plain(n_) + ", at: " + style.place(A_) +
                      ", from: arm, to: part, angle: b";
    if (torsion_ > 0)
      all += ", spring: {stiffness: " + style.number(torsion_, u.turning_stiffness()) +
             ", free_angle: " + style.number(free_angle_, u.angle) + "}";
    all += "}\n";
    if (stiffness_ > 0)
      all += "springs: {coil: {from: arm, at: " + style.place(Q_) + ", to: part, end: " + style.place(E_) +
             ", stiffness: " + style.number(stiffness_, u.stiffness()) +
             ", free_length: " + style.number(free_length_, u.length) + "}}\n";
    return all + "find: {b: deg}\nwhere: [" + style.number(lower_, u.angle) + " < b < " +
           style.number(upper_, u.angle) + "]\nsteady: {frame: arm}\nask: {b: b}\n";
  }

 private:
  // With particles that have the same moments of first and second order: two on a rod, four on a rectangle.
  void add_part(Random& random) {
    const Style style;
    const UnitSystem& u = style.units;
    const double mass = random.uniform(0.2, 3), near = 0.5 / std::sqrt(3.0);
    const Vector center = A_ + random.vector(0.5);
    const std::string amount = ", mass: " + style.number(mass, u.mass);
    const Matrix3<double> turn = random.rotation();
    const Vector a = random.uniform(0.1, 1) * turn.column(0), b = random.uniform(0.1, 1) * turn.column(1);
    switch (random.integer(0, 2)) {
      case 0:
        parts_.push_back("particle: " + style.place(center) + amount);
        particles_.push_back({mass, center});
        break;
      case 1:
        parts_.push_back("rod: [" + style.place(center - 0.5 * a) + ", " + style.place(center + 0.5 * a) + "]" +
                         amount);
        for (const double s : {-near, near}) particles_.push_back({mass / 2, center + s * a});
        break;
      default:
        parts_.push_back("rectangle: {center: " + style.place(center) + ", sides: [" + style.vector(a, u.length) +
                         ", " + style.vector(b, u.length) + "]}" + amount);
        for (const double s : {-near, near})
          for (const double t : {-near, near}) particles_.push_back({mass / 4, center + s * a + t * b});
    }
  }

  static constexpr double g = 9.81;
  std::vector<Load> particles_;
  std::vector<std::string> parts_;
  Vector A_{}, n_{}, Q_{}, E_{};
  double w_ = 0, torsion_ = 0, free_angle_ = 0, stiffness_ = 0, free_length_ = 0, lower_ = 0, upper_ = 0;
};

TEST(Equilibria, AllAnglesOfAHingeOnATurningArm) {
  Random random(431);
  std::map<std::size_t, int> counts;
  int done = 0, failures = 0;
  while (done < 1000) {
    const Hinged hinged(random);
    const auto expected = hinged.scanned();
    if (!expected) continue;
    ++done;
    ++counts[expected->size()];
    const SolvedStatement solved = solve_statement(read_statement(hinged.text(), "test.yaml"), {});
    std::string found;
    bool same = solved.solutions.size() == expected->size();
    for (std::size_t i = 0; i < solved.solutions.size(); ++i) {
      const SolvedAsk& ask = solved.solutions[i].asks.front();
      found += ask.state == AskState::found ? fmt::format(" {:.10g}", ask.value.number) : " (" + ask.reason + ")";
      same = same && ask.state == AskState::found && std::abs(ask.value.number - (*expected)[i]) < 1e-8;
    }
    if (same || ++failures > 3) continue;
    std::string wanted;
    for (double root : *expected) wanted += fmt::format(" {:.10g}", root);
    ADD_FAILURE() << "found" << found << "\nexpected" << wanted << "\n" << hinged.text();
  }
  EXPECT_EQ(failures, 0);
  // The cases are worth something: none, one and several angles all occur.
  for (std::size_t roots = 0; roots <= 4; ++roots) EXPECT_GT(counts[roots], 3) << roots;
}

}  // namespace equilibria_test
}  // namespace poinsot::problem
