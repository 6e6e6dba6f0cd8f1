// The program's standard streams and the interrupt key.
#pragma once

#include <atomic>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>

// Standard output takes no more.
struct OutputError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// To be called first. A standard stream that is closed gets a place-holder, so that no file opened later takes its
// number; writing to a pipe that nobody reads, or more than a file may hold, becomes an error in place of a signal; the
// interrupt key ends the program with exit code 130, unless the caller has set it to be ignored.
void prepare_streams();

// While it lives, the interrupt key does not end the program but sets interrupt_flag(), the first time; the second time
// it ends the program. Requests to end (SIGTERM, SIGHUP) do the same where they are to be caught as well.
class InterruptCatcher {
 public:
  enum class Signals { interrupt, all };
  explicit InterruptCatcher(Signals signals = Signals::interrupt);
  ~InterruptCatcher();
  InterruptCatcher(const InterruptCatcher&) = delete;
  InterruptCatcher& operator=(const InterruptCatcher&) = delete;

 private:
  Signals signals_;
};
// Once it is set it stays so.
const std::atomic<bool>& interrupt_flag();
inline bool interrupted() { return interrupt_flag(); }

// Writes all of the text to standard output before it returns. False if its reader has gone away, so that nothing more
// is wanted; OutputError if the text cannot be written for another reason.
[[nodiscard]] bool write_answer(std::string_view text);

// Writes the text and a line's end to standard error, control characters made harmless.
void write_message(std::string_view text);

// Writes the text to standard error as it is.
void write_on_terminal(std::string_view text);

// The columns of the terminal behind a descriptor; 0 where there is none.
std::size_t terminal_columns(int descriptor);

// What is printed: among answers, lines that are set in by seven blanks or more are values and formulas, which are
// copied.
enum class Lines { of_words, of_answers };

// The text for standard output, whose long lines of words go on below their beginnings where a terminal is too narrow
// for them. Values and formulas stand as they are.
std::string fitted_to_terminal(const std::string& text, Lines lines = Lines::of_words);

// Whether standard output is a terminal that shows color and the environment does not forbid it (no-color.org).
bool wants_color();
