#include "document/recording_records.h"

#include <fmt/format.h>

#include <boost/crc.hpp>
#include <limits>
#include <stdexcept>

#include "document/bytes.h"

namespace poinsot::document {
namespace {

constexpr std::uint32_t form = 2;  // of the records
constexpr std::uint64_t no_rows = std::numeric_limits<std::uint64_t>::max();

void write_problem(ByteWriter& out, const RecordingHead& head) {
  out.text(head.problem);
  out.u64(head.sets.size());
  for (const auto& [name, value] : head.sets) {
    out.text(name);
    out.text(value);
  }
  out.u64(head.meshes.size());
  for (const RecordingHead::Mesh& mesh : head.meshes) {
    out.text(mesh.name);
    out.u64(mesh.size);
    out.u64(mesh.crc64);
  }
}

void write_numbers(ByteWriter& out, const std::vector<double>& numbers) {
  out.u64(numbers.size());
  for (double number : numbers) out.f64(number);
}

std::vector<double> read_numbers(ByteReader& in) {
  std::vector<double> numbers(in.count(8));
  for (double& number : numbers) number = in.f64();
  return numbers;
}

std::string read_text(ByteReader& in) { return std::string(in.text()); }

void expect_end(const ByteReader& in) {
  if (!in.at_end()) throw std::out_of_range("bytes behind the end of a record");
}

}  // namespace

std::string to_bytes(const RecordingHead& head) {
  ByteWriter out;
  out.u32(form);
  out.text(head.program);
  out.text(head.title);
  write_problem(out, head);
  out.f64(head.every);
  out.u64(head.rows.value_or(no_rows));
  out.u64(head.block_rows);
  out.u64(head.columns.size());
  for (const RecordingHead::Column& column : head.columns) {
    out.text(column.name);
    out.text(column.unit);
    out.f64(column.factor);
  }
  return out.bytes();
}

RecordingHead head_of(std::string_view bytes) {
  ByteReader in(bytes);
  if (in.u32() != form) throw std::out_of_range("another form of journal");
  RecordingHead head;
  head.program = read_text(in);
  head.title = read_text(in);
  head.problem = read_text(in);
  head.sets.resize(in.count(16));
  for (auto& [name, value] : head.sets) {
    name = read_text(in);
    value = read_text(in);
  }
  head.meshes.resize(in.count(24));
  for (RecordingHead::Mesh& mesh : head.meshes) {
    mesh.name = read_text(in);
    mesh.size = in.u64();
    mesh.crc64 = in.u64();
  }
  head.every = in.f64();
  const std::uint64_t rows = in.u64();
  if (rows != no_rows) head.rows = rows;
  head.block_rows = in.u64();
  head.columns.resize(in.count(24));
  for (RecordingHead::Column& column : head.columns) {
    column.name = read_text(in);
    column.unit = read_text(in);
    column.factor = in.f64();
  }
  expect_end(in);
  return head;
}

std::string to_bytes(const RecordingBlock& record) {
  const problem::RecordedBlock& block = record.block;
  ByteWriter out;
  out.u64(record.first_row);
  write_numbers(out, block.values);
  out.u64(block.notes.size());
  for (const std::string& note : block.notes) out.text(note);
  for (double check :
       {block.checks.momentum, block.checks.energy, block.checks.newton_euler, block.checks.energy_drift})
    out.f64(check);
  out.u32(block.next ? 1 : 0);
  if (!block.next) return out.bytes();
  out.f64(block.next->time);
  out.u64(block.next->stage);
  out.f64(block.next->stage_start);
  write_numbers(out, block.next->q);
  write_numbers(out, block.next->v);
  std::string acting;
  for (const bool acts : block.next->acting) acting.push_back(acts ? '\1' : '\0');
  out.text(acting);
  write_numbers(out, block.next->fastest_blows);
  write_numbers(out, block.next->told_blows);
  out.f64(block.next->flight);
  return out.bytes();
}

RecordingBlock block_of(std::string_view bytes) {
  ByteReader in(bytes);
  RecordingBlock record;
  problem::RecordedBlock& block = record.block;
  record.first_row = in.u64();
  block.values = read_numbers(in);
  block.notes.resize(in.count(8));
  for (std::string& note : block.notes) note = read_text(in);
  for (double* check :
       {&block.checks.momentum, &block.checks.energy, &block.checks.newton_euler, &block.checks.energy_drift})
    *check = in.f64();
  if (in.u32() != 0) {
    problem::RecordedState& next = block.next.emplace();
    next.time = in.f64();
    next.stage = in.u64();
    next.stage_start = in.f64();
    next.q = read_numbers(in);
    next.v = read_numbers(in);
    for (const char acts : in.text()) next.acting.push_back(acts != '\0');
    next.fastest_blows = read_numbers(in);
    next.told_blows = read_numbers(in);
    if (next.fastest_blows.size() != next.told_blows.size()) throw std::out_of_range("blows that are not told");
    // Beyond that there are more than any motion is followed through.
    constexpr double most_told = 1e6;
    for (const double told : next.told_blows)
      if (!(told >= 0 && told <= most_told)) throw std::out_of_range("a number of blows that no motion has");
    next.flight = in.f64();
  }
  expect_end(in);
  return record;
}

std::uint64_t crc64(std::string_view bytes) {
  constexpr std::uint64_t all = std::numeric_limits<std::uint64_t>::max();
  boost::crc_optimal<64, 0x42F0E1EBA9EA3693, all, all, true, true> sum;
  sum.process_bytes(bytes.data(), bytes.size());
  return sum.checksum();
}

std::string problem_hash(const RecordingHead& head) {
  ByteWriter out;
  write_problem(out, head);
  return fmt::format("{:016x}", crc64(out.bytes()));
}

std::string difference(const RecordingHead& journal, const RecordingHead& wanted) {
  if (journal.problem != wanted.problem) return "it holds a recording of another problem, or of an older text of it";
  if (journal.sets != wanted.sets) return "it holds a recording with other settings";
  if (journal.meshes != wanted.meshes) return "it holds a recording with another mesh";
  if (journal.program != wanted.program)
    return "it holds a recording by " + journal.program + ", and this is " + wanted.program;
  return "it holds another recording";
}

}  // namespace poinsot::document
