// A problem file, read and checked: what a caller asks for answers.
//
//   poinsot::Problem problem = poinsot::Problem::from_text(text, "askew.yaml");
//   poinsot::Document document = problem.solve({{"n", "3000 rpm"}});
//
// The answer document is poinsot/document.h, what shows it poinsot/rendering.h.
#pragma once

#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "poinsot/document.h"

namespace poinsot {

// What is wrong in a problem file, and where: line and column from 1, the column in characters (code points). Line 0:
// at no place of the file.
struct Diagnostic {
  std::string file;
  int line = 0;
  int column = 0;
  std::string message;  // what is wrong, what was expected
  std::string hint;     // what to do; may be empty
};

// A problem file, or a value that was set, that cannot be understood or cannot be. what() has one line for each
// diagnostic: `FILE:LINE:COLUMN: error: message (hint)`.
class StatementError : public std::exception {
 public:
  StatementError(std::vector<Diagnostic> diagnostics, std::string text)
      : diagnostics_(std::move(diagnostics)), text_(std::move(text)) {}
  const char* what() const noexcept override { return text_.c_str(); }
  // At least one.
  const std::vector<Diagnostic>& diagnostics() const { return diagnostics_; }

 private:
  std::vector<Diagnostic> diagnostics_;
  std::string text_;
};

// Values from outside the file, with their units: {"m", "3 kg"}. A letter or a datum gets this value, an unknown
// becomes a datum; a later one for the same name counts.
using Settings = std::vector<std::pair<std::string, std::string>>;

// A datum of the file with the text of its value.
struct StatedDatum {
  std::string name;
  std::string text;  // "1200 rpm", "m*r^2/2", "[0, 1 m, 0]"
  std::string unit;  // of a single number with one: "rpm"; else ""
};

struct StatedUnknown {
  std::string name;
  std::string unit;     // in which it is shown
  bool vector = false;  // three components
};

struct StatedQuestion {
  std::string name;
  std::string text;  // as the file asks or claims
};

// One setting of the machine, with what the file shares among all of them.
struct StatedSituation {
  std::string name;  // "" where the file states no situations
  std::vector<StatedDatum> data;
  std::vector<Letter> letters;
  std::vector<StatedUnknown> unknowns;
};

// M dv/dt = F + J^T y, J dv/dt = b.
enum class EquationPart {
  // of the matrices
  mass_matrix,        // M
  right_side,         // F: loads, springs, weights, and what the velocities bring
  constraint_matrix,  // J and b
  reduced,            // independent coordinates u: dv/dt = N du/dt + g, (N^T M N) du/dt = N^T (F - M g)
  // others
  position_rate,     // dq/dt
  forward_dynamics,  // dv/dt
  inverse_dynamics   // M a - F
};

enum class EquationForm { text, tex, c, cpp, python, sympy };

struct EquationsOptions {
  std::vector<EquationPart> parts{};  // none: M and F, and where there are constraints J and b
  EquationForm form = EquationForm::text;
  std::string function = "equations";  // the name of the function in code
  std::string situation{};             // of several in the file; "": the only one
  Settings sets{};
  std::vector<std::string> letters{};  // data that are to stay letters
};

// Whether every language of equations() takes the text as the name of a function.
bool is_function_name(std::string_view text);

// There are no such equations of motion for this problem: what() says why.
class NoEquations : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

class RecordingError : public std::runtime_error {
 public:
  enum class Fault {
    caller,   // a wrong path, a journal of another problem
    problem,  // understood, but without answer
    machine,  // a full disk
  };
  RecordingError(Fault fault, const std::string& message) : std::runtime_error(message), fault_(fault) {}
  Fault fault() const { return fault_; }

 private:
  Fault fault_;
};

// What is safe on the disk.
struct RecordingProgress {
  std::uint64_t rows = 0;
  std::optional<std::uint64_t> of;  // at most; none where only an event ends the motion
  std::uint64_t resumed_at = 0;     // rows of earlier runs
  double time = 0;                  // of the last row, s
};

struct RecordOptions {
  Settings sets{};
  // Called before the first block. From there on the recording ends well if it is asked to.
  std::function<void()> begun{};
  // Whether to end here. Asked before every block.
  std::function<bool()> interrupted{};
  // Called at first, and then at most ten times a second.
  std::function<void(const RecordingProgress&)> progress{};
};

struct Recording {
  std::string data, journal;  // paths
  std::uint64_t rows = 0;
  std::size_t columns = 0;
  double end = 0;                  // time of the last row, s
  bool complete = false;           // false: interrupted
  std::uint64_t resumed_at = 0;    // rows that were in the journal before
  std::uint64_t torn_bytes = 0;    // of a record that an earlier run had not finished, cut off
  std::vector<std::string> notes;  // what happened during the motion
};

// A problem as a value: it does not change, and copies share what they hold. Nothing is kept from one call to the next,
// so that several threads may use one problem, or copies of it, at the same time; a call runs in the thread that makes
// it. What a call returns stays good without the problem.
class Problem {
 public:
  // Reads and checks a problem file's text. `name` stands in messages and in the document. Throws StatementError.
  static Problem from_text(std::string_view text, const std::string& name);
  // The file at the path; "-" is standard input. Throws StatementError, also where there is no such file.
  static Problem from_file(const std::string& path);

  Problem(const Problem&);
  Problem(Problem&&) noexcept;
  Problem& operator=(const Problem&);
  Problem& operator=(Problem&&) noexcept;
  ~Problem();

  // What the file states, in its order.
  const std::string& name() const;
  const std::string& title() const;
  const std::vector<StatedSituation>& situations() const;  // at least one
  const std::vector<StatedQuestion>& questions() const;
  const std::vector<StatedQuestion>& claims() const;
  bool expects() const;  // whether it has an `expect` block
  bool records() const;  // whether it has a `record` block

  // Answers every question and decides every claim. Answers that cannot be given stand in the document with their state
  // and reason. Throws StatementError where a set is wrong, the statement contradicts itself, or nothing is asked.
  Document solve(const Settings& sets = {}) const;
  // The same with a worked solution in each solution of the document.
  Document explain(const Settings& sets = {}) const;
  // What falls short of the file's own `expect` block, one line each; none: all agrees. A question that the block
  // leaves out falls short, and so does a file without the block. Throws as solve().
  std::vector<std::string> check() const;

  // Writes the motion that the file says under `record:` to the file `output`, which ends in .csv, .h5 or .hdf5.
  //
  // While it runs, a recording is an append-only journal beside the data file, OUTPUT.journal. A run that stopped at
  // any moment leaves a journal that the same call takes up again, with the same bits as if it had never stopped. A
  // failure after the first row leaves the rows before it in the data file, marked as incomplete. One journal is
  // written by one call at a time: another is refused. Throws StatementError where the file or a set is wrong,
  // RecordingError else.
  Recording record(const std::string& output, const RecordOptions& options) const;

  // The equations of motion as formulas or as code, in SI units. They hold for every position and velocity of the
  // coordinates; what the file says of an instant does not enter. Letters and unknowns stay letters, data are numbers.
  // Throws StatementError where a set is wrong, NoEquations, std::invalid_argument for a name that is none.
  std::string equations(const EquationsOptions& options = {}) const;

 private:
  struct Parts;
  explicit Problem(std::shared_ptr<const Parts> parts);
  std::shared_ptr<const Parts> parts_;  // none in a problem that was moved from
};

// The JSON Schema (draft 2020-12) of the problem file, ending in a newline.
std::string problem_schema();

}  // namespace poinsot
