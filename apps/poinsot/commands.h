// What the program's commands do. Each returns the exit code and throws what it cannot deal with.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "poinsot/pictures.h"
#include "poinsot/problem.h"

struct SolveArguments {
  std::vector<std::string> files;  // and folders
  poinsot::Settings sets;
  bool json = false;
  bool explain = false;  // with worked solutions
  bool scene = false;    // with what a picture shows, in JSON
  std::string output;    // of a worked solution with figures; none: the standard one, without figures
  bool force = false;    // replace files that are there
};

// Solves each file and writes its answers; a file that fails does not keep the others from being solved, and the worst
// outcome gives the exit code.
int solve(const SolveArguments& arguments);

// Writes the worked solutions of one file to `output`, and their figures beside it.
int write_worked_solutions(const SolveArguments& arguments);

struct CheckArguments {
  std::vector<std::string> paths;
  bool list = false;  // name the files that pass
  bool json = false;
};

// Compares files, and those named *.yaml in folders, with their own expected answers: a line for each that fails, and
// last `N passed, M failed`. Interrupted, it tells of the files until then.
int check(const CheckArguments& arguments);

struct RecordArguments {
  std::string file, output;
  bool force = false;  // replace a file that is there
  poinsot::Settings sets;
};

// Records the motion of a file, with its progress on a terminal. Interrupted, it ends with what there is.
int record(const RecordArguments& arguments);

struct EquationsArguments {
  std::string file, output;  // no output: the standard one
  bool force = false;        // replace a file that is there
  std::string form = "text", function = "equations", situation;
  std::vector<std::string> of, letters;
  poinsot::Settings sets;
};

// Writes the equations of motion of a file's mechanism, as formulas or code.
int equations(const EquationsArguments& arguments);

struct ReportArguments {
  std::vector<std::string> paths;  // one problem file, or folders of them
  std::string output;              // NAME.html, or a folder for a gallery
  bool force = false;              // replace what is there
  poinsot::Settings sets;
};

// Writes the page of a file, or a gallery of pages for folders. Interrupted, a gallery has the pages made until then.
int report(const ReportArguments& arguments);

// Problem files, and for each folder every `*.yaml` below it in the order of their names.
std::vector<std::string> problem_files(const std::vector<std::string>& paths);

struct FigureArguments {
  std::string file, output;  // no output: the standard one
  bool force = false;        // replace a file that is there
  bool list = false;         // name the figures that there are, and draw none
  std::size_t solution = 1;
  poinsot::FigureOptions options;
  poinsot::Settings sets;
};

// Draws a figure of a file's solution as SVG.
int figure(const FigureArguments& arguments);

// Writes the schema of the answer document or of the problem file.
int schema(bool of_answer);
