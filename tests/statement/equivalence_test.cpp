// One piece of physics, stated in several ways, has one set of answers.
#include <gtest/gtest.h>

#include "statement/random_problems.h"

namespace poinsot::statement {
namespace {

using namespace testing;

constexpr int trials = 1000;

// How an answer to the first text stands to the same answer of the second: vectors turn with the figure.
void expect_same(const std::string& first, const std::string& second, double tolerance,
                 const Matrix3<double>& R = Matrix3<double>::identity()) {
  const Solution a = solved(first), b = solved(second);
  ASSERT_EQ(a.asks.size(), b.asks.size());
  const std::map<std::string, double> sizes = sizes_of(a);
  for (std::size_t i = 0; i < a.asks.size(); ++i) {
    ASSERT_EQ(a.asks[i].state, AskState::found) << i << " " << a.asks[i].reason << "\n" << first;
    ASSERT_EQ(b.asks[i].state, AskState::found) << i << " " << b.asks[i].reason << "\n" << second;
    const Value<double>&x = a.asks[i].value, &y = b.asks[i].value;
    ASSERT_EQ(x.kind, y.kind);
    ASSERT_TRUE(same_kind(x.dimension, y.dimension));
    const double size = sizes.at(to_string(x.dimension));
    const double difference = x.is_vector() ? norm(R * x.vector - y.vector) : std::abs(x.number - y.number);
    ASSERT_LE(difference, tolerance * size) << "answer " << i << "\n" << first << "\n" << second;
  }
  for (const Solution* solution : {&a, &b})
    for (const auto& [name, residual] : solution->checks) ASSERT_LT(residual, 1e-9) << name << "\n" << first;
}

Style in_units(const UnitSystem& units) {
  Style style;
  style.units = units;
  return style;
}

TEST(Equivalence, OtherUnits) {
  Random random(101);
  for (int trial = 0; trial < trials; ++trial) {
    ProblemData problem = random_problem(random);
    ask_everything(problem);
    const UnitSystem& units = unit_systems()[static_cast<std::size_t>(random.integer(1, 4))];
    expect_same(problem.text(), problem.text(in_units(units)), 1e-10);
    if (HasFatalFailure()) return;
  }
}

TEST(Equivalence, TurnedAxesAndShiftedOrigin) {
  Random random(102);
  for (int trial = 0; trial < trials; ++trial) {
    ProblemData problem = random_problem(random);
    ask_everything(problem);
    Style style;
    style.R = random.rotation();
    style.shift = random.vector(5);
    expect_same(problem.text(), problem.text(style), 1e-9, style.R);
    if (HasFatalFailure()) return;
  }
}

TEST(Equivalence, OtherOrder) {
  Random random(103);
  for (int trial = 0; trial < trials; ++trial) {
    ProblemData problem = random_problem(random, {.least_bodies = 2, .most_bodies = 5});
    ask_everything(problem);
    Style style;
    style.order = 1 + static_cast<std::uint64_t>(trial);
    expect_same(problem.text(), problem.text(style), 1e-9);
    if (HasFatalFailure()) return;
  }
}

// Rods halved, spheres left: the parts of one body.
TEST(Equivalence, ABodySplitIntoParts) {
  Random random(104);
  for (int trial = 0; trial < trials; ++trial) {
    ProblemData whole = random_problem(random);
    ask_everything(whole);
    ProblemData split = whole;
    for (BodyData& body : split.bodies) {
      std::vector<PartData> parts;
      for (const PartData& part : body.parts) {
        PartData one = part, two = part;
        const double share = random.uniform(0.2, 0.8);
        one.mass = share * part.mass;
        two.mass = part.mass - one.mass;
        if (part.shape == PartData::Shape::rod) one.b = two.a = part.a + share * (part.b - part.a);
        if (part.shape == PartData::Shape::box) {
          one.b = share * part.b;
          two.b = part.b - one.b;
          one.a = part.a - 0.5 * (1 - share) * part.b;
          two.a = part.a + 0.5 * share * part.b;
        }
        if (part.shape == PartData::Shape::cylinder) {
          const Vector u = normalized(part.b);
          one.length = share * part.length;
          two.length = part.length - one.length;
          one.a = part.a - 0.5 * two.length * u;
          two.a = part.a + 0.5 * one.length * u;
        }
        if (part.shape == PartData::Shape::triangle) one.b = two.a = part.a + share * (part.b - part.a);
        parts.push_back(one);
        parts.push_back(two);
      }
      body.parts = parts;
    }
    expect_same(whole.text(), split.text(), 1e-9);
    if (HasFatalFailure()) return;
  }
}

// The same parts as two bodies with a weld between them; what is asked of one is asked of both together.
TEST(Equivalence, ABodySplitIntoTwoBodiesWithAWeld) {
  Random random(105);
  for (int trial = 0; trial < trials; ++trial) {
    ProblemData whole = random_problem(random);
    ProblemData welded = whole;
    const auto k = static_cast<std::size_t>(random.integer(0, static_cast<int>(whole.bodies.size()) - 1));
    const std::string name = whole.bodies[k].name;
    const BodyData rest{"other", {welded.bodies[k].parts.back()}};
    welded.bodies[k].parts.pop_back();
    welded.bodies.push_back(rest);
    JointData weld;
    weld.name = "seam";
    weld.kind = "weld";
    weld.from = name;
    weld.to = "other";
    weld.at = random.vector();
    welded.joints.push_back(weld);
    whole.points["S"] = welded.points["S"] = random.vector();
    // What the other bodies are hung on may as well be the new one.
    for (JointData& joint : welded.joints)
      if (joint.from == name && joint.to != "other" && random.chance(0.5)) joint.from = "other";
    for (const BodyData& body : whole.bodies) {
      const std::string& b = body.name;
      const bool here = b == name;
      for (const std::string f : {"momentum(", "kinetic_energy("}) {
        whole.asks.push_back(f + b + ")");
        welded.asks.push_back(f + b + ")" + (here ? " + " + f + "other)" : ""));
      }
      whole.asks.push_back("angular_momentum(" + b + " about P)");
      welded.asks.push_back("angular_momentum(" + b + " about P)" + (here ? " + angular_momentum(other about P)" : ""));
      whole.asks.push_back("rate(angular_momentum(" + b + " about P))");
      welded.asks.push_back("rate(angular_momentum(" + b + " about P))" + (here ? " + rate(angular_momentum(other about P))" : ""));
      for (const std::string f : {"angular_acceleration(", "acceleration(S of "}) {
        whole.asks.push_back(f + b + ")");
        welded.asks.push_back(f + (here && random.chance(0.5) ? "other" : b) + ")");
      }
    }
    for (std::size_t j = 0; j < whole.joints.size(); ++j) {
      const JointData& joint = whole.joints[j];
      if (joint.kind == "free") continue;
      for (ProblemData* problem : {&whole, &welded}) {
        problem->asks.push_back("force(" + joint.name + " on " + joint.to + ")");
        problem->asks.push_back("couple(" + joint.name + " on " + joint.to + " about P)");
      }
    }
    expect_same(whole.text(), welded.text(), 1e-9);
    if (HasFatalFailure()) return;
  }
}

}  // namespace
}  // namespace poinsot::statement
