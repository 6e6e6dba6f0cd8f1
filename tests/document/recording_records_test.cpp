#include "document/recording_records.h"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

namespace poinsot::document {
namespace recording_records_test {

RecordingHead some_head() {
  RecordingHead head;
  head.program = "poinsot 1.2.3";
  head.title = "A top";
  head.problem = std::string("title: A top\n\0\xff", 15);
  head.sets = {{"m", "3 kg"}, {"r", "2 m"}};
  head.meshes = {{"a.stl", 17, 0xfedcba9876543210}};
  head.every = 1e-3;
  head.rows = 1001;
  head.block_rows = 500;
  head.columns = {{"t", "s", 1}, {"a", "deg", 0.017}};
  return head;
}

RecordingBlock some_block() {
  RecordingBlock record;
  record.first_row = 500;
  record.block.values = {1, -0.0, 5e-324, 1e308};
  record.block.notes = {"the cord goes slack", ""};
  record.block.checks = {1e-16, 2e-16, 3e-16, 4e-16};
  record.block.next =
      problem::RecordedState{0.5, 2, 0.25, {1, 2, 3}, {4, 5}, {true, false, true}, {0, 2.5, 0}, {0, 3, 0}, 1e-3};
  return record;
}

// Every shorter text, and a longer one, is no record.
template <class Read>
void refuses_other_lengths(const std::string& bytes, const Read& read) {
  for (std::size_t length = 0; length < bytes.size(); ++length)
    EXPECT_THROW(read(bytes.substr(0, length)), std::out_of_range) << length;
  EXPECT_THROW(read(bytes + '\0'), std::out_of_range);
}

TEST(RecordingRecords, ReadBackAndRefuseWhatIsShorterOrLonger) {
  const std::string head = to_bytes(some_head());
  EXPECT_EQ(to_bytes(head_of(head)), head);
  EXPECT_EQ(head_of(head).meshes, some_head().meshes);
  EXPECT_EQ(head_of(head).columns, some_head().columns);
  EXPECT_EQ(head_of(head).problem, some_head().problem);
  EXPECT_EQ(head_of(head).rows, 1001U);
  refuses_other_lengths(head, head_of);
  RecordingHead endless = some_head();
  endless.rows.reset();
  EXPECT_FALSE(head_of(to_bytes(endless)).rows);

  const RecordingBlock record = some_block();
  const std::string block = to_bytes(record);
  const RecordingBlock read = block_of(block);
  EXPECT_EQ(to_bytes(read), block);
  EXPECT_EQ(read.first_row, 500U);
  EXPECT_EQ(read.block.values, record.block.values);
  EXPECT_EQ(read.block.notes, record.block.notes);
  EXPECT_EQ(read.block.checks, record.block.checks);
  EXPECT_EQ(read.block.next, record.block.next);
  refuses_other_lengths(block, block_of);
  RecordingBlock last = record;
  last.block.next.reset();
  EXPECT_FALSE(block_of(to_bytes(last)).block.next);
  for (const double told : {-1.0, 1e300, std::numeric_limits<double>::quiet_NaN()}) {
    RecordingBlock wrong = record;
    wrong.block.next->told_blows[1] = told;
    EXPECT_THROW(block_of(to_bytes(wrong)), std::out_of_range) << told;
  }
}

TEST(RecordingRecords, ChecksumIsThatOfTheStandard) {
  EXPECT_EQ(crc64("123456789"), 0x995DC9BBDF1939FAULL);  // the check value of CRC-64/XZ
}

TEST(RecordingRecords, HashIsOfTheProblemItsSettingsAndItsMeshesOnly) {
  const std::string hash = problem_hash(some_head());
  EXPECT_EQ(hash.size(), 16U);
  RecordingHead same = some_head();
  same.program = "poinsot 9";
  same.columns.pop_back();
  EXPECT_EQ(problem_hash(same), hash);
  RecordingHead other = some_head();
  other.sets[0].second = "4 kg";
  EXPECT_NE(problem_hash(other), hash);
  other = some_head();
  other.meshes[0].crc64 += 1;
  EXPECT_NE(problem_hash(other), hash);
  other = some_head();
  other.problem += " ";
  EXPECT_NE(problem_hash(other), hash);
}

}  // namespace recording_records_test
}  // namespace poinsot::document
