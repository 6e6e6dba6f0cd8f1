// What the program's commands do. Each returns the exit code and throws what it cannot deal with.
#pragma once

#include <string>
#include <vector>

#include "poinsot/answer/run.h"

struct SolveArguments {
  std::vector<std::string> files;
  poinsot::answer::RunOptions run;
  bool json = false;
};

// Solves each file and writes its answers; a file that fails does not keep the others from being solved, and the worst
// outcome gives the exit code.
int solve(const SolveArguments& arguments);

// Compares files with their own expected answers: a line for each that fails, and last `N passed, M failed`.
int check(const std::vector<std::string>& paths);

// Writes the schema of the answer document or of the problem file.
int schema(bool of_answer);
