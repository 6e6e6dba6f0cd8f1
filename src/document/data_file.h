// The data files of recordings.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "document/recording_records.h"

namespace poinsot::document {

// What a data file contains besides its numbers.
struct DataHead {
  const RecordingHead& recording;
  std::uint64_t rows = 0;
  bool complete = false;
  problem::RecordedChecks checks;
  std::vector<std::string> notes;
};

// A data file that is being written. Errors throw RecordingError with Fault::machine.
class DataFile {
 public:
  virtual ~DataFile() = default;
  // Adds whole rows of numbers in SI units.
  virtual void add(std::span<const double> values) = 0;
  // Completes the file after all rows.
  virtual void finish() = 0;
};

// The format of RFC 4180: a row of names `name [unit]`, then for each time a row of numbers in these units, with as
// few digits as read back to the same number. An incomplete file ends with a line that says so, and so cannot be
// mistaken for a table.
std::unique_ptr<DataFile> make_csv_file(const std::string& path, const DataHead& head);

// For each column a data set of 64-bit numbers with the attribute `unit`. The file has the attributes title, program,
// problem_crc64, settings, complete (1 or 0), notes, and the checks.
std::unique_ptr<DataFile> make_hdf5_file(const std::string& path, const DataHead& head);

}  // namespace poinsot::document
