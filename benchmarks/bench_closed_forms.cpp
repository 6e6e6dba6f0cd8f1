// The closed forms of motion: nanoseconds per evaluation and per preparation.
//
// Usage: bench_closed_forms [options of Google Benchmark].
#include <benchmark/benchmark.h>

#include "poinsot/engine/math/elliptic/elliptic_functions.h"
#include "poinsot/engine/motion/closed_form/symmetric_top.h"
#include "poinsot/engine/motion/closed_form/torque_free.h"

namespace poinsot {
namespace {

struct Body {
  const char* name;
  Vector3<double> moments, w;
};
// m = 0.0007, 0.97, 0.9992 and 0.
const Body bodies[] = {{"about the largest moment", {1, 2, 3}, {0.1, 0.1, 5}},
                       {"tumbling", {1, 2, 3}, {0.3, 1, 0.2}},
                       {"near the separatrix", {1, 2, 3}, {0.1, 5, 0.1}},
                       {"axisymmetric", {2, 2, 3}, {1, 0.2, 2}}};

const Body& body_of(benchmark::State& state) {
  const Body& body = bodies[state.range(0)];
  state.SetLabel(body.name);
  return body;
}

void torque_free_attitude(benchmark::State& state) {
  const Body& body = body_of(state);
  const TorqueFreeMotion motion(body.moments, Quaternion<double>::identity(), body.w);
  double t = 0;
  for (auto _ : state) benchmark::DoNotOptimize(motion.attitude(t += 0.137));
}
void torque_free_state(benchmark::State& state) {
  const Body& body = body_of(state);
  const TorqueFreeMotion motion(body.moments, Quaternion<double>::identity(), body.w);
  double t = 0;
  for (auto _ : state) benchmark::DoNotOptimize(motion.at(t += 0.137));
}
void torque_free_preparation(benchmark::State& state) {
  const Body& body = body_of(state);
  for (auto _ : state) {
    benchmark::DoNotOptimize(TorqueFreeMotion(body.moments, Quaternion<double>::identity(), body.w));
  }
}
BENCHMARK(torque_free_attitude)->DenseRange(0, 3);
BENCHMARK(torque_free_state)->DenseRange(0, 3);
BENCHMARK(torque_free_preparation)->DenseRange(0, 3);

const TopParameters top{1, 0.5, 2};
const TopState start{1, 0.3, 0, 0.4, 0, 5};

void top_attitude(benchmark::State& state) {
  const SymmetricTop motion(top, start);
  double t = 0;
  for (auto _ : state) benchmark::DoNotOptimize(motion.attitude(t += 0.137));
}
void top_angles_and_rates(benchmark::State& state) {
  const SymmetricTop motion(top, start);
  double t = 0;
  for (auto _ : state) benchmark::DoNotOptimize(motion.at(t += 0.137));
}
void top_preparation(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(SymmetricTop(top, start));
}
BENCHMARK(top_attitude);
BENCHMARK(top_angles_and_rates);
BENCHMARK(top_preparation);

void jacobi_functions(benchmark::State& state) {
  const JacobiFunctions jacobi(EllipticParameter<double>::of_m(state.range(0) == 0 ? 0.3 : 0.9));
  double u = 0;
  for (auto _ : state) benchmark::DoNotOptimize(jacobi.at(u += 0.137));
}
BENCHMARK(jacobi_functions)->DenseRange(0, 1);

}  // namespace
}  // namespace poinsot

BENCHMARK_MAIN();
