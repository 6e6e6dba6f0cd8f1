// One piece of physics, stated in several ways, has one set of answers.
#include <gtest/gtest.h>

#include "case_count.h"
#include "problem/entries/random_problems.h"

namespace poinsot::problem {
namespace equivalence_test {

using namespace testing;

constexpr int trials = poinsot::testing::case_count(1000);

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
    expect_same(problem.text(), problem.text(style), 1e-10, style.R);
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
    expect_same(problem.text(), problem.text(style), 1e-10);
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
    expect_same(whole.text(), split.text(), 1e-10);
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
      welded.asks.push_back("rate(angular_momentum(" + b + " about P))" +
                            (here ? " + rate(angular_momentum(other about P))" : ""));
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
    expect_same(whole.text(), welded.text(), 1e-10);
    if (HasFatalFailure()) return;
  }
}

// Massless bodies that hang between hinges are the gimbals of ordered angles.
TEST(Equivalence, OrderedAnglesAreGimbals) {
  Random random(106);
  for (int trial = 0; trial < trials; ++trial) {
    ProblemData angles = random_problem(random, {.least_bodies = 1, .most_bodies = 1});
    JointData& joint = angles.joints.front();
    joint.kind = "angles";
    joint.from = "ground";
    joint.freedoms.clear();
    const Matrix3<double> turn = random.rotation();
    const char* names[] = {"phi", "theta", "psi"};
    for (std::size_t k = 0; k < 3; ++k) {
      FreedomData f;
      f.name = names[k];
      f.axis = turn.column(k == 2 && random.chance(0.5) ? 0 : k);
      f.position = k == 1 ? random.uniform(0.4, 1.2) : random.uniform(-1, 1);
      f.rate = random.uniform(-2, 2);
      if (random.chance(0.4))
        f.accel = random.uniform(-3, 3);
      else
        f.effort = random.uniform(-4, 4);
      joint.freedoms.push_back(f);
    }
    ProblemData gimbals = angles;
    gimbals.joints.clear();
    const std::string bodies[] = {"ground", "outer", "inner", "b0"};
    for (std::size_t k = 0; k < 3; ++k) {
      JointData hinge;
      hinge.kind = "revolute";
      hinge.name = joint.freedoms[k].name;
      hinge.from = bodies[k];
      hinge.to = bodies[k + 1];
      hinge.at = joint.at;
      hinge.axis = joint.freedoms[k].axis;
      hinge.freedoms = {joint.freedoms[k]};
      gimbals.joints.push_back(hinge);
      if (k < 2) gimbals.bodies.push_back({bodies[k + 1], {}});
    }
    const std::vector<std::string> motion{"angular_velocity(b0)", "angular_acceleration(b0)", "acceleration(b0)",
                                          "angular_momentum(b0 about P)", "rate(angular_momentum(b0 about P))"};
    angles.asks = gimbals.asks = motion;
    for (const char* ask :
         {"force(j0 on b0)", "couple(j0 on b0 about P)", "drive(phi of j0)", "drive(theta of j0)", "drive(psi of j0)"})
      angles.asks.push_back(ask);
    for (const char* ask :
         {"force(psi on b0)", "couple(psi on b0 about P)", "drive(phi)", "drive(theta)", "drive(psi)"})
      gimbals.asks.push_back(ask);
    expect_same(angles.text(), gimbals.text(), 1e-10);
    if (HasFatalFailure()) return;
  }
}

// A loop of a hinged crank, a ball, a universal joint and a hinged rocker, cut at either end of the coupler.
TEST(Equivalence, ALoopCutElsewhere) {
  Random random(107);
  int closed = 0;
  for (int trial = 0; closed < trials && trial < 3 * trials; ++trial) {
    ProblemData loop;
    loop.gravity = random.vector(10);
    loop.points["P"] = random.vector();
    const Vector corners[] = {random.vector(), random.vector() + Vector{0, 2, 0}, random.vector() + Vector{2, 2, 0},
                              random.vector() + Vector{3, 0, 0}};
    for (std::size_t k = 0; k < 3; ++k) {
      BodyData body;
      body.name = fmt::format("b{}", k);
      body.parts = {random_part(random, corners[k]), random_part(random, corners[k + 1])};
      body.parts[0].shape = PartData::Shape::sphere;
      loop.bodies.push_back(body);
    }
    const auto joint = [&](const std::string& name, const std::string& kind, const std::string& from,
                           const std::string& to, std::size_t at) {
      JointData j;
      j.name = name;
      j.kind = kind;
      j.from = from;
      j.to = to;
      j.at = corners[at];
      j.axis = random.direction();
      j.second = normalized(cross(j.axis, random.direction()));
      return j;
    };
    JointData crank = joint("crank", "revolute", "ground", "b0", 0);
    const JointData ball = joint("ball", "ball", "b0", "b1", 1),
                    cross_joint = joint("universal", "universal", "b1", "b2", 2),
                    rocker = joint("rocker", "revolute", "ground", "b2", 3);
    FreedomData turning;
    turning.rate = random.uniform(0.5, 2);
    if (random.chance(0.5))
      turning.accel = random.uniform(-3, 3);
    else
      turning.effort = random.uniform(-3, 3);
    crank.freedoms = {turning};
    loop.joints = {crank, ball, cross_joint, rocker};
    ProblemData other = loop;
    other.joints = {crank, rocker, cross_joint, ball};
    // Facts about the ball are not needed: the loop fixes its motion.
    for (ProblemData* problem : {&loop, &other})
      for (JointData& j : problem->joints)
        if (j.kind == "ball") j.stated = false;
    for (ProblemData* problem : {&loop, &other})
      for (const char* body : {"b0", "b1", "b2"}) {
        const std::string b = body;
        for (const std::string& ask :
             {"angular_momentum(" + b + " about P)", "angular_acceleration(" + b + ")", "acceleration(" + b + ")"})
          problem->asks.push_back(ask);
      }
    for (ProblemData* problem : {&loop, &other})
      for (const auto& [name, body] : {std::pair{"crank", "b0"}, std::pair{"ball", "b1"}, std::pair{"universal", "b2"},
                                       std::pair{"rocker", "b2"}}) {
        problem->asks.push_back(fmt::format("force({} on {})", name, body));
        problem->asks.push_back(fmt::format("couple({} on {} about P)", name, body));
      }
    // Loops near a dead point have no accurate motion; they are left out.
    const Solution first = solved(loop.text());
    double fastest = 0;
    for (const SolvedAsk& ask : first.asks) fastest = std::max(fastest, size_of(ask.value));
    if (fastest > 500) continue;
    expect_same(loop.text(), other.text(), 1e-10);
    if (HasFatalFailure()) return;
    ++closed;
  }
  EXPECT_EQ(closed, trials);
}

// A cord that holds a hinged body is as good as its tension as a load.
TEST(Equivalence, ACordAndItsTension) {
  Random random(108);
  int taut = 0;
  for (int trial = 0; taut < trials && trial < 4 * trials; ++trial) {
    ProblemData held = random_problem(
        random,
        {.least_bodies = 1, .most_bodies = 1, .positions = false, .planar = false, .loads = false, .unusual = false});
    JointData& hinge = held.joints.front();
    hinge.kind = "revolute";
    FreedomData still;
    still.rate = 0;
    hinge.freedoms = {still};
    held.gravity = random.vector(10);
    const Vector end = random.vector(), far = end + random.uniform(0.5, 2) * random.direction();
    if (std::abs(dot(cross(end - hinge.at, normalized(far - end)), normalized(hinge.axis))) < 0.1) continue;
    ProblemData pulled = held;
    held.extra.push_back("cords: {wire: {at: " + Style().place(far) + ", to: b0, end: " + Style().place(end) + "}}");
    held.asks = {"force(j0 on b0)", "couple(j0 on b0 about P)", "angular_acceleration(b0)", "tension(wire)"};
    const Solution first = solved(held.text());
    ASSERT_EQ(first.asks.size(), 4U);
    if (first.asks[3].state == AskState::refused) continue;
    ASSERT_EQ(first.asks[3].state, AskState::found) << first.asks[3].reason << held.text();
    const Value<double>& tension = first.asks[3].value;
    const double size = tension.is_vector() ? norm(tension.vector) : tension.number;
    LoadData load;
    load.body = "b0";
    load.at = end;
    load.vector = size * normalized(far - end);
    pulled.loads.push_back(load);
    pulled.asks = {"force(j0 on b0)", "couple(j0 on b0 about P)", "angular_acceleration(b0)"};
    const Solution second = solved(pulled.text());
    const double force = size_of(first.asks[0].value) + size;
    for (std::size_t i = 0; i < 3; ++i) {
      ASSERT_EQ(second.asks[i].state, AskState::found);
      ASSERT_LE(norm(first.asks[i].value.vector - second.asks[i].value.vector), 1e-9 * force * (i == 2 ? 100 : 1))
          << i << held.text() << pulled.text();
    }
    ++taut;
  }
  EXPECT_EQ(taut, trials);
}

// A body that stands elsewhere than drawn, and one drawn where it stands.
TEST(Equivalence, DrawnWhereItStands) {
  Random random(109);
  for (int trial = 0; trial < trials; ++trial) {
    ProblemData moved = random_problem(random, {.least_bodies = 1, .most_bodies = 1, .loads = false, .unusual = false});
    JointData& joint = moved.joints.front();
    if (joint.kind == "weld") continue;
    Matrix3<double> R = Matrix3<double>::identity();
    Vector shift{};
    for (FreedomData& f : joint.freedoms) {
      f.stiffness = f.damping = 0;
      f.position = random.uniform(-1, 1);
      const Vector u = normalized(joint.axis);
      if (f.turning)
        R = rotation_about(u, f.position);
      else
        shift = f.position * u;
    }
    const auto carried = [&](const Vector& a) { return joint.at + R * (a - joint.at) + shift; };
    ProblemData drawn = moved;
    for (PartData& part : drawn.bodies.front().parts) {
      const bool points = part.shape == PartData::Shape::rod || part.shape == PartData::Shape::triangle;
      part.a = carried(part.a);
      part.b = points ? carried(part.b) : R * part.b;
      part.c = points ? carried(part.c) : R * part.c;
      part.d = R * part.d;
    }
    for (FreedomData& f : drawn.joints.front().freedoms) f.position = 0;
    for (ProblemData* problem : {&moved, &drawn})
      for (const char* ask :
           {"angular_momentum(b0 about P)", "kinetic_energy(b0)", "acceleration(b0)", "angular_acceleration(b0)",
            "rate(angular_momentum(b0 about P))", "force(j0 on b0)", "couple(j0 on b0 about P)", "center(b0)"})
        problem->asks.push_back(ask);
    expect_same(moved.text(), drawn.text(), 1e-10);
    if (HasFatalFailure()) return;
  }
}

// Motion given and force found; then the force given: the same motion comes back.
TEST(Equivalence, MotionGivenForceFoundAndBack) {
  Random random(110);
  for (int trial = 0; trial < trials; ++trial) {
    ProblemData motion = random_problem(random, {.least_bodies = 1, .most_bodies = 4, .planar = false});
    for (JointData& joint : motion.joints)
      for (FreedomData& f : joint.freedoms) {
        f.effort.reset();
        f.stiffness = f.damping = 0;
        f.accel = random.uniform(-3, 3);
      }
    ask_everything(motion);
    // The sense of each drive along its own axis, as it stands.
    ProblemData asked = motion;
    asked.asks.clear();
    std::vector<std::pair<std::size_t, std::size_t>> freedoms;
    for (std::size_t j = 0; j < motion.joints.size(); ++j)
      for (std::size_t k = 0; k < motion.joints[j].freedoms.size(); ++k) {
        const JointData& joint = motion.joints[j];
        const std::string& name = joint.freedoms[k].name;
        asked.asks.push_back("drive(" + (name.empty() ? joint.name : name + " of " + joint.name) + ")");
        freedoms.emplace_back(j, k);
        // Of a universal joint the first axis rides with the holder, the second with the held body.
        const bool second = joint.kind == "universal" && k == 1;
        const std::string body = second ? joint.to : joint.from, A = "A" + joint.name,
                          tip = (second ? "S" : "F") + joint.name;
        asked.points[A] = joint.at;
        asked.points[tip] = joint.at + normalized(second ? joint.second : joint.axis);
        asked.asks.push_back(body == "ground" ? "center(b0)"
                                              : "(" + tip + " of " + body + ") - (" + A + " of " + body + ")");
      }
    if (freedoms.empty()) continue;
    const Solution efforts = solved(asked.text());
    ProblemData force = motion;
    for (std::size_t n = 0; n < freedoms.size(); ++n) {
      const SolvedAsk& drive = efforts.asks[2 * n];
      const JointData& joint = force.joints[freedoms[n].first];
      const bool second = joint.kind == "universal" && freedoms[n].second == 1;
      const Vector axis =
          joint.from == "ground" && !second ? normalized(joint.axis) : efforts.asks[2 * n + 1].value.vector;
      ASSERT_EQ(drive.state, AskState::found) << drive.reason << asked.text();
      FreedomData& f = force.joints[freedoms[n].first].freedoms[freedoms[n].second];
      f.accel.reset();
      f.effort = dot(drive.value.vector, axis);
    }
    expect_same(motion.text(), force.text(), 1e-10);
    if (HasFatalFailure()) return;
  }
}

// The rate of an angular momentum about a fixed point against differences of the angular momentum in solved states.
TEST(Equivalence, RatesAgainstDifferences) {
  Random random(111);
  for (int trial = 0; trial < trials; ++trial) {
    ProblemData now = random_problem(
        random, {.least_bodies = 1, .most_bodies = 3, .planar = false, .loads = false, .unusual = false});
    for (JointData& joint : now.joints)
      for (FreedomData& f : joint.freedoms) {
        f.effort.reset();
        f.stiffness = f.damping = 0;
        f.accel = random.uniform(-3, 3);
      }
    const std::string last = now.bodies.back().name;
    const std::vector<std::string> asks{"angular_momentum(" + last + " about P)", "momentum(" + last + ")",
                                        "velocity(P of " + last + ")", "angular_momentum(system about P)",
                                        "angular_velocity(" + last + ")"};
    ProblemData rates = now;
    for (const std::string& ask : asks) rates.asks.push_back("rate(" + ask + ")");
    now.asks = asks;
    const Solution rate = solved(rates.text());
    std::vector<Vector> difference(asks.size());
    constexpr double h = 2e-3;
    constexpr double weights[] = {3.0 / 4, -3.0 / 20, 1.0 / 60};
    for (int step = -3; step <= 3; ++step) {
      if (step == 0) continue;
      const double t = step * h;
      ProblemData then = now;
      for (JointData& joint : then.joints)
        for (FreedomData& f : joint.freedoms) {
          f.position += *f.rate * t + *f.accel * t * t / 2;
          *f.rate += *f.accel * t;
        }
      const Solution values = solved(then.text());
      const double weight = (step > 0 ? 1 : -1) * weights[std::abs(step) - 1] / h;
      for (std::size_t i = 0; i < asks.size(); ++i) difference[i] += weight * values.asks[i].value.vector;
    }
    for (std::size_t i = 0; i < asks.size(); ++i) {
      ASSERT_EQ(rate.asks[i].state, AskState::found);
      ASSERT_LE(norm(rate.asks[i].value.vector - difference[i]), 1e-9 * (10 + norm(difference[i]))) << asks[i] << "\n"
                                                                                                    << now.text();
    }
  }
}

}  // namespace equivalence_test
}  // namespace poinsot::problem
