// Impacts within random mechanisms with joints, loops, cords and contacts.
#include <gtest/gtest.h>

#include "case_count.h"
#include "engine/motion/mechanism/random_mechanisms.h"
#include "poinsot/engine/solve/instant/impulse.h"

namespace poinsot::solve {
namespace constrained_impact_test {

using poinsot::testing::accelerations_of;
using poinsot::testing::largest_of;
using poinsot::testing::later;
using poinsot::testing::Random;
using poinsot::testing::random_closed_state;
using poinsot::testing::random_mechanism;

constexpr int cases_per_test = poinsot::testing::case_count(1000);

// A mechanism in which body `on` approaches `from` (or the ground) at a place along a line.
struct Collision {
  Mechanism<double> mechanism;  // with contacts where they are
  State<double> state;
  int on = 0, from = ground;
  Vector3<double> place, push;
  std::optional<MechanismState> before;
  Blow blow;

  Collision(const Collision&) = delete;
  Collision(const Mechanism<double>& drawn, State<double> closed, Random& random)
      : mechanism(drawn), state(std::move(closed)) {
    const int bodies = mechanism.tree.body_count();
    on = random.integer(0, bodies - 1);
    do from = random.integer(-1, bodies - 1);
    while (from == on);
    mechanism.actions.push_back({ActionKind::impact, "stop", "", on, from});
    before.emplace(mechanism);
    before->set_positions(state.q);
    update_contacts(mechanism, *before);
    before->set_velocities(state.v);
    place = motion_of(on).p + random.vector();
    push = random.direction();
    Impact impact{"stop", static_cast<int>(mechanism.actions.size()) - 1, on, from, on_body(on, place), {from, {}}, 0};
    impact.push.vector = on_axes_of(from, push);
    if (approach(*before, impact) > 0) {
      push = -push;
      impact.push.vector = -impact.push.vector;
    }
    blow.impacts.push_back(impact);
  }
  const BodyMotion<double>& motion_of(int body) const {
    return before->workspace().motion[static_cast<std::size_t>(body + 1)];
  }
  Place<double> on_body(int body, const Vector3<double>& point) const {
    if (body == ground) return {ground, point};
    return {body, on_axes_of(body, point - motion_of(body).p)};
  }
  Vector3<double> on_axes_of(int body, const Vector3<double>& direction) const {
    return direction_on_body(mechanism.tree, before->workspace(), body, direction);
  }
  const Impact& impact() const { return blow.impacts.front(); }
  double approach_with(const std::vector<double>& v) const {
    MechanismState placed(mechanism);
    placed.set_positions(state.q);
    placed.set_velocities(v);
    return approach(placed, impact());
  }
};

// The motion through a spring so stiff that it acts for a very short time only, from the first touch until it is
// relaxed again: the limit of an elastic impact. Nothing where no push can part the two.
std::optional<std::vector<double>> after_stiff_spring(const Collision& collision) {
  constexpr double duration = 1e-5, length = 1;
  constexpr int steps = 64;
  // How fast a unit force parts them.
  Mechanism<double> pushed = collision.mechanism;
  pushed.actions.push_back({ActionKind::load, "probe", "", collision.on, collision.from});
  pushed.forces.push_back({static_cast<int>(pushed.actions.size()) - 1, false, collision.impact().at, {}, ground});
  MechanismDynamics probe(pushed);
  probe.set_force(pushed.forces.size() - 1, Vector3<double>::zero());
  std::vector<double> parting = accelerations_of(probe, collision.state);
  probe.set_force(pushed.forces.size() - 1, collision.push);
  const std::vector<double> with = accelerations_of(probe, collision.state);
  for (std::size_t k = 0; k < parting.size(); ++k) parting[k] = with[k] - parting[k];
  const double mobility = collision.approach_with(parting);
  if (mobility < 1e-2) return std::nullopt;

  Mechanism<double> sprung = collision.mechanism;
  sprung.actions.push_back({ActionKind::spring, "stiff", "", collision.on, collision.from});
  SpringLaw<double> spring;
  spring.action = static_cast<int>(sprung.actions.size()) - 1;
  spring.at = collision.impact().at;
  spring.toward = collision.on_body(collision.from, collision.place - length * collision.push);
  spring.free_length = length;
  spring.stiffness = std::pow(3.141592653589793 / duration, 2) / mobility;
  sprung.springs.push_back(spring);
  MechanismDynamics dynamics(sprung);
  MechanismState placed(sprung);
  const auto gap = [&](const State<double>& state) {
    placed.set_positions(state.q);
    return norm(placed.position(spring.at) - placed.position(spring.toward)) - length;
  };
  // By the midpoint rule.
  const auto stepped = [&](const State<double>& state, double h) {
    const State<double> middle = later(dynamics, state, accelerations_of(dynamics, state), h / 2);
    return later(dynamics, state, accelerations_of(dynamics, middle), h);
  };
  State<double> state = collision.state;
  for (int i = 0; i < 3 * steps; ++i) {
    const State<double> next = stepped(state, duration / steps);
    const double here = gap(state), there = gap(next);
    if (there >= 0) return stepped(state, duration / steps * here / (here - there)).v;
    state = next;
  }
  return std::nullopt;
}

struct Counts {
  int cases = 0, constrained = 0, free_of_ground = 0;
};

void compare(const Collision& collision, double restitution, Counts& counts) {
  const Mechanism<double>& mechanism = collision.mechanism;
  const Model<double>& tree = mechanism.tree;
  const auto n = static_cast<std::size_t>(tree.velocity_size());
  MechanismDynamics dynamics(mechanism);
  if (!dynamics.open_coordinates(collision.state.q).empty()) return;
  const double toward = -collision.approach_with(collision.state.v);
  if (toward < 0.1) return;
  const auto stiff = after_stiff_spring(collision);
  if (!stiff) return;

  Blow blow = collision.blow;
  blow.impacts.front().restitution = restitution;
  const LinearSolution solution = solve_impulse(*collision.before, natural_scales(mechanism), blow, {},
                                                std::vector<bool>(mechanism.actions.size(), true));
  ASSERT_TRUE(solution.conflict.empty());
  if (solution.condition > 1e7) return;
  for (std::size_t k = 0; k < n; ++k) ASSERT_TRUE(solution.determined(k));
  const std::vector<double> v(solution.value.begin(), solution.value.begin() + static_cast<std::ptrdiff_t>(n));
  ++counts.cases;
  counts.constrained += !mechanism.constraints.empty();

  // The impulse grows in proportion to 1 + e.
  double size = 1;
  for (std::size_t k = 0; k < n; ++k) size = std::max({size, std::abs(v[k]), std::abs(collision.state.v[k])});
  for (std::size_t k = 0; k < n; ++k)
    EXPECT_NEAR(v[k], collision.state.v[k] + 0.5 * (1 + restitution) * ((*stiff)[k] - collision.state.v[k]),
                2e-3 * size)
        << "coordinate " << k;
  EXPECT_NEAR(collision.approach_with(v), restitution * toward, 1e-9 * size);
  EXPECT_LT(dynamics.largest_rate(collision.state.q, v), 1e-8 * size);

  // An impact pushes; energy is lost as Carnot has it.
  const double J = solution.value.back();
  EXPECT_GE(J, 0);
  const double T0 = dynamics.kinetic_energy(collision.state.q, collision.state.v),
               T1 = dynamics.kinetic_energy(collision.state.q, v);
  EXPECT_LE(T1, T0 * (1 + 1e-12));
  EXPECT_NEAR(T0 - T1, 0.5 * J * toward * (1 - restitution), 1e-8 * (1 + T0));

  // The momenta of the system change by the impulses from outside alone.
  SpatialForce<double> outside = SpatialForce<double>::zero();
  bool touched = false;
  double impulses = 1;
  for (std::size_t i = 0; i < mechanism.actions.size(); ++i) {
    const Action& action = mechanism.actions[i];
    const SpatialForce<double> wrench = action_impulse(*collision.before, blow, solution.value, i);
    impulses = std::max({impulses, norm(wrench.force), norm(wrench.moment)});
    const bool exerts = norm(wrench.force) + norm(wrench.moment) > 0;
    if (action.from == ground) outside += wrench;
    if (action.on == ground) outside += -1.0 * wrench;
    touched = touched || (exerts && (action.from == ground || action.on == ground));
  }
  const auto p0 = dynamics.momentum(collision.state.q, collision.state.v, Vector3<double>::zero()),
             p1 = dynamics.momentum(collision.state.q, v, Vector3<double>::zero());
  EXPECT_LT(norm(p1.linear - p0.linear - outside.force), 1e-8 * impulses);
  EXPECT_LT(norm(p1.angular - p0.angular - outside.moment), 1e-8 * impulses);
  counts.free_of_ground += !touched;
}

TEST(ConstrainedImpact, AgreesWithAStiffShortForceAndConservesWhatItMust) {
  Random random(61);
  Counts counts;
  for (int i = 0; counts.cases < cases_per_test && i < 5 * cases_per_test && !::testing::Test::HasFailure(); ++i) {
    SCOPED_TRACE("mechanism " + std::to_string(i));
    MechanismDynamics dynamics(random_mechanism(random, {.massless_links = false, .held = false}));
    auto state = random_closed_state(random, dynamics, 0.5);
    const double restitution = random.chance(0.2) ? 0 : random.uniform(0, 1);
    if (!state) continue;
    const Collision collision(dynamics.mechanism(), std::move(*state), random);
    compare(collision, restitution, counts);
  }
  EXPECT_EQ(counts.cases, cases_per_test);
  EXPECT_GT(counts.constrained, cases_per_test / 4);
  EXPECT_GT(counts.free_of_ground, cases_per_test / 200);
}

}  // namespace constrained_impact_test
}  // namespace poinsot::solve
