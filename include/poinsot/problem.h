// A problem file that was read and checked. Callers ask it for answers.
//
//   poinsot::Problem problem = poinsot::Problem::from_text(text, "askew.yaml");
//   poinsot::Document document = problem.solve({{"n", "3000 rpm"}});
//
// The answer document is in poinsot/document.h, its renderings in poinsot/rendering.h.
//
// A Budget (poinsot/engine/work/budget.h) bounds how long a call may take, by a deadline, by a flag or by a stop token
// that another thread or a signal handler sets. It also reports progress.
#pragma once

#include <cstddef>
#include <cstdint>
#include <exception>
#include <map>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "poinsot/cases.h"
#include "poinsot/document.h"
#include "poinsot/engine/model/state.h"
#include "poinsot/engine/work/budget.h"

namespace poinsot {

// An error in a problem file and its place. Line and column count from 1, the column in characters (code points).
// With line 0 there is no place in the file.
struct Diagnostic {
  std::string file;
  int line = 0;
  int column = 0;
  std::string message;  // what is wrong, and what was expected
  std::string hint;     // what the author can do; may be empty
};

// Thrown for a problem file, or a value that was set, that cannot be understood or is impossible. what() has one line
// for each diagnostic: `FILE:LINE:COLUMN: error: message (hint)`.
class StatementError : public std::exception {
 public:
  StatementError(std::vector<Diagnostic> diagnostics, std::string text)
      : diagnostics_(std::move(diagnostics)), text_(std::move(text)) {}
  const char* what() const noexcept override { return text_.c_str(); }
  // At least one diagnostic.
  const std::vector<Diagnostic>& diagnostics() const { return diagnostics_; }

 private:
  std::vector<Diagnostic> diagnostics_;
  std::string text_;
};

// Thrown if a file that a problem file names cannot be had. what() says why, as a sentence goes on behind the name of
// the file: "the file does not exist".
class FileError : public std::runtime_error {
 public:
  explicit FileError(const std::string& message, std::string hint = "")
      : std::runtime_error(message), hint_(std::move(hint)) {}
  const std::string& hint() const { return hint_; }  // what the author can do; may be empty

 private:
  std::string hint_;
};

// The source of the files that a problem file names: its meshes.
class FileProvider {
 public:
  virtual ~FileProvider() = default;
  // The bytes of a file, by the name that the problem file gives it. The name is text that somebody wrote: a provider
  // that looks it up on a disk has to keep it from leading out of the folder that is meant. Throws FileError.
  virtual std::string bytes(const std::string& name) const = 0;
};

// Values from outside the file with their units: {"m", "3 kg"}. A letter or a datum gets this value, and an unknown
// becomes a datum. For a name given twice the later value counts.
using Settings = std::vector<std::pair<std::string, std::string>>;

// A datum of the file and the text of its value.
struct StatedDatum {
  std::string name;
  std::string text;  // "1200 rpm", "m*r^2/2", "[0, 1 m, 0]"
  std::string unit;  // of a single number with unit: "rpm"; otherwise ""
};

struct StatedUnknown {
  std::string name;
  std::string unit;     // the unit in which it is shown
  bool vector = false;  // whether it has three components
};

struct StatedQuestion {
  std::string name;
  std::string text;  // as it is written in the file
};

// One setting of the machine, including what the file states for all of them.
struct StatedSituation {
  std::string name;  // "" if the file states no situations
  std::vector<StatedDatum> data;
  std::vector<Letter> letters;
  std::vector<StatedUnknown> unknowns;
};

// The parts of the equations M dv/dt = F + J^T y, J dv/dt = b.
enum class EquationPart {
  // These are matrices and vectors.
  mass_matrix,        // M
  right_side,         // F: loads, springs, weights, and the terms that depend on velocities
  constraint_matrix,  // J and b
  reduced,            // in independent coordinates u: dv/dt = N du/dt + g, (N^T M N) du/dt = N^T (F - M g)
  // These are functions.
  position_rate,     // dq/dt
  forward_dynamics,  // dv/dt
  inverse_dynamics   // M a - F
};

enum class EquationForm { text, tex, c, cpp, python, sympy };

struct EquationsOptions {
  std::vector<EquationPart> parts{};  // if empty: M and F, and with constraints J and b
  EquationForm form = EquationForm::text;
  std::string function = "equations";  // the name of the function in code
  std::string situation{};             // one of several in the file; "" if there is only one
  Settings sets{};
  std::vector<std::string> letters{};  // data that remain letters
};

// Whether the text can be the name of a function in every language of equations().
bool is_function_name(std::string_view text);

// Thrown if the problem has no such equations of motion; what() says why.
class NoEquations : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

class RecordingError : public std::runtime_error {
 public:
  enum class Fault {
    caller,   // a wrong path, or a journal of another problem
    problem,  // the problem is understood but has no answer
    machine,  // a full disk
  };
  RecordingError(Fault fault, const std::string& message) : std::runtime_error(message), fault_(fault) {}
  Fault fault() const { return fault_; }

 private:
  Fault fault_;
};

// Thrown if what is asked of a motion has no answer, or the answer fails a check; what() says why.
class NoMotion : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// A number or a vector along a motion, in SI units.
struct MotionSeries {
  std::string name;                          // as it was asked for: "theta", "angular_velocity(disk)"
  std::string unit;                          // the coherent SI unit: "rad/s"
  std::vector<std::string> component_names;  // of a vector: the names of the axes; empty for a number
  std::vector<double> si;                    // time by time, and for each the components
};

struct MotionValues {
  std::vector<MotionSeries> series;      // in the order asked for
  std::map<std::string, double> checks;  // relative misfits, as those of a Solution
  std::vector<std::string> notes;        // on events during the motion
};

// The tree of bodies of a problem as the engine's algorithms take it, where its motion begins.
struct MotionStart {
  Model<double> tree;  // what the file moves as stated, such as frames, has prescribed coordinates
  State<double> state;
  std::vector<std::string> coordinates;  // of each velocity coordinate, in words
  std::vector<Vector3<double>> origins;  // of each body's frame, whose axes are the ground's in the figure as drawn
  std::vector<std::string> others;       // what acts beside weights: the names of springs, motors, dampers, loads
};

// The motion of a problem, which is followed as far as it is asked for, once, and kept. Like a Problem it is a value
// that copies share, and several threads may ask one: they wait for each other.
class Motion {
 public:
  // The coordinates that have names. They can be asked for, and so can their rates: theta'.
  std::vector<std::string> coordinates(const Budget& budget = {}) const;
  // Throws NoMotion if constraints hold the bodies beside the joints of a tree: loops, rolling, cords, contacts.
  MotionStart start(const Budget& budget = {}) const;
  // Quantities, each as a file would ask for it, at times in any order, s. Each call also asks them at a few of the
  // times as questions of the file, with what tells whether they are determined and with all checks. axes: those of
  // vectors, "" for those of the file. Throws StatementError if a quantity or a time is wrong, NoMotion if there is no
  // answer, and BudgetEnded, which is no std::exception, if the budget ends first.
  MotionValues values(const std::vector<double>& times, const std::vector<std::string>& quantities,
                      const std::string& axes = "", const Budget& budget = {}) const;

 private:
  friend class Problem;
  struct Parts;
  explicit Motion(std::shared_ptr<Parts> parts);
  std::shared_ptr<Parts> parts_;
};

struct RecordOptions {
  Settings sets{};
  // Whether a data file is replaced that is there without the journal of a recording beside it.
  bool replace = false;
};

struct Recording {
  std::string data, journal;  // paths
  std::uint64_t rows = 0;
  std::size_t columns = 0;
  double end = 0;                  // time of the last row, s
  bool complete = false;           // false if the budget ended first
  std::uint64_t resumed_at = 0;    // the number of rows that the journal had before
  std::uint64_t torn_bytes = 0;    // the size of an incomplete record of an earlier run, which was cut off
  std::vector<std::string> notes;  // events during the motion
};

// A problem is a value: it does not change, and copies share what they hold. Calls leave nothing behind, so that
// several threads may use a problem or copies of it at the same time. A call runs in the thread that makes it. Its
// result remains valid without the problem.
class Problem {
 public:
  // Reads and checks the text of a problem file. `name` is used in messages and in the document. The files that the
  // text names are read here, each once, and never again: no disk is touched, and `files` need not outlive the call.
  // Throws StatementError, also if the provider throws FileError.
  static Problem from_text(std::string_view text, const std::string& name, const FileProvider& files);
  // The same with files from the disk: those in the folder of the file `name` or below it, and no others.
  static Problem from_text(std::string_view text, const std::string& name);
  // Reads and checks a file; "-" is standard input, with files from the present folder. Throws StatementError, also if
  // there is no such file.
  static Problem from_file(const std::string& path);

  Problem(const Problem&);
  Problem(Problem&&) noexcept;
  Problem& operator=(const Problem&);
  Problem& operator=(Problem&&) noexcept;
  ~Problem();

  // What the file states, in the order of the file.
  const std::string& name() const;
  const std::string& title() const;
  const std::vector<StatedSituation>& situations() const;  // at least one
  const std::vector<StatedQuestion>& questions() const;
  const std::vector<StatedQuestion>& claims() const;
  bool expects() const;  // whether it has an `expect` block
  bool records() const;  // whether it has a `record` block

  // The number in SI units that `text` ("3000 rpm") is for a letter, a datum or an unknown. Throws StatementError if
  // there is none of this name, or the text is no such value.
  double value_in_si(const std::string& name, const std::string& text) const;

  // The problem with these data as letters without value, as if the file had them under `letters:`. One that is
  // positive in the file is a positive letter. Throws StatementError for what is no datum, no number or changes in
  // time.
  Problem with_letters(const std::vector<std::string>& names) const;

  // Answers every question and decides every claim. Questions without answer are in the document, with state and
  // reason. If the budget ends first, the document says so in `ended` and holds what was found until then. Throws
  // StatementError if a setting is wrong, the statement contradicts itself, or nothing is asked.
  Document solve(const Settings& sets = {}, const Budget& budget = {}) const;
  // The same with a worked solution in each solution of the document, as far as the budget lasts.
  Document explain(const Settings& sets = {}, const Budget& budget = {}) const;
  // The same with a scene in each solution of the document, and on request a worked solution, as far as the budget
  // lasts.
  Document illustrate(const Settings& sets = {}, const Budget& budget = {}, bool with_explanation = false) const;
  // Compares the answers with the file's own `expect` block and describes each discrepancy in one line. A question
  // that the block leaves out is a discrepancy, and so is a file without the block. Throws as solve() does, and
  // BudgetEnded, which is no std::exception, if the budget ends first.
  std::vector<std::string> check(const Budget& budget = {}) const;

  // Records the motion as the file says under `record:`, to the file `output`, which ends in .csv, .h5 or .hdf5.
  //
  // During the run the recording is an append-only journal beside the data file, OUTPUT.journal. If a run stops at
  // any time, the same call continues from its journal, with the same bits as if it had never stopped. After a
  // failure, or where the budget ends, the data file has the rows before it and is marked as incomplete; to write them
  // takes its time also after the end. Progress counts the rows that are safely on the disk. A journal is written by
  // one call at a time, and a second call is refused. Throws StatementError if the file or a setting is wrong,
  // BudgetEnded, which is no std::exception, if the budget ends before the first row, and RecordingError for everything
  // else.
  Recording record(const std::string& output, const RecordOptions& options = {}, const Budget& budget = {}) const;

  // The motion, to be asked for any quantities at any times. Finds the unknowns, and follows nothing yet. Throws
  // StatementError if a setting is wrong, NoMotion if letters remain, the file has several situations or there is not
  // one solution, and BudgetEnded, which is no std::exception, if the budget ends first.
  Motion motion(const Settings& sets = {}, const Budget& budget = {}) const;

  // The problem for many cases that differ in the values of some letters, data or unknowns. Throws StatementError if a
  // name or a setting is wrong, or a question has neither numbers nor vectors for an answer, and BudgetEnded, which is
  // no std::exception, if the budget ends first.
  Cases cases(const CaseQuestions& questions, const Budget& budget = {}) const;

  // The equations of motion as formulas or code, in SI units. They hold for all positions and velocities of the
  // coordinates; what the file states of an instant is not used. Letters and unknowns remain letters, data become
  // numbers. Throws StatementError if a setting is wrong, NoEquations, std::invalid_argument for an impossible name,
  // and BudgetEnded, which is no std::exception, if the budget ends first.
  std::string equations(const EquationsOptions& options = {}, const Budget& budget = {}) const;

 private:
  struct Parts;
  explicit Problem(std::shared_ptr<const Parts> parts);
  // Without a provider files come from the disk.
  static Problem read(std::string_view text, const std::string& name, const FileProvider* files);
  std::shared_ptr<const Parts> parts_;  // empty in a problem that was moved from
};

// The JSON Schema (draft 2020-12) of the problem file, ending in a newline.
std::string problem_schema();

// The coherent SI unit of what a unit of the problem language measures: "rad/s" of "rpm", "" of "". Throws
// std::invalid_argument, which names the bad piece, if it is no unit.
std::string si_unit_of(std::string_view unit);

// What the problem language means by a word: a key, a function, a unit, and the shortest example of the manual that
// uses it. The text ends in a newline; it is empty for a word that the language does not know.
std::string language_help(std::string_view word);
// The words it knows, each once, sorted.
std::vector<std::string> language_words();

}  // namespace poinsot
