// Work and precision of integrating motions, closed forms left aside: processor time against the true error of the
// attitude, from 1e-4 to 1e-11, beside Boost.odeint and SUNDIALS on the same equations in the same run; and the drift
// of energy over a million periods of the spin.
//
// Usage: bench_integration [WORD...]: only cases whose names contain one of the words ("drift" for the last part).
// Exit code 1 if poinsot reaches an error later than the best peer, a fast top less than five times sooner, or the
// energy drifts.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <span>

#include "integration_case.h"
#include "poinsot/engine/math/algebra/pack.h"
#include "poinsot/engine/model/builder.h"

namespace poinsot::bench {
namespace {

// End attitudes by Taylor series of degree 40 in 40-digit arithmetic.
const RotationCase torque_free{"torque-free body",
                               {1.0, 2.0, 3.0},
                               0.0,
                               {0.1, 5.0, 0.1},
                               100.0,
                               {-0.0169736334790839982435844, 0.763707356474878484809854, 0.00348801869715182540305308,
                                0.645329995551298481317482}};
const RotationCase heavy_top{
    "fast heavy top",
    {15.234375, 0.46875, 15.234375},
    15.0 * 9.81,
    {0.0, 150.0, -4.61538},
    2.0,
    {0.122947135041533467104252, -0.491079892550027014699045, 0.350430030343620961839020, -0.787986887550485669324174}};
// The same with unequal moments across the axis.
const RotationCase triaxial_top{
    "fast triaxial top",
    {15.3, 0.46875, 15.234375},
    15.0 * 9.81,
    {0.0, 150.0, -4.61538},
    2.0,
    {0.129774690806640853663107, -0.483590588814031831991393, 0.355647226632329804426100, -0.789185480242300833061324}};

// Problem 18.C5, from level with 5 rad/s.
const ForkCase gimballed_disk{"gimballed disk",
                              0.1377,
                              0.0162,
                              9.81 * 0.36,
                              0.5 * 3.14159265358979323846,
                              5.0,
                              100.0,
                              {0.0357875770625429392026963, -0.696753068261559092440354, 0.0348465017304151946549458,
                               0.715569795696581855820056}};

RotatingBody body_of(const RotationCase& c) {
  RotatingBody body;
  body.inertia = SymmetricMatrix3<double>::diagonal(c.I.x, c.I.y, c.I.z);
  if (c.weight != 0.0) {
    body.first_moment = {0.0, c.weight / 9.81, 0.0};
    body.gravity = {0.0, 0.0, -9.81};
  }
  return body;
}

IntegrationOptions bare(IntegrationMethod method, double tolerance) {
  IntegrationOptions options;
  options.method = method;
  options.tolerance = tolerance;
  options.store = false;
  options.watch_drift = false;
  return options;
}

Integrator<RotationCase> own_rotation(const char* name, IntegrationMethod method) {
  return {name, true, [method](const RotationCase& c, double tolerance) {
            const IntegrationResult r = integrate_rotation(body_of(c), 0.0, Quaternion<double>::identity(), c.w, c.end,
                                                           bare(method, tolerance));
            return Attitude{r.q[0], r.q[1], r.q[2], r.q[3]};
          }};
}

Attitude end_of_fork(const ForkCase& c, const MotionEquations& equations, IntegrationMethod method, double tolerance) {
  const auto start = c.start();
  const IntegrationResult r =
      integrate(equations, 0.0, std::span(start).first(2), std::span(start).subspan(2), c.end, bare(method, tolerance));
  return ForkCase::attitude(r.q.data());
}

// The right-hand side that the others have, for one instant and for eight.
Integrator<ForkCase> own_fork(const char* name, IntegrationMethod method) {
  return {name, true, [method](const ForkCase& c, double tolerance) {
            MotionEquations equations;
            equations.position_size = equations.velocity_size = 2;
            equations.accelerations = [&c](double, std::span<const double> q, std::span<const double> v,
                                           std::span<double> a) {
              const double y[] = {q[0], q[1], v[0], v[1]};
              double rate[4];
              c.rates(y, rate);
              a[0] = rate[2];
              a[1] = rate[3];
            };
            equations.accelerations_at_eight = [&c](std::span<const double>, std::span<const double> q,
                                                    std::span<const double> v, std::span<double> a) {
              using Instants = Pack<8>;
              const auto read = [](const double* at) {
                return Instants(Instants::Lanes(at, std::experimental::element_aligned));
              };
              const Instants y[] = {read(&q[0]), read(&q[8]), read(&v[0]), read(&v[8])};
              Instants rate[4];
              c.rates(y, rate);
              rate[2].lanes().copy_to(&a[0], std::experimental::element_aligned);
              rate[3].lanes().copy_to(&a[8], std::experimental::element_aligned);
            };
            return end_of_fork(c, equations, method, tolerance);
          }};
}

// The fork and the disk as two bodies with joints: no right-hand side by hand.
Model<double> fork_model(const ForkCase& c) {
  using Vector = Vector3<double>;
  constexpr double g = 9.81;
  const double arm = c.weight / g;
  ModelBuilder<double> builder;
  const int fork = builder.add_body("fork", ground, Joint<double>::revolute({0.0, 0.0, 1.0}),
                                    SpatialTransform<double>::identity(), MassProperties<double>{});
  const double across = c.across - arm * arm;
  builder.add_body(
      "disk", fork, Joint<double>::revolute({0.0, 1.0, 0.0}), SpatialTransform<double>::identity(),
      MassProperties<double>{1.0, Vector{0.0, 0.0, -arm}, SymmetricMatrix3<double>::diagonal(across, across, c.along)});
  builder.set_gravity({0.0, 0.0, -g});
  return builder.build();
}

Integrator<ForkCase> own_tree(const char* name, IntegrationMethod method) {
  return {name, true, [method](const ForkCase& c, double tolerance) {
            const Model<double> model = fork_model(c);
            const ForkCase::Numbers start = c.start();
            const double q[] = {start[1], start[0]};
            const double v[] = {start[3], start[2]};
            const IntegrationResult r = integrate(tree_equations(model), 0.0, q, v, c.end, bare(method, tolerance));
            const double y[] = {r.q[1], r.q[0]};
            return ForkCase::attitude(y);
          }};
}

// The angle between two attitudes, rad; quaternions of any length.
double attitude_error(std::span<const double, 4> a, std::span<const double, 4> b) {
  double dot = 0.0;
  double length = 0.0;
  for (std::size_t i = 0; i < 4; ++i) {
    dot += a[i] * b[i];
    length += a[i] * a[i];
  }
  length = std::sqrt(length);
  const double sign = dot < 0.0 ? -1.0 : 1.0;
  double apart = 0.0;
  for (std::size_t i = 0; i < 4; ++i) apart += std::pow(sign * a[i] / length - b[i], 2);
  return 4.0 * std::asin(std::min(1.0, 0.5 * std::sqrt(apart)));
}

// So many times all contestants are measured in turn, so that a time in which the machine is slow slows all.
constexpr int passes = 3;

struct Point {
  double error;
  double seconds;
};

// The least time in several repeats, of runs in a row that take a while.
double least_seconds(const std::function<void()>& run) {
  using Clock = std::chrono::steady_clock;
  constexpr double span = 2e-3;
  int calls = 1;
  double best = INFINITY;
  for (int repeat = 0; repeat < 3;) {
    const auto start = Clock::now();
    for (int i = 0; i < calls; ++i) run();
    const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
    if (seconds < span) {
      calls *= 2;
      continue;
    }
    best = std::min(best, seconds / calls);
    ++repeat;
  }
  return best;
}

// The least time at which the points, joined in the order of tolerances on logarithmic scales, reach the error.
double seconds_at(const std::vector<Point>& points, double error) {
  double best = INFINITY;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (points[i].error <= error) best = std::min(best, points[i].seconds);
    if (i == 0) continue;
    const Point& a = points[i - 1];
    const Point& b = points[i];
    if (!(a.error > error && b.error <= error)) continue;
    const double part = std::log(a.error / error) / std::log(a.error / std::max(b.error, 1e-17));
    best = std::min(best, a.seconds * std::pow(b.seconds / a.seconds, part));
  }
  return best;
}

template <class Case>
bool measure(const Case& c, double goal, std::vector<Integrator<Case>> contestants) {
  for (const Integrator<Case>& peer : odeint_integrators<Case>()) contestants.push_back(peer);
  for (const Integrator<Case>& peer : sundials_integrators<Case>()) contestants.push_back(peer);
  fmt::print("\n{}, {} s: tolerance, true error of the attitude (rad), microseconds\n", c.name, c.end);
  std::vector<std::vector<Point>> curves(contestants.size());
  for (int pass = 0; pass < passes; ++pass)
    for (std::size_t i = 0; i < contestants.size(); ++i) {
      const Integrator<Case>& contestant = contestants[i];
      if (pass + 1 == passes) fmt::print("  {:<24}", contestant.name);
      std::size_t k = 0;
      for (double tolerance = 1e-3; tolerance > 0.9e-15; tolerance *= 0.1) {
        const double error = attitude_error(contestant.run(c, tolerance), c.end_attitude);
        if (!std::isfinite(error) && k == 0) continue;
        if (!std::isfinite(error)) break;
        if (k == curves[i].size()) curves[i].push_back({error, INFINITY});
        double& seconds = curves[i][k++].seconds;
        seconds = std::min(seconds, least_seconds([&] { contestant.run(c, tolerance); }));
        if (pass + 1 == passes) fmt::print(" {:.0e} {:.1e} {:.1f};", tolerance, error, seconds * 1e6);
      }
      if (pass + 1 == passes) fmt::print("\n");
    }

  fmt::print("  microseconds to reach an error:");
  for (const Integrator<Case>& contestant : contestants) fmt::print(" | {}", contestant.name);
  fmt::print(" | best peer / poinsot\n");
  bool good = true;
  for (double error = 1e-4; error > 0.9e-11; error *= 0.1) {
    double mine = INFINITY;
    double best_peer = INFINITY;
    fmt::print("  {:.0e}", error);
    for (std::size_t i = 0; i < contestants.size(); ++i) {
      const double seconds = seconds_at(curves[i], error);
      fmt::print(" | {:.1f}", seconds * 1e6);
      double& best = contestants[i].is_own ? mine : best_peer;
      best = std::min(best, seconds);
    }
    fmt::print(" | {:.1f}\n", best_peer / mine);
    good = good && best_peer >= goal * mine;
  }
  fmt::print("  goal: {} times less than the best peer: {}\n", goal, good ? "reached" : "missed");
  return good;
}

// The largest change of energy, over its size, in a million periods of the spin.
bool measure_drift(const RotationCase& c, double step) {
  constexpr double periods = 1e6;
  const double spin = 2.0 * 3.14159265358979323846 / std::fabs(c.w.y);
  IntegrationOptions options;
  options.method = IntegrationMethod::structure_preserving;
  options.tolerance = 1e-16;
  options.fixed_step = step;
  options.store = false;
  const auto start = std::chrono::steady_clock::now();
  const IntegrationResult r =
      integrate_rotation(body_of(c), 0.0, Quaternion<double>::identity(), c.w, periods * spin, options);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  const Drift& energy = r.drift[0];
  const double drift = energy.largest / std::fabs(energy.start);
  fmt::print("{}: {:.0e} periods of the spin in {} steps, {:.1f} s: energy drifts by {:.1e}, {} by {:.1e}\n", c.name,
             periods, r.statistics.steps, seconds, drift, r.drift[1].name, r.drift[1].largest / norm(c.w));
  // The rounding of so many steps, as it adds up by chance.
  return r.complete() && drift < 20 * 1.1e-16 * std::sqrt(static_cast<double>(r.statistics.steps));
}

}  // namespace
}  // namespace poinsot::bench

int main(int argc, char** argv) {
  using namespace poinsot;
  using namespace poinsot::bench;
  const auto wanted = [&](const std::string& name) {
    if (argc < 2) return true;
    return std::any_of(argv + 1, argv + argc, [&](const char* word) { return name.find(word) != std::string::npos; });
  };
  using enum IntegrationMethod;
  const std::vector<Integrator<RotationCase>> rotation{own_rotation("poinsot", automatic),
                                                       own_rotation("poinsot, equal steps", structure_preserving),
                                                       own_rotation("poinsot, explicit", explicit_runge_kutta)};
  const std::vector<Integrator<ForkCase>> fork{
      own_fork("poinsot", automatic), own_fork("poinsot, explicit", explicit_runge_kutta),
      own_fork("poinsot, equal steps", structure_preserving), own_tree("poinsot, two bodies", automatic),
      own_tree("two bodies, explicit", explicit_runge_kutta)};
  if (sundials_integrators<RotationCase>().empty()) fmt::print("SUNDIALS is not installed: its columns are missing\n");

  bool good = true;
  if (wanted(torque_free.name)) good = measure(torque_free, 1.0, rotation) && good;
  if (wanted(heavy_top.name)) good = measure(heavy_top, 5.0, rotation) && good;
  if (wanted(triaxial_top.name)) good = measure(triaxial_top, 5.0, rotation) && good;
  if (wanted(gimballed_disk.name)) good = measure(gimballed_disk, 1.0, fork) && good;
  if (wanted("drift")) {
    fmt::print("\n");
    good = measure_drift(heavy_top, 0.05) && good;
    good = measure_drift(triaxial_top, 0.017) && good;
  }
  return good ? 0 : 1;
}
