// Recording a motion: what a problem file says under `record:`, to a CSV or HDF5 file.
//
// While it runs, a recording is an append-only journal beside the data file, OUT.journal: first what is recorded
// (problem, settings, columns), then block after block of rows, each with the state from which the next one starts, all
// framed with length and checksum. A run that stops at any moment leaves a journal that the same call takes up again:
// a torn end is cut off, and the blocks that follow have the bits that they would have had. The data file is made from
// the journal, under another name first; the journal stays.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace poinsot::document {

class RecordingError : public std::runtime_error {
 public:
  enum class Fault {
    caller,   // a wrong path, a journal of another problem
    problem,  // understood, but without answer
    machine,  // a full disk
  };
  RecordingError(Fault fault, const std::string& message) : std::runtime_error(message), fault_(fault) {}
  Fault fault() const { return fault_; }

 private:
  Fault fault_;
};

// What is safe on the disk.
struct RecordingProgress {
  std::uint64_t rows = 0;
  std::optional<std::uint64_t> of;  // at most; none where only an event ends the motion
  std::uint64_t resumed_at = 0;     // rows of earlier runs
  double time = 0;                  // of the last row, s
};

struct RecordOptions {
  std::vector<std::pair<std::string, std::string>> sets;  // as those of run_file
  // Called before the first block. From there on the recording ends well if it is asked to.
  std::function<void()> begun;
  // Whether to end here. Asked before every block.
  std::function<bool()> interrupted;
  // Called at first, and then at most ten times a second.
  std::function<void(const RecordingProgress&)> progress;
};

struct Recording {
  std::string data, journal;  // paths
  std::uint64_t rows = 0;
  std::size_t columns = 0;
  double end = 0;                  // time of the last row, s
  bool complete = false;           // false: interrupted
  std::uint64_t resumed_at = 0;    // rows that were in the journal before
  std::uint64_t torn_bytes = 0;    // of a record that an earlier run had not finished, cut off
  std::vector<std::string> notes;  // what happened during the motion
};

// Records the motion of a problem file to `output`, which ends in .csv, .h5 or .hdf5. A failure after the first row
// leaves the rows before it in the data file, marked as incomplete. Throws problem::StatementError where the file or
// a set is wrong, RecordingError else.
Recording record_file(const std::string& path, const std::string& output, const RecordOptions& options);

}  // namespace poinsot::document
