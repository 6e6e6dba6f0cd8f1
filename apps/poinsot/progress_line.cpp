#include "progress_line.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cmath>

#include "streams.h"

namespace {

constexpr std::chrono::seconds patience{1};

std::string duration(double seconds) {
  const auto whole = static_cast<long long>(std::ceil(seconds));
  if (whole < 120) return fmt::format("{} s", whole);
  if (whole < 7200) return fmt::format("{} min", (whole + 59) / 60);
  return fmt::format("{} h {} min", whole / 3600, whole % 3600 / 60);
}

}  // namespace

std::string time_left(double seconds, double part) {
  constexpr double too_early = 0.2;
  if (!(part > 0) || seconds < too_early) return "";
  return fmt::format("  {} left", duration(seconds * (1 - part) / part));
}

poinsot::Budget ProgressLine::budget() {
  poinsot::Budget budget = poinsot::Budget().end_when(&interrupt_flag());
  if (isatty(STDERR_FILENO) == 1) budget.tell([this](const poinsot::Progress& progress) { show(progress); });
  return budget;
}

void ProgressLine::show(const poinsot::Progress& progress) {
  const double part = progress.part.value_or(0);
  if (!since_ || progress.doing != doing_ || part < last_part_) {
    doing_ = progress.doing;
    since_ = Clock::now();
    first_part_ = part;
  }
  last_part_ = part;
  if (Clock::now() - begun_ < patience) return;
  std::string line = progress.part ? fmt::format("{:3.0f} %  {}{}", std::floor(100 * part), doing_, left_after(part))
                                   : fmt::format("{}, {} so far", doing_, progress.count);
  // A line that is wider than the terminal could not be written over.
  if (const std::size_t columns = terminal_columns(STDERR_FILENO); columns > 1 && line.size() >= columns)
    line.resize(columns - 1);
  const std::size_t length = line.size();
  if (length < length_) line.append(length_ - length, ' ');
  length_ = length;
  write_on_terminal("\r" + line);
}

std::string ProgressLine::left_after(double part) const {
  const double seconds = std::chrono::duration<double>(Clock::now() - *since_).count();
  return time_left(seconds, (part - first_part_) / (1 - first_part_));
}

void ProgressLine::erase() {
  if (length_ > 0) write_on_terminal("\r" + std::string(length_, ' ') + "\r");
  length_ = 0;
}
