#include "poinsot/engine/work/budget.h"

#include <algorithm>
#include <utility>

#include "poinsot/engine/work/work_scope.h"

namespace poinsot {
namespace {

// The clock is looked at once a millisecond, as far as the last calls foretell the next: at most 16 calls go by without
// a look, so that calls which suddenly come every three milliseconds are noticed after 48. Where a call counts as much
// as that millisecond (eigenvalues of many bodies take fifty) the next one looks.
constexpr std::chrono::milliseconds between_looks{1};
constexpr Work work_between_looks = 1'000'000;
constexpr unsigned most_calls_let_go = 15;
constexpr std::chrono::milliseconds between_tellings{100};
// Of the 50 ms in which an end is seen, as work and as time; what is left is for what goes on until the next look.
constexpr Work most_graced = 25'000'000;
constexpr std::chrono::milliseconds longest_grace{40};

}  // namespace

std::string_view words_of(BudgetEnd end) {
  return end == BudgetEnd::deadline ? "ended by the deadline" : "interrupted";
}

Budget& Budget::end_at(Clock::time_point deadline) {
  deadline_ = deadline;
  return *this;
}

Budget& Budget::end_after(Clock::duration duration) { return end_at(clock_() + duration); }

Budget& Budget::end_when(Flag flag) {
  flag_ = flag;
  return *this;
}

Budget& Budget::end_when(std::stop_token stop) {
  stop_ = std::move(stop);
  return *this;
}

Budget& Budget::tell(std::function<void(const Progress&)> listener) {
  listener_ = std::move(listener);
  return *this;
}

Budget& Budget::by_clock(std::function<Clock::time_point()> clock) {
  clock_ = std::move(clock);
  return *this;
}

thread_local BudgetScope* BudgetScope::innermost = nullptr;

BudgetScope::BudgetScope(Budget budget) : budget_(std::move(budget)), outer_(innermost) { innermost = this; }

BudgetScope::~BudgetScope() { innermost = outer_; }

std::optional<BudgetEnd> BudgetScope::look() {
  if (ended_) return ended_;
  if ((budget_.flag_ && budget_.flag_->load(std::memory_order_relaxed)) || budget_.stop_.stop_requested())
    return ended_ = BudgetEnd::interrupted;
  if (!budget_.deadline_) return {};
  if (calls_to_go_ > 0 && work_done() - counted_at_look_ < work_between_looks) {
    --calls_to_go_;
    return {};
  }
  return look_at_clock();
}

std::optional<BudgetEnd> BudgetScope::look_at_clock() {
  const Budget::Clock::time_point now = budget_.clock_();
  if (now >= *budget_.deadline_) return ended_ = BudgetEnd::deadline;
  counted_at_look_ = work_done();
  // Where the calls come fast, twice as many of them are let go as the last time.
  const bool fast = now - std::exchange(looked_at_, now) < between_looks;
  calls_let_go_ = fast ? std::min(2 * calls_let_go_ + 1, most_calls_let_go) : 0;
  calls_to_go_ = calls_let_go_;
  return {};
}

bool BudgetScope::tell(const Progress& progress) {
  if (!budget_.listener_) return false;
  const Budget::Clock::time_point now = budget_.clock_();
  if (told_at_ && now - *told_at_ < between_tellings) return true;
  told_at_ = now;
  budget_.listener_(progress);
  return true;
}

BudgetRespite::BudgetRespite() : set_aside_(std::exchange(BudgetScope::innermost, nullptr)) {}

BudgetRespite::~BudgetRespite() { BudgetScope::innermost = set_aside_; }

BudgetGrace::BudgetGrace() : clock_(by_clock_of_what_ended()), work_(budget_of_work(most_graced)) {}

Budget BudgetGrace::by_clock_of_what_ended() const {
  for (const BudgetScope* scope = respite_.set_aside_; scope; scope = scope->outer_)
    if (scope->ended_) return Budget().by_clock(scope->budget_.clock_).end_after(longest_grace);
  return {};
}

// An operation is taken for a nanosecond.
Budget budget_of_work(Work most) {
  return Budget()
      .by_clock([] { return Budget::Clock::time_point{} + std::chrono::nanoseconds(work_done()); })
      .end_after(std::chrono::nanoseconds(most));
}

std::optional<BudgetEnd> how_budget_ended() {
  for (BudgetScope* scope = BudgetScope::innermost; scope; scope = scope->outer_)
    if (const std::optional<BudgetEnd> end = scope->look()) return end;
  return {};
}

void check_budget() {
  if (const std::optional<BudgetEnd> end = how_budget_ended()) throw BudgetEnded{*end};
}

thread_local const ProgressTeller* ProgressTeller::outermost = nullptr;

ProgressTeller::ProgressTeller(std::string_view doing) : doing_(doing) {
  if (!outermost) outermost = this;
}

ProgressTeller::~ProgressTeller() {
  if (outermost == this) outermost = nullptr;
}

void ProgressTeller::tell(std::optional<double> part, std::size_t count) const {
  if (outermost != this) return;
  for (BudgetScope* scope = BudgetScope::innermost; scope; scope = scope->outer_)
    if (scope->tell({doing_, part, count})) return;
}

}  // namespace poinsot
