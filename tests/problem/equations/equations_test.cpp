// Equations of motion of problem files: of every example against the accelerations that the motion room finds by
// numbers, and what is refused.
#include "problem/equations/equations.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <random>

#include "poinsot/engine/math/trace/straight_line.h"
#include "poinsot/engine/motion/mechanism/mechanism_dynamics.h"
#include "problem/equations/rough_states.h"
#include "problem/equations/traced_machine.h"
#include "problem/language/tree.h"
#include "problem/plane/planar_statement.h"

namespace poinsot::problem {
namespace equations_test {

template <class Set>
EquationsOptions with(Set set) {
  EquationsOptions options;
  set(options);
  return options;
}

std::string text_of(const std::string& problem, const EquationsOptions& options = {}) {
  Statement statement = read_statement(problem, "x.yaml");
  restrict_to_plane(statement);
  return equations_text(statement, options);
}

const char* const pendulum = R"(letters: {m: kg, L: m}
gravity: [0, 0, -9.81 m/s^2]
points: {O: [0, 0, 0], A: [0, 0, -L]}
bodies: {bar: {rod: [O, A], mass: m}}
joints: {pin: {revolute: y, at: O, to: bar, angle: theta}}
ask: {T: kinetic_energy(bar)}
)";

bool holds(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST(Equations, OfAPendulumAreThoseOfTheBook) {
  const std::string text = text_of(pendulum);
  EXPECT_TRUE(holds(text, "mass matrix")) << text;
  EXPECT_TRUE(holds(text, "m       kg")) << text;
  EXPECT_TRUE(holds(text, "theta'  rad/s")) << text;
  EquationsOptions forward;
  forward.parts = {EquationPart::forward_dynamics};
  forward.sets = {{"m", "2 kg"}, {"L", "3 m"}};
  forward.form = TextForm::python;
  EXPECT_TRUE(holds(text_of(pendulum, forward), "sin(q[0])"));
}

TEST(Equations, ADatumCanStayALetter) {
  std::string problem = pendulum;
  problem.replace(0, problem.find('\n'), "given: {m: 2 kg, L: 3 m}");
  const EquationsOptions in_c = with([](auto& o) { o.form = TextForm::c; });
  EXPECT_FALSE(holds(text_of(problem, in_c), "parameters[0]"));
  EXPECT_TRUE(holds(text_of(problem, with([](auto& o) {
                              o.form = TextForm::c;
                              o.letters = {"L"};
                            })),
                    "parameters[0]  L, m"));
  EXPECT_THROW(text_of(problem, with([](auto& o) { o.letters = {"M"}; })), StatementError);
}

// A crate that slides and tips on its rough edge, by Newton and Euler for three freedoms of its plane.
TEST(Equations, OfWhatSlidesHaveItsFriction) {
  const std::string crate = R"(plane: [x, y]
letters: {m: kg, I: kg*m^2, mu: 1, v: m/s}
points: {A: [0, 0], G: [0.3 m, 0.4 m]}
bodies: {crate: {mass: m, center: G, inertia: {z: I}}}
contacts: {edge: {of: crate, corner: A, normal: y, friction: mu}}
gravity: -y
facts: {velocity(crate): [v, 0], angular_velocity(crate): 0}
ask: {a: acceleration(crate)}
)";
  const std::string text = text_of(crate);
  EXPECT_TRUE(holds(text, "while contact 'edge' slides along x and presses")) << text;
  EXPECT_TRUE(holds(text, "M dv/dt = F + B y")) << text;
  const EquationsOptions forward = with([](auto& o) { o.parts = {EquationPart::forward_dynamics}; });
  EXPECT_FALSE(text_of(crate, forward).empty());
  try {
    text_of(crate, with([](auto& o) { o.parts = {EquationPart::reduced}; }));
    ADD_FAILURE() << "reduced equations of what slides";
  } catch (const NoEquations& error) {
    EXPECT_TRUE(holds(error.what(), "do work"));
  }
  std::string open = crate;
  open.replace(open.find("facts: "), open.find("ask:") - open.find("facts: "),
               "instants: {now: rest}\n"
               "loads: {pull: {force: [m*v/(1 s), 0], at: A, body: crate}}\n");
  try {
    text_of(open);
    ADD_FAILURE() << "equations of several states";
  } catch (const NoEquations& error) {
    EXPECT_TRUE(holds(error.what(), "contact 'edge' carries other forces")) << error.what();
  }
}

// Accelerations by the equations of a statement's first situation, in the state in which it is stated.
std::vector<double> accelerations_at(const std::string& problem, const std::vector<double>& v) {
  Statement statement = read_statement(problem, "x.yaml");
  restrict_to_plane(statement);
  const SituationInStates in = in_stated_states(statement, statement.situations.front(), {});
  TracedMachine traced = traced_machine(in.situation, {}, "u");
  std::vector<double> inputs(traced.state.q.size()), found(v.size());
  for (std::size_t k = 0; k < inputs.size(); ++k) inputs[k] = traced.inputs[k].meaning.ends_with("quaternion w");
  inputs.insert(inputs.end(), v.begin(), v.end());
  inputs.resize(traced.inputs.size(), 0);
  const TraceScope scope(traced.trace);
  const std::vector<Traced> accelerations = solved_accelerations(
      reduced_equations(equations_of_motion(traced.mechanism, traced.state), traced.held, traced.third));
  StraightLine(traced.trace, accelerations).evaluate(inputs, found);
  return found;
}

// A couple of friction Q in a ball joint, and a force F in a planar one, are against the whole of the slip.
TEST(Equations, OfJointsThatSlipInAllWaysTurnTheirFriction) {
  const std::vector<double> w{3, -4, 12};
  const std::vector<double> turns = accelerations_at(
      "given: {m: 2 kg, r: 0.5 m, Q: 0.3 N*m}\npoints: {O: [0, 0, 0]}\n"
      "bodies: {globe: {sphere: {center: O, radius: r}, mass: m}}\njoints: {socket: {ball: O, to: globe, friction: "
      "Q}}\n"
      "gravity: none\nfacts: {angular_velocity(globe): [3 rad/s, -4 rad/s, 12 rad/s]}\nask: {T: "
      "kinetic_energy(globe)}\n",
      w);
  ASSERT_EQ(turns.size(), 3U);
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(turns[k], -0.3 / (0.4 * 2 * 0.25) * w[k] / 13, 1e-12);
  const std::vector<double> slides = accelerations_at(
      "given: {m: 2 kg, r: 0.5 m, F: 5 N}\npoints: {O: [0, 0, 0]}\n"
      "bodies: {puck: {disk: {center: O, normal: z, radius: r}, mass: m}}\n"
      "joints: {table: {planar: z, at: O, to: puck, friction: F}}\ngravity: none\n"
      "facts: {velocity(puck): [3 m/s, 4 m/s, 0], angular_velocity(puck): [0, 0, 1 rad/s]}\nask: {T: "
      "kinetic_energy(puck)}\n",
      {6, 8, 2});
  ASSERT_EQ(slides.size(), 3U);
  std::vector<double> sorted = slides;
  std::ranges::sort(sorted);
  EXPECT_NEAR(sorted[0], -5.0 / 2 * 0.8, 1e-12);
  EXPECT_NEAR(sorted[1], -5.0 / 2 * 0.6, 1e-12);
  EXPECT_NEAR(sorted[2], 0, 1e-12);
}

// Of all letters only some are a body's.
TEST(Equations, LettersMayHaveToFitTogether) {
  const std::string top = R"(letters: {m: kg, c: m, I: kg*m^2, Ip: kg*m^2}
gravity: -Z
axes: [X, Y, Z]
points: {O: [0, 0, 0], G: [0, 0, c]}
bodies: {top: {mass: m, center: G, inertia: {about: O, axis: Z, axial: I, transverse: Ip}}}
joints: {tip: {ball: O, to: top, angles: [phi: Z, theta: Y, psi: Z]}}
ask: {T: kinetic_energy(top)}
)";
  const std::string text = text_of(top);
  EXPECT_TRUE(holds(text, "mass matrix")) << text;
  EXPECT_TRUE(holds(text, "Ip")) << text;

  // Products of inertia and offsets of either sign are small beside the moments.
  const std::string any_body =
      R"(letters: {m: kg, xG: {signed: m}, yG: {signed: m}, I1: kg*m^2, I2: kg*m^2, I3: kg*m^2, P: {signed: kg*m^2}}
points: {O: [0, 0, 0], G: [xG, yG, 0]}
bodies: {body: {mass: m, center: G, inertia: {about: O, x: I1, y: I2, z: I3, xy: P}}}
joints: {tip: {ball: O, to: body}}
ask: {T: kinetic_energy(body)}
)";
  EXPECT_TRUE(holds(text_of(any_body), "mass matrix"));

  std::string flat = top;
  flat.replace(flat.find("axial: I,"), 9, "axial: 3*Ip,");
  try {
    ADD_FAILURE() << text_of(flat);
  } catch (const StatementError& error) {
    EXPECT_TRUE(holds(error.what(), "no rigid body has these moments")) << error.what();
    EXPECT_TRUE(holds(error.what(), "at all values of the letters that were tried")) << error.what();
  }
}

TEST(Equations, RefusesWithAReason) {
  const auto reason = [](const std::string& problem, const EquationsOptions& options = {}) -> std::string {
    try {
      text_of(problem, options);
    } catch (const NoEquations& error) {
      return error.what();
    }
    return "none";
  };
  const std::string fixed = R"(points: {O: [0, 0, 0], A: [1 m, 0, 0]}
bodies: {bar: {rod: [O, A], mass: 1 kg}}
joints: {wall: {weld: O, to: bar}}
ask: {T: mass(bar)}
)";
  EXPECT_EQ(reason(fixed), "nothing in it can move");
  std::string unknown_mass = pendulum;
  unknown_mass.replace(unknown_mass.find("mass: m}"), 8, "mass: any}");
  EXPECT_EQ(reason(unknown_mass), "a mass property is given as `any`: the equations of motion need it");
  EXPECT_THROW(text_of(pendulum, with([](auto& o) { o.situation = "other"; })), StatementError);
  EXPECT_THROW(text_of(pendulum, with([](auto& o) { o.sets = {{"k", "1 kg"}}; })), StatementError);
}

// A value for every name that the formulas keep.
Settings random_settings(const Situation& situation, std::mt19937_64& random) {
  Settings settings;
  const auto number = [&] { return std::uniform_real_distribution<double>(0.6, 1.4)(random); };
  // Products of inertia and offsets are small beside moments of inertia.
  for (const Letter& letter : situation.letters)
    settings[letter.name] =
        Value<double>::of_number(letter.either_sign ? 0.4 * (number() - 1) : number(), letter.unit.dimension);
  for (const Unknown& unknown : situation.find)
    settings[unknown.name] = unknown.vector
                                 ? Value<double>::of_vector({number(), number(), number()}, unknown.unit.dimension)
                                 : Value<double>::of_number(number(), unknown.unit.dimension);
  return settings;
}

double parameter(const Settings& settings, const Situation& situation, const std::string& name) {
  if (name == "time") return 0;
  if (const auto found = settings.find(name); found != settings.end()) return found->second.number;
  for (std::size_t k = 0; k < 3; ++k)
    if (name.ends_with("_" + situation.axes[k]))
      return settings.at(name.substr(0, name.size() - situation.axes[k].size() - 1)).vector[k];
  throw std::logic_error("no value for " + name);
}

// Largest difference of the traced accelerations from those of MechanismDynamics, relative; nothing where the
// statement has no equations or no values.
std::optional<double> difference(const Situation& situation, std::mt19937_64& random) {
  const Settings settings = random_settings(situation, random);
  Machine machine;
  std::optional<TracedMachine> traced;
  try {
    traced.emplace(traced_machine(situation, {}, "u"));
    DataScope<double> data(situation, settings, 0);
    DataScope<TimeJet> timed(situation, settings, time_jet(0.0));
    MachineOptions options;
    options.lenient = true;
    if (!situation.stages.empty()) options.loads = situation.stages.front().loads;
    machine = build_machine(
        situation, data, timed, [](const Dimension&) { return 1.0; }, options);
  } catch (const StatementError&) {
    return std::nullopt;
  } catch (const NoEquations&) {
    return std::nullopt;
  }
  for (auto& c : machine.mechanism.constraints) {
    c.carried_by.reset();
    c.carried_along.reset();
  }
  MechanismDynamics dynamics(machine.mechanism);
  State<double> state{machine.q, std::vector<double>(static_cast<std::size_t>(machine.mechanism.tree.velocity_size()))};
  const auto number = [&](double size) { return std::uniform_real_distribution<double>(-size, size)(random); };
  for (double& v : state.v) v = number(1);
  // Loops and contacts are closed as drawn.
  if (machine.mechanism.constraints.empty()) {
    integrate_position<double>(machine.mechanism.tree, state.q, state.v, 0.7);
    for (double& v : state.v) v = number(1);
  }
  std::vector<double> inputs = state.q, expected(state.v.size()), found(state.v.size());
  inputs.insert(inputs.end(), state.v.begin(), state.v.end());
  for (std::size_t k = 0; k < state.v.size(); ++k) {
    const bool held = dynamics.is_held(static_cast<int>(k));
    EXPECT_EQ(held, traced->held[k]);
    const double acceleration = held ? number(1) : 0;
    if (held) dynamics.set_held_acceleration(static_cast<int>(k), acceleration);
    inputs.push_back(acceleration);
  }
  for (std::size_t i = inputs.size(); i < traced->inputs.size(); ++i)
    inputs.push_back(parameter(settings, situation, traced->inputs[i].name));

  const TraceScope scope(traced->trace);
  EquationsOfMotion<Traced> equations = equations_of_motion(traced->mechanism, traced->state);
  std::vector<Traced> accelerations;
  try {
    accelerations = solved_accelerations(reduced_equations(equations, traced->held, traced->third));
  } catch (const std::domain_error&) {
    return std::nullopt;  // something moves no mass
  }
  StraightLine(traced->trace, accelerations).evaluate(inputs, found);
  dynamics.accelerations(state.q, state.v, expected);
  if (!dynamics.open_coordinates(state.q).empty()) return std::nullopt;
  double apart = 0, size = 1e-3;
  for (std::size_t k = 0; k < found.size(); ++k) {
    // What is not a number must not pass.
    const double d = std::fabs(found[k] - expected[k]);
    apart = d <= apart ? apart : d;
    size = std::max(size, std::fabs(expected[k]));
  }
  return apart / size;
}

TEST(Equations, OfTheExamplesGiveTheAccelerationsOfTheEngine) {
  std::mt19937_64 random(5);
  int compared = 0;
  for (const auto& entry : std::filesystem::directory_iterator(POINSOT_SOURCE_DIR "/examples/textbook")) {
    if (entry.path().extension() != ".yaml") continue;
    const Statement statement = read_statement(read_file(entry.path().string()), entry.path().string());
    for (const Situation& situation : statement.situations) {
      const auto apart = difference(situation, random);
      if (!apart) continue;
      ++compared;
      EXPECT_LT(*apart, 1e-8) << entry.path() << " " << situation.name;
    }
  }
  EXPECT_GT(compared, 60);
}

}  // namespace equations_test
}  // namespace poinsot::problem
