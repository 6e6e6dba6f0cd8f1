// poinsot record.
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>

#include "commands.h"
#include "exit_codes.h"
#include "streams.h"

namespace {

using poinsot::Recording;
using poinsot::RecordingError;
using poinsot::RecordingProgress;
using Clock = std::chrono::steady_clock;

std::string duration(double seconds) {
  const auto whole = static_cast<long long>(std::ceil(seconds));
  if (whole < 120) return fmt::format("{} s", whole);
  if (whole < 7200) return fmt::format("{} min", (whole + 59) / 60);
  return fmt::format("{} h {} min", whole / 3600, whole % 3600 / 60);
}

// One line on a terminal, written over again and again, and gone in the end. In a pipe, nothing.
class ProgressLine {
 public:
  ~ProgressLine() { erase(); }

  void show(const RecordingProgress& progress) {
    if (!shown_on_terminal_) return;
    if (!begun_) begun_ = Clock::now();
    std::string line = fmt::format("{} rows, to {:.6g} s", progress.rows, progress.time);
    if (progress.of && *progress.of > 0) {
      const double part = static_cast<double>(progress.rows) / static_cast<double>(*progress.of);
      line = fmt::format("{:3.0f} %  {}", std::floor(100 * part), line);
      const double seconds = std::chrono::duration<double>(Clock::now() - *begun_).count();
      if (progress.rows > progress.resumed_at && seconds > 0.2)
        line += "  " +
                duration(seconds * static_cast<double>(*progress.of - progress.rows) /
                         static_cast<double>(progress.rows - progress.resumed_at)) +
                " left";
    }
    const std::size_t length = line.size();
    if (length < length_) line.append(length_ - length, ' ');
    length_ = length;
    write_on_terminal("\r" + line);
  }

  void erase() {
    if (length_ > 0) write_on_terminal("\r" + std::string(length_, ' ') + "\r");
    length_ = 0;
  }

 private:
  bool shown_on_terminal_ = isatty(STDERR_FILENO) == 1;
  std::optional<Clock::time_point> begun_;
  std::size_t length_ = 0;
};

std::string summary(const Recording& recording) {
  std::string text = fmt::format("{}: {} rows of {} columns", recording.data, recording.rows, recording.columns);
  if (recording.rows > 0) text += fmt::format(", to {} s", recording.end);
  if (recording.resumed_at > 0) text += fmt::format(", {} of them from before", recording.resumed_at);
  text += recording.complete ? "\n" : " (incomplete)\n";
  for (const std::string& note : recording.notes) text += fmt::format("  {}\n", note);
  return text;
}

}  // namespace

int record(const RecordArguments& arguments) {
  ProgressLine line;
  poinsot::RecordOptions options;
  options.sets = arguments.sets;
  std::optional<InterruptCatcher> catcher;
  options.begun = [&] { catcher.emplace(InterruptCatcher::Signals::all); };
  options.interrupted = interrupted;
  options.progress = [&](const RecordingProgress& progress) { line.show(progress); };
  try {
    const Recording recording = poinsot::Problem::from_file(arguments.file).record(arguments.output, options);
    line.erase();
    static_cast<void>(write_answer(summary(recording)));
    if (recording.complete) return exit_answered;
    write_message(fmt::format("poinsot: interrupted; the same call goes on from {}", recording.journal));
    return exit_interrupted;
  } catch (const RecordingError& error) {
    line.erase();
    write_message(fmt::format("poinsot: {}", error.what()));
    switch (error.fault()) {
      case RecordingError::Fault::caller:
        return exit_wrong_input;
      case RecordingError::Fault::problem:
        return exit_unanswered;
      case RecordingError::Fault::machine:
        break;
    }
    return exit_internal;
  }
}
