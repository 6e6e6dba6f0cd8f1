// budget_delay FILE...: how late the end of a budget is seen. Each file is solved once without an end; then deadlines
// are drawn at random within that time, and the histogram tells how long after them solve() returned. Time is that of
// this thread's processor, so that other programs do not count.
#include <fmt/format.h>
#include <time.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <exception>
#include <map>
#include <random>

#include "poinsot/problem.h"

namespace {

using Clock = poinsot::Budget::Clock;
using Milliseconds = std::chrono::duration<double, std::milli>;

constexpr int draws = 20;
constexpr double shortest = 50;  // ms; files that take less show little
constexpr std::chrono::seconds longest{20};
constexpr int bin = 5;  // ms

Clock::time_point now() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return Clock::time_point(std::chrono::seconds(time.tv_sec) + std::chrono::nanoseconds(time.tv_nsec));
}

}  // namespace

int main(int count, char** arguments) {
  std::map<int, int> histogram;
  std::mt19937 random(1);
  double latest = 0;
  for (int i = 1; i < count; ++i) {
    try {
      const poinsot::Problem problem = poinsot::Problem::from_file(arguments[i]);
      const Clock::time_point begin = now();
      problem.solve({}, poinsot::Budget().by_clock(now).end_after(longest));
      const Clock::duration full = now() - begin;
      if (Milliseconds(full).count() < shortest) continue;
      double latest_here = 0;
      for (int draw = 0; draw < draws; ++draw) {
        const double part = std::uniform_real_distribution<double>(0, 1)(random);
        const Clock::time_point deadline = now() + std::chrono::duration_cast<Clock::duration>(part * full);
        if (!problem.solve({}, poinsot::Budget().by_clock(now).end_at(deadline)).ended) continue;
        const double late = Milliseconds(now() - deadline).count();
        latest_here = std::max(latest_here, late);
        ++histogram[static_cast<int>(late) / bin];
      }
      latest = std::max(latest, latest_here);
      fmt::print("{:8.0f} ms, {:6.1f} ms late at most  {}\n", Milliseconds(full).count(), latest_here, arguments[i]);
    } catch (const std::exception& error) {
      fmt::print("{}: {}\n", arguments[i], error.what());
    }
    std::fflush(stdout);
  }
  fmt::print("\nlate by    deadlines\n");
  for (const auto& [place, deadlines] : histogram)
    fmt::print("{:3} to {:3} ms  {}\n", bin * place, bin * (place + 1), deadlines);
  fmt::print("at most {:.1f} ms\n", latest);
}
