// What a long call does and how long it will take, on a terminal.
#pragma once

#include <chrono>
#include <optional>
#include <string>

#include "poinsot/problem.h"

// "  12 s left", if a part of what is to be done took so many seconds; "" where it is too early to tell.
std::string time_left(double seconds, double part);

// One line on standard error, written over again and again once a second has passed, and gone in the end. In a pipe,
// nothing.
class ProgressLine {
 public:
  ProgressLine() = default;
  ~ProgressLine() { erase(); }
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  // Ends when the interrupt key is pressed, and shows its progress here, as long as this lives.
  poinsot::Budget budget();
  void erase();

 private:
  using Clock = std::chrono::steady_clock;

  void show(const poinsot::Progress& progress);
  std::string left_after(double part) const;

  const Clock::time_point begun_ = Clock::now();
  std::size_t length_ = 0;
  // Of what is done now: what it is, since when, and how far it had come then.
  std::string doing_;
  std::optional<Clock::time_point> since_;
  double first_part_ = 0, last_part_ = 0;
};
