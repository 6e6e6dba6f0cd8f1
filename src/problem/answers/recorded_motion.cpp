#include "problem/answers/recorded_motion.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "poinsot/engine/work/work.h"
#include "problem/answers/motion_columns.h"
#include "problem/course/course.h"
#include "problem/language/diagnostic.h"
#include "problem/language/words.h"
#include "problem/machine/data.h"
#include "problem/witness/particle_witness.h"

namespace poinsot::problem {
namespace {

// Relative misfit allowed in the check with particles, as for answers (answer_checks.cpp).
constexpr double recording_tolerance = 1e-8;
// A block is long enough that setting up its equations costs little, and short enough that nobody waits long for its
// end.
constexpr double most_block_rows = 500;
constexpr double block_paces = 500;  // in units of the time in which the motion changes noticeably

const Record& record_of(const Statement& statement) {
  if (!statement.record)
    fail(statement.file, Mark{1, 1}, "the file does not say what to record",
         "write record: {every: 1 ms, for: 10 s, columns: {t: time, theta: theta}}");
  if (statement.situations.size() > 1)
    fail(statement.file, statement.record->mark, "a recording is of a file with one situation",
         "state the situations in files of their own");
  return *statement.record;
}

RecordedState recorded_state(const MotionCheckpoint& there) {
  RecordedState state{there.state.time, there.state.stage, there.stage_start,
                      there.state.q,    there.state.v,     there.state.acting};
  for (const BlowsOfAction& blows : there.struck) {
    state.fastest_blows.push_back(blows.fastest);
    state.told_blows.push_back(blows.told);
  }
  state.flight = there.flight;
  return state;
}

MotionCheckpoint checkpoint_of(const RecordedState& state) {
  MotionCheckpoint there{{state.time, static_cast<std::size_t>(state.stage), state.q, state.v, state.acting},
                         state.stage_start};
  for (std::size_t i = 0; i < state.fastest_blows.size(); ++i)
    there.struck.push_back({state.fastest_blows[i], static_cast<int>(state.told_blows.at(i))});
  there.flight = state.flight;
  return there;
}

MotionColumns columns_of(const Statement& statement) { return {*statement.record, "what is to be recorded"}; }

}  // namespace

struct RecordedMotion::Parts {
  explicit Parts(Statement stated) : statement(std::move(stated)) {}

  Statement statement;
  Settings settings;
  std::unique_ptr<Course> motion;
  std::vector<RecordedColumn> columns;
  RecordedState start;
  double every = 0;
  std::optional<std::uint64_t> rows;
  std::uint64_t block_rows = 1;

  const Situation& situation() const { return statement.situations.front(); }
  double time_of(std::uint64_t row) const { return every * static_cast<double>(row); }
  void read_times();
  void read_row(double time, std::vector<double>& values);
  RecordedChecks check(double time);
};

// Reads every: and for:, and finds the times at which stages end.
void RecordedMotion::Parts::read_times() {
  const Record& record = *statement.record;
  DataScope<double> data(situation(), settings);
  every = data.number(record.every, dimensions::time);
  if (!(every > 0)) fail(statement.file, record.every.mark(), "the rows of a recording need a time between them");
  double last = std::numeric_limits<double>::infinity();
  if (record.lasts) {
    last = data.number(*record.lasts, dimensions::time);
    if (!(last >= 0)) fail(statement.file, record.lasts->mark(), "a recording lasts no negative time");
  }
  bool ends = !situation().stages.empty() && (situation().stages.back().lasts || situation().stages.back().until);
  bool known = ends;
  double end = 0;
  for (const Stage& stage : situation().stages) {
    known = known && stage.lasts;
    if (stage.lasts) end += data.number(*stage.lasts, dimensions::time);
  }
  if (known) last = std::min(last, end);
  if (!ends && !record.lasts)
    fail(statement.file, record.mark, "the motion has no end", "say how long it is recorded: for: 10 s");
  if (std::isinf(last)) return;
  // The last row is not lost by the rounding of a step that goes into the time; a count is a whole number among
  // doubles.
  constexpr double rounding = 1e-12, of_a_row = 1e-9, most_rows = 1e15;
  const double count = std::floor(last / every * (1 + rounding) + of_a_row);
  if (count > most_rows)
    fail(statement.file, record.every.mark(), "the recording would have more rows than can be counted",
         "take a larger step");
  rows = static_cast<std::uint64_t>(count) + 1;
}

RecordedMotion::RecordedMotion(Statement statement, const std::vector<std::pair<std::string, std::string>>& sets)
    : parts_(std::make_unique<Parts>(std::move(statement))) {
  Parts& parts = *parts_;
  const Statement& stated = parts.statement;
  record_of(stated);
  parts.settings = settled(stated, sets, columns_of(stated));
  parts.statement = in_states_at_start(stated, sets, columns_of(stated));
  parts.read_times();

  // Whether a column is determined may show only after the motion has changed noticeably.
  const double reached = answered([&] {
    parts.motion = std::make_unique<Course>(parts.situation(), parts.settings, OpenChoice{});
    parts.start = recorded_state(parts.motion->checkpoint());
    const double span = parts.rows ? parts.time_of(*parts.rows - 1) : std::numeric_limits<double>::infinity();
    return parts.motion->follow(std::min(parts.motion->pace_time(), span));
  });
  const SolvedStatement solved = solve_columns(stated, sets, columns_of(stated), {0, reached / 3, reached});
  for (const SolvedColumn& column : solved.solutions.front().asks.front().columns)
    parts.columns.push_back({column.name, column.unit});

  // A recording may take any time, and its content must not depend on the time that has passed.
  parts.motion->set_work_limit(unlimited_work);
  parts.block_rows = static_cast<std::uint64_t>(
      std::clamp(std::floor(block_paces * parts.motion->pace_time() / parts.every), 1.0, most_block_rows));
}

RecordedMotion::~RecordedMotion() = default;
RecordedMotion::RecordedMotion(RecordedMotion&&) noexcept = default;
RecordedMotion& RecordedMotion::operator=(RecordedMotion&&) noexcept = default;

const std::vector<RecordedColumn>& RecordedMotion::columns() const { return parts_->columns; }
double RecordedMotion::every() const { return parts_->every; }
std::optional<std::uint64_t> RecordedMotion::rows() const { return parts_->rows; }
std::uint64_t RecordedMotion::block_rows() const { return parts_->block_rows; }
RecordedState RecordedMotion::start() const { return parts_->start; }

void RecordedMotion::Parts::read_row(double time, std::vector<double>& values) {
  const Record& record = *statement.record;
  SolvedInstant& instant = motion->instant_at(time);
  for (const NamedExpression& column : record.columns) {
    const Value<double> value = instant.ask(column.value, record.axes, nullptr);
    if (!value.is_number() || !std::isfinite(value.number))
      fail(statement.file, column.mark, "column '" + column.name + "' is no number at " + in_seconds(time));
    values.push_back(value.number);
  }
}

RecordedChecks RecordedMotion::Parts::check(double time) {
  SolvedInstant& instant = motion->instant_at(time);
  instant.solve_forces();
  const SolvedInstant::Residuals checked = instant.check();
  const solve::CheckResult& residual = checked.particles;
  const RecordedChecks checks{residual.momentum, residual.energy, residual.newton_euler,
                              motion->energy_drift().value_or(0)};
  // The second road along a blow with friction goes in small steps.
  constexpr double of_rough_blows = recording_tolerance / blow_tolerance;
  const double apart =
      std::max({checked.constraints.value_or(0), checked.friction.value_or(0), motion->blow_misfit().value_or(0),
                of_rough_blows * motion->rough_blow_misfit().value_or(0)});
  const double largest = std::max({checks.momentum, checks.energy, checks.newton_euler, checks.energy_drift, apart});
  if (!(largest <= recording_tolerance))
    throw UnansweredRecord(statement.file + ": the independent check does not confirm the motion at " +
                           in_seconds(time) + ": off by " + with_digits(largest, 2));
  return checks;
}

RecordedBlock RecordedMotion::block(std::uint64_t first_row, const RecordedState& from) {
  Parts& parts = *parts_;
  Course& motion = *parts.motion;
  return answered([&] {
    motion.continue_from(checkpoint_of(from));
    std::uint64_t end_row = first_row + parts.block_rows;
    const bool last = parts.rows && end_row >= *parts.rows;
    if (last) end_row = *parts.rows;
    const double reached = motion.follow(parts.time_of(last ? end_row - 1 : end_row));
    const bool over = motion.is_over();
    // The last instant belongs to the motion, even if rounding puts it behind the end.
    constexpr double rounding = 1e-12;
    const double allowed = reached * (1 + rounding);
    if (over && !last) ++end_row;

    RecordedBlock block;
    for (std::uint64_t row = first_row; row < end_row; ++row) {
      const double time = parts.time_of(row);
      if (over && time > allowed) break;
      parts.read_row(over ? std::min(time, reached) : time, block.values);
    }
    block.checks = parts.check(reached);
    block.notes = motion.happenings();
    if (over || last) return block;
    block.next = recorded_state(motion.checkpoint());
    return block;
  });
}

}  // namespace poinsot::problem
