// A folder with problems to record, and what becomes of them.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <charconv>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <string>
#include <vector>

#include "document/journal.h"
#include "document/recording_records.h"
#include "poinsot/problem.h"

namespace poinsot::document {

namespace fs = std::filesystem;

// A pendulum of 0.9 m let go at 40 deg: five blocks of rows.
inline const std::string pendulum =
    "title: A pendulum\ngiven: {L: 0.9 m, b: 40 deg}\npoints: {O: [0, 0, 0], P: [0, -L, 0]}\n"
    "bodies: {bob: {particle: P, mass: 2 kg}}\njoints: {pin: {revolute: z, at: O, to: bob, angle: theta}}\n"
    "gravity: -y\ninstants: {start: {theta: b, theta': 0}}\n";
inline const std::string pendulum_record =
    "record: {every: 1 ms, for: 2.1 s, columns: {t: time, a: theta, w: theta'}, unit: {a: deg}}\n";

class Recorded : public ::testing::Test {
 protected:
  Recorded()
      : folder_(fs::path(::testing::TempDir()) / ("poinsot_recording_" + std::to_string(::getpid()) +
                                                  ::testing::UnitTest::GetInstance()->current_test_info()->name())) {
    fs::create_directories(folder_);
  }
  ~Recorded() override { fs::remove_all(folder_); }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  std::string file(const std::string& name, const std::string& text) const {
    std::ofstream(path(name), std::ios::binary) << text;
    return path(name);
  }
  static std::string bytes(const std::string& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }

  // The whole recording, in `name`.
  Recording record(const std::string& text, const std::string& name, const RecordOptions& options = {},
                   const Budget& budget = {}) const {
    return Problem::from_file(file("problem.yaml", text)).record(path(name), options, budget);
  }
  // The message of the RecordingError that a recording must throw; "no error" if none comes.
  std::string refusal(const std::string& text, const std::string& name, const RecordOptions& options,
                      RecordingError::Fault fault) const {
    try {
      record(text, name, options);
    } catch (const RecordingError& error) {
      EXPECT_EQ(error.fault(), fault) << error.what();
      return error.what();
    }
    return "no error";
  }
  // The listener hears of the beginning of a recording and of every block: the clock has gone on since it was last
  // told.
  static Budget told_of_every_block(std::function<void(const Progress&)> listener) {
    return Budget()
        .by_clock([now = Budget::Clock::time_point{}]() mutable { return now += std::chrono::seconds(1); })
        .tell([listener = std::move(listener)](const Progress& progress) {
          if (progress.doing == "recording") listener(progress);
        });
  }
  // A recording that is interrupted once so many blocks are there.
  Recording interrupted(const std::string& text, const std::string& name, int blocks) const {
    std::atomic<bool> enough{false};
    return record(text, name, {},
                  Budget(told_of_every_block([&](const Progress&) { enough = blocks-- == 0; })).end_when(&enough));
  }

  // The numbers of a CSV file, row by row, without its first row.
  static std::vector<std::vector<double>> rows(const std::string& path) {
    std::vector<std::vector<double>> rows;
    std::ifstream in(path);
    std::string line;
    std::getline(in, line);
    while (std::getline(in, line)) {
      EXPECT_EQ(line.back(), '\r');
      line.pop_back();
      if (line.starts_with("#")) break;
      rows.emplace_back();
      const char* at = line.data();
      const char* const end = at + line.size();
      while (at < end) {
        double number = 0;
        const auto [next, error] = std::from_chars(at, end, number);
        if (error != std::errc()) {
          ADD_FAILURE() << "no number: " << line;
          return rows;
        }
        rows.back().push_back(number);
        at = next + 1;
      }
    }
    return rows;
  }
  // Where the records of a journal begin, and where the last one ends.
  static std::vector<std::size_t> offsets(const std::string& path) {
    Journal journal(path);
    constexpr std::size_t magic = 16, frame = 8;
    std::vector<std::size_t> at{magic, magic + frame + journal.head().value().size()};
    journal.read([&](std::string_view payload) { at.push_back(at.back() + frame + payload.size()); });
    return at;
  }

  fs::path folder_;
};

}  // namespace poinsot::document
