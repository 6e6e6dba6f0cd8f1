// What poinsot report does with one file, and with many.
#pragma once

#include <string>

#include "commands.h"
#include "poinsot/document.h"
#include "poinsot/problem.h"

// A problem file with its text, as the page shows it.
struct ReadProblem {
  poinsot::Problem problem;
  std::string text;
};

// file: - for standard input. Throws StatementError.
ReadProblem read_problem(const std::string& file);

// Writes index.html and a page for each file into the folder arguments.output.
int gallery(const ReportArguments& arguments);
