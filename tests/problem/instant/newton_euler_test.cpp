// Whole problem files against Newton's and Euler's equations in redundant coordinates, written independently
// (tests/engine/dynamics/newton_euler_oracle.h), for all kinds of joints.
#include <gtest/gtest.h>

#include "case_count.h"
#include "engine/dynamics/newton_euler_oracle.h"
#include "problem/entries/random_problems.h"

namespace poinsot::problem {
namespace newton_euler_test {

using namespace testing;
using poinsot::testing::OracleBody;
using poinsot::testing::OracleResult;
using poinsot::testing::StatedBody;
using poinsot::testing::StatedTree;
using LinkJoint = poinsot::Joint<double>;

Vector vector_of(const Eigen::Vector3d& a) { return {a.x(), a.y(), a.z()}; }

// The problem as a chain of simple joints, each with its coordinates, and what is known of them.
struct Translation {
  StatedTree tree;
  State<double> state;
  std::vector<CoordinateMode> modes;
  std::vector<double> force, acceleration;
  std::vector<SpatialForce<double>> external;
  std::map<std::string, int> link;  // of each body
  std::vector<Vector> origin;       // of each link as drawn

  explicit Translation(const ProblemData& problem) {
    tree.gravity = problem.gravity;
    for (std::size_t i = 0; i < problem.bodies.size(); ++i) add(problem, problem.joints[i]);
    const std::vector<OracleBody> placed = poinsot::testing::oracle_motion(tree, state);
    external.assign(tree.bodies.size(), SpatialForce<double>::zero());
    for (const LoadData& load : problem.loads) {
      const auto i = static_cast<std::size_t>(link.at(load.body));
      // Both act on ground axes unless they turn along; the point rides with the body.
      const Eigen::Matrix3d R = placed[i].R;
      const Vector on_body =
          load.turns_along ? load.vector : vector_of(R.transpose() * poinsot::testing::eigen(load.vector));
      if (load.couple)
        external[i] += SpatialForce<double>{on_body, Vector::zero()};
      else
        external[i] += SpatialForce<double>{cross(load.at - origin[i], on_body), on_body};
    }
    for (const SpringData& spring : problem.springs) {
      const auto end_of = [&](const std::string& body, const Vector& drawn) {
        struct End {
          int index;
          Eigen::Vector3d place, velocity;
        };
        if (body == "ground") return End{ground, poinsot::testing::eigen(drawn), Eigen::Vector3d::Zero()};
        const int index = link.at(body);
        const OracleBody& b = placed[static_cast<std::size_t>(index)];
        const Eigen::Vector3d r = b.R * poinsot::testing::eigen(drawn - origin[static_cast<std::size_t>(index)]);
        return End{index, b.p + r, b.v + b.w.cross(r)};
      };
      const auto near = end_of(spring.from, spring.at), far = end_of(spring.to, spring.end);
      const Eigen::Vector3d span = near.place - far.place;
      const Eigen::Vector3d u = span.normalized();
      const double pull =
          spring.stiffness * (span.norm() - spring.free_length) + spring.damping * u.dot(near.velocity - far.velocity);
      const auto apply = [&](const auto& end, const Eigen::Vector3d& pulling) {
        if (end.index == ground) return;
        const auto i = static_cast<std::size_t>(end.index);
        const Eigen::Vector3d r = end.place - placed[i].p;
        external[i] += SpatialForce<double>{vector_of(placed[i].R.transpose() * r.cross(pulling)),
                                            vector_of(placed[i].R.transpose() * pulling)};
      };
      apply(far, pull * u);
      apply(near, -pull * u);
    }
  }

  OracleResult solve() const {
    return poinsot::testing::oracle_dynamics(tree, state, modes, force, acceleration, external);
  }

 private:
  void add_link(const LinkJoint& joint, int parent, const Vector& at, const MassProperties<double>& mass,
                const std::vector<double>& q, const std::vector<double>& v) {
    const Vector parent_origin = parent < 0 ? Vector::zero() : origin[static_cast<std::size_t>(parent)];
    MassProperties<double> own = mass;
    if (own.mass > 0) own.center = own.center - at;
    tree.bodies.push_back(
        StatedBody{parent, joint, SpatialTransform<double>::translation(at - parent_origin), own, {}});
    origin.push_back(at);
    state.q.insert(state.q.end(), q.begin(), q.end());
    state.v.insert(state.v.end(), v.begin(), v.end());
    for (std::size_t k = 0; k < v.size(); ++k) {
      modes.push_back(CoordinateMode::free);
      force.push_back(0);
      acceleration.push_back(0);
    }
  }
  void know(const FreedomData& f) {
    if (f.accel) {
      modes.back() = CoordinateMode::prescribed;
      acceleration.back() = *f.accel;
    } else {
      force.back() =
          f.effort.value_or(0) - f.stiffness * (f.position - f.free_position) - f.damping * f.rate.value_or(0);
    }
  }

  void add(const ProblemData& problem, const JointData& joint) {
    int parent = joint.from == "ground" ? ground : link.at(joint.from);
    const MassProperties<double> mass = problem.body(joint.to).properties();
    const auto chain = [&](const std::vector<std::pair<LinkJoint, const FreedomData*>>& joints) {
      for (std::size_t k = 0; k < joints.size(); ++k) {
        const auto& [own, f] = joints[k];
        add_link(own, parent, joint.at, k + 1 == joints.size() ? mass : massless<double>(), {f->position},
                 {f->rate.value_or(0)});
        know(*f);
        parent = static_cast<int>(tree.bodies.size()) - 1;
      }
    };
    const auto simple = [](const FreedomData& f) {
      return f.turning ? LinkJoint::revolute(f.axis) : LinkJoint::prismatic(f.axis);
    };
    if (joint.kind == "weld") {
      add_link(LinkJoint::weld(), parent, joint.at, mass, {}, {});
    } else if (joint.kind == "screw") {
      chain({{LinkJoint::screw(joint.axis, joint.pitch), &joint.freedoms.front()}});
    } else if (joint.kind == "ball" || joint.kind == "free") {
      const bool ball = joint.kind == "ball";
      // On the axes of the body, which stand as drawn in the body or ground that holds it.
      Eigen::Matrix3d R = Eigen::Matrix3d::Identity();
      Eigen::Vector3d w = Eigen::Vector3d::Zero();
      if (parent >= 0) {
        const std::vector<OracleBody> placed = poinsot::testing::oracle_motion(tree, state);
        R = placed[static_cast<std::size_t>(parent)].R;
        w = placed[static_cast<std::size_t>(parent)].w;
      }
      const Vector relative = vector_of(R.transpose() * (poinsot::testing::eigen(joint.w) - w));
      if (ball)
        add_link(LinkJoint::ball(), parent, joint.at, mass, {1, 0, 0, 0}, {relative.x, relative.y, relative.z});
      else
        add_link(LinkJoint::free(), parent, joint.at, mass, {1, 0, 0, 0, 0, 0, 0},
                 {relative.x, relative.y, relative.z, joint.v.x, joint.v.y, joint.v.z});
    } else if (joint.kind == "planar") {
      // Any two directions in the plane do.
      const Vector n = normalized(joint.axis),
                   first = normalized(cross(n, std::abs(n.x) < 0.7 ? Vector{1, 0, 0} : Vector{0, 1, 0}));
      const Vector second = cross(n, first);
      FreedomData slide1, slide2;
      slide1.axis = first;
      slide2.axis = second;
      slide1.turning = slide2.turning = false;
      slide1.rate = dot(joint.v, first);
      slide2.rate = dot(joint.v, second);
      chain({{simple(slide1), &slide1}, {simple(slide2), &slide2}, {simple(joint.freedoms[0]), &joint.freedoms[0]}});
    } else {
      std::vector<std::pair<LinkJoint, const FreedomData*>> joints;
      for (const FreedomData& f : joint.freedoms) joints.push_back({simple(f), &f});
      chain(joints);
    }
    link[joint.to] = static_cast<int>(tree.bodies.size()) - 1;
  }
};

void expect_agreement(const ProblemData& stated, double tolerance) {
  ProblemData problem = stated;
  for (const BodyData& body : problem.bodies) {
    problem.asks.push_back("angular_velocity(" + body.name + ")");
    problem.asks.push_back("velocity(" + body.name + ")");
    problem.asks.push_back("angular_acceleration(" + body.name + ")");
    problem.asks.push_back("acceleration(" + body.name + ")");
    problem.asks.push_back("rate(momentum(" + body.name + "))");
    problem.asks.push_back("rate(angular_momentum(" + body.name + " about P))");
  }
  const std::size_t first_joint = problem.asks.size();
  for (const JointData& joint : problem.joints) {
    if (joint.kind == "free") continue;
    problem.asks.push_back("force(" + joint.name + " on " + joint.to + ")");
    problem.asks.push_back("couple(" + joint.name + " on " + joint.to + " about P)");
  }
  const std::string text = problem.text();
  const Solution solution = solved(text);
  for (const auto& [name, residual] : solution.checks) ASSERT_LT(residual, 1e-9) << name << "\n" << text;
  const Translation translation(problem);
  const OracleResult oracle = translation.solve();
  double motion = 1, forces = 1;
  for (const OracleBody& body : oracle.bodies) {
    motion = std::max({motion, body.alpha.norm(), body.a.norm()});
    forces = std::max({forces, body.f.norm(), body.n.norm()});
  }
  std::size_t next = 0;
  const auto expect = [&](const Eigen::Vector3d& expected, double size) {
    const SolvedAsk& ask = solution.asks[next];
    ASSERT_EQ(ask.state, AskState::found) << problem.asks[next] << ": " << ask.reason << "\n" << text;
    ASSERT_LE(norm(ask.value.vector - vector_of(expected)), tolerance * size) << problem.asks[next] << "\n" << text;
    ++next;
  };
  const Eigen::Vector3d P = poinsot::testing::eigen(problem.points.at("P"));
  for (const BodyData& data : problem.bodies) {
    const auto i = static_cast<std::size_t>(translation.link.at(data.name));
    const OracleBody& body = oracle.bodies[i];
    const MassProperties<double>& mass = translation.tree.bodies[i].mass;
    const Eigen::Vector3d r = body.R * poinsot::testing::eigen(mass.center);
    const Eigen::Vector3d a_G = body.a + body.alpha.cross(r) + body.w.cross(body.w.cross(r));
    const Eigen::Matrix3d I = body.R * poinsot::testing::eigen(mass.inertia_center) * body.R.transpose();
    expect(body.w, motion);
    expect(body.v + body.w.cross(r), motion);
    expect(body.alpha, motion);
    expect(a_G, motion);
    expect(mass.mass * a_G, forces);
    expect(I * body.alpha + body.w.cross(I * body.w) + (body.p + r - P).cross(mass.mass * a_G), forces);
    if (::testing::Test::HasFatalFailure()) return;
  }
  ASSERT_EQ(next, first_joint);
  for (const JointData& joint : problem.joints) {
    if (joint.kind == "free") continue;
    const OracleBody& body = oracle.bodies[static_cast<std::size_t>(translation.link.at(joint.to))];
    expect(body.f, forces);
    expect(body.n + (body.p - P).cross(body.f), forces);
    if (::testing::Test::HasFatalFailure()) return;
  }
}

TEST(NewtonEuler, AllKindsOfJoints) {
  Random random(201);
  for (int trial = 0; trial < poinsot::testing::case_count(1000); ++trial) {
    expect_agreement(random_problem(random, {.least_bodies = 1, .most_bodies = 5}), 1e-10);
    if (HasFatalFailure()) return;
  }
}

// Each kind by itself, so that a fault shows where it is.
class EachKind : public ::testing::TestWithParam<const char*> {};

TEST_P(EachKind, AgreesWithNewtonAndEuler) {
  Random random(202);
  int met = 0;
  for (int trial = 0; trial < 2000 && met < 100; ++trial) {
    const ProblemData problem = random_problem(random, {.least_bodies = 1, .most_bodies = 2});
    if (problem.joints.back().kind != GetParam()) continue;
    ++met;
    expect_agreement(problem, 1e-10);
    if (HasFatalFailure()) return;
  }
  EXPECT_EQ(met, 100);
}
INSTANTIATE_TEST_SUITE_P(NewtonEuler, EachKind,
                         ::testing::Values("revolute", "prismatic", "cylindrical", "universal", "ball", "planar",
                                           "screw", "weld", "free"),
                         [](const auto& kind) { return std::string(kind.param); });

// Loads that turn with the body they act on.
TEST(NewtonEuler, LoadsOnTheAxesOfTheBody) {
  Random random(203);
  for (int trial = 0; trial < 300; ++trial) {
    ProblemData problem = random_problem(random);
    for (LoadData& load : problem.loads) load.turns_along = true;
    expect_agreement(problem, 1e-10);
    if (HasFatalFailure()) return;
  }
}

// A ball with three ordered angles is a chain of three hinges, efforts on each of them included.
TEST(NewtonEuler, OrderedAngles) {
  Random random(204);
  for (int trial = 0; trial < 500; ++trial) {
    ProblemData problem = random_problem(random, {.least_bodies = 1, .most_bodies = 2, .unusual = false});
    JointData& joint = problem.joints.back();
    joint.kind = "angles";
    joint.freedoms.clear();
    const Matrix3<double> turn = random.rotation();
    const char* names[] = {"phi", "theta", "psi"};
    for (std::size_t k = 0; k < 3; ++k) {
      FreedomData f;
      f.name = names[k];
      // The third axis as drawn is another one, or the first again: then the second angle must not be zero.
      f.axis = turn.column(k == 2 && random.chance(0.5) ? 0 : k);
      f.position = k == 1 ? random.uniform(0.4, 1.2) : random.uniform(-1, 1);
      f.rate = random.uniform(-2, 2);
      if (random.chance(0.4))
        f.accel = random.uniform(-3, 3);
      else if (random.chance(0.7))
        f.effort = random.uniform(-4, 4);
      joint.freedoms.push_back(f);
    }
    expect_agreement(problem, 1e-10);
    if (HasFatalFailure()) return;
  }
}

}  // namespace newton_euler_test
}  // namespace poinsot::problem
