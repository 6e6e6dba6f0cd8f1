// What the records of a recording's journal hold, as bytes.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "problem/answers/recorded_motion.h"

namespace poinsot::document {

// The first record: what is recorded. Recordings with the same bytes here have the same bytes everywhere.
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
  std::string program;  // "poinsot 0.1.0"
  std::string title;
  std::string problem;  // the text of the file
  std::vector<std::pair<std::string, std::string>> sets;
  std::vector<Mesh> meshes;
  double every = 0;                   // s
  std::optional<std::uint64_t> rows;  // as those of a RecordedMotion
  std::uint64_t block_rows = 1;
  std::vector<Column> columns;
};

// Every later record: a block, behind the rows of those before it.
struct RecordingBlock {
  std::uint64_t first_row = 0;
  problem::RecordedBlock block;
};

std::string to_bytes(const RecordingHead& head);
std::string to_bytes(const RecordingBlock& block);
// Throws std::out_of_range if the bytes are no such record.
RecordingHead head_of(std::string_view bytes);
RecordingBlock block_of(std::string_view bytes);

// CRC-64/XZ.
std::uint64_t crc64(std::string_view bytes);
// Of the problem, its settings and its meshes: sixteen hexadecimal digits.
std::string problem_hash(const RecordingHead& head);

// In what a journal differs from what is to be recorded, in words: "it holds a recording with other settings".
std::string difference(const RecordingHead& journal, const RecordingHead& wanted);

}  // namespace poinsot::document
