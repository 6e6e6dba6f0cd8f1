// Inverse dynamics, forward dynamics and mass matrix: one call at a time, and eight states at a time in packs, beside
// Pinocchio. Prints one table of medians in nanoseconds per state; above 1 a ratio says how many times quicker poinsot
// is.
//
// Usage: bench_dynamics [MODEL...]: only models whose names contain one of the words.
// Exit code 1 if the contestants' results differ by more than 1e-9 of their largest entry.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <type_traits>

#include "peer.h"
#include "poinsot/engine/dynamics/forward_dynamics.h"
#include "poinsot/engine/dynamics/inverse_dynamics.h"
#include "poinsot/engine/dynamics/mass_matrix.h"
#include "poinsot/engine/dynamics/packed_bodies.h"
#include "poinsot/engine/math/algebra/pack.h"

namespace poinsot::bench {
namespace {

constexpr int sample_count = 16;

// Runs over one scalar. Case: a state and given numbers.
template <class Scalar>
struct Runner {
  struct Case {
    State<Scalar> state;
    std::vector<Scalar> given;
  };
  Model<Scalar> model;
  Workspace<Scalar> workspace;
  PackedBodies<Scalar> bodies;
  std::vector<Case> cases;
  std::vector<Scalar> result;
  std::vector<Scalar> matrix;

  Runner(const Model<Scalar>& own_model, std::vector<Case> own_cases)
      : model(own_model),
        workspace(model),
        bodies(model, workspace),
        cases(std::move(own_cases)),
        result(model.velocity_size()),
        matrix(model.velocity_size() * model.velocity_size()) {}

  void inverse(const Case& c) { inverse_dynamics<Scalar>(model, workspace, c.state, c.given, result); }
  void forward(const Case& c) {
    if constexpr (std::is_same_v<Scalar, double>)
      forward_dynamics<Scalar>(model, workspace, c.state, c.given, result);
    else
      forward_dynamics<Scalar>(model, bodies, c.state, c.given, result);
  }
  void mass(const Case& c) { mass_matrix<Scalar>(model, workspace, c.state.q, matrix); }
};

template <class Scalar>
Contestant contestant_of(const std::shared_ptr<Runner<Scalar>>& runner) {
  using R = Runner<Scalar>;
  const auto through = [runner](auto call) {
    return [runner, call](int calls) {
      const std::size_t count = runner->cases.size();
      for (int i = 0; i < calls; ++i) ((*runner).*call)(runner->cases[static_cast<std::size_t>(i) % count]);
    };
  };
  Contestant contestant;
  contestant.inverse_dynamics = through(&R::inverse);
  contestant.forward_dynamics = through(&R::forward);
  contestant.mass_matrix = through(&R::mass);
  return contestant;
}

Contestant single(const Model<double>& model, const std::vector<Sample>& samples) {
  std::vector<Runner<double>::Case> cases;
  for (const Sample& sample : samples) cases.push_back({sample.state, sample.given});
  const auto runner = std::make_shared<Runner<double>>(model, cases);
  Contestant contestant = contestant_of(runner);
  contestant.inverse_result = [runner](int i) {
    runner->inverse(runner->cases[static_cast<std::size_t>(i)]);
    return runner->result;
  };
  contestant.forward_result = [runner](int i) {
    runner->forward(runner->cases[static_cast<std::size_t>(i)]);
    return runner->result;
  };
  contestant.mass_result = [runner](int i) {
    runner->mass(runner->cases[static_cast<std::size_t>(i)]);
    std::vector<double> lower;
    const int n = runner->model.velocity_size();
    for (int r = 0; r < n; ++r) lower.insert(lower.end(), &runner->matrix[r * n], &runner->matrix[r * n] + r + 1);
    return lower;
  };
  return contestant;
}

Contestant packed(const Model<double>& model, const std::vector<Sample>& samples) {
  using P = Pack<8>;
  std::vector<Runner<P>::Case> cases;
  for (std::size_t first = 0; first + 8 <= samples.size(); first += 8) {
    const auto gathered = [&](auto list) {
      std::vector<P> packs(list(samples[first]).size());
      for (std::size_t k = 0; k < packs.size(); ++k) {
        packs[k] = P::from_lanes([&](int lane) { return list(samples[first + static_cast<std::size_t>(lane)])[k]; });
      }
      return packs;
    };
    cases.push_back({{gathered([](const Sample& s) -> const std::vector<double>& { return s.state.q; }),
                      gathered([](const Sample& s) -> const std::vector<double>& { return s.state.v; })},
                     gathered([](const Sample& s) -> const std::vector<double>& { return s.given; })});
  }
  return contestant_of(std::make_shared<Runner<P>>(convert<P>(model), cases));
}

double seconds_of(const std::function<void(int)>& run, int calls) {
  const auto start = std::chrono::steady_clock::now();
  run(calls);
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// Median nanoseconds per call of each run, the runs taking turns so that the machine's moods fall on all alike.
std::vector<double> medians(const std::vector<std::function<void(int)>>& runs) {
  constexpr int repeats = 41;
  constexpr double span = 400e-6;  // s, long against the clock's step
  std::vector<int> calls;
  for (const auto& run : runs) {
    int count = 1;
    if (run) {
      while (seconds_of(run, count) < span) count *= 2;
    }
    calls.push_back(count);
  }
  std::vector<std::vector<double>> times(runs.size());
  for (int repeat = 0; repeat < repeats; ++repeat) {
    for (std::size_t i = 0; i < runs.size(); ++i) {
      if (runs[i]) times[i].push_back(seconds_of(runs[i], calls[i]) / calls[i] * 1e9);
    }
  }
  std::vector<double> middle;
  for (std::vector<double>& list : times) {
    if (list.empty()) {
      middle.push_back(NAN);
      continue;
    }
    std::nth_element(list.begin(), list.begin() + repeats / 2, list.end());
    middle.push_back(list[repeats / 2]);
  }
  return middle;
}

double difference(const std::vector<double>& a, const std::vector<double>& b) {
  if (a.size() != b.size()) return INFINITY;
  double largest = 1e-300;
  double apart = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    largest = std::max(largest, std::fabs(b[i]));
    if (!(std::fabs(a[i] - b[i]) <= apart)) apart = std::fabs(a[i] - b[i]);
  }
  return apart / largest;
}

std::string number(double x) {
  return std::isnan(x) ? "-" : x < 100.0 ? fmt::format("{:.1f}", x) : fmt::format("{:.0f}", x);
}
std::string ratio(double x) { return std::isnan(x) ? "-" : fmt::format("{:.2f}", x); }

int run(const std::vector<std::string>& wanted) {
  fmt::print("poinsot beside {}; medians in ns per state, ratio = peer / poinsot\n\n", peer_name());
  constexpr const char* row = "{:<24} {:<17} {:>10} {:>10} {:>7} {:>10} {:>7} {:>9}\n";
  fmt::print(row, "model", "quantity", "one call", "peer", "ratio", "pack of 8", "ratio", "apart");
  bool agree = true;
  for (const StatedModel& stated : stated_models()) {
    const auto is_wanted = [&](const std::string& word) { return stated.name.find(word) != std::string::npos; };
    if (!wanted.empty() && std::none_of(wanted.begin(), wanted.end(), is_wanted)) continue;
    const Model<double> model = built(stated);
    const std::vector<Sample> inputs = samples(model, sample_count);
    const Contestant one = single(model, inputs);
    const Contestant eight = packed(model, inputs);
    const Contestant peer = make_peer(stated, inputs);
    const auto measure = [&](const char* quantity, auto call, auto result) {
      double apart = NAN;
      if (peer.*result) {
        apart = 0.0;
        for (int i = 0; i < sample_count; ++i) {
          const double d = difference((one.*result)(i), (peer.*result)(i));
          if (!(d <= apart)) apart = d;
        }
        agree = agree && apart < 1e-9;
      }
      const std::vector<double> times = medians({one.*call, peer.*call, eight.*call});
      fmt::print(row, stated.name, quantity, number(times[0]), number(times[1]), ratio(times[1] / times[0]),
                 number(times[2] / 8.0), ratio(times[1] / (times[2] / 8.0)),
                 std::isnan(apart) ? "-" : fmt::format("{:.0e}", apart));
      std::fflush(stdout);
    };
    measure("inverse dynamics", &Contestant::inverse_dynamics, &Contestant::inverse_result);
    measure("forward dynamics", &Contestant::forward_dynamics, &Contestant::forward_result);
    measure("mass matrix", &Contestant::mass_matrix, &Contestant::mass_result);
  }
  if (!agree) fmt::print(stderr, "bench_dynamics: the results differ by more than 1e-9 of their largest entry\n");
  return agree ? 0 : 1;
}

}  // namespace
}  // namespace poinsot::bench

int main(int argc, char** argv) { return poinsot::bench::run(std::vector<std::string>(argv + 1, argv + argc)); }
