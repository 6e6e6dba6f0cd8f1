// What a worked solution states as a fact is one: points that it calls fixed, and values that are kept.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <string>

#include "poinsot/problem.h"
#include "poinsot/rendering.h"
#include "problem/entries/statement.h"
#include "problem/explanation/held_point.h"
#include "problem/instant/instant.h"

namespace poinsot::problem {
namespace facts_of_explanations_test {

struct Drawn {
  explicit Drawn(const std::string& text)
      : statement(read_statement(text, "drawn.yaml")),
        instant(statement.situations.front(), settings, When{}, OpenChoice{}),
        state(instant.machine().mechanism) {
    state.set_positions(instant.state().q);
  }
  bool held(const std::string& body, const Vector3<double>& place) const {
    return is_held(state, instant.machine().index.at(body), place, instant.scales().length);
  }

  Statement statement;
  Settings settings;
  SolvedInstant instant;
  solve::MechanismState state;
};

std::string explained(const std::string& text) {
  return to_markdown(poinsot::Problem::from_text(text, "explained.yaml").explain());
}
bool says(const std::string& text, const std::string& piece) { return text.find(piece) != std::string::npos; }

// Pendulums of two links at random angles and sizes: of the first link the pivot is held, of the second no point.
TEST(HeldPoint, IsThePivotOfTheFirstLinkAlone) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> angle(-180, 180), decades(-6, 6);
  for (int n = 0; n < 40; ++n) {
    const double L = std::pow(10, decades(random));
    const std::string joint = n % 2 == 0 ? "revolute: z" : "ball: O";
    const Drawn drawn(
        "given: {L: " + fmt::format("{}", L) + " m}\npoints: {O: [0, 0, 0], A: [0, -L, 0], B: [L, -L, 0]}\n" +
        "bodies: {one: {rod: [O, A], mass: 1 kg}, two: {rod: [A, B], mass: 1 kg}}\njoints:\n" +
        "  top: {revolute: z, at: O, to: one, angle: a}\n  elbow: {revolute: z, at: A, from: one, to: two, angle: "
        "b}\n" +
        "gravity: -y\ninstants: {now: {a: " + std::to_string(angle(random)) +
        " deg, b: " + std::to_string(angle(random)) + " deg, a': 0, b': 0}}\nask: {x: acceleration(one)}\n");
    const auto& motion = drawn.state.workspace().motion;
    EXPECT_TRUE(drawn.held("one", {0, 0, 0}));
    EXPECT_TRUE(drawn.held("one", {0, 0, L})) << "on the axis";
    EXPECT_FALSE(drawn.held("one", {L * 1e-3, 0, 0}));
    EXPECT_FALSE(drawn.held("two", motion[static_cast<std::size_t>(drawn.instant.machine().index.at("two") + 1)].p));
    EXPECT_FALSE(drawn.held("two", {0, 0, 0})) << "where the axes of two bodies meet";
  }
}

// The ends of a four-bar's rocker: the loop is closed by a constraint, so no joint of the tree holds the rocker.
TEST(HeldPoint, OfALoopIsWhereItMeetsTheGround) {
  const Drawn drawn(R"(
points: {O: [0, 0, 0], A: [0, 0.2 m, 0], B: [0.5 m, 0.4 m, 0], C: [0.6 m, 0, 0]}
bodies: {crank: {rod: [O, A], mass: 1 kg}, coupler: {rod: [A, B], mass: 1 kg}, rocker: {rod: [B, C], mass: 1 kg}}
joints:
  a: {revolute: z, at: O, to: crank, angle: u}
  b: {revolute: z, at: A, from: crank, to: coupler}
  c: {revolute: z, at: B, from: coupler, to: rocker}
  d: {revolute: z, at: C, from: ground, to: rocker}
gravity: -y
instants: {now: {u: 0, "u'": 0}}
ask: {x: acceleration(rocker)}
)");
  EXPECT_TRUE(drawn.held("rocker", {0.6, 0, 0}));
  EXPECT_FALSE(drawn.held("rocker", {0.5, 0.4, 0}));
  EXPECT_TRUE(drawn.held("crank", {0, 0, 0}));
  EXPECT_FALSE(drawn.held("coupler", {0, 0.2, 0}));
}

// The point of a ball on the road has no velocity, but it does not stay.
TEST(HeldPoint, IsNotThePointOnWhichABallRolls) {
  const Drawn drawn(R"(
points: {O: [0, 0, 0], C: [0, 0.1 m, 0]}
bodies: {ball: {sphere: {center: C, radius: 0.1 m}, mass: 1 kg}}
contacts: {road: {of: ball, at: O, normal: y, no_slip: true}}
gravity: -y
instants: {now: rest}
ask: {x: acceleration(ball)}
)");
  EXPECT_FALSE(drawn.held("ball", {0, 0, 0}));
  EXPECT_FALSE(drawn.held("ball", {0, 0.1, 0}));
}

const std::string ladder = R"(
points: {A: [0, 3 m, 0], B: [4 m, 0, 0]}
bodies: {ladder: {rod: [A, B], mass: 10 kg}}
contacts: {wall: {of: ladder, at: A, normal: x}, floor: {of: ladder, at: B, normal: y}}
gravity: -y
instants: {now: rest}
ask: {N: force(floor on ladder).y}
)";

// From rest all points of a body have no velocity: an end that slides is not therefore fixed.
TEST(Explanation, CallsNoEndFixedThatSlides) {
  const std::string text = explained(ladder);
  EXPECT_TRUE(says(text, "Eqs. 18.1 and 18.23")) << text;
  EXPECT_FALSE(says(text, "fixed point")) << text;
  EXPECT_FALSE(says(text, "parallel axes")) << text;
}

std::string pendulum(double degrees, double damping) {
  return "points: {O: [0, 0, 0], A: [0, -1 m, 0]}\nbodies: {bar: {rod: [O, A], mass: 1 kg}}\njoints: {pin: {revolute: "
         "z, "
         "at: O, to: bar, angle: a, damping: " +
         std::to_string(damping) + " N*m*s/rad}}\ngravity: -y\ninstants: {now: {a: " + std::to_string(degrees) +
         " deg, a': 0}}\nask: {R: 'force(pin on bar).y @ 0 s', w: 'a'' @ 2 s'}\n";
}

TEST(Explanation, CallsThePivotOfAPendulumFixed) {
  EXPECT_TRUE(says(explained(R"(
points: {O: [0, 0, 0], A: [1 m, 0, 0]}
bodies: {bar: {rod: [O, A], mass: 1 kg}}
joints: {pin: {ball: O, to: bar}}
gravity: -y
instants: {now: rest}
ask: {R: force(pin on bar).y}
)"),
                   "fixed point $O$"));
}

// Small swings lose little in joules, but it is all that they have.
TEST(Explanation, TellsAKeptEnergyFromOneThatIsLostSlowly) {
  for (const double degrees : {60.0, 1.0, 0.01}) {
    EXPECT_TRUE(says(explained(pendulum(degrees, 0)), "the sum of kinetic and potential energy keep"));
    EXPECT_FALSE(says(explained(pendulum(degrees, 0.003)), "the sum of kinetic and potential energy"));
  }
}

// Of a nutating top the vertical momentum is kept, that on a horizontal axis is not.
TEST(Explanation, TellsKeptMomentaFromOthers) {
  const std::string text = explained(R"(
points: {A: [0, 0, 0], G: [0, 0, -0.36 m]}
axes: [X, Y, Z]
bodies: {disk: {disk: {center: G, normal: Z, radius: 180 mm}, mass: 2 kg}}
joints: {socket: {ball: A, to: disk, angles: [phi: Z, theta: -Y, psi: G->A]}}
gravity: -Z
instants: {start: {phi: 0, theta: 90 deg, psi: 0, phi': 0, theta': 0, psi': 50 rad/s}}
ask: {least: min(theta)}
)");
  EXPECT_TRUE(says(text, "on the axis $Z$")) << text;
  EXPECT_FALSE(says(text, "on the axis $X$")) << text;
  EXPECT_FALSE(says(text, "on the axis $Y$")) << text;
}

// A rod on a pin that is thrown upward: m (L w)^2/6 - m g L/2 cos(theta) is kept by hand. On two pins one above the
// other, through which a second coordinate comes, what is kept does not tell how far it goes, and nothing is said.
TEST(ExplainedMotion, what_is_kept_tells_how_far_a_coordinate_goes) {
  const std::string text = explained(R"(given: {m: 2 kg, L: 1.5 m, w0: 3 rad/s}
points: {O: [0, 0, 0], P: [0, -L, 0]}
bodies: {rod: {rod: [O, P], mass: m}}
joints: {pin: {revolute: z, at: O, to: rod, angle: theta}}
gravity: -y
instants: {start: {theta: 0, theta': w0}}
ask: {top: max(theta)}
)");
  EXPECT_TRUE(says(text, "Where $\\theta$ is largest its rate vanishes")) << text;
  const double kept = 2 * 1.5 * 1.5 * 9 / 6.0 - 2 * 9.80665 * 0.75;
  EXPECT_TRUE(says(text, fmt::format("\\cos \\theta}}{{2}} = {:.5f}\\ \\mathrm{{J}}", kept))) << text;
  EXPECT_TRUE(says(text, fmt::format("$\\theta = {:.4f}^{{\\circ}}$",
                                     std::acos(-kept / (2 * 9.80665 * 0.75)) * 180 / std::numbers::pi)))
      << text;

  const std::string two = explained(R"(given: {L: 1.5 m}
points: {O: [0, 0, 0], P: [0, -L, 0], Q: [0, -2*L, 0]}
bodies: {upper: {rod: [O, P], mass: 2 kg}, lower: {rod: [P, Q], mass: 1 kg}}
joints:
  pin: {revolute: z, at: O, to: upper, angle: a}
  knee: {revolute: z, at: P, from: upper, to: lower, angle: b}
gravity: -y
instants: {start: {a: 20 deg, a': 0, b: 10 deg, b': 0}}
stages: {all: {lasts: 2 s}}
ask: {top: max(a)}
)");
  EXPECT_TRUE(says(two, "the sum of kinetic and potential energy keeps its value")) << two;
  EXPECT_FALSE(says(two, "its rate vanishes")) << two;
}

// The same rod with letters: from m (L w0)^2/6 - m g L cos(a)/2 of the start, with the angle that is stated there and
// that which is not, is seen how far it goes.
TEST(ExplainedMotion, what_is_kept_has_the_letters_of_the_start) {
  const std::string data =
      "letters: {m: kg, L: m, w0: rad/s}\npoints: {O: [0, 0, 0], P: [0, -L, 0]}\n"
      "bodies: {rod: {rod: [O, P], mass: m}}\njoints: {pin: {revolute: z, at: O, to: rod, angle: q}}\n"
      "gravity: -y\nstages: {all: {lasts: 1 s}}\nask: {top: max(q)}\n";
  const std::string drawn = explained(data + "instants: {start: {q': w0}}\n");
  EXPECT_TRUE(says(drawn, "At the start it is:")) << drawn;
  EXPECT_TRUE(says(drawn, "T + V = \\frac{m L \\left(L w_{0}^{2} - 3 g\\right)}{6}")) << drawn;
  const std::string raised = explained(data + "instants: {start: {q: 60 deg, q': 0}}\n");
  EXPECT_TRUE(says(raised, "T + V = -\\frac{m g L}{4}")) << raised;
  // What is stated in other words than those of the coordinate is not read.
  const std::string other = explained(data + "instants: {start: {angular_velocity(rod): [0, 0, w0]}}\n");
  EXPECT_FALSE(says(other, "At the start")) << other;
}

// A particle that sticks belongs to its body from the blow on: the energy that is worked out is that which is answered.
TEST(Explanation, CountsWhatHasStuck) {
  const std::string text = explained(R"(title: t
letters: {m: kg, M: kg, L: m, v: m/s}
points: {O: [0, 0, 0], A: [0, -L, 0]}
bodies: {rod: {rod: [O, A], mass: M}}
joints: {pin: {revolute: z, at: O, to: rod, angle: q}}
strikes: {bullet: {mass: m, hits: rod, at: A, velocity: [v, 0, 0], stays: true}}
gravity: -y
instants: {before: rest}
ask: {T: kinetic_energy(rod), p: impulse(pin)}
)");
  EXPECT_TRUE(says(text, "`3*m^2*v^2/(2*(M + 3*m))`")) << text;
  EXPECT_TRUE(says(text, "\\sum m v^2 = \\frac{3 m^{2} v^{2}}{2 \\left(M + 3 m\\right)}")) << text;
  EXPECT_TRUE(says(text, "the momenta after have theirs as well"));
}

// What is given as `any` has no value that could be told.
TEST(Explanation, StatesNoInertiaThatIsOpen) {
  const std::string text = explained(R"(title: t
letters: {m: kg, P: {signed: kg*m^2}, I: kg*m^2, n: rad/s, M: N*m, L: m}
points: {A: [0, 0, 0], B: [L, 0, 0]}
bodies: {r: {mass: m, center: [L/2, 0, 0], inertia: {x: I, xy: P, zx: 0, rest: any}}}
joints: {s: {revolute: x, at: A, to: r, rate: n, couple: M, supports: {A: [x, y, z], B: [y, z]}}}
gravity: none
ask: {A: reaction(A)}
)");
  EXPECT_FALSE(says(text, "I_{y}")) << text;
  EXPECT_TRUE(says(text, "only those that are stated are known")) << text;
  EXPECT_TRUE(says(text, "I\\,\\alpha_{s}")) << text;
}

// Letters are drawn until the statement makes sense, as where it was solved.
TEST(Explanation, WorksOutAnUnknownInLettersThatMustFitTogether) {
  const std::string text = explained(R"(title: t
letters: {m: kg, c: m, I: kg*m^2, J: kg*m^2, b: rad, S: rad/s}
find: {P: rad/s}
points: {O: [0, 0, 0], G: '[c*sin(b), 0, c*cos(b)]'}
frames: {figure: {turns: z, rate: P}}
bodies: {top: {mass: m, center: G, inertia: {about: O, axis: O->G, axial: I, transverse: J}}}
joints: {tip: {ball: O, to: top}}
steady: {frame: figure, spins: {top: {about: O->G, rate: S}}}
gravity: -z
ask: {P: P, N: reaction(tip)}
)");
  EXPECT_FALSE(says(text, "The answers follow from the data")) << text;
  EXPECT_TRUE(says(text, "\\Sigma M_{y}")) << text;
}

// How a body turns that is left open: neither an energy nor the velocity of a point is worked out.
TEST(Explanation, TellsNoMotionThatIsLeftOpen) {
  const std::string text = explained(R"(title: t
given: {v: 2 m/s, r: 0.1 m}
points: {G: [0, 0, 0], A: [0, r, 0]}
bodies: {ball: {sphere: {center: G, radius: r}, mass: 1 kg}}
gravity: none
facts: {velocity(ball): [v, 0, 0]}
ask: {T: kinetic_energy(ball), L: momentum(ball), a: velocity(A of ball)}
)");
  EXPECT_TRUE(says(text, "\\mathbf{L} = m")) << text;
  EXPECT_FALSE(says(text, "kinetic energy is")) << text;
  EXPECT_FALSE(says(text, "\\mathbf{v}_{A}")) << text;
  EXPECT_FALSE(says(text, "\\boldsymbol{\\omega} &=")) << text;
}

}  // namespace facts_of_explanations_test
}  // namespace poinsot::problem
