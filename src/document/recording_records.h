// The records in the journal of a recording, as bytes.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "problem/answers/recorded_motion.h"

namespace poinsot::document {

// The first record, which says what is recorded. Recordings with equal first records are equal.
struct RecordingHead {
  struct Mesh {
    std::string name;
    std::uint64_t size = 0, crc64 = 0;
    bool operator==(const Mesh&) const = default;
  };
  struct Column {
    std::string name, unit;
    double factor = 1;  // one of the unit, in SI
    bool operator==(const Column&) const = default;
  };
  std::string program;  // "poinsot 0.2.0"
  std::string title;
  std::string problem;  // the text of the file
  std::vector<std::pair<std::string, std::string>> sets;
  std::vector<Mesh> meshes;
  double every = 0;                   // s
  std::optional<std::uint64_t> rows;  // as those of a RecordedMotion
  std::uint64_t block_rows = 1;
  std::vector<Column> columns;
};

// A later record: one block. first_row is the number of rows before it.
struct RecordingBlock {
  std::uint64_t first_row = 0;
  problem::RecordedBlock block;
};

std::string to_bytes(const RecordingHead& head);
std::string to_bytes(const RecordingBlock& block);
// These throw std::out_of_range if the bytes are no such record.
RecordingHead head_of(std::string_view bytes);
RecordingBlock block_of(std::string_view bytes);

// CRC-64/XZ.
std::uint64_t crc64(std::string_view bytes);
// The checksum of the problem, its settings and its meshes, as sixteen hexadecimal digits.
std::string problem_hash(const RecordingHead& head);

// Describes how a journal differs from what is to be recorded: "it holds a recording with other settings".
std::string difference(const RecordingHead& journal, const RecordingHead& wanted);

}  // namespace poinsot::document
