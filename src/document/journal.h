// An append-only file of records, each whole or not there.
//
//   file    "poinsot journal\n" record*
//   record  length (4 bytes), payload, CRC-32 of length and payload (4 bytes)
//
// Numbers have their lowest byte first. A kill leaves at most the beginning of a record behind the whole ones, a loss
// of power besides it zeros or what was on the disk before: what fails its checksum, and all behind it, does not count.
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

  // Opens the file, or makes an empty one, and keeps other runs away as long as this object lives. Throws
  // RecordingError: the caller's fault if another run holds it or it cannot be opened.
  explicit Journal(const std::string& path);

  const std::string& path() const { return path_; }
  // The first record if it is whole.
  std::optional<std::string> head() const;
  // Whether the file is what may be left where a journal was about to begin with this record.
  bool is_torn_beginning_of(std::string_view head) const;
  // Empties the file and begins with a record, which is on the disk, name and all, when this returns.
  void begin(std::string_view head);

  // Calls for every whole record behind the first one, in order; what it throws passes through.
  void read(const std::function<void(std::string_view payload)>& visit);
  // Cuts off what is behind the last whole record. How many bytes that were.
  std::uint64_t cut_torn_end();

  // Behind the last record. Throws as cannot_write; the records before it stay whole.
  void append(std::string_view payload);
  // Until everything appended is on the disk.
  void sync();

 private:
  std::optional<std::string> record_at(std::uint64_t offset) const;
  std::uint64_t size() const;

  std::string path_;
  Descriptor file_;
  std::uint64_t end_ = 0;  // behind the last whole record
};

}  // namespace poinsot::document
