// Machines over dual numbers against differences of machines over doubles: how masses, actions, poses, equations and
// their solutions vary with any number of a statement.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <regex>

#include "case_count.h"
#include "docs/fenced_blocks.h"
#include "example_files.h"
#include "poinsot/engine/math/algebra/plain.h"
#include "poinsot/engine/solve/instant/closure.h"
#include "poinsot/engine/solve/instant/impulse.h"
#include "problem/entries/random_problems.h"
#include "problem/language/scalar_value.h"
#include "problem/machine/machine.h"

namespace poinsot::problem {
namespace varied_machine_test {

using namespace testing;

// One number of a problem that varies: a datum or unknown, or one component of it.
struct Varied {
  std::string name;
  std::size_t component = 0;
};

// All numbers that a machine leads to, in an order of their own.
template <class Scalar>
struct Numbers {
  std::vector<Scalar> list;
  std::vector<std::string> origin;  // in words
  std::string now;
  std::map<std::string, double> terms;  // sizes of what the numbers of an origin were made from
  double closed_to = 0;

  void add(const Scalar& x) {
    list.push_back(x);
    origin.push_back(now);
  }
  void add(const Vector3<Scalar>& a) {
    for (std::size_t k = 0; k < 3; ++k) add(a[k]);
  }
  void add(const Matrix3<Scalar>& a) {
    for (std::size_t k = 0; k < 3; ++k) add(a.row(k));
  }
  void add(const SymmetricMatrix3<Scalar>& a) {
    for (const Scalar& x : {a.xx, a.yy, a.zz, a.xy, a.yz, a.zx}) add(x);
  }
  void add(const SpatialForce<Scalar>& a) {
    add(a.moment);
    add(a.force);
  }
  void add(const std::vector<Scalar>& items) {
    for (const Scalar& x : items) add(x);
  }
  void add(const solve::LinearSystemOf<Scalar>& system) {
    for (const std::vector<Scalar>& row : system.coefficients()) add(row);
    add(system.right_sides());
  }
};

// A system solved, with how the solution varies.
template <class Scalar>
struct Solved {
  std::vector<Scalar> value, misfit;
  bool fixed = false;
  double size = 0;
};
Solved<double> solved(const solve::LinearSystem& system) {
  const solve::LinearSolution solution = system.solve();
  return {solution.value, solution.misfit, solution.open.empty(), solution.size};
}
Solved<Dual<1>> solved(const solve::LinearSystemOf<Dual<1>>& system) {
  const solve::LinearFactors factors(system);
  const solve::LinearSolution& solution = factors.solution();
  const solve::LinearDerivative derivative = factors.derivative(system);
  Solved<Dual<1>> varied{{}, {}, solution.open.empty(), solution.size};
  for (std::size_t k = 0; k < solution.value.size(); ++k)
    varied.value.push_back({solution.value[k], {derivative.value[k]}});
  for (std::size_t k = 0; k < solution.misfit.size(); ++k)
    varied.misfit.push_back({solution.misfit[k], {derivative.misfit[k]}});
  return varied;
}

std::vector<double> closed(const MachineOf<double>& machine, double& gap) {
  const solve::Closure closure = solve::close_pose(machine.mechanism, machine.q, machine.position_given);
  gap = closure.gap;
  return closure.q;
}
std::vector<Dual<1>> closed(const MachineOf<Dual<1>>& machine, const std::vector<double>& q) {
  return solve::varied_pose(machine.mechanism, q, machine.q, machine.position_given);
}

class Subject {
 public:
  Subject(const Situation& situation, Settings settings, const Varied& varied)
      : situation_(situation), settings_(std::move(settings)), varied_(varied) {
    Value<double>& value = settings_[varied.name];
    base_ = value.is_vector() ? value.vector[varied.component] : value.number;
    const Numbers<double> first = at(0);
    q_ = q_now_;
    gap_ = first.closed_to;
  }

  double gap() const { return gap_; }

  Numbers<double> at(double change) {
    Settings settings = settings_;
    Value<double>& value = settings[varied_.name];
    (value.is_vector() ? value.vector[varied_.component] : value.number) = base_ + change;
    DataScope<double> data(situation_, settings, time);
    DataScope<TimeJet> timed(situation_, settings, time_jet(time));
    Machine machine = build_machine(situation_, data, timed, any, options());
    double gap = 0;
    machine.q = closed(machine, gap);
    q_now_ = machine.q;
    if (!prepared_) scales_ = solve::natural_scales(machine.mechanism);
    Numbers<double> numbers = numbers_of(machine);
    prepared_ = true;
    numbers.closed_to = gap;
    return numbers;
  }
  Numbers<Dual<1>> varied() {
    DataScope<Dual<1>> data(situation_, settings_, Dual<1>(time));
    DataScope<TimeJetOf<Dual<1>>> timed(situation_, settings_, time_jet(Dual<1>(time)));
    const Value<Dual<1>> variable = as_variable(settings_.at(varied_.name), varied_.component);
    data.vary(varied_.name, variable);
    timed.vary(varied_.name, lifted<TimeJetOf<Dual<1>>>(variable));
    MachineOf<Dual<1>> machine = build_machine(situation_, data, timed, any, options());
    machine.q = closed(machine, q_);
    return numbers_of(machine);
  }
  double base() const { return base_; }

 private:
  static constexpr double time = 0.3;
  static double any(const Dimension&) { return 1; }
  static MachineOptions options() {
    MachineOptions options;
    options.lenient = true;
    options.time = time;
    options.open_gravity = {1, -2, 3};
    return options;
  }

  template <class Scalar>
  Numbers<Scalar> numbers_of(MachineOf<Scalar>& machine) {
    Mechanism<Scalar>& mechanism = machine.mechanism;
    const Model<Scalar>& tree = mechanism.tree;
    Numbers<Scalar> numbers;
    const auto about = [&](const std::string& words) { numbers.now = words; };
    about("gravity");
    numbers.add(tree.gravity());
    for (int i = 0; i < tree.body_count(); ++i) {
      about("body " + tree.name(i));
      // On the body's axes: the working axes may turn over at once.
      const Matrix3<Scalar> R_BW = transpose(tree.body(i).R_WB);
      numbers.add(R_BW * tree.body(i).inertia.first_moment);
      numbers.add(turned(R_BW, tree.body(i).inertia.inertia));
      numbers.add(tree.body(i).inertia.mass);
      numbers.add(tree.body(i).pitch);
    }
    for (const auto& [index, mass] : machine.masses) {
      about("mass of " + tree.name(index));
      numbers.add(mass.properties.mass);
      numbers.add(mass.properties.center);
      numbers.add(mass.properties.inertia_center);
    }
    about("pose");
    numbers.add(machine.q);
    solve::MechanismStateOf<Scalar> placed(mechanism);
    placed.set_positions(machine.q);
    solve::update_contacts(mechanism, placed);

    for (int i = 0; i < tree.body_count(); ++i) {
      about("pose of " + tree.name(i));
      numbers.add(body_rotation(tree, placed.workspace(), i));
      numbers.add(point_position(tree, placed.workspace(), i, Vector3<Scalar>::zero()));
    }

    about("velocities");
    std::vector<solve::ConditionOf<Scalar>> rates, accelerations;
    const auto state = [&](auto& conditions, const auto& list, std::size_t size) {
      for (const StatedRateOf<Scalar>& rate : list) {
        solve::ConditionOf<Scalar> condition{rate.words, std::vector<Scalar>(size, Scalar(0)), rate.value, 1};
        condition.coefficients[static_cast<std::size_t>(rate.velocity)] = Scalar(1);
        conditions.push_back(std::move(condition));
      }
    };
    const auto n = static_cast<std::size_t>(tree.velocity_size());
    state(rates, machine.rates, n);
    state(accelerations, machine.accelerations, solve::force_unknowns(mechanism).size());
    const auto velocity_equations = solve::velocity_equations(placed, scales_, rates);
    numbers.add(velocity_equations);
    const Solved<Scalar> velocities = solved(velocity_equations);
    add_misfit(numbers, "misfit of velocities", velocities);
    about("solved velocities");
    std::vector<Scalar> v = velocities.value;
    if (!velocities.fixed)
      for (std::size_t k = 0; k < n; ++k) v[k] = Scalar(0.3 + 0.2 * static_cast<double>(k % 5));
    numbers.add(v);
    placed.set_velocities(v);

    for (const Component<Scalar>& component : mechanism.components) {
      about("component of " + mechanism.actions[static_cast<std::size_t>(component.action)].name);
      numbers.add(placed.component_wrench(component));
    }
    for (const Drive<Scalar>& drive : mechanism.drives) {
      about("drive");
      numbers.add(placed.drive_wrench(drive));
      numbers.add(drive.known_effort(placed.state()));
    }
    about("loads and springs");
    for (const auto& known : placed.known_forces()) numbers.add(wrench_of(known.force));
    for (const VelocityConstraint<Scalar>& constraint : mechanism.constraints) {
      about("constraint " + constraint.words);
      const solve::ConstraintRow<Scalar> row = solve::constraint_row(placed, constraint);
      numbers.add(row.coefficients);
      numbers.add(row.bias);
    }

    for (const RoughContactOf<Scalar>& contact : machine.rough_contacts) {
      about("friction of " + contact.name);
      for (const Scalar& x : {contact.resting, contact.sliding, contact.friction_at_rest, contact.friction_in_slip})
        numbers.add(x);
      for (const PressingPart<Scalar>& part : contact.pressing) numbers.add(part.lever);
    }

    about("motion");
    const auto motion_equations = solve::motion_equations(placed, scales_, accelerations);
    numbers.add(motion_equations);
    const Solved<Scalar> motion = solved(motion_equations);
    add_misfit(numbers, "misfit of motion", motion);
    if (motion.fixed) {
      about("solved motion");
      numbers.add(motion.value);
      about("action");
      for (std::size_t i = 0; i < mechanism.actions.size(); ++i)
        numbers.add(solve::action_wrench(placed, motion.value, i));
    }
    if (situation_.has_blow()) add_blow(machine, placed, numbers);
    return numbers;
  }

  template <class Scalar>
  void add_blow(const MachineOf<Scalar>& machine, const solve::MechanismStateOf<Scalar>& before,
                Numbers<Scalar>& numbers) {
    const Mechanism<Scalar>& mechanism = machine.mechanism;
    numbers.now = "blow";
    solve::BlowOf<Scalar> blow;
    blow.impacts = machine.impacts;
    for (const StatedImpulseOf<Scalar>& stated : machine.impulses) {
      const Vector3<Scalar> vector = before.on_ground_axes(stated.axes, stated.vector);
      SpatialForce<Scalar> wrench{vector, Vector3<Scalar>::zero()};
      if (!stated.couple) wrench = {cross(before.position(stated.at), vector), vector};
      blow.impulses.push_back({stated.action, stated.on, wrench, stated.absorbed, stated.at});
      numbers.add(stated.particle_mass);
      numbers.add(stated.kept);
    }
    for (const auto& impact : blow.impacts) {
      numbers.add(solve::impact_wrench(before, impact));
      numbers.add(solve::approach(before, impact));
    }
    const std::vector<bool> acting(mechanism.actions.size(), true);
    const auto equations = solve::impulse_equations<Scalar>(before, scales_, blow, {}, acting);
    numbers.add(equations);
    const Solved<Scalar> impulses = solved(equations);
    add_misfit(numbers, "misfit of the blow", impulses);
    if (!impulses.fixed) return;
    numbers.now = "solved blow";
    numbers.add(impulses.value);
    for (std::size_t i = 0; i < mechanism.actions.size(); ++i)
      numbers.add(solve::action_impulse(before, blow, impulses.value, i));
  }

  template <class Scalar>
  static void add_misfit(Numbers<Scalar>& numbers, const std::string& origin, const Solved<Scalar>& solution) {
    numbers.now = origin;
    numbers.terms[origin] = solution.size;
    numbers.add(solution.misfit);
  }

  const Situation& situation_;
  Settings settings_;
  Varied varied_;
  double base_ = 0, gap_ = 0;
  bool prepared_ = false;
  solve::Scales scales_;  // of the first machine
  std::vector<double> q_, q_now_;
};

// What differences of the eighth order tell of a number.
struct Varying {
  double slope = 0, size = 0;
  double corner = 0;  // how much the slope jumps: second differences of two steps, which cancel where it does not
};

// Compares all numbers; returns how many vary.
std::size_t expect_derivatives(Subject& subject, const std::string& words) {
  const Numbers<Dual<1>> varied = subject.varied();
  const Numbers<double> base = subject.at(0);
  if (base.list.size() != varied.list.size()) {
    ADD_FAILURE() << words << ": " << base.list.size() << " numbers, but " << varied.list.size() << " with duals";
    return 0;
  }
  // A datum that is small in units of SI, as an unbalance, varies by a part of itself.
  const double base_size = std::abs(subject.base());
  const double h = 2e-4 * (base_size > 0 && base_size < 1e-4 ? base_size : std::max(base_size, 0.1));
  constexpr std::array<double, 4> weights{4.0 / 5, -1.0 / 5, 4.0 / 105, -1.0 / 280};
  std::vector<Varying> numbers(base.list.size());
  for (std::size_t k = 1; k <= weights.size(); ++k)
    for (const double side : {1.0, -1.0}) {
      const Numbers<double> there = subject.at(side * static_cast<double>(k) * h);
      if (there.list.size() != base.list.size()) return 0;  // what is fixed is no longer: no derivative
      for (std::size_t i = 0; i < numbers.size(); ++i) {
        numbers[i].slope += side * weights[k - 1] / h * there.list[i];
        numbers[i].size = std::max(numbers[i].size, std::abs(there.list[i]));
        if (k <= 2) numbers[i].corner += (k == 1 ? 2 : -0.5) * (there.list[i] - base.list[i]) / h;
      }
    }
  // Rounding is that of the largest number with the same origin.
  std::map<std::string, double> largest = base.terms, steepest;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    largest[base.origin[i]] = std::max(largest[base.origin[i]], numbers[i].size);
    steepest[base.origin[i]] = std::max(steepest[base.origin[i]], std::abs(numbers[i].slope));
  }
  std::size_t count = 0, wrong = 0;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const std::string& origin = base.origin[i];
    // Misfits of contradicting equations have corners, where another entry of a row becomes the largest.
    const double jump = origin.starts_with("misfit") ? std::abs(numbers[i].corner) : 0;
    const double tolerance = 1e-7 * steepest[origin] + 1e-10 / h * (largest[origin] + 1e-3) + jump;
    const bool same = std::abs(varied.list[i].value - base.list[i]) <= 1e-10 * (largest[origin] + 1e-3);
    if (!same || !(std::abs(varied.list[i].partial[0] - numbers[i].slope) <= tolerance)) {
      if (++wrong <= 3)
        ADD_FAILURE() << words << ": number " << i << " of " << origin << " is " << base.list[i] << ", over duals "
                      << varied.list[i].value << "; its derivative " << numbers[i].slope << ", by duals "
                      << varied.list[i].partial[0];
    }
    count += varied.list[i].partial[0] != 0;
  }
  return count;
}

// The text of a problem with one literal replaced by the datum `varied`.
std::string with_datum(const std::string& text, std::size_t which, std::size_t& literals) {
  static const std::regex literal(
      R"(([\[ ])(-?[0-9]+(?:\.[0-9]+)?(?:e[-+]?[0-9]+)?(?: [a-zA-Z][^,\]\}\n]*)?)(?=[,\]\}\n]))");
  const std::size_t end = text.find("\nask:");
  const std::string head = text.substr(0, end);
  const auto begin = std::sregex_iterator(head.begin(), head.end(), literal);
  literals = static_cast<std::size_t>(std::distance(begin, std::sregex_iterator()));
  if (which >= literals) return text;
  const std::smatch match = *std::next(begin, static_cast<std::ptrdiff_t>(which));
  std::string changed = text;
  changed.replace(static_cast<std::size_t>(match.position(2)), static_cast<std::size_t>(match.length(2)), "varied");
  return changed + "given: {varied: " + match[2].str() + "}\n";
}

TEST(VariedMachine, EveryNumberOfRandomProblems) {
  std::size_t varying = 0, tried = 0;
  constexpr std::size_t cases = poinsot::testing::case_count(1000);
  for (std::uint64_t seed = 0; seed < cases; ++seed) {
    Random random(seed);
    ProblemData data = random_problem(random);
    ask_everything(data);
    const std::string text = data.text();
    std::size_t literals = 0;
    with_datum(text, static_cast<std::size_t>(-1), literals);
    const auto which = static_cast<std::size_t>(random.integer(0, static_cast<int>(literals) - 1));
    const std::string varied = with_datum(text, which, literals);
    const Statement statement = read_statement(varied, "test.yaml");
    const Situation& situation = statement.situations.front();
    DataScope<double> scope(situation, {});
    const Settings settings{{"varied", scope.value(situation.given.front().value)}};
    try {
      Subject subject(situation, settings, {"varied"});
      const std::size_t count = expect_derivatives(subject, "seed " + std::to_string(seed));
      ++tried;
      varying += count > 0;
    } catch (const StatementError&) {
      // The edges of a box are no longer at right angles, for example.
    }
    ASSERT_FALSE(HasFailure()) << varied;
  }
  EXPECT_GT(tried, cases * 4 / 5);
  EXPECT_GT(varying, tried * 4 / 5);
}

// Varies every datum, letter and unknown of a statement, with component by component of vectors. What the drawn values
// of letters and unknowns do not let stand is left out.
struct Count {
  std::size_t tried = 0, varying = 0;
};
Count vary_all(const Statement& statement, const std::string& words) {
  Count count;
  for (const Situation& situation : statement.situations) {
    Settings settings;
    for (const Letter& letter : situation.letters)
      settings[letter.name] = Value<double>::of_number(0.7 * letter.unit.factor, letter.unit.dimension);
    for (const Unknown& unknown : situation.find)
      settings[unknown.name] = Value<double>::of_number(0.4 * unknown.unit.factor, unknown.unit.dimension);
    for (const Choice& choice : situation.choose)
      for (const std::string& name : choice.of) settings[name] = Value<double>::of_number(0, dimensions::none);
    Settings values = settings;
    DataScope<double> scope(situation, settings);
    for (const NamedExpression& datum : situation.given) {
      try {
        values[datum.name] = scope.value(datum.value);
      } catch (const StatementError&) {
        // It rests on something that has no value here.
      }
    }
    for (const auto& [name, value] : values) {
      if (!value.is_number() && !value.is_vector()) continue;
      for (std::size_t component = 0; component < (value.is_vector() ? 3u : 1u); ++component) {
        Settings set = settings;
        set[name] = value;
        try {
          Subject subject(situation, set, {name, component});
          if (subject.gap() > 1e-9) continue;
          const std::size_t varying = expect_derivatives(subject, words + ", " + name);
          ++count.tried;
          count.varying += varying > 0;
        } catch (const StatementError&) {
        }
      }
    }
  }
  return count;
}

TEST(VariedMachine, EveryDatumOfTheExamples) {
  std::size_t files = 0, most = 0;
  Count total;
  for (const std::filesystem::path& file : poinsot::testing::example_files("textbook")) {
    std::ifstream stream(file);
    const std::string text{std::istreambuf_iterator<char>(stream), {}};
    const Count count = vary_all(read_statement(text, file.string()), file.filename().string());
    ++most;
    files += count.varying > 0;
    total.tried += count.tried;
    total.varying += count.varying;
  }
  EXPECT_GT(files, most * 9 / 10);
  EXPECT_GT(total.varying, total.tried * 4 / 5);
}

TEST(VariedMachine, EveryDatumOfTheManual) {
  const std::filesystem::path folder = std::filesystem::path(::testing::TempDir()) / "poinsot-varied-machines";
  std::filesystem::create_directories(folder);
  std::size_t blocks = 0, most = 0;
  Count total;
  for (const FencedBlock& block : fenced_blocks("docs/language.md")) {
    if (!block.name.empty()) std::ofstream(folder / block.name) << block.text;
    if (block.kind != "yaml") continue;
    const std::string words = "docs/language.md:" + std::to_string(block.line);
    const Count count = vary_all(read_statement(block.text, (folder / "example.yaml").string()), words);
    ++most;
    blocks += count.varying > 0;
    total.tried += count.tried;
    total.varying += count.varying;
  }
  std::filesystem::remove_all(folder);
  EXPECT_GT(blocks, most * 9 / 10);
  // Coefficients of restitution, times, frequencies that shake and impulses change no machine.
  EXPECT_GT(total.varying, total.tried * 3 / 4);
}

void expect_all_vary(const std::string& text, std::size_t data) {
  const Count count = vary_all(read_statement(text, "test.yaml"), "the problem");
  EXPECT_EQ(count.tried, data);
  EXPECT_EQ(count.varying, data);
}

TEST(VariedMachine, MotionsThatFollowTheTime) {
  expect_all_vary(R"(
title: An arm that swings, a block that slides in it, a cart that speeds up
given: {m: 2 kg, L: 0.8 m, A: 40 deg, w: 3 rad/s, u: 0.2 m/s, b: 1.5 m/s^2, M: 4 N*m, s: 0.5 rad/s^2}
points: {O: [0, 0, 0], P: [L, 0, 0], Q: [2 m, L, 0]}
frames:
  cart: {velocity: [b*time, 0, u*sin(w*time)]}
  table: {origin: Q, turns: y, rate: s*time}
bodies:
  arm: {rod: [O, P], mass: m}
  block: {particle: P, mass: m}
  lever: {rod: [P, Q], mass: m}
  slab: {rod: [O, Q], mass: m}
joints:
  pin: {revolute: z, at: O, to: arm, angle: A*sin(w*time)}
  slot: {prismatic: x, at: P, from: arm, to: block, rate: u*cos(w*time)}
  post: {revolute: x, at: P, from: cart, to: lever, couple: M*cos(w*time)^2}
  pivot: {revolute: z, at: Q, from: table, to: slab, rate: w}
gravity: -y
ask: {F: force(pin on arm)}
)",
                  8);
}

TEST(VariedMachine, ClosedPosesAwayFromTheDrawnOne) {
  // A loop, closed by a slider.
  expect_all_vary(R"(
title: Crank, coupler and slider
given: {a: 0.3 m, b: 0.8 m, q: 50 deg, m: 2 kg, n: 4 rad/s}
points: {O: [0, 0, 0], A: [a, 0, 0], B: [a + b, 0, 0]}
bodies:
  crank: {rod: [O, A], mass: m}
  coupler: {rod: [A, B], mass: m}
  slider: {particle: B, mass: m}
joints:
  main: {revolute: z, at: O, to: crank, angle: q, rate: n}
  big: {revolute: z, at: A, from: crank, to: coupler}
  guide: {prismatic: x, at: B, to: slider}
  small: {revolute: z, at: B, from: coupler, to: slider}
gravity: -y
ask: {v: velocity(slider)}
)",
                  5);
  // A contact whose point moves over the wheel as that tilts.
  expect_all_vary(R"(
title: A wheel tilted after it was drawn
given: {r: 0.3 m, b: 20 deg, m: 3 kg, n: 2 rad/s, k: 400 N/m}
points: {O: [0, 0, 0], C: [0, r, 0], T: [0.1 m, 1 m, 0.2 m]}
bodies:
  carriage: {particle: C, mass: m}
  wheel: {disk: {center: C, normal: z, radius: r}, mass: m}
joints:
  lift: {prismatic: y, at: C, to: carriage}
  tilt: {revolute: x, at: C, from: carriage, to: wheel, angle: b, rate: n}
contacts:
  floor: {of: wheel, at: O, normal: y}
springs:
  hanger: {at: T, to: carriage, end: C, stiffness: k, free_length: r}
gravity: -y
ask: {N: force(floor on wheel)}
)",
                  5);
  // A cord that stays as long as drawn.
  expect_all_vary(R"(
title: A bar that has swung and a block on a cord
given: {L: 0.6 m, h: 0.9 m, q: 25 deg, m: 3 kg, n: 2 rad/s}
points: {O: [0, 0, 0], A: [L, 0, 0], B: [L + h/2, -h, 0]}
bodies:
  bar: {rod: [O, A], mass: m}
  block: {particle: B, mass: m}
joints:
  pin: {revolute: z, at: O, to: bar, angle: q, rate: n}
  guide: {prismatic: y, at: B, to: block}
cords:
  line: {from: bar, at: A, to: block, end: B}
gravity: -y
ask: {T: tension(line)}
)",
                  5);
}

// What is zero in the statement still varies.
TEST(VariedMachine, PosesAsDrawn) {
  expect_all_vary(R"(
title: A loop in the pose in which it is drawn
given: {q: 0 deg, c: 0 m}
points: {O: [0, 0, 0], A: [0, 0.3 m, 0], B: [0.7 m, c, 0]}
bodies:
  crank: {rod: [O, A], mass: 2 kg}
  coupler: {rod: [A, B], mass: 3 kg}
  slider: {particle: B, mass: 1 kg}
joints:
  main: {revolute: z, at: O, to: crank, angle: q, rate: 3 rad/s}
  big: {revolute: z, at: A, from: crank, to: coupler}
  guide: {prismatic: x, at: B, to: slider}
  small: {revolute: z, at: B, from: coupler, to: slider}
gravity: -y
ask: {v: velocity(slider)}
)",
                  2);
  expect_all_vary(R"(
title: A wheel that has not yet turned
given: {q: 0 deg, b: 0 deg}
points: {O: [0, 0, 0], C: [0, 0.3 m, 0], D: [0.2 m, 0.3 m, 0]}
bodies:
  carriage: {particle: C, mass: 1 kg}
  fork: {particle: D, mass: 2 kg}
  wheel: {disk: {center: C, normal: z, radius: 0.3 m}, mass: 3 kg}
joints:
  lift: {prismatic: y, at: C, to: carriage}
  tilt: {revolute: x, at: C, from: carriage, to: fork, angle: b}
  axle: {revolute: z, at: C, from: fork, to: wheel, angle: q}
contacts:
  floor: {of: wheel, at: O, normal: y, no_slip: true}
gravity: -y
ask: {N: force(floor on wheel)}
)",
                  2);
}

}  // namespace varied_machine_test
}  // namespace poinsot::problem
