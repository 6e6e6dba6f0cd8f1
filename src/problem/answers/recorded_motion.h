// The motion of a problem as it is recorded: rows of numbers at equal steps of time, in blocks. A block starts from the
// numbers of a checkpoint and from nothing else; so a recording that is taken up at a checkpoint goes on with the same
// bits as one that never stopped.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "problem/entries/statement.h"

namespace poinsot::problem {

// Understood, but there is no answer: what() says why.
class UnansweredRecord : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

struct RecordedColumn {
  std::string name;
  Unit unit;
};

// Where a block starts.
struct RecordedState {
  double time = 0;  // s
  std::uint64_t stage = 0;
  double stage_start = 0;    // s
  std::vector<double> q, v;  // coordinates and velocities
  std::vector<bool> acting;  // which cords and contacts act; empty: all
  bool operator==(const RecordedState&) const = default;
};

// How well a motion keeps what it should, relative.
struct RecordedChecks {
  double momentum = 0, energy = 0, newton_euler = 0;  // on the road of particles, the largest of the blocks
  double energy_drift = 0;                            // a bound: the sum of the blocks' largest
  bool operator==(const RecordedChecks&) const = default;
};

struct RecordedBlock {
  std::vector<double> values;         // row by row, in SI
  std::vector<std::string> notes;     // what happened: cords that went slack, contacts that were lost
  RecordedChecks checks;              // of this block
  std::optional<RecordedState> next;  // where the next block starts; none: this one is the last
};

class RecordedMotion {
 public:
  // Reads what to record, finds unknowns, and sees that every column is determined, for `sets` as those of
  // solve_statement. Throws StatementError where the file or a set is wrong, UnansweredRecord if a column has no
  // answer.
  RecordedMotion(Statement statement, const std::vector<std::pair<std::string, std::string>>& sets);
  ~RecordedMotion();
  RecordedMotion(RecordedMotion&&) noexcept;
  RecordedMotion& operator=(RecordedMotion&&) noexcept;

  const std::vector<RecordedColumn>& columns() const;
  double every() const;  // s
  // How many rows there will be: at most, if an event may end the motion before; none if only an event ends it.
  std::optional<std::uint64_t> rows() const;
  // Rows of a block; the last one may have fewer, or one more.
  std::uint64_t block_rows() const;

  // The start of the motion.
  RecordedState start() const;
  // The rows from first_row on, which is the number of rows in the blocks before. Throws StatementError or
  // UnansweredRecord where the motion or a column cannot be followed.
  RecordedBlock block(std::uint64_t first_row, const RecordedState& from);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

// The paths of the meshes that a statement names, each once, in the order of the file.
std::vector<std::string> mesh_paths(const Statement& statement);

}  // namespace poinsot::problem
