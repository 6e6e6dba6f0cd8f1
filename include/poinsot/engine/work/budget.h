// How long a caller lets this library work: a deadline, a flag that cancels, a listener to progress.
//
// Results never depend on a clock: searches end by counted work. A caller may still be unwilling to wait. It puts a
// Budget in force for its thread by a BudgetScope; long computations then call check_budget() every few milliseconds,
// which throws BudgetEnded, and those that have found something already catch it and say what ended them. Without a
// scope nothing ends and no clock is read.
#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <functional>
#include <optional>
#include <stop_token>
#include <string_view>

#include "poinsot/engine/work/work.h"

namespace poinsot {

// What ended a computation before it was done.
enum class BudgetEnd { deadline, interrupted };

// "ended by the deadline", "interrupted"
std::string_view words_of(BudgetEnd end);

// Derived from no std::exception: it is no error, and must pass the places that turn an error into "this has no
// formula" or "there is no motion from here".
struct BudgetEnded {
  BudgetEnd end;
};

struct Progress {
  std::string_view doing;      // "following the motion", "searching the unknowns"
  std::optional<double> part;  // from 0 to 1, where it is known how much there is to do
  std::size_t count = 0;       // else what has been done: steps, evaluations
};

// One budget may be in force in several threads. A listener that is then called from all of them must allow for that.
class Budget {
 public:
  using Clock = std::chrono::steady_clock;
  using Flag = const std::atomic<bool>*;

  Budget& end_at(Clock::time_point deadline);
  Budget& end_after(Clock::duration duration);  // from now on, by the clock set before
  Budget& end_when(Flag flag);                  // is set; it must outlive the budget
  Budget& end_when(std::stop_token stop);
  // Called at most ten times a second in one scope.
  Budget& tell(std::function<void(const Progress&)> listener);
  // Another clock than the steady one, for tests.
  Budget& by_clock(std::function<Clock::time_point()> clock);

 private:
  friend class BudgetScope;
  friend class BudgetGrace;

  std::optional<Clock::time_point> deadline_;
  Flag flag_ = nullptr;
  std::stop_token stop_;
  std::function<void(const Progress&)> listener_;
  std::function<Clock::time_point()> clock_ = &Clock::now;
};

// While it lives, the budget holds for this thread, and so do the budgets of the scopes around it. Once it has ended it
// stays so.
class BudgetScope {
 public:
  explicit BudgetScope(Budget budget);
  ~BudgetScope();
  BudgetScope(const BudgetScope&) = delete;
  BudgetScope& operator=(const BudgetScope&) = delete;

 private:
  friend class BudgetRespite;
  friend class BudgetGrace;
  friend std::optional<BudgetEnd> how_budget_ended();
  friend class ProgressTeller;

  std::optional<BudgetEnd> look();
  std::optional<BudgetEnd> look_at_clock();
  bool tell(const Progress& progress);  // whether it has a listener

  static thread_local BudgetScope* innermost;

  const Budget budget_;
  BudgetScope* const outer_;
  std::optional<BudgetEnd> ended_;
  // Calls to go until the clock is looked at again, and how many were let go the last time.
  unsigned calls_to_go_ = 0, calls_let_go_ = 0;
  Work counted_at_look_ = 0;
  Budget::Clock::time_point looked_at_{};
  std::optional<Budget::Clock::time_point> told_at_;
};

// While it lives no budget is in force in this thread: for the little that is to be done with what was found, after the
// end.
class BudgetRespite {
 public:
  BudgetRespite();
  ~BudgetRespite();
  BudgetRespite(const BudgetRespite&) = delete;
  BudgetRespite& operator=(const BudgetRespite&) = delete;

 private:
  friend class BudgetGrace;

  BudgetScope* const set_aside_;
};

// While it lives, this thread has a few hundredths of a second more, whatever has ended: to finish what was found. They
// are told by counted work and by the clock of what has ended, so that work which counts too little makes nobody wait.
class BudgetGrace {
 public:
  BudgetGrace();

 private:
  Budget by_clock_of_what_ended() const;

  BudgetRespite respite_;
  BudgetScope clock_, work_;
};

// Takes some nanoseconds, so that it may be called every microsecond. It should be called every three milliseconds at
// least, by which the end is seen within 50.
std::optional<BudgetEnd> how_budget_ended();
inline bool budget_ended() { return how_budget_ended().has_value(); }
// Throws BudgetEnded where the budget has ended.
void check_budget();

// Tells the listener, if there is one and it has not been told just now, how far something has come that this thread
// does. What is done within it is not told: a search that follows a thousand motions tells of the search.
class ProgressTeller {
 public:
  explicit ProgressTeller(std::string_view doing);  // words that outlive it
  ~ProgressTeller();
  ProgressTeller(const ProgressTeller&) = delete;
  ProgressTeller& operator=(const ProgressTeller&) = delete;

  // A part from 0 to 1, where it is known how much there is to do, and what has been done: steps, evaluations.
  void tell(std::optional<double> part, std::size_t count = 0) const;

 private:
  static thread_local const ProgressTeller* outermost;
  const std::string_view doing_;
};

}  // namespace poinsot
