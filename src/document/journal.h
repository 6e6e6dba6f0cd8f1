// An append-only file of records, each of which is complete or absent.
//
//   file    "poinsot journal\n" record*
//   record  length (4 bytes), payload, CRC-32 of length and payload (4 bytes)
//
// Numbers have their lowest byte first. A kill leaves at most an incomplete record behind the complete ones; a loss
// of power may also leave zeros or old data there. A record with a wrong checksum, and everything behind it, does not
// count.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "document/file_output.h"

namespace poinsot::document {

class Journal {
 public:
  static constexpr std::uint32_t most_bytes = std::uint32_t{1} << 30;  // of a payload

  // Opens the file or creates it, and locks it as long as the object lives. Throws RecordingError with Fault::caller
  // if another run holds it or it cannot be opened.
  explicit Journal(const std::string& path);

  const std::string& path() const { return path_; }
  // The first record, if it is complete.
  std::optional<std::string> head() const;
  // Whether the file could be what is left if this record was being written as the first one.
  bool is_torn_beginning_of(std::string_view head) const;
  // Empties the file and writes a first record. It is on the disk, with the name of the file, when this returns.
  void begin(std::string_view head);

  // Calls `visit` for every complete record after the first, in order. Exceptions of `visit` are passed on.
  void read(const std::function<void(std::string_view payload)>& visit);
  // Cuts off what follows the last complete record, and returns the number of these bytes.
  std::uint64_t cut_torn_end();

  // Adds a record at the end. Throws as cannot_write does; the records before it stay complete.
  void append(std::string_view payload);
  // Waits until all records are on the disk.
  void sync();

 private:
  std::optional<std::string> record_at(std::uint64_t offset) const;
  std::uint64_t size() const;

  std::string path_;
  Descriptor file_;
  std::uint64_t end_ = 0;  // behind the last whole record
};

}  // namespace poinsot::document
