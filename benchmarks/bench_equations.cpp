// Equations of motion as formulas: derives those of the models below and prints, a line of JSON for each, how long that
// took (median, s), how many operations they have, and their code in Python. bench_equations.py compares them with
// SymPy's.
//
// A second part writes C for the inverse dynamics of arms of seven joints, compiles it with the system's compiler and
// measures it beside the engine's own call: ns per call of each.
#include <dlfcn.h>
#include <fmt/format.h>
#include <fmt/os.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>

#include "models.h"
#include "poinsot/engine/dynamics/equations_of_motion.h"
#include "poinsot/engine/math/trace/straight_line_text.h"

namespace poinsot::bench {
namespace {

using Clock = std::chrono::steady_clock;
using Vector = Vector3<Traced>;
using TracedJoint = Joint<Traced>;
using Mass = MassProperties<Traced>;

// A model in the making, with its letters.
struct Draft {
  Trace trace;
  std::vector<TextInput> inputs;
  std::vector<std::string> letters;
  ModelBuilder<Traced> builder;
  Mechanism<Traced> mechanism;

  Traced letter(const std::string& name) {
    const double sample = 0.7 + 0.13 * static_cast<double>(letters.size());
    inputs.push_back({"parameters", static_cast<int>(letters.size()), name, "", true});
    letters.push_back(name);
    return trace.input(sample);
  }
};

Vector axis(int i) { return Vector::unit(static_cast<std::size_t>(i)); }
SpatialTransform<Traced> at(const Vector& place) { return SpatialTransform<Traced>::translation(place); }
Mass massless() { return {Traced(0), Vector::zero(), SymmetricMatrix3<Traced>::zero()}; }

// What is derived: mass matrix and right-hand side of the independent coordinates.
struct Derived {
  StraightLine program;
  ProgramText text;
};

Derived derived(Draft& draft, StraightLine::Shortening shortening) {
  draft.mechanism.tree = draft.builder.build();
  const Model<Traced>& tree = draft.mechanism.tree;
  State<Traced> state;
  for (int k = 0; k < tree.position_size(); ++k) {
    draft.inputs.push_back({"q", k, "q" + std::to_string(k + 1), "", false});
    state.q.push_back(draft.trace.input(0.31 + 0.17 * k));
  }
  for (int k = 0; k < tree.velocity_size(); ++k) {
    draft.inputs.push_back({"v", k, "q" + std::to_string(k + 1) + "'", "", false});
    state.v.push_back(draft.trace.input(0.41 - 0.19 * k));
  }
  const EquationsOfMotion<Traced> equations = equations_of_motion(draft.mechanism, state);
  std::vector<Traced> outputs = equations.mass, right = equations.right_side;
  if (!draft.mechanism.constraints.empty()) {
    const auto n = static_cast<std::size_t>(equations.size);
    std::vector<double> preferred(n, 0);
    // The position of the contact follows from the turning.
    for (std::size_t k = 2; k < n; ++k) preferred[k] = 30;
    ReducedEquations<Traced> reduced =
        reduced_equations(equations, std::vector<bool>(n, false), std::vector<Traced>(n), preferred);
    outputs = std::move(reduced.mass);
    right = std::move(reduced.right_side);
  }
  outputs.insert(outputs.end(), right.begin(), right.end());
  ProgramText text;
  text.function = "equations";
  text.arrays = {"q", "v", "parameters"};
  text.inputs = draft.inputs;
  text.blocks = {{"M", "mass matrix", right.size(), right.size(), true},
                 {"F", "right-hand side", right.size(), 1, false}};
  return {StraightLine(draft.trace, outputs, shortening), text};
}

void heavy_top(Draft& d) {
  const Traced m = d.letter("m"), g = d.letter("g"), l = d.letter("l"), A = d.letter("A"), C = d.letter("C");
  d.builder.set_gravity({Traced(0), Traced(0), -g});
  d.builder.add_body("precession", ground, TracedJoint::revolute(axis(2)), {}, massless());
  d.builder.add_body("nutation", 0, TracedJoint::revolute(axis(0)), {}, massless());
  d.builder.add_body("top", 1, TracedJoint::revolute(axis(2)), {},
                     {m, {Traced(0), Traced(0), l}, SymmetricMatrix3<Traced>::diagonal(A, A, C)});
}

// On the point where it touches ride yaw, lean and spin; that point moves as the disk rolls.
void rolling_disk(Draft& d) {
  const Traced m = d.letter("m"), g = d.letter("g"), r = d.letter("r");
  d.builder.set_gravity({Traced(0), Traced(0), -g});
  d.builder.add_body("x", ground, TracedJoint::prismatic(axis(0)), {}, massless());
  d.builder.add_body("y", 0, TracedJoint::prismatic(axis(1)), {}, massless());
  d.builder.add_body("yaw", 1, TracedJoint::revolute(axis(2)), {}, massless());
  d.builder.add_body("lean", 2, TracedJoint::revolute(axis(0)), {}, massless());
  const Traced I = m * r * r / Traced(4);
  d.builder.add_body("disk", 3, TracedJoint::revolute(axis(1)), at({Traced(0), Traced(0), r}),
                     {m, Vector::zero(), SymmetricMatrix3<Traced>::diagonal(I, I + I, I)});
  for (const int along : {0, 1}) {
    VelocityConstraint<Traced> c;
    c.kind = VelocityConstraintKind::rolling;
    c.on = 4;
    c.along = {ground, axis(along)};
    c.axis = axis(1);
    c.radius = r;
    c.center = Vector::zero();
    c.toward = {ground, Vector::zero()};
    c.surface_axis = {ground, axis(2)};
    d.mechanism.constraints.push_back(c);
  }
}

// Point masses on rods, each with its own angle to the rod before it.
std::function<void(Draft&)> planar_pendulum(int links) {
  return [links](Draft& d) {
    const Traced g = d.letter("g");
    d.builder.set_gravity({Traced(0), -g, Traced(0)});
    std::vector<Traced> length, mass;
    for (int i = 1; i <= links; ++i) mass.push_back(d.letter("m" + std::to_string(i)));
    for (int i = 1; i <= links; ++i) length.push_back(d.letter("l" + std::to_string(i)));
    for (int i = 0; i < links; ++i) {
      const auto k = static_cast<std::size_t>(i);
      const Vector place = i == 0 ? Vector::zero() : Vector{Traced(0), -length[k - 1], Traced(0)};
      d.builder.add_body(std::to_string(i), i - 1, TracedJoint::revolute(axis(2)), at(place),
                         {mass[k], {Traced(0), -length[k], Traced(0)}, SymmetricMatrix3<Traced>::zero()});
    }
  };
}

// Uniform bars whose hinges stand along x and y in turn.
std::function<void(Draft&)> spatial_pendulum(int links) {
  return [links](Draft& d) {
    const Traced g = d.letter("g"), m = d.letter("m"), l = d.letter("l");
    d.builder.set_gravity({Traced(0), Traced(0), -g});
    const Traced I = m * l * l / Traced(12);
    for (int i = 0; i < links; ++i) {
      const Vector place = i == 0 ? Vector::zero() : Vector{Traced(0), Traced(0), -l};
      d.builder.add_body(
          std::to_string(i), i - 1, TracedJoint::revolute(axis(i % 2)), at(place),
          {m, {Traced(0), Traced(0), -l / Traced(2)}, SymmetricMatrix3<Traced>::diagonal(I, I, Traced(0))});
    }
  };
}

double median(std::vector<double> times) {
  std::nth_element(times.begin(), times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2), times.end());
  return times[times.size() / 2];
}

// The row that is reported, and in it how long it takes.
nlohmann::json derived_row(const std::string& name, const std::function<void(Draft&)>& build,
                           StraightLine::Shortening shortening) {
  std::vector<double> times;
  nlohmann::json row;
  for (int run = 0; run < 11; ++run) {
    const auto begin = Clock::now();
    Draft draft;
    const TraceScope scope(draft.trace);
    build(draft);
    const Derived result = derived(draft, shortening);
    times.push_back(std::chrono::duration<double>(Clock::now() - begin).count());
    if (run > 0) continue;
    row = {{"model", name},
           {"size", result.text.blocks[1].rows},
           {"letters", draft.letters},
           {"operations", result.program.operations()},
           {"python", write_program(result.program, result.text, TextForm::python)}};
  }
  row["seconds"] = median(times);
  return row;
}

void report_equations(const std::string& name, const std::function<void(Draft&)>& build) {
  nlohmann::json row = derived_row(name, build, StraightLine::Shortening::quick);
  const nlohmann::json thorough = derived_row(name, build, StraightLine::Shortening::thorough);
  row["thorough_seconds"] = thorough["seconds"];
  row["thorough_operations"] = thorough["operations"];
  fmt::print("{}\n", row.dump());
}

// Code for a numeric model's inverse dynamics, beside the engine.
int report_code(const StatedModel& stated, const std::filesystem::path& folder) {
  const Model<double> model = built(stated);
  Trace trace;
  const TraceScope scope(trace);
  State<Traced> state;
  std::vector<Traced> acceleration, force(static_cast<std::size_t>(model.velocity_size()));
  ProgramText text;
  text.function = "inverse_dynamics";
  text.arrays = {"q", "v", "a", "parameters"};
  const auto inputs = [&](const std::string& array, int count, std::vector<Traced>& values) {
    for (int k = 0; k < count; ++k) {
      text.inputs.push_back({array, k, array + std::to_string(k + 1), "", false});
      values.push_back(trace.input(0.31 + 0.07 * static_cast<double>(text.inputs.size())));
    }
  };
  inputs("q", model.position_size(), state.q);
  inputs("v", model.velocity_size(), state.v);
  inputs("a", model.velocity_size(), acceleration);
  const Model<Traced> traced = convert<Traced>(model);
  Workspace<Traced> traced_workspace(traced);
  inverse_dynamics<Traced>(traced, traced_workspace, state, acceleration, force);
  const StraightLine program(trace, force);
  text.blocks = {{"force", "generalised forces", force.size(), 1, false}};
  const std::string source = (folder / "code.c").string(), library = (folder / "code.so").string();
  fmt::output_file(source).print("{}", write_program(program, text, TextForm::c));
  const std::string command = "cc -std=c99 -O3 -march=native -shared -fPIC -o " + library + " " + source + " -lm";
  if (std::system(command.c_str()) != 0) {
    fmt::print(stderr, "bench_equations: the generated C does not compile\n");
    return 1;
  }
  void* handle = dlopen(library.c_str(), RTLD_NOW | RTLD_LOCAL);
  using Function = void (*)(const double*, const double*, const double*, const double*, double*);
  const auto function = handle ? reinterpret_cast<Function>(dlsym(handle, "inverse_dynamics")) : nullptr;
  if (!function) return 1;

  const std::vector<Sample> cases = samples(model, 16);
  Workspace<double> workspace(model);
  std::vector<double> own(force.size()), code(force.size());
  double apart = 0, size = 0;
  for (const Sample& c : cases) {
    inverse_dynamics<double>(model, workspace, c.state, c.given, own);
    function(c.state.q.data(), c.state.v.data(), c.given.data(), nullptr, code.data());
    for (std::size_t k = 0; k < own.size(); ++k) {
      apart = std::max(apart, std::fabs(own[k] - code[k]));
      size = std::max(size, std::fabs(own[k]));
    }
  }
  const auto measured = [&](const auto& call) {
    constexpr int calls = 2000;
    const auto begin = Clock::now();
    for (int i = 0; i < calls; ++i) call(cases[static_cast<std::size_t>(i) % cases.size()]);
    return std::chrono::duration<double>(Clock::now() - begin).count() / calls * 1e9;
  };
  std::vector<double> engine_times, code_times;
  for (int run = 0; run < 41; ++run) {
    engine_times.push_back(
        measured([&](const Sample& c) { inverse_dynamics<double>(model, workspace, c.state, c.given, own); }));
    code_times.push_back(measured(
        [&](const Sample& c) { function(c.state.q.data(), c.state.v.data(), c.given.data(), nullptr, code.data()); }));
  }
  const nlohmann::json row = {{"code", stated.name},
                              {"operations", program.operations()},
                              {"engine", median(engine_times)},
                              {"generated", median(code_times)},
                              {"apart", apart / size}};
  fmt::print("{}\n", row.dump());
  dlclose(handle);
  return apart <= 1e-12 * size ? 0 : 1;
}

int run() {
  report_equations("heavy top, Euler angles", heavy_top);
  report_equations("rolling disk", rolling_disk);
  report_equations("planar 3-link pendulum", planar_pendulum(3));
  report_equations("spatial 3-link pendulum", spatial_pendulum(3));
  report_equations("planar 6-link pendulum", planar_pendulum(6));
  report_equations("spatial 6-link pendulum", spatial_pendulum(6));
  report_equations("planar 10-link pendulum", planar_pendulum(10));
  char name[] = "/tmp/poinsot-code-XXXXXX";
  const char* made = mkdtemp(name);
  if (!made) return 1;
  const std::filesystem::path folder(made);
  int status = 0;
  for (const StatedModel& stated : stated_models())
    if (stated.name.starts_with("arm")) status |= report_code(stated, folder);
  std::filesystem::remove_all(folder);
  return status;
}

}  // namespace
}  // namespace poinsot::bench

int main() { return poinsot::bench::run(); }
