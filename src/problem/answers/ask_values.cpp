#include "problem/answers/ask_values.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

#include "problem/instant/open_words.h"
#include "problem/unknowns/asked_value.h"
#include "problem/unknowns/extremum.h"

namespace poinsot::problem {
namespace {

// An ask may have no value where all open velocities are zero, but one elsewhere. Then it is not determined.
std::optional<Diagnostic> fails_where_open(const Statement& statement, Sample& sample, const Ask& ask,
                                           const AllSettings& settings) {
  const auto has_value = [&](std::size_t direction) {
    try {
      Sample moved(statement, settings, {.seed = 16, .velocities = true, .direction = direction});
      asked_value(moved, ask);
      return true;
    } catch (const StatementError&) {
      return false;
    }
  };
  try {
    const SolvedInstant& instant = sample.instant_of(ask);
    const solve::LinearSolution& velocities = instant.velocities();
    if (velocities.open.empty() || !has_value(OpenChoice::every)) return std::nullopt;
    std::vector<std::string> names;
    std::size_t missing = 0;
    for (const bool alone : {true, false})
      for (std::size_t d = 0; d < velocities.open.size() && (alone || missing == 0); ++d) {
        if (alone && !has_value(d)) continue;
        ++missing;
        for (std::size_t k : velocities.share[d])
          if (const std::string_view name = instant.velocity_equations().name(k);
              std::find(names.begin(), names.end(), name) == names.end())
            names.emplace_back(name);
      }
    return Diagnostic{statement.situations.front().file, ask.mark, open_velocities(names, missing), {}};
  } catch (const StatementError&) {
    return std::nullopt;
  }
}

bool is_finite(const Value<double>& value) {
  if (value.is_number()) return std::isfinite(value.number);
  if (value.is_vector()) return std::isfinite(norm(value.vector));
  return std::all_of(value.items.begin(), value.items.end(), is_finite);
}

Diagnostic without_value(const Statement& statement, const Ask& ask) {
  return {statement.situations.front().file, ask.mark,
          "it has no finite value here: something is divided by zero, or it is the rate of what has none, as a norm "
          "that is zero",
          "ask for it at another instant, or for the vector in place of its norm"};
}

// Adds the work done while it lives.
class WorkCounter {
 public:
  explicit WorkCounter(Work& sum) : sum_(sum), before_(work_done()) {}
  ~WorkCounter() { sum_ += work_done() - before_; }
  WorkCounter(const WorkCounter&) = delete;
  WorkCounter& operator=(const WorkCounter&) = delete;

 private:
  Work& sum_;
  const Work before_;
};

}  // namespace

void add_ask_value(const Statement& statement, Sample& sample, const AllSettings& settings, const OpenChoice& choice,
                   AskValues& values) {
  const Ask& ask = statement.asks[values.values.size()];
  const WorkCounter counter(values.work);
  if (ask.extremum) {
    ExtremumFound found = ExtremumSearch(statement, ask, settings, choice).find();
    values.values.emplace_back(std::nullopt);
    if (found.value)
      values.values.back() = WatchedValue{*found.value, {}};
    else
      values.no_extremum[ask.name] = found.reason;
    if (!found.note.empty()) values.notes.push_back(ask.name + ": " + found.note);
    if (found.sample) values.extremal.push_back(std::move(found.sample));
    return;
  }
  try {
    WatchedValue value = watched_value(statement, sample, ask);
    if (!is_finite(value.answer)) throw UnansweredError(without_value(statement, ask));
    values.values.emplace_back(std::move(value));
  } catch (const UnansweredError& error) {
    values.values.emplace_back(std::nullopt);
    values.unanswered[ask.name] = error.diagnostics().front();
  } catch (const StatementError&) {
    std::optional<Diagnostic> open = fails_where_open(statement, sample, ask, settings);
    if (!open) throw;
    values.values.emplace_back(std::nullopt);
    values.unanswered[ask.name] = *std::move(open);
  }
}

AskValues ask_values(const Statement& statement, Sample& sample, const AllSettings& settings,
                     const OpenChoice& choice) {
  AskValues values;
  while (values.values.size() < statement.asks.size()) add_ask_value(statement, sample, settings, choice, values);
  return values;
}

}  // namespace poinsot::problem
