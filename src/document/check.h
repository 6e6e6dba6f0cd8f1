// Compares a document with answers that are known from elsewhere.
#pragma once

#include <string>
#include <vector>

#include "poinsot/document.h"

namespace poinsot::document {

// A column of a table, by its name.
struct ExpectedColumn {
  std::string name;
  std::vector<double> si;  // row by row, in SI base units
};

// What the answer to one question should be. Either `si` or `columns` is set.
struct Expectation {
  std::string part;  // the name of the question

  // In SI base units: a number, a list (vector), a list of lists (matrix); or a truth value, a text, or a list of
  // texts, which may stand in any order.
  Datum si;
  std::vector<ExpectedColumn> columns;  // of a table, in any order

  // A number may be off by relative_tolerance times the larger of its own magnitude and the largest magnitude in its
  // list, row or column, plus absolute_tolerance (SI). Where all that is expected is zero, the scale is the
  // largest answer in the same unit.
  double relative_tolerance = 1e-6;
  double absolute_tolerance = 0;

  bool roots = false;  // `si` lists one number for each solution, in any order; otherwise every solution must agree
};

// Whether it is expected that there is no solution: of each part no root.
bool expects_no_solution(const std::vector<Expectation>& expectations);

// Describes each discrepancy in one line; empty if everything agrees. A question without expectation is a
// discrepancy, and so is an expectation without question. Numbers are in SI base units.
std::vector<std::string> shortfalls(const Document& document, const std::vector<Expectation>& expectations);

}  // namespace poinsot::document
