// The data file of a recording.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "document/recording_records.h"

namespace poinsot::document {

// What a data file says besides its numbers.
struct DataHead {
  const RecordingHead& recording;
  std::uint64_t rows = 0;
  bool complete = false;
  problem::RecordedChecks checks;
  std::vector<std::string> notes;
};

// One that is being written. What fails throws RecordingError, the machine's fault.
class DataFile {
 public:
  virtual ~DataFile() = default;
  // Rows, one after the other, in SI.
  virtual void add(std::span<const double> values) = 0;
  // After all rows.
  virtual void finish() = 0;
};

// RFC 4180: a row of names, `name [unit]`, then a row of numbers in these units for each time, in as few digits as read
// back to the same number. A file that is not complete has a last line that says so, and so is no table for a program.
std::unique_ptr<DataFile> make_csv_file(const std::string& path, const DataHead& head);

// For each column a data set of 64-bit numbers with the attribute `unit`. Attributes of the file: title, program,
// problem_crc64, settings, complete (1 or 0), notes, and the checks.
std::unique_ptr<DataFile> make_hdf5_file(const std::string& path, const DataHead& head);

}  // namespace poinsot::document
