#include <hdf5.h>

#include <cmath>
#include <numbers>

#include "document/recording_support.h"
#include "poinsot/problem.h"
#include "problem/language/failure.h"

namespace poinsot::document {
namespace recording_test {

// A cord that goes slack and taut, stages that begin and end within blocks, and a motion that an event ends.
const std::string cord =
    "title: A bob on a cord, pushed up\ngiven: {L: 1 m}\npoints: {O: [0, 0, 0], P: [0, -L, 0]}\n"
    "bodies: {bob: {particle: P, mass: 1 kg}}\ncords: {c: {from: ground, at: O, to: bob, end: P}}\ngravity: -y\n"
    "instants: {start: {velocity(bob): [6 m/s, 0, 0]}}\n"
    "record: {every: 1 ms, for: 1.6 s, columns: {t: time, y: center(bob).y, T: tension(c)}}\n";
const std::string staged =
    "title: A flywheel\ngiven: {J: 2 kg*m^2}\npoints: {O: [0, 0, 0]}\n"
    "bodies: {wheel: {mass: 4 kg, center: O, inertia: {axis: z, axial: J, transverse: J}}}\n"
    "joints: {axle: {revolute: z, at: O, to: wheel, angle: a}}\n"
    "loads: {motor: {couple: [0, 0, 3 N*m], body: wheel}, brake: {couple: [0, 0, -1 N*m], body: wheel}}\n"
    "gravity: none\ninstants: {start: rest}\n"
    "stages: {driven: {lasts: 0.7405 s, loads: [motor]}, braked: {until: a' == 0, loads: [brake]}}\n"
    "record: {every: 1 ms, columns: {t: time, a: a, w: a'}}\n";

TEST_F(Recorded, NumbersAreThoseOfATable) {
  const Recording recording = record(pendulum + pendulum_record, "a.csv");
  EXPECT_TRUE(recording.complete);
  EXPECT_EQ(recording.rows, 2101U);
  EXPECT_EQ(recording.columns, 3U);
  EXPECT_EQ(recording.end, 2.1);
  EXPECT_EQ(recording.journal, path("a.csv.journal"));
  const auto numbers = rows(path("a.csv"));
  ASSERT_EQ(numbers.size(), 2101U);
  const Document table =
      Problem::from_file(
          file("table.yaml",
               pendulum + "ask: {x: {table: {t: time, a: theta, w: theta'}, over: {time: 0 s .. 2.1 s by 0.1 s}, "
                          "unit: {a: deg}}}\n"))
          .solve();
  const std::vector<Column>& columns = table.solutions.at(0).answers.at(0).columns;
  ASSERT_EQ(columns.size(), 3U);
  for (std::size_t row = 0; row < columns[0].value.size(); ++row)
    for (std::size_t column = 0; column < 3; ++column)
      EXPECT_NEAR(numbers[100 * row][column], columns[column].value[row], 1e-8);
}

TEST_F(Recorded, CsvHoldsTheMotionToItsEndInTheUnitsAsked) {
  record(pendulum +
             "record: {every: 0.25 s, for: 1.1 s, columns: {t: time, a: theta, 'a-b.1': theta'}, unit: {a: deg, t: "
             "ms}}\n",
         "a.csv");
  const std::string text = bytes(path("a.csv"));
  EXPECT_TRUE(text.starts_with("t [ms],a [deg],a-b.1 [rad/s]\r\n0,40,0\r\n250,")) << text;
  const auto numbers = rows(path("a.csv"));
  ASSERT_EQ(numbers.size(), 5U);
  EXPECT_EQ(numbers[4][0], 1000);
  // A number reads back as it was: half the energy is in its rate at each row.
  for (const auto& row : numbers) {
    const double theta = row[1] * std::numbers::pi / 180, start = 40 * std::numbers::pi / 180;
    EXPECT_NEAR(row[2] * row[2], 2 * 9.80665 / 0.9 * (std::cos(theta) - std::cos(start)), 1e-10);
  }
}

std::vector<double> data_set(hid_t in, const char* name) {
  const hid_t set = H5Dopen2(in, name, H5P_DEFAULT);
  const hid_t space = H5Dget_space(set);
  hsize_t size = 0;
  EXPECT_EQ(H5Sget_simple_extent_dims(space, &size, nullptr), 1);
  std::vector<double> values(size);
  EXPECT_GE(H5Dread(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), 0);
  H5Sclose(space);
  H5Dclose(set);
  return values;
}

std::string text_attribute(hid_t in, const char* object, const char* name) {
  const hid_t attribute = H5Aopen_by_name(in, object, name, H5P_DEFAULT, H5P_DEFAULT);
  EXPECT_GE(attribute, 0) << name;
  if (attribute < 0) return "";
  const hid_t type = H5Aget_type(attribute);
  std::string text(H5Tget_size(type), '\0');
  EXPECT_GE(H5Aread(attribute, type, text.data()), 0);
  H5Tclose(type);
  H5Aclose(attribute);
  return text;
}

TEST_F(Recorded, Hdf5HoldsTheNumbersOfTheCsvAndSaysWhatTheyAre) {
  const RecordOptions options{.sets = {{"L", "0.5 m"}, {"L", "0.8 m"}}};
  record(pendulum + pendulum_record, "a.csv", options);
  record(pendulum + pendulum_record, "a.h5", options);
  const auto numbers = rows(path("a.csv"));
  const hid_t in = H5Fopen(path("a.h5").c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  ASSERT_GE(in, 0);
  const char* const names[] = {"t", "a", "w"};
  const char* const units[] = {"s", "deg", "rad/s"};
  for (std::size_t column = 0; column < 3; ++column) {
    const std::vector<double> values = data_set(in, names[column]);
    ASSERT_EQ(values.size(), numbers.size());
    for (std::size_t row = 0; row < values.size(); ++row) EXPECT_EQ(values[row], numbers[row][column]);
    EXPECT_EQ(text_attribute(in, names[column], "unit"), units[column]);
  }
  EXPECT_EQ(text_attribute(in, ".", "title"), "A pendulum");
  EXPECT_EQ(text_attribute(in, ".", "program"), "poinsot " POINSOT_VERSION);
  EXPECT_EQ(text_attribute(in, ".", "settings"), "L=0.8 m");
  Journal journal(path("a.h5.journal"));
  EXPECT_EQ(text_attribute(in, ".", "problem_crc64"), problem_hash(head_of(journal.head().value())));
  int complete = 0;
  const hid_t attribute = H5Aopen(in, "complete", H5P_DEFAULT);
  EXPECT_GE(H5Aread(attribute, H5T_NATIVE_INT, &complete), 0);
  H5Aclose(attribute);
  EXPECT_EQ(complete, 1);
  H5Fclose(in);
  EXPECT_EQ(bytes(path("a.h5.journal")), bytes(path("a.csv.journal")));
}

TEST_F(Recorded, ResumedAfterAnyBlockIsTheSame) {
  for (const std::string& text : {pendulum + pendulum_record, cord, staged}) {
    for (const char* ending : {".csv", ".h5"}) {
      const std::string whole = std::string("whole") + ending, part = std::string("part") + ending;
      const Recording all = record(text, whole);
      const std::size_t blocks = offsets(all.journal).size() - 2;
      ASSERT_GE(blocks, 4U);
      for (std::size_t stop = 0; stop < blocks; ++stop) {
        const Recording before = interrupted(text, part, static_cast<int>(stop));
        EXPECT_FALSE(before.complete);
        const std::string left = bytes(before.journal);
        EXPECT_TRUE(bytes(all.journal).starts_with(left));
        const Recording after = record(text, part);
        EXPECT_TRUE(after.complete);
        EXPECT_EQ(after.resumed_at, before.rows);
        EXPECT_EQ(after.notes, all.notes);
        EXPECT_EQ(bytes(after.journal), bytes(all.journal)) << stop;
        EXPECT_EQ(bytes(after.data), bytes(all.data)) << stop;
        fs::remove(after.journal);
        fs::remove(after.data);
      }
      fs::remove(all.journal);
      fs::remove(all.data);
    }
  }
}

TEST_F(Recorded, ResumedFromAnEndTornAnywhereIsTheSame) {
  const std::string text = pendulum + "record: {every: 60 s, for: 120 s, columns: {t: time, a: theta}}\n";
  const Recording all = record(text, "whole.csv");
  const std::string journal = bytes(all.journal), data = bytes(all.data);
  const std::vector<std::size_t> starts = offsets(all.journal);
  const auto resume = [&](const std::string& left) {
    file("part.csv.journal", left);
    const Recording after = record(text, "part.csv");
    const auto cut = std::ranges::upper_bound(starts, left.size());
    const std::size_t whole = cut == starts.begin() ? 0 : *std::prev(cut);
    EXPECT_EQ(bytes(after.journal), journal);
    EXPECT_EQ(bytes(after.data), data);
    return std::pair(after, whole);
  };
  for (std::size_t length = 0; length < journal.size(); length += length < starts[1] ? 37 : 5) {
    const auto [after, whole] = resume(journal.substr(0, length));
    if (length < starts[1]) continue;
    EXPECT_EQ(after.torn_bytes, length - whole) << length;
  }
  // After a loss of power zeros or old blocks may stand where bytes should.
  const std::size_t last = starts[starts.size() - 2];
  resume(journal.substr(0, last + 20) + std::string(4000, '\0'));
  resume(journal.substr(0, last + 20) + std::string(4000, '\x5a'));
  resume(journal.substr(0, last) + std::string(7, '\0'));
  resume(journal.substr(0, 100) + std::string(60, '\0'));
  std::string flipped = journal;
  flipped[last + 30] = static_cast<char>(flipped[last + 30] ^ 0x10);
  resume(flipped);
}

TEST_F(Recorded, NothingIsComputedAnewOnceItIsComplete) {
  const Recording first = record(pendulum + pendulum_record, "a.csv");
  const std::string data = bytes(first.data), journal = bytes(first.journal);
  fs::remove(first.data);
  const Recording second = record(pendulum + pendulum_record, "a.csv");
  EXPECT_EQ(second.resumed_at, first.rows);
  EXPECT_TRUE(second.complete);
  EXPECT_EQ(bytes(second.data), data);
  EXPECT_EQ(bytes(second.journal), journal);
}

TEST_F(Recorded, InterruptedTheTableSaysThatItIsIncomplete) {
  const Recording none = interrupted(pendulum + pendulum_record, "a.csv", 0);
  EXPECT_EQ(none.rows, 0U);
  EXPECT_EQ(bytes(none.data), "t [s],a [deg],w [rad/s]\r\n# incomplete: 0 rows of 2101\r\n");
  const Recording one = interrupted(pendulum + pendulum_record, "a.csv", 1);
  EXPECT_EQ(one.rows, 500U);
  EXPECT_EQ(one.end, 0.499);
  EXPECT_EQ(rows(one.data).size(), 500U);
  EXPECT_TRUE(bytes(one.data).ends_with("\r\n# incomplete: 500 rows of 2101\r\n"));
}

TEST_F(Recorded, StagesBeginAndEndWithinBlocks) {
  const Recording recording = record(staged, "a.csv");
  EXPECT_TRUE(recording.complete);
  const double driven = 0.7405, top = 1.5 * driven, end = driven + top / 0.5;
  const auto numbers = rows(recording.data);
  ASSERT_EQ(numbers.size(), static_cast<std::size_t>(std::floor(end / 1e-3)) + 1);
  for (const auto& row : numbers) {
    const double t = row[0], since = t - driven;
    EXPECT_NEAR(row[2], since < 0 ? 1.5 * t : top - 0.5 * since, 1e-10) << t;
    EXPECT_NEAR(row[1], since < 0 ? 0.75 * t * t : top * driven / 2 + top * since - 0.25 * since * since, 1e-10) << t;
  }
}

TEST_F(Recorded, TheMotionMayEndWhereABlockDoes) {
  for (const char* lasts : {"0.499 s", "0.5 s", "0.501 s", "1 s", "0 s"}) {
    const Recording recording = record(
        pendulum + "stages: {all: {lasts: " + lasts + "}}\nrecord: {every: 1 ms, columns: {t: time, a: theta}}\n",
        "a.csv");
    EXPECT_TRUE(recording.complete);
    const auto count = static_cast<std::size_t>(std::lround(std::stod(lasts) * 1000)) + 1;
    const auto numbers = rows(recording.data);
    ASSERT_EQ(numbers.size(), count) << lasts;
    for (std::size_t row = 0; row < count; ++row) EXPECT_EQ(numbers[row][0], 1e-3 * static_cast<double>(row));
    fs::remove(recording.journal);
    fs::remove(recording.data);
  }
}

TEST_F(Recorded, WhatHappenedIsNoted) {
  // With v^2 = 36 at the bottom the cord is slack where v^2 = -g y: above the center, y = (36/g - 2)/3.
  const Recording recording = record(cord, "a.csv");
  ASSERT_GE(recording.notes.size(), 2U);
  EXPECT_TRUE(recording.notes[0].starts_with("the cord 'c' goes slack at ")) << recording.notes[0];
  EXPECT_TRUE(recording.notes[1].starts_with("the cord 'c' goes taut at ")) << recording.notes[1];
  const double slack = std::stod(recording.notes[0].substr(27)), taut = std::stod(recording.notes[1].substr(26));
  const auto numbers = rows(recording.data);
  double height = -2;
  for (const auto& row : numbers) {
    if (row[0] < slack - 1e-5) {
      EXPECT_GT(row[2], 0);
      height = row[1];
    } else if (row[0] > slack + 1e-5 && row[0] < taut - 1e-5) {
      EXPECT_EQ(row[2], 0);
    }
  }
  EXPECT_NEAR(height, (36 / 9.80665 - 2) / 3, 3e-3);
}

TEST_F(Recorded, UnknownsAreFoundFirst) {
  std::string text = staged;
  text.replace(text.find("[0, 0, 3 N*m]"), 13, "[0, 0, C]");
  text += "find: {C: N*m}\n";
  text.replace(text.find("instants: {start: rest}"), 23, "instants: {start: rest, 0.5 s: {a': 1 rad/s}}");
  const Recording recording = record(text, "a.csv");
  const auto numbers = rows(recording.data);
  ASSERT_GT(numbers.size(), 500U);
  EXPECT_NEAR(numbers[250][2], 0.5, 1e-9);  // C = 4 N m
}

TEST_F(Recorded, ProgressGrowsToTheWhole) {
  std::vector<Progress> seen;
  interrupted(pendulum + pendulum_record, "a.csv", 2);
  record(pendulum + pendulum_record, "a.csv", {},
         told_of_every_block([&](const Progress& progress) { seen.push_back(progress); }));
  ASSERT_GE(seen.size(), 3U);
  EXPECT_EQ(seen.front().count, 1000U);
  for (std::size_t i = 0; i < seen.size(); ++i) {
    EXPECT_EQ(seen[i].part, static_cast<double>(seen[i].count) / 2101);
    if (i > 0) {
      EXPECT_GE(seen[i].count, seen[i - 1].count);
    }
  }
  EXPECT_EQ(seen.back().count, 2101U);
}

// The end comes amid a block, at a number of looks at the clock: the rows of whole blocks are there, the same call goes
// on, and to the same bits.
TEST_F(Recorded, ADeadlineKeepsWholeBlocks) {
  const Recording whole = record(pendulum + pendulum_record, "whole.csv");
  std::size_t kept = 0, before_the_first = 0;
  for (const int looks : {1, 100, 1000, 2000, 3000, 5000, 8000}) {
    const std::string name = "a" + std::to_string(looks) + ".csv";
    const auto clock = [now = Budget::Clock::time_point{}]() mutable { return now += std::chrono::milliseconds(1); };
    try {
      const Recording part =
          record(pendulum + pendulum_record, name, {},
                 Budget().by_clock(clock).end_at(Budget::Clock::time_point(std::chrono::milliseconds(looks))));
      EXPECT_TRUE(part.complete || part.rows % 500 == 0) << part.rows;
      kept += !part.complete && part.rows > 0;
    } catch (const BudgetEnded& ended) {
      EXPECT_EQ(ended.end, BudgetEnd::deadline);
      ++before_the_first;
    }
    EXPECT_TRUE(record(pendulum + pendulum_record, name).complete);
    EXPECT_EQ(bytes(path(name)), bytes(whole.data));
  }
  EXPECT_GT(kept, 0U);
  EXPECT_GT(before_the_first, 0U);
}

}  // namespace recording_test
}  // namespace poinsot::document
