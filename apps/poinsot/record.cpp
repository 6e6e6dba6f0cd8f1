// poinsot record.
#include <fmt/format.h>

#include "commands.h"
#include "exit_codes.h"
#include "poinsot/problem.h"
#include "progress_line.h"
#include "streams.h"

namespace {

using poinsot::Recording;
using poinsot::RecordingError;

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
  try {
    const poinsot::Problem problem = poinsot::Problem::from_file(arguments.file);
    const InterruptCatcher catcher(InterruptCatcher::Signals::all);
    const Recording recording =
        problem.record(arguments.output, {.sets = arguments.sets, .replace = arguments.force}, line.budget());
    line.erase();
    static_cast<void>(write_answer(summary(recording)));
    if (recording.complete) return exit_answered;
    write_message(fmt::format("poinsot: interrupted; the same call goes on from {}", recording.journal));
    return exit_interrupted;
  } catch (const poinsot::BudgetEnded&) {
    line.erase();
    write_message("poinsot: interrupted before the first row");
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
