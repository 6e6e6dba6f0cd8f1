// What is wrong in a problem file, and where.
#pragma once

#include <exception>
#include <string>
#include <string_view>
#include <vector>

namespace poinsot::problem {

// A place in a file: line and column from 1, columns counted in characters (code points). Line 0: no place.
struct Mark {
  int line = 0;
  int column = 0;

  friend bool operator==(const Mark&, const Mark&) = default;
};

struct Diagnostic {
  std::string file;
  Mark mark;
  std::string message;  // what is wrong, and what was expected
  std::string hint;     // what the author can do; may be empty
};

// `FILE:LINE:COLUMN: error: message (hint)`; without place `FILE: error: ...`.
std::string to_string(const Diagnostic& diagnostic);

// A problem file that cannot be understood. what() holds one line per diagnostic.
class StatementError : public std::exception {
 public:
  explicit StatementError(Diagnostic diagnostic);
  // Takes at least one diagnostic; throws std::invalid_argument if there is none.
  explicit StatementError(std::vector<Diagnostic> diagnostics);
  StatementError(std::string file, Mark mark, std::string message, std::string hint = "");

  const char* what() const noexcept override { return text_.c_str(); }
  const std::vector<Diagnostic>& diagnostics() const { return diagnostics_; }

 private:
  std::vector<Diagnostic> diagnostics_;
  std::string text_;
};

// An expression whose form and dimensions are right but which has no value for the data at hand (division by zero,
// square root of a negative number, a result beyond all bounds).
class DomainError : public StatementError {
 public:
  using StatementError::StatementError;
};

// A question that the motion does not answer (it ends before, say). The other questions are answered all the same.
class UnansweredError : public StatementError {
 public:
  using StatementError::StatementError;
};

// What is taken for a steady motion is none. reason: what changes.
class UnsteadyError : public UnansweredError {
 public:
  UnsteadyError(std::string file, Mark mark, std::string message, std::string hint, std::string reason)
      : UnansweredError(std::move(file), mark, std::move(message), std::move(hint)), reason_(std::move(reason)) {}

  const std::string& reason() const { return reason_; }

 private:
  std::string reason_;
};

// What is asked for does not happen, as far as the motion goes or was followed.
class NotHappeningError : public UnansweredError {
 public:
  NotHappeningError(std::string file, Mark mark, std::string message, std::string hint, double until);

  // How far it was looked for, s; infinite if the motion or what is asked of it ends there.
  double until() const { return until_; }

 private:
  double until_;
};

// What is stated contradicts itself.
class ContradictionError : public StatementError {
 public:
  using StatementError::StatementError;
};

// Throws StatementError with one diagnostic.
[[noreturn]] void fail(const std::string& file, Mark mark, std::string message, std::string hint = "");

// Distance of two words: insertions, deletions, replacements and exchanges of neighbours (Damerau-Levenshtein, optimal
// string alignment). A replacement that only changes the case counts one half.
double edit_distance(std::string_view a, std::string_view b);

// The candidate nearest to the word, the first of several; "" if none is near enough to be a slip of the pen. That is
// one slip in words of two to four letters, two in words of up to seven, three in longer ones; words that differ in
// case only are always near. A word is never suggested for itself.
std::string nearest(std::string_view word, const std::vector<std::string>& candidates);

// The hint "did you mean 'x'?", or "" if no candidate is near.
std::string did_you_mean(std::string_view word, const std::vector<std::string>& candidates);

}  // namespace poinsot::problem
