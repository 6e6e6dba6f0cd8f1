// Records the motion of a problem: rows of numbers at equal steps of time, in blocks. A block depends on nothing but
// the numbers of the checkpoint at which it starts. So a recording that is continued from a checkpoint has the same
// bits as one that never stopped.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "problem/answers/motion_columns.h"
#include "problem/entries/statement.h"

namespace poinsot::problem {

struct RecordedColumn {
  std::string name;
  Unit unit;
};

// The state in which a block starts.
struct RecordedState {
  double time = 0;  // s
  std::uint64_t stage = 0;
  double stage_start = 0;    // s
  std::vector<double> q, v;  // coordinates and velocities
  std::vector<bool> acting;  // for each cord and contact whether it acts; if empty, all do
  // Of each of them the largest speed with which it was struck and how many of its blows have been told; both empty if
  // none was struck. From a blow there to the next one as it began, s; none if zero.
  std::vector<double> fastest_blows{}, told_blows{};
  double flight = 0;
  bool operator==(const RecordedState&) const = default;
};

// Relative errors of what a motion must conserve or satisfy.
struct RecordedChecks {
  double momentum = 0, energy = 0, newton_euler = 0;  // in the check with particles; the largest of all blocks
  double energy_drift = 0;                            // a bound: the sum of the largest drifts of the blocks
  bool operator==(const RecordedChecks&) const = default;
};

struct RecordedBlock {
  std::vector<double> values;         // row by row, in SI units
  std::vector<std::string> notes;     // events, such as cords that went slack and contacts that were lost
  RecordedChecks checks;              // of this block
  std::optional<RecordedState> next;  // the start of the next block; nothing after the last one
};

class RecordedMotion {
 public:
  // Reads what to record, finds the unknowns and checks that every column is determined. `sets` are those of
  // solve_statement. Throws StatementError if the file or a setting is wrong, UnansweredRecord if a column has no
  // answer.
  RecordedMotion(Statement statement, const std::vector<std::pair<std::string, std::string>>& sets);
  ~RecordedMotion();
  RecordedMotion(RecordedMotion&&) noexcept;
  RecordedMotion& operator=(RecordedMotion&&) noexcept;

  const std::vector<RecordedColumn>& columns() const;
  double every() const;  // s
  // The number of rows, or the largest number if an event may end the motion earlier; nothing if only an event ends
  // it.
  std::optional<std::uint64_t> rows() const;
  // The number of rows in a block. The last block may have fewer, or one more.
  std::uint64_t block_rows() const;

  // The state at the start of the motion.
  RecordedState start() const;
  // The rows of one block. first_row is the number of rows in the blocks before. Throws StatementError or
  // UnansweredRecord if the motion or a column cannot be followed.
  RecordedBlock block(std::uint64_t first_row, const RecordedState& from);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace poinsot::problem
